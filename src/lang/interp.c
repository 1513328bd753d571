/* interp.c - the interpreter as a whole: making and freeing it, running
 * scripts and texts, and the services that primitives use.
 *
 * After the first hard error all sources are closed, but the rest of the
 * present physical line still runs, as in the reference (spec/language 9). */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "lang/arrangements.h"
#include "lang/interp_impl.h"

#define DEFAULT_CALLS  1000
#define DEFAULT_FORMAT "%-16.14lg"

/* --- making and freeing
 * ------------------------------------------------------------ */

static void note(void *ud, const char *text)
{
    ix__remark(ud, "%s", text);
}

static ix_states initial_states(void)
{
    return (ix_states){
        .bsp_prod_method = 2,
        .dump_level = 23,
        .prim_rat_srfs = true,
        .cmp_eps = 1e-14,
        .float_format = DEFAULT_FORMAT,
        .random = 1,
        .time_start = (double)clock() / CLOCKS_PER_SEC,
    };
}

static ix_status set_up(ix_interp *in)
{
    IX_TRY(ix__paths_init(in));
    IX_TRY(ix__predefine(in));
    in->viewed = ix__obj_list(in->ctx);
    return in->viewed ? IX_OK : IX_ENOMEM;
}

ix_status ix__interp_new(ix_ctx *ctx, const ix_interp_opts *o, ix_interp **out)
{
    ix_interp *in = ix__alloc(ctx, sizeof *in);
    ix_status st;

    *out = NULL;
    if (!in)
        return IX_ENOMEM;
    *in = (ix_interp){.ctx = ctx, .opt = *o, .states = initial_states()};
    ix__buf_init(&in->text, ctx);
    if (in->opt.max_calls <= 0)
        in->opt.max_calls = DEFAULT_CALLS;
    st = set_up(in);
    if (st != IX_OK) {
        ix__interp_free(in);
        return st;
    }
    ix_ctx_set_note(ctx, note, in);
    *out = in;
    return IX_OK;
}

void ix__interp_free(ix_interp *in)
{
    ix_ctx *ctx;

    if (!in)
        return;
    ctx = in->ctx;
    ix_ctx_set_note(ctx, NULL, NULL);
    if (in->out)
        (void)fclose(in->out);
    if (in->log)
        (void)fclose(in->log);
    ix__stack_pop(in, in->top);
    ix__unit_unref(in->place.unit);
    ix__unit_unref(in->spare);
    ix__syms_free(in);
    ix__obj_unref(ctx, in->viewed);
    ix__attr_free_all(ctx, &in->states.other);
    ix__kept_free_all(ctx, &in->states.kept);
    ix__buf_free(&in->text);
    ix__free(ctx, in->stack, in->cap_stack * sizeof(*in->stack));
    ix__free(ctx, in->frame, in->cap_frames * sizeof(*in->frame));
    ix__strfree(ctx, in->log_name);
    ix__strfree(ctx, in->root);
    ix__strfree(ctx, in->script_dir);
    ix__free(ctx, in, sizeof *in);
}

/* --- running
 * ------------------------------------------------------------------------ */

/* --check runs only what later statements need to be understood. */
static ix_status check_run(ix_interp *in, ix__node *n)
{
    const char *name = n->kind == N_CALL ? n->u.bi->row->name : "";

    if (n->kind == N_FUNDEF)
        return ix__exec(in, n);
    if (strcmp(name, "INCLUDE") == 0 && n->kid[0]->kind == N_STR)
        return ix__exec(in, n);
    if (strcmp(name, "FREE") == 0 && n->kid[0]->kind == N_GLOBAL)
        n->kid[0]->u.sym->declared = 0;
    return IX_OK;
}

static ix_status one_statement(ix_interp *in, ix__reader *rd, ix__unit *u,
                               bool dynamic, bool *end)
{
    ix__node *n;

    IX_TRY(ix__parse(in, rd, u, dynamic, &n, end));
    if (!n)
        return IX_OK;
    in->unit = u;
    return in->opt.check_only ? check_run(in, n) : ix__exec(in, n);
}

static ix_status run_statement(ix_interp *in, ix__reader *rd, bool dynamic,
                               bool *end)
{
    ix__unit *u = in->spare ? in->spare : ix__unit_new(in->ctx);
    ix__unit *outer = in->unit;
    ix__pos here = in->here;
    ix_status st;

    in->spare = NULL;
    if (!u)
        return IX_ENOMEM;
    if (!in->nframes)
        ix__progress(in->ctx, NULL, -1);
    st = one_statement(in, rd, u, dynamic, end);
    in->unit = outer;
    in->here = here;
    if (u->refs == 1 && !in->spare) {
        ix__unit_clear(u);
        in->spare = u;
    } else {
        ix__unit_unref(u);
    }
    return st;
}

static void drop_line(ix__reader *rd)
{
    rd->pos = rd->line.len;
}

/* All statements; the status of the first hard error. */
static ix_status run_reader(ix_interp *in, ix__reader *rd)
{
    ix_status first = IX_OK;
    bool end = false;

    while (!end) {
        ix_status st = run_statement(in, rd, false, &end);

        if (st == IX_OK)
            continue;
        if (first == IX_OK && !in->exiting)
            first = st;
        if (in->exiting || st == IX_ECANCEL || in->opt.strict)
            drop_line(rd);
        if (!in->exiting)
            ix__report(in, false);
        if (in->exiting)
            rd->prompting = false;
        if (in->exiting || st == IX_ECANCEL || !in->opt.check_only)
            ix__reader_close(rd);
    }
    return first;
}

static ix_status run(ix_interp *in, ix__reader *rd)
{
    ix__reader *outer = in->rd;
    uintptr_t base = in->stack_base;
    ix_status st;

    if (!base)
        in->stack_base = (uintptr_t)__builtin_frame_address(0);
    in->rd = rd;
    st = run_reader(in, rd);
    in->rd = outer;
    in->stack_base = base;
    return st;
}

ix_status ix__interp_run_text(ix_interp *in, const char *name, const char *text,
                              size_t n)
{
    const char *kept = ix__intern_file(in, name);
    ix__reader rd;
    ix_status st;

    if (!kept)
        return IX_ENOMEM;
    if (in->exiting)
        return IX_OK;
    ix__reader_init(&rd, in);
    rd.add_semicolon = true;
    ix__reader_push_text(&rd, kept, text, n);
    st = run(in, &rd);
    ix__reader_free(&rd);
    return st;
}

/* Pushes the script at path; shown as name. Err IX_EARG it is being read. */
static ix_status push_script(ix_interp *in, ix__reader *rd, const char *path)
{
    const char *kept = ix__intern_file(in, path);
    struct stat s;
    ix_buf data;

    if (!kept)
        return IX_ENOMEM;
    if (stat(path, &s) != 0)
        return IX_FAIL(in->ctx, IX_EIO, "cannot open %s: %s", path,
                       strerror(errno));
    for (int i = 0; i < rd->n; i++)
        if (rd->src[i].ino == s.st_ino && rd->src[i].dev == s.st_dev &&
            rd->src[i].ino)
            return IX_FAIL(in->ctx, IX_EARG,
                           "%s is being read already: it would include itself",
                           path);
    if (rd->n > IX_MAX_INCLUDE)
        return IX_FAIL(in->ctx, IX_EARG,
                       "scripts are included more than %d deep",
                       IX_MAX_INCLUDE);
    ix__buf_init(&data, in->ctx);
    IX_TRY(ix__file_read(in->ctx, path, &data));
    ix__reader_push_file(rd, kept, &data, s.st_dev, s.st_ino);
    return IX_OK;
}

/* The script of the command line, ".irt" added if there is no such file. */
static ix_status push_main(ix_interp *in, ix__reader *rd, const char *name)
{
    char path[IX_PATH];
    struct stat s;

    if (strcmp(name, "-") == 0) {
        ix__reader_push_text(rd, "<stdin>", NULL, 0);
        rd->prompting = in->opt.read_line != NULL;
        return IX_OK;
    }
    if (snprintf(path, sizeof path, "%s%s", name,
                 stat(name, &s) == 0 ? "" : ".irt") >= (int)sizeof path ||
        stat(path, &s) != 0)
        return IX_FAIL(in->ctx, IX_EIO, "cannot open %s: %s", name,
                       strerror(errno));
    IX_TRY(ix__paths_script(in, path));
    return push_script(in, rd, path);
}

ix_status ix__interp_run_file(ix_interp *in, const char *name)
{
    ix__reader rd;
    ix_status st;

    if (in->exiting)
        return IX_OK;
    ix__reader_init(&rd, in);
    st = push_main(in, &rd, name);
    if (st == IX_OK)
        st = run(in, &rd);
    else
        ix__report(in, false);
    ix__reader_free(&rd);
    return st;
}

ix_status ix__exec_text(ix_interp *in, const char *text)
{
    static const ix__fn exec = {.name = "EXEC"}; /* for traces and limits */
    ix__reader rd;
    bool end = false;
    ix_status st;

    IX_TRY(ix__frame_push(in, &exec, in->top, in->here));
    ix__reader_init(&rd, in);
    rd.add_semicolon = true;
    ix__reader_push_text(&rd, "<exec>", text, strlen(text));
    do
        st = run_statement(in, &rd, true, &end);
    while (st == IX_OK && !end);
    ix__reader_free(&rd);
    in->nframes--;
    return st;
}

ix_status ix__queue_file(ix_interp *in, const char *name)
{
    char path[IX_PATH];
    ix__reader *rd = in->rd;
    const char *from = in->unit && in->here.line < in->unit->nlines
                           ? in->unit->line[in->here.line].file
                           : "";
    ix_status st;

    if (!rd)
        return IX_FAIL(in->ctx, IX_EARG, "no script is being read");
    if (in->out)
        (void)fflush(in->out); /* it may have been printed just now */
    st = ix__path_include(in, name, from, path);
    if (st == IX_OK)
        st = push_script(in, rd, path);
    if (st != IX_EIO || in->opt.strict)
        return st;
    ix__at(in, in->unit, in->here);
    ix__report(in, true);
    return IX_OK;
}

/* --- services
 * ----------------------------------------------------------------------------
 */

int ix__interp_errors(const ix_interp *in)
{
    return in->nerrors;
}

const ix_obj *ix__interp_viewed(const ix_interp *in)
{
    return in->viewed;
}

ix_ctx *ix__interp_ctx(ix_interp *in)
{
    return in->ctx;
}

ix_states *ix__states(ix_interp *in)
{
    return &in->states;
}

ix_status ix__view(ix_interp *in, ix_obj *o)
{
    ix_obj *item = o ? ix__obj_copy(in->ctx, o) : ix__obj_list(in->ctx);

    if (!item)
        return IX_ENOMEM;
    if (o)
        return ix__list_add(in->ctx, in->viewed, item);
    ix__obj_unref(in->ctx, in->viewed);
    in->viewed = item;
    return IX_OK;
}

ix_status ix__exit(ix_interp *in)
{
    in->exiting = true;
    return IX_FAIL(in->ctx, IX_ECANCEL, "exit");
}

static ix_status close_file(ix_interp *in, FILE **f)
{
    FILE *old = *f;

    *f = NULL;
    if (old && fclose(old) != 0)
        return IX_FAIL(in->ctx, IX_EIO, "cannot write the file: %s",
                       strerror(errno));
    return IX_OK;
}

ix_status ix__out_redirect(ix_interp *in, const char *file)
{
    IX_TRY(close_file(in, &in->out));
    if (!file || !*file)
        return IX_OK;
    IX_TRY(ix__path_check(in, file, true));
    in->out = fopen(file, "w");
    if (!in->out)
        return IX_FAIL(in->ctx, IX_EIO, "cannot write %s: %s", file,
                       strerror(errno));
    return IX_OK;
}

static ix_status open_log(ix_interp *in)
{
    const char *name = in->log_name ? in->log_name : "iritx.log";

    IX_TRY(ix__path_check(in, name, true));
    in->log = fopen(name, "w");
    if (!in->log)
        return IX_FAIL(in->ctx, IX_EIO, "cannot write %s: %s", name,
                       strerror(errno));
    return IX_OK;
}

ix_status ix__log(ix_interp *in, const char *file, bool on)
{
    if (file) {
        char *name = ix__strdup(in->ctx, file);

        if (!name)
            return IX_ENOMEM;
        ix__strfree(in->ctx, in->log_name);
        in->log_name = name;
        IX_TRY(close_file(in, &in->log));
    }
    in->log_on = on;
    return on && !in->log ? open_log(in) : IX_OK;
}

bool ix__in_line(ix_interp *in, ix_buf *b)
{
    int c;

    ix__flush(in);
    while ((c = getc(stdin)) != EOF && c != '\n')
        ix__buf_putc(b, (char)c);
    return c == '\n' || b->len > 0;
}
