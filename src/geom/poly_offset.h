/* poly_offset.h - planar polylines and polygons at a distance. */
#ifndef GEOM_POLY_OFFSET_H
#define GEOM_POLY_OFFSET_H

#include "base/ctx.h"

/* What is put in on the outer side of a corner; on the inner side the moved
 * edges meet, if they are long enough for it. */
typedef enum {
    IX__JOIN_BEVEL, /* the straight line between the ends of the edges */
    IX__JOIN_MITRE, /* the edges go on until they meet; a bevel if that is
                       farther than 4 distances away */
    IX__JOIN_ROUND  /* points of the circle around the corner, every 10 degrees
                       or closer */
} ix__join;

/* Every edge of p[n] moved by d to its right, seen from the side to which the
 * unit vector up points; neighbours joined. Edges of length 0 are left out.
 * Loops where d is larger than there is room for are not cut out.
 *
 * In    closed  the last vertex is joined with the first
 * Out   *out    scratch, *m vertices
 * Err   IX_EDOMAIN  all vertices are one */
ix_status ix__polyline_offset(ix_ctx *ctx, int n, const double (*p)[3],
                              bool closed, const double up[3], double d,
                              ix__join join, int *m,
                              double (**out)[3]) IX_MUST_CHECK;

#endif
