/* ibd_read_geom.c - binary freeforms, polygons, trimmed and triangular
 * surfaces, models (spec/ibd-format 4). */
#include <string.h>

#include "io/gather.h"
#include "io/ibd_read_impl.h"
#include "io/read_rules.h"

/* --- sequences -------------------------------------------------------- */

static void drop_refs(ix_ctx *ctx, ix_obj_type type, const ix__ibdr_refs *refs)
{
    for (int i = 0; i < refs->n; i++)
        ix__seq_unref(ctx, type, refs->item[i]);
}

ix_status ix__ibdr_seq(ix__ibdr *r, ix_obj_type type, ix__ibdr_refs *refs,
                       ix_status st, ix_obj **out)
{
    *out = NULL;
    if (st == IX_OK && refs->n == 0)
        st = ix__ibdr_fail(r, "an object without geometry");
    if (st == IX_OK) {
        *out = ix__seq_new(r->ctx, type, refs->n, refs->item);
        st = *out ? IX_OK : IX_ENOMEM;
    }
    drop_refs(r->ctx, type, refs);
    return st;
}

/* Reads one record; variant is what the object says of all of them. */
typedef ix_status (*read_fn)(ix__ibdr *r, int variant, const void **out);

/* Records of a type up to their END. */
static ix_status sequence(ix__ibdr *r, int record, read_fn read, int variant,
                          ix__ibdr_refs *refs)
{
    for (bool more;;) {
        ix_mark mk;
        ix_status st;

        IX_TRY(ix__ibdr_next(r, record, &more));
        if (!more)
            return IX_OK;
        IX_TRY(ix__gather(r->ctx, refs->n, &refs->cap, sizeof *refs->item,
                          (void *)&refs->item));
        mk = ix__scratch_mark(r->ctx);
        st = read(r, variant, &refs->item[refs->n]);
        ix__scratch_release(r->ctx, mk);
        IX_TRY(st);
        refs->n++;
    }
}

/* --- freeforms -------------------------------------------------------- */

/* Where a block has what. */
typedef struct {
    int record, geometry; /* the code of Bezier; B-spline, power follow */
    size_t block;
    int ndirs;
    size_t length, order, periodic; /* ints, one for each direction */
} layout;

static const layout layouts[] = {
    [IX_OBJ_CURVE] = {IX_IBD_CURVE, 1201, 200, 1, 24, 28, 32},
    [IX_OBJ_SURFACE] = {IX_IBD_SURFACE, 1204, 224, 2, 24, 32, 40},
    [IX_OBJ_TRIVAR] = {IX_IBD_TRIVAR, 1221, 240, 3, 24, 40, 52},
    [IX_OBJ_MULTIVAR] = {IX_IBD_MULTIVAR, 1241, 256, 0, 0, 0, 0},
};

typedef struct {
    ix_basis basis;
    int ndirs, ncoords;
    bool rational;
    ix_dir dirs[IX_MAX_DIRS];
} header;

static ix_status read_point_type(ix__ibdr *r, int code, header *h)
{
    h->ncoords = (code - 1100) / 2 + 1;
    h->rational = code % 2 != 0;
    if (code < 1100 || h->ncoords > IX_MAX_COORDS)
        return ix__ibdr_fail(r, "point type %d", code);
    return IX_OK;
}

/* The lengths, orders and flags of a multivariate follow its block. */
static ix_status multivar_sizes(ix__ibdr *r, const ix__block *k, header *h)
{
    ix__block v;
    size_t n;

    h->ndirs = ix__block_int(k, 24);
    if (h->ndirs < 1 || h->ndirs > IX_MAX_DIRS)
        return ix__ibdr_fail(r, "%d directions", h->ndirs);
    n = (size_t)h->ndirs;
    IX_TRY(ix__ibdr_block(r, &v, 4 * (4 * n + 1)));
    for (size_t d = 0; d < n; d++) {
        h->dirs[d].length = ix__block_int(&v, 4 * d);
        h->dirs[d].order = ix__block_int(&v, 4 * (n + d));
        h->dirs[d].periodic = ix__block_int(&v, 4 * (3 * n + 1 + d)) != 0;
    }
    return ix__ibdr_skip(r, 8 * n);
}

static ix_status check_sizes(ix__ibdr *r, header *h, double *n)
{
    *n = 1;
    for (int d = 0; d < h->ndirs; d++) {
        ix_dir *dir = &h->dirs[d];

        dir->basis = h->basis;
        if (h->basis != IX_BSPLINE)
            dir->order = dir->length;
        if (dir->length < 1 || dir->order < 1 || dir->order > IX_MAX_ORDER ||
            dir->length > INT32_MAX - 2 * IX_MAX_ORDER)
            return ix__ibdr_fail(r, "%d points of order %d", dir->length,
                                 dir->order);
        *n *= dir->length;
    }
    return IX_OK;
}

static ix_status read_header(ix__ibdr *r, const layout *y, header *h, double *n)
{
    ix__block k;
    int code;

    IX_TRY(ix__ibdr_block(r, &k, y->block));
    code = ix__block_int(&k, 16) - y->geometry;
    if (code < 0 || code > 2)
        return ix__ibdr_fail(r, "geometry type %d", code + y->geometry);
    h->basis = code == 0 ? IX_BEZIER : code == 1 ? IX_BSPLINE : IX_POWER;
    IX_TRY(read_point_type(r, ix__block_int(&k, 20), h));
    h->ndirs = y->ndirs;
    if (h->ndirs == 0)
        IX_TRY(multivar_sizes(r, &k, h));
    for (int d = 0; d < y->ndirs; d++) {
        h->dirs[d].length = ix__block_int(&k, y->length + 4 * (size_t)d);
        h->dirs[d].order = ix__block_int(&k, y->order + 4 * (size_t)d);
        h->dirs[d].periodic = ix__block_int(&k, y->periodic + 4 * (size_t)d);
    }
    return check_sizes(r, h, n);
}

/* The file of a periodic multivariate lacks the last order - 1 knots, which the
 * period gives. */
static ix_status multivar_knots(ix__ibdr *r, const ix_dir *dir, double *knots)
{
    int n = dir->length, k = dir->order;
    double period = knots[n + k - 1] - knots[k - 1];

    if (dir->periodic && n < k)
        return ix__ibdr_fail(r, "%d periodic points of order %d", n, k);
    for (int i = n + k; dir->periodic && i < n + 2 * k - 1; i++)
        knots[i] = knots[i - n] + period;
    return IX_OK;
}

static ix_status read_knots(ix__ibdr *r, const layout *y, ix_dir *dir)
{
    int n = ix_knots_count(dir), stored = n;
    double *knots, *all;

    if (y->ndirs == 0)
        stored = dir->length + dir->order;
    IX_TRY(ix__ibdr_array(r, stored, &knots));
    if (n > stored) {
        IX_SCRATCH(r->ctx, all, n);
        memcpy(all, knots, (size_t)stored * sizeof *knots);
        knots = all;
        IX_TRY(multivar_knots(r, dir, knots));
    }
    dir->knots = knots;
    return IX_OK;
}

/* What lower floors refuse as an argument is a malformed record here. */
static ix_status parsed(ix__ibdr *r, ix_status st)
{
    return st == IX_EARG ? ix__ibdr_fail(r, "%s", ix_ctx_message(r->ctx)) : st;
}

static ix_status read_freeform(ix__ibdr *r, int type, const void **out)
{
    const layout *y = &layouts[type];
    header h = {.ndirs = 0};
    double *pts, n = 0;
    ix_mv *m = NULL;

    IX_TRY(read_header(r, y, &h, &n));
    IX_TRY(ix__ibdr_array(r, n * (h.ncoords + h.rational), &pts));
    for (int d = 0; h.basis == IX_BSPLINE && d < h.ndirs; d++)
        IX_TRY(read_knots(r, y, &h.dirs[d]));
    IX_TRY(parsed(
        r, ix_mv_new(r->ctx, h.ndirs, h.dirs, h.ncoords, h.rational, pts, &m)));
    *out = m;
    return IX_OK;
}

ix_status ix__ibdr_mv_seq(ix__ibdr *r, ix_obj_type type, ix__ibdr_refs *refs)
{
    return sequence(r, layouts[type].record, read_freeform, (int)type, refs);
}

ix_status ix__ibdr_mvs(ix__ibdr *r, ix_obj_type type, ix_obj **out)
{
    ix__ibdr_refs refs = {0};
    ix_status st = ix__ibdr_mv_seq(r, type, &refs);

    return ix__ibdr_seq(r, type, &refs, st, out);
}

/* The only freeform of a sequence. */
static ix_status read_one(ix__ibdr *r, ix_obj_type type, const ix_mv **out)
{
    ix__ibdr_refs refs = {0};
    ix_status st = ix__ibdr_mv_seq(r, type, &refs);

    if (st == IX_OK && refs.n != 1)
        st = ix__ibdr_fail(r, "%d freeforms where one is due", refs.n);
    *out = st == IX_OK ? ix_mv_ref(refs.item[0]) : NULL;
    drop_refs(r->ctx, type, &refs);
    return st;
}

/* --- polygons --------------------------------------------------------- */

typedef struct {
    int n, cap;
    ix_polygon *poly;
} polygons;

static ix_status read_vertex(ix__ibdr *r, ix_vertex *v)
{
    ix__block k;

    IX_TRY(ix__ibdr_block(r, &k, 80));
    *v = (ix_vertex){.internal = k.b[24] & 1};
    for (size_t i = 0; i < 3; i++) {
        v->p[i] = ix__block_num(&k, 32 + 8 * i);
        v->normal[i] = ix__block_num(&k, 56 + 8 * i);
        if (!(v->p[i] - v->p[i] == 0))
            return ix__ibdr_fail(r, "a coordinate is not finite");
    }
    v->has_normal = k.b[24] & 2 && ix__poly_unit(v->normal, 3);
    return ix__block_ptr(&k, 8) ? ix__ibdr_attrs(r, &v->attrs) : IX_OK;
}

/* The vertices up to the END; what is in *v is released by the caller. */
static ix_status read_vertices(ix__ibdr *r, ix_vertex **v, int *n)
{
    int cap = 0;

    for (bool more;;) {
        IX_TRY(ix__ibdr_next(r, IX_IBD_VERTEX, &more));
        if (!more)
            return IX_OK;
        IX_TRY(ix__gather(r->ctx, *n, &cap, sizeof **v, (void *)v));
        (*v)[*n] = (ix_vertex){.internal = false};
        ++*n;
        IX_TRY(read_vertex(r, &(*v)[*n - 1]));
    }
}

static ix_status fill_polygon(ix__ibdr *r, ix_polygon *pg)
{
    ix_vertex *v = NULL;
    int n = 0;
    ix_status st = read_vertices(r, &v, &n);

    if (st == IX_OK && n == 0)
        st = ix__ibdr_fail(r, "a polygon without vertices");
    if (st == IX_OK)
        st = ix__poly_vertices(r->ctx, pg, n);
    for (int i = 0; i < n; i++) {
        if (st == IX_OK)
            pg->v[i] = v[i]; /* its attributes move */
        else
            ix__attr_free_all(r->ctx, &v[i].attrs);
    }
    return st;
}

static ix_status read_polygon(ix__ibdr *r, ix_polygon *pg)
{
    ix__block k;

    IX_TRY(ix__ibdr_block(r, &k, 128));
    if (ix__block_ptr(&k, 8))
        IX_TRY(ix__ibdr_attrs(r, &pg->attrs));
    for (size_t i = 0; i < 4; i++)
        pg->plane[i] = ix__block_num(&k, 48 + 8 * i);
    pg->has_plane = k.b[32] & 4 && ix__poly_unit(pg->plane, 4);
    IX_TRY(fill_polygon(r, pg));
    ix__poly_complete(pg);
    return IX_OK;
}

/* One polygon in a block of its own, as the other sequences have theirs. */
static ix_status one_polygon(ix__ibdr *r, int kind, const void **out)
{
    ix_poly *p = ix__poly_new(r->ctx, 1);
    ix_status st = IX_ENOMEM;

    if (p) {
        p->poly[0].kind = (ix_poly_kind)kind;
        st = read_polygon(r, &p->poly[0]);
    }

    if (st == IX_OK)
        *out = p;
    else
        ix__poly_unref(r->ctx, p);
    return st;
}

ix_status ix__ibdr_polys(ix__ibdr *r, ix_poly_kind kind, ix_obj **out)
{
    ix__ibdr_refs refs = {0};
    ix_status st = sequence(r, IX_IBD_POLYGON, one_polygon, (int)kind, &refs);
    ix_poly *p = st == IX_OK ? ix__poly_new(r->ctx, refs.n) : NULL;

    for (int i = 0; i < refs.n; i++) {
        ix_polygon *from = ((const ix_poly *)refs.item[i])->poly;

        if (p) {
            p->poly[i] = *from; /* vertices and attributes move */
            *from = (ix_polygon){.n = 0};
        }
        ix__poly_unref(r->ctx, refs.item[i]);
    }
    IX_TRY(st);
    *out = ix__obj_poly(r->ctx, p);
    return *out ? IX_OK : IX_ENOMEM;
}

/* --- trimmed surfaces ------------------------------------------------- */

/* The curves of a segment, each as one of its own. */
static ix_status read_trimseg(ix__ibdr *r, ix__trimming *trim)
{
    ix__ibdr_refs refs = {0};
    ix_trimseg *s;
    ix_status st;

    IX_TRY(ix__ibdr_skip(r, 32));
    st = ix__ibdr_mv_seq(r, IX_OBJ_CURVE, &refs);
    for (int i = 0; st == IX_OK && i < refs.n; i++) {
        st = ix__trimming_seg(r->ctx, trim, &s);
        if (st == IX_OK)
            s->uv = ix_mv_ref(refs.item[i]);
    }
    drop_refs(r->ctx, IX_OBJ_CURVE, &refs);
    return st;
}

static ix_status read_trimloop(ix__ibdr *r, ix__trimming *trim)
{
    int first = trim->nsegs;

    IX_TRY(ix__ibdr_skip(r, 24));
    for (bool more;;) {
        IX_TRY(ix__ibdr_next(r, IX_IBD_TRIMSEG, &more));
        if (!more)
            break;
        IX_TRY(read_trimseg(r, trim));
    }
    if (trim->nsegs == first)
        return ix__ibdr_fail(r, "a trimming loop without curves");
    return ix__trimming_loop(r->ctx, trim, first);
}

static ix_status read_trimming(ix__ibdr *r, ix__trimming *trim,
                               ix_trimsrf **out)
{
    IX_TRY(ix__ibdr_skip(r, 40));
    IX_TRY(read_one(r, IX_OBJ_SURFACE, &trim->srf));
    for (bool more;;) {
        IX_TRY(ix__ibdr_next(r, IX_IBD_TRIMLOOP, &more));
        if (!more)
            return ix__trimming_make(r->ctx, trim, out);
        IX_TRY(read_trimloop(r, trim));
    }
}

static ix_status read_trimsrf(ix__ibdr *r, int variant, const void **out)
{
    ix__trimming trim = {0};
    ix_trimsrf *made = NULL;
    ix_status st = read_trimming(r, &trim, &made);

    (void)variant;
    ix__trimming_drop(r->ctx, &trim);
    *out = made;
    return st;
}

ix_status ix__ibdr_trimsrfs(ix__ibdr *r, ix_obj **out)
{
    ix__ibdr_refs refs = {0};
    ix_status st = sequence(r, IX_IBD_TRIMSRF, read_trimsrf, 0, &refs);

    return ix__ibdr_seq(r, IX_OBJ_TRIMSRF, &refs, st, out);
}

/* --- triangular surfaces ---------------------------------------------- */

static ix_status check_tri(ix__ibdr *r, int kind, int length, int order)
{
    if (kind < 0 || kind > 2)
        return ix__ibdr_fail(r, "geometry type %d", kind + 1261);
    if (length < (kind == 2 ? 5 : 1) || length > 32767 || order < 1 ||
        order > IX_MAX_ORDER || (kind == 1 && order > length))
        return ix__ibdr_fail(r, "a triangle of %d points a side, order %d",
                             length, order);
    return IX_OK;
}

static ix_status fill_tri(ix__ibdr *r, ix_trisrf *t)
{
    ix_dir dir = {IX_BSPLINE, t->order, t->length, false, t->knots};
    size_t n = (size_t)t->npts * (size_t)(t->ncoords + t->rational);
    double *v;

    IX_TRY(ix__ibdr_array(r, (double)n, &v));
    memcpy(t->pts, v, n * sizeof *v);
    if (t->nknots == 0)
        return IX_OK;
    IX_TRY(ix__ibdr_array(r, t->nknots, &v));
    memcpy(t->knots, v, (size_t)t->nknots * sizeof *v);
    return parsed(r, ix__mv_check_dirs(r->ctx, 1, &dir, 1));
}

static ix_status read_trisrf(ix__ibdr *r, int variant, const void **out)
{
    static const ix_tri_kind kinds[] = {IX_TRI_BEZIER, IX_TRI_BSPLINE,
                                        IX_TRI_GREGORY};
    ix__block k;
    header h;
    int kind, length, order;
    ix_trisrf *t;
    ix_status st;

    (void)variant;
    IX_TRY(ix__ibdr_block(r, &k, 192));
    kind = ix__block_int(&k, 16) - 1261;
    length = ix__block_int(&k, 24);
    order = kind == 1 ? ix__block_int(&k, 28) : length;
    IX_TRY(check_tri(r, kind, length, order));
    IX_TRY(read_point_type(r, ix__block_int(&k, 20), &h));
    t = ix__trisrf_new(r->ctx, kinds[kind], length, order, h.ncoords,
                       h.rational);
    if (!t)
        return IX_ENOMEM;
    st = fill_tri(r, t);
    if (st == IX_OK)
        *out = t;
    else
        ix__trisrf_unref(r->ctx, t);
    return st;
}

ix_status ix__ibdr_trisrfs(ix__ibdr *r, ix_obj **out)
{
    ix__ibdr_refs refs = {0};
    ix_status st = sequence(r, IX_IBD_TRISRF, read_trisrf, 0, &refs);

    return ix__ibdr_seq(r, IX_OBJ_TRISRF, &refs, st, out);
}

/* --- models ----------------------------------------------------------- */

/* Parts of a model as they come: the numbers of both are told by their ENDs. */
typedef struct {
    int nseg, seg_cap, nsrf, srf_cap;
    ix_model_seg *seg;
    struct model_srf {
        const ix_mv *srf;
        int nloops, cap;
        struct loop {
            int n, cap, *ref;
        } * loop;
    } * srf;
} parts;

static ix_status read_model_seg(ix__ibdr *r, ix_model_seg *s)
{
    const ix_mv **const curve[3] = {&s->uv1, &s->uv2, &s->euclid};
    ix__block k;

    IX_TRY(ix__ibdr_block(r, &k, 64));
    s->s1 = (int)ix__block_long(&k, 16);
    s->s2 = (int)ix__block_long(&k, 24);
    for (int i = 0; i < 3; i++) {
        if (!ix__block_ptr(&k, 32 + 8 * (size_t)i))
            continue;
        s->mask |= 1 << i;
        IX_TRY(read_one(r, IX_OBJ_CURVE, curve[i]));
    }
    return IX_OK;
}

static ix_status read_model_segs(ix__ibdr *r, parts *p)
{
    for (bool more;;) {
        IX_TRY(ix__ibdr_next(r, IX_IBD_MODEL_SEG, &more));
        if (!more)
            return IX_OK;
        IX_TRY(ix__gather(r->ctx, p->nseg, &p->seg_cap, sizeof *p->seg,
                          (void *)&p->seg));
        p->seg[p->nseg++] = (ix_model_seg){.mask = 0};
        IX_TRY(read_model_seg(r, &p->seg[p->nseg - 1]));
    }
}

static ix_status read_loop(ix__ibdr *r, struct loop *l)
{
    for (bool more;;) {
        ix__block k;

        IX_TRY(ix__ibdr_next(r, IX_IBD_MODEL_REF, &more));
        if (!more)
            return IX_OK;
        IX_TRY(ix__ibdr_block(r, &k, 32));
        IX_TRY(
            ix__gather(r->ctx, l->n, &l->cap, sizeof *l->ref, (void *)&l->ref));
        l->ref[l->n++] = (int)ix__block_long(&k, 16);
    }
}

static ix_status read_model_srf(ix__ibdr *r, struct model_srf *s)
{
    IX_TRY(ix__ibdr_skip(r, 32));
    IX_TRY(read_one(r, IX_OBJ_SURFACE, &s->srf));
    for (bool more;;) {
        IX_TRY(ix__ibdr_next(r, IX_IBD_MODEL_LOOP, &more));
        if (!more)
            return IX_OK;
        IX_TRY(ix__gather(r->ctx, s->nloops, &s->cap, sizeof *s->loop,
                          (void *)&s->loop));
        s->loop[s->nloops++] = (struct loop){.n = 0};
        IX_TRY(read_loop(r, &s->loop[s->nloops - 1]));
    }
}

static ix_status read_parts(ix__ibdr *r, parts *p)
{
    IX_TRY(read_model_segs(r, p));
    for (bool more;;) {
        IX_TRY(ix__ibdr_next(r, IX_IBD_MODEL_SRF, &more));
        if (!more)
            return p->nsrf > 0 ? IX_OK : ix__ibdr_fail(r, "an empty model");
        IX_TRY(ix__gather(r->ctx, p->nsrf, &p->srf_cap, sizeof *p->srf,
                          (void *)&p->srf));
        p->srf[p->nsrf++] = (struct model_srf){.nloops = 0};
        IX_TRY(read_model_srf(r, &p->srf[p->nsrf - 1]));
    }
}

static void drop_parts(ix_ctx *ctx, parts *p)
{
    for (int i = 0; i < p->nseg; i++) {
        ix_mv_unref(ctx, p->seg[i].uv1);
        ix_mv_unref(ctx, p->seg[i].uv2);
        ix_mv_unref(ctx, p->seg[i].euclid);
    }
    for (int i = 0; i < p->nsrf; i++)
        ix_mv_unref(ctx, p->srf[i].srf);
}

/* Every index in a model names something. */
static ix_status check_parts(ix__ibdr *r, const parts *p)
{
    for (int i = 0; i < p->nseg; i++)
        if (p->seg[i].s1 < 0 || p->seg[i].s1 > p->nsrf || p->seg[i].s2 < 0 ||
            p->seg[i].s2 > p->nsrf)
            return ix__ibdr_fail(r, "segment %d lies on surface %d or %d of %d",
                                 i + 1, p->seg[i].s1, p->seg[i].s2, p->nsrf);
    for (int i = 0; i < p->nsrf; i++)
        for (int j = 0; j < p->srf[i].nloops; j++)
            for (int k = 0; k < p->srf[i].loop[j].n; k++) {
                int ref = p->srf[i].loop[j].ref[k];

                if (ref == 0 || ref < -p->nseg || ref > p->nseg)
                    return ix__ibdr_fail(r, "segment %d of %d", ref, p->nseg);
            }
    return IX_OK;
}

static ix_status fill_model_srf(ix__ibdr *r, struct model_srf *from,
                                ix_model_srf *s)
{
    IX_TRY(ix__model_loops(r->ctx, s, from->nloops));
    for (int j = 0; j < from->nloops; j++) {
        const struct loop *l = &from->loop[j];

        IX_TRY(ix__model_loop_segs(r->ctx, s, j, l->n));
        if (l->n > 0)
            memcpy(s->seg[j], l->ref, (size_t)l->n * sizeof *l->ref);
    }
    s->srf = from->srf;
    from->srf = NULL; /* has moved */
    return IX_OK;
}

static ix_status fill_model(ix__ibdr *r, parts *p, ix_model *m)
{
    for (int i = 0; i < p->nsrf; i++)
        IX_TRY(fill_model_srf(r, &p->srf[i], &m->srf[i]));
    for (int i = 0; i < p->nseg; i++) {
        m->seg[i] = p->seg[i];
        p->seg[i] = (ix_model_seg){.mask = 0};
    }
    return IX_OK;
}

static ix_status make_model(ix__ibdr *r, parts *p, const void **out)
{
    ix_model *m;
    ix_status st;

    IX_TRY(read_parts(r, p));
    IX_TRY(check_parts(r, p));
    m = ix__model_new(r->ctx, p->nsrf, p->nseg);
    if (!m)
        return IX_ENOMEM;
    st = fill_model(r, p, m);
    if (st == IX_OK)
        *out = m;
    else
        ix__model_unref(r->ctx, m);
    return st;
}

static ix_status read_model(ix__ibdr *r, int variant, const void **out)
{
    parts p = {.nseg = 0};
    ix_status st = make_model(r, &p, out);

    (void)variant;
    drop_parts(r->ctx, &p);
    return st;
}

ix_status ix__ibdr_models(ix__ibdr *r, ix_obj **out)
{
    ix__ibdr_refs refs = {0};
    ix_status st = sequence(r, IX_IBD_MODEL, read_model, 0, &refs);

    return ix__ibdr_seq(r, IX_OBJ_MODEL, &refs, st, out);
}
