/* prims_srf_edit.c - surfaces joined, turned over, asked for tangents and
 * normals. Trimmed surfaces keep their trimming curves. */
#include <string.h>

#include "iritx/geom_srf.h"
#include "lang/args_freeform.h"
#include "lang/prims_freeform.h"
#include "lang/prims_surface.h"

static const ix_mv *surface(const ix_call *c)
{
    const ix_obj *o = c->argv[0];

    return o->type == IX_OBJ_TRIMSRF ? o->u.trim.item[0]->srf
                                     : ix__arg_mv(c, 0);
}

/* srf, which is taken over, with the trimming curves of argument 0 mapped. */
static ix_status return_trimmed(ix_call *c, ix_mv *srf, const double mat[16])
{
    ix_trimsrf *t;
    ix_status st;

    if (c->argv[0]->type != IX_OBJ_TRIMSRF)
        return ix__ret_mv(c, 0, srf);
    st = ix__trim_mapped(c->ctx, c->argv[0]->u.trim.item[0], srf, mat, &t);
    ix_mv_unref(c->ctx, srf);
    IX_TRY(st);
    return ix__ret(c, ix__obj_trimsrf(c->ctx, t));
}

ix_status ix__prim_smerge(ix_call *c)
{
    const ix_mv *a = ix__arg_mv(c, 0);
    ix_mv *out;
    int dir;

    IX_TRY(ix__arg_dir(c, 2, a->ndirs, &dir));
    IX_TRY(ix_mv_merge(c->ctx, a, ix__arg_mv(c, 1), dir,
                       ix__arg_bool(c, 3) ? IX_JOIN_SHARED : IX_JOIN_BRIDGE,
                       &out));
    return ix__ret_mv(c, 0, out);
}

ix_status ix__prim_sreverse(ix_call *c)
{
    const double swap[16] = {0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    ix_mv *out;

    IX_TRY(ix_mv_swap_dirs(c->ctx, surface(c), 0, 1, &out));
    return return_trimmed(c, out, swap);
}

ix_status ix__prim_sreparam(ix_call *c)
{
    double mat[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    double t0 = ix__arg_num(c, 2), t1 = ix__arg_num(c, 3), dom[2];
    const ix_mv *s = surface(c);
    ix_mv *out;
    int dir;

    IX_TRY(ix__arg_dir(c, 1, 2, &dir));
    IX_TRY(ix_mv_reparam(c->ctx, s, dir, t0, t1, &out));
    ix_mv_domain(s, dir, dom);
    mat[5 * dir] = (t1 - t0) / (dom[1] - dom[0]);
    mat[12 + dir] = t0 - dom[0] * mat[5 * dir];
    return return_trimmed(c, out, mat);
}

ix_status ix__prim_snormal(ix_call *c)
{
    double n[3];

    IX_TRY(ix_srf_normal(c->ctx, surface(c), ix__arg_num(c, 1),
                         ix__arg_num(c, 2), n));
    return ix__ret_vector(c, n);
}

ix_status ix__prim_snrmlsrf(ix_call *c)
{
    ix_mv *out;

    IX_TRY(ix_srf_normal_field(c->ctx, ix__arg_mv(c, 0), &out));
    return ix__ret_mv(c, 0, out);
}

ix_status ix__prim_stangent(ix_call *c)
{
    double u = ix__arg_num(c, 2), v = ix__arg_num(c, 3), t[3];
    int dir;

    /* COL is the tangent of the curve of constant u. */
    IX_TRY(ix__arg_dir(c, 1, 2, &dir));
    if (ix__arg_bool(c, 4))
        IX_TRY(ix_srf_unit_tangent(c->ctx, surface(c), 1 - dir, u, v, t));
    else
        IX_TRY(ix_srf_tangent(c->ctx, surface(c), 1 - dir, u, v, t));
    return ix__ret_vector(c, t);
}

ix_status ix__prim_nrmlcone(ix_call *c)
{
    double axis[3], angle;
    ix_obj *list;
    ix_status st;

    IX_TRY(ix_srf_normal_cone(c->ctx, ix__arg_mv(c, 0), axis, &angle));
    list = ix__obj_list(c->ctx);
    st = ix__list_add(c->ctx, list, ix__obj_vector(c->ctx, axis));
    if (st == IX_OK)
        st = ix__list_add_num(c->ctx, list, angle);
    return ix__ret_list(c, list, st);
}

/* The integral as a number, or as a scalar surface. */
static ix_status integrate(ix_call *c, const ix_volume *what, bool eval)
{
    double v;
    ix_mv *out;

    if (eval) {
        IX_TRY(ix_srf_volume(c->ctx, ix__arg_mv(c, 0), what, &v));
        return ix__ret_num(c, v);
    }
    IX_TRY(ix_srf_volume_field(c->ctx, ix__arg_mv(c, 0), what, &out));
    return ix__ret_mv(c, -1, out);
}

ix_status ix__prim_svolume(ix_call *c)
{
    int method;

    IX_TRY(ix__arg_int(c, 1, 1, 2, &method));
    return integrate(c, &(ix_volume){.origin = method == 2},
                     ix__arg_bool(c, 2));
}

ix_status ix__prim_smoments(ix_call *c)
{
    ix_volume what = {.origin = false};
    int order, axis;

    IX_TRY(ix__arg_int(c, 1, 1, 2, &order));
    for (int k = 0; k < order; k++) {
        IX_TRY(ix__arg_int(c, 2 + k, 1, 3, &axis));
        what.power[axis - 1]++;
    }
    return integrate(c, &what, ix__arg_bool(c, 4));
}
