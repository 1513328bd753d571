/* meet.c - intersections of two planar curves as a system in (t, r).
 *
 * The system is never built as a whole: only pairs of spans whose hulls meet
 * become patches of it, without weights sums of one function of t and one of r.
 * They are found by halving both curves, with a tree of boxes for each. */
#include <float.h>
#include <math.h>

#include "bsp/spans.h"
#include "geom/planar_spans.h"
#include "iritx/distance.h"
#include "solve/patches.h"
#include "sym/form.h"

#define MAX_BOXES                                                \
    200000 /* overlapping curves have no isolated solutions: the \
              search is stopped when it has become pointless */
#define UNIT (DBL_EPSILON / 2)

static ix_status check(ix_ctx *ctx, const ix_mv *c, int which)
{
    if (c->ndirs != 1 || c->ncoords < 2)
        return IX_FAIL(ctx, IX_EARG,
                       "curve %d has %d directions and %d coordinates; a "
                       "curve of 2 or more is wanted",
                       which, c->ndirs, c->ncoords);
    if (c->dirs[0].basis == IX_POWER)
        return IX_FAIL(ctx, IX_EARG,
                       "curve %d is in power basis: convert it to Bezier",
                       which);
    return IX_OK;
}

typedef struct {
    ix__planar_spans c[2];
    const ix__span_pair *pair; /* those whose hulls meet */
    int npairs, next;
    const ix__shape *shape; /* of the equations */
    double scale[2];        /* of the equations, powers of 2 */
    double err;             /* of their coefficients */
} meeting;

/* x_a(t) w_b(r) - x_b(r) w_a(t) on spans i and j, coordinate k. */
static void equation(const meeting *m, int k, int i, int j, double *out)
{
    const ix__planar_spans *a = &m->c[0], *b = &m->c[1];
    int na = a->sp.degree + 1, nb = b->sp.degree + 1;
    const double *xa = a->x[k] + (size_t)i * (size_t)na;
    const double *xb = b->x[k] + (size_t)j * (size_t)nb;
    const double *wa = a->w ? a->w + (size_t)i * (size_t)na : NULL;
    const double *wb = b->w ? b->w + (size_t)j * (size_t)nb : NULL;

    for (int l = 0; l < nb; l++)
        for (int n = 0; n < na; n++)
            out[n + l * na] = m->scale[k] * (xa[n] * (wb ? wb[l] : 1) -
                                             xb[l] * (wa ? wa[n] : 1));
}

/* The same of polynomial curves, as a sum. */
static void difference(const meeting *m, int k, int i, int j, double *out)
{
    const ix__planar_spans *a = &m->c[0], *b = &m->c[1];
    int na = a->sp.degree + 1, nb = b->sp.degree + 1;
    const double *xa = a->x[k] + (size_t)i * (size_t)na;
    const double *xb = b->x[k] + (size_t)j * (size_t)nb;

    for (int n = 0; n < na; n++)
        out[n] = m->scale[k] * xa[n];
    for (int n = 0; n < nb; n++)
        out[na + n] = -m->scale[k] * xb[n];
}

static void take(const meeting *m, int i, int j, ix__box *b)
{
    const ix_spans *sa = &m->c[0].sp, *sb = &m->c[1].sp;

    b->cuts = b->fresh = 0;
    b->lo[0] = sa->breaks[i];
    b->hi[0] = sa->breaks[i + 1];
    b->lo[1] = sb->breaks[j];
    b->hi[1] = sb->breaks[j + 1];
    for (int k = 0; k < 2; k++) {
        if (m->shape->sum)
            difference(m, k, i, j, b->c + (size_t)k * m->shape->size);
        else
            equation(m, k, i, j, b->c + (size_t)k * m->shape->size);
        b->err[k] = m->err;
    }
}

static bool next_pair(void *self, ix__box *b)
{
    meeting *m = self;

    if (m->next == m->npairs)
        return false;
    take(m, m->pair[m->next].i, m->pair[m->next].j, b);
    m->next++;
    return true;
}

static void pair_at(void *self, const double *x, ix__box *b)
{
    const meeting *m = self;

    take(m, ix__spans_find(&m->c[0].sp, x[0]),
         ix__spans_find(&m->c[1].sp, x[1]), b);
}

/* Scales that make the equations of size 1 at most, and what the decomposition
 * has rounded, relative to that. */
static void scale(meeting *m)
{
    const ix__planar_spans *a = &m->c[0], *b = &m->c[1];
    double steps = a->steps + b->steps;

    for (int k = 0; k < 2; k++) {
        int e;

        (void)frexp(a->size[k] * b->wsize + b->size[k] * a->wsize, &e);
        m->scale[k] = ldexp(1, e < -1020 ? 1020 : -e);
    }
    m->err = steps * UNIT + DBL_MIN;
}

static ix_status crv_crv_meet(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                              const ix_solve_opts *o, ix_solutions *out)
{
    const ix_solve_opts own = {.max_boxes = MAX_BOXES};
    ix__patch_source src = {
        .n = 2, .neq = 2, .nall = 2, .next = next_pair, .at = pair_at};
    const ix_mv *const c[2] = {a, b};
    meeting m = {.shape = &src.shape};
    int dims[2];

    IX_TRY(ix__planar_spans_of(ctx, c, m.c));
    IX_TRY(ix__span_pairs(ctx, &m.c[0], &m.c[1], &m.pair, &m.npairs));
    scale(&m);
    for (int k = 0; k < 2; k++) {
        const ix_spans *sp = &m.c[k].sp;

        dims[k] = sp->degree + 1;
        src.edge[k] = sp->breaks[sp->nspans] - sp->breaks[0];
    }
    if (m.c[0].w || m.c[1].w)
        ix__shape_init(&src.shape, 2, dims);
    else
        ix__shape_init_sum(&src.shape, 2, dims);
    src.self = &m;
    return ix__solve_patches(ctx, &src, o ? o : &own, out);
}

ix_status ix_crv_crv_meet(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                          const ix_solve_opts *o, ix_solutions *out)
{
    *out = (ix_solutions){.n = 0};
    IX_TRY(check(ctx, a, 1));
    IX_TRY(check(ctx, b, 2));
    IX_RETURN_SCOPED(ctx, crv_crv_meet(ctx, a, b, o, out));
}
