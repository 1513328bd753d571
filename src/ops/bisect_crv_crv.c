/* bisect_crv_crv.c - the true bisector of two objects made of curves. */
#include "geom/parts.h"
#include "iritx/ops_plane.h"
#include "mv/mv.h"
#include "ops/plane_bisector.h"

/* Samples of each side of a span, before any refinement. */
enum { GRID = 8 };

/* --- the walk --------------------------------------------------------------
 */

/* Do the boxes of any two spans overlap? */
static bool may_meet(const ix__set *a, const ix__set *b)
{
    for (int i = 0; i < a->nspans; i++)
        for (int j = 0; j < b->nspans; j++) {
            const ix__span *p = &a->span[i], *q = &b->span[j];
            bool apart = p->boxed && q->boxed;

            if (!apart)
                return true;
            apart = false;
            for (int k = 0; k < 2; k++)
                apart = apart || p->box[0][k] > q->box[1][k] ||
                        q->box[0][k] > p->box[1][k];
            if (!apart)
                return true;
        }
    return false;
}

static ix_status walk(ix_ctx *ctx, const ix__object obj[2],
                      const ix_frame *frame, double tol, ix_bisector *out)
{
    ix__walk w = {obj[0].set,
                  obj[1].set,
                  tol,
                  GRID,
                  may_meet(obj[0].set, obj[1].set),
                  ix__sets_size(obj[0].set, obj[1].set)};
    ix__place *seeds;
    ix__walked done;
    int n;

    IX_TRY(ix__plane_seeds(ctx, obj, &n, &seeds));
    IX_TRY(ix__walk_all(ctx, &w, n, seeds, &done));
    IX_TRY(ix__walked_chain(ctx, &done));
    return ix__bisector_make(ctx, &done, obj, frame, out);
}

static ix_status run(ix_ctx *ctx, const int n[2], ix_mv *const *const *crv,
                     double tol, ix_bisector *out)
{
    ix__set set[2];
    ix__object obj[2];
    ix_frame frame;
    const ix_mv **all;

    IX_SCRATCH(ctx, all, n[0] + n[1]);
    for (int i = 0; i < n[0] + n[1]; i++)
        all[i] = i < n[0] ? crv[0][i] : crv[1][i - n[0]];
    IX_TRY(ix__plane_frame(ctx, n[0] + n[1], all, 0, NULL, &frame));
    for (int i = 0; i < 2; i++) {
        const ix_mv *const *c = i ? all + n[0] : all;

        IX_TRY(ix__set_of_curves(ctx, n[i], c, &frame, (ix__set_opts){0},
                                 &set[i]));
        obj[i] = (ix__object){.set = &set[i], .n = n[i], .crv = c};
    }
    ix__sets_share(&set[0], &set[1]);
    return walk(ctx, obj, &frame, tol, out);
}

static ix_status scoped(ix_ctx *ctx, const int n[2],
                        const ix_mv *const *const c[2], double tol,
                        ix_bisector *out)
{
    ix_mv **crv[2] = {NULL, NULL};
    ix_status st;

    IX_TRY(ix__bisector_tol(ctx, tol, &tol));
    IX_TRY(ix__plane_curves(ctx, n[0], c[0], &crv[0]));
    st = ix__plane_curves(ctx, n[1], c[1], &crv[1]);
    if (st == IX_OK) {
        ix_mv *const *const both[2] = {crv[0], crv[1]};

        st = run(ctx, n, both, tol, out);
        ix__mv_unref_all(ctx, crv[1], n[1]);
    }
    ix__mv_unref_all(ctx, crv[0], n[0]);
    return st;
}

ix_status ix_bisect_crv_crv(ix_ctx *ctx, int n1, const ix_mv *const *c1, int n2,
                            const ix_mv *const *c2, double tol,
                            ix_bisector *out)
{
    const int n[2] = {n1, n2};
    const ix_mv *const *const c[2] = {c1, c2};

    *out = (ix_bisector){0};
    if (n1 < 1 || n2 < 1)
        return IX_FAIL(ctx, IX_EARG,
                       "%d and %d curves: each object has one at "
                       "least",
                       n1, n2);
    IX_RETURN_SCOPED(ctx, scoped(ctx, n, c, tol, out));
}
