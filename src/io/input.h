/* input.h - the bytes of a text, one piece after the other: from memory, from
 * a file, from a packed one. Nobody who reads holds more than a window. */
#ifndef IO_INPUT_H
#define IO_INPUT_H

#include "io/io.h"

/* What readers hold of a text at a time; longer words make it grow. */
#define IX_INPUT_PIECE ((size_t)1 << 17)

/* A regular file, inflated if it is gzip (told by its first bytes); name stays
 * the caller's. Err IX_EIO, IX_EPARSE (packed by compress), IX_ENOMEM; messages
 * begin with the name. */
ix_status ix__input_file(ix_ctx *ctx, const char *name,
                         ix__input **out) IX_MUST_CHECK;
/* The same from data[n], which stays the caller's, as name. piece: what readers
 * are to hold, 8 bytes or more; 0 is IX_INPUT_PIECE. */
ix_status ix__input_memory(ix_ctx *ctx, const char *name, const char *data,
                           size_t n, size_t piece,
                           ix__input **out) IX_MUST_CHECK;
/* What read makes of a text in memory. */
typedef ix_status (*ix__read_fn)(ix__input *s, ix_obj **out);
ix_status ix__input_text(ix_ctx *ctx, const char *name, const char *data,
                         size_t n, ix__read_fn read,
                         ix_obj **out) IX_MUST_CHECK;
/* The same text from its start, to be closed before s. */
ix_status ix__input_again(const ix__input *s, ix__input **out) IX_MUST_CHECK;
void ix__input_close(ix__input *s); /* s may be NULL */

/* Fills to[room], 8 bytes or more; *n is less at the end only. A byte order
 * mark is left out. Err IX_EIO also more than IX_MAX_TEXT bytes, IX_EPARSE as
 * ix__gunzip_read, IX_ECANCEL. */
ix_status ix__input_read(ix__input *s, char *to, size_t room,
                         size_t *n) IX_MUST_CHECK;
/* The whole text has at most so many bytes; what a packed one may inflate to is
 * known roughly only. */
size_t ix__input_most(const ix__input *s);
ix_ctx *ix__input_ctx(const ix__input *s);
const char *ix__input_name(const ix__input *s);
size_t ix__input_piece(const ix__input *s);

#endif
