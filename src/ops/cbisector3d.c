/* cbisector3d.c - the bisector surface of two space curves, and the
 * alpha-sectors beside it.
 *
 * A curve (p, w) has the lift L = (w p, w^2, |p|^2). A sphere a.x + b + e|x|^2
 * = 0 touches the curve where (a, b, e) is orthogonal to both partials of L;
 * it touches two curves where it is orthogonal to four rows, so its
 * coefficients are the 4 x 4 minors of these and its centre is -a / (2e).
 * Expanded by pairs of rows, each minor is a sum of six products of a 2 x 2
 * minor in s by one in t (Laplace): the result is kept in that form until its
 * grid of control points is written.
 *
 * An alpha-sector has the plane through (1 - alpha) C1 + alpha C2 in place of
 * that through the middle. With E = w1 p2 - w2 p1 and D the tangents (scaled as
 * w^2 D, the minors x1 y1 z1) it adds (2 alpha - 1) |E|^2 D1 x D2 to the
 * numerators: sums of products of w^2 D, |p|^2 D and w p_k D_j. */
#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "geom/vec3.h"
#include "iritx/ops_bisect.h"
#include "ops/crv_pair.h"
#include "ops/lift.h"
#include "ops/report.h"
#include "sym/outer.h"

enum { NTERMS = 24, NMORE = 30, WEIGHT_TERMS = 6 };

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

/* Rows after the ten minors of each curve: |p|^2 D, then w p_k D_j. */
enum { QUADRATIC = 10, MIXED = 13 };

/* f |E|^2 (D1 x D2)_i: ten terms. */
static int add_sector(int row, int i, double f, ix_outer_term *t)
{
    int n = 0, sign, tangent = ix__lift_minor(0, 3, &sign);

    for (int h = 0; h < 2; h++) {
        int j = (i + 1 + h) % 3, l = (i + 2 - h) % 3;
        double e = h ? -f : f;

        t[n++] = (ix_outer_term){row, tangent + j, QUADRATIC + l, e};
        t[n++] = (ix_outer_term){row, QUADRATIC + j, tangent + l, e};
        for (int k = 0; k < 3; k++)
            t[n++] = (ix_outer_term){row, MIXED + 3 * k + j, MIXED + 3 * k + l,
                                     -2.0 * e};
    }
    return n;
}

/* Row 0 is the weight 2e, rows 1 .. 3 are -a; minor j has the sign (-1)^j. */
static int make_terms(double alpha, ix_outer_term *t)
{
    int n = WEIGHT_TERMS;

    expand(0, 4, 2.0, t);
    for (int i = 0; i < 3; i++) {
        expand(1 + i, i, i == 1 ? 1.0 : -1.0, t + n);
        n += 6;
        if (alpha != 0.5)
            n += add_sector(1 + i, i, 2.0 * alpha - 1.0, t + n);
    }
    return n;
}

/* --- the surface ---------------------------------------------------------- */

typedef struct {
    double alpha;
    ix_degree_form form;
    int max_cont;
} task;

/* m x, or its inverse if back, for n vectors: x[3][n]. */
static void turn(double m[3][3], bool back, size_t n, double *x)
{
    for (size_t i = 0; i < n; i++, x++) {
        double y[3] = {x[0], x[n], x[2 * n]};

        for (int k = 0; k < 3; k++) {
            double sum = 0.0;

            for (int j = 0; j < 3; j++)
                sum += (back ? m[j][k] : m[k][j]) * y[j];
            x[(size_t)k * n] = sum;
        }
    }
}

/* Positive sum of weights, largest weight in [1/2, 1), the user's frame. */
static void finish(ix_crv_pair *p, size_t n, double *pts)
{
    double f = ix__bern_weight_factor(n, pts);

    for (size_t i = 0; i < n; i++)
        pts[i] *= f;
    if (p->turned)
        turn(p->turn, true, n, pts + n);
    ix__frame_back(&p->frame, f, n, pts, pts + n);
}

/* The degree that a form of the result asks for, given the minimal one. */
static int wanted_degree(ix_degree_form form, bool rational, int d, int minimal)
{
    int n = minimal;

    if (form == IX_FORM_IRIT && rational)
        n = 5 * d;
    if (form == IX_FORM_PUBLISHED && rational)
        n = 4 * d - 1;
    return n > minimal ? n : minimal;
}

/* |p|^2 D and w p_k D_j, with w^2 D = the minors x1 y1 z1. */
static ix_status sector_rows(ix_ctx *ctx, const ix_form *f, bool rational,
                             bool formal, ix_form *out)
{
    ix_form p = ix__form_rows(f, rational, 3), w, d, pp, wp, part[4];
    const ix_form *list[4] = {&part[0], &part[1], &part[2], &part[3]};

    if (rational) {
        w = ix__form_rows(f, 0, 1);
        IX_TRY(ix__form_jacobian(ctx, &p, &w, 0, &d));
        ix__form_times(&d, formal ? -1.0 / f->dirs[0].degree : 2.0);
        IX_TRY(ix__form_mul(ctx, &p, &w, &wp));
    } else {
        IX_TRY(ix__form_derive(ctx, &p, 0, &d));
        ix__form_times(&d, -ix__spans_mean(&p.dirs[0]));
        wp = p;
    }
    IX_TRY(ix__form_dot(ctx, &p, &p, &pp));
    IX_TRY(ix__form_mul(ctx, &d, &pp, &part[0]));
    for (int k = 0; k < 3; k++) {
        ix_form one = ix__form_rows(&wp, k, 1);

        IX_TRY(ix__form_mul(ctx, &d, &one, &part[k + 1]));
    }
    return ix__form_join(ctx, 4, list, out);
}

/* The factors of the surface in one curve. Published and IRIT's forms have the
 * tangent in its formal degree, the latter each row over one denominator (a
 * factor w); the naive one leaves a factor w^2 that determinants of fractions
 * over their own denominators do not lose. */
static ix_status load_factors(ix_ctx *ctx, const ix_form *f, bool rational,
                              const task *k, int factors, ix_form *out)
{
    bool formal = rational &&
                  (k->form == IX_FORM_PUBLISHED || k->form == IX_FORM_IRIT);
    ix_form minors, more, w = ix__form_rows(f, 0, 1);
    const ix_form *parts[2] = {&minors, &more};

    if (formal)
        IX_TRY(ix__lift_formal(ctx, f, &minors));
    else
        IX_TRY(ix__lift_tangents(ctx, f, rational, &minors));
    *out = minors;
    if (k->alpha != 0.5) {
        IX_TRY(sector_rows(ctx, f, rational, formal, &more));
        IX_TRY(ix__form_join(ctx, 2, parts, out));
    }
    for (int i = 0; rational && i < factors; i++)
        IX_TRY(ix__form_mul(ctx, out, &w, out));
    return IX_OK;
}

/* |p|^2 D and w p_k D_j of a curve moved by a, with w^2 D before them. */
static void move_sector(ix_form *m, const double a[3])
{
    int sign, tangent = ix__lift_minor(0, 3, &sign);
    double aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];

    for (size_t i = 0; i < m->n; i++)
        for (int j = 0; j < 3; j++) {
            double d = m->c[(size_t)(tangent + j) * m->n + i],
                   *q = m->c + (size_t)(QUADRATIC + j) * m->n + i;

            *q += aa * d;
            for (int k = 0; k < 3; k++) {
                double *x = m->c + (size_t)(MIXED + 3 * k + j) * m->n + i;

                *q += 2.0 * a[k] * *x;
                *x += a[k] * d;
            }
        }
}

/* The factors of curve i in the frame of both. They are computed around the
 * curve itself, where the differences that make them do not cancel if it is
 * small in comparison with the distance of both, and moved. */
static ix_status place_factors(ix_ctx *ctx, const ix_mv *c, const task *k,
                               ix_crv_pair *p, int i)
{
    ix_frame own, near = p->frame;
    int factors = k->form == IX_FORM_NAIVE ? 2 : k->form == IX_FORM_IRIT;
    double a[3];

    IX_TRY(ix__frame_of(ctx, 1, &c, &own));
    for (int j = 0; j < 3; j++) {
        near.shift[j] = own.shift[j];
        a[j] = ldexp(own.shift[j] - p->frame.shift[j], -p->frame.exp);
    }
    IX_TRY(ix__forms_load(ctx, 1, &c, &near, &p->f[i]));
    if (p->turned) {
        turn(p->turn, false, 1, a);
        turn(p->turn, false, p->f[i].n,
             p->f[i].c + (c->rational ? p->f[i].n : 0));
    }
    p->powers[i] = c->rational ? 4 + factors : 0;
    IX_TRY(load_factors(ctx, &p->f[i], c->rational, k, factors, &p->minors[i]));
    ix__lift_move(&p->minors[i], a);
    if (k->alpha != 0.5)
        move_sector(&p->minors[i], a);
    return IX_OK;
}

static ix_status load_pair(ix_ctx *ctx, const ix_mv *const *c, const task *k,
                           ix_crv_pair *p)
{
    bool both = c[0]->rational || c[1]->rational;

    p->crv = c;
    IX_TRY(ix__frame_of(ctx, 2, c, &p->frame));
    ix__crv_pair_turn(p);
    for (int i = 0; i < 2; i++) {
        int degree;

        IX_TRY(place_factors(ctx, c[i], k, p, i));
        degree = wanted_degree(k->form, both, p->f[i].dirs[0].degree,
                               p->minors[i].dirs[0].degree);
        IX_TRY(ix__form_elevate(ctx, &p->minors[i], &degree, &p->minors[i]));
        if (k->form == IX_FORM_IRIT) /* B-spline whatever the input */
            p->minors[i].bezier = 0;
    }
    ix__crv_pair_band(p);
    return IX_OK;
}

/* The points of s, whose directions are those of the sum. */
static ix_status fill(ix_ctx *ctx, ix_crv_pair *p, const ix_outer *sum,
                      ix_mv *s)
{
    ix_outer weight = {sum->u, sum->v, 1, WEIGHT_TERMS, sum->terms};

    IX_TRY(ix__crv_pair_weight(ctx, p, &weight));
    IX_TRY(ix__outer_points(ctx, sum, s->dirs, s->pts, NULL));
    finish(p, s->npts, s->pts);
    return ix__check_finite(ctx, 4 * s->npts, s->pts);
}

static ix_status build(ix_ctx *ctx, const ix_mv *const *c, const task *k,
                       ix_mv **out)
{
    ix_outer_term terms[NTERMS + NMORE];
    ix_sym_opts so = {k->form == IX_FORM_IRIT ? 0 : k->max_cont, 0};
    ix_outer sum = {.nrows = 4, .terms = terms};
    ix_dir dirs[2];
    ix_status st;
    ix_crv_pair p;
    ix_mv *s;

    IX_TRY(load_pair(ctx, c, k, &p));
    IX_TRY(ix__crv_pair_check(ctx, &p));
    sum.nterms = make_terms(k->alpha, terms);
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

/* Points closer to infinity than this part of the largest weight are not
 * measured: there the surface has no point. */
#define POLE 1e-6

/* How far b is from the plane through (1 - alpha) p0 + alpha p1 at right angles
 * to p1 - p0, relative to size or the distance; for alpha = 1/2 the difference
 * of the distances. */
static double off_plane(const double *b, double p[2][3], double alpha,
                        double size)
{
    double e[3], m[3], r[2];

    for (int i = 0; i < 2; i++)
        r[i] = ix__dist3(b, p[i]);
    size = fmax(size, fmax(r[0], r[1]));
    if (alpha == 0.5)
        return fabs(r[0] - r[1]) / size;
    ix__sub3(p[1], p[0], e);
    ix__axpy3(p[0], alpha, e, m);
    ix__sub3(b, m, m);
    return fabs(ix__dot3(m, e)) / (size * fmax(ix__len3(e), DBL_MIN));
}

/* Both curves' points at the parameters t[5]: x[coordinate][5], not finite at a
 * pole; and the surface above all pairs: b[axis][25]. */
typedef struct {
    double t[2][5], x[2][3 * 5], b[4 * IX__PLACES];
} places;

static ix_status take_places(ix_ctx *ctx, const ix_mv *const *c, const ix_mv *s,
                             places *p)
{
    for (int i = 0; i < IX__PLACES; i++) {
        double t[2];

        ix__report_place(s, i, t);
        p->t[0][i % 5] = t[0];
        p->t[1][i / 5] = t[1];
    }
    for (int k = 0; k < 2; k++)
        IX_TRY(ix_mv_point_many(ctx, c[k], 5, p->t[k], p->x[k]));
    return ix_mv_eval_grid(ctx, s, (const int[]){5, 5},
                           (const double *const[]){p->t[0], p->t[1]}, p->b);
}

static void measure_at(const places *at, int i, double alpha, double size,
                       double *worst)
{
    double b[3], p[2][3], off, w = at->b[i];

    for (int k = 0; k < 3; k++) {
        b[k] = at->b[(k + 1) * IX__PLACES + i] / w;
        p[0][k] = at->x[0][5 * k + i % 5];
        p[1][k] = at->x[1][5 * k + i / 5];
    }
    off = off_plane(b, p, alpha, size);
    if (fabs(w) > POLE && isfinite(off))
        *worst = fmax(isnan(*worst) ? 0.0 : *worst, off);
}

static ix_status measure(ix_ctx *ctx, const ix_mv *const *c, const ix_mv *s,
                         const task *k, ix_report *rep)
{
    ix_frame frame;
    places at;

    ix__report_init(rep, k->form, s);
    rep->how = k->alpha == 0.5
                   ? "equidistance on a 5 x 5 grid, relative to distance or "
                     "size"
                   : "distance from the dividing plane on a 5 x 5 grid, "
                     "relative to distance or size";
    IX_TRY(ix__frame_of(ctx, 2, c, &frame));
    IX_TRY(take_places(ctx, c, s, &at));
    for (int i = 0; i < IX__PLACES; i++)
        measure_at(&at, i, k->alpha, ldexp(1.0, frame.exp), &rep->residual);
    return ix_bisector_meetings(ctx, c[0], c[1], rep);
}

/* --- entry ---------------------------------------------------------------- */

static ix_status check_input(ix_ctx *ctx, const ix_mv *const *c, double alpha)
{
    for (int i = 0; i < 2; i++)
        if (c[i]->ndirs != 1 || c[i]->ncoords > 3)
            return IX_FAIL(ctx, IX_EARG,
                           "operand %d has %d directions and %d coordinates: "
                           "a curve with at most 3 is needed",
                           i + 1, c[i]->ndirs, c[i]->ncoords);
    if (!isfinite(alpha))
        return IX_FAIL(ctx, IX_EARG, "a ratio of %g; it must be finite", alpha);
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, const ix_mv *const *c, const task *k,
                     ix_report *rep, ix_mv **out)
{
    ix_mv *s;
    ix_status st;

    IX_TRY(build(ctx, c, k, &s));
    st = rep ? measure(ctx, c, s, k, rep) : IX_OK;
    if (st != IX_OK) {
        ix_mv_unref(ctx, s);
        return st;
    }
    *out = s;
    return IX_OK;
}

ix_status ix_calphasector3d(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                            double alpha, const ix_op_opts *o, ix_report *rep,
                            ix_mv **out)
{
    const ix_mv *c[2] = {c1, c2};
    ix_mv *space[2] = {NULL, NULL};
    task k = {.alpha = alpha, .max_cont = o ? o->max_cont : INT_MAX};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    *out = NULL;
    IX_TRY(check_input(ctx, c, alpha));
    IX_TRY(ix__form_of_opts(ctx, o, &k.form));
    st = ix_mv_coerce(ctx, c1, 3, c1->rational, &space[0]);
    if (st == IX_OK)
        st = ix_mv_coerce(ctx, c2, 3, c2->rational, &space[1]);
    c[0] = space[0];
    c[1] = space[1];
    if (st == IX_OK)
        st = run(ctx, c, &k, rep, out);
    ix_mv_unref(ctx, space[0]);
    ix_mv_unref(ctx, space[1]);
    ix__scratch_release(ctx, mk);
    return st;
}

ix_status ix_cbisector3d(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                         const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    return ix_calphasector3d(ctx, c1, c2, 0.5, o, rep, out);
}
