/* divide_box.c - a rectangle divided by curves: the faces of their arrangement
 * with its four sides. Works in the unit square, where tolerances in both
 * directions are one. */
#include <math.h>
#include <string.h>

#include "geom/arrange_edges.h"
#include "geom/parts.h"
#include "iritx/regions.h"

/* Points of the unit square nearer than this are one. */
#define SAME 1e-7

void ix_regions_free(ix_ctx *ctx, ix_regions *r)
{
    if (r->bytes == 0)
        return;
    ix__mv_unref_all(ctx, r->crv, r->ncrvs);
    ix__free(ctx, r->area, r->bytes);
    *r = (ix_regions){.n = 0};
}

/* One block: areas, curves, then the indices. */
static ix_status regions_new(ix_ctx *ctx, int n, int nloops, int ncrvs,
                             ix_regions *out)
{
    size_t bytes = (size_t)n * sizeof(double) +
                   (size_t)ncrvs * sizeof(ix_mv *) +
                   (size_t)(n + nloops + 2) * sizeof(int);

    *out = (ix_regions){.n = n, .nloops = nloops, .bytes = bytes};
    out->area = ix__alloc(ctx, bytes);
    if (!out->area) {
        *out = (ix_regions){.n = 0};
        return IX_ENOMEM;
    }
    memset(out->area, 0, bytes);
    out->crv = (ix_mv **)(out->area + n);
    out->first_loop = (int *)(out->crv + ncrvs);
    out->first_crv = out->first_loop + n + 1;
    return IX_OK;
}

/* --- to the unit square and back
 * ------------------------------------------------ */

static void frame(const double box[2][2], double to[16], double back[16])
{
    memset(to, 0, 16 * sizeof *to);
    memset(back, 0, 16 * sizeof *back);
    for (int k = 0; k < 2; k++) {
        double size = box[k][1] - box[k][0];

        to[5 * k] = 1 / size;
        to[12 + k] = -box[k][0] / size;
        back[5 * k] = size;
        back[12 + k] = box[k][0];
    }
    to[10] = to[15] = back[10] = back[15] = 1;
}

static ix_status move(ix_ctx *ctx, const ix_mv *c, const double mat[16],
                      ix_mv **out)
{
    ix_mv *flat;
    ix_status st;

    *out = NULL;
    if (c->ndirs != 1 || c->ncoords < 2)
        return IX_FAIL(ctx, IX_EARG,
                       "%d directions and %d coordinates; a curve (u, v) is "
                       "wanted",
                       c->ndirs, c->ncoords);
    IX_TRY(ix_mv_coerce(ctx, c, 2, c->rational, &flat));
    st = ix_mv_transform(ctx, flat, mat, out);
    ix_mv_unref(ctx, flat);
    return st;
}

/* Side k of the unit square, counter-clockwise from (0, 0). */
static ix_status side(ix_ctx *ctx, int k, ix_mv **out)
{
    static const double x[5] = {0, 1, 1, 0, 0}, y[5] = {0, 0, 1, 1, 0};
    const ix_dir dir = {.basis = IX_BEZIER, .order = 2, .length = 2};

    return ix_mv_new(ctx, 1, &dir, 2, false,
                     (const double[4]){x[k], x[k + 1], y[k], y[k + 1]}, out);
}

/* --- faces
 * ------------------------------------------------------------------------ */

static bool in_square(double x)
{
    return x >= -SAME && x <= 1 + SAME;
}

static ix_status middle_inside(ix_ctx *ctx, const ix_mv *c, bool *out)
{
    double dom[2], mid, p[2];

    ix_mv_domain(c, 0, dom);
    mid = dom[0] / 2 + dom[1] / 2;
    IX_TRY(ix_mv_point(ctx, c, &mid, p));
    *out = in_square(p[0]) && in_square(p[1]);
    return IX_OK;
}

/* Says how many parts of curves inside bound nothing. */
static ix_status tell_hanging(ix_ctx *ctx, const ix_arrangement *a)
{
    int n = 0;

    for (int e = 0; e < a->nedges; e++) {
        bool inside = false;

        if (a->edge[e].face[0] < 0)
            IX_TRY(middle_inside(ctx, a->edge[e].crv, &inside));
        n += inside;
    }
    if (n > 0)
        ix__note(ctx,
                 "%d part%s of the curves end%s inside and divide%s nothing", n,
                 n > 1 ? "s" : "", n > 1 ? "" : "s", n > 1 ? "" : "s");
    return IX_OK;
}

/* Faces are inside or outside the square as a whole: those outside have an edge
 * outside. */
static ix_status is_inside(ix_ctx *ctx, const ix_arrangement *a, int face,
                           bool *out)
{
    const ix_arr_loop *l;

    *out = face > 0;
    if (!*out)
        return IX_OK;
    l = &a->loop[a->face[face].outer];
    for (int k = 0; k < l->n && *out; k++)
        IX_TRY(middle_inside(ctx, a->edge[a->half[l->first + k] / 2].crv, out));
    return IX_OK;
}

static ix_status add_loop(ix_ctx *ctx, const ix_arrangement *a, int loop,
                          const double back[16], int *nloops, ix_regions *r)
{
    const ix_arr_loop *l = &a->loop[loop];

    for (int k = 0; k < l->n; k++) {
        int half = a->half[l->first + k];
        const ix_mv *c = a->edge[half / 2].crv;
        ix_mv *turned;
        ix_status st;

        if (half % 2)
            IX_TRY(ix_mv_reverse(ctx, c, 0, &turned));
        else
            turned = ix_mv_ref(c);
        st = ix_mv_transform(ctx, turned, back, &r->crv[r->ncrvs]);
        ix_mv_unref(ctx, turned);
        IX_TRY(st);
        r->ncrvs++;
    }
    r->first_crv[++*nloops] = r->ncrvs;
    return IX_OK;
}

static ix_status add_faces(ix_ctx *ctx, const ix_arrangement *a,
                           const bool *inside, const double back[16],
                           ix_regions *r)
{
    int n = 0, nloops = 0;

    for (int f = 0; f < a->nfaces; f++) {
        int outer = a->face[f].outer;

        if (!inside[f])
            continue;
        r->area[n] = a->face[f].area * back[0] * back[5];
        IX_TRY(add_loop(ctx, a, outer, back, &nloops, r));
        for (int l = 0; l < a->nloops; l++)
            if (a->loop[l].face == f && l != outer)
                IX_TRY(add_loop(ctx, a, l, back, &nloops, r));
        r->first_loop[++n] = nloops;
    }
    return IX_OK;
}

/* odd: only faces that an odd number of closed curves encloses. */
static ix_status take_faces(ix_ctx *ctx, const ix_arrangement *a, bool odd,
                            const double back[16], ix_regions *out)
{
    int n = 0, nloops = 0, ncrvs = 0;
    ix_status st;
    bool *inside;

    IX_SCRATCH(ctx, inside, a->nfaces);
    for (int f = 0; f < a->nfaces; f++) {
        IX_TRY(is_inside(ctx, a, f, &inside[f]));
        if (odd && a->face[f].winding % 2 == 0)
            inside[f] = false;
        n += inside[f];
    }
    for (int l = 0; l < a->nloops; l++)
        if (inside[a->loop[l].face]) {
            nloops++;
            ncrvs += a->loop[l].n;
        }
    IX_TRY(regions_new(ctx, n, nloops, ncrvs, out));
    st = add_faces(ctx, a, inside, back, out);
    if (st != IX_OK)
        ix_regions_free(ctx, out);
    return st;
}

/* --- the whole ---------------------------------------------------------- */

static ix_status arrange(ix_ctx *ctx, ix_arrangement *a, bool odd)
{
    IX_TRY(ix_arrangement_split_meetings(ctx, a, SAME));
    /* what ran together is cut where that begins and ends: copies by now */
    IX_TRY(ix_arrangement_drop_copies(ctx, a, SAME));
    IX_TRY(ix_arrangement_evaluate(ctx, a, true));
    return odd ? ix_arrangement_classify(ctx, a) : tell_hanging(ctx, a);
}

/* in[n + 4]: places for the sides of the unit square, n curves in it. */
static ix_status divide(ix_ctx *ctx, int n, ix_mv **in, bool odd,
                        const double back[16], ix_regions *out)
{
    ix_arrangement *a;
    ix_status st;

    for (int k = 0; k < 4; k++)
        IX_TRY(side(ctx, k, &in[k]));
    IX_TRY(ix_arrangement_new(ctx, 4 + n, (const ix_mv *const *)in, SAME, &a));
    st = arrange(ctx, a, odd);
    if (st == IX_OK)
        st = take_faces(ctx, a, odd, back, out);
    ix_arrangement_free(ctx, a);
    return st;
}

/* n + 4 places for curves. */
static ix_status new_curves(ix_ctx *ctx, int n, ix_mv ***in)
{
    IX_SCRATCH(ctx, *in, n + 4);
    for (int k = 0; k < n + 4; k++)
        (*in)[k] = NULL;
    return IX_OK;
}

static ix_status divide_box(ix_ctx *ctx, const double box[2][2], int n,
                            const ix_mv *const *crv, ix_regions *out)
{
    double to[16], back[16];
    ix_status st = IX_OK;
    ix_mv **in;

    frame(box, to, back);
    IX_TRY(new_curves(ctx, n, &in));
    for (int k = 0; st == IX_OK && k < n; k++)
        st = move(ctx, crv[k], to, &in[4 + k]);
    if (st == IX_OK)
        st = divide(ctx, n, in, false, back, out);
    ix__mv_unref_all(ctx, in, n + 4);
    return st;
}

static ix_status check_box(ix_ctx *ctx, const double box[2][2])
{
    for (int k = 0; k < 2; k++)
        if (!(box[k][0] < box[k][1]))
            return IX_FAIL(ctx, IX_EARG, "an empty interval [%g, %g]",
                           box[k][0], box[k][1]);
    return IX_OK;
}

ix_status ix_divide_box(ix_ctx *ctx, const double box[2][2], int n,
                        const ix_mv *const *crv, ix_regions *out)
{
    *out = (ix_regions){.n = 0};
    IX_TRY(check_box(ctx, box));
    IX_RETURN_SCOPED(ctx, divide_box(ctx, box, n, crv, out));
}

/* --- loops ---------------------------------------------------------------- */

/* *loop, a reference, is continued by next. */
static ix_status append(ix_ctx *ctx, ix_mv **loop, const ix_mv *next)
{
    ix_mv *longer = NULL;

    if (!*loop) {
        *loop = ix_mv_ref(next);
        return IX_OK;
    }
    return ix__mv_step(ctx, loop, &longer,
                       ix__crv_chain(ctx, *loop, next, &longer));
}

/* A straight line from the end to the start, if they are apart. */
static ix_status close_loop(ix_ctx *ctx, ix_mv **loop)
{
    const ix_dir dir = {.basis = IX_BEZIER, .order = 2, .length = 2};
    double dom[2], p[2], q[2];
    ix_mv *line;
    ix_status st;

    ix_mv_domain(*loop, 0, dom);
    IX_TRY(ix_mv_point(ctx, *loop, &dom[0], p));
    IX_TRY(ix_mv_point(ctx, *loop, &dom[1], q));
    if (hypot(p[0] - q[0], p[1] - q[1]) <= SAME / 2)
        return IX_OK;
    IX_TRY(ix_mv_new(ctx, 1, &dir, 2, false,
                     (const double[4]){q[0], p[0], q[1], p[1]}, &line));
    st = append(ctx, loop, line);
    ix_mv_unref(ctx, line);
    return st;
}

static ix_status make_loop(ix_ctx *ctx, int n, const ix_mv *const *crv,
                           const double to[16], ix_mv **out)
{
    for (int k = 0; k < n; k++) {
        ix_mv *moved;
        ix_status st;

        IX_TRY(move(ctx, crv[k], to, &moved));
        st = append(ctx, out, moved);
        ix_mv_unref(ctx, moved);
        IX_TRY(st);
    }
    return close_loop(ctx, out);
}

static ix_status trim_box(ix_ctx *ctx, const double box[2][2], int nloops,
                          const int *first, const ix_mv *const *crv,
                          ix_regions *out)
{
    double to[16], back[16];
    ix_status st = IX_OK;
    ix_mv **in;
    int n = 0;

    frame(box, to, back);
    IX_TRY(new_curves(ctx, nloops, &in));
    for (int k = 0; st == IX_OK && k < nloops; k++)
        if (first[k + 1] > first[k])
            st = make_loop(ctx, first[k + 1] - first[k], crv + first[k], to,
                           &in[4 + n++]);
    if (st == IX_OK)
        st = divide(ctx, n, in, true, back, out);
    ix__mv_unref_all(ctx, in, nloops + 4);
    return st;
}

ix_status ix_trim_box(ix_ctx *ctx, const double box[2][2], int nloops,
                      const int *first, const ix_mv *const *crv,
                      ix_regions *out)
{
    *out = (ix_regions){.n = 0};
    IX_TRY(check_box(ctx, box));
    IX_RETURN_SCOPED(ctx, trim_box(ctx, box, nloops, first, crv, out));
}
