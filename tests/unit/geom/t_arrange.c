/* Arrangements of curves, against Euler's formula, sums of areas, and windings
 * counted on dense samples of the curves themselves. */
#include <math.h>
#include <stdlib.h>

#include "base/ctx.h"
#include "geomtest.h"
#include "iritx/arrange.h"

enum { DENSE = 400 };

#define PI 3.14159265358979323846

/* A random curve: closed (ends equal) or open, of cubic or lower spans. */
static ix_mv *wild_curve(gt *t, bool closed, bool rational)
{
    int order = (int)ix_rng_range(&t->r, 2, 4.99), n = order + 3;
    int axes = rational ? 3 : 2;
    double pts[3 * 8], knots[16];
    ix_dir d = {IX_BSPLINE, order, n, false, knots};
    ix_mv *m;

    for (int i = 0; i < n; i++) {
        double w = rational ? ix_rng_range(&t->r, 0.5, 2) : 1;

        if (rational)
            pts[i] = i == n - 1 ? 1 : i ? w : 1;
        for (int k = 0; k < 2; k++)
            pts[i + (k + rational) * n] = ix_rng_range(&t->r, -1, 1) *
                                          (rational ? pts[i] : 1);
    }
    if (closed)
        for (int k = 0; k < axes; k++)
            pts[n - 1 + k * n] = pts[k * n];
    ASSERT_OK(t->ctx, ix_knots_make(t->ctx, IX_KV_OPEN, order, n, knots));
    ASSERT_OK(t->ctx, ix_mv_new(t->ctx, 1, &d, 2, rational, pts, &m));
    return m;
}

/* How often c turns around p, by the angles between dense samples; *near is
 * set if p is too near to tell. */
static int turns_around(gt *t, const ix_mv *c, const double p[2], bool *near)
{
    double dom[2], sum = 0, before[IX_MAX_COORDS] = {0}, x[IX_MAX_COORDS];

    ix_mv_domain(c, 0, dom);
    for (int i = 0; i <= DENSE; i++) {
        double u = i == DENSE ? dom[1] : dom[0] + (dom[1] - dom[0]) * i / DENSE;

        gt_point(t, c, &u, x);
        x[0] -= p[0];
        x[1] -= p[1];
        *near = *near || hypot(x[0], x[1]) < 0.03;
        if (i)
            sum += atan2(before[0] * x[1] - before[1] * x[0],
                         before[0] * x[0] + before[1] * x[1]);
        memcpy(before, x, sizeof before);
    }
    return (int)lround(sum / (2 * PI));
}

static int degree_sum(const ix_arrangement *a, int *vertices)
{
    int sum = 0;

    *vertices = 0;
    for (int v = 0; v < a->nvertices; v++) {
        sum += a->vertex[v].degree;
        *vertices += a->vertex[v].degree > 0;
    }
    return sum;
}

/* Law: V - E + F = 1 + C; every half edge is in one loop; the bounded faces and
 * the loops around the components have areas that add up to 0. */
static void check_subdivision(const ix_arrangement *a)
{
    int v, ends = degree_sum(a, &v);
    double inside = 0, around = 0;

    assert_true(a->evaluated);
    assert_int_equal(v - ends / 2 + a->nfaces, 1 + a->ncomponents);
    assert_int_equal(ends, a->nhalf);
    for (int f = 1; f < a->nfaces; f++) {
        assert_true(a->face[f].area > 0);
        inside += a->face[f].area;
    }
    for (int l = 0; l < a->nloops; l++)
        if (a->loop[l].face == 0)
            around -= a->loop[l].area;
    ASSERT_CLOSE(inside, around, 1e-9);
    for (int e = 0; e < a->nedges; e++)
        for (int k = 0; k < 2; k++)
            assert_true(a->edge[e].face[k] < a->nfaces);
}

/* Law: at any point the winding of its face is the sum of what the closed
 * curves turn around it. */
static int check_windings(gt *t, const ix_arrangement *a, int n,
                          ix_mv *const *crv, const bool *closed)
{
    int checked = 0;

    for (int i = 0; i < 40; i++) {
        double p[2] = {ix_rng_range(&t->r, -1, 1), ix_rng_range(&t->r, -1, 1)};
        int want = 0, face;
        bool near = false;

        for (int k = 0; k < n; k++)
            if (closed[k])
                want += turns_around(t, crv[k], p, &near);
        if (near)
            continue;
        ASSERT_OK(t->ctx, ix_arrangement_locate(t->ctx, a, p, &face));
        if (a->face[face].winding != want)
            fail_msg("(%g, %g) in face %d: winding %d, sampled %d", p[0], p[1],
                     face, a->face[face].winding, want);
        assert_true(a->face[face].depth >= abs(want));
        assert_true((a->face[face].depth == 0) == (face == 0));
        checked++;
    }
    return checked;
}

static void random_arrangements(void **state)
{
    gt t = gt_begin(1);
    int faces = 0, checked = 0;

    (void)state;
    for (int k = 0; k < 12; k++) {
        ix_mv *c[6];
        bool closed[6];
        ix_arrangement *a, *b;
        int n = 2 + k % 5, all;

        for (int i = 0; i < n; i++) {
            closed[i] = (i + k) % 3 != 0;
            c[i] = wild_curve(&t, closed[i], i % 2);
        }
        ASSERT_OK(t.ctx, ix_arrangement_new(t.ctx, n, (const ix_mv *const *)c,
                                            1e-6, &a));
        ASSERT_OK(t.ctx, ix_arrangement_split_meetings(t.ctx, a, 1e-7));
        ASSERT_OK(t.ctx, ix_arrangement_evaluate(t.ctx, a, false));
        check_subdivision(a);
        all = a->nfaces;
        ASSERT_OK(t.ctx, ix_arrangement_classify(t.ctx, a));
        checked += check_windings(&t, a, n, c, closed);
        faces += all;
        ASSERT_OK(t.ctx, ix_arrangement_copy(t.ctx, a, &b));
        assert_false(b->evaluated);
        ASSERT_OK(t.ctx, ix_arrangement_evaluate(t.ctx, b, true));
        check_subdivision(b);
        assert_int_equal(b->nfaces, all); /* hanging edges bound nothing new */
        for (int v = 0; v < b->nvertices; v++)
            assert_int_not_equal(b->vertex[v].degree, 1);
        ix_arrangement_free(t.ctx, b);
        ix_arrangement_free(t.ctx, a);
        for (int i = 0; i < n; i++)
            ix_mv_unref(t.ctx, c[i]);
    }
    assert_true(faces > 100 && checked > 150);
    gt_end(&t);
}

static ix_mv *circle_at(gt *t, double x, double y, double r)
{
    const double at[3] = {x, y, 0};
    ix_mv *c;

    ASSERT_OK(t->ctx, ix_circle(t->ctx, at, r, &c));
    return c;
}

static ix_arrangement *circles(gt *t, int n, const double (*c)[3])
{
    ix_arrangement *a;
    ix_mv *m[8] = {NULL};

    for (int i = 0; i < n; i++)
        m[i] = circle_at(t, c[i][0], c[i][1], c[i][2]);
    ASSERT_OK(t->ctx,
              ix_arrangement_new(t->ctx, n, (const ix_mv *const *)m, 1e-6, &a));
    for (int i = 0; i < n; i++)
        ix_mv_unref(t->ctx, m[i]);
    return a;
}

/* Two unit circles whose centres are d apart: the lens has the area
 * 2 acos(d/2) - d sqrt(1 - d^2/4). */
static void a_lens(void **state)
{
    const double c[2][3] = {{0, 0, 1}, {1, 0, 1}}, in[2] = {0.5, 0};
    gt t = gt_begin(2);
    ix_arrangement *a = circles(&t, 2, c);
    int f;

    (void)state;
    ASSERT_OK(t.ctx, ix_arrangement_split_meetings(t.ctx, a, 1e-7));
    ASSERT_OK(t.ctx, ix_arrangement_classify(t.ctx, a));
    check_subdivision(a);
    assert_int_equal(a->nfaces, 4);
    ASSERT_OK(t.ctx, ix_arrangement_locate(t.ctx, a, in, &f));
    assert_int_equal(a->face[f].winding, 2);
    ASSERT_CLOSE(a->face[f].area, 2 * acos(0.5) - sqrt(0.75), 1e-11);
    ix_arrangement_free(t.ctx, a);
    gt_end(&t);
}

/* Circles that nearly touch, far from the origin, one of them cut beside a
 * knot: edges and spans of 3e-5 and less, whose derivatives are known to few
 * digits, are measured in no time. */
static void slivers(void **state)
{
    const double gap[3] = {1e-9, 1e-11, 1e-12};
    gt t = gt_begin(8);

    (void)state;
    for (int k = 0; k < 3; k++) {
        const double c[2][3] = {{5, 7, 1}, {7 - gap[k], 7, 1}};
        const double in[2] = {5, 7}, beside = 1 + gap[k];
        ix_arrangement *a = circles(&t, 2, c);
        int f;

        ASSERT_OK(t.ctx, ix_arrangement_split(t.ctx, a, 0, 1, &beside, 0));
        assert_int_equal(a->nedges, 3);
        ASSERT_OK(t.ctx, ix_arrangement_split_meetings(t.ctx, a, 1e-8));
        ASSERT_OK(t.ctx, ix_arrangement_classify(t.ctx, a));
        ASSERT_OK(t.ctx, ix_arrangement_locate(t.ctx, a, in, &f));
        ASSERT_CLOSE(a->face[f].area, PI, 1e-9);
        ix_arrangement_free(t.ctx, a);
    }
    gt_end(&t);
}

/* Touching circles: tangent curves leave their vertex in the right order. Rings
 * in rings: holes and parents. */
static void touching_and_nested(void **state)
{
    const double c[5][3] = {
        {0, 0, 4}, {-2, 0, 2}, {-1, 0, 1}, {2.5, 0, 1}, {2.5, 0, 0.5}};
    const double in[5][2] = {{0, 3}, {-3.5, 0}, {-1, 0}, {2.5, 0.75}, {2.5, 0}};
    const double area[5] = {16 - 4 - 1, 4 - 1, 1, 1 - 0.25, 0.25};
    const int depth[5] = {1, 2, 3, 2, 3};
    gt t = gt_begin(3);
    ix_arrangement *a = circles(&t, 5, c);
    int f, up;

    (void)state;
    ASSERT_OK(t.ctx, ix_arrangement_split_meetings(t.ctx, a, 1e-5));
    ASSERT_OK(t.ctx, ix_arrangement_classify(t.ctx, a));
    check_subdivision(a);
    assert_int_equal(a->nfaces, 6);
    assert_int_equal(a->ncomponents, 3);
    for (int i = 0; i < 5; i++) {
        ASSERT_OK(t.ctx, ix_arrangement_locate(t.ctx, a, in[i], &f));
        ASSERT_CLOSE(a->face[f].area, PI * area[i], 1e-6);
        assert_int_equal(a->face[f].depth, depth[i]);
        assert_int_equal(a->face[f].winding, depth[i]);
    }
    ASSERT_OK(t.ctx, ix_arrangement_locate(t.ctx, a, in[3], &up));
    assert_int_equal(a->face[f].parent, up);
    ix_arrangement_free(t.ctx, a);
    gt_end(&t);
}

/* Copies, one of them reversed, count as turns; a part that runs along another
 * curve is cut out. */
static void copies_and_overlaps(void **state)
{
    const double c[3][3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, in[2] = {0, 0};
    const double lines[2][4] = {{0, 3, 0, 0}, {1, 5, 0, 0}};
    gt t = gt_begin(4);
    ix_arrangement *a = circles(&t, 3, c);
    ix_mv *m[3];
    int f;

    (void)state;
    ASSERT_OK(t.ctx, ix_arrangement_drop_copies(t.ctx, a, 1e-9));
    assert_int_equal(a->nedges, 1);
    assert_int_equal(a->edge[0].turns, 3);
    ASSERT_OK(t.ctx, ix_arrangement_classify(t.ctx, a));
    ASSERT_OK(t.ctx, ix_arrangement_locate(t.ctx, a, in, &f));
    assert_int_equal(a->face[f].winding, 3);
    ix_arrangement_free(t.ctx, a);

    m[0] = circle_at(&t, 0, 0, 1);
    ASSERT_OK(t.ctx, ix_mv_reverse(t.ctx, m[0], 0, &m[1]));
    ASSERT_OK(t.ctx,
              ix_arrangement_new(t.ctx, 2, (const ix_mv *const *)m, 1e-6, &a));
    ASSERT_OK(t.ctx, ix_arrangement_drop_copies(t.ctx, a, 1e-9));
    assert_int_equal(a->nedges, 1);
    assert_int_equal(a->edge[0].turns, 0);
    ix_arrangement_free(t.ctx, a);
    for (int i = 0; i < 2; i++) {
        ix_mv_unref(t.ctx, m[i]);
        m[i] = gt_curve(&t, 2, 2, NULL, 2, false, lines[i]);
    }
    ASSERT_OK(t.ctx,
              ix_arrangement_new(t.ctx, 2, (const ix_mv *const *)m, 1e-6, &a));
    ASSERT_OK(t.ctx, ix_arrangement_split_meetings(t.ctx, a, 1e-7));
    assert_int_equal(a->nedges, 4);
    assert_int_equal(ix_arrangement_evaluate(t.ctx, a, false), IX_EUNABLE);
    ASSERT_OK(t.ctx, ix_arrangement_drop_overlaps(t.ctx, a, 1e-7));
    assert_int_equal(a->nedges, 3); /* 0 .. 1 .. 3 .. 5 */
    ASSERT_OK(t.ctx, ix_arrangement_evaluate(t.ctx, a, false));
    assert_int_equal(a->nfaces, 1);
    ASSERT_OK(t.ctx, ix_arrangement_merge(t.ctx, a, 0.01));
    assert_int_equal(a->nedges, 1);
    ix_arrangement_free(t.ctx, a);
    for (int i = 0; i < 2; i++)
        ix_mv_unref(t.ctx, m[i]);
    gt_end(&t);
}

/* Law: merging what was cut gives the same faces, from fewer curves; so does
 * fitting within a small tolerance. */
static void merged_and_fitted(void **state)
{
    const double c[3][3] = {{0, 0, 1}, {1, 0.2, 1}, {0.4, 1, 0.9}};
    const double near[2][3] = {{1, 1.201, 5}, {9, 9, 9}};
    gt t = gt_begin(5);
    ix_arrangement *a = circles(&t, 3, c);
    double want = 0, got = 0;
    int cut, faces;

    (void)state;
    ASSERT_OK(t.ctx, ix_arrangement_split_meetings(t.ctx, a, 1e-7));
    cut = a->nedges;
    ASSERT_OK(t.ctx, ix_arrangement_split_near(t.ctx, a, 2, near, 0.01));
    assert_int_equal(a->nedges, cut + 1);
    ASSERT_OK(t.ctx, ix_arrangement_evaluate(t.ctx, a, true));
    faces = a->nfaces;
    for (int f = 1; f < faces; f++)
        want += a->face[f].area * a->face[f].area;
    ASSERT_OK(t.ctx, ix_arrangement_merge(t.ctx, a, 0.1));
    assert_false(a->evaluated);
    assert_int_equal(a->nedges, 12); /* 6 crossings of degree 4 */
    ASSERT_OK(t.ctx, ix_arrangement_fit(t.ctx, a, 1e-8, 4));
    for (int e = 0; e < a->nedges; e++) {
        assert_false(ix_mv_rational(a->edge[e].crv));
        assert_int_equal(ix_mv_order(a->edge[e].crv, 0), 4);
    }
    ASSERT_OK(t.ctx, ix_arrangement_evaluate(t.ctx, a, true));
    check_subdivision(a);
    assert_int_equal(a->nfaces, faces);
    for (int f = 1; f < faces; f++)
        got += a->face[f].area * a->face[f].area;
    ASSERT_CLOSE(got, want, 1e-6);
    ix_arrangement_free(t.ctx, a);
    gt_end(&t);
}

/* A square of four lines with a hanging one: corners, T, loops as curves. */
static void corners_and_hanging(void **state)
{
    const double sq[10] = {0, 2, 2, 0, 0, 0, 0, 2, 2, 0};
    const double kv[7] = {0, 0, 1, 2, 3, 4, 4}, stick[4] = {1, 1, 0, 1};
    gt t = gt_begin(6);
    ix_arrangement *a;
    ix_mv *m[2], *c;
    int where;

    (void)state;
    m[0] = gt_curve(&t, 2, 5, kv, 2, false, sq);
    m[1] = gt_curve(&t, 2, 2, NULL, 2, false, stick);
    ASSERT_OK(t.ctx,
              ix_arrangement_new(t.ctx, 2, (const ix_mv *const *)m, 1e-6, &a));
    ASSERT_OK(t.ctx, ix_arrangement_split_corners(t.ctx, a, 0.5));
    assert_int_equal(a->nedges, 5);
    ASSERT_OK(t.ctx, ix_arrangement_split_meetings(t.ctx, a, 1e-7));
    assert_int_equal(a->nedges, 6);
    ASSERT_OK(t.ctx, ix_arrangement_evaluate(t.ctx, a, false));
    check_subdivision(a);
    assert_int_equal(a->nfaces, 2);
    ASSERT_CLOSE(a->face[1].area, 4, 1e-12);
    assert_int_equal(a->loop[a->face[1].outer].n, 7);
    ASSERT_OK(t.ctx, ix_arrangement_evaluate(t.ctx, a, true));
    assert_int_equal(a->loop[a->face[1].outer].n, 5);
    ASSERT_OK(t.ctx, ix_arrangement_loop_curve(t.ctx, a, a->face[1].outer, &c));
    ix_mv_unref(t.ctx, c);
    ASSERT_OK(t.ctx, ix_arrangement_locate(t.ctx, a, (double[]){1, 1}, &where));
    assert_int_equal(where, 1);
    ASSERT_OK(t.ctx, ix_arrangement_locate(t.ctx, a, (double[]){3, 1}, &where));
    assert_int_equal(where, 0);
    ix_arrangement_free(t.ctx, a);
    ix_mv_unref(t.ctx, m[0]);
    ix_mv_unref(t.ctx, m[1]);
    gt_end(&t);
}

static void errors(void **state)
{
    const double c[1][3] = {{0, 0, 1}}, pole[6] = {1, -1, 0, -1, 0, 0};
    const double line[2] = {0, 1}, p[2] = {0, 0};
    gt t = gt_begin(7);
    ix_mv *scalar = gt_curve(&t, 2, 2, NULL, 1, false, line), *out;
    ix_mv *bad = gt_curve(&t, 2, 2, NULL, 2, true, pole);
    ix_arrangement *a, *b;
    const ix_mv *in = scalar;
    double far = 9;
    int f;

    (void)state;
    assert_int_equal(ix_arrangement_new(t.ctx, 1, &in, 1e-3, &b), IX_EARG);
    in = bad;
    assert_int_equal(ix_arrangement_new(t.ctx, 1, &in, 1e-3, &b), IX_EDOMAIN);
    assert_int_equal(ix_arrangement_new(t.ctx, 0, NULL, 0, &b), IX_EARG);
    assert_null(b);
    a = circles(&t, 1, c);
    assert_int_equal(ix_arrangement_drop_copies(t.ctx, a, -1), IX_EARG);
    assert_int_equal(ix_arrangement_drop_overlaps(t.ctx, a, 0), IX_EARG);
    assert_int_equal(ix_arrangement_split(t.ctx, a, 1, 0, NULL, 0), IX_EARG);
    assert_int_equal(ix_arrangement_split(t.ctx, a, 0, 1, &far, 0), IX_EARG);
    assert_int_equal(ix_arrangement_split_corners(t.ctx, a, NAN), IX_EARG);
    assert_int_equal(ix_arrangement_split_meetings(t.ctx, a, NAN), IX_EARG);
    assert_int_equal(ix_arrangement_split_near(t.ctx, a, 0, NULL, -1), IX_EARG);
    assert_int_equal(ix_arrangement_merge(t.ctx, a, -1), IX_EARG);
    assert_int_equal(ix_arrangement_fit(t.ctx, a, 0, 4), IX_EARG);
    assert_int_equal(ix_arrangement_fit(t.ctx, a, 1e-3, 1), IX_EARG);
    assert_int_equal(ix_arrangement_fit(t.ctx, a, 1e-16, 3), IX_EUNABLE);
    assert_int_equal(a->nedges, 1);
    assert_int_equal(ix_arrangement_locate(t.ctx, a, p, &f), IX_EARG);
    assert_int_equal(ix_arrangement_loop_curve(t.ctx, a, 0, &out), IX_EARG);
    ASSERT_OK(t.ctx, ix_arrangement_evaluate(t.ctx, a, false));
    assert_int_equal(ix_arrangement_loop_curve(t.ctx, a, 9, &out), IX_EARG);
    ix_arrangement_free(t.ctx, a);
    ix_mv_unref(t.ctx, scalar);
    ix_mv_unref(t.ctx, bad);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double p[6] = {-1, 0, 1, 0, 1, 0}, q[4] = {-1, 1, 0.25, 0.25};
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 3, .length = 3},
                         {.basis = IX_BEZIER, .order = 2, .length = 2}};

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d[0], 2, false, p, &f->in[0]));
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d[1], 2, false, q, &f->in[1]));
}

static ix_status steps(ix_ctx *ctx, ix_arrangement *a, ix_mv **out)
{
    ix_arrangement *b;

    IX_TRY(ix_arrangement_split_meetings(ctx, a, 1e-6));
    IX_TRY(ix_arrangement_drop_copies(ctx, a, 1e-6));
    IX_TRY(ix_arrangement_classify(ctx, a));
    IX_TRY(ix_arrangement_loop_curve(ctx, a, 0, out));
    ix_mv_unref(ctx, *out);
    *out = NULL;
    IX_TRY(ix_arrangement_merge(ctx, a, 4));
    IX_TRY(ix_arrangement_fit(ctx, a, 0.5, 2));
    IX_TRY(ix_arrangement_copy(ctx, a, &b));
    *out = ix_mv_ref(b->edge[0].crv);
    ix_arrangement_free(ctx, b);
    return IX_OK;
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    ix_arrangement *a;
    ix_status st;

    IX_TRY(ix_arrangement_new(ctx, 2, (const ix_mv *const *)f->in, 1e-6, &a));
    st = steps(ctx, a, out);
    ix_arrangement_free(ctx, a);
    return st;
}

static void memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_arrangements),
        cmocka_unit_test(a_lens),
        cmocka_unit_test(slivers),
        cmocka_unit_test(touching_and_nested),
        cmocka_unit_test(copies_and_overlaps),
        cmocka_unit_test(merged_and_fitted),
        cmocka_unit_test(corners_and_hanging),
        cmocka_unit_test(errors),
        cmocka_unit_test(memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
