/* curves_link.c - arcs of single cells joined to whole curves.
 *
 * An arc's end lies on a face of its cell; the neighbour has an arc that ends
 * in the same point, computed independently, so they agree to rounding. Ends
 * without a partner lie on the domain's boundary, at a singular point, or at a
 * jump of the functions. */
#include <math.h>
#include <string.h>

#include "solve/curves_alloc.h"
#include "solve/curves_impl.h"

#define TIE                                                           \
    1e-8 /* of the domain's edges: a root on a face is known to about \
            1e-12, different ones are rarely this close */

/* End e of arc a is number 2 a + e; e = 0 its first point, 1 its last. */
typedef struct {
    ix__curves *s;
    int nends;
    int *order;   /* ends by their first coordinate */
    int *partner; /* -1: none */
    int *single;  /* singular point at an end, -1: none */
} links;

static const double *end_point(const ix__curves *s, int e)
{
    const ix__arc *a = &s->arc[e / 2];

    return s->pts[e % 2 ? a->first + a->n - 1 : a->first].x;
}

static double distance(const ix__curves *s, const double *a, const double *b)
{
    double d = 0;

    for (int j = 0; j < s->n; j++)
        d = fmax(d, fabs(a[j] - b[j]) / s->t.edge[j]);
    return d;
}

/* Shell sort of ends by first coordinate, then number: deterministic. */
static void sort_ends(links *l)
{
    static const int gaps[] = {86961, 33936, 13776, 4592, 1968, 861, 336,
                               112,   48,    21,    7,    3,    1};

    for (size_t g = 0; g < sizeof gaps / sizeof *gaps; g++)
        for (int gap = gaps[g], i = gap; i < l->nends; i++) {
            int t = l->order[i], k = i;
            double x = end_point(l->s, t)[0];

            for (; k >= gap; k -= gap) {
                int o = l->order[k - gap];
                double y = end_point(l->s, o)[0];

                if (y < x || (!(y > x) && o < t))
                    break;
                l->order[k] = o;
            }
            l->order[k] = t;
        }
}

/* The nearest free end within tie of the i-th in order, -1 if there is none. */
static int nearest(const links *l, int i, double tie)
{
    const ix__curves *s = l->s;
    const double *p = end_point(s, l->order[i]);
    double best = tie;
    int found = -1;

    for (int k = i + 1; k < l->nends; k++) {
        const double *q = end_point(s, l->order[k]);

        if (q[0] - p[0] > tie * s->t.edge[0])
            break;
        if (l->partner[l->order[k]] < 0 && l->order[k] != (l->order[i] ^ 1) &&
            distance(s, p, q) < best) {
            best = distance(s, p, q);
            found = l->order[k];
        }
    }
    return found;
}

/* The closest pairs first: near a cusp two branches run within 1e-8. */
static void find_partners(links *l)
{
    for (double tie = 1e-14; tie <= TIE; tie *= 100)
        for (int i = 0; i < l->nends; i++) {
            int e = l->order[i], f;

            if (l->partner[e] >= 0)
                continue;
            f = nearest(l, i, tie);
            if (f >= 0) {
                l->partner[e] = f;
                l->partner[f] = e;
            }
        }
}

#define PAD                                                                 \
    0x1p-6 /* of the domain, at most: rounding spoils the surroundings of a \
              singular point, not those of a patch that vanishes */

/* The singular point whose box an end touches. */
static int at_singular(const ix__curves *s, const double *p)
{
    for (int i = 0; i < s->singular.n; i++) {
        const ix_solution *r = &s->singular.sol[i];
        bool in = true;

        for (int j = 0; in && j < s->n; j++) {
            double pad = 2 * s->t.cell * s->t.edge[j] +
                         fmin(0.25 * (r->hi[j] - r->lo[j]), PAD * s->t.edge[j]);

            in = p[j] >= r->lo[j] - pad && p[j] <= r->hi[j] + pad;
        }
        if (in)
            return i;
    }
    return -1;
}

/* --- arcs that two patches found on their common face
 * ------------------------- */

static bool same_arc(const ix__curves *s, int a, int b)
{
    const ix__arc *p = &s->arc[a], *q = &s->arc[b];
    const double *m = s->pts[p->first + p->n / 2].x;
    bool back = distance(s, end_point(s, 2 * a), end_point(s, 2 * b + 1)) < TIE;
    double best = HUGE_VAL;

    if (!(distance(s, end_point(s, 2 * a), end_point(s, 2 * b + back)) < TIE &&
          distance(s, end_point(s, 2 * a + 1), end_point(s, 2 * b + !back)) <
              TIE))
        return false;
    for (int i = 0; i < q->n; i++)
        best = fmin(best, distance(s, m, s->pts[q->first + i].x));
    return best < TIE;
}

/* Removes doubles; ends are in order, so candidates are near each other. */
static void drop_doubles(links *l)
{
    ix__curves *s = l->s;
    int kept = 0;

    for (int i = 0; i < l->nends; i++) {
        int a = l->order[i] / 2;

        if (s->arc[a].n == 0)
            continue;
        for (int k = i + 1; k < l->nends; k++) {
            int b = l->order[k] / 2;

            if (end_point(s, l->order[k])[0] - end_point(s, l->order[i])[0] >
                TIE * s->t.edge[0])
                break;
            if (b != a && s->arc[b].n > 0 && same_arc(s, a, b)) {
                s->arc[b].first = s->arc[a].first;
                s->arc[b].n = 0;
                break;
            }
        }
    }
    for (int a = 0; a < s->narcs; a++)
        if (s->arc[a].n > 0)
            s->arc[kept++] = s->arc[a];
    s->narcs = kept;
    l->nends = 2 * kept;
    for (int i = 0; i < l->nends; i++)
        l->order[i] = i;
    sort_ends(l);
}

/* Removes arcs that lie in the box of one singular point: what the rounding
 * errors let through there. */
static void drop_inside(ix__curves *s)
{
    int kept = 0;

    for (int a = 0; a < s->narcs; a++) {
        const ix__arc *arc = &s->arc[a];
        int at = at_singular(s, s->pts[arc->first].x);
        bool in = at >= 0;

        for (int i = 1; in && i < arc->n; i++)
            in = at_singular(s, s->pts[arc->first + i].x) == at;
        if (!in)
            s->arc[kept++] = *arc;
    }
    s->narcs = kept;
}

static bool on_boundary(const ix__curves *s, const double *p)
{
    for (int j = 0; j < s->n; j++) {
        double tie = TIE * s->t.edge[j];

        if (p[j] <= s->lo[j] + tie || p[j] >= s->hi[j] - tie)
            return true;
    }
    return false;
}

/* Whether p is no further from the box than its largest edge, twice. */
static bool near_box(const ix__curves *s, const ix_solution *r, const double *p)
{
    double size = 0;

    for (int j = 0; j < s->n; j++)
        size = fmax(size, (r->hi[j] - r->lo[j]) / s->t.edge[j]);
    size = fmin(size, 4 * PAD);
    for (int j = 0; j < s->n; j++) {
        double pad = 2 * size * s->t.edge[j];

        if (!(p[j] >= r->lo[j] - pad && p[j] <= r->hi[j] + pad))
            return false;
    }
    return true;
}

/* An end inside the domain without a partner, near a singular point, shows
 * that rounding has spoilt more than its box: the box grows to hold the end.
 * True if one has grown. */
static bool absorb_ends(links *l)
{
    ix__curves *s = l->s;
    bool grown = false;

    for (int e = 0; e < l->nends; e++) {
        const double *p = end_point(s, e);

        if (l->partner[e] >= 0 || at_singular(s, p) >= 0 || on_boundary(s, p))
            continue;
        for (int i = 0; i < s->singular.n; i++) {
            ix_solution *r = &s->singular.sol[i];

            if (!near_box(s, r, p))
                continue;
            for (int j = 0; j < s->n; j++) {
                r->lo[j] = fmin(r->lo[j], p[j]);
                r->hi[j] = fmax(r->hi[j], p[j]);
                r->x[j] = 0.5 * (r->lo[j] + r->hi[j]);
            }
            grown = true;
            break;
        }
    }
    return grown;
}

/* --- curves that count several times
 * ----------------------------------------------------------------------- */

#define SHORT                                                              \
    0x1p-6 /* of the domain: near a contact of order p of two branches, or \
              a cusp, f is below rounding over 1e-15^(1/p), which looks    \
              like a curve that counts twice: there the point is singular */

typedef struct {
    double lo[4], hi[4];
} extent;

static void widen(const ix__curves *s, int arc, extent *x)
{
    for (int i = 0; i < s->arc[arc].n; i++)
        for (int j = 0; j < s->n; j++) {
            double t = s->pts[s->arc[arc].first + i].x[j];

            x->lo[j] = fmin(x->lo[j], t);
            x->hi[j] = fmax(x->hi[j], t);
        }
}

/* The chain of such arcs that begins with end e, outwards; marks them. */
static void follow(const links *l, int e, bool *seen, extent *x)
{
    while (e >= 0 && l->s->arc[e / 2].times > 1 && !seen[e / 2]) {
        seen[e / 2] = true;
        widen(l->s, e / 2, x);
        e = l->partner[e ^ 1];
    }
}

/* Adds a singular box for chains that are short, whose arcs drop_inside then
 * takes away. */
static ix_status make_points(links *l, bool *any)
{
    ix__curves *s = l->s;
    bool *seen;

    *any = false;
    IX_SCRATCH_ZERO(s->t.ctx, seen, s->narcs);
    for (int a = 0; a < s->narcs; a++) {
        ix_solution r = {.certified = false};
        double longest = 0;
        extent x;

        if (seen[a] || s->arc[a].times < 2)
            continue;
        for (int j = 0; j < s->n; j++) {
            x.lo[j] = HUGE_VAL;
            x.hi[j] = -HUGE_VAL;
        }
        follow(l, 2 * a, seen, &x);
        follow(l, l->partner[2 * a], seen, &x);
        for (int j = 0; j < s->n; j++) {
            r.lo[j] = x.lo[j];
            r.hi[j] = x.hi[j];
            r.x[j] = 0.5 * (x.lo[j] + x.hi[j]);
            longest = fmax(longest, (x.hi[j] - x.lo[j]) / s->t.edge[j]);
        }
        if (longest < SHORT) {
            IX_TRY(ix__found_add(&s->singular, &r));
            *any = true;
        }
    }
    return IX_OK;
}

#define MAX_GROWTH 20

static ix_status make_links(ix__curves *s, links *l)
{
    *l = (links){.s = s, .nends = 2 * s->narcs};
    IX_SCRATCH(s->t.ctx, l->order, l->nends);
    IX_SCRATCH(s->t.ctx, l->partner, l->nends);
    IX_SCRATCH(s->t.ctx, l->single, l->nends);
    for (int round = 0; round < MAX_GROWTH; round++) {
        bool any;

        IX_TRY(ix__found_merge(&s->singular, s->n, s->t.edge));
        drop_inside(s);
        l->nends = 2 * s->narcs;
        for (int e = 0; e < l->nends; e++)
            l->order[e] = e;
        sort_ends(l);
        drop_doubles(l);
        for (int e = 0; e < l->nends; e++)
            l->partner[e] = -1;
        find_partners(l);
        IX_TRY(make_points(l, &any));
        if (!any && !absorb_ends(l))
            break;
    }
    for (int e = 0; e < l->nends; e++)
        l->single[e] = l->partner[e] < 0 ? at_singular(s, end_point(s, e)) : -1;
    return IX_OK;
}

/* --- output
 * ------------------------------------------------------------------------ */

static ix_curve_end kind_of_end(const links *l, int e)
{
    if (on_boundary(l->s, end_point(l->s, e)))
        return IX_END_BOUNDARY;
    return l->single[e] >= 0 ? IX_END_SINGULAR : IX_END_OPEN;
}

typedef struct {
    ix_solution_curves *out;
    double *x;  /* next free vertex */
    bool *used; /* [narcs] */
} writer;

/* Vertices of arc a, from its end e on, without the first if skip. */
static void put_arc(writer *w, const ix__curves *s, int e, bool skip,
                    ix_solution_curve *c)
{
    const ix__arc *a = &s->arc[e / 2];

    for (int i = skip; i < a->n; i++) {
        int k = e % 2 ? a->first + a->n - 1 - i : a->first + i;

        memcpy(w->x, s->pts[k].x, (size_t)s->n * sizeof *w->x);
        w->x += s->n;
        c->n++;
    }
}

/* The curve that starts with end e of its first arc. */
static void put_curve(writer *w, const links *l, int e)
{
    const ix__curves *s = l->s;
    ix_solution_curve *c = &w->out->curve[w->out->ncurves++];
    int last = e;

    *c = (ix_solution_curve){
        .x = w->x, .start_singular = l->single[e], .end_singular = -1};
    c->start = l->partner[e] < 0 ? kind_of_end(l, e) : IX_END_CLOSED;
    for (int a = e; a >= 0 && !w->used[a / 2]; a = l->partner[a ^ 1]) {
        w->used[a / 2] = true;
        put_arc(w, s, a, c->n > 0, c);
        c->times = s->arc[a / 2].times > c->times ? s->arc[a / 2].times
                                                  : c->times;
        last = a ^ 1;
    }
    c->end = l->partner[last] < 0 ? kind_of_end(l, last) : IX_END_CLOSED;
    c->end_singular = l->single[last];
    if (c->end == IX_END_CLOSED) /* the very same numbers */
        memcpy(w->x - s->n, c->x, (size_t)s->n * sizeof *w->x);
}

static ix_status allocate(ix__curves *s, ix_solution_curves *out, double **x)
{
    size_t nx = 0;

    for (int a = 0; a < s->narcs; a++)
        nx += (size_t)s->arc[a].n * (size_t)s->n;
    return ix__solution_curves_alloc(s->t.ctx, nx, (size_t)s->narcs,
                                     (size_t)s->singular.n, out, x);
}

ix_status ix__curves_link(ix__curves *s, ix_solution_curves *out)
{
    writer w = {.out = out};
    links l;

    IX_TRY(make_links(s, &l));
    IX_SCRATCH_ZERO(s->t.ctx, w.used, s->narcs);
    IX_TRY(allocate(s, out, &w.x));
    for (int i = 0; i < s->singular.n; i++) {
        out->singular[i] = s->singular.sol[i];
        out->arcs[i] = 0;
    }
    out->nsingular = s->singular.n;
    for (int e = 0; e < l.nends; e++)
        if (l.single[e] >= 0)
            out->arcs[l.single[e]]++;
    for (int i = 0; i < l.nends; i++) /* open ends first, then loops */
        if (l.partner[l.order[i]] < 0 && !w.used[l.order[i] / 2])
            put_curve(&w, &l, l.order[i]);
    for (int i = 0; i < l.nends; i++)
        if (!w.used[l.order[i] / 2])
            put_curve(&w, &l, l.order[i]);
    return IX_OK;
}
