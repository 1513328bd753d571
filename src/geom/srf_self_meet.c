/* srf_self_meet.c - self-intersections and antipodal points of a surface.
 *
 * All pairs of patches are solved (srf_pairs.h). The curves of a patch with
 * itself come twice, as (p, q) and (q, p), of which one is kept; arcs of
 * neighbouring pairs are joined at their ends, exchanging p and q where need
 * be. */
#include <math.h>
#include <string.h>

#include "base/grow.h"
#include "geom/srf_pairs.h"
#include "iritx/distance.h"
#include "solve/box.h"

enum { CURVE_BOXES = 200000, POINT_BOXES = 20000 }; /* of one pair of patches */
enum {
    LESS = 20,      /* by which they are divided once a pair has used them up: a
                       surface with a whole family of solutions, as spheres are */
    WORK = 4000000, /* coefficients in all boxes of one pair: those of rational
                       surfaces have thousands, and take as long */
    LEAST_BOXES = 300 /* enough for what is not degenerate */
};
#define JOIN 1e-7 /* of the domain: ends of arcs that are one point */

/* --- equations -------------------------------------------------------------
 */

/* Each axis of v as an equation; *n counts on. NULL: nothing to ask. */
static void ask_vector(ix__vec v, ix_equation *eq, int *n)
{
    for (int k = 0; k < 3; k++)
        if (v.x[k])
            eq[(*n)++] = (ix_equation){.f = v.x[k], .rel = IX_EQUAL_ZERO};
}

static void ask(const ix_mv *f, ix_equation *eq, int *n)
{
    if (f)
        eq[(*n)++] = (ix_equation){.f = f, .rel = IX_EQUAL_ZERO};
}

/* --- arcs in a growing array -----------------------------------------------
 */

typedef struct {
    int n;
    double (*x)[4]; /* scratch */
    bool closed, gone;
} arc;

typedef struct {
    double tol, edge[4]; /* of the domains */
    int n, cap;
    arc *a;
    size_t boxes;
    bool complete;
} arcs;

static double apart(const arcs *s, const double *p, const double *q, bool swap)
{
    double d = 0;

    for (int k = 0; k < 4; k++)
        d = fmax(d, fabs(p[k] - q[swap ? (k + 2) % 4 : k]) / s->edge[k]);
    return d;
}

static ix_status add_arc(ix_ctx *ctx, arcs *s, int n, arc **out)
{
    IX_GROW(ctx, s->a, s->n, s->cap);
    *out = &s->a[s->n];
    **out = (arc){.n = n};
    IX_SCRATCH(ctx, (*out)->x, n);
    s->n++;
    return IX_OK;
}

static ix_status collect(ix_ctx *ctx, arcs *s, const ix__srf_pair *p,
                         const ix_solution_curves *c)
{
    for (int i = 0; i < c->ncurves; i++) {
        const ix_solution_curve *k = &c->curve[i];
        arc *a;

        IX_TRY(add_arc(ctx, s, k->n, &a));
        for (int v = 0; v < k->n; v++)
            ix__srf_pair_map(p, k->x + 4 * (size_t)v, a->x[v]);
        a->closed = k->start == IX_END_CLOSED;
    }
    return IX_OK;
}

/* How many boxes the equations of one pair may take. */
static size_t budget(size_t most, bool complete, int n, const ix_equation *eq)
{
    size_t big = 1;

    for (int i = 0; i < n; i++)
        if (eq[i].f && eq[i].f->npts > big)
            big = eq[i].f->npts;
    if (most > WORK / big)
        most = WORK / big;
    if (!complete)
        most /= LESS;
    return most < LEAST_BOXES ? LEAST_BOXES : most;
}

static ix_status meet_pair(ix_ctx *ctx, void *arg, const ix__srf_pair *p)
{
    arcs *s = arg;
    ix_curves_opts o = {.tol = s->tol};
    ix_pool q = {.ctx = ctx};
    ix_solution_curves c;
    ix_equation eq[6];
    ix_status st;
    int n = 0;

    ask_vector(ix__vec_between(&q, p->eq.p, p->eq.q), eq, &n);
    st = q.st;
    if (st == IX_OK && n < 3)
        st = IX_FAIL(ctx, IX_EDOMAIN,
                     "the surface lies in a plane: it covers itself");
    ask_vector(p->eq.off, eq, &n);
    o.checks = n - 3;
    o.max_boxes = budget(CURVE_BOXES, s->complete, n, eq);
    if (st == IX_OK)
        st = ix_solve_curves(ctx, n, eq, &o, &c);
    ix__pool_free(&q);
    IX_TRY(st);
    s->boxes += c.boxes;
    s->complete = s->complete && c.complete;
    st = collect(ctx, s, p, &c);
    ix_solution_curves_free(ctx, &c);
    return st;
}

/* --- each curve once -------------------------------------------------------
 */

/* Distance of x (p and q exchanged) from a polyline, relative. */
static double from_polyline(const arcs *s, const arc *a, const double *x)
{
    double best = HUGE_VAL;

    for (int i = 0; i + 1 < a->n; i++) {
        double len = 0, t = 0, d = 0;

        for (int k = 0; k < 4; k++) {
            double e = (a->x[i + 1][k] - a->x[i][k]) / s->edge[k];

            len += e * e;
            t += e * (x[(k + 2) % 4] - a->x[i][k]) / s->edge[k];
        }
        t = len > 0 ? fmin(fmax(t / len, 0), 1) : 0;
        for (int k = 0; k < 4; k++) {
            double e = a->x[i + 1][k] - a->x[i][k];
            double f = (x[(k + 2) % 4] - a->x[i][k] - t * e) / s->edge[k];

            d += f * f;
        }
        best = fmin(best, d);
    }
    return sqrt(best);
}

/* Arcs that are another one with p and q exchanged go. */
static void drop_twins(arcs *s)
{
    for (int i = 0; i < s->n; i++)
        for (int j = 0; j < i && !s->a[i].gone; j++) {
            const arc *a = &s->a[i], *b = &s->a[j];

            if (b->gone)
                continue;
            s->a[i].gone = true;
            for (int k = 0; s->a[i].gone && k < 3; k++)
                /* 4: both polylines leave the curve by tol */
                s->a[i].gone = from_polyline(s, b,
                                             a->x[(a->n - 1) * (k + 1) / 4]) <=
                               4 * s->tol + JOIN;
        }
}

/* A loop that passes its own exchange is cut there: the rest repeats it. */
static void halve_loops(arcs *s)
{
    for (int i = 0; i < s->n; i++) {
        arc *a = &s->a[i];

        for (int k = 1; a->closed && !a->gone && k + 1 < a->n; k++)
            if (apart(s, a->x[0], a->x[k], true) <= JOIN) {
                a->n = k + 1;
                a->closed = false;
            }
    }
}

/* --- joining ---------------------------------------------------------------
 */

static void copy_swapped(double *to, const double *from, bool swap)
{
    for (int k = 0; k < 4; k++)
        to[k] = from[swap ? (k + 2) % 4 : k];
}

/* b's end `e` is the last point of a: a goes on along b. */
static ix_status append(ix_ctx *ctx, arc *a, arc *b, int e, bool swap)
{
    double(*x)[4];
    int n = a->n;

    IX_SCRATCH(ctx, x, n + b->n - 1);
    memcpy(x, a->x, (size_t)n * sizeof *x);
    for (int i = 1; i < b->n; i++)
        copy_swapped(x[n + i - 1], b->x[e ? b->n - 1 - i : i], swap);
    a->x = x;
    a->n = n + b->n - 1;
    b->gone = true;
    return IX_OK;
}

/* The only other end at the last point of a, if exactly one is there. */
static bool partner(const arcs *s, const arc *a, int *at, int *end, bool *swap)
{
    int count = 0;

    for (int i = 0; i < s->n; i++)
        for (int e = 0; e < 4; e++) {
            const arc *b = &s->a[i];
            const double *x = b->x[e % 2 ? b->n - 1 : 0];

            if (b->gone || b->closed || (b == a && e == 1) ||
                !(apart(s, a->x[a->n - 1], x, e > 1) <= JOIN))
                continue;
            *at = i;
            *end = e % 2;
            *swap = e > 1;
            count++;
        }
    return count == 1;
}

static void turn_around(arc *a)
{
    for (int i = 0, j = a->n - 1; i < j; i++, j--) {
        double t[4];

        memcpy(t, a->x[i], sizeof t);
        memcpy(a->x[i], a->x[j], sizeof t);
        memcpy(a->x[j], t, sizeof t);
    }
}

static ix_status join(ix_ctx *ctx, arcs *s)
{
    for (int i = 0; i < s->n; i++) {
        arc *a = &s->a[i];

        for (int side = 0; side < 2 && !a->gone && !a->closed; side++) {
            int at = 0, end = 0;
            bool swap = false;

            while (!a->closed && partner(s, a, &at, &end, &swap)) {
                if (&s->a[at] == a) {
                    a->closed = end == 0 && !swap;
                    break;
                }
                IX_TRY(append(ctx, a, &s->a[at], end, swap));
            }
            turn_around(a);
        }
    }
    return IX_OK;
}

/* --- the result ------------------------------------------------------------
 */

static ix_status give_curves(ix_ctx *ctx, const arcs *s,
                             ix_solution_curves *out)
{
    size_t points = 0, n = 0;
    double(*x)[4];
    char *block;

    for (int i = 0; i < s->n; i++)
        if (!s->a[i].gone) {
            n++;
            points += (size_t)s->a[i].n;
        }
    out->unknowns = 4;
    out->boxes = s->boxes;
    out->complete = s->complete;
    if (n == 0)
        return IX_OK;
    out->bytes = n * sizeof *out->curve + points * sizeof *x;
    block = ix__alloc(ctx, out->bytes);
    if (!block) {
        out->bytes = 0;
        return IX_ENOMEM;
    }
    x = (double(*)[4])(void *)block;
    out->singular = (ix_solution *)(void *)block; /* none; starts the block */
    out->curve = (ix_solution_curve *)(void *)(x + points);
    for (int i = 0; i < s->n; i++) {
        const arc *a = &s->a[i];
        ix_curve_end end = a->closed ? IX_END_CLOSED : IX_END_OPEN;

        if (a->gone)
            continue;
        memcpy(x, a->x, (size_t)a->n * sizeof *x);
        out->curve[out->ncurves++] = (ix_solution_curve){.n = a->n,
                                                         .x = x[0],
                                                         end,
                                                         end,
                                                         .start_singular = -1,
                                                         .end_singular = -1};
        x += a->n;
    }
    return IX_OK;
}

static ix_status self_meet(ix_ctx *ctx, const ix_mv *srf, double tol,
                           ix_solution_curves *out)
{
    arcs s = {.tol = tol > 0 ? tol : 1e-4, .complete = true};
    ix__srf_walk w = {.visit = meet_pair, .arg = &s};

    for (int k = 0; k < 4 && srf->ndirs == 2; k++) {
        double dom[2];

        ix_mv_domain(srf, k % 2, dom);
        s.edge[k] = dom[1] - dom[0];
    }
    IX_TRY(ix__srf_pairs(ctx, srf, &w));
    drop_twins(&s);
    IX_TRY(join(ctx, &s));
    halve_loops(&s);
    return give_curves(ctx, &s, out);
}

ix_status ix_srf_self_meet(ix_ctx *ctx, const ix_mv *srf, double tol,
                           ix_solution_curves *out)
{
    *out = (ix_solution_curves){.unknowns = 0};
    IX_RETURN_SCOPED(ctx, self_meet(ctx, srf, tol, out));
}

/* --- antipodal points ------------------------------------------------------
 */

typedef struct {
    ix__found found;
    const ix_mv *srf;
    double size;
    size_t boxes;
    bool complete;
} feet;

static ix_status chord(ix_ctx *ctx, const feet *f, const double *x, double *len)
{
    double a[IX_MAX_COORDS] = {0}, b[IX_MAX_COORDS] = {0};

    IX_TRY(ix_mv_point(ctx, f->srf, x, a));
    IX_TRY(ix_mv_point(ctx, f->srf, x + 2, b));
    *len = 0;
    for (int k = 0; k < 3; k++)
        *len = fmax(*len, fabs(a[k] - b[k]));
    return IX_OK;
}

/* Solutions with a chord, the smaller parameters first. */
static ix_status keep(ix_ctx *ctx, feet *f, const ix__srf_pair *p,
                      const ix_solutions *s)
{
    for (int i = 0; i < s->n; i++) {
        ix_solution r = s->sol[i];
        double x[4], len;
        bool swap;

        ix__srf_pair_map(p, s->sol[i].x, x);
        IX_TRY(chord(ctx, f, x, &len));
        if (!(len > 1e-7 * f->size))
            continue;
        swap = x[0] > x[2] || (x[0] >= x[2] && x[1] > x[3]);
        copy_swapped(r.x, x, swap);
        for (int k = 0; k < 4; k++) {
            /* the box in the patches' parameters, at most that large */
            double wide = 0;

            for (int e = 0; e < 4; e++)
                wide = fmax(wide, s->sol[i].hi[e] - s->sol[i].lo[e]);
            wide *= p->hi[0][k % 2] - p->lo[0][k % 2];
            r.lo[k] = r.x[k] - wide;
            r.hi[k] = r.x[k] + wide;
        }
        IX_TRY(ix__found_add(&f->found, &r));
    }
    return IX_OK;
}

/* The chord across the tangents at both ends. What vanishes there too goes by
 * further relations: pairs of one point by `off`, which then is no tangent;
 * self-intersections, as the normals are parallel at true pairs only. */
static void antipodal_equations(ix_pool *q, const ix__srf_pair *p,
                                ix_equation *eq, int *n)
{
    ix__vec d = ix__vec_between(q, p->eq.p, p->eq.q);
    ix__vec normal = ix__vec_cross(q, p->eq.tp[0], p->eq.tp[1]);

    for (int k = 0; k < 2; k++) {
        ask(ix__vec_dot(q, d, p->eq.tp[k]), eq, n);
        ask(ix__vec_dot(q, d, p->eq.tq[k]), eq, n);
    }
    for (int k = 0; k < 2; k++)
        ask(ix__vec_dot(q, normal, p->eq.tq[k]), eq, n);
    if (p->kind != IX__PAIR_APART)
        ask(ix__vec_dot(q, normal, p->eq.off), eq, n);
}

static ix_status antipodal_pair(ix_ctx *ctx, void *arg, const ix__srf_pair *p)
{
    ix_solve_opts o = {0};
    feet *f = arg;
    ix_pool q = {.ctx = ctx};
    ix_solutions s;
    ix_equation eq[7];
    ix_status st;
    int n = 0;

    antipodal_equations(&q, p, eq, &n);
    st = q.st;
    o.max_boxes = budget(POINT_BOXES, f->complete, n, eq);
    if (st == IX_OK)
        st = ix_solve(ctx, n, eq, &o, &s);
    ix__pool_free(&q);
    IX_TRY(st);
    f->boxes += s.boxes;
    f->complete = f->complete && s.complete;
    st = keep(ctx, f, p, &s);
    ix_solutions_free(ctx, &s);
    return st;
}

static ix_status antipodal(ix_ctx *ctx, const ix_mv *srf, ix_solutions *out)
{
    feet f = {.found = {.ctx = ctx}, .srf = srf, .complete = true};
    ix__srf_walk w = {.all = true, .visit = antipodal_pair, .arg = &f};
    double edge[4];

    if (srf->ndirs == 2 && srf->ncoords > 0)
        for (size_t i = 0; i < (size_t)srf->ncoords * srf->npts; i++) {
            double wt = srf->rational ? ix_mv_weights(srf)[i % srf->npts] : 1;

            f.size = fmax(f.size, fabs(ix_mv_coord(srf, 0)[i] / wt));
        }
    IX_TRY(ix__srf_pairs(ctx, srf, &w));
    for (int k = 0; k < 4; k++)
        edge[k] = w.dom[k % 2][1] - w.dom[k % 2][0];
    IX_TRY(ix__found_merge(&f.found, 4, edge));
    out->unknowns = 4;
    out->boxes = f.boxes;
    out->complete = f.complete;
    if (f.found.n == 0)
        return IX_OK;
    out->sol = ix__alloc(ctx, (size_t)f.found.n * sizeof *out->sol);
    if (!out->sol)
        return IX_ENOMEM;
    out->bytes = (size_t)f.found.n * sizeof *out->sol;
    memcpy(out->sol, f.found.sol, out->bytes);
    out->n = f.found.n;
    return IX_OK;
}

ix_status ix_srf_antipodal(ix_ctx *ctx, const ix_mv *srf, ix_solutions *out)
{
    *out = (ix_solutions){.n = 0};
    IX_RETURN_SCOPED(ctx, antipodal(ctx, srf, out));
}
