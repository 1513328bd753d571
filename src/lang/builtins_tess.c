/* builtins_tess.c - freeforms as polygons, polylines and points (chapter 23 of
 * spec/functions): in RESOLUTION steps, or within POLY_APPROX_TOL if
 * POLY_APPROX_OPT is not 0. */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "io/shapes.h"
#include "iritx/geom_srf.h"
#include "lang/interp.h"
#include "object/walk.h"

/* Polygons in the making, each in memory of its own until they are one value.
 */
typedef struct {
    ix_call *c;
    ix_buf out; /* ix_polygon[] */
    int steps;
    double tol; /* 0: steps */
    double size;
    bool normals, quads, uv, optimal;
} maker;

enum { MOST_STEPS = 10000, ISO_LINES = 10 };

/* --- polygons ------------------------------------------------------------- */

static ix_polygon *add_polygon(maker *m, ix_poly_kind kind, int n)
{
    ix_polygon pg = {.kind = kind}, *at;

    ix__buf_add(&m->out, (const char *)&pg, sizeof pg);
    if (m->out.failed)
        return NULL;
    at = (ix_polygon *)(void *)(m->out.data + m->out.len - sizeof pg);
    return ix__poly_vertices(m->c->ctx, at, n) == IX_OK ? at : NULL;
}

/* All polygons as one value; they are gone from m. */
static ix_status finish(maker *m, const char *what)
{
    size_t n = m->out.len / sizeof(ix_polygon);
    ix_poly *p;

    if (n == 0)
        return IX_ARG_FAIL(m->c, 0, "there is no %s in it", what);
    if (n > INT_MAX)
        return IX_FAIL(m->c->ctx, IX_EUNABLE, "%zu polygons are too many", n);
    p = ix__poly_new(m->c->ctx, (int)n);
    if (!p)
        return IX_ENOMEM;
    memcpy(p->poly, m->out.data, m->out.len);
    m->out.len = 0;
    return ix__ret(m->c, ix__obj_poly(m->c->ctx, p));
}

static void drop_polygon(ix_ctx *ctx, ix_polygon *pg)
{
    for (int k = 0; k < pg->n; k++)
        ix__attr_free_all(ctx, &pg->v[k].attrs);
    ix__attr_free_all(ctx, &pg->attrs);
    ix__free(ctx, pg->v, (size_t)pg->n * sizeof *pg->v);
}

/* What is left when something failed. */
static void drop(maker *m)
{
    ix_polygon *pg = (ix_polygon *)(void *)m->out.data;

    for (size_t i = 0; i < m->out.len / sizeof *pg; i++)
        drop_polygon(m->c->ctx, &pg[i]);
    ix__buf_free(&m->out);
}

static ix_status put_uv(maker *m, ix_vertex *v, const double *uv)
{
    char text[2 * IX_NUM_MAX + 2];
    int n = ix_num_format(uv[0], text);

    text[n++] = ' ';
    n += ix_num_format(uv[1], text + n);
    text[n] = '\0';
    return ix__attr_set_string(m->c->ctx, &v->attrs, "uvvals", text);
}

/* At singular points of the surface there is no normal. */
static ix_status put_normal(maker *m, const ix_mv *srf, ix_vertex *v,
                            const double *uv, double sign)
{
    double n[3];
    ix_status st = ix_srf_normal(m->c->ctx, srf, uv[0], uv[1], n);

    if (st == IX_EDOMAIN || st == IX_EUNABLE)
        return IX_OK;
    IX_TRY(st);
    for (int c = 0; c < 3; c++)
        v->normal[c] = sign * n[c];
    v->has_normal = true;
    return IX_OK;
}

/* A polygon of n vertices of a mesh, against their order: scripts have normals
 * along dS/dv x dS/du. */
static ix_status put_face(maker *m, const ix__face *f, const ix__mesh *g, int n,
                          const uint32_t *id)
{
    ix_polygon *pg = add_polygon(m, IX_POLYGON, n);

    if (!pg)
        return IX_ENOMEM;
    for (int k = 0; k < n; k++) {
        size_t at = id[n - 1 - k];

        memcpy(pg->v[k].p, g->xyz + 3 * at, sizeof pg->v[k].p);
        if (m->normals)
            IX_TRY(put_normal(m, f->srf, &pg->v[k], g->uv + 2 * at,
                              f->reversed ? -1 : 1));
        if (m->uv)
            IX_TRY(put_uv(m, &pg->v[k], g->uv + 2 * at));
    }
    pg->has_plane = ix__polygon_plane(pg, pg->plane); /* not of a needle */
    return IX_OK;
}

/* Two triangles a b c and a c d, or a b d and b c d, as a quadrangle. */
static bool quadrangle(const uint32_t *s, const uint32_t *t, uint32_t *q)
{
    bool first = s[0] == t[0] && s[2] == t[1];
    bool second = s[1] == t[0] && s[2] == t[2];

    q[0] = s[0];
    q[1] = s[1];
    q[2] = first ? s[2] : t[1];
    q[3] = t[2];
    return first || second;
}

/* Vector from vertex a to b of a mesh. */
static void along(const ix__mesh *g, uint32_t a, uint32_t b, double v[3])
{
    for (size_t c = 0; c < 3; c++)
        v[c] = g->xyz[3 * (size_t)b + c] - g->xyz[3 * (size_t)a + c];
}

static void cross(const double a[3], const double b[3], double n[3])
{
    for (int c = 0; c < 3; c++)
        n[c] = a[(c + 1) % 3] * b[(c + 2) % 3] -
               a[(c + 2) % 3] * b[(c + 1) % 3];
}

#define FLAT 1e-9 /* sine of the angle between what counts as one plane */

/* Flat, and convex at each corner: all turns point the same way. */
static bool is_flat(const ix__mesh *g, const uint32_t q[4])
{
    double n[4][3];

    for (int k = 0; k < 4; k++) {
        double a[3], b[3], across[3];

        along(g, q[k], q[(k + 1) % 4], a);
        along(g, q[(k + 1) % 4], q[(k + 2) % 4], b);
        cross(a, b, n[k]);
        cross(n[0], n[k], across);
        if (!(hypot(hypot(across[0], across[1]), across[2]) <=
              FLAT * (n[0][0] * n[k][0] + n[0][1] * n[k][1] +
                      n[0][2] * n[k][2])) ||
            !(n[k][0] != 0 || n[k][1] != 0 || n[k][2] != 0))
            return false;
    }
    return true;
}

static ix_status put_mesh(maker *m, const ix__face *f, const ix__mesh *g)
{
    uint32_t q[4];

    for (size_t i = 0; i < g->ntris; i++) {
        if (m->quads && i + 1 < g->ntris &&
            quadrangle(g->tri[i], g->tri[i + 1], q) && is_flat(g, q)) {
            IX_TRY(put_face(m, f, g, 4, q));
            i++;
        } else {
            IX_TRY(put_face(m, f, g, 3, g->tri[i]));
        }
    }
    return IX_OK;
}

static ix_status put_faces(maker *m, int n, const ix__face *f)
{
    const int steps[2] = {m->steps, m->steps};
    ix_ctx *ctx = m->c->ctx;
    ix_status st = IX_OK;
    ix__mesh *g;

    IX_TRY(ix__mesh_of_faces(ctx, n, f, m->tol > 0 ? m->tol : m->size,
                             m->tol > 0 ? NULL : steps, &g));
    for (int i = 0; i < n; i++) {
        if (st == IX_OK)
            st = put_mesh(m, &f[i], &g[i]);
        ix__mesh_free(ctx, &g[i]);
    }
    return st;
}

/* --- lines ---------------------------------------------------------------- */

static ix_status put_lines(maker *m, const ix__lines *l)
{
    for (size_t i = 0; i < l->nlines; i++) {
        size_t first = l->start[i], n = l->start[i + 1] - first;
        ix_polygon *pg = add_polygon(m, IX_POLYLINE, (int)n);

        if (!pg)
            return IX_ENOMEM;
        for (size_t k = 0; k < n; k++)
            memcpy(pg->v[k].p, l->xyz + 3 * (first + k), sizeof pg->v[k].p);
    }
    return IX_OK;
}

/* The least tolerance is found to these parts of itself and of the size. */
#define NEARLY   1.001
#define SMALLEST 1e-12

/* As many points as RESOLUTION steps have, where the curve needs them: the
 * least tolerance that asks for no more. *out: of tolerance hi. */
static ix_status optimal_lines(maker *m, const ix_mv *crv, ix__lines *out)
{
    ix_ctx *ctx = m->c->ctx;
    double hi = m->size, lo = SMALLEST * m->size;

    IX_TRY(ix__lines_of_crv(ctx, crv, hi, out));
    while (hi > NEARLY * lo) {
        double tol = sqrt(hi) * sqrt(lo);
        ix__lines finer;
        ix_status st = ix__lines_of_crv(ctx, crv, tol, &finer);

        if (st == IX_OK && finer.npts <= (size_t)m->steps + 1) {
            ix__lines_free(ctx, out);
            *out = finer;
            hi = tol;
        } else if (st == IX_OK || st == IX_EUNABLE) {
            ix__lines_free(ctx, &finer);
            lo = tol;
        } else {
            ix__lines_free(ctx, out);
            return st;
        }
    }
    return IX_OK;
}

static ix_status put_curve(maker *m, const ix_mv *crv)
{
    ix_ctx *ctx = m->c->ctx;
    ix__lines l;
    ix_status st;

    if (m->tol > 0)
        IX_TRY(ix__lines_of_crv(ctx, crv, m->tol, &l));
    else if (m->optimal)
        IX_TRY(optimal_lines(m, crv, &l));
    else
        IX_TRY(ix__lines_even(ctx, crv, m->steps, &l));
    st = put_lines(m, &l);
    ix__lines_free(ctx, &l);
    return st;
}

/* Curve dir = part of the domain, of a surface. */
static ix_status put_iso(maker *m, const ix_mv *srf, int dir, double part)
{
    double dom[2];
    ix_status st;
    ix_mv *crv;

    ix_mv_domain(srf, dir, dom);
    IX_TRY(ix_mv_fix(m->c->ctx, srf, dir,
                     part == 1 ? dom[1] : dom[0] + (dom[1] - dom[0]) * part,
                     &crv));
    st = put_curve(m, crv);
    ix_mv_unref(m->c->ctx, crv);
    return st;
}

static ix_status put_isos(maker *m, const ix_mv *srf)
{
    for (int dir = 0; dir < 2; dir++)
        for (int i = 0; i < ISO_LINES; i++)
            IX_TRY(put_iso(m, srf, dir, (double)i / (ISO_LINES - 1)));
    return IX_OK;
}

/* The borders of faces. */
static ix_status put_borders(maker *m, int n, const ix__face *f)
{
    for (int i = 0; i < n; i++) {
        ix__lines l;
        ix_status st;

        if (f[i].nloops == 0) {
            IX_TRY(put_isos(m, f[i].srf));
            continue;
        }
        IX_TRY(ix__lines_of_face(m->c->ctx, &f[i],
                                 m->tol > 0 ? m->tol : m->size / 1000, &l));
        st = put_lines(m, &l);
        ix__lines_free(m->c->ctx, &l);
        IX_TRY(st);
    }
    return IX_OK;
}

/* --- objects -------------------------------------------------------------- */

typedef struct {
    maker *m;
    ix_status (*faces)(maker *m, int n, const ix__face *f);
    ix_status (*surface)(maker *m, const ix_mv *srf);
    ix_status (*curve)(maker *m, const ix_mv *crv); /* or NULL */
    bool lines; /* polygons become polylines, else polylines are left out */
} plan;

static ix_status whole_surface(maker *m, const ix_mv *srf)
{
    const ix__face f = {.srf = srf};

    return put_faces(m, 1, &f);
}

static ix_status do_sides(const plan *p, const ix_mv *tv)
{
    for (int i = 0; i < 6; i++) {
        double dom[2];
        ix_status st;
        ix_mv *side;

        ix_mv_domain(tv, i / 2, dom);
        IX_TRY(ix_mv_fix(p->m->c->ctx, tv, i / 2, dom[i % 2], &side));
        st = p->surface(p->m, side);
        ix_mv_unref(p->m->c->ctx, side);
        IX_TRY(st);
    }
    return IX_OK;
}

static ix_status do_mv(const plan *p, const ix_mv *mv)
{
    switch (ix_mv_ndirs(mv)) {
    case 1:
        return p->curve ? p->curve(p->m, mv) : IX_OK;
    case 2:
        return p->surface(p->m, mv);
    case 3:
        return do_sides(p, mv);
    default:
        return IX_OK;
    }
}

static ix_status do_item(const plan *p, const ix_obj *o, const void *item)
{
    ix_ctx *ctx = p->m->c->ctx;
    ix__face one, *all;

    if (o->type == IX_OBJ_TRIMSRF) {
        IX_TRY(ix__face_of_trimsrf(ctx, item, &one));
        return p->faces(p->m, 1, &one);
    }
    if (o->type == IX_OBJ_MODEL) {
        IX_TRY(ix__faces_of_model(ctx, item, &all));
        return p->faces(p->m, ((const ix_model *)item)->nsrf, all);
    }
    return o->type == IX_OBJ_TRISRF ? IX_OK : do_mv(p, item);
}

/* Polygons as they are, or closed polylines of them. */
static ix_status do_polygon(const plan *p, const ix_polygon *from)
{
    bool close = p->lines && from->kind == IX_POLYGON && from->n > 0;
    ix_polygon *pg;

    if (!p->lines && from->kind != IX_POLYGON)
        return IX_OK;
    pg = add_polygon(p->m, p->lines ? IX_POLYLINE : IX_POLYGON,
                     p->lines ? from->n + close : 0);
    if (!pg)
        return IX_ENOMEM;
    if (!p->lines)
        return ix__polygon_dup(p->m->c->ctx, from, pg);
    for (int k = 0; k < pg->n; k++)
        memcpy(pg->v[k].p, from->v[k % from->n].p, sizeof pg->v[k].p);
    return IX_OK;
}

static ix_status do_leaf(void *arg, const ix_obj *o)
{
    const plan *p = arg;
    ix_mark mk = ix__scratch_mark(p->m->c->ctx);
    ix_status st = IX_OK;

    for (int i = 0; i < ix__seq_count(o) && st == IX_OK; i++)
        st = do_item(p, o, ix__seq_item(o, i));
    for (int i = 0; o->type == IX_OBJ_POLY && i < o->u.poly->n && st == IX_OK;
         i++)
        st = do_polygon(p, &o->u.poly->poly[i]);
    ix__scratch_release(p->m->c->ctx, mk);
    return st;
}

static ix_status make(maker *m, plan *p)
{
    double n = fmin(fmax(ix__var_num(m->c->in, "RESOLUTION", 20), 1),
                    MOST_STEPS);

    p->m = m;
    m->steps = (int)n;
    if (ix__var_num(m->c->in, "POLY_APPROX_OPT", 0) != 0)
        m->tol = fmax(ix__var_num(m->c->in, "POLY_APPROX_TOL", 0), 0);
    IX_TRY(ix__shape_tol(m->c->ctx, m->c->argv[0], &m->size));
    m->size *= 1000;
    return ix__walk_leaves(m->c->argv[0], do_leaf, p);
}

/* --- the functions ---------------------------------------------------------
 */

static ix_status gpolygon(ix_call *c)
{
    maker m = {.c = c,
               .normals = ix__arg_bool(c, 1),
               .quads = ix__var_num(c->in, "POLY_APPROX_TRI", 0) == 0,
               .uv = ix__var_num(c->in, "POLY_APPROX_UV", 0) != 0};
    plan p = {.faces = put_faces, .surface = whole_surface};
    ix_status st;

    ix__buf_init(&m.out, c->ctx);
    st = make(&m, &p);
    if (st == IX_OK)
        st = finish(&m, "surface or polygon");
    drop(&m);
    return st;
}

static ix_status lines(ix_call *c, maker *m)
{
    plan p = {.faces = put_borders,
              .surface = put_isos,
              .curve = put_curve,
              .lines = true};

    m->c = c;
    m->optimal = ix__arg_bool(c, 1);
    ix__buf_init(&m->out, c->ctx);
    return make(m, &p);
}

static ix_status gpolyline(ix_call *c)
{
    maker m = {0};
    ix_status st = lines(c, &m);

    if (st == IX_OK)
        st = finish(&m, "curve, surface or polyline");
    drop(&m);
    return st;
}

/* All points in one list. */
static ix_status merge(maker *m)
{
    size_t n = m->out.len / sizeof(ix_polygon), total = 0;
    const ix_polygon *from = (const ix_polygon *)(void *)m->out.data;
    ix_polygon *all;

    for (size_t i = 0; i < n; i++)
        total += (size_t)from[i].n;
    if (total > INT_MAX)
        return IX_FAIL(m->c->ctx, IX_EUNABLE, "%zu points are too many", total);
    all = total > 0 ? add_polygon(m, IX_POINTLIST, (int)total) : NULL;
    if (!all)
        return total > 0 ? IX_ENOMEM : IX_OK;
    from = (const ix_polygon *)(void *)m->out.data;
    total = 0;
    for (size_t i = 0; i < n; i++)
        for (int k = 0; k < from[i].n; k++)
            memcpy(all->v[total++].p, from[i].v[k].p, sizeof all->v[0].p);
    for (size_t i = 0; i < n; i++)
        drop_polygon(m->c->ctx, (ix_polygon *)(void *)m->out.data + i);
    memmove(m->out.data, all, sizeof *all);
    m->out.len = sizeof *all;
    return IX_OK;
}

static ix_status gpointlist(ix_call *c)
{
    maker m = {0};
    ix_status st = lines(c, &m);
    ix_polygon *pg;

    if (st == IX_OK && ix__arg_bool(c, 2))
        st = merge(&m);
    pg = (ix_polygon *)(void *)m.out.data;
    for (size_t i = 0; i < m.out.len / sizeof *pg; i++)
        pg[i].kind = IX_POINTLIST;
    if (st == IX_OK)
        st = finish(&m, "curve, surface or polyline");
    drop(&m);
    return st;
}

#define C "c = circle(vector(0,0,0), 1); "

const ix_builtin ix__builtins_tess[] = {
    {"GPOLYGON", "x:list|geom normals:bool -> poly",
     "Surfaces, trimmed surfaces, models as polygons: RESOLUTION steps in each "
     "direction, or within POLY_APPROX_TOL if POLY_APPROX_OPT is not 0; "
     "with POLY_APPROX_TRI triangles only; vertices with normals as of "
     "SNORMAL, "
     "with POLY_APPROX_UV attributes uvvals.",
     C "s = ruledSrf(c, c * tz(1)); o = gpolygon(s, true);", gpolygon, 0, 23},
    {"GPOLYLINE", "x:list|geom optimal:bool -> poly",
     "Curves as polylines, surfaces as ten isoparametric lines in each "
     "direction, trimmed ones as their borders: RESOLUTION equal steps, with "
     "optimal so many where they are needed; or within POLY_APPROX_TOL if "
     "POLY_APPROX_OPT is not 0.",
     C "o = gpolyline(c, false);", gpolyline, 0, 23},
    {"GPOINTLIST", "x:list|geom optimal:bool merge:bool -> poly",
     "The points of GPOLYLINE as point lists, or with merge one list.",
     C "o = gpointlist(c, false, true);", gpointlist, 0, 23},
    {0}};
