/* form.h - piecewise homogeneous forms: what all algebra works on.
 *
 * An operator loads its inputs once, computes with forms in scratch memory and
 * stores one result; nothing is decomposed or composed in between.
 *
 * A form is a function of ndirs parameters with nrows components. Direction i
 * has spans (breaks, degree d) as in bsp/spans.h; on span j, of length h, the
 * local parameters are u = (t - a) / h and v = 1 - u, and the function is the
 * homogeneous form sum c_k u^k v^(d-k) of degree d. Each row is a tensor in
 * which direction i holds nspans (degree + 1) scaled Bernstein coefficients
 * c_k = C(d,k) b_k, span by span, direction 0 fastest.
 *
 *   c    double[nrows][n],  n = product of nspans_i (degree_i + 1)
 *
 * Values are c times 2^exp: exp is 0 except for degrees so high that binomials
 * could overflow; every operation here keeps track of it.
 *
 * Two forms meet only if they have the same directions and breaks (as after
 * ix__forms_load, or ix__form_refine); degrees may differ. Rows: a form with
 * one row meets every row of the other.
 *
 * Continuity. cont[j] of a direction is what the algebra guarantees of every
 * row, as a function of the global parameter, at an inner break:
 *   load             order - 1 - multiplicity; none of its knots: INT_MAX
 *   sum, product     the smaller of both
 *   derive           one less (INT_MAX stays); integrate: one more
 *   elevate, refine  unchanged
 * The partials U and V are different. With respect to the global parameter
 *   F_u = d f + (b - t) f'    F_v = d f - (t - a) f'
 * on the span [a, b]: they depend on the span, so that alone they are not
 * even continuous. But (F_u, F_v) is (f, f') times a matrix of determinant
 * -d h, so a minor that takes both partials of its functions is -d h times
 * the minor of (f, f'), and a minor that takes all k-th partials is a constant
 * times h^(k(k+1)/2) times the minor of (f, f', ..., f^(k)). ix__form_partial
 * therefore divides by h / h0 with each U (h0 the mean span length, the same
 * on all spans): k-th partials together carry exactly h^(-k(k+1)/2), and such
 * minors are C^(c-k) functions, with no further care. The continuity written
 * down for a partial, c - 1, is that of these minors. Never store a partial
 * by itself; store what is built from complete sets. */
#ifndef SYM_FORM_H
#define SYM_FORM_H

#include "bsp/spans.h"
#include "iritx/sym.h"
#include "mv/mv.h"

typedef struct {
    int ndirs, nrows;
    unsigned bezier;      /* bit i: direction i met only Bezier bases */
    int exp;              /* values are c * 2^exp */
    const ix_spans *dirs; /* [ndirs] */
    size_t n;             /* coefficients of one row */
    double *c;            /* [nrows][n] */
} ix_form;

/* --- frames --------------------------------------------------------------- */

/* x' = (x - shift) 2^-exp carries the inputs into the unit box. Powers of two
 * change no bit; shifting is exact to the last place of the input. */
typedef struct {
    int ncoords, exp;
    double shift[IX_MAX_COORDS];
    double noise; /* largest rounding error of an input, in the frame */
} ix_frame;

/* The frame of the projected control points of n multivariates (those of
 * weight 0 aside). Err IX_EDOMAIN all weights are zero. */
ix_status ix__frame_of(ix_ctx *ctx, int n, const ix_mv *const *m,
                       ix_frame *out) IX_MUST_CHECK;
/* Makes the point at[nc] the origin if it is within twice the box: then
 * differences from it are exact however near it is. False if it is not. */
bool ix__frame_centre(ix_frame *f, int nc, const double *at);
/* Values of the frame back to the user's: x = w shift + factor x' 2^exp, in
 * place on double[ncoords][n]; w double[n] are their weights, NULL stands for
 * 1. (A result whose weights were multiplied by factor, a power of two, gets
 * it on its coordinates here.) */
void ix__frame_back(const ix_frame *f, double factor, size_t n, const double *w,
                    double *x);

/* --- in and out ----------------------------------------------------------- */

/* n multivariates (any basis) as forms on common breaks, the axes as rows
 * (weight first). Domains are mapped onto the first one's. frame: NULL, or
 * applied to the coordinates before anything else; weights are then scaled to
 * at most 1 (a homogeneous factor).
 * Err IX_EARG numbers of directions or domains differ (1e-5 of the length) */
ix_status ix__forms_load(ix_ctx *ctx, int n, const ix_mv *const *m,
                         const ix_frame *frame, ix_form *out) IX_MUST_CHECK;

/* The rows as axes of a new multivariate; bezier directions stay Bezier,
 * others get the knots that cont, cut to o->max_cont, asks for.
 * Err IX_EDOMAIN a coefficient overflows */
ix_status ix__form_store(ix_ctx *ctx, const ix_form *f, bool rational,
                         const ix_sym_opts *o, ix_mv **out) IX_MUST_CHECK;

/* The same in two steps, for results that are finished on control points: the
 * directions (knots in scratch), then the points double[nrows][npts]. */
ix_status ix__form_dirs(ix_ctx *ctx, const ix_form *f, const ix_sym_opts *o,
                        ix_dir *dirs) IX_MUST_CHECK;
ix_status ix__form_points(ix_ctx *ctx, const ix_form *f, const ix_dir *dirs,
                          const double **out) IX_MUST_CHECK;
/* The points into to; f is converted in place and no form afterwards. */
ix_status ix__form_points_into(ix_ctx *ctx, ix_form *f, const ix_dir *dirs,
                               double *to) IX_MUST_CHECK;
/* IX_EDOMAIN if a number is infinite or NaN. */
ix_status ix__check_finite(ix_ctx *ctx, size_t n,
                           const double *x) IX_MUST_CHECK;

/* --- making --------------------------------------------------------------- */

/* Coefficients unset. Err IX_EUNABLE a degree beyond IX_MAX_ORDER - 1. */
ix_status ix__form_alloc(ix_ctx *ctx, int ndirs, const ix_spans *dirs,
                         int nrows, ix_form *out) IX_MUST_CHECK;
/* Rows of constants, degree 0, on the breaks of like. */
ix_status ix__form_constant(ix_ctx *ctx, const ix_form *like, int nrows,
                            const double *values, ix_form *out) IX_MUST_CHECK;
/* A copy that may be changed. */
ix_status ix__form_copy(ix_ctx *ctx, const ix_form *f,
                        ix_form *out) IX_MUST_CHECK;
/* View of count rows from first on. */
static inline ix_form ix__form_rows(const ix_form *f, int first, int count)
{
    return (ix_form){f->ndirs,
                     count,
                     f->bezier,
                     f->exp,
                     f->dirs,
                     f->n,
                     f->c + (size_t)first * f->n};
}
/* All rows of n forms one after the other, elevated to common degrees. */
ix_status ix__form_join(ix_ctx *ctx, int n, const ix_form *const *parts,
                        ix_form *out) IX_MUST_CHECK;

/* --- the same function, written otherwise --------------------------------- */

/* To the given degrees, none below f's; a view if there is nothing to do. */
ix_status ix__form_elevate(ix_ctx *ctx, const ix_form *f, const int *degrees,
                           ix_form *out) IX_MUST_CHECK;
/* To the given degrees (below 0 means 0) where the leading coefficients in t
 * are known to vanish: what is not zero in them is lost. A view if there is
 * nothing to do. */
ix_status ix__form_lower(ix_ctx *ctx, const ix_form *f, const int *degrees,
                         ix_form *out) IX_MUST_CHECK;
/* On breaks that contain those of f: direction dir gets the breaks of sp. */
ix_status ix__form_refine(ix_ctx *ctx, const ix_form *f, int dir,
                          const ix_spans *sp, ix_form *out) IX_MUST_CHECK;

/* --- algebra -------------------------------------------------------------- */

/* a + sign b, sign = 1 or -1, at the larger degrees. */
ix_status ix__form_add(ix_ctx *ctx, const ix_form *a, int sign,
                       const ix_form *b, ix_form *out) IX_MUST_CHECK;
/* Row by row; a form of one row multiplies all rows of the other. */
ix_status ix__form_mul(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                       ix_form *out) IX_MUST_CHECK;
/* Row r = sum of sign a_i b_j over its terms: every product of vectors is one
 * of these, and is best computed in one go. Terms are sorted by row. */
typedef struct {
    int row, a, b, sign; /* sign 1 or -1 */
} ix_form_term;
ix_status ix__form_bilinear(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                            int nrows, int nterms, const ix_form_term *terms,
                            ix_form *out) IX_MUST_CHECK;
/* acc += sign a b. acc was made by an operation above; its degrees grow if
 * need be. */
ix_status ix__form_mul_add(ix_ctx *ctx, const ix_form *a, int sign,
                           const ix_form *b, ix_form *acc) IX_MUST_CHECK;
/* f^k row by row, k >= 0; k = 1: a view. */
ix_status ix__form_power(ix_ctx *ctx, const ix_form *f, int k,
                         ix_form *out) IX_MUST_CHECK;
/* All coefficients times a constant, in place. */
void ix__form_times(ix_form *f, double factor);

/* --- calculus ------------------------------------------------------------- */

/* A partial of the form in direction dir, degree d - 1 (of degree 0: zeros
 * of degree 0); see the top of the file for the scale of U. */
typedef enum { IX__U, IX__V } ix__uv;
ix_status ix__form_partial(ix_ctx *ctx, const ix_form *f, int dir, ix__uv which,
                           ix_form *out) IX_MUST_CHECK;
/* All k-th partials: out[i] = d^k / dU^(k-i) dV^i, i = 0 .. k <= degree. */
ix_status ix__form_partials(ix_ctx *ctx, const ix_form *f, int dir, int k,
                            ix_form *out) IX_MUST_CHECK;
/* d/dt, degree d - 1 (of degree 0: zeros of degree 0). */
ix_status ix__form_derive(ix_ctx *ctx, const ix_form *f, int dir,
                          ix_form *out) IX_MUST_CHECK;
/* The integral from the lower end of direction dir, degree d + 1. */
ix_status ix__form_integrate(ix_ctx *ctx, const ix_form *f, int dir,
                             ix_form *out) IX_MUST_CHECK;
/* A_U b_V - A_V b_U for the rows of a and a scalar b of degrees p and q:
 * degree p + q - 2, equal to h0 (q A' b - p A b'); for p = q this is the
 * numerator of (A/b)' times p h0. Degree 0 counts as constant: zeros. */
ix_status ix__form_jacobian(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                            int dir, ix_form *out) IX_MUST_CHECK;
/* h0 of a direction: the mean span length. */
double ix__spans_mean(const ix_spans *sp);

/* --- rows as vectors and matrices ----------------------------------------- */

/* sum a_i b_i. */
ix_status ix__form_dot(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                       ix_form *out) IX_MUST_CHECK;
/* Three rows each (two: the third is 0). */
ix_status ix__form_cross(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                         ix_form *out) IX_MUST_CHECK;
/* a_0 b_1 - a_1 b_0: the minors of two pairs, rows as in ix__form_mul. */
ix_status ix__form_bracket(ix_ctx *ctx, const ix_form *const a[2],
                           const ix_form *const b[2],
                           ix_form *out) IX_MUST_CHECK;
/* det of n forms with n rows each. */
ix_status ix__form_det(ix_ctx *ctx, int n, const ix_form *const *m,
                       ix_form *out) IX_MUST_CHECK;
/* All maximal minors of n forms with cols >= n rows each, as the rows of one
 * form, sets of columns in lexicographic order (01, 02, .., 12, ..). Shared
 * sub-minors: sum over k of k C(cols, k) products. cols <= IX_MAX_COORDS. */
ix_status ix__form_all_minors(ix_ctx *ctx, int n, const ix_form *const *m,
                              ix_form *out) IX_MUST_CHECK;
/* The n + 1 signed minors (-1)^j det(all columns but j) as the rows of one
 * form: the vector orthogonal to all n. */
ix_status ix__form_minors(ix_ctx *ctx, int n, const ix_form *const *m,
                          ix_form *out) IX_MUST_CHECK;

/* --- asking --------------------------------------------------------------- */

/* All rows at t[ndirs] (inside the domain): out[nrows]. */
void ix__form_eval(const ix_form *f, const double *t, double *out);
/* Bernstein coefficients double[nrows][n] (scaling and exp undone). */
ix_status ix__form_bernstein(ix_ctx *ctx, const ix_form *f,
                             const double **out) IX_MUST_CHECK;
/* The span that holds t: breaks[j] <= t < breaks[j + 1], the last at its end.
 */
int ix__spans_find(const ix_spans *sp, double t);
/* Largest |Bernstein coefficient| of the rows (an upper bound of |f|). */
ix_status ix__form_bound(ix_ctx *ctx, const ix_form *f,
                         double *out) IX_MUST_CHECK;

#endif
