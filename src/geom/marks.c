/* marks.c - see the header. */
#include "geom/marks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"
#include "geom/crvs.h"
#include "geom/outer_mv.h"
#include "geom/pool.h"
#include "geom/vec3.h"

ix_status ix__marks_ends(ix_ctx *ctx, const ix_mv *crv, ix__marks *out)
{
    *out = (ix__marks){.ctx = ctx, .crv = crv, .room = 64};
    IX_TRY(ix__check_planar(ctx, crv));
    IX_TRY(ix__path_new(ctx, crv, &out->path));
    IX_TRY(ix__path_no_poles(ctx, &out->path));
    IX_SCRATCH(ctx, out->t, out->room);
    out->size = ix__path_size(&out->path);
    out->dom[0] = out->path.breaks[0];
    out->dom[1] = out->path.breaks[out->path.nspans];
    IX_TRY(ix__marks_add(out, out->dom[0]));
    return ix__marks_add(out, out->dom[1]);
}

ix_status ix__marks_new(ix_ctx *ctx, const ix_mv *crv, ix__marks *out)
{
    IX_TRY(ix__marks_ends(ctx, crv, out));
    for (int s = 1; s < out->path.nspans; s++)
        if (ix__path_is_corner(&out->path, s))
            IX_TRY(ix__marks_add(out, out->path.breaks[s]));
    return IX_OK;
}

ix_status ix__marks_add(ix__marks *m, double t)
{
    IX_GROW(m->ctx, m->t, m->n, m->room);
    m->t[m->n++] = fmax(m->dom[0], fmin(m->dom[1], t));
    return IX_OK;
}

ix_status ix__marks_add_roots(ix__marks *m, ix_root *r, int n)
{
    ix_status st = IX_OK;

    for (int i = 0; st == IX_OK && i < n; i++) {
        bool wide = r[i].kind == IX_ROOT_INTERVAL;

        st = ix__marks_add(m, wide ? r[i].lo : r[i].t);
        if (st == IX_OK && wide)
            st = ix__marks_add(m, r[i].hi);
    }
    ix_roots_free(m->ctx, r, n);
    return st;
}

ix_status ix__marks_add_both(ix__marks *a, ix__marks *b, ix_solutions *s)
{
    ix_status st = IX_OK;

    for (int i = 0; st == IX_OK && i < 2 * s->n; i++)
        st = ix__marks_add(i % 2 ? b : a, s->sol[i / 2].x[i % 2]);
    ix_solutions_free(a->ctx, s);
    return st;
}

ix_status ix__marks_add_pairs(ix__marks *m, ix_solutions *s)
{
    return ix__marks_add_both(m, m, s);
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return x < y ? -1 : x > y;
}

void ix__marks_sort(ix__marks *m)
{
    double tie = 1e-9 * (m->dom[1] - m->dom[0]);
    int n = 1;

    qsort(m->t, (size_t)m->n, sizeof *m->t, ascending);
    for (int i = 1; i < m->n; i++)
        if (m->t[i] - m->t[n - 1] > tie)
            m->t[n++] = m->t[i];
    m->t[n - 1] = m->dom[1]; /* one next to the end is the end */
    m->n = n;
}

/* Does the curve from a to b stay within tol of where it begins? As seen at
 * eight places: a piece that leaves between two of them and comes back within
 * an eighth is longer than the tolerance by chance only. */
static bool stays(const ix__marks *m, double a, double b, double tol)
{
    double p[IX_MAX_COORDS], q[IX_MAX_COORDS];

    ix__path_point(&m->path, a, p);
    for (int i = 1; i <= 8; i++) {
        ix__path_point(&m->path, i == 8 ? b : a + (b - a) * i / 8, q);
        if (!(hypot(q[0] - p[0], q[1] - p[1]) <= tol))
            return false;
    }
    return true;
}

void ix__marks_thin(ix__marks *m, double tol)
{
    int n = 1;

    ix__marks_sort(m);
    for (int i = 1; i + 1 < m->n; i++)
        if (!stays(m, m->t[n - 1], m->t[i], tol))
            m->t[n++] = m->t[i];
    while (n > 1 && stays(m, m->t[n - 1], m->dom[1], tol))
        n--;
    m->t[n++] = m->dom[1];
    m->n = n;
}

ix_status ix__marks_add_corners(ix__marks *m, double angle)
{
    for (int s = 1; s < m->path.nspans; s++) {
        double t = m->path.breaks[s], u[3], v[3], c[3];
        bool both = ix__path_tangent3(&m->path, s - 1, t, true, u) &&
                    ix__path_tangent3(&m->path, s, t, false, v);

        if (both) {
            ix__cross3(u, v, c);
            both = atan2(ix__len3(c), ix__dot3(u, v)) <= angle;
        }
        if (!both)
            IX_TRY(ix__marks_add(m, t));
    }
    return IX_OK;
}

/* f' of the numerator f, or what f' w - f w' is for a fraction. */
static ix_status slope(ix_ctx *ctx, const ix_mv *crv, const ix_mv *f,
                       ix_mv **out)
{
    ix_pool q = {.ctx = ctx};

    return ix__pool_give(
        &q,
        crv->rational ? ix__pool_wronskian(&q, f, ix__pool_axis(&q, crv, 0), 0)
                      : ix__pool_derive(&q, f, 0),
        out);
}

ix_status ix__marks_line(const ix__marks *m, const double at[2],
                         const double normal[2], bool stationary, ix_root **r,
                         int *n)
{
    const double plane[4] = {normal[0], normal[1], 0,
                             -(normal[0] * at[0] + normal[1] * at[1])};
    ix_status st = IX_OK;
    ix_mv *f, *d = NULL;

    IX_TRY(ix__affine_field(m->ctx, m->crv, plane, &f));
    if (stationary)
        st = slope(m->ctx, m->crv, f, &d);
    if (st == IX_OK)
        st = ix_roots(m->ctx, d ? d : f, 0, NULL, r, n);
    ix_mv_unref(m->ctx, f);
    ix_mv_unref(m->ctx, d);
    return st;
}

ix_status ix__marks_add_line(ix__marks *m, const double at[2],
                             const double normal[2], bool stationary)
{
    ix_root *r;
    int n;

    IX_TRY(ix__marks_line(m, at, normal, stationary, &r, &n));
    return ix__marks_add_roots(m, r, n);
}
