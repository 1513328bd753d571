/* b_interp.c - what the interpreter itself costs: loop rounds, calls of
 * built-ins and of user functions, parsing, starting. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <string.h>

#include "lang/interp.h"

#define ROUNDS 100000

typedef struct {
    ix_ctx *ctx;
    ix_interp *in;
    const char *text;
} bench;

static void run_text(void *arg)
{
    bench *b = arg;

    ix_bench_ok(b->ctx,
                ix__interp_run_text(b->in, "bench", b->text, strlen(b->text)));
}

static void start(void *arg)
{
    static const ix_interp_opts none;
    bench *b = arg;
    ix_interp *in;

    ix_bench_ok(b->ctx, ix__interp_new(b->ctx, &none, &in));
    ix__interp_free(in);
}

int main(void)
{
    static const ix_interp_opts none;
    static const struct {
        const char *name, *text;
        double n; /* so often happens ... */
        const char *unit;
    } rows[] = {
        {"x = 1", "for (i = 1, 1, 100000, x = 1)", ROUNDS, "round"},
        {"x = i * 2 + 1", "for (i = 1, 1, 100000, x = i * 2 + 1)", ROUNDS,
         "round"},
        {"c = atan2(a, b)", "for (i = 1, 1, 100000, c = atan2(a, b))", ROUNDS,
         "round"},
        {"v = coerce(p, VECTOR_TYPE)",
         "for (i = 1, 1, 100000, v = coerce(p, vector_type))", ROUNDS, "round"},
        {"x = f(i), f(n) = n + 1", "for (i = 1, 1, 100000, x = f(i))", ROUNDS,
         "round"},
        {"fib(20)", "x = fib(20)", 21891, "call"},
        {"parsing and running b = 2",
         "b = 2; b = 2; b = 2; b = 2; b = 2; b = 2; b = 2; b = 2; b = 2; b = 2",
         10, "statement"},
    };
    bench b = {.ctx = ix_ctx_new(NULL, NULL)};

    if (!b.ctx)
        return 1;
    ix_bench_ok(b.ctx, ix__interp_new(b.ctx, &none, &b.in));
    b.text =
        "a = 2; b = 3; p = point(1, 2, 3); f = function(n): return = n + 1; "
        "fib = function(n): return = n; fib = function(n): if (n < 2, "
        "return = n, return = fib(n - 1) + fib(n - 2))";
    run_text(&b);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        b.text = rows[i].text;
        ix_bench(rows[i].name, run_text, &b, rows[i].n, rows[i].unit);
    }
    ix_bench("starting an interpreter", start, &b, 1, "start");
    ix__interp_free(b.in);
    ix_ctx_free(b.ctx);
    return 0;
}
