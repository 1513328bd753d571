/* vec3.h - three numbers as a point or a direction: the few operations that
 * analytic geometry writes on every second line. */
#ifndef GEOM_VEC3_H
#define GEOM_VEC3_H

#include <math.h>

#include "base/ctx.h"

static inline double ix__dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Scaled, so that it neither overflows nor underflows on the way. */
static inline double ix__len3(const double a[3])
{
    double s = fmax(fabs(a[0]), fmax(fabs(a[1]), fabs(a[2])));
    double x = a[0] / s, y = a[1] / s, z = a[2] / s;

    return s > 0 && isfinite(s) ? s * sqrt(x * x + y * y + z * z) : s;
}

/* out = a - b; may be one of them. */
static inline void ix__sub3(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[i] - b[i];
}

/* out = a + t b; may be one of them. */
static inline void ix__axpy3(const double a[3], double t, const double b[3],
                             double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[i] + t * b[i];
}

/* out = a x b; must be neither of them. */
static inline void ix__cross3(const double a[3], const double b[3],
                              double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* out = a / |a| and the result |a|; out untouched when that is 0 or not
 * finite. */
static inline double ix__unit3(const double a[3], double out[3])
{
    double len = ix__len3(a);

    if (len > 0 && isfinite(len))
        for (int i = 0; i < 3; i++)
            out[i] = a[i] / len;
    return len;
}

static inline double ix__dist3(const double a[3], const double b[3])
{
    double d[3];

    ix__sub3(a, b, d);
    return ix__len3(d);
}

/* Some unit vector perpendicular to the unit vector u. */
static inline void ix__perp3(const double u[3], double out[3])
{
    double e[3] = {0, 0, 0};
    int k = fabs(u[0]) <= fabs(u[1]) && fabs(u[0]) <= fabs(u[2]) ? 0
            : fabs(u[1]) <= fabs(u[2])                           ? 1
                                                                 : 2;

    e[k] = 1; /* the axis farthest from u */
    ix__cross3(u, e, out);
    ix__unit3(out, out);
}

/* out = the unit vector along v. Err IX_EARG v is zero or not finite: "WHAT
 * (x, y, z) has no direction". */
ix_status ix__direction(ix_ctx *ctx, const char *what, const double v[3],
                        double out[3]) IX_MUST_CHECK;

#endif
