/* systest.h - systems given as text, solved and held against Newton from many
 * starts; for the tests of ix_solve. */
#ifndef SYSTEST_H
#define SYSTEST_H

#include "solvetest.h"

typedef struct {
    const char *name;
    int n, neq;
    const char *eq[6];
    double lo, hi; /* of every variable */
    int certified, open;
} sys_case;

static inline void to_box(double (*box)[2], int n, const double *t, double *x)
{
    for (int j = 0; j < n; j++)
        x[j] = box[j][0] + t[j] * (box[j][1] - box[j][0]);
}

static inline ix_solutions solve_text(ix_ctx *ctx, int n, int neq,
                                      const char *const *text, double (*box)[2],
                                      const ix_relation *rel,
                                      const ix_solve_opts *o)
{
    ix_equation eq[6] = {{NULL, 0, IX_EQUAL_ZERO}};
    ix_mv *m[6];
    ix_solutions s;

    for (int i = 0; i < neq; i++) {
        m[i] = st_mv(ctx, text[i], n, box);
        eq[i] = (ix_equation){m[i], 0, rel ? rel[i] : IX_EQUAL_ZERO};
    }
    ASSERT_OK(ctx, ix_solve(ctx, neq, eq, o, &s));
    for (int i = 0; i < neq; i++)
        ix_mv_unref(ctx, m[i]);
    return s;
}

static inline void fill(double (*box)[2], double lo, double hi)
{
    for (int j = 0; j < 6; j++) {
        box[j][0] = lo;
        box[j][1] = hi;
    }
}

static inline int count_certified(const ix_solutions *s)
{
    int n = 0;

    for (int i = 0; i < s->n; i++)
        n += s->sol[i].certified;
    return n;
}

/* Law: every certified solution annuls the text itself; no two share a box.
 * Returns how many were verified. */
static inline long check_roots(const char *name, int n, int neq,
                               const char *const *text, double (*box)[2],
                               const ix_solutions *s)
{
    long verified = 0;

    for (int i = 0; i < s->n; i++) {
        double x[6];

        to_box(box, n, s->sol[i].x, x);
        for (int k = 0; k < neq && s->sol[i].certified; k++)
            if (!(fabs(st_value(text[k], x)) <=
                  1e-12 * st_size(text[k], box, n)))
                fail_msg("%s: solution %d: equation %d is %g", name, i, k,
                         st_value(text[k], x));
        for (int k = 0; k < i; k++) {
            int apart = 0;

            for (int j = 0; j < n; j++)
                apart |= s->sol[i].lo[j] > s->sol[k].hi[j] ||
                         s->sol[k].lo[j] > s->sol[i].hi[j];
            if (!apart)
                fail_msg("%s: solutions %d and %d overlap", name, k, i);
        }
        verified += s->sol[i].certified;
    }
    return verified;
}

/* Law: every root that Newton finds from anywhere is among the solutions. */
static inline void check_complete(ix_rng *rng, const char *name, int n,
                                  const char *const *text, double (*box)[2],
                                  const ix_solutions *s, int starts)
{
    for (int k = 0; k < starts; k++) {
        double x[6];
        int hit = 0;

        for (int j = 0; j < n; j++)
            x[j] = ix_rng_range(rng, box[j][0], box[j][1]);
        if (!st_newton(n, text, box, x))
            continue;
        for (int i = 0; i < s->n && !hit; i++) {
            hit = 1;
            for (int j = 0; j < n; j++) {
                double len = box[j][1] - box[j][0];
                double t = (x[j] - box[j][0]) / len;

                hit &= t >= s->sol[i].lo[j] - 1e-6 &&
                       t <= s->sol[i].hi[j] + 1e-6;
            }
        }
        if (!hit)
            fail_msg("%s: lost (%.17g, %.17g, ...)", name, x[0], x[1]);
    }
}

static inline long run_case(ix_ctx *ctx, ix_rng *rng, const sys_case *c,
                            int starts)
{
    double box[6][2];
    ix_solutions s;
    long verified;

    fill(box, c->lo, c->hi);
    s = solve_text(ctx, c->n, c->neq, c->eq, box, NULL, NULL);
    print_message("# %s: %zu boxes, %d certified, %d open\n", c->name, s.boxes,
                  count_certified(&s), s.n - count_certified(&s));
    verified = check_roots(c->name, c->n, c->neq, c->eq, box, &s);
    if (c->n == c->neq)
        check_complete(rng, c->name, c->n, c->eq, box, &s, starts);
    if (count_certified(&s) != c->certified ||
        s.n - count_certified(&s) != c->open)
        fail_msg("%s: %d certified and %d open, expected %d and %d", c->name,
                 count_certified(&s), s.n - count_certified(&s), c->certified,
                 c->open);
    assert_true(s.complete);
    ix_solutions_free(ctx, &s);
    return verified;
}

#endif
