/* clients.h - what functions that talk to client programs answer. */
#ifndef LANG_CLIENTS_H
#define LANG_CLIENTS_H

#include "lang/builtin.h"

/* Scripts of iritx have no clients: IX_EUNABLE with a sentence that says so. */
ix_status ix__no_client(ix_call *c) IX_MUST_CHECK;

#endif
