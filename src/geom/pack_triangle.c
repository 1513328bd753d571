/* pack_triangle.c - see the header. */
#include "geom/pack_triangle.h"

#include <math.h>
#include <string.h>

#include "geom/unit_solve.h"

/* Sides k from corner k to k + 1, with directions and inner normals. */
typedef struct {
    double p[3][2], len[3], e[3][2], n[3][2], cot[3], inradius;
} triangle;

static ix_status measure(ix_ctx *ctx, const double (*p)[2], triangle *t)
{
    double area2 = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) -
                   (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
    double around = 0, turn = area2 > 0 ? 1 : -1;

    for (int k = 0; k < 3; k++) {
        const double *q = p[(k + 1) % 3];
        double d[2] = {q[0] - p[k][0], q[1] - p[k][1]};

        memcpy(t->p[k], p[k], sizeof t->p[k]);
        t->len[k] = hypot(d[0], d[1]);
        around += t->len[k];
        for (int c = 0; c < 2; c++)
            t->e[k][c] = d[c] / t->len[k];
        t->n[k][0] = -turn * t->e[k][1];
        t->n[k][1] = turn * t->e[k][0];
    }
    t->inradius = fabs(area2) / around;
    if (!(t->inradius > 1e-10 * around))
        return IX_FAIL(ctx, IX_EDOMAIN, "the three points are on one line");
    /* the way from corner k to where the inscribed circle touches */
    for (int k = 0; k < 3; k++)
        t->cot[k] = (around / 2 - t->len[(k + 1) % 3]) / t->inradius;
    return IX_OK;
}

static const ix_mv *sum(ix_pool *q, const ix_mv *a, const ix_mv *b)
{
    return ix__sum0(q, a, b);
}

static const ix_mv *times(ix_pool *q, const ix_mv *a, const ix_mv *b, double f)
{
    const ix_mv *m = ix__prod0(q, a, b);

    return m ? ix__pool_scale(q, m, f) : NULL;
}

static const ix_mv *constant(ix_pool *q, double v, int n)
{
    return ix__pool_linear(q, (const double[2]){v, v}, n, 0);
}

static void corner_disc(const triangle *t, int k, double x, ix__disc *d)
{
    d->radius = x * x;
    for (int c = 0; c < 2; c++)
        d->at[c] = t->p[k][c] +
                   d->radius * (t->cot[k] * t->e[k][c] + t->n[k][c]);
}

/* --- three
 * ------------------------------------------------------------------- */

static void three_equations(ix_pool *q, const triangle *t,
                            const double (*dom)[2], const ix_mv **f)
{
    const ix_mv *x[3];

    for (int k = 0; k < 3; k++)
        x[k] = ix__pool_linear(q, dom[k], 3, k);
    for (int k = 0; k < 3; k++) {
        int j = (k + 1) % 3;

        f[k] = sum(q, times(q, x[k], x[k], t->cot[k]),
                   times(q, x[j], x[j], t->cot[j]));
        f[k] = ix__diff0(q, sum(q, f[k], times(q, x[k], x[j], 2)),
                         constant(q, t->len[k], 3));
    }
}

static ix_status three(ix_ctx *ctx, const double (*p)[2], bool interior, int *n,
                       ix__disc (**out)[3])
{
    const ix_solve_opts o = {.max_boxes = 100000};
    ix_pool q = {.ctx = ctx};
    double dom[3][2] = {{0}}, most = 0;
    const ix_mv *f[3];
    ix_solutions s;
    triangle t;

    IX_TRY(measure(ctx, p, &t));
    /* discriminants: x_j real needs x_i^2 <= L cot_j / (cot_i cot_j - 1), which
     * is r_i <= the radius of the circle that touches the opposite side from
     * outside, as cot_i cot_j - 1 = cot_k (cot_i + cot_j) */
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;

        most = fmax(most, t.len[i] * t.cot[j] / (t.cot[i] * t.cot[j] - 1));
        most = fmax(most, t.len[i] * t.cot[i] / (t.cot[i] * t.cot[j] - 1));
    }
    for (int k = 0; k < 3; k++) {
        dom[k][1] = sqrt(interior ? t.inradius : 1.01 * most);
        dom[k][0] = interior || k == 0 ? 0 : -dom[k][1];
    }
    three_equations(&q, &t, (const double(*)[2])dom, f);
    IX_TRY(ix__unit_solve(&q, 3, f, (const double(*)[2])dom, &o, &s));
    *out = ix__scratch(ctx, (size_t)s.n + 1, sizeof **out);
    for (int i = 0; *out && i < s.n; i++)
        for (int k = 0; k < 3; k++)
            corner_disc(&t, k, s.sol[i].x[k], &(*out)[i][k]);
    *n = s.n;
    ix_solutions_free(ctx, &s);
    return *out ? IX_OK : IX_ENOMEM;
}

ix_status ix__pack_three(ix_ctx *ctx, const double (*p)[2], bool interior,
                         int *n, ix__disc (**out)[3])
{
    *n = 0;
    return three(ctx, p, interior, n, out);
}

/* --- six
 * --------------------------------------------------------------------- */

/* Along the side k: both corner circles and the one between them. */
static const ix_mv *along_side(ix_pool *q, const triangle *t,
                               const ix_mv *const *x, int k)
{
    int j = (k + 1) % 3;
    const ix_mv *f = sum(q, times(q, x[k], x[k], t->cot[k]),
                         times(q, x[j], x[j], t->cot[j]));

    f = sum(q, f, times(q, x[3 + k], ix__sum0(q, x[k], x[j]), 2));
    return ix__diff0(q, f, constant(q, t->len[k], 6));
}

/* Centre of the circle at a side, from corner k: along the direction e. */
static void side_center(ix_pool *q, const triangle *t, const ix_mv *const *x,
                        int k, const ix_mv *y, const double e[2],
                        const double n[2], const ix_mv *out[2])
{
    const ix_mv *way = sum(q, times(q, x[k], x[k], t->cot[k]),
                           times(q, x[k], y, 2));

    for (int c = 0; c < 2; c++) {
        const ix_mv *a = way ? ix__pool_scale(q, way, e[c]) : NULL;

        out[c] = sum(q, a, times(q, y, y, n[c]));
    }
}

/* The circles at both sides of corner k touch: |a - b|^2 = (ya^2 + yb^2)^2. */
static const ix_mv *touching(ix_pool *q, const triangle *t,
                             const ix_mv *const *x, int k)
{
    int before = (k + 2) % 3;
    double back[2] = {-t->e[before][0], -t->e[before][1]};
    const ix_mv *a[2], *b[2], *r, *d[2];

    side_center(q, t, x, k, x[3 + k], t->e[k], t->n[k], a);
    side_center(q, t, x, k, x[3 + before], back, t->n[before], b);
    for (int c = 0; c < 2; c++)
        d[c] = ix__diff0(q, a[c], b[c]);
    r = sum(q, times(q, x[3 + k], x[3 + k], 1),
            times(q, x[3 + before], x[3 + before], 1));
    return ix__diff0(q,
                     sum(q, times(q, d[0], d[0], 1), times(q, d[1], d[1], 1)),
                     times(q, r, r, 1));
}

static void six_discs(const triangle *t, const double *x, ix__disc *d)
{
    for (int k = 0; k < 3; k++) {
        double y = x[3 + k], way = t->cot[k] * x[k] * x[k] + 2 * x[k] * y;

        corner_disc(t, k, x[k], &d[k]);
        d[3 + k].radius = y * y;
        for (int c = 0; c < 2; c++)
            d[3 + k].at[c] = t->p[k][c] + way * t->e[k][c] + y * y * t->n[k][c];
    }
}

ix_status ix__pack_six(ix_ctx *ctx, const double (*p)[2], int *n,
                       ix__disc (**out)[6])
{
    const ix_solve_opts o = {.max_boxes = 100000};
    ix_pool q = {.ctx = ctx};
    const ix_mv *f[6], *x[6];
    double dom[6][2] = {{0}};
    ix_solutions s;
    triangle t;

    *n = 0;
    IX_TRY(measure(ctx, p, &t));
    for (int k = 0; k < 6; k++) {
        dom[k][1] = sqrt(t.inradius);
        x[k] = ix__pool_linear(&q, dom[k], 6, k);
    }
    for (int k = 0; k < 3; k++) {
        f[k] = along_side(&q, &t, x, k);
        f[3 + k] = touching(&q, &t, x, k);
    }
    IX_TRY(ix__unit_solve(&q, 6, f, (const double(*)[2])dom, &o, &s));
    *out = ix__scratch(ctx, (size_t)s.n + 1, sizeof **out);
    for (int i = 0; *out && i < s.n; i++)
        six_discs(&t, s.sol[i].x, (*out)[i]);
    *n = s.n;
    ix_solutions_free(ctx, &s);
    return *out ? IX_OK : IX_ENOMEM;
}
