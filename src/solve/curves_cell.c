/* curves_cell.c - the arcs of a curve inside one patch.
 *
 * A box is halved until one coordinate k is proven to be a parameter of the
 * curve in it: for every value of x_k at most one solution (a contraction in
 * the other coordinates). Then the arcs of the box lie between the points in
 * which the curve meets its faces, sorted by x_k. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "base/grow.h"
#include "solve/contract.h"
#include "solve/curves_impl.h"
#include "solve/poly_roots.h"
#include "solve/system_impl.h"

#define UNIT     (DBL_EPSILON / 2)
#define NOISE    4   /* errors that a value may have and be called noise */
#define MAX_FACE 256 /* points of one cell on its faces */
#define RATIO                                               \
    0.487373 /* halving away from dyadic numbers, where the \
                interesting points of test cases lie */

typedef struct ix__cells {
    ix__curves *s;
    ix__stack stack;
    ix__box wide;  /* the box in hand, enlarged beyond faces of its patch */
    ix__box twice; /* the box in hand, with an equation for a multiple curve */
    double *work, *face, *strip;
} search;

/* A cell with parameter x_k: m is the inverse of the Jacobian in the others. */
typedef struct {
    const ix__box *b;
    int k;
    ix__mat m;
    int in[IX_MAX_UNKNOWNS]; /* the curve lies in the patch's face at the low
                                (-1) or high (1) end of that direction */
} graph;

static double *tensor(const ix__curves *s, const ix__box *b, int i)
{
    return b->c + (size_t)i * s->t.shape.size;
}

/* The i-th coordinate other than k. */
static int other(int i, int k)
{
    return i < k ? i : i + 1;
}

/* --- growing arrays
 * --------------------------------------------------------------- */

ix_status ix__curves_add_pt(ix__curves *s, const double *x)
{
    IX_GROW(s->t.ctx, s->pts, s->npts, s->pt_cap);
    memcpy(s->pts[s->npts++].x, x, (size_t)s->n * sizeof *x);
    return IX_OK;
}

ix_status ix__curves_add_arc(ix__curves *s, int first)
{
    IX_GROW(s->t.ctx, s->arc, s->narcs, s->arc_cap);
    s->arc[s->narcs++] = (ix__arc){first, s->npts - first, 1};
    return IX_OK;
}

/* --- the test for a parameter
 * ---------------------------------------------------------- */

/* Bound of |I - m J| over the cell, J the Jacobian without column k. */
static double contraction(const ix__curves *s, const graph *g, ix__mat m)
{
    int dir[IX_MAX_UNKNOWNS];
    ix__mat d;

    for (int j = 0; j < s->n - 1; j++)
        dir[j] = other(j, g->k);
    return ix__contraction(&s->t.shape, s->n - 1, dir, g->b->c, g->b->err,
                           g->b->mag, m, d);
}

/* Looks for a coordinate that is a parameter, the best conditioned first. */
static bool find_parameter(const ix__curves *s, const ix__box *b, graph *g)
{
    double best = 0.9;
    ix__mat jac;

    for (int i = 0; i < s->n - 1; i++)
        ix__tensor_mean_gradient(&s->t.shape, tensor(s, b, i), jac[i]);
    for (int k = 0; k < s->n; k++) {
        graph t = {.b = b, .k = k};
        ix__mat sub;
        double lip;

        for (int i = 0; i < s->n - 1; i++)
            for (int j = 0; j < s->n - 1; j++)
                sub[i][j] = jac[i][other(j, k)];
        if (!ix__small_invert(s->n - 1, sub, t.m))
            continue;
        lip = contraction(s, &t, t.m);
        if (lip < best) {
            best = lip;
            *g = t;
        }
    }
    return best < 0.9;
}

/* --- points on the curve
 * ------------------------------------------------------------------ */

/* The Newton matrix at x: the inverse of the Jacobian without column k, or the
 * cell's preconditioner where that is singular. */
static void matrix_at(search *q, const graph *g, const double *x, ix__mat m)
{
    const ix__curves *s = q->s;
    ix__mat sub;

    for (int i = 0; i < s->n - 1; i++) {
        double grad[IX_MAX_UNKNOWNS];

        ix__tensor_gradient(&s->t.shape, tensor(s, g->b, i), x, grad, q->work);
        for (int j = 0; j < s->n - 1; j++)
            sub[i][j] = grad[other(j, g->k)];
    }
    if (!ix__small_invert(s->n - 1, sub, m))
        memcpy(m, g->m, sizeof(ix__mat));
}

/* One step of x for the coordinates other than k; its size. */
static double step(search *q, const graph *g, ix__mat m, double *x)
{
    const ix__curves *s = q->s;
    double v[IX_MAX_UNKNOWNS], size = 0;

    for (int i = 0; i < s->n - 1; i++)
        v[i] = ix__tensor_value(&s->t.shape, tensor(s, g->b, i), x, q->work);
    for (int i = 0; i < s->n - 1; i++) {
        double d = 0;

        for (int k = 0; k < s->n - 1; k++)
            d += m[i][k] * v[k];
        x[other(i, g->k)] -= d;
        size = fmax(size, fabs(d));
    }
    return size;
}

/* Solves for the coordinates other than k (local, x given as start). The
 * cell's own matrix contracts for sure but slowly; once it has come near,
 * Newton's method finishes. The last step, or infinity. */
static double correct(search *q, const graph *g, double *x)
{
    double last = HUGE_VAL;
    ix__mat m;

    memcpy(m, g->m, sizeof m);
    for (int it = 0; it < 60; it++) {
        double size;

        if (last < 0.1)
            matrix_at(q, g, x, m);
        size = step(q, g, m, x);
        if (!(size < 4))
            return HUGE_VAL;
        if (size <= 2 * UNIT || (last < 1e-7 && !(size < 0.5 * last)))
            return fmin(size, last);
        last = size;
    }
    return last;
}

static bool inside(const ix__curves *s, const double *x, double slack)
{
    for (int j = 0; j < s->n; j++)
        if (!(x[j] >= -slack && x[j] <= 1 + slack))
            return false;
    return true;
}

static void to_global(const ix__curves *s, const graph *g, const double *x,
                      double *out)
{
    const ix__box *b = g->b;

    for (int j = 0; j < s->n; j++) {
        double t = fmin(fmax(x[j], 0), 1);

        out[j] = t >= 1 ? b->hi[j] : b->lo[j] + t * (b->hi[j] - b->lo[j]);
        if (g->in[j])
            out[j] = g->in[j] > 0 ? s->patch_hi[j] : s->patch_lo[j];
    }
}

/* --- faces
 * ------------------------------------------------------------------------------------
 */

/* Tensor layer of direction j at its low or high end: a tensor of one
 * direction less. */
static void take_layer(const ix__curves *s, const double *c, int j, bool high,
                       double *out)
{
    size_t inner = s->t.shape.stride[j], m = (size_t)s->t.shape.dims[j];
    const double *p = c + (high ? (m - 1) * inner : 0);

    for (; p < c + s->t.shape.size; p += inner * m, out += inner)
        memcpy(out, p, inner * sizeof *out);
}

static void face_shape(const ix__curves *s, int j, ix__shape *f)
{
    int dims[IX_MAX_UNKNOWNS];

    for (int i = 0; i < s->n - 1; i++)
        dims[i] = s->t.shape.dims[other(i, j)];
    ix__shape_init(f, s->n - 1, dims);
}

/* Adds a point with local coordinates y on face j. False: too many. */
static bool add_face_point(const ix__curves *s, int j, bool high,
                           const double *y, ix__pt *list, int *count)
{
    if (*count == MAX_FACE)
        return false;
    for (int i = 0; i < s->n - 1; i++)
        list[*count].x[other(i, j)] = y[i];
    list[*count].x[j] = high;
    (*count)++;
    return true;
}

/* A face of the patch: unlike a cut, it cannot be moved. */
static bool on_patch(const ix__curves *s, const ix__box *b, int j, bool high)
{
    return high ? b->hi[j] >= s->patch_hi[j] : b->lo[j] <= s->patch_lo[j];
}

/* n = 2: the face is an edge with one polynomial. *ok false: undecided. A
 * touching root inside the patch is undecided too: another cut will miss it,
 * or it comes from branches that the coefficients cannot tell apart. */
static ix_status edge_points(search *q, const graph *g, int j, bool high,
                             ix__pt *list, int *count, bool *ok)
{
    const ix__box *b = g->b;
    ix__curves *s = q->s;
    ix_mark mk = ix__scratch_mark(s->t.ctx);
    int d = s->t.shape.dims[1 - j] - 1;
    ix__poly_roots r;
    ix_status st;
    double y;

    take_layer(s, b->c, j, high, q->face);
    st = ix__poly_roots_find(s->t.ctx, d, q->face, b->err[0], &r);
    if (st == IX_OK && !r.vanishes) {
        y = 0;
        if (r.zeros0)
            *ok &= add_face_point(s, j, high, &y, list, count);
        for (int i = 0; i < r.n; i++) {
            y = r.root[i].s;
            *ok &= (r.root[i].count == 1 || on_patch(s, b, j, high)) &&
                   add_face_point(s, j, high, &y, list, count);
        }
        y = 1;
        if (r.zeros1)
            *ok &= add_face_point(s, j, high, &y, list, count);
    }
    ix__scratch_release(s->t.ctx, mk);
    return st;
}

/* Where the curve touches a face of the patch, the point is known to the root
 * of rounding only: it is moved onto the curve. */
static void improve(search *q, const graph *g, ix__pt *p)
{
    ix__pt x = *p;

    if (correct(q, g, x.x) < 1e-6 && inside(q->s, x.x, 1e-12))
        *p = x;
}

/* n > 2: a system of n - 1 equations on the face. */
static ix_status face_points(search *q, const graph *g, int j, bool high,
                             ix__pt *list, int *count, bool *ok)
{
    const ix__box *b = g->b;
    ix__curves *s = q->s;
    ix_mark mk = ix__scratch_mark(s->t.ctx);
    ix__found found = {.ctx = s->t.ctx};
    ix__system sys = {.n = s->n - 1,
                      .t = {.ctx = s->t.ctx,
                            .neq = s->n - 1,
                            .nall = s->n - 1,
                            .cell = 1e-6,
                            .max_boxes = 2000}};
    ix__box f = {.c = q->face, .cuts = 0};
    ix_status st = IX_OK;

    face_shape(s, j, &sys.t.shape);
    for (int i = 0; i < s->n - 1; i++) {
        sys.t.edge[i] = 1;
        f.lo[i] = 0;
        f.hi[i] = 1;
        f.err[i] = b->err[i];
        take_layer(s, tensor(s, b, i), j, high,
                   q->face + (size_t)i * sys.t.shape.size);
    }
    st = ix__system_search(&sys, &f, &found);
    if (st == IX_OK)
        st = ix__found_merge(&found, sys.n, sys.t.edge);
    for (int i = 0; st == IX_OK && i < found.n; i++) {
        *ok &= (found.sol[i].certified || on_patch(s, b, j, high)) &&
               add_face_point(s, j, high, found.sol[i].x, list, count);
        if (*ok && !found.sol[i].certified)
            improve(q, g, &list[*count - 1]);
    }
    *ok &= sys.t.boxes < sys.t.max_boxes && !sys.t.crowded;
    ix__scratch_release(s->t.ctx, mk);
    return st;
}

/* All points in which the curve meets the faces, sorted by x_k; *ok false if
 * some face could not be decided. */
static ix_status all_face_points(search *q, const graph *g, ix__pt *list,
                                 int *count, bool *ok)
{
    int n = q->s->n;

    *count = 0;
    *ok = true;
    for (int j = 0; j < n; j++)
        for (int high = 0; high <= 1; high++)
            if (g->in[j] != (high ? 1 : -1))
                IX_TRY((n == 2 ? edge_points : face_points)(q, g, j, high != 0,
                                                            list, count, ok));
    for (int i = 1; i < *count; i++) {
        ix__pt t = list[i];
        int k = i;

        for (; k > 0 && list[k - 1].x[g->k] > t.x[g->k]; k--)
            list[k] = list[k - 1];
        list[k] = t;
    }
    return IX_OK;
}

/* --- curves in the faces of a patch
 * ---------------------------------------------------------------------------
 * Common in practice: patches with a common edge, sections along knot lines.
 * Such a curve meets its face everywhere, or nowhere, as rounding would have
 * it. So the cell is enlarged across that face, and the curve lies inside. */

#define ACROSS  0.125 /* by that part of the cell */
#define SAMPLES 16    /* on how many intervals of x_k the curve is looked at */

/* Whether the curve is at x_j = side for all x_k, as far as the coefficients,
 * known to within err, can tell. */
static bool lies_in(search *q, const graph *g, int j, double side)
{
    const ix__curves *s = q->s;
    const double *row = g->m[j < g->k ? j : j - 1];
    double x[IX_MAX_UNKNOWNS], band = 16 * UNIT;

    for (int i = 0; i < s->n - 1; i++)
        band += 2 * fabs(row[i]) * g->b->err[i];
    for (int i = 0; i < s->n; i++)
        x[i] = 0.5;
    x[j] = side;
    if (!(correct(q, g, x) < 1e-6) || !(fabs(x[j] - side) <= band))
        return false;
    for (int i = 0; i <= SAMPLES; i++) {
        x[g->k] = (double)i / SAMPLES;
        if (!(correct(q, g, x) < 1e-6) || !(fabs(x[j] - side) <= band))
            return false;
    }
    return true;
}

/* Enlarges q->wide in direction j across its low or high end: the part [-a, 1]
 * or [0, 1 + a]. Extrapolating multiplies errors by (1 + 2 a) for each degree.
 */
static void widen(search *q, int j, bool high)
{
    const ix__shape *f = &q->s->t.shape;
    ix__box *w = &q->wide;
    double len = w->hi[j] - w->lo[j], grow = 1;

    for (int d = 1; d < f->dims[j]; d++)
        grow *= 1 + 2 * ACROSS;
    for (int i = 0; i < q->s->n - 1; i++) {
        double *c = w->c + (size_t)i * f->size, lo, hi;

        ix__tensor_restrict(f, c, j, high ? 0 : -ACROSS, high ? 1 + ACROSS : 1);
        ix__tensor_range(f, c, &lo, &hi);
        w->mag[i] = ix__larger(-lo, hi);
        w->err[i] = grow *
                    (w->err[i] + 3 * (f->dims[j] - 1) * UNIT * w->mag[i]);
    }
    if (high)
        w->hi[j] += ACROSS * len;
    else
        w->lo[j] -= ACROSS * len;
}

/* Faces of the patch in which the curve lies: the cell becomes one enlarged
 * across them. False: that has no parameter any more. */
static bool leave_faces(search *q, graph *g)
{
    const ix__curves *s = q->s;
    const ix__box *b = g->b;
    double *c = q->wide.c;
    int in[IX_MAX_UNKNOWNS] = {0};
    bool any = false;

    for (int j = 0; j < s->n; j++)
        for (int high = 0; j != g->k && high <= 1; high++)
            if (on_patch(s, b, j, high != 0) && lies_in(q, g, j, high)) {
                in[j] = high ? 1 : -1;
                any = true;
            }
    if (!any)
        return true;
    q->wide = *b;
    q->wide.c = c;
    memcpy(c, b->c, (size_t)(s->n - 1) * s->t.shape.size * sizeof *c);
    for (int j = 0; j < s->n; j++)
        if (in[j])
            widen(q, j, in[j] > 0);
    if (!find_parameter(s, &q->wide, g) || in[g->k])
        return false;
    memcpy(g->in, in, sizeof in);
    return true;
}

/* A curve in a face that two patches have in common belongs to the upper. */
static bool left_to_neighbour(const ix__curves *s, const graph *g)
{
    for (int j = 0; j < s->n; j++)
        if (g->in[j] > 0 && s->joined[j])
            return true;
    return false;
}

/* --- tracing
 * ------------------------------------------------------------------------------------
 */

/* Global distance of x from the chord a b, relative to the domain's edges. */
static double sag(const ix__curves *s, const ix__box *b, const double *p,
                  const double *x, const double *r)
{
    double d = 0, t = 0, len = 0, e[4], c[4];

    for (int j = 0; j < s->n; j++) {
        double w = (b->hi[j] - b->lo[j]) / s->t.edge[j];

        e[j] = (r[j] - p[j]) * w;
        c[j] = (x[j] - p[j]) * w;
        len += e[j] * e[j];
        t += e[j] * c[j];
    }
    t = len > 0 ? t / len : 0;
    for (int j = 0; j < s->n; j++)
        d += (c[j] - t * e[j]) * (c[j] - t * e[j]);
    return sqrt(d);
}

/* As sag, in the image of the curve. */
static double image_sag(const ix__curves *s, const graph *g, const double *p,
                        const double *x, const double *r)
{
    double t[3][4];

    if (!s->image)
        return 0;
    to_global(s, g, p, t[0]);
    to_global(s, g, x, t[1]);
    to_global(s, g, r, t[2]);
    return ix__curves_image_sag(s, t[0], t[1], t[2]);
}

typedef struct {
    double p[4], r[4];
    int level;
} chord;

#define MAX_LEVEL 24

/* Vertices between p and r (both given), r included, p not. Halving in x_k;
 * at least two levels, so that an S does not look straight. */
static ix_status trace(search *q, const graph *g, const double *p,
                       const double *r)
{
    ix__curves *s = q->s;
    chord stack[MAX_LEVEL + 1];
    double out[4];
    int top = 0;

    memcpy(stack[0].p, p, sizeof stack[0].p);
    memcpy(stack[0].r, r, sizeof stack[0].r);
    stack[0].level = 0;
    while (top >= 0) {
        chord c = stack[top--];
        double x[4];

        for (int j = 0; j < s->n; j++)
            x[j] = 0.5 * (c.p[j] + c.r[j]);
        if (c.level < MAX_LEVEL && correct(q, g, x) < 1e-6 &&
            (c.level < 2 || sag(s, g->b, c.p, x, c.r) > 0.5 * s->tol ||
             image_sag(s, g, c.p, x, c.r) > 0.5 * s->tol)) {
            chord lo = c, hi = c;

            memcpy(lo.r, x, sizeof x);
            memcpy(hi.p, x, sizeof x);
            lo.level = hi.level = c.level + 1;
            stack[++top] = hi;
            stack[++top] = lo;
            continue;
        }
        to_global(s, g, c.r, out);
        IX_TRY(ix__curves_add_pt(s, out));
    }
    return IX_OK;
}

static bool same_point(const ix__curves *s, const double *a, const double *b)
{
    for (int j = 0; j < s->n; j++)
        if (!(fabs(a[j] - b[j]) <= 1e-9)) /* parts of the cell: roots on two
                                             faces that meet at its corner */
            return false;
    return true;
}

/* The arcs of a cell with a parameter. */
static ix_status cell_arcs(search *q, graph *g, bool *ok)
{
    ix__curves *s = q->s;
    ix__pt list[MAX_FACE];
    int count, k = 0;

    *ok = leave_faces(q, g);
    if (!*ok || left_to_neighbour(s, g))
        return IX_OK;
    IX_TRY(all_face_points(q, g, list, &count, ok));
    if (!*ok)
        return IX_OK;
    for (int i = 0; i < count; i++)
        if (k == 0 || !same_point(s, list[i].x, list[k - 1].x))
            list[k++] = list[i];
    for (int i = 0; i + 1 < k; i++) {
        double x[4], out[4];
        int first = s->npts;

        for (int j = 0; j < s->n; j++)
            x[j] = 0.5 * (list[i].x[j] + list[i + 1].x[j]);
        if (!(correct(q, g, x) < 1e-6) || !inside(s, x, 1e-12))
            continue;
        to_global(s, g, list[i].x, out);
        IX_TRY(ix__curves_add_pt(s, out));
        IX_TRY(trace(q, g, list[i].x, list[i + 1].x));
        IX_TRY(ix__curves_add_arc(s, first));
    }
    return IX_OK;
}

/* --- the search
 * ----------------------------------------------------------------------------------
 */

/* Whether one of the equations is, on all of the cell, as small as its own
 * error: then smaller cells will not decide more. */
static bool below_noise(const ix__curves *s, const ix__box *b)
{
    for (int i = 0; i < s->n - 1; i++)
        if (b->mag[i] <= NOISE * b->err[i])
            return true;
    return false;
}

/* The arcs of a cell with the parameter of g; nothing unless *ok. */
static ix_status try_arcs(search *q, graph *g, int times, bool *ok)
{
    ix__curves *s = q->s;
    int arcs = s->narcs, pts = s->npts;

    IX_TRY(cell_arcs(q, g, ok));
    if (!*ok) {
        s->narcs = arcs;
        s->npts = pts;
    }
    for (int a = arcs; a < s->narcs; a++)
        s->arc[a].times = times;
    return IX_OK;
}

static ix_status examine(void *self)
{
    search *q = self;
    ix__curves *s = q->s;
    ix__box *b = &q->stack.box[q->stack.top];
    bool done = false;
    double len;
    graph g;
    int j, times;

    s->t.boxes++;
    if (!ix__box_signs_allow(&s->t, b)) {
        q->stack.top--;
        return IX_OK;
    }
    if (find_parameter(s, b, &g)) {
        IX_TRY(try_arcs(q, &g, 1, &done));
    } else if (s->n == 2) {
        times = ix__curves_multiple(s, b, q->strip, &q->twice);
        if (times && find_parameter(s, &q->twice, &g))
            IX_TRY(try_arcs(q, &g, times, &done));
    }
    if (done) {
        q->stack.top--;
        return IX_OK;
    }
    j = ix__box_longest(&s->t, b, &len);
    if (len <= s->t.cell || q->stack.top + 1 >= IX__MAX_DEPTH ||
        below_noise(s, b)) {
        q->stack.top--;
        return ix__open_box(&s->t, b, &s->singular);
    }
    return ix__stack_halve(&s->t, &q->stack, j, RATIO);
}

static ix_status make_search(ix__curves *s)
{
    size_t n = (size_t)(s->n - 1) * s->t.shape.size;
    search *q;

    IX_SCRATCH_ZERO(s->t.ctx, q, 1);
    IX_TRY(ix__stack_make(&s->t, &q->stack));
    IX_SCRATCH(s->t.ctx, q->work, 2 * s->t.shape.size);
    IX_SCRATCH(s->t.ctx, q->face, n);
    IX_SCRATCH(s->t.ctx, q->wide.c, n);
    IX_SCRATCH(s->t.ctx, q->twice.c, n);
    IX_SCRATCH(s->t.ctx, q->strip, 3 * s->t.shape.size);
    q->s = s;
    s->search = q;
    return IX_OK;
}

ix_status ix__curves_patch(ix__curves *s, const ix__box *b)
{
    search *q;

    if (!s->search)
        IX_TRY(make_search(s));
    q = s->search;
    memcpy(s->patch_lo, b->lo, sizeof s->patch_lo);
    memcpy(s->patch_hi, b->hi, sizeof s->patch_hi);
    ix__stack_start(&s->t, &q->stack, b);
    if (below_noise(s, &q->stack.box[0])) {
        s->area = true;
        return ix__open_box(&s->t, b, &s->singular);
    }
    return ix__stack_run(&s->t, &q->stack, examine, q, &s->singular);
}
