/* quad.c - Gauss-Legendre with 15 nodes, intervals halved where the halves
 * disagree with the whole. The order of summation is fixed. */
#include "geom/quad.h"

#include <math.h>
#include <string.h>

#define HALF  7
#define DEPTH 48
#define MOST                                                                   \
    10000 /* intervals: kinks need some hundred, the noise of an integrand far \
             from the origin would be halved for ever */

/* Distances of the nodes from the ends of [0, 1], and their weights, which add
 * up to 1; the last is the middle. */
static const double node[HALF + 1] = {
    0.0060037409897572857552, 0.0313633037996470478461,
    0.0758967082947863918996, 0.1377911343199149762919,
    0.2145139136957305762313, 0.3029243264612183150513,
    0.3994029530012827388496, 0.5};
static const double weight[HALF + 1] = {
    0.0153766209980586341773, 0.0351830237440540623546,
    0.0535796102335859675059, 0.0697853389630771572239,
    0.0831346029084969667766, 0.0930805000077811055134,
    0.0992157426635557882280, 0.1012891209627806364403};

typedef struct {
    ix__integrand f;
    void *arg;
    int nf;
    double rtol;
} rule;

typedef struct {
    double a, b, sum[IX_QUAD_MAX];
} interval;

static void add(const rule *r, interval *v, double t, double w)
{
    double f[IX_QUAD_MAX];

    r->f(r->arg, t, f);
    for (int k = 0; k < r->nf; k++)
        v->sum[k] += w * f[k];
}

static interval apply(const rule *r, double a, double b)
{
    interval v = {.a = a, .b = b};
    double h = b - a;

    for (int i = 0; i < HALF; i++) {
        add(r, &v, a + h * node[i], h * weight[i]);
        add(r, &v, b - h * node[i], h * weight[i]);
    }
    add(r, &v, a + h / 2, h * weight[HALF]);
    return v;
}

/* Do two halves agree with the whole, relative to the scale of the total? */
static bool agree(const rule *r, const interval *v, const interval *l,
                  const interval *h, double scale)
{
    for (int k = 0; k < r->nf; k++) {
        double both = l->sum[k] + h->sum[k];
        double size = k ? fabs(both) + scale * fabs(v->b - v->a) : scale;

        if (!(fabs(both - v->sum[k]) <= r->rtol * size) && isfinite(both))
            return false;
    }
    return true;
}

void ix__quad(ix__integrand f, void *arg, int nf, double a, double b,
              double rtol, double *out)
{
    const rule r = {f, arg, nf, rtol};
    interval stack[DEPTH + 2];
    int depth[DEPTH + 2], n = 1, most = MOST;
    double scale;

    memset(out, 0, (size_t)nf * sizeof *out);
    stack[0] = apply(&r, a, b);
    depth[0] = 0;
    scale = fabs(stack[0].sum[0]);
    while (n > 0) {
        interval v = stack[--n];
        int d = depth[n];
        interval l = apply(&r, v.a, v.a + (v.b - v.a) / 2);
        interval h = apply(&r, v.a + (v.b - v.a) / 2, v.b);

        if (d >= DEPTH || most-- <= 0 || agree(&r, &v, &l, &h, scale)) {
            for (int k = 0; k < nf; k++)
                out[k] += l.sum[k] + h.sum[k];
            continue;
        }
        stack[n] = h;
        depth[n++] = d + 1;
        stack[n] = l;
        depth[n++] = d + 1;
    }
}
