/* window.h - the points that count at one parameter, with their weights: what
 * values, derivatives and blossoms have in common. */
#ifndef MV_WINDOW_H
#define MV_WINDOW_H

#include "mv/mv.h"

typedef struct {
    const ix_mv *m;
    size_t stride[IX_MAX_DIRS];
    int first[IX_MAX_DIRS]; /* first point of the window, before wrapping */
    double *w[IX_MAX_DIRS]; /* weights of the window, [order]; unset */
    double total; /* what the products of the weights add up to: 1, 0 for a
                     derivative, NAN if that is not known (power basis) */
} ix__window;

/* Room for the weights, in scratch; total 1. */
ix_status ix__window_init(ix_ctx *ctx, const ix_mv *m,
                          ix__window *out) IX_MUST_CHECK;
/* The weighted sum of every axis: out[axes]. Constants stay exact. */
void ix__window_sum(const ix__window *win, double *out);

#endif
