/* prompt.h - lines typed by a person. */
#ifndef APP_PROMPT_H
#define APP_PROMPT_H

#include "base/buf.h"

/* True if standard input and output are terminals. */
bool prompt_wanted(void);
/* Asks for a line and appends it to b, without its newline; more: the
 * statement goes on. ud is the cancel flag (volatile int *): Ctrl-C during the
 * last computation or at the prompt clears it. False at the end of input. */
bool prompt_line(void *ud, bool more, ix_buf *b);

#endif
