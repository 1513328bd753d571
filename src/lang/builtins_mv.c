/* builtins_mv.c - multivariates (chapter 16 of spec/functions). Directions
 * are numbers from 0; errors are soft, as in the reference. */
#include <limits.h>
#include <string.h>

#include "iritx/geom_srf.h"
#include "lang/args_freeform.h"
#include "lang/poly_expr.h"
#include "lang/prims_freeform.h"

/* --- construction ------------------------------------------------------ */

/* The integers lo .. hi of a list of at most IX_MAX_DIRS. */
static ix_status int_list(ix_call *c, int i, int lo, int hi, int *n, int *out)
{
    double *v;

    IX_TRY(ix__arg_nums(c, i, n, &v));
    if (*n < 1 || *n > IX_MAX_DIRS)
        return IX_ARG_FAIL(c, i, "%d directions, 1 to %d are possible", *n,
                           IX_MAX_DIRS);
    for (int d = 0; d < *n; d++) {
        if (!(v[d] >= lo && v[d] <= hi) || v[d] != (int)v[d])
            return IX_ARG_FAIL(c, i,
                               "element %d is %g, not a whole number "
                               "from %d to %d",
                               d + 1, v[d], lo, hi);
        out[d] = (int)v[d];
    }
    return IX_OK;
}

/* The points of argument i, as many as the directions hold together. */
static ix_status make_mv(ix_call *c, int i, int ndirs, const ix_dir *dirs)
{
    size_t need = 1;
    int n, ncoords;
    bool rational;
    double *pts;
    ix_mv *out;

    for (int d = 0; d < ndirs; d++)
        if ((need *= (size_t)dirs[d].length) > INT_MAX)
            return IX_ARG_FAIL(c, 0, "the mesh is too large");
    IX_TRY(ix__arg_points(c, c->argv[i], &n, &ncoords, &rational, &pts));
    if ((size_t)n != need)
        return IX_ARG_FAIL(c, i, "%d points, the directions need %zu", n, need);
    IX_TRY(ix_mv_new(c->ctx, ndirs, dirs, ncoords, rational, pts, &out));
    return ix__ret(c, ix__obj_mv(c->ctx, IX_OBJ_MULTIVAR, out));
}

static ix_status without_knots(ix_call *c, ix_basis basis)
{
    ix_dir dirs[IX_MAX_DIRS];
    int order[IX_MAX_DIRS], n;

    IX_TRY(int_list(c, 0, 1, IX_MAX_ORDER, &n, order));
    for (int d = 0; d < n; d++)
        dirs[d] = (ix_dir){
            .basis = basis, .order = order[d], .length = order[d]};
    return make_mv(c, 1, n, dirs);
}

static ix_status mbezier(ix_call *c)
{
    return without_knots(c, IX_BEZIER);
}

static ix_status mpower(ix_call *c)
{
    return without_knots(c, IX_POWER);
}

static ix_status mbspline(ix_call *c)
{
    int length[IX_MAX_DIRS], order[IX_MAX_DIRS], n, n2;
    const ix_obj *kvs = c->argv[3];
    ix_dir dirs[IX_MAX_DIRS];

    IX_TRY(int_list(c, 0, 1, INT_MAX / 2, &n, length));
    IX_TRY(int_list(c, 1, 1, IX_MAX_ORDER, &n2, order));
    if (n2 != n || kvs->u.list.n != n)
        return IX_ARG_FAIL(c, n2 != n ? 1 : 3,
                           "%d lengths, %d orders, %d knot vectors", n, n2,
                           kvs->u.list.n);
    for (int d = 0; d < n; d++)
        IX_TRY(ix__arg_knots(c, 3, kvs->u.list.item[d], order[d], length[d],
                             &dirs[d]));
    return make_mv(c, 2, n, dirs);
}

static ix_status mvexplicit(ix_call *c)
{
    ix_mv *out;
    int dim;

    IX_TRY(ix__arg_int(c, 0, 1, IX_MAX_DIRS, &dim));
    c->bad_arg = 2;
    IX_TRY(ix__poly_expr(c->ctx, dim, ix__arg_str(c, 1), &out));
    c->bad_arg = 0;
    return ix__ret(c, ix__obj_mv(c->ctx, IX_OBJ_MULTIVAR, out));
}

/* --- directions -------------------------------------------------------- */

static ix_status mpromote(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    int n, v[IX_MAX_DIRS];
    ix_mv *out;

    IX_TRY(int_list(c, 1, 0, IX_MAX_DIRS, &n, v));
    if (n > 2)
        return IX_ARG_FAIL(c, 1,
                           "list(index) or list(dimension, start) is "
                           "needed, not %d numbers",
                           n);
    if (n == 1) {
        if (v[0] > m->ndirs || m->ndirs == IX_MAX_DIRS)
            return IX_ARG_FAIL(c, 1, "no place %d for a new direction among %d",
                               v[0], m->ndirs);
        IX_TRY(ix_mv_insert_dir(c->ctx, m, v[0], &out));
    } else {
        if (v[0] <= m->ndirs || v[1] + m->ndirs > v[0])
            return IX_ARG_FAIL(c, 1,
                               "%d directions from number %d on do not go into "
                               "%d%s",
                               m->ndirs, v[1], v[0],
                               v[0] == m->ndirs ? ": nothing to promote" : "");
        IX_TRY(ix_mv_promote(c->ctx, m, v[0], v[1], &out));
    }
    return ix__ret_mv(c, 0, out);
}

static ix_status mreverse(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    int d1, d2;
    ix_mv *out;

    IX_TRY(ix__arg_dir(c, 1, m->ndirs, &d1));
    IX_TRY(ix__arg_dir(c, 2, m->ndirs, &d2));
    IX_TRY(ix_mv_swap_dirs(c->ctx, m, d1, d2, &out));
    return ix__ret_mv(c, 0, out);
}

static ix_status mmerge(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    ix_mv *out;
    int dir;

    IX_TRY(ix__arg_dir(c, 2, m->ndirs, &dir));
    IX_TRY(ix_mv_merge(c->ctx, m, ix__arg_mv(c, 1), dir,
                       ix__arg_bool(c, 3) ? IX_JOIN_JUMP : IX_JOIN_SHARED,
                       &out));
    return ix__ret_mv(c, 0, out);
}

/* --- table ------------------------------------------------------------- */

#define M                                                                  \
    "m = mbezier(list(2, 2), list(ctlpt(E1,0), ctlpt(E1,1), ctlpt(E1,1), " \
    "ctlpt(E1,3))); "

const ix_builtin ix__builtins_mv[] = {
    {"MBEZIER", "orders:list pts:list -> mv",
     "Bezier multivariate; points in a flat list, the first direction fastest.",
     M, mbezier, IX_B_SOFT, 16},
    {"MBSPLINE", "lengths:list orders:list pts:list kvs:list -> mv",
     "B-spline multivariate; each knot vector is list(KV_*) or its knots.",
     "m = mbspline(list(3, 2), list(2, 2), list(ctlpt(E1,0), ctlpt(E1,1), "
     "ctlpt(E1,2), ctlpt(E1,3), ctlpt(E1,4), ctlpt(E1,9)), "
     "list(list(KV_OPEN), list(KV_OPEN)));",
     mbspline, IX_B_SOFT, 16},
    {"MPOWER", "orders:list pts:list -> mv",
     "Multivariate in the monomial basis; coefficients in a flat list, powers "
     "of the first direction fastest.",
     "m = mpower(list(2, 2), list(ctlpt(E1,0), ctlpt(E1,1), ctlpt(E1,2), "
     "ctlpt(E1,3)));",
     mpower, IX_B_SOFT, 16},
    {"MVEXPLICIT", "dim:num expr:str -> mv",
     "Polynomial in the letters A (first direction), B, C ... with + - * / ^ "
     "and parentheses, in the monomial basis.",
     "m = coerce(mvexplicit(3, \"A*B + 2*C^2 - 0.3\"), BEZIER_TYPE);",
     mvexplicit, IX_B_SOFT, 16},
    {"MEVAL", "m:mv params:list -> ctlpt", "Value at a list of parameters.",
     M "q = meval(m, list(0.2, 0.3));", ix__prim_eval, IX_B_SOFT, 16},
    {"MDERIVE", "m:mv dir:num -> mv",
     "Derivative in one direction, of every coordinate and of the weight by "
     "itself.",
     M "d = mderive(m, 0);", ix__prim_derive, IX_B_SOFT, 16},
    {"MDIVIDE", "m:mv dir:num t:num -> list",
     "The two parts below and above a parameter.", M "l = mdivide(m, 1, 0.5);",
     ix__prim_divide, IX_B_SOFT, 16},
    {"MREGION", "m:mv dir:num t0:num t1:num -> mv",
     "The part between two parameters.", M "r = mregion(m, 0, 0.1, 0.4);",
     ix__prim_region, IX_B_SOFT, 16},
    {"MREPARAM", "m:mv dir:num t0:num t1:num -> mv",
     "The same shape with the domain of one direction moved to [t0, t1].",
     M "r = mreparam(m, 0, 0, 2);", ix__prim_reparam, IX_B_SOFT, 16},
    {"MREFINE", "m:mv dir:num replace:bool knots:list -> mv",
     "Knots inserted, or with replace the whole knot vector exchanged.",
     M "r = mrefine(m, 0, false, list(0.5));", ix__prim_refine, IX_B_SOFT, 16},
    {"MRAISE", "m:mv dir:num order:num -> mv",
     "The same shape with a higher order in one direction.",
     M "r = mraise(m, 0, 4);", ix__prim_raise, IX_B_SOFT, 16},
    {"MFROMMV", "m:mv dir:num t:num -> mv",
     "One parameter fixed: one direction less.", M "r = mfrommv(m, 0, 0.5);",
     ix__prim_fix, IX_B_SOFT, 16},
    {"MFROMMESH", "m:mv dir:num index:num -> mv",
     "One layer of control points, one direction less.",
     M "r = mfrommesh(m, 0, 1);", ix__prim_layer, IX_B_SOFT, 16},
    {"MMERGE", "m1:mv m2:mv dir:num discont:bool -> mv",
     "The second after the first; a common layer is taken once unless discont.",
     M "r = mmerge(m, m, 0, true);", mmerge, IX_B_SOFT, 16},
    {"MPROMOTE", "m:mv places:list -> mv",
     "list(d): a new constant direction at d. list(dim, start): dim "
     "directions, "
     "the old ones from start on, the others constant.",
     M "r = mpromote(m, list(3, 0));", mpromote, IX_B_SOFT, 16},
    {"MREVERSE", "m:mv dir1:num dir2:num -> mv", "Two directions exchanged.",
     M "r = mreverse(m, 0, 1);", mreverse, IX_B_SOFT, 16},
    {0}};
