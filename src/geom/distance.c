/* distance.c - the least and the Hausdorff distance of two freeforms by
 * branch and bound: every result is attained at the points it names and comes
 * with a proven bound of its error. */
#include <math.h>
#include <string.h>

#include "iritx/distance.h"
#include "mv/mv.h"

#define GAP      1e-12 /* relative, at which bounds count as equal */
#define MAX_WORK 4000  /* boxes; beyond it the error tells what is left */

/* A Bezier part of a freeform, its interval and its middle. */
typedef struct {
    ix_mv *m;
    double lo[2], hi[2];
    double mid[3];
} part;

typedef struct {
    part a, b; /* b unused for one-sided distances */
    double bound;
} node;

typedef struct {
    ix_ctx *ctx;
    const ix_mv *a, *b;
    node *heap; /* the most promising first */
    int n, cap;
    double sign; /* 1: the smallest bound first, -1: the largest */
    double size; /* of the input */
    ix_distance best;
} work;

static double dist(const double *p, const double *q)
{
    return sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                (p[2] - q[2]) * (p[2] - q[2]));
}

/* --- the heap
 * ------------------------------------------------------------------ */

static bool before(const work *w, const node *x, const node *y)
{
    return w->sign * x->bound < w->sign * y->bound;
}

static void drop(ix_ctx *ctx, node *x)
{
    ix_mv_unref(ctx, x->a.m);
    ix_mv_unref(ctx, x->b.m);
}

/* Takes over x, also when it fails. */
static ix_status push(work *w, node *x)
{
    int i = w->n;

    if (w->n == w->cap) {
        int cap = w->cap ? 2 * w->cap : 64;
        node *more = ix__scratch(w->ctx, (size_t)cap, sizeof *more);

        if (!more) {
            drop(w->ctx, x);
            return IX_ENOMEM;
        }
        if (w->n)
            memcpy(more, w->heap, (size_t)w->n * sizeof *more);
        w->heap = more;
        w->cap = cap;
    }
    w->n++;
    for (; i > 0 && before(w, x, &w->heap[(i - 1) / 2]); i = (i - 1) / 2)
        w->heap[i] = w->heap[(i - 1) / 2];
    w->heap[i] = *x;
    return IX_OK;
}

static node pop(work *w)
{
    node top = w->heap[0], last = w->heap[--w->n];
    int i = 0;

    for (;;) {
        int c = 2 * i + 1;

        if (c + 1 < w->n && before(w, &w->heap[c + 1], &w->heap[c]))
            c++;
        if (c >= w->n || !before(w, &w->heap[c], &last))
            break;
        w->heap[i] = w->heap[c];
        i = c;
    }
    if (w->n > 0)
        w->heap[i] = last;
    return top;
}

/* --- parts
 * --------------------------------------------------------------------- */

static void control_point(const ix_mv *m, size_t i, double *p)
{
    double w = m->rational ? ix_mv_weights(m)[i] : 1;

    for (int k = 0; k < 3; k++)
        p[k] = k < m->ncoords ? ix_mv_coord(m, k)[i] / w : 0;
}

static ix_status point_of(ix_ctx *ctx, const ix_mv *m, const double *t,
                          double p[3])
{
    p[0] = p[1] = p[2] = 0;
    return ix_mv_point(ctx, m, t, p);
}

static ix_status set_middle(ix_ctx *ctx, part *p)
{
    const double half[2] = {0.5, 0.5};

    return point_of(ctx, p->m, half, p->mid);
}

/* Half of p along direction dir; new reference in out. */
static ix_status half_of(ix_ctx *ctx, const part *p, int dir, bool high,
                         part *out)
{
    double c = 0.5 * (p->lo[dir] + p->hi[dir]);

    *out = *p;
    out->m = NULL;
    (high ? out->lo : out->hi)[dir] = c;
    IX_TRY(
        ix_mv_region(ctx, p->m, dir, high ? 0.5 : 0, high ? 1 : 0.5, &out->m));
    return set_middle(ctx, out);
}

/* The largest distance between first and last layer along a direction. */
static double extent(const ix_mv *m, int dir)
{
    size_t stride = dir ? (size_t)m->dirs[0].length : 1;
    size_t steps = (size_t)m->dirs[dir].length - 1;
    double far = 0;

    for (size_t i = 0; i < m->npts; i++) {
        double p[3], q[3];

        if (i / stride % (steps + 1) != 0)
            continue;
        control_point(m, i, p);
        for (size_t k = 1; k <= steps; k++) {
            control_point(m, i + k * stride, q);
            far = fmax(far, dist(p, q));
        }
    }
    return far;
}

static int longest(const ix_mv *m, double *len)
{
    double a = extent(m, 0), b = m->ndirs > 1 ? extent(m, 1) : -1;

    *len = fmax(a, b);
    return b > a;
}

static ix_status check(ix_ctx *ctx, const ix_mv *m, int which)
{
    if (m->ndirs > 2 || m->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "freeform %d has %d directions and %d coordinates; "
                       "curves and surfaces of at most 3 are possible",
                       which, m->ndirs, m->ncoords);
    for (int j = 0; j < m->ndirs; j++)
        if (m->dirs[j].basis == IX_POWER)
            return IX_FAIL(ctx, IX_EARG,
                           "freeform %d is in power basis: convert it to "
                           "Bezier",
                           which);
    for (size_t i = 0; m->rational && i < m->npts; i++)
        if (!(ix_mv_weights(m)[i] > 0))
            return IX_FAIL(ctx, IX_EUNABLE,
                           "freeform %d has a weight of %g; bounds need "
                           "positive ones",
                           which, ix_mv_weights(m)[i]);
    return IX_OK;
}

static void measure(work *w, const ix_mv *m)
{
    for (size_t i = 0; i < m->npts; i++) {
        double p[3];

        control_point(m, i, p);
        w->size = fmax(w->size, fmax(fabs(p[0]), fmax(fabs(p[1]), fabs(p[2]))));
    }
}

/* --- from one to the other
 * ------------------------------------------------------ */

/* The nearest parameter and distance; order 1 is a point. */
static ix_status nearest(ix_ctx *ctx, const ix_mv *m, const double p[3],
                         double *t, double *d)
{
    double q[3], dom[2];

    if (m->ndirs == 2)
        return ix_srf_nearest(ctx, m, p, false, t, d);
    if (m->dirs[0].order > 1)
        return ix_crv_nearest(ctx, m, p, NULL, false, t, d);
    ix_mv_domain(m, 0, dom);
    t[0] = dom[0];
    IX_TRY(point_of(ctx, m, t, q));
    *d = dist(p, q);
    return IX_OK;
}

static void offer(work *w, double d, const double *ta, const double *tb)
{
    ix_distance *o = &w->best;

    if (o->distance >= 0 && !(w->sign * d < w->sign * o->distance))
        return;
    o->distance = d;
    for (int j = 0; j < 2; j++) {
        o->a[j] = j < w->a->ndirs ? ta[j] : 0;
        o->b[j] = j < w->b->ndirs ? tb[j] : 0;
    }
}

/* The distance of the point of a at ta from b; *foot on b. */
static ix_status try_point(work *w, const double *ta, double foot[3])
{
    double p[3], tb[2], d;

    IX_TRY(point_of(w->ctx, w->a, ta, p));
    IX_TRY(nearest(w->ctx, w->b, p, tb, &d));
    IX_TRY(point_of(w->ctx, w->b, tb, foot));
    offer(w, d, ta, tb);
    return IX_OK;
}

/* No point of part p is further from b than from the foot of its middle. */
static ix_status bound_part(work *w, const part *p, double *bound)
{
    double ta[2], foot[3];

    for (int j = 0; j < w->a->ndirs; j++)
        ta[j] = 0.5 * (p->lo[j] + p->hi[j]);
    IX_TRY(try_point(w, ta, foot));
    *bound = 0;
    for (size_t i = 0; i < p->m->npts; i++) {
        double q[3];

        control_point(p->m, i, q);
        *bound = fmax(*bound, dist(q, foot));
    }
    return IX_OK;
}

static ix_status push_part(work *w, part *p)
{
    node x = {.a = *p};
    ix_status st = bound_part(w, p, &x.bound);

    if (st == IX_OK)
        return push(w, &x);
    drop(w->ctx, &x);
    return st;
}

/* The corners of the whole domain of a, which no middle reaches. */
static ix_status try_corners(work *w)
{
    double dom[2][2] = {{0, 0}, {0, 0}}, foot[3];

    for (int j = 0; j < w->a->ndirs; j++)
        ix_mv_domain(w->a, j, dom[j]);
    for (int k = 0; k < 1 << w->a->ndirs; k++) {
        double t[2] = {dom[0][k & 1], dom[1][k >> 1]};

        IX_TRY(try_point(w, t, foot));
    }
    return IX_OK;
}

static ix_status push_pieces(work *w, const ix_mv_pieces *pc)
{
    for (size_t i = 0; i < pc->count; i++) {
        int nd = w->a->ndirs;
        part p = {.m = ix_mv_ref(pc->piece[i])};

        for (int j = 0; j < nd; j++) {
            p.lo[j] = pc->lo[i * (size_t)nd + (size_t)j];
            p.hi[j] = pc->hi[i * (size_t)nd + (size_t)j];
        }
        IX_TRY(push_part(w, &p));
    }
    return IX_OK;
}

static bool closed(const work *w, double bound)
{
    return w->sign * (w->best.distance - bound) <=
           GAP * fmax(w->size, w->best.distance);
}

static ix_status split_part(work *w, const part *p)
{
    double len;
    int dir = longest(p->m, &len);

    for (int high = 0; high <= 1; high++) {
        part q;
        ix_status st = half_of(w->ctx, p, dir, high != 0, &q);

        if (st != IX_OK) {
            ix_mv_unref(w->ctx, q.m);
            return st;
        }
        IX_TRY(push_part(w, &q));
    }
    return IX_OK;
}

static ix_status far_search(work *w)
{
    ix_mv_pieces pc;
    ix_status st;

    IX_TRY(try_corners(w));
    IX_TRY(ix_mv_to_bezier(w->ctx, w->a, &pc));
    st = push_pieces(w, &pc);
    ix_mv_pieces_free(w->ctx, &pc);
    IX_TRY(st);
    for (int k = 0; w->n > 0; k++) {
        node x;

        w->best.error = fmax(0, w->heap[0].bound - w->best.distance);
        if (closed(w, w->heap[0].bound) || k >= MAX_WORK)
            break;
        x = pop(w);
        st = split_part(w, &x.a);
        drop(w->ctx, &x);
        IX_TRY(st);
        IX_TRY(ix__poll(w->ctx));
    }
    return IX_OK;
}

/* --- the least distance
 * ---------------------------------------------------------- */

/* How far the two parts are apart along the line between their middles. */
static double apart(const work *w, const part *a, const part *b)
{
    double d = dist(a->mid, b->mid), lo = HUGE_VAL, hi = -HUGE_VAL, v[3];

    if (!(d > 0))
        return 0;
    for (int k = 0; k < 3; k++)
        v[k] = (a->mid[k] - b->mid[k]) / d;
    for (int side = 0; side < 2; side++) {
        const ix_mv *m = side ? b->m : a->m;

        for (size_t i = 0; i < m->npts; i++) {
            double p[3], s = 0;

            control_point(m, i, p);
            for (int k = 0; k < 3; k++)
                s += (p[k] - b->mid[k]) * v[k];
            lo = side ? lo : fmin(lo, s);
            hi = side ? fmax(hi, s) : hi;
        }
    }
    /* parts that are not apart: the nearest middles first */
    return lo > hi ? lo - hi : -1 / (1 + d / w->size);
}

static ix_status push_pair(work *w, part *a, part *b)
{
    node x = {.a = *a, .b = *b};
    double ta[2] = {0, 0}, tb[2] = {0, 0};

    for (int j = 0; j < 2; j++) {
        ta[j] = 0.5 * (a->lo[j] + a->hi[j]);
        tb[j] = 0.5 * (b->lo[j] + b->hi[j]);
    }
    offer(w, dist(a->mid, b->mid), ta, tb);
    x.bound = apart(w, a, b);
    return push(w, &x);
}

/* The two halves of one part of x with the other whole. */
static ix_status split_pair(work *w, const node *x)
{
    double la, lb;
    int da = longest(x->a.m, &la), db = longest(x->b.m, &lb);

    for (int high = 0; high <= 1; high++) {
        part a = x->a, b = x->b, q;
        ix_status st = half_of(w->ctx, la >= lb ? &a : &b, la >= lb ? da : db,
                               high != 0, &q);

        if (st != IX_OK) {
            ix_mv_unref(w->ctx, q.m);
            return st;
        }
        if (la >= lb) {
            a = q;
            b.m = ix_mv_ref(b.m);
        } else {
            b = q;
            a.m = ix_mv_ref(a.m);
        }
        IX_TRY(push_pair(w, &a, &b));
    }
    return IX_OK;
}

static ix_status piece_part(work *w, const ix_mv_pieces *pc, size_t i, int nd,
                            part *p)
{
    *p = (part){.m = pc->piece[i]};
    for (int j = 0; j < nd; j++) {
        p->lo[j] = pc->lo[i * (size_t)nd + (size_t)j];
        p->hi[j] = pc->hi[i * (size_t)nd + (size_t)j];
    }
    return set_middle(w->ctx, p);
}

static ix_status push_all_pairs(work *w, const ix_mv_pieces *pa,
                                const ix_mv_pieces *pb)
{
    for (size_t i = 0; i < pa->count; i++)
        for (size_t k = 0; k < pb->count; k++) {
            part a, b;

            IX_TRY(piece_part(w, pa, i, w->a->ndirs, &a));
            IX_TRY(piece_part(w, pb, k, w->b->ndirs, &b));
            a.m = ix_mv_ref(a.m);
            b.m = ix_mv_ref(b.m);
            IX_TRY(push_pair(w, &a, &b));
        }
    return IX_OK;
}

/* Foot after foot: the parameters to more digits than bounds can give. */
static ix_status polish(work *w)
{
    for (int k = 0; k < 8; k++) {
        double p[3], q[3], ta[2], tb[2], d;

        IX_TRY(point_of(w->ctx, w->a, w->best.a, p));
        IX_TRY(nearest(w->ctx, w->b, p, tb, &d));
        IX_TRY(point_of(w->ctx, w->b, tb, q));
        IX_TRY(nearest(w->ctx, w->a, q, ta, &d));
        if (!(d < w->best.distance))
            break;
        offer(w, d, ta, tb);
    }
    return IX_OK;
}

static ix_status near_search(work *w)
{
    ix_mv_pieces pa, pb;
    ix_status st;

    IX_TRY(ix_mv_to_bezier(w->ctx, w->a, &pa));
    st = ix_mv_to_bezier(w->ctx, w->b, &pb);
    if (st == IX_OK) {
        st = push_all_pairs(w, &pa, &pb);
        ix_mv_pieces_free(w->ctx, &pb);
    }
    ix_mv_pieces_free(w->ctx, &pa);
    IX_TRY(st);
    for (int k = 0; w->n > 0; k++) {
        double bound = fmax(0, w->heap[0].bound);
        node x;

        w->best.error = fmax(0, w->best.distance - bound);
        if (closed(w, bound) || k >= 10 * MAX_WORK)
            break;
        if (k % 64 == 63)
            IX_TRY(polish(w));
        x = pop(w);
        st = split_pair(w, &x);
        drop(w->ctx, &x);
        IX_TRY(st);
        IX_TRY(ix__poll(w->ctx));
    }
    return polish(w);
}

/* --- the calls
 * ------------------------------------------------------------------ */

static ix_status run(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, bool least,
                     ix_distance *out)
{
    work w = {.ctx = ctx,
              .a = a,
              .b = b,
              .sign = least ? 1 : -1,
              .best = {.distance = -1}};
    ix_mark mk;
    ix_status st;

    IX_TRY(check(ctx, a, 1));
    IX_TRY(check(ctx, b, 2));
    measure(&w, a);
    measure(&w, b);
    if (!(w.size > 0))
        w.size = 1;
    mk = ix__scratch_mark(ctx);
    st = least ? near_search(&w) : far_search(&w);
    while (w.n > 0)
        drop(ctx, &w.heap[--w.n]);
    ix__scratch_release(ctx, mk);
    *out = w.best;
    return st;
}

ix_status ix_distance_least(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                            ix_distance *out)
{
    return run(ctx, a, b, true, out);
}

ix_status ix_distance_hausdorff(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                                bool one_sided, ix_distance *out)
{
    ix_distance back;

    IX_TRY(run(ctx, a, b, false, out));
    if (one_sided)
        return IX_OK;
    IX_TRY(run(ctx, b, a, false, &back));
    if (back.distance > out->distance) {
        ix_distance t = {.distance = back.distance};

        memcpy(t.a, back.b, sizeof t.a);
        memcpy(t.b, back.a, sizeof t.b);
        t.error = fmax(back.error, out->error);
        *out = t;
    }
    return IX_OK;
}
