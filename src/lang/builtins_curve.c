/* builtins_curve.c - chapter 7: functions that make curves and the plane
 * figures that belong to them. Each one fetches, calls and returns. */
#include <limits.h>
#include <string.h>

#include "iritx/geom.h"
#include "lang/args_freeform.h"
#include "lang/curve_args.h"
#include "lang/interp.h"

/* --- from control points -------------------------------------------------- */

static ix_status cbezier(ix_call *c)
{
    return ix__ret_mesh(c, 1, IX_BEZIER);
}

static ix_status cpower(ix_call *c)
{
    return ix__ret_mesh(c, 1, IX_POWER);
}

static ix_status cbspline(ix_call *c)
{
    ix_mesh m;
    ix_dir dir;
    int order;
    ix_mv *crv;

    IX_TRY(ix__arg_int(c, 0, 1, IX_MAX_ORDER, &order));
    IX_TRY(ix__arg_mesh(c, 1, 1, &m));
    IX_TRY(ix__arg_knots(c, 2, c->argv[2], order, m.length[0], &dir));
    IX_TRY(ix_mv_new(c->ctx, 1, &dir, m.ncoords, m.rational, m.pts, &crv));
    return ix__ret_mv(c, -1, crv);
}

/* --- circles, arcs, windings ------------------------------------------------
 */

static ix_status circle(ix_call *c)
{
    double center[3];
    ix_mv *crv;

    IX_TRY(ix__arg_pt3(c, 0, center));
    IX_TRY(ix_circle(c->ctx, center, ix__arg_num(c, 1), &crv));
    return ix__ret_geom(c, -1, crv, IX__GEOM_CIRCULAR);
}

static ix_status pcircle(ix_call *c)
{
    double center[3];
    ix_mv *crv;

    IX_TRY(ix__arg_pt3(c, 0, center));
    IX_TRY(ix_pcircle(c->ctx, center, ix__arg_num(c, 1), &crv));
    return ix__ret_geom(c, -1, crv, IX__GEOM_CIRCULAR);
}

static ix_status arc(ix_call *c)
{
    double p[3][3];
    ix_mv *crv;

    for (int i = 0; i < 3; i++)
        IX_TRY(ix__arg_pt3(c, i, p[i]));
    IX_TRY(ix_arc(c->ctx, p[0], p[1], p[2], &crv));
    return ix__ret_geom(c, -1, crv, IX__GEOM_CIRCULAR);
}

static ix_status arc360(ix_call *c)
{
    double center[3];
    ix_mv *crv;

    IX_TRY(ix__arg_pt3(c, 0, center));
    IX_TRY(ix_arc_angles(c->ctx, center, ix__arg_num(c, 1), ix__arg_num(c, 2),
                         ix__arg_num(c, 3), &crv));
    return ix__ret_geom(c, -1, crv, IX__GEOM_CIRCULAR);
}

static ix_status chelix(ix_call *c)
{
    int samples;
    ix_mv *crv;

    IX_TRY(ix__arg_int(c, 3, 4, 1000000, &samples));
    IX_TRY(ix_helix(c->ctx, ix__arg_num(c, 0), ix__arg_num(c, 1),
                    ix__arg_num(c, 2), samples, ix__arg_num(c, 4), &crv));
    return ix__ret_mv(c, -1, crv);
}

static ix_status cspiral(ix_call *c)
{
    int samples;
    ix_mv *crv;

    IX_TRY(ix__arg_int(c, 2, 4, 1000000, &samples));
    IX_TRY(ix_spiral(c->ctx, ix__arg_num(c, 0), ix__arg_num(c, 1), samples,
                     ix__arg_num(c, 3), &crv));
    return ix__ret_mv(c, -1, crv);
}

static ix_status csine(ix_call *c)
{
    int samples;
    ix_mv *crv;

    IX_TRY(ix__arg_int(c, 1, 4, 1000000, &samples));
    IX_TRY(
        ix_sine(c->ctx, ix__arg_num(c, 0), samples, ix__arg_num(c, 2), &crv));
    return ix__ret_mv(c, -1, crv);
}

/* --- interpolation -----------------------------------------------------------
 */

/* Argument 3: a PARAM_* code, or list(parameters, knots). */
static ix_status interp_opts(ix_call *c, int n, ix_interpolate_opts *o)
{
    const ix_obj *how = c->argv[3];

    *o = (ix_interpolate_opts){.periodic = ix__arg_bool(c, 4)};
    IX_TRY(ix__arg_int(c, 1, 1, IX_MAX_ORDER, &o->order));
    IX_TRY(ix__arg_int(c, 2, 0, n, &o->size));
    if (how->type == IX_OBJ_NUMBER)
        return ix__arg_param(c, 3, &o->param);
    if (how->u.list.n != 2)
        return IX_ARG_FAIL(c, 3, "list(parameters, knots) has two lists");
    IX_TRY(ix__arg_nums_of(c, 3, how->u.list.item[0], &o->nparams, &o->params));
    return ix__arg_nums_of(c, 3, how->u.list.item[1], &o->nknots, &o->knots);
}

/* list(curve, largest error) */
static ix_status cinterp_curve(ix_call *c)
{
    ix_interpolate_opts o;
    double err;
    ix_mv *crv;

    IX_TRY(interp_opts(c, INT_MAX, &o));
    IX_TRY(ix_fit_curve(c->ctx, ix__arg_mv(c, 0), &o, &err, &crv));
    IX_TRY(ix__ret(c, ix__obj_list(c->ctx)));
    IX_TRY(
        ix__list_add(c->ctx, c->result, ix__obj_mv(c->ctx, IX_OBJ_CURVE, crv)));
    return ix__list_add_num(c->ctx, c->result, err);
}

static ix_status cinterp(ix_call *c)
{
    ix_interpolate_opts o;
    ix_mesh m;
    ix_mv *crv;

    if (c->argv[0]->type == IX_OBJ_CURVE)
        return cinterp_curve(c);
    IX_TRY(ix__arg_mesh(c, 0, 1, &m));
    IX_TRY(interp_opts(c, m.length[0], &o));
    IX_TRY(ix_interpolate(c->ctx, m.length[0], m.ncoords, m.rational, m.pts, &o,
                          NULL, &crv));
    return ix__ret_mv(c, -1, crv);
}

static ix_status linterp(ix_call *c)
{
    double point[3], dir[3], dist, *pts;
    int n;

    IX_TRY(ix__arg_points3(c, 0, &n, &pts));
    IX_TRY(ix_fit_line(c->ctx, n, pts, point, dir, &dist));
    IX_TRY(ix__ret(c, ix__obj_list(c->ctx)));
    IX_TRY(ix__list_add(c->ctx, c->result, ix__obj_point(c->ctx, point)));
    IX_TRY(ix__list_add(c->ctx, c->result, ix__obj_vector(c->ctx, dir)));
    return ix__list_add_num(c->ctx, c->result, dist);
}

static ix_status pinterp(ix_call *c)
{
    double plane[4], dist, *pts;
    int n;

    IX_TRY(ix__arg_points3(c, 0, &n, &pts));
    IX_TRY(ix_fit_plane(c->ctx, n, pts, plane, &dist));
    IX_TRY(ix__ret(c, ix__obj_list(c->ctx)));
    IX_TRY(ix__list_add(c->ctx, c->result, ix__obj_plane(c->ctx, plane)));
    return ix__list_add_num(c->ctx, c->result, dist);
}

/* --- conics and quadrics
 * -------------------------------------------------------
 */

/* Two curves: argument 2 the sum of distances, 3 what is wanted. */
static ix_status conic_of_curves(ix_call *c)
{
    const ix_mv **crv;
    double fineness = ix__var_num(c->in, "RESOLUTION", 20);
    int n, mode;
    ix_lines l;
    ix_mv *srf;
    ix_status st;

    IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_CURVE, &n, &crv));
    if (n != 2)
        return IX_ARG_FAIL(c, 0, "two curves are needed, not %d", n);
    if (c->argv[2]->type != IX_OBJ_NUMBER || c->argv[3]->type != IX_OBJ_NUMBER)
        return IX_ARG_FAIL(c, 2, "a sum of distances and 0, 1 or 2 are needed");
    IX_TRY(ix__arg_int(c, 3, 0, 2, &mode));
    if (mode == 0) {
        IX_TRY(
            ix_conic_distance(c->ctx, crv[0], crv[1], ix__arg_num(c, 2), &srf));
        return ix__ret_mv(c, -1, srf);
    }
    /* chords as long as a cell of such a grid */
    fineness = fineness >= 1 ? fineness : 1;
    IX_TRY(ix_conic_locus(c->ctx, crv[0], crv[1], ix__arg_num(c, 2), mode == 2,
                          1 / (8 * fineness * fineness), &l));
    st = ix__ret_lines(c, &l, IX_POLYLINE);
    ix_lines_free(c->ctx, &l);
    return st;
}

/* Arguments 2, 3: both off (the whole), both numbers, both points. */
static ix_status conicsec(ix_call *c)
{
    double range[2], p[2][3], z = ix__arg_num(c, 1);
    const double *coef;
    bool num = c->argv[2]->type == IX_OBJ_NUMBER;
    const ix_list *list = &c->argv[0]->u.list;
    ix_mv *crv;

    if (list->n > 0 && list->item[0]->type == IX_OBJ_CURVE)
        return conic_of_curves(c);
    IX_TRY(ix__arg_nums_n(c, 0, 6, &coef));
    if (num != (c->argv[3]->type == IX_OBJ_NUMBER))
        return IX_ARG_FAIL(c, 3, "both ends are numbers or both are points");
    if (!num) {
        IX_TRY(ix__arg_pt3(c, 2, p[0]));
        IX_TRY(ix__arg_pt3(c, 3, p[1]));
        IX_TRY(ix_conic_between(c->ctx, coef, z, p[0], p[1], &crv));
        return ix__ret_geom(c, -1, crv, IX__GEOM_CONIC);
    }
    range[0] = ix__arg_num(c, 2);
    range[1] = ix__arg_num(c, 3);
    IX_TRY(ix_conic(c->ctx, coef, z,
                    range[0] == 0 && range[1] == 0 ? NULL : range, &crv));
    return ix__ret_geom(c, -1, crv, IX__GEOM_CONIC);
}

static ix_status cnc2quad(ix_call *c)
{
    const double *coef;
    double q[10];

    IX_TRY(ix__arg_nums_n(c, 0, 6, &coef));
    IX_TRY(ix_conic_to_quadric(c->ctx, coef, ix__arg_num(c, 1), q));
    return ix__ret_nums(c, 10, q);
}

static ix_status ellipse3pt(ix_call *c)
{
    double p[3][3], coef[6];

    for (int i = 0; i < 3; i++)
        IX_TRY(ix__arg_pt3(c, i, p[i]));
    IX_TRY(ix_ellipse_three_points(c->ctx, (const double(*)[3])p,
                                   ix__arg_num(c, 3), coef));
    return ix__ret_nums(c, 6, coef);
}

/* The number of coefficients says what they are; argument 0 does not count. */
static ix_status implctrans(ix_call *c)
{
    const double *coef, *mat = c->argv[2]->u.mat;
    double out[10];
    int n;

    IX_TRY(ix__arg_nums_of(c, 1, c->argv[1], &n, &coef));
    if (n != 6 && n != 10)
        return IX_ARG_FAIL(c, 1,
                           "6 coefficients of a conic or 10 of a quadric are "
                           "needed, not %d",
                           n);
    if (n == 6)
        IX_TRY(ix_conic_transform(c->ctx, coef, mat, out));
    else
        IX_TRY(ix_quadric_transform(c->ctx, coef, mat, out));
    return ix__ret_nums(c, n, out);
}

const ix_builtin ix__builtins_curve[] = {
    {"CBSPLINE", "order:num pts:list knots:list -> curve",
     "B-spline curve of control points; knots are numbers or list(KV_OPEN), "
     "list(KV_FLOAT), list(KV_PERIODIC), list(KV_DISC_OPEN).",
     "c = cbspline(4, list(ctlpt(E2,0,0), ctlpt(E2,1,0), ctlpt(E2,1,1), "
     "ctlpt(E2,0,1)), list(KV_PERIODIC));",
     cbspline, 0, 7},
    {"CBEZIER", "pts:list -> curve",
     "Bezier curve of control points; its order is their number.",
     "c = cbezier(list(ctlpt(E2,0,0), ctlpt(E2,1,2), ctlpt(E2,2,0)));", cbezier,
     0, 7},
    {"CPOWER", "coefs:list -> curve",
     "Curve in the power basis: sum of coefficients times t^i, t in [0, 1].",
     "c = cpower(list(ctlpt(E1,1), ctlpt(E1,2), ctlpt(E1,3)));", cpower, 0, 7},
    {"CIRCLE", "center:pt3 r:num -> curve",
     "Exact rational circle parallel to the XY plane, domain [0, 4].",
     "c = circle(vector(0,0,0), 1);", circle, 0, 7},
    {"PCIRCLE", "center:pt3 r:num -> curve",
     "Cubic polynomial circle, radius within 2.8e-4, domain [0, 4].",
     "c = pcircle(vector(0,0,0), 1);", pcircle, 0, 7},
    {"ARC", "start:pt3 center:pt3 end:pt3 -> curve",
     "Circular arc of less than 180 degrees, a rational quadratic.",
     "a = arc(vector(1,0,0), vector(0,0,0), vector(0,1,0));", arc, 0, 7},
    {"ARC360", "center:pt3 r:num a0:num a1:num -> curve",
     "Circular arc counter-clockwise from angle a0 to a1, in degrees.",
     "a = arc360(vector(0,0,0), 2, 30, 200);", arc360, 0, 7},
    {"CINTERP",
     "data:list|curve order:num size:num param:num|list periodic:num -> any",
     "B-spline through points (size 0 or their number) or nearest to them; of "
     "a curve, list(nearest spline, largest distance). Time is linear in the "
     "number of points.",
     "c = cinterp(list(point(0,0,0), point(1,1,0), point(2,0,0)), 3, 0, "
     "PARAM_UNIFORM, false);",
     cinterp, 0, 7},
    {"CONICSEC", "coefs:list z:num a:num|pt3 b:num|pt3 -> any",
     "Conic Ax^2+Bxy+Cy^2+Dx+Ey+F=0 at height z: whole (off, off), between "
     "parameters or between points. Of list(c1, c2): points whose distances "
     "add up to a; b 0 the field over (t1, t2), 1 its zeros, 2 the points.",
     "c = conicsec(list(1,0,4,0,0,-1), 0, off, off);", conicsec, 0, 7},
    {"CHELIX",
     "loops:num pitch:num radius:num samples:num perloop:num -> curve",
     "Cubic spline near a helix of one pitch per loop; a negative radius grows "
     "from 0.",
     "c = chelix(2, 0.3, 1, 200, 8);", chelix, 0, 7},
    {"CSPIRAL", "loops:num pitch:num samples:num perloop:num -> curve",
     "Cubic spline near a spiral from the origin.",
     "c = cspiral(3, 0.5, 300, 8);", cspiral, 0, 7},
    {"CSINE", "cycles:num samples:num percycle:num -> curve",
     "Cubic spline near a sine curve.", "c = csine(2, 200, 8);", csine, 0, 7},
    {"CNC2QUAD", "coefs:list z:num -> list",
     "Quadric (10 coefficients) over a central conic (6), of half height z.",
     "l = cnc2quad(list(1,0,1,0,0,-1), 0.5);", cnc2quad, 0, 7},
    {"ELLIPSE3PT", "p1:pt3 p2:pt3 p3:pt3 offset:num -> list",
     "Coefficients of the smallest ellipse through three points, enlarged by "
     "offset.",
     "l = ellipse3pt(point(0,0,0), point(1,0,0), point(0,1,0), 0);", ellipse3pt,
     0, 7},
    {"IMPLCTRANS", "oper:num coefs:list m:matrix -> list",
     "Coefficients of a transformed conic (6) or quadric (10).",
     "l = implctrans(0, list(1,0,1,0,0,-1), trans(vector(1,0,0)));", implctrans,
     0, 7},
    {"LINTERP", "pts:list -> list",
     "list(point, direction, mean distance) of the line nearest to points.",
     "l = linterp(list(point(0,0,0), point(1,1,0), point(2,2,1)));", linterp, 0,
     7},
    {"PINTERP", "pts:list -> list",
     "list(plane, mean distance) of the plane nearest to points.",
     "l = pinterp(list(point(0,0,1), point(1,0,1), point(1,1,1), "
     "point(0,1,1)));",
     pinterp, 0, 7},
    {0}};
