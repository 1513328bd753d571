/* ruled_pieces.h - a surface as pieces that are nearly ruled, and ruled strips
 * laid flat. */
#ifndef GEOM_RULED_PIECES_H
#define GEOM_RULED_PIECES_H

#include "iritx/mv.h"

/* Cuts direction dir of a surface into pieces, each within eps (> 0) of the
 * ruled surface between its two end curves: bounds of control points, not
 * samples. cut[*n + 1] in scratch, the first and the last are the domain's.
 * Err IX_EARG not a Bezier or B-spline surface of at most 3 coordinates, eps;
 * IX_EDOMAIN poles; IX_EUNABLE more than 4096 pieces would be needed. */
ix_status ix__ruled_pieces(ix_ctx *ctx, const ix_mv *s, int dir, double eps,
                           int *n, double **cut) IX_MUST_CHECK;

/* The ruled surface between the curves of s at a and b of direction dir: u
 * along the curves, v from a to b. */
ix_status ix__ruled_piece(ix_ctx *ctx, const ix_mv *s, int dir, double a,
                          double b, ix_mv **out) IX_MUST_CHECK;

/* The strip of triangles p[i] q[i] p[i+1], q[i] q[i+1] p[i+1] between two rows
 * of n points, laid into the plane without change of lengths: p[0] at the
 * origin, q[0] up the y axis, the rest towards +x. A triangle without extent
 * keeps its two lengths only. */
void ix__strip_flat(int n, const double (*p)[3], const double (*q)[3],
                    double (*pf)[2], double (*qf)[2]);

#endif
