/* editor.h - a line editor with history and completion: libedit, loaded when
 * the first line is asked for, so that batch runs do not pay for it. */
#ifndef APP_EDITOR_H
#define APP_EDITOR_H

#include "base/buf.h"

typedef enum {
    EDITOR_LINE,        /* a line has been read */
    EDITOR_INTERRUPTED, /* *cancel is set */
    EDITOR_END          /* of the input */
} editor_result;

/* Sorted names that begin with the n characters at word; how many. */
typedef size_t (*editor_complete_fn)(void *ud, const char *word, size_t n,
                                     const char **out, size_t max);

typedef struct {
    const volatile int *cancel; /* looked at when a signal came */
    editor_complete_fn complete;
    void *ud;
    const char *prompt;
    void *line, *history; /* libedit's */
    char file[4096];      /* that keeps the history; "": none */
} editor;

/* Fills e. False: there is no libedit, or the terminal cannot edit. */
bool editor_open(editor *e, const volatile int *cancel,
                 editor_complete_fn complete, void *ud);
/* Appends a line without its newline. */
editor_result editor_read(editor *e, const char *prompt, ix_buf *b);
/* Keeps a line for this session and later ones; more: it continues the one
 * before. */
void editor_remember(editor *e, const char *text, bool more);
/* Puts the terminal right. */
void editor_close(editor *e);

#endif
