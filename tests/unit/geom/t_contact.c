/* t_contact.c - systems of several freeforms: errors and memory; the laws are
 * in tests/script/contact. */
#include "geom/contact.h"

#include "geom/meet_fields.h"
#include "geom/reflection.h"
#include "geomtest.h"

static ix_mv *line(gt *t, double x, double z)
{
    const double p[6] = {x, -x, 0.3, 1, z, 2};

    return gt_curve(t, 2, 2, NULL, 3, false, p);
}

static void test_errors(void **state)
{
    gt t = gt_begin(1);
    ix_mv *s = gt_random(&t, 2, 3, 0, IX_RAND_BEZIER, 3), *c = line(&t, 1, 0);
    ix_mv *d = line(&t, 2, 1), *e, *out;
    const ix_mv *three[3] = {s, s, c};
    const double z[3] = {0, 0, 1}, none[3] = {0, 0, 0};
    ix_solution_curves k;
    ix_solutions p;

    (void)state;
    ASSERT_OK(t.ctx, ix_mv_reparam(t.ctx, d, 0, 0, 2, &e));
    assert_int_equal(ix__srf_bitangents(t.ctx, s, c, 0, &k), IX_EARG);
    assert_int_equal(ix__srf_tritangents(t.ctx, three, &p), IX_EARG);
    assert_int_equal(ix__srf_contacts(t.ctx, s, s, NULL, NULL, &p), IX_EARG);
    assert_int_equal(ix__srf_contacts(t.ctx, s, s, s, NULL, &p), IX_EARG);
    assert_int_equal(ix__srf_contacts(t.ctx, s, s, c, e, &p), IX_EARG);
    assert_int_equal(ix__srf_access(t.ctx, s, none, s, 0, &k), IX_EARG);
    assert_int_equal(ix__srf_access(t.ctx, s, z, c, 0, &k), IX_EARG);
    assert_int_equal(ix__crv_srf_feet(t.ctx, s, s, 0, &k), IX_EARG);
    assert_int_equal(ix__reflected_line(t.ctx, s, none, z, z, &out), IX_EARG);
    assert_int_equal(ix__reflected_line(t.ctx, s, z, z, none, &out), IX_EARG);
    assert_int_equal(ix__reflected_line(t.ctx, c, z, z, z, &out), IX_EARG);
    assert_int_equal(ix__reflected_circle(t.ctx, s, z, none, 1, &out), IX_EARG);
    for (int i = 0; i < 3; i++)
        assert_null(out);
    ix_mv_unref(t.ctx, s);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, d);
    ix_mv_unref(t.ctx, e);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double a[12] = {0, 4, 0, 4, 0, 0, 4, 4, 0, 0, 1, 0.5};
    const double b[12] = {1, 1, 3, 3, 1, 1, 2, 3, -2, 2, -2, 2};
    const double m[6] = {0, 0, 0, 0, 1, -1}, r[2] = {1, 1.2};
    const ix_dir d[2] = {{IX_BEZIER, 2, 2, false, NULL},
                         {IX_BEZIER, 2, 2, false, NULL}};

    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, false, a, &f->in[0]));
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, false, b, &f->in[1]));
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, d, 3, false, m, &f->in[2]));
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, d, 1, false, r, &f->in[3]));
}

static ix_status fields(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const double z[3] = {0.1, 0.2, 1}, p[3] = {0, 0, 3};
    const ix_mv *c[4] = {f->in[2], f->in[3], f->in[2], f->in[3]};
    ix_mv *g;

    IX_TRY(ix__reflected_line(ctx, f->in[0], z, p, z, &g));
    ix_mv_unref(ctx, g);
    IX_TRY(ix__reflected_circle(ctx, f->in[0], z, z, 0.3, &g));
    ix_mv_unref(ctx, g);
    if (ix__ring_meet_field(ctx, c, &g) == IX_ENOMEM)
        return IX_ENOMEM;
    return ix__ruled_meet_field(ctx, c, out);
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    ix_solution_curves k;
    ix_solutions s;

    IX_TRY(ix__crv_srf_feet(ctx, f->in[2], f->in[0], 1e-2, &k));
    ix_solution_curves_free(ctx, &k);
    IX_TRY(ix__srf_contacts(ctx, f->in[0], f->in[1], f->in[2], f->in[3], &s));
    ix_solutions_free(ctx, &s);
    return fields(ctx, f, out);
}

static void test_memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
