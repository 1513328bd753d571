/* Curve operators in exact rational arithmetic (FLINT): values of all minimal
 * forms, degrees of the fields, and that the focal curve is rational. */
#include <limits.h>
#include <string.h>

#include "crv_test.h"
#include "ops/table.h"

#ifdef IX_HAVE_FLINT
#include <flint/fmpq_poly.h>

enum { MAX_D = 4 };

/* The curve (p, w) in the power basis, and what is derived from it. */
typedef struct {
    int d;
    fmpq_poly_t p[3], w, dp[3], dw, tan[3], v[3], q, t, slope[3];
} exact;

static void poly_all(exact *e, void (*f)(fmpq_poly_t))
{
    fmpq_poly_struct *all[] = {e->w, e->dw, e->q, e->t};

    for (int i = 0; i < 4; i++)
        f(all[i]);
    for (int k = 0; k < 3; k++) {
        fmpq_poly_struct *rows[] = {e->p[k], e->dp[k], e->tan[k], e->v[k],
                                    e->slope[k]};

        for (int i = 0; i < 5; i++)
            f(rows[i]);
    }
}

/* sum b_i C(d,i) t^i (1-t)^(d-i) of integers. */
static void from_bernstein(fmpq_poly_t out, int d, const double *b)
{
    static const int binom[MAX_D + 1][MAX_D + 1] = {
        {1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}};
    fmpq_poly_t u, v, s;

    fmpq_poly_init(u);
    fmpq_poly_init(v);
    fmpq_poly_init(s);
    fmpq_poly_zero(out);
    for (int i = 0; i <= d; i++) {
        fmpq_poly_set_coeff_si(u, 1, 1);
        fmpq_poly_pow(s, u, (ulong)i);
        fmpq_poly_set_si(v, 1);
        fmpq_poly_set_coeff_si(v, 1, -1);
        fmpq_poly_pow(v, v, (ulong)(d - i));
        fmpq_poly_mul(s, s, v);
        fmpq_poly_scalar_mul_si(s, s, (slong)b[i] * binom[d][i]);
        fmpq_poly_add(out, out, s);
    }
    fmpq_poly_clear(u);
    fmpq_poly_clear(v);
    fmpq_poly_clear(s);
}

/* out += sign a b. */
static void add_mul(fmpq_poly_t out, int sign, const fmpq_poly_t a,
                    const fmpq_poly_t b)
{
    fmpq_poly_t t;

    fmpq_poly_init(t);
    fmpq_poly_mul(t, a, b);
    if (sign > 0)
        fmpq_poly_add(out, out, t);
    else
        fmpq_poly_sub(out, out, t);
    fmpq_poly_clear(t);
}

static void dot(fmpq_poly_t out, fmpq_poly_t *a, fmpq_poly_t *b)
{
    fmpq_poly_zero(out);
    for (int k = 0; k < 3; k++)
        add_mul(out, 1, a[k], b[k]);
}

/* The three functions' derivatives: out = a'. */
static void derive3(fmpq_poly_t *out, fmpq_poly_t *a)
{
    for (int k = 0; k < 3; k++)
        fmpq_poly_derivative(out[k], a[k]);
}

/* D = p'w - p w', V = D x D' / w (exactly divisible), Q = D.D,
 * T = V.D'' / w, as det(D, D', D'') = w^2 T. */
static void fill(exact *e)
{
    fmpq_poly_t d1[3], d2[3], a;

    fmpq_poly_init(a);
    fmpq_poly_derivative(e->dw, e->w);
    derive3(e->dp, e->p);
    for (int k = 0; k < 3; k++) {
        fmpq_poly_init(d1[k]);
        fmpq_poly_init(d2[k]);
        fmpq_poly_mul(e->tan[k], e->dp[k], e->w);
        add_mul(e->tan[k], -1, e->p[k], e->dw);
    }
    derive3(d1, e->tan);
    derive3(d2, d1);
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;

        fmpq_poly_mul(a, e->tan[i], d1[j]);
        add_mul(a, -1, e->tan[j], d1[i]);
        fmpq_poly_divrem(e->v[k], a, a, e->w);
        assert_true(fmpq_poly_is_zero(a));
    }
    dot(e->q, e->tan, e->tan);
    dot(a, e->v, d2);
    fmpq_poly_divrem(e->t, a, a, e->w);
    assert_true(fmpq_poly_is_zero(a));
    for (int k = 0; k < 3; k++) {
        fmpq_poly_clear(d1[k]);
        fmpq_poly_clear(d2[k]);
    }
    fmpq_poly_clear(a);
}

/* w (V'Q - 3/2 V Q') + 3 w'Q V. */
static void fill_slope(exact *e)
{
    fmpq_poly_t a, b, dq;

    fmpq_poly_init(a);
    fmpq_poly_init(b);
    fmpq_poly_init(dq);
    fmpq_poly_derivative(dq, e->q);
    for (int k = 0; k < 3; k++) {
        fmpq_poly_derivative(b, e->v[k]);
        fmpq_poly_mul(a, b, e->q);
        fmpq_poly_mul(b, e->v[k], dq);
        fmpq_poly_scalar_mul_si(b, b, 3);
        fmpq_poly_scalar_div_si(b, b, 2);
        fmpq_poly_sub(a, a, b);
        fmpq_poly_mul(e->slope[k], a, e->w);
        fmpq_poly_mul(b, e->q, e->v[k]);
        fmpq_poly_scalar_mul_si(b, b, 3);
        add_mul(e->slope[k], 1, b, e->dw);
    }
    fmpq_poly_clear(a);
    fmpq_poly_clear(b);
    fmpq_poly_clear(dq);
}

/* The curve with these integer control points, homogeneous. */
static void random_exact(ix_rng *r, exact *e, int d, double *pts)
{
    e->d = d;
    for (int i = 0; i < 4 * (d + 1); i++)
        pts[i] = i <= d ? ix_rng_int(r, 1, 3) : ix_rng_int(r, -4, 4);
    pts[0] = 1;
    pts[1] = 2; /* equal weights would be divided out */
    from_bernstein(e->w, d, pts);
    for (int k = 0; k < 3; k++)
        from_bernstein(e->p[k], d, pts + (k + 1) * (d + 1));
    fill(e);
    fill_slope(e);
}

/* Law: with y = -slope / (w^4 T), exactly
 *   y.x' = 0, y.x'' = |x'|^2, y.x''' = 3 x'.x'':
 * x + y, which is rational, is the centre of the osculating sphere. */
static void focal_curve_is_rational(void **state)
{
    ix_rng r = ix_rng_new(81);
    double pts[4 * (MAX_D + 1)];
    fmpq_poly_t d1[3], d2[3], a, b, w2, s1, s2;
    exact e;

    (void)state;
    poly_all(&e, fmpq_poly_init);
    for (int k = 0; k < 3; k++) {
        fmpq_poly_init(d1[k]);
        fmpq_poly_init(d2[k]);
    }
    fmpq_poly_init(a);
    fmpq_poly_init(b);
    fmpq_poly_init(w2);
    fmpq_poly_init(s1);
    fmpq_poly_init(s2);
    for (int round = 0; round < 4; round++) {
        random_exact(&r, &e, 3 + round % 2, pts);
        derive3(d1, e.tan);
        derive3(d2, d1);
        fmpq_poly_mul(w2, e.w, e.w);
        dot(a, e.slope, e.tan);
        assert_true(fmpq_poly_is_zero(a));
        dot(s1, e.slope, d1); /* slope.D' = -T Q w^2 */
        fmpq_poly_mul(a, e.t, e.q);
        fmpq_poly_set(b, s1);
        add_mul(b, 1, a, w2);
        assert_true(fmpq_poly_is_zero(b));
        /* w slope.D'' - 4 w' slope.D' + 3/2 T w^2 (Q'w - 4 Q w') = 0 */
        dot(s2, e.slope, d2);
        fmpq_poly_derivative(a, e.q);
        fmpq_poly_mul(a, a, e.w);
        fmpq_poly_mul(b, e.q, e.dw);
        fmpq_poly_scalar_mul_si(b, b, 4);
        fmpq_poly_sub(a, a, b);
        fmpq_poly_mul(a, a, e.t);
        fmpq_poly_mul(a, a, w2);
        fmpq_poly_scalar_mul_si(a, a, 3);
        fmpq_poly_scalar_div_si(a, a, 2);
        add_mul(a, 1, e.w, s2);
        fmpq_poly_scalar_mul_si(s1, s1, 4);
        add_mul(a, -1, e.dw, s1);
        assert_true(fmpq_poly_is_zero(a));
    }
    for (int k = 0; k < 3; k++) {
        fmpq_poly_clear(d1[k]);
        fmpq_poly_clear(d2[k]);
    }
    fmpq_poly_clear(a);
    fmpq_poly_clear(b);
    fmpq_poly_clear(w2);
    fmpq_poly_clear(s1);
    fmpq_poly_clear(s2);
    poly_all(&e, fmpq_poly_clear);
}

/* The value of a polynomial at num/8. */
static double value(const fmpq_poly_t f, int num)
{
    fmpq_t x, y;
    double v;

    fmpq_init(x);
    fmpq_init(y);
    fmpq_set_si(x, num, 8);
    fmpq_poly_evaluate_fmpq(y, f, x);
    v = fmpq_get_d(y);
    fmpq_clear(x);
    fmpq_clear(y);
    return v;
}

/* Law: the torsion field of integer control points is T in 4d - 12, to
 * rounding: 1e-12 of its largest value at nine parameters. */
static void torsion_is_exact(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(82);
    double pts[4 * (MAX_D + 1)];
    exact e;

    (void)state;
    poly_all(&e, fmpq_poly_init);
    for (int round = 0; round < 6; round++) {
        int d = 3 + round % 2;
        double worst = 0, big = 0;
        ix_mv *c, *f;

        random_exact(&r, &e, d, pts);
        assert_true(fmpq_poly_degree(e.t) <= 4 * d - 12);
        assert_true(fmpq_poly_degree(e.v[0]) <= 3 * d - 6);
        assert_true(fmpq_poly_degree(e.slope[1]) <= 8 * d - 12);
        c = make_crv(ctx, d + 1, d + 1, NULL, true, 3, pts);
        ASSERT_OK(ctx,
                  ix_crv_field(ctx, c, IX_CRV_TORSION_ZERO, NULL, NULL, &f));
        for (int i = 0; i <= 8; i++) {
            double t = i / 8.0, got;

            ASSERT_OK(ctx, ix_mv_eval(ctx, f, &t, &got));
            big = fmax(big, fabs(value(e.t, i)));
            worst = fmax(worst, fabs(got - value(e.t, i)));
        }
        if (!(worst <= 1e-12 * big))
            fail_msg("degree %d: off by %g of %g", d, worst, big);
        ix_mv_unref(ctx, c);
        ix_mv_unref(ctx, f);
    }
    poly_all(&e, fmpq_poly_clear);
    ix_ctx_free(ctx);
}

/* --- definitions in rational numbers -----------------------------------------
 */

/* Expressions over a pool of rationals, emptied after each parameter. */
enum { POOL = 4000 };
static fmpq pool[POOL];
static int used;
typedef fmpq *num;
typedef struct {
    num c[3];
} vec;

static num fresh(void)
{
    assert_true(used < POOL);
    return &pool[used++];
}

typedef void (*operation)(fmpq_t, const fmpq_t, const fmpq_t);

static num apply(operation op, num a, num b)
{
    num r = fresh();

    op(r, a, b);
    return r;
}

static num add(num a, num b)
{
    return apply(fmpq_add, a, b);
}

static num sub(num a, num b)
{
    return apply(fmpq_sub, a, b);
}

static num mul(num a, num b)
{
    return apply(fmpq_mul, a, b);
}

static num over(num a, num b)
{
    return apply(fmpq_div, a, b);
}

static num integer(int k)
{
    num r = fresh();

    fmpq_set_si(r, k, 1);
    return r;
}

static num power(num a, int k)
{
    num r = fresh();

    fmpq_pow_si(r, a, k);
    return r;
}

static vec scaled(num f, vec a)
{
    return (vec){{mul(f, a.c[0]), mul(f, a.c[1]), mul(f, a.c[2])}};
}

static vec sum(vec a, vec b)
{
    return (vec){
        {add(a.c[0], b.c[0]), add(a.c[1], b.c[1]), add(a.c[2], b.c[2])}};
}

static num inner(vec a, vec b)
{
    return add(add(mul(a.c[0], b.c[0]), mul(a.c[1], b.c[1])),
               mul(a.c[2], b.c[2]));
}

static vec outer(vec a, vec b)
{
    vec r;

    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;

        r.c[k] = sub(mul(a.c[i], b.c[j]), mul(a.c[j], b.c[i]));
    }
    return r;
}

/* x, x', x'', x''' and w at t by the quotient rule. */
typedef struct {
    vec x[4];
    num w;
} jet;

static num at(const fmpq_poly_t f, int derivative, num t)
{
    fmpq_poly_t d;
    num r = fresh();

    fmpq_poly_init(d);
    fmpq_poly_set(d, f);
    for (int i = 0; i < derivative; i++)
        fmpq_poly_derivative(d, d);
    fmpq_poly_evaluate_fmpq(r, d, t);
    fmpq_poly_clear(d);
    return r;
}

static jet jet_at(const exact *e, int dim, num t)
{
    static const int binom[4][4] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
    jet j;

    j.w = at(e->w, 0, t);
    for (int n = 0; n < 4; n++)
        for (int k = 0; k < 3; k++) {
            num s = k < dim ? at(e->p[k], n, t) : integer(0);

            for (int i = 1; i <= n; i++)
                s = sub(s, mul(mul(integer(binom[n][i]), at(e->w, i, t)),
                               j.x[n - i].c[k]));
            j.x[n].c[k] = over(s, j.w);
        }
    return j;
}

/* What the minimal form of an operator is at t: up to three values; of ruled
 * surfaces the end of the ruling for r = 1. */
static int definition(const char *op, int dim, const jet *j, num out[3])
{
    vec b = outer(j->x[1], j->x[2]), c = outer(j->x[1], j->x[3]), v;
    num q = inner(j->x[1], j->x[1]), d = inner(j->x[1], j->x[2]);
    num bb = inner(b, b), det = inner(b, j->x[3]);
    vec n = outer(b, j->x[1]);

    out[0] = NULL;
    if (strcmp(op, "CINFLECT") == 0)
        out[0] = mul(b.c[2], power(j->w, 3));
    if (strcmp(op, "CCRVTRSQR") == 0)
        out[0] = over(bb, power(q, 3));
    if (strcmp(op, "CTORSIONZERO") == 0)
        out[0] = mul(det, power(j->w, 4));
    if (strcmp(op, "CTORSION") == 0)
        out[0] = over(det, bb);
    if (strcmp(op, "CCRVTR") == 0 && dim == 2)
        out[0] = mul(sub(mul(c.c[2], q), mul(mul(integer(3), d), b.c[2])),
                     power(j->w, 8));
    if (strcmp(op, "CCRVTR") == 0 && dim == 3)
        out[0] = mul(sub(mul(mul(integer(2), inner(b, c)), q),
                         mul(mul(integer(6), bb), d)),
                     power(j->w, 11));
    if (out[0])
        return 1;
    v = j->x[0];
    if (strcmp(op, "CNRMLCRV") == 0)
        v = scaled(over(integer(1), mul(q, q)), n);
    if (strcmp(op, "EVOLUTE") == 0)
        v = sum(v, scaled(over(q, bb), n));
    if (strcmp(op, "FOCALCRV") == 0)
        v = sum(v, sum(scaled(over(mul(integer(3), d), det), b),
                       scaled(over(sub(integer(0), q), det), c)));
    if (strcmp(op, "TANDEVSRF") == 0)
        v = sum(v, scaled(j->w, j->x[1]));
    if (strcmp(op, "NRMLSCROLL") == 0)
        v = sum(v, scaled(power(j->w, 4), n));
    if (strcmp(op, "BINRMLSCROLL") == 0)
        v = sum(v, scaled(power(j->w, 2), b));
    if (strcmp(op, "RECTDEVSRF") == 0)
        v = sum(v, scaled(power(j->w, 9),
                          sum(scaled(mul(det, q), j->x[1]), scaled(bb, b))));
    memcpy(out, v.c, sizeof v.c);
    return 3;
}

/* Integers near an arc of a helix, on which all is well conditioned. */
static void helix_points(ix_rng *r, exact *e, int d, int dim, bool rational,
                         double *pts)
{
    for (int i = 0; i <= d; i++) {
        double angle = 2.4 * i / d, w = rational ? ix_rng_int(r, 4, 5) : 1;
        const double x[3] = {8 * cos(angle), 8 * sin(angle), 4 * angle};

        pts[i] = w;
        for (int k = 0; k < 3; k++)
            pts[(k + 1) * (d + 1) + i] = k < dim ? rint(w * x[k]) +
                                                       ix_rng_int(r, 0, 1)
                                                 : 0;
    }
    pts[0] = rational ? 4 : 1; /* equal weights would be divided out */
    pts[d] = rational ? 5 : 1;
    from_bernstein(e->w, d, pts);
    for (int k = 0; k < 3; k++)
        from_bernstein(e->p[k], d, pts + (k + 1) * (d + 1));
}

/* The value of a result at t, and of the end v = 1 of a ruling. */
static void value_of(ix_ctx *ctx, const ix_mv *m, double t, double *x)
{
    double tv[2] = {t, 1};

    x[0] = x[1] = x[2] = 0;
    ASSERT_OK(ctx, ix_mv_point(ctx, m, tv, x));
}

static void check_value(const ix_op *op, int n, num want[3], const double *x)
{
    double size = 0, gap = 0;

    for (int k = 0; k < n; k++) {
        double v = fmpq_get_d(want[k]);

        size = fmax(size, fabs(v));
        gap = fmax(gap, fabs(x[k] - v));
    }
    if (!(gap <= 1e-12 * size))
        fail_msg("%s: off by %g of %g", op->name, gap, size);
}

/* The point is on the axis of the circle of curvature:
 * (x - x(t)).x' = 0 and (x - x(t)).x'' = |x'|^2. */
static void check_axis(const jet *j, const double *x)
{
    double f[2] = {0, 0}, size[2] = {0, 0};

    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 2; i++) {
            double y = x[k] - fmpq_get_d(j->x[0].c[k]);
            double a = y * fmpq_get_d(j->x[i + 1].c[k]);

            f[i] += a;
            size[i] += fabs(a);
        }
    f[1] -= fmpq_get_d(inner(j->x[1], j->x[1]));
    assert_true(fabs(f[0]) <= 1e-12 * size[0]);
    assert_true(fabs(f[1]) <= 1e-12 * size[1]);
}

static void check_op(ix_ctx *ctx, const ix_op *op, const exact *e,
                     const ix_mv *c, int dim)
{
    ix_op_args a = {.mv = {c}, .num = {0, 1}};
    ix_op_opts o = {IX_FORM_MINIMAL, INT_MAX};
    ix_mv *m;

    ASSERT_OK(ctx, op->run(ctx, &a, &o, NULL, &m));
    for (int i = 0; i <= 8; i++) {
        double x[3];
        num t = fresh(), want[3];
        jet j;

        fmpq_set_si(t, i, 8);
        j = jet_at(e, dim, t);
        value_of(ctx, m, i / 8.0, x);
        if (strcmp(op->name, "FOCALSRF") == 0)
            check_axis(&j, x);
        else
            check_value(op, definition(op->name, dim, &j, want), want, x);
        used = 0;
    }
    ix_mv_unref(ctx, m);
}

/* Law: the minimal form of every operator on curves, for integer control
 * points, is its definition in rational numbers, to rounding: 1e-12 of the
 * value for these curves. */
static void all_operators_are_exact(void **state)
{
    static const char *const space[] = {
        "CCRVTR",    "CCRVTRSQR",  "CTORSION",     "CTORSIONZERO",
        "CNRMLCRV",  "EVOLUTE",    "FOCALCRV",     "FOCALSRF",
        "TANDEVSRF", "NRMLSCROLL", "BINRMLSCROLL", "RECTDEVSRF"};
    static const char *const plane[] = {"CINFLECT", "CCRVTR", "CCRVTRSQR",
                                        "CNRMLCRV", "EVOLUTE"};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(83);
    double pts[4 * (MAX_D + 1)];
    exact e;

    (void)state;
    poly_all(&e, fmpq_poly_init);
    for (int i = 0; i < POOL; i++)
        fmpq_init(&pool[i]);
    for (int round = 0; round < 8; round++) {
        int d = 3 + (round >> 2), dim = 2 + (round & 1);
        bool rational = round >> 1 & 1;
        ix_mv *c;

        helix_points(&r, &e, d, dim, rational, pts);
        c = make_crv(ctx, d + 1, d + 1, NULL, rational, dim,
                     rational ? pts : pts + d + 1);
        for (int i = 0; i < (dim == 2 ? 5 : 12); i++)
            check_op(ctx, ix__op_find((dim == 2 ? plane : space)[i]), &e, c,
                     dim);
        ix_mv_unref(ctx, c);
    }
    for (int i = 0; i < POOL; i++)
        fmpq_clear(&pool[i]);
    poly_all(&e, fmpq_poly_clear);
    ix_ctx_free(ctx);
}
#else
static void all_operators_are_exact(void **state)
{
    (void)state;
    skip();
}

static void focal_curve_is_rational(void **state)
{
    (void)state;
    skip();
}

static void torsion_is_exact(void **state)
{
    (void)state;
    skip();
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(focal_curve_is_rational),
        cmocka_unit_test(torsion_is_exact),
        cmocka_unit_test(all_operators_are_exact),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
