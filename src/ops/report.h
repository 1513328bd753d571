/* report.h - filling in what an operator tells of its result. */
#ifndef OPS_REPORT_H
#define OPS_REPORT_H

#include "iritx/ops.h"

/* Form, orders; the residual is NaN until measured. rep may be NULL. */
void ix__report_init(ix_report *rep, ix_degree_form form, const ix_mv *result);
/* The form of the options, minimal by default; IX_EARG if there is no such. */
ix_status ix__form_of_opts(ix_ctx *ctx, const ix_op_opts *o,
                           ix_degree_form *out) IX_MUST_CHECK;

/* The i-th parameters of a 5 x 5 grid inside the domain of a surface. */
enum { IX__PLACES = 25 };
void ix__report_place(const ix_mv *srf, int i, double t[2]);

/* Calls fn at nine parameters inside the domain of direction 0 of crv, with
 * derivatives 0 .. 3 in three coordinates and the weight; parameters at poles
 * are left out. fn adds to *worst. */
typedef struct {
    double t, w, x[4][3];
} ix_probe;
typedef ix_status (*ix__probe_fn)(ix_ctx *ctx, const ix_probe *at,
                                  const void *arg, double *worst);
ix_status ix__probe(ix_ctx *ctx, const ix_mv *crv, ix__probe_fn fn,
                    const void *arg, double *worst) IX_MUST_CHECK;
/* Makes m the result in *out; a report says how far, by fn, it is from its
 * definition. Takes over m, which is released on an error. */
ix_status ix__report_probed(ix_ctx *ctx, const ix_mv *crv, ix_degree_form form,
                            ix__probe_fn fn, const void *arg, const char *how,
                            ix_report *rep, ix_mv *m,
                            ix_mv **out) IX_MUST_CHECK;

#endif
