/* b_eval.c - values: one point, a million points, a grid. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>

#include "iritx/mv.h"

#define MANY 1000000

typedef struct {
    ix_ctx *ctx;
    ix_mv *m;
    size_t n;
    double *t, *out;
    const double *axes[2];
    int counts[2];
} task;

static unsigned long long state = 1;

static double random_unit(void)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(state >> 11) * 0x1p-53;
}

/* Open uniform B-spline with random points, weights in [0.5, 1.5]. */
static ix_mv *make(ix_ctx *ctx, int ndirs, int order, int length, bool rational)
{
    double knots[2000], *pts;
    ix_dir dirs[2];
    size_t npts = 1, n;
    ix_mv *m;

    ix_bench_ok(ctx, ix_knots_make(ctx, IX_KV_OPEN, order, length, knots));
    for (int d = 0; d < ndirs; d++) {
        dirs[d] = (ix_dir){IX_BSPLINE, order, length, false, knots};
        npts *= (size_t)length;
    }
    n = npts * (size_t)(3 + rational);
    pts = malloc(n * sizeof *pts);
    for (size_t i = 0; pts && i < n; i++)
        pts[i] = rational && i < npts ? 0.5 + random_unit() : random_unit();
    ix_bench_ok(ctx, ix_mv_new(ctx, ndirs, dirs, 3, rational, pts, &m));
    free(pts);
    return m;
}

static void run_one(void *arg)
{
    task *k = arg;
    double t[2] = {k->t[0], k->t[1]};

    ix_bench_ok(k->ctx, ix_mv_point(k->ctx, k->m, t, k->out));
}

static void run_many(void *arg)
{
    task *k = arg;

    ix_bench_ok(k->ctx, ix_mv_point_many(k->ctx, k->m, k->n, k->t, k->out));
}

static void run_grid(void *arg)
{
    task *k = arg;

    ix_bench_ok(k->ctx,
                ix_mv_eval_grid(k->ctx, k->m, k->counts, k->axes, k->out));
}

static void random_params(task *k)
{
    for (size_t i = 0; i < 2 * k->n; i++)
        k->t[i] = random_unit();
}

static void sorted_params(task *k)
{
    for (size_t i = 0; i < k->n; i++)
        k->t[i] = (double)i / (double)(k->n - 1);
}

static void curve(task *k, int order, bool rational)
{
    char name[64];

    k->m = make(k->ctx, 1, order, 16, rational);
    random_params(k);
    snprintf(name, sizeof name, "eval-one-d%d%s", order - 1,
             rational ? "-rational" : "");
    ix_bench(name, run_one, k, 1, "point");
    for (int sorted = 0; sorted < 2; sorted++) {
        if (sorted)
            sorted_params(k);
        snprintf(name, sizeof name, "eval-many-%s-d%d%s",
                 sorted ? "sorted" : "random", order - 1,
                 rational ? "-rational" : "");
        ix_bench(name, run_many, k, MANY, "point");
    }
    ix_mv_unref(k->ctx, k->m);
}

static void surface(task *k, bool rational)
{
    const char *suffix = rational ? "-rational" : "";
    char name[64];

    k->m = make(k->ctx, 2, 4, 16, rational);
    random_params(k);
    snprintf(name, sizeof name, "eval-one-bicubic%s", suffix);
    ix_bench(name, run_one, k, 1, "point");
    snprintf(name, sizeof name, "eval-many-bicubic%s", suffix);
    ix_bench(name, run_many, k, MANY, "point");
    sorted_params(k);
    k->counts[0] = k->counts[1] = 1000;
    for (int i = 0; i < 1000; i++)
        k->t[i] = (double)i / 999;
    k->axes[0] = k->axes[1] = k->t;
    snprintf(name, sizeof name, "eval-grid-bicubic%s", suffix);
    ix_bench(name, run_grid, k, MANY, "point");
    ix_mv_unref(k->ctx, k->m);
}

int main(int argc, char **argv)
{
    task k = {.n = MANY};

    k.ctx = ix_ctx_new(NULL, NULL);
    k.t = malloc(2 * MANY * sizeof *k.t);
    k.out = malloc(4 * MANY * sizeof *k.out);
    if (!k.ctx || !k.t || !k.out)
        return 1;
    ix_ctx_set_threads(k.ctx, argc > 1 ? atoi(argv[1]) : 0);
    curve(&k, 4, false);
    curve(&k, 4, true);
    curve(&k, 8, false);
    curve(&k, 12, true);
    surface(&k, false);
    surface(&k, true);
    free(k.t);
    free(k.out);
    ix_ctx_free(k.ctx);
    return 0;
}
