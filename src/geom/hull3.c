/* hull3.c - quickhull in integers: a point is outside of a face or not, without
 * a tolerance, so that the faces always are a closed convex surface. */
#include "geom/hull3.h"

#include <math.h>
#include <string.h>

#include "geom/vec3.h"

/* Coordinates below 2^38, their differences 2^39: determinants 2^120. */
__extension__ typedef __int128 wide;
#define GRID 0x1p38

typedef struct {
    int v[3];    /* counter-clockwise */
    int nb[3];   /* the face across the edge v[i], v[i + 1] */
    int outside; /* first of the points outside that it has to deal with, -1 */
    int mark;    /* the point that sees it */
    bool dead;
    wide n[3]; /* normal */
} face;

typedef struct {
    int a, b, out; /* directed as in the faces that go; the face that stays */
} edge;

/* A hull has 2 n - 4 faces at most, a horizon n edges. */
typedef struct {
    ix_ctx *ctx;
    int n;
    int64_t (*x)[3];
    int *next;  /* [n]: the points outside a face, as lists */
    int *start; /* [n]: the new face whose edge on the horizon begins there */
    face *f;    /* [3 n] */
    int nf;     /* used so far, dead ones included */
    int *idle;  /* [3 n]: dead faces, to be used again */
    int nidle;
    int *seen; /* [2 n]: faces that the point in hand sees */
    int nseen;
    edge *horizon; /* [n] */
    int *fresh;    /* [n]: the new faces */
    int nh;        /* of both */
} hull;

/* --- predicates
 * ------------------------------------------------------------------ */

static void normal(const int64_t *a, const int64_t *b, const int64_t *c,
                   wide *n)
{
    wide u[3], v[3];

    for (int k = 0; k < 3; k++) {
        u[k] = b[k] - a[k];
        v[k] = c[k] - a[k];
    }
    n[0] = u[1] * v[2] - u[2] * v[1];
    n[1] = u[2] * v[0] - u[0] * v[2];
    n[2] = u[0] * v[1] - u[1] * v[0];
}

/* Six times the volume of the tetrahedron of face and point. */
static wide above(const hull *h, const face *f, int p)
{
    const int64_t *a = h->x[f->v[0]], *q = h->x[p];

    return f->n[0] * (q[0] - a[0]) + f->n[1] * (q[1] - a[1]) +
           f->n[2] * (q[2] - a[2]);
}

static bool sees(const hull *h, const face *f, int p)
{
    return above(h, f, p) > 0;
}

/* --- faces
 * ----------------------------------------------------------------------- */

static int add_face(hull *h, int a, int b, int c)
{
    int i = h->nidle > 0 ? h->idle[--h->nidle] : h->nf++;
    face *f = &h->f[i];

    *f = (face){.v = {a, b, c}, .outside = -1, .mark = -1};
    normal(h->x[a], h->x[b], h->x[c], f->n);
    return i;
}

/* Gives point p to the first of n faces that it is outside of. */
static void assign(hull *h, int n, const int *list, int p)
{
    for (int i = 0; i < n; i++) {
        face *f = &h->f[list[i]];

        if (sees(h, f, p)) {
            h->next[p] = f->outside;
            f->outside = p;
            return;
        }
    }
}

static int farthest(const hull *h, const face *f)
{
    int best = f->outside;
    wide most = above(h, f, best);

    for (int p = h->next[best]; p >= 0; p = h->next[p]) {
        wide v = above(h, f, p);

        if (v > most) {
            most = v;
            best = p;
        }
    }
    return best;
}

/* --- one point
 * --------------------------------------------------------------------- */

/* The faces that p sees, f being one, and their boundary. */
static void look(hull *h, int f, int p)
{
    h->nh = 0;
    h->nseen = 0;
    h->seen[h->nseen++] = f;
    h->f[f].mark = p;
    for (int i = 0; i < h->nseen; i++) {
        const face *g = &h->f[h->seen[i]];

        for (int k = 0; k < 3; k++) {
            int o = g->nb[k];

            if (h->f[o].mark == p)
                continue;
            if (sees(h, &h->f[o], p)) {
                h->f[o].mark = p;
                h->seen[h->nseen++] = o;
            } else {
                h->horizon[h->nh++] = (edge){g->v[k], g->v[(k + 1) % 3], o};
            }
        }
    }
}

/* The edge of face o that begins at v. */
static int edge_from(const face *o, int v)
{
    return o->v[0] == v ? 0 : o->v[1] == v ? 1 : 2;
}

/* Faces from every edge of the horizon to p, joined with each other. */
static void close_over(hull *h, int p)
{
    for (int i = 0; i < h->nh; i++) {
        edge e = h->horizon[i];
        int f = add_face(h, e.a, e.b, p);

        h->f[f].nb[0] = e.out;
        h->f[e.out].nb[edge_from(&h->f[e.out], e.b)] = f;
        h->start[e.a] = f;
        h->fresh[i] = f;
    }
    for (int i = 0; i < h->nh; i++) {
        int f = h->fresh[i], after = h->start[h->f[f].v[1]];

        h->f[f].nb[1] = after; /* across v[1], p */
        h->f[after].nb[2] = f;
    }
}

static void add_point(hull *h, int f)
{
    int p = farthest(h, &h->f[f]);

    look(h, f, p);
    close_over(h, p);
    for (int i = 0; i < h->nseen; i++) {
        face *gone = &h->f[h->seen[i]];

        for (int q = gone->outside, after; q >= 0; q = after) {
            after = h->next[q];
            if (q != p)
                assign(h, h->nh, h->fresh, q);
        }
        gone->outside = -1;
        gone->dead = true;
        h->idle[h->nidle++] = h->seen[i];
    }
}

/* --- the start
 * --------------------------------------------------------------------- */

static wide absolute(wide v)
{
    return v < 0 ? -v : v;
}

/* The point that makes the largest |f|, f 0: the distance from a, 1: from the
 * line a b, 2: from the plane of face; -1 if all are 0. */
static int extreme(const hull *h, int what, int a, int b, const face *plane)
{
    wide most = 0;
    int best = -1;

    for (int i = 0; i < h->n; i++) {
        wide v = 0;

        if (what == 0)
            for (int k = 0; k < 3; k++)
                v += absolute(h->x[i][k] - h->x[a][k]);
        if (what == 1) {
            wide n[3];

            normal(h->x[a], h->x[b], h->x[i], n);
            v = absolute(n[0]) + absolute(n[1]) + absolute(n[2]);
        }
        if (what == 2)
            v = absolute(above(h, plane, i));
        if (v > most) {
            most = v;
            best = i;
        }
    }
    return best;
}

/* The four faces of the tetrahedron a b c d, d below a b c. */
static void tetrahedron(hull *h, int a, int b, int c, int d)
{
    const int v[4][3] = {{a, b, c}, {b, a, d}, {c, b, d}, {a, c, d}};
    const int nb[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    const int list[4] = {0, 1, 2, 3};

    for (int i = 0; i < 4; i++)
        (void)add_face(h, v[i][0], v[i][1], v[i][2]);
    for (int i = 0; i < 4; i++)
        memcpy(h->f[i].nb, nb[i], sizeof nb[i]);
    for (int p = 0; p < h->n; p++)
        assign(h, 4, list, p);
}

/* False if all points lie in one plane: *flat is a face in it. */
static ix_status start(hull *h, face *flat, bool *solid)
{
    int a = 0, b = extreme(h, 0, a, 0, NULL), c, d;

    c = b < 0 ? -1 : extreme(h, 1, a, b, NULL);
    if (c < 0)
        return IX_FAIL(h->ctx, IX_EDOMAIN,
                       "all points lie on one line: they have no hull");
    *flat = (face){.v = {a, b, c}};
    normal(h->x[a], h->x[b], h->x[c], flat->n);
    d = extreme(h, 2, 0, 0, flat);
    /* the points were moved by half a step of the grid; the triangle is about
       as large as they reach */
    *solid = d >= 0 && absolute(above(h, flat, d)) >
                           8 * (absolute(flat->n[0]) + absolute(flat->n[1]) +
                                absolute(flat->n[2]));
    if (!*solid)
        return IX_OK;
    if (above(h, flat, d) > 0)
        tetrahedron(h, b, a, c, d);
    else
        tetrahedron(h, a, b, c, d);
    return IX_OK;
}

/* --- the call
 * ---------------------------------------------------------------------- */

/* Onto the grid. */
static ix_status snap(hull *h, const double (*p)[3])
{
    double lo[3], size = 0;

    memcpy(lo, p[0], sizeof lo);
    for (int i = 0; i < h->n; i++)
        for (int k = 0; k < 3; k++)
            lo[k] = fmin(lo[k], p[i][k]);
    for (int i = 0; i < h->n; i++)
        for (int k = 0; k < 3; k++) {
            if (!isfinite(p[i][k]))
                return IX_FAIL(h->ctx, IX_EDOMAIN, "point %d is not finite",
                               i + 1);
            size = fmax(size, p[i][k] - lo[k]);
        }
    for (int i = 0; i < h->n; i++)
        for (int k = 0; k < 3; k++)
            h->x[i][k] = size > 0 ? llrint((p[i][k] - lo[k]) / size * GRID) : 0;
    return IX_OK;
}

static ix_status make(ix_ctx *ctx, int n, hull *h)
{
    *h = (hull){.ctx = ctx, .n = n};
    IX_SCRATCH(ctx, h->x, n);
    IX_SCRATCH(ctx, h->next, n);
    IX_SCRATCH(ctx, h->start, n);
    IX_SCRATCH(ctx, h->f, 3 * (size_t)n + 4);
    IX_SCRATCH(ctx, h->idle, 3 * (size_t)n + 4);
    IX_SCRATCH(ctx, h->seen, 2 * (size_t)n + 4);
    IX_SCRATCH(ctx, h->horizon, (size_t)n + 4);
    IX_SCRATCH(ctx, h->fresh, (size_t)n + 4);
    return IX_OK;
}

ix_status ix__hull3(ix_ctx *ctx, int n, const double (*p)[3], int *nfaces,
                    int (**out)[3], double flat[3])
{
    bool solid, again;
    face plane;
    hull h;

    *nfaces = 0;
    if (n < 1)
        return IX_FAIL(ctx, IX_EDOMAIN, "no points have no hull");
    IX_TRY(make(ctx, n, &h));
    IX_TRY(snap(&h, p));
    IX_TRY(start(&h, &plane, &solid));
    for (int k = 0; k < 3; k++)
        flat[k] = (double)plane.n[k];
    (void)ix__unit3(flat, flat);
    if (!solid)
        return IX_OK;
    do { /* new faces may come before the one in hand */
        again = false;
        for (int f = 0; f < h.nf; f++)
            if (!h.f[f].dead && h.f[f].outside >= 0) {
                add_point(&h, f);
                IX_TRY(ix__poll(ctx));
                again = true;
            }
    } while (again);
    IX_SCRATCH(ctx, *out, (size_t)h.nf + 1);
    for (int f = 0; f < h.nf; f++)
        if (!h.f[f].dead)
            memcpy((*out)[(*nfaces)++], h.f[f].v, sizeof **out);
    return IX_OK;
}
