/* degrees.c - degrees, control points, residual and time of an operator's
 * result in one of its forms. */
#define _POSIX_C_SOURCE 200809L
#include "ops/degrees.h"

#include <limits.h>
#include <math.h>
#include <string.h>
#include <strings.h>
#include <time.h>

#include "base/ctx.h"

const char *ix__form_name(int form)
{
    static const char *const names[IX__NFORMS] = {"minimal", "published",
                                                  "naive", "irit", "reduced"};

    return form >= 0 && form < IX__NFORMS ? names[form] : "?";
}

static bool fits(const ix_op *op, int nmvs, const ix_mv *const *mv)
{
    for (int i = 0; i < IX_OP_MAX_MVS; i++)
        if (op->ndirs[i] != (i < nmvs ? ix_mv_ndirs(mv[i]) : 0))
            return false;
    return nmvs <= IX_OP_MAX_MVS;
}

const ix_op *ix__op_for(const char *name, int nmvs, const ix_mv *const *mv)
{
    for (const ix_op *op = ix__ops; op->name; op++)
        if (strcasecmp(op->name, name) == 0 && fits(op, nmvs, mv))
            return op;
    return NULL;
}

void ix__op_defaults(const ix_op *op, double *num)
{
    static const double range[2] = {0, 1}, mirror[4] = {0, 0, 0, 2};

    memset(num, 0, IX_OP_MAX_NUMS * sizeof *num);
    if (op->nnums == 2) /* rulings */
        memcpy(num, range, sizeof range);
    if (op->nnums == 4) /* a point and a factor */
        memcpy(num, mirror, sizeof mirror);
}

bool ix__op_has_form(const ix_op *op, int form)
{
    return form == IX__FORM_REDUCED || (op->forms >> form & 1u);
}

static double now(void)
{
    struct timespec t = {0, 0};

    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* *m, a result of the minimal form, reduced. */
static ix_status reduce(ix_ctx *ctx, ix_mv **m, double *change)
{
    ix_reduce_report rep = {.change = 0.0};
    ix_mv *less = NULL;
    ix_status st = ix_sym_reduce(ctx, *m, 0.0, &rep, &less);

    ix_mv_unref(ctx, *m);
    *m = less;
    *change = rep.change;
    return st;
}

static void describe(const ix_mv *m, ix_degree_row *out)
{
    out->ndirs = ix_mv_ndirs(m);
    out->npts = ix_mv_npts(m);
    for (int i = 0; i < out->ndirs; i++) {
        out->degree[i] = ix_mv_order(m, i) - 1;
        out->length[i] = ix_mv_length(m, i);
    }
}

ix_status ix__degree_row(ix_ctx *ctx, const ix_op *op, const ix_op_args *a,
                         int form, ix_degree_row *out)
{
    bool reduced = form == IX__FORM_REDUCED;
    ix_op_opts o = {reduced ? IX_FORM_MINIMAL : (ix_degree_form)form, INT_MAX};
    ix_report rep = {.residual = NAN};
    double begin = now(), change = 0.0;
    ix_mv *m;

    *out = (ix_degree_row){.residual = NAN};
    IX_TRY(op->run(ctx, a, &o, NULL, &m)); /* timed without the report */
    if (reduced)
        IX_TRY(reduce(ctx, &m, &change));
    out->seconds = now() - begin;
    describe(m, out);
    ix_mv_unref(ctx, m);
    IX_TRY(op->run(ctx, a, &o, &rep, &m));
    ix_mv_unref(ctx, m);
    out->residual = rep.residual + change;
    return IX_OK;
}
