/* srf_feet.c - points of a surface whose way to a point or a line is
 * perpendicular to it. */
#include <math.h>

#include "geom/feet.h"
#include "iritx/distance.h"
#include "iritx/sym.h"
#include "mv/mv.h"

#define MAX_BOXES 200000

ix_status ix__check_surface(ix_ctx *ctx, const ix_mv *s)
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

ix_status ix__feet_of_origin(ix_ctx *ctx, const ix_mv *rel, size_t max_boxes,
                             ix_solutions *out)
{
    ix_equation eq[2] = {{.rel = IX_EQUAL_ZERO}, {.rel = IX_EQUAL_ZERO}};
    const ix_solve_opts o = {.max_boxes = max_boxes};
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

ix_status ix__relative_to(ix_ctx *ctx, const ix_mv *s, const double p[3],
                          const double *dir, ix_mv **out)
{
    double m[16] = {0};
    double len = dir ? sqrt(dir[0] * dir[0] + dir[1] * dir[1] + dir[2] * dir[2])
                     : 1;
    ix_status st;
    ix_mv *wide;

    if (!(len > 0))
        return IX_FAIL(ctx, IX_EARG, "a line of direction (0, 0, 0)");
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            m[4 * i + k] = (i == k) - (dir ? dir[i] / len * (dir[k] / len) : 0);
            m[12 + k] -= p[i] * m[4 * i + k];
        }
    m[15] = 1;
    IX_TRY(ix_mv_coerce(ctx, s, 3, s->rational, &wide));
    st = ix_mv_transform(ctx, wide, m, out);
    ix_mv_unref(ctx, wide);
    return st;
}

static ix_status feet(ix_ctx *ctx, const ix_mv *s, const double p[3],
                      const double *dir, ix_solutions *out)
{
    ix_status st;
    ix_mv *rel;

    *out = (ix_solutions){.n = 0};
    IX_TRY(ix__check_surface(ctx, s));
    IX_TRY(ix__relative_to(ctx, s, p, dir, &rel));
    st = ix__feet_of_origin(ctx, rel, MAX_BOXES, out);
    ix_mv_unref(ctx, rel);
    return st;
}

ix_status ix_srf_feet(ix_ctx *ctx, const ix_mv *s, const double p[3],
                      ix_solutions *out)
{
    return feet(ctx, s, p, NULL, out);
}

ix_status ix_srf_line_feet(ix_ctx *ctx, const ix_mv *s, const double p[3],
                           const double dir[3], ix_solutions *out)
{
    return feet(ctx, s, p, dir, out);
}
