/* b_bisector.c - bisector surfaces of two space curves, from C. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>

#include "iritx/ops_bisect.h"

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

/* --- a point and a curve or a surface ------------------------------------- */

static const double at[3] = {0.3, 2.9, 0.7};

static void plane_once(void *arg)
{
    work *w = arg;
    ix_mv *s;

    ix_bench_ok(w->ctx,
                ix_pt_crv_bisector(w->ctx, w->a, at, 0.5, NULL, NULL, &s));
    ix_mv_unref(w->ctx, s);
}

static void space_once(void *arg)
{
    work *w = arg;
    ix_mv *s;

    ix_bench_ok(w->ctx, ix_pt_crv_bisector3d(w->ctx, w->a, at, 0.5, NULL, NULL,
                                             NULL, &s));
    ix_mv_unref(w->ctx, s);
}

static void surface_once(void *arg)
{
    work *w = arg;
    ix_mv *s;

    ix_bench_ok(w->ctx, ix_pt_srf_bisector(w->ctx, w->b, at, NULL, NULL, &s));
    ix_mv_unref(w->ctx, s);
}

static void point_rows(work *w, int degree, int spans, bool rational)
{
    char name[80];
    int n = spans > 0 ? spans : 1;

    w->a = make(w->ctx, degree, spans, rational, 0.7);
    snprintf(name, sizeof name, "point/curve, planar, %s degree %d, %d spans",
             rational ? "rational" : "polynomial", degree, n);
    ix_bench(name, plane_once, w, n, "span");
    snprintf(name, sizeof name, "point/curve, space, %s degree %d, %d spans",
             rational ? "rational" : "polynomial", degree, n);
    ix_bench(name, space_once, w, n, "span");
    ix_mv_unref(w->ctx, w->a);
}

/* A bicubic patch, and one of degree 2 with weights. */
static void surface_row(work *w, int order, bool rational)
{
    ix_dir d[2] = {{IX_BEZIER, order, order, false, NULL},
                   {IX_BEZIER, order, order, false, NULL}};
    double pts[64];
    int n = order * order, k = rational ? n : 0;
    char name[80];

    for (int i = 0; i < n; i++) {
        double x = i % order, y = i / order;

        pts[i] = 1.0 + 0.2 * i;
        pts[k + i] = x;
        pts[k + n + i] = y;
        pts[k + 2 * n + i] = sin(3.0 * x + 5.0 * y);
    }
    ix_bench_ok(w->ctx, ix_mv_new(w->ctx, 2, d, 3, rational, pts, &w->b));
    snprintf(name, sizeof name, "point/surface, %s degree %d",
             rational ? "rational" : "polynomial", order - 1);
    ix_bench(name, surface_once, w, 1, "patch");
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
    point_rows(&w, 3, 0, false);
    point_rows(&w, 2, 0, true);
    point_rows(&w, 3, 101, false);
    surface_row(&w, 4, false);
    surface_row(&w, 3, true);
    w.rep = &rep;
    row(&w, 3, 0, false);
    ix_ctx_free(w.ctx);
    return 0;
}
