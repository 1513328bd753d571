/* prim_planes.c - pairs of primitives whose bisector consists of planes: two
 * planes, two lines in one plane, a line and one of its points. */
#include <math.h>

#include "geom/vec3.h"
#include "ops/prim.h"

bool ix__prim_parallel(const double u[3], const double v[3])
{
    double x[3];

    ix__cross3(u, v, x);
    return !(ix__len3(x) > IX__PARALLEL);
}

void ix__prim_offset(const ix_prim *a, const double q[3], double out[3])
{
    double e[3];

    ix__sub3(q, a->pos, e);
    ix__axpy3(e, -ix__dot3(e, a->dir), a->dir, out);
}

bool ix__prim_touch(double gap, const double p[3], const double q[3],
                    double size)
{
    return !(gap > IX__ONE_POINT * (size + ix__len3(p) + ix__len3(q)));
}

ix_status ix__prim_plane(ix_ctx *ctx, const double at[3],
                         const double normal[3], double size, ix__prim_set *s)
{
    ix_prim p = {.kind = IX_PRIM_PLANE,
                 .pos = {at[0], at[1], at[2]},
                 .dir = {normal[0], normal[1], normal[2]}};

    IX_TRY(ix__prim_surface(ctx, &p, size, &s->srf[s->n]));
    s->n++;
    return IX_OK;
}

/* Both planes through at with the normals u - v and u + v. */
static ix_status two_through(ix_ctx *ctx, const double at[3], const double u[3],
                             const double v[3], double size, ix__prim_set *s)
{
    double n[3];

    for (int sign = -1; sign <= 1; sign += 2) {
        ix__axpy3(u, sign, v, n);
        IX_TRY(ix__prim_plane(ctx, at, n, size, s));
    }
    return IX_OK;
}

static void middle_of(const double p[3], const double q[3], double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = 0.5 * (p[k] + q[k]);
}

ix_status ix__prim_two_planes(ix_ctx *ctx, const ix_prim *a, const ix_prim *b,
                              double size, ix__prim_set *s)
{
    double at[3], e[3], line[3], to[3], h;

    middle_of(a->pos, b->pos, at);
    ix__sub3(b->pos, a->pos, e);
    h = ix__dot3(e, a->dir);
    if (ix__prim_parallel(a->dir, b->dir)) {
        if (ix__prim_touch(fabs(h), a->pos, b->pos, size))
            return IX_FAIL(ctx, IX_EDOMAIN, "both are one plane");
        return ix__prim_plane(ctx, at, a->dir, size, s);
    }
    /* the middle, carried into plane a, and in it to the planes' line */
    ix__axpy3(at, -0.5 * h, a->dir, at);
    ix__cross3(a->dir, b->dir, line);
    ix__cross3(line, a->dir, to);
    ix__sub3(b->pos, at, e);
    ix__axpy3(at, ix__dot3(e, b->dir) / ix__dot3(to, b->dir), to, at);
    return two_through(ctx, at, a->dir, b->dir, size, s);
}

/* Where the lines, not parallel, come next to each other, on a; their distance
 * there. */
static double nearest(const ix_prim *a, const ix_prim *b, double at[3])
{
    double e[3], n[3], m[3], len;

    ix__sub3(b->pos, a->pos, e);
    ix__cross3(a->dir, b->dir, n);
    len = ix__unit3(n, n);
    ix__cross3(b->dir, n, m);
    ix__axpy3(a->pos, ix__dot3(e, m) / len, a->dir, at);
    return fabs(ix__dot3(e, n));
}

ix_status ix__prim_flat_lines(ix_ctx *ctx, const ix_prim *a, const ix_prim *b,
                              double size, ix__prim_set *s)
{
    double at[3], e[3];

    if (ix__prim_parallel(a->dir, b->dir)) {
        ix__prim_offset(a, b->pos, e);
        if (ix__prim_touch(ix__len3(e), a->pos, b->pos, size))
            return IX_FAIL(ctx, IX_EDOMAIN, "both are one line");
        middle_of(a->pos, b->pos, at);
        return ix__prim_plane(ctx, at, e, size, s);
    }
    if (!ix__prim_touch(nearest(a, b, at), a->pos, b->pos, size))
        return IX_OK;
    return two_through(ctx, at, a->dir, b->dir, size, s);
}

ix_status ix__prim_line_point(ix_ctx *ctx, const ix_prim *line,
                              const double q[3], double size, ix__prim_set *s)
{
    double e[3];

    ix__prim_offset(line, q, e);
    if (!ix__prim_touch(ix__len3(e), line->pos, q, size))
        return IX_OK;
    return ix__prim_plane(ctx, q, line->dir, size, s);
}
