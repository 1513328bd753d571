/* form_impl.h - what the files of forms share among themselves. */
#ifndef SYM_FORM_IMPL_H
#define SYM_FORM_IMPL_H

#include <limits.h>

#include "sym/form.h"

/* One direction seen as outer * nspans blocks double[degree + 1][inner]. */
typedef struct {
    size_t outer, nspans, inner;
} ix__shape;
void ix__form_shape(const ix_form *f, int dir, ix__shape *s);

/* Calls fn for every block of in and the block of out in its place, in and
 * out differing in direction dir alone; span is that of the block. */
typedef void (*ix__block_fn)(const void *arg, size_t span, size_t inner,
                             const double *in, double *out);
void ix__form_blocks(ix_ctx *ctx, const ix_form *in, int dir, ix__block_fn fn,
                     const void *arg, double block_ns, ix_form *out);

/* A form like f but for direction dir, coefficients unset. */
ix_status ix__form_like(ix_ctx *ctx, const ix_form *f, int dir, ix_spans sp,
                        ix_form *out) IX_MUST_CHECK;

static inline size_t ix__spans_size(const ix_spans *sp)
{
    return (size_t)sp->nspans * ((size_t)sp->degree + 1);
}

/* Continuity changed by a number of orders, or IX__SMOOTH: all INT_MAX. */
#define IX__SMOOTH INT_MAX
ix_status ix__cont_shift(ix_ctx *ctx, ix_spans *sp, int by) IX_MUST_CHECK;
/* The smaller of both at each break. */
ix_status ix__cont_meet(ix_ctx *ctx, const ix_spans *a, const ix_spans *b,
                        const int **out) IX_MUST_CHECK;
/* Directions of a with the continuity of both. */
ix_status ix__form_meet(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                        ix_spans *dirs) IX_MUST_CHECK;
/* f's continuity cut to that of dirs. */
ix_status ix__form_narrow(ix_ctx *ctx, const ix_spans *dirs,
                          ix_form *f) IX_MUST_CHECK;
/* ix__form_alloc with coefficients that are there already (c NULL: not). */
ix_status ix__form_adopt(ix_ctx *ctx, int ndirs, const ix_spans *dirs,
                         int nrows, double *c, ix_form *out) IX_MUST_CHECK;
/* Bernstein coefficients double[nrows][n] to the scaled ones of f, in place or
 * not. */
ix_status ix__form_scale_in(ix_ctx *ctx, const ix_form *f,
                            const double *in) IX_MUST_CHECK;
/* Both at the larger degrees and one exponent; views or elevated copies. */
ix_status ix__form_match(ix_ctx *ctx, ix_form *a, ix_form *b) IX_MUST_CHECK;

#endif
