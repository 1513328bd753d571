/* recognize_obj.h - ISGEOM: the kind of geometry of an object as a list. */
#ifndef LANG_RECOGNIZE_OBJ_H
#define LANG_RECOGNIZE_OBJ_H

#include "object/object.h"

/* list(0), or list(flag, parameters ...) as geom/recognize.h describes them;
 * kind is a GEOM_ constant. Out: a new reference. Err IX_EARG not a single
 * curve or surface, no such kind. */
ix_status ix__recognize_obj(ix_ctx *ctx, const ix_obj *o, int kind, double eps,
                            ix_obj **out) IX_MUST_CHECK;

#endif
