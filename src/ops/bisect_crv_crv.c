/* bisect_crv_crv.c - the true bisector of two objects made of curves. */
#include <string.h>

#include "geom/parts.h"
#include "iritx/distance.h"
#include "iritx/ops_plane.h"
#include "mv/mv.h"
#include "ops/plane_bisector.h"

/* Samples of each side of a span, before any refinement. */
enum { GRID = 8 };

/* --- crossings -------------------------------------------------------------
 *
 * Where the curves cross four branches meet. They may belong to parts of the
 * bisector, however small, that are connected to others by crossings only: on
 * either side of the first curve, a little before and behind each crossing, the
 * walk looks for them. */

typedef struct {
    int n;
    ix__place *p;
} places;

/* The border elements of span i, at u - step and u + step. */
static void both_sides(const ix__set *s, int i, double u, double step,
                       places *out)
{
    for (int j = 0; j < s->nborders; j++) {
        const ix__border *e = &s->border[j];

        if (e->kind != IX__SIDE || e->index != i)
            continue;
        for (int k = -1; k <= 1; k += 2) {
            double at = (e->side > 0 ? u : 1.0 - u) + k * step;

            if (at > 0.0 && at < 1.0)
                out->p[out->n++] = (ix__place){j, at};
        }
    }
}

/* Branches whose feet stay near a crossing, or near an end where one curve goes
 * on from the other, may be as short as that on the curve. */
static const double steps[] = {1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2};
enum { STEPS = sizeof steps / sizeof *steps };

static void add_crossing(const ix__set *s, int curve, double t, places *out)
{
    for (int i = 0; i < s->nspans; i++) {
        const ix__span *sp = &s->span[i];
        double u = (t - sp->t[0]) / (sp->t[1] - sp->t[0]);

        if (sp->curve == curve && u > -1e-9 && u < 1.0 + 1e-9) {
            for (int k = 0; k < STEPS; k++)
                both_sides(s, i, u, steps[k], out);
        }
    }
}

/* Two sides, two directions, and two spans at a joint. */
enum { PER_CROSSING = 8 * STEPS };

static ix_status crossings(ix_ctx *ctx, const ix__set *s, int curve,
                           const ix_mv *a, const ix_mv *b, places *out)
{
    /* overlapping curves would fill any number of boxes */
    static const ix_solve_opts few = {.max_boxes = 20000};
    ix_solutions meet;
    ix__place *more;

    IX_TRY(ix_crv_crv_meet(ctx, a, b, &few, &meet));
    more = ix__scratch(ctx, (size_t)out->n + PER_CROSSING * (size_t)meet.n,
                       sizeof *more);
    if (more) {
        if (out->n)
            memcpy(more, out->p, (size_t)out->n * sizeof *more);
        out->p = more;
        for (int i = 0; i < meet.n; i++)
            add_crossing(s, curve, meet.sol[i].x[0], out);
    }
    ix_solutions_free(ctx, &meet);
    return more ? IX_OK : IX_ENOMEM;
}

static ix_status all_crossings(ix_ctx *ctx, const ix__object obj[2],
                               places *out)
{
    for (int i = 0; i < obj[0].n; i++)
        for (int j = 0; j < obj[1].n; j++)
            IX_TRY(crossings(ctx, obj[0].set, i, obj[0].crv[i], obj[1].crv[j],
                             out));
    return IX_OK;
}

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
    places seeds = {0, NULL};
    ix__walked done;

    IX_TRY(all_crossings(ctx, obj, &seeds));
    IX_TRY(ix__walk_all(ctx, &w, seeds.n, seeds.p, &done));
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
