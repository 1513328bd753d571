/* integrate.c - integrals of polynomials, in their own basis: running sums of
 * the control points times the widths of their basis functions. */
#include <string.h>

#include "iritx/sym.h"
#include "mv/mv.h"

/* out[i + 1] = out[i] + f[i] in[i] (power basis: no sum), out[0] = 0. */
typedef struct {
    ix_dir dir;
    double *f;
} summation;

static ix_status make_rule(ix_ctx *ctx, const ix_dir *d, summation *r)
{
    int k = d->order, n = d->length;
    double *kv;

    r->dir = *d;
    r->dir.order++;
    r->dir.length++;
    IX_SCRATCH(ctx, r->f, n);
    for (int i = 0; i < n; i++)
        r->f[i] = d->basis == IX_BSPLINE ? (d->knots[i + k] - d->knots[i]) / k
                  : d->basis == IX_POWER ? 1.0 / (i + 1)
                                         : 1.0 / k;
    if (d->basis != IX_BSPLINE)
        return IX_OK;
    IX_SCRATCH(ctx, kv, n + k + 2);
    kv[0] = d->knots[0];
    memcpy(kv + 1, d->knots, (size_t)(n + k) * sizeof *kv);
    kv[n + k + 1] = d->knots[n + k - 1];
    r->dir.knots = kv;
    return IX_OK;
}

static void apply(const summation *r, size_t outer, size_t inner,
                  const double *in, double *out)
{
    double keep = r->dir.basis == IX_POWER ? 0.0 : 1.0;

    for (size_t o = 0; o < outer; o++) {
        memset(out, 0, inner * sizeof *out);
        out += inner;
        for (int i = 0; i < r->dir.length - 1; i++, in += inner, out += inner)
            for (size_t k = 0; k < inner; k++)
                out[k] = keep * (out - inner)[k] + r->f[i] * in[k];
    }
}

static ix_status integrate(ix_ctx *ctx, const ix_mv *a, int dir, ix_mv **out)
{
    ix_dir dirs[IX_MAX_DIRS];
    size_t inner = ix__mv_stride(a, dir), outer;
    summation r;
    ix_mv *m;

    outer = (size_t)a->naxes * a->npts / inner / (size_t)a->dirs[dir].length;
    if (a->dirs[dir].order >= IX_MAX_ORDER)
        return IX_FAIL(ctx, IX_EUNABLE, "order %d already, at most %d",
                       a->dirs[dir].order, IX_MAX_ORDER);
    IX_TRY(make_rule(ctx, &a->dirs[dir], &r));
    memcpy(dirs, a->dirs, (size_t)a->ndirs * sizeof *dirs);
    dirs[dir] = r.dir;
    IX_TRY(ix__mv_alloc(ctx, a->ndirs, dirs, a->ncoords, false, &m));
    apply(&r, outer, inner, a->pts, m->pts);
    *out = m;
    return IX_OK;
}

ix_status ix_sym_integrate(ix_ctx *ctx, const ix_mv *a, int dir, ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_mv *open = NULL;
    ix_status st;

    *out = NULL;
    if (dir < 0 || dir >= a->ndirs)
        return IX_FAIL(ctx, IX_EARG, "direction %d of %d", dir, a->ndirs);
    if (a->rational)
        return IX_FAIL(ctx, IX_EARG,
                       "the integral of a rational function is "
                       "not rational");
    st = ix_mv_to_open(ctx, a, &open);
    if (st == IX_OK)
        st = integrate(ctx, open, dir, out);
    ix_mv_unref(ctx, open);
    ix__scratch_release(ctx, mk);
    return st;
}
