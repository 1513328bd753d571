/* read_rules.h - what all readers make of planes, normals and weights. */
#ifndef IO_READ_RULES_H
#define IO_READ_RULES_H

#include "object/object.h"

/* Divides v[n] by the length of its first three; false if that is 0 or the
 * quotients overflow. A length of 1 up to rounding is left alone, so that
 * writing and reading keep bits. */
bool ix__poly_unit(double *v, int n);
/* A polygon without a plane gets it from its vertices, and vertices without a
 * normal get the plane's. */
void ix__poly_complete(ix_polygon *pg);
/* The least and the greatest weight: legal, but operators may refuse, if they
 * have both signs (true): the curve goes through infinity. False also with a
 * power basis, whose weights are coefficients and whose signs say nothing. */
bool ix__signs_change(const ix_mv *m, double range[2]);

#endif
