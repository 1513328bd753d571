/* bisect_pt_crv.c - the true bisector of a point and a curve. */
#include <math.h>
#include <string.h>

#include "geom/parts.h"
#include "iritx/ops_plane.h"
#include "mv/mv.h"
#include "ops/plane_bisector.h"

/* Directions around the point, before any refinement. */
enum { GRID = 64 };
/* A point no farther from a curve of size 1 is on it: what evaluating the
 * curve there rounds. */
#define ON_CURVE 1e-13

typedef struct {
    ix_ctx *ctx;
    const ix_mv *crv;
    double q[2];  /* the user's */
    double at[2]; /* in the frame */
    ix_frame frame;
    ix__set curve, point;
    double tol;
} problem;

/* --- a point on the curve ---------------------------------------------------
 *
 * A point b is as far from q as from a curve through q where no other point of
 * the curve is nearer: b is on a normal at q, or between the normals at an end
 * or a corner. */

/* A circle of less curvature is a line. */
#define STRAIGHT 1e-12
/* Vertices of unbounded normals are at this many times the size. */
#define REACH 20.0

typedef struct {
    const problem *p;
    double t;     /* the parameter of q */
    double *data; /* room for ten numbers of each normal */
    ix_bisector *out;
} normals;

static ix_status exact_normal(ix_ctx *ctx, ix_bisector_piece *b)
{
    ix_dir d = {.basis = IX_BEZIER, .order = 2, .length = 2};
    bool far = b->unbounded[1];
    const double *x = b->x, *end = far ? b->dir[1] : x + 2;
    double pts[6] = {1.0, far ? 0.0 : 1.0, x[0], end[0], x[1], end[1]};

    return ix_mv_new(ctx, 1, &d, 2, true, pts, &b->exact);
}

/* The normal line's part from q to where another point is as near, kappa the
 * curvature towards n. */
static ix_status add_normal(normals *k, const double n[2], double kappa)
{
    const problem *p = k->p;
    ix_bisector_piece *b = &k->out->piece[k->out->n];
    ix__touch t = {.kappa = kappa, .span = -1};
    double *x = k->data, r;

    ix__set_touch(&p->curve, p->at, n, IX__DEPTH, &t);
    if (!isfinite(t.kappa))
        return IX_OK;
    *b = (ix_bisector_piece){.kind = IX_POINT_POINT, .n = 2};
    b->unbounded[1] = !(t.kappa > STRAIGHT);
    r = ldexp(b->unbounded[1] ? REACH : 1.0 / t.kappa, p->frame.exp);
    for (int i = 0; i < 2; i++) {
        x[i] = p->q[i];
        x[2 + i] = p->q[i] + r * n[i];
        b->dir[1][i] = b->unbounded[1] ? n[i] : 0.0;
        x[4 + 2 * i] = 0.0;
        x[5 + 2 * i] = k->t;
        b->point[i] = true;
    }
    x[8] = 0.0;
    x[9] = r;
    b->x = x;
    b->foot = x + 4;
    b->r = x + 8;
    b->joined = k->out->n > 0;
    k->data += 10;
    k->out->n++;
    return exact_normal(p->ctx, b);
}

/* The curvature at u if the curve bends towards n, else 0. */
static double curvature_towards(const ix__set *s, const ix__span *sp, double u,
                                const double n[2])
{
    double d[3][2], v2, k;

    ix__span_at(s, sp, u, d);
    v2 = d[1][0] * d[1][0] + d[1][1] * d[1][1];
    k = (d[2][0] * n[0] + d[2][1] * n[1]) / v2;
    return k > 0.0 ? k : 0.0;
}

static ix_status smooth_normals(normals *k, const ix__touch *at)
{
    const ix__set *s = &k->p->curve;
    const ix__span *sp = &s->span[at->span];
    double t[2], n[2];

    ix__span_tangent(s, sp, at->u, t);
    for (int side = -1; side <= 1; side += 2) {
        n[0] = -side * t[1];
        n[1] = side * t[0];
        IX_TRY(add_normal(k, n, curvature_towards(s, sp, at->u, n)));
    }
    return IX_OK;
}

/* The two that bound the fan of vertex v. */
static ix_status fan_normals(normals *k, int v)
{
    const ix__set *s = &k->p->curve;

    for (int i = 0; i < s->nborders; i++) {
        const ix__border *e = &s->border[i];

        if (e->kind != IX__FAN || e->index != v)
            continue;
        ix__note(k->p->ctx, "the point is an end or a corner of the curve: "
                            "between the normals all points are equally far");
        for (int j = 0; j < 2; j++) {
            double a = j ? e->to : e->from, n[2] = {cos(a), sin(a)};

            IX_TRY(add_normal(k, n, 0.0));
        }
    }
    return IX_OK;
}

static double set_size(const problem *p)
{
    return ldexp(ix__sets_size(&p->point, &p->curve), p->frame.exp);
}

static ix_status on_curve(const problem *p, const ix__touch *at,
                          ix_bisector *out)
{
    enum { MOST = 2 };
    const ix__span *sp = &p->curve.span[at->span];
    int v = at->u <= 0.0 ? sp->vertex[0] : at->u >= 1.0 ? sp->vertex[1] : -1;
    normals k = {.p = p, .t = ix__span_parameter(sp, at->u), .out = out};
    ix_status st;

    *out = (ix_bisector){.size = set_size(p)};
    out->bytes = MOST * (sizeof *out->piece + 10 * sizeof(double));
    out->piece = ix__alloc(p->ctx, out->bytes);
    if (!out->piece)
        return IX_ENOMEM;
    memset(out->piece, 0, out->bytes);
    k.data = (double *)(void *)(out->piece + MOST);
    st = v < 0 ? smooth_normals(&k, at) : fan_normals(&k, v);
    if (st != IX_OK)
        ix_bisector_free(p->ctx, out);
    return st;
}

/* --- entry -----------------------------------------------------------------
 */

static ix_status solve(problem *p, bool whole, ix_bisector *out)
{
    const ix_mv *const crv[1] = {p->crv};
    ix__set_opts o = {.carrier = whole};
    ix__walk w = {&p->point, &p->curve, p->tol, GRID, false, 0.0};
    ix__object obj[2] = {{.set = &p->point, .point = {p->q[0], p->q[1]}},
                         {.set = &p->curve, .n = 1, .crv = crv}};
    const double at[1][2] = {{p->q[0], p->q[1]}};
    ix__touch foot;
    ix__walked done;

    IX_TRY(ix__plane_frame(p->ctx, 1, crv, 1, at, &p->frame));
    for (int k = 0; k < 2; k++)
        p->at[k] = ldexp(p->q[k] - p->frame.shift[k], -p->frame.exp);
    IX_TRY(ix__set_of_point(p->ctx, p->at, &p->point));
    IX_TRY(ix__set_of_curves(p->ctx, 1, crv, &p->frame, o, &p->curve));
    if (ix__set_distance(&p->curve, p->at, &foot) <= ON_CURVE) {
        if (!p->curve.span[foot.span].phantom)
            return on_curve(p, &foot, out);
        *out = (ix_bisector){.size = set_size(p)};
        return IX_OK; /* the carrier passes through q beyond the curve */
    }
    w.size = ix__sets_size(&p->point, &p->curve);
    IX_TRY(ix__walk_all(p->ctx, &w, 0, NULL, &done));
    return ix__bisector_make(p->ctx, &done, obj, &p->frame, out);
}

static ix_status scoped(ix_ctx *ctx, const ix_mv *crv, const double q[2],
                        bool whole, double tol, ix_bisector *out)
{
    problem p = {.ctx = ctx, .q = {q[0], q[1]}};
    ix_mv **flat;
    ix_status st;

    IX_TRY(ix__bisector_tol(ctx, tol, &p.tol));
    if (!isfinite(q[0]) || !isfinite(q[1]))
        return IX_FAIL(ctx, IX_EARG, "the point (%g, %g) is not finite", q[0],
                       q[1]);
    IX_TRY(ix__plane_curves(ctx, 1, &crv, &flat));
    p.crv = flat[0];
    st = solve(&p, whole, out);
    ix__mv_unref_all(ctx, flat, 1);
    return st;
}

ix_status ix_bisect_pt_crv(ix_ctx *ctx, const ix_mv *crv, const double q[2],
                           bool whole, double tol, ix_bisector *out)
{
    *out = (ix_bisector){0};
    IX_RETURN_SCOPED(ctx, scoped(ctx, crv, q, whole, tol, out));
}
