/* release_impl.h - dropping references without recursion.
 *
 * A box whose last reference goes is put on a list of dead boxes; only
 * ix__obj_release_dead takes boxes from it. So neither deep lists nor object
 * attributes of object attributes use the C stack. */
#ifndef OBJECT_RELEASE_IMPL_H
#define OBJECT_RELEASE_IMPL_H

#include "object/object.h"

/* Drops one reference to o (may be NULL); its last puts it on *dead. */
void ix__obj_drop(ix_ctx *ctx, ix_obj *o, ix_obj **dead);
void ix__attr_drop_all(ix_ctx *ctx, ix_attr **list, ix_obj **dead);
void ix__poly_drop(ix_ctx *ctx, const ix_poly *p, ix_obj **dead);
/* Releases all boxes of the list and all that die with them. */
void ix__obj_release_dead(ix_ctx *ctx, ix_obj *dead);

/* Counts and marks are no part of a value: they change behind const. */
#define IX_MUTABLE(type, p) ((type *)(uintptr_t)(p))

#endif
