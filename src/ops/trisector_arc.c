/* trisector_arc.c - the equations of a trisector linearised on a box of centres
 * and boxes of parameters (trisector_search.c). */
#include <math.h>
#include <string.h>

#include "ops/trisector_impl.h"

enum { NV = IX__TRI_VARS, NE = IX__TRI_EQS };

/* Of half widths: the larger box in which an arc is proven. */
#define MARGIN IX__TRI_MARGIN

/* Bounds of |A J - 1|, the centre's box larger by so much, or none: then they
 * hold for differences from the middle only. */
static void errors_of(const ix__tri_task *k, const ix__tri_box *b,
                      double larger, ix__tri_matrix jm, ix__tri_linear *l)
{
    const ix__tri_shape *sh = &k->shape;
    const ix__tri_jet *m[3], *h[3];
    double wide[3];
    ix__tri_matrix jh;

    for (int i = 0; i < 3; i++) {
        m[i] = &l->p[i]->m;
        h[i] = &l->p[i]->h;
        wide[i] = larger * b->h[i];
    }
    ix__tri_jacobian_bounds(sh, b->c, wide, m, h, jm, jh);
    for (int r = 0; r < sh->neqs; r++)
        for (int c = 0; c < sh->nvars; c++) {
            jm[r][c] *= l->half[c];
            jh[r][c] *= l->half[c];
        }
    memcpy(l->rad, jh, sizeof jh);
}

/* jm: the middle of J, if the inverse is not of it; else NULL. */
static void combine(const ix__tri_shape *sh, ix__tri_matrix jm,
                    ix__tri_linear *l)
{
    memset(l->err, 0, sizeof l->err);
    for (int r = 0; r < sh->neqs; r++)
        for (int q = 0; q < sh->neqs; q++) {
            double v = fabs(l->inv.inv[r][q]);

            for (int c = 0; c < sh->nvars; c++)
                l->err[r][c] += v * l->rad[q][c];
        }
    for (int r = 0; r < sh->neqs && jm; r++)
        for (int c = 0; c < sh->nvars; c++) {
            double m = c == l->inv.free ? -l->inv.slope[r]
                                        : -(double)(c == l->inv.of[r]);

            for (int q = 0; q < sh->neqs; q++)
                m += l->inv.inv[r][q] * jm[q][c];
            l->err[r][c] += fabs(m);
        }
}

static bool linearise(const ix__tri_task *k, const ix__tri_box *b,
                      ix__tri_linear *l)
{
    const ix__tri_shape *sh = &k->shape;
    const ix__tri_jet *at[3];
    ix__tri_matrix jm;
    double f[NE];

    for (int i = 0; i < 3; i++) {
        at[i] = &l->p[i]->at;
        l->half[i] = b->h[i];
        for (int a = 0; a < sh->ndirs[i]; a++)
            l->half[sh->at[i] + a] = l->p[i]->half[a];
    }
    ix__tri_values(sh, b->c, at, f);
    errors_of(k, b, 0.0, jm, l);
    if (!ix__tri_invert(sh, jm, -1, &l->inv))
        return false;
    combine(sh, NULL, l);
    for (int r = 0; r < sh->neqs; r++) {
        l->at0[r] = 0.0;
        for (int q = 0; q < sh->neqs; q++)
            l->at0[r] -= l->inv.inv[r][q] * f[q];
    }
    return true;
}

/* The error of row r if the unknowns are as far from 0 as reach. */
static double error_of(const ix__tri_linear *l, int nvars, int r,
                       const double *reach)
{
    double e = 0.0;

    for (int c = 0; c < nvars; c++)
        e += l->err[r][c] * reach[c];
    return e;
}

/* Of the box: rounding of the values. */
#define ROUNDING 1e-6

static bool clip(double range[2], double lo, double hi)
{
    range[0] = fmax(range[0], lo - ROUNDING);
    range[1] = fmin(range[1], hi + ROUNDING);
    return range[0] <= range[1];
}

/* Row r makes the ranges of its unknown and of the free one smaller; false if
 * nothing is left. */
static bool tighten(ix__tri_linear *l, int nvars, int r)
{
    double *own = l->range[l->inv.of[r]], *free = l->range[l->inv.free];
    double slope = l->inv.slope[r], reach[NV], e, x[2];

    for (int c = 0; c < nvars; c++)
        reach[c] = fmax(fabs(l->range[c][0]), fabs(l->range[c][1]));
    e = error_of(l, nvars, r, reach);
    x[0] = -slope * free[0];
    x[1] = -slope * free[1];
    if (!clip(own, l->at0[r] + fmin(x[0], x[1]) - e,
              l->at0[r] + fmax(x[0], x[1]) + e))
        return false;
    if (fabs(slope) < 1e-3)
        return true;
    x[0] = (l->at0[r] - own[0] + e) / slope;
    x[1] = (l->at0[r] - own[1] - e) / slope;
    return clip(free, fmin(x[0], x[1]), fmax(x[0], x[1]));
}

/* Whether each value of the free unknown in its range has exactly one point,
 * within the larger box. */
static bool is_arc(const ix__tri_linear *l, const ix__tri_shape *sh)
{
    const double *free = l->range[l->inv.free];
    double reach[NV];

    for (int c = 0; c < sh->nvars; c++)
        reach[c] = 1.0 + MARGIN;
    for (int r = 0; r < sh->neqs; r++) {
        double e = error_of(l, sh->nvars, r, reach);

        for (int k = 0; k < 2; k++)
            if (!(fabs(l->at0[r] - l->inv.slope[r] * free[k]) + e <
                  1.0 + MARGIN - ROUNDING))
                return false;
    }
    return true;
}

enum { ROUNDS = 3 };

/* is_arc with bounds that hold for all differences in the larger box. */
static bool is_proven(const ix__tri_task *k, const ix__tri_box *b,
                      ix__tri_linear *l)
{
    const ix__tri_foot *kept[3];
    ix__tri_foot wide[3];
    ix__tri_matrix jm;

    for (int i = 0; i < 3; i++) {
        wide[i] = *l->p[i];
        ix__tri_measure(&k->object[i], MARGIN, &wide[i]);
        if (!wide[i].bounded)
            return false;
    }
    for (int i = 0; i < 3; i++) {
        kept[i] = l->p[i];
        l->p[i] = &wide[i];
    }
    errors_of(k, b, 1.0 + MARGIN, jm, l);
    memcpy(l->p, kept, sizeof kept);
    combine(&k->shape, jm, l);
    return is_arc(l, &k->shape);
}

ix__tri_verdict ix__tri_judge(const ix__tri_task *k, const ix__tri_box *b,
                              ix__tri_linear *l)
{
    const ix__tri_shape *sh = &k->shape;

    for (int c = 0; c < NV; c++) {
        l->range[c][0] = -1.0;
        l->range[c][1] = 1.0;
    }
    l->inv.free = -1;
    for (int i = 0; i < 3; i++)
        if (!l->p[i]->bounded)
            return IX__TRI_UNDECIDED;
    if (!linearise(k, b, l)) {
        l->inv.free = -1;
        return IX__TRI_UNDECIDED;
    }
    for (int round = 0; round < ROUNDS; round++)
        for (int r = 0; r < sh->neqs; r++)
            if (!tighten(l, sh->nvars, r))
                return IX__TRI_NONE;
    return is_arc(l, sh) && is_proven(k, b, l) ? IX__TRI_ARC
                                               : IX__TRI_UNDECIDED;
}

bool ix__tri_is_tube(const ix__tri_task *k, const ix__tri_linear *l)
{
    static const double reach[NV] = {1, 1, 1, 1, 1, 1, 1, 1, 1};

    if (l->inv.free < 0)
        return false;
    for (int r = 0; r < k->shape.neqs; r++)
        if (!(error_of(l, k->shape.nvars, r, reach) < 1.0))
            return false;
    return true;
}
