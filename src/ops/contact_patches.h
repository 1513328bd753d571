/* contact_patches.h - the lines of contact of a whole surface, patch by patch.
 *
 * The equations of line_contact.h are made for every Bezier patch, a little
 * enlarged on all sides: curves along knots and seams, where symmetric surfaces
 * like to have them, would lie on the boundary of the solver's domain
 * otherwise, where they are singular. What is outside of the patch is cut off
 * again. */
#ifndef OPS_CONTACT_PATCHES_H
#define OPS_CONTACT_PATCHES_H

#include "iritx/solve.h"
#include "mv/mv.h"

/* Curves of contact of order 3 as ix_srf_flecnodal says. turn: how far, on the
 * unit sphere, directions in space may be from the chords between vertices; 0:
 * no matter. */
ix_status ix__contact_curves(ix_ctx *ctx, const ix_mv *s, double tol,
                             double turn,
                             ix_solution_curves *out) IX_MUST_CHECK;
/* Points of contact of order 4 as ix_srf_flecnodal_points says. */
ix_status ix__contact_points(ix_ctx *ctx, const ix_mv *s,
                             ix_solutions *out) IX_MUST_CHECK;

#endif
