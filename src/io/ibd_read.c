/* ibd_read.c - binary records: bytes, sync words, objects, attributes
 * (spec/ibd-format 1-3). */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "io/gather.h"
#include "io/ibd_read_impl.h"
#include "io/text.h"

/* --- bytes ------------------------------------------------------------ */

ix_status ix__ibdr_fail(ix__ibdr *r, const char *fmt, ...)
{
    char text[300];
    va_list ap;

    va_start(ap, fmt);
    (void)vsnprintf(text, sizeof text, fmt, ap);
    va_end(ap);
    return IX_FAIL(r->ctx, IX_EPARSE, "%.150s: byte %zu: %s", r->name, r->at,
                   text);
}

ix_status ix__ibdr_bytes(ix__ibdr *r, void *to, size_t n)
{
    size_t got;

    IX_TRY(r->fill(r->arg, to, n, &got));
    r->at += got;
    return got == n ? IX_OK : ix__ibdr_fail(r, "the data end within a record");
}

ix_status ix__ibdr_skip(ix__ibdr *r, size_t n)
{
    char piece[1024];

    while (n > 0) {
        size_t k = n < sizeof piece ? n : sizeof piece;

        IX_TRY(ix__ibdr_bytes(r, piece, k));
        n -= k;
    }
    return IX_OK;
}

static unsigned long long unsigned_of(const unsigned char *b, int n,
                                      bool swapped)
{
    unsigned long long v = 0;

    for (int i = 0; i < n; i++)
        v |= (unsigned long long)b[swapped ? n - 1 - i : i] << 8 * i;
    return v;
}

static int int_of(const unsigned char *b, bool swapped)
{
    return (int)(int32_t)(uint32_t)unsigned_of(b, 4, swapped);
}

static double num_of(const unsigned char *b, bool swapped)
{
    unsigned long long bits = unsigned_of(b, 8, swapped);
    double v;

    _Static_assert(sizeof v == sizeof bits, "IEEE doubles");
    memcpy(&v, &bits, sizeof v);
    return v;
}

ix_status ix__ibdr_block(ix__ibdr *r, ix__block *k, size_t n)
{
    k->swapped = r->swapped;
    return ix__ibdr_bytes(r, k->b, n);
}

int ix__block_int(const ix__block *k, size_t at)
{
    return int_of(k->b + at, k->swapped);
}

double ix__block_num(const ix__block *k, size_t at)
{
    return num_of(k->b + at, k->swapped);
}

long long ix__block_long(const ix__block *k, size_t at)
{
    return (long long)unsigned_of(k->b + at, 8, k->swapped);
}

bool ix__block_ptr(const ix__block *k, size_t at)
{
    return ix__block_long(k, at) != 0;
}

static ix_status read_int(ix__ibdr *r, int *v)
{
    unsigned char b[4];

    IX_TRY(ix__ibdr_bytes(r, b, sizeof b));
    *v = int_of(b, r->swapped);
    return IX_OK;
}

ix_status ix__ibdr_nums(ix__ibdr *r, size_t n, double *v)
{
    IX_TRY(ix__ibdr_bytes(r, v, n * sizeof *v));
    for (size_t i = 0; i < n; i++) {
        unsigned char b[8];

        memcpy(b, &v[i], sizeof b);
        v[i] = num_of(b, r->swapped);
        if (!isfinite(v[i]))
            return ix__ibdr_fail(r, "a number is not finite");
    }
    return IX_OK;
}

ix_status ix__ibdr_array(ix__ibdr *r, double n, double **out)
{
    static const size_t most = IX_MAX_TEXT / sizeof **out;
    size_t want = (size_t)n, have = 0, cap = 4096;
    double *v, *wider;

    if (!(n >= 0 && n < (double)most))
        return ix__ibdr_fail(r, "%g numbers are too many", n);
    cap = cap < want ? cap : want;
    IX_SCRATCH(r->ctx, v, cap);
    for (;;) {
        IX_TRY(ix__poll(r->ctx));
        IX_TRY(ix__ibdr_nums(r, cap - have, v + have));
        have = cap;
        if (have == want)
            break;
        cap = 2 * cap < want ? 2 * cap : want;
        IX_SCRATCH(r->ctx, wider, cap);
        memcpy(wider, v, have * sizeof *v);
        v = wider;
    }
    *out = v;
    return IX_OK;
}

/* --- sync words, texts ------------------------------------------------ */

ix_status ix__ibdr_sync(ix__ibdr *r, int *type)
{
    unsigned char b[4];
    unsigned word;

    if (r->pushed) {
        r->pushed = false;
        *type = r->type;
        return IX_OK;
    }
    IX_TRY(ix__ibdr_bytes(r, b, sizeof b));
    word = (unsigned)unsigned_of(b, 4, r->swapped);
    if ((word & 0x3fff0000u) != (IX_IBD_SYNC & 0x3fff0000u))
        return ix__ibdr_fail(r, "no record begins here");
    if ((word & 0xff00u) != (IX_IBD_SYNC & 0xff00u))
        return ix__ibdr_fail(r, "the data come from a program with other word "
                                "sizes; only those of 64-bit Linux are read");
    *type = (int)(word & 0xffu);
    return IX_OK;
}

ix_status ix__ibdr_peek(ix__ibdr *r, int *type)
{
    IX_TRY(ix__ibdr_sync(r, type));
    r->pushed = true;
    r->type = *type;
    return IX_OK;
}

ix_status ix__ibdr_expect(ix__ibdr *r, int type)
{
    int got;

    IX_TRY(ix__ibdr_sync(r, &got));
    return got == type ? IX_OK
                       : ix__ibdr_fail(r, "a record of type %d where %d is due",
                                       got, type);
}

ix_status ix__ibdr_next(ix__ibdr *r, int type, bool *more)
{
    int got;

    IX_TRY(ix__ibdr_sync(r, &got));
    *more = got == type;
    return *more || got == IX_IBD_END
               ? IX_OK
               : ix__ibdr_fail(r, "a record of type %d among those of type %d",
                               got, type);
}

ix_status ix__ibdr_text(ix__ibdr *r, char **s)
{
    size_t have = 0, cap = 64, want;
    char *wider;
    int n;

    IX_TRY(read_int(r, &n));
    if (n < 0)
        return ix__ibdr_fail(r, "a text of %d bytes", n);
    want = (size_t)n;
    IX_SCRATCH(r->ctx, *s, cap);
    while (have < want) {
        size_t k = want - have < cap - 1 - have ? want - have : cap - 1 - have;

        IX_TRY(ix__ibdr_bytes(r, *s + have, k));
        have += k;
        if (have == want)
            break;
        IX_SCRATCH(r->ctx, wider, 2 * cap);
        memcpy(wider, *s, have);
        *s = wider;
        cap *= 2;
    }
    (*s)[have] = '\0'; /* the padding behind the text is arbitrary */
    return IX_OK;
}

ix_status ix__ibdr_string(ix__ibdr *r, char **s)
{
    IX_TRY(ix__ibdr_expect(r, IX_IBD_STRING));
    return ix__ibdr_text(r, s);
}

/* --- attributes ------------------------------------------------------- */

enum { A_INT = 1, A_REAL, A_UV, A_STRING, A_OBJECT };

static ix_status set_uv(ix__ibdr *r, ix_attr **attrs, const char *name,
                        const ix__block *k)
{
    float uv[2];
    char text[64];

    for (size_t i = 0; i < 2; i++) {
        uint32_t bits = (uint32_t)ix__block_int(k, 16 + 4 * i);

        memcpy(&uv[i], &bits, sizeof uv[i]);
    }
    (void)snprintf(text, sizeof text, "%g %g", (double)uv[0], (double)uv[1]);
    return ix__attr_set_string(r->ctx, attrs, name, text);
}

static ix_status set_object(ix__ibdr *r, ix_attr **attrs, const char *name)
{
    ix_obj *o;
    int type;
    ix_status st;

    IX_TRY(ix__ibdr_sync(r, &type));
    IX_TRY(ix__ibdr_object(r, type, &o));
    st = ix__attr_set_obj(r->ctx, attrs, name, o);
    ix__obj_unref(r->ctx, o);
    return st;
}

static ix_status read_attr(ix__ibdr *r, ix_attr **attrs)
{
    ix__block k;
    char *name, *s;
    double v;

    IX_TRY(ix__ibdr_string(r, &name));
    IX_TRY(ix__ibdr_block(r, &k, 32));
    switch (ix__block_int(&k, 8)) {
    case A_INT:
        return ix__attr_set_int(r->ctx, attrs, name, ix__block_int(&k, 16));
    case A_REAL:
        v = ix__block_num(&k, 16);
        if (!isfinite(v))
            return ix__ibdr_fail(r, "attribute %.64s is not finite", name);
        return ix__attr_set_real(r->ctx, attrs, name, v);
    case A_UV:
        return set_uv(r, attrs, name, &k);
    case A_STRING:
        IX_TRY(ix__ibdr_string(r, &s));
        return ix__attr_set_string(r->ctx, attrs, name, s);
    case A_OBJECT:
        return set_object(r, attrs, name);
    default:
        return ix__ibdr_fail(r, "attribute %.64s has the unknown type %d", name,
                             ix__block_int(&k, 8));
    }
}

ix_status ix__ibdr_attrs(ix__ibdr *r, ix_attr **attrs)
{
    for (bool more;;) {
        IX_TRY(ix__ibdr_next(r, IX_IBD_ATTR, &more));
        if (!more)
            return IX_OK;
        IX_TRY(read_attr(r, attrs));
        ix__attr_first_to_last(attrs);
    }
}

/* --- objects ---------------------------------------------------------- */

static ix_status made(ix_obj *o, ix_obj **out)
{
    *out = o;
    return o ? IX_OK : IX_ENOMEM;
}

static ix_status block_nums(ix__ibdr *r, const ix__block *k, int n, double *v)
{
    for (int i = 0; i < n; i++) {
        v[i] = ix__block_num(k, IX_IBD_REAL((size_t)i));
        if (!isfinite(v[i]))
            return ix__ibdr_fail(r, "a number is not finite");
    }
    return IX_OK;
}

/* What stands in the block itself. */
static ix_status simple(ix__ibdr *r, const ix__block *k, int type, ix_obj **out)
{
    double v[4] = {0};

    IX_TRY(block_nums(r, k, type == IX_OBJ_PLANE ? 4 : 3, v));
    switch (type) {
    case IX_OBJ_POINT:
        return made(ix__obj_point(r->ctx, v), out);
    case IX_OBJ_VECTOR:
        return made(ix__obj_vector(r->ctx, v), out);
    default:
        return made(ix__obj_plane(r->ctx, v), out);
    }
}

static ix_status number(ix__ibdr *r, const ix__block *k, ix_obj **out)
{
    double v;

    IX_TRY(block_nums(r, k, 1, &v));
    return made(ix__obj_number(r->ctx, v), out);
}

static ix_status ctlpt(ix__ibdr *r, const ix__block *k, ix_obj **out)
{
    int code = ix__block_int(k, 256) - 1100;
    ix_ctlpt p = {.ncoords = code / 2 + 1, .rational = code % 2 != 0};

    if (code < 0 || p.ncoords > IX_MAX_COORDS)
        return ix__ibdr_fail(r, "point type %d", code + 1100);
    for (int i = 0; i < p.ncoords + p.rational; i++) {
        p.v[i] = ix__block_num(k, 104 + 8 * (size_t)(i + !p.rational));
        if (!isfinite(p.v[i]))
            return ix__ibdr_fail(r, "a number is not finite");
    }
    return made(ix__obj_ctlpt(r->ctx, &p), out);
}

static ix_status matrix(ix__ibdr *r, ix_obj **out)
{
    double v[16];

    IX_TRY(ix__ibdr_expect(r, IX_IBD_MATRIX));
    IX_TRY(ix__ibdr_nums(r, 16, v));
    IX_TRY(ix__ibdr_expect(r, IX_IBD_END));
    return made(ix__obj_matrix(r->ctx, v), out);
}

static ix_status string(ix__ibdr *r, ix_obj **out)
{
    char *s;

    IX_TRY(ix__ibdr_string(r, &s));
    IX_TRY(ix__ibdr_expect(r, IX_IBD_END));
    return made(ix__obj_string(r->ctx, s, strlen(s)), out);
}

static ix_status instance(ix__ibdr *r, ix_obj **out)
{
    double v[16];
    char *s;

    IX_TRY(ix__ibdr_expect(r, IX_IBD_INSTANCE));
    IX_TRY(ix__ibdr_nums(r, 16, v));
    IX_TRY(ix__ibdr_text(r, &s));
    IX_TRY(ix__ibdr_expect(r, IX_IBD_END));
    return made(ix__obj_instance(r->ctx, s, v), out);
}

/* The pointers up to a zero one tell how many objects follow. */
static ix_status list_pointers(ix__ibdr *r, int capacity, int *n)
{
    bool open = true;

    *n = 0;
    for (int i = 0; i < capacity; i++) {
        ix__block k;

        IX_TRY(ix__ibdr_block(r, &k, 8));
        open = open && ix__block_ptr(&k, 0);
        *n += open;
    }
    return IX_OK;
}

static ix_status list_items(ix__ibdr *r, ix_obj *list, int n)
{
    for (int i = 0; i < n; i++) {
        ix_obj *o;
        int type;
        ix_status st;

        IX_TRY(ix__ibdr_sync(r, &type));
        IX_TRY(ix__ibdr_object(r, type, &o));
        st = ix__obj_append(r->ctx, list, o);
        ix__obj_unref(r->ctx, o);
        IX_TRY(st);
    }
    return IX_OK;
}

static ix_status list(ix__ibdr *r, const ix__block *k, ix_obj **out)
{
    ix_obj *l;
    int n;
    ix_status st;

    IX_TRY(ix__ibdr_expect(r, IX_IBD_LIST));
    IX_TRY(list_pointers(r, ix__block_int(k, 96), &n));
    IX_TRY(made(ix__obj_list(r->ctx), &l));
    st = list_items(r, l, n);
    if (st == IX_OK)
        *out = l;
    else
        ix__obj_unref(r->ctx, l);
    return st;
}

static ix_status payload(ix__ibdr *r, const ix__block *k, int type,
                         ix_obj **out)
{
    switch (type) {
    case IX_OBJ_POLY:
        return ix__ibdr_polys(r, (ix_poly_kind)(ix__block_int(k, 28) & 3), out);
    case IX_OBJ_NUMBER:
        return number(r, k, out);
    case IX_OBJ_POINT:
    case IX_OBJ_VECTOR:
    case IX_OBJ_PLANE:
        return simple(r, k, type, out);
    case IX_OBJ_MATRIX:
        return matrix(r, out);
    case IX_OBJ_STRING:
        return string(r, out);
    case IX_OBJ_LIST:
        return list(r, k, out);
    case IX_OBJ_CTLPT:
        return ctlpt(r, k, out);
    case IX_OBJ_TRIMSRF:
        return ix__ibdr_trimsrfs(r, out);
    case IX_OBJ_INSTANCE:
        return instance(r, out);
    case IX_OBJ_TRISRF:
        return ix__ibdr_trisrfs(r, out);
    case IX_OBJ_MODEL:
        return ix__ibdr_models(r, out);
    default:
        return ix__ibdr_mvs(r, (ix_obj_type)type, out);
    }
}

static ix_status object(ix__ibdr *r, int type, ix_attr **attrs, ix_obj **out)
{
    ix__block k;
    char *name;

    IX_TRY(ix__poll(r->ctx));
    IX_TRY(ix__ibdr_block(r, &k, IX_IBD_OBJECT));
    if (ix__block_int(&k, 32) != type)
        return ix__ibdr_fail(r, "an object of type %d in a record of type %d",
                             ix__block_int(&k, 32), type);
    IX_TRY(ix__ibdr_string(r, &name));
    IX_TRY(ix__ibdr_expect(r, IX_IBD_END));
    if (ix__block_ptr(&k, 8))
        IX_TRY(ix__ibdr_attrs(r, attrs));
    IX_TRY(payload(r, &k, type, out));
    (*out)->attrs = *attrs;
    *attrs = NULL;
    return ix__obj_set_name(r->ctx, *out, name);
}

ix_status ix__ibdr_object(ix__ibdr *r, int type, ix_obj **out)
{
    ix_mark mk = ix__scratch_mark(r->ctx);
    ix_attr *attrs = NULL;
    ix_status st;

    *out = NULL;
    if (type < IX_OBJ_POLY || type > IX_OBJ_MULTIVAR)
        return ix__ibdr_fail(r, "a record of type %d where an object is due",
                             type);
    if (r->depth == IX_MAX_DEPTH)
        return ix__ibdr_fail(r, "objects nested deeper than %d", IX_MAX_DEPTH);
    r->depth++;
    st = object(r, type, &attrs, out);
    r->depth--;
    ix__attr_free_all(r->ctx, &attrs);
    ix__scratch_release(r->ctx, mk);
    if (st != IX_OK) {
        ix__obj_unref(r->ctx, *out);
        *out = NULL;
    }
    return st;
}

/* --- files ------------------------------------------------------------ */

/* The byte order, by the first sync word. */
static void find_order(ix__ibdr *r, const unsigned char *b)
{
    unsigned word = (unsigned)unsigned_of(b, 4, true);

    r->swapped = (word & 0x3fff0000u) == (IX_IBD_SYNC & 0x3fff0000u);
}

static ix_status fill_from_text(void *arg, char *to, size_t room, size_t *n)
{
    ix__text *t = arg;

    for (*n = 0; *n < room;) {
        size_t k;

        IX_TRY(ix__text_ahead(t, 1));
        k = (size_t)(t->end - t->p);
        if (k == 0)
            break;
        k = k < room - *n ? k : room - *n;
        memcpy(to + *n, t->p, k);
        t->p += k;
        *n += k;
    }
    return IX_OK;
}

static ix_status read_all(ix__ibdr *r, ix__text *t, ix_obj *all)
{
    for (;;) {
        ix_obj *o;
        int type;
        ix_status st;

        IX_TRY(ix__text_ahead(t, 1));
        if (t->p == t->end)
            break;
        IX_TRY(ix__ibdr_sync(r, &type));
        IX_TRY(ix__ibdr_object(r, type, &o));
        st = ix__obj_append(r->ctx, all, o);
        ix__obj_unref(r->ctx, o);
        IX_TRY(st);
    }
    return all->u.list.n > 0 ? IX_OK : ix__ibdr_fail(r, "no object");
}

static ix_status read_file(ix__input *s, ix__text *t, ix_obj **out)
{
    ix__ibdr r = {.ctx = t->ctx,
                  .name = ix__input_name(s),
                  .fill = fill_from_text,
                  .arg = t};
    ix_obj *all;
    ix_status st;

    IX_TRY(ix__text_ahead(t, 4));
    if (t->end - t->p >= 4)
        find_order(&r, (const unsigned char *)t->p);
    IX_TRY(made(ix__obj_list(r.ctx), &all));
    st = read_all(&r, t, all);
    if (st == IX_OK)
        *out = ix__obj_ref(all->u.list.n == 1 ? all->u.list.item[0] : all);
    ix__obj_unref(r.ctx, all);
    return st;
}

ix_status ix__ibd_read_from(ix__input *s, ix_obj **out)
{
    ix__text t;
    ix_status st;

    *out = NULL;
    st = ix__text_init(&t, s);
    if (st == IX_OK)
        st = read_file(s, &t, out);
    ix__text_free(&t);
    return st;
}

ix_status ix__ibd_read_one(ix_ctx *ctx, const char *name, ix__fill_fn fill,
                           void *arg, ix_obj **out)
{
    ix__ibdr r = {.ctx = ctx, .name = name, .fill = fill, .arg = arg};
    int type;

    *out = NULL;
    IX_TRY(ix__ibdr_sync(&r, &type));
    return ix__ibdr_object(&r, type, out);
}
