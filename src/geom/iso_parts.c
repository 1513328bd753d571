/* iso_parts.c - isoparametric curves only where they are needed (Elber, Cohen
 * 1996): where two neighbours are too far apart, the curve in the middle goes
 * between them, over just those parameters. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"
#include "geom/iso_curves.h"
#include "geom/parts.h"
#include "iritx/solve.h"
#include "iritx/sym.h"

enum { MOST = 1 << 16, DEEPEST = 24 };

typedef struct {
    ix_ctx *ctx;
    const ix_mv *s;
    int dir;
    double eps;
    int n, room;
    ix__iso_part *part;
} parts;

static ix_status add(parts *w, double t, const double range[2], int level)
{
    if (w->n == MOST)
        return IX_FAIL(w->ctx, IX_EUNABLE,
                       "more than %d curves for a distance of %g", MOST,
                       w->eps);
    IX_GROW(w->ctx, w->part, w->n, w->room);
    w->part[w->n++] = (ix__iso_part){t, {range[0], range[1]}, level};
    return IX_OK;
}

/* |S(., a) - S(., b)|^2 as a scalar curve. */
static ix_status gap_field(const parts *w, double a, double b, ix_mv **out)
{
    ix_mv *t[3] = {NULL};
    ix_status st = ix_mv_fix(w->ctx, w->s, w->dir, a, &t[0]);

    if (st == IX_OK)
        st = ix_mv_fix(w->ctx, w->s, w->dir, b, &t[1]);
    if (st == IX_OK)
        st = ix_sym_sub(w->ctx, t[0], t[1], NULL, &t[2]);
    if (st == IX_OK)
        st = ix_sym_dot(w->ctx, t[2], t[2], NULL, out);
    ix__mv_unref_all(w->ctx, t, 3);
    return st;
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* Parameters in the range at which the gap is eps, the range's ends around
 * them: (*cut)[*n], rising, in scratch. */
static ix_status cuts(const parts *w, const ix_mv *f, const double range[2],
                      int *n, double **cut)
{
    const ix_root_opts o = {
        .lo = range[0], .hi = range[1], .level = w->eps * w->eps};
    ix_root *r;
    int m;

    IX_TRY(ix_roots(w->ctx, f, ix_mv_rational(f), &o, &r, &m));
    *cut = ix__scratch(w->ctx, 2 * (size_t)m + 2, sizeof **cut);
    *n = 0;
    if (*cut) {
        (*cut)[(*n)++] = range[0];
        for (int i = 0; i < m; i++) {
            (*cut)[(*n)++] = r[i].lo;
            (*cut)[(*n)++] = r[i].hi;
        }
        (*cut)[(*n)++] = range[1];
        qsort(*cut, (size_t)*n, sizeof **cut, ascending);
    }
    ix_roots_free(w->ctx, r, m);
    return *cut ? IX_OK : IX_ENOMEM;
}

/* Curves wherever those at t[0] and t[1] are farther apart than eps in the
 * range. Its depth is bounded by DEEPEST. */
static ix_status between(parts *w, const double t[2], const double range[2],
                         int level)
{
    double *cut, tie = 1e-9 * (range[1] - range[0]);
    double mid = t[0] / 2 + t[1] / 2;
    const double half[2][2] = {{t[0], mid}, {mid, t[1]}};
    int n, from = -1;
    ix_mv *f;
    ix_status st;

    if (level > DEEPEST)
        return IX_FAIL(w->ctx, IX_EUNABLE,
                       "curves at %g and %g are still farther apart than %g",
                       t[0], t[1], w->eps);
    IX_TRY(ix__poll(w->ctx));
    IX_TRY(gap_field(w, t[0], t[1], &f));
    st = cuts(w, f, range, &n, &cut);
    for (int i = 0; st == IX_OK && i < n; i++) {
        bool far = false;

        if (i + 1 < n && cut[i + 1] - cut[i] > tie) {
            double m = cut[i] / 2 + cut[i + 1] / 2, d;

            st = ix_mv_point(w->ctx, f, &m, &d);
            far = st == IX_OK && !(d <= w->eps * w->eps);
        } else if (i + 1 < n) {
            continue;
        }
        if (far && from < 0)
            from = i;
        if (!far && from >= 0) {
            const double part[2] = {cut[from], cut[i]};

            from = -1;
            st = add(w, mid, part, level);
            for (int k = 0; k < 2 && st == IX_OK; k++)
                st = between(w, half[k], part, level + 1);
        }
    }
    ix_mv_unref(w->ctx, f);
    return st;
}

static int by_place(const void *a, const void *b)
{
    const ix__iso_part *p = a, *q = b;

    if (p->t < q->t || p->t > q->t)
        return p->t < q->t ? -1 : 1;
    return (p->range[0] > q->range[0]) - (p->range[0] < q->range[0]);
}

ix_status ix__iso_parts(ix_ctx *ctx, const ix_mv *s, int dir, double eps,
                        int *n, ix__iso_part **out)
{
    parts w = {.ctx = ctx, .s = s, .dir = dir, .eps = eps};
    double t[2], range[2], mid;

    *n = 0;
    IX_TRY(ix__iso_check(ctx, s, eps));
    if (ix_mv_has_poles(s))
        return IX_FAIL(ctx, IX_EDOMAIN, "weights of both signs, or 0");
    ix_mv_domain(s, dir, t);
    ix_mv_domain(s, 1 - dir, range);
    IX_TRY(add(&w, t[0], range, 0));
    IX_TRY(add(&w, t[1], range, 0));
    /* both ends of a closed surface are one curve: the middle always comes */
    mid = t[0] / 2 + t[1] / 2;
    IX_TRY(add(&w, mid, range, 1));
    IX_TRY(between(&w, (const double[2]){t[0], mid}, range, 2));
    IX_TRY(between(&w, (const double[2]){mid, t[1]}, range, 2));
    qsort(w.part, (size_t)w.n, sizeof *w.part, by_place);
    *n = w.n;
    *out = w.part;
    return IX_OK;
}
