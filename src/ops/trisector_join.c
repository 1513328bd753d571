/* trisector_join.c - polylines from the arcs of a trisector: arcs that follow a
 * border of two spans come twice, and arcs end at borders behind which another
 * one goes on, with the same centre and the same feet. */
#include <math.h>
#include <string.h>

#include "geom/lines.h"
#include "geom/vec3.h"
#include "ops/trisector_impl.h"

enum { NP = 12 };

/* A centre and its feet. */
typedef struct {
    double x[NP];
} spot;

typedef struct {
    ix__tri_task *k;
    bool *twice;  /* [narcs] */
    spot *end;    /* [2 narcs]: first, last */
    double *dir;  /* [2 narcs][3]: of the centre, out of the arc */
    int *partner; /* [2 narcs], or -1 */
} joining;

static const double *vertex(const ix__tri_task *k, const ix__tri_arc *a, int v)
{
    return a->z + (size_t)(v * k->shape.nvars);
}

static spot spot_at(const ix__tri_task *k, const ix__tri_arc *a, int v)
{
    const double *z = vertex(k, a, v);
    spot s;

    memcpy(s.x, z, 3 * sizeof *z);
    for (int i = 0; i < 3; i++) {
        ix__tri_jet j;

        ix__tri_jet_at(&k->object[i].span[a->span[i]], z + k->shape.at[i], &j);
        memcpy(s.x + 3 + 3 * i, j.x, sizeof j.x);
    }
    return s;
}

/* Of the box: ends of two arcs, each to rounding where they are well
 * conditioned. */
#define SAME 1e-6

static bool within(const joining *j, const spot *a, const spot *b, double tol)
{
    for (int c = 0; c < NP; c++)
        if (!(fabs(a->x[c] - b->x[c]) <= tol * fmax(j->k->size, fabs(a->x[c]))))
            return false;
    return true;
}

static bool same(const joining *j, const spot *a, const spot *b)
{
    return within(j, a, b, SAME);
}

/* Whether the sphere is so small that curves are not followed any more. */
static bool is_tiny(const joining *j, const spot *a)
{
    return ix__dist3(a->x, a->x + 3) <= IX__TRI_TINY * j->k->size;
}

/* --- arcs that come twice ---------------------------------------------------
 */

/* Of a span: what has been corrected on a border. */
#define ON_BORDER 1e-6

static bool on_border(const ix__tri_task *k, const ix__tri_arc *a)
{
    for (int c = 3; c < k->shape.nvars; c++)
        for (int side = 0; side < 2; side++) {
            int v = 0;

            while (v < a->n && fabs(vertex(k, a, v)[c] - side) <= ON_BORDER)
                v++;
            if (v == a->n)
                return true;
        }
    return false;
}

/* Whether p is within a tenth of its length from the segment: chords are nearer
 * to their curve. */
static bool beside(const spot *a, const spot *b, const spot *p)
{
    double ab = 0.0, ap = 0.0, off = 0.0, u;

    for (int c = 0; c < NP; c++) {
        ab += (b->x[c] - a->x[c]) * (b->x[c] - a->x[c]);
        ap += (b->x[c] - a->x[c]) * (p->x[c] - a->x[c]);
    }
    u = ab > 0.0 ? fmin(fmax(ap / ab, 0.0), 1.0) : 0.0;
    for (int c = 0; c < NP; c++) {
        double d = a->x[c] + u * (b->x[c] - a->x[c]) - p->x[c];

        off += d * d;
    }
    return off <= 0.01 * ab;
}

static bool covers(const joining *j, int a, int b)
{
    const ix__tri_arc *one = &j->k->arc[a], *other = &j->k->arc[b];
    spot mid = spot_at(j->k, one, one->n / 2), last = j->end[2 * b];

    if (one->closed != other->closed)
        return false;
    for (int e = 0; e < 2 && !one->closed; e++)
        if (!same(j, &j->end[2 * a + e], &j->end[2 * b]) &&
            !same(j, &j->end[2 * a + e], &j->end[2 * b + 1]))
            return false;
    for (int v = 1; v < other->n; v++) {
        spot next = spot_at(j->k, other, v);

        if (beside(&last, &next, &mid))
            return true;
        last = next;
    }
    return false;
}

static void find_twice(joining *j)
{
    for (int a = 0; a < j->k->narcs; a++) {
        if (!on_border(j->k, &j->k->arc[a]))
            continue;
        for (int b = 0; b < a && !j->twice[a]; b++)
            j->twice[a] = !j->twice[b] && on_border(j->k, &j->k->arc[b]) &&
                          covers(j, a, b);
    }
}

/* --- ends -------------------------------------------------------------------
 */

static void measure_ends(joining *j)
{
    for (int a = 0; a < j->k->narcs; a++) {
        const ix__tri_arc *arc = &j->k->arc[a];

        for (int e = 0; e < 2; e++) {
            int i = 2 * a + e, v = e ? arc->n - 1 : 0, in = e ? v - 1 : 1;
            double *d = j->dir + (size_t)3 * (size_t)i;

            j->end[i] = spot_at(j->k, arc, v);
            j->partner[i] = -1;
            memset(d, 0, 3 * sizeof *d);
            ix__sub3(vertex(j->k, arc, v), vertex(j->k, arc, in), d);
            ix__unit3(d, d);
        }
    }
}

static bool is_free(const joining *j, int end)
{
    return !j->k->arc[end / 2].closed && !j->twice[end / 2] &&
           j->partner[end] < 0;
}

/* Whether two arcs may go on from one to the other: they have an end in common,
 * or both end on one line at a point that all objects share. */
static bool may_join(const joining *j, int e, int f, double turn)
{
    const spot *a = &j->end[e], *b = &j->end[f];

    return same(j, a, b) || (turn < -0.99 && is_tiny(j, a) && is_tiny(j, b) &&
                             within(j, a, b, 4.0 * IX__TRI_TINY));
}

/* Of several arcs that go on from an end the straightest. */
static void find_partners(joining *j)
{
    for (int e = 0; e < 2 * j->k->narcs; e++) {
        double best = HUGE_VAL;
        int with = -1;

        for (int f = e + 1; f < 2 * j->k->narcs && is_free(j, e); f++) {
            double turn;

            if (!is_free(j, f))
                continue;
            turn = ix__dot3(j->dir + (size_t)3 * (size_t)e,
                            j->dir + (size_t)3 * (size_t)f);
            if (turn < best && may_join(j, e, f, turn)) {
                best = turn;
                with = f;
            }
        }
        if (with < 0)
            continue;
        j->partner[e] = with;
        j->partner[with] = e;
    }
}

/* --- polylines --------------------------------------------------------------
 */

static void add_vertex(ix_lines *out, size_t *at, const double *p)
{
    memcpy(out->pt[*at], p, 3 * sizeof *p);
    ++*at;
    out->count[out->n - 1]++;
}

/* The arcs from the end e on, which must be new; they are marked. */
static void emit(joining *j, int e, ix_lines *out, size_t *at)
{
    size_t first = *at;
    int from = e;

    out->count[out->n++] = 0;
    do {
        const ix__tri_arc *a = &j->k->arc[from / 2];
        int step = from % 2 ? -1 : 1, v = from % 2 ? a->n - 1 : 0;

        j->twice[from / 2] = true;
        for (int i = 0; i < a->n; i++, v += step)
            if (i > 0 || from == e)
                add_vertex(out, at, vertex(j->k, a, v));
        from = a->closed ? -1 : j->partner[from ^ 1];
    } while (from >= 0 && from != e);
    if (from == e)
        memcpy(out->pt[*at - 1], out->pt[first], sizeof out->pt[first]);
}

static ix_status join(ix__tri_task *k, ix_lines *out)
{
    joining j = {.k = k};
    size_t total = 0, at = 0;

    IX_SCRATCH_ZERO(k->ctx, j.twice, k->narcs + 1);
    IX_SCRATCH(k->ctx, j.end, 2 * k->narcs + 1);
    IX_SCRATCH(k->ctx, j.dir, 6 * k->narcs + 1);
    IX_SCRATCH(k->ctx, j.partner, 2 * k->narcs + 1);
    for (int a = 0; a < k->narcs; a++)
        total += (size_t)k->arc[a].n;
    measure_ends(&j);
    find_twice(&j);
    find_partners(&j);
    IX_TRY(ix__lines_new(k->ctx, total, out));
    /* open ones from an end, then what is left: loops */
    for (int loops = 0; loops < 2; loops++)
        for (int e = 0; e < 2 * k->narcs; e++)
            if (!j.twice[e / 2] &&
                (loops || (!k->arc[e / 2].closed && j.partner[e] < 0)))
                emit(&j, e, out, &at);
    return IX_OK;
}

ix_status ix__tri_join(ix__tri_task *k, ix_lines *out)
{
    if (k->narcs == 0)
        return IX_OK;
    return join(k, out);
}
