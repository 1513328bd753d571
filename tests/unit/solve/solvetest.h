/* solvetest.h - equations written as text ("x^2 + y^2 - 1") on a box, for the
 * tests of the solvers: parsed once into a multivariate through the algebra,
 * and once more, by itself, into values and slopes for an independent Newton.
 */
#ifndef SOLVETEST_H
#define SOLVETEST_H

#include <stdlib.h>
#include <string.h>

#include "harness/test.h"
#include "iritx/solve.h"
#include "iritx/sym.h"

#define ST_NAMES "xyzwuv"

typedef struct {
    ix_ctx *ctx;
    int n;
    double (*box)[2]; /* variable k runs from box[k][0] to box[k][1] */
    const char *s;
} st_reader;

/* --- text to a Bezier multivariate on [0, 1]^n -----------------------------
 */

/* Order 2 in direction k, 1 elsewhere; k < 0: the constant a. */
static ix_mv *st_linear(st_reader *p, int k, double a, double b)
{
    ix_dir d[IX_MAX_UNKNOWNS];
    double pts[2] = {a, b};
    ix_mv *m;

    for (int j = 0; j < p->n; j++)
        d[j] = (ix_dir){.basis = IX_BEZIER,
                        .order = j == k ? 2 : 1,
                        .length = j == k ? 2 : 1};
    ASSERT_OK(p->ctx, ix_mv_new(p->ctx, p->n, d, 1, false, pts, &m));
    return m;
}

/* a and b are consumed. */
static ix_mv *st_binary(st_reader *p, char op, ix_mv *a, ix_mv *b)
{
    ix_mv *m = NULL;

    if (op == '*')
        ASSERT_OK(p->ctx, ix_sym_mul(p->ctx, a, b, NULL, &m));
    else if (op == '+')
        ASSERT_OK(p->ctx, ix_sym_add(p->ctx, a, b, NULL, &m));
    else
        ASSERT_OK(p->ctx, ix_sym_sub(p->ctx, a, b, NULL, &m));
    ix_mv_unref(p->ctx, a);
    ix_mv_unref(p->ctx, b);
    return m;
}

static ix_mv *st_sum(st_reader *p);

static void st_blank(st_reader *p)
{
    while (*p->s == ' ')
        p->s++;
}

static ix_mv *st_atom(st_reader *p)
{
    const char *at;
    ix_mv *m;

    st_blank(p);
    at = strchr(ST_NAMES, *p->s);
    if (*p->s == '(') {
        p->s++;
        m = st_sum(p);
        st_blank(p);
        p->s++;
    } else if (*p->s && at) {
        int k = (int)(at - ST_NAMES);

        p->s++;
        m = st_linear(p, k, p->box[k][0], p->box[k][1]);
    } else {
        char *end;
        double v = strtod(p->s, &end);

        assert_true(end > p->s);
        p->s = end;
        m = st_linear(p, -1, v, 0);
    }
    return m;
}

static ix_mv *st_power(st_reader *p)
{
    ix_mv *m = st_atom(p), *base;

    st_blank(p);
    if (*p->s != '^')
        return m;
    p->s++;
    base = ix_mv_ref(m);
    for (int e = (int)strtol(p->s, (char **)(void *)&p->s, 10); e > 1; e--)
        m = st_binary(p, '*', m, ix_mv_ref(base));
    ix_mv_unref(p->ctx, base);
    return m;
}

static ix_mv *st_term(st_reader *p)
{
    ix_mv *m = st_power(p);

    for (st_blank(p); *p->s == '*'; st_blank(p)) {
        p->s++;
        m = st_binary(p, '*', m, st_power(p));
    }
    return m;
}

static ix_mv *st_sum(st_reader *p)
{
    ix_mv *m;

    st_blank(p);
    if (*p->s == '-') {
        p->s++;
        m = st_binary(p, '-', st_linear(p, -1, 0, 0), st_term(p));
    } else {
        m = st_term(p);
    }
    for (st_blank(p); *p->s == '+' || *p->s == '-'; st_blank(p)) {
        char op = *p->s++;

        m = st_binary(p, op, m, st_term(p));
    }
    return m;
}

static ix_mv *st_mv(ix_ctx *ctx, const char *text, int n, double (*box)[2])
{
    st_reader p = {ctx, n, box, text};
    ix_mv *m = st_sum(&p);

    if (*p.s)
        fail_msg("cannot read %s at %s", text, p.s);
    return m;
}

/* --- text to a number --------------------------------------------------------
 */

static double st_vsum(const char **s, const double *x);

static double st_vatom(const char **s, const double *x)
{
    const char *at;
    double v;

    while (**s == ' ')
        (*s)++;
    at = strchr(ST_NAMES, **s);
    if (**s == '(') {
        (*s)++;
        v = st_vsum(s, x);
        while (**s != ')')
            (*s)++;
        (*s)++;
        return v;
    }
    if (at) {
        (*s)++;
        return x[at - ST_NAMES];
    }
    return strtod(*s, (char **)(void *)s);
}

static double st_vterm(const char **s, const double *x)
{
    double v = 1;

    for (;;) {
        double f = st_vatom(s, x), g = f;

        while (**s == ' ')
            (*s)++;
        if (**s == '^') {
            (*s)++;
            for (long e = strtol(*s, (char **)(void *)s, 10); e > 1; e--)
                g *= f;
        }
        v *= g;
        while (**s == ' ')
            (*s)++;
        if (**s != '*')
            return v;
        (*s)++;
    }
}

static double st_vsum(const char **s, const double *x)
{
    double v = 0, sign = 1;

    while (**s == ' ')
        (*s)++;
    if (**s == '-') {
        sign = -1;
        (*s)++;
    }
    for (;;) {
        v += sign * st_vterm(s, x);
        while (**s == ' ')
            (*s)++;
        if (**s != '+' && **s != '-')
            return v;
        sign = *(*s)++ == '+' ? 1 : -1;
    }
}

static double st_value(const char *text, const double *x)
{
    return st_vsum(&text, x);
}

/* The size of the text at the corners of the box, where it is largest. */
static inline double st_size(const char *text, double (*box)[2], int n)
{
    double size = 1;

    for (int k = 0; k < 1 << n; k++) {
        double x[6];

        for (int j = 0; j < n; j++)
            x[j] = box[j][k >> j & 1];
        size = fmax(size, fabs(st_value(text, x)));
    }
    return size;
}

/* --- Newton from many starts: the independent truth ------------------------
 */

/* Solves a small dense system by elimination with row pivoting. */
static int st_linsolve(int n, double a[6][7])
{
    for (int c = 0; c < n; c++) {
        int best = c;

        for (int i = c + 1; i < n; i++)
            if (fabs(a[i][c]) > fabs(a[best][c]))
                best = i;
        if (!(fabs(a[best][c]) > 1e-13))
            return 0;
        for (int j = 0; j <= n; j++) {
            double t = a[c][j];

            a[c][j] = a[best][j];
            a[best][j] = t;
        }
        for (int i = 0; i < n; i++) {
            double f = a[i][c] / a[c][c];

            for (int j = c; i != c && j <= n; j++)
                a[i][j] -= f * a[c][j];
        }
    }
    for (int i = 0; i < n; i++)
        a[i][n] /= a[i][i];
    return 1;
}

/* True if Newton from x converges to a regular root inside the box. */
static inline int st_newton(int n, const char *const *eq, double (*box)[2],
                            double *x)
{
    double size = 1;

    for (int it = 0; it < 60 && size > 1e-13; it++) {
        double a[6][7];

        for (int i = 0; i < n; i++) {
            a[i][n] = st_value(eq[i], x);
            for (int j = 0; j < n; j++) {
                double h = 1e-6 * (box[j][1] - box[j][0]), keep = x[j], f;

                x[j] = keep + h;
                f = st_value(eq[i], x);
                x[j] = keep - h;
                a[i][j] = (f - st_value(eq[i], x)) / (2 * h);
                x[j] = keep;
            }
        }
        if (!st_linsolve(n, a))
            return 0;
        size = 0;
        for (int j = 0; j < n; j++) {
            x[j] -= a[j][n];
            size = fmax(size, fabs(a[j][n]) / (box[j][1] - box[j][0]));
        }
        if (!(size < 10))
            return 0;
    }
    for (int j = 0; j < n; j++)
        if (!(x[j] >= box[j][0] && x[j] <= box[j][1]))
            return 0;
    return size <= 1e-9;
}

#endif
