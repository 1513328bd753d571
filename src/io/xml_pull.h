/* xml_pull.h - XML as a sequence of events, one pulled after the other.
 *
 * libxml2 is fed the text in pieces; what it reports waits in a queue that is
 * never longer than one piece. No tree is made, nothing is fetched, and what
 * could grow is bounded: see the limits. */
#ifndef IO_XML_PULL_H
#define IO_XML_PULL_H

#include "io/text.h"

#define IX_XML_NAMESPACE "urn:iritx:geometry"

/* More of it is refused. */
#define IX_XML_MAX_TAG   ((size_t)1 << 16) /* bytes of a start tag */
#define IX_XML_MAX_TEXT  ((size_t)8 << 20) /* bytes of one element's text */
#define IX_XML_MAX_NODES ((size_t)1 << 25) /* tags, comments, instructions */

typedef enum { IX_X_START, IX_X_END, IX_X_TEXT, IX_X_EOF } ix__xkind;

/* Valid until the next one is pulled. */
typedef struct {
    ix__xkind kind;
    size_t at; /* offset of the element's <; of text: where it begins */
    int nattrs;
    const char *s; /* START: the name; then names and values of attributes,
                      each with its NUL. TEXT: not terminated */
    size_t n;      /* of TEXT */
} ix__xevent;

typedef struct ix__xml ix__xml;

/* src stays the caller's. Err IX_ENOMEM. */
ix_status ix__xml_open(ix__input *src, ix__xml **out) IX_MUST_CHECK;
void ix__xml_close(ix__xml *x); /* x may be NULL */
/* Err IX_EPARSE (with name:line:col) not XML in UTF-8, not well-formed, a
 * DOCTYPE, over a limit, an element of another namespace. */
ix_status ix__xml_next(ix__xml *x, ix__xevent *e) IX_MUST_CHECK;

/* IX_EPARSE with "file:line:col: error: " before the text. */
ix_status ix__xml_fail(ix__xml *x, size_t at, const char *fmt, ...)
    IX_PRINTF(3, 4);
/* A note with "file:line:col: warning: "; the first 20 of a file. */
void ix__xml_warn(ix__xml *x, size_t at, const char *fmt, ...) IX_PRINTF(3, 4);
ix_ctx *ix__xml_ctx(const ix__xml *x);
size_t ix__xml_most(const ix__xml *x); /* bytes of the whole text, at most */

#endif
