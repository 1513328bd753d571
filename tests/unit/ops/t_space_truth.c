/* Bisector surfaces in space of awkward input, against their definition in long
 * double: the centre is solved for from three planes, of the feet as they are
 * given by the input's own control points.
 *
 * IX_TEST_ROUNDS=300 tries that many of each kind; then IX_TEST_KIND=10 may
 * choose one. By default a few. What rounding is allowed is measured: by how
 * much the centre moves when every number of the input, and value and
 * derivative of both curves, are changed by one rounding, and what the rounding
 * of the control points of the result leaves at that parameter. */
#include <float.h>
#include <limits.h>
#include <stdlib.h>

#include "geom/vec3.h"
#include "harness/test.h"
#include "iritx/geom_srf.h"
#include "iritx/ops_bisect.h"
#include "truth.h"

static int rounds(void)
{
    const char *s = getenv("IX_TEST_ROUNDS");

    return s ? atoi(s) : 2;
}

/* --- input ------------------------------------------------------------------
 */

enum {
    PLAIN,
    CORNERS,     /* repeated knots, up to jumps */
    WEIGHTS,     /* from 1e-3 to 1e3 */
    HIGH,        /* orders up to 8 */
    SIZES,       /* from 1e-6 to 1e6 */
    FAR,         /* 1e6 of their size from the origin */
    FLAT,        /* coplanar but for 1e-3 to 1e-12 */
    NEAR,        /* 1e-3 to 1e-10 apart at one place */
    LINES,       /* collinear but for 1e-3 to 1e-9 */
    SHARED,      /* the first half is the same */
    STRAIGHT,    /* order 2, or straight spans */
    CLOSED,      /* periodic */
    PLANAR,      /* two coordinates, and three */
    SMALL_APART, /* 1e-6 in size, 1 to 2^20 apart */
    KINDS
};

static const char *const names[KINDS] = {
    "plain",    "corners", "weights", "high",       "sizes",
    "far",      "flat",    "near",    "lines",      "shared",
    "straight", "closed",  "planar",  "small apart"};

typedef struct {
    ix_ctx *ctx;
    ix_rng *r;
    int kind;
} source;

/* A logarithm's worth from lo to hi. */
static double scale_of(ix_rng *r, double lo, double hi)
{
    return exp(ix_rng_range(r, log(lo), log(hi)));
}

static int knots_of(source *s, int order, double *kv)
{
    int spans = ix_rng_int(s->r, 1, 3), n = order, most = order - 2;

    if (s->kind == CORNERS)
        most = order;
    for (int i = 0; i < order; i++)
        kv[i] = 0;
    for (int i = 1; i < spans; i++)
        for (int m = ix_rng_int(s->r, 1, most > 1 ? most : 1); m > 0; m--)
            kv[n++] = i + 0.3 * (i & 1);
    for (int i = 0; i < order; i++)
        kv[n + i] = spans;
    return n;
}

static double weight_of(source *s)
{
    return s->kind == WEIGHTS ? scale_of(s->r, 1e-3, 1e3)
                              : ix_rng_range(s->r, 0.5, 2);
}

/* Curve number c (0 or 1): order, knots and weights at random, near an arc that
 * is the other one's turned by a right angle, at a distance. */
static ix_mv *random_curve(source *s, int c, double size, const double *shift)
{
    int most = s->kind == HIGH ? 8 : 4, lo = s->kind == CORNERS ? 3 : 2;
    int order = s->kind == STRAIGHT ? 2 + c : ix_rng_int(s->r, lo, most), n;
    bool rational = s->kind == WEIGHTS || ix_rng_int(s->r, 0, 1);
    int nc = s->kind == PLANAR && c == 0 ? 2 : 3;
    double kv[64], pts[4 * 64];
    ix_dir d = {IX_BSPLINE, order, 0, false, kv};
    ix_mv *m;

    n = knots_of(s, order, kv);
    if (s->kind == CLOSED) {
        n = order + ix_rng_int(s->r, 1, 4);
        for (int i = 0; i < n + 2 * order - 1; i++)
            kv[i] = i - order + 1;
        d.periodic = true;
    }
    d.length = n;
    for (int i = 0; i < n; i++) {
        double u = i / (n - 1.0), w = rational ? weight_of(s) : 1;
        double a = s->kind == CLOSED ? 6.28 * i / n : 2.2 * u - 1.1;
        double x[3] = {c ? 1.2 * sin(a) : 0.8 * cos(a) - 1.4,
                       c ? 0.3 * sin(2 * a) : 1.2 * sin(a),
                       c ? 0.8 * cos(a) : 0.2 * sin(3 * a)};

        for (int k = 0; k < 3; k++)
            x[k] += ix_rng_range(s->r, -0.15, 0.15);
        if (s->kind == STRAIGHT && c && i < n / 2)
            x[0] = i, x[1] = 0.5 * i, x[2] = 1 - 0.5 * i;
        pts[i] = w;
        for (int k = 0; k < nc; k++)
            pts[(k + rational) * n + i] = w * (size * x[k] +
                                               (shift ? shift[k] : 0));
    }
    ASSERT_OK(s->ctx, ix_mv_new(s->ctx, 1, &d, nc, rational, pts, &m));
    return m;
}

/* Control points of m replaced by f(x, eps). */
typedef void (*change)(double *x, double eps);

static void flatten(double *x, double eps)
{
    x[2] = 0.3 * x[0] - 0.2 * x[1] + eps * x[2];
}

static void straighten(double *x, double eps)
{
    x[1] = 0.4 * x[0] + eps * x[1];
    x[2] = -0.7 * x[0] + eps * x[2];
}

static ix_mv *changed(ix_ctx *ctx, ix_mv *m, change f, double eps)
{
    double pts[4 * 64];
    size_t n = ix_mv_npts(m), r = ix_mv_rational(m);
    ix_dir d = ix_mv_dir(m, 0);
    ix_mv *out;

    for (size_t i = 0; i < n; i++) {
        double w = r ? ix_mv_weights(m)[i] : 1, x[3];

        for (int k = 0; k < 3; k++)
            x[k] = ix_mv_coord(m, k)[i] / w;
        f(x, eps);
        pts[i] = w;
        for (size_t k = 0; k < 3; k++)
            pts[(k + r) * n + i] = w * x[k];
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 3, r, pts, &out));
    ix_mv_unref(ctx, m);
    return out;
}

/* b moved so that it is gap from a at one place of each. */
static ix_mv *brought_near(source *s, const ix_mv *a, ix_mv *b, double gap)
{
    double m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    double dom[2], t, x[3], y[3];
    ix_mv *out;

    ix_mv_domain(a, 0, dom);
    t = dom[0] + 0.37 * (dom[1] - dom[0]);
    ASSERT_OK(s->ctx, ix_mv_point(s->ctx, a, &t, x));
    ix_mv_domain(b, 0, dom);
    t = dom[0] + 0.61 * (dom[1] - dom[0]);
    ASSERT_OK(s->ctx, ix_mv_point(s->ctx, b, &t, y));
    for (int k = 0; k < 3; k++)
        m[12 + k] = x[k] - y[k] + (k == 1 ? gap : 0);
    ASSERT_OK(s->ctx, ix_mv_transform(s->ctx, b, m, &out));
    ix_mv_unref(s->ctx, b);
    return out;
}

/* The first half of a, then points of its own. */
static ix_mv *branching(source *s, const ix_mv *a)
{
    double pts[4 * 64];
    size_t n = ix_mv_npts(a);
    ix_dir d = ix_mv_dir(a, 0);
    ix_mv *out;

    for (size_t i = 0; i < n * (3 + (size_t)ix_mv_rational(a)); i++) {
        const double *p = ix_mv_rational(a) ? ix_mv_weights(a)
                                            : ix_mv_coord(a, 0);

        pts[i] = p[i] +
                 (i % n >= n / 2 && i >= n ? ix_rng_range(s->r, -0.5, 0.5) : 0);
    }
    ASSERT_OK(s->ctx,
              ix_mv_new(s->ctx, 1, &d, 3, ix_mv_rational(a), pts, &out));
    return out;
}

static void make_pair(source *s, ix_mv *c[2])
{
    double size = s->kind == SIZES         ? scale_of(s->r, 1e-6, 1e6)
                  : s->kind == SMALL_APART ? 1e-6
                                           : 1,
           far = s->kind == FAR ? 1e6 : 0,
           apart = s->kind == SMALL_APART ? scale_of(s->r, 1, 1 << 20) : 0;

    for (int i = 0; i < 2; i++) {
        const double at[3] = {far + i * apart, far - i * apart / 2,
                              i * apart / 4 - far};

        c[i] = random_curve(s, i, size, at);
        if (s->kind == FLAT)
            c[i] = changed(s->ctx, c[i], flatten, scale_of(s->r, 1e-12, 1e-3));
        if (s->kind == LINES)
            c[i] = changed(s->ctx, c[i], straighten,
                           scale_of(s->r, 1e-9, 1e-3));
    }
    if (s->kind == NEAR)
        c[1] = brought_near(s, c[0], c[1], scale_of(s->r, 1e-10, 1e-3));
    if (s->kind == SHARED) {
        ix_mv_unref(s->ctx, c[1]);
        c[1] = branching(s, c[0]);
    }
}

/* --- truth ------------------------------------------------------------------
 */

/* Knots around t, also of a periodic direction; the index of the first point.
 */
static size_t load_around(const ix_dir *d, double t, local *o)
{
    int p = d->order - 1, j = p;

    o->degree = p;
    while (d->basis == IX_BSPLINE && d->knots[j + 1] <= t &&
           j + 1 < d->length + (d->periodic ? p : 0))
        j++;
    for (int i = 0; i < 2 * p + 2; i++)
        o->knots[i] = d->basis == IX_BSPLINE ? d->knots[j - p + i] : i > p;
    memset(o->pts, 0, sizeof o->pts);
    return (size_t)(j - p);
}

/* A homogeneous curve around t, every number changed by eps at random. */
static void load_curve(const ix_mv *m, double t, double eps, ix_rng *r,
                       local *o)
{
    ix_dir d = ix_mv_dir(m, 0);
    size_t n = ix_mv_npts(m), first = load_around(&d, t, o);

    for (int i = 0; i < d.order; i++) {
        size_t at = (first + (size_t)i) % n;

        o->pts[i][0] = ix_mv_rational(m) ? ix_mv_weights(m)[at] : 1;
        for (int k = 0; k < ix_mv_ncoords(m); k++)
            o->pts[i][k + 1] = ix_mv_coord(m, k)[at];
        for (int k = ix_mv_rational(m) ? 0 : 1; k < 4 && eps > 0; k++)
            o->pts[i][k] *= 1 + eps * ix_rng_range(r, -1, 1);
    }
}

/* Foot and tangent; value and derivative changed by eps, too, as their sums
 * are rounded. */
static void foot_of(const local *c, double t, double eps, ix_rng *r, real x[3],
                    real d[3])
{
    real h[4], g[4], slope;
    local a = *c;

    derive_local(c, 0, t, h);
    derive_local(c, 1, t, g);
    if (eps > 0) {
        real sum[4];

        for (int i = 0; i <= c->degree; i++)
            for (int k = 0; k < 4; k++)
                a.pts[i][k] = fabsl(a.pts[i][k]);
        derive_local(&a, 0, t, sum);
        slope = 2 * c->degree / (c->knots[c->degree + 1] - c->knots[c->degree]);
        for (int k = 0; k < 4; k++) {
            h[k] += eps * ix_rng_range(r, -1, 1) * sum[k];
            g[k] += eps * ix_rng_range(r, -1, 1) * sum[k] * slope;
        }
    }
    for (int k = 0; k < 3; k++) {
        x[k] = h[k + 1] / h[0];
        d[k] = (g[k + 1] - x[k] * g[0]) / h[0];
    }
}

/* x with r[i].x = h[i]. */
static void three_planes(real r[3][3], const real h[3], real x[3])
{
    real c[3], det;

    cross(r[1], r[2], c);
    det = dot(r[0], c);
    memset(x, 0, 3 * sizeof *x);
    for (int i = 0; i < 3; i++) {
        cross(r[(i + 1) % 3], r[(i + 2) % 3], c);
        for (int k = 0; k < 3; k++)
            x[k] += h[i] * c[k] / det;
    }
}

/* The centre over t, seen from the first foot, which is added at last. */
static void centre_of(const ix_mv *const c[2], const double t[2], double alpha,
                      double eps, ix_rng *r, real out[3])
{
    real x[2][3], row[3][3], h[3] = {0, 0, 0};
    local l;

    for (int i = 0; i < 2; i++) {
        load_curve(c[i], t[i], eps, r, &l);
        foot_of(&l, t[i], eps, r, x[i], row[i]);
    }
    for (int k = 0; k < 3; k++)
        row[2][k] = x[1][k] - x[0][k];
    h[1] = dot(row[1], row[2]);
    h[2] = (real)alpha * dot(row[2], row[2]);
    three_planes(row, h, out);
    for (int k = 0; k < 3; k++)
        out[k] += x[0][k];
}

static real off(const real *a, const real *b)
{
    real d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};

    return sqrtl(dot(d, d));
}

/* What one rounding of each number of the input makes of the centre. */
static real condition(const ix_mv *const c[2], const double t[2], double alpha,
                      const real want[3])
{
    ix_rng r = {77};
    real worst = 0;

    for (int i = 0; i < 6; i++) {
        real x[3];

        centre_of(c, t, alpha, 0x1p-52, &r, x);
        worst = fmaxl(worst, off(x, want));
    }
    return worst;
}

/* The same of each control point of the result: the sum of absolute values over
 * the weight. */
static double of_result(ix_ctx *ctx, const ix_mv *s, const double *t)
{
    static double pts[4 * 1 << 16];
    size_t n = ix_mv_npts(s);
    ix_dir d[2] = {ix_mv_dir(s, 0), ix_mv_dir(s, 1)};
    double w[4], a[4], most = 0;
    ix_mv *m;

    assert_true(4 * n <= sizeof pts / sizeof *pts);
    for (size_t i = 0; i < 4 * n; i++)
        pts[i] = fabs(ix_mv_weights(s)[i]) + DBL_MIN;
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, true, pts, &m));
    ASSERT_OK(ctx, ix_mv_eval(ctx, s, t, w));
    ASSERT_OK(ctx, ix_mv_eval(ctx, m, t, a));
    ix_mv_unref(ctx, m);
    for (int k = 1; k < 4; k++)
        most = fmax(most, a[k] + fabs(w[k] / w[0]) * a[0]);
    return 0x1p-52 * most / fabs(w[0]);
}

/* --- two curves -------------------------------------------------------------
 */

/* Roundings allowed of what is measured: six products in degrees up to 26 in
 * each parameter; 3000 cases of each kind use 31, curves that share a half 116.
 */
#define ROUNDINGS 256

static void random_place(source *s, const ix_mv *b, double *t)
{
    for (int k = 0; k < 2; k++) {
        double dom[2];

        ix_mv_domain(b, k, dom);
        t[k] = ix_rng_range(s->r, dom[0], dom[1]);
    }
}

static void check_point(source *s, const ix_mv *const c[2], const ix_mv *b,
                        double alpha, const double *t)
{
    real want[3], got[3], bound;
    double x[3];

    centre_of(c, t, alpha, 0, NULL, want);
    if (ix_mv_point(s->ctx, b, t, x) != IX_OK)
        return;
    for (int k = 0; k < 3; k++)
        got[k] = x[k];
    bound = condition(c, t, alpha, want) + of_result(s->ctx, b, t);
    if (!(off(got, want) <= ROUNDINGS * bound))
        fail_msg("%s: %Lg off, bound %Lg at (%g, %g)", names[s->kind],
                 off(got, want), bound, t[0], t[1]);
}

static void check_degrees(const ix_mv *const c[2], const ix_mv *b)
{
    for (int k = 0; k < 2; k++) {
        int d = ix_mv_order(c[k], 0) - 1;

        assert_int_equal(ix_mv_order(b, k) - 1,
                         ix_mv_rational(c[k]) ? 4 * d - 2 : 3 * d - 1);
    }
}

static bool covered(const ix_mv_pieces *p, const double lo[2],
                    const double hi[2])
{
    for (size_t i = 0; i < p->count; i++)
        if (p->lo[2 * i] <= lo[0] && hi[0] <= p->hi[2 * i] &&
            p->lo[2 * i + 1] <= lo[1] && hi[1] <= p->hi[2 * i + 1])
            return true;
    return false;
}

/* Law: cells of the last halving that no finite piece covers have a pole, or
 * are so near to one that the weight varies by more than its distance from 0;
 * in pieces the weight has one sign. */
static void check_pieces(source *s, const ix_mv *b)
{
    enum { DEPTH = 6, CELLS = 1 << DEPTH / 2 };
    ix_mv_pieces p;
    double dom[2][2];

    ASSERT_OK(s->ctx, ix_finite_pieces(s->ctx, b, DEPTH, 0, &p));
    for (int k = 0; k < 2; k++)
        ix_mv_domain(b, k, dom[k]);
    for (int cell = 0; cell < CELLS * CELLS; cell++) {
        double lo[2], hi[2], least = HUGE_VAL, most = -HUGE_VAL;
        /* control polygons of high degree overshoot */
        double near = 1 + (ix_mv_order(b, 0) + ix_mv_order(b, 1)) / 8.0;

        for (int k = 0; k < 2; k++) {
            int i = k ? cell / CELLS : cell % CELLS;

            lo[k] = dom[k][0] + i * (dom[k][1] - dom[k][0]) / CELLS;
            hi[k] = dom[k][0] + (i + 1) * (dom[k][1] - dom[k][0]) / CELLS;
        }
        for (int i = 0; i < 25; i++) {
            double t[2], w[4];

            for (int k = 0; k < 2; k++)
                t[k] = lo[k] +
                       (hi[k] - lo[k]) * ((k ? i / 5 : i % 5) + 0.5) / 5.0;
            ASSERT_OK(s->ctx, ix_mv_eval(s->ctx, b, t, w));
            least = fmin(least, w[0]);
            most = fmax(most, w[0]);
        }
        if (covered(&p, lo, hi) ? !(least * most > 0)
                                : fmax(least, -most) > near * (most - least))
            fail_msg("%s: weights from %g to %g in a cell %s", names[s->kind],
                     least, most,
                     covered(&p, lo, hi) ? "said to be finite"
                                         : "of no finite piece");
    }
    ix_mv_pieces_free(s->ctx, &p);
}

/* Curves that share a part, and a few that touch, are in one plane over spans
 * of order 2 and 3; others within the rounding of 1e-12. */
static bool may_be_flat(int kind)
{
    return kind == SHARED || kind == NEAR || kind == FLAT;
}

static void check_pair(source *s, const ix_mv *const c[2], double alpha,
                       ix_degree_form form)
{
    const ix_op_opts o = {form, INT_MAX};
    ix_mv *b;
    ix_status st = ix_calphasector3d(s->ctx, c[0], c[1], alpha, &o, NULL, &b);

    if (st == IX_EDOMAIN && may_be_flat(s->kind))
        return;
    if (st != IX_OK)
        fail_msg("%s: %s", names[s->kind], ix_ctx_message(s->ctx));
    if (form == IX_FORM_MINIMAL)
        check_degrees(c, b);
    for (int i = 0; i < 16; i++) {
        double t[2];

        random_place(s, b, t);
        check_point(s, c, b, alpha, t);
    }
    if (s->kind != CORNERS && ix_rng_int(s->r, 0, 7) == 0)
        check_pieces(s, b);
    ix_mv_unref(s->ctx, b);
}

/* Law: all degree forms are the centres over both feet. */
static void two_curves(source *s)
{
    double alpha = ix_rng_int(s->r, 0, 2) ? 0.5 : 0.3;
    ix_mv *c[2];

    make_pair(s, c);
    for (int form = 0; form < 4; form++) {
        const ix_mv *const in[2] = {c[0], c[1]};

        if (form == 0 || s->kind != HIGH)
            check_pair(s, in, alpha, (ix_degree_form)form);
    }
    for (int i = 0; i < 2; i++)
        ix_mv_unref(s->ctx, c[i]);
}

/* --- a point ----------------------------------------------------------------
 */

/* Next to the curve, on it, on one of its tangents, far away, anywhere. */
static void random_point(source *s, const ix_mv *c, double q[3])
{
    double dom[2], d[8] = {0}, t, size = 0;
    int nc = ix_mv_ncoords(c), which = ix_rng_int(s->r, 0, 4);

    ix_mv_domain(c, 0, dom);
    t = ix_rng_range(s->r, dom[0], dom[1]);
    ASSERT_OK(s->ctx, ix_mv_curve_derivs(s->ctx, c, t, 1, d));
    for (int k = 0; k < nc; k++)
        size = fmax(size, fabs(d[nc + k]) * (dom[1] - dom[0]));
    for (int k = 0; k < 3; k++) {
        q[k] = k < nc ? d[k] : 0;
        if (which == 1)
            q[k] += size * ix_rng_range(s->r, -1e-6, 1e-6);
        else if (which == 2)
            q[k] += k < nc ? 0.7 * d[nc + k] : 0;
        else if (which)
            q[k] += size * ix_rng_range(s->r, -1, 1) * (which == 3 ? 100 : 1);
    }
}

/* Distances of b from the planes of a ruling. */
static void off_ruling(const ix_mv *c, double t, const double *q, double eps,
                       ix_rng *r, const real b[3], real out[2])
{
    real x[3], d[3], y[3], e[3];
    local l;

    load_curve(c, t, eps, r, &l);
    foot_of(&l, t, eps, r, x, d);
    for (int k = 0; k < 3; k++) {
        real at = q[k] * (1 + (eps > 0 ? eps * ix_rng_range(r, -1, 1) : 0));

        e[k] = x[k] - at;
        y[k] = b[k] - (x[k] + at) / 2;
        x[k] = b[k] - x[k];
    }
    out[0] = dot(x, d) / sqrtl(dot(d, d));
    out[1] = dot(y, e) / sqrtl(dot(e, e));
}

static void check_ruling(source *s, const ix_mv *c, const ix_mv *b,
                         const double *q, const double *t)
{
    real at[3], want[2] = {0, 0}, got[2], moved = 0, bound;
    ix_rng r = {99};
    double x[3];

    if (ix_mv_point(s->ctx, b, t, x) != IX_OK)
        return;
    for (int k = 0; k < 3; k++)
        at[k] = x[k];
    off_ruling(c, t[0], q, 0, NULL, at, got);
    for (int i = 0; i < 6; i++) {
        off_ruling(c, t[0], q, 0x1p-52, &r, at, want);
        for (int k = 0; k < 2; k++)
            moved = fmaxl(moved, fabsl(want[k] - got[k]));
    }
    bound = moved + of_result(s->ctx, b, t);
    if (!(fmaxl(fabsl(got[0]), fabsl(got[1])) <= ROUNDINGS * bound))
        fail_msg("%s: %Lg and %Lg off both planes, bound %Lg at (%g, %g)",
                 names[s->kind], got[0], got[1], bound, t[0], t[1]);
}

/* Law: the pieces cover the curve, and their points are on both planes. */
static void point_and_curve(source *s)
{
    double q[3], dom[2], at;
    ix_mv *c[2];
    ix_status st;
    ix_crvs p;

    make_pair(s, c);
    random_point(s, c[0], q);
    st = ix_pt_crv_bisector3d_pieces(s->ctx, c[0], q, 0.5, NULL, NULL, &p);
    ix_mv_domain(c[0], 0, dom);
    at = dom[0];
    if (st != IX_OK && (st != IX_EDOMAIN || ix_mv_order(c[0], 0) > 2))
        fail_msg("%s: %s", names[s->kind], ix_ctx_message(s->ctx));
    for (int i = 0; i < p.n; i++) {
        assert_true(p.t[2 * i] == at);
        at = p.t[2 * i + 1];
        for (int j = 0; j < 8; j++) {
            double t[2];

            random_place(s, p.crv[i], t);
            check_ruling(s, c[0], p.crv[i], q, t);
        }
    }
    assert_true(st != IX_OK || at == dom[1]);
    ix_crvs_free(s->ctx, &p);
    for (int i = 0; i < 2; i++)
        ix_mv_unref(s->ctx, c[i]);
}

/* --- a surface and a point --------------------------------------------------
 */

static double size_of(const ix_mv *c)
{
    double size = 0, w[2] = {1, 1};

    for (size_t i = 1; i < ix_mv_npts(c); i++)
        for (int k = 0; k < ix_mv_ncoords(c); k++) {
            const double *x = ix_mv_coord(c, k);

            if (ix_mv_rational(c)) {
                w[0] = ix_mv_weights(c)[0];
                w[1] = ix_mv_weights(c)[i];
            }
            size = fmax(size, fabs(x[i] / w[1] - x[0] / w[0]));
        }
    return size;
}

/* The curve extruded along a line of its size, or ruled to the other one. */
static ix_mv *random_surface(source *s)
{
    ix_mv *c[2], *m;
    double size, v[3];

    make_pair(s, c);
    size = size_of(c[0]);
    if (s->kind != SHARED && s->kind != PLANAR && s->kind != HIGH) {
        for (int k = 0; k < 3; k++)
            v[k] = size * ix_rng_range(s->r, 0.5, 1.5);
        ASSERT_OK(s->ctx, ix_srf_extrude(s->ctx, c[0], v, &m));
    } else {
        ASSERT_OK(s->ctx, ix_srf_ruled(s->ctx, c[0], c[1], &m));
    }
    for (int i = 0; i < 2; i++)
        ix_mv_unref(s->ctx, c[i]);
    return m;
}

/* Largest projected coordinate of a control point. */
static double box_of(const ix_mv *m)
{
    size_t n = ix_mv_npts(m);
    double most = 0;

    for (size_t i = 0; i < 3 * n; i++)
        most = fmax(most,
                    fabs(ix_mv_coord(m, 0)[i] /
                         (ix_mv_rational(m) ? ix_mv_weights(m)[i % n] : 1)));
    return most;
}

/* Value and partials of the homogeneous surface around q, changed by eps of
 * the box: the surface has one frame, however small some part of it is. */
static void surface_jet(const ix_mv *m, const double *t, const double *q,
                        double eps, ix_rng *r, real h[3][4])
{
    ix_dir d[2] = {ix_mv_dir(m, 0), ix_mv_dir(m, 1)};
    size_t nu = (size_t)d[0].length, n = ix_mv_npts(m), rat = ix_mv_rational(m);
    const double *p = rat ? ix_mv_weights(m) : ix_mv_coord(m, 0);
    local u, sum, v[3];
    size_t j = load_around(&d[1], t[1], &v[0]),
           i = load_around(&d[0], t[0], &u);
    real size[4], slope[3] = {1, 0, 0}, box = eps > 0 ? box_of(m) : 0;

    v[1] = v[2] = v[0];
    sum = u;
    slope[1] = 2 * u.degree / (u.knots[u.degree + 1] - u.knots[u.degree]);
    slope[2] = 2 * v->degree / (v->knots[v->degree + 1] - v->knots[v->degree]);
    for (int row = 0; row <= v[0].degree; row++) {
        for (int a = 0; a <= u.degree; a++) {
            size_t at = (i + (size_t)a) % nu + nu * (j + (size_t)row);
            real w = rat ? p[at] * (real)(1 + eps * ix_rng_range(r, -1, 1)) : 1;

            u.pts[a][0] = w;
            sum.pts[a][0] = fabsl(w);
            for (size_t k = 0; k < 3; k++) {
                real x = p[(k + rat) * n + at] +
                         w * (real)(box * eps * ix_rng_range(r, -1, 1));

                u.pts[a][k + 1] = x - w * q[k];
                sum.pts[a][k + 1] = fabsl(x) + fabsl(w * q[k]);
            }
        }
        derive_local(&u, 0, t[0], v[0].pts[row]);
        derive_local(&u, 1, t[0], v[1].pts[row]);
        derive_local(&sum, 0, t[0], v[2].pts[row]);
    }
    derive_local(&v[0], 0, t[1], h[0]);
    derive_local(&v[1], 0, t[1], h[1]);
    derive_local(&v[0], 1, t[1], h[2]);
    derive_local(&v[2], 0, t[1], size);
    for (int b = 0; b < 3; b++)
        for (int k = 0; k < 4; k++)
            h[b][k] += eps * ix_rng_range(r, -1, 1) * size[k] * slope[b];
}

/* The point of the bisector; returns its distance from the foot over the sine
 * at which the line to q meets the tangent plane: their product is a sum that
 * is rounded in proportion to both lengths. */
static real on_normal(const ix_mv *m, const double *t, const double *q,
                      double eps, real out[3])
{
    static ix_rng r = {5};
    real h[3][4], x[3], d[2][3], n[3], lambda;

    surface_jet(m, t, q, eps, &r, h);
    for (int k = 0; k < 3; k++) {
        x[k] = h[0][k + 1] / h[0][0];
        for (int i = 0; i < 2; i++)
            d[i][k] = (h[i + 1][k + 1] - x[k] * h[i + 1][0]) / h[0][0];
    }
    cross(d[0], d[1], n);
    lambda = -dot(x, x) / (2 * dot(x, n));
    for (int k = 0; k < 3; k++)
        out[k] = q[k] + x[k] + lambda * n[k];
    return fabsl(lambda) * dot(n, n) * sqrtl(dot(x, x)) / fabsl(dot(x, n));
}

/* Weights over six decades in both factors of the normal cost up to five digits
 * (600 cases: 2.5e4 roundings). Thin strips lose the ratio of their sides,
 * which makes the normal out of nearly parallel tangents: none here. */
#define WEIGHTED 1e5

/* Law: on the normal as far from the point as from the surface. */
static void point_and_surface(source *s)
{
    ix_mv *m = random_surface(s), *b;
    double q[3], t[2];
    ix_status st;

    random_place(s, m, t);
    ASSERT_OK(s->ctx, ix_mv_point(s->ctx, m, t, q));
    for (int k = 0; k < 3 && ix_rng_int(s->r, 0, 3); k++)
        q[k] += (s->kind == SMALL_APART ? 1e-6 : 1) * scale_of(s->r, 1e-6, 100);
    st = ix_pt_srf_bisector(s->ctx, m, q, NULL, NULL, &b);
    /* all tangent planes of a plane pass through a point of it */
    if (st != IX_OK && (st != IX_EDOMAIN || ix_mv_order(m, 0) > 2))
        fail_msg("%s: %s", names[s->kind], ix_ctx_message(s->ctx));
    for (int i = 0; st == IX_OK && i < 8; i++) {
        real want[3], got[3], moved[3], bound;
        double x[3];

        random_place(s, b, t);
        bound = 0x1p-52 * on_normal(m, t, q, 0, want);
        if (ix_mv_point(s->ctx, b, t, x) != IX_OK)
            continue;
        for (int k = 0; k < 3; k++)
            got[k] = x[k];
        for (int k = 0; k < 6; k++) {
            (void)on_normal(m, t, q, 0x1p-52, moved);
            bound = fmaxl(bound, off(moved, want));
        }
        bound += of_result(s->ctx, b, t);
        bound *= s->kind == WEIGHTS ? WEIGHTED : ROUNDINGS;
        if (!(off(got, want) <= bound))
            fail_msg("%s: %Lg off, bound %Lg at (%g, %g)", names[s->kind],
                     off(got, want), bound, t[0], t[1]);
    }
    ix_mv_unref(s->ctx, b);
    ix_mv_unref(s->ctx, m);
}

/* --- all kinds --------------------------------------------------------------
 */

static void each(void (*check)(source *s), uint64_t seed)
{
    const char *one = getenv("IX_TEST_KIND");

    for (int kind = 0; kind < KINDS; kind++)
        for (int i = 0; i < rounds(); i++) {
            ix_rng r = {seed + (uint64_t)(1000 * kind + i)};
            source s = {ix_ctx_new(NULL, NULL), &r, kind};

            if (!one || atoi(one) == kind)
                check(&s);
            ix_ctx_free(s.ctx);
        }
}

static void curves(void **state)
{
    (void)state;
    each(two_curves, 0);
}

static void points(void **state)
{
    (void)state;
    each(point_and_curve, 50000);
}

static void surfaces(void **state)
{
    (void)state;
    each(point_and_surface, 90000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(curves),
        cmocka_unit_test(points),
        cmocka_unit_test(surfaces),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
