/* plane_walk.c - samples along the border of a set, dense where the bisector
 * bends. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"
#include "ops/plane_walk_impl.h"

/* Intervals of a border element are halved down to this. */
#define FINEST 0x1p-50
/* From here on so many events at most are looked for in an interval. */
#define SMALL 0x1p-26
enum { MOST_EVENTS = 4 };
/* A foot that moves farther (in spans) at one place jumps: less may be its
 * rounding where the circle nearly is that of curvature. */
#define JUMP 1e-5
/* Feet nearer than this part of the radius count as so far apart when steps are
 * chosen: along nearly parallel curves they would be too many. */
#define NARROW 0.05
/* Feet that are nearer to an end, in spans, are not told to the search. */
#define NEAR_END 1e-3
/* No step is longer than this part of the size, or of the radius. */
#define LONGEST 0.25

/* --- refinement ------------------------------------------------------------
 */

typedef struct {
    ix_ctx *ctx;
    const ix__walk *w;
    ix__samples s;
} sink;

static ix_status emit(sink *k, const ix__sample *s)
{
    if (k->s.n % IX__BLOCK == 0) {
        int used = k->s.n / IX__BLOCK;

        IX_TRY(ix__poll(k->ctx));
        IX_GROW(k->ctx, k->s.block, used, k->s.room);
        IX_SCRATCH(k->ctx, k->s.block[used], IX__BLOCK);
    }
    *ix__sample_at(&k->s, k->s.n++) = *s;
    return IX_OK;
}

/* How far the bisector is from the chord from a to b. It is a cubic there, as
 * good as: with the sines p, q of the angles between the chord of length l and
 * both tangents it is l (p s (1-s)^2 + q s^2 (1-s)) away from it, s from 0 to
 * 1, and either product is 4/27 at most. */
static double sagitta(const ix__sample *a, const ix__sample *b)
{
    double d[2] = {b->b[0] - a->b[0], b->b[1] - a->b[1]};
    double p = fabs(d[0] * a->along[1] - d[1] * a->along[0]);
    double q = fabs(d[0] * b->along[1] - d[1] * b->along[0]);

    return 4.0 / 27.0 * (p + q);
}

static bool flat(const ix__walk *w, const ix__sample *a, const ix__sample *m,
                 const ix__sample *b)
{
    double d[2] = {b->b[0] - a->b[0], b->b[1] - a->b[1]};
    double e[2] = {m->b[0] - a->b[0], m->b[1] - a->b[1]};
    double len = hypot(d[0], d[1]), part = d[0] * e[0] + d[1] * e[1];
    double room = ix__walk_room(w, m);

    if (!(w->tol * len <= LONGEST * room))
        return false;
    if (len <= room)
        return hypot(e[0], e[1]) <= room;
    if (!a->own_circle && !(sagitta(a, m) <= room && sagitta(m, b) <= room))
        return false;
    return fabs(d[0] * e[1] - d[1] * e[0]) <= room * len &&
           part >= 0.04 * len * len && part <= 0.96 * len * len;
}

/* Of a medial axis the radius is a coordinate, too. As good as a parabola
 * between a, m and b it is a quarter as far from the chords of both halves as m
 * is from that of the whole. */
static bool radius_flat(const ix__walk *w, const ix__sample *a,
                        const ix__sample *m, const ix__sample *b)
{
    double la = hypot(m->b[0] - a->b[0], m->b[1] - a->b[1]);
    double lb = hypot(b->b[0] - m->b[0], b->b[1] - m->b[1]);

    return w->own != w->other ||
           fabs((m->r - a->r) * lb - (b->r - m->r) * la) <=
               2.0 * ix__walk_room(w, m) * (la + lb);
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

/* The square of the tangents from y to the circle around a: what y is outside
 * of it. */
static double outside(const ix__sample *a, const double y[2])
{
    double d = hypot(y[0] - a->b[0], y[1] - a->b[1]);

    return fmax((d - a->r) * (d + a->r), 0.0);
}

/* Between two neighbours a and b, with feet y at a and z at b on one of the
 * sets: how much the squared distance from that set may be more, on the chord,
 * than what no set can be nearer.
 *
 * On the chord of length l, s from 0 to 1, |y - .|^2 is (1-s) |y - a|^2 +
 * s |y - b|^2 - s (1-s) l^2. So with q = (1-s) r_a^2 + s r_b^2 - s (1-s) l^2
 * every point that is outside both circles is at least sqrt(q) away from the
 * chord, and the set no more than sqrt(q + s outside(b, y)) and
 * sqrt(q + (1-s) outside(a, z)): whatever comes and goes between a and b, the
 * larger sum is the harmonic one at most. It is zero if both circles and all
 * between them pass through the foot. */
static double excess(const ix__sample *a, const ix__sample *b,
                     const double y[2], const double z[2])
{
    double p = outside(b, y), q = outside(a, z);

    return p + q > 0.0 ? p * q / (p + q) : 0.0;
}

static double feet_apart(const ix__sample *a)
{
    return hypot(a->apart[0], a->apart[1]);
}

/* What part of the tolerance the chord from a to b is off at most, whatever is
 * hidden between them. Both distances from a point of it lie between sqrt(q)
 * and sqrt(q + excess). The difference grows with |x - c| / r across the
 * bisector, x and c the feet. */
static double hidden_share(const ix__walk *w, const ix__sample *a,
                           const ix__sample *b)
{
    const ix__sample *small = a->r < b->r ? a : b;
    double most = fmax(excess(a, b, a->c, b->c), excess(a, b, a->x, b->x));
    double apart = fmax(fmin(feet_apart(a), feet_apart(b)), NARROW * small->r);
    double room = ix__walk_room(w, small);
    double half = 0.5 * hypot(b->b[0] - a->b[0], b->b[1] - a->b[1]);
    double q = fmax(small->r * small->r - half * half, 0.0);

    if (fmax(a->r, b->r) <= room || most == 0.0)
        return 0.0;
    return most / (sqrt(q + most) + sqrt(q)) * small->r / (apart * room);
}

double ix__walk_share(const ix__walk *w, const ix__sample *a,
                      const ix__sample *b)
{
    return fmax(hidden_share(w, a, b), sagitta(a, b) / ix__walk_room(w, a));
}

/* Nothing happens between a and b, of which m is the middle. */
static bool smooth(const ix__walk *w, const ix__sample *a, const ix__sample *m,
                   const ix__sample *b)
{
    const double speed[3] = {a->speed, m->speed, b->speed};
    const double rate[3] = {a->rate, m->rate, b->rate};
    double d, e, room;
    bool far;

    if (!m->valid || !ix__same_feet(w, a, b) || !ix__same_feet(w, a, m) ||
        ix__walk_turns(w, a, b) || ix__passes_seam(w, a, b) ||
        !flat(w, a, m, b) || !radius_flat(w, a, m, b))
        return false;
    if (a->own_circle)
        return true;
    if (!(hidden_share(w, a, m) <= 1.0 && hidden_share(w, m, b) <= 1.0))
        return false;
    room = ix__walk_room(w, m);
    far = hypot(m->b[0], m->b[1]) > IX__FAR;
    if (!as_promised(hypot(b->b[0] - a->b[0], b->b[1] - a->b[1]), b->at - a->at,
                     speed, far, 0.1 * room))
        return false;
    if (a->vertex >= 0)
        return true;
    d = ix__foot_way(w->other, &a->foot, &b->foot);
    if (!isfinite(d)) /* a corner between */
        return false;
    if (!as_promised(d, b->at - a->at, rate, far, 1e-6))
        return false;
    e = ix__foot_way(w->other, &a->foot, &m->foot);
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
    is_a = ix__same_feet(w, a, m);
    is_b = ix__same_feet(w, m, b);
    if (!is_a || !is_b || m->vertex >= 0)
        return is_a;
    return fabs(ix__foot_way(w->other, &a->foot, &m->foot)) <
           fabs(ix__foot_way(w->other, &m->foot, &b->foot));
}

/* Does the foot jump from a to b, or only move as fast as it does there? */
static bool jumps(const ix__walk *w, const ix__sample *a, const ix__sample *b)
{
    double fast = fmax(fabs(a->rate), fabs(b->rate)) * (b->at - a->at);

    return a->valid && b->valid && ix__same_feet(w, a, b) && a->vertex < 0 &&
           !a->own_circle &&
           !(fabs(ix__foot_way(w->other, &a->foot, &b->foot)) <=
             JUMP + 4.0 * fast);
}

/* Emits b; the foot may jump between it and the sample before, in one place or,
 * where more than one thing happens, in several. */
static ix_status emit_after(sink *k, const ix__sample *b)
{
    ix__sample *a = ix__sample_at(&k->s, k->s.n - 1);

    a->cut = jumps(k->w, a, b);
    return emit(k, b);
}

/* Does something happen between a and b, as far as they tell? */
static bool differ(const ix__walk *w, const ix__sample *a, const ix__sample *b)
{
    return a->valid != b->valid || a->far != b->far ||
           (a->valid && !ix__same_feet(w, a, b));
}

/* Encloses the first of what happens between *lo and *hi in the smallest
 * interval. */
static void enclose(const ix__walk *w, ix__sample *lo, ix__sample *hi)
{
    ix__sample m;

    while (hi->at - lo->at > FINEST) {
        double at = 0.5 * (lo->at + hi->at);

        if (at <= lo->at || at >= hi->at)
            break;
        ix__walk_sample(w, lo->border, at, &m);
        if (like_first(w, lo, &m, hi))
            *lo = m;
        else
            *hi = m;
    }
}

/* Encloses what happens between a and b: one thing as a rule, but a circle that
 * comes back from infinity may touch elsewhere first, within rounding. */
static ix_status locate(sink *k, const ix__sample *a, const ix__sample *b)
{
    ix__sample from = *a;

    for (int i = 0; i < MOST_EVENTS; i++) {
        ix__sample lo = from, hi = *b;

        enclose(k->w, &lo, &hi);
        if (lo.at > from.at)
            IX_TRY(emit_after(k, &lo));
        if (hi.at < b->at)
            IX_TRY(emit_after(k, &hi));
        if (!(hi.at < b->at) || !differ(k->w, &hi, b))
            break;
        from = hi;
    }
    return emit_after(k, b);
}

/* Where the other foot is likely to be between a and b: NULL if it changes.
 * Near ends of spans what is known would tip the scales between curve and
 * vertex, which cannot be told from each other there. */
static const ix__touch *foot_between(const ix__walk *w, const ix__sample *a,
                                     const ix__sample *b, ix__touch *out)
{
    if (!a->valid || !b->valid || a->foot.span != b->foot.span ||
        !ix__same_feet(w, a, b) || a->own_circle)
        return NULL;
    *out = a->foot;
    out->u = 0.5 * (a->foot.u + b->foot.u);
    return out->u > NEAR_END && out->u < 1.0 - NEAR_END ? out : NULL;
}

/* Samples between a and b, b included; a is the last one emitted. */
static ix_status refine(sink *k, const ix__sample *a, const ix__sample *b)
{
    double at = 0.5 * (a->at + b->at);
    ix__touch near;
    ix__sample m;

    if (!a->valid && !b->valid)
        return emit(k, b);
    ix__walk_sample_near(k->w, a->border, at, foot_between(k->w, a, b, &near),
                         &m);
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
/* Vertices no farther apart are one (as in plane_set.c). */
#define COMMON_END 1e-11
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

    ix__own_frame(w->own, e, end, &o);
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
                        const ix__place *seeds, ix__samples *out)
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
    *out = k.s;
    return IX_OK;
}
