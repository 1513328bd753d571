/* builtins_list.c - lists, strings, names, elements of objects (chapter 3).
 *
 * LIST keeps references to its arguments, so that a list sees later changes
 * of the variables in it; NTH and SNOC copy, NREF gives the element itself
 * (spec/language 5.10). No list ever holds itself: what would is copied. */
#include <math.h>
#include <string.h>

#include "geom/set_cover.h"
#include "lang/coerce.h"
#include "lang/deep_copy.h"
#include "lang/interp.h"

static ix_status b_list(ix_call *c)
{
    IX_TRY(ix__ret(c, ix__obj_list(c->ctx)));
    for (int i = 0; i < c->argc; i++)
        IX_TRY(ix__obj_append(c->ctx, c->result, c->argv[i]));
    return IX_OK;
}

static ix_status b_nil(ix_call *c)
{
    return ix__ret(c, ix__obj_list(c->ctx));
}

static ix_status b_coerce(ix_call *c)
{
    ix_obj *o;

    IX_TRY(ix__coerce(c->ctx, c->argv[0], ix__arg_num(c, 1), &o));
    return ix__ret(c, o);
}

static ix_status b_snoc(ix_call *c)
{
    ix_obj *x = c->argv[0], *list = c->argv[1], *copy;

    if (ix__obj_contains(x, list)) {
        IX_TRY(ix__deep_copy(c->ctx, x, &copy));
    } else {
        copy = ix__obj_copy(c->ctx, x);
    }
    return ix__list_add(c->ctx, list, copy);
}

/* Element i of argument 0, counted from base; borrowed. */
static ix_status element(ix_call *c, int base, ix_obj **out)
{
    const ix_list *l = &c->argv[0]->u.list;
    double i = round(ix__arg_num(c, 1));

    if (!(i >= base && i < base + l->n))
        return IX_ARG_FAIL(c, 1,
                           "Out of range of list: element %g of %d (from %d)",
                           i, l->n, base);
    *out = l->item[(int)i - base];
    return IX_OK;
}

static ix_status b_nth(ix_call *c)
{
    ix_obj *o;

    IX_TRY(element(c, 1, &o));
    return ix__ret(c, ix__obj_copy(c->ctx, o));
}

static ix_status b_nref(ix_call *c)
{
    ix_obj *o;

    IX_TRY(element(c, 1, &o));
    return ix__ret(c, ix__obj_ref(o));
}

static ix_status b_getname(ix_call *c)
{
    ix_obj *o;
    const char *name;

    IX_TRY(element(c, 1, &o));
    name = o->name ? o->name : "";
    return ix__ret(c, ix__obj_string(c->ctx, name, strlen(name)));
}

/* True if argument 0 was written LIST(x, ...): x is a global variable, and
 * its box is the element. */
static bool is_global(ix_call *c, const ix_obj *o)
{
    const ix_obj *v;

    for (size_t i = 0; o->name && (v = ix__var_at(c->in, i)); i++)
        if (v == o)
            return true;
    return false;
}

#define LETTERS "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"

/* A letter, then letters, digits and underscores. */
static bool is_identifier(const char *s)
{
    return strspn(s, LETTERS) > 0 && !s[strspn(s, LETTERS "0123456789_")];
}

static ix_status b_setname(ix_call *c)
{
    const char *name = ix__arg_str(c, 2);
    ix_obj *o;

    IX_TRY(element(c, 0, &o));
    if (!is_global(c, o))
        return ix__obj_set_name(c->ctx, o, name);
    if (!is_identifier(name))
        return IX_ARG_FAIL(c, 2, "\"%.60s\" is no name of a variable", name);
    return ix__var_rename(c->in, o->name, name);
}

/* --- SIZEOF
 * -------------------------------------------------------------------- */

static ix_status b_sizeof(ix_call *c)
{
    const ix_obj *o = c->argv[0];

    switch (o->type) {
    case IX_OBJ_LIST:
        return ix__ret_num(c, o->u.list.n);
    case IX_OBJ_STRING:
        return ix__ret_num(c, (double)o->u.str.len);
    case IX_OBJ_POLY:
        return ix__ret_num(c, o->u.poly->n == 1 ? o->u.poly->poly[0].n
                                                : o->u.poly->n);
    case IX_OBJ_CURVE:
        return ix__ret_num(c, o->u.mvs->n == 1
                                  ? (double)ix_mv_npts(o->u.mvs->mv[0])
                                  : o->u.mvs->n);
    case IX_OBJ_CTLPT:
        return ix__ret_num(c, o->u.ctlpt->rational ? -o->u.ctlpt->ncoords
                                                   : o->u.ctlpt->ncoords);
    case IX_OBJ_PLANE:
        return ix__ret_num(c, 4);
    default:
        return ix__ret_num(c, 3); /* point, vector */
    }
}

/* --- COORD
 * --------------------------------------------------------------------- */

static ix_status out_of_range(ix_call *c, double i, double lo, double hi)
{
    return IX_ARG_FAIL(c, 1, "coordinate %g is out of range, %g to %g", i, lo,
                       hi);
}

/* Number i of x[n]; the first is number 0. */
static ix_status ret_number(ix_call *c, double i, const double *x, int n)
{
    if (!(i >= 0 && i < n))
        return out_of_range(c, i, 0, n - 1);
    return ix__ret_num(c, x[(int)i]);
}

/* Weight 0 (of rational points only), coordinates from 1. */
static ix_status coord_of_ctlpt(ix_call *c, double i)
{
    const ix_ctlpt *p = c->argv[0]->u.ctlpt;
    int lo = p->rational ? 0 : 1;

    if (!(i >= lo && i <= p->ncoords))
        return out_of_range(c, i, lo, p->ncoords);
    return ix__ret_num(c, p->v[(int)i - lo]);
}

static ix_status coord_of_string(ix_call *c, double i)
{
    const ix_obj *s = c->argv[0];

    if (!(i >= 0 && i < (double)s->u.str.len))
        return out_of_range(c, i, 0, (double)s->u.str.len - 1);
    return ix__ret_num(c, (unsigned char)s->u.str.s[(size_t)i]);
}

/* Control point i, direction 0 fastest. */
static ix_status coord_of_mv(ix_call *c, double i)
{
    const ix_mv *m = ix__arg_mv(c, 0);
    size_t n = ix_mv_npts(m);
    ix_ctlpt p = {.ncoords = ix_mv_ncoords(m), .rational = ix_mv_rational(m)};

    if (!(i >= 0 && i < (double)n))
        return out_of_range(c, i, 0, (double)n - 1);
    for (int k = 0; k < ix_mv_naxes(m); k++)
        p.v[k] = ix_mv_axis(m, k)[(size_t)i];
    return ix__ret(c, ix__obj_ctlpt(c->ctx, &p));
}

/* A vertex as a vector that carries the vertex's attributes. */
static ix_status ret_vertex(ix_call *c, const ix_vertex *v)
{
    IX_TRY(ix__ret(c, ix__obj_vector(c->ctx, v->p)));
    return ix__attr_copy_all(c->ctx, v->attrs, &c->result->attrs);
}

/* Polygon i of a poly as a poly of one. */
static ix_status poly_part(ix_ctx *ctx, const ix_poly *p, int i, ix_obj **out)
{
    ix_poly *one = ix__poly_new(ctx, 1);

    if (!one)
        return IX_ENOMEM;
    if (ix__polygon_dup(ctx, &p->poly[i], &one->poly[0]) != IX_OK) {
        ix__poly_unref(ctx, one);
        return IX_ENOMEM;
    }
    *out = ix__obj_poly(ctx, one);
    return *out ? IX_OK : IX_ENOMEM;
}

static ix_status coord_of_poly(ix_call *c, double i)
{
    const ix_poly *p = c->argv[0]->u.poly;
    int n = p->n == 1 ? p->poly[0].n : p->n;
    ix_obj *o;

    if (!(i >= 0 && i < n))
        return out_of_range(c, i, 0, n - 1);
    if (p->n == 1)
        return ret_vertex(c, &p->poly[0].v[(int)i]);
    IX_TRY(poly_part(c->ctx, p, (int)i, &o));
    return ix__ret(c, o);
}

static ix_status b_coord(ix_call *c)
{
    const ix_obj *o = c->argv[0];
    double i = round(ix__arg_num(c, 1));

    switch (o->type) {
    case IX_OBJ_POINT:
    case IX_OBJ_VECTOR:
        return ret_number(c, i, o->u.pt, 3);
    case IX_OBJ_PLANE:
        return ret_number(c, i, o->u.plane, 4);
    case IX_OBJ_MATRIX:
        return ret_number(c, i, o->u.mat, 16);
    case IX_OBJ_CTLPT:
        return coord_of_ctlpt(c, i);
    case IX_OBJ_STRING:
        return coord_of_string(c, i);
    case IX_OBJ_LIST:
        if (!(i >= 1 && i <= o->u.list.n))
            return out_of_range(c, i, 1, o->u.list.n);
        return b_nth(c);
    case IX_OBJ_POLY:
        return coord_of_poly(c, i);
    case IX_OBJ_CURVE:
    case IX_OBJ_SURFACE:
    case IX_OBJ_TRIVAR:
    case IX_OBJ_MULTIVAR:
        return coord_of_mv(c, i);
    default:
        return IX_ARG_FAIL(c, 0, "%s has no coordinates",
                           ix__obj_type_name(o->type));
    }
}

/* --- SPLITLST
 * ------------------------------------------------------------------ */

/* How many things of one kind the object holds. */
static int parts_of(const ix_obj *o)
{
    int n = o->type == IX_OBJ_POLY ? o->u.poly->n : ix__seq_count(o);

    return n > 0 || o->type == IX_OBJ_POLY ? n : 1;
}

/* Part i on its own. */
static ix_status part(ix_ctx *ctx, const ix_obj *o, int i, ix_obj **out)
{
    const void *item;

    if (o->type == IX_OBJ_POLY)
        return poly_part(ctx, o->u.poly, i, out);
    if (ix__seq_count(o) > 0) {
        item = ix__seq_item(o, i);
        *out = ix__seq_new(ctx, o->type, 1, &item);
    } else {
        *out = ix__obj_copy(ctx, o);
    }
    return *out ? IX_OK : IX_ENOMEM;
}

static ix_status b_splitlst(ix_call *c)
{
    const ix_obj *o = c->argv[0];
    int n = parts_of(o);

    IX_TRY(ix__ret(c, ix__obj_list(c->ctx)));
    for (int i = 0; i < n; i++) {
        ix_obj *p;
        ix_status st;

        IX_TRY(part(c->ctx, o, i, &p));
        st = ix__attr_copy_all(c->ctx, o->attrs, &p->attrs);
        if (st != IX_OK) {
            ix__obj_unref(c->ctx, p);
            return st;
        }
        IX_TRY(ix__list_add(c->ctx, c->result, p));
    }
    return IX_OK;
}

/* --- SETCOVER
 * ------------------------------------------------------------------- */

/* Two numbers in a list: one range. */
static bool is_range(const ix_obj *o)
{
    return o->type == IX_OBJ_LIST && o->u.list.n == 2 &&
           o->u.list.item[0]->type == IX_OBJ_NUMBER &&
           o->u.list.item[1]->type == IX_OBJ_NUMBER;
}

static ix__range range_of(const ix_obj *o, int set)
{
    return (ix__range){o->u.list.item[0]->u.num, o->u.list.item[1]->u.num, set};
}

/* The ranges of element s of argument 0, appended to r if it is not NULL. */
static ix_status set_ranges(ix_call *c, int s, ix__range *r, int *n)
{
    const ix_obj *e = c->argv[0]->u.list.item[s];

    if (is_range(e)) {
        if (r)
            r[*n] = range_of(e, s);
        ++*n;
        return IX_OK;
    }
    if (e->type != IX_OBJ_LIST)
        return ix__wrong_element(c, 0, s, e,
                                 "a range list(a, b) or a list of ranges");
    for (int i = 0; i < e->u.list.n; i++, ++*n) {
        if (!is_range(e->u.list.item[i]))
            return IX_ARG_FAIL(c, 0,
                               "element %d holds something that is no range "
                               "list(a, b)",
                               s + 1);
        if (r)
            r[*n] = range_of(e->u.list.item[i], s);
    }
    return IX_OK;
}

static ix_status b_setcover(ix_call *c)
{
    int nsets = c->argv[0]->u.list.n, n = 0;
    ix__range *r;
    char *pick;

    for (int s = 0; s < nsets; s++)
        IX_TRY(set_ranges(c, s, NULL, &n));
    IX_SCRATCH(c->ctx, r, n);
    IX_SCRATCH(c->ctx, pick, nsets);
    n = 0;
    for (int s = 0; s < nsets; s++)
        IX_TRY(set_ranges(c, s, r, &n));
    IX_TRY(ix__set_cover(c->ctx, n, r, nsets, ix__arg_num(c, 1), pick));
    IX_TRY(ix__ret(c, ix__obj_list(c->ctx)));
    for (int s = 0; s < nsets; s++)
        if (pick[s])
            IX_TRY(ix__list_add_num(c->ctx, c->result, s));
    return IX_OK;
}

/* --- GETLINE
 * -------------------------------------------------------------------- */

/* Exactly n numbers with blanks or commas between; the rest must be blank. */
static bool parse_numbers(const ix_buf *b, int n, double *x)
{
    const char *s = b->data, *end = b->data + b->len;

    for (int i = 0; i < n && s; i++) {
        s += strspn(s, " \t,");
        s = ix_num_parse(s, end, &x[i]);
    }
    return s && s + strspn(s, " \t\r") == end;
}

static ix_obj *line_value(ix_call *c, const ix_buf *b)
{
    ix__code code = ix__code_of(ix__arg_num(c, 0));
    double x[4];

    if (code.kind == IX_CODE_TYPE && b->len > 0) {
        if (code.type == IX_OBJ_NUMBER && parse_numbers(b, 1, x))
            return ix__obj_number(c->ctx, x[0]);
        if (code.type == IX_OBJ_POINT && parse_numbers(b, 3, x))
            return ix__obj_point(c->ctx, x);
        if (code.type == IX_OBJ_VECTOR && parse_numbers(b, 3, x))
            return ix__obj_vector(c->ctx, x);
        if (code.type == IX_OBJ_PLANE && parse_numbers(b, 4, x))
            return ix__obj_plane(c->ctx, x);
    }
    return ix__obj_string(c->ctx, b->len ? b->data : "", b->len);
}

static ix_status b_getline(ix_call *c)
{
    ix_buf b;
    ix_status st;

    ix__buf_init(&b, c->ctx);
    (void)ix__in_line(c->in, &b); /* the end of input is an empty line */
    st = ix__buf_check(&b);
    if (st == IX_OK)
        st = ix__ret(c, line_value(c, &b));
    ix__buf_free(&b);
    return st;
}

const ix_builtin ix__builtins_list[] = {
    {"COERCE", "x:any type:num -> any",
     "Converts x to a type: point, vector, plane, control point; a point type "
     "E1 .. P18 of a freeform (a scalar curve or surface becomes its graph, "
     "the value in x); KV_OPEN, KV_FLOAT; BEZIER_TYPE, BSPLINE_TYPE, "
     "POWER_TYPE; curve, surface, trivariate and multivariate; a surface to "
     "TRIMSRF_TYPE or MODEL_TYPE; lists element by element.",
     "coerce(point(1, 2, 3), P3);", b_coerce, IX_B_SOFT, 3},
    {"COORD", "x:any i:num -> any",
     "Coordinate i of a point, vector, plane or matrix (from 0) or of a "
     "control point (from 1, 0 is the weight); character code i of a string; "
     "element i of a list (from 1); vertex or polygon i of a poly; control "
     "point i of a freeform (from 0, first direction fastest).",
     "coord(point(1, 2, 3), 1);", b_coord, IX_B_SOFT, 3},
    {"GETLINE", "type:num -> any",
     "Reads a line of standard input: 1, 3, 3 or 4 numbers as a NUMERIC_TYPE, "
     "POINT_TYPE, VECTOR_TYPE or PLANE_TYPE, anything else as a string.",
     "v = getline(numeric_type);", b_getline, IX_B_LOCAL, 3},
    {"GETNAME", "l:list i:num -> str", "The name of element i, from 1.",
     "a = 5: getname(list(a), 1);", b_getname, 0, 3},
    {"LIST", "elements:any... -> list",
     "A list of the elements; variables in it stay shared, so later "
     "assignments to them show in the list.",
     "list(1, vector(0, 0, 1), list(\"a\", \"b\"));", b_list, 0, 3},
    {"NIL", "-> list", "An empty list.", "nil();", b_nil, 0, 3},
    {"NREF", "l:list i:num -> any",
     "Element i, from 1, itself: what changes in place changes in the list.",
     "l = list(point(0, 0, 0)): attrib(nref(l, 1), \"rgb\", \"255,0,0\");",
     b_nref, 0, 3},
    {"NTH", "l:list i:num -> any", "A copy of element i, from 1.",
     "nth(list(4, 5, 6), 2);", b_nth, 0, 3},
    {"SETCOVER", "ranges:list tol:num -> list",
     "The indices, from 0, of the fewest elements that cover the union of "
     "all; each is a range list(a, b) or a list of ranges, gaps up to tol do "
     "not count.",
     "setcover(list(list(0, 0.4), list(0.3, 1), list(0.1, 0.9)), 1e-6);",
     b_setcover, 0, 3},
    {"SETNAME", "l:list i:num name:str -> nothing",
     "Renames element i, from 0; setname(list(a), 0, \"B\") renames the "
     "variable A.",
     "l = list(1, 2): setname(l, 0, \"FIRST\");", b_setname, 0, 3},
    {"SIZEOF", "x:list|str|poly|curve|point|vector|plane|ctlpt -> num",
     "Elements of a list; characters of a string; polygons, or vertices of a "
     "single one; control points of a curve; coordinates, negative for "
     "rational control points.",
     "sizeof(list(1, 2, 3));", b_sizeof, 0, 3},
    {"SNOC", "x:any l:list -> nothing",
     "Appends a copy of x to the list l in place.",
     "l = nil(): snoc(point(1, 2, 3), l);", b_snoc, 0, 3},
    {"SPLITLST", "x:any -> list",
     "The polygons, curves, surfaces, ... that one object holds, each as an "
     "object of its own.",
     "splitlst(axes);", b_splitlst, 0, 3},
    {NULL, NULL, NULL, NULL, NULL, 0, 0}};
