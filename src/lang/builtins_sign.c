/* builtins_sign.c - where functions of three parameters change their sign:
 * folds of trivariates, inflections by one control point (chapters 15 and 19 of
 * spec/functions). */
#include <math.h>
#include <string.h>

#include "iritx/geom_srf.h"
#include "iritx/ops_crv.h"
#include "lang/args_freeform.h"
#include "lang/interp.h"
#include "lang/ret_solutions.h"
#include "mv/mv.h"

/* Lines or polygons, released; no value if there is none. */
static ix_status ret_lines(ix_call *c, ix_lines *l, ix_poly_kind kind)
{
    ix_status st = l->n > 0 ? ix__ret_lines(c, l, kind) : IX_OK;

    ix_lines_free(c->ctx, l);
    return st;
}

/* --- folds
 * --------------------------------------------------------------------- */

/* Argument 3: a number for all directions, or a list of three; >= 0. */
static ix_status arg_fineness(ix_call *c, double f[3])
{
    if (c->argv[3]->type == IX_OBJ_LIST) {
        double *v;
        int n;

        IX_TRY(ix__arg_nums(c, 3, &n, &v));
        if (n != 3)
            return IX_ARG_FAIL(c, 3, "%d numbers, 3 are wanted", n);
        memcpy(f, v, 3 * sizeof *f);
    } else {
        f[0] = f[1] = f[2] = ix__arg_num(c, 3);
    }
    for (int d = 0; d < 3; d++)
        if (!(f[d] >= 0 && f[d] <= 1e6))
            return IX_ARG_FAIL(c, 3, "a fineness of %g, 0 or more is wanted",
                               f[d]);
    return IX_OK;
}

static ix_status tvzrjacob(ix_call *c)
{
    const ix_mv *t = ix__arg_mv(c, 0);
    int skip, cells[3];
    double f[3];
    ix_lines l;

    IX_TRY(ix__arg_int(c, 2, 1, 10000, &skip));
    IX_TRY(arg_fineness(c, f));
    for (int d = 0; d < 3; d++)
        cells[d] = (int)ceil(2 * ix_mv_order(t, d) * (1 + f[d]) / skip);
    IX_TRY(ix_tv_fold(c->ctx, t, cells, ix__arg_bool(c, 1), &l));
    return ret_lines(c, &l, IX_POLYGON);
}

/* --- one control point
 * --------------------------------------------------------- */

typedef struct {
    const ix_mv *crv;
    int idx;
    double range[2];
} one_point;

static ix_status ret_field(ix_call *c, const one_point *p)
{
    ix_mv *f;

    IX_TRY(ix_crv_one_point(c->ctx, p->crv, p->idx, p->range, &f));
    return ix__ret(c, ix__obj_mv(c->ctx, IX_OBJ_MULTIVAR, f));
}

static ix_status ret_surface(ix_call *c, const one_point *p)
{
    int cells = (int)fmax(ix__var_num(c->in, "RESOLUTION", 20), 2);
    ix_lines l;

    IX_TRY(
        ix_crv_one_point_surface(c->ctx, p->crv, p->idx, p->range, cells, &l));
    return ret_lines(c, &l, IX_POLYGON);
}

/* (t, x, y) as lines. */
static ix_status as_lines(ix_call *c, const ix_solution_curves *s, ix_poly *p)
{
    for (int i = 0; i < s->ncurves; i++) {
        const ix_solution_curve *k = &s->curve[i];

        p->poly[i].kind = IX_POLYLINE;
        IX_TRY(ix__poly_vertices(c->ctx, &p->poly[i], k->n));
        for (int v = 0; v < k->n; v++)
            memcpy(p->poly[i].v[v].p, k->x + 3 * (size_t)v,
                   sizeof p->poly[i].v[v].p);
    }
    return IX_OK;
}

static ix_status ret_births(ix_call *c, const one_point *p)
{
    ix_solution_curves s;
    ix_status st = IX_OK;
    ix_poly *poly = NULL;

    IX_TRY(ix_crv_one_point_births(c->ctx, p->crv, p->idx, p->range,
                                   ix__contour_tolerance(c), &s));
    ix__remark_open(c, s.complete, s.boxes);
    if (s.ncurves > 0) {
        poly = ix__poly_new(c->ctx, s.ncurves);
        st = poly ? as_lines(c, &s, poly) : IX_ENOMEM;
    }
    ix_solution_curves_free(c->ctx, &s);
    if (st == IX_OK && poly)
        return ix__ret(c, ix__obj_poly(c->ctx, poly));
    if (poly)
        ix__poly_unref(c->ctx, poly);
    return st;
}

static ix_status ret_regions(ix_call *c, const one_point *p)
{
    bool complete;
    ix_lines l;

    IX_TRY(ix_crv_one_point_regions(c->ctx, p->crv, p->idx, p->range,
                                    ix__contour_tolerance(c), &complete, &l));
    if (!complete)
        ix__remark(c->in, "a search was stopped: lines may be missing");
    return ret_lines(c, &l, IX_POLYLINE);
}

static ix_status ccrvtr1pt(ix_call *c)
{
    static ix_status (*const what[4])(ix_call *, const one_point *) = {
        ret_field, ret_surface, ret_births, ret_regions};
    one_point p = {.crv = ix__arg_mv(c, 0)};
    int op;

    IX_TRY(ix__arg_int(c, 1, 0, ix_mv_length(p.crv, 0) - 1, &p.idx));
    for (int e = 0; e < 2; e++)
        p.range[e] = ix__arg_num(c, 2 + e);
    if (!(p.range[0] < p.range[1]))
        return IX_ARG_FAIL(c, 3, "a range from %g to %g", p.range[0],
                           p.range[1]);
    IX_TRY(ix__arg_int(c, 6, 1, 4, &op));
    return what[op - 1](c, &p);
}

/* --- table ------------------------------------------------------------- */

#define FOLD                                                                  \
    "s = ctlpt(E3,0,0,0) + ctlpt(E3,1,0,0); p = ruledsrf(s, s * ty(1)); t = " \
    "tfromsrfs(list(p, p * tz(1), p), 3, KV_OPEN); "

const ix_builtin ix__builtins_sign[] = {
    {"TVZRJACOB", "t:trivar euclid:bool skip:num fineness:num|list -> poly",
     "Where a trivariate folds: the surface on which its Jacobian determinant "
     "changes its sign, as triangles in its parameters, or (euclid) in space. "
     "The determinant is sampled in 2 order (1 + fineness) / skip boxes to "
     "each "
     "span; fineness is one number or one for each direction. No value if "
     "there "
     "is no fold.",
     FOLD "o = tvzrjacob(t, true, 1, 0);", tvzrjacob, 0, 15},
    {"CCRVTR1PT",
     "c:curve idx:num min:num max:num subdiv:num numer:num op:num -> any",
     "The sign of the curvature by the place (x, y) of control point idx (from "
     "0) in [min, max]^2: op 1 the scalar multivariate F(t, x, y); 2 F = 0 as "
     "triangles, RESOLUTION boxes to each span and side; 3 the curves (t, x, "
     "y) "
     "where two inflections appear, F = dF/dt = 0; 4 the lines (x, y, 0) "
     "between regions with the same number of inflections: those curves, and "
     "where F is 0 at an end or at a knot where F or dF/dt jumps. The other "
     "numbers are not needed.",
     "c = cbezier(list(ctlpt(E2,0,0), ctlpt(E2,0,1), ctlpt(E2,1,1), "
     "ctlpt(E2,1,0))); m = ccrvtr1pt(c, 1, -1, 3, 0.1, 1e-6, 1);",
     ccrvtr1pt, 0, 19},
    {0}};
