/* xml_read_impl.h - what the parts of the XML reader share.
 *
 * A reader of an element starts behind its start tag, whose name and
 * attributes r->e holds until the next event, consumes its end tag and
 * returns a new reference; on failure nothing is left but scratch memory,
 * which the reader of the object releases. */
#ifndef IO_XML_READ_IMPL_H
#define IO_XML_READ_IMPL_H

#include "io/xml_pull.h"

typedef struct {
    ix__xml *x;
    ix_ctx *ctx;
    int depth;     /* of open elements */
    ix__xevent e;  /* the start tag read last */
    ix_buf text;   /* of the element read last by ix__xmlr_text */
    size_t behind; /* offset of that text */
    const char *p; /* the next number in it */
} ix__xmlr;

/* --- elements --------------------------------------------------------- */
/* The next child of the element that is open, or its end. */
ix_status ix__xmlr_child(ix__xmlr *r, bool *more) IX_MUST_CHECK;
/* There is no child. */
ix_status ix__xmlr_empty(ix__xmlr *r) IX_MUST_CHECK;
bool ix__xmlr_is(const ix__xmlr *r, const char *name);
/* "<element> ... may not stand here". */
ix_status ix__xmlr_unexpected(ix__xmlr *r, const char *wanted);
/* Attributes but these (names with blanks around each) are errors. */
ix_status ix__xmlr_allow(ix__xmlr *r, const char *names) IX_MUST_CHECK;
const char *ix__xmlr_attr(const ix__xmlr *r, const char *name); /* or NULL */
ix_status ix__xmlr_need(ix__xmlr *r, const char *name,
                        const char **value) IX_MUST_CHECK;
/* value[0 .. *n) of name="..." or name-hex="...", in scratch; NULL if there is
 * neither. Err IX_EPARSE also a NUL in it. */
ix_status ix__xmlr_name(ix__xmlr *r, const char *name,
                        char **value) IX_MUST_CHECK;
/* Attribute name, an integer within [lo, hi]. */
ix_status ix__xmlr_int(ix__xmlr *r, const char *name, int lo, int hi,
                       int *v) IX_MUST_CHECK;
ix_status ix__xmlr_bool(ix__xmlr *r, const char *name, bool *v) IX_MUST_CHECK;
/* Attribute name, n numbers; *given false if there is none. */
ix_status ix__xmlr_attr_nums(ix__xmlr *r, const char *name, int n, double *v,
                             bool *given) IX_MUST_CHECK;
/* Attribute type: E1 .. E18, P1 .. P18. */
ix_status ix__xmlr_point_type(ix__xmlr *r, int *ncoords,
                              bool *rational) IX_MUST_CHECK;
/* Which of n words the attribute is. */
ix_status ix__xmlr_word(ix__xmlr *r, const char *name, int n,
                        const char *const *words, int *i) IX_MUST_CHECK;

/* --- text ------------------------------------------------------------- */
/* All text of the element that is open, with its end. */
ix_status ix__xmlr_text(ix__xmlr *r) IX_MUST_CHECK;
/* The same as bytes: hexadecimal digits are undone if hex. */
ix_status ix__xmlr_bytes(ix__xmlr *r, bool hex) IX_MUST_CHECK;
bool ix__xmlr_at_end(ix__xmlr *r); /* only blanks are left */
ix_status ix__xmlr_num(ix__xmlr *r, double *v) IX_MUST_CHECK;
/* The text is n numbers. */
ix_status ix__xmlr_nums(ix__xmlr *r, int n, double *v) IX_MUST_CHECK;
/* "file:line:col: error: " at the next number. */
ix_status ix__xmlr_bad_text(ix__xmlr *r, const char *what);
/* What lower floors refuse as an argument is malformed text here. */
ix_status ix__xmlr_at(ix__xmlr *r, size_t at, ix_status st) IX_MUST_CHECK;
/* Fails if the text cannot hold n numbers: memory stays bounded. */
ix_status ix__xmlr_room(ix__xmlr *r, size_t at, double n,
                        const char *what) IX_MUST_CHECK;

/* --- entities --------------------------------------------------------- */
/* ndirs 0: any. */
ix_status ix__xmlr_mv(ix__xmlr *r, int ndirs, const ix_mv **out) IX_MUST_CHECK;
ix_status ix__xmlr_trisrf(ix__xmlr *r, const void **out) IX_MUST_CHECK;
ix_status ix__xmlr_poly(ix__xmlr *r, ix_poly_kind kind,
                        const void **out) IX_MUST_CHECK;
ix_status ix__xmlr_trimsrf(ix__xmlr *r, const void **out) IX_MUST_CHECK;
ix_status ix__xmlr_model(ix__xmlr *r, const void **out) IX_MUST_CHECK;
ix_status ix__xmlr_object(ix__xmlr *r, ix_obj **out) IX_MUST_CHECK;
/* The element is an <attribute>. */
ix_status ix__xmlr_attribute(ix__xmlr *r, ix_attr **attrs,
                             int *count) IX_MUST_CHECK;

#endif
