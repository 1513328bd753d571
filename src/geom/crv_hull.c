/* crv_hull.c - the convex hull of a closed planar curve.
 *
 * An arc ends where a bitangent, a tangent from a corner or a corner is;
 * whether it is on the hull its middle tells, whose tangent must have all of
 * the curve on one side. A corner is a vertex if some line through it has: one
 * that bounds the range of such lines touches the curve or meets another
 * corner. The parts are put in order by their outward normals. */
#include <math.h>
#include <stdlib.h>

#include "geom/angle.h"
#include "geom/crvs.h"
#include "geom/marks.h"
#include "iritx/distance.h"
#include "iritx/visible.h"

#define DENT 1e-9 /* of the size */

/* An arc, or a vertex (from == to), with its outward normal. */
typedef struct {
    double from, to, normal[2], angle;
    bool reversed;
} part;

typedef struct {
    ix__marks m;
    int nparts, ncorners;
    part *part;
    double *corner;
} hull;

/* Parameters that are one mark. */
static bool same(const hull *h, double a, double b)
{
    return fabs(a - b) <= 1e-9 * (h->m.dom[1] - h->m.dom[0]);
}

/* Is no point of the curve farther along the unit vector n than p? */
static ix_status supports(const hull *h, const double *p, const double n[2],
                          bool *yes)
{
    double top = DENT * h->m.size, x[IX_MAX_COORDS];
    ix_root *r;
    int nr;

    *yes = true;
    for (int i = 0; i < h->ncorners; i++) {
        ix__path_point(&h->m.path, h->corner[i], x);
        if (!((x[0] - p[0]) * n[0] + (x[1] - p[1]) * n[1] <= top))
            *yes = false;
    }
    if (!*yes)
        return IX_OK;
    IX_TRY(ix__marks_line(&h->m, p, n, true, &r, &nr));
    for (int i = 0; *yes && i < nr; i++) {
        ix__path_point(&h->m.path, r[i].t, x);
        *yes = (x[0] - p[0]) * n[0] + (x[1] - p[1]) * n[1] <= top;
    }
    ix_roots_free(h->m.ctx, r, nr);
    return IX_OK;
}

static void add_part(hull *h, double from, double to, const double n[2],
                     bool reversed)
{
    h->part[h->nparts++] = (part){.from = from,
                                  .to = to,
                                  .normal = {n[0], n[1]},
                                  .angle = atan2(n[1], n[0]),
                                  .reversed = reversed};
}

/* The arc between two marks, if it is on the hull. Err IX_EDOMAIN all of the
 * curve is on its tangent. */
static ix_status try_arc(hull *h, double from, double to)
{
    double t = (from + to) / 2, p[IX_MAX_COORDS], u[3];
    int span = ix__path_span(&h->m.path, t);
    bool yes[2];

    ix__path_point(&h->m.path, t, p);
    if (!ix__path_tangent3(&h->m.path, span, t, false, u))
        return IX_OK;
    for (int side = 0; side < 2; side++) { /* outward to the right, left */
        const double s = side ? -1 : 1, n[2] = {s * u[1], -s * u[0]};

        IX_TRY(supports(h, p, n, &yes[side]));
        if (yes[side])
            add_part(h, from, to, n, side);
    }
    if (yes[0] && yes[1])
        return IX_FAIL(h->m.ctx, IX_EDOMAIN,
                       "a curve on one line has no convex hull");
    return IX_OK;
}

/* Adds the normals along +-u, turned, that support the corner. */
static ix_status try_line(hull *h, const double *p, const double u[2],
                          double sum[2])
{
    double len = hypot(u[0], u[1]);

    if (!(len > 0))
        return IX_OK;
    for (int side = 0; side < 2; side++) {
        const double s = (side ? -1 : 1) / len, n[2] = {s * u[1], -s * u[0]};
        bool yes;

        IX_TRY(supports(h, p, n, &yes));
        sum[0] += yes ? n[0] : 0;
        sum[1] += yes ? n[1] : 0;
    }
    return IX_OK;
}

static ix_status try_chord(hull *h, const double *p, double t, double sum[2])
{
    double x[IX_MAX_COORDS], u[2];

    ix__path_point(&h->m.path, t, x);
    u[0] = x[0] - p[0];
    u[1] = x[1] - p[1];
    if (!(hypot(u[0], u[1]) > 1e-6 * h->m.size))
        return IX_OK; /* the corner itself, or next to it */
    return try_line(h, p, u, sum);
}

/* Tangents at the corner from both sides, lines to other corners, tangents. */
static ix_status corner_lines(hull *h, double t, const double *p,
                              const ix_root *r, int nr, double sum[2])
{
    double u[3];
    int span = ix__path_span(&h->m.path, t);

    for (int side = 0; side < 2; side++) {
        int at = side ? span : (span ? span : h->m.path.nspans) - 1;
        double end = side ? h->m.path.breaks[at] : h->m.path.breaks[at + 1];

        if (ix__path_tangent3(&h->m.path, at, end, !side, u))
            IX_TRY(try_line(h, p, u, sum));
    }
    for (int i = 0; i < h->ncorners; i++)
        IX_TRY(try_chord(h, p, h->corner[i], sum));
    for (int i = 0; i < nr; i++)
        IX_TRY(try_chord(h, p, r[i].t, sum));
    return IX_OK;
}

/* The corner is a vertex, unless an arc of the hull ends in it. */
static ix_status try_corner(hull *h, double t)
{
    double p[IX_MAX_COORDS] = {0}, sum[2] = {0, 0};
    const double *end = h->m.dom;
    ix_status st;
    ix_root *r;
    int n;

    for (int i = 0; i < h->nparts; i++) {
        const part *a = &h->part[i];

        if (same(h, a->from, t) || same(h, a->to, t) ||
            (same(h, end[0], t) && same(h, end[1], a->to)))
            return IX_OK;
    }
    ix__path_point(&h->m.path, t, p);
    p[2] = 0;
    IX_TRY(ix_crv_tangents_from(h->m.ctx, h->m.crv, p, &r, &n));
    st = corner_lines(h, t, p, r, n, sum);
    ix_roots_free(h->m.ctx, r, n);
    IX_TRY(st);
    if (hypot(sum[0], sum[1]) > 0)
        add_part(h, t, t, sum, false);
    return IX_OK;
}

/* Arcs that follow each other smoothly in the parameter become one. */
static void join_arcs(hull *h)
{
    int n = 0, k = 0;

    for (int i = 0; i < h->nparts; i++) {
        part *last = n ? &h->part[n - 1] : NULL, *p = &h->part[i];

        while (k < h->ncorners && h->corner[k] < p->from &&
               !same(h, h->corner[k], p->from))
            k++;
        if (last && same(h, last->to, p->from) &&
            last->reversed == p->reversed &&
            !(k < h->ncorners && same(h, h->corner[k], p->from)))
            last->to = p->to;
        else
            h->part[n++] = *p;
    }
    h->nparts = n;
}

static int by_angle(const void *a, const void *b)
{
    double x = ((const part *)a)->angle, y = ((const part *)b)->angle;

    return x < y ? -1 : x > y;
}

static ix_status find_marks(hull *h)
{
    ix_solutions s;
    ix_root *r;
    int n;

    ix__marks_sort(&h->m);
    h->ncorners = h->m.n;
    IX_SCRATCH(h->m.ctx, h->corner, h->ncorners);
    for (int i = 0; i < h->ncorners; i++) {
        double p[IX_MAX_COORDS] = {0};

        h->corner[i] = h->m.t[i];
        ix__path_point(&h->m.path, h->corner[i], p);
        p[2] = 0;
        IX_TRY(ix_crv_tangents_from(h->m.ctx, h->m.crv, p, &r, &n));
        IX_TRY(ix__marks_add_roots(&h->m, r, n));
    }
    IX_TRY(ix_crv_bitangents(h->m.ctx, h->m.crv, &s));
    return ix__marks_add_pairs(&h->m, &s);
}

static ix_status find_parts(hull *h)
{
    IX_TRY(find_marks(h));
    ix__marks_sort(&h->m);
    IX_SCRATCH(h->m.ctx, h->part, h->m.n + 1 + h->ncorners);
    for (int i = 0; i + 1 < h->m.n; i++)
        IX_TRY(try_arc(h, h->m.t[i], h->m.t[i + 1]));
    join_arcs(h);
    for (int i = 0; i < h->ncorners; i++) /* the domain's ends are one */
        if (h->corner[i] < h->m.dom[1])
            IX_TRY(try_corner(h, h->corner[i]));
    qsort(h->part, (size_t)h->nparts, sizeof *h->part, by_angle);
    return IX_OK;
}

/* --- as one curve --------------------------------------------------------- */

/* The arc in the direction of the hull. */
static ix_status arc_curve(const hull *h, const ix_mv *b, const part *p,
                           ix_mv **out)
{
    ix_status st;
    ix_mv *arc;

    IX_TRY(ix_mv_region(h->m.ctx, b, 0, p->from, p->to, &arc));
    if (!p->reversed) {
        *out = arc;
        return IX_OK;
    }
    st = ix_mv_reverse(h->m.ctx, arc, 0, out);
    ix_mv_unref(h->m.ctx, arc);
    return st;
}

/* The homogeneous point of the curve at t, weight 1. */
static void vertex_axes(const hull *h, double t, double *axes)
{
    axes[0] = 1;
    ix__path_point(&h->m.path, t, axes + h->m.crv->rational);
}

static ix_status add_line(const hull *h, const ix_mv *sum, const double *axes,
                          ix_mv **out)
{
    const double *p = axes + h->m.crv->rational;
    double dom[2], end[IX_MAX_COORDS];

    ix_mv_domain(sum, 0, dom);
    IX_TRY(ix_mv_point(h->m.ctx, sum, &dom[1], end));
    if (hypot(end[0] - p[0], end[1] - p[1]) <= DENT * h->m.size) {
        *out = ix_mv_ref(sum);
        return IX_OK;
    }
    return ix_mv_add_point(h->m.ctx, sum, axes, false, out);
}

/* sum and the next part: a line to its first point, then the arc. */
static ix_status add_next(const hull *h, const ix_mv *b, const part *p,
                          const ix_mv *sum, ix_mv **out)
{
    double axes[IX_MAX_COORDS + 1];
    ix_mv *line, *arc;
    ix_status st;

    vertex_axes(h, p->reversed ? p->to : p->from, axes);
    IX_TRY(add_line(h, sum, axes, &line));
    if (p->from >= p->to) {
        *out = line;
        return IX_OK;
    }
    st = arc_curve(h, b, p, &arc);
    if (st == IX_OK) {
        st = ix_mv_merge(h->m.ctx, line, arc, 0, IX_JOIN_SHARED, out);
        ix_mv_unref(h->m.ctx, arc);
    }
    ix_mv_unref(h->m.ctx, line);
    return st;
}

/* Only vertices: a closed polyline. */
static ix_status polygon(const hull *h, ix_mv **out)
{
    int n = h->nparts + 1, nc = h->m.crv->ncoords;
    const ix_dir d = {.basis = IX_BEZIER, .order = 2, .length = 2};
    double axes[IX_MAX_COORDS + 1], *pts;
    ix_mv *sum, *next;

    IX_SCRATCH(h->m.ctx, pts, 2 * nc);
    for (int e = 0; e < 2; e++) {
        vertex_axes(h, h->part[e].from, axes);
        for (int k = 0; k < nc; k++)
            pts[k * 2 + e] = axes[k + h->m.crv->rational];
    }
    IX_TRY(ix_mv_new(h->m.ctx, 1, &d, nc, false, pts, &sum));
    for (int i = 2; i < n; i++) {
        ix_status st;

        vertex_axes(h, h->part[i % h->nparts].from, axes);
        st = ix_mv_add_point(h->m.ctx, sum, axes + h->m.crv->rational, false,
                             &next);
        ix_mv_unref(h->m.ctx, sum);
        IX_TRY(st);
        sum = next;
    }
    *out = sum;
    return IX_OK;
}

/* From the first arc around and back to it. */
static ix_status assemble(const hull *h, const ix_mv *b, int first, ix_mv **out)
{
    double axes[IX_MAX_COORDS + 1];
    const part *p = &h->part[first];
    ix_mv *sum, *next = NULL;
    ix_status st = arc_curve(h, b, p, &sum);

    for (int i = 1; st == IX_OK && i < h->nparts; i++) {
        st = add_next(h, b, &h->part[(first + i) % h->nparts], sum, &next);
        ix_mv_unref(h->m.ctx, sum);
        sum = next;
    }
    IX_TRY(st);
    vertex_axes(h, p->reversed ? p->to : p->from, axes);
    st = add_line(h, sum, axes, out);
    ix_mv_unref(h->m.ctx, sum);
    return st;
}

static ix_status convex_hull(ix_ctx *ctx, const ix_mv *crv, ix_mv **out)
{
    hull h = {.nparts = 0};
    ix_status st;
    int first = 0;
    ix_mv *b;

    IX_TRY(ix__check_closed(ctx, crv));
    IX_TRY(ix__marks_new(ctx, crv, &h.m));
    IX_TRY(find_parts(&h));
    while (first < h.nparts && h.part[first].from >= h.part[first].to)
        first++;
    if (first == h.nparts)
        return polygon(&h, out);
    IX_TRY(ix_mv_to_bspline(ctx, crv, &b));
    st = assemble(&h, b, first, out);
    ix_mv_unref(ctx, b);
    return st;
}

ix_status ix_crv_hull(ix_ctx *ctx, const ix_mv *crv, ix_mv **out)
{
    *out = NULL;
    IX_RETURN_SCOPED(ctx, convex_hull(ctx, crv, out));
}
