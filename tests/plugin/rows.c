/* rows.c - a plug-in for tests: what WHICH names is wrong with its rows, or
 * nothing is, and then it has functions that use each part of the host. */
#include <stdio.h>
#include <string.h>

#include <iritx/plugin.h>

#ifndef WHICH
#define WHICH 0
#endif
#define RUNS "x = 1;"

static ix_status nothing(const ix_host *h, ix_call *c)
{
    (void)h;
    (void)c;
    return IX_OK;
}

/* What arrived, as a list of texts and numbers. */
static ix_status t_echo(const ix_host *h, ix_call *c)
{
    ix_ctx *ctx = h->ctx(c);
    ix_obj *list;
    double p[3], *nums;
    ix_status st;
    int i = 0, n = 0;

    IX_TRY(h->arg_int(c, 0, 1, 9, &i));
    IX_TRY(h->arg_pt3(c, 2, p));
    IX_TRY(h->arg_nums(c, 3, &n, &nums));
    list = h->list(ctx);
    st = h->list_add_num(ctx, list, h->argc(c));
    if (st == IX_OK)
        st = h->list_add_num(ctx, list, i);
    if (st == IX_OK)
        st = h->list_add(
            ctx, list,
            h->string(ctx, h->arg_str(c, 1), strlen(h->arg_str(c, 1))));
    if (st == IX_OK)
        st = h->list_add(ctx, list, h->point(ctx, p));
    if (st == IX_OK)
        st = h->list_add(ctx, list, h->vector(ctx, p));
    for (int k = 0; st == IX_OK && k < n; k++)
        st = h->list_add_num(ctx, list, nums[k]);
    return h->ret_list(c, list, st);
}

/* Attributes, the parts of objects, variables, states. */
static ix_status t_parts(const ix_host *h, ix_call *c)
{
    ix_ctx *ctx = h->ctx(c);
    ix_obj *x = h->arg(c, 0), *list = h->list(ctx);
    double v = -1;
    ix_status st = h->list_add_num(ctx, list, h->type(x));

    if (!h->attr_num(x, "weight", &v))
        h->remark(c, "no attribute %s", "weight");
    if (st == IX_OK)
        st = h->list_add_num(ctx, list, v);
    if (st == IX_OK)
        st = h->list_add_num(ctx, list, h->op_opts(c).form);
    if (st == IX_OK)
        st = h->list_add_num(ctx, list, h->var_num(c, "some_number", -2));
    if (st == IX_OK && h->mv_of(x))
        st = h->list_add_num(ctx, list, ix_mv_ndirs(h->mv_of(x)));
    for (int i = 0; st == IX_OK && i < h->list_size(x); i++)
        st = h->list_add(ctx, list, h->ref(h->list_item(x, i)));
    if (st == IX_OK)
        st = h->attr_set_int(ctx, list, "whole", 3);
    if (st == IX_OK)
        st = h->attr_set_num(ctx, list, "real", 0.5);
    if (st == IX_OK)
        st = h->attr_set_str(ctx, list, "text", "abc");
    return h->ret_list(c, list, st);
}

static ix_status t_fail(const ix_host *h, ix_call *c)
{
    if (h->arg_num(c, 0) == 0)
        return h->arg_fail(c, 0, "zero is no good, %d would be", 1);
    return h->fail(c, IX_EDOMAIN, "no result for %g", h->arg_num(c, 0));
}

static ix_status t_scratch(const ix_host *h, ix_call *c)
{
    double *a = h->scratch(c, 1000, sizeof *a), sum = 0;

    if (!a)
        return IX_ENOMEM;
    IX_TRY(h->poll(c));
    for (int i = 0; i < 1000; i++)
        a[i] = i;
    for (int i = 0; i < 1000; i++)
        sum += a[i];
    return h->ret_num(c, sum);
}

static const ix_plugin_row good[] = {
    {"T_ECHO", "i:num s:str p:pt3 l:list [more:any] -> list", "Arguments.",
     RUNS, t_echo, 0, 0},
    {"T_PARTS", "x:any -> list", "Parts.", RUNS, t_parts, 0, 0},
    {"T_FAIL", "x:num -> num", "Fails.", RUNS, t_fail, 0, 0},
    {"T_SOFT", "x:num -> num", "Fails.", RUNS, t_fail, IX_PLUGIN_SOFT, 0},
    {"T_SCRATCH", "-> num", "499500.", RUNS, t_scratch, 0, 0},
    {0}};
/* One fault in each; a good row before it must not be registered either. */
static const ix_plugin_row faulty[][3] = {
    {{0}},
    {{"GOOD_1", "-> num", "S.", RUNS, nothing, 0, 0},
     {"lower", "-> num", "S.", RUNS, nothing, 0, 0}},
    {{"GOOD_2", "-> num", "S.", RUNS, nothing, 0, 0},
     {"T_A", "x:number -> num", "S.", RUNS, nothing, 0, 0}},
    {{"T_B", "x:num", "S.", RUNS, nothing, 0, 0}},
    {{"T_C", "-> num", "", RUNS, nothing, 0, 0}},
    {{"T_D", "-> num", "S.", NULL, nothing, 0, 0}},
    {{"T_E", "-> num", "S.", RUNS, NULL, 0, 0}},
    {{"EVOLUTE", "-> num", "S.", RUNS, nothing, 0, 0}},
    {{"T_F", "-> num", "S.", RUNS, nothing, 0, 0},
     {"T_F", "-> num", "S.", RUNS, nothing, 0, 0}},
};
#define FAULTS ((int)(sizeof faulty / sizeof *faulty))

ix_status ix_plugin_init(const ix_host *h, ix_registry *r)
{
    if (h->version < IX_PLUGIN_VERSION || h->size < sizeof *h)
        return IX_EUNABLE;
    if (WHICH == FAULTS)
        return h->add(r, IX_PLUGIN_VERSION + 1, good);
    return h->add(r, IX_PLUGIN_VERSION, WHICH == 0 ? good : faulty[WHICH]);
}
