/* ops.h - the geometric operators as script functions, registered through the
 * interface of plug-ins. Their files use what a plug-in has: include/iritx. */
#ifndef IRIT_EXT_OPS_OPS_H
#define IRIT_EXT_OPS_OPS_H

#include "iritx/plugin.h"

/* As ix_plugin_init, one for each file. */
ix_status ix__ops_curves(const ix_host *h, ix_registry *r);
ix_status ix__ops_surfaces(const ix_host *h, ix_registry *r);

/* Values of the attribute GeomType: GEOM_RULED_SRF, GEOM_DEVELOP_SRF. */
enum { GEOM_RULED = 13, GEOM_DEVELOP = 14 };

/* p = n scratch items of p's type, or return IX_ENOMEM. */
#define SCRATCH(h, c, p, n)                                \
    do {                                                   \
        (p) = (h)->scratch((c), (size_t)(n), sizeof *(p)); \
        if (!(p))                                          \
            return IX_ENOMEM;                              \
    } while (0)

#endif
