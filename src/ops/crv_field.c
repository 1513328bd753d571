/* crv_field.c - scalar functions of a curve: inflections, critical curvature,
 * squared curvature, torsion.
 *
 * All is computed in the frame of the curve, where lengths are 2^-e and
 * weights 2^-g of the user's: a function that is homogeneous in both is
 * multiplied by one power of two at the end. */
#include "iritx/ops_crv.h"

#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "ops/published.h"
#include "ops/ratio.h"
#include "ops/report.h"

/* A field before it is stored: a fraction, and how it scales. */
typedef struct {
    ix_frac f;
    int length, weight; /* degrees of homogeneity */
} field;

typedef ix_status (*build_fn)(ix_ctx *ctx, const ix_curve *c, field *out);

/* --- inflections -------------------------------------------------------- */

static ix_status inflection_minimal(ix_ctx *ctx, const ix_curve *c, field *out)
{
    (void)ctx;
    *out = (field){{.x = c->v}, 2, 3};
    return IX_OK;
}

/* det(p', p'') w - det(p, p'') w' + det(p, p') w''. */
static ix_status inflection_published(ix_ctx *ctx, const ix_curve *c,
                                      field *out)
{
    ix_form dp, ddp, dw, ddw, a, b, e, r;

    IX_TRY(ix__form_derive(ctx, &c->p, 0, &dp));
    IX_TRY(ix__form_derive(ctx, &dp, 0, &ddp));
    IX_TRY(ix__form_det2(ctx, &dp, &ddp, &r));
    *out = (field){{.x = r}, 2, 3};
    if (!c->rational)
        return IX_OK;
    IX_TRY(ix__form_derive(ctx, &c->local, 0, &dp));
    IX_TRY(ix__form_derive(ctx, &dp, 0, &ddp));
    IX_TRY(ix__form_derive(ctx, &c->w, 0, &dw));
    IX_TRY(ix__form_derive(ctx, &dw, 0, &ddw));
    IX_TRY(ix__form_det2(ctx, &dp, &ddp, &a));
    IX_TRY(ix__form_det2(ctx, &c->local, &ddp, &b));
    IX_TRY(ix__form_det2(ctx, &c->local, &dp, &e));
    IX_TRY(ix__form_mul(ctx, &a, &c->w, &r));
    IX_TRY(ix__form_mul_add(ctx, &b, -1, &dw, &r));
    IX_TRY(ix__form_mul_add(ctx, &e, 1, &ddw, &r));
    out->f.x = r;
    return IX_OK;
}

/* x' and x'' as fractions. */
static ix_status derivatives(ix_ctx *ctx, const ix_curve *c, int n, ix_frac *d)
{
    ix_frac f = ix__ratio_of(c);

    for (int i = 0; i < n; i++) {
        IX_TRY(ix__ratio_derive(ctx, &f, &f));
        d[i] = f;
    }
    return IX_OK;
}

static ix_status inflection_naive(ix_ctx *ctx, const ix_curve *c, field *out)
{
    ix_frac d[2];

    IX_TRY(derivatives(ctx, c, 2, d));
    *out = (field){{.rational = false}, 2, 0};
    return ix__ratio_product(ctx, ix__form_det2, &d[0], &d[1], &out->f);
}

/* --- squared curvature -------------------------------------------------- */

/* |V|^2 w^6 / Q^3. */
static ix_status square_minimal(ix_ctx *ctx, const ix_curve *c, field *out)
{
    ix_form a, w;

    *out = (field){{.rational = true}, -2, 0};
    IX_TRY(ix__form_dot(ctx, &c->v, &c->v, &a));
    IX_TRY(ix__form_power(ctx, &c->w, 6, &w));
    IX_TRY(ix__form_mul(ctx, &a, &w, &out->f.x));
    return ix__form_power(ctx, &c->q, 3, &out->f.w);
}

/* |D1 x D2|^2 w^4 / |D1|^6. */
static ix_status square_published(ix_ctx *ctx, const ix_curve *c, field *out)
{
    ix_published p;
    ix_form a, w;

    *out = (field){{.rational = true}, -2, 0};
    IX_TRY(ix__published_of(ctx, c, &p));
    IX_TRY(ix__form_dot(ctx, &p.b, &p.b, &a));
    IX_TRY(ix__form_power(ctx, &c->w, 4, &w));
    IX_TRY(ix__form_mul(ctx, &a, &w, &out->f.x));
    return ix__form_power(ctx, &p.q, 3, &out->f.w);
}

/* The product for x' and x'' by which the curvature is their product over
 * |x'|^3. */
static ix__form_product area_of(const ix_curve *c)
{
    return c->dim == 2 ? ix__form_det2 : ix__form_cross;
}

static ix_status square_naive(ix_ctx *ctx, const ix_curve *c, field *out)
{
    ix_frac d[2], b, q, q2;

    *out = (field){{.rational = true}, -2, 0};
    IX_TRY(derivatives(ctx, c, 2, d));
    IX_TRY(ix__ratio_product(ctx, area_of(c), &d[0], &d[1], &b));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &b, &b, &b));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &d[0], &d[0], &q));
    IX_TRY(ix__ratio_product(ctx, ix__form_mul, &q, &q, &q2));
    IX_TRY(ix__ratio_product(ctx, ix__form_mul, &q2, &q, &q));
    IX_TRY(ix__ratio_over(ctx, &b, &q, &out->f));
    return ix__ratio_even(ctx, &out->f);
}

/* --- critical curvature ------------------------------------------------- */

static ix_status critical_minimal(ix_ctx *ctx, const ix_curve *c, field *out)
{
    ix_form a;

    if (c->dim == 2) {
        *out = (field){{.rational = false}, 4, 8};
        return ix__curve_slope(ctx, c, &c->v, 1, &out->f.x);
    }
    *out = (field){{.rational = false}, 6, 11};
    IX_TRY(ix__form_dot(ctx, &c->v, &c->v, &a));
    return ix__curve_slope(ctx, c, &a, 2, &out->f.x);
}

/* a b c, b and c scalars, times factor. */
static ix_status triple(ix_ctx *ctx, double factor, const ix_form *a,
                        const ix_form *b, const ix_form *c, ix_form *out)
{
    ix_form t;

    IX_TRY(ix__form_mul(ctx, a, b, &t));
    IX_TRY(ix__form_mul(ctx, &t, c, out));
    ix__form_times(out, factor);
    return IX_OK;
}

/* (3.5): ([D1 D3] + [D1 D21]) |D1|^2 w + 2 w' [D1 D2] |D1|^2
 *        - 3 (D1.D2) [D1 D2] w, and (3.4) for polynomials. */
static ix_status direct_planar(ix_ctx *ctx, const ix_curve *c,
                               const ix_published *p, ix_form *out)
{
    ix_form d3 = p->d3, a, dw, t, dot;

    IX_TRY(ix__form_dot(ctx, &p->d1, &p->d2, &dot));
    IX_TRY(triple(ctx, -3.0, &p->b, &dot, &c->w, out));
    if (c->rational && c->degree < 3)
        d3 = p->d21; /* D3 = 0, of degree -1 as it were */
    else if (c->rational)
        IX_TRY(ix__form_add(ctx, &d3, 1, &p->d21, &d3));
    if (c->rational || c->degree > 2) {
        IX_TRY(ix__form_det2(ctx, &p->d1, &d3, &a));
        IX_TRY(triple(ctx, 1.0, &a, &p->q, &c->w, &t));
        IX_TRY(ix__form_add(ctx, out, 1, &t, out));
    }
    if (!c->rational)
        return IX_OK;
    IX_TRY(ix__form_derive(ctx, &c->w, 0, &dw));
    IX_TRY(triple(ctx, 2.0, &p->b, &p->q, &dw, &t));
    return ix__form_add(ctx, out, 1, &t, out);
}

/* In space, with B = |D1 x D2|^2:  w (B' Q - 3 B Q') + 4 w' B Q. */
static ix_status direct_space(ix_ctx *ctx, const ix_curve *c,
                              const ix_published *p, ix_form *out)
{
    ix_form b, db, dq, dw, t;

    IX_TRY(ix__form_dot(ctx, &p->b, &p->b, &b));
    IX_TRY(ix__form_derive(ctx, &b, 0, &db));
    IX_TRY(ix__form_derive(ctx, &p->q, 0, &dq));
    IX_TRY(triple(ctx, 1.0, &db, &p->q, &c->w, out));
    IX_TRY(triple(ctx, -3.0, &b, &dq, &c->w, &t));
    IX_TRY(ix__form_add(ctx, out, 1, &t, out));
    if (!c->rational)
        return IX_OK;
    IX_TRY(ix__form_derive(ctx, &c->w, 0, &dw));
    IX_TRY(triple(ctx, 4.0, &b, &p->q, &dw, &t));
    return ix__form_add(ctx, out, 1, &t, out);
}

static ix_status critical_published(ix_ctx *ctx, const ix_curve *c, field *out)
{
    ix_published p;

    IX_TRY(ix__published_of(ctx, c, &p));
    if (c->dim == 2) {
        *out = (field){{.rational = false}, 4, 9};
        return direct_planar(ctx, c, &p, &out->f.x);
    }
    *out = (field){{.rational = false}, 6, 13};
    return direct_space(ctx, c, &p, &out->f.x);
}

/* (kappa^2)'. */
static ix_status critical_naive(ix_ctx *ctx, const ix_curve *c, field *out)
{
    IX_TRY(square_naive(ctx, c, out));
    return ix__ratio_derive(ctx, &out->f, &out->f);
}

/* (3.4) as it stands: det(x', x''') |x'|^2 - 3 (x'.x'') det(x', x''), in space
 * 2 (b.c) |x'|^2 - 6 |b|^2 (x'.x'') with b = x' x x'', c = x' x x'''. */
static ix_status direct_naive(ix_ctx *ctx, const ix_curve *c, field *out)
{
    ix__form_product area = area_of(c);
    ix_frac d[3], a, b, q, dot;

    *out = (field){{.rational = false}, c->dim == 2 ? 4 : 6, 0};
    IX_TRY(derivatives(ctx, c, 3, d));
    IX_TRY(ix__ratio_product(ctx, area, &d[0], &d[1], &b));
    IX_TRY(ix__ratio_product(ctx, area, &d[0], &d[2], &a));
    if (c->dim == 3) {
        IX_TRY(ix__ratio_product(ctx, ix__form_dot, &b, &a, &a));
        IX_TRY(ix__ratio_product(ctx, ix__form_dot, &b, &b, &b));
        ix__form_times(&a.x, 2.0);
        ix__form_times(&b.x, 2.0);
    }
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &d[0], &d[0], &q));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &d[0], &d[1], &dot));
    IX_TRY(ix__ratio_product(ctx, ix__form_mul, &a, &q, &a));
    IX_TRY(ix__ratio_product(ctx, ix__form_mul, &b, &dot, &b));
    ix__form_times(&b.x, 3.0);
    return ix__ratio_add(ctx, &a, -1, &b, &out->f);
}

/* (|kappa N|^2)', with kappa N = (x' x x'') x x' / |x'|^4. */
static ix_status critical_irit(ix_ctx *ctx, const ix_curve *c, field *out)
{
    ix_frac d[2], n, q;

    *out = (field){{.rational = true}, -2, 0};
    IX_TRY(derivatives(ctx, c, 2, d));
    IX_TRY(ix__ratio_product(ctx, area_of(c), &d[0], &d[1], &n));
    IX_TRY(ix__ratio_product(
        ctx, c->dim == 2 ? ix__form_turned : ix__form_cross, &n, &d[0], &n));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &d[0], &d[0], &q));
    IX_TRY(ix__ratio_product(ctx, ix__form_mul, &q, &q, &q));
    IX_TRY(ix__ratio_over(ctx, &n, &q, &n));
    IX_TRY(ix__ratio_even(ctx, &n));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &n, &n, &n));
    return ix__ratio_derive(ctx, &n, &out->f);
}

/* --- torsion ------------------------------------------------------------ */

/* Nothing to compute in the plane: the torsion is zero. */
static ix_status zero_field(ix_ctx *ctx, const ix_curve *c, field *out)
{
    static const double zero = 0.0;

    *out = (field){{.rational = false}, 0, 0};
    return ix__form_constant(ctx, &c->p, 1, &zero, &out->f.x);
}

static ix_status torsion_zero_minimal(ix_ctx *ctx, const ix_curve *c,
                                      field *out)
{
    ix_extent *e;

    if (c->dim == 2)
        return zero_field(ctx, c, out);
    *out = (field){{.rational = false}, 3, 4};
    return ix__curve_torsion(ctx, c, &out->f.x, &e);
}

static ix_status torsion_zero_published(ix_ctx *ctx, const ix_curve *c,
                                        field *out)
{
    ix_published p;

    if (c->dim == 2)
        return zero_field(ctx, c, out);
    *out = (field){{.rational = false}, 3, 6};
    IX_TRY(ix__published_of(ctx, c, &p));
    return ix__published_torsion(ctx, &p, &out->f.x);
}

static ix_status torsion_zero_naive(ix_ctx *ctx, const ix_curve *c, field *out)
{
    ix_frac d[3], b;

    if (c->dim == 2)
        return zero_field(ctx, c, out);
    *out = (field){{.rational = false}, 3, 0};
    IX_TRY(derivatives(ctx, c, 3, d));
    IX_TRY(ix__ratio_product(ctx, ix__form_cross, &d[0], &d[1], &b));
    return ix__ratio_product(ctx, ix__form_dot, &b, &d[2], &out->f);
}

/* T w^2 / |V|^2. */
static ix_status torsion_minimal(ix_ctx *ctx, const ix_curve *c, field *out)
{
    ix_extent *e;
    ix_form t, w;

    if (c->dim == 2)
        return zero_field(ctx, c, out);
    *out = (field){{.rational = true}, -1, 0};
    IX_TRY(ix__curve_torsion(ctx, c, &t, &e));
    IX_TRY(ix__form_mul(ctx, &c->w, &c->w, &w));
    IX_TRY(ix__form_mul(ctx, &t, &w, &out->f.x));
    return ix__form_dot(ctx, &c->v, &c->v, &out->f.w);
}

static ix_status torsion_published(ix_ctx *ctx, const ix_curve *c, field *out)
{
    ix_published p;
    ix_form t, w;

    if (c->dim == 2)
        return zero_field(ctx, c, out);
    *out = (field){{.rational = true}, -1, 0};
    IX_TRY(ix__published_of(ctx, c, &p));
    IX_TRY(ix__published_torsion(ctx, &p, &t));
    IX_TRY(ix__form_mul(ctx, &c->w, &c->w, &w));
    IX_TRY(ix__form_mul(ctx, &t, &w, &out->f.x));
    return ix__form_dot(ctx, &p.b, &p.b, &out->f.w);
}

static ix_status torsion_naive(ix_ctx *ctx, const ix_curve *c, field *out)
{
    ix_frac d[3], b, t;

    if (c->dim == 2)
        return zero_field(ctx, c, out);
    *out = (field){{.rational = true}, -1, 0};
    IX_TRY(derivatives(ctx, c, 3, d));
    IX_TRY(ix__ratio_product(ctx, ix__form_cross, &d[0], &d[1], &b));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &b, &d[2], &t));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &b, &b, &b));
    return ix__ratio_over(ctx, &t, &b, &out->f);
}

/* --- table and entry ---------------------------------------------------- */

/* Builders by degree form; IRIT has no torsion. */
static const build_fn builders[6][4] = {
    [IX_CRV_INFLECTION] = {inflection_minimal, inflection_published,
                           inflection_naive, inflection_naive},
    [IX_CRV_CRITICAL] = {critical_minimal, critical_published, critical_naive,
                         critical_irit},
    [IX_CRV_CURVATURE_SQR] = {square_minimal, square_published, square_naive,
                              square_naive},
    [IX_CRV_TORSION_ZERO] = {torsion_zero_minimal, torsion_zero_published,
                             torsion_zero_naive, torsion_zero_minimal},
    [IX_CRV_TORSION] = {torsion_minimal, torsion_published, torsion_naive,
                        torsion_minimal},
    [IX_CRV_CRITICAL_DIRECT] = {critical_minimal, critical_published,
                                direct_naive, direct_naive}};

/* A denominator that vanishes on all of a span leaves nothing to divide by. */
static ix_status check_denominator(ix_ctx *ctx, const ix_curve *c,
                                   ix_crv_field_kind kind)
{
    bool torsion = kind == IX_CRV_TORSION && c->dim == 3;
    const ix_extent *e = torsion ? c->ev : c->ed;

    if (!torsion && kind != IX_CRV_CURVATURE_SQR)
        return IX_OK;
    for (int j = 0; j < c->p.dirs[0].nspans; j++)
        if (ix__extent_is_zero(e[j]))
            return IX_FAIL(
                ctx, IX_EDOMAIN, "the curve is %s over [%g, %g]: no %s there",
                torsion ? "straight" : "a point", c->p.dirs[0].breaks[j],
                c->p.dirs[0].breaks[j + 1], torsion ? "torsion" : "curvature");
    return IX_OK;
}

/* A builder, and how what it made scales. */
typedef struct {
    build_fn build;
    int length, weight;
    bool rational;
} builder;

/* Denominator, of rational fields, and numerator. */
static ix_status field_forms(ix_ctx *ctx, const ix_curve *c, void *arg,
                             ix_form *out)
{
    builder *b = arg;
    field f;

    IX_TRY(b->build(ctx, c, &f));
    b->length = f.length;
    b->weight = f.weight;
    b->rational = f.f.rational;
    if (b->rational)
        out[0] = f.f.w;
    out[1] = f.f.x;
    return IX_OK;
}

static ix_status build(ix_ctx *ctx, const ix_mv *crv, ix_crv_field_kind kind,
                       ix_degree_form form, const ix_op_opts *o, int *dim,
                       ix_mv **out)
{
    ix__curve_kind as = kind == IX_CRV_INFLECTION ? IX__CURVE_FLAT : IX__CURVE;
    builder b = {.build = builders[kind][form]};
    ix_form f;
    ix_curve c;

    IX_TRY(ix__curve_load(ctx, crv, as, form == IX_FORM_MINIMAL, &c));
    IX_TRY(check_denominator(ctx, &c, kind));
    *dim = c.dim;
    IX_TRY(ix__curve_forms(ctx, &c, field_forms, &b, &f));
    return ix__rows_store(ctx, &f, b.rational,
                          b.length * c.frame.exp + b.weight * c.wexp,
                          ix__join_rule(o), out);
}

/* --- the report --------------------------------------------------------- */

typedef struct {
    const ix_mv *field;
    ix_crv_field_kind kind;
    int dim;        /* of the curve: 2 or 3 */
    int weight;     /* the field is w^weight times its definition */
    double largest; /* value met */
    double terms;   /* largest sum of terms met, without signs */
} probe_arg;

/* |x'|^8 (kappa^2)' from b = x' x x'' and q = |x'|^2, or in the plane |x'|^5
 * kappa'; of rational fields (kappa^2)' itself
 * (not for CRITICAL_DIRECT). */
static double slope(const ix_probe *at, const double *b, double q,
                    const probe_arg *a)
{
    bool quotient = a->kind == IX_CRV_CRITICAL && ix_mv_rational(a->field);
    double c[3], bb = ix__dot3(b, b), dot = ix__dot3(at->x[1], at->x[2]), s;

    ix__cross3(at->x[1], at->x[3], c);
    if (a->dim == 2 && !quotient)
        return c[2] * q - 3.0 * dot * b[2];
    s = 2.0 * ix__dot3(b, c) * q - 6.0 * bb * dot;
    return quotient ? s / (q * q * q * q) : s;
}

/* The definition at a probe. */
static double definition(const ix_probe *at, const probe_arg *a)
{
    double b[3], q = ix__dot3(at->x[1], at->x[1]);

    ix__cross3(at->x[1], at->x[2], b);
    switch (a->kind) {
    case IX_CRV_INFLECTION:
        return b[2];
    case IX_CRV_CRITICAL:
    case IX_CRV_CRITICAL_DIRECT:
        return slope(at, b, q, a);
    case IX_CRV_TORSION_ZERO:
        return ix__dot3(b, at->x[3]);
    case IX_CRV_TORSION:
        return ix__dot3(b, at->x[3]) / ix__dot3(b, b);
    default:
        return ix__dot3(b, b) / (q * q * q);
    }
}

/* What the definition comes to if none of its terms cancel. */
static double term_size(const ix_probe *at, const probe_arg *a)
{
    double l[4], q, m, b[3];

    for (int i = 1; i < 4; i++)
        l[i] = ix__len3(at->x[i]);
    q = l[1] * l[1];
    ix__cross3(at->x[1], at->x[2], b);
    switch (a->kind) {
    case IX_CRV_INFLECTION:
        return l[1] * l[2];
    case IX_CRV_TORSION_ZERO:
        return l[1] * l[2] * l[3];
    case IX_CRV_TORSION:
        return l[1] * l[2] * l[3] / ix__dot3(b, b);
    case IX_CRV_CURVATURE_SQR:
        return ix__dot3(b, b) / (q * q * q);
    default: /* the slope: see there */
        m = q * (l[1] * l[3] + 3.0 * l[2] * l[2]);
        if (a->dim == 3)
            m *= 2.0 * l[1] * l[2];
        if (a->kind == IX_CRV_CRITICAL && ix_mv_rational(a->field))
            m *= (a->dim == 3 ? 1.0 : 2.0 * l[1] * l[2]) / (q * q * q * q);
        return m;
    }
}

/* The power of the weight in a polynomial field. */
static int power_of_weight(ix_crv_field_kind kind, int dim, bool is_published)
{
    switch (kind) {
    case IX_CRV_INFLECTION:
        return 3;
    case IX_CRV_CRITICAL:
    case IX_CRV_CRITICAL_DIRECT:
        return dim == 2 ? 8 + is_published : 11 + 2 * is_published;
    case IX_CRV_TORSION_ZERO:
        return is_published ? 6 : 4;
    default:
        return 0;
    }
}

static ix_status compare(ix_ctx *ctx, const ix_probe *at, const void *arg,
                         double *worst)
{
    probe_arg *a = *(probe_arg *const *)arg;
    double v[2], want, terms = term_size(at, a);

    IX_TRY(ix_mv_eval(ctx, a->field, &at->t, v));
    want = definition(at, a);
    if (ix_mv_rational(a->field)) {
        v[0] = v[1] / v[0];
    } else {
        want *= pow(at->w, a->weight);
        terms *= pow(fabs(at->w), a->weight);
    }
    a->largest = fmax(a->largest, fabs(want));
    a->terms = fmax(a->terms, terms);
    *worst = fmax(*worst, fabs(v[0] - want));
    return IX_OK;
}

static ix_status measure(ix_ctx *ctx, const ix_mv *crv, probe_arg *a,
                         ix_report *rep)
{
    double worst = 0.0;

    a->weight = power_of_weight(a->kind, a->dim,
                                rep->form == IX_FORM_PUBLISHED);
    IX_TRY(ix__probe(ctx, crv, compare, &a, &worst));
    /* a field that is zero but for rounding (of a circle) has no value to be
     * relative to */
    if (a->largest <= 1e-12 * a->terms)
        a->largest = a->terms;
    rep->residual = a->largest > 0.0 ? worst / a->largest : worst;
    rep->how = "against derivatives at nine parameters, relative to the "
               "largest value, or of a zero field to its terms";
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, const ix_mv *crv, ix_crv_field_kind kind,
                     const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    probe_arg a = {.kind = kind};
    ix_degree_form form;
    ix_mv *f;
    ix_status st;

    if (kind < IX_CRV_INFLECTION || kind > IX_CRV_CRITICAL_DIRECT)
        return IX_FAIL(ctx, IX_EARG, "field %d is not in 0 .. 5", (int)kind);
    IX_TRY(ix__form_of_opts(ctx, o, &form));
    IX_TRY(build(ctx, crv, kind, form, o, &a.dim, &f));
    ix__report_init(rep, form, f);
    a.field = f;
    st = rep ? measure(ctx, crv, &a, rep) : IX_OK;
    if (st != IX_OK) {
        ix_mv_unref(ctx, f);
        return st;
    }
    *out = f;
    return IX_OK;
}

ix_status ix_crv_field(ix_ctx *ctx, const ix_mv *crv, ix_crv_field_kind kind,
                       const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    *out = NULL;
    IX_RETURN_SCOPED(ctx, run(ctx, crv, kind, o, rep, out));
}
