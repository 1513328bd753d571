/* itd_read_impl.h - what the parts of the text reader share.
 *
 * A reader of an entity starts behind its keyword, consumes its closing
 * bracket and returns a new reference; on failure nothing is left but
 * scratch memory, which the reader of the object releases. */
#ifndef IO_ITD_READ_IMPL_H
#define IO_ITD_READ_IMPL_H

#include "io/itd_lex.h"

/* Attributes at the start of an entity, in the file's order. special (may be
 * NULL) sees each name first, the lexer behind it, and either reads the
 * attribute with its bracket (*taken) or leaves everything as it is. */
typedef ix_status (*ix__attr_special)(ix__lex *l, const ix__token *name,
                                      void *arg, bool *taken);
ix_status ix__itdr_attrs(ix__lex *l, ix_attr **attrs, ix__attr_special special,
                         void *arg) IX_MUST_CHECK;

/* Attributes that belong to nothing that is kept. */
ix_status ix__itdr_drop_attrs(ix__lex *l) IX_MUST_CHECK;

/* "E3", "P12"; the upper-case letter is not insisted on. */
ix_status ix__itdr_point_type(ix__lex *l, int *ncoords,
                              bool *rational) IX_MUST_CHECK;
/* "[KV ...]" into scratch. Err also what ix__mv_check_dirs refuses in
 * dirs[0 .. d]; the order is checked against the length here. */
ix_status ix__itdr_knots(ix__lex *l, ix_dir *dirs, int d) IX_MUST_CHECK;
/* n points, pts is double[naxes][n]. */
ix_status ix__itdr_points(ix__lex *l, int naxes, size_t n,
                          double *pts) IX_MUST_CHECK;
/* One point, p[axis * stride]; i of n are for messages. */
ix_status ix__itdr_point(ix__lex *l, int naxes, size_t stride, double *p,
                         size_t i, size_t n) IX_MUST_CHECK;

ix_status ix__itdr_mv(ix__lex *l, ix_obj_type type,
                      const void **out) IX_MUST_CHECK;
/* "[CURVE ...]" or "[SURFACE ...]" with its opening bracket and keyword. */
ix_status ix__itdr_whole_mv(ix__lex *l, ix_obj_type type,
                            const ix_mv **out) IX_MUST_CHECK;
ix_status ix__itdr_poly(ix__lex *l, ix_poly_kind kind,
                        const void **out) IX_MUST_CHECK;
ix_status ix__itdr_trimsrf(ix__lex *l, const void **out) IX_MUST_CHECK;
ix_status ix__itdr_trisrf(ix__lex *l, const void **out) IX_MUST_CHECK;
ix_status ix__itdr_model(ix__lex *l, const void **out) IX_MUST_CHECK;

/* Objects and words between them to the end of list, up to a closing bracket or
 * the end, which are left. inside: the first "[OBJECT" has been read. wanted is
 * for the message about something else in brackets. */
ix_status ix__itdr_objects(ix__lex *l, ix_obj *list, bool inside,
                           const char *wanted) IX_MUST_CHECK;

#endif
