/* All operators on surfaces, in all degree forms, against their definitions in
 * long double, with the condition of each value measured: the law and its
 * numbers are those of t_crv_truth.
 *
 *   |value - definition| <= C e (input + output),  e = 2^-53
 *
 * input: change of the definition for random changes of the control points by e
 * times the surface's size; output: e (max |x_i| + |x / w| max |w_i|) / |w|
 * over the result's control points that count there. */
#include <limits.h>

#include "harness/randmv.h"
#include "harness/test.h"
#include "iritx/ops_srf.h"
#include "ops/table.h"
#include "truth.h"

IX_TEST_FIXTURE(43)

enum { DEGREE = 3, CHANGES = 6 };
#define ROUNDINGS 8

typedef struct {
    int degree[2];
    bool rational;
    int spans;       /* 0: Bezier */
    double at, size; /* distance from the origin in each coordinate */
} kind;

/* Half wild: control points on a grid, moved by up to its width. */
static ix_mv *rand_srf(const kind *k)
{
    double kv[2][16], pts[4 * 36];
    int n[2];
    ix_dir d[2];
    size_t np;
    ix_mv *m;

    for (int i = 0; i < 2; i++) {
        int p = k->degree[i];

        n[i] = p + (k->spans ? k->spans : 1);
        for (int j = 0; j < n[i] + p + 1; j++)
            kv[i][j] = j <= p ? 0 : j >= n[i] ? k->spans : j - p + 0.2;
        d[i] = (ix_dir){k->spans ? IX_BSPLINE : IX_BEZIER, p + 1, n[i], false,
                        k->spans ? kv[i] : NULL};
    }
    np = (size_t)n[0] * (size_t)n[1];
    for (size_t i = 0; i < np; i++) {
        const double grid[3] = {(double)(i % (size_t)n[0]) / (n[0] - 1),
                                (double)(i / (size_t)n[0]) / (n[1] - 1), 0};
        double w = k->rational ? ix_rng_range(&rng, 0.5, 2) : 1;
        double *p = pts + (k->rational ? np : 0);

        pts[i] = w;
        for (size_t c = 0; c < 3; c++) {
            double x = grid[c] + ix_rng_range(&rng, -0.3, 0.3);

            p[c * np + i] = w * (k->size * x + k->at);
        }
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, 2, d, 3, k->rational, pts, &m));
    return m;
}

/* --- the surface in long double ---------------------------------------------
 */

typedef struct {
    local u[DEGREE + 1], v; /* rows of control points; knots of v */
    double at;
} patch;

/* S_u, S_v, S_uu, S_uv, S_vv and S, about the point `at`. */
typedef struct {
    real s[3], d[2][3], dd[3][3];
} jet;

static void load_patch(const ix_mv *m, const double t[2], double at, patch *o)
{
    const double *w = ix_mv_weights(m);
    int row = load_knots(&m->dirs[1], t[1], &o->v);

    o->at = at;
    for (int j = 0; j <= o->v.degree; j++) {
        local *u = &o->u[j];
        int first = load_knots(&m->dirs[0], t[0], u);

        for (int i = 0; i <= u->degree; i++) {
            int at_i = (row + j) * m->dirs[0].length + first + i;

            u->pts[i][0] = w ? w[at_i] : 1;
            for (int k = 0; k < 3; k++)
                u->pts[i][k + 1] = ix_mv_coord(m, k)[at_i] -
                                   u->pts[i][0] * (real)at;
        }
    }
}

/* Derivatives by the quotient rule. */
static jet jet_of(const patch *p, const double t[2])
{
    static const int ij[6][2] = {{0, 0}, {1, 0}, {0, 1},
                                 {2, 0}, {1, 1}, {0, 2}};
    real h[6][4], w;
    local v = p->v;
    jet o;

    for (int n = 0; n < 6; n++) {
        for (int j = 0; j <= v.degree; j++)
            derive_local(&p->u[j], ij[n][0], t[0], v.pts[j]);
        derive_local(&v, ij[n][1], t[1], h[n]);
    }
    w = h[0][0];
    for (int k = 0; k < 3; k++) {
        real x = o.s[k] = h[0][k + 1] / w, a, b;

        a = o.d[0][k] = (h[1][k + 1] - x * h[1][0]) / w;
        b = o.d[1][k] = (h[2][k + 1] - x * h[2][0]) / w;
        o.dd[0][k] = (h[3][k + 1] - x * h[3][0] - 2 * a * h[1][0]) / w;
        o.dd[1][k] = (h[4][k + 1] - x * h[4][0] - a * h[2][0] - b * h[1][0]) /
                     w;
        o.dd[2][k] = (h[5][k + 1] - x * h[5][0] - 2 * b * h[2][0]) / w;
    }
    return o;
}

/* --- definitions ------------------------------------------------------------
 */

enum { MIRROR = 2 }; /* the k of ORTHOTOMC */
static const double mirrored[3] = {0.3, -0.4, 0.6};

/* What is computed of a surface, and how many values it has. */
typedef enum {
    FIRST,
    SECOND,
    THIRD,
    GAUSS,
    MEAN,
    ALONG_U,
    ALONG_V,
    TOTAL,
    FOCAL_U,
    FOCAL_V,
    EVOLUTE,
    DUAL,
    ORTHOTOMIC,
    NOPS
} op;

static const char *const names[NOPS] = {
    "SRFFFORM 1", "SRFFFORM 2", "SRFFFORM 3", "SGAUSS",   "SMEAN",
    "SCRVTR COL", "SCRVTR ROW", "SCRVTR OFF", "SFOCAL 0", "SFOCAL 1",
    "EVOLUTE",    "DUALITY",    "ORTHOTOMC"};

static int count_of(op what)
{
    return what >= GAUSS && what <= TOTAL ? 1 : 3;
}

static bool is_place(op what)
{
    return (what >= FOCAL_U && what <= EVOLUTE) || what == ORTHOTOMIC;
}

typedef struct {
    real n[3], nn, g[3], l[3], det, k, h; /* L_ij = S_ij.n, n not unit */
} shape;

static shape shape_of(const jet *j)
{
    shape o;

    cross(j->d[1], j->d[0], o.n);
    o.nn = dot(o.n, o.n);
    for (int i = 0; i < 3; i++) {
        o.g[i] = dot(j->d[i / 2], j->d[(i + 1) / 2]);
        o.l[i] = dot(j->dd[i], o.n);
    }
    o.det = o.g[0] * o.g[2] - o.g[1] * o.g[1];
    o.k = (o.l[0] * o.l[2] - o.l[1] * o.l[1]) / o.nn / o.det;
    o.h = (o.g[0] * o.l[2] + o.g[2] * o.l[0] - 2 * o.g[1] * o.l[1]) /
          (2 * o.det); /* times |n| */
    return o;
}

static void vectors(op what, const jet *j, const shape *s, double at, real *out)
{
    const real r = what == EVOLUTE   ? 1 / (2 * s->h)
                   : what == FOCAL_U ? s->g[0] / s->l[0]
                                     : s->g[2] / s->l[2];
    real about[3], c;

    for (int k = 0; k < 3; k++) { /* s is about at */
        about[k] = j->s[k] + at - (what == DUAL ? 0 : mirrored[k]);
        out[k] = j->s[k] + r * s->n[k];
    }
    c = dot(s->n, about);
    for (int k = 0; k < 3; k++) {
        if (what == DUAL)
            out[k] = -s->n[k] / c;
        if (what == ORTHOTOMIC)
            out[k] = (real)mirrored[k] - at + MIRROR * c / s->nn * s->n[k];
    }
}

static void definition(op what, const jet *j, double at, real *out)
{
    shape s = shape_of(j);

    if (what > TOTAL) {
        vectors(what, j, &s, at, out);
        return;
    }
    for (int i = 0; i < 3; i++)
        out[i] = what == FIRST    ? s.g[i]
                 : what == SECOND ? s.l[i]
                                  : 2 * s.h * s.l[i] / s.nn - s.k * s.g[i];
    if (what >= GAUSS)
        out[0] = what == GAUSS   ? s.k
                 : what == MEAN  ? s.h * s.h / s.nn
                 : what == TOTAL ? 4 * s.h * s.h / s.nn - 2 * s.k
                                 : s.l[what == ALONG_U ? 0 : 2] *
                                       s.l[what == ALONG_U ? 0 : 2] /
                                       (s.nn * s.g[what == ALONG_U ? 0 : 2] *
                                        s.g[what == ALONG_U ? 0 : 2]);
}

/* --- condition --------------------------------------------------------------
 */

/* q = p with control points moved by step times their size. */
static void change(const kind *k, const patch *p, double step, patch *q)
{
    *q = *p;
    for (int b = 0; b <= q->v.degree; b++)
        for (int a = 0; a <= q->u[b].degree; a++)
            for (int c = k->rational ? 0 : 1; c < 4; c++) {
                double e = ix_rng_next(&rng) & 1 ? step : -step;

                q->u[b].pts[a][c] += e * (c ? k->size : 1) * p->u[b].pts[a][0];
            }
}

/* Change of the values, as a vector, for a relative change of the control
 * points by one. */
static double input_condition(op what, const kind *k, const patch *p,
                              const double t[2], const real *want)
{
    static const double step = 0x1p-30;
    double cond = 0;

    for (int round = 0; round < CHANGES; round++) {
        patch q;
        real v[3];
        jet j;

        change(k, p, step, &q);
        j = jet_of(&q, t);
        definition(what, &j, k->at, v);
        for (int i = 0; i < count_of(what); i++)
            cond = fmax(cond, fabs((double)(v[i] - want[i])) / step);
    }
    return cond;
}

/* The output number of coordinate c of a result with this value. */
static double output_condition(const ix_mv *m, const double t[2], int c,
                               double value)
{
    const ix_dir *d = m->dirs;
    const double *w = ix_mv_weights(m), *x = ix_mv_coord(m, c);
    int j[2] = {span_of(&d[0], t[0]), span_of(&d[1], t[1])};
    double axes[4], big = 0, wide = 0;

    ASSERT_OK(ctx, ix_mv_eval(ctx, m, t, axes));
    for (int b = j[1] - d[1].order + 1; b <= j[1]; b++)
        for (int a = j[0] - d[0].order + 1; a <= j[0]; a++) {
            big = fmax(big, fabs(x[b * d[0].length + a]));
            wide = fmax(wide, w ? fabs(w[b * d[0].length + a]) : 0);
        }
    return (big + fabs(value) * wide) / (w ? fabs(axes[0]) : 1);
}

/* What (n_i.n_j)(n.n) - (n.n_i)(n.n_j) over |n|^4 subtracts, in size. */
static double third_form_terms(const jet *j)
{
    real n[3], a[3], b[3], most = 0;

    cross(j->d[1], j->d[0], n);
    for (int i = 0; i < 2; i++) {
        cross(j->dd[i + 1], j->d[0], a); /* n_i = S_vi x S_u + S_v x S_ui */
        cross(j->d[1], j->dd[i], b);
        for (int k = 0; k < 3; k++)
            a[k] += b[k];
        most = dot(a, a) > most ? dot(a, a) : most;
    }
    return (double)(most / dot(n, n));
}

/* --- the law ----------------------------------------------------------------
 */

/* One result, or the three of a fundamental form. */
static ix_status run(op what, const ix_mv *s, const ix_op_opts *o,
                     ix_mv *out[3])
{
    out[0] = out[1] = out[2] = NULL;
    if (what <= THIRD)
        return ix_srf_forms(ctx, s, (int)what + 1, o, out);
    if (what == GAUSS)
        return ix_srf_gauss(ctx, s, false, o, NULL, out);
    if (what == MEAN)
        return ix_srf_mean(ctx, s, false, o, NULL, out);
    if (what <= TOTAL)
        return ix_srf_curvature(ctx, s, (ix_srf_curvature_kind)(what - ALONG_U),
                                o, NULL, out);
    if (what <= FOCAL_V)
        return ix_srf_focal(ctx, s, (int)(what - FOCAL_U), o, NULL, out);
    if (what == EVOLUTE)
        return ix_srf_evolute(ctx, s, o, NULL, out);
    if (what == DUAL)
        return ix_duality(ctx, s, o, out);
    return ix_orthotomic(ctx, s, mirrored, MIRROR, o, out);
}

static void check_at(op what, int form, const kind *k, const ix_mv *s,
                     ix_mv *const res[3], const double t[2])
{
    double gap = 0, out = 0, most;
    real want[3];
    patch p;
    jet j;

    load_patch(s, t, k->at, &p);
    j = jet_of(&p, t);
    definition(what, &j, k->at, want);
    for (int i = 0; i < count_of(what); i++) {
        const ix_mv *m = res[what <= THIRD ? i : 0];
        int c = what <= THIRD ? 0 : i;
        double x[3];

        ASSERT_OK(ctx, ix_mv_point(ctx, m, t, x));
        out = fmax(out, output_condition(m, t, c, x[c]));
        gap = fmax(gap, (double)fabsl((real)x[c] - want[i] -
                                      (is_place(what) ? k->at : 0)));
    }
    if (what == THIRD && form != IX_FORM_MINIMAL)
        out += third_form_terms(&j);
    most = 0x1p-53 * (input_condition(what, k, &p, t, want) + out);
    if (!(gap <= ROUNDINGS * most))
        fail_msg("%s form %d, degrees %d %d, rational %d, %d spans, at %g, "
                 "size %g, (%g, %g): off by %g, %g times e (value %Lg)",
                 names[what], form, k->degree[0], k->degree[1], k->rational,
                 k->spans, k->at, k->size, t[0], t[1], gap, gap / most,
                 want[0]);
}

/* Lines: no normal curvature, no centres. */
static bool along_ruling(op what, const kind *k)
{
    return ((what == FOCAL_U || what == ALONG_U) && k->degree[0] == 1) ||
           ((what == FOCAL_V || what == ALONG_V) && k->degree[1] == 1);
}

static void check_surface(const kind *k)
{
    static const ix_degree_form forms[3] = {IX_FORM_MINIMAL, IX_FORM_NAIVE,
                                            IX_FORM_IRIT};
    ix_mv *s = rand_srf(k), *res[3];
    bool large = k->degree[0] + k->degree[1] > (k->rational ? 3 : 4);

    for (int what = 0; what < NOPS; what++)
        for (int f = 0; f < (large || k->spans ? 1 : 3); f++) {
            const ix_op_opts o = {forms[f], INT_MAX};

            if (along_ruling((op)what, k))
                continue;
            ASSERT_OK(ctx, run((op)what, s, &o, res));
            for (int i = 0; i < 4; i++) {
                double t[2], dom[2];

                for (int d = 0; d < 2; d++) {
                    ix_mv_domain(s, d, dom);
                    t[d] = ix_rng_range(&rng, dom[0], dom[1]);
                }
                check_at((op)what, (int)forms[f], k, s, res, t);
            }
            for (int i = 0; i < 3; i++)
                ix_mv_unref(ctx, res[i]);
        }
    ix_mv_unref(ctx, s);
}

/* --- zeros ------------------------------------------------------------------
 */

/* The equation that was solved has its largest coefficient 1: an error of e in
 * that is e times this in the definition. */
static real size_of(const ix_mv *f, const double t[2], real slope)
{
    int k[2][2] = {{1, 0}, {0, 1}};
    real of_f = 0;

    for (int d = 0; f && d < 2; d++) {
        double x[2];

        ASSERT_OK(ctx, ix_mv_partial(ctx, f, t, k[d], x));
        of_f += fabs(x[0]);
    }
    return f ? slope / of_f : 0;
}

/* How far a zero of f (NULL: not at hand) can be off: the change of the values
 * over steps of 4 e in the parameters, and their errors by the input and by the
 * coefficients of f. 64 as in t_crv_truth; the largest met was 14. */
static void check_zero(const kind *k, const ix_mv *s, const ix_mv *f,
                       const double t[2], real (*value)(const jet *j))
{
    real at_zero, slope = 0, unsure = 0;
    static const double step = 0x1p-30;
    patch p;
    jet j;

    load_patch(s, t, k->at, &p);
    j = jet_of(&p, t);
    at_zero = value(&j);
    for (int d = 0; d < 2; d++) {
        double u[2] = {t[0], t[1]};

        u[d] += t[d] > 0.5 ? -step : step;
        j = jet_of(&p, u);
        slope += fabsl(value(&j) - at_zero) / step;
    }
    for (int round = 0; round < CHANGES; round++) {
        patch q;

        change(k, &p, step, &q);
        j = jet_of(&q, t);
        unsure = fmaxl(unsure, fabsl(value(&j) - at_zero) / step);
    }
    if (!(fabsl(at_zero) <=
          64 * 0x1p-53 * (4 * slope + unsure + size_of(f, t, slope))))
        fail_msg("zero at (%.17g, %.17g), size %g: %Lg, %Lg by the parameters, "
                 "%Lg by the input",
                 t[0], t[1], k->size, at_zero, slope, unsure);
}

static void truth_of_all(double at, double size)
{
    static const int degrees[][2] = {{2, 2}, {2, 1}, {3, 2}, {1, 1}};

    for (int i = 0; i < 4; i++)
        for (int r = 0; r < 2; r++) {
            kind k = {{degrees[i][0], degrees[i][1]}, r, 0, at, size};

            check_surface(&k);
            k.spans = 2;
            if (degrees[i][0] == 2)
                check_surface(&k);
        }
}

static void of_unit_size(void **state)
{
    (void)state;
    truth_of_all(0, 1);
}

/* At a million units (a power of two, so that the shift is exact) in all
 * coordinates. */
static void far_away(void **state)
{
    (void)state;
    truth_of_all(0x1p20, 1);
}

static void small(void **state)
{
    (void)state;
    truth_of_all(0, 1e-6);
}

static void large(void **state)
{
    (void)state;
    truth_of_all(0, 1e6);
}

/* K without its positive denominator. */
static real gauss_numerator(const jet *j)
{
    shape s = shape_of(j);

    return s.l[0] * s.l[2] - s.l[1] * s.l[1];
}

/* Both equations of an umbilic. */
static real umbilic_12(const jet *j)
{
    shape s = shape_of(j);

    return s.l[0] * s.g[1] - s.l[1] * s.g[0];
}

static real umbilic_22(const jet *j)
{
    shape s = shape_of(j);

    return s.l[0] * s.g[2] - s.l[2] * s.g[0];
}

/* Law: parabolic points have K = 0, umbilics have proportional forms, as nearly
 * as the last place of parameters and the input allow, at any size and place.
 */
static void zeros(void **state)
{
    static const double scale[][2] = {{0, 1}, {0x1p20, 1}, {0, 1e-6}, {0, 1e6}};
    int parabolic = 0, umbilics = 0;

    (void)state;
    for (int i = 0; i < 8; i++) {
        kind k = {{3, 2}, i & 1, 0, scale[i / 2][0], scale[i / 2][1]};
        ix_mv *s = rand_srf(&k), *f;
        ix_solution_curves c;
        ix_solutions u;

        ASSERT_OK(ctx, ix_srf_gauss(ctx, s, true, NULL, NULL, &f));
        ASSERT_OK(ctx, ix_srf_parabolic(ctx, s, 0, &c));
        for (int n = 0; n < c.ncurves; n++)
            for (int j = 0; j < c.curve[n].n; j += 5, parabolic++)
                check_zero(&k, s, f, c.curve[n].x + 2 * j, gauss_numerator);
        ix_solution_curves_free(ctx, &c);
        ASSERT_OK(ctx, ix_srf_umbilics(ctx, s, NULL, &u));
        for (int n = 0; n < u.n; n++, umbilics++) {
            check_zero(&k, s, NULL, u.sol[n].x, umbilic_12);
            check_zero(&k, s, NULL, u.sol[n].x, umbilic_22);
        }
        ix_solutions_free(ctx, &u);
        ix_mv_unref(ctx, f);
        ix_mv_unref(ctx, s);
    }
    assert_true(parabolic > 20 && umbilics > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_unit_size), cmocka_unit_test(far_away),
        cmocka_unit_test(small), cmocka_unit_test(large),
        cmocka_unit_test(zeros)};

    return cmocka_run_group_tests(tests, setup, teardown);
}
