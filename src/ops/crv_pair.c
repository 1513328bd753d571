/* crv_pair.c - pairs of space curves without a bisector surface, and those that
 * meet (Elber and Kim 1998, section 2.3).
 *
 * The weight of the surface is the determinant of both tangents and the line
 * between the feet. It vanishes identically where a curve stands still and,
 * over a span of each, exactly if both spans lie in one plane. */
#include "ops/crv_pair.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "geom/vec3.h"
#include "iritx/distance.h"
#include "ops/lift.h"

/* Relative rounding of a sum of products in the degrees at hand, and what the
 * rounding of the input makes of its three factors in each curve. */
void ix__crv_pair_band(ix_crv_pair *p)
{
    int d = p->minors[0].dirs[0].degree + p->minors[1].dirs[0].degree;

    p->band = 8.0 * DBL_EPSILON * (d + 2) + 8.0 * p->frame.noise;
}

/* A curve is a point if its tangent (minors x1 y1 z1) vanishes. */
static ix_status check_point(ix_ctx *ctx, const ix_crv_pair *p, int i)
{
    int sign, first = ix__lift_minor(0, 3, &sign);
    ix_form tangent = ix__form_rows(&p->minors[i], first, 3);
    double big;

    IX_TRY(ix__form_bound(ctx, &tangent, &big));
    if (!(big > p->band))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "curve %d is a point: its tangent is at most %.3g of "
                       "the size of both curves, error band %.3g",
                       i + 1, big, p->band);
    return IX_OK;
}

/* Distance of c2 from c1 at one parameter u in [0, 1] of both domains;
 * negative at a pole. */
static ix_status gap_at(ix_ctx *ctx, const ix_mv *const *c, double u,
                        bool reversed, double *gap)
{
    double dom[2], x[2][3];

    *gap = -1.0;
    for (int i = 0; i < 2; i++) {
        double v = i && reversed ? 1.0 - u : u, t;
        ix_status st;

        ix_mv_domain(c[i], 0, dom);
        t = dom[0] + v * (dom[1] - dom[0]);
        st = ix_mv_point(ctx, c[i], &t, x[i]);
        if (st == IX_EDOMAIN)
            return IX_OK;
        IX_TRY(st);
    }
    *gap = 0.0;
    for (int k = 0; k < 3; k++)
        *gap = fmax(*gap, fabs(x[0][k] - x[1][k]));
    return IX_OK;
}

/* Curves that agree at as many parameters as their difference has degrees on
 * all spans together are the same. */
static ix_status check_same(ix_ctx *ctx, const ix_mv *const *c,
                            const ix_crv_pair *p, bool reversed)
{
    int n = 0, seen = 0;
    double tol = ldexp(p->band, p->frame.exp), gap, big = 0.0;

    for (int i = 0; i < 2; i++)
        n += p->f[i].dirs[0].nspans;
    n *= p->f[0].dirs[0].degree + p->f[1].dirs[0].degree + 1;
    for (int i = 0; i <= n; i++) {
        IX_TRY(gap_at(ctx, c, (double)i / n, reversed, &gap));
        if (gap > tol)
            return IX_OK;
        seen += gap >= 0.0;
        big = fmax(big, gap);
    }
    if (2 * seen < n)
        return IX_OK;
    return IX_FAIL(ctx, IX_EDOMAIN,
                   "both curves are the same%s: they differ by at most %.3g, "
                   "error band %.3g",
                   reversed ? ", one reversed" : "", big, tol);
}

/* The projected control points of both curves one after the other; k is
 * advanced, false at the end. Those of weight 0 are directions: left out. */
static bool next_point(const ix_mv *const *c, size_t *k, double out[3])
{
    for (; *k < c[0]->npts + c[1]->npts; ++*k) {
        const ix_mv *m = *k < c[0]->npts ? c[0] : c[1];
        size_t i = *k < c[0]->npts ? *k : *k - c[0]->npts;
        double w = m->rational ? ix_mv_weights(m)[i] : 1.0;

        for (int j = 0; j < 3; j++)
            out[j] = ix_mv_coord(m, j)[i] / w;
        if (w != 0.0) {
            ++*k;
            return true;
        }
    }
    return false;
}

/* The line through two of the control points, the first and the one farthest
 * from it: its direction u, their distance; and the farthest distance from it:
 * the line holds both curves if that is within rounding. */
static double off_line(const ix_mv *const *c, double u[3], double *length)
{
    double p0[3] = {0, 0, 0}, p[3], v[3], worst = 0.0;
    size_t k = 0, first;

    u[0] = u[1] = u[2] = 0.0;
    (void)next_point(c, &k, p0);
    first = k;
    while (next_point(c, &k, p)) {
        ix__sub3(p, p0, v);
        if (ix__len3(v) > ix__len3(u))
            ix__sub3(p, p0, u);
    }
    *length = ix__unit3(u, u);
    for (k = first; next_point(c, &k, p);) {
        double x[3];

        ix__sub3(p, p0, v);
        ix__cross3(u, v, x);
        worst = fmax(worst, ix__len3(x));
    }
    return worst;
}

/* Both reflections that carry u to the axis e next to it: I - (u + e) (u + e)^T
 * / (1 + u.e) + 2 e u^T. */
void ix__crv_pair_turn(ix_crv_pair *p)
{
    double u[3], length, off = off_line(p->crv, u, &length), s;
    int k = 0;

    p->turned = off < 0.0625 * length;
    p->thin = p->turned ? off / length + p->frame.noise : 1.0;
    if (!p->turned)
        return;
    for (int i = 1; i < 3; i++)
        k = fabs(u[i]) > fabs(u[k]) ? i : k;
    s = u[k] < 0.0 ? -1.0 : 1.0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            double a = s * u[i], b = s * u[j];

            p->turn[i][j] = (i == j) + (i == k ? 2.0 * b : 0.0) -
                            (a + (i == k)) * (b + (j == k)) / (1.0 + s * u[k]);
        }
}

/* --- spans in one plane --------------------------------------------------- */

/* Of each span of a curve: bounds of the tangent, and of the powers of the
 * weight in it, and all rows at a place that is no root of low order. */
typedef struct {
    const ix_form *m;
    double *size, *unit, *at; /* [nspans], [nspans], [nspans][nrows] */
} samples;

#define PLACE 0.4142135623730951

static double in_span(const ix_form *m, int i, double u)
{
    const double *b = m->dirs[0].breaks + i;

    return b[0] + u * (b[1] - b[0]);
}

/* The largest weight of each span to the power in the minors. */
static ix_status weigh_spans(ix_ctx *ctx, const ix_crv_pair *p, int i,
                             samples *s)
{
    int n = p->f[i].dirs[0].nspans;
    size_t block = (size_t)p->f[i].dirs[0].degree + 1;
    const double *b;

    IX_SCRATCH(ctx, s->unit, n);
    for (int j = 0; j < n; j++)
        s->unit[j] = 1.0;
    if (p->powers[i] == 0)
        return IX_OK;
    IX_TRY(ix__form_bernstein(ctx, &p->f[i], &b));
    for (int j = 0; j < n; j++)
        s->unit[j] = pow(ix__bern_largest(block, b + (size_t)j * block),
                         p->powers[i]);
    return IX_OK;
}

static ix_status sample(ix_ctx *ctx, const ix_form *m, samples *s)
{
    int sign, first = ix__lift_minor(0, 3, &sign), n = m->dirs[0].nspans;
    ix_form tangent = ix__form_rows(m, first, 3);
    size_t block = (size_t)m->dirs[0].degree + 1;
    const double *b;

    s->m = m;
    IX_TRY(ix__form_bernstein(ctx, &tangent, &b));
    IX_SCRATCH(ctx, s->size, n);
    IX_SCRATCH(ctx, s->at, (size_t)n * (size_t)m->nrows);
    for (int i = 0; i < n; i++) {
        double t = in_span(m, i, PLACE);

        s->size[i] = 0.0;
        for (int r = 0; r < 3; r++)
            s->size[i] = fmax(s->size[i],
                              ix__bern_largest(block, b + (size_t)r * m->n +
                                                          (size_t)i * block));
        ix__form_eval(m, &t, s->at + (size_t)i * (size_t)m->nrows);
    }
    return IX_OK;
}

static double product(const ix_outer *w, const double *u, const double *v)
{
    double sum = 0.0;

    for (int k = 0; k < w->nterms; k++)
        sum += w->terms[k].coef * u[w->terms[k].u] * v[w->terms[k].v];
    return sum;
}

/* The largest weight at as many places of both spans as decide that it is not
 * zero everywhere. */
static ix_status largest_over(ix_ctx *ctx, const ix_outer *w, int i, int j,
                              double *big)
{
    int nu = w->u->dirs[0].degree + 1, nv = w->v->dirs[0].degree + 1;
    double *u, *v;

    IX_SCRATCH(ctx, u, w->u->nrows);
    IX_SCRATCH(ctx, v, w->v->nrows);
    *big = 0.0;
    for (int a = 0; a < nu; a++) {
        double s = in_span(w->u, i, (a + 0.5) / nu);

        ix__form_eval(w->u, &s, u);
        for (int b = 0; b < nv; b++) {
            double t = in_span(w->v, j, (b + 0.5) / nv);

            ix__form_eval(w->v, &t, v);
            *big = fmax(*big, fabs(product(w, u, v)));
        }
    }
    return IX_OK;
}

static ix_status refuse_spans(ix_ctx *ctx, const ix_outer *w, int i, int j,
                              double ratio, double band)
{
    const double *a = w->u->dirs[0].breaks + i, *b = w->v->dirs[0].breaks + j;

    return IX_FAIL(ctx, IX_EDOMAIN,
                   "curve 1 over %g .. %g and curve 2 over %g .. %g lie in one "
                   "plane: the weight is at most %.3g of its terms, error band "
                   "%.3g; CREGION separates the parts that have a bisector "
                   "surface",
                   a[0], a[1], b[0], b[1], ratio, band);
}

static ix_status sample_both(ix_ctx *ctx, const ix_crv_pair *p,
                             const ix_outer *w, samples s[2])
{
    for (int k = 0; k < 2; k++) {
        IX_TRY(sample(ctx, k ? w->v : w->u, &s[k]));
        IX_TRY(weigh_spans(ctx, p, k, &s[k]));
        for (int i = 0; i < s[k].m->dirs[0].nspans; i++)
            if (!(s[k].size[i] > p->band * s[k].unit[i]))
                return IX_FAIL(ctx, IX_EDOMAIN,
                               "curve %d stands still over %g .. %g: its "
                               "tangent is at most %.3g of the size of both "
                               "curves, error band %.3g",
                               k + 1, s[k].m->dirs[0].breaks[i],
                               s[k].m->dirs[0].breaks[i + 1],
                               s[k].size[i] / s[k].unit[i], p->band);
    }
    return IX_OK;
}

/* Spans in one plane with a span of the other curve. The six products of
 * coordinates, at most 1 in the frame, and tangents have an error of band times
 * the tangents each; of thin pairs each has two factors across, of which one is
 * in error. */
typedef struct {
    int i, j; /* the first such pair */
    double ratio;
    bool any, all;
} flat_spans;

static ix_status find_flat(ix_ctx *ctx, const samples s[2], const ix_outer *w,
                           double band, flat_spans *f)
{
    *f = (flat_spans){.all = true};
    for (int i = 0; i < w->u->dirs[0].nspans; i++)
        for (int j = 0; j < w->v->dirs[0].nspans; j++) {
            double size = s[0].size[i] * s[1].size[j],
                   big = fabs(product(w, s[0].at + i * w->u->nrows,
                                      s[1].at + j * w->v->nrows));

            if (!(big > band * size))
                IX_TRY(largest_over(ctx, w, i, j, &big));
            if (big > band * size) {
                f->all = false;
            } else if (!f->any) {
                *f = (flat_spans){i, j, big / size, true, f->all};
            }
            if (f->any && !f->all)
                return IX_OK;
        }
    return IX_OK;
}

static ix_status refuse_all(ix_ctx *ctx, const ix_crv_pair *p, double ratio)
{
    double u[3], length, off = off_line(p->crv, u, &length);

    if (off <= ldexp(p->band, p->frame.exp))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the curves lie on one straight line, within %.3g: "
                       "their bisector consists of planes at right angles to "
                       "it",
                       off);
    return IX_FAIL(ctx, IX_EDOMAIN,
                   "the curves lie in one plane: the weight is at most %.3g of "
                   "its terms, error band %.3g; their bisector is a cylinder "
                   "over that in the plane",
                   ratio, p->band);
}

/* --- all of both -----------------------------------------------------------
 */

ix_status ix__crv_pair_check(ix_ctx *ctx, const ix_crv_pair *p)
{
    for (int i = 0; i < 2; i++)
        IX_TRY(check_point(ctx, p, i));
    for (int i = 0; i < 2; i++)
        IX_TRY(check_same(ctx, p->crv, p, i == 1));
    return IX_OK;
}

ix_status ix__crv_pair_weight(ix_ctx *ctx, const ix_crv_pair *p,
                              const ix_outer *w)
{
    double band = (double)w->nterms * p->band * p->thin;
    flat_spans f;
    samples s[2];

    IX_TRY(sample_both(ctx, p, w, s));
    IX_TRY(find_flat(ctx, s, w, band, &f));
    if (!f.any)
        return IX_OK;
    return f.all ? refuse_all(ctx, p, f.ratio)
                 : refuse_spans(ctx, w, f.i, f.j, f.ratio, band);
}

/* --- meetings --------------------------------------------------------------
 */

static ix_status run_along(ix_ctx *ctx, const ix_mv *const *c, double eps,
                           ix_report *rep)
{
    ix_overlap o;

    for (int i = 0; i < 2; i++)
        if (c[i]->dirs[0].basis == IX_POWER) /* its meetings are left as such */
            return IX_OK;
    IX_TRY(ix_crv_overlap(ctx, c[0], c[1], eps, &o));
    if (o.relation == IX_CRVS_DISTINCT)
        return IX_OK;
    for (int i = 0; i < 2; i++) {
        rep->overlap[0][i] = o.a[i];
        rep->overlap[1][i] = o.b[i];
    }
    rep->nmeetings = 0;
    return IX_OK;
}

ix_status ix_bisector_meetings(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                               ix_report *rep)
{
    const ix_mv *const c[2] = {c1, c2};
    ix_status st = IX_OK;
    ix_meetings m;

    rep->nmeetings = 0;
    memset(rep->overlap, 0, sizeof rep->overlap);
    IX_TRY(ix_crv_meetings(ctx, c1, c2, &m));
    rep->nmeetings = m.n;
    for (int i = 0; i < m.n && i < IX_REPORT_MEETINGS; i++)
        for (int k = 0; k < 2; k++)
            rep->meetings[i][k] = m.at[i].t[k];
    if (!m.complete)
        st = run_along(ctx, c, m.eps, rep);
    ix_meetings_free(ctx, &m);
    return st;
}
