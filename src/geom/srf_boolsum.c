/* srf_boolsum.c - bilinearly blended patches of four boundary curves:
 * ruled(c1, c2) + ruled(c3, c4) - bilinear(corners). Rational boundaries are
 * blended in homogeneous coordinates when their weights agree at corners. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "geom/parts.h"
#include "iritx/geom_srf.h"
#include "iritx/sym.h"

enum { C1, C2, C3, C4 };

/* Which end of which two curves meet at the corners (0,0) (1,0) (0,1) (1,1). */
static const struct {
    int along, along_end, across, across_end;
} corners[4] = {{C1, 0, C3, 0}, {C1, 1, C4, 0}, {C2, 0, C3, 1}, {C2, 1, C4, 1}};

/* Homogeneous end point of a curve. */
static ix_status end_point(ix_ctx *ctx, const ix_mv *c, int end, double *p)
{
    double dom[2];

    ix_mv_domain(c, 0, dom);
    return ix_mv_eval(ctx, c, &dom[end], p);
}

/* What the corners of four curves of one point type look like. */
typedef struct {
    double p[4][IX_MAX_COORDS + 1]; /* homogeneous, of the curves c1, c2 */
    bool same_weights;
} corner_info;

/* Largest difference of the projected points p and q, and their size. */
static void compare(const ix_mv *c, const double *p, const double *q,
                    double *diff, double *size)
{
    int r = c->rational ? 1 : 0;

    for (int k = r; k < c->naxes; k++) {
        double a = r ? p[k] / p[0] : p[k], b = r ? q[k] / q[0] : q[k];

        *diff = fmax(*diff, fabs(a - b));
        *size = fmax(*size, fmax(fabs(a), fabs(b)));
        if (!(a - b == a - b)) /* a point at infinity or NaN is no corner */
            *diff = HUGE_VAL;
    }
}

/* The reference's 1e-5 for points, here relative to the corners' size. */
static ix_status find_corners(ix_ctx *ctx, ix_mv *const c[4], corner_info *out)
{
    double diff[4] = {0}, size = DBL_MIN;

    out->same_weights = true;
    for (int i = 0; i < 4; i++) {
        const ix_mv *a = c[corners[i].along], *b = c[corners[i].across];
        double q[IX_MAX_COORDS + 1];

        IX_TRY(end_point(ctx, a, corners[i].along_end, out->p[i]));
        IX_TRY(end_point(ctx, b, corners[i].across_end, q));
        compare(a, out->p[i], q, &diff[i], &size);
        if (a->rational && !(fabs(out->p[i][0] - q[0]) <= 1e-9 * fabs(q[0])))
            out->same_weights = false;
    }
    for (int i = 0; i < 4; i++)
        if (!(diff[i] <= 1e-5 * size))
            return IX_FAIL(ctx, IX_EARG,
                           "curves %d and %d do not meet: their end points are "
                           "%g apart",
                           corners[i].along + 1, corners[i].across + 1,
                           diff[i]);
    return IX_OK;
}

/* The bilinear patch of the corners, homogeneous or projected. */
static ix_status bilinear(ix_ctx *ctx, const ix_mv *like, const corner_info *ci,
                          bool projected, ix_mv **out)
{
    bool bezier = !ix__mv_has_basis(like, IX_BSPLINE);
    ix_dir dirs[2] = {ix__dir_linear(bezier), ix__dir_linear(bezier)};

    IX_TRY(ix__mv_alloc(ctx, 2, dirs, like->ncoords, like->rational, out));
    for (int k = 0; k < like->naxes; k++)
        for (int i = 0; i < 4; i++)
            (*out)->pts[4 * k + i] = ci->p[i][k] /
                                     (projected ? ci->p[i][0] : 1);
    return IX_OK;
}

/* a + 0 b: the curve a over the product of both weights. */
static ix_status share_weight(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                              ix_mv **out)
{
    const double zero[16] = {[15] = 1};
    ix_mv *flat = NULL;
    ix_status st;

    IX_TRY(ix_mv_transform(ctx, b, zero, &flat));
    st = ix_sym_add(ctx, a, flat, NULL, out);
    ix_mv_unref(ctx, flat);
    return st;
}

/* (1 - t) a + t b of the projected curves if affine, else homogeneous. */
static ix_status ruled(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, bool affine,
                       ix_mv *t[2], ix_mv **out)
{
    if (!affine)
        return ix_srf_ruled(ctx, a, b, out);
    IX_TRY(share_weight(ctx, a, b, &t[0]));
    IX_TRY(share_weight(ctx, b, a, &t[1]));
    return ix_srf_ruled(ctx, t[0], t[1], out);
}

/* a + b - c, all on [0, 1]^2; weights as ordinary coordinates on demand. */
static ix_status blend(ix_ctx *ctx, ix_mv *const abc[3], bool homogeneous,
                       ix_mv *t[5], ix_mv **out)
{
    bool rational = abc[0]->rational;

    for (int i = 0; i < 3; i++)
        IX_TRY(ix__mv_relabel(ctx, abc[i], rational && !homogeneous, &t[i]));
    IX_TRY(ix_sym_add(ctx, t[0], t[1], NULL, &t[3]));
    IX_TRY(ix_sym_sub(ctx, t[3], t[2], NULL, &t[4]));
    return ix__mv_relabel(ctx, t[4], rational, out);
}

enum { PLAIN_TEMPS = 13 };

/* c: four curves on [0, 1], all Bezier or all B-spline, of one point type. */
static ix_status boolsum_plain(ix_ctx *ctx, ix_mv *const c[4],
                               ix_mv *t[PLAIN_TEMPS], ix_mv **out)
{
    corner_info ci;
    bool affine;

    IX_TRY(find_corners(ctx, c, &ci));
    affine = c[0]->rational && !ci.same_weights;
    IX_TRY(ruled(ctx, c[C1], c[C2], affine, t + 9, &t[0]));
    IX_TRY(ruled(ctx, c[C3], c[C4], affine, t + 11, &t[3]));
    IX_TRY(ix_mv_swap_dirs(ctx, t[3], 0, 1, &t[1]));
    IX_TRY(bilinear(ctx, t[0], &ci, affine, &t[2]));
    return blend(ctx, t, !affine, t + 4, out);
}

/* All four curves of one kind, on [0, 1], with one point type, in t[8..11]. */
static ix_status prepare(ix_ctx *ctx, const ix_mv *const c[4], ix_mv *t[12])
{
    bool bspline = false, rational = false;
    int ncoords = 1;

    for (int i = 0; i < 4; i++) {
        bspline = bspline || ix__mv_has_basis(c[i], IX_BSPLINE);
        rational = rational || c[i]->rational;
        if (c[i]->ncoords > ncoords)
            ncoords = c[i]->ncoords;
    }
    for (int i = 0; i < 4; i++) {
        IX_TRY(ix_mv_coerce(ctx, c[i], ncoords, rational, &t[i]));
        if (bspline) {
            IX_TRY(ix_mv_to_open(ctx, t[i], &t[4 + i]));
            IX_TRY(ix_mv_reparam(ctx, t[4 + i], 0, 0, 1, &t[8 + i]));
        } else {
            IX_TRY(ix__mv_plain(ctx, t[i], &t[8 + i]));
        }
    }
    return IX_OK;
}

ix_status ix_srf_boolsum(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                         const ix_mv *c3, const ix_mv *c4, ix_mv **out)
{
    const ix_mv *const c[4] = {c1, c2, c3, c4};
    ix_mv *t[12] = {NULL}, *s[PLAIN_TEMPS] = {NULL};
    ix_status st;

    *out = NULL;
    for (int i = 0; i < 4; i++)
        if (c[i]->ndirs != 1)
            return IX_FAIL(ctx, IX_EARG, "boundary %d has %d directions, not 1",
                           i + 1, c[i]->ndirs);
    st = prepare(ctx, c, t);
    if (st == IX_OK)
        st = boolsum_plain(ctx, t + 8, s, out);
    ix__mv_unref_all(ctx, t, 12);
    ix__mv_unref_all(ctx, s, PLAIN_TEMPS);
    return st;
}

/* Quarter q of the domain; quarters 2 and 3 run backwards, so that the four
 * pieces are boundaries in the order of ix_srf_boolsum: 0, 2, 3, 1. */
static ix_status quarter(ix_ctx *ctx, const ix_mv *c, int q, ix_mv **out)
{
    double dom[2], t[2];
    ix_mv *piece = NULL;
    ix_status st;

    ix_mv_domain(c, 0, dom);
    for (int i = 0; i < 2; i++)
        t[i] = q + i == 4 ? dom[1] : dom[0] + (dom[1] - dom[0]) * (q + i) / 4;
    if (q < 2)
        return ix_mv_region(ctx, c, 0, t[0], t[1], out);
    IX_TRY(ix_mv_region(ctx, c, 0, t[0], t[1], &piece));
    st = ix_mv_reverse(ctx, piece, 0, out);
    ix_mv_unref(ctx, piece);
    return st;
}

static ix_status boolone(ix_ctx *ctx, const ix_mv *crv, ix_mv *t[5],
                         ix_mv **out)
{
    double p[2][IX_MAX_COORDS + 1], diff = 0, size = DBL_MIN;

    if (crv->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG, "the boundary has %d directions, not 1",
                       crv->ndirs);
    IX_TRY(ix__mv_plain(ctx, crv, &t[4]));
    for (int e = 0; e < 2; e++)
        IX_TRY(end_point(ctx, t[4], e, p[e]));
    compare(t[4], p[0], p[1], &diff, &size);
    if (!(diff <= 1e-5 * size))
        return IX_FAIL(ctx, IX_EARG,
                       "the curve is not closed: its ends are %g apart", diff);
    for (int q = 0; q < 4; q++)
        IX_TRY(quarter(ctx, t[4], q, &t[q]));
    return ix_srf_boolsum(ctx, t[0], t[2], t[3], t[1], out);
}

ix_status ix_srf_boolone(ix_ctx *ctx, const ix_mv *crv, ix_mv **out)
{
    ix_mv *t[5] = {NULL};
    ix_status st;

    *out = NULL;
    st = boolone(ctx, crv, t, out);
    ix__mv_unref_all(ctx, t, 5);
    return st;
}
