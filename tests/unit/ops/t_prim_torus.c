/* Bisectors of tori with planes and with what has their axis: points found by
 * bisection of the difference of distances lie on the surfaces, degrees, parts
 * beyond the torus left out. */
#include <string.h>

#include "geom/angle.h"
#include "geom/vec3.h"
#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/distance.h"
#include "iritx/geom_srf.h"
#include "iritx/ops_prim.h"

IX_TEST_FIXTURE(8701)

/* Distance, negative inside or below. */
static double signed_distance(const ix_prim *p, const double x[3])
{
    double r[3], u[3], z, rho, a = IX__RADIANS(p->degrees);

    ix__sub3(x, p->pos, r);
    (void)ix__unit3(p->dir, u);
    z = ix__dot3(r, u);
    rho = sqrt(fmax(0, ix__dot3(r, r) - z * z));
    switch (p->kind) {
    case IX_PRIM_PLANE:
        return z;
    case IX_PRIM_CONE:
        return rho * cos(a) - z * sin(a);
    case IX_PRIM_TORUS:
        return hypot(rho - p->major, z) - p->radius;
    default:
        return rho - p->radius;
    }
}

/* The point of the segment at which |f| and |g| are one, by bisection; false if
 * the ends do not enclose one. */
static bool meet(const ix_prim *a, const ix_prim *b, double ends[2][3],
                 double x[3])
{
    double lo = 0, hi = 1, sign = 0;

    for (int i = 0; i < 90; i++) {
        double t = i == 0 ? 0 : i == 1 ? 1 : 0.5 * (lo + hi), f;

        for (int k = 0; k < 3; k++)
            x[k] = ends[0][k] + t * (ends[1][k] - ends[0][k]);
        f = fabs(signed_distance(a, x)) - fabs(signed_distance(b, x));
        if (i == 0)
            sign = f;
        else if (i == 1 && !(f * sign < 0))
            return false;
        else if (i > 1 && f * sign < 0)
            hi = t;
        else if (i > 1)
            lo = t;
    }
    return true;
}

/* The axes of p, x along the part of n across it. */
static void axes_of(const ix_prim *p, const double n[3], double e[3][3])
{
    (void)ix__unit3(p->dir, e[2]);
    ix__axpy3(n, -ix__dot3(n, e[2]), e[2], e[0]);
    (void)ix__unit3(e[0], e[0]);
    ix__cross3(e[2], e[0], e[1]);
}

static double turn_param(double y, double x)
{
    double d = IX__DEG(atan2(y, x));

    return ix_circle_param(d < 0 ? d + 360 : d);
}

static void random_vec(double *v, double size)
{
    for (int k = 0; k < 3; k++)
        v[k] = ix_rng_range(&rng, -size, size);
}

static ix_prim random_torus(void)
{
    ix_prim p = {.kind = IX_PRIM_TORUS,
                 .radius = ix_rng_range(&rng, 0.1, 0.7),
                 .major = ix_rng_range(&rng, 0.8, 1.5)};

    random_vec(p.pos, 2);
    random_vec(p.dir, 1);
    return p;
}

/* Law: over the direction (u, v) of the torus' normal one of the surfaces has
 * the point that bisection of the distances found, v counted from the least g
 * on; and its points are as far from both, from the torus in their own half
 * plane. Degree (2, 2), on every side of the plane that has a part of the torus
 * one. Rounding over the part of B in the size: what remains of 1 - n.N. */
static void planes(void **state)
{
    int seen = 0, sides[3] = {0};

    (void)state;
    for (int i = 0; i < 60; i++) {
        ix_prim t = random_torus(), p = {.kind = IX_PRIM_PLANE};
        double e[3][3], n[3], ends[2][3], x[3], reach, at;
        ix_crvs s;

        random_vec(p.pos, i % 3 ? 2 : 4);
        random_vec(p.dir, 1);
        if (i % 4 == 0)
            t.radius = 0;
        (void)ix__unit3(p.dir, n);
        axes_of(&t, n, e);
        ASSERT_OK(ctx, ix_prim_bisector(ctx, &t, &p, 2, NULL, &s));
        /* the circle is at the height at -+ reach */
        at = signed_distance(&p, t.pos);
        reach = t.major * ix__dot3(n, e[0]);
        assert_int_equal(s.n, t.radius == 0 ? 1
                                            : (at + reach + t.radius > 0) +
                                                  (at - reach - t.radius < 0));
        sides[s.n]++;
        for (int j = 0; j < s.n; j++)
            for (int k = 0; k < 2; k++)
                assert_int_equal(ix_mv_order(s.crv[j], k), 3);
        for (int j = 0; j < 40; j++) {
            double r[3], g[3], gap = HUGE_VAL, uv[2], v0, rho, y[3], z;

            random_vec(ends[0], 4);
            random_vec(ends[1], 4);
            if (!meet(&t, &p, ends, x))
                continue;
            ix__sub3(x, t.pos, r);
            for (int k = 0; k < 3; k++)
                g[k] = ix__dot3(r, e[k]);
            uv[0] = turn_param(g[1], g[0]);
            rho = hypot(g[0], g[1]) - t.major;
            for (int k = 0; k < s.n; k++)
                for (int l = 0; l < 2; l++) { /* both ends of the normal */
                    bool above = at + reach + t.radius > 0 && k == 0;
                    double h = -at + (above ? -1 : 1) * t.radius;

                    v0 = atan2(ix__dot3(n, e[2]) * t.major, h);
                    z = atan2(g[2], rho) - v0 + l * IX__PI;
                    uv[1] = turn_param(sin(z), cos(z));
                    if (ix_mv_point(ctx, s.crv[k], uv, y) == IX_OK)
                        gap = fmin(gap, ix__dist3(x, y));
                }
            if (!(gap <= 1e-11))
                fail_msg("case %d: (%g, %g, %g) is %g off", i, x[0], x[1], x[2],
                         gap);
            seen++;
        }
        for (int j = 0; s.n == 1 && j < 36; j++) {
            double dom[2], uv[2] = {(j % 6 + 0.5) / 1.5, 0}, f, g;

            ix_mv_domain(s.crv[0], 1, dom);
            uv[1] = dom[0] + (dom[1] - dom[0]) * (j / 6 + 0.5) / 6;
            ASSERT_OK(ctx, ix_mv_point(ctx, s.crv[0], uv, x));
            f = fabs(signed_distance(&t, x));
            g = fabs(signed_distance(&p, x));
            if (!(fabs(f - g) <= 1e-12 * (1 + ix__len3(x))))
                fail_msg("case %d: %g and %g", i, f, g);
        }
        ix_crvs_free(ctx, &s);
    }
    assert_true(seen > 500 && sides[1] > 5 && sides[2] > 5);
}

/* Distance of a point from the curve over u, relative to its farthest control
 * point: of a flat parabola that is far away. */
static double off_surface(const ix_mv *m, double u, const double x[3])
{
    double t, d, far = 1;
    ix_mv *c;

    ASSERT_OK(ctx, ix_mv_fix(ctx, m, 0, u, &c));
    for (size_t i = 0; i < 3 * ix_mv_npts(c); i++)
        far = fmax(far, fabs(ix_mv_coord(c, 0)[i]) /
                            ix_mv_weights(c)[i % ix_mv_npts(c)]);
    ASSERT_OK(ctx, ix_crv_nearest(ctx, c, x, NULL, false, &t, &d));
    ix_mv_unref(ctx, c);
    return d / far;
}

/* Law: the same for what has the axis of the torus, in the half plane of the
 * first direction. */
static void around_the_axis(void **state)
{
    static const ix_prim_kind kinds[] = {IX_PRIM_LINE, IX_PRIM_PLANE,
                                         IX_PRIM_CYLINDER, IX_PRIM_CONE,
                                         IX_PRIM_TORUS};
    int seen[5] = {0}, both = 0;

    (void)state;
    for (int i = 0; i < 100; i++) {
        ix_prim t = random_torus(), b = {.kind = kinds[i % 5]};
        double e[3][3], ends[2][3], x[3];
        ix_crvs s;

        if (i % 7 == 0)
            t.radius = 1.7; /* a spindle */
        b.radius = i % 3                    ? ix_rng_range(&rng, 0.1, 3)
                   : b.kind == IX_PRIM_LINE ? 0
                                            : t.radius;
        if (b.kind == IX_PRIM_LINE)
            b.radius = 0;
        b.major = ix_rng_range(&rng, 0.5, 2);
        b.degrees = ix_rng_range(&rng, 10, 80);
        ix__axpy3(t.pos, ix_rng_range(&rng, -1, 1), t.dir, b.pos);
        for (int k = 0; k < 3; k++)
            b.dir[k] = i % 2 ? -2 * t.dir[k] : t.dir[k];
        if (ix_prim_bisector(ctx, &t, &b, 40, NULL, &s) != IX_OK)
            fail_msg("case %d: %s", i, ix_ctx_message(ctx));
        both += s.n > 1;
        (void)ix__unit3(t.dir, e[2]);
        ix__perp3(e[2], e[0]);
        for (int j = 0; j < s.n; j++)
            assert_true(ix_mv_order(s.crv[j], 0) == 3 &&
                        ix_mv_order(s.crv[j], 1) <= 3);
        for (int j = 0; j < 12; j++) {
            double gap = HUGE_VAL;

            for (int k = 0; k < 2; k++) {
                double rho = ix_rng_range(&rng, 0, 4),
                       z = ix_rng_range(&rng, -4, 4);

                ix__axpy3(t.pos, rho, e[0], ends[k]);
                ix__axpy3(ends[k], z, e[2], ends[k]);
            }
            if (!meet(&t, &b, ends, x))
                continue;
            for (int k = 0; k < s.n; k++)
                gap = fmin(gap, off_surface(s.crv[k], 0, x));
            if (!(gap <= 1e-12))
                fail_msg("case %d, kind %d: (%g, %g, %g) is %g off", i, b.kind,
                         x[0], x[1], x[2], gap);
            seen[i % 5]++;
        }
        ix_crvs_free(ctx, &s);
    }
    for (int i = 0; i < 5; i++)
        assert_true(seen[i] > 20);
    assert_true(both > 10);
}

static void expect(const ix_prim *a, const ix_prim *b, double size,
                   ix_status st, const char *text)
{
    ix_crvs s;

    assert_int_equal(ix_prim_bisector(ctx, a, b, size, NULL, &s), st);
    assert_int_equal(s.n, 0);
    if (!strstr(ix_ctx_message(ctx), text))
        fail_msg("\"%s\" is not in \"%s\"", text, ix_ctx_message(ctx));
}

static void refused(void **state)
{
    ix_prim t = {
        .kind = IX_PRIM_TORUS, .dir = {0, 0, 1}, .radius = 0.05, .major = 0.2};
    ix_prim b = {.kind = IX_PRIM_CONE,
                 .pos = {0, 0, 10},
                 .dir = {0, 0, 1},
                 .radius = 5,
                 .degrees = 30};

    (void)state;
    expect(&t, &t, 2, IX_EDOMAIN, "both are one torus");
    /* the parabola is beyond the axis next to its vertex */
    expect(&t, &b, 0.01, IX_EDOMAIN, "within 0.01 of the torus");
    b.pos[0] = 0.1;
    expect(&t, &b, 2, IX_EARG, "a torus and a cone are offered around one");
    b.kind = IX_PRIM_CYLINDER;
    expect(&t, &b, 2, IX_EARG, "radii of 0.05 and 5");
}

typedef struct {
    int which;
    ix_crvs s;
} operands;

static void make(ix_ctx *own, void *state)
{
    (void)own;
    ((operands *)state)->s = (ix_crvs){.n = 0};
}

static ix_status call(ix_ctx *own, void *state)
{
    static const ix_prim t = {
        .kind = IX_PRIM_TORUS, .dir = {0, 0, 1}, .radius = 0.8, .major = 1};
    static const ix_prim b[] = {{.kind = IX_PRIM_PLANE, .dir = {0, 1, 1}},
                                {.kind = IX_PRIM_PLANE, .dir = {0, 0, 1}},
                                {.kind = IX_PRIM_TORUS,
                                 .dir = {0, 0, 1},
                                 .pos = {0, 0, 0.5},
                                 .radius = 0.7,
                                 .major = 1}};
    operands *o = state;

    return ix_prim_bisector(own, &t, &b[o->which], 2, NULL, &o->s);
}

static void release(ix_ctx *own, void *state)
{
    ix_crvs_free(own, &((operands *)state)->s);
}

static void memory_may_fail(void **state)
{
    (void)state;
    for (int i = 0; i < 3; i++) {
        operands o = {.which = i};
        ix_fault_case c = {make, call, release, &o};

        assert_true(ix_fault_run(&c) > 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planes),
        cmocka_unit_test(around_the_axis),
        cmocka_unit_test(refused),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
