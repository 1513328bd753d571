/* cdt.h - triangulations of a square that contain given edges, each with a
 * parity: how often curves that bound a region run along it, modulo 2.
 *
 * Points are integers, so that all signs are exact: orientations fit into 64
 * bits, in-circle tests into 128. Points are inserted one by one, with Delaunay
 * flips (Lawson 1977); edges by flips of what they cross (Sloan 1993). Edges
 * that cross each other get a common point, rounded. All is in scratch. */
#ifndef MV_CDT_H
#define MV_CDT_H

#include "base/ctx.h"

/* The square is [0, IX__CDT_SIDE]^2. */
enum { IX__CDT_BITS = 30, IX__CDT_SIDE = 1 << IX__CDT_BITS };

typedef struct {
    int32_t x, y;
} ix__cdt_point;

/* Corners counter-clockwise. Side k lies opposite of corner k; n[k] is the
 * triangle behind it, -1 at the square's border; odd[k] its parity. */
typedef struct {
    int v[3], n[3];
    bool odd[3];
} ix__cdt_tri;

typedef struct {
    ix_ctx *ctx;
    int npts, ntris, cap; /* room for cap points, 2 cap triangles */
    ix__cdt_point *p;     /* 0 .. 3: the square's corners, counter-clockwise */
    ix__cdt_tri *t;
    int *at; /* [npts]: a triangle at each point */
    int last;
    int crossings; /* that may still be added */
} ix__cdt;

/* The square, two triangles. */
ix_status ix__cdt_init(ix_ctx *ctx, int npts, ix__cdt *c) IX_MUST_CHECK;
/* Adds a point, or finds it: *id. */
ix_status ix__cdt_point_at(ix__cdt *c, ix__cdt_point p, int *id) IX_MUST_CHECK;
/* Changes the parity of the edges that lead from a to b. Those along the
 * square's border stay on it; no points are added there. Err IX_EUNABLE far
 * more crossings than edges. */
ix_status ix__cdt_toggle(ix__cdt *c, int a, int b) IX_MUST_CHECK;
/* The triangle and side of the border edge from point v on, counter-clockwise
 * around the square. */
int ix__cdt_border(const ix__cdt *c, int v, int *side);

#endif
