/* plane_bisector.c - pieces of bisectors from runs: vertices in the user's
 * coordinates, feet as the user's parameters. */
#include <math.h>
#include <string.h>

#include "geom/parts.h"
#include "mv/mv.h"
#include "ops/plane_bisector.h"

/* Unbounded pieces end beyond this distance from the middle of the objects,
 * whose size is 1. */
#define REACH 16.0

void ix_bisector_free(ix_ctx *ctx, ix_bisector *b)
{
    for (int i = 0; i < b->n; i++)
        ix_mv_unref(ctx, b->piece[i].exact);
    ix__free(ctx, b->piece, b->bytes);
    *b = (ix_bisector){0};
}

ix_status ix__bisector_tol(ix_ctx *ctx, double tol, double *out)
{
    if (!(tol >= 0.0 && isfinite(tol)))
        return IX_FAIL(ctx, IX_EARG,
                       "a tolerance of %g: positive, or 0 for "
                       "1e-4",
                       tol);
    *out = tol > 0.0 ? tol : 1e-4;
    return IX_OK;
}

ix_status ix__plane_check(ix_ctx *ctx, int n, const ix_mv *const *crv)
{
    for (int i = 0; i < n; i++)
        if (crv[i]->ndirs != 1 || crv[i]->ncoords < 2)
            return IX_FAIL(ctx, IX_EARG,
                           "operand %d has %d directions and %d coordinates: "
                           "a curve with at least two is needed",
                           i + 1, crv[i]->ndirs, crv[i]->ncoords);
    return IX_OK;
}

ix_status ix__plane_curves(ix_ctx *ctx, int n, const ix_mv *const *crv,
                           ix_mv ***out)
{
    ix_mv **m;

    IX_TRY(ix__plane_check(ctx, n, crv));
    IX_SCRATCH_ZERO(ctx, m, n);
    for (int i = 0; i < n; i++) {
        ix_status st = ix_mv_coerce(ctx, crv[i], 2, crv[i]->rational, &m[i]);

        if (st != IX_OK) {
            ix__mv_unref_all(ctx, m, i);
            return st;
        }
    }
    *out = m;
    return IX_OK;
}

/* --- vertices --------------------------------------------------------------
 */

typedef struct {
    ix_ctx *ctx;
    const ix__walked *w;
    const ix__object *obj;
    const ix_frame *frame;
    double *data; /* what is left of the block for vertices */
} maker;

/* Samples of a run that become vertices: [first, end). */
typedef struct {
    int first, end;
} part;

/* Is s, towards an unbounded end, beyond the reach, and not that of the other
 * end, from which something has to be left? */
static bool beyond(const ix__sample *s, const ix__sample *end)
{
    return !(hypot(s->b[0], s->b[1]) <= REACH) &&
           hypot(s->b[0] - end->b[0], s->b[1] - end->b[1]) >
               1e-3 * hypot(end->b[0], end->b[1]);
}

/* Unbounded ends keep one sample beyond the reach. */
static part within_reach(const maker *k, const ix__run *r)
{
    part p = {0, r->count};

    while (r->far[0] && p.first + 2 < p.end &&
           beyond(ix__run_at(k->w, r, p.first + 1),
                  ix__run_at(k->w, r, r->count - 1)))
        p.first++;
    while (r->far[1] && p.end - 2 > p.first &&
           beyond(ix__run_at(k->w, r, p.end - 2), ix__run_at(k->w, r, p.first)))
        p.end--;
    return p;
}

double ix__own_parameter(const ix__set *s, const ix__sample *a)
{
    const ix__border *e = &s->border[a->border];

    if (e->kind == IX__FAN)
        return s->vertex[e->index].t;
    return ix__span_parameter(&s->span[e->index],
                              e->side > 0 ? a->at : 1.0 - a->at);
}

/* A circle that touches at a vertex is as good, within the depth that cannot be
 * told from nothing, as one that touches this far beside it: there the foot
 * changes from the curve to the vertex. */
#define AT_VERTEX 1e-6
/* Not so where the circle is small itself: at a common end or a crossing. */
#define SMALL_CIRCLE 1e-3

double ix__other_parameter(const ix__set *s, const ix__sample *a)
{
    const ix__span *sp = &s->span[a->foot.span];
    double u = a->foot.u;

    if (a->vertex >= 0)
        return s->vertex[a->vertex].t;
    if (u < AT_VERTEX && sp->vertex[0] >= 0 && a->r > SMALL_CIRCLE)
        u = 0.0;
    if (u > 1.0 - AT_VERTEX && sp->vertex[1] >= 0 && a->r > SMALL_CIRCLE)
        u = 1.0;
    return ix__span_parameter(sp, u);
}

static void to_user(const ix_frame *f, const double in[2], double out[2])
{
    for (int k = 0; k < 2; k++)
        out[k] = ldexp(in[k], f->exp) + f->shift[k];
}

static void vertices(maker *k, const ix__run *r, ix_bisector_piece *p)
{
    part q = within_reach(k, r);
    double *x = k->data, *foot, *rad;
    const ix__sample *before = NULL;
    int most = q.end - q.first, n = 0;

    foot = x + 2 * most;
    rad = foot + 2 * most;
    k->data = rad + most;
    for (int i = q.first; i < q.end; i++) {
        const ix__sample *s = ix__run_at(k->w, r, i);

        if (before && s->b[0] == before->b[0] && s->b[1] == before->b[1] &&
            i + 1 < q.end)
            continue;
        to_user(k->frame, s->b, x + 2 * n);
        foot[2 * n] = ix__own_parameter(k->obj[0].set, s);
        foot[2 * n + 1] = ix__other_parameter(k->obj[1].set, s);
        rad[n++] = ldexp(s->r, k->frame->exp);
        before = s;
    }
    p->n = n;
    p->x = x;
    p->foot = foot;
    p->r = rad;
}

/* --- pieces ----------------------------------------------------------------
 */

static void describe(const maker *k, const ix__run *r, ix_bisector_piece *p)
{
    const ix__sample *a = ix__run_at(k->w, r, 0);
    const ix__border *e = &k->obj[0].set->border[a->border];
    bool v1 = e->kind == IX__FAN, v2 = a->vertex >= 0;

    p->point[0] = v1;
    p->point[1] = v2;
    p->kind = v1 && v2   ? IX_POINT_POINT
              : v1 || v2 ? IX_POINT_CURVE
                         : IX_CURVE_CURVE;
    p->curve[0] = v1 ? k->obj[0].set->vertex[e->index].curve
                     : k->obj[0].set->span[e->index].curve;
    p->curve[1] = k->obj[1].set->span[a->foot.span].curve;
    p->side = v1 ? 0 : e->side;
    p->joined = r->joined;
    for (int i = 0; i < 2; i++) {
        const ix__sample *s = ix__run_at(k->w, r, i ? r->count - 1 : 0);

        p->unbounded[i] = r->far[i];
        memcpy(p->dir[i], s->n, sizeof s->n);
        if (!r->far[i])
            p->dir[i][0] = p->dir[i][1] = 0.0;
    }
}

/* Feet on the same points and curves? */
static bool same_objects(const ix_bisector_piece *a, const ix_bisector_piece *b)
{
    if (a->kind != b->kind)
        return false;
    for (int i = 0; i < 2; i++)
        if (a->curve[i] != b->curve[i] || a->point[i] != b->point[i] ||
            (a->point[i] && a->foot[i] != b->foot[i]))
            return false;
    return true;
}

static void count_component(ix_bisector *b)
{
    ix_bisector_piece *p = &b->piece[b->n - 1];

    p->component = b->n == 1 ? 0 : p[-1].component;
    if (b->n > 1 && !(p->joined && same_objects(p - 1, p)))
        p->component++;
}

static ix_status fill(maker *k, ix_bisector *out)
{
    for (int i = 0; i < k->w->nruns; i++) {
        const ix__run *r = &k->w->run[i];
        ix_bisector_piece *p = &out->piece[i];

        out->n = i + 1;
        describe(k, r, p);
        vertices(k, r, p);
        count_component(out);
        IX_TRY(ix__bisector_exact(k->ctx, k->w, k->obj, r, p));
    }
    return IX_OK;
}

static bool is_closed(const ix_bisector *b)
{
    const ix_bisector_piece *a, *z;
    const double *x, *y;

    if (b->n == 0)
        return false;
    a = &b->piece[0];
    z = &b->piece[b->n - 1];
    for (int i = 1; i < b->n; i++)
        if (!b->piece[i].joined)
            return false;
    if (a->unbounded[0] || z->unbounded[1])
        return false;
    x = a->x;
    y = z->x + 2 * (z->n - 1);
    return hypot(x[0] - y[0], x[1] - y[1]) <= 1e-7 * b->size;
}

ix_status ix__bisector_make(ix_ctx *ctx, const ix__walked *w,
                            const ix__object obj[2], const ix_frame *frame,
                            ix_bisector *out)
{
    maker k = {.ctx = ctx, .w = w, .obj = obj, .frame = frame};
    size_t n = (size_t)w->nruns, total = 0;
    ix_status st;

    *out = (ix_bisector){
        .size = ldexp(ix__sets_size(obj[0].set, obj[1].set), frame->exp)};
    if (n == 0)
        return IX_OK;
    for (int i = 0; i < w->nruns; i++)
        total += (size_t)w->run[i].count;
    out->bytes = n * sizeof *out->piece + 5 * total * sizeof(double);
    out->piece = ix__alloc(ctx, out->bytes);
    if (!out->piece)
        return IX_ENOMEM;
    memset(out->piece, 0, n * sizeof *out->piece);
    k.data = (double *)(void *)(out->piece + n);
    st = fill(&k, out);
    if (st != IX_OK) {
        ix_bisector_free(ctx, out);
        return st;
    }
    out->closed = is_closed(out);
    return IX_OK;
}
