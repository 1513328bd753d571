/* pt_srf_bisector.c - the bisector of a point and a surface.
 *
 * With S = p / w, the tangent plane m.X + c = 0 of S, and r = p - w Q: the
 * point S + lambda m of the normal has the distance |r / w + lambda m| from Q
 * and |lambda m| from S, so that lambda = |r|^2 / (2 w^2 h), h = m.Q + c = -m.r
 * / w, and
 *
 *   B = (2 w h p + |r|^2 m) / (2 w^2 h).
 *
 * All of that in the surface's own frame, around Q if it is next to the
 * surface: with a far Q as the origin the differences that make m would cancel.
 *
 * The forms naive and IRIT solve S_u.B = S_u.S, S_v.B = S_v.S, (S - Q).B =
 * (S - Q).(S + Q) / 2 by Cramer's rule on fractions instead, each row over one
 * denominator. */
#include "geom/vec3.h"
#include "iritx/ops_bisect.h"
#include "ops/report.h"
#include "ops/srf_naive.h"

typedef struct {
    ix_surface s;
    double q[3]; /* in the frame of s */
    ix_form wq, r, h;
} task;

/* h is zero where the tangent plane passes through Q. */
static ix_status check_planes(ix_ctx *ctx, const task *k)
{
    double at_q, m, r, c, q;
    ix_form at_origin = ix__form_rows(&k->s.plane, 3, 1);

    IX_TRY(ix__form_bound(ctx, &k->h, &at_q));
    IX_TRY(ix__form_bound(ctx, &k->s.m, &m));
    IX_TRY(ix__form_bound(ctx, &k->r, &r));
    IX_TRY(ix__form_bound(ctx, &at_origin, &c));
    q = ix__len3(k->q);
    /* of the terms of h, and of all it could be */
    if (at_q > k->s.band * fmax(m * r, m * q + c))
        return IX_OK;
    return IX_FAIL(ctx, IX_EDOMAIN,
                   "all tangent planes pass through the point (within %.3g of "
                   "the size of both): a plane, or a cone with its apex there",
                   at_q / (m * r));
}

/* With Q elsewhere than at the origin: r = p - w Q, h = c + m.Q. */
static ix_status seen_from(ix_ctx *ctx, task *k, const ix_form *c)
{
    ix_form at, x;

    IX_TRY(ix__form_constant(ctx, &k->s.p, 3, k->q, &at));
    IX_TRY(ix__form_mul(ctx, &at, &k->s.w, &k->wq));
    IX_TRY(ix__form_add(ctx, &k->s.p, -1, &k->wq, &k->r));
    IX_TRY(ix__form_dot(ctx, &k->s.m, &at, &x));
    return ix__form_add(ctx, c, 1, &x, &k->h);
}

static ix_status load(ix_ctx *ctx, const ix_mv *srf, const double q[3], task *k)
{
    ix_form c;

    IX_TRY(ix__surface_load_plane(ctx, srf, q, &k->s));
    for (int i = 0; i < 3; i++)
        k->q[i] = ldexp(q[i] - k->s.frame.shift[i], -k->s.frame.exp);
    c = ix__form_rows(&k->s.plane, 3, 1);
    k->r = k->s.p;
    k->h = c;
    if (!k->s.centred)
        IX_TRY(seen_from(ctx, k, &c));
    return check_planes(ctx, k);
}

/* w f; a copy if w is 1. */
static ix_status weighed(ix_ctx *ctx, const task *k, const ix_form *f,
                         ix_form *out)
{
    return k->s.rational ? ix__form_mul(ctx, f, &k->s.w, out)
                         : ix__form_copy(ctx, f, out);
}

static ix_status minimal(ix_ctx *ctx, const task *k, ix_form *x, ix_form *den)
{
    ix_form y, rr;

    IX_TRY(weighed(ctx, k, &k->h, den));
    ix__form_times(den, 2.0);
    IX_TRY(ix__form_mul(ctx, &k->s.p, den, x));
    IX_TRY(ix__form_dot(ctx, &k->r, &k->r, &rr));
    IX_TRY(ix__form_mul(ctx, &k->s.m, &rr, &y));
    IX_TRY(ix__form_add(ctx, x, 1, &y, x));
    return k->s.rational ? ix__form_mul(ctx, den, &k->s.w, den) : IX_OK;
}

/* Rows S_u, S_v, S - Q times w, so that their right sides have the same
 * weights. */
static ix_status rows_of(ix_ctx *ctx, const task *k, ix_form row[3],
                         ix_form right[3])
{
    const ix_surface *s = &k->s;
    ix_frac d, f = {s->p, s->w, s->rational};
    ix_form sum;

    for (int i = 0; i < 2; i++) {
        IX_TRY(ix__ratio_partial(ctx, &f, i, &d));
        IX_TRY(ix__form_dot(ctx, &d.x, &s->p, &right[i]));
        row[i] = d.x;
    }
    sum = s->p;
    if (!s->centred)
        IX_TRY(ix__form_add(ctx, &s->p, 1, &k->wq, &sum));
    IX_TRY(ix__form_dot(ctx, &k->r, &sum, &right[2]));
    ix__form_times(&right[2], 0.5);
    row[2] = k->r;
    for (int i = 0; i < 3 && s->rational; i++)
        IX_TRY(ix__form_mul(ctx, &row[i], &s->w, &row[i]));
    return IX_OK;
}

static ix_status cramer(ix_ctx *ctx, const task *k, ix_form *x, ix_form *den)
{
    ix_form row[3] = {{0}}, right[3], cross, term;

    IX_TRY(rows_of(ctx, k, row, right));
    for (int i = 0; i < 3; i++) {
        IX_TRY(
            ix__form_cross(ctx, &row[(i + 1) % 3], &row[(i + 2) % 3], &cross));
        IX_TRY(ix__form_mul(ctx, &cross, &right[i], &term));
        if (i == 0) {
            IX_TRY(ix__form_dot(ctx, &row[0], &cross, den));
            *x = term;
        } else {
            IX_TRY(ix__form_add(ctx, x, 1, &term, x));
        }
    }
    return IX_OK;
}

static ix_status build(ix_ctx *ctx, const ix_mv *srf, const double q[3],
                       const ix_op_opts *o, ix_mv **out)
{
    task k;
    ix_form x, den;
    ix__field f = {&den, &x, 0, &k.s.frame};

    IX_TRY(load(ctx, srf, q, &k));
    if (ix__naive_wanted(o))
        IX_TRY(cramer(ctx, &k, &x, &den));
    else
        IX_TRY(minimal(ctx, &k, &x, &den));
    return ix__field_store(ctx, &f, o, out);
}

/* --- the report ------------------------------------------------------------
 */

/* Distances from Q and from the foot, and the sine between B - S and n. */
static ix_status residual_at(ix_ctx *ctx, const ix_mv *srf, const ix_mv *b,
                             const double q[3], const double t[2],
                             double *worst)
{
    double x[3], f[3], e[3], r, size;
    ix_srf_jet j;
    ix_status st = ix__srf_jet(ctx, srf, t[0], t[1], &j);

    if (st == IX_OK)
        st = ix_mv_point(ctx, b, t, x);
    if (st == IX_EDOMAIN)
        return IX_OK;
    IX_TRY(st);
    ix__sub3(x, j.s, f);
    r = ix__dist3(x, q);
    size = fmax(r, ix__dist3(j.s, q));
    if (!(r <= 1e6 * (ix__dist3(j.s, q) + ix__len3(j.s)))) /* a pole */
        return IX_OK;
    ix__cross3(f, j.n, e);
    *worst = fmax(*worst, fabs(r - ix__len3(f)) / size);
    *worst = fmax(*worst, ix__len3(e) / (size * ix__len3(j.n)));
    return IX_OK;
}

static ix_status measure(ix_ctx *ctx, const ix_mv *srf, const ix_mv *b,
                         const double q[3], ix_report *rep)
{
    rep->residual = 0.0;
    rep->how = "equal distances along the normal on a 5 x 5 grid, relative";
    for (int i = 0; i < IX__PLACES; i++) {
        double t[2];

        ix__report_place(srf, i, t);
        IX_TRY(residual_at(ctx, srf, b, q, t, &rep->residual));
    }
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, const ix_mv *srf, const double q[3],
                     const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    ix_degree_form form;
    ix_status st;
    ix_mv *b;

    for (int k = 0; k < 3; k++)
        if (!isfinite(q[k]))
            return IX_FAIL(ctx, IX_EARG, "coordinate %d of the point is %g",
                           k + 1, q[k]);
    IX_TRY(ix__form_of_opts(ctx, o, &form));
    IX_TRY(build(ctx, srf, q, o, &b));
    ix__report_init(rep, form, b);
    st = rep ? measure(ctx, srf, b, q, rep) : IX_OK;
    if (st == IX_OK)
        *out = b;
    else
        ix_mv_unref(ctx, b);
    return st;
}

ix_status ix_pt_srf_bisector(ix_ctx *ctx, const ix_mv *srf, const double q[3],
                             const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    *out = NULL;
    IX_RETURN_SCOPED(ctx, run(ctx, srf, q, o, rep, out));
}
