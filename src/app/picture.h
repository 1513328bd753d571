/* picture.h - the way to the drawing module. */
#ifndef APP_PICTURE_H
#define APP_PICTURE_H

#include "draw/draw.h"

/* As ix__draw_picture, after loading the module. Err IX_EUNABLE it is not
 * there or does not fit; the message says why. */
ix_status picture_draw(ix_buf *out, const ix_obj *o,
                       const draw_opts *d) IX_MUST_CHECK;

/* From now on SAVE knows the suffixes svg, png and pdf. */
void picture_register(void);

#endif
