/* xml_read_poly.c - polygons, polylines, point lists and strips from XML:
 * plain vertices as rows of numbers, others as elements. */
#include <limits.h>
#include <string.h>

#include "io/read_rules.h"
#include "io/xml_read_impl.h"

/* Vertices gathered so far; their attributes are owned. */
typedef struct {
    ix_vertex *v;
    int n;
    size_t cap;
} vertices;

static void drop(ix_ctx *ctx, vertices *a)
{
    for (int i = 0; i < a->n; i++)
        ix__attr_free_all(ctx, &a->v[i].attrs);
    ix__free(ctx, a->v, a->cap * sizeof *a->v);
}

static ix_status add(ix__xmlr *r, vertices *a, const ix_vertex *v)
{
    size_t cap = a->cap ? 2 * a->cap : 16;
    ix_vertex *fresh;

    if ((size_t)a->n == a->cap) {
        if (a->n > INT_MAX / 4)
            return IX_FAIL(r->ctx, IX_EUNABLE, "more than %d vertices", a->n);
        fresh = ix__realloc(r->ctx, a->v, a->cap * sizeof *a->v,
                            cap * sizeof *a->v);
        if (!fresh)
            return IX_ENOMEM;
        a->v = fresh;
        a->cap = cap;
    }
    a->v[a->n++] = *v;
    return IX_OK;
}

static ix_status read_rows(ix__xmlr *r, vertices *a)
{
    IX_TRY(ix__xmlr_allow(r, ""));
    IX_TRY(ix__xmlr_text(r));
    while (!ix__xmlr_at_end(r)) {
        ix_vertex v = {0};

        for (int k = 0; k < 3; k++)
            IX_TRY(ix__xmlr_num(r, &v.p[k]));
        IX_TRY(add(r, a, &v));
    }
    return ix__poll(r->ctx);
}

static ix_status read_vertex(ix__xmlr *r, vertices *a)
{
    size_t at = r->e.at;
    ix_vertex v = {0};
    bool given, more;
    int count = 0;

    IX_TRY(ix__xmlr_allow(r, " position normal internal "));
    IX_TRY(ix__xmlr_attr_nums(r, "position", 3, v.p, &given));
    if (!given)
        return ix__xml_fail(r->x, at, "vertex without a position");
    IX_TRY(ix__xmlr_attr_nums(r, "normal", 3, v.normal, &given));
    v.has_normal = given && ix__poly_unit(v.normal, 3); /* zero is none */
    IX_TRY(ix__xmlr_bool(r, "internal", &v.internal));
    IX_TRY(add(r, a, &v));
    for (;;) {
        IX_TRY(ix__xmlr_child(r, &more));
        if (!more)
            return IX_OK;
        if (!ix__xmlr_is(r, "attribute"))
            return ix__xmlr_unexpected(r, "attribute");
        IX_TRY(ix__xmlr_attribute(r, &a->v[a->n - 1].attrs, &count));
    }
}

static ix_status read_children(ix__xmlr *r, ix_polygon *pg, vertices *a)
{
    bool more;
    int count = 0;

    for (;;) {
        IX_TRY(ix__xmlr_child(r, &more));
        if (!more)
            return IX_OK;
        if (ix__xmlr_is(r, "points"))
            IX_TRY(read_rows(r, a));
        else if (ix__xmlr_is(r, "vertex"))
            IX_TRY(read_vertex(r, a));
        else if (ix__xmlr_is(r, "attribute") && a->n == 0)
            IX_TRY(ix__xmlr_attribute(r, &pg->attrs, &count));
        else
            return ix__xmlr_unexpected(r, "points or vertex");
    }
}

static ix_status read_polygon(ix__xmlr *r, ix_polygon *pg, vertices *a)
{
    size_t at = r->e.at;

    IX_TRY(ix__xmlr_allow(r, " plane "));
    IX_TRY(ix__xmlr_attr_nums(r, "plane", 4, pg->plane, &pg->has_plane));
    if (pg->has_plane && !ix__poly_unit(pg->plane, 4))
        return ix__xml_fail(r->x, at, "degenerate normal: plane %g %g %g",
                            pg->plane[0], pg->plane[1], pg->plane[2]);
    IX_TRY(read_children(r, pg, a));
    if (a->n == 0)
        return ix__xml_fail(r->x, at, "no vertices");
    IX_TRY(ix__poly_vertices(r->ctx, pg, a->n));
    memcpy(pg->v, a->v, (size_t)a->n * sizeof *a->v);
    a->n = 0; /* attributes have moved */
    ix__poly_complete(pg);
    return IX_OK;
}

ix_status ix__xmlr_poly(ix__xmlr *r, ix_poly_kind kind, const void **out)
{
    ix_mark mk = ix__scratch_mark(r->ctx);
    ix_poly *p = ix__poly_new(r->ctx, 1);
    vertices a = {0};
    ix_status st = IX_ENOMEM;

    *out = NULL;
    if (p) {
        p->poly[0].kind = kind;
        st = read_polygon(r, &p->poly[0], &a);
    }
    drop(r->ctx, &a);
    ix__scratch_release(r->ctx, mk);
    if (st == IX_OK)
        *out = p;
    else
        ix__poly_unref(r->ctx, p);
    return st;
}
