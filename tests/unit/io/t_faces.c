/* Laws of trimmed meshes, measured on dense samples: triangles are within the
 * tolerance of the surface at the same parameters, border edges of the trimming
 * curves on it, in space; the triangles cover the enclosed region once; inner
 * edges have two triangles; faces of a model that share an edge have no crack
 * there. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harness/can.h"
#include "harness/fault.h"
#include "harness/randmv.h"
#include "io/faces.h"
#include "io/io.h"

IX_TEST_FIXTURE(0xface5u)

/* Rounding on both sides, relative to the tolerances used, above 1e-6. */
#define SLACK 1e-6

#define MOST_LOOPS 4

/* --- making faces --------------------------------------------------------- */

/* A closed cubic through n control points about (x, y), radii between r / 2 and
 * r, starting and ending at the first; u and v stretch to the domain of m. */
static ix_mv *blob(const ix_mv *m, int n, double x, double y, double r)
{
    double knots[40], pts[64], du[2], dv[2];
    const ix_dir dir = {IX_BSPLINE, 4, n + 1, false, knots};
    ix_mv *c;

    ix_mv_domain(m, 0, du);
    ix_mv_domain(m, 1, dv);
    ASSERT_OK(ctx, ix_knots_make(ctx, IX_KV_OPEN, 4, n + 1, knots));
    for (int i = 0; i <= n; i++) {
        double a = 2 * acos(-1.) * (i % n) / n;
        double s = r * (i % n ? .5 + .5 * ix_rng_unit(&rng) : 1);

        pts[i] = du[0] + (du[1] - du[0]) * (x + s * cos(a));
        pts[n + 1 + i] = dv[0] + (dv[1] - dv[0]) * (y + s * sin(a));
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 2, false, pts, &c));
    return c;
}

/* A polyline of n points x, y in parts of the domain of m. */
static ix_mv *polyline(const ix_mv *m, int n, const double (*xy)[2])
{
    double knots[40], pts[64], dom[2];
    const ix_dir dir = {IX_BSPLINE, 2, n, false, knots};
    ix_mv *c;

    ASSERT_OK(ctx, ix_knots_make(ctx, IX_KV_OPEN, 2, n, knots));
    for (int d = 0; d < 2; d++) {
        ix_mv_domain(m, d, dom);
        for (int i = 0; i < n; i++)
            pts[d * n + i] = xy[i][d] == 1
                                 ? dom[1]
                                 : dom[0] + (dom[1] - dom[0]) * xy[i][d];
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 2, false, pts, &c));
    return c;
}

static ix_mv *frame(const ix_mv *m)
{
    static const double xy[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};

    return polyline(m, 5, xy);
}

/* A face with n loops of one curve each. */
typedef struct {
    ix__face face;
    ix__face_loop loop[MOST_LOOPS];
    ix__face_curve curve[MOST_LOOPS];
    ix_mv *uv[MOST_LOOPS], *srf;
} simple;

static void make_simple(simple *s, ix_mv *srf, int n, ix_mv *const *uv)
{
    *s = (simple){.srf = srf};
    s->face = (ix__face){.srf = srf, .nloops = n, .loop = s->loop};
    for (int i = 0; i < n; i++) {
        s->uv[i] = uv[i];
        s->curve[i] = (ix__face_curve){.uv = uv[i], .edge = -1};
        s->loop[i] = (ix__face_loop){1, &s->curve[i]};
    }
}

static void drop_simple(simple *s)
{
    for (int i = 0; i < s->face.nloops; i++)
        ix_mv_unref(ctx, s->uv[i]);
    ix_mv_unref(ctx, s->srf);
}

/* --- measuring ------------------------------------------------------------ */

static void surface_at(const ix_mv *m, const double *uv, double *out)
{
    double v[IX_MAX_COORDS];

    ASSERT_OK(ctx, ix_mv_point(ctx, m, uv, v));
    for (int c = 0; c < 3; c++)
        out[c] = c < ix_mv_ncoords(m) ? v[c] : 0;
}

static double distance(const double *a, const double *b)
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* The largest distance from the surface at the same parameters. */
static double inner_error(const ix_mv *m, const ix__mesh *g)
{
    size_t step = 1 + g->ntris / 300;
    double most = 0;

    for (size_t i = 0; i < g->ntris; i += step)
        for (int a = 0; a <= 3; a++)
            for (int b = 0; a + b <= 3; b++) {
                const double w[3] = {a / 3., b / 3., (3 - a - b) / 3.};
                double x[3] = {0}, uv[2] = {0}, y[3];

                for (int k = 0; k < 3; k++) {
                    size_t v = g->tri[i][k];

                    for (size_t c = 0; c < 3; c++)
                        x[c] += w[k] * g->xyz[3 * v + c];
                    for (size_t c = 0; c < 2; c++)
                        uv[c] += w[k] * g->uv[2 * v + c];
                }
                surface_at(m, uv, y);
                most = fmax(most, distance(x, y));
            }
    return most;
}

enum { DENSE = 4000 };

/* Points of all curves on the surface: xyz[n DENSE][3]; *area: what they
 * enclose in the parameter plane, holes negative. */
static double *dense(const simple *s, double *area)
{
    int n = s->face.nloops;
    double *xyz = malloc(3 * sizeof *xyz * DENSE * (size_t)n);

    assert_non_null(xyz);
    *area = 0;
    for (int l = 0; l < n; l++) {
        double dom[2], p[IX_MAX_COORDS], q[2] = {0}, part = 0;

        ix_mv_domain(s->uv[l], 0, dom);
        for (int i = 0; i < DENSE; i++) {
            double t = dom[0] + (dom[1] - dom[0]) * i / (DENSE - 1);

            ASSERT_OK(ctx, ix_mv_point(ctx, s->uv[l], &t, p));
            if (i > 0)
                part += (p[1] - q[1]) * (p[0] + q[0]) / 2;
            memcpy(q, p, sizeof q);
            surface_at(s->srf, p, xyz + 3 * (size_t)(l * DENSE + i));
        }
        *area += l == 0 ? fabs(part) : -fabs(part);
    }
    return xyz;
}

static double covered(const ix__mesh *g)
{
    double sum = 0;

    for (size_t i = 0; i < g->ntris; i++) {
        const double *a = g->uv + 2 * g->tri[i][0];
        const double *b = g->uv + 2 * g->tri[i][1];
        const double *c = g->uv + 2 * g->tri[i][2];
        double twice = (b[0] - a[0]) * (c[1] - a[1]) -
                       (b[1] - a[1]) * (c[0] - a[0]);

        /* counter-clockwise, but for what integers round away */
        assert_true(twice > -1e-8);
        sum += twice / 2;
    }
    return sum;
}

/* Edges of a mesh: corners in order, and how often each is there. */
typedef struct {
    uint32_t a, b;
    int ahead, back;
} edge;

static int by_corners(const void *x, const void *y)
{
    const edge *p = x, *q = y;

    if (p->a != q->a)
        return p->a < q->a ? -1 : 1;
    return p->b < q->b ? -1 : p->b > q->b;
}

static edge *edges_of(const ix__mesh *g, size_t *n)
{
    edge *e = malloc(3 * g->ntris * sizeof *e);
    size_t k = 0;

    assert_non_null(e);
    for (size_t i = 0; i < 3 * g->ntris; i++) {
        uint32_t a = g->tri[i / 3][i % 3], b = g->tri[i / 3][(i + 1) % 3];

        e[i] = a < b ? (edge){a, b, 1, 0} : (edge){b, a, 0, 1};
    }
    qsort(e, 3 * g->ntris, sizeof *e, by_corners);
    for (size_t i = 0; i < 3 * g->ntris; i++) {
        if (k > 0 && by_corners(&e[i], &e[k - 1]) == 0) {
            e[k - 1].ahead += e[i].ahead;
            e[k - 1].back += e[i].back;
        } else {
            e[k++] = e[i];
        }
    }
    *n = k;
    return e;
}

static double to_segment(const double *p, const double *a, const double *b)
{
    double d = 0, l = 0, x[3];

    for (int c = 0; c < 3; c++) {
        d += (p[c] - a[c]) * (b[c] - a[c]);
        l += (b[c] - a[c]) * (b[c] - a[c]);
    }
    d = l > 0 ? fmin(fmax(d / l, 0), 1) : 0;
    for (int c = 0; c < 3; c++)
        x[c] = a[c] + d * (b[c] - a[c]);
    return distance(p, x);
}

static double to_curves(const double *p, int nloops, const double *xyz)
{
    double least = HUGE_VAL;

    for (int i = 0; i < nloops * DENSE; i++)
        if (i % DENSE)
            least = fmin(least, to_segment(p, xyz + 3 * (i - 1), xyz + 3 * i));
    return least;
}

/* Ends and middles of some border edges, from the curves; no edge has more than
 * two triangles, and these run through it both ways. */
static double border_error(const ix__mesh *g, int nloops, const double *xyz,
                           long *euler)
{
    size_t n, nb = 0;
    edge *e = edges_of(g, &n);
    double most = 0;

    for (size_t i = 0; i < n; i++) {
        const double *a = g->xyz + 3 * e[i].a, *b = g->xyz + 3 * e[i].b;
        double mid[3];

        assert_true(e[i].ahead <= 1 && e[i].back <= 1);
        if (e[i].ahead + e[i].back != 1 || nb++ % 5)
            continue;
        for (int c = 0; c < 3; c++)
            mid[c] = (a[c] + b[c]) / 2;
        most = fmax(most, to_curves(mid, nloops, xyz));
        most = fmax(most, to_curves(a, nloops, xyz));
    }
    *euler = (long)g->nverts - (long)n + (long)g->ntris;
    free(e);
    return most;
}

/* *out with the triangles, for further looks; s is dropped. */
static void check(simple *s, double tol, long euler)
{
    ix_mark mk = ix__scratch_mark(ctx);
    double area, got, err, *xyz = dense(s, &area), dom[2], size = 1;
    ix__mesh *g;
    long chi;

    for (int d = 0; d < 2; d++) {
        ix_mv_domain(s->srf, d, dom);
        size *= dom[1] - dom[0];
    }
    ASSERT_OK(ctx, ix__mesh_of_faces(ctx, 1, &s->face, tol, NULL, &g));
    assert_true(inner_error(s->srf, g) <= tol * (1 + SLACK));
    err = border_error(g, s->face.nloops, xyz, &chi);
    assert_true(err <= tol * (1 + SLACK));
    assert_int_equal(chi, euler);
    got = covered(g);
    /* chords cut off slivers: less than 2 % of the domain at these tolerances
     */
    assert_true(fabs(got - area) <= .02 * size);
    ix__mesh_free(ctx, g);
    ix__scratch_release(ctx, mk);
    free(xyz);
    drop_simple(s);
}

static ix_mv *random_surface(void)
{
    const ix_rand_opts o = {.ndirs = 2,
                            .ncoords = 3,
                            .kinds = IX_RAND_OPEN | IX_RAND_BEZIER,
                            .min_order = 2,
                            .max_knots = 2};

    return ix_mv_randtest(ctx, &rng, &o);
}

/* --- tests ---------------------------------------------------------------- */

static void test_region(void **state)
{
    (void)state;
    for (int i = 0; i < 6; i++) {
        ix_mv *m = random_surface();
        ix_mv *const uv[1] = {blob(m, 9, .5, .5, .48)};
        simple s;

        make_simple(&s, m, 1, uv);
        check(&s, .03, 1);
    }
}

/* The domain with two holes: their tops touch, the second one the border's
 * right side in a point. */
static void test_holes(void **state)
{
    (void)state;
    for (int i = 0; i < 6; i++) {
        ix_mv *m = random_surface();
        ix_mv *const uv[3] = {frame(m), blob(m, 7, .25, .4, .2),
                              blob(m, 8, .7, .6, .24)};
        simple s;

        make_simple(&s, m, 3, uv);
        check(&s, .05, -1);
    }
}

/* Loops that run along the domain's border, and along each other. */
static void test_borders(void **state)
{
    static const double left[5][2] = {{0, 0}, {.5, 0}, {.5, 1}, {0, 1}, {0, 0}};
    static const double hole[5][2] = {
        {0, .25}, {.5, .25}, {.5, .5}, {0, .5}, {0, .25}};

    (void)state;
    for (int i = 0; i < 4; i++) {
        ix_mv *m = random_surface();
        ix_mv *const uv[2] = {polyline(m, 5, left), polyline(m, 5, hole)};
        simple s;

        make_simple(&s, m, 2, uv);
        check(&s, .05, 2); /* two pieces */
    }
}

/* A figure eight: what crosses itself gets a vertex there. */
static void test_crossing(void **state)
{
    static const double xy[5][2] = {
        {.1, .13}, {.9, .81}, {.9, .13}, {.1, .81}, {.1, .13}};
    ix_mv *m, *eight;
    double area;
    simple s;
    ix__mesh *g;

    (void)state;
    for (int i = 0; i < 4; i++) {
        ix_mark mk = ix__scratch_mark(ctx);

        m = random_surface();
        eight = polyline(m, 5, xy);
        make_simple(&s, m, 1, &eight);
        free(dense(&s, &area));
        ASSERT_OK(ctx, ix__mesh_of_faces(ctx, 1, &s.face, .1, NULL, &g));
        /* two triangles of .8 by .34, on the way of the diagonals */
        {
            double du[2], dv[2];

            ix_mv_domain(m, 0, du);
            ix_mv_domain(m, 1, dv);
            assert_true(fabs(covered(g) / ((du[1] - du[0]) * (dv[1] - dv[0])) -
                             .8 * .68 / 2) < 1e-6);
        }
        assert_true(inner_error(m, g) <= .1 * (1 + SLACK));
        ix__mesh_free(ctx, g);
        drop_simple(&s);
        ix__scratch_release(ctx, mk);
    }
}

enum { COLUMNS = 200 };

/* The part of the unit square that a closed polyline encloses an odd number of
 * times, by the lengths of columns. */
static double odd_part(int n, double (*xy)[2])
{
    double sum = 0, y[40];

    for (int c = 0; c < COLUMNS; c++) {
        double x = (c + .5 + 1e-7) / COLUMNS;
        int q = 0;

        for (int k = 0; k < n; k++) {
            const double *a = xy[k], *b = xy[k + 1];
            double at, i;

            if ((a[0] > x) == (b[0] > x))
                continue;
            at = a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
            at = fmin(fmax(at, 0), 1);
            for (i = q++; i > 0 && y[(int)i - 1] > at; i--)
                y[(int)i] = y[(int)i - 1];
            y[(int)i] = at;
        }
        for (int k = 0; k + 1 < q; k += 2)
            sum += (y[k + 1] - y[k]) / COLUMNS;
    }
    return sum;
}

/* Scribbles: edges that cross many times, coincide, meet in points and leave
 * the domain. Columns miss less than 1/100 of the area. */
static void test_scribbles(void **state)
{
    (void)state;
    for (int i = 0; i < 24; i++) {
        ix_mark mk = ix__scratch_mark(ctx);
        int n = ix_rng_int(&rng, 4, 29);
        double xy[30][2], du[2], dv[2], got;
        ix_mv *m = random_surface(), *uv;
        ix__mesh *g;
        simple s;

        for (int k = 0; k < 2 * n; k++)
            xy[k / 2][k % 2] = i % 2 ? ix_rng_int(&rng, 0, 4) / 4.
                                     : ix_rng_range(&rng, -.2, 1.2);
        memcpy(xy[n], xy[0], sizeof xy[0]);
        uv = polyline(m, n + 1, (const double(*)[2])xy);
        make_simple(&s, m, 1, &uv);
        ix_mv_domain(m, 0, du);
        ix_mv_domain(m, 1, dv);
        ASSERT_OK(ctx, ix__mesh_of_faces(ctx, 1, &s.face, .2, NULL, &g));
        got = covered(g) / ((du[1] - du[0]) * (dv[1] - dv[0]));
        assert_true(fabs(got - odd_part(n, xy)) < .01);
        ix__mesh_free(ctx, g);
        drop_simple(&s);
        ix__scratch_release(ctx, mk);
    }
}

/* A curve that leaves the domain is cut off there. */
static void test_outside(void **state)
{
    static const double xy[5][2] = {
        {.5, .5}, {3, .5}, {3, 2}, {.5, 2}, {.5, .5}};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_mv *m = random_surface(), *uv = polyline(m, 5, xy);
    double du[2], dv[2];
    ix__mesh *g;
    simple s;

    (void)state;
    make_simple(&s, m, 1, &uv);
    ix_mv_domain(m, 0, du);
    ix_mv_domain(m, 1, dv);
    ASSERT_OK(ctx, ix__mesh_of_faces(ctx, 1, &s.face, .1, NULL, &g));
    assert_true(fabs(covered(g) / ((du[1] - du[0]) * (dv[1] - dv[0])) - .25) <
                1e-8);
    ix__mesh_free(ctx, g);
    drop_simple(&s);
    ix__scratch_release(ctx, mk);
}

/* A sphere's eighth within a circle of parameters: depth below the sphere, and
 * the border's points at the circle's parameters, in closed form. */
static void test_sphere(void **state)
{
    const double h = sqrt(.5);
    const double c[3][3] = {{1, 1, 0}, {h, h, h}, {1, 0, 1}}; /* w x y */
    const ix_dir d[2] = {{IX_BEZIER, 3, 3, false, NULL},
                         {IX_BEZIER, 3, 3, false, NULL}};
    double pts[36];
    ix_mv *m, *uv;
    simple s;

    (void)state;
    for (int k = 0; k < 9; k++) {
        pts[k] = c[k % 3][0] * c[k / 3][0];
        pts[9 + k] = c[k % 3][1] * c[k / 3][1];
        pts[18 + k] = c[k % 3][2] * c[k / 3][1];
        pts[27 + k] = c[k % 3][0] * c[k / 3][2];
    }
    for (double tol = .03; tol > 1e-3; tol /= 5) {
        ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, true, pts, &m));
        uv = blob(m, 9, .5, .5, .5);
        make_simple(&s, m, 1, &uv);
        check(&s, tol, 1);
    }
}

/* --- models --------------------------------------------------------------- */

/* A bent edge between two faces, curved in both parameter planes: the plane
 * z = 0 above y = f(x) and z = f(x) - y below it. */
#define BENT                                                       \
    "[MODEL 2 3 [MDLTSRF 1 [SURFACE BEZIER 2 2 E3 [0 0 0][2 0 0]"  \
    "[0 2 0][2 2 0]][MDLLOOP 1 2]]"                                \
    "[MDLTSRF 1 [SURFACE BEZIER 4 4 E3 %s][MDLLOOP -1 3]]"         \
    "[MDLTSEG 7 1 2 [CURVE BEZIER 4 E2 [0 .2][.3 .7][.7 0][1 .4]]" \
    "[CURVE BEZIER 4 E2 [0 .2][.3 .7][.7 0][1 .4]]"                \
    "[CURVE BEZIER 4 E3 [0 .4 0][.6 1.4 0][1.4 0 0][2 .8 0]]]"     \
    "[MDLTSEG 1 1 0 [CURVE BSPLINE 4 2 E2 [KV 0 0 1 2 3 3]"        \
    "[1 .4][1 1][0 1][0 .2]]]"                                     \
    "[MDLTSEG 1 2 0 [CURVE BSPLINE 4 2 E2 [KV 0 0 1 2 3 3]"        \
    "[0 .2][0 0][1 0][1 .4]]]]"

static int by_point(const void *a, const void *b)
{
    return memcmp(a, b, 3 * sizeof(double));
}

/* Points of border edges of a mesh that lie near the curve y = f(x), sorted;
 * returns how many. */
static size_t edge_points(const ix__mesh *g, double (*out)[3])
{
    size_t n, k = 0;
    edge *e = edges_of(g, &n);

    for (size_t i = 0; i < n; i++) {
        const double *a = g->xyz + 3 * e[i].a, *b = g->xyz + 3 * e[i].b;

        if (e[i].ahead + e[i].back != 1 || fmin(a[1], b[1]) < 1e-9 ||
            fmax(a[1], b[1]) > 2 - 1e-9 || fmax(a[0], b[0]) < 1e-9 ||
            fmin(a[0], b[0]) > 2 - 1e-9)
            continue;
        memcpy(out[k++], a, sizeof *out);
        memcpy(out[k++], b, sizeof *out);
    }
    free(e);
    qsort(out, k, sizeof *out, by_point);
    return k;
}

/* A bicubic Bezier surface as text: (2x, 2y) with a bump that vanishes nowhere
 * in particular when bump is not 0. */
static void bicubic(char *s, size_t size, double bump)
{
    s[0] = '\0';
    for (int j = 0; j < 4; j++)
        for (int i = 0; i < 4; i++) {
            size_t n = strlen(s);

            (void)snprintf(s + n, size - n, "[%.17g %.17g %.17g]", 2 * i / 3.,
                           2 * j / 3., bump * (i % 2) * (j % 2));
        }
}

/* Both faces have the same border edges along the common curve. */
static void test_model(void **state)
{
    static double p[2][20000][3];
    char text[4000], net[2000];
    ix_mark mk = ix__scratch_mark(ctx);
    ix__face *face;
    ix__mesh *g;
    size_t n[2];
    ix_obj *o;

    (void)state;
    bicubic(net, sizeof net, 2e-4);
    (void)snprintf(text, sizeof text, BENT, net);
    ASSERT_OK(ctx, ix__itd_read(ctx, "t", text, strlen(text), &o));
    ASSERT_OK(ctx, ix__faces_of_model(ctx, o->u.model.item[0], &face));
    assert_int_equal(face[0].nloops, 1);
    assert_int_equal(face[1].loop[0].n, 2);
    assert_true(face[1].loop[0].curve[0].back);
    ASSERT_OK(ctx, ix__mesh_of_faces(ctx, 2, face, 2e-4, NULL, &g));
    for (int f = 0; f < 2; f++)
        n[f] = edge_points(&g[f], p[f]);
    assert_true(n[0] > 40);
    assert_int_equal(n[0], n[1]);
    assert_memory_equal(p[0], p[1], n[0] * sizeof p[0][0]);
    for (int f = 0; f < 2; f++)
        ix__mesh_free(ctx, &g[f]);
    ix__obj_unref(ctx, o);
    ix__scratch_release(ctx, mk);
}

/* An edge of points in space, smaller end first. */
typedef struct {
    double a[3], b[3];
    int sense;
} space_edge;

static int by_space(const void *x, const void *y)
{
    const space_edge *p = x, *q = y;
    int c = memcmp(p->a, q->a, sizeof p->a);

    return c ? c : memcmp(p->b, q->b, sizeof p->b);
}

static space_edge edge_between(const double *a, const double *b)
{
    bool ahead = memcmp(a, b, 3 * sizeof *a) < 0;
    space_edge e = {.sense = ahead ? 1 : -1};

    memcpy(e.a, ahead ? a : b, sizeof e.a);
    memcpy(e.b, ahead ? b : a, sizeof e.b);
    return e;
}

/* Closed: each edge once in each sense; and the volume it encloses, from
 * outward triangles, is less than the can's by less than its area times the
 * tolerance. */
static void test_can(void **state)
{
    const double tol = .002, pi = acos(-1.);
    ix_mark mk = ix__scratch_mark(ctx);
    space_edge *e;
    ix__face *face;
    ix__mesh *g;
    size_t n = 0;
    double volume = 0;
    ix_obj *o;

    (void)state;
    ASSERT_OK(ctx, ix__itd_read(ctx, "t", CAN, strlen(CAN), &o));
    ASSERT_OK(ctx, ix__faces_of_model(ctx, o->u.model.item[0], &face));
    assert_true(face[1].reversed && !face[0].reversed && !face[2].reversed);
    ASSERT_OK(ctx, ix__mesh_of_faces(ctx, 3, face, tol, NULL, &g));
    e = malloc(3 * sizeof *e * (g[0].ntris + g[1].ntris + g[2].ntris));
    assert_non_null(e);
    for (int f = 0; f < 3; f++)
        for (size_t i = 0; i < g[f].ntris; i++) {
            const double *p[3];

            for (int k = 0; k < 3; k++)
                p[k] = g[f].xyz + 3 * g[f].tri[i][k];
            for (int k = 0; k < 3; k++) {
                e[n++] = edge_between(p[k], p[(k + 1) % 3]);
                volume += p[0][k] *
                          (p[1][(k + 1) % 3] * p[2][(k + 2) % 3] -
                           p[1][(k + 2) % 3] * p[2][(k + 1) % 3]) /
                          6;
            }
        }
    qsort(e, n, sizeof *e, by_space);
    for (size_t i = 0; i < n; i += 2) {
        assert_int_equal(by_space(&e[i], &e[i + 1]), 0);
        assert_int_equal(e[i].sense + e[i + 1].sense, 0);
        assert_true(i == 0 || by_space(&e[i - 1], &e[i]) != 0);
    }
    assert_true(volume <= 2 * pi && volume >= 2 * pi - 6 * pi * tol);
    free(e);
    for (int f = 0; f < 3; f++)
        ix__mesh_free(ctx, &g[f]);
    ix__obj_unref(ctx, o);
    ix__scratch_release(ctx, mk);
}

/* --- errors and allocations ------------------------------------------------
 */

static void test_errors(void **state)
{
    const double pole[8] = {1, -1, 0, 1, 0, 1, 0, 0};
    const ix_dir d = {IX_BEZIER, 2, 2, false, NULL};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_mv *m = random_surface(), *uv;
    ix_trimsrf *t = ix__trimsrf_new(ctx, m, 1);
    ix__face f;

    (void)state;
    assert_non_null(t);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, true, pole, &uv));
    ASSERT_OK(ctx, ix__trimloop_segs(ctx, &t->loop[0], 1));
    t->loop[0].seg[0].uv = uv;
    assert_int_equal(ix__face_of_trimsrf(ctx, t, &f), IX_EDOMAIN);
    ix_mv_unref(ctx, uv);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 1, false, pole, &uv));
    t->loop[0].seg[0].uv = uv;
    assert_int_equal(ix__face_of_trimsrf(ctx, t, &f), IX_EARG);
    ix__trimsrf_unref(ctx, t);
    ix_mv_unref(ctx, m);
    ix__scratch_release(ctx, mk);
}

typedef struct {
    ix_obj *o;
    ix__mesh g[2];
} inputs;

static void make(ix_ctx *c, void *state)
{
    inputs *in = state;
    char text[4000], net[2000];

    bicubic(net, sizeof net, 0);
    (void)snprintf(text, sizeof text, BENT, net);
    if (ix__itd_read(c, "t", text, strlen(text), &in->o) != IX_OK)
        in->o = NULL;
}

static ix_status work(ix_ctx *c, void *state)
{
    inputs *in = state;
    ix_mark mk = ix__scratch_mark(c);
    ix__face *face;
    ix__mesh *g;
    ix_status st = ix__faces_of_model(c, in->o->u.model.item[0], &face);

    if (st == IX_OK)
        st = ix__mesh_of_faces(c, 2, face, .02, NULL, &g);
    if (st == IX_OK)
        memcpy(in->g, g, sizeof in->g);
    ix__scratch_release(c, mk);
    return st;
}

static void drop(ix_ctx *c, void *state)
{
    inputs *in = state;

    for (int f = 0; f < 2; f++)
        ix__mesh_free(c, &in->g[f]);
    ix__obj_unref(c, in->o);
    *in = (inputs){0};
}

static void test_faults(void **state)
{
    inputs in = {0};
    const ix_fault_case c = {make, work, drop, &in};

    (void)state;
    assert_true(ix_fault_run(&c) >= 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_region),    cmocka_unit_test(test_holes),
        cmocka_unit_test(test_borders),   cmocka_unit_test(test_crossing),
        cmocka_unit_test(test_scribbles), cmocka_unit_test(test_outside),
        cmocka_unit_test(test_sphere),    cmocka_unit_test(test_model),
        cmocka_unit_test(test_can),       cmocka_unit_test(test_errors),
        cmocka_unit_test(test_faults),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
