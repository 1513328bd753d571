/* file_api.c - the public face of loading and saving (iritx/file.h). */
#include "iritx/file.h"

#include "io/io.h"

ix_status ix_load(ix_ctx *ctx, const char *name, ix_obj **out)
{
    return ix__load(ctx, name, NULL, out);
}

ix_status ix_save(ix_ctx *ctx, const char *name, const ix_obj *o, double tol)
{
    const ix_write_opts w = {.file = true, .tol = tol};

    return ix__save(ctx, name, o, &w);
}
