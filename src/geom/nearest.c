/* nearest.c - the point of a curve or surface nearest to (or farthest from) a
 * point or a line.
 *
 * Spans and patches are left out if their bounds are worse than the distance of
 * some knot or of what has been found. In the others the candidates are the
 * feet of perpendiculars, the ends of the domain and, of a surface, the edges
 * at which its derivative may jump (for a curve such corners are roots). */
#include <math.h>
#include <string.h>

#include "geom/distance_bounds.h"
#include "geom/feet.h"
#include "iritx/distance.h"
#include "mv/mv.h"

#define MAX_BOXES                                               \
    200000 /* of all patches: a sphere seen from its centre has \
              feet everywhere */

typedef struct {
    double t[2], d;
    bool any;
} candidate;

typedef struct {
    ix_ctx *ctx;
    const ix_mv *m;
    double p[3];
    bool farthest;
    const ix_spans *sp; /* of a surface's directions */
    ix__distance_bounds b;
    candidate best;
    size_t boxes; /* left of MAX_BOXES */
} search;

static bool before(const search *s, const double *t, double d)
{
    const candidate *c = &s->best;

    if (!c->any || d < c->d || d > c->d)
        return !c->any || (s->farthest ? d > c->d : d < c->d);
    if (t[0] < c->t[0] || t[0] > c->t[0])
        return t[0] < c->t[0];
    return t[1] < c->t[1];
}

static ix_status offer(search *s, const double *t)
{
    candidate *c = &s->best;
    double x[3] = {0, 0, 0}, d = 0;

    IX_TRY(ix_mv_point(s->ctx, s->m, t, x));
    for (int k = 0; k < 3; k++)
        d += (x[k] - s->p[k]) * (x[k] - s->p[k]);
    d = sqrt(d);
    if (before(s, t, d)) {
        c->t[0] = t[0];
        c->t[1] = t[1];
        c->d = d;
        c->any = true;
    }
    return IX_OK;
}

/* --- curves
 * ------------------------------------------------------------------------ */

/* Spans i .. j - 1 of f as a form of their own. */
static ix_status part_of(ix_ctx *ctx, const ix_form *f, int i, int j,
                         ix_form *out)
{
    const ix_spans *old = &f->dirs[0];
    size_t m = (size_t)old->degree + 1;
    ix_spans *sp;

    IX_SCRATCH(ctx, sp, 1);
    *sp = (ix_spans){old->degree, j - i, old->breaks + i, old->cont + i};
    *out = *f;
    out->dirs = sp;
    out->n = (size_t)(j - i) * m;
    IX_SCRATCH(ctx, out->c, (size_t)f->nrows * out->n + 1);
    for (int r = 0; r < f->nrows; r++)
        memcpy(out->c + (size_t)r * out->n,
               f->c + (size_t)r * f->n + (size_t)i * m,
               out->n * sizeof *out->c);
    return IX_OK;
}

/* The feet in spans i .. j - 1. */
static ix_status visit_spans(search *s, const ix_form *x, const ix_form *w,
                             int i, int j)
{
    ix_form px, pw;
    ix_root *r;
    int n;

    IX_TRY(part_of(s->ctx, x, i, j, &px));
    IX_TRY(part_of(s->ctx, w, i, j, &pw));
    IX_TRY(ix__foot_roots(s->ctx, &px, &pw, &r, &n));
    for (int k = 0; k < n; k++)
        IX_TRY(offer(s, (double[2]){r[k].t, 0}));
    return IX_OK;
}

static bool span_matters(const search *s, int i)
{
    const ix__distance_bounds *b = &s->b;

    return s->farthest ? !(b->d[i] + b->slack < b->best)
                       : !(b->d[i] - b->slack > b->best);
}

/* Runs of spans, so that a foot at a joint of two that matter is in one field
 * and not at its end. */
static ix_status look_at_curve(search *s)
{
    ix_form x, w;
    double dom[2];

    IX_TRY(ix__foot_forms(s->ctx, s->m, s->p, &x, &w));
    IX_TRY(ix__distance_bounds_of(s->ctx, &x, w.nrows ? &w : NULL, s->farthest,
                                  &s->b));
    for (int i = 0, j; i < s->b.n; i = j + 1) {
        for (j = i; j < s->b.n && span_matters(s, j);)
            j++;
        if (j > i)
            IX_TRY(visit_spans(s, &x, &w, i, j));
    }
    ix_mv_domain(s->m, 0, dom);
    for (int e = 0; e < 2; e++)
        IX_TRY(offer(s, (double[2]){dom[e], 0}));
    return IX_OK;
}

/* --- surfaces (s->p is the origin)
 * ------------------------------------------------------------------------ */

/* Span i of direction dir of m: new reference. */
static ix_status cut(search *s, const ix_mv *m, int dir, int i, ix_mv **out)
{
    const ix_spans *sp = &s->sp[dir];

    if (sp->nspans == 1) {
        *out = ix_mv_ref(m);
        return IX_OK;
    }
    return ix_mv_region(s->ctx, m, dir, sp->breaks[i], sp->breaks[i + 1], out);
}

/* Whether break i of direction dir is an end of the domain or one where the
 * derivative may jump. */
static bool is_edge(const search *s, int dir, int i)
{
    const ix_spans *sp = &s->sp[dir];

    return i == 0 || i == sp->nspans || sp->cont[i - 1] < 1;
}

static ix_status offer_feet(search *s, const ix_mv *patch)
{
    ix_status st = IX_OK;
    ix_solutions sol;

    if (s->boxes == 0)
        return IX_OK;
    IX_TRY(ix__feet_of_origin(s->ctx, patch, s->boxes, &sol));
    s->boxes -= sol.boxes < s->boxes ? sol.boxes : s->boxes;
    for (int i = 0; st == IX_OK && i < sol.n; i++)
        st = offer(s, sol.sol[i].x);
    ix_solutions_free(s->ctx, &sol);
    return st;
}

/* The nearest point of the patch's edge at t in direction dir. */
static ix_status offer_edge(search *s, const ix_mv *patch, int dir, double t)
{
    double uv[2], d;
    ix_status st;
    ix_mv *c;

    uv[dir] = t;
    IX_TRY(ix_mv_fix(s->ctx, patch, dir, t, &c));
    st = ix_crv_nearest(s->ctx, c, s->p, NULL, s->farthest, &uv[1 - dir], &d);
    ix_mv_unref(s->ctx, c);
    IX_TRY(st);
    return offer(s, uv);
}

static ix_status offer_patch(search *s, const ix_mv *patch, const int *at)
{
    IX_TRY(offer_feet(s, patch));
    for (int dir = 0; dir < 2; dir++)
        for (int e = at[dir]; e <= at[dir] + 1; e++)
            if (is_edge(s, dir, e))
                IX_TRY(offer_edge(s, patch, dir, s->sp[dir].breaks[e]));
    return IX_OK;
}

static ix_status visit_patch(search *s, int i)
{
    const int at[2] = {i % s->sp[0].nspans, i / s->sp[0].nspans};
    ix_mv *strip, *patch;
    ix_status st;

    IX_TRY(cut(s, s->m, 1, at[1], &strip));
    st = cut(s, strip, 0, at[0], &patch);
    ix_mv_unref(s->ctx, strip);
    IX_TRY(st);
    st = offer_patch(s, patch, at);
    ix_mv_unref(s->ctx, patch);
    return st;
}

/* Whether patch i may hold what is looked for. */
static bool patch_matters(const search *s, int i)
{
    double d = s->b.best;

    if (s->best.any) /* the square of a measured distance: 4 roundings */
        d = s->farthest ? fmax(d, s->best.d * s->best.d)
                        : fmin(d, s->best.d * s->best.d);
    return s->farthest ? !(s->b.d[i] + s->b.slack < d)
                       : !(s->b.d[i] - s->b.slack > d);
}

/* The best corner of the grid, for the case that the foot on a joint of
 * patches was lost by rounding: only if it is better by more than that. */
static ix_status offer_corner(search *s)
{
    const ix__distance_bounds *b = &s->b;
    double uv[2];

    if (b->part < 0 ||
        (s->best.any &&
         (s->farthest ? !(b->best - b->slack > s->best.d * s->best.d)
                      : !(b->best + b->slack < s->best.d * s->best.d))))
        return IX_OK;
    for (int j = 0; j < 2; j++) {
        int i = j ? b->part / s->sp[0].nspans : b->part % s->sp[0].nspans;

        uv[j] = s->sp[j].breaks[i + (b->high >> j & 1)];
    }
    return offer(s, uv);
}

static ix_status look_at_surface(search *s)
{
    int first = 0;
    ix_form f, x, w;

    IX_TRY(ix__forms_load(s->ctx, 1, &s->m, NULL, &f));
    w = ix__form_rows(&f, 0, s->m->rational);
    x = ix__form_rows(&f, s->m->rational, f.nrows - s->m->rational);
    s->sp = f.dirs;
    IX_TRY(ix__distance_bounds_of(s->ctx, &x, w.nrows ? &w : NULL, s->farthest,
                                  &s->b));
    for (int i = 1; i < s->b.n; i++)
        if (s->farthest ? s->b.d[i] > s->b.d[first] : s->b.d[i] < s->b.d[first])
            first = i;
    IX_TRY(visit_patch(s, first));
    for (int i = 0; i < s->b.n; i++) {
        if (i == first || !patch_matters(s, i))
            continue;
        IX_TRY(visit_patch(s, i));
        IX_TRY(ix__poll(s->ctx));
    }
    return offer_corner(s);
}

/* From p (dir NULL) or the line through p along dir; m is not in power basis.
 */
static ix_status run(ix_ctx *ctx, const ix_mv *m, const double *p,
                     const double *dir, bool farthest, double *t, double *d)
{
    search s = {.ctx = ctx, .farthest = farthest, .boxes = MAX_BOXES};
    ix_mv *rel = NULL;
    ix_status st;
    ix_mark mk;

    if (dir || m->ndirs == 2)
        IX_TRY(ix__relative_to(ctx, m, p, dir, &rel));
    s.m = rel ? rel : m;
    for (int k = 0; k < 3 && !rel; k++)
        s.p[k] = p[k];
    mk = ix__scratch_mark(ctx);
    st = m->ndirs == 1 ? look_at_curve(&s) : look_at_surface(&s);
    ix__scratch_release(ctx, mk);
    ix_mv_unref(ctx, rel);
    IX_TRY(st);
    for (int k = 0; k < m->ndirs; k++)
        t[k] = s.best.t[k];
    *d = s.best.d;
    return IX_OK;
}

ix_status ix_crv_nearest(ix_ctx *ctx, const ix_mv *c, const double p[3],
                         const double *dir, bool farthest, double *t,
                         double *distance)
{
    IX_TRY(ix__check_curve(ctx, c, 1));
    return run(ctx, c, p, dir, farthest, t, distance);
}

ix_status ix_srf_nearest(ix_ctx *ctx, const ix_mv *s, const double p[3],
                         bool farthest, double uv[2], double *distance)
{
    IX_TRY(ix__check_surface(ctx, s));
    return run(ctx, s, p, NULL, farthest, uv, distance);
}

ix_status ix_srf_line_nearest(ix_ctx *ctx, const ix_mv *s, const double p[3],
                              const double dir[3], bool farthest, double uv[2],
                              double *distance)
{
    IX_TRY(ix__check_surface(ctx, s));
    return run(ctx, s, p, dir, farthest, uv, distance);
}
