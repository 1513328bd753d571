/* operators_geom.c - operators that join, move and multiply geometry. An
 * object that links several curves counts with its first one. */
#include <math.h>
#include <string.h>

#include "iritx/sym.h"
#include "lang/codes.h"
#include "lang/interp_impl.h"
#include "lang/operators_impl.h"

/* End points nearer than this are one (spec/model 12). */
#define SAME_POINT 1e-5

/* A new box (NULL: no memory) with the attributes of a. */
static ix_status like(ix_interp *in, const ix_obj *a, ix_obj *box, ix_obj **out)
{
    ix_status st;

    if (!box)
        return IX_ENOMEM;
    st = ix__attr_copy_all(in->ctx, a->attrs, &box->attrs);
    if (st == IX_OK)
        *out = box;
    else
        ix__obj_unref(in->ctx, box);
    return st;
}

static ix_obj *mv_box(ix_interp *in, const ix_mv *m)
{
    return ix__obj_mv(in->ctx, ix__obj_type_of_mv(m), m);
}

/* --- control points and curves
 * ------------------------------------------------------ */

/* Coordinate c of a control point, 0 beyond its own. */
static double coordinate(const ix_ctlpt *p, int c)
{
    return c < p->ncoords ? p->v[c + p->rational] : 0;
}

/* Trailing coordinates that are 0 in both points do not count. */
static int common_coords(const ix_ctlpt *a, const ix_ctlpt *b)
{
    int n = a->ncoords > b->ncoords ? a->ncoords : b->ncoords;

    while (n > 1 && coordinate(a, n - 1) == 0 && coordinate(b, n - 1) == 0)
        n--;
    return n;
}

ix_status ix__op_add_ctlpt(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    const ix_ctlpt *p[2] = {l->u.ctlpt, r->u.ctlpt};
    bool rational = p[0]->rational || p[1]->rational;
    int n = common_coords(p[0], p[1]);
    double pts[2 * (IX_MAX_COORDS + 1)];
    const ix_dir line = {.basis = IX_BEZIER, .order = 2, .length = 2};
    ix_mv *m;
    ix_status st;

    for (int i = 0; i < 2; i++) {
        if (rational)
            pts[i] = p[i]->rational ? p[i]->v[0] : 1;
        for (int c = 0; c < n; c++)
            pts[2 * (c + rational) + i] = coordinate(p[i], c);
    }
    IX_TRY(ix_mv_new(in->ctx, 1, &line, n, rational, pts, &m));
    *out = mv_box(in, m);
    if (!*out)
        return IX_ENOMEM;
    st = ix__attr_set_int(in->ctx, &(*out)->attrs, "GeomType", IX__GEOM_LINEAR);
    if (st != IX_OK) {
        ix__obj_unref(in->ctx, *out);
        *out = NULL;
    }
    return st;
}

/* The curve and the point in one point type; p in axis order. */
static ix_status unify(ix_interp *in, const ix_mv *m, const ix_ctlpt *q,
                       ix_mv **curve, double *p)
{
    bool rational = q->rational || ix_mv_rational(m);
    int n = ix_mv_ncoords(m) > q->ncoords ? ix_mv_ncoords(m) : q->ncoords;

    if (rational)
        p[0] = q->rational ? q->v[0] : 1;
    for (int c = 0; c < n; c++)
        p[c + rational] = coordinate(q, c);
    return ix_mv_coerce(in->ctx, m, n, rational, curve);
}

static ix_status add_point(ix_interp *in, const ix_obj *crv, const ix_obj *pt,
                           bool before, ix_mv **out)
{
    double p[IX_MAX_COORDS + 1];
    ix_mv *m;
    ix_status st;

    IX_TRY(unify(in, ix__obj_first_mv(crv), pt->u.ctlpt, &m, p));
    st = ix_mv_add_point(in->ctx, m, p, before, out);
    ix_mv_unref(in->ctx, m);
    return st;
}

/* True if a ends where b begins. */
static ix_status meet(ix_interp *in, const ix_mv *a, const ix_mv *b, bool *yes)
{
    double pa[IX_MAX_COORDS] = {0}, pb[IX_MAX_COORDS] = {0}, dom[2], sum = 0;

    ix_mv_domain(a, 0, dom);
    IX_TRY(ix_mv_point(in->ctx, a, &dom[1], pa));
    ix_mv_domain(b, 0, dom);
    IX_TRY(ix_mv_point(in->ctx, b, &dom[0], pb));
    for (int c = 0; c < IX_MAX_COORDS; c++)
        sum += (pa[c] - pb[c]) * (pa[c] - pb[c]);
    *yes = sqrt(sum) < SAME_POINT &&
           (ix_mv_order(a, 0) > 1 || ix_mv_order(b, 0) > 1);
    return IX_OK;
}

static ix_status join(ix_interp *in, const ix_mv *a, const ix_mv *b,
                      ix_mv **out)
{
    bool shared;

    IX_TRY(meet(in, a, b, &shared));
    return ix_mv_merge(in->ctx, a, b, 0,
                       shared ? IX_JOIN_SHARED : IX_JOIN_BRIDGE, out);
}

ix_status ix__op_add_curve(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    ix_mv *m;

    if (l->type == IX_OBJ_CTLPT)
        IX_TRY(add_point(in, r, l, true, &m));
    else if (r->type == IX_OBJ_CTLPT)
        IX_TRY(add_point(in, l, r, false, &m));
    else
        IX_TRY(join(in, ix__obj_first_mv(l), ix__obj_first_mv(r), &m));
    return like(in, l, mv_box(in, m), out);
}

ix_status ix__op_dot_freeform(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    const ix_obj *v = l->type == IX_OBJ_VECTOR ? l : r;
    const ix_mv *m = ix__obj_first_mv(v == l ? r : l);
    double pad[IX_MAX_COORDS] = {v->u.pt[0], v->u.pt[1], v->u.pt[2]};
    ix_mv *dot;

    IX_TRY(ix_sym_dot_vector(in->ctx, m, pad, &dot));
    *out = mv_box(in, dot);
    return *out ? IX_OK : IX_ENOMEM;
}

ix_status ix__op_transform(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    /* list * matrix: the right one is the matrix, unless only the left is. */
    bool right = r->type == IX_OBJ_MATRIX;

    return ix__obj_transform(in->ctx, right ? l : r,
                             right ? r->u.mat : l->u.mat, out);
}

/* --- polys
 * ----------------------------------------------------------------------------
 */

/* Copies p with one more vertex of its polygon, at its beginning or end. */
static ix_status with_vertex(ix_interp *in, const ix_poly *p,
                             const double pt[3], bool before, ix_poly **out)
{
    ix_poly *q = ix__poly_dup(in->ctx, p);
    ix_polygon *pg;
    ix_vertex *v;
    size_t n;

    *out = NULL;
    if (!q)
        return IX_ENOMEM;
    pg = &q->poly[before ? 0 : q->n - 1];
    n = (size_t)pg->n;
    v = ix__realloc(in->ctx, pg->v, n * sizeof *v, (n + 1) * sizeof *v);
    if (!v) {
        ix__poly_unref(in->ctx, q);
        return IX_ENOMEM;
    }
    pg->v = v;
    pg->n++;
    if (before)
        memmove(v + 1, v, n * sizeof *v);
    v += before ? 0 : n;
    *v = (ix_vertex){.internal = false};
    memcpy(v->p, pt, sizeof v->p);
    *out = q;
    return IX_OK;
}

ix_status ix__op_add_poly_pt(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    bool before = l->type != IX_OBJ_POLY;
    const ix_obj *poly = before ? r : l;
    const double *pt = before ? l->u.pt : r->u.pt;
    ix_poly *p;

    if (poly->u.poly->n == 0)
        return IX_FAIL(in->ctx, IX_EARG, "the poly is empty");
    if (poly->u.poly->poly[before ? 0 : poly->u.poly->n - 1].kind == IX_POLYGON)
        return IX_FAIL(in->ctx, IX_EARG,
                       "a point can be added to a polyline or a point list, "
                       "not to a polygon");
    IX_TRY(with_vertex(in, poly->u.poly, pt, before, &p));
    return like(in, poly, ix__obj_poly(in->ctx, p), out);
}

ix_status ix__op_polyline(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    ix_poly *p;
    ix_status st;

    if (l->type == IX_OBJ_POLY || r->type == IX_OBJ_POLY)
        return ix__op_add_poly_pt(in, l, r, out);
    p = ix__poly_new(in->ctx, 1);
    if (!p)
        return IX_ENOMEM;
    p->poly[0].kind = IX_POLYLINE;
    st = ix__poly_vertices(in->ctx, &p->poly[0], 2);
    if (st != IX_OK) {
        ix__poly_unref(in->ctx, p);
        return st;
    }
    memcpy(p->poly[0].v[0].p, l->u.pt, sizeof l->u.pt);
    memcpy(p->poly[0].v[1].p, r->u.pt, sizeof r->u.pt);
    *out = ix__obj_poly(in->ctx, p);
    return *out ? IX_OK : IX_ENOMEM;
}

/* --- one object out of two
 * ------------------------------------------------------------ */

static ix_obj *merge_polys(ix_ctx *ctx, const ix_poly *a, const ix_poly *b)
{
    ix_poly *p = ix__poly_new(ctx, a->n + b->n);

    for (int i = 0; p && i < p->n; i++) {
        const ix_polygon *from = i < a->n ? &a->poly[i] : &b->poly[i - a->n];

        if (ix__polygon_dup(ctx, from, &p->poly[i]) != IX_OK) {
            ix__poly_unref(ctx, p);
            return NULL;
        }
    }
    return p ? ix__obj_poly(ctx, p) : NULL;
}

/* Two arrays of pointers, one behind the other, in scratch. */
static const void **concatenated(ix_ctx *ctx, const void *a, int na,
                                 const void *b, int nb)
{
    const void **v = ix__scratch(ctx, (size_t)na + (size_t)nb, sizeof *v);

    if (v) {
        memcpy(v, a, (size_t)na * sizeof *v);
        memcpy(v + na, b, (size_t)nb * sizeof *v);
    }
    return v;
}

static ix_obj *merge_surfaces(ix_ctx *ctx, const ix_mvs *a, const ix_mvs *b)
{
    ix_mark mk = ix__scratch_mark(ctx);
    const void **v = concatenated(ctx, a->mv, a->n, b->mv, b->n);
    const ix_mvs *both = v ? ix__mvs_new(ctx, a->n + b->n,
                                         (const ix_mv *const *)v)
                           : NULL;

    ix__scratch_release(ctx, mk);
    return both ? ix__obj_mvs(ctx, IX_OBJ_SURFACE, both) : NULL;
}

static ix_obj *merge_trimmed(ix_ctx *ctx, const ix_obj *a, const ix_obj *b)
{
    int na = a->u.trim.n, nb = b->u.trim.n;
    ix_mark mk = ix__scratch_mark(ctx);
    const void **v = concatenated(ctx, a->u.trim.item, na, b->u.trim.item, nb);
    ix_obj *o = v ? ix__obj_trimsrfs(ctx, na + nb, (const ix_trimsrf *const *)v)
                  : NULL;

    ix__scratch_release(ctx, mk);
    return o;
}

ix_status ix__op_merge(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    ix_obj *o;

    if (l->type == IX_OBJ_POLY)
        o = merge_polys(in->ctx, l->u.poly, r->u.poly);
    else if (l->type == IX_OBJ_SURFACE)
        o = merge_surfaces(in->ctx, l->u.mvs, r->u.mvs);
    else
        o = merge_trimmed(in->ctx, l, r);
    return like(in, l, o, out);
}
