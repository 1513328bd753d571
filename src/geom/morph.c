/* morph.c - sequences of curves from one curve to another.
 *
 * By edges: each edge of the control polygon turns and grows from its form in
 * the first curve to that in the second, so that shapes do not shrink on the
 * way as under convex blending (Sederberg, Gao, Wang, Mu 1993). By
 * resolution: details of the curves' multiresolution decompositions are
 * exchanged one after the other, coarse ones first. */
#include <math.h>
#include <string.h>

#include "geom/angle.h"
#include "geom/crvs.h"
#include "geom/parts.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"

/* One of the two polygons: edges and sizes. */
typedef struct {
    int n, nedges;
    bool closed;
    double (*pt)[3];
    double center[3], length, diagonal;
} polygon;

typedef struct {
    const ix_mv *crv[2];
    ix_morph_how how;
    polygon p[2];
    double (*turn)[3]; /* rotation vector of each edge */
    double (*q)[3];    /* [n] points of the curve in the making */
} morph;

static void measure(int n, int nedges, double (*pt)[3], polygon *p)
{
    double lo[3], hi[3], d[3];

    p->n = n;
    p->nedges = nedges;
    p->pt = pt;
    p->length = 0;
    memcpy(lo, pt[0], sizeof lo);
    memcpy(hi, pt[0], sizeof hi);
    memset(p->center, 0, sizeof p->center);
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++) {
            lo[k] = fmin(lo[k], pt[i][k]);
            hi[k] = fmax(hi[k], pt[i][k]);
            p->center[k] += pt[i][k] / n;
        }
    for (int i = 0; i < nedges; i++)
        p->length += ix__dist3(pt[i], pt[(i + 1) % n]);
    ix__sub3(hi, lo, d);
    p->diagonal = ix__len3(d);
    /* 1e-9 of the size: drawn as closed */
    p->closed = nedges == n ||
                ix__dist3(pt[0], pt[n - 1]) <= 1e-9 * p->diagonal;
}

static ix_status load(ix_ctx *ctx, const ix_mv *m, polygon *p)
{
    int n = (int)m->npts;
    double(*pt)[3];

    IX_SCRATCH_ZERO(ctx, pt, n);
    for (int i = 0; i < n; i++)
        for (int c = 0; c < m->ncoords; c++) {
            double w = m->rational ? m->pts[i] : 1;

            pt[i][c] = ix_mv_coord(m, c)[i] / w;
            if (!isfinite(pt[i][c]))
                return IX_FAIL(ctx, IX_EDOMAIN, "control point %d has weight 0",
                               i);
        }
    measure(n, m->dirs[0].periodic ? n : n - 1, pt, p);
    return IX_OK;
}

static void edge(const polygon *p, int i, double out[3])
{
    ix__sub3(p->pt[(i + 1) % p->n], p->pt[i], out);
}

/* The least rotation vector from u to v; half turns about +z, or about a
 * perpendicular of u. */
static void turn_between(const double u[3], const double v[3], double out[3])
{
    double a[3] = {0}, b[3] = {0}, x[3], z[3] = {0, 0, 1}, s, c;

    memset(out, 0, 3 * sizeof *out);
    if (!(ix__unit3(u, a) > 0) || !(ix__unit3(v, b) > 0))
        return;
    ix__cross3(a, b, x);
    s = ix__len3(x);
    c = ix__dot3(a, b);
    if (s < 1e-12) { /* parallel: rounding has no say in the axis */
        ix__axpy3(z, -ix__dot3(z, a), a, x);
        if (ix__len3(x) < 0.5)
            ix__perp3(a, x);
    }
    ix__unit3(x, x);
    for (int k = 0; k < 3; k++)
        out[k] = x[k] * (s < 1e-12 ? (c > 0 ? 0 : IX__PI) : atan2(s, c));
}

/* Turns the other way round where that continues the edge before. */
static void follow(const double before[3], double turn[3])
{
    double angle = ix__len3(turn), other[3];

    if (!(angle > 0))
        return;
    for (int k = 0; k < 3; k++)
        other[k] = turn[k] * (angle - 2 * IX__PI) / angle;
    if (ix__dist3(other, before) < ix__dist3(turn, before))
        memcpy(turn, other, sizeof other);
}

static ix_status prepare(ix_ctx *ctx, morph *m)
{
    for (int i = 0; i < 2; i++)
        IX_TRY(load(ctx, m->crv[i], &m->p[i]));
    IX_SCRATCH(ctx, m->turn, m->p[0].nedges + 1);
    IX_SCRATCH(ctx, m->q, m->p[0].n + 1);
    for (int i = 0; i < m->p[0].nedges; i++) {
        double u[3], v[3];

        edge(&m->p[0], i, u);
        edge(&m->p[1], i, v);
        turn_between(u, v, m->turn[i]);
        if (i && m->how.follow)
            follow(m->turn[i - 1], m->turn[i]);
    }
    return IX_OK;
}

/* v turned by f times the rotation vector (Rodrigues). */
static void rotate(const double turn[3], double f, double v[3])
{
    double a[3] = {0}, x[3], angle = f * ix__len3(turn), c = cos(angle),
           s = sin(angle), along;

    if (!(ix__unit3(turn, a) > 0))
        return;
    ix__cross3(a, v, x);
    along = ix__dot3(a, v) * (1 - c);
    for (int k = 0; k < 3; k++)
        v[k] = c * v[k] + s * x[k] + along * a[k];
}

/* The edges at blend b, laid end to end; closed curves are closed again. */
static void lay(morph *m, double b)
{
    const polygon *p = m->p;
    int n = p[0].n, ne = p[0].nedges;
    double gap[3];

    memset(m->q[0], 0, sizeof m->q[0]);
    for (int i = 0; i < ne; i++) {
        double u[3], v[3], lu, lv, e[3] = {0, 0, 0};

        edge(&p[0], i, u);
        edge(&p[1], i, v);
        lu = ix__len3(u);
        lv = ix__len3(v);
        if (lu > 0) {
            rotate(m->turn[i], b, u);
            ix__axpy3(e, ((1 - b) * lu + b * lv) / lu, u, e);
        } else {
            ix__axpy3(e, b, v, e);
        }
        for (int k = 0; k < 3; k++)
            m->q[i + 1][k] = m->q[i][k] + e[k];
    }
    if (!p[0].closed || !p[1].closed)
        return;
    memcpy(gap, m->q[ne], sizeof gap);
    for (int i = 1; i < n; i++)
        ix__axpy3(m->q[i], -(double)i / ne, gap, m->q[i]);
}

/* The curve at blend b: scaled to the blended size, centred. */
static ix_status by_edges(ix_ctx *ctx, morph *m, double b, ix_mv **out)
{
    const polygon *p = m->p;
    polygon now;
    double want, have, f;
    ix_mv *r;

    lay(m, b);
    measure(p[0].n, p[0].nedges, m->q, &now);
    want = m->how.by_length ? (1 - b) * p[0].length + b * p[1].length
                            : (1 - b) * p[0].diagonal + b * p[1].diagonal;
    have = m->how.by_length ? now.length : now.diagonal;
    f = have > 0 ? want / have : 1;
    IX_TRY(ix_mv_morph(ctx, m->crv[0], m->crv[1], b, &r));
    for (size_t i = 0; i < r->npts; i++)
        for (int c = 0; c < r->ncoords; c++) {
            double w = r->rational ? r->pts[i] : 1;
            double x = (1 - b) * p[0].center[c] + b * p[1].center[c] +
                       f * (m->q[i][c] - now.center[c]);

            r->pts[(size_t)(c + (r->rational ? 1 : 0)) * r->npts + i] = w * x;
        }
    *out = r;
    return IX_OK;
}

/* --- by resolution
 * ------------------------------------------------------------
 */

/* m's control values in the space of full, whose knots contain m's. */
static ix_status refined(ix_ctx *ctx, const ix_mv *m, const ix_mv *full,
                         ix_mv **out)
{
    const ix_dir *d = &full->dirs[0], *e = &m->dirs[0];
    double *add;
    int n = 0, j = e->order;

    IX_SCRATCH(ctx, add, d->length);
    for (int i = d->order; i < d->length; i++)
        if (j < e->length && e->knots[j] == d->knots[i])
            j++;
        else
            add[n++] = d->knots[i];
    return ix_mv_insert_knots(ctx, m, 0, n, add, out);
}

/* How far level l of n has come at blend b: each takes its turn, half
 * overlapping with the next. */
static double progress(int l, int n, double b)
{
    return fmin(1, fmax(0, b * (1 + (n - 1) / 2.0) - l / 2.0));
}

static ix_status by_levels(ix_ctx *ctx, const ix_crvs lev[2], double b,
                           ix_mv **out)
{
    const ix_mv *full = lev[0].crv[lev[0].n - 1];
    ix_mv *sum, *fine = NULL;

    IX_TRY(ix__mv_alloc(ctx, 1, full->dirs, full->ncoords, false, &sum));
    memset(sum->pts, 0, sum->npts * (size_t)sum->naxes * sizeof *sum->pts);
    for (int s = 0; s < 2; s++)
        for (int l = 0; l < lev[s].n; l++) {
            double x = progress(l, lev[s].n, b), f = s ? x : 1 - x;
            ix_status st = refined(ctx, lev[s].crv[l], full, &fine);

            if (st != IX_OK) {
                ix_mv_unref(ctx, sum);
                return st;
            }
            for (size_t i = 0; i < sum->npts * (size_t)sum->naxes; i++)
                sum->pts[i] += f * fine->pts[i];
            ix_mv_unref(ctx, fine);
        }
    *out = sum;
    return IX_OK;
}

/* --- the sequence
 * ------------------------------------------------------------- */

static ix_status fill(ix_ctx *ctx, morph *m, const ix_crvs *lev, ix_crvs *out)
{
    double step = 1.0 / (out->n - 1);

    if (!m->how.levels)
        IX_TRY(prepare(ctx, m));
    for (int i = 0; i < out->n; i++) {
        double b = i == out->n - 1 ? 1 : i * step;

        IX_TRY(ix__poll(ctx));
        out->t[2 * i] = out->t[2 * i + 1] = b;
        if (m->how.levels)
            IX_TRY(by_levels(ctx, lev, b, &out->crv[i]));
        else
            IX_TRY(by_edges(ctx, m, b, &out->crv[i]));
    }
    return IX_OK;
}

static ix_status sequence(ix_ctx *ctx, morph *m, int n, ix_crvs *out)
{
    ix_crvs lev[2] = {{0}, {0}};
    const ix_multires how = {.keep_jumps = true};
    ix_mv *probe = NULL;
    ix_status st;

    IX_TRY(ix_mv_morph(ctx, m->crv[0], m->crv[1], 0, &probe)); /* fits? */
    ix_mv_unref(ctx, probe);
    if (!m->how.levels && m->crv[0]->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG, "%d coordinates: at most 3",
                       m->crv[0]->ncoords);
    st = ix__crvs_new(ctx, n, out);
    for (int i = 0; st == IX_OK && m->how.levels && i < 2; i++)
        st = ix_multires_split(ctx, m->crv[i], how, &lev[i]);
    if (st == IX_OK)
        st = fill(ctx, m, lev, out);
    ix_crvs_free(ctx, &lev[0]);
    ix_crvs_free(ctx, &lev[1]);
    return st;
}

ix_status ix_morph(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                   ix_morph_how how, double step, ix_crvs *out)
{
    morph m = {.crv = {c1, c2}, .how = how};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    *out = (ix_crvs){0};
    if (c1->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG, "not a curve: %d directions", c1->ndirs);
    if (!(step >= 1e-4 && step <= 1))
        return IX_FAIL(ctx, IX_EARG, "step %g is not within 1e-4 .. 1", step);
    /* 1e-9: 1 / 0.1 is 10 steps */
    st = sequence(ctx, &m, 1 + (int)ceil(1 / step - 1e-9), out);
    if (st != IX_OK)
        ix_crvs_free(ctx, out);
    ix__scratch_release(ctx, mk);
    return st;
}
