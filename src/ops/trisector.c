/* trisector.c - curves equally far from three objects: all points of them that
 * a search by boxes finds (trisector_search.c) are followed (trisector_walk.c)
 * and joined (trisector_join.c). Three points have a line. */
#include <math.h>
#include <string.h>

#include "geom/lines.h"
#include "geom/vec3.h"
#include "iritx/ops_mbisect.h"
#include "ops/contact.h"
#include "ops/trisector_impl.h"

static int rank_of(const ix_mv *m)
{
    return ix__is_point(m) ? 0 : m->ndirs;
}

static ix_status check(ix_ctx *ctx, const ix_mv *const in[3])
{
    for (int i = 0; i < 3; i++)
        if (in[i]->ndirs < 1 || in[i]->ndirs > 2 || in[i]->ncoords < 2 ||
            in[i]->ncoords > 3)
            return IX_FAIL(ctx, IX_EARG,
                           "operand %d has %d directions and %d coordinates: a "
                           "point, curve or surface with 2 or 3 is needed",
                           i + 1, in[i]->ndirs, in[i]->ncoords);
    return IX_OK;
}

/* --- three points -----------------------------------------------------------
 */

/* The part of the line p + t u in the box; false if there is none. */
static bool cross_box(const double box[6], const double p[3], const double u[3],
                      double t[2])
{
    t[0] = -HUGE_VAL;
    t[1] = HUGE_VAL;
    for (int i = 0; i < 3; i++) {
        double a = (box[i] - p[i]) / u[i], b = (box[3 + i] - p[i]) / u[i];

        if (u[i] == 0.0 && !(p[i] >= box[i] && p[i] <= box[3 + i]))
            return false;
        if (u[i] == 0.0)
            continue;
        t[0] = fmax(t[0], fmin(a, b));
        t[1] = fmin(t[1], fmax(a, b));
    }
    return t[0] < t[1];
}

/* The axis of the points' circle, from one side of the box to the other. */
static ix_status three_points(ix_ctx *ctx, double q[3][3], const double box[6],
                              ix_lines *out)
{
    double r[3][3] = {{0}}, h[3], e[3], mid[3], p[3], t[2];

    for (int i = 0; i < 2; i++) {
        ix__sub3(q[i + 1], q[0], e);
        if (!(ix__unit3(e, r[i]) > 0))
            return IX_FAIL(ctx, IX_EDOMAIN, "two of the points are one");
        ix__axpy3(q[0], 0.5, e, mid);
        h[i] = ix__dot3(r[i], mid);
    }
    ix__cross3(r[0], r[1], r[2]);
    if (!(ix__unit3(r[2], r[2]) > 1e-9))
        return IX_OK; /* on one line: there is no circle */
    h[2] = ix__dot3(r[2], q[0]);
    if (!ix__meet_planes(3, 3, r, h, p) || !cross_box(box, p, r[2], t))
        return IX_OK;
    IX_TRY(ix__lines_new(ctx, 2, out));
    out->count[out->n++] = 2;
    for (int i = 0; i < 2; i++)
        ix__axpy3(p, t[i], r[2], out->pt[i]);
    return IX_OK;
}

/* --- entry ------------------------------------------------------------------
 */

/* Points before curves before surfaces. */
static ix_status load(ix__tri_task *k, const ix_mv *const in[3])
{
    int n = 0, ndirs[3];

    for (int pass = 0; pass <= 2; pass++)
        for (int i = 0; i < 3; i++)
            if (rank_of(in[i]) == pass) {
                ndirs[n] = pass;
                IX_TRY(
                    ix__tri_object_of(k->ctx, i + 1, in[i], &k->object[n++]));
            }
    k->shape = ix__tri_shape_of(ndirs);
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, const ix_mv *const in[3], double tol,
                     const double *box, ix_lines *out, bool *complete)
{
    ix__tri_task k = {.ctx = ctx,
                      .box = box,
                      .step = sqrt(tol > 0.0 ? tol : 1e-4),
                      .complete = true};

    IX_TRY(check(ctx, in));
    IX_TRY(load(&k, in));
    for (int i = 0; i < 3; i++)
        k.size = fmax(k.size, box[3 + i] - box[i]);
    if (k.shape.nvars == 3) {
        double q[3][3];

        for (int i = 0; i < 3; i++)
            memcpy(q[i], k.object[i].span[0].p.c + 1, sizeof q[i]);
        IX_TRY(three_points(ctx, q, box, out));
    } else {
        IX_TRY(ix__tri_search(&k));
        IX_TRY(ix__tri_join(&k, out));
    }
    *complete = k.complete;
    return IX_OK;
}

ix_status ix_trisector(ix_ctx *ctx, const ix_mv *const m[3], double tol,
                       const double box[6], ix_lines *out, bool *complete)
{
    *out = (ix_lines){.n = 0};
    *complete = false;
    if (!(tol >= 0.0))
        return IX_FAIL(ctx, IX_EARG, "a tolerance of %g", tol);
    for (int k = 0; k < 3; k++)
        if (!(box[k] < box[3 + k]))
            return IX_FAIL(ctx, IX_EARG, "an empty box: %g to %g in axis %d",
                           box[k], box[3 + k], k + 1);
    IX_RETURN_SCOPED(ctx, run(ctx, m, tol, box, out, complete));
}
