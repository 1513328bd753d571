/* service.h - one request of another program, and its answer as bytes.
 *
 * The convention IRITX/1: a request is list("IRITX/1", number, "OP",
 * list(arguments)), the answer list("IRITX/1", number, status, value), with
 * status 0 and the result, or 1 and a message. The three ways to ask
 * (cmd_client.c, cmd_pipes.c, cmd_call.c) share it.
 *
 * What computes is a child process: it may crash, run out of memory, or be
 * killed, and there is still an answer. The process that keeps the connection
 * has no threads; only functions that change states run in it. */
#ifndef APP_SERVICE_H
#define APP_SERVICE_H

#include "lang/interp.h"

typedef struct {
    bool loud;    /* tells on standard error what happens */
    double idle;  /* seconds without a request after which it ends; 0: never */
    double limit; /* seconds that one computation may take; 0: any */
} service_opts;

typedef struct {
    ix_ctx *ctx;
    ix_interp *in; /* its states last from request to request */
    service_opts opts;
    bool quit; /* the operation EXIT came */
} service;

/* Reads "-v", "--idle S" and "--limit S"; *used: how many arguments they are.
 * False: a value is wrong, which has been said. */
bool service_options(int argc, char **argv, service_opts *o, int *used);

/* Closes descriptors that were inherited, keeps standard output free of
 * anything, and makes the interpreter. */
ix_status service_open(service *s, ix_ctx *ctx,
                       const service_opts *o) IX_MUST_CHECK;
void service_close(service *s);

bool service_is_request(const ix_obj *o);
/* A string named COMMAND_ with the text EXIT or DISCONNECT. */
bool service_is_farewell(const ix_obj *o);

/* The answer to a request, in one form, appended to out. watch: the peer's
 * descriptor (-1: none); when it hangs up the computation is given up. Err
 * IX_ECANCEL the peer has left, or a signal came; IX_ENOMEM. All else is an
 * answer. */
ix_status service_answer(service *s, const ix_obj *request, bool binary,
                         int watch, ix_buf *out) IX_MUST_CHECK;
/* The answer that request number seq has failed with the message why. */
ix_status service_refuse(service *s, double seq, const char *why, bool binary,
                         ix_buf *out) IX_MUST_CHECK;
/* A line on standard error, if that is wanted. */
void service_tell(const service *s, const char *fmt, ...) IX_PRINTF(2, 3);
/* Seconds of a clock that only goes forwards. */
double service_clock(void);

#endif
