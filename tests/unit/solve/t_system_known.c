/* Published systems and mechanisms with known numbers of real solutions. */
#include "harness/randmv.h"
#include "systest.h"

IX_TEST_FIXTURE(20261125)

static long verified; /* roots, over the whole file */

static void run_all(const sys_case *c, size_t n, int starts)
{
    for (size_t i = 0; i < n; i++)
        verified += run_case(ctx, &rng, &c[i], starts);
}

#define RUN(cases, starts) run_all(cases, sizeof cases / sizeof *cases, starts)

/* The benchmarks of polynomial solvers: magnetism (Katsura & Sasaki 1986),
 * neural networks (Noonburg 1989), the conformations of a six-membered ring
 * (Emiris & Mourrain 1999: 16 real ones), Chebyshev polynomials composed. */
static void published(void **state)
{
    static const sys_case cases[] = {
        {"katsura-4",
         5,
         5,
         {"x + 2*y + 2*z + 2*w + 2*u - 1",
          "x^2 + 2*y^2 + 2*z^2 + 2*w^2 + 2*u^2 - x",
          "2*x*y + 2*y*z + 2*z*w + 2*w*u - y",
          "2*x*z + y^2 + 2*y*w + 2*z*u - z", "2*x*w + 2*y*z + 2*y*u - w"},
         -1.1,
         1.3,
         12,
         0},
        {"noon-3",
         3,
         3,
         {"x*y^2 + x*z^2 - 1.1*x + 1", "y*x^2 + y*z^2 - 1.1*y + 1",
          "z*x^2 + z*y^2 - 1.1*z + 1"},
         -3.1,
         3.3,
         7,
         0},
        {"ring of six",
         3,
         3,
         {"-1 - y^2 - z^2 - 5*y^2*z^2 + 8*y*z",
          "-1 - z^2 - x^2 - 5*z^2*x^2 + 8*z*x",
          "-1 - x^2 - y^2 - 5*x^2*y^2 + 8*x*y"},
         -4.1,
         4.3,
         16,
         0},
        {"chebyshev 3 o 3",
         2,
         2,
         {"4*x^3 - 3*x - y", "4*y^3 - 3*y - x"},
         -1.2,
         1.3,
         9,
         0}};

    (void)state;
    RUN(cases, 40);
}

/* Planar mechanisms: the lengths are chosen, the solutions are the ways in
 * which they can be assembled (even numbers, 6 at most for a platform on three
 * legs, 2 for a four-bar linkage whose crank is held). */
static void mechanisms(void **state)
{
    static const sys_case cases[] = {
        {"four bars",
         4,
         4,
         {"x^2 + y^2 - 1", "z^2 + w^2 - 1", "0.5 + 1.8*x - 1.6*z - 2",
          "0.8660254 + 1.8*y - 1.6*w"},
         -1.2,
         1.3,
         2,
         0},
        {"five bars",
         2,
         2,
         {"(x + 0.3)^2 + (y - 0.9)^2 - 1.44",
          "(x - 1.7)^2 + (y - 0.8)^2 - 1.69"},
         -3.1,
         3.3,
         2,
         0},
        {"platform on three legs",
         4,
         4,
         {"z^2 + w^2 - 1", "x^2 + y^2 - 1",
          "(x + 1.2*z - 1.3)^2 + (y + 1.2*w)^2 - 0.81",
          "(x + 0.6*z - 1*w - 0.6)^2 + (y + 0.6*w + 1*z - 1.1)^2 - 0.7"},
         -1.4,
         1.5,
         4,
         0},
        {"three distances in space",
         3,
         3,
         {"x^2 + y^2 + z^2 - 1.5", "(x - 1)^2 + y^2 + z^2 - 1.2",
          "(x - 0.4)^2 + (y - 0.9)^2 + (z - 0.1)^2 - 1.1"},
         -2.1,
         2.3,
         2,
         0}};

    (void)state;
    RUN(cases, 100);
}

/* Pairs that touch, cross each other twice close by, or have a singular point
 * in common. */
static void degenerate(void **state)
{
    static const sys_case cases[] = {
        {"a node and a line",
         2,
         2,
         {"y^2 - x^2*(x + 1)", "y - 0.5*x"},
         -2.1,
         2.3,
         1,
         1},
        {"a cusp and a line", 2, 2, {"y^2 - x^3", "y - x"}, -1.1, 1.3, 1, 1},
        {"an isolated point and a circle",
         2,
         2,
         {"x^2 + y^2", "(x - 1)^2 + y^2 - 1"},
         -1.1,
         1.3,
         0,
         1},
        {"two cusps that meet",
         2,
         2,
         {"y^2 - x^3", "x^2 - y^3"},
         -1.1,
         1.3,
         1,
         1},
        {"contact of order 3 of cubics",
         2,
         2,
         {"y - x^3", "y"},
         -1.1,
         1.3,
         0,
         1},
        {"a quintic and a line", 2, 2, {"y - x^5", "y - x"}, -0.7, 0.8, 1, 0},
        {"two contacts, turned",
         2,
         2,
         {"x^2 + y^2 - 1", "5*x^2 + 5*y^2 + 6*x*y - 8"},
         -1.2,
         1.3,
         0,
         2},
        {"spheres that touch",
         3,
         3,
         {"x^2 + y^2 + z^2 - 1", "(x - 2)^2 + y^2 + z^2 - 1", "y - 0.1*z"},
         -1.1,
         1.3,
         0,
         1},
        {"4e-6 apart",
         2,
         2,
         {"y - x^2", "y - 0.000000000004"},
         -1.1,
         1.3,
         2,
         0}};
    (void)state;
    RUN(cases, 50);
}

/* Law: a system with a one-dimensional solution set is told from one with
 * many isolated solutions. */
static void positive_dimension(void **state)
{
    static const char *const cyclic[] = {
        "x + y + z + w", "x*y + y*z + z*w + w*x",
        "x*y*z + y*z*w + z*w*x + w*x*y", "x*y*z*w - 1"};
    const ix_solve_opts o = {.max_boxes = 50000};
    double box[6][2];
    ix_solutions s;

    (void)state;
    fill(box, -1.9, 2.1);
    s = solve_text(ctx, 4, 4, cyclic, box, NULL, &o);
    print_message("# cyclic-4: %zu boxes\n", s.boxes);
    assert_true(s.crowded);
    for (int k = 1; k < 20; k++) { /* (a, b, -a, -b) with a b = 1 */
        double a = 0.5 + 0.07 * k, x[4] = {a, 1 / a, -a, -1 / a};
        int hit = 0;

        for (int i = 0; i < s.n && !hit; i++) {
            hit = 1;
            for (int j = 0; j < 4; j++) {
                double t = (x[j] + 1.9) / 4;

                hit &= t >= s.sol[i].lo[j] && t <= s.sol[i].hi[j];
            }
        }
        assert_true(hit);
    }
    ix_solutions_free(ctx, &s);
}

static void tell(void **state)
{
    (void)state;
    print_message("# %ld solutions verified\n", verified);
    assert_true(verified > 50);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(published), cmocka_unit_test(mechanisms),
        cmocka_unit_test(degenerate), cmocka_unit_test(positive_dimension),
        cmocka_unit_test(tell)};

    return cmocka_run_group_tests(tests, setup, teardown);
}
