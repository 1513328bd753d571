/* path.h - a curve cut into Bezier spans, ready to be evaluated often.
 *
 * Lives in scratch memory. A span may be asked beyond its interval (it is a
 * polynomial, or a quotient of two), so limits from both sides of a knot are
 * within reach. One thread at a time: it has a work array. */
#ifndef GEOM_PATH_H
#define GEOM_PATH_H

#include "bsp/spans.h"
#include "mv/mv.h"

typedef struct {
    int degree, nspans, naxes, ncoords;
    bool rational;
    const double *breaks; /* [nspans + 1] */
    const int *cont;      /* [nspans - 1]: known continuity at inner breaks */
    const double *coef;   /* [nspans][naxes][degree + 1], Bernstein */
    double *work;         /* [degree + 1] */
} ix_path;

/* Err IX_EARG not one direction. */
ix_status ix__path_new(ix_ctx *ctx, const ix_mv *crv,
                       ix_path *out) IX_MUST_CHECK;

/* The span that holds t; at a break the one to the right, clamped. */
int ix__path_span(const ix_path *p, double t);

/* Homogeneous value, or derivatives 0 .. nder: out[nder + 1][naxes]. */
void ix__path_axes(const ix_path *p, int span, double t, int nder, double *out);

/* Derivatives 0 .. nder (<= IX_PATH_DERIVS) of the projected curve:
 * out[nder + 1][ncoords]; not finite at a pole. */
#define IX_PATH_DERIVS 3
void ix__path_derivs(const ix_path *p, int span, double t, int nder,
                     double *out);

/* The point, out[ncoords], at any t of the domain. */
void ix__path_point(const ix_path *p, double t, double *out);

/* Derivatives of the first three coordinates, missing ones 0. */
void ix__path_derivs3(const ix_path *p, int span, double t, int nder,
                      double (*out)[3]);

/* Unit tangent at t from the side of span: the direction of the first
 * derivative that does not vanish (relative to the span's size). False if
 * three vanish. at_end: t is the span's upper end, the direction of arrival. */
bool ix__path_tangent3(const ix_path *p, int span, double t, bool at_end,
                       double out[3]);

/* Unit principal normal of the first three coordinates at t, towards the centre
 * of curvature; false if there is no tangent or no curvature (below 1e-12 of
 * |C''| is rounding). */
bool ix__path_normal3(const ix_path *p, int span, double t, double out[3]);

/* IX_EDOMAIN unless all weights of the spans have one sign. */
ix_status ix__path_no_poles(ix_ctx *ctx, const ix_path *p) IX_MUST_CHECK;

/* Largest distance of control points from the first one, over all spans: the
 * size that rounding is relative to. */
double ix__path_size(const ix_path *p);

/* Does the tangent turn (by more than 1e-6), or the curve jump, at inner break
 * s, 0 < s < nspans? */
bool ix__path_is_corner(const ix_path *p, int s);
/* The first break from `from` on where it does; nspans if there is none. */
int ix__path_corner(const ix_path *p, int from);

#endif
