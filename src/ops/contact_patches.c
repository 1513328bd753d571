/* contact_patches.c - see the header. */
#include "ops/contact_patches.h"

#include <math.h>
#include <string.h>

#include "geom/parts.h"
#include "geom/unit_solve.h"
#include "geom/vec3.h"
#include "iritx/contour.h"
#include "ops/direction_curves.h"
#include "ops/line_contact.h"
#include "ops/surface.h"
#include "solve/box.h"

/* Patches that are nearly ruled end the search: others need some thousands. */
#define MAX_BOXES 200000
#define BEYOND    0.03125 /* of a patch: by how much it is enlarged */
#define SLACK     1e-10   /* of a patch: what counts as on its edge */
#define LEVELS    12      /* of halving for turn */

/* A vertex: (u, v, r) of the enlarged patch, (u, v, a, b), direction. */
typedef struct {
    double x[3], at[4], d[3];
} vertex;

typedef struct {
    ix_ctx *ctx;
    const ix_mv *s;
    double tol, turn;
    int order;
    ix__direction_arcs arcs; /* of curves */
    ix__found found;         /* points, (u, v, a, b) */
    int patches, ruled;
    bool complete;
    size_t boxes;
    /* the present patch */
    ix__line_contact c;
    const ix_mv *face[3]; /* u, v, r as functions of (u, v, r) */
    double at[2];         /* the enlarged patch in the patch's [0, 1] */
    double in[2];         /* the patch in the enlarged one's [0, 1] */
    double own[2][2];     /* in the surface's parameters */
    bool last[2];         /* nothing follows in this direction */
} walk;

/* --- places
 * -------------------------------------------------------------------- */

/* (u, v, r) of the enlarged patch as one of the patch. */
static void to_patch(const walk *w, const double *x, double y[3])
{
    for (int d = 0; d < 3; d++)
        y[d] = w->at[0] + x[d] * (w->at[1] - w->at[0]);
}

static void place(const walk *w, const double *x, double at[4])
{
    double y[3];

    to_patch(w, x, y);
    ix__line_contact_place(&w->c, y, at);
    for (int d = 0; d < 2; d++) {
        double slack = 2.0 * SLACK * (w->own[d][1] - w->own[d][0]);

        for (int e = 0; e < 2; e++)
            if (fabs(at[d] - w->own[d][e]) <= slack)
                at[d] = w->own[d][e];
    }
}

/* What x is outside of: 2 d + e for direction d, at its low or high end; -1:
 * inside. */
static int outside(const walk *w, const double *x)
{
    for (int d = 0; d < 3; d++) {
        if (!(x[d] >= w->in[0] - SLACK))
            return 2 * d;
        if (!(x[d] <= w->in[1] + SLACK))
            return 2 * d + 1;
    }
    return -1;
}

/* Whether x is on an edge that the next patch, or chart, has too: what runs
 * along it is left to that one. */
static bool is_of_next(const walk *w, const double *x)
{
    for (int d = 0; d < 3; d++)
        if (!(d < 2 && w->last[d]) && !(x[d] < w->in[1] - SLACK))
            return true;
    return false;
}

/* The vertex at v->x; *found is false where the surface has no normal. */
static ix_status locate(const walk *w, vertex *v, bool *found)
{
    ix_srf_jet j;
    ix_status st;

    place(w, v->x, v->at);
    st = ix__srf_jet(w->ctx, w->s, v->at[0], v->at[1], &j);
    *found = false;
    if (st == IX_EDOMAIN)
        return IX_OK;
    IX_TRY(st);
    for (int k = 0; k < 3; k++)
        v->d[k] = v->at[2] * j.su[k] + v->at[3] * j.sv[k];
    *found = ix__unit3(v->d, v->d) > 0.0;
    return IX_OK;
}

/* --- steps between vertices
 * ---------------------------------------------------- */

/* Does the chord a b leave m between them too far away? */
static bool bends(const walk *w, const vertex *a, const vertex *m,
                  const vertex *b)
{
    double chord[3], off[3], t, len2;
    double sign = ix__dot3(a->d, b->d) < 0.0 ? -1.0 : 1.0;
    double side = ix__dot3(a->d, m->d) < 0.0 ? -1.0 : 1.0;

    for (int k = 0; k < 3; k++) {
        chord[k] = sign * b->d[k] - a->d[k];
        off[k] = side * m->d[k] - a->d[k];
    }
    len2 = ix__dot3(chord, chord);
    t = len2 > 0.0 ? ix__dot3(off, chord) / len2 : 0.0;
    ix__axpy3(off, -t, chord, off);
    return !(ix__len3(off) <= w->turn);
}

/* Moves x onto the curve; with face 2 d + e >= 0, onto that edge. *found is
 * false if that fails. */
static ix_status refine(const walk *w, int face, double *x, bool *found)
{
    ix_equation eq[3] = {{.f = w->c.f[0]}, {.f = w->c.f[1]}, {.f = NULL}};
    ix_mv *f = NULL;
    ix_status st;

    *found = false;
    if (face >= 0) {
        const double plane[4] = {1.0, 0.0, 0.0, -w->in[face % 2]};

        IX_TRY(ix_contour_field(w->ctx, w->face[face / 2], plane, &f));
        eq[2].f = f;
    }
    st = ix_solve_refine(w->ctx, face < 0 ? 2 : 3, eq, x);
    ix_mv_unref(w->ctx, f);
    if (st == IX_EUNABLE || st == IX_EDOMAIN)
        return IX_OK;
    *found = st == IX_OK;
    return st;
}

/* Vertices after a up to b. */
static ix_status step(walk *w, const vertex *a, const vertex *b, int level)
{
    bool found = false;
    vertex m;

    if (w->turn > 0.0 && level < LEVELS) {
        for (int i = 0; i < 3; i++)
            m.x[i] = 0.5 * (a->x[i] + b->x[i]);
        IX_TRY(refine(w, -1, m.x, &found));
        if (found)
            IX_TRY(locate(w, &m, &found));
    }
    if (found && (level < 2 || bends(w, a, &m, b))) {
        IX_TRY(step(w, a, &m, level + 1));
        return step(w, &m, b, level + 1);
    }
    return ix__direction_add(&w->arcs, b->at);
}

/* Where the curve from a, inside, to b, outside, leaves the patch. */
static ix_status leave(walk *w, const vertex *a, const vertex *b, vertex *m,
                       bool *found)
{
    vertex end = *b;
    int face;

    *found = false;
    for (int cuts = 0; cuts < 3 && (face = outside(w, end.x)) >= 0; cuts++) {
        int d = face / 2;
        double t = (w->in[face % 2] - a->x[d]) / (end.x[d] - a->x[d]);

        for (int i = 0; i < 3; i++)
            end.x[i] = a->x[i] + t * (end.x[i] - a->x[i]);
        IX_TRY(refine(w, face, end.x, found));
        if (!*found)
            return IX_OK;
    }
    *m = end;
    *found = outside(w, m->x) < 0;
    return *found ? locate(w, m, found) : IX_OK;
}

/* --- curves of a patch
 * --------------------------------------------------------- */

static void load(const ix_solution_curve *k, int i, vertex *v)
{
    memcpy(v->x, k->x + 3 * (size_t)i, sizeof v->x);
}

/* From vertex a, if that is inside, to b. */
static ix_status segment(walk *w, const vertex *a, bool from, const vertex *b,
                         bool to)
{
    bool found;
    vertex m;

    if (from && to)
        return step(w, a, b, 0);
    if (from) {
        IX_TRY(leave(w, a, b, &m, &found));
        if (found)
            IX_TRY(step(w, a, &m, 0));
        ix__direction_end(&w->arcs, IX_END_OPEN);
        return IX_OK;
    }
    if (!to)
        return IX_OK;
    IX_TRY(leave(w, b, a, &m, &found));
    IX_TRY(ix__direction_begin(&w->arcs, IX_END_OPEN));
    IX_TRY(ix__direction_add(&w->arcs, found ? m.at : b->at));
    return found ? step(w, &m, b, 0) : IX_OK;
}

static ix_status add_curve(walk *w, const ix_solution_curve *k)
{
    bool in = false, all = true, next = true;
    vertex last = {{0}, {0}, {0}};
    int arc;

    for (int i = 0; i < k->n; i++) {
        all = all && outside(w, k->x + 3 * (size_t)i) < 0;
        next = next && is_of_next(w, k->x + 3 * (size_t)i);
    }
    if (next)
        return IX_OK;
    arc = w->arcs.narcs;
    for (int i = 0; i < k->n; i++) {
        vertex v;
        bool now;

        load(k, i, &v);
        IX_TRY(locate(w, &v, &now));
        now = now && outside(w, v.x) < 0;
        if (i == 0 && now) {
            IX_TRY(ix__direction_begin(&w->arcs, all ? k->start : IX_END_OPEN));
            IX_TRY(ix__direction_add(&w->arcs, v.at));
        }
        if (i > 0)
            IX_TRY(segment(w, &last, in, &v, now));
        in = now;
        last = v;
    }
    if (in)
        ix__direction_end(&w->arcs, all ? k->end : IX_END_OPEN);
    if (w->arcs.narcs != arc + 1) /* cut: no loop any more */
        for (; arc < w->arcs.narcs; arc++)
            for (int e = 0; e < 2; e++)
                if (w->arcs.arc[arc].end[e] == IX_END_CLOSED)
                    w->arcs.arc[arc].end[e] = IX_END_OPEN;
    return IX_OK;
}

static ix_status patch_curves(walk *w)
{
    const ix_equation eq[2] = {{.f = w->c.f[0]}, {.f = w->c.f[1]}};
    const ix_curves_opts o = {.tol = w->tol, .max_boxes = MAX_BOXES};
    ix_solution_curves raw;
    ix_status st = IX_OK;

    IX_TRY(ix_solve_curves(w->ctx, 2, eq, &o, &raw));
    w->boxes += raw.boxes;
    w->complete = w->complete && raw.complete;
    for (int i = 0; st == IX_OK && i < raw.ncurves; i++)
        st = add_curve(w, &raw.curve[i]);
    ix_solution_curves_free(w->ctx, &raw);
    return st;
}

/* --- points of a patch
 * --------------------------------------------------------- */

static ix_status add_point(walk *w, const ix_solution *s)
{
    ix_solution p = *s;
    vertex v;
    bool found;

    if (outside(w, s->x) >= 0)
        return IX_OK;
    memcpy(v.x, s->x, sizeof v.x);
    IX_TRY(locate(w, &v, &found));
    if (!found)
        return IX_OK;
    to_patch(w, s->x, p.x);
    to_patch(w, s->lo, p.lo);
    to_patch(w, s->hi, p.hi);
    p = ix__line_contact_solution(&w->c, &p);
    place(w, s->x, p.x);
    for (int i = 0; i < w->found.n; i++)
        if (ix__direction_same(&w->arcs, p.x, w->found.sol[i].x))
            return IX_OK;
    return ix__found_add(&w->found, &p);
}

static ix_status patch_points(walk *w)
{
    const ix_equation eq[3] = {
        {.f = w->c.f[0]}, {.f = w->c.f[1]}, {.f = w->c.f[2]}};
    const ix_solve_opts o = {.max_boxes = MAX_BOXES};
    ix_status st = IX_OK;
    ix_solutions raw;

    IX_TRY(ix_solve(w->ctx, 3, eq, &o, &raw));
    w->boxes += raw.boxes;
    w->complete = w->complete && raw.complete;
    for (int i = 0; st == IX_OK && i < raw.n; i++)
        st = add_point(w, &raw.sol[i]);
    ix_solutions_free(w->ctx, &raw);
    return st;
}

/* --- patches
 * ------------------------------------------------------------------- */

/* The equations over the enlarged patch. */
static ix_status enlarge(walk *w)
{
    for (int e = 0; e < 2; e++) {
        w->at[e] = e ? 1.0 + BEYOND : -BEYOND;
        w->in[e] = (e + BEYOND) / (1.0 + 2.0 * BEYOND);
    }
    for (int i = 0; i < w->c.n; i++)
        for (int d = 0; d < 3; d++) {
            ix_mv *next;

            IX_TRY(ix__mv_step(
                w->ctx, &w->c.f[i], &next,
                ix_mv_region(w->ctx, w->c.f[i], d, w->at[0], w->at[1], &next)));
        }
    return IX_OK;
}

static ix_status solve_patch(walk *w)
{
    static const double unit[2] = {0.0, 1.0};
    ix_pool q = {.ctx = w->ctx};
    ix_status st;

    for (int d = 0; d < 3; d++)
        w->face[d] = ix__pool_linear(&q, unit, 3, d);
    st = q.st;
    if (st == IX_OK)
        st = w->order > 3 ? patch_points(w) : patch_curves(w);
    ix__pool_free(&q);
    return st;
}

static ix_status one_chart(walk *w, const ix_mv *piece, int chart)
{
    ix_status st;

    IX_TRY(ix__line_contact_make(w->ctx, piece, w->order, chart, &w->c));
    memcpy(w->c.dom, w->own, sizeof w->own);
    st = enlarge(w);
    if (st == IX_OK && w->c.n > 0)
        st = solve_patch(w);
    ix__line_contact_free(w->ctx, &w->c);
    return st;
}

static ix_status one_patch(walk *w, const ix_mv *piece)
{
    ix_status st = IX_OK;

    w->patches++;
    for (int chart = 0; st == IX_OK && chart < 2; chart++)
        st = one_chart(w, piece, chart);
    if (st != IX_EDOMAIN)
        return st;
    w->ruled++; /* or plane, or a point */
    return IX_OK;
}

static ix_status all_patches(walk *w)
{
    ix_status st = IX_OK;
    ix_mv_pieces p;
    ix_mv *open;

    IX_TRY(ix_mv_to_open(w->ctx, w->s, &open));
    st = ix_mv_to_bezier(w->ctx, open, &p);
    ix_mv_unref(w->ctx, open);
    IX_TRY(st);
    for (size_t i = 0; st == IX_OK && i < p.count; i++) {
        for (int d = 0; d < 2; d++) {
            w->own[d][0] = p.lo[2 * i + (size_t)d];
            w->own[d][1] = p.hi[2 * i + (size_t)d];
            w->last[d] = !(w->own[d][1] < w->arcs.dom[d][1]);
        }
        st = one_patch(w, p.piece[i]);
    }
    ix_mv_pieces_free(w->ctx, &p);
    IX_TRY(st);
    if (w->ruled < w->patches)
        return IX_OK;
    return IX_FAIL(w->ctx, IX_EDOMAIN,
                   "the surface is a plane or ruled: every point has a tangent "
                   "of higher contact");
}

static ix_status begin(ix_ctx *ctx, const ix_mv *s, int order, walk *w)
{
    if (s->ndirs != 2 || s->ncoords != 3 || ix__mv_has_basis(s, IX_POWER))
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a Bezier or B-spline "
                       "surface of 3 coordinates is wanted",
                       s->ndirs, s->ncoords);
    *w = (walk){.ctx = ctx,
                .s = s,
                .order = order,
                .arcs = {.ctx = ctx},
                .found = {.ctx = ctx},
                .complete = true};
    for (int d = 0; d < 2; d++)
        ix_mv_domain(s, d, w->arcs.dom[d]);
    return IX_OK;
}

static ix_status curves(ix_ctx *ctx, const ix_mv *s, double tol, double turn,
                        ix_solution_curves *out)
{
    walk w;

    IX_TRY(begin(ctx, s, 3, &w));
    w.tol = tol;
    w.turn = turn;
    IX_TRY(all_patches(&w));
    out->complete = w.complete;
    out->boxes = w.boxes;
    return ix__direction_join(&w.arcs, out);
}

ix_status ix__contact_curves(ix_ctx *ctx, const ix_mv *s, double tol,
                             double turn, ix_solution_curves *out)
{
    *out = (ix_solution_curves){.unknowns = 4};
    IX_RETURN_SCOPED(ctx, curves(ctx, s, tol, turn, out));
}

static ix_status points(ix_ctx *ctx, const ix_mv *s, ix_solutions *out)
{
    walk w;

    IX_TRY(begin(ctx, s, 4, &w));
    IX_TRY(all_patches(&w));
    out->complete = w.complete;
    out->boxes = w.boxes;
    if (w.found.n == 0)
        return IX_OK;
    out->bytes = (size_t)w.found.n * sizeof *out->sol;
    out->sol = ix__alloc(ctx, out->bytes);
    if (!out->sol) {
        out->bytes = 0;
        return IX_ENOMEM;
    }
    memcpy(out->sol, w.found.sol, out->bytes);
    out->n = w.found.n;
    return IX_OK;
}

ix_status ix__contact_points(ix_ctx *ctx, const ix_mv *s, ix_solutions *out)
{
    *out = (ix_solutions){.unknowns = 4};
    IX_RETURN_SCOPED(ctx, points(ctx, s, out));
}
