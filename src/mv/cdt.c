/* cdt.c - constrained triangulation of points in a square. Triangles always
 * fill the square, each with a positive area. */
#include "mv/cdt.h"

#include <assert.h>
#include <math.h>
#include <string.h>

__extension__ typedef __int128 wide;

/* --- signs --------------------------------------------------------------- */

static int64_t area(ix__cdt_point a, ix__cdt_point b, ix__cdt_point c)
{
    return (int64_t)(b.x - a.x) * (c.y - a.y) -
           (int64_t)(b.y - a.y) * (c.x - a.x);
}

/* Twice the area of a, b, d: positive if counter-clockwise. */
static int64_t orient(const ix__cdt *c, int a, int b, int d)
{
    return area(c->p[a], c->p[b], c->p[d]);
}

/* Is d inside the circle through a, b, e (counter-clockwise)? */
static bool in_circle(const ix__cdt *c, int a, int b, int e, int d)
{
    const int v[3] = {a, b, e};
    int64_t x[3], y[3];
    wide sum = 0;

    for (int k = 0; k < 3; k++) {
        x[k] = (int64_t)c->p[v[k]].x - c->p[d].x;
        y[k] = (int64_t)c->p[v[k]].y - c->p[d].y;
    }
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;

        sum += (wide)(x[k] * x[k] + y[k] * y[k]) * (x[i] * y[j] - x[j] * y[i]);
    }
    return sum > 0;
}

/* --- triangles ----------------------------------------------------------- */

static void put(ix__cdt *c, int t, ix__cdt_tri tri)
{
    c->t[t] = tri;
    for (int k = 0; k < 3; k++)
        c->at[tri.v[k]] = t;
}

static int corner_of(const ix__cdt_tri *t, int v)
{
    return t->v[0] == v ? 0 : t->v[1] == v ? 1 : 2;
}

/* The same triangle with corner k first. */
static ix__cdt_tri turned(const ix__cdt_tri *t, int k)
{
    ix__cdt_tri r;

    for (int i = 0; i < 3; i++) {
        r.v[i] = t->v[(k + i) % 3];
        r.n[i] = t->n[(k + i) % 3];
        r.odd[i] = t->odd[(k + i) % 3];
    }
    return r;
}

static void relink(ix__cdt *c, int t, int old, int new)
{
    for (int k = 0; t >= 0 && k < 3; k++)
        if (c->t[t].n[k] == old) {
            c->t[t].n[k] = new;
            return;
        }
}

/* The side of t's neighbour u that leads back. */
static int side_to(const ix__cdt *c, int u, int t)
{
    const ix__cdt_tri *r = &c->t[u];

    return r->n[0] == t ? 0 : r->n[1] == t ? 1 : 2;
}

static ix_status more_room(ix__cdt *c, int cap)
{
    ix__cdt_point *p;
    ix__cdt_tri *t;
    int *at;

    IX_SCRATCH(c->ctx, p, cap);
    IX_SCRATCH(c->ctx, t, 2 * (size_t)cap);
    IX_SCRATCH(c->ctx, at, cap);
    if (c->npts > 0) {
        memcpy(p, c->p, (size_t)c->npts * sizeof *p);
        memcpy(t, c->t, (size_t)c->ntris * sizeof *t);
        memcpy(at, c->at, (size_t)c->npts * sizeof *at);
    }
    c->cap = cap;
    c->p = p;
    c->t = t;
    c->at = at;
    return IX_OK;
}

ix_status ix__cdt_init(ix_ctx *ctx, int npts, ix__cdt *c)
{
    *c = (ix__cdt){.ctx = ctx, .crossings = 1000 + npts};
    IX_TRY(more_room(c, npts < 8 ? 8 : npts + npts / 4));
    c->npts = 4;
    c->ntris = 2;
    for (int k = 0; k < 4; k++)
        c->p[k] = (ix__cdt_point){k == 1 || k == 2 ? IX__CDT_SIDE : 0,
                                  k >= 2 ? IX__CDT_SIDE : 0};
    put(c, 0, (ix__cdt_tri){.v = {0, 1, 2}, .n = {-1, 1, -1}});
    put(c, 1, (ix__cdt_tri){.v = {0, 2, 3}, .n = {-1, -1, 0}});
    return IX_OK;
}

/* --- flips --------------------------------------------------------------- */

/* The side opposite of the first corner of t is replaced by the other diagonal:
 * a b d and w d b become a b w and a w d. */
static void flip(ix__cdt *c, int t, int k)
{
    ix__cdt_tri r = turned(&c->t[t], k), s;
    int u = r.n[0];

    s = turned(&c->t[u], side_to(c, u, t));
    put(c, t,
        (ix__cdt_tri){.v = {r.v[0], r.v[1], s.v[0]},
                      .n = {s.n[1], u, r.n[2]},
                      .odd = {s.odd[1], false, r.odd[2]}});
    put(c, u,
        (ix__cdt_tri){.v = {r.v[0], s.v[0], r.v[2]},
                      .n = {s.n[2], r.n[1], t},
                      .odd = {s.odd[2], r.odd[1], false}});
    relink(c, s.n[1], u, t);
    relink(c, r.n[1], t, u);
}

/* The triangle before t around v, clockwise; the one after it. */
static int before(const ix__cdt *c, int t, int v)
{
    return c->t[t].n[(corner_of(&c->t[t], v) + 2) % 3];
}

static int after(const ix__cdt *c, int t, int v)
{
    return c->t[t].n[(corner_of(&c->t[t], v) + 1) % 3];
}

/* The first triangle around v, clockwise as far as the border, or any. */
static int first_at(const ix__cdt *c, int v)
{
    int start = c->at[v], t = start, b;

    while ((b = before(c, t, v)) >= 0 && b != start)
        t = b;
    return t;
}

static bool wants_flip(const ix__cdt *c, int t, int k)
{
    const ix__cdt_tri *r = &c->t[t];
    int u = r->n[k];

    if (u < 0 || r->odd[k])
        return false;
    return in_circle(c, r->v[0], r->v[1], r->v[2], c->t[u].v[side_to(c, u, t)]);
}

/* Delaunay's property around a new point. */
static void legalise(ix__cdt *c, int v)
{
    int start = first_at(c, v), t = start;

    do {
        while (wants_flip(c, t, corner_of(&c->t[t], v)))
            flip(c, t, corner_of(&c->t[t], v));
        t = after(c, t, v);
    } while (t >= 0 && t != start);
}

/* --- points -------------------------------------------------------------- */

static void split_triangle(ix__cdt *c, int t, int p)
{
    ix__cdt_tri r = c->t[t];
    int part[3] = {t, c->ntris, c->ntris + 1};

    c->ntris += 2;
    for (int k = 0; k < 3; k++) {
        int l = (k + 1) % 3, m = (k + 2) % 3;

        put(c, part[k],
            (ix__cdt_tri){.v = {p, r.v[l], r.v[m]},
                          .n = {r.n[k], part[l], part[m]},
                          .odd = {r.odd[k], false, false}});
        relink(c, r.n[k], t, part[k]);
    }
}

/* t becomes a b p, a new triangle a p d; p lies on the side b d opposite of
 * corner k. Returns the new one. */
static int split_half(ix__cdt *c, int t, int k, int p)
{
    ix__cdt_tri r = turned(&c->t[t], k);
    int more = c->ntris++;

    put(c, t,
        (ix__cdt_tri){.v = {r.v[0], r.v[1], p},
                      .n = {-1, more, r.n[2]},
                      .odd = {r.odd[0], false, r.odd[2]}});
    put(c, more,
        (ix__cdt_tri){.v = {r.v[0], p, r.v[2]},
                      .n = {-1, r.n[1], t},
                      .odd = {r.odd[0], r.odd[1], false}});
    relink(c, r.n[1], t, more);
    return more;
}

static void split_side(ix__cdt *c, int t, int k, int p)
{
    int u = c->t[t].n[k], j = u < 0 ? 0 : side_to(c, u, t), t1, u1;

    t1 = split_half(c, t, k, p);
    if (u < 0)
        return;
    u1 = split_half(c, u, j, p);
    c->t[t].n[0] = u1;
    c->t[t1].n[0] = u;
    c->t[u].n[0] = t1;
    c->t[u1].n[0] = t;
}

/* One of the sides that p lies beyond, from side k on; -1: none. */
static int beyond(const ix__cdt *c, int t, ix__cdt_point p)
{
    const ix__cdt_tri *r = &c->t[t];

    for (int k = 0; k < 3; k++)
        if (area(c->p[r->v[(k + 1) % 3]], c->p[r->v[(k + 2) % 3]], p) < 0)
            return k;
    return -1;
}

/* A triangle that holds p: by walking, which ends if the triangulation is
 * Delaunay's, else by looking at all. */
static int locate(const ix__cdt *c, ix__cdt_point p)
{
    int t = c->last < c->ntris ? c->last : 0, k;

    for (int steps = 0; steps < c->ntris; steps++) {
        k = beyond(c, t, p);
        if (k < 0)
            return t;
        t = c->t[t].n[k];
    }
    for (t = 0; beyond(c, t, p) >= 0;)
        t++;
    return t;
}

static bool same(ix__cdt_point a, ix__cdt_point b)
{
    return a.x == b.x && a.y == b.y;
}

ix_status ix__cdt_point_at(ix__cdt *c, ix__cdt_point p, int *id)
{
    int t = locate(c, p), on = -1;

    c->last = t;
    for (int k = 0; k < 3; k++) {
        *id = c->t[t].v[k];
        if (same(c->p[*id], p))
            return IX_OK;
        if (area(c->p[c->t[t].v[(k + 1) % 3]], c->p[c->t[t].v[(k + 2) % 3]],
                 p) == 0)
            on = k;
    }
    if (c->npts == c->cap)
        IX_TRY(more_room(c, 2 * c->cap));
    *id = c->npts++;
    c->p[*id] = p;
    if (on < 0)
        split_triangle(c, t, *id);
    else
        split_side(c, t, on, *id);
    legalise(c, *id);
    return IX_OK;
}

int ix__cdt_border(const ix__cdt *c, int v, int *side)
{
    int t = first_at(c, v);

    *side = (corner_of(&c->t[t], v) + 2) % 3;
    return t;
}

/* --- edges --------------------------------------------------------------- */

/* Pairs of points that are still to be joined. */
typedef struct {
    int n, cap;
    int (*pair)[2];
} todo;

static ix_status push(ix__cdt *c, todo *l, int a, int b)
{
    int(*more)[2];

    if (a == b)
        return IX_OK;
    if (l->n == l->cap) {
        IX_SCRATCH(c->ctx, more, 2 * (size_t)l->cap + 16);
        if (l->n > 0)
            memcpy(more, l->pair, (size_t)l->n * sizeof *more);
        l->pair = more;
        l->cap = 2 * l->cap + 16;
    }
    l->pair[l->n][0] = a;
    l->pair[l->n++][1] = b;
    return IX_OK;
}

static void toggle_side(ix__cdt *c, int t, int k)
{
    int u = c->t[t].n[k];

    c->t[t].odd[k] = !c->t[t].odd[k];
    if (u >= 0) {
        int j = side_to(c, u, t);

        c->t[u].odd[j] = !c->t[u].odd[j];
    }
}

/* Edges lead through points that are nearer to them, in steps of the integers:
 * so edges that nearly coincide become one, instead of crossing each other
 * again wherever rounding moves a crossing. */
#define NEAR 4.0

/* Does v lie near the way from a to b, between them? o is orient(a, b, v). */
static bool on_way(const ix__cdt *c, int a, int b, int v, int64_t o)
{
    double bx = (double)c->p[b].x - c->p[a].x;
    double by = (double)c->p[b].y - c->p[a].y;
    double vx = (double)c->p[v].x - c->p[a].x;
    double vy = (double)c->p[v].y - c->p[a].y;
    double length2 = bx * bx + by * by, along = bx * vx + by * vy;

    return fabs((double)o) <= NEAR * sqrt(length2) && along > 0 &&
           along < length2;
}

/* What is met first on the way from a to b. */
typedef struct {
    int t, side; /* an edge: crossed, or (joined) the one from a to b */
    bool joined;
    int via; /* a point on the way, or -1 */
} way;

static way look_from(const ix__cdt *c, int a, int b)
{
    int start = first_at(c, a), t = start;

    do {
        const ix__cdt_tri *r = &c->t[t];
        int k = corner_of(r, a), p = r->v[(k + 1) % 3], q = r->v[(k + 2) % 3];
        int64_t op = orient(c, a, b, p), oq = orient(c, a, b, q);

        if (p == b || q == b)
            return (way){t, (k + (p == b ? 2 : 1)) % 3, true, -1};
        if (on_way(c, a, b, p, op))
            return (way){.via = p};
        if (on_way(c, a, b, q, oq))
            return (way){.via = q};
        if (op < 0 && oq > 0)
            return (way){t, k, false, -1};
        t = after(c, t, a);
    } while (t >= 0 && t != start);
    assert(false); /* the triangles fill the square */
    return (way){.via = a};
}

static int32_t inside(double x)
{
    return (int32_t)fmin(fmax(nearbyint(x), 1), IX__CDT_SIDE - 1);
}

/* The edge a b crosses the edge p q, which bounds the region: both get a common
 * point, as near as integers allow. The parity of p q goes over. */
static ix_status meet(ix__cdt *c, todo *l, int a, int b, int t, int side)
{
    int p = c->t[t].v[(side + 1) % 3], q = c->t[t].v[(side + 2) % 3], e;
    double op = (double)orient(c, a, b, p), oq = (double)orient(c, a, b, q);
    double s = op / (op - oq);
    ix__cdt_point x = {inside(c->p[p].x + s * ((double)c->p[q].x - c->p[p].x)),
                       inside(c->p[p].y + s * ((double)c->p[q].y - c->p[p].y))};

    if (c->crossings-- == 0)
        return IX_FAIL(c->ctx, IX_EUNABLE,
                       "the trimming curves cross one another everywhere");
    if (same(x, c->p[p]) || same(x, c->p[q])) {
        e = same(x, c->p[p]) ? p : q;
    } else {
        toggle_side(c, t, side);
        IX_TRY(ix__cdt_point_at(c, x, &e));
        IX_TRY(push(c, l, p, e));
        IX_TRY(push(c, l, e, q));
    }
    IX_TRY(push(c, l, a, e));
    return push(c, l, e, b);
}

/* Finds the edge of points v and w. */
static bool find_edge(const ix__cdt *c, int v, int w, int *t, int *side)
{
    int start = first_at(c, v);

    *t = start;
    do {
        int k = corner_of(&c->t[*t], v);

        for (int j = 1; j < 3; j++)
            if (c->t[*t].v[(k + j) % 3] == w) {
                *side = (k + 3 - j) % 3;
                return true;
            }
        *t = after(c, *t, v);
    } while (*t >= 0 && *t != start);
    return false;
}

/* One of the edges that a b crosses is flipped if its two triangles form a
 * convex quadrangle; *crosses: there is still an edge v w across. */
static bool flip_across(ix__cdt *c, int a, int b, int *v, int *w, bool *crosses)
{
    int t, k, x, y;

    *crosses = true;
    if (!find_edge(c, *v, *w, &t, &k))
        return false;
    x = c->t[t].v[k];
    y = c->t[c->t[t].n[k]].v[side_to(c, c->t[t].n[k], t)];
    if (!(orient(c, x, c->t[t].v[(k + 1) % 3], y) > 0 &&
          orient(c, x, y, c->t[t].v[(k + 2) % 3]) > 0))
        return false;
    flip(c, t, k);
    *v = x;
    *w = y;
    *crosses = x != a && x != b && y != a && y != b &&
               (orient(c, a, b, x) < 0) != (orient(c, a, b, y) < 0);
    return true;
}

/* All edges between a and b are flipped away; none of them is odd, and no
 * point lies on the line (Sloan 1993). */
static ix_status clear_way(ix__cdt *c, int a, int b, todo *across)
{
    size_t first = 0, n = (size_t)across->n, cap = n;

    while (n > 0) {
        int *e = across->pair[first % cap];
        bool crosses;

        (void)flip_across(c, a, b, &e[0], &e[1], &crosses);
        if (crosses) { /* at the end of the queue again */
            int *to = across->pair[(first + n) % cap];
            int v = e[0], w = e[1];

            to[0] = v;
            to[1] = w;
        } else {
            n--;
        }
        first++;
        IX_TRY(ix__poll(c->ctx));
    }
    return IX_OK;
}

/* Follows the line from a to b beyond side k of t; what it crosses is listed,
 * unless it meets a point or an odd edge: then that is dealt with first. */
static ix_status follow(ix__cdt *c, todo *l, int a, int b, int t, int k,
                        todo *across, bool *clear)
{
    *clear = false;
    for (;;) {
        int p = c->t[t].v[(k + 1) % 3], q = c->t[t].v[(k + 2) % 3], u, j, w;
        int64_t o;

        if (c->t[t].odd[k])
            return meet(c, l, a, b, t, k);
        IX_TRY(push(c, across, p, q));
        u = c->t[t].n[k];
        j = side_to(c, u, t);
        w = c->t[u].v[j];
        if (w == b) {
            *clear = true;
            return IX_OK;
        }
        o = orient(c, a, b, w);
        if (on_way(c, a, b, w, o)) {
            IX_TRY(push(c, l, a, w));
            return push(c, l, w, b);
        }
        /* u is w q p: to the right w takes the place of p */
        t = u;
        k = (j + (o > 0 ? 1 : 2)) % 3;
    }
}

/* One pair: joined, or replaced by other pairs. */
static ix_status join(ix__cdt *c, todo *l, int a, int b)
{
    way w = look_from(c, a, b);
    todo across = {0};
    bool clear;

    if (w.joined) {
        toggle_side(c, w.t, w.side);
        return IX_OK;
    }
    if (w.via >= 0) {
        IX_TRY(push(c, l, a, w.via));
        return push(c, l, w.via, b);
    }
    IX_TRY(follow(c, l, a, b, w.t, w.side, &across, &clear));
    if (!clear)
        return IX_OK;
    IX_TRY(clear_way(c, a, b, &across));
    return push(c, l, a, b);
}

ix_status ix__cdt_toggle(ix__cdt *c, int a, int b)
{
    todo l = {0};

    IX_TRY(push(c, &l, a, b));
    while (l.n > 0) {
        l.n--;
        IX_TRY(join(c, &l, l.pair[l.n][0], l.pair[l.n][1]));
    }
    return IX_OK;
}
