/* prompt.c - a session with a person.
 *
 * Lines come from the editor or, without one, as the terminal edits them.
 * Ctrl-C at the prompt gives up the line, and the statement that it would
 * continue. */
#define _POSIX_C_SOURCE 200809L
#include "app/prompt.h"

#include <ctype.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "app/complete.h"
#include "app/keyboard.h"
#include "app/listing.h"
#include "app/progress.h"
#include "app/summary.h"
#include "lang/types_impl.h"

bool prompt_wanted(void)
{
    return isatty(STDIN_FILENO) && isatty(STDOUT_FILENO);
}

/* --- help -------------------------------------------------------------- */

enum { SIMILAR = 60, LONGEST = 80 };

static void help_session(void)
{
    (void)printf("Statements end with ; and may take several lines.\n"
                 "  help NAME, ?NAME  about a function, constant, variable\n"
                 "  Tab               completes a name, or lists what fits\n"
                 "  Up, Ctrl-R        earlier statements\n"
                 "  Ctrl-C            ends a computation or a statement\n"
                 "  Ctrl-D, exit      leaves\n"
                 "Large values are summarised; printf(\"%%Dg\\\\n\", list(a)); "
                 "shows all of a.\n"
                 "iritx --list-functions lists all functions.\n");
}

/* In lines of a screen. */
static void put_name(const char *name, bool first)
{
    static size_t column;
    const size_t width = 78;

    if (first)
        (void)printf(" These contain it:");
    if (first || column + 1 + strlen(name) > width) {
        (void)printf("\n ");
        column = 1;
    }
    (void)printf(" %s", name);
    column += 1 + strlen(name);
}

static void help_similar(prompt *p, const char *name)
{
    const char *found[SIMILAR];
    size_t n = complete_names(p->in, name, strlen(name), true, found, SIMILAR);

    (void)printf("Nothing is called %s.", name);
    for (size_t i = 0; i < n; i++)
        put_name(found[i], i == 0);
    (void)putchar('\n');
}

static bool help_variable(prompt *p, const char *name)
{
    const ix_obj *o = ix__var_find(p->in, name);
    ix_buf b;

    if (!o)
        return false;
    ix__buf_init(&b, ix__interp_ctx(p->in));
    if (summary_add(&b, o, 0) == IX_OK && ix__buf_check(&b) == IX_OK)
        (void)fputs(b.data, stdout);
    ix__buf_free(&b);
    return true;
}

static bool help_constant(const char *name)
{
    const char *found;
    double v;

    for (size_t i = 0; (found = ix__constant_at(i, &v)); i++) {
        if (strcasecmp(found, name) == 0) {
            (void)printf("%s is a constant: %.15g\n", found, v);
            return true;
        }
    }
    return false;
}

static bool help_function(prompt *p, const char *name)
{
    const char *found;

    for (size_t i = 0; (found = ix__fn_at(p->in, i)); i++) {
        if (strcasecmp(found, name) == 0) {
            (void)printf("%s is a function of this session.\n", found);
            return true;
        }
    }
    return listing_help(name);
}

static void help(prompt *p, const char *name)
{
    if (!*name)
        help_session();
    else if (!help_function(p, name) && !help_constant(name) &&
             !help_variable(p, name))
        help_similar(p, name);
}

/* "help NAME" and "?NAME", with or without a ; or (). False: a statement. */
static bool asks_for_help(const char *line, char name[LONGEST])
{
    size_t n = 0;

    line += strspn(line, " \t");
    if (*line == '?')
        line++;
    else if (strncasecmp(line, "help", 4) == 0 && strchr(" \t;", line[4]))
        line += 4;
    else
        return false;
    line += strspn(line, " \t");
    while (n + 1 < LONGEST && (isalnum((unsigned char)*line) || *line == '_'))
        name[n++] = *line++;
    name[n] = '\0';
    return line[strspn(line, " \t;()")] == '\0';
}

/* --- lines ------------------------------------------------------------- */

static const char *question(bool more)
{
    return more ? "  ...> " : "iritx> ";
}

/* A line as the terminal edits it. */
static editor_result plain_line(const prompt *p, bool more, ix_buf *b)
{
    int c = EOF;

    (void)fputs(question(more), stdout);
    (void)fflush(stdout);
    while (!*p->cancel && !keyboard_wait(p->cancel))
        continue; /* a signal that does not matter here */
    while (!*p->cancel && (c = getc(stdin)) != EOF && c != '\n')
        ix__buf_putc(b, (char)c);
    if (c == '\n')
        return EDITOR_LINE;
    clearerr(stdin);
    (void)putchar('\n');
    return *p->cancel ? EDITOR_INTERRUPTED : EDITOR_END;
}

static size_t names(void *ud, const char *word, size_t n, const char **out,
                    size_t max)
{
    const prompt *p = ud;

    return complete_names(p->in, word, n, false, out, max);
}

static void begin(prompt *p)
{
    p->begun = true;
    p->edits = editor_open(&p->editor, p->cancel, names, p);
    (void)printf("iritx %s; help tells more, Ctrl-D leaves\n", ix_version());
}

/* "exit" or "quit" alone, without the marks of a statement. */
static bool asks_to_leave(const char *line)
{
    line += strspn(line, " \t");
    if (strncasecmp(line, "exit", 4) != 0 && strncasecmp(line, "quit", 4) != 0)
        return false;
    return line[4 + strspn(line + 4, " \t;")] == '\0';
}

/* A line that the interpreter shall see; Ctrl-C starts a new one. */
static editor_result statement_line(prompt *p, bool more, ix_buf *b)
{
    for (;;) {
        char topic[LONGEST];
        editor_result r;

        ix__buf_clear(b);
        r = p->edits ? editor_read(&p->editor, question(more), b)
                     : plain_line(p, more, b);
        if (r == EDITOR_INTERRUPTED && *p->cancel == SIGINT && !more) {
            *p->cancel = 0;
            continue;
        }
        if (r != EDITOR_LINE || b->len == 0)
            return r;
        if (p->edits)
            editor_remember(&p->editor, b->data, more);
        if (!more && asks_to_leave(b->data))
            return EDITOR_END;
        if (more || !asks_for_help(b->data, topic))
            return r;
        help(p, topic);
    }
}

bool prompt_line(void *ud, bool more, ix_buf *b)
{
    prompt *p = ud;
    editor_result r;

    if (!p->begun)
        begin(p);
    if (*p->cancel == SIGINT)
        *p->cancel = 0;
    if (*p->cancel)
        return false;
    r = statement_line(p, more, b);
    if (r == EDITOR_INTERRUPTED) {
        ix__buf_clear(b);
        return *p->cancel == SIGINT; /* the flag gives up the statement */
    }
    progress_begin();
    return r == EDITOR_LINE;
}

/* --- values ------------------------------------------------------------ */

bool prompt_show(void *ud, const ix_obj *o, ix_buf *b)
{
    prompt *p = ud;
    bool large = summary_is_large(o);

    if (!large && (ix__seq_count(o) > 0 || o->type == IX_OBJ_POLY))
        return false;
    if (summary_add_short(b, o) != IX_OK) {
        ix__buf_clear(b);
        return false;
    }
    if (large && !p->hinted && o->type != IX_OBJ_LIST) {
        ix__buf_puts(b, "(in full: printf(\"%Dg\\\\n\", list(a));)\n");
        p->hinted = true;
    }
    return true;
}

void prompt_end(prompt *p)
{
    if (p->edits)
        editor_close(&p->editor);
}
