/* form_det.c - forms as vectors: dot, cross, determinants and minors. Minors
 * are built row by row of the matrix over all sets of columns, each from the
 * minors one smaller, so that none is computed twice. */
#include <string.h>

#include "sym/form_impl.h"

ix_status ix__form_dot(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                       ix_form *out)
{
    ix_form r = {0};

    for (int i = 0; i < a->nrows; i++) {
        ix_form x = ix__form_rows(a, i, 1), y = ix__form_rows(b, i, 1);

        if (i == 0)
            IX_TRY(ix__form_mul(ctx, &x, &y, &r));
        else
            IX_TRY(ix__form_mul_add(ctx, &x, 1, &y, &r));
    }
    *out = r;
    return IX_OK;
}

/* a_i b_j - a_j b_i. */
static ix_status minor2(ix_ctx *ctx, const ix_form *a, const ix_form *b, int i,
                        int j, ix_form *out)
{
    ix_form ai = ix__form_rows(a, i, 1), aj = ix__form_rows(a, j, 1);
    ix_form bi = ix__form_rows(b, i, 1), bj = ix__form_rows(b, j, 1);

    IX_TRY(ix__form_mul(ctx, &ai, &bj, out));
    return ix__form_mul_add(ctx, &aj, -1, &bi, out);
}

ix_status ix__form_cross(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                         ix_form *out)
{
    const ix_form *parts[3];
    ix_form c[3];
    double zero[2] = {0.0, 0.0};

    IX_TRY(minor2(ctx, a, b, 0, 1, &c[2]));
    if (a->nrows < 3) {
        IX_TRY(ix__form_constant(ctx, a, 2, zero, &c[0]));
        parts[0] = &c[0];
        parts[1] = &c[2];
        return ix__form_join(ctx, 2, parts, out);
    }
    IX_TRY(minor2(ctx, a, b, 1, 2, &c[0]));
    IX_TRY(minor2(ctx, a, b, 2, 0, &c[1]));
    for (int i = 0; i < 3; i++)
        parts[i] = &c[i];
    return ix__form_join(ctx, 3, parts, out);
}

/* --- minors ------------------------------------------------------------------
 */

/* Minors of the first k rows are indexed by the bit set of their columns. */
typedef struct {
    int cols;
    const ix_form **minor; /* [2^cols]; NULL: not of this size */
} minor_table;

static int bits(unsigned set)
{
    return __builtin_popcount(set);
}

/* The minor on the columns of set, expanded along its last row: the entry of
 * the last column counts plus. */
static ix_status expand(ix_ctx *ctx, const minor_table *t, const ix_form *row,
                        unsigned set, ix_form *out)
{
    bool first = true;

    for (int c = t->cols - 1, sign = 1; c >= 0; c--) {
        ix_form x = ix__form_rows(row, c, 1);

        if (!(set >> c & 1u))
            continue;
        if (first)
            IX_TRY(ix__form_mul(ctx, t->minor[set & ~(1u << c)], &x, out));
        else
            IX_TRY(ix__form_mul_add(ctx, t->minor[set & ~(1u << c)], sign, &x,
                                    out));
        first = false;
        sign = -sign;
    }
    return IX_OK;
}

static ix_status minors_of_rows(ix_ctx *ctx, int n, const ix_form *const *m,
                                minor_table *t)
{
    unsigned all;

    t->cols = m[0]->nrows;
    all = 1u << t->cols;
    IX_SCRATCH_ZERO(ctx, t->minor, all);
    for (int k = 1; k <= n; k++)
        for (unsigned set = 1; set < all; set++) {
            ix_form *f;

            if (bits(set) != k)
                continue;
            IX_SCRATCH(ctx, f, 1);
            if (k == 1)
                *f = ix__form_rows(m[0], __builtin_ctz(set), 1);
            else
                IX_TRY(expand(ctx, t, m[k - 1], set, f));
            t->minor[set] = f;
        }
    return IX_OK;
}

ix_status ix__form_det(ix_ctx *ctx, int n, const ix_form *const *m,
                       ix_form *out)
{
    minor_table t;

    IX_TRY(minors_of_rows(ctx, n, m, &t));
    return ix__form_copy(ctx, t.minor[(1u << n) - 1u], out);
}

/* The next list of n increasing columns in lexicographic order. */
static bool next_set(int cols, int n, int *list)
{
    int i = n - 1;

    while (i >= 0 && list[i] == cols - n + i)
        i--;
    if (i < 0)
        return false;
    list[i]++;
    for (int k = i + 1; k < n; k++)
        list[k] = list[k - 1] + 1;
    return true;
}

ix_status ix__form_all_minors(ix_ctx *ctx, int n, const ix_form *const *m,
                              ix_form *out)
{
    int list[IX_MAX_COORDS], count = 0;
    const ix_form **parts;
    minor_table t;

    IX_TRY(minors_of_rows(ctx, n, m, &t));
    IX_SCRATCH(ctx, parts, (size_t)1 << t.cols);
    for (int i = 0; i < n; i++)
        list[i] = i;
    do {
        unsigned set = 0;

        for (int i = 0; i < n; i++)
            set |= 1u << list[i];
        parts[count++] = t.minor[set];
    } while (next_set(t.cols, n, list));
    return ix__form_join(ctx, count, parts, out);
}

ix_status ix__form_minors(ix_ctx *ctx, int n, const ix_form *const *m,
                          ix_form *out)
{
    const ix_form *parts[IX_MAX_COORDS];
    unsigned all = (1u << (n + 1)) - 1u;
    minor_table t;

    IX_TRY(minors_of_rows(ctx, n, m, &t));
    for (int j = 0; j <= n; j++)
        parts[j] = t.minor[all & ~(1u << j)];
    IX_TRY(ix__form_join(ctx, n + 1, parts, out));
    for (int j = 1; j <= n; j += 2) {
        ix_form row = ix__form_rows(out, j, 1);

        ix__form_times(&row, -1.0);
    }
    return IX_OK;
}
