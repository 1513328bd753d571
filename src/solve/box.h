/* box.h - boxes of parameters with the tensors of all relations on them, and
 * the search by halving that the systems and the curves have in common. */
#ifndef SOLVE_BOX_H
#define SOLVE_BOX_H

#include "base/ctx.h"
#include "iritx/solve.h"
#include "solve/tensor.h"

#define IX__MAX_EQS (3 * IX_MAX_UNKNOWNS)

typedef struct {
    double *c;               /* [nall][size] */
    double err[IX__MAX_EQS]; /* bounds the error of every coefficient */
    double mag[IX__MAX_EQS]; /* bounds every |coefficient| */
    double lo[IX_MAX_UNKNOWNS], hi[IX_MAX_UNKNOWNS];
    int cuts;  /* how often an end was moved, which commits roundings */
    int fresh; /* cuts at the last ix__box_refresh */
} ix__box;

/* Solutions found so far, in a growing scratch array. */
typedef struct {
    ix_ctx *ctx;
    ix_solution *sol;
    int n, cap;
} ix__found;

/* What a search knows of its task. All tensors have one shape, each scaled so
 * that its largest coefficient is about 1. */
typedef struct {
    ix_ctx *ctx;
    ix__shape shape;
    int neq, nall; /* equalities first, then relations f >= 0 */
    double cell;   /* smallest edge, as a part of the domain's; grows when
                      undecided boxes crowd (ix__open_box) */
    size_t max_boxes, boxes;
    double edge[IX_MAX_UNKNOWNS]; /* lengths of the whole domain */
    int open;                     /* undecided boxes reported */
    int crowd;                    /* so many of them count as a crowd; 0: 64 */
    bool keep;                    /* on interruption what is open is reported */
    bool interrupted;             /* that has happened */
    bool crowded;
} ix__task;

/* The boxes still to be looked at, the next one on top. */
typedef struct {
    ix__box *box; /* [IX__MAX_DEPTH] */
    int top;      /* -1: none */
    int made;     /* boxes that have tensors */
} ix__stack;

#define IX__MAX_DEPTH 400

/* Makes mag. */
void ix__box_measure(const ix__task *t, ix__box *b);
/* False if the signs of some relation exclude the box. Updates mag. */
bool ix__box_signs_allow(const ix__task *t, ix__box *b);
/* The part [a, e] of [0, 1] in direction j. */
void ix__box_cut(const ix__task *t, ix__box *b, int j, double a, double e);
/* Where rounding has eaten up half of the digits, takes the box from the patch
 * at once, which commits the roundings of one cut only, and makes it larger by
 * the uncertainty of its ends. */
void ix__box_refresh(const ix__task *t, const ix__box *patch, ix__box *b);
/* The direction of the longest edge as a part of the domain's, *len. */
int ix__box_longest(const ix__task *t, const ix__box *b, double *len);
double ix__box_part(const ix__task *t, const ix__box *b, int j);

/* By how much the stored ends of a box in direction j may be off: every cut
 * rounds w = hi - lo, a w and lo + a w, that is u (|x| + 3 w) at most, and the
 * widths of all cuts together stay below 4 edges of the domain, as a cut
 * leaves SHRUNK = 0.7 at most. */
double ix__box_drift(const ix__task *t, const ix__box *b, int j);

/* Adds b as an undecided solution. When a crowd of them has come, the smallest
 * size doubles, and so on: isolated solutions, however degenerate, leave few,
 * a common curve of the equations thousands. */
ix_status ix__open_box(ix__task *t, const ix__box *b,
                       ix__found *f) IX_MUST_CHECK;

ix_status ix__found_add(ix__found *f, const ix_solution *s) IX_MUST_CHECK;
/* One solution reported by several boxes becomes one; undecided boxes that
 * touch become one box. Sorted. */
ix_status ix__found_merge(ix__found *f, int n,
                          const double *edge) IX_MUST_CHECK;

ix_status ix__stack_make(const ix__task *t, ix__stack *k) IX_MUST_CHECK;
/* b becomes the only box. */
void ix__stack_start(const ix__task *t, ix__stack *k, const ix__box *b);
/* Halves the top box at `ratio` of direction j, the lower part on top. */
ix_status ix__stack_halve(const ix__task *t, ix__stack *k, int j,
                          double ratio) IX_MUST_CHECK;

/* Calls examine(self), which takes the top box off or replaces it, until the
 * stack is empty. What a reached budget or, with t->keep, an interruption
 * leaves is added to found. */
ix_status ix__stack_run(ix__task *t, ix__stack *k,
                        ix_status (*examine)(void *self), void *self,
                        ix__found *found) IX_MUST_CHECK;

#endif
