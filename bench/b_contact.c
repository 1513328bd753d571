/* b_contact.c - lines that touch a surface closely, radial curvature, folds. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>

#include "iritx/geom_srf.h"
#include "iritx/ops_srf.h"

typedef struct {
    ix_ctx *ctx;
    ix_mv *m;
    int what;
} work;

/* A bicubic patch, rational or not; as a block, its layers 1 apart and back. */
static ix_mv *patch(ix_ctx *ctx, bool rational)
{
    const ix_dir d[2] = {{IX_BEZIER, 4, 4, false, NULL},
                         {IX_BEZIER, 4, 4, false, NULL}};
    double pts[64], *p = pts + (rational ? 16 : 0);
    ix_mv *m;

    for (int i = 0; i < 16; i++) {
        double w = rational ? 1 + 0.2 * sin(5 * i) : 1;

        pts[i] = w;
        p[i] = w * (i % 4) / 3;
        p[16 + i] = w * (double)(i / 4) / 3;
        p[32 + i] = w * sin(i * i);
    }
    ix_bench_ok(ctx, ix_mv_new(ctx, 2, d, 3, rational, pts, &m));
    return m;
}

static void once(void *arg)
{
    static const double view[3] = {0.5, 0.3, 0.8};
    static const int cells[3] = {8, 8, 8};
    ix_solution_curves c = {.unknowns = 0};
    ix_solutions p = {.n = 0};
    ix_lines l = {.n = 0};
    work *w = arg;

    if (w->what == 0)
        ix_bench_ok(w->ctx, ix_srf_flecnodal(w->ctx, w->m, 1e-3, &c));
    else if (w->what == 1)
        ix_bench_ok(w->ctx, ix_srf_flecnodal_points(w->ctx, w->m, &p));
    else if (w->what == 2)
        ix_bench_ok(w->ctx, ix_srf_radial(w->ctx, w->m, view, 1e-3, &c));
    else
        ix_bench_ok(w->ctx, ix_tv_fold(w->ctx, w->m, cells, true, &l));
    ix_solution_curves_free(w->ctx, &c);
    ix_solutions_free(w->ctx, &p);
    ix_lines_free(w->ctx, &l);
}

static ix_mv *block(ix_ctx *ctx, const ix_mv *s)
{
    static const double up[16] = {1, 0, 0, 0, 0, 1, 0, 0,
                                  0, 0, 1, 0, 0, 0, 1, 1};
    const ix_mv *layer[3] = {s, NULL, s};
    ix_mv *top, *m;

    ix_bench_ok(ctx, ix_mv_transform(ctx, s, up, &top));
    layer[1] = top;
    ix_bench_ok(ctx, ix_srf_layers(ctx, 3, layer, 3, IX_KV_OPEN, &m));
    ix_mv_unref(ctx, top);
    return m;
}

int main(void)
{
    static const char *const name[3] = {"flecnodal curves",
                                        "points of five-fold contact",
                                        "zeros of radial curvature"};
    work w = {.ctx = ix_ctx_new(NULL, NULL)};

    for (int r = 0; r < 2; r++) {
        char row[80];

        w.m = patch(w.ctx, r == 1);
        for (w.what = 0; w.what < 3; w.what++) {
            snprintf(row, sizeof row, "%s, %s bicubic patch", name[w.what],
                     r ? "rational" : "polynomial");
            ix_bench(row, once, &w, 1, "patch");
        }
        if (r == 0) {
            ix_mv *s = w.m;

            w.m = block(w.ctx, s);
            ix_bench("fold of a block, 8 x 8 x 8 boxes", once, &w, 512, "box");
            ix_mv_unref(w.ctx, s);
        }
        ix_mv_unref(w.ctx, w.m);
    }
    ix_ctx_free(w.ctx);
    return 0;
}
