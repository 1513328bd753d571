/* form_lower.c - degree lowering: factors u + v = 1 taken out of a form where
 * algebra has shown that they are there. */
#include <string.h>

#include "sym/form_impl.h"

/* c_k = q_k + q_(k-1), k = 0 .. d: q from both ends to the middle. Each sum of
 * errors is then of the size of the largest term beside it, as the binomials
 * grow towards the middle. No overlap. */
static void divide_block(const void *arg, size_t span, size_t inner,
                         const double *in, double *out)
{
    int d = *(const int *)arg, half = d / 2;
    size_t row = inner * sizeof *out;

    (void)span;
    memcpy(out, in, row);
    for (int k = 1; k < half; k++)
        for (size_t i = 0; i < inner; i++)
            out[(size_t)k * inner + i] = in[(size_t)k * inner + i] -
                                         out[(size_t)(k - 1) * inner + i];
    if (d > 1)
        memcpy(out + (size_t)(d - 1) * inner, in + (size_t)d * inner, row);
    for (int k = d - 2; k >= half && k > 0; k--)
        for (size_t i = 0; i < inner; i++)
            out[(size_t)k * inner + i] = in[(size_t)(k + 1) * inner + i] -
                                         out[(size_t)(k + 1) * inner + i];
}

static ix_status lower_once(ix_ctx *ctx, const ix_form *f, int dir,
                            ix_form *out)
{
    ix_spans sp = f->dirs[dir];
    int d = sp.degree;

    sp.degree--;
    IX_TRY(ix__form_like(ctx, f, dir, sp, out));
    ix__form_blocks(ctx, f, dir, divide_block, &d, d + 1.0, out);
    return IX_OK;
}

ix_status ix__form_lower(ix_ctx *ctx, const ix_form *f, const int *degrees,
                         ix_form *out)
{
    ix_form t = *f;

    for (int i = 0; i < f->ndirs; i++)
        while (t.dirs[i].degree > 0 && t.dirs[i].degree > degrees[i]) {
            ix_form down;

            IX_TRY(lower_once(ctx, &t, i, &down));
            t = down;
        }
    *out = t;
    return IX_OK;
}
