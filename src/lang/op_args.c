/* op_args.c - options, operands and poles of the geometric operators. */
#include "lang/op_args.h"

#include <limits.h>
#include <string.h>

#include "iritx/solve.h"
#include "lang/interp.h"
#include "lang/types_impl.h"

ix_op_opts ix__op_opts(const ix_call *c)
{
    const ix_states *s = ix__states(c->in);

    return (ix_op_opts){.form = (ix_degree_form)s->degree_form,
                        .max_cont = s->bsp_prod_method == 0 ? 0 : INT_MAX};
}

/* --- operands --------------------------------------------------------------
 */

static ix_status point_of(ix_call *c, int i, const ix_obj *o, double p[3])
{
    const ix_ctlpt *q = o->u.ctlpt;

    if (o->type != IX_OBJ_CTLPT) {
        memcpy(p, o->u.pt, 3 * sizeof *p);
        return IX_OK;
    }
    if (q->rational && q->v[0] == 0)
        return IX_ARG_FAIL(c, i,
                           "the control point has weight 0: it is no "
                           "point");
    for (int k = 0; k < 3; k++)
        p[k] = k < q->ncoords
                   ? q->v[k + q->rational] / (q->rational ? q->v[0] : 1)
                   : 0;
    return IX_OK;
}

static bool is_point(const ix_obj *o)
{
    return o->type == IX_OBJ_POINT || o->type == IX_OBJ_VECTOR ||
           o->type == IX_OBJ_CTLPT;
}

ix_status ix__arg_operands(ix_call *c, int i, ix_obj_type type, int n,
                           const char *what, ix_operand *out)
{
    const ix_list *l = &c->argv[i]->u.list;
    int k = 0, points = 0;
    char buf[64];

    if (l->n != n)
        return IX_ARG_FAIL(c, i, "%s is needed, got %d elements", what, l->n);
    for (int j = 0; j < n; j++) {
        const ix_obj *o = l->item[j];

        if (is_point(o) && points++ == 0) {
            out[n - 1] = (ix_operand){.mv = NULL};
            IX_TRY(point_of(c, i, o, out[n - 1].pt));
        } else if (o->type == type) {
            out[k++] = (ix_operand){.mv = ix__obj_first_mv(o)};
        } else {
            return IX_ARG_FAIL(
                c, i, "%s is needed, element %d is %s", what, j + 1,
                is_point(o) ? "another point"
                            : ix__types_text(1u << o->type, buf, sizeof buf));
        }
    }
    return IX_OK;
}

/* --- poles ------------------------------------------------------------------
 */

/* The zeros of a weight as a list; NULL if memory is short. */
static ix_obj *list_of_poles(ix_ctx *ctx, const ix_root *r, int n)
{
    ix_obj *list = ix__obj_list(ctx);

    for (int i = 0; list && i < n; i++)
        if (r[i].kind != IX_ROOT_JUMP &&
            ix__list_add_num(ctx, list, r[i].t) != IX_OK) {
            ix__obj_unref(ctx, list);
            return NULL;
        }
    return list;
}

/* The list (lo, hi) at the end of a list; nothing if it is empty. */
static ix_status add_range(ix_ctx *ctx, ix_obj *list, double lo, double hi)
{
    ix_obj *pair;
    ix_status st;

    if (!(lo < hi))
        return IX_OK;
    pair = ix__obj_list(ctx);
    st = pair ? ix__list_add_num(ctx, pair, lo) : IX_ENOMEM;
    if (st == IX_OK)
        st = ix__list_add_num(ctx, pair, hi);
    if (st == IX_OK)
        return ix__list_add(ctx, list, pair);
    ix__obj_unref(ctx, pair);
    return st;
}

/* The ranges between poles, which are sorted; NULL if memory is short. */
static ix_obj *list_of_finite(ix_ctx *ctx, const double dom[2],
                              const ix_root *r, int n)
{
    ix_obj *list = ix__obj_list(ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;
    double from = dom[0];

    for (int i = 0; st == IX_OK && i < n; i++) {
        bool wide = r[i].kind == IX_ROOT_INTERVAL;

        if (r[i].kind == IX_ROOT_JUMP)
            continue;
        st = add_range(ctx, list, from, wide ? r[i].lo : r[i].t);
        from = wide ? r[i].hi : r[i].t;
    }
    if (st == IX_OK)
        st = add_range(ctx, list, from, dom[1]);
    if (st == IX_OK)
        return list;
    ix__obj_unref(ctx, list);
    return NULL;
}

static ix_status poles_of_curve(ix_call *c, ix_obj *result, const ix_mv *m)
{
    /* what composition and products leave in the weights */
    static const ix_root_opts rounded = {.lo = 1, .hi = 0, .error = 1e-14};
    ix_obj *poles, *finite;
    double dom[2];
    ix_root *r;
    ix_status st = IX_OK;
    int n;

    IX_TRY(ix_roots(c->ctx, m, 0, &rounded, &r, &n));
    ix_mv_domain(m, 0, dom);
    poles = list_of_poles(c->ctx, r, n);
    finite = list_of_finite(c->ctx, dom, r, n);
    if (!poles || !finite)
        st = IX_ENOMEM;
    if (st == IX_OK && poles->u.list.n > 0) {
        st = ix__attr_set_obj(c->ctx, &result->attrs, "Poles", poles);
        if (st == IX_OK)
            st = ix__attr_set_obj(c->ctx, &result->attrs, "Finite", finite);
    }
    ix__obj_unref(c->ctx, poles);
    ix__obj_unref(c->ctx, finite);
    ix_roots_free(c->ctx, r, n);
    return st;
}

ix_status ix__tell_poles(ix_call *c, ix_obj *result, const ix_mv *m)
{
    double dom[2];
    ix_status st;
    ix_mv *iso;

    if (!ix_mv_has_poles(m))
        return IX_OK;
    if (ix_mv_ndirs(m) == 1)
        return poles_of_curve(c, result, m);
    ix_mv_domain(m, 1, dom);
    IX_TRY(ix_mv_fix(c->ctx, m, 1, dom[0], &iso));
    st = poles_of_curve(c, result, iso);
    ix_mv_unref(c->ctx, iso);
    return st;
}
