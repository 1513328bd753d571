/* b_export.c - tessellation within a tolerance, and files for other programs:
 * a rational surface with many patches. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>

#include "io/export.h"
#include "mv/tessellate.h"

enum { SIDE = 12, ORDER = 4 };

typedef struct {
    ix_ctx *ctx;
    ix_mv *srf;
    ix_obj *o;
    ix_buf text;
    double tol;
    size_t ntris;
    ix_status (*write)(ix_buf *, const ix_obj *, const ix_write_opts *);
} bench;

static ix_mv *surface(ix_ctx *ctx)
{
    double knots[SIDE + ORDER], pts[4 * SIDE * SIDE];
    const ix_dir dir = {IX_BSPLINE, ORDER, SIDE, false, knots};
    const ix_dir dirs[2] = {dir, dir};
    ix_mv *m = NULL;

    ix_bench_ok(ctx, ix_knots_make(ctx, IX_KV_OPEN, ORDER, SIDE, knots));
    for (int k = 0; k < SIDE * SIDE; k++) {
        double w = 1.5 + sin(k);

        pts[k] = w;
        pts[SIDE * SIDE + k] = w * (k % SIDE);
        pts[2 * SIDE * SIDE + k] = w * (k / SIDE);
        pts[3 * SIDE * SIDE + k] = w * cos(3 * k);
    }
    ix_bench_ok(ctx, ix_mv_new(ctx, 2, dirs, 3, true, pts, &m));
    return m;
}

static void mesh(void *arg)
{
    bench *b = arg;
    ix__mesh m;

    ix_bench_ok(b->ctx, ix__mesh_of_srf(b->ctx, b->srf, b->tol, &m));
    b->ntris = m.ntris;
    ix__mesh_free(b->ctx, &m);
}

static void write_file(void *arg)
{
    bench *b = arg;
    const ix_write_opts w = {.tol = b->tol};

    ix__buf_clear(&b->text);
    ix_bench_ok(b->ctx, b->write(&b->text, b->o, &w));
}

static void file_row(bench *b, const char *name)
{
    write_file(b);
    ix_bench(name, write_file, b, (double)b->text.len, "byte");
}

int main(void)
{
    bench b = {.ctx = ix_ctx_new(NULL, NULL)};

    b.srf = surface(b.ctx);
    b.o = ix__obj_mv(b.ctx, IX_OBJ_SURFACE, ix_mv_ref(b.srf));
    ix__buf_init(&b.text, b.ctx);
    b.tol = .1;
    mesh(&b);
    ix_bench("tessellate, tolerance 1e-1", mesh, &b, (double)b.ntris,
             "triangle");
    b.tol = .01;
    mesh(&b);
    ix_bench("tessellate, tolerance 1e-2", mesh, &b, (double)b.ntris,
             "triangle");
    b.tol = .1;
    b.write = ix__stl_write;
    file_row(&b, "stl, text");
    b.write = ix__bstl_write;
    file_row(&b, "stl, binary");
    b.write = ix__obj_file_write;
    file_row(&b, "obj");
    b.write = ix__step_write;
    file_row(&b, "step");
    ix__buf_free(&b.text);
    ix__obj_unref(b.ctx, b.o);
    ix_mv_unref(b.ctx, b.srf);
    ix_ctx_free(b.ctx);
    return 0;
}
