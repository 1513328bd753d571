/* recognize.c - kinds of geometry found on a grid of samples.
 *
 * The grid has n[0] x n[1] points, direction 0 fastest; a curve has n[1] = 1.
 * A line of the grid in a direction is an iso-curve; stride and count describe
 * it. */
#include "geom/recognize.h"

#include <float.h>
#include <string.h>

#include "geom/matrix.h"
#include "geom/vec3.h"

/* Samples of one direction at most: more spans get fewer points each. */
#define MAX_SAMPLES 256

typedef struct {
    ix_ctx *ctx;
    const ix_mv *m;
    int n[2];
    double *t[2];   /* parameters */
    double (*p)[3]; /* points */
    double eps;
} grid;

typedef const double (*points)[3];

/* --- sampling ----------------------------------------------------------------
 */

/* Breakpoints inside the domain of a direction, ends included, in scratch. */
static ix_status breakpoints(grid *g, int d, int *n, double **out)
{
    ix_dir dir = ix_mv_dir(g->m, d);
    double dom[2];
    int nk = ix_mv_nknots(g->m, d);

    ix_mv_domain(g->m, d, dom);
    IX_SCRATCH(g->ctx, *out, nk + 2);
    (*out)[0] = dom[0];
    *n = 1;
    for (int i = 0; i < nk; i++)
        if (dir.knots[i] > (*out)[*n - 1] && dir.knots[i] < dom[1])
            (*out)[(*n)++] = dir.knots[i];
    (*out)[(*n)++] = dom[1];
    return IX_OK;
}

/* Chebyshev-Lobatto points of every span. Equations of revolution have degree
 * 4 d in the coordinates of degree d, the highest of all kinds. */
static ix_status sample_direction(grid *g, int d)
{
    int nb, per = 4 * ix_mv_order(g->m, d);
    double *b;

    IX_TRY(breakpoints(g, d, &nb, &b));
    if (per > MAX_SAMPLES / (nb - 1))
        per = MAX_SAMPLES / (nb - 1);
    if (per < 2)
        per = 2;
    IX_SCRATCH(g->ctx, g->t[d], (size_t)(nb - 1) * (size_t)per);
    g->n[d] = 0;
    for (int s = 0; s + 1 < nb; s++)
        for (int i = s > 0; i < per; i++) {
            double u = 0.5 - 0.5 * cos(3.14159265358979323846 * i / (per - 1));

            g->t[d][g->n[d]++] = i == per - 1 ? b[s + 1]
                                              : b[s] + (b[s + 1] - b[s]) * u;
        }
    return IX_OK;
}

static ix_status project(const grid *g, size_t n, const double *w,
                         const double *h)
{
    int nc = ix_mv_ncoords(g->m);

    for (size_t i = 0; i < n; i++) {
        if (w && !(fabs(w[i]) > 0))
            return IX_FAIL(g->ctx, IX_EDOMAIN, "the weight is %g at a sample",
                           w[i]);
        for (int c = 0; c < 3; c++)
            g->p[i][c] = c < nc ? h[(size_t)c * n + i] / (w ? w[i] : 1) : 0;
    }
    return IX_OK;
}

static ix_status sample(grid *g)
{
    int nd = ix_mv_ndirs(g->m), rational = ix_mv_rational(g->m);
    size_t n;
    double *h;

    g->n[1] = 1;
    for (int d = 0; d < nd; d++)
        IX_TRY(sample_direction(g, d));
    n = (size_t)g->n[0] * (size_t)g->n[1];
    IX_SCRATCH(g->ctx, h, n * (size_t)ix_mv_naxes(g->m));
    IX_SCRATCH(g->ctx, g->p, n);
    IX_TRY(ix_mv_eval_grid(g->ctx, g->m, g->n, (const double *const *)g->t, h));
    return project(g, n, rational ? h : NULL, rational ? h + n : h);
}

/* --- fits to a sequence of points
 * ------------------------------------------------ */

/* Every stride-th of n points. */
typedef struct {
    points p;
    int n, stride;
} line;

static const double *at(const line *l, int i)
{
    return l->p[(size_t)i * (size_t)l->stride];
}

/* Distance of x from the line through a along the unit vector u. */
static double off_line(const double x[3], const double a[3], const double u[3])
{
    double d[3], c[3];

    ix__sub3(x, a, d);
    ix__cross3(d, u, c);
    return ix__len3(c);
}

static int farthest_from_point(const line *l, const double a[3], double *dist)
{
    int best = 0;

    *dist = 0;
    for (int i = 0; i < l->n; i++) {
        double d = ix__dist3(at(l, i), a);

        if (d > *dist) {
            *dist = d;
            best = i;
        }
    }
    return best;
}

static int farthest_from_line(const line *l, const double a[3],
                              const double u[3], double *dist)
{
    int best = 0;

    *dist = 0;
    for (int i = 0; i < l->n; i++) {
        double d = off_line(at(l, i), a, u);

        if (d > *dist) {
            *dist = d;
            best = i;
        }
    }
    return best;
}

/* Unit direction from the first point to the farthest; *off is the largest
 * distance from that line, *apart that of the farthest point. */
static int fit_line(const line *l, double u[3], double *off, double *apart)
{
    int far = farthest_from_point(l, at(l, 0), apart);
    double d[3];

    u[0] = u[1] = u[2] = 0;
    ix__sub3(at(l, far), at(l, 0), d);
    ix__unit3(d, u);
    return farthest_from_line(l, at(l, 0), u, off);
}

/* Centre of the circle through three points that are not on one line. */
static void circumcentre(const double a[3], const double b[3],
                         const double c[3], double out[3])
{
    double e[3], f[3], n[3], x[3], y[3], s;

    ix__sub3(b, a, e);
    ix__sub3(c, a, f);
    ix__cross3(e, f, n);
    s = 2 * ix__dot3(n, n);
    ix__cross3(f, n, x);
    ix__cross3(n, e, y);
    for (int i = 0; i < 3; i++)
        out[i] = a[i] + (ix__dot3(e, e) * x[i] + ix__dot3(f, f) * y[i]) / s;
}

/* The circle through three spread points, and whether all are near it. */
static bool fit_circle(const line *l, double eps, ix__geom_fit *out)
{
    double u[3], off, apart, e[3], f[3];
    int q, r = fit_line(l, u, &off, &apart);

    if (!(off > eps))
        return false;
    q = farthest_from_point(l, at(l, 0), &apart);
    circumcentre(at(l, 0), at(l, q), at(l, r), out->point);
    out->radius = ix__dist3(out->point, at(l, 0));
    ix__sub3(at(l, q), at(l, 0), e);
    ix__sub3(at(l, r), at(l, 0), f);
    ix__cross3(e, f, out->dir);
    ix__unit3(out->dir, out->dir);
    for (int i = 0; i < l->n; i++) {
        double d[3], h;

        ix__sub3(at(l, i), out->point, d);
        h = ix__dot3(d, out->dir);
        if (!(fabs(h) <= eps) || !(fabs(ix__len3(d) - out->radius) <= eps))
            return false;
    }
    return true;
}

static line all_points(const grid *g)
{
    return (line){(points)g->p, g->n[0] * g->n[1], 1};
}

/* Line number k of the grid in direction d. */
static line grid_line(const grid *g, int d, int k)
{
    size_t first = d == 0 ? (size_t)k * (size_t)g->n[0] : (size_t)k;

    return (line){(points)(g->p + first), g->n[d], d == 0 ? 1 : g->n[0]};
}

/* --- kinds of curves and surfaces
 * -------------------------------------------------- */

static bool is_const(const grid *g, ix__geom_fit *out)
{
    line l = all_points(g);
    double far;

    memcpy(out->point, at(&l, 0), sizeof out->point);
    (void)farthest_from_point(&l, out->point, &far);
    return far <= g->eps;
}

static bool is_linear(const grid *g, ix__geom_fit *out)
{
    line l = all_points(g);
    double off, apart;

    memcpy(out->point, at(&l, 0), sizeof out->point);
    (void)fit_line(&l, out->dir, &off, &apart);
    return apart > g->eps && off <= g->eps;
}

static bool is_circular(const grid *g, ix__geom_fit *out)
{
    line l = all_points(g);

    return fit_circle(&l, g->eps, out);
}

/* The signed area of a curve's loop, or of a surface's cells, as a vector. */
static void area_vector(const grid *g, double out[3])
{
    points p = (points)g->p;
    int n = g->n[0];

    out[0] = out[1] = out[2] = 0;
    for (int j = 0; j < (g->n[1] > 1 ? g->n[1] - 1 : 1); j++)
        for (int i = 0; i + 1 < n; i++) {
            bool cells = g->n[1] > 1;
            const double *o = cells ? p[j * n + i] : p[0];
            double a[3], b[3], c[3];

            ix__sub3(p[j * n + i + (cells ? 1 : 0)], o, a);
            ix__sub3(p[cells ? (j + 1) * n + i : i + 1], o, b);
            ix__cross3(a, b, c);
            ix__axpy3(out, 1, c, out);
        }
}

/* The plane through the first point, the farthest from it and the farthest
 * from their line; any plane through shapes that are less than plane. */
static bool is_planar(const grid *g, ix__geom_fit *out)
{
    line l = all_points(g);
    double u[3] = {1, 0, 0}, e[3], n[3], area[3], off, apart, side;
    double *pl = out->plane;
    int r = fit_line(&l, u, &off, &apart);

    if (apart == 0)
        u[0] = 1;
    ix__perp3(u, pl);
    ix__sub3(at(&l, r), at(&l, 0), e);
    ix__cross3(u, e, n);
    if (off > DBL_EPSILON * apart)
        ix__unit3(n, pl);
    area_vector(g, area);
    side = ix__dot3(pl, area) < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++)
        pl[i] = side * pl[i] + 0.0; /* no negative zeros */
    pl[3] = 0 - ix__dot3(pl, at(&l, 0));
    for (int i = 0; i < l.n; i++) {
        ix__sub3(at(&l, i), at(&l, 0), e);
        if (!(fabs(ix__dot3(pl, e)) <= g->eps))
            return false;
    }
    return true;
}

/* The sphere through the circle of three points and the point farthest from
 * their plane: its centre is c + h n with equal distances. */
static bool is_spherical(const grid *g, ix__geom_fit *out)
{
    line l = all_points(g);
    double u[3], e[3], f[3], n[3], c[3], off, apart, r2, top = 0, h;
    int q, r = fit_line(&l, u, &off, &apart), s = 0;

    if (!(off > g->eps))
        return false;
    q = farthest_from_point(&l, at(&l, 0), &apart);
    circumcentre(at(&l, 0), at(&l, q), at(&l, r), c);
    ix__sub3(at(&l, q), at(&l, 0), e);
    ix__sub3(at(&l, r), at(&l, 0), f);
    ix__cross3(e, f, n);
    ix__unit3(n, n);
    for (int i = 0; i < l.n; i++) {
        ix__sub3(at(&l, i), c, e);
        if (fabs(ix__dot3(e, n)) > fabs(top)) {
            top = ix__dot3(e, n);
            s = i;
        }
    }
    if (!(fabs(top) > g->eps))
        return false;
    ix__sub3(at(&l, 0), c, e);
    ix__sub3(at(&l, s), c, f);
    r2 = ix__dot3(e, e);
    h = (ix__dot3(f, f) - r2) / (2 * top);
    ix__axpy3(c, h, n, out->point);
    out->radius = sqrt(r2 + h * h);
    for (int i = 0; i < l.n; i++)
        if (!(fabs(ix__dist3(at(&l, i), out->point) - out->radius) <= g->eps))
            return false;
    return true;
}

/* --- kinds of surfaces
 * ---------------------------------------------------------------- */

/* All points of a line at one height along the axis and one distance. */
static bool turns_about(const grid *g, const line *l, const ix__geom_fit *axis)
{
    double d[3], h0 = 0, r0 = 0;

    for (int i = 0; i < l->n; i++) {
        double h, r = off_line(at(l, i), axis->point, axis->dir);

        ix__sub3(at(l, i), axis->point, d);
        h = ix__dot3(d, axis->dir);
        if (i == 0) {
            h0 = h;
            r0 = r;
        }
        if (!(fabs(h - h0) <= g->eps) || !(fabs(r - r0) <= g->eps))
            return false;
    }
    return true;
}

/* Lines in direction d are circles about the axis of the largest of them. */
static bool revolves(const grid *g, int d, ix__geom_fit *out)
{
    double best = 0;

    for (int k = 0; k < g->n[!d]; k++) {
        line l = grid_line(g, d, k);
        ix__geom_fit fit = {0};
        double far;

        if (fit_circle(&l, g->eps, &fit)) {
            if (fit.radius > best) {
                best = fit.radius;
                *out = fit;
            }
            continue;
        }
        (void)farthest_from_point(&l, at(&l, 0), &far);
        if (!(far <= g->eps)) /* no pole either */
            return false;
    }
    for (int k = 0; k < g->n[!d] && best > 0; k++) {
        line l = grid_line(g, d, k);

        if (!turns_about(g, &l, out))
            return false;
    }
    return best > 0;
}

/* In direction d all points move by one vector, along one line. */
static bool extrudes(const grid *g, int d, ix__geom_fit *out)
{
    line first = grid_line(g, d, 0);
    double u[3], off, far;
    int q = farthest_from_point(&first, at(&first, 0), &far);

    (void)fit_line(&first, u, &off, &far);
    if (!(off <= g->eps) || !(far > g->eps))
        return false;
    for (int k = 1; k < g->n[!d]; k++) {
        line l = grid_line(g, d, k);

        for (int i = 0; i < l.n; i++) {
            double a[3], b[3];

            ix__sub3(at(&first, i), at(&first, 0), a);
            ix__sub3(at(&l, i), at(&l, 0), b);
            if (!(ix__dist3(a, b) <= g->eps))
                return false;
        }
    }
    ix__sub3(at(&first, q), at(&first, 0), out->dir);
    return true;
}

static bool is_straight(const grid *g, int d, ix__geom_fit *out)
{
    (void)out;
    for (int k = 0; k < g->n[!d]; k++) {
        line l = grid_line(g, d, k);
        double u[3], off, apart;

        (void)fit_line(&l, u, &off, &apart);
        if (!(off <= g->eps))
            return false;
    }
    return true;
}

/* Lines in direction d are congruent: distances to four of their points do
 * not change from line to line. */
static bool is_rigid(const grid *g, int d, ix__geom_fit *out)
{
    line first = grid_line(g, d, 0);
    int n = first.n;
    const int anchor[4] = {0, n / 3, 2 * n / 3, n - 1};

    (void)out;
    for (int k = 1; k < g->n[!d]; k++) {
        line l = grid_line(g, d, k);

        for (int i = 0; i < 4 * n; i++) {
            int a = anchor[i % 4];
            double want = ix__dist3(at(&first, i / 4), at(&first, a));

            if (!(fabs(ix__dist3(at(&l, i / 4), at(&l, a)) - want) <= g->eps))
                return false;
        }
    }
    return true;
}

/* The first direction for which a test holds, from 1; 0: none. */
static int either(const grid *g,
                  bool (*test)(const grid *, int, ix__geom_fit *),
                  ix__geom_fit *out)
{
    for (int d = 0; d < 2; d++)
        if (g->n[1] > 1 && test(g, d, out))
            return d + 1;
    return 0;
}

/* --- developable surfaces
 * ----------------------------------------------------------------- */

/* Homogeneous (x, y, z, w) of a partial derivative. */
static ix_status partial4(const grid *g, const double t[2], int a, int b,
                          double *v, double out[4])
{
    const int k[2] = {a, b};
    int r = ix_mv_rational(g->m), nc = ix_mv_ncoords(g->m);

    IX_TRY(ix_mv_partial(g->ctx, g->m, t, k, v));
    for (int i = 0; i < 3; i++)
        out[i] = i < nc ? v[i + r] : 0;
    out[3] = r ? v[0] : a + b == 0;
    return IX_OK;
}

/* Gauss curvature by determinants of homogeneous partials: with P = (w S, w)
 * and T_xy = det(P, P_u, P_v, P_xy), the scalar product of S_xy and
 * S_u x S_v is -T_xy / w^4. *area2 = |S_u x S_v|^2. */
static ix_status gauss(const grid *g, const double t[2], double *v, double *k,
                       double *area2)
{
    double m[16], uu[4], uv[4], vv[4], a[3], b[3], c[3], tuu, tuv, tvv, w;

    IX_TRY(partial4(g, t, 0, 0, v, m));
    IX_TRY(partial4(g, t, 1, 0, v, m + 4));
    IX_TRY(partial4(g, t, 0, 1, v, m + 8));
    IX_TRY(partial4(g, t, 2, 0, v, uu));
    IX_TRY(partial4(g, t, 1, 1, v, uv));
    IX_TRY(partial4(g, t, 0, 2, v, vv));
    w = m[3];
    for (int i = 0; i < 3; i++) {
        a[i] = (m[4 + i] - m[7] * m[i] / w) / w;
        b[i] = (m[8 + i] - m[11] * m[i] / w) / w;
    }
    ix__cross3(a, b, c);
    *area2 = ix__dot3(c, c);
    memcpy(m + 12, uu, sizeof uu);
    tuu = ix__mat_det(m);
    memcpy(m + 12, uv, sizeof uv);
    tuv = ix__mat_det(m);
    memcpy(m + 12, vv, sizeof vv);
    tvv = ix__mat_det(m);
    w = w * w * w * w * *area2;
    *k = (tuu / w) * (tvv / w) - (tuv / w) * (tuv / w);
    return IX_OK;
}

/* At the middles of the sample intervals, where no span ends; points at which
 * the surface is singular (the apex of a cone) do not count. */
static ix_status is_developable(const grid *g, ix__geom_fit *out)
{
    line l = all_points(g);
    double diameter, k, area2, *v;

    if (g->n[1] < 2)
        return IX_OK;
    IX_SCRATCH(g->ctx, v, ix_mv_naxes(g->m));
    (void)farthest_from_point(&l, at(&l, 0), &diameter);
    for (int j = 0; j + 1 < g->n[1]; j++)
        for (int i = 0; i + 1 < g->n[0]; i++) {
            const double t[2] = {(g->t[0][i] + g->t[0][i + 1]) / 2,
                                 (g->t[1][j] + g->t[1][j + 1]) / 2};

            IX_TRY(gauss(g, t, v, &k, &area2));
            if (isfinite(k) && !(fabs(k) * diameter * diameter <= g->eps))
                return IX_OK;
        }
    out->flag = either(g, is_straight, out);
    if (!out->flag)
        out->flag = 1;
    return IX_OK;
}

static ix_status recognize(grid *g, ix__geom_kind kind, ix__geom_fit *out)
{
    IX_TRY(sample(g));
    switch (kind) {
    case IX_KIND_CONST:
        out->flag = is_const(g, out);
        break;
    case IX_KIND_LINEAR:
        out->flag = is_linear(g, out);
        break;
    case IX_KIND_CIRCULAR:
        out->flag = is_circular(g, out);
        break;
    case IX_KIND_PLANAR:
        out->flag = is_planar(g, out);
        break;
    case IX_KIND_SPHERICAL:
        out->flag = is_spherical(g, out);
        break;
    case IX_KIND_REVOLUTION:
        out->flag = either(g, revolves, out);
        break;
    case IX_KIND_EXTRUSION:
        out->flag = either(g, extrudes, out);
        break;
    case IX_KIND_RULED:
        out->flag = either(g, is_straight, out);
        break;
    case IX_KIND_DEVELOPABLE:
        return is_developable(g, out);
    case IX_KIND_SWEEP:
        out->flag = either(g, is_rigid, out);
        break;
    default:
        return IX_FAIL(g->ctx, IX_EARG, "%d is no kind of geometry", (int)kind);
    }
    return IX_OK;
}

ix_status ix__recognize(ix_ctx *ctx, const ix_mv *m, ix__geom_kind kind,
                        double eps, ix__geom_fit *out)
{
    grid g = {.ctx = ctx, .m = m, .eps = eps};
    ix_mark mk;
    ix_status st;

    *out = (ix__geom_fit){0};
    if (ix_mv_ndirs(m) > 2)
        return IX_FAIL(ctx, IX_EARG, "%d directions: no curve or surface",
                       ix_mv_ndirs(m));
    if (!(eps > 0) || !isfinite(eps))
        return IX_FAIL(ctx, IX_EARG, "the tolerance %g is not positive", eps);
    mk = ix__scratch_mark(ctx);
    st = recognize(&g, kind, out);
    ix__scratch_release(ctx, mk);
    return st;
}
