/* All operators on curves, in all degree forms, against their definitions in
 * long double, with the condition of each value measured.
 *
 * The definition is evaluated from derivatives by de Boor's rule in long double
 * (63 bits after the first), after an exact shift of the curve to the origin.
 * Two things limit what any result in double can be:
 *
 *   input   the control points themselves: a change of e times the curve's size
 *           (of weights: e) in them changes the value by e times a number that
 *           is measured, as the largest of some random changes of 2^-30 in the
 *           definition
 *   output  the result's control points: rounding them changes the value x / w
 *           by e (max |x_i| + |x / w| max |w_i|) / |w(t)|, i over those that
 *           count at t; its derivative by 2 d / h times that for x, and w
 *
 * The law: |value - definition| <= C e (input + output), e = 2^-53. C = 64
 * stands for the roundings in a coefficient; the largest met in some thousand
 * curves was 24. Values that are well conditioned are thereby right to 1e-14,
 * near cusps and inflections they are what the input determines.
 *
 *   terms   of (kappa^2)' and (|kappa N|^2)', the naive and IRIT forms of
 * CCRVTR, computed as (N'D - N D') / D^2: the coefficients of N'D and N D' are
 *           larger than their difference by any factor, and rounding is
 * relative to them: e 4 d / h max |N_i| max |D_i| / D(t)^2, N and D those of
 *           kappa^2 and |kappa N|^2 in the same form. The bound is 1e-12 of the
 *           value for the best tenth of these curves, 4e-9 (IRIT's form 7e-7)
 *           for half of them, and says nothing for one in ten: that is what
 *           these forms are */
#include <limits.h>
#include <string.h>

#include "crv_test.h"
#include "ops/table.h"
#include "truth.h"

enum { MAX_VALUES = 6, CHANGES = 6 };
#define ROUNDINGS 64

/* --- the curve in long double -----------------------------------------------
 */

/* Derivatives of the projected curve, and its weight. */
typedef struct {
    int dim;
    real x[4][3], w;
} jet;

static void load_local(const ix_mv *m, double t, double at, local *o)
{
    const ix_dir *d = &m->dirs[0];
    const double *w = ix_mv_weights(m);
    int first;

    *o = (local){.dim = m->ncoords};
    first = load_knots(d, t, o);
    for (int i = 0; i <= o->degree; i++) {
        o->pts[i][0] = w ? w[first + i] : 1;
        for (int k = 0; k < o->dim; k++)
            o->pts[i][k + 1] = ix_mv_coord(m, k)[first + i] -
                               o->pts[i][0] * (real)at;
    }
}

static jet jet_of(const local *c, double t)
{
    static const int binom[4][4] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
    real h[4][4];
    jet j = {.dim = c->dim};

    for (int n = 0; n < 4; n++)
        derive_local(c, n, t, h[n]);
    j.w = h[0][0];
    for (int n = 0; n < 4; n++)
        for (int k = 0; k < 3; k++) {
            real s = h[n][k + 1];

            for (int i = 1; i <= n; i++)
                s -= binom[n][i] * h[i][0] * j.x[n - i][k];
            j.x[n][k] = s / j.w;
        }
    return j;
}

/* --- definitions
 * -------------------------------------------------------------- */

static real power(real w, int n)
{
    return n == 0 ? 1 : w * power(w, n - 1);
}

typedef struct {
    const char *op;
    int form;
    bool rational; /* the curve */
    double at;     /* what the curve was shifted by, in each coordinate */
} item;

/* Numbers of the operators: a range of rulings, or the point and the factor of
 * an orthotomic. */
static const double numbers[4] = {-0.5, 0.5, 0, 2};

/* Fields: one value; (form, rational) tell the power of w that it carries. */
static real field(const item *it, const jet *j)
{
    real b[3], c[3], q = dot(j->x[1], j->x[1]), d = dot(j->x[1], j->x[2]);
    real bb, s;
    bool quotient = it->form > 1;

    cross(j->x[1], j->x[2], b);
    cross(j->x[1], j->x[3], c);
    bb = dot(b, b);
    if (strcmp(it->op, "CINFLECT") == 0)
        return b[2] * (quotient ? 1 : power(j->w, 3));
    if (strcmp(it->op, "CCRVTRSQR") == 0)
        return bb / (q * q * q);
    if (strcmp(it->op, "CTORSION") == 0)
        return dot(b, j->x[3]) / bb;
    if (strcmp(it->op, "CTORSIONZERO") == 0)
        return dot(b, j->x[3]) *
               (quotient ? 1 : power(j->w, it->form == 1 ? 6 : 4));
    s = 2 * dot(b, c) * q - 6 * bb * d; /* CCRVTR */
    if (quotient && strcmp(it->op, "CCRVTRDIRECT") == 0)
        return j->dim == 3 ? s : c[2] * q - 3 * d * b[2];
    if (quotient)
        return s / (q * q * q * q);
    if (j->dim == 3)
        return s * power(j->w, it->form == 1 ? 13 : 11);
    return (c[2] * q - 3 * d * b[2]) * power(j->w, it->form == 1 ? 9 : 8);
}

/* Centre of curvature and its derivative. */
static void centre(const jet *j, real *e, real *de)
{
    real b[3], db[3], n[3], m[3], dn[3], q, dq, bb, dbb;

    cross(j->x[1], j->x[2], b);
    cross(j->x[1], j->x[3], db);
    cross(b, j->x[1], n);
    cross(db, j->x[1], dn);
    cross(b, j->x[2], m);
    q = dot(j->x[1], j->x[1]);
    dq = 2 * dot(j->x[1], j->x[2]);
    bb = dot(b, b);
    dbb = 2 * dot(b, db);
    for (int k = 0; k < 3; k++) {
        e[k] = j->x[0][k] + q / bb * n[k];
        de[k] = j->x[1][k] + (dq / bb - q * dbb / (bb * bb)) * n[k] +
                q / bb * (dn[k] + m[k]);
    }
}

static void focal(const jet *j, real *out)
{
    real b[3], c[3], q = dot(j->x[1], j->x[1]);

    cross(j->x[1], j->x[2], b);
    cross(j->x[1], j->x[3], c);
    for (int k = 0; k < 3; k++)
        out[k] = j->x[0][k] + (3 * dot(j->x[1], j->x[2]) * b[k] - q * c[k]) /
                                  dot(b, j->x[3]);
}

/* Both ends of a ruling over [-1/2, 1/2]; those of the polar developable's
 * minimal form lie elsewhere on the same line (see on_axis). */
static void ruling(const item *it, const jet *j, real *out)
{
    real b[3], n[3], r[3], x[3], skip[3], q = dot(j->x[1], j->x[1]), bb, f = 1;
    int pw = 0;

    cross(j->x[1], j->x[2], b);
    cross(b, j->x[1], n);
    bb = dot(b, b);
    memcpy(x, j->x[0], sizeof x);
    memcpy(r, b, sizeof r);
    if (strcmp(it->op, "TANDEVSRF") == 0) {
        memcpy(r, j->x[1], sizeof r);
        pw = 1;
    } else if (strcmp(it->op, "NRMLSCROLL") == 0) {
        memcpy(r, n, sizeof r);
        pw = it->form == 1 ? 5 : 4;
    } else if (strcmp(it->op, "BINRMLSCROLL") == 0) {
        pw = it->form == 1 ? 3 : 2;
    } else if (strcmp(it->op, "RECTDEVSRF") == 0) {
        for (int k = 0; k < 3; k++)
            r[k] = dot(b, j->x[3]) * q * j->x[1][k] + bb * b[k];
        pw = it->form == 0 ? 9 : 0;
        f = it->form == 0 ? 1 : 1 / (q * bb);
    } else { /* FOCALSRF */
        centre(j, x, skip);
    }
    if (it->form < 2)
        f *= power(j->w, pw);
    for (int k = 0; k < 3; k++) {
        out[k] = x[k] - f * r[k] / 2;
        out[k + 3] = x[k] + f * r[k] / 2;
    }
}

/* The dual, not shifted, or the orthotomic, shifted as the curve. */
static void of_tangent(const item *it, const jet *j, real *out)
{
    const bool dual = strcmp(it->op, "DUALITY") == 0;
    const real n[3] = {-j->x[1][1], j->x[1][0], 0};
    real way[3] = {0, 0, 0}, c;

    for (int k = 0; k < 2; k++)
        way[k] = j->x[0][k] + it->at - (dual ? 0 : numbers[k]);
    c = dot(n, way);
    for (int k = 0; k < 2; k++)
        out[k] = dual ? -n[k] / c
                      : numbers[k] - it->at + numbers[3] * c / dot(n, n) * n[k];
    out[2] = 0;
}

static bool of_tangents(const char *op)
{
    return strcmp(op, "DUALITY") == 0 || strcmp(op, "ORTHOTOMC") == 0;
}

static bool is_surface(const char *op)
{
    return strstr(op, "SRF") || strstr(op, "SCROLL");
}

static int definition(const item *it, const jet *j, real *out)
{
    real b[3], n[3], q = dot(j->x[1], j->x[1]);

    if (strcmp(it->op, "EVOLUTE") == 0) {
        centre(j, out, out + 3);
        return 6;
    }
    if (strcmp(it->op, "FOCALCRV") == 0) {
        focal(j, out);
        return 3;
    }
    if (strcmp(it->op, "CNRMLCRV") == 0) {
        cross(j->x[1], j->x[2], b);
        cross(b, j->x[1], n);
        for (int k = 0; k < 3; k++)
            out[k] = n[k] / (q * q);
        return 3;
    }
    if (is_surface(it->op)) {
        ruling(it, j, out);
        return 6;
    }
    if (of_tangents(it->op)) {
        of_tangent(it, j, out);
        return 3;
    }
    out[0] = field(it, j);
    return 1;
}

/* --- condition
 * ---------------------------------------------------------------- */

/* Change of each value for a relative change of the control points by one. */
static void input_condition(ix_rng *r, const item *it, const local *c, double t,
                            double size, const real *want, double *cond)
{
    static const double step = 0x1p-30;

    for (int i = 0; i < MAX_VALUES; i++)
        cond[i] = 0;
    for (int round = 0; round < CHANGES; round++) {
        local d = *c;
        real v[MAX_VALUES];
        jet j;
        int n;

        for (int i = 0; i <= c->degree; i++)
            for (int k = 0; k <= c->dim; k++) {
                double e = ix_rng_next(r) & 1 ? step : -step;

                if (k == 0 && !it->rational)
                    continue;
                d.pts[i][k] += e * (k ? size : 1) * c->pts[i][0];
            }
        j = jet_of(&d, t);
        n = definition(it, &j, v);
        for (int i = 0; i < n; i++)
            cond[i] = fmax(cond[i], fabs((double)(v[i] - want[i])) / step);
    }
}

/* The output number of coordinate k of row v of a result with this value. */
static double output_condition(ix_ctx *ctx, const ix_mv *m, double t, int v,
                               int k, double value)
{
    const ix_dir *d = &m->dirs[0];
    int p = d->order - 1, j = span_of(d, t);
    const double *w = ix_mv_weights(m), *x = ix_mv_coord(m, k);
    double uv[2] = {t, v}, axes[4], big = 0, wide = 0;

    ASSERT_OK(ctx, ix_mv_eval(ctx, m, uv, axes));
    for (int i = v * d->length + j - p; i <= v * d->length + j; i++) {
        big = fmax(big, fabs(x[i]));
        wide = fmax(wide, w ? fabs(w[i]) : 0);
    }
    return (big + fabs(value) * wide) / (w ? fabs(axes[0]) : 1);
}

/* That of the derivative dv of a curve's value v. */
static double slope_condition(ix_ctx *ctx, const ix_mv *m, double t, int k,
                              double v, double dv)
{
    const ix_dir *d = &m->dirs[0];
    double h = 1, unit, of_v;
    int one[1] = {1};
    double w[4], dw[4];

    if (d->basis == IX_BSPLINE) {
        int j = span_of(d, t);

        h = d->knots[j + 1] - d->knots[j];
    }
    unit = 2 * (d->order - 1) / h;
    of_v = output_condition(ctx, m, t, 0, k, v);
    ASSERT_OK(ctx, ix_mv_eval(ctx, m, &t, w));
    ASSERT_OK(ctx, ix_mv_partial(ctx, m, &t, one, dw));
    /* v' = (x' - v w') / w */
    return of_v * (unit + fabs(dw[0] / w[0])) +
           output_condition(ctx, m, t, 0, k, dv);
}

/* --- results
 * ------------------------------------------------------------------ */

/* The values of a result at t, shifted, and their output numbers. */
typedef struct {
    real v[MAX_VALUES];
    double out[MAX_VALUES];
} values;

static void surface_values(ix_ctx *ctx, const ix_mv *m, double t, double at,
                           values *o)
{
    for (int v = 0; v < 2; v++) {
        double uv[2] = {t, v}, x[3];

        ASSERT_OK(ctx, ix_mv_point(ctx, m, uv, x));
        for (int k = 0; k < 3; k++) {
            o->v[3 * v + k] = (real)x[k] - at;
            o->out[3 * v + k] = output_condition(ctx, m, t, v, k, x[k]);
        }
    }
}

static void curve_values(ix_ctx *ctx, const item *it, const ix_mv *m, double t,
                         double at, int dim, values *o)
{
    bool evolute = strcmp(it->op, "EVOLUTE") == 0;
    bool place = evolute || strcmp(it->op, "FOCALCRV") == 0 ||
                 strcmp(it->op, "ORTHOTOMC") == 0;
    double d[6] = {0};
    int nc = m->ncoords;

    ASSERT_OK(ctx, ix_mv_curve_derivs(ctx, m, t, 1, d));
    for (int k = 0; k < nc; k++) {
        /* IRIT's evolute of a planar curve has z = 0 */
        o->v[k] = (real)d[k] - (place && k < dim ? at : 0);
        o->out[k] = output_condition(ctx, m, t, 0, k, d[k]);
        o->v[3 + k] = d[nc + k];
        if (evolute)
            o->out[3 + k] = slope_condition(ctx, m, t, k, d[k], d[nc + k]);
    }
}

/* The points moved along the axis to the centre of curvature, which is what
 * both should then be. */
static void on_axis(const jet *j, const real *want, values *o)
{
    real b[3], e[3], skip[3];

    cross(j->x[1], j->x[2], b);
    centre(j, e, skip);
    for (int i = 0; i < 6; i += 3) {
        real y[3], f;

        for (int k = 0; k < 3; k++)
            y[k] = o->v[i + k] - e[k];
        f = dot(y, b) / dot(b, b);
        for (int k = 0; k < 3; k++)
            o->v[i + k] = want[i + k] + y[k] - f * b[k];
    }
}

/* Largest control value of an axis among those that count at t. */
static double largest_near(const ix_mv *m, int axis, double t)
{
    const ix_dir *d = &m->dirs[0];
    const double *x = ix_mv_axis(m, axis);
    double big = 0;
    int j = span_of(d, t);

    for (int i = j - d->order + 1; i <= j; i++)
        big = fmax(big, fabs(x[i]));
    return big;
}

/* The quotient N / D whose derivative a form of CCRVTR is: max |N|, max |D| and
 * D(t), and 2 d / h for its degree. Of kappa N / W it is the square. */
static double quotient_terms(ix_ctx *ctx, const ix_mv *crv, int form, double t)
{
    bool irit = form == IX_FORM_IRIT;
    const ix_op *op = ix__op_find(irit ? "CNRMLCRV" : "CCRVTRSQR");
    const ix_op_opts o = {(ix_degree_form)form, INT_MAX};
    ix_op_args a = {.mv = {crv}};
    double n = 0, w, axes[4], unit, size;
    const ix_dir *d;
    ix_mv *m;

    ASSERT_OK(ctx, op->run(ctx, &a, &o, NULL, &m));
    ASSERT_OK(ctx, ix_mv_eval(ctx, m, &t, axes));
    d = &m->dirs[0];
    for (int k = 1; k < m->naxes; k++)
        n = fmax(n, largest_near(m, k, t));
    w = largest_near(m, 0, t) / fabs(axes[0]);
    n /= fabs(axes[0]);
    unit = 2 * (d->order - 1);
    if (d->basis == IX_BSPLINE) {
        int j = span_of(d, t);

        unit /= d->knots[j + 1] - d->knots[j];
    }
    size = irit ? 2 * unit * 3 * n * n * w * w : unit * n * w;
    ix_mv_unref(ctx, m);
    return 2 * size;
}

/* --- the law
 * ------------------------------------------------------------------ */

typedef struct {
    ix_ctx *ctx;
    ix_rng *r;
    const ix_mv *crv, *res;
    const crv_kind *kind;
} place;

static void check_at(const place *o, const item *it, double t)
{
    double in[MAX_VALUES], gap[MAX_VALUES];
    real want[MAX_VALUES];
    values got = {{0}, {0}};
    local c;
    jet j;
    int n;

    load_local(o->crv, t, o->kind->at, &c);
    j = jet_of(&c, t);
    n = definition(it, &j, want);
    input_condition(o->r, it, &c, t, o->kind->size, want, in);
    if (is_surface(it->op))
        surface_values(o->ctx, o->res, t, o->kind->at, &got);
    else
        curve_values(o->ctx, it, o->res, t, o->kind->at, c.dim, &got);
    if (strcmp(it->op, "FOCALSRF") == 0 && it->form == 0)
        on_axis(&j, want, &got);
    for (int i = 0; i < n; i++)
        gap[i] = (double)fabsl(got.v[i] - want[i]);
    if (it->form > 1 && strcmp(it->op, "CCRVTR") == 0)
        got.out[0] += quotient_terms(o->ctx, o->crv, it->form, t);
    for (int i = 0; i < n; i += 3) { /* vectors as a whole */
        int m = n < 3 ? n : 3;
        double most = ROUNDINGS * 0x1p-53 *
                      (largest(in + i, m) + largest(got.out + i, m));

        if (!(largest(gap + i, m) <= most))
            fail_msg("%s form %d, degree %d, rational %d, %d spans, at %g, "
                     "size %g, t %g: off by %g, bound %g (value %Lg)",
                     it->op, it->form, o->kind->degree, it->rational,
                     o->kind->spans, o->kind->at, o->kind->size, t,
                     largest(gap + i, m), most, want[i]);
    }
}

static void check_op(ix_ctx *ctx, ix_rng *r, const ix_op *op, const ix_mv *c,
                     const crv_kind *k)
{
    ix_op_args a = {.mv = {c}};

    memcpy(a.num, numbers, sizeof numbers);
    for (int form = 0; form < 4; form++) {
        ix_op_opts o = {(ix_degree_form)form, INT_MAX};
        item it = {op->name, form, k->rational, k->at};
        place p = {ctx, r, c, NULL, k};
        double dom[2];
        ix_mv *m;

        if (!(op->forms >> form & 1))
            continue;
        ASSERT_OK(ctx, op->run(ctx, &a, &o, NULL, &m));
        p.res = m;
        ix_mv_domain(c, 0, dom);
        for (int i = 0; i < 3; i++) {
            double u = (i + ix_rng_unit(r)) / 3;

            check_at(&p, &it, dom[0] + (dom[1] - dom[0]) * u);
        }
        ix_mv_unref(ctx, m);
    }
}

/* Operators on one curve of this kind, none of them a bisector. */
static bool applies(const ix_op *op, const crv_kind *k)
{
    bool plane_too = strcmp(op->name, "CCRVTR") == 0 ||
                     strcmp(op->name, "CCRVTRDIRECT") == 0 ||
                     strcmp(op->name, "CCRVTRSQR") == 0 ||
                     strcmp(op->name, "CNRMLCRV") == 0 ||
                     strcmp(op->name, "EVOLUTE") == 0;
    bool third = strncmp(op->name, "CTORSION", 8) == 0 ||
                 strcmp(op->name, "FOCALCRV") == 0;

    if (op->ndirs[0] != 1 || op->ndirs[1] != 0)
        return false;
    if (strcmp(op->name, "CINFLECT") == 0 || of_tangents(op->name))
        return k->ncoords == 2;
    if (third)
        return k->ncoords == 3 && k->degree > 2;
    return plane_too || (k->ncoords == 3 && is_surface(op->name));
}

static void truth_of_all(const crv_kind *like)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng r = ix_rng_new(57);

    for (int d = 2; d <= MAX_DEGREE; d++)
        for (int i = 0; i < 8; i++) {
            crv_kind k = {d,        2 + (i & 1), i >> 1 & 1, i & 4 ? 3 : 0,
                          like->at, like->size};
            ix_mv *c = rand_crv(ctx, &r, &k);

            for (const ix_op *op = ix__ops; op->name; op++)
                if (applies(op, &k))
                    check_op(ctx, &r, op, c, &k);
            ix_mv_unref(ctx, c);
        }
    ix_ctx_free(ctx);
}

static void of_unit_size(void **state)
{
    const crv_kind k = {.at = 0, .size = 1};

    (void)state;
    truth_of_all(&k);
}

/* At a million units (a power of two, so that the shift is exact) in all
 * coordinates. */
static void far_away(void **state)
{
    const crv_kind k = {.at = 0x1p20, .size = 1};

    (void)state;
    truth_of_all(&k);
}

static void small(void **state)
{
    const crv_kind k = {.at = 0, .size = 1e-6};

    (void)state;
    truth_of_all(&k);
}

static void large(void **state)
{
    const crv_kind k = {.at = 0, .size = 1e6};

    (void)state;
    truth_of_all(&k);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_unit_size), cmocka_unit_test(far_away),
        cmocka_unit_test(small), cmocka_unit_test(large)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
