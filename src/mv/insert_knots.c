/* insert_knots.c - knots inserted, replaced, or mapped to another domain. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mv/mv.h"

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* Sorted copy in scratch; knots within rounding of one of dir's become it. */
static ix_status prepare(ix_ctx *ctx, const ix_mv *m, int d, int n,
                         const double *knots, double **out)
{
    const ix_dir *dir = m->dirs + d;
    int nk = ix_knots_count(dir), i = 0;
    double dom[2], tol = ix__knots_ulp4(nk, dir->knots), *s;

    ix__dir_domain(dir, dom);
    IX_SCRATCH(ctx, s, n);
    memcpy(s, knots, (size_t)n * sizeof *s);
    for (int k = 0; k < n; k++)
        if (!(s[k] >= dom[0] - tol && s[k] <= dom[1] + tol))
            return IX_FAIL(ctx, IX_EARG,
                           "knot %.17g is outside the domain [%.17g, %.17g] of "
                           "direction %d",
                           s[k], dom[0], dom[1], d);
    qsort(s, (size_t)n, sizeof *s, compare);
    for (int k = 0; k < n; k++) {
        while (i < nk - 1 && dir->knots[i] < s[k] - tol)
            i++;
        if (fabs(dir->knots[i] - s[k]) <= tol)
            s[k] = dir->knots[i];
    }
    *out = s;
    return IX_OK;
}

/* The knots of dir and the n sorted others in one vector. */
static ix_status merge_knots(ix_ctx *ctx, const ix_dir *dir, int n,
                             const double *more, ix_dir *out)
{
    int nk = ix_knots_count(dir), i = 0, j = 0, total;
    double *kv;

    if (__builtin_add_overflow(nk, n, &total))
        return IX_FAIL(ctx, IX_ENOMEM, "%d knots and %d more", nk, n);
    IX_SCRATCH(ctx, kv, total);
    while (i + j < total)
        if (j == n || (i < nk && dir->knots[i] <= more[j])) {
            kv[i + j] = dir->knots[i];
            i++;
        } else {
            kv[i + j] = more[j];
            j++;
        }
    *out = (ix_dir){IX_BSPLINE, dir->order, dir->length + n, false, kv};
    return IX_OK;
}

/* m is a B-spline, not periodic in direction d. */
static ix_status insert(ix_ctx *ctx, const ix_mv *m, int d, int n,
                        const double *knots, ix_mv **out)
{
    double *sorted;
    ix_rows rows;
    ix_dir nd;

    IX_TRY(prepare(ctx, m, d, n, knots, &sorted));
    IX_TRY(merge_knots(ctx, m->dirs + d, n, sorted, &nd));
    IX_TRY(ix__mv_check_dirs(ctx, 1, &nd, 1));
    IX_TRY(ix__rows_refine(ctx, m->dirs + d, nd.length, nd.knots, &rows));
    return ix__mv_map(ctx, m, d, &rows, &nd, out);
}

static ix_status insert_scoped(ix_ctx *ctx, const ix_mv *m, int d, int n,
                               const double *knots, ix_mv **out)
{
    IX_RETURN_SCOPED(ctx, insert(ctx, m, d, n, knots, out));
}

ix_status ix_mv_insert_knots(ix_ctx *ctx, const ix_mv *m, int dir, int n,
                             const double *knots, ix_mv **out)
{
    ix_mv *cur, *next;

    *out = NULL;
    IX_TRY(ix__mv_check_dir(ctx, m, dir));
    if (n < 0)
        return IX_FAIL(ctx, IX_EARG, "%d knots", n);
    if (n == 0) {
        *out = ix_mv_ref(m);
        return IX_OK;
    }
    IX_TRY(ix_mv_to_bspline(ctx, m, &cur));
    if (m->dirs[dir].periodic)
        IX_TRY(
            ix__mv_step(ctx, &cur, &next, ix__mv_unwrap(ctx, cur, dir, &next)));
    IX_TRY(ix__mv_step(ctx, &cur, &next,
                       insert_scoped(ctx, cur, dir, n, knots, &next)));
    *out = cur;
    return IX_OK;
}

/* --- other knots for the same points ------------------------------------- */

static ix_status set_knots(ix_ctx *ctx, const ix_mv *m, int dir, int nknots,
                           const double *knots, ix_mv **out)
{
    ix_dir nd = m->dirs[dir];
    double *kv;

    if (nknots != ix_knots_count(&nd))
        return IX_FAIL(ctx, IX_EARG,
                       "%d knots instead of the %d of direction %d", nknots,
                       ix_knots_count(&nd), dir);
    nd.knots = knots;
    IX_TRY(ix__mv_check_dirs(ctx, 1, &nd, 1));
    IX_SCRATCH(ctx, kv, nknots);
    memcpy(kv, knots, (size_t)nknots * sizeof *kv);
    ix__mv_join_knots(&nd, kv);
    return ix__mv_with_knots(ctx, m, dir, kv, out);
}

static ix_status set_scoped(ix_ctx *ctx, const ix_mv *m, int dir, int nknots,
                            const double *knots, ix_mv **out)
{
    IX_RETURN_SCOPED(ctx, set_knots(ctx, m, dir, nknots, knots, out));
}

ix_status ix_mv_set_knots(ix_ctx *ctx, const ix_mv *m, int dir, int nknots,
                          const double *knots, ix_mv **out)
{
    ix_mv *cur, *next;

    *out = NULL;
    IX_TRY(ix__mv_check_dir(ctx, m, dir));
    IX_TRY(ix_mv_to_bspline(ctx, m, &cur));
    IX_TRY(ix__mv_step(ctx, &cur, &next,
                       set_scoped(ctx, cur, dir, nknots, knots, &next)));
    *out = cur;
    return IX_OK;
}

/* x of [from[0], from[1]] to [to[0], to[1]], exact at both ends, measured
 * from the nearer; equal x have equal images. */
static double affine(double x, const double from[2], const double to[2])
{
    double s = (x - from[0]) / (from[1] - from[0]);

    if (s <= 0.5)
        return to[0] + s * (to[1] - to[0]);
    return to[1] - (from[1] - x) / (from[1] - from[0]) * (to[1] - to[0]);
}

static ix_status reparam(ix_ctx *ctx, const ix_mv *m, int dir,
                         const double to[2], ix_mv **out)
{
    const ix_dir *old = m->dirs + dir;
    int n = ix_knots_count(old);
    ix_dir nd = *old;
    double from[2], *kv;

    ix__dir_domain(old, from);
    IX_SCRATCH(ctx, kv, n);
    for (int i = 0; i < n; i++) {
        kv[i] = affine(old->knots[i], from, to);
        if (i > 0 && kv[i] < kv[i - 1])
            kv[i] = kv[i - 1]; /* where the two formulas meet */
    }
    nd.knots = kv;
    IX_TRY(ix__mv_check_dirs(ctx, 1, &nd, 1));
    ix__mv_join_knots(&nd, kv);
    return ix__mv_with_knots(ctx, m, dir, kv, out);
}

static ix_status reparam_scoped(ix_ctx *ctx, const ix_mv *m, int dir,
                                const double to[2], ix_mv **out)
{
    IX_RETURN_SCOPED(ctx, reparam(ctx, m, dir, to, out));
}

ix_status ix_mv_reparam(ix_ctx *ctx, const ix_mv *m, int dir, double t0,
                        double t1, ix_mv **out)
{
    double to[2] = {t0, t1};
    ix_mv *cur, *next;

    *out = NULL;
    IX_TRY(ix__mv_check_dir(ctx, m, dir));
    if (!(t0 < t1) || !isfinite(t1 - t0))
        return IX_FAIL(
            ctx, IX_EARG,
            "domain [%.17g, %.17g]: the lower end must be below the upper", t0,
            t1);
    IX_TRY(ix_mv_to_bspline(ctx, m, &cur));
    IX_TRY(ix__mv_step(ctx, &cur, &next,
                       reparam_scoped(ctx, cur, dir, to, &next)));
    *out = cur;
    return IX_OK;
}
