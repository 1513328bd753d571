/* factor.h - common factors of many polynomials, numerically. */
#ifndef SYM_FACTOR_H
#define SYM_FACTOR_H

#include "base/ctx.h"

/* n polynomials of degree d on one span, scaled coefficients, double[n][d+1],
 * and what is known of a factor common to all. */
typedef struct {
    int d;
    size_t n;
    const double *p;
    double tol; /* of a Bernstein coefficient: what may change */
} ix__bundle;

/* The largest degree k <= most for which all polynomials are, within tol,
 * multiples of one polynomial h of degree k (h: scaled coefficients [k + 1],
 * room for d + 1, largest Bernstein coefficient 1; k = 0: h = 1).
 *
 * Two combinations of the polynomials have a Sylvester matrix whose null space
 * has the dimension of their common factor; its vectors tell h, which is then
 * fitted to all polynomials. What is returned has been checked by dividing and
 * multiplying back: *change is the largest change of a coefficient. */
ix_status ix__common_factor(ix_ctx *ctx, const ix__bundle *b, int most,
                            double *h, int *k, double *change) IX_MUST_CHECK;

/* All p = h q nearly: q double[n][d - k + 1] by least squares; *change: the
 * largest |Bernstein coefficient of p - h q|. */
ix_status ix__divide_all(ix_ctx *ctx, const ix__bundle *b, int k,
                         const double *h, double *q,
                         double *change) IX_MUST_CHECK;

#endif
