/* to_bezier.c - the Bezier pieces of a multivariate: every direction cut into
 * spans, then each box of spans collected. */
#include <string.h>

#include "mv/bernstein.h"

/* Coefficients of one axis of the piece at spans at[], copied by rows. */
static double *collect(const ix__bernstein *c, const int *at, const double *in,
                       double *out)
{
    size_t row = (size_t)c->m->dirs[0].order;
    int q[IX_MAX_DIRS] = {0};

    do {
        memcpy(out, in + ix__bernstein_row(c, at, q), row * sizeof *out);
        out += row;
    } while (ix__bernstein_next(c->m, q));
    return out;
}

static ix_status make_piece(ix_ctx *ctx, const ix__bernstein *c, const int *at,
                            ix_mv **out)
{
    const ix_mv *m = c->m;
    ix_dir dirs[IX_MAX_DIRS];
    double *p;

    for (int d = 0; d < m->ndirs; d++)
        dirs[d] = (ix_dir){IX_BEZIER, m->dirs[d].order, m->dirs[d].order, false,
                           NULL};
    IX_TRY(ix__mv_alloc(ctx, m->ndirs, dirs, m->ncoords, m->rational, out));
    p = (*out)->pts;
    for (size_t a = 0; a < (size_t)m->naxes; a++)
        p = collect(c, at, c->coefs + a * c->axis, p);
    return IX_OK;
}

/* Room for count pieces and their intervals, nothing in it yet. */
static ix_status alloc_pieces(ix_ctx *ctx, const ix__bernstein *c,
                              ix_mv_pieces *out)
{
    size_t n = 1, nd = (size_t)c->m->ndirs, each, bytes;
    unsigned char *block;

    for (int d = 0; d < c->m->ndirs; d++)
        n *= (size_t)c->sp[d].nspans; /* no more than there are points */
    each = sizeof(ix_mv *) + 2 * nd * sizeof(double);
    if (__builtin_mul_overflow(n, each, &bytes))
        return IX_FAIL(ctx, IX_ENOMEM, "%zu pieces", n);
    block = ix__alloc(ctx, bytes);
    if (!block)
        return IX_ENOMEM;
    memset(block, 0, bytes);
    *out = (ix_mv_pieces){.count = n, .bytes = bytes};
    out->lo = (double *)(void *)block;
    out->hi = out->lo + n * nd;
    out->piece = (ix_mv **)(void *)(out->hi + n * nd);
    return IX_OK;
}

static ix_status to_bezier(ix_ctx *ctx, const ix_mv *m, ix_mv_pieces *out)
{
    int at[IX_MAX_DIRS] = {0};
    ix__bernstein c;

    IX_TRY(ix__bernstein_of(ctx, m, &c));
    IX_TRY(alloc_pieces(ctx, &c, out));
    for (size_t i = 0; i < out->count; i++) {
        size_t nd = (size_t)m->ndirs;

        IX_TRY(make_piece(ctx, &c, at, out->piece + i));
        for (size_t d = 0; d < nd; d++) {
            out->lo[i * nd + d] = c.sp[d].breaks[at[d]];
            out->hi[i * nd + d] = c.sp[d].breaks[at[d] + 1];
        }
        for (int d = 0; d < m->ndirs && ++at[d] == c.sp[d].nspans; d++)
            at[d] = 0;
    }
    return IX_OK;
}

/* What was made before a failure is released. */
static ix_status cleaned(ix_ctx *ctx, const ix_mv *m, ix_mv_pieces *out)
{
    ix_status st = to_bezier(ctx, m, out);

    if (st != IX_OK)
        ix_mv_pieces_free(ctx, out);
    return st;
}

static ix_status to_bezier_scoped(ix_ctx *ctx, const ix_mv *m,
                                  ix_mv_pieces *out)
{
    IX_RETURN_SCOPED(ctx, cleaned(ctx, m, out));
}

ix_status ix_mv_to_bezier(ix_ctx *ctx, const ix_mv *m, ix_mv_pieces *out)
{
    ix_mv *cur;
    ix_status st;

    *out = (ix_mv_pieces){0};
    IX_TRY(ix__mv_no_power(ctx, m, &cur));
    st = to_bezier_scoped(ctx, cur, out);
    ix_mv_unref(ctx, cur);
    return st;
}

void ix_mv_pieces_free(ix_ctx *ctx, ix_mv_pieces *p)
{
    for (size_t i = 0; i < p->count; i++)
        ix_mv_unref(ctx, p->piece[i]);
    ix__free(ctx, p->lo, p->bytes);
    *p = (ix_mv_pieces){0};
}
