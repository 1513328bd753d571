/* srf_rib.c - a rib along a curve on a surface, in tangent contact with it.
 *
 * Its two borders are the surface composed with curves of the parameter plane,
 * its derivatives across them the surface's own, composed likewise: contact is
 * exact. What is approximated is where the borders run and the normals between
 * them. */
#include <math.h>

#include "geom/marks.h"
#include "geom/parts.h"
#include "geom/section_hermite.h"
#include "geom/unit_solve.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"

/* Borders and normals are right within this part of half the width, and of the
 * height. */
#define FIT_TOL 1e-4
/* A straight border is one within this part: rounding of what it comes from. */
#define LINE_TOL 1e-9

typedef struct {
    const ix_mv *srf;
    const ix_rib *o;
    ix__marks marks;   /* of the path: its ends, where parameters kink */
    double u[2], v[2]; /* domain of srf */
    int side;          /* -1, 1: which border */
} rib;

/* --- functions of the path's parameter
 * ---------------------------------------- */

/* The factor, or the value of its curve at t mapped from the path's domain. */
static ix_status value_at(ix_ctx *ctx, const rib *r, double factor,
                          const ix_mv *crv, double t, double *out)
{
    const double *span = r->marks.dom;
    double v[IX_MAX_COORDS], dom[2], x;

    *out = factor;
    if (!crv)
        return IX_OK;
    ix_mv_domain(crv, 0, dom);
    x = (t - span[0]) / (span[1] - span[0]);
    x = (1 - x) * dom[0] + x * dom[1];
    IX_TRY(ix_mv_point(ctx, crv, &x, v));
    *out *= v[crv->ncoords > 1 ? 1 : 0];
    return IX_OK;
}

/* The step d in the parameter plane, to the left of the path, whose image in
 * the tangent plane is perpendicular to the curve and has length 1. */
static ix_status across(ix_ctx *ctx, const rib *r, const double at[2],
                        const double along[2], double t, double d[2])
{
    double su[3], sv[3], e, f, g, len;

    IX_TRY(ix_srf_tangent(ctx, r->srf, 0, at[0], at[1], su));
    IX_TRY(ix_srf_tangent(ctx, r->srf, 1, at[0], at[1], sv));
    e = ix__dot3(su, su);
    f = ix__dot3(su, sv);
    g = ix__dot3(sv, sv);
    d[0] = -(f * along[0] + g * along[1]);
    d[1] = e * along[0] + f * along[1];
    len = sqrt(e * d[0] * d[0] + 2 * f * d[0] * d[1] + g * d[1] * d[1]);
    if (!(len > 0 && isfinite(len) && (e * g - f * f) > 1e-14 * e * g))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "at parameter %g the curve or the surface is singular",
                       t);
    d[0] /= len;
    d[1] /= len;
    return IX_OK;
}

static bool inside(const rib *r, const double p[2])
{
    double eps[2] = {1e-9 * (r->u[1] - r->u[0]), 1e-9 * (r->v[1] - r->v[0])};

    return p[0] >= r->u[0] - eps[0] && p[0] <= r->u[1] + eps[0] &&
           p[1] >= r->v[0] - eps[1] && p[1] <= r->v[1] + eps[1];
}

static ix_status check_inside(ix_ctx *ctx, const rib *r, double t,
                              const double p[2], const char *what)
{
    if (!inside(r, p))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "at parameter %g %s is at (%g, %g), outside the "
                       "surface's domain",
                       t, what, p[0], p[1]);
    return IX_OK;
}

/* The border at t, out[2]; *size: half the width in the parameter plane. */
static ix_status border_at(ix_ctx *ctx, const rib *r, double t, double *out,
                           double *size)
{
    double d[2][3], step[2], width;

    ix__path_derivs3(&r->marks.path, ix__path_span(&r->marks.path, t), t, 1, d);
    IX_TRY(check_inside(ctx, r, t, d[0], "the curve"));
    IX_TRY(value_at(ctx, r, r->o->width, r->o->width_crv, t, &width));
    if (!(width > 0))
        return IX_FAIL(ctx, IX_EARG, "at parameter %g the width is %g", t,
                       width);
    IX_TRY(across(ctx, r, d[0], d[1], t, step));
    for (int k = 0; k < 2; k++)
        out[k] = d[0][k] + r->side * width / 2 * step[k];
    *size = width / 2 * hypot(step[0], step[1]);
    return check_inside(ctx, r, t, out, "a border");
}

/* The unit normal times the height, out[3]. */
static ix_status raised_at(ix_ctx *ctx, const rib *r, double t, double *out,
                           double *size)
{
    double at[IX_MAX_COORDS], height;

    ix__path_point(&r->marks.path, t, at);
    IX_TRY(value_at(ctx, r, r->o->height, r->o->height_crv, t, &height));
    IX_TRY(ix_srf_normal(ctx, r->srf, at[0], at[1], out));
    for (int k = 0; k < 3; k++)
        out[k] *= height;
    *size = fabs(height);
    return IX_OK;
}

/* --- splines near them
 * --------------------------------------------------------- */

typedef ix_status (*rib_fn)(ix_ctx *ctx, const rib *r, double t, double *out,
                            double *size);

/* Knots of the order with `parts` spans between kinks, where splines of order 4
 * are but C0. */
static ix_status make_dir(ix_ctx *ctx, const rib *r, int order, int parts,
                          ix_dir *out)
{
    const double *mark = r->marks.t;
    int spans = r->marks.n - 1, n = 0;
    int most = 2 * order + spans * (parts + order);
    double *kv;

    IX_SCRATCH(ctx, kv, most);
    kv[n++] = mark[0];
    for (int k = 0; k < spans; k++) {
        for (int i = 1; i < order; i++)
            kv[n++] = mark[k];
        for (int i = 1; i < parts; i++)
            kv[n++] = mark[k] + (mark[k + 1] - mark[k]) * i / parts;
    }
    for (int i = 0; i < order; i++)
        kv[n++] = mark[spans];
    *out = (ix_dir){IX_BSPLINE, order, n - order, false, kv};
    return IX_OK;
}

/* The spline that is fn at its nodes. */
static ix_status through(ix_ctx *ctx, const rib *r, rib_fn fn, int dim,
                         const ix_dir *dir, ix_mv **out)
{
    int n = dir->length;
    double *tau, *pts, size;

    IX_SCRATCH(ctx, tau, n);
    IX_SCRATCH(ctx, pts, (size_t)n * (size_t)dim);
    ix_knots_nodes(dir, tau);
    for (int i = 0; i < n; i++) {
        double x[3];

        IX_TRY(ix__poll(ctx));
        IX_TRY(fn(ctx, r, tau[i], x, &size));
        for (int k = 0; k < dim; k++)
            pts[k * n + i] = x[k];
    }
    return ix_interpolate(ctx, n, dim, false, pts,
                          &(ix_interpolate_opts){.order = dir->order,
                                                 .size = n,
                                                 .nparams = n,
                                                 .params = tau,
                                                 .nknots = n + dir->order,
                                                 .knots = dir->knots},
                          NULL, out);
}

/* Is it right within tol times the size at 4 n places? */
static ix_status good(ix_ctx *ctx, const rib *r, rib_fn fn, int dim, int n,
                      double tol, const ix_mv *m, bool *out)
{
    const double *span = r->marks.dom;

    *out = true;
    for (int i = 0; i <= 4 * n && *out; i++) {
        double x = (double)i / (4 * n), y[3], q[3], size, d = 0;
        double t = (1 - x) * span[0] + x * span[1];

        IX_TRY(fn(ctx, r, t, y, &size));
        IX_TRY(ix_mv_point(ctx, m, &t, q));
        for (int k = 0; k < dim; k++)
            d = hypot(d, y[k] - q[k]);
        *out = d <= tol * size;
    }
    return IX_OK;
}

static ix_status attempt(ix_ctx *ctx, const rib *r, rib_fn fn, int dim,
                         int parts, bool *ok, ix_mv **out)
{
    ix_dir dir;

    IX_TRY(make_dir(ctx, r, parts ? 4 : 2, parts ? parts : 1, &dir));
    IX_TRY(through(ctx, r, fn, dim, &dir, out));
    return good(ctx, r, fn, dim, dir.length, parts ? FIT_TOL : LINE_TOL, *out,
                ok);
}

/* A spline near fn: piecewise linear if that will do, else cubic with 1, 2, 4,
 * ... spans between kinks. */
static ix_status spline_near(ix_ctx *ctx, const rib *r, rib_fn fn, int dim,
                             ix_mv **out)
{
    const int most = 256;

    for (int parts = 0; parts <= most; parts = parts ? 2 * parts : 1) {
        ix_mark mk = ix__scratch_mark(ctx);
        bool ok = false;
        ix_status st;

        *out = NULL;
        st = attempt(ctx, r, fn, dim, parts, &ok, out);
        ix__scratch_release(ctx, mk);
        if (st == IX_OK && ok)
            return IX_OK;
        ix_mv_unref(ctx, *out);
        *out = NULL;
        IX_TRY(st);
    }
    return IX_FAIL(ctx, IX_EUNABLE,
                   "%d spans do not follow a border of the rib within %g of "
                   "its width",
                   most, FIT_TOL);
}

/* --- kinks ------------------------------------------------------------------
 */

/* Marks where the path crosses a knot of the surface at which that is less than
 * C2. */
static ix_status mark_crossings(rib *r, int d)
{
    const ix_dir *dir = &r->srf->dirs[d];
    int n = ix_knots_count(dir) - dir->order, many = 0;
    const double normal[2] = {d == 0, d == 1};

    for (int i = dir->order; i < n; i++) {
        double at[2] = {dir->knots[i], dir->knots[i]};

        many++;
        if (dir->knots[i + 1] <= dir->knots[i] || many < dir->order - 2) {
            many = dir->knots[i + 1] > dir->knots[i] ? 0 : many;
            continue;
        }
        many = 0;
        IX_TRY(ix__marks_add_line(&r->marks, at, normal, false));
    }
    return IX_OK;
}

static ix_status find_kinks(rib *r)
{
    const ix_path *p = &r->marks.path;

    for (int i = 1; i < p->nspans; i++)
        if (p->cont[i - 1] < 2)
            IX_TRY(ix__marks_add(&r->marks, p->breaks[i]));
    for (int d = 0; d < 2; d++)
        IX_TRY(mark_crossings(r, d));
    ix__marks_sort(&r->marks);
    return IX_OK;
}

/* --- exact contact
 * ------------------------------------------------------------- */

/* Both borders in the parameter plane, and the raised normals. */
typedef struct {
    ix_mv *border[2], *normal;
} tracks;

static const ix_mv *composed(ix_pool *q, const ix_mv *f, const ix_mv *g)
{
    return q->st == IX_OK && f
               ? ix__pool_made(q,
                               ix_sym_compose(q->ctx, f, g, ix__pool_room(q)))
               : NULL;
}

/* Axis k of the composition, over [0, 1], as the second of two parameters. */
static const ix_mv *axis(ix_pool *q, const ix_mv *m, int k)
{
    if (q->st != IX_OK || !m)
        return NULL;
    return ix__pool_promote(q, ix__pool_unit(q, ix__pool_axis(q, m, k)), 2, 1);
}

/* The homogeneous surface's derivative along the step between the borders. */
static const ix_mv *slope(ix_pool *q, const ix_mv *const d[2],
                          const ix_mv *const step[2], int k)
{
    return ix__sum0(q, ix__prod0(q, axis(q, d[0], k), step[0]),
                    ix__prod0(q, axis(q, d[1], k), step[1]));
}

/* Position and derivative at end e: X / w and (D w - X D_w) / w^2, both over
 * w^2; h is the surface with its weight as the first coordinate. */
static void contact(ix_pool *q, const ix_mv *h, bool rational, const ix_mv *g,
                    const ix_mv *const step[2], int e, ix__section_hermite *out)
{
    const ix_mv *x = composed(q, h, g), *d[2], *w = NULL, *dw = NULL;
    int n = h->ncoords - rational;

    for (int k = 0; k < 2; k++)
        d[k] = composed(q, ix__pool_derive(q, h, k), g);
    if (rational) {
        w = axis(q, x, 0);
        dw = slope(q, d, step, 0);
        out->b[e].w = out->t[e].w = ix__prod0(q, w, w);
    }
    for (int k = 0; k < n; k++) {
        const ix_mv *xk = axis(q, x, k + rational);
        const ix_mv *dk = slope(q, d, step, k + rational);

        out->b[e].x[k] = rational ? ix__prod0(q, xk, w) : xk;
        out->t[e].x[k] = rational ? ix__diff0(q, ix__prod0(q, dk, w),
                                              ix__prod0(q, xk, dw))
                                  : dk;
    }
}

/* The surface without a weight: that as the first coordinate. */
static const ix_mv *homogeneous(ix_pool *q, const ix_mv *s)
{
    return ix__pool_made(
        q, s->rational
               ? ix__mv_relabel(q->ctx, s, false, ix__pool_room(q))
               : ix_mv_coerce(q->ctx, s, s->ncoords, false, ix__pool_room(q)));
}

static ix__vec promoted(ix_pool *q, const ix_mv *c, int start)
{
    const ix_mv *u = q->st == IX_OK ? ix__pool_unit(q, c) : NULL;

    return u ? ix__vec_promote(q, ix__vec_of(q, u), 2, start)
             : (ix__vec){{NULL}, NULL};
}

static ix_status build(ix_ctx *ctx, const rib *r, const tracks *k, ix_mv **out)
{
    ix_pool q = {.ctx = ctx};
    ix__section_hermite h = {.section = {{NULL}, NULL}};
    const ix_mv *s = homogeneous(&q, r->srf), *gap = NULL, *step[2] = {NULL};

    if (q.st == IX_OK)
        gap = ix__pool_sub(&q, k->border[1], k->border[0]);
    for (int d = 0; d < 2 && q.st == IX_OK; d++)
        step[d] = ix__pool_scale(&q, axis(&q, gap, d), r->o->tan_scale);
    for (int e = 0; e < 2 && q.st == IX_OK; e++)
        contact(&q, s, r->srf->rational, k->border[e], step, e, &h);
    h.section = promoted(&q, r->o->section, 0);
    h.normal = promoted(&q, k->normal, 1);
    return ix__section_hermite_make(&q, &h, out);
}

/* --- the whole
 * ------------------------------------------------------------------ */

static ix_status check(ix_ctx *ctx, const ix_mv *srf, const ix_rib *o)
{
    const ix_mv *crv[4] = {o->path, o->section, o->width_crv, o->height_crv};

    if (srf->ndirs != 2 || srf->ncoords < 2 || srf->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a surface of 2 or 3 "
                       "is wanted",
                       srf->ndirs, srf->ncoords);
    for (int k = 0; k < 4; k++)
        if (crv[k] && crv[k]->ndirs != 1)
            return IX_FAIL(ctx, IX_EARG, "%d directions; a curve is wanted",
                           crv[k]->ndirs);
    if (o->path->ncoords < 2)
        return IX_FAIL(ctx, IX_EARG,
                       "a path of one coordinate; u and v are wanted");
    if (!(o->tan_scale > 0 && isfinite(o->tan_scale)))
        return IX_FAIL(ctx, IX_EARG,
                       "tangents scaled by %g; a positive number is wanted",
                       o->tan_scale);
    if (!isfinite(o->width) || !isfinite(o->height))
        return IX_FAIL(ctx, IX_EARG, "width %g, height %g", o->width,
                       o->height);
    return ix__section_check(ctx, o->section);
}

/* in: the surface not in power basis, the path with two coordinates. */
static ix_status make(ix_ctx *ctx, const ix_mv *srf, rib *r, ix_mv *in[2],
                      tracks *k, ix_mv **out)
{
    const ix_mv *path = r->o->path;
    int corner;

    IX_TRY(ix__mv_plain(ctx, srf, &in[0]));
    r->srf = in[0];
    ix_mv_domain(r->srf, 0, r->u);
    ix_mv_domain(r->srf, 1, r->v);
    IX_TRY(ix_mv_coerce(ctx, path, 2, path->rational, &in[1]));
    IX_TRY(ix__marks_ends(ctx, in[1], &r->marks));
    corner = ix__path_corner(&r->marks.path, 1);
    if (corner < r->marks.path.nspans)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the curve has a corner at parameter %g: cut it there",
                       r->marks.path.breaks[corner]);
    IX_TRY(find_kinks(r));
    for (int e = 0; e < 2; e++) {
        r->side = 2 * e - 1;
        IX_TRY(spline_near(ctx, r, border_at, 2, &k->border[e]));
    }
    IX_TRY(spline_near(ctx, r, raised_at, 3, &k->normal));
    return build(ctx, r, k, out);
}

ix_status ix_srf_rib(ix_ctx *ctx, const ix_mv *srf, const ix_rib *o,
                     ix_mv **out)
{
    rib r = {.o = o};
    tracks k = {{NULL, NULL}, NULL};
    ix_mv *in[2] = {NULL};
    ix_mark mk;
    ix_status st;

    *out = NULL;
    IX_TRY(check(ctx, srf, o));
    mk = ix__scratch_mark(ctx);
    st = make(ctx, srf, &r, in, &k, out);
    ix__mv_unref_all(ctx, in, 2);
    ix__mv_unref_all(ctx, k.border, 2);
    ix_mv_unref(ctx, k.normal);
    ix__scratch_release(ctx, mk);
    return st;
}
