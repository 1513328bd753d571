/* xml_write_impl.h - what the parts of the XML writer share.
 *
 * A writer appends to one buffer whole lines, indented by two blanks a level;
 * rows of numbers are not indented. Functions without a status rely on the
 * buffer's mark of failure and on ix__xmlw_check, which all loops call. */
#ifndef IO_XML_WRITE_IMPL_H
#define IO_XML_WRITE_IMPL_H

#include "io/write_text.h"

typedef struct {
    ix_buf *b;
    size_t start;   /* bytes of b before */
    int depth;      /* of open elements */
    bool nonfinite; /* some number was NaN or infinite */
} ix__xmlw;

/* Out of memory, too much text, a number refused, interrupted. */
ix_status ix__xmlw_check(const ix__xmlw *w) IX_MUST_CHECK;

/* "<name" on a new line; attributes may follow. */
void ix__xmlw_tag(ix__xmlw *w, const char *name);
void ix__xmlw_attr(ix__xmlw *w, const char *name, const char *value);
void ix__xmlw_attr_int(ix__xmlw *w, const char *name, long long v);
void ix__xmlw_attr_nums(ix__xmlw *w, const char *name, int n, const double *v);
/* Any bytes; as name-hex="..." if they are no text. Err IX_EUNABLE longer than
 * a tag may be. */
ix_status ix__xmlw_attr_text(ix__xmlw *w, const char *name, const char *s,
                             size_t n) IX_MUST_CHECK;
void ix__xmlw_none(ix__xmlw *w);  /* "/>" and a new line */
void ix__xmlw_open(ix__xmlw *w);  /* ">", a new line, one level deeper */
void ix__xmlw_begin(ix__xmlw *w); /* ">": text follows in the line */
/* The end of an element whose contents stand in lines of their own. */
void ix__xmlw_close(ix__xmlw *w, const char *name);
/* The end of an element whose text stands in the line. */
void ix__xmlw_end(ix__xmlw *w, const char *name);

void ix__xmlw_nums(ix__xmlw *w, int n, const double *v); /* blanks between */
void ix__xmlw_num(ix__xmlw *w, double v);
void ix__xmlw_escaped(ix_buf *b, const char *s, size_t n);
/* Can XML hold the bytes: UTF-8, and no control bytes but tab and line ends? */
bool ix__xml_is_text(const char *s, size_t n);

ix_status ix__xmlw_object(ix__xmlw *w, const ix_obj *o) IX_MUST_CHECK;
ix_status ix__xmlw_attrs(ix__xmlw *w, const ix_attr *attrs) IX_MUST_CHECK;

/* Entities. */
ix_status ix__xmlw_mv(ix__xmlw *w, const char *name, const char *use,
                      const ix_mv *m) IX_MUST_CHECK;
ix_status ix__xmlw_trisrf(ix__xmlw *w, const ix_trisrf *t) IX_MUST_CHECK;
ix_status ix__xmlw_poly(ix__xmlw *w, const ix_polygon *pg) IX_MUST_CHECK;
ix_status ix__xmlw_trimsrf(ix__xmlw *w, const ix_trimsrf *t) IX_MUST_CHECK;
ix_status ix__xmlw_model(ix__xmlw *w, const ix_model *m) IX_MUST_CHECK;

#endif
