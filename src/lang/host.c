/* host.c - the table of functions that plug-ins are given. Most are those that
 * primitives use; the others make an opaque object's parts reachable. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "lang/args_freeform.h"
#include "lang/host.h"
#include "lang/interp.h"
#include "lang/op_args.h"

/* --- the call ------------------------------------------------------------ */

static ix_ctx *ctx_of(const ix_call *c)
{
    return c->ctx;
}

IX_PRINTF(3, 0)
static ix_status fail_with(ix_call *c, ix_status st, const char *fmt,
                           va_list ap)
{
    char text[400];

    (void)vsnprintf(text, sizeof text, fmt, ap);
    ix__fail(c->ctx, st, "plug-in", "", 0, "%s", text);
    return st;
}

IX_PRINTF(3, 4)
static ix_status fail(ix_call *c, ix_status st, const char *fmt, ...)
{
    va_list ap;

    va_start(ap, fmt);
    st = fail_with(c, st, fmt, ap);
    va_end(ap);
    return st;
}

IX_PRINTF(3, 4)
static ix_status arg_fail(ix_call *c, int i, const char *fmt, ...)
{
    va_list ap;

    c->bad_arg = i + 1;
    va_start(ap, fmt);
    (void)fail_with(c, IX_EARG, fmt, ap);
    va_end(ap);
    return IX_EARG;
}

IX_PRINTF(2, 3)
static void remark(ix_call *c, const char *fmt, ...)
{
    char text[400];
    va_list ap;

    va_start(ap, fmt);
    (void)vsnprintf(text, sizeof text, fmt, ap);
    va_end(ap);
    ix__remark(c->in, "%s", text);
}

static void *scratch(ix_call *c, size_t n, size_t size)
{
    return ix__scratch(c->ctx, n, size);
}

static ix_status poll_call(ix_call *c)
{
    return ix__poll(c->ctx);
}

static double var_num(const ix_call *c, const char *name, double dflt)
{
    return ix__var_num(c->in, name, dflt);
}

/* --- arguments, the result ----------------------------------------------- */

static int argc_of(const ix_call *c)
{
    return c->argc;
}

static ix_obj *arg(const ix_call *c, int i)
{
    return c->argv[i];
}

static ix_obj *result(const ix_call *c)
{
    return c->result;
}

/* --- objects ------------------------------------------------------------- */

static ix_obj_type type_of(const ix_obj *o)
{
    return o->type;
}

static int list_size(const ix_obj *o)
{
    return o->type == IX_OBJ_LIST ? o->u.list.n : 0;
}

static ix_obj *list_item(const ix_obj *o, int i)
{
    return o->u.list.item[i];
}

static double num_of(const ix_obj *o)
{
    return o->u.num;
}

static const char *str_of(const ix_obj *o)
{
    return o->u.str.s;
}

static ix_status attr_set_int(ix_ctx *ctx, ix_obj *o, const char *name,
                              long long v)
{
    return ix__attr_set_int(ctx, &o->attrs, name, v);
}

static ix_status attr_set_num(ix_ctx *ctx, ix_obj *o, const char *name,
                              double v)
{
    return ix__attr_set_real(ctx, &o->attrs, name, v);
}

static ix_status attr_set_str(ix_ctx *ctx, ix_obj *o, const char *name,
                              const char *v)
{
    return ix__attr_set_string(ctx, &o->attrs, name, v);
}

static ix_status attr_set_obj(ix_ctx *ctx, ix_obj *o, const char *name,
                              ix_obj *v)
{
    if (ix__obj_contains(v, o))
        return IX_FAIL(ctx, IX_EARG,
                       "attribute %s would hold the object that has it", name);
    return ix__attr_set_obj(ctx, &o->attrs, name, v);
}

static bool attr_num(const ix_obj *o, const char *name, double *v)
{
    const ix_attr *a = ix__attr_find(o->attrs, name);
    const char *end;

    if (!a || a->type == IX_ATTR_OBJ)
        return false;
    if (a->type == IX_ATTR_STRING) {
        end = a->s + strlen(a->s);
        return *a->s && ix_num_parse(a->s, end, v) == end;
    }
    *v = a->type == IX_ATTR_INT ? (double)a->i : a->r;
    return true;
}

/* --- the table ----------------------------------------------------------- */

const ix_host ix__host = {
    .version = IX_PLUGIN_VERSION,
    .size = sizeof(ix_host),
    .add = ix__registry_add,
    .ctx = ctx_of,
    .fail = fail,
    .arg_fail = arg_fail,
    .remark = remark,
    .scratch = scratch,
    .poll = poll_call,
    .op_opts = ix__op_opts,
    .contour_tol = ix__contour_tolerance,
    .var_num = var_num,
    .argc = argc_of,
    .arg = arg,
    .arg_num = ix__arg_num,
    .arg_bool = ix__arg_bool,
    .arg_int = ix__arg_int,
    .arg_str = ix__arg_str,
    .arg_pt3 = ix__arg_pt3,
    .arg_mv = ix__arg_mv,
    .arg_dir = ix__arg_dir,
    .arg_pttype = ix__arg_pttype,
    .arg_mvs = ix__arg_mvs,
    .arg_nums = ix__arg_nums,
    .ret = ix__ret,
    .ret_num = ix__ret_num,
    .ret_mv = ix__ret_mv,
    .ret_geom = ix__ret_geom,
    .ret_list = ix__ret_list,
    .ret_contours = ix__ret_contours,
    .result = result,
    .set_poles = ix__tell_poles,
    .number = ix__obj_number,
    .string = ix__obj_string,
    .point = ix__obj_point,
    .vector = ix__obj_vector,
    .freeform = ix__obj_mv,
    .list = ix__obj_list,
    .list_add = ix__list_add,
    .list_add_num = ix__list_add_num,
    .ref = ix__obj_ref,
    .unref = ix__obj_unref,
    .type = type_of,
    .list_size = list_size,
    .list_item = list_item,
    .num_of = num_of,
    .str_of = str_of,
    .mv_of = ix__obj_first_mv,
    .attr_set_int = attr_set_int,
    .attr_set_num = attr_set_num,
    .attr_set_str = attr_set_str,
    .attr_set_obj = attr_set_obj,
    .attr_num = attr_num,
};
