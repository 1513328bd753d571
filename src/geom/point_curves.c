/* point_curves.c - curves of parameters that are a point in space.
 *
 * Where an edge of a surface is a single point, as the poles of a sphere are,
 * conditions that hold there hold along the whole edge: a curve in the
 * parameters, and none on the surface. */
#include "geom/point_curves.h"

#include <math.h>

#include "mv/mv.h"

#define ONE_POINT                                              \
    1e-9 /* of the largest coordinate: the vertices are on the \
            pole to rounding, which a high degree multiplies */

static ix_status is_point(ix_ctx *ctx, const ix_mv *m, const double *t,
                          int stride, int n, bool *yes)
{
    double a[IX_MAX_COORDS], x[IX_MAX_COORDS], size = 0;

    *yes = false;
    IX_TRY(ix_mv_point(ctx, m, t, a));
    for (int k = 0; k < m->ncoords; k++)
        size = fmax(size, fabs(a[k]));
    for (int i = 1; i < n; i++) {
        IX_TRY(ix_mv_point(ctx, m, t + (size_t)i * (size_t)stride, x));
        for (int k = 0; k < m->ncoords; k++)
            if (!(fabs(x[k] - a[k]) <= ONE_POINT * size))
                return IX_OK;
    }
    *yes = true;
    return IX_OK;
}

ix_status ix__drop_point_curves(ix_ctx *ctx, const ix_mv *m, int first,
                                ix_solution_curves *s)
{
    int kept = 0;

    for (int i = 0; i < s->ncurves; i++) {
        ix_solution_curve c = s->curve[i];
        bool drop;

        IX_TRY(is_point(ctx, m, c.x + first, s->unknowns, c.n, &drop));
        if (!drop) {
            s->curve[kept++] = c;
            continue;
        }
        if (c.start_singular >= 0)
            s->arcs[c.start_singular]--;
        if (c.end_singular >= 0)
            s->arcs[c.end_singular]--;
    }
    s->ncurves = kept;
    return IX_OK;
}
