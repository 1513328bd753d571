/* iso_surface.c - marching tetrahedra on a grid that has all knots among its
 * planes.
 *
 * The edges of the tetrahedra lead from a grid point p to p + e, e one of the
 * seven corners of a cube beside the first, and are numbered 7 p + e - 1. The
 * tetrahedra of a cube are the six ways from its first to its last corner. */
#include "geom/iso_surface.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "bsp/spans.h"
#include "geom/lines.h"
#include "geom/parts.h"
#include "geom/vec3.h"
#include "mv/mv.h"

#define MAX_POINTS 20000000

typedef struct {
    ix_ctx *ctx;
    const ix_mv *f;
    int n[3];         /* grid points a direction */
    double *param[3]; /* their parameters */
    double *value;    /* of f */
    int *vertex;      /* [7 points]: of an edge, or -1 */
    size_t nverts;
    double (*at)[3];
    size_t ntris;
    int (*tri)[3];
} grid;

/* --- sampling
 * ------------------------------------------------------------------ */

static ix_status parameters(grid *g, int d, int cells)
{
    ix_spans sp;
    int k = 0;

    IX_TRY(ix__spans_of(g->ctx, &g->f->dirs[d], &sp));
    if ((double)sp.nspans * cells >= MAX_POINTS)
        return IX_FAIL(g->ctx, IX_EUNABLE, "%d cells in each of %d spans",
                       cells, sp.nspans);
    g->n[d] = sp.nspans * cells + 1;
    IX_SCRATCH(g->ctx, g->param[d], g->n[d]);
    for (int s = 0; s < sp.nspans; s++)
        for (int i = 0; i < cells; i++)
            g->param[d][k++] = sp.breaks[s] +
                               (sp.breaks[s + 1] - sp.breaks[s]) * i / cells;
    g->param[d][k] = sp.breaks[sp.nspans];
    return IX_OK;
}

static ix_status sample(grid *g, const int cells[3])
{
    double points = 1;

    for (int d = 0; d < 3; d++) {
        IX_TRY(parameters(g, d, cells[d]));
        points *= g->n[d];
    }
    if (points > MAX_POINTS)
        return IX_FAIL(g->ctx, IX_EUNABLE, "a grid of %d x %d x %d points",
                       g->n[0], g->n[1], g->n[2]);
    IX_SCRATCH(g->ctx, g->value, (size_t)points);
    return ix_mv_eval_grid(g->ctx, g->f, g->n, (const double *const *)g->param,
                           g->value);
}

/* --- vertices
 * ------------------------------------------------------------------- */

static size_t point_at(const grid *g, int i, int j, int k)
{
    return (size_t)i +
           (size_t)g->n[0] * ((size_t)j + (size_t)g->n[1] * (size_t)k);
}

static void place(const grid *g, size_t p, double t[3])
{
    size_t n0 = (size_t)g->n[0], n1 = (size_t)g->n[1];

    t[0] = g->param[0][p % n0];
    t[1] = g->param[1][p / n0 % n1];
    t[2] = g->param[2][p / n0 / n1];
}

/* The grid point at corner e of the cube at p; bit d of e is a step along d. */
static size_t corner(const grid *g, size_t p, int e)
{
    size_t n0 = (size_t)g->n[0], n1 = (size_t)g->n[1];

    return p + (e & 1 ? 1 : 0) + (e & 2 ? n0 : 0) + (e & 4 ? n0 * n1 : 0);
}

static bool has_corner(const grid *g, int i, int j, int k, int e)
{
    return i + (e & 1) < g->n[0] && j + (e >> 1 & 1) < g->n[1] &&
           k + (e >> 2 & 1) < g->n[2];
}

/* Numbers the edges with both signs; 0 counts as positive. */
static ix_status find_edges(grid *g)
{
    size_t points = (size_t)g->n[0] * (size_t)g->n[1] * (size_t)g->n[2], p = 0;

    IX_SCRATCH(g->ctx, g->vertex, 7 * points);
    for (int k = 0; k < g->n[2]; k++)
        for (int j = 0; j < g->n[1]; j++)
            for (int i = 0; i < g->n[0]; i++, p++)
                for (int e = 1; e < 8; e++)
                    g->vertex[7 * p + (size_t)e - 1] =
                        has_corner(g, i, j, k, e) &&
                                (g->value[p] < 0) !=
                                    (g->value[corner(g, p, e)] < 0)
                            ? (int)g->nverts++
                            : -1;
    IX_SCRATCH(g->ctx, g->at, g->nverts);
    return IX_OK;
}

/* A root between the ends a (f < 0) and b of an edge, by the regula falsi in
 * Illinois form. */
typedef struct {
    double a[3], b[3], fa, fb, t; /* t: the last guess, from a to b */
    int side;
} bracket;

static void set_bracket(const grid *g, size_t p, int e, bracket *k)
{
    size_t q = corner(g, p, e);

    if (g->value[p] >= 0) {
        size_t s = p;

        p = q;
        q = s;
    }
    place(g, p, k->a);
    place(g, q, k->b);
    k->fa = g->value[p];
    k->fb = g->value[q];
    k->side = 0;
}

static void guess(bracket *k, double x[3])
{
    k->t = k->fa / (k->fa - k->fb);
    for (int d = 0; d < 3; d++)
        x[d] = k->a[d] + k->t * (k->b[d] - k->a[d]);
}

/* The part of the bracket with the root, f being the value at x. */
static void narrow(bracket *k, const double x[3], double f)
{
    if (f < 0) {
        memcpy(k->a, x, sizeof k->a);
        k->fa = f;
        if (k->side < 0)
            k->fb *= 0.5;
        k->side = -1;
    } else {
        memcpy(k->b, x, sizeof k->b);
        k->fb = f;
        if (k->side > 0)
            k->fa *= 0.5;
        k->side = 1;
    }
}

#define ROUNDS 40 /* for a simple root 8 are enough */

static ix_status refine(const grid *g, bracket *k, double *x)
{
    for (int round = 0; round < ROUNDS; round++) {
        double f, y[3], moved = 0;

        guess(k, y);
        for (int d = 0; d < 3; d++)
            moved = fmax(moved, fabs(y[d] - x[d]));
        memcpy(x, y, sizeof y);
        if (round > 0 && moved <= 0)
            break;
        IX_TRY(ix_mv_eval(g->ctx, g->f, y, &f));
        if (f >= 0 && f <= 0)
            break;
        narrow(k, y, f);
    }
    return IX_OK;
}

static ix_status find_vertices(grid *g)
{
    size_t points = (size_t)g->n[0] * (size_t)g->n[1] * (size_t)g->n[2];

    IX_TRY(find_edges(g));
    for (size_t p = 0; p < points; p++) {
        if (p % 4096 == 0)
            IX_TRY(ix__poll(g->ctx));
        for (int e = 1; e < 8; e++) {
            int v = g->vertex[7 * p + (size_t)e - 1];
            bracket k;

            if (v < 0)
                continue;
            set_bracket(g, p, e, &k);
            memcpy(g->at[v], k.a, sizeof k.a);
            IX_TRY(refine(g, &k, g->at[v]));
        }
    }
    return IX_OK;
}

/* --- triangles
 * ------------------------------------------------------------------ */

/* The vertex between corners a and b of the cube at p, one being a subset of
 * the other. */
static int between(const grid *g, size_t p, int a, int b)
{
    int low = a < b ? a : b;

    return g->vertex[7 * corner(g, p, low) + (size_t)(a ^ b) - 1];
}

static bool same_place(const double a[3], const double b[3])
{
    return !(a[0] < b[0] || a[0] > b[0] || a[1] < b[1] || a[1] > b[1] ||
             a[2] < b[2] || a[2] > b[2]);
}

/* Not if it has no area; turned so that `up` is on its positive side. */
static void add_triangle(grid *g, int a, int b, int c, const double up[3])
{
    double e[2][3], n[3];

    if (same_place(g->at[a], g->at[b]) || same_place(g->at[b], g->at[c]) ||
        same_place(g->at[c], g->at[a]))
        return;
    if (g->tri) {
        ix__sub3(g->at[b], g->at[a], e[0]);
        ix__sub3(g->at[c], g->at[a], e[1]);
        ix__cross3(e[0], e[1], n);
        g->tri[g->ntris][0] = a;
        g->tri[g->ntris][1] = ix__dot3(n, up) < 0 ? c : b;
        g->tri[g->ntris][2] = ix__dot3(n, up) < 0 ? b : c;
    }
    g->ntris++;
}

/* From the mean of the corners below to that of those above. */
static void upwards(const grid *g, size_t p, const int c[4], double up[3])
{
    double sum[2][3] = {{0}}, t[3];
    int count[2] = {0};

    for (int i = 0; i < 4; i++) {
        size_t q = corner(g, p, c[i]);
        int above = g->value[q] >= 0;

        place(g, q, t);
        ix__axpy3(sum[above], 1, t, sum[above]);
        count[above]++;
    }
    for (int d = 0; d < 3; d++)
        up[d] = sum[1][d] / count[1] - sum[0][d] / count[0];
}

/* One or two triangles where the corners of a tetrahedron differ in sign. */
static void tetrahedron(grid *g, size_t p, const int c[4])
{
    int low[4], high[4], nlow = 0, nhigh = 0;
    double up[3];

    for (int i = 0; i < 4; i++)
        if (g->value[corner(g, p, c[i])] < 0)
            low[nlow++] = c[i];
        else
            high[nhigh++] = c[i];
    if (nlow == 0 || nhigh == 0)
        return;
    upwards(g, p, c, up);
    if (nlow == 2) { /* a quadrilateral */
        int q[4] = {
            between(g, p, low[0], high[0]), between(g, p, low[0], high[1]),
            between(g, p, low[1], high[1]), between(g, p, low[1], high[0])};

        add_triangle(g, q[0], q[1], q[2], up);
        add_triangle(g, q[0], q[2], q[3], up);
        return;
    }
    if (nlow == 3)
        add_triangle(g, between(g, p, low[0], high[0]),
                     between(g, p, low[1], high[0]),
                     between(g, p, low[2], high[0]), up);
    else
        add_triangle(g, between(g, p, low[0], high[0]),
                     between(g, p, low[0], high[1]),
                     between(g, p, low[0], high[2]), up);
}

/* Counts them, or, with memory, keeps them. */
static void triangles(grid *g)
{
    static const int ways[6][4] = {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7},
                                   {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}};

    g->ntris = 0;
    for (int k = 0; k + 1 < g->n[2]; k++)
        for (int j = 0; j + 1 < g->n[1]; j++)
            for (int i = 0; i + 1 < g->n[0]; i++)
                for (int w = 0; w < 6; w++)
                    tetrahedron(g, point_at(g, i, j, k), ways[w]);
}

static ix_status give(grid *g, ix_lines *out)
{
    triangles(g);
    IX_SCRATCH(g->ctx, g->tri, g->ntris);
    triangles(g);
    if (g->ntris > INT_MAX / 3)
        return IX_FAIL(g->ctx, IX_EUNABLE, "%zu triangles", g->ntris);
    IX_TRY(ix__lines_new(g->ctx, 3 * g->ntris, out));
    for (size_t t = 0; t < g->ntris; t++) {
        for (int c = 0; c < 3; c++)
            memcpy(out->pt[3 * t + (size_t)c], g->at[g->tri[t][c]],
                   sizeof *out->pt);
        out->count[t] = 3;
    }
    out->n = (int)g->ntris;
    return IX_OK;
}

static ix_status build(ix_ctx *ctx, const ix_mv *f, const int cells[3],
                       ix_lines *out)
{
    grid g = {.ctx = ctx, .f = f};

    IX_TRY(sample(&g, cells));
    IX_TRY(find_vertices(&g));
    return give(&g, out);
}

ix_status ix__iso_surface(ix_ctx *ctx, const ix_mv *f, const int cells[3],
                          ix_lines *out)
{
    *out = (ix_lines){.n = 0};
    if (f->ndirs != 3 || f->ncoords != 1 || f->rational ||
        ix__mv_has_basis(f, IX_POWER))
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates%s; a polynomial "
                       "scalar of three directions is wanted",
                       f->ndirs, f->ncoords, f->rational ? ", rational" : "");
    for (int d = 0; d < 3; d++)
        if (cells[d] < 1)
            return IX_FAIL(ctx, IX_EARG, "%d cells in direction %d", cells[d],
                           d);
    IX_RETURN_SCOPED(ctx, build(ctx, f, cells, out));
}
