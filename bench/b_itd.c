/* b_itd.c - text files: reading and writing control points, small objects,
 * and what a box costs. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>

#include "io/gz.h"
#include "io/input.h"

#define SIDE 200 /* a surface of SIDE x SIDE rational points */

typedef struct {
    ix_ctx *ctx;
    ix_obj *o;
    ix_buf text, other;
    const char *format;
} bench;

static ix_obj *surface(ix_ctx *ctx, double scale)
{
    const ix_dir dirs[2] = {{IX_BEZIER, SIDE, SIDE, false, NULL},
                            {IX_BEZIER, SIDE, SIDE, false, NULL}};
    double *pts = calloc(4 * SIDE * SIDE, sizeof *pts);
    ix_mv *m = NULL;

    if (!pts)
        exit(1);
    for (int i = 0; i < 4 * SIDE * SIDE; i++)
        pts[i] = 1.5 + sin(i);
    for (int i = 0; scale != 0 && i < 4 * SIDE * SIDE; i++)
        pts[i] = round(pts[i] * scale) / scale;
    ix_bench_ok(ctx, ix_mv_new(ctx, 2, dirs, 3, true, pts, &m));
    free(pts);
    return ix__obj_mv(ctx, IX_OBJ_SURFACE, m);
}

static ix_obj *numbers(ix_ctx *ctx, int n)
{
    ix_obj *l = ix__obj_list(ctx);

    for (int i = 0; i < n; i++) {
        ix_obj *o = ix__obj_number(ctx, i);

        ix_bench_ok(ctx, ix__obj_append(ctx, l, o));
        ix__obj_unref(ctx, o);
    }
    return l;
}

static void write_text(void *arg)
{
    bench *b = arg;
    const ix_write_opts w = {.float_format = b->format, .file = true};

    ix__buf_clear(&b->text);
    ix_bench_ok(b->ctx, ix__itd_write(&b->text, b->o, &w, 0));
}

static void read_text(void *arg)
{
    bench *b = arg;
    ix_obj *o;

    ix_bench_ok(b->ctx,
                ix__itd_read(b->ctx, "bench", b->text.data, b->text.len, &o));
    ix__obj_unref(b->ctx, o);
}

static ix_status to_buf(void *arg, const char *s, size_t n)
{
    ix__buf_add(arg, s, n);
    return ix__buf_check(arg);
}

static void pack(void *arg)
{
    bench *b = arg;
    ix__gzip *g;

    ix__buf_clear(&b->other);
    ix_bench_ok(b->ctx, ix__gzip_open(b->ctx, to_buf, &b->other, &g));
    ix_bench_ok(b->ctx, ix__gzip_put(g, b->text.data, b->text.len));
    ix_bench_ok(b->ctx, ix__gzip_finish(g));
    ix__gzip_close(g);
}

static void unpack(void *arg)
{
    static char piece[1 << 16];
    bench *b = arg;
    ix__input *s;
    size_t n;

    ix_bench_ok(b->ctx, ix__input_memory(b->ctx, "bench", b->other.data,
                                         b->other.len, 0, &s));
    do
        ix_bench_ok(b->ctx, ix__input_read(s, piece, sizeof piece, &n));
    while (n == sizeof piece);
    ix__input_close(s);
}

static void make_number(void *arg)
{
    bench *b = arg;

    ix__obj_unref(b->ctx, ix__obj_number(b->ctx, 1));
}

static void transform(void *arg)
{
    static const double turn[16] = {0, 1, 0, 0, -1, 0, 0, 0,
                                    0, 0, 1, 0, 1,  2, 3, 1};
    bench *b = arg;
    ix_obj *o;

    ix_bench_ok(b->ctx, ix__obj_transform(b->ctx, b->o, turn, &o));
    ix__obj_unref(b->ctx, o);
}

/* Rows of an object written and read; the unit is a byte of text. */
static void rows(bench *b, const char *writing, const char *reading)
{
    write_text(b);
    ix_bench(writing, write_text, b, (double)b->text.len, "byte");
    ix_bench(reading, read_text, b, (double)b->text.len, "byte");
}

int main(void)
{
    bench b = {.ctx = ix_ctx_new(NULL, NULL)};

    ix__buf_init(&b.text, b.ctx);
    ix__buf_init(&b.other, b.ctx);
    ix_bench("number box, make and drop", make_number, &b, 1, "box");
    b.o = surface(b.ctx, 0);
    rows(&b, "itd write, 160 k random doubles",
         "itd read, 160 k random "
         "doubles");
    b.format = "%-16.14lg";
    rows(&b, "itd write, the same as %-16.14lg",
         "itd read, the same as "
         "%-16.14lg");
    b.format = NULL;
    pack(&b);
    ix_bench("gzip, text of the surface", pack, &b, (double)b.text.len, "byte");
    ix_bench("gunzip, text of the surface", unpack, &b, (double)b.text.len,
             "byte");
    ix_bench("transform, 40 k points", transform, &b, SIDE * SIDE, "point");
    ix__obj_unref(b.ctx, b.o);
    b.o = surface(b.ctx, 1000);
    rows(&b, "itd write, 160 k short decimals",
         "itd read, 160 k short "
         "decimals");
    ix__obj_unref(b.ctx, b.o);
    b.o = numbers(b.ctx, 10000);
    rows(&b, "itd write, list of 10 k numbers",
         "itd read, list of 10 k "
         "numbers");
    ix__obj_unref(b.ctx, b.o);
    ix__buf_free(&b.text);
    ix__buf_free(&b.other);
    ix_ctx_free(b.ctx);
    return 0;
}
