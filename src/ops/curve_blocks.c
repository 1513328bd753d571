/* curve_blocks.c - the forms of an operator on curves, block by block of spans:
 * what lies between input and result then takes the memory of one block,
 * however long the curve is, and stays in the processor's cache. */
#include <assert.h>
#include <string.h>

#include "ops/curve.h"

/* Spans of a block. Rational curves of degree 5 need up to 60 KB for the
 * intermediate forms of one span; a block costs some microseconds by itself,
 * so that it may not be much smaller. */
enum { BLOCK = 32 };

typedef struct {
    const ix_curve *c;
    ix__curve_fn fn;
    void *arg;
    ix_form *out;
    int *cont; /* of out */
} job;

/* --- parts of the curve ------------------------------------------------- */

static ix_status form_part(ix_ctx *ctx, int first, int count, ix_form *f)
{
    const ix_spans *sp = &f->dirs[0];
    size_t m = (size_t)sp->degree + 1, n = (size_t)count * m;
    ix_spans dir = {sp->degree, count, sp->breaks + first, NULL};
    ix_form part;

    if (count > 1)
        dir.cont = sp->cont + first;
    IX_TRY(ix__form_alloc(ctx, 1, &dir, f->nrows, &part));
    part.bezier = f->bezier;
    part.exp = f->exp;
    for (size_t r = 0; r < (size_t)f->nrows; r++)
        memcpy(part.c + r * n, f->c + r * f->n + (size_t)first * m,
               n * sizeof *part.c);
    *f = part;
    return IX_OK;
}

static ix_status curve_part(ix_ctx *ctx, const ix_curve *c, int first,
                            int count, ix_curve *out)
{
    ix_curve part = *c;
    ix_form *forms[] = {&part.p, &part.w, &part.local, &part.d,
                        &part.v, &part.q, &part.t};
    ix_extent **sizes[] = {&part.ew, &part.ed, &part.ev, &part.eq, &part.et};

    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++)
        if (forms[i]->c)
            IX_TRY(form_part(ctx, first, count, forms[i]));
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        if (*sizes[i])
            *sizes[i] += first;
    *out = part;
    return IX_OK;
}

/* What fn makes of a part, as the rows of one form of its own. */
static ix_status run_part(ix_ctx *ctx, const ix_curve *c, ix__curve_fn fn,
                          void *arg, ix_form *out)
{
    ix_form f[IX__CURVE_FORMS] = {{0}};
    const ix_form *parts[IX__CURVE_FORMS];
    int n = 0;

    IX_TRY(fn(ctx, c, arg, f));
    for (int i = 0; i < IX__CURVE_FORMS; i++)
        if (f[i].nrows > 0)
            parts[n++] = &f[i];
    return ix__form_join(ctx, n, parts, out);
}

/* --- results ------------------------------------------------------------ */

/* Degree, rows and scale of the result: those of its first span. *out has no
 * coefficients. */
static ix_status first_span(ix_ctx *ctx, const job *j, ix_spans *dir,
                            ix_form *out)
{
    ix_curve part;

    IX_TRY(curve_part(ctx, j->c, 0, 1, &part));
    IX_TRY(run_part(ctx, &part, j->fn, j->arg, out));
    *dir = j->c->p.dirs[0];
    dir->degree = out->dirs[0].degree;
    return IX_OK;
}

static ix_status first_span_scoped(ix_ctx *ctx, const job *j, ix_spans *dir,
                                   ix_form *out)
{
    IX_RETURN_SCOPED(ctx, first_span(ctx, j, dir, out));
}

static ix_status make_result(ix_ctx *ctx, job *j)
{
    ix_spans dir;
    ix_form like;

    IX_TRY(first_span_scoped(ctx, j, &dir, &like));
    IX_SCRATCH(ctx, j->cont, dir.nspans);
    dir.cont = j->cont;
    IX_TRY(ix__form_alloc(ctx, 1, &dir, like.nrows, j->out));
    j->out->exp = like.exp;
    j->out->bezier = like.bezier;
    return IX_OK;
}

/* The first count spans of a part to their places. */
static void keep(const ix_form *part, int first, int count, ix_form *out)
{
    size_t m = (size_t)part->dirs[0].degree + 1, n = (size_t)count * m;

    assert(part->nrows == out->nrows && part->exp == out->exp &&
           part->dirs[0].degree == out->dirs[0].degree);
    for (size_t r = 0; r < (size_t)part->nrows; r++)
        memcpy(out->c + r * out->n + (size_t)first * m, part->c + r * part->n,
               n * sizeof *out->c);
}

/* One span more is computed than kept: what the result is at the last break of
 * the block is known between two spans only. */
static ix_status one_block(ix_ctx *ctx, const job *j, int first)
{
    int left = j->c->p.dirs[0].nspans - first;
    int count = left > BLOCK ? BLOCK : left;
    int with_next = left > BLOCK ? count + 1 : count;
    ix_curve part;
    ix_form f;

    IX_TRY(curve_part(ctx, j->c, first, with_next, &part));
    IX_TRY(run_part(ctx, &part, j->fn, j->arg, &f));
    keep(&f, first, count, j->out);
    if (with_next > 1)
        memcpy(j->cont + first, f.dirs[0].cont,
               ((size_t)with_next - 1) * sizeof *j->cont);
    return IX_OK;
}

static ix_status one_block_scoped(ix_ctx *ctx, const job *j, int first)
{
    IX_RETURN_SCOPED(ctx, one_block(ctx, j, first));
}

ix_status ix__curve_forms(ix_ctx *ctx, const ix_curve *c, ix__curve_fn fn,
                          void *arg, ix_form *out)
{
    job j = {.c = c, .fn = fn, .arg = arg, .out = out};

    if (c->p.dirs[0].nspans <= 2 * BLOCK)
        return run_part(ctx, c, fn, arg, out);
    IX_TRY(make_result(ctx, &j));
    for (int first = 0; first < c->p.dirs[0].nspans; first += BLOCK)
        IX_TRY(one_block_scoped(ctx, &j, first));
    return IX_OK;
}
