/* srf_kernel.c - from where the whole of a closed surface is seen.
 *
 * The kernel is what is behind all tangent planes, so it is convex. Here it is
 * cut out of the surface's box by the tangent planes at samples: a polyhedron
 * that holds the kernel, as near to it as the samples are dense. Invariant:
 * faces are convex polygons, counter-clockwise from outside; every vertex
 * belongs to three faces or more. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"
#include "bsp/spans.h"
#include "geom/lines.h"
#include "geom/normals.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"
#include "iritx/kernel.h"
#include "mv/mv.h"

typedef struct {
    int n, room;
    int *count; /* vertices of each face */
    int np, proom;
    double (*p)[3];
} solid;

typedef struct {
    ix_ctx *ctx;
    double size, tie; /* points nearer to a plane than tie are on it */
    int nu, nv;
    double (*at)[3], (*normal)[3]; /* [nu nv]; a normal of 0: there is none */
    solid now, next;               /* after the last cut, and room for one */
    double (*cap)[3];
    int ncap, caproom;
} kernel;

/* --- polyhedra -------------------------------------------------------------
 */

static ix_status add_point(ix_ctx *ctx, int *n, int *room, double (**p)[3],
                           const double x[3])
{
    IX_GROW(ctx, *p, *n, *room);
    memcpy((*p)[(*n)++], x, sizeof **p);
    return IX_OK;
}

static ix_status add_vertex(ix_ctx *ctx, solid *s, const double x[3])
{
    s->count[s->n]++;
    return add_point(ctx, &s->np, &s->proom, &s->p, x);
}

static ix_status begin_face(ix_ctx *ctx, solid *s)
{
    IX_GROW(ctx, s->count, s->n, s->room);
    s->count[s->n] = 0;
    return IX_OK;
}

/* A face of less than three vertices is none. */
static void end_face(solid *s)
{
    if (s->count[s->n] >= 3)
        s->n++;
    else
        s->np -= s->count[s->n];
}

static ix_status box(ix_ctx *ctx, const double lo[3], const double hi[3],
                     solid *s)
{
    for (int k = 0; k < 3; k++)
        for (int side = 0; side < 2; side++) {
            IX_TRY(begin_face(ctx, s));
            for (int i = 0; i < 4; i++) {
                int turn = side ? i : 3 - i;
                double x[3];

                x[k] = side ? hi[k] : lo[k];
                x[(k + 1) % 3] = turn == 1 || turn == 2 ? hi[(k + 1) % 3]
                                                        : lo[(k + 1) % 3];
                x[(k + 2) % 3] = turn >= 2 ? hi[(k + 2) % 3] : lo[(k + 2) % 3];
                IX_TRY(add_vertex(ctx, s, x));
            }
            end_face(s);
        }
    return IX_OK;
}

/* --- one cut ---------------------------------------------------------------
 */

static double above(const kernel *w, const double a[3], const double n[3],
                    const double p[3])
{
    double d = (p[0] - a[0]) * n[0] + (p[1] - a[1]) * n[1] +
               (p[2] - a[2]) * n[2];

    return fabs(d) <= w->tie ? 0 : d;
}

/* The part of a convex polygon that is not above the plane; its points on the
 * plane are gathered for the new face. */
static ix_status cut_face(kernel *w, const double a[3], const double n[3],
                          int count, const double (*p)[3])
{
    IX_TRY(begin_face(w->ctx, &w->next));
    for (int i = 0; i < count; i++) {
        const double *q = p[i], *r = p[(i + 1) % count];
        double d = above(w, a, n, q), e = above(w, a, n, r), x[3];

        if (d <= 0)
            IX_TRY(add_vertex(w->ctx, &w->next, q));
        if (d == 0)
            IX_TRY(add_point(w->ctx, &w->ncap, &w->caproom, &w->cap, q));
        if (!(d * e < 0))
            continue;
        for (int k = 0; k < 3; k++)
            x[k] = q[k] + d / (d - e) * (r[k] - q[k]);
        IX_TRY(add_vertex(w->ctx, &w->next, x));
        IX_TRY(add_point(w->ctx, &w->ncap, &w->caproom, &w->cap, x));
    }
    end_face(&w->next);
    return IX_OK;
}

typedef struct {
    double angle;
    int i;
} around;

static int by_angle(const void *a, const void *b)
{
    const around *p = a, *q = b;

    return p->angle < q->angle   ? -1
           : p->angle > q->angle ? 1
                                 : (p->i > q->i) - (p->i < q->i);
}

/* The gathered points, sorted around their middle, as the face in the plane. */
static ix_status add_cap(kernel *w, const double n[3])
{
    double mid[3] = {0}, u[3], v[3];
    const double *last = NULL, *first = NULL;
    around *o;

    IX_SCRATCH(w->ctx, o, w->ncap);
    for (int i = 0; i < w->ncap; i++)
        ix__axpy3(mid, 1.0 / w->ncap, w->cap[i], mid);
    ix__perp3(n, u);
    ix__cross3(n, u, v);
    for (int i = 0; i < w->ncap; i++) {
        double d[3];

        ix__sub3(w->cap[i], mid, d);
        o[i] = (around){atan2(ix__dot3(d, v), ix__dot3(d, u)), i};
    }
    qsort(o, (size_t)w->ncap, sizeof *o, by_angle);
    IX_TRY(begin_face(w->ctx, &w->next));
    for (int i = 0; i < w->ncap; i++) {
        const double *x = w->cap[o[i].i];

        if ((last && ix__dist3(last, x) <= 4 * w->tie) ||
            (first && ix__dist3(first, x) <= 4 * w->tie))
            continue;
        IX_TRY(add_vertex(w->ctx, &w->next, x));
        first = first ? first : x;
        last = x;
    }
    end_face(&w->next);
    return IX_OK;
}

/* Nothing changes unless a vertex is above the plane. */
static ix_status cut(kernel *w, const double a[3], const double n[3])
{
    const double(*p)[3] = (const double(*)[3])w->now.p;
    bool any = false;
    ix_status st;
    solid old;

    for (int i = 0; !any && i < w->now.np; i++)
        any = above(w, a, n, p[i]) > 0;
    if (!any)
        return IX_OK;
    w->next.n = w->next.np = w->ncap = 0;
    for (int f = 0; f < w->now.n; p += w->now.count[f], f++)
        IX_TRY(cut_face(w, a, n, w->now.count[f], p));
    st = w->next.n && w->ncap ? add_cap(w, n) : IX_OK;
    old = w->now;
    w->now = w->next;
    w->next = old;
    return st;
}

/* --- samples ---------------------------------------------------------------
 */

/* Parameters of one direction: steps equal ones in each span, shifted by a part
 * of a step (then one less in all). */
static ix_status params(ix_ctx *ctx, const ix_mv *s, int dir, int steps,
                        double shift, int *n, double **t)
{
    ix_spans sp;

    IX_TRY(ix__spans_of(ctx, &s->dirs[dir], &sp));
    IX_SCRATCH(ctx, *t, (size_t)sp.nspans * (size_t)steps + 1);
    *n = 0;
    for (int j = 0; j < sp.nspans; j++)
        for (int i = 0; i < steps; i++)
            (*t)[(*n)++] = sp.breaks[j] + (sp.breaks[j + 1] - sp.breaks[j]) *
                                              (i + shift) / steps;
    if (!(shift > 0))
        (*t)[(*n)++] = sp.breaks[sp.nspans];
    return IX_OK;
}

/* Projected values of three coordinates, p[nu nv]. */
static ix_status grid(ix_ctx *ctx, const ix_mv *m, const int n[2],
                      double *const t[2], double (**p)[3])
{
    size_t all = (size_t)n[0] * (size_t)n[1];
    double *v;

    IX_SCRATCH(ctx, v, all * (size_t)m->naxes);
    IX_SCRATCH(ctx, *p, all);
    IX_TRY(ix_mv_eval_grid(ctx, m, n, (const double *const *)t, v));
    for (size_t i = 0; i < all; i++)
        for (int k = 0; k < 3; k++)
            (*p)[i][k] = v[((size_t)k + m->rational) * all + i] /
                         (m->rational ? v[i] : 1);
    return IX_OK;
}

/* Points, unit normals (0 where there is none), and the sum of the volumes of
 * cones from the first point over the samples: its sign tells whether the
 * normal leads out of a closed surface. */
static ix_status sample(kernel *w, const ix_mv *s, const ix_mv *field,
                        int steps, double shift, double *volume)
{
    double *t[2], top = 0;
    int n[2];

    for (int d = 0; d < 2; d++)
        IX_TRY(params(w->ctx, s, d, steps, shift, &n[d], &t[d]));
    w->nu = n[0];
    w->nv = n[1];
    IX_TRY(grid(w->ctx, s, n, t, &w->at));
    IX_TRY(grid(w->ctx, field, n, t, &w->normal));
    *volume = 0;
    for (int i = 0; i < n[0] * n[1]; i++)
        top = fmax(top, ix__len3(w->normal[i]));
    for (int i = 0; i < n[0] * n[1]; i++) {
        int u = i % n[0], v = i / n[0];
        double du = t[0][u + 1 < n[0] ? u + 1 : u] - t[0][u ? u - 1 : 0];
        double dv = t[1][v + 1 < n[1] ? v + 1 : v] - t[1][v ? v - 1 : 0];
        double d[3];

        ix__sub3(w->at[i], w->at[0], d);
        *volume += du * dv * ix__dot3(d, w->normal[i]);
        if (!(ix__unit3(w->normal[i], w->normal[i]) > 1e-9 * top))
            memset(w->normal[i], 0, sizeof w->normal[i]);
    }
    return IX_OK;
}

static void turn(kernel *w, double volume)
{
    for (int i = 0; volume < 0 && i < w->nu * w->nv; i++)
        for (int k = 0; k < 3; k++)
            w->normal[i][k] = -w->normal[i][k];
}

/* --- the whole -------------------------------------------------------------
 */

static ix_status cut_all(kernel *w, int skip)
{
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < w->nu * w->nv; i++) {
            bool coarse = i % w->nu % skip == 0 && i / w->nu % skip == 0;

            IX_TRY(ix__poll(w->ctx));
            if (coarse == (pass == 0) &&
                ix__dot3(w->normal[i], w->normal[i]) > 0)
                IX_TRY(cut(w, w->at[i], w->normal[i]));
        }
    return IX_OK;
}

/* How far vertices are in front of tangent planes at samples. */
static double excess(const kernel *w)
{
    double worst = 0;

    for (int i = 0; i < w->nu * w->nv; i++)
        for (int k = 0; k < w->now.np; k++) {
            double d[3];

            ix__sub3(w->now.p[k], w->at[i], d);
            worst = fmax(worst, ix__dot3(d, w->normal[i]));
        }
    return worst;
}

static ix_status find(kernel *w, const ix_mv *s, const ix_mv *field,
                      int samples, int skip, double *error, ix_lines *out)
{
    double lo[IX_MAX_COORDS], hi[IX_MAX_COORDS], volume, between;

    IX_TRY(ix_mv_bbox(w->ctx, s, lo, hi));
    w->size = fmax(hi[0] - lo[0], fmax(hi[1] - lo[1], hi[2] - lo[2]));
    w->tie = 1e-11 * w->size;
    IX_TRY(box(w->ctx, lo, hi, &w->now));
    IX_TRY(sample(w, s, field, samples, 0, &volume));
    turn(w, volume);
    IX_TRY(cut_all(w, skip));
    IX_TRY(sample(w, s, field, samples, 0.5, &between));
    turn(w, volume);
    *error = excess(w);
    IX_TRY(ix__lines_new(w->ctx, (size_t)w->now.np, out));
    out->n = w->now.n;
    if (w->now.n) {
        memcpy(out->count, w->now.count, (size_t)w->now.n * sizeof *out->count);
        memcpy(out->pt, w->now.p, (size_t)w->now.np * sizeof *out->pt);
    }
    return IX_OK;
}

ix_status ix_srf_kernel(ix_ctx *ctx, const ix_mv *srf, int samples, int skip,
                        double *error, ix_lines *out)
{
    kernel w = {.ctx = ctx};
    ix_mv *field;
    ix_mark mk;
    ix_status st;

    *out = (ix_lines){0};
    *error = 0;
    IX_TRY(ix__check_space_surface(ctx, srf));
    if (samples < 1 || samples > 1000 || skip < 1)
        return IX_FAIL(ctx, IX_EARG,
                       "%d samples, every one of %d first; 1 to 1000 and a "
                       "positive number are wanted",
                       samples, skip);
    IX_TRY(ix_srf_normal_field(ctx, srf, &field));
    mk = ix__scratch_mark(ctx);
    st = find(&w, srf, field, samples, skip, error, out);
    ix__scratch_release(ctx, mk);
    ix_mv_unref(ctx, field);
    return st;
}
