/* b_plane.c - bisectors in the plane: correspondence of feet, true bisectors of
 * points and curves, from C. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>

#include "iritx/ops_plane.h"

typedef struct {
    ix_ctx *ctx;
    ix_mv *a, *b;
    int func;
} work;

static ix_mv *curve(ix_ctx *ctx, int degree, int spans, double seed, double y)
{
    double kv[256], pts[2 * 128];
    int n = degree + (spans > 0 ? spans : 1);
    ix_dir d = {spans > 0 ? IX_BSPLINE : IX_BEZIER, degree + 1, n, false, kv};
    ix_mv *m;

    for (int i = 0; i < n + degree + 1; i++)
        kv[i] = i <= degree ? 0 : i >= n ? spans : i - degree;
    for (int i = 0; i < n; i++) {
        pts[i] = i;
        pts[n + i] = y + sin(i * seed + seed);
    }
    ix_bench_ok(ctx, ix_mv_new(ctx, 1, &d, 2, false, pts, &m));
    return m;
}

static void field(void *arg)
{
    work *w = arg;
    ix_mv *f;

    ix_bench_ok(w->ctx, ix_cbisector2d(w->ctx, w->a, w->b, w->func, NULL, &f));
    ix_mv_unref(w->ctx, f);
}

static void untrimmed(void *arg)
{
    work *w = arg;
    ix_lines l;

    ix_bench_ok(w->ctx,
                ix_cbisector2d_curves(w->ctx, w->a, w->b, 0, false, &l));
    ix_lines_free(w->ctx, &l);
}

static void two_curves(void *arg)
{
    work *w = arg;
    const ix_mv *const a[1] = {w->a}, *const b[1] = {w->b};
    ix_bisector s;

    ix_bench_ok(w->ctx, ix_bisect_crv_crv(w->ctx, 1, a, 1, b, 0, &s));
    ix_bisector_free(w->ctx, &s);
}

static void point(void *arg)
{
    static const double q[2] = {0.7, 1.5};
    work *w = arg;
    ix_bisector s;

    ix_bench_ok(w->ctx, ix_bisect_pt_crv(w->ctx, w->a, q, false, 0, &s));
    ix_bisector_free(w->ctx, &s);
}

static void pair(work *w, int spans)
{
    int n = spans > 0 ? spans : 1;
    char name[80];

    w->a = curve(w->ctx, 3, spans, 0.7, 0);
    w->b = curve(w->ctx, 3, spans, 1.9, 3);
    for (w->func = 1; w->func <= 4; w->func++) {
        snprintf(name, sizeof name,
                 "planar correspondence %d, two cubics, %d spans", w->func, n);
        ix_bench(name, field, w, (double)n * n, "patch");
    }
    snprintf(name, sizeof name, "untrimmed bisector, two cubics, %d spans", n);
    ix_bench(name, untrimmed, w, (double)n * n, "patch");
    snprintf(name, sizeof name, "true bisector, two cubics, %d spans", n);
    ix_bench(name, two_curves, w, n, "span");
    snprintf(name, sizeof name, "true bisector, point and cubic, %d spans", n);
    ix_bench(name, point, w, n, "span");
    ix_mv_unref(w->ctx, w->a);
    ix_mv_unref(w->ctx, w->b);
}

static void axis(void *arg)
{
    work *w = arg;
    const ix_mv *const c[1] = {w->a};
    ix_medial_axis m;

    ix_bench_ok(w->ctx, ix_medial_axis_of(w->ctx, 1, c, 0, &m));
    ix_medial_axis_free(w->ctx, &m);
}

/* A closed cubic with n spans. */
static void medial(work *w, int n)
{
    double kv[128 + 8], pts[2 * 128];
    ix_dir d = {IX_BSPLINE, 4, n, true, kv};
    char name[80];

    for (int i = 0; i < n + 7; i++)
        kv[i] = i - 3;
    for (int i = 0; i < n; i++) {
        double a = 6.283185307179586 * i / n;
        double r = 1 + 0.2 * sin(3 * a) + 0.1 * sin(11 * a + 1);

        pts[i] = r * cos(a);
        pts[n + i] = r * sin(a);
    }
    ix_bench_ok(w->ctx, ix_mv_new(w->ctx, 1, &d, 2, false, pts, &w->a));
    snprintf(name, sizeof name, "medial axis, closed cubic, %d spans", n);
    ix_bench(name, axis, w, n, "span");
    ix_mv_unref(w->ctx, w->a);
}

int main(void)
{
    work w = {.ctx = ix_ctx_new(NULL, NULL)};

    pair(&w, 0);
    pair(&w, 8);
    pair(&w, 32);
    medial(&w, 25);
    medial(&w, 50);
    medial(&w, 100);
    ix_ctx_free(w.ctx);
    return 0;
}
