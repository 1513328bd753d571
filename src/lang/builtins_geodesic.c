/* builtins_geodesic.c - distances on surfaces (chapter 22). */
#include <math.h>

#include "iritx/geodesic.h"
#include "lang/args_freeform.h"

/* --- results -------------------------------------------------------------- */

/* Appends one of the multivariates of a curve, which is taken over. */
static ix_status add_part(ix_call *c, ix_obj *list, ix_mv **part)
{
    ix_obj *o = ix__obj_mv(c->ctx, IX_OBJ_CURVE, *part);

    *part = NULL;
    return ix__list_add(c->ctx, list, o);
}

static ix_status set_attributes(ix_call *c, ix_obj *list, const ix_geo_curve *g)
{
    ix_attr **a = &list->attrs;

    IX_TRY(ix__attr_set_real(c->ctx, a, "Miss", g->miss));
    IX_TRY(ix__attr_set_real(c->ctx, a, "Fit", g->fit));
    IX_TRY(
        ix__attr_set_string(c->ctx, a, "Stop2", ix_geo_stop_name(g->stop[1])));
    return ix__attr_set_string(c->ctx, a, "Stop1",
                               ix_geo_stop_name(g->stop[0]));
}

/* list(curve of the parameter plane, curve in space, states); takes over what
 * g holds. */
static ix_status curve_list(ix_call *c, ix_geo_curve *g, ix_obj **out)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    if (st == IX_OK)
        st = add_part(c, list, &g->uv);
    if (st == IX_OK)
        st = add_part(c, list, &g->space);
    if (st == IX_OK)
        st = add_part(c, list, &g->states);
    if (st == IX_OK)
        st = set_attributes(c, list, g);
    ix_geo_curve_free(c->ctx, g);
    if (st != IX_OK) {
        ix__obj_unref(c->ctx, list);
        list = NULL;
    }
    *out = list;
    return st;
}

static ix_status ret_curve(ix_call *c, ix_geo_curve *g)
{
    ix_obj *list;

    IX_TRY(curve_list(c, g, &list));
    return ix__ret(c, list);
}

/* A list of such lists; takes over what g holds. */
static ix_status ret_curves(ix_call *c, ix_geo_curves *g)
{
    ix_obj *all = ix__obj_list(c->ctx), *one;
    ix_status st = all ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < g->n; i++) {
        st = curve_list(c, &g->crv[i], &one);
        if (st == IX_OK)
            st = ix__list_add(c->ctx, all, one);
    }
    ix_geo_curves_free(c->ctx, g);
    return ix__ret_list(c, all, st);
}

/* --- arguments ----------------------------------------------------------- */

static ix_geo_surface surface_of(const ix_call *c)
{
    return (ix_geo_surface){.mv = ix__arg_mv(c, 0)};
}

/* The tolerance, argument i if there is one. */
static ix_status options(ix_call *c, int i, ix_geo_opts *o)
{
    *o = (ix_geo_opts){0};
    if (i >= c->argc)
        return IX_OK;
    o->tol = ix__arg_num(c, i);
    if (!(o->tol >= 0))
        return IX_ARG_FAIL(c, i,
                           "tolerance %g: a length above 0 is wanted, or 0 for "
                           "1e-8 of the surface's size",
                           o->tol);
    return IX_OK;
}

static ix_status side_of(ix_call *c, int i, double x, int *out)
{
    if (x != 1 && x != -1)
        return IX_ARG_FAIL(c, i,
                           "side %g: 1 (left of the curve, seen against the "
                           "normal S_u x S_v) or -1 (right) is wanted",
                           x);
    *out = (int)x;
    return IX_OK;
}

/* A list of n numbers; NULL if it is none. */
static ix_status numbers(ix_call *c, int i, int n, const char *what,
                         double *out)
{
    double *v;
    int have = -1;

    if (c->argv[i]->type == IX_OBJ_LIST)
        IX_TRY(ix__arg_nums(c, i, &have, &v));
    if (have != n)
        return IX_ARG_FAIL(c, i, "%s is wanted", what);
    for (int k = 0; k < n; k++)
        out[k] = v[k];
    return IX_OK;
}

/* --- functions ----------------------------------------------------------- */

static ix_status geodesic(ix_call *c)
{
    const ix_geo_surface s = surface_of(c);
    double uv[3], dir[3], conjugate;
    ix_geo_opts o;
    ix_geo_curve g;

    IX_TRY(ix__arg_pt3(c, 1, uv));
    IX_TRY(ix__arg_pt3(c, 2, dir));
    IX_TRY(options(c, 4, &o));
    IX_TRY(ix_geodesic(c->ctx, &s, uv, dir, ix__arg_num(c, 3), &o, &conjugate,
                       &g));
    IX_TRY(ret_curve(c, &g));
    if (isnan(conjugate))
        return IX_OK;
    return ix__attr_set_real(c->ctx, &c->result->attrs, "Conjugate", conjugate);
}

static ix_status geodnrml(ix_call *c)
{
    const ix_geo_surface s = surface_of(c);
    ix_geo_opts o;
    ix_geo_curve g;

    IX_TRY(options(c, 4, &o));
    IX_TRY(ix_geodesic_normal(c->ctx, &s, ix__arg_mv(c, 1), ix__arg_num(c, 2),
                              ix__arg_num(c, 3), false, &o, &g));
    return ret_curve(c, &g);
}

static ix_status geodcrvtr(ix_call *c)
{
    const ix_geo_surface s = surface_of(c);
    double kg[2];

    IX_TRY(ix_geodesic_curvature(c->ctx, &s, ix__arg_mv(c, 1),
                                 ix__arg_num(c, 2), kg));
    return ix__ret_num(c, kg[0]);
}

/* The parameters of cusps as an attribute of the result. */
static ix_status set_cusps(ix_call *c, int n, const double *t)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < n; i++)
        st = ix__list_add_num(c->ctx, list, t[i]);
    if (st == IX_OK)
        st = ix__attr_set_obj(c->ctx, &c->result->attrs, "Cusps", list);
    ix__obj_unref(c->ctx, list);
    return st;
}

static ix_status geodoffset(ix_call *c)
{
    const ix_geo_surface s = surface_of(c);
    bool number = c->argv[2]->type == IX_OBJ_NUMBER;
    ix_geo_opts o;
    ix_geo_curves g;
    double *cusps;
    ix_status st;
    int n;

    IX_TRY(options(c, 3, &o));
    IX_TRY(ix_geodesic_offset(
        c->ctx, &s, ix__arg_mv(c, 1), number ? ix__arg_num(c, 2) : 0.0,
        number ? NULL : ix__arg_mv(c, 2), &o, &n, &cusps, &g));
    st = ret_curves(c, &g);
    if (st == IX_OK)
        st = set_cusps(c, n, cusps);
    ix_geo_numbers_free(c->ctx, cusps, n);
    return st;
}

/* Sides: list(a, b), or list() for all. */
static ix_status medial_sides(ix_call *c, int side[2])
{
    double v[2];

    side[0] = side[1] = 0;
    if (c->argv[3]->type == IX_OBJ_LIST && c->argv[3]->u.list.n == 0)
        return IX_OK;
    IX_TRY(numbers(c, 3, 2, "list(side1, side2), or list() for all sides,", v));
    IX_TRY(side_of(c, 3, v[0], &side[0]));
    return side_of(c, 3, v[1], &side[1]);
}

static ix_status medial_start(ix_call *c, ix_medial_opts *m)
{
    if (c->argc <= 5)
        return IX_OK;
    if (c->argv[5]->type == IX_OBJ_NUMBER) {
        if (ix__arg_bool(c, 5))
            m->start = IX_MEDIAL_ENDS;
        return IX_OK;
    }
    m->start = IX_MEDIAL_GUESS;
    return numbers(c, 5, 3, "true, false or list(t1, t2, distance)", m->guess);
}

static ix_status medialcrv(ix_call *c)
{
    const ix_geo_surface s = surface_of(c);
    ix_medial_opts m = {.start = IX_MEDIAL_AUTO};
    ix_geo_opts o;
    ix_geo_curves g;

    IX_TRY(medial_sides(c, m.sides));
    IX_TRY(options(c, 4, &o));
    IX_TRY(medial_start(c, &m));
    IX_TRY(ix_medial_crv(c->ctx, &s, ix__arg_mv(c, 1), ix__arg_mv(c, 2), &m, &o,
                         &g));
    return ret_curves(c, &g);
}

static ix_status srffocalcrv(ix_call *c)
{
    const ix_geo_surface s = surface_of(c);
    ix_geo_opts o;
    ix_geo_curves g;
    int side;

    IX_TRY(side_of(c, 2, ix__arg_num(c, 2), &side));
    IX_TRY(options(c, 3, &o));
    IX_TRY(ix_srf_focal_crv(c->ctx, &s, ix__arg_mv(c, 1), side, &o, &g));
    return ret_curves(c, &g);
}

/* --- table --------------------------------------------------------------- */

#define BUMP                                                             \
    "s = sbezier(list(list(ctlpt(E3, 0, 0, 0), ctlpt(E3, 0, 1, 0), "     \
    "ctlpt(E3, 0, 2, 0)), list(ctlpt(E3, 1, 0, 0), ctlpt(E3, 1, 1, 2), " \
    "ctlpt(E3, 1, 2, 0)), list(ctlpt(E3, 2, 0, 0), ctlpt(E3, 2, 1, 0), " \
    "ctlpt(E3, 2, 2, 0)))); "
#define LINE(name, u0, v0, u1, v1)                                     \
    name " = cbezier(list(ctlpt(E2, " #u0 ", " #v0 "), ctlpt(E2, " #u1 \
         ", " #v1 "))); "

const ix_builtin ix__builtins_geodesic[] = {
    {"GEODESIC", "s:surface uv:pv dir:pv len:num [tol:num] -> list",
     "The geodesic of a length from a point of the parameter plane in a "
     "direction of it: list(curve in the parameter plane, curve in space, "
     "states (s, u, v, y, y')).",
     BUMP "g = geodesic(s, point(0.1, 0.1, 0), vector(1, 0.8, 0), 2);",
     geodesic, 0, 22},
    {"GEODNRML", "s:surface crv:curve t:num len:num [tol:num] -> list",
     "As GEODESIC: the geodesic at a right angle to a curve of the parameter "
     "plane at t, to its left if len is positive; y is the length of the "
     "offsets' derivatives along it.",
     BUMP LINE("c", 0.1, 0.3, 0.9, 0.2) "g = geodnrml(s, c, 0.5, 1);", geodnrml,
     0, 22},
    {"GEODCRVTR", "s:surface crv:curve t:num -> num",
     "The geodesic curvature of a curve of the parameter plane at t, positive "
     "if it turns left.",
     BUMP LINE("c", 0.1, 0.3, 0.9, 0.2) "k = geodcrvtr(s, c, 0.5);", geodcrvtr,
     0, 22},
    {"GEODOFFSET", "s:surface crv:curve dist:num|curve [tol:num] -> list",
     "The geodesic offset of a curve of the parameter plane, to its left if "
     "dist is positive; dist may be a scalar curve. A list of lists (curve in "
     "the parameter plane, curve in space, states (t, u, v, y, distance)).",
     BUMP LINE("c", 0.1, 0.3, 0.9, 0.2) "o = geodoffset(s, c, 0.3);",
     geodoffset, 0, 22},
    {"MEDIALCRV",
     "s:surface crv1:curve crv2:curve sides:list tol:num [start:any] -> list",
     "Medial curves of two curves of the parameter plane: points at the same "
     "geodesic distance from both, on the sides list(1 or -1, 1 or -1). A list "
     "of lists (curve in the parameter plane, curve in space, states (t1, s, "
     "t2, distance)). start true: all that begin at ends of the curves; "
     "list(t1, t2, distance): near these.",
     BUMP LINE("a", 0.1, 0.2, 0.9, 0.1) LINE(
         "b", 0.1, 0.6, 0.9, 0.8) "m = medialcrv(s, a, b, list(1, -1), 1e-6);",
     medialcrv, 0, 22},
    {"SRFFOCALCRV", "s:surface crv:curve side:num tol:num -> list",
     "The first focal points on one side (1 left, -1 right) of a curve of the "
     "parameter plane. A list of lists (curve in the parameter plane, curve in "
     "space, states (t, s, u, v, ds/dt)).",
     BUMP "c = cbezier(list(ctlpt(E2, 0.2, 0.8), ctlpt(E2, 0.5, 0), "
          "ctlpt(E2, 0.8, 0.8))); f = srffocalcrv(s, c, 1, 1e-6);",
     srffocalcrv, 0, 22},
    {0}};
