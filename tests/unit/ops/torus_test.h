/* torus_test.h - an exact torus for tests. */
#ifndef UNIT_OPS_TORUS_TEST_H
#define UNIT_OPS_TORUS_TEST_H

#include "harness/test.h"
#include "iritx/geom.h"
#include "iritx/geom_srf.h"

/* The torus with radii 3 and 1 about the z axis, exactly: u its rotation, v the
 * section, from the outer equator on. */
static inline ix_mv *lt_torus(ix_ctx *ctx)
{
    static const double at[3] = {3, 0, 0};
    static const double to_xz[16] = {1, 0, 0, 0, 0, 0, 1, 0,
                                     0, 1, 0, 0, 0, 0, 0, 1};
    ix_mv *c, *section, *m;

    ASSERT_OK(ctx, ix_circle(ctx, at, 1, &c));
    ASSERT_OK(ctx, ix_mv_transform(ctx, c, to_xz, &section));
    ASSERT_OK(ctx, ix_srf_revolve(ctx, section, IX_TURN_RATIONAL, &m));
    ix_mv_unref(ctx, c);
    ix_mv_unref(ctx, section);
    return m;
}

#endif
