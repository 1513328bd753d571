/* itd_write_brep.c - polygons, trimmed surfaces and models as text. */
#include <math.h>

#include "io/itd_write_impl.h"

/* --- polygons --------------------------------------------------------- */

/* A dump leaves out normals that IRIT would leave out: those within 1e-5 of
 * the plane's (spec/itd-format 5). A file keeps all that differ at all. */
static bool worth_writing(const ix__itdw *w, const ix_polygon *pg,
                          const ix_vertex *v)
{
    double tol = w->file ? 0 : 1e-5, size = 0, change = 0;

    if (!v->has_normal || pg->kind == IX_POLYLINE || pg->kind == IX_POINTLIST)
        return false;
    for (int k = 0; k < 3; k++) {
        size = fmax(size, fabs(v->normal[k]));
        change = fmax(change, fabs(v->normal[k] - pg->plane[k]));
    }
    return size > tol && (!pg->has_plane || change > tol);
}

static ix_status write_vertex(ix__itdw *w, const ix_polygon *pg,
                              const ix_vertex *v, int column)
{
    ix_buf *b = w->b;

    ix__itdw_indent(w, column);
    ix__buf_putc(b, '[');
    if (v->attrs)
        IX_TRY(ix__itdw_attrs(w, v->attrs, column));
    if (v->internal && pg->kind != IX_POINTLIST)
        ix__buf_puts(b, "[INTERNAL] ");
    if (worth_writing(w, pg, v)) {
        ix__buf_puts(b, "[NORMAL ");
        ix__itdw_nums(w, 3, v->normal);
        ix__buf_puts(b, "] ");
    }
    ix__itdw_nums(w, 3, v->p);
    ix__buf_puts(b, "]\n");
    return IX_OK;
}

ix_status ix__itdw_poly(ix__itdw *w, const ix_polygon *pg, int column)
{
    static const char *const words[] = {"POLYGON", "POLYLINE", "POINTLIST",
                                        "POLYSTRIP"};
    ix_buf *b = w->b;

    ix__itdw_indent(w, column);
    ix__buf_printf(b, "[%s ", words[pg->kind]);
    if (pg->has_plane && pg->kind != IX_POLYLINE && pg->kind != IX_POINTLIST) {
        ix__buf_puts(b, "[PLANE ");
        ix__itdw_nums(w, 4, pg->plane);
        ix__buf_puts(b, "] ");
    }
    IX_TRY(ix__itdw_attrs(w, pg->attrs, column));
    ix__itdw_indent(w, column + 4);
    ix__buf_printf(b, "%d\n", pg->n);
    for (int i = 0; i < pg->n; i++) {
        IX_TRY(write_vertex(w, pg, &pg->v[i], column + 4));
        if (i % 1024 == 0)
            IX_TRY(ix__itdw_check(w));
    }
    ix__itdw_indent(w, column);
    ix__buf_puts(b, "]\n");
    return ix__itdw_check(w);
}

/* --- trimmed surfaces ------------------------------------------------- */

static void open_line(ix__itdw *w, const char *text, int column)
{
    ix__itdw_indent(w, column);
    ix__buf_puts(w->b, text);
    ix__buf_putc(w->b, '\n');
}

static ix_status write_trimseg(ix__itdw *w, const ix_trimseg *s, int column)
{
    open_line(w, "[TRIMCRVSEG", column);
    IX_TRY(ix__itdw_mv(w, IX_OBJ_CURVE, s->uv, column + 4));
    if (s->euclid)
        IX_TRY(ix__itdw_mv(w, IX_OBJ_CURVE, s->euclid, column + 4));
    open_line(w, "]", column);
    return IX_OK;
}

ix_status ix__itdw_trimsrf(ix__itdw *w, const ix_trimsrf *t, int column)
{
    open_line(w, "[TRIMSRF", column);
    IX_TRY(ix__itdw_mv(w, IX_OBJ_SURFACE, t->srf, column + 4));
    for (int i = 0; i < t->nloops; i++) {
        open_line(w, "[TRIMCRV", column + 4);
        for (int k = 0; k < t->loop[i].n; k++)
            IX_TRY(write_trimseg(w, &t->loop[i].seg[k], column + 8));
        open_line(w, "]", column + 4);
    }
    open_line(w, "]", column);
    return ix__itdw_check(w);
}

/* --- models ----------------------------------------------------------- */

static ix_status write_model_srf(ix__itdw *w, const ix_model_srf *s, int column)
{
    ix__itdw_indent(w, column);
    ix__buf_printf(w->b, "[MDLTSRF %d\n", s->nloops);
    IX_TRY(ix__itdw_mv(w, IX_OBJ_SURFACE, s->srf, column + 4));
    for (int i = 0; i < s->nloops; i++) {
        ix__itdw_indent(w, column + 4);
        ix__buf_puts(w->b, "[MDLLOOP");
        for (int k = 0; k < s->nseg[i]; k++)
            ix__buf_printf(w->b, " %d", s->seg[i][k]);
        ix__buf_puts(w->b, "]\n");
    }
    open_line(w, "]", column);
    return IX_OK;
}

static ix_status write_model_seg(ix__itdw *w, const ix_model_seg *s, int column)
{
    const ix_mv *curves[3] = {s->uv1, s->uv2, s->euclid};
    int mask = (s->uv1 ? 1 : 0) + (s->uv2 ? 2 : 0) + (s->euclid ? 4 : 0);

    ix__itdw_indent(w, column);
    ix__buf_printf(w->b, "[MDLTSEG %d %d %d\n", mask, s->s1, s->s2);
    for (int k = 0; k < 3; k++)
        if (curves[k])
            IX_TRY(ix__itdw_mv(w, IX_OBJ_CURVE, curves[k], column + 4));
    open_line(w, "]", column);
    return IX_OK;
}

ix_status ix__itdw_model(ix__itdw *w, const ix_model *m, int column)
{
    ix__itdw_indent(w, column);
    ix__buf_printf(w->b, "[MODEL %d %d\n", m->nsrf, m->nseg);
    for (int i = 0; i < m->nsrf; i++)
        IX_TRY(write_model_srf(w, &m->srf[i], column + 4));
    for (int i = 0; i < m->nseg; i++)
        IX_TRY(write_model_seg(w, &m->seg[i], column + 4));
    open_line(w, "]", column);
    return ix__itdw_check(w);
}
