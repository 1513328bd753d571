/* builtins_enclose.c - least circles, spheres and cones; kernels; curves that
 * overlap (chapters 9, 10 and 22 of spec/functions). */
#include <math.h>
#include <string.h>

#include "iritx/distance.h"
#include "iritx/enclose.h"
#include "iritx/geom_srf.h"
#include "iritx/kernel.h"
#include "lang/args_freeform.h"
#include "lang/interp.h"
#include "mv/mv.h"

/* --- least circles and spheres
 * ----------------------------------------------- */

/* The geometry with its centre and radius as attributes; takes over m. */
static ix_status ret_ball(ix_call *c, ix_obj_type type, const ix_mv *m,
                          const ix_ball *b)
{
    ix_obj *o = ix__obj_mv(c->ctx, type, m);
    ix_obj *center = ix__obj_point(c->ctx, b->center);
    ix_status st = o && center ? IX_OK : IX_ENOMEM;

    if (st == IX_OK)
        st = ix__attr_set_real(c->ctx, &o->attrs, "radius", b->radius);
    if (st == IX_OK)
        st = ix__attr_set_obj(c->ctx, &o->attrs, "center", center);
    ix__obj_unref(c->ctx, center);
    if (st == IX_OK)
        return ix__ret(c, o);
    ix__obj_unref(c->ctx, o);
    return st;
}

static ix_status point_list(ix_call *c, int *n, double (**out)[3])
{
    const ix_list *l = &c->argv[0]->u.list;
    double(*v)[3];

    IX_SCRATCH(c->ctx, v, l->n);
    for (*n = 0; *n < l->n; ++*n) {
        const ix_obj *o = l->item[*n];

        if (o->type != IX_OBJ_POINT && o->type != IX_OBJ_VECTOR)
            return ix__wrong_element(c, 0, *n, o, "a point or vector");
        memcpy(v[*n], o->u.pt, sizeof *v);
    }
    *out = v;
    return IX_OK;
}

static ix_status mscirc(ix_call *c)
{
    const ix_mv **crv;
    double(*p)[3];
    ix_ball b;
    ix_mv *m;
    int n;

    if (c->argv[0]->type == IX_OBJ_POLY) {
        IX_TRY(ix__arg_vertices(c, 0, &n, &p));
        IX_TRY(ix_ball_of_points(c->ctx, n, (const double(*)[3])p, &b));
    } else {
        IX_TRY(ix__arg_mvs(c, 0, IX_OBJ_CURVE, &n, &crv));
        IX_TRY(ix_ball_of_curves(c->ctx, n, crv, &b));
    }
    IX_TRY(ix_circle(c->ctx, b.center, b.radius, &m));
    return ret_ball(c, IX_OBJ_CURVE, m, &b);
}

/* A half circle from pole to pole turned about the Z axis. */
static ix_status sphere(ix_ctx *ctx, const ix_ball *b, ix_mv **out)
{
    const double r = b->radius, zero[3] = {0, 0, 0};
    const double m[16] = {0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1};
    double move[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    ix_mv *cur, *next;

    memcpy(move + 12, b->center, sizeof b->center);
    IX_TRY(ix_circle(ctx, zero, r, &cur));
    IX_TRY(
        ix__mv_step(ctx, &cur, &next, ix_mv_region(ctx, cur, 0, 0, 2, &next)));
    /* (x, y) becomes (y in x, x in z): from pole to pole in x >= 0 */
    IX_TRY(ix__mv_step(ctx, &cur, &next, ix_mv_transform(ctx, cur, m, &next)));
    IX_TRY(ix__mv_step(ctx, &cur, &next,
                       ix_srf_revolve(ctx, cur, IX_TURN_RATIONAL, &next)));
    IX_TRY(
        ix__mv_step(ctx, &cur, &next, ix_mv_transform(ctx, cur, move, &next)));
    *out = cur;
    return IX_OK;
}

static ix_status mssphere(ix_call *c)
{
    double(*p)[3];
    ix_ball b;
    ix_mv *m;
    int n;

    IX_TRY(point_list(c, &n, &p));
    IX_TRY(ix_ball_of_points(c->ctx, n, (const double(*)[3])p, &b));
    IX_TRY(sphere(c->ctx, &b, &m));
    return ret_ball(c, IX_OBJ_SURFACE, m, &b);
}

static ix_status mscone(ix_call *c)
{
    double(*v)[3], axis[3], angle;
    ix_obj *list;
    ix_status st;
    int n;

    IX_TRY(point_list(c, &n, &v));
    IX_TRY(ix_cone_of_vectors(c->ctx, n, (const double(*)[3])v, axis, &angle));
    list = ix__obj_list(c->ctx);
    st = ix__list_add(c->ctx, list, ix__obj_vector(c->ctx, axis));
    if (st == IX_OK)
        st = ix__list_add_num(c->ctx, list, angle);
    return ix__ret_list(c, list, st);
}

/* --- overlapping curves
 * ------------------------------------------------------ */

static ix_status ffcmpcrvs(ix_call *c)
{
    ix_overlap o;

    IX_TRY(ix_crv_overlap(c->ctx, ix__arg_mv(c, 0), ix__arg_mv(c, 1),
                          ix__arg_num(c, 2), &o));
    return ix__ret_nums(
        c, 5, (double[]){(double)o.relation, o.a[0], o.a[1], o.b[0], o.b[1]});
}

/* --- kernels ---------------------------------------------------------------
 */

/* The numbers of argument 3, a list or one number, of which the last says how
 * fine. */
static ix_status arg_fineness(ix_call *c, int *n, double **v)
{
    if (c->argv[3]->type == IX_OBJ_LIST)
        return ix__arg_nums(c, 3, n, v);
    IX_SCRATCH(c->ctx, *v, 1);
    (*v)[0] = ix__arg_num(c, 3);
    *n = 1;
    return IX_OK;
}

/* (x, y) over the box to [0, 1]^2, unless euclid is on. */
static void to_box(const ix_mv *crv, ix_ctx *ctx, ix_lines *l)
{
    double lo[IX_MAX_COORDS], hi[IX_MAX_COORDS];

    if (ix_mv_bbox(ctx, crv, lo, hi) != IX_OK)
        return;
    for (int i = 0; i < 4 * l->n; i++)
        for (int k = 0; k < 2; k++)
            l->pt[i][k] = (l->pt[i][k] - lo[k] + 1) / (hi[k] - lo[k] + 2);
}

static ix_status kernel_sheet(ix_call *c, double gamma, double fineness)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    double lo[2], hi[2];
    ix_status st;
    ix_lines l;
    ix_mv *f;

    if (fineness < 0) {
        IX_TRY(ix_crv_kernel_field(c->ctx, m, gamma, lo, hi, &f));
        return ix__ret_mv(c, -1, f);
    }
    IX_TRY(ix_crv_kernel_sheet(
        c->ctx, m, gamma, (int)(4 * fmin(fmax(fineness, 0), 1e4)) + 2, &l));
    if (!ix__arg_bool(c, 2))
        to_box(m, c->ctx, &l);
    st = ix__ret_lines(c, &l, IX_POLYGON);
    ix_lines_free(c->ctx, &l);
    return st;
}

/* The vertices of the envelope as points (x, y, 0). */
static ix_status kernel_envelope(ix_call *c, double gamma, double step)
{
    double lo[2], hi[2];
    ix_solution_curves s;
    ix_obj *list;
    ix_status st;
    ix_mv *f;

    IX_TRY(ix_crv_kernel_field(c->ctx, ix__arg_mv(c, 0), gamma, lo, hi, &f));
    ix_mv_unref(c->ctx, f);
    IX_TRY(ix_crv_kernel_envelope(c->ctx, ix__arg_mv(c, 0), gamma,
                                  fmin(fmax(step * step / 8, 1e-8), 1e-2), &s));
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; i < s.ncurves; i++)
        for (int k = 0; st == IX_OK && k < s.curve[i].n; k++) {
            const double *x = s.curve[i].x + 3 * (size_t)k;
            const double p[3] = {lo[0] + x[0] * (hi[0] - lo[0]),
                                 lo[1] + x[1] * (hi[1] - lo[1]), 0};

            st = ix__list_add(c->ctx, list, ix__obj_point(c->ctx, p));
        }
    ix_solution_curves_free(c->ctx, &s);
    return ix__ret_list(c, list, st);
}

static ix_status crvkernel(ix_call *c)
{
    double gamma = ix__arg_num(c, 1) * (acos(-1) / 180), *fine;
    int mode, n;
    ix_mv *out;

    IX_TRY(ix__arg_int(c, 4, 0, 2, &mode));
    IX_TRY(arg_fineness(c, &n, &fine));
    if (n < 1)
        return IX_ARG_FAIL(c, 3, "an empty list; a number is wanted");
    if (mode == 0)
        return kernel_sheet(c, gamma, fine[n - 1]);
    if (mode == 1)
        return kernel_envelope(c, gamma, fine[0]);
    IX_TRY(
        ix_crv_kernel_surface(c->ctx, ix__arg_mv(c, 0), gamma, fine[0], &out));
    return ix__ret_mv(c, -1, out);
}

static ix_status srfkernel(ix_call *c)
{
    int samples, skip;
    double error;
    ix_lines l;
    ix_status st;

    IX_TRY(ix__arg_int(c, 1, 1, 1000, &samples));
    IX_TRY(ix__arg_int(c, 2, 1, 1000000, &skip));
    IX_TRY(ix_srf_kernel(c->ctx, ix__arg_mv(c, 0), samples, skip, &error, &l));
    st = l.n ? ix__ret_lines(c, &l, IX_POLYGON) : IX_OK;
    ix_lines_free(c->ctx, &l);
    if (st != IX_OK || !c->result)
        return st;
    return ix__attr_set_real(c->ctx, &c->result->attrs, "Error", error);
}

const ix_builtin ix__builtins_enclose[] = {
    {"MSCIRC", "x:poly|list tols:list|num -> curve",
     "The smallest circle in the XY plane that holds all vertices of x, or all "
     "curves of the list x, exactly; its attributes center and radius tell "
     "where. The tolerances are not needed.",
     "c = mscirc(poly(list(point(0,0,0), point(1,0,0), point(0,1,0)), true), "
     "nil()); r = getattr(c, \"radius\");",
     mscirc, 0, 22},
    {"MSSPHERE", "pts:list -> surface",
     "The smallest sphere that holds all points of a list, with the attributes "
     "center and radius.",
     "s = mssphere(list(point(0,0,0), point(1,0,0), point(0,1,1)));", mssphere,
     0, 22},
    {"MSCONE", "vecs:list -> list",
     "The narrowest cone that holds all vectors: list(unit axis, half angle in "
     "radians).",
     "l = mscone(list(vector(1,0,1), vector(0,1,1), vector(-1,0,1)));", mscone,
     0, 22},
    {"FFCMPCRVS", "c1:curve c2:curve eps:num -> list",
     "How two curves lie on each other within eps: list(relation, start1, "
     "end1, "
     "start2, end2), relation 1 the same, 2 they overlap on these intervals "
     "(the longest; start2 > end2 if they run against each other), 3 distinct.",
     "c = cbezier(list(ctlpt(E2,0,0), ctlpt(E2,1,2), ctlpt(E2,3,0))); "
     "l = ffcmpcrvs(c, cregion(c, 0.2, 0.7), 1e-5);",
     ffcmpcrvs, 0, 10},
    {"CRVKERNEL",
     "c:curve gamma:num euclid:bool fineness:num|list mode:num -> "
     "poly|trivar|surface|list",
     "The tangent lines of a closed curve, turned by gamma degrees: what they "
     "leave free is its kernel. mode 0: quadrangles (x, y, t) on the sheet "
     "that they sweep, x and y in the curve's box enlarged by 1 (euclid on) or "
     "in [0, 1]; a negative last fineness: the function itself, F(x, y, t). "
     "mode 1: points (x, y, 0) of their envelope. mode 2: the sheet as a "
     "surface, fineness being its extent along the lines.",
     "c = circle(vector(0,0,0), 1); o = crvkernel(c, 0, true, list(2, 2, 2), "
     "0);",
     crvkernel, 0, 9},
    {"SRFKERNEL", "s:surface fineness:num skip:num -> poly",
     "The kernel of a closed surface, from where all of it is seen, as a "
     "convex "
     "polyhedron around it: the tangent planes at fineness places of each "
     "patch "
     "and direction, every skip-th cut first (which changes the time only). "
     "Attribute Error: farthest that it is in front of a tangent plane between "
     "these. No value if there is no kernel.",
     "s = spheresrf(1); o = srfkernel(s, 10, 5);", srfkernel, 0, 13},
    {0}};
