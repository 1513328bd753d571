/* view_page.h - the fixed parts of the page of "iritx view", in their order:
 * head, the viewer's script, body, captions, scene, the objects as X3D, end.
 *
 * Object i has a caption with data-object="i" in its box, and in the scene the
 * Switch nodes iritx_oi (itself) and iritx_ni (its control net). Viewpoints are
 * iritx_v0, iritx_v1 and so on, in the order of the buttons. */
#ifndef APP_VIEW_PAGE_H
#define APP_VIEW_PAGE_H

extern const char view_page_head[], view_page_body[], view_page_scene[],
    view_page_end[];

#endif
