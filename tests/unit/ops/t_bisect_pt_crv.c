/* The true bisector of a point and a curve: by the definition on random curves,
 * against the closed forms of Farouki and Johnstone, convex. */
#include "harness/fault.h"
#include "plane_test.h"

static void free_all(ix_ctx *ctx, ix_bisector *s, brute *b, ix_mv *c)
{
    ix_bisector_free(ctx, s);
    free(b->x);
    ix_mv_unref(ctx, c);
}

/* The bisector turns left all along, seen in the order of its pieces. 1e-10:
 * a vertex is equally far within 1e-13, and that far off where both feet are
 * close to each other. */
static void check_convex(const ix_bisector *s, int id)
{
    double p[2] = {0, 0}, d[2] = {0, 0};
    int have = 0;

    for (int i = 0; i < s->n; i++) {
        if (!s->piece[i].joined)
            have = 0;
        for (int j = 0; j < s->piece[i].n; j++) {
            const double *x = s->piece[i].x + 2 * j;
            double e[2] = {x[0] - p[0], x[1] - p[1]}, l = hypot(e[0], e[1]);

            if (have && l < 1e-7 * (s->size + hypot(x[0], x[1])))
                continue;
            if (have > 1 && !(d[0] * e[1] - d[1] * e[0] >=
                              -1e-10 * (s->size + hypot(x[0], x[1]))))
                fail_msg("curve %d: turns right at (%g, %g) by %g", id, p[0],
                         p[1], d[0] * e[1] - d[1] * e[0]);
            if (have)
                d[0] = e[0] / l, d[1] = e[1] / l;
            have++;
            p[0] = x[0];
            p[1] = x[1];
        }
    }
}

/* Points of the exact pieces are as far from q as from the curve. */
static void check_exact(ix_ctx *ctx, const ix_bisector *s, const brute *c,
                        const double q[2])
{
    for (int i = 0; i < s->n; i++) {
        const ix_mv *m = s->piece[i].exact;
        double dom[2], x[2], d, e;

        assert_non_null(m);
        ix_mv_domain(m, 0, dom);
        for (int j = 1; j < 6; j++) {
            double t = dom[0] + j * (dom[1] - dom[0]) / 6;

            ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, x));
            d = hypot(x[0] - q[0], x[1] - q[1]);
            e = brute_distance(ctx, c, x, true);
            if (!(fabs(d - e) <= 1e-9 * (s->size + d)))
                fail_msg("piece %d at %g: %.15g from the point, %.15g from "
                         "the curve",
                         i, t, d, e);
        }
    }
}

/* Law: each vertex is as far from q as from the whole curve (1e-11: brute
 * force finds feet to 1e-13 of the parameter), each point that is as far lies
 * on the result (5e-4: five times the tolerance of the polylines), which
 * bounds a convex region. */
static void by_definition(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(701);

    (void)state;
    for (int i = 0; i < 14; i++) {
        crv_kind k = {1 + i % 5, 2, i & 1, i % 3 ? 0 : 4, 0, 1};
        ix_mv *c = rand_crv(ctx, &r, &k);
        const ix_mv *list[1] = {c};
        double q[2] = {ix_rng_range(&r, -1.5, 1.5), ix_rng_range(&r, -1, 1)};
        brute b, point = {.point = {q[0], q[1]}};
        ix_bisector s;
        double w;

        ASSERT_OK(ctx, ix_bisect_pt_crv(ctx, c, q, false, 0, &s));
        b = brute_of(ctx, 1, list);
        w = worst_vertex(ctx, &s, &point, &b, 9);
        if (!(w <= 1e-11))
            fail_msg("curve %d: %g off", i, w);
        w = worst_missing(ctx, &r, &s, &point, &b, 2, 3);
        if (!(w <= 5e-4))
            fail_msg("curve %d: %g is missing", i, w);
        check_convex(&s, i);
        check_exact(ctx, &s, &b, q);
        free_all(ctx, &s, &b, c);
    }
    ix_ctx_free(ctx);
}

/* --- the examples of the paper ---------------------------------------------
 */

/* A curve whose coordinates are monomials: w, x, y as sums of c_i u^i, i <= d,
 * over u in [-a, a]. */
static ix_mv *monomials(ix_ctx *ctx, int d, double a, const double (*c)[5],
                        bool rational)
{
    double pts[15];
    int n = d + 1, row = 0;

    for (int k = rational ? 0 : 1; k < 3; k++, row++)
        for (int j = 0; j < n; j++) { /* blossom at j times a, d - j times -a */
            double e[6] = {1}, s = 0, bin = 1;

            for (int i = 0; i < d; i++)
                for (int m = i + 1; m > 0; m--)
                    e[m] = (m <= i ? e[m] : 0) + (i < j ? a : -a) * e[m - 1];
            for (int i = 0; i <= d; i++) {
                s += c[k][i] * e[i] / bin;
                bin = bin * (d - i) / (i + 1);
            }
            pts[row * n + j] = s;
        }
    return make_crv(ctx, n, n, NULL, rational, 2, pts);
}

static double poly(int n, const double *c, double u)
{
    double s = 0;

    for (int i = n; i >= 0; i--)
        s = s * u + c[i];
    return s;
}

/* The polynomial p of degree n vanishes, and nowhere else in [-a, a], at the
 * special points of a kind (parameters t of [0, 1]). Relative to its size
 * 1e-9, as the roots are good to 1e-12 and slopes are up to 100 times that. */
static void same_roots(const char *what, const ix_pt_crv_special *s, int count,
                       ix_pt_crv_mark mark, double a, int n, const double *p,
                       bool all)
{
    double size = 0;
    int changes = 0, found = 0;

    for (int i = 0; i <= 4000; i++) {
        double u = a * ((i + 0.37) / 2000.5 - 1);
        double v = a * ((i + 1.37) / 2000.5 - 1);

        size = fmax(size, fabs(poly(n, p, u)));
        changes += i < 4000 && poly(n, p, u) * poly(n, p, v) < 0;
    }
    for (int i = 0; i < count; i++) {
        double u = a * (2 * s[i].t - 1);

        if (s[i].mark != mark)
            continue;
        found++;
        if (!(fabs(poly(n, p, u)) <= 1e-9 * size))
            fail_msg("%s: %g at u = %.15g, size %g", what, poly(n, p, u), u,
                     size);
    }
    if (all ? found != changes : found > changes)
        fail_msg("%s: %d points, the polynomial has %d", what, found, changes);
}

static const double points[][2] = {{0.3, 0.9},  {-0.2, 0.4}, {0.7, 0.1},
                                   {0.1, 1.7},  {0.45, 0.3}, {-0.6, 1.2},
                                   {0.15, -0.4}};
enum { NPOINTS = sizeof points / sizeof *points };

/* Parabola (u, u^2): (41), (64), (85); crossings pair in (86). */
static void parabola(void **state)
{
    static const double c[3][5] = {{1}, {0, 1}, {0, 0, 1}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = monomials(ctx, 2, 2, c, false);

    (void)state;
    for (int i = 0; i < NPOINTS; i++) {
        double a = points[i][0], b = points[i][1];
        const double inf[3] = {b, -2 * a, 1};
        const double cusp[5] = {-(a * a + b * b - b), 0, 6 * b, -8 * a, 3};
        const double self[5] = {a * a + b * b - b, 0, -2 * b, 0, 1};
        ix_pt_crv_special *s;
        int n;

        ASSERT_OK(ctx, ix_pt_crv_specials(ctx, m, points[i], &s, &n));
        same_roots("(41)", s, n, IX_CLASS_POINT, 2, 2, inf, true);
        same_roots("(64)", s, n, IX_CUSP, 2, 4, cusp, true);
        same_roots("(85)", s, n, IX_CROSSING, 2, 4, self, true);
        for (int j = 0; j < n; j++)
            if (s[j].mark == IX_CROSSING) /* symmetric: on the axis */
                assert_true(fabs(s[j].t + s[j].other - 1) <= 1e-12 &&
                            fabs(s[j].b[0]) <= 1e-12);
        ix_pt_crv_specials_free(ctx, s, n);
    }
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* Ellipse with semi-axes 1 and k (42): (44), (65), (88). The last coefficient
 * pair of (65) as printed. */
static void ellipse(void **state)
{
    enum { A = 3 };
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int i = 0; i < NPOINTS; i++) {
        double k = i & 1 ? 1.6 : 0.6, a = points[i][0], b = points[i][1];
        const double c[3][5] = {{1, 0, 1}, {1, 0, -1}, {0, 2 * k}};
        double q = a * a + b * b, e = 2 * (1 - k * k), f = 1 - 2 * k * k;
        const double inf[3] = {k * (a - 1), 2 * b, -k * (a + 1)};
        const double cusp[7] = {k * (q - e * a + f),
                                0,
                                3 * k * (q + e * a - 3 + 2 * k * k),
                                8 * e * b,
                                3 * k * (q - e * a - 3 + 2 * k * k),
                                0,
                                k * (q + e * a + f)};
        const double self1[5] = {q - e * a + f, 0, 2 * (q - 1), 0,
                                 q + e * a + f};
        const double self2[5] = {k * (q - 1), 2 * e * b,
                                 2 * k * (q - 3 + 2 * k * k), 2 * e * b,
                                 k * (q - 1)};
        double self[9] = {0};
        ix_mv *m = monomials(ctx, 2, A, c, true);
        ix_pt_crv_special *s;
        int n;

        for (int x = 0; x < 5; x++)
            for (int y = 0; y < 5; y++)
                self[x + y] += self1[x] * self2[y];
        ASSERT_OK(ctx, ix_pt_crv_specials(ctx, m, points[i], &s, &n));
        same_roots("(44)", s, n, IX_CLASS_POINT, A, 2, inf, true);
        same_roots("(65)", s, n, IX_CUSP, A, 6, cusp, true);
        same_roots("(88)", s, n, IX_CROSSING, A, 8, self, false);
        ix_pt_crv_specials_free(ctx, s, n);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

/* (95): the parameters of all self-intersections of the bisector of (a, b) and
 * (u, u^3), of which the real ones at finite points are crossings. */
static void quartic_pairs(double a, double b, double *p)
{
    double a2 = a * a, b2 = b * b, a4 = a2 * a2, b4 = b2 * b2, q = a2 + b2;
    const double c[25] = {
        27 * q * q * q * q - 256 * b4,
        -72 * q * (3 * a * q * q - 16 * b2 * b),
        12 * (9 * (7 * a4 * a2 - 3 * a4 * b2 - 27 * a2 * b4 - 17 * b4 * b2) +
              64 * a * b2 * b),
        4 * (243 * b * q * q * q - 54 * a * (7 * a4 + 22 * a2 * b2 + 15 * b4) -
             224 * b2 * b),
        18 * (324 * a * b * q * q + 105 * a4 + 210 * a2 * b2 + 41 * b4),
        -36 * (99 * a * q * q * q + 3 * b * (81 * a4 + 50 * a2 * b2 - 31 * b4) +
               2 * a * (21 * a2 - 19 * b2)),
        12 * (9 * (59 * a4 * a2 + 77 * a4 * b2 - 23 * a2 * b4 - 41 * b4 * b2) +
              36 * a * b * (13 * a2 + 17 * b2) + 63 * a2 - 89 * b2),
        -108 * (a * (57 * a4 + 290 * a2 * b2 + 233 * b4) +
                b * (57 * a2 + 41 * b2) + 2 * a),
        9 * (2664 * a * b * q * q + 12 * (57 * a4 + 234 * a2 * b2 + 65 * b4) +
             520 * a * b + 3),
        -4 * (27 * b * (253 * a4 + 234 * a2 * b2 - 19 * b4) + 945 * a * q +
              293 * b),
        -36 * (108 * a2 * q * q - 24 * a * b * (29 * a2 + 45 * b2) - 7 * a2 +
               5 * b2),
        -12 * (27 * a * (5 * a4 + 186 * a2 * b2 + 181 * b4) +
               18 * b * (117 * a2 + 85 * b2) - 53 * a),
        2 * (27 * (79 * a4 + 894 * a2 * b2 + 303 * b4) + 5724 * a * b - 86),
        36 * (432 * a2 * b * q + 12 * a * (7 * a2 - 57 * b2) - 43 * b),
        108 * (36 * a * b * (5 * a2 + 17 * b2) - 31 * a2 + 101 * b2),
        -108 * (b * (241 * a2 + 305 * b2) + a),
        -54 * (144 * a2 * (a2 + 3 * b2) - 100 * a * b - 7),
        108 * (3 * a * (11 * a2 - 101 * b2) - 5 * b),
        108 * (23 * a2 + 235 * b2),
        108 * a * (144 * a * b - 1),
        540 * (6 * a * b - 1),
        -8100 * b,
        -3888 * a2,
        1620 * a,
        675};

    memcpy(p, c, sizeof c);
}

/* Cubic (u, u^3): (95), (96). */
static void cubic(void **state)
{
    static const double c[3][5] = {{1}, {0, 1}, {0, 0, 0, 1}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = monomials(ctx, 3, 1.25, c, false);

    (void)state;
    for (int i = 0; i < NPOINTS; i++) {
        double a = points[i][0], b = points[i][1], self[25];
        const double inf[4] = {b, 0, -3 * a, 2};
        const double cusp[8] = {
            b, -3 * (a * a + b * b), 3 * a, -1, 15 * b, 0, -27 * a, 15};
        ix_pt_crv_special *s;
        int n;

        quartic_pairs(a, b, self);
        ASSERT_OK(ctx, ix_pt_crv_specials(ctx, m, points[i], &s, &n));
        same_roots("(96) first", s, n, IX_CLASS_POINT, 1.25, 3, inf, true);
        same_roots("(96) second", s, n, IX_CUSP, 1.25, 7, cusp, true);
        same_roots("(95)", s, n, IX_CROSSING, 1.25, 24, self, false);
        ix_pt_crv_specials_free(ctx, s, n);
    }
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* Crossings of the superbola (u, u^4) and of cubics come in pairs of equal
 * points of the untrimmed bisector. */
static void crossings_are_pairs(void **state)
{
    static const double c[3][5] = {{1}, {0, 1}, {0, 0, 0, 0, 1}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = monomials(ctx, 4, 1.3, c, false);
    int pairs = 0;

    (void)state;
    for (int i = 0; i < NPOINTS; i++) {
        ix_pt_crv_special *s;
        int n;

        ASSERT_OK(ctx, ix_pt_crv_specials(ctx, m, points[i], &s, &n));
        for (int j = 0; j < n; j++)
            for (int k = 0; k < j; k++) {
                double size = 1 + hypot(s[j].b[0], s[j].b[1]);

                if (s[j].mark != IX_CROSSING || s[k].mark != IX_CROSSING ||
                    s[k].t != s[j].other)
                    continue;
                pairs++;
                assert_true(s[j].t == s[k].other);
                if (!(hypot(s[j].b[0] - s[k].b[0], s[j].b[1] - s[k].b[1]) <=
                      1e-10 * size))
                    fail_msg("point %d: (%.15g, %.15g) and (%.15g, %.15g)", i,
                             s[j].b[0], s[j].b[1], s[k].b[0], s[k].b[1]);
            }
        ix_pt_crv_specials_free(ctx, s, n);
    }
    assert_true(pairs >= 7);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* An extraordinary point: the parabola and a point of its vertex' circle of
 * curvature (87); the bisector passes (0, 1/2) there. */
static void extraordinary(void **state)
{
    static const double c[3][5] = {{1}, {0, 1}, {0, 0, 1}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = monomials(ctx, 2, 2, c, false);
    const double q[2] = {0.5, 0.5};
    ix_pt_crv_special *s;
    int n, found = 0;

    (void)state;
    ASSERT_OK(ctx, ix_pt_crv_specials(ctx, m, q, &s, &n));
    for (int i = 0; i < n; i++)
        if (s[i].mark == IX_EXTRAORDINARY) {
            found++;
            /* a double root: half the digits */
            assert_true(fabs(s[i].t - 0.5) <= 1e-7);
            assert_true(fabs(s[i].b[0]) <= 1e-7 &&
                        fabs(s[i].b[1] - 0.5) <= 1e-7);
        }
    assert_int_equal(found, 1);
    ix_pt_crv_specials_free(ctx, s, n);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* --- the two meanings ------------------------------------------------------
 */

/* Trimmed against the whole carrier a parabola's arc has the trim points (86)
 * and (41) of the paper, and is a part of the whole parabola's bisector. */
static void whole_parabola(void **state)
{
    static const double c[3][5] = {{1}, {0, 1}, {0, 0, 1}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = monomials(ctx, 2, 0.5, c, false);
    const double in[2] = {0.1, 0.6}, out[2] = {0.9, 0.1};
    ix_bisector s;

    (void)state;
    /* inside: from -u to u, u^2 = b - sqrt(b - a^2): 0 < it < 1/4 here? the
       outer pair is beyond the arc, the inner one trims nothing off it */
    ASSERT_OK(ctx, ix_bisect_pt_crv(ctx, m, in, true, 0, &s));
    assert_true(s.n >= 1);
    for (int i = 0; i < s.n; i++)
        for (int j = 0; j < s.piece[i].n; j++) {
            const double *x = s.piece[i].x + 2 * j;
            double d = hypot(x[0] - in[0], x[1] - in[1]), least = INFINITY;

            assert_int_equal(s.piece[i].kind, IX_POINT_CURVE);
            for (int k = -4000; k <= 4000; k++) {
                double u = k / 1000.0;

                least = fmin(least, hypot(x[0] - u, x[1] - u * u));
            }
            /* 1e-6: sampled at 1e-3, squared over twice the distance */
            if (!(fabs(least - d) <= 2e-6))
                fail_msg("(%g, %g): %g and %g", x[0], x[1], d, least);
        }
    ix_bisector_free(ctx, &s);
    ASSERT_OK(ctx, ix_bisect_pt_crv(ctx, m, out, true, 0, &s));
    /* outside: the infinite point (41) u = a - sqrt(a^2 - b) is on the arc */
    {
        double u = 0.9 - sqrt(0.9 * 0.9 - 0.1);
        bool seen = false;

        for (int i = 0; i < s.n; i++) {
            const ix_bisector_piece *p = &s.piece[i];

            for (int e = 0; e < 2; e++)
                if (p->unbounded[e]) {
                    double w[3], dom[2], t[2] = {-0.5, 0.5};

                    ix_mv_domain(p->exact, 0, dom);
                    ASSERT_OK(ctx, ix_mv_eval(ctx, p->exact, &dom[e], w));
                    assert_true(w[0] == 0);
                    (void)t;
                    seen = true;
                    /* normal to the tangent through the point */
                    assert_true(fabs(p->dir[e][0] * 1 + p->dir[e][1] * 2 * u) <=
                                1e-6);
                }
        }
        assert_true(seen);
    }
    ix_bisector_free(ctx, &s);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* A semicircle as its carrier: with the whole circle the bisector is the conic
 * |b| + |b - q| = 1 (7), as far as its feet are on the arc. */
static void whole_circle(void **state)
{
    const double a[3] = {1, 0, 0}, o[3] = {0, 0, 0}, z[3] = {0, 1, 0};
    const double q[2] = {0.3, -0.2};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_bisector s;
    double feet = 0;
    ix_mv *m;

    (void)state;
    ASSERT_OK(ctx, ix_arc(ctx, a, o, z, &m));
    ASSERT_OK(ctx, ix_bisect_pt_crv(ctx, m, q, true, 0, &s));
    for (int i = 0; i < s.n; i++) {
        assert_int_equal(s.piece[i].kind, IX_POINT_CURVE);
        feet += fabs(s.piece[i].foot[2 * s.piece[i].n - 1] -
                     s.piece[i].foot[1]);
        for (int j = 0; j < s.piece[i].n; j++) {
            const double *x = s.piece[i].x + 2 * j;

            ASSERT_CLOSE(hypot(x[0], x[1]) + hypot(x[0] - q[0], x[1] - q[1]), 1,
                         1e-13);
        }
    }
    ASSERT_CLOSE(feet, 1, 1e-12); /* each point of the arc is a foot once */
    ix_bisector_free(ctx, &s);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* A closed curve: the foot passes the place where it begins; there the pieces
 * are divided, so that each is exact over its own parameters. */
static void closed_curve(void **state)
{
    const double o[3] = {0, 0, 0}, q[2] = {0.3, 0.2};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_bisector s;
    double feet = 0;
    ix_mv *m;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, o, 1, &m));
    {
        const ix_mv *const list[1] = {m};
        brute b = brute_of(ctx, 1, list);

        ASSERT_OK(ctx, ix_bisect_pt_crv(ctx, m, q, false, 0, &s));
        check_exact(ctx, &s, &b, q);
        free(b.x);
    }
    assert_true(s.closed);
    for (int i = 0; i < s.n; i++) {
        feet += fabs(s.piece[i].foot[2 * s.piece[i].n - 1] -
                     s.piece[i].foot[1]);
        assert_int_equal(s.piece[i].component, 0);
    }
    ASSERT_CLOSE(feet, 4, 1e-6);
    ix_bisector_free(ctx, &s);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* A line as whole carrier: the parabola with focus q goes on to infinity. */
static void line(void **state)
{
    static const double pts[4] = {-1, 1, 0, 0};
    const double q[2] = {0, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = make_crv(ctx, 2, 2, NULL, false, 2, pts);
    ix_bisector s;

    (void)state;
    ASSERT_OK(ctx, ix_bisect_pt_crv(ctx, m, q, false, 0, &s));
    assert_int_equal(s.n, 3); /* half-line, parabola, half-line */
    assert_int_equal(s.piece[0].kind, IX_POINT_POINT);
    assert_int_equal(s.piece[1].kind, IX_POINT_CURVE);
    assert_int_equal(s.piece[2].kind, IX_POINT_POINT);
    assert_true(s.piece[0].unbounded[0] && s.piece[2].unbounded[1]);
    assert_true(!s.closed && s.piece[1].joined && s.piece[2].joined);
    for (int j = 0; j < s.piece[1].n; j++) {
        const double *x = s.piece[1].x + 2 * j;

        ASSERT_CLOSE(x[1], (x[0] * x[0] + 1) / 2, 1e-14);
    }
    ix_bisector_free(ctx, &s);
    ASSERT_OK(ctx, ix_bisect_pt_crv(ctx, m, q, true, 0, &s));
    assert_int_equal(s.n, 1);
    assert_int_equal(s.piece[0].kind, IX_POINT_CURVE);
    ix_bisector_free(ctx, &s);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* --- the point on the curve ------------------------------------------------
 */

static void on_the_curve(void **state)
{
    static const double c[3][5] = {{1}, {0, 1}, {0, 0, 1}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = monomials(ctx, 2, 2, c, false);
    const double q[2] = {0.5, 0.25}, vertex[2] = {0, 0}, end[2] = {2, 4};
    ix_bisector s;

    (void)state;
    ASSERT_OK(ctx, ix_bisect_pt_crv(ctx, m, q, false, 0, &s));
    assert_int_equal(s.n, 2); /* outside to infinity, inside to the axis */
    for (int i = 0; i < 2; i++) {
        const double *x = s.piece[i].x;

        assert_int_equal(s.piece[i].kind, IX_POINT_POINT);
        ASSERT_CLOSE(s.piece[i].foot[1], 0.625, 1e-12);
        assert_true(x[0] == q[0] && x[1] == q[1]);
        if (s.piece[i].unbounded[1])
            assert_true(x[2] > 0.5 && x[3] < 0.25);
        else /* the normal y = 3/4 - x meets the axis in (0, 3/4) */
            assert_true(fabs(x[2]) <= 1e-9 && fabs(x[3] - 0.75) <= 1e-9);
    }
    ix_bisector_free(ctx, &s);
    /* at the vertex the circle of curvature is the limit */
    ASSERT_OK(ctx, ix_bisect_pt_crv(ctx, m, vertex, false, 0, &s));
    assert_int_equal(s.n, 2);
    for (int i = 0; i < 2; i++)
        if (!s.piece[i].unbounded[1])
            assert_true(fabs(s.piece[i].x[3] - 0.5) <= 1e-9);
    ix_bisector_free(ctx, &s);
    ASSERT_OK(ctx, ix_bisect_pt_crv(ctx, m, end, false, 0, &s));
    assert_int_equal(s.n, 2); /* they bound a region */
    ix_bisector_free(ctx, &s);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* --- errors ----------------------------------------------------------------
 */

static void errors(void **state)
{
    static const double pts[4] = {-1, 1, 0, 0}, same[4] = {1, 1, 2, 2};
    const double q[2] = {0, 1}, bad[2] = {NAN, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m = make_crv(ctx, 2, 2, NULL, false, 2, pts);
    ix_mv *one = make_crv(ctx, 2, 2, NULL, false, 1, pts);
    ix_mv *point = make_crv(ctx, 2, 2, NULL, false, 2, same);
    ix_pt_crv_special *sp;
    ix_bisector s;
    int n;

    (void)state;
    assert_int_equal(ix_bisect_pt_crv(ctx, m, bad, false, 0, &s), IX_EARG);
    assert_int_equal(ix_bisect_pt_crv(ctx, m, q, false, -1, &s), IX_EARG);
    assert_int_equal(ix_bisect_pt_crv(ctx, m, q, false, NAN, &s), IX_EARG);
    assert_int_equal(ix_bisect_pt_crv(ctx, one, q, false, 0, &s), IX_EARG);
    assert_int_equal(ix_bisect_pt_crv(ctx, point, q, false, 0, &s), IX_EDOMAIN);
    assert_int_equal(ix_pt_crv_specials(ctx, m, bad, &sp, &n), IX_EARG);
    assert_int_equal(ix_pt_crv_specials(ctx, one, q, &sp, &n), IX_EARG);
    ix_mv_unref(ctx, m);
    ix_mv_unref(ctx, one);
    ix_mv_unref(ctx, point);
    ix_ctx_free(ctx);
}

typedef struct {
    ix_mv *m;
    ix_pt_crv_special *sp;
    ix_bisector s;
    int n;
} fault_state;

static void fault_setup(ix_ctx *ctx, void *state)
{
    static const double pts[6] = {-1, 0, 1, 0, 1.5, 0};
    fault_state *f = state;

    *f = (fault_state){.m = make_crv(ctx, 3, 3, NULL, false, 2, pts)};
}

static ix_status fault_both(ix_ctx *ctx, void *state)
{
    const double q[2] = {0.1, 0.4};
    fault_state *f = state;
    ix_status st = ix_bisect_pt_crv(ctx, f->m, q, false, 0.01, &f->s);

    return st == IX_OK ? ix_pt_crv_specials(ctx, f->m, q, &f->sp, &f->n) : st;
}

static void fault_teardown(ix_ctx *ctx, void *state)
{
    fault_state *f = state;

    ix_pt_crv_specials_free(ctx, f->sp, f->n);
    ix_bisector_free(ctx, &f->s);
    ix_mv_unref(ctx, f->m);
    *f = (fault_state){0};
}

static void no_memory(void **state)
{
    fault_state f = {0};
    ix_fault_case c = {fault_setup, fault_both, fault_teardown, &f};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(by_definition),
        cmocka_unit_test(parabola),
        cmocka_unit_test(ellipse),
        cmocka_unit_test(cubic),
        cmocka_unit_test(crossings_are_pairs),
        cmocka_unit_test(extraordinary),
        cmocka_unit_test(whole_parabola),
        cmocka_unit_test(whole_circle),
        cmocka_unit_test(closed_curve),
        cmocka_unit_test(line),
        cmocka_unit_test(on_the_curve),
        cmocka_unit_test(errors),
        cmocka_unit_test(no_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
