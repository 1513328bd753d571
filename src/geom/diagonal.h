/* diagonal.h - pairs of points of one surface, without the pairs of a point
 * with itself.
 *
 * P - Q = 0 and everything built on it holds where P and Q are one point of the
 * surface: on the diagonal of a patch taken twice, along the common edge of two
 * patches. With divided differences the chord is
 *
 *   P - Q = (u - s) A + (v - t) B,
 *
 * so that, off the diagonal, P = Q needs A and B to be parallel, which on the
 * diagonal, where they are the partial derivatives, a regular surface excludes:
 * A x B = 0 is the relation that removes it. Beside a common edge, at distances
 * a of P and b of Q from it, the chord is a A1 - b A2 + (v - t) B; blown up,
 * (a, b) = (s, s m) or (s m, s) with m in [0, 1], A becomes A1 - m A2.
 * All of it is exact in Bernstein form. */
#ifndef GEOM_DIAGONAL_H
#define GEOM_DIAGONAL_H

#include "geom/vecs.h"

/* How the two patches lie. */
typedef enum {
    IX__PAIR_SAME,  /* one patch, unknowns (u, s, v, t) */
    IX__PAIR_EDGE,  /* a common edge, unknowns (s, m, v, t) */
    IX__PAIR_APART, /* nothing, or a corner, in common: (u, s, v, t) */
    IX__PAIR_KINDS
} ix__pair_kind;

/* Points and tangents of both, in the four unknowns, and the vector that
 * vanishes for true pairs (all NULL for IX__PAIR_APART). */
typedef struct {
    ix__vec p, q, tp[2], tq[2], off;
} ix__pair;

/* From Bezier surfaces of orders 2 and more. For IX__PAIR_EDGE both are
 * measured from the common edge, which is u = 0 of either; q is the one at
 * s m. */
void ix__pair_make(ix_pool *q, ix__pair_kind kind, const ix_mv *a,
                   const ix_mv *b, ix__pair *out);

#endif
