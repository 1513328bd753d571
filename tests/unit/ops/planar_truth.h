/* planar_truth.h - distances in the plane by dense sampling: what bisectors and
 * medial axes are held against. Shares no code with the operators: curves are
 * cut into Bezier arcs, sampled, and each interval of samples whose length lets
 * it hold a nearer point than those known is searched by golden section. */
#ifndef UNIT_OPS_PLANAR_TRUTH_H
#define UNIT_OPS_PLANAR_TRUTH_H

#include <stdlib.h>
#include <string.h>

#include "harness/test.h"
#include "iritx/ops_plane.h"

enum { ARC_SAMPLES = 48, ARC_DEGREE = 9 };

typedef struct {
    int degree, curve;
    double c[3][ARC_DEGREE + 1]; /* Bernstein: w, wx, wy */
    double t[2];
    double x[ARC_SAMPLES + 1][2];
    double len[ARC_SAMPLES]; /* upper bounds, of quarters in all */
    double quarter[4 * ARC_SAMPLES];
    double box[2][2]; /* of the samples, widened by half a length */
} truth_arc;

/* Some curves. */
typedef struct {
    int narcs;
    truth_arc *arc;
} truth_set;

typedef struct {
    double d, x[2];
    int arc;
    double u;
} truth_foot;

static inline void truth_at(const truth_arc *a, double u, double x[2])
{
    double b[3], p[ARC_DEGREE + 1];

    for (int k = 0; k < 3; k++) {
        memcpy(p, a->c[k], sizeof p);
        for (int n = a->degree; n > 0; n--)
            for (int i = 0; i < n; i++)
                p[i] += u * (p[i + 1] - p[i]);
        b[k] = p[0];
    }
    x[0] = b[1] / b[0];
    x[1] = b[2] / b[0];
}

static inline double truth_dist(const double *a, const double *b)
{
    double x = a[0] - b[0], y = a[1] - b[1];

    return sqrt(x * x + y * y);
}

/* Cuts the part of the curve before s off c, and gives the length of its
 * control polygon: that of a curve with positive weights is not more. */
static inline double truth_cut(int n, double c[3][ARC_DEGREE + 1], double s)
{
    double left[3][ARC_DEGREE + 1], len = 0;

    for (int k = 0; k < 3; k++)
        for (int j = 0; j <= n; j++) {
            left[k][j] = c[k][0];
            for (int i = 0; i < n - j; i++)
                c[k][i] += s * (c[k][i + 1] - c[k][i]);
        }
    for (int j = 0; j < n; j++)
        len += hypot(left[1][j + 1] / left[0][j + 1] - left[1][j] / left[0][j],
                     left[2][j + 1] / left[0][j + 1] - left[2][j] / left[0][j]);
    return len * (1 + 1e-9);
}

static inline void truth_sample(truth_arc *a)
{
    double c[3][ARC_DEGREE + 1];

    memcpy(c, a->c, sizeof c);
    truth_at(a, 0, a->x[0]);
    for (int k = 0; k < 2; k++) {
        a->box[0][k] = INFINITY;
        a->box[1][k] = -INFINITY;
    }
    for (int i = 0; i < ARC_SAMPLES; i++) {
        a->len[i] = 0;
        for (int j = 4 * i; j < 4 * i + 4; j++) {
            a->quarter[j] = truth_cut(a->degree, c,
                                      1.0 / (4 * ARC_SAMPLES - j));
            a->len[i] += a->quarter[j];
        }
        truth_at(a, (i + 1.0) / ARC_SAMPLES, a->x[i + 1]);
        for (int k = 0; k < 2; k++) {
            double p = a->x[i][k], q = a->x[i + 1][k];

            a->box[0][k] = fmin(a->box[0][k], fmin(p, q) - 0.5 * a->len[i]);
            a->box[1][k] = fmax(a->box[1][k], fmax(p, q) + 0.5 * a->len[i]);
        }
    }
}

static inline truth_set truth_of(ix_ctx *ctx, int n, const ix_mv *const *crv)
{
    truth_set s = {0, NULL};

    for (int i = 0; i < n; i++) {
        ix_mv_pieces p;

        ASSERT_OK(ctx, ix_mv_to_bezier(ctx, crv[i], &p));
        s.arc = realloc(s.arc, ((size_t)s.narcs + p.count) * sizeof *s.arc);
        for (size_t j = 0; j < p.count; j++) {
            truth_arc *a = &s.arc[s.narcs++];
            const double *w = ix_mv_weights(p.piece[j]);

            a->degree = ix_mv_order(p.piece[j], 0) - 1;
            a->curve = i;
            a->t[0] = p.lo[j];
            a->t[1] = p.hi[j];
            for (int k = 0; k <= a->degree; k++) {
                a->c[0][k] = w ? w[k] : 1;
                for (int c = 0; c < 2; c++)
                    a->c[c + 1][k] = ix_mv_coord(p.piece[j], c)[k];
            }
            truth_sample(a);
        }
        ix_mv_pieces_free(ctx, &p);
    }
    return s;
}

/* Golden section over [lo, hi]. */
static inline void truth_golden(const truth_arc *a, const double q[2],
                                double lo, double hi, truth_foot *f, int index)
{
    const double g = 0.6180339887498949;
    double u[2] = {hi - g * (hi - lo), lo + g * (hi - lo)}, x[2][2], d[2];

    for (int k = 0; k < 2; k++) {
        truth_at(a, u[k], x[k]);
        d[k] = truth_dist(x[k], q);
    }
    /* where the curve passes through q the distance is no parabola, but an
       angle: as many more steps as its square has digits */
    for (int i = 0; i < 34 || (i < 60 && fmin(d[0], d[1]) < 1e-6); i++) {
        int k = d[0] < d[1] ? 1 : 0; /* the one that is replaced */

        if (k) {
            hi = u[1];
            u[1] = u[0];
            u[0] = hi - g * (hi - lo);
            d[1] = d[0];
            memcpy(x[1], x[0], sizeof x[0]);
        } else {
            lo = u[0];
            u[0] = u[1];
            u[1] = lo + g * (hi - lo);
            d[0] = d[1];
            memcpy(x[0], x[1], sizeof x[0]);
        }
        truth_at(a, u[1 - k], x[1 - k]);
        d[1 - k] = truth_dist(x[1 - k], q);
    }
    for (int k = 0; k < 2; k++)
        if (d[k] < f->d)
            *f = (truth_foot){d[k], {x[k][0], x[k][1]}, index, u[k]};
}

/* Intervals that may hold less, in quarters. */
static inline void truth_interval(const truth_arc *a, const double q[2], int i,
                                  truth_foot *f, int index)
{
    double x[5][2], d[5];

    for (int j = 0; j <= 4; j++) {
        truth_at(a, (i + 0.25 * j) / ARC_SAMPLES, x[j]);
        d[j] = truth_dist(x[j], q);
        if (d[j] < f->d)
            *f = (truth_foot){
                d[j], {x[j][0], x[j][1]}, index, (i + 0.25 * j) / ARC_SAMPLES};
    }
    for (int j = 0; j < 4; j++)
        if (0.5 * (d[j] + d[j + 1] - a->quarter[4 * i + j]) <= f->d)
            truth_golden(a, q, (i + 0.25 * j) / ARC_SAMPLES,
                         (i + 0.25 * (j + 1)) / ARC_SAMPLES, f, index);
}

/* The nearest point of the whole set; rough: of the samples only, and in *low
 * what the distance cannot be below. */
static inline truth_foot truth_nearest(const truth_set *s, const double q[2],
                                       bool rough, double *low)
{
    truth_foot f = {.d = INFINITY};
    double least = INFINITY;

    for (int pass = 0; pass < (rough ? 1 : 2); pass++)
        for (int i = 0; i < s->narcs; i++) {
            const truth_arc *a = &s->arc[i];
            double gap[2], d, last;

            for (int k = 0; k < 2; k++)
                gap[k] = fmax(fmax(a->box[0][k] - q[k], q[k] - a->box[1][k]),
                              0);
            if (hypot(gap[0], gap[1]) > f.d)
                continue;
            last = truth_dist(a->x[0], q);
            if (pass == 0 && last < f.d)
                f = (truth_foot){last, {a->x[0][0], a->x[0][1]}, i, 0};
            for (int j = 0; j < ARC_SAMPLES; j++) {
                d = truth_dist(a->x[j + 1], q);
                least = fmin(least, 0.5 * (d + last - a->len[j]));
                if (pass == 0 && d < f.d)
                    f = (truth_foot){d,
                                     {a->x[j + 1][0], a->x[j + 1][1]},
                                     i,
                                     (j + 1.0) / ARC_SAMPLES};
                if (pass == 1 && 0.5 * (d + last - a->len[j]) <= f.d)
                    truth_interval(a, q, j, &f, i);
                last = d;
            }
        }
    if (low)
        *low = fmin(least, f.d);
    return f;
}

static inline double truth_distance(const truth_set *s, const double q[2])
{
    return truth_nearest(s, q, false, NULL).d;
}

/* d(x, first) - d(x, second), at least its sign. */
static inline double truth_difference(const truth_set s[2], const double x[2])
{
    truth_foot f[2];
    double low[2];

    for (int k = 0; k < 2; k++)
        f[k] = truth_nearest(&s[k], x, true, &low[k]);
    if (low[0] > f[1].d)
        return 1;
    if (low[1] > f[0].d)
        return -1;
    return truth_distance(&s[0], x) - truth_distance(&s[1], x);
}

/* Its parameter on the user's curve. */
static inline double truth_parameter(const truth_set *s, const truth_foot *f)
{
    const truth_arc *a = &s->arc[f->arc];

    return a->t[0] + f->u * (a->t[1] - a->t[0]);
}

/* max over the set of x . n */
static inline double truth_support(const truth_set *s, const double n[2])
{
    const double far = 1e3; /* times the size, which is about 1 */
    double best = -INFINITY;

    (void)far;
    for (int i = 0; i < s->narcs; i++) {
        const truth_arc *a = &s->arc[i];
        int at = 0;
        double v[ARC_SAMPLES + 1], lo, hi;

        for (int j = 0; j <= ARC_SAMPLES; j++) {
            v[j] = a->x[j][0] * n[0] + a->x[j][1] * n[1];
            at = v[j] > v[at] ? j : at;
        }
        lo = (at > 0 ? at - 1.0 : 0.0) / ARC_SAMPLES;
        hi = (at < ARC_SAMPLES ? at + 1.0 : at) / ARC_SAMPLES;
        best = fmax(best, v[at]);
        for (int j = 0; j < 50; j++) {
            double x[2], y[2], m[2] = {lo + (hi - lo) / 3, hi - (hi - lo) / 3};
            double p, r;

            truth_at(a, m[0], x);
            truth_at(a, m[1], y);
            p = x[0] * n[0] + x[1] * n[1];
            r = y[0] * n[0] + y[1] * n[1];
            best = fmax(best, fmax(p, r));
            if (p < r)
                lo = m[0];
            else
                hi = m[1];
        }
    }
    return best;
}

#endif
