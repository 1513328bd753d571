/* srf_quadric.c - a rational biquadratic patch of a quadric given by its
 * equation. In the axes of its quadratic form every quadric is a sum of
 * products of one function of u and one of v, each rational quadratic:
 * circle, hyperbola or parabola. */
#include <math.h>
#include <string.h>

#include "base/ctx.h"
#include "geom/eigen.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"

/* --- the functions of one parameter ------------------------------------ */

/* Bezier coefficients of three functions each: (1, c, s) with a common weight
 * for circle and hyperbola, (1, t, t^2) for the parabola, t in [-1, 1]. */
typedef double functions[3][3];

#define HALF  0.5                 /* cos 60: arcs of 120 degrees */
#define ROOT3 0.86602540378443865 /* sin 60 */
#define COSH1 1.54308063481524378
#define SINH1 1.17520119364380146

static const functions circle = {
    {1, HALF, 1}, {HALF, 1, HALF}, {-ROOT3, 0, ROOT3}};
static const functions hyperbola = {
    {1, COSH1, 1}, {COSH1, 1, COSH1}, {-SINH1, 0, SINH1}};
static const functions parabola = {{1, 1, 1}, {-1, 0, 1}, {1, -1, 1}};

/* A term f_u[iu] f_v[iv] of a coordinate. */
typedef struct {
    double f;
    int iu, iv;
} term;

/* A patch in its own axes: z[k] sums of terms, weight f_u[0] f_v[0]. */
typedef struct {
    const functions *u, *v;
    term z[3][3]; /* f = 0: no term */
} patch;

/* --- the equation in the axes of its form ------------------------------ */

typedef struct {
    double lambda[3], axis[3][3]; /* eigenvalues that vanish come last */
    int rank;
    double linear[3]; /* of the axes without quadratic term: only the first of
                         them, axis[rank], has one */
    double constant;  /* after completing the squares */
    double origin[3];
    double scale; /* size of what constant is the difference of */
} canonical;

/* Relative size of what rounding of the coefficients leaves of a zero. */
#define ZERO 1e-12

static void swap_axes(canonical *q, int i, int j)
{
    double l = q->lambda[i], v[3];

    q->lambda[i] = q->lambda[j];
    q->lambda[j] = l;
    memcpy(v, q->axis[i], sizeof v);
    memcpy(q->axis[i], q->axis[j], sizeof v);
    memcpy(q->axis[j], v, sizeof v);
}

static void principal_axes(const double c[10], canonical *q)
{
    double a[9] = {c[0],     c[3] / 2, c[4] / 2, c[3] / 2, c[1],
                   c[5] / 2, c[4] / 2, c[5] / 2, c[2]};
    double most = 0;

    ix__eigen_symmetric(3, a, q->lambda, &q->axis[0][0]);
    for (int k = 0; k < 3; k++)
        most = fmax(most, fabs(q->lambda[k]));
    q->rank = 0;
    for (int k = 0; k < 3; k++)
        if (fabs(q->lambda[k]) > ZERO * most)
            swap_axes(q, q->rank++, k);
}

/* The axes of the null space turned so that the first carries all of the
 * linear part g. */
static void turn_null_axes(const double g[3], canonical *q)
{
    double *e = q->axis[q->rank], *f = q->axis[2], d[3] = {0};

    for (int i = q->rank; i < 3; i++)
        for (int k = 0; k < 3; k++)
            d[k] += ix__dot3(g, q->axis[i]) * q->axis[i][k];
    if (q->rank == 3 || !(ix__len3(d) > ZERO * ix__len3(g)))
        return;
    ix__unit3(d, e);
    if (q->rank == 1) {
        ix__cross3(q->axis[0], e, f);
    } else if (q->rank == 0) {
        ix__perp3(e, q->axis[1]);
        ix__cross3(e, q->axis[1], f);
    }
    q->linear[q->rank] = ix__dot3(g, e);
}

static void complete_squares(const double c[10], canonical *q)
{
    const double g[3] = {c[6], c[7], c[8]};

    memset(q->linear, 0, sizeof q->linear);
    memset(q->origin, 0, sizeof q->origin);
    q->constant = c[9];
    q->scale = fabs(c[9]);
    for (int k = 0; k < q->rank; k++) {
        double b = ix__dot3(g, q->axis[k]), at = -b / (2 * q->lambda[k]);

        ix__axpy3(q->origin, at, q->axis[k], q->origin);
        q->constant += b * at / 2;
        q->scale += fabs(b * at / 2);
    }
    turn_null_axes(g, q);
    if (q->rank < 3 && q->linear[q->rank] != 0) { /* absorbs the constant */
        ix__axpy3(q->origin, -q->constant / q->linear[q->rank],
                  q->axis[q->rank], q->origin);
        q->constant = 0;
    } else if (fabs(q->constant) <= ZERO * q->scale) {
        q->constant = 0;
    }
}

/* --- the kinds --------------------------------------------------------- */

/* Positive eigenvalues of sign s first; how many there are. */
static int positive_first(canonical *q, double s)
{
    int n = 0;

    for (int k = 0; k < q->rank; k++)
        if (s * q->lambda[k] > 0)
            swap_axes(q, n++, k);
    return n;
}

static ix_status no_surface(ix_ctx *ctx, const char *what)
{
    return IX_FAIL(ctx, IX_EDOMAIN,
                   "the equation describes %s, no surface of "
                   "one piece",
                   what);
}

/* lambda . z^2 = -constant, not 0: ellipsoid or hyperboloid. */
static ix_status central(ix_ctx *ctx, canonical *q, patch *p)
{
    double k = -q->constant, r[3];
    int positive = positive_first(q, k);

    if (positive == 0)
        return no_surface(ctx, "nothing");
    for (int i = 0; i < 3; i++)
        r[i] = sqrt(fabs(k / q->lambda[i]));
    p->u = positive == 1 ? &hyperbola : &circle;
    p->v = positive == 3 ? &circle : &hyperbola;
    p->z[0][0] = (term){r[0], 1, 1};
    p->z[1][0] = (term){r[1], 2, 1};
    p->z[2][0] = (term){r[2], 0, 2};
    return IX_OK;
}

/* lambda . z^2 = 0: both halves of a cone. */
static ix_status cone(ix_ctx *ctx, canonical *q, patch *p)
{
    int positive = positive_first(q, 1);

    if (positive == 1)
        positive = positive_first(q, -1);
    if (positive != 2)
        return no_surface(ctx, "a point");
    p->u = &circle;
    p->v = &parabola;
    p->z[0][0] = (term){sqrt(-q->lambda[2] / q->lambda[0]), 1, 1};
    p->z[1][0] = (term){sqrt(-q->lambda[2] / q->lambda[1]), 2, 1};
    p->z[2][0] = (term){1, 0, 1};
    return IX_OK;
}

/* Rank 2 without linear part: a cylinder along the third axis. */
static ix_status cylinder(ix_ctx *ctx, canonical *q, patch *p)
{
    double k = -q->constant;
    int positive = positive_first(q, k);

    if (k == 0)
        return no_surface(ctx, q->lambda[0] * q->lambda[1] > 0 ? "a line"
                                                               : "two planes");
    if (positive == 0)
        return no_surface(ctx, "nothing");
    p->u = positive == 2 ? &circle : &hyperbola;
    p->v = &parabola;
    p->z[0][0] = (term){sqrt(fabs(k / q->lambda[0])), 1, 0};
    p->z[1][0] = (term){sqrt(fabs(k / q->lambda[1])), 2, 0};
    p->z[2][0] = (term){1, 0, 1};
    return IX_OK;
}

/* The coordinate axis[rank] as a quadratic function of the others. */
static void graph(const canonical *q, patch *p)
{
    double g = q->linear[q->rank];

    p->u = p->v = &parabola;
    if (q->rank == 2) {
        p->z[0][0] = (term){1, 1, 0};
        p->z[1][0] = (term){1, 0, 1};
        p->z[2][0] = (term){-q->lambda[0] / g, 2, 0};
        p->z[2][1] = (term){-q->lambda[1] / g, 0, 2};
    } else if (q->rank == 1) {
        p->z[0][0] = (term){1, 1, 0};
        p->z[1][0] = (term){-q->lambda[0] / g, 2, 0};
        p->z[2][0] = (term){1, 0, 1};
    } else {
        p->z[1][0] = (term){1, 1, 0};
        p->z[2][0] = (term){1, 0, 1};
    }
}

static ix_status classify(ix_ctx *ctx, canonical *q, patch *p)
{
    if (q->rank < 3 && q->linear[q->rank] != 0) {
        graph(q, p);
        return IX_OK;
    }
    if (q->rank == 3)
        return q->constant != 0 ? central(ctx, q, p) : cone(ctx, q, p);
    if (q->rank == 2)
        return cylinder(ctx, q, p);
    return no_surface(ctx, q->rank == 0                     ? "all or nothing"
                           : q->constant == 0               ? "a double plane"
                           : q->constant / q->lambda[0] < 0 ? "two planes"
                                                            : "nothing");
}

/* --- result ------------------------------------------------------------ */

static double value(const patch *p, const term *t, int i, int j)
{
    return t->f != 0 ? t->f * (*p->u)[t->iu][i] * (*p->v)[t->iv][j] : 0;
}

static ix_status build(ix_ctx *ctx, const canonical *q, const patch *p,
                       ix_mv **out)
{
    const ix_dir quadratic = {.basis = IX_BEZIER, .order = 3, .length = 3};
    const ix_dir dirs[2] = {quadratic, quadratic};
    double pts[4][9];

    for (int at = 0; at < 9; at++) {
        int i = at % 3, j = at / 3;
        double w = (*p->u)[0][i] * (*p->v)[0][j], z[3] = {0};

        for (int k = 0; k < 3; k++)
            for (int n = 0; n < 3; n++)
                z[k] += value(p, &p->z[k][n], i, j);
        pts[0][at] = w;
        for (int x = 0; x < 3; x++)
            pts[1 + x][at] = w * q->origin[x] + z[0] * q->axis[0][x] +
                             z[1] * q->axis[1][x] + z[2] * q->axis[2][x];
    }
    return ix_mv_new(ctx, 2, dirs, 3, true, pts[0], out);
}

ix_status ix_srf_quadric(ix_ctx *ctx, const double coef[10], ix_mv **out)
{
    canonical q = {.rank = 0};
    patch p = {.u = NULL};

    *out = NULL;
    for (int i = 0; i < 10; i++)
        if (!isfinite(coef[i]))
            return IX_FAIL(ctx, IX_EARG, "coefficient %d is %g", i + 1,
                           coef[i]);
    principal_axes(coef, &q);
    complete_squares(coef, &q);
    IX_TRY(classify(ctx, &q, &p));
    return build(ctx, &q, &p, out);
}

/* v runs along the generators, which are parallel to z: z is an axis without
 * quadratic and linear part, and those are put last. */
static ix_status stretch(ix_ctx *ctx, const ix_mv *s, double height,
                         ix_mv **out)
{
    double z0 = ix_mv_coord(s, 2)[0] / ix_mv_weights(s)[0];
    double z1 = ix_mv_coord(s, 2)[6] / ix_mv_weights(s)[6];
    double f = height / (z1 - z0);
    const double mat[16] = {1, 0, 0, 0, 0, 1, 0,       0,
                            0, 0, f, 0, 0, 0, -f * z0, 1};

    return ix_mv_transform(ctx, s, mat, out);
}

ix_status ix_srf_conic_cylinder(ix_ctx *ctx, const double coef[6],
                                double height, ix_mv **out)
{
    const double c[10] = {coef[0], coef[2], 0,       coef[1], 0,
                          0,       coef[3], coef[4], 0,       coef[5]};
    ix_mv *s = NULL;
    ix_status st;

    *out = NULL;
    if (!(fabs(height) > 0 && isfinite(height)))
        return IX_FAIL(ctx, IX_EARG, "height %g of a cylinder", height);
    IX_TRY(ix_srf_quadric(ctx, c, &s));
    st = stretch(ctx, s, height, out);
    ix_mv_unref(ctx, s);
    return st;
}
