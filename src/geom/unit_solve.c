/* unit_solve.c - see the header. */
#include "geom/unit_solve.h"

#include <stdint.h>

const ix_mv *ix__pool_unit(ix_pool *q, const ix_mv *m)
{
    for (int d = 0; q->st == IX_OK && d < m->ndirs; d++) {
        double dom[2];

        ix_mv_domain(m, d, dom);
        if (dom[0] < 0 || dom[0] > 0 || dom[1] < 1 || dom[1] > 1)
            m = ix__pool_made(
                q, ix_mv_reparam(q->ctx, m, d, 0, 1, ix__pool_room(q)));
    }
    return q->st == IX_OK ? m : NULL;
}

const ix_mv *ix__pool_linear(ix_pool *q, const double dom[2], int n, int at)
{
    const ix_dir d = {.basis = IX_BEZIER, .order = 2, .length = 2};
    const ix_mv *f;

    if (q->st != IX_OK)
        return NULL;
    f = ix__pool_made(
        q, ix_mv_new(q->ctx, 1, &d, 1, false, dom, ix__pool_room(q)));
    return q->st == IX_OK ? ix__pool_promote(q, f, n, at) : NULL;
}

static void to_domains(const double (*dom)[2], ix_solutions *out)
{
    for (int i = 0; i < out->n; i++)
        for (int k = 0; k < out->unknowns; k++) {
            ix_solution *s = &out->sol[i];
            double a = dom[k][0], w = dom[k][1] - a;

            s->x[k] = s->x[k] >= 1 ? dom[k][1] : a + s->x[k] * w;
            s->lo[k] = a + s->lo[k] * w;
            s->hi[k] = a + s->hi[k] * w;
        }
}

static ix_status holds_everywhere(ix_ctx *ctx, int i)
{
    return IX_FAIL(ctx, IX_EDOMAIN,
                   "condition %d holds everywhere: there are infinitely many "
                   "solutions",
                   i + 1);
}

/* f[i] = 0 each; a condition without a function holds everywhere. */
static ix_status equations(const ix_pool *q, int neq, const ix_mv *const *f,
                           ix_equation *eq)
{
    ix_status st = q->st;

    for (int i = 0; st == IX_OK && i < neq; i++) {
        if (!f[i])
            st = holds_everywhere(q->ctx, i);
        eq[i] = (ix_equation){.f = f[i], .rel = IX_EQUAL_ZERO};
    }
    return st;
}

ix_status ix__unit_solve(ix_pool *q, int neq, const ix_mv *const *f,
                         const double (*dom)[2], const ix_solve_opts *o,
                         ix_solutions *out)
{
    ix_equation eq[3 * IX_MAX_UNKNOWNS];
    ix_status st = equations(q, neq, f, eq);

    *out = (ix_solutions){.n = 0};
    if (st == IX_OK)
        st = ix_solve(q->ctx, neq, eq, o, out);
    ix__pool_free(q);
    if (st == IX_OK)
        to_domains(dom, out);
    return st;
}

static void curves_to_domains(const double (*dom)[2], ix_solution_curves *out)
{
    for (int i = 0; i < out->ncurves; i++) {
        /* the block is ours until it is returned */
        double *x = (double *)(uintptr_t)out->curve[i].x;

        for (int v = 0; v < out->curve[i].n * out->unknowns; v++) {
            const double *d = dom[v % out->unknowns];

            x[v] = x[v] >= 1 ? d[1] : d[0] + x[v] * (d[1] - d[0]);
        }
    }
}

ix_status ix__unit_curves(ix_pool *q, int neq, const ix_mv *const *f,
                          const double (*dom)[2], const ix_curves_opts *o,
                          ix_solution_curves *out)
{
    ix_equation eq[3 * IX_MAX_UNKNOWNS];
    ix_status st = equations(q, neq, f, eq);

    *out = (ix_solution_curves){.unknowns = 0};
    if (st == IX_OK)
        st = ix_solve_curves(q->ctx, neq, eq, o, out);
    ix__pool_free(q);
    if (st == IX_OK)
        curves_to_domains(dom, out);
    return st;
}
