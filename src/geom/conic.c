/* conic.c - implicit conics as rational quadratics.
 *
 * A rotation by at most 45 degrees and a shift bring the equation to its axes;
 * there ellipse, hyperbola and parabola have the parametrisations
 *
 *   (a cos u, b sin u)   (a cosh u, b sinh u) or (b sinh u, a cosh u)
 *   (u^2 / 4p, u) or (u, u^2 / 4p)
 *
 * and every interval of u is one or two rational quadratic spans. */
#include <math.h>
#include <string.h>

#include "geom/angle.h"
#include "geom/circle.h"
#include "mv/mv.h"

typedef enum { ELLIPSE, HYPERBOLA, PARABOLA } kind;

typedef struct {
    kind kind;
    double o[2], ex[2], ey[2]; /* center or vertex; unit axes */
    double a, b;               /* semi-axes; parabola: a = p */
} conic;

/* c in coordinates turned by the angle with cosine cs and sine sn. */
static void turn(const double c[6], double cs, double sn, double out[6])
{
    out[0] = c[0] * cs * cs + c[1] * cs * sn + c[2] * sn * sn;
    out[1] = 0; /* by the choice of the angle */
    out[2] = c[0] * sn * sn - c[1] * cs * sn + c[2] * cs * cs;
    out[3] = c[3] * cs + c[4] * sn;
    out[4] = -c[3] * sn + c[4] * cs;
    out[5] = c[5];
}

/* tan 2u = B / (A - C) with |u| <= 45 degrees. */
static void axes(const double c[6], double *cs, double *sn)
{
    double d = c[0] - c[2], u;

    u = c[1] == 0 ? 0 : d == 0 ? copysign(IX__PI / 2, c[1]) : atan(c[1] / d);
    *cs = cos(u / 2);
    *sn = sin(u / 2);
}

/* Swaps or turns the frame by a quarter so that its first axis is the one on
 * which the curve opens, pointing towards it. */
static void quarter(conic *q, double sign)
{
    double ex[2] = {q->ex[0], q->ex[1]};

    for (int k = 0; k < 2; k++) {
        q->ex[k] = sign * q->ey[k];
        q->ey[k] = -sign * ex[k];
    }
}

/* A x^2 + C y^2 + D x + E y + F with A and C not 0. */
static ix_status central(ix_ctx *ctx, const double c[6], conic *q)
{
    double x = -c[3] / (2 * c[0]), y = -c[4] / (2 * c[2]);
    double f = c[5] + (c[3] * x + c[4] * y) / 2;
    double size = fabs(c[5]) + fabs(c[3] * x) + fabs(c[4] * y);
    double a2 = -f / c[0], b2 = -f / c[2];

    for (int k = 0; k < 2; k++)
        q->o[k] = x * q->ex[k] + y * q->ey[k];
    if (!(fabs(f) > 1e-13 * size)) /* cancelled to rounding */
        return IX_FAIL(ctx, IX_EDOMAIN, "degenerate conic: %s (%g, %g)",
                       c[0] * c[2] > 0 ? "the single point"
                                       : "two lines that cross at",
                       q->o[0], q->o[1]);
    if (a2 < 0 && b2 < 0)
        return IX_FAIL(ctx, IX_EDOMAIN, "the conic has no real points");
    q->kind = a2 > 0 && b2 > 0 ? ELLIPSE : HYPERBOLA;
    q->a = sqrt(fabs(a2));
    q->b = sqrt(fabs(b2));
    if (a2 < 0) { /* opens along y */
        double t = q->a;

        q->a = q->b;
        q->b = t;
        quarter(q, 1);
    }
    return IX_OK;
}

/* C y^2 + D x + E y + F with C not 0. */
static ix_status parabola(ix_ctx *ctx, const double c[6], double size, conic *q)
{
    double y = -c[4] / (2 * c[2]), f = c[5] + c[4] * y / 2, x;

    if (!(fabs(c[3]) > 1e-13 * size)) {
        if (f / c[2] > 0)
            return IX_FAIL(ctx, IX_EDOMAIN, "the conic has no real points");
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "degenerate conic: two parallel lines at distance %g",
                       2 * sqrt(-f / c[2]));
    }
    x = -f / c[3];
    q->kind = PARABOLA;
    for (int k = 0; k < 2; k++)
        q->o[k] = x * q->ex[k] + y * q->ey[k];
    q->a = -c[3] / (4 * c[2]); /* y^2 = 4 p x */
    if (q->a < 0) {
        q->a = -q->a;
        quarter(q, 1);
        quarter(q, 1); /* half a turn */
    }
    return IX_OK;
}

static ix_status classify(ix_ctx *ctx, const double in[6], conic *q)
{
    double c[6], t[6], size = 0, quad, cs, sn;

    for (int k = 0; k < 6; k++)
        size = fmax(size, fabs(in[k]));
    if (!(size > 0 && isfinite(size)))
        return IX_FAIL(ctx, IX_EARG, "the largest coefficient is %g", size);
    for (int k = 0; k < 6; k++)
        c[k] = in[k] / size;
    axes(c, &cs, &sn);
    turn(c, cs, sn, t);
    q->ex[0] = q->ey[1] = cs;
    q->ex[1] = sn;
    q->ey[0] = -sn;
    quad = fmax(fabs(t[0]), fabs(t[2]));
    if (!(quad > 1e-14)) /* of the largest coefficient: rounding */
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "degenerate conic: the equation is linear");
    /* 1e-12: an axis a million times the other; below, rounding decides */
    if (fabs(t[0]) > 1e-12 * quad && fabs(t[2]) > 1e-12 * quad)
        return central(ctx, t, q);
    if (fabs(t[2]) < quad) { /* x^2: turn the frame, y -> -x, x -> y */
        double s[6] = {t[2], 0, t[0], t[4], -t[3], t[5]};

        quarter(q, 1);
        return parabola(ctx, s, 1, q);
    }
    return parabola(ctx, t, 1, q);
}

/* The parameter of open conics grows towards +x or +y: the second axis is
 * mirrored if need be (they are symmetric to the first). */
static void orient(conic *q)
{
    int k = fabs(q->ey[0]) > fabs(q->ey[1]) ? 0 : 1;
    double sign = q->kind != ELLIPSE && q->ey[k] < 0 ? -1 : 1;

    q->ey[0] *= sign;
    q->ey[1] *= sign;
}

/* Homogeneous points (w, x, y) of the part u0 .. u1 in the conic's frame, but
 * for ellipses, which are made of circles: p[3][3]. */
static void piece(const conic *q, double u0, double u1, double p[3][3])
{
    double m = (u0 + u1) / 2, h = (u1 - u0) / 2;
    const double u[3] = {u0, m, u1};

    for (int i = 0; i < 3; i++) {
        p[0][i] = 1;
        if (q->kind == HYPERBOLA) { /* end tangents meet on the axis of m */
            p[0][i] = i == 1 ? cosh(h) : 1;
            p[1][i] = q->a * cosh(u[i]);
            p[2][i] = q->b * sinh(u[i]);
        } else {
            p[1][i] = (i == 1 ? u0 * u1 : u[i] * u[i]) / (4 * q->a);
            p[2][i] = u[i];
        }
    }
}

/* m's points (P3, in the frame, z = 0) mapped into the plane at height z. */
static ix_status place(ix_ctx *ctx, const conic *q, double z, const ix_mv *m,
                       ix_mv **out)
{
    size_t n = m->npts;
    ix_mv *r;

    IX_TRY(ix__mv_alloc(ctx, 1, m->dirs, 3, true, &r));
    for (size_t i = 0; i < n; i++) {
        double w = m->pts[i], x = m->pts[n + i], y = m->pts[2 * n + i];

        r->pts[i] = w;
        for (size_t k = 0; k < 2; k++)
            r->pts[(k + 1) * n + i] = w * q->o[k] + x * q->ex[k] + y * q->ey[k];
        r->pts[3 * n + i] = w * z;
    }
    *out = r;
    return IX_OK;
}

/* The part with parameters u[0] .. u[1]; NULL: an ellipse as a whole. */
static ix_status make(ix_ctx *ctx, const conic *q, double z, const double *u,
                      ix_mv **out)
{
    static const double origin[3] = {0, 0, 0};
    const ix_dir dir = {.basis = IX_BEZIER, .order = 3, .length = 3};
    conic frame = *q;
    double p[4][3] = {{0}};
    ix_mv *m;
    ix_status st;

    if (q->kind == ELLIPSE) {
        for (int k = 0; k < 2; k++) {
            frame.ex[k] *= q->a;
            frame.ey[k] *= q->b;
        }
        if (u)
            IX_TRY(ix_arc_angles(ctx, origin, 1, IX__DEG(u[0]), IX__DEG(u[1]),
                                 &m));
        else
            IX_TRY(ix_circle(ctx, origin, 1, &m));
    } else {
        if (!(u[0] < u[1] && isfinite(u[1] - u[0])))
            return IX_FAIL(ctx, IX_EARG, "parameters %g to %g", u[0], u[1]);
        piece(q, u[0], u[1], p);
        IX_TRY(ix_mv_new(ctx, 1, &dir, 3, true, p[0], &m));
    }
    st = place(ctx, &frame, z, m, out);
    ix_mv_unref(ctx, m);
    return st;
}

ix_status ix_conic(ix_ctx *ctx, const double coef[6], double z,
                   const double *range, ix_mv **out)
{
    double u[2] = {-2, 2};
    conic q;

    *out = NULL;
    IX_TRY(classify(ctx, coef, &q));
    orient(&q);
    if (q.kind == PARABOLA) { /* four times the half width at the focus */
        u[0] = -8 * q.a;
        u[1] = 8 * q.a;
    }
    if (!range)
        return make(ctx, &q, z, q.kind == ELLIPSE ? NULL : u, out);
    for (int k = 0; k < 2; k++)
        u[k] = q.kind == ELLIPSE ? IX__RADIANS(range[k]) : range[k];
    return make(ctx, &q, z, u, out);
}

/* Parameter of a point that lies on the conic. */
static ix_status parameter(ix_ctx *ctx, const conic *q, const double p[3],
                           double *u)
{
    double d[2] = {p[0] - q->o[0], p[1] - q->o[1]}, off;
    double x = d[0] * q->ex[0] + d[1] * q->ex[1];
    double y = d[0] * q->ey[0] + d[1] * q->ey[1];

    if (q->kind == ELLIPSE) {
        *u = atan2(y / q->b, x / q->a);
        off = fabs(hypot(x / q->a, y / q->b) - 1);
    } else if (q->kind == HYPERBOLA) {
        *u = asinh(y / q->b);
        off = fabs(x / (q->a * cosh(*u)) - 1);
    } else {
        *u = y;
        off = fabs(x - y * y / (4 * q->a)) / (q->a + fabs(x));
    }
    if (!(off <= 1e-5)) /* "approximately equal", spec/model 2 */
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "point (%g, %g) is not on the conic%s (off by %g)", p[0],
                       p[1], q->kind == HYPERBOLA ? "'s branch" : "", off);
    return IX_OK;
}

ix_status ix_conic_between(ix_ctx *ctx, const double coef[6], double z,
                           const double p0[3], const double p1[3], ix_mv **out)
{
    double u[2], d[2];
    conic q;

    *out = NULL;
    IX_TRY(classify(ctx, coef, &q));
    for (int k = 0; k < 2; k++)
        d[k] = p0[k] - q.o[k];
    if (q.kind == HYPERBOLA && d[0] * q.ex[0] + d[1] * q.ex[1] < 0) {
        quarter(&q, 1);
        quarter(&q, 1); /* the other branch */
    }
    orient(&q);
    IX_TRY(parameter(ctx, &q, p0, &u[0]));
    IX_TRY(parameter(ctx, &q, p1, &u[1]));
    if (q.kind != ELLIPSE && u[0] > u[1]) {
        double t = u[0];

        u[0] = u[1];
        u[1] = t;
    }
    return make(ctx, &q, z, u, out);
}
