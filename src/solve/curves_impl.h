/* curves_impl.h - shared by the parts of the curve solver. */
#ifndef SOLVE_CURVES_IMPL_H
#define SOLVE_CURVES_IMPL_H

#include "solve/patches.h"

/* A point of the curve on a cell's face, or a vertex of a polyline. */
typedef struct {
    double x[4];
} ix__pt;

/* An arc inside one cell: points from end to end, in a growing array. */
typedef struct {
    int first, n; /* in pts */
    int times;    /* that the curve counts there */
} ix__arc;

typedef struct {
    ix__task t;
    int n; /* unknowns; n - 1 equations */
    double lo[IX_MAX_UNKNOWNS], hi[IX_MAX_UNKNOWNS]; /* the whole domain */
    double patch_lo[IX_MAX_UNKNOWNS], patch_hi[IX_MAX_UNKNOWNS];
    bool joined[IX_MAX_UNKNOWNS]; /* the patch has an upper neighbour with the
                                     same values on the common face */
    double tol;
    const ix_mv *image; /* of the unknowns from image_at on; NULL: none */
    int image_at;
    double image_size;
    bool area; /* an equation is zero on all of a patch */
    ix__arc *arc;
    int narcs, arc_cap;
    ix__pt *pts;
    int npts, pt_cap;
    ix__found singular;       /* cells that could not be decided */
    struct ix__cells *search; /* working memory, made for the first patch */
} ix__curves;

ix_status ix__curves_add_pt(ix__curves *s, const double *x) IX_MUST_CHECK;
ix_status ix__curves_add_arc(ix__curves *s, int first) IX_MUST_CHECK;

/* The image of o, if it has a size. */
ix_status ix__curves_take_image(ix_ctx *ctx, const ix_curves_opts *o,
                                ix__curves *s) IX_MUST_CHECK;
/* Distance of the image of x from the chord of those of p and r, as a part of
 * the image's size; 0 at a pole. */
double ix__curves_image_sag(const ix__curves *s, const double *p,
                            const double *x, const double *r);

/* All arcs in the patch b. */
ix_status ix__curves_patch(ix__curves *s, const ix__box *b) IX_MUST_CHECK;

/* n = 2: if all zeros of the equation in the cell are on one curve that counts
 * m = 2 .. 4 times, m, and out (with room for the tensor) is the cell with an
 * equation that has this curve once; else 0. work: 3 times the shape's size. */
int ix__curves_multiple(const ix__curves *s, const ix__box *b, double *work,
                        ix__box *out);

/* Joins arcs and hands the result over. */
ix_status ix__curves_link(ix__curves *s, ix_solution_curves *out) IX_MUST_CHECK;

#endif
