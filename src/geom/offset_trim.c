/* offset_trim.c - where an offset runs backwards, and which of its pieces are
 * at the wanted distance. */
#include <stdlib.h>
#include <string.h>

#include "geom/crvs.h"
#include "iritx/distance.h"
#include "iritx/offset.h"
#include "iritx/sym.h"
#include "mv/mv.h"

/* --- local loops -----------------------------------------------------------
 */

static ix_status backwards_field(ix_ctx *ctx, const ix_mv *crv,
                                 const ix_mv *off, ix_mv **out)
{
    ix_mv *a, *b = NULL;
    ix_status st;

    IX_TRY(ix_sym_derive(ctx, crv, 0, NULL, &a));
    st = ix_sym_derive(ctx, off, 0, NULL, &b);
    if (st == IX_OK)
        st = ix_sym_dot(ctx, a, b, NULL, out);
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    return st;
}

/* The intervals where the function is negative, ends[n + 1][2]. */
static int negative_intervals(const ix_root *r, int n, bool all,
                              const double dom[2], double *ends)
{
    double from = dom[0];
    bool inside = n ? r[0].before < 0 : all;
    int k = 0;

    for (int i = 0; i < n; i++) {
        if (inside && r[i].lo > from) {
            ends[2 * k] = from;
            ends[2 * k++ + 1] = r[i].lo;
        }
        inside = r[i].after < 0;
        from = r[i].hi;
    }
    if (inside && dom[1] > from) {
        ends[2 * k] = from;
        ends[2 * k++ + 1] = dom[1];
    }
    return k;
}

static ix_status find_loops(ix_ctx *ctx, const ix_mv *f, double **ends, int *n)
{
    double dom[2], *room, mid, v[2];
    ix_root *r;
    ix_status st = IX_OK;
    int nr;

    ix_mv_domain(f, 0, dom);
    mid = (dom[0] + dom[1]) / 2;
    IX_TRY(ix_mv_eval(ctx, f, &mid, v));
    IX_TRY(ix_roots(ctx, f, f->rational, NULL, &r, &nr));
    room = ix__scratch(ctx, 2 * (size_t)(nr + 1), sizeof *room);
    if (room) {
        *n = negative_intervals(r, nr, v[f->rational] < 0, dom, room);
        if (*n) {
            size_t bytes = 2 * (size_t)*n * sizeof **ends;

            *ends = ix__alloc(ctx, bytes);
            if (*ends)
                memcpy(*ends, room, bytes);
        }
    }
    if (!room || (*n && !*ends))
        st = IX_ENOMEM;
    ix_roots_free(ctx, r, nr);
    return st;
}

ix_status ix_offset_loops(ix_ctx *ctx, const ix_mv *crv, const ix_mv *off,
                          double **ends, int *n)
{
    ix_status st;
    ix_mark mk;
    ix_mv *f;

    *ends = NULL;
    *n = 0;
    if (crv->ndirs != 1 || off->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG, "%d and %d directions; curves are wanted",
                       crv->ndirs, off->ndirs);
    IX_TRY(backwards_field(ctx, crv, off, &f));
    mk = ix__scratch_mark(ctx);
    st = find_loops(ctx, f, ends, n);
    ix__scratch_release(ctx, mk);
    ix_mv_unref(ctx, f);
    return st;
}

void ix_offset_loops_free(ix_ctx *ctx, double *ends, int n)
{
    ix__free(ctx, ends, 2 * (size_t)n * sizeof *ends);
}

/* --- global ones
 * ---------------------------------------------------------- */

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return x < y ? -1 : x > y;
}

/* The ends of the domain and the self-intersections between, sorted. */
static ix_status cuts(ix_ctx *ctx, const ix_mv *off, int *n, double **t)
{
    double dom[2], tie;
    ix_solutions s;
    int m = 1;

    ix_mv_domain(off, 0, dom);
    tie = 1e-9 * (dom[1] - dom[0]);
    IX_TRY(ix_crv_self_meet(ctx, off, &s));
    *t = ix__scratch(ctx, 2 * (size_t)s.n + 2, sizeof **t);
    for (int i = 0; *t && i < 2 * s.n; i++)
        (*t)[i] = s.sol[i / 2].x[i % 2];
    *n = 2 * s.n;
    ix_solutions_free(ctx, &s);
    if (!*t)
        return IX_ENOMEM;
    (*t)[(*n)++] = dom[0];
    (*t)[(*n)++] = dom[1];
    qsort(*t, (size_t)*n, sizeof **t, ascending);
    for (int i = 1; i < *n; i++)
        if ((*t)[i] - (*t)[m - 1] > tie)
            (*t)[m++] = (*t)[i];
    (*t)[m - 1] = dom[1]; /* a cut next to the end is the end */
    *n = m;
    return IX_OK;
}

/* False if some place of the piece is nearer to crv than amount. */
static ix_status far_enough(ix_ctx *ctx, const ix_mv *crv, const ix_mv *off,
                            double a, double b, double amount, bool *far)
{
    enum { PLACES = 10 };

    *far = true;
    for (int i = 1; *far && i < PLACES; i++) {
        double t = a + (b - a) * i / PLACES, p[IX_MAX_COORDS] = {0}, foot, d;

        IX_TRY(ix_mv_point(ctx, off, &t, p));
        IX_TRY(ix_crv_nearest(ctx, crv, p, NULL, false, &foot, &d));
        *far = d >= amount;
    }
    return IX_OK;
}

/* The next corner of off in (from, to), where it is continuous only; or to. */
static double next_corner(const ix_mv *off, double from, double to)
{
    ix_dir d = ix_mv_dir(off, 0);
    int nk = ix_mv_nknots(off, 0), run = 0;
    double tie = 1e-9 * (to - from);

    for (int i = 1; i < nk && d.knots[i] < to - tie; i++) {
        run = d.knots[i] > d.knots[i - 1] ? 1 : run + 1;
        if (run >= d.order - 1 && d.knots[i] > from + tie)
            return d.knots[i];
    }
    return to;
}

/* The parts between two crossings that keep their distance: the bridge of a
 * corner does not, but what it joins may. Adds to ends[2 * *n]. */
static ix_status keep_between(ix_ctx *ctx, const ix_mv *crv, const ix_mv *off,
                              const double ab[2], double amount, double *ends,
                              int *n)
{
    bool before = false, far;

    for (double from = ab[0], to; from < ab[1]; from = to) {
        to = next_corner(off, from, ab[1]);
        IX_TRY(far_enough(ctx, crv, off, from, to, amount, &far));
        if (far && !before)
            ends[2 * (*n)++] = from;
        if (far)
            ends[2 * *n - 1] = to;
        before = far;
    }
    return IX_OK;
}

static ix_status keep_far(ix_ctx *ctx, const ix_mv *crv, const ix_mv *off,
                          double amount, ix_crvs *out)
{
    double *t, *ends;
    int n, kept = 0;

    IX_TRY(cuts(ctx, off, &n, &t));
    IX_SCRATCH(ctx, ends, 2 * ((size_t)n + (size_t)ix_mv_nknots(off, 0)));
    for (int i = 0; i + 1 < n; i++)
        IX_TRY(keep_between(ctx, crv, off, t + i, amount, ends, &kept));
    IX_TRY(ix__crvs_new(ctx, kept, out));
    for (int i = 0; i < kept; i++) {
        IX_TRY(ix_mv_region(ctx, off, 0, ends[2 * i], ends[2 * i + 1],
                            &out->crv[i]));
        out->t[2 * i] = ends[2 * i];
        out->t[2 * i + 1] = ends[2 * i + 1];
    }
    return IX_OK;
}

ix_status ix_offset_trim(ix_ctx *ctx, const ix_mv *crv, const ix_mv *off,
                         double amount, ix_crvs *out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    *out = (ix_crvs){0};
    st = keep_far(ctx, crv, off, amount, out);
    ix__scratch_release(ctx, mk);
    if (st != IX_OK && out->n)
        ix_crvs_free(ctx, out);
    return st;
}
