/* draw.h - pictures of objects through cairo.
 *
 * This floor is a module of its own, iritx_draw.so, which the program loads
 * when the first picture is drawn: cairo and what it needs take longer to
 * load than all the rest together. */
#ifndef DRAW_DRAW_H
#define DRAW_DRAW_H

#include "io/io.h"

typedef enum { DRAW_SVG, DRAW_PNG, DRAW_PDF } draw_format;

typedef struct {
    draw_format format;
    int width, height; /* pixels or points; 0: 900 x 700 */
    bool fit;          /* the picture takes the shape of its content */
    bool net, knots, shade;
    bool no_axes; /* a plane figure without axes and grid */
    bool has_view;
    double view[16]; /* if has_view; else the scene's own, else top for plane
                        figures and iso for others */
} draw_opts;

/* Appends the finished picture of o to out. Err IX_EDOMAIN nothing to draw. */
ix_status ix__draw_picture(ix_buf *out, const ix_obj *o,
                           const draw_opts *d) IX_MUST_CHECK;
typedef ix_status (*draw_fn)(ix_buf *out, const ix_obj *o, const draw_opts *d);

#endif
