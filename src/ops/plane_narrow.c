/* plane_narrow.c - the circle through a place of the border that touches the
 * other set next to it, where both curves nearly touch or cross at a small
 * angle.
 *
 * There kappa = 2 n.v / |v|^2, v from the own foot to the other one, is a
 * quotient of differences that cancel twice: with feet 1e-7 apart nothing is
 * left of it. v is the difference of both points in double-double arithmetic,
 * rounded last, so that n.v is known to 1e-16 of |v|. With v = p t + q n, t the
 * own tangent, and the other curve as q = delta + theta p + k p^2 / 2,
 *
 *   kappa = k + 2 theta / p + 2 delta / p^2 ,
 *
 * a parabola in 1 / p: largest at p = -2 delta / theta if delta < 0. */
#include <math.h>
#include <string.h>

#include "base/dd.h"
#include "ops/plane_walk_impl.h"

/* Where the other set is farther from the own foot, or the other foot would be,
 * double arithmetic has six digits at least of kappa. */
#define NEAR_BY 1e-3
#define REACH   1e-2
/* Curves at smaller angles are parallel (as tangents of a smooth joint in
 * plane_set.c); steeper ones need no help. */
#define PARALLEL 1e-10
#define STEEP    0.2
/* Points nearer than that are one, where the curves are parallel. */
#define COMMON 1e-13

/* --- differences -----------------------------------------------------------
 */

/* sum c_i u^i (1 - u)^(d - i) */
static ix_dd form(int d, const double *c, double u)
{
    ix_dd v = ix__two_sum(1.0, -u), p = {1.0, 0.0}, s = {c[0], 0.0};

    for (int i = 1; i <= d; i++) {
        p = ix__dd_mul(p, (ix_dd){u, 0.0});
        s = ix__dd_add(ix__dd_mul(s, v), ix__dd_mul(p, (ix_dd){c[i], 0.0}));
    }
    return s;
}

typedef struct {
    ix_dd w, x[2];
} point;

static point point_at(const ix__span *sp, double u)
{
    int d = sp->degree;
    point p = {.w = form(d, sp->p, u)};

    for (int k = 0; k < 2; k++)
        p.x[k] = form(d, sp->p + (k + 1) * (d + 1), u);
    return p;
}

/* y - x */
static void difference(const point *x, const point *y, double out[2])
{
    for (int k = 0; k < 2; k++) {
        ix_dd a = ix__dd_mul(y->x[k], x->w), b = ix__dd_mul(x->x[k], y->w);

        out[k] = ix__dd_add(a, ix__dd_neg(b)).hi / (x->w.hi * y->w.hi);
    }
}

/* --- the other curve as seen from the own foot -------------------------------
 */

typedef struct {
    const ix__set *other;
    point c;
    double n[2];
    int span;
    double u;
    double v[2], p, q, m; /* to the point at u, slope there */
    double speed;         /* dp/du */
    double theta, delta;  /* of the parabola that touches there, at p = 0 */
} view;

/* False where the other curve does not run along the own one. */
static bool look(view *a)
{
    const ix__span *sp = &a->other->span[a->span];
    point y = point_at(sp, a->u);
    double d[3][2], k, q2, p2;

    difference(&a->c, &y, a->v);
    ix__span_at(a->other, sp, a->u, d);
    a->p = a->v[0] * a->n[1] - a->v[1] * a->n[0];
    a->q = a->v[0] * a->n[0] + a->v[1] * a->n[1];
    a->speed = d[1][0] * a->n[1] - d[1][1] * a->n[0];
    a->m = (d[1][0] * a->n[0] + d[1][1] * a->n[1]) / a->speed;
    if (!(fabs(a->m) <= STEEP))
        return false;
    p2 = d[2][0] * a->n[1] - d[2][1] * a->n[0];
    q2 = d[2][0] * a->n[0] + d[2][1] * a->n[1];
    k = (q2 - a->m * p2) / (a->speed * a->speed);
    a->theta = a->m - k * a->p;
    a->delta = a->q - a->m * a->p + 0.5 * k * a->p * a->p;
    return true;
}

/* Moves u by that much, into the next span if there is one, to the vertex
 * otherwise. */
static void move(view *a, double du)
{
    double u = a->u + du;

    if (u < 0.0 || u > 1.0) {
        int e = u > 1.0, next = ix__next_span(a->other, a->span, e);

        u = e ? 1.0 : 0.0;
        if (next >= 0) {
            a->span = next;
            u = 1.0 - u;
        }
    }
    a->u = u;
}

/* Where the parabola has kappa stationary: m |v|^2 = 2 (n.v) (t.v + m n.v), m
 * its slope there, is theta p = -2 delta - m q^2 / p. */
static double stationary(const view *a)
{
    double more = fabs(a->q) < 0.5 * fabs(a->p) ? a->m * a->q * a->q / a->p
                                                : 0.0;

    return (-2.0 * a->delta - more) / a->theta;
}

/* Steps end where they are this part of p; a foot that is this near a vertex,
 * as good, is the vertex: where both curves end smoothly in it kappa is
 * stationary there. */
#define SETTLED 1e-9
#define SNAP    1e-7

static bool snap(view *a)
{
    const ix__span *sp = &a->other->span[a->span];
    int e = a->u > 0.5;

    if (sp->vertex[e] < 0 || fabs((a->u - e) * a->speed) > SNAP * fabs(a->p))
        return true;
    a->u = e;
    return look(a);
}

/* To where kappa is stationary, the parabola being taken at each place anew. */
static bool settle(view *a)
{
    for (int i = 0; i < 30; i++) {
        double to, last = a->u;
        int span = a->span;

        if (!(a->delta < 0.0) || !(fabs(a->theta) >= PARALLEL))
            return false;
        to = stationary(a);
        if (!(fabs(to) <= REACH))
            return false;
        move(a, (to - a->p) / a->speed);
        if (!look(a))
            return false;
        if (a->span == span &&
            fabs(a->u - last) * fabs(a->speed) <= SETTLED * fabs(to))
            return snap(a);
    }
    return false;
}

/* --- entry -----------------------------------------------------------------
 */

static point own_point(const ix__set *s, const ix__border *e, double at)
{
    const double *x = s->vertex[e->index].x;

    if (e->kind == IX__SIDE)
        return point_at(&s->span[e->index], e->side > 0 ? at : 1.0 - at);
    return (point){{1.0, 0.0}, {{x[0], 0.0}, {x[1], 0.0}}};
}

static void begin_with(const view *a, ix__sample *o)
{
    double k = 2.0 * a->q / (a->v[0] * a->v[0] + a->v[1] * a->v[1]);

    if (!(k > o->foot.kappa))
        return;
    o->foot = (ix__touch){k, a->span, a->u};
    o->narrow = true;
    memcpy(o->apart, a->v, sizeof o->apart);
}

bool ix__narrow_foot(const ix__walk *w, ix__sample *o)
{
    const ix__border *e = &w->own->border[o->border];
    view a = {.other = w->other, .n = {o->n[0], o->n[1]}};
    ix__touch at;
    double d;

    if (w->own == w->other || !w->meeting ||
        !ix__set_near(w->other, o->c, NEAR_BY))
        return true;
    d = ix__set_distance(w->other, o->c, &at);
    a.c = own_point(w->own, e, o->at);
    a.span = at.span;
    a.u = at.u;
    if (!look(&a))
        return true;
    if (!(fabs(a.theta) >= PARALLEL) || a.delta >= 0.0)
        return d > COMMON; /* in front: the radius is half of that */
    if (settle(&a))
        begin_with(&a, o);
    return true;
}
