/* derive.c - derivatives. Polynomials, and axes by themselves, stay in their
 * own basis: each new control point is a multiple of a difference of two old
 * ones. Rational functions go through forms: (X'W - XW') / W^2. */
#include <string.h>

#include "sym/frac.h"

/* Control points of the derivative: f[i] (P[at[i] + 1] - P[at[i]]), or without
 * the second term for the power basis. */
typedef struct {
    ix_dir dir; /* of the result */
    int *at;
    double *f;
} difference;

/* Basis functions between equal knots vanish: they go, with one knot each. */
static ix_status bspline_rule(ix_ctx *ctx, const ix_dir *d, difference *r)
{
    int k = d->order, n = 0, nk = 0, last = d->length + k - 2;
    double *kv;

    IX_SCRATCH(ctx, kv, d->length + k);
    for (int i = 0; i < d->length - 1; i++) {
        double h = d->knots[i + k] - d->knots[i + 1];

        if (!(h > 0.0))
            continue;
        r->at[n] = i;
        r->f[n++] = (k - 1) / h;
        kv[nk++] = d->knots[i + 1];
    }
    for (int i = last - (k - 2); i <= last; i++)
        kv[nk++] = d->knots[i];
    r->dir = (ix_dir){IX_BSPLINE, k - 1, n, false, kv};
    return IX_OK;
}

static ix_status make_rule(ix_ctx *ctx, const ix_dir *d, difference *r)
{
    r->dir = *d;
    IX_SCRATCH(ctx, r->at, d->length);
    IX_SCRATCH_ZERO(ctx, r->f, d->length);
    for (int i = 0; i < d->length; i++)
        r->at[i] = i;
    if (d->order == 1)
        return IX_OK; /* zeros: f is 0, and at is never used */
    if (d->basis == IX_BSPLINE)
        return bspline_rule(ctx, d, r);
    for (int i = 0; i < d->length - 1; i++)
        r->f[i] = d->basis == IX_POWER ? i + 1 : d->order - 1;
    r->dir.order = r->dir.length = d->order - 1;
    return IX_OK;
}

/* in[outer][length][inner] to out[outer][dir.length][inner]. */
static void apply(const difference *r, int length, size_t outer, size_t inner,
                  const double *in, double *out)
{
    double low = r->dir.basis == IX_POWER ? 0.0 : 1.0;

    for (size_t o = 0; o < outer; o++, in += (size_t)length * inner)
        for (int i = 0; i < r->dir.length; i++, out += inner) {
            const double *p = in + (size_t)r->at[i] * inner;

            for (size_t k = 0; k < inner; k++)
                out[k] = r->f[i] == 0.0 ? 0.0
                                        : r->f[i] * (p[inner + k] - low * p[k]);
        }
}

static ix_status axes(ix_ctx *ctx, const ix_mv *a, int dir, ix_mv **out)
{
    ix_dir dirs[IX_MAX_DIRS];
    size_t inner = ix__mv_stride(a, dir), outer;
    difference r;
    ix_mv *m;

    outer = (size_t)a->naxes * a->npts / inner / (size_t)a->dirs[dir].length;
    IX_TRY(make_rule(ctx, &a->dirs[dir], &r));
    memcpy(dirs, a->dirs, (size_t)a->ndirs * sizeof *dirs);
    dirs[dir] = r.dir;
    IX_TRY(ix__mv_alloc(ctx, a->ndirs, dirs, a->ncoords, a->rational, &m));
    apply(&r, a->dirs[dir].length, outer, inner, a->pts, m->pts);
    *out = m;
    return IX_OK;
}

static ix_status check_dir(ix_ctx *ctx, const ix_mv *a, int dir)
{
    if (dir < 0 || dir >= a->ndirs)
        return IX_FAIL(ctx, IX_EARG, "direction %d of %d", dir, a->ndirs);
    return IX_OK;
}

ix_status ix_sym_derive_axes(ix_ctx *ctx, const ix_mv *a, int dir, ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_mv *plain = NULL;
    ix_status st = IX_OK;

    *out = NULL;
    IX_TRY(check_dir(ctx, a, dir));
    if (a->dirs[dir].periodic)
        st = ix_mv_to_float(ctx, a, &plain);
    else
        plain = ix_mv_ref(a);
    if (st == IX_OK)
        st = axes(ctx, plain, dir, out);
    ix_mv_unref(ctx, plain);
    ix__scratch_release(ctx, mk);
    return st;
}

/* J(X, W) = d h0 (X'W - XW'). */
static ix_status quotient_rule(ix_ctx *ctx, const ix_mv *a, int dir,
                               const ix_sym_opts *o, ix_mv **out)
{
    ix_frac f, r = {.rational = true};
    int d = a->dirs[dir].order - 1;

    IX_TRY(ix__fracs_load(ctx, 1, &a, &f));
    IX_TRY(ix__form_jacobian(ctx, &f.x, &f.w, dir, &r.x));
    if (d > 0)
        ix__form_times(&r.x, 1.0 / (d * ix__spans_mean(&f.x.dirs[dir])));
    IX_TRY(ix__form_mul(ctx, &f.w, &f.w, &r.w));
    return ix__frac_store(ctx, &r, o, out);
}

ix_status ix_sym_derive(ix_ctx *ctx, const ix_mv *a, int dir,
                        const ix_sym_opts *o, ix_mv **out)
{
    ix_mark mk;
    ix_status st;

    *out = NULL;
    if (!a->rational)
        return ix_sym_derive_axes(ctx, a, dir, out);
    IX_TRY(check_dir(ctx, a, dir));
    mk = ix__scratch_mark(ctx);
    st = quotient_rule(ctx, a, dir, o, out);
    ix__scratch_release(ctx, mk);
    return st;
}
