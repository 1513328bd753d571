/* gz.h - gzip in memory, by zlib. */
#ifndef IO_GZ_H
#define IO_GZ_H

#include "base/buf.h"

/* What inflating stops at: bytes, and the ratio of output to input once
 * there are IX_GZ_FREE bytes of output. */
#define IX_GZ_MAX   ((size_t)1 << 30)
#define IX_GZ_FREE  ((size_t)16 << 20)
#define IX_GZ_RATIO 200

bool ix__gz_is(const char *data, size_t n); /* by the first two bytes */

/* Appends the contents of all members to the empty *out, each with its checksum
 * and length verified. Err IX_EPARSE (message begins with name) cut short,
 * corrupt, garbage behind it, over a limit; IX_ENOMEM; IX_ECANCEL. */
ix_status ix__gz_inflate(ix_ctx *ctx, const char *name, const char *data,
                         size_t n, ix_buf *out) IX_MUST_CHECK;
/* Appends one member; the bytes depend on the data only. */
ix_status ix__gz_deflate(ix_ctx *ctx, const char *data, size_t n,
                         ix_buf *out) IX_MUST_CHECK;

#endif
