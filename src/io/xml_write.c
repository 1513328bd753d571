/* xml_write.c - objects, attributes and simple entities as XML (docs/xml.md).
 * The recursion over lists and object attributes is bounded: the depth of
 * elements is. */
#include <string.h>

#include "io/xml_pull.h"
#include "io/xml_write_impl.h"

/* An entity opens at most so many elements inside each other. */
enum { ENTITY_DEPTH = 6, STRING_PIECE = 1 << 20 };

/* --- attributes ------------------------------------------------------- */

/* Text as it is or as hexadecimal digits, in one element. */
static ix_status put_string(ix__xmlw *w, const char *name, const char *s,
                            size_t n)
{
    bool text = ix__xml_is_text(s, n);

    if (!text)
        ix__xmlw_attr(w, "encoding", "hex");
    ix__xmlw_begin(w);
    if (text)
        ix__xmlw_escaped(w->b, s, n);
    for (size_t i = 0; !text && i < n; i++)
        ix__buf_printf(w->b, "%02x", (unsigned char)s[i]);
    ix__xmlw_end(w, name);
    return ix__xmlw_check(w);
}

static ix_status put_attr(ix__xmlw *w, const ix_attr *a)
{
    static const char *const types[] = {"string", "integer", "real", "object"};

    ix__xmlw_tag(w, "attribute");
    IX_TRY(ix__xmlw_attr_text(w, "name", a->name, strlen(a->name)));
    ix__xmlw_attr(w, "type", types[a->type]);
    switch (a->type) {
    case IX_ATTR_STRING:
        if (strlen(a->s) > IX_XML_MAX_TEXT / 6) /* escapes have up to 6 */
            return IX_FAIL(w->b->ctx, IX_EUNABLE,
                           "attribute %.40s: %zu bytes are too long for XML",
                           a->name, strlen(a->s));
        return put_string(w, "attribute", a->s, strlen(a->s));
    case IX_ATTR_OBJ:
        ix__xmlw_open(w);
        IX_TRY(ix__xmlw_object(w, a->obj));
        ix__xmlw_close(w, "attribute");
        return IX_OK;
    case IX_ATTR_INT:
        ix__xmlw_begin(w);
        ix__buf_int(w->b, a->i);
        break;
    case IX_ATTR_REAL:
        ix__xmlw_begin(w);
        ix__xmlw_num(w, a->r);
        break;
    }
    ix__xmlw_end(w, "attribute");
    return IX_OK;
}

ix_status ix__xmlw_attrs(ix__xmlw *w, const ix_attr *attrs)
{
    for (const ix_attr *a = attrs; a; a = a->next)
        if (a->name[0] != '_') /* internal: never written */
            IX_TRY(put_attr(w, a));
    return ix__xmlw_check(w);
}

/* --- simple entities -------------------------------------------------- */

static ix_status put_numbers(ix__xmlw *w, const char *name, int n,
                             const double *v)
{
    ix__xmlw_tag(w, name);
    ix__xmlw_begin(w);
    ix__xmlw_nums(w, n, v);
    ix__xmlw_end(w, name);
    return ix__xmlw_check(w);
}

static ix_status put_ctlpt(ix__xmlw *w, const ix_ctlpt *p)
{
    ix__xmlw_tag(w, "controlpoint");
    ix__buf_printf(w->b, " type=\"%c%d\"", p->rational ? 'P' : 'E', p->ncoords);
    ix__xmlw_begin(w);
    ix__xmlw_nums(w, p->ncoords + (p->rational ? 1 : 0), p->v);
    ix__xmlw_end(w, "controlpoint");
    return ix__xmlw_check(w);
}

/* Long strings go into several elements, cut between characters. */
static ix_status put_strings(ix__xmlw *w, const char *s, size_t n)
{
    do {
        size_t k = n < STRING_PIECE ? n : STRING_PIECE;

        for (int i = 0; k < n && i < 3 && ((unsigned char)s[k] & 0xc0) == 0x80;)
            i++, k--;
        ix__xmlw_tag(w, "string");
        IX_TRY(put_string(w, "string", s, k));
        s += k;
        n -= k;
    } while (n > 0);
    return IX_OK;
}

static ix_status put_instance(ix__xmlw *w, const ix_instance *t)
{
    ix__xmlw_tag(w, "instance");
    IX_TRY(ix__xmlw_attr_text(w, "of", t->target, strlen(t->target)));
    ix__xmlw_begin(w);
    ix__xmlw_nums(w, 16, t->mat);
    ix__xmlw_end(w, "instance");
    return ix__xmlw_check(w);
}

static ix_status put_simple(ix__xmlw *w, const ix_obj *o)
{
    switch (o->type) {
    case IX_OBJ_NUMBER:
        return put_numbers(w, "number", 1, &o->u.num);
    case IX_OBJ_POINT:
        return put_numbers(w, "point", 3, o->u.pt);
    case IX_OBJ_VECTOR:
        return put_numbers(w, "vector", 3, o->u.pt);
    case IX_OBJ_PLANE:
        return put_numbers(w, "plane", 4, o->u.plane);
    case IX_OBJ_MATRIX:
        return put_numbers(w, "matrix", 16, o->u.mat);
    case IX_OBJ_CTLPT:
        return put_ctlpt(w, o->u.ctlpt);
    case IX_OBJ_STRING:
        return put_strings(w, o->u.str.s, o->u.str.len);
    case IX_OBJ_INSTANCE:
        return put_instance(w, o->u.inst);
    default:
        ix__xmlw_tag(w, "undefined");
        ix__xmlw_none(w);
        return IX_OK;
    }
}

/* --- objects ---------------------------------------------------------- */

static ix_status put_item(ix__xmlw *w, const ix_obj *o, int i)
{
    const void *item = ix__seq_item(o, i);

    switch (o->type) {
    case IX_OBJ_CURVE:
        return ix__xmlw_mv(w, "curve", NULL, item);
    case IX_OBJ_SURFACE:
        return ix__xmlw_mv(w, "surface", NULL, item);
    case IX_OBJ_TRIVAR:
        return ix__xmlw_mv(w, "trivariate", NULL, item);
    case IX_OBJ_MULTIVAR:
        return ix__xmlw_mv(w, "multivariate", NULL, item);
    case IX_OBJ_TRIMSRF:
        return ix__xmlw_trimsrf(w, item);
    case IX_OBJ_TRISRF:
        return ix__xmlw_trisrf(w, item);
    default:
        return ix__xmlw_model(w, item);
    }
}

static ix_status put_body(ix__xmlw *w, const ix_obj *o)
{
    int n = ix__seq_count(o);

    if (n == 0 && o->type != IX_OBJ_POLY && o->type != IX_OBJ_LIST)
        return put_simple(w, o);
    for (int i = 0; i < n; i++)
        IX_TRY(put_item(w, o, i));
    for (int i = 0; o->type == IX_OBJ_POLY && i < o->u.poly->n; i++)
        IX_TRY(ix__xmlw_poly(w, &o->u.poly->poly[i]));
    for (int i = 0; o->type == IX_OBJ_LIST && i < o->u.list.n; i++)
        IX_TRY(ix__xmlw_object(w, o->u.list.item[i]));
    return IX_OK;
}

ix_status ix__xmlw_object(ix__xmlw *w, const ix_obj *o)
{
    if (w->depth + ENTITY_DEPTH >= IX_MAX_DEPTH)
        return IX_FAIL(w->b->ctx, IX_EUNABLE,
                       "objects nested too deeply for XML: %d elements inside "
                       "each other, at most %d are read",
                       w->depth + ENTITY_DEPTH, IX_MAX_DEPTH);
    ix__xmlw_tag(w, "object");
    if (o->name)
        IX_TRY(ix__xmlw_attr_text(w, "name", o->name, strlen(o->name)));
    ix__xmlw_open(w);
    IX_TRY(ix__xmlw_attrs(w, o->attrs));
    IX_TRY(put_body(w, o));
    ix__xmlw_close(w, "object");
    return ix__xmlw_check(w);
}

ix_status ix__xml_write(ix_buf *b, const ix_obj *o)
{
    ix__xmlw w = {.b = b, .start = ix__buf_total(b), .depth = 1};

    IX_TRY(ix__obj_check_size(b->ctx, o, IX_MAX_DEPTH, IX_MAX_TEXT));
    ix__buf_puts(b, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                    "<iritx xmlns=\"" IX_XML_NAMESPACE "\" version=\"1\">\n");
    IX_TRY(ix__xmlw_object(&w, o));
    ix__buf_puts(b, "</iritx>\n");
    return ix__xmlw_check(&w);
}
