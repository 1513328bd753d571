/* contact.c - see the header. */
#include "geom/contact.h"

#include "geom/unit_solve.h"
#include "geom/vec3.h"

/* Solutions that are not isolated end the search: regular cases need some
 * thousands. */
#define MAX_BOXES 20000

/* A freeform in all unknowns of a system: place, tangents, normal. */
typedef struct {
    ix__vec p, t[2], n;
} patch;

static ix_status check(ix_ctx *ctx, const ix_mv *m, int ndirs, const char *what)
{
    bool power = false;

    for (int d = 0; d < m->ndirs; d++)
        power = power || m->dirs[d].basis == IX_POWER;
    if (m->ndirs != ndirs || m->ncoords > 3 || power)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates%s; a Bezier or "
                       "B-spline %s of at most 3 coordinates is wanted",
                       m->ndirs, m->ncoords, power ? ", power basis" : "",
                       what);
    return IX_OK;
}

/* m with its parameters at `at` of n; dom gets their domains. */
static patch load(ix_pool *q, const ix_mv *m, int n, int at, double (*dom)[2])
{
    patch s = {.p = {{NULL}, NULL}};
    int nd = m->ndirs;
    ix__vec x;

    for (int d = 0; d < nd; d++)
        ix_mv_domain(m, d, dom[at + d]);
    m = ix__pool_unit(q, m);
    if (!m)
        return s;
    x = ix__vec_of(q, m);
    for (int d = 0; d < nd; d++)
        s.t[d] = ix__vec_tangent(q, x, d);
    if (nd == 2)
        s.n = ix__vec_promote(q, ix__vec_cross(q, s.t[0], s.t[1]), n, at);
    for (int d = 0; d < nd; d++)
        s.t[d] = ix__vec_promote(q, s.t[d], n, at);
    s.p = ix__vec_promote(q, x, n, at);
    return s;
}

/* The tangent plane with normal n of a is that of b: three conditions. */
static void same_plane(ix_pool *q, const patch *a, const patch *b, ix__vec n,
                       const ix_mv **f)
{
    for (int d = 0; d < 2; d++)
        f[d] = ix__vec_dot(q, b->t[d], n);
    f[2] = ix__vec_dot(q, ix__vec_between(q, a->p, b->p), n);
}

static ix_status bitangents(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                            const ix_curves_opts *o, ix_solution_curves *out)
{
    ix_pool q = {.ctx = ctx};
    const ix_mv *f[3];
    double dom[4][2];
    patch s[2];

    s[0] = load(&q, a, 4, 0, dom);
    s[1] = load(&q, b, 4, 2, dom);
    same_plane(&q, &s[1], &s[0], s[1].n, f);
    return ix__unit_curves(&q, 3, f, (const double(*)[2])dom, o, out);
}

/* Of surfaces with a symmetry (moved copies of each other, say) several curves
 * touch in points, around which cells must be so much smaller than their
 * distance from it that the budget does not reach down to the smallest: these
 * points are located to a hundredth of the domain then. */
ix_status ix__srf_bitangents(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                             double tol, ix_solution_curves *out)
{
    const ix_curves_opts fine = {.tol = tol, .max_boxes = MAX_BOXES};
    const ix_curves_opts coarse = {
        .tol = tol, .cell = 0.01, .crowd = 2048, .max_boxes = 5 * MAX_BOXES};

    *out = (ix_solution_curves){.unknowns = 0};
    IX_TRY(check(ctx, a, 2, "surface"));
    IX_TRY(check(ctx, b, 2, "surface"));
    IX_TRY(bitangents(ctx, a, b, &fine, out));
    if (out->complete)
        return IX_OK;
    ix_solution_curves_free(ctx, out);
    return bitangents(ctx, a, b, &coarse, out);
}

ix_status ix__srf_tritangents(ix_ctx *ctx, const ix_mv *const s[3],
                              ix_solutions *out)
{
    const ix_solve_opts o = {.max_boxes = MAX_BOXES};
    ix_pool q = {.ctx = ctx};
    const ix_mv *f[6];
    double dom[6][2];
    patch p[3];

    *out = (ix_solutions){.n = 0};
    for (int k = 0; k < 3; k++)
        IX_TRY(check(ctx, s[k], 2, "surface"));
    for (int k = 0; k < 3; k++)
        p[k] = load(&q, s[k], 6, 2 * k, dom);
    same_plane(&q, &p[0], &p[1], p[0].n, f);
    same_plane(&q, &p[0], &p[2], p[0].n, f + 3);
    return ix__unit_solve(&q, 6, f, (const double(*)[2])dom, &o, out);
}

/* --- motions
 * ----------------------------------------------------------------- */

static ix_status check_motion(ix_ctx *ctx, const ix_mv *mov, const ix_mv *scl)
{
    double a[2], b[2];

    if (!mov && !scl)
        return IX_FAIL(ctx, IX_EARG, "there is no motion");
    if (mov)
        IX_TRY(check(ctx, mov, 1, "curve"));
    if (scl)
        IX_TRY(check(ctx, scl, 1, "curve"));
    if (!mov || !scl)
        return IX_OK;
    ix_mv_domain(mov, 0, a);
    ix_mv_domain(scl, 0, b);
    if (a[0] < b[0] || a[0] > b[0] || a[1] < b[1] || a[1] > b[1])
        return IX_FAIL(ctx, IX_EARG,
                       "the motion lasts from %g to %g, the scaling from %g to "
                       "%g",
                       a[0], a[1], b[0], b[1]);
    return IX_OK;
}

/* Their product; NULL is 1. */
static const ix_mv *both_weights(ix_pool *q, const ix_mv *a, const ix_mv *b)
{
    return a && b ? ix__pool_mul(q, a, b) : a ? a : b;
}

/* scl(t) p + mov(t). */
static ix__vec moved(ix_pool *q, ix__vec p, const ix_mv *mov, const ix_mv *scl,
                     double (*dom)[2])
{
    if (scl) {
        patch s = load(q, scl, 5, 4, dom);

        p = ix__vec_times(q, p, s.p.x[0]);
        p.w = both_weights(q, p.w, s.p.w);
    }
    if (mov) {
        patch m = load(q, mov, 5, 4, dom);
        ix__vec sum;

        /* p / w + m / v = (p v + m w) / (w v) */
        sum = ix__vec_add(q, ix__vec_times(q, p, m.p.w),
                          ix__vec_times(q, m.p, p.w));
        sum.w = both_weights(q, p.w, m.p.w);
        p = sum;
    }
    return p;
}

ix_status ix__srf_contacts(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                           const ix_mv *mov, const ix_mv *scl,
                           ix_solutions *out)
{
    const ix_solve_opts o = {.max_boxes = MAX_BOXES};
    ix_pool q = {.ctx = ctx};
    const ix_mv *f[5];
    double dom[5][2];
    patch s[2];
    ix__vec d;

    *out = (ix_solutions){.n = 0};
    IX_TRY(check(ctx, a, 2, "surface"));
    IX_TRY(check(ctx, b, 2, "surface"));
    IX_TRY(check_motion(ctx, mov, scl));
    s[0] = load(&q, a, 5, 0, dom);
    s[1] = load(&q, b, 5, 2, dom);
    d = ix__vec_between(&q, s[0].p, moved(&q, s[1].p, mov, scl, dom));
    for (int k = 0; k < 3; k++)
        f[k] = d.x[k];
    for (int k = 0; k < 2; k++)
        f[3 + k] = ix__vec_dot(&q, s[0].t[k], s[1].n);
    return ix__unit_solve(&q, 5, f, (const double(*)[2])dom, &o, out);
}

/* --- rays and feet
 * ------------------------------------------------------------- */

/* Is K - S along the direction, and that direction in the tangent plane of K?
 */
static void touches(ix_pool *q, const patch *s, const patch *k,
                    const double *dir, const ix_mv **f)
{
    ix__vec d = ix__vec_between(q, k->p, s->p);

    if (dir) {
        double e[2][3];

        ix__perp3(dir, e[0]);
        ix__cross3(dir, e[0], e[1]);
        for (int i = 0; i < 2; i++)
            f[i] = ix__vec_dot_const(q, d, e[i]);
        f[2] = ix__vec_dot_const(q, k->n, dir);
        return;
    }
    for (int i = 0; i < 2; i++)
        f[i] = ix__vec_dot(q, d, s->t[i]);
    f[2] = ix__vec_dot(q, s->n, k->n);
}

ix_status ix__srf_access(ix_ctx *ctx, const ix_mv *s, const double *dir,
                         const ix_mv *surface, double tol,
                         ix_solution_curves *out)
{
    const ix_curves_opts o = {.tol = tol, .max_boxes = MAX_BOXES};
    ix_pool q = {.ctx = ctx};
    const ix_mv *f[3];
    double dom[4][2], unit[3];
    patch p[2];

    *out = (ix_solution_curves){.unknowns = 0};
    IX_TRY(check(ctx, s, 2, "surface"));
    IX_TRY(check(ctx, surface, 2, "surface"));
    if (dir)
        IX_TRY(ix__direction(ctx, "the orientation", dir, unit));
    p[0] = load(&q, s, 4, 0, dom);
    p[1] = load(&q, surface, 4, 2, dom);
    touches(&q, &p[0], &p[1], dir ? unit : NULL, f);
    return ix__unit_curves(&q, 3, f, (const double(*)[2])dom, &o, out);
}

ix_status ix__crv_srf_feet(ix_ctx *ctx, const ix_mv *c, const ix_mv *s,
                           double tol, ix_solution_curves *out)
{
    const ix_curves_opts o = {.tol = tol, .max_boxes = MAX_BOXES};
    ix_pool q = {.ctx = ctx};
    const ix_mv *f[2];
    double dom[3][2];
    patch p[2];
    ix__vec d;

    *out = (ix_solution_curves){.unknowns = 0};
    IX_TRY(check(ctx, c, 1, "curve"));
    IX_TRY(check(ctx, s, 2, "surface"));
    p[0] = load(&q, c, 3, 0, dom);
    p[1] = load(&q, s, 3, 1, dom);
    d = ix__vec_between(&q, p[0].p, p[1].p);
    for (int k = 0; k < 2; k++)
        f[k] = ix__vec_dot(&q, d, p[1].t[k]);
    return ix__unit_curves(&q, 2, f, (const double(*)[2])dom, &o, out);
}
