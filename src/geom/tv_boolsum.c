/* tv_boolsum.c - see the header. The Boolean sum is built one pair of faces
 * after the other: what the volume so far misses of a face is added, fading out
 * towards the opposite one. */
#include "geom/tv_boolsum.h"

#include "geom/parts.h"
#include "geom/unit_solve.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"

static double largest(const ix_mv *m)
{
    double most = 0;

    for (size_t i = 0; m && i < m->npts * (size_t)m->naxes; i++)
        most = fmax(most, fabs(m->pts[i]));
    return most;
}

/* a and b faces for direction d = 0 or 1 at its ends: ruled, d in its place. */
static const ix_mv *between(ix_pool *q, const ix_mv *a, const ix_mv *b, int d)
{
    const ix_mv *m;

    if (q->st != IX_OK)
        return NULL;
    m = ix__pool_made(q, ix_srf_ruled(q->ctx, a, b, ix__pool_room(q)));
    for (int at = 2; m && at > d; at--)
        m = ix__pool_made(
            q, ix_mv_swap_dirs(q->ctx, m, at, at - 1, ix__pool_room(q)));
    return m;
}

static const ix_mv *face_of(ix_pool *q, const ix_mv *m, int dir, double t)
{
    return q->st == IX_OK ? ix__pool_made(q, ix_mv_fix(q->ctx, m, dir, t,
                                                       ix__pool_room(q)))
                          : NULL;
}

static const ix_mv *minus(ix_pool *q, const ix_mv *a, const ix_mv *b)
{
    return q->st == IX_OK && a && b ? ix__pool_sub(q, a, b) : NULL;
}

/* m with the faces a, b put right at the ends of direction dir. */
static const ix_mv *corrected(ix_pool *q, const ix_mv *m, const ix_mv *a,
                              const ix_mv *b, int dir)
{
    const ix_mv *ra = minus(q, a, face_of(q, m, dir, 0));
    const ix_mv *rb = minus(q, b, face_of(q, m, dir, 1));
    const ix_mv *add = between(q, ra, rb, dir);

    return q->st == IX_OK ? ix__pool_add(q, m, add) : NULL;
}

static void check_faces(ix_pool *q, const ix_mv *m, const ix_mv *const f[6],
                        int n)
{
    for (int i = 0; q->st == IX_OK && i < n; i++) {
        double gap = largest(minus(q, f[i], face_of(q, m, i / 2, i % 2)));
        double size = largest(f[i]);

        if (q->st == IX_OK && !(gap <= 1e-5 * size))
            q->st = IX_FAIL(q->ctx, IX_EARG,
                            "face %d does not meet the others: edges are up to "
                            "%g apart",
                            i + 1, gap);
    }
}

ix_status ix__tv_boolsum(ix_ctx *ctx, const ix_mv *const f[6], ix_mv **out)
{
    const ix_mv *u[6] = {NULL}, *m;
    ix_pool q = {.ctx = ctx};
    int n = f[4] && f[5] ? 6 : 4;

    *out = NULL;
    for (int i = 0; i < n; i++) {
        if (f[i]->ndirs != 2 || f[i]->rational || f[i]->ncoords > 3 ||
            f[i]->ncoords != f[0]->ncoords)
            return IX_FAIL(ctx, IX_EARG,
                           "face %d: a polynomial surface of %d coordinates "
                           "is wanted",
                           i + 1, f[0]->ncoords > 3 ? 3 : f[0]->ncoords);
    }
    for (int i = 0; i < n; i++)
        u[i] = ix__pool_unit(&q, f[i]);
    m = between(&q, u[0], u[1], 0);
    for (int d = 1; m && d < n / 2; d++)
        m = corrected(&q, m, u[2 * d], u[2 * d + 1], d);
    check_faces(&q, m, u, n);
    return ix__pool_give(&q, m, out);
}

/* --- tubes
 * ------------------------------------------------------------------- */

static ix_status fill_layer(ix_ctx *ctx, const ix_mv *tube, int i, ix_mv **out)
{
    ix_mv *crv;
    ix_status st;

    IX_TRY(ix_mv_layer(ctx, tube, 1, i, &crv));
    st = ix_srf_boolone(ctx, crv, out);
    ix_mv_unref(ctx, crv);
    return st;
}

/* The tube is a B-spline. */
static ix_status boolone(ix_ctx *ctx, const ix_mv *tube, ix_mv **out)
{
    ix_dir dir = ix_mv_dir(tube, 1);
    ix_status st = IX_OK;
    ix_mv **layer;

    IX_SCRATCH(ctx, layer, dir.length);
    for (int i = 0; i < dir.length; i++)
        layer[i] = NULL;
    for (int i = 0; st == IX_OK && i < dir.length; i++)
        st = fill_layer(ctx, tube, i, &layer[i]);
    if (st == IX_OK)
        st = ix_mv_stack(ctx, dir.length, (const ix_mv *const *)layer, &dir,
                         out);
    ix__mv_unref_all(ctx, layer, dir.length);
    return st;
}

ix_status ix__tv_boolone(ix_ctx *ctx, const ix_mv *tube, ix_mv **out)
{
    ix_mv *b = NULL, *open = NULL;
    ix_mark mk;
    ix_status st;

    *out = NULL;
    if (tube->ndirs != 2)
        return IX_FAIL(ctx, IX_EARG, "%d directions; a surface is wanted",
                       tube->ndirs);
    mk = ix__scratch_mark(ctx);
    st = ix_mv_to_bspline(ctx, tube, &b);
    if (st == IX_OK)
        st = ix_mv_to_open(ctx, b, &open);
    if (st == IX_OK)
        st = boolone(ctx, open, out);
    ix__scratch_release(ctx, mk);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, open);
    return st;
}

/* --- Hermite with a section
 * ---------------------------------------------------- */

static ix_status check_section(ix_ctx *ctx, const ix_mv *const c[6])
{
    double dom[2], x[2][IX_MAX_COORDS] = {{0}};

    for (int i = 0; i < 6; i++)
        if (c[i]->ndirs != 1 || c[i]->ncoords > 3 || c[i]->rational)
            return IX_FAIL(ctx, IX_EARG,
                           "curve %d: a polynomial curve of at most 3 "
                           "coordinates is wanted",
                           i + 1);
    ix_mv_domain(c[4], 0, dom);
    for (int e = 0; e < 2; e++)
        IX_TRY(ix_mv_point(ctx, c[4], &dom[e], x[e]));
    if (!(fabs(x[0][0] + 1) + fabs(x[0][1]) + fabs(x[1][0] - 1) +
              fabs(x[1][1]) <=
          1e-5))
        return IX_FAIL(ctx, IX_EARG,
                       "the section goes from (%g, %g) to (%g, %g), not from "
                       "(-1, 0) to (1, 0)",
                       x[0][0], x[0][1], x[1][0], x[1][1]);
    return IX_OK;
}

/* The cubic Bernstein polynomial i of (1 + x) / 2, x in *p (1 + x) / 2 and *r
 * (1 - x) / 2. */
static const ix_mv *bernstein(ix_pool *q, const ix_mv *p, const ix_mv *r, int i)
{
    static const double binomial[4] = {1, 3, 3, 1};
    const ix_mv *f = i > 0 ? p : r;

    for (int k = 1; k < 3; k++)
        f = q->st == IX_OK ? ix__pool_mul(q, f, k < i ? p : r) : NULL;
    return q->st == IX_OK ? ix__pool_scale(q, f, binomial[i]) : NULL;
}

/* Control curve i of the Hermite surface. */
static ix__vec row(ix_pool *q, const ix__vec b[4], int i)
{
    ix__vec v = b[i / 2], t = b[2 + i / 2];

    for (int k = 0; k < 3 && (i == 1 || i == 2); k++)
        if (t.x[k] && q->st == IX_OK)
            v.x[k] = ix__sum0(
                q, v.x[k],
                ix__pool_scale(q, t.x[k], i == 1 ? 1.0 / 3 : -1.0 / 3));
    return v;
}

static ix__vec section_hermite(ix_pool *q, const ix__vec b[6])
{
    const double half[2] = {0.5, 0.5};
    ix__vec sum = {{NULL}, NULL};
    const ix_mv *x, *p, *r;

    x = ix__pool_scale(q, b[4].x[0], 0.5);
    p = ix__sum0(q, ix__pool_linear(q, half, 2, 0), x);
    r = ix__diff0(q, ix__pool_linear(q, half, 2, 0), x);
    for (int i = 0; i < 4; i++)
        sum = ix__vec_add(
            q, sum, ix__vec_times(q, row(q, b, i), bernstein(q, p, r, i)));
    if (!b[4].x[1])
        return sum;
    return ix__vec_add(q, sum, ix__vec_times(q, b[5], b[4].x[1]));
}

ix_status ix__srf_section_hermite(ix_ctx *ctx, const ix_mv *const c[6],
                                  ix_mv **out)
{
    ix_pool q = {.ctx = ctx};
    const double zero[2] = {0, 0};
    const ix_mv *axis[3];
    ix__vec b[6], sum;

    *out = NULL;
    IX_TRY(check_section(ctx, c));
    for (int i = 0; i < 6; i++) {
        const ix_mv *u = ix__pool_unit(&q, c[i]);

        b[i] = u ? ix__vec_promote(&q, ix__vec_of(&q, u), 2, i == 4 ? 0 : 1)
                 : (ix__vec){{NULL}, NULL};
    }
    if (q.st == IX_OK)
        sum = section_hermite(&q, b);
    for (int k = 0; q.st == IX_OK && k < 3; k++)
        axis[k] = sum.x[k] ? sum.x[k] : ix__pool_linear(&q, zero, 2, 0);
    if (q.st == IX_OK)
        q.st = ix_mv_join_scalars(ctx, 3, axis, false, out);
    ix__pool_free(&q);
    return q.st;
}
