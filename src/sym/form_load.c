/* form_load.c - multivariates to forms on common breaks. All operands are
 * looked at together, direction by direction; operands with equal knots share
 * their breaks, and single Bezier pieces are copied, not decomposed. */
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "sym/form_impl.h"

/* Domains that differ by more than this part of their length do not agree
 * (spec/model 9.1). */
#define DOMAIN_TOL 1e-5
/* Up to this total degree binomials stay below 1e77: no exponent needed. */
#define FREE_DEGREE 256

typedef struct {
    const ix_mv *m;
    ix_dir dirs[IX_MAX_DIRS]; /* knots mapped onto the common domain */
    ix_spans spans[IX_MAX_DIRS];
} operand;

static const double unit_breaks[2] = {0.0, 1.0};

/* --- domains and breaks --------------------------------------------------- */

static ix_status check_domain(ix_ctx *ctx, int dir, const double a[2],
                              const double b[2])
{
    double tol = DOMAIN_TOL * (a[1] - a[0]);

    if (!(fabs(a[0] - b[0]) <= tol) || !(fabs(a[1] - b[1]) <= tol))
        return IX_FAIL(ctx, IX_EARG,
                       "domains [%g, %g] and [%g, %g] of direction %d differ",
                       a[0], a[1], b[0], b[1], dir);
    return IX_OK;
}

/* The direction d on the domain from[2], carried onto to[2]. */
static ix_status map_dir(ix_ctx *ctx, const double from[2], const double to[2],
                         ix_dir *d)
{
    int n = d->basis == IX_BSPLINE ? ix_knots_count(d) : 2 * d->order;
    double s = (to[1] - to[0]) / (from[1] - from[0]), *kv;

    if (from[0] == to[0] && from[1] == to[1])
        return IX_OK;
    IX_SCRATCH(ctx, kv, n);
    for (int i = 0; i < n; i++) {
        double t = d->basis == IX_BSPLINE ? d->knots[i]
                                          : (i < d->order ? 0.0 : 1.0);

        kv[i] = t == from[1] ? to[1] : to[0] + (t - from[0]) * s;
    }
    d->basis = IX_BSPLINE;
    d->knots = kv;
    return IX_OK;
}

static bool same_breaks(const ix_spans *a, const ix_spans *b)
{
    return a->nspans == b->nspans &&
           !memcmp(a->breaks, b->breaks,
                   ((size_t)a->nspans + 1) * sizeof *a->breaks);
}

/* sp on the finer breaks of all, smooth where it has none itself. Every break
 * of sp is, up to a few ulp, one of all: the nearest. */
static ix_status refine_spans(ix_ctx *ctx, const ix_spans *all, ix_spans *sp)
{
    int n = all->nspans - 1, *cont, i = 1;

    IX_SCRATCH(ctx, cont, n);
    for (int k = 0; k < n; k++)
        cont[k] = INT_MAX;
    for (int j = 1; j < sp->nspans; j++) {
        double t = sp->breaks[j];

        while (i < n && all->breaks[i + 1] - t < t - all->breaks[i])
            i++;
        cont[i - 1] = sp->cont[j - 1];
    }
    *sp = (ix_spans){sp->degree, all->nspans, all->breaks, cont};
    return IX_OK;
}

/* The breaks of all operands in one direction, given to each with its own
 * continuity. */
static ix_status common_breaks(ix_ctx *ctx, int n, operand *op, int dir)
{
    ix_spans all = op[0].spans[dir];

    for (int i = 1; i < n; i++)
        if (!same_breaks(&all, &op[i].spans[dir]))
            IX_TRY(ix__spans_union(ctx, &all, &op[i].spans[dir], 0, &all));
    for (int i = 0; i < n; i++) {
        ix_spans *sp = &op[i].spans[dir];

        if (same_breaks(&all, sp))
            sp->breaks = all.breaks;
        else
            IX_TRY(refine_spans(ctx, &all, sp));
    }
    return IX_OK;
}

static ix_status load_dir(ix_ctx *ctx, int n, operand *op, int dir,
                          bool *bezier)
{
    double dom[2], own[2];

    *bezier = true;
    ix_mv_domain(op[0].m, dir, dom);
    for (int i = 0; i < n; i++) {
        op[i].dirs[dir] = ix_mv_dir(op[i].m, dir);
        if (op[i].dirs[dir].basis == IX_POWER)
            op[i].dirs[dir].basis = IX_BEZIER; /* see from_power */
        *bezier &= op[i].dirs[dir].basis == IX_BEZIER;
        op[i].spans[dir] = (ix_spans){op[i].dirs[dir].order - 1, 1, unit_breaks,
                                      NULL};
    }
    if (*bezier)
        return IX_OK;
    for (int i = 0; i < n; i++) {
        ix_mv_domain(op[i].m, dir, own);
        IX_TRY(check_domain(ctx, dir, dom, own));
        IX_TRY(map_dir(ctx, own, dom, &op[i].dirs[dir]));
        IX_TRY(ix__spans_of(ctx, &op[i].dirs[dir], &op[i].spans[dir]));
    }
    return common_breaks(ctx, n, op, dir);
}

/* --- coefficients --------------------------------------------------------- */

static int exponent_of(size_t n, const double *x)
{
    int e = 0;

    (void)frexp(ix__bern_largest(n, x), &e);
    return e;
}

/* Control points in the frame: double[naxes][npts]. */
static ix_status framed(ix_ctx *ctx, const ix_mv *m, const ix_frame *f,
                        const double **pts)
{
    const double *c = *pts, *w = m->rational ? c : NULL;
    int ew = w ? exponent_of(m->npts, w) : 0;
    double fw = ldexp(1.0, -ew), fx = ldexp(1.0, -f->exp - ew), *p, *x;

    IX_SCRATCH(ctx, p, (size_t)m->naxes * m->npts);
    *pts = x = p;
    if (w) {
        for (size_t i = 0; i < m->npts; i++)
            x[i] = w[i] * fw;
        x += m->npts;
        c += m->npts;
    }
    for (int k = 0; k < m->ncoords; k++, x += m->npts, c += m->npts) {
        double shift = k < f->ncoords ? f->shift[k] : 0.0;

        for (size_t i = 0; i < m->npts; i++)
            x[i] = fma(-shift, w ? w[i] : 1.0, c[i]) * fx;
    }
    return IX_OK;
}

/* Scaled to at most 1 when the degrees are so high that binomials could
 * overflow; *exp receives the exponent taken out. */
static ix_status tamed(ix_ctx *ctx, const ix_mv *m, const double **pts,
                       int *exp)
{
    size_t n = (size_t)m->naxes * m->npts;
    int total = 0;
    double *p;

    *exp = 0;
    for (int i = 0; i < m->ndirs; i++)
        total += m->dirs[i].order - 1;
    if (total <= FREE_DEGREE)
        return IX_OK;
    *exp = exponent_of(n, *pts);
    if (*exp == 0)
        return IX_OK;
    IX_SCRATCH(ctx, p, n);
    for (size_t i = 0; i < n; i++)
        p[i] = ldexp((*pts)[i], -*exp);
    *pts = p;
    return IX_OK;
}

/* A copy of the points whose power directions are Bezier; *pts stays if there
 * is none. */
static ix_status from_power(ix_ctx *ctx, const ix_mv *m, const double **pts)
{
    size_t n = (size_t)m->naxes * m->npts, inner = 1;
    double *p = NULL;

    for (int i = 0; i < m->ndirs; i++) {
        size_t block = inner * (size_t)m->dirs[i].length;

        if (m->dirs[i].basis == IX_POWER && !p) {
            IX_SCRATCH(ctx, p, n);
            memcpy(p, *pts, n * sizeof *p);
            *pts = p;
        }
        for (size_t at = 0; m->dirs[i].basis == IX_POWER && at < n; at += block)
            ix__bern_from_power(m->dirs[i].order - 1, inner, p + at);
        inner = block;
    }
    return IX_OK;
}

/* Decomposes direction after direction; *out stays if none needs it. */
static ix_status decompose(ix_ctx *ctx, const operand *op, const double *in,
                           double **out)
{
    size_t inner = 1, outer = (size_t)op->m->naxes * op->m->npts;

    for (int i = 0; i < op->m->ndirs; i++) {
        const ix_spans *sp = &op->spans[i];
        size_t w = ix__spans_size(sp);

        outer /= (size_t)op->dirs[i].length;
        if (op->dirs[i].basis == IX_BSPLINE || sp->nspans > 1) {
            IX_SCRATCH(ctx, *out, outer * w * inner);
            IX_TRY(ix__spans_extract(ctx, &op->dirs[i], sp, outer, inner, in,
                                     *out));
            in = *out;
        }
        inner *= w;
    }
    return IX_OK;
}

static ix_status load_one(ix_ctx *ctx, const operand *op, const ix_frame *frame,
                          unsigned bezier, ix_form *out)
{
    const double *pts = op->m->pts;
    double *own = NULL; /* decomposed coefficients, if that took any work */
    int exp = 0;

    IX_TRY(from_power(ctx, op->m, &pts));
    if (frame)
        IX_TRY(framed(ctx, op->m, frame, &pts));
    IX_TRY(tamed(ctx, op->m, &pts, &exp));
    IX_TRY(decompose(ctx, op, pts, &own));
    IX_TRY(
        ix__form_adopt(ctx, op->m->ndirs, op->spans, op->m->naxes, own, out));
    out->bezier = bezier;
    out->exp = exp;
    return ix__form_scale_in(ctx, out, own ? own : pts);
}

/* --- all together --------------------------------------------------------- */

ix_status ix__forms_load(ix_ctx *ctx, int n, const ix_mv *const *m,
                         const ix_frame *frame, ix_form *out)
{
    unsigned bezier = 0;
    operand *op;
    bool b;

    IX_SCRATCH(ctx, op, n);
    for (int i = 0; i < n; i++) {
        op[i].m = m[i];
        if (m[i]->ndirs != m[0]->ndirs)
            return IX_FAIL(ctx, IX_EARG, "%d and %d directions", m[0]->ndirs,
                           m[i]->ndirs);
    }
    for (int d = 0; d < m[0]->ndirs; d++) {
        IX_TRY(load_dir(ctx, n, op, d, &b));
        bezier |= (unsigned)b << d;
    }
    for (int i = 0; i < n; i++)
        IX_TRY(load_one(ctx, &op[i], frame, bezier, &out[i]));
    return IX_OK;
}
