/* pending.c - stands in for library functions that are being written; gone
 * with the last of them. */
#include "iritx/sym.h"
#include "lang/builtin.h"

#define PENDING __attribute__((weak))


PENDING ix_status ix_mv_eval_grid(ix_ctx *ctx, const ix_mv *m,
                                  const int *counts,
                                  const double *const *params, double *out)
{
    (void)ctx, (void)m, (void)counts, (void)params, (void)out;
    return IX_EUNABLE;
}

PENDING ix_status ix_sym_compose(ix_ctx *ctx, const ix_mv *f, const ix_mv *g,
                                 ix_mv **out)
{
    (void)ctx, (void)f, (void)g, (void)out;
    return IX_EUNABLE;
}
