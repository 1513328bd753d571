/* x3d_write.c - a scene in X3D 4.0, XML encoding (docs/x3d.md): lists as
 * groups, polygons as indexed sets, freeforms by io/x3d_nurbs.c. Values that
 * are no geometry are left out. */
#include <string.h>

#include "io/shapes.h"
#include "io/x3d_impl.h"
#include "object/walk.h"

/* --- polygons --------------------------------------------------------- */

/* Polygons of one kind, in a row. */
typedef struct {
    ix_poly_kind kind;
    int n;
    const ix_polygon *pg;
} run;

static bool has_colours(const run *r)
{
    for (int i = 0; i < r->n; i++)
        for (int k = 0; k < r->pg[i].n; k++)
            for (const ix_attr *a = r->pg[i].v[k].attrs; a; a = a->next)
                if (ix__name_cmp(a->name, "rgb") == 0 ||
                    ix__name_cmp(a->name, "color") == 0)
                    return true;
    return false;
}

/* The numbers of vertices, "3 4 3". */
static void put_counts(ix__x3d *w, const char *name, const run *r)
{
    ix__buf_printf(w->b, " %s=\"", name);
    for (int i = 0; i < r->n; i++)
        ix__buf_printf(w->b, i ? " %d" : "%d", r->pg[i].n);
    ix__buf_putc(w->b, '"');
}

static void put_indices(ix__x3d *w, const run *r)
{
    int at = 0;

    ix__buf_puts(w->b, " coordIndex=\"");
    for (int i = 0; i < r->n; i++) {
        for (int k = 0; k < r->pg[i].n; k++)
            ix__buf_printf(w->b, "%d ", at++);
        ix__buf_puts(w->b, i + 1 < r->n ? "-1, " : "-1");
    }
    ix__buf_putc(w->b, '"');
}

static ix_status put_vertices(ix__x3d *w, const run *r)
{
    const char *gap = "";

    ix__x3d_indent(w);
    ix__buf_puts(w->b, "<Coordinate point=\"");
    for (int i = 0; i < r->n; i++) {
        for (int k = 0; k < r->pg[i].n; k++, gap = ", ") {
            ix__buf_puts(w->b, gap);
            for (int c = 0; c < 3; c++) {
                ix__x3d_num(w, r->pg[i].v[k].p[c]);
                if (c < 2)
                    ix__buf_putc(w->b, ' ');
            }
        }
        IX_TRY(ix__x3d_check(w));
    }
    ix__buf_puts(w->b, "\"/>\n");
    return IX_OK;
}

static void put_colours(ix__x3d *w, const ix__x3d_look *look, const run *r)
{
    const char *gap = "";

    ix__x3d_indent(w);
    ix__buf_puts(w->b, "<Color color=\"");
    for (int i = 0; i < r->n; i++) {
        ix__x3d_look own = ix__x3d_look_of(r->pg[i].attrs, *look);

        for (int k = 0; k < r->pg[i].n; k++, gap = ", ") {
            ix__x3d_look c = ix__x3d_look_of(r->pg[i].v[k].attrs, own);

            ix__buf_puts(w->b, gap);
            for (int a = 0; a < 3; a++) {
                ix__x3d_num(w, c.rgb[a]);
                if (a < 2)
                    ix__buf_putc(w->b, ' ');
            }
        }
    }
    ix__buf_puts(w->b, "\"/>\n");
}

static const char *open_node(ix__x3d *w, const run *r)
{
    static const char *const nodes[] = {"IndexedFaceSet", "LineSet", "PointSet",
                                        "TriangleStripSet"};

    ix__x3d_indent(w);
    ix__buf_printf(w->b, "<%s", nodes[r->kind]);
    if (r->kind == IX_POLYGON) {
        ix__buf_puts(w->b, " solid=\"false\" convex=\"false\"");
        put_indices(w, r);
    } else if (r->kind == IX_POLYLINE) {
        put_counts(w, "vertexCount", r);
    } else if (r->kind == IX_POLYSTRIP) {
        ix__buf_puts(w->b, " solid=\"false\"");
        put_counts(w, "stripCount", r);
    }
    ix__buf_puts(w->b, ">\n");
    w->depth++;
    return nodes[r->kind];
}

static ix_status put_run(ix__x3d *w, const char *name, ix__x3d_look look,
                         const run *r)
{
    bool shines = r->kind == IX_POLYLINE || r->kind == IX_POINTLIST;
    const char *node;

    if (r->n == 1)
        look = ix__x3d_look_of(r->pg->attrs, look);
    IX_TRY(ix__x3d_shape(w, name, &look, shines));
    node = open_node(w, r);
    if (has_colours(r))
        put_colours(w, &look, r);
    IX_TRY(put_vertices(w, r));
    w->depth--;
    ix__x3d_line(w, "</%s>", node);
    ix__x3d_end_shape(w);
    return IX_OK;
}

/* What a node cannot show: a line of one point, a face of two. */
static bool is_shown(const ix_polygon *pg)
{
    static const int least[] = {3, 2, 1, 3};

    return pg->n >= least[pg->kind];
}

/* Polygons with attributes of their own stand alone, for their colour. */
ix_status ix__x3d_polys(ix__x3d *w, const char *name, const ix__x3d_look *look,
                        const ix_poly *p)
{
    run r = {.kind = IX_POLYGON};

    for (int i = 0; i < p->n; i += r.n) {
        r = (run){p->poly[i].kind, 1, &p->poly[i]};
        if (!is_shown(r.pg))
            continue;
        while (i + r.n < p->n && !r.pg->attrs && r.pg[r.n].kind == r.kind &&
               !r.pg[r.n].attrs && is_shown(&r.pg[r.n]))
            r.n++;
        IX_TRY(put_run(w, name, *look, &r));
    }
    return IX_OK;
}

/* --- points ----------------------------------------------------------- */

static ix_status put_point(ix__x3d *w, const ix_obj *o,
                           const ix__x3d_look *look)
{
    double p[3] = {0, 0, 0}, weight = 1;

    if (o->type == IX_OBJ_POINT) {
        memcpy(p, o->u.pt, sizeof p);
    } else {
        const ix_ctlpt *c = o->u.ctlpt;

        weight = c->rational ? c->v[0] : 1;
        for (int k = 0; k < 3 && k < c->ncoords; k++)
            p[k] = c->v[k + (c->rational ? 1 : 0)] / weight;
    }
    if (weight == 0)
        return IX_OK; /* at infinity */
    IX_TRY(ix__x3d_shape(w, o->name, look, true));
    ix__x3d_indent(w);
    ix__buf_puts(w->b, "<PointSet><Coordinate");
    ix__x3d_rows(w, "point", 1, 3, p, 1);
    ix__buf_puts(w->b, "/></PointSet>\n");
    ix__x3d_end_shape(w);
    return IX_OK;
}

/* --- objects ---------------------------------------------------------- */

static ix_status put_item(ix__x3d *w, const ix_obj *o, int i,
                          const ix__x3d_look *look)
{
    const void *item = ix__seq_item(o, i);

    switch (o->type) {
    case IX_OBJ_TRIMSRF:
        return ix__x3d_trimsrf(w, o->name, look, item);
    case IX_OBJ_MODEL:
        return ix__x3d_model(w, o->name, look, item);
    case IX_OBJ_TRISRF:
        ix__note(w->b->ctx,
                 "warning: %.60s is not in the X3D file: a triangular surface",
                 o->name ? o->name : "an object");
        return IX_OK;
    default:
        return ix__x3d_mv(w, o->name, look, item);
    }
}

static ix_status put_object(ix__x3d *w, const ix_obj *o, ix__x3d_look look)
{
    look = ix__x3d_look_of(o->attrs, look);
    if (o->type == IX_OBJ_POLY)
        return ix__x3d_polys(w, o->name, &look, o->u.poly);
    if (o->type == IX_OBJ_POINT || o->type == IX_OBJ_CTLPT)
        return put_point(w, o, &look);
    if (o->type == IX_OBJ_INSTANCE)
        ix__note(w->b->ctx,
                 "warning: %.60s is not in the X3D file: an instance",
                 o->name ? o->name : "an object");
    for (int i = 0; i < ix__seq_count(o); i++)
        IX_TRY(put_item(w, o, i, &look));
    if (o->type != IX_OBJ_LIST)
        return IX_OK;
    ix__x3d_indent(w);
    ix__buf_puts(w->b, "<Group");
    IX_TRY(ix__x3d_def(w, o->name));
    ix__buf_puts(w->b, ">\n");
    w->depth++;
    for (int i = 0; i < o->u.list.n; i++)
        IX_TRY(put_object(w, o->u.list.item[i], look));
    w->depth--;
    ix__x3d_line(w, "</Group>");
    return ix__x3d_check(w);
}

/* Is a leaf geometry that X3D might show? */
static ix_status look_for_shape(void *arg, const ix_obj *o)
{
    bool *any = arg;

    *any = *any || ix__seq_count(o) > 0 || o->type == IX_OBJ_POLY ||
           o->type == IX_OBJ_POINT || o->type == IX_OBJ_CTLPT;
    return IX_OK;
}

static ix_status put_scene(ix__x3d *w, const ix_obj *o)
{
    const ix__x3d_look plain = {.rgb = {0.8, 0.8, 0.8}};
    bool any = false;

    IX_TRY(ix__walk_leaves(o, look_for_shape, &any));
    if (!any)
        ix__note(w->b->ctx, "warning: there is nothing to be shown in the X3D "
                            "file: no curve, surface, polygon or point");

    ix__buf_puts(w->b, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                       "<X3D profile=\"Interchange\" version=\"4.0\">\n"
                       "<head><component name=\"NURBS\" level=\"4\"/>"
                       "<meta name=\"generator\" content=\"iritx\"/></head>\n"
                       "<Scene>\n");
    IX_TRY(put_object(w, o, plain));
    ix__buf_puts(w->b, "</Scene>\n</X3D>\n");
    return ix__x3d_check(w);
}

ix_status ix__x3d_write(ix_buf *b, const ix_obj *o, const ix_write_opts *opts)
{
    ix__x3d w = {
        .b = b, .start = ix__buf_total(b), .tol = opts ? opts->tol : 0};
    ix_status st;

    IX_TRY(ix__obj_check_size(b->ctx, o, IX_MAX_DEPTH, IX_MAX_TEXT));
    if (w.tol == 0)
        IX_TRY(ix__shape_tol(b->ctx, o, &w.tol));
    st = put_scene(&w, o);
    ix__free(b->ctx, w.seen, w.cap * sizeof *w.seen);
    return st;
}
