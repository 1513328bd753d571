/* builtins_solve.c - zero sets (chapters 9 and 22 of spec/functions): zeros
 * and extremes of curves, systems of equations, solution curves. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "iritx/solve.h"
#include "iritx/sym.h"
#include "lang/args_freeform.h"
#include "lang/interp.h"

/* --- one unknown -------------------------------------------------------------
 */

/* A number with what is special about the root: its kind and multiplicity. */
static ix_obj *root_object(ix_ctx *ctx, const ix_root *r, double t)
{
    static const char *const kinds[] = {"simple", "touch", "cluster", "jump",
                                        "interval"};
    ix_obj *o = ix__obj_number(ctx, t);
    ix_status st = IX_OK;

    if (!o || r->kind == IX_ROOT_SIMPLE)
        return o;
    st = ix__attr_set_string(ctx, &o->attrs, "RootKind", kinds[r->kind]);
    if (st == IX_OK && r->count > 1)
        st = ix__attr_set_int(ctx, &o->attrs, "Multiplicity", r->count);
    if (st == IX_OK)
        return o;
    ix__obj_unref(ctx, o);
    return NULL;
}

static ix_status add_root(ix_ctx *ctx, ix_obj *list, const ix_root *r)
{
    if (r->kind != IX_ROOT_INTERVAL)
        return ix__list_add(ctx, list, root_object(ctx, r, r->t));
    IX_TRY(ix__list_add(ctx, list, root_object(ctx, r, r->lo)));
    return ix__list_add(ctx, list, root_object(ctx, r, r->hi));
}

static ix_status root_list(ix_call *c, const ix_mv *f, int axis)
{
    ix_obj *list = NULL;
    ix_root *r;
    ix_status st;
    int n;

    IX_TRY(ix_roots(c->ctx, f, axis, NULL, &r, &n));
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < n; i++)
        st = add_root(c->ctx, list, &r[i]);
    ix_roots_free(c->ctx, r, n);
    return ix__ret_list(c, list, st);
}

/* The axis of coordinate 1 = x, 2 = y, ...; 0 is the weight. */
static ix_status arg_axis(ix_call *c, int i, const ix_mv *m, int *axis)
{
    int lo = m->rational ? 0 : 1, a;

    IX_TRY(ix__arg_int(c, i, lo, m->ncoords, &a));
    *axis = m->rational ? a : a - 1;
    return IX_OK;
}

/* Bezier form of a power basis curve; new reference. */
static ix_status no_power(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    if (m->dirs[0].basis == IX_POWER)
        return ix_mv_power_to_bezier(ctx, m, out);
    *out = ix_mv_ref(m);
    return IX_OK;
}

static ix_status czeros(ix_call *c)
{
    ix_mv *f;
    ix_status st;
    int axis;

    IX_TRY(arg_axis(c, 2, ix__arg_mv(c, 0), &axis));
    IX_TRY(no_power(c->ctx, ix__arg_mv(c, 0), &f));
    st = root_list(c, f, axis);
    ix_mv_unref(c->ctx, f);
    return st;
}

static ix_status cextremes(ix_call *c)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    ix_mv *f, *d;
    ix_status st;
    int axis;

    IX_TRY(arg_axis(c, 2, m, &axis));
    IX_TRY(no_power(c->ctx, m, &f));
    /* the weight by itself, every other coordinate as a fraction */
    if (m->rational && axis == 0)
        st = ix_sym_derive_axes(c->ctx, f, 0, &d);
    else
        st = ix_sym_derive(c->ctx, f, 0, NULL, &d);
    ix_mv_unref(c->ctx, f);
    IX_TRY(st);
    st = root_list(c, d, axis);
    ix_mv_unref(c->ctx, d);
    return st;
}

/* --- systems
 * ---------------------------------------------------------------------- */

/* The scalar multivariates of a list as equations, in scratch. */
static ix_status arg_equations(ix_call *c, int i, int *n, ix_equation **out)
{
    const ix_mv **mv;
    ix_equation *eq;

    IX_TRY(ix__arg_mvs(c, i, IX_OBJ_UNDEF, n, &mv));
    if (*n < 1)
        return IX_ARG_FAIL(c, i,
                           "an empty list; at least one equation is "
                           "wanted");
    IX_SCRATCH(c->ctx, eq, *n);
    for (int k = 0; k < *n; k++) {
        if (mv[k]->ncoords != 1)
            return IX_ARG_FAIL(c, i,
                               "equation %d has %d coordinates, one "
                               "(E1 or P1) is wanted",
                               k + 1, mv[k]->ncoords);
        eq[k] = (ix_equation){
            .f = mv[k], .axis = mv[k]->rational, .rel = IX_EQUAL_ZERO};
    }
    *out = eq;
    return IX_OK;
}

static ix_obj *solution_object(ix_ctx *ctx, const ix_solution *s, int n)
{
    ix_ctlpt p = {.ncoords = n};
    ix_obj *o;

    memcpy(p.v, s->x, (size_t)n * sizeof *p.v);
    o = ix__obj_ctlpt(ctx, &p);
    if (!o)
        return NULL;
    if (ix__attr_set_real(ctx, &o->attrs, "RngError", s->residual) == IX_OK &&
        ix__attr_set_int(ctx, &o->attrs, "SingleSol", s->certified) == IX_OK)
        return o;
    ix__obj_unref(ctx, o);
    return NULL;
}

static ix_status solution_list(ix_call *c, const ix_solutions *s)
{
    ix_obj *list = ix__obj_list(c->ctx);
    ix_status st = list ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < s->n; i++)
        st = ix__list_add(c->ctx, list,
                          solution_object(c->ctx, &s->sol[i], s->unknowns));
    return ix__ret_list(c, list, st);
}

/* What a search left open, in words for a remark; NULL: nothing. */
static const char *open_reason(bool complete, bool interrupted, bool crowded)
{
    if (interrupted)
        return "interrupted";
    if (crowded)
        return "the equations have more zeros in common than their number "
               "lets expect, or nearly";
    return complete ? NULL : "too many boxes";
}

static void remark_solutions(ix_call *c, const ix_solutions *s)
{
    const char *why = open_reason(s->complete, s->interrupted, s->crowded);
    int open = 0;

    for (int i = 0; i < s->n; i++)
        open += !s->sol[i].certified;
    if (why)
        ix__remark(c->in,
                   "stopped after %zu boxes (%s): %d open ones, with SingleSol "
                   "0, hold all other zeros",
                   s->boxes, why, open);
}

static void remark_curves(ix_call *c, const ix_solution_curves *s)
{
    const char *why = open_reason(s->complete, s->interrupted, s->crowded);

    if (why)
        ix__remark(c->in,
                   "stopped after %zu boxes (%s): curves may be missing in %d "
                   "open ones",
                   s->boxes, why, s->nsingular);
}

/* The longest edge of the domain, in whose parts the solver counts. */
static double longest_edge(const ix_mv *f)
{
    double edge = 0, dom[2];

    for (int d = 0; d < f->ndirs; d++) {
        ix_mv_domain(f, d, dom);
        edge = fmax(edge, dom[1] - dom[0]);
    }
    return edge;
}

static ix_status add_vertex(ix_call *c, ix_obj *list, const double *x, int n)
{
    ix_solution p = {.certified = true};

    memcpy(p.x, x, (size_t)n * sizeof *p.x);
    return ix__list_add(c->ctx, list, solution_object(c->ctx, &p, n));
}

/* Fewer equations by one than unknowns: the vertices of the solution curves,
 * as many as cells of the asked size would give, and points that are by
 * themselves. */
static ix_status curve_points(ix_call *c, int n, const ix_equation *eq,
                              double cell)
{
    double part = cell / longest_edge(eq[0].f);
    ix_curves_opts o = {.tol = fmin(part * part, 1e-2), .keep = true};
    ix_solution_curves s;
    ix_obj *list;
    ix_status st;

    IX_TRY(ix_solve_curves(c->ctx, n, eq, &o, &s));
    remark_curves(c, &s);
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; i < s.ncurves; i++)
        for (int k = 0; st == IX_OK && k < s.curve[i].n; k++)
            st = add_vertex(c, list,
                            s.curve[i].x + (size_t)k * (size_t)s.unknowns,
                            s.unknowns);
    for (int i = 0; st == IX_OK && i < s.nsingular; i++)
        if (s.arcs[i] == 0)
            st = ix__list_add(
                c->ctx, list,
                solution_object(c->ctx, &s.singular[i], s.unknowns));
    ix_solution_curves_free(c->ctx, &s);
    return ix__ret_list(c, list, st);
}

/* An open box wider than the size that was asked for is no point. */
static bool is_wide(const ix_solution *s, int n, double subdiv)
{
    bool wide = false;

    for (int k = 0; k < n; k++)
        wide |= s->hi[k] - s->lo[k] > subdiv;
    return wide && !s->certified;
}

/* A negative numeric tolerance: points that are not proven and miss it go. */
static void purge(ix_solutions *s, double subdiv, double numer)
{
    int k = 0;

    for (int i = 0; i < s->n; i++)
        if (s->sol[i].certified || is_wide(&s->sol[i], s->unknowns, subdiv) ||
            s->sol[i].residual <= -numer)
            s->sol[k++] = s->sol[i];
    s->n = k;
}

static void remark_wide(ix_call *c, const ix_solutions *s, double subdiv)
{
    int wide = 0;

    for (int i = 0; i < s->n; i++)
        wide += is_wide(&s->sol[i], s->unknowns, subdiv);
    if (wide && s->complete)
        ix__remark(
            c->in,
            "%d of the zeros %s an open box wider than %g: some equation "
            "holds everywhere, or nearly",
            wide, wide == 1 ? "stands for" : "stand each for", subdiv);
}

static ix_status mzero(ix_call *c)
{
    const ix_solve_opts o = {.keep = true};
    double subdiv = ix__arg_num(c, 1), numer = ix__arg_num(c, 2);
    ix_solutions s;
    ix_equation *eq;
    ix_status st;
    int n;

    IX_TRY(arg_equations(c, 0, &n, &eq));
    if (!(subdiv > 0))
        return IX_ARG_FAIL(c, 1,
                           "a subdivision size of %g; it must be "
                           "positive",
                           subdiv);
    if (n == eq[0].f->ndirs - 1)
        return curve_points(c, n, eq, subdiv);
    if (n < eq[0].f->ndirs)
        return IX_ARG_FAIL(c, 0,
                           "%d equations in %d unknowns: their zeros are not "
                           "points or curves; %d or more are wanted",
                           n, eq[0].f->ndirs, eq[0].f->ndirs - 1);
    IX_TRY(ix_solve(c->ctx, n, eq, &o, &s));
    remark_solutions(c, &s);
    remark_wide(c, &s, subdiv);
    if (numer < 0)
        purge(&s, subdiv, numer);
    st = solution_list(c, &s);
    ix_solutions_free(c->ctx, &s);
    return st;
}

/* The curves as one object of polylines; the first three parameters. */
static ix_status curves_poly(ix_call *c, const ix_solution_curves *s)
{
    ix_poly *p = ix__poly_new(c->ctx, s->ncurves);
    int dims = s->unknowns < 3 ? s->unknowns : 3;
    ix_status st = p ? IX_OK : IX_ENOMEM;

    for (int i = 0; st == IX_OK && i < s->ncurves; i++) {
        const ix_solution_curve *k = &s->curve[i];

        p->poly[i].kind = IX_POLYLINE;
        st = ix__poly_vertices(c->ctx, &p->poly[i], k->n);
        for (int v = 0; st == IX_OK && v < k->n; v++)
            memcpy(p->poly[i].v[v].p, k->x + (size_t)v * (size_t)s->unknowns,
                   (size_t)dims * sizeof(double));
    }
    if (st == IX_OK)
        return ix__ret(c, ix__obj_poly(c->ctx, p));
    if (p)
        ix__poly_unref(c->ctx, p);
    return st;
}

static ix_status munivzero(ix_call *c)
{
    ix_curves_opts o = {.keep = true};
    double step = ix__arg_num(c, 1);
    ix_solution_curves s;
    ix_equation *eq;
    ix_status st;
    int n;

    IX_TRY(arg_equations(c, 0, &n, &eq));
    if (!(step > 0))
        return IX_ARG_FAIL(c, 1, "a step of %g; it must be positive", step);
    if (n != eq[0].f->ndirs - 1)
        return IX_ARG_FAIL(c, 0,
                           "%d equations in %d unknowns: curves need %d; "
                           "MZERO finds points",
                           n, eq[0].f->ndirs, eq[0].f->ndirs - 1);
    /* chords of that length on a circle as large as the domain */
    step /= longest_edge(eq[0].f);
    o.tol = fmin(step * step / 8, 1e-2);
    IX_TRY(ix_solve_curves(c->ctx, n, eq, &o, &s));
    remark_curves(c, &s);
    st = s.ncurves ? curves_poly(c, &s) : IX_OK;
    ix_solution_curves_free(c->ctx, &s);
    return st;
}

const ix_builtin ix__builtins_solve[] = {
    {"CZEROS", "c:curve eps:num axis:num -> list",
     "All parameters where a coordinate (1 = x, 2 = y, ...; 0 the weight) is "
     "zero, exact to rounding; eps is not needed. Touching zeros, clusters, "
     "jumps and intervals carry the attribute RootKind.",
     "l = czeros(circle(vector(0, 0, 0), 1), 1e-5, 2);", czeros, 0, 9},
    {"CEXTREMES", "c:curve eps:num axis:num -> list",
     "All parameters where a coordinate is stationary (the domain's ends only "
     "where it is so there); eps is not needed.",
     "l = cextremes(circle(vector(0, 0, 0), 1), 1e-5, 2);", cextremes, 0, 9},
    {"MZERO", "mvs:list subdiv:num numer:num -> list",
     "All common zeros of scalar multivariates (of fractions: of their "
     "numerators), as control points of their parameters. SingleSol 1 marks a "
     "solution that is proven to exist and to be the only one near; RngError "
     "is the largest value of an equation there over its largest coefficient. "
     "With numer < 0, points that are not proven and have a larger RngError "
     "than that are left out. Fewer equations by one than unknowns: points of "
     "the "
     "solution curves, about subdiv apart. An interruption keeps what is "
     "found.",
     "m1 = mbezier(list(2, 2), list(ctlpt(E1, -1), ctlpt(E1, 1), "
     "ctlpt(E1, -1), ctlpt(E1, 1))); m2 = mreverse(m1, 0, 1); "
     "z = mzero(list(m1, m2), 0.01, -1e-10);",
     mzero, IX_B_SOFT, 22},
    {"MUNIVZERO", "mvs:list step:num subdiv:num numer:num -> poly",
     "The solution curves of n - 1 equations in n unknowns as polylines of "
     "their first three parameters, with chords of about step; no value if "
     "there is none. subdiv and numer are not needed. An interruption keeps "
     "what is found.",
     "f = mbezier(list(2, 2), list(ctlpt(E1, -1), ctlpt(E1, 0), "
     "ctlpt(E1, 0), ctlpt(E1, 1))); o = munivzero(list(f), 0.01, 0.01, 1e-8);",
     munivzero, IX_B_SOFT, 22},
    {0}};
