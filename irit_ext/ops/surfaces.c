/* surfaces.c - differential geometry of surfaces, duals (chapters 19 and 20 of
 * the reference). */
#include "irit_ext/ops/ops.h"
#include "iritx/ops_srf.h"
#include "iritx/sym.h"

/* --- fields -------------------------------------------------------------- */

static ix_status srffform(const ix_host *h, ix_call *c)
{
    ix_op_opts o = h->op_opts(c);
    ix_obj *list;
    ix_status st = IX_OK;
    ix_mv *f[3];
    int k;

    IX_TRY(h->arg_int(c, 1, 1, 3, &k));
    IX_TRY(ix_srf_forms(h->ctx(c), h->arg_mv(c, 0), k, &o, f));
    list = h->list(h->ctx(c));
    for (int i = 0; i < 3; i++) { /* all are taken over, also after a failure */
        ix_obj *one = h->freeform(h->ctx(c), IX_OBJ_SURFACE, f[i]);
        ix_status s = h->list_add(h->ctx(c), list, one);

        st = st == IX_OK ? s : st;
    }
    return h->ret_list(c, list, st);
}

static ix_status sgauss(const ix_host *h, ix_call *c)
{
    ix_op_opts o = h->op_opts(c);
    ix_mv *out;

    IX_TRY(ix_srf_gauss(h->ctx(c), h->arg_mv(c, 0), h->arg_bool(c, 1), &o, NULL,
                        &out));
    return h->ret_mv(c, 0, out);
}

static ix_status smean(const ix_host *h, ix_call *c)
{
    ix_op_opts o = h->op_opts(c);
    ix_mv *out;

    IX_TRY(ix_srf_mean(h->ctx(c), h->arg_mv(c, 0), h->arg_bool(c, 1), &o, NULL,
                       &out));
    return h->ret_mv(c, 0, out);
}

/* The parameter of direction i as a scalar over the domain of f. */
static ix_status parameter(ix_ctx *ctx, const ix_mv *f, int i, ix_mv **out)
{
    ix_dir d[2] = {{IX_BEZIER, 1, 1, false, NULL},
                   {IX_BEZIER, 1, 1, false, NULL}};
    double dom[2][2];
    ix_mv *unit, *half;
    ix_status st;

    d[i].order = d[i].length = 2;
    for (int k = 0; k < 2; k++)
        ix_mv_domain(f, k, dom[k]);
    IX_TRY(ix_mv_new(ctx, 2, d, 1, false, dom[i], &unit));
    st = ix_mv_reparam(ctx, unit, 0, dom[0][0], dom[0][1], &half);
    ix_mv_unref(ctx, unit);
    IX_TRY(st);
    st = ix_mv_reparam(ctx, half, 1, dom[1][0], dom[1][1], out);
    ix_mv_unref(ctx, half);
    return st;
}

/* The scalar surface f / w as (w, f, u w, v w): one degree more. */
static ix_status height_field(ix_ctx *ctx, const ix_mv *f, ix_mv **out)
{
    ix_mv *t[6] = {NULL};
    const ix_mv *axes[4];
    ix_status st = ix_mv_scalar(ctx, f, 0, &t[0]);

    if (st == IX_OK)
        st = ix_mv_scalar(ctx, f, 1, &t[1]);
    for (int i = 0; st == IX_OK && i < 2; i++) {
        st = parameter(ctx, f, i, &t[4 + i]);
        if (st == IX_OK)
            st = ix_sym_mul(ctx, t[4 + i], t[0], NULL, &t[2 + i]);
    }
    for (int i = 0; i < 4; i++)
        axes[i] = t[i];
    if (st == IX_OK)
        st = ix_mv_join_scalars(ctx, 4, axes, true, out);
    for (int i = 0; i < 6; i++)
        ix_mv_unref(ctx, t[i]);
    return st;
}

static ix_status scrvtr(const ix_host *h, ix_call *c)
{
    ix_op_opts o = h->op_opts(c);
    ix_srf_curvature_kind kind = IX_SRF_TOTAL;
    ix_mv *f, *g = NULL, *out;
    int nc, dir;
    ix_status st;
    bool rational;

    IX_TRY(h->arg_pttype(c, 1, &nc, &rational));
    if (nc != 1 && nc != 3)
        return h->arg_fail(c, 1, "%d coordinates; E1, P1, E3 or P3 is wanted",
                           nc);
    if (h->arg_num(c, 2) != 0) {
        IX_TRY(h->arg_dir(c, 2, 2, &dir));
        kind = dir == 0 ? IX_SRF_ALONG_U : IX_SRF_ALONG_V;
    }
    IX_TRY(ix_srf_curvature(h->ctx(c), h->arg_mv(c, 0), kind, &o, NULL, &f));
    st = nc == 3 ? height_field(h->ctx(c), f, &g) : IX_OK;
    if (st == IX_OK)
        st = ix_mv_coerce(h->ctx(c), g ? g : f, nc, rational, &out);
    ix_mv_unref(h->ctx(c), f);
    ix_mv_unref(h->ctx(c), g);
    IX_TRY(st);
    return h->ret_mv(c, 0, out);
}

static ix_status sfocal(const ix_host *h, ix_call *c)
{
    ix_op_opts o = h->op_opts(c);
    ix_mv *out;
    int dir;

    IX_TRY(h->arg_dir(c, 1, 2, &dir));
    IX_TRY(ix_srf_focal(h->ctx(c), h->arg_mv(c, 0), dir, &o, NULL, &out));
    return h->ret_mv(c, 0, out);
}

/* --- duals --------------------------------------------------------------- */

static ix_status duality(const ix_host *h, ix_call *c)
{
    ix_op_opts o = h->op_opts(c);
    ix_mv *out;

    IX_TRY(ix_duality(h->ctx(c), h->arg_mv(c, 0), &o, &out));
    return h->ret_mv(c, 0, out);
}

static ix_status orthotomc(const ix_host *h, ix_call *c)
{
    ix_op_opts o = h->op_opts(c);
    double p[3];
    ix_mv *out;

    IX_TRY(h->arg_pt3(c, 1, p));
    IX_TRY(ix_orthotomic(h->ctx(c), h->arg_mv(c, 0), p, h->arg_num(c, 2), &o,
                         &out));
    return h->ret_mv(c, 0, out);
}

/* --- special curves and points ------------------------------------------- */

static ix_status sparabolc(const ix_host *h, ix_call *c)
{
    const ix_mv *m = h->arg_mv(c, 0);
    ix_solution_curves s;
    ix_status st;

    IX_TRY(ix_srf_parabolic(h->ctx(c), m, h->contour_tol(c), &s));
    st = h->ret_contours(c, &s, h->arg_bool(c, 1) ? m : NULL);
    ix_solution_curves_free(h->ctx(c), &s);
    return st;
}

static ix_obj *umbilic(const ix_host *h, ix_ctx *ctx, const ix_solution *s)
{
    const double p[3] = {s->x[0], s->x[1], 0};
    ix_obj *o = h->point(ctx, p);

    if (o && h->attr_set_int(ctx, o, "SingleSol", s->certified) != IX_OK) {
        h->unref(ctx, o);
        return NULL;
    }
    return o;
}

static ix_status sumbilic(const ix_host *h, ix_call *c)
{
    ix_obj *list;
    ix_solutions s;
    ix_status st;

    IX_TRY(ix_srf_umbilics(h->ctx(c), h->arg_mv(c, 0), NULL, &s));
    if (!s.complete)
        h->remark(c, "stopped after %zu boxes: umbilics may be missing",
                  s.boxes);
    list = h->list(h->ctx(c));
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < s.n; i++)
        st = h->list_add(h->ctx(c), list, umbilic(h, h->ctx(c), &s.sol[i]));
    ix_solutions_free(h->ctx(c), &s);
    return h->ret_list(c, list, st);
}

/* Direction i in space, or (a, b, 0). */
static ix_obj *direction(const ix_host *h, ix_call *c, const ix_principal *p,
                         int i)
{
    const double ab[3] = {p->ab[i][0], p->ab[i][1], 0};

    return h->vector(h->ctx(c), h->arg_bool(c, 3) ? p->dir[i] : ab);
}

static ix_status scrvtreval(const ix_host *h, ix_call *c)
{
    ix_obj *list;
    ix_principal p;
    ix_status st;

    IX_TRY(ix_srf_principal(h->ctx(c), h->arg_mv(c, 0), h->arg_num(c, 1),
                            h->arg_num(c, 2), &p));
    list = h->list(h->ctx(c));
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < 2; i++) {
        st = h->list_add_num(h->ctx(c), list, p.k[i]);
        if (st == IX_OK)
            st = h->list_add(h->ctx(c), list, direction(h, c, &p, i));
    }
    return h->ret_list(c, list, st);
}

static ix_status sasympeval(const ix_host *h, ix_call *c)
{
    ix_obj *list;
    ix_principal p;
    ix_status st;
    int n;

    IX_TRY(ix_srf_asymptotic(h->ctx(c), h->arg_mv(c, 0), h->arg_num(c, 1),
                             h->arg_num(c, 2), &n, &p));
    list = h->list(h->ctx(c));
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < n; i++)
        st = h->list_add(h->ctx(c), list, direction(h, c, &p, i));
    return h->ret_list(c, list, st);
}

/* --- table --------------------------------------------------------------- */

#define SADDLE                                                          \
    "s = sbezier(list(list(point(0,0,0), point(1,0,0), point(2,0,1)), " \
    "list(point(0,1,0), point(1,1,1), point(2,1,0)))); "
#define CRV "c = cbezier(list(ctlpt(E2,1,1), ctlpt(E2,2,3), ctlpt(E2,4,2))); "

static const ix_plugin_row rows[] = {
    {"SRFFFORM", "s:surface k:num -> list",
     "The coefficients 11, 12, 22 of the fundamental form k = 1, 2, 3 as "
     "scalar surfaces; the second with the normal S_v x S_u not normalised.",
     SADDLE "l = srffform(s, 1);", srffform, 0, 19},
    {"SGAUSS", "s:surface numer:bool -> surface",
     "The Gauss curvature as a rational scalar surface, or its numerator "
     "scaled to a largest control value of 1.",
     SADDLE "k = sgauss(s, false);", sgauss, 0, 19},
    {"SMEAN", "s:surface numer:bool -> surface",
     "The squared mean curvature as a rational scalar surface, or the "
     "numerator of the mean curvature scaled to a largest control value of 1.",
     SADDLE "h = smean(s, false);", smean, 0, 19},
    {"SCRVTR", "s:surface ptype:num dir:num -> surface",
     "The squared normal curvature of the curves along COL (u) or ROW (v), or "
     "the sum of the squared principal curvatures (OFF), exactly as P1 or as "
     "the height field P3 (value, u, v); E1 and E3 divide each control point "
     "of these by its weight, which is near the values only.",
     SADDLE "k = scrvtr(s, P1, OFF);", scrvtr, 0, 19},
    {"SFOCAL", "s:surface dir:num -> surface",
     "The centres of normal curvature along COL (u varies) or ROW (v varies).",
     "s = spheresrf(1); f = sfocal(s, COL);", sfocal, 0, 19},
    {"SPARABOLC", "s:surface euclid:bool -> poly",
     "Where the Gauss curvature is zero, as polylines on the surface or in its "
     "parameters; RESOLUTION sets their fineness. No value if there is no "
     "such curve.",
     "s = torussrf(3, 1); p = sparabolc(s, true);", sparabolc, 0, 19},
    {"SUMBILIC", "s:surface subdiv:num numer:num -> list",
     "The umbilics as points (u, v, 0), with SingleSol 1 where exactly one is "
     "proven; both numbers are accepted and not needed.",
     SADDLE "l = sumbilic(s, 0.01, 1e-8);", sumbilic, 0, 19},
    {"SCRVTREVAL", "s:surface u:num v:num euclid:bool -> list",
     "Principal curvatures and directions at a point: k1, d1, k2, d2 with k1 "
     "not below k2; directions in space of length 1, or their parts along "
     "S_u and S_v.",
     SADDLE "l = scrvtreval(s, 0.3, 0.3, true);", scrvtreval, 0, 19},
    {"SASYMPEVAL", "s:surface u:num v:num euclid:bool -> list",
     "The asymptotic directions at a point, at most two; as SCRVTREVAL.",
     SADDLE "l = sasympeval(s, 0.3, 0.3, true);", sasympeval, 0, 19},
    {"DUALITY", "x:curve|surface -> curve|surface",
     "The dual of a planar curve or a surface: the point (A, B) / C for the "
     "tangent A x + B y + C = 0, (A, B, C) / D for the tangent plane.",
     CRV "d = duality(c);", duality, 0, 20},
    {"ORTHOTOMC", "x:curve|surface p:pt3 k:num -> curve|surface",
     "The k-orthotomic of a planar curve or a surface: p moved k times the way "
     "to the tangent; k = 2 mirrors p, k = 1 is the pedal.",
     CRV "o = orthotomc(c, point(0, 0, 0), 2);", orthotomc, 0, 20},
    {0}};

ix_status ix__ops_surfaces(const ix_host *h, ix_registry *r)
{
    return h->add(r, IX_PLUGIN_VERSION, rows);
}
