/* path.c - Bezier spans of a curve and their derivatives by de Casteljau's
 * algorithm: all derivatives of order j come from the points of step n - j. */
#include "geom/path.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "geom/vec3.h"

/* [naxes][nspans (d + 1)] to [nspans][naxes][d + 1]. */
static void by_span(const ix_path *p, const double *in, double *out)
{
    size_t m = (size_t)p->degree + 1, n = (size_t)p->nspans;
    size_t naxes = (size_t)p->naxes;

    for (size_t a = 0; a < naxes; a++)
        for (size_t s = 0; s < n; s++)
            memcpy(out + (s * naxes + a) * m, in + (a * n + s) * m,
                   m * sizeof *out);
}

static ix_status decompose(ix_ctx *ctx, const ix_mv *crv, ix_path *p)
{
    ix_dir dir = ix_mv_dir(crv, 0);
    ix_spans sp;
    double *coef, *sorted;
    size_t n;

    IX_TRY(ix__spans_of(ctx, &dir, &sp));
    p->degree = sp.degree;
    p->nspans = sp.nspans;
    p->naxes = crv->naxes;
    p->ncoords = crv->ncoords;
    p->rational = crv->rational;
    p->breaks = sp.breaks;
    p->cont = sp.cont;
    n = (size_t)crv->naxes * (size_t)sp.nspans * ((size_t)sp.degree + 1);
    IX_SCRATCH(ctx, coef, n);
    IX_SCRATCH(ctx, sorted, n);
    IX_SCRATCH(ctx, p->work, sp.degree + 1);
    IX_TRY(ix__spans_extract(ctx, &dir, &sp, (size_t)crv->naxes, 1, crv->pts,
                             coef));
    by_span(p, coef, sorted);
    p->coef = sorted;
    return IX_OK;
}

ix_status ix__path_new(ix_ctx *ctx, const ix_mv *crv, ix_path *out)
{
    ix_mv *bez = NULL;
    ix_status st;

    if (ix_mv_ndirs(crv) != 1)
        return IX_FAIL(ctx, IX_EARG, "a curve has one direction, not %d",
                       ix_mv_ndirs(crv));
    if (ix_mv_dir(crv, 0).basis != IX_POWER)
        return decompose(ctx, crv, out);
    IX_TRY(ix_mv_power_to_bezier(ctx, crv, &bez));
    st = decompose(ctx, bez, out);
    ix_mv_unref(ctx, bez);
    return st;
}

int ix__path_span(const ix_path *p, double t)
{
    int lo = 0, hi = p->nspans;

    while (hi - lo > 1) {
        int mid = (lo + hi) / 2;

        if (t < p->breaks[mid])
            hi = mid;
        else
            lo = mid;
    }
    return lo;
}

/* Derivatives 0 .. nder by u of one Bernstein polynomial of degree d, a
 * stride apart. */
static void bernstein(int d, const double *c, double u, int nder, double *work,
                      double *out, int stride)
{
    double v = 1 - u, f = 1;
    int top = nder < d ? nder : d, step = 0;

    memcpy(work, c, ((size_t)d + 1) * sizeof *work);
    for (int j = top; j >= 0; j--) {
        double delta[IX_PATH_DERIVS + 1];

        for (; step < d - j; step++)
            for (int i = 0; i < d - step; i++)
                work[i] = v * work[i] + u * work[i + 1];
        memcpy(delta, work, ((size_t)j + 1) * sizeof *delta);
        for (int k = j; k > 0; k--)
            for (int i = 0; i < k; i++)
                delta[i] = delta[i + 1] - delta[i];
        out[j * stride] = delta[0];
    }
    for (int j = 0; j <= top; j++) {
        out[j * stride] *= f;
        f *= d - j;
    }
    for (int j = top + 1; j <= nder; j++)
        out[j * stride] = 0;
}

void ix__path_axes(const ix_path *p, int span, double t, int nder, double *out)
{
    double a = p->breaks[span], h = p->breaks[span + 1] - a, f = 1;
    const double *c = p->coef +
                      (size_t)span * (size_t)p->naxes * ((size_t)p->degree + 1);

    for (int i = 0; i < p->naxes; i++, c += p->degree + 1)
        bernstein(p->degree, c, (t - a) / h, nder, p->work, out + i, p->naxes);
    for (int j = 1; j <= nder; j++) {
        f /= h;
        for (int i = 0; i < p->naxes; i++)
            out[j * p->naxes + i] *= f;
    }
}

void ix__path_derivs(const ix_path *p, int span, double t, int nder,
                     double *out)
{
    static const int binom[4][4] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
    double h[(IX_PATH_DERIVS + 1) * (IX_MAX_COORDS + 1)] = {0};
    int nc = p->ncoords, na = p->naxes;

    assert(nder >= 0 && nder <= IX_PATH_DERIVS && nc > 0 &&
           na == nc + (p->rational ? 1 : 0));
    if (!p->rational) {
        ix__path_axes(p, span, t, nder, out);
        return;
    }
    ix__path_axes(p, span, t, nder, h);
    for (int j = 0; j <= nder; j++) /* Leibniz: (w C)^(j) solved for C^(j) */
        for (int c = 0; c < nc; c++) {
            double s = h[j * na + 1 + c];

            for (int i = 1; i <= j; i++)
                s -= binom[j][i] * h[i * na] * out[(j - i) * nc + c];
            out[j * nc + c] = s / h[0];
        }
}

void ix__path_point(const ix_path *p, double t, double *out)
{
    ix__path_derivs(p, ix__path_span(p, t), t, 0, out);
}

void ix__path_derivs3(const ix_path *p, int span, double t, int nder,
                      double (*out)[3])
{
    double d[(IX_PATH_DERIVS + 1) * IX_MAX_COORDS] = {0};

    ix__path_derivs(p, span, t, nder, d);
    for (int j = 0; j <= nder; j++)
        for (int c = 0; c < 3; c++)
            out[j][c] = c < p->ncoords ? d[j * p->ncoords + c] : 0;
}

/* Size of one span: the largest distance of its control points from the
 * first. */
static double span_size(const ix_path *p, int span)
{
    size_t m = (size_t)p->degree + 1;
    const double *c = p->coef + (size_t)span * (size_t)p->naxes * m;
    const double *w = c;
    double size = 0;

    c += p->rational ? m : 0;
    for (size_t i = 1; i < m; i++) {
        double s = 0;

        for (int k = 0; k < p->ncoords; k++) {
            const double *x = c + (size_t)k * m;

            s = hypot(s, p->rational ? x[i] / w[i] - x[0] / w[0] : x[i] - x[0]);
        }
        if (isfinite(s))
            size = fmax(size, s);
    }
    return size;
}

bool ix__path_tangent3(const ix_path *p, int span, double t, bool at_end,
                       double out[3])
{
    double d[4][3] = {{0}}, h = p->breaks[span + 1] - p->breaks[span];
    double size = span_size(p, span), f = 1;

    ix__path_derivs3(p, span, t, 3, d);
    for (int j = 1; j <= 3; j++) {
        f *= h;
        /* 1e-9: a derivative below that share of the span is a zero with
         * rounding (control points carry 1e-16, differences of a degree's
         * worth of them some digits less) */
        if (ix__len3(d[j]) * f > 1e-9 * size && isfinite(ix__len3(d[j]))) {
            double len = ix__len3(d[j]);

            for (int c = 0; c < 3; c++)
                out[c] = at_end && j % 2 == 0 ? -d[j][c] / len : d[j][c] / len;
            return true;
        }
    }
    return false;
}

ix_status ix__path_no_poles(ix_ctx *ctx, const ix_path *p)
{
    size_t m = (size_t)p->degree + 1;
    double sign = p->coef[0] < 0 ? -1 : 1;

    for (int s = 0; p->rational && s < p->nspans; s++)
        for (size_t i = 0; i < m; i++) {
            double w = p->coef[(size_t)s * (size_t)p->naxes * m + i];

            if (!(w * sign > 0))
                return IX_FAIL(ctx, IX_EDOMAIN,
                               "the weight changes sign or vanishes in "
                               "[%g, %g]",
                               p->breaks[s], p->breaks[s + 1]);
        }
    return IX_OK;
}

double ix__path_size(const ix_path *p)
{
    double first[3], x[3], size = 0, d[1][3];

    ix__path_derivs3(p, 0, p->breaks[0], 0, d);
    memcpy(first, d[0], sizeof first);
    for (int s = 0; s < p->nspans; s++) {
        ix__path_derivs3(p, s, p->breaks[s], 0, d);
        memcpy(x, d[0], sizeof x);
        size = fmax(size, ix__dist3(x, first) + span_size(p, s));
    }
    return size;
}

bool ix__path_normal3(const ix_path *p, int span, double t, double out[3])
{
    double d[3][3], u[3] = {0}, n[3];

    ix__path_derivs3(p, span, t, 2, d);
    if (!(ix__unit3(d[1], u) > 0))
        return false;
    ix__axpy3(d[2], -ix__dot3(d[2], u), u, n);
    return ix__len3(n) > 1e-12 * ix__len3(d[2]) && ix__unit3(n, out) > 0;
}

bool ix__path_is_corner(const ix_path *p, int s)
{
    double a[3], b[3], t = p->breaks[s];

    if (p->cont[s - 1] < 0)
        return true;
    /* a turn of 1e-6 is a corner, less is rounding of control points */
    return ix__path_tangent3(p, s - 1, t, true, a) &&
           ix__path_tangent3(p, s, t, false, b) && ix__dot3(a, b) < cos(1e-6);
}

int ix__path_corner(const ix_path *p, int from)
{
    int s = from > 1 ? from : 1;

    while (s < p->nspans && !ix__path_is_corner(p, s))
        s++;
    return s;
}
