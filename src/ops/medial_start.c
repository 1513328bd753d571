/* medial_start.c - where medial curves start: where the borders meet, and at
 * the ends of their ranges, by Newton's method (Rausch et al. (4.6)) from a net
 * of geodesics. */
#include <math.h>
#include <string.h>

#include "iritx/distance.h"
#include "ops/medial.h"

enum {
    ROWS = 32,     /* geodesics of the net, and one more */
    MORE_ROWS = 8, /* for each further polynomial of the border */
    STEPS = 96,    /* of a geodesic, up to the reach */
    MEETINGS = 1000
};

ix_status ix__medial_seed_add(ix__medial *m, ix__medial_seeds *out,
                              const double x[3], int fixed)
{
    ix__medial_seed s = {.fixed = fixed};
    void *at = ix__geo_grow(m->g->ctx, out->at, out->n, &out->room,
                            sizeof *out->at);

    if (!at)
        return IX_ENOMEM;
    out->at = at;
    memcpy(s.x, x, sizeof s.x);
    memcpy(s.side, m->side, sizeof s.side);
    out->at[out->n++] = s;
    return IX_OK;
}

/* --- where the borders meet ----------------------------------------------- */

static ix_status add_meetings(ix__medial *m, const ix_solutions *found,
                              ix__medial_seeds *out)
{
    for (int i = 0; i < found->n; i++) {
        double x[3] = {0, 0, 0};
        ix__medial_point p;
        bool ok;

        for (int k = 0; k < 2; k++)
            x[k] = (found->sol[i].x[k] - m->g->c[k].lo) / m->g->c[k].len;
        ix__medial_spans(m, x, true);
        IX_TRY(ix__medial_eval(m, x, &p, &ok));
        if (ok && p.regular && hypot(p.f[0], p.f[1]) < 1e-6)
            IX_TRY(ix__medial_seed_add(m, out, x, -1));
    }
    return IX_OK;
}

ix_status ix__medial_meetings(ix__medial *m, ix__medial_seeds *out)
{
    ix_solutions found;
    ix_status st;

    IX_TRY(
        ix_crv_crv_meet(m->g->ctx, m->g->c[0].mv, m->g->c[1].mv, NULL, &found));
    if (found.n > MEETINGS)
        st = IX_FAIL(m->g->ctx, IX_EDOMAIN,
                     "the borders overlap: they meet at %d places", found.n);
    else
        st = add_meetings(m, &found, out);
    ix_solutions_free(m->g->ctx, &found);
    return st;
}

/* --- the net -------------------------------------------------------------- */

/* Points of geodesics at the distances j h, j = 0 .. STEPS. */
typedef struct {
    int n; /* geodesics */
    double h;
    double *t;       /* [n] */
    int *reached;    /* [n]: the last step before it ends or has a focal
                        point */
    double (*uv)[2]; /* [n][STEPS + 1] */
} net;

/* Geodesic i of border k. */
static ix_status fill_row(ix__medial *m, int k, net *w, int i)
{
    const ix__geo_way way = {.stop_at_focal = true};
    double s = 0;
    ix__geo_state q;
    ix__geo_place p;
    ix_geo_stop stop = IX_GEO_END;
    const ix__geo_crv *c = &m->g->c[k];

    w->reached[i] = -1;
    if (!ix__geo_place_at(c, ix__geo_crv_span(c, w->t[i]), w->t[i], false, &p))
        return IX_OK;
    ix__geo_start(&p, m->side[k], q);
    m->g->cell = p.cell;
    for (int j = 0; j <= STEPS && stop == IX_GEO_END; j++) {
        if (j > 0)
            IX_TRY(ix__geo_run(m->g, &way, m->side[k], j * w->h, &s, q, &stop));
        if (stop == IX_GEO_END) {
            memcpy(w->uv[i * (STEPS + 1) + j], q, 2 * sizeof *q);
            w->reached[i] = j;
        }
    }
    return IX_OK;
}

/* The net of border k on its side; from, to: parameters, or only one. */
static ix_status make_net(ix__medial *m, int k, int n, double from, net *w)
{
    ix_ctx *ctx = m->g->ctx;

    w->n = n;
    w->h = m->g->reach / STEPS;
    IX_SCRATCH(ctx, w->t, n);
    IX_SCRATCH(ctx, w->reached, n);
    IX_SCRATCH(ctx, w->uv, n * (STEPS + 1));
    for (int i = 0; i < n; i++) {
        w->t[i] = n > 1 ? (double)i / (n - 1) : from;
        IX_TRY(fill_row(m, k, w, i));
    }
    return IX_OK;
}

/* --- candidates ----------------------------------------------------------- */

/* Could 0 be a difference within the cell of geodesics i, i + 1 and steps j, j
 * + 1? Both parts change their sign, with as much to spare as they vary. */
static bool candidate(const net *w, const net *one, int i, int j)
{
    for (int d = 0; d < 2; d++) {
        double lo = HUGE_VAL, hi = -HUGE_VAL, more;

        for (int q = 0; q < 4; q++) {
            int r = i + q / 2, c = j + q % 2;
            double x = w->uv[r * (STEPS + 1) + c][d] - one->uv[c][d];

            lo = fmin(lo, x);
            hi = fmax(hi, x);
        }
        more = 0.25 * (hi - lo);
        if (!(lo - more <= 0 && hi + more >= 0))
            return false;
    }
    return true;
}

static bool in_range(const ix__medial *m, const ix__medial_point *p,
                     const double x[3])
{
    for (int k = 0; k < 2; k++) {
        const ix__geo_shot *q = &p->shot[k];

        if (!(x[k] >= -1e-10 && x[k] <= 1 + 1e-10 && q->q[4] > 0 &&
              q->inside >= -1e-10))
            return false;
    }
    return x[2] >= -1e-9 && x[2] <= m->g->reach;
}

/* The same point for the same sides, or those opposite at -s. */
static bool known(const ix__medial *m, const ix__medial_seeds *s,
                  const double x[3])
{
    for (int i = 0; i < s->n; i++) {
        const ix__medial_seed *e = &s->at[i];
        double f = e->side[0] == m->side[0] ? 1 : -1;

        if (e->side[0] * e->side[1] == m->side[0] * m->side[1] &&
            fabs(e->x[0] - x[0]) + fabs(e->x[1] - x[1]) +
                    fabs(e->x[2] - f * x[2]) <
                1e-7)
            return true;
    }
    return false;
}

/* Newton's method from the middle of a cell; border k is at its end t. */
static ix_status try_cell(ix__medial *m, int k, double t, const net *w, int i,
                          int j, ix__medial_seeds *out)
{
    double x[3];
    ix__medial_point p;
    bool ok;

    x[k] = t;
    x[1 - k] = 0.5 * (w->t[i] + w->t[i + 1]);
    x[2] = (j + 0.5) * w->h;
    ix__medial_spans(m, x, true);
    IX_TRY(ix__medial_newton(m, k, x, &p, &ok));
    if (ok && in_range(m, &p, x) && !known(m, out, x))
        return ix__medial_seed_add(m, out, x, k);
    return IX_OK;
}

/* All points with a foot at the end t of border k. */
static ix_status search(ix__medial *m, int k, double t, const net *w,
                        ix__medial_seeds *out)
{
    net one;

    IX_TRY(make_net(m, k, 1, t, &one));
    for (int i = 0; i + 1 < w->n; i++)
        for (int j = 0;
             j < one.reached[0] && j < w->reached[i] && j < w->reached[i + 1];
             j++)
            if (candidate(w, &one, i, j))
                IX_TRY(try_cell(m, k, t, w, i, j, out));
    return IX_OK;
}

ix_status ix__medial_ends(ix__medial *m, ix__medial_seeds *out)
{
    for (int k = 0; k < 2; k++) {
        int rows = ROWS + MORE_ROWS * (m->g->c[1 - k].pieces - 1);
        net w;

        IX_TRY(make_net(m, 1 - k, rows + 1, 0, &w));
        for (int end = 0; end < 2; end++)
            IX_TRY(search(m, k, end, &w, out));
    }
    return IX_OK;
}
