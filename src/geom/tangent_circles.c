/* tangent_circles.c - circles of a given radius that touch two planar curves.
 *
 * The unknowns are both parameters and the centre P: |Ci - P| = r and (Ci - P)
 * across the tangent of Ci. With the centre among them the equations stay of
 * low degree, and nothing vanishes where the normals are parallel. */
#include <math.h>

#include "geom/crvs.h"
#include "geom/unit_solve.h"
#include "iritx/distance.h"

/* X - w P of one curve, its tangent, its weight; all in (t1, t2, x, y). */
typedef struct {
    ix__vec d, t;
    const ix_mv *w;
} side;

static side load(ix_pool *q, const ix_mv *c, int at, ix__vec center)
{
    side s = {.w = NULL};
    ix__vec x;

    c = ix__pool_unit(q, c);
    if (!c)
        return s;
    x = ix__vec_of(q, c);
    x.x[2] = NULL;
    s.t = ix__vec_promote(q, ix__vec_tangent(q, x, 0), 4, at);
    x = ix__vec_promote(q, x, 4, at);
    s.w = x.w;
    s.d = ix__vec_between(q, x, center);
    return s;
}

/* |X - w P|^2 - r^2 w^2 */
static const ix_mv *at_radius(ix_pool *q, const side *s, const ix_mv *rr)
{
    const ix_mv *w2 = s->w ? ix__pool_mul(q, s->w, s->w) : NULL;

    return ix__diff0(q, ix__vec_dot(q, s->d, s->d),
                     w2 ? ix__prod0(q, rr, w2) : rr);
}

/* Where centres can be: the box of the first curve, enlarged. */
static ix_status center_box(ix_ctx *ctx, const ix_mv *c, double r,
                            double (*dom)[2])
{
    double lo[IX_MAX_COORDS], hi[IX_MAX_COORDS];

    IX_TRY(ix_mv_bbox(ctx, c, lo, hi));
    for (int k = 0; k < 2; k++) {
        /* a tenth more, so that no centre is on the boundary */
        dom[2 + k][0] = lo[k] - 1.1 * r;
        dom[2 + k][1] = hi[k] + 1.1 * r;
    }
    return IX_OK;
}

ix_status ix_crv_tangent_circles(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                                 double radius, ix_solutions *out)
{
    const ix_solve_opts o = {.max_boxes = 100000};
    ix_pool q = {.ctx = ctx};
    const ix_mv *rr, *f[4];
    double dom[4][2];
    ix__vec center = {{NULL}, NULL};
    side s[2];

    *out = (ix_solutions){.n = 0};
    IX_TRY(ix__check_planar(ctx, a));
    IX_TRY(ix__check_planar(ctx, b));
    if (!(radius > 0 && isfinite(radius)))
        return IX_FAIL(ctx, IX_EARG, "a radius of %g; it must be positive",
                       radius);
    IX_TRY(center_box(ctx, a, radius, dom));
    ix_mv_domain(a, 0, dom[0]);
    ix_mv_domain(b, 0, dom[1]);
    for (int k = 0; k < 2; k++)
        center.x[k] = ix__pool_linear(&q, dom[2 + k], 4, 2 + k);
    rr = ix__pool_linear(
        &q, (const double[2]){radius * radius, radius * radius}, 4, 0);
    s[0] = load(&q, a, 0, center);
    s[1] = load(&q, b, 1, center);
    for (int k = 0; k < 2; k++) {
        f[2 * k] = at_radius(&q, &s[k], rr);
        f[2 * k + 1] = ix__vec_dot(&q, s[k].d, s[k].t);
    }
    return ix__unit_solve(&q, 4, f, (const double(*)[2])dom, &o, out);
}
