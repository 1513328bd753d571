/* builtins_attr.c - attributes of objects (chapter 5). All act in place on
 * the box that they are given; values that are objects are stored as deep
 * copies, so no chain of attributes and lists can lead back to its owner. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "lang/deep_copy.h"
#include "lang/interp.h"

/* Integers are kept as such where a double tells them apart. */
#define MAX_INT 9007199254740992.0 /* 2^53 */

/* Sets one attribute to a script value. */
static ix_status set_attr(ix_ctx *ctx, ix_attr **attrs, const char *name,
                          const ix_obj *v)
{
    ix_obj *copy;
    ix_status st;

    if (v->type == IX_OBJ_STRING)
        return ix__attr_set_string(ctx, attrs, name, v->u.str.s);
    if (v->type == IX_OBJ_NUMBER && v->u.num == rint(v->u.num) &&
        fabs(v->u.num) <= MAX_INT)
        return ix__attr_set_int(ctx, attrs, name, (long long)v->u.num);
    if (v->type == IX_OBJ_NUMBER)
        return ix__attr_set_real(ctx, attrs, name, v->u.num);
    IX_TRY(ix__deep_copy(ctx, v, &copy));
    st = ix__attr_set_obj(ctx, attrs, name, copy);
    ix__obj_unref(ctx, copy);
    return st;
}

/* A name that files can carry: one word without brackets and quotes. */
static ix_status check_name(ix_call *c, int i)
{
    const char *s = ix__arg_str(c, i);

    if (!*s || s[strcspn(s, " \t\n[]\"")])
        return IX_ARG_FAIL(c, i, "\"%.60s\" is no name of an attribute", s);
    return IX_OK;
}

static ix_status b_attrib(ix_call *c)
{
    IX_TRY(check_name(c, 1));
    return set_attr(c->ctx, &c->argv[0]->attrs, ix__arg_str(c, 1), c->argv[2]);
}

static ix_status b_color(ix_call *c)
{
    return set_attr(c->ctx, &c->argv[0]->attrs, "color", c->argv[1]);
}

static ix_status b_awidth(ix_call *c)
{
    return set_attr(c->ctx, &c->argv[0]->attrs, "width", c->argv[1]);
}

static ix_status b_adwidth(ix_call *c)
{
    return set_attr(c->ctx, &c->argv[0]->attrs, "dwidth", c->argv[1]);
}

static ix_status b_attrprop(ix_call *c)
{
    ix_obj **leaf;
    int n;

    IX_TRY(check_name(c, 1));
    IX_TRY(ix__leaves(c->ctx, c->argv[0], &n, &leaf));
    for (int i = 0; i < n; i++)
        IX_TRY(
            set_attr(c->ctx, &leaf[i]->attrs, ix__arg_str(c, 1), c->argv[2]));
    return IX_OK;
}

/* "u v" as a point, or NULL if that is not what the text holds. */
static const char *parse_uv(const char *s, double uv[3])
{
    const char *end = s + strlen(s);

    s = ix_num_parse(s, end, &uv[0]);
    while (s && *s == ' ')
        s++;
    s = s ? ix_num_parse(s, end, &uv[1]) : NULL;
    uv[2] = 0;
    return s && !*s ? s : NULL;
}

static bool is_uv_name(const char *name)
{
    return ix__name_cmp(name, "uvvals") == 0 ||
           ix__name_cmp(name, "BspDomainMin") == 0 ||
           ix__name_cmp(name, "BspDomainMax") == 0;
}

/* The value of an attribute as a script sees it. */
static ix_status ret_attr(ix_call *c, const ix_attr *a)
{
    ix_obj *copy;
    double uv[3];

    switch (a->type) {
    case IX_ATTR_INT:
        return ix__ret_num(c, (double)a->i);
    case IX_ATTR_REAL:
        return ix__ret_num(c, a->r);
    case IX_ATTR_OBJ:
        IX_TRY(ix__deep_copy(c->ctx, a->obj, &copy));
        return ix__ret(c, copy);
    case IX_ATTR_STRING:
        break;
    }
    if (is_uv_name(a->name) && parse_uv(a->s, uv))
        return ix__ret(c, ix__obj_point(c->ctx, uv));
    return ix__ret(c, ix__obj_string(c->ctx, a->s, strlen(a->s)));
}

static ix_status b_getattr(ix_call *c)
{
    ix_attr *a = ix__attr_find(c->argv[0]->attrs, ix__arg_str(c, 1));

    if (!a)
        return ix__ret(c, ix__obj_list(c->ctx));
    return ret_attr(c, a);
}

static ix_status b_cpattr(ix_call *c)
{
    if (c->argv[0] == c->argv[1])
        return IX_OK;
    return ix__attr_copy_all(c->ctx, c->argv[1]->attrs, &c->argv[0]->attrs);
}

static ix_status b_rmattr(ix_call *c)
{
    ix__attr_remove(c->ctx, &c->argv[0]->attrs, ix__arg_str(c, 1));
    return IX_OK;
}

/* Vertex number argument i of the first polygon of argument 0. */
static ix_status vertex_index(ix_call *c, int i, int *out)
{
    const ix_poly *p = c->argv[0]->u.poly;

    if (p->n < 1 || p->poly[0].n < 1)
        return IX_ARG_FAIL(c, 0, "there is no vertex in it");
    return ix__arg_int(c, i, 0, p->poly[0].n - 1, out);
}

/* A copy of the polygons of argument 0 to be edited. */
static ix_status edit_poly(ix_call *c, ix_poly **out)
{
    *out = ix__poly_dup(c->ctx, c->argv[0]->u.poly);
    return *out ? IX_OK : IX_ENOMEM;
}

static void put_poly(ix_call *c, ix_poly *p)
{
    ix__poly_unref(c->ctx, c->argv[0]->u.poly);
    c->argv[0]->u.poly = p;
}

static ix_status b_pattrib(ix_call *c)
{
    int i;
    ix_poly *p;
    ix_status st;
    const ix_attr *a;

    IX_TRY(check_name(c, 2));
    IX_TRY(vertex_index(c, 1, &i));
    if (c->argv[3]->type != IX_OBJ_LIST || c->argv[3]->u.list.n > 0) {
        IX_TRY(edit_poly(c, &p));
        st = set_attr(c->ctx, &p->poly[0].v[i].attrs, ix__arg_str(c, 2),
                      c->argv[3]);
        if (st != IX_OK) {
            ix__poly_unref(c->ctx, p);
            return st;
        }
        put_poly(c, p);
    }
    a = ix__attr_find(c->argv[0]->u.poly->poly[0].v[i].attrs,
                      ix__arg_str(c, 2));
    return a ? ret_attr(c, a) : ix__ret(c, ix__obj_list(c->ctx));
}

static ix_status b_pnormal(ix_call *c)
{
    int i;
    ix_poly *p;
    ix_vertex *v;

    IX_TRY(vertex_index(c, 1, &i));
    IX_TRY(ix__ret(
        c, ix__obj_vector(c->ctx, c->argv[0]->u.poly->poly[0].v[i].normal)));
    if (c->argv[2]->type != IX_OBJ_VECTOR)
        return IX_OK;
    IX_TRY(edit_poly(c, &p));
    v = &p->poly[0].v[i];
    memcpy(v->normal, c->argv[2]->u.pt, sizeof v->normal);
    v->has_normal = true;
    put_poly(c, p);
    return IX_OK;
}

/* Copies a string attribute to every vertex that does not have it. */
static ix_status to_vertices(ix_ctx *ctx, ix_poly *p, const char *name,
                             const char *value)
{
    for (int k = 0; k < p->n; k++)
        for (int i = 0; i < p->poly[k].n; i++) {
            ix_attr **attrs = &p->poly[k].v[i].attrs;

            if (!ix__attr_find(*attrs, name))
                IX_TRY(ix__attr_set_string(ctx, attrs, name, value));
        }
    return IX_OK;
}

static ix_status b_attrvprop(ix_call *c)
{
    const char *name = ix__arg_str(c, 1);
    const ix_attr *own = ix__attr_find(c->argv[0]->attrs, name), *a;
    ix_obj **leaf;
    int n;

    if (ix__name_cmp(name, "rgb") != 0)
        return IX_ARG_FAIL(c, 1,
                           "only \"rgb\" can go to vertices, not "
                           "\"%.60s\"",
                           name);
    IX_TRY(ix__leaves(c->ctx, c->argv[0], &n, &leaf));
    for (int i = 0; i < n; i++) {
        ix_poly *p;
        ix_status st;

        a = ix__attr_find(leaf[i]->attrs, name);
        a = a ? a : own;
        if (leaf[i]->type != IX_OBJ_POLY || !a || a->type != IX_ATTR_STRING)
            continue;
        p = ix__poly_dup(c->ctx, leaf[i]->u.poly);
        st = p ? to_vertices(c->ctx, p, name, a->s) : IX_ENOMEM;
        if (st != IX_OK) {
            ix__poly_unref(c->ctx, p);
            return st;
        }
        ix__poly_unref(c->ctx, leaf[i]->u.poly);
        leaf[i]->u.poly = p;
    }
    return IX_OK;
}

const ix_builtin ix__builtins_attr[] = {
    {"ADWIDTH", "x:geom width:num -> nothing",
     "Sets the attribute \"dwidth\": the width of lines on displays, in "
     "pixels.",
     "c = circle(vector(0, 0, 0), 1): adwidth(c, 2);", b_adwidth, 0, 5},
    {"ATTRIB", "x:any name:str value:any -> nothing",
     "Sets an attribute of x in place: a string, an integral number, another "
     "number, or a copy of any object; names ignore case.",
     "p = point(1, 2, 3): attrib(p, \"rgb\", \"255,128,0\");", b_attrib, 0, 5},
    {"ATTRPROP", "x:any name:str value:any -> nothing",
     "Sets an attribute on every object in the list x, at any depth; on x "
     "itself if it is no list.",
     "l = list(point(0, 0, 0), list(point(1, 1, 1))): "
     "attrprop(l, \"rgb\", \"255,0,0\");",
     b_attrprop, 0, 5},
    {"ATTRVPROP", "x:any name:str -> nothing",
     "Gives the vertices of polygons the attribute \"rgb\" of their object.",
     "p = poly(list(point(0, 0, 0), point(1, 0, 0)), true): "
     "attrib(p, \"rgb\", \"255,0,0\"): attrvprop(p, \"rgb\");",
     b_attrvprop, 0, 5},
    {"AWIDTH", "x:geom width:num -> nothing",
     "Sets the attribute \"width\": the width of lines in units of the model.",
     "c = circle(vector(0, 0, 0), 1): awidth(c, 0.02);", b_awidth, 0, 5},
    {"COLOR", "x:geom colour:num -> nothing",
     "Sets the attribute \"color\", one of BLACK, BLUE, GREEN, CYAN, RED, "
     "MAGENTA, YELLOW, WHITE.",
     "c = circle(vector(0, 0, 0), 1): color(c, red);", b_color, 0, 5},
    {"CPATTR", "dest:any src:any -> nothing",
     "Replaces all attributes of dest by those of src.",
     "p = point(0, 0, 0): q = point(1, 0, 0): color(p, red): cpattr(q, p);",
     b_cpattr, 0, 5},
    {"GETATTR", "x:any name:str -> any",
     "The value of an attribute, or an empty list if x does not have it.",
     "p = point(0, 0, 0): color(p, red): getattr(p, \"color\");", b_getattr, 0,
     5},
    {"PATTRIB", "p:poly i:num name:str value:any -> any",
     "Sets an attribute of vertex i (from 0) of the first polygon, or with "
     "nil() only looks; its value, or an empty list.",
     "p = poly(list(point(0, 0, 0), point(1, 0, 0)), true): "
     "a = pattrib(p, 0, \"rgb\", \"255,0,0\");",
     b_pattrib, 0, 5},
    {"PNORMAL", "p:poly i:num normal:any -> vector",
     "The normal of vertex i (from 0) of the first polygon, which then becomes "
     "normal if that is a vector.",
     "p = poly(list(point(0, 0, 0), point(1, 0, 0), point(0, 1, 0)), false): "
     "n = pnormal(p, 0, vector(0, 0, 1));",
     b_pnormal, 0, 5},
    {"RMATTR", "x:any name:str -> nothing",
     "Removes an attribute, if x has it.",
     "p = point(0, 0, 0): color(p, red): rmattr(p, \"color\");", b_rmattr, 0,
     5},
    {NULL, NULL, NULL, NULL, NULL, 0, 0}};
