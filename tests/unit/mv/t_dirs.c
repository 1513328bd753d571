/* Directions added, fixed, exchanged, reversed, stacked; Bezier pieces. */
#include <stdlib.h>
#include <string.h>

#include "harness/fault.h"
#include "harness/randmv.h"

/* One or two convex combinations of order up to 6. */
#define TOL 2e-14

IX_TEST_FIXTURE(23)

static void assert_value(const ix_mv *m, const double *t, const ix_mv *n,
                         const double *s, double tol)
{
    double v[19], w[19];

    ASSERT_OK(ctx, ix_mv_eval(ctx, m, t, v));
    ASSERT_OK(ctx, ix_mv_eval(ctx, n, s, w));
    assert_int_equal(ix_mv_naxes(m), ix_mv_naxes(n));
    for (int a = 0; a < ix_mv_naxes(m); a++)
        ASSERT_CLOSE(v[a], w[a], tol);
}

/* All directions have the same kind of basis, as files need it. */
static void assert_one_basis(const ix_mv *m)
{
    for (int d = 1; d < ix_mv_ndirs(m); d++)
        assert_int_equal(ix_mv_dir(m, d).basis, ix_mv_dir(m, 0).basis);
}

/* Law: the new directions do not matter, the old ones keep their place. */
static void promoted(void **state)
{
    (void)state;
    for (int k = 0; k < 60; k++) {
        ix_rand_opts o = {.kinds = k % 2 ? IX_RAND_BSPLINES : IX_RAND_BEZIER};
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *p, *q;
        int nd = ix_mv_ndirs(m), more = ix_rng_int(&rng, 1, 3);
        int start = ix_rng_int(&rng, 0, more), at = ix_rng_int(&rng, 0, nd);
        double t[8], s[16];

        ix_mv_randparam(&rng, m, t);
        ASSERT_OK(ctx, ix_mv_promote(ctx, m, nd + more, start, &p));
        assert_one_basis(p);
        for (int d = 0; d < nd + more; d++)
            s[d] = ix_rng_unit(&rng);
        memcpy(s + start, t, (size_t)nd * sizeof *s);
        assert_value(m, t, p, s, TOL);
        ASSERT_OK(ctx, ix_mv_insert_dir(ctx, m, at, &q));
        assert_one_basis(q);
        memcpy(s, t, (size_t)at * sizeof *s);
        s[at] = ix_rng_unit(&rng);
        memcpy(s + at + 1, t + at, (size_t)(nd - at) * sizeof *s);
        assert_value(m, t, q, s, TOL);
        ix_mv_unref(ctx, p);
        ix_mv_unref(ctx, q);
        ix_mv_unref(ctx, m);
    }
}

/* Law: fixing a parameter is evaluating with it; an end layer of an open
 * direction is the fixed end. */
static void fixed(void **state)
{
    (void)state;
    for (int k = 0; k < 80; k++) {
        ix_rand_opts o = {.ndirs = ix_rng_int(&rng, 2, 4),
                          .max_knots = 3,
                          .max_order = 4,
                          .kinds = IX_RAND_ALL};
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *f, *layer;
        int dir = ix_rng_int(&rng, 0, o.ndirs - 1);
        double t[8], s[8], dom[2];

        ix_mv_randparam(&rng, m, t);
        ASSERT_OK(ctx, ix_mv_fix(ctx, m, dir, t[dir], &f));
        memcpy(s, t, (size_t)dir * sizeof *s);
        memcpy(s + dir, t + dir + 1, (size_t)(o.ndirs - 1 - dir) * sizeof *s);
        assert_value(m, t, f, s, TOL);
        ix_mv_unref(ctx, f);
        if (ix_mv_dir(m, dir).basis == IX_BEZIER) {
            ix_mv_domain(m, dir, dom);
            ASSERT_OK(ctx, ix_mv_fix(ctx, m, dir, dom[1], &f));
            ASSERT_OK(ctx, ix_mv_layer(ctx, m, dir, ix_mv_length(m, dir) - 1,
                                       &layer));
            assert_true(ix_mv_equal(f, layer, 0));
            ix_mv_unref(ctx, f);
            ix_mv_unref(ctx, layer);
        }
        ix_mv_unref(ctx, m);
    }
}

static void swapped(void **state)
{
    (void)state;
    for (int k = 0; k < 60; k++) {
        ix_rand_opts o = {.ndirs = ix_rng_int(&rng, 1, 4),
                          .max_knots = 3,
                          .max_order = 4,
                          .kinds = IX_RAND_ALL};
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *w, *back;
        int a = ix_rng_int(&rng, 0, o.ndirs - 1);
        int b = ix_rng_int(&rng, 0, o.ndirs - 1);
        double t[8], s[8];

        ix_mv_randparam(&rng, m, t);
        memcpy(s, t, sizeof s);
        s[a] = t[b];
        s[b] = t[a];
        ASSERT_OK(ctx, ix_mv_swap_dirs(ctx, m, a, b, &w));
        assert_value(m, t, w, s, 1e-15 * 4); /* summed in another order */
        ASSERT_OK(ctx, ix_mv_swap_dirs(ctx, w, b, a, &back));
        assert_true(ix_mv_equal(m, back, 0));
        ix_mv_unref(ctx, w);
        ix_mv_unref(ctx, back);
        ix_mv_unref(ctx, m);
    }
}

/* By how much the start of a reversed periodic direction moves. */
static double periodic_shift(const ix_mv *m, int dir)
{
    ix_dir d = ix_mv_dir(m, dir);

    /* point i keeps its support: t_first of the reversal is t_n mirrored */
    return d.knots[d.order - 1] + d.knots[d.length];
}

static void reversed(void **state)
{
    (void)state;
    for (int k = 0; k < 120; k++) {
        ix_mv *m = ix_mv_randtest(ctx, &rng, NULL), *r;
        int dir = ix_rng_int(&rng, 0, ix_mv_ndirs(m) - 1), n;
        ix_dir d = ix_mv_dir(m, dir);
        double t[8], s[8], dom[2], dr[2];

        ix_mv_randparam(&rng, m, t);
        memcpy(s, t, sizeof s);
        ix_mv_domain(m, dir, dom);
        t[dir] = ix_rng_range(&rng, dom[0], dom[1]);
        n = ix_mv_nknots(m, dir);
        ASSERT_OK(ctx, ix_mv_reverse(ctx, m, dir, &r));
        ix_mv_domain(r, dir, dr);
        s[dir] = (n ? d.knots[0] + d.knots[n - 1] : 1) - t[dir];
        if (d.periodic) {
            double period = dom[1] - dom[0];

            assert_true(dr[0] == dom[0] && dr[1] == dom[1]);
            s[dir] = periodic_shift(m, dir) - t[dir];
            while (s[dir] < dom[0])
                s[dir] += period;
            while (s[dir] > dom[1])
                s[dir] -= period;
        }
        assert_value(m, t, r, s, TOL);
        ix_mv_unref(ctx, r);
        ix_mv_unref(ctx, m);
    }
}

/* Law: fixing the new direction at the end of an open vector gives the layer;
 * layer i is the i-th input made compatible. */
static void stacked(void **state)
{
    ix_rand_opts o = {.kinds = IX_RAND_BEZIER | IX_RAND_OPEN};
    const ix_dir dir = {IX_BEZIER, 3, 3, false, NULL};

    (void)state;
    for (int k = 0; k < 30; k++) {
        const ix_mv *in[3];
        ix_mv *m, *f;

        o.ndirs = ix_rng_int(&rng, 1, 2);
        o.unit = true;
        for (int i = 0; i < 3; i++)
            in[i] = ix_mv_randtest(ctx, &rng, &o);
        ASSERT_OK(ctx, ix_mv_stack(ctx, 3, in, &dir, &m));
        assert_int_equal(ix_mv_ndirs(m), o.ndirs + 1);
        assert_int_equal(ix_mv_length(m, o.ndirs), 3);
        assert_one_basis(m);
        for (int end = 0; end < 2; end++) {
            double t[8], v[19], w[19];

            ASSERT_OK(ctx, ix_mv_fix(ctx, m, o.ndirs, end, &f));
            ix_mv_randparam(&rng, f, t);
            ASSERT_OK(ctx, ix_mv_point(ctx, f, t, v));
            ASSERT_OK(ctx, ix_mv_point(ctx, in[2 * end], t, w));
            for (int c = 0; c < ix_mv_ncoords(in[2 * end]); c++)
                ASSERT_CLOSE(v[c], w[c], 1e-11);
            ix_mv_unref(ctx, f);
        }
        for (int i = 0; i < 3; i++)
            ix_mv_unref(ctx, in[i]);
        ix_mv_unref(ctx, m);
    }
}

/* Law: every piece is the map over its interval, and the intervals fill the
 * domain, direction 0 fastest. */
static void pieces(void **state)
{
    (void)state;
    for (int k = 0; k < 60; k++) {
        ix_rand_opts o = {.kinds = IX_RAND_ALL, .max_knots = 3, .max_order = 4};
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o);
        size_t nd = (size_t)ix_mv_ndirs(m);
        ix_mv_pieces p;
        double volume = 0, whole = 1;

        ASSERT_OK(ctx, ix_mv_to_bezier(ctx, m, &p));
        for (size_t i = 0; i < p.count; i++) {
            const double *lo = p.lo + i * nd, *hi = p.hi + i * nd;
            double t[8], s[8], v = 1;

            for (size_t d = 0; d < nd; d++) {
                s[d] = ix_rng_unit(&rng);
                t[d] = lo[d] + s[d] * (hi[d] - lo[d]);
                v *= hi[d] - lo[d];
            }
            assert_value(p.piece[i], s, m, t, 1e-11); /* power: see power */
            volume += v;
            if (i + 1 < p.count)
                assert_true(lo[nd] == hi[0] || lo[nd] == p.lo[0]);
        }
        for (size_t d = 0; d < nd; d++) {
            double dom[2];

            ix_mv_domain(m, (int)d, dom);
            whole *= dom[1] - dom[0];
        }
        ASSERT_CLOSE(volume, whole, 1e-12);
        ix_mv_pieces_free(ctx, &p);
        assert_int_equal(p.count, 0);
        ix_mv_unref(ctx, m);
    }
}

static void errors(void **state)
{
    ix_rand_opts o = {.ndirs = 1, .kinds = IX_RAND_OPEN};
    ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *r, *full;
    const ix_mv *in[] = {m, m};
    const ix_dir dir = {IX_BEZIER, 3, 3, false, NULL};

    (void)state;
    assert_int_equal(ix_mv_promote(ctx, m, 1, 0, &r), IX_EARG);
    assert_int_equal(ix_mv_promote(ctx, m, 17, 0, &r), IX_EARG);
    assert_int_equal(ix_mv_promote(ctx, m, 3, 3, &r), IX_EARG);
    assert_int_equal(ix_mv_promote(ctx, m, 3, -1, &r), IX_EARG);
    assert_int_equal(ix_mv_insert_dir(ctx, m, 2, &r), IX_EARG);
    ASSERT_OK(ctx, ix_mv_promote(ctx, m, 16, 4, &full));
    assert_int_equal(ix_mv_insert_dir(ctx, full, 0, &r), IX_EARG);
    ix_mv_unref(ctx, full);
    assert_int_equal(ix_mv_fix(ctx, m, 0, 0, &r), IX_EARG);
    assert_int_equal(ix_mv_fix(ctx, m, 1, 0, &r), IX_EARG);
    assert_int_equal(ix_mv_layer(ctx, m, 0, 0, &r), IX_EARG);
    assert_int_equal(ix_mv_layer(ctx, m, 0, 999, &r), IX_EARG);
    assert_int_equal(ix_mv_swap_dirs(ctx, m, 0, 1, &r), IX_EARG);
    assert_int_equal(ix_mv_reverse(ctx, m, -1, &r), IX_EARG);
    assert_int_equal(ix_mv_stack(ctx, 2, in, &dir, &r), IX_EARG);
    assert_null(r);
    ix_mv_unref(ctx, m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(promoted), cmocka_unit_test(fixed),
        cmocka_unit_test(swapped),  cmocka_unit_test(reversed),
        cmocka_unit_test(stacked),  cmocka_unit_test(pieces),
        cmocka_unit_test(errors),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
