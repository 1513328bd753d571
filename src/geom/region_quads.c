/* region_quads.c - quadrilaterals that tile a planar region.
 *
 * Points live in a list of their own, in floating point; the triangulation sees
 * them rounded to its integers, and is asked for triangles only. Corners of
 * triangles are numbered as the triangulation does; rounded() and point_of()
 * lead from one to the other. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"
#include "geom/crvs.h"
#include "geom/path.h"
#include "iritx/tile.h"
#include "mv/cdt.h"

#define MOST 1000000 /* points */

/* Where a boundary point is. */
typedef struct {
    int crv, next; /* the curve; the point after it along the curve */
    double t, t_next;
} site;

typedef struct {
    ix_ctx *ctx;
    const ix_tile_opts *o;
    double step; /* twice the size: everything is halved in the end */
    double lo[2], scale;
    int n, room;
    double (*p)[2];
    int nsites, site_room; /* the first of the points */
    site *at;
    ix__cdt d;
    int *id;           /* [points of d]: our number */
    unsigned char *in; /* [triangles] */
    int *mate;         /* [triangles]: the side across which it is joined, -1 */
    int (*mid)[3];     /* [triangles]: the middle of each side, -1 */
    ix_quad *quad;
    int nquads;
} tiling;

static ix_status add_point(tiling *w, double x, double y)
{
    if (w->n == w->room) {
        double(*more)[2];

        if (w->room > MOST)
            return IX_FAIL(w->ctx, IX_EARG,
                           "sides of %g: more than %d points would be needed",
                           w->o->size, MOST);
        w->room = 2 * w->room + 256;
        IX_SCRATCH(w->ctx, more, w->room);
        if (w->n)
            memcpy(more, w->p, (size_t)w->n * sizeof *more);
        w->p = more;
    }
    w->p[w->n][0] = x;
    w->p[w->n++][1] = y;
    return IX_OK;
}

/* --- the boundary ----------------------------------------------------------
 */

/* Is the way from a to b, in one span, short and straight enough? */
static bool fine(const tiling *w, const ix_path *p, int span, double a,
                 double b)
{
    double x[2][IX_MAX_COORDS], u[3], v[3];

    ix__path_point(p, a, x[0]);
    ix__path_point(p, b, x[1]);
    if (!(hypot(x[1][0] - x[0][0], x[1][1] - x[0][1]) <= w->step))
        return false;
    if (!ix__path_tangent3(p, span, a, false, u) ||
        !ix__path_tangent3(p, span, b, true, v))
        return true;
    return fabs(atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1])) <=
           w->o->angle;
}

/* Equal parts of a span, 1, 2, 4, ..; their number. A span of a closed curve of
 * few spans has at least `least`. */
static int parts_of(const tiling *w, const ix_path *p, int span, int least)
{
    double a = p->breaks[span], h = p->breaks[span + 1] - a;

    for (int n = least; n < 1 << 16; n *= 2) {
        bool all = true;

        for (int i = 0; all && i < n; i++)
            all = fine(w, p, span, a + h * i / n, a + h * (i + 1) / n);
        if (all)
            return n;
    }
    return 1 << 16;
}

static ix_status add_site(tiling *w, const ix_path *p, int crv, double t)
{
    double x[IX_MAX_COORDS];

    ix__path_point(p, t, x);
    IX_GROW(w->ctx, w->at, w->nsites, w->site_room);
    w->at[w->nsites++] = (site){.crv = crv, .t = t};
    return add_point(w, x[0], x[1]);
}

static ix_status add_boundary(tiling *w, const ix_mv *crv, int number)
{
    int first = w->nsites;
    ix_path p;

    IX_TRY(ix__check_planar(w->ctx, crv));
    IX_TRY(ix__check_closed(w->ctx, crv));
    IX_TRY(ix__path_new(w->ctx, crv, &p));
    IX_TRY(ix__path_no_poles(w->ctx, &p));
    for (int s = 0; s < p.nspans; s++) {
        int n = parts_of(w, &p, s, p.nspans < 4 ? 4 : 1);
        double a = p.breaks[s], h = p.breaks[s + 1] - a;

        for (int i = 0; i < n; i++)
            IX_TRY(add_site(w, &p, number, a + h * i / n));
    }
    for (int i = first; i < w->nsites; i++) {
        bool last = i == w->nsites - 1;

        w->at[i].next = last ? first : i + 1;
        w->at[i].t_next = last ? p.breaks[p.nspans] : w->at[i + 1].t;
    }
    return IX_OK;
}

/* --- points inside
 * -------------------------------------------------------------- */

/* Inside by parity, and not within `gap` of the boundary? */
static bool well_inside(const tiling *w, double x, double y, double gap)
{
    bool in = false;

    for (int i = 0; i < w->nsites; i++) {
        const double *a = w->p[i], *b = w->p[w->at[i].next];
        double dx = b[0] - a[0], dy = b[1] - a[1], len = dx * dx + dy * dy;
        double s = len > 0 ? ((x - a[0]) * dx + (y - a[1]) * dy) / len : 0;

        s = fmax(0, fmin(1, s));
        if (hypot(a[0] + s * dx - x, a[1] + s * dy - y) < gap)
            return false;
        if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) * dx / dy)
            in = !in;
    }
    return in;
}

/* A square grid, not nearer to the boundary than 0.6 of its step. */
static ix_status add_grid(tiling *w, const double hi[2])
{
    double h = w->step;
    double n[2] = {ceil((hi[0] - w->lo[0]) / h), ceil((hi[1] - w->lo[1]) / h)};

    if (!(n[0] * n[1] <= MOST))
        return IX_FAIL(w->ctx, IX_EARG,
                       "sides of %g: more than %d points would be needed",
                       w->o->size, MOST);
    for (int j = 0; j < (int)n[1]; j++)
        for (int i = 0; i < (int)n[0]; i++) {
            double x = (w->lo[0] + hi[0]) / 2 + (i - (n[0] - 1) / 2) * h;
            double y = (w->lo[1] + hi[1]) / 2 + (j - (n[1] - 1) / 2) * h;

            IX_TRY(ix__poll(w->ctx));
            if (well_inside(w, x, y, 0.6 * h))
                IX_TRY(add_point(w, x, y));
        }
    return IX_OK;
}

/* --- triangles -------------------------------------------------------------
 */

/* Into the middle nine tenths of the triangulation's square. */
static ix__cdt_point rounded(const tiling *w, const double p[2])
{
    return (ix__cdt_point){
        (int32_t)lround(IX__CDT_SIDE * 0.05 + (p[0] - w->lo[0]) * w->scale),
        (int32_t)lround(IX__CDT_SIDE * 0.05 + (p[1] - w->lo[1]) * w->scale)};
}

/* Points that the triangulation added, where curves cross. */
static ix_status take_crossings(tiling *w, int known, int *id)
{
    for (int i = known; i < w->d.npts; i++) {
        double x = (w->d.p[i].x - IX__CDT_SIDE * 0.05) / w->scale + w->lo[0];
        double y = (w->d.p[i].y - IX__CDT_SIDE * 0.05) / w->scale + w->lo[1];

        id[i] = w->n;
        IX_TRY(add_point(w, x, y));
    }
    return IX_OK;
}

/* Triangles inside: from the square's border on, changing at odd sides. */
static ix_status find_inside(tiling *w)
{
    int *queue, n = 0, side;

    IX_SCRATCH(w->ctx, queue, w->d.ntris);
    IX_SCRATCH(w->ctx, w->in, w->d.ntris);
    memset(w->in, 2, (size_t)w->d.ntris);
    queue[n++] = ix__cdt_border(&w->d, 0, &side);
    w->in[queue[0]] = 0;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++) {
            const ix__cdt_tri *t = &w->d.t[queue[i]];

            if (t->n[k] < 0 || w->in[t->n[k]] != 2)
                continue;
            w->in[t->n[k]] = w->in[queue[i]] ^ t->odd[k];
            queue[n++] = t->n[k];
        }
    return IX_OK;
}

static ix_status triangulate(tiling *w)
{
    int *vertex, known;

    IX_TRY(ix__cdt_init(w->ctx, w->n + 4, &w->d));
    IX_SCRATCH(w->ctx, vertex, w->n);
    for (int i = 0; i < w->n; i++)
        IX_TRY(ix__cdt_point_at(&w->d, rounded(w, w->p[i]), &vertex[i]));
    known = w->d.npts;
    for (int i = 0; i < w->nsites; i++)
        if (vertex[i] != vertex[w->at[i].next])
            IX_TRY(ix__cdt_toggle(&w->d, vertex[i], vertex[w->at[i].next]));
    IX_SCRATCH(w->ctx, w->id, w->d.npts);
    for (int i = w->n - 1; i >= 0; i--) /* of points at one place the first */
        w->id[vertex[i]] = i;
    IX_TRY(take_crossings(w, known, w->id));
    return find_inside(w);
}

/* --- joined in pairs
 * ------------------------------------------------------------ */

static const double *corner(const tiling *w, int t, int k)
{
    return w->p[w->id[w->d.t[t].v[k % 3]]];
}

/* Largest difference of an angle of the polygon a b c d from a right one. */
static double skew(const double *const q[4])
{
    double worst = 0;

    for (int k = 0; k < 4; k++) {
        const double *a = q[(k + 3) % 4], *b = q[k], *c = q[(k + 1) % 4];
        double u[2] = {c[0] - b[0], c[1] - b[1]};
        double v[2] = {a[0] - b[0], a[1] - b[1]};
        double angle = atan2(u[0] * v[1] - u[1] * v[0],
                             u[0] * v[0] + u[1] * v[1]);

        worst = fmax(worst, fabs(angle - 1.57079632679489662));
    }
    return worst;
}

static int across(const tiling *w, int t, int k)
{
    const ix__cdt_tri *r = &w->d.t[w->d.t[t].n[k]];

    return r->n[0] == t ? 0 : r->n[1] == t ? 1 : 2;
}

typedef struct {
    double skew;
    int t, k;
} pair;

static int by_skew(const void *a, const void *b)
{
    const pair *p = a, *q = b;

    if (p->skew < q->skew || p->skew > q->skew)
        return p->skew < q->skew ? -1 : 1;
    return p->t != q->t ? (p->t > q->t) - (p->t < q->t) : p->k - q->k;
}

/* The best pairs first; none with an angle 75 degrees from a right one. */
static ix_status join_pairs(tiling *w)
{
    pair *c;
    int n = 0;

    IX_SCRATCH(w->ctx, c, 3 * w->d.ntris);
    IX_SCRATCH(w->ctx, w->mate, w->d.ntris);
    for (int t = 0; t < w->d.ntris; t++) {
        w->mate[t] = -1;
        for (int k = 0; w->in[t] == 1 && k < 3; k++) {
            int r = w->d.t[t].n[k];

            if (r < t || w->in[r] != 1 || w->d.t[t].odd[k])
                continue;
            c[n].t = t;
            c[n].k = k;
            c[n].skew = skew((const double *const[4]){
                corner(w, t, k), corner(w, t, k + 1),
                corner(w, r, across(w, t, k)), corner(w, t, k + 2)});
            n += c[n].skew < 1.309;
        }
    }
    qsort(c, (size_t)n, sizeof *c, by_skew);
    for (int i = 0; i < n; i++) {
        int t = c[i].t, k = c[i].k, r = w->d.t[t].n[k];

        if (w->mate[t] >= 0 || w->mate[r] >= 0)
            continue;
        w->mate[t] = k;
        w->mate[r] = across(w, t, k);
    }
    return IX_OK;
}

/* --- halved ----------------------------------------------------------------
 */

/* The curve between two points that follow each other on it; false if it is
 * none. *back: from b to a. */
static bool on_curve(const tiling *w, int a, int b, const site **s, bool *back)
{
    *back = false;
    if (a < w->nsites && w->at[a].next == b) {
        *s = &w->at[a];
        return true;
    }
    *back = true;
    *s = b < w->nsites ? &w->at[b] : NULL;
    return b < w->nsites && w->at[b].next == a;
}

/* The middle of a side, on its curve if it has one. */
static ix_status middle(tiling *w, const ix_mv *const *crv, int t, int k)
{
    int a = w->id[w->d.t[t].v[(k + 1) % 3]];
    int b = w->id[w->d.t[t].v[(k + 2) % 3]], r = w->d.t[t].n[k];
    double x[IX_MAX_COORDS];
    const site *s;
    bool back;

    for (int i = 0; i < 2; i++)
        x[i] = (w->p[a][i] + w->p[b][i]) / 2;
    if (w->d.t[t].odd[k] && on_curve(w, a, b, &s, &back)) {
        double at = (s->t + s->t_next) / 2;

        IX_TRY(ix_mv_point(w->ctx, crv[s->crv], &at, x));
    }
    w->mid[t][k] = w->n;
    if (r >= 0)
        w->mid[r][across(w, t, k)] = w->n;
    return add_point(w, x[0], x[1]);
}

static ix_status middles(tiling *w, const ix_mv *const *crv)
{
    IX_SCRATCH(w->ctx, w->mid, w->d.ntris);
    memset(w->mid, -1, (size_t)w->d.ntris * sizeof *w->mid);
    for (int t = 0; t < w->d.ntris; t++)
        for (int k = 0; w->in[t] == 1 && k < 3; k++)
            if (k != w->mate[t] && w->mid[t][k] < 0)
                IX_TRY(middle(w, crv, t, k));
    return IX_OK;
}

/* Half of a side on a curve: from its end a to its middle, or (out) the other
 * way. b is the far end. */
static void name_side(const tiling *w, ix_quad *q, int k, int a, int b,
                      bool out)
{
    const site *s;
    bool back;

    q->crv[k] = -1;
    q->t[k][0] = q->t[k][1] = 0;
    if (!on_curve(w, a, b, &s, &back))
        return;
    q->crv[k] = s->crv;
    q->t[k][out] = back ? s->t_next : s->t;
    q->t[k][!out] = (s->t + s->t_next) / 2;
}

/* A polygon of n corners v, with the middles m of the sides after them and a
 * centre, as n quadrilaterals; odd[k]: the side after v[k] bounds the region.
 */
static ix_status spokes(tiling *w, int n, const int *v, const int *m,
                        const bool *odd)
{
    double c[2] = {0, 0};
    int centre = w->n;

    for (int i = 0; i < n; i++)
        for (int k = 0; k < 2; k++)
            c[k] += w->p[v[i]][k] / n;
    IX_TRY(add_point(w, c[0], c[1]));
    for (int i = 0; i < n; i++) {
        int before = (i + n - 1) % n;
        ix_quad *q = &w->quad[w->nquads++];

        *q = (ix_quad){
            {v[i], m[i], centre, m[before]}, {-1, -1, -1, -1}, {{0}}};
        if (odd[i])
            name_side(w, q, 0, v[i], v[(i + 1) % n], false);
        if (odd[before])
            name_side(w, q, 3, v[i], v[before], true);
    }
    return IX_OK;
}

/* Corners, middles and sides of triangle t from corner k on, side k left out at
 * the end: appended. */
static int append(const tiling *w, int t, int k, int sides, int n, int *v,
                  int *m, bool *odd)
{
    for (int i = 0; i < sides; i++, n++) {
        int from = (k + i) % 3, side = (from + 2) % 3;

        v[n] = w->id[w->d.t[t].v[from]];
        m[n] = w->mid[t][side];
        odd[n] = w->d.t[t].odd[side];
    }
    return n;
}

static ix_status divide(tiling *w)
{
    IX_SCRATCH(w->ctx, w->quad, 3 * w->d.ntris);
    for (int t = 0; t < w->d.ntris; t++) {
        int v[4], m[4], n, k = w->mate[t], r = k < 0 ? -1 : w->d.t[t].n[k];
        bool odd[4];

        if (w->in[t] != 1 || (k >= 0 && r < t))
            continue;
        if (k < 0) {
            n = append(w, t, 0, 3, 0, v, m, odd);
        } else { /* from the corner after side k, twice two sides */
            n = append(w, t, k + 2, 2, 0, v, m, odd);
            n = append(w, r, w->mate[r] + 2, 2, n, v, m, odd);
        }
        IX_TRY(spokes(w, n, v, m, odd));
    }
    return IX_OK;
}

/* --- smoothed --------------------------------------------------------------
 */

typedef struct {
    int *first, *quad; /* quads around each point */
    bool *fixed;
} stars;

static ix_status make_stars(const tiling *w, stars *s)
{
    IX_SCRATCH_ZERO(w->ctx, s->first, w->n + 2);
    IX_SCRATCH(w->ctx, s->quad, 4 * w->nquads);
    IX_SCRATCH_ZERO(w->ctx, s->fixed, w->n);
    for (int q = 0; q < w->nquads; q++)
        for (int k = 0; k < 4; k++)
            s->first[w->quad[q].v[k] + 2]++;
    for (int i = 0; i < w->n; i++)
        s->first[i + 2] += s->first[i + 1];
    for (int q = 0; q < w->nquads; q++)
        for (int k = 0; k < 4; k++)
            s->quad[s->first[w->quad[q].v[k] + 1]++] = q;
    /* what bounds the region stays: points that more sides reach than quads */
    for (int t = 0; t < w->d.ntris; t++)
        for (int k = 0; w->in[t] == 1 && k < 3; k++)
            if (w->d.t[t].odd[k]) {
                s->fixed[w->mid[t][k]] = true;
                for (int e = 1; e < 3; e++)
                    s->fixed[w->id[w->d.t[t].v[(k + e) % 3]]] = true;
            }
    return IX_OK;
}

/* Least area of a triangle of three corners in a row, of the quads around a
 * point. */
static double least_corner(const tiling *w, const stars *s, int v)
{
    double least = HUGE_VAL;

    for (int i = s->first[v]; i < s->first[v + 1]; i++)
        for (int k = 0; k < 4; k++) {
            const ix_quad *q = &w->quad[s->quad[i]];
            const double *a = w->p[q->v[k]], *b = w->p[q->v[(k + 1) % 4]];
            const double *c = w->p[q->v[(k + 2) % 4]];

            least = fmin(least, (b[0] - a[0]) * (c[1] - b[1]) -
                                    (b[1] - a[1]) * (c[0] - b[0]));
        }
    return least;
}

/* To the mean of the neighbours along sides, unless a corner becomes worse and
 * as good as flat. */
static void smooth_point(tiling *w, const stars *s, int v)
{
    double sum[2] = {0, 0}, old[2] = {w->p[v][0], w->p[v][1]}, before, after;
    int n = 0;

    for (int i = s->first[v]; i < s->first[v + 1]; i++)
        for (int k = 0; k < 4; k++) {
            const ix_quad *q = &w->quad[s->quad[i]];

            if (q->v[k] != v)
                continue;
            for (int e = 1; e < 4; e += 2, n++)
                for (int c = 0; c < 2; c++)
                    sum[c] += w->p[q->v[(k + e) % 4]][c];
        }
    before = least_corner(w, s, v);
    for (int c = 0; c < 2; c++)
        w->p[v][c] = sum[c] / n;
    after = least_corner(w, s, v);
    if (!(after >= fmin(before, 0.01 * w->step * w->step)))
        memcpy(w->p[v], old, sizeof old);
}

static ix_status smooth(tiling *w)
{
    stars s;

    if (w->o->smooth == 0)
        return IX_OK;
    IX_TRY(make_stars(w, &s));
    for (int round = 0; round < w->o->smooth; round++)
        for (int v = 0; v < w->n; v++)
            if (!s.fixed[v] && s.first[v + 1] > s.first[v])
                smooth_point(w, &s, v);
    return IX_OK;
}

/* --- the whole -------------------------------------------------------------
 */

static ix_status frame(tiling *w, double hi[2])
{
    double size;

    for (int k = 0; k < 2; k++) {
        w->lo[k] = HUGE_VAL;
        hi[k] = -HUGE_VAL;
        for (int i = 0; i < w->n; i++) {
            w->lo[k] = fmin(w->lo[k], w->p[i][k]);
            hi[k] = fmax(hi[k], w->p[i][k]);
        }
    }
    size = fmax(hi[0] - w->lo[0], hi[1] - w->lo[1]);
    w->scale = IX__CDT_SIDE * 0.9 / size;
    if (!(size > 0) || !isfinite(w->scale))
        return IX_FAIL(w->ctx, IX_EDOMAIN, "the curves enclose no region");
    return IX_OK;
}

/* Points that no quad has are left out. */
static ix_status give(tiling *w, ix_quads *out)
{
    size_t qs = (size_t)w->nquads * sizeof *out->quad, ps;
    int *number, n = 0;
    char *block;

    IX_SCRATCH(w->ctx, number, w->n);
    memset(number, -1, (size_t)w->n * sizeof *number);
    for (int q = 0; q < w->nquads; q++)
        for (int k = 0; k < 4; k++) {
            int *v = &w->quad[q].v[k];

            if (number[*v] < 0)
                number[*v] = n++;
        }
    ps = (size_t)n * sizeof *out->p;
    block = ix__alloc(w->ctx, qs + ps);
    if (!block)
        return IX_ENOMEM;
    *out = (ix_quads){.npts = n, .nquads = w->nquads, .bytes = qs + ps};
    out->quad = (ix_quad *)(void *)block;
    out->p = (double(*)[2])(void *)(block + qs);
    memcpy(out->quad, w->quad, qs);
    for (int i = 0; i < w->n; i++)
        if (number[i] >= 0)
            memcpy(out->p[number[i]], w->p[i], sizeof *out->p);
    for (int q = 0; q < w->nquads; q++)
        for (int k = 0; k < 4; k++)
            out->quad[q].v[k] = number[out->quad[q].v[k]];
    return IX_OK;
}

static ix_status tile(tiling *w, int n, const ix_mv *const *crv, ix_quads *out)
{
    double hi[2];

    for (int i = 0; i < n; i++)
        IX_TRY(add_boundary(w, crv[i], i));
    IX_TRY(frame(w, hi));
    IX_TRY(add_grid(w, hi));
    IX_TRY(triangulate(w));
    IX_TRY(join_pairs(w));
    IX_TRY(middles(w, crv));
    IX_TRY(divide(w));
    if (w->nquads == 0)
        return IX_FAIL(w->ctx, IX_EDOMAIN, "the curves enclose no region");
    IX_TRY(smooth(w));
    return give(w, out);
}

ix_status ix_region_quads(ix_ctx *ctx, int n, const ix_mv *const *crv,
                          const ix_tile_opts *o, ix_quads *out)
{
    tiling w = {.ctx = ctx, .o = o, .step = 2 * o->size};

    *out = (ix_quads){0};
    if (n < 1 || !(o->angle >= 0.01 && o->angle <= 3.1416) ||
        !(o->size > 0 && isfinite(o->size)) || o->smooth < 0 ||
        o->smooth > 1000)
        return IX_FAIL(
            ctx, IX_EARG,
            "%d curves, angle %g, size %g, smoothing %d; curves, 0.01 "
            "to half a turn, a positive size, 0 to 1000 are wanted",
            n, o->angle, o->size, o->smooth);
    IX_RETURN_SCOPED(ctx, tile(&w, n, crv, out));
}

void ix_quads_free(ix_ctx *ctx, ix_quads *q)
{
    ix__free(ctx, q->quad, q->bytes);
    *q = (ix_quads){0};
}
