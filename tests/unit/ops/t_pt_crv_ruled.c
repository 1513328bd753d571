/* The ruled bisector surface of a point and a space curve: both planes hold on
 * all of it, rulings are what the header says, degrees of all forms. */
#include <limits.h>
#include <string.h>

#include "crv_test.h"
#include "geom/vec3.h"
#include "harness/build_case.h"
#include "harness/randmv.h"
#include "iritx/ops_bisect.h"

IX_TEST_FIXTURE(8201)

/* Point and derivative of a curve as three coordinates. */
static void jet(const ix_mv *c, double t, double x[3], double d[3])
{
    double v[2 * IX_MAX_COORDS];
    int nc = ix_mv_ncoords(c);

    x[2] = d[2] = 0;
    ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, c, t, 1, v));
    for (int k = 0; k < nc; k++) {
        x[k] = v[k];
        d[k] = v[nc + k];
    }
}

/* | |B - Q| - |B - x| | and the distance of B from the normal plane, relative
 * to the distance, times the sine of the angle of both planes. */
static double deviation(const ix_mv *c, const ix_mv *b, const double *q,
                        double t, double v)
{
    double x[3], d[3], uv[2] = {t, v}, p[3], f[3], y[3], e[3], dist, sine;

    jet(c, t, x, d);
    if (ix_mv_point(ctx, b, uv, p) != IX_OK)
        return 0.0;
    ix__sub3(p, x, f);
    ix__sub3(x, q, y);
    ix__cross3(y, d, e);
    sine = ix__len3(e) / (ix__len3(y) * ix__len3(d));
    dist = ix__dist3(p, q);
    return sine * fmax(fabs(ix__len3(f) - dist) / fmax(dist, 1.0),
                       fabs(ix__dot3(f, d)) / (fmax(dist, 1.0) * ix__len3(d)));
}

static void check_definition(const ix_mv *c, const ix_mv *b, const double *q,
                             double tol)
{
    double dom[2];

    ix_mv_domain(c, 0, dom);
    for (int i = 0; i < 24; i++) {
        double t = dom[0] + (dom[1] - dom[0]) * (i / 2 + 0.3) / 12, v = i & 1;
        double dev = deviation(c, b, q, t, i & 2 ? v : 0.4 * v);

        if (!(dev <= tol))
            fail_msg("deviation %g at (%g, %g)", dev, t, v);
    }
}

/* a d + b of the degree in t: [kind][rational][form]; polynomials of degree 1
 * and 2 have 5d-3 where 6d-6 is less. */
static const int degrees[2][2][4][2] = {
    {{{3, -1}, {3, -1}, {7, -3}, {7, -3}},
     {{4, -2}, {4, -1}, {17, 0}, {12, 0}}},
    {{{6, -6}, {7, -3}, {7, -3}, {7, -3}},
     {{6, -4}, {10, -3}, {17, 0}, {12, 0}}}};

static int expected(int kind, bool rational, int form, int d)
{
    const int *f = degrees[kind][rational][form];
    int n = f[0] * d + f[1];

    return kind == 1 && !rational && form == 0 && n < 5 * d - 3 ? 5 * d - 3 : n;
}

static void definition_holds(void **state)
{
    static const double bounds[4] = {1e-12, 1e-11, 1e-9, 1e-10};

    (void)state;
    for (int i = 0; i < 60; i++) {
        crv_kind k = {1 + i % 4, 2 + (i % 3 > 0), i & 4, i & 8 ? 2 : 0, 0, 0};
        ix_mv *c = rand_crv(ctx, &rng, &k), *b;
        double q[3] = {ix_rng_range(&rng, -2, 2), ix_rng_range(&rng, -2, 2),
                       ix_rng_range(&rng, -2, 2)};
        int kind = i % 2;

        for (int form = 0; form < 4; form++) {
            ix_op_opts o = {(ix_degree_form)form, INT_MAX};
            ix_ruling r = {kind ? IX_RULING_DIRECTRIX : IX_RULING_PLANES,
                           {-1, 2},
                           {0, 0, 0}};
            ix_report rep;

            ASSERT_OK(ctx,
                      ix_pt_crv_bisector3d(ctx, c, q, 0.5, &r, &o, &rep, &b));
            assert_int_equal(degree_of(b, 1), 1);
            if (degree_of(b, 0) != expected(kind, k.rational, form, k.degree))
                fail_msg("kind %d form %d degree %d rational %d: %d", kind,
                         form, k.degree, k.rational, degree_of(b, 0));
            assert_true(rep.residual <= 1e-6);
            check_definition(c, b, q, bounds[form]);
            ix_mv_unref(ctx, b);
        }
        ix_mv_unref(ctx, c);
    }
}

/* Law: n.(B - Q) = h, with the planes given, in the user's units. */
static void rulings_between_planes(void **state)
{
    (void)state;
    for (int i = 0; i < 12; i++) {
        crv_kind k = {3, 3, i & 1, 0, 100.0, 5.0};
        ix_mv *c = rand_crv(ctx, &rng, &k), *b;
        double q[3] = {101, 99, 103}, n[3], d[3], uv[2] = {0.3, 0};
        ix_ruling r = {IX_RULING_PLANES, {-3, 7}, {1, 2, -1}};
        ix_op_opts o = {i & 2 ? IX_FORM_PUBLISHED : IX_FORM_MINIMAL, INT_MAX};

        (void)ix__unit3(r.normal, n);
        ASSERT_OK(ctx, ix_pt_crv_bisector3d(ctx, c, q, 0.5, &r, &o, NULL, &b));
        for (int j = 0; j <= 4; j++) {
            uv[1] = j / 4.0;
            ASSERT_OK(ctx, ix_mv_point(ctx, b, uv, d));
            ix__sub3(d, q, d);
            if (!(fabs(ix__dot3(d, n) - (10 * uv[1] - 3)) <=
                  1e-11 * (10 + ix__len3(d))))
                fail_msg("%g at %g", ix__dot3(d, n), uv[1]);
        }
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, c);
    }
}

/* Law: B(h) = R + h E, E = (x - Q) x x', R.E = Q.E; the same surface in the
 * forms minimal, naive and irit. */
static void rulings_of_the_directrix(void **state)
{
    static const ix_degree_form forms[] = {IX_FORM_MINIMAL, IX_FORM_NAIVE,
                                           IX_FORM_IRIT};

    (void)state;
    for (int i = 0; i < 18; i++) {
        crv_kind k = {2 + i % 2, 3, i & 1, 0, 3.0, 0.25};
        ix_mv *c = rand_crv(ctx, &rng, &k), *b;
        double q[3] = {2, 3, 3}, x[3], d[3], e[3], lo[3], hi[3],
               uv[2] = {0.4, 0};
        ix_ruling r = {IX_RULING_DIRECTRIX, {0, 2}, {0, 0, 0}};
        ix_op_opts o = {forms[i % 3], INT_MAX};

        ASSERT_OK(ctx, ix_pt_crv_bisector3d(ctx, c, q, 0.5, &r, &o, NULL, &b));
        jet(c, uv[0], x, d);
        ix__sub3(x, q, x);
        ix__cross3(x, d, e);
        ASSERT_OK(ctx, ix_mv_point(ctx, b, uv, lo));
        uv[1] = 1;
        ASSERT_OK(ctx, ix_mv_point(ctx, b, uv, hi));
        ix__sub3(hi, lo, hi);
        ix__sub3(lo, q, lo);
        assert_true(fabs(ix__dot3(lo, e)) <=
                    1e-10 * ix__len3(lo) * ix__len3(e));
        ix__axpy3(hi, -2.0, e, hi);
        if (!(ix__len3(hi) <= 1e-10 * (ix__len3(e) + ix__len3(lo))))
            fail_msg("form %d: ruling off by %g of %g", o.form, ix__len3(hi),
                     2 * ix__len3(e));
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, c);
    }
}

/* The published directrix has w^2 E for its rulings. */
static void published_rulings(void **state)
{
    crv_kind k = {2, 3, true, 0, 3.0, 0.25};
    ix_mv *c = rand_crv(ctx, &rng, &k), *b;
    double q[3] = {2, 3, 3}, x[3], d[3], e[3], lo[3], hi[3], uv[2] = {0.4, 0},
           w[4];
    ix_ruling r = {IX_RULING_DIRECTRIX, {0, 1}, {0, 0, 0}};
    ix_op_opts o = {IX_FORM_PUBLISHED, INT_MAX};

    (void)state;
    ASSERT_OK(ctx, ix_pt_crv_bisector3d(ctx, c, q, 0.5, &r, &o, NULL, &b));
    jet(c, uv[0], x, d);
    ix__sub3(x, q, x);
    ix__cross3(x, d, e);
    ASSERT_OK(ctx, ix_mv_eval(ctx, c, uv, w));
    ASSERT_OK(ctx, ix_mv_point(ctx, b, uv, lo));
    uv[1] = 1;
    ASSERT_OK(ctx, ix_mv_point(ctx, b, uv, hi));
    for (int j = 0; j < 3; j++)
        ASSERT_CLOSE(hi[j] - lo[j], w[0] * w[0] * e[j], 1e-11);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, c);
}

/* Law: the coplanar isoparametric curve of a planar curve and a point in its
 * plane is their planar bisector, in both approaches (Chen et al., Fig. 6). */
static void contains_the_planar_bisector(void **state)
{
    (void)state;
    for (int i = 0; i < 20; i++) {
        crv_kind k = {3, 2, i & 1, 0, 0, 0};
        ix_mv *c = rand_crv(ctx, &rng, &k), *s, *b;
        double q[3] = {1.5, ix_rng_range(&rng, -2, 2), 0};
        ix_ruling r = {
            i & 2 ? IX_RULING_DIRECTRIX : IX_RULING_PLANES, {-1, 1}, {0, 0, 0}};

        ASSERT_OK(ctx,
                  ix_pt_crv_bisector3d(ctx, c, q, 0.5, &r, NULL, NULL, &s));
        ASSERT_OK(ctx, ix_pt_crv_bisector(ctx, c, q, 0.5, NULL, NULL, &b));
        for (int j = 0; j < 7; j++) {
            double uv[2] = {(j + 0.5) / 7, 0.5}, x[3], y[2];

            if (ix_mv_point(ctx, b, uv, y) != IX_OK)
                continue;
            ASSERT_OK(ctx, ix_mv_point(ctx, s, uv, x));
            assert_true(hypot(x[0] - y[0], x[1] - y[1]) <=
                        1e-10 * (1 + hypot(y[0], y[1]) * hypot(y[0], y[1])));
            assert_true(fabs(x[2]) <= 1e-12 * (1 + hypot(y[0], y[1])));
        }
        ix_mv_unref(ctx, s);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, c);
    }
}

/* A straight line and a point: the parabolic cylinder |B - Q|^2 = |B x u|^2. */
static void line_and_point(void **state)
{
    const double line[6] = {-2, 2, 0, 0, 0, 0}, q[3] = {0, 2, 0};
    ix_mv *c = make_crv(ctx, 2, 2, NULL, false, 3, line), *b;
    ix_ruling r = {IX_RULING_PLANES, {-1, 1}, {0, 0, 0}};

    (void)state;
    ASSERT_OK(ctx, ix_pt_crv_bisector3d(ctx, c, q, 0.5, &r, NULL, NULL, &b));
    assert_int_equal(degree_of(b, 0), 2);
    for (int i = 0; i < 9; i++) {
        double uv[2] = {i / 8.0, (i % 3) / 2.0}, x[3];

        ASSERT_OK(ctx, ix_mv_point(ctx, b, uv, x));
        ASSERT_CLOSE(x[0], 4 * uv[0] - 2, 1e-14);
        ASSERT_CLOSE(x[1], 1 + x[0] * x[0] / 4, 1e-14);
        ASSERT_CLOSE(fabs(x[2]), fabs(2 * uv[1] - 1), 1e-14);
    }
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, c);
}

/* A turn around a line through the point: the rulings turn with it, no plane
 * serves all of them, and the pieces cover the domain without a pole. */
static void pieces_of_a_winding_curve(void **state)
{
    double pts[3 * 9], q[3] = {0, 0, 0.1}, at = 0;
    const double kv[12] = {0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 7, 7};
    ix_mv *c;
    ix_crvs p;

    (void)state;
    for (int i = 0; i < 9; i++) {
        pts[i] = 3 + 0.1 * i;
        pts[9 + i] = sin(0.9 * i);
        pts[18 + i] = cos(0.9 * i);
    }
    c = make_crv(ctx, 3, 9, kv, false, 3, pts);
    ASSERT_OK(ctx, ix_pt_crv_bisector3d_pieces(ctx, c, q, 0.5, NULL, NULL, &p));
    assert_true(p.n > 1);
    for (int i = 0; i < p.n; i++) {
        double dom[2];

        assert_true(p.t[2 * i] == at);
        at = p.t[2 * i + 1];
        ix_mv_domain(p.crv[i], 0, dom);
        assert_true(dom[0] == p.t[2 * i] && dom[1] == at);
        for (int j = 0; j < 20; j++) {
            double uv[2] = {dom[0] + (dom[1] - dom[0]) * (j + 0.5) / 20, j & 1};
            double dev = deviation(c, p.crv[i], q, uv[0], uv[1]);

            if (!(dev <= 1e-11))
                fail_msg("piece %d: deviation %g", i, dev);
        }
    }
    assert_true(at == 7.0);
    ix_crvs_free(ctx, &p);
    ix_mv_unref(ctx, c);
}

/* Law: a point far from the curve, and one near it. */
static void nasty_points(void **state)
{
    (void)state;
    for (int i = 0; i < 30; i++) {
        crv_kind k = {3, 3, i & 1, 0, 0, 0};
        ix_mv *c = rand_crv(ctx, &rng, &k), *b;
        double q[3] = {1e5, 2e5, -3e5}, near[3], d[3];

        ASSERT_OK(ctx,
                  ix_pt_crv_bisector3d(ctx, c, q, 0.5, NULL, NULL, NULL, &b));
        check_definition(c, b, q, 1e-11);
        ix_mv_unref(ctx, b);
        jet(c, 0.5, near, d);
        near[0] += 1e-6;
        ASSERT_OK(
            ctx, ix_pt_crv_bisector3d(ctx, c, near, 0.5, NULL, NULL, NULL, &b));
        check_definition(c, b, near, 1e-9);
        ix_mv_unref(ctx, b);
        ix_mv_unref(ctx, c);
    }
}

/* --- errors --------------------------------------------------------------- */

static void expect(const ix_mv *c, const double *q, double alpha,
                   const ix_ruling *r, ix_status st, const char *text)
{
    ix_mv *b = NULL;
    ix_crvs p;

    assert_int_equal(ix_pt_crv_bisector3d(ctx, c, q, alpha, r, NULL, NULL, &b),
                     st);
    assert_null(b);
    if (!strstr(ix_ctx_message(ctx), text))
        fail_msg("\"%s\" is not in \"%s\"", text, ix_ctx_message(ctx));
    if (!r || r->normal[0] == 0) {
        assert_int_equal(
            ix_pt_crv_bisector3d_pieces(ctx, c, q, alpha, r, NULL, &p), st);
        assert_int_equal(p.n, 0);
    }
}

static void refused(void **state)
{
    const double line[9] = {0, 1, 3, 0.1, 1.1, 3.1, 0.2, 1.2, 3.2};
    const double dot[9] = {1, 1, 1, 2, 2, 2, 3, 3, 3},
                 flat[9] = {0, 1, 3, 0, 2, 1};
    const double on[3] = {-1, -0.9, -0.8}, off[3] = {1, 2, 0},
                 bad[3] = {0, 0, NAN};
    ix_ruling r = {IX_RULING_PLANES, {0, INFINITY}, {0, 0, 0}};
    ix_mv *c = make_crv(ctx, 3, 3, NULL, false, 3, line);

    (void)state;
    expect(c, on, 0.5, NULL, IX_EDOMAIN, "straight line through the point");
    expect(c, bad, 0.5, NULL, IX_EARG, "coordinate 3 of the point is nan");
    expect(c, off, NAN, NULL, IX_EARG, "a ratio of nan");
    expect(c, off, 0.5, &r, IX_EARG, "a range of rulings from 0 to inf");
    r = (ix_ruling){(ix_ruling_kind)2, {0, 1}, {0, 0, 0}};
    expect(c, off, 0.5, &r, IX_EARG, "ruling 2 is not 0 or 1");
    r = (ix_ruling){IX_RULING_PLANES, {0, 1}, {NAN, 0, 0}};
    expect(c, off, 0.5, &r, IX_EARG, "coordinate 1 of the normal is nan");
    ix_mv_unref(ctx, c);
    c = make_crv(ctx, 3, 3, NULL, false, 3, dot);
    expect(c, off, 0.5, NULL, IX_EDOMAIN, "a point over [0, 1]");
    ix_mv_unref(ctx, c);
    c = make_crv(ctx, 3, 3, NULL, false, 3, flat);
    r = (ix_ruling){IX_RULING_PLANES, {0, 1}, {1, 0, 0}};
    expect(c, off, 0.5, &r, IX_EDOMAIN, "are parallel to the planes");
    ix_mv_unref(ctx, c);
}

/* --- memory --------------------------------------------------------------- */

static void make(ix_ctx *own, ix_build_case *f)
{
    ix_rng r = ix_rng_new(36);
    crv_kind k = {2, 3, true, 2, 0, 0};

    f->in[0] = rand_crv(own, &r, &k);
}

static ix_status build(ix_ctx *own, const ix_build_case *f, ix_mv **out)
{
    const double q[3] = {0.5, 2, 1};
    ix_report rep;
    ix_crvs pieces;

    IX_TRY(ix_pt_crv_bisector3d_pieces(own, f->in[0], q, 0.5, NULL, NULL,
                                       &pieces));
    ix_crvs_free(own, &pieces);
    return ix_pt_crv_bisector3d(own, f->in[0], q, 0.5, NULL, NULL, &rep, out);
}

static void memory_may_fail(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(definition_holds),
        cmocka_unit_test(rulings_between_planes),
        cmocka_unit_test(rulings_of_the_directrix),
        cmocka_unit_test(published_rulings),
        cmocka_unit_test(contains_the_planar_bisector),
        cmocka_unit_test(line_and_point),
        cmocka_unit_test(pieces_of_a_winding_curve),
        cmocka_unit_test(nasty_points),
        cmocka_unit_test(refused),
        cmocka_unit_test(memory_may_fail),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
