/* meet_fields.c - see the header. Curves c[0], c[1] have the parameter u, c[2]
 * and c[3] v. */
#include "geom/meet_fields.h"

#include <string.h>

#include "geom/analytic.h"
#include "geom/unit_solve.h"
#include "geom/vec3.h"
#include "iritx/geom.h"

static ix_status check(ix_ctx *ctx, const ix_mv *const c[4])
{
    for (int i = 0; i < 4; i++) {
        const ix_mv *m = c[i];

        if (m->ndirs != 1 || m->ncoords > 3 || m->dirs[0].basis == IX_POWER)
            return IX_FAIL(ctx, IX_EARG,
                           "curve %d: %d directions and %d coordinates%s; a "
                           "Bezier or B-spline curve of at most 3 is wanted",
                           i + 1, m->ndirs, m->ncoords,
                           m->dirs[0].basis == IX_POWER ? ", power basis" : "");
    }
    return IX_OK;
}

static ix__vec load(ix_pool *q, const ix_mv *c)
{
    const ix_mv *unit = ix__pool_unit(q, c);

    return unit ? ix__vec_of(q, unit) : (ix__vec){{NULL}, NULL};
}

/* f over [0, 1]^2 becomes a function over the domains of c[0] and c[2]. */
static ix_status give(ix_pool *q, const ix_mv *f, const ix_mv *const c[4],
                      ix_mv **out)
{
    for (int d = 0; d < 2 && f && q->st == IX_OK; d++) {
        double dom[2];

        ix_mv_domain(c[2 * d], 0, dom);
        if (dom[0] < 0 || dom[0] > 0 || dom[1] < 1 || dom[1] > 1)
            f = ix__pool_made(q, ix_mv_reparam(q->ctx, f, d, dom[0], dom[1],
                                               ix__pool_room(q)));
    }
    if (q->st == IX_OK && !f)
        q->st = IX_FAIL(q->ctx, IX_EDOMAIN,
                        "the condition holds everywhere: every pair meets");
    return ix__pool_give(q, f, out);
}

/* Parameter t of c[0] or c[2] for c[i], whose domain is mapped onto theirs. */
static double mapped(const ix_mv *const c[4], int i, double t)
{
    double a[2], b[2];

    ix_mv_domain(c[i & 2], 0, a);
    ix_mv_domain(c[i], 0, b);
    return i & 1 ? b[0] + (t - a[0]) / (a[1] - a[0]) * (b[1] - b[0]) : t;
}

static ix_status point_at(ix_ctx *ctx, const ix_mv *const c[4], int i, double t,
                          double p[3])
{
    double x[IX_MAX_COORDS] = {0};

    t = mapped(c, i, t);
    IX_TRY(ix_mv_point(ctx, c[i], &t, x));
    memcpy(p, x, 3 * sizeof *p);
    return IX_OK;
}

/* --- ruled
 * ------------------------------------------------------------------- */

ix_status ix__ruled_meet_field(ix_ctx *ctx, const ix_mv *const c[4],
                               ix_mv **out)
{
    ix_pool q = {.ctx = ctx};
    ix__vec p[4], da, db, between;

    *out = NULL;
    IX_TRY(check(ctx, c));
    for (int i = 0; i < 4; i++)
        p[i] = load(&q, c[i]);
    da = ix__vec_promote(&q, ix__vec_between(&q, p[1], p[0]), 2, 0);
    db = ix__vec_promote(&q, ix__vec_between(&q, p[3], p[2]), 2, 1);
    between = ix__vec_between(&q, ix__vec_promote(&q, p[2], 2, 1),
                              ix__vec_promote(&q, p[0], 2, 0));
    return give(&q, ix__vec_dot(&q, ix__vec_cross(&q, da, db), between), c,
                out);
}

ix_status ix__ruled_meet_point(ix_ctx *ctx, const ix_mv *const c[4], double u,
                               double v, double p[3], double along[2],
                               bool *found)
{
    double x[4][3], d[2][3], on[2][3];

    *found = false;
    for (int i = 0; i < 4; i++)
        IX_TRY(point_at(ctx, c, i, i < 2 ? u : v, x[i]));
    for (int k = 0; k < 2; k++) {
        ix__sub3(x[2 * k + 1], x[2 * k], d[k]);
        if (!(ix__len3(d[k]) > 0))
            return IX_OK;
    }
    IX_TRY(ix__lines_near(ctx, x[0], d[0], x[2], d[1], on[0], on[1]));
    for (int k = 0; k < 2; k++) {
        double at[3];

        ix__sub3(on[k], x[2 * k], at);
        along[k] = ix__dot3(at, d[k]) / ix__dot3(d[k], d[k]);
    }
    for (int e = 0; e < 3; e++)
        p[e] = (on[0][e] + on[1][e]) / 2;
    /* parallel lines: their nearest points are as far apart as they are */
    *found = ix__dist3(on[0], on[1]) <=
             1e-6 * (ix__len3(d[0]) + ix__len3(d[1]) + ix__dist3(x[0], x[2]));
    return IX_OK;
}

/* --- ringed
 * ------------------------------------------------------------------ */

/* r^2 times the square of the other radius' weight. */
static const ix_mv *square(ix_pool *q, const ix_mv *r, const ix_mv *w)
{
    const ix_mv *s = ix__prod0(q, r, w);

    return ix__prod0(q, s, s);
}

static double largest(const ix_mv *m)
{
    double most = 0;

    for (size_t i = 0; m && i < m->npts; i++)
        most = fmax(most, fabs(m->pts[i]));
    return most;
}

/* Is the product of a and b zero within its rounding? */
static bool vanishes(const ix_mv *product, ix__vec a, ix__vec b)
{
    double size = 0;

    for (int k = 0; k < 3; k++)
        size = fmax(size, largest(a.x[k]) * largest(b.x[k]));
    return !(largest(product) > 1e-12 * size);
}

/* Both axes in one plane: y has one direction, and the three planes a line in
 * common where it is 0. */
static const ix_mv *one_plane(ix_pool *q, ix__vec y, ix__vec x,
                              const ix__vec t[2])
{
    double turn = 0, size = 0;
    int k = 0;

    for (int i = 0; i < 3; i++) {
        turn = fmax(turn, largest(x.x[i]));
        if (largest(y.x[i]) > largest(y.x[k]))
            k = i;
        for (int j = 0; j < 3; j++)
            size = fmax(size, largest(t[0].x[i]) * largest(t[1].x[j]));
    }
    if (q->st == IX_OK && !(turn > 1e-12 * size))
        q->st = IX_FAIL(q->ctx, IX_EUNABLE,
                        "the axes are parallel: circles lie in parallel "
                        "planes");
    return y.x[k];
}

ix_status ix__ring_meet_field(ix_ctx *ctx, const ix_mv *const c[4], ix_mv **out)
{
    ix_pool q = {.ctx = ctx};
    ix__vec p[4], t[2], d, y, x;
    const ix_mv *w, *k, *det, *r[2], *b;

    *out = NULL;
    IX_TRY(check(ctx, c));
    for (int i = 0; i < 4; i++)
        p[i] = load(&q, c[i]);
    for (int i = 0; i < 2; i++) {
        const ix_mv *rad = p[2 * i + 1].x[0], *rw = p[2 * i + 1].w;

        if (q.st == IX_OK && rw)
            q.st = IX_FAIL(ctx, IX_EARG, "radius %d is rational", i + 1);
        t[i] = ix__vec_promote(&q, ix__vec_tangent(&q, p[2 * i], 0), 2, i);
        p[2 * i] = ix__vec_promote(&q, p[2 * i], 2, i);
        r[i] = q.st == IX_OK && rad ? ix__pool_promote(&q, rad, 2, i) : NULL;
    }
    d = ix__vec_between(&q, p[2], p[0]);
    w = p[0].w && p[2].w ? ix__pool_mul(&q, p[0].w, p[2].w)
        : p[0].w         ? p[0].w
                         : p[2].w;
    for (int i = 0; i < 2; i++)
        r[i] = w ? square(&q, r[i], w) : ix__prod0(&q, r[i], r[i]);
    k = ix__diff0(&q, ix__sum0(&q, ix__vec_dot(&q, d, d), r[0]), r[1]);
    k = k ? ix__pool_scale(&q, k, 0.5) : NULL;
    x = ix__vec_cross(&q, t[0], t[1]);
    det = ix__vec_dot(&q, d, x);
    b = ix__vec_dot(&q, d, t[1]);
    y = ix__vec_cross(&q, d, t[0]);
    for (int e = 0; e < 3; e++)
        y.x[e] = ix__sum0(&q, ix__prod0(&q, y.x[e], b),
                          ix__prod0(&q, x.x[e], k));
    if (q.st == IX_OK && vanishes(det, d, x))
        return give(&q, one_plane(&q, y, x, t), c, out);
    return give(&q,
                ix__diff0(&q, ix__vec_dot(&q, y, y),
                          ix__prod0(&q, r[0], ix__prod0(&q, det, det))),
                c, out);
}

/* The common line of three planes, Y.T1 = 0 and Y.T2 = b, meets the circle
 * twice: side is -1 or 1. */
static bool on_common_line(double t[2][3], const double n[3], double b,
                           double r, int side, double y[3])
{
    double up[3], in[3], s, h;

    if (!(ix__unit3(n, up) > 1e-7))
        return false;
    ix__cross3(up, t[0], in);
    s = b / ix__dot3(in, t[1]);
    h = r * r - s * s;
    for (int e = 0; e < 3; e++)
        y[e] = s * in[e] + side * sqrt(fmax(h, 0)) * up[e];
    return h >= 0;
}

ix_status ix__ring_meet_point(ix_ctx *ctx, const ix_mv *const c[4], double u,
                              double v, int side, double p[3], bool *found)
{
    double x[4][3], t[2][3], d[3], n[3], m[3], y[3], det, k, b;

    *found = false;
    for (int i = 0; i < 4; i++)
        IX_TRY(point_at(ctx, c, i, i < 2 ? u : v, x[i]));
    IX_TRY(ix_tangent(ctx, c[0], u, true, t[0]));
    IX_TRY(ix_tangent(ctx, c[2], v, true, t[1]));
    ix__sub3(x[2], x[0], d);
    ix__cross3(t[0], t[1], n);
    ix__cross3(d, t[0], m);
    det = ix__dot3(d, n);
    b = ix__dot3(d, t[1]);
    k = (ix__dot3(d, d) + x[1][0] * x[1][0] - x[3][0] * x[3][0]) / 2;
    /* 1e-7: half of the digits of Y are left */
    if (fabs(det) > 1e-7 * ix__len3(d)) {
        *found = side > 0;
        for (int e = 0; e < 3; e++)
            y[e] = (b * m[e] + k * n[e]) / det;
    } else {
        *found = on_common_line(t, n, b, x[1][0], side, y);
    }
    for (int e = 0; *found && e < 3; e++)
        p[e] = x[0][e] + y[e];
    return IX_OK;
}
