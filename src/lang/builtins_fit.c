/* builtins_fit.c - freeforms near others and near points (chapters 11, 15 and
 * 24 of spec/functions). */
#include <string.h>

#include "iritx/geom_srf.h"
#include "lang/args_freeform.h"

static ix_status add_errors(ix_call *c, ix_obj *o, const ix_fit_error *err)
{
    IX_TRY(ix__attr_set_real(c->ctx, &o->attrs, "Error", err->rms));
    return ix__attr_set_real(c->ctx, &o->attrs, "MaxError", err->largest);
}

static ix_status ruledfit(ix_call *c)
{
    ix_ruled_opts o = {.extend = ix__arg_num(c, 2)};
    ix_fit_error err;
    ix_mv *out;
    ix_obj *r;

    IX_TRY(ix__arg_dir(c, 1, 2, &o.dir));
    if (!(o.extend >= 0 && o.extend <= 1))
        return IX_ARG_FAIL(c, 2, "an extension by %g; 0 .. 1 is possible",
                           o.extend);
    IX_TRY(ix__arg_int(c, 3, 2, 1000, &o.samples));
    c->bad_arg = 1;
    IX_TRY(ix_srf_fit_ruled(c->ctx, ix__arg_mv(c, 0), &o, &err, &out));
    c->bad_arg = 0;
    r = ix__obj_mv(c->ctx, IX_OBJ_SURFACE, out);
    if (r && (ix__attr_set_real(c->ctx, &r->attrs, "Error", err.rms) != IX_OK ||
              ix__attr_set_real(c->ctx, &r->attrs, "MaxError", err.largest) !=
                  IX_OK)) {
        ix__obj_unref(c->ctx, r);
        r = NULL;
    }
    return ix__ret(c, r);
}

/* --- splines through data, or nearest to them
 * ---------------------------------- */

typedef struct {
    int ndirs;
    int order[3], size[3];
} fit_args;

/* A grid of points, in lists as deep as there are directions. */
static ix_status fit_grid(ix_call *c, const fit_args *f)
{
    ix_mesh m;
    ix_mv *out;

    IX_TRY(ix__arg_mesh(c, 0, f->ndirs, &m));
    IX_TRY(ix_mv_fit_grid(c->ctx, f->ndirs, m.length, m.ncoords, m.rational,
                          m.pts, f->order, f->size, &out));
    return ix__ret_mv(c, -1, out);
}

/* Control points (parameters, values ...). */
static ix_status fit_scattered(ix_call *c, const fit_args *f)
{
    int n, ncoords;
    bool rational;
    double *pts;
    ix_cloud cloud;
    ix_mv *out;

    IX_TRY(ix__arg_points(c, c->argv[0], &n, &ncoords, &rational, &pts));
    if (rational || ncoords <= f->ndirs)
        return IX_ARG_FAIL(c, 0,
                           "scattered points need the coordinates %s and at "
                           "least one value, not %c%d",
                           f->ndirs == 2 ? "u, v" : "u, v, w",
                           rational ? 'P' : 'E', ncoords);
    cloud = (ix_cloud){f->ndirs, n, pts, ncoords - f->ndirs,
                       pts + (size_t)f->ndirs * (size_t)n};
    IX_TRY(ix_mv_fit_points(c->ctx, &cloud, f->order, f->size, &out));
    return ix__ret_mv(c, -1, out);
}

static ix_status fit_list(ix_call *c, const fit_args *f)
{
    const ix_list *l = &c->argv[0]->u.list;

    return l->n > 0 && l->item[0]->type == IX_OBJ_LIST ? fit_grid(c, f)
                                                       : fit_scattered(c, f);
}

/* list(surface, error) near the surface of argument 0. */
static ix_status fit_surface(ix_call *c, const fit_args *f)
{
    ix_obj *list;
    ix_status st;
    double err;
    ix_mv *out;

    IX_TRY(ix_srf_fit_surface(c->ctx, ix__arg_mv(c, 0), f->order, f->size, &err,
                              &out));
    list = ix__obj_list(c->ctx);
    st = ix__list_add(c->ctx, list, ix__obj_mv(c->ctx, IX_OBJ_SURFACE, out));
    if (st == IX_OK)
        st = ix__list_add_num(c->ctx, list, err);
    return ix__ret_list(c, list, st);
}

static ix_status sinterp(ix_call *c)
{
    fit_args f = {.ndirs = 2};

    for (int d = 0; d < 2; d++) {
        IX_TRY(ix__arg_int(c, 1 + d, 1, IX_MAX_ORDER, &f.order[d]));
        IX_TRY(ix__arg_int(c, 3 + d, 0, 10000, &f.size[d]));
    }
    if (ix__arg_num(c, 5) != IX__PARAM_UNIFORM)
        return IX_ARG_FAIL(c, 5, "only PARAM_UNIFORM is possible");
    return c->argv[0]->type == IX_OBJ_SURFACE ? fit_surface(c, &f)
                                              : fit_list(c, &f);
}

static ix_status tinterp(ix_call *c)
{
    fit_args f = {.ndirs = 3};
    ix_mv *out;

    for (int d = 0; d < 3; d++) {
        IX_TRY(ix__arg_int(c, 1 + d, 0, 10000, &f.size[d]));
        IX_TRY(ix__arg_int(c, 4 + d, 0, IX_MAX_ORDER, &f.order[d]));
    }
    if (c->argv[0]->type == IX_OBJ_LIST)
        return fit_list(c, &f);
    IX_TRY(ix_mv_fit_nodes(c->ctx, ix__arg_mv(c, 0), f.order, f.size, &out));
    return ix__ret_mv(c, -1, out);
}

/* --- forms ------------------------------------------------------------------
 */

/* The coordinates of a point, vector or control point (projected): v, their
 * number; 0 of anything else and of a weight 0. */
static int place(const ix_obj *o, double v[IX_MAX_COORDS])
{
    const ix_ctlpt *p = o->u.ctlpt;

    if (o->type == IX_OBJ_POINT || o->type == IX_OBJ_VECTOR) {
        memcpy(v, o->u.pt, 3 * sizeof *v);
        return 3;
    }
    if (o->type != IX_OBJ_CTLPT || (p->rational && p->v[0] == 0))
        return 0;
    for (int k = 0; k < p->ncoords; k++)
        v[k] = p->v[p->rational + k] / (p->rational ? p->v[0] : 1);
    return p->ncoords;
}

/* Argument i as double[want][n]; want 0: as many coordinates as the first one
 * has. At least want coordinates each, or exactly as many as the first. */
static ix_status places(ix_call *c, int i, int want, int *ncoords, double **out)
{
    const ix_list *l = &c->argv[i]->u.list;
    double v[IX_MAX_COORDS];

    *ncoords = want ? want : l->n > 0 ? place(l->item[0], v) : 0;
    IX_SCRATCH(c->ctx, *out, (size_t)*ncoords * (size_t)l->n);
    for (int k = 0; k < l->n; k++) {
        int got = place(l->item[k], v);

        if (got == 0 || (want ? got < want : got != *ncoords))
            return IX_ARG_FAIL(c, i,
                               "element %d is a %s of %d coordinates; a point "
                               "of %d is wanted",
                               k + 1, ix__obj_type_name(l->item[k]->type), got,
                               *ncoords);
        for (int j = 0; j < *ncoords; j++)
            (*out)[(size_t)j * (size_t)l->n + (size_t)k] = v[j];
    }
    return IX_OK;
}

/* Coefficient k of each coordinate as a point, or control point. */
static ix_obj *coefficient(ix_call *c, int ncoords, int terms,
                           const double *coef, int k)
{
    ix_ctlpt p = {.ncoords = ncoords};

    for (int j = 0; j < ncoords; j++)
        p.v[j] = coef[j * terms + k];
    return ncoords == 3 ? ix__obj_point(c->ctx, p.v)
                        : ix__obj_ctlpt(c->ctx, &p);
}

static ix_status add_center(ix_call *c, ix_obj *o, const double center[3])
{
    ix_obj *p = ix__obj_point(c->ctx, center);
    ix_status st = p ? ix__attr_set_obj(c->ctx, &o->attrs, "Center", p)
                     : IX_ENOMEM;

    ix__obj_unref(c->ctx, p);
    return st;
}

static ix_status analyfit(ix_call *c)
{
    int two, kind, terms, power[IX_FORM_MOST][2];
    double *uv, *val, *coef, center[3] = {0};
    ix_form_data d = {.n = c->argv[0]->u.list.n};
    ix_fit_error err;
    ix_obj *list;
    ix_status st;

    IX_TRY(ix__arg_int(c, 2, IX_FORM_LINEAR, IX_FORM_BICUBIC, &kind));
    if (c->argv[1]->u.list.n != d.n)
        return IX_ARG_FAIL(c, 1, "%d points, %d parameters",
                           c->argv[1]->u.list.n, d.n);
    IX_TRY(places(c, 0, 2, &two, &uv));
    IX_TRY(places(c, 1, 0, &d.ncoords, &val));
    d.kind = (ix_form_kind)kind;
    d.centred = ix__arg_bool(c, 3);
    d.uv = uv;
    d.values = val;
    terms = ix_form_terms(d.kind, power);
    IX_SCRATCH(c->ctx, coef, (size_t)terms * (size_t)d.ncoords);
    c->bad_arg = 1;
    IX_TRY(ix_fit_form(c->ctx, &d, center, &err, coef));
    c->bad_arg = 0;
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int k = 0; st == IX_OK && k < terms; k++)
        st = ix__list_add(c->ctx, list,
                          coefficient(c, d.ncoords, terms, coef, k));
    if (st == IX_OK)
        st = add_errors(c, list, &err);
    if (st == IX_OK)
        st = add_center(c, list, center);
    return ix__ret_list(c, list, st);
}

const ix_builtin ix__builtins_fit[] = {
    {"RULEDFIT", "s:surface dir:num extend:num samples:num -> surface",
     "One ruled surface near s and as long, its rulings along dir (PRISA makes "
     "several). Rulings first join the best of `samples` places on each side, "
     "then the sides move to the least squares of distances. With extend, 0 .. "
     "1, s is first continued by that part of its domain at both ends across "
     "the rulings, so that they may lean there too. Attributes Error (root "
     "mean square) and MaxError are distances of points of s from the result.",
     "s = sbezier(list(list(point(0,0,0), point(0,1,1), point(0,2,0)), "
     "list(point(2,0,1), point(2,1,0.5), point(2,2,1)), list(point(4,0,0), "
     "point(4,1,2), point(4,2,0.4)))); r = ruledfit(s, ROW, 0, 20);",
     ruledfit, 0, 11},
    {"SINTERP",
     "data:surface|list uOrder:num vOrder:num uSize:num vSize:num param:num -> "
     "any",
     "Surface through a grid of points (inner lists along u), or nearest to it "
     "with fewer control points; to scattered points (u, v, values); to a "
     "surface, then list(surface, error).",
     "s = sinterp(list(list(point(0,0,0), point(1,0,0), point(2,0,0)), "
     "list(point(0,1,0), point(1,1,1), point(2,1,0)), list(point(0,2,0), "
     "point(1,2,0), point(2,2,0))), 3, 3, 0, 0, PARAM_UNIFORM);",
     sinterp, 0, 11},
    {"TINTERP",
     "t:trivar|list ul:num vl:num wl:num uo:num vo:num wo:num -> trivar",
     "Trivariate of the given lengths and orders through data, or nearest to "
     "them. Of a trivariate: its control points as data at its nodes, lengths "
     "and orders 0 as t has them (then it interpolates, on t's knots). Of a "
     "list: control points (u, v, w, values), parameters in [0, 1], on uniform "
     "knots; or a grid of points (lists three deep, the inner ones along u) at "
     "even parameters, lengths 0 as many as data.",
     "t = tbezier(list(list(list(ctlpt(E1,0), ctlpt(E1,1)), list(ctlpt(E1,2), "
     "ctlpt(E1,5))), list(list(ctlpt(E1,3), ctlpt(E1,4)), list(ctlpt(E1,0), "
     "ctlpt(E1,1))))); x = tinterp(t, 0, 0, 0, 0, 0, 0);",
     tinterp, 0, 15},
    {"ANALYFIT", "uv:list pts:list fit:num center:bool -> list",
     "The polynomial in (u, v) nearest to points pts with parameters uv in the "
     "sense of least squares. fit 1: terms 1 u v; 2: also uv; 3: 1 u v uu uv "
     "vv; 4: u^i v^j for i, j up to 2; 5: up to i + j = 3; 6: i, j up to 3; "
     "ordered by total degree, then falling powers of u. The list has a "
     "coefficient for each term, of the points' coordinates; with center in "
     "powers of the parameters less their mean. Attributes Error (root mean "
     "square), MaxError, Center.",
     "l = analyfit(list(point(0,0,0), point(1,0,0), point(0,1,0), "
     "point(1,1,0)), list(point(0,0,0), point(1,0,0), point(0,1,0), "
     "point(1,1,1)), 2, false);",
     analyfit, 0, 24},
    {0}};
