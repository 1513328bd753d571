/* bisector_touch.c - single points of curve/curve bisectors, and the kinds of
 * end points. */
#include <math.h>
#include <string.h>

#include "geom/parts.h"
#include "iritx/ops_plane.h"
#include "mv/mv.h"
#include "ops/plane_bisector.h"

/* --- circles that touch twice ----------------------------------------------
 *
 * The circle through c with the unit normal n there and through x(t) has the
 * curvature k = 2 n.v / |v|^2, v = x - c; it touches where k is stationary:
 * h = n.x' |v|^2 - 2 (n.v)(x'.v) = 0. */

typedef struct {
    double c[2], n[2];
} ray;

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1];
}

/* Value, first and second derivative of the first two coordinates. */
static ix_status derivs(ix_ctx *ctx, const ix_mv *c, double t, double out[3][2])
{
    double d[3 * IX_MAX_COORDS];

    IX_TRY(ix_mv_curve_derivs(ctx, c, t, 2, d));
    for (int i = 0; i < 3; i++)
        memcpy(out[i], d + i * c->ncoords, sizeof out[i]);
    return IX_OK;
}

static ix_status ray_at(ix_ctx *ctx, const ix_mv *c, double t, int side,
                        ray *out)
{
    double d[3][2], len;

    IX_TRY(derivs(ctx, c, t, d));
    len = hypot(d[1][0], d[1][1]);
    if (!(len > 0.0))
        return IX_FAIL(ctx, IX_EDOMAIN, "no tangent at %g", t);
    memcpy(out->c, d[0], sizeof out->c);
    out->n[0] = -side * d[1][1] / len;
    out->n[1] = side * d[1][0] / len;
    return IX_OK;
}

/* h over its derivative, and k. */
static ix_status newton(ix_ctx *ctx, const ix_mv *c, const ray *r, double t,
                        double *step, double *k)
{
    double d[3][2], v[2], vv, nv, h, dh;

    IX_TRY(derivs(ctx, c, t, d));
    v[0] = d[0][0] - r->c[0];
    v[1] = d[0][1] - r->c[1];
    vv = dot(v, v);
    nv = dot(r->n, v);
    h = dot(r->n, d[1]) * vv - 2.0 * nv * dot(d[1], v);
    dh = dot(r->n, d[2]) * vv - 2.0 * nv * (dot(d[2], v) + dot(d[1], d[1]));
    *step = h / dh;
    *k = 2.0 * nv / vv;
    return IX_OK;
}

/* Steps that are this small a part of the domain, and do not become smaller,
 * are rounding. */
#define ROUNDED 1e-7

static ix_status solve(ix_ctx *ctx, const ix_mv *c, const ray *r, double *t,
                       double *k)
{
    double dom[2], step, before = INFINITY;

    ix_mv_domain(c, 0, dom);
    for (int i = 0; i < 50; i++) {
        double next, len;

        IX_TRY(newton(ctx, c, r, *t, &step, k));
        next = fmin(fmax(*t - step, dom[0]), dom[1]);
        len = fabs(next - *t);
        if (!isfinite(next))
            break;
        if (len <= 1e-15 * (fabs(next) + dom[1] - dom[0]) ||
            (len <= ROUNDED * (dom[1] - dom[0]) && len >= 0.9 * before))
            return IX_OK;
        *t = next;
        before = len;
    }
    return IX_FAIL(ctx, IX_EUNABLE,
                   "no circle that touches both curves is near");
}

/* A foot that is farther from where it was expected may be another one: a foot
 * at a corner belongs to one of two spans, and is looked for from both. */
#define EXPECTED 1e-3

static ix_status solve_near(ix_ctx *ctx, const ix_mv *c, const ray *r,
                            double *t, double *k)
{
    double dom[2], from = *t, best = INFINITY;
    ix_status st = IX_OK;

    *k = 0.0;
    ix_mv_domain(c, 0, dom);
    for (int i = 0; i < 3 && !(best <= EXPECTED * (dom[1] - dom[0])); i++) {
        double aside = (i == 2 ? -1 : i) * ROUNDED * (dom[1] - dom[0]);
        double u = fmin(fmax(from + aside, dom[0]), dom[1]), found = 0.0;

        st = solve(ctx, c, r, &u, &found);
        if (st == IX_ENOMEM)
            return st;
        if (st == IX_OK && found > 0.0 && fabs(u - from) < best) {
            best = fabs(u - from);
            *t = u;
            *k = found;
        }
    }
    return *k > 0.0 ? IX_OK : st;
}

/* With both curves near the origin, where their coordinates have most digits.
 */
static ix_status touch(ix_ctx *ctx, const ix_mv *const c[2], int side,
                       double foot[2], double b[2], double *r)
{
    ray own;
    double k;

    IX_TRY(ray_at(ctx, c[0], foot[0], side, &own));
    IX_TRY(solve_near(ctx, c[1], &own, &foot[1], &k));
    if (!(k > 0.0))
        return IX_FAIL(ctx, IX_EUNABLE, "the circle is a line");
    *r = 1.0 / k;
    b[0] = own.c[0] + *r * own.n[0];
    b[1] = own.c[1] + *r * own.n[1];
    return IX_OK;
}

static ix_status moved_touch(ix_ctx *ctx, const ix_mv *const *c,
                             const double q[2], int side, double foot[2],
                             double b[2], double *r)
{
    ix_mv *near[2] = {NULL, NULL};
    ix_status st = ix__plane_moved(ctx, c[0], -1.0, q, &near[0]);

    if (st == IX_OK)
        st = ix__plane_moved(ctx, c[1], -1.0, q, &near[1]);
    if (st == IX_OK) {
        const ix_mv *const both[2] = {near[0], near[1]};

        st = touch(ctx, both, side, foot, b, r);
    }
    for (int i = 0; i < 2; i++) {
        ix_mv_unref(ctx, near[i]);
        b[i] = st == IX_OK ? b[i] + q[i] : 0.0;
    }
    return st;
}

static ix_status scoped(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2, int side,
                        double foot[2], double b[2], double *r)
{
    const ix_mv *const c[2] = {c1, c2};
    double q[IX_MAX_COORDS];
    ix_mv **flat;
    ix_status st;

    IX_TRY(ix__plane_curves(ctx, 2, c, &flat));
    st = ix_mv_point(ctx, flat[0], &foot[0], q);
    if (st == IX_OK)
        st = moved_touch(ctx, (const ix_mv *const *)flat, q, side < 0 ? -1 : 1,
                         foot, b, r);
    ix__mv_unref_all(ctx, flat, 2);
    return st;
}

ix_status ix_bisector_touch(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                            int side, double foot[2], double b[2], double *r)
{
    b[0] = b[1] = *r = 0.0;
    IX_RETURN_SCOPED(ctx, scoped(ctx, c1, c2, side, foot, b, r));
}

/* --- ends of segments ------------------------------------------------------
 */

/* Counts a foot on the other curve unless it was counted. */
typedef struct {
    int n;
    double foot[2];
} feet;

static void count(feet *f, double t, double tol)
{
    for (int i = 0; i < f->n; i++)
        if (fabs(f->foot[i] - t) <= tol)
            return;
    if (f->n < 2)
        f->foot[f->n++] = t;
}

void ix_bisector_ends(const ix_bisector *b, const ix_mv *c1, const ix_mv *c2,
                      ix_end_class out[4])
{
    double dom[2][2];
    feet f[2][2] = {{{0}}};

    ix_mv_domain(c1, 0, dom[0]);
    ix_mv_domain(c2, 0, dom[1]);
    for (int i = 0; i < b->n; i++) {
        const ix_bisector_piece *p = &b->piece[i];

        for (int e = 0; p->kind == IX_CURVE_CURVE && e < 2; e++)
            for (int c = 0; c < 2; c++) {
                const double *foot = p->foot + (e ? 2 * (p->n - 1) : 0);
                double len = dom[c][1] - dom[c][0];

                /* ends are found to about 1e-7 of a parameter */
                for (int k = 0; k < 2; k++)
                    if (fabs(foot[c] - dom[c][k]) <= 1e-6 * len)
                        count(&f[c][k], foot[1 - c],
                              1e-6 * (dom[1 - c][1] - dom[1 - c][0]));
            }
    }
    for (int c = 0; c < 2; c++)
        for (int k = 0; k < 2; k++)
            out[2 * c + k] = (ix_end_class)f[c][k].n;
}
