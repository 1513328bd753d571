/* contour_cone.h - parts of curves on a surface by the surface's normals. */
#ifndef LANG_CONTOUR_CONE_H
#define LANG_CONTOUR_CONE_H

#include "iritx/solve.h"
#include "lang/builtin.h"

/* Normals of the surface on that make at most an angle with a direction. */
typedef struct {
    const ix_mv *on;
    double dir[3], cosine;
} ix__cone;

/* Argument i, list(direction, degrees). */
ix_status ix__arg_cone(ix_call *c, int i, const ix_mv *on,
                       ix__cone *out) IX_MUST_CHECK;

/* Those parts of curves (u, v) that lie on the surface where its normals are in
 * the cone, as polylines on it; where they leave it is found between two points
 * of the curve. No value if there are none. */
ix_status ix__ret_in_cone(ix_call *c, const ix_solution_curves *s,
                          const ix__cone *k) IX_MUST_CHECK;

#endif
