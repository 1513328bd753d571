/* match.c - reparametrisation of one curve so that it corresponds to another.
 *
 * Both curves are sampled; dynamic programming finds the monotone path of
 * pairs (i, j) of samples with the largest mean value of the chosen norm, a
 * spline with non-falling coefficients is fitted to the path, and the second
 * curve is composed with it (Cohen, Elber, Bar-Yehuda 1997). */
#include <math.h>
#include <string.h>

#include "geom/monotone.h"
#include "geom/parts.h"
#include "geom/path.h"
#include "geom/vec3.h"
#include "iritx/geom.h"
#include "iritx/sym.h"

typedef struct {
    double p[3], t[3]; /* point, unit tangent (0 if there is none) */
} sample;

typedef struct {
    const ix_match_opts *o;
    int n; /* samples */
    const sample *a, *b;
    int shift;       /* sample of b at which the match starts */
    double farthest; /* distance of any two samples */
} pairs;

static ix_status take_samples(ix_ctx *ctx, const ix_mv *crv, int n,
                              sample **out)
{
    double d[1][3];
    ix_path p;

    IX_TRY(ix__path_new(ctx, crv, &p));
    IX_TRY(ix__path_no_poles(ctx, &p));
    IX_SCRATCH(ctx, *out, n);
    for (int i = 0; i < n; i++) {
        sample *s = *out + i;
        double a = p.breaks[0], b = p.breaks[p.nspans];
        double t = i == n - 1 ? b : a + (b - a) * i / (n - 1);
        int span = ix__path_span(&p, t);

        ix__path_derivs3(&p, span, t, 0, d);
        memcpy(s->p, d[0], sizeof s->p);
        if (!ix__path_tangent3(&p, span, t, i == n - 1, s->t))
            memset(s->t, 0, sizeof s->t);
    }
    return IX_OK;
}

/* Ruled: the tangents agree, and so do the normals N = T x d at both ends of
 * the ruling, as they do where the ruled surface is developable. A ruling along
 * the tangents says nothing: there the N vanish. */
static double ruled(const sample *a, const sample *b, const double d[3])
{
    double m[3], n[3];

    ix__cross3(a->t, d, m);
    ix__cross3(b->t, d, n);
    return ix__dot3(a->t, b->t) -
           (ix__len3(m) * ix__len3(n) - ix__dot3(m, n)) / 2;
}

/* What pair (i, j) is worth: 1 is the best, below 0 is bad. */
static double value(const pairs *q, int i, int j)
{
    const sample *a = &q->a[i];
    const sample *b = &q->b[(j + q->shift) % (q->n - (q->shift ? 1 : 0))];
    double d[3], len;

    ix__sub3(b->p, a->p, d);
    len = ix__unit3(d, d); /* 0: d stays 0 */
    switch (q->o->norm) {
    case IX_MATCH_RULED:
        return ruled(a, b, d);
    case IX_MATCH_WALK:
        return q->farthest > 0 ? 1 - len / q->farthest : 1;
    case IX_MATCH_BISECT: /* a's tangent mirrored at the bisecting plane */
        return ix__dot3(a->t, b->t) - 2 * ix__dot3(a->t, d) * ix__dot3(b->t, d);
    case IX_MATCH_MORPH:
        break;
    }
    return ix__dot3(a->t, b->t);
}

/* The pair's value, -HUGE_VAL if it may not be used. */
static double allowed(const void *arg, int i, int j)
{
    const pairs *q = arg;
    double v = value(q, i, j);

    return v > 0 || q->o->allow_negative ? v : -HUGE_VAL;
}

/* Best mean value over monotone paths from (0, 0) to (n-1, n-1). */
static double best_path(const pairs *q, double *work, char *from)
{
    const ix__monotone m = {allowed, q, q->n, 0};
    int end[2];

    return ix__monotone_best(&m, work, from, end) / (q->n - 1);
}

/* The shift with the best path: a coarse search over all, then a fine one
 * around the best (shifts move the value smoothly). */
static ix_status best_shift(ix_ctx *ctx, pairs *q, double *work)
{
    int stride = 1 + (q->n - 1) / 64, best = 0, m = (q->n - 1) / stride + 1;
    double top = -HUGE_VAL;
    pairs c = *q;
    sample *a, *b;

    IX_SCRATCH(ctx, a, m);
    IX_SCRATCH(ctx, b, m);
    for (int i = 0; i < m; i++) {
        a[i] = q->a[i * stride];
        b[i] = q->b[i * stride];
    }
    c.a = a;
    c.b = b;
    c.n = m;
    for (c.shift = 0; c.shift < m - 1; c.shift++) {
        double v = best_path(&c, work, NULL);

        if (v > top) {
            top = v;
            best = c.shift * stride;
        }
    }
    q->shift = best;
    top = -HUGE_VAL;
    for (int k = 1 - stride; k < stride; k++) {
        pairs f = *q;
        double v;

        IX_TRY(ix__poll(ctx));
        f.shift = (best + k + q->n - 1) % (q->n - 1);
        v = best_path(&f, work, NULL);
        if (v > top) {
            top = v;
            q->shift = f.shift;
        }
    }
    return IX_OK;
}

/* Nearest non-falling sequence (pooling adjacent violators). */
static void make_monotone(int n, double *c, double *mean, int *count)
{
    int m = 0;

    for (int i = 0; i < n; i++) {
        mean[m] = c[i];
        count[m++] = 1;
        while (m > 1 && mean[m - 2] > mean[m - 1]) {
            int k = count[m - 2] + count[m - 1];

            mean[m - 2] = (mean[m - 2] * count[m - 2] +
                           mean[m - 1] * count[m - 1]) /
                          k;
            count[m - 2] = k;
            m--;
        }
    }
    for (int i = 0, k = 0; k < m; k++)
        for (int j = 0; j < count[k]; j++)
            c[i++] = mean[k];
}

/* Pairs of the path as t[] (of c1) and r[] (of c2), both in [0, 1]. */
static ix_status trace(ix_ctx *ctx, const pairs *q, const char *from, int *m,
                       double *t, double *r)
{
    const int end[2] = {q->n - 1, q->n - 1};
    int *i, *j;

    IX_SCRATCH(ctx, i, 2 * q->n);
    IX_SCRATCH(ctx, j, 2 * q->n);
    *m = ix__monotone_trace(q->n, from, end, i, j);
    for (int k = 0; k < *m; k++) {
        t[k] = (double)i[k] / (q->n - 1);
        r[k] = (double)j[k] / (q->n - 1);
    }
    return IX_OK;
}

/* r(t) as a scalar curve over c1's domain with values in c2's. */
static ix_status fit_map(ix_ctx *ctx, const ix_match_opts *o, int m,
                         const double *t, const double *r, const double d1[2],
                         const double d2[2], ix_mv **out)
{
    ix_dir dir = {.basis = IX_BSPLINE, .order = o->order, .length = o->length};
    int nk = o->order + o->length, *count;
    double *knots, *c, *mean;
    ix_mv *fit = NULL;

    IX_SCRATCH(ctx, knots, nk);
    IX_SCRATCH(ctx, c, o->length);
    IX_SCRATCH(ctx, mean, o->length);
    IX_SCRATCH(ctx, count, o->length);
    IX_TRY(ix_knots_make(ctx, IX_KV_OPEN, o->order, o->length, knots));
    IX_TRY(ix_interpolate(ctx, m, 1, false, r,
                          &(ix_interpolate_opts){.order = o->order,
                                                 .size = o->length,
                                                 .nparams = m,
                                                 .params = t,
                                                 .nknots = nk,
                                                 .knots = knots},
                          NULL, &fit));
    memcpy(c, ix_mv_coord(fit, 0), (size_t)o->length * sizeof *c);
    ix_mv_unref(ctx, fit);
    make_monotone(o->length, c, mean, count);
    c[0] = 0;
    c[o->length - 1] = 1;
    for (int i = 0; i < o->length; i++)
        c[i] = d2[0] + fmin(1, fmax(0, c[i])) * (d2[1] - d2[0]);
    for (int i = 0; i < nk; i++)
        knots[i] = knots[i] == 1 ? d1[1] : d1[0] + knots[i] * (d1[1] - d1[0]);
    dir.knots = knots;
    return ix_mv_new(ctx, 1, &dir, 1, false, c, out);
}

/* c2 as a B-spline that starts at fraction x of its domain, once around. */
static ix_status move_seam(ix_ctx *ctx, const ix_mv *c2, double x, ix_mv **out)
{
    ix_mv *t[4] = {NULL}, *half[2] = {NULL};
    double dom[2];
    ix_status st = ix_mv_to_bspline(ctx, c2, &t[0]);

    if (st == IX_OK)
        st = ix_mv_to_open(ctx, t[0], &t[1]);
    if (st == IX_OK) {
        ix_mv_domain(t[1], 0, dom);
        st = ix_mv_split(ctx, t[1], 0, dom[0] + x * (dom[1] - dom[0]), half);
    }
    if (st == IX_OK)
        st = ix_mv_merge(ctx, half[1], half[0], 0, IX_JOIN_SHARED, out);
    ix__mv_unref_all(ctx, half, 2);
    ix__mv_unref_all(ctx, t, 4);
    return st;
}

static bool closed(const sample *s, int n)
{
    double d[3], size = 0;

    for (int i = 1; i < n; i++)
        size = fmax(size, ix__dist3(s[0].p, s[i].p));
    ix__sub3(s[0].p, s[n - 1].p, d);
    return ix__len3(d) <= 1e-5 * size; /* "approximately equal" */
}

static ix_status find(ix_ctx *ctx, pairs *q, int *m, double **t, double **r,
                      double *worth)
{
    size_t n = (size_t)q->n;
    double *work;
    char *from;

    IX_SCRATCH(ctx, work, 4 * n);
    IX_SCRATCH(ctx, from, n * n);
    IX_SCRATCH(ctx, *t, 2 * n);
    IX_SCRATCH(ctx, *r, 2 * n);
    for (int i = 0; i < q->n; i++)
        for (int j = 0; q->o->norm == IX_MATCH_WALK && j < q->n; j++)
            q->farthest = fmax(q->farthest, ix__dist3(q->a[i].p, q->b[j].p));
    if (q->o->rotate && closed(q->b, q->n) && q->n > 3)
        IX_TRY(best_shift(ctx, q, work));
    *worth = best_path(q, work, from);
    if (!(*worth > -HUGE_VAL))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "no match: every way from start to end has pairs of "
                       "negative value");
    return trace(ctx, q, from, m, *t, *r);
}

static ix_status match(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                       const ix_match_opts *o, double *worth, ix_mv *tmp[2],
                       ix_mv **out)
{
    pairs q = {.o = o, .n = o->samples};
    double *t, *r, d1[2], d2[2];
    sample *a, *b;
    int m;

    IX_TRY(take_samples(ctx, c1, o->samples, &a));
    IX_TRY(take_samples(ctx, c2, o->samples, &b));
    q.a = a;
    q.b = b;
    IX_TRY(find(ctx, &q, &m, &t, &r, worth));
    if (q.shift)
        IX_TRY(move_seam(ctx, c2, (double)q.shift / (q.n - 1), &tmp[0]));
    else
        tmp[0] = ix_mv_ref(c2);
    ix_mv_domain(c1, 0, d1);
    ix_mv_domain(tmp[0], 0, d2);
    IX_TRY(fit_map(ctx, o, m, t, r, d1, d2, &tmp[1]));
    return ix_sym_compose(ctx, tmp[0], tmp[1], out);
}

ix_status ix_match(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                   const ix_match_opts *o, double *worth, ix_mv **out)
{
    const int most = 4096; /* samples: 16 M steps to remember */
    ix_mark mk = ix__scratch_mark(ctx);
    ix_mv *tmp[2] = {NULL};
    double w = 0;
    ix_status st;

    *out = NULL;
    if (o->samples < 2 || o->samples > most)
        return IX_FAIL(ctx, IX_EARG, "%d samples: want 2 .. %d", o->samples,
                       most);
    if (o->order < 2 || o->order > o->length || o->length > o->samples)
        return IX_FAIL(ctx, IX_EARG,
                       "2 <= order %d <= length %d <= samples %d is not so",
                       o->order, o->length, o->samples);
    if (o->norm < IX_MATCH_RULED || o->norm > IX_MATCH_BISECT)
        return IX_FAIL(ctx, IX_EARG, "norm %d is not within 1 .. 4",
                       (int)o->norm);
    st = match(ctx, c1, c2, o, &w, tmp, out);
    if (worth)
        *worth = w;
    ix__mv_unref_all(ctx, tmp, 2);
    ix__scratch_release(ctx, mk);
    return st;
}
