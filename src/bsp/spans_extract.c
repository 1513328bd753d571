/* spans_extract.c - B-spline coefficients to Bernstein coefficients, span by
 * span, by knot insertion: convex combinations only.
 *
 * On a span [a, b], first every knot before it becomes a: the coefficient of
 * the knots z .. y' and the one of z' .. y make the one of z' .. y', a. Then
 * every knot behind it becomes b. Knots that are there already are skipped.
 *
 * A row is one (outer, inner) pair. Where neighbouring rows are contiguous,
 * LANES of them go through a span together; elsewhere FOUR spans go through
 * together, their knot ratios computed once for all rows. */
#include <string.h>

#include "base/threads.h"
#include "bern/clones.h"
#include "bsp/knots.h"
#include "bsp/spans.h"

#define LANES 8
#define FOUR  4
/* Four spans together up to this degree: the table of steps is on the stack. */
#define MAX_FOUR 16

typedef struct {
    const double *knots, *breaks;
    const double *in;
    double *out;
    int degree, length, nspans;
    size_t inner, nrows, nbatches;
    const int *mu; /* [nspans]: the knot span that holds each span */
} job;

/* x = r x + s y with r + s = 1, on n lanes, from the nearer of both: equal x
 * and y stay as they are, so that a constant stays exactly constant. */
static inline void mix(double *x, double r, const double *y, double s, int n)
{
    if (s <= r)
        for (int l = 0; l < n; l++)
            x[l] += s * (y[l] - x[l]);
    else
        for (int l = 0; l < n; l++)
            x[l] = y[l] + r * (x[l] - y[l]);
}

/* --- one span, n lanes -----------------------------------------------------
 */

/* On [a, b] inside the knot span mu: buf[degree + 1][n] holds the B-spline
 * coefficients c[mu - degree .. mu], then the Bernstein coefficients. */
IX__INLINE void extract_span(const double *knots, int mu, int degree,
                             const double ab[2], double *buf, int n)
{
    const double a = ab[0], b = ab[1];
    int m = 0, e;

    while (m < degree && knots[mu - m] == a)
        m++;
    e = degree - m;
    for (int s = 1; s <= e; s++) {
        const double *z = knots + mu - degree + s, *y = knots + mu + 1;

        for (int i = 0; i <= e - s; i++) {
            double g = 1 / (y[i] - z[i]);

            mix(buf + i * n, (y[i] - a) * g, buf + (i + 1) * n, (a - z[i]) * g,
                n);
        }
    }
    m = 0;
    while (m < degree && knots[mu + 1 + m] == b)
        m++;
    for (int r = 1; r <= degree - m; r++) {
        const double *y = knots + mu + 1 - r;

        for (int j = degree; j >= r + m; j--) {
            double g = 1 / (y[j] - a);

            mix(buf + j * n, (b - a) * g, buf + (j - 1) * n, (y[j] - b) * g, n);
        }
    }
}

void ix__span_matrix(const double *knots, int mu, int degree,
                     const double ab[2], double *out)
{
    int n = degree + 1;

    memset(out, 0, (size_t)n * (size_t)n * sizeof *out);
    for (int i = 0; i < n; i++)
        out[i * n + i] = 1;
    extract_span(knots, mu, degree, ab, out, n);
}

/* Offset of point 0 of row r in an array with n points a row. */
static size_t row_offset(const job *jb, size_t r, size_t n)
{
    return r / jb->inner * n * jb->inner + r % jb->inner;
}

static void extract_one(const job *jb, int span, size_t row, double *buf)
{
    int order = jb->degree + 1, first = jb->mu[span] - jb->degree;
    size_t n = (size_t)jb->nspans * (size_t)order;
    const double *in = jb->in + row_offset(jb, row, (size_t)jb->length);
    double *out = jb->out + row_offset(jb, row, n) +
                  (size_t)span * (size_t)order * jb->inner;

    for (int i = 0; i < order; i++)
        buf[i] = in[(size_t)((first + i) % jb->length) * jb->inner];
    extract_span(jb->knots, jb->mu[span], jb->degree, jb->breaks + span, buf,
                 1);
    for (int i = 0; i < order; i++)
        out[(size_t)i * jb->inner] = buf[i];
}

static void extract_lanes(const job *jb, int span, size_t row, double *buf)
{
    int order = jb->degree + 1, first = jb->mu[span] - jb->degree;
    size_t n = (size_t)jb->nspans * (size_t)order;
    size_t from[LANES], to[LANES];

    for (size_t l = 0; l < LANES; l++) {
        size_t r = row + l < jb->nrows ? row + l : jb->nrows - 1;

        from[l] = row_offset(jb, r, (size_t)jb->length);
        to[l] = row_offset(jb, r, n) + (size_t)span * (size_t)order * jb->inner;
    }
    for (int i = 0; i < order; i++) {
        const double *in = jb->in +
                           (size_t)((first + i) % jb->length) * jb->inner;

        for (int l = 0; l < LANES; l++)
            buf[i * LANES + l] = in[from[l]];
    }
    extract_span(jb->knots, jb->mu[span], jb->degree, jb->breaks + span, buf,
                 LANES);
    for (int i = 0; i < order; i++) {
        double *out = jb->out + (size_t)i * jb->inner;

        for (int l = 0; l < LANES; l++) /* a row twice: the same value twice */
            out[to[l]] = buf[i * LANES + l];
    }
}

/* --- four spans -------------------------------------------------------------
 * A step takes x and y to base + f (y - x), base the nearer of both. */

typedef long long mask __attribute__((vector_size(sizeof(ix__v4))));

typedef struct {
    mask near; /* -1 where base is x */
    ix__v4 f;
} mix4;

IX__INLINE void make_mix(const ix__v4 *r, const ix__v4 *s, mix4 *out)
{
    out->near = *s <= *r;
    out->f = (ix__v4)(((mask)*s & out->near) | ((mask) - *r & ~out->near));
}

IX__INLINE void apply_mix(const mix4 *m, const ix__v4 *x, const ix__v4 *y,
                          ix__v4 *out)
{
    ix__v4 base = (ix__v4)(((mask)*x & m->near) | ((mask)*y & ~m->near));

    *out = base + m->f * (*y - *x);
}

/* The four spans from one on (the last repeated if there are fewer). */
typedef struct {
    int mu[FOUR];
    int before, behind; /* knots that are at a and at b in all four */
    bool next;          /* each begins one knot after the other */
    ix__v4 a, b;
    size_t to[FOUR]; /* where their coefficients go in a row */
} four;

static int knots_at(const double *k, int step, int most, double x)
{
    int m = 0;

    while (m < most && k[m * step] == x)
        m++;
    return m;
}

static void choose_four(const job *jb, int span, four *f)
{
    f->before = f->behind = jb->degree;
    f->next = true;
    for (int l = 0; l < FOUR; l++) {
        int j = span + l < jb->nspans ? span + l : jb->nspans - 1;
        const double *k = jb->knots + jb->mu[j];

        f->mu[l] = jb->mu[j];
        f->next = f->next && f->mu[l] == f->mu[0] + l;
        f->a[l] = jb->breaks[j];
        f->b[l] = jb->breaks[j + 1];
        f->to[l] = (size_t)j * (size_t)(jb->degree + 1) * jb->inner;
        f->before = knots_at(k, -1, f->before, f->a[l]);
        f->behind = knots_at(k + 1, 1, f->behind, f->b[l]);
    }
}

/* Knot mu + k of each span. */
IX__INLINE void knots_of(const job *jb, const four *f, int k, ix__v4 *out)
{
    const double *t = jb->knots + k;

    *out = f->next
               ? *ix__cvec(t + f->mu[0])
               : (ix__v4){t[f->mu[0]], t[f->mu[1]], t[f->mu[2]], t[f->mu[3]]};
}

/* The steps in the order in which extract_four takes them. */
IX__INLINE void plan_four(const job *jb, const four *f, mix4 *m)
{
    int d = jb->degree, e = d - f->before;
    ix__v4 z, y, g, r, s;

    for (int k = 1; k <= e; k++)
        for (int i = 0; i <= e - k; i++) {
            knots_of(jb, f, i + k - d, &z);
            knots_of(jb, f, i + 1, &y);
            g = 1 / (y - z);
            r = (y - f->a) * g;
            s = (f->a - z) * g;
            make_mix(&r, &s, m++);
        }
    for (int q = f->behind + 1; q <= d; q++) {
        knots_of(jb, f, q, &y);
        g = 1 / (y - f->a);
        r = (f->b - f->a) * g;
        s = (y - f->b) * g;
        make_mix(&r, &s, m++);
    }
}

IX__INLINE void run_four(int d, const four *f, const mix4 *m, ix__v4 *c)
{
    int e = d - f->before;

    for (int k = 1; k <= e; k++)
        for (int i = 0; i <= e - k; i++)
            apply_mix(m++, c + i, c + i + 1, c + i);
    m -= f->behind + 1;
    for (int r = 1; r <= d - f->behind; r++)
        for (int j = d; j >= r + f->behind; j--)
            apply_mix(m + (j - r + 1), c + j, c + j - 1, c + j);
}

IX__INLINE void load_four(const job *jb, const four *f, const double *in,
                          ix__v4 *c)
{
    int d = jb->degree, n = jb->length;

    for (int i = 0; i <= d; i++) {
        int k = i - d, first = f->mu[0] + k;

        if (f->next && jb->inner == 1 && first + 3 < n)
            c[i] = *ix__cvec(in + first);
        else
            c[i] = (ix__v4){in[(size_t)(first % n) * jb->inner],
                            in[(size_t)((f->mu[1] + k) % n) * jb->inner],
                            in[(size_t)((f->mu[2] + k) % n) * jb->inner],
                            in[(size_t)((f->mu[3] + k) % n) * jb->inner]};
    }
}

IX__CLONES static void extract_four(const job *jb, int span)
{
    size_t n = (size_t)jb->nspans * (size_t)(jb->degree + 1);
    mix4 m[MAX_FOUR * (MAX_FOUR + 3) / 2];
    ix__v4 c[MAX_FOUR + 1];
    four f;

    choose_four(jb, span, &f);
    plan_four(jb, &f, m);
    for (size_t row = 0; row < jb->nrows; row++) {
        double *out = jb->out + row_offset(jb, row, n);

        load_four(jb, &f, jb->in + row_offset(jb, row, (size_t)jb->length), c);
        run_four(jb->degree, &f, m, c);
        for (int l = 0; l < FOUR; l++)
            for (int i = 0; i <= jb->degree; i++)
                out[f.to[l] + (size_t)i * jb->inner] = c[i][l];
    }
}

static void extract_fours(void *arg, size_t begin, size_t end)
{
    const job *jb = arg;

    for (size_t k = begin; k < end; k++)
        extract_four(jb, (int)k * FOUR);
}

static void extract_items(void *arg, size_t begin, size_t end)
{
    const job *jb = arg;
    double buf[IX_MAX_ORDER * LANES];

    for (size_t k = begin; k < end; k++) {
        int span = (int)(k / jb->nbatches);
        size_t row = k % jb->nbatches * LANES;

        if (jb->nrows - row == 1)
            extract_one(jb, span, row, buf);
        else
            extract_lanes(jb, span, row, buf);
    }
}

/* The knot span of each span's middle: a break may be off by an ulp. */
static ix_status find_spans(ix_ctx *ctx, const ix_dir *dir, const ix_spans *sp,
                            const int **mu)
{
    int last = dir->basis == IX_BSPLINE ? ix__dir_npoints(dir) - 1 : 0;
    int *at, k = dir->order - 1;

    IX_SCRATCH(ctx, at, sp->nspans);
    for (int j = 0; j < sp->nspans; j++) {
        double mid = 0.5 * (sp->breaks[j] + sp->breaks[j + 1]);

        while (k < last && mid >= dir->knots[k + 1])
            k++;
        at[j] = k;
    }
    *mu = at;
    return IX_OK;
}

static ix_status extract(ix_ctx *ctx, const ix_dir *dir, const ix_spans *sp,
                         job *jb)
{
    double steps = (double)dir->order * dir->order;

    jb->degree = dir->order - 1;
    jb->length = dir->length;
    jb->nspans = sp->nspans;
    jb->breaks = sp->breaks;
    jb->nbatches = (jb->nrows + LANES - 1) / LANES;
    if (jb->nrows == 0)
        return IX_OK;
    IX_TRY(ix__dir_knots(ctx, dir, &jb->knots));
    IX_TRY(find_spans(ctx, dir, sp, &jb->mu));
    if (jb->inner < LANES && jb->degree <= MAX_FOUR)
        ix__parallel(ctx, ((size_t)sp->nspans + FOUR - 1) / FOUR,
                     2 * steps * (2 + (double)jb->nrows), extract_fours, jb);
    else
        ix__parallel(ctx, (size_t)sp->nspans * jb->nbatches,
                     20 + 2 * steps + 10 * dir->order, extract_items, jb);
    return IX_OK;
}

ix_status ix__spans_extract(ix_ctx *ctx, const ix_dir *dir, const ix_spans *sp,
                            size_t outer, size_t inner, const double *in,
                            double *out)
{
    job jb = {.in = in, .out = out, .inner = inner, .nrows = outer * inner};
    ix_mark mk;
    ix_status st;

    if (dir->basis == IX_POWER)
        return IX_FAIL(ctx, IX_EARG, "a power basis has no spans");
    mk = ix__scratch_mark(ctx);
    st = extract(ctx, dir, sp, &jb);
    ix__scratch_release(ctx, mk);
    return st;
}
