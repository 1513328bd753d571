/* trisector_feet.c - where feet of normals through a box may be.
 *
 * With C = c + dC in the box and u = m + du in a box of parameters, tangency is
 *
 *   0 = g(c, m) + T dC + G du,  G_ab = (c - X).T_a,b - X_b.T_a,
 *
 * T and G within bounds over the parameters. The inverse A of G in the middle
 * bounds du; where G may be singular, near the centres of curvature, boxes of
 * parameters are halved until the planes of their normals move through the box
 * no farther than it is wide. */
#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "ops/trisector_impl.h"

/* --- bounds -----------------------------------------------------------------
 */

void ix__tri_measure(const ix__tri_object *o, double margin, ix__tri_foot *f)
{
    const ix__tri_span *s = &o->span[f->span];
    double lo[2], hi[2];

    for (int a = 0; a < 2; a++) {
        lo[a] = f->mid[a] - (1.0 + margin) * f->half[a];
        hi[a] = f->mid[a] + (1.0 + margin) * f->half[a];
    }
    f->bounded = ix__tri_bounds(s, lo, hi, &f->m, &f->h);
    ix__tri_jet_at(s, f->mid, &f->at);
}

void ix__tri_distances(const ix__tri_box *b, const ix__tri_foot *f, double d[2])
{
    d[0] = d[1] = 0.0;
    for (int c = 0; c < 3; c++) {
        double gap = fabs(b->c[c] - f->m.x[c]), w = b->h[c] + f->h.x[c];
        double near = fmax(gap - w, 0.0), far = gap + w;

        d[0] += near * near;
        d[1] += far * far;
    }
    d[0] = f->bounded ? sqrt(d[0]) : 0.0;
    d[1] = f->bounded ? sqrt(d[1]) : HUGE_VAL;
}

double ix__tri_diameter(const ix__tri_box *b)
{
    return 2.0 * sqrt(ix__dot3(b->h, b->h));
}

/* Whether a normal plane of the piece may meet the box. */
static bool may_touch(const ix__tri_box *b, const ix__tri_foot *f, int ndirs)
{
    double r[3], hr[3];

    ix__sub3(b->c, f->m.x, r);
    ix__axpy3(b->h, 1.0, f->h.x, hr);
    for (int a = 0; a < ndirs; a++)
        if (fabs(ix__dot3(r, f->m.t[a])) >
            ix__tri_dot_half(r, hr, f->m.t[a], f->h.t[a]))
            return false;
    return true;
}

/* G: middle and half widths, relative to the tangents' lengths and for
 * parameters from -1 to 1. */
typedef struct {
    double g[2][2], h[2][2], len[2];
    double w, hw; /* weight in the middle, and half width, over its mean */
} turning;

static void turning_of(const ix__tri_object *object, const ix__tri_box *b,
                       const ix__tri_foot *f, turning *o)
{
    const ix__tri_span *s = &object->span[f->span];
    double lo[2], hi[2];
    ix__tri_turn turn;

    for (int a = 0; a < 2; a++) {
        lo[a] = f->mid[a] - f->half[a];
        hi[a] = f->mid[a] + f->half[a];
    }
    ix__tri_turning(s, lo, hi, b->c, &turn);
    o->w = f->at.w / turn.w;
    o->hw = turn.hw / fabs(turn.w);
    for (int a = 0; a < s->ndirs; a++) {
        const double *t = f->m.t[a];

        o->len[a] = fmax(sqrt(ix__dot3(t, t)), 1e-300);
        for (int k = 0; k < s->ndirs; k++) {
            double v = f->half[k] / (o->len[a] * turn.w);

            o->g[a][k] = v * turn.g[a][k];
            o->h[a][k] = fabs(v) * turn.h[a][k];
        }
    }
}

/* How much more the uncertainty of G counts than G: near centres of curvature,
 * where G vanishes, centres move with the square of a foot's parameter, and
 * both boxes must fit each other. */
#define BENT 8.0

/* How far the normal planes move in the box, and the parameter that moves them
 * most. */
static double extent(const turning *o, int ndirs, int *axis)
{
    double most = 0.0;

    *axis = 0;
    for (int a = 0; a < ndirs; a++)
        for (int k = 0; k < ndirs; k++) {
            double m = 2.0 * (fabs(o->g[a][k]) + BENT * o->h[a][k]);

            if (m > most) {
                most = m;
                *axis = k;
            }
        }
    return most;
}

/* --- smaller boxes ----------------------------------------------------------
 */

/* Of the box: rounding of the values. */
#define ROUNDING 1e-6
/* Less than this is not worth another look. */
#define GAIN 0.8

static bool invert2(int n, const double g[2][2], double inv[2][2])
{
    double det = n == 1 ? g[0][0] : g[0][0] * g[1][1] - g[0][1] * g[1][0];

    if (n == 1) {
        inv[0][0] = 1.0 / det;
        return det != 0.0;
    }
    inv[0][0] = g[1][1] / det;
    inv[1][1] = g[0][0] / det;
    inv[0][1] = -g[0][1] / det;
    inv[1][0] = -g[1][0] / det;
    return det != 0.0;
}

/* Of 1, how much the inverse of G may miss it: below, the foot is a function of
 * the centre. */
#define REGULAR 0.3

/* Whether each centre has at most one foot in the box of parameters. */
static bool is_regular(int ndirs, const turning *o)
{
    double inv[2][2];

    if (!invert2(ndirs, o->g, inv))
        return false;
    for (int k = 0; k < ndirs; k++) {
        double e = 0.0;

        for (int a = 0; a < ndirs; a++)
            for (int j = 0; j < ndirs; j++)
                e += fabs(inv[k][a]) * o->h[a][j];
        if (!(e <= REGULAR))
            return false;
    }
    return true;
}

/* Narrows the parameters to where tangency can hold; false if nowhere. *gain:
 * the least part of a side that is left. */
static bool narrow(const ix__tri_box *b, ix__tri_foot *f, int ndirs,
                   const turning *o, double *gain)
{
    double inv[2][2], g0[2], th[2][3], r[3], lo[2], hi[2];

    *gain = 1.0;
    if (!invert2(ndirs, o->g, inv))
        return true;
    ix__sub3(b->c, f->at.x, r);
    for (int a = 0; a < ndirs; a++) {
        g0[a] = o->w * ix__dot3(r, f->at.t[a]) / o->len[a];
        for (int c = 0; c < 3; c++)
            th[a][c] = (f->h.t[a][c] * (1.0 + o->hw) +
                        fabs(f->m.t[a][c]) * o->hw) /
                       o->len[a];
    }
    for (int k = 0; k < ndirs; k++) {
        double at = 0.0, e = 0.0, t;

        for (int a = 0; a < ndirs; a++) {
            at -= inv[k][a] * g0[a];
            for (int j = 0; j < ndirs; j++)
                e += fabs(inv[k][a]) * o->h[a][j];
        }
        for (int c = 0; c < 3; c++) {
            t = 0.0;
            for (int a = 0; a < ndirs; a++) {
                t += inv[k][a] * f->m.t[a][c] / o->len[a];
                e += fabs(inv[k][a]) * th[a][c] * b->h[c];
            }
            e += fabs(t) * b->h[c];
        }
        lo[k] = fmax(at - e - ROUNDING, -1.0);
        hi[k] = fmin(at + e + ROUNDING, 1.0);
        if (!(lo[k] <= hi[k]))
            return !(at - e > 1.0 || at + e < -1.0);
        *gain = fmin(*gain, 0.5 * (hi[k] - lo[k]));
    }
    for (int k = 0; k < ndirs; k++) {
        f->mid[k] += 0.5 * (lo[k] + hi[k]) * f->half[k];
        f->half[k] *= 0.5 * (hi[k] - lo[k]);
    }
    return true;
}

/* --- all feet ---------------------------------------------------------------
 */

enum { ROUNDS = 4, DEEPEST = 200 };

static ix_status keep(ix_ctx *ctx, ix__tri_feet *out, const ix__tri_foot *f)
{
    if (out->n == out->cap) {
        int cap = out->cap ? 2 * out->cap : 64;
        ix__tri_foot *more;

        IX_SCRATCH(ctx, more, cap);
        if (out->n > 0)
            memcpy(more, out->f, (size_t)out->n * sizeof *more);
        out->f = more;
        out->cap = cap;
    }
    out->f[out->n++] = *f;
    return IX_OK;
}

/* Whether the normal planes of f move through the box no farther than diam. */
static bool is_small(const ix__tri_object *object, const ix__tri_box *b,
                     const ix__tri_foot *f, double diam)
{
    int ndirs = object->ndirs;
    turning o;
    int axis;

    if (!f->bounded)
        return false;
    turning_of(object, b, f, &o);
    return extent(&o, ndirs, &axis) <= diam || is_regular(ndirs, &o);
}

/* Joins boxes from first on that touch, as of a foot on the border of two
 * halves, if the result is small. */
static void merge(const ix__tri_object *object, const ix__tri_box *b,
                  double diam, ix__tri_feet *out)
{
    for (int i = 0; i < out->n; i++)
        for (int j = i + 1; j < out->n; j++) {
            ix__tri_foot *f = &out->f[i], both = *f;
            const ix__tri_foot *g = &out->f[j];
            const ix__tri_span *s = &object->span[f->span];
            bool touch = f->span == g->span;

            for (int a = 0; a < s->ndirs && touch; a++) {
                double lo = fmin(f->mid[a] - f->half[a],
                                 g->mid[a] - g->half[a]);
                double hi = fmax(f->mid[a] + f->half[a],
                                 g->mid[a] + g->half[a]);

                touch = fabs(f->mid[a] - g->mid[a]) <=
                        (f->half[a] + g->half[a]) * (1.0 + 1e-9);
                both.mid[a] = 0.5 * (lo + hi);
                both.half[a] = 0.5 * (hi - lo);
            }
            if (!touch)
                continue;
            ix__tri_measure(object, 0.0, &both);
            if (!is_small(object, b, &both, diam))
                continue;
            *f = both;
            out->f[j] = out->f[--out->n];
            j = i; /* all others once more */
        }
}

/* Of the box: parameters of smaller boxes are not told apart. */
#define FINEST 1e-9

typedef enum { EMPTY, SMALL, LARGE } state;

/* f narrowed as far as that goes. */
static state settle(const ix__tri_object *o, const ix__tri_box *b, double diam,
                    ix__tri_foot *f, int *axis)
{
    int ndirs = o->ndirs;

    *axis = ndirs > 1 && f->half[1] > f->half[0];
    for (int round = 0; round < ROUNDS; round++) {
        double gain = 1.0;
        turning g;

        ix__tri_measure(o, 0.0, f);
        if (!f->bounded)
            break;
        if (!may_touch(b, f, ndirs))
            return EMPTY;
        if (ndirs == 0)
            return SMALL;
        turning_of(o, b, f, &g);
        if (extent(&g, ndirs, axis) <= diam)
            return SMALL;
        if (!narrow(b, f, ndirs, &g, &gain))
            return EMPTY;
        if (gain > GAIN && is_regular(ndirs, &g))
            return SMALL;
        if (gain > GAIN)
            break;
    }
    return f->half[*axis] > FINEST ? LARGE : SMALL;
}

ix_status ix__tri_feet_in(ix_ctx *ctx, const ix__tri_object *object,
                          const ix__tri_box *b, const double distance[2],
                          const ix__tri_place *from, int n, ix__tri_feet *out)
{
    double diam = IX__TRI_COARSE * ix__tri_diameter(b);
    ix__tri_place stack[DEEPEST];

    for (int i = 0; i < n; i++) {
        int top = 0;

        stack[top++] = from[i];
        while (top > 0) {
            ix__tri_place p = stack[--top];
            ix__tri_foot f = {.span = p.span};
            double d[2];
            int axis;
            state st;

            for (int a = 0; a < 2; a++) {
                f.mid[a] = p.mid[a];
                f.half[a] = p.half[a];
            }
            st = settle(object, b, diam, &f, &axis);
            if (st == EMPTY)
                continue;
            ix__tri_distances(b, &f, d);
            if (d[0] > distance[1] || d[1] < distance[0])
                continue;
            if (st == SMALL || top + 2 > DEEPEST) {
                IX_TRY(keep(ctx, out, &f));
                continue;
            }
            for (int side = -1; side <= 1; side += 2) {
                ix__tri_place *half = &stack[top++];

                *half = (ix__tri_place){.span = f.span};
                for (int a = 0; a < 2; a++) {
                    half->mid[a] = f.mid[a];
                    half->half[a] = f.half[a];
                }
                half->half[axis] *= 0.5;
                half->mid[axis] += side * half->half[axis];
            }
        }
    }
    if (object->ndirs > 0)
        merge(object, b, diam, out);
    return IX_OK;
}
