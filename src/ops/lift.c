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

int ix__lift_minor(int i, int j, int *sign)
{
    *sign = i == 0 && j == 2 ? -1 : 1;
    if (j < 3)
        return 3 - i - j;
    return i == 3 ? 9 : (j == 3 ? 3 : 6) + i;
}

/* Minors of two rows of five columns, group by group of columns. */
static ix_status minors_of(ix_ctx *ctx, const ix_form uv[2], ix_form *out)
{
    ix_form x[2], one[2], q[2], part[4];
    const ix_form *const px[2] = {&x[0], &x[1]}, *const pq[2] = {&q[0], &q[1]};
    const ix_form *const p1[2] = {&one[0], &one[1]};
    const ix_form *list[4] = {&part[0], &part[1], &part[2], &part[3]};

    for (int i = 0; i < 2; i++) {
        x[i] = ix__form_rows(&uv[i], 0, 3);
        one[i] = ix__form_rows(&uv[i], 3, 1);
        q[i] = ix__form_rows(&uv[i], 4, 1);
    }
    IX_TRY(ix__form_cross(ctx, &x[0], &x[1], &part[0]));
    IX_TRY(ix__form_bracket(ctx, px, p1, &part[1]));
    IX_TRY(ix__form_bracket(ctx, px, pq, &part[2]));
    IX_TRY(ix__form_bracket(ctx, p1, pq, &part[3]));
    return ix__form_join(ctx, 4, list, out);
}

static ix_status rational_tangents(ix_ctx *ctx, const ix_form *f, ix_form *out)
{
    ix_form lift, uv[2];

    IX_TRY(ix__lift(ctx, f, true, &lift));
    IX_TRY(ix__form_partials(ctx, &lift, 0, 1, uv));
    return minors_of(ctx, uv, out);
}

ix_status ix__lift_formal(ix_ctx *ctx, const ix_form *f, ix_form *out)
{
    ix_form rows[2];

    IX_TRY(ix__lift(ctx, f, true, &rows[0]));
    IX_TRY(ix__form_derive(ctx, &rows[0], 0, &rows[1]));
    ix__form_times(&rows[1], ix__spans_mean(&f->dirs[0]));
    return minors_of(ctx, rows, out);
}

/* Minors of (p, 1, q) and (p', 0, q') with q = |p|^2, q' = 2 p.p'. */
static ix_status affine_tangents(ix_ctx *ctx, const ix_form *p, ix_form *out)
{
    ix_form dp, q, dq, minus, cross, pq;
    const ix_form *const pp[2] = {p, &dp}, *const qq[2] = {&q, &dq};
    const ix_form *list[4] = {&cross, &minus, &pq, &dq};

    IX_TRY(ix__form_derive(ctx, p, 0, &dp));
    ix__form_times(&dp, ix__spans_mean(&p->dirs[0]));
    IX_TRY(ix__form_dot(ctx, p, p, &q));
    IX_TRY(ix__form_dot(ctx, p, &dp, &dq));
    ix__form_times(&dq, 2.0);
    IX_TRY(ix__form_cross(ctx, p, &dp, &cross));
    IX_TRY(ix__form_bracket(ctx, pp, qq, &pq));
    IX_TRY(ix__form_copy(ctx, &dp, &minus)); /* p 0 - 1 p' */
    ix__form_times(&minus, -1.0);
    return ix__form_join(ctx, 4, list, out);
}

ix_status ix__lift_tangents(ix_ctx *ctx, const ix_form *f, bool rational,
                            ix_form *out)
{
    return rational ? rational_tangents(ctx, f, out)
                    : affine_tangents(ctx, f, out);
}

/* (x + a 1) x (q + 2 a.x + |a|^2 1) and so on, for one coefficient of each row:
 * double[10][n]. */
static void move_one(double *m, size_t n, const double a[3], double aa)
{
    double cross[3], tangent[3], along = 0.0, turned[3], one_q = m[9 * n];

    for (size_t k = 0; k < 3; k++) {
        cross[k] = m[k * n];
        tangent[k] = m[(3 + k) * n];
        along += a[k] * tangent[k];
    }
    for (size_t k = 0; k < 3; k++) {
        size_t i = (k + 1) % 3, j = (k + 2) % 3;

        /* sum of a_i x_k ^ x_i */
        turned[k] = a[i] * cross[j] - a[j] * cross[i];
        m[k * n] += a[j] * tangent[i] - a[i] * tangent[j];
    }
    for (size_t k = 0; k < 3; k++)
        m[(6 + k) * n] += 2.0 * turned[k] + aa * tangent[k] + a[k] * one_q -
                          2.0 * a[k] * along;
    m[9 * n] -= 2.0 * along;
}

void ix__lift_move(ix_form *m, const double a[3])
{
    double aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];

    for (size_t i = 0; i < m->n; i++)
        move_one(m->c + i, m->n, a, aa);
}
