/* prim_bisector.c - the bisector of two primitives: which reduction serves.
 *
 * Points at the distance h from a primitive are h - r from it grown by r. With
 * signed growth the second primitive becomes a point, a line or a cone with the
 * apex of the first; the sign depends on whether one is inside the other. */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "geom/angle.h"
#include "geom/crvs.h"
#include "geom/vec3.h"
#include "ops/prim.h"
#include "ops/report.h"

typedef struct {
    ix_prim a, b; /* a.kind >= b.kind; directions of length 1 */
    double size;
    bool irit;
    ix_op_opts opts;
    ix_crvs *out;
} task;

/* --- results ---------------------------------------------------------------
 */

/* Takes over n surfaces, in the lowest degrees. */
static ix_status deliver(ix_ctx *ctx, task *k, int n, ix_mv *const *s)
{
    ix_status st = ix__crvs_new(ctx, n, k->out);

    for (int i = 0; i < n; i++) {
        if (st == IX_OK)
            st = ix_sym_reduce(ctx, s[i], 0.0, NULL, &k->out->crv[i]);
        if (st == IX_OK)
            ix_mv_domain(k->out->crv[i], 0, k->out->t + 2 * i);
        ix_mv_unref(ctx, s[i]);
    }
    if (st != IX_OK)
        ix_crvs_free(ctx, k->out);
    return st;
}

/* Takes over the surfaces of a special position. */
static ix_status deliver_set(ix_ctx *ctx, task *k, ix__prim_set *s,
                             ix_status st)
{
    if (st == IX_OK)
        return deliver(ctx, k, s->n, s->srf);
    for (int i = 0; i < s->n; i++)
        ix_mv_unref(ctx, s->srf[i]);
    return st;
}

/* --- a point ----------------------------------------------------------------
 */

/* The plane halfway between two points. */
static ix_status two_points(ix_ctx *ctx, task *k, const double q[3])
{
    ix_prim p = {.kind = IX_PRIM_PLANE};
    ix_mv *s;

    for (int i = 0; i < 3; i++) {
        p.pos[i] = 0.5 * (k->a.pos[i] + q[i]);
        p.dir[i] = q[i] - k->a.pos[i];
    }
    if (!(ix__len3(p.dir) > 0))
        return IX_FAIL(ctx, IX_EDOMAIN, "both are one point");
    IX_TRY(ix__prim_surface(ctx, &p, k->size, &s));
    return deliver(ctx, k, 1, &s);
}

static ix_status line_segment(ix_ctx *ctx, const ix_prim *p, double size,
                              ix_mv **out)
{
    const ix_dir d = {IX_BEZIER, 2, 2, false, NULL};
    double pts[6];

    for (int i = 0; i < 3; i++) {
        pts[2 * i] = p->pos[i] - size * p->dir[i];
        pts[2 * i + 1] = p->pos[i] + size * p->dir[i];
    }
    return ix_mv_new(ctx, 1, &d, 3, false, pts, out);
}

static ix_status circle_of(ix_ctx *ctx, const ix_prim *p, ix_mv **out)
{
    static const double zero[3] = {0, 0, 0};
    double m[16] = {0};
    ix_prim_axes e;
    ix_mv *c;
    ix_status st;

    IX_TRY(ix__prim_axes(ctx, p, &e));
    for (int i = 0; i < 3; i++) {
        m[i] = e.x[i];
        m[4 + i] = e.y[i];
        m[8 + i] = e.z[i];
        m[12 + i] = p->pos[i];
    }
    m[15] = 1;
    IX_TRY(ix_circle(ctx, zero, p->major, &c));
    st = ix_mv_transform(ctx, c, m, out);
    ix_mv_unref(ctx, c);
    return st;
}

/* The axis of a line or cylinder, the circle inside a torus. */
static ix_status spine_of(ix_ctx *ctx, const ix_prim *p, double size,
                          ix_mv **out)
{
    return p->kind == IX_PRIM_TORUS ? circle_of(ctx, p, out)
                                    : line_segment(ctx, p, size, out);
}

/* A line, or the circle that a torus of minor radius 0 is, and a point. */
static ix_status curve_point(ix_ctx *ctx, task *k, const ix_prim *p,
                             const double q[3])
{
    ix_ruling r = {IX_RULING_PLANES, {-k->size, k->size}, {0, 0, 0}};
    ix__prim_set set = {.n = 0};
    ix_mv *c, *s;
    ix_status st;

    if (p->kind != IX_PRIM_TORUS)
        IX_TRY(ix__prim_line_point(ctx, p, q, k->size, &set));
    if (set.n > 0)
        return deliver_set(ctx, k, &set, IX_OK);
    IX_TRY(spine_of(ctx, p, k->size, &c));
    st = ix_pt_crv_bisector3d(ctx, c, q, 0.5, &r, NULL, NULL, &s);
    ix_mv_unref(ctx, c);
    IX_TRY(st);
    return deliver(ctx, k, 1, &s);
}

/* The primitive p, grown or shrunk, and a point. */
static ix_status with_point(ix_ctx *ctx, task *k, const ix_prim *p,
                            const double q[3])
{
    ix_mv *srf, *s;
    ix_status st;

    if (p->kind == IX_PRIM_POINT ||
        (p->kind == IX_PRIM_SPHERE && p->radius == 0.0))
        return two_points(ctx, k, q);
    if (p->kind == IX_PRIM_LINE ||
        (p->radius == 0.0 &&
         (p->kind == IX_PRIM_CYLINDER || p->kind == IX_PRIM_TORUS)))
        return curve_point(ctx, k, p, q);
    IX_TRY(ix__prim_surface(ctx, p, k->size, &srf));
    st = ix_pt_srf_bisector(ctx, srf, q, &k->opts, NULL, &s);
    ix_mv_unref(ctx, srf);
    IX_TRY(st);
    return deliver(ctx, k, 1, &s);
}

/* --- a sphere ---------------------------------------------------------------
 */

/* Distance of q from the axis, and along it. */
static double off_axis(const ix_prim *p, const double q[3], double *along)
{
    double r[3];

    ix__sub3(q, p->pos, r);
    *along = ix__dot3(r, p->dir);
    ix__axpy3(r, -*along, p->dir, r);
    return ix__len3(r);
}

/* True if q is inside the closed surface, or where the cone opens. */
static bool inside(const ix_prim *p, const double q[3])
{
    double z, rho = off_axis(p, q, &z);

    switch (p->kind) {
    case IX_PRIM_SPHERE:
        return ix__dist3(q, p->pos) < p->radius;
    case IX_PRIM_CYLINDER:
        return rho < p->radius;
    case IX_PRIM_CONE:
        return z > 0 && rho < z * tan(IX__RADIANS(p->degrees));
    default:
        return hypot(rho - p->major, z) < p->radius;
    }
}

/* a and a sphere: a becomes so much larger or smaller that the sphere is a
 * point. Of spheres the smaller one shrinks to a point. */
static ix_status with_sphere(ix_ctx *ctx, task *k)
{
    double r = k->b.radius, z, s;
    ix_prim p = k->a;
    bool in = k->irit ? p.kind != IX_PRIM_SPHERE : inside(&p, k->b.pos);

    switch (p.kind) {
    case IX_PRIM_PLANE:
        (void)off_axis(&p, k->b.pos, &z);
        ix__axpy3(p.pos, z < 0 ? r : -r, p.dir, p.pos);
        break;
    case IX_PRIM_LINE:
        p.kind = IX_PRIM_CYLINDER;
        p.radius = r;
        break;
    case IX_PRIM_CONE:
        s = r / sin(IX__RADIANS(p.degrees));
        ix__axpy3(p.pos, in ? -s : s, p.dir, p.pos);
        break;
    default:
        p.radius = in ? p.radius + r : fabs(p.radius - r);
    }
    return with_point(ctx, k, &p, k->b.pos);
}

/* --- one apex ---------------------------------------------------------------
 */

static ix_status apex_pair(ix_ctx *ctx, task *k, const double apex[3],
                           const double n[3], double degrees, const double u[3])
{
    ix_mv *s[2];

    IX_TRY(ix__prim_apex(ctx, apex, n, degrees, u, k->size, s));
    return deliver(ctx, k, 2, s);
}

static double angle_between(const double a[3], const double b[3])
{
    double c[3];

    ix__cross3(a, b, c);
    return IX__DEG(atan2(ix__len3(c), ix__dot3(a, b)));
}

/* The plane between the axes of cones with one apex and one angle. */
static ix_status equal_cones(ix_ctx *ctx, task *k)
{
    ix_prim p = {.kind = IX_PRIM_PLANE};
    ix_mv *s;

    ix__axpy3(k->a.pos, 0.0, k->a.dir, p.pos);
    ix__sub3(k->a.dir, k->b.dir, p.dir);
    IX_TRY(ix__prim_surface(ctx, &p, k->size, &s));
    return deliver(ctx, k, 1, &s);
}

/* Cones with one apex: the narrower one shrinks to its axis. */
static ix_status cone_cone(ix_ctx *ctx, task *k)
{
    const ix_prim *a = &k->a, *b = &k->b;
    double apart = angle_between(a->dir, b->dir);
    bool in = apart < fmax(a->degrees, b->degrees) && !k->irit;
    double angle = in ? a->degrees + b->degrees : fabs(a->degrees - b->degrees);

    if (a->degrees < b->degrees) {
        a = &k->b;
        b = &k->a;
    }
    if (a->degrees == b->degrees && !(apart > 1e-12))
        return IX_FAIL(ctx, IX_EDOMAIN, "both are one cone");
    return angle == 0.0 ? equal_cones(ctx, k)
                        : apex_pair(ctx, k, a->pos, a->dir, angle, b->dir);
}

/* The plane and a line that meets it. */
static ix_status plane_line(ix_ctx *ctx, task *k, const ix_prim *plane,
                            const ix_prim *line)
{
    double r[3], apex[3], slope = ix__dot3(plane->dir, line->dir);

    ix__sub3(plane->pos, line->pos, r);
    ix__axpy3(line->pos, ix__dot3(r, plane->dir) / slope, line->dir, apex);
    return apex_pair(ctx, k, apex, plane->dir, 90.0, line->dir);
}

/* The plane and a line or cylinder parallel to it. */
static ix_status plane_axis(ix_ctx *ctx, task *k, const ix_prim *plane,
                            const ix_prim *axis)
{
    ix__prim_set s = {.n = 0};

    return deliver_set(ctx, k, &s,
                       ix__prim_axis_plane(ctx, axis, plane, k->size, &s));
}

static bool along(const ix_prim *plane, const ix_prim *axis)
{
    return !(fabs(ix__dot3(plane->dir, axis->dir)) > IX__PARALLEL);
}

/* A plane parallel to a ruling of the cone: with m = n + sin(a) e, at a right
 * angle to the axis e and of the length cos(a), the distance of the axis is
 * that of a plane with the normal m. */
static ix_status plane_ruling(ix_ctx *ctx, task *k, const ix_prim *plane,
                              const ix_prim *cone)
{
    double a = IX__RADIANS(cone->degrees), e[3], h;
    ix_prim axis = {.kind = IX_PRIM_LINE}, other = {.kind = IX_PRIM_PLANE};

    ix__sub3(plane->pos, cone->pos, e);
    h = ix__dot3(e, plane->dir);
    ix__axpy3(plane->dir, sin(a), cone->dir, other.dir);
    ix__axpy3(cone->pos, h / ix__dot3(other.dir, other.dir), other.dir,
              other.pos);
    (void)ix__unit3(other.dir, other.dir);
    memcpy(axis.pos, cone->pos, sizeof axis.pos);
    memcpy(axis.dir, cone->dir, sizeof axis.dir);
    return plane_axis(ctx, k, &other, &axis);
}

/* Plane and cone are moved inwards alike until the apex is in the plane; with
 * the plane as the cone of 90 degrees around its normal, angles add up. */
static ix_status plane_cone(ix_ctx *ctx, task *k, const ix_prim *plane,
                            const ix_prim *cone)
{
    double s = sin(IX__RADIANS(cone->degrees)), z, slope, apex[3];

    (void)off_axis(plane, cone->pos, &z);
    slope = 1.0 + ix__dot3(plane->dir, cone->dir) / s;
    if (!(fabs(slope) > IX__PARALLEL))
        return plane_ruling(ctx, k, plane, cone);
    ix__axpy3(cone->pos, -z / slope / s, cone->dir, apex);
    return apex_pair(ctx, k, apex, plane->dir, 90.0 + cone->degrees, cone->dir);
}

/* Plane and cylinder are moved likewise, until the cylinder is its axis. */
static ix_status plane_cylinder(ix_ctx *ctx, task *k, const ix_prim *plane,
                                const ix_prim *cyl)
{
    ix_prim p = *plane;

    ix__axpy3(p.pos, -cyl->radius, p.dir, p.pos);
    return plane_line(ctx, k, &p, cyl);
}

/* Positive on the outside, or where the normal points. */
static double signed_distance(const ix_prim *p, const double x[3])
{
    double z, rho = off_axis(p, x, &z), a = IX__RADIANS(p->degrees);

    return p->kind == IX_PRIM_PLANE  ? z
           : p->kind == IX_PRIM_CONE ? rho * cos(a) - z * sin(a)
                                     : rho - p->radius;
}

/* Of both nappes in k->out the one on which the signed distances are equal: on
 * the other one their sum is 0. */
static ix_status pick_nappe(ix_ctx *ctx, const ix_crvs *s, const ix_prim *a,
                            const ix_prim *b, ix_mv **out)
{
    double best = HUGE_VAL;

    for (int i = 0; i < s->n; i++) {
        double uv[2] = {s->t[0] + 0.37, 1.0}, x[3], gap;

        if (s->n > 1)
            IX_TRY(ix_mv_point(ctx, s->crv[i], uv, x));
        gap = s->n > 1 ? fabs(signed_distance(a, x) - signed_distance(b, x))
                       : 0.0;
        if (!(gap < best))
            continue;
        best = gap;
        *out = s->crv[i];
    }
    *out = ix_mv_ref(*out);
    return IX_OK;
}

/* What is on the side of the plane to which its normal points, and outside of
 * b, or on the other side and inside. */
static ix_status one_side(ix_ctx *ctx, const task *k, const ix_prim *plane,
                          const ix_prim *b, ix_mv **out)
{
    ix_crvs both = {0};
    task own = *k;
    ix_status st;

    own.out = &both;
    st = b->kind == IX_PRIM_CYLINDER ? plane_cylinder(ctx, &own, plane, b)
                                     : plane_cone(ctx, &own, plane, b);
    if (st == IX_OK)
        st = pick_nappe(ctx, &both, plane, b, out);
    ix_crvs_free(ctx, &both);
    return st;
}

/* A plane and a cylinder or cone: one surface for each side of the plane.
 * IRIT's cones have both nappes of one side. */
static ix_status with_plane(ix_ctx *ctx, task *k)
{
    ix_prim plane = k->b;
    ix_mv *s[2] = {NULL, NULL};
    ix_status st = IX_OK;

    if (k->a.kind == IX_PRIM_CYLINDER && along(&plane, &k->a))
        return plane_axis(ctx, k, &plane, &k->a);
    if (k->a.kind == IX_PRIM_CONE && k->irit)
        return plane_cone(ctx, k, &plane, &k->a);
    for (int i = 0; i < 2 && st == IX_OK; i++) {
        st = one_side(ctx, k, &plane, &k->a, &s[i]);
        for (int j = 0; j < 3; j++)
            plane.dir[j] = -plane.dir[j];
    }
    if (st == IX_OK)
        return deliver(ctx, k, 2, s);
    ix_mv_unref(ctx, s[0]);
    return st;
}

static ix_status planes(ix_ctx *ctx, task *k)
{
    ix__prim_set s = {.n = 0};

    return deliver_set(ctx, k, &s,
                       ix__prim_two_planes(ctx, &k->a, &k->b, k->size, &s));
}

/* --- which ------------------------------------------------------------------
 */

/* Two curves, of which a and b are canal surfaces of one radius. */
static ix_status spines(ix_ctx *ctx, task *k)
{
    ix_mv *c[2] = {NULL, NULL}, *s = NULL;
    ix_status st = spine_of(ctx, &k->a, k->size, &c[0]);

    if (st == IX_OK)
        st = spine_of(ctx, &k->b, k->size, &c[1]);
    if (st == IX_OK)
        st = ix_cbisector3d(ctx, c[0], c[1], &k->opts, NULL, &s);
    ix_mv_unref(ctx, c[0]);
    ix_mv_unref(ctx, c[1]);
    return st == IX_OK ? deliver(ctx, k, 1, &s) : st;
}

static ix_status lines(ix_ctx *ctx, task *k)
{
    ix__prim_set s = {.n = 0};
    ix_status st = ix__prim_flat_lines(ctx, &k->a, &k->b, k->size, &s);

    return st == IX_OK && s.n == 0 ? spines(ctx, k)
                                   : deliver_set(ctx, k, &s, st);
}

/* What turns around the axis of the torus: conics of the half plane. */
static ix_status around_torus(ix_ctx *ctx, task *k)
{
    ix__prim_set s = {.n = 0};
    ix_status st;

    if (k->b.kind == IX_PRIM_TORUS)
        st = ix__prim_coaxial_tori(ctx, &k->a, &k->b, k->size, &s);
    else
        st = ix__prim_torus_line(ctx, &k->a, &k->b, k->size, &s);
    return deliver_set(ctx, k, &s, st);
}

static ix_status torus_plane(ix_ctx *ctx, task *k)
{
    ix__prim_set s = {.n = 0};

    if (ix__prim_parallel(k->a.dir, k->b.dir))
        return around_torus(ctx, k);
    return deliver_set(ctx, k, &s,
                       ix__prim_torus_plane(ctx, &k->a, &k->b, k->size, &s));
}

/* A torus, and a line, cylinder or torus: spheres of one radius roll along
 * both spines. */
static ix_status with_torus(ix_ctx *ctx, task *k)
{
    double gap = fabs(k->a.radius - k->b.radius);

    if (k->b.kind == IX_PRIM_PLANE)
        return torus_plane(ctx, k);
    if (ix__prim_is_coaxial(&k->a, &k->b, k->size))
        return around_torus(ctx, k);
    if (k->b.kind == IX_PRIM_CONE)
        return IX_FAIL(ctx, IX_EARG,
                       "a torus and a cone are offered around one axis only");
    if (!(gap <= IX__ONE_POINT * k->size))
        return IX_FAIL(ctx, IX_EARG,
                       "radii of %g and %g: of a torus and a line, cylinder or "
                       "torus only those of one radius, or around one axis, "
                       "have a rational bisector",
                       k->a.radius, k->b.radius);
    return spines(ctx, k);
}

/* Lines (cylinders of radius 0), cylinders and cones. Cylinders of one radius
 * have the bisector of their axes. */
static ix_status axes(ix_ctx *ctx, task *k)
{
    const ix_prim *a = &k->a, *b = &k->b;
    bool cones = a->kind == IX_PRIM_CONE && b->kind == IX_PRIM_CONE,
         parallel = ix__prim_parallel(a->dir, b->dir);
    ix__prim_set s = {.n = 0};
    ix_status st;

    if (a->kind == IX_PRIM_CYLINDER && !parallel && !k->irit &&
        fabs(a->radius - b->radius) <= IX__ONE_POINT * k->size)
        return lines(ctx, k);
    if (a->kind != IX_PRIM_CONE && parallel)
        st = ix__prim_parallel_axes(ctx, a, b, k->size, &s);
    else if (ix__prim_is_coaxial(a, b, k->size))
        st = ix__prim_coaxial(ctx, a, b, k->size, &s);
    else if (cones && parallel && ix__dot3(a->dir, b->dir) > 0 &&
             !(fabs(a->degrees - b->degrees) > IX__DEG(IX__PARALLEL)))
        st = ix__prim_equal_cones(ctx, a, b, k->size, &s);
    else {
        st = ix__prim_tangents(ctx, a, b, &s.srf[0]);
        s.n = st == IX_OK;
    }
    return deliver_set(ctx, k, &s, st);
}

static ix_status with_line(ix_ctx *ctx, task *k)
{
    double z;

    if (k->a.kind == IX_PRIM_LINE)
        return lines(ctx, k);
    if (k->a.kind == IX_PRIM_PLANE && along(&k->a, &k->b))
        return plane_axis(ctx, k, &k->a, &k->b);
    if (k->a.kind == IX_PRIM_PLANE)
        return plane_line(ctx, k, &k->a, &k->b);
    if (k->a.kind == IX_PRIM_CONE &&
        ix__prim_touch(off_axis(&k->b, k->a.pos, &z), k->a.pos, k->b.pos,
                       k->size))
        return apex_pair(ctx, k, k->a.pos, k->a.dir, k->a.degrees, k->b.dir);
    return axes(ctx, k);
}

/* a is not of a lower rank than b. */
static ix_status reduce(ix_ctx *ctx, task *k)
{
    if (k->b.kind == IX_PRIM_POINT)
        return with_point(ctx, k, &k->a, k->b.pos);
    if (k->b.kind == IX_PRIM_SPHERE)
        return with_sphere(ctx, k);
    if (k->a.kind == IX_PRIM_TORUS)
        return with_torus(ctx, k);
    if (k->b.kind == IX_PRIM_LINE)
        return with_line(ctx, k);
    if (k->a.kind == IX_PRIM_PLANE)
        return planes(ctx, k);
    if (k->b.kind == IX_PRIM_PLANE)
        return with_plane(ctx, k);
    if (k->a.kind == IX_PRIM_CONE && k->b.kind == IX_PRIM_CONE &&
        ix__prim_touch(ix__dist3(k->a.pos, k->b.pos), k->a.pos, k->b.pos,
                       k->size))
        return cone_cone(ctx, k);
    return axes(ctx, k);
}

/* --- entry ------------------------------------------------------------------
 */

static ix_status check_prim(ix_ctx *ctx, ix_prim *p)
{
    if (p->kind < IX_PRIM_POINT || p->kind > IX_PRIM_TORUS)
        return IX_FAIL(ctx, IX_EARG, "primitive %d is not in 0 .. 6",
                       (int)p->kind);
    if (!isfinite(p->pos[0] + p->pos[1] + p->pos[2]))
        return IX_FAIL(ctx, IX_EARG, "position (%g, %g, %g) is not finite",
                       p->pos[0], p->pos[1], p->pos[2]);
    if (p->kind != IX_PRIM_POINT && p->kind != IX_PRIM_SPHERE)
        IX_TRY(ix__direction(ctx, "the direction", p->dir, p->dir));
    if (p->kind == IX_PRIM_LINE)
        p->radius = 0.0;
    if ((p->kind >= IX_PRIM_SPHERE && p->kind != IX_PRIM_CONE) &&
        (!(p->radius >= 0.0) || !isfinite(p->radius)))
        return IX_FAIL(ctx, IX_EARG,
                       "a radius of %g; it must be finite and not negative",
                       p->radius);
    if (p->kind == IX_PRIM_TORUS && (!(p->major > 0.0) || !isfinite(p->major)))
        return IX_FAIL(ctx, IX_EARG,
                       "a major radius of %g; it must be positive", p->major);
    if (p->kind == IX_PRIM_CONE && !(p->degrees > 0.0 && p->degrees < 90.0))
        return IX_FAIL(ctx, IX_EARG,
                       "an angle of %g degrees is not between 0 and 90",
                       p->degrees);
    return IX_OK;
}

/* The order of reduction: what becomes a point or a line goes last. */
static bool goes_last(const ix_prim *p, const ix_prim *than)
{
    static const int rank[] = {
        [IX_PRIM_POINT] = 0, [IX_PRIM_SPHERE] = 1,   [IX_PRIM_LINE] = 2,
        [IX_PRIM_PLANE] = 3, [IX_PRIM_CYLINDER] = 4, [IX_PRIM_CONE] = 5,
        [IX_PRIM_TORUS] = 6};

    if (p->kind == IX_PRIM_SPHERE && than->kind == IX_PRIM_SPHERE)
        return p->radius < than->radius;
    return rank[p->kind] < rank[than->kind];
}

ix_status ix_prim_bisector(ix_ctx *ctx, const ix_prim *a, const ix_prim *b,
                           double size, const ix_op_opts *o, ix_crvs *out)
{
    task k = {.size = size, .out = out};
    ix_degree_form form;

    *out = (ix_crvs){.n = 0};
    IX_TRY(ix__form_of_opts(ctx, o, &form));
    if (!(size > 0.0) || !isfinite(size))
        return IX_FAIL(ctx, IX_EARG, "a size of %g; it must be positive", size);
    k.a = *a;
    k.b = *b;
    IX_TRY(check_prim(ctx, &k.a));
    IX_TRY(check_prim(ctx, &k.b));
    if (goes_last(&k.a, &k.b)) {
        ix_prim first = k.b;

        k.b = k.a;
        k.a = first;
    }
    k.irit = form == IX_FORM_IRIT;
    k.opts = (ix_op_opts){IX_FORM_MINIMAL, o ? o->max_cont : INT_MAX};
    IX_RETURN_SCOPED(ctx, reduce(ctx, &k));
}
