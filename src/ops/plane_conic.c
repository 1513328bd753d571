/* plane_conic.c - bisectors of straight lines and circles.
 *
 * They are conics; the centre of a circle is a focus, around which they are
 * rational of degree 2 with the unit circle. */
#include "ops/plane_conic.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "mv/mv.h"

#define PI 3.14159265358979323846

/* How far a span's points may be off a line or circle, in parts of the span's
 * size: some hundred roundings; and what coordinates far from the origin round,
 * as long as that is little of the span. */
#define SAME  1e-13
#define ULPS  (8 * DBL_EPSILON)
#define ROUGH 1e-11

typedef enum { OTHER, LINE, CIRCLE } carrier_kind;

typedef struct {
    carrier_kind kind;
    double normal[2]; /* of a line, unit */
    double o[2], rho; /* of a circle */
} carrier;

/* --- what carries a curve --------------------------------------------------
 */

static double cross(const double *a, const double *b)
{
    return a[0] * b[1] - a[1] * b[0];
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1];
}

static double dist(const double *a, const double *b)
{
    return hypot(a[0] - b[0], a[1] - b[1]);
}

/* Through three points. */
static void carrier_through(double p[3][2], double noise, carrier *c)
{
    double e[2], f[2], n, ee, ff;

    for (int k = 0; k < 2; k++) {
        e[k] = p[1][k] - p[0][k];
        f[k] = p[2][k] - p[0][k];
    }
    ee = dot(e, e);
    ff = dot(f, f);
    n = cross(e, f);
    if (!(ff > 0))
        return;
    memcpy(c->o, p[0], sizeof c->o);
    if (fabs(n) <= SAME * ff + noise * sqrt(ff)) {
        c->kind = LINE;
        c->normal[0] = -f[1] / sqrt(ff);
        c->normal[1] = f[0] / sqrt(ff);
        return;
    }
    c->kind = CIRCLE;
    c->o[0] += 0.5 * (ee * f[1] - ff * e[1]) / n;
    c->o[1] += 0.5 * (ff * e[0] - ee * f[0]) / n;
    c->rho = dist(c->o, p[0]);
}

static double off_carrier(const carrier *c, const double x[2])
{
    double d[2] = {x[0] - c->o[0], x[1] - c->o[1]};

    return fabs(c->kind == LINE ? dot(d, c->normal)
                                : hypot(d[0], d[1]) - c->rho);
}

/* The spans that hold t[2], as parameters; how many. */
static int spans_around(const ix_mv *crv, const double t[2], double out[2])
{
    const ix_dir *d = &crv->dirs[0];
    double lo = fmin(t[0], t[1]), hi = fmax(t[0], t[1]);
    int first = 0, last = 1;

    ix_mv_domain(crv, 0, out);
    for (int i = 0, n = ix_knots_count(d); i < n; i++) {
        if (d->knots[i] <= lo && d->knots[i] > out[0]) {
            out[0] = d->knots[i];
            first = i;
        }
        if (d->knots[n - 1 - i] >= hi && d->knots[n - 1 - i] < out[1]) {
            out[1] = d->knots[n - 1 - i];
            last = n - 1 - i;
        }
    }
    return last > first ? last - first : 1;
}

/* Of whole spans: a short part of any curve is an arc up to rounding. A
 * polynomial of degree 2 d that is zero in 2 d + 1 points is zero. */
static ix_status carrier_of(ix_ctx *ctx, const ix_mv *crv, const double t[2],
                            double noise, carrier *c)
{
    double p[3][2], x[2], s[2], far = 0, worst = 0;
    int n = (2 * crv->dirs[0].order - 1) * spans_around(crv, t, s);

    *c = (carrier){.kind = OTHER};
    for (int i = 0; i < 3; i++) { /* not both ends: they may be one point */
        double at = s[0] + 0.4 * i * (s[1] - s[0]);

        IX_TRY(ix_mv_point(ctx, crv, &at, p[i]));
        far = fmax(far, dist(p[0], p[i]));
    }
    carrier_through(p, noise, c);
    for (int i = 0; i <= n && c->kind != OTHER; i++) {
        double at = s[0] + (s[1] - s[0]) * i / n;

        IX_TRY(ix_mv_point(ctx, crv, &at, x));
        worst = fmax(worst, off_carrier(c, x));
        if (!(worst <= SAME * far + noise) || !(worst <= ROUGH * far))
            c->kind = OTHER;
    }
    return IX_OK;
}

/* --- conics by a focus ------------------------------------------------------
 */

/* The points q + d e with d (a - b.e) = k, e being unit vectors. */
typedef struct {
    double q[2], a, b[2], k;
    double from[2]; /* where they are seen from */
} focal;

/* The bisector of circle o and of c, near x. With d = |x - q|, q the centre of
 * o, the distance from o is +-(d - rho); c is at the same distance:
 * |x - centre| = rho' + s d for a circle, n.(x - point) = s (d - rho) for a
 * line, s = +-1. */
static void focal_of(const carrier *o, const carrier *c, const double x[2],
                     focal *f)
{
    double u[2] = {o->o[0] - c->o[0], o->o[1] - c->o[1]};
    double v[2] = {x[0] - c->o[0], x[1] - c->o[1]};
    double s = dist(x, o->o) > o->rho ? 1 : -1;

    memcpy(f->q, o->o, sizeof f->q);
    if (c->kind == LINE) {
        s = dot(v, c->normal) > 0 ? s : -s;
        f->a = s;
        memcpy(f->b, c->normal, sizeof f->b);
        f->k = dot(u, c->normal) + s * o->rho;
    } else {
        double apart = hypot(u[0], u[1]), rho;

        s = hypot(v[0], v[1]) > c->rho ? s : -s;
        rho = c->rho - s * o->rho;
        f->a = s * rho;
        memcpy(f->b, u, sizeof f->b);
        f->k = 0.5 * (apart - rho) * (apart + rho);
    }
}

static double angle_at(const focal *f, const double x[2])
{
    return atan2(x[1] - f->from[1] - f->q[1], x[0] - f->from[0] - f->q[0]);
}

/* The direction towards infinity that is near that of dir. */
static double asymptote(const focal *f, const double dir[2])
{
    double b = atan2(f->b[1], f->b[0]), near = atan2(dir[1], dir[0]);
    double open = acos(fmax(-1, fmin(1, f->a / hypot(f->b[0], f->b[1]))));
    double d0 = remainder(b + open - near, 2 * PI);
    double d1 = remainder(b - open - near, 2 * PI);

    return near + (fabs(d0) < fabs(d1) ? d0 : d1);
}

/* The angles of e over the piece, which turns one way. */
static void angles_of(const focal *f, const ix_bisector_piece *p, double out[2])
{
    double last;

    out[0] = p->unbounded[0] ? asymptote(f, p->dir[0]) : angle_at(f, p->x);
    out[1] = out[0];
    for (int i = 1; i < p->n; i++) {
        last = angle_at(f, p->x + 2 * i);
        out[1] += remainder(last - out[1], 2 * PI);
    }
    if (p->unbounded[1])
        out[1] += remainder(asymptote(f, p->dir[1]) - out[1], 2 * PI);
}

/* Homogeneous points of the unit circle over n equal angles, as splines of
 * degree 2 have them, become those of the conic, linearly: (w, E) gives
 * (a w - b.E, k E + q times that). */
static void points_of(const focal *f, const double angle[2], int n, double *pts)
{
    int count = 2 * n + 1;
    double h = (angle[1] - angle[0]) / (2 * n), largest = 0;

    for (int i = 0; i < count; i++) {
        double w = i % 2 ? cos(h) : 1, e[2], *x = pts + count + i;

        e[0] = cos(angle[0] + i * h);
        e[1] = sin(angle[0] + i * h);
        pts[i] = f->a * w - dot(f->b, e);
        x[0] = f->k * e[0];
        x[count] = f->k * e[1];
        largest = fabs(pts[i]) > fabs(largest) ? pts[i] : largest;
    }
    for (int i = 0; i < 3 * count; i++)
        pts[i] /= largest;
}

/* From the focus to where it is; no weight at infinity. */
static void place_points(const focal *f, const bool far[2], int count,
                         double *pts)
{
    for (int e = 0; e < 2; e++)
        if (far[e])
            pts[e ? count - 1 : 0] = 0;
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < count; i++) {
            double *x = pts + (k + 1) * count + i;

            *x = fma(f->q[k], pts[i], *x);
        }
}

enum { MOST = 3 };                 /* spans: of a whole ellipse */
#define WIDEST (2 * PI / 3 + 1e-9) /* a span's angle */

static ix_status make(ix_ctx *ctx, const focal *f, const ix_bisector_piece *p,
                      ix_mv **out)
{
    double kv[2 * MOST + 4] = {0}, pts[3 * (2 * MOST + 1)], angle[2];
    ix_dir d = {.basis = IX_BEZIER, .order = 3, .length = 3};
    int n;

    angles_of(f, p, angle);
    n = (int)ceil(fmin(fabs(angle[1] - angle[0]) / WIDEST, MOST));
    n = n < 1 ? 1 : n;
    points_of(f, angle, n, pts);
    place_points(f, p->unbounded, 2 * n + 1, pts);
    if (n > 1) {
        for (int i = 0; i < 2 * n + 4; i++)
            kv[i] = i < 3 ? 0 : i > 2 * n ? n : (i - 1) / 2;
        d = (ix_dir){IX_BSPLINE, 3, 2 * n + 1, false, kv};
    }
    return ix_mv_new(ctx, 1, &d, 2, true, pts, out);
}

ix_status ix__bisector_conic(ix_ctx *ctx, const ix_mv *const crv[2],
                             double t[2][2], const ix_bisector_piece *p,
                             const double q[2], bool *straight, ix_mv **out)
{
    const double *mid = p->x + 2 * (p->n / 2);
    const double x[2] = {mid[0] - q[0], mid[1] - q[1]};
    double noise = ULPS * hypot(q[0], q[1]);
    focal f = {.from = {q[0], q[1]}};
    carrier c[2];
    int i;

    *straight = false;
    *out = NULL;
    for (int k = 0; k < 2; k++) {
        if (t[k][0] == t[k][1])
            return IX_OK;
        IX_TRY(carrier_of(ctx, crv[k], t[k], noise, &c[k]));
        if (c[k].kind == OTHER)
            return IX_OK;
    }
    *straight = c[0].kind == LINE && c[1].kind == LINE;
    if (*straight)
        return IX_OK;
    i = c[0].kind == CIRCLE ? 0 : 1;
    focal_of(&c[i], &c[1 - i], x, &f);
    *straight = c[1 - i].kind == CIRCLE && fabs(f.a) <= SAME * c[1 - i].rho;
    return *straight || f.k == 0 ? IX_OK : make(ctx, &f, p, out);
}
