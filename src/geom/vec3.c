/* vec3.c - the one operation on three numbers that can fail. */
#include "geom/vec3.h"

ix_status ix__direction(ix_ctx *ctx, const char *what, const double v[3],
                        double out[3])
{
    double len = ix__unit3(v, out);

    if (!(len > 0) || !isfinite(len))
        return IX_FAIL(ctx, IX_EARG, "%s (%g, %g, %g) has no direction", what,
                       v[0], v[1], v[2]);
    return IX_OK;
}
