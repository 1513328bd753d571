/* trisector_system.c - the equations of a trisector, their derivatives and the
 * inverse of these (trisector_impl.h). */
#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "ops/trisector_impl.h"

ix__tri_shape ix__tri_shape_of(const int ndirs[3])
{
    ix__tri_shape s = {.nvars = 3, .neqs = 2};

    for (int i = 0; i < 3; i++) {
        s.ndirs[i] = ndirs[i];
        s.at[i] = s.nvars;
        s.nvars += ndirs[i];
        s.neqs += ndirs[i];
    }
    return s;
}

/* The difference of squares as (X_j - X_0).(2 C - X_0 - X_j), without
 * cancelling squares of large numbers. */
void ix__tri_values(const ix__tri_shape *s, const double c[3],
                    const ix__tri_jet *const j[3], double f[IX__TRI_EQS])
{
    double r[3][3], e[3], sum[3];
    int n = 0;

    for (int i = 0; i < 3; i++) {
        ix__sub3(c, j[i]->x, r[i]);
        for (int a = 0; a < s->ndirs[i]; a++)
            f[n++] = ix__dot3(r[i], j[i]->t[a]);
    }
    for (int i = 1; i < 3; i++) {
        ix__sub3(j[i]->x, j[0]->x, e);
        ix__axpy3(r[0], 1.0, r[i], sum);
        f[n++] = ix__dot3(e, sum);
    }
}

void ix__tri_jacobian(const ix__tri_shape *s, const double c[3],
                      const ix__tri_jet *const j[3], ix__tri_matrix out)
{
    double r[3][3];
    int n = 0;

    memset(out, 0, sizeof(ix__tri_matrix));
    for (int i = 0; i < 3; i++) {
        ix__sub3(c, j[i]->x, r[i]);
        for (int a = 0; a < s->ndirs[i]; a++, n++) {
            memcpy(out[n], j[i]->t[a], sizeof j[i]->t[a]);
            for (int b = 0; b < s->ndirs[i]; b++)
                out[n][s->at[i] + b] = ix__dot3(r[i], j[i]->e[a][b]) -
                                       ix__dot3(j[i]->d[b], j[i]->t[a]);
        }
    }
    for (int i = 1; i < 3; i++, n++) {
        for (int k = 0; k < 3; k++)
            out[n][k] = 2.0 * (j[i]->x[k] - j[0]->x[k]);
        for (int b = 0; b < s->ndirs[0]; b++)
            out[n][s->at[0] + b] = -2.0 * ix__dot3(r[0], j[0]->d[b]);
        for (int b = 0; b < s->ndirs[i]; b++)
            out[n][s->at[i] + b] = 2.0 * ix__dot3(r[i], j[i]->d[b]);
    }
}

double ix__tri_dot_half(const double a[3], const double ha[3],
                        const double b[3], const double hb[3])
{
    double h = 0.0;

    for (int k = 0; k < 3; k++)
        h += fabs(a[k]) * hb[k] + ha[k] * (fabs(b[k]) + hb[k]);
    return h;
}

void ix__tri_jacobian_bounds(const ix__tri_shape *s, const double c[3],
                             const double half[3],
                             const ix__tri_jet *const mid[3],
                             const ix__tri_jet *const rad[3],
                             ix__tri_matrix out, ix__tri_matrix out_rad)
{
    double r[3][3], hr[3][3];
    int n = 0;

    ix__tri_jacobian(s, c, mid, out);
    memset(out_rad, 0, sizeof(ix__tri_matrix));
    for (int i = 0; i < 3; i++) {
        const ix__tri_jet *m = mid[i], *h = rad[i];

        ix__sub3(c, m->x, r[i]);
        ix__axpy3(half, 1.0, h->x, hr[i]);
        for (int a = 0; a < s->ndirs[i]; a++, n++) {
            memcpy(out_rad[n], h->t[a], sizeof h->t[a]);
            for (int b = 0; b < s->ndirs[i]; b++)
                out_rad[n][s->at[i] + b] =
                    ix__tri_dot_half(r[i], hr[i], m->e[a][b], h->e[a][b]) +
                    ix__tri_dot_half(m->d[b], h->d[b], m->t[a], h->t[a]);
        }
    }
    for (int i = 1; i < 3; i++, n++) {
        for (int k = 0; k < 3; k++)
            out_rad[n][k] = 2.0 * (rad[i]->x[k] + rad[0]->x[k]);
        for (int b = 0; b < s->ndirs[0]; b++)
            out_rad[n][s->at[0] + b] = 2.0 * ix__tri_dot_half(r[0], hr[0],
                                                              mid[0]->d[b],
                                                              rad[0]->d[b]);
        for (int b = 0; b < s->ndirs[i]; b++)
            out_rad[n][s->at[i] + b] = 2.0 * ix__tri_dot_half(r[i], hr[i],
                                                              mid[i]->d[b],
                                                              rad[i]->d[b]);
    }
}

/* --- elimination ------------------------------------------------------------
 */

/* y = M x; rows and columns exchanged one by one until the rows are unknowns
 * and the columns, but one, values. */
typedef struct {
    int m, n;
    double a[IX__TRI_EQS][IX__TRI_VARS];
    int of[IX__TRI_EQS];  /* the unknown of a row; -1: still its value */
    int is[IX__TRI_VARS]; /* the value of a column; -1: still its unknown */
    double scale[IX__TRI_EQS];
} tableau;

/* Solves row r for the unknown (or value) of column c. */
static void exchange(tableau *t, int r, int c)
{
    double f = 1.0 / t->a[r][c], *row = t->a[r];

    for (int k = 0; k < t->n; k++)
        row[k] *= k == c ? 0.0 : -f;
    for (int i = 0; i < t->m; i++) {
        double g = t->a[i][c];

        if (i == r || g == 0.0)
            continue;
        for (int k = 0; k < t->n; k++)
            t->a[i][k] += g * row[k];
        t->a[i][c] = g * f;
    }
    row[c] = f;
}

/* Rows scaled to size 1. */
static bool load(const ix__tri_shape *s, ix__tri_matrix m, tableau *t)
{
    t->m = s->neqs;
    t->n = s->nvars;
    for (int c = 0; c < t->n; c++)
        t->is[c] = -1;
    for (int r = 0; r < t->m; r++) {
        double big = 0.0;

        t->of[r] = -1;
        for (int c = 0; c < t->n; c++)
            big = fmax(big, fabs(m[r][c]));
        if (!(big > 0.0 && isfinite(big)))
            return false;
        t->scale[r] = 1.0 / big;
        for (int c = 0; c < t->n; c++)
            t->a[r][c] = m[r][c] * t->scale[r];
    }
    return true;
}

/* Of the largest pivot, 1: with less an inverse does harm. */
#define DEPENDENT 1e-10

static bool eliminate(tableau *t, int fixed)
{
    for (int step = 0; step < t->m; step++) {
        double best = DEPENDENT;
        int r = -1, c = -1;

        for (int i = 0; i < t->m; i++)
            for (int k = 0; k < t->n && t->of[i] < 0; k++)
                if (fabs(t->a[i][k]) > best && k != fixed && t->is[k] < 0) {
                    best = fabs(t->a[i][k]);
                    r = i;
                    c = k;
                }
        if (r < 0)
            return false;
        exchange(t, r, c);
        t->of[r] = c;
        t->is[c] = r;
    }
    return true;
}

/* The unknown that changes most becomes the free one, in column c. */
static void choose_free(tableau *t, int c, int *free)
{
    double most = 1.0;
    int best = -1;

    for (int r = 0; r < t->m; r++)
        if (fabs(t->a[r][c]) > most) {
            most = fabs(t->a[r][c]);
            best = r;
        }
    if (best < 0)
        return;
    exchange(t, best, c);
    *free = t->of[best];
    t->of[best] = c;
}

bool ix__tri_invert(const ix__tri_shape *s, ix__tri_matrix m, int fixed,
                    ix__tri_inverse *out)
{
    tableau t;
    int c = 0;

    if (!load(s, m, &t) || !eliminate(&t, fixed))
        return false;
    while (t.is[c] >= 0)
        c++;
    out->free = c;
    if (fixed < 0)
        choose_free(&t, c, &out->free);
    for (int r = 0; r < t.m; r++) {
        out->of[r] = t.of[r];
        out->slope[r] = -t.a[r][c];
        for (int k = 0; k < t.n; k++)
            if (t.is[k] >= 0)
                out->inv[r][t.is[k]] = t.a[r][k] * t.scale[t.is[k]];
    }
    return true;
}
