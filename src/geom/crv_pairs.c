/* crv_pairs.c - antipodal points and bitangents of one curve, without the
 * diagonal.
 *
 * With D(t, r) = x(t) w(r) - x(r) w(t) and T = x' w - x w' the conditions are
 * D . T = 0, or D x T = 0, for T at t and at r. They vanish for t = r, to the
 * first or second order; on one span that power of t - r is divided out in the
 * scaled Bernstein basis, where t - r = t (1 - r) - r (1 - t) makes it a
 * recursion along anti-diagonals. Pairs of spans are solved one by one. */
#include "geom/crv_pairs.h"

#include <math.h>
#include <string.h>

#include "bsp/spans.h"
#include "iritx/distance.h"
#include "mv/mv.h"
#include "solve/system_impl.h"

#define MAX_BOXES 20000 /* of one pair of spans, see meet.c */
#define APART                                                          \
    1e-6 /* of the domain: pairs closer than this that are not proven, \
            and all bitangents, belong to the diagonal */

typedef enum { ANTIPODAL, BITANGENT } pair_kind;

typedef struct {
    ix_ctx *ctx;
    pair_kind kind;
    ix_spans sp;
    int d, e, nc; /* degrees of x and T; coordinates */
    double *x[4]; /* scaled: w, coordinates; [nspans][d + 1] */
    double *t[3]; /* scaled: T; [nspans][e + 1] */
    double size;  /* of the curve */
    double *f[2]; /* the equations of one pair */
    const ix_mv *crv;
    ix__found found;
    bool complete;
    size_t boxes;
} pairs;

static double binomial(int n, int k)
{
    double r = 1;

    for (int i = 1; i <= k; i++)
        r = r * (n - k + i) / i;
    return r;
}

/* --- the curve and its tangent
 * ------------------------------------------------------ */

static ix_status load_axis(pairs *p, int axis)
{
    const ix_mv *c = p->crv;
    size_t m = (size_t)p->d + 1, n = (size_t)p->sp.nspans * m;

    IX_SCRATCH(p->ctx, p->x[axis], n);
    if (axis == 0 && !c->rational) {
        for (size_t i = 0; i < n; i++)
            p->x[0][i] = 1;
    } else {
        IX_TRY(ix__spans_extract(
            p->ctx, &c->dirs[0], &p->sp, 1, 1,
            axis ? ix_mv_coord(c, axis - 1) : ix_mv_weights(c), p->x[axis]));
    }
    for (size_t i = 0; i < n; i++) {
        if (axis)
            p->size = fmax(p->size, fabs(p->x[axis][i]));
        p->x[axis][i] *= binomial(p->d, (int)(i % m));
    }
    return IX_OK;
}

/* T of one span: x' for a polynomial, else (x_u w_v - x_v w_u) / d, where the
 * partials of scaled c_i are i c_i and (d - i) c_i. */
static void tangent(const double *x, const double *w, int d, bool rational,
                    double *t)
{
    if (!rational) {
        for (int i = 0; i < d; i++) /* (i+1) c_{i+1} - (d-i) c_i */
            t[i] = (i + 1) * x[i + 1] - (d - i) * x[i];
        return;
    }
    memset(t, 0, (size_t)(2 * d - 1) * sizeof *t);
    for (int i = 0; i <= d; i++)
        for (int j = 0; j <= d; j++) {
            double a = (double)i * (d - j) - (double)(d - i) * j;

            if (i + j > 0 && i + j < 2 * d)
                t[i + j - 1] += a * x[i] * w[j] / d;
        }
}

static ix_status load(pairs *p)
{
    const ix_mv *c = p->crv;
    size_t n;

    IX_TRY(ix__spans_of(p->ctx, &c->dirs[0], &p->sp));
    p->d = p->sp.degree;
    p->e = c->rational ? 2 * p->d - 2 : p->d - 1;
    p->nc = p->kind == BITANGENT ? 2 : c->ncoords;
    for (int k = 0; k <= p->nc && p->d > 0; k++)
        IX_TRY(load_axis(p, k));
    n = (size_t)p->sp.nspans * (size_t)(p->e + 1);
    for (int k = 0; k < p->nc && p->d > 0; k++) {
        IX_SCRATCH(p->ctx, p->t[k], n);
        for (int j = 0; j < p->sp.nspans; j++) {
            size_t at = (size_t)j * (size_t)(p->d + 1);

            tangent(p->x[k + 1] + at, p->x[0] + at, p->d, c->rational,
                    p->t[k] + (size_t)j * (size_t)(p->e + 1));
        }
    }
    n = (size_t)(p->d + p->e + 1) * (size_t)(p->d + 1);
    for (int k = 0; k < 2; k++)
        IX_SCRATCH(p->ctx, p->f[k], n);
    return IX_OK;
}

/* --- the equations of a pair of spans
 * ---------------------------------------------- */

static const double *span(double *const *v, int axis, int i, int degree)
{
    return v[axis] + (size_t)i * (size_t)(degree + 1);
}

/* f += sign D_k(t, r) T_l, T at the first parameter (span i) or at the second
 * (span j); f is scaled, with ns coefficients in the first direction. */
static void add_product(const pairs *p, int k, int l, double sign, int i, int j,
                        bool second, double *f)
{
    const double *xi = span(p->x, k + 1, i, p->d);
    const double *wi = span(p->x, 0, i, p->d);
    const double *xj = span(p->x, k + 1, j, p->d);
    const double *wj = span(p->x, 0, j, p->d);
    const double *t = span(p->t, l, second ? j : i, p->e);
    int ns = p->d + 1 + (second ? 0 : p->e);

    for (int b = 0; b <= p->d; b++)
        for (int a = 0; a <= p->d; a++) {
            double v = sign * (xi[a] * wj[b] - xj[b] * wi[a]);

            for (int q = 0; q <= p->e; q++)
                f[second ? a + (b + q) * ns : a + q + b * ns] += v * t[q];
        }
}

/* f of degrees m and n (scaled) becomes f / (t - r) of degrees m - 1, n - 1:
 * with f = sum f_ij, g_{i-1,j} = f_ij + g_{i,j-1}. */
static void divide(double *f, int m, int n)
{
    for (int j = 0; j < n; j++)
        for (int i = 1; i <= m; i++) {
            double g = i < m && j > 0 ? f[i + (j - 1) * m] : 0;

            f[i - 1 + j * m] = f[i + j * (m + 1)] + g;
        }
}

static void to_bernstein(double *f, int m, int n)
{
    for (int j = 0; j <= n; j++)
        for (int i = 0; i <= m; i++)
            f[i + j * (m + 1)] /= binomial(m, i) * binomial(n, j);
}

static void equation(const pairs *p, int i, int j, bool second, int times,
                     double *f)
{
    int m = p->d + (second ? 0 : p->e), n = p->d + (second ? p->e : 0);

    memset(f, 0, (size_t)(m + 1) * (size_t)(n + 1) * sizeof *f);
    if (p->kind == BITANGENT) {
        add_product(p, 0, 1, 1, i, j, second, f);
        add_product(p, 1, 0, -1, i, j, second, f);
    } else {
        for (int k = 0; k < p->nc; k++)
            add_product(p, k, k, 1, i, j, second, f);
    }
    for (int k = 0; k < times; k++)
        divide(f, m - k, n - k);
    to_bernstein(f, m - times, n - times);
}

/* Equation k of a pair as a multivariate; NULL: the span is straight. */
static ix_status field(pairs *p, int i, int j, int k, int times, ix_mv **out)
{
    int m = p->d + (k ? 0 : p->e) - times + 1;
    int n = p->d + (k ? p->e : 0) - times + 1;
    const ix_dir dirs[2] = {{.basis = IX_BEZIER, .order = m, .length = m},
                            {.basis = IX_BEZIER, .order = n, .length = n}};

    *out = NULL;
    if (m < 1 || n < 1)
        return IX_OK;
    equation(p, i, j, k != 0, times, p->f[k]);
    return ix_mv_new(p->ctx, 2, dirs, 1, false, p->f[k], out);
}

static ix_status tangent_chords(ix_ctx *ctx, const ix_mv *c, int i, int j,
                                ix_mv **out)
{
    pairs p = {.ctx = ctx, .kind = BITANGENT, .crv = c};

    IX_TRY(load(&p));
    if (p.d < 1)
        return IX_OK;
    return field(&p, i, j, 0, i == j ? 2 : 0, out);
}

ix_status ix__tangent_chords(ix_ctx *ctx, const ix_mv *c, int i, int j,
                             ix_mv **out)
{
    *out = NULL;
    IX_RETURN_SCOPED(ctx, tangent_chords(ctx, c, i, j, out));
}

/* --- solutions
 * ------------------------------------------------------------------------ */

static double at(const pairs *p, int i, double u)
{
    const double *br = p->sp.breaks;

    return br[i] + u * (br[i + 1] - br[i]);
}

static ix_status chord(const pairs *p, const double *tr, double *len)
{
    double a[IX_MAX_COORDS], b[IX_MAX_COORDS];

    IX_TRY(ix_mv_point(p->ctx, p->crv, &tr[0], a));
    IX_TRY(ix_mv_point(p->ctx, p->crv, &tr[1], b));
    *len = 0;
    for (int k = 0; k < p->nc; k++)
        *len = fmax(*len, fabs(a[k] - b[k]));
    return IX_OK;
}

/* Keeps solutions with t < r and a chord. */
static ix_status keep(pairs *p, const ix_solutions *sol, int i, int j)
{
    double all = p->sp.breaks[p->sp.nspans] - p->sp.breaks[0];

    for (int k = 0; k < sol->n; k++) {
        ix_solution r = sol->sol[k];
        double len;

        for (int e = 0; e < 2; e++) {
            r.x[e] = at(p, e ? j : i, r.x[e]);
            r.lo[e] = at(p, e ? j : i, r.lo[e]);
            r.hi[e] = at(p, e ? j : i, r.hi[e]);
        }
        if (i == j && !(r.x[0] < r.x[1]))
            continue;
        if ((!r.certified || p->kind == BITANGENT) &&
            !(r.lo[1] - r.hi[0] > APART * all))
            continue;
        IX_TRY(chord(p, r.x, &len));
        if (len <= 1e-7 * p->size) /* a self-intersection, or the seam */
            continue;
        IX_TRY(ix__found_add(&p->found, &r));
    }
    return IX_OK;
}

static ix_status solve_pair(pairs *p, int i, int j)
{
    const ix_solve_opts o = {.max_boxes = MAX_BOXES};
    int times = i == j ? (p->kind == BITANGENT ? 2 : 1) : 0;
    ix_equation eq[2];
    ix_status st = IX_OK;
    ix_solutions sol;
    ix_mv *f[2] = {NULL, NULL};

    for (int k = 0; st == IX_OK && k < 2; k++) {
        st = field(p, i, j, k, times, &f[k]);
        if (st == IX_OK && !f[k]) /* as the other one */
            return IX_OK;
        eq[k] = (ix_equation){.f = f[k], .axis = 0, .rel = IX_EQUAL_ZERO};
    }
    if (st == IX_OK)
        st = ix_solve(p->ctx, 2, eq, &o, &sol);
    for (int k = 0; k < 2; k++)
        ix_mv_unref(p->ctx, f[k]);
    IX_TRY(st);
    p->boxes += sol.boxes;
    p->complete = p->complete && sol.complete;
    st = keep(p, &sol, i, j);
    ix_solutions_free(p->ctx, &sol);
    return st;
}

/* On a closed curve the pairs (t, end) repeat pairs (start, t). */
static ix_status drop_seam(pairs *p)
{
    double end[2] = {p->sp.breaks[0], p->sp.breaks[p->sp.nspans]}, gap;
    double tie = 1e-9 * (end[1] - end[0]);
    int n = 0;

    IX_TRY(chord(p, end, &gap));
    if (!(gap <= 1e-9 * p->size))
        return IX_OK;
    for (int i = 0; i < p->found.n; i++) {
        const ix_solution *r = &p->found.sol[i];
        bool twin = false;

        for (int k = 0; k < p->found.n && end[1] - r->x[1] <= tie; k++) {
            const ix_solution *q = &p->found.sol[k];

            twin |= q->x[0] - end[0] <= tie && fabs(q->x[1] - r->x[0]) <= tie;
        }
        if (!twin)
            p->found.sol[n++] = *r;
    }
    p->found.n = n;
    return IX_OK;
}

static ix_status give(pairs *p, ix_solutions *out)
{
    double all = p->sp.breaks[p->sp.nspans] - p->sp.breaks[0];
    const double edge[2] = {all, all};

    IX_TRY(ix__found_merge(&p->found, 2, edge));
    IX_TRY(drop_seam(p));
    out->unknowns = 2;
    out->boxes = p->boxes;
    out->complete = p->complete;
    if (p->found.n == 0)
        return IX_OK;
    out->bytes = (size_t)p->found.n * sizeof *out->sol;
    out->sol = ix__alloc(p->ctx, out->bytes);
    if (!out->sol)
        return IX_ENOMEM;
    memcpy(out->sol, p->found.sol, out->bytes);
    out->n = p->found.n;
    return IX_OK;
}

static ix_status find(ix_ctx *ctx, const ix_mv *c, pair_kind kind,
                      ix_solutions *out)
{
    pairs p = {.ctx = ctx,
               .kind = kind,
               .crv = c,
               .found = {.ctx = ctx},
               .complete = true};

    IX_TRY(load(&p));
    if (p.d < 1)
        return IX_OK;
    for (int i = 0; i < p.sp.nspans; i++)
        for (int j = i; j < p.sp.nspans; j++)
            IX_TRY(solve_pair(&p, i, j));
    return give(&p, out);
}

static ix_status run(ix_ctx *ctx, const ix_mv *c, pair_kind kind,
                     ix_solutions *out)
{
    int least = kind == BITANGENT ? 2 : 1;
    ix_mark mk;
    ix_status st;

    *out = (ix_solutions){.n = 0};
    if (c->ndirs != 1 || c->ncoords < least || c->ncoords > 3 ||
        c->dirs[0].basis == IX_POWER)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates%s; a Bezier or "
                       "B-spline curve of %d to 3 is wanted",
                       c->ndirs, c->ncoords,
                       c->dirs[0].basis == IX_POWER ? ", power basis" : "",
                       least);
    mk = ix__scratch_mark(ctx);
    st = find(ctx, c, kind, out);
    ix__scratch_release(ctx, mk);
    return st;
}

ix_status ix_crv_antipodal(ix_ctx *ctx, const ix_mv *c, ix_solutions *out)
{
    return run(ctx, c, ANTIPODAL, out);
}

ix_status ix_crv_bitangents(ix_ctx *ctx, const ix_mv *c, ix_solutions *out)
{
    return run(ctx, c, BITANGENT, out);
}
