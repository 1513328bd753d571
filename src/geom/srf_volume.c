/* srf_volume.c - volumes between a surface and the XY plane or the origin, and
 * their moments. By the divergence theorem both are integrals over the
 * surface; Gauss-Legendre on each knot span is exact for polynomials. */
#include <math.h>
#include <string.h>

#include "bsp/knots.h"
#include "geom/gauss.h"
#include "geom/normals.h"
#include "geom/parts.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"
#include "iritx/sym.h"

static ix_status check(ix_ctx *ctx, const ix_mv *s, const ix_volume *v)
{
    IX_TRY(ix__check_space_surface(ctx, s));
    for (int k = 0; k < 3; k++)
        if (v->power[k] < 0 || v->power[k] > 2)
            return IX_FAIL(ctx, IX_EARG, "power %d of a coordinate",
                           v->power[k]);
    return IX_OK;
}

/* --- by quadrature ----------------------------------------------------- */

/* S, S_u, S_v at t, projected. */
static ix_status frame_at(ix_ctx *ctx, const ix_mv *s, const double t[2],
                          double f[3][3])
{
    IX_TRY(ix_mv_point(ctx, s, t, f[0]));
    IX_TRY(ix_srf_tangent(ctx, s, 0, t[0], t[1], f[1]));
    return ix_srf_tangent(ctx, s, 1, t[0], t[1], f[2]);
}

/* The integrand at a point with these derivatives. */
static double density(const ix_volume *v, double f[3][3])
{
    const double *p = f[0];
    double n[3], g;

    ix__cross3(f[1], f[2], n);
    if (v->origin)
        return ix__dot3(p, n) / 3;
    g = p[2] / (v->power[2] + 1) * n[2];
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < v->power[k]; i++)
            g *= p[k];
    return g;
}

/* The spans of a direction: breaks[*n + 1] in scratch. */
static ix_status spans(ix_ctx *ctx, const ix_mv *s, int d, int *n,
                       double **breaks)
{
    const ix_dir *dir = &s->dirs[d];
    double dom[2];

    ix_mv_domain(s, d, dom);
    IX_SCRATCH(ctx, *breaks, ix_knots_count(dir) + 2);
    (*breaks)[0] = dom[0];
    *n = 0;
    for (int i = 0; i < ix_knots_count(dir); i++)
        if (dir->knots[i] > (*breaks)[*n] && dir->knots[i] < dom[1])
            (*breaks)[++*n] = dir->knots[i];
    (*breaks)[++*n] = dom[1];
    return IX_OK;
}

typedef struct {
    const ix_mv *s;
    const ix_volume *v;
    int nspans[2];
    double *breaks[2];
} domain;

/* With m nodes in each span of each direction. */
static ix_status quadrature(ix_ctx *ctx, const domain *d, int m, double *sum)
{
    double *x, *w, t[2], f[3][3];
    int n[2] = {d->nspans[0] * m, d->nspans[1] * m};

    IX_SCRATCH(ctx, x, m);
    IX_SCRATCH(ctx, w, m);
    ix__gauss(m, x, w);
    *sum = 0;
    for (int j = 0; j < n[1]; j++)
        for (int i = 0; i < n[0]; i++) {
            int at[2] = {i, j};
            double weight = 1;

            for (int k = 0; k < 2; k++) {
                const double *b = d->breaks[k] + at[k] / m;

                t[k] = b[0] + (b[1] - b[0]) * x[at[k] % m];
                weight *= (b[1] - b[0]) * w[at[k] % m];
            }
            IX_TRY(frame_at(ctx, d->s, t, f));
            *sum += weight * density(d->v, f);
        }
    return ix__poll(ctx);
}

/* Nodes that are exact for polynomials: the integrand has at most degree
 * q d - 1, q - 2 being the highest power of coordinates in it. */
static int exact_nodes(const ix_mv *s, const ix_volume *v)
{
    int q = 3 + v->power[0] + v->power[1] + v->power[2], d = 1;

    for (int k = 0; k < 2; k++)
        if (s->dirs[k].order - 1 > d)
            d = s->dirs[k].order - 1;
    return (q * d + 1) / 2;
}

/* Rational integrands converge geometrically; the number of nodes is raised
 * until two results agree within 1e-13 of the larger. */
static ix_status converge(ix_ctx *ctx, const domain *d, int m, double *out)
{
    double before;

    IX_TRY(quadrature(ctx, d, m, &before));
    for (m += 8; m <= 200; m += m / 2) {
        IX_TRY(quadrature(ctx, d, m, out));
        if (fabs(*out - before) <= 1e-13 * fmax(fabs(*out), fabs(before)))
            return IX_OK;
        before = *out;
    }
    return IX_FAIL(ctx, IX_EUNABLE,
                   "the integral of the rational surface did not settle: about "
                   "%.10g",
                   *out);
}

static ix_status value(ix_ctx *ctx, const ix_mv *s, const ix_volume *v,
                       double *out)
{
    domain d = {.s = s, .v = v};

    for (int k = 0; k < 2; k++)
        IX_TRY(spans(ctx, s, k, &d.nspans[k], &d.breaks[k]));
    if (s->rational)
        return converge(ctx, &d, exact_nodes(s, v), out);
    return quadrature(ctx, &d, exact_nodes(s, v), out);
}

ix_status ix_srf_volume(ix_ctx *ctx, const ix_mv *srf, const ix_volume *what,
                        double *out)
{
    *out = 0;
    IX_TRY(check(ctx, srf, what));
    IX_RETURN_SCOPED(ctx, value(ctx, srf, what, out));
}

/* --- as a surface ------------------------------------------------------ */

enum { TEMPS = 20 };

/* What is made on the way, in order. */
typedef struct {
    int n;
    ix_mv *m[TEMPS];
} steps;

static ix_mv **next(steps *s)
{
    return &s->m[s->n++];
}

static const ix_mv *last(const steps *s)
{
    return s->m[s->n - 1];
}

/* x^i y^j z^(k+1) / (k + 1) as the last step. */
static ix_status weight(ix_ctx *ctx, const ix_mv *s, const ix_volume *v,
                        steps *t)
{
    const double f = 1.0 / (v->power[2] + 1);
    const double scale[16] = {f, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const ix_mv *x[3], *prod;

    for (int k = 0; k < 3; k++) {
        IX_TRY(ix_mv_scalar(ctx, s, k, next(t)));
        x[k] = last(t);
    }
    IX_TRY(ix_mv_transform(ctx, x[2], scale, next(t)));
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < v->power[k]; i++) {
            prod = last(t);
            IX_TRY(ix_sym_mul(ctx, prod, x[k], NULL, next(t)));
        }
    return IX_OK;
}

/* S.N / 3 as the last step. */
static ix_status cone_density(ix_ctx *ctx, const ix_mv *s, const ix_mv *normal,
                              steps *t)
{
    const double third[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 3};

    IX_TRY(ix_mv_transform(ctx, normal, third, next(t)));
    normal = last(t);
    return ix_sym_dot(ctx, s, normal, NULL, next(t));
}

/* The density as the last step. */
static ix_status density_field(ix_ctx *ctx, const ix_mv *s, const ix_volume *v,
                               steps *t)
{
    const ix_mv *d[2], *n;

    for (int k = 0; k < 2; k++) {
        IX_TRY(ix_sym_derive(ctx, s, k, NULL, next(t)));
        d[k] = last(t);
    }
    IX_TRY(ix_sym_cross(ctx, d[0], d[1], NULL, next(t)));
    n = last(t);
    if (v->origin)
        return cone_density(ctx, s, n, t);
    IX_TRY(ix_mv_scalar(ctx, n, 2, next(t)));
    n = last(t);
    IX_TRY(weight(ctx, s, v, t));
    d[0] = last(t);
    return ix_sym_mul(ctx, n, d[0], NULL, next(t));
}

static ix_status field(ix_ctx *ctx, const ix_mv *s, const ix_volume *v,
                       steps *t, ix_mv **out)
{
    const ix_mv *f;

    IX_TRY(ix__mv_plain(ctx, s, next(t)));
    IX_TRY(density_field(ctx, t->m[0], v, t));
    f = last(t);
    IX_TRY(ix_sym_integrate(ctx, f, 0, next(t)));
    return ix_sym_integrate(ctx, last(t), 1, out);
}

ix_status ix_srf_volume_field(ix_ctx *ctx, const ix_mv *srf,
                              const ix_volume *what, ix_mv **out)
{
    steps t = {.n = 0};
    ix_status st;

    *out = NULL;
    IX_TRY(check(ctx, srf, what));
    if (srf->rational)
        return IX_FAIL(ctx, IX_EARG,
                       "the integral of a rational surface is "
                       "not rational: only its value is known");
    st = field(ctx, srf, what, &t, out);
    ix__mv_unref_all(ctx, t.m, t.n);
    return st;
}
