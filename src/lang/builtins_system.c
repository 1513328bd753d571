/* builtins_system.c - variables, states, scripts and the surroundings
 * (chapter 1). The statements IF, FOR, WHILE, FUNCTION and PROCEDURE of this
 * chapter are syntax and live in the parser. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/numfmt.h"
#include "lang/interp.h"
#include "lang/startup.h"

/* Prints what a buffer holds, and frees it. */
static ix_status print(ix_call *c, ix_buf *b)
{
    ix_status st = ix__buf_check(b);

    if (st == IX_OK && b->len > 0)
        ix__out(c->in, b->data, b->len);
    ix__buf_free(b);
    return st;
}

/* --- variables
 * ------------------------------------------------------------------ */

static ix_status b_free(ix_call *c)
{
    const ix_obj *o = c->argv[0];

    if (!o->name || ix__var_find(c->in, o->name) != o)
        return IX_ARG_FAIL(c, 0, "only a variable can be freed");
    return ix__var_free(c->in, o->name);
}

static ix_status b_thisobj(ix_call *c)
{
    const ix_obj *o = ix__var_find(c->in, ix__arg_str(c, 0));

    return ix__ret_num(c, o ? (double)o->type : IX_OBJ_UNDEF);
}

static ix_status b_varlist(ix_call *c)
{
    ix_buf b;
    const ix_obj *o;

    ix__buf_init(&b, c->ctx);
    for (size_t i = 0; (o = ix__var_at(c->in, i)); i++)
        ix__buf_printf(&b, "%-20s %s\n", o->name, ix__obj_type_name(o->type));
    return print(c, &b);
}

static ix_status b_reset(ix_call *c)
{
    return ix__var_reset(c->in);
}

static ix_status b_fnfree(ix_call *c)
{
    return ix__fn_free(c->in, ix__arg_str(c, 0));
}

/* --- IRITSTATE
 * ------------------------------------------------------------------- */

typedef enum {
    S_INT,  /* an int of ix_states */
    S_BOOL, /* a bool of ix_states */
    S_REAL, /* a double of ix_states */
    S_SEED, /* RandomInit */
    S_FORMAT /* FloatFrmt */,
    S_NUMBER, /* remembered only: a number, a vector, a string */
    S_VECTOR,
    S_STRING
} state_kind;

typedef struct {
    const char *name;
    state_kind kind;
    size_t at;         /* offset in ix_states */
    double lo, hi;     /* admitted numbers */
    double initial[3]; /* of remembered ones */
} state;

#define IN(member) offsetof(ix_states, member)
#define ANY_NUMBER -HUGE_VAL, HUGE_VAL

static const state states[] = {
    {"BoolFreeform", S_VECTOR, 0, ANY_NUMBER, {0.01, 1e-8, 0.01}},
    {"BoolPerturb", S_NUMBER, 0, ANY_NUMBER, {0}},
    {"BspProdMethod", S_INT, IN(bsp_prod_method), 0, 2, {0}},
    {"CmpObjEps", S_REAL, IN(cmp_eps), 0, HUGE_VAL, {0}},
    {"CnvxPl2Vrtcs", S_NUMBER, 0, ANY_NUMBER, {0}},
    {"Coplanar", S_NUMBER, 0, ANY_NUMBER, {1}},
    {"CursorKeep", S_NUMBER, 0, ANY_NUMBER, {0}},
    {"DebugFunc", S_BOOL, IN(debug_func), ANY_NUMBER, {0}},
    {"DegreeForm", S_INT, IN(degree_form), 0, 3, {0}},
    {"Dependency", S_NUMBER, 0, ANY_NUMBER, {0}},
    {"DoGraphics", S_NUMBER, 0, ANY_NUMBER, {0}},
    {"DumpLevel", S_INT, IN(dump_level), 0, 0x7fff, {0}},
    {"EchoSource", S_BOOL, IN(echo_source), ANY_NUMBER, {0}},
    {"FastPolys", S_NUMBER, 0, ANY_NUMBER, {0}},
    {"FlatLoad", S_NUMBER, 0, ANY_NUMBER, {0}},
    {"FloatFrmt", S_FORMAT, 0, 0, 0, {0}},
    {"GMEpsilon", S_NUMBER, 0, ANY_NUMBER, {1e-5}},
    {"InterCrv", S_NUMBER, 0, ANY_NUMBER, {0}},
    {"InterUV", S_NUMBER, 0, ANY_NUMBER, {0}},
    {"LoadFont", S_STRING, 0, 0, 0, {0}},
    {"MvDmnReduce", S_NUMBER, 0, ANY_NUMBER, {1}},
    {"MvGradPrecond", S_NUMBER, 0, ANY_NUMBER, {0}},
    {"MvHPlnTst", S_NUMBER, 0, ANY_NUMBER, {1}},
    {"MvKantTst", S_NUMBER, 0, ANY_NUMBER, {1}},
    {"MvNConeTst", S_NUMBER, 0, ANY_NUMBER, {1}},
    {"PolySort", S_NUMBER, 0, ANY_NUMBER, {0}},
    {"PrimRatSrfs", S_BOOL, IN(prim_rat_srfs), ANY_NUMBER, {0}},
    {"PrimType", S_INT, IN(prim_type), 0, 2, {0}},
    {"RandomInit", S_SEED, IN(random), ANY_NUMBER, {0}},
    {"TrimCrvs", S_NUMBER, 0, ANY_NUMBER, {1e-4}},
    {"UVBoolean", S_NUMBER, 0, ANY_NUMBER, {0}},
};

static const state *find_state(const char *name)
{
    for (size_t i = 0; i < sizeof states / sizeof *states; i++)
        if (ix__name_cmp(states[i].name, name) == 0)
            return &states[i];
    return NULL;
}

static const char *wanted(state_kind k)
{
    return k == S_VECTOR                    ? "a vector"
           : k == S_STRING || k == S_FORMAT ? "a string"
                                            : "a number";
}

static ix_status check_value(ix_call *c, const state *s)
{
    const ix_obj *v = c->argv[1];
    ix_obj_type want = s->kind == S_VECTOR ? IX_OBJ_VECTOR
                       : s->kind == S_STRING || s->kind == S_FORMAT
                           ? IX_OBJ_STRING
                           : IX_OBJ_NUMBER;

    if (v->type != want)
        return IX_ARG_FAIL(c, 1, "state %s needs %s, not %s", s->name,
                           wanted(s->kind), ix__obj_type_name(v->type));
    if (want == IX_OBJ_NUMBER && !(v->u.num >= s->lo && v->u.num <= s->hi))
        return IX_ARG_FAIL(c, 1, "state %s must be from %g to %g, not %g",
                           s->name, s->lo, s->hi, v->u.num);
    return IX_OK;
}

/* The value before any was set, as an object. */
static ix_obj *initial_value(ix_ctx *ctx, const state *s)
{
    if (s->kind == S_VECTOR)
        return ix__obj_vector(ctx, s->initial);
    if (s->kind == S_STRING)
        return ix__obj_string(ctx, "", 0);
    return ix__obj_number(ctx, s->initial[0]);
}

/* Old value to the result, new one to the attribute of the state's name. */
static ix_status remember(ix_call *c, const state *s)
{
    ix_attr **other = &ix__states(c->in)->other;
    ix_attr *old = ix__attr_find(*other, s->name);
    ix_obj *copy;
    ix_status st;

    IX_TRY(ix__ret(c, old ? ix__obj_copy(c->ctx, old->obj)
                          : initial_value(c->ctx, s)));
    copy = ix__obj_copy(c->ctx, c->argv[1]);
    if (!copy)
        return IX_ENOMEM;
    st = ix__obj_set_name(c->ctx, copy, NULL);
    if (st == IX_OK)
        st = ix__attr_set_obj(c->ctx, other, s->name, copy);
    ix__obj_unref(c->ctx, copy);
    return st;
}

/* Integral seeds that differ give sequences that differ; so do others. */
static uint64_t seed_of(double v)
{
    uint64_t bits;

    memcpy(&bits, &v, sizeof bits);
    return v == rint(v) && fabs(v) < 0x1p62 ? (uint64_t)(int64_t)v : bits;
}

static ix_status set_format(ix_call *c, ix_states *s)
{
    const char *f = ix__arg_str(c, 1), *end;
    ix_numfmt parsed;

    end = *f == '%' ? ix__numfmt_parse(f, &parsed) : NULL;
    if (!end || *end || !strchr("eEfFgG", parsed.conv) ||
        strlen(f) >= sizeof s->float_format)
        return IX_ARG_FAIL(c, 1,
                           "\"%.60s\" is no format of a number such as "
                           "\"%%.15g\"",
                           f);
    IX_TRY(ix__ret(
        c, ix__obj_string(c->ctx, s->float_format, strlen(s->float_format))));
    memcpy(s->float_format, f, strlen(f) + 1);
    s->float_format_set = true;
    return IX_OK;
}

static ix_status b_iritstate(ix_call *c)
{
    const state *s = find_state(ix__arg_str(c, 0));
    ix_states *all = ix__states(c->in);
    char *at;
    double old;

    if (!s)
        return IX_ARG_FAIL(c, 0, "undefined IritState \"%.60s\" ignored",
                           ix__arg_str(c, 0));
    IX_TRY(check_value(c, s));
    at = (char *)all + s->at;
    switch (s->kind) {
    case S_INT:
        old = *(int *)(void *)at;
        *(int *)(void *)at = (int)ix__arg_num(c, 1);
        return ix__ret_num(c, old);
    case S_BOOL:
        old = *(bool *)at;
        *(bool *)at = ix__arg_bool(c, 1);
        return ix__ret_num(c, old);
    case S_REAL:
        old = *(double *)(void *)at;
        *(double *)(void *)at = ix__arg_num(c, 1);
        return ix__ret_num(c, old);
    case S_SEED:
        IX_TRY(remember(c, s));
        all->random = seed_of(ix__arg_num(c, 1));
        return IX_OK;
    case S_FORMAT:
        return set_format(c, all);
    case S_NUMBER:
    case S_VECTOR:
    case S_STRING:
        break;
    }
    return remember(c, s);
}

/* --- time
 * ------------------------------------------------------------------------- */

static double cpu_seconds(void)
{
    struct timespec t;

    if (clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t) != 0)
        return 0;
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static ix_status b_time(ix_call *c)
{
    ix_states *s = ix__states(c->in);
    double now = cpu_seconds(), since = now - s->time_start;

    if (ix__arg_bool(c, 0))
        s->time_start = now;
    return ix__ret_num(c, since);
}

/* A batch run does not wait. */
static ix_status b_msleep(ix_call *c)
{
    (void)c;
    return IX_OK;
}

/* --- scripts
 * ------------------------------------------------------------------------ */

static ix_status b_include(ix_call *c)
{
    return ix__queue_file(c->in, ix__arg_str(c, 0));
}

static ix_status b_exec(ix_call *c)
{
    return ix__exec_text(c->in, ix__arg_str(c, 0));
}

static ix_status b_error(ix_call *c)
{
    return IX_FAIL(c->ctx, IX_EARG, "%s", ix__arg_str(c, 0));
}

static ix_status b_exit(ix_call *c)
{
    return ix__exit(c->in);
}

static ix_status b_logfile(ix_call *c)
{
    if (c->argv[0]->type == IX_OBJ_STRING)
        return ix__log(c->in, ix__arg_str(c, 0), true);
    return ix__log(c->in, NULL, ix__arg_bool(c, 0));
}

/* --- the surroundings
 * ----------------------------------------------------------------- */

static ix_status b_chdir(ix_call *c)
{
    const char *dir = ix__arg_str(c, 0);

    IX_TRY(ix__dir_check(c->in, dir));
    if (chdir(dir) != 0)
        return IX_FAIL(c->ctx, IX_EIO, "%s: %s", dir, strerror(errno));
    return IX_OK;
}

static ix_status b_system(ix_call *c)
{
    int rc;

    IX_TRY(ix__system_check(c->in));
    (void)fflush(NULL); /* what was printed before comes first */
    rc = system(ix__arg_str(c, 0));
    if (rc != 0)
        ix__remark(c->in, "the command ended with status %d",
                   rc > 255 ? rc / 256 : rc);
    return IX_OK;
}

static ix_status b_loadext(ix_call *c)
{
    return ix__plugin_open(c->in, ix__arg_str(c, 0));
}

/* --- help and debugging
 * ----------------------------------------------------------------- */

static ix_status b_help(ix_call *c)
{
    const char *topic = ix__arg_str(c, 0);
    const ix_builtin *f = ix__builtin_find(topic);
    const ix__startup_fn *lib = ix__startup_find(topic);
    ix_buf b;

    ix__buf_init(&b, c->ctx);
    if (f)
        ix__buf_printf(&b, "%s %s\n    %s\n    Example: %s\n", f->name,
                       f->signature, f->summary, f->example);
    else if (lib)
        ix__buf_printf(&b, "%s\n    %s\n    Text: %s\n", lib->name,
                       lib->summary, lib->text);
    else if (*topic)
        ix__remark(c->in, "no function is called %.60s", topic);
    else
        ix__buf_puts(&b, "help(\"NAME\") tells about a function, iquery(1) "
                         "lists all of them.\n");
    return print(c, &b);
}

/* Names in columns of 20 characters, four a line. */
static void add_column(ix_buf *b, const char *name, size_t i)
{
    ix__buf_printf(b, i % 4 == 3 ? "%s\n" : "%-19s ", name);
}

static ix_status b_iquery(ix_call *c)
{
    ix_buf b;
    const ix_builtin *f;
    const char *name;
    int what;

    IX_TRY(ix__arg_int(c, 0, 1, 2, &what));
    ix__buf_init(&b, c->ctx);
    for (size_t i = 0; what == 1 && (f = ix__builtin_at(i)); i++)
        add_column(&b, f->name, i);
    for (size_t i = 0; what == 2 && (name = ix__fn_at(c->in, i)); i++)
        add_column(&b, name, i);
    ix__buf_putc(&b, '\n');
    return print(c, &b);
}

static ix_status b_idynmem(ix_call *c)
{
    ix_buf b;

    ix__buf_init(&b, c->ctx);
    ix__buf_printf(&b, "%zu bytes in use\n", c->ctx->live);
    return print(c, &b);
}

static ix_status b_examplefunc(ix_call *c)
{
    const double *v = c->argv[1]->u.pt;
    ix_buf b;

    ix__buf_init(&b, c->ctx);
    ix__buf_printf(&b, "The number %g and the vector (%g, %g, %g).\n",
                   ix__arg_num(c, 0), v[0], v[1], v[2]);
    return print(c, &b);
}

const ix_builtin ix__builtins_system[] = {
    {"CHDIR", "dir:str -> nothing", "Changes the working directory.",
     "chdir(\".\");", b_chdir, IX_B_LOCAL, 1},
    {"ERROR", "message:str -> nothing",
     "Prints the message and stops the script: a hard error.",
     "error(\"bad input\");", b_error, IX_B_LOCAL, 1},
    {"EXAMPLEFUNC", "n:num v:vector -> nothing",
     "Prints its arguments: the least that a function can do.",
     "examplefunc(1, vector(1, 2, 3));", b_examplefunc, IX_B_LOCAL, 1},
    {"EXEC", "text:str -> nothing",
     "Runs text as one statement; it sees and sets the variables of the "
     "running functions.",
     "exec(\"a = 3\");", b_exec, IX_B_LOCAL, 1},
    {"EXIT", "-> nothing", "Ends the interpreter with status 0.", "exit();",
     b_exit, IX_B_LOCAL, 1},
    {"FNFREE", "name:str -> nothing",
     "Removes a user function; with \"\" all in USR_FN_LIST.",
     "f = function(x): return = x; fnfree(\"f\");", b_fnfree, IX_B_LOCAL, 1},
    {"FREE", "variable:any -> nothing", "Removes a variable.",
     "a = 1: free(a);", b_free, IX_B_LOCAL, 1},
    {"HELP", "topic:str -> nothing", "Tells about a function.",
     "help(\"sin\");", b_help, IX_B_LOCAL, 1},
    {"IDYNMEM", "k:num -> nothing", "Prints how much memory is in use.",
     "idynmem(0);", b_idynmem, IX_B_LOCAL, 1},
    {"INCLUDE", "file:str -> nothing",
     "Runs a script after the rest of this line; \".irt\" is added if missing.",
     "include(\"shapes\");", b_include, IX_B_LOCAL, 1},
    {"IQUERY", "k:num -> nothing",
     "Lists the built-in functions (k = 1) or the user's (k = 2).",
     "iquery(2);", b_iquery, IX_B_LOCAL, 1},
    {"IRITSTATE", "name:str value:any -> any",
     "Sets a state of the interpreter, such as \"FloatFrmt\", "
     "\"RandomInit\" or \"DegreeForm\"; its old value.",
     "old = iritstate(\"RandomInit\", 1964);", b_iritstate,
     IX_B_SOFT | IX_B_STATE, 1},
    {"LOGFILE", "log:num|str -> nothing",
     "Starts (1) or stops (0) a copy of the output, or starts it in the file "
     "of that name.",
     "logfile(off);", b_logfile, IX_B_LOCAL, 1},
    {"MSLEEP", "ms:num -> nothing",
     "Waits on displays; scripts that run on their own do not wait.",
     "msleep(10);", b_msleep, IX_B_LOCAL, 1},
    {"RESET", "-> nothing",
     "Removes all variables and makes the predefined ones anew; functions "
     "stay.",
     "reset();", b_reset, IX_B_LOCAL, 1},
    {"SYSTEM", "command:str -> nothing",
     "Runs a shell command, if the program was allowed to.", "system(\"ls\");",
     b_system, IX_B_LOCAL, 1},
    {"LOADEXT", "file:str -> nothing",
     "Loads a plug-in, whose functions can be used from the next statement on, "
     "if the program was allowed to (--allow-plugins, --plugin-dir).",
     "loadext(\"pedal.so\");", b_loadext, IX_B_LOCAL, 1},
    {"THISOBJ", "name:str -> num",
     "The type of the variable of that name, such as CURVE_TYPE; 0 if there "
     "is none.",
     "a = 1: thisobj(\"a\") == numeric_type;", b_thisobj, IX_B_LOCAL, 1},
    {"TIME", "reset:num -> num",
     "Processor seconds since the last call with reset not 0, or since the "
     "start.",
     "t = time(true);", b_time, IX_B_STATE, 1},
    {"VARLIST", "-> nothing", "Lists all variables with their types.",
     "varlist();", b_varlist, IX_B_LOCAL, 1},
    {NULL, NULL, NULL, NULL, NULL, 0, 0}};
