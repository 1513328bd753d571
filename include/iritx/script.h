/* script.h - scripts run from C: an interpreter with variables of its own.
 *
 * It obeys the limits of the command line's defaults: files below the current
 * directory, no commands, no plug-ins (docs/program.md). Messages go to
 * standard error, output to standard output. */
#ifndef IRITX_SCRIPT_H
#define IRITX_SCRIPT_H

#include "iritx/object.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ix_interp ix_script;

/* A new interpreter; it keeps ctx, which must outlive it. Err IX_ENOMEM, IX_EIO
 * the current directory is gone. */
ix_status ix_script_new(ix_ctx *ctx, ix_script **out) IX_MUST_CHECK;
void ix_script_free(ix_script *s); /* s may be NULL */

/* Runs statements, or a file; variables stay. name is for messages. Returns the
 * first hard error's status. */
ix_status ix_script_run(ix_script *s, const char *name,
                        const char *text) IX_MUST_CHECK;
ix_status ix_script_run_file(ix_script *s, const char *name) IX_MUST_CHECK;

/* A variable, any case; borrowed, valid until the next run. NULL: none. */
ix_obj *ix_script_get(ix_script *s, const char *name);
/* Assigns a copy of o, as "name = o" does. Err IX_EARG not a name; IX_ENOMEM.
 */
ix_status ix_script_set(ix_script *s, const char *name,
                        const ix_obj *o) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
