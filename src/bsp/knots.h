/* knots.h - knot vectors of one direction: domain, spans, standard vectors.
 *
 * Knots are non-decreasing and knots meant to be equal are equal bit by bit
 * (ix_mv_new sees to it), so multiplicities are counted with ==. */
#ifndef BSP_KNOTS_H
#define BSP_KNOTS_H

#include "base/ctx.h"
#include "iritx/mv.h"

/* Knots this near are meant to be one: 4 ulp of the vector's largest. */
double ix__knots_ulp4(int n, const double *knots);

/* Domain of any direction; [0, 1] unless B-spline. */
void ix__dir_domain(const ix_dir *dir, double dom[2]);

/* Points of a direction with those that wrap: length, or for a periodic
 * direction length + order - 1. */
int ix__dir_npoints(const ix_dir *dir);

/* The non-empty knot span that holds t: mu with knots[mu] <= t <
 * knots[mu + 1], order - 1 <= mu < ix__dir_npoints; clamped to the first and
 * last span of the domain. B-spline only. */
int ix__dir_span(const ix_dir *dir, double t);

/* The knots of a B-spline direction, or in scratch those of the B-spline that
 * a Bezier direction is. */
ix_status ix__dir_knots(ix_ctx *ctx, const ix_dir *dir,
                        const double **knots) IX_MUST_CHECK;

/* True if the first order knots of the domain's start are equal, and the last
 * ones of its end, and the direction is not periodic. */
bool ix__dir_is_open(const ix_dir *dir);

#endif
