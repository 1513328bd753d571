/* eval.c - values and partial derivatives at one parameter. */
#include <math.h>

#include "bsp/basis.h"
#include "mv/window.h"

bool ix__mv_extrapolates(const ix_mv *m, int d)
{
    const ix_dir *dir = m->dirs + d;

    if (m->ndirs > 2)
        return false;
    return dir->basis != IX_BSPLINE ||
           (dir->length == dir->order && ix__dir_is_open(dir));
}

ix_status ix__mv_param(ix_ctx *ctx, const ix_mv *m, int d, double *t)
{
    double dom[2], slack;

    ix__dir_domain(m->dirs + d, dom);
    if (*t >= dom[0] && *t <= dom[1])
        return IX_OK;
    if (isfinite(*t) && ix__mv_extrapolates(m, d))
        return IX_OK;
    slack = 1e-5 * (dom[1] - dom[0]); /* spec/model 6 */
    if (!(*t >= dom[0] - slack && *t <= dom[1] + slack))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "parameter %.17g of direction %d is outside the domain "
                       "[%.17g, %.17g]",
                       *t, d, dom[0], dom[1]);
    *t = fmin(fmax(*t, dom[0]), dom[1]);
    return IX_OK;
}

static ix_status partial(ix_ctx *ctx, const ix_mv *m, const double *t,
                         const int *k, double *out)
{
    ix__window win;

    IX_TRY(ix__window_init(ctx, m, &win));
    for (int d = 0; d < m->ndirs; d++) {
        double x = t[d];

        IX_TRY(ix__mv_param(ctx, m, d, &x));
        win.first[d] = ix__basis_first(m->dirs + d, x);
        ix__basis_derive(m->dirs + d, win.first[d], x, k[d], win.w[d]);
        if (m->dirs[d].basis == IX_POWER)
            win.total = (double)NAN;
        else if (k[d] > 0)
            win.total *= 0; /* stays NAN */
    }
    ix__window_sum(&win, out);
    return IX_OK;
}

ix_status ix_mv_partial(ix_ctx *ctx, const ix_mv *m, const double *t,
                        const int *k, double *out)
{
    for (int d = 0; d < m->ndirs; d++)
        if (k[d] < 0)
            return IX_FAIL(ctx, IX_EARG, "derivative %d in direction %d", k[d],
                           d);
    IX_RETURN_SCOPED(ctx, partial(ctx, m, t, k, out));
}

ix_status ix_mv_eval(ix_ctx *ctx, const ix_mv *m, const double *t, double *out)
{
    static const int value[IX_MAX_DIRS];

    return ix_mv_partial(ctx, m, t, value, out);
}

/* Err IX_EDOMAIN where a coordinate is not finite. */
static ix_status check_pole(ix_ctx *ctx, const ix_mv *m, const double *h,
                            const double *p)
{
    for (int c = 0; c < m->ncoords; c++)
        if (!isfinite(p[c]))
            return IX_FAIL(ctx, IX_EDOMAIN, "pole: weight %g, coordinate %d %g",
                           m->rational ? h[0] : 1.0, c, h[c + m->rational]);
    return IX_OK;
}

ix_status ix_mv_point(ix_ctx *ctx, const ix_mv *m, const double *t, double *out)
{
    double h[IX_MAX_COORDS + 1];

    IX_TRY(ix_mv_eval(ctx, m, t, h));
    for (int c = 0; c < m->ncoords; c++)
        out[c] = m->rational ? h[c + 1] / h[0] : h[c];
    return check_pole(ctx, m, h, out);
}

/* C = A / w: C(k) = (A(k) - sum over i = 1 .. k of binom(k, i) w(i) C(k-i)) /
 * w (Piegl and Tiller 1997, 4.8); h[k + 1][axes], out[k][ncoords] known. */
static void quotient(const ix_mv *m, const double *h, int k, double *out)
{
    size_t na = (size_t)m->naxes, nc = (size_t)m->ncoords;
    double *c = out + (size_t)k * nc, binom = 1;

    for (size_t j = 0; j < nc; j++)
        c[j] = h[(size_t)k * na + j + 1];
    for (int i = 1; i <= k; i++) {
        double w;

        binom = binom * (k - i + 1) / i;
        w = binom * h[(size_t)i * na];
        for (size_t j = 0; j < nc; j++)
            c[j] -= w * out[(size_t)(k - i) * nc + j];
    }
    for (size_t j = 0; j < nc; j++)
        c[j] /= h[0];
}

static ix_status curve_derivs(ix_ctx *ctx, const ix_mv *m, double t, int order,
                              double *out)
{
    double *h;

    if (!m->rational) {
        for (int k = 0; k <= order; k++)
            IX_TRY(ix_mv_partial(ctx, m, &t, &k,
                                 out + (size_t)k * (size_t)m->ncoords));
        return IX_OK;
    }
    IX_SCRATCH(ctx, h, ((size_t)order + 1) * (size_t)m->naxes);
    for (int k = 0; k <= order; k++) {
        IX_TRY(ix_mv_partial(ctx, m, &t, &k, h + (size_t)k * (size_t)m->naxes));
        quotient(m, h, k, out);
        IX_TRY(check_pole(ctx, m, h, out + (size_t)k * (size_t)m->ncoords));
    }
    return IX_OK;
}

ix_status ix_mv_curve_derivs(ix_ctx *ctx, const ix_mv *m, double t, int order,
                             double *out)
{
    if (m->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG, "%d directions: not a curve", m->ndirs);
    if (order < 0)
        return IX_FAIL(ctx, IX_EARG, "derivative %d", order);
    IX_RETURN_SCOPED(ctx, curve_derivs(ctx, m, t, order, out));
}
