/* scene.h - objects as what a picture shows: paths of points and triangles,
 * with colours and widths, and a view. No picture library is needed here;
 * backends project the paths and draw them.
 *
 * Everything lives in the context's scratch memory: mark, build, draw,
 * release. */
#ifndef IO_SCENE_H
#define IO_SCENE_H

#include "io/io.h"

typedef enum {
    IX_PATH_LINE,  /* a curve, an isoparametric line, a polyline */
    IX_PATH_EDGE,  /* a boundary of a surface or a polygon's outline */
    IX_PATH_NET,   /* control polygon or mesh */
    IX_PATH_POINT, /* single points */
    IX_PATH_KNOT   /* points of curves at their inner knots */
} ix_path_kind;

typedef struct {
    ix_path_kind kind;
    double rgb[3];   /* 0 .. 1 */
    double width;    /* pixels */
    size_t first, n; /* in scene.pts */
    bool closed;
} ix_path;

typedef struct {
    size_t v[3]; /* in scene.pts */
    double rgb[3];
} ix_tri;

typedef struct {
    ix_ctx *ctx;
    double (*pts)[3];
    size_t npts, pts_cap;
    ix_path *path;
    size_t npaths, path_cap;
    ix_tri *tri;
    size_t ntris, tri_cap;
    bool has_view; /* a matrix named VIEW_MAT was among the objects */
    double view[16];
    double box[6]; /* of all points; xmin xmax ymin ymax zmin zmax */
} ix_scene;

typedef struct {
    bool net, knots; /* show control nets, knots */
    bool mesh;       /* triangles of surfaces, for hidden parts and shading */
    int isolines;    /* inner isoparametric lines of a surface; 0: 7 */
    double tol;      /* chord error, as a part of the scene's size; 0: 1e-3 */
} ix_scene_opts;

/* Adds everything that o holds. Attributes color, rgb, dwidth and invisible of
 * an object pass on to the elements of a list. Points at infinity end a path.
 * Err IX_EARG lists nested too deep. */
ix_status ix__scene_build(ix_ctx *ctx, const ix_obj *o,
                          const ix_scene_opts *opts,
                          ix_scene *out) IX_MUST_CHECK;

/* All z are equal: the picture is a plane figure. */
bool ix__scene_is_plane(const ix_scene *s);

/* Standard views: "top", "bottom", "front", "back", "right", "left", "iso";
 * false for another name. Row vectors: x' = x M; x to the right, y up, z
 * towards the viewer. */
bool ix__view_named(const char *name, double m[16]);

/* --- what is hidden
 * ------------------------------------------------------------ */

/* A z-buffer over [0, w) x [0, h) pixels of projected triangles. */
typedef struct {
    int w, h;
    double *z;    /* [w h]; -HUGE_VAL where nothing is */
    float *shade; /* [w h][3], rgb of the nearest triangle, lit */
} ix_raster;
ix_status ix__raster_new(ix_ctx *ctx, int w, int h,
                         ix_raster *out) IX_MUST_CHECK;
/* p, q, r: x, y in pixels (y down), z towards the viewer. */
void ix__raster_triangle(ix_raster *b, const double *p, const double *q,
                         const double *r, const double rgb[3]);
/* Whether something lies in front of a point by more than slack. */
bool ix__raster_hides(const ix_raster *b, const double p[3], double slack);

#endif
