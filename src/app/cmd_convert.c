/* cmd_convert.c - iritx convert [--tol X] IN OUT: one file format into
 * another. */
#include <string.h>

#include "app/cmd.h"

/* "--tol X": a positive number. */
static bool read_tol(const char *s, double *tol)
{
    const char *end = s + strlen(s);

    return ix_num_parse(s, end, tol) == end && *tol > 0;
}

/* "part.dxf" would become "part.dxf.itd". */
static bool check_name(const char *name)
{
    const char *slash = strrchr(name, '/');

    if (ix__save_knows(name) || !strchr(slash ? slash : name, '.'))
        return true;
    (void)fprintf(stderr,
                  "iritx: error: %s: no format has this suffix; there are "
                  ".itd .ibd .xml .x3d .stl .bstl .obj .step .svg .png .pdf\n",
                  name);
    return false;
}

int cmd_convert(ix_ctx *ctx, int argc, char **argv)
{
    ix_write_opts exact = {.file = true};
    ix_obj *o;
    ix_status st;

    if (argc > 1 && strcmp(argv[0], "--tol") == 0) {
        if (!read_tol(argv[1], &exact.tol)) {
            (void)fprintf(stderr,
                          "iritx convert: a tolerance is a positive number, "
                          "not \"%s\"\n",
                          argv[1]);
            return cmd_wrong_usage("convert");
        }
        argc -= 2;
        argv += 2;
    }
    if (argc != 2)
        return cmd_wrong_usage("convert");
    if (!check_name(argv[1]))
        return 1;
    st = ix__load(ctx, argv[0], NULL, &o);
    if (st == IX_OK)
        st = ix__save(ctx, argv[1], o, &exact);
    ix__obj_unref(ctx, o);
    return st == IX_OK ? 0 : cmd_complain(ctx);
}
