/* view_camera.h - from where the page of "iritx view" looks at the objects. */
#ifndef APP_VIEW_CAMERA_H
#define APP_VIEW_CAMERA_H

#include "io/io.h"

/* Appends X3D viewpoints iritx_v0 (from a corner; of a drawing in the plane z =
 * constant: from above), v1 (from above), v2 (from the front), v3 (from the
 * right), and opens the node that the objects belong into. */
void view_camera_begin(ix_buf *b, const ix_obj *list);
void view_camera_end(ix_buf *b);

#endif
