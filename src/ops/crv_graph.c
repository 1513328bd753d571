/* crv_graph.c - graphs (t, f(t)) of scalar functions of one parameter. */
#include <string.h>

#include "iritx/ops_crv.h"
#include "sym/form.h"

/* The function t on the breaks of f, degree 1. */
static ix_status identity(ix_ctx *ctx, const ix_form *f, ix_form *out)
{
    static const double one = 1.0;
    double start = f->dirs[0].breaks[0];
    ix_form c, s;

    IX_TRY(ix__form_constant(ctx, f, 1, &one, &c));
    IX_TRY(ix__form_integrate(ctx, &c, 0, &c));
    IX_TRY(ix__form_constant(ctx, f, 1, &start, &s));
    return ix__form_add(ctx, &c, 1, &s, out);
}

static ix_status exact(ix_ctx *ctx, const ix_mv *f, ix_mv **out)
{
    const ix_form *parts[3];
    ix_form all, w, x, y, t;
    int n = 0;

    IX_TRY(ix__forms_load(ctx, 1, &f, NULL, &all));
    IX_TRY(identity(ctx, &all, &t));
    w = ix__form_rows(&all, 0, 1);
    y = ix__form_rows(&all, f->rational, 1);
    x = t;
    if (f->rational) {
        IX_TRY(ix__form_mul(ctx, &w, &t, &x));
        parts[n++] = &w;
    }
    parts[n++] = &x;
    parts[n++] = &y;
    IX_TRY(ix__form_join(ctx, n, parts, &all));
    return ix__form_store(ctx, &all, f->rational, NULL, out);
}

/* Abscissae at the nodes, times the weights. */
static ix_status nodal(ix_ctx *ctx, const ix_mv *f, ix_mv **out)
{
    size_t n = f->npts;
    double *node;
    ix_mv *m;

    IX_SCRATCH(ctx, node, n);
    ix_knots_nodes(&f->dirs[0], node);
    IX_TRY(ix__mv_alloc(ctx, 1, f->dirs, 2, true, &m));
    memcpy(m->pts, f->pts, n * sizeof *node);
    for (size_t i = 0; i < n; i++)
        m->pts[n + i] = f->pts[i] * node[i];
    memcpy(m->pts + 2 * n, f->pts + n, n * sizeof *node);
    *out = m;
    return IX_OK;
}

ix_status ix_crv_graph(ix_ctx *ctx, const ix_mv *f, bool nodes, ix_mv **out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    *out = NULL;
    if (f->ndirs != 1 || f->ncoords != 1)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions, %d coordinates: a scalar function of "
                       "one parameter is needed",
                       f->ndirs, f->ncoords);
    if (nodes && f->rational && f->dirs[0].order > 1)
        st = nodal(ctx, f, out);
    else
        st = exact(ctx, f, out);
    ix__scratch_release(ctx, mk);
    return st;
}
