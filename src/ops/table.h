/* table.h - the operators whose results are compared in all degree forms, by
 * the name that scripts call them. Whoever adds an operator adds a row. */
#ifndef OPS_TABLE_H
#define OPS_TABLE_H

#include "iritx/ops.h"

enum { IX_OP_MAX_MVS = 2, IX_OP_MAX_NUMS = 4 };

typedef struct {
    const ix_mv *mv[IX_OP_MAX_MVS];
    double num[IX_OP_MAX_NUMS];
} ix_op_args;

typedef struct {
    const char *name;         /* upper case */
    int ndirs[IX_OP_MAX_MVS]; /* directions of each multivariate; 0: none */
    int nnums;                /* numbers that follow */
    unsigned forms;           /* bit f: degree form f is something of its own */
    ix_status (*run)(ix_ctx *ctx, const ix_op_args *a, const ix_op_opts *o,
                     ix_report *rep, ix_mv **out);
} ix_op;

/* Rows until name is NULL. */
extern const ix_op ix__ops[];
/* By name, without case; NULL if there is none. */
const ix_op *ix__op_find(const char *name);

#endif
