/* patches.h - equations decomposed into Bernstein patches; what the system and
 * the curve solver both start from. */
#ifndef SOLVE_PATCHES_H
#define SOLVE_PATCHES_H

#include "bsp/spans.h"
#include "solve/box.h"

typedef struct {
    ix_spans sp[IX_MAX_UNKNOWNS]; /* common breakpoints and degrees */
    ix__shape whole;              /* of one decomposed equation */
    double *c[IX__MAX_EQS];       /* equalities first; largest entry 1 */
    double err[IX__MAX_EQS];      /* of every coefficient, absolute */
} ix__patches;

/* The rules of ix_solve for its arguments; missing: by how many the equalities
 * may be fewer than the unknowns. */
ix_status ix__patches_check(ix_ctx *ctx, int neq, const ix_equation *eq,
                            int missing) IX_MUST_CHECK;
/* Everything in scratch. */
ix_status ix__patches_make(ix_ctx *ctx, int neq, const ix_equation *eq,
                           ix__patches *p) IX_MUST_CHECK;
/* The shape of one patch, and the lengths of the whole domain. */
void ix__patches_shape(const ix__patches *p, ix__shape *s, double *edge);
/* Copies patch idx[] of all nall relations, of shape h, into b. */
void ix__patches_take(const ix__patches *p, const ix__shape *h, int nall,
                      const int *idx, ix__box *b);
/* Counts idx[n] on; false after the last patch. */
bool ix__patches_next(const ix__patches *p, int n, int *idx);

#endif
