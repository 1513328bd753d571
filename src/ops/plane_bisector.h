/* plane_bisector.h - runs along a border made into the pieces of a bisector. */
#ifndef OPS_PLANE_BISECTOR_H
#define OPS_PLANE_BISECTOR_H

#include "iritx/ops_plane.h"
#include "ops/plane_walk.h"

/* One of the two objects: its curves (two coordinates), or the point. */
typedef struct {
    const ix__set *set;
    int n;
    const ix_mv *const *crv; /* NULL: the point */
    double point[2];
} ix__object;

/* The pieces of all runs. Err those of exact pieces, IX_ENOMEM. */
ix_status ix__bisector_make(ix_ctx *ctx, const ix__walked *w,
                            const ix__object obj[2], const ix_frame *frame,
                            ix_bisector *out) IX_MUST_CHECK;
/* Fills p->exact of a piece that has its vertices. Err those of
 * ix_pt_crv_bisector. */
ix_status ix__bisector_exact(ix_ctx *ctx, const ix__walked *w,
                             const ix__object obj[2], const ix__run *r,
                             ix_bisector_piece *p) IX_MUST_CHECK;
/* Places from which every part of the bisector of both objects can be reached
 * if they meet and each is connected; scratch.
 * Err those of ix_crv_crv_meet */
ix_status ix__plane_seeds(ix_ctx *ctx, const ix__object obj[2], int *n,
                          ix__place **out) IX_MUST_CHECK;
/* The user's parameters of both feet. */
double ix__own_parameter(const ix__set *s, const ix__sample *a);
double ix__other_parameter(const ix__set *s, const ix__sample *a);
/* A curve with two coordinates moved by f q. */
ix_status ix__plane_moved(ix_ctx *ctx, const ix_mv *m, double f,
                          const double q[2], ix_mv **out) IX_MUST_CHECK;
/* The tolerance of the polylines, relative. Err IX_EARG negative, NaN. */
ix_status ix__bisector_tol(ix_ctx *ctx, double tol, double *out) IX_MUST_CHECK;
/* IX_EARG unless all are curves with at least two coordinates. */
ix_status ix__plane_check(ix_ctx *ctx, int n,
                          const ix_mv *const *crv) IX_MUST_CHECK;
/* Copies in scratch of n curves with two coordinates, released by the caller
 * with ix__mv_unref_all. */
ix_status ix__plane_curves(ix_ctx *ctx, int n, const ix_mv *const *crv,
                           ix_mv ***out) IX_MUST_CHECK;

#endif
