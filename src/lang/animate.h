/* animate.h - objects at a time of their animation. */
#ifndef LANG_ANIMATE_H
#define LANG_ANIMATE_H

#include "object/object.h"

/* The attribute "animation" of an object holds a list (or one object):
 * matrices, and scalar curves by their names. MOV_X, MOV_Y, MOV_Z translate,
 * ROT_X, ROT_Y, ROT_Z rotate (degrees), SCL, SCL_X, SCL_Y, SCL_Z scale; the
 * curve MOV_XYZ translates by its three coordinates. They are applied in the
 * order of the list. VISIBLE: the object is there while the value is positive.
 * Times outside of a curve's domain count as its nearer end.
 *
 * In a list each element's own animation comes first, then the list's. The
 * result has no attribute "animation" any more.
 * matrices: instead of the objects, the same hierarchy of matrices.
 * Objects that are not visible are left out of lists; alone they become an
 * empty list. Out: a new reference. Err IX_EARG an animation that is none;
 * IX_EUNABLE nested too deeply. */
ix_status ix__animate(ix_ctx *ctx, const ix_obj *o, double t, bool matrices,
                      ix_obj **out) IX_MUST_CHECK;

#endif
