/* quad.c - Gauss-Legendre with 15 nodes, intervals halved where the halves
 * disagree with the whole. The order of summation is fixed. */
#include "geom/quad.h"

#include <math.h>
#include <string.h>

#include "geom/gauss.h"

#define NODES 15
#define DEPTH 48

typedef struct {
    ix__integrand f;
    void *arg;
    int nf;
    double rtol, x[NODES], w[NODES];
} rule;

typedef struct {
    double a, b, sum[IX_QUAD_MAX];
} interval;

static interval apply(const rule *r, double a, double b)
{
    interval v = {.a = a, .b = b};
    double f[IX_QUAD_MAX];

    for (int i = 0; i < NODES; i++) {
        r->f(r->arg, a + (b - a) * r->x[i], f);
        for (int k = 0; k < r->nf; k++)
            v.sum[k] += (b - a) * r->w[i] * f[k];
    }
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
    rule r = {.f = f, .arg = arg, .nf = nf, .rtol = rtol};
    interval stack[DEPTH + 2];
    int depth[DEPTH + 2], n = 1;
    double scale;

    ix__gauss(NODES, r.x, r.w);
    memset(out, 0, (size_t)nf * sizeof *out);
    stack[0] = apply(&r, a, b);
    depth[0] = 0;
    scale = fabs(stack[0].sum[0]);
    while (n > 0) {
        interval v = stack[--n];
        int d = depth[n];
        interval l = apply(&r, v.a, (v.a + v.b) / 2);
        interval h = apply(&r, (v.a + v.b) / 2, v.b);

        if (d >= DEPTH || agree(&r, &v, &l, &h, scale)) {
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
