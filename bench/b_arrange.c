/* b_arrange.c - arrangements of curves: cutting at all meetings, finding the
 * faces; per edge of the result. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include "iritx/arrange.h"

#define CURVES 24
#define POINTS 6

typedef struct {
    ix_ctx *ctx;
    ix_mv *crv[CURVES];
    ix_arrangement *whole, *cut;
} arrangement;

/* Closed cubics of random control points in the unit square; a fixed linear
 * congruence. */
static void make(arrangement *a)
{
    unsigned long seed = 12345;
    double knots[2 * 4 + POINTS - 1];
    const ix_dir d = {.basis = IX_BSPLINE,
                      .order = 4,
                      .length = POINTS,
                      .periodic = true,
                      .knots = knots};

    ix_bench_ok(a->ctx,
                ix_knots_make(a->ctx, IX_KV_PERIODIC, 4, POINTS, knots));
    for (int i = 0; i < CURVES; i++) {
        double pts[2 * POINTS];

        for (int k = 0; k < 2 * POINTS; k++) {
            seed = (1103515245 * seed + 12345) & 0x7fffffff;
            pts[k] = (double)seed / 0x7fffffff;
        }
        ix_bench_ok(a->ctx,
                    ix_mv_new(a->ctx, 1, &d, 2, false, pts, &a->crv[i]));
    }
    ix_bench_ok(a->ctx,
                ix_arrangement_new(a->ctx, CURVES, (const ix_mv *const *)a->crv,
                                   1e-7, &a->whole));
    ix_bench_ok(a->ctx, ix_arrangement_copy(a->ctx, a->whole, &a->cut));
    ix_bench_ok(a->ctx, ix_arrangement_split_meetings(a->ctx, a->cut, 1e-8));
}

static void meetings(void *arg)
{
    arrangement *a = arg, b = *a;

    ix_bench_ok(a->ctx, ix_arrangement_copy(a->ctx, a->whole, &b.cut));
    ix_bench_ok(a->ctx, ix_arrangement_split_meetings(a->ctx, b.cut, 1e-8));
    ix_arrangement_free(a->ctx, b.cut);
}

static void faces(void *arg)
{
    arrangement *a = arg;

    ix_bench_ok(a->ctx, ix_arrangement_evaluate(a->ctx, a->cut, false));
}

int main(void)
{
    arrangement a = {.ctx = ix_ctx_new(NULL, NULL)};

    if (!a.ctx)
        return 1;
    make(&a);
    ix_bench("arrangement, cut at meetings", meetings, &a, a.cut->nedges,
             "edge");
    ix_bench("arrangement, faces", faces, &a, a.cut->nedges, "edge");
    ix_arrangement_free(a.ctx, a.whole);
    ix_arrangement_free(a.ctx, a.cut);
    for (int i = 0; i < CURVES; i++)
        ix_mv_unref(a.ctx, a.crv[i]);
    ix_ctx_free(a.ctx);
    return 0;
}
