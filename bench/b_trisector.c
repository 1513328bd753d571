/* b_trisector.c - curves equally far from three points, curves and surfaces. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>
#include <string.h>

#include "iritx/ops_mbisect.h"

typedef struct {
    ix_ctx *ctx;
    ix_mv *m[3];
} work;

static void once(void *arg)
{
    static const double box[6] = {-1, -1, -1, 1, 1, 1};
    work *w = arg;
    bool complete;
    ix_lines l;

    ix_bench_ok(w->ctx, ix_trisector(w->ctx, (const ix_mv *const *)w->m, 1e-2,
                                     box, &l, &complete));
    ix_lines_free(w->ctx, &l);
}

/* A point, a curve, or a surface across the axis, of one Bezier piece. */
static ix_mv *make(ix_ctx *ctx, char kind, int order, int axis)
{
    int nu = kind == 'p' ? 1 : order, nv = kind == 's' ? order : 1, n = nu * nv;
    const ix_dir d[2] = {{IX_BEZIER, nu, nu, false, NULL},
                         {IX_BEZIER, nv, nv, false, NULL}};
    double p[3 * 16];
    ix_mv *m;

    for (int i = 0; i < n; i++) {
        double u = nu > 1 ? 2.4 * (i % nu) / (nu - 1) - 1.2 : 0.3;
        double v = nv > 1 ? 2.4 * (i / nu) / (nv - 1) - 1.2 : sin(2.0 * i + u);
        double x[3] = {u, v,
                       0.4 * sin(7.0 * i + 3.0 * axis) + 0.3 * axis - 0.5};

        for (int k = 0; k < 3; k++)
            p[(k + axis) % 3 * n + i] = x[k];
    }
    ix_bench_ok(ctx, ix_mv_new(ctx, kind == 's' ? 2 : 1, d, 3, false, p, &m));
    return m;
}

static void row(work *w, const char *kinds, int order)
{
    char name[80];

    for (int k = 0; k < 3; k++)
        w->m[k] = make(w->ctx, kinds[k], order, k);
    snprintf(name, sizeof name, "trisector, %s, degree %d", kinds, order - 1);
    ix_bench(name, once, w, 1, "call");
    for (int k = 0; k < 3; k++)
        ix_mv_unref(w->ctx, w->m[k]);
}

int main(void)
{
    static const char *const kinds[] = {"pps", "pcc", "pcs", "pss",
                                        "ccc", "ccs", "css"};
    work w = {.ctx = ix_ctx_new(NULL, NULL)};

    if (!w.ctx)
        return 1;
    ix_ctx_set_threads(w.ctx, 1);
    for (int i = 0; i < 7; i++)
        for (int order = 3; order <= 4; order++)
            row(&w, kinds[i], order);
    row(&w, "sss", 3);
    ix_ctx_free(w.ctx);
    return 0;
}
