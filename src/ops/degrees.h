/* degrees.h - one operator built in one degree form, and what came out: the
 * rows of the tables that compare forms. */
#ifndef OPS_DEGREES_H
#define OPS_DEGREES_H

#include "ops/table.h"

/* The forms of ix_degree_form, and minimal with common factors and leading
 * terms removed that the special position leaves (ix_sym_reduce). */
enum { IX__FORM_REDUCED = 4, IX__NFORMS };
const char *ix__form_name(int form); /* "minimal", ..., "reduced" */

typedef struct {
    int ndirs;
    int degree[IX_MAX_DIRS], length[IX_MAX_DIRS];
    size_t npts;
    double residual; /* NaN: not measured. Of the reduced form at most: the
                        minimal one's and the largest change */
    double seconds;  /* without the report */
} ix_degree_row;

/* The row of the table for this name and these multivariates, nmvs of them;
 * NULL if there is none. */
const ix_op *ix__op_for(const char *name, int nmvs, const ix_mv *const *mv);
/* Numbers that an operator gets if none are given. */
void ix__op_defaults(const ix_op *op, double *num);
/* True if the form is something of its own for op; reduced always is. */
bool ix__op_has_form(const ix_op *op, int form);

/* Err those of the operator. */
ix_status ix__degree_row(ix_ctx *ctx, const ix_op *op, const ix_op_args *a,
                         int form, ix_degree_row *out) IX_MUST_CHECK;

#endif
