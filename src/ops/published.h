/* published.h - the polynomials of Chen, Riesenfeld & Cohen 2005, (2.1), in
 * their formal degrees:
 *
 *   D1 = p'w - p w'   D2 = p''w - p w''   D3 = p'''w - p w'''
 *   D21 = p''w' - p'w''
 *
 * For polynomial curves these are p', p'', p''' and 0. */
#ifndef OPS_PUBLISHED_H
#define OPS_PUBLISHED_H

#include "ops/curve.h"

typedef struct {
    ix_form d1, d2, d3, d21; /* d21 of rational curves only */
    ix_form b;               /* D1 x D2; in the plane det(D1, D2), one row */
    ix_form q;               /* |D1|^2 */
} ix_published;
ix_status ix__published_of(ix_ctx *ctx, const ix_curve *c,
                           ix_published *out) IX_MUST_CHECK;
/* det(D1, D2, D3) of a space curve. */
ix_status ix__published_torsion(ix_ctx *ctx, const ix_published *p,
                                ix_form *out) IX_MUST_CHECK;

#endif
