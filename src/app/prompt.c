/* prompt.c - lines typed by a person.
 *
 * The terminal edits the line. Ctrl-C at the prompt gives up the line, and the
 * statement that it would continue. */
#define _POSIX_C_SOURCE 200809L
#include "app/prompt.h"

#include <errno.h>
#include <stdio.h>
#include <unistd.h>

bool prompt_wanted(void)
{
    return isatty(STDIN_FILENO) && isatty(STDOUT_FILENO);
}

static void ask(bool more)
{
    (void)fputs(more ? "  ...> " : "iritx> ", stdout);
    (void)fflush(stdout);
}

bool prompt_line(void *ud, bool more, ix_buf *b)
{
    volatile int *cancel = ud;
    int c;

    *cancel = 0;
    ask(more);
    for (;;) {
        c = getc(stdin);
        if (c == EOF && *cancel && errno == EINTR) {
            clearerr(stdin);
            ix__buf_clear(b);
            (void)putc('\n', stdout);
            if (more)
                return true; /* the flag gives up the statement */
            *cancel = 0;
            ask(false);
        } else if (c == EOF || c == '\n') {
            break;
        } else {
            ix__buf_putc(b, (char)c);
        }
    }
    if (c == EOF)
        (void)putc('\n', stdout);
    return c == '\n';
}
