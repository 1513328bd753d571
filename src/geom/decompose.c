/* decompose.c - a polynomial curve as a composition c(t) = f(g(t)).
 *
 * In powers of x = 2t - 1, for a scalar g of degree s and f of degree r with
 * r s = n: the s highest coefficients of c fix g up to an affine map, since
 * those of (x^s + ...)^r do not depend on the lower terms of f (Kozen and
 * Landau 1989). f follows by least squares; what the fit leaves decides
 * whether there is such a decomposition. All axes of a rational curve share
 * one g, so homogeneous curves need no other treatment. */
#include <math.h>
#include <string.h>

#include "bsp/band.h"
#include "bsp/basis.h"
#include "geom/angle.h"
#include "geom/path.h"
#include "iritx/geom.h"

/* out[d + 1]: coefficients in z of  sum a_k (A0 + A1 z)^k (B0 + B1 z)^(d-k),
 * by Horner's scheme; f = {A0, A1, B0, B1}, power[d + 1] is room. */
static void expand(int d, const double *a, const double f[4], double *power,
                   double *out)
{
    out[0] = a[d];
    power[0] = 1;
    for (int j = 0; j < d; j++) {
        out[j + 1] = power[j + 1] = 0;
        for (int k = j + 1; k >= 0; k--) {
            out[k] = f[0] * out[k] + (k ? f[1] * out[k - 1] : 0);
            power[k] = f[2] * power[k] + (k ? f[3] * power[k - 1] : 0);
        }
        for (int k = 0; k <= j + 1; k++)
            out[k] += a[d - j - 1] * power[k];
    }
}

/* Bernstein coefficients on [0, 1], scaled by binomials in place, to powers
 * of x. */
static void to_powers(int d, double *b, double *power, double *c)
{
    static const double x_form[4] = {1, 1, 1, -1};
    double binom = 1;

    for (int i = 0; i <= d; i++) {
        b[i] *= binom;
        binom = binom * (d - i) / (i + 1);
    }
    expand(d, b, x_form, power, c);
    for (int i = 0; i <= d; i++)
        c[i] = ldexp(c[i], -d);
}

/* Powers of x to Bernstein coefficients on [0, 1]. */
static void to_bernstein(int d, const double *c, double *power, double *b)
{
    static const double uv_form[4] = {-1, 1, 1, 1};
    double binom = 1;

    expand(d, c, uv_form, power, b);
    for (int i = 0; i <= d; i++) {
        b[i] /= binom;
        binom = binom * (d - i) / (i + 1);
    }
}

/* g = x^s + g_{s-1} x^{s-1} + ... + g_1 x whose r-th power agrees with c / c_n
 * in the s highest coefficients: with q = c / (c_n x^n) in powers of 1/x,
 * g / x^s is the head of y = q^(1/r), and  y' q = (1/r) q' y. */
static void inner(int n, const double *c, int s, double *g)
{
    double e = (double)s / n;

    g[s] = 1;
    g[0] = 0;
    for (int k = 1; k < s; k++) { /* coefficient of x^-k */
        double sum = 0;

        for (int j = 1; j <= k; j++)
            sum += (e * j - (k - j)) * (c[n - j] / c[n]) * g[s - (k - j)];
        g[s - k] = sum / k;
    }
}

/* Into [0, 1], so that f is asked within its domain only. */
static void normalise(int s, double *b)
{
    double lo = b[0], hi = b[0];

    for (int i = 1; i <= s; i++) {
        lo = fmin(lo, b[i]);
        hi = fmax(hi, b[i]);
    }
    for (int i = 0; i <= s; i++)
        b[i] = (b[i] - lo) / (hi - lo);
}

typedef struct {
    const ix_path *p;
    int n;         /* the true degree */
    double *pow;   /* [naxes][degree + 1], powers of x */
    int lead;      /* axis with the largest highest coefficient */
    double size;   /* largest control value */
    double *g, *f; /* Bernstein: [s + 1], [naxes][r + 1] */
} problem;

/* One equation: axis k at a Chebyshev point, linear in f and, if slopes is
 * given, in changes of g. */
typedef struct {
    int s, r, naxes;
    double *bg, *bf, *slope; /* basis values of g, f, derivatives of f's */
    double at;               /* g */
    double rhs[IX_MAX_COORDS + 1];
} equation;

static void sample(const problem *pr, int i, int rows, equation *e)
{
    const ix_dir gd = {
        .basis = IX_BEZIER, .order = e->s + 1, .length = e->s + 1};
    const ix_dir fd = {
        .basis = IX_BEZIER, .order = e->r + 1, .length = e->r + 1};
    double t = (1 - cos(IX__PI * (i + 0.5) / rows)) / 2;
    double a = pr->p->breaks[0], h = pr->p->breaks[1] - a;

    ix__basis_derive(&gd, 0, t, 0, e->bg);
    e->at = 0;
    for (int k = 0; k <= e->s; k++)
        e->at += e->bg[k] * pr->g[k];
    ix__basis_derive(&fd, 0, e->at, 0, e->bf);
    ix__basis_derive(&fd, 0, e->at, 1, e->slope);
    ix__path_axes(pr->p, 0, a + t * h, 0, e->rhs);
}

/* f by least squares for the present g; *rest: root mean square left over. */
static ix_status outer(ix_ctx *ctx, problem *pr, equation *e, double *rest)
{
    int rows = 2 * pr->n + 2, m = e->r + 1;
    double sum = 0;
    ix_band band;
    ix_status st;

    IX_TRY(ix__band_new(ctx, m, m, false, e->naxes, &band));
    for (int i = 0; i < rows; i++) {
        sample(pr, i, rows, e);
        ix__band_add(&band, 0, m, e->bf, e->rhs);
    }
    for (int k = 0; k < e->naxes; k++)
        sum += band.rest[k];
    *rest = sqrt(sum / rows);
    st = ix__band_solve(ctx, &band, pr->f);
    if (st == IX_EDOMAIN)
        *rest = HUGE_VAL;
    return st == IX_EDOMAIN ? IX_OK : st;
}

/* The two Bernstein coefficients that fix g among its affine images. */
static void pinned(const problem *pr, int s, int pin[2])
{
    pin[0] = pin[1] = 0;
    for (int k = 1; k <= s; k++) {
        if (pr->g[k] < pr->g[pin[0]])
            pin[0] = k;
        if (pr->g[k] > pr->g[pin[1]])
            pin[1] = k;
    }
}

/* A Gauss-Newton step for f and g together; g changes. The highest
 * coefficients of c, from which g came, may be small and noisy. */
static ix_status improve(ix_ctx *ctx, problem *pr, equation *e)
{
    int rows = 2 * pr->n + 2, m = e->r + 1, nf = m * e->naxes, pin[2], k = 0;
    int n = nf + e->s - 1;
    double *row, *x;
    ix_band band;
    ix_status st;

    pinned(pr, e->s, pin);
    IX_SCRATCH(ctx, row, n);
    IX_SCRATCH(ctx, x, n);
    IX_TRY(ix__band_new(ctx, n, n, false, 1, &band));
    for (int i = 0; i < rows; i++) {
        sample(pr, i, rows, e);
        for (int a = 0; a < e->naxes; a++) {
            double slope = 0;

            memset(row, 0, (size_t)n * sizeof *row);
            memcpy(row + a * m, e->bf, (size_t)m * sizeof *row);
            for (int j = 0; j < m; j++)
                slope += e->slope[j] * pr->f[a * m + j];
            for (int j = 0, q = nf; j <= e->s; j++)
                if (j != pin[0] && j != pin[1])
                    row[q++] = slope * e->bg[j];
            ix__band_add(&band, 0, n, row, &e->rhs[a]);
        }
    }
    st = ix__band_solve(ctx, &band, x);
    for (int j = 0; st == IX_OK && j <= e->s; j++)
        if (j != pin[0] && j != pin[1])
            pr->g[j] += x[nf + k++];
    return st == IX_EDOMAIN ? IX_OK : st;
}

/* f and a better g; good: it is f(g) = c. */
static ix_status fit(ix_ctx *ctx, problem *pr, int s, bool *good)
{
    equation e = {.s = s, .r = pr->n / s, .naxes = pr->p->naxes};
    double rest;

    IX_SCRATCH(ctx, e.bg, pr->n + 1);
    IX_SCRATCH(ctx, e.bf, pr->n + 1);
    IX_SCRATCH(ctx, e.slope, pr->n + 1);
    normalise(s, pr->g);
    IX_TRY(outer(ctx, pr, &e, &rest));
    /* a start that is worse than 1e-3 has little to do with c */
    for (int i = 0; i < 6 && rest <= 1e-3 * pr->size; i++) {
        /* 1e-13: no better in double precision */
        if (rest <= 1e-13 * pr->size)
            break;
        IX_TRY(improve(ctx, pr, &e));
        normalise(s, pr->g);
        IX_TRY(outer(ctx, pr, &e, &rest));
    }
    /* 1e-10 of the curve: compositions come with a few digits of rounding,
       what is none differs far more */
    *good = rest <= 1e-10 * pr->size;
    return IX_OK;
}

/* Powers of all axes, and the degree that is really there. */
static ix_status analyse(ix_ctx *ctx, problem *pr)
{
    int d = pr->p->degree, m = d + 1;
    double *b, *power;

    IX_SCRATCH(ctx, pr->pow, pr->p->naxes * m);
    IX_SCRATCH(ctx, b, m);
    IX_SCRATCH(ctx, power, m);
    for (int a = 0; a < pr->p->naxes; a++) {
        for (int i = 0; i < m; i++) {
            b[i] = pr->p->coef[a * m + i];
            pr->size = fmax(pr->size, fabs(b[i]));
        }
        to_powers(d, b, power, pr->pow + a * m);
    }
    for (pr->n = d; pr->n > 0; pr->n--) {
        for (int a = 0; a < pr->p->naxes; a++)
            if (fabs(pr->pow[a * m + pr->n]) >
                fabs(pr->pow[pr->lead * m + pr->n]))
                pr->lead = a;
        /* 1e-12: a degree raised in rounding */
        if (fabs(pr->pow[pr->lead * m + pr->n]) > 1e-12 * pr->size)
            break;
    }
    return IX_OK;
}

static ix_status emit(ix_ctx *ctx, const problem *pr, const ix_mv *crv, int s,
                      ix_mv **f, ix_mv **g)
{
    int r = pr->n / s;
    const ix_dir gd = {.basis = IX_BEZIER, .order = s + 1, .length = s + 1};
    const ix_dir fd = {.basis = IX_BEZIER, .order = r + 1, .length = r + 1};
    ix_mv *bez = NULL;
    ix_status st;

    IX_TRY(ix_mv_new(ctx, 1, &gd, 1, false, pr->g, &bez));
    if (ix_mv_dir(crv, 0).basis == IX_BSPLINE) {
        st = ix_mv_reparam(ctx, bez, 0, pr->p->breaks[0], pr->p->breaks[1], g);
        ix_mv_unref(ctx, bez);
    } else {
        *g = bez;
        st = IX_OK;
    }
    if (st == IX_OK)
        st = ix_mv_new(ctx, 1, &fd, pr->p->ncoords, pr->p->rational, pr->f, f);
    if (st != IX_OK) {
        ix_mv_unref(ctx, *g);
        *g = NULL;
    }
    return st;
}

static ix_status decompose(ix_ctx *ctx, const ix_mv *crv, ix_mv **f, ix_mv **g)
{
    problem pr = {0};
    double *power, *gx;
    bool good;
    ix_path p;

    IX_TRY(ix__path_new(ctx, crv, &p));
    if (p.nspans > 1)
        return IX_FAIL(ctx, IX_EARG,
                       "a curve with inner knots: decompose its pieces");
    pr.p = &p;
    IX_TRY(analyse(ctx, &pr));
    IX_SCRATCH(ctx, pr.g, p.degree + 1);
    IX_SCRATCH(ctx, gx, p.degree + 1);
    IX_SCRATCH(ctx, power, p.degree + 1);
    IX_SCRATCH(ctx, pr.f, p.naxes * (p.degree + 1));
    for (int s = 2; s <= pr.n / 2; s++) {
        if (pr.n % s)
            continue;
        inner(pr.n, pr.pow + pr.lead * (p.degree + 1), s, gx);
        to_bernstein(s, gx, power, pr.g);
        IX_TRY(fit(ctx, &pr, s, &good));
        if (good)
            return emit(ctx, &pr, crv, s, f, g);
    }
    return IX_OK;
}

ix_status ix_decompose(ix_ctx *ctx, const ix_mv *crv, ix_mv **f, ix_mv **g)
{
    *f = *g = NULL;
    IX_RETURN_SCOPED(ctx, decompose(ctx, crv, f, g));
}
