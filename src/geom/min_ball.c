/* min_ball.c - smallest enclosing balls by exchange: a ball of at most four
 * support points meets the farthest point there is; of these five the smallest
 * ball is found by trying all subsets. The radius grows with every step. */
#include <string.h>

#include "geom/vec3.h"
#include "iritx/distance.h"
#include "iritx/enclose.h"
#include "mv/mv.h"

#define INSIDE 1e-12 /* of the radius: roundings of one circumscribed ball */
enum { DIMS = 3, SUPPORT = DIMS + 1, MAX_STEPS = 10000 };

/* The farthest point from center, into p. */
typedef ix_status (*farthest_fn)(ix_ctx *ctx, void *arg, const double center[3],
                                 double p[3]);

/* --- at most five points ---------------------------------------------------
 */

/* Solves the symmetric n x n system g x = b, g semidefinite, by Cholesky; false
 * if the points are dependent (a pivot below 1e-14 of its column). */
static bool solve_gram(int n, double g[DIMS][DIMS], double *b)
{
    for (int i = 0; i < n; i++) {
        double full = g[i][i];

        for (int k = 0; k < i; k++)
            g[i][i] -= g[i][k] * g[i][k];
        if (!(g[i][i] > 1e-14 * full))
            return false;
        g[i][i] = sqrt(g[i][i]);
        for (int j = i + 1; j < n; j++) {
            for (int k = 0; k < i; k++)
                g[j][i] -= g[j][k] * g[i][k];
            g[j][i] /= g[i][i];
        }
    }
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < i; k++)
            b[i] -= g[i][k] * b[k];
        b[i] /= g[i][i];
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++)
            b[i] -= g[k][i] * b[k];
        b[i] /= g[i][i];
    }
    return true;
}

/* The smallest ball with all n <= 4 points on its boundary: its centre is in
 * their affine hull, c = p0 + sum x_i d_i with 2 <d_i, c - p0> = |d_i|^2. */
static bool circumscribe(int n, const double (*p)[3], ix_ball *out)
{
    double d[DIMS][3], g[DIMS][DIMS], x[DIMS];

    memcpy(out->center, p[0], sizeof out->center);
    out->radius = 0;
    for (int i = 1; i < n; i++) {
        ix__sub3(p[i], p[0], d[i - 1]);
        x[i - 1] = ix__dot3(d[i - 1], d[i - 1]) / 2;
        for (int j = 0; j < i; j++)
            g[i - 1][j] = ix__dot3(d[i - 1], d[j]);
    }
    if (n > 1 && !solve_gram(n - 1, g, x))
        return false;
    for (int i = 1; i < n; i++)
        ix__axpy3(out->center, x[i - 1], d[i - 1], out->center);
    out->radius = ix__dist3(out->center, p[0]);
    return true;
}

static bool holds(const ix_ball *b, int n, const double (*p)[3])
{
    for (int i = 0; i < n; i++)
        if (!(ix__dist3(b->center, p[i]) <= b->radius * (1 + INSIDE)))
            return false;
    return true;
}

/* The smallest ball of n <= 5 points, and the points that define it, moved to
 * the front; *m of them. */
static bool smallest(int n, double (*p)[3], int *m, ix_ball *best)
{
    double kept[SUPPORT][3];

    best->radius = HUGE_VAL;
    for (int set = 1; set < 1 << n; set++) {
        double q[SUPPORT + 1][3] = {{0}};
        ix_ball b;
        int k = 0;

        for (int i = 0; i < n; i++)
            if (set >> i & 1)
                memcpy(q[k++], p[i], sizeof q[0]);
        if (k > SUPPORT || !circumscribe(k, (const double(*)[3])q, &b) ||
            !(b.radius < best->radius) || !holds(&b, n, (const double(*)[3])p))
            continue;
        *best = b;
        *m = k;
        memcpy(kept, q, (size_t)k * sizeof *kept);
    }
    if (!(best->radius < HUGE_VAL))
        return false;
    memcpy(p, kept, (size_t)*m * sizeof *kept);
    return true;
}

/* --- exchange --------------------------------------------------------------
 */

static ix_status exchange(ix_ctx *ctx, farthest_fn farthest, void *arg,
                          ix_ball *out)
{
    double p[SUPPORT + 1][3] = {{0}};
    ix_ball b;
    int m = 1;

    memcpy(p[0], out->center, sizeof p[0]);
    out->radius = 0;
    for (int step = 0; step < MAX_STEPS; step++) {
        IX_TRY(farthest(ctx, arg, out->center, p[m]));
        if (!(ix__dist3(out->center, p[m]) > out->radius * (1 + INSIDE)))
            return IX_OK;
        m++;
        if (!smallest(m, p, &m, &b) || !(b.radius > out->radius))
            return IX_OK; /* rounding: no ball is larger and holds them */
        *out = b;
        IX_TRY(ix__poll(ctx));
    }
    return IX_FAIL(ctx, IX_EUNABLE, "no smallest ball after %d steps",
                   MAX_STEPS);
}

typedef struct {
    int n;
    const double (*p)[3];
} cloud;

static ix_status farthest_point(ix_ctx *ctx, void *arg, const double center[3],
                                double p[3])
{
    const cloud *c = arg;
    double best = -1;

    (void)ctx;
    for (int i = 0; i < c->n; i++) {
        double d = ix__dist3(center, c->p[i]);

        if (d > best) {
            best = d;
            memcpy(p, c->p[i], 3 * sizeof *p);
        }
    }
    return IX_OK;
}

ix_status ix_ball_of_points(ix_ctx *ctx, int n, const double (*p)[3],
                            ix_ball *out)
{
    cloud c = {n, p};

    if (n < 1)
        return IX_FAIL(ctx, IX_EARG, "a ball around %d points", n);
    for (int i = 0; i < n; i++)
        if (!isfinite(p[i][0] + p[i][1] + p[i][2]))
            return IX_FAIL(ctx, IX_EARG, "point %d is not finite", i + 1);
    memcpy(out->center, p[0], sizeof out->center);
    return exchange(ctx, farthest_point, &c, out);
}

/* --- curves ----------------------------------------------------------------
 */

typedef struct {
    int n;
    ix_mv **crv; /* two coordinates */
} flats;

static ix_status point_of(ix_ctx *ctx, const ix_mv *c, double t, double p[3])
{
    double x[IX_MAX_COORDS] = {0};

    IX_TRY(ix_mv_point(ctx, c, &t, x));
    p[0] = x[0];
    p[1] = x[1];
    p[2] = 0;
    return IX_OK;
}

static ix_status farthest_on_curves(ix_ctx *ctx, void *arg,
                                    const double center[3], double p[3])
{
    const flats *f = arg;
    double best = -1, t, d;

    for (int i = 0; i < f->n; i++) {
        IX_TRY(ix_crv_nearest(ctx, f->crv[i], center, NULL, true, &t, &d));
        if (!(d > best))
            continue;
        best = d;
        IX_TRY(point_of(ctx, f->crv[i], t, p));
    }
    return IX_OK;
}

static ix_status flatten(ix_ctx *ctx, int n, const ix_mv *const *crv, flats *f)
{
    IX_SCRATCH_ZERO(ctx, f->crv, n);
    for (f->n = 0; f->n < n; f->n++) {
        const ix_mv *c = crv[f->n];

        if (c->ndirs != 1 || c->ncoords > 3)
            return IX_FAIL(ctx, IX_EARG,
                           "%d directions and %d coordinates; curves of at "
                           "most 3 are wanted",
                           c->ndirs, c->ncoords);
        IX_TRY(ix_mv_coerce(ctx, c, 2, c->rational, &f->crv[f->n]));
    }
    return IX_OK;
}

static ix_status around_curves(ix_ctx *ctx, int n, const ix_mv *const *crv,
                               ix_ball *out)
{
    flats f = {0};
    ix_status st = flatten(ctx, n, crv, &f);
    double dom[2];

    if (st == IX_OK) {
        ix_mv_domain(f.crv[0], 0, dom);
        st = point_of(ctx, f.crv[0], dom[0], out->center);
    }
    if (st == IX_OK)
        st = exchange(ctx, farthest_on_curves, &f, out);
    for (int i = 0; f.crv && i < f.n; i++)
        ix_mv_unref(ctx, f.crv[i]);
    return st;
}

ix_status ix_ball_of_curves(ix_ctx *ctx, int n, const ix_mv *const *crv,
                            ix_ball *out)
{
    if (n < 1)
        return IX_FAIL(ctx, IX_EARG, "a circle around %d curves", n);
    IX_RETURN_SCOPED(ctx, around_curves(ctx, n, crv, out));
}

/* --- cones -----------------------------------------------------------------
 */

/* A cap of the unit sphere below a half sphere is the part inside the smallest
 * ball of its points, whose centre is on the cap's axis. */
static ix_status around_vectors(ix_ctx *ctx, int n, const double (*v)[3],
                                double axis[3], double *angle)
{
    double(*u)[3];
    ix_ball b;

    IX_SCRATCH(ctx, u, n);
    for (int i = 0; i < n; i++)
        IX_TRY(ix__direction(ctx, "vector", v[i], u[i]));
    IX_TRY(ix_ball_of_points(ctx, n, (const double(*)[3])u, &b));
    /* 1e-7: a cap of a half sphere has its centre at 0, to the root of
     * rounding */
    if (!(ix__unit3(b.center, axis) > 1e-7))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the %d vectors do not fit into a half space: no cone "
                       "below 90 degrees holds them",
                       n);
    *angle = 0;
    for (int i = 0; i < n; i++) { /* by the chord: exact for narrow cones */
        double d = ix__dist3(axis, u[i]) / 2;

        *angle = fmax(*angle, 2 * asin(fmin(1, d)));
    }
    return IX_OK;
}

ix_status ix_cone_of_vectors(ix_ctx *ctx, int n, const double (*v)[3],
                             double axis[3], double *angle)
{
    if (n < 1)
        return IX_FAIL(ctx, IX_EARG, "a cone around %d vectors", n);
    IX_RETURN_SCOPED(ctx, around_vectors(ctx, n, v, axis, angle));
}
