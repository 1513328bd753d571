/* builtins_volume.c - trivariates of revolution and from faces (chapter 15),
 * Hermite surfaces along a section (chapter 11 of spec/functions). */
#include <string.h>

#include "geom/section_hermite.h"
#include "geom/tv_boolsum.h"
#include "iritx/geom_srf.h"
#include "lang/args_freeform.h"
#include "lang/codes.h"
#include "mv/mv.h"

/* list(surface, from and to degrees, a point of the axis, its direction): all
 * but the surface may be missing. */
static ix_status fetch_revolution(ix_call *c, const ix_mv **srf,
                                  ix_revolution *r)
{
    const ix_list *l = &c->argv[0]->u.list;
    int angles = 0;

    *srf = l->n > 0 && l->item[0]->type == IX_OBJ_SURFACE
               ? ix__obj_first_mv(l->item[0])
               : NULL;
    if (!*srf)
        return IX_ARG_FAIL(c, 0, "a list has the surface as its first element");
    for (int i = 1; i < l->n; i++) {
        const ix_obj *o = l->item[i];

        if (o->type == IX_OBJ_NUMBER && angles < 2)
            *(angles++ ? &r->a1 : &r->a0) = o->u.num;
        else if (o->type == IX_OBJ_POINT)
            memcpy(r->point, o->u.pt, sizeof r->point);
        else if (o->type == IX_OBJ_VECTOR)
            memcpy(r->axis, o->u.pt, sizeof r->axis);
        else
            return IX_ARG_FAIL(c, 0,
                               "element %d is a %s; two angles, a point and a "
                               "vector may follow the surface",
                               i + 1, ix__obj_type_name(o->type));
    }
    if (angles == 1)
        return IX_ARG_FAIL(c, 0, "one angle; from and to are wanted");
    return IX_OK;
}

static ix_status revolved(ix_call *c, ix_turn turn)
{
    ix_revolution r = {.turn = turn, .a1 = 360, .axis = {0, 0, 1}};
    const ix_mv *srf;
    ix_mv *out;

    if (c->argv[0]->type == IX_OBJ_LIST) {
        IX_TRY(fetch_revolution(c, &srf, &r));
        IX_TRY(ix_tv_revolve_about(c->ctx, srf, &r, &out));
    } else {
        IX_TRY(ix_tv_revolve(c->ctx, ix__arg_mv(c, 0), turn, &out));
    }
    return ix__ret_mv(c, -1, out);
}

static ix_status tvrev(ix_call *c)
{
    return revolved(c, IX_TURN_RATIONAL);
}

static ix_status tvprev(ix_call *c)
{
    return revolved(c, IX_TURN_POLYNOMIAL);
}

static ix_status tboolone(ix_call *c)
{
    ix_mv *out;

    IX_TRY(ix__tv_boolone(c->ctx, ix__arg_mv(c, 0), &out));
    return ix__ret_mv(c, -1, out);
}

/* v = 0, 1; u = 0, 1; w = 0, 1 as BOOLSUM has its curves. */
static ix_status tboolsum(ix_call *c)
{
    const ix_mv *f[6] = {ix__arg_mv(c, 2), ix__arg_mv(c, 3), ix__arg_mv(c, 0),
                         ix__arg_mv(c, 1)};
    ix_mv *out;
    int given = 0;

    for (int i = 4; i < 6; i++)
        if (c->argv[i]->type == IX_OBJ_SURFACE) {
            f[i] = ix__arg_mv(c, i);
            given++;
        }
    if (given == 1)
        return IX_ARG_FAIL(c, f[4] ? 5 : 4,
                           "one of the two end faces is missing");
    IX_TRY(ix__tv_boolsum(c->ctx, f, &out));
    return ix__ret_mv(c, -1, out);
}

static ix_status blhermite(ix_call *c)
{
    const ix_mv *crv[6];
    ix_mv *out;

    for (int i = 0; i < 6; i++)
        crv[i] = ix__arg_mv(c, i);
    IX_TRY(ix__srf_section_hermite(c->ctx, crv, &out));
    return ix__ret_mv(c, -1, out);
}

/* A number, or a curve that multiplies 1. */
static void number_or_curve(const ix_call *c, int i, double *x,
                            const ix_mv **crv)
{
    *x = 1;
    if (c->argv[i]->type == IX_OBJ_NUMBER)
        *x = ix__arg_num(c, i);
    else
        *crv = ix__arg_mv(c, i);
}

static ix_status blshermite(ix_call *c)
{
    ix_rib o = {.path = ix__arg_mv(c, 1),
                .section = ix__arg_mv(c, 2),
                .tan_scale = ix__arg_num(c, 3)};
    ix_mv *out;

    if (!(o.tan_scale > 0))
        return IX_ARG_FAIL(c, 3,
                           "tangents scaled by %g; a positive number is "
                           "wanted",
                           o.tan_scale);
    number_or_curve(c, 4, &o.width, &o.width_crv);
    number_or_curve(c, 5, &o.height, &o.height_crv);
    IX_TRY(ix_srf_rib(c->ctx, ix__arg_mv(c, 0), &o, &out));
    return ix__ret_mv(c, -1, out);
}

#define S                                                                \
    "s = ruledsrf(ctlpt(E3,1,0,0) + ctlpt(E3,2,0,0), ctlpt(E3,1,0,1) + " \
    "ctlpt(E3,2,0,1)); "

const ix_builtin ix__builtins_volume[] = {
    {"TVREV", "s:surface|list -> trivar",
     "A surface turned about Z: (u, v) its parameters, w the rotation over "
     "[0, 4], a quarter a unit. A list holds the surface and, as far as "
     "wanted, "
     "two angles in degrees (from, to), a point of the axis and its direction, "
     "a vector.",
     S "t = tvrev(s);", tvrev, 0, 15},
    {"TVPREV", "s:surface|list -> trivar",
     "The same with a polynomial approximation of the circle.",
     S "t = tvprev(s);", tvprev, 0, 15},
    {"TBOOLONE", "s:surface -> trivar",
     "A tube that is closed in u, filled: for each v, which becomes w, the "
     "patch of BOOLONE of its curve.",
     "t = tboolone(extrude(circle(vector(0,0,0), 1), vector(0,0,1), 0));",
     tboolone, 0, 15},
    {"TBOOLSUM",
     "s1:surface s2:surface s3:surface s4:surface s5:any s6:any -> trivar",
     "The trilinearly blended volume of its polynomial faces: s1, s2 in (u, w) "
     "at v = 0, 1; s3, s4 in (v, w) at u = 0, 1; s5, s6 in (u, v) at w = 0, 1, "
     "or both 0: then each w has the patch of its four edges.",
     S "t = tboolsum(s, s * ty(1), ruledsrf(ctlpt(E3,1,0,0) + ctlpt(E3,1,1,0), "
       "ctlpt(E3,1,0,1) + ctlpt(E3,1,1,1)), ruledsrf(ctlpt(E3,2,0,0) + "
       "ctlpt(E3,2,1,0), ctlpt(E3,2,0,1) + ctlpt(E3,2,1,1)), 0, 0);",
     tboolsum, 0, 15},
    {"BLHERMITE",
     "b1:curve b2:curve t1:curve t2:curve section:curve normal:curve -> "
     "surface",
     "The Hermite surface of HERMITE whose parameter runs as the x of a planar "
     "section from (-1, 0) to (1, 0), raised by its y along the normal field: "
     "H((1 + x(u)) / 2, v) + y(u) normal(v).",
     "b = ctlpt(E3,0,0,0) + ctlpt(E3,0,3,0); t = ctlpt(E3,1,0,0) + "
     "ctlpt(E3,1,0,0); g = cbezier(list(ctlpt(E2,-1,0), ctlpt(E2,0,0), "
     "ctlpt(E2,0,2), ctlpt(E2,0,0), ctlpt(E2,1,0))); s = blhermite(b, b * "
     "tx(2), t, t, g, ctlpt(E3,0,0,1) + ctlpt(E3,0,0,1));",
     blhermite, 0, 11},
    {"BLSHERMITE",
     "s:surface pc:curve section:curve tanScale:num width:num|curve "
     "height:num|curve -> surface",
     "A rib along the curve pc = (u, v)(t) on a surface, in exact tangent "
     "contact with it: BLHERMITE between the borders at half the width on both "
     "sides of pc, tangents being those of s across, times tanScale; the "
     "section, from (-1, 0) to (1, 0), is raised along SNORMAL times the "
     "height. Width and height may be curves, whose y (or only coordinate) "
     "counts. The section's parameter is u, pc's v; x = 1 is on the left of "
     "pc.",
     "s = sbezier(list(list(point(0,0,0), point(1,0,0)), list(point(0,1,0), "
     "point(1,1,1)))); g = cbezier(list(ctlpt(E2,-1,0), ctlpt(E2,0,0), "
     "ctlpt(E2,0,2), ctlpt(E2,0,0), ctlpt(E2,1,0))); r = blshermite(s, "
     "ctlpt(E2,0.1,0.5) + ctlpt(E2,0.9,0.5), g, 1, 0.2, 0.1);",
     blshermite, 0, 11},
    {0}};
