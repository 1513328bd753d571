/* offset_match.c - offsets as the sum of a curve and of the point of a circle
 * that has a parallel tangent.
 *
 * The circle is replaced by parabolas, each of which touches it at both ends of
 * an arc from direction a to direction b. Their tangents run through (1 - s) a
 * + s b, so that the parallel to D = A a + B b is at s = B / (A + B): no more
 * than sums and products, exact and of known degree. Points of the parabolas
 * are off the circle, outwards, by a bound that depends on the angle alone. */
#include <math.h>
#include <string.h>

#include "geom/arclen.h"
#include "geom/crvs.h"
#include "geom/marks.h"
#include "geom/parts.h"
#include "geom/pool.h"
#include "geom/vec3.h"
#include "iritx/offset.h"

#define PI 3.14159265358979323846

typedef struct {
    ix_ctx *ctx;
    const ix_mv *crv; /* open B-spline */
    ix__marks m;
    double dist, alpha; /* of one arc */
    double per_length;  /* parameter for a length, at corners */
    int n, room;
    ix_mv **piece;
} match;

/* Takes over p. */
static ix_status add_piece(match *w, ix_mv *p)
{
    if (w->n == w->room) {
        int room = 2 * w->room + 64;
        ix_mv **more = ix__scratch(w->ctx, (size_t)room, sizeof(const ix_mv *));

        if (!more) {
            ix_mv_unref(w->ctx, p);
            return IX_ENOMEM;
        }
        if (w->n)
            memcpy(more, w->piece, (size_t)w->n * sizeof(const ix_mv *));
        w->piece = more;
        w->room = room;
    }
    w->piece[w->n++] = p;
    return IX_OK;
}

/* The parabola of arc j by its control points, their right-hand normals. */
static void parabola(const match *w, int j, double p[3][2])
{
    double far = 1 / (1 + cos(w->alpha));

    for (int k = 0; k < 2; k++) {
        double a = (j + k) * w->alpha; /* direction (cos a, sin a) */

        p[2 * k][0] = sin(a);
        p[2 * k][1] = -cos(a);
    }
    for (int k = 0; k < 2; k++)
        p[1][k] = (p[0][k] + p[2][k]) * far;
}

/* The arc in which a direction lies. */
static int arc_of(const match *w, double angle)
{
    return (int)floor(angle / w->alpha);
}

/* --- pieces along the curve
 * ----------------------------------------------------- */

/* A Bezier scalar without its factor t^lo (1 - t)^hi, raised to its degree
 * again. */
static ix_status without(ix_ctx *ctx, const ix_mv *f, int lo, int hi,
                         ix_mv **out)
{
    int d = ix_mv_order(f, 0) - 1;
    ix_dir dir = {.basis = IX_BEZIER,
                  .order = d + 1 - lo - hi,
                  .length = d + 1 - lo - hi};
    double *c;
    ix_status st;
    ix_mv *low;

    IX_SCRATCH(ctx, c, d + 1);
    memcpy(c, ix_mv_axis(f, 0), ((size_t)d + 1) * sizeof *c);
    for (int k = 0; k < lo; k++, d--) /* C(d, i) / C(d - 1, i - 1) = d / i */
        for (int i = 1; i <= d; i++)
            c[i - 1] = c[i] * d / i;
    for (int k = 0; k < hi; k++, d--)
        for (int i = 0; i < d; i++)
            c[i] *= (double)d / (d - i);
    IX_TRY(ix_mv_new(ctx, 1, &dir, 1, false, c, &low));
    st = ix_mv_raise(ctx, low, 0, ix_mv_order(f, 0), out);
    ix_mv_unref(ctx, low);
    return st;
}

/* How many end coefficients of both are 0, to rounding of the larger ones. */
static int zeros(const ix_mv *const d[2], bool from_end)
{
    int n = (int)ix_mv_npts(d[0]), k = 0;
    double top = 0;

    for (int i = 0; i < n; i++)
        top = fmax(top, hypot(ix_mv_axis(d[0], 0)[i], ix_mv_axis(d[1], 0)[i]));
    while (k < n) {
        int i = from_end ? n - 1 - k : k;

        if (hypot(ix_mv_axis(d[0], 0)[i], ix_mv_axis(d[1], 0)[i]) > 1e-10 * top)
            break;
        k++;
    }
    return k;
}

/* The direction of a Bezier piece, without zeros at its ends. */
static void direction(ix_pool *q, const ix_mv *c, const ix_mv *d[2])
{
    const ix_mv *w = c->rational ? ix__pool_axis(q, c, 0) : NULL;
    int lo, hi;

    for (int k = 0; k < 2; k++) {
        const ix_mv *x = ix__pool_axis(q, c, c->rational + k);

        d[k] = w ? ix__pool_wronskian(q, x, w, 0) : ix__pool_derive(q, x, 0);
    }
    if (q->st != IX_OK)
        return;
    lo = zeros(d, false);
    hi = zeros(d, true);
    if (lo == (int)ix_mv_npts(d[0])) {
        q->st = IX_FAIL(q->ctx, IX_EDOMAIN,
                        "a piece of the curve is a point, without a tangent");
        return;
    }
    for (int k = 0; k < 2 && q->st == IX_OK && lo + hi > 0; k++)
        d[k] = ix__pool_made(q,
                             without(q->ctx, d[k], lo, hi, ix__pool_room(q)));
}

/* The angle of the direction in the middle. */
static double middle_angle(ix_pool *q, const ix_mv *const d[2])
{
    double v[2] = {1, 0}, half = 0.5;

    for (int k = 0; k < 2 && q->st == IX_OK; k++)
        q->st = ix_mv_eval(q->ctx, d[k], &half, &v[k]);
    return atan2(v[1], v[0]);
}

/* v0 f + v1 g. */
static const ix_mv *mix(ix_pool *q, const ix_mv *const d[2], double v0,
                        double v1)
{
    return ix__pool_add(q, ix__pool_scale(q, d[0], v0),
                        ix__pool_scale(q, d[1], v1));
}

/* X (A + B)^2 + dist w (A^2 p0 + 2 A B p1 + B^2 p2) over w (A + B)^2; further
 * coordinates stay. */
static ix_status sum(const match *w, ix_pool *q, const ix_mv *c, int j,
                     const ix_mv *const d[2], ix_mv **out)
{
    const ix_mv *a = mix(q, d, sin((j + 1) * w->alpha),
                         -cos((j + 1) * w->alpha));
    const ix_mv *b = mix(q, d, -sin(j * w->alpha), cos(j * w->alpha));
    const ix_mv *ab = ix__pool_add(q, a, b), *s2 = ix__pool_mul(q, ab, ab);
    const ix_mv *part[3] = {ix__pool_mul(q, a, a), ix__pool_mul(q, a, b),
                            ix__pool_mul(q, b, b)};
    const ix_mv *axis[IX_MAX_COORDS + 1];
    const ix_mv *wt = c->rational ? ix__pool_axis(q, c, 0) : NULL;
    double p[3][2];

    parabola(w, j, p);
    axis[0] = wt ? ix__pool_mul(q, wt, s2) : s2;
    for (int k = 0; k < c->ncoords; k++) {
        axis[k + 1] = ix__pool_mul(q, ix__pool_axis(q, c, c->rational + k), s2);
        if (k < 2) {
            const ix_mv *move = ix__pool_add(
                q, mix(q, part, w->dist * p[0][k], 2 * w->dist * p[1][k]),
                ix__pool_scale(q, part[2], w->dist * p[2][k]));

            axis[k + 1] = ix__pool_add(q, axis[k + 1],
                                       wt ? ix__pool_mul(q, wt, move) : move);
        }
    }
    return q->st == IX_OK
               ? ix_mv_join_scalars(w->ctx, c->ncoords + 1, axis, true, out)
               : q->st;
}

static ix_status offset_piece(const match *w, const ix_mv *bezier, ix_mv **out)
{
    ix_pool q = {.ctx = w->ctx};
    const ix_mv *d[2];
    ix_status st;
    double angle;

    direction(&q, bezier, d);
    angle = middle_angle(&q, d);
    st = q.st == IX_OK ? sum(w, &q, bezier, arc_of(w, angle), d, out) : q.st;
    ix__pool_free(&q);
    return st;
}

/* From t0 to t1, within one span and one arc. */
static ix_status along(match *w, double t0, double t1)
{
    ix_mv_pieces p = {0};
    ix_mv *part, *moved = NULL, *here = NULL;
    ix_status st;

    IX_TRY(ix_mv_region(w->ctx, w->crv, 0, t0, t1, &part));
    st = ix_mv_to_bezier(w->ctx, part, &p);
    if (st == IX_OK && p.count != 1)
        st = IX_FAIL(w->ctx, IX_EUNABLE, "a knot within 1e-9 of %g", t0);
    if (st == IX_OK)
        st = offset_piece(w, p.piece[0], &moved);
    if (st == IX_OK)
        st = ix_mv_reparam(w->ctx, moved, 0, t0, t1, &here);
    ix_mv_pieces_free(w->ctx, &p);
    ix_mv_unref(w->ctx, part);
    ix_mv_unref(w->ctx, moved);
    return st == IX_OK ? add_piece(w, here) : st;
}

/* --- around corners
 * ------------------------------------------------------------- */

/* The part of one parabola between two directions, about the corner c. */
static ix_status fan(match *w, const double *c, double from, double to)
{
    int j = arc_of(w, (from + to) / 2), n = w->crv->ncoords;
    const ix_dir dir = {.basis = IX_BEZIER, .order = 3, .length = 3};
    double s[2], p[3][2], pts[3 * IX_MAX_COORDS];
    double len = fabs(w->dist * (to - from)) * w->per_length;
    ix_mv *arc, *here;
    ix_status st;

    parabola(w, j, p);
    for (int k = 0; k < 2; k++) {
        double at = k ? to : from, a = sin((j + 1) * w->alpha - at),
               b = sin(at - j * w->alpha);

        s[k] = b / (a + b);
    }
    for (int i = 0; i < 3; i++) { /* the blossom at (s0, s0), (s0, s1), (s1, s1)
                                   */
        double u = s[i == 2], v = s[i > 0];

        for (int k = 0; k < n; k++)
            pts[i + 3 * k] = c[k] +
                             (k < 2 ? w->dist * ((1 - u) * (1 - v) * p[0][k] +
                                                 (u + v - 2 * u * v) * p[1][k] +
                                                 u * v * p[2][k])
                                    : 0);
    }
    IX_TRY(ix_mv_new(w->ctx, 1, &dir, n, false, pts, &arc));
    st = ix_mv_reparam(w->ctx, arc, 0, 0, len, &here);
    ix_mv_unref(w->ctx, arc);
    return st == IX_OK ? add_piece(w, here) : st;
}

/* From one tangent to the next, the shorter way; both ways as long: to the
 * left. */
static ix_status corner(match *w, const double *c, const double u[3],
                        const double v[3])
{
    double turn = atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
    double from = atan2(u[1], u[0]), to;

    if (fabs(turn) <= 1e-6 || !(w->dist > 0 || w->dist < 0))
        return IX_OK;
    if (turn < -PI + 1e-9)
        turn = PI;
    to = from + turn;
    while (turn > 0 ? to - from > 1e-9 : from - to > 1e-9) {
        double edge = turn > 0 ? (floor(from / w->alpha + 1e-9) + 1) * w->alpha
                               : (ceil(from / w->alpha - 1e-9) - 1) * w->alpha;
        double next = turn > 0 ? fmin(edge, to) : fmax(edge, to);

        if (fabs(to - next) <= 1e-9)
            next = to;
        IX_TRY(fan(w, c, from, next));
        from = next;
    }
    return IX_OK;
}

static ix_status tangent(const match *w, int span, double t, bool arriving,
                         double u[3])
{
    if (ix__path_tangent3(&w->m.path, span, t, arriving, u))
        return IX_OK;
    return IX_FAIL(w->ctx, IX_EDOMAIN, "no tangent at %g", t);
}

/* Between the pieces that end and begin at parameters t0 and t1, which are one
 * or the seam. */
static ix_status turn_at(match *w, double t0, int s0, double t1, int s1)
{
    double u[3], v[3], c[IX_MAX_COORDS];

    IX_TRY(tangent(w, s0, t0, true, u));
    IX_TRY(tangent(w, s1, t1, false, v));
    ix__path_point(&w->m.path, t0, c);
    return corner(w, c, u, v);
}

/* --- the whole -------------------------------------------------------------
 */

/* Where the tangent has one of the directions between arcs; all breaks. */
static ix_status mark_arcs(match *w, int half)
{
    const double zero[2] = {0, 0};

    for (int j = 0; j < half; j++) {
        const double n[2] = {sin(j * w->alpha), -cos(j * w->alpha)};

        IX_TRY(ix__marks_add_line(&w->m, zero, n, true));
    }
    for (int s = 1; s < w->m.path.nspans; s++)
        IX_TRY(ix__marks_add(&w->m, w->m.path.breaks[s]));
    ix__marks_sort(&w->m);
    return IX_OK;
}

static bool closed(const match *w)
{
    double p[IX_MAX_COORDS], q[IX_MAX_COORDS];

    ix__path_point(&w->m.path, w->m.dom[0], p);
    ix__path_point(&w->m.path, w->m.dom[1], q);
    return hypot(p[0] - q[0], p[1] - q[1]) <= 1e-9 * w->m.size;
}

static ix_status all_pieces(match *w)
{
    const ix_path *p = &w->m.path;
    const double *t = w->m.t;
    int last = -1;

    for (int i = 0; i + 1 < w->m.n; i++) {
        int s = ix__path_span(p, (t[i] + t[i + 1]) / 2);

        IX_TRY(ix__poll(w->ctx));
        if (i > 0)
            IX_TRY(turn_at(w, t[i], last, t[i], s));
        IX_TRY(along(w, t[i], t[i + 1]));
        last = s;
    }
    return closed(w) ? turn_at(w, w->m.dom[1], p->nspans - 1, w->m.dom[0], 0)
                     : IX_OK;
}

/* Neighbours are joined, then neighbours of these, ... */
static ix_status join_all(match *w)
{
    while (w->n > 1) {
        int n = 0;

        for (int i = 0; i < w->n; i += 2) {
            ix_mv *both = w->piece[i];
            ix_status st = IX_OK;

            if (i + 1 < w->n) {
                st = ix_mv_merge(w->ctx, w->piece[i], w->piece[i + 1], 0,
                                 IX_JOIN_SHARED, &both);
                IX_TRY(st);
                ix_mv_unref(w->ctx, w->piece[i]);
                ix_mv_unref(w->ctx, w->piece[i + 1]);
                w->piece[i] = w->piece[i + 1] = NULL;
            }
            w->piece[i] = NULL;
            w->piece[n++] = both;
        }
        w->n = n;
    }
    return IX_OK;
}

static ix_status run(match *w, ix_mv **out)
{
    ix_status st = all_pieces(w);
    int n = w->n;

    if (st == IX_OK)
        st = join_all(w);
    if (st == IX_OK)
        *out = ix_mv_ref(w->piece[0]);
    for (int i = 0; i < (st == IX_OK ? w->n : n); i++)
        ix_mv_unref(w->ctx, w->piece[i]);
    return st;
}

static ix_status offset(ix_ctx *ctx, const ix_mv *crv, double distance,
                        double angle, double *err, ix_mv **out)
{
    match w = {.ctx = ctx, .crv = crv, .dist = distance};
    int half = (int)ceil(PI / angle - 1e-9);
    double len;

    w.alpha = PI / half;
    IX_TRY(ix__marks_ends(ctx, crv, &w.m));
    len = ix__path_length(&w.m.path, w.m.dom[0], w.m.dom[1]);
    if (!(len > 0))
        return IX_FAIL(ctx, IX_EDOMAIN, "the curve is a point");
    w.per_length = (w.m.dom[1] - w.m.dom[0]) / len;
    IX_TRY(mark_arcs(&w, half));
    if (err) /* in the middle of a parabola */
        *err = fabs(distance) *
               ((cos(w.alpha / 2) + 1 / cos(w.alpha / 2)) / 2 - 1);
    return run(&w, out);
}

ix_status ix_crv_offset_match(ix_ctx *ctx, const ix_mv *crv, double distance,
                              double angle, double *err, ix_mv **out)
{
    ix_mv *b, *open = NULL;
    ix_mark mk;
    ix_status st;

    *out = NULL;
    IX_TRY(ix__check_planar(ctx, crv));
    if (!isfinite(distance) || !(angle >= 1e-3) || !(angle <= PI / 2 + 1e-9))
        return IX_FAIL(ctx, IX_EARG,
                       "a distance of %g, arcs of %g radians; 0.001 to a right "
                       "angle are possible",
                       distance, angle);
    IX_TRY(ix_mv_to_bspline(ctx, crv, &b));
    st = ix_mv_to_open(ctx, b, &open);
    mk = ix__scratch_mark(ctx);
    if (st == IX_OK)
        st = offset(ctx, open, distance, angle, err, out);
    ix__scratch_release(ctx, mk);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, open);
    return st;
}
