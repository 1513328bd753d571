/* summary.h - what objects are, without all their numbers. */
#ifndef APP_SUMMARY_H
#define APP_SUMMARY_H

#include "io/io.h"

/* Appends a line for o, indented by 2 depth blanks: type, name, orders, sizes,
 * attributes; a line for its box; then its elements likewise. Err IX_ECANCEL,
 * IX_ENOMEM. */
ix_status summary_add(ix_buf *b, const ix_obj *o, int depth) IX_MUST_CHECK;

/* More than a screen likes: a list, many points. */
bool summary_is_large(const ix_obj *o);
/* The same in few lines, for a person who looks on: the value alone where it is
 * short, the first elements of a long list. Appends whole lines. */
ix_status summary_add_short(ix_buf *b, const ix_obj *o) IX_MUST_CHECK;

#endif
