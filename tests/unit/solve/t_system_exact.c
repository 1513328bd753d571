/* Systems against exact rational arithmetic: nearly tangent pairs whose number
 * of solutions integers decide, mixed so that their coefficients cancel, and
 * certified boxes proven once more without any rounding. */
#include "harness/randmv.h"
#include "iritx/solve.h"
#include "mv/mv.h"

IX_TEST_FIXTURE(20261124)

#ifdef IX_HAVE_FLINT
#include <flint/fmpq.h>
#include <flint/fmpz.h>

/* --- a parabola and a line, nearly tangent ---------------------------------
 * y = q(x) and y = l(x) with Bernstein coefficients k / 2^GRID: all of the
 * numbers below are exact in double. */

#define GRID 40

typedef struct {
    long q[3], l[2]; /* of 2^GRID */
} pair;

/* Roots of 2 (q - l) in [0, 1], coefficients c: the discriminant decides. */
static int exact_count(const pair *p)
{
    const long c[3] = {2 * (p->q[0] - p->l[0]), 2 * p->q[1] - p->l[0] - p->l[1],
                       2 * (p->q[2] - p->l[1])};
    fmpz_t disc, ac;
    int sign;

    if (c[0] <= 0 || c[2] <= 0) /* one root, or at the ends: not wanted */
        return -1;
    fmpz_init(disc);
    fmpz_set_si(disc, c[1]);
    fmpz_mul_si(disc, disc, c[1]);
    fmpz_init_set_si(ac, c[0]);
    fmpz_mul_si(ac, ac, c[2]);
    sign = fmpz_cmp(disc, ac);
    fmpz_clear(disc);
    fmpz_clear(ac);
    if (c[1] >= 0 || sign < 0)
        return 0;
    return sign == 0 ? 1 : 2;
}

/* A line through the point at t with the parabola's slope there, moved and
 * turned by some units. */
static void draw(pair *p, int spread)
{
    double t = ix_rng_range(&rng, 0.1, 0.9), at, slope;
    int span = 1 << spread;

    for (int i = 0; i < 3; i++)
        p->q[i] = (long)(ldexp(1, GRID) * ix_rng_range(&rng, 0.3, 0.7));
    at = (1 - t) * (1 - t) * (double)p->q[0] +
         2 * t * (1 - t) * (double)p->q[1] + t * t * (double)p->q[2];
    slope = 2 * ((1 - t) * (double)(p->q[1] - p->q[0]) +
                 t * (double)(p->q[2] - p->q[1]));
    p->l[0] = (long)(at - t * slope) + ix_rng_int(&rng, 0, span);
    p->l[1] = (long)(at + (1 - t) * slope) - ix_rng_int(&rng, 0, span);
}

/* a (y - q) + b (y - l) as a biquadratic-bilinear tensor, degrees 2 and 1. */
static ix_mv *mixture(const pair *p, long a, long b)
{
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 3, .length = 3},
                         {.basis = IX_BEZIER, .order = 2, .length = 2}};
    const long twice[3] = {2 * p->l[0], p->l[0] + p->l[1], 2 * p->l[1]};
    double pts[6];
    ix_mv *m;

    for (int j = 0; j < 2; j++)
        for (int i = 0; i < 3; i++) {
            long one = j ? 2L << GRID : 0;

            pts[3 * j + i] = (double)(a * (one - 2 * p->q[i]) +
                                      b * (one - twice[i]));
        }
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 1, false, pts, &m));
    return m;
}

/* Law: nothing reported means no solution; certified ones are no more than
 * there are, and all of them if no box is open. */
static void nearly_tangent(void **state)
{
    long sure = 0, open = 0, both = 0;

    (void)state;
    for (int round = 0; round < 2000; round++) {
        long k = 1L << ix_rng_int(&rng, 0, 9);
        int certified = 0, want;
        ix_equation eq[2];
        ix_solutions s;
        ix_mv *m[2];
        pair p;

        draw(&p, 1 + round % 29);
        want = exact_count(&p);
        if (want < 0)
            continue;
        m[0] = mixture(&p, k, k - 1); /* nearly parallel equations */
        m[1] = mixture(&p, k + 1, k);
        for (int i = 0; i < 2; i++)
            eq[i] = (ix_equation){m[i], 0, IX_EQUAL_ZERO};
        ASSERT_OK(ctx, ix_solve(ctx, 2, eq, NULL, &s));
        for (int i = 0; i < s.n; i++)
            certified += s.sol[i].certified;
        if (certified > want || (s.n == certified && certified < want))
            fail_msg("round %d: %d certified, %d open, exactly %d", round,
                     certified, s.n - certified, want);
        sure += s.n == certified;
        both += certified == 2;
        open += s.n > certified;
        ix_solutions_free(ctx, &s);
        ix_mv_unref(ctx, m[0]);
        ix_mv_unref(ctx, m[1]);
    }
    print_message(
        "# %ld nearly tangent pairs decided (%ld with two solutions), "
        "%ld open\n",
        sure, both, open);
    assert_true(sure > 300 && both > 50);
}

/* --- Miranda's theorem without rounding ------------------------------------
 */

#define MAX_C 25

/* The part [a, b] of direction j (0: fastest) of a tensor [n1][n0]. */
static void exact_part(const int *dims, fmpq *c, int j, const fmpq_t a,
                       const fmpq_t b)
{
    int step = j ? dims[0] : 1, m = dims[j], lines = dims[1 - j];
    fmpq_t q, r, t;

    fmpq_init(q);
    fmpq_init(r);
    fmpq_init(t);
    for (int pass = 0; pass < 2; pass++) {
        if (pass == 0)
            fmpq_set(r, b);
        else
            fmpq_div(r, a, b);
        fmpq_one(q);
        fmpq_sub(q, q, r);
        for (int l = 0; l < lines; l++) {
            fmpq *w = c + l * (j ? 1 : dims[0]);

            for (int k = 1; k < m; k++)
                for (int i = 0; i < m - k; i++) {
                    int at = pass ? i : m - 1 - i, from = at + (pass ? 1 : -1);

                    /* pass 0 makes [0, b], from the far end */
                    fmpq_mul(t, w + at * step, pass ? q : r);
                    fmpq_mul(w + at * step, w + from * step, pass ? r : q);
                    fmpq_add(w + at * step, w + at * step, t);
                }
        }
    }
    fmpq_clear(q);
    fmpq_clear(r);
    fmpq_clear(t);
}

static void set_double(fmpq_t x, double v)
{
    int e;
    double f = frexp(v, &e);

    fmpq_set_si(x, (slong)ldexp(f, 53), 1);
    if (e >= 53)
        fmpq_mul_2exp(x, x, (ulong)(e - 53));
    else
        fmpq_div_2exp(x, x, (ulong)(53 - e));
}

/* Coefficients of m on the box of the solution, exactly. */
static void on_box(const ix_mv *m, const ix_solution *s, fmpq *c)
{
    int dims[2] = {m->dirs[0].length, m->dirs[1].length};
    const double *v = ix_mv_axis(m, 0);
    fmpq_t a, b;

    fmpq_init(a);
    fmpq_init(b);
    for (int i = 0; i < dims[0] * dims[1]; i++)
        set_double(c + i, v[i]);
    for (int j = 0; j < 2; j++) {
        set_double(a, s->lo[j]);
        set_double(b, s->hi[j]);
        exact_part(dims, c, j, a, b);
    }
    fmpq_clear(a);
    fmpq_clear(b);
}

/* The sign of sum w_k c_k on the low (high) side of direction j, 0 if mixed;
 * both tensors have the same shape. */
static int side(const int *dims, fmpq *const *c, const fmpq *w, int j, int high)
{
    int sign = 2;
    fmpq_t v;

    fmpq_init(v);
    for (int i = 0; i < dims[0] * dims[1]; i++) {
        int at = j ? i / dims[0] : i % dims[0];

        if (at != (high ? dims[j] - 1 : 0))
            continue;
        fmpq_mul(v, c[0] + i, w);
        fmpq_addmul(v, c[1] + i, w + 1);
        if (sign == 2)
            sign = fmpq_sgn(v);
        else if (sign != fmpq_sgn(v))
            sign = 0;
    }
    fmpq_clear(v);
    return sign;
}

/* Miranda: some combination of the equations per direction has opposite signs
 * on the two opposite sides. The combinations are the rows of the adjugate of
 * the difference matrix of the corners. */
static bool miranda(ix_mv *const *m, const ix_solution *s)
{
    int dims[2] = {m[0]->dirs[0].length, m[0]->dirs[1].length};
    int n = dims[0] * dims[1];
    fmpq *c[2] = {_fmpq_vec_init(n), _fmpq_vec_init(n)};
    fmpq *d = _fmpq_vec_init(4), *w = _fmpq_vec_init(4);
    bool ok = true;

    for (int k = 0; k < 2; k++) {
        on_box(m[k], s, c[k]);
        fmpq_sub(d + 2 * k, c[k] + dims[0] - 1, c[k]);
        fmpq_sub(d + 2 * k + 1, c[k] + n - dims[0], c[k]);
    }
    fmpq_set(w, d + 3);
    fmpq_neg(w + 1, d + 1);
    fmpq_neg(w + 2, d + 2);
    fmpq_set(w + 3, d);
    for (int j = 0; j < 2; j++) {
        int lo = side(dims, c, w + 2 * j, j, 0);
        int hi = side(dims, c, w + 2 * j, j, 1);

        ok &= lo != 0 && hi != 0 && lo == -hi;
    }
    _fmpq_vec_clear(c[0], n);
    _fmpq_vec_clear(c[1], n);
    _fmpq_vec_clear(d, 4);
    _fmpq_vec_clear(w, 4);
    return ok;
}

/* f_1 = p + 2^e g, f_2 = p + 2^e h, e down to -40: nearly the same equation. */
static void cancelling(ix_mv **m)
{
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 4, .length = 4},
                         {.basis = IX_BEZIER, .order = 4, .length = 4}};
    double p[16], a[16], b[16], small = ldexp(1, -ix_rng_int(&rng, 0, 30));

    for (int i = 0; i < 16; i++) {
        p[i] = ix_rng_range(&rng, -1, 1);
        a[i] = p[i] + small * ix_rng_range(&rng, -1, 1);
        b[i] = p[i] + small * ix_rng_range(&rng, -1, 1);
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 1, false, a, &m[0]));
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 1, false, b, &m[1]));
}

/* Law: every certified box holds a solution of the stored equations, by
 * Miranda's theorem in rationals; roots nearer to an edge of the domain than
 * the box is wide are left out. */
static void certificates_hold(void **state)
{
    long proven = 0;

    (void)state;
    for (int round = 0; round < 150; round++) {
        ix_equation eq[2];
        ix_solutions s;
        ix_mv *m[2];

        cancelling(m);
        for (int i = 0; i < 2; i++)
            eq[i] = (ix_equation){m[i], 0, IX_EQUAL_ZERO};
        ASSERT_OK(ctx, ix_solve(ctx, 2, eq, NULL, &s));
        for (int i = 0; i < s.n; i++) {
            ix_solution *r = &s.sol[i];

            if (!r->certified)
                continue;
            for (int j = 0; j < 2; j++) /* room for Miranda's signs */
                for (int side = 0; side < 2; side++)
                    *(side ? &r->hi[j] : &r->lo[j]) += (side ? 0.5 : -0.5) *
                                                       (r->hi[j] - r->lo[j]);
            if (!(r->lo[0] > 0 && r->lo[1] > 0 && r->hi[0] < 1 && r->hi[1] < 1))
                continue;
            if (!miranda(m, r))
                fail_msg("round %d: no solution in the certified box at "
                         "(%.17g, %.17g) of %g x %g",
                         round, r->x[0], r->x[1], r->hi[0] - r->lo[0],
                         r->hi[1] - r->lo[1]);
            proven++;
        }
        ix_solutions_free(ctx, &s);
        ix_mv_unref(ctx, m[0]);
        ix_mv_unref(ctx, m[1]);
    }
    print_message("# %ld certificates proven in rationals\n", proven);
    assert_true(proven > 50);
}
#endif

int main(void)
{
#ifdef IX_HAVE_FLINT
    const struct CMUnitTest tests[] = {cmocka_unit_test(nearly_tangent),
                                       cmocka_unit_test(certificates_hold)};

    return cmocka_run_group_tests(tests, setup, teardown);
#else
    return (void)rng, (void)setup, (void)teardown, 0;
#endif
}
