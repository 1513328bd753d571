/* medial.h - points with the same geodesic distance from two curves.
 *
 * A point is x = (t1, t2, s), scaled, with F(x) = O2(b s, t2) - O1(a s, t1) = 0
 * for the sides a, b. In the orthonormal frame (dO1/ds, E) at O1, E across the
 * first geodesic, the columns of F's derivative are
 *
 *   t1: -y1 E      t2: y2 E2      s: b O2' - a O1'
 *
 * (Rausch et al. (4.3)), and the curve's tangent is the vector orthogonal to
 * both rows. Lengths of x are those of (|C1'| t1, |C2'| t2, s). */
#ifndef OPS_MEDIAL_H
#define OPS_MEDIAL_H

#include "ops/geo.h"

typedef struct {
    ix__geo *g;
    int side[2];
    int span[2];     /* of the borders: their group counts, see geo.h */
    double orient;   /* 1, -1: what makes t1 grow along the tangent; 0: not
                        known yet. Kept along a curve, also past focal points */
    double along;    /* 1, or -1: against that direction */
    ix_geo_stop why; /* the last point could not be evaluated */
} ix__medial;

typedef struct {
    ix__geo_shot shot[2];
    double f[2], j[2][3]; /* F and its derivatives, in the frame */
    double tangent[3];    /* of length 1 */
    bool regular;         /* there is a tangent */
} ix__medial_point;

/* *ok false: a geodesic ends early, m->why. */
ix_status ix__medial_eval(ix__medial *m, const double x[3],
                          ix__medial_point *out, bool *ok) IX_MUST_CHECK;

/* Newton's method: fixed -1 by steps of least length, else x[fixed] is kept.
 * *ok false: no convergence. */
ix_status ix__medial_newton(ix__medial *m, int fixed, double x[3],
                            ix__medial_point *at, bool *ok) IX_MUST_CHECK;

/* The span of t in the present group of border k. */
int ix__medial_span(const ix__medial *m, int k, double t);

/* Sets the spans to those of x; the piece on the side of growing (up) or
 * falling t at a break. */
void ix__medial_spans(ix__medial *m, const double x[3], bool up);

/* Starting points, scaled: x[n][3] with the sides that they are for. */
typedef struct {
    double x[3];
    int side[2];
    int fixed; /* 0, 1: found at an end of this border; -1: a meeting */
} ix__medial_seed;
typedef struct {
    int n, room;
    ix__medial_seed *at;
} ix__medial_seeds;
/* Where the borders meet, in both combinations of sides that differ. */
ix_status ix__medial_meetings(ix__medial *m,
                              ix__medial_seeds *out) IX_MUST_CHECK;
/* All points whose foot is an end of a border, s >= 0, for m->side. */
ix_status ix__medial_ends(ix__medial *m, ix__medial_seeds *out) IX_MUST_CHECK;
ix_status ix__medial_seed_add(ix__medial *m, ix__medial_seeds *out,
                              const double x[3], int fixed) IX_MUST_CHECK;

#endif
