/* spans.h - one direction of a piecewise polynomial, in pieces.
 *
 * A direction of degree d with N spans between increasing breakpoints is
 * held as N * (d + 1) Bernstein coefficients, span by span. A tensor is
 * decomposed direction by direction: an array [outer][n][inner] of B-spline
 * coefficients becomes [outer][N * (d + 1)][inner], inner contiguous. All
 * algebra happens in that shape (scaled, see bern/); composing inverts it. */
#ifndef BSP_SPANS_H
#define BSP_SPANS_H

#include "base/ctx.h"
#include "iritx/mv.h"

typedef struct {
    int degree;
    int nspans;
    const double *breaks; /* [nspans + 1], strictly increasing */
    const int *cont;      /* [nspans - 1]: order of continuity known at
                             breaks[j + 1]; -1 a jump; >= degree no knot */
} ix_spans;

/* The breakpoints inside the domain of dir (any basis; power not), with
 * continuity order-1-multiplicity; arrays in scratch. */
ix_status ix__spans_of(ix_ctx *ctx, const ix_dir *dir,
                       ix_spans *out) IX_MUST_CHECK;

/* The union of two breakpoint sets on one domain (ends agree; a's are kept);
 * breakpoints within 4 ulp are one. degree: as given. cont[j]: the smaller of
 * both, a function without that breakpoint counting as INT_MAX. Scratch. */
ix_status ix__spans_union(ix_ctx *ctx, const ix_spans *a, const ix_spans *b,
                          int degree, ix_spans *out) IX_MUST_CHECK;

/* B-spline (or Bezier) coefficients of dir to Bernstein coefficients on the
 * breaks of sp, which contain those of dir up to a few ulp (sp may have more;
 * its degree and cont do not matter). in [outer][length][inner] (periodic
 * wraps), out [outer][nspans * order][inner]; no overlap. Convex
 * combinations only. Shares out large work. */
ix_status ix__spans_extract(ix_ctx *ctx, const ix_dir *dir, const ix_spans *sp,
                            size_t outer, size_t inner, const double *in,
                            double *out) IX_MUST_CHECK;

/* The open B-spline direction (or Bezier: one span on [0, 1] and allow_bezier)
 * that holds every function with sp's degree and continuity: interior
 * multiplicity degree - cont, at least 0 and at most degree + 1; cont is
 * first cut to max_cont (INT_MAX: as known; 0: C0 joins). Knots in scratch. */
ix_status ix__spans_target(ix_ctx *ctx, const ix_spans *sp, int max_cont,
                           bool allow_bezier, ix_dir *out) IX_MUST_CHECK;

/* Bernstein coefficients on sp to coefficients of dir (from
 * ix__spans_target); each is one blossom value of one span: exact up to
 * rounding. The span is the one that amplifies rounding errors least: that
 * with the most of the knots concerned at its ends, and the longer of two.
 * in [outer][nspans * (degree + 1)][inner], out [outer][dir->length][inner];
 * no overlap. Shares out large work. Where a single span would multiply errors
 * by more than 10^4 (high degree with high continuity), ix__spans_fit takes
 * over; IX_EUNABLE if it cannot. */
ix_status ix__spans_compose(ix_ctx *ctx, const ix_spans *sp, const ix_dir *dir,
                            size_t outer, size_t inner, const double *in,
                            double *out) IX_MUST_CHECK;

/* A bound of what composing from single spans multiplies relative errors by,
 * the worst of all coefficients. */
ix_status ix__spans_amplification(ix_ctx *ctx, const ix_spans *sp,
                                  const ix_dir *dir,
                                  double *worst) IX_MUST_CHECK;

/* The extraction of one span as a matrix: row i holds the weights of the
 * control points c[mu - degree .. mu] in the Bernstein coefficient i over
 * [ab[0], ab[1]] inside the knot span mu: out[degree + 1][degree + 1]. */
void ix__span_matrix(const double *knots, int mu, int degree,
                     const double ab[2], double *out);

/* The spline in dir nearest to Bernstein coefficients on sp, both ends kept
 * (unless its order is 1): least squares of Bernstein coefficients of sp's
 * degree, which is also the best approximation in L2 on one span (Lutterkort,
 * Peters, Reif 1999). dir is open (or Bezier, on the one span [0, 1]), its
 * order at most degree + 1, its breaks among sp's. in as for compose; err
 * [outer] receives a bound of the change, valid for whole spans. Err
 * IX_EUNABLE too badly conditioned (orders far apart and large). */
ix_status ix__spans_fit(ix_ctx *ctx, const ix_spans *sp, const ix_dir *dir,
                        size_t outer, size_t inner, const double *in,
                        double *out, double *err) IX_MUST_CHECK;

#endif
