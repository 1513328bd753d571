/* march.h - cutting a path into pieces, each as long as some error allows.
 *
 * Pieces end at breaks where they cover whole spans, so that curves that are
 * exactly representable span by span stay exact; they never pass a corner or a
 * jump. */
#ifndef GEOM_MARCH_H
#define GEOM_MARCH_H

#include "geom/path.h"

/* Error of a piece over [t0, t1], HUGE_VAL if there is none. */
typedef double (*ix__try_fn)(void *arg, double t0, double t1);
/* Keeps the piece over [t0, t1], whose error was good. */
typedef ix_status (*ix__keep_fn)(ix_ctx *ctx, void *arg, double t0, double t1);

typedef struct {
    const ix_path *p;
    double tol;
    int order; /* errors shrink like length^order */
    ix__try_fn try;
    ix__keep_fn keep;
    void *arg;
} ix_march;

/* Err IX_EUNABLE an error stays too large however short the piece is (2^-30
 * of the span); what keep returns; IX_ECANCEL. */
ix_status ix__march(ix_ctx *ctx, const ix_march *m) IX_MUST_CHECK;

/* The last span that reaches into (.., t1): the one to the left of a break. */
int ix__path_span_left(const ix_path *p, double t1);

#endif
