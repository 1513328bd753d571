/* plugin.h - script functions from outside: the interface of plug-ins.
 *
 * A plug-in is a shared object with one function, ix_plugin_init. The program
 * calls it once, with a table of what it offers (the host), and the function
 * registers rows: each makes a script function with a name, a typed signature,
 * a summary and an example. From then on they are checked, documented and
 * listed like all others; the program's own operators (irit_ext/ops) are
 * registered through the same table.
 *
 *     static ix_status twice(const ix_host *h, ix_call *c)
 *     {
 *         return h->ret_num(c, 2 * h->arg_num(c, 0));
 *     }
 *     static const ix_plugin_row rows[] = {
 *         {"TWICE", "x:num -> num", "Twice a number.", "y = twice(3);", twice,
 *          0, 0},
 *         {0}};
 *     ix_status ix_plugin_init(const ix_host *h, ix_registry *r)
 *     {
 *         return h->add(r, IX_PLUGIN_VERSION, rows);
 *     }
 *
 * The library's own functions (ix_mv_..., ix_sym_..., ix_evolute, ...) are
 * called directly: the program that loads the plug-in has them, so it is not
 * linked with the library. docs/plugins.md is the guide.
 *
 * The table only ever grows at its end: a plug-in that was built with an older
 * version of this header works with a newer program. */
#ifndef IRITX_PLUGIN_H
#define IRITX_PLUGIN_H

#include "iritx/object.h"
#include "iritx/ops.h"
#include "iritx/solve.h"

#ifdef __cplusplus
extern "C" {
#endif

#define IX_PLUGIN_VERSION 1

typedef struct ix_host ix_host;
typedef struct ix_call ix_call;         /* one call of a script function */
typedef struct ix_registry ix_registry; /* where rows are registered */

/* A script function. The arguments fit the signature when it is called. It
 * fetches them, computes, and ends with one of the ret_... functions, which
 * gives the call its value. A failure is returned as a status with a message,
 * to which the program adds file, line, column, the function's name and the
 * argument's number: an ix_... function's own, or that of fail and arg_fail. */
typedef ix_status (*ix_plugin_fn)(const ix_host *h, ix_call *c);

/* Signature: "name:types name:types [name:types] -> type"; types are words
 * joined by "|":
 *   any num bool str point vector plane ctlpt matrix list poly curve surface
 *   trimsrf trivar trisrf model mv instance
 *   pv (point or vector)  pt3 (point, vector or ctlpt)
 *   freeform (curve surface trivar mv)  geom (anything drawable)
 * [x:num] is optional and stands last; "x:any..." takes any number of further
 * arguments; "-> nothing" makes a procedure. */
typedef struct {
    const char *name; /* upper case letters, digits, underscores */
    const char *signature;
    const char *summary; /* one sentence or two, for help and the reference */
    const char *example; /* a script that runs, in one line */
    ix_plugin_fn fn;
    unsigned flags; /* IX_PLUGIN_... */
    int chapter;    /* of the reference; 0: that of plug-ins */
} ix_plugin_row;

/* A failure prints its message and gives no value; the script goes on. */
#define IX_PLUGIN_SOFT 1u

/* What the program offers. All texts, objects and arrays that are passed are
 * copied or counted as said; "borrowed" results stay valid until the script
 * function returns. i counts arguments from 0. */
struct ix_host {
    unsigned version; /* IX_PLUGIN_VERSION of the program */
    size_t size;      /* sizeof(ix_host) there */

    /* Registers all rows up to one with the name NULL, or none of them; only
     * inside ix_plugin_init. version: IX_PLUGIN_VERSION. The rows must stay
     * where they are. Err IX_EARG a row that is malformed (the message says
     * how), a name that exists; IX_EUNABLE a version that is newer than the
     * program's, too many functions. */
    ix_status (*add)(ix_registry *r, unsigned version,
                     const ix_plugin_row *rows);

    /* --- the call -------------------------------------------------------- */
    ix_ctx *(*ctx)(const ix_call *c); /* for functions of the library */
    /* Records a message in one line and returns st; about argument i, with
     * IX_EARG. */
    ix_status (*fail)(ix_call *c, ix_status st, const char *fmt, ...)
        IX_PRINTF(3, 4);
    ix_status (*arg_fail)(ix_call *c, int i, const char *fmt, ...)
        IX_PRINTF(3, 4);
    /* A warning on standard error with the place in the script. */
    void (*remark)(ix_call *c, const char *fmt, ...) IX_PRINTF(2, 3);
    /* n items of memory, aligned, unset, gone when the function returns. NULL:
     * there is none (the message is recorded: return IX_ENOMEM). */
    void *(*scratch)(ix_call *c, size_t n, size_t size);
    /* IX_ECANCEL once the user wants to stop; in long loops of your own. */
    ix_status (*poll)(ix_call *c);
    /* The state "DegreeForm", and joins as BspProdMethod asks for. */
    ix_op_opts (*op_opts)(const ix_call *c);
    /* What polylines may be away from a curve that they stand for, as a part of
     * its domain: from the variable RESOLUTION. */
    double (*contour_tol)(const ix_call *c);
    /* The number that a script's variable holds, else dflt. */
    double (*var_num)(const ix_call *c, const char *name, double dflt);

    /* --- arguments ------------------------------------------------------- */
    int (*argc)(const ix_call *c);
    ix_obj *(*arg)(const ix_call *c, int i); /* borrowed */
    double (*arg_num)(const ix_call *c, int i);
    bool (*arg_bool)(const ix_call *c, int i);
    /* Rounded to an integer of lo .. hi. Err IX_EARG. */
    ix_status (*arg_int)(ix_call *c, int i, int lo, int hi, int *out);
    const char *(*arg_str)(const ix_call *c, int i); /* borrowed */
    /* x, y, z of a point, vector or control point. Err IX_EARG. */
    ix_status (*arg_pt3)(ix_call *c, int i, double p[3]);
    const ix_mv *(*arg_mv)(const ix_call *c, int i); /* borrowed */
    /* COL, ROW, DEPTH (or 0, 1, ...) as a direction below ndirs. Err IX_EARG */
    ix_status (*arg_dir)(ix_call *c, int i, int ndirs, int *dir);
    /* E1 .. P18 as a number of coordinates and a weight. Err IX_EARG. */
    ix_status (*arg_pttype)(ix_call *c, int i, int *ncoords, bool *rational);
    /* The freeforms in a list, all of one type (IX_OBJ_UNDEF: any one);
     * borrowed. Err IX_EARG, IX_ENOMEM. */
    ix_status (*arg_mvs)(ix_call *c, int i, ix_obj_type type, int *n,
                         const ix_mv ***out);
    /* The numbers in a list; borrowed. Err IX_EARG, IX_ENOMEM. */
    ix_status (*arg_nums)(ix_call *c, int i, int *n, double **out);

    /* --- the result ------------------------------------------------------ */
    /* Each gives the call its value and returns IX_OK; IX_ENOMEM. o: takes over
     * the reference; NULL (no memory): IX_ENOMEM. */
    ix_status (*ret)(ix_call *c, ix_obj *o);
    ix_status (*ret_num)(ix_call *c, double v);
    /* Takes over m. like: as an object of the type of that argument; negative:
     * curve, surface, trivariate or multivariate by its directions. */
    ix_status (*ret_mv)(ix_call *c, int like, const ix_mv *m);
    /* The same with the attribute GeomType (GEOM_RULED_SRF, ... of scripts). */
    ix_status (*ret_geom)(ix_call *c, int like, const ix_mv *m, int geom_type);
    /* A list that was filled with status st: released if that is not IX_OK. */
    ix_status (*ret_list)(ix_call *c, ix_obj *list, ix_status st);
    /* Curves over the parameters of the surface m as polylines on it, or in
     * the parameter plane (m NULL); no value if there is none. */
    ix_status (*ret_contours)(ix_call *c, const ix_solution_curves *s,
                              const ix_mv *m);
    ix_obj *(*result)(const ix_call *c); /* what ret_... set; borrowed */
    /* The attributes Poles of o: the parameters where the weight of m (a curve,
     * or a surface whose weight does not depend on direction 1) is zero, and
     * Finite: the ranges (lo, hi) between them. Not set if there are none. */
    ix_status (*set_poles)(ix_call *c, ix_obj *o, const ix_mv *m);

    /* --- objects --------------------------------------------------------- */
    /* Makers return a new reference, NULL without memory, message recorded. */
    ix_obj *(*number)(ix_ctx *ctx, double v);
    ix_obj *(*string)(ix_ctx *ctx, const char *s, size_t len);
    ix_obj *(*point)(ix_ctx *ctx, const double p[3]);
    ix_obj *(*vector)(ix_ctx *ctx, const double v[3]);
    ix_obj *(*freeform)(ix_ctx *ctx, ix_obj_type type,
                        const ix_mv *m); /* takes over m, also if it fails */
    ix_obj *(*list)(ix_ctx *ctx);        /* empty */
    /* Appends; takes over o, also if it fails. IX_ENOMEM, also if o or list is
     * NULL: so makers and list_add nest. */
    ix_status (*list_add)(ix_ctx *ctx, ix_obj *list, ix_obj *o);
    ix_status (*list_add_num)(ix_ctx *ctx, ix_obj *list, double v);
    ix_obj *(*ref)(ix_obj *o);
    void (*unref)(ix_ctx *ctx, ix_obj *o); /* NULL: nothing */
    ix_obj_type (*type)(const ix_obj *o);
    int (*list_size)(const ix_obj *list);
    ix_obj *(*list_item)(const ix_obj *list, int i); /* borrowed */
    double (*num_of)(const ix_obj *number);
    const char *(*str_of)(const ix_obj *string);   /* borrowed */
    const ix_mv *(*mv_of)(const ix_obj *freeform); /* borrowed; NULL: none */
    /* Attributes; o keeps a reference to an object that is one. Err IX_ENOMEM.
     */
    ix_status (*attr_set_int)(ix_ctx *ctx, ix_obj *o, const char *name,
                              long long v);
    ix_status (*attr_set_num)(ix_ctx *ctx, ix_obj *o, const char *name,
                              double v);
    ix_status (*attr_set_str)(ix_ctx *ctx, ix_obj *o, const char *name,
                              const char *v);
    ix_status (*attr_set_obj)(ix_ctx *ctx, ix_obj *o, const char *name,
                              ix_obj *v);
    /* A number: integer, real, or text that is one; false: there is none. */
    bool (*attr_num)(const ix_obj *o, const char *name, double *v);
};

/* What a plug-in defines. Err: its own, or what add gives; then nothing is
 * registered and the program says why. */
#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
ix_status
ix_plugin_init(const ix_host *h, ix_registry *r);

#ifdef __cplusplus
}
#endif
#endif
