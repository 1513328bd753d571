/* parts.h - small steps shared by the surface constructors.
 *
 * Intermediate multivariates go into an array of pointers that starts as NULL;
 * the public function releases the whole array whatever happened. */
#ifndef GEOM_PARTS_H
#define GEOM_PARTS_H

#include "mv/mv.h"

/* Releases t[0 .. n-1], NULL entries included. */
void ix__mv_unref_all(ix_ctx *ctx, ix_mv *const *t, int n);

bool ix__mv_has_basis(const ix_mv *m, ix_basis b);

/* Power becomes Bezier; Bezier directions beside B-spline ones become
 * B-spline, so that all directions are alike. */
ix_status ix__mv_plain(ix_ctx *ctx, const ix_mv *m, ix_mv **out) IX_MUST_CHECK;
/* Both plain, and if one is a B-spline then both are. */
ix_status ix__mv_plain2(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, ix_mv **pa,
                        ix_mv **pb) IX_MUST_CHECK;

/* The same control values with the weight as the first of naxes coordinates
 * (rational = false), or with the first coordinate as the weight. */
ix_status ix__mv_relabel(ix_ctx *ctx, const ix_mv *m, bool rational,
                         ix_mv **out) IX_MUST_CHECK;

/* A direction of order 1 over dom, Bezier if possible and wanted. */
ix_dir ix__dir_constant(bool bezier, const double dom[2]);
/* A linear direction over [0, 1]. */
ix_dir ix__dir_linear(bool bezier);

/* a as a function of (s, t) that does not depend on t, and b one that does not
 * depend on s; s, t over the domains of a and b. Plain inputs of one kind. */
ix_status ix__mv_product_domain(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                                ix_mv **pa, ix_mv **pb) IX_MUST_CHECK;

/* A block with the directions of a, then those of b; points unset. */
ix_status ix__mv_outer_alloc(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                             int ncoords, bool rational,
                             ix_mv **out) IX_MUST_CHECK;
/* out[i + na j] += f a[i] b[j]; a or b NULL stands for ones. */
void ix__outer_add(size_t na, const double *a, size_t nb, const double *b,
                   double f, double *out);

/* Coordinate c of m, NULL if m has not so many. */
const double *ix__mv_coord_or_null(const ix_mv *m, int c);

#endif
