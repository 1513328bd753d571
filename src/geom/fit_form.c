/* fit_form.c - polynomials in two variables near data. The system is solved in
 * variables that are centred and scaled to the data, where it is conditioned
 * best; the coefficients are then expanded about the origin that is wanted. */
#include <math.h>
#include <string.h>

#include "bsp/band.h"
#include "iritx/geom_srf.h"

enum { MOST = IX_FORM_MOST, DEGREE = 3 };

int ix_form_terms(ix_form_kind kind, int power[IX_FORM_MOST][2])
{
    static const int degrees[][2] = {
        /* of each variable, in all */
        [IX_FORM_LINEAR] = {1, 1},    [IX_FORM_BILINEAR] = {1, 2},
        [IX_FORM_QUADRATIC] = {2, 2}, [IX_FORM_BIQUADRATIC] = {2, 4},
        [IX_FORM_CUBIC] = {3, 3},     [IX_FORM_BICUBIC] = {3, 6}};
    int n = 0;

    if (kind < IX_FORM_LINEAR || kind > IX_FORM_BICUBIC)
        return 0;
    for (int d = 0; d <= degrees[kind][1]; d++)
        for (int i = d; i >= 0; i--)
            if (i <= degrees[kind][0] && d - i <= degrees[kind][0]) {
                power[n][0] = i;
                power[n++][1] = d - i;
            }
    return n;
}

double ix_form_value(ix_form_kind kind, const double *coef,
                     const double center[2], const double uv[2])
{
    int power[MOST][2], n = ix_form_terms(kind, power);
    double x = uv[0] - center[0], y = uv[1] - center[1], sum = 0;

    for (int k = 0; k < n; k++)
        sum += coef[k] * pow(x, power[k][0]) * pow(y, power[k][1]);
    return sum;
}

/* Data, and the variables (u - mid) / half in which they are fitted. */
typedef struct {
    const ix_form_data *d;
    double mid[2], half[2];
    int n, power[MOST][2];
} task;

static ix_status set_variables(ix_ctx *ctx, task *t)
{
    int n = t->d->n;

    for (int k = 0; k < 2; k++) {
        double lo = HUGE_VAL, hi = -HUGE_VAL, sum = 0;

        for (int i = 0; i < n; i++) {
            double x = t->d->uv[(size_t)k * (size_t)n + (size_t)i];

            if (!isfinite(x))
                return IX_FAIL(ctx, IX_EARG, "parameter %g of point %d", x,
                               i + 1);
            lo = fmin(lo, x);
            hi = fmax(hi, x);
            sum += x / n;
        }
        t->mid[k] = sum;
        t->half[k] = hi > lo ? (hi - lo) / 2 : 1;
    }
    return IX_OK;
}

static ix_status solve(ix_ctx *ctx, const task *t, double *coef)
{
    const ix_form_data *d = t->d;
    size_t n = (size_t)d->n;
    double row[MOST], *rhs;
    ix_band b;

    IX_SCRATCH(ctx, rhs, d->ncoords);
    IX_TRY(ix__band_new(ctx, t->n, t->n, false, d->ncoords, &b));
    for (size_t i = 0; i < n; i++) {
        double x = (d->uv[i] - t->mid[0]) / t->half[0];
        double y = (d->uv[n + i] - t->mid[1]) / t->half[1];

        for (int k = 0; k < t->n; k++)
            row[k] = pow(x, t->power[k][0]) * pow(y, t->power[k][1]);
        for (size_t c = 0; c < (size_t)d->ncoords; c++)
            rhs[c] = d->values[c * n + i];
        ix__band_add(&b, 0, t->n, row, rhs);
    }
    return ix__band_solve(ctx, &b, coef);
}

/* x^p as a polynomial in u - c, x = (u - mid) / half: out[p + 1]. */
static void expand_power(int p, double mid, double half, double c, double *out)
{
    double shift = (c - mid) / half;

    memset(out, 0, (size_t)(p + 1) * sizeof *out);
    out[0] = 1;
    for (int q = 0; q < p; q++)
        for (int k = q + 1; k >= 0; k--)
            out[k] = (k <= q ? out[k] * shift : 0) +
                     (k > 0 ? out[k - 1] / half : 0);
}

/* Coefficients in x, y to coefficients in u - center[0], v - center[1]. */
static void recentre(const task *t, const double center[2], const double *from,
                     double *to)
{
    double full[DEGREE + 1][DEGREE + 1] = {{0}};

    for (int k = 0; k < t->n; k++) {
        double a[DEGREE + 1], b[DEGREE + 1];
        const int *p = t->power[k];

        expand_power(p[0], t->mid[0], t->half[0], center[0], a);
        expand_power(p[1], t->mid[1], t->half[1], center[1], b);
        for (int i = 0; i <= p[0]; i++)
            for (int j = 0; j <= p[1]; j++)
                full[i][j] += from[k] * a[i] * b[j];
    }
    for (int k = 0; k < t->n; k++)
        to[k] = full[t->power[k][0]][t->power[k][1]];
}

/* Measured in the variables of the fit: free of cancellation. */
static void measure(const task *t, const double *coef, ix_fit_error *err)
{
    const ix_form_data *d = t->d;
    const double zero[2] = {0, 0};
    size_t n = (size_t)d->n;
    double sum = 0, most = 0;

    for (size_t i = 0; i < n; i++) {
        double xy[2], s = 0;

        for (size_t k = 0; k < 2; k++)
            xy[k] = (d->uv[k * n + i] - t->mid[k]) / t->half[k];
        for (size_t c = 0; c < (size_t)d->ncoords; c++) {
            double gap = d->values[c * n + i] -
                         ix_form_value(d->kind, coef + c * (size_t)t->n, zero,
                                       xy);

            s += gap * gap;
        }
        sum += s;
        most = fmax(most, s);
    }
    *err = (ix_fit_error){sqrt(sum / (double)n), sqrt(most)};
}

static ix_status fit(ix_ctx *ctx, task *t, double center[2], ix_fit_error *err,
                     double *coef)
{
    double *x;

    IX_TRY(set_variables(ctx, t));
    IX_SCRATCH(ctx, x, t->n * t->d->ncoords);
    IX_TRY(solve(ctx, t, x));
    for (int k = 0; k < 2; k++)
        center[k] = t->d->centred ? t->mid[k] : 0;
    for (int c = 0; c < t->d->ncoords; c++)
        recentre(t, center, x + c * t->n, coef + c * t->n);
    if (err)
        measure(t, x, err);
    return IX_OK;
}

ix_status ix_fit_form(ix_ctx *ctx, const ix_form_data *d, double center[2],
                      ix_fit_error *err, double *coef)
{
    task t = {.d = d};

    t.n = ix_form_terms(d->kind, t.power);
    if (t.n == 0)
        return IX_FAIL(ctx, IX_EARG, "form %d is not within 1 .. 6",
                       (int)d->kind);
    if (d->n < t.n || d->ncoords < 1)
        return IX_FAIL(ctx, IX_EARG,
                       "%d points of %d coordinates; the form has %d "
                       "coefficients",
                       d->n, d->ncoords, t.n);
    IX_RETURN_SCOPED(ctx, fit(ctx, &t, center, err, coef));
}
