/* progress.c - what a long computation is doing, on a terminal: one line that
 * is written over and erased before anything else is shown. */
#define _POSIX_C_SOURCE 200809L
#include "app/progress.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define PATIENCE 0.5 /* seconds until a person wonders */

static double began;
static bool shown;

static double now(void)
{
    struct timespec t;

    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void show(void *ud, const char *what, double part)
{
    double elapsed = now() - began;

    (void)ud;
    if (shown)
        (void)fputs("\r\033[K", stderr);
    shown = what && elapsed >= PATIENCE;
    if (!shown)
        return;
    (void)fprintf(stderr, "%.1f s", elapsed);
    if (part > 0 && part <= 1)
        (void)fprintf(stderr, ", %.0f %%, %.0f s to go", 100 * part,
                      elapsed * (1 - part) / part);
    if (*what)
        (void)fprintf(stderr, ", %s", what);
    (void)fputs(" (Ctrl-C stops) ", stderr);
    (void)fflush(stderr);
}

void progress_begin(void)
{
    began = now();
}

void progress_watch(ix_ctx *ctx)
{
    const char *term = getenv("TERM");

    progress_begin();
    if (isatty(STDERR_FILENO) && term && *term && strcmp(term, "dumb") != 0)
        ix_ctx_set_progress(ctx, show, NULL);
}
