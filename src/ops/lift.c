/* lift.c - lifts of curves, and the minors of a lift and its derivative. */
#include "ops/lift.h"

ix_status ix__lift(ix_ctx *ctx, const ix_form *f, bool rational, ix_form *out)
{
    static const double one = 1.0;
    int m = f->nrows - (rational ? 1 : 0);
    ix_form p = ix__form_rows(f, rational ? 1 : 0, m), w, parts[3];
    const ix_form *list[3] = {&parts[0], &parts[1], &parts[2]};

    if (rational)
        w = ix__form_rows(f, 0, 1);
    else
        IX_TRY(ix__form_constant(ctx, f, 1, &one, &w));
    IX_TRY(ix__form_mul(ctx, &p, &w, &parts[0]));
    IX_TRY(ix__form_mul(ctx, &w, &w, &parts[1]));
    IX_TRY(ix__form_dot(ctx, &p, &p, &parts[2]));
    return ix__form_join(ctx, 3, list, out);
}

static ix_status rational_tangents(ix_ctx *ctx, const ix_form *f, ix_form *out)
{
    ix_form lift, uv[2];
    const ix_form *rows[2] = {&uv[0], &uv[1]};

    IX_TRY(ix__lift(ctx, f, true, &lift));
    IX_TRY(ix__form_partials(ctx, &lift, 0, 1, uv));
    return ix__form_all_minors(ctx, 2, rows, out);
}

/* Minors of (p, 1, q) and (p', 0, q') with q = |p|^2, q' = 2 p.p'. */
static ix_status affine_tangents(ix_ctx *ctx, const ix_form *p, ix_form *out)
{
    ix_form q, dp, dq, cross, xz, pq, r[10];
    const ix_form *list[10];

    IX_TRY(ix__form_dot(ctx, p, p, &q));
    IX_TRY(ix__form_derive(ctx, p, 0, &dp));
    ix__form_times(&dp, ix__spans_mean(&p->dirs[0]));
    IX_TRY(ix__form_dot(ctx, p, &dp, &dq));
    ix__form_times(&dq, 2.0);
    IX_TRY(ix__form_cross(ctx, p, &dp, &cross));
    IX_TRY(ix__form_mul(ctx, p, &dq, &pq));
    IX_TRY(ix__form_mul_add(ctx, &dp, -1, &q, &pq));
    ix__form_times(&dp, -1.0); /* p 0 - 1 p' */
    for (int k = 0; k < 3; k++) {
        r[ix__lift_pair(k, 3)] = ix__form_rows(&dp, k, 1);
        r[ix__lift_pair(k, 4)] = ix__form_rows(&pq, k, 1);
    }
    r[ix__lift_pair(0, 1)] = ix__form_rows(&cross, 2, 1);
    r[ix__lift_pair(1, 2)] = ix__form_rows(&cross, 0, 1);
    xz = ix__form_rows(&cross, 1, 1);
    ix__form_times(&xz, -1.0);
    r[ix__lift_pair(0, 2)] = xz;
    r[ix__lift_pair(3, 4)] = dq;
    for (int k = 0; k < 10; k++)
        list[k] = &r[k];
    return ix__form_join(ctx, 10, list, out);
}

ix_status ix__lift_tangents(ix_ctx *ctx, const ix_form *f, bool rational,
                            ix_form *out)
{
    return rational ? rational_tangents(ctx, f, out)
                    : affine_tangents(ctx, f, out);
}
