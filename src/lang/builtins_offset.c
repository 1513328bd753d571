/* builtins_offset.c - chapter 20: curves and surfaces at a distance. */
#include <math.h>
#include <string.h>

#include "geom/poly_offset.h"
#include "geom/vec3.h"
#include "iritx/offset.h"
#include "lang/args_freeform.h"
#include "lang/curve_args.h"
#include "lang/interp.h"
#include "lang/poly_rows.h"

/* --- one offset ------------------------------------------------------------
 */

static void remark_error(ix_call *c, double err, double tol)
{
    if (!(err <= tol))
        ix__remark(c->in,
                   "the offset is off by up to %g: the normal changes sides, "
                   "or too many knots would be needed",
                   err);
}

/* A number or a scalar curve as the distance. */
static void arg_distance(ix_call *c, int i, ix_offset_opts *o)
{
    if (c->argv[i]->type == IX_OBJ_CURVE)
        o->field = ix__arg_mv(c, i);
    else
        o->distance = ix__arg_num(c, i);
}

static ix_status arg_tolerance(ix_call *c, int i, double *tol)
{
    *tol = ix__arg_num(c, i);
    if (!(*tol > 0))
        return IX_ARG_FAIL(c, i, "a tolerance of %g; it must be positive",
                           *tol);
    return IX_OK;
}

static ix_status curve_offset(ix_call *c, const ix_offset_opts *o, ix_mv **out)
{
    double err;

    IX_TRY(ix_crv_offset(c->ctx, ix__arg_mv(c, 0), o, &err, out));
    remark_error(c, err, o->tol);
    return IX_OK;
}

static ix_status surface_offset(ix_call *c, const ix_mv *s, double tol,
                                ix_mv **out)
{
    double err;

    if (c->argv[1]->type != IX_OBJ_NUMBER)
        return IX_ARG_FAIL(c, 1,
                           "a curve; the distance of a surface is a number");
    IX_TRY(ix_srf_offset(c->ctx, s, ix__arg_num(c, 1), tol, &err, out));
    remark_error(c, err, tol);
    return IX_OK;
}

/* The same trimming curves on the offset surface. */
static ix_status trimmed_offset(ix_call *c, double tol)
{
    const ix_trimsrf *t = c->argv[0]->u.trim.item[0];
    ix_trimsrf *copy;
    ix_status st = IX_OK;
    ix_mv *s;

    IX_TRY(surface_offset(c, t->srf, tol, &s));
    copy = ix__trimsrf_new(c->ctx, s, t->nloops);
    ix_mv_unref(c->ctx, s);
    if (!copy)
        return IX_ENOMEM;
    for (int l = 0; st == IX_OK && l < t->nloops; l++) {
        st = ix__trimloop_segs(c->ctx, &copy->loop[l], t->loop[l].n);
        for (int k = 0; st == IX_OK && k < t->loop[l].n; k++)
            copy->loop[l].seg[k].uv = ix_mv_ref(t->loop[l].seg[k].uv);
    }
    if (st == IX_OK)
        return ix__ret(c, ix__obj_trimsrf(c->ctx, copy));
    ix__trimsrf_unref(c->ctx, copy);
    return st;
}

/* --- polygons and polylines
 * ------------------------------------------------------- */

/* The side from which right and left are seen: +z for what lies in a plane
 * z = const, else that normal of the polygon's plane whose last component that
 * is not 0 is positive. */
static ix_status upper_side(ix_call *c, int which, const ix_polygon *pg,
                            double up[3])
{
    double plane[4], far = 0, size = 0;
    int k = 2;

    memcpy(up, (double[3]){0, 0, 1}, 3 * sizeof *up);
    if (pg->kind != IX_POLYGON || !ix__polygon_plane(pg, plane))
        plane[0] = plane[1] = plane[2] = plane[3] = 0;
    for (int i = 0; i < pg->n; i++) {
        const double *p = pg->v[i].p, *q = pg->v[0].p;

        size = fmax(size, ix__dist3(p, q));
        far = fmax(far, plane[0] == 0 && plane[1] == 0
                            ? fabs(p[2] - q[2])
                            : fabs(ix__dot3(p, plane) + plane[3]));
    }
    if (!(far <= 1e-9 * size))
        return IX_ARG_FAIL(c, 0,
                           "polygon %d is not planar (by %g); polylines must "
                           "lie in a plane z = const, polygons in any plane",
                           which + 1, far);
    while (k > 0 && fabs(plane[k]) <= 1e-12)
        k--;
    for (int i = 0; i < 3 && fabs(plane[k]) > 0; i++)
        up[i] = plane[k] > 0 ? plane[i] : -plane[i];
    return IX_OK;
}

/* One polygon at the distance; a polyline whose ends are equal stays closed. */
static ix_status polygon_offset(ix_call *c, int which, const ix_polygon *pg,
                                ix__join join, ix_polygon *to)
{
    double(*p)[3], (*out)[3], up[3];
    bool closed = pg->kind == IX_POLYGON, ends;
    int m;

    if (pg->kind != IX_POLYGON && pg->kind != IX_POLYLINE)
        return IX_ARG_FAIL(c, 0, "point lists and strips have no sides");
    IX_TRY(upper_side(c, which, pg, up));
    IX_SCRATCH(c->ctx, p, pg->n);
    for (int i = 0; i < pg->n; i++)
        memcpy(p[i], pg->v[i].p, sizeof p[i]);
    ends = !closed && pg->n > 3 && memcmp(p[0], p[pg->n - 1], sizeof *p) == 0;
    IX_TRY(ix__polyline_offset(c->ctx, pg->n, (const double(*)[3])p,
                               closed || ends, up, ix__arg_num(c, 1), join, &m,
                               &out));
    if (ends)
        memcpy(out[m++], out[0], sizeof *out);
    return ix__polygon_fill(c->ctx, to, pg->kind, m, (const double(*)[3])out);
}

static ix_status poly_offset(ix_call *c)
{
    const ix_poly *in = c->argv[0]->u.poly;
    ix__join join = ix__arg_bool(c, 2)   ? IX__JOIN_ROUND
                    : ix__arg_bool(c, 3) ? IX__JOIN_MITRE
                                         : IX__JOIN_BEVEL;
    ix_status st = IX_OK;
    ix_poly *out;

    if (c->argv[1]->type != IX_OBJ_NUMBER)
        return IX_ARG_FAIL(c, 1,
                           "a curve; the distance of polygons is a number");
    out = ix__poly_new(c->ctx, in->n);
    if (!out)
        return IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < in->n; i++)
        st = polygon_offset(c, i, &in->poly[i], join, &out->poly[i]);
    if (st == IX_OK)
        return ix__ret(c, ix__obj_poly(c->ctx, out));
    ix__poly_unref(c->ctx, out);
    return st;
}

static ix_status offset(ix_call *c)
{
    ix_offset_opts o = {.interpolate = ix__arg_bool(c, 3)};
    ix_mv *out;

    if (c->argv[0]->type == IX_OBJ_POLY)
        return poly_offset(c);
    IX_TRY(arg_tolerance(c, 2, &o.tol));
    if (c->argv[0]->type == IX_OBJ_TRIMSRF)
        return trimmed_offset(c, o.tol);
    if (c->argv[0]->type == IX_OBJ_SURFACE) {
        IX_TRY(surface_offset(c, ix__arg_mv(c, 0), o.tol, &out));
        return ix__ret_mv(c, 0, out);
    }
    arg_distance(c, 1, &o);
    IX_TRY(curve_offset(c, &o, &out));
    return ix__ret_mv(c, 0, out);
}

/* --- trimmed ones
 * ------------------------------------------------------------ */

/* How far the end of a is from the start of b. */
static ix_status gap_between(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                             double *gap)
{
    double p[IX_MAX_COORDS] = {0}, q[IX_MAX_COORDS] = {0}, dom[2];

    ix_mv_domain(a, 0, dom);
    IX_TRY(ix_mv_point(ctx, a, &dom[1], p));
    ix_mv_domain(b, 0, dom);
    IX_TRY(ix_mv_point(ctx, b, &dom[0], q));
    *gap = 0;
    for (int k = 0; k < ix_mv_ncoords(a); k++)
        *gap = hypot(*gap, p[k] - q[k]);
    return IX_OK;
}

/* The pieces end to end as one curve. Those that belong together meet at a
 * crossing, found to rounding; straight lines bridge what is wider than tol. */
static ix_status merged(ix_call *c, const ix_crvs *p, double tol, ix_mv **out)
{
    ix_mv *sum = ix_mv_ref(p->crv[0]), *next;
    double widest = 0, gap;

    for (int i = 1; i < p->n; i++) {
        ix_status st = gap_between(c->ctx, sum, p->crv[i], &gap);

        if (st == IX_OK)
            st = ix_mv_merge(c->ctx, sum, p->crv[i], 0,
                             gap <= tol ? IX_JOIN_SHARED : IX_JOIN_BRIDGE,
                             &next);
        ix_mv_unref(c->ctx, sum);
        IX_TRY(st);
        sum = next;
        widest = fmax(widest, gap);
    }
    if (!(widest <= tol))
        ix__remark(c->in,
                   "what is left lies in pieces up to %g apart, which straight "
                   "lines join; TOFFSET gives the pieces",
                   widest);
    *out = sum;
    return IX_OK;
}

/* Loops of off nearer than the distance, less four times the tolerance, cut
 * out. */
static ix_status without_loops(ix_call *c, const ix_offset_opts *o, ix_mv *off)
{
    double amount = fabs(o->distance) - 4 * o->tol;
    ix_status st;
    ix_mv *out;
    ix_crvs p;

    if (o->field)
        return IX_ARG_FAIL(c, 3,
                           "trimming with a distance that varies; it must be "
                           "off");
    IX_TRY(ix_offset_trim(c->ctx, ix__arg_mv(c, 0), off, amount, &p));
    st = p.n ? merged(c, &p, o->tol, &out) : IX_OK;
    if (st == IX_OK && p.n)
        st = ix__ret_mv(c, 0, out);
    ix_crvs_free(c->ctx, &p);
    return st;
}

static ix_status aoffset(ix_call *c)
{
    ix_offset_opts o = {.interpolate = ix__arg_bool(c, 4)};
    ix_status st;
    ix_mv *out;

    IX_TRY(arg_tolerance(c, 2, &o.tol));
    arg_distance(c, 1, &o);
    IX_TRY(curve_offset(c, &o, &out));
    if (!ix__arg_bool(c, 3))
        return ix__ret_mv(c, 0, out);
    st = without_loops(c, &o, out);
    ix_mv_unref(c->ctx, out);
    return st;
}

static ix_status loffset(ix_call *c)
{
    int samples, size, order;
    ix_mv *out;

    IX_TRY(ix__arg_int(c, 2, 2, 1 << 20, &samples));
    IX_TRY(ix__arg_int(c, 3, 2, samples, &size));
    IX_TRY(ix__arg_int(c, 4, 2, size, &order));
    IX_TRY(ix_crv_offset_fit(c->ctx, ix__arg_mv(c, 0), ix__arg_num(c, 1),
                             samples, size, order, NULL, &out));
    return ix__ret_mv(c, 0, out);
}

static ix_status moffset(ix_call *c)
{
    double deg = ix__arg_num(c, 2), err;
    ix_mv *out;

    if (!(deg >= 0.1 && deg <= 90))
        return IX_ARG_FAIL(c, 2, "arcs of %g degrees; 0.1 to 90 are possible",
                           deg);
    IX_TRY(ix_crv_offset_match(c->ctx, ix__arg_mv(c, 0), ix__arg_num(c, 1),
                               deg * (acos(-1) / 180), &err, &out));
    IX_TRY(ix__ret_mv(c, 0, out));
    return ix__attr_set_real(c->ctx, &c->result->attrs, "Error", err);
}

/* params: amount, validate, euclid, and numbers that are not needed. */
static ix_status surface_toffset(ix_call *c, int n, const double *v)
{
    const ix_mv *s = ix__arg_mv(c, 0), *off = ix__arg_mv(c, 1);
    bool complete, validate = n > 1 && fabs(v[1]) >= 1e-5;
    ix_crvs p;

    if (n < 3)
        return IX_ARG_FAIL(c, 2,
                           "%d parameters; list(amount, validate, euclid, "
                           "subdiv, numer, numerImp) is wanted",
                           n);
    IX_TRY(ix_srf_offset_meet(c->ctx, s, off, validate ? v[0] : 0,
                              fabs(v[2]) >= 1e-5, ix__contour_tolerance(c),
                              &complete, &p));
    if (!complete)
        ix__remark(c->in, "the offset meets itself in more than was found, or "
                          "nearly");
    return ix__ret_crvs(c, &p);
}

static ix_status toffset(ix_call *c)
{
    double *v;
    ix_crvs p;
    int n;

    if (c->argv[0]->type != c->argv[1]->type)
        return IX_ARG_FAIL(c, 1, "%s; the offset of a %s is wanted",
                           ix__obj_type_name(c->argv[1]->type),
                           c->argv[0]->type == IX_OBJ_CURVE ? "curve"
                                                            : "surface");
    IX_TRY(ix__arg_nums(c, 2, &n, &v));
    if (c->argv[0]->type == IX_OBJ_SURFACE)
        return surface_toffset(c, n, v);
    if (n < 3)
        return IX_ARG_FAIL(c, 2,
                           "%d parameters; list(method, tolerance, trimming "
                           "distance, numeric tolerance) is wanted",
                           n);
    IX_TRY(
        ix_offset_trim(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1), v[2], &p));
    return ix__ret_crvs(c, &p);
}

static ix_status iloffset(ix_call *c)
{
    ix_obj *list;
    double *ends;
    ix_status st;
    int n;

    IX_TRY(
        ix_offset_loops(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1), &ends, &n));
    if (n == 0)
        return IX_OK;
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < n; i++) {
        const double p[3] = {ends[2 * i], ends[2 * i + 1], 0};

        st = ix__list_add(c->ctx, list, ix__obj_point(c->ctx, p));
    }
    ix_offset_loops_free(c->ctx, ends, n);
    return ix__ret_list(c, list, st);
}

#define C "c = cbezier(list(ctlpt(E2,0,0), ctlpt(E2,1,2), ctlpt(E2,2,0))); "

const ix_builtin ix__builtins_offset[] = {
    {"OFFSET",
     "x:curve|surface|trimsrf|poly d:num|curve tol:num interp:bool -> "
     "curve|surface|trimsrf|poly",
     "The curve or surface at the distance d, within tol: plane curves to the "
     "right of their direction, curves of three coordinates towards their "
     "centre of curvature, surfaces along SNORMAL. Control points are moved "
     "and knots inserted; with interp a polynomial through offset points. d "
     "may be a scalar curve. Corners are bridged. Of polylines in a plane "
     "z = const and of planar polygons the edges are moved to their right; the "
     "last arguments then ask for round corners (points every 10 degrees), or "
     "for edges that go on until they meet (else a straight bevel). Loops are "
     "not cut out.",
     C
     "o = offset(c, 0.1, 0.001, off); "
     "p = offset(poly(list(point(0,0,0), point(2,0,0), point(0,1,0)), false), "
     "0.1, off, on);",
     offset, 0, 20},
    {"AOFFSET", "c:curve d:num|curve eps:num trim:bool interp:bool -> curve",
     "As OFFSET of a curve; with trim on, loops nearer than d (less four times "
     "eps) are cut out and the rest joined. No value if nothing is left.",
     C "o = aoffset(c, -0.5, 0.001, true, false);", aoffset, 0, 20},
    {"LOFFSET", "c:curve d:num samples:num size:num order:num -> curve",
     "The B-spline of an order and a number of control points nearest, in the "
     "sense of least squares, to samples of the exact offset.",
     C "o = loffset(c, 0.2, 100, 8, 4);", loffset, 0, 20},
    {"MOFFSET", "c:curve d:num angTol:num -> curve",
     "The offset to the right of the direction in the XY plane: each point of "
     "c "
     "and the one of a circle of radius d with a parallel tangent, added up. "
     "Arcs of at most angTol degrees of the circle are replaced by parabolas, "
     "so that the result is rational, with tangents exactly parallel; "
     "distances "
     "are from d to d + the attribute Error.",
     C "o = moffset(c, 0.2, 10);", moffset, 0, 20},
    {"TOFFSET", "c:curve|surface off:curve|surface params:list -> list",
     "The pieces of an offset curve off of c, cut at its self-intersections, "
     "that are nowhere nearer to c than the third of params = list(method, "
     "tolerance, trimming distance, numeric tolerance), best a little below "
     "the offset distance; the others are not needed. Of a surface: curves of "
     "order 2 in which the offset meets itself, params = list(amount, "
     "validate, euclid, subdiv, numer, numerImp): with validate on, as far as "
     "they are not nearer to c than amount, which makes them the edges of the "
     "trimmed offset; with euclid on in space, else as (u1, v1, u2, v2).",
     C "l = toffset(c, offset(c, -0.5, 0.001, off), list(1, 20, 0.49, 1e-3)); "
       "s = ruledsrf(cregion(pcircle(vector(0,0,0), 1), 0, 2), "
       "cregion(pcircle(vector(0,0,1), 1), 0, 2)); "
       "e = toffset(s, offset(s, 0.2, 0.01, off), list(0.19, on, on, 0.1, "
       "1e-6, 0));",
     toffset, 0, 20},
    {"ILOFFSET", "c:curve off:curve -> list",
     "Where an offset curve runs backwards against c (the distance exceeds the "
     "radius of curvature): intervals of the parameter as points (t0, t1, 0); "
     "no value if there are none.",
     C "l = iloffset(c, offset(c, -0.5, 0.001, off));", iloffset, 0, 20},
    {0}};
