/* srf_feet.c - the points of a surface nearest to a point: interior feet of
 * perpendiculars, then the four boundary curves. */
#include <math.h>

#include "iritx/distance.h"
#include "iritx/sym.h"
#include "mv/mv.h"

static ix_status check_surface(ix_ctx *ctx, const ix_mv *s)
{
    if (s->ndirs != 2 || s->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a surface of at "
                       "most 3 is wanted",
                       s->ndirs, s->ncoords);
    return IX_OK;
}

/* (S - p) . dS/du_dir, new reference. */
static ix_status foot_field(ix_ctx *ctx, const ix_mv *rel, int dir, ix_mv **out)
{
    ix_mv *d;
    ix_status st;

    IX_TRY(ix_sym_derive(ctx, rel, dir, NULL, &d));
    st = ix_sym_dot(ctx, rel, d, NULL, out);
    ix_mv_unref(ctx, d);
    return st;
}

static ix_status solve_feet(ix_ctx *ctx, const ix_mv *rel, ix_solutions *out)
{
    ix_equation eq[2] = {{.rel = IX_EQUAL_ZERO}, {.rel = IX_EQUAL_ZERO}};
    ix_solve_opts o = {.max_boxes = 200000};
    ix_status st;
    ix_mv *f, *g;

    IX_TRY(foot_field(ctx, rel, 0, &f));
    st = foot_field(ctx, rel, 1, &g);
    if (st == IX_OK) {
        eq[0].f = f;
        eq[1].f = g;
        eq[0].axis = eq[1].axis = rel->rational;
        st = ix_solve(ctx, 2, eq, &o, out);
        ix_mv_unref(ctx, g);
    }
    ix_mv_unref(ctx, f);
    return st;
}

ix_status ix_srf_feet(ix_ctx *ctx, const ix_mv *s, const double p[3],
                      ix_solutions *out)
{
    const double shift[16] = {1, 0, 0, 0, 0,     1,     0,     0,
                              0, 0, 1, 0, -p[0], -p[1], -p[2], 1};
    ix_mv *wide, *rel;
    ix_status st;

    *out = (ix_solutions){.n = 0};
    IX_TRY(check_surface(ctx, s));
    IX_TRY(ix_mv_coerce(ctx, s, 3, s->rational, &wide));
    st = ix_mv_transform(ctx, wide, shift, &rel);
    ix_mv_unref(ctx, wide);
    IX_TRY(st);
    st = solve_feet(ctx, rel, out);
    ix_mv_unref(ctx, rel);
    return st;
}

typedef struct {
    double uv[2], d;
    bool any, farthest;
} champion;

static ix_status offer(ix_ctx *ctx, const ix_mv *s, const double p[3],
                       const double *uv, champion *b)
{
    double x[3] = {0, 0, 0}, d;

    IX_TRY(ix_mv_point(ctx, s, uv, x));
    d = sqrt((x[0] - p[0]) * (x[0] - p[0]) + (x[1] - p[1]) * (x[1] - p[1]) +
             (x[2] - p[2]) * (x[2] - p[2]));
    if (!b->any || (b->farthest ? d > b->d : d < b->d)) {
        b->uv[0] = uv[0];
        b->uv[1] = uv[1];
        b->d = d;
        b->any = true;
    }
    return IX_OK;
}

static ix_status offer_boundary(ix_ctx *ctx, const ix_mv *s, const double p[3],
                                int dir, double at, champion *b)
{
    double uv[2], d;
    ix_status st;
    ix_mv *c;

    uv[dir] = at;
    IX_TRY(ix_mv_fix(ctx, s, dir, at, &c));
    st = ix_crv_nearest(ctx, c, p, NULL, b->farthest, &uv[1 - dir], &d);
    ix_mv_unref(ctx, c);
    IX_TRY(st);
    return offer(ctx, s, p, uv, b);
}

ix_status ix_srf_nearest(ix_ctx *ctx, const ix_mv *s, const double p[3],
                         bool farthest, double uv[2], double *distance)
{
    champion b = {.farthest = farthest};
    ix_solutions sol;
    ix_status st = IX_OK;

    IX_TRY(ix_srf_feet(ctx, s, p, &sol));
    for (int i = 0; st == IX_OK && i < sol.n; i++)
        st = offer(ctx, s, p, sol.sol[i].x, &b);
    ix_solutions_free(ctx, &sol);
    IX_TRY(st);
    for (int dir = 0; dir < 2; dir++) {
        double dom[2];

        ix_mv_domain(s, dir, dom);
        for (int e = 0; e < 2; e++)
            IX_TRY(offer_boundary(ctx, s, p, dir, dom[e], &b));
    }
    uv[0] = b.uv[0];
    uv[1] = b.uv[1];
    *distance = b.d;
    return IX_OK;
}
