/* srf_region.c - the part of a surface's domain in which a field is positive.
 *
 * Its boundary consists of the arcs on which the field vanishes and of the
 * parts of the domain's boundary on which it is positive. Around every end of
 * an arc, node or not, an even number of these meet, so that they can be walked
 * as closed loops; which loops is of no matter, as regions are filled by
 * parity. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "geom/lines.h"
#include "iritx/contour.h"
#include "mv/mv.h"

#define TIE 1e-9 /* of the perimeter: ends of arcs that are one point */

typedef struct {
    int v[2]; /* vertices at its ends */
    int n;
    const double *x; /* [n][2] */
    bool used;
} edge;

typedef struct {
    ix_ctx *ctx;
    const ix_mv *f;
    double dom[2][2];
    const ix_solution_curves *s;
    double *at; /* positions 0 .. 4 of the ends around the domain, sorted */
    int nat;
    edge *e;
    int ne;
} region;

/* --- around the domain -----------------------------------------------------
 */

/* Position of a boundary point: side, and part of it, counter-clockwise. */
static double position(const region *r, const double *x)
{
    double t[2], d[4];
    int side = 0;

    for (int k = 0; k < 2; k++)
        t[k] = (x[k] - r->dom[k][0]) / (r->dom[k][1] - r->dom[k][0]);
    d[0] = t[1];
    d[1] = 1 - t[0];
    d[2] = 1 - t[1];
    d[3] = t[0];
    for (int k = 1; k < 4; k++)
        if (fabs(d[k]) < fabs(d[side]))
            side = k;
    return fmod(side + (side == 0   ? t[0]
                        : side == 1 ? t[1]
                        : side == 2 ? 1 - t[0]
                                    : 1 - t[1]),
                4);
}

/* The point at a position, `in` of the domain inside. */
static void point_at(const region *r, double pos, double in, double *x)
{
    int side = (int)floor(pos) % 4;
    double p = pos - floor(pos), t[2];

    t[0] = side == 0 ? p : side == 1 ? 1 - in : side == 2 ? 1 - p : in;
    t[1] = side == 0 ? in : side == 1 ? p : side == 2 ? 1 - in : 1 - p;
    for (int k = 0; k < 2; k++)
        x[k] = t[k] >= 1 ? r->dom[k][1]
                         : r->dom[k][0] + t[k] * (r->dom[k][1] - r->dom[k][0]);
}

/* Is f positive beside the boundary from a to b? It has one sign there, but may
 * touch zero. */
static ix_status wanted(const region *r, double a, double b, bool *out)
{
    static const double part[] = {0.5, 0.37, 0.71};
    double x[2], v[2], most = 0;

    for (int i = 0; i < 3; i++) {
        double f;

        point_at(r, a + part[i] * (b - a), 1e-7, x);
        IX_TRY(ix_mv_eval(r->ctx, r->f, x, v));
        f = v[r->f->rational];
        most = fabs(f) > fabs(most) ? f : most;
    }
    *out = most > 0;
    return IX_OK;
}

/* --- vertices --------------------------------------------------------------
 */

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return x < y ? -1 : x > y;
}

static const double *end_of(const ix_solution_curve *c, int e)
{
    return e ? c->x + 2 * (size_t)(c->n - 1) : c->x;
}

static bool on_side(const region *r, const ix_solution_curve *c)
{
    for (int k = 0; k < 2; k++)
        for (int hi = 0; hi < 2; hi++) {
            double tie = TIE * (r->dom[k][1] - r->dom[k][0]);
            bool all = true;

            for (int i = 0; all && i < c->n; i++)
                all = fabs(c->x[2 * i + k] - r->dom[k][hi]) <= tie;
            if (all)
                return true;
        }
    return false;
}

/* Whether f has different signs at the sides of c, inside the domain. */
static bool separates(const region *r, const ix_solution_curve *c)
{
    return c->times % 2 == 1 && !on_side(r, c);
}

static ix_status load_ends(region *r)
{
    int n = 0;

    IX_SCRATCH(r->ctx, r->at, 2 * r->s->ncurves + 1);
    for (int i = 0; i < r->s->ncurves; i++) {
        const ix_solution_curve *c = &r->s->curve[i];

        for (int e = 0; e < 2 && c->start != IX_END_CLOSED; e++)
            if ((e ? c->end : c->start) == IX_END_BOUNDARY && separates(r, c))
                r->at[n++] = position(r, end_of(c, e));
    }
    qsort(r->at, (size_t)n, sizeof *r->at, ascending);
    for (int i = 0; i < n; i++)
        if (r->nat == 0 || r->at[i] - r->at[r->nat - 1] > TIE)
            r->at[r->nat++] = r->at[i];
    if (r->nat > 1 && r->at[0] + 4 - r->at[r->nat - 1] <= TIE)
        r->nat--;
    return IX_OK;
}

/* Boundary points are vertices 0 .. nat - 1, singular ones come after. */
static ix_status vertex(const region *r, const ix_solution_curve *c, int e,
                        int *out)
{
    ix_curve_end kind = e ? c->end : c->start;
    double pos = position(r, end_of(c, e));

    if (kind == IX_END_SINGULAR) {
        *out = r->nat + (e ? c->end_singular : c->start_singular);
        return IX_OK;
    }
    if (kind == IX_END_BOUNDARY)
        for (int i = 0; i < r->nat; i++) {
            double d = fabs(pos - r->at[i]);

            if (fmin(d, 4 - d) <= 2 * TIE) {
                *out = i;
                return IX_OK;
            }
        }
    return IX_FAIL(r->ctx, IX_EUNABLE,
                   "the boundary of the region ends at (%g, %g): the field "
                   "jumps or vanishes over an area",
                   end_of(c, e)[0], end_of(c, e)[1]);
}

/* --- edges -----------------------------------------------------------------
 */

static ix_status arcs(region *r)
{
    for (int i = 0; i < r->s->ncurves; i++) {
        const ix_solution_curve *c = &r->s->curve[i];
        edge *e = &r->e[r->ne];

        if (!separates(r, c))
            continue;
        *e = (edge){.v = {-1, -1}, .n = c->n, .x = c->x};
        for (int k = 0; k < 2 && c->start != IX_END_CLOSED; k++)
            IX_TRY(vertex(r, c, k, &e->v[k]));
        r->ne++;
    }
    return IX_OK;
}

/* The boundary between two positions, a < b <= a + 4, with its corners. */
static ix_status side_edge(region *r, int v0, int v1, double a, double b)
{
    double *x;
    int n = 0;

    IX_SCRATCH(r->ctx, x, 2 * 6);
    point_at(r, a, 0, x + 2 * n++);
    for (double c = floor(a) + 1; c < b - TIE; c++)
        if (c > a + TIE)
            point_at(r, c, 0, x + 2 * n++);
    point_at(r, b, 0, x + 2 * n++);
    r->e[r->ne++] = (edge){.v = {v0, v1}, .n = n, .x = x};
    return IX_OK;
}

static ix_status sides(region *r)
{
    bool in;

    if (r->nat == 0) {
        IX_TRY(wanted(r, 0, 1, &in));
        return in ? side_edge(r, -1, -1, 0, 4) : IX_OK;
    }
    for (int i = 0; i < r->nat; i++) {
        int j = (i + 1) % r->nat;
        double a = r->at[i], b = j > i ? r->at[j] : r->at[j] + 4;

        IX_TRY(wanted(r, a, b, &in));
        if (in)
            IX_TRY(side_edge(r, i, j, a, b));
    }
    return IX_OK;
}

/* --- loops -----------------------------------------------------------------
 */

static void put_edge(const edge *e, bool back, bool first, ix_lines *out)
{
    int *n = &out->count[out->n];
    double(*p)[3] = out->pt;

    for (int i = 0; i < out->n; i++)
        p += out->count[i];
    for (int i = first ? 0 : 1; i < e->n; i++) {
        const double *x = e->x + 2 * (size_t)(back ? e->n - 1 - i : i);

        p[*n][0] = x[0];
        p[*n][1] = x[1];
        p[(*n)++][2] = 0;
    }
}

/* Its last vertex becomes the first one, from which rounding parted it. */
static void close_loop(ix_lines *out)
{
    double(*p)[3] = out->pt;

    for (int i = 0; i < out->n; i++)
        p += out->count[i];
    memcpy(p[out->count[out->n] - 1], p[0], sizeof *p);
    out->n++;
}

/* An edge that is not used and leaves vertex v; *back tells its sense. */
static edge *next_edge(const region *r, int v, bool *back)
{
    for (int i = 0; i < r->ne; i++)
        for (int k = 0; k < 2; k++)
            if (!r->e[i].used && r->e[i].v[k] == v) {
                *back = k == 1;
                return &r->e[i];
            }
    return NULL;
}

static ix_status walk(region *r, edge *e, ix_lines *out)
{
    int start = e->v[0], v;
    bool back = false, first = true;

    out->count[out->n] = 0;
    do {
        e->used = true;
        put_edge(e, back, first, out);
        v = e->v[back ? 0 : 1];
        first = false;
        if (v == start)
            break;
        e = next_edge(r, v, &back);
    } while (e);
    if (v != start)
        return IX_FAIL(r->ctx, IX_EUNABLE,
                       "the boundary of the region does not close");
    close_loop(out);
    return IX_OK;
}

static ix_status loops(region *r, ix_lines *out)
{
    size_t total = 0;

    for (int i = 0; i < r->ne; i++)
        total += (size_t)r->e[i].n;
    IX_TRY(ix__lines_new(r->ctx, total, out));
    for (int i = 0; i < r->ne; i++)
        if (!r->e[i].used)
            IX_TRY(walk(r, &r->e[i], out));
    return IX_OK;
}

static ix_status find(region *r, ix_lines *out)
{
    if (!r->s->complete)
        return IX_FAIL(r->ctx, IX_EUNABLE,
                       "the curves on which the field vanishes are not known "
                       "completely");
    for (int k = 0; k < 2; k++)
        ix_mv_domain(r->f, k, r->dom[k]);
    IX_TRY(load_ends(r));
    IX_SCRATCH(r->ctx, r->e, r->s->ncurves + r->nat + 1);
    IX_TRY(arcs(r));
    IX_TRY(sides(r));
    return loops(r, out);
}

ix_status ix_positive_region(ix_ctx *ctx, const ix_mv *f, double tol,
                             ix_lines *out)
{
    const ix_equation eq = {.f = f, .axis = f->rational, .rel = IX_EQUAL_ZERO};
    const ix_curves_opts o = {.tol = tol};
    ix_solution_curves s;
    region r = {.ctx = ctx, .f = f, .s = &s};
    ix_mark mk;
    ix_status st;

    *out = (ix_lines){0};
    if (f->ndirs != 2 || f->ncoords != 1)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a scalar surface is "
                       "wanted",
                       f->ndirs, f->ncoords);
    IX_TRY(ix_solve_curves(ctx, 1, &eq, &o, &s));
    mk = ix__scratch_mark(ctx);
    st = find(&r, out);
    ix__scratch_release(ctx, mk);
    ix_solution_curves_free(ctx, &s);
    if (st != IX_OK)
        ix_lines_free(ctx, out);
    return st;
}
