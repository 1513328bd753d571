/* trim_sample.c - trimming curves as polylines: within a tolerance on the
 * surface, with points where they cross the surface's grid. */
#include <math.h>
#include <string.h>

#include "base/buf.h"
#include "mv/cdt.h"
#include "mv/tess_impl.h"

/* --- the tolerance ------------------------------------------------------- */

/* A step of the curve du, dv moves its image by at most slope0 |du| + slope1
 * |dv|, at most sqrt 2 times the step of the curve that is scaled by the
 * slopes. */
static ix_status sample(ix_ctx *ctx, const ix_mv *scaled, double tol, int steps,
                        size_t *n, double **t)
{
    ix__lines l;

    if (steps > 0)
        IX_TRY(ix__lines_even(ctx, scaled, steps, &l));
    else
        IX_TRY(ix__lines_of_crv(ctx, scaled, tol / sqrt(2), &l));
    *n = l.npts;
    *t = ix__scratch(ctx, l.npts, sizeof **t);
    if (*t)
        memcpy(*t, l.t, l.npts * sizeof **t);
    ix__lines_free(ctx, &l);
    return *t ? IX_OK : IX_ENOMEM;
}

static ix_status scaled_curve(ix_ctx *ctx, const ix__tess_grid *g,
                              const ix_mv *uv, ix_mv **out)
{
    double mat[16] = {0};
    ix_mv *plain, *next;

    for (int d = 0; d < 2; d++)
        mat[5 * d] = fmax(g->slope[d], 1e-300);
    mat[10] = mat[15] = 1;
    IX_TRY(ix__mv_no_power(ctx, uv, &plain));
    if (ix_mv_has_poles(plain)) {
        ix_mv_unref(ctx, plain);
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "a trimming curve has weights of both signs or zero");
    }
    IX_TRY(ix__mv_step(ctx, &plain, &next,
                       ix_mv_coerce(ctx, plain, 2, plain->rational, &next)));
    IX_TRY(ix__mv_step(ctx, &plain, &next,
                       ix_mv_transform(ctx, plain, mat, &next)));
    *out = plain;
    return IX_OK;
}

ix_status ix__trim_samples(ix_ctx *ctx, const ix__tess_grid *g, const ix_mv *uv,
                           double tol, int steps, size_t *n, double **t)
{
    ix_status st;
    ix_mv *scaled;

    if (uv->ndirs != 1 || uv->ncoords < 2)
        return IX_FAIL(ctx, IX_EARG,
                       "a trimming curve has %d parameters and "
                       "%d coordinates, not 1 and 2",
                       uv->ndirs, uv->ncoords);
    if (!isfinite(g->slope[0] + g->slope[1]))
        return IX_FAIL(ctx, IX_EUNABLE,
                       "the derivatives of a trimmed surface are not bounded");
    IX_TRY(scaled_curve(ctx, g, uv, &scaled));
    st = sample(ctx, scaled, tol, steps, n, t);
    ix_mv_unref(ctx, scaled);
    return st;
}

/* --- crossings ----------------------------------------------------------- */

typedef struct {
    double t, uv[2];
    int64_t x[2];
} point;

typedef struct {
    ix_ctx *ctx;
    const ix__tess_grid *g;
    const ix_mv *uv;
    ix_buf out; /* double[] */
} finder;

static ix_status evaluate(finder *f, double t, point *p)
{
    double v[IX_MAX_COORDS];

    p->t = t;
    IX_TRY(ix_mv_point(f->ctx, f->uv, &t, v));
    for (int d = 0; d < 2; d++) {
        p->uv[d] = v[d];
        p->x[d] = ix__tess_place(&f->g->d[d], v[d]);
    }
    return IX_OK;
}

/* The middle one of the lines strictly between a and b in direction d; -1. */
static int line_between(const finder *f, int d, int64_t a, int64_t b)
{
    int64_t lo = a < b ? a : b, hi = a < b ? b : a;
    int64_t first = (lo >> IX__CDT_BITS) + 1;
    int64_t last = (hi + IX__CDT_SIDE - 1) / IX__CDT_SIDE - 1;

    if (first < 0)
        first = 0;
    if (last > f->g->d[d].nsamples - 1)
        last = f->g->d[d].nsamples - 1;
    return first <= last ? (int)(first + (last - first) / 2) : -1;
}

enum { ROOT_STEPS = 60, DEEP = 200 };

/* The curve's parameter on a line between two of its points, by regula falsi
 * (Illinois); *found: it is strictly between. */
static ix_status find_root(finder *f, const point *a, const point *b, int d,
                           int line, point *r, bool *found)
{
    double at = f->g->d[d].t[line], ta = a->t, tb = b->t;
    double fa = a->uv[d] - at, fb = b->uv[d] - at;

    *found = false;
    for (int i = 0; i < ROOT_STEPS; i++) {
        double t = (fa * tb - fb * ta) / (fa - fb), v;

        if (!(t > fmin(ta, tb) && t < fmax(ta, tb)))
            t = ta / 2 + tb / 2;
        if (!(t > a->t && t < b->t))
            return IX_OK;
        IX_TRY(evaluate(f, t, r));
        v = r->uv[d] - at;
        *found = r->x[d] == (int64_t)line * IX__CDT_SIDE;
        if (*found && fabs(v) <= 4 * 0x1p-53 * fabs(at))
            return IX_OK;
        if (v == 0)
            return IX_OK;
        if ((v < 0) == (fb < 0)) {
            tb = t;
            fb = v;
            fa /= 2;
        } else {
            ta = tb;
            fa = fb;
            tb = t;
            fb = v;
        }
    }
    return IX_OK;
}

/* Points after a up to b. Recursion is bounded by depth. */
static ix_status between(finder *f, const point *a, const point *b, int depth)
{
    bool found = false;
    point r;

    for (int d = 0; d < 2 && !found && depth < DEEP; d++) {
        int line = line_between(f, d, a->x[d], b->x[d]);

        if (line >= 0)
            IX_TRY(find_root(f, a, b, d, line, &r, &found));
    }
    if (!found) {
        ix__buf_add(&f->out, (const char *)&b->t, sizeof b->t);
        return IX_OK;
    }
    IX_TRY(between(f, a, &r, depth + 1));
    return between(f, &r, b, depth + 1);
}

static ix_status all_between(finder *f, size_t n, const double *t)
{
    point a, b;

    IX_TRY(evaluate(f, t[0], &a));
    ix__buf_add(&f->out, (const char *)&a.t, sizeof a.t);
    for (size_t i = 1; i < n; i++) {
        IX_TRY(evaluate(f, t[i], &b));
        IX_TRY(between(f, &a, &b, 0));
        a = b;
    }
    return ix__buf_check(&f->out);
}

ix_status ix__trim_crossings(ix_ctx *ctx, const ix__tess_grid *g,
                             const ix_mv *uv, size_t *n, double **t)
{
    finder f = {.ctx = ctx, .g = g, .uv = uv};
    ix_status st;

    if (*n == 0)
        return IX_OK;
    ix__buf_init(&f.out, ctx);
    st = all_between(&f, *n, *t);
    if (st == IX_OK) {
        *n = f.out.len / sizeof **t;
        *t = ix__scratch(ctx, *n, sizeof **t);
        if (*t)
            memcpy(*t, f.out.data, f.out.len);
        else
            st = IX_ENOMEM;
    }
    ix__buf_free(&f.out);
    return st;
}
