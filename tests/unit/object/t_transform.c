/* Objects times matrices: the table of spec/language 5.3, composition, boxes
 * of what was moved, sharing, memory. */
#include <string.h>

#include "harness/fault.h"
#include "harness/rand_obj.h"
#include "harness/test.h"
#include "io/io.h"

static const double shift[16] = {1, 0, 0, 0, 0, 1, 0, 0,
                                 0, 0, 1, 0, 1, 2, 3, 1};

static ix_obj *times(ix_ctx *ctx, const ix_obj *o, const double m[16])
{
    ix_obj *r;

    ASSERT_OK(ctx, ix__obj_transform(ctx, o, m, &r));
    return r;
}

static ix_obj *times_once(ix_ctx *ctx, ix_obj *o, const double m[16])
{
    ix_obj *r = times(ctx, o, m);

    ix__obj_unref(ctx, o);
    return r;
}

static void product(const double a[16], const double b[16], double out[16])
{
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            out[4 * i + j] = 0;
            for (int k = 0; k < 4; k++)
                out[4 * i + j] += a[4 * i + k] * b[4 * k + j];
        }
}

/* Affine, well conditioned: entries below 0.4 away from the diagonal's 1. */
static void rand_matrix(ix_rng *r, double m[16])
{
    for (int i = 0; i < 16; i++)
        m[i] = (i % 5 == 0) + ix_rng_range(r, -0.3, 0.3);
    for (int i = 3; i < 16; i += 4)
        m[i] = i == 15;
}

/* --- the table -------------------------------------------------------- */

static void test_simple(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_ctlpt p2 = {2, true, {2, 1, 0}}, e1 = {1, false, {5}};
    ix_ctlpt e5 = {5, false, {1, 1, 1, 7, 8}};
    ix_obj *o;

    (void)state;
    o = times_once(ctx, ix__obj_point(ctx, (double[]){1, 1, 1}), shift);
    assert_true(o->u.pt[0] == 2 && o->u.pt[1] == 3 && o->u.pt[2] == 4);
    ix__obj_unref(ctx, o);
    o = times_once(ctx, ix__obj_vector(ctx, (double[]){1, 1, 1}), shift);
    assert_int_equal(o->type, IX_OBJ_VECTOR);
    assert_true(o->u.pt[2] == 4); /* vectors move as well */
    ix__obj_unref(ctx, o);
    o = times_once(ctx, ix__obj_plane(ctx, (double[]){1, 2, 3, 4}),
                   (double[]){1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1});
    assert_true(o->u.plane[0] == 5 && o->u.plane[3] == 4);
    ix__obj_unref(ctx, o);
    o = times_once(ctx, ix__obj_ctlpt(ctx, &p2), shift);
    assert_true(o->u.ctlpt->v[0] == 2 && o->u.ctlpt->v[1] == 3 &&
                o->u.ctlpt->v[2] == 4);
    assert_int_equal(o->u.ctlpt->ncoords, 2);
    ix__obj_unref(ctx, o);
    o = times_once(ctx, ix__obj_ctlpt(ctx, &e1), shift);
    assert_true(!o->u.ctlpt->rational && o->u.ctlpt->v[0] == 6);
    ix__obj_unref(ctx, o);
    o = times_once(ctx, ix__obj_ctlpt(ctx, &e5), shift);
    assert_true(o->u.ctlpt->v[2] == 4 && o->u.ctlpt->v[3] == 7);
    ix__obj_unref(ctx, o);
    o = times_once(ctx, ix__obj_instance(ctx, "leg", shift), shift);
    assert_string_equal(o->u.inst->target, "LEG");
    assert_true(o->u.inst->mat[12] == 2 && o->u.inst->mat[15] == 1);
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

/* Curves and surfaces get three coordinates, trivariates and multivariates
 * keep theirs; weights stay weights. */
static void test_point_types(void **state)
{
    static const double id[16] = {1, 0, 0, 0, 0, 1, 0, 0,
                                  0, 0, 1, 0, 0, 0, 0, 1};
    ix_rng r = ix_rng_new(31);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int i = 0; i < 80; i++) {
        int dirs = 1 + i % 4;
        ix_mv *m = ix_rand_mv(ctx, &r, dirs);
        int nc = ix_mv_ncoords(m), expected = dirs < 3 && nc < 3 ? 3 : nc;
        ix_obj *o = ix__obj_mv(ctx, ix__obj_type_of_mv(m), m);
        ix_obj *q = times_once(ctx, o, id);

        assert_int_equal(ix_mv_ncoords(ix__obj_first_mv(q)), expected);
        ix__obj_unref(ctx, q);
    }
    ix_ctx_free(ctx);
}

static void test_refused(void **state)
{
    const double eye[16] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *n = ix__obj_number(ctx, 1), *s = ix__obj_string(ctx, "a", 1);
    ix_obj *p = ix__obj_point(ctx, (double[]){0, 1, 1}), *l = ix__obj_list(ctx);
    ix_trisrf *t = ix__trisrf_new(ctx, IX_TRI_BEZIER, 1, 1, 3, false);
    ix_obj *tri = ix__obj_trisrf(ctx, t), *out;

    (void)state;
    assert_int_equal(ix__obj_transform(ctx, n, shift, &out), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "Numeric"));
    assert_int_equal(ix__obj_transform(ctx, s, shift, &out), IX_EARG);
    assert_int_equal(ix__obj_transform(ctx, p, eye, &out), IX_EDOMAIN);
    assert_int_equal(ix__obj_transform(ctx, tri, eye, &out), IX_EARG);
    ASSERT_OK(ctx, ix__obj_append(ctx, l, p));
    ASSERT_OK(ctx, ix__obj_append(ctx, l, n));
    assert_int_equal(ix__obj_transform(ctx, l, shift, &out), IX_EARG);
    assert_null(out);
    assert_null(l->mark); /* the walk has cleaned up */
    ix__obj_unref(ctx, n);
    ix__obj_unref(ctx, s);
    ix__obj_unref(ctx, p);
    ix__obj_unref(ctx, l);
    ix__obj_unref(ctx, tri);
    ix_ctx_free(ctx);
}

/* --- laws ------------------------------------------------------------- */

static bool has_image(const ix_obj *o)
{
    return o->type != IX_OBJ_NUMBER && o->type != IX_OBJ_STRING &&
           o->type != IX_OBJ_LIST;
}

/* A thing of moderate size, so that tolerances mean something. */
static ix_obj *rand_curve(ix_ctx *ctx, ix_rng *r)
{
    double pts[12];
    const ix_dir dir = {IX_BEZIER, 3, 3, false, NULL};
    ix_mv *m;

    for (int i = 0; i < 12; i++)
        pts[i] = ix_rng_range(r, 0.5, 2); /* weights too */
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 3, true, pts, &m));
    return ix__obj_mv(ctx, IX_OBJ_CURVE, m);
}

/* Law: (o A) B = o (A B), up to rounding of a few sums of products of numbers
 * below 4. */
static void test_composition(void **state)
{
    ix_rng r = ix_rng_new(32);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int i = 0; i < 50; i++) {
        ix_obj *o = rand_curve(ctx, &r), *ab, *two;
        double a[16], b[16], c[16];
        bool equal;

        rand_matrix(&r, a);
        rand_matrix(&r, b);
        product(a, b, c);
        two = times_once(ctx, times(ctx, o, a), b);
        ab = times_once(ctx, o, c);
        ASSERT_OK(ctx, ix__obj_equal(ctx, two, ab, 64 * 0x1p-52, &equal));
        assert_true(equal);
        ix__obj_unref(ctx, ab);
        ix__obj_unref(ctx, two);
    }
    ix_ctx_free(ctx);
}

/* Law: polygons keep their vertices in their plane, normals stay unit and
 * normal to it, on the side of the image; for mirroring matrices, too. */
static void test_planes(void **state)
{
    ix_rng r = ix_rng_new(33);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int i = 0; i < 50; i++) {
        ix_poly *p = ix__poly_new(ctx, 1);
        double m[16], inside[3] = {0.2, 0.3, 1}, dot = 0, len = 0;
        const ix_polygon *pg;
        ix_obj *o, *q;

        ASSERT_OK(ctx, ix__poly_vertices(ctx, p->poly, 3));
        p->poly->v[1].p[0] = p->poly->v[2].p[1] = 1;
        p->poly->has_plane = ix__polygon_plane(p->poly, p->poly->plane);
        for (int k = 0; k < 3; k++) {
            memcpy(p->poly->v[k].normal, p->poly->plane, 3 * sizeof(double));
            p->poly->v[k].has_normal = true;
        }
        rand_matrix(&r, m);
        for (int k = 0; i % 2 && k < 4; k++)
            m[4 * k] = -m[4 * k]; /* mirrored */
        o = ix__obj_poly(ctx, p);
        q = times_once(ctx, o, m);
        pg = q->u.poly->poly;
        for (int k = 0; k < 3; k++) {
            const double *v = pg->v[k].p, *n = pg->plane;

            ASSERT_CLOSE(n[0] * v[0] + n[1] * v[1] + n[2] * v[2], -n[3], 1e-14);
            ASSERT_CLOSE(pg->v[k].normal[k], n[k], 1e-15);
            len += n[k] * n[k];
        }
        ASSERT_CLOSE(len, 1, 1e-15);
        for (int k = 0; k < 3; k++)
            dot += pg->plane[k] * (inside[0] * m[k] + inside[1] * m[4 + k] +
                                   inside[2] * m[8 + k] + m[12 + k]);
        assert_true(dot + pg->plane[3] > 0);
        ix__obj_unref(ctx, q);
    }
    ix_ctx_free(ctx);
}

/* Law: every object with an image keeps type, name and attributes, and its
 * box moves with a translation (by powers of two: exactly, where the numbers
 * are integers). */
static void test_boxes(void **state)
{
    ix_rng r = ix_rng_new(34);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int i = 0; i < 300; i++) {
        ix_obj *o = ix_rand_obj(ctx, &r, 1), *q;
        double a[6], b[6];

        if (has_image(o)) {
            q = times(ctx, o, shift);
            assert_int_equal(q->type, o->type);
            assert_true(!q->name == !o->name && !q->attrs == !o->attrs);
            if (ix__obj_bbox(ctx, o, a) == IX_OK) {
                ASSERT_OK(ctx, ix__obj_bbox(ctx, q, b));
                if (ix__seq_count(o) == 0 && o->type != IX_OBJ_CTLPT)
                    for (int k = 0; k < 6; k++)
                        ASSERT_CLOSE(b[k], a[k] + shift[12 + k / 2], 1e-15);
            }
            ix__obj_unref(ctx, q);
        }
        ix__obj_unref(ctx, o);
    }
    ix_ctx_free(ctx);
}

/* 2^60 paths: the result shares as the object does. */
static void test_sharing(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *o = ix__obj_list(ctx), *q, *p;
    double box[6];

    (void)state;
    p = ix__obj_point(ctx, (double[]){1, 1, 1});
    ASSERT_OK(ctx, ix__obj_append(ctx, o, p));
    ix__obj_unref(ctx, p);
    for (int i = 0; i < 60; i++) {
        ix_obj *l = ix__obj_list(ctx);

        ASSERT_OK(ctx, ix__obj_append(ctx, l, o));
        ASSERT_OK(ctx, ix__obj_append(ctx, l, o));
        ix__obj_unref(ctx, o);
        o = l;
    }
    q = times(ctx, o, shift);
    assert_ptr_equal(q->u.list.item[0], q->u.list.item[1]);
    ASSERT_OK(ctx, ix__obj_bbox(ctx, q, box));
    assert_true(box[0] == 2 && box[3] == 3 && box[5] == 4);
    ix__obj_unref(ctx, o);
    ix__obj_unref(ctx, q);
    ix_ctx_free(ctx);
}

/* --- boxes ------------------------------------------------------------ */

/* The box of a freeform is that of its projected control points; missing
 * coordinates are 0; a list has the box of all its elements. */
static void test_bbox_values(void **state)
{
    ix_rng r = ix_rng_new(35);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *l = ix__obj_list(ctx);
    double all[6], box[6], want[6];

    (void)state;
    for (int k = 0; k < 6; k++)
        all[k] = k % 2 ? -HUGE_VAL : HUGE_VAL;
    for (int i = 0; i < 40; i++) {
        ix_obj *o = i % 2 ? rand_curve(ctx, &r)
                          : ix_rand_obj_of(ctx, &r, IX_OBJ_TRIMSRF, 0);
        const ix_mv *m = i % 2 ? ix__obj_first_mv(o) : o->u.trim.item[0]->srf;
        const double *w = ix_mv_weights(m);

        for (int c = 0; c < 3; c++) {
            want[2 * c] = HUGE_VAL;
            want[2 * c + 1] = -HUGE_VAL;
            for (size_t k = 0; k < ix_mv_npts(m); k++) {
                double v = c < ix_mv_ncoords(m) ? ix_mv_coord(m, c)[k] : 0;

                v = w ? v / w[k] : v;
                want[2 * c] = fmin(want[2 * c], v);
                want[2 * c + 1] = fmax(want[2 * c + 1], v);
            }
            all[2 * c] = fmin(all[2 * c], want[2 * c]);
            all[2 * c + 1] = fmax(all[2 * c + 1], want[2 * c + 1]);
        }
        ASSERT_OK(ctx, ix__obj_bbox(ctx, o, box));
        for (int k = 0; k < 6; k++)
            assert_true(box[k] == want[k]);
        ASSERT_OK(ctx, ix__obj_append(ctx, l, o));
        ix__obj_unref(ctx, o);
    }
    ASSERT_OK(ctx, ix__obj_bbox(ctx, l, box));
    for (int k = 0; k < 6; k++)
        assert_true(box[k] == all[k]);
    ix__obj_unref(ctx, l);
    ix_ctx_free(ctx);
}

/* Triangular surfaces, models, polygons and points. */
static void test_bbox_others(void **state)
{
    static const struct {
        const char *text;
        double box[6];
    } rows[] = {
        {"[TRISRF BEZIER 2 P2 [2 2 4] [1 5 0] [1 -1 1]]", {-1, 5, 0, 2, 0, 0}},
        {"[MODEL 1 0 [MDLTSRF 0 [SURFACE BEZIER 1 1 E3 [1 2 3]]]]",
         {1, 1, 2, 2, 3, 3}},
        {"[POLYLINE 2 [0 5 1] [1 2 3]]", {0, 1, 2, 5, 1, 3}},
        {"[CTLPT P3 2 2 4 6]", {1, 1, 2, 2, 3, 3}},
        {"[CTLPT E1 7]", {7, 7, 0, 0, 0, 0}},
        {"[VECTOR 1 2 3]", {1, 1, 2, 2, 3, 3}},
    };
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const char *t = rows[i].text;
        double box[6];
        ix_obj *o;

        ASSERT_OK(ctx, ix__itd_read(ctx, t, t, strlen(t), &o));
        ASSERT_OK(ctx, ix__obj_bbox(ctx, o, box));
        for (int k = 0; k < 6; k++)
            assert_true(box[k] == rows[i].box[k]);
        ix__obj_unref(ctx, o);
    }
    ix_ctx_free(ctx);
}

static void test_bbox_errors(void **state)
{
    const ix_dir dir = {IX_BEZIER, 2, 2, false, NULL};
    const double signs[] = {1, -1, 0, 1};
    ix_ctlpt far = {1, true, {0, 1}};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *n = ix__obj_number(ctx, 1), *p = ix__obj_ctlpt(ctx, &far), *c;
    double box[6];
    ix_mv *m;

    (void)state;
    assert_int_equal(ix__obj_bbox(ctx, n, box), IX_EDOMAIN);
    assert_int_equal(ix__obj_bbox(ctx, p, box), IX_EDOMAIN);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, true, signs, &m));
    c = ix__obj_mv(ctx, IX_OBJ_CURVE, m);
    assert_int_equal(ix__obj_bbox(ctx, c, box), IX_EDOMAIN);
    ix__obj_unref(ctx, n);
    ix__obj_unref(ctx, p);
    ix__obj_unref(ctx, c);
    ix_ctx_free(ctx);
}

/* --- memory ----------------------------------------------------------- */

typedef struct {
    ix_obj_type type;
    ix_obj *in, *out;
} fault_state;

static void setup(ix_ctx *ctx, void *state)
{
    fault_state *s = state;
    ix_rng r = ix_rng_new(50 + (uint64_t)s->type);
    ix_obj *o = ix_rand_obj_of(ctx, &r, s->type, 1);

    s->in = ix__obj_list(ctx);
    s->out = NULL;
    assert_true(o && s->in);
    ASSERT_OK(ctx, ix__obj_append(ctx, s->in, o));
    ix__obj_unref(ctx, o);
}

static ix_status run(ix_ctx *ctx, void *state)
{
    fault_state *s = state;
    ix_status st = ix__obj_transform(ctx, s->in, shift, &s->out);

    assert_true((st == IX_OK) == (s->out != NULL));
    assert_null(s->in->mark);
    return st;
}

static void teardown(ix_ctx *ctx, void *state)
{
    fault_state *s = state;

    ix__obj_unref(ctx, s->in);
    ix__obj_unref(ctx, s->out);
}

static void test_faults(void **state)
{
    (void)state;
    for (int t = IX_OBJ_POLY; t <= IX_OBJ_MULTIVAR; t++) {
        fault_state s = {.type = (ix_obj_type)t};
        ix_fault_case c = {setup, run, teardown, &s};

        if (t != IX_OBJ_NUMBER && t != IX_OBJ_STRING && t != IX_OBJ_LIST)
            assert_true(ix_fault_run(&c) > 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_simple),      cmocka_unit_test(test_point_types),
        cmocka_unit_test(test_refused),     cmocka_unit_test(test_composition),
        cmocka_unit_test(test_planes),      cmocka_unit_test(test_boxes),
        cmocka_unit_test(test_sharing),     cmocka_unit_test(test_bbox_values),
        cmocka_unit_test(test_bbox_others), cmocka_unit_test(test_bbox_errors),
        cmocka_unit_test(test_faults)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
