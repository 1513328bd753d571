/* crv_ruled.c - the ruled surfaces along a curve: tangent, rectifying and polar
 * developable, normal and binormal scroll.
 *
 * A surface is (X + r R) / W with rows X, R of the frame. What a ruling is in
 * the user's units is told by two degrees of homogeneity: that of the ruling
 * vector in lengths, and that of R / W in weights. */
#include <limits.h>
#include <math.h>

#include "geom/vec3.h"
#include "iritx/ops_crv.h"
#include "ops/published.h"
#include "ops/ratio.h"
#include "ops/report.h"
#include "ops/steady.h"

typedef struct {
    ix_form x, r, w;
    int length, weight;
} ruled;

/* --- minimal ------------------------------------------------------------ */

/* T Q D + w |V|^2 V. */
static ix_status rectifying(ix_ctx *ctx, const ix_curve *c, ix_form *out)
{
    ix_extent *e;
    ix_form t, tq, vv, wvv;

    IX_TRY(ix__curve_torsion(ctx, c, &t, &e));
    IX_TRY(ix__form_mul(ctx, &t, &c->q, &tq));
    IX_TRY(ix__form_dot(ctx, &c->v, &c->v, &vv));
    IX_TRY(ix__form_mul(ctx, &vv, &c->w, &wvv));
    IX_TRY(ix__form_mul(ctx, &c->v, &wvv, out));
    return ix__form_mul_add(ctx, &c->d, 1, &tq, out);
}

/* n x (w^2 p x V + Q D) over w^3 n.V; the ruling w^3 V. */
static ix_status polar(ix_ctx *ctx, const ix_curve *c, const double n[3],
                       ruled *out)
{
    ix_form normal, w2, w3, pv, nv;

    IX_TRY(ix__form_constant(ctx, &c->p, 3, n, &normal));
    IX_TRY(ix__form_power(ctx, &c->w, 2, &w2));
    IX_TRY(ix__form_power(ctx, &c->w, 3, &w3));
    IX_TRY(ix__form_cross(ctx, &c->p, &c->v, &pv));
    IX_TRY(ix__form_mul(ctx, &pv, &w2, &pv));
    IX_TRY(ix__form_mul_add(ctx, &c->d, 1, &c->q, &pv));
    IX_TRY(ix__form_cross(ctx, &normal, &pv, &out->x));
    IX_TRY(ix__form_dot(ctx, &normal, &c->v, &nv));
    IX_TRY(ix__form_mul(ctx, &nv, &w3, &out->w));
    return ix__form_mul(ctx, &c->v, &w3, &out->r);
}

static ix_status minimal(ix_ctx *ctx, const ix_curve *c, ix_ruled_kind kind,
                         const double normal[3], ruled *out)
{
    static const int scale[][2] = {[IX_RULED_TANGENT] = {1, 1},
                                   [IX_RULED_NORMAL] = {3, 4},
                                   [IX_RULED_BINORMAL] = {2, 2},
                                   [IX_RULED_RECTIFYING] = {6, 9},
                                   [IX_RULED_POLAR] = {0, 0}};

    *out = (ruled){.x = c->p,
                   .w = c->w,
                   .length = scale[kind][0],
                   .weight = scale[kind][1]};
    switch (kind) {
    case IX_RULED_TANGENT:
        out->r = c->d;
        return IX_OK;
    case IX_RULED_NORMAL:
        return ix__form_cross(ctx, &c->v, &c->d, &out->r);
    case IX_RULED_BINORMAL:
        out->r = c->v;
        return IX_OK;
    case IX_RULED_RECTIFYING:
        return rectifying(ctx, c, &out->r);
    default:
        return polar(ctx, c, normal, out);
    }
}

/* --- published ---------------------------------------------------------- */

/* x + r ([D1 D2 D3] / |D1 x D2|^2 D1 + (D1 x D2) / |D1|^2). */
static ix_status darboux(ix_ctx *ctx, const ix_curve *c, const ix_published *p,
                         ruled *out)
{
    ix_form t, bb, tq, den;

    IX_TRY(ix__published_torsion(ctx, p, &t));
    IX_TRY(ix__form_dot(ctx, &p->b, &p->b, &bb));
    IX_TRY(ix__form_mul(ctx, &t, &p->q, &tq));
    IX_TRY(ix__form_mul(ctx, &p->b, &bb, &out->r));
    IX_TRY(ix__form_mul_add(ctx, &p->d1, 1, &tq, &out->r));
    IX_TRY(ix__form_mul(ctx, &out->r, &c->w, &out->r));
    IX_TRY(ix__form_mul(ctx, &bb, &p->q, &den));
    IX_TRY(ix__form_mul(ctx, &c->p, &den, &out->x));
    return ix__form_mul(ctx, &den, &c->w, &out->w);
}

/* p / w + Q (D1 x D2) x D1 / (w^2 |D1 x D2|^2) + r D1 x D2 / w^4. */
static ix_status published_polar(ix_ctx *ctx, const ix_curve *c,
                                 const ix_published *p, ruled *out)
{
    ix_form bb, w2, bbw2, y;

    IX_TRY(ix__form_dot(ctx, &p->b, &p->b, &bb));
    IX_TRY(ix__form_power(ctx, &c->w, 2, &w2));
    IX_TRY(ix__form_mul(ctx, &bb, &w2, &bbw2));
    IX_TRY(ix__form_mul(ctx, &c->p, &bbw2, &out->x));
    IX_TRY(ix__form_mul(ctx, &out->x, &c->w, &out->x));
    IX_TRY(ix__form_cross(ctx, &p->b, &p->d1, &y));
    IX_TRY(ix__form_mul(ctx, &y, &p->q, &y));
    IX_TRY(ix__form_mul_add(ctx, &y, 1, &w2, &out->x));
    IX_TRY(ix__form_mul(ctx, &p->b, &bb, &out->r));
    return ix__form_mul(ctx, &bbw2, &w2, &out->w);
}

static ix_status published(ix_ctx *ctx, const ix_curve *c, ix_ruled_kind kind,
                           ruled *out)
{
    static const int scale[][2] = {[IX_RULED_TANGENT] = {1, 1},
                                   [IX_RULED_NORMAL] = {3, 5},
                                   [IX_RULED_BINORMAL] = {2, 3},
                                   [IX_RULED_RECTIFYING] = {0, 0},
                                   [IX_RULED_POLAR] = {2, 0}};
    ix_published p;

    *out = (ruled){.x = c->p,
                   .w = c->w,
                   .length = scale[kind][0],
                   .weight = scale[kind][1]};
    IX_TRY(ix__published_of(ctx, c, &p));
    switch (kind) {
    case IX_RULED_TANGENT:
        out->r = p.d1;
        return IX_OK;
    case IX_RULED_NORMAL:
        return ix__form_cross(ctx, &p.b, &p.d1, &out->r);
    case IX_RULED_BINORMAL:
        out->r = p.b;
        return IX_OK;
    case IX_RULED_RECTIFYING:
        return darboux(ctx, c, &p, out);
    default:
        return published_polar(ctx, c, &p, out);
    }
}

/* --- naive -------------------------------------------------------------- */

/* det(x', x'', x''') / |x' x x''|^2 x' + x' x x'' / |x'|^2. */
static ix_status naive_darboux(ix_ctx *ctx, const ix_frac *d, const ix_frac *b,
                               ix_frac *out)
{
    ix_frac d3, t, q;

    IX_TRY(ix__ratio_derive(ctx, &d[1], &d3));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, b, &d3, &t));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, b, b, &q));
    IX_TRY(ix__ratio_over(ctx, &t, &q, &t));
    IX_TRY(ix__ratio_product(ctx, ix__form_mul, &d[0], &t, &t));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &d[0], &d[0], &q));
    IX_TRY(ix__ratio_over(ctx, b, &q, &q));
    return ix__ratio_add(ctx, &t, 1, &q, out);
}

/* x + |x'|^2 / |b|^2 b x x'. */
static ix_status naive_centres(ix_ctx *ctx, const ix_frac *x, const ix_frac *d,
                               const ix_frac *b, ix_frac *out)
{
    ix_frac n, q;

    IX_TRY(ix__ratio_product(ctx, ix__form_cross, b, &d[0], &n));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &d[0], &d[0], &q));
    IX_TRY(ix__ratio_product(ctx, ix__form_mul, &n, &q, &n));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, b, b, &q));
    IX_TRY(ix__ratio_over(ctx, &n, &q, &n));
    return ix__ratio_add(ctx, x, 1, &n, out);
}

static ix_status naive(ix_ctx *ctx, const ix_curve *c, ix_ruled_kind kind,
                       ruled *out)
{
    static const int lengths[] = {[IX_RULED_TANGENT] = 1,
                                  [IX_RULED_NORMAL] = 3,
                                  [IX_RULED_BINORMAL] = 2,
                                  [IX_RULED_RECTIFYING] = 0,
                                  [IX_RULED_POLAR] = 2};
    ix_frac x = ix__ratio_of(c), d[2], b, r;

    *out = (ruled){.length = lengths[kind]};
    IX_TRY(ix__ratio_derive(ctx, &x, &d[0]));
    if (kind == IX_RULED_TANGENT)
        return ix__ratio_common(ctx, &x, &d[0], &out->x, &out->r, &out->w);
    IX_TRY(ix__ratio_derive(ctx, &d[0], &d[1]));
    IX_TRY(ix__ratio_product(ctx, ix__form_cross, &d[0], &d[1], &b));
    r = b;
    if (kind == IX_RULED_NORMAL)
        IX_TRY(ix__ratio_product(ctx, ix__form_cross, &b, &d[0], &r));
    if (kind == IX_RULED_RECTIFYING)
        IX_TRY(naive_darboux(ctx, d, &b, &r));
    if (kind == IX_RULED_POLAR)
        IX_TRY(naive_centres(ctx, &x, d, &b, &x));
    return ix__ratio_common(ctx, &x, &r, &out->x, &out->r, &out->w);
}

/* --- all forms ---------------------------------------------------------- */

static ix_status check_spans(ix_ctx *ctx, const ix_curve *c, ix_ruled_kind kind)
{
    const ix_spans *sp = &c->p.dirs[0];
    const ix_extent *e = kind == IX_RULED_TANGENT ? c->ed : c->ev;

    for (int j = 0; j < sp->nspans; j++)
        if (ix__extent_is_zero(e[j]))
            return IX_FAIL(ctx, IX_EDOMAIN, "the curve is %s over [%g, %g]",
                           kind == IX_RULED_TANGENT ? "a point"
                                                    : "straight: no normal",
                           sp->breaks[j], sp->breaks[j + 1]);
    return IX_OK;
}

typedef struct {
    ix_ruled_kind kind;
    ix_degree_form form;
    double normal[3];   /* of the planes that the minimal polar one starts in */
    int length, weight; /* how the rulings scale */
} choice;

/* Weight, start and ruling. */
static ix_status ruled_forms(ix_ctx *ctx, const ix_curve *c, void *arg,
                             ix_form *out)
{
    choice *how = arg;
    ruled s;

    if (how->form == IX_FORM_PUBLISHED)
        IX_TRY(published(ctx, c, how->kind, &s));
    else if (how->form == IX_FORM_NAIVE)
        IX_TRY(naive(ctx, c, how->kind, &s));
    else
        IX_TRY(minimal(ctx, c, how->kind, how->normal, &s));
    how->length = s.length;
    how->weight = s.weight;
    out[0] = s.w;
    out[1] = s.x;
    out[2] = s.r;
    return IX_OK;
}

static ix_status build(ix_ctx *ctx, const ix_mv *crv, ix_ruled_kind kind,
                       const double range[2], const ix_op_opts *o, ix_mv **out)
{
    choice how = {.kind = kind, .form = o->form};
    ix_form f;
    double dom[2];
    ix_curve c;

    IX_TRY(ix__curve_load(ctx, crv, IX__CURVE_SPACE, o->form == IX_FORM_MINIMAL,
                          &c));
    IX_TRY(check_spans(ctx, &c, kind));
    ix_mv_domain(crv, 0, dom);
    if (kind == IX_RULED_POLAR)
        (void)ix__steady_normal(&c.v, dom, how.normal);
    IX_TRY(ix__curve_forms(ctx, &c, ruled_forms, &how, &f));
    return ix__ruled_store(ctx, &c, &f,
                           (how.length - 1) * c.frame.exp + how.weight * c.wexp,
                           range, ix__join_rule(o), out);
}

/* --- the report --------------------------------------------------------- */

typedef struct {
    const ix_mv *srf;
    ix_ruled_kind kind;
} probe_arg;

/* The direction that a ruling has by definition. */
static void direction(const ix_probe *at, ix_ruled_kind kind, double out[3])
{
    double b[3], n[3], q = ix__dot3(at->x[1], at->x[1]);

    ix__cross3(at->x[1], at->x[2], b);
    ix__cross3(b, at->x[1], n);
    for (int k = 0; k < 3; k++)
        out[k] = kind == IX_RULED_TANGENT  ? at->x[1][k]
                 : kind == IX_RULED_NORMAL ? n[k]
                                           : b[k];
    if (kind != IX_RULED_RECTIFYING)
        return;
    for (int k = 0; k < 3; k++)
        out[k] = ix__dot3(b, at->x[3]) * q * at->x[1][k] +
                 ix__dot3(b, b) * b[k];
}

/* Both ends of a ruling: their direction, and that the line goes through the
 * point of the curve, or through points of second order contact. */
static ix_status compare(ix_ctx *ctx, const ix_probe *at, const void *arg,
                         double *worst)
{
    const probe_arg *a = arg;
    double uv[2] = {at->t, 0}, e[2][3], r[3], y[3], want[3], off[3], len;

    IX_TRY(ix_mv_point(ctx, a->srf, uv, e[0]));
    uv[1] = 1;
    IX_TRY(ix_mv_point(ctx, a->srf, uv, e[1]));
    direction(at, a->kind, want);
    ix__sub3(e[1], e[0], r);
    ix__sub3(e[0], at->x[0], y);
    if (!(ix__unit3(r, r) > 0) || !(ix__unit3(want, want) > 0))
        return IX_OK;
    len = ix__len3(y);
    if (!(len <= 1e6 * (1.0 + ix__len3(at->x[0])))) /* a pole */
        return IX_OK;
    ix__cross3(r, want, off);
    *worst = fmax(*worst, ix__len3(off));
    if (a->kind == IX_RULED_POLAR) {
        double q = ix__dot3(at->x[1], at->x[1]);

        off[0] = ix__dot3(y, at->x[1]) / (len * sqrt(q));
        off[1] = (ix__dot3(y, at->x[2]) - q) /
                 fmax(q, len * ix__len3(at->x[2]));
        *worst = fmax(*worst, fmax(fabs(off[0]), fabs(off[1])));
    } else if (len > 0) {
        ix__cross3(y, want, off);
        *worst = fmax(*worst, ix__len3(off) / fmax(len, ix__len3(at->x[0])));
    }
    return IX_OK;
}

static ix_status check_input(ix_ctx *ctx, ix_ruled_kind kind,
                             const double range[2])
{
    if (kind < IX_RULED_TANGENT || kind > IX_RULED_POLAR)
        return IX_FAIL(ctx, IX_EARG, "ruled surface %d is not in 0 .. 4",
                       (int)kind);
    if (!isfinite(range[0]) || !isfinite(range[1]) || range[0] == range[1])
        return IX_FAIL(ctx, IX_EARG,
                       "a range of rulings from %g to %g: two different finite "
                       "numbers are wanted",
                       range[0], range[1]);
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, const ix_mv *crv, ix_ruled_kind kind,
                     const double range[2], ix_op_opts o, ix_report *rep,
                     ix_mv **out)
{
    probe_arg a = {.kind = kind};
    ix_mv *s;

    IX_TRY(build(ctx, crv, kind, range, &o, &s));
    a.srf = s;
    return ix__report_probed(ctx, crv, o.form, compare, &a,
                             "position and direction of nine rulings, relative",
                             rep, s, out);
}

ix_status ix_crv_ruled(ix_ctx *ctx, const ix_mv *crv, ix_ruled_kind kind,
                       const double range[2], const ix_op_opts *o,
                       ix_report *rep, ix_mv **out)
{
    ix_op_opts own = {.max_cont = o ? o->max_cont : INT_MAX};
    *out = NULL;
    IX_TRY(check_input(ctx, kind, range));
    IX_TRY(ix__form_of_opts(ctx, o, &own.form));
    if (own.form == IX_FORM_IRIT) /* it has none of these */
        own.form = IX_FORM_MINIMAL;
    IX_RETURN_SCOPED(ctx, run(ctx, crv, kind, range, own, rep, out));
}
