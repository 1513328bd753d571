/* args_freeform.c - arguments and results that freeform primitives share.
 * Everything here only takes lists apart and puts objects together. */
#include "lang/args_freeform.h"
#include "lang/types_impl.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "iritx/sym.h"

/* --- knots ------------------------------------------------------------- */

static bool kv_of(double code, ix_kv_kind *out)
{
    static const struct {
        int code;
        ix_kv_kind kind;
    } kinds[] = {{IX__KV_OPEN, IX_KV_OPEN},
                 {IX__KV_FLOAT, IX_KV_FLOAT},
                 {IX__KV_PERIODIC, IX_KV_PERIODIC},
                 {IX__KV_DISC_OPEN, IX_KV_DISC_OPEN}};

    for (int k = 0; k < 4; k++)
        if (code == kinds[k].code) {
            *out = kinds[k].kind;
            return true;
        }
    return false;
}

ix_status ix__arg_kv(ix_call *c, int i, ix_kv_kind *out)
{
    if (kv_of(ix__arg_num(c, i), out))
        return IX_OK;
    return IX_ARG_FAIL(c, i,
                       "%g is none of KV_OPEN, KV_FLOAT, KV_PERIODIC, "
                       "KV_DISC_OPEN",
                       ix__arg_num(c, i));
}

static ix_status explicit_knots(ix_call *c, int i, const ix_obj *list,
                                double *knots)
{
    for (int k = 0; k < list->u.list.n; k++) {
        const ix_obj *o = list->u.list.item[k];

        if (o->type != IX_OBJ_NUMBER || !isfinite(o->u.num))
            return IX_ARG_FAIL(c, i, "knot %d is not a finite number", k + 1);
        knots[k] = o->u.num;
        if (k == 0 || knots[k] >= knots[k - 1])
            continue;
        if (knots[k - 1] - knots[k] > 1e-4)
            return IX_ARG_FAIL(c, i,
                               "knots decrease: knot %d is %.15g after "
                               "%.15g",
                               k + 1, knots[k], knots[k - 1]);
        knots[k] = knots[k - 1];
    }
    return IX_OK;
}

static ix_status standard_knots(ix_call *c, int i, ix_kv_kind kind, ix_dir *dir)
{
    double *knots;

    dir->periodic = kind == IX_KV_PERIODIC;
    IX_SCRATCH(c->ctx, knots, ix_knots_count(dir));
    c->bad_arg = i + 1;
    IX_TRY(ix_knots_make(c->ctx, kind, dir->order, dir->length, knots));
    c->bad_arg = 0;
    dir->knots = knots;
    return IX_OK;
}

ix_status ix__arg_knots(ix_call *c, int i, const ix_obj *list, int order,
                        int length, ix_dir *out)
{
    int n = list->type == IX_OBJ_LIST ? list->u.list.n : -1;
    double *knots;
    ix_kv_kind kind;

    *out = (ix_dir){.basis = IX_BSPLINE, .order = order, .length = length};
    if (n < 1)
        return IX_ARG_FAIL(c, i, "a list of knots or list(KV_*) is needed");
    if (order < 1 || order > IX_MAX_ORDER || length < order)
        return IX_ARG_FAIL(c, i, "%d points do not make order %d", length,
                           order);
    if (n == 1 && list->u.list.item[0]->type == IX_OBJ_NUMBER &&
        kv_of(list->u.list.item[0]->u.num, &kind))
        return standard_knots(c, i, kind, out);
    if (n != length + order && n != length + 2 * order - 1)
        return IX_ARG_FAIL(c, i,
                           "%d knots for %d points of order %d: %d are needed, "
                           "%d if periodic",
                           n, length, order, length + order,
                           length + 2 * order - 1);
    out->periodic = n != length + order;
    IX_SCRATCH(c->ctx, knots, n);
    IX_TRY(explicit_knots(c, i, list, knots));
    out->knots = knots;
    return IX_OK;
}

/* --- meshes ------------------------------------------------------------ */

/* Checks that all lists at one level are equally long and appends the points
 * of the innermost ones to flat. Recursion is at most three deep. */
static ix_status flatten(ix_call *c, int i, int level, const ix_obj *list,
                         ix_mesh *m, ix_obj *flat)
{
    int n = list->type == IX_OBJ_LIST ? list->u.list.n : 0;

    if (n < 1)
        return IX_ARG_FAIL(c, i,
                           "control points must come in lists nested "
                           "evenly, none of them empty");
    if (m->length[level] == 0)
        m->length[level] = n;
    if (m->length[level] != n)
        return IX_ARG_FAIL(c, i, "a row has %d points where others have %d", n,
                           m->length[level]);
    for (int k = 0; k < n; k++)
        if (level == 0)
            IX_TRY(ix__obj_append(c->ctx, flat, list->u.list.item[k]));
        else
            IX_TRY(flatten(c, i, level - 1, list->u.list.item[k], m, flat));
    return IX_OK;
}

ix_status ix__arg_mesh(ix_call *c, int i, int depth, ix_mesh *out)
{
    ix_obj *flat = ix__obj_list(c->ctx);
    ix_status st;
    int n;

    memset(out, 0, sizeof *out);
    if (!flat)
        return IX_ENOMEM;
    st = flatten(c, i, depth - 1, c->argv[i], out, flat);
    if (st == IX_OK)
        st = ix__arg_points(c, flat, &n, &out->ncoords, &out->rational,
                            &out->pts);
    ix__obj_unref(c->ctx, flat);
    return st;
}

/* --- lists of freeforms ------------------------------------------------ */

ix_status ix__arg_mvs(ix_call *c, int i, ix_obj_type type, int *n,
                      const ix_mv ***out)
{
    const ix_obj *list = c->argv[i];
    size_t total = 0;
    char buf[64];

    for (int k = 0; k < list->u.list.n; k++) {
        const ix_obj *o = list->u.list.item[k];

        if (type == IX_OBJ_UNDEF && ix__obj_first_mv(o))
            type = o->type;
        if (o->type != type || !ix__obj_first_mv(o))
            return ix__wrong_element(
                c, i, k, o,
                type == IX_OBJ_UNDEF
                    ? "a curve, surface, trivariate or "
                      "multivariate"
                    : ix__types_text(1u << type, buf, sizeof buf));
        total += (size_t)o->u.mvs->n;
    }
    if (total > INT_MAX)
        return IX_ARG_FAIL(c, i, "too many freeforms");
    IX_SCRATCH(c->ctx, *out, total);
    *n = 0;
    for (int k = 0; k < list->u.list.n; k++)
        for (int j = 0; j < list->u.list.item[k]->u.mvs->n; j++)
            (*out)[(*n)++] = list->u.list.item[k]->u.mvs->mv[j];
    return IX_OK;
}

ix_status ix__arg_pttype(ix_call *c, int i, int *ncoords, bool *rational)
{
    double v = ix__arg_num(c, i);

    if (!(v >= IX__E1 && v < IX__E1 + 2 * IX_MAX_COORDS && v == floor(v)))
        return IX_ARG_FAIL(c, i, "%g is no point type E1 .. P%d", v,
                           IX_MAX_COORDS);
    *ncoords = ((int)v - IX__E1) / 2 + 1;
    *rational = ((int)v - IX__E1) % 2;
    return IX_OK;
}

ix_status ix__arg_vec3(ix_call *c, int i, double v[3])
{
    const ix_obj *o = c->argv[i];

    if (o->type != IX_OBJ_VECTOR && o->type != IX_OBJ_POINT)
        return IX_ARG_FAIL(c, i, "a vector is needed, not a %s",
                           ix__obj_type_name(o->type));
    memcpy(v, o->u.pt, 3 * sizeof *v);
    return IX_OK;
}

/* --- results ----------------------------------------------------------- */

static ix_status ret_points(ix_call *c, int ndirs, const ix_dir *dirs,
                            const ix_mesh *m)
{
    ix_mv *out;

    IX_TRY(
        ix_mv_new(c->ctx, ndirs, dirs, m->ncoords, m->rational, m->pts, &out));
    return ix__ret_mv(c, -1, out);
}

ix_status ix__ret_mesh(ix_call *c, int ndirs, ix_basis basis)
{
    ix_dir dirs[3];
    ix_mesh m;

    IX_TRY(ix__arg_mesh(c, 0, ndirs, &m));
    for (int d = 0; d < ndirs; d++)
        dirs[d] = (ix_dir){
            .basis = basis, .order = m.length[d], .length = m.length[d]};
    return ret_points(c, ndirs, dirs, &m);
}

ix_status ix__ret_bspline(ix_call *c, int ndirs, const char *what)
{
    int order, kv_arg = ndirs + 1;
    const ix_obj *kvs = c->argv[kv_arg];
    ix_dir dirs[3];
    ix_mesh m;

    if (kvs->u.list.n != ndirs)
        return IX_ARG_FAIL(c, kv_arg, "%d knot vectors, a %s needs %d",
                           kvs->u.list.n, what, ndirs);
    IX_TRY(ix__arg_mesh(c, ndirs, ndirs, &m));
    for (int d = 0; d < ndirs; d++) {
        IX_TRY(ix__arg_int(c, d, 1, IX_MAX_ORDER, &order));
        IX_TRY(ix__arg_knots(c, kv_arg, kvs->u.list.item[d], order, m.length[d],
                             &dirs[d]));
    }
    return ret_points(c, ndirs, dirs, &m);
}

ix_status ix__ret_geom(ix_call *c, int like, const ix_mv *m, int geom_type)
{
    IX_TRY(ix__ret_mv(c, like, m));
    return ix__attr_set_int(c->ctx, &c->result->attrs, "GeomType", geom_type);
}

ix_status ix__ret_list(ix_call *c, ix_obj *list, ix_status st)
{
    if (st == IX_OK)
        return ix__ret(c, list);
    ix__obj_unref(c->ctx, list);
    return st;
}

ix_status ix__ret_pair(ix_call *c, int like, ix_mv *const pieces[2])
{
    ix_obj_type type = c->argv[like]->type;
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = IX_OK;

    for (int k = 0; k < 2; k++) {
        ix_obj *o = ix__obj_mv(c->ctx, type, pieces[k]);
        ix_status added = ix__list_add(c->ctx, list, o);

        st = st == IX_OK ? added : st;
    }
    return ix__ret_list(c, list, st);
}

ix_status ix__ret_nums(ix_call *c, int n, const double *v)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = IX_OK;

    for (int k = 0; k < n && st == IX_OK; k++)
        st = ix__list_add_num(c->ctx, list, v[k]);
    return ix__ret_list(c, list, st);
}

ix_status ix__ret_ctlpt(ix_call *c, int ncoords, bool rational, const double *v)
{
    ix_ctlpt p = {.ncoords = ncoords, .rational = rational};

    memcpy(p.v, v, (size_t)(ncoords + rational) * sizeof *v);
    return ix__ret(c, ix__obj_ctlpt(c->ctx, &p));
}

ix_status ix__ret_vector(ix_call *c, const double v[3])
{
    return ix__ret(c, ix__obj_vector(c->ctx, v));
}

ix_status ix__polyline_curve(ix_call *c, int n, int ncoords, const double *pts,
                             ix_obj **out)
{
    double *kv;
    ix_dir d;
    ix_mv *crv;

    *out = NULL;
    IX_SCRATCH(c->ctx, kv, n + 2);
    for (int i = 0; i < n + 2; i++)
        kv[i] = i < 1 ? 0 : i > n ? n - 1 : i - 1;
    d = (ix_dir){.basis = IX_BSPLINE, .order = 2, .length = n, .knots = kv};
    IX_TRY(ix_mv_new(c->ctx, 1, &d, ncoords, false, pts, &crv));
    *out = ix__obj_mv(c->ctx, IX_OBJ_CURVE, crv);
    return *out ? IX_OK : IX_ENOMEM;
}

ix_status ix__ret_lines(ix_call *c, const ix_lines *l, ix_poly_kind kind)
{
    ix_poly *p = ix__poly_new(c->ctx, l->n);
    ix_status st = p ? IX_OK : IX_ENOMEM;
    size_t at = 0;

    for (int i = 0; st == IX_OK && i < l->n; i++) {
        p->poly[i].kind = kind;
        st = ix__poly_vertices(c->ctx, &p->poly[i], l->count[i]);
        for (int v = 0; st == IX_OK && v < l->count[i]; v++)
            memcpy(p->poly[i].v[v].p, l->pt[at++], sizeof l->pt[0]);
    }
    if (st == IX_OK)
        return ix__ret(c, ix__obj_poly(c->ctx, p));
    if (p)
        ix__poly_unref(c->ctx, p);
    return st;
}

static ix_status trim_curve(ix_ctx *ctx, const ix_trimsrf *t,
                            const ix_trimseg *s, bool param, ix_mv **out)
{
    if (param || s->euclid) {
        *out = ix_mv_ref(param ? s->uv : s->euclid);
        return IX_OK;
    }
    return ix_sym_compose(ctx, t->srf, s->uv, out);
}

ix_status ix__ret_trim_curves(ix_call *c, const ix_trimsrf *t, bool param)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = IX_OK;

    for (int l = 0; l < t->nloops; l++)
        for (int k = 0; k < t->loop[l].n && st == IX_OK; k++) {
            ix_mv *crv = NULL;

            st = trim_curve(c->ctx, t, &t->loop[l].seg[k], param, &crv);
            if (st == IX_OK)
                st = ix__list_add(c->ctx, list,
                                  ix__obj_mv(c->ctx, IX_OBJ_CURVE, crv));
        }
    return ix__ret_list(c, list, st);
}

ix_status ix__arg_vertices(ix_call *c, int arg, int *n, double (**out)[3])
{
    const ix_poly *p = c->argv[arg]->u.poly;
    double(*v)[3];

    *n = 0;
    for (int i = 0; i < p->n; i++)
        *n += p->poly[i].n;
    IX_SCRATCH(c->ctx, v, *n);
    *n = 0;
    for (int i = 0; i < p->n; i++)
        for (int k = 0; k < p->poly[i].n; k++) {
            memcpy(v[*n], p->poly[i].v[k].p, sizeof *v);
            v[(*n)++][2] = 0;
        }
    *out = v;
    return IX_OK;
}
