/* contour.c - zero sets of scalar fields on surfaces. */
#include "iritx/contour.h"

#include <math.h>

#include "geom/normals.h"
#include "geom/outer_mv.h"
#include "geom/point_curves.h"
#include "iritx/geom_srf.h"
#include "iritx/sym.h"

ix_status ix_contour_field(ix_ctx *ctx, const ix_mv *m, const double plane[4],
                           ix_mv **out)
{
    *out = NULL;
    return ix__affine_field(ctx, m, plane, out);
}

/* The zeros of f, which is consumed, on s, without its poles; s NULL: in the
 * plane of the parameters. */
static ix_status trace(ix_ctx *ctx, ix_mv *f, const ix_mv *s, double tol,
                       ix_solution_curves *out)
{
    const ix_equation eq = {.f = f, .axis = f->rational, .rel = IX_EQUAL_ZERO};
    const ix_curves_opts o = {.tol = tol, .image = s};
    ix_status st = ix_solve_curves(ctx, 1, &eq, &o, out);

    ix_mv_unref(ctx, f);
    if (st == IX_OK && s)
        st = ix__drop_point_curves(ctx, s, 0, out);
    if (st != IX_OK)
        ix_solution_curves_free(ctx, out);
    return st;
}

ix_status ix_contour(ix_ctx *ctx, const ix_mv *m, const double plane[4],
                     double tol, ix_solution_curves *out)
{
    return ix_contour_on(ctx, m, plane, m->ncoords > 1 ? m : NULL, tol, out);
}

ix_status ix_contour_on(ix_ctx *ctx, const ix_mv *m, const double plane[4],
                        const ix_mv *on, double tol, ix_solution_curves *out)
{
    ix_mv *f;

    *out = (ix_solution_curves){.unknowns = 0};
    if (m->ndirs != 2)
        return IX_FAIL(ctx, IX_EARG,
                       "contours of a freeform of %d directions; "
                       "a surface is wanted",
                       m->ndirs);
    IX_TRY(ix__affine_field(ctx, m, plane, &f));
    return trace(ctx, f, on, tol, out);
}

ix_status ix_silhouette(ix_ctx *ctx, const ix_mv *s, const double view[3],
                        double tol, ix_solution_curves *out)
{
    const double v[4] = {view[0], view[1], view[2], 0};
    ix_status st;
    ix_mv *n;

    *out = (ix_solution_curves){.unknowns = 0};
    if (!(view[0] * view[0] + view[1] * view[1] + view[2] * view[2] > 0))
        return IX_FAIL(ctx, IX_EARG, "a view direction of length 0");
    IX_TRY(ix_srf_normal_field(ctx, s, &n));
    st = ix_contour_on(ctx, n, v, s, tol, out);
    ix_mv_unref(ctx, n);
    return st;
}

/* <n, view>^2 - cos^2 <n, n> of the normal field n, view a unit vector. */
static ix_status isocline_field(ix_ctx *ctx, const ix_mv *n,
                                const double view[3], double cosine,
                                ix_mv **out)
{
    const double scale[16] = {cosine, 0, 0,      0, 0, cosine, 0, 0,
                              0,      0, cosine, 0, 0, 0,      0, 1};
    ix_mv *along, *part = NULL, *a2 = NULL, *n2 = NULL;
    ix_status st;

    IX_TRY(ix_sym_dot_vector(ctx, n, view, &along));
    st = ix_sym_mul(ctx, along, along, NULL, &a2);
    if (st == IX_OK)
        st = ix_mv_transform(ctx, n, scale, &part);
    if (st == IX_OK)
        st = ix_sym_dot(ctx, part, part, NULL, &n2);
    if (st == IX_OK)
        st = ix_sym_sub(ctx, a2, n2, NULL, out);
    ix_mv_unref(ctx, along);
    ix_mv_unref(ctx, part);
    ix_mv_unref(ctx, a2);
    ix_mv_unref(ctx, n2);
    return st;
}

ix_status ix__normals_isocline(ix_ctx *ctx, const ix_mv *field,
                               const double view[3], double theta, ix_mv **out)
{
    *out = NULL;
    if (fabs(cos(theta)) <= 1e-12) /* not the square of the silhouette's */
        return ix_sym_dot_vector(ctx, field, view, out);
    return isocline_field(ctx, field, view, cos(theta), out);
}

ix_status ix_isocline_field(ix_ctx *ctx, const ix_mv *s, const double view[3],
                            double theta, ix_mv **out)
{
    double len = sqrt(view[0] * view[0] + view[1] * view[1] +
                      view[2] * view[2]);
    const double v[3] = {view[0] / len, view[1] / len, view[2] / len};
    ix_mv *n;
    ix_status st;

    *out = NULL;
    if (!(len > 0))
        return IX_FAIL(ctx, IX_EARG, "a direction of length 0");
    IX_TRY(ix_srf_normal_field(ctx, s, &n));
    st = ix__normals_isocline(ctx, n, v, theta, out);
    ix_mv_unref(ctx, n);
    return st;
}

ix_status ix_isocline(ix_ctx *ctx, const ix_mv *s, const double view[3],
                      double theta, double tol, ix_solution_curves *out)
{
    ix_mv *f;

    *out = (ix_solution_curves){.unknowns = 0};
    IX_TRY(ix_isocline_field(ctx, s, view, theta, &f));
    return trace(ctx, f, s, tol, out);
}

ix_status ix_polar_silhouette(ix_ctx *ctx, const ix_mv *s, const double axis[3],
                              double tol, ix_solution_curves *out)
{
    ix_mv *n, *moment = NULL, *f = NULL;
    ix_status st;

    *out = (ix_solution_curves){.unknowns = 0};
    if (!(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2] > 0))
        return IX_FAIL(ctx, IX_EARG, "an axis of length 0");
    IX_TRY(ix_srf_normal_field(ctx, s, &n));
    st = ix_sym_cross(ctx, s, n, NULL, &moment);
    if (st == IX_OK)
        st = ix_sym_dot_vector(ctx, moment, axis, &f);
    ix_mv_unref(ctx, n);
    ix_mv_unref(ctx, moment);
    IX_TRY(st);
    return trace(ctx, f, s, tol, out);
}

ix_status ix_implicit_extremes(ix_ctx *ctx, const ix_mv *f, int dir,
                               ix_solutions *out)
{
    ix_equation eq[2] = {{.axis = 0, .rel = IX_EQUAL_ZERO},
                         {.axis = 0, .rel = IX_EQUAL_ZERO}};
    ix_status st;
    ix_mv *num, *d;

    *out = (ix_solutions){.n = 0};
    if (f->ndirs != 2 || f->ncoords != 1 || dir < 0 || dir > 1)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates, direction %d; a "
                       "scalar surface is wanted",
                       f->ndirs, f->ncoords, dir);
    IX_TRY(ix_mv_scalar(ctx, f, f->rational, &num));
    st = ix_sym_derive(ctx, num, 1 - dir, NULL, &d);
    if (st == IX_OK) {
        eq[0].f = num;
        eq[1].f = d;
        st = ix_solve(ctx, 2, eq, NULL, out);
        ix_mv_unref(ctx, d);
    }
    ix_mv_unref(ctx, num);
    return st;
}
