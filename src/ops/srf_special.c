/* srf_special.c - parabolic curves and umbilics of a surface, and the principal
 * and asymptotic directions at a point. */
#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "ops/surface.h"

/* --- parabolic curves --------------------------------------------------------
 */

static ix_status gauss_zeros(ix_ctx *ctx, const ix_mv *k, double tol,
                             ix_solution_curves *out)
{
    ix_equation eq = {.f = k, .axis = 0, .rel = IX_EQUAL_ZERO};
    ix_curves_opts o = {.tol = tol};

    if (ix__bern_largest(k->npts, k->pts) == 0.0)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the Gauss curvature is zero everywhere: every point is "
                       "parabolic");
    return ix_solve_curves(ctx, 1, &eq, &o, out);
}

ix_status ix_srf_parabolic(ix_ctx *ctx, const ix_mv *s, double tol,
                           ix_solution_curves *out)
{
    ix_mv *k;
    ix_status st;

    *out = (ix_solution_curves){.unknowns = 2};
    IX_TRY(ix_srf_gauss(ctx, s, true, NULL, NULL, &k));
    st = gauss_zeros(ctx, k, tol, out);
    ix_mv_unref(ctx, k);
    return st;
}

/* --- umbilics
 * ------------------------------------------------------------------ */

/* b_11 g_1j - b_1j g_11 (or with 22): zero where the forms are proportional. */
static ix_status mismatch(ix_ctx *ctx, const ix_surface *s, int i, int j,
                          ix_mv **out)
{
    const ix_form *const b[2] = {&s->b[i], &s->b[j]};
    const ix_form *const g[2] = {&s->g[i], &s->g[j]};
    double size, terms = 0.0;
    ix_form f;
    ix__field x = {NULL, &f, 0, NULL};

    IX_TRY(ix__form_bracket(ctx, b, g, &f));
    IX_TRY(ix__form_bound(ctx, &f, &size));
    for (int k = 0; k < 2; k++) {
        double p, q;

        IX_TRY(ix__form_bound(ctx, b[k], &p));
        IX_TRY(ix__form_bound(ctx, g[1 - k], &q));
        terms += p * q;
    }
    if (!(size > s->band * terms)) /* zero within its error */
        memset(f.c, 0, f.n * sizeof *f.c);
    return ix__field_store(ctx, &x, NULL, out);
}

static ix_status equations(ix_ctx *ctx, const ix_mv *m, ix_mv *f[2])
{
    ix_surface s;

    IX_TRY(ix__surface_load(ctx, m, &s));
    IX_TRY(ix__surface_forms(ctx, &s));
    IX_TRY(mismatch(ctx, &s, 0, 1, &f[0]));
    return mismatch(ctx, &s, 0, 2, &f[1]);
}

/* Solutions at which the surface has no normal are none. */
static ix_status drop_singular(ix_ctx *ctx, const ix_mv *s, ix_solutions *sol)
{
    int n = 0;

    for (int i = 0; i < sol->n; i++) {
        ix_srf_jet j;
        ix_status st = ix__srf_jet(ctx, s, sol->sol[i].x[0], sol->sol[i].x[1],
                                   &j);

        if (st == IX_OK)
            sol->sol[n++] = sol->sol[i];
        else if (st != IX_EDOMAIN)
            return st;
    }
    sol->n = n;
    return IX_OK;
}

static ix_status solve(ix_ctx *ctx, const ix_mv *s, ix_mv *const f[2],
                       const ix_solve_opts *o, ix_solutions *out)
{
    ix_equation eq[2] = {{.f = f[0]}, {.f = f[1]}};
    ix_status st;

    if (ix__bern_largest(f[0]->npts, f[0]->pts) == 0.0 &&
        ix__bern_largest(f[1]->npts, f[1]->pts) == 0.0)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "every point is an umbilic: a plane or a sphere");
    IX_TRY(ix_solve(ctx, 2, eq, o, out));
    st = drop_singular(ctx, s, out);
    if (st != IX_OK)
        ix_solutions_free(ctx, out);
    return st;
}

ix_status ix_srf_umbilics(ix_ctx *ctx, const ix_mv *s, const ix_solve_opts *o,
                          ix_solutions *out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_mv *f[2] = {NULL, NULL};
    ix_status st;

    *out = (ix_solutions){.unknowns = 2};
    st = equations(ctx, s, f);
    ix__scratch_release(ctx, mk);
    if (st == IX_OK)
        st = solve(ctx, s, f, o, out);
    ix_mv_unref(ctx, f[0]);
    ix_mv_unref(ctx, f[1]);
    return st;
}

/* --- directions at a point
 * --------------------------------------------------------- */

/* The second form in the orthonormal basis e1 = S_u / |S_u|, e2 = the rest of
 * S_v: l = (11, 12, 22); column i of back holds e_i's parts of S_u and S_v. */
static void orthonormal(const ix_srf_jet *j, double l[3], double back[2][2])
{
    double e = sqrt(j->g[0]), f = j->g[1] / e;
    double r = sqrt(j->g[2] - f * f); /* S_v = f e1 + r e2 */

    back[0][0] = 1.0 / e;
    back[0][1] = 0.0;
    back[1][0] = -f / (e * r);
    back[1][1] = 1.0 / r;
    l[0] = j->b[0] / j->g[0];
    l[1] = (j->b[1] - f * e * l[0]) / (e * r);
    l[2] = (j->b[2] - f * f * l[0] - 2.0 * f * r * l[1]) / (r * r);
}

/* Direction c e1 + s e2. */
static void set_direction(const ix_srf_jet *j, double back[2][2], double c,
                          double s, int i, ix_principal *o)
{
    for (int k = 0; k < 2; k++)
        o->ab[i][k] = c * back[0][k] + s * back[1][k];
    for (int k = 0; k < 3; k++)
        o->dir[i][k] = o->ab[i][0] * j->su[k] + o->ab[i][1] * j->sv[k];
}

ix_status ix_srf_principal(ix_ctx *ctx, const ix_mv *s, double u, double v,
                           ix_principal *out)
{
    double l[3], back[2][2], mean, half, radius, angle;
    ix_srf_jet j;

    IX_TRY(ix__srf_jet(ctx, s, u, v, &j));
    orthonormal(&j, l, back);
    mean = 0.5 * (l[0] + l[2]);
    half = 0.5 * (l[0] - l[2]);
    radius = hypot(half, l[1]);
    angle = 0.5 *
            atan2(l[1], half); /* atan2(0, 0) is 0: the direction of S_u */
    out->k[0] = mean + radius;
    out->k[1] = mean - radius;
    set_direction(&j, back, cos(angle), sin(angle), 0, out);
    set_direction(&j, back, -sin(angle), cos(angle), 1, out);
    return IX_OK;
}

/* In the axes of the principal directions k1 c^2 + k2 s^2 = 0. */
ix_status ix_srf_asymptotic(ix_ctx *ctx, const ix_mv *s, double u, double v,
                            int *n, ix_principal *out)
{
    /* a curvature below this part of the other cannot be told from zero: some
     * tens of roundings of the second derivatives */
    static const double flat = 1e-14;
    ix_principal p;
    double c, d;

    *n = 0;
    IX_TRY(ix_srf_principal(ctx, s, u, v, &p));
    *out = p;
    out->k[0] = out->k[1] = 0.0;
    if (fabs(p.k[0]) <= flat * fabs(p.k[1]))
        *n = p.k[1] != 0.0;
    else if (fabs(p.k[1]) <= flat * fabs(p.k[0]))
        *n = 1;
    else
        *n = p.k[0] > 0.0 && p.k[1] < 0.0 ? 2 : 0;
    c = sqrt(fmax(0.0, -p.k[1]) / (p.k[0] - p.k[1]));
    d = sqrt(fmax(0.0, p.k[0]) / (p.k[0] - p.k[1]));
    for (int i = 0; i < *n; i++)
        for (int k = 0; k < 3; k++) {
            if (k < 2)
                out->ab[i][k] = c * p.ab[0][k] + (i ? -d : d) * p.ab[1][k];
            out->dir[i][k] = c * p.dir[0][k] + (i ? -d : d) * p.dir[1][k];
        }
    return IX_OK;
}
