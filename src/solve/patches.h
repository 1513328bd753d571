/* patches.h - equations decomposed into Bernstein patches; what the system and
 * the curve solver both start from, and systems whose patches come one by one.
 */
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
/* Divides v^(k-1) out of the first neq equations, where they vanish along an
 * edge v = 0 of the patch to the order k: the same zeros, once each. */
void ix__patch_simple_edges(const ix__shape *s, int neq, ix__box *b);
/* Whether patch idx[] has an upper neighbour in direction j, and all neq
 * equations have the same values on their common face. */
bool ix__patches_joined(const ix__patches *p, const ix__shape *h, int neq,
                        const int *idx, int j);
/* Counts idx[n] on; false after the last patch. */
bool ix__patches_next(const ix__patches *p, int n, int *idx);

/* A system of which only some patches are looked at, the caller knowing that
 * the others hold no solution, and which is never there as a whole. */
typedef struct {
    int n, neq, nall; /* unknowns, equalities, relations */
    ix__shape shape;  /* of every tensor; each equation of size about 1 */
    double edge[IX_MAX_UNKNOWNS]; /* of the whole domain */
    void *self;
    /* Puts the next patch, its place and its errors into b; false: no more. */
    bool (*next)(void *self, ix__box *b);
    /* The patch that holds x. */
    void (*at)(void *self, const double *x, ix__box *b);
} ix__patch_source;

/* As ix_solve. */
ix_status ix__solve_patches(ix_ctx *ctx, const ix__patch_source *src,
                            const ix_solve_opts *o,
                            ix_solutions *out) IX_MUST_CHECK;

#endif
