/* export.h - writers of other programs' formats; see docs/exports.md. Each
 * appends the whole file to b; w may be NULL. Err IX_EARG nothing in o that the
 * format holds; IX_EUNABLE the tolerance needs too many points; IX_ENOMEM. */
#ifndef IO_EXPORT_H
#define IO_EXPORT_H

#include "io/io.h"

/* Triangles as text, and in binary. */
ix_status ix__stl_write(ix_buf *b, const ix_obj *o,
                        const ix_write_opts *w) IX_MUST_CHECK;
ix_status ix__bstl_write(ix_buf *b, const ix_obj *o,
                         const ix_write_opts *w) IX_MUST_CHECK;
/* Wavefront OBJ: everything with points. */
ix_status ix__obj_file_write(ix_buf *b, const ix_obj *o,
                             const ix_write_opts *w) IX_MUST_CHECK;
/* ISO 10303-21 with the AP214 schema: curves and surfaces as exact B-splines,
 * polylines and points. Err also IX_EUNABLE a pole that cannot be cut away. */
ix_status ix__step_write(ix_buf *b, const ix_obj *o,
                         const ix_write_opts *w) IX_MUST_CHECK;

#endif
