/* script.h - timing calls from scripts: "r = CALL" in a loop of SCRIPT_CALLS.
 */
#ifndef BENCH_SCRIPT_H
#define BENCH_SCRIPT_H

#include "bench.h"

#include <string.h>

#include "lang/interp.h"

#define SCRIPT_CALLS 20

typedef struct {
    ix_ctx *ctx;
    ix_interp *in;
    char text[200];
} script_bench;

static inline void script_run(script_bench *b, const char *text)
{
    ix_bench_ok(b->ctx,
                ix__interp_run_text(b->in, "bench", text, strlen(text)));
}

static inline void script_loop(void *arg)
{
    script_bench *b = arg;

    script_run(b, b->text);
}

/* Ends the program if there is no memory. One thread. */
static inline script_bench script_begin(void)
{
    static const ix_interp_opts quiet = {.quiet = true};
    script_bench b = {.ctx = ix_ctx_new(NULL, NULL)};

    if (!b.ctx)
        exit(1);
    ix_ctx_set_threads(b.ctx, 1);
    ix_bench_ok(b.ctx, ix__interp_new(b.ctx, &quiet, &b.in));
    return b;
}

static inline void script_end(script_bench *b)
{
    ix__interp_free(b->in);
    ix_ctx_free(b->ctx);
}

/* Nanoseconds per call. */
static inline double script_time(script_bench *b, const char *name,
                                 const char *call)
{
    snprintf(b->text, sizeof b->text, "for (ii = 1, 1, %d, r = %s);",
             SCRIPT_CALLS, call);
    return ix_bench(name, script_loop, b, SCRIPT_CALLS, "call");
}

#endif
