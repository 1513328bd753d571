/* line_contact.c - see the header. All algebra is done on forms in three
 * parameters; derivatives are taken in the first two only. */
#include "ops/line_contact.h"

#include <math.h>

#include "bern/bern.h"
#include "geom/parts.h"
#include "geom/unit_solve.h"
#include "iritx/ops_srf.h"
#include "ops/surface.h"

#define MAX_CONTACT 4

/* The surface and its derivatives: jet[k][i] is d^k / du^(k-i) dv^i. Rational
 * points have 4 rows, weight first, others 3. */
typedef struct {
    bool rational;
    ix_form jet[MAX_CONTACT + 1][MAX_CONTACT + 1];
    ix_form n; /* the tangent plane; rational: of 4 rows */
    ix_form e, ne;
    ix_form d[2]; /* a, b */
    /* n.P_i of order k = 2 .. 4, and what of P_i is along P_u and P_v */
    ix_form c[MAX_CONTACT + 1][MAX_CONTACT + 1];
    ix_form along[2][MAX_CONTACT][MAX_CONTACT];
} contact;

/* --- loading
 * -------------------------------------------------------------------- */

/* s moved and scaled by a power of two into the unit box, its domains [0, 1],
 * constant in a third direction. */
static ix_status normalise(ix_ctx *ctx, const ix_mv *s, ix_mv **out)
{
    double mat[16] = {0}, scale;
    ix_pool q = {.ctx = ctx};
    const ix_mv *m;
    ix_frame f;

    IX_TRY(ix__frame_of(ctx, 1, &s, &f));
    scale = ldexp(1.0, -f.exp);
    for (int k = 0; k < 3; k++) {
        mat[5 * k] = scale;
        mat[12 + k] = -f.shift[k] * scale;
    }
    mat[15] = 1.0;
    m = ix__pool_made(&q, ix_mv_transform(ctx, s, mat, ix__pool_room(&q)));
    if (m)
        m = ix__pool_unit(&q, m);
    return ix__pool_give(&q, ix__pool_promote(&q, m, 3, 0), out);
}

/* (a, b) over r for q = 1, in three directions. */
static ix_status directions(ix_ctx *ctx, int chart, ix_mv **out)
{
    static const double pts[2][4] = {{1.0, 1.0, -1.0, 1.0},
                                     {1.0, -1.0, 1.0, 1.0}};
    const ix_dir r = {.basis = IX_BEZIER, .order = 2, .length = 2};
    ix_mv *m;
    ix_status st;

    IX_TRY(ix_mv_new(ctx, 1, &r, 2, false, pts[chart], &m));
    st = ix_mv_promote(ctx, m, 3, 2, out);
    ix_mv_unref(ctx, m);
    return st;
}

static ix_status derive_all(ix_ctx *ctx, int order, contact *k)
{
    for (int n = 1; n <= order; n++)
        for (int i = 0; i <= n; i++)
            IX_TRY(ix__form_derive(ctx, &k->jet[n - 1][i < n ? i : n - 1],
                                   i < n ? 0 : 1, &k->jet[n][i]));
    return IX_OK;
}

/* The covector of P, x and y: their minors, or x times y. */
static ix_status product(ix_ctx *ctx, const contact *k, const ix_form *x,
                         const ix_form *y, ix_form *out)
{
    const ix_form *rows[3] = {&k->jet[0][0], x, y};

    return k->rational ? ix__form_minors(ctx, 3, rows, out)
                       : ix__form_cross(ctx, x, y, out);
}

/* e: the mean of n if n.e is positive everywhere, else n itself. */
static ix_status choose_normal(ix_ctx *ctx, contact *k)
{
    double mean[4] = {0.0}, least = HUGE_VAL;
    const double *b;

    IX_TRY(ix__form_bernstein(ctx, &k->n, &b));
    for (int r = k->rational; r < k->n.nrows; r++)
        for (size_t i = 0; i < k->n.n; i++)
            mean[r] += b[(size_t)r * k->n.n + i];
    IX_TRY(ix__form_constant(ctx, &k->n, k->n.nrows, mean, &k->e));
    IX_TRY(ix__form_dot(ctx, &k->n, &k->e, &k->ne));
    IX_TRY(ix__form_bernstein(ctx, &k->ne, &b));
    for (size_t i = 0; i < k->ne.n; i++)
        least = fmin(least, b[i]);
    if (least > 0.0)
        return IX_OK;
    IX_TRY(ix__form_copy(ctx, &k->n, &k->e));
    if (k->rational) /* the first row is of the weight */
        for (size_t i = 0; i < k->e.n; i++)
            k->e.c[i] = 0.0;
    return ix__form_dot(ctx, &k->n, &k->e, &k->ne);
}

/* n.P_i; the parts of P_i along P_u and P_v times n.e. */
static ix_status components(ix_ctx *ctx, int order, contact *k)
{
    const ix_form *pu = &k->jet[1][0], *pv = &k->jet[1][1];
    ix_form x;

    for (int n = 2; n <= order; n++)
        for (int i = 0; i <= n; i++) {
            const ix_form *p = &k->jet[n][i];

            IX_TRY(ix__form_dot(ctx, &k->n, p, &k->c[n][i]));
            if (n == MAX_CONTACT || n >= order)
                continue;
            IX_TRY(product(ctx, k, pv, p, &x));
            IX_TRY(ix__form_dot(ctx, &k->e, &x, &k->along[0][n][i]));
            IX_TRY(product(ctx, k, p, pu, &x));
            IX_TRY(ix__form_dot(ctx, &k->e, &x, &k->along[1][n][i]));
        }
    return IX_OK;
}

static ix_status load(ix_ctx *ctx, const ix_mv *s, int order, int chart,
                      double *ratio, contact *k)
{
    ix_mv *m[2];
    ix_status st;
    double of[2];
    ix_form f[2];

    IX_TRY(normalise(ctx, s, &m[0]));
    st = directions(ctx, chart, &m[1]);
    if (st == IX_OK) {
        st = ix__forms_load(ctx, 2, (const ix_mv *const *)m, NULL, f);
        ix_mv_unref(ctx, m[1]);
    }
    ix_mv_unref(ctx, m[0]);
    IX_TRY(st);
    k->rational = s->rational;
    k->jet[0][0] = f[0];
    for (int i = 0; i < 2; i++)
        k->d[i] = ix__form_rows(&f[1], i, 1);
    IX_TRY(derive_all(ctx, order, k));
    for (int i = 0; i < 2; i++)
        IX_TRY(ix__form_bound(ctx, &k->jet[1][i], &of[i]));
    *ratio = of[0] / of[1];
    ix__form_times(&k->d[1], *ratio);
    IX_TRY(product(ctx, k, &k->jet[1][1], &k->jet[1][0], &k->n));
    IX_TRY(choose_normal(ctx, k));
    return components(ctx, order, k);
}

/* --- formulas
 * ------------------------------------------------------------------ */

/* One argument less: in[n + 1] of a symmetric form of n arguments, the first
 * being x. out may be in. */
static ix_status contract(ix_ctx *ctx, int n, const ix_form *in,
                          const ix_form x[2], ix_form *out)
{
    for (int i = 0; i < n; i++) {
        ix_form t;

        IX_TRY(ix__form_mul(ctx, &in[i], &x[0], &t));
        IX_TRY(ix__form_mul_add(ctx, &in[i + 1], 1, &x[1], &t));
        out[i] = t;
    }
    return IX_OK;
}

/* All n arguments. */
static ix_status apply(ix_ctx *ctx, int n, const ix_form *in,
                       const ix_form *const *x, ix_form *out)
{
    ix_form level[MAX_CONTACT + 1];

    for (int i = 0; i <= n; i++)
        level[i] = in[i];
    for (; n > 0; n--)
        IX_TRY(contract(ctx, n, level, x[n - 1], level));
    *out = level[0];
    return IX_OK;
}

/* *acc = *acc times by (unless NULL) + factor in(x ..). */
static ix_status add_term(ix_ctx *ctx, double factor, int n, const ix_form *in,
                          const ix_form *const *x, const ix_form *by,
                          ix_form *acc)
{
    ix_form t, p;

    IX_TRY(apply(ctx, n, in, x, &t));
    if (by) {
        IX_TRY(ix__form_mul(ctx, &t, by, &p));
        t = p;
    } else {
        IX_TRY(ix__form_copy(ctx, &t, &p));
    }
    ix__form_times(&p, factor);
    return ix__form_add(ctx, acc, 1, &p, acc);
}

/* g2 times n.e, and g3 times its square. */
static ix_status acceleration(ix_ctx *ctx, const contact *k, ix_form g2[2],
                              ix_form g3[2])
{
    const ix_form *const d[3] = {k->d, k->d, k->d};
    const ix_form *const dg[2] = {k->d, g2};

    for (int i = 0; i < 2; i++)
        IX_TRY(apply(ctx, 2, k->along[i][2], d, &g2[i]));
    for (int i = 0; g3 && i < 2; i++) {
        ix_form t;

        IX_TRY(apply(ctx, 3, k->along[i][3], d, &t));
        IX_TRY(ix__form_mul(ctx, &t, &k->ne, &g3[i]));
        IX_TRY(add_term(ctx, -3.0, 2, k->along[i][2], dg, NULL, &g3[i]));
    }
    return IX_OK;
}

static ix_status third(ix_ctx *ctx, const contact *k, const ix_form g2[2],
                       ix_form *out)
{
    const ix_form *const d[3] = {k->d, k->d, k->d};
    const ix_form *const dg[2] = {k->d, g2};
    ix_form t;

    IX_TRY(apply(ctx, 3, k->c[3], d, &t));
    IX_TRY(ix__form_mul(ctx, &t, &k->ne, out));
    return add_term(ctx, -3.0, 2, k->c[2], dg, NULL, out);
}

static ix_status fourth(ix_ctx *ctx, const contact *k, const ix_form g2[2],
                        const ix_form g3[2], ix_form *out)
{
    const ix_form *const d[4] = {k->d, k->d, k->d, k->d};
    const ix_form *const ddg[3] = {k->d, k->d, g2};
    const ix_form *const gg[2] = {g2, g2}, *const dg[2] = {k->d, g3};
    ix_form square, t;

    IX_TRY(ix__form_mul(ctx, &k->ne, &k->ne, &square));
    IX_TRY(apply(ctx, 4, k->c[4], d, &t));
    IX_TRY(ix__form_mul(ctx, &t, &square, out));
    IX_TRY(add_term(ctx, -6.0, 3, k->c[3], ddg, &k->ne, out));
    IX_TRY(add_term(ctx, 3.0, 2, k->c[2], gg, NULL, out));
    return add_term(ctx, -4.0, 2, k->c[2], dg, NULL, out);
}

/* --- edges that are points
 * ------------------------------------------------------- */

#define ZERO 1e-12 /* of the largest coefficient: some thousand roundings */

/* Is control point i at the low or high end of direction d? */
static bool at_end(const ix_mv *f, size_t i, int d, bool high)
{
    size_t inner = d ? (size_t)f->dirs[0].length : 1;
    size_t n = (size_t)f->dirs[d].length;

    return i / inner % n == (high ? n - 1 : 0);
}

/* Is that edge of the patch one point? */
static bool is_point(const ix_mv *s, int d, bool high)
{
    const double *w = ix_mv_weights(s);
    double size = 0.0, spread = 0.0;

    for (int k = 0; k < s->ncoords; k++) {
        double lo = HUGE_VAL, hi = -HUGE_VAL;

        for (size_t i = 0; i < s->npts; i++)
            if (at_end(s, i, d, high)) {
                double x = ix_mv_coord(s, k)[i] / (w ? w[i] : 1.0);

                lo = fmin(lo, x);
                hi = fmax(hi, x);
            }
        size = fmax(size, fmax(-lo, hi));
        spread = fmax(spread, hi - lo);
    }
    return spread <= ZERO * size;
}

/* Are the coefficients of f there zero? */
static bool vanishes(const ix_mv *f, int d, bool high)
{
    double band = ZERO * ix__bern_largest(f->npts, f->pts);

    for (size_t i = 0; i < f->npts; i++)
        if (at_end(f, i, d, high) && !(fabs(f->pts[i]) <= band))
            return false;
    return f->dirs[d].length > 1;
}

/* f over t (or 1 - t) of direction d, by Bernstein coefficients: those of t g,
 * degree n, are j / n times g's before. */
static ix_status divide(ix_ctx *ctx, const ix_mv *f, int d, bool high,
                        ix_mv **out)
{
    size_t inner = d ? (size_t)f->dirs[0].length : 1, to = 0;
    size_t n = (size_t)f->dirs[d].length;
    ix_dir dirs[3] = {f->dirs[0], f->dirs[1], f->dirs[2]};
    double *pts;

    dirs[d].order = dirs[d].length = (int)n - 1;
    IX_SCRATCH(ctx, pts, f->npts);
    for (size_t i = 0; i < f->npts; i++) {
        size_t j = i / inner % n, from = high ? n - 1 - j : j;

        if (from > 0)
            pts[to++] = f->pts[i] * (double)(n - 1) / (double)from;
    }
    return ix_mv_new(ctx, 3, dirs, 1, false, pts, out);
}

/* Where an edge of s is one point, n vanishes along it, and so does everything:
 * all such factors of f go. */
static ix_status deflate(ix_ctx *ctx, const ix_mv *s, ix_mv **f)
{
    for (int i = 0; i < 4; i++)
        while (is_point(s, i / 2, i % 2) && vanishes(*f, i / 2, i % 2)) {
            ix_mv *g;

            IX_TRY(divide(ctx, *f, i / 2, i % 2, &g));
            ix_mv_unref(ctx, *f);
            *f = g;
        }
    return IX_OK;
}

/* Whether the Gauss curvature is positive by the signs of its coefficients. */
static ix_status is_convex(ix_ctx *ctx, const ix_mv *s, const contact *k,
                           bool *out)
{
    double least = HUGE_VAL;
    ix_status st;
    ix_form f;
    ix_mv *m;

    IX_TRY(ix__form_mul(ctx, &k->c[2][0], &k->c[2][2], &f));
    IX_TRY(ix__form_mul_add(ctx, &k->c[2][1], -1, &k->c[2][1], &f));
    IX_TRY(ix__form_store(ctx, &f, false, NULL, &m));
    st = deflate(ctx, s, &m);
    for (size_t i = 0; st == IX_OK && i < m->npts; i++)
        least = fmin(least, m->pts[i]);
    *out = least > ZERO * ix__bern_largest(m->npts, m->pts);
    ix_mv_unref(ctx, m);
    return st;
}

static ix_status make(ix_ctx *ctx, const ix_mv *s, int order,
                      ix__line_contact *out)
{
    contact *k;
    ix_form g2[2], g3[2], f[3];
    const ix_form *dd[2];
    bool convex;

    IX_SCRATCH(ctx, k, 1);
    IX_TRY(load(ctx, s, order, out->chart, &out->q, k));
    IX_TRY(is_convex(ctx, s, k, &convex));
    if (convex)
        return IX_OK;
    dd[0] = dd[1] = k->d;
    IX_TRY(apply(ctx, 2, k->c[2], dd, &f[0]));
    if (order > 2)
        IX_TRY(acceleration(ctx, k, g2, order > 3 ? g3 : NULL));
    if (order > 2)
        IX_TRY(third(ctx, k, g2, &f[1]));
    if (order > 3)
        IX_TRY(fourth(ctx, k, g2, g3, &f[2]));
    for (; out->n < order - 1; out->n++)
        IX_TRY(ix__form_store(ctx, &f[out->n], false, NULL, &out->f[out->n]));
    for (int i = 0; i < out->n; i++)
        IX_TRY(deflate(ctx, s, &out->f[i]));
    return IX_OK;
}

/* --- ruled surfaces
 * ---------------------------------------------------------------- */

#define GRID 5
#define FLAT 1e-9 /* of the largest value over r: half of the digits */

/* f over r at (u, v). */
static ix_status restrict_to(ix_ctx *ctx, const ix_mv *f, const double uv[2],
                             ix_mv **out)
{
    ix_mv *m;
    ix_status st;

    IX_TRY(ix_mv_fix(ctx, f, 1, uv[1], &m));
    st = ix_mv_fix(ctx, m, 0, uv[0], out);
    ix_mv_unref(ctx, m);
    return st;
}

/* How many zeros g has, and the least |f| at one relative to its largest. */
static ix_status least_at_zeros(ix_ctx *ctx, const ix_mv *g, const ix_mv *f,
                                int *count, double *least)
{
    double size = ix__bern_largest(f->npts, f->pts), x;
    ix_status st = IX_OK;
    ix_root *roots;

    *least = HUGE_VAL;
    IX_TRY(ix_roots(ctx, g, 0, NULL, &roots, count));
    for (int i = 0; st == IX_OK && i < *count; i++) {
        st = ix_mv_eval(ctx, f, &roots[i].t, &x);
        *least = fmin(*least, size > 0.0 ? fabs(x) / size : 0.0);
    }
    ix_roots_free(ctx, roots, *count);
    return st;
}

/* Does h''' vanish for an asymptotic direction of every point of a grid that
 * has one? */
static ix_status check_ruled(ix_ctx *ctx, const ix__line_contact *c)
{
    int with = 0, flat = 0;

    for (int i = 0; i < GRID * GRID; i++) {
        int column = i % GRID, row = i / GRID;
        const double uv[2] = {(column + 0.5153) / GRID, (row + 0.4831) / GRID};
        ix_mv *g, *f = NULL;
        double least = HUGE_VAL;
        int count = 0;
        ix_status st;

        IX_TRY(restrict_to(ctx, c->f[0], uv, &g));
        st = restrict_to(ctx, c->f[1], uv, &f);
        if (st == IX_OK)
            st = least_at_zeros(ctx, g, f, &count, &least);
        ix_mv_unref(ctx, g);
        ix_mv_unref(ctx, f);
        IX_TRY(st);
        with += count > 0;
        flat += count > 0 && least <= FLAT;
    }
    if (with > 0 && flat == with)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the surface is ruled: a line that it contains touches "
                       "it at every point");
    return IX_OK;
}

/* --- calls
 * ---------------------------------------------------------------------- */

static ix_status check(ix_ctx *ctx, const ix_mv *s)
{
    if (s->ndirs != 2 || s->ncoords != 3 || s->dirs[0].basis != IX_BEZIER ||
        s->dirs[1].basis != IX_BEZIER)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a Bezier surface of "
                       "3 coordinates is wanted",
                       s->ndirs, s->ncoords);
    return IX_OK;
}

/* Has the surface a normal, and is it not a plane? */
static ix_status check_curved(ix_ctx *ctx, const ix_mv *s)
{
    ix_surface f;

    IX_TRY(ix__surface_load(ctx, s, &f));
    IX_TRY(ix__surface_forms(ctx, &f));
    for (int i = 0; i < 3; i++)
        if (!ix__form_is_zero(&f.b[i]))
            return IX_OK;
    return IX_FAIL(ctx, IX_EDOMAIN,
                   "the surface is a plane: every line in it is a tangent");
}

ix_status ix__line_contact_make(ix_ctx *ctx, const ix_mv *s, int order,
                                int chart, ix__line_contact *out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    *out = (ix__line_contact){.chart = chart};
    IX_TRY(check(ctx, s));
    for (int d = 0; d < 2; d++)
        ix_mv_domain(s, d, out->dom[d]);
    st = check_curved(ctx, s);
    if (st == IX_OK)
        st = make(ctx, s, order, out);
    ix__scratch_release(ctx, mk);
    if (st == IX_OK && out->n > 1)
        st = check_ruled(ctx, out);
    if (st != IX_OK)
        ix__line_contact_free(ctx, out);
    return st;
}

void ix__line_contact_free(ix_ctx *ctx, ix__line_contact *c)
{
    for (int i = 0; i < c->n; i++)
        ix_mv_unref(ctx, c->f[i]);
    c->n = 0;
}

void ix__line_contact_place(const ix__line_contact *c, const double *x,
                            double out[4])
{
    double r = x[2], ab[2], len;

    ab[0] = c->chart ? 1.0 - 2.0 * r : 1.0;
    ab[1] = c->q * (c->chart ? 1.0 : 2.0 * r - 1.0);
    for (int d = 0; d < 2; d++) {
        double edge = c->dom[d][1] - c->dom[d][0];

        out[d] = c->dom[d][0] + x[d] * edge;
        ab[d] *= edge;
    }
    len = hypot(ab[0], ab[1]);
    for (int d = 0; d < 2; d++)
        out[2 + d] = ab[d] / len;
}

ix_solution ix__line_contact_solution(const ix__line_contact *c,
                                      const ix_solution *s)
{
    double lo[4], hi[4];
    ix_solution o = *s;

    ix__line_contact_place(c, s->x, o.x);
    ix__line_contact_place(c, s->lo, lo);
    ix__line_contact_place(c, s->hi, hi);
    for (int i = 0; i < 4; i++) {
        o.lo[i] = fmin(o.x[i], fmin(lo[i], hi[i]));
        o.hi[i] = fmax(o.x[i], fmax(lo[i], hi[i]));
    }
    return o;
}
