/* region.c - a part of a multivariate, and the two parts of a split. */
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "mv/mv.h"

static ix_status clip_bezier(ix_ctx *ctx, const ix_mv *m, int dir,
                             const double t[2], ix_mv **out)
{
    ix__mv_extent s = ix__mv_shape(m, dir);
    size_t block = (size_t)m->dirs[dir].order * s.inner;

    IX_TRY(ix__mv_alloc_like(ctx, m, dir, m->dirs + dir, out));
    for (size_t o = 0; o < s.outer; o++)
        ix__bern_restrict(m->dirs[dir].order - 1, t[0], t[1], s.inner,
                          m->pts + o * block, (*out)->pts + o * block);
    return IX_OK;
}

/* Open knots on [t0, t1]: order times each end, dir's knots between. */
static ix_status clip_knots(ix_ctx *ctx, const ix_dir *dir, const double t[2],
                            ix_dir *out)
{
    int n = ix_knots_count(dir), o = dir->order, i = 0, inside = 0;
    double *kv;

    while (i < n && dir->knots[i] <= t[0])
        i++;
    while (i + inside < n && dir->knots[i + inside] < t[1])
        inside++;
    IX_SCRATCH(ctx, kv, inside + 2 * o);
    for (int k = 0; k < o; k++) {
        kv[k] = t[0];
        kv[o + inside + k] = t[1];
    }
    memcpy(kv + o, dir->knots + i, (size_t)inside * sizeof *kv);
    *out = (ix_dir){IX_BSPLINE, o, o + inside, false, kv};
    return IX_OK;
}

ix_status ix__mv_clip(ix_ctx *ctx, const ix_mv *m, int dir, const double t[2],
                      ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;
    ix_rows rows;
    ix_dir nd;

    *out = NULL;
    st = clip_knots(ctx, m->dirs + dir, t, &nd);
    if (st == IX_OK)
        st = ix__rows_refine(ctx, m->dirs + dir, nd.length, nd.knots, &rows);
    if (st == IX_OK)
        st = ix__mv_map(ctx, m, dir, &rows, &nd, out);
    ix__scratch_release(ctx, mk);
    return st;
}

/* A parameter of a B-spline direction: inside the domain up to rounding, and
 * the nearby knot if there is one (1e-12, spec/model 2, of the domain's
 * length): no slivers. */
static ix_status settle(ix_ctx *ctx, const ix_dir *dir, int d, double *t)
{
    int n = ix_knots_count(dir);
    double dom[2], near;

    ix__dir_domain(dir, dom);
    near = 1e-12 * (dom[1] - dom[0]);
    if (!(*t >= dom[0] - near && *t <= dom[1] + near))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "parameter %.17g of direction %d is outside the domain "
                       "[%.17g, %.17g]",
                       *t, d, dom[0], dom[1]);
    for (int i = 0; i < n; i++)
        if (dir->knots[i] >= dom[0] && dir->knots[i] <= dom[1] &&
            fabs(dir->knots[i] - *t) <= near) {
            *t = dir->knots[i];
            break;
        }
    return IX_OK;
}

static ix_status clip_any(ix_ctx *ctx, const ix_mv *m, int dir,
                          const double t[2], ix_mv **out)
{
    if (m->dirs[dir].basis == IX_BSPLINE)
        return ix__mv_clip(ctx, m, dir, t, out);
    return clip_bezier(ctx, m, dir, t, out);
}

/* Checks shared by region and split. */
static ix_status check(ix_ctx *ctx, const ix_mv *m, int dir, double *t)
{
    IX_TRY(ix__mv_check_dir(ctx, m, dir));
    if (m->dirs[dir].basis == IX_POWER)
        return IX_FAIL(ctx, IX_EARG, "direction %d: power basis", dir);
    if (!isfinite(*t))
        return IX_FAIL(ctx, IX_EDOMAIN, "parameter %g of direction %d", *t,
                       dir);
    if (m->dirs[dir].basis == IX_BSPLINE)
        return settle(ctx, m->dirs + dir, dir, t);
    return IX_OK;
}

ix_status ix_mv_region(ix_ctx *ctx, const ix_mv *m, int dir, double t0,
                       double t1, ix_mv **out)
{
    double t[2] = {t0 < t1 ? t0 : t1, t0 < t1 ? t1 : t0};

    *out = NULL;
    IX_TRY(check(ctx, m, dir, t));
    IX_TRY(check(ctx, m, dir, t + 1));
    if (!(t[0] < t[1]))
        return IX_FAIL(ctx, IX_EDOMAIN, "region [%.17g, %.17g] has no length",
                       t0, t1);
    return clip_any(ctx, m, dir, t, out);
}

/* --- split -------------------------------------------------------------- */

/* The common layer, computed from either side, becomes one. */
static void same_joint(const ix_mv *a, ix_mv *b, int dir)
{
    ix__mv_extent s = ix__mv_shape(a, dir);
    size_t na = (size_t)a->dirs[dir].length, nb = (size_t)b->dirs[dir].length;

    for (size_t o = 0; o < s.outer; o++)
        memcpy(b->pts + o * nb * s.inner, a->pts + (o * na + na - 1) * s.inner,
               s.inner * sizeof *a->pts);
}

static bool jumps_at(const ix_dir *dir, double t)
{
    int n = ix_knots_count(dir), m = 0;

    for (int i = 0; i < n; i++)
        m += dir->knots[i] == t;
    return m >= dir->order;
}

ix_status ix_mv_split(ix_ctx *ctx, const ix_mv *m, int dir, double t,
                      ix_mv *out[2])
{
    double left[2], right[2];
    ix_status st;

    out[0] = out[1] = NULL;
    IX_TRY(check(ctx, m, dir, &t));
    ix_mv_domain(m, dir, left);
    if (!(t > left[0] && t < left[1]))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "split of direction %d at %.17g, which is not inside "
                       "[%.17g, %.17g]",
                       dir, t, left[0], left[1]);
    right[0] = t;
    right[1] = left[1];
    left[1] = t;
    IX_TRY(clip_any(ctx, m, dir, left, out));
    st = clip_any(ctx, m, dir, right, out + 1);
    if (st != IX_OK) {
        ix_mv_unref(ctx, out[0]);
        out[0] = NULL;
        return st;
    }
    if (!jumps_at(m->dirs + dir, t))
        same_joint(out[0], out[1], dir);
    return IX_OK;
}
