/* tess_bound.c - how far a box of a curve or surface is from flat: bounds of
 * the derivatives of x / w by control points of x and of w. The origin is first
 * moved into the box, so that for small boxes the bounds come near the truth.
 */
#include <math.h>

#include "mv/tess_impl.h"

/* The largest derivatives of a field, by its control points. */
typedef struct {
    double u, v, uu, uv, vv;
} diffs;

static size_t at(const ix__tess_box *b, int axis, int i, int j)
{
    return ((size_t)axis * (size_t)b->o[1] + (size_t)j) * (size_t)b->o[0] +
           (size_t)i;
}

/* The terms of a mixed difference of orders du, dv (together at most 2): their
 * places relative to i, j, and factors. Returns how many there are. */
static int stencil(const ix__tess_box *b, int du, int dv, size_t place[4],
                   double factor[4])
{
    static const double row[3][3] = {{1, 0, 0}, {-1, 1, 0}, {1, -2, 1}};
    int n = 0;

    for (int q = 0; q <= dv; q++)
        for (int p = 0; p <= du; p++) {
            place[n] = at(b, 0, p, q);
            factor[n++] = row[du][p] * row[dv][q];
        }
    return n;
}

/* The largest derivative of orders du, dv of n axes from the first. */
static double largest(const ix__tess_box *b, int first, int n, int du, int dv)
{
    int p = b->o[0] - 1, q = b->o[1] - 1;
    size_t place[4], plane = (size_t)b->o[0] * (size_t)b->o[1];
    double factor[4], most = 0, f = 1;
    int terms = stencil(b, du, dv, place, factor);

    for (int j = 0; j + dv <= q; j++)
        for (int i = 0; i + du <= p; i++) {
            const double *x = b->net + at(b, first, i, j);
            double sum = 0;

            for (int a = 0; a < n; a++, x += plane) {
                double y = 0;

                for (int k = 0; k < terms; k++)
                    y += factor[k] * x[place[k]];
                sum += y * y;
            }
            if (!(sum <= most))
                most = isnan(sum) ? HUGE_VAL : sum;
        }
    for (int k = 0; k < du; k++)
        f *= p - k;
    for (int k = 0; k < dv; k++)
        f *= q - k;
    return f * sqrt(most);
}

static diffs all_diffs(const ix__tess_box *b, int first, int n)
{
    return (diffs){largest(b, first, n, 1, 0), largest(b, first, n, 0, 1),
                   largest(b, first, n, 2, 0), largest(b, first, n, 1, 1),
                   largest(b, first, n, 0, 2)};
}

ix__tess_sign ix__tess_weights(const ix__tess_box *b, double least)
{
    size_t n = (size_t)b->o[0] * (size_t)b->o[1];
    double sign;

    if (!b->rational)
        return IX__TESS_KEEP;
    sign = b->net[0] < 0 ? -1 : 1;
    for (size_t i = 0; i < n; i++)
        if (!(sign * b->net[i] > 0 && sign * b->net[i] >= least))
            return IX__TESS_POLE;
    return IX__TESS_KEEP;
}

/* --- rational boxes ------------------------------------------------------ */

/* out = in times the linear function from l0 to l1 in direction 0, for rows of
 * n coefficients: one more. */
static void times_linear_u(int n, int rows, double l0, double l1,
                           const double *in, double *out)
{
    for (int j = 0; j < rows; j++, in += n)
        for (int k = 0; k <= n; k++) {
            double x = k > 0 ? k * l1 * in[k - 1] : 0;

            *out++ = (x + (k < n ? (n - k) * l0 * in[k] : 0)) / n;
        }
}

/* The same in direction 1. */
static void times_linear_v(int n, int row, double l0, double l1,
                           const double *in, double *out)
{
    for (int k = 0; k <= n; k++)
        for (int i = 0; i < row; i++) {
            double x = k > 0 ? k * l1 * in[(k - 1) * row + i] : 0;

            *out++ = (x + (k < n ? (n - k) * l0 * in[k * row + i] : 0)) / n;
        }
}

/* in times f(u) g(v), both linear, f from f[0] to f[1]. A direction of order
 * 1 is that of a curve, which has none. */
static void times_linear(const ix__tess_box *b, const double *in,
                         const double f[2], const double g[2], double *out)
{
    double *mid = b->work;

    times_linear_u(b->o[0], b->o[1], f[0], f[1], in, b->o[1] > 1 ? mid : out);
    if (b->o[1] > 1)
        times_linear_v(b->o[1], b->o[0] + 1, g[0], g[1], mid, out);
}

size_t ix__tess_work(const ix__tess_box *b)
{
    return (size_t)(b->naxes + 3) * (size_t)(b->o[0] + 1) *
           (size_t)(b->o[1] + 1);
}

/* Projected coordinate of a corner. */
static double corner(const ix__tess_box *b, int axis, int right, int high)
{
    int i = right * (b->o[0] - 1), j = high * (b->o[1] - 1);

    return b->net[at(b, axis, i, j)] / b->net[at(b, 0, i, j)];
}

/* The box with the affine map through its corners, nearly, taken away: what is
 * left has the same second derivatives, and is small, so that the products
 * with derivatives of the weight nearly vanish. One order higher. */
static ix__tess_box flattened(const ix__tess_box *b)
{
    static const double one[2] = {1, 1}, ramp[2] = {-.5, .5};
    ix__tess_box r = *b;
    size_t plane;
    double *w;

    r.o[0]++;
    r.o[1] += r.o[1] > 1;
    plane = (size_t)r.o[0] * (size_t)r.o[1];
    w = b->work + plane;
    r.net = w + 2 * plane;
    times_linear(b, b->net, one, one, r.net);
    times_linear(b, b->net, ramp, one, w);
    times_linear(b, b->net, one, ramp, w + plane);
    for (int a = 1; a <= b->ncoords; a++) {
        double p = corner(b, a, 0, 0), q = corner(b, a, 1, 0);
        double s = corner(b, a, 0, 1), t = corner(b, a, 1, 1);
        double c = (p + q + s + t) / 4, cu = (q - p + t - s) / 2;
        double cv = b->o[1] > 1 ? (s - p + t - q) / 2 : 0;
        double *x = r.net + (size_t)a * plane;

        times_linear(b, b->net + at(b, a, 0, 0), one, one, x);
        for (size_t i = 0; i < plane; i++)
            x[i] -= c * r.net[i] + cu * w[i] + cv * w[plane + i];
    }
    return r;
}

/* The largest distance of a projected control point from the origin, and the
 * least |weight|. */
static double farthest(const ix__tess_box *b, double *wmin)
{
    size_t n = (size_t)b->o[0] * (size_t)b->o[1];
    const double *w = b->net;
    double far = 0;

    *wmin = HUGE_VAL;
    for (size_t i = 0; i < n; i++) {
        double sum = 0;

        for (int a = 1; a <= b->ncoords; a++)
            sum += b->net[(size_t)a * n + i] * b->net[(size_t)a * n + i];
        far = fmax(far, sqrt(sum) / fabs(w[i]));
        *wmin = fmin(*wmin, fabs(w[i]));
    }
    return far;
}

/* Length of the affine map's derivatives, by the corners. */
static double slope(const ix__tess_box *b, int d)
{
    double sum = 0;

    for (int a = 1; a <= b->ncoords; a++) {
        double x = corner(b, a, 1, 1) - corner(b, a, 0, 0);
        double y = corner(b, a, 1, 0) - corner(b, a, 0, 1);
        double s = d == 0 ? (x + y) / 2 : (x - y) / 2;

        sum += s * s;
    }
    return sqrt(sum);
}

ix__tess_bound ix__tess_bounds(const ix__tess_box *b)
{
    double wmin, far, u, v;
    ix__tess_box r;
    diffs x, w;

    if (!b->rational) {
        x = all_diffs(b, 0, b->ncoords);
        return (ix__tess_bound){x.uu, x.uv, x.vv, x.u, x.v};
    }
    r = flattened(b);
    far = farthest(&r, &wmin);
    x = all_diffs(&r, 1, r.ncoords);
    w = all_diffs(&r, 0, 1);
    u = (x.u + w.u * far) / wmin;
    v = (x.v + w.v * far) / wmin;
    return (ix__tess_bound){(x.uu + 2 * w.u * u + w.uu * far) / wmin,
                            (x.uv + w.u * v + w.v * u + w.uv * far) / wmin,
                            (x.vv + 2 * w.v * v + w.vv * far) / wmin,
                            u + slope(b, 0), b->o[1] > 1 ? v + slope(b, 1) : 0};
}

/* --- what the bounds ask for ---------------------------------------------- */

/* The mixed term is given to the two others, 2 uv <= f uv + uv / f, f being the
 * ratio of steps that they would like. */
void ix__tess_needs(const ix__tess_bound *b, double e[2])
{
    double f = b->uu > 0 && b->vv > 0 ? sqrt(sqrt(b->uu / b->vv)) : 1;

    f = fmin(fmax(f, 0.25), 4);
    e[0] = b->uu + f * b->uv;
    e[1] = b->vv + b->uv / f;
}
