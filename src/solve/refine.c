/* refine.c - a point near a solution curve (or near a solution) brought onto it
 * by the shortest Newton steps. */
#include <float.h>
#include <math.h>

#include "mv/mv.h"
#include "solve/small.h"

#define MAX_STEPS 40

/* Value and gradient of equation e at x, both over the gradient's size in
 * units of the domain; *len is that size. */
static ix_status row(ix_ctx *ctx, const ix_equation *e, const double *x,
                     const double *edge, double *f, double *grad, double *len)
{
    double v[IX_MAX_COORDS + 1];
    int n = e->f->ndirs;

    *len = 0;
    IX_TRY(ix_mv_eval(ctx, e->f, x, v));
    *f = v[e->axis];
    for (int j = 0; j < n; j++) {
        int k[IX_MAX_UNKNOWNS] = {0};

        k[j] = 1;
        IX_TRY(ix_mv_partial(ctx, e->f, x, k, v));
        grad[j] = v[e->axis] * edge[j];
        *len = hypot(*len, grad[j]);
    }
    for (int j = 0; *len > 0 && j < n; j++)
        grad[j] /= *len;
    *f /= *len > 0 ? *len : 1;
    return IX_OK;
}

/* The least step s with J s = f: s = J' (J J')^-1 f. False: J is singular. */
static bool least_step(int m, int n, ix__mat jac, const double *f, double *s)
{
    ix__mat gram, inv;

    for (int i = 0; i < m; i++)
        for (int k = 0; k < m; k++) {
            gram[i][k] = 0;
            for (int j = 0; j < n; j++)
                gram[i][k] += jac[i][j] * jac[k][j];
        }
    if (!ix__small_invert(m, gram, inv))
        return false;
    for (int j = 0; j < n; j++) {
        s[j] = 0;
        for (int i = 0; i < m; i++)
            for (int k = 0; k < m; k++)
                s[j] += jac[i][j] * inv[i][k] * f[k];
    }
    return true;
}

static void move(int n, const double (*dom)[2], const double *edge,
                 const double *s, double *x, double *size)
{
    *size = 0;
    for (int j = 0; j < n; j++) {
        x[j] = fmin(fmax(x[j] - s[j] * edge[j], dom[j][0]), dom[j][1]);
        *size = fmax(*size, fabs(s[j]));
    }
}

ix_status ix_solve_refine(ix_ctx *ctx, int neq, const ix_equation *eq,
                          double *x)
{
    double dom[IX_MAX_UNKNOWNS][2], edge[IX_MAX_UNKNOWNS], last = HUGE_VAL;
    int n = neq > 0 ? eq[0].f->ndirs : 0;

    if (neq < 1 || n > IX_MAX_UNKNOWNS || neq > n)
        return IX_FAIL(ctx, IX_EARG, "%d equations for %d unknowns", neq, n);
    for (int j = 0; j < n; j++) {
        ix_mv_domain(eq[0].f, j, dom[j]);
        edge[j] = dom[j][1] - dom[j][0];
        if (!(x[j] >= dom[j][0] && x[j] <= dom[j][1]))
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "parameter %d is %g, outside [%g, %g]", j, x[j],
                           dom[j][0], dom[j][1]);
    }
    for (int it = 0; it < MAX_STEPS; it++) {
        double f[IX_MAX_UNKNOWNS], s[IX_MAX_UNKNOWNS], len, size;
        ix__mat jac;

        for (int i = 0; i < neq; i++)
            IX_TRY(row(ctx, &eq[i], x, edge, &f[i], jac[i], &len));
        if (!least_step(neq, n, jac, f, s))
            return IX_FAIL(ctx, IX_EUNABLE,
                           "the gradients are dependent near (%g, %g)", x[0],
                           n > 1 ? x[1] : 0);
        move(n, (const double(*)[2])dom, edge, s, x, &size);
        if (size <= 4 * DBL_EPSILON || (last < 1e-8 && !(size < 0.5 * last)))
            return IX_OK;
        last = size;
    }
    return IX_FAIL(ctx, IX_EUNABLE,
                   "no convergence near (%g, %g): last step "
                   "%g of the domain",
                   x[0], n > 1 ? x[1] : 0, last);
}
