/* pt_crv.h - a curve and a point Q in the frame of the curve, and the forms of
 * their bisectors.
 *
 * With x = p / w, r = p - w Q and D = p'w - pw' (ops/curve.h), a point B = Q +
 * b is on the normal line or plane of x, and on the line or plane that divides
 * x - Q at a right angle in the ratio alpha : 1 - alpha from Q's end, where
 *
 *   w D.b = r.D        w r.b = (1 - alpha) |r|^2
 *
 * Both are homogeneous: degrees d and 2d - 2 of r and D and the products on
 * the right add up to the lowest degrees of all results. */
#ifndef OPS_PT_CRV_H
#define OPS_PT_CRV_H

#include "ops/curve.h"
#include "ops/report.h"

typedef struct {
    ix_curve c;
    double q[3];       /* in the frame */
    ix_form r, rd, rr; /* r; r.D; (1 - alpha) |r|^2 */
    ix_extent *er;     /* of r */
} ix_pt_crv;

/* dim 2 (kind IX__CURVE_FLAT) or 3 (IX__CURVE_SPACE) numbers of q.
 * Err those of ix__curve_load; IX_EARG q or alpha not finite; IX_EDOMAIN a
 * span is a point. */
ix_status ix__pt_crv_load(ix_ctx *ctx, const ix_mv *crv, ix__curve_kind kind,
                          const double *q, double alpha, bool simplify,
                          ix_pt_crv *out) IX_MUST_CHECK;
/* IX_EDOMAIN if D and r are parallel on a whole span: cross is a form of their
 * vector product. */
ix_status ix__pt_crv_check(ix_ctx *ctx, const ix_pt_crv *c,
                           const ix_form *cross) IX_MUST_CHECK;

/* *x = n + w Q with the rows of n: over w, the point Q + n / w. *x may be n,
 * with its coefficients. */
ix_status ix__pt_crv_from_point(ix_ctx *ctx, const ix_pt_crv *c,
                                const ix_form *n, const ix_form *w,
                                ix_form *x) IX_MUST_CHECK;

/* N with D x r = w N, of degree 2d - 2: the direction of the lines of centres
 * in space. Err as ix__pt_crv_check. */
ix_status ix__pt_crv_ruling(ix_ctx *ctx, const ix_pt_crv *c,
                            ix_form *out) IX_MUST_CHECK;

/* w f; a copy if w is 1. */
ix_status ix__pt_crv_weigh(ix_ctx *ctx, const ix_pt_crv *c, const ix_form *f,
                           ix_form *out) IX_MUST_CHECK;

/* What a point of a result has to satisfy, for ix__report_probed. */
typedef struct {
    const ix_mv *m; /* the result; its further parameters are ts */
    const double *q;
    double alpha;
} ix_pt_crv_probe;
/* Distance of b from both lines or planes, relative to the distances. */
void ix__pt_crv_residual(const ix_probe *at, const double b[3],
                         const ix_pt_crv_probe *arg, double *worst);

#endif
