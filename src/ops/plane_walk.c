/* plane_walk.c - samples along the border of a set, dense where the bisector
 * bends, and runs of them on which nothing changes. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ops/plane_walk.h"

/* With one set for both, feet on a smooth curve that are nearer than this part
 * of the radius count as one: the depth between them is of fourth order, so
 * that they are not known to more than (1e-14)^(1/4), and a margin. */
#define ONE_FOOT 1e-2
/* With two sets, feet nearer than this part of the radius are looked at: what
 * is beside the centre tells whether it is on the bisector. */
#define TOUCHING   4e-3
#define ASIDE      1e-5  /* so far beside, below any tolerance that is usual */
#define ASIDE_FAR  1e-2  /* times the radius: there the bisector is straight */
#define TOLD_APART 2e-14 /* distances differ by more than their rounding */
/* Vertices no farther apart are one (as in plane_set.c). */
#define COMMON_END 1e-11
/* A radius below this counts as a point that both sets have in common. */
#define COMMON 1e-13
/* Intervals of a border element are halved down to this. */
#define FINEST 0x1p-50
/* From here on one event at most is looked for in an interval. */
#define SMALL 0x1p-26
/* A foot that moves farther (in spans) at one place jumps: less may be its
 * rounding where the circle nearly is that of curvature. */
#define JUMP 1e-5
/* Feet nearer than this part of the radius count as so far apart when steps are
 * chosen: along nearly parallel curves they would be too many. */
#define NARROW 0.05
/* Beyond this distance the bisector goes to infinity, nearly straight. */
#define FAR 4.0
/* Pieces that were found lead to others; so often at most. */
enum { ROUNDS = 8 };

/* --- one sample ------------------------------------------------------------
 */

static void own_frame(const ix__set *s, const ix__border *e, double at,
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

/* The other foot: vertex or side of a span. */
static void other_foot(const ix__set *s, ix__sample *o)
{
    const ix__span *sp = &s->span[o->foot.span];
    double d[3][2], t[2], u = o->foot.u;

    o->vertex = u <= 0.0 ? sp->vertex[0] : u >= 1.0 ? sp->vertex[1] : -1;
    o->side = 0;
    if (o->vertex >= 0) {
        memcpy(o->x, s->vertex[o->vertex].x, sizeof o->x);
        return;
    }
    ix__span_at(s, sp, u, d);
    memcpy(o->x, d[0], sizeof o->x);
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
    double n[2] = {(o->b[0] - o->x[0]) / o->r, (o->b[1] - o->x[1]) / o->r};

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
    double m[2] = {o->x[0] - o->c[0], o->x[1] - o->c[1]};
    double len = hypot(m[0], m[1]), size = fmax(o->r, 1.0);
    double most = (o->r > FAR ? ASIDE_FAR : ASIDE) * size;

    if (!(len > 0.0))
        return false;
    m[0] /= len;
    m[1] /= len;
    for (double h = ASIDE * size; h <= 1.001 * most; h *= 10.0) {
        double own = -beside(w, o, m, -h), other = beside(w, o, m, h);

        if (fmin(fabs(own), fabs(other)) > TOLD_APART * size)
            return own > 0.0 && other > 0.0;
    }
    return false;
}

/* Feet so near each other that the centre is known to half the digits. */
static bool near_feet(const ix__sample *a)
{
    return hypot(a->x[0] - a->c[0], a->x[1] - a->c[1]) <=
           TOUCHING * fmin(a->r, 1.0);
}

/* Is the own foot on the other set too (the curves are the same there), or are
 * both feet one as far as can be told? */
static bool on_both(const ix__walk *w, const ix__sample *o)
{
    if (w->own == w->other)
        return false;
    if (ix__set_distance(w->other, o->c, NULL) <= COMMON)
        return true;
    return near_feet(o) && !separates(w, o);
}

static double way(const ix__set *s, const ix__touch *a, const ix__touch *b);

static bool one_foot(const ix__walk *w, const ix__border *e,
                     const ix__sample *o)
{
    ix__touch own = {0.0, e->index, e->side > 0 ? o->at : 1.0 - o->at};

    if (w->own != w->other || e->kind == IX__FAN || o->vertex >= 0)
        return false;
    return w->own->span[own.span].strand == w->own->span[o->foot.span].strand &&
           hypot(o->x[0] - o->c[0], o->x[1] - o->c[1]) <= ONE_FOOT * o->r &&
           isfinite(way(w->own, &own, &o->foot));
}

static void judge(const ix__walk *w, const ix__border *e, ix__sample *o)
{
    ix__touch block = {.kappa = o->foot.kappa, .span = -1};

    o->r = 1.0 / o->foot.kappa;
    if (!(o->r > COMMON) || w->other->span[o->foot.span].phantom)
        return;
    for (int k = 0; k < 2; k++)
        o->b[k] = o->c[k] + o->r * o->n[k];
    other_foot(w->other, o);
    if (in_common(w, o) || (w->meeting && on_both(w, o)))
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

void ix__walk_sample(const ix__walk *w, int border, double at, ix__sample *out)
{
    const ix__border *e = &w->own->border[border];
    ix__sample o = {.border = border, .at = at, .vertex = -1};

    *out = o;
    if (e->kind == IX__FAN && w->own->vertex[e->index].shared)
        return; /* all centres have this vertex as foot on both */
    own_frame(w->own, e, at, &o);
    if (!isfinite(o.c[0] + o.c[1] + o.n[0] + o.n[1]))
        return;
    o.foot = (ix__touch){.span = -1};
    if (w->own == w->other) {
        o.foot.kappa = own_curvature(w->own, e, at);
        if (!isfinite(o.foot.kappa))
            return;
    }
    ix__set_touch(w->other, o.c, o.n, IX__DEPTH, &o.foot);
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

/* --- refinement ------------------------------------------------------------
 */

typedef struct {
    ix_ctx *ctx;
    const ix__walk *w;
    int n, room;
    ix__sample *s;
} sink;

static ix_status emit(sink *k, const ix__sample *s)
{
    if (k->n == k->room) {
        ix__sample *more;

        IX_TRY(ix__poll(k->ctx));
        k->room = k->room ? 2 * k->room : 256;
        IX_SCRATCH(k->ctx, more, k->room);
        if (k->n)
            memcpy(more, k->s, (size_t)k->n * sizeof *more);
        k->s = more;
    }
    k->s[k->n++] = *s;
    return IX_OK;
}

/* How far the foot moves from a to b along its strand; infinite if there is no
 * way without a corner. */
static double way(const ix__set *s, const ix__touch *a, const ix__touch *b)
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

/* Does a foot pass the place where its closed curve begins? There its parameter
 * jumps, and pieces between two objects are divided. */
static bool passes_seam(const ix__walk *w, const ix__sample *a,
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

static bool same_feet(const ix__walk *w, const ix__sample *a,
                      const ix__sample *b)
{
    return a->vertex == b->vertex && a->side == b->side &&
           a->own_circle == b->own_circle &&
           w->other->span[a->foot.span].strand ==
               w->other->span[b->foot.span].strand;
}

/* With one set for both: do the feet change places between a and b? There the
 * medial axis ends, at a centre of curvature, and the walk turns back. */
static bool turns(const ix__walk *w, const ix__sample *a, const ix__sample *b)
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
        d[i] = way(w->own, &own, &s[i]->foot);
        if (!(fabs(d[i]) <=
              0.25 * w->own->strand[w->own->span[own.span].strand].count))
            return false;
    }
    return d[0] * d[1] < 0.0;
}

/* Is the bisector within tol of the chord from a to b? It is a cubic there, as
 * good as: with the sines p, q of the angles between the chord of length l and
 * both tangents it is l (p s (1-s)^2 + q s^2 (1-s)) away from it, s from 0 to
 * 1, and either product is 4/27 at most. */
static bool chord(const ix__sample *a, const ix__sample *b, double tol)
{
    double d[2] = {b->b[0] - a->b[0], b->b[1] - a->b[1]};
    double p = fabs(d[0] * a->along[1] - d[1] * a->along[0]);
    double q = fabs(d[0] * b->along[1] - d[1] * b->along[0]);

    return 4.0 / 27.0 * (p + q) <= tol;
}

static bool flat(const ix__walk *w, const ix__sample *a, const ix__sample *m,
                 const ix__sample *b)
{
    double d[2] = {b->b[0] - a->b[0], b->b[1] - a->b[1]};
    double e[2] = {m->b[0] - a->b[0], m->b[1] - a->b[1]};
    double len = hypot(d[0], d[1]), part = d[0] * e[0] + d[1] * e[1];
    double size = fmax(1.0, hypot(m->b[0], m->b[1]));

    if (!(len <= 0.25 * size))
        return false;
    if (len <= w->tol * size)
        return hypot(e[0], e[1]) <= w->tol * size;
    if (!a->own_circle &&
        !(chord(a, m, w->tol * size) && chord(m, b, w->tol * size)))
        return false;
    return fabs(d[0] * e[1] - d[1] * e[0]) <= w->tol * size * len &&
           part >= 0.04 * len * len && part <= 0.96 * len * len;
}

/* Is what was covered what the speeds at both ends and in the middle promise,
 * by Simpson's rule? Where a part of either border was left out it is not. Far
 * out both grow as on hyperbolas: there their geometric mean is compared,
 * roughly. */
static bool as_promised(double covered, double h, const double v[3], bool far,
                        double least)
{
    double simpson = h * (v[0] + 4.0 * v[1] + v[2]) / 6.0;
    double mean = v[0] * v[2] > 0.0 ? h * sqrt(v[0] * v[2]) : 0.0;

    if (fabs(covered - simpson) <= 0.005 * fabs(covered) + least)
        return true;
    return far && fabs(fabs(covered) - mean) <= 0.05 * fabs(covered) + least;
}

/* Can what comes between the samples a, m and b, and is seen by none of them,
 * be told from the chords between them?
 *
 * A point y outside the circles around a and m is outside that around the
 * middle between them but for l^2 / (8 r), l their distance: |y - .|^2 is
 * convex, with second derivative 2, and so is the radius squared less that. The
 * difference of both distances grows with |x - c| / r across the bisector, x
 * and c the feet: it moves by l^2 / (8 |x - c|) at most. */
static bool nothing_between(const ix__walk *w, const ix__sample *a,
                            const ix__sample *b)
{
    double size = fmax(1.0,
                       fmin(hypot(a->b[0], a->b[1]), hypot(b->b[0], b->b[1])));
    double len = 0.5 * hypot(b->b[0] - a->b[0], b->b[1] - a->b[1]);
    double apart = fmin(hypot(a->x[0] - a->c[0], a->x[1] - a->c[1]),
                        hypot(b->x[0] - b->c[0], b->x[1] - b->c[1]));

    apart = fmax(apart, NARROW * fmin(a->r, b->r));
    return fmax(a->r, b->r) <= w->tol * size || size > FAR ||
           len * len <= 8.0 * w->tol * size * apart;
}

/* Nothing happens between a and b, of which m is the middle. */
static bool smooth(const ix__walk *w, const ix__sample *a, const ix__sample *m,
                   const ix__sample *b)
{
    const double speed[3] = {a->speed, m->speed, b->speed};
    const double rate[3] = {a->rate, m->rate, b->rate};
    double d, e, size;

    if (!m->valid || !same_feet(w, a, b) || !same_feet(w, a, m) ||
        turns(w, a, b) || passes_seam(w, a, b) || !flat(w, a, m, b))
        return false;
    size = fmax(1.0, hypot(m->b[0], m->b[1]));
    if (a->own_circle)
        return true;
    if (!nothing_between(w, a, b))
        return false;
    if (!as_promised(hypot(b->b[0] - a->b[0], b->b[1] - a->b[1]), b->at - a->at,
                     speed, size > FAR, 0.1 * w->tol * size))
        return false;
    if (a->vertex >= 0)
        return true;
    d = way(w->other, &a->foot, &b->foot);
    if (!isfinite(d)) /* a corner between */
        return false;
    if (!as_promised(d, b->at - a->at, rate, size > FAR, 1e-6))
        return false;
    e = way(w->other, &a->foot, &m->foot);
    if (fabs(d) <= 1e-12)
        return true;
    return e >= fmin(0.02 * d, 0.98 * d) && e <= fmax(0.02 * d, 0.98 * d);
}

/* Is m more like a than like b? */
static bool like_first(const ix__walk *w, const ix__sample *a,
                       const ix__sample *m, const ix__sample *b)
{
    bool is_a = a->valid == m->valid && a->far == m->far;
    bool is_b = b->valid == m->valid && b->far == m->far;

    if (!is_a || !is_b || !m->valid)
        return is_a;
    is_a = same_feet(w, a, m);
    is_b = same_feet(w, m, b);
    if (!is_a || !is_b || m->vertex >= 0)
        return is_a;
    return fabs(way(w->other, &a->foot, &m->foot)) <
           fabs(way(w->other, &m->foot, &b->foot));
}

/* Emits b; the foot may jump between it and the sample before, in one place or,
 * where more than one thing happens, in several. */
static ix_status emit_after(sink *k, const ix__sample *b)
{
    ix__sample *a = &k->s[k->n - 1];

    a->cut = a->valid && b->valid && same_feet(k->w, a, b) && a->vertex < 0 &&
             !a->own_circle &&
             fabs(way(k->w->other, &a->foot, &b->foot)) > JUMP;
    return emit(k, b);
}

/* Encloses what happens between a and b in the smallest interval. */
static ix_status locate(sink *k, const ix__sample *a, const ix__sample *b)
{
    ix__sample lo = *a, hi = *b, m;

    while (hi.at - lo.at > FINEST) {
        double at = 0.5 * (lo.at + hi.at);

        if (at <= lo.at || at >= hi.at)
            break;
        ix__walk_sample(k->w, a->border, at, &m);
        if (like_first(k->w, &lo, &m, &hi))
            lo = m;
        else
            hi = m;
    }
    if (lo.at > a->at)
        IX_TRY(emit_after(k, &lo));
    if (hi.at < b->at)
        IX_TRY(emit_after(k, &hi));
    return emit_after(k, b);
}

/* Samples between a and b, b included; a is the last one emitted. */
static ix_status refine(sink *k, const ix__sample *a, const ix__sample *b)
{
    double at = 0.5 * (a->at + b->at);
    ix__sample m;

    if (!a->valid && !b->valid)
        return emit(k, b);
    ix__walk_sample(k->w, a->border, at, &m);
    if (a->valid && b->valid && smooth(k->w, a, &m, b)) {
        IX_TRY(emit(k, &m));
        return emit(k, b);
    }
    if (!(b->at - a->at > SMALL))
        return locate(k, a, b);
    IX_TRY(refine(k, a, &m));
    return refine(k, &m, b);
}

static ix_status walk_border(sink *k, int border, int nseeds,
                             const ix__place *seeds)
{
    int grid = k->w->grid, next = 0;
    ix__sample a, b;

    ix__walk_sample(k->w, border, 0.0, &a);
    IX_TRY(emit(k, &a));
    for (int i = 1; i <= grid; i++) {
        double end = (double)i / grid;

        while (next < nseeds && seeds[next].at < end) {
            if (seeds[next].at > a.at) {
                ix__walk_sample(k->w, border, seeds[next].at, &b);
                IX_TRY(refine(k, &a, &b));
                a = b;
            }
            next++;
        }
        ix__walk_sample(k->w, border, end, &b);
        IX_TRY(refine(k, &a, &b));
        a = b;
    }
    return IX_OK;
}

/* --- common normals ---------------------------------------------------------
 *
 * Where one curve goes on smoothly from the other at a common end the fans of
 * both have one normal in common. Its points have the end as foot on both, one
 * side of it is nearer to the one curve, the other side to the other. */

/* Beyond this radius, or with less curvature, a normal goes on to infinity. */
#define NORMAL_REACH 20.0
#define STRAIGHT     1e-12
/* Normals that differ by no more, of smooth joints, are one. */
#define SAME_NORMAL 1e-9

/* Vertex v of s as a foot: an end of a span. */
static ix__touch vertex_foot(const ix__set *s, int v)
{
    int i = 0;

    while (s->span[i].vertex[0] != v && s->span[i].vertex[1] != v)
        i++;
    return (ix__touch){0.0, i, s->span[i].vertex[0] == v ? 0.0 : 1.0};
}

/* Does a fan of s at x lie on the other side of the normal n, beginning with
 * it (e 0) or ending (1)? Its vertex, or -1. */
static int fan_beside(const ix__set *s, const double x[2], const double n[2],
                      int e)
{
    for (int i = 0; i < s->nborders; i++) {
        const ix__border *b = &s->border[i];
        double a = e ? b->to : b->from, m[2] = {cos(a), sin(a)};
        const double *y;

        if (b->kind != IX__FAN)
            continue;
        y = s->vertex[b->index].x;
        if (hypot(x[0] - y[0], x[1] - y[1]) <= COMMON_END &&
            hypot(m[0] - n[0], m[1] - n[1]) <= SAME_NORMAL)
            return b->index;
    }
    return -1;
}

/* The curvature towards n of the spans of s that end in vertex v. */
static double end_curvature(const ix__set *s, int v, const double n[2])
{
    double big = 0.0;

    for (int i = 0; i < s->nspans; i++)
        for (int e = 0; e < 2; e++) {
            double d[3][2], k;

            if (s->span[i].vertex[e] != v)
                continue;
            ix__span_at(s, &s->span[i], e, d);
            k = (d[2][0] * n[0] + d[2][1] * n[1]) /
                (d[1][0] * d[1][0] + d[1][1] * d[1][1]);
            if (k > big && fabs(d[1][0] * n[0] + d[1][1] * n[1]) <=
                               1e-6 * hypot(d[1][0], d[1][1]))
                big = k;
        }
    return big;
}

/* The part of the common normal, if there is one, at the beginning (end 0) or
 * the end (1) of a fan: from where another point is as near down to the vertex,
 * or back. */
static ix_status common_normal(sink *k, int border, int end)
{
    const ix__walk *w = k->w;
    const ix__border *e = &w->own->border[border];
    ix__sample o = {.border = border, .at = end, .valid = true, .normal = true};
    ix__sample beyond = {.border = border, .at = end, .vertex = -1};
    ix__touch t = {.span = -1};
    double r;

    own_frame(w->own, e, end, &o);
    o.vertex = fan_beside(w->other, o.c, o.n, 1 - end);
    if (o.vertex < 0)
        return IX_OK;
    o.foot = vertex_foot(w->other, o.vertex);
    memcpy(o.x, o.c, sizeof o.x);
    t.kappa = fmax(end_curvature(w->own, e->index, o.n),
                   end_curvature(w->other, o.vertex, o.n));
    ix__set_touch(w->other, o.c, o.n, IX__DEPTH, &t);
    t.span = -1;
    ix__set_touch(w->own, o.c, o.n, IX__DEPTH, &t);
    if (!isfinite(t.kappa))
        return IX_OK;
    beyond.blocked = t.span >= 0;
    beyond.foot = t;
    beyond.far = !(t.kappa > STRAIGHT);
    r = beyond.far ? NORMAL_REACH : 1.0 / t.kappa;
    if (end == 0)
        IX_TRY(emit(k, &beyond));
    for (int i = 0; i < 2; i++) {
        o.r = i == end ? r : 0.0;
        o.b[0] = o.c[0] + o.r * o.n[0];
        o.b[1] = o.c[1] + o.r * o.n[1];
        IX_TRY(emit(k, &o));
    }
    return end == 1 ? emit(k, &beyond) : IX_OK;
}

static ix_status walk_element(sink *k, int border, int nseeds,
                              const ix__place *seeds)
{
    bool fan = k->w->own != k->w->other &&
               k->w->own->border[border].kind == IX__FAN &&
               k->w->own->vertex[k->w->own->border[border].index].shared;

    if (fan)
        IX_TRY(common_normal(k, border, 0));
    IX_TRY(walk_border(k, border, nseeds, seeds));
    return fan ? common_normal(k, border, 1) : IX_OK;
}

ix_status ix__walk_loop(ix_ctx *ctx, const ix__walk *w, int loop, int nseeds,
                        const ix__place *seeds, int *n, ix__sample **out)
{
    const ix__loop *l = &w->own->loop[loop];
    sink k = {.ctx = ctx, .w = w};

    for (int i = l->first; i < l->first + l->count; i++) {
        int first = 0, end;

        IX_TRY(ix__poll(ctx));
        while (first < nseeds && seeds[first].border < i)
            first++;
        for (end = first; end < nseeds && seeds[end].border == i; end++)
            ;
        IX_TRY(walk_element(&k, i, end - first, seeds + first));
    }
    *n = k.n;
    *out = k.s;
    return IX_OK;
}

/* --- seeds -----------------------------------------------------------------
 */

typedef struct {
    ix_ctx *ctx;
    int n, room;
    ix__place *p;
} places;

static ix_status add_place(places *l, ix__place p)
{
    if (l->n == l->room) {
        ix__place *more;

        l->room = l->room ? 2 * l->room : 64;
        IX_SCRATCH(l->ctx, more, l->room);
        if (l->n)
            memcpy(more, l->p, (size_t)l->n * sizeof *more);
        l->p = more;
    }
    l->p[l->n++] = p;
    return IX_OK;
}

static int by_place(const void *a, const void *b)
{
    const ix__place *p = a, *q = b;

    if (p->border != q->border)
        return p->border < q->border ? -1 : 1;
    return (p->at > q->at) - (p->at < q->at);
}

/* Places of the own border that are seen from the other one. */
static ix_status seeds_from_other(ix_ctx *ctx, const ix__walk *w, places *l)
{
    ix__walk back = {w->other, w->own, w->tol, w->grid, w->meeting};
    ix__sample s;
    ix__place p;

    for (int i = 0; i < w->other->nborders; i++)
        for (int j = 0; j <= w->grid; j++) {
            IX_TRY(ix__poll(ctx));
            ix__walk_sample(&back, i, (double)j / w->grid, &s);
            if (s.valid && ix__border_place(w->own, &s.foot, s.b, &p))
                IX_TRY(add_place(l, p));
        }
    return IX_OK;
}

/* --- runs ------------------------------------------------------------------
 */

/* Is there a corner without a fan, of less than 180 degrees, between two sides?
 * However shallow it is, no circle touches there. */
static bool at_corner(const ix__walk *w, const ix__sample *a,
                      const ix__sample *b)
{
    const ix__border *e = &w->own->border[a->border];

    return a->border != b->border && e->kind == IX__SIDE &&
           w->own->span[e->index].vertex[e->side > 0] >= 0;
}

static bool joins(const ix__walk *w, const ix__sample *a, const ix__sample *b)
{
    const ix__border *ea = &w->own->border[a->border];
    const ix__border *eb = &w->own->border[b->border];

    if (!a->valid || !b->valid || a->cut || !same_feet(w, a, b) ||
        turns(w, a, b) || passes_seam(w, a, b) || at_corner(w, a, b))
        return false;
    if (ea->kind != eb->kind)
        return false;
    return ea->kind == IX__SIDE || ea->index == eb->index;
}

static bool meets(const ix__sample *a, const ix__sample *b)
{
    double tol = near_feet(a) || near_feet(b) ? 1e-6 : 1e-7;

    return hypot(a->b[0] - b->b[0], a->b[1] - b->b[1]) <=
           tol * fmax(1.0, a->b[0] * a->b[0] + a->b[1] * a->b[1]);
}

/* Length along the samples: runs between two neighbours in double are none, nor
 * those at infinity that are one place of the border, nor those that rounding
 * makes of a place where both feet come together. */
static bool has_length(const ix__walked *o, const ix__run *r)
{
    const ix__sample *first = ix__run_at(o, r, 0);
    const ix__sample *last = ix__run_at(o, r, r->count - 1);
    bool vague = near_feet(first) && !first->own_circle && first->r > 1e-6;
    double len = 0.0, least = vague ? 1e-7 : 1e-11;

    if (first->normal)
        return true;
    if (first->border == last->border && fabs(last->at - first->at) <= 1e-12)
        return false;
    for (int i = 1; i < r->count && len <= least; i++) {
        const ix__sample *b = ix__run_at(o, r, i);

        len = fmax(len, hypot(b->b[0] - first->b[0], b->b[1] - first->b[1]));
    }
    return len > least;
}

static void add_run(ix__walked *o, ix__run r)
{
    ix__run *before = o->nruns ? &o->run[o->nruns - 1] : NULL;

    if (!has_length(o, &r))
        return;
    if (before && before->loop == r.loop)
        r.joined = !before->far[1] && !r.far[0] &&
                   meets(ix__run_at(o, before, before->count - 1),
                         ix__run_at(o, &r, 0));
    o->run[o->nruns++] = r;
}

/* Where to begin: behind a place at infinity, else behind any break. */
static int beginning(const ix__walk *w, int n, const ix__sample *s)
{
    int at = 0;

    for (int i = 0; i < n; i++)
        if (s[i].far && s[(i + 1) % n].valid)
            return (i + 1) % n;
    for (int i = 0; i < n; i++)
        if (!s[i].valid && s[(i + 1) % n].valid)
            return (i + 1) % n;
    for (int i = 0; i < n; i++)
        if (!joins(w, &s[i], &s[(i + 1) % n]))
            at = (i + 1) % n;
    return at;
}

static void runs_of_loop(const ix__walk *w, int loop, ix__walked *o)
{
    int n = o->counts[loop], i = 0, begin;
    const ix__sample *s = o->samples[loop];

    if (n == 0)
        return;
    begin = beginning(w, n, s);
    while (i < n) {
        ix__run r = {.first = (begin + i) % n, .count = 1, .loop = loop};

        if (!s[r.first].valid) {
            i++;
            continue;
        }
        while (i + r.count < n && joins(w, &s[(begin + i + r.count - 1) % n],
                                        &s[(begin + i + r.count) % n]))
            r.count++;
        r.far[0] = s[(r.first + n - 1) % n].far;
        r.far[1] = s[(r.first + r.count) % n].far;
        add_run(o, r);
        i += r.count;
    }
}

/* Is m, between two samples of a run, what they lead to expect? */
static bool as_expected(const ix__walk *w, const ix__sample *a,
                        const ix__sample *m, const ix__sample *b)
{
    double d[2] = {b->b[0] - a->b[0], b->b[1] - a->b[1]};
    double e[2] = {m->b[0] - a->b[0], m->b[1] - a->b[1]};
    double len = hypot(d[0], d[1]), size = fmax(1.0, hypot(m->b[0], m->b[1]));
    double tol = 2.0 * w->tol * size;

    if (!m->valid || !same_feet(w, a, m))
        return false;
    return hypot(e[0], e[1]) <= len + tol &&
           fabs(d[0] * e[1] - d[1] * e[0]) <= tol * fmax(len, tol);
}

/* Is what is at that place known from the samples around it? */
static bool explored(const ix__walk *w, const ix__walked *o, ix__place p)
{
    ix__sample s;

    ix__walk_sample(w, p.border, p.at, &s);
    for (int i = 0; i < o->nloops; i++) {
        const ix__loop *l = &w->own->loop[i];
        const ix__sample *at = o->samples[i];
        int lo = 0, hi = o->counts[i] - 1;

        if (p.border < l->first || p.border >= l->first + l->count || hi < 1)
            continue;
        while (hi - lo > 1) {
            int m = (lo + hi) / 2;
            ix__place q = {at[m].border, at[m].at};

            if (by_place(&q, &p) <= 0)
                lo = m;
            else
                hi = m;
        }
        if (joins(w, &at[lo], &at[hi]))
            return as_expected(w, &at[lo], &s, &at[hi]);
    }
    return !s.valid;
}

/* Places around p on which nothing is known; *added counts them. The place
 * itself is where three feet are equally far, known to 1e-7 where the circle
 * touches at the end of one of the curves. */
static ix_status unexplored(const ix__walk *w, const ix__walked *o, ix__place p,
                            places *l, int *added)
{
    static const double step[] = {0, 1e-7, -1e-7, 1e-5, -1e-5, 1e-3, -1e-3};

    for (size_t i = 0; i < sizeof step / sizeof *step; i++) {
        ix__place q = {p.border, p.at + step[i]};

        if (!(q.at > 0.0 && q.at < 1.0) || explored(w, o, q))
            continue;
        IX_TRY(add_place(l, q));
        ++*added;
    }
    return IX_OK;
}

/* Where the own set blocks, the bisector goes on from what blocks it. */
static ix_status seeds_from_blocks(const ix__walk *w, const ix__walked *o,
                                   int loop, places *l, int *added)
{
    const ix__sample *s = o->samples[loop];
    int n = o->counts[loop];

    for (int i = 0; i < n; i++) {
        const ix__sample *a = &s[i], *b = &s[(i + 1) % n], *bad, *good;
        ix__place p;

        if (a->valid == b->valid)
            continue;
        good = a->valid ? a : b;
        bad = a->valid ? b : a;
        if (bad->blocked && ix__border_place(w->own, &bad->foot, good->b, &p))
            IX_TRY(unexplored(w, o, p, l, added));
    }
    return IX_OK;
}

static ix_status walk_loops(ix_ctx *ctx, const ix__walk *w, places *seeds,
                            ix__walked *out)
{
    size_t total = 0;

    if (seeds->n)
        qsort(seeds->p, (size_t)seeds->n, sizeof *seeds->p, by_place);
    for (int i = 0; i < out->nloops; i++) {
        IX_TRY(ix__walk_loop(ctx, w, i, seeds->n, seeds->p, &out->counts[i],
                             &out->samples[i]));
        total += (size_t)out->counts[i];
    }
    IX_SCRATCH(ctx, out->run, total + 1);
    out->nruns = 0;
    for (int i = 0; i < out->nloops; i++)
        runs_of_loop(w, i, out);
    return IX_OK;
}

ix_status ix__walk_all(ix_ctx *ctx, const ix__walk *w, int nseeds,
                       const ix__place *first, ix__walked *out)
{
    places seeds = {.ctx = ctx};

    *out = (ix__walked){.nloops = w->own->nloops};
    IX_SCRATCH(ctx, out->samples, out->nloops);
    IX_SCRATCH(ctx, out->counts, out->nloops);
    for (int i = 0; i < nseeds; i++)
        IX_TRY(add_place(&seeds, first[i]));
    if (w->own != w->other)
        IX_TRY(seeds_from_other(ctx, w, &seeds));
    IX_TRY(walk_loops(ctx, w, &seeds, out));
    for (int i = 0; w->own != w->other && i < ROUNDS; i++) {
        int added = 0;

        for (int j = 0; j < out->nloops; j++)
            IX_TRY(seeds_from_blocks(w, out, j, &seeds, &added));
        if (added == 0)
            break;
        IX_TRY(walk_loops(ctx, w, &seeds, out));
    }
    return IX_OK;
}
