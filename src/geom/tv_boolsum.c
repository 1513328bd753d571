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
