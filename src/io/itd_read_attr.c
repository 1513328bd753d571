/* itd_read_attr.c - attributes: typed by the look of their value, unknown
 * names kept (spec/itd-format 3.2). */
#include <math.h>

#include "io/itd_read_impl.h"

#define MAX_ATTRS 1000 /* of one owner: setting one looks through all */

/* Reads tokens up to the closing bracket. */
static ix_status skip_flat(ix__lex *l)
{
    ix__token t;

    do {
        IX_TRY(ix__lex_next(l, &t));
        if (t.kind == IX_T_OPEN || t.kind == IX_T_END)
            return ix__lex_unexpected(l, &t, "] of the attribute");
    } while (t.kind != IX_T_CLOSE);
    return IX_OK;
}

/* Made only of digits, e, E, point and signs, and a number. */
static bool is_numeric(const ix__token *t, double *v)
{
    return t->kind == IX_T_WORD && ix_num_parse(t->s, t->end, v) == t->end &&
           isfinite(*v);
}

static ix_status set_number(ix__lex *l, ix_attr **attrs, const char *name,
                            double v)
{
    const double exact = 9007199254740992.0; /* 2^53: integers are exact */

    if (v == floor(v) && fabs(v) <= exact)
        return ix__attr_set_int(l->ctx, attrs, name, (long long)v);
    return ix__attr_set_real(l->ctx, attrs, name, v);
}

static ix_status read_values(ix__lex *l, ix_attr **attrs, const char *name,
                             ix_obj *list)
{
    IX_TRY(ix__itdr_objects(
        l, list, false,
        "OBJECT (in an attribute; an object's name, or NONE, must stand before "
        "its contents)"));
    IX_TRY(ix__lex_close(l, "] of the attribute"));
    if (list->u.list.n == 0)
        return ix__attr_set_string(l->ctx, attrs, name, "");
    return ix__attr_set_obj(l->ctx, attrs, name,
                            list->u.list.n == 1 ? list->u.list.item[0] : list);
}

static ix_status set_objects(ix__lex *l, ix_attr **attrs, const char *name)
{
    ix_obj *list = ix__obj_list(l->ctx);
    ix_status st;

    if (!list)
        return IX_ENOMEM;
    st = read_values(l, attrs, name, list);
    ix__obj_unref(l->ctx, list);
    return st;
}

static ix_status set_value(ix__lex *l, ix_attr **attrs, const char *name)
{
    ix__token t;
    char *text;
    size_t n;
    double v;

    IX_TRY(ix__lex_peek(l, &t));
    if (t.kind == IX_T_OPEN)
        return set_objects(l, attrs, name);
    IX_TRY(ix__lex_next(l, &t));
    if (t.kind == IX_T_CLOSE)
        return ix__attr_set_string(l->ctx, attrs, name, "");
    if (t.kind == IX_T_END)
        return ix__lex_unexpected(l, &t, "] of the attribute");
    if (is_numeric(&t, &v)) {
        IX_TRY(set_number(l, attrs, name, v));
        return skip_flat(l);
    }
    IX_TRY(ix__token_text(l, &t, &text, &n));
    IX_TRY(ix__attr_set_string(l->ctx, attrs, name, text));
    return skip_flat(l);
}

/* The attribute behind its opening bracket. */
static ix_status read_attr(ix__lex *l, ix_attr **attrs,
                           ix__attr_special special, void *arg)
{
    ix_attr *first = *attrs;
    bool taken = false;
    ix__token t;
    char *name;
    size_t n;

    IX_TRY(ix__lex_next(l, &t));
    if (t.kind != IX_T_WORD && t.kind != IX_T_QUOTED)
        return ix__lex_unexpected(l, &t, "name of an attribute");
    if (special)
        IX_TRY(special(l, &t, arg, &taken));
    if (taken)
        return IX_OK;
    IX_TRY(ix__token_text(l, &t, &name, &n));
    IX_TRY(set_value(l, attrs, name));
    if (*attrs != first)
        ix__attr_first_to_last(attrs);
    return IX_OK;
}

ix_status ix__itdr_attrs(ix__lex *l, ix_attr **attrs, ix__attr_special special,
                         void *arg)
{
    ix__token t;

    IX_TRY(ix__lex_peek(l, &t));
    for (int i = 0; t.kind == IX_T_OPEN; i++) {
        if (i == MAX_ATTRS)
            return ix__lex_fail(l, t.at, "more than %d attributes", MAX_ATTRS);
        IX_TRY(ix__lex_open(l));
        IX_TRY(read_attr(l, attrs, special, arg));
        IX_TRY(ix__lex_peek(l, &t));
    }
    return IX_OK;
}

ix_status ix__itdr_drop_attrs(ix__lex *l)
{
    ix__token t;

    IX_TRY(ix__lex_peek(l, &t));
    while (t.kind == IX_T_OPEN) {
        IX_TRY(ix__lex_open(l));
        IX_TRY(skip_flat(l));
        IX_TRY(ix__lex_peek(l, &t));
    }
    return IX_OK;
}
