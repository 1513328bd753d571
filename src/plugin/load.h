/* load.h - plug-ins: shared objects that define script functions
 * (iritx/plugin.h). */
#ifndef PLUGIN_LOAD_H
#define PLUGIN_LOAD_H

#include "iritx/base.h"

/* Loads a plug-in and lets it register its functions, for this process and all
 * its interpreters, for good. One that is there already does nothing. Runs the
 * code of the file: ask whether that is allowed before. Err IX_EIO there is no
 * such file, or it cannot be loaded; IX_EARG it is not a plug-in, or what it
 * registers is wrong; IX_EUNABLE it was built for a newer program; what its
 * ix_plugin_init returns. The message names the file. */
ix_status ix__plugin_load(ix_ctx *ctx, const char *path) IX_MUST_CHECK;

#endif
