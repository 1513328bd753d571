/* progress.h - what a long computation is doing, on a terminal. */
#ifndef APP_PROGRESS_H
#define APP_PROGRESS_H

#include "iritx/base.h"

/* From now on a line on standard error tells of computations that take longer
 * than half a second, if that is a terminal that can erase a line. */
void progress_watch(ix_ctx *ctx);
/* A computation begins now. */
void progress_begin(void);

#endif
