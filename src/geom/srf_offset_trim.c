/* srf_offset_trim.c - where the offset of a surface meets itself, as far as it
 * is not nearer to the surface than an amount: the edges of the offset after
 * its inner parts have been cut off. */
#include <math.h>
#include <string.h>

#include "geom/crvs.h"
#include "iritx/distance.h"
#include "iritx/offset.h"
#include "mv/mv.h"

#define HALVINGS \
    30 /* of a polyline's edge, to find where the distance is cut */

typedef struct {
    ix_ctx *ctx;
    const ix_mv *srf, *off;
    double amount;
    bool euclid;
    ix_mv **run; /* references, n of them */
    int n;
} job;

/* Whether the point of off at uv is amount away from srf. */
static ix_status is_far(const job *j, const double *uv, bool *far)
{
    double p[IX_MAX_COORDS] = {0}, foot[2], d;

    *far = true;
    if (!(j->amount > 0))
        return IX_OK;
    IX_TRY(ix_mv_point(j->ctx, j->off, uv, p));
    IX_TRY(ix_srf_nearest(j->ctx, j->srf, p, false, foot, &d));
    *far = d >= j->amount;
    return IX_OK;
}

/* The last place on the edge from a (far) to b (not) that is far. */
static ix_status last_far(const job *j, const double *a, const double *b,
                          double *out)
{
    double lo = 0, hi = 1;

    for (int i = 0; i < HALVINGS; i++) {
        double mid = 0.5 * (lo + hi);
        bool far;

        for (int k = 0; k < 4; k++)
            out[k] = a[k] + mid * (b[k] - a[k]);
        IX_TRY(is_far(j, out, &far));
        *(far ? &lo : &hi) = mid;
    }
    for (int k = 0; k < 4; k++)
        out[k] = a[k] + lo * (b[k] - a[k]);
    return IX_OK;
}

/* A curve of order 2 through n points x[n][4], or their points on off. */
static ix_status add_run(job *j, int n, double (*x)[4])
{
    int nc = j->euclid ? 3 : 4;
    ix_dir d = {IX_BSPLINE, 2, n, false, NULL};
    double *kv, *pts;

    IX_SCRATCH(j->ctx, kv, n + 2);
    IX_SCRATCH(j->ctx, pts, (size_t)nc * (size_t)n);
    for (int i = 0; i < n + 2; i++)
        kv[i] = i < 1 ? 0 : i > n ? n - 1 : i - 1;
    for (int i = 0; i < n; i++) {
        double p[IX_MAX_COORDS] = {0};

        if (j->euclid)
            IX_TRY(ix_mv_point(j->ctx, j->off, x[i], p));
        else
            memcpy(p, x[i], sizeof x[i]);
        for (int k = 0; k < nc; k++)
            pts[(size_t)k * (size_t)n + (size_t)i] = p[k];
    }
    d.knots = kv;
    IX_TRY(ix_mv_new(j->ctx, 1, &d, nc, false, pts, &j->run[j->n]));
    j->n++;
    return IX_OK;
}

/* The runs of far vertices of one curve; x has room for n + 2 points. */
static ix_status add_runs(job *j, const ix_solution_curve *c, double (*x)[4])
{
    bool before = false, far;
    int n = 0;

    for (int i = 0; i <= c->n; i++) {
        const double *at = c->x + 4 * i;

        far = false;
        if (i < c->n)
            IX_TRY(is_far(j, at, &far));
        if (far && !before && i > 0)
            IX_TRY(last_far(j, at, at - 4, x[n++]));
        if (far)
            memcpy(x[n++], at, sizeof *x);
        if (before && !far && i < c->n)
            IX_TRY(last_far(j, at - 4, at, x[n++]));
        if (!far && n > 1)
            IX_TRY(add_run(j, n, x));
        if (!far)
            n = 0;
        before = far;
    }
    return IX_OK;
}

static ix_status all_runs(job *j, const ix_solution_curves *s)
{
    size_t vertices = 0, most = 0;
    double(*x)[4];

    for (int i = 0; i < s->ncurves; i++) {
        size_t n = (size_t)s->curve[i].n;

        vertices += n;
        most = n > most ? n : most;
    }
    IX_SCRATCH(j->ctx, x, most + 2);
    IX_SCRATCH(j->ctx, j->run, vertices); /* a run has one vertex at least */
    for (int i = 0; i < s->ncurves; i++)
        IX_TRY(add_runs(j, &s->curve[i], x));
    return IX_OK;
}

/* The runs, whose references it takes over, as a result. */
static ix_status give(job *j, ix_status st, ix_crvs *out)
{
    if (st == IX_OK)
        st = ix__crvs_new(j->ctx, j->n, out);
    for (int i = 0; i < j->n; i++) {
        if (st != IX_OK) {
            ix_mv_unref(j->ctx, j->run[i]);
            continue;
        }
        out->crv[i] = j->run[i];
        ix_mv_domain(j->run[i], 0, out->t + 2 * i);
    }
    return st;
}

ix_status ix_srf_offset_meet(ix_ctx *ctx, const ix_mv *srf, const ix_mv *off,
                             double amount, bool euclid, double tol,
                             bool *complete, ix_crvs *out)
{
    job j = {ctx, srf, off, amount, euclid, NULL, 0};
    ix_solution_curves s;
    ix_status st;
    ix_mark mk;

    *out = (ix_crvs){0};
    if (srf->ndirs != 2 || srf->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a surface of at "
                       "most 3 is wanted",
                       srf->ndirs, srf->ncoords);
    IX_TRY(ix_srf_self_meet(ctx, off, tol, &s));
    *complete = s.complete;
    mk = ix__scratch_mark(ctx);
    st = give(&j, all_runs(&j, &s), out);
    ix__scratch_release(ctx, mk);
    ix_solution_curves_free(ctx, &s);
    return st;
}
