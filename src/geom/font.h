/* font.h - a font of strokes: ASCII 32 .. 126 as curves in the XY plane.
 *
 * Capitals are 1 high and stand on y = 0; small letters are 2/3 high, tails
 * reach down to -1/3, brackets to -1/6 and up to 7/6. Every glyph begins at
 * x = 0. */
#ifndef GEOM_FONT_H
#define GEOM_FONT_H

#include "iritx/geom.h"

#define IX__FONT_DEPTH (1.0 / 3) /* below the base line */

/* Distance from x = 0 to the glyph's right end, 0 of a vertical stroke; -1 if
 * there is no such glyph. A space is 1/2 wide. */
double ix__glyph_width(int ch);

/* The strokes of one glyph: B-splines of two coordinates and order 2 (straight)
 * or 3; none for a space. Err IX_EARG there is no such glyph. */
ix_status ix__glyph(ix_ctx *ctx, int ch, ix_crvs *out) IX_MUST_CHECK;

#endif
