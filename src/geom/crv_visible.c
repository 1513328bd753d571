/* crv_visible.c - which parts of a planar curve are seen. */
#include <math.h>

#include "geom/crvs.h"
#include "geom/marks.h"
#include "iritx/distance.h"
#include "iritx/visible.h"

#define NEAR 1e-9 /* of the size: a point that hides is farther in front */

typedef struct {
    ix_ctx *ctx;
    int n;
    ix__marks *m; /* of each curve */
    double view[2], size;
    bool point;
} sight;

/* The unit vector from p to the viewer and how far it is; false at the viewer
 * itself. */
static bool line_of_sight(const sight *s, const double *p, double d[2],
                          double *far)
{
    double len;

    for (int k = 0; k < 2; k++)
        d[k] = s->view[k] - (s->point ? p[k] : 0);
    len = hypot(d[0], d[1]);
    *far = s->point ? len : HUGE_VAL;
    d[0] /= len;
    d[1] /= len;
    return len > 0;
}

/* The line of sight through t of curve i: point and unit vectors. */
typedef struct {
    double p[IX_MAX_COORDS], d[2], normal[2], far;
} ray;

static bool ray_through(const sight *s, int i, double t, ray *r)
{
    ix__path_point(&s->m[i].path, t, r->p);
    if (!line_of_sight(s, r->p, r->d, &r->far))
        return false;
    r->normal[0] = -r->d[1];
    r->normal[1] = r->d[0];
    return true;
}

static ix_status mark_contours(const sight *s, ix__marks *m)
{
    const double p[3] = {s->view[0], s->view[1], 0}, zero[2] = {0, 0};
    const double across[2] = {-s->view[1], s->view[0]};
    ix_root *r;
    int n;

    if (!s->point)
        return ix__marks_add_line(m, zero, across, true);
    IX_TRY(ix_crv_tangents_from(s->ctx, m->crv, p, &r, &n));
    return ix__marks_add_roots(m, r, n);
}

/* Behind and before the marks so far, on all curves. */
static ix_status mark_shadows(const sight *s)
{
    int *marks;
    ray l;

    IX_SCRATCH(s->ctx, marks, s->n);
    for (int i = 0; i < s->n; i++)
        marks[i] = s->m[i].n;
    for (int i = 0; i < s->n; i++)
        for (int j = 0; j < marks[i]; j++)
            for (int k = 0; ray_through(s, i, s->m[i].t[j], &l) && k < s->n;
                 k++)
                IX_TRY(ix__marks_add_line(&s->m[k], l.p, l.normal, false));
    return IX_OK;
}

/* Where curve i meets itself and those after it. */
static ix_status mark_crossings(const sight *s, int i)
{
    ix_solutions cross;

    IX_TRY(ix_crv_self_meet(s->ctx, s->m[i].crv, &cross));
    IX_TRY(ix__marks_add_pairs(&s->m[i], &cross));
    for (int k = i + 1; k < s->n; k++) {
        IX_TRY(ix_crv_crv_meet(s->ctx, s->m[i].crv, s->m[k].crv, NULL, &cross));
        IX_TRY(ix__marks_add_both(&s->m[i], &s->m[k], &cross));
    }
    return IX_OK;
}

static bool hides(const sight *s, const ray *l, int k, double t)
{
    double x[IX_MAX_COORDS], along;

    ix__path_point(&s->m[k].path, t, x);
    along = (x[0] - l->p[0]) * l->d[0] + (x[1] - l->p[1]) * l->d[1];
    return along > NEAR * s->size && along < l->far;
}

static ix_status is_seen(const sight *s, int i, double t, bool *seen)
{
    ray l;

    *seen = true;
    if (!ray_through(s, i, t, &l))
        return IX_OK;
    for (int k = 0; *seen && k < s->n; k++) {
        ix_root *r = NULL;
        int n;

        IX_TRY(ix__marks_line(&s->m[k], l.p, l.normal, false, &r, &n));
        for (int j = 0; *seen && j < n; j++)
            *seen = !hides(s, &l, k, r[j].lo) && !hides(s, &l, k, r[j].hi);
        ix_roots_free(s->ctx, r, n);
    }
    return IX_OK;
}

/* Neighbouring intervals of curve i that are seen, as one: from[*n], to[*n]. */
static ix_status seen_runs(const sight *s, int i, int *n, double **from,
                           double **to)
{
    const double *t = s->m[i].t;
    bool before = false;

    *n = 0;
    IX_SCRATCH(s->ctx, *from, s->m[i].n);
    IX_SCRATCH(s->ctx, *to, s->m[i].n);
    for (int j = 0; j + 1 < s->m[i].n; j++) {
        bool seen;

        IX_TRY(is_seen(s, i, (t[j] + t[j + 1]) / 2, &seen));
        if (seen && !before)
            (*from)[(*n)++] = t[j];
        if (seen)
            (*to)[*n - 1] = t[j + 1];
        before = seen;
    }
    return IX_OK;
}

static ix_status pieces(const sight *s, int i, ix_crvs *out)
{
    double *from, *to;
    ix_status st;
    ix_mv *b;
    int n;

    IX_TRY(seen_runs(s, i, &n, &from, &to));
    IX_TRY(ix_mv_to_bspline(s->ctx, s->m[i].crv, &b));
    st = ix__crvs_new(s->ctx, n, out);
    for (int k = 0; st == IX_OK && k < n; k++) {
        st = ix_mv_region(s->ctx, b, 0, from[k], to[k], &out->crv[k]);
        out->t[2 * k] = from[k];
        out->t[2 * k + 1] = to[k];
    }
    ix_mv_unref(s->ctx, b);
    return st;
}

static ix_status visible(ix_ctx *ctx, const ix_mv *const *crv, sight *s,
                         ix_crvs *out)
{
    IX_SCRATCH(ctx, s->m, s->n);
    for (int i = 0; i < s->n; i++) {
        IX_TRY(ix__marks_new(ctx, crv[i], &s->m[i]));
        s->size = fmax(s->size, s->m[i].size);
        IX_TRY(mark_contours(s, &s->m[i]));
    }
    IX_TRY(mark_shadows(s));
    for (int i = 0; i < s->n; i++)
        IX_TRY(mark_crossings(s, i));
    for (int i = 0; i < s->n; i++) {
        ix__marks_sort(&s->m[i]);
        IX_TRY(pieces(s, i, &out[i]));
    }
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, const ix_mv *const *crv, sight *s,
                     ix_crvs *out)
{
    ix_status st = visible(ctx, crv, s, out);

    for (int i = 0; st != IX_OK && i < s->n; i++)
        ix_crvs_free(ctx, &out[i]);
    return st;
}

ix_status ix_crvs_visible(ix_ctx *ctx, int n, const ix_mv *const *crv,
                          const double view[2], bool point, ix_crvs *out)
{
    sight s = {.ctx = ctx, .n = n, .view = {view[0], view[1]}, .point = point};
    double len = hypot(view[0], view[1]);

    for (int i = 0; i < n; i++)
        out[i] = (ix_crvs){0};
    if (!isfinite(len) || (!point && !(len > 0)))
        return IX_FAIL(ctx, IX_EARG, "a view (%g, %g) without a direction",
                       view[0], view[1]);
    IX_RETURN_SCOPED(ctx, run(ctx, crv, &s, out));
}

ix_status ix_crv_visible(ix_ctx *ctx, const ix_mv *crv, const double view[2],
                         bool point, ix_crvs *out)
{
    return ix_crvs_visible(ctx, 1, &crv, view, point, out);
}
