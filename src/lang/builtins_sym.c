/* builtins_sym.c - exact algebra on freeforms (chapter 18 of spec/functions).
 * Both operands are curves, or surfaces, or multivariates, over one domain. */
#include <string.h>

#include "iritx/geom_srf.h"
#include "iritx/sym.h"
#include "lang/args_freeform.h"
#include "lang/interp.h"

/* BspProdMethod 0 joins products with C0 only, as the reference does when it
 * multiplies Bezier pieces; 1 and 2 keep the continuity. */
static const ix_sym_opts *product_opts(const ix_call *c)
{
    static const ix_sym_opts c0 = {.max_cont = 0};

    return ix__states(c->in)->bsp_prod_method == 0 ? &c0 : NULL;
}

typedef ix_status (*binary_fn)(ix_ctx *, const ix_mv *, const ix_mv *,
                               const ix_sym_opts *, ix_mv **);

/* Both operands are of one kind over one domain up to 1e-5 of its length. */
static ix_status check_pair(ix_call *c)
{
    const ix_mv *a = ix__arg_mv(c, 0), *b = ix__arg_mv(c, 1);

    if (c->argv[0]->type != c->argv[1]->type || a->ndirs != b->ndirs)
        return IX_ARG_FAIL(c, 1,
                           "a %s of %d directions and a %s of %d do not go "
                           "together",
                           ix__obj_type_name(c->argv[0]->type), a->ndirs,
                           ix__obj_type_name(c->argv[1]->type), b->ndirs);
    for (int d = 0; d < a->ndirs; d++) {
        double p[2], q[2], tol;

        ix_mv_domain(a, d, p);
        ix_mv_domain(b, d, q);
        tol = 1e-5 * (p[1] - p[0]);
        if (!(q[0] - p[0] <= tol && p[0] - q[0] <= tol && q[1] - p[1] <= tol &&
              p[1] - q[1] <= tol))
            return IX_ARG_FAIL(c, 1,
                               "domains [%g, %g] and [%g, %g] of direction %d "
                               "are incompatible",
                               p[0], p[1], q[0], q[1], d + 1);
    }
    return IX_OK;
}

static ix_status binary(ix_call *c, binary_fn fn)
{
    ix_mv *out;

    IX_TRY(check_pair(c));
    IX_TRY(
        fn(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1), product_opts(c), &out));
    return ix__ret_mv(c, 0, out);
}

static ix_status symbsum(ix_call *c)
{
    return binary(c, ix_sym_add);
}

static ix_status symbdiff(ix_call *c)
{
    return binary(c, ix_sym_sub);
}

static ix_status symbprod(ix_call *c)
{
    return binary(c, ix_sym_mul);
}

static ix_status symbcprod(ix_call *c)
{
    return binary(c, ix_sym_cross);
}

static bool is_vector(const ix_obj *o)
{
    return o->type == IX_OBJ_VECTOR || o->type == IX_OBJ_POINT;
}

/* The freeform is argument i, the vector the other one. */
static ix_status dot_vector(ix_call *c, int i)
{
    const ix_mv *m = ix__arg_mv(c, i);
    double v[IX_MAX_COORDS] = {0};
    ix_mv *out;

    IX_TRY(ix__arg_vec3(c, 1 - i, v));
    IX_TRY(ix_sym_dot_vector(c->ctx, m, v, &out));
    return ix__ret_mv(c, i, out);
}

static ix_status symbdprod(ix_call *c)
{
    bool first = is_vector(c->argv[0]), second = is_vector(c->argv[1]);

    if (first && second)
        return ix__ret_num(c, c->argv[0]->u.pt[0] * c->argv[1]->u.pt[0] +
                                  c->argv[0]->u.pt[1] * c->argv[1]->u.pt[1] +
                                  c->argv[0]->u.pt[2] * c->argv[1]->u.pt[2]);
    if (first || second)
        return dot_vector(c, first ? 1 : 0);
    return binary(c, ix_sym_dot);
}

/* --- inner products of basis functions --------------------------------- */

/* What the first call keeps for those that follow, among the remembered
 * states of the interpreter: a copy of the curve, and the orders. */
static const char kept_curve[] = "SymbIProdCurve";
static const char *const kept_order[2] = {"SymbIProdOrder1", "SymbIProdOrder2"};

static ix_status prepare_inner(ix_call *c)
{
    ix_attr **kept = &ix__states(c->in)->other;
    const ix_mv *m = ix__obj_first_mv(c->argv[0]);
    ix_obj *copy;
    ix_status st;
    int order[2];

    if (!m || m->ndirs != 1 || m->dirs[0].basis != IX_BSPLINE)
        return IX_ARG_FAIL(c, 0,
                           "a B-spline curve is needed to begin with, "
                           "then 0");
    for (int e = 0; e < 2; e++) {
        IX_TRY(ix__arg_int(c, e + 1, 1, ix_knots_count(&m->dirs[0]) - 1,
                           &order[e]));
        IX_TRY(ix__attr_set_int(c->ctx, kept, kept_order[e], order[e]));
    }
    copy = ix__obj_copy(c->ctx, c->argv[0]);
    if (!copy)
        return IX_ENOMEM;
    st = ix__attr_set_obj(c->ctx, kept, kept_curve, copy);
    ix__obj_unref(c->ctx, copy);
    IX_TRY(st);
    return ix__ret_num(c, 0);
}

static ix_status symbiprod(ix_call *c)
{
    ix_attr *kept = ix__states(c->in)->other;
    const ix_attr *crv = ix__attr_find(kept, kept_curve);
    int index[2], order[2];
    const ix_mv *m;
    double v;

    if (c->argv[0]->type != IX_OBJ_NUMBER)
        return prepare_inner(c);
    if (!crv)
        return IX_ARG_FAIL(c, 0,
                           "nothing is prepared: call "
                           "symbiprod(curve, order1, order2) first");
    m = ix__obj_first_mv(crv->obj);
    for (int e = 0; e < 2; e++) {
        order[e] = (int)ix__attr_find(kept, kept_order[e])->i;
        IX_TRY(ix__arg_int(c, e + 1, 0,
                           ix_knots_count(&m->dirs[0]) - order[e] - 1,
                           &index[e]));
    }
    IX_TRY(ix_bsp_inner(c->ctx, &m->dirs[0], order, index, &v));
    return ix__ret_num(c, v);
}

/* --- table ------------------------------------------------------------- */

#define AB                                              \
    "a = cbezier(list(ctlpt(E2,0,0), ctlpt(E2,1,2))); " \
    "b = cbezier(list(ctlpt(E2,1,1), ctlpt(E2,2,0), ctlpt(E2,0,3))); "

const ix_builtin ix__builtins_sym[] = {
    {"SYMBSUM", "a:curve|surface|mv b:curve|surface|mv -> any",
     "The sum, coordinate by coordinate.", AB "c = symbsum(a, b);", symbsum, 0,
     18},
    {"SYMBDIFF", "a:curve|surface|mv b:curve|surface|mv -> any",
     "The difference a - b, coordinate by coordinate.",
     AB "c = symbdiff(a, b);", symbdiff, 0, 18},
    {"SYMBPROD", "a:curve|surface|mv b:curve|surface|mv -> any",
     "The product, coordinate by coordinate.", AB "c = symbprod(a, b);",
     symbprod, 0, 18},
    {"SYMBDPROD", "a:pv|curve|surface|mv b:pv|curve|surface|mv -> any",
     "The scalar product; either argument may be a vector.",
     AB "c = symbdprod(a, b);", symbdprod, 0, 18},
    {"SYMBCPROD", "a:curve|surface|mv b:curve|surface|mv -> any",
     "The vector product a x b, always with three coordinates.",
     AB "c = symbcprod(a, b);", symbcprod, 0, 18},
    {"SYMBIPROD", "x:any i:num j:num -> num",
     "(curve, order1, order2) prepares inner products of the B-spline basis "
     "functions on the curve's knots; then (0, i, j) gives the integral of "
     "function i of order1 times function j of order2, both from 0.",
     "d = symbiprod(cbspline(3, list(ctlpt(E1,0), ctlpt(E1,1), ctlpt(E1,3), "
     "ctlpt(E1,2)), list(KV_OPEN)), 3, 3); x = symbiprod(0, 0, 1);",
     symbiprod, 0, 18},
    {0}};
