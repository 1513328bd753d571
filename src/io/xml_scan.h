/* xml_scan.h - what no XML of ours may contain, found before parsing it. */
#ifndef IO_XML_SCAN_H
#define IO_XML_SCAN_H

#include "io/xml_pull.h"

typedef struct {
    const char *what;
    size_t at;
} ix__xml_flaw;

/* False, and the flaw, if the text has a DOCTYPE, NUL bytes, another encoding
 * than UTF-8, or is over a limit of io/xml_pull.h. */
bool ix__xml_scan(const char *s, size_t n, ix__xml_flaw *flaw);

#endif
