/* xml_write_geom.c - geometry as XML: rows of numbers, one control point a
 * line, in elements of bounded size. */
#include <string.h>

#include "io/xml_write_impl.h"

/* So many rows stand in one element; the next ones follow in another. */
enum { ROWS = 1024, KNOTS = 8 * ROWS };

static void put_point_type(ix__xmlw *w, int ncoords, bool rational)
{
    ix__buf_printf(w->b, " type=\"%c%d\"", rational ? 'P' : 'E', ncoords);
}

/* The tags around row i of n. */
static void before_row(ix__xmlw *w, size_t i)
{
    if (i % ROWS == 0) {
        ix__xmlw_tag(w, "points");
        ix__xmlw_open(w);
    }
}

static ix_status after_row(ix__xmlw *w, size_t i, size_t n)
{
    ix__buf_putc(w->b, '\n');
    if ((i + 1) % ROWS != 0 && i + 1 < n)
        return IX_OK;
    ix__xmlw_close(w, "points");
    return ix__xmlw_check(w);
}

/* pts is double[naxes][n]. */
static ix_status put_points(ix__xmlw *w, int naxes, size_t n, const double *pts)
{
    for (size_t i = 0; i < n; i++) {
        before_row(w, i);
        for (int a = 0; a < naxes; a++) {
            if (a > 0)
                ix__buf_putc(w->b, ' ');
            ix__xmlw_num(w, pts[(size_t)a * n + i]);
        }
        IX_TRY(after_row(w, i, n));
    }
    return IX_OK;
}

static ix_status put_knots(ix__xmlw *w, int n, const double *knots)
{
    for (int i = 0; i < n; i += KNOTS) {
        ix__xmlw_tag(w, "knots");
        ix__xmlw_begin(w);
        ix__xmlw_nums(w, n - i < KNOTS ? n - i : KNOTS, knots + i);
        ix__xmlw_end(w, "knots");
        IX_TRY(ix__xmlw_check(w));
    }
    return IX_OK;
}

/* --- multivariates ---------------------------------------------------- */

static ix_status put_direction(ix__xmlw *w, ix_dir dir)
{
    static const char *const words[] = {"bezier", "bspline", "power"};

    ix__xmlw_tag(w, "direction");
    ix__xmlw_attr(w, "basis", words[dir.basis]);
    ix__xmlw_attr_int(w, "order", dir.order);
    if (dir.basis != IX_BSPLINE) {
        ix__xmlw_none(w);
        return IX_OK;
    }
    ix__xmlw_attr_int(w, "length", dir.length);
    if (dir.periodic)
        ix__xmlw_attr(w, "periodic", "true");
    ix__xmlw_open(w);
    IX_TRY(put_knots(w, ix_knots_count(&dir), dir.knots));
    ix__xmlw_close(w, "direction");
    return IX_OK;
}

ix_status ix__xmlw_mv(ix__xmlw *w, const char *name, const char *use,
                      const ix_mv *m)
{
    ix__xmlw_tag(w, name);
    if (use)
        ix__xmlw_attr(w, "use", use);
    put_point_type(w, ix_mv_ncoords(m), ix_mv_rational(m));
    ix__xmlw_open(w);
    for (int d = 0; d < ix_mv_ndirs(m); d++)
        IX_TRY(put_direction(w, ix_mv_dir(m, d)));
    IX_TRY(put_points(w, ix_mv_naxes(m), ix_mv_npts(m), ix_mv_axis(m, 0)));
    ix__xmlw_close(w, name);
    return IX_OK;
}

ix_status ix__xmlw_trisrf(ix__xmlw *w, const ix_trisrf *t)
{
    static const char *const words[] = {"bezier", "bspline", "gregory"};

    ix__xmlw_tag(w, "triangularsurface");
    put_point_type(w, t->ncoords, t->rational);
    ix__xmlw_attr(w, "basis", words[t->kind]);
    ix__xmlw_attr_int(w, "length", t->length);
    if (t->kind == IX_TRI_BSPLINE)
        ix__xmlw_attr_int(w, "order", t->order);
    ix__xmlw_open(w);
    if (t->kind == IX_TRI_BSPLINE)
        IX_TRY(put_knots(w, t->nknots, t->knots));
    IX_TRY(put_points(w, t->ncoords + (t->rational ? 1 : 0), (size_t)t->npts,
                      t->pts));
    ix__xmlw_close(w, "triangularsurface");
    return IX_OK;
}

/* --- polygons --------------------------------------------------------- */

/* A normal that is the plane's comes back by itself when a polygon is read. */
static bool needs_normal(const ix_polygon *pg, const ix_vertex *v)
{
    return v->has_normal &&
           !(pg->kind == IX_POLYGON && pg->has_plane &&
             memcmp(v->normal, pg->plane, sizeof v->normal) == 0);
}

static bool is_plain(const ix_polygon *pg, const ix_vertex *v)
{
    return !v->attrs && !v->internal && !needs_normal(pg, v);
}

static ix_status put_vertex(ix__xmlw *w, const ix_polygon *pg,
                            const ix_vertex *v)
{
    ix__xmlw_tag(w, "vertex");
    ix__xmlw_attr_nums(w, "position", 3, v->p);
    if (needs_normal(pg, v))
        ix__xmlw_attr_nums(w, "normal", 3, v->normal);
    if (v->internal)
        ix__xmlw_attr(w, "internal", "true");
    if (!v->attrs) {
        ix__xmlw_none(w);
        return IX_OK;
    }
    ix__xmlw_open(w);
    IX_TRY(ix__xmlw_attrs(w, v->attrs));
    ix__xmlw_close(w, "vertex");
    return IX_OK;
}

/* n plain vertices from v on. */
static ix_status put_plain(ix__xmlw *w, const ix_vertex *v, int n)
{
    for (int i = 0; i < n; i++) {
        before_row(w, (size_t)i);
        ix__xmlw_nums(w, 3, v[i].p);
        IX_TRY(after_row(w, (size_t)i, (size_t)n));
    }
    return IX_OK;
}

static ix_status put_vertices(ix__xmlw *w, const ix_polygon *pg)
{
    int i = 0;

    while (i < pg->n) {
        int n = 0;

        while (i + n < pg->n && is_plain(pg, &pg->v[i + n]))
            n++;
        IX_TRY(put_plain(w, &pg->v[i], n));
        i += n;
        if (i < pg->n)
            IX_TRY(put_vertex(w, pg, &pg->v[i++]));
        if (i % ROWS == 0)
            IX_TRY(ix__xmlw_check(w));
    }
    return IX_OK;
}

ix_status ix__xmlw_poly(ix__xmlw *w, const ix_polygon *pg)
{
    static const char *const words[] = {"polygon", "polyline", "pointlist",
                                        "polystrip"};

    ix__xmlw_tag(w, words[pg->kind]);
    if (pg->has_plane)
        ix__xmlw_attr_nums(w, "plane", 4, pg->plane);
    ix__xmlw_open(w);
    IX_TRY(ix__xmlw_attrs(w, pg->attrs));
    IX_TRY(put_vertices(w, pg));
    ix__xmlw_close(w, words[pg->kind]);
    return ix__xmlw_check(w);
}

/* --- trimmed surfaces and models -------------------------------------- */

ix_status ix__xmlw_trimsrf(ix__xmlw *w, const ix_trimsrf *t)
{
    ix__xmlw_tag(w, "trimmedsurface");
    ix__xmlw_open(w);
    IX_TRY(ix__xmlw_mv(w, "surface", NULL, t->srf));
    for (int i = 0; i < t->nloops; i++) {
        ix__xmlw_tag(w, "loop");
        ix__xmlw_open(w);
        for (int k = 0; k < t->loop[i].n; k++) {
            const ix_trimseg *s = &t->loop[i].seg[k];

            ix__xmlw_tag(w, "segment");
            ix__xmlw_open(w);
            IX_TRY(ix__xmlw_mv(w, "curve", "uv", s->uv));
            if (s->euclid)
                IX_TRY(ix__xmlw_mv(w, "curve", "space", s->euclid));
            ix__xmlw_close(w, "segment");
        }
        ix__xmlw_close(w, "loop");
    }
    ix__xmlw_close(w, "trimmedsurface");
    return ix__xmlw_check(w);
}

static ix_status put_face(ix__xmlw *w, const ix_model_srf *s)
{
    ix__xmlw_tag(w, "face");
    ix__xmlw_open(w);
    IX_TRY(ix__xmlw_mv(w, "surface", NULL, s->srf));
    for (int i = 0; i < s->nloops; i++) {
        ix__xmlw_tag(w, "edges");
        ix__xmlw_begin(w);
        for (int k = 0; k < s->nseg[i]; k++)
            ix__buf_printf(w->b, k ? " %d" : "%d", s->seg[i][k]);
        ix__xmlw_end(w, "edges");
    }
    ix__xmlw_close(w, "face");
    return IX_OK;
}

static ix_status put_edge(ix__xmlw *w, const ix_model_seg *s)
{
    static const char *const uses[] = {"uv1", "uv2", "space"};
    const ix_mv *curves[3] = {s->uv1, s->uv2, s->euclid};

    ix__xmlw_tag(w, "edge");
    ix__xmlw_attr_int(w, "face1", s->s1);
    ix__xmlw_attr_int(w, "face2", s->s2);
    ix__xmlw_open(w);
    for (int k = 0; k < 3; k++)
        if (curves[k])
            IX_TRY(ix__xmlw_mv(w, "curve", uses[k], curves[k]));
    ix__xmlw_close(w, "edge");
    return IX_OK;
}

ix_status ix__xmlw_model(ix__xmlw *w, const ix_model *m)
{
    ix__xmlw_tag(w, "model");
    ix__xmlw_open(w);
    for (int i = 0; i < m->nsrf; i++)
        IX_TRY(put_face(w, &m->srf[i]));
    for (int i = 0; i < m->nseg; i++)
        IX_TRY(put_edge(w, &m->seg[i]));
    ix__xmlw_close(w, "model");
    return ix__xmlw_check(w);
}
