/* startup.h - the start-up library: user-level functions that every script
 * may call without an include (spec/functions, last chapter).
 *
 * What is faster or clearer in C is a row of ix__builtins_startup (flag
 * IX_B_LIBRARY); the rest is script text, compiled when a script first calls
 * the name. A script may define functions of these names itself. */
#ifndef LANG_STARTUP_H
#define LANG_STARTUP_H

#include "lang/builtin.h"

/* {NAME, definition}, ended by a NULL name. The definition is one statement
 * "NAME = function(...): ...;" that calls only names above it or built-ins. */
extern const char *const ix__startup_text[][2];

/* The definition of a name in upper case, or NULL. */
const char *ix__startup_find(const char *name);

#endif
