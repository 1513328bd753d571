/* srf_centres.c - places of centres of curvature of a surface: the mean evolute
 * and the focal surfaces of isoparametric curves. */
#include <math.h>

#include "geom/vec3.h"
#include "ops/srf_naive.h"

/* x / den, a place in the frame of s. */
static ix_status store_place(ix_ctx *ctx, const ix_surface *s, const ix_form *x,
                             const ix_form *den, const ix_op_opts *o,
                             ix_mv **out)
{
    ix__field f = {den, x, 0, &s->frame};

    return ix__field_store(ctx, &f, o, out);
}

/* As a straightforward system does it. */
static ix_status naive(ix_ctx *ctx, const ix_surface *s, int which,
                       const ix_op_opts *o, ix_mv **out)
{
    ix_srf_naive n;
    ix_frac e;

    IX_TRY(ix__naive_surface(ctx, s, o->form == IX_FORM_IRIT, &n));
    if (which < 0)
        IX_TRY(ix__naive_evolute(ctx, &n, &e));
    else
        IX_TRY(ix__naive_focal(ctx, &n, which, &e));
    return store_place(ctx, s, &e.x, &e.w, o, out);
}

/* (p h + m |m|^2) / (w h). */
static ix_status evolute(ix_ctx *ctx, const ix_surface *s, const ix_op_opts *o,
                         ix_mv **out)
{
    ix_form h, x, y, den;

    IX_TRY(ix__surface_h(ctx, s, &h));
    if (ix__form_is_zero(&h))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the mean curvature is zero everywhere (error band "
                       "%.3g): the evolute is at infinity",
                       s->band);
    if (ix__naive_wanted(o))
        return naive(ctx, s, -1, o, out);
    IX_TRY(ix__form_mul(ctx, &s->p, &h, &x));
    IX_TRY(ix__form_mul(ctx, &s->m, &s->mm, &y));
    IX_TRY(ix__form_add(ctx, &x, 1, &y, &x));
    den = h;
    if (s->rational)
        IX_TRY(ix__form_mul(ctx, &h, &s->w, &den));
    return store_place(ctx, s, &x, &den, o, out);
}

/* (p w^2 b + m g) / (w^3 b). */
static ix_status focal(ix_ctx *ctx, const ix_surface *s, int dir,
                       const ix_op_opts *o, ix_mv **out)
{
    ix_form b = s->b[2 * dir], x, y, den, ww;

    if (ix__form_is_zero(&b))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the normal curvature in direction %d is zero "
                       "everywhere (error band %.3g)",
                       dir, s->band);
    if (ix__naive_wanted(o))
        return naive(ctx, s, dir, o, out);
    den = b;
    if (s->rational) {
        IX_TRY(ix__form_mul(ctx, &s->w, &s->w, &ww));
        IX_TRY(ix__form_mul(ctx, &s->b[2 * dir], &ww, &b));
        IX_TRY(ix__form_mul(ctx, &b, &s->w, &den));
    }
    IX_TRY(ix__form_mul(ctx, &s->p, &b, &x));
    IX_TRY(ix__form_mul(ctx, &s->m, &s->g[2 * dir], &y));
    IX_TRY(ix__form_add(ctx, &x, 1, &y, &x));
    return store_place(ctx, s, &x, &den, o, out);
}

/* --- what they should be ---------------------------------------------------
 */

/* which < 0: the evolute, else the focal surface in that direction. */
static void centre(const ix_srf_jet *j, int which, double *v)
{
    double g = j->g[0] * j->g[2] - j->g[1] * j->g[1], radius;
    double h = (j->g[0] * j->b[2] + j->g[2] * j->b[0] -
                2.0 * j->g[1] * j->b[1]) /
               g;

    radius = which < 0 ? 1.0 / h : j->g[2 * which] / j->b[2 * which];
    ix__axpy3(j->s, radius / ix__len3(j->n), j->n, v);
}

static ix_status build(ix_ctx *ctx, const ix_mv *m, int which,
                       const ix_op_opts *o, ix_mv **out)
{
    ix_surface s;

    IX_TRY(ix__surface_load(ctx, m, &s));
    IX_TRY(ix__surface_forms(ctx, &s));
    return which < 0 ? evolute(ctx, &s, o, out) : focal(ctx, &s, which, o, out);
}

static ix_status centres(ix_ctx *ctx, const ix_mv *s, int which,
                         const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    *out = NULL;
    st = build(ctx, s, which, o, out);
    ix__scratch_release(ctx, mk);
    IX_TRY(st);
    st = ix__srf_measure(ctx, s, *out, centre, which, o, rep);
    if (st != IX_OK) {
        ix_mv_unref(ctx, *out);
        *out = NULL;
    }
    return st;
}

ix_status ix_srf_evolute(ix_ctx *ctx, const ix_mv *s, const ix_op_opts *o,
                         ix_report *rep, ix_mv **out)
{
    return centres(ctx, s, -1, o, rep, out);
}

ix_status ix_srf_focal(ix_ctx *ctx, const ix_mv *s, int dir,
                       const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    *out = NULL;
    if (dir != 0 && dir != 1)
        return IX_FAIL(ctx, IX_EARG, "direction %d of a surface", dir);
    return centres(ctx, s, dir, o, rep, out);
}
