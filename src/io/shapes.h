/* shapes.h - what writers of polygonal formats share: a walk that turns every
 * geometry in an object into triangles, polylines, polygons and points within a
 * tolerance. What a format cannot hold is counted and told in one note. */
#ifndef IO_SHAPES_H
#define IO_SHAPES_H

#include "io/faces.h"
#include "io/io.h"

/* A writer: its functions get arg; NULL: the format has no such thing. o is
 * the object that the shape comes from, for names and colours. */
typedef struct {
    const char *format; /* "an STL file", for messages */
    const char *holds;  /* "surfaces, polygons", for messages */
    /* curves and surfaces as they are; else, if NULL, the next two */
    ix_status (*freeform)(void *arg, const ix_obj *o, const ix_mv *m);
    ix_status (*mesh)(void *arg, const ix_obj *o, const ix__mesh *m);
    /* a trimmed surface (one face) or model as it is; else, if NULL, meshes */
    ix_status (*faces)(void *arg, const ix_obj *o, int n, const ix__face *f);
    ix_status (*lines)(void *arg, const ix_obj *o, const ix__lines *l);
    ix_status (*poly)(void *arg, const ix_obj *o, const ix_poly *p);
    ix_status (*point)(void *arg, const ix_obj *o, const double p[3]);
    void *arg;
} ix__shape_sink;

/* Sends everything in o to the sink, in order. tol 0: ix__shape_tol of it.
 * Err IX_EARG there is nothing that the format holds; IX_EUNABLE as the
 * tessellator; what the functions return. */
ix_status ix__shapes(ix_ctx *ctx, const ix_obj *o, double tol,
                     const ix__shape_sink *sink) IX_MUST_CHECK;

/* The tolerance for those who give none: 1/1000 of the diagonal of the box of
 * the control points (those of tiny weight aside); 1 if that is 0. */
ix_status ix__shape_tol(ix_ctx *ctx, const ix_obj *o,
                        double *tol) IX_MUST_CHECK;

/* Triangles of a polygon by cutting off ears, corners of pg: tri has room for
 * n - 2, work for n. Returns how many there are. */
int ix__polygon_ears(const ix_polygon *pg, int *work, int (*tri)[3]);

/* Colour of an object, 0 .. 1; false if it has none. */
bool ix__shape_color(const ix_obj *o, double rgb[3]);

#endif
