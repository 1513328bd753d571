/* builtins_asymptotic.c - lines that touch surfaces closely, the views at which
 * outlines change, radial curvature (chapters 13 and 19 of spec/functions).
 * Tolerances that scripts give for subdivision are not needed; RESOLUTION sets
 * how fine curves are. */
#include <string.h>

#include "iritx/ops_srf.h"
#include "lang/args_freeform.h"
#include "lang/interp.h"
#include "lang/ret_solutions.h"

/* --- flecnodal curves
 * ---------------------------------------------------------- */

/* All vertices as control points; the curves are released. */
static ix_status ret_vertices(ix_call *c, ix_solution_curves *s)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    ix__remark_open(c, s->complete, s->boxes);
    for (int i = 0; st == IX_OK && i < s->ncurves; i++)
        for (int v = 0; st == IX_OK && v < s->curve[i].n; v++) {
            ix_ctlpt p = {.ncoords = s->unknowns};

            memcpy(p.v, s->curve[i].x + (size_t)v * (size_t)s->unknowns,
                   (size_t)s->unknowns * sizeof *p.v);
            st = ix__list_add(c->ctx, list, ix__obj_ctlpt(c->ctx, &p));
        }
    ix_solution_curves_free(c->ctx, s);
    return ix__ret_list(c, list, st);
}

static ix_status sflecnodal(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    ix_solution_curves s;
    ix_solutions p;
    int contact;

    IX_TRY(ix__arg_int(c, 4, 3, 4, &contact));
    if (contact == 4) {
        IX_TRY(ix_srf_flecnodal_points(c->ctx, m, &p));
        return ix__ret_points(c, &p, NULL);
    }
    IX_TRY(ix_srf_flecnodal(c->ctx, m, ix__contour_tolerance(c), &s));
    if (!ix__arg_bool(c, 5))
        return ret_vertices(c, &s);
    return ix__ret_curves(c, &s, (ix__unknowns){.count = 4}, NULL);
}

/* --- radial curvature
 * ------------------------------------------------------------ */

static ix_status sradcrvtr(ix_call *c)
{
    ix_solution_curves s;
    double view[3];

    IX_TRY(ix__arg_vec3(c, 1, view));
    IX_TRY(ix_srf_radial(c->ctx, ix__arg_mv(c, 0), view,
                         ix__contour_tolerance(c), &s));
    return ix__ret_curves(c, &s, (ix__unknowns){.count = 4}, NULL);
}

/* --- aspect graph
 * ---------------------------------------------------------------- */

/* Lines as polylines first .. of p, with the attribute Event. */
static ix_status put_lines(ix_call *c, const ix_lines *l, const char *event,
                           ix_polygon *p)
{
    size_t at = 0;

    for (int i = 0; i < l->n; i++) {
        p[i].kind = IX_POLYLINE;
        IX_TRY(ix__attr_set_string(c->ctx, &p[i].attrs, "Event", event));
        IX_TRY(ix__poly_vertices(c->ctx, &p[i], l->count[i]));
        for (int v = 0; v < l->count[i]; v++)
            memcpy(p[i].v[v].p, l->pt[at++], sizeof l->pt[0]);
    }
    return IX_OK;
}

static ix_status ret_aspects(ix_call *c, const ix_aspects *a)
{
    int n = a->parabolic.n + a->swallowtail.n;
    ix_status st;
    ix_poly *p;
    ix_obj *o;

    if (!a->complete)
        ix__remark(c->in, "a search was stopped: curves may be missing");
    if (n == 0)
        return IX_OK;
    p = ix__poly_new(c->ctx, n);
    if (!p)
        return IX_ENOMEM;
    st = put_lines(c, &a->parabolic, "parabolic", p->poly);
    if (st == IX_OK)
        st = put_lines(c, &a->swallowtail, "swallowtail",
                       p->poly + a->parabolic.n);
    if (st != IX_OK) {
        ix__poly_unref(c->ctx, p);
        return st;
    }
    o = ix__obj_poly(c->ctx, p); /* takes p over */
    if (!o)
        return IX_ENOMEM;
    st = ix__attr_set_int(c->ctx, &o->attrs, "Parabolic", a->parabolic.n);
    if (st == IX_OK)
        return ix__ret(c, o);
    ix__obj_unref(c->ctx, o);
    return st;
}

static ix_status saspctgrph(ix_call *c)
{
    ix_aspects a;
    ix_status st;

    IX_TRY(
        ix_srf_aspects(c->ctx, ix__arg_mv(c, 0), ix__contour_tolerance(c), &a));
    st = ret_aspects(c, &a);
    ix_aspects_free(c->ctx, &a);
    return st;
}

/* --- table ------------------------------------------------------------- */

#define WAVES                                                           \
    "s = sbezier(list(list(point(0,0,0), point(1,0,1), point(2,0,-1), " \
    "point(3,0,0)), list(point(0,1,1), point(1,1,-1), point(2,1,1), "   \
    "point(3,1,0)), list(point(0,2,-1), point(1,2,1), point(2,2,0), "   \
    "point(3,2,1)), list(point(0,3,0), point(1,3,0), point(2,3,1), "    \
    "point(3,3,-1)))); "

const ix_builtin ix__builtins_asymptotic[] = {
    {"SASPCTGRPH", "s:surface -> poly",
     "Views along which the outline of a surface changes at one of its points, "
     "as polylines on the unit sphere, each with its antipode; their attribute "
     "Event is parabolic (lips, beak-to-beak: asymptotic directions of "
     "parabolic points) or swallowtail (directions of flecnodal curves). "
     "Events "
     "of points one behind the other are not among them.",
     WAVES "o = saspctgrph(s);", saspctgrph, 0, 13},
    {"SFLECNODAL",
     "s:surface subdiv:num numer:num merge:num contact:num univar:bool -> "
     "list",
     "Where a tangent line a S_u + b S_v meets the surface four times (contact "
     "3: flecnodal curves) or five times (contact 4: isolated points): control "
     "points (u, v, a, b), or with univar and contact 3 curves of them, of "
     "order 2. The other numbers are not needed.",
     WAVES "l = sflecnodal(s, 0.1, -1e-6, 0.1, 3, true);", sflecnodal, 0, 19},
    {"SRADCRVTR",
     "s:surface view:vector subdiv:num numer:num merge:num -> list",
     "Where the normal curvature in the direction a S_u + b S_v of the "
     "projected view is zero (radial curvature): curves (u, v, a, b) of order "
     "2. The other numbers are not needed.",
     WAVES "l = sradcrvtr(s, vector(1,0,1), 0.1, -1e-6, 0.1);", sradcrvtr, 0,
     19},
    {0}};
