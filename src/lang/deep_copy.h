/* deep_copy.h - copies and walks that lists inside lists need.
 *
 * Lists share their elements, so one box can be met on very many paths; both
 * functions refuse objects that spread out to more than a million. */
#ifndef LANG_DEEP_COPY_H
#define LANG_DEEP_COPY_H

#include "object/object.h"

/* A copy that shares no box with o. Err IX_EUNABLE nested too deeply (256) or
 * too large. */
ix_status ix__deep_copy(ix_ctx *ctx, const ix_obj *o,
                        ix_obj **out) IX_MUST_CHECK;

/* The boxes in o that are no lists, in order, o itself if it is none: *n
 * borrowed pointers in scratch. Err as above. */
ix_status ix__leaves(ix_ctx *ctx, ix_obj *o, int *n,
                     ix_obj ***out) IX_MUST_CHECK;

#endif
