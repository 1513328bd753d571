/* STEP files read back by a small parser of the test's own: syntax, every
 * reference resolved, and the curves and surfaces evaluated against what was
 * written; poles and jumps cut away; names and colours. */
#include <stdlib.h>
#include <string.h>

#include "harness/can.h"
#include "harness/fault.h"
#include "harness/randmv.h"
#include "io/export.h"

IX_TEST_FIXTURE(0x57e9u)

/* --- the parser ---------------------------------------------------------- */

/* One line "#n=...;" for each entity: text of entity n. */
static const char *entity(const char *file, long n)
{
    char mark[32];
    const char *p;

    (void)snprintf(mark, sizeof mark, "\n#%ld=", n);
    p = strstr(file, mark);
    if (!p)
        fail_msg("#%ld is not defined", n);
    return p + strlen(mark);
}

/* Parentheses and quotes of a line, and its references. */
static void check_line(const char *file, const char *s)
{
    int depth = 0;
    bool quoted = false;

    for (; *s != '\n'; s++) {
        quoted = quoted != (*s == '\'');
        if (quoted)
            continue;
        depth += (*s == '(') - (*s == ')');
        assert_true(depth >= 0);
        if (*s == '#')
            (void)entity(file, atol(s + 1));
        if (*s == ';')
            assert_true(depth == 0 && s[1] == '\n');
    }
    assert_true(!quoted && depth == 0 && s[-1] == ';');
}

/* Entities are numbered 1, 2, ... in order. */
static void check_file(const char *file)
{
    long n = 1;

    assert_int_equal(strncmp(file, "ISO-10303-21;\nHEADER;\n", 22), 0);
    for (const char *p = strstr(file, "DATA;\n") + 6; *p == '#'; n++) {
        char *end;

        assert_int_equal(strtol(p + 1, &end, 10), n);
        assert_int_equal(*end, '=');
        check_line(file, end + 1);
        p = strchr(p, '\n') + 1;
        if (*p != '#')
            assert_string_equal(p, "ENDSEC;\nEND-ISO-10303-21;\n");
    }
    (void)entity(file, 14);
}

/* Numbers, or the numbers behind '#', of the text up to where the parenthesis
 * that s begins with closes; *s is moved behind it. */
static int numbers(const char **s, double *out)
{
    const char *p = *s;
    int depth = 0, n = 0;
    char *end;

    assert_int_equal(*p, '(');
    do {
        depth += (*p == '(') - (*p == ')');
        if (strchr("(),#", *p)) {
            p++;
            continue;
        }
        assert_true(n < 4000);
        out[n++] = strtod(p, &end);
        assert_true(end > p);
        p = end;
    } while (depth > 0);
    *s = p;
    return n;
}

static double v[4000], pts[4000], knots[2][400], mult[2][400];

/* Knots of one direction from those and their multiplicities. */
static int expand(int n, const double *k, const double *mul, double *out)
{
    int total = 0;

    for (int i = 0; i < n; i++) {
        assert_true(i == 0 || k[i] > k[i - 1]);
        for (int j = 0; j < (int)mul[i]; j++)
            out[total++] = k[i];
    }
    return total;
}

/* The spline of that entity as a multivariate. */
static ix_mv *parse_spline(const char *file, const char *e, int nd)
{
    const char *s = strstr(e, nd == 1 ? "B_SPLINE_CURVE" : "B_SPLINE_SURFACE");
    bool rational = *e == '(';
    static double kv[2][800];
    int degree[2] = {0}, n, nk[2], total;
    ix_dir dir[2];
    ix_mv *m;

    s = strchr(s, '(') + 1;
    if (!rational)
        s = strchr(s, ',') + 1; /* the name */
    for (int d = 0; d < nd; d++) {
        char *end;

        degree[d] = (int)strtol(s, &end, 10);
        s = end + 1;
    }
    n = numbers(&s, v);
    s = rational ? strstr(s, "WITH_KNOTS(") + 11 : strstr(s, ".U.,") + 4;
    for (int k = 0; k < 2 * nd; k++) {
        nk[k % nd] = numbers(&s, k < nd ? mult[k % nd] : knots[k % nd]);
        s++;
    }
    for (int d = 0; d < nd; d++) {
        total = expand(nk[d], knots[d], mult[d], kv[d]);
        dir[d] = (ix_dir){IX_BSPLINE, degree[d] + 1, total - degree[d] - 1,
                          false, kv[d]};
    }
    assert_int_equal(n, dir[0].length * (nd > 1 ? dir[1].length : 1));
    /* u outside: point i, j is number i n1 + j */
    for (int k = 0; k < n; k++) {
        int n1 = nd > 1 ? dir[1].length : 1;
        int at = k / n1 + k % n1 * dir[0].length;
        const char *p = strchr(entity(file, (long)v[k]), ',') + 1;
        double x[3];

        assert_int_equal(numbers(&p, x), 3);
        for (int c = 0; c < 3; c++)
            pts[(c + rational) * n + at] = x[c];
    }
    if (rational) {
        s = strchr(strstr(s, "RATIONAL_B_SPLINE"), '(') + 1;
        assert_int_equal(numbers(&s, v), n);
        for (int k = 0; k < n; k++) {
            int n1 = nd > 1 ? dir[1].length : 1;
            int at = k / n1 + k % n1 * dir[0].length;

            assert_true(v[k] > 0);
            pts[at] = v[k];
            for (int c = 1; c < 4; c++)
                pts[c * n + at] *= v[k];
        }
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, nd, dir, 3, rational, pts, &m));
    return m;
}

/* --- laws ---------------------------------------------------------------- */

static void write_mv(const ix_mv *m, ix_buf *b)
{
    ix_obj *o = ix__obj_mv(ctx, ix__obj_type_of_mv(m), ix_mv_ref(m));

    ix__buf_init(b, ctx);
    ASSERT_OK(ctx, ix__step_write(b, o, NULL));
    ix__obj_unref(ctx, o);
    check_file(b->data);
}

static const char *first_spline(const char *file)
{
    const char *p = strstr(file, "B_SPLINE");

    assert_non_null(p);
    while (p[-1] != '\n')
        p--;
    return strchr(p, '=') + 1;
}

/* Numbers are written exactly, so only conversion and division by weights
 * (0.3 .. 3) round: 1e-11 leaves room for power bases of order 6. */
static void same_points(const ix_mv *m, const ix_mv *q)
{
    for (int i = 0; i < 20; i++) {
        double t[2], x[IX_MAX_COORDS], y[3];

        ix_mv_randparam(&rng, m, t);
        ASSERT_OK(ctx, ix_mv_point(ctx, m, t, x));
        ASSERT_OK(ctx, ix_mv_point(ctx, q, t, y));
        for (int c = 0; c < 3; c++)
            ASSERT_CLOSE(y[c], c < ix_mv_ncoords(m) ? x[c] : 0, 1e-11);
    }
}

static void test_random(void **state)
{
    (void)state;
    for (int i = 0; i < 60; i++) {
        const ix_rand_opts o = {.ndirs = 1 + i % 2,
                                .min_order = 2,
                                .kinds = IX_RAND_BEZIER | IX_RAND_OPEN |
                                         IX_RAND_FLOAT | IX_RAND_PERIODIC};
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o), *q;
        ix_buf b;

        write_mv(m, &b);
        q = parse_spline(b.data, first_spline(b.data), o.ndirs);
        same_points(m, q);
        ix_mv_unref(ctx, q);
        ix_mv_unref(ctx, m);
        ix__buf_free(&b);
    }
}

static int count(const char *s, const char *word)
{
    int n = 0;

    for (; (s = strstr(s, word)); s++)
        n++;
    return n;
}

static ix_status write_itd(ix_buf *b, const char *text)
{
    ix_obj *o;
    ix_status st;

    ASSERT_OK(ctx, ix__itd_read(ctx, "t", text, strlen(text), &o));
    ix__buf_init(b, ctx);
    st = ix__step_write(b, o, NULL);
    ix__obj_unref(ctx, o);
    return st;
}

/* A jump makes two curves; order 1 becomes a straight point of degree 1. */
static void test_jumps(void **state)
{
    ix_buf b;

    (void)state;
    ASSERT_OK(ctx, write_itd(&b, "[OBJECT [COLOR 4] A'B [CURVE BSPLINE 4 2 E2 "
                                 "[KV 0 0 1 1 2 2][0 0][1 0][1 1][2 1]]]"));
    check_file(b.data);
    assert_int_equal(count(b.data, "=B_SPLINE_CURVE_WITH_KNOTS('A''B',1,"), 2);
    assert_int_equal(count(b.data, "COLOUR_RGB('',1.,0.,0.)"), 2);
    assert_int_equal(count(b.data, "GEOMETRIC_CURVE_SET("), 1);
    ix__buf_free(&b);
    ASSERT_OK(ctx, write_itd(&b, "[OBJECT S [SURFACE BSPLINE 2 2 1 2 E3 "
                                 "[KV 0 1 2][KV 0 0 1 1]"
                                 "[0 0 0][1 0 0][0 1 0][1 1 0]]]"));
    check_file(b.data);
    assert_int_equal(count(b.data, "=B_SPLINE_SURFACE_WITH_KNOTS("), 2);
    ix__buf_free(&b);
}

/* x = 1 / (t - 1/2): pieces on both sides, weights positive, ends at 1/64 of
 * the largest weight. */
static void test_poles(void **state)
{
    ix_buf b;
    int n;

    (void)state;
    ASSERT_OK(ctx, write_itd(&b, "[OBJECT P [CURVE BEZIER 2 P2 [-.5 1 0]"
                                 "[.5 1 0]]]"));
    check_file(b.data);
    n = count(b.data, "RATIONAL_B_SPLINE_CURVE(");
    assert_true(n >= 2 && n <= 12);
    assert_null(strstr(b.data, "RATIONAL_B_SPLINE_CURVE((-"));
    for (const char *s = strstr(b.data, "DATA;"); (s = strstr(s, "=(BOUNDED"));
         s++) {
        ix_mv *q = parse_spline(b.data, s + 1, 1);
        double dom[2], t, x[3];

        ix_mv_domain(q, 0, dom);
        assert_true(dom[1] < .5 || dom[0] > .5);
        t = (dom[0] + dom[1]) / 2;
        ASSERT_OK(ctx, ix_mv_point(ctx, q, &t, x));
        ASSERT_CLOSE(x[0], 1 / (t - .5), 1e-12);
        ix_mv_unref(ctx, q);
    }
    ix__buf_free(&b);
}

static void test_other_shapes(void **state)
{
    ix_buf b;

    (void)state;
    ASSERT_OK(ctx, write_itd(&b, "[OBJECT A [POINT 1 2e-7 3e30]]"
                                 "[OBJECT L [POLYLINE 2 [0 0 0][1 0 0]]]"
                                 "[OBJECT L [POLYGON 3 [0 0 0][1 0 0][0 1 0]]]"
                                 "[OBJECT N [NUMBER 3]]"));
    check_file(b.data);
    assert_int_equal(count(b.data, "CARTESIAN_POINT('',(1.,2.E-07,3.E+30))"),
                     1);
    assert_int_equal(count(b.data, "POLYLINE("), 2);
    ix__buf_free(&b);
    assert_int_equal(write_itd(&b, "[OBJECT N [NUMBER 3]]"), IX_EARG);
    ix__buf_free(&b);
}

#define SQUARE                                                      \
    "[TRIMCRV [TRIMCRVSEG [CURVE BSPLINE 5 2 E2 [KV 0 0 1 2 3 4 4]" \
    "[0 0][1 0][1 1][0 1][0 0]]]]"
#define HOLE                                                        \
    "[TRIMCRV [TRIMCRVSEG [CURVE BEZIER 4 E2 [.3 .5][.3 .7][.7 .7]" \
    "[.7 .5]]][TRIMCRVSEG [CURVE BEZIER 4 E2 [.7 .5][.7 .3][.3 .3]" \
    "[.3 .5]]]]"
#define TRIMMED(points) \
    "[OBJECT T [TRIMSRF [SURFACE BEZIER 2 2 " points "]" SQUARE HOLE "]]"
#define PLAIN "E3 [0 0 0][4 0 0][0 4 0][4 4 1]"

/* Entities that begin with a word. */
static int entities(const char *file, const char *word)
{
    char mark[64];

    (void)snprintf(mark, sizeof mark, "=%s(", word);
    return count(file, mark);
}

typedef struct {
    const char *keyword;
    int n;
} tally;

static void has_entities(const char *text, const tally *want)
{
    for (; want->keyword; want++)
        assert_int_equal(entities(text, want->keyword), want->n);
}

/* A square outline, cut at its corners, and a hole of two curves. */
static void test_trimmed(void **state)
{
    static const tally want[] = {
        {"ADVANCED_FACE", 1}, {"FACE_OUTER_BOUND", 1}, {"FACE_BOUND", 1},
        {"EDGE_CURVE", 6},    {"VERTEX_POINT", 6},     {"PCURVE", 6},
        {"OPEN_SHELL", 1},    {"GEOMETRIC_SET", 0},    {NULL, 0}};
    ix_buf b;

    (void)state;
    ASSERT_OK(ctx, write_itd(&b, TRIMMED(PLAIN)));
    check_file(b.data);
    has_entities(b.data, want);
    /* v is quadratic, so u v has degree 5; along the border reduced to 1 */
    assert_int_equal(count(b.data, "B_SPLINE_CURVE_WITH_KNOTS('T',5,"), 2);
    assert_int_equal(count(b.data, "B_SPLINE_CURVE_WITH_KNOTS('T',1,"), 8);
    ix__buf_free(&b);
}

static void test_model(void **state)
{
    static const tally want[] = {
        {"ADVANCED_FACE", 3},       {"EDGE_CURVE", 3},
        {"SEAM_CURVE", 1},          {"VERTEX_POINT", 2},
        {"ORIENTED_EDGE", 6},       {"CLOSED_SHELL", 1},
        {"GEOMETRIC_CURVE_SET", 1}, {NULL, 0}};
    ix_buf b;

    (void)state;
    ASSERT_OK(ctx, write_itd(&b, "[OBJECT M " CAN
                                 "][OBJECT P [CURVE BEZIER 2 E3 [0 0 0]"
                                 "[1 1 1]]]"));
    check_file(b.data);
    has_entities(b.data, want);
    ix__buf_free(&b);
}

/* Poles of a trimmed surface; a trimming curve that leaves the domain. */
static void test_not_trimmed(void **state)
{
    ix_buf b;

    (void)state;
    assert_int_equal(
        write_itd(&b, TRIMMED("P3 [1 0 0 0][-1 4 0 0][1 0 4 0][1 4 4 1]")),
        IX_EUNABLE);
    ix__buf_free(&b);
    assert_int_equal(
        write_itd(&b, "[OBJECT T [TRIMSRF [SURFACE BSPLINE 2 2 2 2 E3"
                      "[KV 0 0 1 1][KV 0 0 1 1] [0 0 0][4 0 0][0 4 0][4 4 1]]"
                      "[TRIMCRV [TRIMCRVSEG [CURVE BEZIER 3 E2 [.5 .5][9 .5]"
                      "[.5 .5]]]]]]"),
        IX_EUNABLE);
    ix__buf_free(&b);
}

/* The same for OBJ: elements and their indices. */
static void test_obj(void **state)
{
    static const char text[] =
        "[OBJECT [RGB \"255,0,0\"] S [SURFACE BEZIER 2 2 E3 [0 0 0][1 0 0]"
        "[0 1 0][1 1 0]]][OBJECT C [CURVE BEZIER 2 E3 [0 0 0][1 0 0]]]"
        "[OBJECT P [POINT 7 8 9]][OBJECT Q [POLYGON 3 [0 0 0][1 0 0][0 1 0]]]";
    ix_obj *o;
    ix_buf b;

    (void)state;
    ix__buf_init(&b, ctx);
    ASSERT_OK(ctx, ix__itd_read(ctx, "t", text, strlen(text), &o));
    ASSERT_OK(ctx, ix__obj_file_write(&b, o, NULL));
    assert_string_equal(
        b.data, "# iritx\no S\n# color 1 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                "v 1 1 0\nf 1 2 4\nf 1 4 3\no C\nv 0 0 0\nv 1 0 0\nl 5 6\n"
                "o P\nv 7 8 9\np 7\no Q\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                "f 8 9 10\n");
    ix__buf_free(&b);
    ix__obj_unref(ctx, o);
}

/* --- every allocation fails ------------------------------------------- */

typedef struct {
    ix_obj *o;
    ix_buf b;
} inputs;

static void make(ix_ctx *c, void *state)
{
    static const char text[] =
        "[OBJECT P [CURVE BEZIER 2 P2 [-.5 1 0][.5 1 0]]]"
        "[OBJECT [COLOR 4] A [CURVE BSPLINE 4 2 E2 "
        "[KV 0 0 1 1 2 2][0 0][1 0][1 1][2 1]]]" TRIMMED(PLAIN);
    inputs *in = state;

    ASSERT_OK(c, ix__itd_read(c, "t", text, strlen(text), &in->o));
    ix__buf_init(&in->b, c);
}

static ix_status work(ix_ctx *c, void *state)
{
    inputs *in = state;

    (void)c;
    IX_TRY(ix__step_write(&in->b, in->o, NULL));
    return ix__obj_file_write(&in->b, in->o, NULL);
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
    assert_true(ix_fault_run(&c) > 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random),      cmocka_unit_test(test_jumps),
        cmocka_unit_test(test_poles),       cmocka_unit_test(test_other_shapes),
        cmocka_unit_test(test_trimmed),     cmocka_unit_test(test_model),
        cmocka_unit_test(test_not_trimmed), cmocka_unit_test(test_obj),
        cmocka_unit_test(test_faults),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
