/* srf_normal.c - tangents and normals of surfaces. The normal is S_v x S_u
 * throughout (spec/functions, convention 3). */
#include <math.h>
#include <string.h>

#include "geom/normals.h"
#include "geom/parts.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"
#include "iritx/sym.h"

static ix_status check_surface(ix_ctx *ctx, const ix_mv *s)
{
    if (s->ndirs != 2 || s->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates are no surface in "
                       "space",
                       s->ndirs, s->ncoords);
    return IX_OK;
}

/* The projected partial derivative at t, by the quotient rule. */
static ix_status partial3(ix_ctx *ctx, const ix_mv *s, int dir,
                          const double t[2], double out[3])
{
    double x[4] = {0}, d[4] = {0};
    int k[2] = {dir == 0, dir == 1}, r = s->rational ? 1 : 0;

    IX_TRY(ix_mv_partial(ctx, s, t, k, d));
    if (r) {
        IX_TRY(ix_mv_eval(ctx, s, t, x));
        if (x[0] == 0)
            return IX_FAIL(ctx, IX_EDOMAIN, "a pole at (%g, %g)", t[0], t[1]);
    }
    for (int c = 0; c < 3; c++)
        out[c] = c >= s->ncoords ? 0
                 : r             ? (d[c + 1] - x[c + 1] / x[0] * d[0]) / x[0]
                                 : d[c];
    return IX_OK;
}

ix_status ix_srf_tangent(ix_ctx *ctx, const ix_mv *srf, int dir, double u,
                         double v, double t[3])
{
    IX_TRY(check_surface(ctx, srf));
    if (dir < 0 || dir > 1)
        return IX_FAIL(ctx, IX_EARG, "direction %d of a surface", dir);
    return partial3(ctx, srf, dir, (const double[2]){u, v}, t);
}

ix_status ix_srf_unit_tangent(ix_ctx *ctx, const ix_mv *srf, int dir, double u,
                              double v, double t[3])
{
    IX_TRY(ix_srf_tangent(ctx, srf, dir, u, v, t));
    if (!(ix__unit3(t, t) > 0))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the derivative vanishes at (%g, %g): no tangent", u, v);
    return IX_OK;
}

/* *found is false where S_v x S_u vanishes up to rounding: 1e-10 of the
 * product of the tangents' lengths leaves half of the digits. */
static ix_status try_normal(ix_ctx *ctx, const ix_mv *s, const double t[2],
                            double n[3], bool *found)
{
    double du[3], dv[3], len;

    IX_TRY(partial3(ctx, s, 0, t, du));
    IX_TRY(partial3(ctx, s, 1, t, dv));
    ix__cross3(dv, du, n);
    len = sqrt(ix__dot3(du, du) * ix__dot3(dv, dv));
    *found = ix__unit3(n, n) > 1e-10 * len;
    return IX_OK;
}

ix_status ix_srf_normal(ix_ctx *ctx, const ix_mv *srf, double u, double v,
                        double n[3])
{
    /* Steps towards the middle of the domain, as fractions of it. */
    static const double nudge[] = {0, 1e-6, 1e-4};
    double dom[2][2], t[2];
    bool found;

    IX_TRY(check_surface(ctx, srf));
    for (int d = 0; d < 2; d++)
        ix_mv_domain(srf, d, dom[d]);
    for (int i = 0; i < 3; i++) {
        t[0] = u + nudge[i] * (0.5 * (dom[0][0] + dom[0][1]) - u);
        t[1] = v + nudge[i] * (0.5 * (dom[1][0] + dom[1][1]) - v);
        IX_TRY(try_normal(ctx, srf, t, n, &found));
        if (found)
            return IX_OK;
    }
    return IX_FAIL(ctx, IX_EDOMAIN, "the surface has no normal at (%g, %g)", u,
                   v);
}

static ix_status polynomial_field(ix_ctx *ctx, const ix_mv *s, ix_mv *t[2],
                                  ix_mv **out)
{
    IX_TRY(ix_sym_derive(ctx, s, 1, NULL, &t[0]));
    IX_TRY(ix_sym_derive(ctx, s, 0, NULL, &t[1]));
    return ix_sym_cross(ctx, t[0], t[1], NULL, out);
}

/* The vector numerator of s, or its weight as a scalar. */
static ix_status numerator(ix_ctx *ctx, const ix_mv *s, ix_mv *t[4], ix_mv **x,
                           ix_mv **w)
{
    const ix_mv *axes[3];

    for (int k = 0; k < s->ncoords; k++) {
        IX_TRY(ix_mv_scalar(ctx, s, k + 1, &t[k]));
        axes[k] = t[k];
    }
    IX_TRY(ix_mv_join_scalars(ctx, s->ncoords, axes, false, x));
    return ix_mv_scalar(ctx, s, 0, w);
}

enum { X, W, XU, XV, WU, WV, A, B, C, T1, T2, T3, W2, W3, NUM, REST };

/* w X_v x X_u - w_v X x X_u - w_u X_v x X into t[NUM]. */
static ix_status field_numerator(ix_ctx *ctx, ix_mv *t[REST])
{
    IX_TRY(ix_sym_derive(ctx, t[X], 0, NULL, &t[XU]));
    IX_TRY(ix_sym_derive(ctx, t[X], 1, NULL, &t[XV]));
    IX_TRY(ix_sym_derive(ctx, t[W], 0, NULL, &t[WU]));
    IX_TRY(ix_sym_derive(ctx, t[W], 1, NULL, &t[WV]));
    IX_TRY(ix_sym_cross(ctx, t[XV], t[XU], NULL, &t[A]));
    IX_TRY(ix_sym_cross(ctx, t[X], t[XU], NULL, &t[B]));
    IX_TRY(ix_sym_cross(ctx, t[XV], t[X], NULL, &t[C]));
    IX_TRY(ix_sym_scale(ctx, t[A], t[W], NULL, &t[T1]));
    IX_TRY(ix_sym_scale(ctx, t[B], t[WV], NULL, &t[T2]));
    IX_TRY(ix_sym_scale(ctx, t[C], t[WU], NULL, &t[T3]));
    IX_TRY(ix_sym_sub(ctx, t[T1], t[T2], NULL, &t[A + REST]));
    return ix_sym_sub(ctx, t[A + REST], t[T3], NULL, &t[NUM]);
}

static ix_status rational_field(ix_ctx *ctx, const ix_mv *s, ix_mv *t[2 * REST],
                                ix_mv **out)
{
    const ix_mv *axes[4];

    IX_TRY(numerator(ctx, s, t + REST, &t[X], &t[W]));
    IX_TRY(field_numerator(ctx, t));
    IX_TRY(ix_sym_mul(ctx, t[W], t[W], NULL, &t[W2]));
    IX_TRY(ix_sym_mul(ctx, t[W2], t[W], NULL, &t[W3]));
    axes[0] = t[W3];
    for (int k = 0; k < 3; k++) {
        IX_TRY(ix_mv_scalar(ctx, t[NUM], k, &t[REST + B + k]));
        axes[k + 1] = t[REST + B + k];
    }
    return ix_mv_join_scalars(ctx, 4, axes, true, out);
}

ix_status ix_srf_normal_field(ix_ctx *ctx, const ix_mv *srf, ix_mv **out)
{
    ix_mv *t[2 * REST] = {NULL};
    ix_status st;

    *out = NULL;
    IX_TRY(check_surface(ctx, srf));
    if (srf->ncoords < 2)
        return IX_FAIL(ctx, IX_EARG, "a scalar surface has no normal field");
    if (srf->rational)
        st = rational_field(ctx, srf, t, out);
    else
        st = polynomial_field(ctx, srf, t, out);
    ix__mv_unref_all(ctx, t, 2 * REST);
    return st;
}

/* Unit control vectors of the field, and how many do not vanish: 1e-12 of the
 * longest is the rounding of the products that made them. */
static int unit_vectors(const ix_mv *f, double (*v)[3])
{
    double longest = 0;
    int n = 0;

    for (size_t i = 0; i < f->npts; i++)
        for (int k = 0; k < 3; k++)
            longest = fmax(longest, fabs(ix_mv_coord(f, k)[i]));
    for (size_t i = 0; i < f->npts; i++) {
        for (int k = 0; k < 3; k++)
            v[n][k] = ix_mv_coord(f, k)[i];
        if (ix__unit3(v[n], v[n]) > 1e-12 * longest)
            n++;
    }
    return n;
}

static ix_status cone_of(ix_ctx *ctx, const ix_mv *field, double axis[3],
                         double *half_angle)
{
    double(*v)[3], sum[3] = {0}, worst = 0;
    int n;

    IX_SCRATCH(ctx, v, field->npts);
    n = unit_vectors(field, v);
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++)
            sum[k] += v[i][k];
    if (n == 0)
        return IX_FAIL(ctx, IX_EDOMAIN, "the surface has no normals");
    if (!(ix__unit3(sum, sum) > 0)) /* as many normals one way as another */
        memcpy(sum, v[0], sizeof sum);
    for (int i = 0; i < n; i++) {
        double c[3];

        ix__cross3(v[i], sum, c);
        worst = fmax(worst, atan2(sqrt(ix__dot3(c, c)), ix__dot3(v[i], sum)));
    }
    for (int k = 0; k < 3; k++)
        axis[k] = sum[k];
    *half_angle = worst < 1.57079632679489662 ? worst : 3.14159265358979324;
    return IX_OK;
}

ix_status ix__check_space_surface(ix_ctx *ctx, const ix_mv *s)
{
    if (s->ndirs != 2 || s->ncoords != 3)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions in %d coordinates: a surface in space is "
                       "needed",
                       s->ndirs, s->ncoords);
    return IX_OK;
}

ix_status ix__normals_cone(ix_ctx *ctx, const ix_mv *field, double axis[3],
                           double *half_angle)
{
    IX_RETURN_SCOPED(ctx, cone_of(ctx, field, axis, half_angle));
}

ix_status ix_srf_normal_cone(ix_ctx *ctx, const ix_mv *srf, double axis[3],
                             double *half_angle)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_mv *field = NULL;
    ix_status st;

    st = ix_srf_normal_field(ctx, srf, &field);
    if (st == IX_OK)
        st = cone_of(ctx, field, axis, half_angle);
    ix_mv_unref(ctx, field);
    ix__scratch_release(ctx, mk);
    return st;
}
