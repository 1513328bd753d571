/* crv_offset.c - offsets of curves: pieces between corners, each refined until
 * its moved control points are near enough to the exact offset. */
#include <string.h>

#include "geom/offset_side.h"
#include "geom/parts.h"
#include "geom/vec3.h"
#include "iritx/offset.h"

enum { SAMPLES = 8, MAX_ROUNDS = 24, MAX_POINTS = 1 << 14 };

typedef struct {
    ix_ctx *ctx;
    const ix_offset_opts *o;
    ix_side side;
    double whole[2];
    double worst; /* over all pieces */
} job;

/* --- one candidate -------------------------------------------------------- */

static ix_status no_tangent(ix_ctx *ctx, double t)
{
    return IX_FAIL(ctx, IX_EDOMAIN,
                   "no normal at %g: the derivatives vanish there", t);
}

/* The points of c (open or Bezier) moved at its nodes. */
static ix_status move_points(job *j, const ix_mv *c, ix_mv **out)
{
    const double *w = ix_mv_weights(c);
    double *node, shift[3];
    ix_mv *m;

    IX_SCRATCH(j->ctx, node, c->npts);
    ix_knots_nodes(&c->dirs[0], node);
    IX_TRY(ix__mv_alloc(j->ctx, 1, c->dirs, c->ncoords, c->rational, &m));
    memcpy(m->pts, c->pts, (size_t)c->naxes * c->npts * sizeof *m->pts);
    for (size_t i = 0; i < c->npts; i++) {
        if (!ix__side_shift(&j->side, j->whole, node[i], shift)) {
            ix_mv_unref(j->ctx, m);
            return no_tangent(j->ctx, node[i]);
        }
        for (int k = 0; k < c->ncoords && k < 3; k++)
            m->pts[(size_t)(k + (w ? 1 : 0)) * c->npts + i] += (w ? w[i] : 1) *
                                                               shift[k];
    }
    *out = m;
    return IX_OK;
}

/* The exact offset at n parameters, double[ncoords][n]. */
static ix_status exact_points(const job *j, size_t n, const double *t,
                              double *pts)
{
    int nc = j->side.c.ncoords;
    double p[IX_MAX_COORDS], shift[3];

    for (size_t i = 0; i < n; i++) {
        if (!ix__side_shift(&j->side, j->whole, t[i], shift))
            return no_tangent(j->ctx, t[i]);
        ix__path_point(&j->side.c, t[i], p);
        for (int k = 0; k < nc; k++)
            pts[(size_t)k * n + i] = p[k] + (k < 3 ? shift[k] : 0);
    }
    return IX_OK;
}

/* The polynomial spline on c's knots through the offset at the nodes. */
static ix_status interpolate(job *j, const ix_mv *c, ix_mv **out)
{
    ix_interpolate_opts o = {.order = c->dirs[0].order};
    double *node, *pts;
    ix_mv *bsp;
    ix_status st;

    IX_SCRATCH(j->ctx, node, c->npts);
    IX_SCRATCH(j->ctx, pts, (size_t)c->ncoords * c->npts);
    ix_knots_nodes(&c->dirs[0], node);
    IX_TRY(exact_points(j, c->npts, node, pts));
    IX_TRY(ix_mv_to_bspline(j->ctx, c, &bsp));
    o.params = node;
    o.nparams = (int)c->npts;
    o.knots = bsp->dirs[0].knots;
    o.nknots = ix_knots_count(&bsp->dirs[0]);
    st = ix_interpolate(j->ctx, (int)c->npts, c->ncoords, false, pts, &o, NULL,
                        out);
    ix_mv_unref(j->ctx, bsp);
    return st;
}

/* Largest distance of off from the exact offset in one of its spans. */
static ix_status span_error(job *j, const ix_path *off, int span, double *err)
{
    double a = off->breaks[span], h = off->breaks[span + 1] - a;
    double got[IX_MAX_COORDS], want[IX_MAX_COORDS], d[IX_MAX_COORDS];

    *err = 0;
    for (int i = 0; i < SAMPLES; i++) {
        double t = a + h * (i + 0.5) / SAMPLES, sum = 0;

        IX_TRY(exact_points(j, 1, &t, want));
        ix__path_point(off, t, got);
        for (int k = 0; k < off->ncoords; k++) {
            d[k] = got[k] - want[k];
            sum += d[k] * d[k];
        }
        *err = fmax(*err, sqrt(sum));
    }
    return IX_OK;
}

/* The middles of the spans of off with too large an error. */
static ix_status bad_spans(job *j, const ix_mv *off, double *worst, int *n,
                           double **knots)
{
    double tiny = ldexp(j->whole[1] - j->whole[0], -20);
    ix_path p;

    IX_TRY(ix__path_new(j->ctx, off, &p));
    IX_SCRATCH(j->ctx, *knots, p.nspans);
    *n = 0;
    *worst = 0;
    for (int s = 0; s < p.nspans; s++) {
        double a = p.breaks[s], b = p.breaks[s + 1], err;

        IX_TRY(span_error(j, &p, s, &err));
        *worst = fmax(*worst, err);
        if (!(err <= j->o->tol) && b - a > tiny)
            (*knots)[(*n)++] = a + (b - a) / 2;
    }
    return IX_OK;
}

/* --- one piece
 * ------------------------------------------------------------- */

static ix_status candidate(job *j, const ix_mv *c, ix_mv **out)
{
    return j->o->interpolate ? interpolate(j, c, out) : move_points(j, c, out);
}

/* *cur gets more knots until *out is near enough. */
static ix_status refine(job *j, ix_mv **cur, ix_mv **out)
{
    double worst = 0, *knots;
    int n;

    for (int round = 0;; round++) {
        ix_mark mk = ix__scratch_mark(j->ctx);
        ix_mv *next = NULL;
        ix_status st = candidate(j, *cur, out);

        if (st == IX_OK)
            st = bad_spans(j, *out, &worst, &n, &knots);
        if (st == IX_OK &&
            (n == 0 || round == MAX_ROUNDS || (*cur)->npts > MAX_POINTS)) {
            j->worst = fmax(j->worst, worst);
            ix__scratch_release(j->ctx, mk);
            return IX_OK;
        }
        if (st == IX_OK)
            st = ix_mv_insert_knots(j->ctx, *cur, 0, n, knots, &next);
        ix_mv_unref(j->ctx, *out);
        *out = NULL;
        ix__scratch_release(j->ctx, mk);
        IX_TRY(st);
        ix_mv_unref(j->ctx, *cur);
        *cur = next;
        IX_TRY(ix__poll(j->ctx));
    }
}

/* The offset of the part [t0, t1] of the curve, which has no corner inside. */
static ix_status piece(job *j, const ix_mv *crv, double t0, double t1,
                       ix_mv **out)
{
    bool all = t0 <= j->whole[0] && t1 >= j->whole[1];
    ix_mv *cur;
    ix_status st;

    if (all)
        cur = ix_mv_ref(crv);
    else
        IX_TRY(ix_mv_region(j->ctx, crv, 0, t0, t1, &cur));
    st = ix__side_new(j->ctx, cur, j->o->distance, j->o->field, &j->side);
    if (st == IX_OK)
        st = refine(j, &cur, out);
    ix_mv_unref(j->ctx, cur);
    return st;
}

/* --- pieces joined ---------------------------------------------------------
 */

static ix_status end_point(ix_ctx *ctx, const ix_mv *m, int end, double p[3])
{
    double dom[2], x[IX_MAX_COORDS] = {0};

    ix_mv_domain(m, 0, dom);
    IX_TRY(ix_mv_point(ctx, m, &dom[end], x));
    memcpy(p, x, 3 * sizeof *p);
    return IX_OK;
}

/* *sum, if any, continued by next: shared end, or a straight bridge. */
static ix_status join(job *j, ix_mv **sum, ix_mv *next)
{
    double a[3], b[3];
    ix_mv *both;
    ix_status st;

    if (!*sum) {
        *sum = ix_mv_ref(next);
        return IX_OK;
    }
    IX_TRY(end_point(j->ctx, *sum, 1, a));
    IX_TRY(end_point(j->ctx, next, 0, b));
    st = ix_mv_merge(
        j->ctx, *sum, next, 0,
        ix__dist3(a, b) <= j->o->tol ? IX_JOIN_SHARED : IX_JOIN_BRIDGE, &both);
    IX_TRY(st);
    ix_mv_unref(j->ctx, *sum);
    *sum = both;
    return IX_OK;
}

static ix_status pieces(job *j, const ix_mv *crv, ix_mv **sum)
{
    ix_path whole;
    int at = 0;

    IX_TRY(ix__path_new(j->ctx, crv, &whole));
    while (at < whole.nspans) {
        int to = ix__path_corner(&whole, at + 1);
        ix_mv *next = NULL;
        ix_status st;

        IX_TRY(piece(j, crv, whole.breaks[at], whole.breaks[to], &next));
        st = join(j, sum, next);
        ix_mv_unref(j->ctx, next);
        IX_TRY(st);
        at = to;
    }
    return IX_OK;
}

static ix_status offset(ix_ctx *ctx, const ix_mv *crv, const ix_offset_opts *o,
                        double *err, ix_mv **out)
{
    job j = {.ctx = ctx, .o = o};
    ix_mv *plain = NULL, *open = NULL;
    ix_status st;

    IX_TRY(ix__mv_plain(ctx, crv, &plain));
    st = ix_mv_to_open(ctx, plain, &open);
    if (st == IX_OK) {
        ix_mv_domain(open, 0, j.whole);
        st = pieces(&j, open, out);
    }
    ix_mv_unref(ctx, plain);
    ix_mv_unref(ctx, open);
    if (st != IX_OK) {
        ix_mv_unref(ctx, *out);
        *out = NULL;
        return st;
    }
    if (err)
        *err = j.worst;
    return IX_OK;
}

ix_status ix_crv_offset(ix_ctx *ctx, const ix_mv *crv, const ix_offset_opts *o,
                        double *err, ix_mv **out)
{
    *out = NULL;
    if (crv->ndirs != 1 || !(o->tol > 0))
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions, tolerance %g; a curve and a positive "
                       "tolerance are wanted",
                       crv->ndirs, o->tol);
    IX_RETURN_SCOPED(ctx, offset(ctx, crv, o, err, out));
}

/* --- least squares ---------------------------------------------------------
 */

/* Open uniform knots over the curve's domain. */
static ix_status even_knots(job *j, int order, int size, double **knots)
{
    int n = order + size;

    IX_SCRATCH(j->ctx, *knots, n);
    IX_TRY(ix_knots_make(j->ctx, IX_KV_OPEN, order, size, *knots));
    for (int i = 0; i < n; i++)
        (*knots)[i] = (*knots)[i] >= 1
                          ? j->whole[1]
                          : j->whole[0] +
                                (*knots)[i] * (j->whole[1] - j->whole[0]);
    return IX_OK;
}

static ix_status offset_fit(ix_ctx *ctx, const ix_mv *crv, double distance,
                            int samples, int size, int order, double *err,
                            ix_mv **out)
{
    job j = {.ctx = ctx};
    ix_interpolate_opts o = {.order = order, .size = size};
    double *t, *pts, *knots;

    IX_TRY(ix__side_new(ctx, crv, distance, NULL, &j.side));
    ix_mv_domain(crv, 0, j.whole);
    IX_SCRATCH(ctx, t, samples);
    IX_SCRATCH(ctx, pts, (size_t)samples * (size_t)crv->ncoords);
    for (int i = 0; i < samples; i++)
        t[i] = i == samples - 1
                   ? j.whole[1]
                   : j.whole[0] + (j.whole[1] - j.whole[0]) * i / (samples - 1);
    IX_TRY(exact_points(&j, (size_t)samples, t, pts));
    IX_TRY(even_knots(&j, order, size, &knots));
    o.params = t;
    o.nparams = samples;
    o.knots = knots;
    o.nknots = order + size;
    return ix_interpolate(ctx, samples, crv->ncoords, false, pts, &o, err, out);
}

ix_status ix_crv_offset_fit(ix_ctx *ctx, const ix_mv *crv, double distance,
                            int samples, int size, int order, double *err,
                            ix_mv **out)
{
    *out = NULL;
    if (crv->ndirs != 1 || order < 1 || size < order || samples < size ||
        samples < 2)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions, %d samples, %d control points, order "
                       "%d; a curve and order <= points <= samples are wanted",
                       crv->ndirs, samples, size, order);
    IX_RETURN_SCOPED(
        ctx, offset_fit(ctx, crv, distance, samples, size, order, err, out));
}
