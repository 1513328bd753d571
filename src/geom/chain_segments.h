/* chain_segments.h - segments in space joined to polylines at common ends. */
#ifndef GEOM_CHAIN_SEGMENTS_H
#define GEOM_CHAIN_SEGMENTS_H

#include "iritx/geom.h"

/* Polylines from n segments: ends that agree to about 1e-9 of the extent of all
 * are one; a line goes on where exactly two segments meet, and closed ones
 * repeat their first point. Segments without length are left out. */
ix_status ix__chain_segments(ix_ctx *ctx, int n, const double (*seg)[2][3],
                             ix_lines *out) IX_MUST_CHECK;

#endif
