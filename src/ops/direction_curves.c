/* direction_curves.c - see the header. */
#include "ops/direction_curves.h"

#include <math.h>
#include <string.h>

#include "base/grow.h"
#include "solve/curves_alloc.h"

#define TIE  1e-8 /* of the domain: as in solve/curves_link.c */
#define TURN 1e-6 /* of two tangents of one curve, by their cross product */

/* --- collecting
 * ---------------------------------------------------------------- */

ix_status ix__direction_begin(ix__direction_arcs *a, ix_curve_end start)
{
    IX_GROW(a->ctx, a->arc, a->narcs, a->arc_cap);
    a->arc[a->narcs++] = (ix__direction_arc){.first = a->n,
                                             .end = {start, start}};
    return IX_OK;
}

ix_status ix__direction_add(ix__direction_arcs *a, const double x[4])
{
    IX_GROW(a->ctx, a->x, a->n, a->cap);
    memcpy(a->x[a->n++], x, sizeof *a->x);
    a->arc[a->narcs - 1].n++;
    return IX_OK;
}

void ix__direction_end(ix__direction_arcs *a, ix_curve_end end)
{
    ix__direction_arc *k = &a->arc[a->narcs - 1];

    k->end[1] = end;
    if (k->n < 2) {
        a->n = k->first;
        a->narcs--;
    }
}

/* --- joining
 * ------------------------------------------------------------------- */

/* End e of arc i is number 2 i + e. */
typedef struct {
    ix__direction_arcs *a;
    ix_solution_curves *out;
    int *partner; /* -1: none */
    bool *used;   /* [narcs] */
    double *x;    /* next free vertex */
} joiner;

static double gap(const ix__direction_arcs *a, const double *x, const double *y)
{
    double d = 0.0;

    if (!(fabs(x[2] * y[3] - x[3] * y[2]) <= TURN))
        return HUGE_VAL;
    for (int i = 0; i < 2; i++)
        d = fmax(d, fabs(x[i] - y[i]) / (a->dom[i][1] - a->dom[i][0]));
    return d;
}

bool ix__direction_same(const ix__direction_arcs *a, const double x[4],
                        const double y[4])
{
    return gap(a, x, y) <= TIE;
}

static const double *end_point(const ix__direction_arcs *a, int e)
{
    const ix__direction_arc *k = &a->arc[e / 2];

    return a->x[e % 2 ? k->first + k->n - 1 : k->first];
}

/* The nearest free end within the tie. */
static int nearest(const joiner *j, int e)
{
    double best = TIE;
    int found = -1;

    for (int f = e + 1; f < 2 * j->a->narcs; f++) {
        double d;

        if (j->partner[f] >= 0 || j->a->arc[f / 2].end[0] == IX_END_CLOSED)
            continue;
        d = gap(j->a, end_point(j->a, e), end_point(j->a, f));
        if (d <= best) {
            best = d;
            found = f;
        }
    }
    return found;
}

static void find_partners(joiner *j)
{
    for (int e = 0; e < 2 * j->a->narcs; e++)
        j->partner[e] = -1;
    for (int e = 0; e < 2 * j->a->narcs; e++) {
        int f;

        if (j->a->arc[e / 2].end[0] == IX_END_CLOSED || j->partner[e] >= 0)
            continue;
        f = nearest(j, e);
        j->partner[e] = f;
        if (f >= 0)
            j->partner[f] = e;
    }
}

/* Vertices of an arc from its end e on, with the sense of the last one. */
static void put_arc(joiner *j, int e, ix_solution_curve *k)
{
    const ix__direction_arc *arc = &j->a->arc[e / 2];

    for (int i = k->n > 0; i < arc->n; i++) {
        int at = e % 2 ? arc->first + arc->n - 1 - i : arc->first + i;

        memcpy(j->x, j->a->x[at], sizeof *j->a->x);
        if (k->n > 0 && j->x[2] * j->x[-2] + j->x[3] * j->x[-1] < 0.0) {
            j->x[2] = -j->x[2];
            j->x[3] = -j->x[3];
        }
        j->x += 4;
        k->n++;
    }
}

static ix_curve_end kind_of(const joiner *j, int e)
{
    const double *x = end_point(j->a, e);
    ix_curve_end kind = j->a->arc[e / 2].end[e % 2];

    if (j->partner[e] >= 0 || kind == IX_END_CLOSED)
        return IX_END_CLOSED;
    for (int d = 0; d < 2; d++) {
        double tie = TIE * (j->a->dom[d][1] - j->a->dom[d][0]);

        if (!(x[d] > j->a->dom[d][0] + tie && x[d] < j->a->dom[d][1] - tie))
            return IX_END_BOUNDARY;
    }
    return kind == IX_END_SINGULAR ? kind : IX_END_OPEN;
}

static void put_curve(joiner *j, int e)
{
    ix_solution_curve *k = &j->out->curve[j->out->ncurves++];
    int last = e;

    *k = (ix_solution_curve){
        .x = j->x, .start_singular = -1, .end_singular = -1};
    k->start = kind_of(j, e);
    for (; e >= 0 && !j->used[e / 2]; e = j->partner[last]) {
        j->used[e / 2] = true;
        put_arc(j, e, k);
        last = e ^ 1;
    }
    k->end = kind_of(j, last);
}

static ix_status join(joiner *j)
{
    ix__direction_arcs *a = j->a;

    IX_SCRATCH(a->ctx, j->partner, 2 * a->narcs);
    IX_SCRATCH_ZERO(a->ctx, j->used, a->narcs);
    find_partners(j);
    IX_TRY(ix__solution_curves_alloc(a->ctx, 4 * (size_t)a->n, (size_t)a->narcs,
                                     0, j->out, &j->x));
    for (int e = 0; e < 2 * a->narcs; e++) /* open ends first, then loops */
        if (j->partner[e] < 0 && !j->used[e / 2])
            put_curve(j, e);
    for (int i = 0; i < a->narcs; i++)
        if (!j->used[i])
            put_curve(j, 2 * i);
    return IX_OK;
}

ix_status ix__direction_join(ix__direction_arcs *a, ix_solution_curves *out)
{
    joiner j = {.a = a, .out = out};

    out->unknowns = 4;
    IX_RETURN_SCOPED(a->ctx, join(&j));
}
