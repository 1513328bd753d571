/* rand_obj.h - random objects of every type, for laws about objects, readers
 * and writers. What is made can be written and read back unchanged: numbers
 * are finite, normals are unit vectors, polygons have their plane. */
#ifndef HARNESS_RAND_OBJ_H
#define HARNESS_RAND_OBJ_H

#include "harness/test.h"
#include "object/object.h"

/* Any finite double: integers, ordinary ones, any bits. */
double ix_rand_double(ix_rng *r);
/* ndirs directions with random bases of one kind, orders, knots; weights are
 * positive. NULL if memory is short. */
ix_mv *ix_rand_mv(ix_ctx *ctx, ix_rng *r, int ndirs);
/* A value of that type; lists have up to 4 elements, depth levels deep. Names
 * and attributes are random, too. NULL if memory is short. */
ix_obj *ix_rand_obj_of(ix_ctx *ctx, ix_rng *r, ix_obj_type type, int depth);
/* Of any type but UNDEF. */
ix_obj *ix_rand_obj(ix_ctx *ctx, ix_rng *r, int depth);

#endif
