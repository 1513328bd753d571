/* builtins_envelope.c - envelopes of cones, adaptive isoparametric curves,
 * curvature of level surfaces (chapters 13, 15 and 20 of spec/functions). */
#include "geom/cone_envelope.h"
#include "geom/iso_curvature.h"
#include "geom/iso_curves.h"
#include "lang/args_freeform.h"
#include "mv/mv.h"

static ix_status cenvoff(ix_call *c)
{
    double tol = ix__arg_num(c, 2);
    ix_mv *s[2];
    ix_obj *list;
    ix_status st = IX_OK;

    if (!(tol > 0))
        return IX_ARG_FAIL(c, 2, "a tolerance of %g; it must be positive", tol);
    IX_TRY(ix__cone_envelope(c->ctx, ix__arg_mv(c, 0), ix__arg_num(c, 1), tol,
                             &s[0], &s[1]));
    if (!s[1])
        return ix__ret_mv(c, -1, s[0]);
    list = ix__obj_list(c->ctx);
    for (int k = 0; k < 2; k++) { /* both are taken over */
        ix_obj *o = ix__obj_mv(c->ctx, IX_OBJ_SURFACE, s[k]);
        ix_status added = ix__list_add(c->ctx, list, o);

        st = st == IX_OK ? added : st;
    }
    return ix__ret_list(c, list, st);
}

/* The curves wanted by ADAPISO: parts, or wholes as such. */
static ix_status iso_parts(ix_call *c, int dir, int *n, ix__iso_part **part)
{
    const ix_mv *s = ix__arg_mv(c, 0);
    double *t;

    if (!ix__arg_bool(c, 4))
        return ix__iso_parts(c->ctx, s, dir, ix__arg_num(c, 3), n, part);
    IX_TRY(ix__iso_params(c->ctx, s, dir, ix__arg_num(c, 3), n, &t));
    IX_SCRATCH(c->ctx, *part, *n);
    for (int i = 0; i < *n; i++) {
        (*part)[i] = (ix__iso_part){.t = t[i]};
        ix_mv_domain(s, 1 - dir, (*part)[i].range);
    }
    return IX_OK;
}

static ix_status iso_curve(ix_call *c, int dir, const ix__iso_part *p,
                           ix_mv **out)
{
    double dom[2];
    ix_mv *whole;
    ix_status st;

    IX_TRY(ix_mv_fix(c->ctx, ix__arg_mv(c, 0), dir, p->t, &whole));
    ix_mv_domain(whole, 0, dom);
    if (p->range[0] <= dom[0] && p->range[1] >= dom[1]) {
        *out = whole;
        return IX_OK;
    }
    st = ix_mv_region(c->ctx, whole, 0, p->range[0], p->range[1], out);
    ix_mv_unref(c->ctx, whole);
    return st;
}

static ix_status add_iso(ix_call *c, int dir, const ix__iso_part *p,
                         ix_obj *list)
{
    ix_mv *crv;
    ix_obj *o;

    IX_TRY(iso_curve(c, dir, p, &crv));
    o = ix__obj_mv(c->ctx, IX_OBJ_CURVE, crv);
    if (o &&
        (ix__attr_set_real(c->ctx, &o->attrs, "IsoParam", p->t) != IX_OK ||
         (!ix__arg_bool(c, 4) &&
          ix__attr_set_int(c->ctx, &o->attrs, "Level", p->level) != IX_OK))) {
        ix__obj_unref(c->ctx, o);
        o = NULL;
    }
    return ix__list_add(c->ctx, list, o);
}

/* All curves linked in one object. */
static ix_status ret_linked(ix_call *c, int dir, int n, const ix__iso_part *p)
{
    const ix_mvs *all = NULL;
    ix_status st = IX_OK;
    int made = 0;
    ix_mv **crv;

    IX_SCRATCH(c->ctx, crv, n);
    for (; st == IX_OK && made < n; made += st == IX_OK)
        st = iso_curve(c, dir, &p[made], &crv[made]);
    if (st == IX_OK)
        all = ix__mvs_new(c->ctx, n, (const ix_mv *const *)crv);
    for (int i = 0; i < made; i++)
        ix_mv_unref(c->ctx, crv[i]);
    IX_TRY(st);
    return all ? ix__ret(c, ix__obj_mvs(c->ctx, IX_OBJ_CURVE, all)) : IX_ENOMEM;
}

static ix_status adapiso(ix_call *c)
{
    ix__iso_part *part;
    ix_obj *list;
    ix_status st;
    int dir, n;

    if (!ix__arg_bool(c, 1))
        return IX_ARG_FAIL(c, 1, "tilings are not known here; true is wanted");
    IX_TRY(ix__arg_dir(c, 2, 2, &dir));
    IX_TRY(iso_parts(c, dir, &n, &part));
    if (ix__arg_bool(c, 5))
        return ret_linked(c, dir, n, part);
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < n; i++)
        st = add_iso(c, dir, &part[i], list);
    return ix__ret_list(c, list, st);
}

/* --- level surfaces
 * ------------------------------------------------------------- */

static ix_status ret_curvature(ix_call *c, const ix__level_point *p)
{
    ix_obj *list;
    ix_status st;

    if (!p->regular)
        return IX_FAIL(c->ctx, IX_EDOMAIN,
                       "the gradient is 0: no level surface passes there");
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < 2; i++)
        st = ix__list_add_num(c->ctx, list, p->k[i]);
    for (int i = 0; st == IX_OK && i < 2; i++)
        st = ix__list_add(c->ctx, list, ix__obj_vector(c->ctx, p->dir[i]));
    return ix__ret_list(c, list, st);
}

static ix_status ret_hessian(ix_call *c, const ix__level_point *p)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < 3; i++)
        st = ix__list_add(c->ctx, list,
                          ix__obj_vector(c->ctx, p->hessian + 3 * i));
    return ix__ret_list(c, list, st);
}

static ix_status tcrvtr(ix_call *c)
{
    ix__level_point p;
    double t[3];
    int what;

    IX_TRY(ix__arg_pt3(c, 1, t));
    IX_TRY(ix__arg_int(c, 2, -1, 3, &what));
    if (what < 1) /* nothing is to be prepared or ended */
        return ix__ret_num(c, 1);
    IX_TRY(ix__level_curvature(c->ctx, ix__arg_mv(c, 0), t, &p));
    if (what == 1)
        return ix__ret_vector(c, p.gradient);
    return what == 2 ? ret_hessian(c, &p) : ret_curvature(c, &p);
}

/* --- table ------------------------------------------------------------- */

#define C "c = circle(vector(0,0,0), 1); "
#define S "s = spheresrf(1); "
#define FIELD                                                                \
    "t = tbezier(list(list(list(ctlpt(E1,0), ctlpt(E1,1)), "                 \
    "list(ctlpt(E1,2), ctlpt(E1,5))), list(list(ctlpt(E1,3), ctlpt(E1,4)), " \
    "list(ctlpt(E1,0), ctlpt(E1,1))))); "

const ix_builtin ix__builtins_envelope[] = {
    {"CENVOFF", "c:curve height:num tol:num -> surface|list",
     "The envelope of 45 degree cones with their apices on a smooth planar "
     "curve, from z = 0 up to a height: offsets by the height, within tol, lie "
     "at its upper end. An open curve gives one surface, its ends included; a "
     "closed one list(left, right of its direction).",
     C "l = cenvoff(c, 0.2, 0.01);", cenvoff, 0, 20},
    {"ADAPISO",
     "s:surface genIsos:bool dir:num eps:num full:bool single:bool "
     "weight:list -> curve|list",
     "Isoparametric curves of fixed COL (u) or ROW (v), with attribute "
     "IsoParam, so dense that neighbours are within eps of each other: with "
     "full whole ones (a bound), else parts, only where the curves around them "
     "are farther apart, with attribute Level; with single all linked in one "
     "object. genIsos must be true, the weight is not needed.",
     S "l = adapiso(s, true, COL, 0.5, true, false, nil());", adapiso, 0, 13},
    {"TCRVTR", "t:trivar p:pt3 what:num -> any",
     "Of a scalar trivariate at parameters p: 1 the gradient, 2 the rows of "
     "the Hessian, 3 the principal curvatures of the level surface, for the "
     "normal along the gradient, and their directions, list(k1, k2, d1, d2); "
     "-1 and 0, which would prepare and end, give 1.",
     FIELD "l = tcrvtr(t, point(0.4, 0.3, 0.6), 3);", tcrvtr, 0, 15},

    {0}};
