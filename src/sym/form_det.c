/* form_det.c - forms as vectors: dot, cross, determinants and minors. Each is
 * a bilinear map; minors go row by row of the matrix over all sets of columns,
 * each from the minors one smaller, so that none is computed twice. */
#include "sym/form_impl.h"

ix_status ix__form_dot(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                       ix_form *out)
{
    ix_form_term *t;

    IX_SCRATCH(ctx, t, a->nrows);
    for (int i = 0; i < a->nrows; i++)
        t[i] = (ix_form_term){0, i, i, 1};
    return ix__form_bilinear(ctx, a, b, 1, a->nrows, t, out);
}

ix_status ix__form_cross(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                         ix_form *out)
{
    static const ix_form_term t[6] = {{0, 1, 2, 1}, {0, 2, 1, -1},
                                      {1, 2, 0, 1}, {1, 0, 2, -1},
                                      {2, 0, 1, 1}, {2, 1, 0, -1}};

    if (a->nrows < 3) /* rows 0 and 1 are empty sums */
        return ix__form_bilinear(ctx, a, b, 3, 2, t + 4, out);
    return ix__form_bilinear(ctx, a, b, 3, 6, t, out);
}

ix_status ix__form_bracket(ix_ctx *ctx, const ix_form *const a[2],
                           const ix_form *const b[2], ix_form *out)
{
    IX_TRY(ix__form_mul(ctx, a[0], b[1], out));
    return ix__form_mul_add(ctx, a[1], -1, b[0], out);
}

/* --- minors --------------------------------------------------------------- */

/* Minors of the first rows of a matrix: one row of f for each set of columns,
 * given as bits; index tells which. */
typedef struct {
    int cols, size; /* of the matrix; columns in a set */
    int *index;     /* [2^cols] */
    ix_form f;
} minor_level;

/* The sets of n columns in lexicographic order of their lists. */
static int list_sets(int cols, int n, unsigned *sets)
{
    int list[IX_MAX_COORDS + 1], count = 0, i;

    for (i = 0; i < n; i++)
        list[i] = i;
    for (;;) {
        sets[count] = 0;
        for (i = 0; i < n; i++)
            sets[count] |= 1u << list[i];
        count++;
        for (i = n - 1; i >= 0 && list[i] == cols - n + i; i--)
            ;
        if (i < 0)
            return count;
        for (int v = list[i] + 1; i < n; i++)
            list[i] = v++;
    }
}

/* One row more: minors on the given sets, each expanded along the new row,
 * whose last column counts plus; sign multiplies all of set i. */
static ix_status add_row(ix_ctx *ctx, minor_level *m, const ix_form *row,
                         int nsets, const unsigned *sets, const int *sign)
{
    int n = 0, size = m->size + 1;
    ix_form_term *t;

    IX_SCRATCH(ctx, t, (size_t)nsets * (size_t)size);
    for (int i = 0; i < nsets; i++) {
        int s = sign ? sign[i] : 1;

        for (int c = m->cols - 1; c >= 0; c--) {
            if (!(sets[i] >> c & 1u))
                continue;
            t[n++] = (ix_form_term){i, m->index[sets[i] & ~(1u << c)], c, s};
            s = -s;
        }
    }
    for (int i = 0; i < nsets; i++)
        m->index[sets[i]] = i;
    m->size = size;
    return ix__form_bilinear(ctx, &m->f, row, nsets, n, t, &m->f);
}

/* All minors of the first n rows. */
static ix_status all_minors(ix_ctx *ctx, int n, const ix_form *const *m,
                            minor_level *out)
{
    int cols = m[0]->nrows;
    unsigned *sets;

    *out = (minor_level){.cols = cols, .size = 1, .f = *m[0]};
    IX_SCRATCH(ctx, out->index, (size_t)1 << cols);
    IX_SCRATCH(ctx, sets, (size_t)1 << cols);
    for (int c = 0; c < cols; c++)
        out->index[1u << c] = c;
    for (int k = 2; k <= n; k++)
        IX_TRY(
            add_row(ctx, out, m[k - 1], list_sets(cols, k, sets), sets, NULL));
    return IX_OK;
}

ix_status ix__form_all_minors(ix_ctx *ctx, int n, const ix_form *const *m,
                              ix_form *out)
{
    minor_level level;

    IX_TRY(all_minors(ctx, n, m, &level));
    *out = level.f;
    return IX_OK;
}

ix_status ix__form_det(ix_ctx *ctx, int n, const ix_form *const *m,
                       ix_form *out)
{
    return ix__form_all_minors(ctx, n, m, out);
}

ix_status ix__form_minors(ix_ctx *ctx, int n, const ix_form *const *m,
                          ix_form *out)
{
    static const ix_form_term swap[2] = {{0, 1, 0, 1}, {1, 0, 0, -1}};
    unsigned sets[IX_MAX_COORDS];
    int sign[IX_MAX_COORDS];
    double one = 1.0;
    minor_level level;
    ix_form unit;

    if (n == 1) {
        IX_TRY(ix__form_constant(ctx, m[0], 1, &one, &unit));
        return ix__form_bilinear(ctx, m[0], &unit, 2, 2, swap, out);
    }
    IX_TRY(all_minors(ctx, n - 1, m, &level));
    for (int j = 0; j <= n; j++) {
        sets[j] = ((1u << (n + 1)) - 1u) & ~(1u << j);
        sign[j] = j % 2 ? -1 : 1;
    }
    IX_TRY(add_row(ctx, &level, m[n - 1], n + 1, sets, sign));
    *out = level.f;
    return IX_OK;
}
