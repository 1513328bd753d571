/* step_impl.h - what the parts of the STEP writer share: numbered entities in
 * one buffer. */
#ifndef IO_STEP_IMPL_H
#define IO_STEP_IMPL_H

#include "io/faces.h"
#include "io/io.h"

typedef struct {
    ix_buf *b;
    ix_buf items, styles, shells; /* "#1,#2,..." */
    long next;                    /* number of the next entity */
    const char *name;             /* of the object at hand */
    double rgb[3];
    bool colored, surfaces;
    int degree; /* the highest */
    size_t nleft;
    long plane; /* context of parameter planes, 0: not written yet */
} ix__step;

/* "#N=" for the next entity; returns N. */
long ix__step_entity(ix__step *s);
/* "#N" at the end of a list. */
void ix__step_add(ix_buf *list, long id);
/* A point of n coordinates. */
void ix__step_point(ix__step *s, int n, const double *p);
/* Open B-splines of degree 1 or more without jumps or poles, of dim
 * coordinates: returns the entity. */
long ix__step_spline(ix__step *s, const ix_mv *m, int dim);
/* m as such a B-spline, a new reference. */
ix_status ix__step_normalized(ix_ctx *ctx, const ix_mv *m,
                              ix_mv **out) IX_MUST_CHECK;
/* The colour of an entity, if its object has one. */
void ix__step_style(ix__step *s, long geometry, bool surface);
/* The first interior knot where direction d jumps, if any. */
bool ix__step_jump(const ix_mv *m, int d, double *t);

/* A trimmed surface or model as a shell of faces. Err IX_EUNABLE poles, jumps;
 * IX_EDOMAIN a curve that leaves the domain. Nothing is written then. */
ix_status ix__step_shell(ix__step *s, int n,
                         const ix__face *face) IX_MUST_CHECK;

#endif
