/* cmd_draw.c - iritx draw FILE... -o PICTURE: pictures of geometry. */
#include <stdlib.h>
#include <string.h>

#include "app/cmd.h"
#include "app/picture.h"
#include "io/scene.h"

typedef struct {
    draw_opts draw;
    const char *out;
    int nin;
    char **in; /* the arguments that are files, moved to the front */
} options;

static int bad(const char *what, const char *arg)
{
    (void)fprintf(stderr, "iritx draw: %s \"%s\"\n", what, arg);
    return cmd_wrong_usage("draw");
}

static bool read_size(const char *s, draw_opts *d)
{
    char *end;
    long w = strtol(s, &end, 10), h;

    if (*end != 'x')
        return false;
    h = strtol(end + 1, &end, 10);
    if (*end || w < 16 || h < 16 || w > 20000 || h > 20000)
        return false;
    d->width = (int)w;
    d->height = (int)h;
    return true;
}

/* A name, or 16 numbers separated by commas or blanks. */
static bool read_view(const char *s, draw_opts *d)
{
    const char *end = s + strlen(s);

    d->has_view = true;
    if (ix__view_named(s, d->view))
        return true;
    for (int i = 0; i < 16; i++) {
        while (*s == ' ' || *s == ',')
            s++;
        s = ix_num_parse(s, end, &d->view[i]);
        if (!s)
            return false;
    }
    return s == end;
}

static bool read_format(const char *name, draw_format *f)
{
    const char *dot = strrchr(name, '.');

    if (dot && strcmp(dot, ".svg") == 0)
        *f = DRAW_SVG;
    else if (dot && strcmp(dot, ".png") == 0)
        *f = DRAW_PNG;
    else if (dot && strcmp(dot, ".pdf") == 0)
        *f = DRAW_PDF;
    else
        return false;
    return true;
}

/* 0, or the exit code. */
static int read_flag(const char *a, draw_opts *d)
{
    if (strcmp(a, "--net") == 0)
        d->net = true;
    else if (strcmp(a, "--knots") == 0)
        d->knots = true;
    else if (strcmp(a, "--shade") == 0)
        d->shade = true;
    else if (strcmp(a, "--fit") == 0)
        d->fit = true;
    else if (strcmp(a, "--no-axes") == 0)
        d->no_axes = true;
    else
        return bad("unknown option", a);
    return 0;
}

static int read_options(int argc, char **argv, options *o)
{
    for (int i = 0; i < argc; i++) {
        const char *a = argv[i], *v = i + 1 < argc ? argv[i + 1] : NULL;

        if (a[0] != '-' || !a[1]) {
            o->in[o->nin++] = argv[i];
        } else if (v && strcmp(a, "-o") == 0) {
            o->out = argv[++i];
        } else if (v && strcmp(a, "--size") == 0) {
            if (!read_size(argv[++i], &o->draw))
                return bad("a size is WIDTHxHEIGHT (16 to 20000), not", v);
        } else if (v && strcmp(a, "--view") == 0) {
            if (!read_view(argv[++i], &o->draw))
                return bad("a view is top, bottom, front, back, right, left, "
                           "iso or 16 numbers, not",
                           v);
        } else {
            int rc = read_flag(a, &o->draw);

            if (rc)
                return rc;
        }
    }
    if (o->nin == 0 || !o->out)
        return cmd_wrong_usage("draw");
    if (!read_format(o->out, &o->draw.format))
        return bad("a picture ends in .svg, .png or .pdf, not", o->out);
    return 0;
}

static ix_status load_all(ix_ctx *ctx, const options *o, ix_obj *list)
{
    for (int i = 0; i < o->nin; i++) {
        ix_obj *one;
        ix_status st;

        IX_TRY(ix__load(ctx, o->in[i], NULL, &one));
        st = ix__obj_append(ctx, list, one);
        ix__obj_unref(ctx, one);
        IX_TRY(st);
    }
    return IX_OK;
}

static ix_status draw_files(ix_ctx *ctx, const options *o)
{
    ix_obj *list = ix__obj_list(ctx);
    ix_status st;
    ix_buf b;

    if (!list)
        return IX_ENOMEM;
    ix__buf_init(&b, ctx);
    st = load_all(ctx, o, list);
    if (st == IX_OK)
        st = picture_draw(&b, list, &o->draw);
    if (st == IX_OK)
        st = ix__file_write(ctx, o->out, b.data, b.len);
    ix__buf_free(&b);
    ix__obj_unref(ctx, list);
    return st;
}

int cmd_draw(ix_ctx *ctx, int argc, char **argv)
{
    options o = {.in = argv};
    int rc = read_options(argc, argv, &o);

    if (rc)
        return rc;
    return draw_files(ctx, &o) == IX_OK ? 0 : cmd_complain(ctx);
}
