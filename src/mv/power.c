/* power.c - power basis to Bezier and back, direction by direction, by sums
 * and differences: b[j] = sum of C(j, i) / C(d, i) a[i] over i <= j. */
#include <math.h>
#include <string.h>

#include "mv/mv.h"

/* One direction of all points: c[outer][order][inner]. */
typedef struct {
    double *c;
    int order;
    ix__mv_extent s;
} rows;

static double *row(const rows *r, size_t o, int i)
{
    return r->c + (o * (size_t)r->order + (size_t)i) * r->s.inner;
}

static void scale_row(const rows *r, int i, double f)
{
    for (size_t o = 0; o < r->s.outer; o++)
        for (size_t l = 0; l < r->s.inner; l++)
            row(r, o, i)[l] *= f;
}

/* Row i += f row (i - 1). */
static void add_row(const rows *r, int i, double f)
{
    for (size_t o = 0; o < r->s.outer; o++) {
        const double *prev = row(r, o, i - 1);
        double *x = row(r, o, i);

        for (size_t l = 0; l < r->s.inner; l++)
            x[l] += f * prev[l];
    }
}

static void dir_to_bezier(const rows *r)
{
    int d = r->order - 1;
    double binom = 1;

    for (int i = 1; i <= d; i++) {
        binom = binom * (d - i + 1) / i;
        scale_row(r, i, 1 / binom);
    }
    for (int k = d; k >= 1; k--)
        for (int i = k; i <= d; i++)
            add_row(r, i, 1);
}

static void dir_to_power(const rows *r)
{
    int d = r->order - 1;
    double binom = 1;

    for (int k = 1; k <= d; k++)
        for (int i = d; i >= k; i--)
            add_row(r, i, -1);
    for (int i = 1; i <= d; i++) {
        binom = binom * (d - i + 1) / i;
        scale_row(r, i, binom);
    }
}

/* Directions of basis from become to. */
static ix_status convert(ix_ctx *ctx, const ix_mv *m, ix_basis from,
                         ix_basis to, ix_mv **out)
{
    ix_mv *r;
    bool any = false;

    *out = NULL;
    for (int d = 0; d < m->ndirs; d++)
        any = any || m->dirs[d].basis == from;
    if (!any) {
        *out = ix_mv_ref(m);
        return IX_OK;
    }
    IX_TRY(ix__mv_alloc(ctx, m->ndirs, m->dirs, m->ncoords, m->rational, &r));
    memcpy(r->pts, m->pts, m->npts * (size_t)m->naxes * sizeof *r->pts);
    for (int d = 0; d < m->ndirs; d++) {
        rows all = {r->pts, m->dirs[d].order, ix__mv_shape(m, d)};

        if (m->dirs[d].basis != from)
            continue;
        r->dirs[d].basis = to;
        if (to == IX_BEZIER)
            dir_to_bezier(&all);
        else
            dir_to_power(&all);
    }
    *out = r;
    return IX_OK;
}

ix_status ix__mv_no_power(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    return convert(ctx, m, IX_POWER, IX_BEZIER, out);
}

static ix_status refuse_bspline(ix_ctx *ctx, const ix_mv *m)
{
    for (int d = 0; d < m->ndirs; d++)
        if (m->dirs[d].basis == IX_BSPLINE)
            return IX_FAIL(ctx, IX_EARG, "direction %d is a B-spline", d);
    return IX_OK;
}

ix_status ix_mv_power_to_bezier(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    *out = NULL;
    IX_TRY(refuse_bspline(ctx, m));
    return ix__mv_no_power(ctx, m, out);
}

ix_status ix_mv_bezier_to_power(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    *out = NULL;
    IX_TRY(refuse_bspline(ctx, m));
    return convert(ctx, m, IX_BEZIER, IX_POWER, out);
}
