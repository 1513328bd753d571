/* feet.c - where a curve is perpendicular to the way to a point or a line, and
 * where its tangent passes through a point: zeros of one field each. */
#include "iritx/distance.h"

#include <math.h>
#include <string.h>

#include "geom/feet.h"
#include "mv/mv.h"
#include "solve/form_roots.h"

typedef enum { FOOT, TANGENT } field_kind;

/* rows of x without their part along the unit vector d (rows beyond x's are
 * 0), in place. */
static void project_out(ix_form *x, const double *d)
{
    for (size_t i = 0; i < x->n; i++) {
        double s = 0;

        for (int k = 0; k < x->nrows; k++)
            s += d[k] * x->c[(size_t)k * x->n + i];
        for (int k = 0; k < x->nrows; k++)
            x->c[(size_t)k * x->n + i] -= s * d[k];
    }
}

static ix_status unit(ix_ctx *ctx, const double *dir, double d[3])
{
    double len = sqrt(dir[0] * dir[0] + dir[1] * dir[1] + dir[2] * dir[2]);

    if (!(len > 0))
        return IX_FAIL(ctx, IX_EARG, "a line of direction (0, 0, 0)");
    for (int k = 0; k < 3; k++)
        d[k] = dir[k] / len;
    return IX_OK;
}

ix_status ix__foot_forms(ix_ctx *ctx, const ix_mv *c, const double p[3],
                         ix_form *x, ix_form *w)
{
    ix_frame frame;
    ix_form f;

    IX_TRY(ix__frame_of(ctx, 1, &c, &frame));
    for (int k = 0; k < frame.ncoords; k++)
        frame.shift[k] = p[k];
    IX_TRY(ix__forms_load(ctx, 1, &c, &frame, &f));
    *w = ix__form_rows(&f, 0, c->rational);
    *x = ix__form_rows(&f, c->rational, f.nrows - c->rational);
    return IX_OK;
}

/* The tangent's direction times a positive function: x' or x' w - x w'. */
static ix_status tangent(ix_ctx *ctx, const ix_form *x, const ix_form *w,
                         ix_form *tan)
{
    return w->nrows ? ix__form_jacobian(ctx, x, w, 0, tan)
                    : ix__form_derive(ctx, x, 0, tan);
}

/* x_0 t_1 - x_1 t_0. */
static ix_status cross_z(ix_ctx *ctx, const ix_form *x, const ix_form *t,
                         ix_form *out)
{
    ix_form x0 = ix__form_rows(x, 0, 1), x1 = ix__form_rows(x, 1, 1);
    ix_form t0 = ix__form_rows(t, 0, 1), t1 = ix__form_rows(t, 1, 1);

    IX_TRY(ix__form_mul(ctx, &x0, &t1, out));
    return ix__form_mul_add(ctx, &x1, -1, &t0, out);
}

/* The roots of x . tan or of x times tan. */
static ix_status field_roots(ix_ctx *ctx, const ix_form *x, const ix_form *tan,
                             field_kind kind, ix_root **roots, int *n)
{
    double *size, *other;
    ix_form f;

    IX_TRY(kind == TANGENT ? cross_z(ctx, x, tan, &f)
                           : ix__form_dot(ctx, x, tan, &f));
    IX_SCRATCH(ctx, size, f.dirs[0].nspans);
    IX_SCRATCH(ctx, other, f.dirs[0].nspans);
    IX_TRY(ix__form_sizes(ctx, x, size));
    IX_TRY(ix__form_sizes(ctx, tan, other));
    for (int j = 0; j < f.dirs[0].nspans; j++)
        size[j] *= other[j];
    return ix__form_roots(ctx, &f, size, roots, n);
}

ix_status ix__foot_roots(ix_ctx *ctx, const ix_form *x, const ix_form *w,
                         ix_root **roots, int *n)
{
    ix_form tan;

    IX_TRY(tangent(ctx, x, w, &tan));
    return field_roots(ctx, x, &tan, FOOT, roots, n);
}

static ix_status curve_roots(ix_ctx *ctx, const ix_mv *c, const double p[3],
                             const double *dir, field_kind kind,
                             ix_root **roots, int *n)
{
    ix_form x, w, tan, own;
    double d[3];

    IX_TRY(ix__foot_forms(ctx, c, p, &x, &w));
    IX_TRY(tangent(ctx, &x, &w, &tan));
    if (dir) {
        IX_TRY(unit(ctx, dir, d));
        IX_TRY(ix__form_copy(ctx, &x, &own));
        project_out(&own, d);
        x = own;
    }
    return field_roots(ctx, &x, &tan, kind, roots, n);
}

ix_status ix__check_curve(ix_ctx *ctx, const ix_mv *c, int least)
{
    if (c->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG, "%d directions; a curve is wanted",
                       c->ndirs);
    if (c->ncoords > 3 || c->ncoords < least)
        return IX_FAIL(ctx, IX_EARG,
                       "a curve of %d coordinates; %d to 3 are "
                       "possible",
                       c->ncoords, least);
    return IX_OK;
}

static ix_status give(ix_ctx *ctx, const ix_root *r, int n, ix_root **roots,
                      int *count)
{
    if (n == 0)
        return IX_OK;
    *roots = ix__alloc(ctx, (size_t)n * sizeof **roots);
    if (!*roots)
        return IX_ENOMEM;
    memcpy(*roots, r, (size_t)n * sizeof **roots);
    *count = n;
    return IX_OK;
}

/* Three coordinates if a line may be oblique to the curve's own. */
static ix_status padded(ix_ctx *ctx, const ix_mv *c, const double *dir,
                        ix_mv **out)
{
    if (dir && c->ncoords < 3)
        return ix_mv_coerce(ctx, c, 3, c->rational, out);
    *out = ix_mv_ref(c);
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, const ix_mv *c, const double p[3],
                     const double *dir, field_kind kind, ix_root **roots,
                     int *n)
{
    ix_mark mk;
    ix_root *r = NULL;
    ix_status st;
    int count = 0;
    ix_mv *m;

    *roots = NULL;
    *n = 0;
    IX_TRY(ix__check_curve(ctx, c, kind == TANGENT ? 2 : 1));
    IX_TRY(padded(ctx, c, dir, &m));
    mk = ix__scratch_mark(ctx);
    st = curve_roots(ctx, m, p, dir, kind, &r, &count);
    if (st == IX_OK)
        st = give(ctx, r, count, roots, n);
    ix__scratch_release(ctx, mk);
    ix_mv_unref(ctx, m);
    return st;
}

ix_status ix_crv_feet(ix_ctx *ctx, const ix_mv *c, const double p[3],
                      const double *dir, ix_root **roots, int *n)
{
    return run(ctx, c, p, dir, FOOT, roots, n);
}

ix_status ix_crv_tangents_from(ix_ctx *ctx, const ix_mv *c, const double p[3],
                               ix_root **roots, int *n)
{
    return run(ctx, c, p, NULL, TANGENT, roots, n);
}
