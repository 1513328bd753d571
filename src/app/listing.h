/* listing.h - what the program tells about its functions. */
#ifndef APP_LISTING_H
#define APP_LISTING_H

#include <stdbool.h>

/* One line a function, by chapter of the reference, then by name. */
void listing_functions(void);
/* Signature, summary, example; false if there is no such function. */
bool listing_help(const char *name);

#endif
