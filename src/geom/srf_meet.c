/* srf_meet.c - intersections of surfaces with surfaces and curves, as systems
 * in the parameters of all of them: no projection, no tessellation. */
#include "geom/outer_mv.h"
#include "geom/point_curves.h"
#include "iritx/distance.h"

static ix_status check(ix_ctx *ctx, const ix_mv *m, int ndirs, const char *what)
{
    if (m->ndirs != ndirs || m->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a %s of at most 3 "
                       "is wanted",
                       m->ndirs, m->ncoords, what);
    for (int j = 0; j < ndirs; j++)
        if (m->dirs[j].basis == IX_POWER)
            return IX_FAIL(ctx, IX_EARG,
                           "a %s in power basis: convert it to Bezier", what);
    return IX_OK;
}

static void release(ix_ctx *ctx, int n, ix_equation *eq, ix_mv **f)
{
    for (int i = 0; i < n; i++) {
        ix_mv_unref(ctx, f[i]);
        eq[i].f = NULL;
    }
}

/* a - b = 0, three equations; f[3] are references to be released. */
static ix_status difference(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                            ix_equation *eq, ix_mv **f)
{
    for (int k = 0; k < 3; k++) {
        ix_status st = ix__outer_difference(ctx, a, b, k, &f[k]);

        if (st != IX_OK) {
            release(ctx, k, eq, f);
            return st;
        }
        eq[k] = (ix_equation){.f = f[k], .axis = 0, .rel = IX_EQUAL_ZERO};
    }
    return IX_OK;
}

#define MAX_CELLS                                              \
    100000 /* surfaces that coincide have no curves in common: \
              the search is stopped when it has become pointless */

ix_status ix_srf_srf_meet(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                          double tol, ix_solution_curves *out)
{
    const ix_curves_opts o = {.tol = tol, .max_boxes = MAX_CELLS, .image = a};
    ix_equation eq[3];
    ix_mv *f[3];
    ix_status st;

    *out = (ix_solution_curves){.unknowns = 0};
    IX_TRY(check(ctx, a, 2, "surface"));
    IX_TRY(check(ctx, b, 2, "surface"));
    IX_TRY(difference(ctx, a, b, eq, f));
    st = ix_solve_curves(ctx, 3, eq, &o, out);
    release(ctx, 3, eq, f);
    if (st == IX_OK)
        st = ix__drop_point_curves(ctx, a, 0, out);
    if (st != IX_OK)
        ix_solution_curves_free(ctx, out);
    return st;
}

ix_status ix_crv_srf_meet(ix_ctx *ctx, const ix_mv *c, const ix_mv *s,
                          ix_solutions *out)
{
    const ix_solve_opts o = {.max_boxes = MAX_CELLS};
    ix_equation eq[3];
    ix_mv *f[3];
    ix_status st;

    *out = (ix_solutions){.n = 0};
    IX_TRY(check(ctx, c, 1, "curve"));
    IX_TRY(check(ctx, s, 2, "surface"));
    IX_TRY(difference(ctx, c, s, eq, f));
    st = ix_solve(ctx, 3, eq, &o, out);
    release(ctx, 3, eq, f);
    return st;
}

/* --- three surfaces
 * ----------------------------------------------------------- */

/* The surface on [0, 1]^2, as added directions are: new reference. */
static ix_status unit_domain(ix_ctx *ctx, const ix_mv *s, ix_mv **out)
{
    ix_mv *m = ix_mv_ref(s);

    for (int j = 0; j < 2; j++) {
        double dom[2];
        ix_status st;
        ix_mv *n;

        ix_mv_domain(m, j, dom);
        if (!(dom[0] < 0 || dom[0] > 0 || dom[1] < 1 || dom[1] > 1))
            continue;
        st = ix_mv_reparam(ctx, m, j, 0, 1, &n);
        ix_mv_unref(ctx, m);
        IX_TRY(st);
        m = n;
    }
    *out = m;
    return IX_OK;
}

/* a - b with its four directions at start .. start + 3 of six. */
static ix_status wide_difference(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                                 int start, ix_equation *eq, ix_mv **f)
{
    IX_TRY(difference(ctx, a, b, eq, f));
    for (int k = 0; k < 3; k++) {
        ix_mv *wide;
        ix_status st = ix_mv_promote(ctx, f[k], 6, start, &wide);

        if (st != IX_OK) {
            release(ctx, 3, eq, f);
            return st;
        }
        ix_mv_unref(ctx, f[k]);
        eq[k].f = f[k] = wide;
    }
    return IX_OK;
}

static ix_status solve_three(ix_ctx *ctx, ix_mv *const u[3], ix_solutions *out)
{
    const ix_solve_opts o = {.max_boxes = MAX_CELLS};
    ix_equation eq[6];
    ix_mv *f[6];
    ix_status st;

    IX_TRY(wide_difference(ctx, u[0], u[1], 0, eq, f));
    st = wide_difference(ctx, u[1], u[2], 2, eq + 3, f + 3);
    if (st == IX_OK) {
        st = ix_solve(ctx, 6, eq, &o, out);
        release(ctx, 3, eq + 3, f + 3);
    }
    release(ctx, 3, eq, f);
    return st;
}

static void to_domains(const ix_mv *const s[3], ix_solutions *out)
{
    for (int j = 0; j < 6; j++) {
        double dom[2];

        ix_mv_domain(s[j / 2], j % 2, dom);
        for (int i = 0; i < out->n; i++) {
            ix_solution *r = &out->sol[i];

            r->x[j] = dom[0] + r->x[j] * (dom[1] - dom[0]);
            r->lo[j] = dom[0] + r->lo[j] * (dom[1] - dom[0]);
            r->hi[j] = dom[0] + r->hi[j] * (dom[1] - dom[0]);
        }
    }
}

ix_status ix_srf3_meet(ix_ctx *ctx, const ix_mv *const s[3], ix_solutions *out)
{
    ix_mv *u[3] = {NULL, NULL, NULL};
    ix_status st = IX_OK;

    *out = (ix_solutions){.n = 0};
    for (int k = 0; k < 3; k++)
        IX_TRY(check(ctx, s[k], 2, "surface"));
    for (int k = 0; st == IX_OK && k < 3; k++)
        st = unit_domain(ctx, s[k], &u[k]);
    if (st == IX_OK)
        st = solve_three(ctx, u, out);
    for (int k = 0; k < 3; k++)
        ix_mv_unref(ctx, u[k]);
    if (st == IX_OK)
        to_domains(s, out);
    return st;
}
