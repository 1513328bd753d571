/* prims_surface.h - primitives of surfaces that the table of
 * builtins_surface.c takes from other files: about existing surfaces, and
 * about trimmed ones. */
#ifndef LANG_PRIMS_SURFACE_H
#define LANG_PRIMS_SURFACE_H

#include "lang/builtin.h"

/* prims_srf_edit.c */
ix_status ix__prim_smerge(ix_call *c);   /* (s1, s2, dir, same) */
ix_status ix__prim_sreverse(ix_call *c); /* (s) */
ix_status ix__prim_sreparam(ix_call *c); /* (s, dir, t0, t1) */
ix_status ix__prim_snormal(ix_call *c);  /* (s, u, v) */
ix_status ix__prim_snrmlsrf(ix_call *c); /* (s) */
ix_status ix__prim_stangent(ix_call *c); /* (s, dir, u, v, normalize) */
ix_status ix__prim_nrmlcone(ix_call *c); /* (s) */
ix_status ix__prim_svolume(ix_call *c);  /* (s, method, eval) */
ix_status ix__prim_smoments(ix_call *c); /* (s, order, axis1, axis2, eval) */

/* prims_trim.c */
ix_status ix__prim_trimsrf(ix_call *c);     /* (s, curves, has_upper) */
ix_status ix__prim_strimsrf(ix_call *c);    /* (ts) */
ix_status ix__prim_ctrimsrf(ix_call *c);    /* (ts, param) */
ix_status ix__prim_trmsrfs(ix_call *c);     /* (s, contours) */
ix_status ix__prim_trim_region(ix_call *c); /* (ts, dir, t0, t1) */
ix_status ix__prim_trim_divide(ix_call *c); /* (ts, dir, t) */
/* A copy of t whose surface is srf and whose parameter curves went through
 * the matrix; takes over nothing. */
ix_status ix__trim_mapped(ix_ctx *ctx, const ix_trimsrf *t, const ix_mv *srf,
                          const double mat[16], ix_trimsrf **out) IX_MUST_CHECK;

#endif
