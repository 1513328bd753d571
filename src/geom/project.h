/* project.h - the element of a spline space nearest to a curve, in the mean
 * square over the parameter. */
#ifndef GEOM_PROJECT_H
#define GEOM_PROJECT_H

#include "geom/path.h"

typedef struct {
    bool homogeneous; /* fit the axes (weight first), not the points */
    bool keep_ends;   /* first and last point kept exactly; not periodic */
} ix_project_opts;

/* coef[naxes or ncoords][dir->length]. The domains agree. Exact quadrature if
 * the curve is polynomial (or homogeneous), else with 8 nodes more. */
ix_status ix__project(ix_ctx *ctx, const ix_path *p, const ix_dir *dir,
                      ix_project_opts o, double *coef) IX_MUST_CHECK;

/* Largest distance |p(t) - q(t)| over the common domain, sampled at 16 places
 * of each span of their union. */
ix_status ix__path_distance(ix_ctx *ctx, const ix_path *p, const ix_path *q,
                            double *dist) IX_MUST_CHECK;

#endif
