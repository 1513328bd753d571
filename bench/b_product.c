/* b_product.c - products of scalar B-splines and Bezier pieces, from C. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>

#include "iritx/sym.h"

typedef struct {
    ix_ctx *ctx;
    ix_mv *a, *b;
    ix_status (*fn)(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                    const ix_sym_opts *o, ix_mv **out);
} work;

static void once(void *arg)
{
    work *w = arg;
    ix_mv *c;

    ix_bench_ok(w->ctx, w->fn(w->ctx, w->a, w->b, NULL, &c));
    ix_mv_unref(w->ctx, c);
}

/* A multivariate with the given spans in each direction (0: Bezier). */
static ix_mv *make(ix_ctx *ctx, int ndirs, int order, int spans, int ncoords,
                   double seed)
{
    int n = spans > 0 ? spans + order - 1 : order;
    double *kv = malloc((size_t)(n + order) * sizeof *kv), *pts;
    ix_dir dirs[3];
    size_t np = (size_t)ncoords;
    ix_mv *m;

    for (int i = 0; i < n + order; i++) /* uneven knots */
        kv[i] = i < order ? 0 : i >= n ? spans : i - order + 1 + 0.2 * sin(i);
    for (int d = 0; d < ndirs; d++) {
        dirs[d] = (ix_dir){spans > 0 ? IX_BSPLINE : IX_BEZIER, order, n, false,
                           kv};
        np *= (size_t)n;
    }
    pts = malloc(np * sizeof *pts);
    for (size_t i = 0; i < np; i++)
        pts[i] = sin((double)i * seed + seed);
    ix_bench_ok(ctx, ix_mv_new(ctx, ndirs, dirs, ncoords, false, pts, &m));
    free(pts);
    free(kv);
    return m;
}

static void row(const char *name, work *w, double units, const char *unit)
{
    ix_bench(name, once, w, units, unit);
    ix_mv_unref(w->ctx, w->a);
    ix_mv_unref(w->ctx, w->b);
}

static void product(work *w, const char *name, int ndirs, int order, int spans)
{
    double units = pow(spans > 0 ? spans : 1, ndirs);

    w->fn = ix_sym_mul;
    w->a = make(w->ctx, ndirs, order, spans, 1, 0.7);
    w->b = make(w->ctx, ndirs, order, spans, 1, 1.3);
    row(name, w, units, spans > 0 ? "span" : "product");
}

int main(void)
{
    work w = {.ctx = ix_ctx_new(NULL, NULL)};

    if (!w.ctx)
        return 1;
    ix_ctx_set_threads(w.ctx, 1);
    product(&w, "product, cubic, 13 spans", 1, 4, 13);
    product(&w, "product, cubic, 100 spans", 1, 4, 100);
    product(&w, "product, cubic, 1000 spans", 1, 4, 1000);
    product(&w, "product, cubic, 10000 spans", 1, 4, 10000);
    product(&w, "product, degree 12, 13 spans", 1, 13, 13);
    product(&w, "product, Bezier, degree 3", 1, 4, 0);
    product(&w, "product, Bezier, degree 10", 1, 11, 0);
    product(&w, "product, Bezier, degree 15", 1, 16, 0);
    product(&w, "product, Bezier, degree 50", 1, 51, 0);
    product(&w, "product, Bezier, degree 400", 1, 401, 0);
    product(&w, "product, bicubic, 20 x 20 spans", 2, 4, 20);
    product(&w, "product, tricubic, 5 x 5 x 5 spans", 3, 4, 5);
    product(&w, "product, Bezier surface, degree 20", 2, 21, 0);
    w.fn = ix_sym_cross;
    w.a = make(w.ctx, 1, 4, 100, 3, 0.7);
    w.b = make(w.ctx, 1, 4, 100, 3, 1.3);
    row("vector product, cubic, 100 spans", &w, 100, "span");
    ix_ctx_free(w.ctx);
    return 0;
}
