/* numfmt.h - numbers in the printf-style formats that scripts ask for.
 *
 * A format is checked once and then used for many numbers; what it prints
 * does not depend on the locale. */
#ifndef BASE_NUMFMT_H
#define BASE_NUMFMT_H

#include "base/buf.h"

typedef struct {
    char flags[8];        /* of "-+ #0" */
    int width, precision; /* precision -1: not given */
    char conv;            /* one of d i u o x X e E f F g G s */
} ix_numfmt;

#define IX_NUMFMT_MAX_WIDTH 1024

/* Reads one conversion that starts at "%": flags, width, precision, any of
 * the modifiers h l L q, then the conversion letter, which is stored as it
 * stands. Returns the first character after the letter, or NULL when it is
 * malformed or width or precision exceed IX_NUMFMT_MAX_WIDTH. */
const char *ix__numfmt_parse(const char *s, ix_numfmt *out);

/* Appends v; integer conversions take v truncated towards zero. */
void ix__numfmt_put(ix_buf *b, const ix_numfmt *f, double v);
/* Appends s with the width, precision and "-" flag of f. */
void ix__numfmt_puts(ix_buf *b, const ix_numfmt *f, const char *s);

#endif
