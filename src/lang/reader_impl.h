/* reader_impl.h - physical lines, for the lexer only. */
#ifndef LANG_READER_IMPL_H
#define LANG_READER_IMPL_H

#include "lang/lexer_impl.h"

/* Replaces the present line by the next one; *more is false at the end of all
 * sources. Err IX_ENOMEM, IX_ECANCEL. */
ix_status ix__reader_line(ix__reader *rd, bool *more) IX_MUST_CHECK;

#endif
