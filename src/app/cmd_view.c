/* cmd_view.c - iritx view FILE... -o PAGE: one page that shows objects in a
 * browser, with nothing to be fetched from anywhere.
 *
 * The page holds the viewer (an X3D browser, see docs/dependencies.md), the
 * objects as X3D, each in a Switch, and what the objects are as its caption. */
#define _POSIX_C_SOURCE 200809L
#include <limits.h>
#include <string.h>
#include <unistd.h>

#include "app/cmd.h"
#include "app/summary.h"
#include "app/view_camera.h"
#include "app/view_page.h"
#include "io/scene.h"
#include "io/shapes.h"

/* --- the viewer -------------------------------------------------------- */

/* Appends the script that the build prepared, found from the program's place.
 */
static ix_status add_viewer(ix_ctx *ctx, ix_buf *b)
{
    static const char *const places[] = {"../share/iritx/", "web/", "../web/"};
    char path[PATH_MAX + 64];
    ssize_t n = readlink("/proc/self/exe", path, PATH_MAX - 1);
    char *name;

    path[n > 0 ? n : 0] = '\0';
    name = strrchr(path, '/');
    for (size_t i = 0; name && i < sizeof places / sizeof *places; i++) {
        (void)snprintf(name + 1, 64, "%siritx_view.js", places[i]);
        if (access(path, R_OK) == 0)
            return ix__file_read(ctx, path, b);
    }
    return IX_FAIL(
        ctx, IX_EUNABLE,
        "the viewer iritx_view.js is not there: \"make web\" fetches "
        "it, and \"make install\" puts it beside the program");
}

/* --- parts of the page ------------------------------------------------- */

static void add_escaped(ix_buf *b, const char *s)
{
    for (; *s; s++) {
        if (*s == '<')
            ix__buf_puts(b, "&lt;");
        else if (*s == '>')
            ix__buf_puts(b, "&gt;");
        else if (*s == '&')
            ix__buf_puts(b, "&amp;");
        else
            ix__buf_putc(b, *s);
    }
}

/* What the object's X3D file has between its Scene tags. */
static ix_status add_shapes(ix_buf *b, const ix_obj *o)
{
    ix_buf file;
    const char *from, *to;
    ix_status st;

    ix__buf_init(&file, b->ctx);
    st = ix__x3d_write(&file, o, &(ix_write_opts){.file = true});
    if (st == IX_OK)
        st = ix__buf_check(&file);
    from = st == IX_OK ? strstr(file.data, "<Scene>") : NULL;
    to = from ? strstr(from, "</Scene>") : NULL;
    if (to)
        ix__buf_add(b, from + 7, (size_t)(to - from) - 7);
    ix__buf_free(&file);
    return st;
}

static void add_path(ix_buf *b, const ix_scene *s, const ix_path *p)
{
    ix__buf_printf(b, "<Shape><Appearance><Material emissiveColor=\"");
    ix__buf_printf(
        b, "0.6 0.6 0.6\"/></Appearance><LineSet vertexCount=\"%zu\">", p->n);
    ix__buf_puts(b, "<CoordinateDouble point=\"");
    for (size_t i = p->first; i < p->first + p->n; i++) {
        for (int k = 0; k < 3; k++) {
            ix__buf_num(b, s->pts[i][k]);
            ix__buf_putc(b, k < 2 ? ' ' : ',');
        }
    }
    ix__buf_puts(b, "\"/></LineSet></Shape>\n");
}

static ix_status add_net(ix_buf *b, const ix_obj *o)
{
    const ix_scene_opts opts = {.net = true};
    ix_mark mk = ix__scratch_mark(b->ctx);
    ix_scene s;
    ix_status st = ix__scene_build(b->ctx, o, &opts, &s);

    for (size_t i = 0; st == IX_OK && i < s.npaths; i++)
        if (s.path[i].kind == IX_PATH_NET && s.path[i].n > 1)
            add_path(b, &s, &s.path[i]);
    ix__scratch_release(b->ctx, mk);
    return st;
}

static ix_status add_object(ix_buf *b, const ix_obj *o, int i)
{
    ix__buf_printf(b, "<Switch DEF=\"iritx_o%d\" whichChoice=\"0\"><Group>", i);
    IX_TRY(add_shapes(b, o));
    ix__buf_printf(b,
                   "</Group></Switch>\n<Switch DEF=\"iritx_n%d\" "
                   "whichChoice=\"-1\"><Group>",
                   i);
    IX_TRY(add_net(b, o));
    ix__buf_puts(b, "</Group></Switch>\n");
    return ix__buf_check(b);
}

/* Type and name, up to the colon, stand out. */
static void add_heading(ix_buf *b, char *s)
{
    char *colon = strstr(s, ": ");

    if (colon) {
        *colon = '\0';
        ix__buf_puts(b, "<b>");
        add_escaped(b, s);
        ix__buf_puts(b, "</b>: ");
        s = colon + 2;
    }
    add_escaped(b, s);
}

/* The caption's box, and the colour that the object has. */
static void add_box(ix_buf *b, const ix_obj *o, int i)
{
    double rgb[3] = {0.5, 0.5, 0.5};

    (void)ix__shape_color(o, rgb);
    ix__buf_printf(b,
                   "<label class=\"object\"><input type=\"checkbox\" checked "
                   "data-object=\"%d\"><span class=\"swatch\" "
                   "style=\"background:rgb(%d,%d,%d)\"></span><pre>",
                   i, (int)(255 * rgb[0]), (int)(255 * rgb[1]),
                   (int)(255 * rgb[2]));
}

static ix_status add_caption(ix_buf *b, const ix_obj *o, int i)
{
    ix_buf text;
    ix_status st;

    ix__buf_init(&text, b->ctx);
    st = summary_add(&text, o, 0);
    if (st == IX_OK)
        st = ix__buf_check(&text);
    if (st == IX_OK) {
        add_box(b, o, i);
        add_heading(b, text.data);
        ix__buf_puts(b, "</pre></label>\n");
    }
    ix__buf_free(&text);
    return st;
}

/* --- the page ---------------------------------------------------------- */

/* The elements of list, one each. */
static ix_status make_page(ix_buf *b, const ix_obj *list)
{
    ix_buf viewer;
    ix_status st;

    ix__buf_init(&viewer, b->ctx);
    st = add_viewer(b->ctx, &viewer);
    ix__buf_puts(b, view_page_head);
    if (st == IX_OK)
        ix__buf_add(b, viewer.data, viewer.len);
    ix__buf_free(&viewer);
    ix__buf_puts(b, view_page_body);
    for (int i = 0; st == IX_OK && i < list->u.list.n; i++)
        st = add_caption(b, list->u.list.item[i], i);
    ix__buf_puts(b, view_page_scene);
    view_camera_begin(b, list);
    for (int i = 0; st == IX_OK && i < list->u.list.n; i++)
        st = add_object(b, list->u.list.item[i], i);
    view_camera_end(b);
    ix__buf_puts(b, view_page_end);
    return st == IX_OK ? ix__buf_check(b) : st;
}

/* --- the command ------------------------------------------------------- */

/* The file's object, or the elements of its list, to the end of list. */
static ix_status add_file(ix_ctx *ctx, const char *name, ix_obj *list)
{
    ix_obj *o;
    ix_status st = ix__load(ctx, name, NULL, &o);

    if (st == IX_OK && o->type != IX_OBJ_LIST)
        st = ix__obj_append(ctx, list, o);
    for (int i = 0; st == IX_OK && o->type == IX_OBJ_LIST && i < o->u.list.n;
         i++)
        st = ix__obj_append(ctx, list, o->u.list.item[i]);
    ix__obj_unref(ctx, o);
    return st;
}

static int write_page(ix_ctx *ctx, const ix_obj *list, const char *out)
{
    ix__outfile *f;
    ix_status st = ix__outfile_open(ctx, out, &f);

    if (st == IX_OK)
        st = ix__outfile_close(f, make_page(ix__outfile_text(f), list));
    return st == IX_OK ? 0 : cmd_complain(ctx);
}

int cmd_view(ix_ctx *ctx, int argc, char **argv)
{
    const char *out = NULL;
    ix_obj *list = ix__obj_list(ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;
    int rc;

    for (int i = 0; st == IX_OK && i < argc; i++) {
        if (strcmp(argv[i], "-o") == 0 && i + 1 < argc)
            out = argv[++i];
        else
            st = add_file(ctx, argv[i], list);
    }
    if (st != IX_OK)
        rc = cmd_complain(ctx);
    else if (!out || list->u.list.n == 0)
        rc = cmd_wrong_usage("view");
    else
        rc = write_page(ctx, list, out);
    ix__obj_unref(ctx, list);
    return rc;
}
