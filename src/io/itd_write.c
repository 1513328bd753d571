/* itd_write.c - objects, attributes and simple entities as text, in the layout
 * of spec/itd-format 10. The recursion over lists and object attributes is
 * bounded: ix__itd_write checks the depth before it starts. */
#include "io/itd_write_impl.h"

/* --- attributes ------------------------------------------------------- */

static ix_status write_attr(ix__itdw *w, const ix_attr *a, int column)
{
    ix_buf *b = w->b;

    ix__buf_putc(b, '[');
    IX_TRY(ix__itdw_attr_name(w, a->name));
    switch (a->type) {
    case IX_ATTR_STRING:
        if (a->s[0]) {
            ix__buf_putc(b, ' ');
            IX_TRY(ix__itdw_attr_quoted(w, a->s));
        }
        break;
    case IX_ATTR_INT:
        ix__buf_putc(b, ' ');
        ix__buf_int(b, a->i);
        break;
    case IX_ATTR_REAL:
        ix__buf_putc(b, ' ');
        ix__itdw_real_attr(w, a->r);
        break;
    case IX_ATTR_OBJ:
        ix__buf_putc(b, '\n');
        IX_TRY(ix__itdw_object(w, a->obj, column + 8));
        ix__itdw_indent(w, column + 4);
        break;
    }
    ix__buf_putc(b, ']');
    return IX_OK;
}

static void break_line(ix__itdw *w, int column)
{
    ix__buf_putc(w->b, '\n');
    ix__itdw_indent(w, column + 4);
}

ix_status ix__itdw_attrs(ix__itdw *w, const ix_attr *attrs, int column)
{
    bool fresh = false; /* at the beginning of a line */
    int n = 0;

    for (const ix_attr *a = attrs; a; a = a->next) {
        bool obj = a->type == IX_ATTR_OBJ;

        if (a->name[0] == '_')
            continue;
        if (!fresh && (obj || (n > 0 && n % 2 == 0)))
            break_line(w, column);
        IX_TRY(write_attr(w, a, column));
        if (obj)
            break_line(w, column);
        else
            ix__buf_putc(w->b, ' ');
        fresh = obj;
        n++;
    }
    return ix__itdw_check(w);
}

/* --- simple entities -------------------------------------------------- */

static void write_simple(ix__itdw *w, const char *keyword, int n,
                         const double *v)
{
    ix__buf_putc(w->b, '[');
    ix__buf_puts(w->b, keyword);
    ix__buf_putc(w->b, ' ');
    ix__itdw_nums(w, n, v);
    ix__buf_puts(w->b, "]\n");
}

static void write_ctlpt(ix__itdw *w, const ix_ctlpt *p)
{
    ix__buf_printf(w->b, "[CTLPT %c%d%s", p->rational ? 'P' : 'E', p->ncoords,
                   p->rational ? " " : "  ");
    ix__itdw_nums(w, p->ncoords + (p->rational ? 1 : 0), p->v);
    ix__buf_puts(w->b, "]\n");
}

/* Four rows behind a header line. */
static void write_rows(ix__itdw *w, const double mat[16], int column)
{
    for (int i = 0; i < 4; i++) {
        ix__buf_putc(w->b, '\n');
        ix__itdw_indent(w, column + 8);
        ix__itdw_nums(w, 4, mat + 4 * i);
    }
    ix__buf_puts(w->b, "]\n");
}

static ix_status write_string(ix__itdw *w, const ix_obj *o)
{
    ix__buf_puts(w->b, "[STRING ");
    IX_TRY(ix__itdw_quoted(w, o->u.str.s, o->u.str.len));
    ix__buf_puts(w->b, "]\n");
    return IX_OK;
}

static ix_status write_simple_entity(ix__itdw *w, const ix_obj *o, int column)
{
    ix__itdw_indent(w, column);
    switch (o->type) {
    case IX_OBJ_NUMBER:
        write_simple(w, "NUMBER", 1, &o->u.num);
        break;
    case IX_OBJ_POINT:
        write_simple(w, "POINT", 3, o->u.pt);
        break;
    case IX_OBJ_VECTOR:
        write_simple(w, "VECTOR", 3, o->u.pt);
        break;
    case IX_OBJ_PLANE:
        write_simple(w, "PLANE", 4, o->u.plane);
        break;
    case IX_OBJ_CTLPT:
        write_ctlpt(w, o->u.ctlpt);
        break;
    case IX_OBJ_STRING:
        return write_string(w, o);
    case IX_OBJ_MATRIX:
        ix__buf_puts(w->b, "[MATRIX");
        write_rows(w, o->u.mat, column);
        break;
    case IX_OBJ_INSTANCE:
        ix__buf_puts(w->b, "[INSTANCE ");
        ix__itdw_word(w, o->u.inst->target);
        write_rows(w, o->u.inst->mat, column);
        break;
    default:
        break;
    }
    return IX_OK;
}

/* --- objects ---------------------------------------------------------- */

static ix_status write_body(ix__itdw *w, const ix_obj *o, int column)
{
    switch (o->type) {
    case IX_OBJ_UNDEF:
        return IX_OK;
    case IX_OBJ_LIST:
        for (int i = 0; i < o->u.list.n; i++)
            IX_TRY(ix__itdw_object(w, o->u.list.item[i], column));
        return IX_OK;
    case IX_OBJ_CURVE:
    case IX_OBJ_SURFACE:
    case IX_OBJ_TRIVAR:
    case IX_OBJ_MULTIVAR:
        for (int i = 0; i < o->u.mvs->n; i++)
            IX_TRY(ix__itdw_mv(w, o->type, o->u.mvs->mv[i], column));
        return IX_OK;
    case IX_OBJ_POLY:
        for (int i = 0; i < o->u.poly->n; i++)
            IX_TRY(ix__itdw_poly(w, &o->u.poly->poly[i], column));
        return IX_OK;
    case IX_OBJ_TRIMSRF:
        for (int i = 0; i < o->u.trim.n; i++)
            IX_TRY(ix__itdw_trimsrf(w, o->u.trim.item[i], column));
        return IX_OK;
    case IX_OBJ_TRISRF:
        for (int i = 0; i < o->u.tri.n; i++)
            IX_TRY(ix__itdw_trisrf(w, o->u.tri.item[i], column));
        return IX_OK;
    case IX_OBJ_MODEL:
        for (int i = 0; i < o->u.model.n; i++)
            IX_TRY(ix__itdw_model(w, o->u.model.item[i], column));
        return IX_OK;
    default:
        return write_simple_entity(w, o, column);
    }
}

/* What makes a list empty when it is read (docs/itd.md 12); without contents it
 * would vanish. */
static void write_empty(ix__itdw *w, int column)
{
    ix__itdw_indent(w, column);
    ix__buf_puts(w->b, "[OBJECT NONE\n");
    ix__itdw_indent(w, column);
    ix__buf_puts(w->b, "]\n");
}

ix_status ix__itdw_object(ix__itdw *w, const ix_obj *o, int column)
{
    ix__itdw_indent(w, column);
    ix__buf_puts(w->b, "[OBJECT ");
    IX_TRY(ix__itdw_attrs(w, o->attrs, column));
    ix__itdw_word(w, w->peer ? NULL : o->name);
    ix__buf_putc(w->b, '\n');
    if (w->file && o->type == IX_OBJ_LIST && o->u.list.n == 0)
        write_empty(w, column + 4);
    IX_TRY(write_body(w, o, column + 4));
    ix__itdw_indent(w, column);
    ix__buf_puts(w->b, "]\n");
    return ix__itdw_check(w);
}

ix_status ix__itd_write(ix_buf *b, const ix_obj *o, const ix_write_opts *opts,
                        int column)
{
    ix__itdw w;

    IX_TRY(ix__itdw_init(&w, b, opts));
    IX_TRY(ix__obj_check_size(b->ctx, o, IX_MAX_DEPTH, IX_MAX_TEXT));
    return ix__itdw_object(&w, o, column);
}
