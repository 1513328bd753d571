/* add.c - sums and differences. Operands written alike are added point by
 * point; others meet as forms, rational ones by the rules of fractions unless
 * their weights agree. */
#include <math.h>
#include <string.h>

#include "sym/frac.h"

/* Weights that differ by no more than this part of the largest are taken to
 * be the same (spec/model 9.1); a difference above ROUNDING is remarked on. */
#define WEIGHT_TOL 1e-5
#define ROUNDING   1e-12

/* Whether the weights agree within WEIGHT_TOL; *gap: by how much they do. */
static bool agree(size_t n, const double *wa, const double *wb, double *gap)
{
    double big = 0.0, diff = 0.0;

    for (size_t i = 0; i < n; i++) {
        big = fmax(big, fabs(wa[i]));
        diff = fmax(diff, fabs(wa[i] - wb[i]));
    }
    *gap = big > 0.0 ? diff / big : 0.0;
    return big > 0.0 && diff <= WEIGHT_TOL * big;
}

static void remark(ix_ctx *ctx, double gap)
{
    if (gap > ROUNDING)
        ix__note(ctx,
                 "weights that differ by %.2g of the largest are taken "
                 "to be equal",
                 gap);
}

/* --- point by point ------------------------------------------------------- */

static bool same_dir(const ix_dir *a, const ix_dir *b)
{
    return a->basis == b->basis && a->order == b->order &&
           a->length == b->length && a->periodic == b->periodic &&
           (a->basis != IX_BSPLINE || a->knots == b->knots ||
            !memcmp(a->knots, b->knots,
                    (size_t)ix_knots_count(a) * sizeof *a->knots));
}

static bool same_shape(const ix_mv *a, const ix_mv *b, double *gap)
{
    *gap = 0.0;
    if (a->ndirs != b->ndirs || a->ncoords != b->ncoords ||
        a->rational != b->rational)
        return false;
    for (int i = 0; i < a->ndirs; i++)
        if (!same_dir(&a->dirs[i], &b->dirs[i]))
            return false;
    return !a->rational || agree(a->npts, a->pts, b->pts, gap);
}

static ix_status add_points(ix_ctx *ctx, const ix_mv *a, int sign,
                            const ix_mv *b, ix_mv **out)
{
    size_t n = (size_t)a->naxes * a->npts, i = a->rational ? a->npts : 0;
    ix_mv *m;

    IX_TRY(ix__mv_alloc(ctx, a->ndirs, a->dirs, a->ncoords, a->rational, &m));
    memcpy(m->pts, a->pts, i * sizeof *a->pts);
    for (; i < n; i++)
        m->pts[i] = sign > 0 ? a->pts[i] + b->pts[i] : a->pts[i] - b->pts[i];
    *out = m;
    return IX_OK;
}

/* --- as forms ------------------------------------------------------------- */

static ix_status same_weights(ix_ctx *ctx, const ix_frac *f, bool *same)
{
    ix_form a = f[0].w, b = f[1].w, d;
    double gap, diff, big;

    IX_TRY(ix__form_add(ctx, &a, -1, &b, &d));
    IX_TRY(ix__form_bound(ctx, &d, &diff));
    IX_TRY(ix__form_bound(ctx, &a, &big));
    gap = big > 0.0 ? diff / big : HUGE_VAL;
    *same = gap <= WEIGHT_TOL;
    if (*same)
        remark(ctx, gap);
    return IX_OK;
}

static ix_status add_fracs(ix_ctx *ctx, ix_frac *f, int sign, ix_frac *out)
{
    int nc = f[0].x.nrows > f[1].x.nrows ? f[0].x.nrows : f[1].x.nrows;
    bool same = false;

    IX_TRY(ix__frac_pad(ctx, &f[0], nc));
    IX_TRY(ix__frac_pad(ctx, &f[1], nc));
    if (f[0].rational && f[1].rational)
        IX_TRY(same_weights(ctx, f, &same));
    if (same) {
        out->rational = true;
        out->w = f[0].w;
        return ix__form_add(ctx, &f[0].x, sign, &f[1].x, &out->x);
    }
    IX_TRY(ix__frac_weights(ctx, &f[0], &f[1], out));
    if (f[1].rational)
        IX_TRY(ix__form_mul(ctx, &f[0].x, &f[1].w, &f[0].x));
    if (f[0].rational)
        IX_TRY(ix__form_mul(ctx, &f[1].x, &f[0].w, &f[1].x));
    return ix__form_add(ctx, &f[0].x, sign, &f[1].x, &out->x);
}

static ix_status add(ix_ctx *ctx, const ix_mv *a, int sign, const ix_mv *b,
                     const ix_sym_opts *o, ix_mv **out)
{
    const ix_mv *m[2] = {a, b};
    double gap;

    *out = NULL;
    if (!same_shape(a, b, &gap))
        return ix__frac_run(ctx, 2, m, add_fracs, sign, o, out);
    remark(ctx, gap);
    return add_points(ctx, a, sign, b, out);
}

ix_status ix_sym_add(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                     const ix_sym_opts *o, ix_mv **out)
{
    return add(ctx, a, 1, b, o, out);
}

ix_status ix_sym_sub(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                     const ix_sym_opts *o, ix_mv **out)
{
    return add(ctx, a, -1, b, o, out);
}
