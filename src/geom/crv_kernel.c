/* crv_kernel.c - the tangent lines of a planar curve, turned by an angle, as
 * the zero set of a function that is linear in x and y. */
#include "iritx/kernel.h"

#include <math.h>
#include <string.h>

#include "geom/crvs.h"
#include "geom/lines.h"
#include "geom/parts.h"
#include "geom/path.h"
#include "geom/pool.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"

/* The curve's box, enlarged. */
static ix_status box_of(ix_ctx *ctx, const ix_mv *c, double lo[2], double hi[2])
{
    double a[IX_MAX_COORDS], b[IX_MAX_COORDS];

    IX_TRY(ix_mv_bbox(ctx, c, a, b));
    for (int k = 0; k < 2; k++) {
        lo[k] = a[k] - 1;
        hi[k] = b[k] + 1;
    }
    return IX_OK;
}

/* --- the field -------------------------------------------------------------
 */

/* X x D, w D_y, w D_x: (X - w p) x D = [0] - p_x [1] + p_y [2], with D the
 * turned tangent direction X' w - X w'. */
static void parts(ix_pool *q, const ix_mv *c, double gamma, const ix_mv *out[3])
{
    const ix_mv *x[2], *d[2], *t[2], *w = NULL;
    double cs = cos(gamma), sn = sin(gamma);

    if (c->rational)
        w = ix__pool_axis(q, c, 0);
    for (int k = 0; k < 2; k++) {
        x[k] = ix__pool_axis(q, c, c->rational + k);
        d[k] = w ? ix__pool_wronskian(q, x[k], w, 0)
                 : ix__pool_derive(q, x[k], 0);
    }
    t[0] = ix__pool_sub(q, ix__pool_scale(q, d[0], cs),
                        ix__pool_scale(q, d[1], sn));
    t[1] = ix__pool_add(q, ix__pool_scale(q, d[0], sn),
                        ix__pool_scale(q, d[1], cs));
    out[0] = ix__pool_sub(q, ix__pool_mul(q, x[0], t[1]),
                          ix__pool_mul(q, x[1], t[0]));
    out[1] = w ? ix__pool_mul(q, w, t[1]) : t[1];
    out[2] = w ? ix__pool_mul(q, w, t[0]) : t[0];
}

/* The three curves on one representation become 2 x 2 x n control values. */
static ix_status fill(ix_ctx *ctx, ix_mv *const f[3], const double lo[2],
                      const double hi[2], ix_mv **out)
{
    ix_dir dirs[3];
    ix_mv *m;

    for (int k = 0; k < 2; k++)
        dirs[k] = ix__dir_linear(f[0]->dirs[0].basis == IX_BEZIER);
    dirs[2] = f[0]->dirs[0];
    IX_TRY(ix__mv_alloc(ctx, 3, dirs, 1, false, &m));
    for (size_t i = 0; i < m->npts; i++) {
        double px = i & 1 ? hi[0] : lo[0], py = i & 2 ? hi[1] : lo[1];
        size_t k = i / 4;

        m->pts[i] = f[0]->pts[k] - px * f[1]->pts[k] + py * f[2]->pts[k];
    }
    *out = m;
    return IX_OK;
}

ix_status ix_crv_kernel_field(ix_ctx *ctx, const ix_mv *crv, double gamma,
                              double lo[2], double hi[2], ix_mv **out)
{
    ix_pool q = {.ctx = ctx};
    const ix_mv *f[3] = {NULL};
    ix_mv *same[3] = {NULL}, *c;

    *out = NULL;
    IX_TRY(ix__check_planar(ctx, crv));
    IX_TRY(box_of(ctx, crv, lo, hi));
    IX_TRY(ix_mv_to_open(ctx, crv, &c));
    parts(&q, c, gamma, f);
    if (q.st == IX_OK)
        q.st = ix__mv_compatible_all(ctx, 3, f, IX_SAME_ALL, same);
    if (q.st == IX_OK)
        q.st = fill(ctx, same, lo, hi, out);
    ix__mv_unref_all(ctx, same, 3);
    ix_mv_unref(ctx, c);
    ix__pool_free(&q);
    return q.st;
}

ix_status ix_crv_kernel_envelope(ix_ctx *ctx, const ix_mv *crv, double gamma,
                                 double tol, ix_solution_curves *out)
{
    ix_equation eq[2] = {{.rel = IX_EQUAL_ZERO}, {.rel = IX_EQUAL_ZERO}};
    const ix_curves_opts o = {.tol = tol};
    double lo[2], hi[2];
    ix_mv *f, *ft = NULL;
    ix_status st;

    *out = (ix_solution_curves){.unknowns = 0};
    IX_TRY(ix_crv_kernel_field(ctx, crv, gamma, lo, hi, &f));
    st = ix_sym_derive(ctx, f, 2, NULL, &ft);
    eq[0].f = f;
    eq[1].f = ft;
    if (st == IX_OK)
        st = ix_solve_curves(ctx, 2, eq, &o, out);
    ix_mv_unref(ctx, f);
    ix_mv_unref(ctx, ft);
    return st;
}

/* --- the lines themselves
 * ---------------------------------------------------- */

/* The part of the line p + r d inside the box; false if there is none. */
static bool clip(const double p[2], const double d[2], const double lo[2],
                 const double hi[2], double q[2][3])
{
    double r[2] = {-HUGE_VAL, HUGE_VAL};

    for (int k = 0; k < 2; k++) {
        double a = (lo[k] - p[k]) / d[k], b = (hi[k] - p[k]) / d[k];

        if (!(d[k] < 0 || d[k] > 0)) {
            if (!(p[k] >= lo[k] && p[k] <= hi[k]))
                return false;
            continue;
        }
        r[0] = fmax(r[0], fmin(a, b));
        r[1] = fmin(r[1], fmax(a, b));
    }
    for (int e = 0; e < 2; e++)
        for (int k = 0; k < 2; k++)
            q[e][k] = p[k] + r[e] * d[k];
    return r[0] < r[1] && isfinite(r[0]) && isfinite(r[1]);
}

/* The line of parameter t, turned; false if it misses the box. */
static bool line_at(const ix_path *c, int span, double t, double gamma,
                    const double lo[2], const double hi[2], double q[2][3])
{
    double d[2][3], u[3], turned[2], cs = cos(gamma), sn = sin(gamma);

    ix__path_derivs3(c, span, t, 0, d);
    if (!ix__path_tangent3(c, span, t, t >= c->breaks[span + 1], u))
        return false;
    turned[0] = cs * u[0] - sn * u[1];
    turned[1] = sn * u[0] + cs * u[1];
    q[0][2] = q[1][2] = t;
    return clip(d[0], turned, lo, hi, q);
}

static void put_quad(ix_lines *out, double (*a)[3], double (*b)[3])
{
    double(*p)[3] = out->pt + 4 * (size_t)out->n;

    memcpy(p[0], a[0], sizeof p[0]);
    memcpy(p[1], a[1], sizeof p[1]);
    memcpy(p[2], b[1], sizeof p[2]);
    memcpy(p[3], b[0], sizeof p[3]);
    out->count[out->n++] = 4;
}

static ix_status sheet(ix_ctx *ctx, const ix_mv *crv, double gamma, int lines,
                       ix_lines *out)
{
    double lo[2], hi[2], q[2][2][3];
    ix_path c;

    IX_TRY(box_of(ctx, crv, lo, hi));
    IX_TRY(ix__path_new(ctx, crv, &c));
    IX_TRY(ix__lines_new(ctx, 4 * (size_t)c.nspans * (size_t)(lines - 1), out));
    for (int s = 0; s < c.nspans; s++) {
        bool before = false;

        for (int i = 0; i < lines; i++) {
            double a = c.breaks[s], b = c.breaks[s + 1];
            double t = i == lines - 1 ? b : a + (b - a) * i / (lines - 1);
            bool now = line_at(&c, s, t, gamma, lo, hi, q[i % 2]);

            if (now && before)
                put_quad(out, q[1 - i % 2], q[i % 2]);
            before = now;
        }
    }
    return IX_OK;
}

ix_status ix_crv_kernel_sheet(ix_ctx *ctx, const ix_mv *crv, double gamma,
                              int lines, ix_lines *out)
{
    *out = (ix_lines){0};
    IX_TRY(ix__check_planar(ctx, crv));
    if (lines < 2 || lines > 1 << 20)
        return IX_FAIL(ctx, IX_EARG, "%d lines on a span; 2 or more are wanted",
                       lines);
    IX_RETURN_SCOPED(ctx, sheet(ctx, crv, gamma, lines, out));
}

/* --- the surface -----------------------------------------------------------
 */

/* C + r (C' + g J C'), J clockwise, at a height. */
static ix_status boundary(ix_ctx *ctx, const ix_mv *c, const ix_mv *d, double g,
                          double r, ix_mv **out)
{
    const double m[16] = {r, -r * g, 0, 0, r * g, r, 0, 0,
                          0, 0,      0, 0, 0,     0, 0, 1};
    const double up[16] = {1, 0, 0, 0, 0, 1, 0,       0,
                           0, 0, 0, 0, 0, 0, fabs(g), 1};
    ix_mv *part[3] = {NULL};
    ix_status st = ix_mv_transform(ctx, d, m, &part[0]);

    if (st == IX_OK)
        st = ix_sym_add(ctx, c, part[0], NULL, &part[1]);
    if (st == IX_OK)
        st = ix_mv_coerce(ctx, part[1], 3, part[1]->rational, &part[2]);
    if (st == IX_OK)
        st = ix_mv_transform(ctx, part[2], up, out);
    ix__mv_unref_all(ctx, part, 3);
    return st;
}

ix_status ix_crv_kernel_surface(ix_ctx *ctx, const ix_mv *crv, double gamma,
                                double extent, ix_mv **out)
{
    ix_mv *part[4] = {NULL};
    double g = tan(gamma);
    ix_status st;

    *out = NULL;
    IX_TRY(ix__check_planar(ctx, crv));
    if (!(extent > 0) || !(fabs(cos(gamma)) > 1e-12))
        return IX_FAIL(ctx, IX_EARG,
                       "extent %g, gamma %g radians: a positive extent and no "
                       "right angle are wanted",
                       extent, gamma);
    st = ix_mv_coerce(ctx, crv, 2, crv->rational, &part[0]);
    if (st == IX_OK)
        st = ix_sym_derive(ctx, part[0], 0, NULL, &part[1]);
    for (int e = 0; st == IX_OK && e < 2; e++)
        st = boundary(ctx, part[0], part[1], g, e ? extent : -extent,
                      &part[2 + e]);
    if (st == IX_OK)
        st = ix_srf_ruled(ctx, part[2], part[3], out);
    ix__mv_unref_all(ctx, part, 4);
    return st;
}
