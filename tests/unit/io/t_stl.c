/* STL files read back by a few lines of the test's own: a cylinder's triangles
 * lie on it within the tolerance, close it, and have outward normals; text and
 * binary agree; what cannot be written is refused. */
#include <string.h>

#include "harness/fault.h"
#include "harness/test.h"
#include "io/export.h"

#define CYLINDER                                                    \
    "[OBJECT CYL [SURFACE BSPLINE 9 2 3 2 P3"                       \
    "[KV 0 0 0 1 1 2 2 3 3 4 4 4][KV 0 0 1 1]"                      \
    "[1 1 0 0][.70710678118654757 .70710678118654757 "              \
    ".70710678118654757 0][1 0 1 0]"                                \
    "[.70710678118654757 -.70710678118654757 .70710678118654757 0]" \
    "[1 -1 0 0][.70710678118654757 -.70710678118654757 "            \
    "-.70710678118654757 0][1 0 -1 0]"                              \
    "[.70710678118654757 .70710678118654757 -.70710678118654757 0]" \
    "[1 1 0 0]"                                                     \
    "[1 1 0 2][.70710678118654757 .70710678118654757 "              \
    ".70710678118654757 1.4142135623730951][1 0 1 2]"               \
    "[.70710678118654757 -.70710678118654757 .70710678118654757 "   \
    "1.4142135623730951][1 -1 0 2][.70710678118654757 "             \
    "-.70710678118654757 -.70710678118654757 1.4142135623730951]"   \
    "[1 0 -1 2][.70710678118654757 .70710678118654757 "             \
    "-.70710678118654757 1.4142135623730951][1 1 0 2]]]"

/* An L of six corners: not convex. */
#define ELL "[OBJECT L [POLYGON 6 [0 0 0][2 0 0][2 1 0][1 1 0][1 2 0][0 2 0]]]"

typedef struct {
    int n;
    double v[2000][3][3], normal[2000][3];
} soup;

static ix_obj *read_itd(ix_ctx *ctx, const char *text)
{
    ix_obj *o;

    ASSERT_OK(ctx, ix__itd_read(ctx, "t", text, strlen(text), &o));
    return o;
}

/* Single precision, exactly. */
static void widen(int n, const float *x, double *out)
{
    for (int i = 0; i < n; i++)
        out[i] = (double)x[i];
}

static soup parse_text(const char *s)
{
    soup out = {0};
    int k = 0;

    for (; (s = strpbrk(s, "fv")); s++) {
        float x[3];

        if (sscanf(s, "facet normal %f %f %f", x, x + 1, x + 2) == 3) {
            assert_true(k == 0 && out.n < 2000);
            widen(3, x, out.normal[out.n]);
        } else if (sscanf(s, "vertex %f %f %f", x, x + 1, x + 2) == 3) {
            widen(3, x, out.v[out.n][k]);
            k = (k + 1) % 3;
            out.n += k == 0;
        }
    }
    return out;
}

static soup parse_binary(const ix_buf *b)
{
    soup out = {0};
    uint32_t n;

    memcpy(&n, b->data + 80, 4); /* these tests run on little-endian machines */
    assert_int_equal(b->len, 84 + 50 * (size_t)n);
    for (out.n = 0; out.n < (int)n; out.n++) {
        const char *p = b->data + 84 + 50 * (size_t)out.n;
        float x[12];

        memcpy(x, p, sizeof x);
        widen(3, x, out.normal[out.n]);
        for (int k = 0; k < 3; k++)
            widen(3, x + 3 + 3 * k, out.v[out.n][k]);
    }
    return out;
}

static ix_status write_one(ix_buf *b, const char *text, double tol, bool binary)
{
    const ix_write_opts w = {.tol = tol};
    ix_obj *o = read_itd(b->ctx, text);
    ix_status st = (binary ? ix__bstl_write : ix__stl_write)(b, o, &w);

    ix__obj_unref(b->ctx, o);
    return st;
}

/* Distances of the middles of chords from the unit circle, and the
 * flux of (x, y, 0) through the triangles: twice base times height, 4 pi. */
static void check_cylinder(soup *s, double tol)
{
    double flux = 0;

    assert_true(s->n > 20);
    for (int i = 0; i < s->n; i++) {
        double(*v)[3] = s->v[i];

        for (int k = 0; k < 3; k++) {
            double x = (v[k][0] + v[(k + 1) % 3][0]) / 2.;
            double y = (v[k][1] + v[(k + 1) % 3][1]) / 2.;

            assert_true(1 - hypot(x, y) <= tol + 1e-6); /* single precision */
        }
        for (int c = 0; c < 2; c++) {
            double p[3], q[3];

            for (int a = 0; a < 3; a++) {
                p[a] = v[1][a] - v[0][a];
                q[a] = v[2][a] - v[0][a];
            }
            flux += v[0][c] *
                    (p[(c + 1) % 3] * q[(c + 2) % 3] -
                     p[(c + 2) % 3] * q[(c + 1) % 3]) /
                    2;
        }
        /* normals are radial */
        ASSERT_CLOSE(hypot(s->normal[i][0], s->normal[i][1]), 1, 1e-5);
    }
    assert_true(fabs(flux) <= 4 * acos(-1.) + 1e-4);
    assert_true(fabs(flux) >= 4 * acos(-1.) * (1 - 3 * tol));
}

static void test_cylinder(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (double tol = .05; tol > 1e-4; tol /= 10) {
        soup text, binary;
        ix_buf a, b;

        ix__buf_init(&a, ctx);
        ix__buf_init(&b, ctx);
        ASSERT_OK(ctx, write_one(&a, CYLINDER, tol, false));
        ASSERT_OK(ctx, write_one(&b, CYLINDER, tol, true));
        assert_int_equal(strncmp(a.data, "solid CYL\nfacet", 15), 0);
        text = parse_text(a.data);
        binary = parse_binary(&b);
        assert_int_equal(text.n, binary.n);
        assert_memory_equal(text.v, binary.v, sizeof text.v);
        check_cylinder(&text, tol);
        ix__buf_free(&a);
        ix__buf_free(&b);
    }
    ix_ctx_free(ctx);
}

/* Ears: the areas of the triangles add up to that of the polygon. */
static void test_polygon(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double area = 0;
    ix_buf b;
    soup s;

    (void)state;
    ix__buf_init(&b, ctx);
    ASSERT_OK(ctx, write_one(&b, ELL, 0, true));
    s = parse_binary(&b);
    assert_int_equal(s.n, 4);
    for (int i = 0; i < s.n; i++) {
        double(*v)[3] = s.v[i];
        double a = ((v[1][0] - v[0][0]) * (v[2][1] - v[0][1]) -
                    (v[1][1] - v[0][1]) * (v[2][0] - v[0][0])) /
                   2.;

        assert_true(a >= 0);
        area += a;
    }
    ASSERT_CLOSE(area, 3, 1e-12);
    ix__buf_free(&b);
    ix_ctx_free(ctx);
}

static void test_errors(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_buf b;

    (void)state;
    ix__buf_init(&b, ctx);
    assert_int_equal(write_one(&b, "[OBJECT P [POINT 1 2 3]]", 0, false),
                     IX_EARG);
    assert_int_equal(write_one(&b, CYLINDER, -1, false), IX_EARG);
    assert_int_equal(write_one(&b, CYLINDER, 1e-20, false), IX_EUNABLE);
    ix__buf_free(&b);
    ix_ctx_free(ctx);
}

/* --- every allocation fails ------------------------------------------- */

typedef struct {
    ix_obj *o;
    ix_buf b;
} inputs;

static void make(ix_ctx *c, void *state)
{
    inputs *in = state;

    in->o = read_itd(c, CYLINDER ELL);
    ix__buf_init(&in->b, c);
}

static ix_status work(ix_ctx *c, void *state)
{
    const ix_write_opts w = {.tol = .1};
    inputs *in = state;

    (void)c;
    IX_TRY(ix__bstl_write(&in->b, in->o, &w));
    return ix__stl_write(&in->b, in->o, &w);
}

static void drop(ix_ctx *c, void *state)
{
    inputs *in = state;

    ix__buf_free(&in->b);
    ix__obj_unref(c, in->o);
}

static void test_faults(void **state)
{
    inputs in;
    const ix_fault_case c = {make, work, drop, &in};

    (void)state;
    assert_true(ix_fault_run(&c) >= 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cylinder),
        cmocka_unit_test(test_polygon),
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_faults),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
