/* form_store.c - Bernstein and scaled coefficients; a form to a multivariate:
 * one composition, direction by direction, with the knots that the known
 * continuity allows. */
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "sym/form_impl.h"

ix_status ix__form_scale_in(ix_ctx *ctx, const ix_form *f, const double *in)
{
    const double *from = in;

    for (int i = 0; i < f->ndirs; i++) {
        int d = f->dirs[i].degree;
        double *room = NULL;
        ix__shape s;

        if (d < 2)
            continue;
        if (d > IX__BINOM_TABLE)
            IX_SCRATCH(ctx, room, d + 1);
        ix__form_shape(f, i, &s);
        ix__bern_scale(s.outer * s.nspans, d, s.inner, ix__binom(d, room), from,
                       f->c);
        from = f->c;
    }
    if (from != f->c)
        memcpy(f->c, in, (size_t)f->nrows * f->n * sizeof *f->c);
    return IX_OK;
}

/* Bernstein coefficients into to, double[nrows][n]; exp undone. */
static ix_status unscale(ix_ctx *ctx, const ix_form *f, double *to)
{
    const double *from = f->c;
    size_t n = (size_t)f->nrows * f->n;
    double *room = NULL;

    for (int i = 0; i < f->ndirs; i++) {
        int d = f->dirs[i].degree;
        ix__shape s;

        if (d < 2)
            continue;
        if (d > IX__BINOM_TABLE)
            IX_SCRATCH(ctx, room, d + 1);
        ix__form_shape(f, i, &s);
        ix__bern_unscale(s.outer * s.nspans, d, s.inner, ix__binom(d, room),
                         from, to);
        from = to;
    }
    if (from != to)
        memcpy(to, from, n * sizeof *to);
    for (size_t i = 0; f->exp && i < n; i++)
        to[i] = ldexp(to[i], f->exp);
    return IX_OK;
}

ix_status ix__form_bernstein(ix_ctx *ctx, const ix_form *f, const double **out)
{
    double *to;

    IX_SCRATCH(ctx, to, (size_t)f->nrows * f->n);
    IX_TRY(unscale(ctx, f, to));
    *out = to;
    return IX_OK;
}

ix_status ix__form_dirs(ix_ctx *ctx, const ix_form *f, const ix_sym_opts *o,
                        ix_dir *dirs)
{
    int max_cont = o ? o->max_cont : INT_MAX;

    for (int i = 0; i < f->ndirs; i++)
        IX_TRY(ix__spans_target(ctx, &f->dirs[i], max_cont,
                                (f->bezier >> i & 1u) != 0, &dirs[i]));
    return IX_OK;
}

/* The last direction with more than one span, -1 if none: the coefficients
 * of a single span are those of the result. */
static int last_composed(const ix_form *f)
{
    int i = f->ndirs - 1;

    while (i >= 0 && f->dirs[i].nspans == 1)
        i--;
    return i;
}

/* Composes direction dir, those before it already are; to NULL: in scratch. */
static ix_status compose(ix_ctx *ctx, const ix_form *f, const ix_dir *dirs,
                         int dir, const double **x, double *to)
{
    size_t inner = 1, outer = (size_t)f->nrows;

    for (int i = 0; i < dir; i++)
        inner *= (size_t)dirs[i].length;
    for (int i = dir + 1; i < f->ndirs; i++)
        outer *= ix__spans_size(&f->dirs[i]);
    if (!to)
        IX_SCRATCH(ctx, to, outer * (size_t)dirs[dir].length * inner);
    IX_TRY(ix__spans_compose(ctx, &f->dirs[dir], &dirs[dir], outer, inner, *x,
                             to));
    *x = to;
    return IX_OK;
}

/* Control points double[nrows][points] of the result into to; Bernstein
 * coefficients of splines into room, which may be the form's own place. */
static ix_status points(ix_ctx *ctx, const ix_form *f, const ix_dir *dirs,
                        double *room, double *to)
{
    int last = last_composed(f);
    const double *x = room;

    if (last < 0)
        return unscale(ctx, f, to);
    if (!room) {
        IX_TRY(ix__form_bernstein(ctx, f, &x));
    } else {
        IX_TRY(unscale(ctx, f, room));
    }
    for (int i = 0; i <= last; i++)
        if (f->dirs[i].nspans > 1)
            IX_TRY(compose(ctx, f, dirs, i, &x, i == last ? to : NULL));
    return IX_OK;
}

static size_t count_points(const ix_form *f, const ix_dir *dirs)
{
    size_t n = (size_t)f->nrows;

    for (int i = 0; i < f->ndirs; i++)
        n *= (size_t)dirs[i].length;
    return n;
}

ix_status ix__form_points(ix_ctx *ctx, const ix_form *f, const ix_dir *dirs,
                          const double **out)
{
    double *to;

    IX_SCRATCH(ctx, to, count_points(f, dirs));
    IX_TRY(points(ctx, f, dirs, NULL, to));
    *out = to;
    return IX_OK;
}

ix_status ix__form_points_into(ix_ctx *ctx, ix_form *f, const ix_dir *dirs,
                               double *to)
{
    return points(ctx, f, dirs, f->c, to);
}

ix_status ix__check_finite(ix_ctx *ctx, size_t n, const double *x)
{
    if (!ix__bern_finite(n, x))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "a coefficient of the result overflows");
    return IX_OK;
}

ix_status ix__form_store(ix_ctx *ctx, const ix_form *f, bool rational,
                         const ix_sym_opts *o, ix_mv **out)
{
    ix_dir dirs[IX_MAX_DIRS];
    ix_status st;
    ix_mv *m;

    IX_TRY(ix__form_dirs(ctx, f, o, dirs));
    IX_TRY(ix__mv_alloc(ctx, f->ndirs, dirs, f->nrows - (rational ? 1 : 0),
                        rational, &m));
    st = points(ctx, f, dirs, NULL, m->pts);
    if (st == IX_OK)
        st = ix__check_finite(ctx, (size_t)m->naxes * m->npts, m->pts);
    if (st != IX_OK) {
        ix_mv_unref(ctx, m);
        return st;
    }
    *out = m;
    return IX_OK;
}
