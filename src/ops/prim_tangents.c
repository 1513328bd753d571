/* prim_tangents.c - the bisector of two cylinders or cones.
 *
 * At a point C of the circle on the axis, T its tangent and N the unit normal
 * of the surface, both rational, a centre B of a sphere that touches the
 * surface along the ruling of C satisfies
 *
 *   T1.B = T1.C1    T2.B = T2.C2    (N1 - N2).B = C1.N1 - C2.N2
 *
 * With rows of four columns t = (T, T.C) and n = (N, C.N), over the weight w,
 * (B, -1) is the vector of minors of the rows t1, t2, w2 n1 - w1 n2. Each minor
 * is a sum of products of the minors of (t1, n1) by w2 t2, and of w1 t1 by the
 * minors of (t2, n2). */
#include <limits.h>
#include <math.h>

#include "bern/bern.h"
#include "geom/angle.h"
#include "geom/vec3.h"
#include "ops/curve.h"
#include "ops/prim.h"
#include "sym/outer.h"

enum { NMINORS = 6, NROWS = 10, NTERMS = 24 };

/* a p + b q + c w for the rows p, q of a planar form and vectors a, b, c. */
static ix_status spread(ix_ctx *ctx, const ix_form *f, const ix_form *w,
                        double v[3][4], ix_form *out)
{
    ix_form k, part, one;

    for (int i = 0; i < 3; i++) {
        one = i < 2 ? ix__form_rows(f, i, 1) : *w;
        IX_TRY(ix__form_constant(ctx, &one, 4, v[i], &k));
        IX_TRY(ix__form_mul(ctx, &k, &one, i ? &part : out));
        if (i)
            IX_TRY(ix__form_add(ctx, out, 1, &part, out));
    }
    return IX_OK;
}

/* The fourth column of a vector: its product with the point. */
static void with_product(const double v[3], const double at[3], double extra,
                         double out[4])
{
    for (int k = 0; k < 3; k++)
        out[k] = v[k];
    out[3] = ix__dot3(v, at) + extra;
}

/* Rows 0 .. 5 the minors of (t, n), 6 .. 9 w t. */
static ix_status rows_of(ix_ctx *ctx, const ix_mv *circle, const ix_prim *p,
                         const double origin[3], ix_form *out)
{
    bool cone = p->kind == IX_PRIM_CONE;
    double a = cone ? IX__RADIANS(p->degrees) : 0.0, at[3], v[3][4];
    const ix_form *rows[2], *parts[2];
    ix_form t, n, minors, wt, x;
    ix_prim_axes e;
    ix_curve c;

    IX_TRY(ix__prim_axes(ctx, p, &e));
    IX_TRY(ix__curve_load(ctx, circle, IX__CURVE_FLAT, true, &c));
    IX_TRY(ix__form_copy(ctx, &c.p, &x));
    ix__form_times(&x, ldexp(1.0, c.frame.exp));
    ix__sub3(p->pos, origin, at);
    with_product(e.x, at, 0, v[0]);
    with_product(e.y, at, 0, v[1]);
    for (int k = 0; k < 4; k++)
        v[2][k] = 0.0;
    IX_TRY(spread(ctx, &c.d, &c.w, v, &t));
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 4; k++)
            v[i][k] *= cos(a);
    with_product(e.z, at, 0, v[2]);
    for (int k = 0; k < 4; k++)
        v[2][k] *= -sin(a);
    v[2][3] += cone ? 0.0 : p->radius;
    IX_TRY(spread(ctx, &x, &c.w, v, &n));
    rows[0] = &t;
    rows[1] = &n;
    IX_TRY(ix__form_all_minors(ctx, 2, rows, &minors));
    IX_TRY(ix__form_mul(ctx, &t, &c.w, &wt));
    parts[0] = &minors;
    parts[1] = &wt;
    return ix__form_join(ctx, 2, parts, out);
}

/* Minor of columns a < b among 01 02 03 12 13 23. */
static int minor_row(int a, int b)
{
    return a == 0 ? b - 1 : a + b;
}

/* det without column j of the rows t1, t2, w2 n1 - w1 n2, times f: -(t1, n1 |
 * w2 t2) - (w1 t1 | t2, n2). */
static void expand(int row, int without, double f, ix_outer_term *out)
{
    int c[3], n = 0;

    for (int j = 0; j < 4; j++)
        if (j != without)
            c[n++] = j;
    for (int k = 0; k < 3; k++) {
        int pair = minor_row(c[k == 0], c[k == 2 ? 1 : 2]);
        double sign = k == 1 ? -1.0 : 1.0;

        out[2 * k] = (ix_outer_term){row, pair, NMINORS + c[k], -f * sign};
        out[2 * k + 1] = (ix_outer_term){row, NMINORS + c[k], pair, -f * sign};
    }
}

/* Positive sum of weights, largest in [1/2, 1), moved to the user's origin. */
static void finish(ix_mv *s, const double origin[3])
{
    double sum = 0.0, f;
    int e;

    for (size_t i = 0; i < s->npts; i++)
        sum += s->pts[i];
    (void)frexp(ix__bern_largest(s->npts, s->pts), &e);
    f = ldexp(sum < 0.0 ? -1.0 : 1.0, -e);
    for (size_t i = 0; i < 4 * s->npts; i++)
        s->pts[i] *= f;
    for (size_t k = 0; k < 3; k++)
        for (size_t i = 0; i < s->npts; i++)
            s->pts[(k + 1) * s->npts + i] += origin[k] * s->pts[i];
}

static ix_status check_weight(ix_ctx *ctx, const ix_mv *s, double size)
{
    double big = ix__bern_largest(s->npts, s->pts);

    if (big > 1e-13 * size)
        return IX_OK;
    return IX_FAIL(ctx, IX_EDOMAIN,
                   "the axes are parallel (the weight is at most %.3g of its "
                   "terms): the bisector is a cylinder over that of two "
                   "circles",
                   big / size);
}

static ix_status build(ix_ctx *ctx, const ix_mv *circle, const ix_prim *a,
                       const ix_prim *b, ix_mv **out)
{
    ix_outer_term terms[NTERMS];
    ix_sym_opts so = {INT_MAX, 0};
    ix_form f[2];
    ix_outer sum = {&f[0], &f[1], 4, NTERMS, terms};
    double size[4];
    ix_dir dirs[2];
    ix_mv *s;
    ix_status st;

    IX_TRY(rows_of(ctx, circle, a, a->pos, &f[0]));
    IX_TRY(rows_of(ctx, circle, b, a->pos, &f[1]));
    /* (B, -1) ~ (m0, -m1, m2, -m3) */
    expand(0, 3, 1.0, terms);
    expand(1, 0, 1.0, terms + 6);
    expand(2, 1, -1.0, terms + 12);
    expand(3, 2, 1.0, terms + 18);
    IX_TRY(ix__outer_dirs(ctx, &sum, &so, dirs));
    IX_TRY(ix__mv_alloc(ctx, 2, dirs, 3, true, &s));
    st = ix__outer_points(ctx, &sum, s->dirs, s->pts, size);
    if (st == IX_OK)
        st = check_weight(ctx, s, size[0]);
    if (st != IX_OK) {
        ix_mv_unref(ctx, s);
        return st;
    }
    finish(s, a->pos);
    *out = s;
    return IX_OK;
}

ix_status ix__prim_tangents(ix_ctx *ctx, const ix_prim *a, const ix_prim *b,
                            ix_mv **out)
{
    static const double zero[3] = {0, 0, 0};
    ix_mv *circle, *unit;
    ix_status st;

    IX_TRY(ix_circle(ctx, zero, 1.0, &circle));
    st = ix_mv_reparam(ctx, circle, 0, 0.0, 1.0, &unit);
    ix_mv_unref(ctx, circle);
    IX_TRY(st);
    st = build(ctx, unit, a, b, out);
    ix_mv_unref(ctx, unit);
    return st;
}
