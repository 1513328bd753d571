/* Curves of n - 1 equations in n unknowns: numbers of ovals and arcs known,
 * every boundary point an end of exactly one arc, every vertex on the curve. */
#include "harness/fault.h"
#include "harness/randmv.h"
#include "solvetest.h"

IX_TEST_FIXTURE(20260713)

typedef struct {
    const char *name;
    const char *eq;
    double lo, hi;           /* of both variables */
    int loops, arcs, points; /* points: singular ones */
    int ends;                /* arc ends at all singular points together */
} plane_case;

static void fill(double (*box)[2], double lo, double hi)
{
    for (int j = 0; j < 6; j++) {
        box[j][0] = lo;
        box[j][1] = hi;
    }
}

static ix_solution_curves trace_text(int n, int neq, const char *const *text,
                                     double (*box)[2], const ix_curves_opts *o)
{
    ix_equation eq[6] = {{NULL, 0, IX_EQUAL_ZERO}};
    ix_solution_curves s;
    ix_mv *m[6];

    for (int i = 0; i < neq; i++) {
        m[i] = st_mv(ctx, text[i], n, box);
        eq[i] = (ix_equation){m[i], 0, IX_EQUAL_ZERO};
    }
    ASSERT_OK(ctx, ix_solve_curves(ctx, neq, eq, o, &s));
    for (int i = 0; i < neq; i++)
        ix_mv_unref(ctx, m[i]);
    return s;
}

static void vertex(double (*box)[2], int n, const double *t, double *x)
{
    for (int j = 0; j < n; j++)
        x[j] = box[j][0] + t[j] * (box[j][1] - box[j][0]);
}

/* Law: vertices annul the text; loops close; ends are what they are said to
 * be. */
static void check_curves(const char *name, int n, int neq,
                         const char *const *text, double (*box)[2],
                         const ix_solution_curves *s)
{
    for (int i = 0; i < s->ncurves; i++) {
        const ix_solution_curve *c = &s->curve[i];

        assert_true(c->n >= 2);
        for (int k = 0; k < c->n; k++) {
            double x[6];

            vertex(box, n, c->x + k * n, x);
            for (int e = 0; e < neq; e++) /* 50 roundings of the largest */
                if (!(fabs(st_value(text[e], x)) <=
                      1e-14 * st_size(text[e], box, n)))
                    fail_msg("%s: curve %d vertex %d: %g", name, i, k,
                             st_value(text[e], x));
        }
        if (c->start == IX_END_CLOSED)
            for (int j = 0; j < n; j++)
                assert_true(c->x[j] == c->x[(c->n - 1) * n + j]);
        for (int e = 0; e < 2; e++) {
            const double *p = c->x + (e ? (c->n - 1) * n : 0);
            int edge = 0;

            for (int j = 0; j < n; j++)
                edge |= p[j] < 1e-8 || p[j] > 1 - 1e-8;
            if ((e ? c->end : c->start) == IX_END_BOUNDARY)
                assert_true(edge);
            if ((e ? c->end : c->start) == IX_END_OPEN)
                fail_msg("%s: curve %d ends nowhere", name, i);
        }
    }
}

static void counts(const ix_solution_curves *s, int *loops, int *arcs,
                   int *ends)
{
    *loops = *arcs = *ends = 0;
    for (int i = 0; i < s->ncurves; i++) {
        *loops += s->curve[i].start == IX_END_CLOSED;
        *arcs += s->curve[i].start != IX_END_CLOSED;
    }
    for (int i = 0; i < s->nsingular; i++)
        *ends += s->arcs[i];
}

static void run_plane(const plane_case *c)
{
    int loops, arcs, ends;
    ix_solution_curves s;
    double box[6][2];

    fill(box, c->lo, c->hi);
    s = trace_text(2, 1, &c->eq, box, NULL);
    counts(&s, &loops, &arcs, &ends);
    print_message("# %s: %zu cells, %d loops, %d arcs, %d singular (%d ends)\n",
                  c->name, s.boxes, loops, arcs, s.nsingular, ends);
    if (loops != c->loops || arcs != c->arcs || s.nsingular != c->points ||
        ends != c->ends)
        fail_msg("%s: expected %d loops, %d arcs, %d singular (%d ends)",
                 c->name, c->loops, c->arcs, c->points, c->ends);
    check_curves(c->name, 2, 1, &c->eq, box, &s);
    assert_true(s.complete);
    ix_solution_curves_free(ctx, &s);
}

static void regular(void **state)
{
    static const plane_case cases[] = {
        {"circle", "x^2 + y^2 - 1", -2.1, 2.3, 1, 0, 0, 0},
        {"circle on dyadic cuts", "x^2 + y^2 - 1", -2, 2, 1, 0, 0, 0},
        {"none", "x^2 + y^2 + 1", -2.1, 2.3, 0, 0, 0, 0},
        {"line", "x + 0.3*y - 0.1", -1, 1, 0, 1, 0, 0},
        {"diagonal", "x - y", -1, 1, 0, 1, 0, 0},
        {"hyperbola", "x*y - 0.01", -1, 1, 0, 2, 0, 0},
        {"loop of 1e-4", "(x - 0.3)^2 + (y + 0.2)^2 - 0.00000001", -1, 1, 1, 0,
         0, 0},
        {"loop of 1e-5", "(x - 0.3)^2 + (y + 0.2)^2 - 0.0000000001", -1, 1, 1,
         0, 0, 0},
        {"nearly a node", "x*y - 0.00000001", -1, 1, 0, 2, 0, 0},
        {"four ovals", "(x^2 + 4*y^2 - 4)*(4*x^2 + y^2 - 4) + 0.5", -3.1, 3.3,
         4, 0, 0, 0},
        {"two nested ovals", "(x^2 + y^2 - 1)*(x^2 + y^2 - 2) - 0.01", -3.1,
         3.3, 2, 0, 0, 0},
        {"cubic with oval", "y^2 - x^3 + x", -2.1, 2.3, 1, 1, 0, 0}};

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        run_plane(&cases[i]);
}

/* Three ellipses turned by 60 degrees cut the plane into a middle, 6 regions
 * inside two of them, 6 tips and the outside: one oval in each region of one
 * sign when the sextic is disturbed by a constant. */
static void ellipses(void **state)
{
#define STAR                                               \
    "(x^2 + 16*y^2 - 4)*"                                  \
    "(12.25*x^2 + 4.75*y^2 - 12.990381056766578*x*y - 4)*" \
    "(12.25*x^2 + 4.75*y^2 + 12.990381056766578*x*y - 4)"
    static const plane_case cases[] = {
        {"7 ovals inside", STAR " + 1", -2.6, 2.7, 7, 0, 0, 0},
        {"6 ovals and one around", STAR " - 1", -2.6, 2.7, 7, 0, 0, 0},
        {"close to 12 nodes", STAR " - 0.0001", -2.6, 2.7, 7, 0, 0, 0},
        {"12 nodes", STAR, -2.6, 2.7, 0, 24, 12, 48}};

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        run_plane(&cases[i]);
}

static void singular(void **state)
{
    static const plane_case cases[] = {
        {"isolated point", "x^2 + y^2", -1.1, 1.3, 0, 0, 1, 0},
        {"isolated point of a cubic", "y^2 - x^2*(x - 1)", -2.1, 2.3, 0, 1, 1,
         0},
        {"node", "y^2 - x^2*(x + 1)", -2.1, 2.3, 0, 3, 1, 4},
        {"crossing lines", "x*y", -1.1, 1.3, 0, 4, 1, 4},
        {"two isolated points", "(x^2 - 0.25)^2 + y^2", -1.1, 1.3, 0, 0, 2, 0},
        {"trifolium", "(x^2 + y^2)^2 - x^3 + 3*x*y^2", -1.1, 1.3, 0, 3, 1, 6},
        {"four leaves", "(x^2 + y^2)^3 - 4*x^2*y^2", -1.1, 1.3, 0, 4, 1, 8},
        {"astroid", "(x^2 + y^2 - 1)^3 + 27*x^2*y^2", -1.1, 1.3, 0, 4, 4, 8},
        {"lemniscate", "(x^2 + y^2)^2 - x^2 + y^2", -1.1, 1.3, 0, 2, 1, 4},
        {"cusp", "y^2 - x^3", -1.1, 1.3, 0, 2, 1, 2},
        {"two circles that touch", "(x^2 + y^2 - 1)*((x - 3)^2 + y^2 - 4)",
         -2.1, 5.3, 0, 2, 1, 4}};

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        run_plane(&cases[i]);
}

/* On the boundary of the domain. */
static void boundary(void **state)
{
    static const plane_case cases[] = {
        {"touches all sides", "x^2 + y^2 - 1", -1, 1, 1, 0, 0, 0},
        {"along a side", "(x + 1)*(y - 0.3)", -1, 1, 0, 3, 1, 3},
        {"along a side, twice", "(x + 1)^2*(y - 0.3)", -1, 1, 0, 3, 1, 3},
        {"along two sides, often", "(x + 1)^3*(y - 1)^2*(y - 0.3)", -1, 1, 0, 4,
         2, 5},
        {"through corners", "x + y", -1, 1, 0, 1, 0, 0},
        {"leaves and returns", "y - 2.2*x^2 + 1.05", -1, 1, 0, 2, 0, 0}};

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        run_plane(&cases[i]);
}

/* Two patches that meet in nothing but a common edge, and in one along which
 * their domains end and go on: u and v of the one, s and t of the other. */
static void common_edge(void **state)
{
    static const struct {
        const char *eq[3];
        double knot; /* of y and w, at the edge; 0: none */
    } cases[] = {
        {{"x - z", "x^3 - x^2 + y - z^3 + z^2 + w", "y*(x + 1) - 2*w"}, 0},
        {{"x - z + w", "x^3 + y - z^3", "y*(x - 3) - w - w^2"}, 0},
        {{"x - z", "x^3 + y - 0.5 - z^3 + w - 0.5", "(y - 0.5)*(x + 1)"}, 0.5}};

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        ix_equation eq[3] = {{NULL, 0, IX_EQUAL_ZERO}};
        ix_solution_curves s;
        double box[6][2];

        fill(box, 0, 1);
        for (int k = 0; k < 3; k++) {
            ix_mv *m = st_mv(ctx, cases[i].eq[k], 4, box), *b;

            ASSERT_OK(ctx, ix_mv_to_bspline(ctx, m, &b));
            ix_mv_unref(ctx, m);
            for (int j = 1; cases[i].knot > 0 && j < 4; j += 2) {
                ASSERT_OK(ctx,
                          ix_mv_insert_knots(ctx, b, j, 1, &cases[i].knot, &m));
                ix_mv_unref(ctx, b);
                b = m;
            }
            eq[k] = (ix_equation){b, 0, IX_EQUAL_ZERO};
        }
        ASSERT_OK(ctx, ix_solve_curves(ctx, 3, eq, NULL, &s));
        print_message("# common edge %zu: %zu cells\n", i, s.boxes);
        assert_true(s.complete);
        assert_int_equal(s.nsingular, 0);
        assert_int_equal(s.ncurves, 1);
        assert_int_equal(s.curve[0].start, IX_END_BOUNDARY);
        assert_int_equal(s.curve[0].end, IX_END_BOUNDARY);
        assert_true(s.boxes < 1000);
        for (int k = 0; k < s.curve[0].n; k++) {
            const double *x = s.curve[0].x + 4 * k;

            assert_true(fabs(x[1] - cases[i].knot) <= 0 &&
                        fabs(x[3] - cases[i].knot) <= 0);
            assert_true(fabs(x[0] - x[2]) <= 1e-14);
        }
        /* all of it, from 0 to 1 */
        assert_true(
            fabs(s.curve[0].x[0] - s.curve[0].x[4 * (s.curve[0].n - 1)]) >= 1);
        ix_solution_curves_free(ctx, &s);
        for (int k = 0; k < 3; k++)
            ix_mv_unref(ctx, eq[k].f);
    }
}

/* Law: with an image, chords are within tol of it in space, too: the line
 * x = 0.25 of the unit square as the parabola (y, 2 (y - 0.5)^2). */
static void image(void **state)
{
    double box[6][2],
        pts[2 * 6] = {0, 0, 0.5, 0.5, 1, 1, 0.5, 0.5, -0.5, -0.5, 0.5, 0.5};
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 2, .length = 2},
                         {.basis = IX_BEZIER, .order = 3, .length = 3}};
    ix_curves_opts o = {.tol = 1e-4};
    ix_solution_curves s;
    ix_equation eq;
    ix_mv *f, *m;

    (void)state;
    fill(box, 0, 1);
    f = st_mv(ctx, "x - 0.25", 2, box);
    eq = (ix_equation){f, 0, IX_EQUAL_ZERO};
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 2, false, pts, &m));
    o.image = m;
    ASSERT_OK(ctx, ix_solve_curves(ctx, 1, &eq, &o, &s));
    assert_int_equal(s.ncurves, 1);
    assert_true(s.curve[0].n > 30 && s.curve[0].n < 200);
    for (int i = 1; i < s.curve[0].n; i++) {
        double h = s.curve[0].x[2 * i + 1] - s.curve[0].x[2 * i - 1];

        assert_true(fabs(h) > 0);
        assert_true(h * h / 2 <= 1e-4); /* a chord of 2 y^2 is off by that */
    }
    ix_solution_curves_free(ctx, &s);
    o.image_at = 1;
    assert_int_equal(ix_solve_curves(ctx, 1, &eq, &o, &s), IX_EARG);
    ix_mv_unref(ctx, f);
    ix_mv_unref(ctx, m);
}

/* A closed curve that a knot line follows, or cuts in its vertices. */
static void knot_lines(void **state)
{
    double box[6][2];

    (void)state;
    fill(box, -2, 2);
    for (int k = 0; k < 3; k++) {
        static const double at[3][2] = {{0.25, 0.75}, {0.5, 0.6}, {0.3, 0.8}};
        ix_mv *m = st_mv(ctx, k == 2 ? "x - 0.4" : "x^2 + y^2 - 1", 2, box);
        ix_equation eq = {NULL, 0, IX_EQUAL_ZERO};
        double kv[2] = {at[k][0], at[k][1]};
        ix_solution_curves s;
        ix_mv *b;

        if (k == 2)
            kv[0] = 0.6; /* x = 0.4: the line itself */
        ASSERT_OK(ctx, ix_mv_to_bspline(ctx, m, &b));
        ix_mv_unref(ctx, m);
        for (int j = 0; j < 2; j++) {
            ASSERT_OK(ctx, ix_mv_insert_knots(ctx, b, j, 2, kv, &m));
            ix_mv_unref(ctx, b);
            b = m;
        }
        eq.f = b;
        ASSERT_OK(ctx, ix_solve_curves(ctx, 1, &eq, NULL, &s));
        assert_int_equal(s.ncurves, 1);
        assert_int_equal(s.nsingular, 0);
        assert_int_equal(s.curve[0].start,
                         k == 2 ? IX_END_BOUNDARY : IX_END_CLOSED);
        ix_solution_curves_free(ctx, &s);
        ix_mv_unref(ctx, b);
    }
}

typedef struct {
    const char *name;
    int n;
    const char *eq[3];
    double lo, hi;
    int loops, arcs;
} space_case;

static void more_unknowns(void **state)
{
    static const space_case cases[] = {
        {"sphere and cylinder",
         3,
         {"x^2 + y^2 + z^2 - 4", "(x - 0.3)^2 + y^2 - 1"},
         -2.6,
         2.7,
         2,
         0},
        {"sphere and plane",
         3,
         {"x^2 + y^2 + z^2 - 1", "x + 2*y - z - 0.3"},
         -1.6,
         1.7,
         1,
         0},
        {"sphere cut by the domain",
         3,
         {"x^2 + y^2 + z^2 - 1", "x - 0.5*y"},
         -0.8,
         0.85,
         0,
         4},
        {"two graphs with three loops",
         4,
         {"x - z", "y - w",
          "(x^2 + y^2 - 0.04)*((x - 0.6)^2 + (y - 0.1)^2 - 0.01)*"
          "((x + 0.5)^2 + (y + 0.4)^2 - 0.02)"},
         -1.1,
         1.2,
         3,
         0},
        {"two bicubic patches, two loops and six arcs",
         4,
         {"x - z", "y - w",
          "(4*x^3 - 3*x)*(4*y^3 - 3*y) - 1 + (4*z^3 - 3*z)*(4*w^3 - 3*w)"},
         -1,
         1,
         2,
         6},
        {"four unknowns, no graph",
         4,
         {"x^2 + y^2 - 1 + 0.1*z", "z^2 + w^2 - 1 + 0.1*x", "x - 0.5*z - 0.1"},
         -1.4,
         1.5,
         0,
         0},
        {"an arc in a face of the domain",
         3,
         {"z*(x + 2)", "y - x^2"},
         0,
         1,
         0,
         1},
        {"a loop in a face of the domain",
         3,
         {"z + 0.5*z*x", "(x - 0.5)^2 + (y - 0.4)^2 - 0.09"},
         0,
         1,
         1,
         0},
        {"an arc in two faces",
         4,
         {"y*(1 + x)", "w + y*z", "x - 0.8*z^2 - 0.1 + w"},
         0,
         1,
         0,
         1}};

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const space_case *c = &cases[i];
        int loops, arcs, ends;
        ix_solution_curves s;
        double box[6][2];

        fill(box, c->lo, c->hi);
        s = trace_text(c->n, c->n - 1, c->eq, box, NULL);
        counts(&s, &loops, &arcs, &ends);
        print_message("# %s: %zu cells, %d loops, %d arcs\n", c->name, s.boxes,
                      loops, arcs);
        check_curves(c->name, c->n, c->n - 1, c->eq, box, &s);
        assert_int_equal(s.nsingular, 0);
        if (i < 5 && (loops != c->loops || arcs != c->arcs))
            fail_msg("%s: expected %d loops, %d arcs", c->name, c->loops,
                     c->arcs);
        ix_solution_curves_free(ctx, &s);
    }
}

/* Law: the ends of arcs on the domain's boundary are the zeros there. */
static void boundary_roots(void **state)
{
    (void)state;
    for (int round = 0; round < 40; round++) {
        const ix_rand_opts o = {.ndirs = 2,
                                .ncoords = 1,
                                .rational = -1,
                                .kinds = round % 2 ? IX_RAND_OPEN
                                                   : IX_RAND_BEZIER,
                                .min_order = 4,
                                .max_order = 5,
                                .max_knots = round % 2 ? 2 : -1,
                                .unit = true};
        ix_mv *m = ix_mv_randtest(ctx, &rng, &o);
        ix_equation eq = {m, 0, IX_EQUAL_ZERO};
        ix_solution_curves s;
        int ends = 0, roots = 0;

        ASSERT_OK(ctx, ix_solve_curves(ctx, 1, &eq, NULL, &s));
        for (int i = 0; i < s.ncurves; i++) {
            ends += s.curve[i].start == IX_END_BOUNDARY;
            ends += s.curve[i].end == IX_END_BOUNDARY;
            assert_int_not_equal(s.curve[i].start, IX_END_OPEN);
            assert_int_not_equal(s.curve[i].end, IX_END_OPEN);
        }
        for (int side = 0; side < 4; side++) {
            ix_root *r;
            ix_mv *c;
            int n;

            ASSERT_OK(ctx, ix_mv_fix(ctx, m, side / 2, side % 2, &c));
            ASSERT_OK(ctx, ix_roots(ctx, c, 0, NULL, &r, &n));
            roots += n;
            ix_roots_free(ctx, r, n);
            ix_mv_unref(ctx, c);
        }
        if (ends != roots)
            fail_msg("round %d: %d ends, %d zeros on the boundary", round, ends,
                     roots);
        ix_solution_curves_free(ctx, &s);
        ix_mv_unref(ctx, m);
    }
}

static void errors(void **state)
{
    ix_curves_opts few = {.max_boxes = 5};
    const char *const text[] = {"x^2 + y^2 - 1", "x - y"};
    static const volatile int stop = 1;
    double box[6][2];
    ix_equation eq[2];
    ix_solution_curves s;
    ix_mv *m[2];

    (void)state;
    fill(box, -2.1, 2.3);
    for (int i = 0; i < 2; i++) {
        m[i] = st_mv(ctx, text[i], 2, box);
        eq[i] = (ix_equation){m[i], 0, IX_EQUAL_ZERO};
    }
    assert_int_equal(ix_solve_curves(ctx, 2, eq, NULL, &s), IX_EARG);
    ASSERT_OK(ctx, ix_solve_curves(ctx, 1, eq, &few, &s));
    assert_false(s.complete);
    assert_true(s.nsingular > 0);
    ix_solution_curves_free(ctx, &s);
    ix_ctx_set_cancel(ctx, &stop);
    assert_int_equal(ix_solve_curves(ctx, 1, eq, NULL, &s), IX_ECANCEL);
    few = (ix_curves_opts){.keep = true};
    ASSERT_OK(ctx, ix_solve_curves(ctx, 1, eq, &few, &s));
    assert_true(s.interrupted);
    assert_false(s.complete);
    assert_int_equal(s.nsingular, 1);
    assert_true(s.singular[0].lo[0] <= 0 && s.singular[0].hi[1] >= 1);
    ix_solution_curves_free(ctx, &s);
    ix_ctx_set_cancel(ctx, NULL);
    for (int i = 0; i < 2; i++)
        ix_mv_unref(ctx, m[i]);
}

/* Powers of functions: the number of curves by how often they count, and of
 * points where they meet others. Vertices are zeros of what is raised to a
 * power, to the accuracy that its square leaves. */
static void powers(void **state)
{
    static const struct {
        const char *eq, *factor[2];
        int times[2]; /* of the factors */
        int curves[2], points;
    } cases[] = {
        {"(x^2 + y^2 - 1)^2", {"x^2 + y^2 - 1", NULL}, {2, 0}, {1, 0}, 0},
        {"(x^2 + y^2 - 1)^3", {"x^2 + y^2 - 1", NULL}, {3, 0}, {1, 0}, 0},
        {"(x^2 - y)^4", {"x^2 - y", NULL}, {4, 0}, {1, 0}, 0},
        {"(x - y)^2", {"x - y", NULL}, {2, 0}, {1, 0}, 0},
        {"(x^2 + y^2 - 1)^2*(x - 0.3)",
         {"x^2 + y^2 - 1", "x - 0.3"},
         {2, 1},
         {2, 3},
         2},
        {"(x*y - 0.1)^2*(x + y - 0.2)^3",
         {"x*y - 0.1", "x + y - 0.2"},
         {2, 3},
         {2, 1},
         0},
        /* contacts, a cusp and a point are none of it */
        {"y^2 - x^4", {"y - x^2", "y + x^2"}, {1, 1}, {2, 2}, 1},
        {"y^2 - x^6", {"y - x^3", "y + x^3"}, {1, 1}, {2, 2}, 1},
        {"(x^2 + y^2)^2", {"x^2 + y^2", NULL}, {2, 0}, {0, 0}, 1}};

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *eq[1] = {cases[i].eq};
        int found[2] = {0, 0};
        ix_solution_curves s;
        double box[6][2];

        fill(box, -1.2, 1.3);
        s = trace_text(2, 1, eq, box, NULL);
        print_message("# %s: %zu cells\n", eq[0], s.boxes);
        assert_true(s.complete);
        assert_int_equal(s.nsingular, cases[i].points);
        for (int k = 0; k < s.ncurves; k++) {
            const ix_solution_curve *c = &s.curve[k];
            double x[2], value[2];
            int f;

            assert_true(c->start != IX_END_OPEN && c->end != IX_END_OPEN);
            vertex(box, 2, c->x + 2 * (c->n / 2), x);
            for (f = 0; f < 2; f++)
                value[f] = cases[i].factor[f]
                               ? fabs(st_value(cases[i].factor[f], x))
                               : HUGE_VAL;
            f = value[1] < value[0];
            found[f]++;
            assert_int_equal(c->times, cases[i].times[f]);
            for (int v = 0; v < c->n; v++) {
                vertex(box, 2, c->x + 2 * v, x);
                assert_true(fabs(st_value(cases[i].factor[f], x)) < 1e-9);
            }
        }
        assert_int_equal(found[0], cases[i].curves[0]);
        assert_int_equal(found[1], cases[i].curves[1]);
        ix_solution_curves_free(ctx, &s);
    }
}

/* Surfaces that touch along a curve, in more unknowns: said soon, the curve is
 * in the singular boxes. */
static void multiple_components(void **state)
{
    static const struct {
        int n;
        const char *eq[2];
    } cases[] = {{3, {"x^2 + y^2 - 1", "x^2 + y^2 + z^2 - 1"}},
                 {3, {"x^2 + y^2 + z - 1", "(x^2 + y^2 + z - 1)*y"}}};

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        ix_solution_curves s;
        double box[6][2];

        fill(box, -1.2, 1.3);
        s = trace_text(cases[i].n, cases[i].n - 1, cases[i].eq, box, NULL);
        print_message("# %s, ...: %zu cells\n", cases[i].eq[0], s.boxes);
        assert_true(s.crowded);
        assert_false(s.complete);
        assert_true(s.boxes < 20000);
        for (int k = 0; k < 100; k++) {
            double t[3] = {(cos(k) + 1.2) / 2.5, (sin(k) + 1.2) / 2.5,
                           1.2 / 2.5};
            int hit = 0;

            for (int b = 0; b < s.nsingular && !hit; b++) {
                hit = 1;
                for (int j = 0; j < cases[i].n; j++)
                    hit &= t[j] >= s.singular[b].lo[j] &&
                           t[j] <= s.singular[b].hi[j];
            }
            assert_true(hit);
        }
        ix_solution_curves_free(ctx, &s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(regular),
                                       cmocka_unit_test(ellipses),
                                       cmocka_unit_test(singular),
                                       cmocka_unit_test(boundary),
                                       cmocka_unit_test(common_edge),
                                       cmocka_unit_test(image),
                                       cmocka_unit_test(knot_lines),
                                       cmocka_unit_test(more_unknowns),
                                       cmocka_unit_test(boundary_roots),
                                       cmocka_unit_test(errors),
                                       cmocka_unit_test(powers),
                                       cmocka_unit_test(multiple_components)};

    return cmocka_run_group_tests(tests, setup, teardown);
}
