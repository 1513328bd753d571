/* b_num.c - numbers as text: what loading and saving large files costs. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <math.h>

#include "base/numfmt.h"

#define N 10000

typedef struct {
    double v[N];
    char text[N * IX_NUM_MAX];
    size_t len;
    double sum;
    ix_buf out;
    ix_numfmt format;
} numbers;

static void write_shortest(void *arg)
{
    numbers *d = arg;
    char *p = d->text;

    for (int i = 0; i < N; i++) {
        p += ix_num_format(d->v[i], p);
        *p++ = ' ';
    }
    d->len = (size_t)(p - d->text);
}

static void read_all(void *arg)
{
    numbers *d = arg;
    const char *p = d->text, *end = p + d->len;
    double v = 0;

    d->sum = 0;
    while (p && p < end) {
        p = ix_num_parse(p, end, &v);
        d->sum += v;
        p = p ? p + 1 : NULL;
    }
}

static void write_formatted(void *arg)
{
    numbers *d = arg;

    ix__buf_clear(&d->out);
    for (int i = 0; i < N; i++)
        ix__numfmt_put(&d->out, &d->format, d->v[i]);
}

static void run(numbers *d, const char *kind)
{
    char name[64];

    write_shortest(d);
    snprintf(name, sizeof name, "num write, %s", kind);
    ix_bench(name, write_shortest, d, (double)d->len, "byte");
    snprintf(name, sizeof name, "num read, %s", kind);
    ix_bench(name, read_all, d, (double)d->len, "byte");
    snprintf(name, sizeof name, "num write %%-16.14lg, %s", kind);
    ix_bench(name, write_formatted, d, (double)d->len, "byte");
}

int main(void)
{
    static numbers d;
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    if (!ctx || !ix__numfmt_parse("%-16.14lg", &d.format))
        return 1;
    ix__buf_init(&d.out, ctx);
    for (int i = 0; i < N; i++)
        d.v[i] = 20 * sin(i + 0.1);
    run(&d, "17 digits");
    for (int i = 0; i < N; i++)
        d.v[i] = (i * 7919 % 20000 - 10000) / 1e3;
    run(&d, "5 digits");
    ix__buf_free(&d.out);
    ix_ctx_free(ctx);
    return 0;
}
