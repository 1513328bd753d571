/* Forms made in blocks of spans are those made of the whole curve at once. */
#include <limits.h>
#include <string.h>

#include "crv_test.h"
#include "harness/fault.h"
#include "ops/curve.h"
#include "ops/ratio.h"

/* Knots of multiplicity 1, 2 and, at every eighth, 3 (a jump in x'). */
static ix_mv *make(ix_ctx *ctx, ix_rng *r, int degree, int spans, bool rational)
{
    double kv[600], pts[4 * 600];
    int m = 0, n;

    for (int i = 0; i <= spans; i++) {
        int times = i == 0 || i == spans ? degree + 1
                    : i % 8 == 0         ? 3
                    : i % 3 == 0         ? 2
                                         : 1;

        while (times-- > 0)
            kv[m++] = i + 0.1 * (i % 5);
    }
    n = m - degree - 1;
    for (int i = 0; i < 4 * n; i++)
        pts[i] = i < n && rational ? ix_rng_range(r, 0.5, 2)
                                   : ix_rng_range(r, -1, 1);
    return make_crv(ctx, degree + 1, n, kv, rational, 3, pts);
}

/* Degrees and continuity of their own each: |x''|^2 w, T x', and nothing in
 * polynomial curves. */
static ix_status some_forms(ix_ctx *ctx, const ix_curve *c, void *arg,
                            ix_form *out)
{
    int *calls = arg;
    ix_frac x = ix__ratio_of(c), d, dd;

    ++*calls;
    IX_TRY(ix__ratio_derive(ctx, &x, &d));
    IX_TRY(ix__ratio_derive(ctx, &d, &dd));
    IX_TRY(ix__form_dot(ctx, &dd.x, &dd.x, &out[0]));
    IX_TRY(ix__form_mul(ctx, &c->d, &c->t, &out[1]));
    if (c->rational)
        out[2] = dd.w;
    return IX_OK;
}

static void same(const ix_form *a, const ix_form *b)
{
    const ix_spans *s = &a->dirs[0], *t = &b->dirs[0];

    assert_int_equal(a->nrows, b->nrows);
    assert_int_equal(s->degree, t->degree);
    assert_int_equal(s->nspans, t->nspans);
    assert_int_equal(a->exp, b->exp);
    assert_int_equal(a->bezier, b->bezier);
    assert_memory_equal(s->breaks, t->breaks,
                        ((size_t)s->nspans + 1) * sizeof *s->breaks);
    assert_memory_equal(s->cont, t->cont,
                        ((size_t)s->nspans - 1) * sizeof *s->cont);
    assert_memory_equal(a->c, b->c, (size_t)a->nrows * a->n * sizeof *a->c);
}

/* Law: bit by bit the same, joints included, for numbers of spans that fill
 * their blocks exactly, just not, and just more. */
static void blocks_change_nothing(void **state)
{
    static const int spans[] = {3, 64, 65, 96, 97, 127, 128, 200};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(11);

    (void)state;
    for (size_t i = 0; i < sizeof spans / sizeof *spans; i++)
        for (int q = 0; q < 2; q++) {
            ix_mv *m = make(ctx, &r, 4, spans[i], q);
            ix_mark mk = ix__scratch_mark(ctx);
            ix_form f[IX__CURVE_FORMS] = {{0}}, whole, blocks;
            const ix_form *parts[3] = {&f[0], &f[1], &f[2]};
            int once = 0, calls = 0;
            ix_curve c;

            ASSERT_OK(ctx, ix__curve_load(ctx, m, IX__CURVE, true, &c));
            ASSERT_OK(ctx, ix__curve_torsion(ctx, &c, &c.t, &c.et));
            ASSERT_OK(ctx, some_forms(ctx, &c, &once, f));
            ASSERT_OK(ctx, ix__form_join(ctx, q ? 3 : 2, parts, &whole));
            ASSERT_OK(ctx,
                      ix__curve_forms(ctx, &c, some_forms, &calls, &blocks));
            assert_true(spans[i] <= 64 ? calls == 1 : calls > 3);
            same(&whole, &blocks);
            ix__scratch_release(ctx, mk);
            ix_mv_unref(ctx, m);
        }
    ix_ctx_free(ctx);
}

/* A gentle curve with 109 spans, most of whose knots are none. */
static ix_mv *long_curve(ix_ctx *ctx, ix_rng *r)
{
    const crv_kind k = {4, 3, true, 30, 0, 0};
    ix_mv *m = gentle_crv(ctx, r, &k), *fine;
    double dom[2], t[79];

    ix_mv_domain(m, 0, dom);
    for (int i = 0; i < 79; i++)
        t[i] = dom[0] + (dom[1] - dom[0]) * (i + 0.63) / 80;
    ASSERT_OK(ctx, ix_mv_insert_knots(ctx, m, 0, 79, t, &fine));
    ix_mv_unref(ctx, m);
    return fine;
}

static void check_same_points(ix_ctx *ctx, const ix_mv *a, const ix_mv *b)
{
    double dom[2];

    ix_mv_domain(b, 0, dom);
    assert_int_equal(degree_of(a, 0), degree_of(b, 0));
    for (int i = 1; i < 16; i++) {
        double uv[2] = {dom[0] + (dom[1] - dom[0]) * i / 16, 0}, x[3], y[3];

        ASSERT_OK(ctx, ix_mv_point(ctx, a, uv, x));
        ASSERT_OK(ctx, ix_mv_point(ctx, b, uv, y));
        for (int k = 0; k < 3; k++)
            ASSERT_CLOSE(x[k], y[k], 1e-9);
    }
}

/* Law: an operator on a long curve has the values of that on a piece of it, and
 * its degree. 1e-9: the focal curve of a curve near a helix has a condition of
 * some 10^4, the forms lose as much again with a frame 20 times as wide as the
 * piece. */
static void long_curves(void **state)
{
    static const double range[2] = {0, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(12);
    ix_mv *m = long_curve(ctx, &r), *part;
    double dom[2];

    (void)state;
    ix_mv_domain(m, 0, dom);
    ASSERT_OK(ctx, ix_mv_region(ctx, m, 0, dom[0] + 3, dom[0] + 9, &part));
    for (int form = 0; form < 3; form++) {
        ix_op_opts o = {(ix_degree_form)form, INT_MAX};
        ix_mv *a, *b;

        ASSERT_OK(ctx, ix_focal_crv(ctx, m, &o, NULL, &a));
        ASSERT_OK(ctx, ix_focal_crv(ctx, part, &o, NULL, &b));
        check_same_points(ctx, a, b);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
        ASSERT_OK(ctx,
                  ix_crv_ruled(ctx, m, IX_RULED_NORMAL, range, &o, NULL, &a));
        ASSERT_OK(
            ctx, ix_crv_ruled(ctx, part, IX_RULED_NORMAL, range, &o, NULL, &b));
        check_same_points(ctx, a, b);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
    }
    ix_mv_unref(ctx, part);
    ix_mv_unref(ctx, m);
    ix_ctx_free(ctx);
}

/* --- out of memory ------------------------------------------------------ */

typedef struct {
    ix_mv *in, *out;
} fault_state;

static void fault_setup(ix_ctx *ctx, void *state)
{
    fault_state *f = state;
    ix_rng r = ix_rng_new(13);

    f->in = long_curve(ctx, &r);
    f->out = NULL;
}

static ix_status fault_op(ix_ctx *ctx, void *state)
{
    fault_state *f = state;
    const ix_op_opts o = {IX_FORM_PUBLISHED, INT_MAX};

    return ix_focal_crv(ctx, f->in, &o, NULL, &f->out);
}

static void fault_teardown(ix_ctx *ctx, void *state)
{
    fault_state *f = state;

    ix_mv_unref(ctx, f->in);
    ix_mv_unref(ctx, f->out);
}

static void out_of_memory(void **state)
{
    fault_state f;
    ix_fault_case c = {fault_setup, fault_op, fault_teardown, &f};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(blocks_change_nothing),
                                       cmocka_unit_test(long_curves),
                                       cmocka_unit_test(out_of_memory)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
