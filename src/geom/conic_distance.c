/* conic_distance.c - points whose distances to two planar curves add up to a
 * constant: an ellipse, if the curves were its foci.
 *
 * Such a point is where the normals at C1(s) and C2(t) meet. With the tangent
 * directions T1, T2 and d = C2 - C1,
 *
 *   P - C1 = n1 (d.T2) / D,  P - C2 = n2 (d.T1) / D,  D = T1 x T2,
 *
 * n = T turned by 90 degrees, so the distances |P - Ci| fulfil
 *
 *   |T1| |d.T2| + |T2| |d.T1| = sum |D|.
 *
 * Squared twice, and divided by D^2, which it contains because
 *
 *   |T1|^2 (d.T2)^2 - |T2|^2 (d.T1)^2 = D E,
 *   E = (T1 x d)(T2.d) + (T1.d)(T2 x d),
 *
 * it is the field
 *
 *   sum^4 D^2 - 2 sum^2 (|T1|^2 (d.T2)^2 + |T2|^2 (d.T1)^2) + E^2,
 *
 * whose zeros have differences of distances among them; the locus leaves these
 * out. Rational curves: T = p'w - p w', d times both weights, sum too. */
#include <math.h>
#include <string.h>

#include "geom/lines.h"
#include "geom/parts.h"
#include "geom/path.h"
#include "geom/pool.h"
#include "iritx/solve.h"
#include "iritx/sym.h"

/* One curve: numerators, weight (NULL: 1) and tangent direction, first as
 * functions of its own parameter, then of both. */
typedef struct {
    const ix_mv *x, *y, *w, *tx, *ty;
} side;

static void load(ix_pool *q, const ix_mv *crv, side *s)
{
    const ix_mv *dw;

    if (q->st != IX_OK)
        return;
    s->x = ix__pool_axis(q, crv, crv->rational);
    s->y = ix__pool_axis(q, crv, crv->rational + 1);
    s->tx = ix__pool_derive(q, s->x, 0);
    s->ty = ix__pool_derive(q, s->y, 0);
    if (!crv->rational)
        return;
    s->w = ix__pool_axis(q, crv, 0);
    dw = ix__pool_derive(q, s->w, 0);
    s->tx = ix__pool_sub(q, ix__pool_mul(q, s->tx, s->w),
                         ix__pool_mul(q, s->x, dw));
    s->ty = ix__pool_sub(q, ix__pool_mul(q, s->ty, s->w),
                         ix__pool_mul(q, s->y, dw));
}

/* f over both parameters; it depends on the first one, or on the second. */
static const ix_mv *lift(ix_pool *q, const ix_mv *f, const ix_mv *other,
                         bool second)
{
    const ix_mv *m;

    if (q->st != IX_OK || !f)
        return NULL;
    q->st = ix__mv_product_domain(q->ctx, second ? other : f,
                                  second ? f : other, ix__pool_room(q),
                                  ix__pool_room(q) + 1);
    m = ix__pool_room(q)[second ? 1 : 0];
    q->n += 2;
    return m;
}

static side lift_all(ix_pool *q, const side *s, const ix_mv *other, bool second)
{
    return (side){.x = lift(q, s->x, other, second),
                  .y = lift(q, s->y, other, second),
                  .w = lift(q, s->w, other, second),
                  .tx = lift(q, s->tx, other, second),
                  .ty = lift(q, s->ty, other, second)};
}

/* a times the weight w, if there is one. */
static const ix_mv *weigh(ix_pool *q, const ix_mv *a, const ix_mv *w)
{
    return w ? ix__pool_mul(q, a, w) : a;
}

static const ix_mv *square(ix_pool *q, const ix_mv *a)
{
    return ix__pool_mul(q, a, a);
}

static const ix_mv *dot(ix_pool *q, const ix_mv *ax, const ix_mv *ay,
                        const ix_mv *bx, const ix_mv *by)
{
    return ix__pool_add(q, ix__pool_mul(q, ax, bx), ix__pool_mul(q, ay, by));
}

static const ix_mv *cross(ix_pool *q, const ix_mv *ax, const ix_mv *ay,
                          const ix_mv *bx, const ix_mv *by)
{
    return ix__pool_sub(q, ix__pool_mul(q, ax, by), ix__pool_mul(q, ay, bx));
}

static const ix_mv *field(ix_pool *q, const ix_mv *c1, const ix_mv *c2,
                          double sum)
{
    side u = {0}, v = {0}, a, b;
    const ix_mv *dx, *dy, *d1, *d2, *e, *n, *g;

    load(q, c1, &u);
    load(q, c2, &v);
    a = lift_all(q, &u, v.x, false);
    b = lift_all(q, &v, u.x, true);
    dx = ix__pool_sub(q, weigh(q, b.x, a.w), weigh(q, a.x, b.w));
    dy = ix__pool_sub(q, weigh(q, b.y, a.w), weigh(q, a.y, b.w));
    d1 = dot(q, a.tx, a.ty, dx, dy);
    d2 = dot(q, b.tx, b.ty, dx, dy);
    e = dot(q, cross(q, a.tx, a.ty, dx, dy), d1, d2,
            cross(q, b.tx, b.ty, dx, dy));
    n = ix__pool_add(
        q, ix__pool_mul(q, dot(q, a.tx, a.ty, a.tx, a.ty), square(q, d2)),
        ix__pool_mul(q, dot(q, b.tx, b.ty, b.tx, b.ty), square(q, d1)));
    n = weigh(q, weigh(q, n, a.w), a.w);
    n = weigh(q, weigh(q, n, b.w), b.w);
    g = cross(q, a.tx, a.ty, b.tx, b.ty);
    g = weigh(q, weigh(q, g, a.w), a.w);
    g = weigh(q, weigh(q, g, b.w), b.w);
    g = ix__pool_scale(q, square(q, g), pow(sum, 4));
    n = ix__pool_scale(q, n, 2 * sum * sum);
    return ix__pool_add(q, ix__pool_sub(q, g, n), square(q, e));
}

static ix_status check(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                       double sum)
{
    if (c1->ndirs != 1 || c2->ndirs != 1 || c1->ncoords < 2 || c2->ncoords < 2)
        return IX_FAIL(ctx, IX_EARG, "two planar curves are needed");
    if (!(sum > 0 && isfinite(sum)))
        return IX_FAIL(ctx, IX_EARG, "sum of distances %g is not positive",
                       sum);
    return IX_OK;
}

ix_status ix_conic_distance(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                            double sum, ix_mv **out)
{
    ix_pool q = {.ctx = ctx};
    ix_mv *p[2] = {NULL};
    const ix_mv *f;

    *out = NULL;
    IX_TRY(check(ctx, c1, c2, sum));
    q.st = ix__mv_plain2(ctx, c1, c2, &p[0], &p[1]);
    f = q.st == IX_OK ? field(&q, p[0], p[1], sum) : NULL;
    ix__mv_unref_all(ctx, p, 2);
    return ix__pool_give(&q, f, out);
}

/* --- the locus
 * ----------------------------------------------------------------
 */

typedef struct {
    ix_path p[2];
    double sum;
    bool euclid;
} locus;

/* The vertex for parameters st, as asked for; false if its distances do not
 * add up, or the normals are parallel. */
static bool vertex(const locus *l, const double *st, double out[3])
{
    double d[2][2][3], v[2], cross, along2, along1, dist;

    for (int i = 0; i < 2; i++)
        ix__path_derivs3(&l->p[i], ix__path_span(&l->p[i], st[i]), st[i], 1,
                         d[i]);
    for (int k = 0; k < 2; k++)
        v[k] = d[1][0][k] - d[0][0][k];
    cross = d[0][1][0] * d[1][1][1] - d[0][1][1] * d[1][1][0];
    along2 = v[0] * d[1][1][0] + v[1] * d[1][1][1];
    along1 = v[0] * d[0][1][0] + v[1] * d[0][1][1];
    dist = (hypot(d[0][1][0], d[0][1][1]) * fabs(along2) +
            hypot(d[1][1][0], d[1][1][1]) * fabs(along1)) /
           fabs(cross);
    out[0] = st[0];
    out[1] = st[1];
    out[2] = 0;
    if (l->euclid) {
        out[0] = d[0][0][0] - d[0][1][1] * along2 / cross;
        out[1] = d[0][0][1] + d[0][1][0] * along2 / cross;
    }
    /* other signs are off by twice a distance; the vertices are good to
       rounding, which the squares halve: 1e-6 */
    return fabs(dist - l->sum) <= 1e-6 * l->sum;
}

/* The curves' vertices, cut where they do not belong to the locus. */
static ix_status collect(ix_ctx *ctx, const locus *l,
                         const ix_solution_curves *s, ix_lines *out)
{
    size_t total = 0, used = 0;

    for (int i = 0; i < s->ncurves; i++)
        total += (size_t)s->curve[i].n;
    IX_TRY(ix__lines_new(ctx, total, out));
    for (int i = 0; i < s->ncurves; i++) {
        bool open = false;

        for (int k = 0; k < s->curve[i].n; k++) {
            if (!vertex(l, s->curve[i].x + 2 * k, out->pt[used])) {
                open = false;
                continue;
            }
            if (!open)
                out->count[out->n++] = 0;
            open = true;
            out->count[out->n - 1]++;
            used++;
        }
    }
    return IX_OK;
}

static ix_status trace(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2, locus *l,
                       double tol, ix_lines *out)
{
    const ix_curves_opts o = {.tol = tol};
    ix_solution_curves s = {0};
    ix_equation eq = {.rel = IX_EQUAL_ZERO};
    ix_mv *f = NULL;
    ix_status st;

    IX_TRY(ix__path_new(ctx, c1, &l->p[0]));
    IX_TRY(ix__path_new(ctx, c2, &l->p[1]));
    IX_TRY(ix_conic_distance(ctx, c1, c2, l->sum, &f));
    eq.f = f;
    st = ix_solve_curves(ctx, 1, &eq, &o, &s);
    ix_mv_unref(ctx, f);
    IX_TRY(st);
    st = collect(ctx, l, &s, out);
    ix_solution_curves_free(ctx, &s);
    return st;
}

ix_status ix_conic_locus(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                         double sum, bool euclid, double tol, ix_lines *out)
{
    locus l = {.sum = sum, .euclid = euclid};
    ix_mark mk;
    ix_status st;

    *out = (ix_lines){0};
    IX_TRY(check(ctx, c1, c2, sum));
    mk = ix__scratch_mark(ctx);
    st = trace(ctx, c1, c2, &l, tol, out);
    ix__scratch_release(ctx, mk);
    return st;
}
