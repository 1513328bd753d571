/* plane_walk.h - the bisector of two sets as a function on the border of the
 * first. */
#ifndef OPS_PLANE_WALK_H
#define OPS_PLANE_WALK_H

#include "ops/plane.h"

/* One place of the border and the circle that touches there. */
typedef struct {
    int border;
    double at;
    bool valid; /* the centre is on the bisector */
    bool far;   /* not valid: the circle is a line, the centre at infinity */
    bool cut;   /* valid, but the foot jumps between here and the next one */
    bool own_circle; /* valid, and the circle is that of curvature: the second
                        foot is the own one, or so near that they cannot be
                        told apart */
    bool normal;     /* valid, on the common normal of two ends: there each r
                        from 0 on counts */
    bool narrow;     /* the other foot is next to the own one: plane_narrow.c */
    bool blocked;    /* not valid: the own set is in the circle, at foot */
    double c[2], n[2];  /* own foot, unit vector towards the centre */
    double x[2];        /* other foot */
    double apart[2];    /* x - c, to the last digits if narrow */
    double b[2], r;     /* centre and radius */
    ix__touch foot;     /* on the other set; if blocked, on the own one */
    int vertex, side;   /* of the other foot: vertex or -1, side of its span */
    double speed, rate; /* of the centre and of the other foot, by at */
    double along[2];    /* unit tangent of the bisector, in one of its senses */
} ix__sample;

typedef struct {
    const ix__set *own, *other; /* may be one set: its medial axis */
    double tol;   /* of the polyline of centres, relative to size or, farther
                     out, to the distance r from both sets */
    int grid;     /* samples of each element of the border at least */
    bool meeting; /* the sets may have points in common: centres whose circle
                     touches in such a point do not count */
    double size;  /* ix__sets_size */
} ix__walk;

/* A place to look at: where another touches, or a foot found from elsewhere. */
typedef struct {
    int border;
    double at;
} ix__place;

/* What the polyline may be off at a centre. */
static inline double ix__walk_room(const ix__walk *w, const ix__sample *a)
{
    return w->tol * (a->r > w->size ? a->r : w->size);
}
/* The sample there. */
void ix__walk_sample(const ix__walk *w, int border, double at, ix__sample *out);
/* The same, sooner if the other foot is near the one that is told; NULL: not
 * known. */
void ix__walk_sample_near(const ix__walk *w, int border, double at,
                          const ix__touch *foot, ix__sample *out);
/* The place of the own border from which the circle around b through the foot
 * is seen; false if it belongs to no element. */
bool ix__border_place(const ix__set *s, const ix__touch *foot,
                      const double b[2], ix__place *out);

/* Samples in blocks: growing moves none. Scratch. */
enum { IX__BLOCK = 128 };
typedef struct {
    int n, room; /* samples; blocks there is room for */
    ix__sample **block;
} ix__samples;
static inline ix__sample *ix__sample_at(const ix__samples *s, int i)
{
    return &s->block[i / IX__BLOCK][i % IX__BLOCK];
}

/* Samples along loop, close enough for w->tol where they are valid, each place
 * where something changes enclosed by two samples that are neighbours in
 * double. seeds (n of them, by increasing place) are sampled too. Scratch. */
ix_status ix__walk_loop(ix_ctx *ctx, const ix__walk *w, int loop, int nseeds,
                        const ix__place *seeds, ix__samples *out) IX_MUST_CHECK;

/* Samples first .. first + count - 1 (modulo n) with feet on the same elements.
 */
typedef struct {
    int first, count;
    bool far[2]; /* before and behind it the centre is at infinity */
    bool joined; /* begins where the run before it in the list ends */
    int loop;
} ix__run;

/* All runs of all loops: those of a loop in order, beginning behind a place at
 * infinity if there is one. loop[nloops] in scratch. */
typedef struct {
    int nruns, room, nloops;
    ix__run *run;
    ix__samples *loop;
} ix__walked;
/* first: nseeds places that are looked at in any case. */
ix_status ix__walk_all(ix_ctx *ctx, const ix__walk *w, int nseeds,
                       const ix__place *first, ix__walked *out) IX_MUST_CHECK;
/* Puts runs in the order in which they follow one another, also where that is
 * not the order around the border: where one ends and one begins, and no other.
 */
ix_status ix__walked_chain(ix_ctx *ctx, ix__walked *w) IX_MUST_CHECK;
static inline const ix__sample *ix__run_at(const ix__walked *w,
                                           const ix__run *r, int i)
{
    const ix__samples *s = &w->loop[r->loop];

    return ix__sample_at(s, (r->first + i) % s->n);
}

#endif
