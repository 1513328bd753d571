/* lexer.c - tokens of one statement.
 *
 * Characters come from the reader's present line; when it is used up the next
 * one follows without a separator. Every line that a token stands on is kept
 * in the unit, so that messages can show it. */
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "lang/interp_impl.h"
#include "lang/reader_impl.h"

typedef struct {
    ix__reader *rd;
    ix__unit *u;
    ix_status st; /* of reading a line */
    bool quoted;  /* inside a string */
    bool comment; /* inside a COMMENT block */
} lexer;

/* --- characters ------------------------------------------------------------
 */

static ix__pos here(const lexer *lx)
{
    return (ix__pos){lx->u->nlines ? lx->u->nlines - 1 : 0,
                     (unsigned)lx->rd->pos + 1};
}

static ix_status fail(lexer *lx, ix__pos pos, const char *text)
{
    if (lx->st != IX_OK)
        return lx->st;
    (void)IX_FAIL(lx->rd->in->ctx, IX_EPARSE, "%s", text);
    lx->st = IX_AT(lx->rd->in, lx->u, pos, IX_EPARSE);
    return lx->st;
}

/* The present line was cut short by a byte that is no printable character. In
 * a comment nobody minds; elsewhere the rest is ignored with a warning; a
 * string would lose its end. */
static void cut_short(lexer *lx)
{
    char text[120];
    int c = lx->rd->cut;

    lx->rd->cut = -1;
    if (lx->comment)
        return;
    if (lx->quoted) {
        (void)snprintf(text, sizeof text,
                       "byte 0x%02X is not allowed in a string: use ASCII only",
                       (unsigned)c);
        (void)fail(lx, here(lx), text);
        return;
    }
    (void)snprintf(
        text, sizeof text,
        "the rest of the line is ignored: byte 0x%02X is no printable "
        "character",
        (unsigned)c);
    ix__complain(lx->rd->in, lx->u, here(lx), false, text);
}

/* The next line becomes the present one; false at the end of input. */
static bool next_line(lexer *lx)
{
    ix__reader *rd = lx->rd;
    bool more = false;

    if (rd->cut >= 0)
        cut_short(lx);
    if (lx->st == IX_OK)
        lx->st = ix__reader_line(rd, &more);
    if (lx->st == IX_OK && more)
        lx->st = ix__unit_add_line(lx->u, rd->file, rd->number,
                                   rd->line.data ? rd->line.data : "",
                                   rd->line.len);
    return lx->st == IX_OK && more;
}

/* The next character without consuming it, 0 at the end of input. */
static int peek(lexer *lx)
{
    ix__reader *rd = lx->rd;

    while (rd->pos >= rd->line.len)
        if (!next_line(lx))
            return 0;
    return (unsigned char)rd->line.data[rd->pos];
}

/* Blanks and "#" comments. */
static int skip_blanks(lexer *lx)
{
    int c;

    while ((c = peek(lx)) == ' ' || c == '#') {
        lx->rd->pos++;
        if (c == '#') {
            lx->rd->pos = lx->rd->line.len;
            lx->rd->cut = -1;
        }
    }
    return c;
}

/* COMMENT c ... c, the word being read already. */
static ix_status skip_comment(lexer *lx, ix__pos start)
{
    int c, end;

    lx->comment = true;
    while ((end = peek(lx)) == ' ')
        lx->rd->pos++;
    if (!end)
        return fail(lx, start, "COMMENT without a delimiter character");
    lx->rd->pos++;
    while ((c = peek(lx)) != end) {
        if (!c)
            return fail(lx, start,
                        "COMMENT block is never closed (the input ends)");
        lx->rd->pos++;
    }
    lx->rd->pos++;
    lx->comment = false;
    return IX_OK;
}

/* --- tokens -----------------------------------------------------------------
 */

/* Takes character c into a token of at most max characters. */
static ix_status keep(lexer *lx, ix_buf *b, int c, size_t max, ix__pos pos)
{
    char text[80];

    ix__buf_putc(b, (char)c);
    lx->rd->pos++;
    if (b->len <= max)
        return IX_OK;
    (void)snprintf(text, sizeof text, "this %s is longer than %zu characters",
                   lx->quoted ? "string" : "name or number", max);
    return fail(lx, pos, text);
}

static ix_status read_number(lexer *lx, ix_buf *b, ix__token *t)
{
    int c, last = 0;
    const char *end;

    while (c = peek(lx), isdigit(c) || c == '.' || c == 'e' || c == 'E' ||
                             (c == '-' && (last == 'e' || last == 'E'))) {
        IX_TRY(keep(lx, b, c, IX_MAX_NAME, t->pos));
        last = c;
    }
    IX_TRY(lx->st);
    IX_TRY(ix__buf_check(b));
    end = ix_num_parse(b->data, b->data + b->len, &t->num);
    /* "1.5E" is 1.5: the sign after E may only be a minus. */
    if (!end || (*end && (toupper((unsigned char)*end) != 'E' || end[1])))
        return fail(lx, t->pos, "malformed number");
    if (t->num > 1.7976931348623157e308)
        return fail(lx, t->pos, "number is too large for a double");
    t->kind = T_NUMBER;
    return IX_OK;
}

static ix_status read_name(lexer *lx, ix_buf *b, ix__token *t)
{
    int c;

    while (c = peek(lx), isalnum(c) || c == '_')
        IX_TRY(keep(lx, b, toupper(c), IX_MAX_NAME, t->pos));
    IX_TRY(lx->st);
    IX_TRY(ix__buf_check(b));
    t->kind = T_NAME;
    return IX_OK;
}

static ix_status read_string(lexer *lx, ix_buf *b, ix__token *t)
{
    int c;

    lx->rd->pos++;
    lx->quoted = true;
    while ((c = peek(lx)) != '"') {
        if (c == '\\') {
            lx->rd->pos++;
            c = peek(lx);
        }
        if (!c)
            return fail(lx, t->pos, "string is never closed (the input ends)");
        IX_TRY(keep(lx, b, c, IX_MAX_STRING, t->pos));
    }
    lx->rd->pos++;
    lx->quoted = false;
    t->kind = T_STRING;
    return ix__buf_check(b);
}

/* One- and two-character tokens; second 0: only the single form. */
static const struct {
    char first, second;
    ix__tok_kind kind;
    ix__op op;
} symbols[] = {
    {'(', 0, T_LPAREN, 0},    {')', 0, T_RPAREN, 0},
    {',', 0, T_COMMA, 0},     {':', 0, T_COLON, 0},
    {';', 0, T_SEMICOLON, 0}, {'+', 0, T_OP, OP_ADD},
    {'-', 0, T_OP, OP_SUB},   {'*', 0, T_OP, OP_MUL},
    {'/', 0, T_OP, OP_DIV},   {'^', 0, T_OP, OP_POW},
    {'=', '=', T_OP, OP_EQ},  {'=', 0, T_OP, OP_ASSIGN},
    {'!', '=', T_OP, OP_NE},  {'!', 0, T_OP, OP_NOT},
    {'<', '=', T_OP, OP_LE},  {'<', 0, T_OP, OP_LT},
    {'>', '=', T_OP, OP_GE},  {'>', 0, T_OP, OP_GT},
    {'&', '&', T_OP, OP_AND}, {'|', '|', T_OP, OP_OR},
};

static ix_status bad_character(lexer *lx, ix__pos pos, int c)
{
    char text[64];

    if (c == '&' || c == '|')
        (void)snprintf(text, sizeof text, "a single '%c'; write '%c%c'", c, c,
                       c);
    else
        (void)snprintf(text, sizeof text, "character '%c' has no meaning here",
                       c);
    return fail(lx, pos, text);
}

static ix_status read_symbol(lexer *lx, int c, ix__token *t)
{
    int second;

    lx->rd->pos++;
    /* A doubled character may be broken over lines only where one is
     * possible: a terminator must not read the next line. */
    second = strchr("=!<>&|", c) ? peek(lx) : 0;
    IX_TRY(lx->st);
    for (size_t i = 0; i < sizeof symbols / sizeof *symbols; i++) {
        if (symbols[i].first != c ||
            (symbols[i].second && symbols[i].second != second))
            continue;
        lx->rd->pos += symbols[i].second != 0;
        t->kind = symbols[i].kind;
        t->op = symbols[i].op;
        return IX_OK;
    }
    return bad_character(lx, t->pos, c);
}

/* Names, numbers and strings, collected in b and then kept in the unit. */
static ix_status read_text(lexer *lx, int c, ix__token *t)
{
    ix_buf *b = &lx->rd->word;

    ix__buf_clear(b);
    if (isalpha(c))
        IX_TRY(read_name(lx, b, t));
    else
        IX_TRY(c == '"' ? read_string(lx, b, t) : read_number(lx, b, t));
    t->len = b->len;
    t->text = ix__unit_text(lx->u, b->data ? b->data : "", b->len);
    return t->text ? IX_OK : IX_ENOMEM;
}

static ix_status lex(lexer *lx, ix__token *t)
{
    int c;

    for (;;) {
        *t = (ix__token){.kind = T_END, .pos = here(lx)};
        c = skip_blanks(lx);
        IX_TRY(lx->st);
        if (!c)
            return IX_OK; /* the end is where the last token ended */
        t->pos = here(lx);
        if (!isalpha(c) && c != '"' && !isdigit(c) && c != '.')
            return read_symbol(lx, c, t);
        IX_TRY(read_text(lx, c, t));
        if (t->kind != T_NAME || strcmp(t->text, "COMMENT") != 0)
            return IX_OK;
        IX_TRY(skip_comment(lx, t->pos));
    }
}

ix_status ix__lex(ix__reader *rd, ix__unit *u, ix__token *t)
{
    lexer lx = {.rd = rd, .u = u};

    return lex(&lx, t);
}

ix_status ix__lex_begin(ix__reader *rd, ix__unit *u)
{
    if (!ix__reader_line_left(rd) && rd->cut < 0)
        return IX_OK;
    return ix__unit_add_line(u, rd->file, rd->number,
                             rd->line.data ? rd->line.data : "", rd->line.len);
}

void ix__lex_skip(ix__reader *rd)
{
    bool quoted = false;

    for (; rd->pos < rd->line.len; rd->pos++) {
        char c = rd->line.data[rd->pos];

        if (c == '\\')
            rd->pos++;
        else if (c == '"')
            quoted = !quoted;
        else if (c == ';' && !quoted)
            break;
    }
    rd->pos += rd->pos < rd->line.len;
}
