/* compose_impl.h - what compose.c asks of the inner function. */
#ifndef SYM_COMPOSE_IMPL_H
#define SYM_COMPOSE_IMPL_H

#include "sym/form_impl.h"

/* Err IX_EDOMAIN the coordinate x / w leaves the breaks of sp, f's direction
 * dir, by more than 1e-5 of their length. w has one sign. */
ix_status ix__inner_check(ix_ctx *ctx, const ix_form *x, const ix_form *w,
                          int dir, const ix_spans *sp) IX_MUST_CHECK;

/* The curve g, with coordinates x / w, on breaks at which it passes those of
 * f in any direction. */
ix_status ix__inner_cut(ix_ctx *ctx, const ix_form *f, const ix_form *x,
                        const ix_form *w, ix_form *g) IX_MUST_CHECK;

#endif
