/* b_spans.c - decomposition into spans and back, and what stands on it: the
 * cost per span must not depend on their number. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <limits.h>

#include "bsp/spans.h"
#include "iritx/mv.h"

typedef struct {
    ix_ctx *ctx;
    ix_mv *m;
    ix_dir dir, target;
    ix_spans sp;
    double *bern, *raised, *out;
    size_t outer;
    double knots[64];
    int nknots;
} task;

static unsigned long long state = 1;

static double random_unit(void)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(state >> 11) * 0x1p-53;
}

/* Open uniform B-spline curve with random points. */
static ix_mv *make(ix_ctx *ctx, int order, int spans, int ncoords)
{
    int n = spans + order - 1;
    double *knots = malloc((size_t)(n + order) * sizeof *knots);
    double *pts = malloc((size_t)(n * ncoords) * sizeof *pts);
    ix_dir dir = {IX_BSPLINE, order, n, false, knots};
    ix_mv *m;

    if (!knots || !pts)
        exit(1);
    ix_bench_ok(ctx, ix_knots_make(ctx, IX_KV_OPEN, order, n, knots));
    for (int i = 0; i < n * ncoords; i++)
        pts[i] = random_unit();
    ix_bench_ok(ctx, ix_mv_new(ctx, 1, &dir, ncoords, false, pts, &m));
    free(knots);
    free(pts);
    return m;
}

static void run_extract(void *arg)
{
    task *k = arg;

    ix_bench_ok(k->ctx, ix__spans_extract(k->ctx, &k->dir, &k->sp, k->outer, 1,
                                          ix_mv_axis(k->m, 0), k->bern));
}

static void run_compose(void *arg)
{
    task *k = arg;

    ix_bench_ok(k->ctx, ix__spans_compose(k->ctx, &k->sp, &k->target, k->outer,
                                          1, k->bern, k->out));
}

static void run_raise(void *arg)
{
    task *k = arg;
    ix_mv *r;

    ix_bench_ok(k->ctx, ix_mv_raise(k->ctx, k->m, 0, k->dir.order + 2, &r));
    ix_mv_unref(k->ctx, r);
}

static void run_insert(void *arg)
{
    task *k = arg;
    ix_mv *r;

    ix_bench_ok(k->ctx,
                ix_mv_insert_knots(k->ctx, k->m, 0, k->nknots, k->knots, &r));
    ix_mv_unref(k->ctx, r);
}

static void run_pieces(void *arg)
{
    task *k = arg;
    ix_mv_pieces p;

    ix_bench_ok(k->ctx, ix_mv_to_bezier(k->ctx, k->m, &p));
    ix_mv_pieces_free(k->ctx, &p);
}

/* Extraction and composition at the multiplicity of the square: the largest
 * work of a product besides the product. */
static void spans(ix_ctx *ctx, int order, int nspans, int ncoords)
{
    task k = {.ctx = ctx, .m = make(ctx, order, nspans, ncoords)};
    ix_mark mk = ix__scratch_mark(ctx);
    size_t n = (size_t)nspans * (size_t)(2 * order - 1) * (size_t)ncoords;
    char name[64];

    k.dir = ix_mv_dir(k.m, 0);
    k.outer = (size_t)ncoords;
    k.bern = ix__scratch_zero(ctx, n, sizeof *k.bern);
    k.out = ix__scratch(ctx, n + (size_t)(2 * order), sizeof *k.out);
    ix_bench_ok(ctx, ix__spans_of(ctx, &k.dir, &k.sp));
    snprintf(name, sizeof name, "extract-d%d-%dx%d", order - 1, ncoords,
             nspans);
    ix_bench(name, run_extract, &k, nspans, "span");
    k.sp.degree = 2 * order - 2;
    ix_bench_ok(ctx, ix__spans_target(ctx, &k.sp, INT_MAX, true, &k.target));
    snprintf(name, sizeof name, "compose-d%d-%dx%d", 2 * order - 2, ncoords,
             nspans);
    ix_bench(name, run_compose, &k, nspans, "span");
    ix__scratch_release(ctx, mk);
    ix_mv_unref(ctx, k.m);
}

static void operations(ix_ctx *ctx)
{
    task k = {.ctx = ctx, .m = make(ctx, 4, 13, 3), .nknots = 64};

    k.dir = ix_mv_dir(k.m, 0);
    for (int i = 0; i < 64; i++)
        k.knots[i] = random_unit();
    ix_bench("raise-cubic-to-5", run_raise, &k, 13, "span");
    ix_bench("insert-64-knots", run_insert, &k, 64, "knot");
    ix_bench("bezier-pieces", run_pieces, &k, 13, "span");
    ix_mv_unref(ctx, k.m);
}

int main(int argc, char **argv)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    if (!ctx)
        return 1;
    ix_ctx_set_threads(ctx, argc > 1 ? atoi(argv[1]) : 0);
    operations(ctx);
    spans(ctx, 4, 100, 1);
    spans(ctx, 4, 1000, 1);
    spans(ctx, 4, 10000, 1);
    spans(ctx, 4, 1000, 4);
    spans(ctx, 13, 100, 1);
    spans(ctx, 13, 100, 4);
    ix_ctx_free(ctx);
    return 0;
}
