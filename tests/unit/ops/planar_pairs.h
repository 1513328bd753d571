/* planar_pairs.h - pairs of planar curves for the true bisector: random ones,
 * and each kind of position that is special. */
#ifndef UNIT_OPS_PLANAR_PAIRS_H
#define UNIT_OPS_PLANAR_PAIRS_H

#include <string.h>

#include "harness/test.h"
#include "iritx/geom.h"
#include "iritx/mv.h"

enum { PAIR_POINTS = 24 };

typedef struct {
    int n, degree;
    double w[PAIR_POINTS], p[PAIR_POINTS][2];
    bool rational, periodic;
} pair_points;

static inline ix_mv *pair_curve(ix_ctx *ctx, const pair_points *p)
{
    double kv[3 * PAIR_POINTS], pts[3 * PAIR_POINTS];
    int n = p->n, d = p->degree, axes = p->rational ? 1 : 0;
    ix_dir dir = {IX_BSPLINE, d + 1, n, p->periodic, kv};
    ix_mv *m;

    for (int i = 0; i < n + 2 * d + 2; i++)
        kv[i] = p->periodic ? i - d : i <= d ? 0 : i >= n ? n - d : i - d;
    for (int i = 0; i < n; i++) {
        double w = p->rational ? p->w[i] : 1;

        pts[i] = w;
        for (int k = 0; k < 2; k++)
            pts[(axes + k) * n + i] = w * p->p[i][k];
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 2, p->rational, pts, &m));
    return m;
}

static inline void pair_about(ix_rng *r, double x, double y, double size,
                              double out[2])
{
    out[0] = x + size * ix_rng_range(r, -1, 1);
    out[1] = y + size * ix_rng_range(r, -1, 1);
}

/* Anywhere in the square of that size around (x, y). */
static inline pair_points pair_random(ix_rng *r, int degree, int spans,
                                      bool rational, double x, double y,
                                      double size)
{
    pair_points p = {.n = degree + spans, .degree = degree};

    p.rational = rational;
    for (int i = 0; i < p.n; i++) {
        p.w[i] = exp(ix_rng_range(r, -1.2, 1.2));
        pair_about(r, x, y, size, p.p[i]);
    }
    return p;
}

static inline pair_points pair_simple(ix_rng *r)
{
    return pair_random(r, ix_rng_int(r, 1, 4), 1, false, 0, 0, 1);
}

typedef void (*pair_maker)(ix_rng *r, pair_points *a, pair_points *b);

static inline void pair_cubics(ix_rng *r, pair_points *a, pair_points *b)
{
    *a = pair_random(r, 3, 1, false, 0, 0, 1);
    *b = pair_random(r, 3, 1, false, 0, 0, 1);
}

static inline void pair_mixed(ix_rng *r, pair_points *a, pair_points *b)
{
    *a = pair_simple(r);
    *b = pair_simple(r);
}

static inline void pair_beside(ix_rng *r, pair_points *a, pair_points *b)
{
    *a = pair_random(r, ix_rng_int(r, 1, 4), 1, false, 0, 0, 1);
    *b = pair_random(r, ix_rng_int(r, 1, 4), 1, false, 1.2, 0.9, 1);
}

static inline void pair_rational(ix_rng *r, pair_points *a, pair_points *b)
{
    *a = pair_random(r, ix_rng_int(r, 2, 4), 1, true, 0, 0, 1);
    *b = pair_random(r, ix_rng_int(r, 2, 4), 1, true, 0.5, 0.2, 1);
}

static inline void pair_splines(ix_rng *r, pair_points *a, pair_points *b)
{
    *a = pair_random(r, ix_rng_int(r, 2, 4), 4, false, 0, 0, 1);
    *b = pair_random(r, ix_rng_int(r, 2, 4), 3, true, 0.4, 0.4, 1);
}

/* The second one's first point and tangent are those of the first one in its
 * middle, the parameter that control points as here give by subdivision. */
static inline void pair_touching(ix_rng *r, pair_points *a, pair_points *b)
{
    double f = ix_rng_range(r, -1, 1);

    *a = pair_random(r, 2, 1, false, 0, 0, 1);
    *b = pair_random(r, 4, 1, false, 0.3, 0.3, 1);
    for (int k = 0; k < 2; k++) {
        double m = 0.25 * (a->p[0][k] + 2 * a->p[1][k] + a->p[2][k]);
        double d = 0.25 * (a->p[2][k] - a->p[0][k]), c[5];

        /* b(1/2) = m and b'(1/2) along d, by the points 1 and 3 */
        for (int i = 0; i < 5; i++)
            c[i] = b->p[i][k];
        b->p[1][k] = m - 0.25 * f * d * 8 - 0 * c[1];
        b->p[3][k] = m + 0.25 * f * d * 8;
        b->p[4][k] = c[0] + 2 * (m - c[0]) + f * d * 2;
        b->p[2][k] = (16 * m - c[0] - b->p[4][k] -
                      4 * (b->p[1][k] + b->p[3][k])) /
                     6;
    }
}

static inline void pair_end(ix_rng *r, pair_points *a, pair_points *b)
{
    *a = pair_simple(r);
    *b = pair_simple(r);
    memcpy(b->p[0], a->p[a->n - 1], sizeof b->p[0]);
}

static inline void pair_smooth_end(ix_rng *r, pair_points *a, pair_points *b)
{
    double f = ix_rng_range(r, 0.2, 1.5);

    *a = pair_random(r, 3, 1, false, 0, 0, 1);
    *b = pair_random(r, 3, 1, false, 0, 0, 1);
    memcpy(b->p[0], a->p[3], sizeof b->p[0]);
    for (int k = 0; k < 2; k++)
        b->p[1][k] = a->p[3][k] + f * (a->p[3][k] - a->p[2][k]);
}

static inline void pair_both_ends(ix_rng *r, pair_points *a, pair_points *b)
{
    pair_end(r, a, b);
    memcpy(b->p[b->n - 1], a->p[0], sizeof b->p[0]);
}

static inline void pair_end_on_curve(ix_rng *r, pair_points *a, pair_points *b)
{
    *a = pair_random(r, 2, 1, false, 0, 0, 1);
    *b = pair_simple(r);
    for (int k = 0; k < 2; k++)
        b->p[0][k] = 0.25 * (a->p[0][k] + 2 * a->p[1][k] + a->p[2][k]);
}

static inline void pair_parallel(ix_rng *r, pair_points *a, pair_points *b)
{
    double off = pow(10, ix_rng_range(r, -5, -1));
    double noise = off * pow(10, ix_rng_range(r, -3, -0.3)), d[2];

    *a = pair_simple(r);
    *b = *a;
    pair_about(r, 0, 0, off, d);
    for (int i = 0; i < b->n; i++)
        for (int k = 0; k < 2; k++)
            b->p[i][k] += d[k] + noise * ix_rng_range(r, -1, 1);
}

static inline void pair_ring(ix_rng *r, double x, double y, double size,
                             pair_points *a)
{
    *a = (pair_points){
        .n = ix_rng_int(r, 4, 10), .degree = 3, .periodic = true};
    for (int i = 0; i < a->n; i++) {
        double t = 2 * 3.14159265358979323846 * i / a->n;
        double s = size * ix_rng_range(r, 0.5, 1.2);

        a->p[i][0] = x + s * cos(t);
        a->p[i][1] = y + s * sin(t);
    }
}

static inline void pair_closed(ix_rng *r, pair_points *a, pair_points *b)
{
    pair_ring(r, 0, 0, 1, a);
    if (ix_rng_int(r, 0, 1))
        *b = pair_random(r, 3, 2, false, 0.4, 0.2, 1);
    else
        pair_ring(r, ix_rng_range(r, 0, 2), 0.1, 0.7, b);
}

static inline void pair_nested(ix_rng *r, pair_points *a, pair_points *b)
{
    pair_ring(r, 0, 0, 2, a);
    pair_ring(r, 0.05, 0.1, ix_rng_range(r, 0.1, 0.8), b);
    if (ix_rng_int(r, 0, 1)) {
        pair_points c = *a;

        *a = *b;
        *b = c;
    }
}

/* A cusp at 1/2: the first difference there is 0. */
static inline void pair_cusped(ix_rng *r, pair_points *a, pair_points *b)
{
    *a = pair_random(r, 3, 1, false, 0, 0, 1);
    *b = pair_simple(r);
    for (int k = 0; k < 2; k++)
        a->p[3][k] = a->p[0][k] + a->p[1][k] - a->p[2][k];
}

static inline void pair_straight(ix_rng *r, pair_points *a, pair_points *b)
{
    *a = pair_random(r, 1, ix_rng_int(r, 2, 5), false, 0, 0, 1);
    *b = pair_random(r, 3, 4, false, 0.2, 0, 1);
    for (int i = 1; i <= 4; i++) /* four points on a line, evenly */
        for (int k = 0; k < 2; k++)
            b->p[i + 1][k] = b->p[1][k] +
                             i * (k ? 0.31 : 0.17) * (b->p[0][0] > 0 ? 1 : -1);
}

static inline void pair_sizes(ix_rng *r, pair_points *a, pair_points *b)
{
    double s = pow(10, ix_rng_range(r, -4, -0.5));

    *a = pair_simple(r);
    *b = pair_random(r, ix_rng_int(r, 1, 4), 1, false,
                     ix_rng_range(r, -0.5, 0.5), ix_rng_range(r, -0.5, 0.5), s);
}

static inline void pair_far(ix_rng *r, pair_points *a, pair_points *b)
{
    pair_mixed(r, a, b);
    for (int i = 0; i < a->n; i++) {
        a->p[i][0] += 4096;
        a->p[i][1] -= 1000;
    }
    for (int i = 0; i < b->n; i++) {
        b->p[i][0] += 4096;
        b->p[i][1] -= 1000;
    }
}

static inline void pair_scaled(ix_rng *r, pair_points *a, pair_points *b)
{
    double s = pow(10, ix_rng_range(r, -6, 6));

    pair_mixed(r, a, b);
    for (int i = 0; i < a->n; i++)
        for (int k = 0; k < 2; k++)
            a->p[i][k] *= s;
    for (int i = 0; i < b->n; i++)
        for (int k = 0; k < 2; k++)
            b->p[i][k] *= s;
}

/* Loops: the ends beyond each other. */
static inline void pair_loops(ix_rng *r, pair_points *a, pair_points *b)
{
    pair_points *c[2] = {a, b};

    for (int i = 0; i < 2; i++) {
        *c[i] = pair_random(r, 3, 1, false, 0.3 * i, 0.2 * i, 0.2);
        c[i]->p[0][0] -= 0.5;
        c[i]->p[3][0] += 0.5;
        c[i]->p[1][0] += 1.2;
        c[i]->p[2][0] -= 1.2;
        c[i]->p[1][1] += 1;
        c[i]->p[2][1] += 1;
    }
}

/* Is p[0] .. p[n-1] on one line, back and forth? Whole numbers: exact. */
static inline bool turns_back(int n, double p[][2])
{
    bool back = false;

    for (int i = 2; i < n; i++) {
        double a[2] = {p[i - 1][0] - p[i - 2][0], p[i - 1][1] - p[i - 2][1]};
        double b[2] = {p[i][0] - p[i - 1][0], p[i][1] - p[i - 1][1]};

        if (a[0] * b[1] != a[1] * b[0])
            return false;
        back = back || a[0] * b[0] + a[1] * b[1] < 0;
    }
    return back;
}

/* Such a span would cover itself, and the bisector in part, too: its pieces
 * then end anywhere. */
static inline bool covers_itself(pair_points *c)
{
    int n = c->degree > 1 ? c->degree + 1 : 3;

    for (int i = 0; i + n <= c->n; i++)
        if (turns_back(n, c->p + i))
            return true;
    return false;
}

/* Whole numbers: equal, collinear, touching by chance. */
static inline void pair_grid(ix_rng *r, pair_points *a, pair_points *b)
{
    pair_points *c[2] = {a, b};

    for (int i = 0; i < 2; i++)
        do {
            int d = ix_rng_int(r, 1, 3);

            *c[i] = pair_random(r, d, ix_rng_int(r, 1, 2), false, 0, 0, 1);
            for (int j = 0; j < c[i]->n; j++)
                for (int k = 0; k < 2; k++)
                    c[i]->p[j][k] = ix_rng_int(r, -2, 2);
            /* no points */
            c[i]->p[c[i]->n - 1][0] = c[i]->p[0][0] + 1;
        } while (covers_itself(c[i]));
}

/* The second one a mirror image of the first one, or of itself. */
static inline void pair_mirror(ix_rng *r, pair_points *a, pair_points *b)
{
    pair_points *c[2] = {a, b};

    if (ix_rng_int(r, 0, 1)) {
        *a = pair_simple(r);
        *b = *a;
        for (int i = 0; i < a->n; i++)
            b->p[i][0] = -a->p[i][0];
        return;
    }
    for (int i = 0; i < 2; i++) {
        *c[i] = pair_random(r, ix_rng_int(r, 1, 4), 1, false, 0, 0, 1);
        for (int j = 0; j < c[i]->n; j++) {
            int m = c[i]->n - 1 - j;

            c[i]->p[m][0] = j == m ? 0 : -c[i]->p[j][0];
            c[i]->p[m][1] = c[i]->p[j][1];
        }
    }
}

/* Higher degrees with points that coincide. */
static inline void pair_repeated(ix_rng *r, pair_points *a, pair_points *b)
{
    pair_points *c[2] = {a, b};

    for (int i = 0; i < 2; i++) {
        *c[i] = pair_random(r, 5, 1, i, 0.2 * i, 0, 1);
        memcpy(c[i]->p[1], c[i]->p[0], sizeof c[i]->p[0]);
        if (ix_rng_int(r, 0, 1))
            memcpy(c[i]->p[4], c[i]->p[3], sizeof c[i]->p[3]);
    }
}

static inline void pair_waves(ix_rng *r, pair_points *a, pair_points *b)
{
    *a = pair_random(r, 3, 12, false, 0, 0, 1);
    *b = pair_random(r, 3, 12, false, 0, 0, 1);
    for (int i = 0; i < a->n; i++) {
        a->p[i][0] = b->p[i][0] = 0.2 * i - 1.5;
        a->p[i][1] *= 0.4;
        b->p[i][1] *= 0.4;
        b->p[i][1] += 0.3;
    }
}

static const struct {
    const char *name;
    pair_maker make;
    bool regions; /* there may be points in common that are no crossings */
} pair_kinds[] = {{"cubics", pair_cubics, false},
                  {"mixed", pair_mixed, false},
                  {"beside", pair_beside, false},
                  {"rational", pair_rational, false},
                  {"splines", pair_splines, false},
                  {"touching", pair_touching, true},
                  {"end", pair_end, true},
                  {"smooth end", pair_smooth_end, true},
                  {"both ends", pair_both_ends, true},
                  {"end on curve", pair_end_on_curve, true},
                  {"parallel", pair_parallel, true},
                  {"closed", pair_closed, false},
                  {"nested", pair_nested, false},
                  {"cusped", pair_cusped, false},
                  {"straight", pair_straight, false},
                  {"sizes", pair_sizes, false},
                  {"far", pair_far, false},
                  {"scaled", pair_scaled, false},
                  {"loops", pair_loops, false},
                  {"grid", pair_grid, true},
                  {"mirror", pair_mirror, true},
                  {"repeated", pair_repeated, false},
                  {"waves", pair_waves, false}};
enum { PAIR_KINDS = sizeof pair_kinds / sizeof *pair_kinds };

/* The pair i of a kind; two new references. */
static inline void pair_make(ix_ctx *ctx, uint64_t seed, int kind, int i,
                             ix_mv *out[2])
{
    ix_rng r = {seed + (uint64_t)kind * 1000003u + (uint64_t)i * 7919u};
    pair_points a, b;

    for (int k = 0; k < 3; k++)
        (void)ix_rng_next(&r);
    r.s = ix_rng_next(&r);
    pair_kinds[kind].make(&r, &a, &b);
    out[0] = pair_curve(ctx, &a);
    out[1] = pair_curve(ctx, &b);
}

#endif
