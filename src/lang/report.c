/* report.c - messages on standard error, script output on standard output.
 *
 * A message names file:line:col, shows the source line with a caret and, in
 * functions, how they were reached. Output is flushed first, so that both
 * streams stay in order. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <string.h>

#include "lang/interp_impl.h"

#define MAX_SHOWN 20
#define WINDOW    100 /* characters of a source line that are shown */

/* --- script output
 * ---------------------------------------------------------------- */

void ix__out(ix_interp *in, const char *s, size_t n)
{
    FILE *f = in->out ? in->out : stdout;

    if (!in->out)
        ix__progress_clear(in->ctx);
    if (!in->out && n)
        in->mid_line = s[n - 1] != '\n';
    if (n && fwrite(s, 1, n, f) != n)
        in->out_errno = errno;
    if (in->log && in->log_on && !in->out)
        (void)fwrite(s, 1, n, in->log);
}

void ix__flush(ix_interp *in)
{
    ix__progress_clear(in->ctx);
    if (fflush(stdout) != 0)
        in->out_errno = errno;
}

/* --- places
 * ------------------------------------------------------------------------- */

static void trace(ix_interp *in, ix__place *p)
{
    p->ntrace = 0;
    for (int f = in->nframes - 1; f >= 0 && p->ntrace < IX_TRACE; f--) {
        const ix__frame *fr = &in->frame[f];
        const ix__unit *u = fr->caller;

        if (fr->call.line >= u->nlines)
            continue;
        p->trace[p->ntrace].fn = fr->fn->name;
        p->trace[p->ntrace].file = u->line[fr->call.line].file;
        p->trace[p->ntrace++].line = u->line[fr->call.line].number;
    }
    p->nmore = in->nframes - p->ntrace;
}

void ix__at(ix_interp *in, ix__unit *u, ix__pos pos)
{
    ix__place *p = &in->place;

    if (!p->set) {
        p->set = true;
        p->unit = u && pos.line < u->nlines ? ix__unit_ref(u) : NULL;
        p->pos = pos;
        trace(in, p);
    }
}

static void forget(ix_interp *in)
{
    ix__unit_unref(in->place.unit);
    in->place = (ix__place){.unit = NULL};
    in->soft = false;
    in->soft_node = NULL;
}

/* --- printing
 * ------------------------------------------------------------------------- */

static FILE *errors_to(const ix_interp *in)
{
    return in->err ? in->err : stderr;
}

/* The source line around the column, and a caret under it. */
static void show_line(FILE *f, const char *text, unsigned col)
{
    size_t n = strlen(text), start = 0, at = col ? col - 1 : 0;

    if (n > WINDOW) {
        start = at > WINDOW / 2 ? at - WINDOW / 2 : 0;
        start = start > n - WINDOW ? n - WINDOW : start;
        n = WINDOW;
    }
    (void)fprintf(f, "  %.*s\n  %*s^\n", (int)n, text + start,
                  (int)(at - start), "");
}

typedef enum { HARD, SOFT, REMARK } kind;

static void show_message(FILE *f, const ix__unit *u, ix__pos pos, kind k,
                         const char *text)
{
    const char *word = k == REMARK ? "warning" : "error";
    const char *tail = k == SOFT ? " (the script goes on)" : "";

    if (!u || pos.line >= u->nlines) {
        (void)fprintf(f, "iritx: %s: %s%s\n", word, text, tail);
        return;
    }
    (void)fprintf(f, "%s:%d:%u: %s: %s%s\n", u->line[pos.line].file,
                  u->line[pos.line].number, pos.col, word, text, tail);
    show_line(f, u->line[pos.line].text, pos.col);
}

static void show_trace(FILE *f, const ix__place *p)
{
    for (int i = 0; i < p->ntrace; i++)
        (void)fprintf(f, "  in %s, called from %s:%d\n", p->trace[i].fn,
                      p->trace[i].file, p->trace[i].line);
    if (p->nmore > 0)
        (void)fprintf(f, "  and %d more calls\n", p->nmore);
}

/* True while messages are still shown; the last one says so. */
static bool count(ix_interp *in)
{
    in->nerrors++;
    if (in->nshown == MAX_SHOWN)
        (void)fprintf(errors_to(in),
                      "iritx: more than %d errors; further ones are "
                      "counted, not shown\n",
                      MAX_SHOWN);
    return in->nshown++ < MAX_SHOWN;
}

void ix__report(ix_interp *in, bool soft)
{
    const ix__place *p = &in->place;

    ix__flush(in);
    if (in->out_errno == EPIPE) /* the reader has left: no news to it */
        in->nerrors++;
    else if (count(in)) {
        show_message(errors_to(in), p->unit, p->pos, soft ? SOFT : HARD,
                     ix_ctx_message(in->ctx));
        show_trace(errors_to(in), p);
    }
    forget(in);
}

void ix__complain(ix_interp *in, ix__unit *u, ix__pos pos, bool counts,
                  const char *text)
{
    ix__flush(in);
    if (counts ? count(in) : !in->opt.quiet && in->nshown < MAX_SHOWN)
        show_message(errors_to(in), u, pos, counts ? SOFT : REMARK, text);
}

void ix__remark(ix_interp *in, const char *fmt, ...)
{
    char text[512];
    va_list ap;

    va_start(ap, fmt);
    (void)vsnprintf(text, sizeof text, fmt, ap);
    va_end(ap);
    ix__complain(in, in->unit, in->here, false, text);
}
