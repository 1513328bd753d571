/* trisector.c - curves equally far from three objects: the sphere that touches
 * the first two meets and touches the third, as determinants of lifts. */
#include <math.h>
#include <string.h>

#include "geom/lines.h"
#include "geom/vec3.h"
#include "iritx/ops_mbisect.h"
#include "ops/contact.h"

enum { MAX_FIELDS = 3 };

/* Two curves, then a curve or a surface. */
static ix_status order_of(ix_ctx *ctx, const ix_mv *const in[3],
                          const ix_mv *m[3])
{
    int n = 0;

    for (int pass = 1; pass <= 2; pass++)
        for (int i = 0; i < 3; i++)
            if (in[i]->ndirs == pass)
                m[n++] = in[i];
    if (n < 3 || m[1]->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG,
                       "%d, %d and %d directions: three curves, or two and a "
                       "surface are needed",
                       in[0]->ndirs, in[1]->ndirs, in[2]->ndirs);
    for (int i = 0; i < 3; i++)
        if (m[i]->ncoords < 2 || m[i]->ncoords > 3)
            return IX_FAIL(ctx, IX_EARG, "%d coordinates: 2 or 3 are needed",
                           m[i]->ncoords);
    return IX_OK;
}

static ix_status fields(ix_ctx *ctx, const ix_contacts *c, int n,
                        ix_mv *f[MAX_FIELDS])
{
    ix_contact_row rows[5] = {{0, 0}, {0, 1}, {1, 0}, {1, 1}, {2, 0}};

    for (int i = 0; i < n; i++) {
        rows[4].row = i;
        IX_TRY(ix__contact_det(ctx, c, rows, &f[i]));
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

/* The centre over three feet, and that it is one. */
static ix_status centre_at(ix_ctx *ctx, const ix_contacts *c, const double *x,
                           double p[3], bool *ok)
{
    double foot[3][3], d[3][2][3], r[9][3], h[9], e[3], mid[3], dist[3];
    int n = 0;

    for (int i = 0; i < 3; i++) {
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
    for (int i = 0; i < 3; i++)
        dist[i] = *ok ? ix__dist3(p, foot[i]) : 0.0;
    for (int i = 1; i < 3; i++)
        *ok = *ok && fabs(dist[i] - dist[0]) <= 1e-6 * (dist[i] + dist[0]);
    return IX_OK;
}

static bool in_box(const double p[3], const double box[6])
{
    for (int k = 0; k < 3; k++)
        if (!(p[k] >= box[k] && p[k] <= box[3 + k]))
            return false;
    return true;
}

/* --- polylines
 * ------------------------------------------------------------------ */

/* Vertices of all curves, and for each whether it goes on from the one before;
 * runs of one vertex are dropped. */
typedef struct {
    double (*p)[3];
    bool *joined;
    size_t n;
} trace;

static ix_status collect(ix_ctx *ctx, const ix_contacts *c,
                         const ix_solution_curves *s, const double *box,
                         trace *t)
{
    size_t total = 1;

    for (int i = 0; i < s->ncurves; i++)
        total += (size_t)s->curve[i].n;
    IX_SCRATCH(ctx, t->p, total);
    IX_SCRATCH(ctx, t->joined, total);
    t->n = 0;
    for (int i = 0; i < s->ncurves; i++) {
        bool before = false, ok;

        for (int v = 0; v < s->curve[i].n; v++) {
            const double *x = s->curve[i].x + (size_t)v * (size_t)s->unknowns;

            IX_TRY(centre_at(ctx, c, x, t->p[t->n], &ok));
            ok = ok && in_box(t->p[t->n], box);
            t->joined[t->n] = before && ok;
            t->n += ok;
            before = ok;
        }
    }
    return IX_OK;
}

static ix_status store(ix_ctx *ctx, const trace *t, ix_lines *out)
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

static ix_status run(ix_ctx *ctx, const ix_mv *const in[3], double tol,
                     const double *box, ix_lines *out, bool *complete)
{
    ix_mv *f[MAX_FIELDS] = {NULL};
    ix_equation eq[MAX_FIELDS];
    const ix_curves_opts o = {.tol = tol};
    ix_solution_curves s = {0};
    const ix_mv *m[3];
    ix_contacts c;
    trace t;
    ix_status st;
    int n;

    IX_TRY(order_of(ctx, in, m));
    IX_TRY(ix__contacts_of(ctx, 3, m, NULL, 3, &c));
    n = m[2]->ndirs + 1;
    st = fields(ctx, &c, n, f);
    for (int i = 0; i < n; i++)
        eq[i] = (ix_equation){f[i], 0, IX_EQUAL_ZERO};
    if (st == IX_OK)
        st = ix_solve_curves(ctx, n, eq, &o, &s);
    for (int i = 0; i < n; i++)
        ix_mv_unref(ctx, f[i]);
    *complete = s.complete;
    if (st == IX_OK)
        st = collect(ctx, &c, &s, box, &t);
    if (st == IX_OK)
        st = store(ctx, &t, out);
    ix_solution_curves_free(ctx, &s);
    return st;
}

ix_status ix_trisector(ix_ctx *ctx, const ix_mv *const m[3], double tol,
                       const double box[6], ix_lines *out, bool *complete)
{
    *out = (ix_lines){.n = 0};
    *complete = false;
    for (int k = 0; k < 3; k++)
        if (!(box[k] < box[3 + k]))
            return IX_FAIL(ctx, IX_EARG, "an empty box: %g to %g in axis %d",
                           box[k], box[3 + k], k + 1);
    IX_RETURN_SCOPED(ctx, run(ctx, m, tol, box, out, complete));
}
