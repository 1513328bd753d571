/* prim_apex.c - the bisector of two cones with one apex: a cone.
 *
 * On the unit sphere around the apex the cones are a point u and a circle e(t).
 * A direction P has equal angles to u and e, along a great circle at a right
 * angle to the circle, if P.(u - e) = 0 and P.e' = 0: P = (u - e) x e', a form
 * of degree 2 that is the ruling of the bisector surface of u and the circle.
 */
#include <limits.h>
#include <math.h>

#include "geom/angle.h"
#include "geom/vec3.h"
#include "ops/prim.h"
#include "ops/pt_crv.h"

/* The circle cos n + sin (x, y) on the unit sphere. */
static ix_status sphere_circle(ix_ctx *ctx, const double n[3], double degrees,
                               ix_mv **out)
{
    static const double zero[3] = {0, 0, 0};
    const double c = cos(IX__RADIANS(degrees)), s = sin(IX__RADIANS(degrees));
    ix_prim p = {.kind = IX_PRIM_CONE, .dir = {n[0], n[1], n[2]}};
    ix_prim_axes a;
    double m[16] = {0};
    ix_mv *unit;
    ix_status st;

    IX_TRY(ix__prim_axes(ctx, &p, &a));
    for (int k = 0; k < 3; k++) {
        m[k] = s * a.x[k];
        m[4 + k] = s * a.y[k];
        m[8 + k] = a.z[k];
        m[12 + k] = c * a.z[k];
    }
    m[15] = 1;
    IX_TRY(ix_circle(ctx, zero, 1.0, &unit));
    st = ix_mv_transform(ctx, unit, m, out);
    ix_mv_unref(ctx, unit);
    return st;
}

/* Largest |f| / |w| at a few parameters. */
static double reach(const ix_form *f, const ix_form *w)
{
    const ix_spans *sp = &f->dirs[0];
    double best = 0.0;

    for (int i = 0; i <= 32; i++) {
        double t = sp->breaks[0] +
                   (sp->breaks[sp->nspans] - sp->breaks[0]) * i / 32,
               x[3], y;

        ix__form_eval(f, &t, x);
        ix__form_eval(w, &t, &y);
        best = fmax(best, ix__len3(x) / fabs(y));
    }
    return best;
}

/* The rulings from the apex, as far as range says. */
static ix_status nappe(ix_ctx *ctx, const ix_pt_crv *c, const ix_form *x,
                       const ix_form *ruling, const double range[2],
                       ix_mv **out)
{
    const ix_form *parts[3] = {&c->c.w, x, ruling};
    ix_join_rule rule = {false, INT_MAX};
    ix_form all;

    IX_TRY(ix__form_join(ctx, 3, parts, &all));
    return ix__ruled_store(ctx, &c->c, &all, -c->c.frame.exp, range, rule, out);
}

static ix_status nappes(ix_ctx *ctx, const double apex[3], const ix_mv *circle,
                        const double u[3], double size, ix_mv *out[2])
{
    ix_form ruling, x;
    double at[3], range[2] = {0.0, 0.0};
    ix_pt_crv c;

    IX_TRY(ix__pt_crv_load(ctx, circle, IX__CURVE_SPACE, u, 0.5, true, &c));
    IX_TRY(ix__pt_crv_ruling(ctx, &c, &ruling));
    for (int k = 0; k < 3; k++)
        at[k] = ldexp(apex[k] - c.c.frame.shift[k], -c.c.frame.exp);
    IX_TRY(ix__form_constant(ctx, &c.c.w, 3, at, &x));
    IX_TRY(ix__form_mul(ctx, &x, &c.c.w, &x));
    range[1] = size / reach(&ruling, &c.c.w);
    IX_TRY(nappe(ctx, &c, &x, &ruling, range, &out[0]));
    range[1] = -range[1];
    if (nappe(ctx, &c, &x, &ruling, range, &out[1]) == IX_OK)
        return IX_OK;
    ix_mv_unref(ctx, out[0]);
    out[0] = NULL;
    return IX_ENOMEM;
}

ix_status ix__prim_apex(ix_ctx *ctx, const double apex[3], const double n[3],
                        double degrees, const double u[3], double size,
                        ix_mv *out[2])
{
    double unit[3];
    ix_mv *circle;
    ix_status st;

    IX_TRY(ix__direction(ctx, "the direction", u, unit));
    IX_TRY(sphere_circle(ctx, n, degrees, &circle));
    st = nappes(ctx, apex, circle, unit, size, out);
    ix_mv_unref(ctx, circle);
    return st;
}
