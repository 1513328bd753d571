/* operators_negate.c - unary minus: numbers change sign, strings and curves
 * run backwards, surfaces and solids turn their other side out. The result is
 * a new box with the operand's name and attributes. */
#include <math.h>
#include <string.h>

#include "lang/interp_impl.h"
#include "lang/operators_impl.h"

/* --- surfaces: the first parameter runs backwards
 * ------------------------------------ */

static ix_status reverse_mvs(ix_ctx *ctx, const ix_mvs *a, const ix_mvs **out)
{
    ix_mv **rev;
    const ix_mvs *all;
    int n = 0;
    ix_status st = IX_OK;

    IX_SCRATCH(ctx, rev, a->n);
    while (n < a->n && st == IX_OK) {
        st = ix_mv_reverse(ctx, a->mv[n], 0, &rev[n]);
        n += st == IX_OK;
    }
    if (st == IX_OK) {
        all = ix__mvs_new(ctx, n, (const ix_mv *const *)rev);
        st = all ? IX_OK : IX_ENOMEM;
        *out = all ? all : *out;
    }
    while (n > 0)
        ix_mv_unref(ctx, rev[--n]);
    return st;
}

/* A curve in srf's parameter plane (NULL: none) follows: u0 + u1 - u. */
static ix_status mirror_uv(ix_ctx *ctx, const ix_mv *srf, const ix_mv *uv,
                           const ix_mv **out)
{
    double m[16] = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, dom[2];
    ix_mv *r;

    *out = NULL;
    if (!uv)
        return IX_OK;
    ix_mv_domain(srf, 0, dom);
    m[12] = dom[0] + dom[1];
    IX_TRY(ix_mv_transform(ctx, uv, m, &r));
    *out = r;
    return IX_OK;
}

static ix_status mirror_loops(ix_ctx *ctx, const ix_trimsrf *a, ix_trimsrf *t)
{
    for (int i = 0; i < a->nloops; i++) {
        const ix_trimloop *l = &a->loop[i];

        IX_TRY(ix__trimloop_segs(ctx, &t->loop[i], l->n));
        for (int k = 0; k < l->n; k++) {
            ix_trimseg *s = &t->loop[i].seg[k];

            IX_TRY(mirror_uv(ctx, a->srf, l->seg[k].uv, &s->uv));
            if (l->seg[k].euclid)
                s->euclid = ix_mv_ref(l->seg[k].euclid);
        }
    }
    return IX_OK;
}

static ix_status reverse_trimmed(ix_ctx *ctx, const ix_trimsrf *a,
                                 const ix_trimsrf **out)
{
    ix_mv *srf;
    ix_trimsrf *t;
    ix_status st;

    IX_TRY(ix_mv_reverse(ctx, a->srf, 0, &srf));
    t = ix__trimsrf_new(ctx, srf, a->nloops);
    ix_mv_unref(ctx, srf);
    if (!t)
        return IX_ENOMEM;
    st = mirror_loops(ctx, a, t);
    if (st == IX_OK)
        *out = t;
    else
        ix__trimsrf_unref(ctx, t);
    return st;
}

/* --- models
 * ----------------------------------------------------------------------------
 */

static ix_status reverse_face(ix_ctx *ctx, const ix_model_srf *a,
                              ix_model_srf *s)
{
    ix_mv *srf;

    IX_TRY(ix_mv_reverse(ctx, a->srf, 0, &srf));
    s->srf = srf;
    IX_TRY(ix__model_loops(ctx, s, a->nloops));
    for (int i = 0; i < a->nloops; i++) {
        IX_TRY(ix__model_loop_segs(ctx, s, i, a->nseg[i]));
        if (a->nseg[i])
            memcpy(s->seg[i], a->seg[i],
                   (size_t)a->nseg[i] * sizeof *a->seg[i]);
    }
    return IX_OK;
}

static ix_status mirror_edge(ix_ctx *ctx, const ix_model *m,
                             const ix_model_seg *a, ix_model_seg *s)
{
    *s = (ix_model_seg){.mask = a->mask, .s1 = a->s1, .s2 = a->s2};
    if (a->euclid)
        s->euclid = ix_mv_ref(a->euclid);
    if (a->s1 > 0)
        IX_TRY(mirror_uv(ctx, m->srf[a->s1 - 1].srf, a->uv1, &s->uv1));
    if (a->s2 > 0)
        IX_TRY(mirror_uv(ctx, m->srf[a->s2 - 1].srf, a->uv2, &s->uv2));
    return IX_OK;
}

static ix_status reverse_parts(ix_ctx *ctx, const ix_model *a, ix_model *m)
{
    for (int i = 0; i < a->nsrf; i++)
        IX_TRY(reverse_face(ctx, &a->srf[i], &m->srf[i]));
    for (int i = 0; i < a->nseg; i++)
        IX_TRY(mirror_edge(ctx, a, &a->seg[i], &m->seg[i]));
    return IX_OK;
}

static ix_status reverse_model(ix_ctx *ctx, const ix_model *a,
                               const ix_model **out)
{
    ix_model *m = ix__model_new(ctx, a->nsrf, a->nseg);
    ix_status st;

    if (!m)
        return IX_ENOMEM;
    st = reverse_parts(ctx, a, m);
    if (st == IX_OK)
        *out = m;
    else
        ix__model_unref(ctx, m);
    return st;
}

/* --- polys
 * ------------------------------------------------------------------------------
 */

static void reverse_polygon(ix_polygon *pg)
{
    for (int i = 0, j = pg->n - 1; i < j; i++, j--) {
        ix_vertex t = pg->v[i];

        pg->v[i] = pg->v[j];
        pg->v[j] = t;
    }
    if (pg->kind != IX_POLYGON)
        return;
    for (int k = 0; k < 4; k++)
        pg->plane[k] = -pg->plane[k];
    for (int i = 0; i < pg->n; i++)
        for (int k = 0; k < 3; k++)
            pg->v[i].normal[k] = -pg->v[i].normal[k];
}

static ix_status reverse_poly(ix_ctx *ctx, const ix_poly *a,
                              const ix_poly **out)
{
    ix_poly *p = ix__poly_dup(ctx, a);

    if (!p)
        return IX_ENOMEM;
    for (int i = 0; i < p->n; i++)
        reverse_polygon(&p->poly[i]);
    *out = p;
    return IX_OK;
}

/* --- any object
 * ---------------------------------------------------------------------------
 */

/* Each *field is replaced by its reverse. */
static ix_status reverse_geometry(ix_ctx *ctx, ix_obj *o)
{
    switch (o->type) {
    case IX_OBJ_CURVE:
    case IX_OBJ_SURFACE: {
        const ix_mvs *old = o->u.mvs;

        IX_TRY(reverse_mvs(ctx, old, &o->u.mvs));
        ix__mvs_unref(ctx, old);
        return IX_OK;
    }
    case IX_OBJ_POLY: {
        const ix_poly *old = o->u.poly;

        IX_TRY(reverse_poly(ctx, old, &o->u.poly));
        ix__poly_unref(ctx, old);
        return IX_OK;
    }
    case IX_OBJ_TRIMSRF:
        for (int i = 0; i < o->u.trim.n; i++) {
            const ix_trimsrf *old = o->u.trim.item[i];

            IX_TRY(reverse_trimmed(ctx, old, &o->u.trim.item[i]));
            ix__trimsrf_unref(ctx, old);
        }
        return IX_OK;
    case IX_OBJ_MODEL:
        for (int i = 0; i < o->u.model.n; i++) {
            const ix_model *old = o->u.model.item[i];

            IX_TRY(reverse_model(ctx, old, &o->u.model.item[i]));
            ix__model_unref(ctx, old);
        }
        return IX_OK;
    default:
        return IX_FAIL(ctx, IX_EARG, "unary minus of this type");
    }
}

static ix_status negate(ix_interp *in, const ix_obj *a, int depth,
                        ix_obj **out); /* recursion */

/* A list of the negated elements. */
static ix_status negate_list(ix_interp *in, const ix_obj *a, int depth,
                             ix_obj *list)
{
    for (int i = 0; i < a->u.list.n; i++) {
        ix_obj *item;

        IX_TRY(negate(in, a->u.list.item[i], depth + 1, &item));
        IX_TRY(ix__list_add(in->ctx, list, item));
    }
    return IX_OK;
}

static ix_status copy_marks(ix_interp *in, const ix_obj *a, ix_obj *to)
{
    IX_TRY(ix__obj_set_name(in->ctx, to, a->name));
    return ix__attr_copy_all(in->ctx, a->attrs, &to->attrs);
}

static ix_status negate(ix_interp *in, const ix_obj *a, int depth, ix_obj **out)
{
    bool list = a->type == IX_OBJ_LIST;
    ix_obj *o;
    ix_status st = IX_OK;

    *out = NULL;
    if (depth > IX_MAX_DEPTH)
        return IX_FAIL(in->ctx, IX_EARG,
                       "the list is nested deeper than %d levels",
                       IX_MAX_DEPTH);
    if (!ix__op_types(OP_NEG, 1u << a->type, 0))
        return ix__op_mismatch(in, OP_NEG, 1u << a->type, 0);
    o = list ? ix__obj_list(in->ctx) : ix__obj_copy(in->ctx, a);
    if (!o)
        return IX_ENOMEM;
    if (list) {
        st = copy_marks(in, a, o);
        if (st == IX_OK)
            st = negate_list(in, a, depth, o);
    } else if (!ix__op_negate_simple(o)) {
        st = reverse_geometry(in->ctx, o);
    }
    if (st == IX_OK)
        *out = o;
    else
        ix__obj_unref(in->ctx, o);
    return st;
}

ix_status ix__op_negate(ix_interp *in, ix_obj *a, ix_obj **out)
{
    ix_mark mk = ix__scratch_mark(in->ctx);
    ix_status st = negate(in, a, 0, out);

    ix__scratch_release(in->ctx, mk);
    return st;
}
