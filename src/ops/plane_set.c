/* plane_set.c - planar curves as spans, vertices and the border that is
 * walked. */
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "geom/angle.h"
#include "iritx/solve.h"
#include "ops/plane.h"

/* Tangents that differ by no more are a smooth joint; points that differ by no
 * more, of sets of size 1, are one: both well above the rounding that a spline
 * in Bezier pieces carries, and the bisector moves by no more. */
#define SMOOTH 1e-10
#define SAME   1e-11
/* Parts of a span whose speed is below this part of its largest are cusps. */
#define CUSP 1e-12

static double cross(const double *a, const double *b)
{
    return a[0] * b[1] - a[1] * b[0];
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1];
}

static bool same_point(const double *a, const double *b)
{
    return hypot(a[0] - b[0], a[1] - b[1]) <= SAME;
}

/* --- spans -----------------------------------------------------------------
 */

/* Value and derivatives by u of sum c_k u^k v^(d-k), c scaled. */
static void form_at(int d, const double *c, double u, double out[3])
{
    double v = 1.0 - u, f[3] = {0, 0, 0};

    /* Horner in the larger of u and v; derivatives of u^k v^(d-k) follow from
       F_u - F_v and its repetition. */
    for (int der = 0; der < 3; der++) {
        int n = d - der;
        double s = 0.0, p = 1.0;

        if (n < 0)
            continue;
        for (int k = 0; k <= n; k++) {
            int i = u > v ? n - k : k;
            double ck;

            if (der == 0)
                ck = c[i];
            else if (der == 1)
                ck = (i + 1) * c[i + 1] - (d - i) * c[i];
            else
                ck = (i + 2.0) * (i + 1) * c[i + 2] -
                     2.0 * (i + 1) * (d - i - 1) * c[i + 1] +
                     (double)(d - i) * (d - i - 1) * c[i];
            /* sum ck u^i v^(n-i) from the end with the larger power */
            s = u > v ? s * u + ck * p : s * v + ck * p;
            p *= u > v ? v : u;
        }
        f[der] = s;
    }
    memcpy(out, f, sizeof f);
}

void ix__span_at(const ix__set *s, const ix__span *sp, double u,
                 double out[3][2])
{
    int d = sp->degree;
    double w[3], x[3];

    (void)s;
    form_at(d, sp->p, u, w);
    for (int k = 0; k < 2; k++) {
        form_at(d, sp->p + (k + 1) * (d + 1), u, x);
        out[0][k] = x[0] / w[0];
        out[1][k] = (x[1] - out[0][k] * w[1]) / w[0];
        out[2][k] = (x[2] - 2.0 * out[1][k] * w[1] - out[0][k] * w[2]) / w[0];
    }
}

double ix__span_parameter(const ix__span *sp, double u)
{
    return u <= 0.0   ? sp->t[0]
           : u >= 1.0 ? sp->t[1]
                      : (1.0 - u) * sp->t[0] + u * sp->t[1];
}

/* w^2 x' = P'w - P w' at u, which a pole does not disturb. */
static void direction(const ix__span *sp, double u, double out[2])
{
    int d = sp->degree;
    double w[3], x[3];

    form_at(d, sp->p, u, w);
    for (int k = 0; k < 2; k++) {
        form_at(d, sp->p + (k + 1) * (d + 1), u, x);
        out[k] = x[1] * w[0] - x[0] * w[1];
    }
}

static bool unit(const double v[2], double least, double out[2])
{
    double len = hypot(v[0], v[1]);

    if (!(len > least))
        return false;
    out[0] = v[0] / len;
    out[1] = v[1] / len;
    return true;
}

void ix__span_tangent(const ix__set *s, const ix__span *sp, double u,
                      double out[2])
{
    double d[2];

    (void)s;
    if (u <= 0.0 || u >= 1.0) {
        memcpy(out, sp->tangent[u > 0.5], 2 * sizeof(double));
        return;
    }
    direction(sp, u, d);
    if (!unit(d, 0.0, out))
        out[0] = out[1] = (double)NAN;
}

/* Tangent at end e: towards the first control point that is elsewhere. */
static void end_tangent(ix__span *sp, int e)
{
    int d = sp->degree;
    const double *w = sp->p, *x = w + d + 1, *y = x + d + 1;

    sp->tangent[e][0] = sp->tangent[e][1] = 0.0;
    for (int k = 1; k <= d; k++) {
        int a = e ? d : 0, i = e ? d - k : k;
        double v[2] = {x[i] * w[a] - x[a] * w[i], y[i] * w[a] - y[a] * w[i]};
        double f = e ? -1.0 : 1.0;

        if (!unit(v, SAME * fabs(w[a]) * sp->weight, v))
            continue;
        sp->tangent[e][0] = f * v[0];
        sp->tangent[e][1] = f * v[1];
        return;
    }
}

/* What follows from p. */
static void finish_span(ix__span *sp)
{
    int d = sp->degree;
    double room[IX_MAX_ORDER];
    const double *bin = ix__binom(d, room), *w = sp->p;
    double lo = INFINITY, hi = -INFINITY;

    for (int k = 0; k < 2; k++) {
        sp->box[0][k] = INFINITY;
        sp->box[1][k] = -INFINITY;
    }
    for (int i = 0; i <= d; i++) {
        lo = fmin(lo, w[i] / bin[i]);
        hi = fmax(hi, w[i] / bin[i]);
        for (int k = 0; k < 2; k++) {
            double x = sp->p[(k + 1) * (d + 1) + i] / w[i];

            sp->box[0][k] = fmin(sp->box[0][k], x);
            sp->box[1][k] = fmax(sp->box[1][k], x);
        }
    }
    sp->weight = fmax(hi, -lo);
    sp->boxed = lo > 0.0 || hi < 0.0;
    for (int j = 0; j < IX__SEEN; j++) {
        double at[3][2];

        ix__span_at(NULL, sp, (j + 0.5) / IX__SEEN, at);
        memcpy(sp->seen[j], at[0], sizeof at[0]);
    }
    for (int e = 0; e < 2; e++) {
        int i = e ? d : 0;

        for (int k = 0; k < 2; k++)
            sp->x[e][k] = sp->p[(k + 1) * (d + 1) + i] / w[i];
        end_tangent(sp, e);
        sp->vertex[e] = -1;
    }
}

/* --- loading ---------------------------------------------------------------
 */

ix_status ix__plane_frame(ix_ctx *ctx, int n, const ix_mv *const *crv, int npts,
                          const double (*x)[2], ix_frame *out)
{
    double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY}, size;
    ix_frame f;

    for (int i = 0; i < n; i++) {
        IX_TRY(ix__frame_of(ctx, 1, &crv[i], &f));
        for (int k = 0; k < 2; k++) {
            lo[k] = fmin(lo[k], f.shift[k] - ldexp(1.0, f.exp));
            hi[k] = fmax(hi[k], f.shift[k] + ldexp(1.0, f.exp));
        }
    }
    for (int i = 0; i < npts; i++)
        for (int k = 0; k < 2; k++) {
            lo[k] = fmin(lo[k], x[i][k]);
            hi[k] = fmax(hi[k], x[i][k]);
        }
    *out = (ix_frame){.ncoords = 2};
    size = 0.5 * fmax(hi[0] - lo[0], hi[1] - lo[1]);
    if (!isfinite(size))
        return IX_FAIL(ctx, IX_EARG,
                       "coordinates that are not finite, or too "
                       "large");
    if (size > 0.0)
        (void)frexp(size, &out->exp);
    for (int k = 0; k < 2; k++)
        out->shift[k] = 0.5 * (lo[k] + hi[k]);
    return IX_OK;
}

typedef struct {
    ix_ctx *ctx;
    ix__set *set;
    int room, degree;
} builder;

static ix__span *new_span(builder *b)
{
    return &b->set->span[b->set->nspans++];
}

/* The rows w, x, y of a span: copies of length d + 1 at stride n. */
static ix_status copy_rows(ix_ctx *ctx, int d, size_t n, const double *c,
                           bool rational, double **out)
{
    double *p, room[IX_MAX_ORDER];
    const double *bin = ix__binom(d, room);

    IX_SCRATCH(ctx, p, 3 * (d + 1));
    for (int i = 0; i <= d; i++) {
        p[i] = rational ? c[i] : bin[i];
        p[d + 1 + i] = c[(rational ? n : 0) + (size_t)i];
        p[2 * (d + 1) + i] = c[(rational ? 2 * n : n) + (size_t)i];
    }
    *out = p;
    return IX_OK;
}

/* The part of span sp beyond end e, to infinity: in homogeneous parameters
 * from (0, 1) or (1, 0) on to (-1, 1), where u + v is 0. */
static ix_status add_ray(builder *b, const ix__span *sp, int e)
{
    int d = sp->degree;
    double *p, room[IX_MAX_ORDER];
    const double *bin = ix__binom(d, room);
    ix__span *ray;

    IX_SCRATCH(b->ctx, p, 3 * (d + 1));
    for (int k = 0; k < 3; k++) {
        const double *c = sp->p + k * (d + 1);
        double *o = p + k * (d + 1);

        /* sum c_i (-s)^j, j = i or d - i: monomials to scaled Bernstein */
        memset(o, 0, (size_t)(d + 1) * sizeof(double));
        for (int j = 0; j <= d; j++) {
            double f = (j & 1 ? -1.0 : 1.0) * c[e ? d - j : j], m = 1.0;

            for (int i = j; i <= d; i++) {
                o[i] += f * m; /* s^j = sum C(d-j, i-j) s^i (1-s)^(d-i) */
                m = m * (d - i) / (i - j + 1);
            }
        }
    }
    (void)bin;
    ray = new_span(b);
    *ray = (ix__span){.degree = d, .p = p, .phantom = true};
    ray->curve = sp->curve;
    ray->t[0] = sp->t[e];
    ray->t[1] = e ? INFINITY : -INFINITY;
    ray->strand = -1;
    finish_span(ray);
    ray->boxed = false;
    return IX_OK;
}

/* Spans of one curve that are no points, in order. */
static ix_status load_curve(builder *b, const ix_mv *crv, int index,
                            const ix_frame *frame)
{
    const ix_spans *sp;
    ix_form f;
    size_t n;

    IX_TRY(ix__forms_load(b->ctx, 1, &crv, frame, &f));
    sp = &f.dirs[0];
    n = (size_t)sp->degree + 1;
    for (int j = 0; j < sp->nspans; j++) {
        ix__span *s = new_span(b);
        double *p;

        IX_TRY(copy_rows(b->ctx, sp->degree, f.n, f.c + (size_t)j * n,
                         crv->rational, &p));
        *s = (ix__span){.degree = sp->degree, .p = p, .curve = index};
        s->t[0] = sp->breaks[j];
        s->t[1] = sp->breaks[j + 1];
        finish_span(s);
        if (dot(s->tangent[0], s->tangent[0]) == 0.0)
            b->set->nspans--;
    }
    b->degree = sp->degree > b->degree ? sp->degree : b->degree;
    return IX_OK;
}

/* --- cusps ------------------------------------------------------------------
 */

/* Cuts a span at u into two, the second one following it in the array. */
static ix_status cut(builder *b, int index, double u)
{
    ix__set *s = b->set;
    ix__span *sp = &s->span[index], *next;
    int d = sp->degree;
    double *p, *q, room[IX_MAX_ORDER];
    const double *bin = ix__binom(d, room);

    IX_SCRATCH(b->ctx, p, 3 * (d + 1));
    IX_SCRATCH(b->ctx, q, 3 * (d + 1));
    for (int k = 0; k < 3; k++) {
        double *l = p + k * (d + 1), *r = q + k * (d + 1);

        for (int i = 0; i <= d; i++)
            r[i] = sp->p[k * (d + 1) + i] / bin[i];
        for (int j = 0; j <= d; j++) {
            l[j] = r[0];
            for (int i = 0; i < d - j; i++)
                r[i] = (1.0 - u) * r[i] + u * r[i + 1];
        }
        for (int i = 0; i <= d; i++) {
            l[i] *= bin[i];
            r[i] *= bin[i];
        }
    }
    memmove(sp + 1, sp, (size_t)(s->nspans - index) * sizeof *sp);
    s->nspans++;
    next = sp + 1;
    next->p = q;
    sp->p = p;
    sp->t[1] = next->t[0] = (1.0 - u) * sp->t[0] + u * sp->t[1];
    finish_span(sp);
    finish_span(next);
    return IX_OK;
}

/* Squared speed and half its derivative, of D = P'w - Pw'. */
static double speed(const ix__span *sp, double u)
{
    double d[2];

    direction(sp, u, d);
    return dot(d, d);
}

/* The place in [a, b] where the speed is least, by golden section: at a cusp
 * the squared speed is a parabola down to 0, found to about 1e-8 of the
 * interval, where it is below 1e-16 of its largest value. */
static double slowest(const ix__span *sp, double a, double b)
{
    const double g = 0.6180339887498949;
    double c = b - g * (b - a), d = a + g * (b - a);
    double fc = speed(sp, c), fd = speed(sp, d);

    while (b - a > 1e-15) {
        if (fc < fd) {
            b = d;
            d = c;
            fd = fc;
            c = b - g * (b - a);
            fc = speed(sp, c);
        } else {
            a = c;
            c = d;
            fc = fd;
            d = a + g * (b - a);
            fd = speed(sp, d);
        }
        if (c >= d)
            break;
    }
    return 0.5 * (a + b);
}

/* Cuts where the speed is zero inside a span. */
static ix_status cut_cusps(builder *b)
{
    enum { GRID = 32 };

    for (int i = 0; i < b->set->nspans; i++) {
        const ix__span *sp = &b->set->span[i];
        double f[GRID + 1], big = 0.0;

        for (int j = 0; j <= GRID; j++) {
            f[j] = speed(sp, (double)j / GRID);
            big = fmax(big, f[j]);
        }
        for (int j = 1; j < GRID; j++) {
            double u;

            if (!(f[j] <= f[j - 1] && f[j] <= f[j + 1] && f[j] < 1e-2 * big) ||
                b->set->nspans >= b->room)
                continue;
            u = slowest(sp, (j - 1.0) / GRID, (j + 1.0) / GRID);
            if (!(speed(sp, u) <= CUSP * big))
                continue;
            IX_TRY(cut(b, i, u));
            break; /* the second part is looked at next */
        }
    }
    return IX_OK;
}

/* --- joints ----------------------------------------------------------------
 */

static int new_vertex(ix__set *s, const ix__span *sp, int e)
{
    ix__vertex *v = &s->vertex[s->nvertices];

    *v = (ix__vertex){.t = sp->t[e], .curve = sp->curve};
    memcpy(v->x, sp->x[e], sizeof v->x);
    return s->nvertices++;
}

static bool finite_end(const ix__span *sp, int e)
{
    return isfinite(sp->x[e][0]) && isfinite(sp->x[e][1]);
}

static bool joined(const ix__span *a, const ix__span *b)
{
    return a->curve == b->curve && finite_end(a, 1) && finite_end(b, 0) &&
           same_point(a->x[1], b->x[0]);
}

static bool smooth(const ix__span *a, const ix__span *b)
{
    return dot(a->tangent[1], b->tangent[0]) > 0.0 &&
           fabs(cross(a->tangent[1], b->tangent[0])) <= SMOOTH;
}

/* Vertices of the joint between two spans. */
static void join(ix__set *s, ix__span *a, ix__span *b)
{
    if (!smooth(a, b))
        a->vertex[1] = b->vertex[0] = new_vertex(s, b, 0);
}

static void end_vertex(ix__set *s, ix__span *sp, int e)
{
    if (finite_end(sp, e))
        sp->vertex[e] = new_vertex(s, sp, e);
}

static void make_strand(ix__set *s, int first, int count)
{
    ix__strand *st = &s->strand[s->nstrands];
    ix__span *a = &s->span[first], *z = a + count - 1;

    *st = (ix__strand){first, count, joined(z, a)};
    for (int i = 0; i < count; i++) {
        a[i].strand = s->nstrands;
        if (i)
            join(s, &a[i - 1], &a[i]);
    }
    if (st->closed)
        join(s, z, a);
    else {
        end_vertex(s, a, 0);
        end_vertex(s, z, 1);
    }
    s->nstrands++;
}

static void make_strands(ix__set *s)
{
    int n = s->nspans, first = 0;

    for (int i = 1; i <= n; i++)
        if (i == n || !joined(&s->span[i - 1], &s->span[i])) {
            make_strand(s, first, i - first);
            first = i;
        }
}

/* --- border ----------------------------------------------------------------
 */

static void add_side(ix__set *s, int span, int side)
{
    s->border[s->nborders++] = (ix__border){
        .kind = IX__SIDE, .index = span, .side = side};
}

/* The normal turns clockwise by turn, from the left of tangent. */
static void add_fan(ix__set *s, int vertex, const double tangent[2],
                    double turn)
{
    double from = atan2(tangent[0], -tangent[1]);

    s->border[s->nborders++] = (ix__border){
        .kind = IX__FAN, .index = vertex, .from = from, .to = from - turn};
}

/* Does the curve, which reverses at the joint of a and b, come back on the
 * right? */
static bool returns_right(const ix__set *s, const ix__span *a,
                          const ix__span *b)
{
    double p[3][2], q[3][2], v[2], h = 1e-3;

    ix__span_at(s, a, 1.0 - h, p);
    ix__span_at(s, b, h, q);
    v[0] = q[0][0] - a->x[1][0];
    v[1] = q[0][1] - a->x[1][1];
    p[0][0] -= a->x[1][0];
    p[0][1] -= a->x[1][1];
    return cross(a->tangent[1], v) < cross(a->tangent[1], p[0]);
}

static double turn_at(const ix__set *s, const ix__span *a, const ix__span *b)
{
    double c = cross(a->tangent[1], b->tangent[0]);
    double turn = atan2(c, dot(a->tangent[1], b->tangent[0]));

    if (fabs(turn) > IX__PI - SMOOTH)
        turn = returns_right(s, a, b) ? -IX__PI : IX__PI;
    return turn;
}

/* The fan between two spans on one side, if it is there. Walked from a to b on
 * the left, from b to a on the right. */
static void joint_fan(ix__set *s, const ix__span *a, const ix__span *b,
                      int side)
{
    double turn, back[2] = {-b->tangent[0][0], -b->tangent[0][1]};

    if (a->vertex[1] < 0)
        return;
    turn = turn_at(s, a, b);
    if (side * turn < 0.0)
        add_fan(s, a->vertex[1], side > 0 ? a->tangent[1] : back, fabs(turn));
}

static void open_loop(ix__set *s, const ix__strand *st)
{
    const ix__span *a = &s->span[st->first], *z = a + st->count - 1;
    double back[2] = {-a->tangent[0][0], -a->tangent[0][1]};

    for (int i = 0; i < st->count; i++) {
        if (i)
            joint_fan(s, a + i - 1, a + i, 1);
        add_side(s, st->first + i, 1);
    }
    if (z->vertex[1] >= 0)
        add_fan(s, z->vertex[1], z->tangent[1], IX__PI);
    for (int i = st->count - 1; i >= 0; i--) {
        add_side(s, st->first + i, -1);
        if (i)
            joint_fan(s, a + i - 1, a + i, -1);
    }
    if (a->vertex[0] >= 0)
        add_fan(s, a->vertex[0], back, IX__PI);
}

static void closed_loop(ix__set *s, const ix__strand *st, int side)
{
    int n = st->count;
    const ix__span *a = &s->span[st->first];

    for (int k = 0; k < n; k++) {
        int i = side > 0 ? k : n - 1 - k;

        add_side(s, st->first + i, side);
        if (side > 0)
            joint_fan(s, a + i, a + (i + 1) % n, 1);
        else
            joint_fan(s, a + (i + n - 1) % n, a + i, -1);
    }
}

static void make_loop(ix__set *s, int strand, int side)
{
    const ix__strand *st = &s->strand[strand];
    ix__loop *l = &s->loop[s->nloops++];

    *l = (ix__loop){s->nborders, 0, strand, side};
    if (side)
        closed_loop(s, st, side);
    else
        open_loop(s, st);
    l->count = s->nborders - l->first;
}

/* --- entry -----------------------------------------------------------------
 */

static ix_status allocate(builder *b, int room)
{
    ix__set *s = b->set;

    b->room = room;
    IX_SCRATCH(b->ctx, s->span, room);
    IX_SCRATCH(b->ctx, s->vertex, 2 * room);
    IX_SCRATCH(b->ctx, s->strand, room);
    IX_SCRATCH(b->ctx, s->loop, 2 * room);
    IX_SCRATCH(b->ctx, s->border, 4 * room + 2);
    return IX_OK;
}

/* For searches in spans of that degree: plane_touch.c has the layout. */
static ix_status make_work(builder *b)
{
    IX_SCRATCH(b->ctx, b->set->work, 160 * (b->degree + 2));
    return IX_OK;
}

/* A segment that passes through infinity has no offset curves and no feet
 * there: halving would go on for ever. */
static ix_status check_poles(ix_ctx *ctx, const ix_mv *c, int index)
{
    double at = 0.0;
    ix_root *r;
    int n;

    if (!ix_mv_has_poles(c))
        return IX_OK;
    IX_TRY(ix_roots(ctx, c, 0, NULL, &r, &n));
    if (n)
        at = r[0].t;
    ix_roots_free(ctx, r, n);
    if (n)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "curve %d has a pole at %g: its weight is zero; parts "
                       "without poles (FFFINITE) are wanted",
                       index + 1, at);
    return IX_OK;
}

static ix_status check_curve(ix_ctx *ctx, const ix_mv *c, int index)
{
    if (c->ndirs != 1 || c->ncoords != 2)
        return IX_FAIL(ctx, IX_EARG,
                       "operand %d has %d directions and %d coordinates: a "
                       "curve of the plane, with two, is needed",
                       index + 1, c->ndirs, c->ncoords);
    return check_poles(ctx, c, index);
}

static int count_spans(int n, const ix_mv *const *crv)
{
    int room = 0;

    for (int i = 0; i < n; i++)
        room += ix_mv_length(crv[i], 0) + ix_mv_order(crv[i], 0) + 2;
    return 2 * room; /* cusps cut spans */
}

static ix_status add_rays(builder *b)
{
    ix__set *s = b->set;

    for (int i = 0; i < s->nstrands; i++) {
        ix__strand st = s->strand[i];
        int ends[2] = {st.first, st.first + st.count - 1};

        for (int e = 0; !st.closed && e < 2; e++) {
            ix__span *sp = &s->span[ends[e]];

            IX_TRY(add_ray(b, sp, e));
            sp->vertex[e] = -1;
        }
    }
    return IX_OK;
}

ix_status ix__set_of_curves(ix_ctx *ctx, int n, const ix_mv *const *crv,
                            const ix_frame *frame, ix__set_opts o, ix__set *out)
{
    builder b = {.ctx = ctx, .set = out};

    *out = (ix__set){0};
    for (int i = 0; i < n; i++)
        IX_TRY(check_curve(ctx, crv[i], i));
    IX_TRY(allocate(&b, count_spans(n, crv)));
    for (int i = 0; i < n; i++) {
        int before = out->nspans;

        IX_TRY(load_curve(&b, crv[i], i, frame));
        if (out->nspans == before)
            return IX_FAIL(ctx, IX_EDOMAIN, "curve %d is a point", i + 1);
    }
    IX_TRY(cut_cusps(&b));
    make_strands(out);
    if (o.carrier)
        IX_TRY(add_rays(&b));
    for (int i = 0; i < out->nstrands; i++) {
        make_loop(out, i, out->strand[i].closed ? 1 : 0);
        if (out->strand[i].closed)
            make_loop(out, i, -1);
    }
    return make_work(&b);
}

ix_status ix__set_of_point(ix_ctx *ctx, const double x[2], ix__set *out)
{
    builder b = {.ctx = ctx, .set = out};
    static const double left[2] = {0.0, 1.0}; /* whose left is at pi */
    ix__span *sp;
    double *p;

    *out = (ix__set){0};
    IX_TRY(allocate(&b, 1));
    IX_SCRATCH(ctx, p, 3);
    p[0] = 1.0;
    p[1] = x[0];
    p[2] = x[1];
    sp = new_span(&b);
    *sp = (ix__span){.degree = 0, .p = p};
    finish_span(sp);
    sp->vertex[0] = sp->vertex[1] = new_vertex(out, sp, 0);
    out->strand[out->nstrands++] = (ix__strand){0, 1, false};
    out->loop[out->nloops++] = (ix__loop){0, 1, 0, 0};
    add_fan(out, 0, left, -2.0 * IX__PI); /* counter-clockwise */
    return make_work(&b);
}

static void share(ix__set *a, const ix__set *b)
{
    for (int i = 0; i < a->nvertices; i++)
        if (ix__set_distance(b, a->vertex[i].x, NULL) <= SAME)
            a->vertex[i].shared = true;
}

void ix__sets_share(ix__set *a, ix__set *b)
{
    share(a, b);
    share(b, a);
}
