/* The medial axis of regions with curved borders: its circles are inside and
 * touch twice, its topology is that of the region, and each largest circle is
 * on it. */
#include "harness/fault.h"
#include "iritx/distance.h"
#include "plane_test.h"

/* A closed cubic B-spline around the origin, C2, through no symmetric shape: n
 * spans, radius 1 + wave. */
static ix_mv *blob(ix_ctx *ctx, int n, double size, double wave, double seed)
{
    double kv[2 * 128 + 8], pts[2 * 128];
    ix_dir d = {IX_BSPLINE, 4, n, true, kv};
    ix_mv *m;

    for (int i = 0; i < n + 7; i++)
        kv[i] = i - 3;
    for (int i = 0; i < n; i++) {
        double a = 2 * 3.14159265358979323846 * i / n;
        double r = size * (1 + wave * sin(3 * a + seed) +
                           0.7 * wave * sin(7 * a + 2 * seed));

        pts[i] = r * cos(a);
        pts[n + i] = r * sin(a);
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d, 2, false, pts, &m));
    return m;
}

static ix_mv *polygon(ix_ctx *ctx, int n, const double (*p)[2])
{
    double kv[40], pts[40];

    for (int i = 0; i <= n; i++) {
        kv[i + 1] = i;
        pts[i] = p[i % n][0];
        pts[n + 1 + i] = p[i % n][1];
    }
    kv[0] = 0;
    kv[n + 2] = n;
    return make_crv(ctx, 2, n + 1, kv, false, 2, pts);
}

/* Law: the vertices' radius is the distance from the border (1e-11 of the size:
 * brute force), the centre is inside; the graph is connected if E - V + 1 is
 * the number of holes. */
static void check(ix_ctx *ctx, int n, const ix_mv *const *c, int holes,
                  ix_medial_axis *m)
{
    brute b = brute_of(ctx, n, c);
    int ends = 0;

    ASSERT_OK(ctx, ix_medial_axis_of(ctx, n, c, 0, m));
    for (int i = 0; i < m->nbranches; i++)
        for (int j = 0; j < m->branch[i].n; j += 5) {
            const double *x = m->branch[i].x + 3 * j;
            double d = brute_distance(ctx, &b, x, true);

            if (!(fabs(d - x[2]) <= 1e-11 * m->size))
                fail_msg("branch %d: (%g, %g): %.15g, distance %.15g", i, x[0],
                         x[1], x[2], d);
        }
    for (int i = 0; i < m->nnodes; i++)
        ends += m->node[i].degree;
    assert_int_equal(ends, 2 * m->nbranches);
    if (m->nbranches - m->nnodes + 1 != holes)
        fail_msg("%d branches, %d nodes, %d holes", m->nbranches, m->nnodes,
                 holes);
    free(b.x);
}

static int nodes_of_degree(const ix_medial_axis *m, int degree)
{
    int n = 0;

    for (int i = 0; i < m->nnodes; i++)
        n += m->node[i].degree == degree;
    return n;
}

static double off_axis(const ix_medial_axis *m, const double *q)
{
    double best = INFINITY;

    for (int i = 0; i < m->nbranches; i++)
        for (int j = 0; j + 1 < m->branch[i].n; j++) {
            const double *p = m->branch[i].x + 3 * j;
            double d[2] = {p[3] - p[0], p[4] - p[1]};
            double e[2] = {q[0] - p[0], q[1] - p[1]};
            double l = d[0] * d[0] + d[1] * d[1], t = 0;

            if (l > 0)
                t = fmin(fmax((d[0] * e[0] + d[1] * e[1]) / l, 0), 1);
            best = fmin(best, hypot(e[0] - t * d[0], e[1] - t * d[1]));
        }
    return best;
}

/* Law: the centre of the largest circle inside that touches at any place of the
 * border is on the axis: found by halving the radius, with brute force. side:
 * that of the region. */
static void complete(ix_ctx *ctx, ix_rng *r, int n, const ix_mv *const *c,
                     const int *side, const ix_medial_axis *m, int count)
{
    brute b = brute_of(ctx, n, c);

    for (int i = 0; i < count; i++) {
        int k = ix_rng_int(r, 0, n - 1);
        double dom[2], d[4], lo = 0, hi = 4, x[2];

        ix_mv_domain(c[k], 0, dom);
        ASSERT_OK(ctx, ix_mv_curve_derivs(
                           ctx, c[k], ix_rng_range(r, dom[0], dom[1]), 1, d));
        for (int j = 0; j < 30; j++) {
            double rad = 0.5 * (lo + hi), l = hypot(d[2], d[3]);

            x[0] = d[0] - side[k] * rad * d[3] / l;
            x[1] = d[1] + side[k] * rad * d[2] / l;
            /* the samples are 1e-3 apart: circles seem free up to 1e-6 */
            if (brute_distance(ctx, &b, x, true) < rad - 1e-10)
                hi = rad;
            else
                lo = rad;
        }
        /* where the circle nearly is that of curvature the centre is known to
           the cube root of 1e-10 */
        if (!(off_axis(m, x) <= 2e-3))
            fail_msg("(%g, %g), radius %g: %g off the axis", x[0], x[1], lo,
                     off_axis(m, x));
    }
    free(b.x);
}

/* --- closed forms ----------------------------------------------------------
 */

static void rectangle(void **state)
{
    static const double p[4][2] = {{0, 0}, {3, 0}, {3, 1}, {0, 1}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const ix_mv *c[1] = {polygon(ctx, 4, p)};
    ix_medial_axis m;

    (void)state;
    check(ctx, 1, c, 0, &m);
    assert_int_equal(m.nbranches, 5);
    assert_int_equal(nodes_of_degree(&m, 1), 4);
    assert_int_equal(nodes_of_degree(&m, 3), 2);
    for (int i = 0; i < m.nnodes; i++)
        if (m.node[i].degree == 3) {
            ASSERT_CLOSE(m.node[i].x[1], 0.5, 1e-12);
            ASSERT_CLOSE(fabs(m.node[i].x[0] - 1.5), 1, 1e-12);
            ASSERT_CLOSE(m.node[i].r, 0.5, 1e-12);
        }
    ix_medial_axis_free(ctx, &m);
    ix_mv_unref(ctx, c[0]);
    ix_ctx_free(ctx);
}

/* Semi-axes 2 and 1: the segment between the centres of curvature at the
 * vertices, (+-3/2, 0). */
static void ellipse(void **state)
{
    const double o[3] = {0, 0, 0};
    const double stretch[16] = {2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *circle, *e;
    const ix_mv *c[1];
    ix_medial_axis m;

    (void)state;
    ASSERT_OK(ctx, ix_circle(ctx, o, 1, &circle));
    ASSERT_OK(ctx, ix_mv_transform(ctx, circle, stretch, &e));
    c[0] = e;
    check(ctx, 1, c, 0, &m);
    assert_int_equal(m.nbranches, 1);
    for (int i = 0; i < 2; i++) {
        ASSERT_CLOSE(fabs(m.node[i].x[0]), 1.5, 1e-8);
        ASSERT_CLOSE(m.node[i].r, 0.5, 1e-8);
    }
    for (int j = 0; j < m.branch[0].n; j++)
        assert_true(fabs(m.branch[0].x[3 * j + 1]) <= 1e-9);
    ix_medial_axis_free(ctx, &m);
    /* a circle: its centre */
    c[0] = circle;
    ASSERT_OK(ctx, ix_medial_axis_of(ctx, 1, c, 0, &m));
    assert_int_equal(m.nbranches, 0);
    assert_int_equal(m.nnodes, 1);
    assert_true(hypot(m.node[0].x[0], m.node[0].x[1]) <= 1e-12);
    ix_medial_axis_free(ctx, &m);
    ix_mv_unref(ctx, circle);
    ix_mv_unref(ctx, e);
    ix_ctx_free(ctx);
}

/* Reflex corners: the branch in the corner of an L is a parabola's arc between
 * two straight ones. */
static void l_shape(void **state)
{
    static const double p[6][2] = {{0, 0}, {3, 0}, {3, 1},
                                   {1, 1}, {1, 3}, {0, 3}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const ix_mv *c[1] = {polygon(ctx, 6, p)};
    ix_medial_axis m;
    int points = 0;

    (void)state;
    check(ctx, 1, c, 0, &m);
    assert_int_equal(nodes_of_degree(&m, 1), 5); /* the convex corners */
    for (int i = 0; i < m.nbranches; i++)
        points += m.branch[i].point[0] || m.branch[i].point[1];
    assert_true(points >= 2);
    ix_medial_axis_free(ctx, &m);
    ix_mv_unref(ctx, c[0]);
    ix_ctx_free(ctx);
}

/* Where two reflex corners are opposite each other both feet change from corner
 * to side in one point: one node of degree 2, no branch from it to itself. */
static void comb(void **state)
{
    static const double p[12][2] = {{0, 0}, {5, 0}, {5, 3}, {4, 3},
                                    {4, 1}, {3, 1}, {3, 4}, {2, 4},
                                    {2, 1}, {1, 1}, {1, 4}, {0, 4}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const ix_mv *c[1] = {polygon(ctx, 12, p)};
    ix_medial_axis m;

    (void)state;
    check(ctx, 1, c, 0, &m);
    assert_int_equal(nodes_of_degree(&m, 1), 8);
    assert_int_equal(nodes_of_degree(&m, 3), 6);
    for (int i = 0; i < m.nbranches; i++)
        assert_true(m.branch[i].node[0] != m.branch[i].node[1]);
    ix_medial_axis_free(ctx, &m);
    ix_mv_unref(ctx, c[0]);
    ix_ctx_free(ctx);
}

/* A corner of 0.5 degrees less than straight is a corner: a branch ends there.
 */
static void shallow(void **state)
{
    static const double p[5][2] = {
        {0, 0}, {3, 0}, {3.002, 0.5}, {3, 1}, {0, 1}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const ix_mv *c[1] = {polygon(ctx, 5, p)};
    ix_medial_axis m;
    int found = 0;

    (void)state;
    check(ctx, 1, c, 0, &m);
    assert_int_equal(nodes_of_degree(&m, 1), 5);
    for (int i = 0; i < m.nnodes; i++)
        found += hypot(m.node[i].x[0] - 3.002, m.node[i].x[1] - 0.5) <= 1e-8 &&
                 m.node[i].r <= 1e-8;
    assert_int_equal(found, 1);
    ix_medial_axis_free(ctx, &m);
    ix_mv_unref(ctx, c[0]);
    ix_ctx_free(ctx);
}

/* A rectangle with round corners that begins with one of them: the feet of one
 * branch come to the curve's beginning and to its end. The arcs have one circle
 * each: branches end in their centres. */
static void round_corners(void **state)
{
    static const double c[4][2] = {{2, 1}, {-2, 1}, {-2, -1}, {2, -1}};
    static const double q[5][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
    const double h = 0.70710678118654752440;
    double pts[3][17], kv[20];
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const ix_mv *list[1];
    ix_medial_axis m;

    (void)state;
    for (int i = 0; i < 17; i++) {
        int k = i / 4 % 4, l = i == 16 ? 0 : i % 4;
        double w = l == 1 ? h : 1, x[2];

        for (int j = 0; j < 2; j++)
            x[j] = l < 3 ? c[k][j] + (l < 2 ? q[k][j] : 0) * 0.5 +
                               (l > 0 ? q[k + 1][j] : 0) * 0.5
                         : 0.5 * (c[k][j] + c[(k + 1) % 4][j] + q[k + 1][j]);
        pts[0][i] = w;
        pts[1][i] = w * x[0];
        pts[2][i] = w * x[1];
    }
    for (int i = 0; i < 20; i++)
        kv[i] = i < 3 ? 0 : i > 16 ? 8 : (i - 1) / 2;
    list[0] = make_crv(ctx, 3, 17, kv, true, 2, &pts[0][0]);
    check(ctx, 1, list, 0, &m);
    assert_int_equal(m.nbranches, 5);
    assert_int_equal(nodes_of_degree(&m, 1), 4);
    for (int i = 0; i < m.nnodes; i++) {
        const ix_medial_node *n = &m.node[i];
        bool end = n->degree == 1;

        ASSERT_CLOSE(fabs(n->x[0]), end ? 2 : 1, 1e-9);
        ASSERT_CLOSE(fabs(n->x[1]), end ? 1 : 0, 1e-9);
        ASSERT_CLOSE(n->r, end ? 0.5 : 1.5, 1e-9);
    }
    ix_medial_axis_free(ctx, &m);
    ix_mv_unref(ctx, list[0]);
    ix_ctx_free(ctx);
}

/* Circles in a circle: one hole in the middle, two, three. */
static void holes(void **state)
{
    static const double at[4][3] = {
        {0, 0, 0}, {1.1, 0.2, 0}, {-0.9, 0.8, 0}, {-0.2, -1.2, 0}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const ix_mv *c[4];
    ix_mv *own[4];

    (void)state;
    for (int i = 0; i < 4; i++) {
        ASSERT_OK(ctx, ix_circle(ctx, at[i], i ? 0.3 + 0.1 * i : 3, &own[i]));
        c[i] = own[i];
    }
    for (int n = 2; n <= 4; n++) {
        ix_medial_axis m;

        check(ctx, n, c, n - 1, &m);
        ix_medial_axis_free(ctx, &m);
    }
    for (int i = 0; i < 4; i++)
        ix_mv_unref(ctx, own[i]);
    ix_ctx_free(ctx);
}

/* Free forms, with and without a hole. */
static void free_forms(void **state)
{
    static const int side[2] = {1, -1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(731);

    (void)state;
    for (int i = 0; i < 4; i++) {
        ix_mv *own[2] = {blob(ctx, 12 + 3 * i, 1, 0.25, 0.4 + i),
                         blob(ctx, 8, 0.3, 0.1, i)};
        const ix_mv *c[2] = {own[0], own[1]};
        int n = 1 + i % 2;
        ix_medial_axis m;

        check(ctx, n, c, n - 1, &m);
        complete(ctx, &r, n, c, side, &m, 5);
        ix_medial_axis_free(ctx, &m);
        ix_mv_unref(ctx, own[0]);
        ix_mv_unref(ctx, own[1]);
    }
    ix_ctx_free(ctx);
}

/* --- errors ----------------------------------------------------------------
 */

static void errors(void **state)
{
    static const double pts[6] = {0, 1, 2, 0, 1, 0};
    static const double p[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *open = make_crv(ctx, 3, 3, NULL, false, 2, pts);
    ix_mv *tri = polygon(ctx, 3, p);
    const ix_mv *c[2] = {open, tri};
    ix_medial_axis m;

    (void)state;
    assert_int_equal(ix_medial_axis_of(ctx, 1, c, 0, &m), IX_EARG);
    assert_int_equal(ix_medial_axis_of(ctx, 0, c, 0, &m), IX_EARG);
    assert_int_equal(ix_medial_axis_of(ctx, 1, c + 1, -1, &m), IX_EARG);
    ix_mv_unref(ctx, open);
    ix_mv_unref(ctx, tri);
    ix_ctx_free(ctx);
}

typedef struct {
    ix_mv *c;
    ix_medial_axis m;
} fault_state;

static void fault_setup(ix_ctx *ctx, void *state)
{
    static const double p[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    fault_state *s = state;

    *s = (fault_state){.c = polygon(ctx, 3, p)};
}

static ix_status fault_call(ix_ctx *ctx, void *state)
{
    fault_state *s = state;
    const ix_mv *const c[1] = {s->c};

    return ix_medial_axis_of(ctx, 1, c, 0.1, &s->m);
}

static void fault_teardown(ix_ctx *ctx, void *state)
{
    fault_state *s = state;

    ix_medial_axis_free(ctx, &s->m);
    ix_mv_unref(ctx, s->c);
    *s = (fault_state){0};
}

static void no_memory(void **state)
{
    fault_state s = {0};
    ix_fault_case c = {fault_setup, fault_call, fault_teardown, &s};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rectangle), cmocka_unit_test(ellipse),
        cmocka_unit_test(l_shape),   cmocka_unit_test(comb),
        cmocka_unit_test(shallow),   cmocka_unit_test(round_corners),
        cmocka_unit_test(holes),     cmocka_unit_test(free_forms),
        cmocka_unit_test(errors),    cmocka_unit_test(no_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
