/* x3d_impl.h - what the parts of the X3D writer share.
 *
 * Shapes are appended to one buffer. A shape has the colour of its object, or
 * of the list that it is in; its name, made unique, is that of its node. */
#ifndef IO_X3D_IMPL_H
#define IO_X3D_IMPL_H

#include "io/io.h"

typedef struct {
    double rgb[3]; /* 0 .. 1 */
    double transparency;
} ix__x3d_look;

typedef struct {
    ix_buf *b;
    size_t start;   /* length of b before */
    double tol;     /* of lines and triangles */
    bool pieces;    /* of a shape with poles are being written */
    int depth;      /* for indentation */
    bool nonfinite; /* some number was NaN or infinite */
    uint64_t *seen;
    size_t nseen, cap; /* names in use, as a hash table of their hashes */
} ix__x3d;

/* Out of memory, too much text, a number refused, interrupted. */
ix_status ix__x3d_check(const ix__x3d *w) IX_MUST_CHECK;
/* A line with its indentation. */
void ix__x3d_line(ix__x3d *w, const char *fmt, ...) IX_PRINTF(2, 3);
void ix__x3d_indent(ix__x3d *w);
void ix__x3d_num(ix__x3d *w, double v);
/* name="v v v"; every group of so many numbers ends with a comma. Numbers are
 * v[i + a * stride], a < group. */
void ix__x3d_rows(ix__x3d *w, const char *name, size_t n, int group,
                  const double *v, size_t stride);
/* "<Shape>" with its appearance, and its end. name (may be NULL) becomes DEF.
 * Lines and points shine by themselves. */
ix_status ix__x3d_shape(ix__x3d *w, const char *name, const ix__x3d_look *look,
                        bool shines) IX_MUST_CHECK;
void ix__x3d_end_shape(ix__x3d *w);
/* ' DEF="NAME"', unique in the file; nothing for NULL. */
ix_status ix__x3d_def(ix__x3d *w, const char *name) IX_MUST_CHECK;

/* One or more shapes each; a note instead where X3D cannot have it. */
ix_status ix__x3d_mv(ix__x3d *w, const char *name, const ix__x3d_look *look,
                     const ix_mv *m) IX_MUST_CHECK;
ix_status ix__x3d_trimsrf(ix__x3d *w, const char *name,
                          const ix__x3d_look *look,
                          const ix_trimsrf *t) IX_MUST_CHECK;
ix_status ix__x3d_model(ix__x3d *w, const char *name, const ix__x3d_look *look,
                        const ix_model *m) IX_MUST_CHECK;
ix_status ix__x3d_polys(ix__x3d *w, const char *name, const ix__x3d_look *look,
                        const ix_poly *p) IX_MUST_CHECK;
/* The colour that attributes tell, else the one given. */
ix__x3d_look ix__x3d_look_of(const ix_attr *attrs, ix__x3d_look otherwise);

#endif
