/* main.c - the program iritx: runs scripts in batch.
 *
 * It prompts only if both standard streams are terminals. Exit codes: 0 fine, 1
 * an error was reported, 2 wrong usage, 128 + n ended by signal n. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "app/listing.h"
#include "app/options.h"
#include "app/picture.h"
#include "app/progress.h"
#include "app/prompt.h"
#include "plugin/load.h"

#define DEFAULT_MEMORY ((size_t)1 << 30)
#define STDOUT_BUFFER  65536

static volatile int cancel; /* the number of the signal that came */

/* The first signal asks the computation to stop, the second one kills. */
static void on_signal(int sig)
{
    if (cancel) {
        (void)signal(sig, SIG_DFL);
        (void)raise(sig);
    }
    cancel = sig;
}

static void set_signals(void)
{
    static const int stopping[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction a = {.sa_handler = on_signal}, old;

    (void)sigemptyset(&a.sa_mask);
    for (size_t i = 0; i < sizeof stopping / sizeof *stopping; i++) {
        (void)sigaction(stopping[i], NULL, &old);
        if (old.sa_handler != SIG_IGN) /* a background job of a shell */
            (void)sigaction(stopping[i], &a, NULL);
    }
    a.sa_handler = SIG_IGN; /* writing fails instead, and is reported */
    (void)sigaction(SIGPIPE, &a, NULL);
    (void)sigaction(SIGXFSZ, &a, NULL);
}

/* A closed standard stream must not be taken by the next file that we open;
 * what is written to it then fails. */
static void fill_streams(void)
{
    int fd;

    do
        fd = open("/dev/null", O_RDONLY);
    while (fd >= 0 && fd <= 2);
    if (fd >= 0)
        (void)close(fd);
}

/* --- running
 * ------------------------------------------------------------------- */

static ix_status complain(ix_ctx *ctx, ix_status st)
{
    ix__progress_clear(ctx);
    (void)fprintf(stderr, "iritx: error: %s\n", ix_ctx_message(ctx));
    return st;
}

/* NAME=VALUE: a number if VALUE is one, else a string. */
static ix_status define(ix_interp *in, const char *arg)
{
    ix_ctx *ctx = ix__interp_ctx(in);
    const char *value = strchr(arg, '=') + 1, *end = value + strlen(value);
    char name[256];
    double v;
    ix_obj *o;
    ix_status st;

    if ((size_t)(value - arg) > sizeof name)
        return IX_FAIL(ctx, IX_EARG, "-D: the name is too long");
    memcpy(name, arg, (size_t)(value - arg) - 1);
    name[value - arg - 1] = '\0';
    if (*value && ix_num_parse(value, end, &v) == end)
        o = ix__obj_number(ctx, v);
    else
        o = ix__obj_string(ctx, value, strlen(value));
    if (!o)
        return IX_ENOMEM;
    st = ix__var_set(in, name, o);
    ix__obj_unref(ctx, o);
    return st;
}

static ix_status define_all(ix_interp *in, const options *o)
{
    for (int i = 0; i < o->nitems; i++)
        if (o->item[i].kind == RUN_DEFINE)
            IX_TRY(define(in, o->item[i].arg));
    return IX_OK;
}

/* Scripts and texts in their order. */
static ix_status run_all(ix_interp *in, const options *o)
{
    bool any = false;

    for (int i = 0; i < o->nitems; i++) {
        const run_item *r = &o->item[i];

        if (r->kind == RUN_TEXT)
            IX_TRY(ix__interp_run_text(in, "<-e>", r->arg, strlen(r->arg)));
        else if (r->kind == RUN_FILE)
            IX_TRY(ix__interp_run_file(in, r->arg));
        any = any || r->kind == RUN_TEXT || r->kind == RUN_FILE;
    }
    return any ? IX_OK : ix__interp_run_file(in, "-");
}

/* What was viewed, as one object or a list. */
static ix_status save_viewed(ix_interp *in, const char *name)
{
    const ix_obj *list = ix__interp_viewed(in);
    const ix_states *s = ix__states(in);
    ix_write_opts w = {.float_format = s->float_format_set ? s->float_format
                                                           : NULL,
                       .file = true};

    return ix__save(ix__interp_ctx(in), name,
                    list->u.list.n == 1 ? list->u.list.item[0] : list, &w);
}

static int run(ix_ctx *ctx, const options *o)
{
    prompt person = {.cancel = &cancel};
    ix_interp_opts opts = o->interp;
    ix_interp *in;
    ix_status st;
    int errors;

    opts.load_plugin = ix__plugin_load;
    if (prompt_wanted()) {
        opts.read_line = prompt_line;
        opts.show_value = prompt_show;
        opts.read_ud = &person;
    }
    st = ix__interp_new(ctx, &opts, &in);
    if (st != IX_OK)
        return complain(ctx, st) != IX_OK;
    person.in = in;
    ix__states(in)->degree_form = o->degree_form;
    st = define_all(in, o);
    if (st != IX_OK)
        (void)complain(ctx, st);
    else
        st = run_all(in, o); /* has reported its errors */
    if (st == IX_OK && o->output && !o->interp.check_only) {
        st = save_viewed(in, o->output);
        if (st != IX_OK)
            (void)complain(ctx, st);
    }
    errors = ix__interp_errors(in);
    prompt_end(&person);
    ix__interp_free(in);
    return st != IX_OK || errors;
}

static void show_note(void *ud, const char *text)
{
    (void)ud;
    (void)fprintf(stderr, "iritx: %s\n", text);
}

static int run_command(ix_ctx *ctx, const options *o)
{
    if (o->nargs == 1 && strcmp(o->args[0], "--help") == 0) {
        cmd_help(o->command);
        return 0;
    }
    if (!o->interp.quiet)
        ix_ctx_set_note(ctx, show_note, NULL);
    return o->command->run(ctx, o->nargs, o->args);
}

static int run_with_context(const options *o)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    int rc;

    if (!ctx) {
        (void)fprintf(stderr, "iritx: error: out of memory\n");
        return 1;
    }
    ix_ctx_set_memory_limit(ctx, o->max_memory);
    ix_ctx_set_threads(ctx, o->threads);
    ix_ctx_set_cancel(ctx, &cancel);
    progress_watch(ctx);
    rc = o->task == DO_COMMAND ? run_command(ctx, o) : run(ctx, o);
    ix_ctx_set_progress(ctx, NULL, NULL);
    ix_ctx_free(ctx);
    return rc;
}

/* The plug-ins of the command line come first, for --help knows them too. */
static bool load_plugins(const options *o)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_status st = ctx ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < o->nitems; i++)
        if (o->item[i].kind == RUN_PLUGIN)
            st = ix__plugin_load(ctx, o->item[i].arg);
    if (st != IX_OK)
        (void)fprintf(stderr, "iritx: error: %s\n",
                      ctx ? ix_ctx_message(ctx) : "out of memory");
    ix_ctx_free(ctx);
    return st == IX_OK;
}

static int perform(const options *o)
{
    switch (o->task) {
    case DO_VERSION:
        (void)printf("iritx %s\n", ix_version());
        return 0;
    case DO_LIST:
        listing_functions();
        return 0;
    case DO_HELP:
        if (!o->topic) {
            options_usage(stdout);
        } else if (!listing_help(o->topic)) {
            (void)fprintf(stderr, "iritx: no function is called %s\n",
                          o->topic);
            return 2;
        }
        return 0;
    default:
        return run_with_context(o);
    }
}

/* Standard output is complete, or the exit code says that it is not. */
static int finish(int rc)
{
    bool failed = fflush(stdout) != 0 || ferror(stdout);

    if (failed && rc == 0 && errno != EPIPE)
        (void)fprintf(stderr,
                      "iritx: error: cannot write standard output: "
                      "%s\n",
                      strerror(errno));
    if (cancel)
        return 128 + cancel;
    return failed && rc == 0 ? 1 : rc;
}

int main(int argc, char **argv)
{
    static char buffer[STDOUT_BUFFER];
    options o = {.max_memory = DEFAULT_MEMORY};
    int rc = 2;

    fill_streams();
    set_signals();
    picture_register();
    (void)setvbuf(stdout, buffer, _IOFBF, sizeof buffer);
    o.interp.include_path = getenv("IRIT_INCLUDE");
    o.item = calloc((size_t)argc + 1, sizeof *o.item);
    if (!o.item)
        (void)fprintf(stderr, "iritx: error: out of memory\n");
    else if (options_read(argc, argv, &o))
        rc = load_plugins(&o) ? perform(&o) : 1;
    free(o.item);
    return finish(rc);
}
