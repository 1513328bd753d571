/* moment.c - centre of mass and principal axis of a curve as a thin wire of
 * constant density: integrals over the arc length. */
#include <math.h>

#include "geom/arclen.h"
#include "geom/eigen.h"
#include "geom/quad.h"
#include "geom/vec3.h"
#include "iritx/geom.h"

typedef struct {
    const ix_path *p;
    int span;
    double center[3];
} wire;

/* |C'| (1, x, y, z, xx, xy, xz, yy, yz, zz) relative to center. */
static void density(void *arg, double t, double *f)
{
    const wire *w = arg;
    double d[2][3], x[3];
    int k = 4;

    ix__path_derivs3(w->p, w->span, t, 1, d);
    ix__sub3(d[0], w->center, x);
    f[0] = ix__len3(d[1]);
    for (int i = 0; i < 3; i++)
        f[i + 1] = f[0] * x[i];
    for (int i = 0; i < 3; i++)
        for (int j = i; j < 3; j++)
            f[k++] = f[0] * x[i] * x[j];
}

static void integrate(wire *w, double sum[10])
{
    double part[10];

    for (int k = 0; k < 10; k++)
        sum[k] = 0;
    for (int s = 0; s < w->p->nspans; s++) {
        w->span = s;
        ix__quad(density, w, 10, w->p->breaks[s], w->p->breaks[s + 1], 1e-12,
                 part);
        for (int k = 0; k < 10; k++)
            sum[k] += part[k];
    }
}

/* crv is near the origin: far from it, x - center would lose its digits. */
static ix_status moments(ix_ctx *ctx, const ix_mv *crv, double center[3],
                         double axis[3])
{
    double sum[10], cov[9], val[3], vec[9], d[1][3];
    wire w = {.span = 0};
    ix_path p;

    IX_TRY(ix__path_new(ctx, crv, &p));
    IX_TRY(ix__path_no_poles(ctx, &p));
    w.p = &p;
    ix__path_derivs3(&p, 0, p.breaks[0], 0, d);
    for (int i = 0; i < 3; i++)
        w.center[i] = d[0][i];
    integrate(&w, sum);
    if (!(sum[0] > 0 && isfinite(sum[0])))
        return IX_FAIL(ctx, IX_EDOMAIN, "the curve has length %g", sum[0]);
    for (int i = 0; i < 3; i++)
        w.center[i] += sum[i + 1] / sum[0];
    for (int i = 0; i < 3; i++)
        center[i] = w.center[i];
    if (!axis)
        return IX_OK;
    integrate(&w, sum); /* again, about the centre: no cancellation */
    for (int i = 0, k = 4; i < 3; i++)
        for (int j = i; j < 3; j++)
            cov[3 * i + j] = cov[3 * j + i] = sum[k++];
    ix__eigen_symmetric(3, cov, val, vec);
    for (int i = 0; i < 3; i++)
        axis[i] = vec[i];
    return IX_OK;
}

/* crv with its start moved to the origin; new reference. */
static ix_status to_origin(ix_ctx *ctx, const ix_mv *crv, double start[3],
                           ix_mv **out)
{
    double mat[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    double dom[2], x[IX_MAX_COORDS] = {0};

    ix_mv_domain(crv, 0, dom);
    IX_TRY(ix_mv_point(ctx, crv, dom, x));
    for (int i = 0; i < 3; i++) {
        start[i] = i < ix_mv_ncoords(crv) ? x[i] : 0;
        mat[12 + i] = -start[i];
    }
    return ix_mv_transform(ctx, crv, mat, out);
}

ix_status ix_moments(ix_ctx *ctx, const ix_mv *crv, double center[3],
                     double axis[3])
{
    ix_mark mk = ix__scratch_mark(ctx);
    double start[3];
    ix_mv *near;
    ix_status st = to_origin(ctx, crv, start, &near);

    if (st == IX_OK) {
        st = moments(ctx, near, center, axis);
        ix_mv_unref(ctx, near);
    }
    for (int i = 0; st == IX_OK && i < 3; i++)
        center[i] += start[i];
    ix__scratch_release(ctx, mk);
    return st;
}
