/* The bisector surface of two space curves: its definition substituted back,
 * its degrees, its behaviour under changes of the input, degenerate input. */
#include <limits.h>
#include <string.h>

#include "geom/vec3.h"
#include "harness/fault.h"
#include "harness/test.h"
#include "iritx/ops_bisect.h"

static ix_mv *make_curve(ix_ctx *ctx, int order, int n, const double *knots,
                         bool rational, int nc, const double *pts)
{
    ix_dir d = {knots ? IX_BSPLINE : IX_BEZIER, order, n, false, knots};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, nc, rational, pts, &m));
    return m;
}

/* kind 0: Bezier; else a B-spline with that many spans (simple knots). */
static ix_mv *rand_curve(ix_ctx *ctx, ix_rng *r, int degree, bool rational,
                         int spans, const double *shift, double size)
{
    double kv[64], pts[4 * 40];
    int n = degree + (spans > 0 ? spans : 1);

    for (int i = 0; i < n + degree + 1; i++)
        kv[i] = i <= degree ? 0 : i >= n ? spans : i - degree + 0.2;
    for (int i = 0; i < n; i++) {
        double w = rational ? ix_rng_range(r, 0.5, 2) : 1;
        double *p = pts + (rational ? n : 0);

        pts[i] = w;
        for (int k = 0; k < 3; k++)
            p[k * n + i] = w * (size * ix_rng_range(r, -1, 1) +
                                (shift ? shift[k] : 0));
    }
    return make_curve(ctx, degree + 1, n, spans ? kv : NULL, rational, 3, pts);
}

/* Largest of the three defining residuals over random samples, relative to the
 * distance: equidistance and the two normal planes. Points where the weight is
 * below 1e-3 of the largest are near infinity and left out. */
static double worst_residual(ix_ctx *ctx, ix_rng *r, const ix_mv *a,
                             const ix_mv *b, const ix_mv *s)
{
    double worst = 0, top = 0;

    for (size_t i = 0; i < ix_mv_npts(s); i++)
        top = fmax(top, fabs(ix_mv_weights(s)[i]));
    for (int round = 0; round < 40; round++) {
        double t[2], dom[2], x[4], e[2][6], d[2] = {0, 0}, dot[2] = {0, 0},
                                            tan[2] = {0, 0};

        for (int i = 0; i < 2; i++) {
            ix_mv_domain(s, i, dom);
            t[i] = ix_rng_range(r, dom[0], dom[1]);
        }
        ASSERT_OK(ctx, ix_mv_eval(ctx, s, t, x));
        if (!(fabs(x[0]) > 1e-3 * top))
            continue;
        ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, a, t[0], 1, e[0]));
        ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, b, t[1], 1, e[1]));
        for (int i = 0; i < 2; i++)
            for (int k = 0; k < 3; k++) {
                double v = x[k + 1] / x[0] - e[i][k];

                d[i] += v * v;
                dot[i] += v * e[i][3 + k];
                tan[i] += e[i][3 + k] * e[i][3 + k];
            }
        worst = fmax(worst, fabs(sqrt(d[0]) - sqrt(d[1])) / sqrt(d[0]));
        for (int i = 0; i < 2; i++)
            worst = fmax(worst, fabs(dot[i]) / sqrt(d[i] * tan[i]));
    }
    return worst;
}

static int degree_of(const ix_mv *s, int dir)
{
    return ix_mv_order(s, dir) - 1;
}

/* Law: |B - C1| = |B - C2|, (B - C1).C1' = (B - C2).C2' = 0, for polynomial
 * and rational Bezier and B-spline curves; degrees exactly 3d - 1 (polynomial
 * curve) and 4d - 2 (rational curve). Tolerance: the aim of the project. */
static void definition_holds(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(31);

    (void)state;
    for (int round = 0; round < 32; round++) {
        int d1 = ix_rng_int(&r, 1, 4), d2 = ix_rng_int(&r, 1, 4);
        bool q1 = round & 1, q2 = round >> 1 & 1;
        int n1 = round & 4 ? 3 : 0, n2 = round & 8 ? 4 : 0;
        ix_mv *a = rand_curve(ctx, &r, d1, q1, n1, NULL, 1);
        ix_mv *b = rand_curve(ctx, &r, d2, q2, n2, NULL, 1), *s;
        double res;
        ix_report rep;

        ASSERT_OK(ctx, ix_cbisector3d(ctx, a, b, NULL, &rep, &s));
        assert_int_equal(degree_of(s, 0), q1 ? 4 * d1 - 2 : 3 * d1 - 1);
        assert_int_equal(degree_of(s, 1), q2 ? 4 * d2 - 2 : 3 * d2 - 1);
        assert_int_equal(rep.orders[0], ix_mv_order(s, 0));
        assert_true(ix_mv_rational(s) && ix_mv_ncoords(s) == 3);
        assert_int_equal(ix_mv_dir(s, 0).basis, n1 ? IX_BSPLINE : IX_BEZIER);
        res = worst_residual(ctx, &r, a, b, s);
        if (!(res <= 1e-12 && rep.residual <= 1e-12))
            fail_msg("degrees %d %d rational %d %d spans %d %d: %g, %g", d1, d2,
                     q1, q2, n1, n2, res, rep.residual);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, s);
    }
    ix_ctx_free(ctx);
}

/* --- changes of the input ------------------------------------------------- */

static ix_mv *bisector(ix_ctx *ctx, const ix_mv *a, const ix_mv *b)
{
    ix_mv *s;

    ASSERT_OK(ctx, ix_cbisector3d(ctx, a, b, NULL, NULL, &s));
    return s;
}

/* A rotation, then a scale, then a translation, in row vectors. */
static void motion(double scale, const double *shift, double mat[16])
{
    const double c = 0.6, s = 0.8;
    const double m[16] = {c * scale,  s * c * scale, s * s * scale, 0,
                          -s * scale, c * c * scale, c * s * scale, 0,
                          0,          -s * scale,    c * scale,     0,
                          shift[0],   shift[1],      shift[2],      1};

    memcpy(mat, m, sizeof m);
}

/* Largest distance of the points of a and b at the same parameters (mapped by
 * their domains), relative to size; where a's weight is not small. */
static double worst_gap(ix_ctx *ctx, ix_rng *r, const ix_mv *a, const ix_mv *b,
                        double size)
{
    double worst = 0, top = 0;

    for (size_t i = 0; i < ix_mv_npts(a); i++)
        top = fmax(top, fabs(ix_mv_weights(a)[i]));
    for (int round = 0; round < 20; round++) {
        double s[2], t[2], x[4], y[3], far = size;

        for (int i = 0; i < 2; i++) {
            double u = ix_rng_unit(r), p[2], q[2];

            ix_mv_domain(a, i, p);
            ix_mv_domain(b, i, q);
            s[i] = p[0] + u * (p[1] - p[0]);
            t[i] = q[0] + u * (q[1] - q[0]);
        }
        ASSERT_OK(ctx, ix_mv_eval(ctx, a, s, x));
        if (!(fabs(x[0]) > 1e-2 * top))
            continue;
        ASSERT_OK(ctx, ix_mv_point(ctx, b, t, y));
        for (int k = 0; k < 3; k++)
            far = fmax(far, fabs(x[k + 1] / x[0]));
        for (int k = 0; k < 3; k++)
            worst = fmax(worst, fabs(x[k + 1] / x[0] - y[k]) / far);
    }
    return worst;
}

/* Law: the bisector of moved and scaled curves is the moved and scaled
 * bisector; of curves on other domains, the same surface on these. */
static void follows_motions_and_parameters(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(32);
    const double shift[3] = {3, -2, 7};
    double mat[16];

    (void)state;
    motion(2.5, shift, mat);
    for (int round = 0; round < 8; round++) {
        ix_mv *a = rand_curve(ctx, &r, 3, round & 1, round & 2 ? 3 : 0, NULL,
                              1);
        ix_mv *b = rand_curve(ctx, &r, 2, round & 4, 0, NULL, 1);
        ix_mv *s = bisector(ctx, a, b), *ma, *mb, *ms, *sm;

        ASSERT_OK(ctx, ix_mv_transform(ctx, a, mat, &ma));
        ASSERT_OK(ctx, ix_mv_transform(ctx, b, mat, &mb));
        ASSERT_OK(ctx, ix_mv_transform(ctx, s, mat, &ms));
        sm = bisector(ctx, ma, mb);
        assert_true(worst_gap(ctx, &r, ms, sm, 1) <= 1e-11);
        ix_mv_unref(ctx, ma);
        ix_mv_unref(ctx, sm);
        ASSERT_OK(ctx, ix_mv_reparam(ctx, a, 0, -40, 13, &ma));
        sm = bisector(ctx, ma, b);
        assert_true(worst_gap(ctx, &r, s, sm, 1) <= 1e-11);
        ix_mv_unref(ctx, sm);
        sm = bisector(ctx, b, a); /* the surface with parameters exchanged */
        ix_mv_unref(ctx, ms);
        ASSERT_OK(ctx, ix_mv_swap_dirs(ctx, sm, 0, 1, &ms));
        assert_true(worst_gap(ctx, &r, s, ms, 1) <= 1e-11);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, s);
        ix_mv_unref(ctx, ma);
        ix_mv_unref(ctx, mb);
        ix_mv_unref(ctx, ms);
        ix_mv_unref(ctx, sm);
    }
    ix_ctx_free(ctx);
}

/* Curves of size 1 at distance 1e6, of size 1e-6 and 1e150: what the input's
 * own rounding (1e-10 of the size, at distance 1e6) leaves. */
static void badly_scaled(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(33);
    const double far[3] = {1e6, -1e6, 5e5};
    const struct {
        double size, tol;
        const double *shift;
    } cases[] = {{1, 1e-8, far}, {1e-6, 1e-12, NULL}, {1e150, 1e-12, NULL}};

    (void)state;
    for (int i = 0; i < 3; i++)
        for (int round = 0; round < 4; round++) {
            ix_mv *a = rand_curve(ctx, &r, 3, round & 1, 0, cases[i].shift,
                                  cases[i].size);
            ix_mv *b = rand_curve(ctx, &r, 2, round & 2, 0, cases[i].shift,
                                  cases[i].size);
            ix_report rep;
            ix_mv *s;

            ASSERT_OK(ctx, ix_cbisector3d(ctx, a, b, NULL, &rep, &s));
            if (!(rep.residual <= cases[i].tol))
                fail_msg("case %d: residual %g", i, rep.residual);
            ix_mv_unref(ctx, a);
            ix_mv_unref(ctx, b);
            ix_mv_unref(ctx, s);
        }
    ix_ctx_free(ctx);
}

/* Value and derivative of a cubic relative to c0. */
static void local_curve(const double *p, bool rational, const double c0[3],
                        double u, double x[3], double d[3])
{
    double v = 1 - u, h[4] = {0}, g[4] = {0};
    const double val[4] = {v * v * v, 3 * v * v * u, 3 * v * u * u, u * u * u},
                 der[4] = {-3 * v * v, 3 * v * v - 6 * v * u,
                           6 * v * u - 3 * u * u, 3 * u * u};

    for (int i = 0; i < 4; i++) {
        double w = rational ? p[i] : 1;

        h[0] += val[i] * w;
        g[0] += der[i] * w;
        for (int k = 0; k < 3; k++) {
            h[k + 1] += val[i] * (p[(k + rational) * 4 + i] - w * c0[k]);
            g[k + 1] += der[i] * (p[(k + rational) * 4 + i] - w * c0[k]);
        }
    }
    for (int k = 0; k < 3; k++) {
        x[k] = h[k + 1] / h[0];
        d[k] = (g[k + 1] - x[k] * g[0]) / h[0];
    }
}

/* Law: curves of size 1 or 1e-6 that are 1 or 2^20 apart: B by three planes
 * around the first curve, to 32 roundings of its distance over the
 * determinant of the planes' unit normals. Rational ones have another 2^8 and
 * are told apart from their distance only to 2^20. */
static void small_and_far_apart(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng rng = ix_rng_new(41);

    (void)state;
    for (int i = 0; i < 48; i++) {
        bool rational = i & 1;
        double size = i & 2 && !(rational && i & 4) ? 1e-6 : 1,
               gap = i & 4 ? 1 << 20 : 1, alpha = i & 8 ? 0.3 : 0.5;
        double c0[2][3] = {{0, 0, 0}, {gap, gap / 2, -gap / 4}}, p[2][16];
        double worst = 0;
        ix_mv *m[2], *s;

        for (int c = 0; c < 2; c++) {
            for (int j = 0; j < 4; j++) {
                const double at[3] = {c ? 0 : j / 3.0, c ? j / 3.0 : 0,
                                      c / 2.0};
                double w = rational ? 1 + 0.25 * (j % 2) : 1;

                p[c][j] = w;
                for (int k = 0; k < 3; k++)
                    p[c][(k + rational) * 4 + j] =
                        w * (c0[c][k] +
                             size * (at[k] + ix_rng_range(&rng, -0.2, 0.2)));
            }
            m[c] = make_curve(ctx, 4, 4, NULL, rational, 3, p[c]);
        }
        ASSERT_OK(ctx,
                  ix_calphasector3d(ctx, m[0], m[1], alpha, NULL, NULL, &s));
        for (int j = 0; j < 9; j++) {
            double t[2] = {(j % 3 + 0.5) / 3, (j / 3 + 0.5) / 3}, x[2][3];
            double r[3][3], h[3], a[3], y[3], det, off = 0, far = gap;

            for (int c = 0; c < 2; c++)
                local_curve(p[c], rational, c0[c], t[c], x[c], r[c]);
            for (int k = 0; k < 3; k++) {
                x[1][k] += c0[1][k];
                r[2][k] = x[1][k] - x[0][k];
                a[k] = (1 - alpha) * x[0][k] + alpha * x[1][k];
            }
            for (int k = 0; k < 3; k++) {
                h[k] = ix__dot3(r[k], k < 2 ? x[k] : a) / ix__len3(r[k]);
                (void)ix__unit3(r[k], r[k]);
            }
            ix__cross3(r[1], r[2], a);
            det = ix__dot3(r[0], a);
            if (fabs(det) < 0.1)
                continue;
            ASSERT_OK(ctx, ix_mv_point(ctx, s, t, y));
            for (int k = 0; k < 3; k++) {
                double b = 0;

                for (int l = 0; l < 3; l++) {
                    ix__cross3(r[(l + 1) % 3], r[(l + 2) % 3], a);
                    b += h[l] * a[k] / det;
                }
                far = fmax(far, fabs(b));
                off = fmax(off, fabs(y[k] - b));
            }
            worst = fmax(worst, off * fabs(det) / far);
        }
        if (!(worst <= (rational ? 8192 : 32) * 2.3e-16))
            fail_msg("case %d: off by %g", i, worst);
        ix_mv_unref(ctx, m[0]);
        ix_mv_unref(ctx, m[1]);
        ix_mv_unref(ctx, s);
    }
    ix_ctx_free(ctx);
}

/* Two skew lines: degree (2, 2) and one weight, so a polynomial surface: the
 * hyperbolic paraboloid. Elber and Kim's example, (1, s, 0) and (0, 0, t),
 * whose bisector is ((1 - s^2 + t^2) / 2, s, t). */
static void skew_lines(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const double p[] = {1, 1, 0, 1, 0, 0}, q[] = {0, 0, 0, 0, 0, 1};
    ix_mv *a = make_curve(ctx, 2, 2, NULL, false, 3, p);
    ix_mv *b = make_curve(ctx, 2, 2, NULL, false, 3, q);
    ix_mv *s = bisector(ctx, a, b);
    double t[2] = {0.3, 0.8}, x[3];

    (void)state;
    assert_true(degree_of(s, 0) == 2 && degree_of(s, 1) == 2);
    for (int i = 0; i < 9; i++)
        ASSERT_CLOSE(ix_mv_weights(s)[i] / ix_mv_weights(s)[0], 1, 1e-15);
    ASSERT_OK(ctx, ix_mv_point(ctx, s, t, x));
    ASSERT_CLOSE(x[0], (1 - 0.09 + 0.64) / 2, 1e-15);
    ASSERT_CLOSE(x[1], 0.3, 1e-15);
    ASSERT_CLOSE(x[2], 0.8, 1e-15);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, s);
    ix_ctx_free(ctx);
}

/* Lines through (0, 0, h) and (0, 0, -h) at half the angle a to both sides of
 * x, feet at the distances s and t: the point of both normal planes has
 *   x = (s + t) / (2 cos a), y = (s - t) / (2 sin a), z = (t^2 - s^2) / (4 h),
 * the hyperbolic paraboloid h z = -cos a sin a x y. Turned and moved at random
 * (rounding over the sine of the angle: 1e-12). */
static void skew_lines_at_an_angle(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(38);

    (void)state;
    for (int i = 0; i < 20; i++) {
        double a = ix_rng_range(&r, 0.2, 1.3), h = ix_rng_range(&r, 0.1, 2);
        double ends[2] = {ix_rng_range(&r, -3, -1), ix_rng_range(&r, 1, 3)};
        double p[6], q[6], mat[16], shift[3] = {1, -2, 3}, st[2], x[3];
        ix_mv *m[2], *n[2], *s;

        for (int k = 0; k < 2; k++) {
            p[k] = q[k] = ends[k] * cos(a);
            p[2 + k] = ends[k] * sin(a);
            q[2 + k] = -p[2 + k];
            p[4 + k] = h;
            q[4 + k] = -h;
        }
        motion(i * 0.4 + 0.5, shift, mat);
        m[0] = make_curve(ctx, 2, 2, NULL, false, 3, p);
        m[1] = make_curve(ctx, 2, 2, NULL, false, 3, q);
        for (int k = 0; k < 2; k++)
            ASSERT_OK(ctx, ix_mv_transform(ctx, m[k], mat, &n[k]));
        s = bisector(ctx, n[0], n[1]);
        assert_true(degree_of(s, 0) == 2 && degree_of(s, 1) == 2);
        for (int j = 0; j < 9; j++) {
            double t[2] = {j % 3 / 2.0, j / 3 / 2.0}, want[3], to[3];

            for (int k = 0; k < 2; k++)
                st[k] = ends[0] + t[k] * (ends[1] - ends[0]);
            want[0] = (st[0] + st[1]) / (2 * cos(a));
            want[1] = (st[0] - st[1]) / (2 * sin(a));
            want[2] = (st[1] * st[1] - st[0] * st[0]) / (4 * h);
            ASSERT_OK(ctx, ix_mv_point(ctx, s, t, x));
            for (int k = 0; k < 3; k++) {
                to[k] = mat[12 + k];
                for (int l = 0; l < 3; l++)
                    to[k] += want[l] * mat[4 * l + k];
            }
            if (!(ix__dist3(x, to) <= 1e-12 * (1 + ix__len3(x))))
                fail_msg("case %d: off by %g", i, ix__dist3(x, to));
        }
        for (int k = 0; k < 2; k++) {
            ix_mv_unref(ctx, m[k]);
            ix_mv_unref(ctx, n[k]);
        }
        ix_mv_unref(ctx, s);
    }
    ix_ctx_free(ctx);
}

/* Elber and Kim's equations (8), (9): the unit circle C and its axis (0, 0, t)
 * have the bisector ((1 + t^2) / 2 C(s), t), of degree (2, 2). The minimal form
 * has (6, 2) and the common factor (1 + s^2)^2 of every circle, |C|^2 being
 * w^2, which the reduction divides out: for the paper's half of the circle and
 * for the whole one in four arcs. */
static void circle_and_axis(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const double line[6] = {0, 0, 0, 0, -2, 3}, zero[3] = {0, 0, 0};
    /* 1 - s^2, 2 s, 1 + s^2 over [-1, 1] */
    const double half[12] = {2, 0, 2, 0, 2, 0, -2, 0, 2, 0, 0, 0};
    ix_mv *axis = make_curve(ctx, 2, 2, NULL, false, 3, line), *c[2];

    (void)state;
    c[0] = make_curve(ctx, 3, 3, NULL, true, 3, half);
    ASSERT_OK(ctx, ix_circle(ctx, zero, 1, &c[1]));
    for (int i = 0; i < 2; i++) {
        ix_mv *s = bisector(ctx, c[i], axis), *low;
        double dom[2];

        assert_true(degree_of(s, 0) == 6 && degree_of(s, 1) == 2);
        ASSERT_OK(ctx, ix_sym_reduce(ctx, s, 0.0, NULL, &low));
        assert_true(degree_of(low, 0) == 2 && degree_of(low, 1) == 2);
        ix_mv_domain(c[i], 0, dom);
        for (int j = 0; j < 25; j++) {
            double u[2] = {dom[0] + (dom[1] - dom[0]) * (j % 5 + 0.5) / 5,
                           j / 5 / 4.0},
                   t = -2 + 5 * u[1], x[3], p[3];

            ASSERT_OK(ctx, ix_mv_point(ctx, c[i], u, p));
            ASSERT_OK(ctx, ix_mv_point(ctx, low, u, x));
            ASSERT_CLOSE(x[0], p[0] * (1 + t * t) / 2, 1e-13);
            ASSERT_CLOSE(x[1], p[1] * (1 + t * t) / 2, 1e-13);
            ASSERT_CLOSE(x[2], t, 1e-13);
        }
        ix_mv_unref(ctx, s);
        ix_mv_unref(ctx, low);
        ix_mv_unref(ctx, c[i]);
    }
    ix_mv_unref(ctx, axis);
    ix_ctx_free(ctx);
}

/* Points of the reference case bisect-curves-3d-bspline (15 digits). */
static void reference_points(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const double kv[] = {0, 0, 0, 0.5, 1, 1, 1};
    const double p[] = {0, 1, 2, 3, 0, 0, 1, 0, 0, 1, 0, 0};
    const double q[] = {0, 0, 2, 3, 0, 1};
    const double want[3][3] = {
        {-0.684881720430107, 1.03601075268817, 1.56398924731183},
        {0.906, 1.597, 1.003},
        {-51.3019999999998, -80.916333333333, 83.516333333333}};
    ix_mv *a = make_curve(ctx, 3, 4, kv, false, 3, p);
    ix_mv *b = make_curve(ctx, 2, 2, NULL, false, 3, q);
    ix_mv *s = bisector(ctx, a, b);

    (void)state;
    for (int i = 0; i < 3; i++) {
        double t[2] = {0.1 + 0.4 * i, 0.3}, x[3];

        ASSERT_OK(ctx, ix_mv_point(ctx, s, t, x));
        for (int k = 0; k < 3; k++)
            ASSERT_CLOSE(x[k], want[i][k], 1e-13);
    }
    assert_int_equal(ix_mv_length(s, 0), 11); /* C0 at the knot: C' is */
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, s);
    ix_ctx_free(ctx);
}

/* The same surface in the degrees of the paper and of IRIT. */
static void degree_forms(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(34);
    ix_mv *a = rand_curve(ctx, &r, 2, true, 0, NULL, 1);
    ix_mv *b = rand_curve(ctx, &r, 3, true, 0, NULL, 1);
    ix_mv *s = bisector(ctx, a, b), *f;
    ix_op_opts o = {IX_FORM_PUBLISHED, INT_MAX};
    ix_report rep;

    (void)state;
    ASSERT_OK(ctx, ix_cbisector3d(ctx, a, b, &o, &rep, &f));
    assert_true(degree_of(f, 0) == 7 && degree_of(f, 1) == 11);
    assert_int_equal(rep.form, IX_FORM_PUBLISHED);
    assert_true(worst_gap(ctx, &r, s, f, 1) <= 1e-12);
    ix_mv_unref(ctx, f);
    o.form = IX_FORM_IRIT;
    ASSERT_OK(ctx, ix_cbisector3d(ctx, a, b, &o, NULL, &f));
    assert_true(degree_of(f, 0) == 10 && degree_of(f, 1) == 15);
    assert_int_equal(ix_mv_dir(f, 0).basis, IX_BSPLINE);
    assert_true(worst_gap(ctx, &r, s, f, 1) <= 1e-12);
    ix_mv_unref(ctx, f);
    o.form = IX_FORM_NAIVE;
    ASSERT_OK(ctx, ix_cbisector3d(ctx, a, b, &o, NULL, &f));
    assert_true(degree_of(f, 0) == 10 && degree_of(f, 1) == 16);
    assert_true(worst_gap(ctx, &r, s, f, 1) <= 1e-12);
    ix_mv_unref(ctx, f);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, s);
    ix_ctx_free(ctx);
}

/* --- sectors -------------------------------------------------------------- */

/* Law: an alpha-sector lies in both normal planes and in the plane that divides
 * C1 C2 in the ratio alpha; 1/2 is the bisector; the degrees are its own. */
static void alpha_sectors(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(37);

    (void)state;
    for (int i = 0; i < 40; i++) {
        bool ra = i & 1, rb = i & 2;
        int da = 1 + i % 3 + ra, db = 2 + i % 2;
        double alpha = ix_rng_range(&r, -1, 2), worst = 0;
        ix_mv *a = rand_curve(ctx, &r, da, ra, 2, NULL, 1);
        ix_mv *b = rand_curve(ctx, &r, db, rb, 0, NULL, 1), *s;
        ix_op_opts o = {(ix_degree_form)(i / 4 % 4), INT_MAX};
        ix_report rep;

        ASSERT_OK(ctx, ix_calphasector3d(ctx, a, b, alpha, &o, &rep, &s));
        if (o.form == IX_FORM_MINIMAL) {
            assert_int_equal(degree_of(s, 0), ra ? 4 * da - 2 : 3 * da - 1);
            assert_int_equal(degree_of(s, 1), rb ? 4 * db - 2 : 3 * db - 1);
        }
        assert_true(rep.residual <= 1e-10);
        for (int j = 0; j < 9; j++) {
            double dom[2], t[2], x[3], p[6], q[6], f[3], g[3], e[3], m[3], w[4];

            ix_mv_domain(a, 0, dom);
            t[0] = dom[0] + (dom[1] - dom[0]) * (j + 0.5) / 9;
            t[1] = (0.3 + j) / 9;
            ASSERT_OK(ctx, ix_mv_eval(ctx, s, t, w));
            if (fabs(w[0]) < 1e-4 || ix_mv_point(ctx, s, t, x) != IX_OK)
                continue;
            ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, a, t[0], 1, p));
            ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, b, t[1], 1, q));
            ix__sub3(x, p, f);
            ix__sub3(x, q, g);
            ix__sub3(q, p, e);
            ix__axpy3(f, -alpha, e, m);
            worst = fmax(worst, fabs(ix__dot3(f, p + 3)) /
                                    (ix__len3(p + 3) * (1 + ix__len3(f))));
            worst = fmax(worst, fabs(ix__dot3(g, q + 3)) /
                                    (ix__len3(q + 3) * (1 + ix__len3(g))));
            worst = fmax(worst, fabs(ix__dot3(m, e)) /
                                    (ix__len3(e) * (1 + ix__len3(m))));
        }
        if (!(worst <= 1e-10))
            fail_msg("case %d, alpha %g: off by %g", i, alpha, worst);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, s);
    }
    ix_ctx_free(ctx);
}

/* Law: two canal surfaces of one radius have the bisector of their spines: a
 * point at the distance h from both spines is h - r from both surfaces. A torus
 * and a cylinder of radius 1/4. */
static void canal_surfaces(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const double line[6] = {0.4, 0.2, 0.1, 0.3, -1, 1}, radius = 0.25;
    const double zero[3] = {0, 0, 0};
    ix_mv *axis = make_curve(ctx, 2, 2, NULL, false, 3, line), *spine, *s;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, zero, 2.0, &spine));
    ASSERT_OK(ctx, ix_cbisector3d(ctx, axis, spine, NULL, NULL, &s));
    for (int i = 0; i < 9; i++) {
        double t[2] = {(i + 0.5) / 9, (i * 5 % 9 + 0.3) / 2.5}, x[3], p[3],
               q[3];
        double torus, cylinder, u[3], v[3];

        if (ix_mv_point(ctx, s, t, x) != IX_OK)
            continue;
        ASSERT_OK(ctx, ix_mv_point(ctx, axis, t, p));
        ASSERT_OK(ctx, ix_mv_point(ctx, spine, t + 1, q));
        /* implicit distances: sqrt((rho - 2)^2 + z^2) - r at the foot's side */
        ix__sub3(x, q, u);
        torus = ix__len3(u) - radius;
        v[0] = (x[0] * q[0] + x[1] * q[1]) / 2 - 2;
        assert_true(fabs(hypot(v[0], x[2]) - radius - torus) <=
                    1e-10 * (1 + torus));
        for (int k = 0; k < 3; k++)
            u[k] = line[2 * k + 1] - line[2 * k];
        (void)ix__unit3(u, u);
        ix__sub3(x, p, v);
        ix__axpy3(v, -ix__dot3(v, u), u, v);
        cylinder = ix__len3(v) - radius;
        assert_true(fabs(torus - cylinder) <= 1e-10 * (1 + torus));
    }
    ix_mv_unref(ctx, s);
    ix_mv_unref(ctx, axis);
    ix_mv_unref(ctx, spine);
    ix_ctx_free(ctx);
}

/* --- degenerate input ----------------------------------------------------- */

static void expect(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, ix_status st,
                   const char *text)
{
    ix_mv *s = NULL;

    assert_int_equal(ix_cbisector3d(ctx, a, b, NULL, NULL, &s), st);
    assert_null(s);
    if (!strstr(ix_ctx_message(ctx), text))
        fail_msg("\"%s\" is not in \"%s\"", text, ix_ctx_message(ctx));
}

/* Coplanar curves in a tilted plane (so with rounded coordinates), planar
 * input of 2 coordinates, parallel lines; a point; the same curve twice,
 * reversed, and on finer knots; surfaces. */
static void degenerate_input(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(35);
    const double shift[3] = {0.1, 0.2, 0.3}, half = 0.5;
    double p[12], q[12], mat[16];
    ix_mv *a, *b, *c, *d;
    ix_dir square[2] = {{IX_BEZIER, 1, 1, false, NULL},
                        {IX_BEZIER, 1, 1, false, NULL}};

    (void)state;
    for (int i = 0; i < 12; i++) {
        p[i] = i < 8 ? ix_rng_range(&r, -1, 1) : 0;
        q[i] = i < 8 ? ix_rng_range(&r, -1, 1) : 0;
    }
    a = make_curve(ctx, 4, 4, NULL, false, 2, p);
    b = make_curve(ctx, 4, 4, NULL, false, 2, q);
    expect(ctx, a, b, IX_EDOMAIN, "in one plane");
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    a = make_curve(ctx, 4, 4, NULL, false, 3, p);
    b = make_curve(ctx, 4, 4, NULL, false, 3, q);
    for (int i = 0; i < 2; i++) {
        motion(i ? 1e-3 : 7.3, shift, mat);
        ASSERT_OK(ctx, ix_mv_transform(ctx, a, mat, &c));
        ASSERT_OK(ctx, ix_mv_transform(ctx, b, mat, &d));
        expect(ctx, c, d, IX_EDOMAIN, "in one plane");
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, d);
    }
    ix_mv_unref(ctx, b);
    b = make_curve(ctx, 2, 2, NULL, false, 3, (double[]){1, 1, 2, 2, 3, 3});
    expect(ctx, a, b, IX_EDOMAIN, "curve 2 is a point");
    expect(ctx, b, a, IX_EDOMAIN, "curve 1 is a point");
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    a = rand_curve(ctx, &r, 3, true, 2, NULL, 1);
    expect(ctx, a, a, IX_EDOMAIN, "both curves are the same");
    ASSERT_OK(ctx, ix_mv_reverse(ctx, a, 0, &b));
    expect(ctx, a, b, IX_EDOMAIN, "one reversed");
    ix_mv_unref(ctx, b);
    ASSERT_OK(ctx, ix_mv_insert_knots(ctx, a, 0, 1, &half, &b));
    expect(ctx, a, b, IX_EDOMAIN, "both curves are the same");
    ix_mv_unref(ctx, b);
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, square, 3, false, p, &b));
    expect(ctx, a, b, IX_EARG, "operand 2");
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_ctx_free(ctx);
}

/* Spans in one plane with a span of the other curve, and a span on which a
 * curve stands still, are named; the other parts have their surface. */
static void degenerate_spans(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const double kv[] = {0, 0, 1, 2, 2};
    /* the first leg is parallel to the line */
    const double bent[] = {0, 1, 1, 0, 0, 1, 0, 0, 1};
    const double still[] = {0, 0, 1, 0, 0, 1, 0, 0, 1};
    const double line[] = {-1, 2, 0, 0, 1, 1};
    ix_mv *a = make_curve(ctx, 2, 3, kv, false, 3, bent), *part, *s;
    ix_mv *b = make_curve(ctx, 2, 2, NULL, false, 3, line);

    (void)state;
    expect(ctx, a, b, IX_EDOMAIN,
           "curve 1 over 0 .. 1 and curve 2 over 0 .. 1 lie in one plane");
    expect(ctx, b, a, IX_EDOMAIN, "and curve 2 over 0 .. 1 lie in one plane");
    ASSERT_OK(ctx, ix_mv_region(ctx, a, 0, 1, 2, &part));
    s = bisector(ctx, part, b);
    ix_mv_unref(ctx, s);
    ix_mv_unref(ctx, part);
    ix_mv_unref(ctx, a);
    a = make_curve(ctx, 2, 3, kv, false, 3, still);
    expect(ctx, a, b, IX_EDOMAIN, "curve 1 stands still over 0 .. 1");
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_ctx_free(ctx);
}

/* Where the curves meet weight and numerators vanish, and the report has the
 * parameters; a part that both share is reported by its ends. */
static void meetings(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(39);
    ix_mv *a, *b, *c, *s;
    ix_report rep;

    (void)state;
    for (int i = 0; i < 12; i++) {
        double t[2] = {0.3, i % 3 ? 0.7 : 0}, p[3], q[3], w[4], top = 0;
        double mat[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

        a = rand_curve(ctx, &r, 3, i & 1, 0, NULL, 1);
        c = rand_curve(ctx, &r, 2, i & 2, 0, NULL, 1);
        ASSERT_OK(ctx, ix_mv_point(ctx, a, t, p));
        ASSERT_OK(ctx, ix_mv_point(ctx, c, t + 1, q));
        for (int k = 0; k < 3; k++)
            mat[12 + k] = p[k] - q[k];
        ASSERT_OK(ctx, ix_mv_transform(ctx, c, mat, &b));
        ASSERT_OK(ctx, ix_cbisector3d(ctx, a, b, NULL, &rep, &s));
        assert_int_equal(rep.nmeetings, 1);
        ASSERT_CLOSE(rep.meetings[0][0], t[0], 1e-9);
        ASSERT_CLOSE(rep.meetings[0][1], t[1], 1e-9);
        assert_true(rep.overlap[0][0] == rep.overlap[0][1]);
        ASSERT_OK(ctx, ix_mv_eval(ctx, s, t, w));
        for (size_t k = 0; k < ix_mv_npts(s); k++)
            top = fmax(top, fabs(ix_mv_weights(s)[k]));
        for (int k = 0; k < 4; k++)
            assert_true(fabs(w[k]) <= 1e-13 * top * (1 + ix__len3(p)));
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, s);
    }
    c = rand_curve(ctx, &r, 3, true, 0, NULL, 1);
    ASSERT_OK(ctx, ix_mv_region(ctx, c, 0, 0, 0.6, &a));
    ASSERT_OK(ctx, ix_mv_region(ctx, c, 0, 0.3, 1, &b));
    ASSERT_OK(ctx, ix_cbisector3d(ctx, a, b, NULL, &rep, &s));
    assert_int_equal(rep.nmeetings, 0);
    for (int i = 0; i < 2; i++) {
        double dom[2][2], x[3], y[3];

        ix_mv_domain(a, 0, dom[0]);
        ix_mv_domain(b, 0, dom[1]);
        ASSERT_CLOSE(rep.overlap[i][1 - i], dom[i][1 - i], 1e-9);
        ASSERT_OK(ctx, ix_mv_point(ctx, a, &rep.overlap[0][i], x));
        ASSERT_OK(ctx, ix_mv_point(ctx, b, &rep.overlap[1][i], y));
        assert_true(ix__dist3(x, y) <= 1e-12);
    }
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, s);
    ix_ctx_free(ctx);
}

/* --- memory --------------------------------------------------------------- */

typedef struct {
    ix_mv *a, *b, *out;
} operands;

static void make(ix_ctx *ctx, void *state)
{
    operands *o = state;
    ix_rng r = ix_rng_new(36);

    o->a = rand_curve(ctx, &r, 3, true, 3, NULL, 1);
    o->b = rand_curve(ctx, &r, 2, false, 0, NULL, 1);
    o->out = NULL;
}

static ix_status run(ix_ctx *ctx, void *state)
{
    operands *o = state;
    ix_report rep;
    ix_status st = ix_cbisector3d(ctx, o->a, o->b, NULL, &rep, &o->out);

    assert_true((st == IX_OK) == (o->out != NULL));
    return st;
}

static void release(ix_ctx *ctx, void *state)
{
    operands *o = state;

    ix_mv_unref(ctx, o->a);
    ix_mv_unref(ctx, o->b);
    ix_mv_unref(ctx, o->out);
}

static void memory_may_fail(void **state)
{
    operands o;
    ix_fault_case c = {make, run, release, &o};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(definition_holds),
        cmocka_unit_test(follows_motions_and_parameters),
        cmocka_unit_test(badly_scaled),
        cmocka_unit_test(small_and_far_apart),
        cmocka_unit_test(skew_lines),
        cmocka_unit_test(skew_lines_at_an_angle),
        cmocka_unit_test(circle_and_axis),
        cmocka_unit_test(reference_points),
        cmocka_unit_test(degree_forms),
        cmocka_unit_test(alpha_sectors),
        cmocka_unit_test(canal_surfaces),
        cmocka_unit_test(degenerate_input),
        cmocka_unit_test(degenerate_spans),
        cmocka_unit_test(meetings),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
