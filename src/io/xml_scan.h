/* xml_scan.h - what no XML of ours may contain, found before parsing it. */
#ifndef IO_XML_SCAN_H
#define IO_XML_SCAN_H

#include "io/xml_pull.h"

typedef struct {
    const char *what;
    size_t at;
} ix__xml_flaw;

typedef enum {
    IX_XS_TEXT,
    IX_XS_OPEN, /* behind a <, while it is not clear what it opens */
    IX_XS_TAG,
    IX_XS_UNTIL /* in a comment, an instruction, CDATA */
} ix__xml_state;

/* Where the look over a text has got to; zeroed before the first piece. */
typedef struct {
    ix__xml_state state;
    size_t done;  /* bytes looked at */
    size_t nodes; /* tags, comments, instructions */
    size_t open;  /* where the present one began */
    char head[16];
    int nhead;        /* its first characters, while they tell what it is */
    char quote;       /* within a tag; NUL: outside quotes */
    const char *mark; /* what ends a comment ... */
    int matched;      /* ... and how much of it has just been seen */
} ix__xml_scan;

/* The next n bytes of the text. False, and the flaw, if there is a DOCTYPE, a
 * NUL byte, another encoding than UTF-8 (told by the first piece, which must
 * hold the declaration), or something is over a limit of io/xml_pull.h. */
bool ix__xml_scan_piece(ix__xml_scan *c, const char *s, size_t n,
                        ix__xml_flaw *flaw);

#endif
