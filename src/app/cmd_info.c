/* cmd_info.c - iritx info FILE...: the objects of files as a tree, a line
 * each. Readers bound the depth of what they make, so that the recursion over
 * lists is bounded, too. */
#include "app/cmd.h"

#include <string.h>

static void put_numbers(int n, const double *v)
{
    for (int i = 0; i < n; i++)
        (void)printf(i ? " %.6g" : "%.6g", v[i]);
}

static void put_point_type(int ncoords, bool rational)
{
    (void)printf("%c%d", rational ? 'P' : 'E', ncoords);
}

/* --- freeforms -------------------------------------------------------- */

static const char *basis_name(ix_dir dir)
{
    return dir.basis == IX_BEZIER  ? "Bezier"
           : dir.basis == IX_POWER ? "power basis"
           : dir.periodic          ? "periodic B-spline"
                                   : "B-spline";
}

/* "order 3, 9 points, 0 .. 4". */
static void put_direction(const ix_mv *m, int d)
{
    double dom[2];

    ix_mv_domain(m, d, dom);
    (void)printf(", %s of order %d, %d point%s, on [",
                 basis_name(ix_mv_dir(m, d)), ix_mv_order(m, d),
                 ix_mv_length(m, d), ix_mv_length(m, d) == 1 ? "" : "s");
    (void)printf("%.6g, %.6g]", dom[0], dom[1]);
}

static void put_mv(const ix_mv *m)
{
    put_point_type(ix_mv_ncoords(m), ix_mv_rational(m));
    for (int d = 0; d < ix_mv_ndirs(m); d++)
        put_direction(m, d);
    if (ix_mv_has_poles(m))
        (void)printf(", has poles");
}

/* --- other geometry --------------------------------------------------- */

static void put_trimsrf(const ix_trimsrf *t)
{
    int n = 0;

    for (int i = 0; i < t->nloops; i++)
        n += t->loop[i].n;
    put_mv(t->srf);
    (void)printf(", %d trimming loop%s of %d curve%s", t->nloops,
                 t->nloops == 1 ? "" : "s", n, n == 1 ? "" : "s");
}

static void put_trisrf(const ix_trisrf *t)
{
    static const char *const kinds[] = {"Bezier", "B-spline", "Gregory"};

    put_point_type(t->ncoords, t->rational);
    (void)printf(", %s of order %d, %d points", kinds[t->kind], t->order,
                 t->npts);
}

static void put_model(const ix_model *m)
{
    (void)printf("%d faces, %d edges", m->nsrf, m->nseg);
}

static void put_polys(const ix_poly *p)
{
    static const char *const kinds[] = {"polygon", "polyline", "point list",
                                        "strip"};
    long count[4] = {0}, vertices = 0;
    const char *gap = "";

    for (int i = 0; i < p->n; i++) {
        count[p->poly[i].kind]++;
        vertices += p->poly[i].n;
    }
    for (int k = 0; k < 4; k++) {
        if (count[k] == 0)
            continue;
        (void)printf("%s%ld %s%s", gap, count[k], kinds[k],
                     count[k] == 1 ? "" : "s");
        gap = ", ";
    }
    (void)printf("%s%ld vertices", gap, vertices);
}

/* --- simple values ---------------------------------------------------- */

enum { LONGEST = 60 }; /* of a string's text that is shown */

static void put_string(const char *s, size_t n)
{
    size_t shown = n < LONGEST ? n : LONGEST;

    while (shown > 0 && shown < n && ((unsigned char)s[shown] & 0xc0) == 0x80)
        shown--; /* not within a character */
    (void)putchar('"');
    for (size_t i = 0; i < shown; i++) {
        unsigned char c = (unsigned char)s[i];

        (void)putchar(c < ' ' || c == 0x7f ? '?' : c);
    }
    (void)printf(shown < n ? "\"... (%zu bytes)" : "\"", n);
}

static void put_simple(const ix_obj *o)
{
    switch (o->type) {
    case IX_OBJ_NUMBER:
        put_numbers(1, &o->u.num);
        break;
    case IX_OBJ_POINT:
    case IX_OBJ_VECTOR:
        put_numbers(3, o->u.pt);
        break;
    case IX_OBJ_PLANE:
        put_numbers(4, o->u.plane);
        break;
    case IX_OBJ_MATRIX:
        put_numbers(16, o->u.mat);
        break;
    case IX_OBJ_STRING:
        put_string(o->u.str.s, o->u.str.len);
        break;
    case IX_OBJ_CTLPT:
        put_point_type(o->u.ctlpt->ncoords, o->u.ctlpt->rational);
        (void)printf(" ");
        put_numbers(o->u.ctlpt->ncoords + (o->u.ctlpt->rational ? 1 : 0),
                    o->u.ctlpt->v);
        break;
    case IX_OBJ_INSTANCE:
        (void)printf("of %s", o->u.inst->target);
        break;
    default:
        break;
    }
}

/* --- objects ---------------------------------------------------------- */

static void put_attrs(const ix_attr *attrs)
{
    const char *gap = "  [";

    for (const ix_attr *a = attrs; a; a = a->next, gap = "; ") {
        (void)printf("%s%s", gap, a->name);
        if (a->type == IX_ATTR_INT)
            (void)printf(" %lld", a->i);
        else if (a->type == IX_ATTR_REAL)
            (void)printf(" %.6g", a->r);
        else if (a->type == IX_ATTR_OBJ)
            (void)printf(" (%s)", ix__obj_type_name(a->obj->type));
        else if (a->s[0]) {
            (void)printf(" ");
            put_string(a->s, strlen(a->s));
        }
    }
    if (attrs)
        (void)printf("]");
}

static void put_item(const ix_obj *o, int i)
{
    const void *item = ix__seq_item(o, i);

    if (o->type == IX_OBJ_TRIMSRF)
        put_trimsrf(item);
    else if (o->type == IX_OBJ_TRISRF)
        put_trisrf(item);
    else if (o->type == IX_OBJ_MODEL)
        put_model(item);
    else
        put_mv(item);
}

static void put_value(const ix_obj *o, int depth)
{
    int n = ix__seq_count(o);

    if (o->type == IX_OBJ_LIST)
        (void)printf("%d element%s", o->u.list.n, o->u.list.n == 1 ? "" : "s");
    else if (o->type == IX_OBJ_POLY)
        put_polys(o->u.poly);
    else if (n == 1)
        put_item(o, 0);
    else if (n > 1)
        (void)printf("%d in sequence", n);
    else
        put_simple(o);
    put_attrs(o->attrs);
    (void)printf("\n");
    for (int i = 0; n > 1 && i < n; i++) {
        (void)printf("%*s%d: ", 2 * depth + 2, "", i + 1);
        put_item(o, i);
        (void)printf("\n");
    }
}

/* Geometry only: other objects, and those with poles, have no box. */
static void put_box(ix_ctx *ctx, const ix_obj *o, int depth)
{
    double b[6];

    if (o->type == IX_OBJ_LIST || ix__obj_bbox(ctx, o, b) != IX_OK)
        return;
    if (ix__seq_count(o) == 0 && o->type != IX_OBJ_POLY)
        return;
    (void)printf("%*sbox [%.6g, %.6g] x [%.6g, %.6g] x [%.6g, %.6g]\n",
                 2 * depth + 2, "", b[0], b[1], b[2], b[3], b[4], b[5]);
}

static ix_status put_object(ix_ctx *ctx, const ix_obj *o, int depth)
{
    IX_TRY(ix__poll(ctx));
    (void)printf("%*s%s %s: ", 2 * depth, "", ix__obj_type_name(o->type),
                 o->name ? o->name : "-");
    put_value(o, depth);
    put_box(ctx, o, depth);
    for (int i = 0; o->type == IX_OBJ_LIST && i < o->u.list.n; i++)
        IX_TRY(put_object(ctx, o->u.list.item[i], depth + 1));
    return IX_OK;
}

static ix_status put_file(ix_ctx *ctx, const char *name)
{
    ix_buf resolved;
    ix_obj *o;
    ix_status st;

    ix__buf_init(&resolved, ctx);
    st = ix__load(ctx, name, &resolved, &o);
    if (st == IX_OK) {
        (void)printf("%s\n", resolved.data);
        st = put_object(ctx, o, 1);
    }
    ix__obj_unref(ctx, o);
    ix__buf_free(&resolved);
    return st;
}

int cmd_info(ix_ctx *ctx, int argc, char **argv)
{
    int rc = 0;

    if (argc == 0)
        return cmd_wrong_usage("info");
    for (int i = 0; i < argc; i++)
        if (put_file(ctx, argv[i]) != IX_OK)
            rc = cmd_complain(ctx);
    return rc;
}
