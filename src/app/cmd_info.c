/* cmd_info.c - iritx info FILE...: the objects of files as a tree. */
#include "app/cmd.h"
#include "app/summary.h"

static ix_status put_file(ix_ctx *ctx, const char *name)
{
    ix_buf resolved, text;
    ix_obj *o;
    ix_status st;

    ix__buf_init(&resolved, ctx);
    ix__buf_init(&text, ctx);
    st = ix__load(ctx, name, &resolved, &o);
    if (st == IX_OK) {
        ix__buf_printf(&text, "%s\n", resolved.data);
        st = summary_add(&text, o, 1);
    }
    if (st == IX_OK)
        st = ix__buf_check(&text);
    if (st == IX_OK)
        (void)fputs(text.data, stdout);
    ix__obj_unref(ctx, o);
    ix__buf_free(&resolved);
    ix__buf_free(&text);
    return st;
}

int cmd_info(ix_ctx *ctx, int argc, char **argv)
{
    int rc = 0;

    if (argc == 0)
        return cmd_wrong_usage("info");
    for (int i = 0; i < argc; i++)
        if (put_file(ctx, argv[i]) != IX_OK)
            rc = cmd_complain(ctx);
    return rc;
}
