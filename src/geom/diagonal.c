/* diagonal.c - divided differences and blow-ups of Bezier patches. */
#include "geom/diagonal.h"

#include <string.h>

static double choose(int n, int k)
{
    double r = 1;

    for (int i = 1; i <= k; i++)
        r = r * (n - k + i) / i;
    return r;
}

/* --- kernels: tensors double[..][n0], direction 0 fastest, of which only the
 * first one or two directions are worked on; rest is the product of the others.
 */

/* f (degree d in both first directions) over t0 - t1, as exact division:
 * in scaled form g_{i-1,j} = f_ij + g_{i,j-1}. out[rest][d][d]. */
static void divide_difference(const double *f, int d, size_t rest, double *out)
{
    size_t n = (size_t)d + 1;

    for (size_t r = 0; r < rest; r++, f += n * n, out += (size_t)d * (size_t)d)
        for (int j = 0; j < d; j++)
            for (int i = 1; i <= d; i++) {
                double g = i < d && j > 0
                               ? out[i + (j - 1) * d] * choose(d - 1, i) *
                                     choose(d - 1, j - 1)
                               : 0;
                double v = f[(size_t)i + (size_t)j * n] * choose(d, i) *
                               choose(d, j) +
                           g;

                out[i - 1 + j * d] = v /
                                     (choose(d - 1, i - 1) * choose(d - 1, j));
            }
}

/* f, zero at 0 in direction 0, over that parameter: degree d - 1. */
static void divide_parameter(const double *f, int d, size_t rest, double *out)
{
    for (size_t r = 0; r < rest; r++, f += d + 1, out += d)
        for (int i = 1; i <= d; i++)
            out[i - 1] = f[i] * choose(d, i) / choose(d - 1, i - 1);
}

/* f(s m) in direction 0, of degree d in both: with 1 - s m = (1 - s) + s (1 -
 * m) every term is a positive multiple of a Bernstein function.
 * out[rest][d+1][d+1]. */
static void substitute_product(const double *f, int d, size_t rest, double *out)
{
    int n = d + 1;

    memset(out, 0, rest * (size_t)n * (size_t)n * sizeof *out);
    for (size_t r = 0; r < rest; r++, f += n, out += n * n) {
        for (int k = 0; k <= d; k++)
            for (int e = 0; e <= d - k; e++) {
                double v = f[k] * choose(d, k) * choose(d - k, e);

                /* s^(k+e) (1-s)^rest, m^k (1-m)^e raised to degree d */
                for (int up = 0; up <= d - k - e; up++)
                    out[k + e + (k + up) * n] += v * choose(d - k - e, up);
            }
        for (int j = 0; j <= d; j++)
            for (int i = 0; i <= d; i++)
                out[i + j * n] /= choose(d, i) * choose(d, j);
    }
}

/* --- the same for multivariates ------------------------------------------- */

typedef void (*kernel)(const double *f, int d, size_t rest, double *out);

/* k applied to f, whose first `used` directions (of one degree) become `made`
 * ones of order n. */
static const ix_mv *apply(ix_pool *q, kernel k, const ix_mv *f, int used,
                          int made, int n)
{
    ix_dir dirs[IX_MAX_DIRS];
    size_t rest = 1;
    ix_mv *m;

    if (q->st != IX_OK || !f)
        return NULL;
    for (int i = 0; i < made; i++)
        dirs[i] = (ix_dir){.basis = IX_BEZIER, .order = n, .length = n};
    for (int i = used; i < f->ndirs; i++) {
        dirs[made + i - used] = f->dirs[i];
        rest *= (size_t)f->dirs[i].length;
    }
    q->st = ix__mv_alloc(q->ctx, f->ndirs - used + made, dirs, 1, false, &m);
    if (q->st != IX_OK)
        return NULL;
    k(f->pts, f->dirs[0].order - 1, rest, m->pts);
    *ix__pool_room(q) = m;
    return ix__pool_made(q, IX_OK);
}

static const ix_mv *insert_dir(ix_pool *q, const ix_mv *f, int dir)
{
    if (q->st != IX_OK || !f)
        return NULL;
    return ix__pool_made(q, ix_mv_insert_dir(q->ctx, f, dir, ix__pool_room(q)));
}

static const ix_mv *swap_dirs(ix_pool *q, const ix_mv *f, int a, int b)
{
    if (q->st != IX_OK || !f)
        return NULL;
    return ix__pool_made(q, ix_mv_swap_dirs(q->ctx, f, a, b, ix__pool_room(q)));
}

/* Two more constant directions at a, then at b. */
static const ix_mv *widen(ix_pool *q, const ix_mv *f, int a, int b)
{
    f = insert_dir(q, f, a);
    return b < 0 ? f : insert_dir(q, f, b);
}

static ix__vec widen_all(ix_pool *q, ix__vec v, int a, int b)
{
    for (int k = 0; k < 3; k++)
        v.x[k] = widen(q, v.x[k], a, b);
    v.w = widen(q, v.w, a, b);
    return v;
}

/* The function with direction 0 fixed at 0. */
static const ix_mv *at_edge(ix_pool *q, const ix_mv *f)
{
    if (q->st != IX_OK || !f)
        return NULL;
    return ix__pool_made(q, ix_mv_layer(q->ctx, f, 0, 0, ix__pool_room(q)));
}

/* (x(t0) w(t1) - x(t1) w(t0)) / (t0 - t1) in direction 0 of x(t, ..): a
 * function of (t0, t1, ..), symmetric in both. */
static ix__vec divided(ix_pool *q, ix__vec a)
{
    ix__vec p = widen_all(q, a, 1, -1), r = widen_all(q, a, 0, -1), d;

    d = ix__vec_between(q, p, r);
    for (int k = 0; k < 3; k++)
        if (d.x[k])
            d.x[k] = apply(q, divide_difference, d.x[k], 2, 2,
                           d.x[k]->dirs[0].order - 1);
    return d;
}

/* (x(b, ..) w(0, ..) - x(0, ..) w(b, ..)) / b, and the product of the weights.
 */
static ix__vec from_edge(ix_pool *q, ix__vec a)
{
    ix__vec e = a, d;

    for (int k = 0; k < 3; k++)
        e.x[k] = insert_dir(q, at_edge(q, a.x[k]), 0);
    e.w = insert_dir(q, at_edge(q, a.w), 0);
    d = ix__vec_between(q, a, e);
    for (int k = 0; k < 3; k++)
        if (d.x[k])
            d.x[k] = apply(q, divide_parameter, d.x[k], 1, 1,
                           d.x[k]->dirs[0].order - 1);
    d.w = ix__prod0(q, a.w, e.w);
    return d;
}

static ix__vec blown_up(ix_pool *q, ix__vec a)
{
    const ix_mv **f[4] = {&a.x[0], &a.x[1], &a.x[2], &a.w};

    for (int k = 0; k < 4; k++)
        if (*f[k])
            *f[k] = apply(q, substitute_product, *f[k], 1, 2,
                          (*f[k])->dirs[0].order);
    return a;
}

/* --- pairs -----------------------------------------------------------------
 */

/* P(u, v), Q(s, t) in (u, s, v, t). */
static void apart(ix_pool *q, const ix_mv *a, const ix_mv *b, ix__pair *out)
{
    ix__vec p = ix__vec_of(q, a), r = ix__vec_of(q, b);

    out->p = widen_all(q, p, 1, 3);
    out->q = widen_all(q, r, 0, 2);
    for (int k = 0; k < 2; k++) {
        out->tp[k] = widen_all(q, ix__vec_tangent(q, p, k), 1, 3);
        out->tq[k] = widen_all(q, ix__vec_tangent(q, r, k), 0, 2);
    }
}

static void same(ix_pool *q, const ix_mv *a, ix__pair *out)
{
    ix__vec x = ix__vec_of(q, a), y = x, da, db;

    apart(q, a, a, out);
    da = widen_all(q, divided(q, x), 3, -1); /* (u, s, v) */
    for (int k = 0; k < 3; k++)
        y.x[k] = swap_dirs(q, x.x[k], 0, 1);
    y.w = swap_dirs(q, x.w, 0, 1);
    db = divided(q, y); /* (v, t, s), symmetric in v and t */
    for (int k = 0; k < 3; k++)
        db.x[k] = insert_dir(q, swap_dirs(q, db.x[k], 0, 2), 0);
    out->off = ix__vec_cross(q, da, db);
}

/* The linear function m of (s, m, v, t). */
static const ix_mv *linear_m(ix_pool *q)
{
    const ix_dir d = {.basis = IX_BEZIER, .order = 2, .length = 2};
    const double pts[2] = {0, 1};
    const ix_mv *f;

    if (q->st != IX_OK)
        return NULL;
    f = ix__pool_made(
        q, ix_mv_new(q->ctx, 1, &d, 1, false, pts, ix__pool_room(q)));
    return q->st == IX_OK ? ix__pool_promote(q, f, 4, 1) : NULL;
}

/* P(s, v), Q(s m, t) in (s, m, v, t). */
static void edge(ix_pool *q, const ix_mv *a, const ix_mv *b, ix__pair *out)
{
    ix__vec p = ix__vec_of(q, a), r = ix__vec_of(q, b), e = p, ep, er, along;

    out->p = widen_all(q, p, 1, 3);
    out->q = widen_all(q, blown_up(q, r), 2, -1);
    for (int k = 0; k < 2; k++) {
        out->tp[k] = widen_all(q, ix__vec_tangent(q, p, k), 1, 3);
        out->tq[k] = widen_all(q, blown_up(q, ix__vec_tangent(q, r, k)), 2, -1);
    }
    ep = widen_all(q, from_edge(q, p), 1, 3);
    er = widen_all(q, blown_up(q, from_edge(q, r)), 2, -1);
    for (int k = 0; k < 3; k++)
        e.x[k] = at_edge(q, p.x[k]);
    e.w = at_edge(q, p.w);
    along = ix__vec_promote(q, divided(q, e), 4, 2);
    out->off = ix__vec_sub(
        q, ix__vec_times(q, ep, er.w),
        ix__vec_times(q, ix__vec_times(q, er, ep.w), linear_m(q)));
    out->off = ix__vec_cross(q, out->off, along);
}

void ix__pair_make(ix_pool *q, ix__pair_kind kind, const ix_mv *a,
                   const ix_mv *b, ix__pair *out)
{
    *out = (ix__pair){.p = {{NULL}, NULL}};
    if (kind == IX__PAIR_SAME)
        same(q, a, out);
    else if (kind == IX__PAIR_EDGE)
        edge(q, a, b, out);
    else
        apart(q, a, b, out);
}
