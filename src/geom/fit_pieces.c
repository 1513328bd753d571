/* fit_pieces.c - quadratic or cubic Bezier pieces near a curve.
 *
 * A piece has the curve's end points and, in its own parameter, half the sum
 * of the end tangents' information (quadratic) or both end derivatives
 * (cubic); polynomial curves of no higher degree come back exactly. Every
 * piece is made as long as the tolerance allows. */
#include <math.h>
#include <string.h>

#include "geom/arclen.h"
#include "geom/bound.h"
#include "geom/crvs.h"
#include "geom/march.h"

typedef struct {
    double t0, t1;
    double pts[IX_MAX_COORDS][4];
} piece;

typedef struct {
    ix_path path;
    const ix_path *p; /* it */
    int order;        /* 3 or 4 */
    double tol, max_len, worst;
    double *curve, *part, *diff, *work;
    piece now; /* the candidate */
    int n, cap;
    piece *pieces;
} fit;

/* End points and end derivatives of the interval, on [0, 1]. */
static void approximate(const fit *f, piece *c)
{
    double a[2 * IX_MAX_COORDS], b[2 * IX_MAX_COORDS], h = c->t1 - c->t0;
    int nc = f->p->ncoords;

    ix__path_derivs(f->p, ix__path_span(f->p, c->t0), c->t0, 1, a);
    ix__path_derivs(f->p, ix__path_span_left(f->p, c->t1), c->t1, 1, b);
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

/* Largest |C - q| over the part of the piece that is in one span: numerator
 * X - w q against the least weight. Bounded, not sampled. */
static double span_error(const fit *f, int span, const piece *c)
{
    const ix_path *p = f->p;
    int d = p->degree, k = f->order - 1, e = p->rational ? d + k : d;
    double a = fmax(c->t0, p->breaks[span]), least = 1, h = c->t1 - c->t0;
    double b = fmin(c->t1, p->breaks[span + 1]);
    double *x = f->curve + (p->rational ? d + 1 : 0);

    if (e < k)
        e = k;
    ix__path_restrict(p, span, a, b, f->curve);
    for (int i = 0; i < p->ncoords; i++) {
        double *diff = f->diff + i * (e + 1), *q = f->work;
        double *work = q + e + 1;

        ix__bernstein_restrict(k, (a - c->t0) / h, (b - c->t0) / h, c->pts[i],
                               f->part);
        if (p->rational)
            ix__bernstein_mul(d, f->curve, k, f->part, work, q);
        else
            ix__bernstein_raise(k, f->part, e - k, work, q);
        ix__bernstein_raise(d, x + i * (d + 1), e - d, work, diff);
        for (int j = 0; j <= e; j++)
            diff[j] -= q[j];
    }
    for (int i = 0; p->rational && i <= d; i++)
        least = i ? fmin(least, fabs(f->curve[i])) : fabs(f->curve[i]);
    return ix__bernstein_max(p->ncoords, e, f->diff, f->work) / least;
}

static double try_piece(void *arg, double t0, double t1)
{
    fit *f = arg;
    int last = ix__path_span_left(f->p, t1);
    double err = 0;

    f->now.t0 = t0;
    f->now.t1 = t1;
    approximate(f, &f->now);
    for (int s = ix__path_span(f->p, t0); s <= last && err <= f->tol; s++)
        err = fmax(err, span_error(f, s, &f->now));
    return err;
}

static ix_status push(ix_ctx *ctx, fit *f)
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
    f->pieces[f->n++] = f->now;
    return IX_OK;
}

/* Keeps the piece; one that is too long goes in parts of equal length. */
static ix_status keep(ix_ctx *ctx, void *arg, double t0, double t1)
{
    fit *f = arg;
    double len = 0, from = t0;
    int parts = 1;

    if (f->max_len > 0) {
        len = ix__path_length(f->p, t0, t1);
        if (!(len / f->max_len <= 1 << 20))
            return IX_FAIL(ctx, IX_EUNABLE,
                           "length limit %g: more than a million pieces",
                           f->max_len);
        parts = len > f->max_len ? (int)ceil(len / f->max_len) : 1;
    }
    for (int i = 1; i <= parts; i++) {
        double to = i == parts
                        ? t1
                        : ix__path_at_length(f->p, t0, t1, len * i / parts);

        f->worst = fmax(f->worst, try_piece(f, from, to));
        IX_TRY(push(ctx, f));
        from = to;
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
    const ix_march m = {&f->path, f->tol, f->order, try_piece, keep, f};
    size_t d, nc;

    IX_TRY(ix__path_new(ctx, crv, &f->path));
    IX_TRY(ix__path_no_poles(ctx, &f->path));
    f->p = &f->path;
    d = (size_t)f->p->degree + (size_t)f->order;
    nc = (size_t)f->p->naxes;
    IX_SCRATCH(ctx, f->curve, nc * (d + 1));
    IX_SCRATCH(ctx, f->part, f->order);
    IX_SCRATCH(ctx, f->diff, nc * (d + 1));
    IX_SCRATCH(ctx, f->work, nc * (d + 1) + ix__bernstein_work((int)d));
    IX_TRY(ix__march(ctx, &m));
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
