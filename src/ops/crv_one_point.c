/* crv_one_point.c - how the curvature's sign depends on one control point.
 *
 * det(p, p', p'') of the homogeneous curve p = p0 + B(t) q is affine in the
 * control point q, as det with two rows along q vanishes: over a square of
 * positions the field is bilinear between those of the four corners. */
#include <math.h>
#include <string.h>

#include "geom/iso_surface.h"
#include "geom/lines.h"
#include "geom/parts.h"
#include "iritx/ops_crv.h"
#include "iritx/sym.h"
#include "mv/mv.h"

/* --- the field
 * ------------------------------------------------------------------ */

static ix_status check(ix_ctx *ctx, const ix_mv *crv, int idx,
                       const double range[2])
{
    if (crv->ndirs != 1 || crv->ncoords < 2 || crv->ncoords > 3 ||
        ix__mv_has_basis(crv, IX_POWER))
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a Bezier or B-spline "
                       "curve in the plane is wanted",
                       crv->ndirs, crv->ncoords);
    if (idx < 0 || (size_t)idx >= crv->npts)
        return IX_FAIL(ctx, IX_EARG, "control point %d of %zu (from 0)", idx,
                       crv->npts);
    if (!(range[0] < range[1]) || !isfinite(range[1] - range[0]))
        return IX_FAIL(ctx, IX_EARG, "positions from %g to %g", range[0],
                       range[1]);
    if (crv->dirs[0].order < 3)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "a curve of order %d is straight everywhere",
                       crv->dirs[0].order);
    return IX_OK;
}

/* The inflection field with the control point at (x, y). */
static ix_status field_at(ix_ctx *ctx, const ix_mv *crv, int idx, double x,
                          double y, ix_mv **out)
{
    double p[IX_MAX_COORDS + 1], w = 1;
    ix_mv *moved, *f;
    ix_status st;

    for (int k = 0; k < ix_mv_naxes(crv); k++)
        p[k] = ix_mv_axis(crv, k)[idx];
    if (crv->rational)
        w = p[0];
    p[crv->rational] = w * x;
    p[crv->rational + 1] = w * y;
    IX_TRY(ix_mv_set_point(ctx, crv, (size_t)idx, p, &moved));
    st = ix_crv_field(ctx, moved, IX_CRV_INFLECTION, NULL, NULL, &f);
    ix_mv_unref(ctx, moved);
    IX_TRY(st);
    moved = NULL;
    if (f->rational) /* its numerator */
        st = ix_mv_scalar(ctx, f, 1, &moved);
    else
        st = ix_mv_to_bspline(ctx, f, &moved);
    ix_mv_unref(ctx, f);
    *out = moved;
    return st;
}

static ix_status stack(ix_ctx *ctx, ix_mv *const layer[2],
                       const double range[2], ix_mv **out)
{
    const double knots[4] = {range[0], range[0], range[1], range[1]};
    const ix_dir d = {
        .basis = IX_BSPLINE, .order = 2, .length = 2, .knots = knots};

    return ix_mv_stack(ctx, 2, (const ix_mv *const *)layer, &d, out);
}

static ix_status field(ix_ctx *ctx, const ix_mv *crv, int idx,
                       const double range[2], ix_mv **out)
{
    ix_mv *f[4] = {NULL}, *rows[2] = {NULL};
    ix_status st = IX_OK;

    for (int i = 0; st == IX_OK && i < 4; i++)
        st = field_at(ctx, crv, idx, range[i % 2], range[i / 2], &f[i]);
    for (int i = 0; st == IX_OK && i < 2; i++)
        st = stack(ctx, f + 2 * i, range, &rows[i]);
    if (st == IX_OK)
        st = stack(ctx, rows, range, out);
    ix__mv_unref_all(ctx, f, 4);
    ix__mv_unref_all(ctx, rows, 2);
    return st;
}

ix_status ix_crv_one_point(ix_ctx *ctx, const ix_mv *crv, int idx,
                           const double range[2], ix_mv **out)
{
    *out = NULL;
    IX_TRY(check(ctx, crv, idx, range));
    return field(ctx, crv, idx, range, out);
}

/* --- where inflections appear
 * ----------------------------------------------------- */

static bool is_zero(const ix_mv *f)
{
    for (size_t i = 0; i < f->npts; i++)
        if (f->pts[i] < 0 || f->pts[i] > 0)
            return false;
    return true;
}

static ix_status births(ix_ctx *ctx, const ix_mv *f, double tol,
                        ix_solution_curves *out)
{
    const ix_curves_opts o = {.tol = tol};
    ix_status st = IX_OK;
    ix_mv *df;

    IX_TRY(ix_sym_derive(ctx, f, 0, NULL, &df));
    if (is_zero(df)) {
        out->unknowns = 3;
        out->complete = true;
    } else {
        const ix_equation eq[2] = {{.f = f}, {.f = df}};

        st = ix_solve_curves(ctx, 2, eq, &o, out);
    }
    ix_mv_unref(ctx, df);
    return st;
}

ix_status ix_crv_one_point_births(ix_ctx *ctx, const ix_mv *crv, int idx,
                                  const double range[2], double tol,
                                  ix_solution_curves *out)
{
    ix_status st;
    ix_mv *f;

    *out = (ix_solution_curves){.unknowns = 3};
    IX_TRY(ix_crv_one_point(ctx, crv, idx, range, &f));
    st = births(ctx, f, tol, out);
    ix_mv_unref(ctx, f);
    return st;
}

/* --- regions of the plane
 * ---------------------------------------------------------- */

/* Segments at the ends of the domain and at knots, at most two each. */
typedef struct {
    ix_ctx *ctx;
    const ix_mv *f;
    const double *range;
    int n;
    double (*end)[2][2];
} segments;

/* Where the bilinear function (in fact affine) with these values at the corners
 * of the square vanishes, if that is a segment. */
static void add_segment(segments *s, const double v[4])
{
    static const int edge[4][2] = {{0, 1}, {1, 3}, {3, 2}, {2, 0}};
    const double *r = s->range;
    double p[4][2];
    int n = 0;

    for (int e = 0; e < 4; e++) {
        int a = edge[e][0], b = edge[e][1];
        double t = v[a] / (v[a] - v[b]);

        if ((v[a] < 0) == (v[b] < 0))
            continue;
        for (int d = 0; d < 2; d++) {
            int from = d ? a / 2 : a % 2, to = d ? b / 2 : b % 2;

            p[n][d] = r[from] + t * (r[to] - r[from]);
        }
        n++;
    }
    if (n == 2)
        memcpy(s->end[s->n++], p, sizeof *s->end);
}

/* Of the values at t, of the piece on its left (side < 0) or right. */
static ix_status segment_at(segments *s, double t, int side)
{
    const ix_mv *f = s->f;
    double dom[2], v[4];
    ix_mv *part, *at;
    ix_status st;

    ix_mv_domain(f, 0, dom);
    IX_TRY(ix_mv_region(s->ctx, f, 0, side < 0 ? dom[0] : t,
                        side < 0 ? t : dom[1], &part));
    st = ix_mv_layer(s->ctx, part, 0, side < 0 ? ix_mv_length(part, 0) - 1 : 0,
                     &at);
    ix_mv_unref(s->ctx, part);
    IX_TRY(st);
    memcpy(v, at->pts, sizeof v);
    ix_mv_unref(s->ctx, at);
    add_segment(s, v);
    return IX_OK;
}

/* Both ends, and knots at which f or its derivative in t jumps. */
static ix_status all_segments(segments *s)
{
    const ix_dir *d = &s->f->dirs[0];
    double dom[2];

    ix_mv_domain(s->f, 0, dom);
    IX_SCRATCH(s->ctx, s->end, 2 * d->length + 2);
    IX_TRY(segment_at(s, dom[0], 1));
    IX_TRY(segment_at(s, dom[1], -1));
    for (int i = d->order; i < d->length;) {
        int m = 1;

        while (i + m < d->length && d->knots[i + m] <= d->knots[i])
            m++;
        if (m >= d->order - 1)
            IX_TRY(segment_at(s, d->knots[i], 1));
        if (m >= d->order)
            IX_TRY(segment_at(s, d->knots[i], -1));
        i += m;
    }
    return IX_OK;
}

static ix_status give(ix_ctx *ctx, const ix_solution_curves *c,
                      const segments *s, ix_lines *out)
{
    size_t n = 2 * (size_t)s->n, at = 0;

    for (int i = 0; i < c->ncurves; i++)
        n += (size_t)c->curve[i].n;
    IX_TRY(ix__lines_new(ctx, n, out));
    for (int i = 0; i < c->ncurves; i++) {
        for (int k = 0; k < c->curve[i].n; k++, at++) {
            memcpy(out->pt[at], c->curve[i].x + 3 * (size_t)k + 1,
                   2 * sizeof(double));
            out->pt[at][2] = 0;
        }
        out->count[out->n++] = c->curve[i].n;
    }
    for (int i = 0; i < s->n; i++) {
        for (int e = 0; e < 2; e++, at++) {
            memcpy(out->pt[at], s->end[i][e], 2 * sizeof(double));
            out->pt[at][2] = 0;
        }
        out->count[out->n++] = 2;
    }
    return IX_OK;
}

static ix_status regions(ix_ctx *ctx, const ix_mv *f, const double range[2],
                         double tol, bool *complete, ix_lines *out)
{
    segments s = {.ctx = ctx, .f = f, .range = range};
    ix_solution_curves c = {.unknowns = 3};
    ix_status st;

    IX_TRY(all_segments(&s));
    IX_TRY(births(ctx, f, tol, &c));
    *complete = c.complete;
    st = give(ctx, &c, &s, out);
    ix_solution_curves_free(ctx, &c);
    return st;
}

ix_status ix_crv_one_point_regions(ix_ctx *ctx, const ix_mv *crv, int idx,
                                   const double range[2], double tol,
                                   bool *complete, ix_lines *out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;
    ix_mv *f;

    *out = (ix_lines){.n = 0};
    *complete = true;
    IX_TRY(ix_crv_one_point(ctx, crv, idx, range, &f));
    st = regions(ctx, f, range, tol, complete, out);
    ix_mv_unref(ctx, f);
    ix__scratch_release(ctx, mk);
    return st;
}

ix_status ix_crv_one_point_surface(ix_ctx *ctx, const ix_mv *crv, int idx,
                                   const double range[2], int cells,
                                   ix_lines *out)
{
    const int n[3] = {cells, cells, cells};
    ix_status st;
    ix_mv *f;

    *out = (ix_lines){.n = 0};
    IX_TRY(ix_crv_one_point(ctx, crv, idx, range, &f));
    st = ix__iso_surface(ctx, f, n, out);
    ix_mv_unref(ctx, f);
    return st;
}
