/* curve_store.c - forms in a curve's frame to curves and surfaces of the
 * user's space. */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "geom/parts.h"
#include "ops/curve.h"

ix_join_rule ix__join_rule(const ix_op_opts *o)
{
    bool irit = o && o->form == IX_FORM_IRIT;

    return (ix_join_rule){irit, irit ? 0 : o ? o->max_cont : INT_MAX};
}

/* IRIT joins pieces whose ends are equal: up to this part of the coefficients
 * next to them, wider than what rounding leaves at the degrees in question. */
#define EQUAL_ENDS 1e-9

/* True if the coefficients on both sides of at agree, at[-1] and at[0]. */
static bool ends_meet(const double *at, size_t m)
{
    size_t near = m > 1 ? 2 : 1;

    return fabs(at[0] - at[-1]) <=
           EQUAL_ENDS * ix__bern_largest(2 * near, at - near);
}

/* Joins as IRIT makes them: C0 or a jump, by the values; what is known to be
 * smoother stays so up to max_cont. */
static ix_status irit_joins(ix_ctx *ctx, ix_form *f, int max_cont)
{
    const ix_spans *sp = &f->dirs[0];
    size_t m = (size_t)sp->degree + 1;
    const double *b;
    ix_spans *own;
    int *cont;

    IX_TRY(ix__form_bernstein(ctx, f, &b));
    IX_SCRATCH(ctx, cont, sp->nspans);
    IX_SCRATCH(ctx, own, 1);
    for (int j = 0; j + 1 < sp->nspans; j++) {
        cont[j] = 0;
        if (max_cont > 0 && sp->cont[j] > 0) {
            cont[j] = sp->cont[j];
            continue;
        }
        for (int r = 0; r < f->nrows; r++)
            if (!ends_meet(b + (size_t)r * f->n + (size_t)(j + 1) * m, m))
                cont[j] = -1;
    }
    *own = *sp;
    own->cont = cont;
    f->dirs = own;
    return IX_OK;
}

/* Control points of one or two forms joined, and their direction. */
static ix_status points_of(ix_ctx *ctx, ix_form *f, ix_join_rule rule,
                           ix_dir *dir, double **pts)
{
    ix_sym_opts so = {rule.max_cont, 0};
    const double *x;

    if (rule.irit)
        IX_TRY(irit_joins(ctx, f, rule.max_cont));
    IX_TRY(ix__form_dirs(ctx, f, &so, dir));
    IX_TRY(ix__form_points(ctx, f, dir, &x));
    IX_SCRATCH(ctx, *pts, (size_t)f->nrows * (size_t)dir->length);
    memcpy(*pts, x, (size_t)f->nrows * (size_t)dir->length * sizeof **pts);
    return IX_OK;
}

/* Positive sum of the first n (the weights), the largest in [1/2, 1). */
static void normalise(size_t n, size_t total, double *pts)
{
    double sum = 0.0, f;
    int e;

    for (size_t i = 0; i < n; i++)
        sum += pts[i];
    (void)frexp(ix__bern_largest(n, pts), &e);
    f = ldexp(sum < 0.0 ? -1.0 : 1.0, -e);
    for (size_t i = 0; i < total; i++)
        pts[i] *= f;
}

/* Weights and coordinates in the frame, double[1 + dim][n], to a multivariate
 * of ncoords coordinates. */
static ix_status make(ix_ctx *ctx, const ix_curve *c, int ndirs,
                      const ix_dir *dirs, size_t n, double *pts, int ncoords,
                      ix_mv **out)
{
    size_t total = (size_t)(c->dim + 1) * n;
    ix_mv *m;

    ix__frame_back(&c->frame, 1.0, n, pts, pts + n);
    IX_TRY(ix__check_finite(ctx, total, pts));
    IX_TRY(ix__mv_alloc(ctx, ndirs, dirs, ncoords, true, &m));
    memcpy(m->pts, pts, total * sizeof *pts);
    for (size_t i = 0; c->dim < ncoords && i < n; i++)
        m->pts[total + i] = c->z * pts[i];
    *out = m;
    return IX_OK;
}

ix_status ix__curve_store(ix_ctx *ctx, const ix_curve *c, const ix_form *w,
                          const ix_form *x, int ncoords, ix_join_rule rule,
                          ix_mv **out)
{
    const ix_form *parts[2] = {w, x};
    ix_form all;
    ix_dir dir;
    double *pts;
    size_t n;

    IX_TRY(ix__form_join(ctx, 2, parts, &all));
    IX_TRY(points_of(ctx, &all, rule, &dir, &pts));
    n = (size_t)dir.length;
    normalise(n, (size_t)(c->dim + 1) * n, pts);
    return make(ctx, c, 1, &dir, n, pts, ncoords, out);
}

ix_status ix__ruled_store(ix_ctx *ctx, const ix_curve *c, const ix_ruled *r,
                          ix_join_rule rule, ix_mv **out)
{
    const ix_form *parts[3] = {r->w, r->x, r->ruling};
    int dim = c->dim;
    ix_form all;
    ix_dir dirs[2];
    double *in, *pts;
    size_t n;

    IX_TRY(ix__form_join(ctx, 3, parts, &all));
    IX_TRY(points_of(ctx, &all, rule, dirs, &in));
    n = (size_t)dirs[0].length;
    normalise(n, (size_t)(2 * dim + 1) * n, in);
    dirs[1] = ix__dir_linear(dirs[0].basis == IX_BEZIER);
    IX_SCRATCH(ctx, pts, 2 * (size_t)(dim + 1) * n);
    for (size_t k = 0; k < 2; k++)
        for (size_t i = 0; i < n; i++) {
            double f = ldexp(r->range[k], r->exp);

            pts[k * n + i] = in[i];
            for (size_t a = 1; a <= (size_t)dim; a++)
                pts[(2 * a + k) * n + i] = in[a * n + i] +
                                           f * in[(a + (size_t)dim) * n + i];
        }
    return make(ctx, c, 2, dirs, 2 * n, pts, 3, out);
}

ix_status ix__rows_store(ix_ctx *ctx, const ix_form *w, const ix_form *x,
                         int exp, ix_join_rule rule, ix_mv **out)
{
    const ix_form *parts[2] = {w, x};
    ix_form all;
    ix_dir dir;
    double *pts;
    size_t n;
    ix_mv *m;
    int first = w ? 1 : 0;

    IX_TRY(ix__form_join(ctx, w ? 2 : 1, parts + !w, &all));
    IX_TRY(points_of(ctx, &all, rule, &dir, &pts));
    n = (size_t)dir.length;
    for (size_t i = (size_t)first * n; i < (size_t)all.nrows * n; i++)
        pts[i] = ldexp(pts[i], exp);
    if (w)
        normalise(n, (size_t)all.nrows * n, pts);
    IX_TRY(ix__check_finite(ctx, (size_t)all.nrows * n, pts));
    IX_TRY(ix__mv_alloc(ctx, 1, &dir, x->nrows, w != NULL, &m));
    memcpy(m->pts, pts, (size_t)all.nrows * n * sizeof *pts);
    *out = m;
    return IX_OK;
}
