/* factor.c - the common factor of many polynomials.
 *
 * Everything is computed in coefficients c_k / sqrt(C(d,k)), c_k scaled
 * Bernstein: there products are as well conditioned as they can be (the norm
 * of Bombieri). A proposal may be poor; only the check by division counts. */
#include "sym/factor.h"

#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "bern/dense.h"
#include "sym/form.h"

/* Singular values below this part of the largest may be zeros: generous, for
 * proposals are checked. */
#define PROPOSE 1e-7
/* Beyond this degree a common factor is not looked for: the search is cubic,
 * and a second long from here on. */
#define MOST_DEGREE 160
/* Rounds of fitting the factor and the quotients in turn. */
enum { ROUNDS = 4 };

/* Binomials by degree, as square roots. */
static ix_status roots(ix_ctx *ctx, int d, const double **out)
{
    double *room, *r;
    const double *row;

    IX_SCRATCH(ctx, room, d + 1);
    IX_SCRATCH(ctx, r, d + 1);
    row = ix__binom(d, room);
    for (int k = 0; k <= d; k++)
        r[k] = sqrt(row[k]);
    *out = r;
    return IX_OK;
}

/* Columns: f times the monomials of degree e, f of degree d in scaled
 * coefficients; out double[e + 1][d + e + 1], leading dimension ld. */
static ix_status multiples(ix_ctx *ctx, int d, const double *f, int e,
                           size_t ld, double *out)
{
    const double *re, *rn;

    IX_TRY(roots(ctx, e, &re));
    IX_TRY(roots(ctx, d + e, &rn));
    for (int j = 0; j <= e; j++, out += ld) {
        memset(out, 0, ld * sizeof *out);
        for (int i = 0; i <= d; i++)
            out[i + j] = f[i] * re[j] / rn[i + j];
    }
    return IX_OK;
}

/* --- division ------------------------------------------------------------- */

/* max |p - h q| over Bernstein coefficients. */
static double mismatch(int k, const double *h, int e, const double *q,
                       const double *p, const double *binom, double *work)
{
    double worst = 0.0, *prod = work, *room = work + k + e + 1;

    ix__bern_conv_spans(1, k, h, e, q, IX__SET, room, prod);
    for (int i = 0; i <= k + e; i++)
        worst = fmax(worst, fabs(p[i] - prod[i]) / binom[i]);
    return worst;
}

ix_status ix__divide_all(ix_ctx *ctx, const ix__bundle *b, int k,
                         const double *h, double *q, double *change)
{
    int d = b->d, e = d - k;
    size_t n = (size_t)d + 1;
    double *a, *tau, *rhs, *room, *work;
    const double *re, *rd, *binom;

    IX_SCRATCH(ctx, a, n * (size_t)(e + 1));
    IX_SCRATCH(ctx, tau, e + 1);
    IX_SCRATCH(ctx, rhs, n);
    IX_SCRATCH(ctx, room, n);
    IX_SCRATCH(ctx, work, 2 * n + 2 * IX__BERN_PAD);
    IX_TRY(roots(ctx, e, &re));
    IX_TRY(roots(ctx, d, &rd));
    IX_TRY(multiples(ctx, k, h, e, n, a));
    binom = ix__binom(d, room);
    ix__dense_qr((int)n, e + 1, a, tau);
    *change = 0.0;
    for (size_t l = 0; l < b->n; l++, q += e + 1) {
        const double *p = b->p + l * n;

        for (int i = 0; i <= d; i++)
            rhs[i] = p[i] / rd[i];
        ix__dense_apply((int)n, e + 1, a, tau, rhs);
        if (!ix__dense_solve((int)n, e + 1, a, rhs)) {
            *change = HUGE_VAL;
            return IX_OK;
        }
        for (int i = 0; i <= e; i++)
            q[i] = rhs[i] * re[i];
        *change = fmax(*change, mismatch(k, h, e, q, p, binom, work));
        IX_TRY(ix__poll(ctx));
    }
    return IX_OK;
}

/* --- proposing ------------------------------------------------------------ */

/* Two combinations of all polynomials with weights of no pattern. */
static void combine(const ix__bundle *b, double *f, double *g)
{
    size_t n = (size_t)b->d + 1;
    unsigned long seed = 12345;

    memset(f, 0, n * sizeof *f);
    memset(g, 0, n * sizeof *g);
    for (size_t l = 0; l < b->n; l++) {
        double w[2];

        for (int i = 0; i < 2; i++) {
            seed = (seed * 1103515245ul + 12345ul) & 0x7ffffffful;
            w[i] = (double)seed / 0x40000000 - 1.0;
        }
        for (size_t i = 0; i < n; i++) {
            f[i] += w[0] * b->p[l * n + i];
            g[i] += w[1] * b->p[l * n + i];
        }
    }
}

/* The null space of the transposed Sylvester matrix of f and g, from below:
 * functionals on polynomials of degree 2d - 1, double[2d][2d], of which the
 * last *count belong to (nearly) vanishing singular values. */
static ix_status functionals(ix_ctx *ctx, const ix__bundle *b,
                             const double **out, int *count)
{
    int d = b->d, n = 2 * d;
    size_t ln = (size_t)n;
    double *f, *g, *a, *at, *tau, *s, *v;

    IX_SCRATCH(ctx, f, d + 1);
    IX_SCRATCH(ctx, g, d + 1);
    IX_SCRATCH(ctx, a, ln * ln);
    IX_SCRATCH(ctx, at, ln * ln);
    IX_SCRATCH(ctx, tau, ln);
    IX_SCRATCH(ctx, s, ln);
    IX_SCRATCH(ctx, v, ln * ln);
    combine(b, f, g);
    IX_TRY(multiples(ctx, d, f, d - 1, ln, a));
    IX_TRY(multiples(ctx, d, g, d - 1, ln, a + (size_t)d * ln));
    for (size_t i = 0; i < ln; i++)
        for (size_t j = 0; j < ln; j++)
            at[i * ln + j] = a[j * ln + i];
    ix__dense_qr(n, n, at, tau);
    *count = 0;
    if (ix__dense_smallest(n, n, at, s) >
        PROPOSE * sqrt(n) * ix__bern_largest(ln * ln, a))
        return IX_OK;
    for (size_t j = 0; j < ln; j++) /* R alone has the right vectors */
        for (size_t i = j + 1; i < ln; i++)
            at[j * ln + i] = 0.0;
    ix__dense_singular(n, n, at, s, v);
    while (*count < d && !(s[n - 1 - *count] > PROPOSE * s[0]))
        ++*count;
    *out = v;
    return IX_OK;
}

/* The polynomial of degree k all of whose multiples of degree 2d - 1 are
 * annihilated by the last k of the functionals v. */
static ix_status propose(ix_ctx *ctx, int d, int k, const double *v, double *h)
{
    int n = 2 * d, e = n - 1 - k, m = k * (e + 1), w = k + 1;
    const double *rk, *re, *rn;
    double *a, *tau, *s, *x;

    if (m < w) /* k = 1, d = 1: one equation for two unknowns */
        m = w;
    IX_SCRATCH_ZERO(ctx, a, (size_t)m * (size_t)w);
    IX_SCRATCH(ctx, tau, w);
    IX_SCRATCH(ctx, s, w);
    IX_SCRATCH(ctx, x, w * w);
    IX_TRY(roots(ctx, k, &rk));
    IX_TRY(roots(ctx, e, &re));
    IX_TRY(roots(ctx, n - 1, &rn));
    for (int l = 0; l <= k; l++)
        for (int j = 0; j < k; j++) {
            const double *f = v + (size_t)(n - 1 - j) * (size_t)n;

            for (int i = 0; i <= e; i++)
                a[l * m + j * (e + 1) + i] = f[l + i] * rk[l] * re[i] /
                                             rn[l + i];
        }
    ix__dense_qr(m, w, a, tau);
    for (int j = 0; j < w; j++)
        for (int i = j + 1; i < m; i++)
            a[j * m + i] = 0.0;
    ix__dense_singular(m, w, a, s, x);
    for (int l = 0; l <= k; l++)
        h[l] = x[k * w + l] * rk[l];
    return IX_OK;
}

/* Largest Bernstein coefficient 1. */
static ix_status normalise(ix_ctx *ctx, int k, double *h)
{
    double *room, big = 0.0;
    const double *row;

    IX_SCRATCH(ctx, room, k + 1);
    row = ix__binom(k, room);
    for (int i = 0; i <= k; i++)
        if (fabs(h[i] / row[i]) > fabs(big))
            big = h[i] / row[i];
    for (int i = 0; big != 0.0 && i <= k; i++)
        h[i] /= big;
    return IX_OK;
}

/* h fitted to all p given all q: least squares over the stacked equations,
 * folded into normal equations of size k + 1 one quotient at a time. */
static ix_status refit(ix_ctx *ctx, const ix__bundle *b, int k, const double *q,
                       double *h)
{
    int d = b->d, e = d - k, w = k + 1;
    size_t n = (size_t)d + 1, rows = n + (size_t)w;
    double *a, *rhs, *tau, *r, *y;
    const double *rk, *rd;

    IX_SCRATCH(ctx, a, rows * (size_t)w);
    IX_SCRATCH(ctx, rhs, rows);
    IX_SCRATCH(ctx, tau, w);
    IX_SCRATCH_ZERO(ctx, r, w * w); /* R of all equations so far */
    IX_SCRATCH_ZERO(ctx, y, w);
    IX_TRY(roots(ctx, k, &rk));
    IX_TRY(roots(ctx, d, &rd));
    for (size_t l = 0; l < b->n; l++, q += e + 1) {
        IX_TRY(multiples(ctx, e, q, k, rows, a));
        for (int j = 0; j < w; j++)
            memcpy(a + (size_t)j * rows + n, r + j * w, (size_t)w * sizeof *r);
        for (size_t i = 0; i < n; i++)
            rhs[i] = b->p[l * n + i] / rd[i];
        memcpy(rhs + n, y, (size_t)w * sizeof *y);
        ix__dense_qr((int)rows, w, a, tau);
        ix__dense_apply((int)rows, w, a, tau, rhs);
        for (int j = 0; j < w; j++)
            for (int i = 0; i <= j; i++)
                r[j * w + i] = a[(size_t)j * rows + (size_t)i];
        memcpy(y, rhs, (size_t)w * sizeof *y);
    }
    if (!ix__dense_solve(w, w, r, y))
        return IX_OK;
    for (int l = 0; l <= k; l++)
        h[l] = y[l] * rk[l];
    return IX_OK;
}

/* The best h of degree k, and what it changes. */
static ix_status try_degree(ix_ctx *ctx, const ix__bundle *b, int k,
                            const double *v, double *h, double *change)
{
    double *q, *next, c;

    IX_SCRATCH(ctx, q, b->n * (size_t)(b->d - k + 1));
    IX_SCRATCH(ctx, next, k + 1);
    IX_TRY(propose(ctx, b->d, k, v, h));
    IX_TRY(normalise(ctx, k, h));
    IX_TRY(ix__divide_all(ctx, b, k, h, q, change));
    for (int i = 0; i<ROUNDS && * change> b->tol; i++) {
        memcpy(next, h, (size_t)(k + 1) * sizeof *h);
        IX_TRY(refit(ctx, b, k, q, next));
        IX_TRY(normalise(ctx, k, next));
        IX_TRY(ix__divide_all(ctx, b, k, next, q, &c));
        if (!(c < *change))
            break;
        memcpy(h, next, (size_t)(k + 1) * sizeof *h);
        *change = c;
    }
    return IX_OK;
}

static ix_status search(ix_ctx *ctx, const ix__bundle *b, int most, double *h,
                        int *k, double *change)
{
    const double *v = NULL;
    int count;

    IX_TRY(functionals(ctx, b, &v, &count));
    for (int i = count < most ? count : most; i > 0; i--) {
        ix_mark mk = ix__scratch_mark(ctx);
        ix_status st = try_degree(ctx, b, i, v, h, change);

        ix__scratch_release(ctx, mk);
        IX_TRY(st);
        if (*change <= b->tol) {
            *k = i;
            return IX_OK;
        }
    }
    return IX_OK;
}

ix_status ix__common_factor(ix_ctx *ctx, const ix__bundle *b, int most,
                            double *h, int *k, double *change)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st = IX_OK;

    *k = 0;
    if (b->d > 0 && b->d <= MOST_DEGREE && most > 0)
        st = search(ctx, b, most, h, k, change);
    if (*k == 0) {
        h[0] = 1.0;
        *change = 0.0;
    }
    ix__scratch_release(ctx, mk);
    return st;
}
