/* file_impl.h - what reading and writing files share. */
#ifndef IO_FILE_IMPL_H
#define IO_FILE_IMPL_H

#include <sys/stat.h>

#include "io/io.h"

/* IX_EIO, "x.itd: cannot read: No such file or directory", from errno. */
ix_status ix__file_failed(ix_ctx *ctx, const char *what, const char *name);
/* Err IX_EIO it is a directory, a FIFO, ... */
ix_status ix__file_regular(ix_ctx *ctx, const char *what, const char *name,
                           const struct stat *sb) IX_MUST_CHECK;

#endif
