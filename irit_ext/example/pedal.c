/* pedal.c - a plug-in: PEDALSRF, the pedal surface of a space curve.
 *
 * The planes that touch a curve at c(t) turn about its tangent line. The feet
 * of the perpendiculars from a point p on all of them make the pedal surface:
 * for each t a circle through p. With X, w the numerator and the weight of
 * c - p, D = X'w - Xw' (the direction of the tangent; X' if c is polynomial),
 * M = X x X' (its moment about p) and N = |D|^2, the foot on the plane with
 * normal D x M - r N M is
 *
 *     p + (D x M - r N M) / (N (1 + r^2 N)):
 *
 * tan(phi) = r |D| for the angle phi from the plane with the farthest foot, at
 * r = 0. Quadratic in r, so three control layers hold it exactly. */
#include <iritx/plugin.h>

/* What is computed on the way, released together. */
typedef struct {
    ix_mv *moved; /* c - p, three coordinates */
    ix_mv *w, *x[3], *dw, *wdx, *xdw;
    ix_mv *num, *dnum;   /* X, X' */
    ix_mv *d, *m, *n;    /* D, M, N */
    ix_mv *dm, *nm, *nn; /* D x M, N M, N^2 */
    ix_mv *layer[3], *joined;
} parts;

static void release(ix_ctx *ctx, const parts *p)
{
    const ix_mv *const all[] = {
        p->moved, p->w,      p->x[0],     p->x[1],     p->x[2],
        p->dw,    p->wdx,    p->xdw,      p->d,        p->m,
        p->n,     p->num,    p->dnum,     p->dm,       p->nm,
        p->nn,    p->joined, p->layer[0], p->layer[1], p->layer[2]};

    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        ix_mv_unref(ctx, all[i]); /* NULL is fine */
}

static ix_status translate(ix_ctx *ctx, const ix_mv *m, const double p[3],
                           double sign, ix_mv **out)
{
    const double mat[16] = {1,           0,           0,           0, 0, 1,
                            0,           0,           0,           0, 1, 0,
                            sign * p[0], sign * p[1], sign * p[2], 1};

    return ix_mv_transform(ctx, m, mat, out);
}

static ix_status scale(ix_ctx *ctx, const ix_mv *m, double s, ix_mv **out)
{
    const double mat[16] = {s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0, 0, 0, 0, 1};

    return ix_mv_transform(ctx, m, mat, out);
}

/* X and, for a rational curve, w, as polynomial curves. */
static ix_status numerator(ix_ctx *ctx, const ix_mv *c, parts *p)
{
    int first = ix_mv_rational(c);

    if (!first) {
        p->num = ix_mv_ref(c);
        return IX_OK;
    }
    IX_TRY(ix_mv_scalar(ctx, c, 0, &p->w));
    for (int i = 0; i < 3; i++)
        IX_TRY(ix_mv_scalar(ctx, c, 1 + i, &p->x[i]));
    return ix_mv_join_scalars(ctx, 3, (const ix_mv *const *)p->x, false,
                              &p->num);
}

/* D. */
static ix_status direction(ix_ctx *ctx, parts *p)
{
    IX_TRY(ix_sym_derive(ctx, p->num, 0, NULL, &p->dnum));
    if (!p->w) {
        p->d = ix_mv_ref(p->dnum);
        return IX_OK;
    }
    IX_TRY(ix_sym_derive(ctx, p->w, 0, NULL, &p->dw));
    IX_TRY(ix_sym_scale(ctx, p->dnum, p->w, NULL, &p->wdx));
    IX_TRY(ix_sym_scale(ctx, p->num, p->dw, NULL, &p->xdw));
    return ix_sym_sub(ctx, p->wdx, p->xdw, NULL, &p->d);
}

static ix_status products(ix_ctx *ctx, parts *p)
{
    IX_TRY(ix_sym_cross(ctx, p->num, p->dnum, NULL, &p->m));
    IX_TRY(ix_sym_dot(ctx, p->d, p->d, NULL, &p->n));
    IX_TRY(ix_sym_cross(ctx, p->d, p->m, NULL, &p->dm));
    IX_TRY(ix_sym_scale(ctx, p->m, p->n, NULL, &p->nm));
    return ix_sym_mul(ctx, p->n, p->n, NULL, &p->nn);
}

/* The control layer with the blossom values r of r and rr of r^2: weight
 * N + rr N^2, coordinates D x M - r N M. */
static ix_status layer(ix_ctx *ctx, const parts *p, double r, double rr,
                       ix_mv **out)
{
    ix_mv *t[4] = {NULL}, *axis[4] = {NULL};
    ix_status st = scale(ctx, p->nn, rr, &t[0]);

    if (st == IX_OK)
        st = ix_sym_add(ctx, p->n, t[0], NULL, &axis[0]);
    if (st == IX_OK)
        st = scale(ctx, p->nm, -r, &t[1]);
    if (st == IX_OK)
        st = ix_sym_add(ctx, p->dm, t[1], NULL, &t[2]);
    for (int i = 0; st == IX_OK && i < 3; i++)
        st = ix_mv_scalar(ctx, t[2], i, &axis[1 + i]);
    if (st == IX_OK)
        st = ix_mv_join_scalars(ctx, 4, (const ix_mv *const *)axis, true, out);
    for (int i = 0; i < 4; i++) {
        ix_mv_unref(ctx, t[i]);
        ix_mv_unref(ctx, axis[i]);
    }
    return st;
}

static ix_status surface(ix_ctx *ctx, const ix_mv *crv, const double pt[3],
                         double a, double b, parts *p, ix_mv **out)
{
    const ix_dir rulings = {IX_BEZIER, 3, 3, false, NULL};
    ix_mv *space;
    ix_status st;

    IX_TRY(ix_mv_coerce(ctx, crv, 3, ix_mv_rational(crv), &space));
    st = translate(ctx, space, pt, -1, &p->moved);
    ix_mv_unref(ctx, space);
    IX_TRY(st);
    IX_TRY(numerator(ctx, p->moved, p));
    IX_TRY(direction(ctx, p));
    IX_TRY(products(ctx, p));
    IX_TRY(layer(ctx, p, a, a * a, &p->layer[0]));
    IX_TRY(layer(ctx, p, (a + b) / 2, a * b, &p->layer[1]));
    IX_TRY(layer(ctx, p, b, b * b, &p->layer[2]));
    IX_TRY(ix_mv_stack(ctx, 3, (const ix_mv *const *)p->layer, &rulings,
                       &p->joined));
    return translate(ctx, p->joined, pt, 1, out);
}

static ix_status pedalsrf(const ix_host *h, ix_call *c)
{
    double a = h->arg_num(c, 2), b = h->arg_num(c, 3), pt[3];
    parts p = {.moved = NULL};
    ix_mv *out;
    ix_status st;

    if (!(b > a))
        return h->arg_fail(c, 3, "%g is not above the lower end %g", b, a);
    if (ix_mv_ncoords(h->arg_mv(c, 0)) > 3)
        return h->arg_fail(c, 0, "a curve with more than 3 coordinates");
    IX_TRY(h->arg_pt3(c, 1, pt));
    st = surface(h->ctx(c), h->arg_mv(c, 0), pt, a, b, &p, &out);
    release(h->ctx(c), &p);
    IX_TRY(st);
    return h->ret_mv(c, -1, out);
}

static const ix_plugin_row rows[] = {
    {"PEDALSRF", "c:curve p:pt3 min:num max:num -> surface",
     "The pedal surface of a curve: the feet of p on all planes that touch the "
     "curve, direction 1 along the curve, direction 2 turning the plane.",
     "s = pedalsrf(cbezier(list(point(1,0,0), point(0,1,1), point(-1,0,0))), "
     "point(0, 0, 0), -1, 1);",
     pedalsrf, 0, 0},
    {0}};

ix_status ix_plugin_init(const ix_host *h, ix_registry *r)
{
    return h->add(r, IX_PLUGIN_VERSION, rows);
}
