/* geo_surface.c - a surface for tracing on it: derivatives through third order,
 * exact from the spline or from the user's function, and the numbers that
 * geodesics need of them. Evaluation allocates nothing. */
#include <math.h>
#include <string.h>

#include "bern/clones.h"
#include "bsp/basis.h"
#include "geom/vec3.h"
#include "iritx/geom.h"
#include "iritx/solve.h"
#include "mv/mv.h"
#include "ops/geo.h"

/* Below this continuity of curve and surface results are cut: pieces of degree
 * 5 would not fit well over it. */
enum { ROUGH = 4 };

/* Exponents of u and v of the derivatives of a jet. */
static const int deriv[IX_GEO_NJET][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0},
                                          {1, 1}, {0, 2}, {3, 0}, {2, 1},
                                          {1, 2}, {0, 3}};
/* The place in a jet of the derivative (i, j). */
static const int place[4][4] = {
    {0, 2, 5, 9}, {1, 4, 8, -1}, {3, 7, -1, -1}, {6, -1, -1, -1}};
static const int njet[4] = {1, 3, 6, 10};

/* --- opening ------------------------------------------------------------- */

static ix_status open_dir(ix_ctx *ctx, const ix_dir *dir, double lo, double len,
                          ix__geo_dir *out)
{
    ix_spans sp;

    out->dir = *dir;
    IX_TRY(ix__spans_of(ctx, dir, &sp));
    out->nspans = sp.nspans;
    out->cont = sp.cont;
    IX_SCRATCH(ctx, out->breaks, sp.nspans + 1);
    IX_SCRATCH(ctx, out->first, sp.nspans);
    IX_SCRATCH(ctx, out->w, 4 * dir->order);
    IX_SCRATCH_ZERO(ctx, out->wt, 4 * dir->order);
    for (int i = 0; i <= sp.nspans; i++)
        out->breaks[i] = (sp.breaks[i] - lo) / len;
    for (int i = 0; i < sp.nspans; i++)
        out->first[i] = ix__basis_first(
            dir, 0.5 * (sp.breaks[i] + sp.breaks[i + 1]));
    return IX_OK;
}

/* Only C1 joins: there the map from the parameters to the plane has an inverse
 * that is C1, too. */
static ix_status is_smooth(ix_ctx *ctx, const ix_mv *m, bool *out)
{
    *out = true;
    for (int d = 0; d < m->ndirs; d++) {
        ix_spans sp;

        IX_TRY(ix__spans_of(ctx, m->dirs + d, &sp));
        for (int i = 0; i < sp.nspans - 1; i++)
            *out = *out && sp.cont[i] >= 1;
    }
    return IX_OK;
}

/* Control points in one plane within rounding of their size. */
static ix_status find_plane(ix_ctx *ctx, const ix_mv *m, double size, bool *out)
{
    double *p, plane[4], dist;
    size_t n = m->npts;
    ix_status st;

    IX_TRY(is_smooth(ctx, m, out));
    if (!*out || m->ncoords == 2)
        return IX_OK;
    *out = false;
    IX_SCRATCH(ctx, p, 3 * n);
    for (size_t i = 0; i < n; i++)
        for (int c = 0; c < 3; c++)
            p[3 * i + (size_t)c] = ix_mv_coord(m, c)[i] /
                                   (m->rational ? m->pts[i] : 1.0);
    st = ix_fit_plane(ctx, (int)n, p, plane, &dist);
    if (st == IX_EDOMAIN)
        return IX_OK;
    IX_TRY(st);
    *out = true;
    for (size_t i = 0; i < n; i++)
        *out = *out && fabs(ix__dot3(plane, p + 3 * i) + plane[3]) <=
                           1e-13 * (size + ix__len3(p + 3 * i));
    return IX_OK;
}

static ix_status open_mv(ix_ctx *ctx, const ix_mv *m, ix__geo_srf *s,
                         ix_mv **keep)
{
    ix_mv *step = NULL, *flat = NULL;
    ix_status st;

    if (m->ndirs != 2 || m->ncoords < 2 || m->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates: a surface with 2 or "
                       "3 coordinates is needed",
                       m->ndirs, m->ncoords);
    if (ix_mv_has_poles(m))
        return IX_FAIL(ctx, IX_EARG,
                       "the surface has weights of both signs "
                       "or zero: poles");
    st = ix__mv_no_power(ctx, m, &step);
    if (st == IX_OK)
        st = ix_mv_to_float(ctx, step, &flat);
    ix_mv_unref(ctx, step);
    IX_TRY(st);
    *keep = flat;
    s->mv = flat;
    return IX_OK;
}

/* The piece; all of a spline unless one is given. */
static ix_status find_domain(ix_ctx *ctx, const ix_geo_surface *in,
                             ix__geo_srf *s)
{
    for (int d = 0; d < 2; d++) {
        double dom[2] = {in->lo[d], in->hi[d]}, all[2];

        if (s->mv)
            ix_mv_domain(s->mv, d, all);
        if (s->mv && dom[0] == dom[1])
            memcpy(dom, all, sizeof dom);
        if (!(dom[1] > dom[0]) || !isfinite(dom[1] - dom[0]))
            return IX_FAIL(ctx, IX_EARG,
                           "[%g, %g] of direction %d is not a domain", dom[0],
                           dom[1], d);
        if (s->mv && !(dom[0] >= all[0] && dom[1] <= all[1]))
            return IX_FAIL(ctx, IX_EARG,
                           "[%g, %g] of direction %d is not inside the "
                           "surface's domain [%g, %g]",
                           dom[0], dom[1], d, all[0], all[1]);
        s->lo[d] = dom[0];
        s->len[d] = dom[1] - dom[0];
    }
    return IX_OK;
}

enum { PROBES = 5 };

/* The largest side of the box of a few points. */
static ix_status find_size(ix_ctx *ctx, ix__geo_srf *s)
{
    double lo[3], hi[3];
    ix__geo_jet j;
    int n = 0;

    s->size = 1;
    for (int i = 0; i < PROBES * PROBES; i++) {
        int row = i / PROBES;
        double u = (double)(i % PROBES) / (PROBES - 1);
        double v = (double)row / (PROBES - 1);

        if (!ix__geo_eval(s, ix__geo_cell_of(s, u, v), u, v, 0, j))
            continue;
        for (int c = 0; c < 3; c++) {
            lo[c] = n ? fmin(lo[c], j[0][c]) : j[0][c];
            hi[c] = n ? fmax(hi[c], j[0][c]) : j[0][c];
        }
        n++;
    }
    s->size = n ? fmax(hi[0] - lo[0], fmax(hi[1] - lo[1], hi[2] - lo[2])) : 0;
    if (!(s->size > 0) || !isfinite(s->size))
        return IX_FAIL(ctx, IX_EARG,
                       "the surface is a point or not finite (size %g)",
                       s->size);
    return IX_OK;
}

ix_status ix__geo_srf_open(ix_ctx *ctx, const ix_geo_surface *in,
                           ix__geo_srf *s, ix_mv **keep)
{
    *s = (ix__geo_srf){.in = *in};
    *keep = NULL;
    if (!in->mv == !in->fn)
        return IX_FAIL(ctx, IX_EARG,
                       "a surface is either a multivariate or a function");
    if (in->mv)
        IX_TRY(open_mv(ctx, in->mv, s, keep));
    IX_TRY(find_domain(ctx, in, s));
    if (s->mv) {
        for (int d = 0; d < 2; d++)
            IX_TRY(
                open_dir(ctx, s->mv->dirs + d, s->lo[d], s->len[d], &s->d[d]));
    }
    IX_TRY(find_size(ctx, s));
    return s->mv ? find_plane(ctx, s->mv, s->size, &s->planar) : IX_OK;
}

static int span_of(const ix__geo_dir *d, double t)
{
    int lo = 0, hi = d->nspans - 1;

    while (lo < hi) {
        int mid = (lo + hi + 1) / 2;

        if (t >= d->breaks[mid])
            lo = mid;
        else
            hi = mid - 1;
    }
    return lo;
}

ix__geo_cell ix__geo_cell_of(const ix__geo_srf *s, double u, double v)
{
    ix__geo_cell c = {{0, 0}};

    if (s->mv) {
        c.at[0] = span_of(&s->d[0], u);
        c.at[1] = span_of(&s->d[1], v);
    }
    return c;
}

/* --- derivatives --------------------------------------------------------- */

/* The weights of the derivatives 0 .. n by the polynomial of a span; those of
 * higher ones are left: finite numbers that are not used. */
static void weights(const ix__geo_dir *d, int span, double t, int n)
{
    int order = d->dir.order;

    ix__basis_derivs(&d->dir, d->first[span], t, n, d->w);
    for (int k = 0; k <= n; k++)
        for (int i = 0; i < order; i++)
            d->wt[4 * i + k] = d->w[k * order + i];
}

/* Sum of w[i] p[i], four derivatives at once. */
IX__INLINE void sum_row(int n, const ix__v4 *w, const double *p, ix__v4 *out)
{
    ix__v4 even = {0}, odd = {0}; /* neither waits for the other */
    int i = 0;

    for (; i + 1 < n; i += 2) {
        even += w[i] * p[i];
        odd += w[i + 1] * p[i + 1];
    }
    if (i < n)
        even += w[i] * p[i];
    *out = even + odd;
}

/* One axis of a window of n[0] x n[1] points, rows len apart: all[i][k] is the
 * derivative i by v, k by u. */
IX__CLONES static void sum_axis(const int n[2], const double *const wt[2],
                                const double *p, size_t len, int order,
                                double (*all)[4])
{
    const ix__v4 *w = ix__cvec(wt[0]);
    const double *wv = wt[1];
    ix__v4 sum[4] = {{0}};

    for (int j = 0; j < n[1]; j++, p += len, wv += 4) {
        ix__v4 row;

        sum_row(n[0], w, p, &row);
        for (int i = 0; i <= order; i++)
            sum[i] += wv[i] * row;
    }
    for (int i = 0; i <= order; i++)
        *ix__vec(all[i]) = sum[i];
}

/* Homogeneous derivatives: h[axis][derivative]. */
static void sum(const ix__geo_srf *s, ix__geo_cell c, int order,
                double (*h)[IX_GEO_NJET])
{
    const ix_mv *m = s->mv;
    const int n[2] = {m->dirs[0].order, m->dirs[1].order};
    const double *const wt[2] = {s->d[0].wt, s->d[1].wt};
    size_t len = (size_t)m->dirs[0].length;
    size_t from = (size_t)s->d[0].first[c.at[0]] +
                  len * (size_t)s->d[1].first[c.at[1]];
    double all[4][4];

    for (int a = 0; a < m->naxes; a++) {
        sum_axis(n, wt, m->pts + (size_t)a * m->npts + from, len, order, all);
        for (int q = 0; q < njet[order]; q++)
            h[a][q] = all[deriv[q][1]][deriv[q][0]];
    }
}

/* x = p / w by Leibniz' rule for p = x w. */
static void divide(int order, int nc, double (*h)[IX_GEO_NJET], ix__geo_jet x)
{
    static const int binom[4][4] = {
        {1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};

    for (int q = 0; q < njet[order]; q++)
        for (int c = 0; c < nc; c++) {
            int i = deriv[q][0], j = deriv[q][1];
            double y = h[c + 1][q];

            for (int a = 0; a <= i; a++)
                for (int b = 0; b <= j; b++)
                    if (a + b > 0)
                        y -= binom[i][a] * binom[j][b] * h[0][place[a][b]] *
                             x[place[i - a][j - b]][c];
            x[q][c] = y / h[0][0];
        }
}

static bool eval_mv(const ix__geo_srf *s, ix__geo_cell c, double u, double v,
                    int order, ix__geo_jet j)
{
    double h[4][IX_GEO_NJET];
    const ix_mv *m = s->mv;

    weights(&s->d[0], c.at[0], u, order);
    weights(&s->d[1], c.at[1], v, order);
    sum(s, c, order, h);
    for (int q = 0; q < njet[order]; q++)
        j[q][2] = 0;
    if (m->rational) {
        divide(order, m->ncoords, h, j);
        return h[0][0] != 0;
    }
    for (int q = 0; q < njet[order]; q++)
        for (int k = 0; k < m->ncoords; k++)
            j[q][k] = h[k][q];
    return true;
}

bool ix__geo_eval(const ix__geo_srf *s, ix__geo_cell c, double u, double v,
                  int order, ix__geo_jet j)
{
    double pu[4] = {1, s->len[0]}, pv[4] = {1, s->len[1]};
    bool ok = u >= -IX_GEO_MARGIN && u <= 1 + IX_GEO_MARGIN &&
              v >= -IX_GEO_MARGIN && v <= 1 + IX_GEO_MARGIN;

    u = s->lo[0] + u * s->len[0];
    v = s->lo[1] + v * s->len[1];
    if (ok)
        ok = s->mv ? eval_mv(s, c, u, v, order, j)
                   : s->in.fn(s->in.ud, u, v, order, j);
    if (!ok)
        return false;
    for (int k = 2; k <= order; k++) {
        pu[k] = pu[k - 1] * pu[1];
        pv[k] = pv[k - 1] * pv[1];
    }
    for (int q = 0; q < njet[order]; q++)
        for (int k = 0; k < 3; k++)
            j[q][k] *= pu[deriv[q][0]] * pv[deriv[q][1]] / s->size;
    return true;
}

/* --- what geodesics need of them ----------------------------------------- */

bool ix__geo_metric_of(ix__geo_jet j, ix__geo_metric *m)
{
    ix__cross3(j[IX_GEO_SU], j[IX_GEO_SV], m->n);
    m->e = ix__dot3(j[IX_GEO_SU], j[IX_GEO_SU]);
    m->f = ix__dot3(j[IX_GEO_SU], j[IX_GEO_SV]);
    m->g = ix__dot3(j[IX_GEO_SV], j[IX_GEO_SV]);
    m->w = sqrt(ix__dot3(m->n, m->n));
    for (int c = 0; c < 3; c++)
        m->n[c] /= m->w;
    /* as ix_srf_normal: half of the digits are left; nor is there a normal
     * where a direction has shrunk to a point */
    return m->w > 1e-10 * sqrt(m->e * m->g) && fmin(m->e, m->g) > 1e-20;
}

/* K = P / Q with n = S_u x S_v: P = (S_uu.n) (S_vv.n) - (S_uv.n)^2, Q =
 * (n.n)^2, and with n_u = S_uu x S_v + S_u x S_uv the derivatives of both. */
void ix__geo_gauss(ix__geo_jet j, bool grad, double k[3])
{
    double n[3], l[3], w;

    ix__cross3(j[IX_GEO_SU], j[IX_GEO_SV], n);
    w = ix__dot3(n, n);
    for (int i = 0; i < 3; i++)
        l[i] = ix__dot3(j[IX_GEO_SUU + i], n);
    k[0] = (l[0] * l[2] - l[1] * l[1]) / (w * w);
    for (int d = 0; grad && d < 2; d++) { /* by u, by v */
        double a[3], b[3], dn[3], dl[3], dw, dp;

        ix__cross3(j[IX_GEO_SUU + d], j[IX_GEO_SV], a);
        ix__cross3(j[IX_GEO_SU], j[IX_GEO_SUV + d], b);
        ix__axpy3(a, 1, b, dn);
        dw = 2 * ix__dot3(n, dn);
        for (int i = 0; i < 3; i++)
            dl[i] = ix__dot3(j[6 + i + d], n) + ix__dot3(j[IX_GEO_SUU + i], dn);
        dp = dl[0] * l[2] + l[0] * dl[2] - 2 * l[1] * dl[1];
        k[1 + d] = (dp - 2 * k[0] * w * dw) / (w * w);
    }
}

void ix__geo_vector(ix__geo_jet j, const double ab[2], double x[3])
{
    for (int c = 0; c < 3; c++)
        x[c] = ab[0] * j[IX_GEO_SU][c] + ab[1] * j[IX_GEO_SV][c];
}

void ix__geo_parts(ix__geo_jet j, const ix__geo_metric *m, const double x[3],
                   double ab[2])
{
    double a = ix__dot3(x, j[IX_GEO_SU]), b = ix__dot3(x, j[IX_GEO_SV]);

    ab[0] = (m->g * a - m->f * b) / (m->w * m->w);
    ab[1] = (m->e * b - m->f * a) / (m->w * m->w);
}

/* --- curves -------------------------------------------------------------- */

/* Inside the domain: control polygons would ask too much. */
static ix_status check_inside(ix_ctx *ctx, const ix__geo_crv *c,
                              const char *what)
{
    enum { PER_SPAN = 8 };

    for (int i = 0; i <= c->d.nspans * PER_SPAN; i++) {
        double x[2], t = (double)i / (c->d.nspans * PER_SPAN);

        t = c->lo + t * c->len;
        IX_TRY(ix_mv_point(ctx, c->mv, &t, x));
        for (int d = 0; d < 2; d++) {
            double r = (x[d] - c->s->lo[d]) / c->s->len[d];

            if (!(r >= -1e-9 && r <= 1 + 1e-9))
                return IX_FAIL(ctx, IX_EARG,
                               "%s leaves the surface's domain: coordinate %d "
                               "is %.12g at parameter %.12g, outside [%.12g, "
                               "%.12g]",
                               what, d, x[d], t, c->s->lo[d],
                               c->s->lo[d] + c->s->len[d]);
        }
    }
    return IX_OK;
}

typedef struct {
    double t;
    int cont;
} cut;

/* Appends to x[*n] the parameters where coordinate d of the curve is at a knot
 * of the surface. */
static ix_status add_crossings(ix_ctx *ctx, const ix__geo_crv *c, int d,
                               int room, cut *x, int *n)
{
    const ix__geo_srf *s = c->s;

    for (int i = 1; s->mv && i < s->d[d].nspans; i++) {
        ix_root_opts o = {.lo = 1, .hi = 0};
        ix_root *roots;
        int found;

        if (!(s->d[d].breaks[i] > 0 && s->d[d].breaks[i] < 1))
            continue;
        o.level = s->lo[d] + s->len[d] * s->d[d].breaks[i];
        IX_TRY(ix_roots(ctx, c->mv, d + c->mv->rational, &o, &roots, &found));
        for (int k = 0; k < found && *n < room; k++)
            if (roots[k].kind != IX_ROOT_INTERVAL)
                x[(*n)++] = (cut){(roots[k].t - c->lo) / c->len,
                                  s->d[d].cont[i - 1]};
        ix_roots_free(ctx, roots, found);
    }
    return IX_OK;
}

static void sort_cuts(int n, cut *x)
{
    for (int i = 1; i < n; i++) {
        cut one = x[i];
        int k = i;

        for (; k > 0 && x[k - 1].t > one.t; k--)
            x[k] = x[k - 1];
        x[k] = one;
    }
}

/* Cuts that are one become one; the ends of the domain are not moved. */
static int join_cuts(int n, cut *x)
{
    int kept = 1;

    for (int i = 1; i < n; i++) {
        bool apart = x[i].t - x[kept - 1].t > 1e-9;

        if (apart && (x[i].t == 1 || 1 - x[i].t > 1e-9))
            x[kept++] = x[i];
        else if (!apart)
            x[kept - 1].cont = x[i].cont < x[kept - 1].cont ? x[i].cont
                                                            : x[kept - 1].cont;
    }
    return kept;
}

static ix_status set_spans(ix_ctx *ctx, ix__geo_crv *c, int n, const cut *x)
{
    int from = 0;

    c->d.nspans = n;
    IX_SCRATCH(ctx, c->d.breaks, n + 1);
    IX_SCRATCH(ctx, c->d.first, n);
    IX_SCRATCH(ctx, c->cell, n);
    IX_SCRATCH(ctx, c->group, n);
    IX_SCRATCH(ctx, c->cont, n + 1);
    c->cont[0] = -1;
    c->d.breaks[0] = x[0].t;
    for (int i = 0; i < n; i++) {
        double mid = c->lo + c->len * 0.5 * (x[i].t + x[i + 1].t), uv[2];

        c->group[i][0] = from;
        c->d.breaks[i + 1] = x[i + 1].t;
        c->d.first[i] = ix__basis_first(&c->d.dir, mid);
        IX_TRY(ix_mv_point(ctx, c->mv, &mid, uv));
        c->cell[i] = ix__geo_cell_of(c->s, (uv[0] - c->s->lo[0]) / c->s->len[0],
                                     (uv[1] - c->s->lo[1]) / c->s->len[1]);
        c->cont[i + 1] = x[i + 1].cont;
        if (x[i + 1].cont >= 2)
            continue;
        for (; from <= i; from++)
            c->group[from][1] = i + 1;
    }
    return IX_OK;
}

/* Spans of the curve cut at the knot lines of the surface. */
static ix_status cut_spans(ix_ctx *ctx, ix__geo_crv *c)
{
    enum { MORE = 4096 };
    int n = c->d.nspans + 1, room = n + MORE;
    cut *x;

    IX_SCRATCH(ctx, x, room);
    for (int i = 0; i < n; i++)
        x[i] = (cut){c->d.breaks[i],
                     i > 0 && i < n - 1 ? c->d.cont[i - 1] : -1};
    for (int d = 0; d < 2; d++)
        IX_TRY(add_crossings(ctx, c, d, room, x, &n));
    sort_cuts(n, x);
    n = join_cuts(n, x);
    return set_spans(ctx, c, n - 1, x);
}

ix_status ix__geo_crv_open(ix_ctx *ctx, const ix__geo_srf *s, const ix_mv *crv,
                           const char *what, ix__geo_crv *out, ix_mv **keep)
{
    ix_mv *step = NULL, *flat = NULL;
    double dom[2];
    ix_status st;

    if (ix_mv_ndirs(crv) != 1 || ix_mv_ncoords(crv) < 2)
        return IX_FAIL(ctx, IX_EARG,
                       "%s: a curve of the surface's parameter plane with 2 "
                       "coordinates is needed, not %d directions and %d "
                       "coordinates",
                       what, ix_mv_ndirs(crv), ix_mv_ncoords(crv));
    if (ix_mv_has_poles(crv))
        return IX_FAIL(ctx, IX_EARG, "%s has poles", what);
    st = ix__mv_no_power(ctx, crv, &step);
    if (st == IX_OK)
        st = ix_mv_to_float(ctx, step, &flat);
    ix_mv_unref(ctx, step);
    step = NULL;
    IX_TRY(ix__mv_step(
        ctx, &flat, &step,
        st == IX_OK ? ix_mv_coerce(ctx, flat, 2, flat->rational, &step) : st));
    *keep = flat;
    ix_mv_domain(flat, 0, dom);
    *out = (ix__geo_crv){
        .mv = flat, .lo = dom[0], .len = dom[1] - dom[0], .s = s};
    IX_TRY(open_dir(ctx, flat->dirs, out->lo, out->len, &out->d));
    out->pieces = out->d.nspans;
    IX_TRY(check_inside(ctx, out, what));
    return cut_spans(ctx, out);
}

int ix__geo_crv_span(const ix__geo_crv *c, double t)
{
    return span_of(&c->d, t);
}

int ix__geo_crv_span_in(const ix__geo_crv *c, double t, double lo, double hi)
{
    int span = ix__geo_crv_span(c, t);

    while (span > 0 && c->d.breaks[span] >= hi)
        span--;
    while (span < c->d.nspans - 1 && c->d.breaks[span + 1] <= lo)
        span++;
    return span;
}

ix_status ix__geo_crv_rough(ix_ctx *ctx, const ix__geo_crv *c, int *n,
                            double **out)
{
    double *t;
    int k = 0;

    IX_SCRATCH(ctx, t, c->d.nspans + 1);
    for (int i = 0; i <= c->d.nspans; i++)
        if (c->cont[i] < ROUGH)
            t[k++] = c->d.breaks[i];
    *out = t;
    *n = k;
    return IX_OK;
}

/* u and v with derivatives through the third: x[k][2], scaled. */
static bool plane_derivs(const ix__geo_crv *c, int span, double t,
                         double x[4][2])
{
    const ix_mv *m = c->mv;
    int order = m->dirs[0].order, r = m->rational ? 1 : 0;
    double h[4][3], power = 1;

    weights(&c->d, span, c->lo + t * c->len, 3);
    for (int k = 0; k < 4; k++, power *= c->len)
        for (int a = 0; a < m->naxes; a++) {
            const double *p = m->pts + (size_t)a * m->npts + c->d.first[span];

            h[k][a] = 0;
            for (int i = 0; i < order; i++)
                h[k][a] += c->d.w[k * order + i] * p[i] * power;
        }
    for (int k = 0; k < 4; k++)
        for (int d = 0; d < 2; d++) {
            double y = h[k][d + r], binom = 1;

            for (int i = 1; r && i <= k; i++) {
                binom = binom * (k - i + 1) / i;
                y -= binom * h[i][0] * x[k - i][d];
            }
            x[k][d] = r ? y / h[0][0] : y;
        }
    for (int k = 0; k < 4; k++)
        for (int d = 0; d < 2; d++)
            x[k][d] = (x[k][d] - (k ? 0 : c->s->lo[d])) / c->s->len[d];
    return true;
}

/* C', C'', C''' by the chain rule. */
static void space_derivs(ix__geo_jet j, double x[4][2], bool third,
                         double d[3][3])
{
    const double u1 = x[1][0], v1 = x[1][1], u2 = x[2][0], v2 = x[2][1];

    for (int c = 0; c < 3; c++) {
        d[0][c] = j[1][c] * u1 + j[2][c] * v1;
        d[1][c] = j[3][c] * u1 * u1 + 2 * j[4][c] * u1 * v1 +
                  j[5][c] * v1 * v1 + j[1][c] * u2 + j[2][c] * v2;
        if (third)
            d[2][c] = j[6][c] * u1 * u1 * u1 + 3 * j[7][c] * u1 * u1 * v1 +
                      3 * j[8][c] * u1 * v1 * v1 + j[9][c] * v1 * v1 * v1 +
                      3 * (j[3][c] * u1 * u2 + j[4][c] * (u1 * v2 + v1 * u2) +
                           j[5][c] * v1 * v2) +
                      j[1][c] * x[3][0] + j[2][c] * x[3][1];
    }
}

/* det(n, a, b). */
static double det3(const double n[3], const double a[3], const double b[3])
{
    double x[3];

    ix__cross3(a, b, x);
    return ix__dot3(n, x);
}

/* kg = A / (|n| len^3), A = det(n, C', C''), n = S_u x S_v, and its derivative
 * with A' = det(n', C', C'') + det(n, C', C'''). */
static void curvature(ix__geo_jet j, double x[4][2], double d[3][3], bool third,
                      ix__geo_place *p)
{
    double n[3], dn[3] = {0}, w, a, da, dw;

    ix__cross3(j[IX_GEO_SU], j[IX_GEO_SV], n);
    w = sqrt(ix__dot3(n, n));
    a = det3(n, d[0], d[1]);
    p->kg = a / (w * p->len * p->len * p->len);
    p->dlen = ix__dot3(d[0], d[1]) / p->len;
    p->dkg = 0;
    if (!third)
        return;
    for (int i = 0; i < 2; i++) { /* n' = n_u u' + n_v v' */
        double y[3];

        ix__cross3(j[IX_GEO_SUU + i], j[IX_GEO_SV], y);
        ix__axpy3(dn, x[1][i], y, dn);
        ix__cross3(j[IX_GEO_SU], j[IX_GEO_SUV + i], y);
        ix__axpy3(dn, x[1][i], y, dn);
    }
    da = det3(dn, d[0], d[1]) + det3(n, d[0], d[2]);
    dw = ix__dot3(n, dn) / w;
    p->dkg = da / (w * p->len * p->len * p->len) -
             p->kg * (dw / w + 3 * p->dlen / p->len);
}

bool ix__geo_place_at(const ix__geo_crv *c, int span, double t, bool third,
                      ix__geo_place *p)
{
    double x[4][2], d[3][3];
    ix__geo_metric m;
    ix__geo_jet j;

    (void)plane_derivs(c, span, t, x);
    memcpy(p->uv, x[0], sizeof p->uv);
    memcpy(p->duv, x[1], sizeof p->duv);
    p->cell = c->cell[span];
    if (!ix__geo_eval(c->s, p->cell, x[0][0], x[0][1], third ? 3 : 2, j) ||
        !ix__geo_metric_of(j, &m))
        return false;
    space_derivs(j, x, third, d);
    memcpy(p->pos, j[0], sizeof p->pos);
    memcpy(p->normal, m.n, sizeof p->normal);
    p->len = ix__unit3(d[0], p->tangent);
    if (!(p->len > 1e-12) || !isfinite(p->len))
        return false;
    ix__cross3(m.n, p->tangent, p->side);
    ix__geo_parts(j, &m, p->side, p->side_ab);
    curvature(j, x, d, third, p);
    return true;
}
