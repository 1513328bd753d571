/* srf_ray.c - where a ray meets a surface: two planes through the ray make two
 * equations in the parameters of the surface. */
#include <stdlib.h>

#include "geom/outer_mv.h"
#include "geom/vec3.h"
#include "iritx/distance.h"

static int along_ray(const void *a, const void *b)
{
    double s = ((const ix_solution *)a)->x[2];
    double t = ((const ix_solution *)b)->x[2];

    return s < t ? -1 : s > t;
}

/* x[2] becomes the parameter of the ray; what is behind its start goes. */
static ix_status order(ix_ctx *ctx, const ix_mv *s, const double p[3],
                       const double d[3], ix_solutions *out)
{
    double len2 = ix__dot3(d, d);
    int n = 0;

    for (int i = 0; i < out->n; i++) {
        ix_solution r = out->sol[i];
        double x[IX_MAX_COORDS] = {0}, v[3];

        IX_TRY(ix_mv_point(ctx, s, r.x, x));
        ix__sub3(x, p, v);
        r.x[2] = r.lo[2] = r.hi[2] = ix__dot3(v, d) / len2;
        /* 1e-12: a start on the surface counts */
        if (r.x[2] * sqrt(len2) >= -1e-12 * (ix__len3(x) + ix__len3(p)))
            out->sol[n++] = r;
    }
    out->n = n;
    out->unknowns = 3;
    if (n > 1)
        qsort(out->sol, (size_t)n, sizeof *out->sol, along_ray);
    return IX_OK;
}

ix_status ix_srf_ray(ix_ctx *ctx, const ix_mv *s, const double p[3],
                     const double d[3], ix_solutions *out)
{
    const ix_solve_opts o = {.max_boxes = 100000};
    ix_equation eq[2] = {{.rel = IX_EQUAL_ZERO}, {.rel = IX_EQUAL_ZERO}};
    ix_mv *f[2] = {NULL};
    double u[3], e[2][3];
    ix_status st = IX_OK;

    *out = (ix_solutions){.n = 0};
    if (s->ndirs != 2 || s->ncoords > 3 || s->dirs[0].basis == IX_POWER)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a Bezier or B-spline "
                       "surface of at most 3 is wanted",
                       s->ndirs, s->ncoords);
    IX_TRY(ix__direction(ctx, "the ray", d, u));
    ix__perp3(u, e[0]);
    ix__cross3(u, e[0], e[1]);
    for (int k = 0; st == IX_OK && k < 2; k++) {
        const double plane[4] = {e[k][0], e[k][1], e[k][2], -ix__dot3(e[k], p)};

        st = ix__affine_field(ctx, s, plane, &f[k]);
        eq[k].f = f[k];
    }
    if (st == IX_OK)
        st = ix_solve(ctx, 2, eq, &o, out);
    for (int k = 0; k < 2; k++)
        ix_mv_unref(ctx, f[k]);
    if (st == IX_OK)
        st = order(ctx, s, p, d, out);
    if (st != IX_OK)
        ix_solutions_free(ctx, out);
    return st;
}
