/* summary.c - objects as a tree, a line each. Readers and scripts bound the
 * depth of what they make, so that the recursion over lists is bounded, too. */
#include "app/summary.h"

#include <string.h>

#include "object/object.h"

/* Digits of a number: where sizes are looked at, and where values are. */
enum { BRIEF = 6, PRECISE = 14 };

static void put_numbers(ix_buf *b, int digits, int n, const double *v)
{
    for (int i = 0; i < n; i++)
        ix__buf_printf(b, i ? " %.*g" : "%.*g", digits, v[i]);
}

static void put_point_type(ix_buf *b, int ncoords, bool rational)
{
    ix__buf_printf(b, "%c%d", rational ? 'P' : 'E', ncoords);
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
static void put_direction(ix_buf *b, const ix_mv *m, int d)
{
    double dom[2];

    ix_mv_domain(m, d, dom);
    ix__buf_printf(b, ", %s of order %d, %d point%s, on [",
                   basis_name(ix_mv_dir(m, d)), ix_mv_order(m, d),
                   ix_mv_length(m, d), ix_mv_length(m, d) == 1 ? "" : "s");
    ix__buf_printf(b, "%.6g, %.6g]", dom[0], dom[1]);
}

static void put_mv(ix_buf *b, const ix_mv *m)
{
    put_point_type(b, ix_mv_ncoords(m), ix_mv_rational(m));
    for (int d = 0; d < ix_mv_ndirs(m); d++)
        put_direction(b, m, d);
    if (ix_mv_has_poles(m))
        ix__buf_printf(b, ", has poles");
}

/* --- other geometry --------------------------------------------------- */

static void put_trimsrf(ix_buf *b, const ix_trimsrf *t)
{
    int n = 0;

    for (int i = 0; i < t->nloops; i++)
        n += t->loop[i].n;
    put_mv(b, t->srf);
    ix__buf_printf(b, ", %d trimming loop%s of %d curve%s", t->nloops,
                   t->nloops == 1 ? "" : "s", n, n == 1 ? "" : "s");
}

static void put_trisrf(ix_buf *b, const ix_trisrf *t)
{
    static const char *const kinds[] = {"Bezier", "B-spline", "Gregory"};

    put_point_type(b, t->ncoords, t->rational);
    ix__buf_printf(b, ", %s of order %d, %d points", kinds[t->kind], t->order,
                   t->npts);
}

static void put_model(ix_buf *b, const ix_model *m)
{
    ix__buf_printf(b, "%d faces, %d edges", m->nsrf, m->nseg);
}

static void put_polys(ix_buf *b, const ix_poly *p)
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
        ix__buf_printf(b, "%s%ld %s%s", gap, count[k], kinds[k],
                       count[k] == 1 ? "" : "s");
        gap = ", ";
    }
    ix__buf_printf(b, "%s%ld vertices", gap, vertices);
}

/* --- simple values ---------------------------------------------------- */

enum { LONGEST = 60 }; /* of a string's text that is shown */

static void put_string(ix_buf *b, const char *s, size_t n)
{
    size_t shown = n < LONGEST ? n : LONGEST;

    while (shown > 0 && shown < n && ((unsigned char)s[shown] & 0xc0) == 0x80)
        shown--; /* not within a character */
    ix__buf_putc(b, '"');
    for (size_t i = 0; i < shown; i++) {
        unsigned char c = (unsigned char)s[i];

        ix__buf_putc(b, c < ' ' || c == 0x7f ? '?' : (char)c);
    }
    ix__buf_printf(b, shown < n ? "\"... (%zu bytes)" : "\"", n);
}

static void put_simple(ix_buf *b, int digits, const ix_obj *o)
{
    switch (o->type) {
    case IX_OBJ_NUMBER:
        put_numbers(b, digits, 1, &o->u.num);
        break;
    case IX_OBJ_POINT:
    case IX_OBJ_VECTOR:
        put_numbers(b, digits, 3, o->u.pt);
        break;
    case IX_OBJ_PLANE:
        put_numbers(b, digits, 4, o->u.plane);
        break;
    case IX_OBJ_MATRIX:
        put_numbers(b, digits, 16, o->u.mat);
        break;
    case IX_OBJ_STRING:
        put_string(b, o->u.str.s, o->u.str.len);
        break;
    case IX_OBJ_CTLPT:
        put_point_type(b, o->u.ctlpt->ncoords, o->u.ctlpt->rational);
        ix__buf_printf(b, " ");
        put_numbers(b, digits,
                    o->u.ctlpt->ncoords + (o->u.ctlpt->rational ? 1 : 0),
                    o->u.ctlpt->v);
        break;
    case IX_OBJ_INSTANCE:
        ix__buf_printf(b, "of %s", o->u.inst->target);
        break;
    default:
        break;
    }
}

/* --- objects ---------------------------------------------------------- */

static void put_attrs(ix_buf *b, const ix_attr *attrs)
{
    const char *gap = "  [";

    for (const ix_attr *a = attrs; a; a = a->next, gap = "; ") {
        ix__buf_printf(b, "%s%s", gap, a->name);
        if (a->type == IX_ATTR_INT)
            ix__buf_printf(b, " %lld", a->i);
        else if (a->type == IX_ATTR_REAL)
            ix__buf_printf(b, " %.6g", a->r);
        else if (a->type == IX_ATTR_OBJ)
            ix__buf_printf(b, " (%s)", ix__obj_type_name(a->obj->type));
        else if (a->s[0]) {
            ix__buf_printf(b, " ");
            put_string(b, a->s, strlen(a->s));
        }
    }
    if (attrs)
        ix__buf_printf(b, "]");
}

static void put_item(ix_buf *b, const ix_obj *o, int i)
{
    const void *item = ix__seq_item(o, i);

    if (o->type == IX_OBJ_TRIMSRF)
        put_trimsrf(b, item);
    else if (o->type == IX_OBJ_TRISRF)
        put_trisrf(b, item);
    else if (o->type == IX_OBJ_MODEL)
        put_model(b, item);
    else
        put_mv(b, item);
}

static void put_value(ix_buf *b, int digits, const ix_obj *o, int depth)
{
    int n = ix__seq_count(o);

    if (o->type == IX_OBJ_LIST)
        ix__buf_printf(b, "%d element%s", o->u.list.n,
                       o->u.list.n == 1 ? "" : "s");
    else if (o->type == IX_OBJ_POLY)
        put_polys(b, o->u.poly);
    else if (n == 1)
        put_item(b, o, 0);
    else if (n > 1)
        ix__buf_printf(b, "%d in sequence", n);
    else
        put_simple(b, digits, o);
    put_attrs(b, o->attrs);
    ix__buf_printf(b, "\n");
    for (int i = 0; n > 1 && i < n; i++) {
        ix__buf_printf(b, "%*s%d: ", 2 * depth + 2, "", i + 1);
        put_item(b, o, i);
        ix__buf_printf(b, "\n");
    }
}

/* Geometry only: other objects, and those with poles, have no box. */
static void put_box(ix_buf *b, const ix_obj *o, int depth)
{
    double box[6];

    if (o->type == IX_OBJ_LIST || ix__obj_bbox(b->ctx, o, box) != IX_OK)
        return;
    if (ix__seq_count(o) == 0 && o->type != IX_OBJ_POLY)
        return;
    ix__buf_printf(b, "%*sbox [%.6g, %.6g] x [%.6g, %.6g] x [%.6g, %.6g]\n",
                   2 * depth + 2, "", box[0], box[1], box[2], box[3], box[4],
                   box[5]);
}

ix_status summary_add(ix_buf *b, const ix_obj *o, int depth)
{
    IX_TRY(ix__poll(b->ctx));
    ix__buf_printf(b, "%*s%s %s: ", 2 * depth, "", ix__obj_type_name(o->type),
                   o->name ? o->name : "-");
    put_value(b, BRIEF, o, depth);
    put_box(b, o, depth);
    for (int i = 0; o->type == IX_OBJ_LIST && i < o->u.list.n; i++)
        IX_TRY(summary_add(b, o->u.list.item[i], depth + 1));
    return IX_OK;
}

/* --- for a person -------------------------------------------------------- */

enum {
    SHOWN = 20,      /* elements of a list */
    FEW_POINTS = 12, /* of a freeform or polygon that is shown in full */
};

bool summary_is_large(const ix_obj *o)
{
    size_t n = 0;

    if (o->type == IX_OBJ_LIST)
        return true;
    if (o->type == IX_OBJ_POLY) {
        for (int i = 0; i < o->u.poly->n && n <= FEW_POINTS; i++)
            n += (size_t)o->u.poly->poly[i].n;
        return n > FEW_POINTS;
    }
    if (ix__seq_count(o) == 0)
        return false;
    return ix__seq_count(o) > 1 || o->type == IX_OBJ_TRIMSRF ||
           o->type == IX_OBJ_TRISRF || o->type == IX_OBJ_MODEL ||
           ix_mv_npts(ix__seq_item(o, 0)) > FEW_POINTS;
}

static void put_matrix(ix_buf *b, const ix_obj *o)
{
    for (int i = 0; i < 16; i += 4) {
        put_numbers(b, PRECISE, 4, o->u.mat + i);
        ix__buf_putc(b, '\n');
    }
}

static void put_short_elements(ix_buf *b, const ix_obj *o)
{
    int n = o->u.list.n;

    for (int i = 0; i < n && i < SHOWN; i++) {
        const ix_obj *e = o->u.list.item[i];

        ix__buf_printf(b, "  %d: %s ", i + 1, ix__obj_type_name(e->type));
        if (e->name)
            ix__buf_printf(b, "%s: ", e->name);
        put_value(b, PRECISE, e, 1);
    }
    if (n > SHOWN)
        ix__buf_printf(b, "  ... and %d more\n", n - SHOWN);
}

ix_status summary_add_short(ix_buf *b, const ix_obj *o)
{
    bool geometry = ix__seq_count(o) > 0 || o->type == IX_OBJ_POLY;

    if (o->type == IX_OBJ_MATRIX && !o->attrs) {
        put_matrix(b, o);
        return ix__buf_check(b);
    }
    if (geometry || o->type == IX_OBJ_LIST)
        ix__buf_printf(b, "%s %s: ", ix__obj_type_name(o->type),
                       o->name ? o->name : "-");
    put_value(b, PRECISE, o, 0);
    if (geometry)
        put_box(b, o, 0);
    if (o->type == IX_OBJ_LIST)
        put_short_elements(b, o);
    return ix__buf_check(b);
}
