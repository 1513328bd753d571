/* Regions in which a field is positive: parity of the loops against the sign of
 * the field at random points; isoclines against angles of normals. */
#include "base/ctx.h"
#include "geomtest.h"
#include "iritx/contour.h"
#include "iritx/geom_srf.h"

/* Is x inside, by the parity of crossings of a ray to the right? *near: some
 * edge passes within tol of x. */
static bool inside(const ix_lines *l, const double *x, double tol, bool *near)
{
    const double(*p)[3] = (const double(*)[3])l->pt;
    bool in = false;

    *near = false;
    for (int i = 0; i < l->n; p += l->count[i], i++)
        for (int k = 0; k + 1 < l->count[i]; k++) {
            const double *a = p[k], *b = p[k + 1];
            double e[2] = {b[0] - a[0], b[1] - a[1]};
            double d[2] = {x[0] - a[0], x[1] - a[1]};
            double len = hypot(e[0], e[1]), t = 0;

            if (len > 0)
                t = fmin(1, fmax(0, (d[0] * e[0] + d[1] * e[1]) / len / len));
            *near |= hypot(d[0] - t * e[0], d[1] - t * e[1]) <= tol;
            if ((a[1] > x[1]) != (b[1] > x[1]) &&
                a[0] + (x[1] - a[1]) / e[1] * e[0] > x[0])
                in = !in;
        }
    return in;
}

/* Law: a point is inside exactly where the field is positive; the field and
 * its negative share the domain. */
static void parity_is_the_sign(void **state)
{
    gt t = gt_begin(1);
    int counted = 0, loops = 0;

    (void)state;
    for (int k = 0; k < 40; k++) {
        ix_mv *f = gt_random(&t, 2, 1, k % 4 == 3 ? 1 : -1,
                             IX_RAND_BEZIER | IX_RAND_OPEN, 3);
        ix_lines l;

        ASSERT_OK(t.ctx, ix_positive_region(t.ctx, f, 1e-3, &l));
        loops += l.n;
        for (int i = 0; i < l.n; i++)
            assert_true(l.count[i] >= 3);
        for (int i = 0; i < 60; i++) {
            double x[2] = {gt_param(&t, f, 0), gt_param(&t, f, 1)}, v[2],
                   dom[2];
            double wide = 0;
            bool near, in;

            for (int d = 0; d < 2; d++) {
                ix_mv_domain(f, d, dom);
                wide = fmax(wide, dom[1] - dom[0]);
            }
            in = inside(&l, x, 3e-3 * wide, &near);
            if (near)
                continue;
            ASSERT_OK(t.ctx, ix_mv_eval(t.ctx, f, x, v));
            assert_true(in == (v[ix_mv_rational(f)] > 0));
            counted++;
        }
        ix_lines_free(t.ctx, &l);
        ix_mv_unref(t.ctx, f);
    }
    assert_true(counted > 1500 && loops > 40);
    gt_end(&t);
}

/* (u - 1/2)(v - 1/2): two of four quarters, that meet in a node. */
static void a_node(void **state)
{
    const double p[4] = {0.25, -0.25, -0.25, 0.25};
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 2, .length = 2},
                         {.basis = IX_BEZIER, .order = 2, .length = 2}};
    gt t = gt_begin(2);
    ix_lines l;
    ix_mv *f;

    (void)state;
    ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 2, d, 1, false, p, &f));
    ASSERT_OK(t.ctx, ix_positive_region(t.ctx, f, 1e-3, &l));
    for (int i = 0; i < 100; i++) {
        double x[2] = {ix_rng_unit(&t.r), ix_rng_unit(&t.r)};
        bool near, in = inside(&l, x, 3e-3, &near);

        assert_true(near || in == ((x[0] - 0.5) * (x[1] - 0.5) > 0));
    }
    ix_lines_free(t.ctx, &l);
    ix_mv_unref(t.ctx, f);
    gt_end(&t);
}

/* (u - 1/2)^2 (v - 1/3): zero along u = 1/2 too, where no region ends. */
static void an_even_line(void **state)
{
    double p[6];
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 3, .length = 3},
                         {.basis = IX_BEZIER, .order = 2, .length = 2}};
    gt t = gt_begin(7);
    ix_lines l;
    ix_mv *f;

    (void)state;
    for (int i = 0; i < 6; i++)
        p[i] = (i % 3 == 1 ? -0.25 : 0.25) * (i / 3 ? 2 / 3.0 : -1 / 3.0);
    ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 2, d, 1, false, p, &f));
    ASSERT_OK(t.ctx, ix_positive_region(t.ctx, f, 1e-3, &l));
    for (int i = 0; i < 100; i++) {
        double x[2] = {ix_rng_unit(&t.r), ix_rng_unit(&t.r)};
        bool near, in = inside(&l, x, 3e-3, &near);

        assert_true(near || in == (x[1] > 1 / 3.0));
    }
    ix_lines_free(t.ctx, &l);
    ix_mv_unref(t.ctx, f);
    gt_end(&t);
}

/* Everywhere, and nowhere. */
static void all_or_nothing(void **state)
{
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 1, .length = 1},
                         {.basis = IX_BEZIER, .order = 1, .length = 1}};
    gt t = gt_begin(3);

    (void)state;
    for (int k = 0; k < 2; k++) {
        const double p[1] = {k ? 1 : -1};
        ix_lines l;
        ix_mv *f;

        ASSERT_OK(t.ctx, ix_mv_new(t.ctx, 2, d, 1, false, p, &f));
        ASSERT_OK(t.ctx, ix_positive_region(t.ctx, f, 1e-3, &l));
        assert_int_equal(l.n, k);
        assert_true(!k || l.count[0] == 5);
        ix_lines_free(t.ctx, &l);
        ix_mv_unref(t.ctx, f);
    }
    gt_end(&t);
}

/* Law: the isocline's field is positive where the normal's line is within theta
 * of the direction. */
static void isocline_fields(void **state)
{
    gt t = gt_begin(4);
    int all = 0;

    (void)state;
    for (int k = 0; k < 30; k++) {
        ix_mv *s = gt_random(&t, 2, 3, k % 3 ? -1 : 1, IX_RAND_BEZIER, 3), *f;
        double view[3], theta = ix_rng_range(&t.r, 0.2, 1.4);

        for (int c = 0; c < 3; c++)
            view[c] = ix_rng_range(&t.r, -1, 1);
        ASSERT_OK(t.ctx, ix_isocline_field(t.ctx, s, view, theta, &f));
        for (int i = 0; i < 20; i++) {
            double x[2] = {ix_rng_unit(&t.r), ix_rng_unit(&t.r)}, n[3], v[2];
            double dot = 0, len = 0;

            ASSERT_OK(t.ctx, ix_srf_normal(t.ctx, s, x[0], x[1], n));
            for (int c = 0; c < 3; c++) {
                dot += n[c] * view[c];
                len += view[c] * view[c];
            }
            dot = fabs(dot) / sqrt(len) - cos(theta);
            ASSERT_OK(t.ctx, ix_mv_eval(t.ctx, f, x, v));
            if (fabs(dot) < 1e-6)
                continue;
            assert_true((v[ix_mv_rational(f)] > 0) == (dot > 0));
            all++;
        }
        ix_mv_unref(t.ctx, s);
        ix_mv_unref(t.ctx, f);
    }
    assert_true(all > 500);
    gt_end(&t);
}

static void errors(void **state)
{
    const double zero[3] = {0, 0, 0};
    gt t = gt_begin(5);
    ix_mv *s = gt_random(&t, 2, 3, -1, IX_RAND_BEZIER, 3), *f;
    ix_lines l;

    (void)state;
    assert_int_equal(ix_positive_region(t.ctx, s, 1e-3, &l), IX_EARG);
    assert_int_equal(ix_isocline_field(t.ctx, s, zero, 1, &f), IX_EARG);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double p[6] = {1, -1, 1, 1, -2, 2};
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 3, .length = 3},
                         {.basis = IX_BEZIER, .order = 2, .length = 2}};

    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 1, false, p, &f->in[0]));
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    ix_lines l;

    IX_TRY(ix_positive_region(ctx, f->in[0], 1e-2, &l));
    ix_lines_free(ctx, &l);
    *out = ix_mv_ref(f->in[0]);
    return IX_OK;
}

static void memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parity_is_the_sign),
        cmocka_unit_test(a_node),
        cmocka_unit_test(an_even_line),
        cmocka_unit_test(all_or_nothing),
        cmocka_unit_test(isocline_fields),
        cmocka_unit_test(errors),
        cmocka_unit_test(memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
