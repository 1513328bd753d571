/* b_srf_fit.c - surfaces and trivariates near data, ribs, domains divided by
 * curves: what they cost per sample, point, span or region. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>

#include "iritx/geom.h"
#include "iritx/geom_srf.h"
#include "iritx/regions.h"

enum { LINES = 20, CLOUD = 2000 };

typedef struct {
    ix_ctx *ctx;
    ix_mv *hill, *path, *section, *crv[LINES];
    int samples;
    double par[3 * CLOUD], val[CLOUD];
} fits;

static void ruled(void *arg)
{
    fits *f = arg;
    const ix_ruled_opts o = {.dir = 1, .samples = f->samples};
    ix_mv *m;

    ix_bench_ok(f->ctx, ix_srf_fit_ruled(f->ctx, f->hill, &o, NULL, &m));
    ix_mv_unref(f->ctx, m);
}

static void scattered(void *arg)
{
    fits *f = arg;
    const ix_cloud c = {3, CLOUD, f->par, 1, f->val};
    const int order[3] = {3, 3, 3}, size[3] = {6, 6, 6};
    ix_mv *m;

    ix_bench_ok(f->ctx, ix_mv_fit_points(f->ctx, &c, order, size, &m));
    ix_mv_unref(f->ctx, m);
}

static void rib(void *arg)
{
    fits *f = arg;
    const ix_rib o = {.path = f->path,
                      .section = f->section,
                      .tan_scale = 1,
                      .width = 0.1,
                      .height = 0.1};
    ix_mv *m;

    ix_bench_ok(f->ctx, ix_srf_rib(f->ctx, f->hill, &o, &m));
    ix_mv_unref(f->ctx, m);
}

static void divide(void *arg)
{
    const double box[2][2] = {{0, 1}, {0, 1}};
    fits *f = arg;
    ix_regions r;

    ix_bench_ok(f->ctx, ix_divide_box(f->ctx, box, LINES,
                                      (const ix_mv *const *)f->crv, &r));
    ix_regions_free(f->ctx, &r);
}

static void bezier(fits *f, int ndirs, int n, int ncoords, const double *pts,
                   ix_mv **out)
{
    const ix_dir d[2] = {{IX_BEZIER, n, n, false, NULL},
                         {IX_BEZIER, n, n, false, NULL}};

    ix_bench_ok(f->ctx, ix_mv_new(f->ctx, ndirs, d, ncoords, false, pts, out));
}

static void make(fits *f)
{
    const double path[6] = {0.2, 0.8, 0.7, 0.2, 0.3, 0.8};
    const double section[10] = {-1, -0.3, 0, 0.3, 1, 0, 0, 2, 0, 0};
    const double irrational[3] = {1.41421356237, 1.73205080757, 2.2360679775};
    double hill[48];

    for (int i = 0; i < 16; i++) {
        hill[i] = i % 4;
        hill[16 + i] = (int)(i / 4);
        hill[32 + i] = sin(5.0 * i);
    }
    bezier(f, 2, 4, 3, hill, &f->hill);
    bezier(f, 1, 3, 2, path, &f->path);
    bezier(f, 1, 5, 2, section, &f->section);
    for (int i = 0; i < LINES; i++) { /* half of them cross the others */
        double x = (i % 10 + 0.5) / 10, y = (i * 3 % 10 + 0.5) / 10;
        double a[4] = {0, 1, x, y}, b[4] = {x, y, 0, 1};

        bezier(f, 1, 2, 2, i < 10 ? a : b, &f->crv[i]);
    }
    for (int i = 0; i < CLOUD; i++) {
        for (int d = 0; d < 3; d++)
            f->par[d * CLOUD + i] = fmod(i * irrational[d], 1);
        f->val[i] = sin(f->par[i]);
    }
}

int main(void)
{
    static fits f;

    f.ctx = ix_ctx_new(NULL, NULL);
    if (!f.ctx)
        return 1;
    make(&f);
    f.samples = 20;
    ix_bench("ruled fit, 20 samples", ruled, &f, f.samples, "sample");
    f.samples = 100;
    ix_bench("ruled fit, 100 samples", ruled, &f, f.samples, "sample");
    ix_bench("trivariate fit, 6^3 points", scattered, &f, CLOUD, "point");
    ix_bench("rib on a bicubic", rib, &f, 1, "rib");
    ix_bench("domain divided by 20 lines", divide, &f, LINES, "line");
    for (int i = 0; i < LINES; i++)
        ix_mv_unref(f.ctx, f.crv[i]);
    ix_mv_unref(f.ctx, f.hill);
    ix_mv_unref(f.ctx, f.path);
    ix_mv_unref(f.ctx, f.section);
    ix_ctx_free(f.ctx);
    return 0;
}
