/* Special positions, scales, agreement of the degree forms, extrema of the
 * curvature against sampling, and memory, for all operators on curves. */
#include <limits.h>
#include <string.h>

#include "crv_test.h"
#include "harness/fault.h"
#include "iritx/sym.h"
#include "ops/table.h"

static ix_mv *bezier(ix_ctx *ctx, int n, int nc, const double *pts)
{
    return make_crv(ctx, n, n, NULL, false, nc, pts);
}

static void refused(ix_ctx *ctx, ix_status got, const char *word)
{
    assert_int_equal(got, IX_EDOMAIN);
    if (!strstr(ix_ctx_message(ctx), word))
        fail_msg("'%s' does not say '%s'", ix_ctx_message(ctx), word);
}

/* A line at any place and slope, of degree 3: no evolute, no normal, zero
 * curvature throughout, no extrema. */
static void straight_line(void **state)
{
    static const double p[8] = {1e5 + 0.1, 1e5 + 0.4, 1e5 + 0.7, 1e5 + 1.0,
                                3.3,       3.5,       3.7,       3.9};
    static const double range[2] = {0, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *c = bezier(ctx, 4, 2, p), *out;
    ix_crv_feature *f;
    ix_root *r;
    ix_crvs e;
    int n;

    (void)state;
    refused(ctx, ix_evolute(ctx, c, NULL, NULL, &out), "straight");
    ASSERT_OK(ctx, ix_evolute_pieces(ctx, c, NULL, &e));
    assert_int_equal(e.n, 0);
    ix_crvs_free(ctx, &e);
    for (int k = IX_RULED_NORMAL; k <= IX_RULED_POLAR; k++)
        refused(ctx,
                ix_crv_ruled(ctx, c, (ix_ruled_kind)k, range, NULL, NULL, &out),
                "straight");
    refused(ctx, ix_focal_crv(ctx, c, NULL, NULL, &out), "plane");
    ASSERT_OK(ctx, ix_crv_inflections(ctx, c, &r, &n));
    assert_int_equal(n, 1);
    assert_int_equal(r[0].kind, IX_ROOT_INTERVAL);
    ix_roots_free(ctx, r, n);
    ASSERT_OK(ctx, ix_crv_features(ctx, c, &f, &n));
    assert_int_equal(n, 0);
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

/* The evolute of a circle is its centre, in every form; it has no extrema. */
static void circle(void **state)
{
    static const double center[3] = {1, -2, 7};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_crv_feature *f;
    ix_mv *c, *e, *low;
    int n;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, center, 3, &c));
    ASSERT_OK(ctx, ix_crv_features(ctx, c, &f, &n));
    assert_int_equal(n, 0);
    for (int form = 0; form < 4; form++) {
        ix_op_opts o = {(ix_degree_form)form, INT_MAX};
        double x[3];

        ASSERT_OK(ctx, ix_evolute(ctx, c, &o, NULL, &e));
        for (int i = 0; i <= 16; i++) {
            double t = i / 4.0;

            ASSERT_OK(ctx, ix_mv_point(ctx, e, &t, x));
            for (int k = 0; k < 3; k++)
                ASSERT_CLOSE(x[k], center[k], 1e-12);
        }
        if (form == 0) {
            ASSERT_OK(ctx, ix_sym_reduce(ctx, e, 0, NULL, &low));
            assert_int_equal(ix_mv_order(low, 0), 1);
            ix_mv_unref(ctx, low);
        }
        ix_mv_unref(ctx, e);
    }
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

/* The cusp (t^2, t^3): numerators and weight of the evolute have the common
 * factor t^2; without it the evolute passes through the cusp. */
static void cusp(void **state)
{
    static const double p[8] = {0, 0, 1. / 3, 1, 0, 0, 0, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *c = bezier(ctx, 4, 2, p), *e, *low;
    double t = 0, x[3];

    (void)state;
    ASSERT_OK(ctx, ix_evolute(ctx, c, NULL, NULL, &e));
    assert_int_equal(degree_of(e, 0), 6);
    ASSERT_OK(ctx, ix_sym_reduce(ctx, e, 1e-10, NULL, &low));
    assert_true(degree_of(low, 0) <= 4);
    ASSERT_OK(ctx, ix_mv_point(ctx, low, &t, x));
    assert_true(fabs(x[0]) <= 1e-9 && fabs(x[1]) <= 1e-9);
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, e);
    ix_mv_unref(ctx, low);
    ix_ctx_free(ctx);
}

/* Fields of negative degree are zero; a conic's inflection field is constant
 * and has no zero. */
static void negative_degrees(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(91);
    static const struct {
        ix_crv_field_kind kind;
        int degree, ncoords;
        bool rational;
    } rows[] = {
        {IX_CRV_INFLECTION, 1, 2, false},   {IX_CRV_INFLECTION, 1, 2, true},
        {IX_CRV_CRITICAL, 1, 2, false},     {IX_CRV_CRITICAL, 1, 2, true},
        {IX_CRV_TORSION_ZERO, 2, 3, false}, {IX_CRV_TORSION_ZERO, 2, 3, true}};

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        crv_kind k = {
            rows[i].degree, rows[i].ncoords, rows[i].rational, 0, 0, 0};
        ix_mv *c = rand_crv(ctx, &r, &k), *f;

        ASSERT_OK(ctx, ix_crv_field(ctx, c, rows[i].kind, NULL, NULL, &f));
        if (degree_of(f, 0) != 0 || !(fabs(ix_mv_axis(f, 0)[0]) <= 1e-15))
            fail_msg("row %zu: degree %d, %g", i, degree_of(f, 0),
                     ix_mv_axis(f, 0)[0]);
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, f);
    }
    ix_ctx_free(ctx);
}

/* Law: the definitions hold for unit curves far away and for small and large
 * ones. The bound is the rounding of the input (1e-10 of the curve at a
 * distance of 1e6) times the condition of third derivatives, about 1e4. */
static void scales(void **state)
{
    static const double at[4] = {0, 0, 1e6, 1e6}, size[4] = {1e-6, 1e6, 1, 10};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(92);

    (void)state;
    for (int i = 0; i < 8; i++) {
        crv_kind k = {3, 3, i & 4, 0, at[i % 4], size[i % 4]};
        double bound = k.at > 0 ? 1e-5 : 1e-9;
        ix_mv *c = rand_crv(ctx, &r, &k), *out;
        ix_report rep;

        ASSERT_OK(ctx, ix_evolute(ctx, c, NULL, &rep, &out));
        if (!(rep.residual <= bound))
            fail_msg("evolute %d: %g", i, rep.residual);
        ix_mv_unref(ctx, out);
        ASSERT_OK(ctx, ix_focal_crv(ctx, c, NULL, &rep, &out));
        if (!(rep.residual <= bound))
            fail_msg("focal curve %d: %g", i, rep.residual);
        ix_mv_unref(ctx, out);
        ix_mv_unref(ctx, c);
    }
    ix_ctx_free(ctx);
}

static void point_at(ix_ctx *ctx, const ix_mv *m, double t, double *x)
{
    x[2] = 0;
    ASSERT_OK(ctx, ix_mv_point(ctx, m, &t, x));
}

/* Law: all forms of a curve are one curve, relative to the distance from the
 * origin where that is above 1. */
static void forms_agree(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(93);

    (void)state;
    for (int i = 0; i < 8; i++) {
        crv_kind k = {3, 2 + (i & 1), i >> 1 & 1, i & 4 ? 3 : 0, 0, 0};
        ix_mv *c = rand_crv(ctx, &r, &k), *e[4];

        for (int form = 0; form < 4; form++) {
            ix_op_opts o = {(ix_degree_form)form, INT_MAX};

            ASSERT_OK(ctx, ix_evolute(ctx, c, &o, NULL, &e[form]));
        }
        for (int s = 0; s < 10; s++) {
            double dom[2], x[3], y[3], t, len = 1;

            ix_mv_domain(c, 0, dom);
            t = ix_rng_range(&r, dom[0], dom[1]);
            point_at(ctx, e[0], t, x);
            for (int a = 0; a < 3; a++)
                len = fmax(len, fabs(x[a]));
            for (int form = 1; form < 4; form++) {
                point_at(ctx, e[form], t, y);
                for (int a = 0; a < 3; a++)
                    if (!(fabs(x[a] - y[a]) <= 1e-10 * len * len))
                        fail_msg("curve %d form %d: %g, %g", i, form, x[a],
                                 y[a]);
            }
        }
        for (int form = 0; form < 4; form++)
            ix_mv_unref(ctx, e[form]);
        ix_mv_unref(ctx, c);
    }
    ix_ctx_free(ctx);
}

/* The marks of extrema nearest to t, at most gap away. */
static bool has_feature(const ix_crv_feature *f, int n, double t, double gap,
                        ix_crv_mark mark)
{
    for (int i = 0; i < n; i++)
        if (f[i].mark == mark && fabs(f[i].root.t - t) <= gap)
            return true;
    return false;
}

enum { SAMPLES = 2000 };

/* Law: every local maximum of the sampled curvature is listed, also at knots,
 * and each listed one is one. */
static void extrema_are_complete(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(94);
    int at_knots = 0;

    (void)state;
    for (int round = 0; round < 8; round++) {
        crv_kind k = {3, 2 + (round >> 1 & 1), round & 1, 5, 0, 0};
        ix_mv *c = rand_crv(ctx, &r, &k);
        static double v[SAMPLES + 1];
        ix_crv_feature *f;
        double dom[2], h;
        int n;

        ASSERT_OK(ctx, ix_crv_features(ctx, c, &f, &n));
        ix_mv_domain(c, 0, dom);
        h = (dom[1] - dom[0]) / SAMPLES;
        for (int i = 0; i <= SAMPLES; i++)
            ASSERT_OK(ctx, ix_crv_curvature(ctx, c, dom[0] + i * h, &v[i]));
        for (int i = 1; i < SAMPLES; i++)
            if (v[i] > v[i - 1] && v[i] > v[i + 1] &&
                !has_feature(f, n, dom[0] + i * h, 2 * h, IX_CRV_MAX))
                fail_msg("round %d: a maximum near %g is missing", round,
                         dom[0] + i * h);
        for (int i = 0; i < n; i++) {
            double d = 1e-5, t = f[i].root.t, a, b;

            at_knots += f[i].root.kind == IX_ROOT_JUMP;
            if (f[i].mark == IX_CRV_FLAT || f[i].mark == IX_CRV_STATIONARY)
                continue;
            ASSERT_OK(ctx, ix_crv_curvature(ctx, c, t - d, &a));
            ASSERT_OK(ctx, ix_crv_curvature(ctx, c, t + d, &b));
            a -= f[i].curvature;
            b -= f[i].curvature;
            if (f[i].mark == IX_CRV_MAX ? a > 0 || b > 0 : a < 0 || b < 0)
                fail_msg("round %d: no extremum at %g", round, t);
        }
        ix_crv_features_free(ctx, f, n);
        ix_mv_unref(ctx, c);
    }
    assert_true(at_knots > 0);
    ix_ctx_free(ctx);
}

/* --- errors and memory ---------------------------------------------------- */

static void bad_arguments(void **state)
{
    static const double p[4] = {0, 1, 2, 3}, empty[2] = {1, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *one = bezier(ctx, 4, 1, p), *two = bezier(ctx, 2, 2, p), *out;
    ix_op_opts o = {(ix_degree_form)7, 0};

    (void)state;
    assert_int_equal(ix_evolute(ctx, one, NULL, NULL, &out), IX_EARG);
    assert_int_equal(ix_evolute(ctx, two, &o, NULL, &out), IX_EARG);
    assert_int_equal(
        ix_crv_field(ctx, two, (ix_crv_field_kind)9, NULL, NULL, &out),
        IX_EARG);
    assert_int_equal(
        ix_crv_ruled(ctx, two, IX_RULED_TANGENT, empty, NULL, NULL, &out),
        IX_EARG);
    assert_null(out);
    assert_int_equal(ix_crv_graph(ctx, two, false, &out), IX_EARG);
    ix_mv_unref(ctx, one);
    ix_mv_unref(ctx, two);
    ix_ctx_free(ctx);
}

typedef struct {
    const ix_op *op;
    ix_op_args args;
    ix_op_opts o;
    ix_mv *out, *graph;
    ix_crv_feature *f;
    int n;
} memory;

static void setup(ix_ctx *ctx, void *state)
{
    memory *m = state;
    ix_rng r = ix_rng_new(95);
    crv_kind k = {3, 3, true, 2, 0, 0};

    m->args.mv[0] = rand_crv(ctx, &r, &k);
    m->args.num[1] = 1;
    m->out = m->graph = NULL;
    m->f = NULL;
}

static ix_status run_op(ix_ctx *ctx, void *state)
{
    memory *m = state;
    ix_report rep;

    return m->op->run(ctx, &m->args, &m->o, &rep, &m->out);
}

static ix_status run_features(ix_ctx *ctx, void *state)
{
    memory *m = state;

    return ix_crv_features(ctx, m->args.mv[0], &m->f, &m->n);
}

static void teardown(ix_ctx *ctx, void *state)
{
    memory *m = state;

    ix_mv_unref(ctx, m->args.mv[0]);
    ix_mv_unref(ctx, m->out);
    ix_crv_features_free(ctx, m->f, m->n);
    m->out = NULL;
    m->f = NULL;
}

/* Every allocation of every operator on one curve fails in turn. */
static void out_of_memory(void **state)
{
    memory m = {.o = {IX_FORM_MINIMAL, INT_MAX}};
    ix_fault_case c = {setup, run_op, teardown, &m};

    (void)state;
    for (m.op = ix__ops; m.op->name; m.op++)
        for (int form = 0;
             form < 3 && m.op->ndirs[1] == 0 && m.op->ndirs[0] == 1; form++) {
            m.o.form = (ix_degree_form)form;
            assert_true(ix_fault_run(&c) > 0);
        }
    c.run = run_features;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(straight_line),
        cmocka_unit_test(circle),
        cmocka_unit_test(cusp),
        cmocka_unit_test(negative_degrees),
        cmocka_unit_test(scales),
        cmocka_unit_test(forms_agree),
        cmocka_unit_test(extrema_are_complete),
        cmocka_unit_test(bad_arguments),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
