/* crv_visible.c - which parts of a planar curve are seen. */
#include <math.h>

#include "geom/crvs.h"
#include "geom/marks.h"
#include "iritx/distance.h"
#include "iritx/visible.h"

#define NEAR 1e-9 /* of the size: a point that hides is farther in front */

typedef struct {
    ix__marks m;
    double view[2];
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

/* What the line of sight through t meets. */
static ix_status line_roots(sight *s, double t, double p[IX_MAX_COORDS],
                            double d[2], double *far, ix_root **r, int *n)
{
    double normal[2];

    *n = 0;
    ix__path_point(&s->m.path, t, p);
    if (!line_of_sight(s, p, d, far))
        return IX_OK;
    normal[0] = -d[1];
    normal[1] = d[0];
    return ix__marks_line(&s->m, p, normal, false, r, n);
}

static ix_status mark_contours(sight *s)
{
    const double p[3] = {s->view[0], s->view[1], 0}, zero[2] = {0, 0};
    const double across[2] = {-s->view[1], s->view[0]};
    ix_root *r;
    ix_status st;
    int n;

    if (s->point)
        st = ix_crv_tangents_from(s->m.ctx, s->m.crv, p, &r, &n);
    else
        st = ix__marks_line(&s->m, zero, across, true, &r, &n);
    IX_TRY(st);
    st = ix__marks_add_roots(&s->m, r, n);
    ix_roots_free(s->m.ctx, r, n);
    return st;
}

/* Behind and before the marks so far. */
static ix_status mark_shadows(sight *s)
{
    int marks = s->m.n;

    for (int i = 0; i < marks; i++) {
        double p[IX_MAX_COORDS], d[2], far;
        ix_root *r = NULL;
        ix_status st;
        int n;

        IX_TRY(line_roots(s, s->m.t[i], p, d, &far, &r, &n));
        st = ix__marks_add_roots(&s->m, r, n);
        ix_roots_free(s->m.ctx, r, n);
        IX_TRY(st);
    }
    return IX_OK;
}

static bool hides(const sight *s, const double *p, const double *d, double far,
                  double t)
{
    double x[IX_MAX_COORDS], along;

    ix__path_point(&s->m.path, t, x);
    along = (x[0] - p[0]) * d[0] + (x[1] - p[1]) * d[1];
    return along > NEAR * s->m.size && along < far;
}

static ix_status is_seen(sight *s, double t, bool *seen)
{
    double p[IX_MAX_COORDS], d[2], far;
    ix_root *r = NULL;
    int n;

    *seen = true;
    IX_TRY(line_roots(s, t, p, d, &far, &r, &n));
    for (int i = 0; *seen && i < n; i++)
        *seen = !hides(s, p, d, far, r[i].lo) && !hides(s, p, d, far, r[i].hi);
    ix_roots_free(s->m.ctx, r, n);
    return IX_OK;
}

/* Neighbouring intervals that are seen, as one: from[*n], to[*n]. */
static ix_status seen_runs(sight *s, int *n, double **from, double **to)
{
    const double *t = s->m.t;
    bool before = false;

    *n = 0;
    IX_SCRATCH(s->m.ctx, *from, s->m.n);
    IX_SCRATCH(s->m.ctx, *to, s->m.n);
    for (int i = 0; i + 1 < s->m.n; i++) {
        bool seen;

        IX_TRY(is_seen(s, (t[i] + t[i + 1]) / 2, &seen));
        if (seen && !before)
            (*from)[(*n)++] = t[i];
        if (seen)
            (*to)[*n - 1] = t[i + 1];
        before = seen;
    }
    return IX_OK;
}

static ix_status pieces(sight *s, int n, const double *from, const double *to,
                        ix_crvs *out)
{
    ix_status st;
    ix_mv *b;

    IX_TRY(ix_mv_to_bspline(s->m.ctx, s->m.crv, &b));
    st = ix__crvs_new(s->m.ctx, n, out);
    for (int i = 0; st == IX_OK && i < n; i++) {
        st = ix_mv_region(s->m.ctx, b, 0, from[i], to[i], &out->crv[i]);
        out->t[2 * i] = from[i];
        out->t[2 * i + 1] = to[i];
    }
    ix_mv_unref(s->m.ctx, b);
    if (st != IX_OK)
        ix_crvs_free(s->m.ctx, out);
    return st;
}

static ix_status visible(ix_ctx *ctx, const ix_mv *crv, sight *s, ix_crvs *out)
{
    double *from, *to;
    ix_solutions cross;
    int n;

    IX_TRY(ix__marks_new(ctx, crv, &s->m));
    IX_TRY(mark_contours(s));
    IX_TRY(mark_shadows(s));
    IX_TRY(ix_crv_self_meet(ctx, crv, &cross));
    IX_TRY(ix__marks_add_pairs(&s->m, &cross));
    ix__marks_sort(&s->m);
    IX_TRY(seen_runs(s, &n, &from, &to));
    return pieces(s, n, from, to, out);
}

ix_status ix_crv_visible(ix_ctx *ctx, const ix_mv *crv, const double view[2],
                         bool point, ix_crvs *out)
{
    sight s = {.view = {view[0], view[1]}, .point = point};
    double len = hypot(view[0], view[1]);

    *out = (ix_crvs){0};
    if (!isfinite(len) || (!point && !(len > 0)))
        return IX_FAIL(ctx, IX_EARG, "a view (%g, %g) without a direction",
                       view[0], view[1]);
    IX_RETURN_SCOPED(ctx, visible(ctx, crv, &s, out));
}
