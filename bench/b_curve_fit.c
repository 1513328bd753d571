/* b_curve_fit.c - interpolation, least squares, arc length, arcs and pieces:
 * what fitting curves costs per point or span. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>

#include "iritx/geom.h"

#define N 10000
#define M 1000

typedef struct {
    ix_ctx *ctx;
    double pts[3 * N];
    ix_interpolate_opts o;
    ix_mv *crv; /* through M points of the plane */
    double tol;
} fits;

static void interpolate(void *arg)
{
    fits *f = arg;
    ix_mv *m;

    ix_bench_ok(f->ctx,
                ix_interpolate(f->ctx, N, 3, false, f->pts, &f->o, NULL, &m));
    ix_mv_unref(f->ctx, m);
}

static void arc_length(void *arg)
{
    fits *f = arg;
    ix_mv *m;

    ix_bench_ok(f->ctx, ix_arclen(f->ctx, f->crv, f->tol, 4, NULL, &m));
    ix_mv_unref(f->ctx, m);
}

static void length(void *arg)
{
    fits *f = arg;
    double len;

    ix_bench_ok(f->ctx, ix_length(f->ctx, f->crv, NULL, &len));
}

static void arcs(void *arg)
{
    fits *f = arg;
    ix_crvs c;

    ix_bench_ok(f->ctx, ix_biarcs(f->ctx, f->crv, f->tol, 90, NULL, &c));
    ix_crvs_free(f->ctx, &c);
}

static void cubics(void *arg)
{
    fits *f = arg;
    ix_crvs c;

    ix_bench_ok(f->ctx, ix_fit_pieces(f->ctx, f->crv, 4, f->tol, 0, NULL, &c));
    ix_crvs_free(f->ctx, &c);
}

static void run(fits *f)
{
    f->o = (ix_interpolate_opts){.order = 4, .param = IX_PARAM_CHORD};
    ix_bench("curve interpolate, cubic", interpolate, f, N, "point");
    f->o.order = 6;
    ix_bench("curve interpolate, quintic", interpolate, f, N, "point");
    f->o = (ix_interpolate_opts){.order = 4, .periodic = true};
    ix_bench("curve interpolate, periodic cubic", interpolate, f, N, "point");
    f->o = (ix_interpolate_opts){.order = 4, .size = 1000};
    ix_bench("curve least squares, 1000 points", interpolate, f, N, "point");
    f->tol = 1e-6;
    ix_bench("curve length to 1e-12", length, f, M, "span");
    ix_bench("curve by arc length, 1e-6", arc_length, f, M, "span");
    ix_bench("curve to arcs, 1e-6", arcs, f, M, "span");
    ix_bench("curve to cubics, 1e-6", cubics, f, M, "span");
}

int main(void)
{
    static fits f;
    double flat[2 * M];

    f.ctx = ix_ctx_new(NULL, NULL);
    if (!f.ctx)
        return 1;
    for (int i = 0; i < N; i++) {
        double a = 0.01 * i;

        f.pts[i] = (10 + sin(3 * a)) * cos(a);
        f.pts[N + i] = (10 + cos(2 * a)) * sin(a);
        f.pts[2 * N + i] = a;
    }
    for (int i = 0; i < M; i++) {
        flat[i] = f.pts[i];
        flat[M + i] = f.pts[N + i];
    }
    f.o.order = 4;
    ix_bench_ok(f.ctx,
                ix_interpolate(f.ctx, M, 2, false, flat, &f.o, NULL, &f.crv));
    run(&f);
    ix_mv_unref(f.ctx, f.crv);
    ix_ctx_free(f.ctx);
    return 0;
}
