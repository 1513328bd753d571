/* cmd_validate.c - iritx validate FILE...: XML files are read, which checks
 * what no schema can state and has the better messages, then held against the
 * schema, so that other programs can rely on it. */
#include "app/cmd.h"
#include "io/input.h"

static ix_status validate_from(ix_ctx *ctx, ix__input *s)
{
    ix__input *again;
    ix_obj *o;
    ix_status st;

    IX_TRY(ix__xml_read_from(s, &o));
    ix__obj_unref(ctx, o);
    IX_TRY(ix__input_again(s, &again));
    st = ix__xml_validate(again);
    ix__input_close(again);
    return st;
}

static ix_status validate_file(ix_ctx *ctx, const char *name)
{
    ix__input *s;
    ix_status st;

    IX_TRY(ix__input_file(ctx, name, &s));
    st = validate_from(ctx, s);
    ix__input_close(s);
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
