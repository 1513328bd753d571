/* analytic.c - distances and intersections of points, lines, planes, circles.
 * Differences are formed first, so that results do not lose digits far from
 * the origin. */
#include "geom/analytic.h"

#include <float.h>
#include <string.h>

#include "geom/vec3.h"

/* Sine of the angle below which unit directions are parallel. */
static const double PARALLEL = 1e-14;

ix_status ix__line_foot(ix_ctx *ctx, const double p[3], const double at[3],
                        const double dir[3], double out[3])
{
    double u[3], d[3];

    IX_TRY(ix__direction(ctx, "line direction", dir, u));
    ix__sub3(p, at, d);
    ix__axpy3(at, ix__dot3(d, u), u, out);
    return IX_OK;
}

ix_status ix__line_dist(ix_ctx *ctx, const double p[3], const double at[3],
                        const double dir[3], double *out)
{
    double u[3], d[3], c[3];

    IX_TRY(ix__direction(ctx, "line direction", dir, u));
    ix__sub3(p, at, d);
    ix__cross3(d, u, c);
    *out = ix__len3(c);
    return IX_OK;
}

ix_status ix__plane_dist(ix_ctx *ctx, const double p[3], const double plane[4],
                         double *out)
{
    double n[3];

    IX_TRY(ix__direction(ctx, "plane normal", plane, n));
    *out = fabs(ix__dot3(n, p) + plane[3] / ix__len3(plane));
    return IX_OK;
}

ix_status ix__line_plane(ix_ctx *ctx, const double at[3], const double dir[3],
                         const double plane[4], double out[3])
{
    double n[3], u[3], h, c;

    IX_TRY(ix__direction(ctx, "plane normal", plane, n));
    IX_TRY(ix__direction(ctx, "line direction", dir, u));
    h = ix__dot3(n, at) + plane[3] / ix__len3(plane);
    c = ix__dot3(n, u);
    if (!(fabs(c) >= PARALLEL))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the line is parallel to the plane, at distance %g",
                       fabs(h));
    ix__axpy3(at, -h / c, u, out);
    return IX_OK;
}

ix_status ix__lines_near(ix_ctx *ctx, const double a[3], const double da[3],
                         const double b[3], const double db[3], double on_a[3],
                         double on_b[3])
{
    double u[3], v[3], n[3], d[3], x[3], y[3], s, ta;

    IX_TRY(ix__direction(ctx, "line direction", da, u));
    IX_TRY(ix__direction(ctx, "line direction", db, v));
    ix__cross3(u, v, n);
    ix__sub3(b, a, d);
    s = ix__dot3(n, n);
    /* ta u - tb v + h n = d, solved by Cramer; then on_b is on_a's foot. */
    ix__cross3(d, v, x);
    ta = sqrt(s) >= PARALLEL ? ix__dot3(x, n) / s : 0;
    ix__axpy3(a, ta, u, y);
    ix__sub3(y, b, d);
    ix__axpy3(b, ix__dot3(d, v), v, on_b);
    memcpy(on_a, y, sizeof y);
    return IX_OK;
}

/* Edges from p[0] and their normal; false if its length is only rounding. */
static bool triangle_normal(const double p[3][3], double e[3], double f[3],
                            double n[3])
{
    ix__sub3(p[1], p[0], e);
    ix__sub3(p[2], p[0], f);
    ix__cross3(e, f, n);
    return ix__len3(n) > 8 * DBL_EPSILON * ix__len3(e) * ix__len3(f);
}

ix_status ix__plane_through(ix_ctx *ctx, const double p[3][3], double plane[4])
{
    double e[3], f[3], n[3];

    if (!triangle_normal(p, e, f, n))
        return IX_FAIL(ctx, IX_EDOMAIN, "the three points are on one line");
    ix__unit3(n, plane);
    plane[3] = 0 - ix__dot3(plane, p[0]);
    return IX_OK;
}

ix_status ix__barycentric(ix_ctx *ctx, const double p[3][3], const double q[3],
                          double out[3])
{
    double e[3], f[3], n[3], d[3], c[3], s;

    if (!triangle_normal(p, e, f, n))
        return IX_FAIL(ctx, IX_EDOMAIN, "the three points are on one line");
    ix__sub3(q, p[0], d);
    s = ix__dot3(n, n);
    ix__cross3(d, f, c);
    out[1] = ix__dot3(c, n) / s;
    ix__cross3(e, d, c);
    out[2] = ix__dot3(c, n) / s;
    out[0] = 1 - out[1] - out[2];
    return IX_OK;
}

/* In the plane of both, with unit normal n: centres at distance |d| > 0. */
static void planar_circles(const ix__circle3 *a, const ix__circle3 *b,
                           const double n[3], double tol, int *count,
                           double out[2][3])
{
    double u[3], v[3], d[3], len, x, h2, h, mid[3];

    ix__sub3(b->centre, a->centre, d);
    len = ix__unit3(d, u);
    ix__cross3(n, u, v);
    x = (len + (a->radius - b->radius) * (a->radius + b->radius) / len) / 2;
    h2 = (a->radius - x) * (a->radius + x);
    h = sqrt(fmax(h2, 0));
    ix__axpy3(a->centre, x, u, mid);
    ix__axpy3(mid, h, v, out[0]);
    ix__axpy3(mid, -h, v, out[1]);
    if (fabs(len - (a->radius + b->radius)) <= tol ||
        fabs(len - fabs(a->radius - b->radius)) <= tol)
        *count = 1; /* they touch */
    else
        *count = h2 > 0 ? 2 : 0;
    if (*count == 1) /* h is the root of rounding there: leave it out */
        ix__axpy3(a->centre, x > 0 ? a->radius : -a->radius, u, out[0]);
}

/* Points of a on the line (at, u) of both planes that lie on b, too. */
static void line_circles(const ix__circle3 *a, const ix__circle3 *b,
                         const double at[3], const double u[3], double tol,
                         int *count, double out[2][3])
{
    double d[3], foot[3], dist, h2;

    *count = 0;
    ix__sub3(a->centre, at, d);
    ix__axpy3(at, ix__dot3(d, u), u, foot);
    dist = ix__dist3(foot, a->centre);
    h2 = (a->radius - dist) * (a->radius + dist);
    if (dist > a->radius + tol)
        return;
    for (int k = 0; k < 2; k++) {
        double p[3], h = dist > a->radius - tol ? 0 : sqrt(fmax(h2, 0));

        if (k == 1 && h == 0)
            break;
        ix__axpy3(foot, k ? -h : h, u, p);
        if (fabs(ix__dist3(p, b->centre) - b->radius) <= tol)
            memcpy(out[(*count)++], p, sizeof p);
    }
}

static ix_status check_circle(ix_ctx *ctx, const ix__circle3 *c, double n[3])
{
    IX_TRY(ix__direction(ctx, "circle normal", c->normal, n));
    if (!(c->radius > 0) || !isfinite(c->radius))
        return IX_FAIL(ctx, IX_EARG, "radius %g is not positive", c->radius);
    return IX_OK;
}

ix_status ix__circles_meet(ix_ctx *ctx, const ix__circle3 *a,
                           const ix__circle3 *b, double tol, int *n,
                           double out[2][3])
{
    double na[3], nb[3], u[3], d[3], at[3], v[3], h, dist;

    IX_TRY(check_circle(ctx, a, na));
    IX_TRY(check_circle(ctx, b, nb));
    ix__cross3(na, nb, u);
    ix__sub3(b->centre, a->centre, d);
    dist = ix__len3(d);
    *n = 0;
    if (ix__len3(u) < PARALLEL) {
        if (!(fabs(ix__dot3(d, na)) <= tol))
            return IX_OK;
        if (dist <= tol && fabs(a->radius - b->radius) <= tol)
            return IX_FAIL(ctx, IX_EDOMAIN, "the two circles are one");
        if (dist > tol)
            planar_circles(a, b, na, tol, n, out);
        return IX_OK;
    }
    ix__unit3(u, u);
    ix__cross3(u, na, v); /* in a's plane, across the common line */
    h = ix__dot3(d, nb) / ix__dot3(v, nb);
    ix__axpy3(a->centre, h, v, at);
    line_circles(a, b, at, u, tol, n, out);
    return IX_OK;
}

ix_status ix__circles_tangents(ix_ctx *ctx, const double ca[3], double ra,
                               const double cb[3], double rb, bool outer,
                               double out[2][2][3])
{
    double dx = cb[0] - ca[0], dy = cb[1] - ca[1], d = hypot(dx, dy);
    double sign = outer ? 1 : -1, need = fabs(ra - sign * rb);
    double c, s;

    if (!(ra >= 0) || !(rb >= 0) || !isfinite(d))
        return IX_FAIL(ctx, IX_EARG, "radii %g and %g at distance %g", ra, rb,
                       d);
    if (!(d > need))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "no two %s tangents: the centres are %g apart, they "
                       "would have to be more than %g",
                       outer ? "outer" : "inner", d, need);
    c = (ra - sign * rb) / d; /* of the angle between the way and a's radius */
    s = sqrt((1 - c) * (1 + c));
    for (int k = 0; k < 2; k++, s = -s) {
        double nx = (dx * c - dy * s) / d, ny = (dy * c + dx * s) / d;

        out[k][0][0] = ca[0] + ra * nx;
        out[k][0][1] = ca[1] + ra * ny;
        out[k][0][2] = ca[2];
        out[k][1][0] = cb[0] + sign * rb * nx;
        out[k][1][1] = cb[1] + sign * rb * ny;
        out[k][1][2] = cb[2];
    }
    return IX_OK;
}
