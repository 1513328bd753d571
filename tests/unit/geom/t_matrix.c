/* t_matrix.c - laws of the 4 x 4 matrices: products against their inverses,
 * maps against what defines them, parts against their recomposition. */
#include <string.h>

#include "geom/matrix.h"
#include "geom/vec3.h"
#include "harness/test.h"

enum { ROUNDS = 200 };
/* A few operations on numbers of size 1 .. 10. */
static const double TOL = 1e-13;

static void random3(ix_rng *g, double r, double v[3])
{
    for (int i = 0; i < 3; i++)
        v[i] = ix_rng_range(g, -r, r);
}

static void assert_mat(const double a[16], const double b[16], double tol)
{
    for (int i = 0; i < 16; i++)
        if (!ix_close(a[i], b[i], tol))
            fail_msg("entry %d: %.17g against %.17g", i, a[i], b[i]);
}

static void assert_rotation(const double m[16])
{
    double t[16], p[16], one[16];

    for (int i = 0; i < 16; i++)
        t[i] = m[4 * (i % 4) + i / 4];
    ix__mat_mul(m, t, p);
    ix__mat_identity(one);
    assert_mat(p, one, TOL);
    ASSERT_CLOSE(ix__mat_det(m), 1.0, TOL);
}

/* Law: sincos agrees with libm, and is exact at multiples of 90. */
static void test_sincos(void **state)
{
    static const double exact[4][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};
    ix_rng g = ix_rng_new(11);
    double s, c;

    (void)state;
    for (int k = -40; k <= 40; k++) {
        ix__sincos_deg(90.0 * k, &s, &c);
        assert_true(s == exact[k & 3][0] && c == exact[k & 3][1]);
        assert_false(signbit(s) && s == 0);
    }
    for (int k = 0; k < ROUNDS; k++) {
        double d = ix_rng_range(&g, -720, 720);

        ix__sincos_deg(d, &s, &c);
        ASSERT_CLOSE(s, sin(d * 3.14159265358979323846 / 180), 4e-15);
        ASSERT_CLOSE(c, cos(d * 3.14159265358979323846 / 180), 4e-15);
    }
    ix__sincos_deg((double)NAN, &s, &c);
    assert_true(isnan(s) && isnan(c));
}

/* Law: M M^-1 = 1 whatever the scales of rows; det(AB) = det A det B. */
static void test_inverse(void **state)
{
    ix_rng g = ix_rng_new(12);
    double a[16], b[16], p[16], one[16];

    (void)state;
    ix__mat_identity(one);
    for (int k = 0; k < ROUNDS; k++) {
        double s = pow(10, ix_rng_range(&g, -30, 30));

        for (int i = 0; i < 16; i++) {
            a[i] = ix_rng_range(&g, -1, 1) + (i % 5 == 0 ? 3 : 0);
            b[i] = ix_rng_range(&g, -1, 1);
        }
        ix__mat_mul(a, b, p);
        ASSERT_CLOSE(ix__mat_det(p), ix__mat_det(a) * ix__mat_det(b), TOL);
        for (int i = 0; i < 4; i++)
            a[4 + i] *= s;
        assert_true(ix__mat_inverse(a, b));
        for (int i = 0; i < 4; i++) { /* undone: the row of M, the column */
            a[4 + i] /= s;            /* of its inverse */
            b[4 * i + 1] *= s;
        }
        ix__mat_mul(a, b, p);
        assert_mat(p, one, TOL);
    }
    memcpy(a + 4, a, 4 * sizeof *a);
    b[0] = 77;
    assert_false(ix__mat_inverse(a, b));
    assert_true(b[0] == 77);
    a[5] = (double)NAN;
    assert_false(ix__mat_inverse(a, b));
}

/* Law: a far translation does not make a small scale singular. */
static void test_inverse_affine(void **state)
{
    double far[3] = {1e9, -1e9, 1e9}, tiny[3] = {1e-9, 1e-9, 1e-9};
    double s[16], t[16], m[16], inv[16], p[3] = {0.25, 0.5, 1}, q[3];

    (void)state;
    ix__mat_scale(tiny, s);
    ix__mat_translate(far, t);
    ix__mat_mul(s, t, m);
    assert_true(ix__mat_inverse(m, inv));
    ix__mat_mul(m, inv, m);
    assert_true(ix__mat_point(p, m, q));
    for (int i = 0; i < 3; i++)
        ASSERT_CLOSE(q[i], p[i], TOL);
}

/* Law: rotations about coordinate axes equal those about a vector; the left
 * factor acts first; a positive angle turns x to y. */
static void test_rotations(void **state)
{
    ix_rng g = ix_rng_new(13);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double m[16], n[16], p[3] = {1, 0, 0}, q[3];

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        double d = ix_rng_range(&g, -400, 400), e[3] = {0, 0, 0};

        e[k % 3] = ix_rng_range(&g, 1, 5);
        ix__mat_rotate(k % 3, d, m);
        ASSERT_OK(ctx, ix__mat_rotate_about(ctx, e, d, n));
        assert_mat(m, n, TOL);
        assert_rotation(m);
    }
    ix__mat_rotate(2, 90, m);
    assert_true(ix__mat_point(p, m, q));
    assert_true(q[0] == 0 && q[1] == 1 && q[2] == 0);
    p[0] = 0;
    assert_int_equal(ix__mat_rotate_about(ctx, p, 1, m), IX_EARG);
    ix_ctx_free(ctx);
}

/* Law: the turn takes a to b, is a rotation, and leaves a x b alone; also
 * when a and b are (nearly) equal or opposite. */
static void test_turn(void **state)
{
    ix_rng g = ix_rng_new(14);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        double a[3], b[3], u[3], v[3], w[3], m[16], q[3];
        double off = k % 3 ? pow(10, ix_rng_range(&g, -18, 0)) : 0;

        random3(&g, 4, a);
        random3(&g, 4, b);
        if (k % 4)
            for (int i = 0; i < 3; i++)
                b[i] = (k % 4 == 1 ? -2 : 3) * a[i] + off * b[i];
        ASSERT_OK(ctx, ix__mat_turn(ctx, a, b, m));
        assert_rotation(m);
        ix__unit3(a, u);
        ix__unit3(b, v);
        assert_true(ix__mat_point(u, m, q));
        assert_true(ix__dist3(q, v) <= 4e-15); /* rounding of unit vectors */
        ix__cross3(u, v, w);
        if (ix__unit3(w, w) > 0.01) {
            assert_true(ix__mat_point(w, m, q));
            assert_true(ix__dist3(q, w) <= TOL);
        }
    }
    ix_ctx_free(ctx);
}

/* Law: z goes to dir, x into the half plane of dir2; the view matrix is its
 * counterpart for eyes. */
static void test_frame_view(void **state)
{
    ix_rng g = ix_rng_new(15);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    static const double zero[3] = {0, 0, 0}, ez[3] = {0, 0, 1};
    double m[16], v[3];

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        double a[3], b[3], pos[3], at[3], q[3];

        random3(&g, 4, a);
        random3(&g, 4, b);
        random3(&g, 9, pos);
        ASSERT_OK(ctx, ix__mat_frame(ctx, a, b, m));
        assert_rotation(m);
        ASSERT_CLOSE(ix__dot3(m + 8, a), ix__len3(a), TOL);
        ASSERT_CLOSE(ix__dot3(m + 4, b), 0.0, TOL);
        assert_true(ix__dot3(m, b) > 0);
        ASSERT_OK(ctx, ix__mat_view(ctx, pos, a, b, m));
        assert_true(ix__mat_point(pos, m, q));
        assert_true(ix__len3(q) <= TOL * 10);
        ix__axpy3(pos, 2, a, at);
        assert_true(ix__mat_point(at, m, q));
        ASSERT_CLOSE(q[2], -2 * ix__len3(a), TOL);
        ASSERT_CLOSE(hypot(q[0], q[1]), 0.0, TOL * 10);
        ix__axpy3(pos, 1, b, at);
        assert_true(ix__mat_point(at, m, q));
        ASSERT_CLOSE(q[0], 0.0, TOL * 10);
        assert_true(q[1] > 0);
        m[12] = m[13] = m[14] = 0;
        assert_rotation(m);
    }
    ix__axpy3(zero, -3, ez, v);
    assert_int_equal(ix__mat_frame(ctx, ez, v, m), IX_EARG);
    assert_non_null(strstr(ix_ctx_message(ctx), "parallel"));
    assert_int_equal(ix__mat_frame(ctx, zero, v, m), IX_EARG);
    assert_int_equal(ix__mat_turn(ctx, v, zero, m), IX_EARG);
    ix_ctx_free(ctx);
}

static double height(const double pl[4], const double p[3])
{
    return (ix__dot3(pl, p) + pl[3]) / ix__len3(pl);
}

/* Law: images lie in the plane and on the line to the eye; a mirror keeps
 * the plane, negates heights and is its own inverse. */
static void test_project_reflect(void **state)
{
    ix_rng g = ix_rng_new(16);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        double pl[4], eye[4], p[3], q[3], d[3], e[3], c[3], m[16], mm[16];

        random3(&g, 2, pl);
        random3(&g, 5, eye);
        random3(&g, 5, p);
        pl[3] = ix_rng_range(&g, -3, 3);
        eye[3] = k % 2;
        if (fabs(ix__dot3(pl, eye) + pl[3] * eye[3]) < 0.1)
            continue;
        ASSERT_OK(ctx, ix__mat_project(ctx, pl, eye, m));
        if (!ix__mat_point(p, m, q) || ix__len3(q) > 100)
            continue;
        ASSERT_CLOSE(height(pl, q), 0.0, 1e-11); /* q up to 100 */
        ix__sub3(q, p, d);
        ix__axpy3(eye, -eye[3], p, e);
        ix__cross3(d, e, c);
        ASSERT_CLOSE(ix__len3(c), 0.0, 1e-10);
        ASSERT_OK(ctx, ix__mat_reflect(ctx, pl, m));
        assert_true(ix__mat_point(p, m, q));
        ASSERT_CLOSE(height(pl, q), -height(pl, p), 1e-12);
        ix__mat_mul(m, m, mm);
        ix__mat_identity(m);
        assert_mat(mm, m, 1e-12);
    }
    assert_int_equal(ix__mat_project(ctx, (double[4]){0, 0, 1, -2},
                                     (double[4]){5, 5, 2, 1}, (double[16]){0}),
                     IX_EDOMAIN);
    assert_int_equal(
        ix__mat_reflect(ctx, (double[4]){0, 0, 0, 1}, (double[16]){0}),
        IX_EARG);
    ix_ctx_free(ctx);
}

/* Law: the image triangle has equal sides, its centre at the origin. */
static void test_equilateral(void **state)
{
    ix_rng g = ix_rng_new(17);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double m[16], p[3][3], q[3][3];

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        double sum[3] = {0, 0, 0};

        for (int i = 0; i < 3; i++)
            random3(&g, 3, p[i]);
        ASSERT_OK(ctx, ix__mat_equilateral(ctx, p, m));
        for (int i = 0; i < 3; i++) {
            assert_true(ix__mat_point(p[i], m, q[i]));
            ix__axpy3(sum, 1, q[i], sum);
        }
        for (int i = 0; i < 3; i++)
            ASSERT_CLOSE(ix__dist3(q[i], q[(i + 1) % 3]), sqrt(3), 1e-10);
        assert_true(ix__len3(sum) < 1e-10); /* thin triangles among them */
    }
    for (int i = 0; i < 3; i++)
        ix__axpy3(p[0], i, (double[3]){1, 2, 3}, p[i]);
    assert_int_equal(ix__mat_equilateral(ctx, p, m), IX_EDOMAIN);
    ix_ctx_free(ctx);
}

static void recompose(const ix__mat_parts *p, bool scale_first, double m[16])
{
    double s[16], t[16];

    ix__mat_scale(p->scale, s);
    ix__mat_translate(p->trans, t);
    ix__mat_mul(scale_first ? s : p->rot, scale_first ? p->rot : s, m);
    ix__mat_mul(m, t, m);
}

/* Law: the parts multiply to the matrix, in both orders of scale and
 * rotation and with mirrors; a pure scale (mirroring or positive) has no
 * rotation. */
static void test_decompose(void **state)
{
    ix_rng g = ix_rng_new(18);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double m[16], n[16], one[16];
    ix__mat_parts p, got;

    (void)state;
    ix__mat_identity(one);
    for (int k = 0; k < ROUNDS; k++) {
        double axis[3];

        random3(&g, 1, axis);
        random3(&g, 9, p.trans);
        for (int i = 0; i < 3; i++)
            p.scale[i] = pow(10, ix_rng_range(&g, -3, 3)) *
                         (ix_rng_int(&g, 0, 1) ? 1 : -1);
        ASSERT_OK(ctx, ix__mat_rotate_about(ctx, axis, ix_rng_range(&g, 0, 360),
                                            p.rot));
        if (k % 5 == 0)
            ix__mat_identity(p.rot);
        recompose(&p, k % 2, m);
        ASSERT_OK(ctx, ix__mat_decompose(ctx, m, &got));
        assert_rotation(got.rot);
        recompose(&got, k % 2 && k % 5, n);
        assert_mat(m, n, 1e-12);
        if (k % 5 == 0 && (p.scale[0] * p.scale[1] * p.scale[2] < 0 ||
                           (p.scale[0] > 0 && p.scale[1] > 0)))
            assert_mat(got.rot, one, TOL);
    }
    ix_ctx_free(ctx);
}

/* Each error of the decompositions, with its numbers. */
static void test_decompose_errors(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double m[16], v[7];
    ix__mat_parts p;

    (void)state;
    ix__mat_identity(m);
    m[1] = 1; /* rows and columns at 45 degrees */
    assert_int_equal(ix__mat_decompose(ctx, m, &p), IX_EDOMAIN);
    assert_non_null(strstr(ix_ctx_message(ctx), "columns 1 and 2 meet at 45 "));
    ix__mat_identity(m);
    m[3] = 0.5;
    assert_int_equal(ix__mat_decompose(ctx, m, &p), IX_EDOMAIN);
    assert_non_null(strstr(ix_ctx_message(ctx), "perspective"));
    ix__mat_scale((double[3]){1, 0, 1}, m);
    assert_int_equal(ix__mat_decompose(ctx, m, &p), IX_EDOMAIN);
    assert_non_null(strstr(ix_ctx_message(ctx), "singular"));
    m[5] = (double)NAN;
    assert_int_equal(ix__mat_decompose(ctx, m, &p), IX_EDOMAIN);
    ix__mat_scale((double[3]){1, 2, 1}, m);
    assert_int_equal(ix__mat_to_euler(ctx, m, v), IX_EDOMAIN);
    assert_non_null(strstr(ix_ctx_message(ctx), "not uniform: 1, 2, 1"));
    m[15] = 0;
    assert_int_equal(ix__mat_to_euler(ctx, m, v), IX_EDOMAIN);
    ix_ctx_free(ctx);
}

/* Law: from_euler is Rx Ry Rz S T; to_euler inverts it, at the poles of the
 * angles and for negative scales too. */
static void test_euler(void **state)
{
    ix_rng g = ix_rng_new(19);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    const double deg = 180 / 3.14159265358979323846;
    double v[7], w[7], m[16], n[16], f[16];

    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        for (int i = 0; i < 7; i++)
            v[i] = ix_rng_range(&g, -3, 3);
        if (k % 3 == 0)
            v[1] = (k % 2 ? 90 : -90) / deg;
        ix__mat_from_euler(v, m);
        ix__mat_rotate(0, v[0] * deg, n);
        ix__mat_rotate(1, v[1] * deg, f);
        ix__mat_mul(n, f, n);
        ix__mat_rotate(2, v[2] * deg, f);
        ix__mat_mul(n, f, n);
        ix__mat_scale((double[3]){v[3], v[3], v[3]}, f);
        ix__mat_mul(n, f, n);
        ix__mat_translate(v + 4, f);
        ix__mat_mul(n, f, n);
        assert_mat(m, n, TOL);
        ASSERT_OK(ctx, ix__mat_to_euler(ctx, m, w));
        ASSERT_CLOSE(w[3], v[3], TOL);
        ix__mat_from_euler(w, n);
        assert_mat(m, n, 1e-12);
    }
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sincos),
        cmocka_unit_test(test_inverse),
        cmocka_unit_test(test_inverse_affine),
        cmocka_unit_test(test_rotations),
        cmocka_unit_test(test_turn),
        cmocka_unit_test(test_frame_view),
        cmocka_unit_test(test_project_reflect),
        cmocka_unit_test(test_equilateral),
        cmocka_unit_test(test_decompose),
        cmocka_unit_test(test_decompose_errors),
        cmocka_unit_test(test_euler),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
