/* poly_offset.c - edges moved to the right, and what joins them. */
#include "geom/poly_offset.h"

#include <math.h>
#include <string.h>

#include "geom/vec3.h"

#define ROUND_MAX  19  /* points of half a turn, every 10 degrees */
#define MITRE_MOST 4.0 /* times the distance */

typedef struct {
    double (*p)[3]; /* corners, no two neighbours equal */
    double (*r)[3]; /* the unit normal to the right of the edge that begins
                       there */
    int n;
    bool closed;
    double d;
    ix__join join;
    double (*out)[3];
    int m;
} outline;

static void add(outline *o, const double *p, double s, const double *dir)
{
    ix__axpy3(p, s, dir, o->out[o->m++]);
}

/* The points of the circle of radius |d| from direction a to b, both unit. */
static void add_arc(outline *o, const double *p, const double *a,
                    const double *b)
{
    double turn = acos(fmax(-1, fmin(1, ix__dot3(a, b)))), side[3];
    int steps = (int)ceil(turn / (acos(-1) / 18) - 1e-9);

    ix__axpy3(b, -ix__dot3(a, b), a, side);
    if (!(ix__unit3(side, side) > 0))
        steps = 1;
    add(o, p, o->d, a);
    for (int k = 1; k < steps; k++) {
        double w = turn * k / steps, dir[3];

        for (int i = 0; i < 3; i++)
            dir[i] = cos(w) * a[i] + sin(w) * side[i];
        add(o, p, o->d, dir);
    }
    add(o, p, o->d, b);
}

/* Whether the edges at corner i are to meet: on the outer side (mitre) if that
 * is not too far away, on the inner side if they are long enough. They meet at
 * p + d (a + b) / (1 + a.b), a, b being their normals. */
static bool edges_meet(const outline *o, int i, double cos1, bool inner)
{
    const double *p = o->p[i], *before = o->p[(i + o->n - 1) % o->n];
    double shorter = fmin(ix__dist3(before, p),
                          ix__dist3(o->p[(i + 1) % o->n], p));

    if (!inner)
        return o->join == IX__JOIN_MITRE &&
               cos1 > 2 / (MITRE_MOST * MITRE_MOST);
    /* |d| tan(turn / 2) <= shorter */
    return cos1 > 0 && o->d * o->d * (2 - cos1) <= shorter * shorter * cos1;
}

static void add_corner(outline *o, int i, const double *up)
{
    const double *p = o->p[i], *a = o->r[(i + o->n - 1) % o->n], *b = o->r[i];
    double cos1 = 1 + ix__dot3(a, b), sum[3], turn[3];
    bool inner;

    ix__axpy3(a, 1, b, sum);
    ix__cross3(a, b, turn);
    inner = ix__dot3(turn, up) * o->d <= 0; /* turns towards the offset */
    if (cos1 > 2 - 1e-15) {
        add(o, p, o->d, a);
        return;
    }
    if (edges_meet(o, i, cos1, inner)) {
        add(o, p, o->d / cos1, sum);
        return;
    }
    if (!inner && o->join == IX__JOIN_ROUND) {
        add_arc(o, p, a, b);
        return;
    }
    add(o, p, o->d, a);
    add(o, p, o->d, b);
}

static void make(outline *o, const double *up)
{
    int last = o->n - 1;

    for (int i = 0; i < o->n; i++) {
        if (!o->closed && i == 0)
            add(o, o->p[0], o->d, o->r[0]);
        else if (!o->closed && i == last)
            add(o, o->p[last], o->d, o->r[last - 1]);
        else
            add_corner(o, i, up);
    }
}

/* The corners without repeated ones, and the normals. */
static void load(outline *o, int n, const double (*p)[3], const double *up)
{
    for (int i = 0; i < n; i++)
        if (o->n == 0 || memcmp(o->p[o->n - 1], p[i], sizeof *p) != 0)
            memcpy(o->p[o->n++], p[i], sizeof *p);
    while (o->closed && o->n > 1 &&
           memcmp(o->p[0], o->p[o->n - 1], sizeof *p) == 0)
        o->n--;
    for (int i = 0; i < o->n; i++) {
        double e[3];

        ix__sub3(o->p[(i + 1) % o->n], o->p[i], e);
        ix__cross3(e, up, o->r[i]);
        (void)ix__unit3(o->r[i], o->r[i]);
    }
}

ix_status ix__polyline_offset(ix_ctx *ctx, int n, const double (*p)[3],
                              bool closed, const double up[3], double d,
                              ix__join join, int *m, double (**out)[3])
{
    outline o = {.closed = closed, .d = d, .join = join};

    IX_SCRATCH(ctx, o.p, n + 1);
    IX_SCRATCH(ctx, o.r, n + 1);
    IX_SCRATCH(ctx, o.out, (size_t)(n + 1) * (ROUND_MAX + 1));
    load(&o, n, p, up);
    if (o.n < 2)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "all vertices are one point, which has no sides");
    make(&o, up);
    *m = o.m;
    *out = o.out;
    return IX_OK;
}
