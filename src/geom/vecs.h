/* vecs.h - vectors of functions in formulas (pool.h): the numerators of up to
 * three coordinates and a weight. NULL stands for 0 in a coordinate, for 1 as
 * the weight, so that nothing is computed for missing ones. */
#ifndef GEOM_VECS_H
#define GEOM_VECS_H

#include "geom/pool.h"

typedef struct {
    const ix_mv *x[3], *w;
} ix__vec;

/* Scalars that may be NULL, which is 0. */
const ix_mv *ix__sum0(ix_pool *q, const ix_mv *a, const ix_mv *b);
const ix_mv *ix__diff0(ix_pool *q, const ix_mv *a, const ix_mv *b);
const ix_mv *ix__prod0(ix_pool *q, const ix_mv *a, const ix_mv *b);

/* The coordinates and the weight of a freeform of at most 3 coordinates. */
ix__vec ix__vec_of(ix_pool *q, const ix_mv *m);
/* The direction of the partial derivative: of the numerator x' w - x w', that
 * is without weight. */
ix__vec ix__vec_tangent(ix_pool *q, ix__vec a, int dir);
/* As functions of n parameters, their own from start on. */
ix__vec ix__vec_promote(ix_pool *q, ix__vec a, int n, int start);

/* The following take the numerators only, unless stated. */
ix__vec ix__vec_add(ix_pool *q, ix__vec a, ix__vec b);
ix__vec ix__vec_sub(ix_pool *q, ix__vec a, ix__vec b);
/* Each coordinate times s (NULL: 1). */
ix__vec ix__vec_times(ix_pool *q, ix__vec a, const ix_mv *s);
ix__vec ix__vec_cross(ix_pool *q, ix__vec a, ix__vec b);
const ix_mv *ix__vec_dot(ix_pool *q, ix__vec a, ix__vec b);
/* The third coordinate of the product, of vectors in the plane. */
const ix_mv *ix__vec_cross2(ix_pool *q, ix__vec a, ix__vec b);
/* a - b as points: the numerator x_a w_b - x_b w_a. */
ix__vec ix__vec_between(ix_pool *q, ix__vec a, ix__vec b);
/* A constant vector. */
const ix_mv *ix__vec_dot_const(ix_pool *q, ix__vec a, const double v[3]);

#endif
