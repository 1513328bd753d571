/* poly_roots.h - the roots of one polynomial in Bernstein form on [0, 1].
 *
 * The engine under ix_roots: it isolates by sign variation of the
 * coefficients, with an error band around each of them, first in double, then
 * where that does not decide in double-double arithmetic. */
#ifndef SOLVE_POLY_ROOTS_H
#define SOLVE_POLY_ROOTS_H

#include "base/ctx.h"

typedef struct {
    double s, lo, hi; /* in [0, 1], s in [lo, hi] */
    int count;        /* 1: exactly one simple root in [lo, hi]; more: at most
                         so many, with multiplicity, and the parity is right */
} ix__poly_root;

typedef struct {
    int n;
    ix__poly_root *root; /* [at most degree], increasing; scratch */
    int zeros0, zeros1;  /* multiplicity of the roots at 0 and at 1 */
    int sign0, sign1;    /* sign just inside the two ends; both 0 if and only if
                            the polynomial vanishes within its band */
    bool vanishes;
} ix__poly_roots;

/* b[degree + 1], each with absolute error at most band (>= 0). Roots at 0 and
 * 1 (coefficients within their band there) are counted in zeros0, zeros1, the
 * others are inside (0, 1). */
ix_status ix__poly_roots_find(ix_ctx *ctx, int degree, const double *b,
                              double band, ix__poly_roots *out) IX_MUST_CHECK;

#endif
