/* band.c - banded least squares: each new row is rotated into the triangle
 * (Golub and Van Loan, Matrix Computations, 5.2; Lawson and Hanson 1974, 27).
 * A triangle row whose diagonal is zero is empty and takes what comes. */
#include "bsp/band.h"

#include <math.h>
#include <string.h>

ix_status ix__band_new(ix_ctx *ctx, int n, int width, bool periodic, int nrhs,
                       ix_band *out)
{
    ix_band b = {.n = n, .width = width, .nrhs = nrhs};
    size_t main_rows;

    if (periodic)
        b.border = n < 2 * width ? n : width - 1;
    main_rows = (size_t)(n - b.border);
    IX_SCRATCH_ZERO(ctx, b.band, main_rows * (size_t)width);
    IX_SCRATCH_ZERO(ctx, b.edge, (size_t)n * (size_t)b.border);
    IX_SCRATCH_ZERO(ctx, b.rhs, (size_t)n * (size_t)nrhs);
    IX_SCRATCH_ZERO(ctx, b.rest, nrhs);
    IX_SCRATCH_ZERO(ctx, b.row, width + b.border + nrhs);
    *out = b;
    return IX_OK;
}

/* (r, x) <- (c r + s x, c x - s r) for n entries. */
static void rotate(double c, double s, int n, double *r, double *x)
{
    for (int i = 0; i < n; i++) {
        double ri = r[i], xi = x[i];

        r[i] = c * ri + s * xi;
        x[i] = c * xi - s * ri;
    }
}

/* The rotation that takes (r, x) to (hypot, 0). */
static void givens(double r, double x, double *c, double *s)
{
    double h = hypot(r, x);

    *c = r / h;
    *s = x / h;
}

static bool all_zero(const double *x, int n)
{
    for (int i = 0; i < n; i++)
        if (x[i] != 0)
            return false;
    return true;
}

/* Rotates the row's band, which starts at column j, into the main part.
 * Returns false if an empty triangle row took it. */
static bool absorb_band(ix_band *b, int j, double *band, double *edge,
                        double *rhs)
{
    int w = b->width, p = b->border;

    for (; j < b->n - p && !all_zero(band, w); j++) {
        double *r = b->band + (size_t)j * (size_t)w;
        double *e = b->edge + (size_t)j * (size_t)p;
        double *y = b->rhs + (size_t)j * (size_t)b->nrhs, c, s;

        if (band[0] != 0 && r[0] == 0) {
            memcpy(r, band, (size_t)w * sizeof *r);
            memcpy(e, edge, (size_t)p * sizeof *e);
            memcpy(y, rhs, (size_t)b->nrhs * sizeof *y);
            return false;
        }
        if (band[0] != 0) {
            givens(r[0], band[0], &c, &s);
            rotate(c, s, w, r, band);
            rotate(c, s, p, e, edge);
            rotate(c, s, b->nrhs, y, rhs);
        }
        memmove(band, band + 1, (size_t)(w - 1) * sizeof *band);
        band[w - 1] = 0;
    }
    return true;
}

/* The same for what is left: the border's columns and triangle. */
static bool absorb_edge(ix_band *b, double *edge, double *rhs)
{
    int p = b->border;

    for (int j = 0; j < p; j++) {
        size_t row = (size_t)b->n - (size_t)p + (size_t)j;
        double *e = b->edge + row * (size_t)p, c, s;
        double *y = b->rhs + row * (size_t)b->nrhs;

        if (edge[j] != 0 && e[j] == 0) {
            memcpy(e, edge, (size_t)p * sizeof *e);
            memcpy(y, rhs, (size_t)b->nrhs * sizeof *y);
            return false;
        }
        if (edge[j] != 0) {
            givens(e[j], edge[j], &c, &s);
            rotate(c, s, p - j, e + j, edge + j);
            rotate(c, s, b->nrhs, y, rhs);
            edge[j] = 0;
        }
    }
    return true;
}

void ix__band_add(ix_band *b, int first, int m, const double *coef,
                  const double *rhs)
{
    double *band = b->row, *edge = band + b->width, *y = edge + b->border;
    int main_rows = b->n - b->border, start = first < main_rows ? first : 0;

    memset(b->row, 0, (size_t)(b->width + b->border) * sizeof *b->row);
    for (int i = 0; i < m; i++) {
        int col = (first + i) % b->n;

        if (col >= main_rows)
            edge[col - main_rows] += coef[i];
        else
            band[col - start] += coef[i];
    }
    memcpy(y, rhs, (size_t)b->nrhs * sizeof *y);
    if (absorb_band(b, start, band, edge, y) && absorb_edge(b, edge, y))
        for (int k = 0; k < b->nrhs; k++)
            b->rest[k] += y[k] * y[k];
}

/* Entry (row, col) of the triangle. */
static double entry(const ix_band *b, int row, int col)
{
    int main_rows = b->n - b->border;

    if (col >= main_rows)
        return b
            ->edge[(size_t)row * (size_t)b->border + (size_t)(col - main_rows)];
    return b->band[(size_t)row * (size_t)b->width + (size_t)(col - row)];
}

/* Back substitution of one unknown for one right-hand side. */
static double unknown(const ix_band *b, int row, int k, const double *x)
{
    int main_rows = b->n - b->border, stop = row + b->width;
    double sum = b->rhs[(size_t)row * (size_t)b->nrhs + (size_t)k];

    if (stop > main_rows)
        stop = main_rows;
    for (int c = row + 1; c < stop; c++)
        sum -= entry(b, row, c) * x[c];
    for (int c = row < main_rows ? main_rows : row + 1; c < b->n; c++)
        sum -= entry(b, row, c) * x[c];
    return sum / entry(b, row, row);
}

ix_status ix__band_solve(ix_ctx *ctx, const ix_band *b, double *x)
{
    double top = 0;

    for (int j = 0; j < b->n; j++)
        top = fmax(top, fabs(entry(b, j, j)));
    for (int j = 0; j < b->n; j++)
        /* beyond 1e13 in condition fewer than three digits would be left */
        if (!(fabs(entry(b, j, j)) > 1e-13 * top))
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "singular system: unknown %d of %d is not "
                           "determined (pivot %g of %g)",
                           j, b->n, entry(b, j, j), top);
    for (int k = 0; k < b->nrhs; k++) {
        double *xk = x + (size_t)k * (size_t)b->n;

        for (int j = b->n - 1; j >= 0; j--)
            xk[j] = unknown(b, j, k, xk);
    }
    return IX_OK;
}
