/* arc.c - circular arcs as rational quadratics: end points with weight 1,
 * between them the meeting point of the end tangents with weight cos(a/2). */
#include "geom/angle.h"
#include "geom/circle.h"

#include <math.h>

#include "geom/matrix.h"
#include "geom/vec3.h"

ix_status ix_arc(ix_ctx *ctx, const double start[3], const double center[3],
                 const double end[3], ix_mv **out)
{
    const ix_dir dir = {.basis = IX_BEZIER, .order = 3, .length = 3};
    double u[3], v[3], un[3] = {0}, vn[3] = {0}, sum[3], diff[3], c, s,
                       pts[4][3];

    *out = NULL;
    ix__sub3(start, center, u);
    ix__sub3(end, center, v);
    if (!(ix__unit3(u, un) > 0) || !(ix__unit3(v, vn) > 0))
        return IX_FAIL(ctx, IX_EARG, "an end of the arc is its center");
    if (!(isfinite(ix__len3(u)) && isfinite(ix__len3(v))))
        return IX_FAIL(ctx, IX_EARG, "points that are not finite");
    for (int i = 0; i < 3; i++) {
        sum[i] = (un[i] + vn[i]) / 2;
        diff[i] = (un[i] - vn[i]) / 2;
    }
    c = ix__len3(sum); /* cosine and sine of half the angle */
    s = ix__len3(diff);
    /* 1e-8: there the plane, or the side, comes from rounding alone */
    if (!(c > 1e-8) || !(s > 1e-8))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "start, center and end on one line: angle of %g degrees",
                       IX__DEG(2 * atan2(s, c)));
    pts[0][0] = pts[0][2] = 1;
    pts[0][1] = c;
    for (int i = 0; i < 3; i++) {
        pts[i + 1][0] = start[i];
        pts[i + 1][1] = c * center[i] + (u[i] + v[i]) / (2 * c);
        pts[i + 1][2] = end[i];
    }
    return ix_mv_new(ctx, 1, &dir, 3, true, pts[0], out);
}

/* Fills the points of n equal spans that turn by sweep degrees together. */
static void arc_points(const double center[3], double radius, double a0,
                       double sweep, int n, double *pts)
{
    int np = 2 * n + 1;
    double half = sweep / (2 * n), c, s, ca, sa;

    ix__sincos_deg(half, &s, &c);
    for (int i = 0; i < np; i++) {
        double w = i % 2 ? c : 1, r = i % 2 ? radius / c : radius;

        ix__sincos_deg(a0 + i * half, &sa, &ca);
        pts[i] = w;
        pts[np + i] = w * (center[0] + r * ca);
        pts[2 * np + i] = w * (center[1] + r * sa);
        pts[3 * np + i] = w * center[2];
    }
}

ix_status ix_arc_angles(ix_ctx *ctx, const double center[3], double radius,
                        double a0, double a1, ix_mv **out)
{
    static const double knots[8] = {0, 0, 0, 1, 1, 2, 2, 2};
    const ix_dir one = {.basis = IX_BEZIER, .order = 3, .length = 3};
    const ix_dir two = {
        .basis = IX_BSPLINE, .order = 3, .length = 5, .knots = knots};
    double sweep = fmod(a1 - a0, 360), pts[20];
    int n;

    *out = NULL;
    IX_TRY(ix__check_circle(ctx, center, radius));
    if (sweep < 0)
        sweep += 360;
    /* 1e-6 degrees: as for ix_arc, beyond it the weights tell nothing */
    if (!(sweep > 1e-6 && sweep < 360 - 1e-6))
        return IX_FAIL(ctx, IX_EARG,
                       "from %g to %g degrees is no arc but a whole turn", a0,
                       a1);
    n = sweep < 160 ? 1 : 2;
    arc_points(center, radius, a0, sweep, n, pts);
    return ix_mv_new(ctx, 1, n == 1 ? &one : &two, 3, true, pts, out);
}

/* The end tangents meet at pts[1]; the centre is where the perpendiculars to
 * them at the ends meet, on the line from pts[1] through the mid-point m of
 * the chord:  centre = q + (m - q) |m - q|^-2 (h^2 + |m - q|^2),  h half the
 * chord (similar triangles). */
bool ix_arc_center(const ix_mv *arc, double center[3])
{
    double p[3][3] = {{0}}, m[3], d[3], chord[3], len2, h2;
    int nc = ix_mv_ncoords(arc);

    if (ix_mv_ndirs(arc) != 1 || ix_mv_npts(arc) != 3 || !ix_mv_rational(arc) ||
        nc > 3)
        return false;
    for (int c = 0; c < nc; c++)
        for (int i = 0; i < 3; i++)
            p[i][c] = ix_mv_coord(arc, c)[i] / ix_mv_weights(arc)[i];
    for (int c = 0; c < 3; c++) {
        m[c] = (p[0][c] + p[2][c]) / 2;
        chord[c] = (p[2][c] - p[0][c]) / 2;
    }
    ix__sub3(m, p[1], d);
    len2 = ix__dot3(d, d);
    h2 = ix__dot3(chord, chord);
    /* a triangle flatter than 1e-7 is straight to within rounding of p */
    if (!(len2 > 1e-14 * h2) ||
        !(fabs(ix__dot3(d, chord)) <= 1e-6 * sqrt(len2 * h2)))
        return false;
    ix__axpy3(p[1], (h2 + len2) / len2, d, center);
    return true;
}
