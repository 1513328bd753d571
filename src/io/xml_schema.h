/* xml_schema.h - the patterns of a RELAX NG schema, and what is left of them
 * when part of a document has been seen (their derivatives: Brzozowski 1964;
 * for RELAX NG Clark 2002).
 *
 * Patterns are numbers; equal patterns are one, so that they stay few however
 * long a document is. The part of RELAX NG that docs/iritx.rng uses is known:
 * no interleave, no mixed content, and within one element a name stands for one
 * kind of element only. */
#ifndef IO_XML_SCHEMA_H
#define IO_XML_SCHEMA_H

#include "base/buf.h"

typedef struct ix__schema ix__schema;
typedef int ix__pat;

#define IX_PAT_NONE 0 /* the pattern that nothing matches */

/* text[n] is trusted. Err IX_ENOMEM. */
ix_status ix__schema_open(ix_ctx *ctx, const char *text, size_t n,
                          ix__schema **out) IX_MUST_CHECK;
void ix__schema_close(ix__schema *s); /* s may be NULL */

/* All of these may run out of memory: ix__schema_check tells at the end of a
 * step, until then they return anything. */
ix_status ix__schema_check(const ix__schema *s) IX_MUST_CHECK;

ix__pat ix__schema_start(ix__schema *s); /* one root element */
/* The kind of element of this name that may come now; -1 if none may. */
int ix__schema_find(ix__schema *s, ix__pat p, const char *name);
ix__pat ix__schema_content(ix__schema *s, int kind);
/* Behind an element of this kind. */
ix__pat ix__schema_behind(ix__schema *s, ix__pat p, int kind);
/* With an attribute; IX_PAT_NONE if it may not stand here, or not so. */
ix__pat ix__schema_with(ix__schema *s, ix__pat p, const char *name,
                        const char *value);
/* Without further attributes; IX_PAT_NONE if some are needed. */
ix__pat ix__schema_closed(ix__schema *s, ix__pat p);
bool ix__schema_may_end(const ix__schema *s, ix__pat p);
/* Is s the text of an element that has no children? */
bool ix__schema_text(ix__schema *s, ix__pat p, const char *text, size_t n);
/* Names of the elements, or of the attributes, that may come now: "a, b". */
void ix__schema_expected(const ix__schema *s, ix__pat p, bool attributes,
                         char *out, size_t room);

#endif
