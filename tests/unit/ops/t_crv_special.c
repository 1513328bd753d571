/* Special positions, knots and corners, extrema of the curvature against
 * sampling, and memory, for all operators on curves. That results are right, at
 * all scales and in all forms, is in t_crv_truth. */
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

/* The evolute of a circle is its centre, in every form; it has no extrema, and
 * the reports of its critical field, which is zero, say that it is right. */
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
        ix_report rep;

        ASSERT_OK(ctx, ix_crv_field(ctx, c, IX_CRV_CRITICAL, &o, &rep, &e));
        assert_true(rep.residual <= 1e-14);
        ix_mv_unref(ctx, e);
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

/* The cusps of (t^2, t^3) and (t^2, t^3, t^4) are maxima of the curvature, no
 * zeros of it, inside and at the end of the domain; an inflection is one. */
static void cusps_are_no_inflections(void **state)
{
    /* Bernstein coefficients over [-1, 1] and [0, 1] of t^2, t^3, t^4 */
    static const double inside[15] = {1,   0, -1. / 3, 0,  1, -1, .5, 0,
                                      -.5, 1, 1,       -1, 1, -1, 1};
    static const double at_end[15] = {0,   0, 1. / 6, .5, 1, 0, 0, 0,
                                      .25, 1, 0,      0,  0, 0, 1};
    static const double cubic[8] = {-1, -1. / 3, 1. / 3, 1, -1, 1, -1, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int i = 0; i < 5; i++) {
        ix_mv *c = i == 4 ? bezier(ctx, 4, 2, cubic)
                          : bezier(ctx, 5, 2 + i / 2, i & 1 ? at_end : inside);
        double want = i < 4 && i & 1 ? 0 : 0.5;
        ix_crv_feature *f;
        int n, near = 0;

        ASSERT_OK(ctx, ix_crv_features(ctx, c, &f, &n));
        for (int k = 0; k < n; k++)
            if (fabs(f[k].root.t - want) <= 1e-6) {
                assert_int_equal(f[k].mark, i == 4 ? IX_CRV_FLAT : IX_CRV_MAX);
                assert_true(i == 4 ? f[k].curvature == 0.0
                                   : !isfinite(f[k].curvature));
                near++;
            }
        assert_int_equal(near, 1);
        ix_crv_features_free(ctx, f, n);
        ix_mv_unref(ctx, c);
    }
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

/* --- double knots and corners ----------------------------------------------
 */

/* Cubic with knots of multiplicity 1, 2 (a jump of x'') and 3 (a corner). */
static ix_mv *knotted(ix_ctx *ctx, ix_rng *r, int nc, bool rational)
{
    static const double kv[14] = {0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 4, 4, 4, 4};
    double pts[40];

    for (int i = 0; i < 10; i++) {
        double angle = 0.5 * i + (i > 6 ? 1 : 0), w = 1;
        const double x[3] = {cos(angle), sin(angle), 0.4 * angle};

        if (rational)
            w = ix_rng_range(r, 0.9, 1.2);
        pts[i] = w;
        for (int k = 0; k < nc; k++)
            pts[(k + rational) * 10 + i] = w * x[k];
    }
    return make_crv(ctx, 4, 10, kv, rational, nc, pts);
}

/* The result over the piece [lo, hi] of the curve is that of the whole. */
static void compare_piece(ix_ctx *ctx, const ix_op *op, const ix_op_args *a,
                          const ix_op_opts *o, const ix_mv *whole, double lo)
{
    ix_op_args part = *a;
    ix_mv *c, *m;

    ASSERT_OK(ctx, ix_mv_region(ctx, a->mv[0], 0, lo, lo + 1, &c));
    part.mv[0] = c;
    ASSERT_OK(ctx, op->run(ctx, &part, o, NULL, &m));
    for (int i = 0; i < 3; i++) {
        double tv[2] = {lo + (i + 0.5) / 3, 1}, x[3], y[3], size = 0;
        int nc = ix_mv_ncoords(m);

        ASSERT_OK(ctx, ix_mv_point(ctx, whole, tv, x));
        ASSERT_OK(ctx, ix_mv_point(ctx, m, tv, y));
        for (int k = 0; k < nc; k++)
            size = fmax(size, fabs(x[k]));
        for (int k = 0; k < nc; k++)
            if (!(fabs(x[k] - y[k]) <= 1e-11 * size))
                fail_msg("%s form %d at %g: %g, of the piece %g", op->name,
                         o->form, tv[0], x[k], y[k]);
    }
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, m);
}

/* Law: whatever the knots, every operator in every form gives on each span
 * what it gives for that piece alone; where the curve has a corner the result
 * has a knot of full multiplicity. (The planes between which the minimal polar
 * developable lies are those of the whole curve.) */
static void knots_do_not_matter(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(96);

    (void)state;
    for (int i = 0; i < 4; i++) {
        ix_mv *c = knotted(ctx, &r, 2 + (i & 1), i >> 1);
        ix_op_args a = {.mv = {c}, .num = {0, 1}};

        for (const ix_op *op = ix__ops; op->name; op++)
            for (int form = 0; form < 4; form++) {
                const ix_op_opts o = {(ix_degree_form)form, INT_MAX};
                ix_mv *m;
                ix_dir d;
                int at_corner = 0;

                if (op->ndirs[0] != 1 || op->ndirs[1] || op->nnums > 2 ||
                    strcmp(op->name, "PTCRVBISECT") == 0 ||
                    strcmp(op->name, "FOCALSRF") == 0 ||
                    !(op->forms >> form & 1) ||
                    (!(i & 1) && (strcmp(op->name, "FOCALCRV") == 0)))
                    continue;
                ASSERT_OK(ctx, op->run(ctx, &a, &o, NULL, &m));
                for (int lo = 0; lo < 4; lo++)
                    compare_piece(ctx, op, &a, &o, m, lo);
                d = ix_mv_dir(m, 0);
                for (int k = 0; k < d.order + d.length; k++)
                    at_corner += d.knots[k] == 3;
                if (at_corner != d.order && strcmp(op->name, "DUALITY") != 0 &&
                    d.order > 1)
                    fail_msg("%s form %d: %d knots at the corner, order %d",
                             op->name, form, at_corner, d.order);
                ix_mv_unref(ctx, m);
            }
        ix_mv_unref(ctx, c);
    }
    ix_ctx_free(ctx);
}

/* --- ruled surfaces
 * ----------------------------------------------------------- */

/* The ruling at t, from its point for r = 0 on. */
static void ruling_at(ix_ctx *ctx, const ix_mv *s, double t, double *r)
{
    double a[3], b[3], tv[2] = {t, 0};

    ASSERT_OK(ctx, ix_mv_point(ctx, s, tv, a));
    tv[1] = 1;
    ASSERT_OK(ctx, ix_mv_point(ctx, s, tv, b));
    for (int k = 0; k < 3; k++)
        r[k] = b[k] - a[k];
}

/* Along a planar curve in space, here z = x / 2, rulings of TANDEVSRF and
 * NRMLSCROLL are in the plane, those of the others across it: cylinders. */
static void rulings_of_a_planar_curve(void **state)
{
    static const double range[2] = {0, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(97);
    crv_kind k = {4, 3, true, 0, 0, 0};
    ix_mv *c = gentle_crv(ctx, &r, &k), *plane, *s;
    double pts[20];

    (void)state;
    for (int a = 0; a < 4; a++)
        memcpy(pts + 5 * a, ix_mv_weights(c) + 5 * a, 5 * sizeof *pts);
    for (int i = 0; i < 5; i++)
        pts[15 + i] = pts[5 + i] / 2;
    plane = make_crv(ctx, 5, 5, NULL, true, 3, pts);
    for (int kind = IX_RULED_TANGENT; kind <= IX_RULED_POLAR; kind++) {
        bool inside = kind == IX_RULED_TANGENT || kind == IX_RULED_NORMAL;

        ASSERT_OK(ctx, ix_crv_ruled(ctx, plane, (ix_ruled_kind)kind, range,
                                    NULL, NULL, &s));
        for (int i = 0; i < 5; i++) {
            double v[3], len;

            ruling_at(ctx, s, (i + 0.5) / 5, v);
            len = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            assert_true(len > 0);
            if (inside)
                assert_true(fabs(v[2] - v[0] / 2) <= 1e-13 * len);
            else
                assert_true(fabs(v[0] + v[2] / 2) <= 1e-13 * len &&
                            fabs(v[1]) <= 1e-13 * len);
        }
        ix_mv_unref(ctx, s);
    }
    ix_mv_unref(ctx, plane);
    ix_mv_unref(ctx, c);
    ix_ctx_free(ctx);
}

/* Where the curvature is zero, at (t, t^3, t^4), t = 0, and at the cusp of
 * (t^2, t^3, t^4), rulings have length 0. */
static void rulings_that_vanish(void **state)
{
    /* over [-1, 1], degree 4; blossoms of t, t^2, t^3, t^4 */
    static const double t1[5] = {-1, -.5, 0, .5, 1};
    static const double t2[5] = {1, 0, -1. / 3, 0, 1};
    static const double t3[5] = {-1, .5, 0, -.5, 1};
    static const double t4[5] = {1, -1, 1, -1, 1}, range[2] = {0, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double pts[15], v[3], far[3];

    (void)state;
    memcpy(pts + 5, t3, sizeof t3);
    memcpy(pts + 10, t4, sizeof t4);
    for (int cusp = 0; cusp < 2; cusp++)
        for (int kind = IX_RULED_TANGENT; kind < IX_RULED_POLAR; kind++) {
            ix_mv *c, *s;

            memcpy(pts, cusp ? t2 : t1, sizeof t1);
            c = make_crv(ctx, 5, 5, NULL, false, 3, pts);
            ASSERT_OK(ctx, ix_crv_ruled(ctx, c, (ix_ruled_kind)kind, range,
                                        NULL, NULL, &s));
            ruling_at(ctx, s, 0.5, v);
            ruling_at(ctx, s, 0.9, far);
            for (int k = 0; k < 3; k++)
                if (cusp || kind != IX_RULED_TANGENT)
                    assert_true(fabs(v[k]) <=
                                1e-14 *
                                    (1 + hypot(hypot(far[0], far[1]), far[2])));
            ix_mv_unref(ctx, c);
            ix_mv_unref(ctx, s);
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

/* --- graphs ----------------------------------------------------------------
 */

/* Law: a graph is (t, f(t)): exactly, of polynomial and rational fields; with
 * nodes, as IRIT has it, at the ends. */
static void graphs(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(98);

    (void)state;
    for (int i = 0; i < 8; i++) {
        crv_kind k = {3, 2, i & 1, i & 2 ? 3 : 0, 0, 0};
        ix_mv *c = gentle_crv(ctx, &r, &k), *f, *g;
        bool nodes = i & 4;
        double dom[2];

        ASSERT_OK(ctx,
                  ix_crv_field(ctx, c,
                               i & 1 ? IX_CRV_CURVATURE_SQR : IX_CRV_CRITICAL,
                               NULL, NULL, &f));
        ASSERT_OK(ctx, ix_crv_graph(ctx, f, nodes, &g));
        ix_mv_domain(c, 0, dom);
        for (int j = 0; j <= 8; j++) {
            double t = dom[0] + (dom[1] - dom[0]) * j / 8, x[2], y;

            ASSERT_OK(ctx, ix_mv_point(ctx, g, &t, x));
            ASSERT_OK(ctx, ix_mv_point(ctx, f, &t, &y));
            if (!nodes || j == 0 || j == 8)
                ASSERT_CLOSE(x[0], t, 1e-13);
            ASSERT_CLOSE(x[1], y, 1e-13);
        }
        ix_mv_unref(ctx, g);
        ix_mv_unref(ctx, f);
        ix_mv_unref(ctx, c);
    }
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
        cmocka_unit_test(cusps_are_no_inflections),
        cmocka_unit_test(negative_degrees),
        cmocka_unit_test(knots_do_not_matter),
        cmocka_unit_test(rulings_of_a_planar_curve),
        cmocka_unit_test(rulings_that_vanish),
        cmocka_unit_test(extrema_are_complete),
        cmocka_unit_test(graphs),
        cmocka_unit_test(bad_arguments),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
