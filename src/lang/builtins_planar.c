/* builtins_planar.c - circles in triangles, belts, curves cut at their
 * intersections, shells, points moved onto others, quadrilaterals (chapters 9,
 * 11, 22 and 24 of spec/functions). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"
#include "geom/belt.h"
#include "geom/pack_triangle.h"
#include "geom/register.h"
#include "iritx/distance.h"
#include "iritx/geom.h"
#include "iritx/geom_srf.h"
#include "iritx/tile.h"
#include "iritx/visible.h"
#include "lang/args_freeform.h"
#include "lang/interp.h"
#include "mv/mv.h"

/* --- circles in triangles
 * ------------------------------------------------------ */

static ix_obj *circle_object(ix_ctx *ctx, const ix__disc *d)
{
    const double at[3] = {d->at[0], d->at[1], 0};
    ix_mv *crv;

    if (ix_circle(ctx, at, d->radius, &crv) != IX_OK)
        return NULL;
    return ix__obj_mv(ctx, IX_OBJ_CURVE, crv);
}

/* n lists of count circles each. */
static ix_status ret_circles(ix_call *c, int n, int count, const ix__disc *d)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < n; i++) {
        ix_obj *own = ix__obj_list(c->ctx);

        st = own ? IX_OK : IX_ENOMEM;
        for (int k = 0; st == IX_OK && k < count; k++)
            st = ix__list_add(c->ctx, own,
                              circle_object(c->ctx, &d[i * count + k]));
        if (st == IX_OK)
            st = ix__list_add(c->ctx, list, own);
        else
            ix__obj_unref(c->ctx, own);
    }
    return ix__ret_list(c, list, st);
}

static ix_status arg_triangle(ix_call *c, double (*p)[2])
{
    for (int k = 0; k < 3; k++) {
        double q[3];

        IX_TRY(ix__arg_pt3(c, k, q));
        memcpy(p[k], q, sizeof p[k]);
    }
    return IX_OK;
}

static ix_status pktri3crcs(ix_call *c)
{
    ix__disc(*d)[3];
    double p[3][2];
    int n;

    IX_TRY(arg_triangle(c, p));
    IX_TRY(ix__pack_three(c->ctx, (const double(*)[2])p, ix__arg_bool(c, 3), &n,
                          &d));
    return ret_circles(c, n, 3, d[0]);
}

static ix_status pktri6crcs(ix_call *c)
{
    ix__disc(*d)[6];
    double p[3][2];
    int n;

    IX_TRY(arg_triangle(c, p));
    if (!ix__arg_bool(c, 3))
        return IX_ARG_FAIL(c, 3, "six circles outside are not known here");
    IX_TRY(ix__pack_six(c->ctx, (const double(*)[2])p, &n, &d));
    return ret_circles(c, n, 6, d[0]);
}

/* --- belts
 * --------------------------------------------------------------------- */

static ix_status take_piece(ix_call *c, const ix_mv *piece, ix_mv **sum)
{
    ix_mv *next;
    ix_status st;

    if (!*sum) {
        *sum = ix_mv_ref(piece);
        return IX_OK;
    }
    st = ix_mv_merge(c->ctx, *sum, piece, 0, IX_JOIN_SHARED, &next);
    if (st == IX_OK) {
        ix_mv_unref(c->ctx, *sum);
        *sum = next;
    }
    return st;
}

/* All pieces as one closed curve, or in a list of their own. */
static ix_status add_belt(ix_call *c, const ix_crvs *p, bool whole,
                          ix_obj *list)
{
    ix_obj *own = whole ? NULL : ix__obj_list(c->ctx);
    ix_status st = whole || own ? IX_OK : IX_ENOMEM;
    ix_mv *sum = NULL;

    for (int i = 0; st == IX_OK && i < p->n; i++)
        st = whole ? take_piece(c, p->crv[i], &sum)
                   : ix__list_add(c->ctx, own,
                                  ix__obj_mv(c->ctx, IX_OBJ_CURVE,
                                             ix_mv_ref(p->crv[i])));
    if (st == IX_OK)
        return ix__list_add(
            c->ctx, list, whole ? ix__obj_mv(c->ctx, IX_OBJ_CURVE, sum) : own);
    ix__obj_unref(c->ctx, own);
    ix_mv_unref(c->ctx, sum);
    return st;
}

static ix_status add_side(ix_call *c, int n, const double (*p)[3], double grow,
                          ix_obj *list)
{
    ix_crvs pieces;
    ix_status st;

    IX_TRY(ix__belt(c->ctx, n, p, grow, &pieces));
    st = add_belt(c, &pieces, ix__arg_bool(c, 3), list);
    ix_crvs_free(c->ctx, &pieces);
    return st;
}

static ix_status beltcurve(ix_call *c)
{
    const ix_poly *in = c->argv[0]->u.poly;
    double h = ix__arg_num(c, 1), (*p)[3];
    int n = in->n > 0 ? in->poly[0].n : 0;
    ix_obj *list;
    ix_status st;

    if (!(h >= 0))
        return IX_ARG_FAIL(c, 1, "a thickness of %g; it must not be negative",
                           h);
    IX_SCRATCH(c->ctx, p, n);
    for (int i = 0; i < n; i++) { /* the belt's middle */
        memcpy(p[i], in->poly[0].v[i].p, sizeof p[i]);
        p[i][2] += copysign(h / 2, p[i][2]) * (p[i][2] != 0);
    }
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int side = -1; st == IX_OK && side <= 1; side += 2)
        st = add_side(c, n, (const double(*)[3])p, side * h / 2, list);
    return ix__ret_list(c, list, st);
}

/* --- arrangements
 * --------------------------------------------------------------- */

/* The intersections of one curve with the others: rising parameters. */
typedef struct {
    int n, room;
    double *t;
} cuts;

static ix_status add_cut(ix_call *c, cuts *k, double t)
{
    IX_GROW(c->ctx, k->t, k->n, k->room);
    k->t[k->n++] = t;
    return IX_OK;
}

static ix_status meet(ix_call *c, const ix_mv **m, int i, int j, cuts *k)
{
    ix_solutions s;
    ix_status st = IX_OK;

    if (i == j)
        IX_TRY(ix_crv_self_meet(c->ctx, m[i], &s));
    else
        IX_TRY(ix_crv_crv_meet(c->ctx, m[i], m[j], NULL, &s));
    if (!s.complete)
        ix__remark(c->in, "curves %d and %d lie on each other", i + 1, j + 1);
    for (int e = 0; st == IX_OK && e < s.n; e++) {
        st = add_cut(c, &k[i], s.sol[e].x[0]);
        if (st == IX_OK)
            st = add_cut(c, &k[j], s.sol[e].x[1]);
    }
    ix_solutions_free(c->ctx, &s);
    return st;
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* Sorted, with those that are within eps of the one before left out. */
static void tidy(cuts *k, double eps)
{
    int n = 0;

    if (k->n)
        qsort(k->t, (size_t)k->n, sizeof *k->t, by_value);
    for (int i = 0; i < k->n; i++)
        if (n == 0 || k->t[i] - k->t[n - 1] > eps)
            k->t[n++] = k->t[i];
    k->n = n;
}

/* The curve with its parameters in "InterPts". */
static ix_status add_marked(ix_call *c, const ix_mv *m, const cuts *k,
                            ix_obj *list)
{
    ix_obj *o = ix__obj_mv(c->ctx, IX_OBJ_CURVE, ix_mv_ref(m));
    ix_obj *own = ix__obj_list(c->ctx);
    ix_status st = o && own ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < k->n; i++)
        st = ix__list_add_num(c->ctx, own, k->t[i]);
    if (st == IX_OK)
        st = ix__attr_set_obj(c->ctx, &o->attrs, "InterPts", own);
    ix__obj_unref(c->ctx, own);
    if (st == IX_OK)
        return ix__list_add(c->ctx, list, o);
    ix__obj_unref(c->ctx, o);
    return st;
}

/* The pieces between the parameters, none shorter than eps. */
static ix_status add_pieces(ix_call *c, const ix_mv *m, const cuts *k,
                            double eps, ix_obj *list)
{
    double dom[2], from;

    ix_mv_domain(m, 0, dom);
    from = dom[0];
    for (int i = 0; i <= k->n; i++) {
        double to = i < k->n ? k->t[i] : dom[1];
        ix_mv *piece;

        if (!(to - from > eps) || (i < k->n && !(dom[1] - to > eps)))
            continue;
        IX_TRY(ix_mv_region(c->ctx, m, 0, from, to, &piece));
        IX_TRY(ix__list_add(c->ctx, list,
                            ix__obj_mv(c->ctx, IX_OBJ_CURVE, piece)));
        from = to;
    }
    return IX_OK;
}

/* What is seen of all curves from below, or from a point. */
static ix_status envelope(ix_call *c, int n, const ix_mv *const *m, bool radial)
{
    double view[3] = {0, -1, 0};
    ix_obj_type type = c->argv[3]->type;
    ix_obj *list;
    ix_crvs *seen;
    ix_status st;

    if (radial && type != IX_OBJ_POINT && type != IX_OBJ_VECTOR &&
        type != IX_OBJ_CTLPT)
        return IX_ARG_FAIL(c, 3, "the center of a radial envelope is a point");
    if (radial)
        IX_TRY(ix__arg_pt3(c, 3, view));
    IX_SCRATCH(c->ctx, seen, n);
    IX_TRY(ix_crvs_visible(c->ctx, n, m, view, radial, seen));
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; i < n; i++) {
        for (int k = 0; st == IX_OK && k < seen[i].n; k++)
            st = ix__list_add(
                c->ctx, list,
                ix__obj_mv(c->ctx, IX_OBJ_CURVE, ix_mv_ref(seen[i].crv[k])));
        ix_crvs_free(c->ctx, &seen[i]);
    }
    return ix__ret_list(c, list, st);
}

static ix_status carrangmnt(ix_call *c)
{
    double eps = ix__arg_num(c, 1);
    const ix_mv **m;
    int n, op;
    cuts *k;
    ix_obj *list;
    ix_status st;

    IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_CURVE, &n, &m));
    IX_TRY(ix__arg_int(c, 2, 1, 4, &op));
    if (!(eps >= 0))
        return IX_ARG_FAIL(c, 1, "a tolerance of %g", eps);
    if (op > 2)
        return envelope(c, n, m, op == 4);
    IX_SCRATCH(c->ctx, k, n);
    memset(k, 0, (size_t)n * sizeof *k);
    for (int i = 0; i < n; i++)
        for (int j = i; j < n; j++)
            IX_TRY(meet(c, m, i, j, k));
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < n; i++) {
        tidy(&k[i], eps);
        st = op == 1 ? add_marked(c, m[i], &k[i], list)
                     : add_pieces(c, m[i], &k[i], eps, list);
    }
    return ix__ret_list(c, list, st);
}

/* --- shells, registration
 * -------------------------------------------------------- */

static ix_status add_wall(ix_call *c, int dir, int end, ix_obj *list)
{
    ix_mv *crv[2] = {NULL, NULL}, *wall = NULL;
    ix_status st = IX_OK;

    for (int k = 0; st == IX_OK && k < 2; k++) {
        const ix_mv *s = ix__arg_mv(c, k);
        double dom[2];

        ix_mv_domain(s, dir, dom);
        st = ix_mv_fix(c->ctx, s, dir, dom[end], &crv[k]);
    }
    if (st == IX_OK)
        st = ix_srf_ruled(c->ctx, crv[0], crv[1], &wall);
    if (st == IX_OK)
        st = ix__list_add(c->ctx, list,
                          ix__obj_mv(c->ctx, IX_OBJ_SURFACE, wall));
    ix_mv_unref(c->ctx, crv[0]);
    ix_mv_unref(c->ctx, crv[1]);
    return st;
}

static ix_status sshell(ix_call *c)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int k = 0; st == IX_OK && k < 4; k++)
        st = add_wall(c, k / 2, k % 2, list);
    return ix__ret_list(c, list, st);
}

static ix_status arg_cloud(ix_call *c, int i, int *n, double (**out)[3])
{
    const ix_list *l = &c->argv[i]->u.list;

    IX_SCRATCH(c->ctx, *out, l->n + 1);
    *n = l->n;
    for (int k = 0; k < l->n; k++) {
        const ix_obj *o = l->item[k];

        if (o->type != IX_OBJ_POINT && o->type != IX_OBJ_VECTOR)
            return ix__wrong_element(c, i, k, o, "a point or vector");
        memcpy((*out)[k], o->u.pt, sizeof(*out)[k]);
    }
    return IX_OK;
}

static ix_status ptregister(ix_call *c)
{
    bool to_srf = c->argv[1]->type == IX_OBJ_SURFACE;
    double(*p)[3], (*q)[3] = NULL, mat[16], err;
    int n, m = 0, iters;

    IX_TRY(arg_cloud(c, 0, &n, &p));
    if (!to_srf)
        IX_TRY(arg_cloud(c, 1, &m, &q));
    IX_TRY(ix__arg_int(c, 2, 1, 100000, &iters));
    IX_TRY(ix__register(c->ctx, n, (const double(*)[3])p, m,
                        (const double(*)[3])q, to_srf ? ix__arg_mv(c, 1) : NULL,
                        iters, ix__arg_num(c, 3), mat, &err));
    IX_TRY(ix__ret(c, ix__obj_matrix(c->ctx, mat)));
    return ix__attr_set_real(c->ctx, &c->result->attrs, "Error", err);
}

/* --- tilings
 * -------------------------------------------------------------------- */

static ix_status ret_polygons(ix_call *c, const ix_quads *q)
{
    ix_poly *p = ix__poly_new(c->ctx, q->nquads);
    ix_status st = p ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < q->nquads; i++) {
        p->poly[i].kind = IX_POLYGON;
        st = ix__poly_vertices(c->ctx, &p->poly[i], 4);
        for (int k = 0; st == IX_OK && k < 4; k++)
            memcpy(p->poly[i].v[k].p, q->p[q->quad[i].v[k]], sizeof *q->p);
    }
    if (st == IX_OK)
        return ix__ret(c, ix__obj_poly(c->ctx, p));
    if (p)
        ix__poly_unref(c->ctx, p);
    return st;
}

/* Side k of a quadrilateral as a curve, back: from its end to its start. */
static ix_status side_of(ix_call *c, const ix_quads *q, const ix_mv *const *crv,
                         int i, int k, bool back, bool follow, ix_mv **out)
{
    const ix_dir d = {.basis = IX_BEZIER, .order = 2, .length = 2};
    const ix_quad *f = &q->quad[i];
    const double *a = q->p[f->v[(k + back) % 4]];
    const double *b = q->p[f->v[(k + !back) % 4]];
    const double pts[6] = {a[0], b[0], a[1], b[1], 0, 0};
    ix_mv *part, *flat = NULL;
    ix_status st;

    if (!follow || f->crv[k] < 0)
        return ix_mv_new(c->ctx, 1, &d, 3, false, pts, out);
    IX_TRY(
        ix_mv_region(c->ctx, crv[f->crv[k]], 0, f->t[k][0], f->t[k][1], &part));
    st = ix_mv_coerce(c->ctx, part, 2, ix_mv_rational(part), &flat);
    ix_mv_unref(c->ctx, part);
    IX_TRY(st);
    /* a region runs by rising parameters */
    if ((f->t[k][0] > f->t[k][1]) != back) {
        st = ix_mv_reverse(c->ctx, flat, 0, &part);
        ix_mv_unref(c->ctx, flat);
        IX_TRY(st);
        flat = part;
    }
    st = ix_mv_coerce(c->ctx, flat, 3, ix_mv_rational(flat), out);
    ix_mv_unref(c->ctx, flat);
    return st;
}

static ix_status add_patch(ix_call *c, const ix_quads *q,
                           const ix_mv *const *crv, int i, bool follow,
                           ix_obj *list)
{
    ix_mv *s[4] = {NULL}, *srf = NULL;
    ix_status st = IX_OK;

    for (int k = 0; st == IX_OK && k < 4; k++)
        st = side_of(c, q, crv, i, k, k >= 2, follow, &s[k]);
    if (st == IX_OK)
        st = ix_srf_boolsum(c->ctx, s[0], s[2], s[3], s[1], &srf);
    for (int k = 0; k < 4; k++)
        ix_mv_unref(c->ctx, s[k]);
    IX_TRY(st);
    return ix__list_add(c->ctx, list, ix__obj_mv(c->ctx, IX_OBJ_SURFACE, srf));
}

static ix_status ret_patches(ix_call *c, const ix_quads *q,
                             const ix_mv *const *crv, bool follow)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < q->nquads; i++)
        st = add_patch(c, q, crv, i, follow, list);
    return ix__ret_list(c, list, st);
}

static ix_status c2rectrgn(ix_call *c)
{
    ix_tile_opts o = {.angle = ix__arg_num(c, 1) * (acos(-1) / 180),
                      .size = ix__arg_num(c, 3)};
    const ix_mv **crv;
    ix_quads q;
    ix_status st;
    int n, type;

    IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_CURVE, &n, &crv));
    if (!(o.angle >= 0.01 && o.angle <= 3.1416))
        return IX_ARG_FAIL(c, 1, "%g degrees; 1 to 180 are possible",
                           ix__arg_num(c, 1));
    IX_TRY(ix__arg_int(c, 2, 1, 3, &type));
    if (!(o.size > 0))
        return IX_ARG_FAIL(c, 3, "sides of %g; it must be positive", o.size);
    IX_TRY(ix__arg_int(c, 4, 0, 1000, &o.smooth));
    IX_TRY(ix_region_quads(c->ctx, n, crv, &o, &q));
    st = type == 1 ? ret_polygons(c, &q) : ret_patches(c, &q, crv, type == 3);
    ix_quads_free(c->ctx, &q);
    return st;
}

/* --- table ------------------------------------------------------------- */

#define TRI "point(0,0,0), point(3,0,0), point(0,2,0)"
#define S                                                             \
    "s = ruledsrf(ctlpt(E3,0,0,0) + ctlpt(E3,1,0,0), ctlpt(E3,0,1,0)" \
    " + ctlpt(E3,1,1,1)); "

const ix_builtin ix__builtins_planar[] = {
    {"PKTRI3CRCS",
     "p1:pt3 p2:pt3 p3:pt3 interior:bool subdiv:num numer:num -> list",
     "Three circles, each touching two sides of a triangle and both others: "
     "lists of three circles; with interior the one triple inside (Malfatti's "
     "circles), else also those that pass each other along a side. The last "
     "two numbers are not needed.",
     "l = pktri3crcs(" TRI ", true, 0.01, 1e-8);", pktri3crcs, 0, 22},
    {"PKTRI6CRCS",
     "p1:pt3 p2:pt3 p3:pt3 interior:bool subdiv:num numer:num -> list",
     "Six circles in a triangle like bowling pins: one in each angle, one at "
     "each side between two of these, which touches the other two at sides; "
     "interior must be true.",
     "l = pktri6crcs(" TRI ", true, 0.01, 1e-8);", pktri6crcs, 0, 22},
    {"BELTCURVE",
     "pulleys:poly thickness:num boundingArcs:num returnCrvs:bool -> list",
     "A closed belt of a thickness on pulleys (x, y, r), passed counter-"
     "clockwise where r > 0, clockwise where r < 0: its left and its right "
     "side, as closed curves, or with returnCrvs off as lists of an arc and a "
     "line for each pulley. boundingArcs is not needed.",
     "l = beltcurve(poly(list(point(0,0,0.5), point(3,0,0.5)), true), 0.1, 0, "
     "true);",
     beltcurve, 0, 11},
    {"CARRANGMNT", "crvs:list eps:num op:num center:any -> list",
     "Planar curves and where they cross each other and themselves, parameters "
     "within eps counting as one: op 1 gives the curves with the list of "
     "parameters as attribute InterPts, op 2 the pieces between them, op 3 "
     "their lower envelope, the parts with nothing of any curve below them, op "
     "4 the radial one, the parts that are seen from the point center. The "
     "last argument is needed by op 4 only.",
     "c = circle(vector(0,0,0), 1); l = carrangmnt(list(c, c * tx(1)), 1e-8, "
     "2, 0);",
     carrangmnt, 0, 9},
    {"SSHELL", "s1:surface s2:surface -> list",
     "The four ruled walls between the borders of two surfaces: at u = 0, 1, "
     "then v = 0, 1.",
     S "l = sshell(s, s * tz(0.1));", sshell, 0, 11},
    {"PTREGISTER", "pts1:list pts2:list|surface iters:num eps:num -> matrix",
     "The rigid motion that brings the points of pts1 near to those of pts2, "
     "or to a surface, from where they are: pairs of nearest points, at most "
     "iters times, until the root mean square distance (attribute Error) "
     "changes by no more than eps.",
     "l = list(point(0,0,0), point(1,0,0), point(0,2,0), point(0,0,3)); m = "
     "ptregister(l, list(point(0.1,0,0), point(1.1,0,0), point(0.1,2,0), "
     "point(0.1,0,3)), 20, 1e-12);",
     ptregister, 0, 24},
    {"C2RECTRGN",
     "crvs:list angDev:num outType:num size:num smooth:num -> poly|list",
     "The region that an odd number of closed planar curves enclose, as "
     "quadrilaterals that share whole sides of about size; a curve turns by at "
     "most angDev degrees along two of them. outType 1: polygons, 2: bilinear "
     "surfaces, 3: surfaces whose outer sides are the curves themselves. "
     "smooth: "
     "rounds in which inner points move to the mean of their neighbours.",
     "c = circle(vector(0,0,0), 1); o = c2rectrgn(list(c), 30, 1, 0.3, 5);",
     c2rectrgn, 0, 9},
    {0}};
