/* offset_side.h - the exact offset of one curve, point by point. */
#ifndef GEOM_OFFSET_SIDE_H
#define GEOM_OFFSET_SIDE_H

#include "geom/path.h"

typedef struct {
    ix_path c;
    bool flat; /* right-hand normal in the XY plane, else principal normal */
    double distance;
    bool varies; /* distance is that of a field */
    ix_path field;
} ix_side;

/* In scratch. field may be NULL. Err IX_EARG a curve of one coordinate, a field
 * that is none; IX_EDOMAIN poles. */
ix_status ix__side_new(ix_ctx *ctx, const ix_mv *crv, double distance,
                       const ix_mv *field, ix_side *out) IX_MUST_CHECK;

/* distance N(t), three coordinates; whole is the domain over which the field is
 * spread. False if there is neither a tangent. */
bool ix__side_shift(const ix_side *s, const double whole[2], double t,
                    double out[3]);

#endif
