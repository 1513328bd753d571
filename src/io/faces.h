/* faces.h - trimmed surfaces and the faces of models as one thing: a surface
 * and loops of curves in its parameter plane, and their triangles. */
#ifndef IO_FACES_H
#define IO_FACES_H

#include "mv/tessellate.h"
#include "object/object.h"

typedef struct {
    const ix_mv *uv;     /* borrowed */
    const ix_mv *euclid; /* in space, or NULL */
    bool back;           /* run through from its end to its beginning */
    int edge;            /* of a model, from 0 on; -1 */
    bool second;         /* the edge's second side */
} ix__face_curve;

typedef struct {
    int n;
    ix__face_curve *curve;
} ix__face_loop;

typedef struct {
    const ix_mv *srf; /* borrowed */
    int nloops;
    ix__face_loop *loop;
    bool reversed; /* of a model: its outside is where -S_u x S_v points */
} ix__face;

/* In scratch. Curves that begin where the one before does not end but end there
 * are turned. Err IX_EDOMAIN a curve has poles, IX_EARG it has not the two
 * coordinates of a trimming curve. */
ix_status ix__face_of_trimsrf(ix_ctx *ctx, const ix_trimsrf *t,
                              ix__face *out) IX_MUST_CHECK;
/* All faces of a model: nsrf. Loops without curves are left out. If all edges
 * are run through once in each sense, as on an oriented surface, faces whose
 * outer loop runs clockwise are reversed. Err as above. */
ix_status ix__faces_of_model(ix_ctx *ctx, const ix_model *m,
                             ix__face **out) IX_MUST_CHECK;

/* How the loops of a face lie in each other. */
typedef struct {
    int depth; /* loops around it; even: it bounds a part from outside */
    int outer; /* of a hole: the innermost one around it; else itself */
    bool turn; /* outer loops are to run counter-clockwise, holes clockwise:
                  it runs the other way */
} ix__nesting;
/* By points on the curves; loops that touch count as the most of them say.
 * *out: [nloops], in scratch. */
ix_status ix__face_nesting(ix_ctx *ctx, const ix__face *f,
                           ix__nesting **out) IX_MUST_CHECK;

/* Triangles of n faces within tol of them. Border edges are within tol of the
 * trimming curves on the surface. Faces that share edges of a model get the
 * same points there, unless their curves are more than tol apart. If steps is
 * not NULL: instead, steps[2] equal steps in the two directions. Err as
 * ix__mesh_of_srf and of the curves; *out: n meshes in scratch, each to be
 * freed, none on failure. */
ix_status ix__mesh_of_faces(ix_ctx *ctx, int n, const ix__face *face,
                            double tol, const int *steps,
                            ix__mesh **out) IX_MUST_CHECK;

/* The border lines of a face in space, within tol, one line for each loop. */
ix_status ix__lines_of_face(ix_ctx *ctx, const ix__face *f, double tol,
                            ix__lines *out) IX_MUST_CHECK;

#endif
