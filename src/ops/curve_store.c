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

/* The direction of the result. */
static ix_status target(ix_ctx *ctx, ix_form *f, ix_join_rule rule, ix_dir *dir)
{
    ix_sym_opts so = {rule.max_cont, 0};

    if (rule.irit)
        IX_TRY(irit_joins(ctx, f, rule.max_cont));
    return ix__form_dirs(ctx, f, &so, dir);
}

/* Positive sum of the first n (the weights), the largest in [1/2, 1). */
static void normalise(size_t n, size_t total, double *pts)
{
    double f = ix__bern_weight_factor(n, pts);

    for (size_t i = 0; i < total; i++)
        pts[i] *= f;
}

/* m if st is IX_OK and all its numbers are finite. */
static ix_status finish(ix_ctx *ctx, ix_status st, ix_mv *m, ix_mv **out)
{
    if (st == IX_OK)
        st = ix__check_finite(ctx, (size_t)m->naxes * m->npts, m->pts);
    if (st == IX_OK)
        *out = m;
    else
        ix_mv_unref(ctx, m);
    return st;
}

/* The points in m, in the frame, to the user's space; a third coordinate is
 * that of the curve's plane. */
static void carry_back(const ix_curve *c, ix_mv *m)
{
    double *pts = m->pts;
    size_t n = m->npts, total = (size_t)(c->dim + 1) * n;

    ix__frame_back(&c->frame, 1.0, n, pts, pts + n);
    for (size_t i = 0; c->dim < m->ncoords && i < n; i++)
        pts[total + i] = c->z * pts[i];
}

ix_status ix__curve_store(ix_ctx *ctx, const ix_curve *c, ix_form *wx,
                          int ncoords, ix_join_rule rule, ix_mv **out)
{
    ix_status st;
    ix_dir dir;
    ix_mv *m;

    IX_TRY(target(ctx, wx, rule, &dir));
    IX_TRY(ix__mv_alloc(ctx, 1, &dir, ncoords, true, &m));
    st = ix__form_points_into(ctx, wx, &dir, m->pts);
    if (st == IX_OK) {
        normalise(m->npts, (size_t)wx->nrows * m->npts, m->pts);
        carry_back(c, m);
    }
    return finish(ctx, st, m, out);
}

/* Rows w, x and the ruling, double[1 + 2 dim][n], to double[1 + dim][2][n]. */
static void both_ends(int dim, size_t n, const double *in, int exp,
                      const double range[2], double *pts)
{
    for (size_t k = 0; k < 2; k++)
        for (size_t i = 0; i < n; i++) {
            double f = ldexp(range[k], exp);

            pts[k * n + i] = in[i];
            for (size_t a = 1; a <= (size_t)dim; a++)
                pts[(2 * a + k) * n + i] = in[a * n + i] +
                                           f * in[(a + (size_t)dim) * n + i];
        }
}

ix_status ix__ruled_store(ix_ctx *ctx, const ix_curve *c, ix_form *wxr, int exp,
                          const double range[2], ix_join_rule rule, ix_mv **out)
{
    ix_dir dirs[2];
    double *in;
    size_t n;
    ix_mv *m;

    IX_TRY(target(ctx, wxr, rule, dirs));
    n = (size_t)dirs[0].length;
    IX_SCRATCH(ctx, in, (size_t)wxr->nrows * n);
    IX_TRY(ix__form_points_into(ctx, wxr, dirs, in));
    normalise(n, (size_t)wxr->nrows * n, in);
    dirs[1] = ix__dir_linear(dirs[0].basis == IX_BEZIER);
    IX_TRY(ix__mv_alloc(ctx, 2, dirs, 3, true, &m));
    both_ends(c->dim, n, in, exp, range, m->pts);
    carry_back(c, m);
    return finish(ctx, IX_OK, m, out);
}

ix_status ix__rows_store(ix_ctx *ctx, ix_form *rows, bool rational, int exp,
                         ix_join_rule rule, ix_mv **out)
{
    size_t first, all;
    ix_status st;
    ix_dir dir;
    ix_mv *m;

    IX_TRY(target(ctx, rows, rule, &dir));
    IX_TRY(ix__mv_alloc(ctx, 1, &dir, rows->nrows - (rational ? 1 : 0),
                        rational, &m));
    st = ix__form_points_into(ctx, rows, &dir, m->pts);
    if (st == IX_OK) {
        first = rational ? m->npts : 0;
        all = (size_t)rows->nrows * m->npts;
        for (size_t i = first; i < all; i++)
            m->pts[i] = ldexp(m->pts[i], exp);
        if (rational)
            normalise(m->npts, all, m->pts);
    }
    return finish(ctx, st, m, out);
}
