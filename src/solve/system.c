/* system.c - n equations in n unknowns on piecewise domains.
 *
 * Every patch of the decomposed equations is searched (system_search.c); then
 * what several patches and boxes reported is made one. */
#include <math.h>
#include <string.h>

#include "mv/mv.h"
#include "solve/patches.h"
#include "solve/system_impl.h"

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
    ix__patches_take(p, &s->t.shape, s->t.nall, idx, b);
    r->residual = 0;
    for (int i = 0; i < s->t.neq; i++) {
        const double *c = b->c + (size_t)i * s->t.shape.size;

        r->residual = fmax(r->residual,
                           fabs(ix__tensor_value(&s->t.shape, c, x, work)));
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

static void set_up(ix_ctx *ctx, int neq, const ix_equation *eq,
                   const ix_solve_opts *o, const ix__patches *p, ix__system *s)
{
    ix__task *t = &s->t;

    *s = (ix__system){.n = eq[0].f->ndirs};
    *t = (ix__task){.ctx = ctx, .nall = neq, .keep = o && o->keep};
    t->cell = o && o->cell > 0 ? o->cell : 1e-10;
    t->max_boxes = o && o->max_boxes ? o->max_boxes : 10000000;
    for (int i = 0; i < neq; i++)
        t->neq += eq[i].rel == IX_EQUAL_ZERO;
    ix__patches_shape(p, &t->shape, t->edge);
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
    IX_SCRATCH(ctx, b.c, (size_t)neq * s.t.shape.size);
    IX_SCRATCH(ctx, work, 2 * s.t.shape.size);
    do { /* after a budget or an interruption this reports whole patches */
        ix__patches_take(&p, &s.t.shape, neq, idx, &b);
        IX_TRY(ix__system_search(&s, &b, &found));
    } while (ix__patches_next(&p, s.n, idx));
    IX_TRY(ix__found_merge(&found, s.n, s.t.edge));
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
