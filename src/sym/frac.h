/* frac.h - operands of the public algebra as fractions of forms: numerators x
 * (one row for each coordinate) over one weight, which may be absent (1). */
#ifndef SYM_FRAC_H
#define SYM_FRAC_H

#include "sym/form.h"

typedef struct {
    ix_form x, w;
    bool rational; /* w counts */
} ix_frac;

/* n <= 3 operands on common breaks. */
ix_status ix__fracs_load(ix_ctx *ctx, int n, const ix_mv *const *m,
                         ix_frac *out) IX_MUST_CHECK;
/* Zero rows appended until there are nc coordinates. */
ix_status ix__frac_pad(ix_ctx *ctx, ix_frac *f, int nc) IX_MUST_CHECK;
/* out's weight = product of the weights there are. */
ix_status ix__frac_weights(ix_ctx *ctx, const ix_frac *a, const ix_frac *b,
                           ix_frac *out) IX_MUST_CHECK;
ix_status ix__frac_store(ix_ctx *ctx, const ix_frac *f, const ix_sym_opts *o,
                         ix_mv **out) IX_MUST_CHECK;

/* The frame of every public operation of two or three operands: loads them,
 * calls body, stores its result, releases the scratch memory. */
typedef ix_status (*ix__frac_body)(ix_ctx *ctx, ix_frac *operands, int sign,
                                   ix_frac *out);
ix_status ix__frac_run(ix_ctx *ctx, int n, const ix_mv *const *m,
                       ix__frac_body body, int sign, const ix_sym_opts *o,
                       ix_mv **out) IX_MUST_CHECK;

#endif
