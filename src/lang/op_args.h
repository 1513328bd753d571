/* op_args.h - what the functions of the geometric operators share: their
 * options, lists of operands, remarks on results. */
#ifndef LANG_OP_ARGS_H
#define LANG_OP_ARGS_H

#include "iritx/ops.h"
#include "lang/builtin.h"

/* The state "DegreeForm", and BspProdMethod 0 as C0 joins. */
ix_op_opts ix__op_opts(const ix_call *c);

/* A freeform, or a point. */
typedef struct {
    const ix_mv *mv; /* NULL: the point */
    double pt[3];
} ix_operand;
/* Argument i is a list of n of them, at most one a point, which then goes last;
 * the freeforms are of the given type. what says in messages what is needed. */
ix_status ix__arg_operands(ix_call *c, int i, ix_obj_type type, int n,
                           const char *what, ix_operand *out) IX_MUST_CHECK;

/* The attributes Poles of the result: the parameters where the weight of m (a
 * curve, or a surface whose weight does not depend on direction 1) is zero, and
 * Finite: the ranges (lo, hi) between them. Not set if there are none. */
ix_status ix__tell_poles(ix_call *c, ix_obj *result,
                         const ix_mv *m) IX_MUST_CHECK;

#endif
