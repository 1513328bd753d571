/* scene.c - objects as paths and triangles. */
#include "io/scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/shapes.h"

/* What an element inherits from the lists that hold it. */
typedef struct {
    double rgb[3], width;
    bool has_color;
} style;

typedef struct {
    ix_scene *s;
    const ix_scene_opts *o;
    int isolines;
} builder;

/* --- growing arrays
 * ------------------------------------------------------------ */

static void *grow(ix_ctx *ctx, const void *old, size_t used, size_t *cap,
                  size_t size)
{
    size_t more = *cap ? 2 * *cap : 1024;
    void *p = ix__scratch(ctx, more, size);

    if (!p)
        return NULL;
    if (used)
        memcpy(p, old, used * size);
    *cap = more;
    return p;
}

static ix_status add_point(ix_scene *s, const double p[3])
{
    if (s->npts == s->pts_cap) {
        s->pts = grow(s->ctx, s->pts, s->npts, &s->pts_cap, sizeof *s->pts);
        if (!s->pts)
            return IX_ENOMEM;
    }
    memcpy(s->pts[s->npts++], p, sizeof *s->pts);
    return IX_OK;
}

/* The points added since first become a path. */
static ix_status add_path(ix_scene *s, ix_path_kind kind, const style *st,
                          size_t first, bool closed)
{
    ix_path *p;

    if (s->npts == first)
        return IX_OK;
    if (s->npaths == s->path_cap) {
        s->path = grow(s->ctx, s->path, s->npaths, &s->path_cap,
                       sizeof *s->path);
        if (!s->path)
            return IX_ENOMEM;
    }
    p = &s->path[s->npaths++];
    *p = (ix_path){.kind = kind,
                   .width = st->width,
                   .first = first,
                   .n = s->npts - first,
                   .closed = closed};
    memcpy(p->rgb, st->rgb, sizeof p->rgb);
    return IX_OK;
}

static ix_status add_triangle(ix_scene *s, const style *st, size_t a, size_t b,
                              size_t c)
{
    ix_tri *t;

    if (s->ntris == s->tri_cap) {
        s->tri = grow(s->ctx, s->tri, s->ntris, &s->tri_cap, sizeof *s->tri);
        if (!s->tri)
            return IX_ENOMEM;
    }
    t = &s->tri[s->ntris++];
    *t = (ix_tri){.v = {a, b, c}};
    memcpy(t->rgb, st->rgb, sizeof t->rgb);
    return IX_OK;
}

/* --- styles
 * --------------------------------------------------------------------- */

/* The sixteen colours of the format, darkened where they vanish on white. */
static const double palette[16][3] = {
    {0, 0, 0},          {0, 0, 0.85},     {0, 0.6, 0},     {0, 0.6, 0.65},
    {0.85, 0, 0},       {0.75, 0, 0.75},  {0.5, 0.5, 0},   {0.5, 0.5, 0.5},
    {0.25, 0.25, 0.25}, {0.25, 0.25, 1},  {0.2, 0.8, 0.2}, {0.1, 0.7, 0.75},
    {1, 0.25, 0.25},    {0.9, 0.25, 0.9}, {0.8, 0.65, 0},  {0.1, 0.1, 0.1}};

static void read_rgb(const char *text, style *st)
{
    double v[3];

    if (sscanf(text, "%lf ,%lf ,%lf", &v[0], &v[1], &v[2]) != 3)
        return;
    for (int k = 0; k < 3; k++)
        st->rgb[k] = fmin(fmax(v[k] / 255, 0), 1);
    /* white is drawn black: the paper is white */
    if (st->rgb[0] + st->rgb[1] + st->rgb[2] > 2.7)
        memset(st->rgb, 0, sizeof st->rgb);
}

static double attr_number(const ix_attr *a)
{
    return a->type == IX_ATTR_INT    ? (double)a->i
           : a->type == IX_ATTR_REAL ? a->r
                                     : -1;
}

static void read_style(ix_attr *attrs, style *st)
{
    const ix_attr *a = ix__attr_find(attrs, "color");

    if (a && a->type == IX_ATTR_INT && a->i >= 0 && a->i < 16) {
        memcpy(st->rgb, palette[a->i], sizeof st->rgb);
        st->has_color = true;
    }
    a = ix__attr_find(attrs, "rgb");
    if (a && a->type == IX_ATTR_STRING) {
        read_rgb(a->s, st);
        st->has_color = true;
    }
    a = ix__attr_find(attrs, "dwidth");
    if (a && attr_number(a) > 0)
        st->width = fmin(attr_number(a), 50);
}

/* --- curves
 * ----------------------------------------------------------------------- */

/* Parameters at which a direction is sampled: knots and equal steps between
 * them; *n of them in scratch. Straight pieces need only their ends. */
static ix_status samples(ix_ctx *ctx, const ix_mv *m, int dir, int least,
                         double **out, int *n)
{
    ix_dir d = ix_mv_dir(m, dir);
    int nk = ix_mv_nknots(m, dir), spans = 0, per, count = 0;
    double dom[2], *brk;

    ix_mv_domain(m, dir, dom);
    IX_SCRATCH(ctx, brk, nk + 2);
    brk[spans] = dom[0];
    for (int i = 0; i < nk; i++)
        if (d.knots[i] > brk[spans] && d.knots[i] < dom[1])
            brk[++spans] = d.knots[i];
    brk[++spans] = dom[1];
    per = d.order <= 2 && !ix_mv_rational(m) ? 1 : least / spans + 1;
    if (d.order > 2 && per < 8)
        per = 8;
    if ((size_t)per * (size_t)spans > 20000)
        per = 1;
    IX_SCRATCH(ctx, *out, (size_t)per * (size_t)spans + 1);
    for (int i = 0; i < spans; i++)
        for (int k = 0; k < per; k++)
            (*out)[count++] = brk[i] +
                              (brk[i + 1] - brk[i]) * ((double)k / per);
    (*out)[count++] = dom[1];
    *n = count;
    return IX_OK;
}

/* x, y, z of a homogeneous point; false at (or very near) infinity. */
static bool project(const ix_mv *m, const double *h, size_t stride, double *p)
{
    bool r = ix_mv_rational(m);
    double w = r ? h[0] : 1, big = 0;
    int n = ix_mv_ncoords(m);

    for (int k = 0; k < 3; k++) {
        p[k] = k < n ? h[(size_t)(k + r) * stride] : 0;
        big = fmax(big, fabs(p[k]));
    }
    if (!(fabs(w) > 1e-9 * big) || !isfinite(big))
        return false;
    for (int k = 0; k < 3; k++)
        p[k] /= w;
    return true;
}

/* Homogeneous points out[axes][n] as a path, broken where they are infinite
 * or change the sign of their weight. */
static ix_status points_to_path(builder *b, const ix_mv *m, const double *h,
                                size_t stride, int n, ix_path_kind kind,
                                const style *st)
{
    size_t first = b->s->npts;
    double last = 0;

    for (int i = 0; i < n; i++) {
        double w = ix_mv_rational(m) ? h[i] : 1, p[3];
        bool ok = project(m, h + i, stride, p);

        if (!ok || w * last < 0) {
            IX_TRY(add_path(b->s, kind, st, first, false));
            first = b->s->npts;
        }
        if (ok)
            IX_TRY(add_point(b->s, p));
        last = ok ? w : 0;
    }
    return add_path(b->s, kind, st, first, false);
}

static ix_status net_of_curve(builder *b, const ix_mv *m, const style *st)
{
    size_t first = b->s->npts, n = ix_mv_npts(m);

    for (size_t i = 0; i < n; i++) {
        double p[3];

        if (project(m, ix_mv_axis(m, 0) + i, n, p))
            IX_TRY(add_point(b->s, p));
    }
    return add_path(b->s, IX_PATH_NET, st, first, ix_mv_dir(m, 0).periodic);
}

static ix_status knots_of_curve(builder *b, const ix_mv *m, const style *st)
{
    ix_dir d = ix_mv_dir(m, 0);
    size_t first = b->s->npts;
    double dom[2], last;

    ix_mv_domain(m, 0, dom);
    last = dom[0];
    for (int i = 0; i < ix_mv_nknots(m, 0); i++) {
        double h[IX_MAX_COORDS + 1], p[3];

        if (!(d.knots[i] > last && d.knots[i] < dom[1]))
            continue;
        last = d.knots[i];
        IX_TRY(ix_mv_eval(b->s->ctx, m, &last, h));
        if (project(m, h, 1, p))
            IX_TRY(add_point(b->s, p));
    }
    return add_path(b->s, IX_PATH_KNOT, st, first, false);
}

static ix_status add_curve(builder *b, const ix_mv *m, ix_path_kind kind,
                           const style *st)
{
    ix_ctx *ctx = b->s->ctx;
    double *t, *h;
    int n;

    IX_TRY(samples(ctx, m, 0, 120, &t, &n));
    IX_SCRATCH(ctx, h, (size_t)ix_mv_naxes(m) * (size_t)n);
    IX_TRY(ix_mv_eval_many(ctx, m, (size_t)n, t, h));
    IX_TRY(points_to_path(b, m, h, (size_t)n, n, kind, st));
    if (kind != IX_PATH_LINE)
        return IX_OK;
    if (b->o->net)
        IX_TRY(net_of_curve(b, m, st));
    if (b->o->knots)
        IX_TRY(knots_of_curve(b, m, st));
    return IX_OK;
}

/* --- surfaces
 * ----------------------------------------------------------------------- */

/* Isoparametric line dir = t. */
static ix_status iso_line(builder *b, const ix_mv *m, int dir, double t,
                          bool edge, const style *st)
{
    style thin = *st;
    ix_status s;
    ix_mv *c;

    if (!edge)
        thin.width *= 0.6;
    IX_TRY(ix_mv_fix(b->s->ctx, m, dir, t, &c));
    s = add_curve(b, c, IX_PATH_EDGE, &thin);
    ix_mv_unref(b->s->ctx, c);
    return s;
}

static ix_status net_of_surface(builder *b, const ix_mv *m, const style *st)
{
    size_t nu = (size_t)ix_mv_length(m, 0), nv = (size_t)ix_mv_length(m, 1);

    for (int dir = 0; dir < 2; dir++)
        for (size_t i = 0; i < (dir ? nu : nv); i++) {
            size_t first = b->s->npts;

            for (size_t k = 0; k < (dir ? nv : nu); k++) {
                size_t at = dir ? i + k * nu : k + i * nu;
                double p[3];

                if (project(m, ix_mv_axis(m, 0) + at, nu * nv, p))
                    IX_TRY(add_point(b->s, p));
            }
            IX_TRY(add_path(b->s, IX_PATH_NET, st, first,
                            ix_mv_dir(m, dir).periodic));
        }
    return IX_OK;
}

/* All three are finite and on one side of the pole; weights are axis 0. */
static bool one_piece(const ix_mv *m, const double *h, const size_t *id,
                      size_t a, size_t b, size_t c)
{
    if (id[a] == SIZE_MAX || id[b] == SIZE_MAX || id[c] == SIZE_MAX)
        return false;
    return !ix_mv_rational(m) ||
           ((h[a] > 0) == (h[b] > 0) && (h[b] > 0) == (h[c] > 0));
}

static ix_status add_mesh(builder *b, const ix_mv *m, const style *st)
{
    ix_ctx *ctx = b->s->ctx;
    const double *t[2];
    double *u[2], *h;
    size_t *id, total;
    int n[2];

    for (int d = 0; d < 2; d++) {
        IX_TRY(samples(ctx, m, d, 40, &u[d], &n[d]));
        t[d] = u[d];
    }
    total = (size_t)n[0] * (size_t)n[1];
    IX_SCRATCH(ctx, h, total * (size_t)ix_mv_naxes(m));
    IX_SCRATCH(ctx, id, total);
    IX_TRY(ix_mv_eval_grid(ctx, m, n, t, h));
    for (size_t i = 0; i < total; i++) {
        double p[3];

        id[i] = SIZE_MAX;
        if (!project(m, h + i, total, p))
            continue;
        id[i] = b->s->npts;
        IX_TRY(add_point(b->s, p));
    }
    for (int j = 0; j + 1 < n[1]; j++)
        for (int i = 0; i + 1 < n[0]; i++) {
            size_t q = (size_t)j * (size_t)n[0] + (size_t)i;
            size_t r = q + (size_t)n[0];

            if (one_piece(m, h, id, q, q + 1, r + 1))
                IX_TRY(add_triangle(b->s, st, id[q], id[q + 1], id[r + 1]));
            if (one_piece(m, h, id, q, r + 1, r))
                IX_TRY(add_triangle(b->s, st, id[q], id[r + 1], id[r]));
        }
    return IX_OK;
}

static ix_status add_surface(builder *b, const ix_mv *m, const style *st)
{
    int n = b->isolines + 1;

    for (int dir = 0; dir < 2; dir++) {
        double dom[2];

        ix_mv_domain(m, dir, dom);
        for (int i = 0; i <= n; i++)
            IX_TRY(iso_line(
                b, m, dir, i == n ? dom[1] : dom[0] + (dom[1] - dom[0]) * i / n,
                i == 0 || i == n, st));
    }
    if (b->o->net)
        IX_TRY(net_of_surface(b, m, st));
    return b->o->mesh ? add_mesh(b, m, st) : IX_OK;
}

/* --- trimmed surfaces and models
 * -------------------------------------------------------------------------- */

static ix_status border_of(builder *b, const ix__lines *l, const style *st)
{
    for (size_t i = 0; i < l->nlines; i++) {
        size_t first = b->s->npts;

        for (size_t k = l->start[i]; k < l->start[i + 1]; k++)
            IX_TRY(add_point(b->s, l->xyz + 3 * k));
        IX_TRY(add_path(b->s, IX_PATH_LINE, st, first, false));
    }
    return IX_OK;
}

/* Triangles where they hide or shade something. */
static ix_status triangles_of(builder *b, const ix__mesh *m, const style *st)
{
    size_t first = b->s->npts;

    if (!b->o->mesh)
        return IX_OK;
    for (size_t i = 0; i < m->nverts; i++)
        IX_TRY(add_point(b->s, m->xyz + 3 * i));
    for (size_t i = 0; i < m->ntris; i++)
        IX_TRY(add_triangle(b->s, st, first + m->tri[i][0],
                            first + m->tri[i][1], first + m->tri[i][2]));
    return IX_OK;
}

/* Where a triangle is cut by the line p[dir] = at: returns how many of its
 * sides are, and the points. Corners on the line count to its upper side, so
 * that triangles side by side agree. */
static int cut_triangle(const ix__mesh *m, const uint32_t *t, int dir,
                        double at, double p[2][3])
{
    int n = 0;

    for (int k = 0; k < 3; k++) {
        size_t i = t[k], j = t[(k + 1) % 3];
        double a = m->uv[2 * i + (size_t)dir] - at;
        double b = m->uv[2 * j + (size_t)dir] - at;

        if ((a < 0) == (b < 0))
            continue;
        for (size_t c = 0; c < 3; c++)
            p[n][c] = m->xyz[3 * i + c] +
                      a / (a - b) * (m->xyz[3 * j + c] - m->xyz[3 * i + c]);
        n++;
    }
    return n;
}

/* Isoparametric lines of what is left of the surface, as cuts through its
 * triangles. */
static ix_status iso_lines(builder *b, const ix_mv *srf, const ix__mesh *m,
                           const style *st)
{
    int n = b->isolines + 1;
    style thin = *st;

    thin.width *= 0.6;
    for (int dir = 0; dir < 2; dir++) {
        double dom[2];

        ix_mv_domain(srf, dir, dom);
        for (int i = 1; i < n; i++)
            for (size_t k = 0; k < m->ntris; k++) {
                size_t first = b->s->npts;
                double p[2][3];

                if (cut_triangle(m, m->tri[k], dir,
                                 dom[0] + (dom[1] - dom[0]) * i / n, p) < 2)
                    continue;
                IX_TRY(add_point(b->s, p[0]));
                IX_TRY(add_point(b->s, p[1]));
                IX_TRY(add_path(b->s, IX_PATH_EDGE, &thin, first, false));
            }
    }
    return IX_OK;
}

static ix_status add_face(builder *b, const ix__face *f, const ix__mesh *m,
                          double tol, const style *st)
{
    ix__lines l;
    ix_status s;

    if (f->nloops == 0)
        return add_surface(b, f->srf, st);
    IX_TRY(ix__lines_of_face(b->s->ctx, f, tol, &l));
    s = border_of(b, &l, st);
    ix__lines_free(b->s->ctx, &l);
    if (s == IX_OK)
        s = iso_lines(b, f->srf, m, st);
    if (s == IX_OK)
        s = triangles_of(b, m, st);
    if (s == IX_OK && b->o->net)
        s = net_of_surface(b, f->srf, st);
    return s;
}

static ix_status add_faces(builder *b, int n, const ix__face *f, double tol,
                           const style *st)
{
    ix_status s = IX_OK;
    ix__mesh *m;

    IX_TRY(ix__mesh_of_faces(b->s->ctx, n, f, tol, NULL, &m));
    for (int i = 0; i < n; i++) {
        if (s == IX_OK)
            s = add_face(b, &f[i], &m[i], tol, st);
        ix__mesh_free(b->s->ctx, &m[i]);
    }
    return s;
}

static ix_status all_faces(builder *b, const ix_obj *o, int i, const style *st)
{
    ix_ctx *ctx = b->s->ctx;
    const void *item = ix__seq_item(o, i);
    const ix_model *model = o->type == IX_OBJ_MODEL ? item : NULL;
    ix__face one, *all = &one;
    double tol;

    IX_TRY(ix__shape_tol(ctx, o, &tol));
    if (model)
        IX_TRY(ix__faces_of_model(ctx, model, &all));
    else
        IX_TRY(ix__face_of_trimsrf(ctx, item, &one));
    return add_faces(b, model ? model->nsrf : 1, all, 2 * tol, st);
}

/* What cannot be trimmed is told and left out. */
static ix_status add_trimmed(builder *b, const ix_obj *o, int i,
                             const style *st)
{
    ix_ctx *ctx = b->s->ctx;
    ix_status s = all_faces(b, o, i, st);

    if (s != IX_EARG && s != IX_EDOMAIN && s != IX_EUNABLE)
        return s;
    ix__note(ctx, "warning: %.60s is not drawn: %s",
             o->name ? o->name : "an object", ix_ctx_message(ctx));
    return IX_OK;
}

/* --- other objects
 * -------------------------------------------------------------------- */

static ix_status add_polygon(builder *b, const ix_polygon *pg, const style *st)
{
    size_t first = b->s->npts;
    ix_path_kind kind = pg->kind == IX_POLYLINE    ? IX_PATH_LINE
                        : pg->kind == IX_POINTLIST ? IX_PATH_POINT
                                                   : IX_PATH_EDGE;

    for (int i = 0; i < pg->n; i++)
        IX_TRY(add_point(b->s, pg->v[i].p));
    if (pg->kind == IX_POLYGON && b->o->mesh)
        for (int i = 1; i + 1 < pg->n; i++)
            IX_TRY(add_triangle(b->s, st, first, first + (size_t)i,
                                first + (size_t)i + 1));
    return add_path(b->s, kind, st, first, pg->kind == IX_POLYGON);
}

static ix_status add_single(builder *b, const double *p, const style *st)
{
    size_t first = b->s->npts;

    IX_TRY(add_point(b->s, p));
    return add_path(b->s, IX_PATH_POINT, st, first, false);
}

static ix_status add_ctlpt(builder *b, const ix_ctlpt *c, const style *st)
{
    double p[3] = {0, 0, 0};

    for (int k = 0; k < 3 && k < c->ncoords; k++)
        p[k] = c->rational ? c->v[k + 1] / c->v[0] : c->v[k];
    return isfinite(p[0] + p[1] + p[2]) ? add_single(b, p, st) : IX_OK;
}

/* The six faces of a trivariate. */
static ix_status add_volume(builder *b, const ix_mv *m, const style *st)
{
    for (int dir = 0; dir < 3; dir++) {
        double dom[2];

        ix_mv_domain(m, dir, dom);
        for (int e = 0; e < 2; e++) {
            ix_status s;
            ix_mv *f;

            IX_TRY(ix_mv_fix(b->s->ctx, m, dir, dom[e], &f));
            s = add_surface(b, f, st);
            ix_mv_unref(b->s->ctx, f);
            IX_TRY(s);
        }
    }
    return IX_OK;
}

static ix_status add_freeform(builder *b, const ix_mv *in, const style *st)
{
    ix_ctx *ctx = b->s->ctx;
    ix_status s = IX_OK;
    ix_mv *m;

    if (ix_mv_dir(in, 0).basis == IX_POWER)
        IX_TRY(ix_mv_power_to_bezier(ctx, in, &m));
    else
        m = ix_mv_ref(in);
    if (ix_mv_ndirs(m) == 1)
        s = add_curve(b, m, IX_PATH_LINE, st);
    else if (ix_mv_ndirs(m) == 2)
        s = add_surface(b, m, st);
    else if (ix_mv_ndirs(m) == 3)
        s = add_volume(b, m, st);
    ix_mv_unref(ctx, m);
    return s;
}

static void take_matrix(ix_scene *s, const ix_obj *o)
{
    if (!o->name || strncmp(o->name, "VIEW_MAT", 8) != 0)
        return;
    memcpy(s->view, o->u.mat, sizeof s->view);
    s->has_view = true;
}

static ix_status add_leaf(builder *b, const ix_obj *o, const style *st)
{
    switch (o->type) {
    case IX_OBJ_POINT:
        return add_single(b, o->u.pt, st);
    case IX_OBJ_CTLPT:
        return add_ctlpt(b, o->u.ctlpt, st);
    case IX_OBJ_MATRIX:
        take_matrix(b->s, o);
        return IX_OK;
    case IX_OBJ_POLY:
        for (int i = 0; i < o->u.poly->n; i++)
            IX_TRY(add_polygon(b, &o->u.poly->poly[i], st));
        return IX_OK;
    case IX_OBJ_TRIMSRF:
    case IX_OBJ_MODEL:
        for (int i = 0; i < ix__seq_count(o); i++)
            IX_TRY(add_trimmed(b, o, i, st));
        return IX_OK;
    case IX_OBJ_CURVE:
    case IX_OBJ_SURFACE:
    case IX_OBJ_TRIVAR:
    case IX_OBJ_MULTIVAR:
        for (int i = 0; i < o->u.mvs->n; i++)
            IX_TRY(add_freeform(b, o->u.mvs->mv[i], st));
        return IX_OK;
    default:
        return IX_OK;
    }
}

/* Lists are at most IX_MAX_DEPTH deep when they come from a file; deeper ones
 * of scripts are refused. */
static ix_status add_object(builder *b, const ix_obj *o, style st, int depth)
{
    if (depth > IX_MAX_DEPTH)
        return IX_FAIL(b->s->ctx, IX_EARG, "lists nested deeper than %d",
                       IX_MAX_DEPTH);
    if (ix__attr_find(o->attrs, "invisible"))
        return IX_OK;
    read_style(o->attrs, &st);
    if (o->type != IX_OBJ_LIST)
        return add_leaf(b, o, &st);
    for (int i = 0; i < o->u.list.n; i++)
        IX_TRY(add_object(b, o->u.list.item[i], st, depth + 1));
    return IX_OK;
}

/* --- the whole
 * -------------------------------------------------------------------------- */

static void measure(ix_scene *s)
{
    for (int k = 0; k < 3; k++) {
        s->box[2 * k] = HUGE_VAL;
        s->box[2 * k + 1] = -HUGE_VAL;
    }
    for (size_t i = 0; i < s->npts; i++)
        for (int k = 0; k < 3; k++) {
            s->box[2 * k] = fmin(s->box[2 * k], s->pts[i][k]);
            s->box[2 * k + 1] = fmax(s->box[2 * k + 1], s->pts[i][k]);
        }
}

ix_status ix__scene_build(ix_ctx *ctx, const ix_obj *o,
                          const ix_scene_opts *opts, ix_scene *out)
{
    const style st = {.rgb = {0.05, 0.25, 0.6}, .width = 1.4};
    builder b = {.s = out, .o = opts};

    *out = (ix_scene){.ctx = ctx};
    b.isolines = opts->isolines > 0 ? opts->isolines : 7;
    IX_TRY(ix__obj_check_size(ctx, o, IX_MAX_DEPTH, SIZE_MAX));
    IX_TRY(add_object(&b, o, st, 0));
    measure(out);
    return IX_OK;
}

bool ix__scene_is_plane(const ix_scene *s)
{
    double size = fmax(s->box[1] - s->box[0], s->box[3] - s->box[2]);

    return !(s->box[5] - s->box[4] > 1e-9 * size);
}

bool ix__view_named(const char *name, double m[16])
{
    static const struct {
        const char *name;
        double axes[3][3]; /* where x, y, z go */
    } views[] = {
        {"top", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
        {"bottom", {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}},
        {"front", {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}},
        {"back", {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}},
        {"right", {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}},
        {"left", {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}},
        {"iso",
         {{-0.70710678118654752, -0.40824829046386302, 0.57735026918962576},
          {0.70710678118654752, -0.40824829046386302, 0.57735026918962576},
          {0, 0.81649658092772603, 0.57735026918962576}}},
    };

    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        if (strcmp(views[i].name, name) != 0)
            continue;
        memset(m, 0, 16 * sizeof *m);
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                m[4 * r + c] = views[i].axes[r][c];
        m[15] = 1;
        return true;
    }
    return false;
}
