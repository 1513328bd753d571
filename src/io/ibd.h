/* ibd.h - the binary format ".ibd": what IRIT 11 writes on 64-bit Linux
 * (spec/ibd-format), which is also what it sends to clients that ask for it.
 *
 * A record is a sync word with its type, a block of fixed size, and what the
 * block owns. Blocks hold pointers of the writing program: only whether one is
 * zero matters. Numbers are little-endian, or all reversed. */
#ifndef IO_IBD_H
#define IO_IBD_H

#include "io/gz.h"
#include "io/input.h"

enum { /* types of records; objects have those of ix_obj_type */
       IX_IBD_END = 200,
       IX_IBD_ATTR,
       IX_IBD_VERTEX,
       IX_IBD_POLYGON,
       IX_IBD_CURVE,
       IX_IBD_SURFACE,
       IX_IBD_TRIMSRF,
       IX_IBD_TRIMLOOP,
       IX_IBD_TRIMSEG,
       IX_IBD_TRIVAR,
       IX_IBD_MATRIX,
       IX_IBD_STRING,
       IX_IBD_LIST,
       IX_IBD_INSTANCE,
       IX_IBD_TRISRF,
       IX_IBD_MODEL,
       IX_IBD_MODEL_SEG,
       IX_IBD_MODEL_SRF,
       IX_IBD_MODEL_LOOP,
       IX_IBD_MODEL_REF,
       IX_IBD_MULTIVAR
};

/* Sync word: type, size of a polygon's block, a constant, the byte order. */
#define IX_IBD_SYNC    0x43168000u
#define IX_IBD_OBJECT  272            /* bytes of the block of an object */
#define IX_IBD_REAL(k) (88 + 8 * (k)) /* number k in it */

/* Reads all objects of a file: one, or an unnamed list. Err IX_EPARSE (message
 * "name: byte N: ..."), IX_ENOMEM, what the input fails with. */
ix_status ix__ibd_read_from(ix__input *s, ix_obj **out) IX_MUST_CHECK;
/* Reads one object; fill gives just the bytes that belong to it. Err as above;
 * what fill fails with. */
ix_status ix__ibd_read_one(ix_ctx *ctx, const char *name, ix__fill_fn fill,
                           void *arg, ix_obj **out) IX_MUST_CHECK;
/* Appends o. Trimming curves in space have no place in the format: they are
 * left out, with a note. Err IX_EUNABLE an object without a value, one with
 * polygons and polylines (the format has neither); too deep, too long;
 * IX_EDOMAIN a number is not finite; IX_ENOMEM. */
ix_status ix__ibd_write(ix_buf *b, const ix_obj *o,
                        const ix_write_opts *w) IX_MUST_CHECK;

#endif
