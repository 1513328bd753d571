/* reverse.c - one direction backwards, and two directions exchanged. */
#include <math.h>
#include <string.h>

#include "mv/mv.h"

/* Knots k[n] mirrored about their middle. */
static void mirror(int n, const double *k, double *out)
{
    double first = k[0], last = k[n - 1];

    for (int i = 0; i < n; i++) {
        double x = k[n - 1 - i];

        out[i] = x == last ? first : x == first ? last : last + (first - x);
    }
}

/* True if the knots of a periodic direction repeat after length of them. */
static bool repeats(const ix_dir *dir)
{
    int n = dir->length, o = dir->order;
    const double *k = dir->knots;
    double period = k[n + o - 1] - k[o - 1];
    double tol = ix__knots_ulp4(ix_knots_count(dir), k);

    for (int i = 0; i < 2 * o - 1; i++)
        if (!(fabs(k[i + n] - k[i] - period) <= tol))
            return false;
    return true;
}

/* The knots that go with the reversed points of a periodic direction: the
 * mirrored ones, order - 1 places further on, from the old start. Knots
 * before the first are those of the period before. */
static void mirror_periodic(const ix_dir *dir, double *out)
{
    int n = dir->length, o = dir->order;
    const double *k = dir->knots;
    double period = k[n + o - 1] - k[o - 1];
    double tol = ix__knots_ulp4(ix_knots_count(dir), k);

    for (int i = 0; i < n + 2 * o - 1; i++) {
        int at = n + o - 1 - i, turns = 0;
        double x;

        while (at < 0) {
            at += n;
            turns++;
        }
        x = k[o - 1] + (k[n] - (k[at] - turns * period));
        if (fabs(x - k[o - 1]) <= tol)
            x = k[o - 1];
        if (fabs(x - k[n + o - 1]) <= tol)
            x = k[n + o - 1];
        out[i] = i > 0 && x < out[i - 1] ? out[i - 1] : x;
    }
}

static ix_status reverse(ix_ctx *ctx, const ix_mv *m, int dir, ix_mv **out)
{
    ix_dir nd = m->dirs[dir];
    ix__mv_extent s = ix__mv_shape(m, dir);
    size_t n = (size_t)nd.length, layer = s.inner * sizeof *m->pts;
    double *kv;

    if (nd.basis == IX_BSPLINE) {
        IX_SCRATCH(ctx, kv, ix_knots_count(&nd));
        if (nd.periodic)
            mirror_periodic(&nd, kv);
        else
            mirror(ix_knots_count(&nd), nd.knots, kv);
        nd.knots = kv;
        ix__mv_join_knots(&nd, kv);
    }
    IX_TRY(ix__mv_alloc_like(ctx, m, dir, &nd, out));
    for (size_t o = 0; o < s.outer; o++)
        for (size_t i = 0; i < n; i++)
            memcpy((*out)->pts + (o * n + i) * s.inner,
                   m->pts + (o * n + n - 1 - i) * s.inner, layer);
    return IX_OK;
}

static ix_status reverse_scoped(ix_ctx *ctx, const ix_mv *m, int dir,
                                ix_mv **out)
{
    IX_RETURN_SCOPED(ctx, reverse(ctx, m, dir, out));
}

ix_status ix_mv_reverse(ix_ctx *ctx, const ix_mv *m, int dir, ix_mv **out)
{
    ix_mv *cur, *next;

    *out = NULL;
    IX_TRY(ix__mv_check_dir(ctx, m, dir));
    if (m->dirs[dir].basis == IX_POWER)
        return IX_FAIL(ctx, IX_EARG, "direction %d: power basis", dir);
    cur = ix_mv_ref(m);
    if (m->dirs[dir].periodic && !repeats(m->dirs + dir))
        IX_TRY(
            ix__mv_step(ctx, &cur, &next, ix__mv_unwrap(ctx, cur, dir, &next)));
    IX_TRY(ix__mv_step(ctx, &cur, &next, reverse_scoped(ctx, cur, dir, &next)));
    *out = cur;
    return IX_OK;
}

/* Points of one axis with directions d1 < d2 exchanged: seen as
 * [outer][n2][middle][n1][inner], n1 and n2 change places. */
static void swap_axis(const ix_mv *m, int d1, int d2, const double *in,
                      double *out)
{
    size_t inner = ix__mv_stride(m, d1), n1 = (size_t)m->dirs[d1].length;
    size_t n2 = (size_t)m->dirs[d2].length;
    size_t middle = ix__mv_stride(m, d2) / (inner * n1);
    size_t block = inner * n1 * middle * n2;

    for (size_t o = 0; o < m->npts; o += block)
        for (size_t i = 0; i < n1; i++)
            for (size_t k = 0; k < middle; k++)
                for (size_t j = 0; j < n2; j++)
                    memcpy(out + o + (((i * middle) + k) * n2 + j) * inner,
                           in + o + ((j * middle + k) * n1 + i) * inner,
                           inner * sizeof *in);
}

ix_status ix_mv_swap_dirs(ix_ctx *ctx, const ix_mv *m, int d1, int d2,
                          ix_mv **out)
{
    ix_dir dirs[IX_MAX_DIRS];

    *out = NULL;
    IX_TRY(ix__mv_check_dir(ctx, m, d1));
    IX_TRY(ix__mv_check_dir(ctx, m, d2));
    if (d1 == d2) {
        *out = ix_mv_ref(m);
        return IX_OK;
    }
    memcpy(dirs, m->dirs, (size_t)m->ndirs * sizeof *dirs);
    dirs[d1] = m->dirs[d2];
    dirs[d2] = m->dirs[d1];
    IX_TRY(ix__mv_alloc(ctx, m->ndirs, dirs, m->ncoords, m->rational, out));
    for (size_t a = 0; a < (size_t)m->naxes; a++)
        swap_axis(m, d1 < d2 ? d1 : d2, d1 < d2 ? d2 : d1, m->pts + a * m->npts,
                  (*out)->pts + a * m->npts);
    return IX_OK;
}
