/* The true bisector of two objects: by the definition on random curves,
 * against closed forms, its components counted. */
#include "harness/fault.h"
#include "iritx/distance.h"
#include "plane_test.h"

/* Law: each vertex is equally far from both whole curves (1e-10 of the size:
 * brute force golden sections at 1e-13 of a parameter, with curves of size 2),
 * each point that is equally far is on the result (5e-4: five times the
 * tolerance). */
static void check(ix_ctx *ctx, ix_rng *r, const ix_mv *a, const ix_mv *b,
                  int id)
{
    const ix_mv *const pa[1] = {a}, *const pb[1] = {b};
    brute ba, bb;
    ix_bisector s;
    double w;

    ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, pa, 1, pb, 0, &s));
    ba = brute_of(ctx, 1, pa);
    bb = brute_of(ctx, 1, pb);
    w = worst_vertex(ctx, &s, &ba, &bb, 40);
    if (!(w <= 1e-10))
        fail_msg("pair %d: vertices are %g off", id, w);
    w = worst_missing(ctx, r, &s, &ba, &bb, 1, 2.5);
    if (!(w <= 5e-4))
        fail_msg("pair %d: %g is missing", id, w);
    ix_bisector_free(ctx, &s);
    free(ba.x);
    free(bb.x);
}

static void by_definition(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(711);

    (void)state;
    for (int i = 0; i < 12; i++) {
        crv_kind k = {1 + i % 4, 2, i & 1, i % 3 ? 0 : 4, 0, 1}, l = k;
        ix_mv *a, *b;

        l.degree = 1 + (i + i / 4) % 4;
        l.spans = i % 5 == 1 ? 3 : 0;
        l.at = i % 2 ? 0.9 : 0; /* beside the first, or across it */
        a = rand_crv(ctx, &r, &k);
        b = rand_crv(ctx, &r, &l);
        check(ctx, &r, a, b, i);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
    }
    ix_ctx_free(ctx);
}

/* Law: two disjoint segments have one bisector from infinity to infinity, or
 * around one of them. Of degree 2 they have eight components at most here (of
 * 3000 random pairs 49 had eight, none more). */
static void disjoint_quadratics(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(712);
    int most = 0, seen = 0;

    (void)state;
    while (seen < 40) {
        crv_kind k = {2, 2, seen & 1, 0, 0, 1};
        ix_mv *a = rand_crv(ctx, &r, &k), *b = rand_crv(ctx, &r, &k);
        const ix_mv *const pa[1] = {a}, *const pb[1] = {b};
        ix_distance d;
        ix_bisector s;

        ASSERT_OK(ctx, ix_distance_least(ctx, a, b, &d));
        if (d.distance > 0.05) {
            int n;

            ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, pa, 1, pb, 0.001, &s));
            assert_true(s.n > 0);
            for (int i = 1; i < s.n; i++)
                if (!s.piece[i].joined)
                    fail_msg("pair %d: piece %d is not joined", seen, i);
            if (!s.closed &&
                !(s.piece[0].unbounded[0] && s.piece[s.n - 1].unbounded[1]))
                fail_msg("pair %d ends somewhere", seen);
            n = s.piece[s.n - 1].component + 1;
            if (n > 8)
                fail_msg("pair %d: %d components", seen, n);
            most = n > most ? n : most;
            ix_bisector_free(ctx, &s);
            seen++;
        }
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
    }
    assert_true(most >= 5);
    ix_ctx_free(ctx);
}

typedef struct {
    double a[6], b[6];
    int n;
    ix_bisector_kind kind[8];
    ix_end_class end[4];
} counted;

/* Seven components, as Adamou et al. draw them, and eight, which their theorem
 * 3 excludes: each between objects of its own, and far from small. */
static const counted examples[] = {
    {{-0.8, -1.8, 0.1, 0.6, -0.6, 1.7},
     {0, 0.8, -0.7, -1.5, 1.2, 0.3},
     7,
     {IX_POINT_CURVE, IX_CURVE_CURVE, IX_POINT_CURVE, IX_CURVE_CURVE,
      IX_POINT_CURVE, IX_CURVE_CURVE, IX_POINT_CURVE},
     {IX_END_ONE_FOOT, IX_END_ONE_FOOT, IX_END_ONE_FOOT, IX_END_ONE_FOOT}},
    {{-0.28, 0.27, -0.42, 0.12, 0.84, -0.11},
     {-0.27, 0.62, -0.96, -0.07, -0.05, -0.45},
     8,
     {IX_CURVE_CURVE, IX_POINT_CURVE, IX_CURVE_CURVE, IX_POINT_CURVE,
      IX_CURVE_CURVE, IX_POINT_CURVE, IX_POINT_POINT, IX_POINT_CURVE},
     {IX_END_FREE, IX_END_TWO_FEET, IX_END_ONE_FOOT, IX_END_FREE}},
    {{-0.64, 0.5, 0.27, -0.15, -0.69, -0.42},
     {-0.39, -0.04, -0.03, 0.83, 0.11, -0.14},
     8,
     {IX_POINT_POINT, IX_POINT_CURVE, IX_CURVE_CURVE, IX_POINT_CURVE,
      IX_POINT_POINT, IX_POINT_CURVE, IX_CURVE_CURVE, IX_POINT_CURVE},
     {IX_END_ONE_FOOT, IX_END_ONE_FOOT, IX_END_ONE_FOOT, IX_END_ONE_FOOT}}};

static void components(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(713);

    (void)state;
    for (size_t e = 0; e < sizeof examples / sizeof *examples; e++) {
        const counted *x = &examples[e];
        ix_mv *a = make_crv(ctx, 3, 3, NULL, false, 2, x->a);
        ix_mv *b = make_crv(ctx, 3, 3, NULL, false, 2, x->b);
        const ix_mv *const la[1] = {a}, *const lb[1] = {b};
        ix_end_class end[4];
        ix_bisector s;

        ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, la, 1, lb, 0, &s));
        assert_int_equal(s.n, x->n);
        for (int i = 0; i < x->n; i++) {
            const ix_bisector_piece *p = &s.piece[i];

            assert_int_equal(p->kind, x->kind[i]);
            assert_int_equal(p->component, i);
            assert_true((p->exact == NULL) == (p->kind == IX_CURVE_CURVE));
            assert_true(i == 0 || p->joined);
            assert_true(p->unbounded[1] ||
                        hypot(p->x[0] - p->x[2 * p->n - 2],
                              p->x[1] - p->x[2 * p->n - 1]) > 0.004);
        }
        ix_bisector_ends(&s, a, b, end);
        for (int i = 0; i < 4; i++)
            assert_int_equal(end[i], x->end[i]);
        ix_bisector_free(ctx, &s);
        check(ctx, &r, a, b, 100 + (int)e);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
    }
    ix_ctx_free(ctx);
}

/* --- closed forms ----------------------------------------------------------
 */

static ix_mv *segment(ix_ctx *ctx, double x0, double y0, double x1, double y1)
{
    double pts[4] = {x0, x1, y0, y1};

    return make_crv(ctx, 2, 2, NULL, false, 2, pts);
}

typedef double (*implicit)(const double *x);

/* Every vertex satisfies f = 0, relative to the distance. */
static void on_locus(ix_ctx *ctx, ix_mv *a, ix_mv *b, implicit f, int closed)
{
    const ix_mv *const la[1] = {a}, *const lb[1] = {b};
    ix_bisector s;

    ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, la, 1, lb, 0, &s));
    assert_true(s.n > 0);
    assert_int_equal(s.closed, closed);
    for (int i = 0; i < s.n; i++)
        for (int j = 0; j < s.piece[i].n; j++) {
            const double *x = s.piece[i].x + 2 * j;

            if (!(fabs(f(x)) <= 1e-12 * (1 + hypot(x[0], x[1]))))
                fail_msg("(%g, %g): %g", x[0], x[1], f(x));
        }
    ix_bisector_free(ctx, &s);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
}

static double on_circle_two(const double *x)
{
    return hypot(x[0], x[1]) - 2;
}

/* |x - (4, 0)| - 1 = |x| - 2, a branch of a hyperbola */
static double on_hyperbola(const double *x)
{
    return hypot(x[0], x[1]) - 2 - (hypot(x[0] - 4, x[1]) - 1);
}

static double on_middle(const double *x)
{
    return x[1] - 0.5;
}

static void circles(void **state)
{
    const double o[3] = {0, 0, 0}, p[3] = {4, 0, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *a, *b;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, o, 1, &a));
    ASSERT_OK(ctx, ix_circle(ctx, o, 3, &b));
    on_locus(ctx, a, b, on_circle_two, 1);
    ASSERT_OK(ctx, ix_circle(ctx, o, 2, &a));
    ASSERT_OK(ctx, ix_circle(ctx, p, 1, &b));
    on_locus(ctx, a, b, on_hyperbola, 0);
    on_locus(ctx, segment(ctx, 0, 0, 1, 0), segment(ctx, 0, 1, 1, 1), on_middle,
             0);
    on_locus(ctx, segment(ctx, 0, 0, 1, 0), segment(ctx, 1, 1, 0, 1), on_middle,
             0);
    ix_ctx_free(ctx);
}

/* Two crossing segments of equal length: the diagonals between them, four half
 * lines that meet in the crossing. */
static double on_diagonals(const double *x)
{
    return fabs(x[0]) - fabs(x[1]);
}

static void crossing(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    on_locus(ctx, segment(ctx, -1, 0, 1, 0), segment(ctx, 0, -1, 0, 1),
             on_diagonals, 0);
    ix_ctx_free(ctx);
}

/* A common end: on one side the bisector of both segments; behind it all
 * points are equally far and left out. */
static void common_end(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *a = segment(ctx, 0, 0, 1, 0), *b = segment(ctx, 0, 0, 0, 1);
    const ix_mv *const la[1] = {a}, *const lb[1] = {b};
    ix_bisector s;

    (void)state;
    ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, la, 1, lb, 0, &s));
    assert_true(s.n >= 2);
    for (int i = 0; i < s.n; i++)
        for (int j = 0; j < s.piece[i].n; j++) {
            const double *x = s.piece[i].x + 2 * j;

            assert_true(x[0] >= -1e-9);
            ASSERT_CLOSE(x[0], x[1], 1e-12);
        }
    ix_bisector_free(ctx, &s);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_ctx_free(ctx);
}

/* The same curve twice has none; two halves of a parabola have its axis: above
 * the centre of curvature between the curves, then between their far ends;
 * below it all feet are the common end. */
static void same_curve(void **state)
{
    static const double pts[6] = {-1, 0, 1, 1, -1, 1}; /* y = x^2 */
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *a = make_crv(ctx, 3, 3, NULL, false, 2, pts), *h[2];
    const ix_mv *const la[1] = {a};
    ix_bisector s;

    (void)state;
    ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, la, 1, la, 0, &s));
    assert_int_equal(s.n, 0);
    ix_bisector_free(ctx, &s);
    ASSERT_OK(ctx, ix_mv_split(ctx, a, 0, 0.5, h));
    {
        const ix_mv *const l0[1] = {h[0]}, *const l1[1] = {h[1]};

        ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, l0, 1, l1, 0, &s));
    }
    /* rounding may set the change of both feet apart */
    assert_in_range(s.n, 4, 5);
    assert_true(s.piece[0].unbounded[0] && s.piece[s.n - 1].unbounded[1]);
    for (int i = 0; i < s.n; i++) {
        assert_true(i == 0 || s.piece[i].joined);
        for (int j = 0; j < s.piece[i].n; j++)
            assert_true(fabs(s.piece[i].x[2 * j]) <= 1e-9);
    }
    /* the normal: from the centre of curvature to the end and on */
    assert_int_equal(s.piece[s.n - 2].kind, IX_POINT_POINT);
    ASSERT_CLOSE(s.piece[s.n - 2].x[1], 0.5, 1e-12);
    ASSERT_CLOSE(s.piece[s.n - 2].x[3], 0, 1e-12);
    ix_bisector_free(ctx, &s);
    ix_mv_unref(ctx, h[0]);
    ix_mv_unref(ctx, h[1]);
    ix_mv_unref(ctx, a);
    ix_ctx_free(ctx);
}

/* --- several curves, single points -----------------------------------------
 */

/* A square of four segments and a point-like circle far from it: as objects of
 * several curves and of one. */
static void objects(void **state)
{
    static const double square[10] = {0, 1, 1, 0, 0, 0, 0, 1, 1, 0};
    static const double kv[7] = {0, 0, 1, 2, 3, 4, 4};
    const double p[3] = {3, 0.5, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *one = make_crv(ctx, 2, 5, kv, false, 2, square), *c, *side[4];
    const ix_mv *list[4], *const whole[1] = {one};
    ix_bisector s, t;
    double least = INFINITY;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, p, 0.5, &c));
    for (int i = 0; i < 4; i++)
        list[i] = side[i] = segment(ctx, square[i], square[5 + i],
                                    square[i + 1], square[6 + i]);
    {
        const ix_mv *const lc[1] = {c};

        ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 4, list, 1, lc, 0, &s));
        ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, whole, 1, lc, 0, &t));
    }
    for (int i = 0; i < t.n; i++)
        for (int j = 0; j < t.piece[i].n; j++) {
            const double *x = t.piece[i].x + 2 * j;

            if (hypot(x[0], x[1]) < 5)
                assert_true(off_result(&s, x) <= 1e-3);
            least = fmin(least, x[0]);
        }
    assert_true(least > 1);
    ix_bisector_free(ctx, &s);
    ix_bisector_free(ctx, &t);
    for (int i = 0; i < 4; i++)
        ix_mv_unref(ctx, side[i]);
    ix_mv_unref(ctx, one);
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

/* Law: ix_bisector_touch from feet that are a little off gives the vertex. */
static void exact_points(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(714);
    crv_kind k = {3, 2, true, 0, 0, 1}, l = {3, 2, false, 0, 1.2, 1};
    ix_mv *a = rand_crv(ctx, &r, &k), *b = rand_crv(ctx, &r, &l);
    const ix_mv *const la[1] = {a}, *const lb[1] = {b};
    int tried = 0;
    ix_bisector s;

    (void)state;
    ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, la, 1, lb, 0, &s));
    for (int i = 0; i < s.n; i++)
        for (int j = 1;
             s.piece[i].kind == IX_CURVE_CURVE && j + 1 < s.piece[i].n; j++) {
            const ix_bisector_piece *p = &s.piece[i];
            double foot[2] = {p->foot[2 * j], p->foot[2 * j + 1] + 1e-5};
            double x[2], rad;

            ASSERT_OK(ctx,
                      ix_bisector_touch(ctx, a, b, p->side, foot, x, &rad));
            assert_true(hypot(x[0] - p->x[2 * j], x[1] - p->x[2 * j + 1]) <=
                        1e-10 * (1 + rad));
            tried++;
        }
    assert_true(tried > 10);
    ix_bisector_free(ctx, &s);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_ctx_free(ctx);
}

/* --- errors ----------------------------------------------------------------
 */

static void errors(void **state)
{
    static const double same[4] = {1, 1, 2, 2};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *a = segment(ctx, 0, 0, 1, 0);
    ix_mv *p = make_crv(ctx, 2, 2, NULL, false, 2, same);
    ix_mv *e1 = make_crv(ctx, 2, 2, NULL, false, 1, same);
    const ix_mv *const la[1] = {a}, *const lp[1] = {p}, *const le[1] = {e1};
    double foot[2] = {0.5, 0.5}, x[2], r;
    ix_bisector s;

    (void)state;
    assert_int_equal(ix_bisect_crv_crv(ctx, 1, la, 1, lp, 0, &s), IX_EDOMAIN);
    assert_int_equal(ix_bisect_crv_crv(ctx, 1, la, 1, le, 0, &s), IX_EARG);
    assert_int_equal(ix_bisect_crv_crv(ctx, 0, la, 1, la, 0, &s), IX_EARG);
    assert_int_equal(ix_bisect_crv_crv(ctx, 1, la, 1, la, -1, &s), IX_EARG);
    assert_int_equal(ix_bisector_touch(ctx, a, e1, 1, foot, x, &r), IX_EARG);
    assert_int_equal(ix_bisector_touch(ctx, p, a, 1, foot, x, &r), IX_EDOMAIN);
    assert_int_equal(ix_bisector_touch(ctx, a, a, 1, foot, x, &r), IX_EUNABLE);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, p);
    ix_mv_unref(ctx, e1);
    ix_ctx_free(ctx);
}

/* More vertices than there is room for are refused before they are made. */
static void too_many(void **state)
{
    static const double arch[6] = {-1, 0, 1, 1, -1, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *a = make_crv(ctx, 3, 3, NULL, false, 2, arch);
    ix_mv *b = segment(ctx, -1, -1, 1, -1.5);
    const ix_mv *const la[1] = {a}, *const lb[1] = {b};
    ix_bisector s;

    (void)state;
    assert_int_equal(ix_bisect_crv_crv(ctx, 1, la, 1, lb, 1e-17, &s),
                     IX_EUNABLE);
    assert_non_null(strstr(ix_ctx_message(ctx), "million vertices"));
    ix_ctx_set_memory_limit(ctx, (size_t)10 << 20);
    ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, la, 1, lb, 1e-7, &s));
    ix_bisector_free(ctx, &s);
    assert_int_equal(ix_bisect_crv_crv(ctx, 1, la, 1, lb, 1e-10, &s),
                     IX_EUNABLE);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_ctx_free(ctx);
}

typedef struct {
    ix_mv *a, *b;
    ix_bisector s;
} fault_state;

static void fault_setup(ix_ctx *ctx, void *state)
{
    fault_state *f = state;

    *f = (fault_state){.a = segment(ctx, 0, 0, 1, 0),
                       .b = segment(ctx, 0, 1, 1, 2)};
}

static ix_status fault_call(ix_ctx *ctx, void *state)
{
    fault_state *f = state;
    const ix_mv *const la[1] = {f->a}, *const lb[1] = {f->b};

    return ix_bisect_crv_crv(ctx, 1, la, 1, lb, 0.1, &f->s);
}

static void fault_teardown(ix_ctx *ctx, void *state)
{
    fault_state *f = state;

    ix_bisector_free(ctx, &f->s);
    ix_mv_unref(ctx, f->a);
    ix_mv_unref(ctx, f->b);
    *f = (fault_state){0};
}

static void no_memory(void **state)
{
    fault_state f = {0};
    ix_fault_case c = {fault_setup, fault_call, fault_teardown, &f};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

/* A curve that turns back on a straight line: where it does the circle on the
 * other side has another size, which is no way to infinity. Exact pieces are as
 * far from both, 1e-9 being what golden sections leave. */
static void turning_back(void **state)
{
    static const double p[8] = {-1, -1, -2, 0, 2, 0, -2, 2};
    static const double q[6] = {1, 1, 2, 0, 1, -1};
    static const double kp[7] = {0, 0, 0, 1, 2, 2, 2}, kq[5] = {0, 0, 1, 2, 2};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m[2] = {make_crv(ctx, 3, 4, kp, false, 2, p),
                   make_crv(ctx, 2, 3, kq, false, 2, q)};
    const ix_mv *const a[1] = {m[0]}, *const b[1] = {m[1]};
    brute ba = brute_of(ctx, 1, a), bb = brute_of(ctx, 1, b);
    int many = 0;
    ix_bisector s;

    (void)state;
    ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, a, 1, b, 0, &s));
    for (int i = 0; i < s.n; i++) {
        const ix_bisector_piece *g = &s.piece[i];
        double dom[2], x[2];

        for (int e = 0; e < 2; e++)
            assert_true(!g->unbounded[e] || g->r[e ? g->n - 1 : 0] > 20);
        for (int k = 1; g->exact && k < 8; k++) {
            double t, d;

            ix_mv_domain(g->exact, 0, dom);
            t = dom[0] + (dom[1] - dom[0]) * k / 8;
            ASSERT_OK(ctx, ix_mv_point(ctx, g->exact, &t, x));
            d = brute_distance(ctx, &ba, x, true);
            ASSERT_CLOSE(d, brute_distance(ctx, &bb, x, true),
                         1e-9 * fmax(2, d));
            many++;
        }
    }
    assert_true(many > 20);
    ix_bisector_free(ctx, &s);
    free(ba.x);
    free(bb.x);
    ix_mv_unref(ctx, m[0]);
    ix_mv_unref(ctx, m[1]);
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(by_definition), cmocka_unit_test(disjoint_quadratics),
        cmocka_unit_test(components),    cmocka_unit_test(circles),
        cmocka_unit_test(crossing),      cmocka_unit_test(common_end),
        cmocka_unit_test(same_curve),    cmocka_unit_test(objects),
        cmocka_unit_test(exact_points),  cmocka_unit_test(errors),
        cmocka_unit_test(no_memory),     cmocka_unit_test(too_many),
        cmocka_unit_test(turning_back),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
