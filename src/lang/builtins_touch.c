/* builtins_touch.c - rays through surfaces, inflections of silhouettes (chapter
 * 13 of spec/functions). Tolerances that scripts give are not needed. */
#include <math.h>
#include <string.h>

#include "iritx/contour.h"
#include "iritx/distance.h"
#include "iritx/geom_srf.h"
#include "lang/args_freeform.h"
#include "lang/interp.h"
#include "mv/mv.h"

/* --- rays ------------------------------------------------------------------
 */

static ix_obj *uv_point(ix_ctx *ctx, const double *uv)
{
    const double p[3] = {uv[0], uv[1], 0};

    return ix__obj_point(ctx, p);
}

static void remark_boxes(ix_call *c, const ix_solutions *s)
{
    if (!s->complete)
        ix__remark(c->in,
                   "stopped after %zu boxes: there may be infinitely many "
                   "solutions",
                   s->boxes);
}

/* The first hit, or for a direction of length 0 the nearest point. */
static ix_status srinter(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    double p[3], d[3], uv[2], dist;
    ix_solutions s;
    ix_status st;

    IX_TRY(ix__arg_pt3(c, 1, p));
    IX_TRY(ix__arg_vec3(c, 2, d));
    if (!(fabs(d[0]) + fabs(d[1]) + fabs(d[2]) > 0)) {
        IX_TRY(ix_srf_nearest(c->ctx, m, p, false, uv, &dist));
        return ix__ret(c, uv_point(c->ctx, uv));
    }
    IX_TRY(ix_srf_ray(c->ctx, m, p, d, &s));
    remark_boxes(c, &s);
    st = s.n ? ix__ret(c, uv_point(c->ctx, s.sol[0].x)) : IX_OK;
    ix_solutions_free(c->ctx, &s);
    return st;
}

/* A hit as (u, v, 0) and its point. */
static ix_status add_hit(ix_call *c, ix_obj *list, const ix_mv *m,
                         const double *uv)
{
    double x[IX_MAX_COORDS] = {0};

    IX_TRY(ix_mv_point(c->ctx, m, uv, x));
    IX_TRY(ix__list_add(c->ctx, list, uv_point(c->ctx, uv)));
    return ix__list_add(c->ctx, list, ix__obj_point(c->ctx, x));
}

static ix_status srayclip(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 2);
    double p[3], d[3];
    ix_solutions s;
    ix_obj *list;
    ix_status st;

    IX_TRY(ix__arg_pt3(c, 0, p));
    IX_TRY(ix__arg_vec3(c, 1, d));
    IX_TRY(ix_srf_ray(c->ctx, m, p, d, &s));
    remark_boxes(c, &s);
    list = ix__obj_list(c->ctx);
    st = ix__list_add_num(c->ctx, list, s.n);
    for (int i = 0; st == IX_OK && i < s.n; i++)
        st = add_hit(c, list, m, s.sol[i].x);
    ix_solutions_free(c->ctx, &s);
    return ix__ret_list(c, list, st);
}

/* --- silhouettes
 * -------------------------------------------------------------- */

/* Points (u, v, 0) as one object; no value if there are none. */
static ix_status ssilinfl(ix_call *c)
{
    double view[3];
    ix_solutions s;
    ix_status st;
    ix_poly *p;

    IX_TRY(ix__arg_vec3(c, 1, view));
    IX_TRY(ix_silhouette_inflections(c->ctx, ix__arg_mv(c, 0), view, &s));
    remark_boxes(c, &s);
    p = s.n ? ix__poly_new(c->ctx, 1) : NULL;
    st = s.n && !p ? IX_ENOMEM : IX_OK;
    if (p) {
        p->poly[0].kind = IX_POINTLIST;
        st = ix__poly_vertices(c->ctx, &p->poly[0], s.n);
        for (int i = 0; st == IX_OK && i < s.n; i++)
            memcpy(p->poly[0].v[i].p, s.sol[i].x, 2 * sizeof(double));
    }
    ix_solutions_free(c->ctx, &s);
    if (st == IX_OK && p)
        return ix__ret(c, ix__obj_poly(c->ctx, p));
    if (p)
        ix__poly_unref(c->ctx, p);
    return st;
}

#define S                                                               \
    "s = sbezier(list(list(point(0,0,0), point(1,0,0), point(2,0,0)), " \
    "list(point(0,1,0), point(1,1,4), point(2,1,0)), "                  \
    "list(point(0,2,0), point(1,2,0), point(2,2,0)))); "

const ix_builtin ix__builtins_touch[] = {
    {"SRINTER", "s:surface p:pt3 d:pv tol:num -> point",
     "The parameters (u, v, 0) of the first point in which the ray from p in "
     "direction d meets a surface (no value if it does not); if d is 0, of the "
     "point nearest to p. tol is not needed.",
     S "q = srinter(s, point(1, 1, 5), vector(0, 0, -1), 0.001);", srinter, 0,
     13},
    {"SRAYCLIP", "p:pt3 d:pv s:surface -> list",
     "All points in which the ray from p in direction d meets a surface, the "
     "nearest first: list(n, uv1, point1, uv2, point2, ...).",
     S "l = srayclip(point(0.7, 1.2, 4), vector(0, 0, -1), s);", srayclip, 0,
     13},
    {"SSILINFL", "s:surface view:pv subdiv:num numer:num -> poly",
     "The points (u, v, 0) of the silhouette at which the view is an "
     "asymptotic "
     "direction: the seen outline has a cusp there. No value if there are "
     "none.",
     S "o = ssilinfl(s, vector(1, 0.1, 0.2), 0.01, 1e-8);", ssilinfl, 0, 13},
    {0}};
