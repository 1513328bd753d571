/* time.h - timing of a task as bench.h does it, for C and C++ programs that
 * know nothing of iritx. */
#ifndef BENCH_PEERS_TIME_H
#define BENCH_PEERS_TIME_H

#include <stdio.h>
#include <time.h>

static inline double peer_clock(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

/* Prints task, nanoseconds and what fn(arg) returned: the best of 7 rounds of
 * at least 10 ms, of one if a call takes more than a second. */
static inline void peer_row(const char *task, int n, double (*fn)(void *),
                            void *arg)
{
    double start = peer_clock(), answer = fn(arg), ns = peer_clock() - start;
    double best = ns;
    long calls = ns < 1e7 ? (long)(1e7 / ns) + 1 : 1;

    for (int round = 0; round < 7 && ns < 1e9; round++) {
        start = peer_clock();
        for (long i = 0; i < calls; i++)
            answer = fn(arg);
        ns = (peer_clock() - start) / (double)calls;
        best = ns < best ? ns : best;
    }
    printf("%s, n = %d\t%.6g\t%.6g\n", task, n, best, answer);
    fflush(stdout);
}

#endif
