/* trisector_walk.c - curves equally far from a surface and two other objects,
 * by continuation.
 *
 * Over the foot X = S(u, v) with the normal N the centres are X + lambda N. The
 * sphere around such a centre through X passes through Y if
 *
 *   A + 2 lambda B = 0,  A = |X - Y|^2,  B = (X - Y).N,
 *
 * and touches another object at Y where lambda = -A / (2 B) is stationary in
 * its parameters r: A_r B - A B_r = 0. So each foot on another object makes a
 * function lambda(u, v); where those of two objects agree is a curve. As lambda
 * is stationary its derivative needs no derivative of the foot:
 *
 *   lambda_u = (A B_u - A_u B) / (2 B^2), A_u = 2 (X - Y).S_u, B_u = (X -
 * Y).N_u
 *
 * (S_u.N = 0). Curves start where the difference changes its sign along an edge
 * of a grid, whose feet the solver finds, and are followed by Newton's method.
 * All parameters are mapped to [0, 1]. */
#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "iritx/ops_mbisect.h"
#include "ops/trisector.h"

enum { SUBSTEPS = 4, NEWTON = 24, HALVINGS = 20, MOST = 8000 };
enum { COARSE = 4, FINE = 64 };

/* Value and derivatives in the mapped parameters; what an object lacks is 0. */
typedef struct {
    double x[3], d[2][3], dd[3][3]; /* dd: rr, rs, ss */
} jet;

typedef struct {
    ix_ctx *ctx;
    const ix_mv *m[3];
    double dom[3][2][2];
    const double *box;
    double step;
    ix__trace *t;
    struct place *known; /* all vertices, in step with t from first on */
    size_t first, cap;
} walk;

/* A foot on the base, feet on both others, the centre. */
typedef struct place {
    double uv[2], r[2][2];
    double f, grad[2]; /* the difference of both lambdas, times |N| */
    double x[3];
} place;

/* --- points of the objects --------------------------------------------------
 */

static ix_status partial(const walk *w, int i, const double *t, int a, int b,
                         double h[4])
{
    const ix_mv *m = w->m[i];
    double v[IX_MAX_COORDS + 1], f = 1.0;
    int order[2] = {a, b}, r = m->rational;

    IX_TRY(ix_mv_partial(w->ctx, m, t, order, v));
    for (int k = 0; k < 2; k++)
        for (int j = 0; j < order[k]; j++)
            f *= w->dom[i][k][1] - w->dom[i][k][0];
    h[0] = r ? f * v[0] : (double)(a + b == 0);
    for (int k = 0; k < 3; k++)
        h[k + 1] = k < m->ncoords ? f * v[k + r] : 0.0;
    return IX_OK;
}

/* The quotient rule; false at a pole. */
static bool divide(double h[6][4], jet *o)
{
    static const int pair[3][2] = {{0, 0}, {0, 1}, {1, 1}};
    double w = h[0][0];

    if (w == 0.0)
        return false;
    for (int c = 0; c < 3; c++) {
        o->x[c] = h[0][c + 1] / w;
        for (int k = 0; k < 2; k++)
            o->d[k][c] = (h[k + 1][c + 1] - o->x[c] * h[k + 1][0]) / w;
        for (int k = 0; k < 3; k++)
            o->dd[k][c] = (h[k + 3][c + 1] - o->x[c] * h[k + 3][0] -
                           o->d[pair[k][0]][c] * h[pair[k][1] + 1][0] -
                           o->d[pair[k][1]][c] * h[pair[k][0] + 1][0]) /
                          w;
    }
    return true;
}

/* Object i at p in [0, 1]. */
static ix_status jet_of(const walk *w, int i, const double *p, jet *o, bool *ok)
{
    static const int order[6][2] = {{0, 0}, {1, 0}, {0, 1},
                                    {2, 0}, {1, 1}, {0, 2}};
    double h[6][4] = {{0}}, t[2] = {0, 0};
    int n = w->m[i]->ndirs;

    for (int k = 0; k < n; k++)
        t[k] = fmin(
            fmax(w->dom[i][k][0] + p[k] * (w->dom[i][k][1] - w->dom[i][k][0]),
                 w->dom[i][k][0]),
            w->dom[i][k][1]);
    for (int k = 0; k < 6; k++)
        if (n == 2 || order[k][1] == 0)
            IX_TRY(partial(w, i, t, order[k][0], order[k][1], h[k]));
    *ok = divide(h, o);
    return IX_OK;
}

/* --- a foot on another object -----------------------------------------------
 */

/* N and its derivatives. */
typedef struct {
    jet s;
    double n[3], nu[2][3], len;
} base;

static bool normal_of(base *b)
{
    const jet *s = &b->s;
    double a[3], c[3];

    ix__cross3(s->d[0], s->d[1], b->n);
    for (int k = 0; k < 2; k++) {
        ix__cross3(s->dd[k], s->d[1], a);
        ix__cross3(s->d[0], s->dd[k + 1], c);
        ix__axpy3(a, 1.0, c, b->nu[k]);
    }
    b->len = ix__len3(b->n);
    return b->len > 1e-10 * ix__len3(s->d[0]) * ix__len3(s->d[1]);
}

/* A, B and their derivatives in the parameters of Y. */
typedef struct {
    double e[3], a, b, ad[2], bd[2], add[3], bdd[3];
} pencil;

static void pencil_of(const base *s, const jet *y, pencil *p)
{
    static const int pair[3][2] = {{0, 0}, {0, 1}, {1, 1}};

    ix__sub3(s->s.x, y->x, p->e);
    p->a = ix__dot3(p->e, p->e);
    p->b = ix__dot3(p->e, s->n);
    for (int k = 0; k < 2; k++) {
        p->ad[k] = -2.0 * ix__dot3(p->e, y->d[k]);
        p->bd[k] = -ix__dot3(y->d[k], s->n);
    }
    for (int k = 0; k < 3; k++) {
        p->add[k] = 2.0 * (ix__dot3(y->d[pair[k][0]], y->d[pair[k][1]]) -
                           ix__dot3(p->e, y->dd[k]));
        p->bdd[k] = -ix__dot3(y->dd[k], s->n);
    }
}

/* The Newton step of n parameters for A_r B - A B_r = 0; false if singular. */
static bool newton(const pencil *p, int n, double step[2])
{
    double g[2], h[3], cross = p->ad[0] * p->bd[1] - p->ad[1] * p->bd[0], det;

    for (int k = 0; k < 2; k++)
        g[k] = p->ad[k] * p->b - p->a * p->bd[k];
    for (int k = 0; k < 3; k++)
        h[k] = p->add[k] * p->b - p->a * p->bdd[k];
    if (n == 1) {
        step[0] = -g[0] / h[0];
        step[1] = 0.0;
        return h[0] != 0.0;
    }
    /* rows (h0, h1 + cross), (h1 - cross, h2) */
    det = h[0] * h[2] - (h[1] + cross) * (h[1] - cross);
    step[0] = ((h[1] + cross) * g[1] - h[2] * g[0]) / det;
    step[1] = ((h[1] - cross) * g[0] - h[0] * g[1]) / det;
    return det != 0.0;
}

/* Moves r to the stationary foot next to it on object i; false if there is none
 * in its domain. */
static ix_status settle(const walk *w, int i, const base *s, double r[2],
                        pencil *p, bool *ok)
{
    int n = ix__is_point(w->m[i]) ? 0 : w->m[i]->ndirs;
    double last = HUGE_VAL;
    jet y;

    for (int it = 0; it < NEWTON; it++) {
        double step[2] = {0, 0}, want = 0.0, moved = 0.0;

        IX_TRY(jet_of(w, i, r, &y, ok));
        if (!*ok)
            return IX_OK;
        pencil_of(s, &y, p);
        *ok = n == 0 || newton(p, n, step);
        if (!*ok || n == 0)
            return IX_OK;
        for (int k = 0; k < n; k++) {
            double to = fmin(fmax(r[k] + step[k], 0.0), 1.0);

            want = fmax(want, fabs(step[k]));
            moved = fmax(moved, fabs(to - r[k]));
            r[k] = to;
        }
        /* jumps lead to other feet; what stays at the boundary is no foot */
        *ok = want < 0.25 && (moved > 0.0 || want < 1e-9);
        if (!*ok || want < 1e-15 || (want < 1e-8 && !(want < 0.5 * last)))
            return IX_OK;
        last = want;
    }
    *ok = last < 1e-8;
    return IX_OK;
}

/* --- the difference of both ------------------------------------------------
 */

/* Spheres smaller than this part of the box end a curve: at a point that all
 * three objects share nothing is left of the digits of lambda. */
#define TINY 1e-5

static double size_of(const walk *w)
{
    double size = 0.0;

    for (int k = 0; k < 6; k++)
        size = fmax(size, fabs(w->box[k]));
    return size;
}

/* Feet, value and gradient over p->uv, beginning with the feet that p has. */
static ix_status look(const walk *w, place *p, bool *ok)
{
    double lambda[2], grad[2][2];
    pencil c;
    base s;

    IX_TRY(jet_of(w, 0, p->uv, &s.s, ok));
    *ok = *ok && normal_of(&s);
    for (int i = 0; i < 2 && *ok; i++) {
        IX_TRY(settle(w, i + 1, &s, p->r[i], &c, ok));
        *ok = *ok && c.b != 0.0;
        if (!*ok)
            return IX_OK;
        lambda[i] = -c.a / (2.0 * c.b);
        for (int k = 0; k < 2; k++)
            grad[i][k] = (c.a * ix__dot3(c.e, s.nu[k]) -
                          2.0 * ix__dot3(c.e, s.s.d[k]) * c.b) /
                         (2.0 * c.b * c.b);
    }
    if (!*ok)
        return IX_OK;
    *ok = fabs(lambda[0]) * s.len > TINY * size_of(w);
    p->f = (lambda[0] - lambda[1]) * s.len;
    for (int k = 0; k < 2; k++)
        p->grad[k] = (grad[0][k] - grad[1][k]) * s.len;
    ix__axpy3(s.s.x, 0.5 * (lambda[0] + lambda[1]), s.n, p->x);
    return IX_OK;
}

/* Onto the curve, inside the domain and the box. */
static ix_status correct(const walk *w, place *p, bool *ok)
{
    for (int it = 0; it < NEWTON; it++) {
        double g2, moved = 0.0;

        IX_TRY(look(w, p, ok));
        if (!*ok)
            return IX_OK;
        g2 = p->grad[0] * p->grad[0] + p->grad[1] * p->grad[1];
        if (fabs(p->f) <= 1e-13 * size_of(w)) {
            *ok = ix__in_box(p->x, w->box);
            return IX_OK;
        }
        for (int k = 0; k < 2; k++) {
            double d = -p->f * p->grad[k] / g2;

            p->uv[k] += d;
            moved = fmax(moved, fabs(d));
            *ok = *ok && p->uv[k] >= 0.0 && p->uv[k] <= 1.0;
        }
        *ok = *ok && moved < 4.0 * w->step;
        if (!*ok)
            return IX_OK;
    }
    *ok = fabs(p->f) <= 1e-10 * size_of(w) && ix__in_box(p->x, w->box);
    return IX_OK;
}

/* --- following --------------------------------------------------------------
 */

static ix_status keep(walk *w, const place *p, bool joined)
{
    size_t n = w->t->n - w->first;

    if (n == w->cap) {
        size_t cap = w->cap ? 2 * w->cap : 256;
        place *more;

        IX_SCRATCH(w->ctx, more, cap);
        if (n > 0)
            memcpy(more, w->known, n * sizeof *more);
        w->known = more;
        w->cap = cap;
    }
    w->known[n] = *p;
    return ix__trace_add(w->ctx, w->t, p->x, joined);
}

static void params(const place *p, double x[6])
{
    memcpy(x, p->uv, sizeof p->uv);
    memcpy(x + 2, p->r, sizeof p->r);
}

static double apart(const place *a, const place *b)
{
    double x[6], y[6], d = 0.0;

    params(a, x);
    params(b, y);
    for (int k = 0; k < 6; k++)
        d = fmax(d, fabs(x[k] - y[k]));
    return d;
}

/* The next place in the direction side, as far as h if possible: near an end of
 * the curve less; false at the end. */
static ix_status advance(const walk *w, const place *from, double side,
                         place *to, bool *ok)
{
    double len = hypot(from->grad[0], from->grad[1]), h = w->step;

    *ok = false;
    for (int i = 0; i < HALVINGS && !*ok && len > 0.0; i++, h *= 0.5) {
        *to = *from;
        to->uv[0] -= side * h * from->grad[1] / len;
        to->uv[1] += side * h * from->grad[0] / len;
        *ok = to->uv[0] >= 0.0 && to->uv[0] <= 1.0 && to->uv[1] >= 0.0 &&
              to->uv[1] <= 1.0;
        if (!*ok)
            continue;
        IX_TRY(correct(w, to, ok));
        /* the same branch: neither foot nor direction jump */
        *ok = *ok && apart(from, to) <= 16.0 * h &&
              from->grad[0] * to->grad[0] + from->grad[1] * to->grad[1] > 0.0;
    }
    return IX_OK;
}

/* From the seed to one side; closed if it comes back. */
static ix_status follow(const walk *w, const place *seed, double side,
                        place *out, int *n, bool *closed)
{
    place at = *seed, next;
    double way = 0.0;
    bool ok;

    *closed = false;
    for (*n = 0; *n < MOST; ++*n) {
        IX_TRY(ix__poll(w->ctx));
        IX_TRY(advance(w, &at, side, &next, &ok));
        if (!ok)
            return IX_OK;
        way += apart(&at, &next);
        out[*n] = at = next;
        *closed = way > 2.0 * w->step && apart(&at, seed) < 0.75 * w->step;
        if (*closed)
            return IX_OK;
    }
    return IX_OK;
}

static ix_status trace_from(walk *w, const place *seed, place *room)
{
    bool closed, joined = false;
    int n, m = 0;

    IX_TRY(follow(w, seed, 1.0, room, &n, &closed));
    if (!closed)
        IX_TRY(follow(w, seed, -1.0, room + MOST, &m, &joined));
    joined = false;
    for (int i = m - 1; i >= 0; i--, joined = true)
        IX_TRY(keep(w, &room[MOST + i], joined));
    IX_TRY(keep(w, seed, joined));
    for (int i = 0; i < n; i++)
        IX_TRY(keep(w, &room[i], true));
    return closed ? keep(w, seed, true) : IX_OK;
}

/* Whether the seed lies on what has been traced: next to a segment, in all
 * parameters. */
static bool is_known(const walk *w, const place *seed)
{
    double s[6], a[6], b[6];

    params(seed, s);
    for (size_t i = w->first + 1; i < w->t->n; i++) {
        double ab = 0.0, as = 0.0, far = 0.0, u;

        if (!w->t->joined[i])
            continue;
        params(&w->known[i - 1 - w->first], a);
        params(&w->known[i - w->first], b);
        for (int k = 0; k < 6; k++) {
            ab += (b[k] - a[k]) * (b[k] - a[k]);
            as += (b[k] - a[k]) * (s[k] - a[k]);
        }
        u = ab > 0.0 ? fmin(fmax(as / ab, 0.0), 1.0) : 0.0;
        for (int k = 0; k < 6; k++)
            far = fmax(far, fabs(a[k] + u * (b[k] - a[k]) - s[k]));
        if (far <= 0.1 * w->step)
            return true;
    }
    return false;
}

/* --- seeds ------------------------------------------------------------------
 */

/* Feet on one of the other objects over the nodes of a grid. */
typedef struct {
    int *first;     /* [nodes + 1] */
    double (*r)[2]; /* in [0, 1] */
} feet;

static ix_status one_foot(ix_ctx *ctx, int nodes, feet *f)
{
    IX_SCRATCH(ctx, f->first, nodes + 1);
    IX_SCRATCH(ctx, f->r, nodes);
    memset(f->r, 0, (size_t)nodes * sizeof *f->r);
    for (int i = 0; i <= nodes; i++)
        f->first[i] = i;
    return IX_OK;
}

/* Points come ordered by node. */
static ix_status sort_feet(const walk *w, int i, int n,
                           const ix_bisector_point *p, int count, feet *f)
{
    int nodes = (n + 1) * (n + 1), at = 0;

    IX_SCRATCH(w->ctx, f->first, nodes + 1);
    IX_SCRATCH(w->ctx, f->r, count + 1);
    for (int node = 0; node < nodes; node++) {
        f->first[node] = at;
        for (; at < count; at++) {
            int of[2];

            for (int k = 0; k < 2; k++)
                of[k] = (int)lround((p[at].uv[k] - w->dom[0][k][0]) /
                                    (w->dom[0][k][1] - w->dom[0][k][0]) * n);
            if (of[1] * (n + 1) + of[0] != node)
                break;
            for (int k = 0; k < 2; k++)
                f->r[at][k] = k < w->m[i]->ndirs
                                  ? (p[at].on[k] - w->dom[i][k][0]) /
                                        (w->dom[i][k][1] - w->dom[i][k][0])
                                  : 0.0;
        }
    }
    f->first[nodes] = at;
    return IX_OK;
}

static ix_status feet_of(const walk *w, int i, int n, feet *f)
{
    ix_bisector_point *p;
    ix_status st;
    int count;

    if (ix__is_point(w->m[i]))
        return one_foot(w->ctx, (n + 1) * (n + 1), f);
    IX_TRY(ix_mbisector_points(w->ctx, w->m[0], w->m[i], n, &p, &count));
    st = sort_feet(w, i, n, p, count, f);
    ix_bisector_points_free(w->ctx, p, count);
    return st;
}

/* The zero between a and b, of different signs, and the curve through it. */
static ix_status start_between(walk *w, place a, place b, place *room)
{
    bool ok;

    for (int i = 0; i < 30; i++) {
        place mid = a;

        for (int k = 0; k < 2; k++)
            mid.uv[k] = 0.5 * (a.uv[k] + b.uv[k]);
        IX_TRY(look(w, &mid, &ok));
        if (!ok)
            return IX_OK;
        *((mid.f < 0) == (a.f < 0) ? &a : &b) = mid;
    }
    IX_TRY(correct(w, &a, &ok));
    /* a jump of the difference through infinity is no zero */
    return ok && !is_known(w, &a) ? trace_from(w, &a, room) : IX_OK;
}

/* Along an edge of the grid, with the feet at its begin. */
static ix_status along_edge(walk *w, const place *from, const double to[2],
                            place *room)
{
    place a = *from, b;
    bool ok;

    IX_TRY(look(w, &a, &ok));
    for (int i = 1; ok && i <= SUBSTEPS; i++) {
        b = a;
        for (int k = 0; k < 2; k++)
            b.uv[k] = from->uv[k] +
                      (to[k] - from->uv[k]) * (double)i / SUBSTEPS;
        IX_TRY(look(w, &b, &ok));
        if (ok && (a.f < 0) != (b.f < 0))
            IX_TRY(start_between(w, a, b, room));
        a = b;
    }
    return IX_OK;
}

/* All four edges of a node, for each pair of feet. */
static ix_status from_node(walk *w, int n, int node, const feet *f, place *room)
{
    int col = node % (n + 1), row = node / (n + 1);

    for (int i = f[0].first[node]; i < f[0].first[node + 1]; i++)
        for (int j = f[1].first[node]; j < f[1].first[node + 1]; j++)
            for (int e = 0; e < 4; e++) {
                int c = col + (e == 0) - (e == 1),
                    r = row + (e == 2) - (e == 3);
                place p = {.uv = {(double)col / n, (double)row / n}};
                const double to[2] = {(double)c / n, (double)r / n};

                if (c < 0 || c > n || r < 0 || r > n)
                    continue;
                memcpy(p.r[0], f[0].r[i], sizeof p.r[0]);
                memcpy(p.r[1], f[1].r[j], sizeof p.r[1]);
                IX_TRY(along_edge(w, &p, to, room));
            }
    return ix__poll(w->ctx);
}

ix_status ix__trisector_walk(ix_ctx *ctx, const ix_mv *const m[3], double step,
                             const double box[6], ix__trace *t)
{
    walk w = {.ctx = ctx, .box = box, .step = step, .t = t, .first = t->n};
    int n = (int)fmin(fmax(ceil(1.0 / step), COARSE), FINE);
    place *room;
    feet f[2];

    for (int i = 0; i < 3; i++) {
        w.m[i] = m[i];
        for (int k = 0; k < m[i]->ndirs; k++)
            ix_mv_domain(m[i], k, w.dom[i][k]);
    }
    IX_SCRATCH(ctx, room, 2 * MOST);
    for (int i = 0; i < 2; i++)
        IX_TRY(feet_of(&w, i + 1, n, &f[i]));
    for (int node = 0; node < (n + 1) * (n + 1); node++)
        IX_TRY(from_node(&w, n, node, f, room));
    return IX_OK;
}
