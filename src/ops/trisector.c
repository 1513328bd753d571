/* trisector.c - curves equally far from three objects: the sphere that passes
 * through the points, touches the curves and meets and touches the surface, as
 * determinants of lifts. With two surfaces the equations hold wherever these
 * meet, a set of more dimensions: then the curves are followed from points. */
#include <math.h>
#include <string.h>

#include "geom/lines.h"
#include "geom/vec3.h"
#include "iritx/ops_mbisect.h"
#include "ops/contact.h"
#include "ops/trisector.h"

enum { MAX_FIELDS = 3, BASE = 4, MAX_ROWS = BASE + MAX_FIELDS };

typedef struct {
    const ix_mv *m[3]; /* points, curves, surfaces */
    int points, surfaces;
    double q[3][3]; /* the points */
    const double *box;
    double tol;
} task;

static int rank_of(const ix_mv *m)
{
    return ix__is_point(m) ? 0 : m->ndirs;
}

/* Points before curves before surfaces. */
static ix_status order_of(ix_ctx *ctx, const ix_mv *const in[3], task *k)
{
    int n = 0;

    for (int i = 0; i < 3; i++)
        if (in[i]->ndirs < 1 || in[i]->ndirs > 2 || in[i]->ncoords < 2 ||
            in[i]->ncoords > 3)
            return IX_FAIL(ctx, IX_EARG,
                           "operand %d has %d directions and %d coordinates: a "
                           "point, curve or surface with 2 or 3 is needed",
                           i + 1, in[i]->ndirs, in[i]->ncoords);
    for (int pass = 0; pass <= 2; pass++)
        for (int i = 0; i < 3; i++)
            if (rank_of(in[i]) == pass)
                k->m[n++] = in[i];
    for (int i = 0; i < 3; i++) {
        double dom[2];

        k->points += rank_of(k->m[i]) == 0;
        k->surfaces += rank_of(k->m[i]) == 2;
        if (rank_of(k->m[i]) > 0)
            continue;
        ix_mv_domain(k->m[i], 0, dom);
        IX_TRY(ix_mv_point(ctx, k->m[i], dom, k->q[i]));
    }
    return IX_OK;
}

/* All rows of contact. BASE of them are in each equation, and one of the
 * others. Where the base is dependent all equations hold without a sphere: a
 * base of the last rows too leaves most of that out. */
static int rows_of(const ix_contacts *c, ix_contact_row rows[MAX_ROWS])
{
    int n = 0;

    for (int i = 0; i < 3; i++)
        for (int r = 0; r < c->at[i].nrows; r++)
            rows[n++] = (ix_contact_row){i, r};
    return n;
}

/* One equation for each row beside the base, BASE rows from first on. */
static ix_status fields(ix_ctx *ctx, const ix_contacts *c, int first, ix_mv **f)
{
    ix_contact_row rows[MAX_ROWS], five[BASE + 1];
    int total = rows_of(c, rows), n = 0;

    memcpy(five, rows + first, BASE * sizeof *five);
    for (int i = 0; i < total; i++) {
        if (i >= first && i < first + BASE)
            continue;
        five[BASE] = rows[i];
        IX_TRY(ix__contact_det(ctx, c, five, &f[n++]));
    }
    return IX_OK;
}

/* --- points
 * ------------------------------------------------------------------- */

static void add_plane(const double *d, const double *at, double (*r)[3],
                      double *h, int *n)
{
    if (!(ix__unit3(d, r[*n]) > 0))
        return;
    h[*n] = ix__dot3(r[*n], at);
    ++*n;
}

/* Of distances, relative; what solves the equations otherwise, where the base
 * is dependent, is far from it. */
#define EQUAL 1e-6

/* The centre over three feet, and that it is one. */
static ix_status centre_at(ix_ctx *ctx, const task *t, const ix_contacts *c,
                           const double *x, double p[3], bool *ok)
{
    double foot[3][3], d[3][2][3] = {{{0}}}, r[9][3] = {{0}}, h[9];
    double e[3], mid[3], dist[3];
    int n = 0;

    *ok = true;
    for (int i = 0; i < 3; i++) {
        memcpy(foot[i], t->q[i], sizeof foot[i]);
        if (c->at[i].m)
            IX_TRY(ix__contact_foot(ctx, c, i, x, foot[i], d[i], ok));
        if (!*ok)
            return IX_OK;
        for (int k = 0; k < 2; k++)
            add_plane(d[i][k], foot[i], r, h, &n);
    }
    for (int i = 0; i < 3; i++) {
        const double *next = foot[(i + 1) % 3];

        ix__sub3(next, foot[i], e);
        ix__axpy3(foot[i], 0.5, e, mid);
        add_plane(e, mid, r, h, &n);
    }
    *ok = ix__meet_planes(3, n, r, h, p);
    for (int i = 0; i < 3 && *ok; i++) {
        dist[i] = ix__dist3(p, foot[i]);
        *ok = fabs(dist[i] - dist[0]) <= EQUAL * (dist[i] + dist[0]);
        ix__sub3(p, foot[i], e);
        for (int k = 0; k < 2; k++)
            *ok = *ok && fabs(ix__dot3(e, d[i][k])) <=
                             EQUAL * dist[i] * ix__len3(d[i][k]);
    }
    return IX_OK;
}

/* --- polylines
 * ------------------------------------------------------------------ */

ix_status ix__trace_add(ix_ctx *ctx, ix__trace *t, const double p[3],
                        bool joined)
{
    if (t->n == t->cap) {
        size_t cap = t->cap ? 2 * t->cap : 256;
        bool *flags;
        double(*more)[3];

        IX_SCRATCH(ctx, more, cap);
        IX_SCRATCH(ctx, flags, cap);
        if (t->n > 0) {
            memcpy(more, t->p, t->n * sizeof *more);
            memcpy(flags, t->joined, t->n * sizeof *flags);
        }
        t->p = more;
        t->joined = flags;
        t->cap = cap;
    }
    memcpy(t->p[t->n], p, sizeof *t->p);
    t->joined[t->n++] = joined;
    return IX_OK;
}

/* The centre over the parameters x, if it is one and in the box. */
static ix_status add_centre(ix_ctx *ctx, const task *k, const ix_contacts *c,
                            const double *x, ix__trace *t, bool *before)
{
    double p[3];
    bool ok;

    IX_TRY(centre_at(ctx, k, c, x, p, &ok));
    ok = ok && ix__in_box(p, k->box);
    if (ok)
        IX_TRY(ix__trace_add(ctx, t, p, *before));
    *before = ok;
    return IX_OK;
}

/* Runs of one vertex are dropped. */
static ix_status store(ix_ctx *ctx, const ix__trace *t, ix_lines *out)
{
    size_t at = 0;

    IX_TRY(ix__lines_new(ctx, t->n, out));
    for (size_t i = 0; i < t->n; i++) {
        bool starts = !t->joined[i] && i + 1 < t->n && t->joined[i + 1];

        if (starts)
            out->count[out->n++] = 0;
        if (!starts && !t->joined[i])
            continue;
        memcpy(out->pt[at++], t->p[i], sizeof t->p[i]);
        out->count[out->n - 1]++;
    }
    return IX_OK;
}

/* --- which ------------------------------------------------------------------
 */

/* The line of three points' circles, from one side of the box to the other. */
static ix_status three_points(ix_ctx *ctx, const task *k, ix__trace *t)
{
    double r[2][3] = {{0}}, h[2], e[3], mid[3], u[3], p[3], lo = -HUGE_VAL,
           hi = HUGE_VAL, rows[3][3], at[3];

    for (int i = 0; i < 2; i++) {
        ix__sub3(k->q[i + 1], k->q[0], e);
        if (!(ix__unit3(e, r[i]) > 0))
            return IX_FAIL(ctx, IX_EDOMAIN, "two of the points are one");
        ix__axpy3(k->q[0], 0.5, e, mid);
        h[i] = ix__dot3(r[i], mid);
    }
    ix__cross3(r[0], r[1], u);
    if (!(ix__unit3(u, u) > 1e-9))
        return IX_OK; /* on one line: there is no circle */
    memcpy(rows, r, sizeof r);
    memcpy(rows[2], u, sizeof u);
    at[0] = h[0];
    at[1] = h[1];
    at[2] = ix__dot3(u, k->q[0]);
    if (!ix__meet_planes(3, 3, rows, at, p))
        return IX_OK;
    for (int i = 0; i < 3; i++) {
        double a = (k->box[i] - p[i]) / u[i], b = (k->box[3 + i] - p[i]) / u[i];

        if (u[i] == 0.0 && !(p[i] >= k->box[i] && p[i] <= k->box[3 + i]))
            return IX_OK;
        if (u[i] == 0.0)
            continue;
        lo = fmax(lo, fmin(a, b));
        hi = fmin(hi, fmax(a, b));
    }
    for (int i = 0; i < 2 && lo < hi; i++) {
        ix__axpy3(p, i ? hi : lo, u, e);
        IX_TRY(ix__trace_add(ctx, t, e, i == 1));
    }
    return IX_OK;
}

/* Two points and a curve: one centre for each of its parameters. */
static ix_status sampled(ix_ctx *ctx, const task *k, const ix_contacts *c,
                         ix__trace *t)
{
    double step = sqrt(k->tol);
    int n = step > 1e-4 ? (int)ceil(1.0 / step) : 10000;
    bool before = false;

    for (int i = 0; i <= n; i++) {
        double x = (double)i / n;

        IX_TRY(add_centre(ctx, k, c, &x, t, &before));
    }
    return IX_OK;
}

/* With a surface there is another way. */
#define SOME_BOXES 1000

static ix_status solved(ix_ctx *ctx, const task *k, const ix_contacts *c, int n,
                        ix__trace *t, bool *complete)
{
    const ix_curves_opts o = {
        .tol = k->tol, .checks = n, .max_boxes = k->surfaces ? SOME_BOXES : 0};
    ix_mv *f[2 * MAX_FIELDS] = {NULL};
    ix_equation eq[2 * MAX_FIELDS];
    ix_solution_curves s = {0};
    ix_status st = fields(ctx, c, 0, f);

    if (st == IX_OK)
        st = fields(ctx, c, n, f + n);
    for (int i = 0; i < 2 * n; i++)
        eq[i] = (ix_equation){f[i], 0, IX_EQUAL_ZERO};
    if (st == IX_OK)
        st = ix_solve_curves(ctx, 2 * n, eq, &o, &s);
    for (int i = 0; i < 2 * n; i++)
        ix_mv_unref(ctx, f[i]);
    *complete = s.complete;
    for (int i = 0; i < s.ncurves && st == IX_OK; i++) {
        bool before = false;

        for (int v = 0; v < s.curve[i].n && st == IX_OK; v++)
            st = add_centre(ctx, k, c,
                            s.curve[i].x + (size_t)v * (size_t)s.unknowns, t,
                            &before);
    }
    ix_solution_curves_free(ctx, &s);
    return st;
}

/* The curves across a grid on the last operand, a surface. */
static ix_status walked(ix_ctx *ctx, const task *k, ix__trace *t,
                        bool *complete)
{
    const ix_mv *last_first[3] = {k->m[2], k->m[1], k->m[0]};

    *complete = true;
    t->n = 0;
    return ix__trisector_walk(ctx, last_first, sqrt(k->tol), k->box, t);
}

static ix_status trace(ix_ctx *ctx, const task *k, ix__trace *t, bool *complete)
{
    const ix_mv *in[3];
    ix_contact_row rows[MAX_ROWS];
    ix_contacts c;
    int n;

    *complete = true;
    if (k->points == 3)
        return three_points(ctx, k, t);
    if (k->surfaces >= 2)
        return walked(ctx, k, t, complete);
    for (int i = 0; i < 3; i++)
        in[i] = i < k->points ? NULL : k->m[i];
    IX_TRY(ix__contacts_of(ctx, 3, in, k->q[0], 3, &c));
    n = rows_of(&c, rows) - BASE;
    if (n == 0)
        return sampled(ctx, k, &c, t);
    IX_TRY(solved(ctx, k, &c, n, t, complete));
    return *complete || k->surfaces == 0 ? IX_OK : walked(ctx, k, t, complete);
}

static ix_status run(ix_ctx *ctx, const ix_mv *const in[3], double tol,
                     const double *box, ix_lines *out, bool *complete)
{
    task k = {.box = box, .tol = tol > 0.0 ? tol : 1e-4};
    ix__trace t = {.n = 0};

    IX_TRY(order_of(ctx, in, &k));
    IX_TRY(trace(ctx, &k, &t, complete));
    return store(ctx, &t, out);
}

ix_status ix_trisector(ix_ctx *ctx, const ix_mv *const m[3], double tol,
                       const double box[6], ix_lines *out, bool *complete)
{
    *out = (ix_lines){.n = 0};
    *complete = false;
    if (!(tol >= 0.0))
        return IX_FAIL(ctx, IX_EARG, "a tolerance of %g", tol);
    for (int k = 0; k < 3; k++)
        if (!(box[k] < box[3 + k]))
            return IX_FAIL(ctx, IX_EARG, "an empty box: %g to %g in axis %d",
                           box[k], box[3 + k], k + 1);
    IX_RETURN_SCOPED(ctx, run(ctx, m, tol, box, out, complete));
}
