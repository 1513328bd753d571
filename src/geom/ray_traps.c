/* ray_traps.c - closed paths of light between planar curves, one bounce on
 * each, in order.
 *
 * At curve i, with chords a and b to the points before and after, the angles
 * with the tangent T agree:  (a.T) / |a| + (b.T) / |b| = 0. Squared it is
 * polynomial; the other sign, light that goes on straight, is left out after.
 * Of two curves both chords are one, which is normal at both ends. */
#include <math.h>

#include "geom/unit_solve.h"
#include "iritx/distance.h"
#include "iritx/geom.h"

typedef struct {
    ix__vec p, t; /* point and tangent direction in all parameters */
} bounce;

static void load(ix_pool *q, int n, const ix_mv *const *crv, bounce *b,
                 double (*dom)[2])
{
    for (int i = 0; i < n; i++) {
        const ix_mv *c = ix__pool_unit(q, crv[i]);
        ix__vec x;

        ix_mv_domain(crv[i], 0, dom[i]);
        if (!c)
            return;
        x = ix__vec_of(q, c);
        x.x[2] = NULL;
        b[i].p = ix__vec_promote(q, x, n, i);
        b[i].t = ix__vec_promote(q, ix__vec_tangent(q, x, 0), n, i);
    }
}

/* (a.T)^2 |b|^2 - (b.T)^2 |a|^2; the chords' factors of weight cancel. */
static const ix_mv *reflection(ix_pool *q, const bounce *from, const bounce *at,
                               const bounce *to)
{
    ix__vec a = ix__vec_between(q, from->p, at->p);
    ix__vec b = ix__vec_between(q, to->p, at->p);
    const ix_mv *at_a = ix__vec_dot(q, a, at->t), *at_b;

    at_b = ix__vec_dot(q, b, at->t);
    return ix__diff0(
        q, ix__prod0(q, ix__prod0(q, at_a, at_a), ix__vec_dot(q, b, b)),
        ix__prod0(q, ix__prod0(q, at_b, at_b), ix__vec_dot(q, a, a)));
}

static ix_status point_of(ix_ctx *ctx, const ix_mv *c, double t, double p[2])
{
    double x[IX_MAX_COORDS] = {0};

    IX_TRY(ix_mv_point(ctx, c, &t, x));
    p[0] = x[0];
    p[1] = x[1];
    return IX_OK;
}

/* Does light bounce at i, and have all chords a length? */
static ix_status bounces(ix_ctx *ctx, int n, const ix_mv *const *crv,
                         const double *t, bool *out)
{
    double p[IX_MAX_UNKNOWNS][2];

    *out = true;
    for (int i = 0; i < n; i++)
        IX_TRY(point_of(ctx, crv[i], t[i], p[i]));
    for (int i = 0; *out && i < n; i++) {
        const double *at = p[i], *to = p[(i + 1) % n];
        const double *from = p[(i + n - 1) % n];
        double a[2] = {from[0] - at[0], from[1] - at[1]};
        double b[2] = {to[0] - at[0], to[1] - at[1]};
        double la = hypot(a[0], a[1]), lb = hypot(b[0], b[1]), tan[3];

        IX_TRY(ix_tangent(ctx, crv[i], t[i], true, tan));
        /* 1e-5: of squared equations roots are good to 1e-8 and better */
        *out = la > 0 && lb > 0 &&
               fabs((a[0] * tan[0] + a[1] * tan[1]) / la +
                    (b[0] * tan[0] + b[1] * tan[1]) / lb) <= 1e-5;
    }
    return IX_OK;
}

static ix_status keep(ix_ctx *ctx, int n, const ix_mv *const *crv,
                      ix_solutions *s)
{
    int k = 0;

    for (int i = 0; i < s->n; i++) {
        bool good;

        IX_TRY(bounces(ctx, n, crv, s->sol[i].x, &good));
        if (good)
            s->sol[k++] = s->sol[i];
    }
    s->n = k;
    return IX_OK;
}

static ix_status check(ix_ctx *ctx, int n, const ix_mv *const *crv)
{
    if (n < 2 || n > IX_MAX_UNKNOWNS)
        return IX_FAIL(ctx, IX_EARG, "%d curves; 2 to %d are possible", n,
                       IX_MAX_UNKNOWNS);
    for (int i = 0; i < n; i++)
        if (crv[i]->ndirs != 1 || crv[i]->ncoords < 2 ||
            crv[i]->dirs[0].basis == IX_POWER)
            return IX_FAIL(ctx, IX_EARG,
                           "freeform %d has %d directions and %d coordinates; "
                           "planar Bezier or B-spline curves are wanted",
                           i + 1, crv[i]->ndirs, crv[i]->ncoords);
    return IX_OK;
}

ix_status ix_crv_ray_traps(ix_ctx *ctx, int n, const ix_mv *const *crv,
                           ix_solutions *out)
{
    const ix_solve_opts o = {.max_boxes = 200000};
    ix_pool q = {.ctx = ctx};
    const ix_mv *f[IX_MAX_UNKNOWNS] = {NULL};
    double dom[IX_MAX_UNKNOWNS][2];
    bounce b[IX_MAX_UNKNOWNS] = {{.p = {{NULL}, NULL}}};
    ix_status st;

    *out = (ix_solutions){.n = 0};
    IX_TRY(check(ctx, n, crv));
    load(&q, n, crv, b, dom);
    for (int i = 0; q.st == IX_OK && i < n; i++)
        f[i] = n == 2 ? ix__vec_dot(&q, ix__vec_between(&q, b[1 - i].p, b[i].p),
                                    b[i].t)
                      : reflection(&q, &b[(i + n - 1) % n], &b[i],
                                   &b[(i + 1) % n]);
    IX_TRY(ix__unit_solve(&q, n, f, (const double(*)[2])dom, &o, out));
    st = keep(ctx, n, crv, out);
    if (st != IX_OK)
        ix_solutions_free(ctx, out);
    return st;
}
