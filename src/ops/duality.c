/* duality.c - tangent lines and planes as points: duals and orthotomics of
 * planar curves and of surfaces. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "ops/surface.h"

/* The tangents of a curve or surface in a frame about origin: n.x + c = 0. */
typedef struct {
    ix_surface s; /* of a curve only frame, degree, rational, band */
    ix_form n, c;
} tangents;

/* --- curves
 * -------------------------------------------------------------------- */

/* Minors of the partials of (x, y, w): degree 2d - 2. */
static ix_status curve_tangents(ix_ctx *ctx, const ix_form *f, bool rational,
                                tangents *t)
{
    static const double one = 1.0;
    int r = rational ? 1 : 0, d = f->dirs[0].degree;
    ix_form p = ix__form_rows(f, r, 2), w = ix__form_rows(f, 0, 1), hom, all;
    ix_form uv[2];
    const ix_form *parts[2] = {&p, &w}, *rows[2] = {&uv[0], &uv[1]};

    if (!r)
        IX_TRY(ix__form_constant(ctx, f, 1, &one, &w));
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

static ix_status load_curve(ix_ctx *ctx, const ix_mv *flat,
                            const double *origin, tangents *t)
{
    ix_surface *s = &t->s;
    double far = 0.0, n;
    ix_form f;
    int e;

    IX_TRY(ix__frame_of(ctx, 1, &flat, &s->frame));
    for (int k = 0; k < 2; k++) {
        far = fmax(far, fabs(s->frame.shift[k] - origin[k]));
        s->frame.shift[k] = origin[k];
    }
    (void)frexp(far, &e);
    if (far > 0.0 && e > s->frame.exp) {
        s->frame.noise = ldexp(s->frame.noise, s->frame.exp - e);
        s->frame.exp = e;
    }
    IX_TRY(ix__forms_load(ctx, 1, &flat, &s->frame, &f));
    s->rational = flat->rational;
    s->degree[0] = f.dirs[0].degree;
    s->band = 8.0 * DBL_EPSILON * (s->degree[0] + 2) + 8.0 * s->frame.noise;
    IX_TRY(curve_tangents(ctx, &f, flat->rational, t));
    IX_TRY(ix__form_bound(ctx, &t->n, &n));
    if (!(n > s->band))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the curve is a point: its tangent is at most %.3g of "
                       "its size, error band %.3g",
                       n, s->band);
    return IX_OK;
}

static ix_status load(ix_ctx *ctx, const ix_mv *m, const double origin[3],
                      tangents *t)
{
    ix_mv *flat;
    ix_status st;

    if (m->ndirs == 2) {
        IX_TRY(ix__surface_load(ctx, m, origin, &t->s));
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
    st = load_curve(ctx, flat, origin, t);
    ix_mv_unref(ctx, flat);
    return st;
}

/* --- results
 * -------------------------------------------------------------------- */

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

static ix_status dual(ix_ctx *ctx, const ix_mv *m, const ix_op_opts *o,
                      ix_mv **out)
{
    static const double zero[3] = {0, 0, 0};
    double c, n;
    tangents t;
    ix__field f = {&t.c, &t.n, 0, NULL};

    IX_TRY(load(ctx, m, zero, &t));
    f.exp = -t.s.frame.exp;
    IX_TRY(ix__form_bound(ctx, &t.c, &c));
    IX_TRY(ix__form_bound(ctx, &t.n, &n));
    if (!(c > t.s.band * n))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "all tangents pass through the origin: the dual is at "
                       "infinity");
    IX_TRY(ix__field_store(ctx, &f, o, out));
    return pad(ctx, m, out);
}

/* -k c n / |n|^2 from p. */
static ix_status orthotomic(ix_ctx *ctx, const ix_mv *m, const double p[3],
                            double k, const ix_op_opts *o, ix_mv **out)
{
    ix_form x, nn;
    tangents t;
    ix__field f = {&nn, &x, 0, &t.s.frame};

    IX_TRY(load(ctx, m, p, &t));
    IX_TRY(ix__form_dot(ctx, &t.n, &t.n, &nn));
    IX_TRY(ix__form_mul(ctx, &t.n, &t.c, &x));
    ix__form_times(&x, -k);
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
