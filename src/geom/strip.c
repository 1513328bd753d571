/* strip.c - see the header. Across the strip the nearest place is known in
 * closed form; along it Gauss-Newton steps go downhill. */
#include "geom/strip.h"

#include <math.h>
#include <string.h>

#include "geom/vec3.h"

/* Rulings at 2 order places of each span. */
static ix_status sample(ix_ctx *ctx, ix__strip *s)
{
    const ix_path *p = &s->side[0];
    int each = 2 * (p->degree + 1), k = 0;

    s->n = p->nspans * each + 1;
    IX_SCRATCH(ctx, s->t, s->n);
    IX_SCRATCH(ctx, s->work, s->n);
    IX_SCRATCH_ZERO(ctx, s->end, s->n);
    for (int i = 0; i < p->nspans; i++)
        for (int q = i > 0; q <= each; q++, k++)
            s->t[k] = p->breaks[i] +
                      (p->breaks[i + 1] - p->breaks[i]) * q / each;
    for (k = 0; k < s->n; k++)
        for (int e = 0; e < 2; e++)
            ix__path_point(&s->side[e], s->t[k], s->end[k][e]);
    return IX_OK;
}

ix_status ix__strip_new(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                        ix__strip *out)
{
    IX_TRY(ix__path_new(ctx, a, &out->side[0]));
    IX_TRY(ix__path_new(ctx, b, &out->side[1]));
    IX_TRY(ix__path_no_poles(ctx, &out->side[0]));
    IX_TRY(ix__path_no_poles(ctx, &out->side[1]));
    return sample(ctx, out);
}

/* The nearest place on the ruling at t, and the Gauss-Newton step from there.
 * Free directions are not made unit vectors yet. */
static double on_ruling(const ix__strip *s, const double p[3], double t,
                        const ix__strip_range *in, ix__strip_foot *f)
{
    double d[2][2][3], e[3], g[3], rest[3], slope, x;

    for (int k = 0; k < 2; k++)
        ix__path_derivs3(&s->side[k], ix__path_span(&s->side[k], t), t, 1,
                         d[k]);
    ix__sub3(d[1][0], d[0][0], e);
    ix__sub3(p, d[0][0], rest);
    x = ix__dot3(rest, e) / ix__dot3(e, e);
    f->t = t;
    f->x = x > in->x[0] ? fmin(x, in->x[1])
                        : in->x[0]; /* also without length */
    f->nfree = 0;
    ix__axpy3(rest, -f->x, e, rest);
    f->dist2 = ix__dot3(rest, rest);
    for (int c = 0; c < 3; c++)
        g[c] = (1 - f->x) * d[0][1][c] + f->x * d[1][1][c];
    slope = ix__dot3(rest, g);
    if (f->x > in->x[0] && f->x < in->x[1]) { /* along it moving is free */
        memcpy(f->free[f->nfree++], e, sizeof e);
        ix__axpy3(g, -ix__dot3(g, e) / ix__dot3(e, e), e, g);
    }
    if (in->t[0] < in->t[1])
        memcpy(f->free[f->nfree++], g, sizeof g);
    return slope / ix__dot3(g, g);
}

/* Unit vectors of the free directions that have a length. */
static void finish(ix__strip_foot *f)
{
    int n = 0;

    for (int k = 0; k < f->nfree; k++)
        if (ix__unit3(f->free[k], f->free[n]) > 0)
            n++;
    f->nfree = n;
}

void ix__strip_nearest_from(const ix__strip *s, const double p[3], double t,
                            const ix__strip_range *in, ix__strip_foot *out)
{
    double lo = in->t[0], hi = in->t[1];
    /* steps below this part of the domain change nothing that counts */
    double least = 1e-12 * (hi - lo), step;

    step = on_ruling(s, p, fmin(hi, fmax(lo, t)), in, out);
    for (int i = 0; i < 40 && fabs(step) > least && lo < hi; i++) {
        ix__strip_foot f;
        double next = on_ruling(s, p, fmin(hi, fmax(lo, out->t + step)), in,
                                &f);

        if (f.dist2 < out->dist2) {
            *out = f;
            step = next;
        } else {
            step /= 4;
        }
    }
    finish(out);
}

/* Squared distance from sample ruling i. */
static double from_sample(const ix__strip *s, int i, const double p[3])
{
    double e[3], d[3], x;

    ix__sub3(s->end[i][1], s->end[i][0], e);
    ix__sub3(p, s->end[i][0], d);
    x = ix__dot3(d, e) / ix__dot3(e, e);
    ix__axpy3(d, x > 0 ? -fmin(x, 1) : 0, e, d);
    return ix__dot3(d, d);
}

void ix__strip_nearest(const ix__strip *s, const double p[3],
                       const ix__strip_range *in, ix__strip_foot *out)
{
    double *d = s->work;

    for (int i = 0; i < s->n; i++)
        d[i] = from_sample(s, i, p);
    out->dist2 = HUGE_VAL;
    for (int i = 0; i < s->n; i++) {
        ix__strip_foot f;

        if ((i > 0 && d[i] > d[i - 1]) || (i + 1 < s->n && d[i] > d[i + 1]))
            continue;
        ix__strip_nearest_from(s, p, s->t[i], in, &f);
        if (f.dist2 < out->dist2)
            *out = f;
    }
}
