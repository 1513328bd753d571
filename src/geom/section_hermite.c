/* section_hermite.c - see the header. Numerators and weights go through the
 * formula apart, so that common weights count once. */
#include "geom/section_hermite.h"

#include <math.h>

#include "geom/unit_solve.h"

ix_status ix__section_check(ix_ctx *ctx, const ix_mv *section)
{
    double dom[2], x[2][IX_MAX_COORDS] = {{0}};

    if (section->ndirs != 1 || section->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "the section has %d directions and %d coordinates; a "
                       "curve of at most 3 is wanted",
                       section->ndirs, section->ncoords);
    ix_mv_domain(section, 0, dom);
    for (int e = 0; e < 2; e++)
        IX_TRY(ix_mv_point(ctx, section, &dom[e], x[e]));
    if (!(fabs(x[0][0] + 1) + fabs(x[0][1]) + fabs(x[1][0] - 1) +
              fabs(x[1][1]) <=
          1e-5))
        return IX_FAIL(ctx, IX_EARG,
                       "the section goes from (%g, %g) to (%g, %g), not from "
                       "(-1, 0) to (1, 0)",
                       x[0][0], x[0][1], x[1][0], x[1][1]);
    return IX_OK;
}

/* --- weights, NULL being 1 --------------------------------------------------
 */

/* Equal up to rounding of their computation. */
static bool same(const ix_mv *a, const ix_mv *b)
{
    double size = 0;

    if (a == b || !a || !b)
        return a == b;
    for (size_t i = 0; i < a->npts; i++)
        size = fmax(size, fabs(a->pts[i]));
    return ix_mv_equal(a, b, 1e-14 * size);
}

static const ix_mv *times(ix_pool *q, const ix_mv *a, const ix_mv *b)
{
    return !a ? b : !b ? a : ix__pool_mul(q, a, b);
}

/* a + f b as fractions. */
static ix__vec sum(ix_pool *q, ix__vec a, ix__vec b, double f)
{
    const ix_mv *w = a.w;
    ix__vec v;

    if (!same(a.w, b.w)) {
        w = times(q, a.w, b.w);
        v = ix__vec_times(q, a, b.w);
        b = ix__vec_times(q, b, a.w);
        a = v;
    }
    for (int k = 0; k < 3; k++)
        if (b.x[k] && (f < 1 || f > 1))
            b.x[k] = ix__pool_scale(q, b.x[k], f);
    v = ix__vec_add(q, a, b);
    v.w = w;
    return v;
}

/* --- the surface ------------------------------------------------------------
 */

/* The numerator of the cubic Bernstein polynomial i of (1 + x) / 2: p = (w + x)
 * / 2 and r = (w - x) / 2 for the section x / w. */
static const ix_mv *bernstein(ix_pool *q, const ix_mv *p, const ix_mv *r, int i)
{
    static const double binomial[4] = {1, 3, 3, 1};
    const ix_mv *f = i > 0 ? p : r;

    for (int k = 1; k < 3; k++)
        f = q->st == IX_OK ? ix__pool_mul(q, f, k < i ? p : r) : NULL;
    return q->st == IX_OK ? ix__pool_scale(q, f, binomial[i]) : NULL;
}

/* The half of the Hermite surface that belongs to end e. */
static ix__vec end_half(ix_pool *q, const ix__section_hermite *h, int e,
                        const ix_mv *p, const ix_mv *r)
{
    ix__vec in = sum(q, h->b[e], h->t[e], e ? -1.0 / 3 : 1.0 / 3);
    ix__vec at = h->b[e], v;

    if (!same(at.w, in.w)) { /* in has the factor of t, too */
        at = ix__vec_times(q, at, h->t[e].w);
        at.w = in.w;
    }
    v = ix__vec_add(q, ix__vec_times(q, at, bernstein(q, p, r, e ? 3 : 0)),
                    ix__vec_times(q, in, bernstein(q, p, r, e ? 2 : 1)));
    v.w = in.w;
    return v;
}

static ix__vec surface(ix_pool *q, const ix__section_hermite *h)
{
    const double one[2] = {1, 1};
    const ix_mv *x = h->section.x[0], *w = h->section.w, *p, *r;
    const ix_mv *unit = w ? w : ix__pool_linear(q, one, 2, 0);
    ix__vec v, n = h->normal;

    p = ix__pool_scale(q, ix__sum0(q, unit, x), 0.5);
    r = ix__pool_scale(q, ix__diff0(q, unit, x), 0.5);
    v = sum(q, end_half(q, h, 0, p, r), end_half(q, h, 1, p, r), 1);
    if (h->section.x[1]) { /* over the section's weight to the third */
        n = ix__vec_times(q, n, h->section.x[1]);
        for (int k = 0; k < 2; k++)
            n = ix__vec_times(q, n, w);
        v = sum(q, v, n, 1);
    }
    for (int k = 0; w && k < 3; k++)
        v.w = times(q, v.w, w);
    return v;
}

ix_status ix__section_hermite_make(ix_pool *q, const ix__section_hermite *h,
                                   ix_mv **out)
{
    const double zero[2] = {0, 0};
    const ix_mv *axis[4];
    ix__vec v = {{NULL}, NULL};
    int n = 0;

    *out = NULL;
    if (q->st == IX_OK)
        v = surface(q, h);
    if (v.w)
        axis[n++] = v.w;
    for (int k = 0; q->st == IX_OK && k < 3; k++)
        axis[n++] = v.x[k] ? v.x[k] : ix__pool_linear(q, zero, 2, 0);
    if (q->st == IX_OK)
        q->st = ix_mv_join_scalars(q->ctx, n, axis, n == 4, out);
    ix__pool_free(q);
    return q->st;
}

ix_status ix__srf_section_hermite(ix_ctx *ctx, const ix_mv *const c[6],
                                  ix_mv **out)
{
    ix_pool q = {.ctx = ctx};
    ix__vec b[6];

    *out = NULL;
    for (int i = 0; i < 6; i++)
        if (c[i]->ndirs != 1 || c[i]->ncoords > 3)
            return IX_FAIL(ctx, IX_EARG,
                           "curve %d: a curve of at most 3 coordinates is "
                           "wanted",
                           i + 1);
    IX_TRY(ix__section_check(ctx, c[4]));
    for (int i = 0; i < 6; i++) {
        const ix_mv *u = ix__pool_unit(&q, c[i]);

        b[i] = u ? ix__vec_promote(&q, ix__vec_of(&q, u), 2, i == 4 ? 0 : 1)
                 : (ix__vec){{NULL}, NULL};
    }
    return ix__section_hermite_make(
        &q, &(ix__section_hermite){{b[0], b[1]}, {b[2], b[3]}, b[4], b[5]},
        out);
}
