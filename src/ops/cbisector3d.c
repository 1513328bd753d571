/* cbisector3d.c - the bisector surface of two space curves.
 *
 * A curve (p, w) has the lift L = (w p, w^2, |p|^2). A sphere a.x + b + e|x|^2
 * = 0 touches the curve where (a, b, e) is orthogonal to both partials of L;
 * it touches two curves where it is orthogonal to four rows, so its
 * coefficients are the 4 x 4 minors of these and its centre is -a / (2e).
 * Expanded by pairs of rows, each minor is a sum of six products of a 2 x 2
 * minor in s by one in t (Laplace): the result is kept in that form until its
 * grid of control points is written. */
#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "iritx/ops.h"
#include "ops/lift.h"
#include "sym/outer.h"

enum { NTERMS = 24, GRID = 5 };

/* --- the six products ----------------------------------------------------- */

/* det of the columns but `without`, expanded along the rows in s, times f. */
static void expand(int row, int without, double f, ix_outer_term *t)
{
    static const int pairs[6][5] = {{0, 1, 2, 3, 1},  {0, 2, 1, 3, -1},
                                    {0, 3, 1, 2, 1},  {1, 2, 0, 3, 1},
                                    {1, 3, 0, 2, -1}, {2, 3, 0, 1, 1}};
    int c[4], n = 0;

    for (int j = 0; j < 5; j++)
        if (j != without)
            c[n++] = j;
    for (int k = 0; k < 6; k++) {
        const int *q = pairs[k];
        int su, sv, u = ix__lift_minor(c[q[0]], c[q[1]], &su);
        int v = ix__lift_minor(c[q[2]], c[q[3]], &sv);

        t[k] = (ix_outer_term){row, u, v, f * q[4] * su * sv};
    }
}

/* Row 0 is the weight 2e, rows 1 .. 3 are -a; minor j has the sign (-1)^j. */
static void make_terms(ix_outer_term *t)
{
    expand(0, 4, 2.0, t);
    expand(1, 0, -1.0, t + 6);
    expand(2, 1, 1.0, t + 12);
    expand(3, 2, -1.0, t + 18);
}

/* --- degenerate input ----------------------------------------------------- */

/* What the computation knows of both curves. */
typedef struct {
    ix_frame frame;
    ix_form f[2], minors[2];
    double band; /* relative error of a coefficient of the result */
} pair;

/* Relative rounding of a sum of products in the degrees at hand, and what the
 * rounding of the input makes of its three factors in each curve. */
static double error_band(const pair *p)
{
    int d = p->minors[0].dirs[0].degree + p->minors[1].dirs[0].degree;

    return 8.0 * DBL_EPSILON * (d + 2) + 8.0 * p->frame.noise;
}

/* A curve is a point if its tangent (minors x1 y1 z1) vanishes. */
static ix_status check_point(ix_ctx *ctx, const pair *p, int i)
{
    int sign, first = ix__lift_minor(0, 3, &sign);
    ix_form tangent = ix__form_rows(&p->minors[i], first, 3);
    double big;

    IX_TRY(ix__form_bound(ctx, &tangent, &big));
    if (!(big > p->band))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "curve %d is a point: its tangent is at most %.3g of "
                       "the size of both curves, error band %.3g",
                       i + 1, big, p->band);
    return IX_OK;
}

/* Distance of c2 from c1 at one parameter u in [0, 1] of both domains;
 * negative at a pole. */
static ix_status gap_at(ix_ctx *ctx, const ix_mv *const *c, double u,
                        bool reversed, double *gap)
{
    double dom[2], x[2][3];

    *gap = -1.0;
    for (int i = 0; i < 2; i++) {
        double v = i && reversed ? 1.0 - u : u, t;
        ix_status st;

        ix_mv_domain(c[i], 0, dom);
        t = dom[0] + v * (dom[1] - dom[0]);
        st = ix_mv_point(ctx, c[i], &t, x[i]);
        if (st == IX_EDOMAIN)
            return IX_OK;
        IX_TRY(st);
    }
    *gap = 0.0;
    for (int k = 0; k < 3; k++)
        *gap = fmax(*gap, fabs(x[0][k] - x[1][k]));
    return IX_OK;
}

/* Curves that agree at as many parameters as their difference has degrees on
 * all spans together are the same. */
static ix_status check_same(ix_ctx *ctx, const ix_mv *const *c, const pair *p,
                            bool reversed)
{
    int n = 0, seen = 0;
    double tol = ldexp(p->band, p->frame.exp), gap, big = 0.0;

    for (int i = 0; i < 2; i++)
        n += p->f[i].dirs[0].nspans;
    n *= p->f[0].dirs[0].degree + p->f[1].dirs[0].degree + 1;
    for (int i = 0; i <= n; i++) {
        IX_TRY(gap_at(ctx, c, (double)i / n, reversed, &gap));
        if (gap > tol)
            return IX_OK;
        seen += gap >= 0.0;
        big = fmax(big, gap);
    }
    if (2 * seen < n)
        return IX_OK;
    return IX_FAIL(ctx, IX_EDOMAIN,
                   "both curves are the same%s: they differ by at most %.3g, "
                   "error band %.3g",
                   reversed ? ", one reversed" : "", big, tol);
}

static ix_status check_weight(ix_ctx *ctx, const pair *p, size_t n,
                              const double *w, double size)
{
    double big = ix__bern_largest(n, w);

    if (!(big > p->band * size))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the curves lie in one plane: the weight is at most "
                       "%.3g of its terms, error band %.3g",
                       size > 0.0 ? big / size : 0.0, p->band);
    return IX_OK;
}

/* --- the surface ---------------------------------------------------------- */

/* Positive sum of weights, largest weight in [1/2, 1), the user's frame. */
static void finish(const ix_frame *frame, size_t n, double *pts)
{
    double sum = 0.0, f;
    int e;

    for (size_t i = 0; i < n; i++)
        sum += pts[i];
    (void)frexp(ix__bern_largest(n, pts), &e);
    f = ldexp(sum < 0.0 ? -1.0 : 1.0, -e);
    for (size_t i = 0; i < n; i++)
        pts[i] *= f;
    ix__frame_back(frame, f, n, pts, pts + n);
}

/* The degree that a form of the result asks for, given the minimal one. */
static int wanted_degree(const ix_op_opts *o, bool rational, int d, int minimal)
{
    int n = minimal;

    if (o && o->form == IX_FORM_IRIT && rational)
        n = 5 * d;
    if (o && o->form == IX_FORM_PUBLISHED && rational)
        n = 4 * d - 1;
    return n > minimal ? n : minimal;
}

static ix_status load_pair(ix_ctx *ctx, const ix_mv *const *c,
                           const ix_op_opts *o, pair *p)
{
    bool both = c[0]->rational || c[1]->rational;

    IX_TRY(ix__frame_of(ctx, 2, c, &p->frame));
    for (int i = 0; i < 2; i++) {
        int degree;

        IX_TRY(ix__forms_load(ctx, 1, &c[i], &p->frame, &p->f[i]));
        IX_TRY(ix__lift_tangents(ctx, &p->f[i], c[i]->rational, &p->minors[i]));
        degree = wanted_degree(o, both, p->f[i].dirs[0].degree,
                               p->minors[i].dirs[0].degree);
        IX_TRY(ix__form_elevate(ctx, &p->minors[i], &degree, &p->minors[i]));
        if (o && o->form == IX_FORM_IRIT) /* B-spline whatever the input */
            p->minors[i].bezier = 0;
    }
    p->band = error_band(p);
    return IX_OK;
}

/* The points of s, whose directions are those of the sum. */
static ix_status fill(ix_ctx *ctx, const pair *p, const ix_outer *sum, ix_mv *s)
{
    double size[4];

    IX_TRY(ix__outer_points(ctx, sum, s->dirs, s->pts, size));
    IX_TRY(check_weight(ctx, p, s->npts, s->pts, size[0]));
    finish(&p->frame, s->npts, s->pts);
    return ix__check_finite(ctx, 4 * s->npts, s->pts);
}

static ix_status build(ix_ctx *ctx, const ix_mv *const *c, const ix_op_opts *o,
                       ix_mv **out)
{
    ix_outer_term terms[NTERMS];
    ix_sym_opts so = {o ? o->max_cont : INT_MAX, 0};
    ix_outer sum = {.nrows = 4, .nterms = NTERMS, .terms = terms};
    ix_dir dirs[2];
    ix_status st;
    pair p;
    ix_mv *s;

    if (o && o->form == IX_FORM_IRIT)
        so.max_cont = 0;
    IX_TRY(load_pair(ctx, c, o, &p));
    for (int i = 0; i < 2; i++)
        IX_TRY(check_point(ctx, &p, i));
    for (int i = 0; i < 2; i++)
        IX_TRY(check_same(ctx, c, &p, i == 1));
    make_terms(terms);
    sum.u = &p.minors[0];
    sum.v = &p.minors[1];
    IX_TRY(ix__outer_dirs(ctx, &sum, &so, dirs));
    IX_TRY(ix__mv_alloc(ctx, 2, dirs, 3, true, &s));
    st = fill(ctx, &p, &sum, s);
    if (st != IX_OK) {
        ix_mv_unref(ctx, s);
        return st;
    }
    *out = s;
    return IX_OK;
}

/* --- the report ----------------------------------------------------------- */

static double distance(const double *a, const double *b)
{
    double s = 0.0;

    for (int k = 0; k < 3; k++)
        s = hypot(s, a[k] - b[k]);
    return s;
}

/* Points closer to infinity than this part of the largest weight are not
 * measured: there the surface has no point. */
#define POLE 1e-6

static ix_status measure_at(ix_ctx *ctx, const ix_mv *const *c, const ix_mv *s,
                            const double *t, double size, double *worst)
{
    double x[4], p[2][3], r[2];

    IX_TRY(ix_mv_eval(ctx, s, t, x));
    if (!(fabs(x[0]) > POLE))
        return IX_OK;
    for (int i = 0; i < 2; i++) {
        ix_status st = ix_mv_point(ctx, c[i], &t[i], p[i]);

        if (st == IX_EDOMAIN)
            return IX_OK;
        IX_TRY(st);
    }
    for (int k = 0; k < 3; k++)
        x[k + 1] /= x[0];
    for (int i = 0; i < 2; i++)
        r[i] = distance(x + 1, p[i]);
    r[0] = fabs(r[0] - r[1]) / fmax(size, fmax(r[0], r[1]));
    *worst = fmax(isnan(*worst) ? 0.0 : *worst, r[0]);
    return IX_OK;
}

static ix_status measure(ix_ctx *ctx, const ix_mv *const *c, const ix_mv *s,
                         const ix_op_opts *o, ix_report *rep)
{
    double a[2], b[2];
    ix_frame frame;

    *rep = (ix_report){.form = o ? o->form : IX_FORM_MINIMAL, .ndirs = 2};
    rep->orders[0] = ix_mv_order(s, 0);
    rep->orders[1] = ix_mv_order(s, 1);
    rep->residual = (double)NAN;
    rep->how = "equidistance on a 5 x 5 grid, relative to distance or size";
    IX_TRY(ix__frame_of(ctx, 2, c, &frame));
    ix_mv_domain(s, 0, a);
    ix_mv_domain(s, 1, b);
    for (int i = 0; i < GRID; i++)
        for (int j = 0; j < GRID; j++) {
            double t[2] = {a[0] + (a[1] - a[0]) * (i + 0.5) / GRID,
                           b[0] + (b[1] - b[0]) * (j + 0.5) / GRID};

            IX_TRY(measure_at(ctx, c, s, t, ldexp(1.0, frame.exp),
                              &rep->residual));
        }
    return IX_OK;
}

/* --- entry ---------------------------------------------------------------- */

static ix_status check_input(ix_ctx *ctx, const ix_mv *const *c,
                             const ix_op_opts *o)
{
    for (int i = 0; i < 2; i++)
        if (c[i]->ndirs != 1 || c[i]->ncoords > 3)
            return IX_FAIL(ctx, IX_EARG,
                           "operand %d has %d directions and %d coordinates: "
                           "a curve with at most 3 is needed",
                           i + 1, c[i]->ndirs, c[i]->ncoords);
    if (o && (o->form == IX_FORM_NAIVE || o->form < IX_FORM_MINIMAL ||
              o->form > IX_FORM_IRIT))
        return IX_FAIL(ctx, IX_EUNABLE,
                       "the bisector surface is not built in degree form %d",
                       (int)o->form);
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, const ix_mv *const *c, const ix_op_opts *o,
                     ix_report *rep, ix_mv **out)
{
    ix_mv *s;
    ix_status st;

    IX_TRY(build(ctx, c, o, &s));
    st = rep ? measure(ctx, c, s, o, rep) : IX_OK;
    if (st != IX_OK) {
        ix_mv_unref(ctx, s);
        return st;
    }
    *out = s;
    return IX_OK;
}

ix_status ix_cbisector3d(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                         const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    const ix_mv *c[2] = {c1, c2};
    ix_mv *space[2] = {NULL, NULL};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    *out = NULL;
    IX_TRY(check_input(ctx, c, o));
    st = ix_mv_coerce(ctx, c1, 3, c1->rational, &space[0]);
    if (st == IX_OK)
        st = ix_mv_coerce(ctx, c2, 3, c2->rational, &space[1]);
    c[0] = space[0];
    c[1] = space[1];
    if (st == IX_OK)
        st = run(ctx, c, o, rep, out);
    ix_mv_unref(ctx, space[0]);
    ix_mv_unref(ctx, space[1]);
    ix__scratch_release(ctx, mk);
    return st;
}
