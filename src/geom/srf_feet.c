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

/* S - p, or (dir given) its part perpendicular to dir, in 3 coordinates. */
static ix_status relative(ix_ctx *ctx, const ix_mv *s, const double p[3],
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
    IX_TRY(check_surface(ctx, s));
    IX_TRY(relative(ctx, s, p, dir, &rel));
    st = solve_feet(ctx, rel, out);
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

typedef struct {
    const ix_mv *rel; /* the distance from the origin is meant */
    double uv[2], d;
    bool any, farthest;
} champion;

static ix_status offer(ix_ctx *ctx, const double *uv, champion *b)
{
    double x[3] = {0, 0, 0}, d;

    IX_TRY(ix_mv_point(ctx, b->rel, uv, x));
    d = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    if (!b->any || (b->farthest ? d > b->d : d < b->d)) {
        b->uv[0] = uv[0];
        b->uv[1] = uv[1];
        b->d = d;
        b->any = true;
    }
    return IX_OK;
}

static ix_status offer_boundary(ix_ctx *ctx, int dir, double at, champion *b)
{
    const double origin[3] = {0, 0, 0};
    double uv[2], d;
    ix_status st;
    ix_mv *c;

    uv[dir] = at;
    IX_TRY(ix_mv_fix(ctx, b->rel, dir, at, &c));
    st = ix_crv_nearest(ctx, c, origin, NULL, b->farthest, &uv[1 - dir], &d);
    ix_mv_unref(ctx, c);
    IX_TRY(st);
    return offer(ctx, uv, b);
}

static ix_status offer_all(ix_ctx *ctx, champion *b)
{
    ix_status st = IX_OK;
    ix_solutions sol;

    IX_TRY(solve_feet(ctx, b->rel, &sol));
    for (int i = 0; st == IX_OK && i < sol.n; i++)
        st = offer(ctx, sol.sol[i].x, b);
    ix_solutions_free(ctx, &sol);
    for (int dir = 0; st == IX_OK && dir < 2; dir++) {
        double dom[2];

        ix_mv_domain(b->rel, dir, dom);
        for (int e = 0; st == IX_OK && e < 2; e++)
            st = offer_boundary(ctx, dir, dom[e], b);
    }
    return st;
}

static ix_status nearest(ix_ctx *ctx, const ix_mv *s, const double p[3],
                         const double *dir, champion *b)
{
    ix_status st;
    ix_mv *rel;

    IX_TRY(check_surface(ctx, s));
    IX_TRY(relative(ctx, s, p, dir, &rel));
    b->rel = rel;
    st = offer_all(ctx, b);
    ix_mv_unref(ctx, rel);
    return st;
}

ix_status ix_srf_nearest(ix_ctx *ctx, const ix_mv *s, const double p[3],
                         bool farthest, double uv[2], double *distance)
{
    champion b = {.farthest = farthest};

    IX_TRY(nearest(ctx, s, p, NULL, &b));
    uv[0] = b.uv[0];
    uv[1] = b.uv[1];
    *distance = b.d;
    return IX_OK;
}

ix_status ix_srf_line_nearest(ix_ctx *ctx, const ix_mv *s, const double p[3],
                              const double dir[3], bool farthest, double uv[2],
                              double *distance)
{
    champion b = {.farthest = farthest};

    IX_TRY(nearest(ctx, s, p, dir, &b));
    uv[0] = b.uv[0];
    uv[1] = b.uv[1];
    *distance = b.d;
    return IX_OK;
}
