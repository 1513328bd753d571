/* gz.h - gzip, piece by piece, by zlib. */
#ifndef IO_GZ_H
#define IO_GZ_H

#include "base/buf.h"

/* What inflating stops at: bytes, and the ratio of output to input once
 * there are IX_GZ_FREE bytes of output. */
#define IX_GZ_MAX   ((size_t)1 << 30)
#define IX_GZ_FREE  ((size_t)16 << 20)
#define IX_GZ_RATIO 200

bool ix__gz_is(const char *data, size_t n); /* by the first two bytes */

/* The most that packed bytes may inflate to. */
size_t ix__gz_most(size_t packed);

/* --- inflating ---------------------------------------------------------- */
/* Fills to[room]; fewer bytes (*n) at the end only. */
typedef ix_status (*ix__fill_fn)(void *arg, char *to, size_t room, size_t *n);

typedef struct ix__gunzip ix__gunzip;

/* Packed bytes come from fill; name is for messages and stays the caller's. */
ix_status ix__gunzip_open(ix_ctx *ctx, const char *name, ix__fill_fn fill,
                          void *arg, ix__gunzip **out) IX_MUST_CHECK;
/* As ix__fill_fn: the contents of all members one behind the other, each with
 * its checksum and length verified before *n < room is returned. Err IX_EPARSE
 * (message begins with name) cut short, corrupt, garbage behind it, over a
 * limit; IX_ENOMEM; IX_ECANCEL; what fill fails with. */
ix_status ix__gunzip_read(ix__gunzip *g, char *to, size_t room,
                          size_t *n) IX_MUST_CHECK;
void ix__gunzip_close(ix__gunzip *g); /* g may be NULL */

/* --- deflating ---------------------------------------------------------- */
typedef struct ix__gzip ix__gzip;

/* One member goes to sink. Its bytes depend on the data, and on how they are
 * divided into pieces. */
ix_status ix__gzip_open(ix_ctx *ctx, ix__sink_fn sink, void *arg,
                        ix__gzip **out) IX_MUST_CHECK;
ix_status ix__gzip_put(ix__gzip *g, const char *s, size_t n) IX_MUST_CHECK;
ix_status ix__gzip_finish(ix__gzip *g) IX_MUST_CHECK; /* once, at the end */
void ix__gzip_close(ix__gzip *g);                     /* g may be NULL */

#endif
