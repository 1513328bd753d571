/* contour_cone.c - see the header. */
#include "lang/contour_cone.h"

#include <math.h>
#include <string.h>

#include "geom/angle.h"
#include "geom/lines.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"
#include "lang/args_freeform.h"

ix_status ix__arg_cone(ix_call *c, int i, const ix_mv *on, ix__cone *out)
{
    const ix_list *l = &c->argv[i]->u.list;

    out->on = on;
    if (!on || l->n != 2 || l->item[1]->type != IX_OBJ_NUMBER ||
        (l->item[0]->type != IX_OBJ_VECTOR && l->item[0]->type != IX_OBJ_POINT))
        return IX_ARG_FAIL(c, i,
                           "list(direction, degrees) of normals on a surface "
                           "is wanted");
    if (!(l->item[1]->u.num >= 0 && l->item[1]->u.num <= 180))
        return IX_ARG_FAIL(c, i,
                           "an angle of %g degrees; 0 .. 180 are possible",
                           l->item[1]->u.num);
    c->bad_arg = i + 1;
    IX_TRY(ix__direction(c->ctx, "the direction", l->item[0]->u.pt, out->dir));
    c->bad_arg = 0;
    out->cosine = cos(IX__RADIANS(l->item[1]->u.num));
    return IX_OK;
}

static bool in_cone(ix_ctx *ctx, const ix__cone *k, const double *uv)
{
    double n[3];

    return ix_srf_normal(ctx, k->on, uv[0], uv[1], n) == IX_OK &&
           ix__dot3(n, k->dir) >= k->cosine;
}

/* The last place from a (inside) towards b that is in the cone. */
static void last_inside(ix_ctx *ctx, const ix__cone *k, const double a[2],
                        const double b[2], double out[2])
{
    double lo = 0, hi = 1;

    for (int i = 0; i < 48; i++) { /* to the last bits */
        double x = (lo + hi) / 2;

        out[0] = a[0] + (b[0] - a[0]) * x;
        out[1] = a[1] + (b[1] - a[1]) * x;
        if (in_cone(ctx, k, out))
            lo = x;
        else
            hi = x;
    }
    out[0] = a[0] + (b[0] - a[0]) * lo;
    out[1] = a[1] + (b[1] - a[1]) * lo;
}

/* The runs of one curve that are in the cone, their ends between its points. */
static void keep_runs(ix_ctx *ctx, const ix__cone *k,
                      const ix_solution_curve *s, ix_lines *l, size_t *at)
{
    bool inside = false;

    for (int i = 0; i < s->n; i++) {
        const double *x = s->x + 2 * i;
        bool now = in_cone(ctx, k, x);

        if (now && !inside) {
            l->count[l->n++] = 0;
            if (i > 0) {
                last_inside(ctx, k, x, x - 2, l->pt[(*at)++]);
                l->count[l->n - 1]++;
            }
        } else if (inside && !now) {
            last_inside(ctx, k, x - 2, x, l->pt[(*at)++]);
            l->count[l->n - 1]++;
        }
        if (now) {
            memcpy(l->pt[(*at)++], x, 2 * sizeof *x);
            l->count[l->n - 1]++;
        }
        inside = now;
    }
}

ix_status ix__ret_in_cone(ix_call *c, const ix_solution_curves *s,
                          const ix__cone *k)
{
    size_t total = 0, at = 0;
    ix_lines l;
    ix_status st = IX_OK;

    for (int i = 0; i < s->ncurves; i++)
        total += 2 * (size_t)s->curve[i].n;
    IX_TRY(ix__lines_new(c->ctx, total, &l));
    for (int i = 0; i < s->ncurves; i++)
        keep_runs(c->ctx, k, &s->curve[i], &l, &at);
    for (size_t i = 0; st == IX_OK && i < at; i++) {
        double p[3] = {0};

        st = ix_mv_point(c->ctx, k->on, l.pt[i], p);
        memcpy(l.pt[i], p, sizeof p);
    }
    if (st == IX_OK && l.n)
        st = ix__ret_lines(c, &l, IX_POLYLINE);
    ix_lines_free(c->ctx, &l);
    return st;
}
