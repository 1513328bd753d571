/* poly_rows.h - polygons between moved copies of polygons or polylines. */
#ifndef LANG_POLY_ROWS_H
#define LANG_POLY_ROWS_H

#include "lang/builtin.h"

/* Copy k of the vertex p, which has the given index in its polygon. */
typedef void (*ix__row_fn)(const void *arg, int k, int vertex,
                           const double p[3], double out[3]);

/* The quadrilaterals between copies 0 .. ncopies-1 of every edge of p, as far
 * as they are not degenerate (triangles where an edge stays a point); with
 * caps also the first copy, reversed, and the last one of each polygon. */
ix_status ix__poly_rows(ix_ctx *ctx, const ix_poly *p, int ncopies, bool caps,
                        ix__row_fn fn, const void *arg,
                        ix_poly **out) IX_MUST_CHECK;

/* A polygon or polyline of n vertices at pts, with its plane. */
ix_status ix__polygon_fill(ix_ctx *ctx, ix_polygon *pg, ix_poly_kind kind,
                           int n, const double (*pts)[3]) IX_MUST_CHECK;

#endif
