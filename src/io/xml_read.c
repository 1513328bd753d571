/* xml_read.c - objects, lists, attributes and simple entities from XML
 * (docs/xml.md). The recursion over objects is bounded: the depth of elements
 * is. */
#include <string.h>

#include "io/gather.h"
#include "io/xml_read_impl.h"

#define MAX_ATTRS 1000 /* of one owner: setting one looks through all */

/* --- entities --------------------------------------------------------- */

typedef struct {
    const char *name;
    ix_obj_type type;
    int variant; /* the kind of polygon; directions of a multivariate, 0 any */
} entity;

static const entity entities[] = {
    {"number", IX_OBJ_NUMBER, 0},
    {"point", IX_OBJ_POINT, 0},
    {"vector", IX_OBJ_VECTOR, 0},
    {"plane", IX_OBJ_PLANE, 0},
    {"matrix", IX_OBJ_MATRIX, 0},
    {"controlpoint", IX_OBJ_CTLPT, 0},
    {"string", IX_OBJ_STRING, 0},
    {"instance", IX_OBJ_INSTANCE, 0},
    {"undefined", IX_OBJ_UNDEF, 0},
    {"curve", IX_OBJ_CURVE, 1},
    {"surface", IX_OBJ_SURFACE, 2},
    {"trivariate", IX_OBJ_TRIVAR, 3},
    {"multivariate", IX_OBJ_MULTIVAR, 0},
    {"polygon", IX_OBJ_POLY, IX_POLYGON},
    {"polyline", IX_OBJ_POLY, IX_POLYLINE},
    {"pointlist", IX_OBJ_POLY, IX_POINTLIST},
    {"polystrip", IX_OBJ_POLY, IX_POLYSTRIP},
    {"trimmedsurface", IX_OBJ_TRIMSRF, 0},
    {"triangularsurface", IX_OBJ_TRISRF, 0},
    {"model", IX_OBJ_MODEL, 0},
};

static const entity *find_entity(const ix__xmlr *r)
{
    for (size_t i = 0; i < sizeof entities / sizeof *entities; i++)
        if (ix__xmlr_is(r, entities[i].name))
            return &entities[i];
    return NULL;
}

static bool in_sequences(ix_obj_type t)
{
    return t == IX_OBJ_POLY || t == IX_OBJ_CURVE || t == IX_OBJ_SURFACE ||
           t == IX_OBJ_TRIVAR || t == IX_OBJ_MULTIVAR || t == IX_OBJ_TRIMSRF ||
           t == IX_OBJ_TRISRF || t == IX_OBJ_MODEL;
}

static ix_status made(ix_obj *o, ix_obj **out)
{
    *out = o;
    return o ? IX_OK : IX_ENOMEM;
}

static ix_status read_numbers(ix__xmlr *r, ix_obj_type type, ix_obj **out)
{
    int n = type == IX_OBJ_NUMBER   ? 1
            : type == IX_OBJ_PLANE  ? 4
            : type == IX_OBJ_MATRIX ? 16
                                    : 3;
    double v[16];

    IX_TRY(ix__xmlr_allow(r, ""));
    IX_TRY(ix__xmlr_nums(r, n, v));
    switch (type) {
    case IX_OBJ_NUMBER:
        return made(ix__obj_number(r->ctx, v[0]), out);
    case IX_OBJ_POINT:
        return made(ix__obj_point(r->ctx, v), out);
    case IX_OBJ_VECTOR:
        return made(ix__obj_vector(r->ctx, v), out);
    case IX_OBJ_PLANE:
        return made(ix__obj_plane(r->ctx, v), out);
    default:
        return made(ix__obj_matrix(r->ctx, v), out);
    }
}

static ix_status read_ctlpt(ix__xmlr *r, ix_obj **out)
{
    ix_ctlpt p = {0};

    IX_TRY(ix__xmlr_allow(r, " type "));
    IX_TRY(ix__xmlr_point_type(r, &p.ncoords, &p.rational));
    IX_TRY(ix__xmlr_nums(r, p.ncoords + p.rational, p.v));
    return made(ix__obj_ctlpt(r->ctx, &p), out);
}

static ix_status read_instance(ix__xmlr *r, ix_obj **out)
{
    size_t at = r->e.at;
    double mat[16];
    char *of;

    IX_TRY(ix__xmlr_allow(r, " of of-hex "));
    IX_TRY(ix__xmlr_name(r, "of", &of));
    if (!of)
        return ix__xml_fail(r->x, at, "an instance needs attribute \"of\"");
    IX_TRY(ix__xmlr_nums(r, 16, mat));
    return made(ix__obj_instance(r->ctx, of, mat), out);
}

/* The text of the element in r->text. */
static ix_status read_text(ix__xmlr *r)
{
    static const char *const encodings[] = {"hex"};
    int i;

    if (!ix__xmlr_attr(r, "encoding"))
        return ix__xmlr_bytes(r, false);
    IX_TRY(ix__xmlr_word(r, "encoding", 1, encodings, &i));
    return ix__xmlr_bytes(r, true);
}

static ix_status read_single(ix__xmlr *r, ix_obj_type type, ix_obj **out)
{
    switch (type) {
    case IX_OBJ_CTLPT:
        return read_ctlpt(r, out);
    case IX_OBJ_INSTANCE:
        return read_instance(r, out);
    case IX_OBJ_UNDEF:
        IX_TRY(ix__xmlr_allow(r, ""));
        IX_TRY(ix__xmlr_empty(r));
        return made(ix__obj_undef(r->ctx), out);
    default:
        return read_numbers(r, type, out);
    }
}

static ix_status read_one(ix__xmlr *r, const entity *e, const void **out)
{
    const ix_mv *m;

    switch (e->type) {
    case IX_OBJ_POLY:
        return ix__xmlr_poly(r, (ix_poly_kind)e->variant, out);
    case IX_OBJ_TRIMSRF:
        return ix__xmlr_trimsrf(r, out);
    case IX_OBJ_TRISRF:
        return ix__xmlr_trisrf(r, out);
    case IX_OBJ_MODEL:
        return ix__xmlr_model(r, out);
    default:
        if (ix__xmlr_attr(r, "use"))
            return ix__xml_fail(r->x, r->e.at,
                                "attribute \"use\" is for curves of trimmed "
                                "surfaces and models");
        IX_TRY(ix__xmlr_mv(r, e->variant, &m));
        *out = m;
        return IX_OK;
    }
}

static void drop_one(ix_ctx *ctx, ix_obj_type type, const void *p)
{
    if (type == IX_OBJ_POLY)
        ix__poly_unref(ctx, p);
    else
        ix__seq_unref(ctx, type, p);
}

/* --- what an object holds --------------------------------------------- */

typedef struct {
    const entity *e; /* of the entities so far; NULL: none */
    ix_obj *o;       /* a list, or a single value */
    ix_buf text;     /* of strings */
    int n, cap;
    const void **item; /* of a sequence */
} body;

static ix_status add_object(ix__xmlr *r, body *b)
{
    ix_obj *o;
    ix_status st;

    if (b->e)
        return ix__xmlr_unexpected(r, "entities, not objects,");
    if (!b->o && !(b->o = ix__obj_list(r->ctx)))
        return IX_ENOMEM;
    IX_TRY(ix__xmlr_object(r, &o));
    st = ix__obj_append(r->ctx, b->o, o);
    ix__obj_unref(r->ctx, o);
    return st;
}

static ix_status add_string(ix__xmlr *r, body *b)
{
    IX_TRY(ix__xmlr_allow(r, " encoding "));
    IX_TRY(read_text(r));
    ix__buf_add(&b->text, r->text.data, r->text.len);
    return ix__buf_check(&b->text);
}

static ix_status add_item(ix__xmlr *r, body *b, const entity *e)
{
    IX_TRY(
        ix__gather(r->ctx, b->n, &b->cap, sizeof *b->item, (void *)&b->item));
    IX_TRY(read_one(r, e, &b->item[b->n]));
    b->n++;
    return IX_OK;
}

static ix_status add_entity(ix__xmlr *r, body *b)
{
    const entity *e = find_entity(r);

    if (!e)
        return ix__xmlr_unexpected(r, "an entity such as number or curve");
    if (b->o && !b->e)
        return ix__xmlr_unexpected(r, "objects, not entities,");
    if (b->e && b->e->type != e->type)
        return ix__xml_fail(r->x, r->e.at,
                            "\"%s\" in an object of another type; an object "
                            "holds entities of one type",
                            e->name);
    if (b->e && !in_sequences(e->type) && e->type != IX_OBJ_STRING)
        return ix__xml_fail(r->x, r->e.at,
                            "a second \"%s\"; an object holds one", e->name);
    b->e = e;
    if (in_sequences(e->type))
        return add_item(r, b, e);
    if (e->type == IX_OBJ_STRING)
        return add_string(r, b);
    return read_single(r, e->type, &b->o);
}

/* The polygons of single ones, moved into one block. */
static ix_obj *join_polys(ix_ctx *ctx, const body *b)
{
    ix_poly *p = ix__poly_new(ctx, b->n);

    for (int i = 0; p && i < b->n; i++) {
        ix_polygon *from = ((const ix_poly *)b->item[i])->poly;

        p->poly[i] = *from;
        *from = (ix_polygon){0};
    }
    return ix__obj_poly(ctx, p);
}

static ix_status finish_body(ix_ctx *ctx, body *b)
{
    if (b->o)
        return IX_OK;
    if (!b->e)
        b->o = ix__obj_list(ctx);
    else if (b->e->type == IX_OBJ_STRING)
        b->o = ix__obj_string(ctx, b->text.data, b->text.len);
    else if (b->e->type == IX_OBJ_POLY)
        b->o = join_polys(ctx, b);
    else
        b->o = ix__seq_new(ctx, b->e->type, b->n, b->item);
    return b->o ? IX_OK : IX_ENOMEM;
}

/* --- attributes ------------------------------------------------------- */

static ix_status set_integer(ix__xmlr *r, ix_attr **attrs, const char *name)
{
    unsigned long long v = 0, most = 9223372036854775807u;
    const char *p;
    bool negative;

    IX_TRY(ix__xmlr_text(r));
    if (ix__xmlr_at_end(r))
        return ix__xmlr_bad_text(r, "an integer expected");
    p = r->p;
    negative = *p == '-';
    most += negative;
    for (p += negative; *p >= '0' && *p <= '9'; p++) {
        if (v > (most - (unsigned)(*p - '0')) / 10)
            return ix__xmlr_bad_text(r, "integer out of range (9.2e18)");
        v = 10 * v + (unsigned)(*p - '0');
    }
    if (p == r->p + negative)
        return ix__xmlr_bad_text(r, "an integer expected");
    r->p = p;
    if (!ix__xmlr_at_end(r))
        return ix__xmlr_bad_text(r, "one integer expected");
    return ix__attr_set_int(r->ctx, attrs, name,
                            negative && v > 0 ? -(long long)(v - 1) - 1
                                              : (long long)v);
}

static ix_status set_string(ix__xmlr *r, ix_attr **attrs, const char *name)
{
    IX_TRY(read_text(r));
    if (memchr(r->text.data, '\0', r->text.len))
        return ix__xml_fail(r->x, r->behind, "a NUL byte in an attribute");
    return ix__attr_set_string(r->ctx, attrs, name, r->text.data);
}

static ix_status set_object(ix__xmlr *r, ix_attr **attrs, const char *name)
{
    size_t at = r->e.at;
    ix_obj *o;
    bool more;
    ix_status st;

    IX_TRY(ix__xmlr_child(r, &more));
    if (!more)
        return ix__xml_fail(r->x, at, "an object expected in it");
    if (!ix__xmlr_is(r, "object"))
        return ix__xmlr_unexpected(r, "object");
    IX_TRY(ix__xmlr_object(r, &o));
    st = ix__attr_set_obj(r->ctx, attrs, name, o);
    ix__obj_unref(r->ctx, o);
    return st == IX_OK ? ix__xmlr_empty(r) : st;
}

static ix_status set_value(ix__xmlr *r, ix_attr **attrs, const char *name,
                           int type)
{
    double v;

    switch (type) {
    case IX_ATTR_STRING:
        return set_string(r, attrs, name);
    case IX_ATTR_INT:
        return set_integer(r, attrs, name);
    case IX_ATTR_REAL:
        IX_TRY(ix__xmlr_nums(r, 1, &v));
        return ix__attr_set_real(r->ctx, attrs, name, v);
    default:
        return set_object(r, attrs, name);
    }
}

ix_status ix__xmlr_attribute(ix__xmlr *r, ix_attr **attrs, int *count)
{
    static const char *const types[] = {"string", "integer", "real", "object"};
    const ix_attr *first = *attrs;
    ix_mark mk = ix__scratch_mark(r->ctx);
    char *name;
    int type;
    ix_status st;

    if (++*count > MAX_ATTRS)
        return ix__xml_fail(r->x, r->e.at, "more than %d attributes",
                            MAX_ATTRS);
    IX_TRY(ix__xmlr_allow(r, " name name-hex type encoding "));
    IX_TRY(ix__xmlr_word(r, "type", 4, types, &type));
    if (type != IX_ATTR_STRING && ix__xmlr_attr(r, "encoding"))
        return ix__xml_fail(r->x, r->e.at, "an encoding of a %s", types[type]);
    IX_TRY(ix__xmlr_name(r, "name", &name));
    if (!name)
        return ix__xml_fail(r->x, r->e.at, "an attribute needs a name");
    st = set_value(r, attrs, name, type);
    if (st == IX_OK && *attrs != first)
        ix__attr_first_to_last(attrs); /* the file's order */
    ix__scratch_release(r->ctx, mk);
    return st;
}

/* --- objects ---------------------------------------------------------- */

static ix_status read_children(ix__xmlr *r, ix_attr **attrs, body *b)
{
    int count = 0;
    bool more;

    for (;;) {
        IX_TRY(ix__xmlr_child(r, &more));
        if (!more)
            return finish_body(r->ctx, b);
        if (ix__xmlr_is(r, "object"))
            IX_TRY(add_object(r, b));
        else if (ix__xmlr_is(r, "attribute") && !b->o && !b->e)
            IX_TRY(ix__xmlr_attribute(r, attrs, &count));
        else
            IX_TRY(add_entity(r, b));
    }
}

static ix_status read_object(ix__xmlr *r, ix_attr **attrs, body *b)
{
    char *name;

    IX_TRY(ix__poll(r->ctx));
    IX_TRY(ix__xmlr_allow(r, " name name-hex "));
    IX_TRY(ix__xmlr_name(r, "name", &name));
    IX_TRY(read_children(r, attrs, b));
    b->o->attrs = *attrs;
    *attrs = NULL;
    return ix__obj_set_name(r->ctx, b->o, name);
}

ix_status ix__xmlr_object(ix__xmlr *r, ix_obj **out)
{
    ix_mark mk = ix__scratch_mark(r->ctx);
    ix_attr *attrs = NULL;
    body b = {0};
    ix_status st;

    ix__buf_init(&b.text, r->ctx);
    st = read_object(r, &attrs, &b);
    for (int i = 0; i < b.n; i++)
        drop_one(r->ctx, b.e->type, b.item[i]);
    ix__buf_free(&b.text);
    ix__attr_free_all(r->ctx, &attrs);
    ix__scratch_release(r->ctx, mk);
    if (st != IX_OK)
        ix__obj_unref(r->ctx, b.o);
    *out = st == IX_OK ? b.o : NULL;
    return st;
}

/* --- files ------------------------------------------------------------ */

static ix_status open_root(ix__xmlr *r)
{
    const char *version;
    bool more;

    IX_TRY(ix__xmlr_child(r, &more));
    if (!more || !ix__xmlr_is(r, "iritx"))
        return ix__xmlr_unexpected(r, "iritx");
    IX_TRY(ix__xmlr_allow(r, " version "));
    IX_TRY(ix__xmlr_need(r, "version", &version));
    if (strcmp(version, "1") == 0)
        return IX_OK;
    return ix__xml_fail(r->x, r->e.at, "version %.20s; version 1 is known",
                        version);
}

static ix_status read_objects(ix__xmlr *r, ix_obj *list)
{
    size_t at = r->e.at;
    bool more;
    ix_obj *o;
    ix_status st;

    for (;;) {
        IX_TRY(ix__xmlr_child(r, &more));
        if (!more)
            break;
        if (!ix__xmlr_is(r, "object"))
            return ix__xmlr_unexpected(r, "object");
        IX_TRY(ix__xmlr_object(r, &o));
        st = ix__obj_append(r->ctx, list, o);
        ix__obj_unref(r->ctx, o);
        IX_TRY(st);
    }
    if (list->u.list.n > 0)
        return IX_OK;
    return ix__xml_fail(r->x, at, "file empty: it holds no object");
}

/* Up to the end, so that what follows the root is well-formed, too. */
static ix_status read_file(ix__xmlr *r, ix_obj *list)
{
    ix__xevent e;

    IX_TRY(open_root(r));
    IX_TRY(read_objects(r, list));
    do
        IX_TRY(ix__xml_next(r->x, &e));
    while (e.kind != IX_X_EOF);
    return IX_OK;
}

static ix_status read_with(ix__xmlr *r, ix_obj **out)
{
    ix_obj *list = ix__obj_list(r->ctx);
    ix_status st = list ? read_file(r, list) : IX_ENOMEM;

    /* A single object stands for itself, not for a list of one. */
    if (st == IX_OK)
        *out = ix__obj_ref(list->u.list.n == 1 ? list->u.list.item[0] : list);
    ix__obj_unref(r->ctx, list);
    return st;
}

ix_status ix__xml_read_from(ix__input *src, ix_obj **out)
{
    ix_ctx *ctx = ix__input_ctx(src);
    ix_mark mk = ix__scratch_mark(ctx);
    ix__xmlr r = {.ctx = ctx};
    ix_status st;

    *out = NULL;
    IX_TRY(ix__xml_open(src, &r.x));
    ix__buf_init(&r.text, ctx);
    st = read_with(&r, out);
    ix__buf_free(&r.text);
    ix__xml_close(r.x);
    ix__scratch_release(ctx, mk);
    return st;
}

ix_status ix__xml_read(ix_ctx *ctx, const char *fname, const char *text,
                       size_t n, ix_obj **out)
{
    return ix__input_text(ctx, fname, text, n, ix__xml_read_from, out);
}
