/* builtins_output.c - files, printing and what takes the place of displays
 * (chapter 4). Nothing is displayed: what a script shows is collected, for
 * programs that render it afterwards. */
#include <math.h>
#include <string.h>

#include "lang/clients.h"
#include "lang/deep_copy.h"
#include "lang/interp.h"

/* For formats that hold polygons (docs/exports.md). */
static double save_tol(ix_interp *in)
{
    if (ix__var_num(in, "POLY_APPROX_OPT", 0) == 0)
        return 0;
    return fmax(ix__var_num(in, "POLY_APPROX_TOL", 0), 0);
}

static ix_status b_save(ix_call *c)
{
    const ix_states *s = ix__states(c->in);
    const ix_write_opts w = {
        .float_format = s->float_format_set ? s->float_format : NULL,
        .tol = save_tol(c->in)};
    const char *name = ix__arg_str(c, 0);

    IX_TRY(ix__path_check(c->in, name, true));
    return ix__save(c->ctx, name, c->argv[1], &w);
}

/* Named objects inside o (lists at any depth) become global variables. */
static ix_status globals_of(ix_call *c, ix_obj *o, int depth)
{
    if (depth > IX_MAX_DEPTH || o->type != IX_OBJ_LIST)
        return IX_OK;
    for (int i = 0; i < o->u.list.n; i++) {
        ix_obj *item = o->u.list.item[i];

        if (item->name)
            IX_TRY(ix__var_set(c->in, item->name, item));
        IX_TRY(globals_of(c, item, depth + 1));
    }
    return IX_OK;
}

/* State FlatLoad: one list of everything that is no list. */
static ix_status flatten(ix_call *c, ix_obj *o)
{
    ix_obj **leaf;
    int n;

    IX_TRY(ix__leaves(c->ctx, o, &n, &leaf));
    IX_TRY(ix__ret(c, ix__obj_list(c->ctx)));
    for (int i = 0; i < n; i++)
        IX_TRY(ix__obj_append(c->ctx, c->result, leaf[i]));
    return IX_OK;
}

static bool flat_load(ix_call *c)
{
    ix_attr *a = ix__attr_find(ix__states(c->in)->other, "FlatLoad");

    return a && a->obj->type == IX_OBJ_NUMBER && a->obj->u.num != 0;
}

static ix_status b_load(ix_call *c)
{
    const char *name = ix__arg_str(c, 0);
    ix_obj *o;
    ix_status st;

    IX_TRY(ix__path_check(c->in, name, false));
    IX_TRY(ix__load(c->ctx, name, NULL, &o));
    st = globals_of(c, o, 1);
    if (st == IX_OK && o->type == IX_OBJ_LIST && flat_load(c)) {
        st = flatten(c, o);
        ix__obj_unref(c->ctx, o);
        return st;
    }
    if (st == IX_OK)
        return ix__ret(c, o);
    ix__obj_unref(c->ctx, o);
    return st;
}

static ix_status b_printf(ix_call *c)
{
    ix_buf b;
    ix_status st;

    ix__buf_init(&b, c->ctx);
    st = ix__printf(c->in, ix__arg_str(c, 0), c->argv[1], &b);
    if (st == IX_OK)
        st = ix__buf_check(&b);
    if (st == IX_OK && b.len > 0)
        ix__out(c->in, b.data, b.len);
    ix__buf_free(&b);
    return st;
}

static ix_status b_printfile(ix_call *c)
{
    const char *name = ix__arg_str(c, 0);

    if (*name)
        IX_TRY(ix__path_check(c->in, name, true));
    return ix__out_redirect(c->in, name);
}

/* Strings named COMMAND_... are meant for the display; those that clear it
 * are the only ones with an effect here. */
static ix_status display_command(ix_call *c, const ix_obj *o)
{
    if (strcmp(o->u.str.s, "CLEAR") == 0 || strcmp(o->u.str.s, "DCLEAR") == 0)
        return ix__view(c->in, NULL);
    return IX_OK;
}

static ix_status b_viewobj(ix_call *c)
{
    ix_obj *o = c->argv[0], *copy;
    ix_status st;

    if (o->type == IX_OBJ_STRING && o->name &&
        strncmp(o->name, "COMMAND_", 8) == 0)
        return display_command(c, o);
    IX_TRY(ix__deep_copy(c->ctx, o, &copy)); /* as it is now */
    st = ix__view(c->in, copy);
    ix__obj_unref(c->ctx, copy);
    return st;
}

static ix_status b_viewset(ix_call *c)
{
    (void)c; /* there is one place that collects */
    return IX_OK;
}

ix_status ix__no_client(ix_call *c)
{
    return IX_FAIL(c->ctx, IX_EUNABLE,
                   "scripts run without client programs here: there is nobody "
                   "to talk to");
}

/* The rows CLNT... belong to chapter 24. */
const ix_builtin ix__builtins_output[] = {
    {"CLNTCLOSE", "handle:num kill:num -> nothing",
     "Would end a client program; there are none.", "clntclose(0, true);",
     ix__no_client, IX_B_SOFT | IX_B_LOCAL, 24},
    {"CLNTCRSR", "ms:num -> list",
     "Would wait for the mouse on a display; there is none.", "clntcrsr(10);",
     ix__no_client, IX_B_SOFT | IX_B_LOCAL, 24},
    {"CLNTEXEC", "command:str -> num",
     "Would start a client program; there are none.", "clntexec(\"prog\");",
     ix__no_client, IX_B_SOFT | IX_B_LOCAL, 24},
    {"CLNTREAD", "handle:num ms:num -> any",
     "Would read an object from a client program; there are none.",
     "clntread(0, 10);", ix__no_client, IX_B_SOFT | IX_B_LOCAL, 24},
    {"CLNTWRITE", "handle:num x:any -> nothing",
     "Would send an object to a client program; there are none.",
     "clntwrite(clients_all, axes);", ix__no_client, IX_B_SOFT | IX_B_LOCAL,
     24},
    {"LOAD", "file:str -> any",
     "Reads a file; several objects come as a list, and named objects in it "
     "also become variables.",
     "save(\"a\", 5): a = load(\"a\");", b_load, IX_B_LOCAL, 4},
    {"PRINTF", "format:str args:list -> nothing",
     "Prints like C: %d %i %u %o %x %X %e %f %g %E %G %s, and with one of e, "
     "f, "
     "g behind them %p point, %v vector, %P plane, %D any object; \\\\n is a "
     "new line.",
     "printf(\"k = %f\\\\n\", list(2));", b_printf, IX_B_SOFT | IX_B_LOCAL, 4},
    {"PRINTFILE", "file:str -> nothing",
     "Sends printed output to a file; \"\" ends that.", "printfile(\"\");",
     b_printfile, IX_B_LOCAL, 4},
    {"SAVE", "file:str x:any -> nothing",
     "Writes x to a file in the format of its suffix; \".itd\" is added if it "
     "has none.",
     "save(\"a\", list(1, point(1, 2, 3)));", b_save, IX_B_LOCAL, 4},
    {"VIEWOBJ", "x:any -> nothing",
     "Adds x to what is to be shown; strings named COMMAND_ control displays.",
     "viewobj(list(view_mat, axes));", b_viewobj, IX_B_LOCAL, 4},
    {"VIEWSET", "handle:num -> nothing", "Selects a display.",
     "viewset(clients_all);", b_viewset, IX_B_LOCAL, 4},
    {NULL, NULL, NULL, NULL, NULL, 0, 0}};
