/* Forms: what each operation does to values, what continuity it guarantees
 * (stored with just the knots that this asks for, the values must follow). */
#include <limits.h>

#include "bern/bern.h"
#include "sym/form.h"
#include "sym/outer.h"
#include "sym_test.h"

/* An open B-spline curve or surface with simple knots of uneven distance. */
static ix_mv *uneven(ix_ctx *ctx, ix_rng *r, int ndirs, int order, int spans,
                     int ncoords)
{
    static const double gap[] = {1, 0.1, 3, 0.5, 2, 0.25, 1};
    double kv[64], pts[4000], at = -1;
    int n = spans + order - 1;
    size_t np = (size_t)ncoords;
    ix_dir dirs[2];
    ix_mv *m;

    for (int i = 0; i < n + order; i++) {
        if (i >= order && i <= n)
            at += gap[(i - order) % 7];
        kv[i] = at;
    }
    for (int i = 0; i < ndirs; i++) {
        dirs[i] = (ix_dir){IX_BSPLINE, order, n, false, kv};
        np *= (size_t)n;
    }
    for (size_t i = 0; i < np; i++)
        pts[i] = ix_rng_range(r, -1, 1);
    ASSERT_OK(ctx, ix_mv_new(ctx, ndirs, dirs, ncoords, false, pts, &m));
    return m;
}

static void load(ix_ctx *ctx, const ix_mv *m, ix_form *f)
{
    ASSERT_OK(ctx, ix__forms_load(ctx, 1, &m, NULL, f));
}

/* Law: a form has the values of what it was loaded from, and storing it gives
 * the same points back. */
static void loading_and_storing(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(81);

    for (int round = 0; round < 30; round++) {
        ix_rand_opts s = {.kinds = IX_RAND_BEZIER | IX_RAND_OPEN};
        ix_mv *m = ix_mv_randtest(w->ctx, &r, &s), *back;
        ix_mark mk = ix__scratch_mark(w->ctx);
        double t[3], x[8], y[8];
        ix_form f;

        load(w->ctx, m, &f);
        rand_param(&r, m, t);
        ASSERT_OK(w->ctx, ix_mv_eval(w->ctx, m, t, x));
        ix__form_eval(&f, t, y);
        for (int i = 0; i < f.nrows; i++)
            ASSERT_CLOSE(x[i], y[i], 1e-13);
        ASSERT_OK(w->ctx,
                  ix__form_store(w->ctx, &f, ix_mv_rational(m), NULL, &back));
        assert_true(ix_mv_equal(m, back, 1e-12));
        ix__scratch_release(w->ctx, mk);
        ix_mv_unref(w->ctx, m);
        ix_mv_unref(w->ctx, back);
    }
}

/* Law: minors of (P_U, P_V), and of all second partials, are those of
 * (f, f') and (f, f', f'') times one constant on all spans: -d h0, and
 * -d (d-1)^2 h0^3; stored with continuity c - 1 and c - 2 they keep their
 * values. Cubic, C2; tolerance: sums of a few products. */
static void partials_are_wronskians(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(82);
    ix_mv *m = uneven(w->ctx, &r, 1, 4, 6, 3), *s;
    ix_mark mk = ix__scratch_mark(w->ctx);
    ix_form f, uv[2], all[3], d1, d2;
    const ix_form *pair[2] = {&uv[0], &uv[1]};
    const ix_form *three[3] = {&all[0], &all[1], &all[2]};
    double h0, e[9], got[3], want[3], t;

    load(w->ctx, m, &f);
    h0 = ix__spans_mean(&f.dirs[0]);
    ASSERT_OK(w->ctx, ix__form_partials(w->ctx, &f, 0, 1, uv));
    ASSERT_OK(w->ctx, ix__form_partials(w->ctx, &f, 0, 2, all));
    ASSERT_OK(w->ctx, ix__form_minors(w->ctx, 2, pair, &d1));
    ASSERT_OK(w->ctx, ix__form_det(w->ctx, 3, three, &d2));
    assert_int_equal(d1.dirs[0].degree, 4);
    assert_int_equal(d2.dirs[0].degree, 3);
    assert_true(d1.dirs[0].cont[0] == 1 && d2.dirs[0].cont[0] == 0);
    for (int k = 0; k < 2; k++) {
        ASSERT_OK(w->ctx,
                  ix__form_store(w->ctx, k ? &d2 : &d1, false, NULL, &s));
        for (int i = 0; i < 20; i++) {
            rand_param(&r, m, &t);
            ASSERT_OK(w->ctx, ix_mv_curve_derivs(w->ctx, m, t, 2, e));
            ASSERT_OK(w->ctx, ix_mv_eval(w->ctx, s, &t, got));
            for (int a = 0; a < 3; a++) /* f x f' */
                want[a] = e[(a + 1) % 3] * e[3 + (a + 2) % 3] -
                          e[(a + 2) % 3] * e[3 + (a + 1) % 3];
            if (k == 0) {
                for (int a = 0; a < 3; a++)
                    ASSERT_CLOSE(got[a], -3 * h0 * want[a], 1e-11);
                continue;
            }
            want[0] = want[0] * e[6] + want[1] * e[7] + want[2] * e[8];
            ASSERT_CLOSE(got[0], -12 * pow(h0, 3) * want[0], 1e-10);
        }
        ix_mv_unref(w->ctx, s);
    }
    ix__scratch_release(w->ctx, mk);
    ix_mv_unref(w->ctx, m);
}

/* Law: derivative and integral of forms are inverse; J(A, b) = h0 (q A' b - p
 * A b') for degrees p and q; stored results keep their values. */
static void calculus(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(83);
    ix_mv *m = uneven(w->ctx, &r, 2, 4, 3, 2), *s;
    ix_mark mk = ix__scratch_mark(w->ctx);
    ix_form f, a, b, d, q, sq, j;
    double h0;

    load(w->ctx, m, &f);
    for (int dir = 0; dir < 2; dir++) {
        double t[2], x[2], y[2], da, db, v[2];

        ASSERT_OK(w->ctx, ix__form_derive(w->ctx, &f, dir, &d));
        q = d; /* the result may be its own operand */
        ASSERT_OK(w->ctx, ix__form_integrate(w->ctx, &q, dir, &q));
        assert_int_equal(q.dirs[dir].cont[0], 2);
        ASSERT_OK(w->ctx, ix__form_derive(w->ctx, &q, dir, &q));
        ASSERT_OK(w->ctx, ix__form_store(w->ctx, &q, false, NULL, &s));
        rand_param(&r, m, t);
        ix__form_eval(&d, t, x);
        ASSERT_OK(w->ctx, ix_mv_eval(w->ctx, s, t, y));
        ASSERT_CLOSE(x[0], y[0], 1e-12);
        ASSERT_CLOSE(x[1], y[1], 1e-12);
        ix_mv_unref(w->ctx, s);

        a = ix__form_rows(&f, 0, 1);
        b = ix__form_rows(&f, 1, 1);
        h0 = ix__spans_mean(&f.dirs[dir]);
        ASSERT_OK(w->ctx, ix__form_mul(w->ctx, &b, &b, &sq));
        ASSERT_OK(w->ctx, ix__form_jacobian(w->ctx, &a, &sq, dir, &j));
        ASSERT_OK(w->ctx, ix__form_store(w->ctx, &j, false, NULL, &s));
        ASSERT_OK(w->ctx, ix_mv_eval(w->ctx, s, t, y));
        ix__form_eval(&f, t, v);
        da = x[0];
        db = 2 * v[1] * x[1];
        ASSERT_CLOSE(y[0], h0 * (6 * da * v[1] * v[1] - 3 * v[0] * db), 1e-11);
        ix_mv_unref(w->ctx, s);
    }
    ix__scratch_release(w->ctx, mk);
    ix_mv_unref(w->ctx, m);
}

/* Law: elevation, refinement, powers and joined rows keep values. */
static void other_representations(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(84);
    ix_mv *m = uneven(w->ctx, &r, 2, 3, 3, 1);
    ix_mark mk = ix__scratch_mark(w->ctx);
    double br[] = {-1, -0.5, 0, 0.05, 0.1, 2, 3.1}, t[2], x, y[3];
    ix_spans fine = {0, 6, br, NULL};
    ix_form f, up, cut, p0, p5, j;
    const ix_form *parts[3] = {&up, &p5, &p0};
    int degrees[2] = {4, 2};

    load(w->ctx, m, &f);
    ASSERT_OK(w->ctx, ix__form_elevate(w->ctx, &f, degrees, &up));
    assert_int_equal(up.dirs[0].degree, 4);
    ASSERT_OK(w->ctx, ix__form_power(w->ctx, &f, 5, &p5));
    ASSERT_OK(w->ctx, ix__form_power(w->ctx, &f, 0, &p0));
    ASSERT_OK(w->ctx, ix__form_join(w->ctx, 3, parts, &j));
    br[2] = f.dirs[0].breaks[1];
    br[4] = f.dirs[0].breaks[2];
    br[6] = f.dirs[0].breaks[3];
    ASSERT_OK(w->ctx, ix__form_refine(w->ctx, &j, 0, &fine, &cut));
    assert_int_equal(cut.dirs[0].nspans, 6);
    assert_int_equal(cut.dirs[0].cont[0], INT_MAX);
    assert_int_equal(cut.dirs[0].cont[1], 1);
    for (int i = 0; i < 10; i++) {
        rand_param(&r, m, t);
        ix__form_eval(&f, t, &x);
        ix__form_eval(&cut, t, y);
        ASSERT_CLOSE(y[0], x, 1e-13);
        ASSERT_CLOSE(y[1], pow(x, 5), 1e-12);
        ASSERT_CLOSE(y[2], 1, 1e-13);
    }
    ix__scratch_release(w->ctx, mk);
    ix_mv_unref(w->ctx, m);
}

/* Law: a sum of products of functions of s and of t, written as a grid, has
 * the values of the sum; more terms than are combined at a time. */
static void outer_products(void **state)
{
    sym_world *w = *state;
    ix_rng r = ix_rng_new(85);
    ix_mv *a = uneven(w->ctx, &r, 1, 4, 3, 2),
          *b = uneven(w->ctx, &r, 1, 3, 4, 3);
    ix_mark mk = ix__scratch_mark(w->ctx);
    ix_outer_term terms[102];
    ix_outer o = {.nrows = 3, .nterms = 102, .terms = terms};
    double *pts, s, t, got[3], want[3], size[3];
    ix_form f, g;
    ix_dir dirs[2];
    ix_mv *m;

    for (int i = 0; i < 102; i++)
        terms[i] = (ix_outer_term){i < 100 ? 0 : 2, i % 2, i % 3,
                                   ix_rng_range(&r, -1, 1)};
    load(w->ctx, a, &f);
    load(w->ctx, b, &g);
    o.u = &f;
    o.v = &g;
    ASSERT_OK(w->ctx, ix__outer_dirs(w->ctx, &o, NULL, dirs));
    pts = ix__scratch(w->ctx,
                      3 * (size_t)dirs[0].length * (size_t)dirs[1].length,
                      sizeof *pts);
    assert_non_null(pts);
    ASSERT_OK(w->ctx, ix__outer_points(w->ctx, &o, dirs, pts, size));
    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 2, dirs, 3, false, pts, &m));
    for (int i = 0; i < 10; i++) {
        double st[2];

        rand_param(&r, m, st);
        s = st[0];
        t = st[1];
        ASSERT_OK(w->ctx, ix_mv_eval(w->ctx, m, st, got));
        ASSERT_OK(w->ctx, ix__outer_eval(w->ctx, &o, &s, &t, want));
        for (int k = 0; k < 3; k++) {
            ASSERT_CLOSE(got[k], want[k], 1e-12);
            assert_true(fabs(got[k]) <= size[k]);
        }
        assert_true(got[1] == 0);
    }
    ix__scratch_release(w->ctx, mk);
    ix_mv_unref(w->ctx, a);
    ix_mv_unref(w->ctx, b);
    ix_mv_unref(w->ctx, m);
}

/* Law: inputs of size 1 at distance 1e6 land in the unit box, and the way
 * there and back gives every point back to the last place but two. */
static void frames(void **state)
{
    sym_world *w = *state;
    double p[] = {1, 0.5, 2, 1e6, 5e5 + 0.5, 2e6 + 1, -3, -2, -7, 0, 0, 0};
    ix_dir d = {IX_BEZIER, 3, 3, false, NULL};
    ix_mark mk = ix__scratch_mark(w->ctx);
    const double *x;
    double back[12];
    ix_frame fr;
    ix_form f;
    ix_mv *m;

    ASSERT_OK(w->ctx, ix_mv_new(w->ctx, 1, &d, 3, true, p, &m));
    ASSERT_OK(w->ctx, ix__frame_of(w->ctx, 1, (const ix_mv *const *)&m, &fr));
    ASSERT_OK(w->ctx,
              ix__forms_load(w->ctx, 1, (const ix_mv *const *)&m, &fr, &f));
    ASSERT_OK(w->ctx, ix__form_bernstein(w->ctx, &f, &x));
    assert_true(ix__bern_largest(12, x) <= 1);
    memcpy(back, x, sizeof back);
    ix__frame_back(&fr, 1, 3, back, back + 3);
    for (int i = 3; i < 12; i++)
        ASSERT_CLOSE(back[i] / back[i % 3], p[i] / p[i % 3], 4e-16);
    assert_true(fr.noise > 1e-11 && fr.noise < 1e-9);
    ix__scratch_release(w->ctx, mk);
    ix_mv_unref(w->ctx, m);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, world_open, world_close)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(loading_and_storing),
        TEST(partials_are_wronskians),
        TEST(calculus),
        TEST(other_representations),
        TEST(outer_products),
        TEST(frames),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
