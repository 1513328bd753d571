/* prim_torus.c - a torus and a plane.
 *
 * Moved by the minor radius they are a circle F(u) of the radius R around z and
 * the plane n.X = h, n = (a, 0, c). With the unit normal N(u, v) of the torus,
 *
 *   B = F + k / (1 - n.N) N,   k = n.F - h,
 *
 * has the distance k / (1 - n.N) from both. For each u that is a conic: F is
 * its focus, the plane its directrix, the length of n in the half plane of u
 * its eccentricity. Over the common denominator a factor w(u) of the circle
 * cancels: with its numerators C, S in u and c, s in v
 *
 *   B = (C g, S g, k s) / (w w - a C c - c w s),  g = R (w - c s) - h c
 *
 * which has degree 2 in u and in v. The weight is not negative; it is 0 where N
 * = n, the directions in which the surface is unbounded: two points (u, v). For
 * all u the radius is positive where g is, outside of an arc of v. */
#include <math.h>

#include "geom/angle.h"
#include "geom/vec3.h"
#include "iritx/geom.h"
#include "iritx/geom_srf.h"
#include "mv/mv.h"
#include "ops/prim.h"

/* The torus in its own axes: x is the part of the normal across its axis. */
typedef struct {
    double x[3], y[3], a, c, h; /* the plane n.X = h */
    double major;
} position;

static void position_of(const ix_prim *torus, const ix_prim *plane, position *p)
{
    double e[3];

    ix__sub3(plane->pos, torus->pos, e);
    p->h = ix__dot3(e, plane->dir);
    p->c = ix__dot3(plane->dir, torus->dir);
    ix__axpy3(plane->dir, -p->c, torus->dir, p->x);
    p->a = ix__unit3(p->x, p->x);
    ix__cross3(torus->dir, p->x, p->y);
    p->major = torus->major;
}

/* Rows w, x, y of the unit circle from the angle of (c, s) on. */
static void turned_rows(const ix_mv *circle, double c, double s, double *out)
{
    size_t n = ix_mv_npts(circle);
    const double *w = ix_mv_weights(circle), *x = ix_mv_coord(circle, 0),
                 *y = ix_mv_coord(circle, 1);

    for (size_t i = 0; i < n; i++) {
        out[i] = w[i];
        out[n + i] = c * x[i] - s * y[i];
        out[2 * n + i] = s * x[i] + c * y[i];
    }
}

/* u[3][nu], v[3][nv] by turned_rows; pts[4][nu nv]. */
static void fill(const position *p, double h, const size_t n[2],
                 const double *u, const double *v, double *pts)
{
    size_t total = n[0] * n[1];

    for (size_t j = 0; j < n[1]; j++)
        for (size_t i = 0; i < n[0]; i++) {
            double wu = u[i], cu = u[n[0] + i], wv = v[j], cv = v[n[1] + j],
                   sv = v[2 * n[1] + j], *q = pts + j * n[0] + i;
            double g = p->major * (wv - p->c * sv) - h * cv,
                   k = p->a * p->major * cu - h * wu;

            q[0] = wu * wv - p->a * cu * cv - p->c * wu * sv;
            q[total] = cu * g;
            q[2 * total] = u[2 * n[0] + i] * g;
            q[3 * total] = k * sv;
        }
}

static ix_status tensor(ix_ctx *ctx, const position *p, double h,
                        const ix_mv *const c[2], const double least[2],
                        ix_mv **out)
{
    const size_t n[2] = {ix_mv_npts(c[0]), ix_mv_npts(c[1])};
    const ix_dir d[2] = {ix_mv_dir(c[0], 0), ix_mv_dir(c[1], 0)};
    double *u, *v, *pts;

    IX_SCRATCH(ctx, u, 3 * n[0]);
    IX_SCRATCH(ctx, v, 3 * n[1]);
    IX_SCRATCH(ctx, pts, 4 * n[0] * n[1]);
    turned_rows(c[0], 1.0, 0.0, u);
    turned_rows(c[1], least[0], least[1], v);
    fill(p, h, n, u, v, pts);
    return ix_mv_new(ctx, 2, d, 3, true, pts, out);
}

/* u begins where n points, v at the least g = R - r cos(v): the arc of negative
 * ones is left out. */
static ix_status surface(ix_ctx *ctx, const position *p, double h, ix_mv **out)
{
    static const double zero[3] = {0, 0, 0};
    double r = hypot(p->c * p->major, h),
           least[2] = {r > 0 ? h / r : 1.0, r > 0 ? p->c * p->major / r : 0.0},
           cut = r > p->major ? IX__DEG(acos(p->major / r)) : 0.0;
    ix_mv *circle, *arc;
    ix_status st;

    IX_TRY(ix_circle(ctx, zero, 1.0, &circle));
    st = ix_mv_region(ctx, circle, 0, ix_circle_param(cut),
                      ix_circle_param(360.0 - cut), &arc);
    if (st == IX_OK) {
        const ix_mv *const c[2] = {circle, arc};

        st = tensor(ctx, p, h, c, least, out);
        ix_mv_unref(ctx, arc);
    }
    ix_mv_unref(ctx, circle);
    return st;
}

static ix_status place(ix_ctx *ctx, const ix_prim *torus, const position *p,
                       const ix_mv *local, ix__prim_set *s)
{
    double m[16] = {0};

    for (int k = 0; k < 3; k++) {
        m[k] = p->x[k];
        m[4 + k] = p->y[k];
        m[8 + k] = torus->dir[k];
        m[12 + k] = torus->pos[k];
    }
    m[15] = 1.0;
    IX_TRY(ix_mv_transform(ctx, local, m, &s->srf[s->n]));
    s->n++;
    return IX_OK;
}

ix_status ix__prim_torus_plane(ix_ctx *ctx, const ix_prim *torus,
                               const ix_prim *plane, double size,
                               ix__prim_set *s)
{
    position p;
    double tie;

    position_of(torus, plane, &p);
    tie = IX__ONE_POINT * (size + p.major + fabs(p.h));
    for (int side = 1; side >= -1; side -= 2) {
        double h = p.h - side * torus->radius;
        ix_mv *local;
        ix_status st;

        if (torus->radius > tie
                ? p.a * p.major - side * h < -tie /* the far side only */
                : side < 0)
            continue;
        IX_TRY(surface(ctx, &p, h, &local));
        st = place(ctx, torus, &p, local, s);
        ix_mv_unref(ctx, local);
        IX_TRY(st);
    }
    return IX_OK;
}
