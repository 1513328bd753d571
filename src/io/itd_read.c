/* itd_read.c - objects, lists and simple entities from text
 * (spec/itd-format 2, 4). The recursion over objects is bounded by
 * IX_MAX_DEPTH; everything else is a loop. */
#include "io/gather.h"
#include "io/itd_read_impl.h"
#include "io/message.h"

/* --- entities --------------------------------------------------------- */

typedef struct {
    const char *word;
    ix_obj_type type;
    int variant; /* the kind of polygon */
} entity;

static const entity entities[] = {
    {"NUMBER", IX_OBJ_NUMBER, 0},
    {"POINT", IX_OBJ_POINT, 0},
    {"VECTOR", IX_OBJ_VECTOR, 0},
    {"PLANE", IX_OBJ_PLANE, 0},
    {"MATRIX", IX_OBJ_MATRIX, 0},
    {"CTLPT", IX_OBJ_CTLPT, 0},
    {"STRING", IX_OBJ_STRING, 0},
    {"INSTANCE", IX_OBJ_INSTANCE, 0},
    {"CURVE", IX_OBJ_CURVE, 0},
    {"SURFACE", IX_OBJ_SURFACE, 0},
    {"TRIVAR", IX_OBJ_TRIVAR, 0},
    {"MULTIVAR", IX_OBJ_MULTIVAR, 0},
    {"POLYGON", IX_OBJ_POLY, IX_POLYGON},
    {"POLYLINE", IX_OBJ_POLY, IX_POLYLINE},
    {"POINTLIST", IX_OBJ_POLY, IX_POINTLIST},
    {"POLYSTRIP", IX_OBJ_POLY, IX_POLYSTRIP},
    {"TRIMSRF", IX_OBJ_TRIMSRF, 0},
    {"TRISRF", IX_OBJ_TRISRF, 0},
    {"MODEL", IX_OBJ_MODEL, 0},
};

static const entity *find_entity(const ix__token *t)
{
    for (size_t i = 0; i < sizeof entities / sizeof *entities; i++)
        if (ix__token_is(t, entities[i].word))
            return &entities[i];
    return NULL;
}

/* The entity's row, by its keyword. */
static ix_status need_entity(ix__lex *l, const ix__token *t, const entity **e)
{
    *e = find_entity(t);
    if (!*e)
        return ix__lex_unexpected(l, t, "an entity such as NUMBER or CURVE");
    return IX_OK;
}

/* --- entities that stand alone ---------------------------------------- */

static ix_status made(ix_obj *o, ix_obj **out)
{
    *out = o;
    return o ? IX_OK : IX_ENOMEM;
}

static ix_status read_numbers(ix__lex *l, const entity *e, ix_obj **out)
{
    int n = e->type == IX_OBJ_NUMBER   ? 1
            : e->type == IX_OBJ_PLANE  ? 4
            : e->type == IX_OBJ_MATRIX ? 16
                                       : 3;
    double v[16];

    IX_TRY(ix__lex_nums(l, "number", n, v));
    switch (e->type) {
    case IX_OBJ_NUMBER:
        return made(ix__obj_number(l->ctx, v[0]), out);
    case IX_OBJ_POINT:
        return made(ix__obj_point(l->ctx, v), out);
    case IX_OBJ_VECTOR:
        return made(ix__obj_vector(l->ctx, v), out);
    case IX_OBJ_PLANE:
        return made(ix__obj_plane(l->ctx, v), out);
    default:
        return made(ix__obj_matrix(l->ctx, v), out);
    }
}

static ix_status read_ctlpt(ix__lex *l, ix_obj **out)
{
    ix_ctlpt p = {0};

    IX_TRY(ix__itdr_point_type(l, &p.ncoords, &p.rational));
    IX_TRY(ix__lex_nums(l, "number", p.ncoords + p.rational, p.v));
    return made(ix__obj_ctlpt(l->ctx, &p), out);
}

static ix_status read_text(ix__lex *l, const char *wanted, char **s, size_t *n)
{
    ix__token t;

    IX_TRY(ix__lex_next(l, &t));
    if (t.kind != IX_T_WORD && t.kind != IX_T_QUOTED)
        return ix__lex_unexpected(l, &t, wanted);
    return ix__token_text(l, &t, s, n);
}

static ix_status read_string(ix__lex *l, ix_obj **out)
{
    char *s;
    size_t n;

    IX_TRY(read_text(l, "text of the STRING", &s, &n));
    return made(ix__obj_string(l->ctx, s, n), out);
}

static ix_status read_instance(ix__lex *l, ix_obj **out)
{
    double mat[16];
    char *s;
    size_t n;

    IX_TRY(read_text(l, "name of the INSTANCE", &s, &n));
    IX_TRY(ix__lex_nums(l, "number of the matrix", 16, mat));
    return made(ix__obj_instance(l->ctx, s, mat), out);
}

static ix_status read_single(ix__lex *l, const entity *e, ix_obj **out)
{
    switch (e->type) {
    case IX_OBJ_CTLPT:
        IX_TRY(read_ctlpt(l, out));
        break;
    case IX_OBJ_STRING:
        IX_TRY(read_string(l, out));
        break;
    case IX_OBJ_INSTANCE:
        IX_TRY(read_instance(l, out));
        break;
    default:
        IX_TRY(read_numbers(l, e, out));
        break;
    }
    return ix__lex_close(l, "] of the entity");
}

/* --- entities in sequences -------------------------------------------- */

/* What the entity readers return. */
typedef struct {
    int n, cap;
    const void **item;
} refs;

static ix_status read_one(ix__lex *l, const entity *e, const void **out)
{
    switch (e->type) {
    case IX_OBJ_POLY:
        return ix__itdr_poly(l, (ix_poly_kind)e->variant, out);
    case IX_OBJ_TRIMSRF:
        return ix__itdr_trimsrf(l, out);
    case IX_OBJ_TRISRF:
        return ix__itdr_trisrf(l, out);
    case IX_OBJ_MODEL:
        return ix__itdr_model(l, out);
    default:
        return ix__itdr_mv(l, e->type, out);
    }
}

static void drop_one(ix_ctx *ctx, ix_obj_type type, const void *p)
{
    if (type == IX_OBJ_POLY)
        ix__poly_unref(ctx, p);
    else
        ix__seq_unref(ctx, type, p);
}

/* Entities of one type, the first behind its keyword, up to a closing bracket
 * or the end, which are left. */
static ix_status read_sequence(ix__lex *l, const entity *e, refs *r)
{
    ix_obj_type type = e->type;
    ix__token open, t;

    for (;;) {
        IX_TRY(ix__gather(l->ctx, r->n, &r->cap, sizeof *r->item,
                          (void *)&r->item));
        IX_TRY(read_one(l, e, &r->item[r->n]));
        r->n++;
        IX_TRY(ix__lex_peek(l, &open));
        if (open.kind != IX_T_OPEN)
            return IX_OK;
        IX_TRY(ix__lex_open(l));
        IX_TRY(ix__lex_next(l, &t));
        IX_TRY(need_entity(l, &t, &e));
        if (e->type != type)
            return ix__lex_fail(l, open.at,
                                "%s in an object of another type; an object "
                                "holds entities of one type",
                                e->word);
    }
}

/* The polygons of single ones, moved into one block. */
static ix_obj *join_polys(ix_ctx *ctx, const refs *r)
{
    ix_poly *p = ix__poly_new(ctx, r->n);

    for (int i = 0; p && i < r->n; i++) {
        ix_polygon *from = ((const ix_poly *)r->item[i])->poly;

        p->poly[i] = *from;
        *from = (ix_polygon){0};
    }
    return ix__obj_poly(ctx, p);
}

static bool is_single(ix_obj_type t)
{
    return t == IX_OBJ_NUMBER || t == IX_OBJ_POINT || t == IX_OBJ_VECTOR ||
           t == IX_OBJ_PLANE || t == IX_OBJ_MATRIX || t == IX_OBJ_CTLPT ||
           t == IX_OBJ_STRING || t == IX_OBJ_INSTANCE;
}

/* The geometry of one object, the first entity behind its keyword, up to a
 * closing bracket or the end. */
static ix_status read_geometry(ix__lex *l, const entity *e, ix_obj **out)
{
    refs r = {0};
    ix_status st;

    if (is_single(e->type))
        return read_single(l, e, out);
    st = read_sequence(l, e, &r);
    if (st == IX_OK)
        st = made(e->type == IX_OBJ_POLY
                      ? join_polys(l->ctx, &r)
                      : ix__seq_new(l->ctx, e->type, r.n, r.item),
                  out);
    for (int i = 0; i < r.n; i++)
        drop_one(l->ctx, e->type, r.item[i]);
    return st;
}

/* --- objects ---------------------------------------------------------- */

/* Objects without a body leave no trace in it: it may be empty. */
static ix_status read_list(ix__lex *l, ix_obj **out)
{
    ix_obj *list = ix__obj_list(l->ctx);
    ix_status st;

    if (!list)
        return IX_ENOMEM;
    st = ix__itdr_objects(l, list, true, "OBJECT");
    if (st == IX_OK)
        *out = ix__obj_ref(list);
    ix__obj_unref(l->ctx, list);
    return st;
}

/* What stands in an object or in the file: NULL if nothing. */
static ix_status read_body(ix__lex *l, ix_obj **out)
{
    const entity *e;
    ix__token t;

    IX_TRY(ix__lex_skip_junk(l, &t));
    if (t.kind != IX_T_OPEN)
        return IX_OK;
    IX_TRY(ix__lex_open(l));
    IX_TRY(ix__lex_next(l, &t));
    if (ix__token_is(&t, "OBJECT"))
        return read_list(l, out);
    IX_TRY(need_entity(l, &t, &e));
    return read_geometry(l, e, out);
}

/* A quoted word in the place of the name leaves the object unnamed. */
static ix_status read_name(ix__lex *l, char **name)
{
    ix__token t;
    size_t n;

    IX_TRY(ix__lex_peek(l, &t));
    if (t.kind != IX_T_WORD && t.kind != IX_T_QUOTED)
        return IX_OK;
    IX_TRY(ix__lex_next(l, &t));
    return t.kind == IX_T_WORD ? ix__token_text(l, &t, name, &n) : IX_OK;
}

static ix_status read_object(ix__lex *l, ix_attr **attrs, ix_obj **out)
{
    char *name = NULL;
    ix_status st;

    IX_TRY(ix__poll(l->ctx));
    IX_TRY(ix__itdr_attrs(l, attrs, NULL, NULL));
    IX_TRY(read_name(l, &name));
    IX_TRY(read_body(l, out));
    if (!*out && l->peer)
        IX_TRY(made(ix__obj_list(l->ctx), out));
    st = ix__lex_close(l, "] of the object");
    if (st != IX_OK || !*out)
        return st;
    (*out)->attrs = *attrs;
    *attrs = NULL;
    return ix__obj_set_name(l->ctx, *out, name);
}

/* The object behind "[OBJECT"; NULL if it is empty. */
static ix_status object_behind(ix__lex *l, ix_obj **out)
{
    ix_mark mk = ix__scratch_mark(l->ctx);
    ix_attr *attrs = NULL;
    ix_status st;

    *out = NULL;
    if (l->depth == IX_MAX_DEPTH)
        return ix__lex_fail(l, ix__lex_at(l), "objects nested deeper than %d",
                            IX_MAX_DEPTH);
    l->depth++;
    st = read_object(l, &attrs, out);
    l->depth--;
    ix__attr_free_all(l->ctx, &attrs);
    ix__scratch_release(l->ctx, mk);
    if (st != IX_OK) {
        ix__obj_unref(l->ctx, *out);
        *out = NULL;
    }
    return st;
}

static ix_status append_object(ix__lex *l, ix_obj *list)
{
    ix_obj *o;
    ix_status st;

    IX_TRY(object_behind(l, &o));
    if (!o)
        return IX_OK;
    st = ix__obj_append(l->ctx, list, o);
    ix__obj_unref(l->ctx, o);
    return st;
}

ix_status ix__itdr_objects(ix__lex *l, ix_obj *list, bool inside,
                           const char *wanted)
{
    ix__token t;

    if (inside)
        IX_TRY(append_object(l, list));
    for (;;) {
        IX_TRY(ix__lex_skip_junk(l, &t));
        if (t.kind != IX_T_OPEN)
            return IX_OK;
        IX_TRY(ix__lex_open(l));
        IX_TRY(ix__lex_next(l, &t));
        if (!ix__token_is(&t, "OBJECT"))
            return ix__lex_unexpected(l, &t, wanted);
        IX_TRY(append_object(l, list));
    }
}

/* --- files ------------------------------------------------------------ */

/* A single object stands for itself, not for a list of one. */
static ix_obj *unwrap(ix_ctx *ctx, ix_obj *o)
{
    ix_obj *only;

    if (o->type != IX_OBJ_LIST || o->u.list.n != 1)
        return o;
    only = ix__obj_ref(o->u.list.item[0]);
    ix__obj_unref(ctx, o);
    return only;
}

/* A surplus ] ends the file quietly, words behind everything are skipped. */
static ix_status read_file(ix__lex *l, ix_obj **out)
{
    ix__token t;

    IX_TRY(read_body(l, out));
    if (!*out || ((*out)->type == IX_OBJ_LIST && (*out)->u.list.n == 0))
        return ix__lex_fail(l, 0, "file empty: it holds no object");
    *out = unwrap(l->ctx, *out);
    IX_TRY(ix__lex_skip_junk(l, &t));
    if (t.kind == IX_T_OPEN)
        return ix__lex_unexpected(l, &t, "end of file");
    return IX_OK;
}

static ix_status read_from(ix__input *src, bool peer, ix_obj **out)
{
    ix_ctx *ctx = ix__input_ctx(src);
    ix_mark mk = ix__scratch_mark(ctx);
    ix__lex l;
    ix_status st;

    *out = NULL;
    st = ix__lex_init(&l, src);
    l.peer = peer;
    if (st == IX_OK)
        st = read_file(&l, out);
    ix__lex_free(&l);
    ix__scratch_release(ctx, mk);
    if (st != IX_OK) {
        ix__obj_unref(ctx, *out);
        *out = NULL;
    }
    return st;
}

ix_status ix__itd_read_from(ix__input *src, ix_obj **out)
{
    return read_from(src, false, out);
}

ix_status ix__itd_read(ix_ctx *ctx, const char *fname, const char *text,
                       size_t n, ix_obj **out)
{
    return ix__input_text(ctx, fname, text, n, ix__itd_read_from, out);
}

static ix_status peer_from(ix__input *src, ix_obj **out)
{
    return read_from(src, true, out);
}

ix_status ix__message_object(const ix__message *m, ix_obj **out)
{
    return ix__input_text(m->text.ctx, "message", m->text.data, m->text.len,
                          peer_from, out);
}
