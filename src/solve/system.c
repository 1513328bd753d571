/* system.c - n equations in n unknowns on piecewise domains.
 *
 * Every patch of the decomposed equations is searched (system_search.c); then
 * what several patches and boxes reported is made one. */
#include <math.h>
#include <string.h>

#include "mv/mv.h"
#include "solve/patches.h"
#include "solve/system_impl.h"
#include "sym/form.h"

static void residual(const ix__patch_source *src, ix_solution *r, ix__box *b,
                     double *work)
{
    double x[IX_MAX_UNKNOWNS];

    src->at(src->self, r->x, b);
    for (int j = 0; j < src->n; j++)
        x[j] = (r->x[j] - b->lo[j]) / (b->hi[j] - b->lo[j]);
    r->residual = 0;
    for (int i = 0; i < src->neq; i++) {
        const double *c = b->c + (size_t)i * src->shape.size;

        r->residual = fmax(r->residual,
                           fabs(ix__tensor_value(&src->shape, c, x, work)));
    }
}

static ix_status give(ix_ctx *ctx, const ix__found *f, const ix__system *s,
                      ix_solutions *out)
{
    size_t bytes = (size_t)f->n * sizeof *out->sol;

    out->unknowns = s->n;
    out->boxes = s->t.boxes;
    out->interrupted = s->t.interrupted;
    out->crowded = s->t.crowded;
    out->complete = s->t.boxes < s->t.max_boxes && !s->t.interrupted &&
                    !s->t.crowded;
    if (f->n == 0)
        return IX_OK;
    out->sol = ix__alloc(ctx, bytes);
    if (!out->sol)
        return IX_ENOMEM;
    memcpy(out->sol, f->sol, bytes);
    out->n = f->n;
    out->bytes = bytes;
    return IX_OK;
}

static void set_up(ix_ctx *ctx, const ix__patch_source *src,
                   const ix_solve_opts *o, ix__system *s)
{
    ix__task *t = &s->t;

    *s = (ix__system){.n = src->n};
    *t = (ix__task){.ctx = ctx,
                    .shape = src->shape,
                    .neq = src->neq,
                    .nall = src->nall,
                    .keep = o && o->keep};
    t->cell = o && o->cell > 0 ? o->cell : 1e-10;
    t->max_boxes = o && o->max_boxes ? o->max_boxes : 10000000;
    memcpy(t->edge, src->edge, sizeof t->edge);
}

static ix_status solve_patches(ix_ctx *ctx, const ix__patch_source *src,
                               const ix_solve_opts *o, ix_solutions *out)
{
    ix__found found = {.ctx = ctx};
    double *work;
    ix__system s;
    ix__box b;

    set_up(ctx, src, o, &s);
    IX_SCRATCH(ctx, b.c, (size_t)src->nall * src->shape.size);
    IX_SCRATCH(ctx, work, 2 * src->shape.size);
    /* after a budget or an interruption this reports whole patches */
    while (src->next(src->self, &b))
        IX_TRY(ix__system_search(&s, &b, &found));
    IX_TRY(ix__found_merge(&found, s.n, s.t.edge));
    for (int i = 0; i < found.n; i++)
        residual(src, &found.sol[i], &b, work);
    return give(ctx, &found, &s, out);
}

ix_status ix__solve_patches(ix_ctx *ctx, const ix__patch_source *src,
                            const ix_solve_opts *o, ix_solutions *out)
{
    *out = (ix_solutions){.n = 0};
    IX_RETURN_SCOPED(ctx, solve_patches(ctx, src, o, out));
}

/* --- equations that are there as a whole
 * ---------------------------------------------------------------------- */

typedef struct {
    ix__patches p;
    const ix__patch_source *src;
    int idx[IX_MAX_UNKNOWNS];
    bool done;
} whole;

static bool next_patch(void *self, ix__box *b)
{
    whole *w = self;

    if (w->done)
        return false;
    ix__patches_take(&w->p, &w->src->shape, w->src->nall, w->idx, b);
    w->done = !ix__patches_next(&w->p, w->src->n, w->idx);
    return true;
}

static void patch_at(void *self, const double *x, ix__box *b)
{
    whole *w = self;
    int idx[IX_MAX_UNKNOWNS];

    for (int j = 0; j < w->src->n; j++)
        idx[j] = ix__spans_find(&w->p.sp[j], x[j]);
    ix__patches_take(&w->p, &w->src->shape, w->src->nall, idx, b);
}

static ix_status solve(ix_ctx *ctx, int neq, const ix_equation *eq,
                       const ix_solve_opts *o, ix_solutions *out)
{
    ix__patch_source src = {.nall = neq, .next = next_patch, .at = patch_at};
    whole w = {.src = &src};

    IX_TRY(ix__patches_check(ctx, neq, eq, 0));
    IX_TRY(ix__patches_make(ctx, neq, eq, &w.p));
    src.self = &w;
    src.n = eq[0].f->ndirs;
    for (int i = 0; i < neq; i++)
        src.neq += eq[i].rel == IX_EQUAL_ZERO;
    ix__patches_shape(&w.p, &src.shape, src.edge);
    return solve_patches(ctx, &src, o, out);
}

ix_status ix_solve(ix_ctx *ctx, int neq, const ix_equation *eq,
                   const ix_solve_opts *o, ix_solutions *out)
{
    *out = (ix_solutions){.n = 0};
    IX_RETURN_SCOPED(ctx, solve(ctx, neq, eq, o, out));
}

void ix_solutions_free(ix_ctx *ctx, ix_solutions *s)
{
    if (s->sol)
        ix__free(ctx, s->sol, s->bytes);
    *s = (ix_solutions){.n = 0};
}
