/* transform_freeform.c - freeforms, trimmed and triangular surfaces, models
 * times a matrix. Curves in parameter planes stay as they are. */
#include <string.h>

#include "object/transform_impl.h"

/* Missing coordinates are 0 before and dropped after; from the fourth on they
 * stay. A perspective matrix makes a polynomial point rational. */
void ix__move_ctlpt(const ix_ctlpt *p, const double mat[16], ix_ctlpt *out)
{
    int nc = p->ncoords < 3 ? p->ncoords : 3;
    double q[4] = {0, 0, 0, p->rational ? p->v[0] : 1}, h[4];

    memcpy(q, p->v + p->rational, (size_t)nc * sizeof *q);
    ix__row_times(q, mat, h);
    *out = (ix_ctlpt){.ncoords = p->ncoords,
                      .rational = p->rational || h[3] != 1};
    for (int k = 0; k < p->ncoords; k++)
        out->v[k + out->rational] = k < nc ? h[k] : p->v[k + p->rational];
    if (out->rational)
        out->v[0] = h[3];
}

/* Curves and surfaces get three coordinates first (spec/language 5.3). */
static ix_status move_mv(ix_ctx *ctx, ix_obj_type type, const ix_mv *m,
                         const double mat[16], const ix_mv **out)
{
    bool lift = type == IX_OBJ_CURVE || type == IX_OBJ_SURFACE;
    ix_mv *wide = NULL, *moved;
    ix_status st;

    if (lift && ix_mv_ncoords(m) < 3)
        IX_TRY(ix_mv_coerce(ctx, m, 3, ix_mv_rational(m), &wide));
    st = ix_mv_transform(ctx, wide ? wide : m, mat, &moved);
    ix_mv_unref(ctx, wide);
    if (st == IX_OK)
        *out = moved;
    return st;
}

/* --- trimmed surfaces ------------------------------------------------- */

static ix_status fill_loop(ix_ctx *ctx, const ix_trimloop *from,
                           const double mat[16], ix_trimloop *to)
{
    IX_TRY(ix__trimloop_segs(ctx, to, from->n));
    for (int i = 0; i < from->n; i++) {
        to->seg[i].uv = ix_mv_ref(from->seg[i].uv);
        if (from->seg[i].euclid)
            IX_TRY(move_mv(ctx, IX_OBJ_CURVE, from->seg[i].euclid, mat,
                           &to->seg[i].euclid));
    }
    return IX_OK;
}

static ix_status move_trimsrf(ix_ctx *ctx, const ix_trimsrf *t,
                              const double mat[16], const void **out)
{
    const ix_mv *srf;
    ix_trimsrf *m;

    IX_TRY(move_mv(ctx, IX_OBJ_SURFACE, t->srf, mat, &srf));
    m = ix__trimsrf_new(ctx, srf, t->nloops);
    ix_mv_unref(ctx, srf);
    *out = m;
    if (!m)
        return IX_ENOMEM;
    for (int i = 0; i < t->nloops; i++)
        IX_TRY(fill_loop(ctx, &t->loop[i], mat, &m->loop[i]));
    return IX_OK;
}

/* --- triangular surfaces ---------------------------------------------- */

static void move_tri_point(const ix_trisrf *t, size_t i, const double mat[16],
                           ix_trisrf *m)
{
    ix_ctlpt p = {.ncoords = t->ncoords, .rational = t->rational}, q;
    size_t n = (size_t)t->npts;

    for (int a = 0; a < t->ncoords + t->rational; a++)
        p.v[a] = t->pts[(size_t)a * n + i];
    ix__move_ctlpt(&p, mat, &q);
    for (int a = 0; a < t->ncoords + t->rational; a++)
        m->pts[(size_t)a * n + i] = q.v[a];
}

/* The point type is kept, so that perspective needs a rational surface. */
static ix_status move_trisrf(ix_ctx *ctx, const ix_trisrf *t,
                             const double mat[16], const void **out)
{
    ix_trisrf *m;

    if (!t->rational && !(ix__is_affine(mat) && mat[15] == 1))
        return IX_FAIL(ctx, IX_EARG,
                       "a polynomial triangular surface has no image under a "
                       "matrix whose last column is not 0 0 0 1");
    m = ix__trisrf_new(ctx, t->kind, t->length, t->order, t->ncoords,
                       t->rational);
    if (!m)
        return IX_ENOMEM;
    if (t->nknots > 0)
        memcpy(m->knots, t->knots, (size_t)t->nknots * sizeof *m->knots);
    for (int i = 0; i < t->npts; i++)
        move_tri_point(t, (size_t)i, mat, m);
    *out = m;
    return IX_OK;
}

/* --- models ----------------------------------------------------------- */

static ix_status fill_model_srf(ix_ctx *ctx, const ix_model_srf *from,
                                const double mat[16], ix_model_srf *to)
{
    IX_TRY(move_mv(ctx, IX_OBJ_SURFACE, from->srf, mat, &to->srf));
    IX_TRY(ix__model_loops(ctx, to, from->nloops));
    for (int i = 0; i < from->nloops; i++) {
        IX_TRY(ix__model_loop_segs(ctx, to, i, from->nseg[i]));
        if (from->nseg[i] > 0)
            memcpy(to->seg[i], from->seg[i],
                   (size_t)from->nseg[i] * sizeof *to->seg[i]);
    }
    return IX_OK;
}

static ix_status fill_model_seg(ix_ctx *ctx, const ix_model_seg *from,
                                const double mat[16], ix_model_seg *to)
{
    to->mask = from->mask;
    to->s1 = from->s1;
    to->s2 = from->s2;
    to->uv1 = from->uv1 ? ix_mv_ref(from->uv1) : NULL;
    to->uv2 = from->uv2 ? ix_mv_ref(from->uv2) : NULL;
    if (!from->euclid)
        return IX_OK;
    return move_mv(ctx, IX_OBJ_CURVE, from->euclid, mat, &to->euclid);
}

static ix_status move_model(ix_ctx *ctx, const ix_model *m,
                            const double mat[16], const void **out)
{
    ix_model *r = ix__model_new(ctx, m->nsrf, m->nseg);

    *out = r;
    if (!r)
        return IX_ENOMEM;
    for (int i = 0; i < m->nsrf; i++)
        IX_TRY(fill_model_srf(ctx, &m->srf[i], mat, &r->srf[i]));
    for (int i = 0; i < m->nseg; i++)
        IX_TRY(fill_model_seg(ctx, &m->seg[i], mat, &r->seg[i]));
    return IX_OK;
}

/* --- any of them ------------------------------------------------------ */

static ix_status move_any(ix_ctx *ctx, ix_obj_type type, const void *item,
                          const double mat[16], const void **out)
{
    const ix_mv *m = NULL;
    ix_status st;

    switch (type) {
    case IX_OBJ_TRIMSRF:
        return move_trimsrf(ctx, item, mat, out);
    case IX_OBJ_TRISRF:
        return move_trisrf(ctx, item, mat, out);
    case IX_OBJ_MODEL:
        return move_model(ctx, item, mat, out);
    default:
        st = move_mv(ctx, type, item, mat, &m);
        *out = m;
        return st;
    }
}

ix_status ix__move_item(ix_ctx *ctx, ix_obj_type type, const void *item,
                        const double mat[16], const void **out)
{
    ix_status st;

    *out = NULL;
    st = move_any(ctx, type, item, mat, out);
    if (st != IX_OK) { /* half made */
        ix__seq_unref(ctx, type, *out);
        *out = NULL;
    }
    return st;
}
