/* srf_offset.c - offsets of surfaces: control points moved along the normals
 * at their nodes, with knots inserted until the surface is near enough. */
#include <string.h>

#include "bsp/spans.h"
#include "geom/parts.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"
#include "iritx/offset.h"

enum { SAMPLES = 4, MAX_ROUNDS = 12, MAX_POINTS = 1 << 18 };

typedef struct {
    ix_ctx *ctx;
    const ix_mv *srf; /* open or Bezier */
    double distance, tol, worst;
} job;

/* The surface as it is refined, and the middles of its spans that want a knot.
 */
typedef struct {
    int n[2]; /* spans */
    double *breaks[2];
    bool *bad[2]; /* [n]: insert a knot in the middle */
} patches;

static ix_status exact_point(const job *j, const double uv[2], double p[3])
{
    double x[IX_MAX_COORDS] = {0}, n[3];

    IX_TRY(ix_srf_normal(j->ctx, j->srf, uv[0], uv[1], n));
    IX_TRY(ix_mv_point(j->ctx, j->srf, uv, x));
    ix__axpy3(x, j->distance, n, p);
    return IX_OK;
}

static ix_status move_points(const job *j, const ix_mv *s, ix_mv **out)
{
    const double *w = ix_mv_weights(s);
    size_t nu = (size_t)s->dirs[0].length;
    double *node[2], n[3];
    ix_status st = IX_OK;
    ix_mv *m;

    for (int k = 0; k < 2; k++) {
        IX_SCRATCH(j->ctx, node[k], s->dirs[k].length);
        ix_knots_nodes(&s->dirs[k], node[k]);
    }
    IX_TRY(ix__mv_alloc(j->ctx, 2, s->dirs, 3, s->rational, &m));
    memset(m->pts, 0, (size_t)m->naxes * m->npts * sizeof *m->pts);
    memcpy(m->pts, s->pts, (size_t)s->naxes * s->npts * sizeof *m->pts);
    for (size_t i = 0; st == IX_OK && i < m->npts; i++) {
        double f = j->distance * (w ? w[i] : 1);

        st = ix_srf_normal(j->ctx, j->srf, node[0][i % nu], node[1][i / nu], n);
        for (int k = 0; st == IX_OK && k < 3; k++)
            m->pts[(size_t)(k + (w ? 1 : 0)) * m->npts + i] += f * n[k];
    }
    return ix__mv_finish(j->ctx, st, m, out);
}

/* --- where it is not near enough
 * ----------------------------------------------- */

static ix_status load_breaks(const job *j, const ix_mv *s, patches *p)
{
    for (int k = 0; k < 2; k++) {
        ix_spans sp;

        IX_TRY(ix__spans_of(j->ctx, &s->dirs[k], &sp));
        p->n[k] = sp.nspans;
        IX_SCRATCH(j->ctx, p->breaks[k], sp.nspans + 1);
        memcpy(p->breaks[k], sp.breaks,
               (size_t)(sp.nspans + 1) * sizeof *p->breaks[k]);
        IX_SCRATCH_ZERO(j->ctx, p->bad[k], sp.nspans);
    }
    return IX_OK;
}

/* Does the normal change along direction k of the patch, by more than 1e-9,
 * where the other parameter is at part f of the patch? Looked at in places that
 * a symmetric surface does not make alike. */
static ix_status turns_at(const job *j, const double lo[2], const double hi[2],
                          int k, double f, bool *out)
{
    static const double at[] = {0, 0.17, 0.36, 0.53, 0.71, 0.88, 1};
    double first[3], n[3];

    for (size_t i = 0; !*out && i < sizeof at / sizeof *at; i++) {
        double t[2];

        t[k] = lo[k] + at[i] * (hi[k] - lo[k]);
        t[1 - k] = lo[1 - k] + f * (hi[1 - k] - lo[1 - k]);
        IX_TRY(ix_srf_normal(j->ctx, j->srf, t[0], t[1], n));
        if (i == 0)
            memcpy(first, n, sizeof first);
        *out = ix__dist3(n, first) > 1e-9;
    }
    return IX_OK;
}

static ix_status turns(const job *j, const double lo[2], const double hi[2],
                       int k, bool *out)
{
    for (int i = 0; !*out && i < 3; i++)
        IX_TRY(turns_at(j, lo, hi, k, 0.2 + 0.31 * i, out));
    return IX_OK;
}

static ix_status patch_error(const job *j, const ix_mv *off, const double lo[2],
                             const double hi[2], double *err)
{
    *err = 0;
    for (int i = 0; i < SAMPLES * SAMPLES; i++) {
        int col = i % SAMPLES, row = i / SAMPLES;
        double f[2] = {(col + 0.5) / SAMPLES, (row + 0.5) / SAMPLES};
        double uv[2] = {lo[0] + f[0] * (hi[0] - lo[0]),
                        lo[1] + f[1] * (hi[1] - lo[1])};
        double got[3], want[3];

        IX_TRY(exact_point(j, uv, want));
        IX_TRY(ix_mv_point(j->ctx, off, uv, got));
        *err = fmax(*err, ix__dist3(got, want));
    }
    return IX_OK;
}

static ix_status look(job *j, const ix_mv *off, patches *p, bool *any)
{
    j->worst = 0;
    *any = false;
    for (int v = 0; v < p->n[1]; v++)
        for (int u = 0; u < p->n[0]; u++) {
            double lo[2] = {p->breaks[0][u], p->breaks[1][v]}, err;
            double hi[2] = {p->breaks[0][u + 1], p->breaks[1][v + 1]};
            bool *bad[2] = {&p->bad[0][u], &p->bad[1][v]};

            IX_TRY(patch_error(j, off, lo, hi, &err));
            j->worst = fmax(j->worst, err);
            for (int k = 0; !(err <= j->tol) && k < 2; k++)
                if (!*bad[k])
                    IX_TRY(turns(j, lo, hi, k, bad[k]));
            *any |= *bad[0] || *bad[1];
        }
    return IX_OK;
}

static ix_status insert(const job *j, const patches *p, const ix_mv *s,
                        ix_mv **out)
{
    ix_mv *cur = ix_mv_ref(s), *next;

    for (int k = 0; k < 2; k++) {
        double *knots;
        int n = 0;

        IX_SCRATCH(j->ctx, knots, p->n[k]);
        for (int i = 0; i < p->n[k]; i++)
            if (p->bad[k][i])
                knots[n++] = (p->breaks[k][i] + p->breaks[k][i + 1]) / 2;
        if (n)
            IX_TRY(ix__mv_step(
                j->ctx, &cur, &next,
                ix_mv_insert_knots(j->ctx, cur, k, n, knots, &next)));
    }
    *out = cur;
    return IX_OK;
}

static ix_status round_of(job *j, ix_mv **cur, bool last, ix_mv **out)
{
    ix_mv *next = NULL;
    bool any = false;
    ix_status st;
    patches p;

    IX_TRY(move_points(j, *cur, out));
    st = load_breaks(j, *cur, &p);
    if (st == IX_OK)
        st = look(j, *out, &p, &any);
    if (st == IX_OK && (!any || last))
        return IX_OK;
    if (st == IX_OK)
        st = insert(j, &p, *cur, &next);
    ix_mv_unref(j->ctx, *out);
    *out = NULL;
    IX_TRY(st);
    ix_mv_unref(j->ctx, *cur);
    *cur = next;
    return ix__poll(j->ctx);
}

static ix_status refine(job *j, ix_mv **out)
{
    ix_mv *cur = ix_mv_ref(j->srf);
    ix_status st = IX_OK;

    for (int i = 0; st == IX_OK && !*out; i++) {
        ix_mark mk = ix__scratch_mark(j->ctx);

        st = round_of(j, &cur, i == MAX_ROUNDS || cur->npts > MAX_POINTS, out);
        ix__scratch_release(j->ctx, mk);
    }
    ix_mv_unref(j->ctx, cur);
    return st;
}

ix_status ix_srf_offset(ix_ctx *ctx, const ix_mv *srf, double distance,
                        double tol, double *err, ix_mv **out)
{
    job j = {.ctx = ctx, .distance = distance, .tol = tol};
    ix_mv *plain, *open = NULL;
    ix_status st;

    *out = NULL;
    if (srf->ndirs != 2 || !(tol > 0) || !isfinite(distance))
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions, distance %g, tolerance %g; a surface "
                       "and a positive tolerance are wanted",
                       srf->ndirs, distance, tol);
    IX_TRY(ix__mv_plain(ctx, srf, &plain));
    st = ix_mv_to_open(ctx, plain, &open);
    j.srf = open;
    if (st == IX_OK)
        st = refine(&j, out);
    ix_mv_unref(ctx, plain);
    ix_mv_unref(ctx, open);
    if (st == IX_OK && err)
        *err = j.worst;
    return st;
}
