/* types_impl.h - sets of types, compiled signatures, the operator table.
 *
 * A set of types is a bit mask over ix_obj_type. The static check computes
 * with sets; at run time a set has one member. */
#ifndef LANG_TYPES_IMPL_H
#define LANG_TYPES_IMPL_H

#include "lang/builtin.h"

typedef unsigned ix__types;

#define IX_T(type) (1u << IX_OBJ_##type)
#define IX_T_PV    (IX_T(POINT) | IX_T(VECTOR))
#define IX_T_FREE  (IX_T(CURVE) | IX_T(SURFACE) | IX_T(TRIVAR) | IX_T(MULTIVAR))
#define IX_T_SOLID (IX_T(POLY) | IX_T(SURFACE) | IX_T(TRIMSRF) | IX_T(MODEL))
#define IX_T_GEOM                                                   \
    (IX_T_PV | IX_T_FREE | IX_T_SOLID | IX_T(PLANE) | IX_T(CTLPT) | \
     IX_T(TRISRF) | IX_T(INSTANCE) | IX_T(LIST))
#define IX_T_ANY (((1u << (IX_OBJ_MULTIVAR + 1)) - 1) & ~IX_T(UNDEF))

/* --- signatures ---------------------------------------------------------- */
#define IX_SIG_MAX 24 /* parameters that can be declared one by one */
typedef struct {
    ix__types arg[IX_SIG_MAX];
    int nmin, nmax;   /* nmax -1: any number, of type rest */
    ix__types rest;   /* 0 unless nmax is -1 */
    ix__types result; /* 0: a statement procedure */
} ix__sig;

/* A built-in with its compiled signature. */
typedef struct {
    const ix_builtin *row;
    ix_plugin_fn ext; /* of a plug-in: called instead of row->fn */
    ix__sig sig;
} ix__bi;

/* False if text is not a signature of builtin.h. */
bool ix__sig_parse(const char *text, ix__sig *out);
/* "NAME(a:num, [b:num]) -> curve" into buf; returns buf. */
const char *ix__sig_text(const ix_builtin *row, char *buf, size_t size);
/* The set that argument i (0-based) must be in. */
ix__types ix__sig_arg(const ix__sig *s, int i);
/* "a number", "a curve or a surface", "a value" into buf; returns buf. */
const char *ix__types_text(ix__types t, char *buf, size_t size);

/* --- operators ------------------------------------------------------------ */
typedef enum {
    OP_ADD,
    OP_SUB,
    OP_MUL,
    OP_DIV,
    OP_POW,
    OP_EQ,
    OP_NE,
    OP_LT,
    OP_LE,
    OP_GT,
    OP_GE,
    OP_AND,
    OP_OR,
    OP_ASSIGN,
    OP_NEG,
    OP_NOT
} ix__op;

const char *ix__op_text(ix__op op); /* "+" */
/* The possible result types for operands of these sets; 0: none fits. For
 * unary operators l is the operand, r is ignored. */
ix__types ix__op_types(ix__op op, ix__types l, ix__types r);
/* What may stand on the right of op when l is on the left. */
ix__types ix__op_right(ix__op op, ix__types l);
/* Records the message that op does not take these operands: IX_EARG. */
ix_status ix__op_mismatch(ix_interp *in, ix__op op, ix__types l, ix__types r);
/* Applies op to two boxes of any types (both numbers are the evaluator's own
 * affair); *out is a new reference. Err IX_EARG types, and what the operation
 * itself gives. */
ix_status ix__op_apply(ix_interp *in, ix__op op, ix_obj *l, ix_obj *r,
                       ix_obj **out) IX_MUST_CHECK;
bool ix__truth(double x); /* conditions: |x| >= 1e-5 */
ix_status ix__op_negate(ix_interp *in, ix_obj *a, ix_obj **out) IX_MUST_CHECK;
/* Two numbers; comparisons within CmpObjEps. Err IX_EARG division by 0. */
ix_status ix__op_numbers(ix_interp *in, ix__op op, double l, double r,
                         double *out) IX_MUST_CHECK;

/* --- tables --------------------------------------------------------------- */
/* A built-in by name (any case) with its signature; NULL: unknown. */
const ix__bi *ix__bi_find(const char *name);
/* The same while the index is being made. */
const ix__bi *ix__bi_find_so_far(const char *name);
/* Adds n checked rows, whose names are new, to those of the tables. Any number
 * of threads may look names up meanwhile. Err IX_EUNABLE no room. */
ix_status ix__bi_append(ix_ctx *ctx, const ix_plugin_row *rows,
                        int n) IX_MUST_CHECK;
/* Up to three known functions, or variables and constants, with names near to
 * name, as "A, B or C" into buf; false if none is near. */
bool ix__names_near(ix_interp *in, const char *name, char *buf, size_t size);
bool ix__vars_near(ix_interp *in, const char *name, char *buf, size_t size);
/* A predefined constant by its upper-case name. */
bool ix__constant_find(const char *name, double *v);
const char *ix__constant_at(size_t i, double *v); /* NULL past the last */

#endif
