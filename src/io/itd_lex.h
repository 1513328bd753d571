/* itd_lex.h - tokens of the text format, with places for messages.
 *
 * A token is a bracket, a quoted text or a word; brackets need no blanks
 * around them. Its characters stand in the window over the text, until the next
 * call that reads. */
#ifndef IO_ITD_LEX_H
#define IO_ITD_LEX_H

#include "io/text.h"

typedef enum { IX_T_END, IX_T_OPEN, IX_T_CLOSE, IX_T_WORD, IX_T_QUOTED } ix__tk;

typedef struct {
    ix__tk kind;
    size_t at;       /* where it begins in the text, for messages */
    const char *s;   /* the first character; of QUOTED behind the quote */
    const char *end; /* behind the last; of QUOTED at the quote or line end */
} ix__token;

typedef struct {
    ix_ctx *ctx;
    ix__text t;
    int depth; /* of objects */
    bool peer; /* a message of IRIT, where an object without a body is an empty
                  list */
} ix__lex;

/* src stays the caller's. l is to be freed whatever this returns. */
ix_status ix__lex_init(ix__lex *l, ix__input *src) IX_MUST_CHECK;
void ix__lex_free(ix__lex *l);

/* IX_EPARSE with "name:line:col: error: " and the text. */
ix_status ix__lex_fail(ix__lex *l, size_t at, const char *fmt, ...)
    IX_PRINTF(3, 4);
/* A note, "name:line:col: warning: " and the text; the first 20 of a file. */
void ix__lex_warn(ix__lex *l, size_t at, const char *fmt, ...) IX_PRINTF(3, 4);
size_t ix__lex_at(const ix__lex *l); /* the next character */
/* "<wanted> expected, found ..."; at the end of the text: which bracket is
 * open. */
ix_status ix__lex_unexpected(ix__lex *l, const ix__token *t,
                             const char *wanted);

/* Err IX_EPARSE a control byte, or (unless in free text) bad UTF-8. */
ix_status ix__lex_next(ix__lex *l, ix__token *t) IX_MUST_CHECK;
/* The same without moving on. */
ix_status ix__lex_peek(ix__lex *l, ix__token *t) IX_MUST_CHECK;
/* Words between objects are skipped; bytes above 127 may be anything there. */
ix_status ix__lex_skip_junk(ix__lex *l, ix__token *t) IX_MUST_CHECK;

bool ix__token_is(const ix__token *t, const char *keyword); /* any case */
/* The text of a word or of a quoted token (backslashes undone), in scratch. */
ix_status ix__token_text(ix__lex *l, const ix__token *t, char **s,
                         size_t *n) IX_MUST_CHECK;

ix_status ix__lex_open(ix__lex *l) IX_MUST_CHECK;
ix_status ix__lex_close(ix__lex *l, const char *wanted) IX_MUST_CHECK;
bool ix__lex_blank(char c); /* blank, tab, LF or CR */
/* A finite number; wanted is for the message. */
ix_status ix__lex_num(ix__lex *l, const char *wanted, double *v) IX_MUST_CHECK;
ix_status ix__lex_nums(ix__lex *l, const char *wanted, int n,
                       double *v) IX_MUST_CHECK;
/* An integer within [lo, hi]; what: "the order". */
ix_status ix__lex_int(ix__lex *l, const char *what, int lo, int hi,
                      int *v) IX_MUST_CHECK;
/* Fails if n items of at least the given number of bytes cannot follow; some
 * thousands are always let through, so that memory stays bounded and the end
 * of a short file is reported as such. */
ix_status ix__lex_room(ix__lex *l, size_t at, double n, int item_bytes,
                       const char *items) IX_MUST_CHECK;

#endif
