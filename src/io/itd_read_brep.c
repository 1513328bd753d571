/* itd_read_brep.c - trimmed surfaces, models and triangular surfaces from text
 * (spec/itd-format 6.4, 7, 8). Curves are kept as they stand in the file. */
#include <stdlib.h>

#include "io/itd_read_impl.h"

/* The words and the brackets up to the bracket that closes this level. */
static ix_status count_items(const ix__lex *l, int *words, int *brackets)
{
    ix__lex scan = *l;
    int depth = 0;
    ix__token t;

    *words = *brackets = 0;
    for (;;) {
        IX_TRY(ix__lex_next(&scan, &t));
        if (t.kind == IX_T_END)
            return ix__lex_unexpected(&scan, &t, "]");
        if (t.kind == IX_T_CLOSE && depth-- == 0)
            return IX_OK;
        if (depth == 0)
            *words += t.kind == IX_T_WORD;
        if (t.kind == IX_T_OPEN && depth++ == 0)
            ++*brackets;
    }
}

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

static ix_status read_trimloop(ix__lex *l, ix_trimloop *loop)
{
    ix__token open;
    int words, n;

    IX_TRY(ix__lex_peek(l, &open));
    IX_TRY(need_bracket(l, "TRIMCRV"));
    IX_TRY(count_items(l, &words, &n));
    if (n == 0)
        return ix__lex_fail(l, open.s, "TRIMCRV holds no TRIMCRVSEG");
    IX_TRY(ix__trimloop_segs(l->ctx, loop, n));
    for (int i = 0; i < n; i++)
        IX_TRY(read_trimseg(l, &loop->seg[i]));
    return ix__lex_close(l, "] of TRIMCRV");
}

static ix_status read_loops(ix__lex *l, ix_trimsrf *t)
{
    for (int i = 0; i < t->nloops; i++)
        IX_TRY(read_trimloop(l, &t->loop[i]));
    return ix__lex_close(l, "] of TRIMSRF");
}

ix_status ix__itdr_trimsrf(ix__lex *l, const void **out)
{
    ix_trimsrf *t = NULL;
    const ix_mv *srf;
    int words, n;
    ix_status st;

    *out = NULL;
    IX_TRY(ix__itdr_whole_mv(l, IX_OBJ_SURFACE, &srf));
    st = count_items(l, &words, &n);
    if (st == IX_OK)
        t = ix__trimsrf_new(l->ctx, srf, n);
    ix_mv_unref(l->ctx, srf);
    if (st != IX_OK || !t)
        return st != IX_OK ? st : IX_ENOMEM;
    st = read_loops(l, t);
    if (st != IX_OK) {
        ix__trimsrf_unref(l->ctx, t);
        return st;
    }
    if (n == 0)
        ix__lex_warn(l, l->p, "a trimmed surface has no trimming curve");
    *out = t;
    return IX_OK;
}

/* --- models ----------------------------------------------------------- */

static ix_status read_loop(ix__lex *l, ix_model_srf *s, int loop, int nseg)
{
    int n, brackets;
    ix__token t;

    IX_TRY(need_bracket(l, "MDLLOOP"));
    IX_TRY(count_items(l, &n, &brackets));
    IX_TRY(ix__model_loop_segs(l->ctx, s, loop, n));
    for (int i = 0; i < n; i++) {
        IX_TRY(ix__lex_peek(l, &t));
        IX_TRY(ix__lex_int(l, "the index of a segment", -nseg, nseg,
                           &s->seg[loop][i]));
        if (s->seg[loop][i] == 0)
            return ix__lex_fail(l, t.s, "segments are counted from 1");
    }
    return ix__lex_close(l, "] of MDLLOOP");
}

static ix_status read_model_srf(ix__lex *l, ix_model *m, ix_model_srf *s)
{
    ix__token open;
    int n;

    IX_TRY(ix__lex_peek(l, &open));
    IX_TRY(need_bracket(l, "MDLTSRF"));
    IX_TRY(ix__lex_int(l, "the number of loops", 0, INT32_MAX, &n));
    IX_TRY(ix__itdr_whole_mv(l, IX_OBJ_SURFACE, &s->srf));
    IX_TRY(ix__lex_room(l, open.s, n, 9, "loops")); /* "[MDLLOOP]" */
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
    IX_TRY(ix__lex_room(l, t.s, nsrf, 10, "surfaces")); /* "[MDLTSRF 0" ... */
    IX_TRY(ix__lex_room(l, t.s, nseg, 15, "segments")); /* "[MDLTSEG 0 0 0]" */
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
    const char *at;
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
    h->at = t.s;
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
        return ix__lex_fail(l, t.s, "KV expected in a triangular surface");
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
