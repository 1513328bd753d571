/* new.c - making, sharing and reading multivariates. One block holds header,
 * directions, knots and points; sizes are computed with overflow checks. */
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "bsp/knots.h"
#include "mv/mv.h"

#define ALIGN 64u

/* --- the block ---------------------------------------------------------- */

/* n += count * size, rounded up to ALIGN; false on overflow. */
static bool add_size(size_t *n, size_t count, size_t size)
{
    size_t bytes;

    if (__builtin_mul_overflow(count, size, &bytes) ||
        __builtin_add_overflow(bytes, ALIGN - 1, &bytes))
        return false;
    return !__builtin_add_overflow(*n, bytes / ALIGN * ALIGN, n);
}

/* Points of one axis; false on overflow. */
static bool count_points(int ndirs, const ix_dir *dirs, size_t *npts)
{
    *npts = 1;
    for (int d = 0; d < ndirs; d++)
        if (__builtin_mul_overflow(*npts, (size_t)dirs[d].length, npts))
            return false;
    return true;
}

static bool block_size(int ndirs, const ix_dir *dirs, int naxes, size_t npts,
                       size_t *bytes)
{
    size_t nknots = 0, ncoefs;

    for (int d = 0; d < ndirs; d++)
        nknots += (size_t)ix_knots_count(dirs + d);
    *bytes = 0;
    return !__builtin_mul_overflow(npts, (size_t)naxes, &ncoefs) &&
           add_size(bytes, 1, sizeof(ix_mv)) &&
           add_size(bytes, (size_t)ndirs, sizeof(ix_dir)) &&
           add_size(bytes, nknots, sizeof(double)) &&
           add_size(bytes, ncoefs, sizeof(double)) &&
           add_size(bytes, 1, ALIGN); /* to move the points to a boundary */
}

/* Directions and their knots behind the header; points behind those. */
static void lay_out(ix_mv *m, const ix_dir *dirs)
{
    double *knots;
    uintptr_t at;

    m->dirs = (ix_dir *)(m + 1);
    knots = (double *)(m->dirs + m->ndirs);
    for (int d = 0; d < m->ndirs; d++) {
        int n = ix_knots_count(dirs + d);

        m->dirs[d] = dirs[d];
        m->dirs[d].knots = n ? knots : NULL;
        if (n)
            memcpy(knots, dirs[d].knots, (size_t)n * sizeof(double));
        knots += n;
    }
    at = (uintptr_t)knots;
    m->pts = knots + (ALIGN - at % ALIGN) % ALIGN / sizeof(double);
}

ix_status ix__mv_alloc(ix_ctx *ctx, int ndirs, const ix_dir *dirs, int ncoords,
                       bool rational, ix_mv **out)
{
    int naxes = ncoords + rational;
    size_t npts, bytes;
    ix_mv *m;

    *out = NULL;
    if (!count_points(ndirs, dirs, &npts) ||
        !block_size(ndirs, dirs, naxes, npts, &bytes))
        return IX_FAIL(ctx, IX_ENOMEM,
                       "a multivariate with %d directions is too large", ndirs);
    m = ix__alloc(ctx, bytes);
    if (!m)
        return IX_ENOMEM;
    *m = (ix_mv){.refs = 1,
                 .ndirs = ndirs,
                 .ncoords = ncoords,
                 .naxes = naxes,
                 .rational = rational,
                 .npts = npts,
                 .bytes = bytes};
    lay_out(m, dirs);
    *out = m;
    return IX_OK;
}

ix_mv *ix_mv_ref(const ix_mv *m)
{
    ix_mv *own = (ix_mv *)(uintptr_t)m; /* the count is not part of the value */

    own->refs++;
    return own;
}

void ix_mv_unref(ix_ctx *ctx, const ix_mv *m)
{
    ix_mv *own = (ix_mv *)(uintptr_t)m;

    if (own && --own->refs == 0)
        ix__free(ctx, own, own->bytes);
}

/* --- checks ------------------------------------------------------------- */

/* Finite, non-decreasing knots, none of them more than order times; inside
 * the domain a knot may be repeated order times (a jump). Knots within tol of
 * the first of a group are one. */
static ix_status check_knots(ix_ctx *ctx, int d, const ix_dir *dir)
{
    int n = ix_knots_count(dir), first = 0;
    const double *k = dir->knots;
    double tol;

    for (int i = 0; i < n; i++)
        if (!isfinite(k[i]))
            return IX_FAIL(ctx, IX_EARG, "direction %d: knot %d is %g", d, i,
                           k[i]);
    tol = ix__knots_ulp4(n, k);
    for (int i = 1; i < n; i++) {
        if (k[i] < k[i - 1] - tol)
            return IX_FAIL(ctx, IX_EARG,
                           "direction %d: knot %d = %.17g is below knot %d = "
                           "%.17g",
                           d, i, k[i], i - 1, k[i - 1]);
        if (!(k[i] - k[first] <= tol))
            first = i;
        if (i - first >= dir->order)
            return IX_FAIL(ctx, IX_EARG,
                           "direction %d: knot %d = %.17g occurs more than "
                           "order = %d times",
                           d, i, k[i], dir->order);
    }
    return IX_OK;
}

static ix_status check_dir(ix_ctx *ctx, int d, const ix_dir *dir)
{
    double dom[2];
    int least = dir->periodic ? 1 : dir->order;

    if (dir->order < 1 || dir->order > IX_MAX_ORDER)
        return IX_FAIL(ctx, IX_EARG, "direction %d: order %d is not in 1 .. %d",
                       d, dir->order, IX_MAX_ORDER);
    if (dir->basis != IX_BSPLINE) {
        if (dir->length == dir->order && !dir->periodic)
            return IX_OK;
        return IX_FAIL(
            ctx, IX_EARG, "direction %d: %d points%s in a %s basis of order %d",
            d, dir->length, dir->periodic ? ", periodic," : "",
            dir->basis == IX_BEZIER ? "Bezier" : "power", dir->order);
    }
    if (dir->length < least || dir->length > INT32_MAX - 2 * IX_MAX_ORDER)
        return IX_FAIL(ctx, IX_EARG, "direction %d: %d points for order %d", d,
                       dir->length, dir->order);
    IX_TRY(check_knots(ctx, d, dir));
    ix__dir_domain(dir, dom);
    if (!(dom[1] - dom[0] > ix__knots_ulp4(2, dom)) ||
        !isfinite(dom[1] - dom[0]))
        return IX_FAIL(ctx, IX_EARG,
                       "direction %d: the domain [%.17g, %.17g] has no usable "
                       "length",
                       d, dom[0], dom[1]);
    return IX_OK;
}

ix_status ix__mv_check_dirs(ix_ctx *ctx, int ndirs, const ix_dir *dirs,
                            int ncoords)
{
    if (ndirs < 1 || ndirs > IX_MAX_DIRS)
        return IX_FAIL(ctx, IX_EARG, "%d directions are not in 1 .. %d", ndirs,
                       IX_MAX_DIRS);
    if (ncoords < 1 || ncoords > IX_MAX_COORDS)
        return IX_FAIL(ctx, IX_EARG, "%d coordinates are not in 1 .. %d",
                       ncoords, IX_MAX_COORDS);
    for (int d = 0; d < ndirs; d++)
        IX_TRY(check_dir(ctx, d, dirs + d));
    return IX_OK;
}

/* Finite; if rational, no point that is 0 in every axis (coefficients of a
 * power basis may vanish), and not all weights 0. */
static ix_status check_points(ix_ctx *ctx, int naxes, bool rational, bool power,
                              size_t npts, const double *pts)
{
    for (size_t i = 0; i < (size_t)naxes * npts; i++)
        if (!isfinite(pts[i]))
            return IX_FAIL(ctx, IX_EARG, "point %zu: coordinate %d is %g",
                           i % npts, (int)(i / npts), pts[i]);
    for (size_t i = 0; rational && !power && i < npts; i++) {
        int a = 0;

        while (a < naxes && pts[(size_t)a * npts + i] == 0)
            a++;
        if (a == naxes)
            return IX_FAIL(ctx, IX_EARG,
                           "point %zu: weight and coordinates are all zero", i);
    }
    for (size_t i = 0; rational; i++) {
        if (i == npts)
            return IX_FAIL(ctx, IX_EARG, "all %zu weights are zero", npts);
        if (pts[i] != 0)
            break;
    }
    return IX_OK;
}

double *ix__mv_knots(ix_mv *m, int dir)
{
    return (double *)(uintptr_t)m->dirs[dir].knots; /* inside m's own block */
}

void ix__mv_join_knots(const ix_dir *dir, double *k)
{
    int n = ix_knots_count(dir);
    double tol = n ? ix__knots_ulp4(n, k) : 0;

    for (int i = 1; i < n; i++)
        if (k[i] - k[i - 1] <= tol)
            k[i] = k[i - 1];
}

ix_status ix_mv_new(ix_ctx *ctx, int ndirs, const ix_dir *dirs, int ncoords,
                    bool rational, const double *pts, ix_mv **out)
{
    int naxes = ncoords + rational;
    size_t npts;
    bool power = false;
    ix_mv *m;

    *out = NULL;
    IX_TRY(ix__mv_check_dirs(ctx, ndirs, dirs, ncoords));
    for (int d = 0; d < ndirs; d++)
        power = power || dirs[d].basis == IX_POWER;
    if (!count_points(ndirs, dirs, &npts) || npts > SIZE_MAX / 256)
        return IX_FAIL(ctx, IX_EARG, "the product of the lengths is too large");
    IX_TRY(check_points(ctx, naxes, rational, power, npts, pts));
    IX_TRY(ix__mv_alloc(ctx, ndirs, dirs, ncoords, rational, &m));
    for (int d = 0; d < ndirs; d++)
        ix__mv_join_knots(m->dirs + d, ix__mv_knots(m, d));
    memcpy(m->pts, pts, (size_t)naxes * npts * sizeof(double));
    *out = m;
    return IX_OK;
}

/* --- reading ------------------------------------------------------------ */

int ix_mv_ndirs(const ix_mv *m)
{
    return m->ndirs;
}

ix_dir ix_mv_dir(const ix_mv *m, int dir)
{
    return m->dirs[dir];
}

int ix_mv_order(const ix_mv *m, int dir)
{
    return m->dirs[dir].order;
}

int ix_mv_length(const ix_mv *m, int dir)
{
    return m->dirs[dir].length;
}

int ix_mv_nknots(const ix_mv *m, int dir)
{
    return ix_knots_count(m->dirs + dir);
}

int ix_mv_ncoords(const ix_mv *m)
{
    return m->ncoords;
}

bool ix_mv_rational(const ix_mv *m)
{
    return m->rational;
}

int ix_mv_naxes(const ix_mv *m)
{
    return m->naxes;
}

size_t ix_mv_npts(const ix_mv *m)
{
    return m->npts;
}

const double *ix_mv_axis(const ix_mv *m, int axis)
{
    return m->pts + (size_t)axis * m->npts;
}

const double *ix_mv_coord(const ix_mv *m, int c)
{
    return ix_mv_axis(m, c + m->rational);
}

const double *ix_mv_weights(const ix_mv *m)
{
    return m->rational ? m->pts : NULL;
}

void ix_mv_domain(const ix_mv *m, int dir, double dom[2])
{
    ix__dir_domain(m->dirs + dir, dom);
}

size_t ix__mv_stride(const ix_mv *m, int dir)
{
    size_t s = 1;

    for (int d = 0; d < dir; d++)
        s *= (size_t)m->dirs[d].length;
    return s;
}
