/* trisector.h - shared by the two ways to trace curves equally far from three
 * objects. */
#ifndef OPS_TRISECTOR_H
#define OPS_TRISECTOR_H

#include "base/ctx.h"
#include "mv/mv.h"

/* Vertices of all curves, and for each whether it goes on from the one before;
 * growing, in scratch. */
typedef struct {
    double (*p)[3];
    bool *joined;
    size_t n, cap;
} ix__trace;
ix_status ix__trace_add(ix_ctx *ctx, ix__trace *t, const double p[3],
                        bool joined) IX_MUST_CHECK;

/* A curve of order 1. */
static inline bool ix__is_point(const ix_mv *m)
{
    return m->ndirs == 1 && m->dirs[0].order == 1;
}

static inline bool ix__in_box(const double p[3], const double box[6])
{
    for (int k = 0; k < 3; k++)
        if (!(p[k] >= box[k] && p[k] <= box[3 + k]))
            return false;
    return true;
}

/* Appends the curves in the box equally far from the surface m[0] and two
 * others, of which at least one is a surface. Curves that pass between the
 * nodes of a grid on m[0] are missed. step: of the parameters, in [0, 1]. */
ix_status ix__trisector_walk(ix_ctx *ctx, const ix_mv *const m[3], double step,
                             const double box[6], ix__trace *t) IX_MUST_CHECK;

#endif
