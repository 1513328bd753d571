/* srf_algsum.c - functions of two independent parameters made of two given
 * maps: sum, swung product, distances. Sums and products of factors of
 * different parameters are outer products of control points, hence exact. */
#include "geom/parts.h"
#include "iritx/geom_srf.h"
#include "iritx/sym.h"

/* a + sign b of plain maps of one kind. */
static ix_status outer_sum(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                           double sign, ix_mv **out)
{
    int n = a->ncoords > b->ncoords ? a->ncoords : b->ncoords;
    const double *wa = ix_mv_weights(a), *wb = ix_mv_weights(b);
    bool rational = a->rational || b->rational;
    double *q;

    IX_TRY(ix__mv_outer_alloc(ctx, a, b, n, rational, out));
    q = (*out)->pts;
    for (size_t i = 0; i < (size_t)(*out)->naxes * (*out)->npts; i++)
        q[i] = 0;
    if (rational) {
        ix__outer_add(a->npts, wa, b->npts, wb, 1, q);
        q += (*out)->npts;
    }
    for (int k = 0; k < n; k++, q += (*out)->npts) {
        if (k < a->ncoords)
            ix__outer_add(a->npts, ix_mv_coord(a, k), b->npts, wb, 1, q);
        if (k < b->ncoords)
            ix__outer_add(a->npts, wa, b->npts, ix_mv_coord(b, k), sign, q);
    }
    return IX_OK;
}

static ix_status plain_sum(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                           double sign, ix_mv **out)
{
    ix_mv *t[2] = {NULL};
    ix_status st;

    st = ix__mv_plain2(ctx, a, b, &t[0], &t[1]);
    if (st == IX_OK)
        st = outer_sum(ctx, t[0], t[1], sign, out);
    ix__mv_unref_all(ctx, t, 2);
    return st;
}

ix_status ix_srf_algsum(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                        ix_mv **out)
{
    *out = NULL;
    return plain_sum(ctx, a, b, 1, out);
}

static ix_status swung(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, ix_mv **out)
{
    const double *wa = ix_mv_weights(a), *wb = ix_mv_weights(b);
    bool rational = a->rational || b->rational;
    size_t n;
    double *q;

    IX_TRY(ix__mv_outer_alloc(ctx, a, b, 3, rational, out));
    n = (*out)->npts;
    q = (*out)->pts;
    for (size_t i = 0; i < (size_t)(*out)->naxes * n; i++)
        q[i] = 0;
    if (rational) {
        ix__outer_add(a->npts, wa, b->npts, wb, 1, q);
        q += n;
    }
    for (int k = 0; k < 2; k++)
        ix__outer_add(a->npts, ix_mv_coord(a, 0), b->npts, ix_mv_coord(b, k), 1,
                      q + (size_t)k * n);
    ix__outer_add(a->npts, ix_mv_coord(a, 1), b->npts, wb, 1, q + 2 * n);
    return IX_OK;
}

ix_status ix_srf_swung(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, ix_mv **out)
{
    ix_mv *t[2] = {NULL};
    ix_status st;

    *out = NULL;
    if (a->ndirs != 1 || b->ndirs != 1 || a->ncoords < 2 || b->ncoords < 2)
        return IX_FAIL(ctx, IX_EARG,
                       "a profile and a trajectory need one direction and two "
                       "coordinates, got %d, %d and %d, %d",
                       a->ndirs, a->ncoords, b->ndirs, b->ncoords);
    st = ix__mv_plain2(ctx, a, b, &t[0], &t[1]);
    if (st == IX_OK)
        st = swung(ctx, t[0], t[1], out);
    ix__mv_unref_all(ctx, t, 2);
    return st;
}

/* (y', -x') of a planar curve. */
static ix_status planar_normal(ix_ctx *ctx, const ix_mv *c, ix_mv *t[2],
                               ix_mv **out)
{
    const double turn[16] = {0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

    IX_TRY(ix_mv_coerce(ctx, c, 2, c->rational, &t[0]));
    IX_TRY(ix_sym_derive(ctx, t[0], 0, NULL, &t[1]));
    return ix_mv_transform(ctx, t[1], turn, out);
}

static ix_status normal_of(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    ix_mv *t[2] = {NULL};
    ix_status st;

    if (m->ndirs == 2)
        return ix_srf_normal_field(ctx, m, out);
    if (m->ndirs != 1 || m->ncoords != 2)
        return IX_FAIL(ctx, IX_EARG,
                       "no normal of %d directions in %d coordinates: a planar "
                       "curve or a surface is needed",
                       m->ndirs, m->ncoords);
    st = planar_normal(ctx, m, t, out);
    ix__mv_unref_all(ctx, t, 2);
    return st;
}

/* <a - b, N> with N extended to the product domain. */
static ix_status along_normal(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                              bool of_a, ix_mv *t[7], ix_mv **out)
{
    IX_TRY(ix__mv_plain2(ctx, a, b, &t[0], &t[1]));
    IX_TRY(plain_sum(ctx, t[0], t[1], -1, &t[2]));
    IX_TRY(normal_of(ctx, t[of_a ? 0 : 1], &t[3]));
    if (of_a) /* the normal's domain is a's, so b serves for the other one */
        IX_TRY(ix__mv_product_domain(ctx, t[3], t[1], &t[5], &t[6]));
    else
        IX_TRY(ix__mv_product_domain(ctx, t[0], t[3], &t[6], &t[5]));
    return ix_sym_dot(ctx, t[2], t[5], NULL, out);
}

ix_status ix_srf_distance(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                          ix_dist what, ix_mv **out)
{
    ix_mv *t[7] = {NULL};
    ix_status st;

    *out = NULL;
    if (what == IX_DIST_VECTOR)
        return plain_sum(ctx, a, b, -1, out);
    if (what == IX_DIST_SQUARED) {
        st = plain_sum(ctx, a, b, -1, &t[0]);
        if (st == IX_OK)
            st = ix_sym_dot(ctx, t[0], t[0], NULL, out);
    } else {
        st = along_normal(ctx, a, b, what == IX_DIST_NORMAL_A, t, out);
    }
    ix__mv_unref_all(ctx, t, 7);
    return st;
}
