/* plane_sample.c - one place of the border and the circle that touches there,
 * what neighbours have in common, and places of the border seen from centres.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ops/plane_walk_impl.h"

/* With one set for both, feet on a smooth curve that are nearer than this part
 * of the radius count as one: the depth between them is of fourth order, so
 * that they are not known to more than (1e-14)^(1/4), and a margin. */
#define ONE_FOOT 1e-2
/* With two sets, feet nearer than this part of the radius are looked at: what
 * is beside the centre tells whether it is on the bisector. */
#define TOUCHING   4e-3
#define NEXT       1e-8 /* steps aside are as long as that, and ten times more */
#define ASIDE      1e-5  /* so far beside, below any tolerance that is usual */
#define ASIDE_FAR  1e-2  /* times the radius: there the bisector is straight */
#define TOLD_APART 2e-14 /* distances differ by more than their rounding */
/* A radius below this counts as a point that both sets have in common. */
#define COMMON 1e-13

/* --- one sample ------------------------------------------------------------
 */

void ix__own_frame(const ix__set *s, const ix__border *e, double at,
                   ix__sample *o)
{
    double d[3][2], t[2], angle;
    const ix__span *sp;
    double u;

    if (e->kind == IX__FAN) {
        angle = e->from + at * (e->to - e->from);
        memcpy(o->c, s->vertex[e->index].x, sizeof o->c);
        o->n[0] = cos(angle);
        o->n[1] = sin(angle);
        return;
    }
    sp = &s->span[e->index];
    u = e->side > 0 ? at : 1.0 - at;
    ix__span_at(s, sp, u, d);
    ix__span_tangent(s, sp, u, t);
    memcpy(o->c, d[0], sizeof o->c);
    o->n[0] = -e->side * t[1];
    o->n[1] = e->side * t[0];
}

/* The curvature of the own border towards n: 0 if it bends away or is a
 * vertex. */
static double own_curvature(const ix__set *s, const ix__border *e, double at)
{
    double d[3][2], v2, k;
    const ix__span *sp = &s->span[e->index];

    if (e->kind == IX__FAN)
        return 0.0;
    ix__span_at(s, sp, e->side > 0 ? at : 1.0 - at, d);
    v2 = d[1][0] * d[1][0] + d[1][1] * d[1][1];
    k = e->side * (d[1][0] * d[2][1] - d[1][1] * d[2][0]) / (v2 * sqrt(v2));
    return k > 0.0 ? k : 0.0;
}

static void set_apart(ix__sample *o)
{
    for (int k = 0; k < 2 && !o->narrow; k++)
        o->apart[k] = o->x[k] - o->c[k];
}

/* The other foot: vertex or side of a span. */
static void other_foot(const ix__set *s, ix__sample *o)
{
    const ix__span *sp = &s->span[o->foot.span];
    double d[3][2], t[2], u = o->foot.u;

    o->vertex = u <= 0.0 ? sp->vertex[0] : u >= 1.0 ? sp->vertex[1] : -1;
    o->side = 0;
    if (o->vertex >= 0) {
        memcpy(o->x, s->vertex[o->vertex].x, sizeof o->x);
        set_apart(o);
        return;
    }
    ix__span_at(s, sp, u, d);
    memcpy(o->x, d[0], sizeof o->x);
    set_apart(o);
    ix__span_tangent(s, sp, u, t);
    o->side = t[0] * (o->b[1] - o->x[1]) - t[1] * (o->b[0] - o->x[0]) > 0.0
                  ? 1
                  : -1;
}

/* Is the foot one that both sets have in common? */
static bool in_common(const ix__walk *w, const ix__sample *o)
{
    return w->own != w->other && o->vertex >= 0 &&
           w->other->vertex[o->vertex].shared;
}

/* Derivative of the own side: unit tangent in the sense of the walk, |x'|, and
 * the curvature towards n; of a fan the turn of n, by which b moves as from a
 * tangent at distance r. */
static void own_motion(const ix__set *s, const ix__border *e,
                       const ix__sample *o, double t[2], double *move)
{
    double d[3][2], v, k;

    if (e->kind == IX__FAN) {
        v = e->to > e->from ? 1.0 : -1.0;
        t[0] = -v * o->n[1];
        t[1] = v * o->n[0];
        *move = o->r * fabs(e->to - e->from);
        return;
    }
    ix__span_at(s, &s->span[e->index], e->side > 0 ? o->at : 1.0 - o->at, d);
    v = hypot(d[1][0], d[1][1]);
    k = (d[2][0] * o->n[0] + d[2][1] * o->n[1]) / (v * v);
    t[0] = e->side * d[1][0] / v;
    t[1] = e->side * d[1][1] / v;
    *move = v * fabs(1.0 - k * o->r);
}

/* How fast b and the other foot move: b along the line that halves the angle
 * of both radii, its part along a tangent being (1 - kappa r) times the motion
 * of the foot. */
static void motion(const ix__walk *w, const ix__border *e, ix__sample *o)
{
    const ix__span *sp = &w->other->span[o->foot.span];
    double t[2], move, m[2], d[3][2], v, along, k, len;
    double n[2] = {o->n[0] - o->apart[0] / o->r, o->n[1] - o->apart[1] / o->r};

    o->speed = 0.0; /* of a circle of curvature: along the evolute, slowly */
    o->rate = e->side;
    if (o->own_circle)
        return;
    own_motion(w->own, e, o, t, &move);
    m[0] = n[1] - o->n[1]; /* normal to the difference of both normals */
    m[1] = o->n[0] - n[0];
    len = hypot(m[0], m[1]);
    if (len < 1.0) {
        m[0] = o->n[0] + n[0];
        m[1] = o->n[1] + n[1];
        len = hypot(m[0], m[1]);
    }
    o->along[0] = m[0] / len;
    o->along[1] = m[1] / len;
    along = o->along[0] * t[0] + o->along[1] * t[1];
    o->speed = move / fabs(along);
    o->rate = 0.0;
    if (o->vertex >= 0)
        return;
    ix__span_at(w->other, sp, o->foot.u, d);
    v = hypot(d[1][0], d[1][1]);
    k = (d[2][0] * n[0] + d[2][1] * n[1]) / (v * v);
    o->rate = move / along * ((m[0] * d[1][0] + m[1] * d[1][1]) / (len * v)) /
              (v * (1.0 - k * o->r));
}

/* Distance from the own set less that from the other one, along from b. */
static double beside(const ix__walk *w, const ix__sample *o, const double m[2],
                     double along)
{
    double x[2] = {o->b[0] + along * m[0], o->b[1] + along * m[1]};

    return ix__set_distance(w->own, x, NULL) -
           ix__set_distance(w->other, x, NULL);
}

/* Where both feet are near each other, the curves going on from one another or
 * crossing at a small angle: is one side of b nearer to the one set and the
 * other side to the other, as near to b as that can be told from rounding? */
static bool separates(const ix__walk *w, const ix__sample *o)
{
    double m[2] = {o->apart[0], o->apart[1]};
    double len = hypot(m[0], m[1]), size = fmax(o->r, 1.0);
    double most = (o->r > IX__FAR ? ASIDE_FAR : ASIDE) * size;

    if (!(len > 0.0))
        return false;
    m[0] /= len;
    m[1] /= len;
    for (double h = NEXT * size; h <= 1.001 * most; h *= 10.0) {
        double own = -beside(w, o, m, -h), other = beside(w, o, m, h);

        if (fmin(fabs(own), fabs(other)) > TOLD_APART * size)
            return own > 0.0 && other > 0.0;
    }
    return false;
}

bool ix__near_feet(const ix__sample *a)
{
    return hypot(a->apart[0], a->apart[1]) <= TOUCHING * fmin(a->r, 1.0);
}

/* Are both feet one as far as can be told? */
static bool one_point(const ix__walk *w, const ix__sample *o)
{
    return w->own != w->other && w->meeting && !o->narrow && ix__near_feet(o) &&
           !separates(w, o);
}

double ix__foot_way(const ix__set *s, const ix__touch *a, const ix__touch *b)
{
    const ix__strand *st = &s->strand[s->span[a->span].strand];
    int step, i = a->span, n = st->count;
    double d = (b->span - a->span) + (b->u - a->u);

    if (s->span[b->span].strand != s->span[a->span].strand)
        return INFINITY;
    if (st->closed && fabs(d) > 0.5 * n)
        d -= d > 0.0 ? n : -n;
    step = d > 0.0 ? 1 : -1;
    while (i != b->span) {
        if (s->span[i].vertex[step > 0] >= 0)
            return INFINITY;
        i = st->first + (i - st->first + step + n) % n;
    }
    return d;
}

static bool one_foot(const ix__walk *w, const ix__border *e,
                     const ix__sample *o)
{
    ix__touch own = {0.0, e->index, e->side > 0 ? o->at : 1.0 - o->at};

    if (w->own != w->other || e->kind == IX__FAN || o->vertex >= 0)
        return false;
    return w->own->span[own.span].strand == w->own->span[o->foot.span].strand &&
           hypot(o->x[0] - o->c[0], o->x[1] - o->c[1]) <= ONE_FOOT * o->r &&
           isfinite(ix__foot_way(w->own, &own, &o->foot));
}

static void judge(const ix__walk *w, const ix__border *e, ix__sample *o)
{
    bool side = e->kind == IX__SIDE;
    ix__touch block = {.kappa = o->foot.kappa,
                       .span = side ? e->index : -1,
                       .u = e->side > 0 ? o->at : 1.0 - o->at};

    o->r = 1.0 / o->foot.kappa;
    if (!(o->r > COMMON) || w->other->span[o->foot.span].phantom)
        return;
    for (int k = 0; k < 2; k++)
        o->b[k] = o->c[k] + o->r * o->n[k];
    other_foot(w->other, o);
    if (in_common(w, o) || one_point(w, o))
        return;
    if (w->own != w->other &&
        ix__set_blocks(w->own, o->c, o->n, IX__OWN_DEPTH, &block)) {
        o->foot = block;
        o->blocked = true;
        return;
    }
    o->valid = true;
    o->own_circle = o->own_circle || one_foot(w, e, o);
    motion(w, e, o);
}

void ix__walk_sample_near(const ix__walk *w, int border, double at,
                          const ix__touch *foot, ix__sample *out)
{
    const ix__border *e = &w->own->border[border];
    ix__sample o = {.border = border, .at = at, .vertex = -1};
    ix__touch next;

    *out = o;
    if (e->kind == IX__FAN && w->own->vertex[e->index].shared)
        return; /* all centres have this vertex as foot on both */
    ix__own_frame(w->own, e, at, &o);
    if (!isfinite(o.c[0] + o.c[1] + o.n[0] + o.n[1]))
        return;
    o.foot = (ix__touch){.span = -1};
    if (w->own == w->other) {
        o.foot.kappa = own_curvature(w->own, e, at);
        if (!isfinite(o.foot.kappa))
            return;
    }
    if (!ix__narrow_foot(w, &o))
        return;
    next = o.foot;
    ix__set_touch_near(w->other, o.c, o.n, IX__DEPTH, foot, &o.foot);
    o.narrow = o.narrow && o.foot.span == next.span && o.foot.u == next.u;
    if (o.foot.span < 0 && w->own == w->other && o.foot.kappa > 0.0) {
        o.own_circle = true;
        o.foot.span = e->index;
        o.foot.u = e->side > 0 ? at : 1.0 - at;
    }
    if (o.foot.span < 0)
        o.far = true;
    else
        judge(w, e, &o);
    *out = o;
}

void ix__walk_sample(const ix__walk *w, int border, double at, ix__sample *out)
{
    ix__walk_sample_near(w, border, at, NULL, out);
}

/* --- neighbours -------------------------------------------------------------
 */

bool ix__passes_seam(const ix__walk *w, const ix__sample *a,
                     const ix__sample *b)
{
    const ix__set *s = w->other;
    const ix__border *e = &w->own->border[a->border];
    const ix__strand *st = &s->strand[s->span[a->foot.span].strand];
    double d = (b->foot.span - a->foot.span) + (b->foot.u - a->foot.u);

    if (w->own == w->other)
        return false;
    if (a->vertex < 0 && st->closed && fabs(d) > 0.5 * st->count)
        return true;
    return e->kind == IX__SIDE &&
           (b->border < a->border || (b->border == a->border && b->at < a->at));
}

bool ix__same_feet(const ix__walk *w, const ix__sample *a, const ix__sample *b)
{
    return a->vertex == b->vertex && a->side == b->side &&
           a->own_circle == b->own_circle &&
           w->other->span[a->foot.span].strand ==
               w->other->span[b->foot.span].strand;
}

bool ix__walk_turns(const ix__walk *w, const ix__sample *a, const ix__sample *b)
{
    const ix__sample *s[2] = {a, b};
    double d[2];

    if (w->own != w->other || a->vertex >= 0 || a->own_circle)
        return false;
    for (int i = 0; i < 2; i++) {
        const ix__border *e = &w->own->border[s[i]->border];
        ix__touch own = {0.0, e->index,
                         e->side > 0 ? s[i]->at : 1.0 - s[i]->at};

        if (e->kind == IX__FAN || w->own->span[own.span].strand !=
                                      w->own->span[s[i]->foot.span].strand)
            return false;
        d[i] = ix__foot_way(w->own, &own, &s[i]->foot);
        if (!(fabs(d[i]) <=
              0.25 * w->own->strand[w->own->span[own.span].strand].count))
            return false;
    }
    return d[0] * d[1] < 0.0;
}

/* --- places ----------------------------------------------------------------
 */

static bool fan_place(const ix__set *s, int vertex, const double d[2],
                      ix__place *out)
{
    for (int i = 0; i < s->nborders; i++) {
        const ix__border *e = &s->border[i];
        double a;

        if (e->kind != IX__FAN || e->index != vertex)
            continue;
        a = remainder(atan2(d[1], d[0]) - 0.5 * (e->from + e->to),
                      2.0 * 3.14159265358979323846) +
            0.5 * (e->from + e->to);
        a = (a - e->from) / (e->to - e->from);
        if (!(a >= -1e-9 && a <= 1.0 + 1e-9))
            continue;
        *out = (ix__place){i, fmin(fmax(a, 0.0), 1.0)};
        return true;
    }
    return false;
}

bool ix__border_place(const ix__set *s, const ix__touch *foot,
                      const double b[2], ix__place *out)
{
    const ix__span *sp = &s->span[foot->span];
    double x[3][2], t[2], d[2];
    int v = foot->u <= 0.0   ? sp->vertex[0]
            : foot->u >= 1.0 ? sp->vertex[1]
                             : -1;

    ix__span_at(s, sp, foot->u, x);
    d[0] = b[0] - x[0][0];
    d[1] = b[1] - x[0][1];
    if (v >= 0)
        return fan_place(s, v, d, out);
    ix__span_tangent(s, sp, foot->u, t);
    for (int i = 0; i < s->nborders; i++) {
        const ix__border *e = &s->border[i];

        if (e->kind == IX__SIDE && e->index == foot->span &&
            e->side * (t[0] * d[1] - t[1] * d[0]) > 0.0) {
            *out = (ix__place){i, e->side > 0 ? foot->u : 1.0 - foot->u};
            return true;
        }
    }
    return false;
}
