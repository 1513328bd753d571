/* arclen.h - arc length as a function on a path, and its inverse. */
#ifndef GEOM_ARCLEN_H
#define GEOM_ARCLEN_H

#include "geom/path.h"

/* Length of the path between two parameters of one span (signed). */
double ix__span_length(const ix_path *p, int span, double a, double b);
/* Length between any two parameters of the domain, t0 <= t1. */
double ix__path_length(const ix_path *p, double t0, double t1);

/* The parameter in [t0, t1] at distance s >= 0 from t0 along the path. */
double ix__path_at_length(const ix_path *p, double t0, double t1, double s);

/* The parameter in [a, b] of one span at distance s from a along the path,
 * total being the distance from a to b; 0 <= s <= total. */
double ix__span_at_length(const ix_path *p, int span, double a, double b,
                          double total, double s);

#endif
