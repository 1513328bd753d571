/* blossom.c - the polar form of a multivariate, direction by direction. */
#include <math.h>

#include "bsp/basis.h"
#include "mv/window.h"

/* The span whose polynomial is meant: that of the middle of the arguments, so
 * that consecutive knots give the control point that they belong to. */
static int choose_window(const ix_dir *dir, const double *args)
{
    double lo = args[0], hi = args[0];

    for (int i = 1; i < dir->order - 1; i++) {
        lo = fmin(lo, args[i]);
        hi = fmax(hi, args[i]);
    }
    return ix__basis_first(dir, 0.5 * (lo + hi));
}

static ix_status blossom(ix_ctx *ctx, const ix_mv *m, const double *const *args,
                         double *out)
{
    ix__window win;

    IX_TRY(ix__window_init(ctx, m, &win));
    for (int d = 0; d < m->ndirs; d++) {
        const ix_dir *dir = m->dirs + d;

        if (dir->basis == IX_POWER)
            return IX_FAIL(ctx, IX_EARG,
                           "direction %d: no blossom of a power basis", d);
        for (int i = 0; i < dir->order - 1; i++)
            if (!isfinite(args[d][i]))
                return IX_FAIL(ctx, IX_EARG,
                               "argument %d of direction %d is %g", i, d,
                               args[d][i]);
        win.first[d] = dir->order > 1 ? choose_window(dir, args[d]) : 0;
        ix__basis_blossom(dir, win.first[d], args[d], win.w[d]);
    }
    ix__window_sum(&win, out);
    return IX_OK;
}

ix_status ix_mv_blossom(ix_ctx *ctx, const ix_mv *m, const double *const *args,
                        double *out)
{
    IX_RETURN_SCOPED(ctx, blossom(ctx, m, args, out));
}
