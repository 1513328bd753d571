/* cmd_validate.c - iritx validate FILE...: XML files are read, which checks
 * what no schema can state and has the better messages, then held against the
 * schema, so that other programs can rely on it. */
#include "app/cmd.h"

static ix_status validate_text(ix_ctx *ctx, const char *name,
                               const ix_buf *text)
{
    ix_obj *o;

    IX_TRY(ix__xml_read(ctx, name, text->data, text->len, &o));
    ix__obj_unref(ctx, o);
    return ix__xml_validate(ctx, name, text->data, text->len);
}

static ix_status validate_file(ix_ctx *ctx, const char *name)
{
    ix_buf text;
    ix_status st;

    IX_TRY(ix__file_read(ctx, name, &text));
    st = validate_text(ctx, name, &text);
    ix__buf_free(&text);
    return st;
}

int cmd_validate(ix_ctx *ctx, int argc, char **argv)
{
    int rc = 0;

    if (argc == 0)
        return cmd_wrong_usage("validate");
    for (int i = 0; i < argc; i++) {
        if (validate_file(ctx, argv[i]) == IX_OK)
            (void)printf("%s: valid\n", argv[i]);
        else
            rc = cmd_complain(ctx);
    }
    return rc;
}
