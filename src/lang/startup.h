/* startup.h - the start-up library: user-level functions that every script
 * may call without an include (spec/functions, last chapter).
 *
 * What is faster or clearer in C is a row of ix__builtins_startup (flag
 * IX_B_LIBRARY); the rest is script text, compiled when a script first calls
 * the name. A script may define functions of these names itself. */
#ifndef LANG_STARTUP_H
#define LANG_STARTUP_H

#include "lang/builtin.h"

/* text is one statement "NAME = function(...): ...;" that calls only built-ins
 * and functions of the library, and reads no variable of the script. */
typedef struct {
    const char *name, *text, *summary;
    const char *example; /* NULL: what it needs is not there */
} ix__startup_fn;
extern const ix__startup_fn ix__startup_text[]; /* ended by a NULL name */

/* The function of that name, any case, or NULL. */
const ix__startup_fn *ix__startup_find(const char *name);

#endif
