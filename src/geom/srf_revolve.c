/* srf_revolve.c - surfaces of revolution. The result is the tensor product of
 * a circle about Z, as control points (weight, cosine, sine), and the
 * profile, so it is exact whenever the circle is. */
#include <math.h>
#include <string.h>

#include "geom/matrix.h"
#include "geom/parts.h"
#include "iritx/geom_srf.h"

#define S        0.70710678118654752440 /* sqrt(1/2) */
#define K        0.55228474983079339840 /* 4 (sqrt(2) - 1) / 3 */
#define TURN_MAX 13

static const double rational_knots[12] = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
static const double rational_rows[3][9] = {{1, S, 1, S, 1, S, 1, S, 1},
                                           {1, S, 0, -S, -1, -S, 0, S, 1},
                                           {0, S, 1, S, 0, -S, -1, -S, 0}};
static const double cubic_knots[17] = {0, 0, 0, 0, 1, 1, 1, 2, 2,
                                       2, 3, 3, 3, 4, 4, 4, 4};
static const double cubic_rows[2][TURN_MAX] = {
    {1, 1, K, 0, -K, -1, -1, -1, -K, 0, K, 1, 1},
    {0, K, 1, 1, 1, K, 0, -K, -1, -1, -1, -K, 0}};

/* A full turn; w is NULL for the polynomial one. */
typedef struct {
    ix_dir dir;
    const double *w, *c, *s;
} turn_rows;

static turn_rows turn_of(ix_turn turn)
{
    if (turn == IX_TURN_RATIONAL)
        return (turn_rows){{IX_BSPLINE, 3, 9, false, rational_knots},
                           rational_rows[0],
                           rational_rows[1],
                           rational_rows[2]};
    return (turn_rows){{IX_BSPLINE, 4, TURN_MAX, false, cubic_knots},
                       NULL,
                       cubic_rows[0],
                       cubic_rows[1]};
}

/* p has three coordinates and is rational as the turn is. */
static ix_status tensor(ix_ctx *ctx, const turn_rows *r, const ix_mv *p,
                        ix_mv **out)
{
    const double *x = ix_mv_coord(p, 0), *y = ix_mv_coord(p, 1),
                 *z = ix_mv_coord(p, 2);
    size_t n = (size_t)r->dir.length, np = p->npts;
    ix_dir dirs[1 + 2] = {r->dir};
    double *q;

    for (int d = 0; d < p->ndirs; d++)
        dirs[1 + d] = p->dirs[d];
    IX_TRY(ix__mv_alloc(ctx, 1 + p->ndirs, dirs, 3, p->rational, out));
    q = (*out)->pts;
    memset(q, 0, (size_t)p->naxes * n * np * sizeof *q);
    if (p->rational) {
        ix__outer_add(n, r->w, np, ix_mv_weights(p), 1, q);
        q += n * np;
    }
    ix__outer_add(n, r->c, np, x, 1, q);
    ix__outer_add(n, r->s, np, y, -1, q);
    q += n * np;
    ix__outer_add(n, r->s, np, x, 1, q);
    ix__outer_add(n, r->c, np, y, 1, q);
    ix__outer_add(n, r->w, np, z, 1, q + n * np);
    return IX_OK;
}

static ix_status revolve(ix_ctx *ctx, const ix_mv *crv, ix_turn turn,
                         ix_mv *t[2], ix_mv **out)
{
    turn_rows r = turn_of(turn);

    if (crv->rational && !r.w)
        return IX_FAIL(ctx, IX_EARG,
                       "a rational profile has no polynomial "
                       "surface of revolution");
    IX_TRY(ix_mv_to_bspline(ctx, crv, &t[0]));
    IX_TRY(ix_mv_coerce(ctx, t[0], 3, r.w != NULL, &t[1]));
    return tensor(ctx, &r, t[1], out);
}

ix_status ix_srf_revolve(ix_ctx *ctx, const ix_mv *crv, ix_turn turn,
                         ix_mv **out)
{
    ix_mv *t[2] = {NULL};
    ix_status st;

    *out = NULL;
    if (crv->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG, "the profile has %d directions, not 1",
                       crv->ndirs);
    st = revolve(ctx, crv, turn, t, out);
    ix__mv_unref_all(ctx, t, 2);
    return st;
}

ix_status ix_tv_revolve(ix_ctx *ctx, const ix_mv *srf, ix_turn turn,
                        ix_mv **out)
{
    ix_mv *t[4] = {NULL};
    ix_status st;

    *out = NULL;
    if (srf->ndirs != 2)
        return IX_FAIL(ctx, IX_EARG, "the profile has %d directions, not 2",
                       srf->ndirs);
    st = revolve(ctx, srf, turn, t, &t[2]);
    if (st == IX_OK)
        st = ix_mv_swap_dirs(ctx, t[2], 0, 1, &t[3]);
    if (st == IX_OK)
        st = ix_mv_swap_dirs(ctx, t[3], 1, 2, out);
    ix__mv_unref_all(ctx, t, 4);
    return st;
}

double ix_circle_param(double degrees)
{
    double quarter = fmin(fmax(floor(degrees / 90), 0), 4), half, r;

    half = tan((degrees - 90 * quarter) * (3.14159265358979323846 / 360));
    r = sqrt(2) * half;
    /* r / (1 + r) with r divided by (1 - half), in one fraction. */
    return fmin(quarter + r / (1 - half + r), 4);
}

static ix_status part(ix_ctx *ctx, const ix_mv *crv, double a0, double a1,
                      ix_mv *t[2], ix_mv **out)
{
    double rot[16];

    IX_TRY(ix_srf_revolve(ctx, crv, IX_TURN_RATIONAL, &t[0]));
    if (a1 - a0 >= 360)
        t[1] = ix_mv_ref(t[0]);
    else
        IX_TRY(ix_mv_region(ctx, t[0], 0, 0, ix_circle_param(a1 - a0), &t[1]));
    ix__mat_rotate(2, a0, rot);
    return ix_mv_transform(ctx, t[1], rot, out);
}

ix_status ix_srf_revolve_part(ix_ctx *ctx, const ix_mv *crv, double a0,
                              double a1, ix_mv **out)
{
    double lo = fmin(a0, a1), hi = fmax(a0, a1);
    ix_mv *t[2] = {NULL};
    ix_status st;

    *out = NULL;
    if (!(hi > lo && isfinite(hi) && isfinite(lo)))
        return IX_FAIL(ctx, IX_EARG, "no turn from %g to %g degrees", a0, a1);
    st = part(ctx, crv, lo, hi, t, out);
    ix__mv_unref_all(ctx, t, 2);
    return st;
}

/* turn takes +Z to the axis; its inverse is its transpose. */
static ix_status about_axis(ix_ctx *ctx, const ix_mv *crv, double a0, double a1,
                            const double turn[16], ix_mv *t[3], ix_mv **out)
{
    double back[16];

    for (int i = 0; i < 16; i++)
        back[i] = turn[4 * (i % 4) + i / 4];
    IX_TRY(ix_mv_coerce(ctx, crv, 3, crv->rational, &t[0]));
    IX_TRY(ix_mv_transform(ctx, t[0], back, &t[1]));
    IX_TRY(ix_srf_revolve_part(ctx, t[1], a0, a1, &t[2]));
    return ix_mv_transform(ctx, t[2], turn, out);
}

ix_status ix_srf_revolve_axis(ix_ctx *ctx, const ix_mv *crv, double a0,
                              double a1, const double axis[3], ix_mv **out)
{
    ix_mv *t[3] = {NULL};
    double turn[16];
    ix_status st;

    *out = NULL;
    IX_TRY(ix__mat_turn(ctx, (const double[3]){0, 0, 1}, axis, turn));
    st = about_axis(ctx, crv, a0, a1, turn, t, out);
    ix__mv_unref_all(ctx, t, 3);
    return st;
}

/* --- trivariates, any axis ---------------------------------------------- */

/* The parameter of an angle of 0 .. 360 degrees on the circle of cubics: within
 * a quarter the angle grows with it. */
static double cubic_param(double degrees)
{
    double quarter = fmin(fmax(floor(degrees / 90), 0), 4);
    double angle = (degrees - 90 * quarter) / 180 * 3.14159265358979323846;
    double lo = 0, hi = 1;

    for (int i = 0; i < 54; i++) {
        double t = (lo + hi) / 2, s = 1 - t;
        double x = s * s * s + 3 * s * s * t + 3 * s * t * t * K;
        double y = 3 * s * s * t * K + 3 * s * t * t + t * t * t;

        if (atan2(y, x) <= angle)
            lo = t;
        else
            hi = t;
    }
    return fmin(quarter + lo, 4);
}

/* turn takes +Z to the axis. */
static ix_status turn_about(ix_ctx *ctx, const ix_mv *srf,
                            const ix_revolution *r, const double turn[16],
                            ix_mv *t[4], ix_mv **out)
{
    double first[16], last[16], lo = fmin(r->a0, r->a1), rot[16];
    double angle = fmax(r->a0, r->a1) - lo;

    for (int i = 0; i < 16; i++)
        first[i] = turn[4 * (i % 4) + i / 4];
    for (int k = 0; k < 3; k++) /* the point of the axis to the origin */
        for (int i = 0; i < 3; i++)
            first[12 + k] -= r->point[i] * first[4 * i + k];
    ix__mat_rotate(2, lo, rot);
    ix__mat_mul(rot, turn, last);
    for (int k = 0; k < 3; k++)
        last[12 + k] += r->point[k];
    IX_TRY(ix_mv_coerce(ctx, srf, 3, srf->rational, &t[0]));
    IX_TRY(ix_mv_transform(ctx, t[0], first, &t[1]));
    IX_TRY(ix_tv_revolve(ctx, t[1], r->turn, &t[2]));
    if (angle >= 360)
        return ix_mv_transform(ctx, t[2], last, out);
    IX_TRY(ix_mv_region(ctx, t[2], 2, 0,
                        r->turn == IX_TURN_RATIONAL ? ix_circle_param(angle)
                                                    : cubic_param(angle),
                        &t[3]));
    return ix_mv_transform(ctx, t[3], last, out);
}

ix_status ix_tv_revolve_about(ix_ctx *ctx, const ix_mv *srf,
                              const ix_revolution *r, ix_mv **out)
{
    ix_mv *t[4] = {NULL};
    double turn[16];
    ix_status st;

    *out = NULL;
    if (!(fabs(r->a1 - r->a0) > 0 && isfinite(r->a0) && isfinite(r->a1)))
        return IX_FAIL(ctx, IX_EARG, "no turn from %g to %g degrees", r->a0,
                       r->a1);
    IX_TRY(ix__mat_turn(ctx, (const double[3]){0, 0, 1}, r->axis, turn));
    st = turn_about(ctx, srf, r, turn, t, out);
    ix__mv_unref_all(ctx, t, 4);
    return st;
}
