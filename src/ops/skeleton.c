/* skeleton.c - points of the plane equally far from three points and curves.
 *
 * A circle (a, b, e), a in two coordinates, that passes through the points and
 * touches the curves is orthogonal to their rows of contact: three of them
 * determine it, every further one is an equation between the feet. */
#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "iritx/ops_mbisect.h"
#include "ops/contact.h"

enum { MAX_FIELDS = 3 };

typedef struct {
    const ix_mv *m[3]; /* points first */
    double q[3][2];
    int points, order[3]; /* where the user has them */
    double extent, eps;
    int n;
    ix_skeleton_point *p; /* in scratch, room for one more */
} skeleton;

/* The equations: determinants of four rows. */
static int rows_of(int points, ix_contact_row rows[MAX_FIELDS][4])
{
    static const ix_contact_row two[1][4] = {{{0, 0}, {1, 0}, {2, 0}, {2, 1}}},
                                one[2][4] = {{{0, 0}, {1, 0}, {1, 1}, {2, 0}},
                                             {{0, 0}, {1, 0}, {1, 1}, {2, 1}}},
                                none[3][4] = {{{0, 0}, {0, 1}, {1, 0}, {1, 1}},
                                              {{0, 0}, {0, 1}, {1, 0}, {2, 0}},
                                              {{0, 0}, {0, 1}, {1, 0}, {2, 1}}};

    memcpy(rows,
           points == 2   ? two
           : points == 1 ? (const void *)one
                         : (const void *)none,
           (size_t)(3 - points) * sizeof rows[0]);
    return 3 - points;
}

static void add_line(const double d[3], const double at[3], double (*r)[3],
                     double *h, int *n)
{
    if (!(ix__unit3(d, r[*n]) > 0))
        return;
    h[*n] = ix__dot3(r[*n], at);
    ++*n;
}

/* The centre over three feet, by normals and lines between feet. */
static bool centre_of(double foot[3][3], double d[3][2][3], double c[3])
{
    double r[6][3], h[6], e[3], mid[3];
    int n = 0;

    for (int i = 0; i < 3; i++)
        add_line(d[i][0], foot[i], r, h, &n);
    for (int i = 0; i < 3; i++) {
        ix__sub3(foot[(i + 1) % 3], foot[i], e);
        ix__axpy3(foot[i], 0.5, e, mid);
        add_line(e, mid, r, h, &n);
    }
    return n >= 2 && ix__meet_planes(2, n, r, h, c);
}

/* Equal distances, and at right angles to the tangents. */
static bool holds(const skeleton *s, double foot[3][3], double d[3][2][3],
                  const double c[3])
{
    double first = ix__dist3(c, foot[0]), u[3], v[3];

    if (!(hypot(c[0], c[1]) <= s->extent))
        return false;
    for (int i = 0; i < 3; i++) {
        double dist = ix__dist3(c, foot[i]);

        if (!(fabs(dist - first) <= s->eps))
            return false;
        ix__sub3(c, foot[i], v);
        if (ix__unit3(d[i][0], u) > 0 &&
            !(fabs(ix__dot3(u, v)) <= s->eps + 1e-7 * dist))
            return false;
    }
    return true;
}

/* A solution at the seam of a closed curve, or at a knot, comes twice. */
static bool is_new(const skeleton *s)
{
    const ix_skeleton_point *p = &s->p[s->n];

    for (int i = 0; i < s->n; i++) {
        const ix_skeleton_point *o = &s->p[i];
        double gap = hypot(p->center[0] - o->center[0],
                           p->center[1] - o->center[1]);

        for (int k = 0; k < 3; k++)
            gap = fmax(gap, hypot(p->foot[k][0] - o->foot[k][0],
                                  p->foot[k][1] - o->foot[k][1]));
        if (gap <= 1e-7 * (p->radius + o->radius))
            return false;
    }
    return true;
}

static ix_status add(ix_ctx *ctx, skeleton *s, const ix_contacts *c,
                     const double *x)
{
    double foot[3][3] = {{0}}, d[3][2][3] = {{{0}}}, at[3] = {0, 0, 0};
    ix_skeleton_point *p = &s->p[s->n];
    bool ok = true;

    for (int i = 0; i < 3 && ok; i++) {
        if (s->m[i])
            IX_TRY(ix__contact_foot(ctx, c, i, x, foot[i], d[i], &ok));
        else
            memcpy(foot[i], s->q[i], sizeof s->q[i]);
    }
    if (!ok || !centre_of(foot, d, at) || !holds(s, foot, d, at))
        return IX_OK;
    p->radius = ix__dist3(at, foot[0]);
    for (int i = 0; i < 3; i++)
        memcpy(p->foot[s->order[i]], foot[i], sizeof p->foot[0]);
    memcpy(p->center, at, sizeof p->center);
    s->n += is_new(s);
    return IX_OK;
}

/* --- solving
 * -------------------------------------------------------------------- */

static ix_status room(ix_ctx *ctx, skeleton *s, int n)
{
    IX_SCRATCH(ctx, s->p, (size_t)n + 1);
    return IX_OK;
}

static ix_status one_unknown(ix_ctx *ctx, skeleton *s, const ix_contacts *c,
                             const ix_mv *f)
{
    ix_root *r;
    ix_status st;
    int n;

    IX_TRY(ix_roots(ctx, f, 0, NULL, &r, &n));
    st = room(ctx, s, n);
    for (int i = 0; st == IX_OK && i < n; i++)
        if (r[i].kind != IX_ROOT_JUMP && r[i].kind != IX_ROOT_INTERVAL)
            st = add(ctx, s, c, &r[i].t);
    ix_roots_free(ctx, r, n);
    return st;
}

static ix_status more_unknowns(ix_ctx *ctx, skeleton *s, const ix_contacts *c,
                               int n, ix_mv *const *f, bool *complete)
{
    ix_equation eq[MAX_FIELDS];
    ix_solutions sol;
    ix_status st;

    for (int i = 0; i < n; i++)
        eq[i] = (ix_equation){f[i], 0, IX_EQUAL_ZERO};
    IX_TRY(ix_solve(ctx, n, eq, NULL, &sol));
    *complete = sol.complete;
    st = room(ctx, s, sol.n);
    for (int i = 0; st == IX_OK && i < sol.n; i++)
        st = add(ctx, s, c, sol.sol[i].x);
    ix_solutions_free(ctx, &sol);
    return st;
}

static ix_status solve(ix_ctx *ctx, skeleton *s, bool *complete)
{
    ix_contact_row rows[MAX_FIELDS][4];
    int n = rows_of(s->points, rows);
    ix_mv *f[MAX_FIELDS] = {NULL};
    ix_contacts c;
    ix_status st = IX_OK;

    IX_TRY(ix__contacts_of(ctx, 3, s->m, s->q[0], 2, &c));
    for (int i = 0; i < n && st == IX_OK; i++)
        st = ix__contact_det(ctx, &c, rows[i], &f[i]);
    if (st == IX_OK)
        st = n == 1 ? one_unknown(ctx, s, &c, f[0])
                    : more_unknowns(ctx, s, &c, n, f, complete);
    for (int i = 0; i < n; i++)
        ix_mv_unref(ctx, f[i]);
    return st;
}

/* --- entry
 * ---------------------------------------------------------------------- */

/* Points before curves. */
static ix_status sort(ix_ctx *ctx, const ix_mv *const m[3],
                      const double q[3][2], skeleton *s)
{
    int n = 0;

    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < 3; i++) {
            if ((m[i] != NULL) != pass)
                continue;
            if (m[i] && (m[i]->ndirs != 1 || m[i]->ncoords < 2))
                return IX_FAIL(ctx, IX_EARG,
                               "operand %d has %d directions and %d "
                               "coordinates: a planar curve is needed",
                               i + 1, m[i]->ndirs, m[i]->ncoords);
            s->m[n] = m[i];
            memcpy(s->q[n], q[i], sizeof s->q[n]);
            s->order[n++] = i;
            s->points += !m[i];
        }
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, const ix_mv *const m[3], const double q[3][2],
                     skeleton *s, ix_skeleton_point **out, bool *complete)
{
    IX_TRY(sort(ctx, m, q, s));
    if (s->points == 3) {
        IX_TRY(room(ctx, s, 1));
        IX_TRY(add(ctx, s, NULL, NULL));
    } else {
        IX_TRY(solve(ctx, s, complete));
    }
    if (s->n == 0)
        return IX_OK;
    *out = ix__alloc(ctx, (size_t)s->n * sizeof **out);
    if (!*out)
        return IX_ENOMEM;
    memcpy(*out, s->p, (size_t)s->n * sizeof **out);
    return IX_OK;
}

ix_status ix_skeleton_points(ix_ctx *ctx, const ix_mv *const m[3],
                             const double q[3][2], double extent, double eps,
                             ix_skeleton_point **out, int *n, bool *complete)
{
    skeleton s = {.extent = extent, .eps = eps};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    *out = NULL;
    *n = 0;
    *complete = true;
    if (!(extent > 0.0) || !(eps > 0.0))
        return IX_FAIL(ctx, IX_EARG,
                       "an extent of %g and a tolerance of %g must be positive",
                       extent, eps);
    st = run(ctx, m, q, &s, out, complete);
    ix__scratch_release(ctx, mk);
    if (st == IX_OK)
        *n = s.n;
    return st;
}

void ix_skeleton_points_free(ix_ctx *ctx, ix_skeleton_point *p, int n)
{
    ix__free(ctx, p, (size_t)n * sizeof *p);
}
