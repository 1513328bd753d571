/* randmv.c - random multivariates for tests. */
#include "harness/randmv.h"

#include <stdlib.h>
#include <string.h>

static bool chance(ix_rng *r, double p)
{
    return ix_rng_unit(r) < p;
}

/* n gaps between knots, some 0, runs of zeros shorter than most; sixteenths,
 * so that sums are exact. */
static void random_gaps(ix_rng *r, int n, int most, double *gap)
{
    int run = 1;

    for (int i = 0; i < n; i++) {
        if (i > 0 && run < most && chance(r, 0.35)) {
            gap[i] = 0;
            run++;
        } else {
            gap[i] = ix_rng_int(r, 1, 24) / 16.0;
            run = 1;
        }
    }
}

/* Interior runs of up to most knots between lo and hi = the return value. */
static double random_inside(ix_rng *r, double lo, int n, int most, double *k)
{
    double at = lo;
    int run = most;

    for (int i = 0; i < n; i++) {
        if (run >= most || chance(r, 0.6)) {
            at += ix_rng_range(r, 0.1, 1.5);
            run = 0;
        }
        k[i] = at;
        run++;
    }
    return at + ix_rng_range(r, 0.1, 1.5);
}

static void open_knots(ix_rng *r, const ix_dir *d, int most, double *k)
{
    int o = d->order, n = d->length;
    double lo = ix_rng_range(r, -2, 2);
    double hi = random_inside(r, lo, n - o, most, k + o);

    for (int i = 0; i < o; i++) {
        k[i] = lo;
        k[n + i] = hi;
    }
}

static void float_knots(ix_rng *r, const ix_dir *d, int most, double *k)
{
    int n = d->length + d->order;

    do
        (void)random_inside(r, ix_rng_range(r, -2, 2), n, most, k);
    while (!(k[d->length] > k[d->order - 1]));
}

static void periodic_knots(ix_rng *r, const ix_dir *d, int most, double *k)
{
    int n = d->length, nk = ix_knots_count(d);
    double *gap = malloc((size_t)n * sizeof *gap);

    assert_non_null(gap);
    random_gaps(r, n, most, gap);
    k[0] = ix_rng_int(r, -32, 32) / 16.0;
    for (int i = 1; i < nk; i++)
        k[i] = k[i - 1] + gap[(i - 1) % n];
    free(gap);
}

static void to_unit(const ix_dir *d, double *k)
{
    int n = ix_knots_count(d), hi = n - d->order;
    double a = k[d->order - 1], b = k[hi];

    for (int i = 0; i < n; i++)
        k[i] = k[i] == b ? 1 : (k[i] - a) / (b - a);
}

static unsigned pick_kind(ix_rng *r, unsigned kinds)
{
    static const unsigned each[] = {IX_RAND_BEZIER, IX_RAND_OPEN, IX_RAND_FLOAT,
                                    IX_RAND_PERIODIC, IX_RAND_POWER};
    unsigned k;

    do
        k = each[ix_rng_int(r, 0, 4)];
    while (!(k & kinds));
    return k;
}

/* One direction; its knots are malloc'ed. */
static ix_dir random_dir(ix_rng *r, const ix_rand_opts *o)
{
    ix_dir d = {IX_BEZIER, 1, 1, false, NULL};
    unsigned kind = pick_kind(r, o->kinds);
    int most, extra = o->max_knots > 0 ? ix_rng_int(r, 0, o->max_knots) : 0;
    double *k;

    d.order = d.length = ix_rng_int(r, o->min_order, o->max_order);
    if (kind == IX_RAND_BEZIER || kind == IX_RAND_POWER) {
        d.basis = kind == IX_RAND_POWER ? IX_POWER : IX_BEZIER;
        return d;
    }
    d.basis = IX_BSPLINE;
    d.periodic = kind == IX_RAND_PERIODIC;
    d.length += extra;
    if (d.periodic) /* also shorter than the order: points repeat in a window */
        d.length = ix_rng_int(r, 1, d.length);
    most = (o->kinds & IX_RAND_JUMPS) || d.order == 1 ? d.order : d.order - 1;
    k = malloc((size_t)ix_knots_count(&d) * sizeof *k);
    assert_non_null(k);
    d.knots = k;
    if (kind == IX_RAND_OPEN)
        open_knots(r, &d, most, k);
    else if (kind == IX_RAND_FLOAT)
        float_knots(r, &d, most, k);
    else
        periodic_knots(r, &d, most, k);
    if (o->unit)
        to_unit(&d, k);
    return d;
}

static ix_rand_opts with_defaults(ix_rng *r, const ix_rand_opts *given)
{
    ix_rand_opts o = {0};

    if (given)
        o = *given;
    if (!o.ndirs)
        o.ndirs = ix_rng_int(r, 1, 3);
    if (!o.ncoords)
        o.ncoords = ix_rng_int(r, 1, 4);
    if (!o.rational)
        o.rational = chance(r, 0.5) ? 1 : -1;
    if (!o.kinds)
        o.kinds = IX_RAND_ALL & ~(unsigned)IX_RAND_POWER;
    if (!o.min_order)
        o.min_order = 1;
    if (!o.max_order)
        o.max_order = 6;
    if (!o.max_knots)
        o.max_knots = 6;
    return o;
}

ix_mv *ix_mv_randtest(ix_ctx *ctx, ix_rng *r, const ix_rand_opts *given)
{
    ix_rand_opts o = with_defaults(r, given);
    ix_dir dirs[IX_MAX_DIRS];
    size_t npts = 1, n;
    bool rational = o.rational > 0;
    double *pts;
    ix_mv *m;

    for (int d = 0; d < o.ndirs; d++) {
        dirs[d] = random_dir(r, &o);
        npts *= (size_t)dirs[d].length;
    }
    n = npts * (size_t)(o.ncoords + rational);
    pts = malloc(n * sizeof *pts);
    assert_non_null(pts);
    for (size_t i = 0; i < n; i++)
        pts[i] = rational && i < npts ? ix_rng_range(r, 0.3, 3)
                                      : ix_rng_range(r, -1, 1);
    ASSERT_OK(ctx, ix_mv_new(ctx, o.ndirs, dirs, o.ncoords, rational, pts, &m));
    free(pts);
    for (int d = 0; d < o.ndirs; d++)
        free((void *)(uintptr_t)dirs[d].knots);
    return m;
}

void ix_mv_randparam(ix_rng *r, const ix_mv *m, double *t)
{
    for (int d = 0; d < ix_mv_ndirs(m); d++) {
        double dom[2];
        int n = ix_mv_nknots(m, d);

        ix_mv_domain(m, d, dom);
        t[d] = ix_rng_range(r, dom[0], dom[1]);
        if (chance(r, 0.1))
            t[d] = dom[ix_rng_int(r, 0, 1)];
        if (n > 0 && chance(r, 0.2)) {
            double k = ix_mv_dir(m, d).knots[ix_rng_int(r, 0, n - 1)];

            t[d] = fmin(fmax(k, dom[0]), dom[1]);
        }
    }
}

void ix_mv_assert_same(ix_ctx *ctx, ix_rng *r, const ix_mv *a, const ix_mv *b,
                       double tol)
{
    int na = ix_mv_naxes(a);
    double size = 1, t[IX_MAX_DIRS];

    assert_int_equal(ix_mv_ndirs(a), ix_mv_ndirs(b));
    assert_int_equal(na, ix_mv_naxes(b));
    for (size_t i = 0; i < ix_mv_npts(a) * (size_t)na; i++)
        size = fmax(size, fabs(ix_mv_axis(a, 0)[i]));
    for (int trial = 0; trial < 12; trial++) {
        double va[IX_MAX_COORDS + 1], vb[IX_MAX_COORDS + 1];

        ix_mv_randparam(r, a, t);
        ASSERT_OK(ctx, ix_mv_eval(ctx, a, t, va));
        ASSERT_OK(ctx, ix_mv_eval(ctx, b, t, vb));
        for (int k = 0; k < na; k++)
            if (!(fabs(va[k] - vb[k]) <= tol * size))
                fail_msg("axis %d at (%.17g, ..): %.17g and %.17g", k, t[0],
                         va[k], vb[k]);
    }
}
