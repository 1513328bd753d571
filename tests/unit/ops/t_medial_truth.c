/* The medial axis of random regions, against dense sampling of their borders:
 * its circles are the largest ones, each largest circle is on it, it is
 * connected where the region is and has a loop around each hole.
 *
 * IX_TEST_ROUNDS=200 tries that many regions of each kind, and more closely;
 * IX_TEST_KIND=3 chooses one kind, IX_TEST_FIRST=17 begins with that one. By
 * default one region of each kind: 0.6 s, no kind can be left out. */
#include "crv_test.h"
#include "iritx/geom.h"
#include "planar_truth.h"

enum { RINGS = 6, POINTS = 128 };

/* Distances against golden sections, relative to the size. */
#define SOUND 1e-9
/* The polyline is within 1e-4 of the size. */
#define OFF 3e-4

static const double pi = 3.14159265358979323846;

static int number_of(const char *name, int otherwise)
{
    const char *s = getenv(name);

    return s ? atoi(s) : otherwise;
}

/* A region: closed curves, how many parts it has and how many holes. */
typedef struct {
    ix_ctx *ctx;
    int n, parts, holes;
    ix_mv *c[RINGS];
    bool exact; /* simple and apart by construction */
    int nconvex;
    double convex[POINTS][2]; /* corners of less than 180 degrees */
} region;

/* --- curves ----------------------------------------------------------------
 */

/* Closed curves of degree d: periodic (C^(d-1)) through n control points, or n
 * Bezier curves of n d control points. */
static ix_mv *closed(ix_ctx *ctx, int d, int n, const double (*p)[2],
                     const double *w, bool periodic)
{
    double kv[POINTS + 16], pts[3 * (POINTS + 1)];
    int m = periodic ? n : n * d + 1, axes = w ? 1 : 0;
    ix_dir dir = {IX_BSPLINE, d + 1, m, periodic, kv};
    ix_mv *c;

    if (periodic)
        for (int i = 0; i < n + 2 * d + 1; i++)
            kv[i] = i - d;
    else
        for (int i = 0; i < m + d + 1; i++)
            kv[i] = i <= d ? 0 : i >= m ? n : (i - 1) / d;
    for (int i = 0; i < m; i++) {
        int j = i % (periodic ? n : n * d);

        pts[i] = w ? w[j] : 1;
        for (int k = 0; k < 2; k++)
            pts[(axes + k) * m + i] = (w ? w[j] : 1) * p[j][k];
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 2, w != NULL, pts, &c));
    return c;
}

static void add(region *g, ix_mv *c)
{
    g->c[g->n++] = c;
}

/* n points around (x, y) between lo and hi away. */
static void around(ix_rng *r, int n, double x, double y, double lo, double hi,
                   double (*p)[2])
{
    for (int i = 0; i < n; i++) {
        double a = 2 * pi * i / n, s = ix_rng_range(r, lo, hi);

        p[i][0] = x + s * cos(a);
        p[i][1] = y + s * sin(a);
    }
}

static void add_blob(ix_rng *r, region *g, int n, double x, double y, double lo,
                     double hi, bool rational)
{
    double p[POINTS][2], w[POINTS];

    around(r, n, x, y, lo, hi, p);
    for (int i = 0; i < n; i++)
        w[i] = exp(ix_rng_range(r, -1, 1));
    add(g, closed(g->ctx, ix_rng_int(r, 2, 4), n, (const double(*)[2])p,
                  rational ? w : NULL, true));
}

static void add_circle(region *g, double x, double y, double radius)
{
    const double o[3] = {x, y, 0};
    ix_mv *c;

    ASSERT_OK(g->ctx, ix_circle(g->ctx, o, radius, &c));
    add(g, c);
}

/* A polygon and its convex corners, counter-clockwise. */
static void add_polygon(region *g, int n, const double (*p)[2])
{
    for (int i = 0; i < n; i++) {
        const double *a = p[(i + n - 1) % n], *b = p[i], *c = p[(i + 1) % n];
        double u[2] = {b[0] - a[0], b[1] - a[1]};
        double v[2] = {c[0] - b[0], c[1] - b[1]};

        if (u[0] * v[1] - u[1] * v[0] >
            1e-6 * hypot(u[0], u[1]) * hypot(v[0], v[1])) {
            memcpy(g->convex[g->nconvex++], b, sizeof *p);
        }
    }
    add(g, closed(g->ctx, 1, n, p, NULL, false));
}

/* --- kinds -----------------------------------------------------------------
 */

static void blob(ix_rng *r, region *g)
{
    add_blob(r, g, ix_rng_int(r, 5, 24), 0, 0, 0.4, 1.2, false);
}

static void rational(ix_rng *r, region *g)
{
    add_blob(r, g, ix_rng_int(r, 6, 14), 0, 0, 0.5, 1.2, true);
}

static void long_border(ix_rng *r, region *g)
{
    add_blob(r, g, ix_rng_int(r, 40, 100), 0, 0, 0.7, 1.2, false);
}

static void holes(ix_rng *r, region *g)
{
    int n = ix_rng_int(r, 1, 5);

    add_blob(r, g, ix_rng_int(r, 8, 20), 0, 0, 2.2, 2.8, false);
    for (int i = 0; i < n; i++) {
        double a = 2 * pi * i / n + ix_rng_range(r, 0, 0.2);

        add_blob(r, g, ix_rng_int(r, 5, 9), 1.1 * cos(a), 1.1 * sin(a), 0.15,
                 0.45, ix_rng_int(r, 0, 1));
    }
    g->holes = n;
}

static void polygon(ix_rng *r, region *g)
{
    double p[POINTS][2];
    int n = ix_rng_int(r, 3, 16);

    around(r, n, 0, 0, n < 5 ? 0.7 : 0.3, 1.2, p);
    add_polygon(g, n, (const double(*)[2])p);
}

/* Sides of degree 2 and 3 between corners. */
static void bent_polygon(ix_rng *r, region *g)
{
    double q[16][2], p[POINTS][2];
    int n = ix_rng_int(r, 3, 9), d = ix_rng_int(r, 2, 3);

    around(r, n, 0, 0, 0.7, 1.2, q);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < d; j++)
            for (int k = 0; k < 2; k++)
                p[i * d + j][k] = ((d - j) * q[i][k] + j * q[(i + 1) % n][k]) /
                                      d +
                                  (j ? ix_rng_range(r, -0.2, 0.2) : 0);
    add(g, closed(g->ctx, d, n, (const double(*)[2])p, NULL, false));
}

/* A circle but for noise. */
static void near_circle(ix_rng *r, region *g)
{
    double e = pow(10, ix_rng_range(r, -7, -1));

    add_blob(r, g, ix_rng_int(r, 12, 24), 0, 0, 1 - e, 1 + e, false);
}

/* An island that nearly touches the border. */
static void island(ix_rng *r, region *g)
{
    double gap = pow(10, ix_rng_range(r, -6, -1)), s = ix_rng_range(r, 0.2, 1);
    double a = ix_rng_range(r, 0, 6), d = 2 - s - gap;

    add_circle(g, 0, 0, 2);
    add_circle(g, d * cos(a), d * sin(a), s);
    g->holes = 1;
    g->exact = true;
}

/* Two wide parts and a neck between them. */
static void neck(ix_rng *r, region *g)
{
    double w = pow(10, ix_rng_range(r, -4, -1)), p[16][2];
    static const double q[16][2] = {
        {0.3, -1},  {1, -1.5},  {2, -1.2}, {2.5, 0},  {2, 1.2},  {1, 1.5},
        {0.3, 1},   {-0.3, 1},  {-1, 1.5}, {-2, 1.2}, {-2.5, 0}, {-2, -1.2},
        {-1, -1.5}, {-0.3, -1}, {0, 0},    {0, 0}};

    for (int i = 0; i < 14; i++)
        for (int k = 0; k < 2; k++)
            p[i][k] = q[i][k] + ix_rng_range(r, -0.1, 0.1);
    for (int i = 0; i < 14; i++)
        if (fabs(q[i][0]) < 0.5) {
            p[i][0] = q[i][0] * 3;
            p[i][1] = q[i][1] * w;
        }
    add(g, closed(g->ctx, ix_rng_int(r, 2, 3), 14, (const double(*)[2])p, NULL,
                  true));
    g->exact = true;
}

/* Corners of a grid: many circles touch more than three times. */
static void lattice(ix_rng *r, region *g)
{
    double p[POINTS][2];
    int n = ix_rng_int(r, 2, 7), m = 0;

    p[m][0] = 0;
    p[m++][1] = 0;
    p[m][0] = n;
    p[m++][1] = 0;
    for (int i = n; i > 0; i--)
        for (int k = 0; k < 2; k++) {
            p[m][0] = i - k;
            p[m][1] = k ? p[m - 1][1] : ix_rng_int(r, 1, 4);
            m++;
        }
    for (int i = m - 1; i > 1; i--) /* no corners on straight sides */
        if (p[i][1] == p[i - 1][1] && p[i][1] == p[(i + 1) % m][1]) {
            memmove(p[i], p[i + 1], (size_t)(m - i - 1) * sizeof *p);
            m--;
        }
    add_polygon(g, m, (const double(*)[2])p);
    if (ix_rng_int(r, 0, 1)) {
        add_circle(g, 0.5 * n, 0.5, 0.25);
        g->holes = 1;
    }
}

/* Alike all around: many branches meet in one node. */
static void regular(ix_rng *r, region *g)
{
    double p[POINTS][2], e = ix_rng_range(r, 0.4, 1);
    int n = ix_rng_int(r, 3, 9), d = ix_rng_int(r, 1, 3);

    for (int i = 0; i < 2 * n; i++) {
        double s = i & 1 ? e : 1, a = pi * i / n;

        p[i][0] = s * cos(a);
        p[i][1] = s * sin(a);
    }
    if (d > 1)
        add(g, closed(g->ctx, d, 2 * n, (const double(*)[2])p, NULL, true));
    else
        add_polygon(g, 2 * n, (const double(*)[2])p);
}

/* Straight sides and arcs: a convex polygon with round corners, each arc a
 * circle of its own. */
static void rounded(ix_rng *r, region *g)
{
    double q[8][2], t[8][2], p[POINTS][2], w[POINTS], rad = 0.3;
    int n = ix_rng_int(r, 3, 8);

    around(r, n, 0, 0, 1, 1, q);
    if (n == 4)
        for (int i = 0; i < n; i++)
            q[i][0] *= 2;
    for (int i = 0; i < n; i++) { /* normals of the sides, outwards */
        const double *a = q[i], *b = q[(i + 1) % n];
        double l = hypot(b[0] - a[0], b[1] - a[1]);

        t[i][0] = (b[1] - a[1]) / l;
        t[i][1] = (a[0] - b[0]) / l;
    }
    for (int i = 0; i < n; i++) {
        const double *u = t[(i + n - 1) % n], *v = t[i];
        double c = sqrt(0.5 * (1 + u[0] * v[0] + u[1] * v[1]));
        double m[2] = {u[0] + v[0], u[1] + v[1]}, l = hypot(m[0], m[1]);

        for (int k = 0; k < 2; k++) {
            p[4 * i][k] = q[i][k] + rad * u[k];
            p[4 * i + 1][k] = q[i][k] + rad * m[k] / l / c;
            p[4 * i + 2][k] = q[i][k] + rad * v[k];
            p[4 * i + 3][k] = 0.5 * (q[i][k] + q[(i + 1) % n][k]) + rad * v[k];
        }
        for (int j = 0; j < 4; j++)
            w[4 * i + j] = j == 1 ? c : 1;
    }
    add(g, closed(g->ctx, 2, 2 * n, (const double(*)[2])p, w, false));
    if (ix_rng_int(r, 0, 1)) {
        add_circle(g, ix_rng_range(r, -0.2, 0.2), ix_rng_range(r, -0.2, 0.2),
                   0.2);
        g->holes = 1;
    }
}

/* Two outer borders, one with a hole in which there is an island. */
static void parts(ix_rng *r, region *g)
{
    add_blob(r, g, 9, 0, 0, 1.7, 2, false);
    add_blob(r, g, 8, 0, 0, 0.9, 1.2, false);
    add_blob(r, g, 7, 0, 0, 0.3, 0.6, true);
    add_blob(r, g, 7, 4.5, 0.3, 0.5, 1.5, false);
    g->parts = 3;
    g->holes = 1;
}

static void far_away(ix_rng *r, region *g)
{
    double s = pow(10, ix_rng_range(r, -5, 5));
    double x = ix_rng_range(r, -200, 200);

    add_blob(r, g, ix_rng_int(r, 6, 14), s * x, -2 * s * x, 0.5 * s, 1.2 * s,
             false);
}

/* A spiral of constant width, with corners. */
static void spiral(ix_rng *r, region *g)
{
    double p[POINTS][2], w = ix_rng_range(r, 0.02, 0.3);
    int n = ix_rng_int(r, 6, 20);

    for (int i = 0; i < n; i++) {
        double a = 0.6 * i, s = 0.5 + 0.09 * i;

        for (int k = 0; k < 2; k++) {
            int j = k ? 2 * n - 1 - i : i;

            p[j][0] = (s - k * w) * cos(a);
            p[j][1] = (s - k * w) * sin(a);
        }
    }
    if (ix_rng_int(r, 0, 1))
        add_polygon(g, 2 * n, (const double(*)[2])p);
    else
        add(g, closed(g->ctx, 3, 2 * n, (const double(*)[2])p, NULL, true));
}

/* Circles only: rings, round one centre too. */
static void rings(ix_rng *r, region *g)
{
    int n = ix_rng_int(r, 1, 4);

    add_circle(g, 0, 0, 3);
    for (int i = 0; i < n; i++) {
        double a = 2 * pi * i / n, d = n > 1 ? 1.5 : ix_rng_int(r, 0, 2) * 0.7;

        add_circle(g, d * cos(a), d * sin(a), n > 1 ? 0.5 : 1);
    }
    g->holes = n;
    g->exact = true;
}

/* Discs beside each other, and a ring: graphs without branches and one that is
 * a circle. */
static void discs(ix_rng *r, region *g)
{
    g->parts = ix_rng_int(r, 1, 4);
    for (int i = 0; i < g->parts; i++)
        add_circle(g, 1.1 * i, 0.4 * i, ix_rng_range(r, 0.1, 0.5));
    if (ix_rng_int(r, 0, 1)) {
        add_circle(g, 1.1, 2.4, 0.9);
        add_circle(g, 1.1, 2.4, 0.3);
        g->parts++;
        g->holes = 1;
    }
    g->exact = true;
}

static const struct {
    const char *name;
    void (*make)(ix_rng *r, region *g);
} kinds[] = {{"blob", blob},
             {"rational", rational},
             {"long border", long_border},
             {"holes", holes},
             {"polygon", polygon},
             {"bent polygon", bent_polygon},
             {"near circle", near_circle},
             {"island", island},
             {"neck", neck},
             {"lattice", lattice},
             {"regular", regular},
             {"rounded", rounded},
             {"parts", parts},
             {"far away", far_away},
             {"spiral", spiral},
             {"rings", rings},
             {"discs", discs}};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* --- checks ----------------------------------------------------------------
 */

typedef struct {
    ix_ctx *ctx;
    const region *g;
    const ix_medial_axis *m;
    truth_set set;
    double size;
    const char *kind;
    int index;
} problem;

#define WRONG(p, ...)                                     \
    do {                                                  \
        printf("%s, region %d: ", (p)->kind, (p)->index); \
        printf(__VA_ARGS__);                              \
        printf("\n");                                     \
        fail_msg("%s, region %d", (p)->kind, (p)->index); \
    } while (0)

static double turn(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Do the sampled borders cross each other or themselves? */
static bool crosses(const truth_set *s)
{
    const int step = ARC_SAMPLES / 12;

    for (int i = 0; i < s->narcs * 12; i++)
        for (int j = 0; j < i; j++) {
            const double *a = s->arc[i / 12].x[i % 12 * step];
            const double *b = s->arc[i / 12].x[i % 12 * step + step];
            const double *c = s->arc[j / 12].x[j % 12 * step];
            const double *d = s->arc[j / 12].x[j % 12 * step + step];

            if (truth_dist(a, d) == 0 || truth_dist(b, c) == 0)
                continue; /* neighbours */
            if (fmax(a[0], b[0]) < fmin(c[0], d[0]) ||
                fmax(c[0], d[0]) < fmin(a[0], b[0]))
                continue;
            if (turn(a, b, c) * turn(a, b, d) < 0 &&
                turn(c, d, a) * turn(c, d, b) < 0)
                return true;
        }
    return false;
}

/* By the sampled borders; not at the height of ends, which may be a rounding
 * apart. */
static bool is_inside(const truth_set *s, double size, const double at[2])
{
    double q[2] = {at[0], at[1] + 1e-7 * size};
    bool in = false;

    for (int i = 0; i < s->narcs; i++)
        for (int j = 0; j < ARC_SAMPLES; j++) {
            const double *a = s->arc[i].x[j], *b = s->arc[i].x[j + 1];

            if ((a[1] > q[1]) != (b[1] > q[1]) &&
                (turn(a, b, q) > 0) == (b[1] > a[1]))
                in = !in;
        }
    return in;
}

/* Each vertex is inside, as far from the border as it says and as far from both
 * feet. */
static void check_vertex(const problem *p, const ix_medial_branch *b, int j)
{
    const double *x = b->x + 3 * j;
    double d = truth_distance(&p->set, x);

    if (!(fabs(d - x[2]) <= SOUND * p->size))
        WRONG(p, "(%.12g, %.12g), radius %.12g: distance %.12g", x[0], x[1],
              x[2], d);
    if (x[2] > 1e-3 * p->size && !is_inside(&p->set, p->size, x))
        WRONG(p, "(%.12g, %.12g), radius %g, is outside", x[0], x[1], x[2]);
    for (int k = 0; k < 2; k++) {
        double y[3];

        ASSERT_OK(p->ctx, ix_mv_point(p->ctx, p->g->c[b->curve[k]],
                                      &b->foot[2 * j + k], y));
        if (!(fabs(truth_dist(x, y) - x[2]) <= SOUND * p->size))
            WRONG(p,
                  "(%.12g, %.12g), radius %.12g: foot %d (%g of curve %d) "
                  "is %.12g away",
                  x[0], x[1], x[2], k + 1, b->foot[2 * j + k], b->curve[k],
                  truth_dist(x, y));
    }
}

static void check_chord(const problem *p, const double *x)
{
    double m[2] = {0.5 * (x[0] + x[3]), 0.5 * (x[1] + x[4])};
    double d = truth_distance(&p->set, m), r = 0.5 * (x[2] + x[5]);

    if (!(fabs(d - r) <= OFF * p->size))
        WRONG(p, "the chord (%.12g, %.12g) (%.12g, %.12g): distance %g, not %g",
              x[0], x[1], x[3], x[4], d, r);
}

static void check_sound(const problem *p, int step)
{
    int skip = step > 60 ? 1 + p->m->nbranches / 3 : 1;

    for (int i = 0; i < p->m->nbranches; i += skip) {
        const ix_medial_branch *b = &p->m->branch[i];

        for (int j = 0; j < b->n; j++) {
            if (j % step && j + 2 < b->n)
                continue;
            check_vertex(p, b, j);
            if (j + 1 < b->n)
                check_chord(p, b->x + 3 * j);
        }
    }
}

static double off_axis(const ix_medial_axis *m, const double q[2])
{
    double best = INFINITY;

    for (int i = 0; i < m->nnodes; i++)
        best = fmin(best, truth_dist(q, m->node[i].x));
    for (int i = 0; i < m->nbranches; i++)
        for (int j = 0; j + 1 < m->branch[i].n; j++) {
            const double *x = m->branch[i].x + 3 * j;
            double d[2] = {x[3] - x[0], x[4] - x[1]};
            double e[2] = {q[0] - x[0], q[1] - x[1]};
            double l = d[0] * d[0] + d[1] * d[1];
            double t = l > 0 ? (d[0] * e[0] + d[1] * e[1]) / l : 0;

            t = fmin(fmax(t, 0), 1);
            best = fmin(best, hypot(e[0] - t * d[0], e[1] - t * d[1]));
        }
    return best;
}

/* The radius of the largest circle that touches at c and comes no nearer to
 * the border than by depth. */
static double largest(const problem *p, const double c[2], const double n[2],
                      double depth)
{
    double lo = 0, hi = 4 * p->size;

    for (int i = 0; i < 40; i++) {
        double m = 0.5 * (lo + hi), x[2] = {c[0] + m * n[0], c[1] + m * n[1]};

        if (truth_distance(&p->set, x) < m - depth)
            hi = m;
        else
            lo = m;
    }
    return lo;
}

/* Law: the largest circle inside that touches at c is on the axis. Where it is
 * nearly that of curvature its radius is not known well (the depth grows with
 * the second to fourth power of what is too much): then some of those that may
 * be it. */
static void check_largest(const problem *p, const double c[2],
                          const double n[2])
{
    double lo = largest(p, c, n, 1e-12 * p->size), best = INFINITY;
    double hi = largest(p, c, n, 1e-10 * p->size);
    int steps;

    lo -= 0.5 * (hi - lo);
    steps = 1 + (int)((hi - lo) / (OFF * p->size));
    for (int i = 0; i <= steps && best > OFF * p->size; i++) {
        double r = lo + (hi - lo) * i / steps;
        double x[2] = {c[0] + r * n[0], c[1] + r * n[1]};

        best = fmin(best, off_axis(p->m, x));
    }
    if (!(best <= OFF * p->size))
        WRONG(p,
              "at (%.12g, %.12g), radius %g to %g: (%g, %g) is %g off the axis",
              c[0], c[1], lo, hi, c[0] + lo * n[0], c[1] + lo * n[1], best);
}

/* Along the arc, of any length. */
static void tangent(const truth_arc *a, double u, double out[2])
{
    double b[3][2], p[ARC_DEGREE + 1];

    for (int k = 0; k < 3; k++) {
        memcpy(p, a->c[k], sizeof p);
        for (int n = a->degree; n > 1; n--)
            for (int i = 0; i < n; i++)
                p[i] += u * (p[i + 1] - p[i]);
        b[k][0] = p[0] + u * (p[1] - p[0]);
        b[k][1] = p[1] - p[0];
    }
    for (int k = 0; k < 2; k++)
        out[k] = b[k + 1][1] - b[0][1] * (b[k + 1][0] / b[0][0]);
}

/* A place of the border and the normal there, inwards; false near a corner. */
static bool border(const problem *p, int arc, double u, double c[2],
                   double n[2])
{
    const truth_arc *a = &p->set.arc[arc];
    double x[2], t[2], l;

    truth_at(a, u, c);
    tangent(a, u, t);
    l = hypot(t[0], t[1]);
    if (!(l > 0))
        return false;
    n[0] = -t[1] / l;
    n[1] = t[0] / l;
    x[0] = c[0] + 1e-3 * p->size * n[0];
    x[1] = c[1] + 1e-3 * p->size * n[1];
    if (truth_distance(&p->set, x) < 0.99e-3 * p->size)
        return false;
    if (!is_inside(&p->set, p->size, x)) {
        n[0] = -n[0];
        n[1] = -n[1];
    }
    return true;
}

/* From places of the border, and from what is nearest to places inside. */
static void check_complete(const problem *p, ix_rng *r, int count)
{
    for (int i = 0; i < count; i++) {
        int arc = ix_rng_int(r, 0, p->set.narcs - 1);
        double u = ix_rng_range(r, 1e-4, 1 - 1e-4), c[2], n[2], q[2];
        truth_foot f;

        if (border(p, arc, u, c, n))
            check_largest(p, c, n);
        truth_at(&p->set.arc[arc], u, c);
        for (int k = 0; k < 2; k++)
            q[k] = c[k] + 0.6 * p->size * ix_rng_range(r, -1, 1);
        if (!is_inside(&p->set, p->size, q))
            continue;
        f = truth_nearest(&p->set, q, false, NULL);
        if (!(f.d > 1e-3 * p->size))
            continue;
        if (!(f.u > 1e-6 && f.u < 1 - 1e-6)) { /* a corner's fan */
            for (int k = 0; k < 2; k++)
                n[k] = (q[k] - f.x[k]) / f.d;
            check_largest(p, f.x, n);
        } else if (border(p, f.arc, f.u, c, n)) /* feet are known to 1e-8 */
            check_largest(p, c, n);
    }
}

/* Law: one graph for each part of the region, with a loop around each hole;
 * branches end where their nodes are. */
static void check_graph(const problem *p)
{
    const ix_medial_axis *m = p->m;
    int *root = malloc((size_t)(m->nnodes + 1) * sizeof *root), n = m->nnodes;
    int *ends = calloc((size_t)m->nnodes + 1, sizeof *ends);

    for (int i = 0; i < m->nnodes; i++)
        root[i] = i;
    for (int i = 0; i < m->nbranches; i++) {
        const ix_medial_branch *b = &m->branch[i];
        int at[2];

        for (int e = 0; e < 2; e++) {
            const double *x = b->x + (e ? 3 * (b->n - 1) : 0);

            at[e] = b->node[e];
            ends[at[e]]++;
            if (!(truth_dist(x, m->node[at[e]].x) <= 1e-5 * m->size))
                WRONG(p, "branch %d ends %g from its node", i,
                      truth_dist(x, m->node[at[e]].x));
            while (root[at[e]] != at[e])
                at[e] = root[at[e]];
        }
        n -= at[0] != at[1];
        root[at[0]] = at[1];
    }
    for (int i = 0; i < m->nnodes; i++)
        if (ends[i] != m->node[i].degree)
            WRONG(p, "node %d has %d ends, degree %d", i, ends[i],
                  m->node[i].degree);
    free(root);
    free(ends);
    if (n != p->g->parts ||
        m->nbranches - m->nnodes != p->g->holes - p->g->parts)
        WRONG(p, "%d graphs with %d branches, %d nodes: %d parts, %d holes", n,
              m->nbranches, m->nnodes, p->g->parts, p->g->holes);
}

/* Convex corners are ends. */
static void check_corners(const problem *p)
{
    for (int i = 0; i < p->g->nconvex; i++) {
        bool found = false;

        for (int j = 0; j < p->m->nnodes && !found; j++)
            found = truth_dist(p->m->node[j].x, p->g->convex[i]) <=
                        1e-6 * p->size &&
                    p->m->node[j].degree == 1 &&
                    p->m->node[j].r <= 1e-6 * p->size;
        if (!found)
            WRONG(p, "no branch to the corner (%g, %g)", p->g->convex[i][0],
                  p->g->convex[i][1]);
    }
}

static void check_again(const problem *p)
{
    ix_medial_axis m;
    bool same;

    ASSERT_OK(p->ctx, ix_medial_axis_of(p->ctx, p->g->n,
                                        (const ix_mv *const *)p->g->c, 0, &m));
    same = m.nbranches == p->m->nbranches && m.nnodes == p->m->nnodes;
    for (int i = 0; same && i < m.nbranches; i++)
        same = m.branch[i].n == p->m->branch[i].n &&
               memcmp(m.branch[i].x, p->m->branch[i].x,
                      3 * (size_t)m.branch[i].n * sizeof(double)) == 0;
    ix_medial_axis_free(p->ctx, &m);
    if (!same)
        WRONG(p, "another result the second time");
}

static void measure(problem *p)
{
    double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};

    for (int i = 0; i < p->set.narcs; i++)
        for (int k = 0; k < 2; k++) {
            lo[k] = fmin(lo[k], p->set.arc[i].box[0][k]);
            hi[k] = fmax(hi[k], p->set.arc[i].box[1][k]);
        }
    p->size = 0.5 * fmax(hi[0] - lo[0], hi[1] - lo[1]);
}

/* In (nearly) a circle everything is equally near, which takes the truth long.
 */
static int effort(int kind, bool closely)
{
    bool slow = kinds[kind].make == near_circle || kinds[kind].make == discs;

    return closely ? slow ? 6 : 60 : slow ? 0 : 2;
}

static void check(int kind, int index, bool closely)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    region g = {.ctx = ctx, .parts = 1};
    problem p = {.ctx = ctx, .g = &g, .kind = kinds[kind].name, .index = index};
    ix_rng r = {91u + (uint64_t)kind * 1000003u + (uint64_t)index * 7919u};
    ix_medial_axis m;

    r.s = ix_rng_next(&r);
    kinds[kind].make(&r, &g);
    p.set = truth_of(ctx, g.n, (const ix_mv *const *)g.c);
    measure(&p);
    if (g.exact || !crosses(&p.set)) {
        ASSERT_OK(
            ctx, ix_medial_axis_of(ctx, g.n, (const ix_mv *const *)g.c, 0, &m));
        p.m = &m;
        check_graph(&p);
        check_corners(&p);
        check_sound(&p, effort(kind, closely) > 6 ? 5 : 61);
        check_complete(&p, &r, effort(kind, closely));
        if (closely)
            check_again(&p);
        ix_medial_axis_free(ctx, &m);
    }
    free(p.set.arc);
    for (int i = 0; i < g.n; i++)
        ix_mv_unref(ctx, g.c[i]);
    ix_ctx_free(ctx);
}

static void all_kinds(void **state)
{
    int one = number_of("IX_TEST_KIND", -1);
    int first = number_of("IX_TEST_FIRST", 0);
    int rounds = number_of("IX_TEST_ROUNDS", 1);

    (void)state;
    for (int kind = 0; kind < KINDS; kind++)
        for (int i = first; i < first + rounds; i++)
            if (one < 0 || one == kind)
                check(kind, i, rounds > 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_kinds),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
