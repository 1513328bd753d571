/* bench.h - timing of one operation: the best of several rounds, each long
 * enough for the clock. A benchmark is a program bench/b_<name>.c that calls
 * ix_bench for each row of the table; bench/run prints the table. */
#ifndef BENCH_BENCH_H
#define BENCH_BENCH_H

#ifndef _POSIX_C_SOURCE
#error "start the file with: #define _POSIX_C_SOURCE 200809L"
#endif

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "iritx/base.h"

#define IX_BENCH_ROUNDS   7
#define IX_BENCH_ROUND_NS 1e7

static inline double ix_bench_clock(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

/* Ends the program if a step of a benchmark failed. */
static inline void ix_bench_ok(ix_ctx *ctx, ix_status st)
{
    if (st == IX_OK)
        return;
    fprintf(stderr, "%s: %s\n", ix_status_name(st), ix_ctx_message(ctx));
    exit(1);
}

static inline double ix_bench_round(void (*fn)(void *), void *arg, long n)
{
    double start = ix_bench_clock();

    for (long i = 0; i < n; i++)
        fn(arg);
    return ix_bench_clock() - start;
}

/* Times fn(arg), which makes or handles `units` things of the given name
 * ("control point", "span", "byte"; in the singular), and prints the row.
 * Returns nanoseconds per call. */
static inline double ix_bench(const char *name, void (*fn)(void *), void *arg,
                              double units, const char *unit)
{
    double best, ns = ix_bench_round(fn, arg, 1); /* and warms the caches */
    long n = 1;

    while (ns < IX_BENCH_ROUND_NS && n < 1L << 40) {
        n *= 2;
        ns = ix_bench_round(fn, arg, n);
    }
    best = ns / (double)n;
    for (int i = 1; i < IX_BENCH_ROUNDS; i++) {
        ns = ix_bench_round(fn, arg, n) / (double)n;
        best = ns < best ? ns : best;
    }
    printf("%s\t%.6g\t%.6g\t%s\n", name, best, units, unit);
    fflush(stdout);
    return best;
}

#endif
