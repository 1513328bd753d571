/* prim_parallel.c - bisectors that are cylinders: of lines and cylinders with
 * parallel axes, of an axis and a plane parallel to it, of cones with parallel
 * axes and one angle.
 *
 * In the plane at a right angle to the axes these are circles with the centres
 * F1, F2, and what has equal distances from them is a conic with these foci
 * (Dutta and Hoffmann 1993):
 *
 *   |XF1| - r1 =   |XF2| - r2    a hyperbola, or a line for r1 = r2
 *   |XF1| - r1 = -(|XF2| - r2)   an ellipse
 *
 * of a circle and a line parabolas. Of cones the radii grow with the height,
 * r = k z: their difference is constant, their sum gives for each height an
 * ellipse with the same foci. */
#include <math.h>

#include "geom/angle.h"
#include "geom/vec3.h"
#include "iritx/geom.h"
#include "iritx/geom_srf.h"
#include "ops/prim.h"

/* The plane of the conic: x from the first axis to the second, z along both. */
typedef struct {
    double o[3], x[3], y[3], z[3], size;
} section;

/* From local to global, x and y scaled. */
static void matrix_of(const section *c, double a, double b, double z,
                      double m[16])
{
    for (int k = 0; k < 3; k++) {
        m[k] = a * c->x[k];
        m[4 + k] = b * c->y[k];
        m[8 + k] = c->z[k];
        m[12 + k] = c->o[k] + z * c->z[k];
    }
    m[3] = m[7] = m[11] = 0;
    m[15] = 1;
}

/* The cylinder over the local curve, as far as size to both sides. */
static ix_status over(ix_ctx *ctx, const section *c, const ix_mv *local,
                      double a, double b, ix__prim_set *s)
{
    double m[16], v[3];
    ix_mv *curve;
    ix_status st;

    matrix_of(c, a, b, -c->size, m);
    IX_TRY(ix_mv_transform(ctx, local, m, &curve));
    for (int k = 0; k < 3; k++)
        v[k] = 2.0 * c->size * c->z[k];
    st = ix_srf_extrude(ctx, curve, v, &s->srf[s->n]);
    ix_mv_unref(ctx, curve);
    IX_TRY(st);
    s->n++;
    return IX_OK;
}

/* A conic arc by its quadratic control points, homogeneous: double[4][3]. */
static ix_status arc_over(ix_ctx *ctx, const section *c, const double *pts,
                          ix__prim_set *s)
{
    const ix_dir d = {IX_BEZIER, 3, 3, false, NULL};
    ix_mv *m;
    ix_status st;

    IX_TRY(ix_mv_new(ctx, 1, &d, 3, true, pts, &m));
    st = over(ctx, c, m, 1.0, 1.0, s);
    ix_mv_unref(ctx, m);
    return st;
}

/* The branch x = a sqrt(1 + y^2 / b^2) of the hyperbola with the foci -f, f:
 * with its end (e, h) the control points (e, -h), (a^2 / e, 0), (e, h) of the
 * weights 1, e / a, 1. */
static ix_status hyperbola(ix_ctx *ctx, const section *c, double a, double f,
                           ix__prim_set *s)
{
    double b = sqrt((f - fabs(a)) * (f + fabs(a))), h = c->size,
           e = fabs(a) * hypot(1.0, h / b), side = a < 0 ? -1.0 : 1.0;
    double pts[12] = {
        fabs(a),     e, fabs(a), a * e, a * side * a, a * e, -h * fabs(a), 0,
        h * fabs(a), 0, 0,       0};

    return arc_over(ctx, c, pts, s);
}

static ix_status ellipse(ix_ctx *ctx, const section *c, double a, double f,
                         ix__prim_set *s)
{
    static const double zero[3] = {0, 0, 0};
    ix_mv *circle;
    ix_status st;

    IX_TRY(ix_circle(ctx, zero, 1.0, &circle));
    st = over(ctx, c, circle, a, sqrt((a - f) * (a + f)), s);
    ix_mv_unref(ctx, circle);
    return st;
}

/* The plane of the axes' middle, or the hyperbola, for the difference of radii
 * 2 a = r1 - r2; nothing if one circle is inside the other. */
static ix_status difference(ix_ctx *ctx, const section *c, double a, double f,
                            double tie, ix__prim_set *s)
{
    if (!(fabs(a) < f - tie))
        return IX_OK;
    if (!(fabs(a) > tie))
        return ix__prim_plane(ctx, c->o, c->x, c->size, s);
    return hyperbola(ctx, c, a, f, s);
}

/* c->o halfway between the axes; the distance of an axis from it. */
static double between(const ix_prim *a, const ix_prim *b, double size,
                      section *c)
{
    double e[3], f;

    *c = (section){.size = size};
    ix__prim_offset(a, b->pos, e);
    for (int k = 0; k < 3; k++) {
        c->o[k] = 0.5 * (a->pos[k] + b->pos[k]);
        c->z[k] = a->dir[k];
    }
    f = 0.5 * ix__unit3(e, c->x);
    if (ix__prim_touch(f, a->pos, b->pos, size)) {
        f = 0.0;
        ix__perp3(c->z, c->x);
    }
    ix__cross3(c->z, c->x, c->y);
    return f;
}

/* What lengths are known to. */
static double tie_of(const ix_prim *a, const ix_prim *b, double size)
{
    return IX__ONE_POINT * (size + ix__len3(a->pos) + ix__len3(b->pos));
}

ix_status ix__prim_parallel_axes(ix_ctx *ctx, const ix_prim *a,
                                 const ix_prim *b, double size, ix__prim_set *s)
{
    double f, half_sum = 0.5 * (a->radius + b->radius),
              half_gap = 0.5 * (a->radius - b->radius),
              tie = tie_of(a, b, size);
    section c;

    f = between(a, b, size, &c);
    if (f == 0.0 && !(fabs(half_gap) > tie))
        return IX_FAIL(ctx, IX_EDOMAIN, "both are one cylinder");
    IX_TRY(difference(ctx, &c, half_gap, f, tie, s));
    if (half_sum > f + tie)
        IX_TRY(ellipse(ctx, &c, half_sum, f, s));
    return IX_OK;
}

/* --- an axis and a plane ----------------------------------------------------
 */

/* The parabolic cylinder of the axis and the plane at the height -p below it
 * along the normal y; p = 0: the plane of axis and normal. */
static ix_status parabola(ix_ctx *ctx, const section *axis, double p,
                          ix__prim_set *s)
{
    double h = axis->size, v = -0.5 * p, e = 0.5 * h * h / p;
    /* y = x^2 / (2 p) - p / 2 by its ends and tangents */
    const double pts[12] = {1, 1, 1, -h, 0, h, v + e, v - e, v + e, 0, 0, 0};

    if (p == 0.0)
        return ix__prim_plane(ctx, axis->o, axis->x, h, s);
    return arc_over(ctx, axis, pts, s);
}

ix_status ix__prim_axis_plane(ix_ctx *ctx, const ix_prim *axis,
                              const ix_prim *plane, double size,
                              ix__prim_set *s)
{
    section c = {.size = size};
    double e[3], height, tie = tie_of(axis, plane, size);

    ix__sub3(axis->pos, plane->pos, e);
    height = ix__dot3(e, plane->dir);
    for (int k = 0; k < 3; k++) {
        c.o[k] = axis->pos[k];
        c.z[k] = axis->dir[k];
        c.y[k] = plane->dir[k];
    }
    ix__cross3(c.y, c.z, c.x);
    for (int side = 1; side >= -1; side -= 2) {
        double p = height + side * axis->radius;

        if (side < 0 && !(axis->radius > tie))
            break;
        IX_TRY(parabola(ctx, &c, fabs(p) > tie ? p : 0.0, s));
    }
    return IX_OK;
}

/* --- cones of one angle -----------------------------------------------------
 */

/* Ellipses with the foci -f, f and half axes k z: with the parameter v
 * k z = f (1 + v^2) / (1 - v^2), so that the short one is 2 f v / (1 - v^2),
 * up to the height size above c->o. */
static ix_status ellipses(ix_ctx *ctx, const section *c, double k, double f,
                          ix__prim_set *s)
{
    static const double zero[3] = {0, 0, 0};
    double top = k * c->size / f, v = sqrt((top - 1.0) / (top + 1.0)), m[16];
    /* 1 - t^2, (1 + t^2), 2 t over [0, v], Bernstein */
    const double w[3] = {1, 1, 1 - v * v}, sum[3] = {1, 1, 1 + v * v},
                 twice[3] = {0, v, 2 * v};
    const ix_dir line = {IX_BEZIER, 3, 3, false, NULL};
    double *pts;
    ix_dir d[2];
    ix_mv *circle, *local;
    ix_status st;
    size_t n;

    IX_TRY(ix_circle(ctx, zero, 1.0, &circle));
    d[0] = ix_mv_dir(circle, 0);
    d[1] = line;
    n = ix_mv_npts(circle);
    pts = ix__scratch(ctx, 12 * n, sizeof *pts);
    for (size_t i = 0; pts && i < 3 * n; i++) {
        size_t j = i / n;
        double cw = ix_mv_weights(circle)[i % n];

        pts[i] = w[j] * cw;
        pts[3 * n + i] = f * sum[j] * ix_mv_coord(circle, 0)[i % n];
        pts[6 * n + i] = f * twice[j] * ix_mv_coord(circle, 1)[i % n];
        pts[9 * n + i] = f / k * sum[j] * cw;
    }
    st = pts ? ix_mv_new(ctx, 2, d, 3, true, pts, &local) : IX_ENOMEM;
    ix_mv_unref(ctx, circle);
    IX_TRY(st);
    matrix_of(c, 1.0, 1.0, 0.0, m);
    st = ix_mv_transform(ctx, local, m, &s->srf[s->n]);
    ix_mv_unref(ctx, local);
    IX_TRY(st);
    s->n++;
    return IX_OK;
}

ix_status ix__prim_equal_cones(ix_ctx *ctx, const ix_prim *a, const ix_prim *b,
                               double size, ix__prim_set *s)
{
    double f, k = tan(IX__RADIANS(a->degrees)), e[3], tie = tie_of(a, b, size);
    section c;

    f = between(a, b, size, &c);
    ix__sub3(b->pos, a->pos, e);
    /* r1 - r2 = k (z1 - z2), z_i the heights above both */
    IX_TRY(difference(ctx, &c, 0.5 * k * ix__dot3(e, a->dir), f, tie, s));
    if (k * size > f + tie)
        IX_TRY(ellipses(ctx, &c, k, f, s));
    if (s->n == 0)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "one cone is inside the other up to the height %g: a "
                       "larger size is needed",
                       size);
    return IX_OK;
}
