/* The true bisector of pairs of every kind of position, against dense sampling
 * of both curves and against what its topology must be.
 *
 * IX_TEST_ROUNDS=200 tries that many pairs of each kind, and more closely; then
 * IX_TEST_KIND=10 may choose one kind. By default one pair of each, 0.4 s on an
 * idle machine: no kind can be left out. */
#include "planar_check.h"
#include "planar_pairs.h"

static int rounds(void)
{
    const char *s = getenv("IX_TEST_ROUNDS");

    return s ? atoi(s) : 1;
}

static void check(ix_ctx *ctx, int kind, int pair)
{
    problem p = {.ctx = ctx, .pair = pair, .close = rounds() > 1};
    ix_rng r = {(uint64_t)(1000 * kind + pair)};
    static const int n[2] = {1, 1};
    ix_bisector s;
    ix_mv *c[2];

    p.kind = pair_kinds[kind].name;
    pair_make(ctx, 1, kind, pair, c);
    {
        const ix_mv *const a[1] = {c[0]}, *const b[1] = {c[1]};
        const ix_mv *const *const both[2] = {a, b};

        ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, a, 1, b, 0, &s));
        check_bisector(&p, n, both, &s, &r);
    }
    ix_bisector_free(ctx, &s);
    for (int k = 0; k < 2; k++)
        ix_mv_unref(ctx, c[k]);
}

/* Pairs in which something was wrong once: a piece that bends both ways between
 * two vertices; parts that came and went between two, and chords too long for
 * the size of the curves; exact pieces far from the origin; a part that begins
 * at the region behind a common end and goes to infinity; branches of crossings
 * at 1e-5 that did not reach them; feet beside a corner. */
static void found(void **state)
{
    static const int which[][2] = {{0, 287}, {5, 1028}, {12, 3}, {16, 15},
                                   {16, 50}, {6, 31},   {10, 4}, {19, 75}};

    (void)state;
    for (size_t i = 0; i < sizeof which / sizeof *which; i++) {
        ix_ctx *ctx = ix_ctx_new(NULL, NULL);

        check(ctx, which[i][0], which[i][1]);
        ix_ctx_free(ctx);
    }
}

/* Law: chords are as good as any tolerance that is asked for; a hundredth of it
 * takes ten times as many vertices. */
static long at_tolerance(ix_ctx *ctx, problem *p, const ix_mv *const *a,
                         const ix_mv *const *b)
{
    ix_bisector s;
    long n = 0;

    ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, a, 1, b, p->tol, &s));
    for (int i = 0; i < s.n; i++) {
        const ix_bisector_piece *g = &s.piece[i];
        int step = 1 + g->n / 12;

        n += g->kind == IX_CURVE_CURVE ? g->n : 0;
        for (int j = 0; j + 1 < g->n; j += step)
            check_chord(p, g->x + 2 * j, fmod(0.5 + 0.618 * j, 1));
    }
    ix_bisector_free(ctx, &s);
    return n;
}

static void tolerances(void **state)
{
    static const double tol[] = {1e-4, 1e-6, 3e-8};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    problem p = {.ctx = ctx, .kind = "tolerance", .pair = 2};
    long n, before = 0;
    ix_mv *c[2];

    (void)state;
    pair_make(ctx, 1, 2, 2, c);
    for (int k = 0; k < 2; k++) {
        const ix_mv *const one[1] = {c[k]};

        p.set[k] = truth_of(ctx, 1, one);
    }
    measure(&p);
    for (int i = 0; i < 3; i++, before = n) {
        const ix_mv *const a[1] = {c[0]}, *const b[1] = {c[1]};

        p.tol = tol[i];
        n = at_tolerance(ctx, &p, a, b);
        assert_true(n > 0 && (i == 0 || n < 15 * before));
    }
    for (int k = 0; k < 2; k++) {
        free(p.set[k].arc);
        ix_mv_unref(ctx, c[k]);
    }
    ix_ctx_free(ctx);
}

static void pairs(void **state)
{
    const char *one = getenv("IX_TEST_KIND");

    (void)state;
    for (int kind = 0; kind < PAIR_KINDS; kind++)
        for (int i = 0; i < rounds(); i++) {
            ix_ctx *ctx;

            if (one && atoi(one) != kind)
                continue;
            ctx = ix_ctx_new(NULL, NULL);
            check(ctx, kind, i);
            ix_ctx_free(ctx);
        }
}

/* Law: four branches meet in a crossing, here of the parabolas y = x^2 / 5 and
 * y = x^2 / 5 + angle x, angles from 1e-2 to 1e-7: ends within 1e-3 of it. */
static void small_angles(void **state)
{
    (void)state;
    for (int i = 2; i <= 7; i++) {
        ix_ctx *ctx = ix_ctx_new(NULL, NULL);
        double angle = pow(10, -i);
        pair_points a = {
            .n = 3, .degree = 2, .p = {{-1, 0.2}, {0, -0.2}, {1, 0.2}}};
        pair_points b = a;
        ix_bisector s;
        ix_mv *c[2];
        int ends = 0;

        b.p[0][1] -= angle;
        b.p[2][1] += angle;
        c[0] = pair_curve(ctx, &a);
        c[1] = pair_curve(ctx, &b);
        {
            const ix_mv *const *d = (const ix_mv *const *)c;

            ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, d, 1, d + 1, 0, &s));
        }
        for (int j = 0; j < s.n; j++)
            for (int e = 0; e < 2; e++) {
                const double *x = s.piece[j].x + (e ? 2 * s.piece[j].n - 2 : 0);

                ends += hypot(x[0], x[1]) < 1e-3;
            }
        assert_int_equal(ends, 4);
        ix_bisector_free(ctx, &s);
        for (int k = 0; k < 2; k++)
            ix_mv_unref(ctx, c[k]);
        ix_ctx_free(ctx);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pairs),
        cmocka_unit_test(found),
        cmocka_unit_test(small_angles),
        cmocka_unit_test(tolerances),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
