/* skeleton_nd.c - points of R^n equally far from n + 1 objects.
 *
 * A sphere (a, b, e) of R^n has n + 2 coefficients. Of all rows of contact (its
 * lift for a point, and the derivatives of the lift for what it touches) n + 1
 * determine it; each further one is an equation, as many as there are unknown
 * parameters. Where the first n + 1 rows are dependent, all equations hold
 * without a sphere (two objects have a point in common): the same equations
 * with the last n + 1 rows as the base leave most of that out. */
#include <math.h>
#include <string.h>

#include "iritx/ops_mbisect.h"
#include "ops/contact.h"
#include "solve/small.h"

enum { N = IX__MAX_OBJECTS, D = N - 1, MAX_ROWS = N + IX_MAX_UNKNOWNS };

typedef struct {
    int n, dim;
    const ix_mv *m[N]; /* points first */
    double q[N * D];
    int points, order[N]; /* where the user has them */
    ix_contacts c;
    ix_centre *found;
    int count;
} task;

/* --- equations --------------------------------------------------------------
 */

static int rows_of(const ix_contacts *c, ix_contact_row rows[MAX_ROWS])
{
    int n = 0;

    for (int i = 0; i < c->n; i++)
        for (int r = 0; r < c->at[i].nrows; r++)
            rows[n++] = (ix_contact_row){i, r};
    return n;
}

/* One for each row beside the base, which are n rows from first on. */
static ix_status fields(ix_ctx *ctx, const task *k, int first, ix_mv **f)
{
    ix_contact_row all[MAX_ROWS], rows[N + 1];
    int total = rows_of(&k->c, all), n = 0;

    memcpy(rows, all + first, (size_t)k->n * sizeof *rows);
    for (int i = 0; i < total; i++) {
        if (i >= first && i < first + k->n)
            continue;
        rows[k->n] = all[i];
        IX_TRY(ix__contact_det(ctx, &k->c, rows, &f[n++]));
    }
    return IX_OK;
}

/* --- centres ----------------------------------------------------------------
 */

typedef struct {
    double x[N][D], d[N][2][D];
} feet;

/* Value and derivatives of object i at t, by the quotient rule; false at a
 * pole. */
static ix_status foot_of(ix_ctx *ctx, const ix_mv *m, const double *t, int dim,
                         double *x, double (*d)[D], bool *ok)
{
    double h[3][IX_MAX_COORDS + 1], w[3] = {1, 0, 0};
    int r = m->rational;

    for (int j = 0; j <= m->ndirs; j++) {
        int order[2] = {j == 1, j == 2};

        IX_TRY(ix_mv_partial(ctx, m, t, order, h[j]));
        if (r)
            w[j] = h[j][0];
    }
    *ok = w[0] != 0.0;
    for (int a = 0; a < dim && *ok; a++) {
        x[a] = h[0][a + r] / w[0];
        for (int j = 0; j < m->ndirs; j++)
            d[j][a] = (h[j + 1][a + r] - x[a] * w[j + 1]) / w[0];
    }
    return IX_OK;
}

static ix_status feet_at(ix_ctx *ctx, const task *k, const double *x,
                         ix_centre *p, feet *f, bool *ok)
{
    *ok = true;
    for (int i = 0; i < k->n && *ok; i++) {
        const ix_contact *c = &k->c.at[i];
        double *t = p->t[k->order[i]];

        if (!k->m[i]) {
            memcpy(f->x[i], k->q + i * k->dim, (size_t)k->dim * sizeof(double));
            continue;
        }
        for (int j = 0; j < k->m[i]->ndirs; j++)
            t[j] = fmin(fmax(c->dom[j][0] + x[c->start + j] *
                                                (c->dom[j][1] - c->dom[j][0]),
                             c->dom[j][0]),
                        c->dom[j][1]);
        IX_TRY(foot_of(ctx, k->m[i], t, k->dim, f->x[i], f->d[i], ok));
    }
    return IX_OK;
}

static double dot(int n, const double *a, const double *b)
{
    double s = 0.0;

    for (int i = 0; i < n; i++)
        s += a[i] * b[i];
    return s;
}

static double distance(int n, const double *a, const double *b)
{
    double s = 0.0;

    for (int i = 0; i < n; i++)
        s += (a[i] - b[i]) * (a[i] - b[i]);
    return sqrt(s);
}

/* Planes r.x = h, r of length 1, h as seen from the first foot. */
typedef struct {
    int n;
    double r[3 * N][D], h[3 * N];
} planes;

static void add_plane(planes *p, int dim, const double *normal, double h)
{
    double len = sqrt(dot(dim, normal, normal));

    if (!(len > 0.0))
        return;
    for (int a = 0; a < dim; a++)
        p->r[p->n][a] = normal[a] / len;
    p->h[p->n++] = h / len;
}

/* At right angles to the objects, and halfway between the feet. */
static void planes_of(const task *k, const feet *f, planes *p)
{
    p->n = 0;
    for (int i = 0; i < k->n; i++) {
        double e[D];

        for (int a = 0; a < k->dim; a++)
            e[a] = f->x[i][a] - f->x[0][a];
        add_plane(p, k->dim, e, 0.5 * dot(k->dim, e, e));
        for (int j = 0; k->m[i] && j < k->m[i]->ndirs; j++)
            add_plane(p, k->dim, f->d[i][j], dot(k->dim, f->d[i][j], e));
    }
}

/* The point next to all planes (least squares, and once more with what is
 * left); false if they have more than a point in common. */
static bool meet(int dim, const planes *p, double *x)
{
    ix__mat m = {{0}}, inv;
    double g[D];

    for (int i = 0; i < p->n; i++)
        for (int a = 0; a < dim; a++)
            for (int b = 0; b < dim; b++)
                m[a][b] += p->r[i][a] * p->r[i][b];
    if (!ix__small_invert(dim, m, inv))
        return false;
    memset(x, 0, (size_t)dim * sizeof *x);
    for (int pass = 0; pass < 2; pass++) {
        memset(g, 0, sizeof g);
        for (int i = 0; i < p->n; i++)
            for (int a = 0; a < dim; a++)
                g[a] += p->r[i][a] * (p->h[i] - dot(dim, p->r[i], x));
        for (int a = 0; a < dim; a++)
            x[a] += dot(dim, inv[a], g);
    }
    return true;
}

/* Relative to the radius: half of the digits. */
#define EQUAL 1e-7

static bool holds(const task *k, const feet *f, const ix_centre *p)
{
    for (int i = 0; i < k->n; i++) {
        double e[D], r;

        for (int a = 0; a < k->dim; a++)
            e[a] = p->x[a] - f->x[i][a];
        r = sqrt(dot(k->dim, e, e));
        if (!(fabs(r - p->radius) <= EQUAL * p->radius))
            return false;
        for (int j = 0; k->m[i] && j < k->m[i]->ndirs; j++) {
            const double *d = f->d[i][j];

            if (!(fabs(dot(k->dim, d, e)) <=
                  EQUAL * r * sqrt(dot(k->dim, d, d))))
                return false;
        }
    }
    return p->radius > 0.0;
}

/* The seam of a closed curve comes twice: the same centre and feet. */
static bool is_new(const task *k, const ix_centre *p, const feet *f,
                   const feet *all)
{
    for (int i = 0; i < k->count; i++) {
        const ix_centre *o = &k->found[i];
        double gap = distance(k->dim, p->x, o->x);

        for (int j = 0; j < k->n; j++)
            gap = fmax(gap, distance(k->dim, f->x[j], all[i].x[j]));
        if (gap <= EQUAL * (p->radius + o->radius))
            return false;
    }
    return true;
}

static ix_status add(ix_ctx *ctx, task *k, const double *x, feet *all)
{
    ix_centre *p = &k->found[k->count];
    feet *f = &all[k->count];
    planes pl;
    bool ok;

    memset(p, 0, sizeof *p);
    IX_TRY(feet_at(ctx, k, x, p, f, &ok));
    if (!ok)
        return IX_OK;
    planes_of(k, f, &pl);
    if (!meet(k->dim, &pl, p->x))
        return IX_OK;
    p->radius = sqrt(dot(k->dim, p->x, p->x));
    for (int a = 0; a < k->dim; a++)
        p->x[a] += f->x[0][a];
    k->count += holds(k, f, p) && is_new(k, p, f, all);
    return IX_OK;
}

/* --- solving ----------------------------------------------------------------
 */

static ix_status room(ix_ctx *ctx, task *k, int n, feet **all)
{
    IX_SCRATCH(ctx, k->found, (size_t)n + 1);
    IX_SCRATCH(ctx, *all, (size_t)n + 1);
    return IX_OK;
}

#define MAX_BOXES 1000000

static ix_status solutions(ix_ctx *ctx, task *k, ix_mv *const *f, int n,
                           bool *complete)
{
    const ix_solve_opts o = {.max_boxes = MAX_BOXES};
    ix_equation eq[2 * IX_MAX_UNKNOWNS];
    ix_solutions s;
    ix_status st;
    feet *all;

    for (int i = 0; i < 2 * n; i++)
        eq[i] = (ix_equation){f[i], 0, IX_EQUAL_ZERO};
    IX_TRY(ix_solve(ctx, 2 * n, eq, &o, &s));
    *complete = s.complete;
    st = room(ctx, k, s.n, &all);
    for (int i = 0; i < s.n && st == IX_OK; i++)
        st = add(ctx, k, s.sol[i].x, all);
    ix_solutions_free(ctx, &s);
    return st;
}

static ix_status solve(ix_ctx *ctx, task *k, bool *complete)
{
    ix_mv *f[2 * IX_MAX_UNKNOWNS] = {NULL};
    int n = k->c.nvars;
    ix_status st = fields(ctx, k, 0, f);

    if (st == IX_OK)
        st = fields(ctx, k, n, f + n);
    if (st == IX_OK)
        st = solutions(ctx, k, f, n, complete);
    for (int i = 0; i < 2 * n; i++)
        ix_mv_unref(ctx, f[i]);
    return st;
}

/* --- entry ------------------------------------------------------------------
 */

static ix_status check(ix_ctx *ctx, int n, const ix_mv *const *m)
{
    int unknowns = 0;

    if (n < 3 || n > N)
        return IX_FAIL(ctx, IX_EARG, "%d objects are not 3 .. %d", n, N);
    for (int i = 0; i < n; i++) {
        if (!m[i])
            continue;
        if (m[i]->ndirs < 1 || m[i]->ndirs > 2 || m[i]->ncoords != n - 1)
            return IX_FAIL(ctx, IX_EARG,
                           "object %d has %d directions and %d coordinates: "
                           "%d objects are points, curves and surfaces of R^%d",
                           i + 1, m[i]->ndirs, m[i]->ncoords, n, n - 1);
        unknowns += m[i]->ndirs;
    }
    if (unknowns > IX_MAX_UNKNOWNS)
        return IX_FAIL(ctx, IX_EARG,
                       "%d parameters of all objects; at most %d can be solved "
                       "for",
                       unknowns, IX_MAX_UNKNOWNS);
    return IX_OK;
}

/* Points, curves, surfaces. */
static void sort(task *k, const ix_mv *const *m, const double *q)
{
    int n = 0;

    for (int pass = 0; pass <= 2; pass++)
        for (int i = 0; i < k->n; i++) {
            if ((m[i] ? m[i]->ndirs : 0) != pass)
                continue;
            k->m[n] = m[i];
            if (!m[i])
                memcpy(k->q + n * k->dim, q + i * k->dim,
                       (size_t)k->dim * sizeof *q);
            k->points += !m[i];
            k->order[n++] = i;
        }
}

static ix_status run(ix_ctx *ctx, task *k, ix_centre **out, bool *complete)
{
    const double none = 0.0;
    feet *all;

    if (k->points == k->n) {
        IX_TRY(room(ctx, k, 1, &all));
        IX_TRY(add(ctx, k, &none, all));
    } else {
        IX_TRY(ix__contacts_of(ctx, k->n, k->m, k->q, k->dim, &k->c));
        IX_TRY(solve(ctx, k, complete));
    }
    if (k->count == 0)
        return IX_OK;
    *out = ix__alloc(ctx, (size_t)k->count * sizeof **out);
    if (!*out)
        return IX_ENOMEM;
    memcpy(*out, k->found, (size_t)k->count * sizeof **out);
    return IX_OK;
}

ix_status ix_equidistant_centres(ix_ctx *ctx, int n, const ix_mv *const *m,
                                 const double *q, ix_centre **out, int *count,
                                 bool *complete)
{
    task k = {.n = n, .dim = n - 1};
    ix_mark mk;
    ix_status st;

    *out = NULL;
    *count = 0;
    *complete = true;
    IX_TRY(check(ctx, n, m));
    mk = ix__scratch_mark(ctx);
    sort(&k, m, q);
    st = run(ctx, &k, out, complete);
    ix__scratch_release(ctx, mk);
    if (st == IX_OK)
        *count = k.count;
    return st;
}

void ix_centres_free(ix_ctx *ctx, ix_centre *p, int n)
{
    ix__free(ctx, p, (size_t)n * sizeof *p);
}
