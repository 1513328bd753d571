/* eval_many.c - values at many parameters at once.
 *
 * The multivariate is cut into Bezier boxes once. A box holds its scaled
 * coefficients with up to four axes next to each other, so one point is a few
 * four-wide steps without any gathering, and its span comes from a table. */
#include <math.h>
#include <string.h>

#include "base/threads.h"
#include "bern/bern.h"
#include "bern/clones.h"
#include "bsp/basis.h"
#include "mv/bernstein.h"
#include "mv/window.h"

#define GROUP 4   /* axes that share a vector */
#define BATCH 256 /* points between stages */
/* Limits of the fast path: scaled coefficients stay far from overflow up to
 * this order, rows of the box that are folded at once. */
#define MAX_ORDER 512
#define MAX_ROWS  1024

/* One span: parameters from lo to next (infinite for the last), inverse of
 * its length. */
typedef struct {
    double lo, inv, next;
} piece;

/* Where the parameters of one direction lie. A bucket tells the first span
 * that reaches into it; at most steps more begin there. */
typedef struct {
    double lo, hi, scale; /* scale: buckets per parameter */
    int nspans, nbuckets, steps;
    const int *bucket;   /* [nbuckets] */
    const piece *pieces; /* [nspans] */
    bool clamp;          /* parameters are clamped to the domain */
} locator;

typedef struct {
    const ix_mv *m;
    locator loc[IX_MAX_DIRS];
    int degree[IX_MAX_DIRS];
    size_t rows;              /* rows of direction 0 in a box */
    size_t box;               /* doubles of a box in one group of axes */
    size_t step[IX_MAX_DIRS]; /* boxes from one span to the next */
    size_t nboxes;
    int ngroups;
    const double *coefs; /* [group][box][row][order of 0][GROUP] */
    double constant[IX_MAX_COORDS + 1 + GROUP]; /* value of a constant axis */
    size_t n;
    const double *t; /* [dir][n] */
    double *out;     /* [axis or coordinate][n] */
    bool project;
} job;

/* --- finding spans -------------------------------------------------------- */

/* Fills the table for a number of buckets; returns the steps it needs. */
static int fill_buckets(const ix_spans *sp, locator *l, int *bucket)
{
    int j = 0, most = 0;

    l->scale = l->nbuckets / (l->hi - l->lo);
    for (int b = 0; b < l->nbuckets; b++) {
        int k;

        while (j < sp->nspans - 1 && (sp->breaks[j + 1] - l->lo) * l->scale < b)
            j++;
        bucket[b] = j;
        for (k = j; k < sp->nspans - 1 &&
                    (sp->breaks[k + 1] - l->lo) * l->scale <= b + 1;)
            k++;
        most = k - j > most ? k - j : most;
    }
    return most;
}

/* More buckets until two steps do, or the table is much larger than the
 * spans: uneven knots then cost more steps. */
static ix_status make_locator(ix_ctx *ctx, const ix_spans *sp, bool clamp,
                              locator *l)
{
    int n = sp->nspans, *bucket;
    piece *pieces;

    *l = (locator){.nspans = n, .nbuckets = n > 1 ? 2 * n : 1, .clamp = clamp};
    l->lo = sp->breaks[0];
    l->hi = sp->breaks[n];
    IX_SCRATCH(ctx, bucket, 16 * (size_t)n);
    IX_SCRATCH(ctx, pieces, n);
    while ((l->steps = fill_buckets(sp, l, bucket)) > 1 && l->nbuckets < 16 * n)
        l->nbuckets *= 2;
    for (int j = 0; j < n; j++)
        pieces[j] = (piece){sp->breaks[j],
                            1 / (sp->breaks[j + 1] - sp->breaks[j]),
                            j < n - 1 ? sp->breaks[j + 1] : HUGE_VAL};
    l->bucket = bucket;
    l->pieces = pieces;
    if (!isfinite(l->scale))
        return IX_FAIL(ctx, IX_EUNABLE, "domain [%g, %g]", l->lo, l->hi);
    return IX_OK;
}

/* The span that holds t, without a branch that could be mispredicted. */
static inline int find_span(const locator *l, double t)
{
    double pos = (t - l->lo) * l->scale;
    int last = l->nbuckets - 1;
    int b = pos < last ? (int)pos : last, j = l->bucket[b];

    for (int k = 0; k < l->steps; k++)
        j += t >= l->pieces[j].next;
    return j;
}

/* The same by halving, where a bucket holds many spans. */
static int search_span(const locator *l, double t)
{
    int lo = 0, hi = l->nspans - 1;

    while (lo < hi) {
        int mid = lo + (hi - lo) / 2;

        if (t >= l->pieces[mid].next)
            lo = mid + 1;
        else
            hi = mid;
    }
    return lo;
}

/* Box of each point and local parameters u of direction d. */
static void locate(const job *jb, int d, size_t first, size_t n, size_t *box,
                   double *u)
{
    const locator *l = jb->loc + d;
    const double *t = jb->t + (size_t)d * jb->n + first;
    double lo = l->clamp ? l->lo : -HUGE_VAL;
    double hi = l->clamp ? l->hi : HUGE_VAL;
    size_t step = jb->step[d];

    for (size_t i = 0; i < n; i++) {
        double x = t[i] < lo ? lo : t[i] > hi ? hi : t[i];
        int j = 0;

        if (l->nspans > 1)
            j = l->steps <= 8 ? find_span(l, x) : search_span(l, x);
        box[i] += (size_t)j * step;
        u[i] = (x - l->pieces[j].lo) * l->pieces[j].inv;
        u[i] = x == l->hi ? 1 : u[i]; /* exactly the last point */
    }
}

/* --- kernels ---------------------------------------------------------------
 * sum of c[k] u^k (1 - u)^(d - k) by r = r (1 - u) + c[k] u^k. */

IX__INLINE void fold(int d, const double *c, size_t stride, double u,
                     ix__v4 *out)
{
    ix__v4 r = *ix__cvec(c);
    double v = 1 - u, pw = 1;

    for (int k = 1; k <= d; k++) {
        c += stride;
        pw *= u;
        r = r * v + *ix__cvec(c) * pw;
    }
    *out = r;
}

/* One direction. */
IX__INLINE void curve_loop(int d, size_t n, const double *coefs,
                           const size_t *box, const double *u, double *out)
{
    for (size_t i = 0; i < n; i++)
        fold(d, coefs + box[i], GROUP, u[i], ix__vec(out + GROUP * i));
}

IX__CLONES static void curve_kernel(int d, size_t n, const double *coefs,
                                    const size_t *box, const double *u,
                                    double *out)
{
    if (d == 3) /* the usual case, unrolled */
        curve_loop(3, n, coefs, box, u, out);
    else
        curve_loop(d, n, coefs, box, u, out);
}

/* Two directions: rows of the first, then across. */
IX__INLINE void surface_loop(int d0, int d1, size_t n, const double *coefs,
                             const size_t *box, const double *u, double *out)
{
    size_t row = GROUP * (size_t)(d0 + 1);

    for (size_t i = 0; i < n; i++) {
        const double *c = coefs + box[i];
        double t = u[BATCH + i], s = 1 - t, pw = 1;
        ix__v4 r, q;

        fold(d0, c, GROUP, u[i], &r);
        for (int k = 1; k <= d1; k++) {
            c += row;
            pw *= t;
            fold(d0, c, GROUP, u[i], &q);
            r = r * s + q * pw;
        }
        *ix__vec(out + GROUP * i) = r;
    }
}

IX__CLONES static void surface_kernel(const int *d, size_t n,
                                      const double *coefs, const size_t *box,
                                      const double *u, double *out)
{
    if (d[0] == 3 && d[1] == 3)
        surface_loop(3, 3, n, coefs, box, u, out);
    else
        surface_loop(d[0], d[1], n, coefs, box, u, out);
}

/* Any number of directions: rows first, then one direction after another. */
IX__CLONES static void box_kernel(const job *jb, size_t n, const double *coefs,
                                  const size_t *box, const double *u,
                                  double *out)
{
    double buf[MAX_ROWS * GROUP];

    for (size_t i = 0; i < n; i++) {
        const double *c = coefs + box[i];
        size_t rows = jb->rows, row = GROUP * ((size_t)jb->degree[0] + 1);

        for (size_t r = 0; r < rows; r++)
            fold(jb->degree[0], c + r * row, GROUP, u[i],
                 ix__vec(buf + GROUP * r));
        for (int d = 1; d < jb->m->ndirs; d++) {
            size_t o = (size_t)jb->degree[d] + 1;

            rows /= o;
            for (size_t r = 0; r < rows; r++)
                fold(jb->degree[d], buf + GROUP * o * r, GROUP,
                     u[(size_t)d * BATCH + i], ix__vec(buf + GROUP * r));
        }
        *ix__vec(out + GROUP * i) = *ix__vec(buf);
    }
}

IX__CLONES static void add_constant(size_t n, const double *c, double *v)
{
    ix__v4 k = *ix__cvec(c);

    for (size_t i = 0; i < n; i++)
        *ix__vec(v + GROUP * i) += k;
}

/* Four points v[4][GROUP], each by its lanes, to four by points. */
IX__INLINE void transpose(const double *v, ix__v4 *x)
{
    ix__v4 a = *ix__cvec(v), b = *ix__cvec(v + 4), c = *ix__cvec(v + 8);
    ix__v4 d = *ix__cvec(v + 12);
    ix__v4 p = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    ix__v4 q = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    ix__v4 r = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    ix__v4 s = __builtin_shufflevector(c, d, 1, 5, 3, 7);

    x[0] = __builtin_shufflevector(p, r, 0, 1, 4, 5);
    x[1] = __builtin_shufflevector(q, s, 0, 1, 4, 5);
    x[2] = __builtin_shufflevector(p, r, 2, 3, 6, 7);
    x[3] = __builtin_shufflevector(q, s, 2, 3, 6, 7);
}

/* Lane k of n points, n a multiple of 4, to row[k], where there is one. */
IX__CLONES static void store(size_t n, const double *v,
                             double *const row[GROUP])
{
    for (size_t i = 0; i < n; i += 4) {
        ix__v4 x[GROUP];

        transpose(v + GROUP * i, x);
        for (int k = 0; k < GROUP; k++)
            if (row[k])
                *ix__vec(row[k] + i) = x[k];
    }
}

/* The same divided by the weights w. */
IX__CLONES static void store_divided(size_t n, const double *v, const double *w,
                                     double *const row[GROUP])
{
    for (size_t i = 0; i < n; i += 4) {
        ix__v4 x[GROUP], h = *ix__cvec(w + i);

        transpose(v + GROUP * i, x);
        for (int k = 0; k < GROUP; k++)
            if (row[k])
                *ix__vec(row[k] + i) = x[k] / h;
    }
}

/* --- batches ---------------------------------------------------------------
 * A group of axes at a time; the weight is the first axis of the first. */

static void run_group(const job *jb, int g, size_t n, const size_t *box,
                      const double *u, double *v)
{
    const double *coefs = jb->coefs + (size_t)g * jb->nboxes * jb->box;

    if (jb->m->ndirs == 1)
        curve_kernel(jb->degree[0], n, coefs, box, u, v);
    else if (jb->m->ndirs == 2)
        surface_kernel(jb->degree, n, coefs, box, u, v);
    else
        box_kernel(jb, n, coefs, box, u, v);
    for (int k = 0; k < GROUP; k++)
        if (jb->constant[g * GROUP + k] != 0) {
            add_constant(n, jb->constant + g * GROUP, v);
            break;
        }
}

/* The last few points of a batch go through room of their own. */
static void store_group(const job *jb, int g, size_t first, size_t n, double *w,
                        const double *v)
{
    bool divided = jb->project && jb->m->rational;
    size_t whole = n / 4 * 4;
    double *row[GROUP] = {NULL}, *end[GROUP] = {NULL}, room[GROUP][4];

    for (int k = 0; k < GROUP && g * GROUP + k < jb->m->naxes; k++) {
        int at = g * GROUP + k - divided;

        if (at < 0)
            continue;
        row[k] = jb->out + (size_t)at * jb->n + first;
        end[k] = room[k];
    }
    for (size_t i = 0; divided && g == 0 && i < n; i++)
        w[i] = v[GROUP * i];
    if (divided) {
        store_divided(whole, v, w, row);
        store_divided(n - whole, v + GROUP * whole, w + whole, end);
    } else {
        store(whole, v, row);
        store(n - whole, v + GROUP * whole, end);
    }
    for (int k = 0; k < GROUP; k++)
        if (row[k])
            memcpy(row[k] + whole, room[k], (n - whole) * sizeof(double));
}

static void run_items(void *arg, size_t begin, size_t end)
{
    const job *jb = arg;
    double u[IX_MAX_DIRS * BATCH], v[GROUP * BATCH], w[BATCH];
    size_t box[BATCH];

    for (size_t i = begin; i < end; i += BATCH) {
        size_t n = end - i < BATCH ? end - i : BATCH;

        memset(box, 0, sizeof box);
        for (int d = 0; d < jb->m->ndirs; d++)
            locate(jb, d, i, n, box, u + (size_t)d * BATCH);
        for (int g = 0; g < jb->ngroups; g++) {
            run_group(jb, g, n, box, u, v);
            store_group(jb, g, i, n, w, v);
        }
    }
}

/* --- preparation -----------------------------------------------------------
 */

/* Binomials of each direction into the coefficients. */
static ix_status scale(ix_ctx *ctx, ix__bernstein *b)
{
    const ix_mv *m = b->m;

    for (int d = 0; d < m->ndirs; d++) {
        int degree = m->dirs[d].order - 1;
        size_t block = (size_t)(degree + 1) * b->stride[d];
        double *room;

        IX_SCRATCH(ctx, room, degree + 1);
        ix__bern_scale(b->axis * (size_t)m->naxes / block, degree, b->stride[d],
                       ix__binom(degree, room), b->coefs, b->coefs);
    }
    return IX_OK;
}

/* The value of an axis whose points are all equal, so that it stays exact;
 * NAN if they are not. */
static double constant_axis(const ix_mv *m, int a)
{
    const double *x = ix_mv_axis(m, a);

    for (size_t i = 0; i < m->npts; i++)
        if (x[i] != x[0])
            return (double)NAN;
    return x[0];
}

/* One axis of all boxes into its lane. */
static void pack_axis(const job *jb, const ix__bernstein *b, int a, double *out)
{
    const double *in = b->coefs + (size_t)a * b->axis;
    int at[IX_MAX_DIRS] = {0}, o = jb->degree[0] + 1;

    for (size_t k = 0; k < jb->nboxes; k++) {
        int q[IX_MAX_DIRS] = {0};

        do {
            const double *row = in + ix__bernstein_row(b, at, q);

            for (int i = 0; i < o; i++, out += GROUP)
                *out = row[i];
        } while (ix__bernstein_next(jb->m, q));
        for (int d = 0; d < jb->m->ndirs && ++at[d] == b->sp[d].nspans; d++)
            at[d] = 0;
    }
}

static ix_status pack(ix_ctx *ctx, job *jb, ix__bernstein *b)
{
    size_t group = jb->nboxes * jb->box;
    double *c;

    IX_TRY(scale(ctx, b));
    jb->ngroups = (jb->m->naxes + GROUP - 1) / GROUP;
    IX_SCRATCH_ZERO(ctx, c, (size_t)jb->ngroups * group);
    for (int a = 0; a < jb->m->naxes; a++) {
        double k = constant_axis(jb->m, a);

        if (isnan(k))
            pack_axis(jb, b, a, c + (size_t)(a / GROUP) * group + a % GROUP);
        else
            jb->constant[a] = k;
    }
    jb->coefs = c;
    return IX_OK;
}

/* Sizes of the fast path; false if it does not suit the shape or does not pay
 * for n points. */
static bool plan(const ix_mv *m, size_t n, job *jb)
{
    double all = (double)m->naxes;

    jb->rows = 1;
    for (int d = 0; d < m->ndirs; d++) {
        const ix_dir *dir = m->dirs + d;
        int spans = dir->basis == IX_BSPLINE
                        ? ix__dir_npoints(dir) - dir->order + 1
                        : 1;

        if (dir->basis == IX_POWER || dir->order > MAX_ORDER)
            return false;
        if (d > 0)
            jb->rows *= (size_t)dir->order;
        if (jb->rows > MAX_ROWS)
            return false;
        all *= (double)spans * dir->order;
        jb->degree[d] = dir->order - 1;
    }
    return all <= 16.0 * (double)n; /* cutting costs a few ns a coefficient */
}

static ix_status prepare(ix_ctx *ctx, const ix_mv *m, job *jb)
{
    ix__bernstein b;

    IX_TRY(ix__bernstein_of(ctx, m, &b));
    jb->box = jb->rows * (size_t)m->dirs[0].order * GROUP;
    jb->nboxes = 1;
    for (int d = 0; d < m->ndirs; d++) {
        jb->step[d] = jb->nboxes * jb->box;
        jb->nboxes *= (size_t)b.sp[d].nspans;
        IX_TRY(make_locator(ctx, b.sp + d, !ix__mv_extrapolates(m, d),
                            jb->loc + d));
    }
    return pack(ctx, jb, &b);
}

/* --- the calls --------------------------------------------------------------
 */

/* Whether all of t[n] are in [lo, hi]; no for NaN. */
IX__CLONES static bool all_inside(size_t n, const double *t, double lo,
                                  double hi)
{
    typedef long long mask __attribute__((vector_size(sizeof(ix__v4))));
    ix__v4 low = {lo, lo, lo, lo}, high = {hi, hi, hi, hi};
    mask in = {-1, -1, -1, -1};
    size_t i = 0;

    for (; i + 4 <= n; i += 4) {
        ix__v4 x = *ix__cvec(t + i);

        in &= (x >= low) & (x <= high);
    }
    for (; i < n; i++)
        if (!(t[i] >= lo && t[i] <= hi))
            return false;
    return (in[0] & in[1] & in[2] & in[3]) != 0;
}

static ix_status check_params(ix_ctx *ctx, const ix_mv *m, size_t n,
                              const double *t)
{
    for (int d = 0; d < m->ndirs; d++) {
        const double *own = t + (size_t)d * n;
        double dom[2];

        ix_mv_domain(m, d, dom);
        if (all_inside(n, own, dom[0], dom[1]))
            continue;
        for (size_t i = 0; i < n; i++) {
            double x = own[i];

            IX_TRY(ix__mv_param(ctx, m, d, &x));
        }
    }
    return IX_OK;
}

/* Point by point, for few points and unusual shapes. */
static ix_status one_by_one(ix_ctx *ctx, const job *jb)
{
    const ix_mv *m = jb->m;
    int rows = m->naxes - (jb->project && m->rational);

    for (size_t i = 0; i < jb->n; i++) {
        double t[IX_MAX_DIRS], v[IX_MAX_COORDS + 1];
        const double *from = v + (m->naxes - rows);

        for (int d = 0; d < m->ndirs; d++)
            t[d] = jb->t[(size_t)d * jb->n + i];
        IX_TRY(ix_mv_eval(ctx, m, t, v));
        for (int k = 0; k < rows; k++)
            jb->out[(size_t)k * jb->n + i] = rows < m->naxes ? from[k] / v[0]
                                                             : from[k];
    }
    return IX_OK;
}

static ix_status many(ix_ctx *ctx, const ix_mv *m, job *jb)
{
    double cost = 4;

    IX_TRY(check_params(ctx, m, jb->n, jb->t));
    if (!plan(m, jb->n, jb))
        return one_by_one(ctx, jb);
    IX_TRY(prepare(ctx, m, jb));
    cost += 0.5 * (double)jb->rows * m->dirs[0].order * jb->ngroups;
    ix__parallel(ctx, jb->n, cost, run_items, jb);
    return IX_OK;
}

ix_status ix_mv_eval_many(ix_ctx *ctx, const ix_mv *m, size_t n,
                          const double *t, double *out)
{
    job jb = {.m = m, .n = n, .t = t, .out = out};

    IX_RETURN_SCOPED(ctx, many(ctx, m, &jb));
}

ix_status ix_mv_point_many(ix_ctx *ctx, const ix_mv *m, size_t n,
                           const double *t, double *out)
{
    job jb = {.m = m, .n = n, .t = t, .out = out, .project = true};

    IX_RETURN_SCOPED(ctx, many(ctx, m, &jb));
}
