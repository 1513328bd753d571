/* b_geodesic.c - geodesics, offsets, medial and focal curves, from C. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>

#include "iritx/geodesic.h"

typedef struct {
    ix_ctx *ctx;
    ix_geo_surface s;
    ix_mv *a, *b;
    int what;
    size_t made; /* states of the last result */
} work;

/* (u, v, sin u cos v). */
static bool wave(void *ud, double u, double v, int order, double (*d)[3])
{
    double s = sin(u), c = cos(u), p = sin(v), q = cos(v);
    const double f[4] = {s, c, -s, -c}, g[4] = {q, -p, -q, p};
    static const int ij[10][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1},
                                  {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}};

    (void)ud;
    for (int k = 0; k < 10 && ij[k][0] + ij[k][1] <= order; k++) {
        d[k][0] = k == 0 ? u : k == 1;
        d[k][1] = k == 0 ? v : k == 2;
        d[k][2] = f[ij[k][0]] * g[ij[k][1]];
    }
    return true;
}

/* The same, roughly, as a spline of the given order and spans. */
static ix_mv *spline(ix_ctx *ctx, int order, int spans)
{
    double kv[64], pts[3 * 32 * 32], node[32];
    int n = order - 1 + spans;
    ix_dir d[2] = {{IX_BSPLINE, order, n, false, kv},
                   {IX_BSPLINE, order, n, false, kv}};
    ix_mv *m;

    for (int i = 0; i < n + order; i++) {
        double t = (double)(i - order + 1) / spans;

        kv[i] = 6.283185307179586 * fmin(fmax(t, 0), 1);
    }
    ix_knots_nodes(&d[0], node);
    for (int i = 0; i < n * n; i++) {
        pts[i] = node[i % n];
        pts[n * n + i] = node[i / n];
        pts[2 * n * n + i] = sin(node[i % n]) * cos(node[i / n]);
    }
    ix_bench_ok(ctx, ix_mv_new(ctx, 2, d, 3, false, pts, &m));
    return m;
}

static ix_mv *line(ix_ctx *ctx, double v0, double v1, double bend)
{
    const double pts[6] = {0.5, 3, 5.8, v0, 0.5 * (v0 + v1) + bend, v1};
    const ix_dir d = {IX_BEZIER, 3, 3, false, NULL};
    ix_mv *m;

    ix_bench_ok(ctx, ix_mv_new(ctx, 1, &d, 2, false, pts, &m));
    return m;
}

static void once(void *arg)
{
    static const double uv[2] = {0.5, 3.1}, dir[2] = {1, 0.1};
    static const ix_medial_opts m = {.sides = {1, -1}};
    static const ix_geo_opts coarse = {.tol = 1e-4};
    work *w = arg;
    ix_geo_curve c;
    ix_geo_curves o;

    if (w->what == 0) {
        ix_bench_ok(w->ctx,
                    ix_geodesic(w->ctx, &w->s, uv, dir, 5, NULL, NULL, &c));
        w->made = ix_mv_npts(c.states);
        ix_geo_curve_free(w->ctx, &c);
        return;
    }
    if (w->what == 1)
        ix_bench_ok(w->ctx, ix_geodesic_offset(w->ctx, &w->s, w->a, 0.5, NULL,
                                               &coarse, NULL, NULL, &o));
    else if (w->what == 2)
        ix_bench_ok(w->ctx,
                    ix_medial_crv(w->ctx, &w->s, w->a, w->b, &m, &coarse, &o));
    else
        ix_bench_ok(w->ctx,
                    ix_srf_focal_crv(w->ctx, &w->s, w->b, -1, &coarse, &o));
    w->made = 0;
    for (int i = 0; i < o.n; i++)
        w->made += ix_mv_npts(o.crv[i].states);
    ix_geo_curves_free(w->ctx, &o);
}

static void rows(work *w, const char *on)
{
    static const char *const what[4] = {"geodesic", "geodesic offset",
                                        "medial curve, borders that meet",
                                        "focal curve"};
    char name[96];

    for (w->what = 0; w->what < 4; w->what++) {
        once(w); /* counts what is made */
        (void)snprintf(name, sizeof name, "%s, %s", what[w->what], on);
        ix_bench(name, once, w, (double)w->made, "state");
    }
}

int main(void)
{
    work w = {.ctx = ix_ctx_new(NULL, NULL)};
    ix_mv *m;

    if (!w.ctx)
        return 1;
    w.a = line(w.ctx, 2.6, 3.6, 0);
    w.b = line(w.ctx, 3.4, 2.8, 0.8);
    w.s = (ix_geo_surface){.fn = wave,
                           .hi = {6.283185307179586, 6.283185307179586}};
    rows(&w, "function");
    w.s = (ix_geo_surface){.mv = m = spline(w.ctx, 4, 12)};
    rows(&w, "bicubic, 12 x 12 spans");
    ix_mv_unref(w.ctx, m);
    w.s.mv = m = spline(w.ctx, 12, 12);
    w.what = 0;
    once(&w);
    ix_bench("geodesic, order 12, 12 x 12 spans", once, &w, (double)w.made,
             "state");
    ix_mv_unref(w.ctx, m);
    ix_mv_unref(w.ctx, w.a);
    ix_mv_unref(w.ctx, w.b);
    ix_ctx_free(w.ctx);
    return 0;
}
