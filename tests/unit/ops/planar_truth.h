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

typedef struct {
    double u, x[2], d;
} truth_place;

static inline truth_place truth_place_at(const truth_arc *a, const double q[2],
                                         double u)
{
    truth_place p = {.u = u};

    truth_at(a, u, p.x);
    p.d = truth_dist(p.x, q);
    return p;
}

/* Can a nearer point than d lie between two places? Lengths are chords and a
 * fifth more. */
static inline bool truth_may_hold(const truth_place *a, const truth_place *b,
                                  double d)
{
    return 0.5 * (a->d + b->d - 1.2 * truth_dist(a->x, b->x)) <= d;
}

/* Golden section between the places p[0] and p[3], as long as it may hold a
 * nearer point. */
static inline void truth_golden(const truth_arc *a, const double q[2],
                                truth_place p[4], truth_foot *f, int index)
{
    const double g = 0.6180339887498949;

    p[1] = truth_place_at(a, q, p[3].u - g * (p[3].u - p[0].u));
    p[2] = truth_place_at(a, q, p[0].u + g * (p[3].u - p[0].u));
    /* a step e beside the foot is e^2 / (2 d) farther: to 1e-13 of d, and where
       the curve passes through q to the last digits */
    for (int i = 0; i < 34 || (i < 60 && truth_dist(p[1].x, p[2].x) >
                                             4e-7 * fmin(p[1].d, p[2].d));
         i++) {
        if (!truth_may_hold(&p[0], &p[1], f->d) &&
            !truth_may_hold(&p[1], &p[2], f->d) &&
            !truth_may_hold(&p[2], &p[3], f->d))
            return;
        if (p[1].d < p[2].d) {
            p[3] = p[2];
            p[2] = p[1];
            p[1] = truth_place_at(a, q, p[3].u - g * (p[3].u - p[0].u));
        } else {
            p[0] = p[1];
            p[1] = p[2];
            p[2] = truth_place_at(a, q, p[0].u + g * (p[3].u - p[0].u));
        }
    }
    for (int k = 1; k < 3; k++)
        if (p[k].d < f->d)
            *f = (truth_foot){p[k].d, {p[k].x[0], p[k].x[1]}, index, p[k].u};
}

/* Intervals that may hold less, in quarters. */
static inline void truth_interval(const truth_arc *a, const double q[2], int i,
                                  truth_foot *f, int index)
{
    truth_place p[5];

    for (int j = 0; j <= 4; j++) {
        p[j] = truth_place_at(a, q, (i + 0.25 * j) / ARC_SAMPLES);
        if (p[j].d < f->d)
            *f = (truth_foot){p[j].d, {p[j].x[0], p[j].x[1]}, index, p[j].u};
    }
    for (int j = 0; j < 4; j++)
        if (truth_may_hold(&p[j], &p[j + 1], f->d)) {
            truth_place at[4] = {[0] = p[j], [3] = p[j + 1]};

            truth_golden(a, q, at, f, index);
        }
}

static inline double truth_box_gap(const truth_arc *a, const double q[2])
{
    double gap[2];

    for (int k = 0; k < 2; k++) {
        gap[k] = a->box[0][k] - q[k];
        if (gap[k] < q[k] - a->box[1][k])
            gap[k] = q[k] - a->box[1][k];
        if (gap[k] < 0)
            gap[k] = 0;
    }
    return sqrt(gap[0] * gap[0] + gap[1] * gap[1]);
}

/* Of the samples of an arc: all distances in d, the nearest in *f if it is
 * nearer than that, and what no point of it can be below. */
static inline double truth_samples(const truth_arc *a, int index,
                                   const double q[2], double *d, truth_foot *f)
{
    double least = INFINITY;
    int best = -1;

    for (int j = 0; j <= ARC_SAMPLES; j++) {
        d[j] = truth_dist(a->x[j], q);
        if (d[j] < f->d) {
            f->d = d[j];
            best = j;
        }
    }
    for (int j = 0; j < ARC_SAMPLES; j++) {
        double low = 0.5 * (d[j] + d[j + 1] - a->len[j]);

        least = low < least ? low : least;
    }
    if (best >= 0)
        *f = (truth_foot){d[best],
                          {a->x[best][0], a->x[best][1]},
                          index,
                          (double)best / ARC_SAMPLES};
    return least;
}

/* The nearest point of the whole set; rough: of the samples only, and in *low
 * what the distance cannot be below. */
static inline truth_foot truth_nearest(const truth_set *s, const double q[2],
                                       bool rough, double *low)
{
    truth_foot f = {.d = INFINITY};
    double least = INFINITY, d[ARC_SAMPLES + 1];

    for (int i = 0; i < s->narcs; i++)
        if (truth_box_gap(&s->arc[i], q) <= f.d)
            least = fmin(least, truth_samples(&s->arc[i], i, q, d, &f));
    for (int i = 0; i < s->narcs && !rough; i++) {
        const truth_arc *a = &s->arc[i];
        truth_foot none = {.d = 0};

        if (truth_box_gap(a, q) > f.d || truth_samples(a, i, q, d, &none) > f.d)
            continue;
        for (int j = 0; j < ARC_SAMPLES; j++)
            if (0.5 * (d[j] + d[j + 1] - a->len[j]) <= f.d)
                truth_interval(a, q, j, &f, i);
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
