/* coerce.c - conversions between kinds of objects.
 *
 * Simple values go through one array of up to 18 numbers and a weight;
 * freeforms through functions on multivariates. Every conversion makes a new
 * object; geometry that does not change is shared. */
#include "lang/coerce.h"

#include <math.h>
#include <string.h>

#include "io/io.h"
#include "lang/codes.h"

ix__code ix__code_of(double v)
{
    ix__code c = {.kind = IX_CODE_NONE};
    int n;

    if (!(v == rint(v)) || !(fabs(v) < 1e6))
        return c;
    n = (int)v;
    if (n >= IX_OBJ_POLY && n <= IX_OBJ_MULTIVAR) {
        c.kind = IX_CODE_TYPE;
        c.type = (ix_obj_type)n;
    } else if (n >= IX__E1 && n < IX__E1 + 2 * IX_MAX_COORDS) {
        c.kind = IX_CODE_POINT;
        c.ncoords = (n - IX__E1) / 2 + 1;
        c.rational = (n - IX__E1) % 2;
    } else if (n <= IX__KV_OPEN && n >= IX__KV_OPEN - 3) {
        c.kind = IX_CODE_KNOTS;
        c.kv = (ix_kv_kind)(IX__KV_OPEN - n);
    } else if (n >= IX__BEZIER_TYPE && n <= IX__BEZIER_TYPE + 2) {
        c.kind = IX_CODE_BASIS;
        c.basis = (ix_basis)(n - IX__BEZIER_TYPE);
    }
    return c;
}

void ix__code_point_name(int ncoords, bool rational, char buf[8])
{
    int at = 0;

    buf[at++] = rational ? 'P' : 'E';
    if (ncoords >= 10)
        buf[at++] = (char)('0' + ncoords / 10 % 10);
    buf[at++] = (char)('0' + ncoords % 10);
    buf[at] = '\0';
}

/* "point type E3", "KV_OPEN", "Curve" for messages. */
static const char *code_name(const ix__code *c, char buf[8])
{
    static const char *const kv[] = {"KV_OPEN", "KV_FLOAT", "KV_PERIODIC",
                                     "KV_DISC_OPEN"};
    static const char *const basis[] = {"BEZIER_TYPE", "BSPLINE_TYPE",
                                        "POWER_TYPE"};

    switch (c->kind) {
    case IX_CODE_TYPE:
        return ix__obj_type_name(c->type);
    case IX_CODE_POINT:
        ix__code_point_name(c->ncoords, c->rational, buf);
        return buf;
    case IX_CODE_KNOTS:
        return kv[c->kv];
    case IX_CODE_BASIS:
        return basis[c->basis];
    case IX_CODE_NONE:
        break;
    }
    return "an unknown type";
}

static ix_status invalid(ix_ctx *ctx, const ix_obj *o, const ix__code *c)
{
    char buf[8];

    return IX_FAIL(ctx, IX_EARG, "Invalid coercion requested: %s to %s",
                   ix__obj_type_name(o->type), code_name(c, buf));
}

/* --- simple values -----------------------------------------------------------
 */

static bool is_simple(const ix_obj *o)
{
    return o->type == IX_OBJ_POINT || o->type == IX_OBJ_VECTOR ||
           o->type == IX_OBJ_PLANE || o->type == IX_OBJ_CTLPT;
}

/* Coordinates, zeros behind them; projected. False at weight 0. */
static bool coordinates(const ix_obj *o, double x[IX_MAX_COORDS])
{
    const ix_ctlpt *p;

    memset(x, 0, IX_MAX_COORDS * sizeof *x);
    if (o->type == IX_OBJ_PLANE) {
        memcpy(x, o->u.plane, 4 * sizeof *x);
        return true;
    }
    if (o->type != IX_OBJ_CTLPT) {
        memcpy(x, o->u.pt, 3 * sizeof *x);
        return true;
    }
    p = o->u.ctlpt;
    for (int i = 0; i < p->ncoords; i++)
        x[i] = p->rational ? p->v[i + 1] / p->v[0] : p->v[i];
    return !p->rational || p->v[0] != 0;
}

/* Homogeneous coordinates stay as they are from one rational type to another;
 * else through the projected ones. */
static ix_status to_ctlpt(ix_ctx *ctx, const ix_obj *o, int ncoords,
                          bool rational, ix_obj **out)
{
    ix_ctlpt p = {.ncoords = ncoords, .rational = rational};
    double x[IX_MAX_COORDS];

    if (o->type == IX_OBJ_CTLPT && o->u.ctlpt->rational && rational) {
        const ix_ctlpt *q = o->u.ctlpt;
        int n = q->ncoords < ncoords ? q->ncoords : ncoords;

        memcpy(p.v, q->v, (size_t)(n + 1) * sizeof *p.v);
    } else {
        if (!coordinates(o, x))
            return IX_FAIL(ctx, IX_EDOMAIN,
                           "Invalid coercion requested: the weight is 0");
        p.v[0] = 1;
        memcpy(p.v + rational, x, (size_t)ncoords * sizeof *x);
    }
    *out = ix__obj_ctlpt(ctx, &p);
    return *out ? IX_OK : IX_ENOMEM;
}

static ix_status simple_to_type(ix_ctx *ctx, const ix_obj *o, const ix__code *c,
                                ix_obj **out)
{
    double x[IX_MAX_COORDS];

    if (c->type == IX_OBJ_CTLPT)
        return to_ctlpt(ctx, o, 3, false, out);
    if (!coordinates(o, x))
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "Invalid coercion requested: the weight is 0");
    if (c->type == IX_OBJ_POINT)
        *out = ix__obj_point(ctx, x);
    else if (c->type == IX_OBJ_VECTOR)
        *out = ix__obj_vector(ctx, x);
    else if (c->type == IX_OBJ_PLANE)
        *out = ix__obj_plane(ctx, x);
    else
        return invalid(ctx, o, c);
    return *out ? IX_OK : IX_ENOMEM;
}

/* --- freeforms: one multivariate to one
 * ---------------------------------------- */

/* Node values of each direction as further coordinates behind the value of a
 * scalar function: (f, u) or (f, u, v), times the weight. */
static ix_status graph(ix_ctx *ctx, const ix_mv *m, bool rational, ix_mv **out)
{
    int n = ix_mv_ndirs(m), axes = n + 1 + rational;
    size_t npts = ix_mv_npts(m), stride = 1;
    const double *w = ix_mv_weights(m), *f = ix_mv_coord(m, 0);
    double *pts;
    ix_dir dirs[2];

    IX_SCRATCH(ctx, pts, npts * (size_t)axes);
    for (size_t i = 0; i < npts && rational; i++)
        pts[i] = w ? w[i] : 1;
    for (size_t i = 0; i < npts; i++) /* spec/model 4: weight 0 is 1e-14 */
        pts[(size_t)rational * npts + i] = w && !rational
                                               ? f[i] /
                                                     (w[i] != 0 ? w[i] : 1e-14)
                                               : f[i];
    for (int d = 0; d < n; d++) {
        double *x = pts + (size_t)(d + 1 + rational) * npts, *node;
        size_t len = (size_t)ix_mv_length(m, d);

        dirs[d] = ix_mv_dir(m, d);
        IX_SCRATCH(ctx, node, len);
        ix_knots_nodes(&dirs[d], node);
        for (size_t i = 0; i < npts; i++)
            x[i] = node[i / stride % len] * (rational ? pts[i] : 1);
        stride *= len;
    }
    return ix_mv_new(ctx, n, dirs, n + 1, rational, pts, out);
}

static ix_status to_point_type(ix_ctx *ctx, ix_obj_type type, const ix_mv *m,
                               const ix__code *c, ix_mv **out)
{
    if (ix_mv_ncoords(m) == 1 && ((type == IX_OBJ_CURVE && c->ncoords == 2) ||
                                  (type == IX_OBJ_SURFACE && c->ncoords == 3)))
        return graph(ctx, m, c->rational, out);
    return ix_mv_coerce(ctx, m, c->ncoords, c->rational, out);
}

static bool has_power(const ix_mv *m)
{
    for (int d = 0; d < ix_mv_ndirs(m); d++)
        if (ix_mv_dir(m, d).basis == IX_POWER)
            return true;
    return false;
}

static bool has_bspline(const ix_mv *m)
{
    for (int d = 0; d < ix_mv_ndirs(m); d++)
        if (ix_mv_dir(m, d).basis == IX_BSPLINE)
            return true;
    return false;
}

/* Power directions as Bezier ones; m otherwise. */
static ix_status without_power(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    if (has_power(m))
        return ix_mv_power_to_bezier(ctx, m, out);
    *out = ix_mv_ref(m);
    return IX_OK;
}

static ix_status to_bspline(ix_ctx *ctx, const ix_mv *m, ix_mv **out)
{
    ix_mv *b;
    ix_status st;

    IX_TRY(without_power(ctx, m, &b));
    st = ix_mv_to_bspline(ctx, b, out);
    ix_mv_unref(ctx, b);
    return st;
}

/* One multivariate for one, for the codes that have such a rule. */
static ix_status convert(ix_ctx *ctx, const ix_obj *o, const ix_mv *m,
                         const ix__code *c, ix_mv **out)
{
    if (c->kind == IX_CODE_POINT)
        return to_point_type(ctx, o->type, m, c, out);
    if (c->kind == IX_CODE_BASIS && c->basis == IX_BSPLINE)
        return to_bspline(ctx, m, out);
    if (c->kind == IX_CODE_KNOTS && c->kv == IX_KV_OPEN)
        return ix_mv_to_open(ctx, m, out);
    if (c->kind == IX_CODE_KNOTS && c->kv == IX_KV_FLOAT)
        return ix_mv_to_float(ctx, m, out);
    return invalid(ctx, o, c);
}

/* A copy of o with other multivariates; takes over ms. */
static ix_status with_mvs(ix_ctx *ctx, const ix_obj *o, const ix_mvs *ms,
                          ix_obj **out)
{
    ix_obj *r = ix__obj_mvs(ctx, o->type, ms);

    if (!r)
        return IX_ENOMEM;
    if (ix__attr_copy_all(ctx, o->attrs, &r->attrs) != IX_OK) {
        ix__obj_unref(ctx, r);
        return IX_ENOMEM;
    }
    *out = r;
    return IX_OK;
}

static void unref_all(ix_ctx *ctx, int n, ix_mv **mv)
{
    for (int i = 0; i < n; i++)
        ix_mv_unref(ctx, mv[i]);
}

static ix_status convert_all(ix_ctx *ctx, const ix_obj *o, const ix__code *c,
                             ix_obj **out)
{
    int n = o->u.mvs->n;
    const ix_mvs *ms;
    ix_mv **mv;

    IX_SCRATCH(ctx, mv, n);
    for (int i = 0; i < n; i++) {
        ix_status st = convert(ctx, o, o->u.mvs->mv[i], c, &mv[i]);

        if (st != IX_OK) {
            unref_all(ctx, i, mv);
            return st;
        }
    }
    ms = ix__mvs_new(ctx, n, (const ix_mv *const *)mv);
    unref_all(ctx, n, mv);
    return ms ? with_mvs(ctx, o, ms, out) : IX_ENOMEM;
}

/* --- freeforms: pieces
 * ------------------------------------------------------------ */

/* BspDomainMin or Max: a number for curves, else text "u v ...". */
static ix_status set_domain(ix_ctx *ctx, ix_obj *o, const char *name, int n,
                            const double *t)
{
    ix_buf b;
    ix_status st;

    if (n == 1)
        return ix__attr_set_real(ctx, &o->attrs, name, t[0]);
    ix__buf_init(&b, ctx);
    for (int i = 0; i < n; i++) {
        if (i)
            ix__buf_putc(&b, ' ');
        ix__buf_num(&b, t[i]);
    }
    st = ix__buf_check(&b);
    if (st == IX_OK)
        st = ix__attr_set_string(ctx, &o->attrs, name, b.data);
    ix__buf_free(&b);
    return st;
}

/* Piece i as an object of type, in power basis if asked, with its interval. */
static ix_status piece(ix_ctx *ctx, ix_obj_type type, const ix_mv_pieces *p,
                       size_t i, bool power, ix_obj **out)
{
    int n = ix_mv_ndirs(p->piece[i]);
    ix_mv *m;
    ix_obj *o;
    ix_status st;

    if (power)
        IX_TRY(ix_mv_bezier_to_power(ctx, p->piece[i], &m));
    else
        m = ix_mv_ref(p->piece[i]);
    o = ix__obj_mv(ctx, type, m);
    if (!o)
        return IX_ENOMEM;
    st = set_domain(ctx, o, "BspDomainMin", n, p->lo + i * (size_t)n);
    if (st == IX_OK)
        st = set_domain(ctx, o, "BspDomainMax", n, p->hi + i * (size_t)n);
    if (st == IX_OK)
        *out = o;
    else
        ix__obj_unref(ctx, o);
    return st;
}

static ix_status add_pieces(ix_ctx *ctx, ix_obj *list, ix_obj_type type,
                            const ix_mv *m, bool power)
{
    ix_mv_pieces p;
    ix_status st;

    IX_TRY(ix_mv_to_bezier(ctx, m, &p));
    st = IX_OK;
    for (size_t i = 0; i < p.count && st == IX_OK; i++) {
        ix_obj *o;

        st = piece(ctx, type, &p, i, power, &o);
        if (st == IX_OK) {
            st = ix__obj_append(ctx, list, o);
            ix__obj_unref(ctx, o);
        }
    }
    ix_mv_pieces_free(ctx, &p);
    return st;
}

/* One Bezier or power multivariate to the other basis. */
static ix_status one_basis(ix_ctx *ctx, const ix_obj *o, const ix_mv *m,
                           bool power, ix_obj **out)
{
    ix_mv *b, *r;
    ix_status st;
    const ix_mvs *ms;

    IX_TRY(without_power(ctx, m, &b));
    st = power ? ix_mv_bezier_to_power(ctx, b, &r) : IX_OK;
    if (!power)
        r = ix_mv_ref(b);
    ix_mv_unref(ctx, b);
    if (st != IX_OK)
        return st;
    ms = ix__mvs_new(ctx, 1, (const ix_mv *const *)&r);
    ix_mv_unref(ctx, r);
    return ms ? with_mvs(ctx, o, ms, out) : IX_ENOMEM;
}

static ix_status fill_pieces(ix_ctx *ctx, const ix_obj *o, bool power,
                             ix_obj *list)
{
    for (int i = 0; i < o->u.mvs->n; i++) {
        const ix_mv *m = o->u.mvs->mv[i];
        ix_obj *r;
        ix_status st;

        if (has_bspline(m)) {
            IX_TRY(add_pieces(ctx, list, o->type, m, power));
            continue;
        }
        IX_TRY(one_basis(ctx, o, m, power, &r));
        st = ix__obj_append(ctx, list, r);
        ix__obj_unref(ctx, r);
        IX_TRY(st);
    }
    return IX_OK;
}

/* A list of Bezier (or power) pieces; a single one as itself. */
static ix_status to_pieces(ix_ctx *ctx, const ix_obj *o, bool power,
                           ix_obj **out)
{
    ix_obj *list = ix__obj_list(ctx);
    ix_status st;

    if (!list)
        return IX_ENOMEM;
    st = fill_pieces(ctx, o, power, list);
    if (st == IX_OK && list->u.list.n == 1) {
        *out = ix__obj_ref(list->u.list.item[0]);
        ix__obj_unref(ctx, list);
        return IX_OK;
    }
    if (st == IX_OK)
        *out = list;
    else
        ix__obj_unref(ctx, list);
    return st;
}

/* --- freeforms: other types of objects
 * ------------------------------------------------ */

/* Straight uv segment number k of the boundary of a surface's domain,
 * counter-clockwise from the lower left corner. */
static ix_status boundary_segment(ix_ctx *ctx, const ix_mv *srf, int k,
                                  ix_mv **out)
{
    static const char at[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    const ix_dir dir = {.basis = IX_BEZIER, .order = 2, .length = 2};
    double dom[2][2], pts[4];

    ix_mv_domain(srf, 0, dom[0]);
    ix_mv_domain(srf, 1, dom[1]);
    for (int i = 0; i < 2; i++) {
        pts[i] = dom[0][(int)at[k + i][0]];
        pts[2 + i] = dom[1][(int)at[k + i][1]];
    }
    return ix_mv_new(ctx, 1, &dir, 2, false, pts, out);
}

/* One loop of four straight segments round the whole domain. */
static ix_status to_trimsrf(ix_ctx *ctx, const ix_mv *srf, ix_obj **out)
{
    ix_trimsrf *t = ix__trimsrf_new(ctx, srf, 1);
    ix_status st = t ? ix__trimloop_segs(ctx, &t->loop[0], 4) : IX_ENOMEM;

    for (int k = 0; k < 4 && st == IX_OK; k++) {
        ix_mv *uv;

        st = boundary_segment(ctx, srf, k, &uv);
        if (st == IX_OK)
            t->loop[0].seg[k].uv = uv;
    }
    if (st != IX_OK) {
        ix__trimsrf_unref(ctx, t);
        return st;
    }
    *out = ix__obj_trimsrf(ctx, t);
    return *out ? IX_OK : IX_ENOMEM;
}

static ix_status fill_model(ix_ctx *ctx, const ix_mv *srf, ix_model *m)
{
    m->srf[0].srf = ix_mv_ref(srf);
    IX_TRY(ix__model_loops(ctx, &m->srf[0], 1));
    IX_TRY(ix__model_loop_segs(ctx, &m->srf[0], 0, 4));
    for (int k = 0; k < 4; k++) {
        ix_mv *uv;

        IX_TRY(boundary_segment(ctx, srf, k, &uv));
        m->seg[k] = (ix_model_seg){.mask = 1, .s1 = 1, .uv1 = uv};
        m->srf[0].seg[0][k] = k + 1;
    }
    return IX_OK;
}

static ix_status to_model(ix_ctx *ctx, const ix_mv *srf, ix_obj **out)
{
    ix_model *m = ix__model_new(ctx, 1, 4);
    ix_status st = m ? fill_model(ctx, srf, m) : IX_ENOMEM;

    if (st != IX_OK) {
        ix__model_unref(ctx, m);
        return st;
    }
    *out = ix__obj_model(ctx, m);
    return *out ? IX_OK : IX_ENOMEM;
}

/* The number of directions that a type of freeform has; 0: any. */
static int dirs_of(ix_obj_type t)
{
    return t == IX_OBJ_CURVE     ? 1
           : t == IX_OBJ_SURFACE ? 2
           : t == IX_OBJ_TRIVAR  ? 3
                                 : 0;
}

static ix_status retype(ix_ctx *ctx, const ix_obj *o, const ix__code *c,
                        ix_obj **out)
{
    int want = dirs_of(c->type);

    for (int i = 0; i < o->u.mvs->n && want; i++)
        if (ix_mv_ndirs(o->u.mvs->mv[i]) != want)
            return IX_FAIL(ctx, IX_EARG,
                           "Invalid coercion requested: a multivariate of %d "
                           "directions to %s",
                           ix_mv_ndirs(o->u.mvs->mv[i]),
                           ix__obj_type_name(c->type));
    IX_TRY(with_mvs(ctx, o, ix__mvs_ref(o->u.mvs), out));
    (*out)->type = c->type;
    return IX_OK;
}

static ix_status freeform_to_type(ix_ctx *ctx, const ix_obj *o,
                                  const ix__code *c, ix_obj **out)
{
    bool mv = c->type == IX_OBJ_MULTIVAR;

    if (mv || (o->type == IX_OBJ_MULTIVAR && dirs_of(c->type)))
        return retype(ctx, o, c, out);
    if (o->type != IX_OBJ_SURFACE || o->u.mvs->n != 1)
        return invalid(ctx, o, c);
    if (c->type == IX_OBJ_TRIMSRF)
        return to_trimsrf(ctx, o->u.mvs->mv[0], out);
    if (c->type == IX_OBJ_MODEL)
        return to_model(ctx, o->u.mvs->mv[0], out);
    return invalid(ctx, o, c);
}

/* --- any object
 * ------------------------------------------------------------------------- */

static ix_status coerce_one(ix_ctx *ctx, const ix_obj *o, const ix__code *c,
                            ix_obj **out)
{
    if (c->kind == IX_CODE_TYPE && c->type == o->type) {
        *out = ix__obj_copy(ctx, o);
        return *out ? ix__obj_set_name(ctx, *out, NULL) : IX_ENOMEM;
    }
    if (is_simple(o) && c->kind == IX_CODE_POINT)
        return to_ctlpt(ctx, o, c->ncoords, c->rational, out);
    if (is_simple(o) && c->kind == IX_CODE_TYPE)
        return simple_to_type(ctx, o, c, out);
    if (!ix__obj_is_freeform(o))
        return invalid(ctx, o, c);
    if (c->kind == IX_CODE_TYPE)
        return freeform_to_type(ctx, o, c, out);
    if (c->kind == IX_CODE_BASIS && c->basis != IX_BSPLINE)
        return to_pieces(ctx, o, c->basis == IX_POWER, out);
    return convert_all(ctx, o, c, out);
}

static ix_status coerce(ix_ctx *ctx, const ix_obj *o, const ix__code *c,
                        int depth, ix_obj **out)
{
    ix_obj *list;

    if (o->type != IX_OBJ_LIST ||
        (c->kind == IX_CODE_TYPE && c->type == IX_OBJ_LIST))
        return coerce_one(ctx, o, c, out);
    if (depth > IX_MAX_DEPTH)
        return IX_FAIL(ctx, IX_EUNABLE, "lists are nested deeper than %d",
                       IX_MAX_DEPTH);
    list = ix__obj_list(ctx);
    if (!list)
        return IX_ENOMEM;
    for (int i = 0; i < o->u.list.n; i++) {
        ix_obj *item;
        ix_status st = coerce(ctx, o->u.list.item[i], c, depth + 1, &item);

        if (st == IX_OK) {
            st = ix__obj_append(ctx, list, item);
            ix__obj_unref(ctx, item);
        }
        if (st != IX_OK) {
            ix__obj_unref(ctx, list);
            return st;
        }
    }
    *out = list;
    return IX_OK;
}

ix_status ix__coerce(ix_ctx *ctx, const ix_obj *o, double code, ix_obj **out)
{
    ix__code c = ix__code_of(code);
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    if (c.kind == IX_CODE_NONE)
        st = IX_FAIL(ctx, IX_EARG, "Invalid coercion requested: %g is no type",
                     code);
    else
        st = coerce(ctx, o, &c, 1, out);
    ix__scratch_release(ctx, mk);
    return st;
}
