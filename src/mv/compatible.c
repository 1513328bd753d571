/* compatible.c - two or more multivariates brought to one point type, one
 * order, one knot vector (spec/model 5). The first one's domain wins. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "mv/mv.h"

typedef struct {
    ix_mv *a, *b; /* own references, NULL after a failure */
} pair;

/* One of the pair becomes next if st is IX_OK; a failed step frees it. */
static ix_status step(ix_ctx *ctx, ix_mv **which, ix_mv **next, ix_status st)
{
    return ix__mv_step(ctx, which, next, st);
}

/* --- point type, orders, bases ------------------------------------------ */

static ix_status same_points(ix_ctx *ctx, pair *p)
{
    int nc = p->a->ncoords > p->b->ncoords ? p->a->ncoords : p->b->ncoords;
    bool rational = p->a->rational || p->b->rational;
    ix_mv *next;

    IX_TRY(
        step(ctx, &p->a, &next, ix_mv_coerce(ctx, p->a, nc, rational, &next)));
    return step(ctx, &p->b, &next,
                ix_mv_coerce(ctx, p->b, nc, rational, &next));
}

static bool has_basis(const ix_mv *m, ix_basis basis)
{
    for (int d = 0; d < m->ndirs; d++)
        if (m->dirs[d].basis == basis)
            return true;
    return false;
}

static ix_status no_power(ix_ctx *ctx, ix_mv **m)
{
    ix_mv *next;

    return step(ctx, m, &next, ix__mv_no_power(ctx, *m, &next));
}

/* B-spline if either is, in every direction. */
static ix_status same_basis(ix_ctx *ctx, pair *p)
{
    ix_mv *next;

    if (!has_basis(p->a, IX_BSPLINE) && !has_basis(p->b, IX_BSPLINE))
        return IX_OK;
    IX_TRY(step(ctx, &p->a, &next, ix_mv_to_bspline(ctx, p->a, &next)));
    return step(ctx, &p->b, &next, ix_mv_to_bspline(ctx, p->b, &next));
}

static ix_status same_order(ix_ctx *ctx, pair *p, int d)
{
    int oa = p->a->dirs[d].order, ob = p->b->dirs[d].order;
    ix_mv *next;

    if (oa < ob)
        return step(ctx, &p->a, &next, ix_mv_raise(ctx, p->a, d, ob, &next));
    if (ob < oa)
        return step(ctx, &p->b, &next, ix_mv_raise(ctx, p->b, d, oa, &next));
    return IX_OK;
}

static ix_status open_both(ix_ctx *ctx, pair *p, int d)
{
    ix_mv *next;

    IX_TRY(step(ctx, &p->a, &next, ix__mv_open_dir(ctx, p->a, d, &next)));
    return step(ctx, &p->b, &next, ix__mv_open_dir(ctx, p->b, d, &next));
}

/* --- knots --------------------------------------------------------------- */

static ix_status same_domain(ix_ctx *ctx, pair *p, int d)
{
    double da[2], db[2];
    ix_mv *next;

    ix_mv_domain(p->a, d, da);
    ix_mv_domain(p->b, d, db);
    if (da[0] == db[0] && da[1] == db[1])
        return IX_OK;
    return step(ctx, &p->b, &next,
                ix_mv_reparam(ctx, p->b, d, da[0], da[1], &next));
}

static bool equal_knots(const ix_dir *a, const ix_dir *b)
{
    int n = ix_knots_count(a);

    return a->periodic == b->periodic && n == ix_knots_count(b) &&
           a->length == b->length &&
           memcmp(a->knots, b->knots, (size_t)n * sizeof(double)) == 0;
}

/* b's knots that differ from one of a's by rounding (of the affine map above:
 * a few ulp of the domain's size) become it. */
static ix_status snap(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, int d,
                      ix_mv **out)
{
    const ix_dir *da = a->dirs + d;
    ix_dir nd = b->dirs[d];
    int na = ix_knots_count(da), nb = ix_knots_count(&nd), i = 0;
    double tol = 4 * ix__knots_ulp4(na, da->knots), *kv;

    IX_SCRATCH(ctx, kv, nb);
    for (int k = 0; k < nb; k++) {
        double x = nd.knots[k];

        while (i < na - 1 &&
               fabs(da->knots[i + 1] - x) <= fabs(da->knots[i] - x))
            i++;
        kv[k] = fabs(da->knots[i] - x) <= tol ? da->knots[i] : x;
    }
    nd.knots = kv;
    IX_TRY(ix__mv_check_dirs(ctx, 1, &nd, 1));
    return ix__mv_with_knots(ctx, b, d, kv, out);
}

static ix_status snap_scoped(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, int d,
                             ix_mv **out)
{
    IX_RETURN_SCOPED(ctx, snap(ctx, a, b, d, out));
}

/* How often the knot x stands in k[n] from *i on; *i moves behind it. */
static int count_run(const double *k, int n, double x, int *i)
{
    int m = 0;

    while (*i < n && k[*i] < x)
        (*i)++;
    for (; *i < n && k[*i] == x; (*i)++)
        m++;
    return m;
}

/* m with the knots of other that it lacks, in direction d; both open. */
static ix_status insert_missing(ix_ctx *ctx, const ix_mv *m, const ix_mv *other,
                                int d, ix_mv **out)
{
    const ix_dir *own = m->dirs + d, *from = other->dirs + d;
    int no = own->length, nf = from->length, i = 0, n = 0;
    double *add;

    IX_SCRATCH(ctx, add, nf);
    for (int k = from->order; k < nf;) {
        double x = from->knots[k];
        int want = count_run(from->knots, nf, x, &k);

        for (int have = count_run(own->knots, no, x, &i); have < want; have++)
            add[n++] = x;
    }
    return ix_mv_insert_knots(ctx, m, d, n, add, out);
}

static ix_status insert_scoped(ix_ctx *ctx, const ix_mv *m, const ix_mv *other,
                               int d, ix_mv **out)
{
    IX_RETURN_SCOPED(ctx, insert_missing(ctx, m, other, d, out));
}

static ix_status same_knots(ix_ctx *ctx, pair *p, int d)
{
    ix_mv *next;

    if (p->a->dirs[d].basis != IX_BSPLINE)
        return IX_OK;
    IX_TRY(same_domain(ctx, p, d));
    if (equal_knots(p->a->dirs + d, p->b->dirs + d))
        return IX_OK;
    IX_TRY(open_both(ctx, p, d));
    IX_TRY(step(ctx, &p->b, &next, snap_scoped(ctx, p->a, p->b, d, &next)));
    IX_TRY(step(ctx, &p->a, &next, insert_scoped(ctx, p->a, p->b, d, &next)));
    return step(ctx, &p->b, &next, insert_scoped(ctx, p->b, p->a, d, &next));
}

/* --- together ------------------------------------------------------------ */

static ix_status compatible(ix_ctx *ctx, pair *p, const unsigned *flags)
{
    int n = p->a->ndirs;
    unsigned any = 0;

    for (int d = 0; d < n; d++) {
        any |= flags[d];
        if (flags[d] & (IX_SAME_ORDERS | IX_SAME_KNOTS) &&
            p->a->dirs[d].periodic != p->b->dirs[d].periodic)
            IX_TRY(open_both(ctx, p, d));
    }
    if (any & IX_SAME_POINTS)
        IX_TRY(same_points(ctx, p));
    if (any & (IX_SAME_ORDERS | IX_SAME_KNOTS)) {
        IX_TRY(no_power(ctx, &p->a));
        IX_TRY(no_power(ctx, &p->b));
        IX_TRY(same_basis(ctx, p));
    }
    for (int d = 0; d < n; d++) {
        if (flags[d] & IX_SAME_ORDERS)
            IX_TRY(same_order(ctx, p, d));
        if (flags[d] & IX_SAME_KNOTS)
            IX_TRY(same_knots(ctx, p, d));
    }
    return IX_OK;
}

ix_status ix__mv_compatible_dirs(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                                 const unsigned *flags, ix_mv **outa,
                                 ix_mv **outb)
{
    pair p;
    ix_status st;

    *outa = *outb = NULL;
    if (a->ndirs != b->ndirs)
        return IX_FAIL(ctx, IX_EARG, "%d directions and %d directions",
                       a->ndirs, b->ndirs);
    p = (pair){ix_mv_ref(a), ix_mv_ref(b)};
    st = compatible(ctx, &p, flags);
    if (st != IX_OK) {
        ix_mv_unref(ctx, p.a);
        ix_mv_unref(ctx, p.b);
        return st;
    }
    *outa = p.a;
    *outb = p.b;
    return IX_OK;
}

ix_status ix_mv_compatible(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                           unsigned flags, ix_mv **outa, ix_mv **outb)
{
    unsigned each[IX_MAX_DIRS];

    for (int d = 0; d < IX_MAX_DIRS; d++)
        each[d] = flags;
    return ix__mv_compatible_dirs(ctx, a, b, each, outa, outb);
}

/* First everything is gathered in out[0], then each of the others made like
 * it. Filled entries are released by the caller if this fails. */
static ix_status all(ix_ctx *ctx, int n, unsigned flags, ix_mv **out)
{
    ix_mv *a, *b;

    for (int round = 0; round < 2; round++)
        for (int i = 1; i < n; i++) {
            IX_TRY(ix_mv_compatible(ctx, out[0], out[i], flags, &a, &b));
            ix_mv_unref(ctx, out[0]);
            ix_mv_unref(ctx, out[i]);
            out[0] = a;
            out[i] = b;
        }
    return IX_OK;
}

ix_status ix__mv_compatible_all(ix_ctx *ctx, int n, const ix_mv *const *in,
                                unsigned flags, ix_mv **out)
{
    ix_status st;

    for (int i = 0; i < n; i++)
        out[i] = ix_mv_ref(in[i]);
    st = all(ctx, n, flags, out);
    for (int i = 0; st != IX_OK && i < n; i++) {
        ix_mv_unref(ctx, out[i]);
        out[i] = NULL;
    }
    return st;
}
