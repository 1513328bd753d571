/* x3d_nurbs.c - freeforms as the nodes of X3D's NURBS component.
 *
 * X3D has homogeneous control points, multiplied by their weights, as we
 * have: they go out as they are (spec/ecosystem 4). Weights must be positive:
 * what has poles is halved until all but small pieces around them have. */
#include <math.h>
#include <string.h>

#include "io/faces.h"
#include "io/x3d_impl.h"
#include "mv/mv.h"

/* --- into the form of X3D --------------------------------------------- */

/* Positive weights, if need be by changing the sign of everything. */
static ix_status positive(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    ix_mv *copy;

    if (!ix_mv_rational(m) || ix_mv_weights(m)[0] > 0) {
        *out = ix_mv_ref(m);
        return IX_OK;
    }
    IX_TRY(ix__mv_alloc(ctx, m->ndirs, m->dirs, m->ncoords, true, &copy));
    for (size_t i = 0; i < m->npts * (size_t)m->naxes; i++)
        copy->pts[i] = -m->pts[i];
    *out = copy;
    return IX_OK;
}

/* An open B-spline of orders 2 and more, with ncoords coordinates. */
static ix_status prepare(ix_ctx *ctx, const ix_mv *m, int ncoords, ix_mv **out)
{
    ix_mv *cur, *next = NULL;
    ix_status st = ix__mv_no_power(ctx, m, &cur);

    if (st == IX_OK)
        st = ix__mv_step(ctx, &cur, &next, ix_mv_to_bspline(ctx, cur, &next));
    if (st == IX_OK)
        st = ix__mv_step(ctx, &cur, &next, ix_mv_to_open(ctx, cur, &next));
    if (st == IX_OK)
        st = ix__mv_step(
            ctx, &cur, &next,
            ix_mv_coerce(ctx, cur, ncoords, ix_mv_rational(cur), &next));
    if (st == IX_OK)
        st = ix__mv_step(ctx, &cur, &next, positive(ctx, cur, &next));
    for (int d = 0; st == IX_OK && d < ix_mv_ndirs(m); d++)
        if (ix_mv_order(cur, d) < 2)
            st = ix__mv_step(ctx, &cur, &next,
                             ix_mv_raise(ctx, cur, d, 2, &next));
    *out = st == IX_OK ? cur : NULL;
    return st;
}

/* --- nodes ------------------------------------------------------------ */

static void put_knots(ix__x3d *w, const char *name, const ix_mv *m, int d)
{
    ix__x3d_rows(w, name, (size_t)ix_mv_nknots(m, d), 1, ix_mv_dir(m, d).knots,
                 0);
}

static void put_weights(ix__x3d *w, const ix_mv *m)
{
    if (ix_mv_rational(m))
        ix__x3d_rows(w, "weight", ix_mv_npts(m), 1, ix_mv_weights(m), 0);
}

/* Behind the attributes of a node: its points, as children, stay open. */
static void put_points(ix__x3d *w, const ix_mv *m)
{
    ix__buf_puts(w->b, ">\n");
    w->depth++;
    ix__x3d_indent(w);
    ix__buf_puts(w->b, "<CoordinateDouble containerField=\"controlPoint\"");
    ix__x3d_rows(w, "point", ix_mv_npts(m), 3, ix_mv_coord(m, 0),
                 ix_mv_npts(m));
    ix__buf_puts(w->b, "/>\n");
    w->depth--;
}

/* Non-empty knot intervals of an open B-spline. */
static int spans(const ix_mv *m, int d)
{
    ix_dir dir = ix_mv_dir(m, d);
    int n = 0;

    for (int i = dir.order - 1; i < dir.length; i++)
        n += dir.knots[i] < dir.knots[i + 1];
    return n;
}

/* Faces or segments: 8 for each degree and span, at most 256. */
static int steps(const ix_mv *m, int d)
{
    int each = 8 * (ix_mv_order(m, d) - 1);
    int n = spans(m, d);

    return n > 256 / each ? (n > 256 ? n : 256) : n * each;
}

static ix_status put_curve(ix__x3d *w, const char *name,
                           const ix__x3d_look *look, const ix_mv *m)
{
    IX_TRY(ix__x3d_shape(w, name, look, true));
    ix__x3d_indent(w);
    ix__buf_printf(w->b, "<NurbsCurve order=\"%d\" tessellation=\"%d\"",
                   ix_mv_order(m, 0), steps(m, 0));
    put_knots(w, "knot", m, 0);
    put_weights(w, m);
    put_points(w, m);
    ix__x3d_line(w, "</NurbsCurve>");
    ix__x3d_end_shape(w);
    return IX_OK;
}

/* The opening tag of a surface's node and its points. */
static void open_surface(ix__x3d *w, const char *node, const ix_mv *m)
{
    ix__x3d_indent(w);
    ix__buf_printf(w->b,
                   "<%s solid=\"false\" uDimension=\"%d\" vDimension=\"%d\" "
                   "uOrder=\"%d\" vOrder=\"%d\" uTessellation=\"%d\" "
                   "vTessellation=\"%d\"",
                   node, ix_mv_length(m, 0), ix_mv_length(m, 1),
                   ix_mv_order(m, 0), ix_mv_order(m, 1), steps(m, 0),
                   steps(m, 1));
    put_knots(w, "uKnot", m, 0);
    put_knots(w, "vKnot", m, 1);
    put_weights(w, m);
    put_points(w, m);
}

static ix_status put_surface(ix__x3d *w, const char *name,
                             const ix__x3d_look *look, const ix_mv *m)
{
    IX_TRY(ix__x3d_shape(w, name, look, false));
    open_surface(w, "NurbsPatchSurface", m);
    ix__x3d_line(w, "</NurbsPatchSurface>");
    ix__x3d_end_shape(w);
    return IX_OK;
}

/* --- the same as lines and triangles ---------------------------------- */

static void put_triples(ix__x3d *w, size_t n, const double *xyz)
{
    ix__x3d_indent(w);
    ix__buf_puts(w->b, "<Coordinate point=\"");
    for (size_t i = 0; i < 3 * n; i++) {
        if (i > 0)
            ix__buf_puts(w->b, i % 3 == 0 ? ", " : " ");
        ix__x3d_num(w, xyz[i]);
    }
    ix__buf_puts(w->b, "\"/>\n");
}

static ix_status put_lines(ix__x3d *w, const ix__x3d_look *look,
                           const ix__lines *l)
{
    IX_TRY(ix__x3d_shape(w, NULL, look, true));
    ix__x3d_indent(w);
    ix__buf_puts(w->b, "<LineSet vertexCount=\"");
    for (size_t i = 0; i < l->nlines; i++)
        ix__buf_printf(w->b, i ? " %zu" : "%zu", l->start[i + 1] - l->start[i]);
    ix__buf_puts(w->b, "\">\n");
    w->depth++;
    put_triples(w, l->npts, l->xyz);
    w->depth--;
    ix__x3d_line(w, "</LineSet>");
    ix__x3d_end_shape(w);
    return IX_OK;
}

static ix_status put_mesh(ix__x3d *w, const ix__x3d_look *look,
                          const ix__mesh *m)
{
    IX_TRY(ix__x3d_shape(w, NULL, look, false));
    ix__x3d_indent(w);
    ix__buf_puts(w->b, "<IndexedTriangleSet solid=\"false\" index=\"");
    for (size_t i = 0; i < m->ntris; i++)
        ix__buf_printf(w->b, "%s%u %u %u", i ? ", " : "", m->tri[i][0],
                       m->tri[i][1], m->tri[i][2]);
    ix__buf_puts(w->b, "\">\n");
    w->depth++;
    put_triples(w, m->nverts, m->xyz);
    w->depth--;
    ix__x3d_line(w, "</IndexedTriangleSet>");
    ix__x3d_end_shape(w);
    return IX_OK;
}

/* A piece beside a pole is large: 1/100 of its size will do for it. */
static double tolerance(const ix__x3d *w, const ix_mv *m)
{
    double lo[3], hi[3], size = 0;

    if (!w->pieces || ix_mv_bbox(w->b->ctx, m, lo, hi) != IX_OK)
        return w->tol;
    for (int c = 0; c < 3; c++)
        size = fmax(size, hi[c] - lo[c]);
    return fmax(w->tol, size / 100);
}

/* Nothing where too many points would be needed: the exact shape is there. */
static ix_status put_approximation(ix__x3d *w, const ix__x3d_look *look,
                                   const ix_mv *m)
{
    ix_ctx *ctx = w->b->ctx;
    double tol = tolerance(w, m);
    ix_status st;
    ix__lines l;
    ix__mesh t;

    if (ix_mv_ndirs(m) == 1) {
        st = ix__lines_of_crv(ctx, m, tol, &l);
        if (st == IX_OK) {
            st = l.nlines > 0 ? put_lines(w, look, &l) : IX_OK;
            ix__lines_free(ctx, &l);
        }
    } else {
        st = ix__mesh_of_srf(ctx, m, tol, &t);
        if (st == IX_OK) {
            st = t.ntris > 0 ? put_mesh(w, look, &t) : IX_OK;
            ix__mesh_free(ctx, &t);
        }
    }
    return st == IX_EUNABLE ? IX_OK : st;
}

/* --- multivariates ---------------------------------------------------- */

/* Both, of which a browser shows the first: choice 1 is for those that do not
 * know NURBS. */
static ix_status put_prepared(ix__x3d *w, const char *name,
                              const ix__x3d_look *look, const ix_mv *m)
{
    ix__x3d_line(w, "<Switch whichChoice=\"0\">");
    w->depth++;
    if (ix_mv_ndirs(m) == 1)
        IX_TRY(put_curve(w, name, look, m));
    else
        IX_TRY(put_surface(w, name, look, m));
    IX_TRY(put_approximation(w, look, m));
    w->depth--;
    ix__x3d_line(w, "</Switch>");
    return ix__x3d_check(w);
}

static ix_status put_whole(ix__x3d *w, const char *name,
                           const ix__x3d_look *look, const ix_mv *m)
{
    ix_mv *ready;
    ix_status st;

    IX_TRY(prepare(w->b->ctx, m, 3, &ready));
    st = put_prepared(w, name, look, ready);
    ix_mv_unref(w->b->ctx, ready);
    return st;
}

enum { HALVINGS = 12 }; /* pieces of 1/4096 of the domain are the smallest */

/* The pieces of m whose weights have one sign. */
static ix_status put_finite(ix__x3d *w, const char *name,
                            const ix__x3d_look *look, const ix_mv *m, int depth)
{
    int d = depth % ix_mv_ndirs(m);
    double dom[2];
    ix_mv *half[2];
    ix_status st;

    if (!ix_mv_has_poles(m))
        return put_whole(w, name, look, m);
    if (depth == HALVINGS)
        return ix__x3d_check(w);
    ix_mv_domain(m, d, dom);
    IX_TRY(ix_mv_split(w->b->ctx, m, d, dom[0] + (dom[1] - dom[0]) / 2, half));
    st = put_finite(w, name, look, half[0], depth + 1);
    if (st == IX_OK)
        st = put_finite(w, name, look, half[1], depth + 1);
    ix_mv_unref(w->b->ctx, half[0]);
    ix_mv_unref(w->b->ctx, half[1]);
    return st;
}

/* Power bases have no control points whose weights would tell. */
static ix_status put_pieces(ix__x3d *w, const char *name,
                            const ix__x3d_look *look, const ix_mv *m)
{
    ix_mv *plain;
    ix_status st;

    IX_TRY(ix__mv_no_power(w->b->ctx, m, &plain));
    w->pieces = ix_mv_has_poles(plain);
    if (w->pieces)
        ix__note(w->b->ctx,
                 "warning: %.60s is in the X3D file in pieces, without what is "
                 "near points at infinity",
                 name ? name : "an object");
    st = put_finite(w, name, look, plain, 0);
    ix_mv_unref(w->b->ctx, plain);
    return st;
}

/* The six faces. */
static ix_status put_trivar(ix__x3d *w, const char *name,
                            const ix__x3d_look *look, const ix_mv *m)
{
    for (int i = 0; i < 6; i++) {
        double dom[2];
        ix_mv *face;
        ix_status st;

        ix_mv_domain(m, i / 2, dom);
        IX_TRY(ix_mv_fix(w->b->ctx, m, i / 2, dom[i % 2], &face));
        st = put_pieces(w, name, look, face);
        ix_mv_unref(w->b->ctx, face);
        IX_TRY(st);
    }
    return IX_OK;
}

ix_status ix__x3d_mv(ix__x3d *w, const char *name, const ix__x3d_look *look,
                     const ix_mv *m)
{
    if (ix_mv_ndirs(m) < 3)
        return put_pieces(w, name, look, m);
    if (ix_mv_ndirs(m) == 3)
        return put_trivar(w, name, look, m);
    ix__note(w->b->ctx,
             "warning: %.60s is not in the X3D file: it has %d parameters",
             name ? name : "an object", ix_mv_ndirs(m));
    return IX_OK;
}

/* --- trimmed surfaces ------------------------------------------------- */

/* The curves of all loops: prepared, references; loop i has size[i] of them. */
typedef struct {
    int nloops, ncurves;
    int *size;
    ix_mv **curve;
} contours;

static ix_status reverse_loop(ix_ctx *ctx, int n, ix_mv **curve)
{
    for (int i = 0; i < n; i++) {
        ix_mv *back;

        IX_TRY(ix_mv_reverse(ctx, curve[i], 0, &back));
        ix_mv_unref(ctx, curve[i]);
        curve[i] = back;
    }
    for (int i = 0; i < n / 2; i++) {
        ix_mv *c = curve[i];

        curve[i] = curve[n - 1 - i];
        curve[n - 1 - i] = c;
    }
    return IX_OK;
}

static void put_contour(ix__x3d *w, int n, ix_mv *const *curve)
{
    ix__x3d_line(w, "<Contour2D containerField=\"trimmingContour\">");
    w->depth++;
    for (int i = 0; i < n; i++) {
        const ix_mv *m = curve[i];

        ix__x3d_indent(w);
        ix__buf_printf(w->b,
                       "<NurbsCurve2D containerField=\"children\" "
                       "order=\"%d\" tessellation=\"%d\"",
                       ix_mv_order(m, 0), steps(m, 0));
        put_knots(w, "knot", m, 0);
        put_weights(w, m);
        ix__x3d_rows(w, "controlPoint", ix_mv_npts(m), 2, ix_mv_coord(m, 0),
                     ix_mv_npts(m));
        ix__buf_puts(w->b, "/>\n");
    }
    w->depth--;
    ix__x3d_line(w, "</Contour2D>");
}

static ix_status put_trimmed(ix__x3d *w, const char *name,
                             const ix__x3d_look *look, const ix_mv *m,
                             contours *c)
{
    ix_mv *const *curve = c->curve;

    IX_TRY(ix__x3d_shape(w, name, look, false));
    open_surface(w, "NurbsTrimmedSurface", m);
    w->depth++;
    for (int i = 0; i < c->nloops; curve += c->size[i++])
        put_contour(w, c->size[i], curve);
    w->depth--;
    ix__x3d_line(w, "</NurbsTrimmedSurface>");
    ix__x3d_end_shape(w);
    return ix__x3d_check(w);
}

/* --- faces ------------------------------------------------------------ */

static bool has_poles(const ix__x3d *w, const char *name, const ix_mv *m)
{
    if (!ix_mv_has_poles(m))
        return false;
    ix__note(w->b->ctx,
             "warning: %.60s is not in the X3D file: its weights are zero or "
             "of both signs",
             name ? name : "an object");
    return true;
}

/* The curves of a face: outer loops counter-clockwise, holes clockwise. */
static ix_status add_curves(ix_ctx *ctx, contours *c, const ix__face *f)
{
    ix__nesting *nest;
    int n = 0;

    IX_TRY(ix__face_nesting(ctx, f, &nest));
    for (int i = 0; i < f->nloops; i++)
        n += f->loop[i].n;
    c->nloops = f->nloops;
    IX_SCRATCH(ctx, c->size, f->nloops);
    IX_SCRATCH(ctx, c->curve, n);
    for (int i = 0; i < f->nloops; i++) {
        c->size[i] = f->loop[i].n;
        for (int k = 0; k < f->loop[i].n; k++) {
            ix_mv **at = &c->curve[c->ncurves];

            IX_TRY(prepare(ctx, f->loop[i].curve[k].uv, 2, at));
            c->ncurves++;
            if (f->loop[i].curve[k].back)
                IX_TRY(reverse_loop(ctx, 1, at));
        }
        if (nest[i].turn)
            IX_TRY(reverse_loop(ctx, c->size[i],
                                c->curve + c->ncurves - c->size[i]));
    }
    return IX_OK;
}

static ix_status put_exact(ix__x3d *w, const char *name,
                           const ix__x3d_look *look, const ix__face *f)
{
    ix_ctx *ctx = w->b->ctx;
    ix_mark mk = ix__scratch_mark(ctx);
    contours c = {0};
    ix_mv *ready = NULL;
    ix_status st = add_curves(ctx, &c, f);

    if (st == IX_OK)
        st = prepare(ctx, f->srf, 3, &ready);
    if (st == IX_OK)
        st = put_trimmed(w, name, look, ready, &c);
    ix_mv_unref(ctx, ready);
    for (int i = 0; i < c.ncurves; i++)
        ix_mv_unref(ctx, c.curve[i]);
    ix__scratch_release(ctx, mk);
    return st;
}

/* Both, as put_prepared; mesh may be NULL. */
static ix_status put_face(ix__x3d *w, const char *name,
                          const ix__x3d_look *look, const ix__face *f,
                          const ix__mesh *mesh)
{
    if (has_poles(w, name, f->srf))
        return IX_OK;
    ix__x3d_line(w, "<Switch whichChoice=\"0\">");
    w->depth++;
    IX_TRY(put_exact(w, name, look, f));
    if (mesh && mesh->ntris > 0)
        IX_TRY(put_mesh(w, look, mesh));
    w->depth--;
    ix__x3d_line(w, "</Switch>");
    return ix__x3d_check(w);
}

/* Without triangles where too many would be needed: the exact shape is there.
 */
static ix_status put_faces(ix__x3d *w, const char *name,
                           const ix__x3d_look *look, int n, const ix__face *f)
{
    ix_ctx *ctx = w->b->ctx;
    ix__mesh *mesh;
    ix_status st = ix__mesh_of_faces(ctx, n, f, w->tol, NULL, &mesh);
    bool some = st == IX_OK;

    if (st == IX_EUNABLE)
        st = IX_OK;
    for (int i = 0; i < n; i++) {
        if (st == IX_OK)
            st = put_face(w, name, look, &f[i], some ? &mesh[i] : NULL);
        if (some)
            ix__mesh_free(ctx, &mesh[i]);
    }
    return st;
}

/* Loops that are none: the reason is told, the rest is written. */
static ix_status leave_out(ix__x3d *w, const char *name, ix_status st)
{
    ix_ctx *ctx = w->b->ctx;

    if (st != IX_EARG && st != IX_EDOMAIN)
        return st;
    ix__note(ctx, "warning: %.60s is not in the X3D file: %s",
             name ? name : "an object", ix_ctx_message(ctx));
    return IX_OK;
}

static ix_status put_trimsrf(ix__x3d *w, const char *name,
                             const ix__x3d_look *look, const ix_trimsrf *t)
{
    ix__face f;
    ix_status st = ix__face_of_trimsrf(w->b->ctx, t, &f);

    return st == IX_OK ? put_faces(w, name, look, 1, &f)
                       : leave_out(w, name, st);
}

ix_status ix__x3d_trimsrf(ix__x3d *w, const char *name,
                          const ix__x3d_look *look, const ix_trimsrf *t)
{
    IX_RETURN_SCOPED(w->b->ctx, put_trimsrf(w, name, look, t));
}

static ix_status put_model(ix__x3d *w, const char *name,
                           const ix__x3d_look *look, const ix_model *m)
{
    ix__face *f;
    ix_status st = ix__faces_of_model(w->b->ctx, m, &f);

    return st == IX_OK ? put_faces(w, name, look, m->nsrf, f)
                       : leave_out(w, name, st);
}

ix_status ix__x3d_model(ix__x3d *w, const char *name, const ix__x3d_look *look,
                        const ix_model *m)
{
    IX_RETURN_SCOPED(w->b->ctx, put_model(w, name, look, m));
}
