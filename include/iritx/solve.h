/* solve.h - zero sets of piecewise polynomial and rational functions.
 *
 * One unknown: ix_roots. Every root is reported once, with an interval that
 * encloses it and with what is known of its multiplicity; nothing that the
 * arithmetic cannot decide is dropped: it is reported as what it is. */
#ifndef IRITX_SOLVE_H
#define IRITX_SOLVE_H

#include "iritx/mv.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    IX_ROOT_SIMPLE,  /* exactly one root, the function changes its sign */
    IX_ROOT_EVEN,    /* touches zero, no change of sign; count is even */
    IX_ROOT_CLUSTER, /* count roots (with multiplicity) closer together than
                        the numbers can tell apart, or one such multiple root */
    IX_ROOT_JUMP,    /* the sign changes at a discontinuity, without a zero */
    IX_ROOT_INTERVAL /* the function vanishes on all of [lo, hi] */
} ix_root_kind;

typedef struct {
    ix_root_kind kind;
    double t;      /* the root: lo <= t <= hi */
    double lo, hi; /* encloses it; lo == hi: the number itself */
    int count;     /* 1 simple, 0 jump and interval; else multiplicity, or its
                      upper bound of the same parity, by sign variation */
    int before, after; /* sign of the function next to lo and hi: -1, 1, or 0
                          at the end of the domain */
} ix_root;

typedef struct {
    double lo, hi; /* the interval of interest; lo > hi: the whole domain */
    double level;  /* roots of f - level (of the numerator if rational) */
    double error;  /* the coefficients' known error, relative to the largest of
                      their span; 0: rounding of the decomposition only */
} ix_root_opts;

/* All zeros of one axis of a univariate f, by increasing t.
 *
 * In    f      one direction, any basis but power; axis 0 .. naxes-1; the
 *              weight of a rational f is not looked at unless level is not 0
 *       o      NULL: whole domain, level 0, error 0
 * Out   *roots array of *n, freed with ix_roots_free
 * Err   IX_EARG     more than one direction, axis out of range, power basis
 * Num   roots closer than about 1e-15 of their span are told apart when the
 *       coefficients are exact; deterministic
 * Src   Descartes' rule in Bernstein form (Lane & Riesenfeld 1981; Rouillier &
 *       Zimmermann 2004) with a running error band */
ix_status ix_roots(ix_ctx *ctx, const ix_mv *f, int axis, const ix_root_opts *o,
                   ix_root **roots, int *n) IX_MUST_CHECK;
void ix_roots_free(ix_ctx *ctx, ix_root *roots, int n);

#ifdef __cplusplus
}
#endif
#endif
