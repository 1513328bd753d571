/* offset_side.c - by how much a point of a curve moves when it is offset. */
#include "geom/offset_side.h"

#include "geom/vec3.h"

static ix_status load_field(ix_ctx *ctx, const ix_mv *field, ix_side *s)
{
    if (!field)
        return IX_OK;
    if (field->ndirs != 1 || field->ncoords != 1)
        return IX_FAIL(ctx, IX_EARG,
                       "a distance of %d directions and %d coordinates; a "
                       "scalar curve is wanted",
                       field->ndirs, field->ncoords);
    IX_TRY(ix__path_new(ctx, field, &s->field));
    s->varies = true;
    return ix__path_no_poles(ctx, &s->field);
}

ix_status ix__side_new(ix_ctx *ctx, const ix_mv *crv, double distance,
                       const ix_mv *field, ix_side *out)
{
    *out = (ix_side){.distance = distance};
    IX_TRY(ix__path_new(ctx, crv, &out->c));
    if (crv->ncoords < 2 || !isfinite(distance))
        return IX_FAIL(ctx, IX_EARG,
                       "a curve of %d coordinates to be offset by %g",
                       crv->ncoords, distance);
    out->flat = crv->ncoords < 3 || crv->dirs[0].order < 3;
    IX_TRY(ix__path_no_poles(ctx, &out->c));
    return load_field(ctx, field, out);
}

static double distance_at(const ix_side *s, const double whole[2], double t)
{
    const ix_path *f = &s->field;
    double a, b, out[IX_MAX_COORDS];

    if (!s->varies)
        return s->distance;
    a = f->breaks[0];
    b = f->breaks[f->nspans];
    t = a + (b - a) * ((t - whole[0]) / (whole[1] - whole[0]));
    ix__path_point(f, fmax(a, fmin(b, t)), out);
    return out[0];
}

/* The principal normal, a little aside where there is none. */
static bool principal(const ix_path *c, int span, double t, double n[3])
{
    static const double aside[] = {0, 1e-6, -1e-6};
    double h = c->breaks[span + 1] - c->breaks[span];

    for (int i = 0; i < 3; i++)
        if (ix__path_normal3(c, span, t + aside[i] * h, n))
            return true;
    return false;
}

bool ix__side_shift(const ix_side *s, const double whole[2], double t,
                    double out[3])
{
    const ix_path *c = &s->c;
    int span = ix__path_span(c, t);
    double n[3] = {0}, u[3], d = distance_at(s, whole, t);

    if (s->flat || !principal(c, span, t, n)) {
        if (!ix__path_tangent3(c, span, t, t >= c->breaks[c->nspans], u))
            return false;
        n[0] = u[1];
        n[1] = -u[0];
        n[2] = 0;
        if (!(ix__unit3(n, n) > 0)) /* straight up: any side is as good */
            ix__perp3(u, n);
    }
    for (int k = 0; k < 3; k++)
        out[k] = d * n[k];
    return true;
}
