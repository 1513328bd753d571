/* Systems of n equations in n unknowns with known solutions: nothing lost,
 * nothing doubled, certified where regular. */
#include "harness/fault.h"
#include "harness/randmv.h"
#include "systest.h"

IX_TEST_FIXTURE(20260711)

static long verified; /* roots, over the whole file */

/* The positions of two conics with real points in common, by multiplicity;
 * boxes with odd ends, so that no root lies on a split. */
static void two_conics(void **state)
{
    static const sys_case cases[] = {
        {"1111",
         2,
         2,
         {"x^2 + y^2 - 1", "0.25*x^2 + 4*y^2 - 1"},
         -2.1,
         2.3,
         4,
         0},
        {"11", 2, 2, {"x^2 + y^2 - 1", "(x - 1)^2 + y^2 - 1"}, -2.1, 2.3, 2, 0},
        {"none",
         2,
         2,
         {"x^2 + y^2 - 1", "(x - 3)^2 + y^2 - 1"},
         -4.1,
         4.3,
         0,
         0},
        {"211", 2, 2, {"x^2 + y^2 - 1", "y - x^2 + 1"}, -2.1, 2.3, 2, 1},
        {"2", 2, 2, {"x^2 + y^2 - 1", "(x - 2)^2 + y^2 - 1"}, -2.1, 3.3, 0, 1},
        {"22", 2, 2, {"x^2 + y^2 - 1", "0.25*x^2 + y^2 - 1"}, -2.1, 2.3, 0, 2},
        {"31",
         2,
         2,
         {"y - x^2", "(x + 4)^2 + (y - 3.5)^2 - 31.25"},
         -4.1,
         10.3,
         1,
         1},
        {"4", 2, 2, {"y - x^2", "x^2 + (y - 0.5)^2 - 0.25"}, -2.1, 2.3, 0, 1}};

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        verified += run_case(ctx, &rng, &cases[i], 200);
}

static void classics(void **state)
{
    static const sys_case cases[] = {
        {"two cubics",
         2,
         2,
         {"4*x^3 - 3*x - 0.1*y", "4*y^3 - 3*y - 0.1*x"},
         -1.2,
         1.3,
         9,
         0},
        {"cyclic-3",
         3,
         3,
         {"x + y + z", "x*y + y*z + z*x", "x*y*z - 1"},
         -3.1,
         3.3,
         0,
         0},
        {"katsura-2",
         3,
         3,
         {"x + 2*y + 2*z - 1", "x^2 + 2*y^2 + 2*z^2 - x", "2*x*y + 2*y*z - y"},
         -1.1,
         1.3,
         4,
         0},
        {"katsura-3",
         4,
         4,
         {"x + 2*y + 2*z + 2*w - 1", "x^2 + 2*y^2 + 2*z^2 + 2*w^2 - x",
          "2*x*y + 2*y*z + 2*z*w - y", "2*x*z + y^2 + 2*y*w - z"},
         -1.1,
         1.3,
         6,
         0},
        {"2R arm",
         4,
         4,
         {"x^2 + y^2 - 1", "z^2 + w^2 - 1", "2*x + 1.5*(x*z - y*w) - 1.2",
          "2*y + 1.5*(y*z + x*w) - 1.9"},
         -1.2,
         1.3,
         2,
         0},
        {"three spheres",
         3,
         3,
         {"x^2 + y^2 + z^2 - 1", "(x - 0.7)^2 + y^2 + z^2 - 1.1",
          "x^2 + (y - 0.4)^2 + (z - 0.3)^2 - 0.9"},
         -2.1,
         2.3,
         2,
         0},
        {"overdetermined, met",
         2,
         3,
         {"x^2 + y^2 - 2", "x - y", "x^3 - y^3"},
         -2.1,
         2.3,
         2,
         0},
        {"overdetermined, missed",
         2,
         3,
         {"x^2 + y^2 - 2", "x - y", "x + y - 1"},
         -2.1,
         2.3,
         0,
         0},
        {"near tangent", 2, 2, {"y - x^2", "y - 0.00000001"}, -1.1, 1.3, 2, 0},
        {"just apart", 2, 2, {"y - x^2", "y + 0.00000001"}, -1.1, 1.3, 0, 0}};

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        verified += run_case(ctx, &rng, &cases[i], 100);
}

/* Roots at the corners, on the edges and in the middle of the domain. */
static void on_the_boundary(void **state)
{
    static const sys_case cases[] = {
        {"grid of 9", 2, 2, {"x*(x^2 - 1)", "y*(y^2 - 1)"}, -1, 1, 9, 0},
        {"corners", 2, 2, {"x^2 - 1", "y^2 - 1"}, -1, 1, 4, 0},
        {"edges", 2, 2, {"x^2 + y^2 - 1", "x*y"}, -1, 1, 4, 0},
        {"corner touch", 2, 2, {"x - 1", "x + y - 2"}, -1, 1, 1, 0}};

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        verified += run_case(ctx, &rng, &cases[i], 100);
}

static void inequalities(void **state)
{
    static const char *const text[] = {"x^2 + y^2 - 1", "x - y", "x"};
    ix_relation rel[] = {IX_EQUAL_ZERO, IX_EQUAL_ZERO, IX_AT_LEAST_ZERO};
    double box[6][2];
    ix_solutions s;

    (void)state;
    fill(box, -2.1, 2.3);
    for (int k = 0; k < 2; k++) {
        double x[2];

        rel[2] = k ? IX_AT_MOST_ZERO : IX_AT_LEAST_ZERO;
        s = solve_text(ctx, 2, 3, text, box, rel, NULL);
        assert_int_equal(s.n, 1);
        to_box(box, 2, s.sol[0].x, x);
        ASSERT_CLOSE(x[0], (k ? -1 : 1) * sqrt(0.5), 1e-14);
        ix_solutions_free(ctx, &s);
    }
}

/* Law: scaling an equation or the domain changes nothing. */
static void scales(void **state)
{
    static const char *const sizes[] = {"0.00000001", "100000000",
                                        "1234567890123456789"};
    double box[6][2];

    (void)state;
    fill(box, -2.1, 2.3);
    for (int k = 0; k < 3; k++) {
        char a[80];
        const char *text[2] = {a, "0.25*x^2 + 4*y^2 - 1"};
        ix_solutions s;

        snprintf(a, sizeof a, "%s*(x^2 + y^2 - 1)", sizes[k]);
        s = solve_text(ctx, 2, 2, text, box, NULL, NULL);
        assert_int_equal(s.n, 4);
        for (int i = 0; i < 4; i++) {
            assert_true(s.sol[i].certified);
            assert_true(s.sol[i].residual < 1e-15);
        }
        ix_solutions_free(ctx, &s);
    }
}

/* --- splines ---------------------------------------------------------------
 */

/* Law: knots, wherever they are, also through the roots, change nothing. */
static void knots_through_roots(void **state)
{
    static const char *const text[] = {"4*x^3 - 3*x - 0.1*y",
                                       "4*y^3 - 3*y - 0.1*x"};
    double box[6][2];
    ix_equation eq[2];
    ix_solutions plain, cut;
    ix_mv *m[2];

    (void)state;
    fill(box, -1.2, 1.3);
    plain = solve_text(ctx, 2, 2, text, box, NULL, NULL);
    for (int i = 0; i < 2; i++) {
        m[i] = st_mv(ctx, text[i], 2, box);
        for (int j = 0; j < 2; j++) {
            double kv[9];
            ix_mv *b, *c;

            for (int k = 0; k < plain.n; k++)
                kv[k] = plain.sol[k].x[j];
            for (int k = 1; k < plain.n; k++) /* increasing */
                for (int l = k; l > 0 && kv[l - 1] > kv[l]; l--) {
                    double t = kv[l];

                    kv[l] = kv[l - 1];
                    kv[l - 1] = t;
                }
            ASSERT_OK(ctx, ix_mv_to_bspline(ctx, m[i], &b));
            ASSERT_OK(ctx, ix_mv_insert_knots(ctx, b, j, j ? 3 : 9, kv, &c));
            ix_mv_unref(ctx, b);
            ix_mv_unref(ctx, m[i]);
            m[i] = c;
        }
        eq[i] = (ix_equation){m[i], 0, IX_EQUAL_ZERO};
    }
    ASSERT_OK(ctx, ix_solve(ctx, 2, eq, NULL, &cut));
    assert_int_equal(cut.n, plain.n);
    for (int i = 0; i < cut.n; i++) {
        assert_true(cut.sol[i].certified);
        for (int j = 0; j < 2; j++)
            ASSERT_CLOSE(cut.sol[i].x[j], plain.sol[i].x[j], 1e-14);
    }
    verified += cut.n;
    for (int i = 0; i < 2; i++)
        ix_mv_unref(ctx, m[i]);
    ix_solutions_free(ctx, &plain);
    ix_solutions_free(ctx, &cut);
}

static double at(const ix_mv *m, double u, double v)
{
    double t[2] = {u, v}, x[1];

    ASSERT_OK(ctx, ix_mv_eval(ctx, m, t, x));
    return x[0];
}

/* Newton on two multivariates from a start; true if it ends inside [0,1]^2. */
static int newton2(ix_mv *const *m, double *u, double *v)
{
    for (int it = 0; it < 40; it++) {
        const double h = 1e-6;
        double j[4], f[2], det, du, dv;

        if (!(*u >= h && *u <= 1 - h && *v >= h && *v <= 1 - h))
            return 0;
        for (int i = 0; i < 2; i++) {
            f[i] = at(m[i], *u, *v);
            j[2 * i] = (at(m[i], *u + h, *v) - at(m[i], *u - h, *v)) / (2 * h);
            j[2 * i + 1] = (at(m[i], *u, *v + h) - at(m[i], *u, *v - h)) /
                           (2 * h);
        }
        det = j[0] * j[3] - j[1] * j[2];
        du = (f[0] * j[3] - f[1] * j[1]) / det;
        dv = (j[0] * f[1] - j[2] * f[0]) / det;
        if (!(fabs(du) < 1 && fabs(dv) < 1))
            return 0;
        *u -= du;
        *v -= dv;
        if (fmax(fabs(du), fabs(dv)) < 1e-12)
            return *u >= 0 && *u <= 1 && *v >= 0 && *v <= 1;
    }
    return 0;
}

/* Law: on random bicubics and bicubic splines, what Newton finds from a grid
 * of starts is what the solver finds. */
static void random_bicubics(void **state)
{
    (void)state;
    for (int round = 0; round < 60; round++) {
        const ix_rand_opts o = {.ndirs = 2,
                                .ncoords = 1,
                                .rational = -1,
                                .kinds = round % 2 ? IX_RAND_OPEN
                                                   : IX_RAND_BEZIER,
                                .min_order = 4,
                                .max_order = 4,
                                .max_knots = round % 2 ? 2 : -1,
                                .unit = true};
        ix_mv *m[2] = {ix_mv_randtest(ctx, &rng, &o),
                       ix_mv_randtest(ctx, &rng, &o)};
        ix_equation eq[2] = {{m[0], 0, IX_EQUAL_ZERO},
                             {m[1], 0, IX_EQUAL_ZERO}};
        ix_solutions s;

        ASSERT_OK(ctx, ix_solve(ctx, 2, eq, NULL, &s));
        for (int i = 0; i < s.n; i++) {
            if (!s.sol[i].certified)
                continue;
            assert_true(fabs(at(m[0], s.sol[i].x[0], s.sol[i].x[1])) < 1e-13);
            assert_true(fabs(at(m[1], s.sol[i].x[0], s.sol[i].x[1])) < 1e-13);
            verified++;
        }
        for (int k = 0; k < 100; k++) {
            double u = (k % 10 + 0.5) / 10, v = (k / 10 + 0.5) / 10;
            int hit = 0;

            if (!newton2(m, &u, &v))
                continue;
            for (int i = 0; i < s.n; i++)
                hit |= fabs(s.sol[i].x[0] - u) < 1e-7 &&
                       fabs(s.sol[i].x[1] - v) < 1e-7;
            if (!hit)
                fail_msg("round %d: lost (%.17g, %.17g)", round, u, v);
        }
        ix_solutions_free(ctx, &s);
        ix_mv_unref(ctx, m[0]);
        ix_mv_unref(ctx, m[1]);
    }
}

/* --- budget, interruption, degenerate systems ------------------------------
 */

/* Whether x (parts of the domain) lies in a box of s. */
static int covered(const ix_solutions *s, const double *x)
{
    int hit = 0;

    for (int i = 0; i < s->n && !hit; i++) {
        hit = 1;
        for (int j = 0; j < s->unknowns; j++)
            hit &= x[j] >= s->sol[i].lo[j] - 1e-15 &&
                   x[j] <= s->sol[i].hi[j] + 1e-15;
    }
    return hit;
}

/* max_boxes reached: what was proven is there, the rest is named as open and
 * covers every solution. */
static void budget(void **state)
{
    static const char *const text[] = {"4*x^3 - 3*x - 0.1*y",
                                       "4*y^3 - 3*y - 0.1*x"};
    double box[6][2];
    ix_solutions all;

    (void)state;
    fill(box, -1.2, 1.3);
    all = solve_text(ctx, 2, 2, text, box, NULL, NULL);
    for (size_t budget = 1; budget < all.boxes; budget += 3) {
        const ix_solve_opts o = {.max_boxes = budget};
        ix_solutions s = solve_text(ctx, 2, 2, text, box, NULL, &o);

        assert_false(s.complete);
        for (int i = 0; i < all.n; i++) {
            if (!covered(&s, all.sol[i].x))
                fail_msg("budget %zu: solution %d is not covered", budget, i);
        }
        ix_solutions_free(ctx, &s);
    }
    ix_solutions_free(ctx, &all);
}

static volatile int stop;

/* Called by the first box's poll, and then every 0.1 s. */
static void stop_now(void *ud, const char *what, double part)
{
    (void)ud;
    (void)what;
    (void)part;
    stop = 1;
}

static ix_mv *with_knots(const char *text, double (*box)[2])
{
    static const double kv[2] = {0.25, 0.75};
    ix_mv *m = st_mv(ctx, text, 2, box), *b;

    ASSERT_OK(ctx, ix_mv_to_bspline(ctx, m, &b));
    ix_mv_unref(ctx, m);
    for (int j = 0; j < 2; j++) {
        ASSERT_OK(ctx, ix_mv_insert_knots(ctx, b, j, 2, kv, &m));
        ix_mv_unref(ctx, b);
        b = m;
    }
    return b;
}

/* Interrupted after the first box of 9 patches: an error and nothing, or with
 * the option keep what is proven, and the rest as open boxes. */
static void interrupted(void **state)
{
    static const char *const text[] = {"x*(x^2 - 0.7)", "y*(y^2 - 0.7)"};
    ix_solve_opts o = {.keep = false};
    ix_solutions all, s;
    double box[6][2];
    ix_equation eq[2];
    ix_mv *m[2];

    (void)state;
    fill(box, -1.2, 1.3);
    for (int i = 0; i < 2; i++) {
        m[i] = with_knots(text[i], box);
        eq[i] = (ix_equation){m[i], 0, IX_EQUAL_ZERO};
    }
    ASSERT_OK(ctx, ix_solve(ctx, 2, eq, NULL, &all));
    assert_int_equal(all.n, 9);
    assert_false(all.interrupted);
    ix_ctx_set_cancel(ctx, &stop);
    ix_ctx_set_progress(ctx, stop_now, NULL);
    assert_int_equal(ix_solve(ctx, 2, eq, &o, &s), IX_ECANCEL);
    assert_int_equal(s.n, 0);
    stop = 0;
    o.keep = true;
    ix_ctx_set_progress(ctx, NULL, NULL);
    ix_ctx_set_progress(ctx, stop_now, NULL);
    ASSERT_OK(ctx, ix_solve(ctx, 2, eq, &o, &s));
    assert_true(s.interrupted);
    assert_false(s.complete);
    assert_int_equal(count_certified(&s), 1);
    for (int i = 0; i < 9; i++)
        assert_true(covered(&s, all.sol[i].x));
    ix_solutions_free(ctx, &s);
    ix_ctx_set_cancel(ctx, NULL);
    ix_ctx_set_progress(ctx, NULL, NULL);
    ix_solutions_free(ctx, &all);
    ix_mv_unref(ctx, m[0]);
    ix_mv_unref(ctx, m[1]);
}

/* A budget that ends in the first patches names the other ones as open. */
static void budget_of_patches(void **state)
{
    static const char *const text[] = {"x*(x^2 - 0.7)", "y*(y^2 - 0.7)"};
    ix_solutions all, s;
    double box[6][2];
    ix_equation eq[2];
    ix_mv *m[2];

    (void)state;
    fill(box, -1.2, 1.3);
    for (int i = 0; i < 2; i++) {
        m[i] = with_knots(text[i], box);
        eq[i] = (ix_equation){m[i], 0, IX_EQUAL_ZERO};
    }
    ASSERT_OK(ctx, ix_solve(ctx, 2, eq, NULL, &all));
    for (size_t budget = 1; budget < all.boxes; budget += 2) {
        const ix_solve_opts o = {.max_boxes = budget};

        ASSERT_OK(ctx, ix_solve(ctx, 2, eq, &o, &s));
        assert_false(s.complete);
        for (int i = 0; i < all.n; i++)
            if (!covered(&s, all.sol[i].x))
                fail_msg("budget %zu: solution %d is lost", budget, i);
        ix_solutions_free(ctx, &s);
    }
    ix_solutions_free(ctx, &all);
    ix_mv_unref(ctx, m[0]);
    ix_mv_unref(ctx, m[1]);
}

/* A common factor: the box count stays small, the regular solution is still
 * certified, and the common curve lies in the open boxes. */
static void common_factor(void **state)
{
    static const char *const text[2][3] = {
        {"(x^2 + y^2 - 1)*(x - 1.3)", "(x^2 + y^2 - 1)*(y - 1.2)", ""},
        {"x^2 + y^2 + z^2 - 1", "x - y", "(x - y)*z"}};

    (void)state;
    for (int c = 0; c < 2; c++) {
        double box[6][2];
        ix_solutions s;

        fill(box, -2.1, 2.3);
        s = solve_text(ctx, 2 + c, 2 + c, text[c], box, NULL, NULL);
        assert_true(s.crowded);
        assert_false(s.complete);
        assert_true(s.boxes < 20000);
        assert_int_equal(count_certified(&s), c == 0);
        for (int k = 0; k < 100; k++) {
            double r = c ? sqrt(0.5) : 1, v = c ? cos(k) : sin(k);
            double t[3] = {(r * cos(k) + 2.1) / 4.4, (r * v + 2.1) / 4.4,
                           (sin(k) + 2.1) / 4.4};

            assert_true(covered(&s, t));
        }
        ix_solutions_free(ctx, &s);
    }
}

/* Coincident curves: within the budget, every box reported is open and the
 * curve lies in their union. */
static void coincident(void **state)
{
    static const char *const text[] = {"x^2 + y^2 - 1", "3*x^2 + 3*y^2 - 3"};
    const ix_solve_opts o = {.cell = 1e-2, .max_boxes = 20000};
    double box[6][2];
    ix_solutions s;

    (void)state;
    fill(box, -1.2, 1.3);
    s = solve_text(ctx, 2, 2, text, box, NULL, &o);
    assert_true(s.n > 0);
    for (int i = 0; i < s.n; i++)
        assert_false(s.sol[i].certified);
    for (int k = 0; k < 100; k++) {
        double t[2] = {(cos(k) + 1.2) / 2.5, (sin(k) + 1.2) / 2.5};
        int hit = 0;

        for (int i = 0; i < s.n; i++)
            hit |= t[0] >= s.sol[i].lo[0] && t[0] <= s.sol[i].hi[0] &&
                   t[1] >= s.sol[i].lo[1] && t[1] <= s.sol[i].hi[1];
        assert_true(hit);
    }
    ix_solutions_free(ctx, &s);
}

/* An equation that vanishes says nothing: what the other one leaves is open,
 * after few boxes. */
static void vanishing(void **state)
{
    static const char *const text[] = {"x^2 + y^2 - 1", "x - x"};
    double box[6][2];
    ix_solutions s;

    (void)state;
    fill(box, -1.2, 1.3);
    s = solve_text(ctx, 2, 2, text, box, NULL, NULL);
    assert_int_equal(s.n, 1);
    assert_false(s.sol[0].certified);
    assert_true(s.complete);
    assert_true(s.boxes < 100);
    ix_solutions_free(ctx, &s);
}

static void errors(void **state)
{
    double box[6][2];
    ix_equation eq[2];
    ix_solutions s;
    ix_mv *a, *b;

    (void)state;
    fill(box, -1.2, 1.3);
    a = st_mv(ctx, "x + y", 2, box);
    b = st_mv(ctx, "x + y + z", 3, box);
    eq[0] = (ix_equation){a, 0, IX_EQUAL_ZERO};
    eq[1] = (ix_equation){b, 0, IX_EQUAL_ZERO};
    assert_int_equal(ix_solve(ctx, 1, eq, NULL, &s), IX_EARG);
    assert_int_equal(ix_solve(ctx, 2, eq, NULL, &s), IX_EARG);
    assert_int_equal(ix_solve(ctx, 0, eq, NULL, &s), IX_EARG);
    eq[1] = (ix_equation){a, 1, IX_EQUAL_ZERO};
    assert_int_equal(ix_solve(ctx, 2, eq, NULL, &s), IX_EARG);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
}

/* --- memory ----------------------------------------------------------------
 */

typedef struct {
    ix_mv *m[2];
    ix_solutions s;
} oom;

static void oom_setup(ix_ctx *own, void *state)
{
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 3, .length = 3},
                         {.basis = IX_BEZIER, .order = 3, .length = 3}};
    const double f[9] = {-1, 1, 2, 1, -3, 1, 2, 1, -1};
    const double g[9] = {1, -1, 1, -2, 1, 2, 1, -1, 1};
    oom *o = state;

    *o = (oom){.s = {.n = 0}};
    ASSERT_OK(own, ix_mv_new(own, 2, d, 1, false, f, &o->m[0]));
    ASSERT_OK(own, ix_mv_new(own, 2, d, 1, false, g, &o->m[1]));
}

static ix_status oom_run(ix_ctx *own, void *state)
{
    oom *o = state;
    ix_equation eq[2] = {{o->m[0], 0, IX_EQUAL_ZERO},
                         {o->m[1], 0, IX_EQUAL_ZERO}};

    return ix_solve(own, 2, eq, NULL, &o->s);
}

static void oom_teardown(ix_ctx *own, void *state)
{
    oom *o = state;

    ix_solutions_free(own, &o->s);
    ix_mv_unref(own, o->m[0]);
    ix_mv_unref(own, o->m[1]);
}

static void out_of_memory(void **state)
{
    oom o;
    const ix_fault_case c = {oom_setup, oom_run, oom_teardown, &o};

    (void)state;
    assert_true(ix_fault_run(&c) > 2);
}

static void tell(void **state)
{
    (void)state;
    print_message("# %ld solutions verified\n", verified);
    assert_true(verified > 150);
}

#define HIGH 19 /* degree of either direction */

/* A linear function times a factor that is largest at the ends of the domain
 * and 1e-3 of that where the line runs; of degree HIGH, one span or four. */
static ix_mv *high_line(const double c[3], bool spline)
{
    const double lin[4] = {c[2], c[0] + c[2], c[1] + c[2], c[0] + c[1] + c[2]};
    const ix_dir two[2] = {{IX_BEZIER, 2, 2, false, NULL},
                           {IX_BEZIER, 2, 2, false, NULL}};
    const ix_dir many[2] = {{IX_BEZIER, HIGH, HIGH, false, NULL},
                            {IX_BEZIER, HIGH, HIGH, false, NULL}};
    static const double knot = 0.625;
    double pts[HIGH * HIGH];
    ix_mv *a, *b, *f, *g;

    for (int i = 0; i < HIGH * HIGH; i++) {
        double x = fabs(i % HIGH - 8.5) / 9.5, y = fabs(i / HIGH - 8.5) / 9.5;

        pts[i] = pow(10, 4 * fmax(x, y) - 4) * ix_rng_range(&rng, 0.8, 1.2);
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, two, 1, false, lin, &a));
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, many, 1, false, pts, &b));
    ASSERT_OK(ctx, ix_sym_mul(ctx, a, b, NULL, &f));
    for (int d = 0; spline && d < 2; d++) {
        ASSERT_OK(ctx, ix_mv_insert_knots(ctx, f, d, 1, &knot, &g));
        ix_mv_unref(ctx, f);
        f = g;
    }
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    return f;
}

/* Law: a regular solution is certified whatever the degree, also where it is
 * not much above the rounding errors of the coefficients. */
static void high_degree(void **state)
{
    static const double line[2][3] = {{0.7, -1, 0.12}, {0.4, 0.9, -0.64}};

    (void)state;
    for (int i = 0; i < 8; i++) {
        ix_mv *f[2] = {high_line(line[0], i % 2), high_line(line[1], i % 2)};
        const ix_equation eq[2] = {{.f = f[0]}, {.f = f[1]}};
        ix_solutions s;

        ASSERT_OK(ctx, ix_solve(ctx, 2, eq, NULL, &s));
        assert_int_equal(s.n, 1);
        assert_true(s.sol[0].certified);
        /* 0.7 x - y + 0.12 = 0.4 x + 0.9 y - 0.64 = 0; an error of 1e-16 of the
         * coefficients is 1e-12 of the function */
        ASSERT_CLOSE(s.sol[0].x[0], 0.532 / 1.03, 1e-11);
        ASSERT_CLOSE(s.sol[0].x[1], 0.496 / 1.03, 1e-11);
        ix_solutions_free(ctx, &s);
        for (int k = 0; k < 2; k++)
            ix_mv_unref(ctx, f[k]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(two_conics),
                                       cmocka_unit_test(classics),
                                       cmocka_unit_test(on_the_boundary),
                                       cmocka_unit_test(inequalities),
                                       cmocka_unit_test(scales),
                                       cmocka_unit_test(knots_through_roots),
                                       cmocka_unit_test(random_bicubics),
                                       cmocka_unit_test(high_degree),
                                       cmocka_unit_test(budget),
                                       cmocka_unit_test(interrupted),
                                       cmocka_unit_test(budget_of_patches),
                                       cmocka_unit_test(common_factor),
                                       cmocka_unit_test(coincident),
                                       cmocka_unit_test(vanishing),
                                       cmocka_unit_test(errors),
                                       cmocka_unit_test(out_of_memory),
                                       cmocka_unit_test(tell)};

    return cmocka_run_group_tests(tests, setup, teardown);
}
