/* itd_write_impl.h - what the parts of the text writer share.
 *
 * A writer appends to one buffer; lines begin with an indentation of tabs and
 * blanks and end with a newline. Functions without a status rely on the
 * buffer's mark of failure and on ix__itdw_check, which all loops call. */
#ifndef IO_ITD_WRITE_IMPL_H
#define IO_ITD_WRITE_IMPL_H

#include "base/numfmt.h"
#include "io/write_text.h"

typedef struct {
    ix_buf *b;
    size_t start; /* bytes of b before */
    bool shortest, file, peer;
    bool nonfinite; /* some number was NaN or infinite */
    ix_numfmt fmt;  /* unless shortest */
    double tiny;
} ix__itdw;

/* Err IX_EARG: not a format for one number. */
ix_status ix__itdw_init(ix__itdw *w, ix_buf *b,
                        const ix_write_opts *o) IX_MUST_CHECK;
/* Out of memory, too much text, a number refused, interrupted. */
ix_status ix__itdw_check(const ix__itdw *w) IX_MUST_CHECK;

void ix__itdw_num(ix__itdw *w, double v);
void ix__itdw_nums(ix__itdw *w, int n, const double *v); /* blanks between */
void ix__itdw_real_attr(ix__itdw *w, double v);
void ix__itdw_indent(ix__itdw *w, int column);
void ix__itdw_word(ix__itdw *w, const char *s); /* a name; NULL: NONE */
/* As it stands; quoted in files where a bare word would mean another thing. */
ix_status ix__itdw_attr_name(ix__itdw *w, const char *name) IX_MUST_CHECK;
/* Files: escaped. Dumps: as it is; in attributes with quotes escaped. */
ix_status ix__itdw_quoted(ix__itdw *w, const char *s, size_t n) IX_MUST_CHECK;
ix_status ix__itdw_attr_quoted(ix__itdw *w, const char *s) IX_MUST_CHECK;
/* Each followed by a blank; the column is that of the entity. */
ix_status ix__itdw_attrs(ix__itdw *w, const ix_attr *attrs,
                         int column) IX_MUST_CHECK;

ix_status ix__itdw_object(ix__itdw *w, const ix_obj *o,
                          int column) IX_MUST_CHECK;

/* Entities, at a column. */
ix_status ix__itdw_mv(ix__itdw *w, ix_obj_type type, const ix_mv *m,
                      int column) IX_MUST_CHECK;
ix_status ix__itdw_poly(ix__itdw *w, const ix_polygon *pg,
                        int column) IX_MUST_CHECK;
ix_status ix__itdw_trimsrf(ix__itdw *w, const ix_trimsrf *t,
                           int column) IX_MUST_CHECK;
ix_status ix__itdw_trisrf(ix__itdw *w, const ix_trisrf *t,
                          int column) IX_MUST_CHECK;
ix_status ix__itdw_model(ix__itdw *w, const ix_model *m,
                         int column) IX_MUST_CHECK;

#endif
