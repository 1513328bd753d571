/* crv_meetings.c - the points that two curves share, in space or in the plane.
 *
 * Pairs of pieces whose boxes are apart are left out, the others halved; the
 * pairs that are left at 2^-14 of a span are carried to the nearest points by
 * Gauss-Newton steps. All of it in the frame of both curves, so that the bound
 * is relative to their common size. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bern/bern.h"
#include "geom/vec3.h"
#include "iritx/distance.h"
#include "sym/form.h"

enum { DEPTH = 14, MOST = 1024, STEPS = 60 };

/* One span of a curve: its interval, and the coefficients of its pieces of
 * 2^-k, double[rows][d + 1] for each level. */
typedef struct {
    int d, rows; /* rows: w, x, y, z */
    double range[2];
    double *level[DEPTH + 1];
} span;

typedef struct {
    ix_ctx *ctx;
    span s[2];
    double eps, dom[2][2];
    ix_meeting *found;
    int n, tries;
} search;

/* --- pieces ---------------------------------------------------------------
 */

typedef struct {
    double lo[3], hi[3];
    bool bounded; /* all weights are positive */
} box;

static box box_of(const span *s, int level)
{
    const double *c = s->level[level];
    int n = s->d + 1;
    box b = {.bounded = true};

    for (int i = 0; i < n; i++)
        b.bounded = b.bounded && c[i] > 0;
    for (int k = 0; k < 3 && b.bounded; k++) {
        const double *x = c + (k + 1) * n;

        b.lo[k] = b.hi[k] = x[0] / c[0];
        for (int i = 1; i < n; i++) {
            b.lo[k] = fmin(b.lo[k], x[i] / c[i]);
            b.hi[k] = fmax(b.hi[k], x[i] / c[i]);
        }
    }
    return b;
}

static double extent(const box *b)
{
    double e = 0;

    for (int k = 0; k < 3; k++)
        e = fmax(e, b->hi[k] - b->lo[k]);
    return b->bounded ? e : HUGE_VAL;
}

static bool apart(const box *a, const box *b, double eps)
{
    for (int k = 0; k < 3 && a->bounded && b->bounded; k++)
        if (a->lo[k] - b->hi[k] > eps || b->lo[k] - a->hi[k] > eps)
            return true;
    return false;
}

static void half_of(const span *s, int level, bool high)
{
    size_t n = (size_t)s->d + 1;

    for (int r = 0; r < 4; r++)
        ix__bern_restrict(s->d, high ? 0.5 : 0.0, high ? 1.0 : 0.5, 1,
                          s->level[level] + (size_t)r * n,
                          s->level[level + 1] + (size_t)r * n);
}

/* --- the nearest points -----------------------------------------------------
 */

/* Value and derivative at u of the span, by de Casteljau; false at a pole. */
static bool jet(const span *s, double u, double *work, double x[3], double d[3])
{
    int n = s->d;
    double h[4], dh[4];

    for (int r = 0; r < 4; r++) {
        memcpy(work, s->level[0] + (size_t)r * (size_t)(n + 1),
               (size_t)(n + 1) * sizeof *work);
        for (int k = n; k > 1; k--)
            for (int i = 0; i < k; i++)
                work[i] += u * (work[i + 1] - work[i]);
        dh[r] = n > 0 ? n * (work[1] - work[0]) : 0.0;
        h[r] = n > 0 ? work[0] + u * (work[1] - work[0]) : work[0];
    }
    if (!(fabs(h[0]) > 0))
        return false;
    for (int k = 0; k < 3; k++) {
        x[k] = h[k + 1] / h[0];
        d[k] = (dh[k + 1] - x[k] * dh[0]) / h[0];
    }
    return true;
}

/* The step that brings x + a d0 and y + b d1 together; the added part of the
 * trace keeps it defined where the tangents are parallel. */
static void step_of(const double e[3], double d[2][3], double out[2])
{
    double a = ix__dot3(d[0], d[0]), b = -ix__dot3(d[0], d[1]),
           c = ix__dot3(d[1], d[1]), r0 = -ix__dot3(d[0], e),
           r1 = ix__dot3(d[1], e), mu = DBL_EPSILON * (a + c) + DBL_MIN, det;

    a += mu;
    c += mu;
    det = a * c - b * b;
    out[0] = (c * r0 - b * r1) / det;
    out[1] = (a * r1 - b * r0) / det;
}

/* From u[2] on to the nearest points; their distance, HUGE_VAL at a pole. */
static double approach(const search *q, double *work, double u[2],
                       double d[2][3])
{
    double x[2][3], e[3], move[2], best = HUGE_VAL;

    for (int i = 0; i < STEPS; i++) {
        double v[2], moved = 0, gap;

        for (int k = 0; k < 2; k++)
            if (!jet(&q->s[k], u[k], work, x[k], d[k]))
                return HUGE_VAL;
        ix__sub3(x[0], x[1], e);
        gap = ix__len3(e);
        best = gap;
        step_of(e, d, move);
        for (int k = 0; k < 2; k++) {
            v[k] = fmin(fmax(u[k] + move[k], 0.0), 1.0);
            moved = fmax(moved, fabs(v[k] - u[k]));
        }
        if (!(moved > 4 * DBL_EPSILON) || gap == 0)
            break;
        memcpy(u, v, sizeof v);
    }
    return best;
}

/* A crossing is known to rounding; where the tangents agree, the curves stay
 * within eps of each other for a while. */
static bool same(const search *q, const ix_meeting *a, const ix_meeting *b)
{
    double tie = fmin(a->sine, b->sine) < 1e-2 ? 1e-3 : 1e-7;

    for (int k = 0; k < 2; k++)
        if (!(fabs(a->t[k] - b->t[k]) <= tie * (q->dom[k][1] - q->dom[k][0])))
            return false;
    return true;
}

static void add(search *q, const ix_meeting *m)
{
    for (int i = 0; i < q->n; i++)
        if (same(q, &q->found[i], m)) {
            if (m->gap < q->found[i].gap)
                q->found[i] = *m;
            return;
        }
    q->found[q->n++] = *m;
}

/* u: the middles of two pieces. */
static void try_pair(search *q, double *work, const double *middle)
{
    double u[2] = {middle[0], middle[1]}, d[2][3] = {{0}}, x[3],
           unit[2][3] = {{0}};
    ix_meeting m = {.sine = 0};

    q->tries++;
    m.gap = approach(q, work, u, d);
    if (!(m.gap <= q->eps))
        return;
    for (int k = 0; k < 2; k++)
        m.t[k] = q->s[k].range[0] +
                 u[k] * (q->s[k].range[1] - q->s[k].range[0]);
    if (ix__unit3(d[0], unit[0]) > 0 && ix__unit3(d[1], unit[1]) > 0) {
        ix__cross3(unit[0], unit[1], x);
        m.sine = ix__len3(x);
    }
    add(q, &m);
}

/* --- pairs ----------------------------------------------------------------
 */

typedef struct {
    int level[2];
    double lo[2]; /* where the pieces begin in their spans */
} pieces;

static ix_status look(search *q, double *work, const pieces *p)
{
    box b[2];
    pieces next = *p;
    int k;

    for (int i = 0; i < 2; i++)
        b[i] = box_of(&q->s[i], p->level[i]);
    if (q->tries >= MOST || apart(&b[0], &b[1], q->eps))
        return IX_OK;
    k = p->level[0] == DEPTH            ? 1
        : p->level[1] == DEPTH          ? 0
        : extent(&b[1]) > extent(&b[0]) ? 1
                                        : 0;
    if (p->level[k] == DEPTH) {
        const double middle[2] = {p->lo[0] + ldexp(0.5, -p->level[0]),
                                  p->lo[1] + ldexp(0.5, -p->level[1])};

        if (b[0].bounded && b[1].bounded)
            try_pair(q, work, middle);
        return ix__poll(q->ctx);
    }
    next.level[k]++;
    for (int h = 0; h < 2; h++) {
        half_of(&q->s[k], p->level[k], h);
        next.lo[k] = p->lo[k] + h * ldexp(1.0, -next.level[k]);
        IX_TRY(look(q, work, &next));
    }
    return IX_OK;
}

/* --- curves ---------------------------------------------------------------
 */

static ix_status load(ix_ctx *ctx, const ix_mv *c, const ix_frame *frame,
                      ix_form *f, const double **b)
{
    static const double one = 1;
    ix_form w, all;
    const ix_form *parts[2] = {&w, f};

    IX_TRY(ix__forms_load(ctx, 1, &c, frame, f));
    if (!c->rational) {
        IX_TRY(ix__form_constant(ctx, f, 1, &one, &w));
        IX_TRY(ix__form_join(ctx, 2, parts, &all));
        *f = all;
    }
    return ix__form_bernstein(ctx, f, b);
}

static void set_span(const ix_form *f, const double *b, int i, span *s)
{
    size_t n = (size_t)s->d + 1;

    for (int r = 0; r < 4; r++)
        memcpy(s->level[0] + (size_t)r * n,
               b + (size_t)r * f->n + (size_t)i * n, n * sizeof *b);
    s->range[0] = f->dirs[0].breaks[i];
    s->range[1] = f->dirs[0].breaks[i + 1];
}

/* All pairs of spans. */
static ix_status all_pairs(search *q, const ix_form *f, const double *const *b)
{
    double *work;

    IX_SCRATCH(q->ctx, q->found, MOST);
    IX_SCRATCH(q->ctx, work,
               (size_t)(q->s[0].d > q->s[1].d ? q->s[0].d : q->s[1].d) + 1);
    for (int k = 0; k < 2; k++)
        for (int l = 0; l <= DEPTH; l++)
            IX_SCRATCH(q->ctx, q->s[k].level[l], 4 * ((size_t)q->s[k].d + 1));
    for (int i = 0; i < f[0].dirs[0].nspans; i++) {
        set_span(&f[0], b[0], i, &q->s[0]);
        for (int j = 0; j < f[1].dirs[0].nspans; j++) {
            const pieces whole = {{0, 0}, {0, 0}};

            set_span(&f[1], b[1], j, &q->s[1]);
            IX_TRY(look(q, work, &whole));
        }
    }
    return IX_OK;
}

static int by_parameters(const void *x, const void *y)
{
    const ix_meeting *a = x, *b = y;
    int k = a->t[0] == b->t[0];

    return (a->t[k] > b->t[k]) - (a->t[k] < b->t[k]);
}

/* Ends of the projected control points' coordinate k; false if they bound
 * nothing: a weight is not positive, or power coefficients. */
static bool net_box(const ix_mv *m, int k, double ends[2])
{
    const double *x = m->pts + (size_t)(k + m->rational) * m->npts;

    if (m->dirs[0].basis == IX_POWER)
        return false;
    ends[0] = INFINITY;
    ends[1] = -INFINITY;
    for (size_t i = 0; i < m->npts; i++) {
        double w = m->rational ? m->pts[i] : 1.0;

        if (!(w > 0.0))
            return false;
        ends[0] = fmin(ends[0], x[i] / w);
        ends[1] = fmax(ends[1], x[i] / w);
    }
    return true;
}

/* Are the boxes of the control points further apart than eps? Most pairs of
 * curves are, and then nothing else has to be done. */
static bool nets_apart(const ix_mv *const *c, double eps)
{
    for (int k = 0; k < 3; k++) {
        double a[2], b[2];

        if (!net_box(c[0], k, a) || !net_box(c[1], k, b))
            return false;
        if (a[0] - b[1] > eps || b[0] - a[1] > eps)
            return true;
    }
    return false;
}

static ix_status run(ix_ctx *ctx, const ix_mv *const *c, ix_meetings *out)
{
    search q = {.ctx = ctx};
    const double *b[2];
    ix_frame frame;
    ix_form f[2];

    IX_TRY(ix__frame_of(ctx, 2, c, &frame));
    /* rounding of both ends of a difference, by de Casteljau and in the input
     */
    q.eps = 8 * (c[0]->dirs[0].order + c[1]->dirs[0].order) * DBL_EPSILON +
            4 * frame.noise;
    out->eps = ldexp(q.eps, frame.exp);
    out->complete = true;
    if (nets_apart(c, out->eps))
        return IX_OK;
    for (int k = 0; k < 2; k++) {
        IX_TRY(load(ctx, c[k], &frame, &f[k], &b[k]));
        q.s[k].d = f[k].dirs[0].degree;
        ix_mv_domain(c[k], 0, q.dom[k]);
    }
    IX_TRY(all_pairs(&q, f, b));
    out->complete = q.tries < MOST;
    if (q.n == 0)
        return IX_OK;
    out->at = ix__alloc(ctx, (size_t)q.n * sizeof *out->at);
    if (!out->at)
        return IX_ENOMEM;
    qsort(q.found, (size_t)q.n, sizeof *q.found, by_parameters);
    memcpy(out->at, q.found, (size_t)q.n * sizeof *out->at);
    for (int i = 0; i < q.n; i++)
        out->at[i].gap = ldexp(out->at[i].gap, frame.exp);
    out->n = q.n;
    return IX_OK;
}

static ix_status in_space(ix_ctx *ctx, const ix_mv *const *c, ix_meetings *out)
{
    ix_mv *own[2] = {NULL, NULL};
    ix_status st = IX_OK;

    for (int k = 0; k < 2 && st == IX_OK; k++)
        st = ix_mv_coerce(ctx, c[k], 3, c[k]->rational, &own[k]);
    if (st == IX_OK)
        st = run(ctx, (const ix_mv *const *)own, out);
    for (int k = 0; k < 2; k++)
        ix_mv_unref(ctx, own[k]);
    return st;
}

ix_status ix_crv_meetings(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                          ix_meetings *out)
{
    const ix_mv *c[2] = {a, b};

    *out = (ix_meetings){.n = 0};
    for (int k = 0; k < 2; k++)
        if (c[k]->ndirs != 1 || c[k]->ncoords > 3)
            return IX_FAIL(ctx, IX_EARG,
                           "operand %d has %d directions and %d coordinates: a "
                           "curve with at most 3 is needed",
                           k + 1, c[k]->ndirs, c[k]->ncoords);
    IX_RETURN_SCOPED(ctx, in_space(ctx, c, out));
}

void ix_meetings_free(ix_ctx *ctx, ix_meetings *m)
{
    ix__free(ctx, m->at, (size_t)m->n * sizeof *m->at);
    *m = (ix_meetings){.n = 0};
}
