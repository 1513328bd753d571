/* arrange_special.c - cutting the curves of an arrangement at inflections and
 * extrema. */
#include "geom/arrange_edges.h"
#include "iritx/ops_crv.h"

static ix_status mark_inflections(ix__marks *m)
{
    ix_root *r;
    int n;

    IX_TRY(ix_crv_inflections(m->ctx, m->crv, &r, &n));
    return ix__marks_add_roots(m, r, n);
}

static ix_status mark_extremes(ix__marks *m, int axis)
{
    const double at[2] = {0, 0}, normal[2] = {axis == 0, axis == 1};

    return ix__marks_add_line(m, at, normal, true);
}

static ix_status mark_curvature(ix__marks *m)
{
    ix_crv_feature *f;
    ix_status st;
    int n;

    st = ix_crv_features(m->ctx, m->crv, &f, &n);
    for (int i = 0; st == IX_OK && i < n; i++)
        if (f[i].mark == IX_CRV_MAX || f[i].mark == IX_CRV_MIN)
            st = ix__marks_add(m, f[i].root.t);
    ix_crv_features_free(m->ctx, f, n);
    return st;
}

static ix_status mark(ix__marks *m, unsigned what)
{
    if (what & IX_ARR_INFLECTIONS)
        IX_TRY(mark_inflections(m));
    if (what & IX_ARR_X_EXTREMES)
        IX_TRY(mark_extremes(m, 0));
    if (what & IX_ARR_Y_EXTREMES)
        IX_TRY(mark_extremes(m, 1));
    if (what & IX_ARR_CURVATURE)
        IX_TRY(mark_curvature(m));
    return IX_OK;
}

static ix_status cut(ix_ctx *ctx, ix_arrangement *a, unsigned what, double tol)
{
    ix__edges l = {.ctx = ctx};
    ix_status st = IX_OK;

    for (int i = 0; st == IX_OK && i < a->nedges; i++) {
        ix__marks m;

        st = ix__marks_ends(ctx, a->edge[i].crv, &m);
        if (st == IX_OK)
            st = mark(&m, what);
        if (st != IX_OK)
            break;
        ix__marks_thin(&m, tol);
        st = ix__edges_add_pieces(&l, &a->edge[i], &m);
    }
    return ix__edges_take(&l, a, st);
}

ix_status ix_arrangement_split_special(ix_ctx *ctx, ix_arrangement *a,
                                       unsigned what, double tol)
{
    if (what > 15 || !(tol >= 0))
        return IX_FAIL(ctx, IX_EARG,
                       "kinds %u, tolerance %g; the kinds are a sum of 1, 2, "
                       "4, 8, the tolerance is not negative",
                       what, tol);
    IX_RETURN_SCOPED(ctx, cut(ctx, a, what, tol));
}
