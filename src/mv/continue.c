/* continue.c - B-splines beyond their domain: the first and the last polynomial
 * go on. */
#include "bsp/basis.h"
#include "mv/mv.h"

/* Control points of the end's polynomial are its blossom at the new knots;
 * points that see none of these stay. */
static void end_rows(const ix_dir *dir, const double *knots, bool upper,
                     ix_rows *rows)
{
    int o = dir->order, last = dir->length - o;

    for (int i = 0; i < dir->length; i++) {
        double *w = rows->w + (size_t)i * (size_t)o;

        rows->first[i] = i < last ? i : last;
        for (int q = 0; q < o; q++)
            w[q] = rows->first[i] + q == i;
        if (upper ? i <= last : i >= o - 1)
            continue;
        rows->first[i] = upper ? last : 0;
        ix__basis_blossom(dir, rows->first[i], knots + i + 1, w);
    }
    ix__rows_weigh(rows);
}

static ix_status move_end(ix_ctx *ctx, const ix_mv *m, int dir, double t,
                          bool upper, ix_mv **out)
{
    ix_dir nd = m->dirs[dir];
    double *knots;
    ix_rows rows;

    IX_SCRATCH(ctx, knots, nd.length + nd.order);
    for (int i = 0; i < nd.length + nd.order; i++)
        knots[i] = (upper ? i >= nd.length : i < nd.order) ? t : nd.knots[i];
    IX_TRY(ix__rows_alloc(ctx, nd.length, nd.order, &rows));
    end_rows(m->dirs + dir, knots, upper, &rows);
    nd.knots = knots;
    return ix__mv_map(ctx, m, dir, &rows, &nd, out);
}

static ix_status both_ends(ix_ctx *ctx, const ix_mv *m, int dir,
                           const double to[2], ix_mv **out)
{
    ix_mv *cur = ix_mv_ref(m), *next = NULL;

    for (int e = 0; e < 2; e++) {
        double dom[2];

        ix_mv_domain(cur, dir, dom);
        if (e == 0 ? to[0] >= dom[0] : to[1] <= dom[1])
            continue;
        IX_TRY(ix__mv_step(ctx, &cur, &next,
                           move_end(ctx, cur, dir, to[e], e == 1, &next)));
    }
    *out = cur;
    return IX_OK;
}

ix_status ix__mv_continue(ix_ctx *ctx, const ix_mv *m, int dir,
                          const double to[2], ix_mv **out)
{
    *out = NULL;
    IX_RETURN_SCOPED(ctx, both_ends(ctx, m, dir, to, out));
}
