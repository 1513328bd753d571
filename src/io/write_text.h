/* write_text.h - what all writers of text ask at the end of a loop. */
#ifndef IO_WRITE_TEXT_H
#define IO_WRITE_TEXT_H

#include "io/io.h"

/* start: ix__buf_total(b) when the writer began; nonfinite: some number was NaN
 * or infinite, and files hold no such. Err IX_ENOMEM; IX_EDOMAIN; IX_EUNABLE
 * more than IX_MAX_TEXT bytes; IX_ECANCEL; what the buffer's sink fails with.
 */
ix_status ix__write_check(ix_buf *b, size_t start,
                          bool nonfinite) IX_MUST_CHECK;
/* The shortest text of v that reads back; marks what is not finite. */
void ix__write_num(ix_buf *b, double v, bool *nonfinite);

#endif
