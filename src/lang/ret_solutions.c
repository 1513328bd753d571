/* ret_solutions.c - what the solver found as results of functions. */
#include "lang/ret_solutions.h"

#include <math.h>
#include <string.h>

#include "lang/args_freeform.h"
#include "lang/interp.h"
#include "mv/mv.h"

void ix__remark_open(ix_call *c, bool complete, size_t boxes)
{
    if (!complete)
        ix__remark(c->in,
                   "stopped after %zu boxes: there may be infinitely many "
                   "solutions",
                   boxes);
}

#define FINE 1e-4 /* of the domain: a place that needs no remark */

/* Where curves end at places that are known only roughly. */
static void remark_rough(ix_call *c, const ix_solution_curves *s)
{
    double widest = 0;

    for (int i = 0; i < s->nsingular; i++)
        for (int j = 0; j < s->unknowns; j++)
            widest = fmax(widest, s->singular[i].hi[j] - s->singular[i].lo[j]);
    if (s->complete && widest > 0.9)
        ix__remark(c->in, "the conditions hold everywhere, or nearly");
    else if (s->complete && widest > FINE)
        ix__remark(c->in,
                   "the conditions depend on each other near %d points: curves "
                   "that meet there end before, up to %.2g of the parameters "
                   "away",
                   s->nsingular, widest);
}

ix_status ix__add_solution_curve(ix_call *c, const ix_solution_curve *k,
                                 ix__unknowns v, ix_obj *list)
{
    int nc = v.m ? 3 : v.count;
    double *pts, x[IX_MAX_COORDS] = {0};
    ix_obj *o;

    IX_SCRATCH(c->ctx, pts, (size_t)nc * (size_t)k->n);
    for (int i = 0; i < k->n; i++) {
        const double *at = k->x + (size_t)i * (size_t)v.unknowns + v.first;

        if (v.m)
            IX_TRY(ix_mv_point(c->ctx, v.m, at, x));
        else
            memcpy(x, at, (size_t)nc * sizeof *x);
        for (int e = 0; e < nc; e++)
            pts[(size_t)e * (size_t)k->n + (size_t)i] = x[e];
    }
    IX_TRY(ix__polyline_curve(c, k->n, nc, pts, &o));
    return ix__list_add(c->ctx, list, o);
}

ix_status ix__ret_curves(ix_call *c, ix_solution_curves *s, ix__unknowns v,
                         ix__keep_solution keep)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    ix__remark_open(c, s->complete, s->boxes);
    remark_rough(c, s);
    v.unknowns = s->unknowns;
    for (int i = 0; st == IX_OK && i < s->ncurves; i++) {
        const ix_solution_curve *k = &s->curve[i];
        bool wanted = true;

        if (keep)
            st = keep(c, k->x + (size_t)(k->n / 2) * (size_t)s->unknowns,
                      &wanted);
        if (st == IX_OK && wanted)
            st = ix__add_solution_curve(c, k, v, list);
    }
    ix_solution_curves_free(c->ctx, s);
    return ix__ret_list(c, list, st);
}

ix_status ix__ret_points(ix_call *c, ix_solutions *s, ix__keep_solution keep)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    ix__remark_open(c, s->complete, s->boxes);
    for (int i = 0; st == IX_OK && i < s->n; i++) {
        ix_ctlpt p = {.ncoords = s->unknowns};
        bool wanted = true;

        memcpy(p.v, s->sol[i].x, (size_t)s->unknowns * sizeof *p.v);
        if (keep)
            st = keep(c, s->sol[i].x, &wanted);
        if (st == IX_OK && wanted)
            st = ix__list_add(c->ctx, list, ix__obj_ctlpt(c->ctx, &p));
    }
    ix_solutions_free(c->ctx, s);
    return ix__ret_list(c, list, st);
}
