/* pt_crv_special.c - the special points of a curve and a point q, at which
 * their untrimmed bisector changes its kind.
 *
 * The curve inverted at q, y = (x - q) / |x - q|^2, is dual to the bisector:
 * its tangent lines are the points b (b.y = 1/2 for b seen from q). So cusps of
 * the bisector are its inflections, self-intersections its bitangents, points
 * at infinity its tangents through the origin, which are those of the curve
 * through q. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"
#include "iritx/distance.h"
#include "iritx/ops_crv.h"
#include "iritx/ops_plane.h"
#include "mv/mv.h"
#include "ops/lift.h"

/* --- the inverted curve ----------------------------------------------------
 */

static ix_status inverted(ix_ctx *ctx, const ix_mv *crv, const double q[2],
                          ix_mv **out)
{
    ix_frame frame;
    ix_form f, lift, p, r2, y;
    const ix_form *const parts[2] = {&r2, &p};

    IX_TRY(ix__frame_of(ctx, 1, &crv, &frame));
    frame.shift[0] = q[0];
    frame.shift[1] = q[1];
    IX_TRY(ix__forms_load(ctx, 1, &crv, &frame, &f));
    IX_TRY(ix__lift(ctx, &f, crv->rational, &lift));
    p = ix__form_rows(&lift, 0, 2);
    r2 = ix__form_rows(&lift, 3, 1);
    IX_TRY(ix__form_join(ctx, 2, parts, &y));
    return ix__form_store(ctx, &y, true, NULL, out);
}

/* --- the list --------------------------------------------------------------
 */

typedef struct {
    ix_ctx *ctx;
    const ix_mv *crv;
    double q[2];
    int n, room;
    ix_pt_crv_special *s; /* scratch */
} collector;

static ix_status add(collector *k, ix_pt_crv_mark mark, double t, double other)
{
    IX_GROW(k->ctx, k->s, k->n, k->room);
    k->s[k->n++] = (ix_pt_crv_special){mark, t, other, {0, 0}};
    return IX_OK;
}

/* Both ends of an interval. */
static ix_status add_roots(collector *k, ix_pt_crv_mark simple,
                           ix_pt_crv_mark even, const ix_root *r, int n)
{
    for (int i = 0; i < n; i++) {
        ix_pt_crv_mark mark = r[i].kind == IX_ROOT_SIMPLE ? simple : even;

        if (r[i].kind == IX_ROOT_JUMP)
            mark = simple;
        if (r[i].kind == IX_ROOT_INTERVAL) {
            IX_TRY(add(k, mark, r[i].lo, r[i].lo));
            IX_TRY(add(k, mark, r[i].hi, r[i].hi));
        } else {
            IX_TRY(add(k, mark, r[i].t, r[i].t));
        }
    }
    return IX_OK;
}

static ix_status inflections(collector *k, const ix_mv *crv,
                             ix_pt_crv_mark simple, ix_pt_crv_mark even)
{
    ix_root *r;
    ix_status st;
    int n;

    IX_TRY(ix_crv_inflections(k->ctx, crv, &r, &n));
    st = add_roots(k, simple, even, r, n);
    ix_roots_free(k->ctx, r, n);
    return st;
}

static ix_status class_points(collector *k)
{
    const double p[3] = {k->q[0], k->q[1], 0.0};
    ix_root *r;
    ix_status st;
    int n;

    IX_TRY(ix_crv_tangents_from(k->ctx, k->crv, p, &r, &n));
    st = add_roots(k, IX_CLASS_POINT, IX_CLASS_POINT, r, n);
    ix_roots_free(k->ctx, r, n);
    return st;
}

static ix_status poles(collector *k)
{
    ix_root *r;
    ix_status st;
    int n;

    if (!k->crv->rational || !ix_mv_has_poles(k->crv))
        return IX_OK;
    IX_TRY(ix_roots(k->ctx, k->crv, 0, NULL, &r, &n));
    st = add_roots(k, IX_CURVE_POLE, IX_CURVE_POLE, r, n);
    ix_roots_free(k->ctx, r, n);
    return st;
}

/* --- crossings -------------------------------------------------------------
 */

/* The point of the untrimmed bisector, NaN where there is none. */
static void point_at(const collector *k, double t, double b[2])
{
    double d[4], v[2], n[2], f;

    b[0] = b[1] = (double)NAN;
    if (ix_mv_curve_derivs(k->ctx, k->crv, t, 1, d) != IX_OK)
        return;
    for (int i = 0; i < 2; i++)
        v[i] = k->q[i] - d[i];
    n[0] = -d[3];
    n[1] = d[2];
    f = (v[0] * v[0] + v[1] * v[1]) / (2.0 * (v[0] * n[0] + v[1] * n[1]));
    for (int i = 0; i < 2; i++)
        b[i] = d[i] + f * n[i];
}

/* Newton steps on b(t0) = b(t1), the slopes by differences: the bitangents of
 * the inverted curve carry the rounding of its high degree, which the points
 * themselves do not. Steps that are not small are not taken. */
static void sharpen(const collector *k, double *t)
{
    double dom[2], h, g[2][2], e[2], x[2][2], det, step[2];

    ix_mv_domain(k->crv, 0, dom);
    h = 1e-6 * (dom[1] - dom[0]);
    for (int i = 0; i < 2; i++) {
        if (!(t[i] - h > dom[0] && t[i] + h < dom[1]))
            return;
    }
    for (int round = 0; round < 2; round++) {
        for (int i = 0; i < 2; i++) {
            point_at(k, t[i] - h, x[0]);
            point_at(k, t[i] + h, x[1]);
            for (int c = 0; c < 2; c++)
                g[c][i] = (i ? -1.0 : 1.0) * (x[1][c] - x[0][c]) / (2.0 * h);
        }
        point_at(k, t[0], x[0]);
        point_at(k, t[1], x[1]);
        for (int c = 0; c < 2; c++)
            e[c] = x[0][c] - x[1][c];
        det = g[0][0] * g[1][1] - g[0][1] * g[1][0];
        step[0] = (e[0] * g[1][1] - e[1] * g[0][1]) / det;
        step[1] = (g[0][0] * e[1] - g[1][0] * e[0]) / det;
        if (!(fabs(step[0]) + fabs(step[1]) <= h))
            return;
        t[0] -= step[0];
        t[1] -= step[1];
    }
}

/* A pair of the same point of the curve (it touches itself) is no crossing. */
static ix_status distinct(collector *k, const double *t, bool *out)
{
    double x[2][2], size = 0.0;

    for (int i = 0; i < 2; i++) {
        IX_TRY(ix_mv_point(k->ctx, k->crv, &t[i], x[i]));
        size = fmax(size, hypot(x[i][0] - k->q[0], x[i][1] - k->q[1]));
    }
    *out = hypot(x[0][0] - x[1][0], x[0][1] - x[1][1]) > 1e-9 * size;
    return IX_OK;
}

/* Is the pair in the list? One that the solver could not tell apart from
 * itself across a boundary of boxes comes twice. */
static bool known(const collector *k, const double *t)
{
    double dom[2];

    ix_mv_domain(k->crv, 0, dom);
    for (int i = 0; i < k->n; i++)
        if (k->s[i].mark == IX_CROSSING &&
            fabs(k->s[i].t - t[0]) + fabs(k->s[i].other - t[1]) <=
                1e-9 * (dom[1] - dom[0]))
            return true;
    return false;
}

static ix_status add_crossings(collector *k, const ix_solutions *s)
{
    for (int i = 0; i < s->n; i++) {
        double t[2] = {s->sol[i].x[0], s->sol[i].x[1]};
        bool two;

        sharpen(k, t);
        if (known(k, t))
            continue;
        IX_TRY(distinct(k, t, &two));
        if (!two)
            continue;
        IX_TRY(add(k, IX_CROSSING, t[0], t[1]));
        IX_TRY(add(k, IX_CROSSING, t[1], t[0]));
    }
    return IX_OK;
}

static ix_status crossings(collector *k, const ix_mv *inv)
{
    ix_solutions s;
    ix_status st;

    IX_TRY(ix_crv_bitangents(k->ctx, inv, &s));
    st = add_crossings(k, &s);
    ix_solutions_free(k->ctx, &s);
    return st;
}

static ix_status from_inverted(collector *k)
{
    ix_mv *inv;
    ix_status st;

    IX_TRY(inverted(k->ctx, k->crv, k->q, &inv));
    st = inflections(k, inv, IX_CUSP, IX_EXTRAORDINARY);
    if (st == IX_OK)
        st = crossings(k, inv);
    ix_mv_unref(k->ctx, inv);
    return st;
}

static int by_parameter(const void *a, const void *b)
{
    const ix_pt_crv_special *x = a, *y = b;

    if (x->t != y->t)
        return x->t < y->t ? -1 : 1;
    return (int)x->mark - (int)y->mark;
}

/* The points of the bisector; NaN at infinity. */
static void locate(collector *k, ix_pt_crv_special *s)
{
    s->b[0] = s->b[1] = (double)NAN;
    if (s->mark != IX_CLASS_POINT && s->mark != IX_CURVE_POLE)
        point_at(k, s->t, s->b);
}

static ix_status run(ix_ctx *ctx, const ix_mv *crv, const double q[2],
                     ix_pt_crv_special **out, int *n)
{
    collector k = {.ctx = ctx, .crv = crv, .q = {q[0], q[1]}};

    IX_TRY(inflections(&k, crv, IX_INFLECTION, IX_INFLECTION));
    IX_TRY(class_points(&k));
    IX_TRY(poles(&k));
    IX_TRY(from_inverted(&k));
    if (k.n == 0)
        return IX_OK;
    qsort(k.s, (size_t)k.n, sizeof *k.s, by_parameter);
    for (int i = 0; i < k.n; i++)
        locate(&k, &k.s[i]);
    *out = ix__alloc(ctx, (size_t)k.n * sizeof **out);
    if (!*out)
        return IX_ENOMEM;
    memcpy(*out, k.s, (size_t)k.n * sizeof **out);
    *n = k.n;
    return IX_OK;
}

static ix_status scoped(ix_ctx *ctx, const ix_mv *crv, const double q[2],
                        ix_pt_crv_special **out, int *n)
{
    ix_mv *flat;
    ix_status st;

    if (crv->ndirs != 1 || crv->ncoords < 2)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates: a curve with at "
                       "least two is needed",
                       crv->ndirs, crv->ncoords);
    if (!isfinite(q[0]) || !isfinite(q[1]))
        return IX_FAIL(ctx, IX_EARG, "the point (%g, %g) is not finite", q[0],
                       q[1]);
    IX_TRY(ix_mv_coerce(ctx, crv, 2, crv->rational, &flat));
    st = run(ctx, flat, q, out, n);
    ix_mv_unref(ctx, flat);
    return st;
}

ix_status ix_pt_crv_specials(ix_ctx *ctx, const ix_mv *crv, const double q[2],
                             ix_pt_crv_special **out, int *n)
{
    *out = NULL;
    *n = 0;
    IX_RETURN_SCOPED(ctx, scoped(ctx, crv, q, out, n));
}

void ix_pt_crv_specials_free(ix_ctx *ctx, ix_pt_crv_special *s, int n)
{
    ix__free(ctx, s, (size_t)n * sizeof *s);
}
