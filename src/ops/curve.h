/* curve.h - a curve in its frame and the forms that its differential geometry
 * is made of.
 *
 * For x = p / w of degree d, ' = d/dt, det() of vectors:
 *
 *   tangent   D = p'w - p w'                  x'        = D / w^2
 *   normal    V = w p'xp'' - w'pxp'' + w''pxp'  x' x x'' = V / w^3
 *   torsion   T = -Wronskian(x, y, z, w)      det(x', x'', x''') = T / w^4
 *   speed     Q = |D|^2
 *
 * as exact functions of these values, in the lowest degree: 2d - 2, 3d - 6,
 * 4d - 12, 4d - 4. A polynomial curve has D = x', V = x' x x'', T and Q with w
 * = 1, of degrees d - 1, 2d - 4, 3d - 9, 2d - 2. In the plane V has one row.
 *
 * A Wronskian of k + 1 functions of degree d is the determinant of rows j = 0
 * .. k, the j-th derivative differentiated k - j times by V (form.h), over
 * prod (d - i)^(i + 1), i < k (Euler's rule, row by row): no leading terms
 * appear that would have to cancel. */
#ifndef OPS_CURVE_H
#define OPS_CURVE_H

#include "iritx/ops.h"
#include "sym/form.h"

/* Size of the values on a span, and their error. */
typedef struct {
    double size, error;
} ix_extent;

typedef struct {
    ix_frame frame;
    int dim, ncoords; /* dim 2: a plane z = const; ncoords: of the input */
    double z;         /* the plane, if ncoords is 3 and dim 2 */
    int degree, wexp; /* weights are 2^-wexp times the user's */
    bool rational;
    ix_form p, w;  /* dim rows; one row (constant 1 if polynomial) */
    ix_form local; /* p minus a multiple of w on each span: D, V, T are the
                      same, without the cancellation of far points */
    ix_form d, v, q;
    ix_form t; /* only where ix__curve_torsion was asked to fill it in */
    ix_extent *ew, *ed, *ev, *eq, *et; /* [nspans] */
    bool centred;
} ix_curve;

/* In the frame, with w, p, D, V, Q; constant weights count as polynomial if
 * simplify is set.
 * Err IX_EARG not a curve, or not 2 or 3 coordinates. */
typedef enum {
    IX__CURVE,      /* dim 2 in a plane z = const, else 3 */
    IX__CURVE_FLAT, /* coordinates after the second are dropped: dim 2 */
    IX__CURVE_SPACE /* dim 3, a missing coordinate is 0 */
} ix__curve_kind;
ix_status ix__curve_load(ix_ctx *ctx, const ix_mv *crv, ix__curve_kind kind,
                         bool simplify, ix_curve *out) IX_MUST_CHECK;
/* Only w, p and D (V, Q and their extents are not set), with the point at[dim]
 * as the origin (centred is set) if it is within twice the box of the curve;
 * kind is not IX__CURVE. */
ix_status ix__curve_load_tangent(ix_ctx *ctx, const ix_mv *crv,
                                 ix__curve_kind kind, const double *at,
                                 bool simplify, ix_curve *out) IX_MUST_CHECK;
/* T; dim is 3. */
ix_status ix__curve_torsion(ix_ctx *ctx, const ix_curve *c, ix_form *t,
                            ix_extent **et) IX_MUST_CHECK;

/* For rows A of degree a that scale as w^s times the square (power 2) or the
 * first power of V:  w (A'Q - 3/2 power A Q') + 3 power A w'Q,
 * the numerator of (w^(3 power) A / Q^(3/2 power))'. */
ix_status ix__curve_slope(ix_ctx *ctx, const ix_curve *c, const ix_form *a,
                          int power, ix_form *out) IX_MUST_CHECK;

/* --- blocks of spans ---------------------------------------------------- */

enum { IX__CURVE_FORMS = 3 };

/* Makes up to IX__CURVE_FORMS forms of a curve, on its breaks; those that it
 * leaves alone have no rows. What it computes on a span may depend on that span
 * only (no mean lengths, no partials by U), degrees and exp on none. */
typedef ix_status (*ix__curve_fn)(ix_ctx *ctx, const ix_curve *c, void *arg,
                                  ix_form *out);
/* The rows of all forms that fn makes, of one degree, in a form of its own
 * (ix__form_join). Long curves are done in blocks of spans, so that
 * intermediate forms take the memory of a block: fn is called several times,
 * with parts of c. */
ix_status ix__curve_forms(ix_ctx *ctx, const ix_curve *c, ix__curve_fn fn,
                          void *arg, ix_form *out) IX_MUST_CHECK;

/* --- extents ------------------------------------------------------------ */

/* Of a form known to within error[nspans] (NULL: 0). */
ix_status ix__extents(ix_ctx *ctx, const ix_form *f, const double *error,
                      ix_extent **out) IX_MUST_CHECK;
/* Of a product of two, computed at the given degree. */
ix_extent ix__extent_mul(ix_extent a, ix_extent b, int degree);
ix_extent ix__extent_add(ix_extent a, ix_extent b);
/* True where the form cannot be told from zero on all spans. */
bool ix__extents_zero(const ix_form *f, const ix_extent *e);
bool ix__extent_is_zero(ix_extent e);

/* --- results ------------------------------------------------------------ */

typedef struct {
    bool irit;    /* joins as IRIT makes them: C0 where values agree, else a
                     jump */
    int max_cont; /* of ix_op_opts */
} ix_join_rule;
ix_join_rule ix__join_rule(const ix_op_opts *o);

/* What is stored are the rows of one form, which is converted in place and no
 * form afterwards. */

/* The rational curve x / w (rows w, x; c->dim of x) as a multivariate of the
 * user's space with ncoords coordinates: the sum of weights is positive, the
 * largest in [1/2, 1). */
ix_status ix__curve_store(ix_ctx *ctx, const ix_curve *c, ix_form *wx,
                          int ncoords, ix_join_rule rule,
                          ix_mv **out) IX_MUST_CHECK;
/* The surface (x + (lo + v (hi - lo)) ruling) / w, v in [0, 1], of the rows w,
 * x, ruling; the last is multiplied by 2^exp first. */
ix_status ix__ruled_store(ix_ctx *ctx, const ix_curve *c, ix_form *wxr, int exp,
                          const double range[2], ix_join_rule rule,
                          ix_mv **out) IX_MUST_CHECK;
/* The rows, the first of them a weight if rational, times 2^exp as they are. */
ix_status ix__rows_store(ix_ctx *ctx, ix_form *rows, bool rational, int exp,
                         ix_join_rule rule, ix_mv **out) IX_MUST_CHECK;

#endif
