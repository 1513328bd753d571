/* prims_freeform.h - primitives that surfaces, trivariates and multivariates
 * share, whose tables differ in names only: the first argument is the
 * freeform, the second a direction. */
#ifndef LANG_PRIMS_FREEFORM_H
#define LANG_PRIMS_FREEFORM_H

#include "lang/builtin.h"

ix_status ix__prim_region(ix_call *c);    /* (m, dir, t0, t1) */
ix_status ix__prim_reparam(ix_call *c);   /* (m, dir, t0, t1) */
ix_status ix__prim_refine(ix_call *c);    /* (m, dir, replace, knots) */
ix_status ix__prim_raise(ix_call *c);     /* (m, dir, order) */
ix_status ix__prim_divide(ix_call *c);    /* (m, dir, t) */
ix_status ix__prim_derive(ix_call *c);    /* (m, dir): rational by quotients,
                                             multivariates axis by axis */
ix_status ix__prim_integrate(ix_call *c); /* (m, dir) */
ix_status ix__prim_fix(ix_call *c);       /* (m, dir, t) */
ix_status ix__prim_layer(ix_call *c);     /* (m, dir, index) */
ix_status ix__prim_morph(ix_call *c);     /* (m1, m2, blend) */
ix_status ix__prim_moebius(ix_call *c);   /* (m, ratio, dir) */
ix_status ix__prim_edit(ix_call *c);      /* (m, ctlpt, index ...) */
ix_status ix__prim_eval(ix_call *c);      /* (m, t ...) or (m, list) */
ix_status ix__prim_layers(ix_call *c);    /* (list, order, kv): one direction
                                             more than the elements have */
ix_status ix__prim_skin(ix_call *c);      /* (list, order, kv, param): the same
                                             through all elements */

#endif
