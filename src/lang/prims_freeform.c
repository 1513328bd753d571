/* prims_freeform.c - primitives that several tables of freeforms share. Each
 * fetches, calls the library and returns an object of its argument's type. */
#include "lang/prims_freeform.h"

#include <string.h>

#include "iritx/geom_srf.h"
#include "iritx/sym.h"
#include "lang/args_freeform.h"
#include "lang/curve_args.h"
#include "lang/prims_surface.h"

/* The freeform and a direction of it, from arguments 0 and i. */
static ix_status fetch_dir(ix_call *c, int i, const ix_mv **m, int *dir)
{
    *m = ix__arg_mv(c, 0);
    return ix__arg_dir(c, i, (*m)->ndirs, dir);
}

typedef ix_status (*interval_fn)(ix_ctx *, const ix_mv *, int, double, double,
                                 ix_mv **);

static ix_status with_interval(ix_call *c, interval_fn fn)
{
    const ix_mv *m;
    ix_mv *out;
    int dir;

    IX_TRY(fetch_dir(c, 1, &m, &dir));
    IX_TRY(fn(c->ctx, m, dir, ix__arg_num(c, 2), ix__arg_num(c, 3), &out));
    return ix__ret_mv(c, 0, out);
}

ix_status ix__prim_region(ix_call *c)
{
    if (c->argv[0]->type == IX_OBJ_TRIMSRF)
        return ix__prim_trim_region(c);
    return with_interval(c, ix_mv_region);
}

ix_status ix__prim_reparam(ix_call *c)
{
    return with_interval(c, ix_mv_reparam);
}

ix_status ix__prim_refine(ix_call *c)
{
    const ix_mv *m;
    ix_mv *out;
    double *knots;
    int dir, n;

    IX_TRY(fetch_dir(c, 1, &m, &dir));
    IX_TRY(ix__arg_nums(c, 3, &n, &knots));
    c->bad_arg = 4;
    if (ix__arg_bool(c, 2))
        IX_TRY(ix_mv_set_knots(c->ctx, m, dir, n, knots, &out));
    else
        IX_TRY(ix_mv_insert_knots(c->ctx, m, dir, n, knots, &out));
    c->bad_arg = 0;
    return ix__ret_mv(c, 0, out);
}

ix_status ix__prim_raise(ix_call *c)
{
    const ix_mv *m;
    ix_mv *out;
    int dir, order;

    IX_TRY(fetch_dir(c, 1, &m, &dir));
    IX_TRY(ix__arg_int(c, 2, 1, IX_MAX_ORDER, &order));
    if (order <= m->dirs[dir].order)
        return IX_ARG_FAIL(c, 2, "order %d is not above the present %d", order,
                           m->dirs[dir].order);
    IX_TRY(ix_mv_raise(c->ctx, m, dir, order, &out));
    return ix__ret_mv(c, 0, out);
}

ix_status ix__prim_divide(ix_call *c)
{
    const ix_mv *m;
    ix_mv *out[2];
    int dir;

    if (c->argv[0]->type == IX_OBJ_TRIMSRF)
        return ix__prim_trim_divide(c);
    IX_TRY(fetch_dir(c, 1, &m, &dir));
    IX_TRY(ix_mv_split(c->ctx, m, dir, ix__arg_num(c, 2), out));
    return ix__ret_pair(c, 0, out);
}

ix_status ix__prim_derive(ix_call *c)
{
    const ix_mv *m;
    ix_mv *out;
    int dir;

    IX_TRY(fetch_dir(c, 1, &m, &dir));
    if (c->argv[0]->type == IX_OBJ_MULTIVAR)
        IX_TRY(ix_sym_derive_axes(c->ctx, m, dir, &out));
    else
        IX_TRY(ix_sym_derive(c->ctx, m, dir, NULL, &out));
    return ix__ret_mv(c, 0, out);
}

ix_status ix__prim_integrate(ix_call *c)
{
    const ix_mv *m;
    ix_mv *out;
    int dir;

    IX_TRY(fetch_dir(c, 1, &m, &dir));
    IX_TRY(ix_sym_integrate(c->ctx, m, dir, &out));
    return ix__ret_mv(c, 0, out);
}

/* One direction less: a surface becomes a curve, a multivariate stays one.
 * Straight curves are marked as such. */
static ix_status return_slice(ix_call *c, ix_mv *m)
{
    if (c->argv[0]->type == IX_OBJ_MULTIVAR)
        return ix__ret_mv(c, 0, m);
    if (m->ndirs == 1 && m->npts == 2 && m->dirs[0].order == 2)
        return ix__ret_geom(c, -1, m, IX__GEOM_LINEAR);
    return ix__ret_mv(c, -1, m);
}

ix_status ix__prim_fix(ix_call *c)
{
    const ix_mv *m;
    ix_mv *out;
    int dir;

    IX_TRY(fetch_dir(c, 1, &m, &dir));
    IX_TRY(ix_mv_fix(c->ctx, m, dir, ix__arg_num(c, 2), &out));
    return return_slice(c, out);
}

ix_status ix__prim_layer(ix_call *c)
{
    const ix_mv *m;
    int dir, index;
    ix_mv *out;

    IX_TRY(fetch_dir(c, 1, &m, &dir));
    IX_TRY(ix__arg_int(c, 2, 0, m->dirs[dir].length - 1, &index));
    IX_TRY(ix_mv_layer(c->ctx, m, dir, index, &out));
    return return_slice(c, out);
}

ix_status ix__prim_morph(ix_call *c)
{
    ix_mv *out;

    IX_TRY(ix_mv_morph(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1),
                       ix__arg_num(c, 2), &out));
    return ix__ret_mv(c, 0, out);
}

ix_status ix__prim_moebius(ix_call *c)
{
    const ix_mv *m;
    ix_mv *out;
    int dir;

    IX_TRY(fetch_dir(c, 2, &m, &dir));
    IX_TRY(ix_mv_moebius(c->ctx, m, dir, ix__arg_num(c, 1), &out));
    return ix__ret_mv(c, 0, out);
}

ix_status ix__prim_edit(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    const ix_ctlpt *p = c->argv[1]->u.ctlpt;
    size_t at = 0;
    ix_mv *out;

    if (p->ncoords != m->ncoords || p->rational != m->rational)
        return IX_ARG_FAIL(c, 1, "the point is %c%d, the freeform %c%d",
                           p->rational ? 'P' : 'E', p->ncoords,
                           m->rational ? 'P' : 'E', m->ncoords);
    for (int d = 0; d < m->ndirs; d++) {
        int k;

        IX_TRY(ix__arg_int(c, 2 + d, 0, m->dirs[d].length - 1, &k));
        at += (size_t)k * ix__mv_stride(m, d);
    }
    IX_TRY(ix_mv_set_point(c->ctx, m, at, p->v, &out));
    return ix__ret_mv(c, 0, out);
}

/* Multivariates do not extrapolate, unlike curves and surfaces (spec/model
 * 6): the parameters must be inside up to 1e-5 of the domain's length. */
static ix_status check_inside(ix_call *c, const ix_mv *m, const double *t)
{
    for (int d = 0; d < m->ndirs; d++) {
        double dom[2], slack;

        ix_mv_domain(m, d, dom);
        slack = 1e-5 * (dom[1] - dom[0]);
        if (!(t[d] >= dom[0] - slack && t[d] <= dom[1] + slack))
            return IX_ARG_FAIL(c, 1,
                               "parameter %g of direction %d is outside the "
                               "domain [%g, %g]",
                               t[d], d, dom[0], dom[1]);
    }
    return IX_OK;
}

ix_status ix__prim_eval(ix_call *c)
{
    const ix_obj *o = c->argv[0];
    const ix_mv *m = o->type == IX_OBJ_TRIMSRF ? o->u.trim.item[0]->srf
                                               : ix__arg_mv(c, 0);
    double v[IX_MAX_COORDS + 1], t[IX_MAX_DIRS], *list = t;
    int n = c->argc - 1;

    if (c->argc == 2 && c->argv[1]->type == IX_OBJ_LIST)
        IX_TRY(ix__arg_nums(c, 1, &n, &list));
    else
        for (int d = 0; d < n; d++)
            t[d] = ix__arg_num(c, d + 1);
    if (n != m->ndirs)
        return IX_ARG_FAIL(c, 1, "%d parameters for %d directions", n,
                           m->ndirs);
    if (o->type == IX_OBJ_MULTIVAR)
        IX_TRY(check_inside(c, m, list));
    IX_TRY(ix_mv_eval(c->ctx, m, list, v));
    return ix__ret_ctlpt(c, m->ncoords, m->rational, v);
}

ix_status ix__prim_layers(ix_call *c)
{
    const ix_mv **layers;
    ix_kv_kind kv;
    int n, order;
    ix_mv *out;

    IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_UNDEF, &n, &layers));
    IX_TRY(ix__arg_int(c, 1, 2, IX_MAX_ORDER, &order));
    IX_TRY(ix__arg_kv(c, 2, &kv));
    IX_TRY(ix_srf_layers(c->ctx, n, layers, order, kv, &out));
    return ix__ret_mv(c, -1, out);
}

ix_status ix__prim_skin(ix_call *c)
{
    const ix_mv **layers;
    ix_kv_kind kv;
    ix_param how;
    int n, order;
    ix_mv *out;

    IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_UNDEF, &n, &layers));
    IX_TRY(ix__arg_int(c, 1, 2, IX_MAX_ORDER, &order));
    IX_TRY(ix__arg_kv(c, 2, &kv));
    IX_TRY(ix__arg_param(c, 3, &how));
    IX_TRY(ix_srf_skin(c->ctx, n, layers, order, kv, how, &out));
    return ix__ret_mv(c, -1, out);
}
