/* planar_check.h - what the true bisector of two sets of planar curves has to
 * satisfy: vertices against dense sampling of both sets, sign changes of the
 * difference of both distances on grids, ends, infinity. */
#ifndef UNIT_OPS_PLANAR_CHECK_H
#define UNIT_OPS_PLANAR_CHECK_H

#include <float.h>

#include "planar_truth.h"

/* Vertices: what golden sections leave of distances, with a margin; the size is
 * that of both curves. */
#define SOUND 1e-11
/* Two ways to compute an end of an exact piece differ along the bisector: by
 * what rounding leaves of tangents where the curve is short or bends sharply.
 */
#define SAME_END 1e-9
/* The polyline is within tol of the size, or of the distance farther out: with
 * both feet on opposite sides distances differ by twice that. */
#define OFF 2.05
/* What golden sections leave of distances from smooth curves. */
#define TRUTH 1e-13
/* Feet this near each other are one point of both curves. */
#define ONE_FOOT 1e-6
/* Ends that meet: near a circle of curvature a centre is known to about the
 * cube root of 1e-14. */
#define MEETING 2e-5

typedef struct {
    ix_ctx *ctx;
    truth_set set[2];
    const ix_bisector *s;
    double size, mid[2];
    const char *kind;
    int pair;
    bool close; /* look closely */
    double tol; /* 0: 1e-4 */
} problem;

#define WRONG(p, ...)                                  \
    do {                                               \
        printf("%s, pair %d: ", (p)->kind, (p)->pair); \
        printf(__VA_ARGS__);                           \
        printf("\n");                                  \
        fail_msg("%s, pair %d", (p)->kind, (p)->pair); \
    } while (0)

/* --- soundness -------------------------------------------------------------
 */

static inline void check_vertex(const problem *p, const double *x, double r)
{
    for (int k = 0; k < 2; k++) {
        double d = truth_distance(&p->set[k], x);

        if (!(fabs(d - r) <= SOUND * fmax(p->size, r)))
            WRONG(p, "(%.12g, %.12g), radius %.12g: distance %.12g from %d",
                  x[0], x[1], r, d, k + 1);
    }
}

/* Anywhere between two vertices. */
static inline void check_chord(const problem *p, const double *x, double s)
{
    double m[2] = {x[0] + s * (x[2] - x[0]), x[1] + s * (x[3] - x[1])};
    double a = truth_distance(&p->set[0], m), b = truth_distance(&p->set[1], m);

    if (!(fabs(a - b) <=
          (OFF * (p->tol > 0 ? p->tol : 1e-4) + TRUTH) * fmax(p->size, a)))
        WRONG(p, "the chord (%.12g, %.12g) (%.12g, %.12g): distances %g, %g",
              x[0], x[1], x[2], x[3], a, b);
}

/* What coordinates round, a few ulp: the middle's, farther out those there. */
static inline double coordinate_ulps(const problem *p, const double *x)
{
    return 16 * DBL_EPSILON *
           (hypot(p->mid[0], p->mid[1]) + truth_dist(x, p->mid));
}

/* The exact piece begins and ends where its polyline does; far out the rounding
 * of a tangent moves both along the bisector, with the square of the distance.
 */
static inline void check_exact_end(const problem *p, const ix_bisector_piece *g,
                                   int e, const double *x)
{
    const double *v = g->x + (e ? 2 * (g->n - 1) : 0);
    double r = g->r[e ? g->n - 1 : 0];

    if (!(truth_dist(x, v) <=
          SAME_END * fmax(p->size, r * r / p->size) + coordinate_ulps(p, x)))
        WRONG(p, "the exact piece's end %d is %g off its vertex", e,
              truth_dist(x, v));
}

static inline void check_exact(const problem *p, const ix_bisector_piece *g)
{
    double dom[2];

    if (!g->exact)
        return;
    ix_mv_domain(g->exact, 0, dom);
    for (int i = 0; i <= 8; i++) {
        double t = i == 8 ? dom[1] : dom[0] + (dom[1] - dom[0]) * i / 8.0;
        double x[2], a, b;

        if (i % 8 == 0 && g->unbounded[i == 8])
            continue;
        ASSERT_OK(p->ctx, ix_mv_point(p->ctx, g->exact, &t, x));
        a = truth_distance(&p->set[0], x);
        b = truth_distance(&p->set[1], x);
        if (!(fabs(a - b) <= SOUND * fmax(p->size, a) + coordinate_ulps(p, x)))
            WRONG(p, "the exact piece at %g: distances %.12g, %.12g", t, a, b);
        if (i % 8 == 0)
            check_exact_end(p, g, i == 8, x);
    }
}

static inline void check_sound(const problem *p)
{
    int step = p->close ? 7 : 61;

    for (int i = 0; i < p->s->n; i++) {
        const ix_bisector_piece *g = &p->s->piece[i];

        for (int j = 0; j < g->n; j++) {
            if (j % step && j + 1 < g->n)
                continue;
            check_vertex(p, g->x + 2 * j, g->r[j]);
            if (j + 1 < g->n)
                check_chord(p, g->x + 2 * j, fmod(0.5 + 0.618 * j, 1));
        }
        check_exact(p, g);
    }
}

/* Law: between two vertices ix_bisector_touch gives points as exact as the
 * vertices: 1e-11 is what the truth leaves with cusps. */
static inline void check_exact_points(const problem *p,
                                      const ix_mv *const *const c[2], ix_rng *r)
{
    for (int i = 0; i < p->s->n; i++) {
        const ix_bisector_piece *g = &p->s->piece[i];

        for (int j = 0; g->kind == IX_CURVE_CURVE && j < (p->close ? 8 : 1);
             j++) {
            int k = ix_rng_int(r, 0, g->n - 2);
            double u = ix_rng_unit(r), foot[2], b[2], rad;

            for (int e = 0; e < 2; e++)
                foot[e] = (1 - u) * g->foot[2 * k + e] +
                          u * g->foot[2 * k + 2 + e];
            ASSERT_OK(p->ctx, ix_bisector_touch(p->ctx, c[0][g->curve[0]],
                                                c[1][g->curve[1]], g->side,
                                                foot, b, &rad));
            for (int e = 0; e < 2; e++)
                if (!(fabs(truth_distance(&p->set[e], b) - rad) <=
                      1e-11 * fmax(p->size, rad) + coordinate_ulps(p, b)))
                    WRONG(p, "the exact point (%.12g, %.12g): %.12g, %.12g",
                          b[0], b[1], rad, truth_distance(&p->set[e], b));
        }
    }
}

/* --- completeness ----------------------------------------------------------
 */

static inline double off_segment(const double *a, const double *b,
                                 const double *q)
{
    double d[2] = {b[0] - a[0], b[1] - a[1]};
    double e[2] = {q[0] - a[0], q[1] - a[1]};
    double l = d[0] * d[0] + d[1] * d[1], t = d[0] * e[0] + d[1] * e[1];

    t = l > 0 ? fmin(fmax(t / l, 0), 1) : 0;
    return hypot(e[0] - t * d[0], e[1] - t * d[1]);
}

static inline double off_result(const ix_bisector *s, const double q[2])
{
    double best = INFINITY;

    for (int i = 0; i < s->n; i++)
        for (int j = 0; j + 1 < s->piece[i].n; j++) {
            const double *x = s->piece[i].x + 2 * j;

            best = fmin(best, off_segment(x, x + 2, q));
        }
    return best;
}

/* Is an end of one curve that is on the other one as near as r: does x border
 * on the region behind it? */
static inline bool at_region(const problem *p, const double *x, double r)
{
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < p->set[k].narcs; i++)
            for (int e = 0; e < 2; e++) {
                const double *v = p->set[k].arc[i].x[e ? ARC_SAMPLES : 0];

                if (fabs(truth_dist(v, x) - r) <= 1e-6 * fmax(r, p->size) &&
                    truth_distance(&p->set[1 - k], v) <= 1e-10 * p->size)
                    return true;
            }
    return false;
}

/* The bisector passes between u and v: where it does the result is near. Left
 * out where both feet are one, in and at the regions behind common ends. */
static inline void check_between(const problem *p, const double u[2],
                                 const double v[2], double at_u)
{
    double lo = 0, hi = 1, q[2];
    truth_foot f[2];

    for (int i = 0; i < 26; i++) {
        double m = 0.5 * (lo + hi);

        for (int k = 0; k < 2; k++)
            q[k] = u[k] + m * (v[k] - u[k]);
        if (truth_difference(p->set, q) * at_u < 0)
            hi = m;
        else
            lo = m;
    }
    for (int k = 0; k < 2; k++)
        f[k] = truth_nearest(&p->set[k], q, false, NULL);
    if (truth_dist(f[0].x, f[1].x) <= ONE_FOOT * p->size ||
        fabs(f[0].d - f[1].d) > 1e-6 * p->size || at_region(p, q, f[0].d))
        return;
    if (!(off_result(p->s, q) <= 3e-4 * fmax(p->size, f[0].d)))
        WRONG(p, "(%.12g, %.12g), radius %g, is %g off the result", q[0], q[1],
              f[0].d, off_result(p->s, q));
}

static inline void grid_point(const double mid[2], double h, int n, int i,
                              int j, double out[2])
{
    out[0] = mid[0] - h + 2 * h * i / n + 1.1e-3 * h;
    out[1] = mid[1] - h + 2 * h * j / n - 0.7e-3 * h;
}

/* All edges of a grid with n x n cells over a square of half the size h. */
static inline void check_grid(const problem *p, const double mid[2], double h,
                              int n)
{
    double *f = malloc((size_t)((n + 1) * (n + 1)) * sizeof *f);

    for (int j = 0; j <= n; j++)
        for (int i = 0; i <= n; i++) {
            double q[2], r[2];

            grid_point(mid, h, n, i, j, q);
            f[j * (n + 1) + i] = truth_difference(p->set, q);
            for (int k = 0; k < 2; k++) {
                int a = i - (k == 0), b = j - (k == 1);
                double last, now = f[j * (n + 1) + i];

                if (a < 0 || b < 0)
                    continue;
                last = f[b * (n + 1) + a];
                grid_point(mid, h, n, a, b, r);
                if (now * last < 0 &&
                    fmin(fabs(now), fabs(last)) > 1e-11 * p->size)
                    check_between(p, r, q, last);
            }
        }
    free(f);
}

/* Grids over everything, and around places of both curves and of the result. */
static inline void check_complete(const problem *p, ix_rng *r)
{
    check_grid(p, p->mid, 2.2 * p->size, p->close ? 40 : 8);
    for (int i = 0; i < (p->close ? 12 : 1); i++) {
        double h = p->size * pow(10, ix_rng_range(r, -3, -0.3)), x[2];
        const truth_set *s = &p->set[i & 1];
        const truth_arc *a = &s->arc[ix_rng_int(r, 0, s->narcs - 1)];

        truth_at(a, i < 4 ? i / 2 : ix_rng_unit(r), x);
        if (i >= 6 && p->s->n) {
            const ix_bisector_piece *g =
                &p->s->piece[ix_rng_int(r, 0, p->s->n - 1)];

            memcpy(x, g->x + (i & 1 ? 2 * (g->n - 1) : 0), sizeof x);
        }
        if (truth_dist(x, p->mid) < 5 * p->size)
            check_grid(p, x, h, p->close ? 14 : 5);
    }
}

/* --- topology --------------------------------------------------------------
 */

static inline const double *piece_end(const ix_bisector_piece *g, int e,
                                      double *r)
{
    *r = g->r[e ? g->n - 1 : 0];
    return g->x + (e ? 2 * (g->n - 1) : 0);
}

static inline bool meets_another(const problem *p, int i, int e)
{
    double r, s;
    const double *x = piece_end(&p->s->piece[i], e, &r);

    for (int k = 0; k < p->s->n; k++)
        for (int d = 0; d < 2; d++)
            if ((k != i || d != e) &&
                truth_dist(x, piece_end(&p->s->piece[k], d, &s)) <=
                    MEETING * fmax(p->size, r * r / p->size))
                return true;
    return false;
}

/* Law: the bisector is the border of what is nearer to the first: a piece ends
 * at infinity, where another begins, in a point of both curves, or at the
 * region behind a common end. */
static inline void check_ends(const problem *p)
{
    for (int i = 0; i < p->s->n; i++)
        for (int e = 0; e < 2; e++) {
            double r;
            const double *x = piece_end(&p->s->piece[i], e, &r);

            if (p->s->piece[i].unbounded[e] || r <= 1e-6 * p->size ||
                meets_another(p, i, e) || at_region(p, x, r))
                continue;
            WRONG(p, "piece %d of %d ends at (%.12g, %.12g), radius %g", i,
                  p->s->n, x[0], x[1], r);
        }
}

/* The difference of both support functions in direction a; 0 if both reach
 * farthest in a common end. */
static inline double support_difference(const problem *p, double a)
{
    double d[2] = {cos(a), sin(a)};
    double f = truth_support(&p->set[0], d) - truth_support(&p->set[1], d);

    return fabs(f) <= 1e-9 * p->size ? 0 : f;
}

/* Between the angles lo and hi the difference changes its sign: is it because
 * what is far out there borders on the region behind a common end? */
static inline bool region_far(const problem *p, double lo, double hi,
                              double at_lo)
{
    double d[2], reach;

    for (int i = 0; i < 40; i++) {
        double m = 0.5 * (lo + hi);

        if (support_difference(p, m) * at_lo > 0)
            lo = m;
        else
            hi = m;
    }
    d[0] = cos(lo);
    d[1] = sin(lo);
    reach = truth_support(&p->set[0], d);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < p->set[k].narcs; i++)
            for (int e = 0; e < 2; e++) {
                const double *v = p->set[k].arc[i].x[e ? ARC_SAMPLES : 0];

                if (d[0] * v[0] + d[1] * v[1] >= reach - 1e-7 * p->size &&
                    truth_distance(&p->set[1 - k], v) <= 1e-10 * p->size)
                    return true;
            }
    return false;
}

/* Law: far out the distance in direction n differs from that from the origin by
 * the support function: there is an end at infinity for each change of sign of
 * the difference of both. */
static inline void check_infinity(const problem *p)
{
    const double step = 2 * 3.14159265358979323846 / (p->close ? 3000 : 90);
    int n = p->close ? 3000 : 90, changes = 0, ends = 0;
    double last = 0;

    for (int i = 0; i <= n; i++) {
        double a = step * i + 1e-3, f = support_difference(p, a);

        changes += f * last < 0 && !region_far(p, a - step, a, last);
        last = f;
    }
    for (int i = 0; i < p->s->n; i++)
        ends += p->s->piece[i].unbounded[0] + p->s->piece[i].unbounded[1];
    if (ends < changes)
        WRONG(p, "%d ends at infinity, %d seen", ends, changes);
}

/* --- all -------------------------------------------------------------------
 */

static inline void measure(problem *p)
{
    double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};

    for (int s = 0; s < 2; s++)
        for (int i = 0; i < p->set[s].narcs; i++)
            for (int k = 0; k < 2; k++) {
                lo[k] = fmin(lo[k], p->set[s].arc[i].box[0][k]);
                hi[k] = fmax(hi[k], p->set[s].arc[i].box[1][k]);
            }
    p->size = 0.5 * fmax(hi[0] - lo[0], hi[1] - lo[1]);
    for (int k = 0; k < 2; k++)
        p->mid[k] = 0.5 * (lo[k] + hi[k]);
}

/* Everything about s, the bisector of the n[k] curves c[k]. r: where to look
 * closely. */
static inline void check_bisector(problem *p, const int n[2],
                                  const ix_mv *const *const c[2],
                                  const ix_bisector *s, ix_rng *r)
{
    p->s = s;
    for (int k = 0; k < 2; k++)
        p->set[k] = truth_of(p->ctx, n[k], c[k]);
    measure(p);
    check_sound(p);
    check_ends(p);
    check_infinity(p);
    check_complete(p, r);
    check_exact_points(p, c, r);
    for (int k = 0; k < 2; k++)
        free(p->set[k].arc);
}

#endif
