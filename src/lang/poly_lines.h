/* poly_lines.h - lines on polygons: where a plane meets them, and what
 * separates those that face a direction from the others. */
#ifndef LANG_POLY_LINES_H
#define LANG_POLY_LINES_H

#include "lang/builtin.h"

/* Polylines in which polygons meet the plane (points, of polylines). Vertices
 * on it count as above it. No value if there are none. */
ix_status ix__ret_poly_contour(ix_call *c, const ix_poly *p,
                               const double plane[4]) IX_MUST_CHECK;

/* Polylines of edges between a polygon whose normal makes an acute angle with
 * the view and one whose does not; polygons have edges in common where both
 * vertices agree to about 1e-9 of the extent. No value if there are none. */
ix_status ix__ret_poly_silhouette(ix_call *c, const ix_poly *p,
                                  const double view[3]) IX_MUST_CHECK;

#endif
