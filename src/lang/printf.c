/* printf.c - the formatter of PRINTF.
 *
 * Conversions come from a fixed list and numbers are formatted by
 * base/numfmt, so a format can neither read beyond its arguments nor ask for
 * more than 1024 columns. All text goes to a buffer: a statement that fails
 * prints nothing. */
#include <string.h>

#include "base/numfmt.h"
#include "lang/interp_impl.h"

typedef struct {
    ix_interp *in;
    ix_buf *b;
    const ix_obj *args;
    int next; /* argument */
} state;

static ix_status wrong_type(const state *s, char what, const char *want)
{
    const ix_obj *o = s->args->u.list.item[s->next - 1];
    char buf[64];

    return IX_FAIL(s->in->ctx, IX_EARG, "%%%c needs %s as argument %d, got %s",
                   what, want, s->next,
                   ix__types_text(1u << o->type, buf, sizeof buf));
}

/* n numbers with ", " between them. */
static void put_numbers(state *s, const ix_numfmt *f, const double *v, int n)
{
    for (int i = 0; i < n; i++) {
        if (i)
            ix__buf_puts(s->b, ", ");
        ix__numfmt_put(s->b, f, v[i]);
    }
}

static void put_ctlpt(state *s, const ix_numfmt *f, const ix_ctlpt *p)
{
    ix__buf_printf(s->b, "%c%d, ", p->rational ? 'P' : 'E', p->ncoords);
    put_numbers(s, f, p->v, p->ncoords + p->rational);
}

static ix_status put_object(state *s, const ix_numfmt *f, const ix_obj *o)
{
    ix_states *st = &s->in->states;
    char saved[sizeof st->float_format];
    ix_status result;

    ix__buf_putc(s->b, '\n');
    memcpy(saved, st->float_format, sizeof saved);
    if (f->width || f->precision >= 0) {
        char precision[16] = "";

        if (f->precision >= 0)
            (void)snprintf(precision, sizeof precision, ".%d", f->precision);
        (void)snprintf(st->float_format, sizeof st->float_format, "%%%s%d%s%c",
                       f->flags, f->width, precision, f->conv);
    }
    result = ix__dump_value(s->in, o, s->b);
    memcpy(st->float_format, saved, sizeof saved);
    return result;
}

/* %p, %v, %P, %D, with the letter of the number format behind. */
static ix_status put_compound(state *s, char kind, const ix_numfmt *f,
                              const ix_obj *o)
{
    if (kind == 'D')
        return put_object(s, f, o);
    if (kind == 'P') {
        if (o->type != IX_OBJ_PLANE)
            return wrong_type(s, 'P', "a plane");
        put_numbers(s, f, o->u.plane, 4);
    } else if (o->type == IX_OBJ_POINT || o->type == IX_OBJ_VECTOR) {
        put_numbers(s, f, o->u.pt, 3);
    } else if (kind == 'p' && o->type == IX_OBJ_CTLPT) {
        put_ctlpt(s, f, o->u.ctlpt);
    } else {
        return wrong_type(s, kind, kind == 'p' ? "a point" : "a vector");
    }
    return IX_OK;
}

static ix_status put_simple(state *s, const ix_numfmt *f, const ix_obj *o)
{
    if (f->conv == 's') {
        if (o->type != IX_OBJ_STRING)
            return wrong_type(s, 's', "a string");
        ix__numfmt_puts(s->b, f, o->u.str.s);
    } else {
        if (o->type != IX_OBJ_NUMBER)
            return wrong_type(s, f->conv, "a number");
        ix__numfmt_put(s->b, f, o->u.num);
    }
    return IX_OK;
}

/* One conversion at *fmt; moves *fmt behind it. */
static ix_status conversion(state *s, const char **fmt)
{
    ix_numfmt f;
    const char *start = *fmt, *end = ix__numfmt_parse(start, &f);
    char kind;

    if (!end)
        return IX_FAIL(s->in->ctx, IX_EARG,
                       "malformed conversion \"%.20s\" (width and precision "
                       "go up to %d; a percent sign is \\%%)",
                       start, IX_NUMFMT_MAX_WIDTH);
    kind = f.conv;
    if (strchr("pvPD", kind)) {
        f.conv = *end ? *end++ : ' ';
        if (!strchr("efgEG", f.conv))
            return IX_FAIL(s->in->ctx, IX_EARG,
                           "%%%c must be followed by e, f or g", kind);
    } else if (!strchr("diuoxXeEfgGs", kind)) {
        return IX_FAIL(s->in->ctx, IX_EARG,
                       "conversion %%%c is not known; use one of d i u o x X "
                       "e f g E G s, or p v P D followed by e, f or g",
                       kind);
    }
    *fmt = end;
    if (s->next >= s->args->u.list.n)
        return IX_FAIL(s->in->ctx, IX_EARG,
                       "the format wants more than the %d argument%s of the "
                       "list",
                       s->args->u.list.n, s->args->u.list.n == 1 ? "" : "s");
    s->next++;
    if (strchr("pvPD", kind))
        return put_compound(s, kind, &f, s->args->u.list.item[s->next - 1]);
    return put_simple(s, &f, s->args->u.list.item[s->next - 1]);
}

/* The character after a backslash. */
static char escaped(char c)
{
    switch (c) {
    case 'n':
        return '\n';
    case 't':
        return '\t';
    default:
        return c;
    }
}

ix_status ix__printf(ix_interp *in, const char *fmt, const ix_obj *args,
                     ix_buf *b)
{
    state s = {in, b, args, 0};

    while (*fmt) {
        if (fmt[0] == '%' && fmt[1] == '%') {
            ix__buf_putc(b, '%');
            fmt += 2;
        } else if (*fmt == '%') {
            IX_TRY(conversion(&s, &fmt));
        } else if (fmt[0] == '\\' && fmt[1]) {
            ix__buf_putc(b, escaped(fmt[1]));
            fmt += 2;
        } else {
            ix__buf_putc(b, *fmt++);
        }
    }
    return ix__buf_check(b);
}
