/* reader.c - physical lines from a stack of sources.
 *
 * The present line is a copy, so it outlives its source: what is left of it
 * runs before an included file, and after an error closed all sources. */
#define _POSIX_C_SOURCE 200809L
#include "lang/reader_impl.h"

#include <stdio.h>
#include <string.h>

#include "lang/interp_impl.h"

void ix__reader_init(ix__reader *rd, ix_interp *in)
{
    *rd = (ix__reader){.in = in, .cut = -1, .file = ""};
    ix__buf_init(&rd->line, in->ctx);
    ix__buf_init(&rd->word, in->ctx);
}

void ix__reader_close(ix__reader *rd)
{
    while (rd->n > rd->prompting)
        ix__buf_free(&rd->src[--rd->n].data);
}

void ix__reader_free(ix__reader *rd)
{
    rd->prompting = false;
    ix__reader_close(rd);
    ix__buf_free(&rd->line);
    ix__buf_free(&rd->word);
}

void ix__reader_push_text(ix__reader *rd, const char *name, const char *text,
                          size_t n)
{
    ix__source *s = &rd->src[rd->n++];

    *s = (ix__source){.name = name, .text = text, .n = n};
    ix__buf_init(&s->data, rd->in->ctx);
    if (n >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0)
        s->pos = 3; /* a byte order mark */
}

void ix__reader_push_file(ix__reader *rd, const char *name, ix_buf *data,
                          dev_t dev, ino_t ino)
{
    ix__source *s = &rd->src[rd->n];

    ix__reader_push_text(rd, name, data->data ? data->data : "", data->len);
    s->data = *data;
    s->dev = dev;
    s->ino = ino;
    ix__buf_init(data, rd->in->ctx);
}

bool ix__reader_line_left(const ix__reader *rd)
{
    for (size_t i = rd->pos; i < rd->line.len; i++)
        if (rd->line.data[i] != ' ')
            return true;
    return false;
}

/* Appends one character of the source; tabs go to the next multiple of 8.
 * After a byte that ends the line nothing is appended. */
static void add_char(ix__reader *rd, int c)
{
    if (rd->cut >= 0)
        return;
    if (c == '\t')
        ix__buf_fill(&rd->line, ' ', 8 - rd->line.len % 8);
    else if (c < ' ' || c > '~')
        rd->cut = c;
    else
        ix__buf_putc(&rd->line, (char)c);
}

/* One line of a text that has one. */
static bool text_line(ix__reader *rd, ix__source *s)
{
    const char *start = s->text + s->pos, *end;
    size_t n;

    end = memchr(start, '\n', s->n - s->pos);
    n = end ? (size_t)(end - start) : s->n - s->pos;
    s->pos += n + (end != NULL);
    for (size_t i = 0; i < n && rd->cut < 0; i++)
        add_char(rd, (unsigned char)start[i]);
    return true;
}

/* One line typed by a person; false at the end. Its end separates words, as a
 * blank does: who types a name and Return does not go on with the name. */
static bool typed_line(ix__reader *rd, ix__source *s)
{
    const ix_interp_opts *o = &rd->in->opt;
    ix_buf *b = &rd->in->text; /* nothing is printed meanwhile */

    ix__buf_clear(b);
    if (!rd->inside) {        /* limits are those of a statement */
        if (rd->in->mid_line) /* the prompt begins a line */
            ix__out(rd->in, "\n", 1);
        rd->in->nshown = 0;
        rd->in->step = 0;
    }
    ix__flush(rd->in);
    s->at_end = !o->read_line(o->read_ud, rd->inside, b);
    for (size_t i = 0; i < b->len; i++)
        add_char(rd, (unsigned char)b->data[i]);
    if (!s->at_end)
        add_char(rd, ' ');
    return !s->at_end;
}

/* One line of standard input; false at its end. */
static bool stdin_line(ix__reader *rd, ix__source *s)
{
    bool any = false;
    int c;

    ix__flush(rd->in);
    while ((c = getc(stdin)) != EOF && c != '\n') {
        any = true;
        add_char(rd, c);
    }
    s->at_end = c == EOF;
    return any || c == '\n';
}

static ix_status present_line(ix__reader *rd, const ix__source *s)
{
    rd->file = s->name;
    rd->number = s->line;
    IX_TRY(ix__buf_check(&rd->line));
    if (rd->cut == '\r')
        rd->cut = -1; /* lines may end as on other systems */
    if (rd->in->states.echo_source && !rd->add_semicolon) {
        ix__out(rd->in, rd->line.data, rd->line.len);
        ix__out(rd->in, "\n", 1);
    }
    return IX_OK;
}

/* Leaves sources that are read to their end. The present line stays: an error
 * at the end of all input is where it ends. */
static void leave_finished(ix__reader *rd)
{
    while (rd->n) {
        ix__source *s = &rd->src[rd->n - 1];

        if (s->text ? s->pos < s->n : !s->at_end)
            return;
        ix__buf_free(&s->data);
        rd->n--;
    }
}

ix_status ix__reader_line(ix__reader *rd, bool *more)
{
    *more = false;
    leave_finished(rd);
    while (rd->n && !*more) {
        ix__source *s = &rd->src[rd->n - 1];

        ix__buf_clear(&rd->line);
        rd->pos = 0;
        rd->cut = -1;
        s->line++;
        *more = s->text         ? text_line(rd, s)
                : rd->prompting ? typed_line(rd, s)
                                : stdin_line(rd, s);
        IX_TRY(ix__poll(rd->in->ctx));
        if (*more)
            IX_TRY(present_line(rd, s));
        else
            leave_finished(rd);
    }
    return IX_OK;
}
