/* cmd_convert.c - iritx convert IN OUT: one file format into another. */
#include "app/cmd.h"

int cmd_convert(ix_ctx *ctx, int argc, char **argv)
{
    const ix_write_opts exact = {.file = true};
    ix_obj *o;
    ix_status st;

    if (argc != 2)
        return cmd_wrong_usage("convert");
    st = ix__load(ctx, argv[0], NULL, &o);
    if (st == IX_OK)
        st = ix__save(ctx, argv[1], o, &exact);
    ix__obj_unref(ctx, o);
    return st == IX_OK ? 0 : cmd_complain(ctx);
}
