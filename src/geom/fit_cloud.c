/* fit_cloud.c - a B-spline near points without order, by iteration: nearest
 * parameters, then least squares for the control points.
 *
 * With the squared distance in the second step (Wang, Pottmann, Liu 2006) an
 * error along the tangent counts only as much as the curve's distance really
 * grows: 0 on the side of the centre of curvature, d / (d + rho) of it on the
 * other. Unknowns are interleaved, x y z of one control point after the
 * other's, so that the system stays banded. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bsp/band.h"
#include "bsp/basis.h"
#include "geom/angle.h"
#include "geom/eigen.h"
#include "geom/gauss.h"
#include "geom/path.h"
#include "iritx/geom.h"

typedef struct {
    double t, dist;
    int span, point;
} foot;

typedef struct {
    const ix_cloud_opts *o;
    int n, nc;
    const double *pts; /* [nc][n] */
    foot *feet;
    double *probe; /* [probes][nc + 1]: parameter and point */
    int probes;
} cloud;

static double sq_dist(const cloud *c, int i, const double *x)
{
    double s = 0;

    for (int k = 0; k < c->nc; k++) {
        double d = c->pts[(size_t)k * (size_t)c->n + (size_t)i] - x[k];

        s += d * d;
    }
    return s;
}

/* Newton's method on (C - X).C' = 0 from the nearest probe, within its span;
 * a step that leads away is halved. */
static foot polish(const cloud *c, const ix_path *p, int i, double t)
{
    foot f = {.point = i, .span = ix__path_span(p, t), .t = t};
    double d[3 * IX_MAX_COORDS], at;
    double lo = p->breaks[f.span], hi = p->breaks[f.span + 1];

    ix__path_derivs(p, f.span, t, 0, d);
    at = sq_dist(c, i, d);
    for (int it = 0; it < 8; it++) {
        double g = 0, h = 0, next, now;

        ix__path_derivs(p, f.span, f.t, 2, d);
        for (int k = 0; k < c->nc; k++) {
            double e = d[k] - c->pts[(size_t)k * (size_t)c->n + (size_t)i];
            double v = d[c->nc + k];

            g += e * v;
            h += v * v + fmax(0, e * d[2 * c->nc + k]);
        }
        if (!(h > 0))
            break;
        next = fmin(hi, fmax(lo, f.t - g / h));
        ix__path_derivs(p, f.span, next, 0, d);
        now = sq_dist(c, i, d);
        if (!(now < at))
            break;
        at = now;
        f.t = next;
    }
    f.dist = sqrt(at);
    return f;
}

static int by_parameter(const void *a, const void *b)
{
    const foot *x = a, *y = b;

    if (x->t != y->t)
        return x->t < y->t ? -1 : 1;
    return x->point - y->point;
}

/* Foot points of all data, in the order of their parameters. */
static void project_all(cloud *c, const ix_path *p)
{
    int per = (c->probes - 1) / p->nspans, m = 0;

    for (int s = 0; s < p->nspans; s++)
        for (int j = 0; j < per; j++, m++) {
            double *x = c->probe + m * (c->nc + 1);
            double a = p->breaks[s], h = p->breaks[s + 1] - a;

            x[0] = a + h * (j + 0.5) / per;
            ix__path_derivs(p, s, x[0], 0, x + 1);
        }
    for (int i = 0; i < c->n; i++) {
        double best = HUGE_VAL, t = 0;

        for (int j = 0; j < m; j++) {
            const double *x = c->probe + j * (c->nc + 1);
            double d = sq_dist(c, i, x + 1);

            if (d < best) {
                best = d;
                t = x[0];
            }
        }
        c->feet[i] = polish(c, p, i, t);
    }
    qsort(c->feet, (size_t)c->n, sizeof *c->feet, by_parameter);
}

/* Weight of the tangential part of the error at a foot point: 1 for plain
 * distances. unit receives the tangent. */
static double tangent_weight(const cloud *c, const ix_path *p, const foot *f,
                             double *unit)
{
    double d[3 * IX_MAX_COORDS], vv = 0, along = 0, side = 0, k2 = 0, kappa;

    /* beyond an open end the distance is that of the end point */
    if (c->o->how == IX_CLOUD_POINT || f->t == p->breaks[0] ||
        f->t == p->breaks[p->nspans])
        return 1;
    ix__path_derivs(p, f->span, f->t, 2, d);
    for (int k = 0; k < c->nc; k++) {
        vv += d[c->nc + k] * d[c->nc + k];
        along += d[c->nc + k] * d[2 * c->nc + k];
    }
    if (!(vv > 0))
        return 1;
    for (int k = 0; k < c->nc; k++) {
        double n = d[2 * c->nc + k] - along / vv * d[c->nc + k];

        unit[k] = d[c->nc + k] / sqrt(vv);
        k2 += n * n;
        side += n *
                (c->pts[(size_t)k * (size_t)c->n + (size_t)f->point] - d[k]);
    }
    if (side >= 0)
        return 0;
    kappa = sqrt(k2) / vv;
    return f->dist * kappa / (1 + f->dist * kappa);
}

/* The rows of one point: (I - (1 - sqrt w) T T^T) (C(t) - X) = 0. */
static void add_point(const cloud *c, const ix_path *p, const ix_dir *dir,
                      const foot *f, double *basis, double *row, ix_band *b)
{
    double unit[IX_MAX_COORDS], w = tangent_weight(c, p, f, unit);
    double g = 1 - sqrt(w), scale = sqrt(1.0 / c->n);
    int k = dir->order, first = ix__basis_first(dir, f->t), nc = c->nc;

    ix__basis_derive(dir, first, f->t, 0, basis);
    for (int r = 0; r < nc; r++) {
        double rhs = 0;

        for (int q = 0; q < nc; q++) {
            double m = (r == q ? 1 : 0) - (g > 0 ? g * unit[r] * unit[q] : 0);

            for (int j = 0; j < k; j++)
                row[j * nc + q] = scale * m * basis[j];
            rhs += scale * m *
                   c->pts[(size_t)q * (size_t)c->n + (size_t)f->point];
        }
        ix__band_add(b, first % dir->length * nc, k * nc, row, &rhs);
    }
}

/* Rows of lambda times the integral of |C''|^2 over the domain as [0, 1]. */
static void add_smoothing(const cloud *c, const ix_path *p, const ix_dir *dir,
                          double *basis, double *row, ix_band *b)
{
    int k = dir->order, nc = c->nc;
    double len = p->breaks[p->nspans] - p->breaks[0], x[8], w[8], zero = 0;
    int m = k < 8 ? k : 8, der = k > 2 ? 2 : k - 1;

    ix__gauss(m, x, w);
    for (int s = 0; s < p->nspans; s++)
        for (int g = 0; g < m; g++) {
            double h = p->breaks[s + 1] - p->breaks[s];
            double t = p->breaks[s] + h * x[g];
            double f = sqrt(c->o->lambda * w[g] * h / len) * pow(len, der);
            int first = ix__basis_first(dir, t);

            ix__basis_derive(dir, first, t, der, basis);
            for (int r = 0; r < nc; r++) {
                memset(row, 0, (size_t)(k * nc) * sizeof *row);
                for (int j = 0; j < k; j++)
                    row[j * nc + r] = f * basis[j];
                ix__band_add(b, first % dir->length * nc, k * nc, row, &zero);
            }
        }
}

/* New control points for the present foot points. */
static ix_status improve(ix_ctx *ctx, const cloud *c, const ix_path *p,
                         const ix_dir *dir, ix_mv **out)
{
    size_t n = (size_t)dir->length, nc = (size_t)c->nc;
    double *basis, *row, *x, *coef;
    ix_band b;

    IX_SCRATCH(ctx, basis, dir->order);
    IX_SCRATCH(ctx, row, (size_t)dir->order * nc);
    IX_SCRATCH(ctx, x, n * nc);
    IX_SCRATCH(ctx, coef, n * nc);
    IX_TRY(ix__band_new(ctx, (int)(n * nc), (int)((size_t)dir->order * nc),
                        dir->periodic, 1, &b));
    if (c->o->lambda > 0)
        add_smoothing(c, p, dir, basis, row, &b);
    for (int i = 0; i < c->n; i++)
        add_point(c, p, dir, &c->feet[i], basis, row, &b);
    IX_TRY(ix__band_solve(ctx, &b, x));
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < nc; k++)
            coef[k * n + i] = x[i * nc + k];
    return ix_mv_new(ctx, 1, dir, c->nc, false, coef, out);
}

/* Root of the mean square distance of the feet. */
static double rms(const cloud *c)
{
    double s = 0;

    for (int i = 0; i < c->n; i++)
        s += c->feet[i].dist * c->feet[i].dist;
    return sqrt(s / c->n);
}

/* How far an iteration has come. */
typedef struct {
    ix_mv *now, *best; /* references */
    double err, least; /* of now, of best */
    int worse;         /* rounds since the best one */
} progress;

/* Foot points on the present curve, and its error. */
static ix_status assess(ix_ctx *ctx, cloud *c, progress *g, ix_path *p)
{
    IX_TRY(ix__path_new(ctx, g->now, p));
    project_all(c, p);
    g->err = rms(c);
    g->worse++;
    if (g->err < g->least) {
        ix_mv_unref(ctx, g->best);
        g->best = ix_mv_ref(g->now);
        g->least = g->err;
        g->worse = 0;
    }
    return IX_OK;
}

/* One round: a curve for the present foot points, then its own foot points.
 * Squared distances may get worse for a round or two. */
static ix_status next_round(ix_ctx *ctx, cloud *c, progress *g, bool *stop)
{
    ix_dir dir = ix_mv_dir(g->now, 0);
    double before = g->err;
    ix_mv *next;
    ix_path p;

    IX_TRY(ix__path_new(ctx, g->now, &p));
    IX_TRY(improve(ctx, c, &p, &dir, &next));
    ix_mv_unref(ctx, g->now);
    g->now = next;
    IX_TRY(assess(ctx, c, g, &p));
    *stop = g->err <= c->o->err_limit ||
            fabs(before - g->err) <= c->o->change_limit || g->worse >= 4;
    return IX_OK;
}

static ix_status iterate(ix_ctx *ctx, cloud *c, progress *g)
{
    bool stop = false;
    ix_mark mk;
    ix_path p;

    IX_TRY(ix__path_new(ctx, g->now, &p));
    c->probes = 1 + p.nspans * 4 * (p.degree + 1);
    IX_SCRATCH(ctx, c->probe, c->probes * (c->nc + 1));
    IX_SCRATCH(ctx, c->feet, c->n);
    IX_TRY(assess(ctx, c, g, &p));
    mk = ix__scratch_mark(ctx);
    for (int i = 0; i < c->o->max_iter && !stop; i++) {
        IX_TRY(ix__poll(ctx));
        IX_TRY(next_round(ctx, c, g, &stop));
        ix__scratch_release(ctx, mk);
    }
    return IX_OK;
}

ix_status ix_fit_cloud(ix_ctx *ctx, int n, int ncoords, const double *pts,
                       const ix_mv *init, const ix_cloud_opts *o, double *err,
                       ix_mv **out)
{
    cloud c = {.o = o, .n = n, .nc = ncoords, .pts = pts};
    progress g = {.least = HUGE_VAL};
    ix_mark mk;
    ix_status st;

    *out = NULL;
    if (ix_mv_ndirs(init) != 1 || ix_mv_rational(init) ||
        ix_mv_ncoords(init) != ncoords)
        return IX_FAIL(ctx, IX_EARG,
                       "the first curve must be polynomial, with %d "
                       "coordinates as the points",
                       ncoords);
    if (n < 2 || o->max_iter < 1 || !(o->lambda >= 0))
        return IX_FAIL(ctx, IX_EARG, "%d points, %d iterations, lambda %g", n,
                       o->max_iter, o->lambda);
    IX_TRY(ix_mv_to_bspline(ctx, init, &g.now));
    mk = ix__scratch_mark(ctx);
    st = iterate(ctx, &c, &g);
    ix__scratch_release(ctx, mk);
    ix_mv_unref(ctx, g.now);
    if (st == IX_OK && !g.best)
        st = IX_FAIL(ctx, IX_EARG, "points that are not finite");
    if (st != IX_OK) {
        ix_mv_unref(ctx, g.best);
        return st;
    }
    if (err)
        *err = g.least;
    *out = g.best;
    return IX_OK;
}

/* --- the first curve
 * ---------------------------------------------------------- */

/* Mean and the two longest principal axes, scaled to standard deviations. */
static void spread(int n, int nc, const double *pts, double *mean,
                   double (*axis)[IX_MAX_COORDS])
{
    double cov[IX_MAX_COORDS * IX_MAX_COORDS], val[IX_MAX_COORDS];
    double vec[IX_MAX_COORDS * IX_MAX_COORDS];

    for (int k = 0; k < nc; k++) {
        mean[k] = 0;
        for (int i = 0; i < n; i++)
            mean[k] += pts[k * n + i] / n;
    }
    for (int a = 0; a < nc; a++)
        for (int b = 0; b < nc; b++) {
            cov[a * nc + b] = 0;
            for (int i = 0; i < n; i++)
                cov[a * nc + b] += (pts[a * n + i] - mean[a]) *
                                   (pts[b * n + i] - mean[b]) / n;
        }
    ix__eigen_symmetric(nc, cov, val, vec);
    for (int j = 0; j < 2; j++)
        for (int k = 0; k < nc; k++)
            axis[j][k] = j < nc ? sqrt(fmax(0, val[j])) * vec[j * nc + k] : 0;
}

static ix_status start(ix_ctx *ctx, int n, int nc, const double *pts,
                       const ix_interpolate_opts *o, ix_mv **out)
{
    double mean[IX_MAX_COORDS], axis[2][IX_MAX_COORDS], *x;
    int m = 8 * o->size;

    spread(n, nc, pts, mean, axis);
    IX_SCRATCH(ctx, x, m * nc);
    for (int i = 0; i < m; i++) {
        double a = 2 * IX__PI * i / m, u = 2.0 * i / (m - 1) - 1;

        /* an ellipse, or a line, with the points' deviations */
        for (int k = 0; k < nc; k++)
            x[k * m + i] = mean[k] + (o->periodic
                                          ? sqrt(2) * (cos(a) * axis[0][k] +
                                                       sin(a) * axis[1][k])
                                          : sqrt(3) * u * axis[0][k]);
    }
    return ix_interpolate(ctx, m, nc, false, x, o, NULL, out);
}

ix_status ix_fit_cloud_start(ix_ctx *ctx, int n, int ncoords, const double *pts,
                             int length, int order, bool periodic, ix_mv **out)
{
    const ix_interpolate_opts o = {
        .order = order, .size = length, .periodic = periodic};
    ix_mark mk;
    ix_status st;

    *out = NULL;
    if (n < 2 || ncoords < 1 || ncoords > IX_MAX_COORDS || length < order ||
        order < 2 || length > 1 << 20)
        return IX_FAIL(ctx, IX_EARG,
                       "%d points of %d coordinates, length %d, order %d", n,
                       ncoords, length, order);
    mk = ix__scratch_mark(ctx);
    st = start(ctx, n, ncoords, pts, &o, out);
    ix__scratch_release(ctx, mk);
    return st;
}
