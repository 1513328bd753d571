/* system.c - n equations in n unknowns on piecewise domains.
 *
 * Every patch of the decomposed equations is searched (system_search.c); then
 * what several patches and boxes reported is made one. */
#include <math.h>
#include <string.h>

#include "mv/mv.h"
#include "solve/patches.h"

static void residuals(const ix__patches *p, const ix__system *s, ix_solution *r,
                      ix__box *b, double *work)
{
    int idx[IX_MAX_UNKNOWNS];
    double x[IX_MAX_UNKNOWNS];

    for (int j = 0; j < s->n; j++) {
        const double *br = p->sp[j].breaks;

        idx[j] = 0;
        while (idx[j] + 1 < p->sp[j].nspans && r->x[j] >= br[idx[j] + 1])
            idx[j]++;
        x[j] = (r->x[j] - br[idx[j]]) / (br[idx[j] + 1] - br[idx[j]]);
    }
    ix__patches_take(p, &s->shape, s->nall, idx, b);
    r->residual = 0;
    for (int i = 0; i < s->neq; i++)
        r->residual = fmax(
            r->residual,
            fabs(ix__tensor_value(&s->shape, b->c + (size_t)i * s->shape.size,
                                  x, work)));
}

static ix_status give(ix_ctx *ctx, const ix__found *f, const ix__system *s,
                      ix_solutions *out)
{
    size_t bytes = (size_t)f->n * sizeof *out->sol;

    out->unknowns = s->n;
    out->boxes = s->boxes;
    out->complete = s->boxes < s->max_boxes;
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

static void set_up(ix_ctx *ctx, int neq, const ix_equation *eq,
                   const ix_solve_opts *o, const ix__patches *p, ix__system *s)
{
    *s = (ix__system){.ctx = ctx, .n = eq[0].f->ndirs, .nall = neq};
    s->cell = o && o->cell > 0 ? o->cell : 1e-7;
    s->max_boxes = o && o->max_boxes ? o->max_boxes : 10000000;
    for (int i = 0; i < neq; i++)
        s->neq += eq[i].rel == IX_EQUAL_ZERO;
    ix__patches_shape(p, &s->shape, s->edge);
}

static ix_status solve(ix_ctx *ctx, int neq, const ix_equation *eq,
                       const ix_solve_opts *o, ix_solutions *out)
{
    int idx[IX_MAX_UNKNOWNS] = {0};
    ix__found found = {.ctx = ctx};
    double *work;
    ix__patches p;
    ix__system s;
    ix__box b;

    IX_TRY(ix__patches_check(ctx, neq, eq, 0));
    IX_TRY(ix__patches_make(ctx, neq, eq, &p));
    set_up(ctx, neq, eq, o, &p, &s);
    IX_SCRATCH(ctx, b.c, (size_t)neq * s.shape.size);
    IX_SCRATCH(ctx, work, 2 * s.shape.size);
    do {
        ix__patches_take(&p, &s.shape, neq, idx, &b);
        IX_TRY(ix__system_search(&s, &b, &found));
    } while (ix__patches_next(&p, s.n, idx) && s.boxes < s.max_boxes);
    IX_TRY(ix__found_merge(&found, s.n, s.edge));
    for (int i = 0; i < found.n; i++)
        residuals(&p, &s, &found.sol[i], &b, work);
    return give(ctx, &found, &s, out);
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
