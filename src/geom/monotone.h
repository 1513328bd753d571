/* monotone.h - the best way through a table of pairs, neither index falling:
 * dynamic programming. */
#ifndef GEOM_MONOTONE_H
#define GEOM_MONOTONE_H

#include "base/ctx.h"

/* What pair (i, j) is worth; -HUGE_VAL: it may not be used. */
typedef double (*ix__pair_fn)(const void *arg, int i, int j);

/* Ways from (0, 0) to (n-1, n-1); with slack they may begin at any pair of two
 * indices <= slack, and end at any pair of two >= n-1 - slack. */
typedef struct {
    ix__pair_fn value;
    const void *arg;
    int n, slack; /* 0 <= slack < n */
} ix__monotone;

/* The largest sum of values over the ways, -HUGE_VAL if there is none: a step
 * counts half of how far both indices advance together, with the mean of the
 * values at its ends; among equals steps of both are preferred. from[i n + j]
 * tells the step that leads to (i, j): 1 i, 2 j, 3 both, 0 none; from may be
 * NULL. work[4 n]; end[2] the last pair. */
double ix__monotone_best(const ix__monotone *m, double *work, char *from,
                         int end[2]);

/* The pairs of that way, in order: i[], j[], at most 2 n - 1; their number. */
int ix__monotone_trace(int n, const char *from, const int end[2], int *i,
                       int *j);

#endif
