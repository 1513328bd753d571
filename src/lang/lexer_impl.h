/* lexer_impl.h - source lines and tokens.
 *
 * A reader is a stack of sources (the script, the files it includes) seen as
 * a sequence of physical lines. Newlines are discarded, so a token may be
 * broken over lines; tabs become blanks. A byte that is no printable ASCII
 * character ends its line: the rest of a comment may be in any encoding, code
 * may not. An included source is read once the present line
 * is used up. */
#ifndef LANG_LEXER_IMPL_H
#define LANG_LEXER_IMPL_H

#include <sys/types.h>

#include "lang/ast_impl.h"

#define IX_MAX_INCLUDE 10
#define IX_MAX_STRING  65536u
#define IX_MAX_NAME    255u

typedef struct {
    const char *name; /* kept by the interpreter */
    const char *text; /* NULL: standard input */
    bool at_end;      /* of standard input */
    size_t n, pos;
    ix_buf data; /* the text, if the source owns it */
    int line;
    dev_t dev; /* of the file; ino 0: no file */
    ino_t ino;
} ix__source;

typedef struct {
    ix_interp *in;
    ix__source src[IX_MAX_INCLUDE + 1];
    int n;
    ix_buf line; /* the present line, tabs expanded */
    ix_buf word; /* of the lexer: the token under way */
    size_t pos;
    int cut; /* the byte that ended the line early; -1: none */
    const char *file;
    int number;
    bool inside;        /* a statement has begun */
    bool prompting;     /* the first source is a person */
    bool add_semicolon; /* a missing last ';' is supplied (-e, EXEC) */
} ix__reader;

void ix__reader_init(ix__reader *rd, ix_interp *in);
void ix__reader_free(ix__reader *rd);
/* Pushes a text (borrowed; NULL: standard input). */
void ix__reader_push_text(ix__reader *rd, const char *name, const char *text,
                          size_t n);
/* Pushes a file that was read into *data (taken over). */
void ix__reader_push_file(ix__reader *rd, const char *name, ix_buf *data,
                          dev_t dev, ino_t ino);
/* Leaves all sources but a person; the rest of the present line stays. */
void ix__reader_close(ix__reader *rd);
/* Something is left on the present line (blanks aside). */
bool ix__reader_line_left(const ix__reader *rd);

typedef enum {
    T_END, /* no more input */
    T_NUMBER,
    T_STRING,
    T_NAME,
    T_LPAREN,
    T_RPAREN,
    T_COMMA,
    T_COLON,
    T_SEMICOLON,
    T_OP /* op */
} ix__tok_kind;

typedef struct {
    ix__tok_kind kind;
    ix__op op; /* T_OP; OP_SUB for every '-' */
    ix__pos pos;
    double num;
    const char *text; /* name in upper case, or string; in the unit */
    size_t len;
} ix__token;

/* The next token of rd. Its text and the lines that it stands on are kept in
 * u. Err IX_EPARSE (place recorded), IX_ENOMEM, IX_ECANCEL. */
ix_status ix__lex(ix__reader *rd, ix__unit *u, ix__token *t) IX_MUST_CHECK;
/* Before a statement: the present line, if anything is left of it, becomes
 * line 0 of u. */
ix_status ix__lex_begin(ix__reader *rd, ix__unit *u) IX_MUST_CHECK;
/* After an error: skips to behind the next ';' of the present line. */
void ix__lex_skip(ix__reader *rd);

#endif
