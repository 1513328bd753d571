/* t_tv_boolsum.c - volumes from faces, ruled pieces: errors and memory; the
 * laws are in tests/script/trivar, surface and layout. */
#include "geom/tv_boolsum.h"

#include "geom/ruled_pieces.h"
#include "geom/section_hermite.h"
#include "geomtest.h"
#include "iritx/geom_srf.h"

/* Law: lengths of all edges of the triangles are kept. */
static void test_strip(void **state)
{
    double p[9][3], q[9][3], pf[9][2], qf[9][2];
    gt t = gt_begin(1);

    (void)state;
    for (int i = 0; i < 9; i++)
        for (int k = 0; k < 3; k++) {
            p[i][k] = ix_rng_range(&t.r, 0, 1) + i;
            q[i][k] = ix_rng_range(&t.r, 0, 1) + i + (k == 1 ? 2 : 0);
        }
    ix__strip_flat(9, (const double(*)[3])p, (const double(*)[3])q, pf, qf);
    for (int i = 0; i < 9; i++) {
        double d = 0, e = 0;

        for (int k = 0; k < 3; k++) {
            d += (p[i][k] - q[i][k]) * (p[i][k] - q[i][k]);
            if (i > 0)
                e += (p[i][k] - q[i - 1][k]) * (p[i][k] - q[i - 1][k]);
        }
        ASSERT_CLOSE(hypot(pf[i][0] - qf[i][0], pf[i][1] - qf[i][1]), sqrt(d),
                     1e-10);
        if (i > 0)
            ASSERT_CLOSE(
                hypot(pf[i][0] - qf[i - 1][0], pf[i][1] - qf[i - 1][1]),
                sqrt(e), 1e-10);
    }
    gt_end(&t);
}

static void test_errors(void **state)
{
    gt t = gt_begin(2);
    ix_mv *s = gt_random(&t, 2, 3, 0, IX_RAND_BEZIER, 3);
    ix_mv *r = gt_random(&t, 2, 3, 1, IX_RAND_BEZIER, 3);
    ix_mv *c = gt_random(&t, 1, 3, 0, IX_RAND_BEZIER, 3), *out;
    const ix_mv *f[6] = {s, s, r, s, NULL, NULL}, *h[6] = {c, c, s, c, c, c};
    double *cut;
    int n;

    (void)state;
    assert_int_equal(ix__tv_boolsum(t.ctx, f, &out), IX_EARG);
    assert_int_equal(ix__tv_boolone(t.ctx, c, &out), IX_EARG);
    assert_int_equal(ix__srf_section_hermite(t.ctx, h, &out), IX_EARG);
    assert_int_equal(ix_tv_revolve(t.ctx, c, IX_TURN_RATIONAL, &out), IX_EARG);
    assert_int_equal(ix_tv_revolve(t.ctx, r, IX_TURN_POLYNOMIAL, &out),
                     IX_EARG);
    assert_null(out);
    assert_int_equal(ix__ruled_pieces(t.ctx, c, 0, 1, &n, &cut), IX_EARG);
    assert_int_equal(ix__ruled_pieces(t.ctx, s, 0, NAN, &n, &cut), IX_EARG);
    ix_mv_unref(t.ctx, s);
    ix_mv_unref(t.ctx, r);
    ix_mv_unref(t.ctx, c);
    gt_end(&t);
}

/* A square, a tube of four sides, a section. */
static void make(ix_ctx *ctx, ix_build_case *f)
{
    static const double square[12] = {0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0};
    static const double tube[30] = {0, 1, 1, 0, 0, 0, 2, 2, 0, 0,
                                    0, 0, 1, 1, 0, 0, 0, 2, 2, 0,
                                    0, 0, 0, 0, 0, 1, 1, 1, 1, 1};
    static const double kv[7] = {0, 0, 1, 2, 3, 4, 4};
    static const double kw[4] = {0, 0, 1, 1}, section[4] = {-1, 1, 0, 0};
    const ix_dir d[2] = {{IX_BEZIER, 2, 2, false, NULL},
                         {IX_BEZIER, 2, 2, false, NULL}};
    const ix_dir e[2] = {{IX_BSPLINE, 2, 5, false, kv},
                         {IX_BSPLINE, 2, 2, false, kw}};

    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, false, square, &f->in[0]));
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, e, 3, false, tube, &f->in[1]));
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, d, 2, false, section, &f->in[2]));
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const ix_mv *c[6] = {f->in[2], f->in[2], f->in[2],
                         f->in[2], f->in[2], f->in[2]};
    const ix_mv *flat[6] = {f->in[0], f->in[0], f->in[0], f->in[0]};
    double *cut;
    ix_mv *m;
    ix_status st;
    int n;

    st = ix__tv_boolsum(ctx, flat, &m); /* they do not meet */
    if (st == IX_ENOMEM)
        return st;
    assert_int_equal(st, IX_EARG);
    IX_TRY(ix__tv_boolone(ctx, f->in[1], &m));
    ix_mv_unref(ctx, m);
    IX_TRY(ix_tv_revolve(ctx, f->in[0], IX_TURN_RATIONAL, &m));
    ix_mv_unref(ctx, m);
    IX_TRY(ix__ruled_pieces(ctx, f->in[0], 0, 1, &n, &cut));
    return ix__srf_section_hermite(ctx, c, out);
}

static void test_memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_strip),
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
