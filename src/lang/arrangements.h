/* arrangements.h - arrangements that scripts work on, kept by the interpreter
 * under names, as CARNGMNT2 gives them. */
#ifndef LANG_ARRANGEMENTS_H
#define LANG_ARRANGEMENTS_H

#include "iritx/arrange.h"
#include "lang/interp.h"

typedef struct ix__kept {
    struct ix__kept *next;
    char name[40]; /* "ARRANGEMENT7" */
    ix_arrangement *a;
    double back[16]; /* from the XY plane to where the curves were */
} ix__kept;

/* Takes over a, also if it fails. *out is borrowed. */
ix_status ix__kept_add(ix_interp *in, ix_arrangement *a, const double back[16],
                       ix__kept **out) IX_MUST_CHECK;
/* By name, any case; NULL: there is none. */
ix__kept *ix__kept_find(ix_interp *in, const char *name);
void ix__kept_drop(ix_interp *in, ix__kept *k);
void ix__kept_free_all(ix_ctx *ctx, ix__kept **all);

#endif
