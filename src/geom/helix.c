/* helix.c - helix, spiral and sine curve: not rational, so cubic splines are
 * fitted to even samples, with uniform parameters and knots. */
#include <math.h>

#include "base/ctx.h"
#include "geom/angle.h"
#include "iritx/geom.h"

/* Point of a curve at angle a; f: its numbers. */
typedef void (*sample_fn)(double a, const double *f, double *pt);

static void helix_at(double a, const double *f, double *pt)
{
    double r = f[2] > 0 ? f[1] : f[1] * a / f[3];

    pt[0] = r * cos(a);
    pt[1] = r * sin(a);
    pt[2] = f[0] * a / (2 * IX__PI);
}

static void spiral_at(double a, const double *f, double *pt)
{
    pt[0] = f[0] * a * cos(a);
    pt[1] = f[0] * a * sin(a);
}

static void sine_at(double a, const double *f, double *pt)
{
    (void)f;
    pt[0] = a;
    pt[1] = sin(a);
}

typedef struct {
    sample_fn at;
    int ncoords;
    const double *f;
    double loops, per_loop;
    int samples;
} winding;

static ix_status fit(ix_ctx *ctx, const winding *w, ix_mv **out)
{
    ix_interpolate_opts o = {.order = 4, .param = IX_PARAM_UNIFORM};
    int n = w->samples;
    double *pts, top = 2 * IX__PI * w->loops;

    o.size = 4 + (int)floor(w->per_loop * w->loops);
    IX_SCRATCH(ctx, pts, (size_t)n * (size_t)w->ncoords);
    for (int i = 0; i < n; i++) {
        double pt[3];

        w->at(top * i / (n - 1), w->f, pt);
        for (int c = 0; c < w->ncoords; c++)
            pts[(size_t)c * (size_t)n + (size_t)i] = pt[c];
    }
    return ix_interpolate(ctx, n, w->ncoords, false, pts, &o, NULL, out);
}

static ix_status wind(ix_ctx *ctx, const winding *w, ix_mv **out)
{
    const int most = 1000000; /* samples */
    double points = 4 + floor(w->per_loop * w->loops);
    ix_mark mk;
    ix_status st;

    *out = NULL;
    if (!(w->loops > 0 && isfinite(w->loops)))
        return IX_FAIL(ctx, IX_EARG, "%g loops; a positive number is wanted",
                       w->loops);
    if (!(points >= 4 && points <= w->samples && w->samples <= most))
        return IX_FAIL(ctx, IX_EARG,
                       "%g control points from %d samples: want 4 .. samples "
                       "control points, at most %d samples",
                       points, w->samples, most);
    mk = ix__scratch_mark(ctx);
    st = fit(ctx, w, out);
    ix__scratch_release(ctx, mk);
    return st;
}

ix_status ix_helix(ix_ctx *ctx, double loops, double pitch, double radius,
                   int samples, double per_loop, ix_mv **out)
{
    const double f[4] = {pitch, fabs(radius), radius, 2 * IX__PI * loops};
    const winding w = {helix_at, 3, f, loops, per_loop, samples};

    return wind(ctx, &w, out);
}

ix_status ix_spiral(ix_ctx *ctx, double loops, double pitch, int samples,
                    double per_loop, ix_mv **out)
{
    const double f[1] = {pitch / (2 * IX__PI * (1 + loops))};
    const winding w = {spiral_at, 2, f, loops, per_loop, samples};

    return wind(ctx, &w, out);
}

ix_status ix_sine(ix_ctx *ctx, double loops, int samples, double per_loop,
                  ix_mv **out)
{
    const winding w = {sine_at, 2, NULL, loops, per_loop, samples};

    return wind(ctx, &w, out);
}
