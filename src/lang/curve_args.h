/* curve_args.h - arguments and results that curve functions share. */
#ifndef LANG_CURVE_ARGS_H
#define LANG_CURVE_ARGS_H

#include "iritx/geom.h"
#include "lang/builtin.h"

/* A PARAM_* constant. */
ix_status ix__arg_param(ix_call *c, int i, ix_param *out) IX_MUST_CHECK;
bool ix__is_param(double code); /* is it one? */

/* A list of numbers inside argument i, into scratch. */
ix_status ix__arg_nums_of(ix_call *c, int i, const ix_obj *list, int *n,
                          const double **out) IX_MUST_CHECK;
/* A list of exactly n numbers. */
ix_status ix__arg_nums_n(ix_call *c, int i, int n,
                         const double **out) IX_MUST_CHECK;
/* A list of points, vectors, control points as double[n][3], projected and
 * padded; the list's elements stay what they are. */
ix_status ix__arg_points3(ix_call *c, int i, int *n,
                          double **out) IX_MUST_CHECK;

/* A list of curves; takes over what crvs holds. */
ix_status ix__ret_crvs(ix_call *c, ix_crvs *crvs) IX_MUST_CHECK;
/* As ix__ret_mv for an edited argument i: it keeps its GeomType. */
ix_status ix__ret_edited(ix_call *c, int i, const ix_mv *m) IX_MUST_CHECK;

#endif
