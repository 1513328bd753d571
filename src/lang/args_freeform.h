/* args_freeform.h - arguments that several freeform constructors share: knot
 * vectors, nested meshes of control points, lists of freeforms, and the codes
 * of point types; results that are lists. All memory is scratch. */
#ifndef LANG_ARGS_FREEFORM_H
#define LANG_ARGS_FREEFORM_H

#include "iritx/geom.h"
#include "iritx/solve.h"
#include "lang/builtin.h"
#include "lang/codes.h"

/* --- arguments ---------------------------------------------------------------
 * i is the argument that messages refer to. */

/* A KV_* constant. */
ix_status ix__arg_kv(ix_call *c, int i, ix_kv_kind *out) IX_MUST_CHECK;

/* The B-spline direction of order and length points that a list describes:
 * list(KV_*) makes a standard vector; else it has length + order knots, or
 * length + 2 order - 1 for a periodic one. A knot that steps back by at most
 * 1e-4 is raised to its predecessor (spec/model 3.3); more is an error. */
ix_status ix__arg_knots(ix_call *c, int i, const ix_obj *list, int order,
                        int length, ix_dir *out) IX_MUST_CHECK;

/* Control points in lists nested depth deep, the innermost along direction 0:
 * length[depth] of each direction, points as ix__arg_points gives them. */
typedef struct {
    int length[3];
    int ncoords;
    bool rational;
    double *pts; /* double[axes][product of lengths] */
} ix_mesh;
ix_status ix__arg_mesh(ix_call *c, int i, int depth,
                       ix_mesh *out) IX_MUST_CHECK;

/* The freeforms of a list, each of the given type (IX_OBJ_UNDEF: any one
 * type), borrowed. An object that links several counts as these. */
ix_status ix__arg_mvs(ix_call *c, int i, ix_obj_type type, int *n,
                      const ix_mv ***out) IX_MUST_CHECK;

/* E1 .. P18 to a number of coordinates and a weight. */
ix_status ix__arg_pttype(ix_call *c, int i, int *ncoords,
                         bool *rational) IX_MUST_CHECK;

/* The vector of three coordinates of a point or vector, no projection. */
ix_status ix__arg_vec3(ix_call *c, int i, double v[3]) IX_MUST_CHECK;

/* All vertices of polygons in scratch, z set to 0. */
ix_status ix__arg_vertices(ix_call *c, int i, int *n,
                           double (**out)[3]) IX_MUST_CHECK;

/* --- results ----------------------------------------------------------- */

/* A freeform of ndirs directions, each of the given basis, whose control points
 * are argument 0. */
ix_status ix__ret_mesh(ix_call *c, int ndirs, ix_basis basis) IX_MUST_CHECK;
/* A B-spline: an order per direction, the control points, a list of a knot
 * vector per direction; what names it for messages. */
ix_status ix__ret_bspline(ix_call *c, int ndirs,
                          const char *what) IX_MUST_CHECK;
/* As ix__ret_mv, with the attribute GeomType. Takes over m. */
ix_status ix__ret_geom(ix_call *c, int like, const ix_mv *m,
                       int geom_type) IX_MUST_CHECK;
/* A list of two pieces of the type of argument like; takes over both. */
ix_status ix__ret_pair(ix_call *c, int like,
                       ix_mv *const pieces[2]) IX_MUST_CHECK;
/* The list if st is IX_OK, else the list is released and st returned. */
ix_status ix__ret_list(ix_call *c, ix_obj *list, ix_status st) IX_MUST_CHECK;
/* n numbers as a list. */
ix_status ix__ret_nums(ix_call *c, int n, const double *v) IX_MUST_CHECK;
/* A control point, homogeneous if rational. */
ix_status ix__ret_ctlpt(ix_call *c, int ncoords, bool rational,
                        const double *v) IX_MUST_CHECK;
/* The trimming curves as a list, in the parameter plane or on the surface. */
ix_status ix__ret_trim_curves(ix_call *c, const ix_trimsrf *t,
                              bool param) IX_MUST_CHECK;
/* The B-spline curve of order 2 through points double[ncoords][n], n >= 2. */
ix_status ix__polyline_curve(ix_call *c, int n, int ncoords, const double *pts,
                             ix_obj **out) IX_MUST_CHECK;
/* Lines, or polygons, as one object. */
ix_status ix__ret_lines(ix_call *c, const ix_lines *l,
                        ix_poly_kind kind) IX_MUST_CHECK;
/* The part of a surface inside closed lines (u, v, 0), as a trimmed surface. */
ix_status ix__region_obj(ix_ctx *ctx, const ix_mv *srf, const ix_lines *l,
                         ix_obj **out) IX_MUST_CHECK;
/* Solution curves over two parameters as polylines in the parameter plane (m
 * NULL) or on m; no value if there is none. */
ix_status ix__ret_contours(ix_call *c, const ix_solution_curves *s,
                           const ix_mv *m) IX_MUST_CHECK;
/* Their tolerance, from the variable RESOLUTION. */
double ix__contour_tolerance(const ix_call *c);
ix_status ix__ret_vector(ix_call *c, const double v[3]) IX_MUST_CHECK;

#endif
