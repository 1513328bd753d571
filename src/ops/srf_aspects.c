/* srf_aspects.c - views along which the outline of a surface changes, as curves
 * on the sphere of directions.
 *
 * The curves on the surface come from the solver with vertices as dense as
 * their own shape needs; the direction may turn faster, so that steps are
 * halved until it is on the sphere as near to the chord as asked for, every new
 * vertex being moved onto the curve. */
#include <math.h>
#include <string.h>

#include "base/grow.h"
#include "geom/lines.h"
#include "geom/vec3.h"
#include "iritx/ops_srf.h"
#include "ops/contact_patches.h"
#include "ops/surface.h"

/* A vertex: parameters (u, v) and the direction there. */
typedef struct {
    double x[2], d[3];
} vertex;

typedef struct {
    ix_ctx *ctx;
    const ix_mv *s;
    ix_equation eq; /* of the parabolic curves */
    double tol;
    vertex *v;
    int n, cap;
    int *count; /* of each polyline; n lines */
    int nlines, line_cap;
} walk;

/* --- directions
 * ---------------------------------------------------------------- */

/* (a, b) with b_11 a + b_12 b = b_12 a + b_22 b = 0. */
static void null_direction(const ix_srf_jet *j, double ab[2])
{
    bool first = fabs(j->b[0]) > fabs(j->b[2]);

    ab[0] = first ? -j->b[1] : j->b[2];
    ab[1] = first ? j->b[0] : -j->b[1];
}

/* The unit direction at (u, v) along ab, or (NULL) of the parabolic point;
 * *found is false where there is none: no normal, a flat point. */
static ix_status direction(const walk *w, const double *uv, const double *ab,
                           double d[3], bool *found)
{
    double null[2] = {0.0, 0.0};
    ix_srf_jet j;
    ix_status st = ix__srf_jet(w->ctx, w->s, uv[0], uv[1], &j);

    *found = false;
    if (st == IX_EDOMAIN)
        return IX_OK;
    IX_TRY(st);
    if (!ab)
        null_direction(&j, null);
    for (int k = 0; k < 3; k++)
        d[k] = (ab ? ab : null)[0] * j.su[k] + (ab ? ab : null)[1] * j.sv[k];
    *found = ix__unit3(d, d) > 0.0;
    return IX_OK;
}

/* --- growing
 * ------------------------------------------------------------------- */

static ix_status add_vertex(walk *w, const vertex *v)
{
    IX_GROW(w->ctx, w->v, w->n, w->cap);
    w->v[w->n++] = *v;
    w->count[w->nlines - 1]++;
    return IX_OK;
}

static ix_status begin_line(walk *w)
{
    if (w->nlines > 0 && w->count[w->nlines - 1] == 0)
        return IX_OK;
    IX_GROW(w->ctx, w->count, w->nlines, w->line_cap);
    w->count[w->nlines++] = 0;
    return IX_OK;
}

/* --- steps
 * --------------------------------------------------------------------- */

#define MAX_LEVEL 12

/* Does the chord a b leave the point m between them too far away? */
static bool bends(const walk *w, const vertex *a, const vertex *m,
                  const vertex *b)
{
    double chord[3], off[3], t, len2;

    ix__sub3(b->d, a->d, chord);
    ix__sub3(m->d, a->d, off);
    len2 = ix__dot3(chord, chord);
    t = len2 > 0.0 ? ix__dot3(off, chord) / len2 : 0.0;
    ix__axpy3(off, -t, chord, off);
    return !(ix__len3(off) <= w->tol);
}

/* The vertex between a and b, with the sense of a; *found is false if the curve
 * could not be reached there. */
static ix_status between(const walk *w, const vertex *a, const vertex *b,
                         vertex *m, bool *found)
{
    ix_status st;

    for (int i = 0; i < 2; i++)
        m->x[i] = 0.5 * (a->x[i] + b->x[i]);
    *found = false;
    st = ix_solve_refine(w->ctx, 1, &w->eq, m->x);
    if (st == IX_EUNABLE)
        return IX_OK;
    IX_TRY(st);
    IX_TRY(direction(w, m->x, NULL, m->d, found));
    if (*found && ix__dot3(a->d, m->d) < 0.0)
        for (int k = 0; k < 3; k++)
            m->d[k] = -m->d[k];
    return IX_OK;
}

/* Vertices after a up to b, whose sense becomes that of a. */
static ix_status step(walk *w, const vertex *a, vertex *b, int level)
{
    bool found;
    vertex m;

    IX_TRY(between(w, a, b, &m, &found));
    if (found && ix__dot3(m.d, b->d) < 0.0)
        for (int k = 0; k < 3; k++)
            b->d[k] = -b->d[k];
    if (found && level < MAX_LEVEL && (level < 2 || bends(w, a, &m, b))) {
        IX_TRY(step(w, a, &m, level + 1));
        return step(w, &m, b, level + 1);
    }
    return add_vertex(w, b);
}

/* A curve of (u, v), which is refined, or of (u, v, a, b). */
static ix_status one_curve(walk *w, const ix_solution_curve *k, int unknowns)
{
    vertex last = {{0}, {0}};
    bool have = false;

    for (int i = 0; i < k->n; i++) {
        const double *x = k->x + (size_t)i * (size_t)unknowns;
        vertex v = {{x[0], x[1]}, {0}};
        bool found;

        IX_TRY(direction(w, x, unknowns == 4 ? x + 2 : NULL, v.d, &found));
        if (found && have && ix__dot3(last.d, v.d) < 0.0)
            for (int c = 0; c < 3; c++)
                v.d[c] = -v.d[c];
        if (found && have && unknowns == 2)
            IX_TRY(step(w, &last, &v, 0));
        else if (found && !have)
            IX_TRY(begin_line(w));
        if (found && !(have && unknowns == 2))
            IX_TRY(add_vertex(w, &v));
        have = found;
        last = v;
    }
    return IX_OK;
}

/* Every line and its antipode. */
static ix_status give(const walk *w, ix_lines *out)
{
    size_t at = 0, to = 0;

    IX_TRY(ix__lines_new(w->ctx, 2 * (size_t)w->n, out));
    for (int i = 0; i < w->nlines; i++) {
        for (int sign = 1; sign >= -1; sign -= 2) {
            for (int v = 0; v < w->count[i]; v++, to++)
                for (int c = 0; c < 3; c++)
                    out->pt[to][c] = sign * w->v[at + (size_t)v].d[c];
            out->count[out->n++] = w->count[i];
        }
        at += (size_t)w->count[i];
    }
    return IX_OK;
}

/* --- events
 * -------------------------------------------------------------------- */

static ix_status all_curves(walk *w, const ix_solution_curves *s,
                            ix_aspects *out, ix_lines *lines)
{
    out->complete = out->complete && s->complete;
    for (int i = 0; i < s->ncurves; i++)
        IX_TRY(one_curve(w, &s->curve[i], s->unknowns));
    return give(w, lines);
}

static ix_status on_parabolic(walk *w, ix_aspects *out)
{
    const ix_curves_opts o = {.tol = w->tol};
    ix_solution_curves s;
    ix_status st;

    if (ix__bern_largest(w->eq.f->npts, w->eq.f->pts) == 0.0)
        return IX_FAIL(w->ctx, IX_EDOMAIN,
                       "the Gauss curvature is zero everywhere: no view "
                       "changes the outline of a developable surface");
    IX_TRY(ix_solve_curves(w->ctx, 1, &w->eq, &o, &s));
    st = all_curves(w, &s, out, &out->parabolic);
    ix_solution_curves_free(w->ctx, &s);
    return st;
}

static ix_status parabolic(ix_ctx *ctx, const ix_mv *s, double tol,
                           ix_aspects *out)
{
    walk w = {.ctx = ctx, .s = s, .tol = tol};
    ix_status st;
    ix_mv *k;

    IX_TRY(ix_srf_gauss(ctx, s, true, NULL, NULL, &k));
    w.eq = (ix_equation){.f = k, .rel = IX_EQUAL_ZERO};
    st = on_parabolic(&w, out);
    ix_mv_unref(ctx, k);
    return st;
}

static ix_status swallowtails(ix_ctx *ctx, const ix_mv *s, double tol,
                              ix_aspects *out)
{
    walk w = {.ctx = ctx, .s = s, .tol = tol};
    ix_solution_curves c;
    ix_status st;

    IX_TRY(ix__contact_curves(ctx, s, tol, tol, &c));
    st = all_curves(&w, &c, out, &out->swallowtail);
    ix_solution_curves_free(ctx, &c);
    return st;
}

static ix_status aspects(ix_ctx *ctx, const ix_mv *s, double tol,
                         ix_aspects *out)
{
    IX_TRY(parabolic(ctx, s, tol, out));
    return swallowtails(ctx, s, tol, out);
}

ix_status ix_srf_aspects(ix_ctx *ctx, const ix_mv *s, double tol,
                         ix_aspects *out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    *out = (ix_aspects){.complete = true};
    st = aspects(ctx, s, tol > 0.0 ? tol : 1e-4, out);
    ix__scratch_release(ctx, mk);
    if (st != IX_OK)
        ix_aspects_free(ctx, out);
    return st;
}

void ix_aspects_free(ix_ctx *ctx, ix_aspects *a)
{
    ix_lines_free(ctx, &a->parabolic);
    ix_lines_free(ctx, &a->swallowtail);
}
