/* Tilings by quadrilaterals: whole sides in common, no corner turned inside
 * out, areas that add up, sides that follow their curves. */
#include <math.h>
#include <stdlib.h>

#include "geomtest.h"
#include "iritx/tile.h"

#define PI 3.14159265358979323846

static double corner_area(const ix_quads *q, int i, int k)
{
    const double *a = q->p[q->quad[i].v[(k + 3) % 4]],
                 *b = q->p[q->quad[i].v[k]];
    const double *c = q->p[q->quad[i].v[(k + 1) % 4]];

    return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
}

/* Area between the chord of a side and its curve, to the right of the chord:
 * fine samples. */
static double bulge(gt *t, const ix_mv *c, const double *r)
{
    double a[IX_MAX_COORDS], p[IX_MAX_COORDS], x[IX_MAX_COORDS], sum = 0;

    gt_point(t, c, &r[0], a);
    memcpy(p, a, sizeof p);
    for (int i = 1; i <= 64; i++) {
        double u = r[0] + (r[1] - r[0]) * i / 64;

        gt_point(t, c, &u, x);
        sum += ((p[0] - a[0]) * (x[1] - a[1]) - (p[1] - a[1]) * (x[0] - a[0])) /
               2;
        memcpy(p, x, sizeof p);
    }
    return sum;
}

typedef struct {
    int a, b, seen;
} edge;

static int by_ends(const void *x, const void *y)
{
    const edge *p = x, *q = y;

    return p->a != q->a ? (p->a > q->a) - (p->a < q->a)
                        : (p->b > q->b) - (p->b < q->b);
}

/* Law: V - E + F = 1 - holes, where each side is in two quads, or in one and
 * then on a curve; every corner is counter-clockwise; areas with what curves
 * add make up `area`. */
static void check(gt *t, const ix_quads *q, ix_mv *const *c, int holes,
                  double area)
{
    edge *e = calloc((size_t)q->nquads * 4, sizeof *e);
    int edges = 0;
    double sum = 0;

    for (int i = 0; i < q->nquads; i++)
        for (int k = 0; k < 4; k++) {
            int a = q->quad[i].v[k], b = q->quad[i].v[(k + 1) % 4];
            int crv = q->quad[i].crv[k];
            double x[IX_MAX_COORDS];

            assert_true(corner_area(q, i, k) > 0);
            sum += corner_area(q, i, k) / 4;
            e[4 * i + k] = (edge){a < b ? a : b, a < b ? b : a, crv >= 0};
            if (crv < 0)
                continue;
            sum += bulge(t, c[crv], q->quad[i].t[k]);
            for (int end = 0; end < 2; end++) {
                gt_point(t, c[crv], &q->quad[i].t[k][end], x);
                gt_same(x, q->p[end ? b : a], 2, 1e-12);
            }
        }
    qsort(e, (size_t)q->nquads * 4, sizeof *e, by_ends);
    for (int i = 0; i < 4 * q->nquads; edges++) {
        int n = 1;

        while (i + n < 4 * q->nquads && by_ends(&e[i], &e[i + n]) == 0)
            n++;
        assert_int_equal(n, e[i].seen ? 1 : 2);
        i += n;
    }
    assert_int_equal(q->npts - edges + q->nquads, 1 - holes);
    ASSERT_CLOSE(sum, area, 1e-4 * area);
    free(e);
}

static ix_mv *circle_at(gt *t, double x, double r)
{
    const double at[3] = {x, 0, 0};
    ix_mv *c;

    ASSERT_OK(t->ctx, ix_circle(t->ctx, at, r, &c));
    return c;
}

static void disks_and_rings(void **state)
{
    gt t = gt_begin(1);
    ix_mv *c[3] = {circle_at(&t, 0, 2), circle_at(&t, -0.8, 0.5),
                   circle_at(&t, 0.9, 0.6)};

    (void)state;
    for (int k = 0; k < 9; k++) {
        int n = 1 + k % 3;
        const ix_tile_opts o = {
            .angle = 0.5, .size = 0.1 + 0.1 * (k / 3), .smooth = 3 * (k / 3)};
        double area = PI * (4 - (n > 1 ? 0.25 : 0) - (n > 2 ? 0.36 : 0));
        ix_quads q;

        ASSERT_OK(t.ctx,
                  ix_region_quads(t.ctx, n, (const ix_mv *const *)c, &o, &q));
        check(&t, &q, c, n - 1, area);
        ix_quads_free(t.ctx, &q);
    }
    for (int i = 0; i < 3; i++)
        ix_mv_unref(t.ctx, c[i]);
    gt_end(&t);
}

/* A star with corners turned in; its area by the polygon's formula. */
static void a_star(void **state)
{
    enum { N = 11 };
    double pts[2 * N], kv[N + 2], area = 0;
    gt t = gt_begin(2);
    ix_mv *c;

    (void)state;
    for (int i = 0; i < N; i++) {
        double r = i % 2 ? 0.5 : 1.5, a = PI * (i % 10) / 5;

        pts[i] = r * cos(a);
        pts[i + N] = r * sin(a);
    }
    for (int i = 0; i + 1 < N; i++)
        area += (pts[i] * pts[i + 1 + N] - pts[i + 1] * pts[i + N]) / 2;
    for (int i = 0; i < N + 2; i++)
        kv[i] = i < 1 ? 0 : i > N ? N - 1 : i - 1;
    c = gt_curve(&t, 2, N, kv, 2, false, pts);
    for (int k = 0; k < 4; k++) {
        const ix_tile_opts o = {
            .angle = 1, .size = 0.05 + 0.15 * k, .smooth = 5 * k};
        ix_quads q;

        ASSERT_OK(t.ctx,
                  ix_region_quads(t.ctx, 1, (const ix_mv *const *)&c, &o, &q));
        check(&t, &q, &c, 0, area);
        ix_quads_free(t.ctx, &q);
    }
    ix_mv_unref(t.ctx, c);
    gt_end(&t);
}

/* A square of side 4 on the grid's own step: nothing but squares inside. */
static void good_corners(void **state)
{
    const double sq[10] = {0, 4, 4, 0, 0, 0, 0, 4, 4, 0};
    const double kv[7] = {0, 0, 1, 2, 3, 4, 4};
    const ix_tile_opts o = {.angle = 1, .size = 0.25, .smooth = 10};
    gt t = gt_begin(3);
    ix_mv *c = gt_curve(&t, 2, 5, kv, 2, false, sq);
    double least = HUGE_VAL;
    ix_quads q;

    (void)state;
    ASSERT_OK(t.ctx,
              ix_region_quads(t.ctx, 1, (const ix_mv *const *)&c, &o, &q));
    check(&t, &q, &c, 0, 16);
    for (int i = 0; i < q.nquads; i++)
        for (int k = 0; k < 4; k++)
            least = fmin(least, corner_area(&q, i, k));
    assert_true(least > 0.25 * 0.25 * 0.25);
    ix_quads_free(t.ctx, &q);
    ix_mv_unref(t.ctx, c);
    gt_end(&t);
}

static void errors(void **state)
{
    const double line[4] = {0, 1, 0, 1}, twice[6] = {0, 1, 0, 0, 1, 0};
    const double kv[5] = {0, 0, 1, 2, 2};
    ix_tile_opts o = {.angle = 1, .size = 0.1};
    gt t = gt_begin(4);
    ix_mv *c = gt_curve(&t, 2, 2, NULL, 2, false, line),
          *k = circle_at(&t, 0, 1);
    ix_mv *d = gt_curve(&t, 2, 3, kv, 2, false, twice);
    ix_quads q;

    (void)state;
    assert_int_equal(
        ix_region_quads(t.ctx, 1, (const ix_mv *const *)&c, &o, &q),
        IX_EDOMAIN);
    assert_int_equal(
        ix_region_quads(t.ctx, 1, (const ix_mv *const *)&d, &o, &q),
        IX_EDOMAIN);
    assert_int_equal(ix_region_quads(t.ctx, 0, NULL, &o, &q), IX_EARG);
    o.size = 1e-6;
    assert_int_equal(
        ix_region_quads(t.ctx, 1, (const ix_mv *const *)&k, &o, &q), IX_EARG);
    o = (ix_tile_opts){.angle = NAN, .size = 1};
    assert_int_equal(
        ix_region_quads(t.ctx, 1, (const ix_mv *const *)&k, &o, &q), IX_EARG);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, d);
    ix_mv_unref(t.ctx, k);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double zero[3] = {0, 0, 0};

    ASSERT_OK(ctx, ix_circle(ctx, zero, 1, &f->in[0]));
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    const ix_tile_opts o = {.angle = 1, .size = 0.4, .smooth = 1};
    ix_quads q;

    IX_TRY(ix_region_quads(ctx, 1, (const ix_mv *const *)f->in, &o, &q));
    ix_quads_free(ctx, &q);
    *out = ix_mv_ref(f->in[0]);
    return IX_OK;
}

static void memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(disks_and_rings), cmocka_unit_test(a_star),
        cmocka_unit_test(good_corners),    cmocka_unit_test(errors),
        cmocka_unit_test(memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
