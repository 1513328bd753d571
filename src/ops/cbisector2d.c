/* cbisector2d.c - the correspondence of the feet of planar bisectors: scalar
 * functions F(t, r) that vanish where one circle touches both curves.
 *
 * All of them are sums of a few products of a function of t by one of r, and
 * are kept so until their control points are written. With x = p / w, D = p'w -
 * pw' (w = 1, D = p' for polynomial curves), d = w1 p2 - w2 p1 and the minors
 * of L and L', L = (w p, w^2, |p|^2), in columns x, y, 1, q:
 *
 *   1, 2   +-((d x D2)^2 |D1|^2 - (D1 x d)^2 |D2|^2), twelve products
 *   3      the determinant of the rows L1, L1', L2, L2' over -2, six products
 *   4      the point where the normals meet and, as z, -2 times function 3
 *          times the weight */
#include <limits.h>
#include <math.h>

#include "geom/parts.h"
#include "iritx/ops_plane.h"
#include "mv/mv.h"
#include "ops/lift.h"
#include "ops/plane_bisector.h"
#include "sym/outer.h"

enum { MOST = 16 };

/* --- functions of one parameter --------------------------------------------
 */

typedef struct {
    ix_form x, y, w; /* rows of the curve; w is 1 if polynomial */
    ix_form dx, dy;  /* D */
    bool rational;
} curve;

static ix_status load_curve(ix_ctx *ctx, const ix_mv *m, const ix_frame *frame,
                            curve *out)
{
    static const double one = 1.0;
    ix_form f, p, d;
    int first = m->rational ? 1 : 0;

    IX_TRY(ix__forms_load(ctx, 1, &m, frame, &f));
    p = ix__form_rows(&f, first, 2);
    out->rational = m->rational;
    if (m->rational) {
        int degree = f.dirs[0].degree;

        out->w = ix__form_rows(&f, 0, 1);
        IX_TRY(ix__form_jacobian(ctx, &p, &out->w, 0, &d));
        ix__form_times(&d, 1.0 / (degree * ix__spans_mean(&f.dirs[0])));
    } else {
        IX_TRY(ix__form_constant(ctx, &f, 1, &one, &out->w));
        IX_TRY(ix__form_derive(ctx, &p, 0, &d));
    }
    out->x = ix__form_rows(&p, 0, 1);
    out->y = ix__form_rows(&p, 1, 1);
    out->dx = ix__form_rows(&d, 0, 1);
    out->dy = ix__form_rows(&d, 1, 1);
    return IX_OK;
}

/* Products collected as rows of one form. */
typedef struct {
    ix_ctx *ctx;
    ix_status st;
    int n;
    ix_form part[MOST];
} rows;

static const ix_form *keep(rows *r, ix_status st, const ix_form *f)
{
    if (r->st == IX_OK)
        r->st = st;
    if (r->st != IX_OK)
        return NULL;
    r->part[r->n] = *f;
    return &r->part[r->n++];
}

static ix_form times(rows *r, const ix_form *a, const ix_form *b)
{
    ix_form f = *a;

    if (r->st == IX_OK)
        r->st = ix__form_mul(r->ctx, a, b, &f);
    return f;
}

/* a b - c d */
static ix_form difference(rows *r, const ix_form *a, const ix_form *b,
                          const ix_form *c, const ix_form *d)
{
    ix_form f = times(r, a, b);

    if (r->st == IX_OK)
        r->st = ix__form_mul_add(r->ctx, c, -1, d, &f);
    return f;
}

static ix_form sum(rows *r, const ix_form *a, const ix_form *b,
                   const ix_form *c, const ix_form *d)
{
    ix_form f = times(r, a, b);

    if (r->st == IX_OK)
        r->st = ix__form_mul_add(r->ctx, c, 1, d, &f);
    return f;
}

/* a^2, a b, b^2, a c, b c, c^2, all times f. */
static void quadratic(rows *r, const ix_form *const v[3], const ix_form *f)
{
    static const int pair[6][2] = {{0, 0}, {0, 1}, {1, 1},
                                   {0, 2}, {1, 2}, {2, 2}};

    for (int i = 0; i < 6; i++) {
        ix_form p = times(r, v[pair[i][0]], v[pair[i][1]]);
        ix_form q = times(r, &p, f);

        (void)keep(r, r->st, &q);
    }
}

/* The rows that functions 1 and 2 are made of: the quadratic products of (x, y,
 * w) times |D|^2, and those of w D and x D. */
static void rows_of_angles(rows *r, const curve *c)
{
    const ix_form *const point[3] = {&c->x, &c->y, &c->w};
    ix_form speed = sum(r, &c->dx, &c->dx, &c->dy, &c->dy);
    ix_form cross = difference(r, &c->x, &c->dy, &c->y, &c->dx);
    ix_form wx = times(r, &c->w, &c->dx), wy = times(r, &c->w, &c->dy);
    const ix_form *const line[3] = {&wy, &wx, &cross};
    static const double unit = 1.0;
    ix_form one;

    if (r->st != IX_OK)
        return;
    quadratic(r, point, &speed);
    r->st = ix__form_constant(r->ctx, &c->x, 1, &unit, &one);
    quadratic(r, line, &one);
}

static ix_status join(rows *r, ix_form *out)
{
    const ix_form *list[MOST];

    IX_TRY(r->st);
    for (int i = 0; i < r->n; i++)
        list[i] = &r->part[i];
    return ix__form_join(r->ctx, r->n, list, out);
}

/* --- functions 1 and 2 ------------------------------------------------------
 *
 * d x D2 = w1 cross2 - x1 (w2 D2y) + y1 (w2 D2x), a linear function of (x1, y1,
 * w1); its square has six products. */

static int angle_terms(double sign, ix_outer_term *t)
{
    /* coefficients of (x, y, w) in terms of (wDy, wDx, cross): -, +, + */
    static const double f[6] = {1, -2, 1, -2, 2, 1};
    int n = 0;

    for (int i = 0; i < 6; i++)
        t[n++] = (ix_outer_term){0, i, 6 + i, sign * f[i]};
    for (int i = 0; i < 6; i++)
        t[n++] = (ix_outer_term){0, 6 + i, i, -sign * f[i]};
    return n;
}

static ix_status angle_rows(ix_ctx *ctx, const ix_mv *m, const ix_frame *frame,
                            ix_form *out)
{
    rows r = {.ctx = ctx};
    curve c;

    IX_TRY(load_curve(ctx, m, frame, &c));
    rows_of_angles(&r, &c);
    return join(&r, out);
}

/* --- function 3 ------------------------------------------------------------
 */

/* The six minors xy, x1, y1, xq, yq, 1q of L and L'. */
enum { XY, X1, Y1, XQ, YQ, ONEQ };

static ix_status minors(ix_ctx *ctx, const ix_mv *m, const ix_frame *frame,
                        ix_form *out)
{
    static const int columns[6][2] = {{0, 1}, {0, 3}, {1, 3},
                                      {0, 4}, {1, 4}, {3, 4}};
    ix_form f, all, part[6];
    const ix_form *list[6];
    ix_mv *space;
    ix_status st;
    double scale;

    IX_TRY(ix_mv_coerce(ctx, m, 3, m->rational, &space));
    st = ix__forms_load(ctx, 1, (const ix_mv *const *)&space, frame, &f);
    ix_mv_unref(ctx, space);
    IX_TRY(st);
    IX_TRY(ix__lift_tangents(ctx, &f, m->rational, &all));
    scale = ix__spans_mean(&f.dirs[0]);
    if (m->rational) /* of L_U and L_V: -2 d h0 times those of L, L' */
        scale *= -2.0 * f.dirs[0].degree;
    for (int i = 0; i < 6; i++) {
        int sign, row = ix__lift_minor(columns[i][0], columns[i][1], &sign);

        part[i] = ix__form_rows(&all, row, 1);
        list[i] = &part[i];
    }
    IX_TRY(ix__form_join(ctx, 6, list, &f));
    IX_TRY(ix__form_copy(ctx, &f, out));
    ix__form_times(out, 1.0 / scale);
    return IX_OK;
}

static int determinant_terms(ix_outer_term *t)
{
    static const int u[6] = {XQ, YQ, XY, ONEQ, Y1, X1};
    static const int v[6] = {Y1, X1, ONEQ, XY, XQ, YQ};
    static const double f[6] = {-0.5, 0.5, -0.5, -0.5, -0.5, 0.5};

    for (int i = 0; i < 6; i++)
        t[i] = (ix_outer_term){0, u[i], v[i], f[i]};
    return 6;
}

/* --- function 4 ------------------------------------------------------------
 */

enum { EX, EY, EP, ZX, ZY = ZX + 6 }; /* rows: w^5 D, w^4 p.D, w Dx m, w Dy m */

static ix_status meeting_rows(ix_ctx *ctx, const ix_mv *m, ix_form *out)
{
    rows r = {.ctx = ctx};
    ix_form six, wx, wy, dot, f;
    curve c;

    IX_TRY(load_curve(ctx, m, NULL, &c));
    IX_TRY(minors(ctx, m, NULL, &six));
    wx = times(&r, &c.w, &c.dx);
    wy = times(&r, &c.w, &c.dy);
    dot = sum(&r, &c.x, &c.dx, &c.y, &c.dy);
    IX_TRY(r.st);
    IX_TRY(ix__form_power(ctx, &c.w, 4, &f));
    {
        ix_form e[3] = {times(&r, &wx, &f), times(&r, &wy, &f),
                        times(&r, &dot, &f)};

        for (int i = 0; i < 3; i++)
            (void)keep(&r, r.st, &e[i]);
    }
    for (int k = 0; k < 12; k++) {
        ix_form one = ix__form_rows(&six, k % 6, 1);
        ix_form p = times(&r, k < 6 ? &wx : &wy, &one);

        (void)keep(&r, r.st, &p);
    }
    return join(&r, out);
}

/* Rows w, x, y, z of the surface. */
static int meeting_terms(ix_outer_term *t)
{
    ix_outer_term six[6];
    int n = 0;

    t[n++] = (ix_outer_term){0, EX, EY, 1};
    t[n++] = (ix_outer_term){0, EY, EX, -1};
    t[n++] = (ix_outer_term){1, EP, EY, 1};
    t[n++] = (ix_outer_term){1, EY, EP, -1};
    t[n++] = (ix_outer_term){2, EX, EP, 1};
    t[n++] = (ix_outer_term){2, EP, EX, -1};
    determinant_terms(six);
    for (int i = 0; i < 6; i++) {
        t[n++] = (ix_outer_term){3, ZX + six[i].u, ZY + six[i].v,
                                 -2 * six[i].coef};
        t[n++] = (ix_outer_term){3, ZY + six[i].u, ZX + six[i].v,
                                 2 * six[i].coef};
    }
    return n;
}

/* --- the surface -----------------------------------------------------------
 */

static ix_status store(ix_ctx *ctx, const ix_outer *sum_of, int max_cont,
                       int coords, bool rational, double scale, ix_mv **out)
{
    ix_sym_opts o = {max_cont, 0};
    ix_dir dirs[2];
    ix_status st;
    ix_mv *m;

    IX_TRY(ix__outer_dirs(ctx, sum_of, &o, dirs));
    IX_TRY(ix__mv_alloc(ctx, 2, dirs, coords, rational, &m));
    st = ix__outer_points(ctx, sum_of, m->dirs, m->pts, NULL);
    for (size_t i = 0; scale != 1.0 && i < m->npts; i++)
        m->pts[i] *= scale;
    if (st == IX_OK)
        st = ix__check_finite(ctx, (size_t)sum_of->nrows * m->npts, m->pts);
    if (st == IX_OK)
        *out = m;
    else
        ix_mv_unref(ctx, m);
    return st;
}

/* A sum that is negative throughout is turned round, as for all weights. */
static void positive_weight(ix_mv *m)
{
    for (size_t i = 0; i < m->npts; i++)
        if (m->pts[i] > 0.0)
            return;
    for (size_t i = 0; i < 4 * m->npts; i++)
        m->pts[i] = -m->pts[i];
}

static ix_status build(ix_ctx *ctx, const ix_mv *const *c, int func,
                       int max_cont, ix_mv **out)
{
    ix_outer_term terms[24];
    ix_outer s = {.nrows = func == 4 ? 4 : 1, .terms = terms};
    ix_frame frame;
    ix_form side[2];

    IX_TRY(ix__frame_of(ctx, 2, c, &frame));
    if (frame.ncoords < 3)
        frame.shift[2] = 0.0;
    frame.ncoords = 3;
    for (int i = 0; i < 2; i++) {
        if (func == 4)
            IX_TRY(meeting_rows(ctx, c[i], &side[i]));
        else if (func == 3)
            IX_TRY(minors(ctx, c[i], &frame, &side[i]));
        else
            IX_TRY(angle_rows(ctx, c[i], &frame, &side[i]));
    }
    s.u = &side[0];
    s.v = &side[1];
    s.nterms = func == 4   ? meeting_terms(terms)
               : func == 3 ? determinant_terms(terms)
                           : angle_terms(func == 1 ? 1.0 : -1.0, terms);
    if (func == 4) {
        IX_TRY(store(ctx, &s, max_cont, 3, true, 1.0, out));
        positive_weight(*out);
        return IX_OK;
    }
    return store(ctx, &s, max_cont, 1, false,
                 ldexp(1.0, (func == 3 ? 4 : 6) * frame.exp), out);
}

static ix_status scoped(ix_ctx *ctx, const ix_mv *const *c, int func,
                        const ix_op_opts *o, ix_mv **out)
{
    ix_mv **flat;
    ix_status st;

    IX_TRY(ix__plane_curves(ctx, 2, c, &flat));
    st = build(ctx, (const ix_mv *const *)flat, func, o ? o->max_cont : INT_MAX,
               out);
    ix__mv_unref_all(ctx, flat, 2);
    return st;
}

ix_status ix_cbisector2d(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                         int func, const ix_op_opts *o, ix_mv **out)
{
    const ix_mv *const c[2] = {c1, c2};

    *out = NULL;
    if (func < 1 || func > 4)
        return IX_FAIL(ctx, IX_EARG, "function %d: there are 1 to 4", func);
    IX_RETURN_SCOPED(ctx, scoped(ctx, c, func, o, out));
}
