/* wire.h - objects from a socket or a pipe, whatever else comes through it.
 *
 * The peer speaks first, and its first object tells whether it speaks text or
 * binary. What is no object is skipped; half an object that is not continued is
 * given up. */
#ifndef APP_WIRE_H
#define APP_WIRE_H

#include "io/message.h"

typedef enum { WIRE_UNKNOWN, WIRE_TEXT, WIRE_BINARY } wire_form;

typedef struct {
    ix_ctx *ctx;
    int fd;
    bool socket; /* else a pipe, which is not to be waited for */
    double idle; /* seconds between objects; 0: any */
    wire_form form;
    bool ended;      /* nothing will ever come */
    ix_buf in;       /* bytes that have come ... */
    size_t at;       /* ... those before are done with */
    ix__message msg; /* text */
    char head[2048]; /* the first bytes of a binary object */
    size_t nhead;
} wire;

void wire_init(wire *w, ix_ctx *ctx, int fd, bool socket, wire_form form);
void wire_free(wire *w);

typedef enum {
    WIRE_OBJECT, /* *o: a new reference */
    WIRE_BROKEN, /* a request, number *seq, that cannot be read: the context
                    has the message */
    WIRE_END     /* nothing more (w->ended), or not for now */
} wire_event;
wire_event wire_next(wire *w, ix_obj **o, double *seq);
/* Has anything come, without waiting? Blanks between texts do not count. */
bool wire_pending(wire *w);
/* All of it; meanwhile reads what comes, for the peer may be writing, too.
 * False: the peer has left. */
bool wire_send(wire *w, const char *s, size_t n);

#endif
