/* tessellate.c - triangles and polylines from the grid of samples. Only points
 * that are used are kept. */
#include <math.h>
#include <string.h>

#include "mv/tess_impl.h"

/* --- surfaces ----------------------------------------------------------- */

static bool same_point(const double *a, const double *b)
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

bool ix__tess_degenerate(const double *xyz, const uint32_t *t)
{
    const double *a = xyz + 3 * (size_t)t[0], *b = xyz + 3 * (size_t)t[1];
    const double *c = xyz + 3 * (size_t)t[2];

    return same_point(a, b) || same_point(b, c) || same_point(c, a);
}

static double distance2(const double *a, const double *b)
{
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];

    return x * x + y * y + z * z;
}

size_t ix__tess_cut_cell(const double *xyz, const uint32_t k[4],
                         uint32_t (*t)[3])
{
    /* corners: 0 low, 1 right, 2 high, 3 left */
    static const int by[2][2][3] = {{{0, 1, 2}, {0, 2, 3}},
                                    {{0, 1, 3}, {1, 2, 3}}};
    bool other = distance2(xyz + 3 * (size_t)k[1], xyz + 3 * (size_t)k[3]) <
                 distance2(xyz + 3 * (size_t)k[0], xyz + 3 * (size_t)k[2]);
    size_t n = 0;

    for (int i = 0; i < 2; i++) {
        for (int c = 0; c < 3; c++)
            t[n][c] = k[by[other][i][c]];
        n += !ix__tess_degenerate(xyz, t[n]);
    }
    return n;
}

static ix_status all_triangles(ix_ctx *ctx, const ix__tess_grid *g,
                               uint32_t (**tri)[3], size_t *ntris)
{
    uint32_t n0 = (uint32_t)g->d[0].nsamples;
    uint32_t n1 = (uint32_t)g->d[1].nsamples;
    size_t cells = (size_t)(n0 - 1) * (n1 - 1), k = 0;

    *ntris = 0;
    *tri = ix__scratch(ctx, 2 * cells, sizeof **tri);
    if (!*tri)
        return IX_ENOMEM;
    for (uint32_t j = 0; j + 1 < n1; j++)
        for (uint32_t i = 0; i + 1 < n0; i++, k++) {
            uint32_t low = j * n0 + i;
            const uint32_t corner[4] = {low, low + 1, low + n0 + 1, low + n0};

            if (g->cell[k])
                *ntris += ix__tess_cut_cell(g->xyz, corner, *tri + *ntris);
        }
    return IX_OK;
}

/* The result: vertices that are used, in their order. */
ix_status ix__mesh_pack(ix_ctx *ctx, size_t nverts, const double *xyz,
                        const double *uv, size_t ntris,
                        const uint32_t (*tri)[3], ix__mesh *out)
{
    uint32_t *place;
    size_t n = 0;

    IX_SCRATCH_ZERO(ctx, place, nverts);
    for (size_t i = 0; i < ntris; i++)
        for (int c = 0; c < 3; c++)
            place[tri[i][c]] = 1;
    for (size_t i = 0; i < nverts; i++)
        n += place[i];
    *out = (ix__mesh){.nverts = n, .ntris = ntris};
    if (ntris == 0)
        return IX_OK;
    out->vbytes = 5 * n * sizeof *out->xyz;
    out->xyz = ix__alloc(ctx, out->vbytes);
    if (!out->xyz)
        return IX_ENOMEM;
    out->tbytes = ntris * sizeof *out->tri;
    out->tri = ix__alloc(ctx, out->tbytes);
    if (!out->tri) {
        ix__free(ctx, out->xyz, out->vbytes);
        *out = (ix__mesh){0};
        return IX_ENOMEM;
    }
    out->uv = out->xyz + 3 * n;
    n = 0;
    for (size_t i = 0; i < nverts; i++)
        if (place[i]) {
            memcpy(out->xyz + 3 * n, xyz + 3 * i, 3 * sizeof *xyz);
            memcpy(out->uv + 2 * n, uv + 2 * i, 2 * sizeof *uv);
            place[i] = (uint32_t)n++;
        }
    for (size_t i = 0; i < ntris; i++)
        for (int c = 0; c < 3; c++)
            out->tri[i][c] = place[tri[i][c]];
    return IX_OK;
}

void ix__tess_put_uv(const ix__tess_grid *g, double *uv)
{
    for (int j = 0; j < g->d[1].nsamples; j++)
        for (int i = 0; i < g->d[0].nsamples; i++) {
            *uv++ = g->d[0].t[i];
            *uv++ = g->d[1].t[j];
        }
}

void ix__tess_note(ix_ctx *ctx, size_t nleft)
{
    if (nleft > 0)
        ix__note(ctx,
                 "the weight changes sign or vanishes: what is near the poles "
                 "is left out");
}

static ix_status mesh_of_grid(ix_ctx *ctx, const ix__tess_grid *g,
                              ix__mesh *out)
{
    uint32_t(*tri)[3];
    size_t ntris;
    double *uv;

    IX_TRY(all_triangles(ctx, g, &tri, &ntris));
    IX_SCRATCH(ctx, uv, 2 * g->nverts);
    ix__tess_put_uv(g, uv);
    IX_TRY(ix__mesh_pack(ctx, g->nverts, g->xyz, uv, ntris,
                         (const uint32_t(*)[3])tri, out));
    out->nleft = g->nleft;
    ix__tess_note(ctx, g->nleft);
    return IX_OK;
}

ix_status ix__mesh_of_grid(ix_ctx *ctx, const ix__tess_grid *g, ix__mesh *out)
{
    *out = (ix__mesh){0};
    IX_RETURN_SCOPED(ctx, mesh_of_grid(ctx, g, out));
}

ix_status ix__mesh_grid(ix_ctx *ctx, const ix_mv *srf, double tol,
                        ix__tess_grid **out)
{
    if (srf->ndirs != 2)
        return IX_FAIL(ctx, IX_EARG, "%d directions are not a surface",
                       srf->ndirs);
    IX_SCRATCH(ctx, *out, 1);
    return ix__tess_grid_of(ctx, srf, tol, *out);
}

ix_status ix__mesh_grid_even(ix_ctx *ctx, const ix_mv *srf, const int steps[2],
                             ix__tess_grid **out)
{
    if (srf->ndirs != 2)
        return IX_FAIL(ctx, IX_EARG, "%d directions are not a surface",
                       srf->ndirs);
    IX_SCRATCH(ctx, *out, 1);
    return ix__tess_grid_even(ctx, srf, steps, *out);
}

static ix_status mesh_of_srf(ix_ctx *ctx, const ix_mv *srf, double tol,
                             ix__mesh *out)
{
    ix__tess_grid *g;

    IX_TRY(ix__mesh_grid(ctx, srf, tol, &g));
    return mesh_of_grid(ctx, g, out);
}

ix_status ix__mesh_of_srf(ix_ctx *ctx, const ix_mv *srf, double tol,
                          ix__mesh *out)
{
    *out = (ix__mesh){0};
    IX_RETURN_SCOPED(ctx, mesh_of_srf(ctx, srf, tol, out));
}

void ix__mesh_free(ix_ctx *ctx, ix__mesh *m)
{
    ix__free(ctx, m->xyz, m->vbytes);
    ix__free(ctx, m->tri, m->tbytes);
    *m = (ix__mesh){0};
}

/* --- curves ------------------------------------------------------------- */

/* Samples that end a kept interval; a line begins where the one before is not
 * kept. */
static void count_lines(const ix__tess_grid *g, size_t *nlines, size_t *npts)
{
    bool before = false;

    *nlines = *npts = 0;
    for (int k = 0; k + 1 < g->d[0].nsamples; k++) {
        bool kept = g->cell[k];

        *nlines += kept && !before;
        *npts += kept ? (before ? 1 : 2) : 0;
        before = kept;
    }
}

ix_status ix__lines_alloc(ix_ctx *ctx, size_t nlines, size_t npts,
                          ix__lines *out)
{
    size_t bytes = 4 * npts * sizeof(double) + (nlines + 1) * sizeof(size_t);
    double *x = ix__alloc(ctx, bytes);

    if (!x)
        return IX_ENOMEM;
    *out = (ix__lines){.nlines = nlines, .npts = npts, .bytes = bytes};
    out->xyz = x;
    out->t = x + 3 * npts;
    out->start = (size_t *)(void *)(out->t + npts);
    return IX_OK;
}

static void put_lines(const ix__tess_grid *g, ix__lines *out)
{
    bool before = false;
    size_t line = 0, n = 0;

    for (int k = 0; k + 1 < g->d[0].nsamples; k++) {
        if (g->cell[k] && !before)
            out->start[line++] = n;
        for (int e = before ? 1 : 0; e < 2 && g->cell[k]; e++, n++) {
            out->t[n] = g->d[0].t[k + e];
            memcpy(out->xyz + 3 * n, g->xyz + 3 * (size_t)(k + e),
                   3 * sizeof *g->xyz);
        }
        before = g->cell[k];
    }
    out->start[line] = n;
}

/* tol, or if steps > 0 these. */
static ix_status lines_of_crv(ix_ctx *ctx, const ix_mv *crv, double tol,
                              int steps, ix__lines *out)
{
    size_t nlines, npts;
    ix__tess_grid g;

    if (steps > 0)
        IX_TRY(ix__tess_grid_even(ctx, crv, &steps, &g));
    else
        IX_TRY(ix__tess_grid_of(ctx, crv, tol, &g));
    count_lines(&g, &nlines, &npts);
    IX_TRY(ix__lines_alloc(ctx, nlines, npts, out));
    put_lines(&g, out);
    out->nleft = g.nleft;
    ix__tess_note(ctx, g.nleft);
    return IX_OK;
}

static ix_status check_curve(ix_ctx *ctx, const ix_mv *crv, ix__lines *out)
{
    *out = (ix__lines){0};
    if (crv->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG, "%d directions are not a curve",
                       crv->ndirs);
    return IX_OK;
}

ix_status ix__lines_of_crv(ix_ctx *ctx, const ix_mv *crv, double tol,
                           ix__lines *out)
{
    IX_TRY(check_curve(ctx, crv, out));
    IX_RETURN_SCOPED(ctx, lines_of_crv(ctx, crv, tol, 0, out));
}

ix_status ix__lines_even(ix_ctx *ctx, const ix_mv *crv, int steps,
                         ix__lines *out)
{
    IX_TRY(check_curve(ctx, crv, out));
    if (steps < 1)
        return IX_FAIL(ctx, IX_EARG, "%d steps", steps);
    IX_RETURN_SCOPED(ctx, lines_of_crv(ctx, crv, 1, steps, out));
}

void ix__lines_free(ix_ctx *ctx, ix__lines *l)
{
    ix__free(ctx, l->xyz, l->bytes);
    *l = (ix__lines){0};
}
