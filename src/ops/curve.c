/* curve.c - the curve in its frame: Wronskians by rows of one degree, error
 * bounds span by span. */
#include "ops/curve.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "bern/bern.h"

/* --- extents ------------------------------------------------------------ */

ix_status ix__extents(ix_ctx *ctx, const ix_form *f, const double *error,
                      ix_extent **out)
{
    int nspans = f->dirs[0].nspans;
    size_t m = (size_t)f->dirs[0].degree + 1;
    const double *b;
    ix_extent *e;

    IX_SCRATCH(ctx, e, nspans);
    IX_TRY(ix__form_bernstein(ctx, f, &b));
    for (int j = 0; j < nspans; j++) {
        double size = 0.0;

        for (int r = 0; r < f->nrows; r++)
            size = fmax(size, ix__bern_largest(m, b + (size_t)r * f->n +
                                                      (size_t)j * m));
        e[j] = (ix_extent){size, error ? error[j] : 0.0};
    }
    *out = e;
    return IX_OK;
}

ix_extent ix__extent_mul(ix_extent a, ix_extent b, int degree)
{
    double size = a.size * b.size;

    /* a sum of up to degree + 1 products for each coefficient, up to three
     * rows to a sum */
    return (ix_extent){size, a.size * b.error + a.error * b.size +
                                 a.error * b.error +
                                 4.0 * DBL_EPSILON * (degree + 2) * size};
}

ix_extent ix__extent_add(ix_extent a, ix_extent b)
{
    return (ix_extent){a.size + b.size, a.error + b.error};
}

bool ix__extent_is_zero(ix_extent e)
{
    return !(e.size > e.error);
}

bool ix__extents_zero(const ix_form *f, const ix_extent *e)
{
    for (int j = 0; j < f->dirs[0].nspans; j++)
        if (!ix__extent_is_zero(e[j]))
            return false;
    return true;
}

/* The extent of the form itself with the error that its terms have. */
static ix_status settle(ix_ctx *ctx, const ix_form *f, const ix_extent *terms,
                        ix_extent **out)
{
    IX_TRY(ix__extents(ctx, f, NULL, out));
    for (int j = 0; j < f->dirs[0].nspans; j++)
        (*out)[j].error = terms[j].error;
    return IX_OK;
}

/* --- Wronskians --------------------------------------------------------- */

enum { MAX_ROWS = 4 };

/* Rows j = 0 .. k of a Wronskian, and the extents of each on each span, for a
 * form whose coefficients are known to within error. */
typedef struct {
    int k;
    double factor;
    ix_form row[MAX_ROWS];
    ix_extent *e[MAX_ROWS];
} wronskian;

/* 1 / prod (d - i)^(i + 1); 0 if the Wronskian vanishes for want of degree. */
static double wronskian_factor(int d, int k)
{
    double f = 1.0;

    if (d < k)
        return 0.0;
    for (int i = 0; i < k; i++)
        for (int j = 0; j <= i; j++)
            f /= d - i;
    return f;
}

static ix_status row_extents(ix_ctx *ctx, const ix_form *f, int j,
                             const double *error, wronskian *w)
{
    const ix_spans *sp = &f->dirs[0];
    double up = 1.0;

    IX_TRY(ix__extents(ctx, &w->row[j], NULL, &w->e[j]));
    for (int i = 0; i < w->k; i++)
        up *= sp->degree > i ? sp->degree - i : 1;
    for (int s = 0; s < sp->nspans; s++)
        w->e[j][s].error = up * error[s] *
                           pow(2.0 / (sp->breaks[s + 1] - sp->breaks[s]), j);
    return IX_OK;
}

static ix_status wronskian_rows(ix_ctx *ctx, const ix_form *f, int k,
                                const double *error, wronskian *w)
{
    ix_form d = *f;

    w->k = k;
    w->factor = wronskian_factor(f->dirs[0].degree, k);
    for (int j = 0; j <= k; j++) {
        if (j > 0)
            IX_TRY(ix__form_derive(ctx, &d, 0, &d));
        w->row[j] = d;
        for (int i = j; i < k; i++)
            IX_TRY(ix__form_partial(ctx, &w->row[j], 0, IX__V, &w->row[j]));
        IX_TRY(row_extents(ctx, f, j, error, w));
    }
    return IX_OK;
}

/* The rows of w that belong to columns first .. first + count - 1. */
static void columns(const wronskian *w, int first, int count, ix_form *out)
{
    for (int j = 0; j <= w->k; j++)
        out[j] = ix__form_rows(&w->row[j], first, count);
}

/* Product of the extents of all rows. */
static ix_status wronskian_extents(ix_ctx *ctx, const wronskian *w,
                                   const ix_form *f, ix_extent **out)
{
    ix_extent *terms;

    IX_SCRATCH(ctx, terms, f->dirs[0].nspans);
    for (int s = 0; s < f->dirs[0].nspans; s++) {
        terms[s] = w->e[0][s];
        for (int j = 1; j <= w->k; j++)
            terms[s] = ix__extent_mul(terms[s], w->e[j][s], f->dirs[0].degree);
        terms[s].error *= w->factor * (w->k > 2 ? 6.0 : 2.0);
    }
    return settle(ctx, f, terms, out);
}

/* --- D, V, T ------------------------------------------------------------ */

/* Rounding of a coefficient in the frame: of the input, of the shift, of the
 * decomposition; of the derivative's coefficients if polynomial. */
static ix_status coefficient_errors(ix_ctx *ctx, const ix_curve *c,
                                    double **out)
{
    const ix_spans *sp = &c->p.dirs[0];
    double e = c->frame.noise + DBL_EPSILON * (c->degree + 2);

    IX_SCRATCH(ctx, *out, sp->nspans);
    for (int j = 0; j < sp->nspans; j++)
        (*out)[j] = c->rational ? e
                                : 2.0 * c->degree * e /
                                      (sp->breaks[j + 1] - sp->breaks[j]);
    return IX_OK;
}

/* a_0 x b_1 of two rows in the plane (one row), or the vector product. */
static ix_status cross(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                       ix_form *out)
{
    static const ix_form_term plane[2] = {{0, 0, 1, 1}, {0, 1, 0, -1}};

    if (a->nrows == 2)
        return ix__form_bilinear(ctx, a, b, 1, 2, plane, out);
    return ix__form_cross(ctx, a, b, out);
}

static ix_status polynomial_parts(ix_ctx *ctx, bool all, ix_curve *c)
{
    wronskian w;
    double *error;

    IX_TRY(coefficient_errors(ctx, c, &error));
    IX_TRY(ix__form_derive(ctx, &c->p, 0, &c->d));
    IX_TRY(ix__extents(ctx, &c->d, error, &c->ed));
    if (!all)
        return IX_OK;
    IX_TRY(wronskian_rows(ctx, &c->d, 1, error, &w));
    IX_TRY(cross(ctx, &w.row[0], &w.row[1], &c->v));
    ix__form_times(&c->v, w.factor);
    return wronskian_extents(ctx, &w, &c->v, &c->ev);
}

/* w_0 (p_1 x p_2) + p_0 x (w_2 p_1 - w_1 p_2). */
static ix_status rational_normal(ix_ctx *ctx, const wronskian *w, int dim,
                                 ix_form *out)
{
    ix_form x[3], g[3], b, c, e;
    const ix_form *pw[2], *pp[2];

    columns(w, 0, 1, g);
    columns(w, 1, dim, x);
    pp[0] = &x[1], pp[1] = &x[2];
    pw[0] = &g[1], pw[1] = &g[2];
    IX_TRY(ix__form_bracket(ctx, pp, pw, &b)); /* p_1 w_2 - p_2 w_1 */
    IX_TRY(cross(ctx, &x[0], &b, &c));
    IX_TRY(cross(ctx, &x[1], &x[2], &e));
    IX_TRY(ix__form_mul(ctx, &e, &g[0], out));
    IX_TRY(ix__form_add(ctx, out, 1, &c, out));
    ix__form_times(out, w->factor);
    return IX_OK;
}

static ix_status rational_parts(ix_ctx *ctx, bool all, ix_curve *c)
{
    const ix_form *parts[2] = {&c->w, &c->local};
    ix_form wp, x[2], g[2];
    const ix_form *px[2] = {&x[1], &x[0]}, *pg[2] = {&g[1], &g[0]};
    wronskian w;
    double *error;

    IX_TRY(coefficient_errors(ctx, c, &error));
    IX_TRY(ix__form_join(ctx, 2, parts, &wp));
    IX_TRY(wronskian_rows(ctx, &wp, 1, error, &w));
    columns(&w, 0, 1, g);
    columns(&w, 1, c->dim, x);
    IX_TRY(ix__form_bracket(ctx, px, pg, &c->d)); /* p' w_V - p_V w' */
    ix__form_times(&c->d, w.factor);
    IX_TRY(wronskian_extents(ctx, &w, &c->d, &c->ed));
    if (!all)
        return IX_OK;
    IX_TRY(wronskian_rows(ctx, &wp, 2, error, &w));
    IX_TRY(rational_normal(ctx, &w, c->dim, &c->v));
    return wronskian_extents(ctx, &w, &c->v, &c->ev);
}

ix_status ix__curve_torsion(ix_ctx *ctx, const ix_curve *c, ix_form *t,
                            ix_extent **et)
{
    const ix_form *parts[2] = {&c->local, &c->w}, *rows[MAX_ROWS];
    int k = c->rational ? 3 : 2;
    double *error;
    wronskian w;
    ix_form f;

    IX_TRY(coefficient_errors(ctx, c, &error));
    if (c->rational)
        IX_TRY(ix__form_join(ctx, 2, parts, &f));
    else
        f = c->d;
    IX_TRY(wronskian_rows(ctx, &f, k, error, &w));
    for (int j = 0; j <= k; j++)
        rows[j] = &w.row[j];
    IX_TRY(ix__form_det(ctx, k + 1, rows, t));
    ix__form_times(t, c->rational ? -w.factor : w.factor);
    return wronskian_extents(ctx, &w, t, et);
}

/* --- slopes ------------------------------------------------------------- */

/* A' B_V - A_V B' = b A'B - a A B' in degree a + b - 2. */
static ix_status jacobian(ix_ctx *ctx, const ix_form *a, const ix_form *b,
                          ix_form *out)
{
    ix_form da, db, va, vb;
    const ix_form *pa[2] = {&da, &va}, *pb[2] = {&db, &vb};

    IX_TRY(ix__form_derive(ctx, a, 0, &da));
    IX_TRY(ix__form_derive(ctx, b, 0, &db));
    IX_TRY(ix__form_partial(ctx, a, 0, IX__V, &va));
    IX_TRY(ix__form_partial(ctx, b, 0, IX__V, &vb));
    return ix__form_bracket(ctx, pa, pb, out);
}

static ix_status polynomial_slope(ix_ctx *ctx, const ix_curve *c,
                                  const ix_form *a, int power, ix_form *out)
{
    ix_form da, dq, t;

    IX_TRY(ix__form_derive(ctx, &c->q, 0, &dq));
    IX_TRY(ix__form_mul(ctx, a, &dq, &t));
    ix__form_times(&t, -1.5 * power);
    if (a->dirs[0].degree == 0) {
        *out = t;
        return IX_OK;
    }
    IX_TRY(ix__form_derive(ctx, a, 0, &da));
    IX_TRY(ix__form_mul(ctx, &da, &c->q, out));
    return ix__form_add(ctx, out, 1, &t, out);
}

ix_status ix__curve_slope(ix_ctx *ctx, const ix_curve *c, const ix_form *a,
                          int power, ix_form *out)
{
    int b = c->q.dirs[0].degree;
    ix_form j, t;

    if (!c->rational)
        return polynomial_slope(ctx, c, a, power, out);
    IX_TRY(jacobian(ctx, &c->w, &c->q, &j));
    IX_TRY(ix__form_mul(ctx, a, &j, &t));
    ix__form_times(&t, b > 0 ? 3.0 * power / b : 0.0);
    if (a->dirs[0].degree == 0) {
        *out = t;
        return IX_OK;
    }
    IX_TRY(jacobian(ctx, a, &c->q, &j));
    IX_TRY(ix__form_mul(ctx, &j, &c->w, out));
    ix__form_times(out, b > 0 ? 1.0 / b : 0.0);
    return ix__form_add(ctx, out, 1, &t, out);
}

/* --- loading ------------------------------------------------------------ */

/* On each span p - x0 w, x0 the projected middle control point of the span
 * (0 where its weight is). */
static ix_status recentre(ix_ctx *ctx, ix_curve *c)
{
    size_t m = (size_t)c->degree + 1, mid = m / 2;

    IX_TRY(ix__form_copy(ctx, &c->p, &c->local));
    for (int j = 0; j < c->p.dirs[0].nspans; j++)
        for (int r = 0; r < c->dim; r++) {
            double *x = c->local.c + (size_t)r * c->p.n + (size_t)j * m;
            const double *w = c->w.c + (size_t)j * m;
            double x0 = x[mid] / w[mid];

            for (size_t i = 0; isfinite(x0) && i < m; i++)
                x[i] = fma(-x0, w[i], x[i]);
        }
    return IX_OK;
}

/* True if the third coordinate is one number; *z receives it. */
static bool in_plane(const ix_mv *m, double *z)
{
    const double *w = ix_mv_weights(m), *c = ix_mv_coord(m, 2);
    size_t at = 0, n = ix_mv_npts(m);

    while (w && at < n && w[at] == 0.0)
        at++;
    *z = at < n ? c[at] / (w ? w[at] : 1.0) : 0.0;
    for (size_t i = 0; i < n; i++)
        if (c[i] != *z * (w ? w[i] : 1.0))
            return false;
    return true;
}

static ix_status speed(ix_ctx *ctx, ix_curve *c)
{
    IX_TRY(ix__form_dot(ctx, &c->d, &c->d, &c->q));
    IX_TRY(ix__extents(ctx, &c->q, NULL, &c->eq));
    for (int j = 0; j < c->q.dirs[0].nspans; j++)
        c->eq[j].error =
            ix__extent_mul(c->ed[j], c->ed[j], c->q.dirs[0].degree).error * 3.0;
    return IX_OK;
}

/* With an origin at, w, p and D only. */
static ix_status load_forms(ix_ctx *ctx, const ix_mv *m, const double *at,
                            ix_curve *c)
{
    static const double one = 1.0;
    ix_form f;
    int r = m->rational;

    IX_TRY(ix__frame_of(ctx, 1, &m, &c->frame));
    c->centred = at && ix__frame_centre(&c->frame, c->dim, at);
    IX_TRY(ix__forms_load(ctx, 1, &m, &c->frame, &f));
    c->rational = r;
    c->degree = f.dirs[0].degree;
    c->p = ix__form_rows(&f, r, c->dim);
    if (r) {
        c->w = ix__form_rows(&f, 0, 1);
        (void)frexp(ix__bern_largest(m->npts, ix_mv_weights(m)), &c->wexp);
        IX_TRY(recentre(ctx, c));
    } else {
        IX_TRY(ix__form_constant(ctx, &f, 1, &one, &c->w));
        c->local = c->p;
    }
    IX_TRY(ix__extents(ctx, &c->w, NULL, &c->ew));
    for (int j = 0; j < f.dirs[0].nspans; j++)
        c->ew[j].error = r ? DBL_EPSILON * (c->degree + 2) : 0.0;
    IX_TRY(r ? rational_parts(ctx, !at, c) : polynomial_parts(ctx, !at, c));
    return at ? IX_OK : speed(ctx, c);
}

/* All weights are one number other than 0. */
static bool constant_weight(const ix_mv *m)
{
    const double *w = ix_mv_weights(m);

    for (size_t i = 1; i < ix_mv_npts(m); i++)
        if (w[i] != w[0])
            return false;
    return w[0] != 0.0;
}

static ix_status load(ix_ctx *ctx, const ix_mv *crv, ix__curve_kind kind,
                      const double *at, bool simplify, ix_curve *out)
{
    ix_curve c = {.dim = crv->ncoords, .ncoords = crv->ncoords};
    bool rational = crv->rational;
    ix_mv *m;
    ix_status st;

    if (crv->ndirs != 1)
        return IX_FAIL(ctx, IX_EARG, "%d directions: a curve is needed",
                       crv->ndirs);
    if (crv->ncoords < 2 || crv->ncoords > 3)
        return IX_FAIL(ctx, IX_EARG,
                       "a curve with %d coordinates: 2 or 3 are needed",
                       crv->ncoords);
    if (kind == IX__CURVE_SPACE)
        c.dim = 3;
    else if (kind == IX__CURVE_FLAT || (c.dim == 3 && in_plane(crv, &c.z)))
        c.dim = 2;
    if (rational && simplify && crv->dirs[0].basis != IX_POWER)
        rational = !constant_weight(crv);
    IX_TRY(ix_mv_coerce(ctx, crv, c.dim, rational, &m));
    st = load_forms(ctx, m, at, &c);
    ix_mv_unref(ctx, m);
    *out = c;
    return st;
}

ix_status ix__curve_load(ix_ctx *ctx, const ix_mv *crv, ix__curve_kind kind,
                         bool simplify, ix_curve *out)
{
    return load(ctx, crv, kind, NULL, simplify, out);
}

ix_status ix__curve_load_tangent(ix_ctx *ctx, const ix_mv *crv,
                                 ix__curve_kind kind, const double *at,
                                 bool simplify, ix_curve *out)
{
    return load(ctx, crv, kind, at, simplify, out);
}
