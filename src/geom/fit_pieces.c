/* fit_pieces.c - quadratic or cubic Bezier pieces near a curve.
 *
 * A piece has the curve's end points and, in its own parameter, half the sum
 * of the end tangents' information (quadratic) or both end derivatives
 * (cubic); polynomial curves of no higher degree come back exactly. Going
 * along each span, every piece is made as long as the tolerance allows. */
#include <math.h>
#include <string.h>

#include "geom/arclen.h"
#include "geom/bound.h"
#include "geom/crvs.h"

typedef struct {
    double t0, t1;
    double pts[IX_MAX_COORDS][4];
} piece;

typedef struct {
    ix_path path;
    const ix_path *p; /* it */
    int order;        /* 3 or 4 */
    double tol, max_len, worst;
    double *curve, *diff, *work; /* control points of one candidate */
    int n, cap;
    piece *pieces;
} fit;

/* End points and end derivatives of the interval, on [0, 1]. */
static void approximate(const fit *f, int span, piece *c)
{
    double a[2 * IX_MAX_COORDS], b[2 * IX_MAX_COORDS], h = c->t1 - c->t0;
    int nc = f->p->ncoords;

    ix__path_derivs(f->p, span, c->t0, 1, a);
    ix__path_derivs(f->p, span, c->t1, 1, b);
    for (int k = 0; k < nc; k++) {
        double *q = c->pts[k], u = h * a[nc + k], v = h * b[nc + k];

        q[0] = a[k];
        q[f->order - 1] = b[k];
        if (f->order == 4) {
            q[1] = a[k] + u / 3;
            q[2] = b[k] - v / 3;
        } else {
            q[1] = (a[k] + u / 2 + (b[k] - v / 2)) / 2;
        }
    }
}

/* Largest |C - q| over the interval: numerator X - w q against the least
 * weight. Bounded, not sampled. */
static double error(const fit *f, int span, const piece *c)
{
    const ix_path *p = f->p;
    int d = p->degree, k = f->order - 1, e = p->rational ? d + k : d;
    double least = HUGE_VAL, *x = f->curve + (p->rational ? d + 1 : 0);

    if (e < k)
        e = k;
    ix__path_restrict(p, span, c->t0, c->t1, f->curve);
    for (int a = 0; a < p->ncoords; a++) {
        double *diff = f->diff + a * (e + 1), *q = f->work;
        double *work = q + e + 1;

        if (p->rational)
            ix__bernstein_mul(d, f->curve, k, c->pts[a], work, q);
        else
            ix__bernstein_raise(k, c->pts[a], e - k, work, q);
        ix__bernstein_raise(d, x + a * (d + 1), e - d, work, diff);
        for (int i = 0; i <= e; i++)
            diff[i] -= q[i];
    }
    for (int i = 0; p->rational && i <= d; i++)
        least = fmin(least, fabs(f->curve[i]));
    if (!p->rational)
        least = 1;
    return ix__bernstein_max(p->ncoords, e, f->diff, f->work) / least;
}

static ix_status push(ix_ctx *ctx, fit *f, const piece *c)
{
    if (f->n == f->cap) {
        piece *more;

        f->cap = f->cap ? 2 * f->cap : 16;
        if (f->cap > 1 << 20)
            return IX_FAIL(ctx, IX_EUNABLE,
                           "tolerance %g: more than a million pieces", f->tol);
        IX_SCRATCH(ctx, more, f->cap);
        if (f->n)
            memcpy(more, f->pieces, (size_t)f->n * sizeof *more);
        f->pieces = more;
    }
    f->pieces[f->n++] = *c;
    return IX_OK;
}

/* The longest good piece from c->t0 that ends at c->t1 or before. */
static ix_status longest(ix_ctx *ctx, fit *f, int span, piece *c)
{
    double whole = c->t1 - c->t0, len;

    for (;;) {
        double err, shrink;

        approximate(f, span, c);
        err = error(f, span, c);
        if (err <= f->tol) {
            f->worst = fmax(f->worst, err);
            break;
        }
        /* the error goes with h^order; 0.95: not to miss it again */
        shrink = 0.95 * pow(f->tol / err, 1.0 / f->order);
        c->t1 = c->t0 + (c->t1 - c->t0) * (shrink > 0.1 ? shrink : 0.1);
        if (!(c->t1 - c->t0 > 1e-9 * whole))
            return IX_FAIL(ctx, IX_EUNABLE,
                           "error %g at parameter %g where %g is asked for",
                           err, c->t0, f->tol);
    }
    if (!(f->max_len > 0))
        return IX_OK;
    len = ix__span_length(f->p, span, c->t0, c->t1);
    if (len > f->max_len) { /* even parts, none too long */
        double part = len / ceil(len / f->max_len);

        c->t1 = ix__span_at_length(f->p, span, c->t0, c->t1, len, part);
        approximate(f, span, c);
    }
    return IX_OK;
}

static ix_status walk(ix_ctx *ctx, fit *f)
{
    const ix_path *p = f->p;

    for (int s = 0; s < p->nspans; s++) {
        double t = p->breaks[s];

        while (t < p->breaks[s + 1]) {
            piece c = {.t0 = t, .t1 = p->breaks[s + 1]};

            IX_TRY(ix__poll(ctx));
            IX_TRY(longest(ctx, f, s, &c));
            IX_TRY(push(ctx, f, &c));
            t = c.t1;
        }
    }
    return IX_OK;
}

static ix_status emit(ix_ctx *ctx, const fit *f, ix_crvs *out)
{
    const ix_dir dir = {
        .basis = IX_BEZIER, .order = f->order, .length = f->order};
    double pts[IX_MAX_COORDS * 4];

    IX_TRY(ix__crvs_new(ctx, f->n, out));
    for (int i = 0; i < f->n; i++) {
        for (int k = 0; k < f->p->ncoords; k++)
            memcpy(pts + k * f->order, f->pieces[i].pts[k],
                   (size_t)f->order * sizeof *pts);
        out->t[2 * i] = f->pieces[i].t0;
        out->t[2 * i + 1] = f->pieces[i].t1;
        IX_TRY(
            ix_mv_new(ctx, 1, &dir, f->p->ncoords, false, pts, &out->crv[i]));
    }
    return IX_OK;
}

static ix_status fit_pieces(ix_ctx *ctx, const ix_mv *crv, fit *f, ix_crvs *out)
{
    size_t d, nc;

    IX_TRY(ix__path_new(ctx, crv, &f->path));
    IX_TRY(ix__path_no_poles(ctx, &f->path));
    f->p = &f->path;
    d = (size_t)f->p->degree + (size_t)f->order;
    nc = (size_t)f->p->naxes;
    IX_SCRATCH(ctx, f->curve, nc * (d + 1));
    IX_SCRATCH(ctx, f->diff, nc * (d + 1));
    IX_SCRATCH(ctx, f->work, nc * (d + 1) + ix__bernstein_work((int)d));
    IX_TRY(walk(ctx, f));
    return emit(ctx, f, out);
}

ix_status ix_fit_pieces(ix_ctx *ctx, const ix_mv *crv, int order, double tol,
                        double max_len, double *err, ix_crvs *out)
{
    fit f = {.order = order, .tol = tol, .max_len = max_len};
    ix_mark mk;
    ix_status st;

    *out = (ix_crvs){0};
    if (order != 3 && order != 4)
        return IX_FAIL(ctx, IX_EARG, "order %d is neither 3 nor 4", order);
    if (!(tol > 0 && isfinite(tol)))
        return IX_FAIL(ctx, IX_EARG, "tolerance %g is not positive", tol);
    mk = ix__scratch_mark(ctx);
    st = fit_pieces(ctx, crv, &f, out);
    if (st != IX_OK)
        ix_crvs_free(ctx, out);
    else if (err)
        *err = f.worst;
    ix__scratch_release(ctx, mk);
    return st;
}
