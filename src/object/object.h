/* object.h - the box itself and what may be done with it.
 *
 * Names of functions: _new makes (one reference for the caller), _ref/_unref
 * count, _copy is deep for boxes (list elements stay shared, geometry is
 * shared and immutable), _assign replaces a box's value in place. Attributes
 * are values: copied with the box. Every _new returns NULL with the message
 * set if memory is short, so that calls nest. */
#ifndef OBJECT_OBJECT_H
#define OBJECT_OBJECT_H

#include "base/buf.h"
#include "iritx/object.h"
#include "mv/mv.h"

/* --- attributes ------------------------------------------------------- */
typedef enum {
    IX_ATTR_STRING,
    IX_ATTR_INT,
    IX_ATTR_REAL,
    IX_ATTR_OBJ
} ix_attr_type;
struct ix_attr {
    ix_attr *next; /* in the order of writing: the newest first */
    char *name;    /* spelling kept; compared without case */
    ix_attr_type type;
    char *s;     /* STRING; "" for a bare attribute */
    long long i; /* INT */
    double r;    /* REAL */
    ix_obj *obj; /* OBJ: a reference */
};
ix_attr *ix__attr_find(ix_attr *list, const char *name);
/* Setting replaces a value of that name where it stands, else the new
 * attribute comes first. On failure nothing has changed. */
ix_status ix__attr_set_string(ix_ctx *, ix_attr **, const char *name,
                              const char *s) IX_MUST_CHECK;
ix_status ix__attr_set_int(ix_ctx *, ix_attr **, const char *name,
                           long long v) IX_MUST_CHECK;
ix_status ix__attr_set_real(ix_ctx *, ix_attr **, const char *name,
                            double v) IX_MUST_CHECK;
/* Keeps a reference to o, which must not hold the owner of the attributes
 * (ix__obj_contains): such a cycle would never be released. */
ix_status ix__attr_set_obj(ix_ctx *, ix_attr **, const char *name,
                           ix_obj *o) IX_MUST_CHECK;
void ix__attr_remove(ix_ctx *, ix_attr **, const char *name);
ix_status ix__attr_copy_all(ix_ctx *, const ix_attr *from,
                            ix_attr **to) IX_MUST_CHECK; /* *to replaced */
/* Moves the first attribute to the end: readers keep the file's order. */
void ix__attr_first_to_last(ix_attr **);
/* Case-insensitive in ASCII whatever the locale; < 0, 0, > 0. */
int ix__name_cmp(const char *a, const char *b);
void ix__name_upper(char *s); /* ASCII, in place */
void ix__attr_free_all(ix_ctx *, ix_attr **);

/* --- the box ---------------------------------------------------------- */
typedef struct {
    int n, cap;
    ix_obj **item; /* references */
} ix_list;

struct ix_obj {
    int refs;
    ix_obj_type type;
    union {
        char *name;   /* NULL: none (written NONE); upper case as a rule */
        ix_obj *link; /* of a box that waits for its release or its reuse */
    };
    ix_attr *attrs;
    void *mark; /* used by one walk at a time, NULL outside; see walk.h */
    union {
        double num;
        double pt[3]; /* POINT, VECTOR */
        double plane[4];
        double mat[16];  /* row-major, row vectors */
        ix_ctlpt *ctlpt; /* owned */
        struct {
            char *s;
            size_t len;
        } str; /* owned, NUL-terminated */
        ix_list list;
        const ix_mvs *mvs; /* CURVE SURFACE TRIVAR MULTIVAR: a reference; the
                              elements have 1, 2, 3, any directions */
        const ix_poly *poly;
        struct {
            int n;
            const ix_trimsrf **item;
        } trim; /* owned array of refs */
        struct {
            int n;
            const ix_trisrf **item;
        } tri;
        struct {
            int n;
            const ix_model **item;
        } model;
        ix_instance *inst; /* owned */
    } u;
};

ix_obj *ix__obj_ref(ix_obj *o);
void ix__obj_unref(ix_ctx *ctx, ix_obj *o); /* iterative; o may be NULL */

ix_obj *ix__obj_undef(ix_ctx *ctx);
ix_obj *ix__obj_number(ix_ctx *ctx, double v);
ix_obj *ix__obj_point(ix_ctx *ctx, const double p[3]);
ix_obj *ix__obj_vector(ix_ctx *ctx, const double p[3]);
ix_obj *ix__obj_plane(ix_ctx *ctx, const double p[4]);
ix_obj *ix__obj_matrix(ix_ctx *ctx, const double m[16]);
ix_obj *ix__obj_string(ix_ctx *ctx, const char *s, size_t len);
ix_obj *ix__obj_ctlpt(ix_ctx *ctx, const ix_ctlpt *p);
ix_obj *ix__obj_list(ix_ctx *ctx); /* empty */
/* Takes over the caller's reference to m, also when it fails. type must be
 * CURVE, SURFACE, TRIVAR or MULTIVAR and fit m. */
ix_obj *ix__obj_mv(ix_ctx *ctx, ix_obj_type type, const ix_mv *m);
ix_obj *ix__obj_mvs(ix_ctx *ctx, ix_obj_type type,
                    const ix_mvs *m);                      /* takes over */
ix_obj *ix__obj_poly(ix_ctx *ctx, const ix_poly *p);       /* takes over */
ix_obj *ix__obj_trimsrf(ix_ctx *ctx, const ix_trimsrf *t); /* takes over */
ix_obj *ix__obj_trisrf(ix_ctx *ctx, const ix_trisrf *t);   /* takes over */
ix_obj *ix__obj_model(ix_ctx *ctx, const ix_model *m);     /* takes over */
/* Linked sequences of n >= 1; these keep references of their own. */
ix_obj *ix__obj_trimsrfs(ix_ctx *ctx, int n, const ix_trimsrf *const *t);
ix_obj *ix__obj_trisrfs(ix_ctx *ctx, int n, const ix_trisrf *const *t);
ix_obj *ix__obj_models(ix_ctx *ctx, int n, const ix_model *const *m);
/* target is copied, in upper case. */
ix_obj *ix__obj_instance(ix_ctx *ctx, const char *target, const double m[16]);

/* CURVE, SURFACE, TRIVAR for 1, 2, 3 directions, else MULTIVAR. */
ix_obj_type ix__obj_type_of_mv(const ix_mv *m);
/* The (first) multivariate of a freeform object; NULL for other types. */
const ix_mv *ix__obj_first_mv(const ix_obj *o);
bool ix__obj_is_freeform(const ix_obj *o); /* has multivariates, any kind */

/* List elements; append keeps a reference of its own. */
ix_status ix__obj_append(ix_ctx *ctx, ix_obj *list, ix_obj *item) IX_MUST_CHECK;

/* A new box with the same name, attributes, value; list elements shared. */
ix_obj *ix__obj_copy(ix_ctx *ctx, const ix_obj *o);
/* dst gets src's value and attributes, keeps its own name and references.
 * Lists: elements shared. dst == src does nothing. */
ix_status ix__obj_assign(ix_ctx *ctx, ix_obj *dst,
                         const ix_obj *src) IX_MUST_CHECK;
/* The same, but takes over the caller's reference to src, and moves its value
 * if that was the last one: cannot fail then. */
ix_status ix__obj_move(ix_ctx *ctx, ix_obj *dst, ix_obj *src) IX_MUST_CHECK;
/* Checks that o can be written out: lists (and object attributes) nested at
 * most max_depth deep, none inside itself, and no more than max_bytes of text
 * by a lower estimate that counts every path through shared lists. Err
 * IX_EUNABLE. */
ix_status ix__obj_check_size(ix_ctx *ctx, const ix_obj *o, int max_depth,
                             size_t max_bytes) IX_MUST_CHECK;
/* name is copied and converted to upper case; NULL, "" or "NONE": no name. */
ix_status ix__obj_set_name(ix_ctx *ctx, ix_obj *o,
                           const char *name) IX_MUST_CHECK;
/* True if o is x or holds it somewhere, in lists or object attributes.
 * Iterative; each box is looked at once; immediate for plain values. */
bool ix__obj_contains(const ix_obj *o, const ix_obj *x);
/* "Numeric", "Object List", "CtlPt", ... as in the header line of dumps. */
const char *ix__obj_type_name(ix_obj_type t);

/* --- polygonal data and the other counted values ---------------------- */
/* Builders: fill a fresh block, then treat it as immutable. Zeroed. */
ix_poly *ix__poly_new(ix_ctx *ctx, int npolys);
ix_status ix__poly_vertices(ix_ctx *ctx, ix_polygon *pg,
                            int n) IX_MUST_CHECK;     /* zeroed */
ix_poly *ix__poly_dup(ix_ctx *ctx, const ix_poly *p); /* deep, to be edited */
/* Plane from the vertices (Newell's sum); false if degenerate. */
bool ix__polygon_plane(const ix_polygon *pg, double plane[4]);
/* Deep copy of one polygon into a zeroed one; on failure the owner of *to
 * releases what is there. */
ix_status ix__polygon_dup(ix_ctx *ctx, const ix_polygon *from,
                          ix_polygon *to) IX_MUST_CHECK;
const ix_poly *ix__poly_ref(const ix_poly *p);
const ix_mvs *ix__mvs_ref(const ix_mvs *m);
const ix_trimsrf *ix__trimsrf_ref(const ix_trimsrf *t);
const ix_trisrf *ix__trisrf_ref(const ix_trisrf *t);
const ix_model *ix__model_ref(const ix_model *m);
void ix__poly_unref(ix_ctx *ctx, const ix_poly *p);
const ix_mvs *ix__mvs_new(ix_ctx *ctx, int n,
                          const ix_mv *const *mv); /* keeps references */
void ix__mvs_unref(ix_ctx *ctx, const ix_mvs *m);
ix_trimsrf *ix__trimsrf_new(ix_ctx *ctx, const ix_mv *srf,
                            int nloops); /* keeps a reference; loops empty */
ix_status ix__trimloop_segs(ix_ctx *ctx, ix_trimloop *l,
                            int n) IX_MUST_CHECK; /* zeroed */
void ix__trimsrf_unref(ix_ctx *ctx, const ix_trimsrf *t);
ix_trisrf *ix__trisrf_new(ix_ctx *ctx, ix_tri_kind kind, int length, int order,
                          int ncoords, bool rational);
void ix__trisrf_unref(ix_ctx *ctx, const ix_trisrf *t);
ix_model *ix__model_new(ix_ctx *ctx, int nsrf, int nseg); /* zeroed */
/* Makes room for n empty loops of a surface; for n indices of one loop. */
ix_status ix__model_loops(ix_ctx *ctx, ix_model_srf *s, int n) IX_MUST_CHECK;
ix_status ix__model_loop_segs(ix_ctx *ctx, ix_model_srf *s, int loop,
                              int n) IX_MUST_CHECK;
void ix__model_unref(ix_ctx *ctx, const ix_model *m);

/* Linked sequences whatever their type: the geometries that a freeform,
 * trimmed surface, triangular surface or model object holds (ix_mv, ix_trimsrf,
 * ...). Other types have none. */
int ix__seq_count(const ix_obj *o);
const void *ix__seq_item(const ix_obj *o, int i); /* borrowed */
/* items: n >= 1 pointers of the type's geometry; keeps references. */
ix_obj *ix__seq_new(ix_ctx *ctx, ix_obj_type type, int n, void *items);
void ix__seq_unref(ix_ctx *ctx, ix_obj_type type, const void *item);

/* x' = x M applied to any object, recursively for lists; a new box with o's
 * name and attributes. Curves and surfaces with fewer than 3 coordinates gain
 * them (spec/language 5.3); numbers and strings: IX_EARG. */
ix_status ix__obj_transform(ix_ctx *ctx, const ix_obj *o, const double mat[16],
                            ix_obj **out) IX_MUST_CHECK;
/* Box of x, y, z: box[6] = xmin xmax ymin ymax zmin zmax. Err IX_EDOMAIN if
 * there is no geometry in it. */
ix_status ix__obj_bbox(ix_ctx *ctx, const ix_obj *o,
                       double box[6]) IX_MUST_CHECK;
/* Same value (names and attributes aside), numbers within eps; geometry by
 * representation; lists over the left length. Err IX_EARG types differ. */
ix_status ix__obj_equal(ix_ctx *ctx, const ix_obj *a, const ix_obj *b,
                        double eps, bool *equal) IX_MUST_CHECK;

#endif
