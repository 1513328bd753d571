/* mbisector.c - bisectors of curves and surfaces by equations (ops_mbisect.h).
 */
#include <math.h>
#include <string.h>

#include "bern/bern.h"
#include "geom/vec3.h"
#include "iritx/ops_mbisect.h"
#include "ops/contact.h"

/* --- fields -----------------------------------------------------------------
 */

/* Curves before surfaces. */
static ix_status pair_of(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                         const ix_mv *m[2])
{
    bool swap = a->ndirs == 2 && b->ndirs == 1;

    m[0] = swap ? b : a;
    m[1] = swap ? a : b;
    for (int i = 0; i < 2; i++)
        if (m[i]->ndirs < 1 || m[i]->ndirs > 2 || m[i]->ncoords < 2 ||
            m[i]->ncoords > 3)
            return IX_FAIL(ctx, IX_EARG,
                           "%d directions and %d coordinates: curves and "
                           "surfaces with 2 or 3 coordinates are needed",
                           m[i]->ndirs, m[i]->ncoords);
    if (m[1]->ndirs == 1)
        return IX_FAIL(ctx, IX_EARG,
                       "two curves have a rational bisector surface; a surface "
                       "is needed");
    return IX_OK;
}

/* Full contact with both, or with the first and one derivative of the other. */
static ix_status fields(ix_ctx *ctx, const ix_contacts *c, ix_mv *out[2],
                        int *n)
{
    static const ix_contact_row mixed[5] = {
        {0, 0}, {0, 1}, {1, 0}, {1, 1}, {1, 2}};
    static const ix_contact_row both[2][5] = {
        {{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}},
        {{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 2}}};

    *n = c->at[0].m->ndirs;
    if (*n == 1)
        return ix__contact_det(ctx, c, mixed, &out[0]);
    IX_TRY(ix__contact_det(ctx, c, both[0], &out[0]));
    if (ix__contact_det(ctx, c, both[1], &out[1]) == IX_OK)
        return IX_OK;
    ix_mv_unref(ctx, out[0]);
    out[0] = NULL;
    return IX_ENOMEM;
}

static ix_status fields_of(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                           ix_mv *out[2], int *n)
{
    const ix_mv *m[2];
    ix_contacts c;

    IX_TRY(pair_of(ctx, a, b, m));
    IX_TRY(ix__contacts_of(ctx, 2, m, NULL, 3, &c));
    return fields(ctx, &c, out, n);
}

ix_status ix_mbisector_fields(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                              ix_mv *out[2], int *n)
{
    out[0] = out[1] = NULL;
    *n = 0;
    IX_RETURN_SCOPED(ctx, fields_of(ctx, a, b, out, n));
}

/* --- rational ones
 * ------------------------------------------------------------ */

/* The centre -a / (2 e) of the sphere (a, b, e), in the user's frame. */
static ix_status centre(ix_ctx *ctx, const ix_contacts *c, const ix_form *m,
                        ix_mv **out)
{
    ix_form w, all, x = ix__form_rows(m, 0, c->dim),
                    e = ix__form_rows(m, c->dim + 1, 1);
    const ix_form *parts[2] = {&w, &x};
    double sum = 0.0;
    int exp = 0;

    IX_TRY(ix__form_copy(ctx, &e, &w));
    ix__form_times(&w, -2.0);
    IX_TRY(ix__form_join(ctx, 2, parts, &all));
    for (size_t i = 0; i < all.n; i++)
        sum += all.c[i];
    (void)frexp(ix__bern_largest(all.n, all.c), &exp);
    ix__form_times(&all, ldexp(sum < 0.0 ? -1.0 : 1.0, -exp));
    ix__frame_back(&c->frame, 1.0, all.n, all.c, all.c + all.n);
    return ix__form_store(ctx, &all, true, NULL, out);
}

/* What rounding leaves of determinants of six rows that should vanish. */
#define FLAT 1e-12

static ix_status exact(ix_ctx *ctx, const ix_mv *const *m, int dim, ix_mv **out)
{
    ix_contact_row rows[IX_MAX_COORDS];
    ix_form minors, e, x;
    double big, size;
    ix_contacts c;
    int n = 0;

    IX_TRY(ix__contacts_of(ctx, 2, m, NULL, dim, &c));
    for (int i = 0; i < 2; i++)
        for (int r = 0; r < c.at[i].nrows; r++)
            rows[n++] = (ix_contact_row){i, r};
    IX_TRY(ix__contact_minors(ctx, &c, rows, &minors));
    e = ix__form_rows(&minors, dim + 1, 1);
    x = ix__form_rows(&minors, 0, dim + 1);
    IX_TRY(ix__form_bound(ctx, &e, &big));
    IX_TRY(ix__form_bound(ctx, &x, &size));
    if (!(big > FLAT * size))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "both lie in one hyperplane: the weight is at most %.3g "
                       "of its terms",
                       size > 0.0 ? big / size : 0.0);
    return centre(ctx, &c, &minors, out);
}

ix_status ix_mbisector_exact(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                             ix_mv **out)
{
    const ix_mv *m[2] = {a, b};
    int dim = a->ndirs + b->ndirs + 1;

    *out = NULL;
    for (int i = 0; i < 2; i++)
        if (m[i]->ndirs < 1 || m[i]->ndirs > 2 || m[i]->ncoords != dim)
            return IX_FAIL(ctx, IX_EARG,
                           "operand %d has %d directions and %d coordinates: "
                           "two curves have a rational bisector in R^3, a "
                           "curve and a surface in R^4, two surfaces in R^5",
                           i + 1, m[i]->ndirs, m[i]->ncoords);
    IX_RETURN_SCOPED(ctx, exact(ctx, m, dim, out));
}

/* --- points
 * ------------------------------------------------------------------- */

typedef struct {
    ix_contacts c;
    ix_mv *f[2];
    int nf, n, cap;
    ix_bisector_point *p;
} search;

static ix_status add_point(ix_ctx *ctx, search *s, const ix_bisector_point *p)
{
    int cap = s->cap ? 2 * s->cap : 64;
    ix_bisector_point *grown;

    if (s->n == s->cap) {
        grown = ix__alloc(ctx, (size_t)cap * sizeof *grown);
        if (!grown)
            return IX_ENOMEM;
        if (s->n > 0)
            memcpy(grown, s->p, (size_t)s->n * sizeof *grown);
        ix__free(ctx, s->p, (size_t)s->cap * sizeof *grown);
        s->p = grown;
        s->cap = cap;
    }
    s->p[s->n++] = *p;
    return IX_OK;
}

/* r[k].p = h[k] from a direction and a point, of length 1. */
static int plane_row(const double *d, const double *at, double *r, double *h)
{
    if (!(ix__unit3(d, r) > 0))
        return 0;
    *h = ix__dot3(r, at);
    return 1;
}

/* The centre over feet on both; false if the planes do not meet in a point, or
 * the feet are one. */
static bool centre_of(double foot[2][3], double d[2][2][3], double p[3])
{
    double r[5][3], h[5], e[3], mid[3], a, b;
    int n = 0;

    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
            n += plane_row(d[i][k], foot[i], r[n], &h[n]);
    ix__sub3(foot[1], foot[0], e);
    ix__axpy3(foot[0], 0.5, e, mid);
    n += plane_row(e, mid, r[n], &h[n]);
    if (!ix__meet_planes(3, n, r, h, p))
        return false;
    a = ix__dist3(p, foot[0]);
    b = ix__dist3(p, foot[1]);
    /* solutions of the equations with coinciding feet are no spheres */
    return fabs(a - b) <= 1e-7 * (a + b) &&
           ix__len3(e) > 1e-9 * (a + b + ix__len3(foot[0]));
}

/* x: all parameters in [0, 1]; the surface with the grid is object g. */
static ix_status found(ix_ctx *ctx, search *s, int g, const double *x)
{
    double foot[2][3], d[2][2][3];
    ix_bisector_point p;
    bool ok[2];

    for (int i = 0; i < 2; i++)
        IX_TRY(ix__contact_foot(ctx, &s->c, i, x, foot[i], d[i], &ok[i]));
    memset(&p, 0, sizeof p);
    if (!ok[0] || !ok[1] || !centre_of(foot, d, p.x))
        return IX_OK;
    for (int i = 0; i < 2; i++) {
        const ix_contact *k = &s->c.at[i];

        for (int j = 0; j < k->m->ndirs; j++)
            (i == g ? p.uv : p.on)[j] = k->dom[j][0] +
                                        x[k->start + j] *
                                            (k->dom[j][1] - k->dom[j][0]);
    }
    return add_point(ctx, s, &p);
}

/* The curve's parameters where the surface's are (u, v). */
static ix_status on_curve(ix_ctx *ctx, search *s, double u, double v)
{
    ix_mv *fu, *f;
    ix_root *r;
    ix_status st;
    int n;

    IX_TRY(ix_mv_fix(ctx, s->f[0], 1, u, &fu));
    st = ix_mv_fix(ctx, fu, 1, v, &f);
    ix_mv_unref(ctx, fu);
    IX_TRY(st);
    st = ix_roots(ctx, f, 0, NULL, &r, &n);
    ix_mv_unref(ctx, f);
    IX_TRY(st);
    for (int i = 0; st == IX_OK && i < n; i++) {
        double x[3] = {r[i].t, u, v};

        if (r[i].kind != IX_ROOT_JUMP && r[i].kind != IX_ROOT_INTERVAL)
            st = found(ctx, s, 1, x);
    }
    ix_roots_free(ctx, r, n);
    return st;
}

/* The second surface's parameters where the first one's are (u, v). */
static ix_status on_surface(ix_ctx *ctx, search *s, double u, double v)
{
    ix_mv *fu[2] = {NULL, NULL}, *f[2] = {NULL, NULL};
    ix_equation eq[2];
    ix_solutions sol = {0};
    ix_status st = IX_OK;

    for (int i = 0; i < 2 && st == IX_OK; i++) {
        st = ix_mv_fix(ctx, s->f[i], 0, u, &fu[i]);
        if (st == IX_OK)
            st = ix_mv_fix(ctx, fu[i], 0, v, &f[i]);
        eq[i] = (ix_equation){f[i], 0, IX_EQUAL_ZERO};
    }
    if (st == IX_OK)
        st = ix_solve(ctx, 2, eq, NULL, &sol);
    for (int i = 0; st == IX_OK && i < sol.n; i++) {
        double x[4] = {u, v, sol.sol[i].x[0], sol.sol[i].x[1]};

        st = found(ctx, s, 0, x);
    }
    ix_solutions_free(ctx, &sol);
    for (int i = 0; i < 2; i++) {
        ix_mv_unref(ctx, fu[i]);
        ix_mv_unref(ctx, f[i]);
    }
    return st;
}

static ix_status points(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, int n,
                        search *s)
{
    const ix_mv *m[2];
    ix_status st;

    IX_TRY(pair_of(ctx, a, b, m));
    IX_TRY(ix__contacts_of(ctx, 2, m, NULL, 3, &s->c));
    IX_TRY(fields(ctx, &s->c, s->f, &s->nf));
    st = IX_OK;
    for (int i = 0; st == IX_OK && i < (n + 1) * (n + 1); i++) {
        double u = (double)(i % (n + 1)) / n, v = (double)(i / (n + 1)) / n;

        st = ix__poll(ctx);
        if (st == IX_OK)
            st = s->nf == 1 ? on_curve(ctx, s, u, v) : on_surface(ctx, s, u, v);
    }
    for (int i = 0; i < 2; i++)
        ix_mv_unref(ctx, s->f[i]);
    return st;
}

/* As many places as there are points. */
static ix_status settle(ix_ctx *ctx, search *s)
{
    ix_bisector_point *p;
    size_t size = (size_t)s->n * sizeof *p;

    if (s->n == 0)
        return IX_OK;
    p = ix__alloc(ctx, size);
    if (!p)
        return IX_ENOMEM;
    memcpy(p, s->p, size);
    ix__free(ctx, s->p, (size_t)s->cap * sizeof *p);
    s->p = p;
    s->cap = s->n;
    return IX_OK;
}

static ix_status points_of(ix_ctx *ctx, const ix_mv *a, const ix_mv *b, int n,
                           ix_bisector_point **out, int *count)
{
    search s = {.n = 0};
    ix_status st = points(ctx, a, b, n, &s);

    if (st == IX_OK)
        st = settle(ctx, &s);
    if (st != IX_OK) {
        ix__free(ctx, s.p, (size_t)s.cap * sizeof *s.p);
        return st;
    }
    *out = s.p;
    *count = s.n;
    return IX_OK;
}

ix_status ix_mbisector_points(ix_ctx *ctx, const ix_mv *a, const ix_mv *b,
                              int n, ix_bisector_point **out, int *count)
{
    *out = NULL;
    *count = 0;
    if (n < 1 || n > 256)
        return IX_FAIL(ctx, IX_EARG, "a grid of %d is not in 1 .. 256", n);
    IX_RETURN_SCOPED(ctx, points_of(ctx, a, b, n, out, count));
}

void ix_bisector_points_free(ix_ctx *ctx, ix_bisector_point *p, int count)
{
    ix__free(ctx, p, (size_t)count * sizeof *p);
}
