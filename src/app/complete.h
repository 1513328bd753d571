/* complete.h - the names that a person may type. */
#ifndef APP_COMPLETE_H
#define APP_COMPLETE_H

#include "lang/interp.h"

/* The names of functions, constants and variables that begin with the n
 * characters at prefix, any case (within: that contain them): sorted, each
 * once, at most max. Returns how many; they stay valid until a script runs. */
size_t complete_names(ix_interp *in, const char *prefix, size_t n, bool within,
                      const char **out, size_t max);

#endif
