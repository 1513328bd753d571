/* srf_radial.c - where the radial curvature of a surface vanishes.
 *
 * With m = S_v x S_u and the projection w of the view on the tangent plane,
 * |m|^2 w = A S_u + B S_v for A = view.(m x S_v), B = view.(S_u x m), so that
 * the normal curvature along w has the zeros of
 *
 *   b_11 A^2 + 2 b_12 A B + b_22 B^2. */
#include <math.h>

#include "geom/vec3.h"
#include "ops/surface.h"
#include "solve/curves_alloc.h"

/* view.(m x t_v), and view.(t_u x m). */
static ix_status components(ix_ctx *ctx, const ix_surface *s,
                            const double view[3], ix_form ab[2])
{
    ix_form v, x;

    IX_TRY(ix__form_constant(ctx, &s->m, 3, view, &v));
    IX_TRY(ix__form_cross(ctx, &s->m, &s->t[1], &x));
    IX_TRY(ix__form_dot(ctx, &v, &x, &ab[0]));
    IX_TRY(ix__form_cross(ctx, &s->t[0], &s->m, &x));
    return ix__form_dot(ctx, &v, &x, &ab[1]);
}

/* The field, exactly zero if it is so within its error. */
static ix_status second_form(ix_ctx *ctx, const ix_surface *s,
                             const ix_form ab[2], ix_form *out)
{
    double size, terms = 0.0, of[2];
    ix_form p, t, zero;

    IX_TRY(ix__form_mul(ctx, &ab[0], &ab[0], &p));
    IX_TRY(ix__form_mul(ctx, &s->b[0], &p, out));
    IX_TRY(ix__form_mul(ctx, &ab[0], &ab[1], &p));
    ix__form_times(&p, 2.0);
    IX_TRY(ix__form_mul_add(ctx, &s->b[1], 1, &p, out));
    IX_TRY(ix__form_mul(ctx, &ab[1], &ab[1], &p));
    IX_TRY(ix__form_mul(ctx, &s->b[2], &p, &t));
    IX_TRY(ix__form_add(ctx, out, 1, &t, &zero));
    *out = zero;
    for (int i = 0; i < 2; i++)
        IX_TRY(ix__form_bound(ctx, &ab[i], &of[i]));
    for (int k = 0; k < 3; k++) {
        IX_TRY(ix__form_bound(ctx, &s->b[k], &size));
        terms += (k == 1 ? 2.0 : 1.0) * size * of[k / 2] * of[(k + 1) / 2];
    }
    IX_TRY(ix__form_bound(ctx, out, &size));
    if (!(size > s->band * terms))
        ix__form_clear(out);
    return IX_OK;
}

static ix_status field(ix_ctx *ctx, const ix_mv *m, const double view[3],
                       ix_mv **out)
{
    ix_form ab[2], f;
    ix_surface s;

    IX_TRY(ix__surface_load(ctx, m, &s));
    IX_TRY(ix__surface_forms(ctx, &s));
    IX_TRY(components(ctx, &s, view, ab));
    IX_TRY(second_form(ctx, &s, ab, &f));
    return ix__form_store(ctx, &f, false, NULL, out);
}

ix_status ix_srf_radial_field(ix_ctx *ctx, const ix_mv *s, const double view[3],
                              ix_mv **out)
{
    double unit[3];

    *out = NULL;
    IX_TRY(ix__direction(ctx, "the view", view, unit));
    IX_RETURN_SCOPED(ctx, field(ctx, s, unit, out));
}

/* --- curves
 * -------------------------------------------------------------------- */

#define FRONTAL                                                    \
    1e-6 /* a projection below this part of the view has lost half \
            of its digits */

/* (a, b) of the view's projection at (u, v), of length 1; false where the view
 * is along the normal, or there is none. */
static ix_status projection(ix_ctx *ctx, const ix_mv *s, const double view[3],
                            const double *uv, double ab[2], bool *out)
{
    double p, q, det, len2;
    ix_srf_jet j;
    ix_status st = ix__srf_jet(ctx, s, uv[0], uv[1], &j);

    *out = false;
    if (st == IX_EDOMAIN)
        return IX_OK;
    IX_TRY(st);
    p = ix__dot3(view, j.su);
    q = ix__dot3(view, j.sv);
    det = j.g[0] * j.g[2] - j.g[1] * j.g[1];
    ab[0] = (j.g[2] * p - j.g[1] * q) / det;
    ab[1] = (j.g[0] * q - j.g[1] * p) / det;
    len2 = ab[0] * p + ab[1] * q; /* |w|^2 */
    *out = len2 > FRONTAL * FRONTAL;
    p = hypot(ab[0], ab[1]);
    for (int i = 0; *out && i < 2; i++)
        ab[i] /= p;
    return IX_OK;
}

/* One curve with the directions; where there is none, that of the nearest
 * vertex before, else after. */
static ix_status put_curve(ix_ctx *ctx, const ix_mv *s, const double view[3],
                           const ix_solution_curve *in, double *x,
                           ix_solution_curve *out, bool *any)
{
    int known = -1;

    *out = *in;
    out->x = x;
    for (int i = 0; i < in->n; i++) {
        double *y = x + 4 * (size_t)i;
        bool found;

        y[0] = in->x[2 * (size_t)i];
        y[1] = in->x[2 * (size_t)i + 1];
        y[2] = y[3] = 0.0;
        IX_TRY(projection(ctx, s, view, y, y + 2, &found));
        if (!found)
            continue;
        for (int k = known < 0 ? 0 : i; k < i; k++) {
            x[4 * (size_t)k + 2] = y[2];
            x[4 * (size_t)k + 3] = y[3];
        }
        known = i;
    }
    for (int i = 1; known >= 0 && i < in->n; i++) {
        double *y = x + 4 * (size_t)i;

        if (!(hypot(y[2], y[3]) > 0.5)) {
            y[2] = y[-2];
            y[3] = y[-1];
        }
    }
    *any = known >= 0;
    return IX_OK;
}

/* Curves without any direction, such as edges that are points, go. */
static ix_status with_directions(ix_ctx *ctx, const ix_mv *s,
                                 const double view[3],
                                 const ix_solution_curves *in,
                                 ix_solution_curves *out)
{
    size_t n = 0;
    double *x;

    *out = *in;
    out->unknowns = 4;
    out->ncurves = out->nsingular = 0;
    for (int i = 0; i < in->ncurves; i++)
        n += (size_t)in->curve[i].n;
    IX_TRY(ix__solution_curves_alloc(ctx, 4 * n, (size_t)in->ncurves,
                                     (size_t)in->nsingular, out, &x));
    for (; out->nsingular < in->nsingular; out->nsingular++) {
        out->singular[out->nsingular] = in->singular[out->nsingular];
        out->arcs[out->nsingular] = in->arcs[out->nsingular];
    }
    for (int i = 0; i < in->ncurves; i++) {
        bool any;

        IX_TRY(put_curve(ctx, s, view, &in->curve[i], x,
                         &out->curve[out->ncurves], &any));
        x += 4 * (size_t)in->curve[i].n;
        out->ncurves += any;
    }
    return IX_OK;
}

static ix_status trace(ix_ctx *ctx, const ix_mv *s, const double view[3],
                       const ix_mv *f, double tol, ix_solution_curves *out)
{
    const ix_equation eq = {.f = f, .rel = IX_EQUAL_ZERO};
    const ix_curves_opts o = {.tol = tol};
    ix_solution_curves plain;
    ix_status st;

    if (ix__bern_largest(f->npts, f->pts) == 0.0)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the radial curvature is zero everywhere: a plane, or "
                       "rulings along the view");
    IX_TRY(ix_solve_curves(ctx, 1, &eq, &o, &plain));
    st = with_directions(ctx, s, view, &plain, out);
    ix_solution_curves_free(ctx, &plain);
    if (st != IX_OK)
        ix_solution_curves_free(ctx, out);
    return st;
}

ix_status ix_srf_radial(ix_ctx *ctx, const ix_mv *s, const double view[3],
                        double tol, ix_solution_curves *out)
{
    double unit[3];
    ix_status st;
    ix_mv *f;

    *out = (ix_solution_curves){.unknowns = 4};
    IX_TRY(ix__direction(ctx, "the view", view, unit));
    IX_TRY(ix_srf_radial_field(ctx, s, unit, &f));
    st = trace(ctx, s, unit, f, tol, out);
    ix_mv_unref(ctx, f);
    return st;
}
