/* itd_read_poly.c - polygons, polylines, point lists and strips from text
 * (spec/itd-format 5). Planes and normals are made unit vectors, unless they
 * are so within rounding already. */
#include "io/itd_read_impl.h"
#include "io/read_rules.h"

static ix_status polygon_attr(ix__lex *l, const ix__token *name, void *arg,
                              bool *taken)
{
    ix_polygon *pg = arg;

    if (!ix__token_is(name, "PLANE"))
        return IX_OK;
    *taken = true;
    IX_TRY(ix__lex_nums(l, "number of the PLANE", 4, pg->plane));
    IX_TRY(ix__lex_close(l, "] of the PLANE"));
    if (!ix__poly_unit(pg->plane, 4))
        return ix__lex_fail(l, name->at, "degenerate normal: PLANE %g %g %g",
                            pg->plane[0], pg->plane[1], pg->plane[2]);
    pg->has_plane = true;
    return IX_OK;
}

static ix_status vertex_attr(ix__lex *l, const ix__token *name, void *arg,
                             bool *taken)
{
    ix_vertex *v = arg;

    if (ix__token_is(name, "INTERNAL")) {
        *taken = v->internal = true;
        return ix__lex_close(l, "] of INTERNAL");
    }
    if (!ix__token_is(name, "NORMAL"))
        return IX_OK;
    *taken = true;
    IX_TRY(ix__lex_nums(l, "number of the NORMAL", 3, v->normal));
    v->has_normal = ix__poly_unit(v->normal, 3); /* a zero normal is none */
    return ix__lex_close(l, "] of the NORMAL");
}

static ix_status read_vertex(ix__lex *l, ix_vertex *v, int i, int n)
{
    ix__token t;

    IX_TRY(ix__lex_next(l, &t));
    if (t.kind == IX_T_CLOSE)
        return ix__lex_fail(l, t.at, "%d vertices expected, %d found", n, i);
    if (t.kind != IX_T_OPEN)
        return ix__lex_unexpected(l, &t, "[ of a vertex");
    IX_TRY(ix__itdr_attrs(l, &v->attrs, vertex_attr, v));
    IX_TRY(ix__lex_nums(l, "coordinate", 3, v->p));
    return ix__lex_close(l, "] of a vertex");
}

static ix_status read_polygon(ix__lex *l, ix_polygon *pg)
{
    ix__token t;
    int n;

    IX_TRY(ix__itdr_attrs(l, &pg->attrs, polygon_attr, pg));
    IX_TRY(ix__lex_peek(l, &t));
    IX_TRY(ix__lex_int(l, "the number of vertices", 1, INT32_MAX, &n));
    IX_TRY(ix__lex_room(l, t.at, n, 7, "vertices")); /* "[0 0 0]" */
    IX_TRY(ix__poly_vertices(l->ctx, pg, n));
    for (int i = 0; i < n; i++) {
        if (i % 4096 == 0)
            IX_TRY(ix__poll(l->ctx));
        IX_TRY(read_vertex(l, &pg->v[i], i, n));
    }
    ix__poly_complete(pg);
    return ix__lex_close(l, "] behind the last vertex");
}

ix_status ix__itdr_poly(ix__lex *l, ix_poly_kind kind, const void **out)
{
    ix_mark mk = ix__scratch_mark(l->ctx);
    ix_poly *p = ix__poly_new(l->ctx, 1);
    ix_status st = IX_ENOMEM;

    *out = NULL;
    if (p) {
        p->poly[0].kind = kind;
        st = read_polygon(l, &p->poly[0]);
    }
    ix__scratch_release(l->ctx, mk);
    if (st == IX_OK)
        *out = p;
    else
        ix__poly_unref(l->ctx, p);
    return st;
}
