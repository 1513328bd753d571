/* b_xml.c - XML files: writing and reading a large scene, memory for it, the
 * schema; the text format beside it. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>

#include "io/input.h"

#define SIDE   200   /* a surface of SIDE x SIDE rational points */
#define OBJECT 20000 /* numbers with a name and an attribute */

/* What the context has allocated, and the most of it. */
typedef struct {
    size_t live, peak;
} meter;

static void *metered(void *ud, void *p, size_t old_size, size_t size)
{
    meter *m = ud;

    if (size == 0) {
        m->live -= p ? old_size : 0;
        free(p);
        return NULL;
    }
    m->live += size - (p ? old_size : 0);
    m->peak = m->live > m->peak ? m->live : m->peak;
    return realloc(p, size);
}

typedef struct {
    ix_ctx *ctx;
    ix_obj *o;
    ix_buf text;
} bench;

static ix_obj *surface(ix_ctx *ctx)
{
    const ix_dir dirs[2] = {{IX_BEZIER, SIDE, SIDE, false, NULL},
                            {IX_BEZIER, SIDE, SIDE, false, NULL}};
    double *pts = calloc(4 * SIDE * SIDE, sizeof *pts);
    ix_mv *m = NULL;

    if (!pts)
        exit(1);
    for (int i = 0; i < 4 * SIDE * SIDE; i++)
        pts[i] = 1.5 + sin(i);
    ix_bench_ok(ctx, ix_mv_new(ctx, 2, dirs, 3, true, pts, &m));
    free(pts);
    return ix__obj_mv(ctx, IX_OBJ_SURFACE, m);
}

static ix_obj *small_objects(ix_ctx *ctx)
{
    ix_obj *l = ix__obj_list(ctx);

    for (int i = 0; i < OBJECT; i++) {
        ix_obj *o = ix__obj_number(ctx, i / 7.0);

        ix_bench_ok(ctx, ix__obj_set_name(ctx, o, "NUMBER"));
        ix_bench_ok(ctx, ix__attr_set_int(ctx, &o->attrs, "color", i % 16));
        ix_bench_ok(ctx, ix__obj_append(ctx, l, o));
        ix__obj_unref(ctx, o);
    }
    return l;
}

static void write_xml(void *arg)
{
    bench *b = arg;

    ix__buf_clear(&b->text);
    ix_bench_ok(b->ctx, ix__xml_write(&b->text, b->o));
}

static void read_xml(void *arg)
{
    bench *b = arg;
    ix_obj *o;

    ix_bench_ok(b->ctx,
                ix__xml_read(b->ctx, "bench", b->text.data, b->text.len, &o));
    ix__obj_unref(b->ctx, o);
}

static void validate_xml(void *arg)
{
    bench *b = arg;

    ix__input *s;

    ix_bench_ok(b->ctx, ix__input_memory(b->ctx, "bench", b->text.data,
                                         b->text.len, 0, &s));
    ix_bench_ok(b->ctx, ix__xml_validate(s));
    ix__input_close(s);
}

static void read_itd(void *arg)
{
    bench *b = arg;
    ix_obj *o;

    ix_bench_ok(b->ctx,
                ix__itd_read(b->ctx, "bench", b->text.data, b->text.len, &o));
    ix__obj_unref(b->ctx, o);
}

/* The most that reading takes beside the text, as a row without a time. */
static void memory_row(bench *b, meter *m, const char *name)
{
    size_t before = m->live;

    m->peak = m->live;
    read_xml(b);
    printf("# %s: %.1f MB of text, %.1f MB beside it while reading\n", name,
           1e-6 * (double)b->text.len, 1e-6 * (double)(m->peak - before));
}

static void rows(bench *b, meter *m, const char *what, const char *names[3])
{
    write_xml(b);
    memory_row(b, m, what);
    ix_bench(names[0], write_xml, b, (double)b->text.len, "byte");
    ix_bench(names[1], read_xml, b, (double)b->text.len, "byte");
    ix_bench(names[2], validate_xml, b, (double)b->text.len, "byte");
}

int main(void)
{
    static const char *points[] = {"xml write, 160 k random doubles",
                                   "xml read, 160 k random doubles",
                                   "xml validate, 160 k random doubles"};
    static const char *objects[] = {"xml write, 20 k small objects",
                                    "xml read, 20 k small objects",
                                    "xml validate, 20 k small objects"};
    const ix_write_opts exact = {.file = true};
    meter m = {0};
    bench b = {.ctx = ix_ctx_new(metered, &m)};

    ix__buf_init(&b.text, b.ctx);
    b.o = surface(b.ctx);
    rows(&b, &m, "a surface of 40 k points", points);
    ix__obj_unref(b.ctx, b.o);
    b.o = small_objects(b.ctx);
    rows(&b, &m, "a list of 20 k numbers", objects);
    ix__buf_clear(&b.text);
    ix_bench_ok(b.ctx, ix__itd_write(&b.text, b.o, &exact, 0));
    ix_bench("itd read, 20 k small objects", read_itd, &b, (double)b.text.len,
             "byte");
    ix__obj_unref(b.ctx, b.o);
    ix__buf_free(&b.text);
    ix_ctx_free(b.ctx);
    return 0;
}
