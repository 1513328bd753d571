/* pln_bisect.c - the bisector of coplanar curves by way of space: one of them
 * is lifted or tilted out of the plane, and the bisector surface cut with the
 * plane halfway between.
 *
 * Lifted by e, points of the plane z = e / 2 are as far from both curves as
 * their projections, but for e^2 / 4 on both sides: the cut is the untrimmed
 * bisector itself. Tilted by an angle e about a line, what is 2 y b in the
 * squared distance of points at y and b from that line becomes 2 y b cos(e / 2)
 * for both: the cut deviates by O(e^2). */
#include <math.h>

#include "geom/angle.h"
#include "geom/lines.h"
#include "geom/parts.h"
#include "iritx/contour.h"
#include "iritx/ops.h"
#include "iritx/ops_plane.h"
#include "mv/mv.h"
#include "ops/plane_bisector.h"
#include "sym/form.h"

typedef struct {
    ix_ctx *ctx;
    double eps; /* distance, or angle in radians */
    bool lift;
    double y;        /* of the line that is tilted about */
    double plane[4]; /* halfway */
    double size;
    const ix_mv *crv[2]; /* in the plane */
} tilt;

/* c in space, moved the whole way. */
static ix_status move(const tilt *k, const ix_mv *c, ix_mv **out)
{
    double co = cos(k->eps), si = sin(k->eps);
    double lift[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, k->eps, 1};
    double turn[16] = {1,          0, 0,   0,  0, co, si,
                       0,          0, -si, co, 0, 0,  k->y - k->y * co,
                       -k->y * si, 1};
    ix_mv *space;
    ix_status st;

    IX_TRY(ix_mv_coerce(k->ctx, c, 3, c->rational, &space));
    st = ix_mv_transform(k->ctx, space, k->lift ? lift : turn, out);
    ix_mv_unref(k->ctx, space);
    return st;
}

/* A point of the plane halfway back in the plane. */
static void flatten(const tilt *k, const double x[3], double out[3])
{
    double y = x[1] - k->y, h = 0.5 * k->eps;

    out[0] = x[0];
    out[1] = k->lift ? x[1] : k->y + y * cos(h) + x[2] * sin(h);
    out[2] = 0.0;
}

/* Is x equally far from the points of both curves, as far as the method goes?
 * Where the surface passes through infinity its points have no digits. */
static bool is_good(const tilt *k, const double *st, const double x[3])
{
    double h = 0.5 * k->eps, p[2], d[2];
    double tol = (k->lift ? 1e-6 : 1e-6 + 4.0 * h * h) * k->size;

    for (int i = 0; i < 2; i++) {
        if (ix_mv_point(k->ctx, k->crv[i], &st[i], p) != IX_OK)
            return false;
        d[i] = hypot(x[0] - p[0], x[1] - p[1]);
    }
    return fabs(d[0] - d[1]) <= tol;
}

static ix_status collect(const tilt *k, const ix_mv *s,
                         const ix_solution_curves *c, ix_lines *out)
{
    size_t total = 0, used = 0;

    for (int i = 0; i < c->ncurves; i++)
        total += (size_t)c->curve[i].n;
    IX_TRY(ix__lines_new(k->ctx, total, out));
    for (int i = 0; i < c->ncurves; i++) {
        out->count[out->n] = 0;
        for (int j = 0; j < c->curve[i].n; j++) {
            double x[3];
            ix_status st = ix_mv_point(k->ctx, s, c->curve[i].x + 2 * j, x);

            if (st == IX_EDOMAIN)
                continue; /* a pole */
            IX_TRY(st);
            flatten(k, x, out->pt[used]);
            if (!is_good(k, c->curve[i].x + 2 * j, out->pt[used]))
                continue;
            used++;
            out->count[out->n]++;
        }
        if (out->count[out->n] > 1)
            out->n++;
        else
            used -= (size_t)out->count[out->n];
    }
    return IX_OK;
}

static ix_status cut(const tilt *k, const ix_mv *a, const ix_mv *b, double tol,
                     ix_lines *out)
{
    ix_solution_curves c = {0};
    ix_status st;
    ix_mv *s;

    IX_TRY(ix_cbisector3d(k->ctx, a, b, NULL, NULL, &s));
    st = ix_contour(k->ctx, s, k->plane, tol, &c);
    if (st == IX_OK)
        st = collect(k, s, &c, out);
    ix_solution_curves_free(k->ctx, &c);
    ix_mv_unref(k->ctx, s);
    return st;
}

/* --- the error -------------------------------------------------------------
 */

static double off_lines(const ix_lines *l, const double *q)
{
    const double(*p)[3] = (const double(*)[3])l->pt;
    double best = (double)INFINITY;

    for (int i = 0; i < l->n; p += l->count[i], i++)
        for (int j = 0; j + 1 < l->count[i]; j++) {
            double d[2] = {p[j + 1][0] - p[j][0], p[j + 1][1] - p[j][1]};
            double e[2] = {q[0] - p[j][0], q[1] - p[j][1]};
            double len = d[0] * d[0] + d[1] * d[1], t = 0.0;

            if (len > 0.0)
                t = fmin(fmax((d[0] * e[0] + d[1] * e[1]) / len, 0.0), 1.0);
            best = fmin(best, hypot(e[0] - t * d[0], e[1] - t * d[1]));
        }
    return best;
}

/* Largest distance of a curve/curve vertex of the true bisector near the
 * curves from the lines. */
static ix_status compare(const tilt *k, const ix_mv *c1, const ix_mv *c2,
                         const ix_lines *l, double *error)
{
    const ix_mv *const a[1] = {c1}, *const b[1] = {c2};
    ix_bisector s;

    IX_TRY(ix_bisect_crv_crv(k->ctx, 1, a, 1, b, 0, &s));
    *error = 0.0;
    for (int i = 0; i < s.n; i++)
        for (int j = 0; s.piece[i].kind == IX_CURVE_CURVE && j < s.piece[i].n;
             j++)
            if (s.piece[i].r[j] <= 2.0 * s.size)
                *error = fmax(*error, off_lines(l, s.piece[i].x + 2 * j));
    ix_bisector_free(k->ctx, &s);
    return IX_OK;
}

/* --- entry -----------------------------------------------------------------
 */

static ix_status prepare(tilt *k, const ix_mv *const *c)
{
    double h = 0.5 * k->eps;
    ix_frame frame;

    IX_TRY(ix__frame_of(k->ctx, 2, c, &frame));
    k->y = frame.shift[1];
    k->size = ldexp(1.0, frame.exp);
    k->crv[0] = c[0];
    k->crv[1] = c[1];
    k->plane[0] = 0.0;
    k->plane[1] = k->lift ? 0.0 : -sin(h);
    k->plane[2] = k->lift ? 1.0 : cos(h);
    k->plane[3] = k->lift ? -h : k->y * sin(h);
    return IX_OK;
}

static ix_status run(tilt *k, const ix_mv *const *c, double tol, ix_lines *out,
                     double *error)
{
    ix_mv *space, *moved;
    ix_status st;

    IX_TRY(prepare(k, c));
    IX_TRY(ix_mv_coerce(k->ctx, c[0], 3, c[0]->rational, &space));
    st = move(k, c[1], &moved);
    if (st == IX_OK) {
        st = cut(k, space, moved, tol, out);
        ix_mv_unref(k->ctx, moved);
    }
    ix_mv_unref(k->ctx, space);
    if (st == IX_OK && error)
        st = compare(k, c[0], c[1], out, error);
    if (st != IX_OK)
        ix_lines_free(k->ctx, out);
    return st;
}

static ix_status scoped(tilt *k, const ix_mv *const *c, double tol,
                        ix_lines *out, double *error)
{
    ix_mv **flat;
    ix_status st;

    IX_TRY(ix__bisector_tol(k->ctx, tol, &tol));
    IX_TRY(ix__plane_curves(k->ctx, 2, c, &flat));
    st = run(k, (const ix_mv *const *)flat, tol, out, error);
    ix__mv_unref_all(k->ctx, flat, 2);
    return st;
}

ix_status ix_pln_bisect(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                        double eps, bool lift, double tol, ix_lines *out,
                        double *error)
{
    tilt k = {.ctx = ctx, .eps = lift ? eps : IX__RADIANS(eps), .lift = lift};
    const ix_mv *const c[2] = {c1, c2};

    *out = (ix_lines){0};
    if (!(fabs(eps) > 0.0 && isfinite(eps)) || (!lift && fabs(eps) >= 90.0))
        return IX_FAIL(ctx, IX_EARG,
                       lift ? "a distance of %g: not 0, and finite"
                            : "an angle of %g degrees: not 0, below 90",
                       eps);
    IX_RETURN_SCOPED(ctx, scoped(&k, c, tol, out, error));
}
