/* object.h - the value tree of files and scripts.
 *
 * An object is a counted, mutable box: a type, a name, attributes and a
 * value. Lists hold references to boxes, so that changing a box is seen by
 * every list that holds it; that is how script variables behave. The geometry
 * inside (ix_mv, ix_poly, ...) is immutable, counted and shared by copies. */
#ifndef IRITX_OBJECT_H
#define IRITX_OBJECT_H

#include "iritx/mv.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The numbers are those that scripts see (THISOBJ). */
typedef enum {
    IX_OBJ_UNDEF = 0,
    IX_OBJ_POLY = 1,
    IX_OBJ_NUMBER = 2,
    IX_OBJ_POINT = 3,
    IX_OBJ_VECTOR = 4,
    IX_OBJ_PLANE = 5,
    IX_OBJ_MATRIX = 6,
    IX_OBJ_CURVE = 7,
    IX_OBJ_SURFACE = 8,
    IX_OBJ_STRING = 9,
    IX_OBJ_LIST = 10,
    IX_OBJ_CTLPT = 11,
    IX_OBJ_TRIMSRF = 12,
    IX_OBJ_TRIVAR = 13,
    IX_OBJ_INSTANCE = 14,
    IX_OBJ_TRISRF = 15,
    IX_OBJ_MODEL = 16,
    IX_OBJ_MULTIVAR = 17
} ix_obj_type;

typedef struct ix_obj ix_obj;
typedef struct ix_attr ix_attr; /* see object/attr.h */

/* A control point value: type En or Pn. */
typedef struct {
    int ncoords; /* 1 .. IX_MAX_COORDS */
    bool rational;
    double v[IX_MAX_COORDS + 1]; /* weight first if rational */
} ix_ctlpt;

/* --- polygonal data: immutable, counted ---------------------------------- */
typedef enum {
    IX_POLYGON,
    IX_POLYLINE,
    IX_POINTLIST,
    IX_POLYSTRIP
} ix_poly_kind;
typedef struct {
    double p[3], normal[3];
    bool has_normal, internal;
    ix_attr *attrs;
} ix_vertex;
typedef struct {
    ix_poly_kind kind;
    bool has_plane;
    double plane[4]; /* unit normal */
    ix_attr *attrs;
    int n;
    ix_vertex *v;
} ix_polygon;
typedef struct {
    int refs;
    int n;
    ix_polygon *poly;
} ix_poly;

/* --- linked sequences of freeforms: one object may hold several ----------- */
typedef struct {
    int refs;
    int n;
    const ix_mv **mv; /* n references */
} ix_mvs;

/* --- trimmed surface, triangular surface, model: immutable, counted ------- */
typedef struct {
    const ix_mv *uv;     /* curve in the parameter plane */
    const ix_mv *euclid; /* NULL if not given */
} ix_trimseg;
typedef struct {
    int n;
    ix_trimseg *seg;
} ix_trimloop;
typedef struct {
    int refs;
    const ix_mv *srf;
    int nloops;
    ix_trimloop *loop;
} ix_trimsrf;

typedef enum { IX_TRI_BEZIER, IX_TRI_BSPLINE, IX_TRI_GREGORY } ix_tri_kind;
typedef struct {
    int refs;
    ix_tri_kind kind;
    int length, order; /* length (length+1)/2 points; Gregory: 3 more */
    int ncoords;
    bool rational;
    int nknots;
    double *knots;
    int npts;
    double *pts; /* double[axes][npts], weight first */
} ix_trisrf;

typedef struct {
    const ix_mv *srf;
    int nloops;
    int *nseg; /* [nloops] */
    int **seg; /* [nloops][nseg]: 1-based, negative = reversed */
} ix_model_srf;
typedef struct {
    int mask, s1, s2; /* mask bits 1, 2, 4: which curves follow */
    const ix_mv *uv1, *uv2, *euclid;
} ix_model_seg;
typedef struct {
    int refs;
    int nsrf, nseg;
    ix_model_srf *srf;
    ix_model_seg *seg;
} ix_model;

typedef struct {
    char *target; /* upper case */
    double mat[16];
} ix_instance;

/* --- objects: counted, mutable boxes ------------------------------------- */
/* Makers return a new reference, NULL without memory (message recorded). */
ix_obj *ix_obj_number(ix_ctx *ctx, double v);
ix_obj *ix_obj_string(ix_ctx *ctx, const char *s);
ix_obj *ix_obj_point(ix_ctx *ctx, const double p[3]);
ix_obj *ix_obj_vector(ix_ctx *ctx, const double v[3]);
/* A curve, surface, trivariate or multivariate, by m's directions. Takes over
 * the caller's reference to m, also if it fails. */
ix_obj *ix_obj_freeform(ix_ctx *ctx, const ix_mv *m);
ix_obj *ix_obj_list(ix_ctx *ctx); /* empty */
/* Appends o to a list and takes it over, also if it fails. Err IX_ENOMEM, also
 * if o is NULL, so that a maker may stand as the argument; IX_EARG not a list,
 * or o holds it. */
ix_status ix_obj_list_add(ix_ctx *ctx, ix_obj *list, ix_obj *o) IX_MUST_CHECK;

ix_obj *ix_obj_ref(ix_obj *o);
void ix_obj_unref(ix_ctx *ctx, ix_obj *o); /* o may be NULL */

ix_obj_type ix_obj_type_of(const ix_obj *o);
const char *ix_obj_name(const ix_obj *o); /* "" if it has none; borrowed */
/* Upper case is usual; NULL or "": no name. Err IX_ENOMEM. */
ix_status ix_obj_set_name(ix_ctx *ctx, ix_obj *o,
                          const char *name) IX_MUST_CHECK;
int ix_obj_list_size(const ix_obj *list);            /* 0 of other types */
ix_obj *ix_obj_list_item(const ix_obj *list, int i); /* borrowed; NULL: none */
double ix_obj_num(const ix_obj *o);                  /* NaN of other types */
const char *ix_obj_str(const ix_obj *o); /* borrowed; NULL of other types */
/* x, y, z of a point or vector; false of other types. */
bool ix_obj_xyz(const ix_obj *o, double xyz[3]);
/* The freeforms that an object holds: one, several if they are linked, none of
 * other types. */
int ix_obj_mv_count(const ix_obj *o);
const ix_mv *ix_obj_mv(const ix_obj *o, int i); /* borrowed; NULL: none */
/* An attribute, such as "rgb" with "255,0,0". Err IX_ENOMEM. */
ix_status ix_obj_set_attr(ix_ctx *ctx, ix_obj *o, const char *name,
                          const char *value) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
