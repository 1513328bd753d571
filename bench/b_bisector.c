/* b_bisector.c - bisector surfaces of two space curves, from C. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>

#include "iritx/ops.h"

typedef struct {
    ix_ctx *ctx;
    ix_mv *a, *b;
    ix_report *rep;
} work;

static void once(void *arg)
{
    work *w = arg;
    ix_mv *s;

    ix_bench_ok(w->ctx, ix_cbisector3d(w->ctx, w->a, w->b, NULL, w->rep, &s));
    ix_mv_unref(w->ctx, s);
}

/* A curve with the given spans (0: Bezier). */
static ix_mv *make(ix_ctx *ctx, int degree, int spans, bool rational,
                   double seed)
{
    double kv[256], pts[4 * 128];
    int n = degree + (spans > 0 ? spans : 1);
    ix_dir d = {spans > 0 ? IX_BSPLINE : IX_BEZIER, degree + 1, n, false, kv};
    ix_mv *m;

    for (int i = 0; i < n + degree + 1; i++)
        kv[i] = i <= degree ? 0 : i >= n ? spans : i - degree;
    for (int i = 0; i < 4 * n; i++)
        pts[i] = i < n && rational ? 1.5 + 0.5 * sin(i + seed)
                                   : sin(i * seed + seed);
    ix_bench_ok(ctx, ix_mv_new(ctx, 1, &d, 3, rational, pts, &m));
    return m;
}

static void row(work *w, int degree, int spans, bool rational)
{
    char name[80];
    int n = spans > 0 ? spans : 1;

    w->a = make(w->ctx, degree, spans, rational, 0.7);
    w->b = make(w->ctx, degree, spans, rational, 1.9);
    snprintf(name, sizeof name, "space bisector, %s degree %d, %d x %d spans%s",
             rational ? "rational" : "polynomial", degree, n, n,
             w->rep ? ", with report" : "");
    ix_bench(name, once, w, (double)n * n, "patch");
    ix_mv_unref(w->ctx, w->a);
    ix_mv_unref(w->ctx, w->b);
}

int main(void)
{
    work w = {.ctx = ix_ctx_new(NULL, NULL)};
    ix_report rep;

    if (!w.ctx)
        return 1;
    ix_ctx_set_threads(w.ctx, 1);
    for (int d = 1; d <= 5; d++)
        row(&w, d, 0, false);
    for (int d = 2; d <= 5; d++)
        row(&w, d, 0, true);
    row(&w, 3, 5, false);
    row(&w, 3, 40, false);
    row(&w, 3, 5, true);
    w.rep = &rep;
    row(&w, 3, 0, false);
    ix_ctx_free(w.ctx);
    return 0;
}
