/* crv_feature.c - special points of a curve: inflections, extrema of the
 * curvature, zeros of the torsion.
 *
 * They are zeros of the minimal fields with the error that each span's
 * coefficients are known to have: straight pieces and circles, whose fields
 * vanish up to rounding, come out as intervals. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "iritx/ops_crv.h"
#include "ops/curve.h"
#include "solve/roots.h"

/* A field, what is known of its error, and its zeros (in scratch). */
typedef struct {
    ix_form f;
    ix_extent *e;
    ix_root *root;
    int n;
} zeros;

static ix_status find_zeros(ix_ctx *ctx, zeros *z)
{
    const ix_spans *sp = &z->f.dirs[0];
    const double *b;
    double *band;

    IX_TRY(ix__form_bernstein(ctx, &z->f, &b));
    IX_SCRATCH(ctx, band, sp->nspans);
    for (int j = 0; j < sp->nspans; j++)
        band[j] = z->e[j].error;
    return ix__spans_roots(ctx, sp, b, band, &z->root, &z->n);
}

static ix_status copy_roots(ix_ctx *ctx, const zeros *z, ix_root **roots,
                            int *n)
{
    if (z->n == 0)
        return IX_OK;
    *roots = ix__alloc(ctx, (size_t)z->n * sizeof **roots);
    if (!*roots)
        return IX_ENOMEM;
    memcpy(*roots, z->root, (size_t)z->n * sizeof **roots);
    *n = z->n;
    return IX_OK;
}

static ix_status inflections(ix_ctx *ctx, const ix_mv *crv, ix_root **roots,
                             int *n)
{
    ix_curve c;
    zeros z;

    IX_TRY(ix__curve_load(ctx, crv, IX__CURVE_FLAT, true, &c));
    z.f = c.v;
    z.e = c.ev;
    IX_TRY(find_zeros(ctx, &z));
    return copy_roots(ctx, &z, roots, n);
}

static ix_status torsion_zeros(ix_ctx *ctx, const ix_mv *crv, ix_root **roots,
                               int *n)
{
    ix_curve c;
    zeros z;

    IX_TRY(ix__curve_load(ctx, crv, IX__CURVE, true, &c));
    if (c.dim == 2)
        return IX_OK;
    IX_TRY(ix__curve_torsion(ctx, &c, &z.f, &z.e));
    IX_TRY(find_zeros(ctx, &z));
    return copy_roots(ctx, &z, roots, n);
}

typedef ix_status (*finder)(ix_ctx *ctx, const ix_mv *crv, ix_root **roots,
                            int *n);

static ix_status run_finder(ix_ctx *ctx, finder find, const ix_mv *crv,
                            ix_root **roots, int *n)
{
    *roots = NULL;
    *n = 0;
    IX_RETURN_SCOPED(ctx, find(ctx, crv, roots, n));
}

ix_status ix_crv_inflections(ix_ctx *ctx, const ix_mv *crv, ix_root **roots,
                             int *n)
{
    return run_finder(ctx, inflections, crv, roots, n);
}

ix_status ix_crv_torsion_zeros(ix_ctx *ctx, const ix_mv *crv, ix_root **roots,
                               int *n)
{
    return run_finder(ctx, torsion_zeros, crv, roots, n);
}

/* --- extrema of the curvature ------------------------------------------- */

/* The curve, its curvature (signed in the plane, squared in space) and the
 * slope of that. */
typedef struct {
    ix_curve c;
    zeros bend, slope;
} curvature;

/* Error of the slope: each of its terms is a product of the curvature, Q, w
 * with one derivative in it. */
static ix_status slope_extents(ix_ctx *ctx, curvature *k)
{
    const ix_curve *c = &k->c;
    const ix_spans *sp = &c->p.dirs[0];
    int da = k->bend.f.dirs[0].degree, dq = c->q.dirs[0].degree;
    int deg = k->slope.f.dirs[0].degree;
    ix_form t;
    ix_extent *e[3], *now;

    IX_TRY(ix__extents(ctx, &k->slope.f, NULL, &now));
    IX_TRY(ix__form_derive(ctx, &k->bend.f, 0, &t));
    IX_TRY(ix__extents(ctx, &t, NULL, &e[0]));
    IX_TRY(ix__form_derive(ctx, &c->q, 0, &t));
    IX_TRY(ix__extents(ctx, &t, NULL, &e[1]));
    IX_TRY(ix__form_derive(ctx, &c->w, 0, &t));
    IX_TRY(ix__extents(ctx, &t, NULL, &e[2]));
    for (int j = 0; j < sp->nspans; j++) {
        double h = sp->breaks[j + 1] - sp->breaks[j];
        ix_extent a = k->bend.e[j], q = c->eq[j], w = c->ew[j], sum;

        e[0][j].error = 2.0 * da * a.error / h;
        e[1][j].error = 2.0 * dq * q.error / h;
        e[2][j].error = 2.0 * c->degree * w.error / h;
        sum = ix__extent_mul(ix__extent_mul(e[0][j], q, deg), w, deg);
        sum = ix__extent_add(
            sum, ix__extent_mul(ix__extent_mul(a, e[1][j], deg), w, deg));
        sum = ix__extent_add(
            sum, ix__extent_mul(ix__extent_mul(a, q, deg), e[2][j], deg));
        now[j].error = 6.0 * sum.error;
    }
    k->slope.e = now;
    return IX_OK;
}

static ix_status load_curvature(ix_ctx *ctx, const ix_mv *crv, curvature *k)
{
    int nspans;

    IX_TRY(ix__curve_load(ctx, crv, IX__CURVE, true, &k->c));
    nspans = k->c.p.dirs[0].nspans;
    k->bend.f = k->c.v;
    k->bend.e = k->c.ev;
    if (k->c.dim == 3) {
        int d = 2 * k->c.v.dirs[0].degree;

        IX_TRY(ix__form_dot(ctx, &k->c.v, &k->c.v, &k->bend.f));
        IX_TRY(ix__extents(ctx, &k->bend.f, NULL, &k->bend.e));
        for (int j = 0; j < nspans; j++)
            k->bend.e[j].error =
                3.0 * ix__extent_mul(k->c.ev[j], k->c.ev[j], d).error;
    }
    IX_TRY(ix__curve_slope(ctx, &k->c, &k->bend.f, k->c.dim == 2 ? 1 : 2,
                           &k->slope.f));
    IX_TRY(slope_extents(ctx, k));
    IX_TRY(find_zeros(ctx, &k->bend));
    return find_zeros(ctx, &k->slope);
}

static int sign(double x)
{
    return (x > 0) - (x < 0);
}

/* Sign of the slope of the absolute curvature for the sign s of the slope:
 * kappa = V w^3 / Q^(3/2). In space the squared curvature is never negative. */
static int outward(const curvature *k, double t, int s)
{
    double v, w;

    if (k->c.dim == 3)
        return s;
    ix__form_eval(&k->bend.f, &t, &v);
    ix__form_eval(&k->c.w, &t, &w);
    return s * sign(v) * sign(w);
}

static ix_crv_mark mark_of(const curvature *k, const ix_root *r)
{
    int a = outward(k, nextafter(r->lo, -HUGE_VAL), r->before);
    int b = outward(k, r->hi, r->after);

    if (r->before == 0)
        a = -b;
    if (r->after == 0)
        b = -a;
    return a > 0 && b < 0   ? IX_CRV_MAX
           : a < 0 && b > 0 ? IX_CRV_MIN
                            : IX_CRV_STATIONARY;
}

/* True if the curvature has a zero at r, too: then that one is listed. */
static bool at_flat(const curvature *k, const ix_root *r)
{
    for (int i = 0; i < k->bend.n; i++)
        if (k->bend.root[i].lo <= r->hi && k->bend.root[i].hi >= r->lo)
            return true;
    if (k->c.dim == 3) { /* the square of a small number is small */
        int j = ix__spans_find(&k->bend.f.dirs[0], r->t);
        double v;

        ix__form_eval(&k->bend.f, &r->t, &v);
        return !(v > k->bend.e[j].error);
    }
    return false;
}

/* True if x' is zero at r within its error: a cusp, at which V is zero, too,
 * but not the curvature. */
static bool at_cusp(const curvature *k, const ix_root *r)
{
    int j = ix__spans_find(&k->c.q.dirs[0], r->t);
    double q;

    ix__form_eval(&k->c.q, &r->t, &q);
    return !(q > k->c.eq[j].error);
}

/* The curvature at t, at most that far from a cusp; NaN where there is none. */
static double curvature_near(ix_ctx *ctx, const ix_mv *crv, double t)
{
    double v;

    return ix_crv_curvature(ctx, crv, t, &v) == IX_OK ? v : (double)NAN;
}

/* A maximum if the curvature grows towards it on all sides inside the domain;
 * by steps of 1e-3 and 2e-3 of the span, where the cusp's own shape counts. */
static ix_crv_feature cusp_feature(ix_ctx *ctx, const ix_mv *crv,
                                   const curvature *k, const ix_root *r)
{
    const ix_spans *sp = &k->c.q.dirs[0];
    int j = ix__spans_find(sp, r->t);
    double h = 1e-3 * (sp->breaks[j + 1] - sp->breaks[j]);
    ix_crv_mark mark = IX_CRV_MAX;

    for (int side = -1; side <= 1; side += 2) {
        double far = r->t + 2 * side * h;

        if (far < sp->breaks[0] || far > sp->breaks[sp->nspans])
            continue;
        if (!(curvature_near(ctx, crv, r->t + side * h) >
              curvature_near(ctx, crv, far)))
            mark = IX_CRV_STATIONARY;
    }
    return (ix_crv_feature){*r, mark, (double)NAN};
}

static int by_parameter(const ix_crv_feature *a, const ix_crv_feature *b)
{
    return (a->root.t > b->root.t) - (a->root.t < b->root.t);
}

/* Both lists are sorted; the features of the second are put in their places. */
static int merge(const ix_crv_feature *a, int na, const ix_crv_feature *b,
                 int nb, ix_crv_feature *out)
{
    int i = 0, j = 0, n = 0;

    while (i < na || j < nb)
        if (j == nb || (i < na && by_parameter(&a[i], &b[j]) <= 0))
            out[n++] = a[i++];
        else
            out[n++] = b[j++];
    return n;
}

static ix_status collect(ix_ctx *ctx, const ix_mv *crv, const curvature *k,
                         ix_crv_feature *f, int *n)
{
    ix_crv_feature *a, *b;
    int na = 0, nb = 0;

    IX_SCRATCH(ctx, a, k->bend.n + 1);
    IX_SCRATCH(ctx, b, k->slope.n + 1);
    for (int i = 0; i < k->bend.n; i++)
        if (k->bend.root[i].kind != IX_ROOT_INTERVAL)
            a[na++] = at_cusp(k, &k->bend.root[i])
                          ? cusp_feature(ctx, crv, k, &k->bend.root[i])
                          : (ix_crv_feature){k->bend.root[i], IX_CRV_FLAT, 0.0};
    for (int i = 0; i < k->slope.n; i++) {
        const ix_root *r = &k->slope.root[i];
        ix_crv_feature *x = &b[nb];

        if (r->kind == IX_ROOT_INTERVAL)
            continue;
        if (at_flat(k, r)) {
            if (k->c.dim == 2)
                continue;
            *x = at_cusp(k, r) ? cusp_feature(ctx, crv, k, r)
                               : (ix_crv_feature){*r, IX_CRV_FLAT, 0.0};
        } else {
            *x = (ix_crv_feature){*r, mark_of(k, r), 0.0};
            if (ix_crv_curvature(ctx, crv, r->t, &x->curvature) != IX_OK)
                x->curvature = (double)NAN; /* a cusp or a pole */
        }
        nb++;
    }
    if (k->c.dim == 3)
        na = 0; /* the zeros of a square are among those of its slope */
    *n = merge(a, na, b, nb, f);
    return IX_OK;
}

static ix_status features(ix_ctx *ctx, const ix_mv *crv, ix_crv_feature **f,
                          int *n)
{
    ix_crv_feature *all;
    curvature k;
    int count;

    IX_TRY(load_curvature(ctx, crv, &k));
    IX_SCRATCH(ctx, all, k.bend.n + k.slope.n + 1);
    IX_TRY(collect(ctx, crv, &k, all, &count));
    if (count == 0)
        return IX_OK;
    *f = ix__alloc(ctx, (size_t)count * sizeof **f);
    if (!*f)
        return IX_ENOMEM;
    memcpy(*f, all, (size_t)count * sizeof **f);
    *n = count;
    return IX_OK;
}

ix_status ix_crv_features(ix_ctx *ctx, const ix_mv *crv, ix_crv_feature **f,
                          int *n)
{
    *f = NULL;
    *n = 0;
    IX_RETURN_SCOPED(ctx, features(ctx, crv, f, n));
}

void ix_crv_features_free(ix_ctx *ctx, ix_crv_feature *f, int n)
{
    if (f)
        ix__free(ctx, f, (size_t)n * sizeof *f);
}
