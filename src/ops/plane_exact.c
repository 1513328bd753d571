/* plane_exact.c - exact pieces of bisectors: straight ones between two points,
 * rational ones between a point and a curve, conics between lines and circles.
 *
 * A rational piece is computed with its point as origin: coordinates that are
 * large against the distance of both would cost digits in each step, and a
 * weight that is set to zero at infinity would move all of the piece. */
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "iritx/ops_bisect.h"
#include "mv/mv.h"
#include "ops/plane_bisector.h"
#include "ops/plane_conic.h"

/* A first point whose numbers are no larger than this part of the largest is
 * zero: the tangent vanishes there. As in plane_set.c, where points that are
 * that near are one. */
#define VANISHES 1e-11
/* A pole is no farther beyond the last sample of an unbounded piece, in lengths
 * of its last polynomial. */
#define NEAR_POLE 1e-3
/* A piece that is shorter, in parameters of the whole curve, is cut out of one
 * of that length: differences of control points in a short part would be
 * rounding. */
#define SHORT 0.02

typedef struct {
    ix_ctx *ctx;
    const ix__walked *w;
    const ix__object *obj;
} maker;

/* The user's coordinates of a foot that stays. */
static ix_status fixed_foot(const maker *k, const ix_bisector_piece *p, int i,
                            double out[2])
{
    const ix__object *o = &k->obj[i];
    double t = p->foot[i];

    if (o->crv)
        return ix_mv_point(k->ctx, o->crv[p->curve[i]], &t, out);
    memcpy(out, o->point, 2 * sizeof(double));
    return IX_OK;
}

/* --- straight pieces -------------------------------------------------------
 */

static ix_status bezier(ix_ctx *ctx, int order, const double *wxy, ix_mv **out)
{
    ix_dir d = {.basis = IX_BEZIER, .order = order, .length = order};
    double pts[9];

    for (int i = 0; i < order; i++)
        for (int k = 0; k < 3; k++)
            pts[k * order + i] = wxy[3 * i + k];
    return ix_mv_new(ctx, 1, &d, 2, true, pts, out);
}

/* (1, x) of a vertex or (0, direction) at infinity. */
static void straight_end(const ix_bisector_piece *p, int e, double out[3])
{
    const double *x = p->x + (e ? 2 * (p->n - 1) : 0);
    bool far = p->unbounded[e];

    out[0] = far ? 0.0 : 1.0;
    out[1] = far ? p->dir[e][0] : x[0];
    out[2] = far ? p->dir[e][1] : x[1];
}

/* The directions at infinity, normal to the line through the feet a and b: the
 * last sample's is as good as it is far out only. */
static void straight_directions(const double a[2], const double b[2],
                                ix_bisector_piece *p)
{
    double n[2] = {a[1] - b[1], b[0] - a[0]}, len = hypot(n[0], n[1]);

    for (int e = 0; e < 2; e++) {
        double *d = p->dir[e];
        double f = d[0] * n[0] + d[1] * n[1] < 0.0 ? -len : len;

        if (!p->unbounded[e] || !(len > 0.0))
            continue;
        d[0] = n[0] / f;
        d[1] = n[1] / f;
    }
}

static ix_status exact_straight(const maker *k, ix_bisector_piece *p)
{
    double c[9], a[2], b[2];

    IX_TRY(fixed_foot(k, p, 0, a));
    IX_TRY(fixed_foot(k, p, 1, b));
    straight_directions(a, b, p);
    straight_end(p, 0, c);
    straight_end(p, 1, c + 3);
    if (!(p->unbounded[0] && p->unbounded[1]))
        return bezier(k->ctx, 2, c, &p->exact);
    memcpy(c + 6, c + 3, 3 * sizeof(double)); /* a whole line: its middle */
    c[3] = 1.0;
    c[4] = 0.5 * (a[0] + b[0]);
    c[5] = 0.5 * (a[1] + b[1]);
    return bezier(k->ctx, 3, c, &p->exact);
}

/* --- rational pieces -------------------------------------------------------
 */

ix_status ix__plane_moved(ix_ctx *ctx, const ix_mv *m, double f,
                          const double q[2], ix_mv **out)
{
    const double *w = ix_mv_weights(m);
    size_t n = m->npts, first = w ? n : 0;

    IX_TRY(ix__mv_alloc(ctx, 1, m->dirs, 2, m->rational, out));
    if (w)
        memcpy((*out)->pts, w, n * sizeof(double));
    for (size_t k = 0; k < 2; k++)
        for (size_t i = 0; i < n; i++) {
            size_t at = first + k * n + i;

            (*out)->pts[at] = fma(f * q[k], w ? w[i] : ix__mv_one(m, i),
                                  m->pts[at]);
        }
    return IX_OK;
}

/* Index j of the points, counted from end e. */
static size_t from_end(const ix_mv *m, int e, int j)
{
    return e ? m->npts - 1 - (size_t)j : (size_t)j;
}

/* Is the point at end e zero, its weight too? */
static bool zero_end(const ix_mv *m, int e)
{
    double end = 0.0, largest = ix__bern_largest(3 * m->npts, m->pts);

    for (size_t k = 0; k < 3; k++)
        end = fmax(end, fabs(m->pts[k * m->npts + from_end(m, e, 0)]));
    return end <= VANISHES * largest;
}

/* Makes the last polynomial at end e a Bezier one: *m's points there are its
 * own. */
static ix_status isolate(ix_ctx *ctx, int e, ix_mv **m)
{
    const ix_dir *d = &(*m)->dirs[0];
    double knots[IX_MAX_ORDER];
    int at = e ? d->length - 1 : d->order, have = 0;
    ix_mv *next;

    if (d->basis == IX_BEZIER || d->length == d->order)
        return IX_OK;
    for (int i = 0; i < d->length + d->order; i++)
        have += d->knots[i] == d->knots[at];
    for (int i = have; i < d->order - 1; i++)
        knots[i - have] = d->knots[at];
    if (have >= d->order - 1)
        return IX_OK;
    IX_TRY(ix_mv_insert_knots(ctx, *m, 0, d->order - 1 - have, knots, &next));
    ix_mv_unref(ctx, *m);
    *m = next;
    return IX_OK;
}

static ix_status copied(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    IX_TRY(ix__mv_alloc(ctx, 1, m->dirs, 2, true, out));
    memcpy((*out)->pts, m->pts, 3 * m->npts * sizeof(double));
    return IX_OK;
}

/* Where the curve's tangent vanishes at an end all of the homogeneous piece
 * does: there it is divided by the parameter, counted from that end, and
 * multiplied by 1 = u + v. With Bernstein coefficients b, b_0 = 0, of degree n
 * the quotient by u has b_(k+1) n / (k+1), and raised again b_k +
 * b_(k+1) (n-k) / (k+1): the same at the other end. */
static ix_status divide_end(ix_ctx *ctx, int e, ix_mv **m)
{
    int n = (*m)->dirs[0].order - 1;
    ix_mv *out;

    IX_TRY(isolate(ctx, e, m));
    IX_TRY(copied(ctx, *m, &out));
    for (size_t k = 0; k < 3; k++) {
        double *c = out->pts + k * out->npts;

        c[from_end(out, e, 0)] = 0.0;
        for (int i = 0; i < n; i++)
            c[from_end(out, e, i)] += c[from_end(out, e, i + 1)] * (n - i) /
                                      (i + 1);
    }
    ix_mv_unref(ctx, *m);
    *m = out;
    return IX_OK;
}

/* c, Bernstein of degree n with stride step, over [0, 1], over [0, u] now. */
static void cut(int n, double u, ptrdiff_t step, double *c)
{
    for (int j = n; j > 0; j--)
        for (int i = n; i > n - j; i--) /* de Casteljau, the last ones */
            c[i * step] = (1.0 - u) * c[(i - 1) * step] + u * c[i * step];
}

/* Where the weight of the last polynomial at end e is zero, counted from its
 * other end: near 1 by Newton's method; 1 if it is not near. */
static double pole_place(const ix_mv *m, int e)
{
    int n = m->dirs[0].order - 1;
    const double *w = m->pts + from_end(m, e, 0);
    ptrdiff_t step = e ? -1 : 1;
    double slope = n * (w[0] - w[step]), u = 1.0 - w[0] / slope;

    return fabs(u - 1.0) <= NEAR_POLE ? u : 1.0;
}

/* Ends at infinity have no weight. The last sample there is as near to the pole
 * as parameters can tell, which along a short piece is not all digits: the
 * polynomial goes on to the pole itself, its domain stays. */
static ix_status mark_pole(ix_ctx *ctx, int e, ix_mv **m)
{
    int n = (*m)->dirs[0].order - 1;
    ix_mv *out;

    IX_TRY(isolate(ctx, e, m));
    IX_TRY(copied(ctx, *m, &out));
    for (int pass = 0; pass < 2; pass++) {
        double u = pole_place(out, e);

        for (size_t k = 0; k < 3; k++)
            cut(n, u, e ? 1 : -1,
                out->pts + k * out->npts + from_end(out, e, n));
    }
    out->pts[from_end(out, e, 0)] = 0.0;
    ix_mv_unref(ctx, *m);
    *m = out;
    return IX_OK;
}

/* The piece around the origin, its sense and ends set right, moved to q. */
static ix_status orient(ix_ctx *ctx, bool back, const bool far[2],
                        const double q[2], ix_mv **m)
{
    ix_mv *out;

    if (back) {
        IX_TRY(ix_mv_reverse(ctx, *m, 0, &out));
        ix_mv_unref(ctx, *m);
        *m = out;
    }
    for (int e = 0; e < 2; e++) {
        if (zero_end(*m, e))
            IX_TRY(divide_end(ctx, e, m));
        if (far[e])
            IX_TRY(mark_pole(ctx, e, m));
    }
    IX_TRY(ix__plane_moved(ctx, *m, 1.0, q, &out));
    ix_mv_unref(ctx, *m);
    *m = out;
    return IX_OK;
}

/* The parameters [lo, hi] of crv, made longer inside the domain if they are
 * few. */
static void widen(const ix_mv *crv, const double in[2], double out[2])
{
    double dom[2], room;

    ix_mv_domain(crv, 0, dom);
    room = 0.5 * fmax(SHORT * (dom[1] - dom[0]) - (in[1] - in[0]), 0.0);
    out[0] = fmin(fmax(dom[0], in[0] - room), in[0]);
    out[1] = fmax(fmin(dom[1], in[1] + room), in[1]);
}

/* The untrimmed bisector of the origin and the part over t of crv, as seen from
 * q. */
static ix_status around_origin(ix_ctx *ctx, const ix_mv *crv, const double t[2],
                               const double q[2], ix_mv **out)
{
    static const double origin[2] = {0.0, 0.0};
    double u[2] = {t[0], t[1]}, wide[2];
    ix_mv *m, *next;

    widen(crv, t, wide);
    IX_TRY(ix__plane_moved(ctx, crv, -1.0, q, &m));
    IX_TRY(ix__mv_step(ctx, &m, &next,
                       ix_mv_region(ctx, m, 0, wide[0], wide[1], &next)));
    IX_TRY(ix__mv_step(
        ctx, &m, &next,
        ix_pt_crv_bisector(ctx, m, origin, 0.5, NULL, NULL, &next)));
    if (m->dirs[0].basis == IX_BEZIER) /* over [0, 1] now */
        for (int e = 0; e < 2; e++)
            u[e] = (t[e] - wide[0]) / (wide[1] - wide[0]);
    if (wide[0] < t[0] || wide[1] > t[1])
        IX_TRY(ix__mv_step(ctx, &m, &next,
                           ix_mv_region(ctx, m, 0, u[0], u[1], &next)));
    *out = m;
    return IX_OK;
}

/* The parameter of the foot on object i. Feet on a curve are not moved to
 * vertices that are near: pieces end at the vertices of their polylines. */
static double moving_foot(const maker *k, int i, const ix__sample *a)
{
    if (i == 0)
        return ix__own_parameter(k->obj[0].set, a);
    return ix__span_parameter(&k->obj[1].set->span[a->foot.span], a->foot.u);
}

/* The moving foot on object i at both ends of the run: unbounded ones are at
 * infinity to the last digits. */
static void moving_feet(const maker *k, const ix__run *r, int i, double t[2])
{
    for (int e = 0; e < 2; e++)
        t[e] = moving_foot(k, i, ix__run_at(k->w, r, e ? r->count - 1 : 0));
}

/* The rational bisector over the parameters of the moving foot. */
static ix_status exact_rational(const maker *k, const ix__run *r,
                                ix_bisector_piece *p)
{
    int i = p->point[0] ? 1 : 0;
    double q[2], t[2], range[2];

    IX_TRY(fixed_foot(k, p, 1 - i, q));
    moving_feet(k, r, i, t);
    if (t[0] == t[1])
        return IX_OK; /* shorter than rounding */
    range[0] = fmin(t[0], t[1]);
    range[1] = fmax(t[0], t[1]);
    IX_TRY(
        around_origin(k->ctx, k->obj[i].crv[p->curve[i]], range, q, &p->exact));
    return orient(k->ctx, t[0] > t[1], p->unbounded, q, &p->exact);
}

/* --- lines and circles -----------------------------------------------------
 */

/* With crv seen from q. */
static ix_status conic_from(const maker *k, const ix__run *r, const double q[2],
                            ix_mv *const crv[2], bool *straight,
                            ix_bisector_piece *p)
{
    const ix_mv *const both[2] = {crv[0], crv[1]};
    double t[2][2];
    ix_status st;
    ix_mv *m;

    for (int i = 0; i < 2; i++)
        moving_feet(k, r, i, t[i]);
    IX_TRY(ix__bisector_conic(k->ctx, both, t, p, q, straight, &m));
    if (!m)
        return IX_OK;
    st = ix__plane_moved(k->ctx, m, 1.0, q, &p->exact);
    ix_mv_unref(k->ctx, m);
    return st;
}

static ix_status exact_conic(const maker *k, const ix__run *r,
                             ix_bisector_piece *p)
{
    const double *q = p->x + 2 * (p->n / 2);
    ix_mv *crv[2] = {NULL, NULL};
    bool straight = false;
    ix_status st = IX_OK;

    for (int i = 0; i < 2 && st == IX_OK; i++)
        st = ix__plane_moved(k->ctx, k->obj[i].crv[p->curve[i]], -1.0, q,
                             &crv[i]);
    if (st == IX_OK)
        st = conic_from(k, r, q, crv, &straight, p);
    for (int i = 0; i < 2; i++)
        ix_mv_unref(k->ctx, crv[i]);
    IX_TRY(st);
    return straight ? exact_straight(k, p) : IX_OK;
}

ix_status ix__bisector_exact(ix_ctx *ctx, const ix__walked *w,
                             const ix__object obj[2], const ix__run *r,
                             ix_bisector_piece *p)
{
    const maker k = {ctx, w, obj};

    return p->kind == IX_POINT_POINT   ? exact_straight(&k, p)
           : p->kind == IX_POINT_CURVE ? exact_rational(&k, r, p)
                                       : exact_conic(&k, r, p);
}
