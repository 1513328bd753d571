/* steady.h - planes that lines along a curve are not parallel to. */
#ifndef OPS_STEADY_H
#define OPS_STEADY_H

#include "sym/form.h"

/* A unit vector n to which the directions v(t), three rows, stay as far from a
 * right angle as possible: the mean of up to 64 of them in range (their signs
 * do not count), or one of them. The result is the least |cosine| that was
 * seen; (0, 0, 1) and 1 if all of them vanish. */
double ix__steady_normal(const ix_form *v, const double range[2], double n[3]);

#endif
