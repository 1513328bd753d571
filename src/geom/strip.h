/* strip.h - a ruled strip between two curves over one domain, and the points of
 * it nearest to given ones. */
#ifndef GEOM_STRIP_H
#define GEOM_STRIP_H

#include "geom/path.h"

typedef struct {
    ix_path side[2];
    int n; /* sample rulings */
    double *t, (*end)[2][3];
    double *work; /* [n] */
} ix__strip;

/* In scratch; the curves have one domain. Err IX_EARG, IX_EDOMAIN as paths. */
ix_status ix__strip_new(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                        ix__strip *out) IX_MUST_CHECK;

/* A place on the strip: parameter t of both curves, fraction x of the way from
 * the first to the second; its squared distance from the point asked for; unit
 * vectors, perpendicular to each other, along which it can move. */
typedef struct {
    double t, x, dist2;
    int nfree;
    double free[2][3];
} ix__strip_foot;

/* Where a place may be: parameters and fractions from lo to hi. */
typedef struct {
    double t[2], x[2];
} ix__strip_range;

/* The place in range nearest to p that is found downhill from parameter t. */
void ix__strip_nearest_from(const ix__strip *s, const double p[3], double t,
                            const ix__strip_range *in, ix__strip_foot *out);
/* The nearest of those found from all sample rulings that are nearer to p than
 * their neighbours. */
void ix__strip_nearest(const ix__strip *s, const double p[3],
                       const ix__strip_range *in, ix__strip_foot *out);

#endif
