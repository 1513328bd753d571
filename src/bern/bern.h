/* bern.h - kernels on raw arrays of Bernstein coefficients.
 *
 * A polynomial of degree d on one span is sum b_k B(d,k)(u), u in [0, 1]. Its
 * scaled coefficients c_k = C(d,k) b_k are those of the homogeneous form
 * sum c_k u^k v^(d-k), v = 1 - u: there a product is a plain convolution and
 * the partials are k c_k and (d-k) c_k.
 *
 * Many polynomials at once: a block is double[d + 1][inner], inner contiguous;
 * blocks follow each other. Kernels allocate nothing, cannot fail and may run
 * in any thread. Degrees go up to IX_MAX_ORDER - 1, where the largest binomial
 * is still finite. */
#ifndef BERN_BERN_H
#define BERN_BERN_H

#include <stdbool.h>
#include <stddef.h>

/* --- binomials ------------------------------------------------------------ */

/* Degrees up to this one have their binomials in a table. */
#define IX__BINOM_TABLE 24
/* The row C(d, 0 .. d): from the table, or computed into room[d + 1], each
 * entry within one ulp. room may be NULL for d <= IX__BINOM_TABLE. */
const double *ix__binom(int d, double *room);

/* --- blocks --------------------------------------------------------------- */

/* c_k = C(d,k) b_k and back, for count blocks; out may be in. Rows of degree
 * 0 and 1 are copied. row = ix__binom(d). */
void ix__bern_scale(size_t count, int d, size_t inner, const double *row,
                    const double *in, double *out);
void ix__bern_unscale(size_t count, int d, size_t inner, const double *row,
                      const double *in, double *out);

/* One block in scaled form. out has (d + e + 1), d or d + 2 rows of inner
 * numbers; no overlap with in.
 * elevate: times (u + v)^e, row = ix__binom(e). */
void ix__bern_elevate(int d, int e, const double *row, size_t inner,
                      const double *in, double *out);
/* f times d/du, d/dv of the form; d >= 1. */
void ix__bern_partial_u(int d, double f, size_t inner, const double *in,
                        double *out);
void ix__bern_partial_v(int d, double f, size_t inner, const double *in,
                        double *out);
/* f times the derivative with respect to u on v = 1 - u; d >= 1. */
void ix__bern_derive(int d, double f, size_t inner, const double *in,
                     double *out);
/* start[inner] + f times the integral from u = 0; rows = binomials of d and
 * of d + 1. start receives the value at u = 1. */
void ix__bern_integrate(int d, double f, const double *row, const double *row1,
                        size_t inner, const double *in, double *start,
                        double *out);
/* Power coefficients, sum a_k u^k, to Bernstein ones in place. */
void ix__bern_from_power(int d, size_t inner, double *a);
/* The polynomial over [a, b] of u, as a form on its own span; b_k in and out
 * (not scaled), work and out double[d + 1][inner], in place allowed. */
void ix__bern_restrict(int d, double a, double b, size_t inner,
                       const double *in, double *out);

/* --- one polynomial ------------------------------------------------------- */

/* Value of the scaled form at (u, v): u, v >= 0 gives an error of at most
 * 2 d ulp of sum |c_k| u^k v^(d-k). */
double ix__bern_value(int d, const double *c, double u, double v);

/* Changes of sign in c[0 .. n-1], numbers with |c_k| <= band counting as
 * zero and zeros as nothing; *undecided (may be NULL) tells whether there
 * were such. */
int ix__bern_variations(int n, const double *c, double band, bool *undecided);

/* Parameters in (0, 1) where the polynomial with Bernstein coefficients
 * b[0 .. d] changes sign, increasing, at most d of them; coefficients up to
 * band count as zero, so that zeros it only touches, or runs along, are left
 * out. work has room for 2 (d + 1). Returns their number. */
int ix__bern_crossings(int d, const double *b, double band, double *work,
                       double *out);

/* --- products ------------------------------------------------------------- */

/* How a product meets what stands in out. */
typedef enum { IX__SET, IX__ADD, IX__SUB } ix__into;

/* Zeros that stand on either side of a dense factor. */
#define IX__BERN_PAD 16

/* Products of n pairs of scaled polynomials, span by span: a double[n][p+1],
 * b double[n][q+1], out double[n][p+q+1] (no overlap); work has room for
 * max(p,q) + 1 + 2 IX__BERN_PAD. */
void ix__bern_conv_spans(size_t n, int p, const double *a, int q,
                         const double *b, ix__into into, double *work,
                         double *out);

/* One product of sparse by dense: out[k] = sum a[i] b[k - off[i]] for
 * 0 <= k < nout; off increases; b[0 .. nb-1] stands between IX__BERN_PAD
 * zeros on either side; out has room for nout rounded up to 16. This is the
 * product of tensors whose coefficients stand at the strides of the result. */
void ix__bern_conv_sparse(int na, const double *a, const int *off, int nb,
                          const double *b, int nout, double *out);

/* The largest |x[i]|, NaNs left out, 0 if there is none; whether no x[i] is
 * infinite or NaN. */
double ix__bern_largest(size_t n, const double *x);
bool ix__bern_finite(size_t n, const double *x);
/* Plus or minus the power of two by which weights get a sum that is not
 * negative and a largest size in [1/2, 1). */
double ix__bern_weight_factor(size_t n, const double *w);

/* out[i] = sum over j < k of f[j] x[j][i], 0 <= i < n. */
void ix__bern_combine(size_t n, int k, const double *f, const double *const *x,
                      double *out);

#endif
