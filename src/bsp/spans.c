/* spans.c - breakpoints with known continuity: of a direction, of two
 * functions together, and the knot vector that they call for. */
#include "bsp/spans.h"

#include <limits.h>
#include <math.h>

#include "bsp/knots.h"

ix_status ix__spans_of(ix_ctx *ctx, const ix_dir *dir, ix_spans *out)
{
    const double *kv;
    double *breaks;
    int *cont;
    int lo = dir->order - 1, hi, n = 0;

    if (dir->basis == IX_POWER)
        return IX_FAIL(ctx, IX_EARG, "a power basis has no spans");
    IX_TRY(ix__dir_knots(ctx, dir, &kv));
    hi = ix__dir_npoints(dir);
    IX_SCRATCH(ctx, breaks, hi - lo + 1);
    IX_SCRATCH(ctx, cont, hi - lo + 1);
    breaks[0] = kv[lo];
    for (int i = lo + 1; i <= hi; i++) {
        if (kv[i] > breaks[n]) {
            breaks[++n] = kv[i];
            cont[n - 1] = dir->order - 2;
        } else if (n > 0) {
            cont[n - 1]--; /* one more knot at an interior break */
        }
    }
    *out = (ix_spans){dir->order - 1, n, breaks, cont};
    return IX_OK;
}

ix_status ix__spans_union(ix_ctx *ctx, const ix_spans *a, const ix_spans *b,
                          int degree, ix_spans *out)
{
    int i = 1, j = 1, n = 0, nb = b->nspans;
    double lo = a->breaks[0], hi = a->breaks[a->nspans];
    double tol = ix__knots_ulp4(a->nspans + 1, a->breaks), *breaks;
    int *cont;

    while (j < nb && b->breaks[j] <= lo + tol) /* ends may differ by an ulp */
        j++;
    while (nb > j && b->breaks[nb - 1] >= hi - tol)
        nb--;
    IX_SCRATCH(ctx, breaks, (size_t)a->nspans + (size_t)b->nspans);
    IX_SCRATCH(ctx, cont, (size_t)a->nspans + (size_t)b->nspans);
    breaks[0] = lo;
    while (i < a->nspans || j < nb) {
        double x = i < a->nspans ? a->breaks[i] : HUGE_VAL;
        double y = j < nb ? b->breaks[j] : HUGE_VAL;
        int ca = INT_MAX, cb = INT_MAX;

        if (x <= y + tol)
            ca = a->cont[i++ - 1];
        if (y <= x + tol)
            cb = b->cont[j++ - 1];
        cont[n] = ca < cb ? ca : cb;
        breaks[++n] = x <= y + tol ? x : y;
    }
    breaks[++n] = hi;
    *out = (ix_spans){degree, n, breaks, cont};
    return IX_OK;
}

/* Multiplicity that continuity c calls for at degree d. */
static int multiplicity(int d, int c)
{
    if (c >= d)
        return 0;
    return c < -1 ? d + 1 : d - c;
}

ix_status ix__spans_target(ix_ctx *ctx, const ix_spans *sp, int max_cont,
                           bool allow_bezier, ix_dir *out)
{
    int d = sp->degree, last = sp->nspans;
    const double *br = sp->breaks;
    size_t total = 2 * ((size_t)d + 1), n = 0;
    double *kv;

    if (allow_bezier && last == 1 && br[0] == 0 && br[1] == 1) {
        *out = (ix_dir){IX_BEZIER, d + 1, d + 1, false, NULL};
        return IX_OK;
    }
    for (int j = 0; j < last - 1; j++)
        total += (size_t)multiplicity(d, sp->cont[j] < max_cont ? sp->cont[j]
                                                                : max_cont);
    if (d + 1 > IX_MAX_ORDER || total > INT_MAX)
        return IX_FAIL(ctx, IX_EUNABLE,
                       "a result of order %d with %zu knots is too large",
                       d + 1, total);
    IX_SCRATCH(ctx, kv, total);
    for (int j = 0; j <= last; j++) {
        int m = d + 1;

        if (j > 0 && j < last)
            m = multiplicity(d, sp->cont[j - 1] < max_cont ? sp->cont[j - 1]
                                                           : max_cont);
        while (m-- > 0)
            kv[n++] = br[j];
    }
    *out = (ix_dir){IX_BSPLINE, d + 1, (int)total - d - 1, false, kv};
    return IX_OK;
}
