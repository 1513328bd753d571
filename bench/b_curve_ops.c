/* b_curve_ops.c - all operators on one curve, in all degree forms, for space
 * curves (CINFLECT: their projections) of degree 3 and 5, polynomial and
 * rational, with 1, 10 and 1000 spans. The time of a span should not depend on
 * their number. Forms that an operator does not have are left out. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <limits.h>
#include <math.h>

#include "ops/degrees.h"

typedef struct {
    ix_ctx *ctx;
    const ix_op *op;
    ix_op_args args;
    ix_op_opts o;
} work;

static void once(void *arg)
{
    work *w = arg;
    ix_mv *m;

    ix_bench_ok(w->ctx, w->op->run(w->ctx, &w->args, &w->o, NULL, &m));
    ix_mv_unref(w->ctx, m);
}

/* A curve with the given spans, simple knots. */
static ix_mv *make(ix_ctx *ctx, int degree, int spans, bool rational)
{
    static double kv[1100], pts[4 * 1100];
    int n = degree + spans;
    ix_dir d = {spans > 1 ? IX_BSPLINE : IX_BEZIER, degree + 1, n, false, kv};
    ix_mv *m;

    for (int i = 0; i < n + degree + 1; i++)
        kv[i] = i <= degree ? 0 : i >= n ? spans : i - degree;
    for (int i = 0; i < 4 * n; i++)
        pts[i] = i < n && rational ? 1.5 + 0.5 * sin(i) : sin(0.7 * i * i);
    ix_bench_ok(ctx, ix_mv_new(ctx, 1, &d, 3, rational, pts, &m));
    return m;
}

static void rows(work *w, int degree, int spans, bool rational)
{
    static const char *const ops[] = {
        "CINFLECT",   "CCRVTR",       "CCRVTRSQR", "CTORSION", "CTORSIONZERO",
        "CNRMLCRV",   "EVOLUTE",      "FOCALCRV",  "FOCALSRF", "TANDEVSRF",
        "NRMLSCROLL", "BINRMLSCROLL", "RECTDEVSRF"};
    ix_mv *c = make(w->ctx, degree, spans, rational);
    char name[80];

    w->args = (ix_op_args){.mv = {c}, .num = {0, 1}};
    for (size_t i = 0; i < sizeof ops / sizeof *ops; i++) {
        w->op = ix__op_find(ops[i]);
        for (int form = 0; form < 4; form++) {
            if (!ix__op_has_form(w->op, form))
                continue;
            w->o = (ix_op_opts){(ix_degree_form)form, INT_MAX};
            snprintf(name, sizeof name, "%s %s, %s degree %d, %d spans", ops[i],
                     ix__form_name(form), rational ? "rational" : "polynomial",
                     degree, spans);
            ix_bench(name, once, w, spans, "span");
        }
    }
    ix_mv_unref(w->ctx, c);
}

int main(void)
{
    static const int spans[] = {1, 10, 1000};
    work w = {.ctx = ix_ctx_new(NULL, NULL)};

    if (!w.ctx)
        return 1;
    ix_ctx_set_threads(w.ctx, 1);
    for (int d = 3; d <= 5; d += 2)
        for (int q = 0; q < 2; q++)
            for (int i = 0; i < 3; i++)
                rows(&w, d, spans[i], q);
    ix_ctx_free(w.ctx);
    return 0;
}
