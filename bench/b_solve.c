/* b_solve.c - the solvers: roots of one polynomial, systems, curves. The
 * units of a system are the boxes that it visits. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>
#include <string.h>

#include "iritx/solve.h"

typedef struct {
    ix_ctx *ctx;
    ix_mv *f[3];
    ix_equation eq[3];
    int neq;
    size_t boxes;
} work;

static void roots(void *arg)
{
    work *w = arg;
    ix_root *r;
    int n;

    ix_bench_ok(w->ctx, ix_roots(w->ctx, w->f[0], 0, NULL, &r, &n));
    ix_roots_free(w->ctx, r, n);
}

static void system_of(void *arg)
{
    work *w = arg;
    ix_solutions s;

    ix_bench_ok(w->ctx, ix_solve(w->ctx, w->neq, w->eq, NULL, &s));
    w->boxes = s.boxes;
    ix_solutions_free(w->ctx, &s);
}

static void curves(void *arg)
{
    work *w = arg;
    ix_solution_curves s;

    ix_bench_ok(w->ctx, ix_solve_curves(w->ctx, w->neq, w->eq, NULL, &s));
    w->boxes = s.boxes;
    ix_solution_curves_free(w->ctx, &s);
}

/* A scalar of n directions of one degree with coefficients from sines. */
static ix_mv *wave(ix_ctx *ctx, int n, int degree, double seed)
{
    double pts[4096];
    ix_dir d[4];
    size_t size = 1;
    ix_mv *m;

    for (int j = 0; j < n; j++) {
        d[j] = (ix_dir){
            .basis = IX_BEZIER, .order = degree + 1, .length = degree + 1};
        size *= (size_t)degree + 1;
    }
    for (size_t i = 0; i < size; i++)
        pts[i] = sin(seed * (double)(i + 1) * (double)(i + 2));
    ix_bench_ok(ctx, ix_mv_new(ctx, n, d, 1, false, pts, &m));
    return m;
}

static void set(work *w, int neq, int n, int degree, double seed)
{
    w->neq = neq;
    for (int i = 0; i < neq; i++) {
        w->f[i] = wave(w->ctx, n, degree, seed + 0.37 * i);
        w->eq[i] = (ix_equation){w->f[i], 0, IX_EQUAL_ZERO};
    }
}

static void clear(work *w)
{
    for (int i = 0; i < w->neq; i++)
        ix_mv_unref(w->ctx, w->f[i]);
}

static void row(work *w, void (*fn)(void *), const char *name)
{
    fn(w);
    ix_bench(name, fn, w, w->boxes ? (double)w->boxes : 1,
             w->boxes ? "box" : "polynomial");
    clear(w);
    w->boxes = 0;
}

/* Two circles of the unit square: apart by dx, dx = 0.5 touching. */
static void circles(work *w, double dx)
{
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 3, .length = 3},
                         {.basis = IX_BEZIER, .order = 3, .length = 3}};

    w->neq = 2;
    for (int i = 0; i < 2; i++) {
        double p[9], x = 0.26 + i * dx, y = 0.51, r = 0.25;
        double cx[3] = {x * x, x * x - x, (1 - x) * (1 - x)};
        double cy[3] = {y * y, y * y - y, (1 - y) * (1 - y)};

        for (int k = 0; k < 9; k++)
            p[k] = cx[k % 3] + cy[k / 3] - r * r;
        ix_bench_ok(w->ctx, ix_mv_new(w->ctx, 2, d, 1, false, p, &w->f[i]));
        w->eq[i] = (ix_equation){w->f[i], 0, IX_EQUAL_ZERO};
    }
}

int main(void)
{
    static const int degrees[] = {3, 6, 12, 24, 48};
    work w = {.ctx = ix_ctx_new(NULL, NULL)};
    char name[80];

    if (!w.ctx)
        return 1;
    for (size_t i = 0; i < sizeof degrees / sizeof *degrees; i++) {
        snprintf(name, sizeof name, "roots, degree %d", degrees[i]);
        set(&w, 1, 1, degrees[i], 0.7);
        row(&w, roots, name);
    }
    circles(&w, 0.2);
    row(&w, system_of, "two circles, 2 solutions");
    circles(&w, 0.5);
    row(&w, system_of, "two circles that touch");
    for (int d = 2; d <= 6; d++) {
        snprintf(name, sizeof name, "2 equations of degree %d, 2 unknowns", d);
        set(&w, 2, 2, d, 0.7);
        row(&w, system_of, name);
    }
    set(&w, 3, 3, 2, 0.7);
    row(&w, system_of, "3 equations of degree 2, 3 unknowns");
    set(&w, 3, 3, 3, 0.7);
    row(&w, system_of, "3 equations of degree 3, 3 unknowns");
    set(&w, 1, 2, 3, 0.7);
    row(&w, curves, "curve of degree 3 x 3");
    set(&w, 1, 2, 8, 0.7);
    row(&w, curves, "curve of degree 8 x 8");
    set(&w, 2, 3, 2, 0.7);
    row(&w, curves, "curve of 2 equations, 3 unknowns");
    ix_ctx_free(w.ctx);
    return 0;
}
