/* itd_read_brep.c - trimmed surfaces, models and triangular surfaces from text
 * (spec/itd-format 6.4, 7, 8). Curves are kept as they stand in the file. */
#include <string.h>

#include "io/gather.h"
#include "io/itd_read_impl.h"

static ix_status need_bracket(ix__lex *l, const char *word)
{
    ix__token t;

    IX_TRY(ix__lex_open(l));
    IX_TRY(ix__lex_next(l, &t));
    if (!ix__token_is(&t, word))
        return ix__lex_unexpected(l, &t, word);
    return IX_OK;
}

/* --- trimmed surfaces ------------------------------------------------- */

static ix_status read_trimseg(ix__lex *l, ix_trimseg *s)
{
    ix__token t;

    IX_TRY(need_bracket(l, "TRIMCRVSEG"));
    IX_TRY(ix__itdr_whole_mv(l, IX_OBJ_CURVE, &s->uv));
    IX_TRY(ix__lex_peek(l, &t));
    if (t.kind == IX_T_OPEN)
        IX_TRY(ix__itdr_whole_mv(l, IX_OBJ_CURVE, &s->euclid));
    return ix__lex_close(l, "] of TRIMCRVSEG");
}

static ix_status read_trimloop(ix__lex *l, ix__trimming *trim)
{
    int first = trim->nsegs;
    ix__token open, t;
    ix_trimseg *s;

    IX_TRY(ix__lex_peek(l, &open));
    IX_TRY(need_bracket(l, "TRIMCRV"));
    for (;;) {
        IX_TRY(ix__lex_peek(l, &t));
        if (t.kind != IX_T_OPEN)
            break;
        IX_TRY(ix__trimming_seg(l->ctx, trim, &s));
        IX_TRY(read_trimseg(l, s));
    }
    IX_TRY(ix__lex_close(l, "] of TRIMCRV"));
    if (trim->nsegs == first)
        return ix__lex_fail(l, open.at, "TRIMCRV holds no TRIMCRVSEG");
    return ix__trimming_loop(l->ctx, trim, first);
}

static ix_status read_trimsrf(ix__lex *l, ix__trimming *trim, ix_trimsrf **out)
{
    ix__token t;

    IX_TRY(ix__itdr_whole_mv(l, IX_OBJ_SURFACE, &trim->srf));
    for (;;) {
        IX_TRY(ix__lex_peek(l, &t));
        if (t.kind != IX_T_OPEN)
            break;
        IX_TRY(read_trimloop(l, trim));
    }
    IX_TRY(ix__lex_close(l, "] of TRIMSRF"));
    if (trim->nloops == 0)
        ix__lex_warn(l, ix__lex_at(l),
                     "a trimmed surface has no trimming curve");
    return ix__trimming_make(l->ctx, trim, out);
}

ix_status ix__itdr_trimsrf(ix__lex *l, const void **out)
{
    ix_mark mk = ix__scratch_mark(l->ctx);
    ix__trimming trim = {0};
    ix_trimsrf *made = NULL;
    ix_status st = read_trimsrf(l, &trim, &made);

    ix__trimming_drop(l->ctx, &trim);
    ix__scratch_release(l->ctx, mk);
    *out = made;
    return st;
}

/* --- models ----------------------------------------------------------- */

/* The numbers of the segments of a loop, in scratch. */
static ix_status read_refs(ix__lex *l, int nseg, int **ref, int *n)
{
    int cap = 0;
    ix__token t;

    for (*n = 0;; ++*n) {
        IX_TRY(ix__lex_peek(l, &t));
        if (t.kind != IX_T_WORD)
            return ix__lex_close(l, "] of MDLLOOP");
        IX_TRY(ix__gather(l->ctx, *n, &cap, sizeof **ref, (void *)ref));
        IX_TRY(
            ix__lex_int(l, "the index of a segment", -nseg, nseg, *ref + *n));
        if ((*ref)[*n] == 0)
            return ix__lex_fail(l, t.at, "segments are counted from 1");
    }
}

static ix_status fill_loop(ix__lex *l, ix_model_srf *s, int loop, int nseg)
{
    int *ref = NULL, n;

    IX_TRY(need_bracket(l, "MDLLOOP"));
    IX_TRY(read_refs(l, nseg, &ref, &n));
    IX_TRY(ix__model_loop_segs(l->ctx, s, loop, n));
    if (n > 0)
        memcpy(s->seg[loop], ref, (size_t)n * sizeof *ref);
    return IX_OK;
}

static ix_status read_loop(ix__lex *l, ix_model_srf *s, int loop, int nseg)
{
    IX_RETURN_SCOPED(l->ctx, fill_loop(l, s, loop, nseg));
}

static ix_status read_model_srf(ix__lex *l, ix_model *m, ix_model_srf *s)
{
    ix__token open;
    int n;

    IX_TRY(ix__lex_peek(l, &open));
    IX_TRY(need_bracket(l, "MDLTSRF"));
    IX_TRY(ix__lex_int(l, "the number of loops", 0, INT32_MAX, &n));
    IX_TRY(ix__itdr_whole_mv(l, IX_OBJ_SURFACE, &s->srf));
    IX_TRY(ix__lex_room(l, open.at, n, 9, "loops")); /* "[MDLLOOP]" */
    IX_TRY(ix__model_loops(l->ctx, s, n));
    for (int i = 0; i < n; i++)
        IX_TRY(read_loop(l, s, i, m->nseg));
    return ix__lex_close(l, "] of MDLTSRF");
}

static ix_status read_model_seg(ix__lex *l, ix_model *m, ix_model_seg *s)
{
    IX_TRY(need_bracket(l, "MDLTSEG"));
    IX_TRY(ix__lex_int(l, "the mask of a segment", 0, 7, &s->mask));
    IX_TRY(ix__lex_int(l, "the index of a surface", 0, m->nsrf, &s->s1));
    IX_TRY(ix__lex_int(l, "the index of a surface", 0, m->nsrf, &s->s2));
    if (s->mask & 1)
        IX_TRY(ix__itdr_whole_mv(l, IX_OBJ_CURVE, &s->uv1));
    if (s->mask & 2)
        IX_TRY(ix__itdr_whole_mv(l, IX_OBJ_CURVE, &s->uv2));
    if (s->mask & 4)
        IX_TRY(ix__itdr_whole_mv(l, IX_OBJ_CURVE, &s->euclid));
    return ix__lex_close(l, "] of MDLTSEG");
}

static ix_status read_model(ix__lex *l, ix_model *m)
{
    for (int i = 0; i < m->nsrf; i++)
        IX_TRY(read_model_srf(l, m, &m->srf[i]));
    for (int i = 0; i < m->nseg; i++)
        IX_TRY(read_model_seg(l, m, &m->seg[i]));
    return ix__lex_close(l, "] of MODEL");
}

ix_status ix__itdr_model(ix__lex *l, const void **out)
{
    int nsrf, nseg;
    ix__token t;
    ix_model *m;
    ix_status st;

    *out = NULL;
    IX_TRY(ix__lex_peek(l, &t));
    IX_TRY(ix__lex_int(l, "the number of surfaces", 1, INT32_MAX, &nsrf));
    IX_TRY(ix__lex_int(l, "the number of segments", 0, INT32_MAX, &nseg));
    IX_TRY(ix__lex_room(l, t.at, nsrf, 10, "surfaces")); /* "[MDLTSRF 0" ... */
    IX_TRY(ix__lex_room(l, t.at, nseg, 15, "segments")); /* "[MDLTSEG 0 0 0]" */
    m = ix__model_new(l->ctx, nsrf, nseg);
    if (!m)
        return IX_ENOMEM;
    st = read_model(l, m);
    if (st == IX_OK)
        *out = m;
    else
        ix__model_unref(l->ctx, m);
    return st;
}

/* --- triangular surfaces ---------------------------------------------- */

typedef struct {
    size_t at;
    ix_tri_kind kind;
    int length, order, ncoords;
    bool rational;
    ix_dir dir; /* B-spline: for its knots */
} tri_header;

static ix_status read_tri_header(ix__lex *l, tri_header *h)
{
    ix__token t;
    double n;

    IX_TRY(ix__lex_next(l, &t));
    h->at = t.at;
    if (!ix__token_is(&t, "BEZIER") && !ix__token_is(&t, "BSPLINE") &&
        !ix__token_is(&t, "GREGORY"))
        return ix__lex_unexpected(l, &t, "BEZIER, BSPLINE or GREGORY");
    h->kind = ix__token_is(&t, "BEZIER")    ? IX_TRI_BEZIER
              : ix__token_is(&t, "BSPLINE") ? IX_TRI_BSPLINE
                                            : IX_TRI_GREGORY;
    IX_TRY(ix__itdr_drop_attrs(l));
    /* Below 5 the twists of a Gregory patch would not be three points. */
    IX_TRY(ix__lex_int(l, "the number of points of a side",
                       h->kind == IX_TRI_GREGORY ? 5 : 1, 32767, &h->length));
    h->order = h->length;
    if (h->kind == IX_TRI_BSPLINE)
        IX_TRY(ix__lex_int(l, "the order", 1, IX_MAX_ORDER, &h->order));
    IX_TRY(ix__itdr_point_type(l, &h->ncoords, &h->rational));
    n = h->length * (h->length + 1.0) / 2;
    IX_TRY(ix__lex_room(l, h->at, n, 2 * (h->ncoords + h->rational) + 1,
                        "control points"));
    h->dir = (ix_dir){IX_BSPLINE, h->order, h->length, false, NULL};
    if (h->kind != IX_TRI_BSPLINE)
        return IX_OK;
    IX_TRY(ix__lex_peek(l, &t));
    IX_TRY(ix__itdr_knots(l, &h->dir, 0));
    if (h->dir.periodic)
        return ix__lex_fail(l, t.at, "KV expected in a triangular surface");
    return IX_OK;
}

/* Is mesh point i the twist number *k of a Gregory patch? */
static bool is_twist(const ix_trisrf *t, int i, int *k)
{
    const int at[3] = {t->length + 1, 2 * t->length - 3,
                       t->length * (t->length + 1) / 2 - 5};

    if (t->kind != IX_TRI_GREGORY)
        return false;
    for (*k = 0; *k < 3 && at[*k] != i;)
        ++*k;
    return *k < 3;
}

static ix_status read_tri_points(ix__lex *l, ix_trisrf *t)
{
    int mesh = t->length * (t->length + 1) / 2;
    int naxes = t->ncoords + (t->rational ? 1 : 0), k;
    size_t stride = (size_t)t->npts;

    for (int i = 0; i < mesh; i++) {
        bool pair = is_twist(t, i, &k);

        if (i % 4096 == 0)
            IX_TRY(ix__poll(l->ctx));
        if (pair)
            IX_TRY(ix__lex_open(l));
        IX_TRY(ix__itdr_point(l, naxes, stride, t->pts + i, (size_t)i,
                              (size_t)mesh));
        if (!pair)
            continue;
        IX_TRY(ix__itdr_point(l, naxes, stride, t->pts + mesh + k, (size_t)i,
                              (size_t)mesh));
        IX_TRY(ix__lex_close(l, "] of a pair of points"));
    }
    return ix__lex_close(l, "] behind the last control point");
}

static ix_status read_trisrf(ix__lex *l, const void **out)
{
    tri_header h = {0};
    ix_trisrf *t;
    ix_status st;

    IX_TRY(read_tri_header(l, &h));
    t = ix__trisrf_new(l->ctx, h.kind, h.length, h.order, h.ncoords,
                       h.rational);
    if (!t)
        return IX_ENOMEM;
    for (int i = 0; i < t->nknots; i++)
        t->knots[i] = h.dir.knots[i];
    st = read_tri_points(l, t);
    if (st == IX_OK)
        *out = t;
    else
        ix__trisrf_unref(l->ctx, t);
    return st;
}

ix_status ix__itdr_trisrf(ix__lex *l, const void **out)
{
    *out = NULL;
    IX_RETURN_SCOPED(l->ctx, read_trisrf(l, out));
}
