/* The Voronoi cell of some curves among others, the bisector of two sets of
 * curves, against dense sampling: crossing ones, with corners, closed, nested,
 * with ends in common, rational, far apart in size, equal ones.
 *
 * IX_TEST_ROUNDS=200 tries that many sets of each kind, and more closely;
 * IX_TEST_KIND=3 chooses one kind, IX_TEST_FIRST=17 begins with that set. By
 * default one set of each kind. */
#include "harness/fault.h"
#include "planar_check.h"
#include "planar_pairs.h"

enum { MOST = 8 };

static int number_of(const char *name, int otherwise)
{
    const char *s = getenv(name);

    return s ? atoi(s) : otherwise;
}

/* Curves; the first `own` of them are what the cell is around. */
typedef struct {
    int n, own;
    pair_points c[MOST];
} cells;

typedef void (*cells_maker)(ix_rng *r, cells *out);

static void start(ix_rng *r, int most, cells *out)
{
    out->n = ix_rng_int(r, 3, most);
    out->own = 1;
}

/* --- kinds -----------------------------------------------------------------
 */

static void scattered(ix_rng *r, cells *o)
{
    start(r, MOST, o);
    for (int i = 0; i < o->n; i++)
        o->c[i] = pair_random(r, ix_rng_int(r, 1, 4), 1, false,
                              ix_rng_range(r, -1, 1), ix_rng_range(r, -1, 1),
                              0.35);
}

static void heaped(ix_rng *r, cells *o)
{
    start(r, 5, o);
    for (int i = 0; i < o->n; i++)
        o->c[i] = pair_simple(r);
}

static void rational(ix_rng *r, cells *o)
{
    start(r, 6, o);
    for (int i = 0; i < o->n; i++)
        o->c[i] = pair_random(r, ix_rng_int(r, 2, 4), ix_rng_int(r, 1, 2), true,
                              ix_rng_range(r, -1, 1), ix_rng_range(r, -1, 1),
                              0.5);
}

static void polylines(ix_rng *r, cells *o)
{
    start(r, 5, o);
    for (int i = 0; i < o->n; i++)
        o->c[i] = pair_random(r, 1, ix_rng_int(r, 2, 5), false,
                              ix_rng_range(r, -1, 1), ix_rng_range(r, -1, 1),
                              0.6);
}

/* A ring in the middle of others: its cell is bounded, or nearly. */
static void surrounded(ix_rng *r, cells *o)
{
    start(r, MOST, o);
    pair_ring(r, 0, 0, 0.4, &o->c[0]);
    for (int i = 1; i < o->n; i++) {
        double a = 2 * 3.14159265358979323846 * i / (o->n - 1);

        pair_ring(r, 1.5 * cos(a), 1.5 * sin(a), 0.35, &o->c[i]);
    }
}

/* Rings and open curves within a ring, whose cell it is, or that of one inside.
 */
static void enclosed(ix_rng *r, cells *o)
{
    int outer;

    start(r, 6, o);
    outer = ix_rng_int(r, 0, 1) ? 0 : o->n - 1;
    for (int i = 0; i < o->n; i++) {
        double a = 2.3 * i;

        if (i == outer)
            pair_ring(r, 0, 0, 2.5, &o->c[i]);
        else if (i & 1)
            pair_ring(r, 0.7 * cos(a), 0.7 * sin(a), 0.2, &o->c[i]);
        else
            o->c[i] = pair_random(r, 3, 2, false, 0.7 * cos(a), 0.7 * sin(a),
                                  0.3);
    }
}

/* The sides of a polygon, straight and bent ones. */
static void sides(ix_rng *r, cells *o)
{
    double p[MOST][2];

    start(r, MOST, o);
    for (int i = 0; i < o->n; i++) {
        double a = 2 * 3.14159265358979323846 * i / o->n;
        double s = ix_rng_range(r, 0.4, 1.2);

        p[i][0] = s * cos(a);
        p[i][1] = s * sin(a);
    }
    for (int i = 0; i < o->n; i++) {
        o->c[i] = pair_random(r, ix_rng_int(r, 1, 3), 1, false, 0, 0, 0.3);
        for (int k = 0; k < 2; k++) {
            const double *a = p[i], *b = p[(i + 1) % o->n];
            int n = o->c[i].n;

            for (int j = 1; j + 1 < n; j++)
                o->c[i].p[j][k] += 0.5 * (a[k] + b[k]);
            o->c[i].p[0][k] = a[k];
            o->c[i].p[n - 1][k] = b[k];
        }
    }
}

/* Curves that all begin in one point. */
static void star(ix_rng *r, cells *o)
{
    start(r, 6, o);
    for (int i = 0; i < o->n; i++) {
        o->c[i] = pair_random(r, ix_rng_int(r, 1, 3), 1, false, 0, 0, 1);
        o->c[i].p[0][0] = 0.1;
        o->c[i].p[0][1] = 0.2;
    }
}

/* One curve in pieces: smooth joints. */
static void chain(ix_rng *r, cells *o)
{
    start(r, 6, o);
    for (int i = 0; i < o->n; i++) {
        pair_points *c = &o->c[i];

        *c = pair_random(r, 3, 1, false, 0.7 * i - 1.5, 0, 0.6);
        for (int k = 0; i && k < 2; k++) {
            c->p[0][k] = c[-1].p[3][k];
            c->p[1][k] = 1.5 * c[-1].p[3][k] - 0.5 * c[-1].p[2][k];
        }
    }
    if (ix_rng_int(r, 0, 1)) { /* the cell of one in the middle */
        pair_points a = o->c[0];

        o->c[0] = o->c[1];
        o->c[1] = a;
    }
}

/* Whole numbers: equal distances by chance. */
static void lattice(ix_rng *r, cells *o)
{
    start(r, 6, o);
    for (int i = 0; i < o->n; i++) {
        pair_points *c = &o->c[i];

        *c = pair_random(r, ix_rng_int(r, 1, 3), 1, false, 0, 0, 1);
        for (int j = 0; j < c->n; j++)
            for (int k = 0; k < 2; k++)
                c->p[j][k] = ix_rng_int(r, -3, 3);
        c->p[c->n - 1][0] = c->p[0][0] + 1;
    }
}

/* One curve turned about a centre: every circle touches many. */
static void turned(ix_rng *r, cells *o)
{
    start(r, MOST, o);
    o->c[0] = pair_random(r, ix_rng_int(r, 1, 3), 1, false, 0.9, 0.1, 0.4);
    for (int i = 1; i < o->n; i++) {
        double a = 2 * 3.14159265358979323846 * i / o->n;

        o->c[i] = o->c[0];
        for (int j = 0; j < o->c[0].n; j++) {
            const double *p = o->c[0].p[j];

            o->c[i].p[j][0] = cos(a) * p[0] - sin(a) * p[1];
            o->c[i].p[j][1] = sin(a) * p[0] + cos(a) * p[1];
        }
    }
}

static void sizes(ix_rng *r, cells *o)
{
    start(r, MOST, o);
    for (int i = 0; i < o->n; i++)
        o->c[i] = pair_random(r, ix_rng_int(r, 1, 4), 1, false,
                              ix_rng_range(r, -1, 1), ix_rng_range(r, -1, 1),
                              pow(10, ix_rng_range(r, -4, 0)));
}

/* Some of the others are equal, or part of another. */
static void equal(ix_rng *r, cells *o)
{
    scattered(r, o);
    o->c[o->n - 1] = o->c[1];
    if (o->n > 3) /* the other way round */
        for (int i = 0; i < o->c[1].n; i++)
            memcpy(o->c[2].p[i], o->c[1].p[o->c[1].n - 1 - i],
                   sizeof o->c[2].p[i]);
    if (o->n > 3) {
        o->c[2].n = o->c[1].n;
        o->c[2].degree = o->c[1].degree;
    }
}

/* Several on either side. */
static void several(ix_rng *r, cells *o)
{
    if (ix_rng_int(r, 0, 1))
        scattered(r, o);
    else
        sides(r, o);
    o->own = ix_rng_int(r, 2, o->n - 1);
}

static void far_away(ix_rng *r, cells *o)
{
    double s = pow(10, ix_rng_range(r, -5, 5));

    scattered(r, o);
    for (int i = 0; i < o->n; i++)
        for (int j = 0; j < o->c[i].n; j++) {
            o->c[i].p[j][0] = s * (o->c[i].p[j][0] + 300);
            o->c[i].p[j][1] = s * (o->c[i].p[j][1] - 200);
        }
}

static const struct {
    const char *name;
    cells_maker make;
} kinds[] = {{"scattered", scattered},   {"heaped", heaped},
             {"rational", rational},     {"polylines", polylines},
             {"surrounded", surrounded}, {"enclosed", enclosed},
             {"sides", sides},           {"star", star},
             {"chain", chain},           {"lattice", lattice},
             {"turned", turned},         {"sizes", sizes},
             {"equal", equal},           {"several", several},
             {"far away", far_away}};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* --- checks ----------------------------------------------------------------
 */

static void check(ix_ctx *ctx, int kind, int index)
{
    problem p = {.ctx = ctx, .kind = kinds[kind].name, .pair = index};
    ix_rng r = {77u + (uint64_t)kind * 1000003u + (uint64_t)index * 7919u};
    const ix_mv *c[MOST];
    const ix_mv *const *sets[2];
    ix_mv *own[MOST];
    ix_bisector s;
    cells o;
    int n[2];

    r.s = ix_rng_next(&r);
    p.close = number_of("IX_TEST_ROUNDS", 1) > 1;
    kinds[kind].make(&r, &o);
    for (int i = 0; i < o.n; i++)
        c[i] = own[i] = pair_curve(ctx, &o.c[i]);
    n[0] = o.own;
    n[1] = o.n - o.own;
    sets[0] = c;
    sets[1] = c + o.own;
    ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, n[0], sets[0], n[1], sets[1], 0, &s));
    check_bisector(&p, n, sets, &s, &r);
    ix_bisector_free(ctx, &s);
    for (int i = 0; i < o.n; i++)
        ix_mv_unref(ctx, own[i]);
}

/* Sets in which something was wrong once: a third point as far out as both feet
 * hid the end at infinity. */
static void found(void **state)
{
    static const int which[][2] = {{9, 4}, {9, 39}};

    (void)state;
    for (size_t i = 0; i < sizeof which / sizeof *which; i++) {
        ix_ctx *ctx = ix_ctx_new(NULL, NULL);

        check(ctx, which[i][0], which[i][1]);
        ix_ctx_free(ctx);
    }
}

static void all_kinds(void **state)
{
    int one = number_of("IX_TEST_KIND", -1);
    int first = number_of("IX_TEST_FIRST", 0);

    (void)state;
    for (int kind = 0; kind < KINDS; kind++)
        for (int i = 0; i < number_of("IX_TEST_ROUNDS", 1); i++) {
            ix_ctx *ctx;

            if (one >= 0 && one != kind)
                continue;
            ctx = ix_ctx_new(NULL, NULL);
            check(ctx, kind, first + i);
            ix_ctx_free(ctx);
        }
}

/* --- memory ----------------------------------------------------------------
 */

typedef struct {
    ix_mv *c[3];
    ix_bisector s;
} fault_state;

static void fault_setup(ix_ctx *ctx, void *state)
{
    fault_state *f = state;

    *f = (fault_state){0};
    for (int i = 0; i < 3; i++) {
        pair_points p = {
            .n = 2, .degree = 1, .p = {{i, 0}, {i * 0.5, 1 + 0.2 * i}}};

        f->c[i] = pair_curve(ctx, &p);
    }
}

static ix_status fault_call(ix_ctx *ctx, void *state)
{
    fault_state *f = state;
    const ix_mv *const c[3] = {f->c[0], f->c[1], f->c[2]};

    return ix_bisect_crv_crv(ctx, 1, c, 2, c + 1, 0.1, &f->s);
}

static void fault_teardown(ix_ctx *ctx, void *state)
{
    fault_state *f = state;

    ix_bisector_free(ctx, &f->s);
    for (int i = 0; i < 3; i++)
        ix_mv_unref(ctx, f->c[i]);
    *f = (fault_state){0};
}

static void no_memory(void **state)
{
    fault_state f = {0};
    ix_fault_case c = {fault_setup, fault_call, fault_teardown, &f};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_kinds),
        cmocka_unit_test(found),
        cmocka_unit_test(no_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
