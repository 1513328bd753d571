/* ratio_sector.c - the points whose distances from two curves have a constant
 * ratio: not rational, so interpolated to a tolerance.
 *
 * Over each pair of feet both normal planes meet in a line B = P + x u, and
 *
 *   |B - C1|^2 = k^2 |B - C2|^2,   k = alpha / (1 - alpha),
 *
 * is a quadratic equation for x: two sheets. */
#include <math.h>

#include "geom/crvs.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"
#include "iritx/ops_bisect.h"
#include "mv/mv.h"

enum { START = 17, MOST = 257, ORDER = 4 };

typedef struct {
    double x[3], t[3]; /* foot and unit tangent */
} foot;

/* The curves, and what one grid needs of them: feet at its nodes (even places)
 * and half way between (odd places), each taken once. */
typedef struct {
    const ix_mv *c[2];
    double k, dom[2][2];
    int n; /* nodes in each direction */
    foot *feet[2];
} sector;

/* Parameter of place i, of 2 n - 1. */
static double place(const sector *s, int side, int i)
{
    const double *d = s->dom[side];

    return d[0] + i / (2.0 * (s->n - 1)) * (d[1] - d[0]);
}

static ix_status foot_of(ix_ctx *ctx, const ix_mv *c, int side, double at,
                         foot *f)
{
    double d[2 * IX_MAX_COORDS];
    int nc = ix_mv_ncoords(c);

    IX_TRY(ix_mv_curve_derivs(ctx, c, at, 1, d));
    for (int k = 0; k < 3; k++) {
        f->x[k] = k < nc ? d[k] : 0.0;
        f->t[k] = k < nc ? d[nc + k] : 0.0;
    }
    if (!(ix__unit3(f->t, f->t) > 0))
        return IX_FAIL(ctx, IX_EDOMAIN, "curve %d has no tangent at %g",
                       side + 1, at);
    return IX_OK;
}

static ix_status take_feet(ix_ctx *ctx, sector *s, int n)
{
    s->n = n;
    for (int side = 0; side < 2; side++) {
        IX_SCRATCH(ctx, s->feet[side], 2 * (size_t)n - 1);
        for (int i = 0; i < 2 * n - 1; i++)
            IX_TRY(foot_of(ctx, s->c[side], side, place(s, side, i),
                           &s->feet[side][i]));
    }
    return IX_OK;
}

/* The point of both normal planes next to p, and the direction u of their line;
 * false if they are parallel (sine 1e-9). */
static bool line_of(const foot *f, const foot *g, double p[3], double u[3])
{
    double a[3], b[3], h[2] = {ix__dot3(f->t, f->x), ix__dot3(g->t, g->x)};
    double sine;

    ix__cross3(f->t, g->t, u);
    sine = ix__unit3(u, u);
    if (!(sine > 1e-9))
        return false;
    ix__cross3(g->t, u, a);
    ix__cross3(u, f->t, b);
    for (int k = 0; k < 3; k++)
        p[k] = (h[0] * a[k] + h[1] * b[k]) / sine;
    return true;
}

/* Both solutions of a x^2 + 2 b x + c = 0, by sheet; false if not real. */
static bool roots_of(double a, double b, double c, double x[2])
{
    double disc = b * b - a * c, q;

    if (!(disc >= 0.0))
        return false;
    q = b >= 0.0 ? -b - sqrt(disc) : -b + sqrt(disc);
    x[b >= 0.0 ? 0 : 1] = q / a;
    x[b >= 0.0 ? 1 : 0] = q == 0.0 ? 0.0 : c / q;
    return true;
}

/* Points of both sheets over the places i and j. */
static ix_status points_at(ix_ctx *ctx, const sector *s, int i, int j,
                           double out[2][3])
{
    const foot *f = &s->feet[0][i], *g = &s->feet[1][j];
    double p[3], u[3], r[2][3], k2 = s->k * s->k, root[2];
    bool ok = line_of(f, g, p, u);

    ix__sub3(p, f->x, r[0]);
    ix__sub3(p, g->x, r[1]);
    ok = ok && roots_of(1.0 - k2, ix__dot3(u, r[0]) - k2 * ix__dot3(u, r[1]),
                        ix__dot3(r[0], r[0]) - k2 * ix__dot3(r[1], r[1]), root);
    if (!ok)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "no point with this ratio over the parameters (%g, %g)",
                       place(s, 0, i), place(s, 1, j));
    for (int k = 0; k < 2; k++)
        ix__axpy3(p, root[k], u, out[k]);
    return IX_OK;
}

/* The nodes of both sheets, double[2][3][n n]. */
static ix_status sample(ix_ctx *ctx, const sector *s, double **out)
{
    size_t total = (size_t)s->n * (size_t)s->n;

    IX_SCRATCH(ctx, *out, 6 * total);
    for (size_t at = 0; at < total; at++) {
        int i = (int)(at % (size_t)s->n), j = (int)(at / (size_t)s->n);
        double x[2][3];

        IX_TRY(points_at(ctx, s, 2 * i, 2 * j, x));
        for (size_t k = 0; k < 6; k++)
            (*out)[k * total + at] = x[k / 3][k % 3];
    }
    return ix__poll(ctx);
}

/* The interpolants half way between the nodes: y[3][(n - 1)^2] each. */
static ix_status between(ix_ctx *ctx, int steps, ix_mv *const srf[2],
                         double *y[2])
{
    size_t total = (size_t)steps * (size_t)steps;
    double *u;

    IX_SCRATCH(ctx, u, (size_t)steps);
    for (int i = 0; i < steps; i++)
        u[i] = (i + 0.5) / steps;
    for (int k = 0; k < 2; k++) {
        IX_SCRATCH(ctx, y[k], 3 * total);
        IX_TRY(ix_mv_eval_grid(ctx, srf[k], (const int[]){steps, steps},
                               (const double *const[]){u, u}, y[k]));
    }
    return IX_OK;
}

/* Largest distance of the interpolants from the sheets, half way between the
 * nodes. */
static ix_status error_of(ix_ctx *ctx, const sector *s, ix_mv *const srf[2],
                          double *worst)
{
    int steps = s->n - 1;
    size_t total = (size_t)steps * (size_t)steps;
    double *y[2];

    *worst = 0.0;
    IX_TRY(between(ctx, steps, srf, y));
    for (size_t at = 0; at < total; at++) {
        int i = (int)(at % (size_t)steps), j = (int)(at / (size_t)steps);
        double x[2][3];

        IX_TRY(points_at(ctx, s, 2 * i + 1, 2 * j + 1, x));
        for (int k = 0; k < 2; k++) {
            double q[3] = {y[k][at], y[k][total + at], y[k][2 * total + at]};

            *worst = fmax(*worst, ix__dist3(x[k], q));
        }
    }
    return IX_OK;
}

static ix_status interpolate(ix_ctx *ctx, int n, const double *pts,
                             ix_mv *srf[2])
{
    const int count[2] = {n, n}, order[2] = {ORDER, ORDER};
    size_t total = (size_t)n * (size_t)n;

    for (size_t k = 0; k < 2; k++)
        IX_TRY(ix_srf_fit_grid(ctx, count, 3, false, pts + 3 * k * total, order,
                               count, &srf[k]));
    return IX_OK;
}

/* Interpolants on a grid of n x n nodes, and their error. */
static ix_status attempt(ix_ctx *ctx, sector *s, int n, ix_mv *srf[2],
                         double *err)
{
    double *pts;

    IX_TRY(take_feet(ctx, s, n));
    IX_TRY(sample(ctx, s, &pts));
    IX_TRY(interpolate(ctx, n, pts, srf));
    return error_of(ctx, s, srf, err);
}

/* Grids of twice as many steps until the error is within tol. */
static ix_status refine(ix_ctx *ctx, sector *s, double tol, ix_mv *srf[2],
                        double *err)
{
    for (int n = START; n <= MOST; n = 2 * n - 1) {
        ix_mark mk = ix__scratch_mark(ctx);
        ix_status st = attempt(ctx, s, n, srf, err);

        ix__scratch_release(ctx, mk);
        if (st != IX_OK || *err <= tol)
            return st;
        for (int k = 0; k < 2; k++) {
            ix_mv_unref(ctx, srf[k]);
            srf[k] = NULL;
        }
    }
    return IX_FAIL(ctx, IX_EUNABLE,
                   "%d x %d points leave an error of %.3g, above %g", MOST,
                   MOST, *err, tol);
}

/* Over the domains of the curves; takes over srf. */
static ix_status deliver(ix_ctx *ctx, const sector *s, ix_mv *srf[2],
                         ix_crvs *out)
{
    ix_status st = ix__crvs_new(ctx, 2, out);

    for (int i = 0; i < 2; i++) {
        ix_mv *half = NULL;

        if (st == IX_OK)
            st = ix_mv_reparam(ctx, srf[i], 0, s->dom[0][0], s->dom[0][1],
                               &half);
        if (st == IX_OK)
            st = ix_mv_reparam(ctx, half, 1, s->dom[1][0], s->dom[1][1],
                               &out->crv[i]);
        ix_mv_unref(ctx, half);
    }
    if (st != IX_OK)
        ix_crvs_free(ctx, out);
    return st;
}

static ix_status run(ix_ctx *ctx, sector *s, double tol, double *err,
                     ix_crvs *out)
{
    ix_mv *srf[2] = {NULL, NULL};
    ix_status st = refine(ctx, s, tol, srf, err);

    if (st == IX_OK)
        st = deliver(ctx, s, srf, out);
    for (int i = 0; i < 2; i++)
        ix_mv_unref(ctx, srf[i]);
    return st;
}

ix_status ix_ratio_sector(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                          double alpha, double tol, double *err, ix_crvs *out)
{
    sector s = {.c = {c1, c2}, .k = alpha / (1.0 - alpha)};
    double worst;

    *out = (ix_crvs){.n = 0};
    if (!(alpha > 0.0 && alpha < 1.0) || alpha == 0.5)
        return IX_FAIL(ctx, IX_EARG,
                       "a ratio of %g: between 0 and 1, not 0.5 (the bisector) "
                       "is needed",
                       alpha);
    if (!(tol > 0.0))
        return IX_FAIL(ctx, IX_EARG, "a tolerance of %g", tol);
    for (int i = 0; i < 2; i++) {
        if (s.c[i]->ndirs != 1 || s.c[i]->ncoords < 2 || s.c[i]->ncoords > 3)
            return IX_FAIL(ctx, IX_EARG,
                           "operand %d has %d directions and %d coordinates: a "
                           "curve with 2 or 3 is needed",
                           i + 1, s.c[i]->ndirs, s.c[i]->ncoords);
        ix_mv_domain(s.c[i], 0, s.dom[i]);
    }
    IX_RETURN_SCOPED(ctx, run(ctx, &s, tol, err ? err : &worst, out));
}
