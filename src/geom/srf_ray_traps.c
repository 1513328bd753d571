/* srf_ray_traps.c - light caught between two surfaces. */
#include <math.h>

#include "geom/unit_solve.h"
#include "iritx/distance.h"

static ix_status check(ix_ctx *ctx, const ix_mv *m)
{
    if (m->ndirs != 2 || m->ncoords > 3 || m->dirs[0].basis == IX_POWER ||
        m->dirs[1].basis == IX_POWER)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; Bezier or B-spline "
                       "surfaces of at most 3 are wanted",
                       m->ndirs, m->ncoords);
    return IX_OK;
}

/* Point and tangents of m with its parameters at `at` of four. */
static void load(ix_pool *q, const ix_mv *m, int at, double (*dom)[2],
                 ix__vec *p, ix__vec t[2])
{
    ix__vec x;

    for (int d = 0; d < 2; d++)
        ix_mv_domain(m, d, dom[at + d]);
    m = ix__pool_unit(q, m);
    if (!m)
        return;
    x = ix__vec_of(q, m);
    *p = ix__vec_promote(q, x, 4, at);
    for (int d = 0; d < 2; d++)
        t[d] = ix__vec_promote(q, ix__vec_tangent(q, x, d), 4, at);
}

/* Chords without a length, where the surfaces meet, are left out. */
static ix_status keep(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                      ix_solutions *s)
{
    int n = 0;

    for (int i = 0; i < s->n; i++) {
        double p[IX_MAX_COORDS] = {0}, r[IX_MAX_COORDS] = {0};
        double far = 0, size = 0;

        IX_TRY(ix_mv_point(ctx, a, s->sol[i].x, p));
        IX_TRY(ix_mv_point(ctx, b, s->sol[i].x + 2, r));
        for (int k = 0; k < 3; k++) {
            far = fmax(far, fabs(p[k] - r[k]));
            size = fmax(size, fmax(fabs(p[k]), fabs(r[k])));
        }
        /* a point on both, to the accuracy of solutions that are not simple */
        if (far > 1e-7 * size)
            s->sol[n++] = s->sol[i];
    }
    s->n = n;
    return IX_OK;
}

ix_status ix_srf_ray_traps(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                           ix_solutions *out)
{
    const ix_solve_opts o = {.max_boxes = 200000};
    ix_pool q = {.ctx = ctx};
    ix__vec p[2] = {{{NULL}, NULL}}, t[4] = {{{NULL}, NULL}}, chord;
    const ix_mv *f[4];
    double dom[4][2];
    ix_status st;

    *out = (ix_solutions){.n = 0};
    IX_TRY(check(ctx, a));
    IX_TRY(check(ctx, b));
    load(&q, a, 0, dom, &p[0], &t[0]);
    load(&q, b, 2, dom, &p[1], &t[2]);
    chord = ix__vec_between(&q, p[0], p[1]);
    for (int i = 0; i < 4; i++)
        f[i] = ix__vec_dot(&q, chord, t[i]);
    IX_TRY(ix__unit_solve(&q, 4, f, (const double(*)[2])dom, &o, out));
    st = keep(ctx, a, b, out);
    if (st != IX_OK)
        ix_solutions_free(ctx, out);
    return st;
}
