/* t_divide_box.c - a rectangle divided by curves: areas, windings and nesting
 * are measured on polygons sampled from the loops. */
#include "iritx/geom.h"
#include "iritx/regions.h"
#include "unit/geom/geomtest.h"

/* Wide and low, so that tolerances in the parameters cannot be absolute. */
static const double box[2][2] = {{2, 402}, {-0.5, 0.5}};

static ix_mv *to_box(gt *t, ix_mv *unit)
{
    const double mat[16] = {400, 0, 0, 0, 0, 1,    0, 0,
                            0,   0, 1, 0, 2, -0.5, 0, 1};
    ix_mv *m = NULL;

    ASSERT_OK(t->ctx, ix_mv_transform(t->ctx, unit, mat, &m));
    ix_mv_unref(t->ctx, unit);
    return m;
}

static ix_mv *line(gt *t, double x0, double y0, double x1, double y1)
{
    return to_box(t, gt_curve(t, 2, 2, NULL, 2, false,
                              (const double[4]){x0, x1, y0, y1}));
}

static ix_mv *disk(gt *t, double x, double y, double r)
{
    ix_mv *c = NULL;

    ASSERT_OK(t->ctx, ix_circle(t->ctx, (const double[3]){x, y, 0}, r, &c));
    return to_box(t, c);
}

enum { SAMPLES = 64 }; /* of a curve */

/* Turns of loop k around p, and its signed area. */
static double turns(gt *t, const ix_regions *r, int k, const double *p,
                    double *area)
{
    double sum = 0, a[2] = {0}, b[2], last[2] = {0};
    bool any = false;

    *area = 0;
    for (int c = r->first_crv[k]; c < r->first_crv[k + 1]; c++)
        for (int i = 0; i <= SAMPLES; i++) {
            double dom[2], q[IX_MAX_COORDS], at;

            ix_mv_domain(r->crv[c], 0, dom);
            at = dom[0] + (dom[1] - dom[0]) * i / SAMPLES;
            gt_point(t, r->crv[c], &at, q);
            b[0] = (q[0] - p[0]) / 400; /* the unit square again */
            b[1] = q[1] - p[1];
            if (any && i == 0) { /* each begins where the one before ends */
                ASSERT_CLOSE(b[0], last[0], 1e-6);
                ASSERT_CLOSE(b[1], last[1], 1e-6);
            }
            if (any) {
                sum += atan2(a[0] * b[1] - a[1] * b[0],
                             a[0] * b[0] + a[1] * b[1]);
                *area += (a[0] * b[1] - a[1] * b[0]) / 2;
            }
            memcpy(a, b, sizeof a);
            memcpy(last, b, sizeof last);
            any = true;
        }
    return sum / (2 * 3.14159265358979);
}

/* Whether p is in region i, by the turns of its loops; the region's area by the
 * same polygons. */
static bool holds(gt *t, const ix_regions *r, int i, const double *p,
                  double *area)
{
    int n = 0;

    *area = 0;
    for (int k = r->first_loop[i]; k < r->first_loop[i + 1]; k++) {
        double one, w = turns(t, r, k, p, &one);

        ASSERT_CLOSE(w, floor(w + 0.5), 1e-6);
        /* the first is the outer one, counter-clockwise, others are holes */
        assert_true(k == r->first_loop[i] ? one > 0 : one < 0);
        n += (int)floor(w + 0.5);
        *area += one;
    }
    assert_true(n == 0 || n == 1);
    return n == 1;
}

/* Laws: the areas add up to the rectangle's, and each is its polygons' (circles
 * of four spans with 64 chords: 1e-3 of them less); every point is in exactly
 * one region. */
static void check_regions(gt *t, const ix_regions *r, int want)
{
    double sum = 0, area;

    assert_int_equal(r->n, want);
    for (int i = 0; i < r->n; i++)
        sum += r->area[i];
    ASSERT_CLOSE(sum, 400, 1e-9);
    for (int k = 0; k < 12; k++) {
        double p[2] = {ix_rng_range(&t->r, 2, 402),
                       ix_rng_range(&t->r, -0.5, 0.5)};
        int inside = 0;

        for (int i = 0; i < r->n; i++) {
            inside += holds(t, r, i, p, &area);
            ASSERT_CLOSE(area, r->area[i] / 400, 2e-3);
        }
        assert_int_equal(inside, 1);
    }
}

static void divide(gt *t, int n, ix_mv **c, int want)
{
    ix_regions r;

    ASSERT_OK(t->ctx,
              ix_divide_box(t->ctx, box, n, (const ix_mv *const *)c, &r));
    check_regions(t, &r, want);
    ix_regions_free(t->ctx, &r);
    for (int i = 0; i < n; i++)
        ix_mv_unref(t->ctx, c[i]);
}

static void known_divisions(void **state)
{
    static const double knot[8] = {0.2, 1.1, -0.1, 0.8, 0.3, 0.9, 0.9, 0.3};
    gt t = gt_begin(81);
    ix_mv *c[6];

    (void)state;
    divide(&t, 0, c, 1);
    c[0] = line(&t, 0, 0.2, 1, 0.5); /* border to border */
    divide(&t, 1, c, 2);
    c[0] = line(&t, -0.5, 0.2, 1.5, 0.5); /* and beyond */
    divide(&t, 1, c, 2);
    c[0] = line(&t, 0.2, 0.2, 0.8, 0.5); /* ends inside: divides nothing */
    divide(&t, 1, c, 1);
    c[0] = line(&t, 0, 0, 1, 1); /* corner to corner */
    c[1] = line(&t, 0, 1, 1, 0);
    divide(&t, 2, c, 4);
    c[0] = line(&t, 0, 0.5, 1, 0.5);
    c[1] = line(&t, 0.3, 0.5, 0.3, 1); /* from border to contour */
    divide(&t, 2, c, 3);
    c[0] = disk(&t, 0.5, 0.5, 0.3);
    divide(&t, 1, c, 2);
    c[0] = disk(&t, 1, 1, 0.4); /* around a corner */
    divide(&t, 1, c, 2);
    c[0] = disk(&t, 0.5, 0.5, 0.4);
    c[1] = disk(&t, 0.5, 0.5, 0.3); /* nested three deep */
    c[2] = disk(&t, 0.4, 0.5, 0.1);
    c[3] = disk(&t, 0.65, 0.5, 0.08);
    divide(&t, 4, c, 5);
    c[0] = disk(&t, 0.4, 0.5, 0.2); /* a lens and two moons */
    c[1] = disk(&t, 0.6, 0.5, 0.2);
    divide(&t, 2, c, 4);
    c[0] = disk(&t, 0.5, 0.5, 0.5); /* touches all sides */
    divide(&t, 1, c, 5);
    c[0] = line(&t, 0, 0, 1, 0); /* a side itself */
    c[1] = line(&t, 0.2, 0, 0.7, 0);
    c[2] = line(&t, 0.2, 0, 0.2, 1);
    c[3] = line(&t, 0.2, 1, 0.2, 0); /* and its copy against it */
    divide(&t, 4, c, 2);
    c[0] = to_box(&t, gt_curve(&t, 4, 4, NULL, 2, false, knot)); /* a loop */
    c[1] = line(&t, 0, 0.3, 0.2, 0.3);
    c[2] = line(&t, 0.8, 0.3, 1, 0.3);
    divide(&t, 3, c, 3);
    gt_end(&t);
}

/* Random circles and lines from border to border: the number of regions follows
 * from Euler's formula, as meetings are counted in closed form. */
static void random_divisions(void **state)
{
    gt t = gt_begin(82);

    (void)state;
    for (int k = 0; k < 6; k++) {
        double x[4][2]; /* lines from (x0, 0) to (x1, 1) */
        int cuts = 0;
        ix_mv *c[4];

        for (int i = 0; i < 4; i++) {
            x[i][0] = ix_rng_range(&t.r, 0.05, 0.95);
            x[i][1] = ix_rng_range(&t.r, 0.05, 0.95);
            c[i] = line(&t, x[i][0], 0, x[i][1], 1);
            for (int j = 0; j < i; j++)
                cuts += (x[i][0] < x[j][0]) != (x[i][1] < x[j][1]);
        }
        divide(&t, 4, c, 1 + 4 + cuts); /* each line and crossing adds one */
    }
    gt_end(&t);
}

/* Laws of what is inside loops: of a ring cut by a box, areas of both parts add
 * up to the ring's; loops of several curves with a gap of 1e-5 close. */
static void trimmed(void **state)
{
    const double left[2][2] = {{2, 150}, {-0.5, 0.5}};
    const double right[2][2] = {{150, 402}, {-0.5, 0.5}};
    const int first[3] = {0, 1, 2}, corners[2] = {0, 3};
    const double ring = 3.14159265358979 * (0.16 - 0.01) * 400;
    gt t = gt_begin(85);
    ix_mv *c[3];
    ix_regions r;
    double sum = 0;

    (void)state;
    c[0] = disk(&t, 0.5, 0.5, 0.4);
    c[1] = disk(&t, 0.5, 0.5, 0.1);
    ASSERT_OK(t.ctx,
              ix_trim_box(t.ctx, box, 2, first, (const ix_mv *const *)c, &r));
    assert_int_equal(r.n, 1);
    assert_int_equal(r.nloops, 2);
    ASSERT_CLOSE(r.area[0], ring, 1e-9);
    ix_regions_free(t.ctx, &r);
    for (int k = 0; k < 2; k++) {
        ASSERT_OK(t.ctx, ix_trim_box(t.ctx, k ? right : left, 2, first,
                                     (const ix_mv *const *)c, &r));
        for (int i = 0; i < r.n; i++)
            sum += r.area[i];
        ix_regions_free(t.ctx, &r);
    }
    ASSERT_CLOSE(sum, ring, 1e-9);
    ix_mv_unref(t.ctx, c[0]);
    ix_mv_unref(t.ctx, c[1]);
    c[0] = line(&t, 0.1, 0.1, 0.9, 0.1);
    c[1] = line(&t, 0.9, 0.1 + 1e-5, 0.9, 0.9);
    c[2] = line(&t, 0.9, 0.9, 0.1, 0.1 + 1e-5);
    ASSERT_OK(t.ctx,
              ix_trim_box(t.ctx, box, 1, corners, (const ix_mv *const *)c, &r));
    assert_int_equal(r.n, 1);
    ASSERT_CLOSE(r.area[0], 400 * 0.32, 400 * 1e-5);
    ix_regions_free(t.ctx, &r);
    for (int k = 0; k < 3; k++)
        ix_mv_unref(t.ctx, c[k]);
    gt_end(&t);
}

static void errors(void **state)
{
    const double empty[2][2] = {{0, 1}, {1, 1}};
    gt t = gt_begin(83);
    ix_mv *flat = gt_random(&t, 1, 1, 0, IX_RAND_BEZIER, 2);
    ix_mv *s = gt_random(&t, 2, 2, 0, IX_RAND_BEZIER, 2);
    ix_regions r;

    (void)state;
    assert_int_equal(ix_divide_box(t.ctx, empty, 0, NULL, &r), IX_EARG);
    assert_int_equal(
        ix_divide_box(t.ctx, box, 1, (const ix_mv *const[]){flat}, &r),
        IX_EARG);
    assert_int_equal(
        ix_divide_box(t.ctx, box, 1, (const ix_mv *const[]){s}, &r), IX_EARG);
    assert_int_equal(ix_trim_box(t.ctx, empty, 0, NULL, NULL, &r), IX_EARG);
    assert_int_equal(ix_trim_box(t.ctx, box, 1, (const int[2]){0, 1},
                                 (const ix_mv *const[]){flat}, &r),
                     IX_EARG);
    assert_int_equal(r.n, 0);
    ix_regions_free(t.ctx, &r);
    ix_mv_unref(t.ctx, flat);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

typedef struct {
    ix_mv *c[2];
    ix_regions r;
} fault;

static void setup(ix_ctx *ctx, void *state)
{
    gt t = {ctx, ix_rng_new(84)};
    fault *f = state;

    f->r = (ix_regions){.n = 0};
    f->c[0] = line(&t, 0, 0.2, 1, 0.5);
    f->c[1] = line(&t, 0.5, 0.3, 0.5, 1);
}

static ix_status run(ix_ctx *ctx, void *state)
{
    const int first[2] = {0, 2};
    fault *f = state;

    IX_TRY(ix_trim_box(ctx, box, 1, first, (const ix_mv *const *)f->c, &f->r));
    ix_regions_free(ctx, &f->r);
    return ix_divide_box(ctx, box, 2, (const ix_mv *const *)f->c, &f->r);
}

static void teardown(ix_ctx *ctx, void *state)
{
    fault *f = state;

    ix_regions_free(ctx, &f->r);
    ix_mv_unref(ctx, f->c[0]);
    ix_mv_unref(ctx, f->c[1]);
}

static void out_of_memory(void **state)
{
    fault f;
    const ix_fault_case c = {setup, run, teardown, &f};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_divisions), cmocka_unit_test(random_divisions),
        cmocka_unit_test(trimmed),         cmocka_unit_test(errors),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
