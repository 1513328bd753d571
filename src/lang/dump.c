/* dump.c - the text of a value as an expression statement prints it: a
 * header line, then the object in the syntax of data files (spec/language
 * 3.2). DumpLevel chooses what is shown. */
#include "lang/interp_impl.h"

enum { /* bits of DumpLevel */
       SCALARS = 1,
       FREEFORMS = 2,
       POLYS = 4,
       RECURSE = 0x10,
       WHOLE_LISTS = 0x20,
       NO_HEADER = 0x100
};

#define INDENT 4
#define KEEP   65536u /* of the text buffer between two statements */

static int level_bit(const ix_obj *o)
{
    switch (o->type) {
    case IX_OBJ_LIST:
        return WHOLE_LISTS;
    case IX_OBJ_POLY:
        return POLYS;
    case IX_OBJ_CURVE:
    case IX_OBJ_SURFACE:
    case IX_OBJ_TRIMSRF:
    case IX_OBJ_TRIVAR:
    case IX_OBJ_TRISRF:
    case IX_OBJ_MODEL:
    case IX_OBJ_MULTIVAR:
        return FREEFORMS;
    default:
        return SCALARS;
    }
}

static ix_status dump(ix_interp *in, const ix_obj *o, int refs, int depth,
                      ix_buf *b)
{
    ix_write_opts w = {.float_format = in->states.float_format};
    int level = in->states.dump_level;

    if (!(level & NO_HEADER)) {
        ix__buf_fill(b, ' ', (size_t)(INDENT * depth));
        ix__buf_printf(b, "%-10s (%d) - %-9s type\n",
                       o->name ? o->name : "NONE", refs,
                       ix__obj_type_name(o->type));
    }
    IX_TRY(ix__buf_check(b));
    if (level & level_bit(o))
        return ix__itd_write(b, o, &w, INDENT * depth);
    if (o->type != IX_OBJ_LIST || !(level & RECURSE))
        return IX_OK;
    for (int i = 0; i < o->u.list.n; i++)
        IX_TRY(
            dump(in, o->u.list.item[i], o->u.list.item[i]->refs, depth + 1, b));
    return IX_OK;
}

/* A list may hold one list many times, so its text is measured first. */
static ix_status dump_checked(ix_interp *in, const ix_obj *o, int refs,
                              ix_buf *b)
{
    if (o->type == IX_OBJ_LIST)
        IX_TRY(ix__obj_check_size(in->ctx, o, IX_MAX_DEPTH, IX_MAX_TEXT));
    return dump(in, o, refs, 0, b);
}

ix_status ix__dump_value(ix_interp *in, const ix_obj *o, ix_buf *b)
{
    return dump_checked(in, o, o->refs, b);
}

/* The short text for a person at the prompt. */
static bool shown_shortly(ix_interp *in, const ix_obj *o, ix_buf *b)
{
    const ix_interp_opts *opt = &in->opt;

    return in->rd && in->rd->prompting && !in->out && opt->show_value &&
           opt->show_value(opt->read_ud, o, b);
}

ix_status ix__print_value(ix_interp *in, const ix_obj *o, int refs)
{
    ix_buf *b = &in->text;
    ix_status st;

    ix__buf_clear(b);
    st = shown_shortly(in, o, b) ? ix__buf_check(b)
                                 : dump_checked(in, o, refs, b);
    if (st == IX_OK)
        ix__out(in, b->data ? b->data : "", b->len);
    if (b->cap > KEEP)
        ix__buf_free(b);
    return st;
}
