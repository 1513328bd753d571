/* builtins_arrange.c - CARNGMNT2: arrangements of planar curves, step by step
 * (chapter 9 of spec/functions, docs/ops/arrangement.md). */
#include <math.h>
#include <string.h>

#include "geom/matrix.h"
#include "lang/args_freeform.h"
#include "lang/arrangements.h"
#include "mv/mv.h"
#include "mv/tessellate.h"

#define RADIANS (3.14159265358979324 / 180)

/* One call: its operation's parameters, and what it works on. */
typedef struct {
    ix_call *c;
    double *num; /* the parameters; not of operation 8 */
    ix__kept *k;
} job;

static ix_status ret_name(const job *j, const ix__kept *k)
{
    return ix__ret(j->c, ix__obj_string(j->c->ctx, k->name, strlen(k->name)));
}

/* --- 1: curves -------------------------------------------------------------
 */

typedef struct {
    ix_call *c;
    int mask, n, room;
    ix_mv **crv;
} gathered;

/* Takes over m. */
static ix_status gather(gathered *g, ix_mv *m)
{
    if (g->n == g->room) {
        int room = 2 * g->room + 32;
        ix_mv **more = ix__scratch(g->c->ctx, (size_t)room,
                                   sizeof(const ix_mv *));

        if (!more) {
            ix_mv_unref(g->c->ctx, m);
            return IX_ENOMEM;
        }
        if (g->n)
            memcpy(more, g->crv, (size_t)g->n * sizeof(const ix_mv *));
        g->crv = more;
        g->room = room;
    }
    g->crv[g->n++] = m;
    return IX_OK;
}

/* A polyline, or a polygon with its first vertex once more. */
static ix_status gather_polygon(gathered *g, const ix_polygon *p)
{
    int n = p->n + (p->kind == IX_POLYGON);
    double *pts;
    ix_obj *o;
    ix_status st;

    if (p->n < 2)
        return IX_OK;
    IX_SCRATCH(g->c->ctx, pts, 3 * n);
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++)
            pts[i + k * n] = p->v[i % p->n].p[k];
    IX_TRY(ix__polyline_curve(g->c, n, 3, pts, &o));
    st = gather(g, ix_mv_ref(ix__obj_first_mv(o)));
    ix__obj_unref(g->c->ctx, o);
    return st;
}

static ix_status gather_borders(gathered *g, const ix_mv *s)
{
    for (int i = 0; i < 4; i++) {
        double dom[2];
        ix_mv *m;

        ix_mv_domain(s, i / 2, dom);
        IX_TRY(ix_mv_fix(g->c->ctx, s, i / 2, dom[i % 2], &m));
        IX_TRY(gather(g, m));
    }
    return IX_OK;
}

#define NESTED 16 /* lists in lists */

static ix_status gather_object(gathered *g, const ix_obj *o, int number,
                               int depth)
{
    if (o->type == IX_OBJ_LIST && depth < NESTED) {
        for (int i = 0; i < o->u.list.n; i++)
            IX_TRY(gather_object(g, o->u.list.item[i], i + 1, depth + 1));
        return IX_OK;
    }
    if (o->type == IX_OBJ_POLY) {
        for (int i = 0; (g->mask & 2) && i < o->u.poly->n; i++)
            IX_TRY(gather_polygon(g, &o->u.poly->poly[i]));
        return IX_OK;
    }
    if (o->type != IX_OBJ_CURVE && o->type != IX_OBJ_SURFACE)
        return ix__wrong_element(g->c, 0, number - 1, o,
                                 "a curve, polygon or surface");
    for (int i = 0; i < o->u.mvs->n; i++) {
        if (o->type == IX_OBJ_CURVE && (g->mask & 1))
            IX_TRY(gather(g, ix_mv_ref(o->u.mvs->mv[i])));
        if (o->type == IX_OBJ_SURFACE && (g->mask & 4))
            IX_TRY(gather_borders(g, o->u.mvs->mv[i]));
    }
    return IX_OK;
}

/* Into the XY plane; back leads out of it again. */
static ix_status lay_flat(gathered *g, double tol, bool project,
                          double back[16])
{
    double m[16];

    ix__mat_identity(back);
    if (project)
        return IX_OK;
    IX_TRY(
        ix_crvs_plane(g->c->ctx, g->n, (const ix_mv *const *)g->crv, tol, m));
    (void)ix__mat_inverse(m, back); /* a motion */
    for (int i = 0; i < g->n; i++) {
        ix_mv *flat, *three;
        ix_status st;

        IX_TRY(ix_mv_coerce(g->c->ctx, g->crv[i], 3, ix_mv_rational(g->crv[i]),
                            &three));
        st = ix_mv_transform(g->c->ctx, three, m, &flat);
        ix_mv_unref(g->c->ctx, three);
        IX_TRY(st);
        ix_mv_unref(g->c->ctx, g->crv[i]);
        g->crv[i] = flat;
    }
    return IX_OK;
}

static ix_status create(job *j)
{
    gathered g = {.c = j->c, .mask = (int)j->num[3]};
    ix_arrangement *a = NULL;
    double back[16];
    ix_status st;

    if (!(j->num[3] >= 1 && j->num[3] <= 7))
        return IX_ARG_FAIL(j->c, 2,
                           "mask %g; it is a sum of 1 (curves), 2 (polygons), "
                           "4 (borders of surfaces)",
                           j->num[3]);
    st = gather_object(&g, j->c->argv[0], 1, 0);
    if (st == IX_OK)
        st = lay_flat(&g, j->num[1], fabs(j->num[2]) >= 1e-5, back);
    if (st == IX_OK)
        st = ix_arrangement_new(j->c->ctx, g.n, (const ix_mv *const *)g.crv,
                                j->num[0], &a);
    for (int i = 0; i < g.n; i++)
        ix_mv_unref(j->c->ctx, g.crv[i]);
    IX_TRY(st);
    IX_TRY(ix__kept_add(j->c->in, a, back, &j->k));
    return ret_name(j, j->k);
}

/* --- 2 to 12, 15: steps
 * ---------------------------------------------------------- */

static ix_status copy(job *j)
{
    ix_arrangement *a;
    ix__kept *k;

    IX_TRY(ix_arrangement_copy(j->c->ctx, j->k->a, &a));
    IX_TRY(ix__kept_add(j->c->in, a, j->k->back, &k));
    return ret_name(j, k);
}

static ix_status drop_copies(job *j)
{
    return ix_arrangement_drop_copies(j->c->ctx, j->k->a, j->num[0]);
}

static ix_status drop_overlaps(job *j)
{
    return ix_arrangement_drop_overlaps(j->c->ctx, j->k->a, j->num[0]);
}

static ix_status split_special(job *j)
{
    double what = round(j->num[0]);

    if (!(what >= 0 && what <= 15))
        return IX_ARG_FAIL(j->c, 2,
                           "mask %g; it is a sum of 1 (inflections), 2 (x "
                           "extremes), 4 (y extremes), 8 (curvature extremes)",
                           what);
    return ix_arrangement_split_special(j->c->ctx, j->k->a, (unsigned)what,
                                        j->num[1]);
}

static ix_status split_corners(job *j)
{
    return ix_arrangement_split_corners(j->c->ctx, j->k->a,
                                        j->num[0] * RADIANS);
}

static ix_status split_meetings(job *j)
{
    return ix_arrangement_split_meetings(j->c->ctx, j->k->a, j->num[0]);
}

/* list(points, tol): the points in the curves' space. */
static ix_status split_near(job *j)
{
    const ix_list *l = &j->c->argv[2]->u.list;
    const ix_list *in;
    double(*p)[3], m[16];

    if (l->item[0]->type != IX_OBJ_LIST || l->item[1]->type != IX_OBJ_NUMBER)
        return IX_ARG_FAIL(j->c, 2, "list(points, tolerance) is wanted");
    in = &l->item[0]->u.list;
    (void)ix__mat_inverse(j->k->back, m);
    IX_SCRATCH(j->c->ctx, p, in->n);
    for (int i = 0; i < in->n; i++) {
        const ix_obj *o = in->item[i];

        if (o->type != IX_OBJ_POINT && o->type != IX_OBJ_VECTOR)
            return ix__wrong_element(j->c, 2, i, o, "a point or vector");
        (void)ix__mat_point(o->u.pt, m, p[i]);
    }
    return ix_arrangement_split_near(j->c->ctx, j->k->a, in->n,
                                     (const double(*)[3])p, l->item[1]->u.num);
}

static ix_status merge(job *j)
{
    return ix_arrangement_merge(j->c->ctx, j->k->a, j->num[0] * RADIANS);
}

static ix_status fit(job *j)
{
    double order = round(j->num[1]);

    if (!(order >= 2 && order <= 32))
        return IX_ARG_FAIL(j->c, 2, "order %g is not within 2 .. 32", order);
    return ix_arrangement_fit(j->c->ctx, j->k->a, j->num[0], (int)order);
}

static ix_status evaluate(job *j)
{
    return ix_arrangement_evaluate(j->c->ctx, j->k->a, fabs(j->num[0]) >= 1e-5);
}

static ix_status classify(job *j)
{
    return ix_arrangement_classify(j->c->ctx, j->k->a);
}

static ix_status drop(job *j)
{
    ix__kept_drop(j->c->in, j->k);
    return ix__ret_num(j->c, 1);
}

/* --- 13: report ------------------------------------------------------------
 */

static void put_vertices(const ix_arrangement *a, ix_buf *b)
{
    for (int v = 0; v < a->nvertices; v++)
        ix__buf_printf(b, "vertex %d: (%.10g, %.10g), %d edges\n", v,
                       a->vertex[v].p[0], a->vertex[v].p[1],
                       a->vertex[v].degree);
}

static void put_edges(const ix_arrangement *a, ix_buf *b)
{
    for (int e = 0; e < a->nedges; e++) {
        const ix_arr_edge *d = &a->edge[e];

        ix__buf_printf(b, "curve %d: of input %d, turns %d", e, d->source,
                       d->turns);
        if (a->evaluated)
            ix__buf_printf(b, ", vertices %d to %d, faces %d | %d",
                           d->vertex[0], d->vertex[1], d->face[0], d->face[1]);
        ix__buf_putc(b, '\n');
    }
}

static void put_faces(const ix_arrangement *a, ix_buf *b)
{
    for (int f = 0; f < a->nfaces; f++) {
        ix__buf_printf(b, "face %d: area %.10g, in face %d", f, a->face[f].area,
                       a->face[f].parent);
        if (a->classified)
            ix__buf_printf(b, ", depth %d, winding %d", a->face[f].depth,
                           a->face[f].winding);
        ix__buf_putc(b, '\n');
    }
}

/* Vertices that an edge reaches; edges that take part are half their ends. */
static int reached(const ix_arrangement *a)
{
    int n = 0;

    for (int v = 0; v < a->nvertices; v++)
        n += a->vertex[v].degree > 0;
    return n;
}

static ix_status report(job *j)
{
    const ix_arrangement *a = j->k->a;
    const double counts[5] = {a->nedges, reached(a), 0.5 * a->nhalf, a->nfaces,
                              a->ncomponents};
    int mask = (int)round(j->num[0]);
    ix_status st;
    ix_buf b;

    if (!(j->num[0] >= 0 && j->num[0] <= 15))
        return IX_ARG_FAIL(j->c, 2,
                           "mask %g; it is a sum of 1 (counts), 2 (vertices), "
                           "4 (curves), 8 (faces)",
                           j->num[0]);
    ix__buf_init(&b, j->c->ctx);
    if (mask & 1)
        ix__buf_printf(&b,
                       "%s: %d curves; %d vertices, %d edges, %d faces, %d "
                       "components\n",
                       j->k->name, a->nedges, reached(a), a->nhalf / 2,
                       a->nfaces, a->ncomponents);
    if (mask & 2)
        put_vertices(a, &b);
    if (mask & 4)
        put_edges(a, &b);
    if (mask & 8)
        put_faces(a, &b);
    st = ix__buf_check(&b);
    if (st == IX_OK && b.len)
        ix__out(j->c->in, b.data, b.len);
    ix__buf_free(&b);
    IX_TRY(st);
    return ix__ret_nums(j->c, 5, counts);
}

/* --- 14: output ------------------------------------------------------------
 */

/* Where item number i goes: lifted by its height, then out of the plane. */
static void place_of(const job *j, int i, double m[16])
{
    const double up[3] = {0, 0, i * j->num[2]};

    ix__mat_translate(up, m);
    ix__mat_mul(m, j->k->back, m);
}

static bool stays(const double m[16])
{
    double one[16];

    ix__mat_identity(one);
    return memcmp(one, m, sizeof one) == 0;
}

/* A curve of the plane as an object, in three coordinates if it leaves the
 * plane. Takes over crv. */
static ix_status placed(const job *j, ix_mv *crv, int i, ix_obj **out)
{
    ix_mv *three = NULL, *moved = NULL;
    ix_status st = IX_OK;
    double m[16];

    *out = NULL;
    place_of(j, i, m);
    if (stays(m)) {
        *out = ix__obj_mv(j->c->ctx, IX_OBJ_CURVE, crv);
        return *out ? IX_OK : IX_ENOMEM;
    }
    st = ix_mv_coerce(j->c->ctx, crv, 3, ix_mv_rational(crv), &three);
    if (st == IX_OK)
        st = ix_mv_transform(j->c->ctx, three, m, &moved);
    ix_mv_unref(j->c->ctx, crv);
    ix_mv_unref(j->c->ctx, three);
    IX_TRY(st);
    *out = ix__obj_mv(j->c->ctx, IX_OBJ_CURVE, moved);
    return *out ? IX_OK : IX_ENOMEM;
}

typedef struct {
    const char *name;
    long long value;
} mark;

static ix_status set_marks(ix_call *c, ix_obj *o, int n, const mark *m)
{
    for (int i = 0; i < n; i++)
        IX_TRY(ix__attr_set_int(c->ctx, &o->attrs, m[i].name, m[i].value));
    return IX_OK;
}

/* Appends o, if st is IX_OK. */
static ix_status add_or_drop(ix_call *c, ix_obj *list, ix_obj *o, ix_status st)
{
    if (st == IX_OK)
        return ix__list_add(c->ctx, list, o);
    ix__obj_unref(c->ctx, o);
    return st;
}

static ix_status out_edges(const job *j, ix_obj *list)
{
    const ix_arrangement *a = j->k->a;

    for (int e = 0; e < a->nedges; e++) {
        const ix_arr_edge *d = &a->edge[e];
        const mark m[6] = {
            {"Source", d->source},         {"Turns", d->turns},
            {"LeftFace", d->face[0]},      {"RightFace", d->face[1]},
            {"StartVertex", d->vertex[0]}, {"EndVertex", d->vertex[1]}};
        ix_obj *o;

        IX_TRY(placed(j, ix_mv_ref(d->crv), e, &o));
        IX_TRY(add_or_drop(j->c, list, o,
                           set_marks(j->c, o, a->evaluated ? 6 : 2, m)));
    }
    return IX_OK;
}

static ix_status set_face(const job *j, ix_obj *o, int f)
{
    const ix_arr_face *p = &j->k->a->face[f];
    const mark m[4] = {{"Face", f},
                       {"Parent", p->parent},
                       {"Depth", p->depth},
                       {"Winding", p->winding}};

    IX_TRY(set_marks(j->c, o, j->k->a->classified ? 4 : 2, m));
    return ix__attr_set_real(j->c->ctx, &o->attrs, "Area", p->area);
}

static ix_status out_loops(const job *j, ix_obj *list)
{
    const ix_arrangement *a = j->k->a;

    for (int l = 0; l < a->nloops; l++) {
        int f = a->loop[l].face;
        const mark hole = {"Hole", a->face[f].outer != l};
        ix_mv *crv;
        ix_status st;
        ix_obj *o;

        if (f == 0)
            continue;
        IX_TRY(ix_arrangement_loop_curve(j->c->ctx, a, l, &crv));
        IX_TRY(placed(j, crv, f - 1, &o));
        st = set_face(j, o, f);
        if (st == IX_OK)
            st = set_marks(j->c, o, 1, &hole);
        IX_TRY(add_or_drop(j->c, list, o, st));
    }
    return IX_OK;
}

/* The rectangle of a box, by x and y, where item i goes. */
static ix_status sheet(const job *j, const double lo[2], const double hi[2],
                       int i, ix_mv **out)
{
    const double ku[4] = {lo[0], lo[0], hi[0], hi[0]};
    const double kv[4] = {lo[1], lo[1], hi[1], hi[1]};
    const ix_dir d[2] = {
        {.basis = IX_BSPLINE, .order = 2, .length = 2, .knots = ku},
        {.basis = IX_BSPLINE, .order = 2, .length = 2, .knots = kv}};
    const double pts[12] = {lo[0], hi[0], lo[0], hi[0], lo[1], lo[1],
                            hi[1], hi[1], 0,     0,     0,     0};
    double m[16];
    ix_mv *flat;
    ix_status st;

    place_of(j, i, m);
    IX_TRY(ix_mv_new(j->c->ctx, 2, d, 3, false, pts, &flat));
    st = ix_mv_transform(j->c->ctx, flat, m, out);
    ix_mv_unref(j->c->ctx, flat);
    return st;
}

static ix_status trim_by(const job *j, int f, ix_trimsrf *t)
{
    const ix_arrangement *a = j->k->a;
    int n = 0;

    for (int l = 0; l < a->nloops; l++) {
        ix_mv *crv;

        if (a->loop[l].face != f)
            continue;
        IX_TRY(ix__trimloop_segs(j->c->ctx, &t->loop[n], 1));
        IX_TRY(ix_arrangement_loop_curve(j->c->ctx, a, l, &crv));
        t->loop[n++].seg[0].uv = crv;
    }
    return IX_OK;
}

/* Face f as a trimmed plane. */
static ix_status trimmed(const job *j, int f, ix_obj **out)
{
    const ix_arrangement *a = j->k->a;
    double lo[2], hi[2];
    ix_mv *crv, *srf = NULL;
    ix_trimsrf *t = NULL;
    ix_status st;
    int n = 0;

    *out = NULL;
    for (int l = 0; l < a->nloops; l++)
        n += a->loop[l].face == f;
    IX_TRY(ix_arrangement_loop_curve(j->c->ctx, a, a->face[f].outer, &crv));
    st = ix_mv_bbox(j->c->ctx, crv, lo, hi);
    ix_mv_unref(j->c->ctx, crv);
    if (st == IX_OK)
        st = sheet(j, lo, hi, f - 1, &srf);
    if (st == IX_OK) {
        t = ix__trimsrf_new(j->c->ctx, srf, n);
        st = t ? trim_by(j, f, t) : IX_ENOMEM;
    }
    ix_mv_unref(j->c->ctx, srf);
    if (st == IX_OK) {
        *out = ix__obj_trimsrf(j->c->ctx, t);
        return *out ? IX_OK : IX_ENOMEM;
    }
    if (t)
        ix__trimsrf_unref(j->c->ctx, t);
    return st;
}

static ix_status out_faces(const job *j, ix_obj *list)
{
    for (int f = 1; f < j->k->a->nfaces; f++) {
        ix_obj *o;

        IX_TRY(trimmed(j, f, &o));
        IX_TRY(add_or_drop(j->c, list, o, set_face(j, o, f)));
    }
    return IX_OK;
}

/* One curve as a polyline within the tolerance. */
static ix_status polyline(const job *j, int e, ix_polygon *pg)
{
    ix__lines l;
    double m[16];
    ix_status st;

    place_of(j, e, m);
    IX_TRY(ix__lines_of_crv(j->c->ctx, j->k->a->edge[e].crv, j->num[1], &l));
    pg->kind = IX_POLYLINE;
    st = ix__poly_vertices(j->c->ctx, pg, (int)l.npts);
    for (size_t i = 0; st == IX_OK && i < l.npts; i++)
        (void)ix__mat_point(l.xyz + 3 * i, m, pg->v[i].p);
    ix__lines_free(j->c->ctx, &l);
    return st;
}

static ix_status out_polylines(const job *j)
{
    const ix_arrangement *a = j->k->a;
    ix_poly *p = ix__poly_new(j->c->ctx, a->nedges);
    ix_status st = p ? IX_OK : IX_ENOMEM;

    for (int e = 0; st == IX_OK && e < a->nedges; e++)
        st = polyline(j, e, &p->poly[e]);
    if (st == IX_OK)
        return ix__ret(j->c, ix__obj_poly(j->c->ctx, p));
    if (p)
        ix__poly_unref(j->c->ctx, p);
    return st;
}

static ix_status output(job *j)
{
    int style = (int)round(j->num[0]);
    ix_obj *list;
    ix_status st;

    if (!(j->num[0] >= 0.5 && j->num[0] < 4.5))
        return IX_ARG_FAIL(j->c, 2,
                           "style %g; 1 gives the curves, 2 the loops, 3 the "
                           "faces, 4 polylines",
                           j->num[0]);
    if ((style == 2 || style == 3) && !j->k->a->evaluated)
        return IX_ARG_FAIL(j->c, 0,
                           "%s has no faces yet: operation 11 finds them",
                           j->k->name);
    if (style == 4 && !(j->num[1] > 0))
        return IX_ARG_FAIL(j->c, 2,
                           "a tolerance of %g; polylines need a positive one",
                           j->num[1]);
    if (style == 4)
        return out_polylines(j);
    list = ix__obj_list(j->c->ctx);
    st = !list        ? IX_ENOMEM
         : style == 1 ? out_edges(j, list)
         : style == 2 ? out_loops(j, list)
                      : out_faces(j, list);
    return ix__ret_list(j->c, list, st);
}

/* --- the call --------------------------------------------------------------
 */

static const struct {
    int n; /* parameters */
    const char *params;
    ix_status (*run)(job *j);
} operation[15] = {{4, "list(endTol, planarTol, project, mask)", create},
                   {0, "an empty list", copy},
                   {1, "list(tol)", drop_copies},
                   {1, "list(tol)", drop_overlaps},
                   {2, "list(mask, tol)", split_special},
                   {1, "list(degrees)", split_corners},
                   {1, "list(tol)", split_meetings},
                   {2, "list(points, tol)", split_near},
                   {1, "list(degrees)", merge},
                   {2, "list(tol, order)", fit},
                   {1, "list(ignoreHanging)", evaluate},
                   {0, "an empty list", classify},
                   {1, "list(mask)", report},
                   {3, "list(style, tol, zOffset)", output},
                   {0, "an empty list", drop}};

enum { CREATE = 0, SPLIT_NEAR = 7 };

static ix_status find_kept(job *j, int op)
{
    const ix_obj *o = j->c->argv[0];

    if (op == CREATE) {
        if (o->type == IX_OBJ_STRING)
            return IX_ARG_FAIL(j->c, 0, "operation 1 takes curves");
        return IX_OK;
    }
    if (o->type != IX_OBJ_STRING)
        return IX_ARG_FAIL(j->c, 0,
                           "operation %d takes the name of an arrangement, as "
                           "operation 1 gives it",
                           op + 1);
    j->k = ix__kept_find(j->c->in, o->u.str.s);
    if (!j->k)
        return IX_ARG_FAIL(j->c, 0, "there is no arrangement \"%s\"",
                           o->u.str.s);
    return IX_OK;
}

static ix_status carngmnt2(ix_call *c)
{
    job j = {.c = c};
    ix_status st;
    int op, n;

    IX_TRY(ix__arg_int(c, 1, 1, 15, &op));
    op--;
    if (c->argv[2]->u.list.n != operation[op].n)
        return IX_ARG_FAIL(c, 2, "%d parameters; operation %d takes %s",
                           c->argv[2]->u.list.n, op + 1, operation[op].params);
    if (op != SPLIT_NEAR)
        IX_TRY(ix__arg_nums(c, 2, &n, &j.num));
    IX_TRY(find_kept(&j, op));
    st = operation[op].run(&j);
    if (st == IX_EARG && !c->bad_arg)
        c->bad_arg = 3; /* the arrangement itself has been looked up */
    IX_TRY(st);
    return c->result ? IX_OK : ret_name(&j, j.k);
}

const ix_builtin ix__builtins_arrange[] = {
    {"CARNGMNT2", "crvs:list|curve|poly|surface|str op:num params:list -> any",
     "An arrangement of planar curves, kept under a name and changed step by "
     "step; its name is the value, unless stated. op 1 makes one of curves, "
     "list(endTol, planarTol, project, mask), mask a sum of 1 curves, 2 "
     "polygons, 4 borders of surfaces; all others take the name: 2 copies; 3 "
     "drops copies of curves, list(tol); 4 those of parts that run together, "
     "list(tol); cuts: 5 at special points, list(mask, tol), 1 inflections, 2 "
     "x "
     "and 4 y extremes, 8 curvature extremes; 6 at corners, list(degrees); 7 "
     "at "
     "intersections, list(tol); 8 near points, list(points, tol); 9 merges at "
     "ends that turn less, list(degrees); 10 fits B-splines, list(tol, order); "
     "11 finds vertices and faces, list(ignoreHanging); 12 their depths and "
     "windings; 13 prints, list(mask), 1 counts, 2 vertices, 4 curves, 8 "
     "faces, "
     "and gives list(curves, vertices, edges, faces, components); 14 gives, "
     "list(style, tol, zOffset), 1 the curves, 2 the loops around faces, 3 the "
     "faces as trimmed planes, 4 polylines within tol; 15 frees it and gives "
     "1. "
     "See docs/ops/arrangement.md.",
     "c = circle(vector(0,0,0), 1); a = carngmnt2(list(c, c * tx(1)), 1, "
     "list(1e-6, 1e-6, true, 1)); a = carngmnt2(a, 7, list(1e-7)); a = "
     "carngmnt2(a, 11, list(false)); l = carngmnt2(a, 14, list(3, 0, 0));",
     carngmnt2, IX_B_STATE, 9},
    {0}};
