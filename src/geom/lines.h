/* lines.h - making the polylines that geom.h returns. */
#ifndef GEOM_LINES_H
#define GEOM_LINES_H

#include "base/ctx.h"
#include "iritx/geom.h"

/* Room for so many vertices, in as many lines at most; no line yet. */
ix_status ix__lines_new(ix_ctx *ctx, size_t points,
                        ix_lines *out) IX_MUST_CHECK;

#endif
