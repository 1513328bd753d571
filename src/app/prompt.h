/* prompt.h - a session with a person. */
#ifndef APP_PROMPT_H
#define APP_PROMPT_H

#include "app/editor.h"
#include "lang/interp.h"

typedef struct {
    ix_interp *in;
    volatile int *cancel; /* the number of the signal that came, or 0 */
    bool begun, edits, hinted;
    editor editor;
} prompt;

/* True if standard input and output are terminals. */
bool prompt_wanted(void);

/* read_line and show_value of ix_interp_opts; ud is a prompt. */

/* Asks for a line and appends it to b, without its newline; more: the
 * statement goes on. Ctrl-C during the last computation or at the prompt clears
 * the flag; other signals end the input. "help NAME" and "?NAME" are answered
 * here. */
bool prompt_line(void *ud, bool more, ix_buf *b);
/* Few lines for a value; false: the full text is short enough. */
bool prompt_show(void *ud, const ix_obj *o, ix_buf *b);

void prompt_end(prompt *p);

#endif
