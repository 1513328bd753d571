/* message.h - objects that come one behind the other through a socket or a
 * pipe, as text: where one ends, and which were requests to us.
 *
 * IRIT writes one line an entity. Its strings are not escaped: a line
 * [STRING "..."] holds one up to the last "] of the line, whatever is between.
 * Outside of quotes, the bracket that closes the first one ends a message. */
#ifndef IO_MESSAGE_H
#define IO_MESSAGE_H

#include "io/io.h"

/* What begins a request: list("IRITX/1", number, ...). */
#define IX_MESSAGE_HEAD "IRITX/1"

typedef struct {
    ix_buf text;    /* of the message so far, its strings escaped; nothing
                       before the first bracket is kept */
    int depth;      /* of open brackets */
    int state;      /* of the character that comes next */
    size_t line[3]; /* where this line and the two before it begin */
    size_t string;  /* where the text of a string begins */
    size_t part;    /* ... and this line of it */
} ix__message;

void ix__message_init(ix__message *m, ix_ctx *ctx);
void ix__message_free(ix__message *m);
/* Forgets what has come. Memory beyond a usual message's is given back. */
void ix__message_clear(ix__message *m);

/* Takes bytes of s[n] up to the end of a message; *used of them are done with,
 * *complete tells whether that end was reached. A request that begins inside a
 * message (the rest of that one never came) takes its place. Err IX_ENOMEM,
 * IX_EUNABLE more than IX_MAX_TEXT bytes; m is to be cleared then. */
ix_status ix__message_feed(ix__message *m, const char *s, size_t n,
                           size_t *used, bool *complete) IX_MUST_CHECK;
/* The object of a complete message; one without a body is an empty list. Err
 * IX_EPARSE (message "message:line:col: error: ..."), IX_ENOMEM. */
ix_status ix__message_object(const ix__message *m, ix_obj **out) IX_MUST_CHECK;
/* Is it a request, by a look at its beginning, even if it cannot be read? *seq
 * is its number, 0 if there is none. */
bool ix__message_is_request(const ix__message *m, double *seq);
/* The same for the first bytes of a binary record. */
bool ix__record_is_request(const char *s, size_t n, double *seq);

#endif
