/* b_mzero.c - systems of the kinds that IRIT times its MZERO with (see
 * tests/harness/mzero_suite.h for what they are and are not): called from C,
 * and MZERO from a script. Units are boxes, then calls. The lines with # hold
 * the times against IRIT's. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <string.h>

#include "harness/mzero_suite.h"
#include "iritx/solve.h"
#include "lang/interp.h"
#include "lang/poly_expr.h"
#include "object/object.h"

#define TIGHT 1e-12 /* of the domain: what an enclosure should be below */

typedef struct {
    ix_ctx *ctx;
    ix_interp *in;
    const mzero_system *d;
    ix_mv *f[3];
    ix_equation eq[3];
    size_t boxes;
    int found, tight; /* solutions, those certified to TIGHT */
    char script[64];
} work;

/* The text in A, B, C on [0, 1] for one in x, y, z on [lo, hi]. */
static void substitute(const mzero_system *d, int i, char *out, size_t size)
{
    size_t n = 0;

    for (const char *s = d->eq[i]; *s && n + 40 < size; s++) {
        if (*s < 'x' || *s > 'z')
            out[n++] = *s;
        else
            n += (size_t)snprintf(out + n, size - n, "(%.17g+%.17g*%c)", d->lo,
                                  d->hi - d->lo, 'A' + *s - 'x');
    }
    out[n] = '\0';
}

static ix_mv *add_knots(work *w, ix_mv *m)
{
    ix_mv *b;

    ix_bench_ok(w->ctx, ix_mv_to_bspline(w->ctx, m, &b));
    ix_mv_unref(w->ctx, m);
    for (int j = 0; j < w->d->n; j++) {
        double kv[8];

        for (int k = 0; k < w->d->knots; k++)
            kv[k] = (k + 1.0) / (w->d->knots + 1);
        ix_bench_ok(w->ctx,
                    ix_mv_insert_knots(w->ctx, b, j, w->d->knots, kv, &m));
        ix_mv_unref(w->ctx, b);
        b = m;
    }
    return b;
}

/* Makes the equations, for C and as the script's variables M1, M2, M3. */
static void set(work *w, const mzero_system *d)
{
    w->d = d;
    for (int i = 0; i < d->n; i++) {
        char text[2000], name[3] = {'m', (char)('1' + i), 0};
        ix_mv *power;
        ix_obj *o;

        substitute(d, i, text, sizeof text);
        ix_bench_ok(w->ctx, ix__poly_expr(w->ctx, d->n, text, &power));
        ix_bench_ok(w->ctx, ix_mv_power_to_bezier(w->ctx, power, &w->f[i]));
        ix_mv_unref(w->ctx, power);
        if (d->knots)
            w->f[i] = add_knots(w, w->f[i]);
        w->eq[i] = (ix_equation){w->f[i], 0, IX_EQUAL_ZERO};
        o = ix__obj_mv(w->ctx, IX_OBJ_MULTIVAR, ix_mv_ref(w->f[i]));
        ix_bench_ok(w->ctx, o ? ix__var_set(w->in, name, o) : IX_ENOMEM);
        ix__obj_unref(w->ctx, o);
    }
    snprintf(w->script, sizeof w->script,
             "r = mzero(list(m1, m2%s), 1e-5, "
             "1e-14);\n",
             d->n == 3 ? ", m3" : "");
}

static void clear(work *w)
{
    for (int i = 0; i < w->d->n; i++)
        ix_mv_unref(w->ctx, w->f[i]);
}

static void from_c(void *arg)
{
    work *w = arg;
    ix_solutions s;

    ix_bench_ok(w->ctx, ix_solve(w->ctx, w->d->n, w->eq, NULL, &s));
    w->boxes = s.boxes;
    w->found = s.n;
    w->tight = 0;
    for (int i = 0; i < s.n; i++) {
        double widest = 0;

        for (int j = 0; j < s.unknowns; j++)
            if (s.sol[i].hi[j] - s.sol[i].lo[j] > widest)
                widest = s.sol[i].hi[j] - s.sol[i].lo[j];
        w->tight += s.sol[i].certified && widest <= TIGHT;
    }
    ix_solutions_free(w->ctx, &s);
}

static void from_script(void *arg)
{
    work *w = arg;

    ix_bench_ok(w->ctx,
                ix__interp_run_text(w->in, "b", w->script, strlen(w->script)));
}

static int by_size(const void *a, const void *b)
{
    const double *x = a, *y = b;

    return (*x > *y) - (*x < *y);
}

/* The least and the median of IRIT's time over ours. */
static void tell(const char *what, double *ratio)
{
    qsort(ratio, MZERO_SYSTEMS, sizeof *ratio, by_size);
    printf("# %s: IRIT 11's time for its own system of the kind is %.3g to "
           "%.3g times ours, the median %.3g\n",
           what, ratio[0], ratio[MZERO_SYSTEMS - 1], ratio[MZERO_SYSTEMS / 2]);
}

int main(void)
{
    const ix_interp_opts quiet = {.quiet = true};
    double c[MZERO_SYSTEMS], script[MZERO_SYSTEMS];
    work w = {.ctx = ix_ctx_new(NULL, NULL)};

    if (!w.ctx)
        return 1;
    ix_bench_ok(w.ctx, ix__interp_new(w.ctx, &quiet, &w.in));
    for (int k = 0; k < MZERO_SYSTEMS; k++) {
        const mzero_system *d = &mzero_suite[k];
        char name[120];

        set(&w, d);
        from_c(&w);
        snprintf(name, sizeof name, "%s %s: %d found, %d proven to 1e-12",
                 d->name, d->trait, w.found, w.tight);
        c[k] = 1e3 * d->irit /
               ix_bench(name, from_c, &w, (double)w.boxes, "box");
        snprintf(name, sizeof name, "%s from a script", d->name);
        script[k] = 1e3 * d->irit / ix_bench(name, from_script, &w, 1, "call");
        clear(&w);
    }
    if (ix__interp_errors(w.in) > 0)
        return 1;
    tell("from C", c);
    tell("from a script", script);
    ix__interp_free(w.in);
    ix_ctx_free(w.ctx);
    return 0;
}
