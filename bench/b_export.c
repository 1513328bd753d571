/* b_export.c - tessellation within a tolerance, and files for other programs:
 * a rational surface with many patches. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>

#include "io/export.h"
#include "io/faces.h"
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

/* A bicubic patch, whole or with a hole in it. */
typedef struct {
    ix_ctx *ctx;
    ix__face face;
    double tol;
    size_t ntris;
} patch;

static ix_mv *bicubic(ix_ctx *ctx)
{
    const ix_dir dir[2] = {{IX_BEZIER, 4, 4, false, NULL},
                           {IX_BEZIER, 4, 4, false, NULL}};
    double pts[48];
    ix_mv *m = NULL;

    for (int k = 0; k < 16; k++) {
        pts[k] = k % 4;
        pts[16 + k] = k / 4;
        pts[32 + k] = cos(5 * k);
    }
    ix_bench_ok(ctx, ix_mv_new(ctx, 2, dir, 3, false, pts, &m));
    return m;
}

/* A closed curve about (x, x), as a loop of one curve. */
static ix_mv *ring(ix_ctx *ctx, int order, int n, double x, double r)
{
    double knots[16], pts[24];
    const ix_dir dir = {IX_BSPLINE, order, n, false, knots};
    ix_mv *m = NULL;

    ix_bench_ok(ctx, ix_knots_make(ctx, IX_KV_OPEN, order, n, knots));
    for (int i = 0; i < n; i++) {
        double a = 2 * acos(-1.) * (i % (n - 1)) / (n - 1);

        pts[i] = x + r * cos(a);
        pts[n + i] = x + r * sin(a);
    }
    ix_bench_ok(ctx, ix_mv_new(ctx, 1, &dir, 2, false, pts, &m));
    return m;
}

static void mesh_face(void *arg)
{
    patch *p = arg;
    ix_mark mk = ix__scratch_mark(p->ctx);
    ix__mesh *m;

    ix_bench_ok(p->ctx,
                ix__mesh_of_faces(p->ctx, 1, &p->face, p->tol, NULL, &m));
    p->ntris = m->ntris;
    ix__mesh_free(p->ctx, m);
    ix__scratch_release(p->ctx, mk);
}

static void patch_rows(ix_ctx *ctx)
{
    ix_mv *outer = ring(ctx, 4, 9, .5, .5), *hole = ring(ctx, 4, 9, .5, .3);
    ix__face_curve curve[2] = {{.uv = outer, .edge = -1},
                               {.uv = hole, .edge = -1}};
    ix__face_loop loop[2] = {{1, &curve[0]}, {1, &curve[1]}};
    ix_mv *srf = bicubic(ctx);
    patch p = {.ctx = ctx, .face = {.srf = srf}, .tol = 1e-4};

    mesh_face(&p);
    ix_bench("tessellate a bicubic patch, tolerance 1e-4", mesh_face, &p,
             (double)p.ntris, "triangle");
    p.face.nloops = 2;
    p.face.loop = loop;
    mesh_face(&p);
    ix_bench("the same, trimmed by two loops", mesh_face, &p, (double)p.ntris,
             "triangle");
    ix_mv_unref(ctx, srf);
    ix_mv_unref(ctx, outer);
    ix_mv_unref(ctx, hole);
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
    patch_rows(b.ctx);
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
