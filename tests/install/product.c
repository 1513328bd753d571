/* product.c - a program of a user of the library: the product of two curves,
 * and its value compared with the product of the values. */
#include <math.h>
#include <stdio.h>

#include <iritx/sym.h>

static ix_status product_at(ix_ctx *ctx, double t, double *value,
                            double *expected)
{
    const double pa[] = {1, 2, 4}, pb[] = {3, -1};
    const ix_dir quadratic = {.basis = IX_BEZIER, .order = 3, .length = 3};
    const ix_dir linear = {.basis = IX_BEZIER, .order = 2, .length = 2};
    ix_mv *a = NULL, *b = NULL, *ab = NULL;
    double va, vb;
    ix_status st = ix_mv_new(ctx, 1, &quadratic, 1, false, pa, &a);

    if (st == IX_OK)
        st = ix_mv_new(ctx, 1, &linear, 1, false, pb, &b);
    if (st == IX_OK)
        st = ix_sym_mul(ctx, a, b, NULL, &ab);
    if (st == IX_OK)
        st = ix_mv_point(ctx, a, &t, &va);
    if (st == IX_OK)
        st = ix_mv_point(ctx, b, &t, &vb);
    if (st == IX_OK)
        st = ix_mv_point(ctx, ab, &t, value);
    if (st == IX_OK)
        *expected = va * vb;
    ix_mv_unref(ctx, a);
    ix_mv_unref(ctx, b);
    ix_mv_unref(ctx, ab);
    return st;
}

int main(void)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    double value = 0, expected = 0;
    ix_status st;

    if (!ctx)
        return 1;
    st = product_at(ctx, 0.3, &value, &expected);
    if (st != IX_OK)
        fprintf(stderr, "%s: %s\n", ix_status_name(st), ix_ctx_message(ctx));
    else
        printf("iritx %s: %.15g, expected %.15g\n", ix_version(), value,
               expected);
    ix_ctx_free(ctx);
    return st == IX_OK && fabs(value - expected) <= 1e-14 ? 0 : 1;
}
