/* cmd_view.c - iritx view FILE... -o PAGE: one page that shows objects in a
 * browser, with nothing to be fetched from anywhere.
 *
 * The page holds the viewer (an X3D browser, see docs/dependencies.md), the
 * objects as X3D, each in a Switch, and what the objects are as its caption. */
#define _POSIX_C_SOURCE 200809L
#include <limits.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "app/cmd.h"
#include "app/summary.h"
#include "io/scene.h"

/* --- the viewer
 * --------------------------------------------------------------------------
 */

/* Appends the script that make web prepared, found from the program's place. */
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
    return IX_FAIL(ctx, IX_EUNABLE,
                   "the viewer iritx_view.js is not there: \"make web\" makes "
                   "it from the npm package x_ite (npm must be installed)");
}

/* --- parts of the page
 * ------------------------------------------------------------------- */

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

static ix_status add_caption(ix_buf *b, const ix_obj *o, int i)
{
    ix_buf text;
    ix_status st;

    ix__buf_init(&text, b->ctx);
    st = summary_add(&text, o, 0);
    if (st == IX_OK)
        st = ix__buf_check(&text);
    if (st == IX_OK) {
        ix__buf_printf(b,
                       "<label><input type=\"checkbox\" checked "
                       "data-object=\"%d\"><pre>",
                       i);
        add_escaped(b, text.data);
        ix__buf_puts(b, "</pre></label>\n");
    }
    ix__buf_free(&text);
    return st;
}

/* --- the page
 * -----------------------------------------------------------------------------
 */

static const char page_head[] =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src data: "
    "blob: 'unsafe-inline' 'unsafe-eval'\">\n"
    "<title>iritx</title><style>\n"
    "html,body{margin:0;height:100%;font:13px sans-serif}\n"
    "body{display:flex}\n"
    "x3d-canvas{flex:1;height:100%}\n"
    "#objects{max-width:28em;overflow:auto;padding:0 8px;background:#eee}\n"
    "label{display:flex;align-items:flex-start}\n"
    "pre{margin:3px;white-space:pre-wrap}\n"
    "</style>\n<script>\n";

static const char page_canvas[] =
    "</script></head><body>\n<x3d-canvas id=\"view\" splashScreen=\"false\" "
    "contextMenu=\"false\">"
    "</x3d-canvas>\n<div id=\"objects\">\n"
    "<p>Drag: orbit. Wheel: zoom. "
    "<button id=\"all\">Show all</button></p>\n"
    "<label><input type=\"checkbox\" id=\"nets\"><pre>control nets</pre>"
    "</label><hr>\n";

static const char page_scene[] =
    "</div>\n<script type=\"text/plain\" id=\"scene\">"
    "<X3D profile=\"Interchange\" version=\"4.0\"><head>"
    "<component name=\"NURBS\" level=\"4\"/></head><Scene>\n"
    "<NavigationInfo type='\"EXAMINE\" \"ANY\"'/>"
    "<Background skyColor=\"0.8 0.9 1\"/>\n";

static const char page_end[] =
    "</Scene></X3D></script>\n<script>\n"
    "const browser = document.getElementById('view').browser;\n"
    "const nets = document.getElementById('nets');\n"
    "const boxes = [...document.querySelectorAll('[data-object]')];\n"
    "function choose(name, on) {\n"
    "  browser.currentScene.getNamedNode(name).whichChoice = on ? 0 : -1;\n"
    "}\n"
    "function update() {\n"
    "  for (const box of boxes) {\n"
    "    choose('iritx_o' + box.dataset.object, box.checked);\n"
    "    choose('iritx_n' + box.dataset.object, box.checked && nets.checked);\n"
    "  }\n"
    "}\n"
    "async function start() {\n"
    "  const text = document.getElementById('scene').textContent;\n"
    "  await browser.replaceWorld(await browser.createX3DFromString(text));\n"
    "  for (const box of [nets, ...boxes]) box.onchange = update;\n"
    "  document.getElementById('all').onclick = () => browser.viewAll();\n"
    "  document.title = 'iritx: ready';\n"
    "}\n"
    "start();\n</script></body></html>\n";

/* Looks along -z at the box of all objects, from where its sphere fits into
 * X3D's field of view of pi / 4. */
static void add_viewpoint(ix_buf *b, const ix_obj *list)
{
    double box[6], mid[3], size = 0;

    if (ix__obj_bbox(b->ctx, list, box) != IX_OK)
        return;
    for (int k = 0; k < 3; k++) {
        mid[k] = (box[2 * k] + box[2 * k + 1]) / 2;
        size = hypot(size, box[2 * k + 1] - box[2 * k]);
    }
    if (!(size > 0 && isfinite(size)))
        return;
    ix__buf_printf(b, "<Viewpoint position=\"%.9g %.9g %.9g\" ", mid[0], mid[1],
                   mid[2] + 1.4 * size);
    ix__buf_printf(b, "centerOfRotation=\"%.9g %.9g %.9g\"/>\n", mid[0], mid[1],
                   mid[2]);
}

/* The elements of list, one each. */
static ix_status make_page(ix_buf *b, const ix_obj *list)
{
    ix_buf viewer;
    ix_status st;

    ix__buf_init(&viewer, b->ctx);
    st = add_viewer(b->ctx, &viewer);
    ix__buf_puts(b, page_head);
    if (st == IX_OK)
        ix__buf_add(b, viewer.data, viewer.len);
    ix__buf_free(&viewer);
    ix__buf_puts(b, page_canvas);
    for (int i = 0; st == IX_OK && i < list->u.list.n; i++)
        st = add_caption(b, list->u.list.item[i], i);
    ix__buf_puts(b, page_scene);
    add_viewpoint(b, list);
    for (int i = 0; st == IX_OK && i < list->u.list.n; i++)
        st = add_object(b, list->u.list.item[i], i);
    ix__buf_puts(b, page_end);
    return st == IX_OK ? ix__buf_check(b) : st;
}

/* --- the command
 * ---------------------------------------------------------------------- */

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
    ix_buf page;
    ix_status st;

    ix__buf_init(&page, ctx);
    st = make_page(&page, list);
    if (st == IX_OK)
        st = ix__file_write(ctx, out, page.data, page.len);
    ix__buf_free(&page);
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
