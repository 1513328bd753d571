/* ibd_write.c - binary records of objects (spec/ibd-format). Zero where IRIT
 * would have a pointer or a value that readers ignore, 1 for a pointer whose
 * target follows. The recursion over lists and object attributes is bounded:
 * ix__ibd_write checks the depth before it starts. */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "io/ibd.h"
#include "io/write_text.h"
#include "mv/mv.h"

typedef struct {
    ix_buf *b;
    size_t start;
    bool nonfinite, peer;
    bool lost_curves, lost_knots; /* what the format has no place for */
} writer;

/* --- bytes ------------------------------------------------------------ */

typedef struct {
    unsigned char b[IX_IBD_OBJECT];
} block;

static void put(unsigned char *to, unsigned long long v, int n)
{
    for (int i = 0; i < n; i++)
        to[i] = (unsigned char)(v >> 8 * i);
}

static void put_int(block *k, size_t at, long long v)
{
    put(k->b + at, (unsigned long long)v, 4);
}

static void put_long(block *k, size_t at, long long v)
{
    put(k->b + at, (unsigned long long)v, 8);
}

static unsigned long long bits_of(writer *w, double v)
{
    unsigned long long bits;

    if (!isfinite(v))
        w->nonfinite = true;
    memcpy(&bits, &v, sizeof bits);
    return bits;
}

static void put_num(writer *w, block *k, size_t at, double v)
{
    put(k->b + at, bits_of(w, v), 8);
}

static void add_block(writer *w, const block *k, size_t n)
{
    ix__buf_add(w->b, (const char *)k->b, n);
}

static void add_int(writer *w, unsigned v)
{
    unsigned char b[4];

    put(b, v, 4);
    ix__buf_add(w->b, (const char *)b, sizeof b);
}

static void sync(writer *w, int type)
{
    add_int(w, IX_IBD_SYNC | (unsigned)type);
}

static ix_status check(const writer *w)
{
    return ix__write_check(w->b, w->start, w->nonfinite);
}

static ix_status add_nums(writer *w, size_t n, const double *v)
{
    for (size_t i = 0; i < n; i++) {
        unsigned char b[8];

        if (i % 4096 == 0)
            IX_TRY(check(w));
        put(b, bits_of(w, v[i]), 8);
        ix__buf_add(w->b, (const char *)b, sizeof b);
    }
    return IX_OK;
}

static ix_status end(writer *w)
{
    sync(w, IX_IBD_END);
    return check(w);
}

/* Its length with a zero byte, rounded up to 8. */
static void add_text(writer *w, const char *s)
{
    size_t n = s ? strlen(s) : 0, room = (n + 8) / 8 * 8;

    add_int(w, (unsigned)room);
    ix__buf_add(w->b, s ? s : "", n);
    ix__buf_fill(w->b, '\0', room - n);
}

static void add_string(writer *w, const char *s)
{
    sync(w, IX_IBD_STRING);
    add_text(w, s);
}

/* --- attributes ------------------------------------------------------- */

static ix_status add_object(writer *w, const ix_obj *o);

/* Names with an underscore in front stay inside a program. */
static bool travels(const ix_attr *a)
{
    return a->name[0] != '_';
}

static bool any_travels(const ix_attr *a)
{
    for (; a; a = a->next)
        if (travels(a))
            return true;
    return false;
}

static ix_status add_attr(writer *w, const ix_attr *a)
{
    bool small = a->i >= INT_MIN && a->i <= INT_MAX;
    block k = {{0}};

    sync(w, IX_IBD_ATTR);
    add_string(w, a->name);
    switch (a->type) {
    case IX_ATTR_INT:
        put_int(&k, 8, small ? 1 : 2);
        if (small)
            put_int(&k, 16, a->i);
        else
            put_num(w, &k, 16, (double)a->i);
        break;
    case IX_ATTR_REAL:
        put_int(&k, 8, 2);
        put_num(w, &k, 16, a->r);
        break;
    case IX_ATTR_STRING:
        put_int(&k, 8, 4);
        put_long(&k, 16, 1);
        break;
    case IX_ATTR_OBJ:
        put_int(&k, 8, 5);
        put_long(&k, 16, 1);
        break;
    }
    add_block(w, &k, 32);
    if (a->type == IX_ATTR_STRING)
        add_string(w, a->s);
    return a->type == IX_ATTR_OBJ ? add_object(w, a->obj) : IX_OK;
}

static ix_status add_attrs(writer *w, const ix_attr *attrs)
{
    if (!any_travels(attrs))
        return IX_OK;
    for (const ix_attr *a = attrs; a; a = a->next)
        if (travels(a))
            IX_TRY(add_attr(w, a));
    return end(w);
}

/* --- freeforms -------------------------------------------------------- */

static int point_type(int ncoords, bool rational)
{
    return 1100 + 2 * (ncoords - 1) + rational;
}

/* Where the blocks of curves, surfaces, trivariates have their parts. */
typedef struct {
    int record, geometry;
    size_t block, length, order, periodic;
    size_t points, knots; /* pointers */
} layout;

static const layout layouts[] = {
    [IX_OBJ_CURVE] = {IX_IBD_CURVE, 1201, 200, 24, 28, 32, 40, 192},
    [IX_OBJ_SURFACE] = {IX_IBD_SURFACE, 1204, 224, 24, 32, 40, 48, 200},
    [IX_OBJ_TRIVAR] = {IX_IBD_TRIVAR, 1221, 240, 24, 40, 52, 64, 216},
};

static int basis_code(ix_basis b)
{
    return b == IX_BEZIER ? 0 : b == IX_BSPLINE ? 1 : 2;
}

/* A pointer for each axis, at the place of its coordinate. */
static void point_pointers(block *k, size_t at, const ix_mv *m)
{
    int first = m->rational ? 0 : 1;

    for (int i = first; i <= m->ncoords; i++)
        put_long(k, at + 8 * (size_t)i, 1);
}

static ix_status add_knots(writer *w, const ix_dir *dir, int n)
{
    return dir->basis == IX_BSPLINE ? add_nums(w, (size_t)n, dir->knots)
                                    : IX_OK;
}

static void add_sizes(writer *w, block *k, const layout *y, const ix_mv *m)
{
    for (size_t d = 0; d < (size_t)m->ndirs; d++) {
        const ix_dir *dir = &m->dirs[d];

        put_int(k, y->length + 4 * d, dir->length);
        put_int(k, y->order + 4 * d, dir->order);
        put_int(k, y->periodic + 4 * d, dir->periodic);
        put_long(k, y->knots + 8 * d, dir->basis == IX_BSPLINE);
    }
    if (y->record == IX_IBD_TRIVAR) /* points of a layer */
        put_int(k, 36, (long long)m->dirs[0].length * m->dirs[1].length);
    add_block(w, k, y->block);
}

static size_t all_points(const ix_mv *m)
{
    return m->npts * (size_t)(m->ncoords + m->rational);
}

static ix_status add_freeform(writer *w, ix_obj_type type, const ix_mv *m)
{
    const layout *y = &layouts[type];
    block k = {{0}};

    sync(w, y->record);
    put_int(&k, 16, y->geometry + basis_code(m->dirs[0].basis));
    put_int(&k, 20, point_type(m->ncoords, m->rational));
    point_pointers(&k, y->points, m);
    add_sizes(w, &k, y, m);
    IX_TRY(add_nums(w, all_points(m), m->pts));
    for (int d = 0; d < m->ndirs; d++)
        IX_TRY(add_knots(w, &m->dirs[d], ix_knots_count(&m->dirs[d])));
    return IX_OK;
}

/* Lengths, orders, steps of the points' index, flags, pointers to knots. */
static void add_multivar_sizes(writer *w, const ix_mv *m)
{
    unsigned step = 1;
    size_t n = (size_t)m->ndirs;

    for (size_t d = 0; d < n; d++)
        add_int(w, (unsigned)m->dirs[d].length);
    for (size_t d = 0; d < n; d++)
        add_int(w, (unsigned)m->dirs[d].order);
    add_int(w, step);
    for (size_t d = 0; d < n; d++)
        add_int(w, step *= (unsigned)m->dirs[d].length);
    for (size_t d = 0; d < n; d++)
        add_int(w, m->dirs[d].periodic);
    for (size_t d = 0; d < n; d++) {
        add_int(w, m->dirs[d].basis == IX_BSPLINE);
        add_int(w, 0);
    }
}

/* The file lacks the last order - 1 knots of a periodic direction: readers
 * repeat the others. */
static bool repeats(const ix_dir *dir)
{
    int n = dir->length, k = dir->order;
    double period = dir->knots[n + k - 1] - dir->knots[k - 1];

    for (int i = n + k; i < n + 2 * k - 1; i++)
        if (dir->knots[i] != dir->knots[i - n] + period)
            return false;
    return true;
}

static ix_status add_multivar(writer *w, const ix_mv *m)
{
    static const size_t pointers[] = {32, 40, 48, 56, 224};
    block k = {{0}};

    sync(w, IX_IBD_MULTIVAR);
    put_int(&k, 16, 1241 + basis_code(m->dirs[0].basis));
    put_int(&k, 20, point_type(m->ncoords, m->rational));
    put_int(&k, 24, m->ndirs);
    for (size_t i = 0; i < sizeof pointers / sizeof *pointers; i++)
        put_long(&k, pointers[i], 1);
    point_pointers(&k, 64, m);
    add_block(w, &k, 256);
    add_multivar_sizes(w, m);
    IX_TRY(add_nums(w, all_points(m), m->pts));
    for (int d = 0; d < m->ndirs; d++) {
        const ix_dir *dir = &m->dirs[d];

        IX_TRY(add_knots(w, dir, dir->length + dir->order));
        w->lost_knots |= dir->periodic && !repeats(dir);
    }
    return IX_OK;
}

static ix_status add_mvs(writer *w, ix_obj_type type, int n,
                         const ix_mv *const *mv)
{
    for (int i = 0; i < n; i++)
        IX_TRY(type == IX_OBJ_MULTIVAR ? add_multivar(w, mv[i])
                                       : add_freeform(w, type, mv[i]));
    return end(w);
}

/* --- polygons --------------------------------------------------------- */

static ix_status add_vertex(writer *w, const ix_vertex *v)
{
    block k = {{0}};

    sync(w, IX_IBD_VERTEX);
    put_long(&k, 8, any_travels(v->attrs));
    k.b[24] = (unsigned char)((v->internal ? 1 : 0) | (v->has_normal ? 2 : 0));
    for (size_t i = 0; i < 3; i++) {
        put_num(w, &k, 32 + 8 * i, v->p[i]);
        put_num(w, &k, 56 + 8 * i, v->has_normal ? v->normal[i] : 0);
    }
    add_block(w, &k, 80);
    return add_attrs(w, v->attrs);
}

static ix_status add_polygon(writer *w, const ix_polygon *pg)
{
    block k = {{0}};

    sync(w, IX_IBD_POLYGON);
    put_long(&k, 8, any_travels(pg->attrs));
    put_long(&k, 16, 1);
    k.b[32] = (unsigned char)((pg->has_plane ? 4 : 0) |
                              (pg->kind == IX_POLYSTRIP ? 8 : 0));
    for (size_t i = 0; pg->has_plane && i < 4; i++)
        put_num(w, &k, 48 + 8 * i, pg->plane[i]);
    add_block(w, &k, 128);
    IX_TRY(add_attrs(w, pg->attrs));
    for (int i = 0; i < pg->n; i++) {
        if (i % 1024 == 0)
            IX_TRY(check(w));
        IX_TRY(add_vertex(w, &pg->v[i]));
    }
    return end(w);
}

/* The object tells the kind of all of them. */
static ix_status add_polys(writer *w, const ix_poly *p)
{
    for (int i = 0; i < p->n; i++) {
        if (p->poly[i].kind != p->poly[0].kind)
            return IX_FAIL(w->b->ctx, IX_EUNABLE,
                           "an object holds both polygons and polylines or "
                           "points; a binary file can hold one kind of them");
        IX_TRY(add_polygon(w, &p->poly[i]));
    }
    return end(w);
}

/* --- trimmed and triangular surfaces ---------------------------------- */

static ix_status add_trimsrf(writer *w, const ix_trimsrf *t)
{
    block k = {{0}};

    sync(w, IX_IBD_TRIMSRF);
    put_long(&k, 24, 1);
    put_long(&k, 32, t->nloops > 0);
    add_block(w, &k, 40);
    IX_TRY(add_mvs(w, IX_OBJ_SURFACE, 1, &t->srf));
    memset(&k, 0, sizeof k);
    for (int i = 0; i < t->nloops; i++) {
        sync(w, IX_IBD_TRIMLOOP);
        add_block(w, &k, 24);
        for (int j = 0; j < t->loop[i].n; j++) {
            sync(w, IX_IBD_TRIMSEG);
            add_block(w, &k, 32);
            w->lost_curves |= t->loop[i].seg[j].euclid != NULL;
            IX_TRY(add_mvs(w, IX_OBJ_CURVE, 1, &t->loop[i].seg[j].uv));
        }
        IX_TRY(end(w));
    }
    return end(w);
}

static ix_status add_trisrf(writer *w, const ix_trisrf *t)
{
    static const int codes[] = {[IX_TRI_BEZIER] = 1261,
                                [IX_TRI_BSPLINE] = 1262,
                                [IX_TRI_GREGORY] = 1263};
    block k = {{0}};

    sync(w, IX_IBD_TRISRF);
    put_int(&k, 16, codes[t->kind]);
    put_int(&k, 20, point_type(t->ncoords, t->rational));
    put_int(&k, 24, t->length);
    put_int(&k, 28, t->order);
    for (int i = t->rational ? 0 : 1; i <= t->ncoords; i++)
        put_long(&k, 32 + 8 * (size_t)i, 1);
    put_long(&k, 184, t->nknots > 0);
    add_block(w, &k, 192);
    IX_TRY(add_nums(w, (size_t)t->npts * (size_t)(t->ncoords + t->rational),
                    t->pts));
    return add_nums(w, (size_t)t->nknots, t->knots);
}

/* --- models ----------------------------------------------------------- */

static ix_status add_model_seg(writer *w, const ix_model_seg *s)
{
    const ix_mv *const curve[3] = {s->uv1, s->uv2, s->euclid};
    block k = {{0}};

    sync(w, IX_IBD_MODEL_SEG);
    put_long(&k, 16, s->s1);
    put_long(&k, 24, s->s2);
    for (size_t i = 0; i < 3; i++)
        put_long(&k, 32 + 8 * i, curve[i] != NULL);
    add_block(w, &k, 64);
    for (int i = 0; i < 3; i++)
        if (curve[i])
            IX_TRY(add_mvs(w, IX_OBJ_CURVE, 1, &curve[i]));
    return IX_OK;
}

static ix_status add_model_srf(writer *w, const ix_model_srf *s)
{
    block k = {{0}};

    sync(w, IX_IBD_MODEL_SRF);
    put_long(&k, 16, 1);
    put_long(&k, 24, s->nloops > 0);
    add_block(w, &k, 32);
    IX_TRY(add_mvs(w, IX_OBJ_SURFACE, 1, &s->srf));
    for (int i = 0; i < s->nloops; i++) {
        sync(w, IX_IBD_MODEL_LOOP);
        for (int j = 0; j < s->nseg[i]; j++) {
            block ref = {{0}};

            sync(w, IX_IBD_MODEL_REF);
            put_long(&ref, 16, s->seg[i][j]);
            add_block(w, &ref, 32);
        }
        IX_TRY(end(w));
    }
    return end(w);
}

static ix_status add_model(writer *w, const ix_model *m)
{
    sync(w, IX_IBD_MODEL);
    for (int i = 0; i < m->nseg; i++)
        IX_TRY(add_model_seg(w, &m->seg[i]));
    IX_TRY(end(w));
    for (int i = 0; i < m->nsrf; i++)
        IX_TRY(add_model_srf(w, &m->srf[i]));
    return end(w);
}

/* --- objects ---------------------------------------------------------- */

/* Values that stand in the object's block, and what else it says. */
static ix_status fill_block(writer *w, const ix_obj *o, block *k)
{
    static const int tags[] = {[IX_POLYGON] = 0,
                               [IX_POLYLINE] = 1,
                               [IX_POINTLIST] = 2,
                               [IX_POLYSTRIP] = 3};
    int n = o->type == IX_OBJ_NUMBER                              ? 1
            : o->type == IX_OBJ_POINT || o->type == IX_OBJ_VECTOR ? 3
            : o->type == IX_OBJ_PLANE                             ? 4
                                                                  : 0;

    put_long(k, 8, any_travels(o->attrs));
    put_int(k, 24, 1); /* references */
    put_int(k, 32, o->type);
    put_long(k, IX_IBD_REAL(0), 1); /* a pointer, as a rule */
    for (size_t i = 0; i < (size_t)n; i++)
        put_num(w, k, IX_IBD_REAL(i), n == 1 ? o->u.num : o->u.pt[i]);
    if (o->type == IX_OBJ_LIST)
        put_int(k, 96, o->u.list.n + 1);
    if (o->type == IX_OBJ_POLY)
        put_int(k, 28, tags[o->u.poly->poly[0].kind]);
    if (o->type == IX_OBJ_CTLPT) {
        const ix_ctlpt *p = o->u.ctlpt;

        put_long(k, IX_IBD_REAL(0), 0);
        for (int i = 0; i < p->ncoords + p->rational; i++)
            put_num(w, k, 104 + 8 * (size_t)(i + !p->rational), p->v[i]);
        put_int(k, 256, point_type(p->ncoords, p->rational));
    }
    return check(w);
}

/* Pointers up to a zero one, then the objects. */
static ix_status add_list(writer *w, const ix_obj *o)
{
    static const char one[8] = {1};

    sync(w, IX_IBD_LIST);
    for (int i = 0; i < o->u.list.n; i++)
        ix__buf_add(w->b, one, sizeof one);
    ix__buf_fill(w->b, '\0', 8);
    for (int i = 0; i < o->u.list.n; i++)
        IX_TRY(add_object(w, o->u.list.item[i]));
    return IX_OK;
}

static ix_status add_simple(writer *w, const ix_obj *o)
{
    switch (o->type) {
    case IX_OBJ_MATRIX:
        sync(w, IX_IBD_MATRIX);
        IX_TRY(add_nums(w, 16, o->u.mat));
        return end(w);
    case IX_OBJ_STRING:
        add_string(w, o->u.str.s);
        return end(w);
    case IX_OBJ_INSTANCE:
        sync(w, IX_IBD_INSTANCE);
        IX_TRY(add_nums(w, 16, o->u.inst->mat));
        add_text(w, o->u.inst->target);
        return end(w);
    case IX_OBJ_LIST:
        return add_list(w, o);
    default:
        return IX_OK; /* all is in the block */
    }
}

static ix_status add_payload(writer *w, const ix_obj *o)
{
    switch (o->type) {
    case IX_OBJ_CURVE:
    case IX_OBJ_SURFACE:
    case IX_OBJ_TRIVAR:
    case IX_OBJ_MULTIVAR:
        return add_mvs(w, o->type, o->u.mvs->n, o->u.mvs->mv);
    case IX_OBJ_POLY:
        return add_polys(w, o->u.poly);
    case IX_OBJ_TRIMSRF:
        for (int i = 0; i < o->u.trim.n; i++)
            IX_TRY(add_trimsrf(w, o->u.trim.item[i]));
        return end(w);
    case IX_OBJ_TRISRF:
        for (int i = 0; i < o->u.tri.n; i++)
            IX_TRY(add_trisrf(w, o->u.tri.item[i]));
        return end(w);
    case IX_OBJ_MODEL:
        for (int i = 0; i < o->u.model.n; i++)
            IX_TRY(add_model(w, o->u.model.item[i]));
        return end(w);
    default:
        return add_simple(w, o);
    }
}

static ix_status add_object(writer *w, const ix_obj *o)
{
    block k = {{0}};

    if (o->type == IX_OBJ_UNDEF ||
        (o->type == IX_OBJ_POLY && o->u.poly->n == 0))
        return IX_FAIL(w->b->ctx, IX_EUNABLE,
                       "%s is empty, and binary files have no place for that",
                       o->name ? o->name : "an object");
    sync(w, (int)o->type);
    IX_TRY(fill_block(w, o, &k));
    add_block(w, &k, IX_IBD_OBJECT);
    add_string(w, w->peer ? NULL : o->name);
    IX_TRY(end(w));
    IX_TRY(add_attrs(w, o->attrs));
    return add_payload(w, o);
}

ix_status ix__ibd_write(ix_buf *b, const ix_obj *o, const ix_write_opts *opts)
{
    writer w = {.b = b, .start = ix__buf_total(b), .peer = opts && opts->peer};

    IX_TRY(ix__obj_check_size(b->ctx, o, IX_MAX_DEPTH, IX_MAX_TEXT));
    IX_TRY(add_object(&w, o));
    if (w.lost_curves)
        ix__note(b->ctx, "binary files hold no trimming curves in space: they "
                         "are left out");
    if (w.lost_knots)
        ix__note(b->ctx, "binary files hold the last knots of a periodic "
                         "multivariate only as a repetition of the others");
    return ix__buf_check(b);
}
