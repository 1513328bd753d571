/* b_peers.c - tasks that other libraries do too: the same input as in
 * bench/peers, where their programs are. Lines with = hold the answers, by
 * which bench/run sees that all did the same. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include "iritx/contour.h"
#include "iritx/distance.h"
#include "peers/tasks.h"

typedef struct {
    ix_ctx *ctx;
    ix_mv *a, *b;
    int n;
    double *pts; /* [3][n] */
    double answer;
} work;

static double *numbers(size_t n)
{
    double *p = malloc(n * sizeof *p);

    if (!p)
        exit(1);
    return p;
}

static ix_mv *freeform(ix_ctx *ctx, int ndirs, int n, int ncoords,
                       const double *pts)
{
    double *kv = numbers((size_t)n + TASK_DEGREE + 1);
    ix_dir d[2] = {{IX_BSPLINE, TASK_DEGREE + 1, n, false, kv}};
    ix_mv *m;

    task_knots(n, kv);
    d[1] = d[0];
    ix_bench_ok(ctx, ix_mv_new(ctx, ndirs, d, ncoords, false, pts, &m));
    free(kv);
    return m;
}

static void row(work *w, const char *task, void (*fn)(void *), double units,
                const char *unit)
{
    char name[80];

    snprintf(name, sizeof name, "%s, n = %d", task, w->n);
    ix_bench(name, fn, w, units, unit);
    printf("=%s\t%.6g\n", name, w->answer);
    fflush(stdout);
}

static void meet(void *arg)
{
    work *w = arg;
    ix_solutions s;

    ix_bench_ok(w->ctx, ix_crv_crv_meet(w->ctx, w->a, w->b, NULL, &s));
    w->answer = s.n;
    ix_solutions_free(w->ctx, &s);
}

static void meets(work *w)
{
    for (int i = 0; i < TASK_COUNT(task_meet_n); i++) {
        size_t n = (size_t)(w->n = task_meet_n[i]);
        double *p = numbers(2 * n);

        task_meet_curve(0, w->n, p, p + n);
        w->a = freeform(w->ctx, 1, w->n, 2, p);
        task_meet_curve(1, w->n, p, p + n);
        w->b = freeform(w->ctx, 1, w->n, 2, p);
        meet(w);
        row(w, "curve/curve intersection, cubics", meet, w->answer, "point");
        ix_mv_unref(w->ctx, w->a);
        ix_mv_unref(w->ctx, w->b);
        free(p);
    }
}

static void near_curve(void *arg)
{
    work *w = arg;
    double t;

    ix_bench_ok(w->ctx, ix_crv_nearest(w->ctx, w->a, task_point, NULL, false,
                                       &t, &w->answer));
}

static void near_curves(work *w)
{
    for (int i = 0; i < TASK_COUNT(task_crv_n); i++) {
        size_t n = (size_t)(w->n = task_crv_n[i]);
        double *p = numbers(3 * n);

        task_curve(w->n, p, p + n, p + 2 * n);
        w->a = freeform(w->ctx, 1, w->n, 3, p);
        row(w, "point/curve distance, cubic", near_curve, w->n - TASK_DEGREE,
            "span");
        ix_mv_unref(w->ctx, w->a);
        free(p);
    }
}

static void near_surface(void *arg)
{
    work *w = arg;
    double uv[2];

    ix_bench_ok(w->ctx, ix_srf_nearest(w->ctx, w->a, task_point_srf, false, uv,
                                       &w->answer));
}

static void contour(void *arg)
{
    work *w = arg;
    const double plane[4] = {0, 0, 1, -task_level};
    ix_solution_curves c;

    ix_bench_ok(w->ctx, ix_contour(w->ctx, w->a, plane, TASK_TOL, &c));
    w->answer = c.ncurves;
    ix_solution_curves_free(w->ctx, &c);
}

static void surfaces(work *w)
{
    for (int i = 0; i < TASK_COUNT(task_srf_n); i++) {
        size_t n = (size_t)(w->n = task_srf_n[i]);
        double *p = numbers(3 * n * n), spans = w->n - TASK_DEGREE;

        task_surface(w->n, p, p + n * n, p + 2 * n * n);
        w->a = freeform(w->ctx, 2, w->n, 3, p);
        row(w, "point/surface distance, bicubic", near_surface, spans * spans,
            "patch");
        row(w, "contour of a bicubic", contour, spans * spans, "patch");
        ix_mv_unref(w->ctx, w->a);
        free(p);
    }
}

static void fit(void *arg)
{
    work *w = arg;
    ix_interpolate_opts o = {.order = TASK_DEGREE + 1, .size = TASK_FIT};
    ix_mv *m;

    ix_bench_ok(w->ctx, ix_interpolate(w->ctx, w->n, 3, false, w->pts, &o,
                                       &w->answer, &m));
    ix_mv_unref(w->ctx, m);
}

static void fits(work *w)
{
    for (int i = 0; i < TASK_COUNT(task_fit_n); i++) {
        size_t n = (size_t)(w->n = task_fit_n[i]);

        w->pts = numbers(3 * n);
        task_cloud(w->n, w->pts, w->pts + n, w->pts + 2 * n);
        row(w, "least squares, cubic, 1000 control points", fit, w->n, "point");
        free(w->pts);
    }
}

int main(void)
{
    work w = {.ctx = ix_ctx_new(NULL, NULL)};

    if (!w.ctx)
        return 1;
    meets(&w);
    near_curves(&w);
    surfaces(&w);
    fits(&w);
    ix_ctx_free(w.ctx);
    return 0;
}
