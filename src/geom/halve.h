/* halve.h - an interval cut into halves until each piece is good enough. */
#ifndef GEOM_HALVE_H
#define GEOM_HALVE_H

#include "iritx/mv.h"

#define IX__HALVINGS 12 /* at most */

/* How bad the piece [a, b] of direction dir of s is. */
typedef ix_status (*ix__gap_fn)(ix_ctx *ctx, const ix_mv *s, int dir, double a,
                                double b, double *gap);

typedef struct {
    ix__gap_fn gap;
    const ix_mv *s;
    int dir;
    double eps;       /* good enough */
    bool look_inside; /* the whole is halved at least once */
    const char *what; /* of the message: "the ruled surface" */
} ix__halving;

/* Ends of pieces over the domain of s, rising, both ends included: t[*n] in
 * scratch. Err IX_EUNABLE a piece of 2^-IX__HALVINGS is still too bad; what gap
 * says */
ix_status ix__halve(ix_ctx *ctx, const ix__halving *h, int *n,
                    double **t) IX_MUST_CHECK;

#endif
