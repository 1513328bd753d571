/* marks.h - parameters of a curve at which something changes, collected in
 * scratch memory, and the curve's meetings with a line. */
#ifndef GEOM_MARKS_H
#define GEOM_MARKS_H

#include "geom/path.h"
#include "iritx/solve.h"

typedef struct {
    ix_ctx *ctx;
    const ix_mv *crv;
    ix_path path;
    double dom[2], size;
    int n, room;
    double *t;
} ix__marks;

/* For a planar curve without poles; the ends of its domain are marked ... */
ix_status ix__marks_ends(ix_ctx *ctx, const ix_mv *crv,
                         ix__marks *out) IX_MUST_CHECK;
/* ... and its corners, too. */
ix_status ix__marks_new(ix_ctx *ctx, const ix_mv *crv,
                        ix__marks *out) IX_MUST_CHECK;
ix_status ix__marks_add(ix__marks *m, double t) IX_MUST_CHECK;
/* The ends of all roots; releases r. */
ix_status ix__marks_add_roots(ix__marks *m, ix_root *r, int n) IX_MUST_CHECK;
/* Both parameters of pairs; releases s. */
ix_status ix__marks_add_pairs(ix__marks *m, ix_solutions *s) IX_MUST_CHECK;
/* The first parameter of pairs to a, the second to b; releases s. */
ix_status ix__marks_add_both(ix__marks *a, ix__marks *b,
                             ix_solutions *s) IX_MUST_CHECK;
/* Sorts them; one of those closer than 1e-9 of the domain stays. */
void ix__marks_sort(ix__marks *m);
/* Sorts them and leaves only so many that no part of the curve between two
 * stays within tol of where it begins; the domain's ends stay. */
void ix__marks_thin(ix__marks *m, double tol);
/* Corners whose tangents make more than angle (radians), or without tangent. */
ix_status ix__marks_add_corners(ix__marks *m, double angle) IX_MUST_CHECK;

/* Where (C - at) . normal vanishes, or with stationary, where its derivative
 * does; freed with ix_roots_free. */
ix_status ix__marks_line(const ix__marks *m, const double at[2],
                         const double normal[2], bool stationary, ix_root **r,
                         int *n) IX_MUST_CHECK;

/* Marks these places. */
ix_status ix__marks_add_line(ix__marks *m, const double at[2],
                             const double normal[2],
                             bool stationary) IX_MUST_CHECK;

#endif
