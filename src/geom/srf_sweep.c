/* srf_sweep.c - surfaces swept by sections along an axis curve. Each control
 * point of the axis carries one scaled section in the frame that belongs to
 * the node of that control point; frames are orthonormal and right-handed. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "geom/matrix.h"
#include "geom/parts.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"

/* Rows of a frame are the images of the section's axes X, Y, Z. */
typedef double frame3[3][3];

/* Steps of the rotation minimising frame between two nodes: its error is
 * O(h^4), below 1e-8 for a quarter turn per node. */
enum { SUBSTEPS = 32 };

/* --- tangents ---------------------------------------------------------- */

/* True where the axis has a corner: an interior knot of multiplicity at least
 * order - 1. */
static bool at_corner(const ix_mv *axis, double t)
{
    const ix_dir *d = &axis->dirs[0];
    int mult = 0;

    if (d->basis != IX_BSPLINE || !(t > d->knots[d->order - 1]) ||
        !(t < d->knots[d->length]))
        return false;
    for (int i = 0; i < d->order + d->length; i++)
        mult += d->knots[i] == t;
    return mult >= d->order - 1;
}

/* Position and unit derivative; *speed is the derivative's length. */
static ix_status derivative(ix_ctx *ctx, const ix_mv *axis, double t,
                            double pos[3], double tan[3], double *speed)
{
    double d[2][3];

    IX_TRY(ix_mv_curve_derivs(ctx, axis, t, 1, d[0]));
    memcpy(pos, d[0], sizeof d[0]);
    memcpy(tan, d[1], sizeof d[1]);
    *speed = ix__unit3(tan, tan);
    return IX_OK;
}

/* Unit tangent; the bisecting direction at a corner. Where the derivative
 * vanishes it is taken 1e-5 of the domain away, towards the middle. */
static ix_status tangent(ix_ctx *ctx, const ix_mv *axis, double t,
                         double pos[3], double tan[3])
{
    double dom[2], len, speed, before[3], unused[3];

    ix_mv_domain(axis, 0, dom);
    len = dom[1] - dom[0];
    IX_TRY(derivative(ctx, axis, t, pos, tan, &speed));
    if (at_corner(axis, t)) {
        IX_TRY(derivative(ctx, axis, t - 1e-9 * len, unused, before, &speed));
        for (int k = 0; k < 3; k++)
            tan[k] += before[k];
        speed = ix__unit3(tan, tan);
    }
    if (speed > 0)
        return IX_OK;
    t += (t > 0.5 * (dom[0] + dom[1]) ? -1e-5 : 1e-5) * len;
    IX_TRY(derivative(ctx, axis, t, unused, tan, &speed));
    if (!(speed > 0))
        return IX_FAIL(ctx, IX_EDOMAIN, "the axis has no tangent at %g", t);
    return IX_OK;
}

/* --- frames ------------------------------------------------------------ */

static ix_status first_frame(ix_ctx *ctx, const double tan[3], frame3 f)
{
    double m[16];

    IX_TRY(ix__mat_turn(ctx, (const double[3]){0, 0, 1}, tan, m));
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            f[i][k] = m[4 * i + k];
    return IX_OK;
}

/* v reflected in the plane orthogonal to n, c = n.n > 0. */
static void reflect(const double n[3], double c, double v[3])
{
    double s = 2 * ix__dot3(n, v) / c;

    for (int k = 0; k < 3; k++)
        v[k] -= s * n[k];
}

/* Double reflection from the frame f at position p to tangent tan at q. */
static void transport(const double p[3], const double q[3], const double tan[3],
                      frame3 f)
{
    double n[3], c;

    for (int k = 0; k < 3; k++)
        n[k] = q[k] - p[k];
    c = ix__dot3(n, n);
    if (c > 0) {
        reflect(n, c, f[0]);
        reflect(n, c, f[2]);
    }
    for (int k = 0; k < 3; k++)
        n[k] = tan[k] - f[2][k];
    c = ix__dot3(n, n);
    if (c > DBL_EPSILON * DBL_EPSILON)
        reflect(n, c, f[0]);
    memcpy(f[2], tan, sizeof f[2]);
    c = ix__dot3(f[0], f[2]); /* rounding must not pile up */
    for (int k = 0; k < 3; k++)
        f[0][k] -= c * f[2][k];
    ix__unit3(f[0], f[0]);
    ix__cross3(f[2], f[0], f[1]);
}

static ix_status minimal_frames(ix_ctx *ctx, const ix_mv *axis,
                                const double *nodes, int n, frame3 *f)
{
    double p[3], q[3], tan[3];

    IX_TRY(tangent(ctx, axis, nodes[0], p, tan));
    IX_TRY(first_frame(ctx, tan, f[0]));
    for (int i = 1; i < n; i++) {
        memcpy(f[i], f[i - 1], sizeof f[i]);
        for (int k = 1; k <= SUBSTEPS; k++) {
            double s = (double)k / SUBSTEPS;
            double t = k == SUBSTEPS ? nodes[i]
                                     : (1 - s) * nodes[i - 1] + s * nodes[i];

            IX_TRY(tangent(ctx, axis, t, q, tan));
            transport(p, q, tan, f[i]);
            memcpy(p, q, sizeof p);
        }
    }
    return IX_OK;
}

/* x of the domain of from at the place of t in that of to. */
static double map_param(const ix_mv *from, const ix_mv *to, double t)
{
    double a[2], b[2], s;

    ix_mv_domain(from, 0, a);
    ix_mv_domain(to, 0, b);
    s = (t - b[0]) / (b[1] - b[0]);
    return (1 - s) * a[0] + s * a[1];
}

/* The frame whose Y axis is closest to the binormal b. */
static ix_status fixed_frame(ix_ctx *ctx, double t, const double tan[3],
                             const double b[3], frame3 f)
{
    memcpy(f[2], tan, sizeof f[2]);
    ix__cross3(b, tan, f[0]);
    if (!(ix__unit3(f[0], f[0]) > 1e-12 * sqrt(ix__dot3(b, b))))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the binormal (%g, %g, %g) is along the axis at %g",
                       b[0], b[1], b[2], t);
    ix__cross3(tan, f[0], f[1]);
    return IX_OK;
}

static ix_status binormal_frames(ix_ctx *ctx, const ix_sweep *s,
                                 const ix_mv *axis, const ix_mv *field,
                                 const double *nodes, int n, frame3 *f)
{
    double b[3] = {s->vec[0], s->vec[1], s->vec[2]}, p[3], tan[3];

    for (int i = 0; i < n; i++) {
        double t;

        IX_TRY(tangent(ctx, axis, nodes[i], p, tan));
        if (field) {
            t = map_param(field, axis, nodes[i]);
            IX_TRY(ix_mv_point(ctx, field, &t, b));
        }
        IX_TRY(fixed_frame(ctx, nodes[i], tan, b, f[i]));
    }
    return IX_OK;
}

/* --- the pieces of the product ----------------------------------------- */

/* The axis, open, with three coordinates and the wanted extra knots: t[3]. */
static ix_status prepare_axis(ix_ctx *ctx, const ix_sweep *s, ix_mv *t[4])
{
    int wanted = s->refine * (s->scale ? s->scale->dirs[0].length : 1), n = 0;
    double dom[2], *knots;

    IX_TRY(ix__mv_plain(ctx, s->axis, &t[0]));
    IX_TRY(ix_mv_to_open(ctx, t[0], &t[1]));
    IX_TRY(ix_mv_coerce(ctx, t[1], 3, t[1]->rational, &t[2]));
    if (wanted <= 0) {
        t[3] = ix_mv_ref(t[2]);
        return IX_OK;
    }
    ix_mv_domain(t[2], 0, dom);
    IX_SCRATCH(ctx, knots, wanted);
    for (int i = 1; i <= wanted; i++) {
        double k = dom[0] + (dom[1] - dom[0]) * i / (wanted + 1);

        if (!at_corner(t[2], k))
            knots[n++] = k;
    }
    return ix_mv_insert_knots(ctx, t[2], 0, n, knots, &t[3]);
}

/* The sections, compatible, as one map with a second direction that numbers
 * them. One section becomes two equal ones. */
static ix_status prepare_sections(ix_ctx *ctx, const ix_sweep *s, ix_mv **out)
{
    int n = s->nsections > 1 ? s->nsections : 2;
    const ix_mv **view;
    ix_mv *stack = NULL;
    ix_status st;

    IX_SCRATCH(ctx, view, n);
    for (int i = 0; i < n; i++)
        view[i] = s->sections[s->nsections > 1 ? i : 0];
    IX_TRY(ix_srf_layers(ctx, n, view, 2, IX_KV_OPEN, &stack));
    st = ix_mv_coerce(ctx, stack, 3, stack->rational, out);
    ix_mv_unref(ctx, stack);
    return st;
}

/* Factor of the section at node t. */
static ix_status scale_at(ix_ctx *ctx, const ix_sweep *s, const ix_mv *axis,
                          double t, double *out)
{
    double v[IX_MAX_COORDS];

    *out = s->factor;
    if (!s->scale)
        return IX_OK;
    t = map_param(s->scale, axis, t);
    IX_TRY(ix_mv_point(ctx, s->scale, &t, v));
    *out *= v[s->scale->ncoords > 1 ? 1 : 0];
    return IX_OK;
}

/* Section at fraction x of the axis: homogeneous (w, x, y, z) of point i. */
static void section_point(const ix_mv *sec, double x, size_t i, double p[4])
{
    size_t n = (size_t)sec->dirs[0].length;
    double at = x * (sec->dirs[1].length - 1), f;
    size_t row = (size_t)fmin(floor(at), sec->dirs[1].length - 2);
    const double *w = ix_mv_weights(sec);

    f = at - (double)row;
    for (int k = 0; k < 4; k++) {
        const double *a = k ? ix_mv_coord(sec, k - 1) : w;

        p[k] = a ? (1 - f) * a[row * n + i] + f * a[(row + 1) * n + i] : 1;
    }
}

/* Column j of the result: the section at axis control point j. */
static void put_column(ix_mv *m, const ix_mv *sec, const ix_mv *axis, size_t j,
                       double x, double scale, frame3 f)
{
    size_t n = (size_t)m->dirs[0].length;
    double wa = axis->rational ? ix_mv_weights(axis)[j] : 1;

    for (size_t i = 0; i < n; i++) {
        double *q = m->pts + j * n + i, p[4];

        section_point(sec, x, i, p);
        if (m->rational) {
            *q = wa * p[0];
            q += m->npts;
        }
        for (int k = 0; k < 3; k++, q += m->npts)
            *q = wa * scale *
                     (p[1] * f[0][k] + p[2] * f[1][k] + p[3] * f[2][k]) +
                 p[0] * ix_mv_coord(axis, k)[j];
    }
}

static ix_status assemble(ix_ctx *ctx, const ix_sweep *s, const ix_mv *axis,
                          const ix_mv *sec, const double *nodes, frame3 *f,
                          ix_mv **out)
{
    ix_dir dirs[2] = {sec->dirs[0], axis->dirs[0]};
    double dom[2], scale;
    ix_mv *m;

    ix_mv_domain(axis, 0, dom);
    IX_TRY(ix__mv_alloc(ctx, 2, dirs, 3, sec->rational || axis->rational, &m));
    for (int j = 0; j < axis->dirs[0].length; j++) {
        ix_status st = scale_at(ctx, s, axis, nodes[j], &scale);

        if (st != IX_OK) {
            ix_mv_unref(ctx, m);
            return st;
        }
        put_column(m, sec, axis, (size_t)j,
                   (nodes[j] - dom[0]) / (dom[1] - dom[0]), scale, f[j]);
    }
    *out = m;
    return IX_OK;
}

static ix_status sweep(ix_ctx *ctx, const ix_sweep *s, ix_mv *t[8], ix_mv **out)
{
    double *nodes;
    frame3 *f;
    int n;

    IX_TRY(prepare_axis(ctx, s, t));
    IX_TRY(prepare_sections(ctx, s, &t[4]));
    n = t[3]->dirs[0].length;
    IX_SCRATCH(ctx, nodes, n);
    IX_SCRATCH(ctx, f, n);
    ix_knots_nodes(&t[3]->dirs[0], nodes);
    if (s->frame == IX_FRAME_MINIMAL) {
        IX_TRY(minimal_frames(ctx, t[3], nodes, n, f));
    } else {
        if (s->frame == IX_FRAME_CURVE)
            IX_TRY(ix_mv_coerce(ctx, s->field, 3, s->field->rational, &t[5]));
        IX_TRY(binormal_frames(ctx, s, t[3], t[5], nodes, n, f));
    }
    IX_TRY(ix__mv_plain2(ctx, t[3], t[4], &t[6], &t[7]));
    return assemble(ctx, s, t[6], t[7], nodes, f, out);
}

static ix_status check(ix_ctx *ctx, const ix_sweep *s)
{
    if (s->nsections < 1)
        return IX_FAIL(ctx, IX_EARG, "no cross section");
    if (s->axis->ndirs != 1 || s->axis->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG, "the axis is no space curve");
    for (int i = 0; i < s->nsections; i++)
        if (s->sections[i]->ndirs != 1 || s->sections[i]->ncoords > 3)
            return IX_FAIL(ctx, IX_EARG, "section %d is no space curve", i + 1);
    if (s->scale && s->scale->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG, "the scale is no curve");
    if (s->frame == IX_FRAME_CURVE && s->field->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG, "the binormals are no curve");
    if (s->refine < 0 || s->refine > 10000)
        return IX_FAIL(ctx, IX_EARG, "refinement %d is not in 0 .. 10000",
                       s->refine);
    return IX_OK;
}

ix_status ix_srf_sweep(ix_ctx *ctx, const ix_sweep *s, ix_mv **out)
{
    ix_mv *t[8] = {NULL};
    ix_status st;
    ix_mark mk;

    *out = NULL;
    IX_TRY(check(ctx, s));
    mk = ix__scratch_mark(ctx);
    st = sweep(ctx, s, t, out);
    ix__mv_unref_all(ctx, t, 8);
    ix__scratch_release(ctx, mk);
    return st;
}
