/* duality.c - tangent lines and planes as points: duals and orthotomics of
 * planar curves and of surfaces. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "ops/srf_naive.h"

/* A curve or surface in its own frame, and its tangents n.X + c = 0 there. */
typedef struct {
    ix_surface s; /* of a curve only frame, degree, rational, band */
    ix_frac x;
    ix_form n, c;
} tangents;

/* --- curves ----------------------------------------------------------------
 */

/* Minors of the partials of (x, y, w): degree 2d - 2. */
static ix_status curve_tangents(ix_ctx *ctx, const ix_form *f, tangents *t)
{
    static const double one = 1.0;
    int r = t->s.rational ? 1 : 0, d = f->dirs[0].degree;
    ix_form hom, all, uv[2];
    const ix_form *parts[2] = {&t->x.x, &t->x.w}, *rows[2] = {&uv[0], &uv[1]};

    t->x = (ix_frac){ix__form_rows(f, r, 2), ix__form_rows(f, 0, 1),
                     t->s.rational};
    if (!r)
        IX_TRY(ix__form_constant(ctx, f, 1, &one, &t->x.w));
    IX_TRY(ix__form_join(ctx, 2, parts, &hom));
    if (d == 0)
        return IX_FAIL(ctx, IX_EDOMAIN, "the curve is a point");
    IX_TRY(ix__form_partials(ctx, &hom, 0, 1, uv));
    IX_TRY(ix__form_minors(ctx, 2, rows, &all));
    t->n = ix__form_rows(&all, 0, 2);
    t->c = ix__form_rows(&all, 2, 1);
    if (r)
        return IX_OK;
    d--; /* the tangent of a polynomial curve */
    return ix__form_lower(ctx, &t->n, &d, &t->n);
}

static ix_status load_curve(ix_ctx *ctx, const ix_mv *flat, tangents *t)
{
    ix_surface *s = &t->s;
    ix_form f;
    double n;

    IX_TRY(ix__frame_of(ctx, 1, &flat, &s->frame));
    IX_TRY(ix__forms_load(ctx, 1, &flat, &s->frame, &f));
    s->rational = flat->rational;
    s->degree[0] = f.dirs[0].degree;
    s->band = 8.0 * DBL_EPSILON * (s->degree[0] + 2) + 8.0 * s->frame.noise;
    IX_TRY(curve_tangents(ctx, &f, t));
    IX_TRY(ix__form_bound(ctx, &t->n, &n));
    if (!(n > s->band))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the curve is a point: its tangent is at most %.3g of "
                       "its size, error band %.3g",
                       n, s->band);
    return IX_OK;
}

static ix_status load(ix_ctx *ctx, const ix_mv *m, tangents *t)
{
    ix_mv *flat;
    ix_status st;

    if (m->ndirs == 2) {
        IX_TRY(ix__surface_load(ctx, m, &t->s));
        t->x = (ix_frac){t->s.p, t->s.w, t->s.rational};
        t->n = t->s.m;
        t->c = ix__form_rows(&t->s.plane, 3, 1);
        return IX_OK;
    }
    if (m->ndirs != 1 || m->ncoords < 2 || m->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates: a planar curve or a "
                       "surface is needed",
                       m->ndirs, m->ncoords);
    IX_TRY(ix_mv_coerce(ctx, m, 2, m->rational, &flat));
    st = load_curve(ctx, flat, t);
    ix_mv_unref(ctx, flat);
    return st;
}

/* --- as a straightforward system does it
 * --------------------------------------
 */

/* The normal, not of length 1: (-y', x') or S_v x S_u, by the quotient rule. */
static ix_status naive_normal(ix_ctx *ctx, const ix_frac *x, ix_frac *out)
{
    static const double one = 1.0;
    ix_frac d[2];
    ix_form unit;

    for (int i = 0; i < x->x.ndirs; i++)
        IX_TRY(ix__ratio_partial(ctx, x, i, &d[i]));
    if (x->x.ndirs == 2)
        return ix__ratio_product(ctx, ix__form_cross, &d[1], &d[0], out);
    *out = d[0];
    IX_TRY(ix__form_constant(ctx, &x->x, 1, &one, &unit));
    return ix__form_turned(ctx, &unit, &d[0].x, &out->x);
}

/* x - p for the point p of the frame. */
static ix_status from_point(ix_ctx *ctx, const ix_frac *x, const double *p,
                            ix_frac *out)
{
    ix_frac at = {.rational = false};

    IX_TRY(ix__form_constant(ctx, &x->x, x->x.nrows, p, &at.x));
    return ix__ratio_add(ctx, x, -1, &at, out);
}

/* n / -(n.(x - p)), where IRIT keeps numerators over the common weight. */
static ix_status naive_dual(ix_ctx *ctx, const tangents *t, const double *p,
                            bool irit, ix_frac *out)
{
    ix_frac x, n, c;

    IX_TRY(from_point(ctx, &t->x, p, &x));
    IX_TRY(naive_normal(ctx, &t->x, &n));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &n, &x, &c));
    ix__form_times(&c.x, -1.0);
    if (!irit || !n.rational)
        return ix__ratio_over(ctx, &n, &c, out);
    *out = (ix_frac){.w = c.x, .rational = true};
    return ix__form_mul(ctx, &n.x, &t->x.w, &out->x);
}

/* p + k (n.(x - p)) n / |n|^2. */
static ix_status naive_orthotomic(ix_ctx *ctx, const tangents *t,
                                  const double *p, double k, ix_frac *out)
{
    ix_frac x, n, nn, at = {.rational = false};

    IX_TRY(from_point(ctx, &t->x, p, &x));
    IX_TRY(naive_normal(ctx, &t->x, &n));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &n, &x, &x));
    IX_TRY(ix__ratio_product(ctx, ix__form_mul, &n, &x, &x));
    ix__form_times(&x.x, k);
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &n, &n, &nn));
    IX_TRY(ix__ratio_over(ctx, &x, &nn, &x));
    IX_TRY(ix__form_constant(ctx, &t->n, t->n.nrows, p, &at.x));
    return ix__ratio_add(ctx, &at, 1, &x, out);
}

/* --- results ---------------------------------------------------------------
 */

/* Missing coordinates of a curve with three of them are 0. */
static ix_status pad(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    ix_mv *t;
    ix_status st;

    if ((*out)->ncoords >= m->ncoords)
        return IX_OK;
    st = ix_mv_coerce(ctx, *out, m->ncoords, true, &t);
    ix_mv_unref(ctx, *out);
    *out = st == IX_OK ? t : NULL;
    return st;
}

/* The place of a point in the frame: exact but for its last place, however far
 * the curve or surface is. */
static void place_of(const ix_frame *f, const double p[3], double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = k < f->ncoords ? ldexp(p[k] - f->shift[k], -f->exp) : 0.0;
}

/* n.(X - p) + c' = 0 is the tangent: c' = c + n.p. What is far from p has its
 * digits in n and c; in a frame about p they would cancel. */
static ix_status constant_about(ix_ctx *ctx, const tangents *t, const double *p,
                                ix_form *out)
{
    ix_form at, np;

    IX_TRY(ix__form_constant(ctx, &t->n, t->n.nrows, p, &at));
    IX_TRY(ix__form_dot(ctx, &t->n, &at, &np));
    return ix__form_add(ctx, &t->c, 1, &np, out);
}

/* The dual is at infinity if all of c is within the error of its terms. */
static ix_status check_constant(ix_ctx *ctx, const tangents *t, const double *p,
                                const ix_form *c)
{
    double size, n, terms, far = 0.0;

    IX_TRY(ix__form_bound(ctx, c, &size));
    IX_TRY(ix__form_bound(ctx, &t->n, &n));
    IX_TRY(ix__form_bound(ctx, &t->c, &terms));
    for (int k = 0; k < t->n.nrows; k++)
        far = fmax(far, fabs(p[k]));
    if (!(size > t->s.band * fmax(n * fmax(far, 1.0), terms)))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "all tangents pass through the origin: the dual is at "
                       "infinity");
    return IX_OK;
}

static ix_status dual(ix_ctx *ctx, const ix_mv *m, const ix_op_opts *o,
                      ix_mv **out)
{
    static const double zero[3] = {0, 0, 0};
    double p[3];
    tangents t;
    ix_frac r;
    ix__field f = {&r.w, &r.x, 0, NULL};

    IX_TRY(load(ctx, m, &t));
    place_of(&t.s.frame, zero, p);
    IX_TRY(constant_about(ctx, &t, p, &r.w));
    IX_TRY(check_constant(ctx, &t, p, &r.w));
    r.x = t.n;
    if (ix__naive_wanted(o))
        IX_TRY(naive_dual(ctx, &t, p, o->form == IX_FORM_IRIT, &r));
    f.exp = -t.s.frame.exp;
    IX_TRY(ix__field_store(ctx, &f, o, out));
    return pad(ctx, m, out);
}

/* p - k c n / |n|^2. */
static ix_status minimal_orthotomic(ix_ctx *ctx, const tangents *t,
                                    const double *p, double k, ix_frac *out)
{
    ix_form c, at;

    IX_TRY(constant_about(ctx, t, p, &c));
    IX_TRY(ix__form_dot(ctx, &t->n, &t->n, &out->w));
    IX_TRY(ix__form_mul(ctx, &t->n, &c, &out->x));
    ix__form_times(&out->x, -k);
    IX_TRY(ix__form_constant(ctx, &t->n, t->n.nrows, p, &at));
    return ix__form_mul_add(ctx, &at, 1, &out->w, &out->x);
}

static ix_status orthotomic(ix_ctx *ctx, const ix_mv *m, const double point[3],
                            double k, const ix_op_opts *o, ix_mv **out)
{
    double p[3];
    tangents t;
    ix_frac r;
    ix__field f = {&r.w, &r.x, 0, &t.s.frame};

    IX_TRY(load(ctx, m, &t));
    place_of(&t.s.frame, point, p);
    if (ix__naive_wanted(o))
        IX_TRY(naive_orthotomic(ctx, &t, p, k, &r));
    else
        IX_TRY(minimal_orthotomic(ctx, &t, p, k, &r));
    IX_TRY(ix__field_store(ctx, &f, o, out));
    return pad(ctx, m, out);
}

/* --- entries
 * --------------------------------------------------------------------- */

ix_status ix_duality(ix_ctx *ctx, const ix_mv *m, const ix_op_opts *o,
                     ix_mv **out)
{
    *out = NULL;
    IX_RETURN_SCOPED(ctx, dual(ctx, m, o, out));
}

ix_status ix_orthotomic(ix_ctx *ctx, const ix_mv *m, const double p[3],
                        double k, const ix_op_opts *o, ix_mv **out)
{
    *out = NULL;
    if (!isfinite(k) || !isfinite(p[0] + p[1] + p[2]))
        return IX_FAIL(ctx, IX_EARG,
                       "k = %g and p = (%g, %g, %g) must be finite", k, p[0],
                       p[1], p[2]);
    IX_RETURN_SCOPED(ctx, orthotomic(ctx, m, p, k, o, out));
}
