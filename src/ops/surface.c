/* surface.c - the forms of a surface in its frame, in their lowest degrees. */
#include "ops/surface.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

/* --- loading ---------------------------------------------------------------
 */

/* p_i w - p w_i. */
static ix_status tangent(ix_ctx *ctx, const ix_surface *s, int i, ix_form *out)
{
    int d = s->degree[i];

    if (!s->rational || d == 0)
        return ix__form_derive(ctx, &s->p, i, out);
    IX_TRY(ix__form_jacobian(ctx, &s->p, &s->w, i, out));
    ix__form_times(out, 1.0 / (d * ix__spans_mean(&s->p.dirs[i])));
    return IX_OK;
}

/* (m, c) of a rational surface: affine rows, two leading terms less. */
static ix_status rational_plane(ix_ctx *ctx, ix_surface *s)
{
    int low[2] = {3 * s->degree[0] - 2, 3 * s->degree[1] - 2};
    ix_form pu, pv, t;
    const ix_form *rows[3] = {&s->hom, &pv, &pu};

    IX_TRY(ix__form_derive(ctx, &s->hom, 0, &pu));
    IX_TRY(ix__form_derive(ctx, &s->hom, 1, &pv));
    IX_TRY(ix__form_minors(ctx, 3, rows, &t));
    IX_TRY(ix__form_lower(ctx, &t, low, &s->plane));
    s->m = ix__form_rows(&s->plane, 0, 3);
    return IX_OK;
}

static ix_status polynomial_plane(ix_ctx *ctx, ix_surface *s)
{
    int low[2] = {3 * s->degree[0] - 2, 3 * s->degree[1] - 2};
    ix_form c, t;
    const ix_form *parts[2] = {&s->m, &c};

    IX_TRY(ix__form_cross(ctx, &s->t[1], &s->t[0], &s->m));
    IX_TRY(ix__form_dot(ctx, &s->m, &s->p, &t));
    IX_TRY(ix__form_lower(ctx, &t, low, &c));
    ix__form_times(&c, -1.0);
    return ix__form_join(ctx, 2, parts, &s->plane);
}

/* Rounding of sums of products in these degrees, and what the rounding of the
 * input makes of four factors. */
static double error_band(const ix_surface *s)
{
    return 8.0 * DBL_EPSILON * (s->degree[0] + s->degree[1] + 4) +
           8.0 * s->frame.noise;
}

static ix_status check_normal(ix_ctx *ctx, const ix_surface *s)
{
    double m, a, b;

    IX_TRY(ix__form_bound(ctx, &s->m, &m));
    IX_TRY(ix__form_bound(ctx, &s->t[0], &a));
    IX_TRY(ix__form_bound(ctx, &s->t[1], &b));
    if (!(m > s->band * a * b))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the surface has no normal: S_v x S_u is at most %.3g "
                       "of |S_u||S_v|, error band %.3g",
                       a * b > 0.0 ? m / (a * b) : 0.0, s->band);
    return IX_OK;
}

static ix_status load(ix_ctx *ctx, const ix_mv *s, const double *at,
                      ix_surface *out)
{
    static const double one = 1.0;
    int r = s->rational ? 1 : 0;
    const ix_form *parts[2] = {&out->p, &out->w};
    ix_form f;

    IX_TRY(ix__frame_of(ctx, 1, &s, &out->frame));
    out->centred = at && ix__frame_centre(&out->frame, 3, at);
    IX_TRY(ix__forms_load(ctx, 1, &s, &out->frame, &f));
    out->rational = r;
    for (int i = 0; i < 2; i++)
        out->degree[i] = f.dirs[i].degree;
    out->p = ix__form_rows(&f, r, 3);
    out->w = ix__form_rows(&f, 0, 1);
    if (!r)
        IX_TRY(ix__form_constant(ctx, &f, 1, &one, &out->w));
    IX_TRY(ix__form_join(ctx, 2, parts, &out->hom));
    for (int i = 0; i < 2; i++)
        IX_TRY(tangent(ctx, out, i, &out->t[i]));
    IX_TRY(r ? rational_plane(ctx, out) : polynomial_plane(ctx, out));
    out->band = error_band(out);
    return check_normal(ctx, out);
}

ix_status ix__surface_load_plane(ix_ctx *ctx, const ix_mv *s, const double *at,
                                 ix_surface *out)
{
    ix_mv *space;
    ix_status st;

    if (s->ndirs != 2 || s->ncoords < 2 || s->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates: a surface with 2 or "
                       "3 coordinates is needed",
                       s->ndirs, s->ncoords);
    IX_TRY(ix_mv_coerce(ctx, s, 3, s->rational, &space));
    st = load(ctx, space, at, out); /* copies what it needs */
    ix_mv_unref(ctx, space);
    return st;
}

ix_status ix__surface_load(ix_ctx *ctx, const ix_mv *s, ix_surface *out)
{
    IX_TRY(ix__surface_load_plane(ctx, s, NULL, out));
    return ix__form_dot(ctx, &out->m, &out->m, &out->mm);
}

/* --- the fundamental forms ---------------------------------------------------
 */

void ix__form_clear(ix_form *f)
{
    memset(f->c, 0, (size_t)f->nrows * f->n * sizeof *f->c);
}

bool ix__form_is_zero(const ix_form *f)
{
    return ix__bern_largest((size_t)f->nrows * f->n, f->c) == 0.0;
}

/* (m, c).P_ij for i + j = k, or m.S_ij. */
static ix_status second(ix_ctx *ctx, const ix_surface *s, int k, ix_form *out)
{
    const ix_form *p = s->rational ? &s->hom : &s->p;
    const ix_form *n = s->rational ? &s->plane : &s->m;
    int a = s->rational ? 4 : 3, low[2];
    double size, of_n, of_p;
    ix_form d, dd, t;

    for (int i = 0; i < 2; i++) {
        bool both = k == 1, here = k == 2 * i;

        low[i] = a * s->degree[i] - (s->rational ? (both   ? 4
                                                    : here ? 6
                                                           : 2)
                                                 : (both   ? 3
                                                    : here ? 4
                                                           : 1));
    }
    IX_TRY(ix__form_derive(ctx, p, k < 2 ? 0 : 1, &d));
    IX_TRY(ix__form_derive(ctx, &d, k < 1 ? 0 : 1, &dd));
    IX_TRY(ix__form_dot(ctx, n, &dd, &t));
    IX_TRY(ix__form_bound(ctx, &t, &size));
    IX_TRY(ix__form_bound(ctx, n, &of_n));
    IX_TRY(ix__form_bound(ctx, p, &of_p));
    for (int i = 0; i < 2; i++) /* a derivative is at most 2 d / h of it */
        for (int j = 0; j < (k == 1 ? 1 : k == 2 * i ? 2 : 0); j++)
            of_p *= 2.0 * s->degree[i] / ix__spans_mean(&p->dirs[i]);
    if (!(size > s->band * of_n * of_p))
        ix__form_clear(&t);
    return ix__form_lower(ctx, &t, low, out);
}

ix_status ix__surface_forms(ix_ctx *ctx, ix_surface *s)
{
    for (int k = 0; k < 3; k++) {
        IX_TRY(ix__form_dot(ctx, &s->t[k / 2], &s->t[(k + 1) / 2], &s->g[k]));
        IX_TRY(second(ctx, s, k, &s->b[k]));
    }
    return IX_OK;
}

/* A sum that is zero within band times the sizes of its terms becomes so. */
static ix_status snap(ix_ctx *ctx, const ix_surface *s, double terms,
                      ix_form *f)
{
    double size;

    IX_TRY(ix__form_bound(ctx, f, &size));
    if (!(size > s->band * terms))
        ix__form_clear(f);
    return IX_OK;
}

ix_status ix__surface_k(ix_ctx *ctx, const ix_surface *s, ix_form *k)
{
    int less = ix__form_is_zero(&s->b[0]) || ix__form_is_zero(&s->b[2]);
    int low[2];
    double a, b, c;
    ix_form t;

    for (int i = 0; i < 2; i++)
        low[i] = s->rational ? 8 * s->degree[i] - 8
                             : 6 * s->degree[i] - 5 - less;
    IX_TRY(ix__form_mul(ctx, &s->b[0], &s->b[2], &t));
    IX_TRY(ix__form_mul_add(ctx, &s->b[1], -1, &s->b[1], &t));
    IX_TRY(ix__form_bound(ctx, &s->b[0], &a));
    IX_TRY(ix__form_bound(ctx, &s->b[1], &b));
    IX_TRY(ix__form_bound(ctx, &s->b[2], &c));
    IX_TRY(snap(ctx, s, a * c + b * b, &t));
    return ix__form_lower(ctx, &t, low, k);
}

ix_status ix__surface_h(ix_ctx *ctx, const ix_surface *s, ix_form *h)
{
    int low[2];
    double terms = 0.0;
    ix_form t, twice;

    for (int i = 0; i < 2; i++)
        low[i] = s->rational ? 8 * s->degree[i] - 6
                             : 5 * s->degree[i] - 3 -
                                   ix__form_is_zero(&s->b[2 - 2 * i]);
    IX_TRY(ix__form_copy(ctx, &s->b[1], &twice));
    ix__form_times(&twice, 2.0);
    IX_TRY(ix__form_mul(ctx, &s->g[0], &s->b[2], &t));
    IX_TRY(ix__form_mul_add(ctx, &s->g[2], 1, &s->b[0], &t));
    IX_TRY(ix__form_mul_add(ctx, &s->g[1], -1, &twice, &t));
    for (int i = 0; i < 3; i++) {
        double a, b;

        IX_TRY(ix__form_bound(ctx, &s->g[i], &a));
        IX_TRY(ix__form_bound(ctx, &s->b[2 - i], &b));
        terms += a * b * (i == 1 ? 2.0 : 1.0);
    }
    IX_TRY(snap(ctx, s, terms, &t));
    return ix__form_lower(ctx, &t, low, h);
}

ix_status ix__surface_gauss_map(ix_ctx *ctx, const ix_surface *s,
                                ix_form out[2])
{
    for (int i = 0; i < 2; i++) {
        IX_TRY(ix__form_mul(ctx, &s->t[1], &s->b[i], &out[i]));
        IX_TRY(ix__form_mul_add(ctx, &s->t[0], -1, &s->b[i + 1], &out[i]));
    }
    return IX_OK;
}

/* --- results -----------------------------------------------------------------
 */

/* Weights: largest in [1/2, 1), the sum positive. */
static void normalise(ix_form *all)
{
    ix__form_times(all, ix__bern_weight_factor(all->n, all->c));
    all->exp = 0;
}

/* Rows after the weight times 2^exp, or carried back from the frame. */
static void carry_back(const ix__field *f, ix_form *all)
{
    ix_form x = ix__form_rows(all, 1, all->nrows - 1);

    if (f->place)
        ix__frame_back(f->place, 1.0, all->n, all->c, x.c);
    else
        ix__form_times(&x, ldexp(1.0, f->exp));
}

ix_status ix__field_store(ix_ctx *ctx, const ix__field *f, const ix_op_opts *o,
                          ix_mv **out)
{
    const ix_form *parts[2] = {f->den, f->x};
    ix_sym_opts so = {o ? o->max_cont : INT_MAX, 0};
    ix_form all;

    if (o && o->form == IX_FORM_IRIT)
        so.max_cont = 0;
    if (f->den)
        IX_TRY(ix__form_join(ctx, 2, parts, &all));
    else
        IX_TRY(ix__form_copy(ctx, f->x, &all));
    if (f->den) {
        normalise(&all);
        carry_back(f, &all);
    } else {
        ix__form_times(&all, ldexp(1.0, f->exp));
    }
    return ix__form_store(ctx, &all, f->den != NULL, &so, out);
}
