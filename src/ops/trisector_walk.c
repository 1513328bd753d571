/* trisector_walk.c - following a trisector from a point of it, by Newton's
 * method, to the borders of its spans and of the box. Lengths are measured in
 * parts of the box and of the domains. */
#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "ops/trisector_impl.h"

enum { NV = IX__TRI_VARS, NEWTON = 12, HALVINGS = 24, MOST = 20000 };

typedef struct {
    const ix__tri_task *k;
    const ix__tri_span *span[3];
    double lo[NV], hi[NV], unit[NV];
} space;

static space space_of(const ix__tri_task *k, const int span[3])
{
    space s = {.k = k};

    for (int a = 0; a < 3; a++) {
        s.lo[a] = k->box[a];
        s.hi[a] = k->box[3 + a];
        s.unit[a] = k->size;
    }
    for (int i = 0; i < 3; i++) {
        s.span[i] = &k->object[i].span[span[i]];
        for (int a = 0; a < s.span[i]->ndirs; a++) {
            int at = k->shape.at[i] + a;

            s.lo[at] = 0.0;
            s.hi[at] = 1.0;
            s.unit[at] = 1.0 / s.span[i]->part[a];
        }
    }
    return s;
}

/* --- Newton -----------------------------------------------------------------
 */

/* The Jacobian in units, and the values. */
static void system_at(const space *s, const double *z, ix__tri_matrix m,
                      double f[IX__TRI_EQS])
{
    const ix__tri_shape *sh = &s->k->shape;
    ix__tri_jet jet[3];
    const ix__tri_jet *const j[3] = {&jet[0], &jet[1], &jet[2]};

    for (int i = 0; i < 3; i++)
        ix__tri_jet_at(s->span[i], z + sh->at[i], &jet[i]);
    ix__tri_values(sh, z, j, f);
    ix__tri_jacobian(sh, z, j, m);
    for (int r = 0; r < sh->neqs; r++)
        for (int c = 0; c < sh->nvars; c++)
            m[r][c] *= s->unit[c];
}

#define FAR  0.5   /* steps of the whole domain lead elsewhere */
#define DONE 1e-14 /* a step: rounding */
#define NEAR 1e-9  /* the last step if they no longer decrease */

static bool correct(const space *s, int fixed, double *z)
{
    const ix__tri_shape *sh = &s->k->shape;
    double last = HUGE_VAL;

    for (int it = 0; it < NEWTON; it++) {
        double f[IX__TRI_EQS], moved = 0.0;
        ix__tri_inverse inv;
        ix__tri_matrix m;

        system_at(s, z, m, f);
        if (!ix__tri_invert(sh, m, fixed, &inv))
            return false;
        for (int r = 0; r < sh->neqs; r++) {
            double d = 0.0;

            for (int q = 0; q < sh->neqs; q++)
                d -= inv.inv[r][q] * f[q];
            z[inv.of[r]] += d * s->unit[inv.of[r]];
            moved = fmax(moved, fabs(d));
        }
        if (!(moved <= FAR))
            return false;
        if (moved <= DONE || (moved <= NEAR && moved >= 0.5 * last))
            return true;
        last = moved;
    }
    return last <= NEAR;
}

bool ix__tri_correct(const ix__tri_task *k, const int span[3], int fixed,
                     double *z)
{
    space s = space_of(k, span);

    return correct(&s, fixed, z);
}

static bool large(const space *s, const double *z)
{
    ix__tri_jet j;

    ix__tri_jet_at(s->span[0], z + s->k->shape.at[0], &j);
    return ix__dist3(z, j.x) > IX__TRI_TINY * s->k->size;
}

/* By more than the border's width. */
static bool within(const space *s, const double *z)
{
    for (int c = 0; c < s->k->shape.nvars; c++) {
        double slack = IX__TRI_BORDER * (c < 3 ? s->unit[c] : 1.0);

        if (!(z[c] >= s->lo[c] - slack && z[c] <= s->hi[c] + slack))
            return false;
    }
    return true;
}

bool ix__tri_inside(const ix__tri_task *k, const int span[3], const double *z)
{
    space s = space_of(k, span);

    return within(&s, z) && large(&s, z);
}

/* --- steps ------------------------------------------------------------------
 */

static double dot(int n, const double *a, const double *b)
{
    double s = 0.0;

    for (int i = 0; i < n; i++)
        s += a[i] * b[i];
    return s;
}

/* Of length 1, in units; false at a singular point. */
static bool tangent(const space *s, const double *z, double *t)
{
    const ix__tri_shape *sh = &s->k->shape;
    double f[IX__TRI_EQS], len;
    ix__tri_inverse inv;
    ix__tri_matrix m;

    system_at(s, z, m, f);
    if (!ix__tri_invert(sh, m, -1, &inv))
        return false;
    t[inv.free] = 1.0;
    for (int r = 0; r < sh->neqs; r++)
        t[inv.of[r]] = -inv.slope[r];
    len = sqrt(dot(sh->nvars, t, t));
    for (int c = 0; c < sh->nvars; c++)
        t[c] /= len;
    return true;
}

static double apart(const space *s, const double *a, const double *b)
{
    double d = 0.0;

    for (int c = 0; c < s->k->shape.nvars; c++)
        d = fmax(d, fabs(a[c] - b[c]) / s->unit[c]);
    return d;
}

typedef struct {
    double z[NV], t[NV];
} place;

/* From p as far as h along its tangent, or to the first border on the way:
 * then the result is its unknown, else that which changes most. */
static int predict(const space *s, const place *p, double h, double *z,
                   bool *border)
{
    int n = s->k->shape.nvars, fixed = 0;
    double part = 1.0, bound = 0.0;

    *border = false;
    for (int c = 0; c < n; c++) {
        double d = h * p->t[c] * s->unit[c], to = p->z[c] + d;
        double slack = IX__TRI_BORDER * (c < 3 ? s->unit[c] : 1.0);
        double edge = d > 0.0 ? s->hi[c] : s->lo[c], f = (edge - p->z[c]) / d;

        if (fabs(p->t[c]) > fabs(p->t[fixed]) && !*border)
            fixed = c;
        if ((to >= s->lo[c] - slack && to <= s->hi[c] + slack) || !(f < part))
            continue;
        part = fmax(f, 0.0);
        bound = edge;
        fixed = c;
        *border = true;
    }
    for (int c = 0; c < n; c++)
        z[c] = p->z[c] + part * h * p->t[c] * s->unit[c];
    if (*border)
        z[fixed] = bound;
    return fixed;
}

/* Of a step: how far curves are from the cubic of their ends and tangents. */
#define CUBIC 1e-2

/* The cubic with given ends and directions at u in [0, 1]. */
static void cubic(const space *s, const place *a, const place *b, double u,
                  double *z)
{
    int n = s->k->shape.nvars;
    double v = 1.0 - u, len = 0.0, side[2] = {0.0, 0.0};

    for (int c = 0; c < n; c++) {
        double d = (b->z[c] - a->z[c]) / s->unit[c];

        len += d * d;
        side[0] += d * a->t[c];
        side[1] += d * b->t[c];
    }
    len = sqrt(len);
    for (int c = 0; c < n; c++) {
        double da = copysign(len, side[0]) * s->unit[c] * a->t[c];
        double db = copysign(len, side[1]) * s->unit[c] * b->t[c];

        z[c] = v * v * (1.0 + 2.0 * u) * a->z[c] + u * v * v * da +
               u * u * (1.0 + 2.0 * v) * b->z[c] - u * u * v * db;
    }
}

/* Whether the curve between two places is their cubic: not if the step led to
 * another curve. */
static bool is_one(const space *s, const place *a, const place *b)
{
    double guess[NV], z[NV];
    int n = s->k->shape.nvars, fixed = 0;

    for (int c = 1; c < n; c++)
        if (fabs(b->z[c] - a->z[c]) / s->unit[c] >
            fabs(b->z[fixed] - a->z[fixed]) / s->unit[fixed])
            fixed = c;
    cubic(s, a, b, 0.5, guess);
    memcpy(z, guess, sizeof z);
    return correct(s, fixed, z) &&
           apart(s, guess, z) <= CUBIC * apart(s, a->z, b->z) + NEAR;
}

/* Of the tangents at both ends of a step. */
#define STRAIGHT 0.9

/* The next place, as far as *h if the curve is straight enough: chords stay
 * within step^2. False at a singular point. */
static bool advance(const space *s, const place *from, double *h, place *to,
                    bool *border)
{
    int n = s->k->shape.nvars;

    for (int i = 0; i < HALVINGS; i++, *h *= 0.5) {
        double guess[NV];
        int fixed = predict(s, from, *h, guess, border);

        memcpy(to->z, guess, sizeof guess);
        if (!correct(s, fixed, to->z) || !within(s, to->z) ||
            !(apart(s, guess, to->z) <=
              fmin(4.0 * s->k->step * s->k->step, 0.25 * *h)) ||
            !tangent(s, to->z, to->t))
            continue;
        if (dot(n, from->t, to->t) < 0.0)
            for (int c = 0; c < n; c++)
                to->t[c] = -to->t[c];
        if (dot(n, from->t, to->t) >= STRAIGHT && is_one(s, from, to))
            return true;
    }
    return false;
}

/* How far along the segment from a to b, from 0 to 1, the point next to z is;
 * in *off its distance, as a part of the segment's length. */
static double along(const space *s, const double *a, const double *b,
                    const double *z, double *off)
{
    double ab = 0.0, az = 0.0, far = 0.0, u;
    int n = s->k->shape.nvars;

    for (int c = 0; c < n; c++) {
        double d = (b[c] - a[c]) / s->unit[c];

        ab += d * d;
        az += d * (z[c] - a[c]) / s->unit[c];
    }
    u = ab > 0.0 ? fmin(fmax(az / ab, 0.0), 1.0) : 0.0;
    for (int c = 0; c < n; c++) {
        double d = (a[c] + u * (b[c] - a[c]) - z[c]) / s->unit[c];

        far += d * d;
    }
    *off = sqrt(far / fmax(ab, 1e-300));
    return u;
}

/* --- curves -----------------------------------------------------------------
 */

typedef struct {
    double *z;
    int n, cap;
} trail;

static ix_status keep(const space *s, trail *t, const double *z)
{
    int nv = s->k->shape.nvars;

    if (t->n == t->cap) {
        int cap = t->cap ? 2 * t->cap : 128;
        double *more;

        IX_SCRATCH(s->k->ctx, more, cap * nv);
        if (t->n > 0)
            memcpy(more, t->z, (size_t)(t->n * nv) * sizeof *more);
        t->z = more;
        t->cap = cap;
    }
    memcpy(t->z + (size_t)(t->n++ * nv), z, (size_t)nv * sizeof *z);
    return IX_OK;
}

/* A chord's distance from its curve, of its length. */
#define SAGITTA 0.1

/* Whether the seed is between two places, and the curve passes it as it did.
 */
static bool comes_back(const space *s, const place *a, const place *b,
                       const place *seed)
{
    double off, u = along(s, a->z, b->z, seed->z, &off);

    return u > 0.0 && off <= SAGITTA &&
           dot(s->k->shape.nvars, b->t, seed->t) > STRAIGHT;
}

/* To the side of the seed's tangent. */
static ix_status follow(ix__tri_task *k, const space *s, const place *seed,
                        trail *out, bool *closed)
{
    place at = *seed, next;
    double h = k->step;
    bool border;

    *closed = false;
    for (int n = 0; n < MOST; n++) {
        IX_TRY(ix__poll(k->ctx));
        if (!advance(s, &at, &h, &next, &border))
            return IX_OK;
        *closed = n >= 2 && comes_back(s, &at, &next, seed);
        if (*closed)
            return keep(s, out, seed->z);
        IX_TRY(keep(s, out, next.z));
        if (border || !large(s, next.z))
            return IX_OK;
        h = fmin(1.5 * h, k->step);
        at = next;
    }
    k->complete = false;
    return IX_OK;
}

/* Both sides, the first one backwards. */
static ix_status store(ix__tri_task *k, const int span[3], const trail *back,
                       const place *seed, const trail *on, bool closed)
{
    size_t nv = (size_t)k->shape.nvars;
    ix__tri_arc *a, *more;
    double *z;

    if (k->narcs == k->cap) {
        k->cap = k->cap ? 2 * k->cap : 32;
        IX_SCRATCH(k->ctx, more, k->cap);
        if (k->narcs > 0)
            memcpy(more, k->arc, (size_t)k->narcs * sizeof *more);
        k->arc = more;
    }
    a = &k->arc[k->narcs];
    *a = (ix__tri_arc){.n = back->n + 1 + on->n, .closed = closed};
    memcpy(a->span, span, sizeof a->span);
    IX_SCRATCH(k->ctx, z, (size_t)a->n * nv);
    a->z = z;
    for (int i = back->n - 1; i >= 0; i--, z += nv)
        memcpy(z, back->z + (size_t)i * nv, nv * sizeof *z);
    memcpy(z, seed->z, nv * sizeof *z);
    if (on->n > 0)
        memcpy(z + nv, on->z, (size_t)on->n * nv * sizeof *z);
    k->narcs++;
    return IX_OK;
}

/* Of two points of a curve that are the same. */
#define SAME 1e-7
/* Whether the curve of a segment goes through z. */
static bool passes(const space *s, const double *from, const double *to,
                   const double *z)
{
    double off, u = along(s, from, to, z, &off), at[NV];
    int n = s->k->shape.nvars, fixed = 0;
    place a, b;

    if (!(off <= SAGITTA))
        return false;
    memcpy(a.z, from, (size_t)n * sizeof *from);
    memcpy(b.z, to, (size_t)n * sizeof *to);
    if (!tangent(s, a.z, a.t) || !tangent(s, b.z, b.t))
        return false;
    for (int c = 0; c < n; c++)
        if (fabs(to[c] - from[c]) / s->unit[c] >
            fabs(to[fixed] - from[fixed]) / s->unit[fixed])
            fixed = c;
    for (int it = 0; it < 3; it++) {
        cubic(s, &a, &b, u, at);
        u += (z[fixed] - at[fixed]) / (to[fixed] - from[fixed]);
    }
    if (!(apart(s, at, z) <= CUBIC * apart(s, from, to) + SAME))
        return false;
    at[fixed] = z[fixed];
    return correct(s, fixed, at) && apart(s, at, z) <= SAME;
}

static bool is_known(const space *s, const int span[3], const double *z)
{
    const ix__tri_task *k = s->k;
    size_t nv = (size_t)k->shape.nvars;

    for (int i = 0; i < k->narcs; i++) {
        const ix__tri_arc *a = &k->arc[i];

        if (memcmp(a->span, span, sizeof a->span) != 0)
            continue;
        for (int v = 1; v < a->n; v++)
            if (passes(s, a->z + (size_t)(v - 1) * nv, a->z + (size_t)v * nv,
                       z))
                return true;
    }
    return false;
}

/* Whether most vertices of a trail are on curves that are there: a seed at a
 * sharp bend may not have been recognised. */
static bool is_repeated(const space *s, const int span[3], const trail *t)
{
    size_t nv = (size_t)s->k->shape.nvars;
    int known = 0;

    for (int v = 0; v < t->n; v++)
        known += is_known(s, span, t->z + (size_t)v * nv);
    return t->n > 0 && 2 * known > t->n;
}

ix_status ix__tri_trace(ix__tri_task *k, const int span[3], const double *z)
{
    space s = space_of(k, span);
    trail on = {.n = 0}, back = {.n = 0};
    bool closed, ignored;
    place seed;

    memcpy(seed.z, z, (size_t)k->shape.nvars * sizeof *z);
    if (is_known(&s, span, z) || !tangent(&s, z, seed.t))
        return IX_OK;
    IX_TRY(follow(k, &s, &seed, &on, &closed));
    for (int c = 0; c < k->shape.nvars; c++)
        seed.t[c] = -seed.t[c];
    if (!closed)
        IX_TRY(follow(k, &s, &seed, &back, &ignored));
    if (on.n + back.n == 0 || is_repeated(&s, span, &on) ||
        is_repeated(&s, span, &back))
        return IX_OK;
    return store(k, span, &back, &seed, &on, closed);
}
