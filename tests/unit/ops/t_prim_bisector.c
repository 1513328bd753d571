/* Bisectors of primitives: every point has equal distances from both by closed
 * forms of the distance, in all pairs, positions and orders. */
#include <limits.h>
#include <string.h>

#include "geom/angle.h"
#include "geom/vec3.h"
#include "harness/fault.h"
#include "harness/randmv.h"
#include "iritx/ops_prim.h"

IX_TEST_FIXTURE(8501)

enum { NDIST = 4 };

/* The distances from x to the feet of its normals, 1 to 4 of them: untrimmed
 * bisectors have equal distances to some feet. */
static int distances(const ix_prim *p, const double x[3], double *d)
{
    double r[3], u[3] = {0, 0, 1}, z, rho, a = IX__RADIANS(p->degrees);

    ix__sub3(x, p->pos, r);
    (void)ix__unit3(p->dir, u);
    z = ix__dot3(r, u);
    rho = sqrt(fmax(0, ix__dot3(r, r) - z * z));
    switch (p->kind) {
    case IX_PRIM_POINT:
        d[0] = ix__len3(r);
        return 1;
    case IX_PRIM_LINE:
        d[0] = rho;
        return 1;
    case IX_PRIM_PLANE:
        d[0] = fabs(z);
        return 1;
    case IX_PRIM_SPHERE:
        d[0] = fabs(ix__len3(r) - p->radius);
        d[1] = ix__len3(r) + p->radius;
        return 2;
    case IX_PRIM_CYLINDER:
        d[0] = fabs(rho - p->radius);
        d[1] = rho + p->radius;
        return 2;
    case IX_PRIM_CONE:
        d[0] = fabs(rho * cos(a) - z * sin(a));
        d[1] = fabs(rho * cos(a) + z * sin(a));
        return 2;
    default:
        for (int i = 0; i < 4; i++)
            d[i] = fabs(hypot(rho + (i & 1 ? p->major : -p->major), z) +
                        (i & 2 ? p->radius : -p->radius));
        return 4;
    }
}

static double gap(const ix_prim *a, const ix_prim *b, const double x[3])
{
    double da[NDIST], db[NDIST], best = HUGE_VAL;
    int na = distances(a, x, da), nb = distances(b, x, db);

    for (int i = 0; i < na; i++)
        for (int j = 0; j < nb; j++)
            best = fmin(best, fabs(da[i] - db[j]));
    return best;
}

static double largest_weight(const ix_mv *m)
{
    double big = 0;

    for (size_t i = 0; i < ix_mv_npts(m); i++)
        big = fmax(big, fabs(ix_mv_weights(m)[i]));
    return big;
}

/* Conditioned points (not within a thousandth of a pole) of all surfaces. */
static int check_points(const ix_prim *a, const ix_prim *b, const ix_crvs *s,
                        double tol)
{
    int seen = 0;

    for (int i = 0; i < s->n; i++)
        for (int j = 0; j < 25; j++) {
            double t[2], x[3], w[4], dom[2], g, size;

            for (int k = 0; k < 2; k++) {
                ix_mv_domain(s->crv[i], k, dom);
                t[k] = dom[0] +
                       (dom[1] - dom[0]) * ((k ? j / 5 : j % 5) + 0.43) / 5;
            }
            ASSERT_OK(ctx, ix_mv_eval(ctx, s->crv[i], t, w));
            if (ix_mv_rational(s->crv[i]) &&
                fabs(w[0]) < 1e-3 * largest_weight(s->crv[i]))
                continue;
            if (ix_mv_point(ctx, s->crv[i], t, x) != IX_OK)
                continue;
            g = gap(a, b, x);
            size = 1 + ix__len3(x);
            if (!(g <= tol * size))
                fail_msg("kinds %d and %d: gap %g at (%g, %g, %g)", a->kind,
                         b->kind, g, x[0], x[1], x[2]);
            seen++;
        }
    return seen;
}

static void rand_vec(double *v, double size)
{
    for (int k = 0; k < 3; k++)
        v[k] = ix_rng_range(&rng, -size, size);
}

static ix_prim rand_prim(int kind)
{
    ix_prim p = {.kind = (ix_prim_kind)kind,
                 .radius = ix_rng_range(&rng, 0.2, 0.6),
                 .major = ix_rng_range(&rng, 0.8, 1.5),
                 .degrees = ix_rng_range(&rng, 15, 50)};

    rand_vec(p.pos, 2);
    rand_vec(p.dir, 1);
    return p;
}

/* Law: equal distances, for every pair that is offered and random positions;
 * rounding: 1e-9 of the distance from the origin, which is what the condition
 * of near-poles of weight 1e-3 leaves. */
static void equal_distances(void **state)
{
    (void)state;
    for (int i = 0; i < 420; i++) {
        int ka = i % 7, kb = i / 7 % 7;
        ix_prim a = rand_prim(ka), b = rand_prim(kb);
        ix_crvs s;
        ix_status st;

        if (ka == IX_PRIM_CONE &&
            (kb == IX_PRIM_LINE || (kb == IX_PRIM_CONE && i & 1)))
            memcpy(b.pos, a.pos, sizeof b.pos);
        if (i > 300) /* what becomes points and planes */
            b.radius = a.radius, b.degrees = a.degrees;
        if (kb == IX_PRIM_CONE && ka == IX_PRIM_LINE)
            memcpy(a.pos, b.pos, sizeof a.pos);
        st = ix_prim_bisector(ctx, &a, &b, 3.0, NULL, &s);
        if (st != IX_OK) {
            if (st != IX_EARG) /* not offered */
                fail_msg("kinds %d and %d: %s", ka, kb, ix_ctx_message(ctx));
            assert_true(ka == IX_PRIM_TORUS || kb == IX_PRIM_TORUS);
            assert_null(s.crv);
            continue;
        }
        if (check_points(&a, &b, &s, 1e-9) == 0)
            fail_msg("no point of kinds %d and %d", ka, kb);
        ix_crvs_free(ctx, &s);
    }
}

/* IRIT's choice of offsets is right for a sphere inside the other. */
static void irit_offsets(void **state)
{
    const ix_op_opts o = {IX_FORM_IRIT, INT_MAX};
    ix_prim ball = {.kind = IX_PRIM_SPHERE, .radius = 0.2};
    ix_prim a = {.radius = 1, .major = 2, .degrees = 30, .dir = {0, 0, 1}};

    (void)state;
    for (int kind = IX_PRIM_CYLINDER; kind <= IX_PRIM_TORUS; kind++) {
        ix_crvs s, t;

        a.kind = (ix_prim_kind)kind;
        ball.pos[0] = kind == IX_PRIM_TORUS ? 2.1 : 0.1;
        ball.pos[2] = kind == IX_PRIM_CONE ? 1.5 : 0.1;
        ASSERT_OK(ctx, ix_prim_bisector(ctx, &a, &ball, 2, &o, &s));
        ASSERT_OK(ctx, ix_prim_bisector(ctx, &ball, &a, 2, NULL, &t));
        assert_true(ix_mv_equal(s.crv[0], t.crv[0], 1e-12));
        assert_true(check_points(&a, &ball, &s, 1e-9) > 0);
        ix_crvs_free(ctx, &s);
        ix_crvs_free(ctx, &t);
    }
}

/* Coaxial cones of 50 and 20 degrees: the cone of 35; IRIT's offset: of 15. A
 * cone of 30 degrees and its axis: 15. A plane and its normal: 45. */
static void coaxial(void **state)
{
    static const double z[3] = {0, 0, 1};
    const ix_op_opts o[2] = {{IX_FORM_MINIMAL, INT_MAX},
                             {IX_FORM_IRIT, INT_MAX}};
    const struct {
        ix_prim_kind a, b;
        double da, db, angle;
        int form;
    } c[] = {{IX_PRIM_CONE, IX_PRIM_CONE, 50, 20, 35, 0},
             {IX_PRIM_CONE, IX_PRIM_CONE, 50, 20, 15, 1},
             {IX_PRIM_CONE, IX_PRIM_LINE, 30, 0, 15, 0},
             {IX_PRIM_LINE, IX_PRIM_PLANE, 0, 0, 45, 0}};

    (void)state;
    for (size_t i = 0; i < sizeof c / sizeof *c; i++) {
        ix_prim a = {.kind = c[i].a, .degrees = c[i].da, .dir = {0, 0, 1}};
        ix_prim b = {.kind = c[i].b, .degrees = c[i].db, .dir = {0, 0, 2}};
        ix_crvs s;

        ASSERT_OK(ctx, ix_prim_bisector(ctx, &a, &b, 2, &o[c[i].form], &s));
        assert_int_equal(s.n, 2);
        for (int j = 0; j < 2; j++) {
            double t[2] = {1.3, 0.7}, x[3], cosine;

            ASSERT_OK(ctx, ix_mv_point(ctx, s.crv[j], t, x));
            cosine = fabs(ix__dot3(x, z)) / ix__len3(x);
            ASSERT_CLOSE(cosine, cos(IX__RADIANS(c[i].angle)), 1e-13);
            assert_true(ix_mv_order(s.crv[j], 0) == 3);
            t[1] = 1;
            ASSERT_OK(ctx, ix_mv_point(ctx, s.crv[j], t, x));
            ASSERT_CLOSE(ix__len3(x), 2, 1e-12);
        }
        ix_crvs_free(ctx, &s);
    }
}

/* --- special positions ------------------------------------------------------
 */

enum { PT, LN, PL, SP, CY, CO, TO };

/* Local coordinates: positions, and directions along z ('d': against it), or
 * x. What is expected: surfaces, and the orders of the first in u and v. */
static const struct {
    struct {
        int kind;
        double pos[3], radius, degrees;
        char along;
    } p[2];
    int n, order[2];
} special[] = {
    /* cylinders with parallel axes: apart, inside, crossing, coaxial */
    {{{CY, {0, 0, 0}, .5, 0, 'z'}, {CY, {2, 0, 1}, .5, 0, 'z'}}, 1, {2, 2}},
    {{{CY, {0, 0, 0}, 1, 0, 'z'}, {CY, {3, 1, 0}, .4, 0, 'z'}}, 1, {3, 2}},
    {{{CY, {0, 0, 0}, .4, 0, 'z'}, {CY, {3, 1, 0}, 1, 0, 'd'}}, 1, {3, 2}},
    {{{CY, {0, 0, 0}, 2, 0, 'z'}, {CY, {.6, 0, 0}, .5, 0, 'z'}}, 1, {3, 2}},
    {{{CY, {0, 0, 0}, 1, 0, 'z'}, {CY, {1.2, 0, 0}, .8, 0, 'z'}}, 2, {3, 2}},
    {{{CY, {0, 0, 0}, 1, 0, 'z'}, {CY, {1.2, 0, 0}, 1, 0, 'z'}}, 2, {2, 2}},
    {{{CY, {0, 0, 0}, 1, 0, 'z'}, {CY, {0, 0, 2}, .4, 0, 'd'}}, 1, {3, 2}},
    {{{CY, {0, 0, 0}, 1, 0, 'z'}, {LN, {3, 0, 0}, 0, 0, 'z'}}, 1, {3, 2}},
    {{{CY, {0, 0, 0}, 1, 0, 'z'}, {LN, {0, .2, 0}, 0, 0, 'z'}}, 1, {3, 2}},
    {{{LN, {0, 0, 0}, 0, 0, 'z'}, {LN, {0, .2, 0}, 0, 0, 'd'}}, 1, {2, 2}},
    {{{LN, {0, 0, 0}, 0, 0, 'z'}, {LN, {0, 0, 2}, 0, 0, 'x'}}, 2, {2, 2}},
    /* a plane and what is parallel to it */
    {{{PL, {0, 0, 0}, 0, 0, 'x'}, {CY, {3, 1, 0}, .5, 0, 'z'}}, 2, {3, 2}},
    {{{PL, {0, 0, 0}, 0, 0, 'x'}, {CY, {-.2, 1, 0}, .5, 0, 'd'}}, 2, {3, 2}},
    {{{PL, {0, 0, 0}, 0, 0, 'x'}, {CY, {-.5, 1, 0}, .5, 0, 'z'}}, 2, {2, 2}},
    {{{PL, {0, 0, 0}, 0, 0, 'x'}, {LN, {2, 1, 0}, 0, 0, 'z'}}, 1, {3, 2}},
    {{{PL, {0, 0, 0}, 0, 0, 'x'}, {LN, {0, 1, 0}, 0, 0, 'z'}}, 1, {2, 2}},
    {{{PL, {0, 0, 0}, 0, 0, 'z'}, {PL, {1, 1, 2}, 0, 0, 'd'}}, 1, {2, 2}},
    {{{PL, {0, 0, 0}, 0, 0, 'z'}, {PL, {1, 1, 2}, 0, 0, 'x'}}, 2, {2, 2}},
    /* around one axis */
    {{{CO, {0, 0, 0}, 0, 30, 'z'}, {CO, {0, 0, 1}, 0, 20, 'z'}}, 2, {3, 2}},
    {{{CO, {0, 0, 0}, 0, 30, 'z'}, {CO, {0, 0, 1}, 0, 30, 'z'}}, 1, {3, 2}},
    {{{CO, {0, 0, 0}, 0, 30, 'z'}, {CO, {0, 0, 1}, 0, 30, 'd'}}, 2, {3, 2}},
    {{{CO, {0, 0, 0}, 0, 30, 'z'}, {CY, {0, 0, 1}, 1, 0, 'd'}}, 2, {3, 2}},
    /* cones of one angle: apexes level, one higher, one inside the other */
    {{{CO, {0, 0, 0}, 0, 30, 'z'}, {CO, {1, 0, 0}, 0, 30, 'z'}}, 2, {2, 2}},
    {{{CO, {0, 0, 0}, 0, 30, 'z'}, {CO, {1, 0, 1}, 0, 30, 'z'}}, 2, {3, 2}},
    {{{CO, {0, 0, 0}, 0, 30, 'z'}, {CO, {.2, 0, 1}, 0, 30, 'z'}}, 1, {3, 3}},
    {{{CO, {0, 0, 0}, 0, 10, 'z'}, {CO, {2, 0, 1}, 0, 10, 'z'}}, 1, {3, 2}},
    /* a line that misses the apex */
    {{{CO, {0, 0, 0}, 0, 30, 'z'}, {LN, {.5, 0, 0}, 0, 0, 'z'}}, 1, {3, 3}},
    {{{LN, {0, 0, 0}, 0, 0, 'z'}, {PT, {0, 0, .5}, 0, 0, 'z'}}, 1, {2, 2}},
    /* spheres of one radius along both spines */
    {{{CY, {0, 0, 0}, .3, 0, 'z'}, {CY, {0, 2, 1}, .3, 0, 'x'}}, 1, {3, 3}},
    {{{CY, {0, 0, 0}, .3, 0, 'z'}, {CY, {0, 0, 1}, .3, 0, 'x'}}, 2, {2, 2}},
    {{{TO, {0, 0, 0}, .3, 0, 'z'}, {CY, {.5, .2, 1}, .3, 0, 'x'}}, 1, {3, 3}},
    {{{TO, {0, 0, 0}, .3, 0, 'z'}, {TO, {.5, .2, 1}, .3, 0, 'x'}}, 1, {3, 3}},
    {{{TO, {0, 0, 0}, .3, 0, 'z'}, {TO, {0, 0, 1}, .3, 0, 'd'}}, 1, {3, 2}},
    {{{TO, {0, 0, 0}, 0, 0, 'z'}, {LN, {.5, .2, 1}, 0, 0, 'x'}}, 1, {3, 3}},
};

/* The local axes at a random place. */
static ix_prim placed(int i, int j, double axes[4][3])
{
    ix_prim p = {.kind = (ix_prim_kind)special[i].p[j].kind,
                 .radius = special[i].p[j].radius,
                 .degrees = special[i].p[j].degrees,
                 .major = 1.2};
    char along = special[i].p[j].along;

    for (int k = 0; k < 3; k++) {
        p.pos[k] = axes[3][k];
        for (int l = 0; l < 3; l++)
            p.pos[k] += special[i].p[j].pos[l] * axes[l][k];
        p.dir[k] = along == 'x'   ? axes[0][k]
                   : along == 'd' ? -2 * axes[2][k]
                                  : axes[2][k];
    }
    return p;
}

/* Law: equal distances in special positions too, as many surfaces as said and
 * in the degrees of the quadric; parallel cylinders to the nearest feet. */
static void special_positions(void **state)
{
    (void)state;
    for (int i = 0; i < (int)(sizeof special / sizeof *special); i++)
        for (int swap = 0; swap < 2; swap++) {
            double axes[4][3], v[3];
            ix_prim a, b;
            ix_crvs s;

            rand_vec(axes[3], 2);
            rand_vec(v, 1);
            (void)ix__unit3(v, axes[2]);
            ix__perp3(axes[2], axes[0]);
            ix__cross3(axes[2], axes[0], axes[1]);
            a = placed(i, swap, axes);
            b = placed(i, !swap, axes);
            if (ix_prim_bisector(ctx, &a, &b, 4.0, NULL, &s) != IX_OK)
                fail_msg("case %d: %s", i, ix_ctx_message(ctx));
            if (s.n != special[i].n)
                fail_msg("case %d: %d surfaces", i, s.n);
            if (ix_mv_order(s.crv[0], 0) != special[i].order[0] ||
                ix_mv_order(s.crv[0], 1) != special[i].order[1])
                fail_msg("case %d: orders %d and %d", i,
                         ix_mv_order(s.crv[0], 0), ix_mv_order(s.crv[0], 1));
            if (check_points(&a, &b, &s, 1e-9) == 0)
                fail_msg("case %d: no point", i);
            for (int k = 0;
                 a.kind == IX_PRIM_CYLINDER && a.kind == b.kind && k < 9 * s.n;
                 k++) {
                double dom[2][2], t[2], x[3], da[2], db[2];

                for (int l = 0; l < 2; l++) {
                    ix_mv_domain(s.crv[k / 9], l, dom[l]);
                    t[l] = dom[l][0] + (dom[l][1] - dom[l][0]) *
                                           ((l ? k % 3 : k / 3 % 3) + 0.4) / 3;
                }
                ASSERT_OK(ctx, ix_mv_point(ctx, s.crv[k / 9], t, x));
                (void)distances(&a, x, da);
                (void)distances(&b, x, db);
                ASSERT_CLOSE(da[0], db[0], 1e-11);
            }
            ix_crvs_free(ctx, &s);
        }
}

/* Plane z = 0 and the cone that opens along (cos a, 0, sin a) turned so that a
 * ruling is parallel to the plane: on the other side a parabolic cylinder. */
static void plane_and_ruling(void **state)
{
    (void)state;
    for (int i = 0; i < 8; i++) {
        ix_prim plane = {.kind = IX_PRIM_PLANE, .dir = {0, 0, -1}},
                cone = {.kind = IX_PRIM_CONE, .degrees = 20 + 5 * i};
        double a = IX__RADIANS(cone.degrees);
        ix_crvs s;

        cone.dir[0] = cos(a);
        cone.dir[2] = sin(a);
        cone.pos[1] = i;
        cone.pos[2] = i % 4; /* 0: the apex in the plane */
        ASSERT_OK(ctx, ix_prim_bisector(ctx, &plane, &cone, 2, NULL, &s));
        assert_int_equal(s.n, 2);
        assert_int_equal(ix_mv_order(s.crv[0], 0), i % 4 ? 3 : 2);
        assert_true(check_points(&plane, &cone, &s, 1e-9) > 0);
        ix_crvs_free(ctx, &s);
    }
}

/* Law: of a plane and a cylinder or cone each surface belongs to one side:
 * where it is outside, the nearest feet have equal distances, on both sides of
 * the plane. */
static void both_sides_of_a_plane(void **state)
{
    int above = 0, below = 0;

    (void)state;
    for (int i = 0; i < 40; i++) {
        ix_prim plane = {.kind = IX_PRIM_PLANE, .dir = {0, 0, 1}};
        ix_prim b = rand_prim(i & 1 ? IX_PRIM_CYLINDER : IX_PRIM_CONE);
        ix_crvs s;

        ASSERT_OK(ctx, ix_prim_bisector(ctx, &plane, &b, 3, NULL, &s));
        assert_int_equal(s.n, 2);
        for (int j = 0; j < 2 * 16; j++) {
            double dom[2][2], t[2], x[3], d[NDIST], e[3], along;
            double a = IX__RADIANS(b.degrees), u[3], rho;

            for (int k = 0; k < 2; k++) {
                ix_mv_domain(s.crv[j / 16], k, dom[k]);
                t[k] = dom[k][0] + (dom[k][1] - dom[k][0]) *
                                       ((k ? j % 4 : j / 4 % 4) + 0.6) / 4;
            }
            ASSERT_OK(ctx, ix_mv_point(ctx, s.crv[j / 16], t, x));
            (void)ix__unit3(b.dir, u);
            ix__sub3(x, b.pos, e);
            along = ix__dot3(e, u);
            rho = sqrt(fmax(0, ix__dot3(e, e) - along * along));
            if (i & 1 ? rho < b.radius : rho * cos(a) < along * sin(a))
                continue; /* inside */
            (void)distances(&b, x, d);
            if (!(fabs(d[0] - fabs(x[2])) <= 1e-9 * (1 + ix__len3(x))))
                fail_msg("case %d: %g and %g", i, d[0], fabs(x[2]));
            assert_true((x[2] > 0) == (j / 16 == 0));
            above += x[2] > 0;
            below += x[2] < 0;
        }
        ix_crvs_free(ctx, &s);
    }
    assert_true(above > 300 && below > 300);
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
    ix_prim a = {.kind = IX_PRIM_CYLINDER, .radius = 1, .dir = {0, 0, 1}};
    ix_prim b = {.kind = IX_PRIM_CYLINDER,
                 .radius = 0.5,
                 .dir = {0, 0, 3},
                 .pos = {4, 0, 0}};

    (void)state;
    expect(&a, &a, 2, IX_EDOMAIN, "both are one cylinder");
    expect(&a, &b, 0, IX_EARG, "a size of 0");
    b.kind = IX_PRIM_PLANE;
    expect(&b, &b, 2, IX_EDOMAIN, "both are one plane");
    b.kind = IX_PRIM_LINE;
    expect(&b, &b, 2, IX_EDOMAIN, "both are one line");
    b.kind = IX_PRIM_CONE;
    b.degrees = 90;
    expect(&a, &b, 2, IX_EARG, "an angle of 90 degrees");
    b.degrees = 30;
    expect(&b, &b, 2, IX_EDOMAIN, "both are one cone");
    a = b;
    a.pos[0] += 1;
    a.pos[2] = 9; /* inside b, and tan 30 < 1 below the middle */
    expect(&a, &b, 0.5, IX_EDOMAIN, "inside the other up to the height 0.5");
    a = (ix_prim){
        .kind = IX_PRIM_TORUS, .dir = {0, 0, 1}, .radius = 0.1, .major = 1};
    expect(&a, &b, 2, IX_EARG, "a torus and a cone are offered around one");
    b.kind = IX_PRIM_CYLINDER;
    expect(&a, &b, 2, IX_EARG, "radii of 0.1 and 0.5");
    expect(&a, &a, 2, IX_EDOMAIN, "both are one torus");
    a.kind = IX_PRIM_SPHERE;
    a.radius = -1;
    expect(&a, &b, 2, IX_EARG, "a radius of -1");
    a.kind = IX_PRIM_TORUS;
    a.radius = 0.1;
    a.major = 0;
    expect(&a, &b, 2, IX_EARG, "a major radius of 0");
    a.kind = IX_PRIM_POINT;
    expect(&a, &a, 2, IX_EDOMAIN, "both are one point");
    a.pos[1] = NAN;
    expect(&a, &b, 2, IX_EARG, "position (0, nan, 0)");
    a.kind = (ix_prim_kind)9;
    expect(&a, &b, 2, IX_EARG, "primitive 9");
    a = (ix_prim){.kind = IX_PRIM_LINE};
    expect(&a, &b, 2, IX_EARG, "no direction");
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
    static const ix_prim p[][2] = {
        {{.kind = IX_PRIM_PLANE, .dir = {0, 0, 1}},
         {.kind = IX_PRIM_CYLINDER, .dir = {0, 0.2, 1}, .radius = 0.4}},
        {{.kind = IX_PRIM_TORUS, .dir = {0, 0, 1}, .radius = 0.3, .major = 1},
         {.kind = IX_PRIM_SPHERE, .pos = {3, 0, 0}, .radius = 0.3}},
        {{.kind = IX_PRIM_LINE, .dir = {0, 0, 1}},
         {.kind = IX_PRIM_LINE, .pos = {3, 0, 0}, .dir = {0, 1, 0}}},
        {{.kind = IX_PRIM_CYLINDER, .dir = {0, 0, 1}, .radius = 0.3},
         {.kind = IX_PRIM_CONE,
          .pos = {3, 0, 0},
          .dir = {0, 1, 0},
          .degrees = 9}},
        {{.kind = IX_PRIM_CYLINDER, .dir = {0, 0, 1}, .radius = 1},
         {.kind = IX_PRIM_CYLINDER,
          .pos = {1, 0, 0},
          .dir = {0, 0, 1},
          .radius = 0.8}},
        {{.kind = IX_PRIM_CONE, .dir = {0, 0, 1}, .degrees = 30},
         {.kind = IX_PRIM_CONE,
          .pos = {1, 0, 1},
          .dir = {0, 0, 1},
          .degrees = 30}},
        {{.kind = IX_PRIM_CONE, .dir = {0, 0, 1}, .degrees = 30},
         {.kind = IX_PRIM_CYLINDER, .dir = {0, 0, 1}, .radius = 1}},
        {{.kind = IX_PRIM_PLANE, .dir = {1, 0, 0}},
         {.kind = IX_PRIM_PLANE, .dir = {0, 0, 1}}}};
    operands *o = state;

    return ix_prim_bisector(own, &p[o->which][0], &p[o->which][1], 2, NULL,
                            &o->s);
}

static void release(ix_ctx *own, void *state)
{
    ix_crvs_free(own, &((operands *)state)->s);
}

static void memory_may_fail(void **state)
{
    (void)state;
    for (int i = 0; i < 8; i++) {
        operands o = {.which = i};
        ix_fault_case c = {make, call, release, &o};

        assert_true(ix_fault_run(&c) > 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_distances),
        cmocka_unit_test(irit_offsets),
        cmocka_unit_test(coaxial),
        cmocka_unit_test(special_positions),
        cmocka_unit_test(plane_and_ruling),
        cmocka_unit_test(both_sides_of_a_plane),
        cmocka_unit_test(refused),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
