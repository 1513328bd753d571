/* form_store.c - a form to a multivariate: one composition, direction by
 * direction, with the knots that the known continuity allows. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "sym/form_impl.h"

ix_status ix__form_bernstein(ix_ctx *ctx, const ix_form *f, const double **out)
{
    const double *from = f->c;
    size_t n = (size_t)f->nrows * f->n;
    double *to, *room;

    IX_SCRATCH(ctx, to, n);
    for (int i = 0; i < f->ndirs; i++) {
        int d = f->dirs[i].degree;
        ix__shape s;

        if (d < 2)
            continue;
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
    *out = to;
    return IX_OK;
}

/* Direction dir composed, those before it already are. */
static ix_status compose(ix_ctx *ctx, const ix_form *f, const ix_dir *dirs,
                         int dir, const double **x)
{
    size_t inner = 1, outer = (size_t)f->nrows;
    double *next;

    for (int i = 0; i < dir; i++)
        inner *= (size_t)dirs[i].length;
    for (int i = dir + 1; i < f->ndirs; i++)
        outer *= ix__spans_size(&f->dirs[i]);
    IX_SCRATCH(ctx, next, outer * (size_t)dirs[dir].length * inner);
    IX_TRY(ix__spans_compose(ctx, &f->dirs[dir], &dirs[dir], outer, inner, *x,
                             next));
    *x = next;
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

ix_status ix__form_points(ix_ctx *ctx, const ix_form *f, const ix_dir *dirs,
                          const double **out)
{
    IX_TRY(ix__form_bernstein(ctx, f, out));
    for (int i = 0; i < f->ndirs; i++)
        if (f->dirs[i].nspans > 1) /* else its coefficients are the result's */
            IX_TRY(compose(ctx, f, dirs, i, out));
    return IX_OK;
}

ix_status ix__check_finite(ix_ctx *ctx, size_t n, const double *x)
{
    bool ok = true;

    for (size_t i = 0; i < n; i++)
        ok &= fabs(x[i]) <= DBL_MAX;
    if (!ok)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "a coefficient of the result overflows");
    return IX_OK;
}

ix_status ix__form_store(ix_ctx *ctx, const ix_form *f, bool rational,
                         const ix_sym_opts *o, ix_mv **out)
{
    ix_dir dirs[IX_MAX_DIRS];
    const double *x;
    size_t n = (size_t)f->nrows;
    ix_mv *m;

    IX_TRY(ix__form_dirs(ctx, f, o, dirs));
    IX_TRY(ix__form_points(ctx, f, dirs, &x));
    for (int i = 0; i < f->ndirs; i++)
        n *= (size_t)dirs[i].length;
    IX_TRY(ix__check_finite(ctx, n, x));
    IX_TRY(ix__mv_alloc(ctx, f->ndirs, dirs, f->nrows - (rational ? 1 : 0),
                        rational, &m));
    memcpy(m->pts, x, n * sizeof *x);
    *out = m;
    return IX_OK;
}
