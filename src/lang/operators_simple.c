/* operators_simple.c - operators on strings, points, vectors, matrices and
 * lists. Matrices are row-major and act on row vectors. */
#include <math.h>
#include <string.h>

#include "base/numfmt.h"
#include "geom/matrix.h"
#include "lang/interp_impl.h"
#include "lang/operators_impl.h"

static ix_status done(ix_obj *o, ix_obj **out)
{
    *out = o;
    return o ? IX_OK : IX_ENOMEM;
}

/* --- strings
 * -------------------------------------------------------------------- */

static ix_status join(ix_interp *in, const char *a, size_t na, const char *b,
                      size_t nb, ix_obj **out)
{
    ix_buf t;
    ix_status st;

    ix__buf_init(&t, in->ctx);
    ix__buf_add(&t, a, na);
    ix__buf_add(&t, b, nb);
    st = ix__buf_check(&t);
    if (st == IX_OK)
        st = done(ix__obj_string(in->ctx, t.data ? t.data : "", t.len), out);
    ix__buf_free(&t);
    return st;
}

ix_status ix__op_str_str(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    return join(in, l->u.str.s, l->u.str.len, r->u.str.s, r->u.str.len, out);
}

/* One operand is a number, written in the format f. */
static ix_status join_number(ix_interp *in, const char *f, const ix_obj *l,
                             const ix_obj *r, ix_obj **out)
{
    const ix_obj *num = l->type == IX_OBJ_NUMBER ? l : r;
    const ix_obj *str = num == l ? r : l;
    ix_numfmt fmt;
    ix_buf t;
    ix_status st;

    if (!ix__numfmt_parse(f, &fmt))
        return IX_FAIL(in->ctx, IX_EARG, "FloatFrmt \"%s\" is no number format",
                       f);
    ix__buf_init(&t, in->ctx);
    ix__numfmt_put(&t, &fmt, num->u.num);
    st = ix__buf_check(&t);
    if (st == IX_OK)
        st = num == l
                 ? join(in, t.data, t.len, str->u.str.s, str->u.str.len, out)
                 : join(in, str->u.str.s, str->u.str.len, t.data, t.len, out);
    ix__buf_free(&t);
    return st;
}

ix_status ix__op_add_str_num(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    return join_number(in, "%d", l, r, out);
}

ix_status ix__op_pow_str_num(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    return join_number(in, in->states.float_format, l, r, out);
}

/* --- points and vectors
 * ------------------------------------------------------------ */

ix_status ix__op_add_pv(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    const double *a = l->u.pt, *b = r->u.pt;

    return done(ix__obj_vector(
                    in->ctx, (double[]){a[0] + b[0], a[1] + b[1], a[2] + b[2]}),
                out);
}

ix_status ix__op_sub_pv(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    const double *a = l->u.pt, *b = r->u.pt;

    return done(ix__obj_vector(
                    in->ctx, (double[]){a[0] - b[0], a[1] - b[1], a[2] - b[2]}),
                out);
}

ix_status ix__op_dot(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    const double *a = l->u.pt, *b = r->u.pt;

    return done(
        ix__obj_number(in->ctx, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]), out);
}

/* a ^ b is b x a (spec/language 5.5). */
ix_status ix__op_cross(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    const double *a = r->u.pt, *b = l->u.pt;

    return done(ix__obj_vector(in->ctx, (double[]){a[1] * b[2] - a[2] * b[1],
                                                   a[2] * b[0] - a[0] * b[2],
                                                   a[0] * b[1] - a[1] * b[0]}),
                out);
}

ix_status ix__op_scale(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    const ix_obj *a = l->type == IX_OBJ_NUMBER ? r : l;
    double s = a == l ? r->u.num : l->u.num, v[16];
    int n = a->type == IX_OBJ_MATRIX ? 16 : 3;

    for (int i = 0; i < n; i++)
        v[i] = s * (n == 16 ? a->u.mat[i] : a->u.pt[i]);
    if (n == 16)
        return done(ix__obj_matrix(in->ctx, v), out);
    if (a->type == IX_OBJ_POINT)
        return done(ix__obj_point(in->ctx, v), out);
    return done(ix__obj_vector(in->ctx, v), out);
}

/* --- matrices
 * ------------------------------------------------------------------------ */

ix_status ix__op_add_mat(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    double m[16];

    for (int i = 0; i < 16; i++)
        m[i] = l->u.mat[i] + r->u.mat[i];
    return done(ix__obj_matrix(in->ctx, m), out);
}

ix_status ix__op_sub_mat(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    double m[16];

    for (int i = 0; i < 16; i++)
        m[i] = l->u.mat[i] - r->u.mat[i];
    return done(ix__obj_matrix(in->ctx, m), out);
}

ix_status ix__op_mul_mat(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    double m[16];

    ix__mat_mul(l->u.mat, r->u.mat, m);
    return done(ix__obj_matrix(in->ctx, m), out);
}

/* m^n by repeated squaring. */
static void power(const double m[16], unsigned n, double out[16])
{
    double base[16];

    memcpy(base, m, sizeof base);
    ix__mat_identity(out);
    for (; n; n >>= 1) {
        if (n & 1)
            ix__mat_mul(out, base, out);
        ix__mat_mul(base, base, base);
    }
}

ix_status ix__op_mat_power(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    double m[16], n = r->u.num;

    if (n == -1) {
        if (!ix__mat_inverse(l->u.mat, m))
            return IX_FAIL(in->ctx, IX_EDOMAIN,
                           "the matrix is singular: it has no inverse");
    } else if (n == -2) {
        for (int i = 0; i < 16; i++)
            m[i] = l->u.mat[i % 4 * 4 + i / 4];
    } else if (n >= 0 && n <= 1e9 && n == floor(n)) {
        power(l->u.mat, (unsigned)n, m);
    } else {
        return IX_FAIL(in->ctx, IX_EARG,
                       "matrix ^ %g: the exponent must be a whole number >= 0, "
                       "-1 (inverse) or -2 (transpose)",
                       n);
    }
    return done(ix__obj_matrix(in->ctx, m), out);
}

/* --- lists
 * ------------------------------------------------------------------------------
 */

static ix_status append_all(ix_interp *in, ix_obj *to, const ix_obj *from)
{
    for (int i = 0; i < from->u.list.n; i++)
        IX_TRY(ix__obj_append(in->ctx, to, from->u.list.item[i]));
    return IX_OK;
}

ix_status ix__op_add_list(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out)
{
    ix_obj *list = ix__obj_list(in->ctx);
    ix_status st;

    if (!list)
        return IX_ENOMEM;
    st = append_all(in, list, l);
    if (st == IX_OK)
        st = append_all(in, list, r);
    if (st == IX_OK)
        *out = list;
    else
        ix__obj_unref(in->ctx, list);
    return st;
}

/* --- unary minus of simple values
 * ---------------------------------------------------------- */

static void reverse_string(ix_obj *o)
{
    char *s = o->u.str.s;

    for (size_t i = 0, j = o->u.str.len; i + 1 < j; i++) {
        char c = s[i];

        s[i] = s[--j];
        s[j] = c;
    }
}

bool ix__op_negate_simple(ix_obj *o)
{
    switch (o->type) {
    case IX_OBJ_NUMBER:
        o->u.num = -o->u.num;
        return true;
    case IX_OBJ_POINT:
    case IX_OBJ_VECTOR:
        for (int i = 0; i < 3; i++)
            o->u.pt[i] = -o->u.pt[i];
        return true;
    case IX_OBJ_PLANE:
        for (int i = 0; i < 4; i++)
            o->u.plane[i] = -o->u.plane[i];
        return true;
    case IX_OBJ_MATRIX:
        for (int i = 0; i < 16; i++)
            o->u.mat[i] = -o->u.mat[i];
        return true;
    case IX_OBJ_CTLPT: {
        ix_ctlpt *p = o->u.ctlpt;

        for (int i = p->rational; i < p->ncoords + p->rational; i++)
            p->v[i] = -p->v[i];
        return true;
    }
    case IX_OBJ_STRING:
        reverse_string(o);
        return true;
    default:
        return false;
    }
}
