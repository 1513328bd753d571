/* options.c - the command line: one table row per option. */
#include "app/options.h"

#include <assert.h>
#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

typedef enum {
    TEXT,
    DEFINE,
    OUTPUT,
    QUIET,
    CHECK,
    STRICT,
    FORM,
    THREADS,
    MEMORY,
    STEPS,
    ROOT,
    SYSTEM,
    PLUGIN,
    PLUGINS,
    PLUGIN_DIR,
    LIST,
    HELP,
    VERSION
} option_id;

enum argument { NONE, REQUIRED, OPTIONAL };
static const struct {
    const char *name, *value; /* value: its name in the usage, or NULL */
    enum argument argument;
    option_id id;
    const char *help;
} table[] = {
    {"-e", "TEXT", REQUIRED, TEXT, "run TEXT (may be given several times)"},
    {"-D", "NAME=VALUE", REQUIRED, DEFINE,
     "define a variable: a number, else a string"},
    {"-o", "FILE", REQUIRED, OUTPUT,
     "save what the scripts view; the suffix decides the format"},
    {"-q", NULL, NONE, QUIET, "no warnings"},
    {"--check", NULL, NONE, CHECK, "parse and check types, run nothing"},
    {"--strict", NULL, NONE, STRICT, "stop at the first error of any kind"},
    {"--degree-form", "FORM", REQUIRED, FORM,
     "of operators: minimal (default), published, naive, irit"},
    {"--threads", "N", REQUIRED, THREADS,
     "threads for large work; 0 (default): one per processor"},
    {"--max-memory", "MB", REQUIRED, MEMORY,
     "limit of memory in MB (1024); 0: none"},
    {"--max-steps", "N", REQUIRED, STEPS,
     "limit of statements and loop rounds; 0 (default): none"},
    {"--root", "DIR", REQUIRED, ROOT,
     "scripts reach files below DIR only (the current directory)"},
    {"--allow-system", NULL, NONE, SYSTEM, "allow SYSTEM, and files anywhere"},
    {"--plugin", "FILE", REQUIRED, PLUGIN,
     "load a plug-in first (may be given several times)"},
    {"--allow-plugins", NULL, NONE, PLUGINS, "allow LOADEXT of any plug-in"},
    {"--plugin-dir", "DIR", REQUIRED, PLUGIN_DIR,
     "allow LOADEXT of the plug-ins below DIR"},
    {"--list-functions", NULL, NONE, LIST, "names and signatures"},
    {"--help", "[NAME]", OPTIONAL, HELP, "this text, or about a function"},
    {"--version", NULL, NONE, VERSION, "the version"},
};
#define NOPTIONS (sizeof table / sizeof *table)

void options_usage(FILE *f)
{
    (void)fprintf(f, "usage: iritx [options] [script...]\n"
                     "       iritx [options] command arguments\n"
                     "Runs .irt scripts; - or nothing is standard input.\n\n");
    for (size_t i = 0; i < NOPTIONS; i++) {
        char left[64];

        (void)snprintf(left, sizeof left, "%s %s", table[i].name,
                       table[i].value ? table[i].value : "");
        (void)fprintf(f, "  %-22s %s\n", left, table[i].help);
    }
    (void)fprintf(f, "\nCommands (a script of that name is run as ./NAME):\n");
    cmd_usage(f);
    (void)fprintf(f, "\nExit status: 0 fine, 1 an error was reported, 2 wrong "
                     "usage, 128+n signal n.\n");
}

static bool complain(const char *what, const char *arg)
{
    (void)fprintf(stderr, "iritx: %s: %s (iritx --help tells more)\n", arg,
                  what);
    return false;
}

static bool natural(const char *name, const char *s, unsigned long max,
                    unsigned long *out)
{
    char *end;

    errno = 0;
    *out = strtoul(s, &end, 10);
    if (*s >= '0' && *s <= '9' && !*end && !errno && *out <= max)
        return true;
    (void)fprintf(stderr, "iritx: %s takes a whole number 0 .. %lu, got %s\n",
                  name, max, s);
    return false;
}

static bool degree_form(options *o, const char *v)
{
    static const char *const forms[] = {"minimal", "published", "naive",
                                        "irit"};

    for (int i = 0; i < 4; i++) {
        if (strcmp(v, forms[i]) == 0) {
            o->degree_form = i;
            return true;
        }
    }
    return complain("--degree-form takes minimal, published, naive or irit", v);
}

static bool add_item(options *o, run_kind kind, const char *arg)
{
    if (kind == RUN_DEFINE && (!strchr(arg, '=') || *arg == '='))
        return complain("-D takes NAME=VALUE", arg);
    o->item[o->nitems++] = (run_item){kind, arg};
    return true;
}

/* Options that take a value. */
static bool apply_value(options *o, option_id id, const char *v)
{
    unsigned long n = 0;
    bool ok = true;

    assert(v);
    switch (id) {
    case TEXT:
        return add_item(o, RUN_TEXT, v);
    case DEFINE:
        return add_item(o, RUN_DEFINE, v);
    case PLUGIN:
        return add_item(o, RUN_PLUGIN, v);
    case PLUGIN_DIR:
        o->interp.plugin_dir = v;
        break;
    case FORM:
        return degree_form(o, v);
    case OUTPUT:
        o->output = v;
        break;
    case ROOT:
        o->interp.root = v;
        break;
    case THREADS:
        ok = natural("--threads", v, 64, &n);
        o->threads = (int)n;
        break;
    case MEMORY:
        ok = natural("--max-memory", v, 1ul << 24, &n);
        o->max_memory = (size_t)n << 20;
        break;
    default:
        ok = natural("--max-steps", v, ULONG_MAX, &o->interp.steps);
    }
    return ok;
}

static bool apply(options *o, option_id id, const char *v)
{
    switch (id) {
    case QUIET:
        o->interp.quiet = true;
        return true;
    case CHECK:
        o->interp.check_only = true;
        return true;
    case STRICT:
        o->interp.strict = true;
        return true;
    case SYSTEM:
        o->interp.allow_system = true;
        return true;
    case PLUGINS:
        o->interp.allow_plugins = true;
        return true;
    case LIST:
        o->task = DO_LIST;
        return true;
    case VERSION:
        o->task = DO_VERSION;
        return true;
    case HELP:
        o->task = DO_HELP;
        o->topic = v;
        return true;
    default:
        return apply_value(o, id, v);
    }
}

typedef struct {
    int argc, at;
    char **argv;
    options *o;
} reader;

/* The value after "--name=" or as the next argument. */
static bool option_value(reader *r, size_t i, const char *inline_value,
                         const char **v)
{
    *v = inline_value;
    if (table[i].argument == NONE)
        return !inline_value ||
               complain("this option takes no value", table[i].name);
    if (inline_value || r->at == r->argc)
        return inline_value || table[i].argument == OPTIONAL ||
               complain("this option needs a value", table[i].name);
    if (table[i].argument == OPTIONAL && *r->argv[r->at] == '-')
        return true;
    *v = r->argv[r->at++];
    return true;
}

static bool read_option(reader *r, const char *arg)
{
    const char *equals = strncmp(arg, "--", 2) == 0 ? strchr(arg, '=') : NULL;
    size_t n = equals ? (size_t)(equals - arg) : strlen(arg);

    for (size_t i = 0; i < NOPTIONS; i++) {
        const char *v;

        if (strlen(table[i].name) == n && strncmp(table[i].name, arg, n) == 0)
            return option_value(r, i, equals ? equals + 1 : NULL, &v) &&
                   apply(r->o, table[i].id, v);
    }
    return complain("unknown option", arg);
}

static bool runs_something(const options *o)
{
    for (int i = 0; i < o->nitems; i++)
        if (o->item[i].kind != RUN_PLUGIN)
            return true;
    return false;
}

/* The first argument that is no option may name a command, which takes all
 * that follows. */
static bool take_command(reader *r, const char *arg)
{
    options *o = r->o;

    if (runs_something(o) || !(o->command = cmd_find(arg)))
        return false;
    o->task = DO_COMMAND;
    o->args = r->argv + r->at;
    o->nargs = r->argc - r->at;
    return true;
}

bool options_read(int argc, char **argv, options *o)
{
    reader r = {argc, 1, argv, o};
    bool only_names = false;

    while (r.at < argc) {
        const char *arg = argv[r.at++];

        if (!only_names && take_command(&r, arg))
            return true;
        if (only_names || *arg != '-' || !arg[1])
            (void)add_item(o, RUN_FILE, arg);
        else if (strcmp(arg, "--") == 0)
            only_names = true;
        else if (!read_option(&r, arg))
            return false;
    }
    return true;
}
