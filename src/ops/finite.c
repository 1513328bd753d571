/* finite.c - the parts of a rational multivariate that stay away from infinity.
 *
 * The domain is halved until the weights of the control points over a part have
 * one sign, which proves that it is finite there, and those points are within
 * reach, which bounds it. What is left at the last halving lies beside a pole
 * or beyond. */
#include <math.h>
#include <string.h>

#include "iritx/ops_bisect.h"
#include "mv/mv.h"

enum { MAX_DEPTH = 12 };

typedef struct {
    double reach;
    int depth, n;
    const ix_mv **piece; /* references */
} finder;

/* Weights of one sign and projected control points within reach of 0. */
static bool is_finite(const ix_mv *m, double reach)
{
    const double *w = ix_mv_weights(m);

    if (ix_mv_has_poles(m))
        return false;
    for (int k = 0; reach > 0.0 && k < m->ncoords; k++) {
        const double *x = ix_mv_coord(m, k);

        for (size_t i = 0; i < m->npts; i++)
            if (!(fabs(x[i]) <= reach * (w ? fabs(w[i]) : 1.0)))
                return false;
    }
    return true;
}

/* Halves direction level mod ndirs; keeps no reference to m. */
static ix_status find(ix_ctx *ctx, finder *f, const ix_mv *m, int level)
{
    int dir = level % m->ndirs;
    double dom[2];
    ix_mv *half[2];
    ix_status st = IX_OK;

    if (is_finite(m, f->reach)) {
        f->piece[f->n++] = ix_mv_ref(m);
        return IX_OK;
    }
    if (level == f->depth)
        return IX_OK;
    ix_mv_domain(m, dir, dom);
    IX_TRY(ix_mv_split(ctx, m, dir, 0.5 * (dom[0] + dom[1]), half));
    for (int i = 0; i < 2; i++) {
        if (st == IX_OK)
            st = find(ctx, f, half[i], level + 1);
        ix_mv_unref(ctx, half[i]);
    }
    return st;
}

/* Takes over the references. */
static ix_status collect(ix_ctx *ctx, const finder *f, int nd,
                         ix_mv_pieces *out)
{
    size_t n = (size_t)f->n, d = (size_t)nd;
    size_t bytes = n * (sizeof(ix_mv *) + 2 * d * sizeof(double)) + 1;
    double *block = ix__alloc(ctx, bytes), dom[2];

    if (!block)
        return IX_ENOMEM;
    *out = (ix_mv_pieces){
        .count = n, .lo = block, .hi = block + n * d, .bytes = bytes};
    out->piece = (ix_mv **)(void *)(out->hi + n * d);
    for (size_t i = 0; i < n; i++) {
        memcpy(&out->piece[i], &f->piece[i], sizeof out->piece[i]);
        for (size_t k = 0; k < d; k++) {
            ix_mv_domain(f->piece[i], (int)k, dom);
            out->lo[i * d + k] = dom[0];
            out->hi[i * d + k] = dom[1];
        }
    }
    return IX_OK;
}

static ix_status pieces(ix_ctx *ctx, const ix_mv *m, int depth, double reach,
                        ix_mv_pieces *out)
{
    finder f = {.reach = reach, .depth = depth};
    ix_mv *b; /* keeps the domains of its parts */
    ix_status st;

    IX_SCRATCH(ctx, f.piece, (size_t)1 << depth);
    IX_TRY(ix_mv_to_bspline(ctx, m, &b));
    st = find(ctx, &f, b, 0);
    if (st == IX_OK)
        st = collect(ctx, &f, m->ndirs, out);
    for (int i = 0; st != IX_OK && i < f.n; i++)
        ix_mv_unref(ctx, f.piece[i]);
    ix_mv_unref(ctx, b);
    return st;
}

ix_status ix_finite_pieces(ix_ctx *ctx, const ix_mv *m, int depth, double reach,
                           ix_mv_pieces *out)
{
    *out = (ix_mv_pieces){0};
    if (depth < 0 || depth > MAX_DEPTH)
        return IX_FAIL(ctx, IX_EARG, "a depth of %d is not in 0 .. %d", depth,
                       MAX_DEPTH);
    if (!(reach >= 0.0))
        return IX_FAIL(ctx, IX_EARG, "a reach of %g", reach);
    IX_RETURN_SCOPED(ctx, pieces(ctx, m, depth, reach, out));
}
