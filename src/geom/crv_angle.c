/* crv_angle.c - pairs of points of a planar curve whose tangents make a given
 * angle. */
#include <math.h>
#include <string.h>

#include "geom/crvs.h"
#include "geom/lines.h"
#include "geom/unit_solve.h"
#include "iritx/visible.h"

static const ix_mv *angle_field(ix_pool *q, const ix_mv *crv, double theta)
{
    const ix_mv *c = ix__pool_unit(q, crv), *dot, *lens;
    double cs = cos(theta);
    ix__vec x, a, b;

    if (!c)
        return NULL;
    x = ix__vec_of(q, c);
    x.x[2] = NULL;
    x = ix__vec_tangent(q, x, 0);
    a = ix__vec_promote(q, x, 2, 0);
    b = ix__vec_promote(q, x, 2, 1);
    if (fabs(sin(theta)) <= 1e-12)
        return ix__vec_cross2(q, a, b);
    dot = ix__vec_dot(q, a, b);
    if (fabs(cs) <= 1e-12)
        return dot;
    lens = ix__prod0(q, ix__vec_dot(q, a, a), ix__vec_dot(q, b, b));
    return lens ? ix__diff0(q, ix__prod0(q, dot, dot),
                            ix__pool_scale(q, lens, cs * cs))
                : NULL;
}

/* NULL, or nothing but rounding of products of the tangents. */
static bool vanishes(const ix_mv *f)
{
    for (size_t i = 0; f && i < f->npts; i++)
        if (f->pts[i] < 0 || f->pts[i] > 0)
            return false;
    return true;
}

ix_status ix_crv_angle_field(ix_ctx *ctx, const ix_mv *crv, double theta,
                             ix_mv **out)
{
    ix_pool q = {.ctx = ctx};
    const ix_mv *f;
    double dom[2];

    *out = NULL;
    IX_TRY(ix__check_planar(ctx, crv));
    ix_mv_domain(crv, 0, dom);
    f = angle_field(&q, crv, theta);
    if (q.st == IX_OK && vanishes(f))
        q.st = IX_FAIL(ctx, IX_EDOMAIN,
                       "all tangents make this angle: a straight line");
    for (int d = 0; q.st == IX_OK && d < 2; d++)
        if (dom[0] < 0 || dom[0] > 0 || dom[1] < 1 || dom[1] > 1)
            f = ix__pool_made(&q, ix_mv_reparam(ctx, f, d, dom[0], dom[1],
                                                ix__pool_room(&q)));
    return ix__pool_give(&q, f, out);
}

/* Are all its vertices on t = r? */
static bool is_diagonal(const ix_solution_curve *k, double edge)
{
    for (int i = 0; i < k->n; i++)
        if (!(fabs(k->x[2 * i] - k->x[2 * i + 1]) <= 1e-9 * edge))
            return false;
    return true;
}

static ix_status keep(ix_ctx *ctx, const ix_solution_curves *s, double edge,
                      ix_lines *out)
{
    size_t points = 0;

    for (int i = 0; i < s->ncurves; i++)
        points += (size_t)s->curve[i].n;
    IX_TRY(ix__lines_new(ctx, points, out));
    points = 0;
    for (int i = 0; i < s->ncurves; i++) {
        const ix_solution_curve *k = &s->curve[i];

        if (is_diagonal(k, edge))
            continue;
        out->count[out->n++] = k->n;
        for (int v = 0; v < k->n; v++, points++) {
            memcpy(out->pt[points], k->x + 2 * (size_t)v, 2 * sizeof(double));
            out->pt[points][2] = 0;
        }
    }
    return IX_OK;
}

ix_status ix_crv_angle_pairs(ix_ctx *ctx, const ix_mv *crv, double theta,
                             double tol, ix_lines *out)
{
    const ix_curves_opts o = {.tol = tol};
    ix_equation eq = {.rel = IX_EQUAL_ZERO};
    ix_solution_curves s;
    double dom[2];
    ix_status st;
    ix_mv *f;

    *out = (ix_lines){0};
    IX_TRY(ix_crv_angle_field(ctx, crv, theta, &f));
    ix_mv_domain(f, 0, dom);
    eq.f = f;
    st = ix_solve_curves(ctx, 1, &eq, &o, &s);
    ix_mv_unref(ctx, f);
    IX_TRY(st);
    if (s.complete)
        st = keep(ctx, &s, dom[1] - dom[0], out);
    else
        st = IX_FAIL(ctx, IX_EUNABLE,
                     "stopped after %zu cells: tangents make this angle over "
                     "whole intervals, or nearly",
                     s.boxes);
    ix_solution_curves_free(ctx, &s);
    return st;
}
