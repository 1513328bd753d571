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

/* --- n equations in n unknowns ------------------------------------------- */

#define IX_MAX_UNKNOWNS 6

typedef enum { IX_EQUAL_ZERO, IX_AT_LEAST_ZERO, IX_AT_MOST_ZERO } ix_relation;

/* One axis of f (the numerator if rational) related to zero. All equations
 * have the same number of directions and the same domains. */
typedef struct {
    const ix_mv *f;
    int axis;
    ix_relation rel;
} ix_equation;

typedef struct {
    double x[IX_MAX_UNKNOWNS];
    double lo[IX_MAX_UNKNOWNS], hi[IX_MAX_UNKNOWNS]; /* encloses it */
    bool certified;  /* exactly one solution in the box, proven; otherwise the
                        box could not be decided: it holds none, one or more */
    double residual; /* largest |f_i(x)| over the largest coefficient of f_i */
} ix_solution;

typedef struct {
    double cell;      /* boxes smaller than this part of the domain that stay
                         undecided are reported; 0: 1e-10. Multiple
                         solutions end far above, where rounding hides them */
    size_t max_boxes; /* stop after so many boxes; 0: 10 million */
    bool keep;        /* when interrupted, return IX_OK with what is proven so
                         far, as with max_boxes, instead of IX_ECANCEL */
} ix_solve_opts;

typedef struct {
    int n, unknowns;
    ix_solution *sol; /* by increasing x[0], then x[1], ... */
    bool complete;    /* false: max_boxes reached, interrupted or crowded; what
                         is open is reported as boxes that are not certified */
    size_t boxes;     /* looked at */
    size_t bytes;
    bool interrupted; /* with the option keep */
    bool crowded;     /* so many boxes stayed undecided that they are no longer
                         isolated solutions: the equations share a curve, or
                         nearly; the open boxes that cover it are larger than
                         cell, the fewer the sooner */
} ix_solutions;

/* All common solutions of neq relations, of which as many equalities as there
 * are unknowns (1 .. IX_MAX_UNKNOWNS); further equalities are used as checks.
 *
 * Out   *out    freed with ix_solutions_free
 * Err   IX_EARG     fewer equalities than unknowns, different domains or
 *                   directions, power basis
 *       IX_ECANCEL  interrupted (without the option keep)
 * Num   a regular solution is certified (Krawczyk's test on its box) and
 *       polished by Newton to the accuracy of double; deterministic
 * Src   preconditioned domain reduction: Mourrain & Pavone 2009; uniqueness:
 *       Krawczyk 1969, Moore 1977 */
ix_status ix_solve(ix_ctx *ctx, int neq, const ix_equation *eq,
                   const ix_solve_opts *o, ix_solutions *out) IX_MUST_CHECK;
void ix_solutions_free(ix_ctx *ctx, ix_solutions *s);

/* --- n - 1 equations in n unknowns: curves ----------------------------------
 */

typedef struct {
    double tol;       /* distance of the polyline from the curve, as a part of
                         the domain's longest edge; 0: 1e-4 */
    double cell;      /* as in ix_solve_opts; 0: 1e-6 */
    size_t max_boxes; /* 0: 1 million */
    bool keep;        /* as in ix_solve_opts */
    int checks; /* the last so many relations only leave out cells in which
                   they cannot hold: what the curves that are wanted
                   fulfil, and a set of other solutions does not. Curves
                   on which they fail elsewhere are not cut */
    int crowd;  /* undecided cells after which cell doubles; 0: 64, which a
                   singular point in 4 unknowns at which several curves touch
                   may exceed */
    const ix_mv *image; /* a curve or surface in space whose parameters are the
                           unknowns from image_at on: the polyline's image is
                           within tol of the image's size, too. NULL: none;
                           borrowed */
    int image_at;
} ix_curves_opts;

typedef enum {
    IX_END_CLOSED,   /* the curve is a loop: first and last point are equal */
    IX_END_BOUNDARY, /* on the boundary of the domain */
    IX_END_SINGULAR, /* at a singular point (see singular) */
    IX_END_OPEN      /* at a jump of the functions, or undecided */
} ix_curve_end;

/* One arc: a polyline in the space of the parameters whose vertices lie on the
 * curve to the accuracy of double. */
typedef struct {
    int n;
    const double *x; /* double[n][unknowns] */
    ix_curve_end start, end;
    int start_singular, end_singular; /* index into singular, or -1 */
    int times; /* 1; 2 .. 4: the function (of 2 unknowns) vanishes along it as
                  the power of another does */
} ix_solution_curve;

typedef struct {
    int unknowns, ncurves, nsingular;
    ix_solution_curve *curve;
    ix_solution *singular; /* points where the gradients are dependent, located
                              to their boxes: nodes, cusps, isolated points */
    int *arcs;             /* [nsingular]: arc ends that meet there */
    bool complete; /* false: max_boxes reached, interrupted or crowded; what is
                      open is reported as singular */
    size_t boxes, bytes;
    bool interrupted; /* with the option keep */
    bool crowded;     /* the gradients are dependent along a whole curve, as for
                         a component that counts twice: the singular boxes that
                         cover it are larger than cell */
    bool area;        /* an equation is zero on whole patches, which are
                         singular boxes: the solutions there are no curves */
} ix_solution_curves;

/* The solution set of unknowns - 1 equations (2 to 4 unknowns), and o->checks
 * further relations.
 *
 * Err   as ix_solve
 * Num   every regular arc is found: cells on which one coordinate is proven to
 *       be a parameter of the curve are joined at points of their faces
 * Src   Liang, Mourrain & Pavone 2008; Barton, Elber & Hanniel 2011 */
ix_status ix_solve_curves(ix_ctx *ctx, int neq, const ix_equation *eq,
                          const ix_curves_opts *o,
                          ix_solution_curves *out) IX_MUST_CHECK;
void ix_solution_curves_free(ix_ctx *ctx, ix_solution_curves *c);

/* Moves x[unknowns] onto the solution set of neq equations (1 .. unknowns) by
 * Newton steps of least length, inside the domain: a vertex of a solution curve
 * after it was interpolated, or a start value of one's own.
 *
 * Err   IX_EARG     more equations than unknowns
 *       IX_EDOMAIN  x is outside the domain
 *       IX_EUNABLE  no convergence (x is the last point), or the gradients are
 *                   dependent there
 * Num   a regular point is reached to a few units in the last place */
ix_status ix_solve_refine(ix_ctx *ctx, int neq, const ix_equation *eq,
                          double *x) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
