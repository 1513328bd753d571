/* pt_crv.c - what the bisectors of a point and a curve have in common, in the
 * plane and in space. */
#include "ops/pt_crv.h"

#include <float.h>

#include "geom/vec3.h"

/* r = p - w q. */
static ix_status relative(ix_ctx *ctx, ix_pt_crv *c)
{
    ix_form q;

    c->r = c->c.p;
    if (c->c.centred)
        return IX_OK;
    IX_TRY(ix__form_constant(ctx, &c->c.p, c->c.dim, c->q, &q));
    IX_TRY(ix__form_mul(ctx, &q, &c->c.w, &q));
    return ix__form_add(ctx, &c->c.p, -1, &q, &c->r);
}

/* Rounding of r: of the input, of both products with w. */
static ix_status r_extents(ix_ctx *ctx, ix_pt_crv *c)
{
    double *error, far = 1.0;

    IX_SCRATCH(ctx, error, c->r.dirs[0].nspans);
    for (int k = 0; k < c->c.dim; k++)
        far = fmax(far, fabs(c->q[k]));
    for (int j = 0; j < c->r.dirs[0].nspans; j++)
        error[j] = c->c.frame.noise + far * DBL_EPSILON * (c->c.degree + 2);
    return ix__extents(ctx, &c->r, error, &c->er);
}

static ix_status check_spans(ix_ctx *ctx, const ix_pt_crv *c)
{
    const ix_spans *sp = &c->r.dirs[0];

    for (int j = 0; j < sp->nspans; j++)
        if (ix__extent_is_zero(c->c.ed[j]))
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "the curve is a point over [%g, %g]", sp->breaks[j],
                           sp->breaks[j + 1]);
    return IX_OK;
}

ix_status ix__pt_crv_load(ix_ctx *ctx, const ix_mv *crv, ix__curve_kind kind,
                          const double *q, double alpha, bool simplify,
                          ix_pt_crv *out)
{
    ix_pt_crv c;
    int dim = kind == IX__CURVE_SPACE ? 3 : 2;

    for (int k = 0; k < dim; k++)
        if (!isfinite(q[k]))
            return IX_FAIL(ctx, IX_EARG, "coordinate %d of the point is %g",
                           k + 1, q[k]);
    if (!isfinite(alpha))
        return IX_FAIL(ctx, IX_EARG, "a ratio of %g; it must be finite", alpha);
    IX_TRY(ix__curve_load_tangent(ctx, crv, kind, q, simplify, &c.c));
    for (int k = 0; k < dim; k++)
        c.q[k] = ldexp(q[k] - c.c.frame.shift[k], -c.c.frame.exp);
    IX_TRY(relative(ctx, &c));
    IX_TRY(r_extents(ctx, &c));
    IX_TRY(check_spans(ctx, &c));
    IX_TRY(ix__form_dot(ctx, &c.r, &c.c.d, &c.rd));
    IX_TRY(ix__form_dot(ctx, &c.r, &c.r, &c.rr));
    ix__form_times(&c.rr, 1.0 - alpha);
    *out = c;
    return IX_OK;
}

ix_status ix__pt_crv_check(ix_ctx *ctx, const ix_pt_crv *c,
                           const ix_form *cross)
{
    const ix_spans *sp = &cross->dirs[0];
    ix_extent *e;

    IX_TRY(ix__extents(ctx, cross, NULL, &e));
    for (int j = 0; j < sp->nspans; j++) {
        ix_extent terms = ix__extent_mul(c->er[j], c->c.ed[j], sp->degree);

        if (!(e[j].size > terms.error))
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "over [%g, %g] the curve is a straight line through "
                           "the point: their bisector is at infinity",
                           sp->breaks[j], sp->breaks[j + 1]);
    }
    return IX_OK;
}

/* N with D x r = w N: minors of (p, w, Q w) and its partials. As p' x p - D x
 * Q, it has no large terms to cancel when Q is far. */
ix_status ix__pt_crv_ruling(ix_ctx *ctx, const ix_pt_crv *c, ix_form *out)
{
    int d = c->c.degree;
    ix_form dp, pv, q, dq;

    IX_TRY(ix__form_derive(ctx, &c->c.p, 0, &dp));
    IX_TRY(ix__form_partial(ctx, &c->c.p, 0, IX__V, &pv));
    IX_TRY(ix__form_cross(ctx, &dp, &pv, out));
    ix__form_times(out, d > 0 ? 1.0 / d : 0.0);
    if (!c->c.centred) {
        IX_TRY(ix__form_constant(ctx, &c->r, 3, c->q, &q));
        IX_TRY(ix__form_cross(ctx, &c->c.d, &q, &dq));
        IX_TRY(ix__form_add(ctx, out, -1, &dq, out));
    }
    return ix__pt_crv_check(ctx, c, out);
}

ix_status ix__pt_crv_weigh(ix_ctx *ctx, const ix_pt_crv *c, const ix_form *f,
                           ix_form *out)
{
    ix_form own;

    if (c->c.rational)
        return ix__form_mul(ctx, f, &c->c.w, out);
    IX_TRY(ix__form_copy(ctx, f, &own));
    *out = own;
    return IX_OK;
}

void ix__pt_crv_residual(const ix_probe *at, const double b[3],
                         const ix_pt_crv_probe *arg, double *worst)
{
    double q[3] = {arg->q[0], arg->q[1], arg->q[2]}, r[3], n[3], m[3], len;

    ix__sub3(at->x[0], q, r);
    ix__sub3(b, at->x[0], n);
    ix__axpy3(b, arg->alpha - 1.0, r, m);
    ix__sub3(m, q, m); /* b - (Q + (1 - alpha) (x - Q)) */
    len = ix__len3(n);
    if (!(len <= 1e6 * (1.0 + ix__len3(at->x[0]) + ix__len3(q)))) /* a pole */
        return;
    /* a foot cannot be known better than its coordinates */
    len = fmax(len, 1e-4 * (ix__len3(b) + ix__len3(q)));
    *worst = fmax(*worst,
                  fabs(ix__dot3(n, at->x[1])) / (len * ix__len3(at->x[1])));
    *worst = fmax(*worst,
                  fabs(ix__dot3(m, r)) / (len * fmax(ix__len3(r), len)));
}

ix_status ix__pt_crv_from_point(ix_ctx *ctx, const ix_pt_crv *c,
                                const ix_form *n, const ix_form *w, ix_form *x)
{
    ix_form q;

    *x = *n;
    if (c->c.centred)
        return IX_OK;
    IX_TRY(ix__form_constant(ctx, n, n->nrows, c->q, &q));
    IX_TRY(ix__form_mul(ctx, &q, w, &q));
    return ix__form_add(ctx, n, 1, &q, x);
}
