/* circle.h - what circles and arcs share. */
#ifndef GEOM_CIRCLE_H
#define GEOM_CIRCLE_H

#include "base/ctx.h"
#include "iritx/geom.h"

/* IX_EARG unless the center is finite and the radius finite and positive. */
ix_status ix__check_circle(ix_ctx *ctx, const double center[3],
                           double radius) IX_MUST_CHECK;

#endif
