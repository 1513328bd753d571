/* outer.h - results in several variables kept as sums of products.
 *
 * When some rows depend on the first variables alone (u) and others on the
 * remaining ones alone (v), a result such as
 *
 *   r_k(s, t) = sum over terms of row k: coef u_i(s) v_j(t)
 *
 * needs each factor composed once, in its own directions; its control points
 * are then the same sums of products of control points. A bisector surface of
 * two curves is 4 rows of 6 terms: its cost is that of writing the grid. */
#ifndef SYM_OUTER_H
#define SYM_OUTER_H

#include "sym/form.h"

typedef struct {
    int row;  /* of the result; terms are sorted by it */
    int u, v; /* rows of the factors */
    double coef;
} ix_outer_term;

typedef struct {
    const ix_form *u, *v;
    int nrows, nterms;
    const ix_outer_term *terms;
} ix_outer;

/* The directions of the result: those of u, then those of v; knots in
 * scratch. */
ix_status ix__outer_dirs(ix_ctx *ctx, const ix_outer *f, const ix_sym_opts *o,
                         ix_dir *dirs) IX_MUST_CHECK;

/* The control points double[nrows][points of v][points of u] into pts. size,
 * if not NULL, receives for each row a bound of its terms, the sum of |coef|
 * max |u_i| max |v_j|, against which cancellation can be judged. */
ix_status ix__outer_points(ix_ctx *ctx, const ix_outer *f, const ix_dir *dirs,
                           double *pts, double *size) IX_MUST_CHECK;

/* Value of all rows without any grid: s[u's directions], t[v's directions]. */
ix_status ix__outer_eval(ix_ctx *ctx, const ix_outer *f, const double *s,
                         const double *t, double *out) IX_MUST_CHECK;

#endif
