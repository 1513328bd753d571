/* builtin.h - what a script function is: one row of a table.
 *
 * A row gives the name, the signature as text, a one-line summary, an example
 * and the C function. Argument checks, their messages, --help and the
 * reference pages are generated from it. A primitive has one shape: fetch the
 * arguments (already checked), call the library, return the result.
 *
 * Signature:  "name:types name:types [name:types] ... -> type"
 *   types are words joined by "|":
 *     any num bool str point vector plane ctlpt matrix list poly curve
 *     surface trimsrf trivar trisrf model mv instance
 *     pv (point or vector)  pt3 (point, vector or ctlpt)
 *     freeform (curve surface trivar mv)   geom (anything drawable)
 *   [x:num] is optional, must stand last; "x:any..." takes any number of
 *   further arguments. A result "-> nothing" makes it a statement procedure
 *   (legal only as a complete sub-statement). Bool arguments are numbers. */
#ifndef LANG_BUILTIN_H
#define LANG_BUILTIN_H

#include "iritx/plugin.h"
#include "object/object.h"

typedef struct ix_interp ix_interp; /* lang/interp.h */

struct ix_call {
    ix_interp *in;
    ix_ctx *ctx;
    int argc;
    ix_obj **argv;  /* borrowed; the variables' own boxes where an argument
                       is a variable, so procedures may change them */
    ix_obj *result; /* set by functions: a new reference; NULL = no value */
    int bad_arg;    /* 1-based argument to which a failure refers, 0 none */
};

typedef ix_status (*ix_builtin_fn)(ix_call *c);

enum {
    IX_B_SOFT = IX_PLUGIN_SOFT, /* a failure prints its message, gives no value,
                        and the script goes on (spec/language 9, "soft") */
    IX_B_LIBRARY = 2, /* start-up library: a script may define a function of
                        this name, which then goes first */
    IX_B_LOCAL = 4, /* touches files, commands, the terminal or the script's own
                        variables: not for calls from outside (lang/call.h) */
    IX_B_STATE = 8 /* changes the interpreter's states: a call from outside must
                       happen in the process that keeps them */
};

typedef struct {
    const char *name; /* upper case */
    const char *signature;
    const char *summary; /* one sentence for help and the reference */
    const char *example; /* one runnable script line */
    ix_builtin_fn fn;
    unsigned flags;
    int chapter; /* of the reference: 1 .. 24 as in spec/functions.md */
} ix_builtin;

/* Each builtins_*.c defines one table ended by a row with name NULL;
 * lang/tables.c lists the tables. */
extern const ix_builtin ix__builtins_system[];
extern const ix_builtin ix__builtins_numeric[];
extern const ix_builtin ix__builtins_list[];
extern const ix_builtin ix__builtins_output[];
extern const ix_builtin ix__builtins_attr[];
extern const ix_builtin ix__builtins_analytic[];
extern const ix_builtin ix__builtins_curve[];
extern const ix_builtin ix__builtins_curve_edit[];
extern const ix_builtin ix__builtins_curve_ask[];
extern const ix_builtin ix__builtins_freeform[];
extern const ix_builtin ix__builtins_surface[];
extern const ix_builtin ix__builtins_trivar[]; /* and triangular patches */
extern const ix_builtin ix__builtins_mv[];
extern const ix_builtin ix__builtins_sym[];
extern const ix_builtin ix__builtins_ops[];
extern const ix_builtin ix__builtins_bisect2d[];
extern const ix_builtin ix__builtins_bisect3d[];
extern const ix_builtin ix__builtins_prim[];
extern const ix_builtin ix__builtins_mbisect[];
extern const ix_builtin ix__builtins_degrees[];
extern const ix_builtin ix__builtins_geodesic[];
extern const ix_builtin ix__builtins_poly[];
extern const ix_builtin ix__builtins_tess[];
extern const ix_builtin ix__builtins_distance[];
extern const ix_builtin ix__builtins_meet[];
extern const ix_builtin ix__builtins_solve[];
extern const ix_builtin ix__builtins_offset[];
extern const ix_builtin ix__builtins_enclose[];
extern const ix_builtin ix__builtins_touch[];
extern const ix_builtin ix__builtins_visible[];
extern const ix_builtin ix__builtins_text[];
extern const ix_builtin ix__builtins_envelope[];
extern const ix_builtin ix__builtins_fit[];
extern const ix_builtin ix__builtins_planar[];
extern const ix_builtin ix__builtins_arrange[];
extern const ix_builtin ix__builtins_layout[];
extern const ix_builtin ix__builtins_volume[];
extern const ix_builtin ix__builtins_contact[];
extern const ix_builtin ix__builtins_asymptotic[];
extern const ix_builtin ix__builtins_sign[];
extern const ix_builtin ix__builtins_solid[];   /* and other outsiders */
extern const ix_builtin ix__builtins_startup[]; /* lang/startup.h */

/* --- helpers for primitives --------------------------------------------------
 */
/* Numbers of arguments (already checked to be numbers). */
double ix__arg_num(const ix_call *c, int i); /* i = 0 .. argc-1 */
bool ix__arg_bool(const ix_call *c, int i);  /* |x| >= 1e-5 */
/* Rounded to an integer within [lo, hi], else IX_EARG naming the argument. */
ix_status ix__arg_int(ix_call *c, int i, int lo, int hi,
                      int *out) IX_MUST_CHECK;
const char *ix__arg_str(const ix_call *c, int i);
/* x, y, z of a point, vector or (projected, padded) control point. */
ix_status ix__arg_pt3(ix_call *c, int i, double p[3]) IX_MUST_CHECK;
const ix_mv *ix__arg_mv(const ix_call *c,
                        int i); /* the first of a linked one */
/* COL, ROW, DEPTH to direction 0, 1, 2 < ndirs of argument mvarg; for
 * multivariates a 0-based number. */
ix_status ix__arg_dir(ix_call *c, int i, int ndirs, int *dir) IX_MUST_CHECK;
/* A list of numbers into scratch. */
ix_status ix__arg_nums(ix_call *c, int i, int *n, double **out) IX_MUST_CHECK;
/* Control points, points, vectors (nested = false: a flat list) into axis
 * order double[axes][n] of the smallest type that holds all, in scratch. The
 * list's own elements become control points of that type, as in IRIT. */
ix_status ix__arg_points(ix_call *c, ix_obj *list, int *n, int *ncoords,
                         bool *rational, double **pts) IX_MUST_CHECK;

/* Fails: "element K must be WANT, got ..." about the list of argument i, k
 * 0-based. */
ix_status ix__wrong_element(ix_call *c, int i, int k, const ix_obj *o,
                            const char *want) IX_MUST_CHECK;

/* Results: set c->result; return IX_ENOMEM if the box could not be made. */
ix_status ix__ret(ix_call *c,
                  ix_obj *o) IX_MUST_CHECK; /* takes over; NULL: IX_ENOMEM */
ix_status ix__ret_num(ix_call *c, double v) IX_MUST_CHECK;
/* As an object of the type of argument like (curve stays curve), or by the
 * number of directions when like < 0. Takes over m. */
ix_status ix__ret_mv(ix_call *c, int like, const ix_mv *m) IX_MUST_CHECK;
/* Appends v as a number / takes over o. On a NULL o or list: IX_ENOMEM. */
ix_status ix__list_add_num(ix_ctx *ctx, ix_obj *list, double v) IX_MUST_CHECK;
ix_status ix__list_add(ix_ctx *ctx, ix_obj *list, ix_obj *o) IX_MUST_CHECK;

/* "argument 2 of CBSPLINE: ..." is put in front by the interpreter when
 * bad_arg is set; use  return IX_ARG_FAIL(c, 1, "order %d ...", n). */
#define IX_ARG_FAIL(c, i, ...) \
    ((c)->bad_arg = (i) + 1, IX_FAIL((c)->ctx, IX_EARG, __VA_ARGS__))

#endif
