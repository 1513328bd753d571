/* srf_layers.c - surfaces from control layers: ruled, through rows, extruded,
 * Hermite. The new direction is always the last one, except that Hermite
 * surfaces carry it first. */
#include <math.h>

#include "geom/parts.h"
#include "iritx/geom_srf.h"
#include "iritx/sym.h"

/* Every direction over [0, 1]. */
static ix_status unit_domain(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    ix_mv *cur = ix_mv_ref(m);

    for (int d = 0; d < m->ndirs; d++) {
        ix_mv *next = NULL;
        ix_status st = ix_mv_reparam(ctx, cur, d, 0, 1, &next);

        ix_mv_unref(ctx, cur);
        if (st != IX_OK)
            return st;
        cur = next;
    }
    *out = cur;
    return IX_OK;
}

static ix_status ruled(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, ix_mv *t[6],
                       ix_mv **out)
{
    bool spline_a, spline_b;
    ix_dir dir;

    IX_TRY(ix__mv_plain(ctx, a, &t[0]));
    IX_TRY(ix__mv_plain(ctx, b, &t[1]));
    spline_a = ix__mv_has_basis(t[0], IX_BSPLINE);
    spline_b = ix__mv_has_basis(t[1], IX_BSPLINE);
    if (spline_a && !spline_b)
        IX_TRY(unit_domain(ctx, t[0], &t[2]));
    else
        t[2] = ix_mv_ref(t[0]);
    IX_TRY(ix_mv_compatible(ctx, t[2], t[1], IX_SAME_ALL, &t[3], &t[4]));
    dir = ix__dir_linear(!spline_a && !spline_b);
    return ix_mv_stack(ctx, 2, (const ix_mv *const[]){t[3], t[4]}, &dir, out);
}

ix_status ix_srf_ruled(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, ix_mv **out)
{
    ix_mv *t[6] = {NULL};
    ix_status st;

    *out = NULL;
    if (a->ndirs != b->ndirs || a->ndirs >= IX_MAX_DIRS)
        return IX_FAIL(ctx, IX_EARG, "%d and %d directions", a->ndirs,
                       b->ndirs);
    st = ruled(ctx, a, b, t, out);
    ix__mv_unref_all(ctx, t, 6);
    return st;
}

/* A periodic vector of uniform steps 1 / (n - order + 1), as the reference
 * makes it for surfaces through curves (curves use steps of 1 / n). */
static void periodic_knots(int order, int n, double *knots)
{
    for (int i = 0; i < n + 2 * order - 1; i++)
        knots[i] = (double)(i - order + 1) / (double)(n - order + 1);
}

static ix_status layer_dir(ix_ctx *ctx, int n, bool bezier, int order,
                           ix_kv_kind kv, ix_dir *dir)
{
    double *knots;

    *dir = (ix_dir){.basis = IX_BSPLINE,
                    .order = order,
                    .length = n,
                    .periodic = kv == IX_KV_PERIODIC};
    if (bezier && order == n && kv == IX_KV_OPEN) {
        dir->basis = IX_BEZIER;
        return IX_OK;
    }
    IX_SCRATCH(ctx, knots, ix_knots_count(dir));
    if (kv == IX_KV_PERIODIC)
        periodic_knots(order, n, knots);
    else
        IX_TRY(ix_knots_make(ctx, kv, order, n, knots));
    dir->knots = knots;
    return IX_OK;
}

/* Layers with all directions B-spline, if that is wanted, else as they are;
 * the references made are counted in *made. */
static ix_status plain_layers(ix_ctx *ctx, int n, const ix_mv *const *layers,
                              bool bspline, ix_mv **own, int *made)
{
    for (int i = 0; i < n; i++, ++*made)
        if (bspline)
            IX_TRY(ix_mv_to_bspline(ctx, layers[i], &own[i]));
        else
            IX_TRY(ix__mv_plain(ctx, layers[i], &own[i]));
    return IX_OK;
}

static ix_status stack_layers(ix_ctx *ctx, int n, const ix_mv *const *layers,
                              int order, ix_kv_kind kv, ix_mv **out)
{
    bool bezier = true;
    const ix_mv **view;
    ix_mv **own;
    ix_status st;
    int made = 0;
    ix_dir dir;

    for (int i = 0; i < n; i++)
        bezier = bezier && !ix__mv_has_basis(layers[i], IX_BSPLINE);
    IX_TRY(layer_dir(ctx, n, bezier, order, kv, &dir));
    IX_SCRATCH_ZERO(ctx, own, n);
    IX_SCRATCH(ctx, view, n);
    st = plain_layers(ctx, n, layers, dir.basis == IX_BSPLINE, own, &made);
    for (int i = 0; i < made; i++)
        view[i] = own[i];
    if (st == IX_OK)
        st = ix_mv_stack(ctx, n, view, &dir, out);
    ix__mv_unref_all(ctx, own, made);
    return st;
}

ix_status ix_srf_layers(ix_ctx *ctx, int n, const ix_mv *const *layers,
                        int order, ix_kv_kind kv, ix_mv **out)
{
    ix_status st;
    ix_mark mk;

    *out = NULL;
    if (n < 2)
        return IX_FAIL(ctx, IX_EARG, "%d layers, at least 2 are needed", n);
    if (order < 2)
        return IX_FAIL(ctx, IX_EARG, "order %d across the layers is below 2",
                       order);
    if (order > n)
        order = n;
    for (int i = 1; i < n; i++)
        if (layers[i]->ndirs != layers[0]->ndirs)
            return IX_FAIL(ctx, IX_EARG, "layer %d has %d directions, not %d",
                           i + 1, layers[i]->ndirs, layers[0]->ndirs);
    mk = ix__scratch_mark(ctx);
    st = stack_layers(ctx, n, layers, order, kv, out);
    ix__scratch_release(ctx, mk);
    return st;
}

/* Coordinates that are needed to hold m + vec. */
static int needed_coords(const ix_mv *m, const double vec[3])
{
    int n = 3;

    while (n > 0 && vec[n - 1] == 0)
        n--;
    return n > m->ncoords ? n : m->ncoords;
}

static ix_status extrude(ix_ctx *ctx, const ix_mv *m, const double vec[3],
                         ix_mv *t[3], ix_mv **out)
{
    const double mat[16] = {1, 0, 0, 0, 0,      1,      0,      0,
                            0, 0, 1, 0, vec[0], vec[1], vec[2], 1};

    IX_TRY(ix__mv_plain(ctx, m, &t[0]));
    IX_TRY(ix_mv_coerce(ctx, t[0], needed_coords(m, vec), m->rational, &t[1]));
    IX_TRY(ix_mv_transform(ctx, t[1], mat, &t[2]));
    return ix_srf_ruled(ctx, t[1], t[2], out);
}

ix_status ix_srf_extrude(ix_ctx *ctx, const ix_mv *m, const double vec[3],
                         ix_mv **out)
{
    double len = fabs(vec[0]) + fabs(vec[1]) + fabs(vec[2]);
    ix_mv *t[3] = {NULL};
    ix_status st;

    *out = NULL;
    if (!(len > 0 && isfinite(len)))
        return IX_FAIL(ctx, IX_EARG, "extrusion along (%g, %g, %g)", vec[0],
                       vec[1], vec[2]);
    st = extrude(ctx, m, vec, t, out);
    ix__mv_unref_all(ctx, t, 3);
    return st;
}

/* b + f t, domains mapped onto b's. t keeps what is made on the way. */
static ix_status offset_row(ix_ctx *ctx, const ix_mv *b, const ix_mv *tan,
                            double f, ix_mv *t[4], ix_mv **out)
{
    const double mat[16] = {f, 0, 0, 0, 0, f, 0, 0, 0, 0, f, 0, 0, 0, 0, 1};
    double dom[2];

    IX_TRY(ix__mv_plain2(ctx, b, tan, &t[0], &t[1]));
    ix_mv_domain(t[0], 0, dom);
    if (ix__mv_has_basis(t[0], IX_BSPLINE))
        IX_TRY(ix_mv_reparam(ctx, t[1], 0, dom[0], dom[1], &t[2]));
    else
        t[2] = ix_mv_ref(t[1]);
    IX_TRY(ix_mv_transform(ctx, t[2], mat, &t[3]));
    return ix_sym_add(ctx, t[0], t[3], NULL, out);
}

enum { ROW_TEMPS = 4, HERMITE_TEMPS = 4 * ROW_TEMPS + 5 };

/* The outer rows get the weights of the inner ones (b + 0 t has), so that the
 * derivative of the projected surface is 3 times the difference of rows. */
static ix_status hermite(ix_ctx *ctx, const ix_mv *const c[4],
                         ix_mv *t[HERMITE_TEMPS], ix_mv **out)
{
    static const double f[4] = {0, 1.0 / 3, -1.0 / 3, 0};
    ix_mv **row = t + 4 * ROW_TEMPS;

    for (int i = 0; i < 4; i++)
        IX_TRY(offset_row(ctx, c[i / 2], c[2 + i / 2], f[i], t + i * ROW_TEMPS,
                          &row[i]));
    IX_TRY(ix_srf_layers(ctx, 4, (const ix_mv *const *)row, 4, IX_KV_OPEN,
                         &row[4]));
    return ix_mv_swap_dirs(ctx, row[4], 0, 1, out);
}

ix_status ix_srf_hermite(ix_ctx *ctx, const ix_mv *b1, const ix_mv *b2,
                         const ix_mv *t1, const ix_mv *t2, ix_mv **out)
{
    const ix_mv *const c[4] = {b1, b2, t1, t2};
    ix_mv *t[HERMITE_TEMPS] = {NULL};
    ix_status st;

    *out = NULL;
    for (int i = 0; i < 4; i++)
        if (c[i]->ndirs != 1)
            return IX_FAIL(ctx, IX_EARG,
                           "a Hermite surface needs curves, got "
                           "%d directions",
                           c[i]->ndirs);
    st = hermite(ctx, c, t, out);
    ix__mv_unref_all(ctx, t, HERMITE_TEMPS);
    return st;
}
