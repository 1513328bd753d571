/* curves.c - n - 1 equations in n unknowns: the public call. */
#include <float.h>

#include "mv/mv.h"
#include "solve/curves_impl.h"

#define ROUNDED                                                             \
    (16 * DBL_EPSILON) /* of its largest coefficient: what an equation that \
                          was computed is known to. Curves along an edge of \
                          the domain are outside of it by that */

static void set_up(ix_ctx *ctx, int neq, const ix_equation *eq,
                   const ix_curves_opts *o, const ix__patches *p, ix__curves *s)
{
    ix__task *t = &s->t;

    *s = (ix__curves){.n = eq[0].f->ndirs, .singular = {.ctx = ctx}};
    *t = (ix__task){.ctx = ctx, .nall = neq, .keep = o && o->keep};
    for (int i = 0; i < neq; i++)
        t->neq += eq[i].rel == IX_EQUAL_ZERO;
    t->cell = o && o->cell > 0 ? o->cell : 1e-6;
    t->max_boxes = o && o->max_boxes ? o->max_boxes : 1000000;
    t->crowd = o && o->crowd > 0 ? o->crowd : 0;
    s->tol = o && o->tol > 0 ? o->tol : 1e-4;
    ix__patches_shape(p, &t->shape, t->edge);
    for (int j = 0; j < s->n; j++) {
        s->lo[j] = p->sp[j].breaks[0];
        s->hi[j] = p->sp[j].breaks[p->sp[j].nspans];
    }
}

static ix_status solve(ix_ctx *ctx, int neq, const ix_equation *eq,
                       const ix_curves_opts *o, ix_solution_curves *out)
{
    int idx[IX_MAX_UNKNOWNS] = {0}, n;
    ix__patches p;
    ix__curves s;
    ix__box b;

    IX_TRY(ix__patches_check(ctx, neq, eq, 1));
    n = eq[0].f->ndirs;
    if (n < 2 || n > 4)
        return IX_FAIL(ctx, IX_EARG,
                       "curves in %d unknowns; 2 to 4 are possible", n);
    if (neq - (o ? o->checks : 0) != n - 1)
        return IX_FAIL(ctx, IX_EARG, "%d equations for a curve in %d unknowns",
                       neq - (o ? o->checks : 0), n);
    IX_TRY(ix__patches_make(ctx, neq, eq, &p));
    set_up(ctx, neq, eq, o, &p, &s);
    IX_TRY(ix__curves_take_image(ctx, o, &s));
    IX_SCRATCH(ctx, b.c, (size_t)neq * s.t.shape.size);
    for (int i = 0; i < neq; i++)
        p.err[i] += ROUNDED;
    do {
        ix__patches_take(&p, &s.t.shape, neq, idx, &b);
        ix__patch_simple_edges(&s.t.shape, n - 1, &b);
        for (int j = 0; j < n; j++)
            s.joined[j] = ix__patches_joined(&p, &s.t.shape, n - 1, idx, j);
        IX_TRY(ix__curves_patch(&s, &b));
    } while (ix__patches_next(&p, n, idx));
    out->unknowns = n;
    out->boxes = s.t.boxes;
    out->interrupted = s.t.interrupted;
    out->crowded = s.t.crowded;
    out->area = s.area;
    out->complete = s.t.boxes < s.t.max_boxes && !s.t.interrupted &&
                    !s.t.crowded;
    return ix__curves_link(&s, out);
}

ix_status ix_solve_curves(ix_ctx *ctx, int neq, const ix_equation *eq,
                          const ix_curves_opts *o, ix_solution_curves *out)
{
    *out = (ix_solution_curves){.unknowns = 0};
    IX_RETURN_SCOPED(ctx, solve(ctx, neq, eq, o, out));
}
