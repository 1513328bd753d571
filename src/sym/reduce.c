/* reduce.c - the same map in lower degree and with fewer knots.
 *
 * Rows are brought to size 1 (weights and coordinates each by a power of two),
 * so that one tolerance holds for all. Each step is checked by undoing it. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "sym/factor.h"
#include "sym/form_impl.h"

#define DEFAULT_TOL 1e-12

typedef struct {
    ix_form f;
    double tol, change;
    int degrees, factors;
} reduction;

/* --- leading coefficients ------------------------------------------------- */

/* One degree less: from b_k = (k q_{k-1} + (d-k) q_k) / d the lower half of q
 * is found from below, the upper from above, where errors shrink. Returns the
 * largest change when raised again. b, q with stride. */
static double lower_line(int d, const double *b, size_t step, double *q)
{
    int half = (d - 1) / 2;
    double worst = 0.0;

    q[0] = b[0];
    for (int k = 1; k <= half; k++)
        q[(size_t)k * step] = (d * b[(size_t)k * step] -
                               k * q[(size_t)(k - 1) * step]) /
                              (d - k);
    if (d > 1)
        q[(size_t)(d - 1) * step] = b[(size_t)d * step];
    for (int k = d - 2; k > half; k--)
        q[(size_t)k * step] = (d * b[(size_t)(k + 1) * step] -
                               (d - k - 1) * q[(size_t)(k + 1) * step]) /
                              (k + 1);
    for (int k = 0; k <= d; k++) {
        double lo = k > 0 ? k * q[(size_t)(k - 1) * step] : 0.0;
        double hi = k < d ? (d - k) * q[(size_t)k * step] : 0.0;

        worst = fmax(worst, fabs((lo + hi) / d - b[(size_t)k * step]));
    }
    return worst;
}

/* One degree less in direction dir if no coefficient changes beyond tol. */
static ix_status lower(ix_ctx *ctx, reduction *r, int dir, bool *done)
{
    ix_spans sp = r->f.dirs[dir];
    const double *b;
    double worst = 0.0;
    ix__shape s;
    ix_form q;

    *done = false;
    if (sp.degree == 0)
        return IX_OK;
    sp.degree--;
    IX_TRY(ix__form_bernstein(ctx, &r->f, &b));
    IX_TRY(ix__form_like(ctx, &r->f, dir, sp, &q));
    ix__form_shape(&r->f, dir, &s);
    for (size_t i = 0; i < s.outer * s.nspans; i++)
        for (size_t l = 0; l < s.inner; l++)
            worst = fmax(
                worst,
                lower_line(sp.degree + 1,
                           b + i * ((size_t)sp.degree + 2) * s.inner + l,
                           s.inner,
                           q.c + i * ((size_t)sp.degree + 1) * s.inner + l));
    if (!(r->change + worst <= r->tol))
        return IX_OK;
    IX_TRY(ix__form_scale_in(ctx, &q, q.c));
    q.exp = 0;
    r->f = q;
    r->change += worst;
    r->degrees++;
    *done = true;
    return IX_OK;
}

/* --- common factors ------------------------------------------------------- */

/* The lines of one span in one direction as a bundle, and back. */
typedef struct {
    const ix_form *f;
    int dir;
    ix__shape s;
    const double *row; /* binomials of the degree */
    const double *b;   /* Bernstein coefficients of f */
    double *lines;     /* [s.outer * s.inner][degree + 1], scaled in dir */
} span_lines;

static ix_status open_lines(ix_ctx *ctx, const ix_form *f, int dir,
                            span_lines *l)
{
    int d = f->dirs[dir].degree;
    double *room;

    *l = (span_lines){.f = f, .dir = dir};
    ix__form_shape(f, dir, &l->s);
    IX_SCRATCH(ctx, room, d + 1);
    l->row = ix__binom(d, room);
    IX_TRY(ix__form_bernstein(ctx, f, &l->b));
    IX_SCRATCH(ctx, l->lines, l->s.outer * l->s.inner * (size_t)(d + 1));
    return IX_OK;
}

static ix__bundle gather(const span_lines *l, size_t span, double tol)
{
    size_t n = (size_t)l->f->dirs[l->dir].degree + 1, at = 0;

    for (size_t o = 0; o < l->s.outer; o++)
        for (size_t i = 0; i < l->s.inner; i++)
            for (size_t k = 0; k < n; k++)
                l->lines[at++] =
                    l->row[k] *
                    l->b[((o * l->s.nspans + span) * n + k) * l->s.inner + i];
    return (ix__bundle){(int)n - 1, l->s.outer * l->s.inner, l->lines, tol};
}

/* The largest degree that every span's lines have in common, and the factors
 * h[span][degree of f + 1]. */
static ix_status find_factors(ix_ctx *ctx, const span_lines *l, double tol,
                              double *h, int *degree, double *change)
{
    size_t n = (size_t)l->f->dirs[l->dir].degree + 1;
    int most = (int)n - 1;
    bool again = true;

    while (again && most > 0) {
        again = false;
        *change = 0.0;
        for (size_t j = 0; j < l->s.nspans && most > 0; j++) {
            ix__bundle b = gather(l, j, tol);
            double c;
            int k;

            IX_TRY(ix__common_factor(ctx, &b, most, h + j * n, &k, &c));
            again |= k < most && j > 0;
            most = k < most ? k : most;
            *change = fmax(*change, c);
        }
    }
    *degree = most;
    return IX_OK;
}

/* q's coefficients (Bernstein in all directions) of one span, from the lines
 * divided by h. */
static ix_status divide_span(ix_ctx *ctx, const span_lines *l, size_t span,
                             int k, const double *h, const double *row,
                             ix_form *q)
{
    size_t n = (size_t)q->dirs[l->dir].degree + 1, at = 0;
    ix__bundle b = gather(l, span, 0.0);
    double *quot, unused;

    IX_SCRATCH(ctx, quot, b.n * n);
    IX_TRY(ix__divide_all(ctx, &b, k, h, quot, &unused));
    for (size_t o = 0; o < l->s.outer; o++)
        for (size_t i = 0; i < l->s.inner; i++)
            for (size_t m = 0; m < n; m++)
                q->c[((o * l->s.nspans + span) * n + m) * l->s.inner + i] =
                    quot[at++] / row[m];
    return IX_OK;
}

/* Factors of different spans are known up to constants: those of the spans
 * behind the first are chosen so that the quotients join. False if at some
 * break no constant does, within tol. */
static bool join_spans(const span_lines *l, double tol, ix_form *q)
{
    const ix_spans *sp = &q->dirs[l->dir];
    size_t n = (size_t)sp->degree + 1, inner = l->s.inner;

    for (size_t j = 0; j + 1 < l->s.nspans; j++) {
        double ab = 0.0, bb = 0.0, top = 0.0, worst = 0.0, f;

        if (sp->cont[j] < 0)
            continue;
        for (int pass = 0; pass < 2; pass++) {
            f = pass > 0 && bb > 0.0 ? ab / bb : 1.0;
            for (size_t o = 0; o < l->s.outer; o++)
                for (size_t i = 0; i < inner; i++) {
                    size_t at = ((o * l->s.nspans + j) * n + n) * inner + i;
                    double x = q->c[at - inner], y = q->c[at];

                    ab += x * y;
                    bb += y * y;
                    top = fmax(top, fabs(x));
                    worst = pass ? fmax(worst, fabs(x - f * y)) : 0.0;
                }
        }
        if (!(worst <= tol * top) || f == 0.0)
            return false;
        for (size_t o = 0; o < l->s.outer; o++)
            for (size_t i = 0; i < n * inner; i++)
                q->c[((o * l->s.nspans + j + 1) * n) * inner + i] *= f;
    }
    return true;
}

/* Continuity of the quotient: at least that it joins where f does. */
static ix_status joined_cont(ix_ctx *ctx, ix_spans *sp)
{
    int *cont;

    IX_SCRATCH(ctx, cont, sp->nspans);
    for (int j = 0; j + 1 < sp->nspans; j++)
        cont[j] = sp->cont[j] < 0 ? -1 : 0;
    sp->cont = cont;
    return IX_OK;
}

static ix_status divide(ix_ctx *ctx, reduction *r, int dir)
{
    ix_spans sp = r->f.dirs[dir];
    double *h, *room, change = 0.0;
    const double *row;
    span_lines l;
    ix_form q;
    int k;

    IX_TRY(open_lines(ctx, &r->f, dir, &l));
    IX_SCRATCH(ctx, h, ix__spans_size(&sp));
    IX_TRY(find_factors(ctx, &l, r->tol - r->change, h, &k, &change));
    if (k == 0)
        return IX_OK;
    IX_TRY(joined_cont(ctx, &sp));
    sp.degree -= k;
    IX_TRY(ix__form_like(ctx, &r->f, dir, sp, &q));
    IX_SCRATCH(ctx, room, sp.degree + 1);
    row = ix__binom(sp.degree, room);
    for (size_t j = 0; j < l.s.nspans; j++)
        IX_TRY(divide_span(ctx, &l, j, k,
                           h + j * (size_t)(r->f.dirs[dir].degree + 1), row,
                           &q));
    if (!join_spans(&l, r->tol, &q))
        return IX_OK;
    IX_TRY(ix__form_scale_in(ctx, &q, q.c));
    q.exp = 0;
    r->f = q;
    r->change += change;
    r->degrees += k;
    r->factors += k;
    return IX_OK;
}

/* --- knots ---------------------------------------------------------------- */

static int knots_of(const ix_mv *m)
{
    int n = 0;

    for (int i = 0; i < m->ndirs; i++)
        n += ix_mv_nknots(m, i);
    return n;
}

/* All directions in turn, axes taken as coordinates; *m is replaced. */
static ix_status remove_knots(ix_ctx *ctx, double tol, ix_mv **m)
{
    for (int i = 0; i < (*m)->ndirs; i++) {
        ix_mv *less;

        IX_TRY(ix_mv_remove_knots(ctx, *m, i, tol, &less));
        ix_mv_unref(ctx, *m);
        *m = less;
    }
    return IX_OK;
}

/* By how much two polynomial multivariates differ. */
static ix_status difference(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                            double *gap)
{
    const ix_mv *m[2] = {a, b};
    ix_form f[2], d;

    IX_TRY(ix__forms_load(ctx, 2, m, NULL, f));
    IX_TRY(ix__form_add(ctx, &f[0], -1, &f[1], &d));
    return ix__form_bound(ctx, &d, gap);
}

/* --- all together --------------------------------------------------------- */

/* Rows to size 1: exponents of weight and coordinates. */
static ix_status normalise(ix_ctx *ctx, bool rational, ix_form *f, int exp[2])
{
    int first = rational ? 1 : 0;
    ix_form group[2] = {ix__form_rows(f, 0, first),
                        ix__form_rows(f, first, f->nrows - first)};
    double big;

    for (int i = 0; i < 2; i++) {
        exp[i] = 0;
        if (group[i].nrows == 0)
            continue;
        IX_TRY(ix__form_bound(ctx, &group[i], &big));
        (void)frexp(big, &exp[i]);
        ix__form_times(&group[i], ldexp(1.0, f->exp - exp[i]));
    }
    f->exp = 0;
    return IX_OK;
}

/* The result: m's axes, its first one a weight again, at their old sizes. */
static ix_status finish(ix_ctx *ctx, const ix_mv *m, bool rational,
                        const int exp[2], ix_mv **out)
{
    ix_mv *r;

    IX_TRY(ix__mv_alloc(ctx, m->ndirs, m->dirs, m->naxes - (rational ? 1 : 0),
                        rational, &r));
    for (size_t i = 0; i < (size_t)m->naxes * m->npts; i++)
        r->pts[i] = ldexp(m->pts[i], rational && i < m->npts ? exp[0] : exp[1]);
    *out = r;
    return IX_OK;
}

static ix_status lower_all(ix_ctx *ctx, bool rational, reduction *r)
{
    for (int i = 0; i < r->f.ndirs; i++) {
        bool more = true;

        while (more)
            IX_TRY(lower(ctx, r, i, &more));
        if (rational)
            IX_TRY(divide(ctx, r, i));
    }
    return IX_OK;
}

/* f as a multivariate without needless knots, its rows as coordinates, in *m.
 * (One row more than coordinates there can be is left with its knots.) */
static ix_status strip(ix_ctx *ctx, reduction *r, ix_mv **m, int *removed)
{
    bool crowded = r->f.nrows > IX_MAX_COORDS;
    ix_status st;
    double gap;
    ix_mv *all;

    *removed = 0;
    IX_TRY(ix__form_store(ctx, &r->f, crowded, NULL, m));
    if (crowded)
        return IX_OK;
    all = ix_mv_ref(*m);
    st = remove_knots(ctx, r->tol, m);
    *removed = knots_of(all) - knots_of(*m);
    if (st == IX_OK && *removed > 0) {
        st = difference(ctx, all, *m, &gap);
        r->change += gap;
    }
    ix_mv_unref(ctx, all);
    return st;
}

static ix_status reduce(ix_ctx *ctx, const ix_mv *a, reduction *r, ix_mv **out)
{
    int exp[2] = {0, 0}, removed = 0;
    ix_mv *m = NULL;
    ix_status st;

    IX_TRY(ix__forms_load(ctx, 1, &a, NULL, &r->f));
    IX_TRY(normalise(ctx, a->rational, &r->f, exp));
    IX_TRY(lower_all(ctx, a->rational, r));
    st = strip(ctx, r, &m, &removed);
    if (st == IX_OK && r->degrees == 0 && removed == 0)
        *out = ix_mv_ref(a);
    else if (st == IX_OK)
        st = finish(ctx, m, a->rational, exp, out);
    ix_mv_unref(ctx, m);
    return st;
}

ix_status ix_sym_reduce(ix_ctx *ctx, const ix_mv *a, double tol,
                        ix_reduce_report *rep, ix_mv **out)
{
    reduction r = {.tol = tol == 0.0 ? DEFAULT_TOL : tol};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    *out = NULL;
    if (!(tol >= 0.0))
        return IX_FAIL(ctx, IX_EARG, "a tolerance of %g", tol);
    st = reduce(ctx, a, &r, out);
    if (st == IX_OK && rep)
        *rep = (ix_reduce_report){r.change, r.degrees, r.factors};
    ix__scratch_release(ctx, mk);
    return st;
}
