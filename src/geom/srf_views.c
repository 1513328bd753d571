/* srf_views.c - few directions from which all of a surface is seen at small
 * angles, and the parts that each of them sees.
 *
 * The domain is cut into cells until the normals of each fit a narrow cone, by
 * bounds; then directions are chosen, each time the one that takes in the most
 * cells left, until there are none: so nothing is left out between samples.
 * Where a whole edge is one point the field of normals vanishes along it, and
 * at knots of a rational surface it jumps in its length: then the surface is
 * treated patch by patch, with factors that vanish along edges divided out. */
#include <math.h>
#include <string.h>

#include "base/grow.h"
#include "geom/lines.h"
#include "geom/normals.h"
#include "geom/vec3.h"
#include "iritx/contour.h"
#include "iritx/geom_srf.h"
#include "iritx/sym.h"
#include "mv/mv.h"

#define MOST_CELLS 20000
#define MOST_VIEWS 2000
#define DEPTH      30 /* halvings of a cell, both ways together */

/* The field of normals of a part of the domain, on its own domain. */
typedef struct {
    ix_mv *field;
    double lo[2], hi[2]; /* of the surface's domain */
} part;

typedef struct {
    double axis[3], half; /* of a cone that holds its normals */
} cell;

typedef struct {
    ix_ctx *ctx;
    double angle, tol;
    int cells;
    double dom[2][2];
    int nparts;
    part *part;
    int n, room;
    cell *c;
    int nviews;
    double (*view)[3];
} cover;

/* --- the field of normals
 * ------------------------------------------------------- */

/* Numerators only: three polynomial coordinates. */
static ix_status numerators(ix_ctx *ctx, const ix_mv *s, ix_mv **out)
{
    ix_mv *f, *x[3] = {NULL};
    ix_status st;

    IX_TRY(ix_srf_normal_field(ctx, s, &f));
    st = IX_OK;
    for (int k = 0; st == IX_OK && k < 3; k++)
        st = ix_mv_scalar(ctx, f, f->rational + k, &x[k]);
    if (st == IX_OK)
        st = ix_mv_join_scalars(ctx, 3, (const ix_mv *const *)x, false, out);
    for (int k = 0; k < 3; k++)
        ix_mv_unref(ctx, x[k]);
    ix_mv_unref(ctx, f);
    return st;
}

static double largest(const ix_mv *f)
{
    double top = 0;

    for (size_t i = 0; i < 3 * f->npts; i++)
        top = fmax(top, fabs(f->pts[i]));
    return top;
}

/* Do all control points of an outer layer vanish, to rounding? */
static bool layer_vanishes(const ix_mv *f, int dir, int end)
{
    int n[2] = {f->dirs[0].length, f->dirs[1].length};
    int fixed = end ? n[dir] - 1 : 0;
    double top = largest(f);

    for (int i = 0; i < n[!dir]; i++)
        for (int k = 0; k < 3; k++) {
            int at = dir == 0 ? fixed + i * n[0] : i + fixed * n[0];

            if (!(fabs(ix_mv_coord(f, k)[at]) <= 1e-10 * top))
                return false;
        }
    return true;
}

/* A Bezier field without its factor t or 1 - t in one direction: C(d, i) / C(d
 * - 1, i - 1) = d / i. */
static ix_status strip(ix_ctx *ctx, const ix_mv *f, int dir, int end,
                       ix_mv **out)
{
    int n[2] = {f->dirs[0].length, f->dirs[1].length}, m[2] = {n[0], n[1]};
    int d = n[dir] - 1;
    ix_dir dirs[2];
    ix_mv *g;

    m[dir]--;
    for (int k = 0; k < 2; k++)
        dirs[k] = (ix_dir){.basis = IX_BEZIER, .order = m[k], .length = m[k]};
    IX_TRY(ix__mv_alloc(ctx, 2, dirs, 3, false, &g));
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < m[1]; j++)
            for (int i = 0; i < m[0]; i++) {
                int at = dir ? j : i;
                int from[2] = {i, j};
                double factor = (double)d / (end ? d - at : at + 1);

                from[dir] += !end;
                g->pts[((size_t)k * (size_t)m[1] + (size_t)j) * (size_t)m[0] +
                       (size_t)i] = factor *
                                    ix_mv_coord(f, k)[from[0] + from[1] * n[0]];
            }
    *out = g;
    return IX_OK;
}

static ix_status strip_all(ix_ctx *ctx, ix_mv **f)
{
    for (int side = 0; side < 4; side++)
        while ((*f)->dirs[side / 2].length > 1 && largest(*f) > 0 &&
               layer_vanishes(*f, side / 2, side % 2)) {
            ix_mv *g;

            IX_TRY(strip(ctx, *f, side / 2, side % 2, &g));
            ix_mv_unref(ctx, *f);
            *f = g;
        }
    return IX_OK;
}

/* Does the field jump at a knot? That of a rational surface does, in its length
 * where its direction is continuous. */
static bool has_jumps(const ix_mv *f)
{
    for (int d = 0; d < 2; d++) {
        const ix_dir *p = &f->dirs[d];
        int run = 1;

        for (int i = p->order; p->basis == IX_BSPLINE && i < p->length; i++) {
            run = p->knots[i] > p->knots[i - 1] ? 1 : run + 1;
            if (run >= p->order)
                return true;
        }
    }
    return false;
}

static ix_status make_patches(cover *w, const ix_mv *f)
{
    ix_mv_pieces p;
    ix_status st = IX_OK;

    IX_TRY(ix_mv_to_bezier(w->ctx, f, &p));
    w->part = ix__scratch(w->ctx, p.count, sizeof *w->part);
    if (!w->part)
        st = IX_ENOMEM;
    for (size_t i = 0; st == IX_OK && i < p.count; i++) {
        part *q = &w->part[w->nparts++];

        q->field = ix_mv_ref(p.piece[i]);
        for (int k = 0; k < 2; k++) {
            q->lo[k] = p.lo[2 * i + (size_t)k];
            q->hi[k] = p.hi[2 * i + (size_t)k];
        }
        st = strip_all(w->ctx, &q->field);
    }
    ix_mv_pieces_free(w->ctx, &p);
    return st;
}

/* The whole, or its patches if there are poles or jumps. Takes over f. */
static ix_status make_parts(cover *w, ix_mv *f)
{
    ix_status st;
    ix_mv *open;
    bool poles;

    st = ix_mv_to_open(w->ctx, f, &open);
    ix_mv_unref(w->ctx, f);
    IX_TRY(st);
    poles = has_jumps(open);
    for (int side = 0; side < 4; side++)
        poles = poles || layer_vanishes(open, side / 2, side % 2);
    if (poles) {
        st = make_patches(w, open);
        ix_mv_unref(w->ctx, open);
        return st;
    }
    w->part = ix__scratch(w->ctx, 1, sizeof *w->part);
    if (!w->part) {
        ix_mv_unref(w->ctx, open);
        return IX_ENOMEM;
    }
    w->part[w->nparts++] = (part){
        open, {w->dom[0][0], w->dom[1][0]}, {w->dom[0][1], w->dom[1][1]}};
    return IX_OK;
}

/* --- cells -----------------------------------------------------------------
 */

static ix_status add_cell(cover *w, const cell *c)
{
    IX_GROW(w->ctx, w->c, w->n, w->room);
    if (w->n == MOST_CELLS)
        return IX_FAIL(
            w->ctx, IX_EUNABLE,
            "more than %d cells of the surface would be needed for cones "
            "of %g radians",
            MOST_CELLS, w->angle);
    w->c[w->n++] = *c;
    return IX_OK;
}

/* Two halves of a field. */
static ix_status halves(ix_ctx *ctx, const ix_mv *f, int dir, ix_mv *out[2])
{
    double dom[2];

    ix_mv_domain(f, dir, dom);
    return ix_mv_split(ctx, f, dir, (dom[0] + dom[1]) / 2, out);
}

/* The normals of a cell, or of its halves, as cones not wider than a third of
 * the wanted angle. steps[k]: halvings that are still to be done at least.
 * Depth first, at most DEPTH deep. */
static ix_status refine(cover *w, const ix_mv *f, const int steps[2], int depth)
{
    int dir = steps[1] > steps[0] || (steps[0] == steps[1] && depth % 2);
    int left[2] = {steps[0], steps[1]};
    ix_mv *h[2];
    ix_status st;
    cell c;

    IX_TRY(ix__poll(w->ctx));
    if (steps[0] <= 0 && steps[1] <= 0) {
        IX_TRY(ix__normals_cone(w->ctx, f, c.axis, &c.half));
        if (c.half <= w->angle / 3)
            return add_cell(w, &c);
    }
    if (depth == DEPTH)
        return IX_FAIL(w->ctx, IX_EUNABLE,
                       "the normals of a cell of 2^-%d of the domain spread by "
                       "more than %g radians: an edge or a cusp",
                       DEPTH / 2, w->angle / 3);
    left[dir]--;
    IX_TRY(halves(w->ctx, f, dir, h));
    st = refine(w, h[0], left, depth + 1);
    if (st == IX_OK)
        st = refine(w, h[1], left, depth + 1);
    ix_mv_unref(w->ctx, h[0]);
    ix_mv_unref(w->ctx, h[1]);
    return st;
}

static ix_status make_cells(cover *w)
{
    for (int i = 0; i < w->nparts; i++) {
        const part *p = &w->part[i];
        int steps[2];

        for (int k = 0; k < 2; k++) /* halvings to so many cells */
            steps[k] = (int)ceil(log2(w->cells * (p->hi[k] - p->lo[k]) /
                                      (w->dom[k][1] - w->dom[k][0])) -
                                 1e-9);
        IX_TRY(refine(w, p->field, steps, 0));
    }
    return IX_OK;
}

/* --- directions ------------------------------------------------------------
 */

static bool takes_in(const cover *w, const double view[3], const cell *c)
{
    double x[3];

    ix__cross3(view, c->axis, x);
    return atan2(ix__len3(x), ix__dot3(view, c->axis)) + c->half <=
           w->angle - 1e-9;
}

/* The axis that takes in the most cells left; of equal ones the first. */
static int best_view(const cover *w, const bool *done)
{
    int best = -1, most = 0, stride = w->n / 1000 + 1;

    for (int i = 0; i < w->n; i++) {
        int count = 0;

        if (done[i] && i % stride)
            continue;
        if (best >= 0 && i % stride) /* of many axes not all are tried */
            continue;
        for (int k = 0; k < w->n; k++)
            count += !done[k] && takes_in(w, w->c[i].axis, &w->c[k]);
        if (count > most) {
            most = count;
            best = i;
        }
    }
    return best;
}

static ix_status choose(cover *w)
{
    int left = w->n;
    bool *done;

    IX_SCRATCH_ZERO(w->ctx, done, w->n);
    IX_SCRATCH(w->ctx, w->view, MOST_VIEWS);
    while (left > 0) {
        int i = best_view(w, done);

        IX_TRY(ix__poll(w->ctx));
        if (w->nviews == MOST_VIEWS)
            return IX_FAIL(w->ctx, IX_EUNABLE,
                           "more than %d directions are needed for cones of %g "
                           "radians",
                           MOST_VIEWS, w->angle);
        for (int k = 0; k < w->n; k++)
            if (!done[k] && takes_in(w, w->c[i].axis, &w->c[k])) {
                done[k] = true;
                left--;
            }
        memcpy(w->view[w->nviews++], w->c[i].axis, sizeof w->c[i].axis);
    }
    return IX_OK;
}

/* --- what they see
 * -------------------------------------------------------------- */

/* Of the closed lines those along which normals are on the viewer's side, in
 * the surface's parameters. */
static ix_status keep_near(const cover *w, const part *p, const double view[3],
                           ix_lines *l)
{
    double(*from)[3] = l->pt, (*to)[3] = l->pt, dom[2][2];
    int n = 0;

    for (int k = 0; k < 2; k++)
        ix_mv_domain(p->field, k, dom[k]);
    for (int i = 0; i < l->n; from += l->count[i], i++) {
        double sum = 0;

        for (int v = 0; v < l->count[i]; v++) {
            double m[3];

            IX_TRY(ix_mv_eval(w->ctx, p->field, from[v], m));
            sum += ix__dot3(m, view);
        }
        if (!(sum > 0))
            continue;
        for (int v = 0; v < l->count[i]; v++, to++)
            for (int k = 0; k < 3; k++)
                (*to)[k] = k == 2 ? 0
                                  : p->lo[k] + (p->hi[k] - p->lo[k]) *
                                                   (from[v][k] - dom[k][0]) /
                                                   (dom[k][1] - dom[k][0]);
        l->count[n++] = l->count[i];
    }
    l->n = n;
    return IX_OK;
}

static ix_status seen_part(const cover *w, const part *p, const double view[3],
                           ix_lines *out)
{
    ix_status st;
    ix_mv *f;

    IX_TRY(ix__normals_isocline(w->ctx, p->field, view, w->angle, &f));
    st = ix_positive_region(w->ctx, f, w->tol, out);
    ix_mv_unref(w->ctx, f);
    return st == IX_OK ? keep_near(w, p, view, out) : st;
}

static ix_status regions(const cover *w, ix_view_regions *out)
{
    for (int i = 0; i < w->nviews; i++)
        for (int k = 0; k < w->nparts; k++) {
            ix_view_region *r = &out->region[out->n++];

            memcpy(r->dir, w->view[i], sizeof r->dir);
            IX_TRY(seen_part(w, &w->part[k], w->view[i], &r->border));
            if (r->border.n == 0) {
                ix_lines_free(w->ctx, &r->border);
                out->n--;
            }
        }
    return IX_OK;
}

void ix_view_regions_free(ix_ctx *ctx, ix_view_regions *r)
{
    for (int i = 0; i < r->n; i++)
        ix_lines_free(ctx, &r->region[i].border);
    ix__free(ctx, r->region, r->bytes);
    *r = (ix_view_regions){0};
}

static ix_status find(cover *w, const ix_mv *srf, ix_view_regions *out)
{
    ix_mv *f;
    ix_status st;
    size_t room;

    for (int k = 0; k < 2; k++)
        ix_mv_domain(srf, k, w->dom[k]);
    IX_TRY(numerators(w->ctx, srf, &f));
    IX_TRY(make_parts(w, f));
    IX_TRY(make_cells(w));
    IX_TRY(choose(w));
    room = (size_t)w->nviews * (size_t)w->nparts;
    out->bytes = room * sizeof *out->region;
    out->region = ix__alloc(w->ctx, out->bytes);
    if (!out->region)
        return out->bytes = 0, IX_ENOMEM;
    memset(out->region, 0, out->bytes);
    st = regions(w, out);
    if (st != IX_OK)
        ix_view_regions_free(w->ctx, out);
    return st;
}

ix_status ix_srf_view_regions(ix_ctx *ctx, const ix_mv *srf, int cells,
                              double angle, double tol, ix_view_regions *out)
{
    cover w = {.ctx = ctx, .angle = angle, .tol = tol, .cells = cells};
    ix_mark mk;
    ix_status st;

    *out = (ix_view_regions){0};
    IX_TRY(ix__check_space_surface(ctx, srf));
    if (cells < 1 || cells > 100 || !(angle >= 1e-3 && angle <= 1.5707964))
        return IX_FAIL(ctx, IX_EARG,
                       "%d cells, cones of %g radians; 1 to 100, 0.001 to a "
                       "right angle are possible",
                       cells, angle);
    mk = ix__scratch_mark(ctx);
    st = find(&w, srf, out);
    for (int i = 0; i < w.nparts; i++)
        ix_mv_unref(ctx, w.part[i].field);
    ix__scratch_release(ctx, mk);
    return st;
}
