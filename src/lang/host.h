/* host.h - what plug-ins are offered (iritx/plugin.h), and where their rows
 * go. */
#ifndef LANG_HOST_H
#define LANG_HOST_H

#include "lang/builtin.h"

extern const ix_host ix__host;

/* Where ix_plugin_init registers: the rows join the index of built-ins, for
 * good. */
struct ix_registry {
    ix_ctx *ctx; /* for messages; NULL while the index is being made */
    int added;   /* rows so far */
};

/* ix_host.add, by registry.c. */
ix_status ix__registry_add(ix_registry *r, unsigned version,
                           const ix_plugin_row *rows) IX_MUST_CHECK;

#endif
