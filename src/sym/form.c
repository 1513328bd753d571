/* form.c - making forms, elevation, sums: what needs no product. Results have
 * their own coefficients; breaks and continuity are shared where equal. */
#include "sym/form.h"

#include <math.h>
#include <string.h>

#include "base/threads.h"
#include "bern/bern.h"
#include "sym/form_impl.h"

/* --- making --------------------------------------------------------------- */

ix_status ix__form_adopt(ix_ctx *ctx, int ndirs, const ix_spans *dirs,
                         int nrows, double *c, ix_form *out)
{
    ix_spans *own;
    size_t n = 1, total;

    for (int i = 0; i < ndirs; i++) {
        if (dirs[i].degree >= IX_MAX_ORDER)
            return IX_FAIL(ctx, IX_EUNABLE,
                           "order %d in direction %d of a result, at most %d",
                           dirs[i].degree + 1, i, IX_MAX_ORDER);
        if (__builtin_mul_overflow(n, ix__spans_size(&dirs[i]), &n))
            return IX_FAIL(ctx, IX_ENOMEM, "a form of too many coefficients");
    }
    if (__builtin_mul_overflow(n, (size_t)nrows, &total))
        return IX_FAIL(ctx, IX_ENOMEM, "a form of too many coefficients");
    IX_SCRATCH(ctx, own, ndirs);
    if (!c)
        IX_SCRATCH(ctx, c, total);
    for (int i = 0; i < ndirs; i++)
        own[i] = dirs[i];
    *out = (ix_form){ndirs, nrows, 0, 0, own, n, c};
    return IX_OK;
}

ix_status ix__form_alloc(ix_ctx *ctx, int ndirs, const ix_spans *dirs,
                         int nrows, ix_form *out)
{
    return ix__form_adopt(ctx, ndirs, dirs, nrows, NULL, out);
}

ix_status ix__form_constant(ix_ctx *ctx, const ix_form *like, int nrows,
                            const double *values, ix_form *out)
{
    ix_spans dirs[IX_MAX_DIRS];

    for (int i = 0; i < like->ndirs; i++) {
        dirs[i] = like->dirs[i];
        dirs[i].degree = 0;
        IX_TRY(ix__cont_shift(ctx, &dirs[i], IX__SMOOTH));
    }
    IX_TRY(ix__form_alloc(ctx, like->ndirs, dirs, nrows, out));
    out->bezier = like->bezier;
    for (int r = 0; r < nrows; r++)
        for (size_t i = 0; i < out->n; i++)
            out->c[(size_t)r * out->n + i] = values[r];
    return IX_OK;
}

ix_status ix__form_copy(ix_ctx *ctx, const ix_form *f, ix_form *out)
{
    IX_TRY(ix__form_alloc(ctx, f->ndirs, f->dirs, f->nrows, out));
    out->bezier = f->bezier;
    out->exp = f->exp;
    memcpy(out->c, f->c, (size_t)f->nrows * f->n * sizeof *f->c);
    return IX_OK;
}

/* --- continuity ----------------------------------------------------------- */

ix_status ix__cont_shift(ix_ctx *ctx, ix_spans *sp, int by)
{
    int n = sp->nspans - 1, *cont;

    if (n < 1 || by == 0)
        return IX_OK;
    IX_SCRATCH(ctx, cont, n);
    for (int j = 0; j < n; j++) {
        bool smooth = by == IX__SMOOTH || sp->cont[j] == INT_MAX;
        int c = smooth ? INT_MAX : sp->cont[j] + by;

        cont[j] = c < -1 ? -1 : c;
    }
    sp->cont = cont;
    return IX_OK;
}

ix_status ix__cont_meet(ix_ctx *ctx, const ix_spans *a, const ix_spans *b,
                        const int **out)
{
    int n = a->nspans - 1, *cont;

    *out = a->cont;
    if (n < 1 || a->cont == b->cont)
        return IX_OK;
    IX_SCRATCH(ctx, cont, n);
    for (int j = 0; j < n; j++)
        cont[j] = a->cont[j] < b->cont[j] ? a->cont[j] : b->cont[j];
    *out = cont;
    return IX_OK;
}

ix_status ix__form_narrow(ix_ctx *ctx, const ix_spans *dirs, ix_form *f)
{
    ix_spans own[IX_MAX_DIRS], *to;
    bool same = true;

    for (int i = 0; i < f->ndirs; i++) {
        own[i] = f->dirs[i];
        IX_TRY(ix__cont_meet(ctx, &f->dirs[i], &dirs[i], &own[i].cont));
        same &= own[i].cont == f->dirs[i].cont;
    }
    if (same)
        return IX_OK;
    IX_SCRATCH(ctx, to, f->ndirs);
    memcpy(to, own, (size_t)f->ndirs * sizeof *to);
    f->dirs = to;
    return IX_OK;
}

/* --- blocks of one direction ---------------------------------------------- */

double ix__spans_mean(const ix_spans *sp)
{
    return (sp->breaks[sp->nspans] - sp->breaks[0]) / sp->nspans;
}

void ix__form_shape(const ix_form *f, int dir, ix__shape *s)
{
    s->inner = 1;
    s->outer = (size_t)f->nrows;
    for (int i = 0; i < dir; i++)
        s->inner *= ix__spans_size(&f->dirs[i]);
    for (int i = dir + 1; i < f->ndirs; i++)
        s->outer *= ix__spans_size(&f->dirs[i]);
    s->nspans = (size_t)f->dirs[dir].nspans;
}

typedef struct {
    const ix_form *in;
    ix_form *out;
    ix__shape s;
    size_t ni, no; /* coefficients of a block */
    ix__block_fn fn;
    const void *arg;
} block_job;

static void run_blocks(void *arg, size_t begin, size_t end)
{
    const block_job *w = arg;

    for (size_t b = begin; b < end; b++)
        w->fn(w->arg, b % w->s.nspans, w->s.inner, w->in->c + b * w->ni,
              w->out->c + b * w->no);
}

void ix__form_blocks(ix_ctx *ctx, const ix_form *in, int dir, ix__block_fn fn,
                     const void *arg, double block_ns, ix_form *out)
{
    block_job w = {in, out, {0}, 0, 0, fn, arg};

    ix__form_shape(in, dir, &w.s);
    w.ni = ((size_t)in->dirs[dir].degree + 1) * w.s.inner;
    w.no = ((size_t)out->dirs[dir].degree + 1) * w.s.inner;
    ix__parallel(ctx, w.s.outer * w.s.nspans, block_ns * (double)w.s.inner,
                 run_blocks, &w);
}

/* A form like f with another degree in direction dir, coefficients unset. */
ix_status ix__form_like(ix_ctx *ctx, const ix_form *f, int dir, ix_spans sp,
                        ix_form *out)
{
    ix_spans dirs[IX_MAX_DIRS];

    memcpy(dirs, f->dirs, (size_t)f->ndirs * sizeof *dirs);
    dirs[dir] = sp;
    IX_TRY(ix__form_alloc(ctx, f->ndirs, dirs, f->nrows, out));
    out->bezier = f->bezier;
    out->exp = f->exp;
    return IX_OK;
}

/* --- elevation ------------------------------------------------------------ */

typedef struct {
    int d, e;
    const double *row;
} elevation;

static void elevate_block(const void *arg, size_t span, size_t inner,
                          const double *in, double *out)
{
    const elevation *w = arg;

    (void)span;
    ix__bern_elevate(w->d, w->e, w->row, inner, in, out);
}

static ix_status elevate_dir(ix_ctx *ctx, const ix_form *f, int dir, int degree,
                             ix_form *out)
{
    elevation w = {f->dirs[dir].degree, degree - f->dirs[dir].degree, NULL};
    ix_spans sp = f->dirs[dir];
    double *room;

    sp.degree = degree;
    IX_TRY(ix__form_like(ctx, f, dir, sp, out));
    IX_SCRATCH(ctx, room, w.e + 1);
    w.row = ix__binom(w.e, room);
    ix__form_blocks(ctx, f, dir, elevate_block, &w, (w.d + 1.0) * (w.e + 1.0),
                    out);
    return IX_OK;
}

ix_status ix__form_elevate(ix_ctx *ctx, const ix_form *f, const int *degrees,
                           ix_form *out)
{
    ix_form t = *f;

    for (int i = 0; i < f->ndirs; i++)
        if (degrees[i] > t.dirs[i].degree) {
            ix_form up;

            IX_TRY(elevate_dir(ctx, &t, i, degrees[i], &up));
            t = up;
        }
    *out = t;
    return IX_OK;
}

/* --- sums ----------------------------------------------------------------- */

/* One exponent for both: the larger, so that nothing overflows. */
static ix_status same_exp(ix_ctx *ctx, ix_form *f, int exp)
{
    ix_form t;

    if (f->exp == exp)
        return IX_OK;
    IX_TRY(ix__form_copy(ctx, f, &t));
    ix__form_times(&t, ldexp(1.0, f->exp - exp));
    t.exp = exp;
    *f = t;
    return IX_OK;
}

ix_status ix__form_match(ix_ctx *ctx, ix_form *a, ix_form *b)
{
    int degrees[IX_MAX_DIRS] = {0}, exp = a->exp > b->exp ? a->exp : b->exp;

    for (int i = 0; i < a->ndirs; i++) {
        int da = a->dirs[i].degree, db = b->dirs[i].degree;

        degrees[i] = da > db ? da : db;
    }
    IX_TRY(ix__form_elevate(ctx, a, degrees, a));
    IX_TRY(ix__form_elevate(ctx, b, degrees, b));
    IX_TRY(same_exp(ctx, a, exp));
    return same_exp(ctx, b, exp);
}

ix_status ix__form_meet(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                        ix_spans *dirs)
{
    for (int i = 0; i < a->ndirs; i++) {
        dirs[i] = a->dirs[i];
        IX_TRY(ix__cont_meet(ctx, &a->dirs[i], &b->dirs[i], &dirs[i].cont));
    }
    return IX_OK;
}

ix_status ix__form_add(ix_ctx *ctx, const ix_form *a, int sign,
                       const ix_form *b, ix_form *out)
{
    ix_form x = *a, y = *b;
    ix_spans dirs[IX_MAX_DIRS];
    size_t n;

    IX_TRY(ix__form_match(ctx, &x, &y));
    IX_TRY(ix__form_meet(ctx, &x, &y, dirs));
    IX_TRY(ix__form_alloc(ctx, x.ndirs, dirs, x.nrows, out));
    out->bezier = x.bezier & y.bezier;
    out->exp = x.exp;
    n = (size_t)x.nrows * x.n;
    for (size_t i = 0; i < n; i++)
        out->c[i] = sign > 0 ? x.c[i] + y.c[i] : x.c[i] - y.c[i];
    return IX_OK;
}

void ix__form_times(ix_form *f, double factor)
{
    size_t n = (size_t)f->nrows * f->n;

    for (size_t i = 0; i < n; i++)
        f->c[i] *= factor;
}

/* --- assembling ----------------------------------------------------------- */

ix_status ix__form_join(ix_ctx *ctx, int n, const ix_form *const *parts,
                        ix_form *out)
{
    ix_spans dirs[IX_MAX_DIRS];
    int degrees[IX_MAX_DIRS], nrows = 0, exp = parts[0]->exp;
    unsigned bezier = ~0u;
    double *to;

    memcpy(dirs, parts[0]->dirs, (size_t)parts[0]->ndirs * sizeof *dirs);
    for (int p = 0; p < n; p++) {
        nrows += parts[p]->nrows;
        exp = parts[p]->exp > exp ? parts[p]->exp : exp;
        bezier &= parts[p]->bezier;
        for (int i = 0; i < parts[0]->ndirs; i++) {
            const ix_spans *sp = &parts[p]->dirs[i];

            if (sp->degree > dirs[i].degree)
                dirs[i].degree = sp->degree;
            IX_TRY(ix__cont_meet(ctx, &dirs[i], sp, &dirs[i].cont));
            degrees[i] = dirs[i].degree;
        }
    }
    IX_TRY(ix__form_alloc(ctx, parts[0]->ndirs, dirs, nrows, out));
    out->bezier = bezier;
    out->exp = exp;
    to = out->c;
    for (int p = 0; p < n; p++) {
        ix_form t;

        IX_TRY(ix__form_elevate(ctx, parts[p], degrees, &t));
        IX_TRY(same_exp(ctx, &t, exp));
        memcpy(to, t.c, (size_t)t.nrows * t.n * sizeof *to);
        to += (size_t)t.nrows * t.n;
    }
    return IX_OK;
}
