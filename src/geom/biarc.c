/* biarc.c - planar curves as circular arcs.
 *
 * A biarc meets two points and tangents with two arcs that share a tangent
 * where they join; here the one whose arms are equally long (Bolton 1975):
 * with v = p1 - p0 and arms d,
 *
 *   |v|^2 - 2 d v.(t0 + t1) - 2 d^2 (1 - t0.t1) = 0,
 *   joint = (p0 + d t0 + p1 - d t1) / 2.
 *
 * Distances are bounded, not sampled: for an arc from p with normal n and
 * curvature k, the form h = k |X - p|^2 / 2 - n.(X - p) gives the distance
 * 2 h / (1 + sqrt(1 + 2 k h)), also for k = 0. */
#include <math.h>
#include <string.h>

#include "geom/angle.h"
#include "geom/bound.h"
#include "geom/crvs.h"
#include "geom/march.h"

typedef struct {
    double p[2], q[2], r[2]; /* control points; q where the tangents meet */
    double w;                /* cosine of half the angle */
    double t0, t1;
} arc;

typedef struct {
    ix_path path;
    const ix_path *p;    /* it */
    double tol, least_w; /* cosine of half the largest angle */
    double *crv;         /* [naxes][d + 1] of the interval */
    double *rel;         /* [3][d + 1]: w, x - w p_x, y - w p_y */
    double *form;        /* [2 d + 1] */
    double *work;
    double worst;
    arc now[2]; /* the candidate */
    int nnow;
    int n, cap;
    arc *arcs;
} biarcs;

static double dot2(const double a[2], const double b[2])
{
    return a[0] * b[0] + a[1] * b[1];
}

/* Bound of the distance between the curve over [t0, t1] of one span and the
 * arc's circle or line. */
static double span_distance(const biarcs *b, int span, double t0, double t1,
                            const arc *a)
{
    const ix_path *p = b->p;
    int d = p->degree, m = d + 1, c = p->rational ? 1 : 0;
    double arm[2] = {a->q[0] - a->p[0], a->q[1] - a->p[1]};
    double chord[2] = {a->r[0] - a->p[0], a->r[1] - a->p[1]};
    double len = hypot(arm[0], arm[1]), n[2] = {-arm[1] / len, arm[0] / len};
    double k = 2 * dot2(n, chord) / dot2(chord, chord), least = HUGE_VAL, h;
    double *w = b->rel, *sq = b->work, *work = sq + 2 * d + 1;

    ix__path_restrict(p, span, t0, t1, b->crv);
    for (int i = 0; i < m; i++) {
        w[i] = c ? b->crv[i] : 1;
        least = fmin(least, fabs(w[i]));
        for (int j = 0; j < 2; j++)
            b->rel[(j + 1) * m + i] = b->crv[(j + c) * m + i] - w[i] * a->p[j];
    }
    memset(b->form, 0, (size_t)(2 * d + 1) * sizeof *b->form);
    for (int j = 0; j < 2; j++) {
        const double *x = b->rel + (j + 1) * m;

        ix__bernstein_mul(d, x, d, x, work, sq);
        for (int i = 0; i <= 2 * d; i++)
            b->form[i] += k / 2 * sq[i];
        ix__bernstein_mul(d, w, d, x, work, sq);
        for (int i = 0; i <= 2 * d; i++)
            b->form[i] -= n[j] * sq[i];
    }
    h = ix__bernstein_max(1, 2 * d, b->form, b->work) / (least * least);
    return 2 * h / (1 + sqrt(fmax(0, 1 - 2 * fabs(k) * h)));
}

/* The same over any interval. */
static double distance(const biarcs *b, double t0, double t1, const arc *a)
{
    const double *br = b->p->breaks;
    int last = ix__path_span_left(b->p, t1);
    double worst = 0;

    for (int s = ix__path_span(b->p, t0); s <= last && worst <= b->tol; s++)
        worst = fmax(worst, span_distance(b, s, fmax(t0, br[s]),
                                          fmin(t1, br[s + 1]), a));
    return worst;
}

/* Is the curve over [t0, t1] monotone along v? Then it meets each normal of
 * the biarc's chord once, so that small distances mean nearness all along. */
static bool monotone(const biarcs *b, double t0, double t1, const double v[2])
{
    int m = b->p->degree + 1, c = b->p->rational ? 1 : 0;
    int end = ix__path_span_left(b->p, t1);
    const double *br = b->p->breaks;
    double last = -HUGE_VAL, slack = 1e-12 * sqrt(dot2(v, v));

    for (int s = ix__path_span(b->p, t0); s <= end; s++) {
        ix__path_restrict(b->p, s, fmax(t0, br[s]), fmin(t1, br[s + 1]),
                          b->crv);
        for (int i = 0; i < m; i++) {
            double w = c ? b->crv[i] : 1;
            double x[2] = {b->crv[c * m + i] / w, b->crv[(c + 1) * m + i] / w};
            double at = dot2(x, v) / sqrt(dot2(v, v));

            if (!(at >= last - slack)) /* slack: rounding at the breaks */
                return false;
            last = at;
        }
    }
    return true;
}

/* How far beyond joint j, along tj, the curve is at t. */
static double beyond(const biarcs *b, double t, const double j[2],
                     const double tj[2])
{
    double x[IX_MAX_COORDS];

    ix__path_point(b->p, t, x);
    return (x[0] - j[0]) * tj[0] + (x[1] - j[1]) * tj[1];
}

/* The parameter at which the curve crosses the normal at joint j. */
static bool cross_joint(const biarcs *b, double t0, double t1,
                        const double j[2], const double tj[2], double *t)
{
    if (!(beyond(b, t0, j, tj) < 0 && beyond(b, t1, j, tj) > 0))
        return false;
    for (int it = 0; it < 54; it++) { /* to the last bit of t1 - t0 */
        *t = t0 + (t1 - t0) / 2;
        if (beyond(b, *t, j, tj) < 0)
            t0 = *t;
        else
            t1 = *t;
    }
    return true;
}

/* End point and unit tangent. */
static bool end_data(const biarcs *b, double t, bool at_end, double pt[2],
                     double tan[2])
{
    int span = at_end ? ix__path_span_left(b->p, t) : ix__path_span(b->p, t);
    double d[1][3], u[3], len;

    ix__path_derivs3(b->p, span, t, 0, d);
    if (!ix__path_tangent3(b->p, span, t, at_end, u))
        return false;
    len = hypot(u[0], u[1]);
    for (int k = 0; k < 2; k++) {
        pt[k] = d[0][k];
        tan[k] = u[k] / len;
    }
    return len > 0;
}

/* The two arcs for the interval [c[0].t0, c[1].t1]; false if there are none
 * within half a turn each. */
static bool make_biarc(const biarcs *b, arc c[2])
{
    double p0[2], p1[2], t0[2], t1[2], v[2], sum[2], vs, vv, d;

    if (!end_data(b, c[0].t0, false, p0, t0) ||
        !end_data(b, c[1].t1, true, p1, t1))
        return false;
    for (int k = 0; k < 2; k++) {
        v[k] = p1[k] - p0[k];
        sum[k] = t0[k] + t1[k];
    }
    vv = dot2(v, v);
    vs = dot2(v, sum);
    d = vs + sqrt(vs * vs + 2 * (1 - dot2(t0, t1)) * vv);
    if (!(d > 1e-6 * sqrt(vv))) /* the arms would be a million chords long */
        return false;
    d = vv / d;
    for (int k = 0; k < 2; k++) {
        c[0].p[k] = p0[k];
        c[0].q[k] = p0[k] + d * t0[k];
        c[1].q[k] = p1[k] - d * t1[k];
        c[1].r[k] = p1[k];
        c[0].r[k] = c[1].p[k] = (c[0].q[k] + c[1].q[k]) / 2;
    }
    for (int i = 0; i < 2; i++)
        c[i].w = hypot(c[i].r[0] - c[i].p[0], c[i].r[1] - c[i].p[1]) / (2 * d);
    return c[0].w >= b->least_w && c[1].w >= b->least_w;
}

/* Distance of the biarc of the interval, infinite if there is none. */
static double try_biarc(const biarcs *b, arc c[2])
{
    double v[2], tj[2], t;

    if (!make_biarc(b, c))
        return HUGE_VAL;
    for (int k = 0; k < 2; k++) {
        v[k] = c[1].r[k] - c[0].p[k];
        tj[k] = c[1].q[k] - c[0].q[k];
    }
    if (!monotone(b, c[0].t0, c[1].t1, v) ||
        !cross_joint(b, c[0].t0, c[1].t1, c[0].r, tj, &t))
        return HUGE_VAL;
    c[0].t1 = c[1].t0 = t;
    return fmax(distance(b, c[0].t0, t, &c[0]), distance(b, t, c[1].t1, &c[1]));
}

/* One arc instead of two of the same circle (or line), if allowed. */
static bool join(const biarcs *b, const arc c[2], arc *out)
{
    double v[2], u[2], k[2], vv, cosine, arm;

    for (int i = 0; i < 2; i++) {
        double x[2] = {c[i].r[0] - c[i].p[0], c[i].r[1] - c[i].p[1]};
        double y[2] = {c[i].q[0] - c[i].p[0], c[i].q[1] - c[i].p[1]};

        k[i] = 2 * (y[0] * x[1] - y[1] * x[0]) /
               (hypot(y[0], y[1]) * dot2(x, x));
    }
    for (int i = 0; i < 2; i++) {
        v[i] = c[1].r[i] - c[0].p[i];
        u[i] = c[0].q[i] - c[0].p[i];
    }
    vv = dot2(v, v);
    cosine = dot2(u, v) / sqrt(dot2(u, u) * vv);
    /* 1e-10 of the chord: curvatures that differ by rounding */
    if (!(fabs(k[0] - k[1]) * sqrt(vv) <= 1e-10) || !(cosine >= b->least_w))
        return false;
    arm = sqrt(vv) / (2 * cosine) / sqrt(dot2(u, u));
    *out = c[0];
    for (int i = 0; i < 2; i++) {
        out->q[i] = c[0].p[i] + arm * u[i];
        out->r[i] = c[1].r[i];
    }
    out->w = cosine;
    out->t1 = c[1].t1;
    return true;
}

static ix_status push(ix_ctx *ctx, biarcs *b, const arc *a)
{
    if (b->n == b->cap) {
        arc *more;

        b->cap = b->cap ? 2 * b->cap : 32;
        if (b->cap > 1 << 20)
            return IX_FAIL(ctx, IX_EUNABLE,
                           "tolerance %g: more than a million arcs", b->tol);
        IX_SCRATCH(ctx, more, b->cap);
        if (b->n)
            memcpy(more, b->arcs, (size_t)b->n * sizeof *more);
        b->arcs = more;
    }
    b->arcs[b->n++] = *a;
    return IX_OK;
}

/* Where no biarc can be had (around a cusp), the chord, if the curve stays
 * within the tolerance of its start; within one span. */
static bool tiny(const biarcs *b, double t0, double t1, arc *out)
{
    int m = b->p->degree + 1, c = b->p->rational ? 1 : 0;
    int span = ix__path_span(b->p, t0);
    double d[2][3];

    if (span != ix__path_span_left(b->p, t1))
        return false;
    ix__path_derivs3(b->p, span, t0, 0, &d[0]);
    ix__path_derivs3(b->p, span, t1, 0, &d[1]);
    ix__path_restrict(b->p, span, t0, t1, b->crv);
    for (int i = 0; i < m; i++) {
        double w = c ? b->crv[i] : 1;

        if (!(hypot(b->crv[c * m + i] / w - d[0][0],
                    b->crv[(c + 1) * m + i] / w - d[0][1]) <= b->tol / 2))
            return false;
    }
    *out = (arc){.w = 1, .t0 = t0, .t1 = t1};
    for (int k = 0; k < 2; k++) {
        out->p[k] = d[0][k];
        out->r[k] = d[1][k];
        out->q[k] = (d[0][k] + d[1][k]) / 2;
    }
    return true;
}

/* The candidate of an interval: one or two arcs in b->now. */
static double try_arcs(void *arg, double t0, double t1)
{
    biarcs *b = arg;
    arc c[2] = {{.t0 = t0}, {.t1 = t1}};
    double err = try_biarc(b, c);

    b->nnow = 2;
    memcpy(b->now, c, sizeof c);
    if (err <= b->tol && join(b, c, &b->now[0]))
        b->nnow = 1;
    if (!(err <= b->tol) && tiny(b, t0, t1, &b->now[0])) {
        b->nnow = 1;
        err = b->tol / 2;
    }
    return err;
}

static ix_status keep(ix_ctx *ctx, void *arg, double t0, double t1)
{
    biarcs *b = arg;

    b->worst = fmax(b->worst, try_arcs(b, t0, t1));
    for (int i = 0; i < b->nnow; i++)
        IX_TRY(push(ctx, b, &b->now[i]));
    return IX_OK;
}

static ix_status emit(ix_ctx *ctx, const biarcs *b, double z, ix_crvs *out)
{
    const ix_dir dir = {.basis = IX_BEZIER, .order = 3, .length = 3};
    int nc = b->p->ncoords > 2 ? 3 : 2;

    IX_TRY(ix__crvs_new(ctx, b->n, out));
    for (int i = 0; i < b->n; i++) {
        const arc *a = &b->arcs[i];
        double pts[12];

        for (int k = 0; k < 3; k++) {
            const double *x = k == 0 ? a->p : k == 1 ? a->q : a->r;
            double w = k == 1 ? a->w : 1;

            pts[k] = w;
            pts[3 + k] = w * x[0];
            pts[6 + k] = w * x[1];
            pts[9 + k] = w * z;
        }
        out->t[2 * i] = a->t0;
        out->t[2 * i + 1] = a->t1;
        IX_TRY(ix_mv_new(ctx, 1, &dir, nc, true, pts, &out->crv[i]));
    }
    return IX_OK;
}

/* The curve's height, if it is in a plane z = const. */
static ix_status height(ix_ctx *ctx, const ix_path *p, double *z)
{
    int m = p->degree + 1, c = p->rational ? 1 : 0;
    double size = ix__path_size(p);

    *z = 0;
    for (int s = 0; p->ncoords > 2 && s < p->nspans; s++)
        for (int i = 0; i < m; i++) {
            const double *b = p->coef + (size_t)s * (size_t)(p->naxes * m);
            double at = b[(c + 2) * m + i] / (c ? b[i] : 1);

            if (s == 0 && i == 0)
                *z = at;
            /* 1e-12 of the size: rounding of transformed curves */
            if (!(fabs(at - *z) <= 1e-12 * (size + fabs(*z))))
                return IX_FAIL(ctx, IX_EARG,
                               "the curve is not in a plane z = const: z is %g "
                               "and %g",
                               *z, at);
        }
    return IX_OK;
}

static ix_status biarc(ix_ctx *ctx, const ix_mv *crv, biarcs *b, ix_crvs *out)
{
    const ix_path *p = &b->path;
    /* a biarc's error goes with h^3 */
    const ix_march march = {p, b->tol, 3, try_arcs, keep, b};
    size_t m;
    double z;

    IX_TRY(ix__path_new(ctx, crv, &b->path));
    IX_TRY(ix__path_no_poles(ctx, p));
    IX_TRY(height(ctx, p, &z));
    if (2 * p->degree >= IX_MAX_ORDER)
        return IX_FAIL(ctx, IX_EUNABLE, "degree %d is too high", p->degree);
    b->p = p;
    m = (size_t)p->degree + 1;
    IX_SCRATCH(ctx, b->crv, (size_t)p->naxes * m);
    IX_SCRATCH(ctx, b->rel, 3 * m);
    IX_SCRATCH(ctx, b->form, 2 * m);
    IX_SCRATCH(ctx, b->work, 2 * m + ix__bernstein_work(2 * p->degree));
    IX_TRY(ix__march(ctx, &march));
    return emit(ctx, b, z, out);
}

ix_status ix_biarcs(ix_ctx *ctx, const ix_mv *crv, double tol, double max_angle,
                    double *err, ix_crvs *out)
{
    biarcs b = {.tol = tol};
    ix_mark mk;
    ix_status st;

    *out = (ix_crvs){0};
    if (ix_mv_ncoords(crv) < 2)
        return IX_FAIL(ctx, IX_EARG, "arcs need two coordinates");
    if (!(tol > 0 && isfinite(tol)))
        return IX_FAIL(ctx, IX_EARG, "tolerance %g is not positive", tol);
    if (!(max_angle > 0))
        return IX_FAIL(ctx, IX_EARG, "largest angle %g is not positive",
                       max_angle);
    /* 170 degrees: an arc's weight must stay well above 0 */
    b.least_w = cos(IX__RADIANS(fmin(max_angle, 170)) / 2);
    mk = ix__scratch_mark(ctx);
    st = biarc(ctx, crv, &b, out);
    if (st != IX_OK)
        ix_crvs_free(ctx, out);
    else if (err)
        *err = b.worst;
    ix__scratch_release(ctx, mk);
    return st;
}
