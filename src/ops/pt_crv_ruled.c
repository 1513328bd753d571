/* pt_crv_ruled.c - the ruled bisector surface of a point and a space curve.
 *
 * With the forms of pt_crv.h, E = D x r = w N the direction of a ruling (N =
 * p' x r - ... of degree 2d - 2) and b = B - Q, the lines of centres
 *
 *   w D.b = r.D      w r.b = rr
 *
 * meet the plane n.b = h in
 *
 *   b = ((r.D) r x n + rr n x D + h w E) / (w n.E)                (planes)
 *
 * and the plane E.b = 0 through Q, which is the one through x, in
 *
 *   b = ((r.D) r x E + rr E x D) / (w |E|^2)                      (directrix)
 *
 * in which a factor w cancels with E = w N. */
#include <limits.h>
#include <string.h>

#include "geom/crvs.h"
#include "geom/vec3.h"
#include "iritx/ops_bisect.h"
#include "ops/pt_crv.h"
#include "ops/published.h"
#include "ops/ratio.h"
#include "ops/steady.h"

/* (x + h ruling 2^exp) / w in the frame. */
typedef struct {
    ix_form x, r, w;
    int exp;
} ruled;

/* s (a x b) + t (c x a): what both approaches solve their planes by. */
static ix_status two_crosses(ix_ctx *ctx, const ix_form *s, const ix_form *a,
                             const ix_form *b, const ix_form *t,
                             const ix_form *c, ix_form *out)
{
    ix_form ab, bc;

    IX_TRY(ix__form_cross(ctx, a, b, &ab));
    IX_TRY(ix__form_cross(ctx, b, c, &bc));
    IX_TRY(ix__form_mul(ctx, &ab, s, out));
    IX_TRY(ix__form_mul(ctx, &bc, t, &bc));
    return ix__form_add(ctx, out, 1, &bc, out);
}

/* --- planes ----------------------------------------------------------------
 */

/* Weights that are zero on all of a span: its rulings are parallel to the
 * planes. */
static ix_status check_planes(ix_ctx *ctx, const ix_form *weight,
                              const ix_form *ruling)
{
    const ix_spans *sp = &weight->dirs[0];
    ix_extent *w, *e;

    IX_TRY(ix__extents(ctx, weight, NULL, &w));
    IX_TRY(ix__extents(ctx, ruling, NULL, &e));
    for (int j = 0; j < sp->nspans; j++)
        if (!(w[j].size > 1e-12 * e[j].size))
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "all rulings over [%g, %g] are parallel to the "
                           "planes: the normal has a part of %.3g along them",
                           sp->breaks[j], sp->breaks[j + 1],
                           w[j].size / e[j].size);
    return IX_OK;
}

/* With a tangent d and w times the direction of the rulings, we = w (d x r). */
static ix_status by_planes(ix_ctx *ctx, const ix_pt_crv *c, const ix_form *d,
                           const ix_form *we, const double n[3], ruled *out)
{
    ix_form normal, rd, b;

    IX_TRY(ix__form_constant(ctx, &c->r, 3, n, &normal));
    IX_TRY(ix__form_dot(ctx, &c->r, d, &rd));
    IX_TRY(two_crosses(ctx, &rd, &c->r, &normal, &c->rr, d, &b));
    IX_TRY(ix__form_dot(ctx, &normal, we, &out->w));
    IX_TRY(check_planes(ctx, &out->w, we));
    out->r = *we;
    out->exp = -c->c.frame.exp;
    return ix__pt_crv_from_point(ctx, c, &b, &out->w, &out->x);
}

static ix_status minimal_planes(ix_ctx *ctx, const ix_pt_crv *c,
                                const ix_form *ruling, const double n[3],
                                ruled *out)
{
    ix_form w2, we = *ruling;

    if (c->c.rational) {
        IX_TRY(ix__form_mul(ctx, &c->c.w, &c->c.w, &w2));
        IX_TRY(ix__form_mul(ctx, ruling, &w2, &we));
    }
    return by_planes(ctx, c, &c->c.d, &we, n, out);
}

/* D1 of its formal degree in place of D. */
static ix_status published_planes(ix_ctx *ctx, const ix_pt_crv *c,
                                  const double n[3], ruled *out)
{
    ix_published p;
    ix_form we;

    IX_TRY(ix__published_of(ctx, &c->c, &p));
    IX_TRY(ix__form_cross(ctx, &p.d1, &c->r, &we));
    IX_TRY(ix__form_mul(ctx, &we, &c->c.w, &we));
    return by_planes(ctx, c, &p.d1, &we, n, out);
}

/* --- directrix -------------------------------------------------------------
 */

/* b = ((r.D) r x N + rr N x D) / (w^2 |N|^2), the ruling -N / w^2. */
static ix_status minimal_directrix(ix_ctx *ctx, const ix_pt_crv *c,
                                   const ix_form *ruling, ruled *out)
{
    ix_form b, nn;

    IX_TRY(two_crosses(ctx, &c->rd, &c->r, ruling, &c->rr, &c->c.d, &b));
    IX_TRY(ix__form_dot(ctx, ruling, ruling, &nn));
    IX_TRY(ix__form_mul(ctx, ruling, &nn, &out->r));
    ix__form_times(&out->r, -1.0);
    IX_TRY(ix__pt_crv_weigh(ctx, c, &nn, &out->w));
    IX_TRY(ix__pt_crv_weigh(ctx, c, &out->w, &out->w));
    out->exp = c->c.frame.exp;
    return ix__pt_crv_from_point(ctx, c, &b, &out->w, &out->x);
}

/* The sum of two functions in the published manner: each of one degree, over
 * the product of the denominators. */
static ix_status sum(ix_ctx *ctx, const ruled *base, const ix_frac *ruling,
                     ruled *out)
{
    ix_frac x = {base->x, base->w, true}, r = *ruling;

    IX_TRY(ix__ratio_even(ctx, &x));
    IX_TRY(ix__ratio_even(ctx, &r));
    return ix__ratio_common(ctx, &x, &r, &out->x, &out->r, &out->w);
}

/* (5.12): the planes D1, E1 = D1 x r and r; the ruling is E1 / w. */
static ix_status published_directrix(ix_ctx *ctx, const ix_pt_crv *c,
                                     ruled *out)
{
    ix_frac ruling = {.w = c->c.w, .rational = c->c.rational};
    ix_published p;
    ix_form e, rd, b;
    ruled base;

    IX_TRY(ix__published_of(ctx, &c->c, &p));
    IX_TRY(ix__form_cross(ctx, &p.d1, &c->r, &e));
    IX_TRY(ix__form_dot(ctx, &c->r, &p.d1, &rd));
    IX_TRY(two_crosses(ctx, &rd, &c->r, &e, &c->rr, &p.d1, &b));
    IX_TRY(ix__form_dot(ctx, &e, &e, &base.w));
    IX_TRY(ix__form_mul(ctx, &base.w, &c->c.w, &base.w));
    IX_TRY(ix__pt_crv_from_point(ctx, c, &b, &base.w, &base.x));
    ruling.x = e;
    ix__form_times(&ruling.x, -1.0);
    out->exp = c->c.frame.exp + 2 * c->c.wexp;
    return sum(ctx, &base, &ruling, out);
}

/* Cramer's rule on fractions, the elements of a row over one denominator. The
 * rows are x', y = x - Q and E = y x x', whose right side is 0. */
typedef struct {
    ix_frac y, d, e, yd, yy;
    ix_form yw, dw; /* numerators over the denominators of yy and yd */
} fractions;

static ix_status fractions_of(ix_ctx *ctx, const ix_pt_crv *c, fractions *f)
{
    f->y = (ix_frac){c->r, c->c.w, c->c.rational};
    IX_TRY(ix__ratio_derive(ctx, &f->y, &f->d));
    IX_TRY(ix__ratio_product(ctx, ix__form_cross, &f->y, &f->d, &f->e));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &f->d, &f->y, &f->yd));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &f->y, &f->y, &f->yy));
    IX_TRY(ix__form_mul(ctx, &f->d.x, &c->c.w, &f->dw));
    return ix__form_mul(ctx, &f->y.x, &c->c.w, &f->yw);
}

/* Over the determinant |E|^2 of the fractions themselves. */
static ix_status naive(ix_ctx *ctx, const ix_pt_crv *c, ruled *out)
{
    ix_frac det, b;
    fractions f;
    ruled base;

    IX_TRY(fractions_of(ctx, c, &f));
    IX_TRY(ix__ratio_product(ctx, ix__form_dot, &f.e, &f.e, &det));
    IX_TRY(two_crosses(ctx, &f.yd.x, &f.yw, &f.e.x, &c->rr, &f.dw, &b.x));
    ix__form_times(&b.x, -1.0);
    IX_TRY(ix__frac_weights(ctx, &f.yd, &f.yy, &b));
    IX_TRY(ix__frac_weights(ctx, &b, &f.e, &b));
    IX_TRY(ix__ratio_over(ctx, &b, &det, &b));
    base.w = b.w;
    IX_TRY(ix__pt_crv_from_point(ctx, c, &b.x, &base.w, &base.x));
    out->exp = c->c.frame.exp;
    return sum(ctx, &base, &f.e, out);
}

/* Over the determinant of the same rows: the denominators cancel. The right
 * side of E, E.x for IRIT, has one more. */
static ix_status irit(ix_ctx *ctx, const ix_pt_crv *c, ruled *out)
{
    ix_form ew, b, cross;
    fractions f;
    ruled base;

    IX_TRY(fractions_of(ctx, c, &f));
    IX_TRY(ix__form_mul(ctx, &f.e.x, &c->c.w, &ew));
    IX_TRY(two_crosses(ctx, &f.yd.x, &f.yw, &ew, &c->rr, &f.dw, &b));
    IX_TRY(ix__form_cross(ctx, &f.yw, &ew, &cross));
    IX_TRY(ix__form_dot(ctx, &f.dw, &cross, &base.w));
    IX_TRY(ix__pt_crv_from_point(ctx, c, &b, &base.w, &base.x));
    out->exp = c->c.frame.exp;
    return sum(ctx, &base, &f.e, out);
}

/* --- all forms -------------------------------------------------------------
 */

static void fit_range(const ix_pt_crv *c, ix_ruling *r)
{
    double half = 0.0;

    if (r->range[0] != r->range[1])
        return;
    for (int k = 0; k < 3; k++) /* the curve's box is at most [-1, 1]^3 */
        half = fmax(half, fmax(1.0, 0.5 * (1.0 + fabs(c->q[k]))));
    r->range[1] = r->kind == IX_RULING_PLANES ? ldexp(half, c->c.frame.exp)
                                              : 0.5;
    r->range[0] = -r->range[1];
}

/* The unit normal of the planes. */
static void choose_normal(const ix_form *ruling, const double dom[2],
                          ix_ruling *r)
{
    if (!(ix__unit3(r->normal, r->normal) > 0))
        (void)ix__steady_normal(ruling, dom, r->normal);
}

static ix_status solved(ix_ctx *ctx, const ix_pt_crv *c, ix_degree_form form,
                        const ix_form *ruling, const ix_ruling *r, ruled *out)
{
    if (form == IX_FORM_NAIVE)
        return naive(ctx, c, out);
    if (form == IX_FORM_IRIT)
        return irit(ctx, c, out);
    if (r->kind == IX_RULING_PLANES)
        return form == IX_FORM_MINIMAL
                   ? minimal_planes(ctx, c, ruling, r->normal, out)
                   : published_planes(ctx, c, r->normal, out);
    return form == IX_FORM_MINIMAL ? minimal_directrix(ctx, c, ruling, out)
                                   : published_directrix(ctx, c, out);
}

typedef struct {
    const ix_mv *crv;
    const double *q;
    double alpha;
    ix_ruling r;
    ix_op_opts o;
} task;

/* Curve, point and rulings in their frame. */
typedef struct {
    ix_pt_crv c;
    ix_form ruling;
} loaded;

static ix_status load(ix_ctx *ctx, const task *k, bool simplify, loaded *l)
{
    IX_TRY(ix__pt_crv_load(ctx, k->crv, IX__CURVE_SPACE, k->q, k->alpha,
                           simplify, &l->c));
    return ix__pt_crv_ruling(ctx, &l->c, &l->ruling);
}

static ix_status build_of(ix_ctx *ctx, const task *k, const loaded *l,
                          ix_mv **out)
{
    ix_join_rule rule = ix__join_rule(&k->o);
    const ix_pt_crv *c = &l->c;
    ix_form all;
    ix_ruling r = k->r;
    double dom[2];
    ruled f;
    const ix_form *parts[3] = {&f.w, &f.x, &f.r};

    fit_range(c, &r);
    ix_mv_domain(k->crv, 0, dom);
    choose_normal(&l->ruling, dom, &r);
    IX_TRY(solved(ctx, c, k->o.form, &l->ruling, &r, &f));
    IX_TRY(ix__form_join(ctx, 3, parts, &all));
    rule.max_cont = k->o.max_cont; /* IRIT keeps continuity here */
    return ix__ruled_store(ctx, &c->c, &all, f.exp, r.range, rule, out);
}

static ix_status build(ix_ctx *ctx, const task *k, ix_mv **out)
{
    loaded l;

    IX_TRY(load(ctx, k, k->o.form == IX_FORM_MINIMAL, &l));
    return build_of(ctx, k, &l, out);
}

/* --- the report ------------------------------------------------------------
 */

/* Both ends of a ruling. */
static ix_status compare(ix_ctx *ctx, const ix_probe *at, const void *arg,
                         double *worst)
{
    const ix_pt_crv_probe *a = arg;

    for (int i = 0; i < 2; i++) {
        double uv[2] = {at->t, i}, b[3];
        ix_status st = ix_mv_point(ctx, a->m, uv, b);

        if (st == IX_EDOMAIN)
            continue;
        IX_TRY(st);
        ix__pt_crv_residual(at, b, a, worst);
    }
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, const task *k, ix_report *rep, ix_mv **out)
{
    ix_pt_crv_probe arg = {NULL, k->q, k->alpha};
    ix_mv *m;

    IX_TRY(build(ctx, k, &m));
    arg.m = m;
    return ix__report_probed(ctx, k->crv, k->o.form, compare, &arg,
                             "distance from normal and dividing plane, both "
                             "ends of nine rulings, relative",
                             rep, m, out);
}

static ix_status prepare(ix_ctx *ctx, const ix_ruling *r, const ix_op_opts *o,
                         task *k)
{
    if (r)
        k->r = *r;
    k->o.max_cont = o ? o->max_cont : INT_MAX;
    if (k->r.kind != IX_RULING_PLANES && k->r.kind != IX_RULING_DIRECTRIX)
        return IX_FAIL(ctx, IX_EARG, "ruling %d is not 0 or 1", (int)k->r.kind);
    for (int i = 0; i < 2; i++)
        if (!isfinite(k->r.range[i]))
            return IX_FAIL(
                ctx, IX_EARG,
                "a range of rulings from %g to %g: finite numbers are wanted",
                k->r.range[0], k->r.range[1]);
    for (int i = 0; i < 3; i++)
        if (!isfinite(k->r.normal[i]))
            return IX_FAIL(ctx, IX_EARG, "coordinate %d of the normal is %g",
                           i + 1, k->r.normal[i]);
    return ix__form_of_opts(ctx, o, &k->o.form);
}

ix_status ix_pt_crv_bisector3d(ix_ctx *ctx, const ix_mv *crv, const double q[3],
                               double alpha, const ix_ruling *r,
                               const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    task k = {.crv = crv, .q = q, .alpha = alpha};

    *out = NULL;
    IX_TRY(prepare(ctx, r, o, &k));
    IX_RETURN_SCOPED(ctx, run(ctx, &k, rep, out));
}

/* --- pieces ----------------------------------------------------------------
 */

/* Rulings stay at 11.5 degrees or more from the planes of a piece; there are at
 * most 2^MAX_DEPTH pieces. */
#define LEAST_COSINE 0.2
enum { MAX_DEPTH = 6, MAX_PIECES = 1 << MAX_DEPTH };

typedef struct {
    int n;
    double t[2 * MAX_PIECES], normal[MAX_PIECES][3];
} cuts;

/* Halves, until one plane serves each. */
static void cut(const ix_form *ruling, const double range[2], int depth,
                cuts *out)
{
    const double mid = 0.5 * (range[0] + range[1]);
    const double left[2] = {range[0], mid}, right[2] = {mid, range[1]};

    if (ix__steady_normal(ruling, range, out->normal[out->n]) < LEAST_COSINE &&
        depth < MAX_DEPTH) {
        cut(ruling, left, depth + 1, out);
        cut(ruling, right, depth + 1, out);
        return;
    }
    out->t[2 * out->n] = range[0];
    out->t[2 * out->n + 1] = range[1];
    out->n++;
}

static void find_cuts(task *k, const loaded *l, cuts *out)
{
    double dom[2];

    fit_range(&l->c, &k->r);
    ix_mv_domain(k->crv, 0, dom);
    out->n = 0;
    cut(&l->ruling, dom, k->r.kind == IX_RULING_PLANES ? 0 : MAX_DEPTH, out);
}

static ix_status one_piece(ix_ctx *ctx, const task *all, const double *t,
                           const double *normal, ix_mv **out)
{
    task k = *all;
    ix_mv *part;
    ix_status st;

    memcpy(k.r.normal, normal, sizeof k.r.normal);
    IX_TRY(ix_mv_region(ctx, all->crv, 0, t[0], t[1], &part));
    k.crv = part;
    st = build(ctx, &k, out);
    ix_mv_unref(ctx, part);
    return st;
}

static ix_status pieces(ix_ctx *ctx, task *k, ix_crvs *out)
{
    ix_status st = IX_OK;
    loaded l;
    cuts *c;

    IX_SCRATCH(ctx, c, 1);
    IX_TRY(load(ctx, k, k->o.form == IX_FORM_MINIMAL, &l));
    find_cuts(k, &l, c);
    IX_TRY(ix__crvs_new(ctx, c->n, out));
    if (c->n == 1) {
        memcpy(k->r.normal, c->normal[0], sizeof c->normal[0]);
        st = build_of(ctx, k, &l, &out->crv[0]);
    }
    for (int i = 0; c->n > 1 && st == IX_OK && i < c->n; i++)
        st = one_piece(ctx, k, c->t + 2 * i, c->normal[i], &out->crv[i]);
    if (st != IX_OK)
        ix_crvs_free(ctx, out);
    else
        memcpy(out->t, c->t, 2 * (size_t)c->n * sizeof *c->t);
    return st;
}

ix_status ix_pt_crv_bisector3d_pieces(ix_ctx *ctx, const ix_mv *crv,
                                      const double q[3], double alpha,
                                      const ix_ruling *r, const ix_op_opts *o,
                                      ix_crvs *out)
{
    task k = {.crv = crv, .q = q, .alpha = alpha};

    *out = (ix_crvs){.n = 0};
    IX_TRY(prepare(ctx, r, o, &k));
    memset(k.r.normal, 0, sizeof k.r.normal);
    if (k.o.form == IX_FORM_NAIVE || k.o.form == IX_FORM_IRIT)
        k.r.kind = IX_RULING_DIRECTRIX;
    IX_RETURN_SCOPED(ctx, pieces(ctx, &k, out));
}
