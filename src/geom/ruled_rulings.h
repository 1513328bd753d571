/* ruled_rulings.h - which points of two opposite sides of a surface rulings
 * should join. */
#ifndef GEOM_RULED_RULINGS_H
#define GEOM_RULED_RULINGS_H

#include "mv/mv.h"

/* Rulings from S(t[k], v0) to S(r[k], v1), neither falling. */
typedef struct {
    int n;
    double *t, *r;
} ix__rulings;

/* Of all ways to join `samples` even places of the sides v = v0 and v = v1 of a
 * B-spline surface without crossing, that whose rulings are nearest to the
 * surface in the mean square; distances at `fine` - 1 points of each, taken
 * where the straight line of the parameters passes. Means over a quarter of the
 * places smooth the steps between them. The first slack places and
 * the last ones are beyond what is to be covered: rulings begin and end there.
 * In scratch. Err IX_EDOMAIN poles */
ix_status ix__rulings_find(ix_ctx *ctx, const ix_mv *s, int samples, int slack,
                           int fine, ix__rulings *out) IX_MUST_CHECK;

/* The parameter (t + r) / 2 of the ruling over (u, v), where v is the fraction
 * of the way from one side to the other. */
double ix__rulings_over(const ix__rulings *g, double u, double v);

#endif
