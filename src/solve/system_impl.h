/* system_impl.h - shared by the parts of the system solver. */
#ifndef SOLVE_SYSTEM_IMPL_H
#define SOLVE_SYSTEM_IMPL_H

#include "solve/box.h"
#include "solve/small.h"

/* The system on one patch: n unknowns, the first n equalities as the square
 * system, the rest of the relations as checks. */
typedef struct {
    ix__task t;
    int n;
    struct ix__search *search; /* working memory, made for the first patch */
} ix__system;

/* All solutions in b, added to found. */
ix_status ix__system_search(ix__system *sys, const ix__box *b,
                            ix__found *found) IX_MUST_CHECK;

/* The equations after preconditioning, and what they are worth. */
typedef struct {
    ix__shape shape;
    double *c; /* [size] */
    double err, mag;
} ix__combined;

/* g[n] with orthogonal mean gradients, the shortest of them that of g[weak]:
 * out becomes g[weak] - sum l_k g_k, k != weak, with linear l_k that cancel its
 * mean second derivatives in all directions but that of the null vector of the
 * Jacobian. out->c has room for the tensor with one degree more in each
 * direction, work for two of them. */
void ix__second_order(int n, const ix__combined *g, int weak, ix__mat grad,
                      double *work, ix__combined *out);

#endif
