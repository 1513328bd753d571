/* plane_test.h - distances by brute force, and what a bisector has to satisfy
 * by its definition. */
#ifndef UNIT_OPS_PLANE_TEST_H
#define UNIT_OPS_PLANE_TEST_H

#include <stdlib.h>
#include <string.h>

#include "crv_test.h"
#include "iritx/ops_plane.h"

enum { BRUTE = 1500 };

/* Curves sampled densely; a point is a curve without samples. */
typedef struct {
    int n;
    const ix_mv *crv[8];
    double (*x)[BRUTE + 1][2]; /* [n] */
    double point[2];
} brute;

static inline void brute_point_at(ix_ctx *ctx, const ix_mv *c, double u,
                                  double x[2])
{
    double dom[2], t, p[3];

    ix_mv_domain(c, 0, dom);
    t = dom[0] + u * (dom[1] - dom[0]);
    ASSERT_OK(ctx, ix_mv_point(ctx, c, &t, p));
    x[0] = p[0];
    x[1] = p[1];
}

static inline brute brute_of(ix_ctx *ctx, int n, const ix_mv *const *c)
{
    brute b = {.n = n};

    b.x = malloc((size_t)n * sizeof *b.x);
    for (int i = 0; i < n; i++) {
        b.crv[i] = c[i];
        for (int j = 0; j <= BRUTE; j++)
            brute_point_at(ctx, c[i], (double)j / BRUTE, b.x[i][j]);
    }
    return b;
}

static inline double brute_golden(ix_ctx *ctx, const ix_mv *c, double lo,
                                  double hi, const double q[2])
{
    const double g = 0.6180339887498949;
    double best = INFINITY;

    for (int i = 0; i < 60 && hi - lo > 1e-13; i++) {
        double a = hi - g * (hi - lo), b = lo + g * (hi - lo), x[2], fa, fb;

        brute_point_at(ctx, c, a, x);
        fa = hypot(x[0] - q[0], x[1] - q[1]);
        brute_point_at(ctx, c, b, x);
        fb = hypot(x[0] - q[0], x[1] - q[1]);
        best = fmin(best, fmin(fa, fb));
        if (fa < fb)
            hi = b;
        else
            lo = a;
    }
    return best;
}

/* Distance: the samples, and around each that is lower than its neighbours and
 * not far above the lowest, golden section. */
static inline double brute_distance(ix_ctx *ctx, const brute *b,
                                    const double q[2], bool fine)
{
    double best = INFINITY, margin;

    if (b->n == 0)
        return hypot(q[0] - b->point[0], q[1] - b->point[1]);
    for (int i = 0; i < b->n; i++)
        for (int j = 0; j <= BRUTE; j++)
            best = fmin(best,
                        hypot(b->x[i][j][0] - q[0], b->x[i][j][1] - q[1]));
    margin = best;
    for (int i = 0; fine && i < b->n; i++)
        for (int j = 0; j <= BRUTE; j++) {
            double(*x)[2] = b->x[i];
            double d[3];

            for (int k = -1; k <= 1; k++) {
                int m = j + k < 0 ? 0 : j + k > BRUTE ? BRUTE : j + k;

                d[k + 1] = hypot(x[m][0] - q[0], x[m][1] - q[1]);
            }
            if (d[1] <= d[0] && d[1] <= d[2] &&
                d[1] - fabs(d[0] - d[1]) - fabs(d[2] - d[1]) <= margin)
                for (int m = -4; m < 4; m++)
                    best = fmin(
                        best, brute_golden(
                                  ctx, b->crv[i], fmax(j + 0.25 * m, 0) / BRUTE,
                                  fmin(j + 0.25 * (m + 1), BRUTE) / BRUTE, q));
        }
    return best;
}

/* Soundness: each vertex is as far from one whole object as from the other,
 * within tol of its distance or the size. Ends of unbounded pieces far out are
 * measured relative to the distance too. */
static inline double worst_vertex(ix_ctx *ctx, const ix_bisector *s,
                                  const brute *a, const brute *b, int step)
{
    double worst = 0;

    for (int i = 0; i < s->n; i++)
        for (int j = 0; j < s->piece[i].n; j++) {
            const double *q = s->piece[i].x + 2 * j;
            double r = s->piece[i].r[j], d1, d2, e;

            if (j % step && j + 1 < s->piece[i].n)
                continue;
            d1 = brute_distance(ctx, a, q, true);
            d2 = brute_distance(ctx, b, q, true);
            e = fmax(fabs(d1 - r), fabs(d2 - r)) / fmax(s->size, r);
            if (!(e <= worst))
                worst = e;
        }
    return worst;
}

/* Distance of q from the polylines. */
static inline double off_result(const ix_bisector *s, const double q[2])
{
    double best = INFINITY;

    for (int i = 0; i < s->n; i++)
        for (int j = 0; j < s->piece[i].n; j++) {
            const double *p = s->piece[i].x + 2 * j;
            double d[2] = {0, 0}, e[2] = {q[0] - p[0], q[1] - p[1]}, l, t = 0;

            if (j + 1 < s->piece[i].n) {
                d[0] = p[2] - p[0];
                d[1] = p[3] - p[1];
            }
            l = d[0] * d[0] + d[1] * d[1];
            if (l > 0)
                t = fmin(fmax((d[0] * e[0] + d[1] * e[1]) / l, 0), 1);
            best = fmin(best, hypot(e[0] - t * d[0], e[1] - t * d[1]));
        }
    return best;
}

/* Completeness: where the difference of the distances changes its sign along
 * random segments across the objects, the result is near. */
static inline double worst_missing(ix_ctx *ctx, ix_rng *r, const ix_bisector *s,
                                   const brute *a, const brute *b, int lines,
                                   double reach)
{
    enum { STEPS = 60 };
    double worst = 0;

    for (int i = 0; i < lines; i++) {
        double p[2][2], last = 0;

        for (int k = 0; k < 4; k++)
            p[k / 2][k % 2] = ix_rng_range(r, -reach, reach);
        for (int j = 0; j <= STEPS; j++) {
            double lo = (j - 1.0) / STEPS, hi = (double)j / STEPS, f, q[2];

            for (int k = 0; k < 2; k++)
                q[k] = p[0][k] + hi * (p[1][k] - p[0][k]);
            f = brute_distance(ctx, a, q, false) -
                brute_distance(ctx, b, q, false);
            if (j && f * last < 0) {
                for (int k = 0; k < 25; k++) {
                    double m = 0.5 * (lo + hi), g;

                    for (int c = 0; c < 2; c++)
                        q[c] = p[0][c] + m * (p[1][c] - p[0][c]);
                    g = brute_distance(ctx, a, q, true) -
                        brute_distance(ctx, b, q, true);
                    if (g * last < 0)
                        hi = m;
                    else
                        lo = m;
                }
                worst = fmax(worst, off_result(s, q));
            }
            last = f;
        }
    }
    return worst;
}

#endif
