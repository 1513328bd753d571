/* draft.c - surfaces of constant slope that go on where the slope of a surface
 * is left: ruled ones, tangent to it along an isocline.
 *
 * The ruling at a point with unit normal n is the line of steepest slope in
 * the tangent plane, V - <n, V> n. It and the isocline span the tangent plane,
 * and all of them have one angle with V: the ruled surface is developable, its
 * normals along a ruling are n. */
#include <math.h>
#include <string.h>

#include "geom/lines.h"
#include "geom/vec3.h"
#include "iritx/contour.h"
#include "iritx/geom_srf.h"
#include "mv/mv.h"

typedef struct {
    ix_ctx *ctx;
    const ix_mv *s, *field;
    double v[3];     /* unit */
    double sign;     /* of the field at the side that the rulings go to */
    double level[2]; /* least and largest <S, V> of the control points */
} draft;

/* How far the surface may reach along V. */
static ix_status measure(draft *d)
{
    const double *w = ix_mv_weights(d->s);

    d->level[0] = HUGE_VAL;
    d->level[1] = -HUGE_VAL;
    for (size_t i = 0; i < d->s->npts; i++) {
        double h = 0;

        for (int k = 0; k < d->s->ncoords && k < 3; k++)
            h += ix_mv_coord(d->s, k)[i] * d->v[k];
        h /= w ? w[i] : 1;
        if (!isfinite(h))
            return IX_FAIL(d->ctx, IX_EDOMAIN, "a control point at infinity");
        d->level[0] = fmin(d->level[0], h);
        d->level[1] = fmax(d->level[1], h);
    }
    return IX_OK;
}

/* The derivative of the field at uv in the direction whose image is r. */
static ix_status field_along(const draft *d, const double *uv, const double *r,
                             double *out)
{
    double t[2][3], g[2], e, f, h, a, b, det;

    for (int j = 0; j < 2; j++) {
        const int once[2] = {j == 0, j == 1};
        double v[IX_MAX_COORDS + 1];

        IX_TRY(ix_srf_tangent(d->ctx, d->s, j, uv[0], uv[1], t[j]));
        IX_TRY(ix_mv_partial(d->ctx, d->field, uv, once, v));
        g[j] = v[d->field->naxes - 1];
    }
    e = ix__dot3(t[0], t[0]);
    f = ix__dot3(t[0], t[1]);
    h = ix__dot3(t[1], t[1]);
    a = ix__dot3(t[0], r);
    b = ix__dot3(t[1], r);
    det = e * h - f * f;
    *out = (g[0] * (a * h - b * f) + g[1] * (b * e - a * f)) / det;
    return IX_OK;
}

/* Foot and end of the ruling at uv; *up: it goes along V; false in *some if it
 * has no length. */
static ix_status ruling(const draft *d, const double *uv, double foot[3],
                        double end[3], bool *up, bool *some)
{
    double n[3], r[3], slope, h, p[IX_MAX_COORDS] = {0};

    IX_TRY(ix_mv_point(d->ctx, d->s, uv, p));
    memcpy(foot, p, 3 * sizeof *foot);
    IX_TRY(ix_srf_normal(d->ctx, d->s, uv[0], uv[1], n));
    ix__axpy3(d->v, -ix__dot3(n, d->v), n, r);
    IX_TRY(field_along(d, uv, r, &slope));
    *up = slope * d->sign > 0;
    h = d->level[*up] - ix__dot3(foot, d->v); /* <r, V> = |r|^2 */
    ix__axpy3(foot, h / ix__dot3(r, r), r, end);
    *some = fabs(h) > 1e-12 * (d->level[1] - d->level[0]);
    return IX_OK;
}

/* The n feet at *to become a line, and their ends the next one. */
static void add_pair(ix_lines *out, int n, double (**to)[3], double (*end)[3])
{
    if (n < 2)
        return;
    memcpy(*to + n, end, (size_t)n * sizeof *end);
    *to += 2 * n;
    out->count[out->n++] = n;
    out->count[out->n++] = n;
}

/* The feet and ends of rulings along one isocline, in pieces in which they go
 * to one side of V: lines 2 i and 2 i + 1. */
static ix_status along_curve(const draft *d, const ix_solution_curve *c,
                             ix_lines *out, double (**to)[3], double (*end)[3])
{
    bool up = false, now = false, some = false;
    int n = 0;

    for (int i = 0; i <= c->n; i++) {
        double foot[3], tip[3];

        if (i < c->n)
            IX_TRY(ruling(d, c->x + 2 * i, foot, tip, &now, &some));
        if (n > 0 && (i == c->n || now != up || !some)) {
            add_pair(out, n, to, end);
            n = 0;
        }
        if (i == c->n || !some)
            continue;
        up = now;
        memcpy((*to)[n], foot, sizeof foot);
        memcpy(end[n++], tip, sizeof tip);
    }
    return IX_OK;
}

static ix_status fill(const draft *d, const ix_solution_curves *s,
                      ix_lines *out)
{
    double(*to)[3] = out->pt, (*end)[3];
    int most = 0;

    for (int i = 0; i < s->ncurves; i++)
        most = s->curve[i].n > most ? s->curve[i].n : most;
    IX_SCRATCH(d->ctx, end, most);
    for (int i = 0; i < s->ncurves; i++)
        IX_TRY(along_curve(d, &s->curve[i], out, &to, end));
    return IX_OK;
}

static ix_status drafts(draft *d, double theta, double tol, ix_lines *out)
{
    ix_solution_curves s;
    size_t points = 0;
    ix_status st;

    IX_TRY(measure(d));
    IX_TRY(ix_isocline(d->ctx, d->s, d->v, theta, tol, &s));
    for (int i = 0; i < s.ncurves; i++)
        points += (size_t)s.curve[i].n;
    st = ix__lines_new(d->ctx, 2 * points, out);
    if (st == IX_OK)
        st = fill(d, &s, out);
    if (st != IX_OK)
        ix_lines_free(d->ctx, out);
    ix_solution_curves_free(d->ctx, &s);
    return st;
}

ix_status ix_isocline_drafts(ix_ctx *ctx, const ix_mv *s, const double view[3],
                             double theta, bool below, double tol,
                             ix_lines *out)
{
    draft d = {.ctx = ctx, .s = s, .sign = below ? 1 : -1};
    ix_mark mk;
    ix_status st;
    ix_mv *f;

    *out = (ix_lines){0};
    if (!(fabs(sin(theta)) > 1e-6))
        return IX_FAIL(ctx, IX_EARG,
                       "an angle of %g degrees; a slope has a direction only "
                       "for more than 0 and less than 180",
                       theta * 180 / acos(-1));
    if (!(ix__unit3(view, d.v) > 0))
        return IX_FAIL(ctx, IX_EARG, "a direction of length 0");
    IX_TRY(ix_isocline_field(ctx, s, view, theta, &f));
    d.field = f;
    mk = ix__scratch_mark(ctx);
    st = drafts(&d, theta, tol, out);
    ix__scratch_release(ctx, mk);
    ix_mv_unref(ctx, f);
    return st;
}
