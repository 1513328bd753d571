/* Bisectors of segments and arcs of circles: conics, against distances by
 * closed forms. */
#include <stdlib.h>

#include "harness/fault.h"
#include "iritx/ops_plane.h"
#include "planar_pairs.h"

/* A segment (rho 0), or the arc around o over the angles mid -+ half. */
typedef struct {
    double p[2][2], o[2], rho, mid, half;
} carrier;

static double random_in(ix_rng *r, double lo, double hi)
{
    return ix_rng_range(r, lo, hi);
}

static carrier random_carrier(ix_rng *r, double x, bool arc)
{
    carrier c = {.rho = 0};

    for (int k = 0; k < 2; k++) {
        c.o[k] = random_in(r, -1, 1) + (k ? 0 : x);
        c.p[0][k] = random_in(r, -1, 1) + (k ? 0 : x);
        c.p[1][k] = random_in(r, -1, 1) + (k ? 0 : x);
    }
    if (!arc)
        return c;
    c.rho = random_in(r, 0.2, 1.5);
    c.mid = random_in(r, -3, 3);
    c.half = random_in(r, 0.2, 1.4);
    for (int e = 0; e < 2; e++) {
        double a = c.mid + (e ? c.half : -c.half);

        c.p[e][0] = c.o[0] + c.rho * cos(a);
        c.p[e][1] = c.o[1] + c.rho * sin(a);
    }
    return c;
}

/* Of degree 1 or 2, elevated by up to 2. */
static ix_mv *curve_of(ix_ctx *ctx, const carrier *c, int more)
{
    pair_points p = {.n = 2, .degree = 1};
    ix_mv *m, *up;
    int order;

    memcpy(p.p, c->p, sizeof c->p);
    if (c->rho > 0) {
        double out = c->rho / cos(c->half);

        p = (pair_points){.n = 3, .degree = 2, .rational = true};
        memcpy(p.p[0], c->p[0], sizeof p.p[0]);
        memcpy(p.p[2], c->p[1], sizeof p.p[2]);
        p.p[1][0] = c->o[0] + out * cos(c->mid);
        p.p[1][1] = c->o[1] + out * sin(c->mid);
        p.w[0] = p.w[2] = 1;
        p.w[1] = cos(c->half);
    }
    m = pair_curve(ctx, &p);
    order = p.degree + 1 + more;
    ASSERT_OK(ctx, ix_mv_raise(ctx, m, 0, order, &up));
    ix_mv_unref(ctx, m);
    return up;
}

static double distance(const carrier *c, const double x[2])
{
    double d[2] = {c->p[1][0] - c->p[0][0], c->p[1][1] - c->p[0][1]};
    double e[2] = {x[0] - c->p[0][0], x[1] - c->p[0][1]};
    double t = (d[0] * e[0] + d[1] * e[1]) / (d[0] * d[0] + d[1] * d[1]);
    double a = remainder(atan2(x[1] - c->o[1], x[0] - c->o[0]) - c->mid,
                         2 * 3.14159265358979323846);

    if (c->rho > 0 && fabs(a) <= c->half)
        return fabs(hypot(x[0] - c->o[0], x[1] - c->o[1]) - c->rho);
    if (!(c->rho > 0) && t > 0 && t < 1)
        return hypot(e[0] - t * d[0], e[1] - t * d[1]);
    return fmin(hypot(e[0], e[1]), hypot(x[0] - c->p[1][0], x[1] - c->p[1][1]));
}

/* Law: a piece with both feet on curves is a conic (or straight), begins and
 * ends with the polyline, and is as far from both, within 1e-11 of the distance
 * or the objects' size 1: some 1000 roundings and what arcs of 0.4 make of
 * them. */
static void check_piece(ix_ctx *ctx, const carrier c[2],
                        const ix_bisector_piece *g)
{
    double dom[2], x[2];

    assert_non_null(g->exact);
    assert_true(ix_mv_order(g->exact, 0) <= 3);
    ix_mv_domain(g->exact, 0, dom);
    for (int i = 0; i <= 8; i++) {
        double t = dom[0] + (dom[1] - dom[0]) * i / 8.0, a, b;

        if ((i == 0 && g->unbounded[0]) || (i == 8 && g->unbounded[1]))
            continue;
        ASSERT_OK(ctx, ix_mv_point(ctx, g->exact, &t, x));
        a = distance(&c[0], x);
        b = distance(&c[1], x);
        ASSERT_CLOSE(a, b, 1e-11 * fmax(1, a));
        for (int k = 0; k < 2 && i % 8 == 0; k++)
            ASSERT_CLOSE(x[k], g->x[(i ? 2 * (g->n - 1) : 0) + k],
                         1e-8 * fmax(1, a));
    }
}

static int check_pair(ix_ctx *ctx, ix_rng *r, int round)
{
    int conics = 0;
    carrier c[2];
    ix_mv *m[2];
    ix_bisector s;

    for (int i = 0; i < 2; i++) {
        c[i] = random_carrier(r, i * random_in(r, 0, 2), (round >> i) & 1);
        m[i] = curve_of(ctx, &c[i], round % 3);
    }
    ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, (const ix_mv *const *)m, 1,
                                     (const ix_mv *const *)(m + 1), 0, &s));
    for (int i = 0; i < s.n; i++)
        if (s.piece[i].kind == IX_CURVE_CURVE) {
            check_piece(ctx, c, &s.piece[i]);
            conics++;
        }
    ix_bisector_free(ctx, &s);
    ix_mv_unref(ctx, m[0]);
    ix_mv_unref(ctx, m[1]);
    return conics;
}

static void segments_and_arcs(void **state)
{
    const char *more = getenv("IX_TEST_ROUNDS");
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    int all = 0, rounds = more ? atoi(more) : 60;
    ix_rng r = {77};

    (void)state;
    for (int i = 0; i < rounds; i++)
        all += check_pair(ctx, &r, i);
    assert_true(all > rounds / 2);
    ix_ctx_free(ctx);
}

/* Circles of radius 1 and 1/2, 3 apart: the branch of the hyperbola with
 * |x| = 1/4, foci 0 and 3, seen from the middle; and two alike: a line. */
static void circles(void **state)
{
    const double o[3] = {0, 0, 0}, q[3] = {3, 0, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m[3];

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, o, 1, &m[0]));
    ASSERT_OK(ctx, ix_circle(ctx, q, 0.5, &m[1]));
    ASSERT_OK(ctx, ix_circle(ctx, q, 1, &m[2]));
    for (int k = 1; k < 3; k++) {
        double vertex = k == 1 ? 0.25 : 0, c2 = 2.25, x[2], a;
        ix_bisector s;

        ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, (const ix_mv *const *)m, 1,
                                         (const ix_mv *const *)(m + k), 0, &s));
        for (int i = 0; i < s.n; i++) {
            double dom[2], t;

            assert_non_null(s.piece[i].exact);
            ix_mv_domain(s.piece[i].exact, 0, dom);
            t = 0.5 * (dom[0] + dom[1]);
            ASSERT_OK(ctx, ix_mv_point(ctx, s.piece[i].exact, &t, x));
            x[0] -= 1.5;
            a = vertex * vertex;
            ASSERT_CLOSE(x[0], sqrt(a + a * x[1] * x[1] / (c2 - a)),
                         1e-12 * (1 + fabs(x[1])));
        }
        ix_bisector_free(ctx, &s);
    }
    for (int k = 0; k < 3; k++)
        ix_mv_unref(ctx, m[k]);
    ix_ctx_free(ctx);
}

/* A circle of radius 1 in one of radius 3, the centres 1/2 apart: on the
 * ellipse |x| + |x - (1/2, 0)| = 4, in spans of 120 degrees at most. */
static void ellipse(void **state)
{
    const double o[3] = {0, 0, 0}, q[3] = {0.5, 0, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double turn = 0;
    ix_bisector s;
    ix_mv *m[2];

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, o, 3, &m[0]));
    ASSERT_OK(ctx, ix_circle(ctx, q, 1, &m[1]));
    ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, (const ix_mv *const *)m, 1,
                                     (const ix_mv *const *)(m + 1), 0, &s));
    for (int i = 0; i < s.n; i++) {
        double dom[2], last[2] = {0, 0};

        assert_non_null(s.piece[i].exact);
        assert_int_equal(ix_mv_order(s.piece[i].exact, 0), 3);
        ix_mv_domain(s.piece[i].exact, 0, dom);
        for (int k = 0; k <= 60; k++) {
            double t = dom[0] + (dom[1] - dom[0]) * k / 60, x[2];

            ASSERT_OK(ctx, ix_mv_point(ctx, s.piece[i].exact, &t, x));
            ASSERT_CLOSE(hypot(x[0], x[1]) + hypot(x[0] - 0.5, x[1]), 4, 1e-14);
            turn += k ? atan2(last[0] * x[1] - last[1] * x[0],
                              last[0] * x[0] + last[1] * x[1])
                      : 0;
            memcpy(last, x, sizeof last);
        }
    }
    ASSERT_CLOSE(fabs(turn), 2 * 3.14159265358979323846, 1e-9);
    ix_bisector_free(ctx, &s);
    ix_mv_unref(ctx, m[0]);
    ix_mv_unref(ctx, m[1]);
    ix_ctx_free(ctx);
}

/* Law: of a cubic and a segment only straight pieces and those with one foot
 * at rest are exact. */
static void no_conic(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = {78};
    int all = 0;

    (void)state;
    for (int i = 0; i < 10; i++) {
        pair_points a = pair_random(&r, 3, 1, false, 0, 0, 1);
        pair_points b = pair_random(&r, 1, 1, false, 1, 0, 1);
        ix_mv *m[2] = {pair_curve(ctx, &a), pair_curve(ctx, &b)};
        ix_bisector s;

        ASSERT_OK(ctx, ix_bisect_crv_crv(ctx, 1, (const ix_mv *const *)m, 1,
                                         (const ix_mv *const *)(m + 1), 0, &s));
        for (int k = 0; k < s.n; k++) {
            bool both = s.piece[k].kind == IX_CURVE_CURVE;

            all += both;
            assert_true(both ? !s.piece[k].exact : s.piece[k].exact != NULL);
        }
        ix_bisector_free(ctx, &s);
        ix_mv_unref(ctx, m[0]);
        ix_mv_unref(ctx, m[1]);
    }
    assert_true(all > 5);
    ix_ctx_free(ctx);
}

/* --- failing allocations ---------------------------------------------------
 */

typedef struct {
    ix_mv *m[2];
    ix_bisector s;
} fault_state;

static void fault_setup(ix_ctx *ctx, void *state)
{
    const carrier a = {.p = {{-1, 0}, {1, 0}}};
    const carrier b = {.p = {{-0.5, 1}, {0.5, 1}},
                       .o = {0, 1 + 0.5 / tan(0.8)},
                       .rho = 0.5 / sin(0.8),
                       .mid = -1.5707963267948966,
                       .half = 0.8};
    fault_state *f = state;

    *f = (fault_state){{curve_of(ctx, &a, 0), curve_of(ctx, &b, 0)}, {0}};
}

static ix_status fault_call(ix_ctx *ctx, void *state)
{
    fault_state *f = state;

    return ix_bisect_crv_crv(ctx, 1, (const ix_mv *const *)f->m, 1,
                             (const ix_mv *const *)(f->m + 1), 0.1, &f->s);
}

static void fault_teardown(ix_ctx *ctx, void *state)
{
    fault_state *f = state;

    ix_bisector_free(ctx, &f->s);
    ix_mv_unref(ctx, f->m[0]);
    ix_mv_unref(ctx, f->m[1]);
    *f = (fault_state){.s = {0}};
}

static void no_memory(void **state)
{
    fault_state s = {.s = {0}};
    ix_fault_case c = {fault_setup, fault_call, fault_teardown, &s};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(segments_and_arcs), cmocka_unit_test(circles),
        cmocka_unit_test(ellipse),           cmocka_unit_test(no_conic),
        cmocka_unit_test(no_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
