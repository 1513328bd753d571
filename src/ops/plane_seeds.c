/* plane_seeds.c - places of the border from which every part of a bisector can
 * be reached: beside crossings, and around the regions behind common ends.
 *
 * Law: parts of the bisector of two connected objects that meet begin or end at
 * a common point or a region behind one. A part that did neither would be a
 * closed curve, or one from infinity to infinity, and have the one object on
 * one side, the other one on the other: they would not meet. */
#include <math.h>

#include "base/grow.h"
#include "geom/parts.h"
#include "iritx/distance.h"
#include "ops/plane_bisector.h"

typedef struct {
    ix_ctx *ctx;
    const ix__set *own, *other;
    int n, room;
    ix__place *p;
} places;

static ix_status add_place(places *l, int border, double at)
{
    if (!(at > 0.0 && at < 1.0))
        return IX_OK;
    IX_GROW(l->ctx, l->p, l->n, l->room);
    l->p[l->n++] = (ix__place){border, at};
    return IX_OK;
}

/* --- crossings -------------------------------------------------------------
 *
 * Where the curves cross four branches meet. They may belong to parts of the
 * bisector, however small, that are connected to others by crossings only: on
 * either side of the first curve, a little before and behind each crossing, the
 * walk looks for them. */

/* Branches whose feet stay near a crossing, or near an end where one curve goes
 * on from the other, may be as short as that on the curve. */
static const double steps[] = {1e-11, 1e-10, 1e-9, 1e-8, 1e-7,
                               1e-6,  1e-5,  1e-4, 1e-3, 1e-2};
enum { STEPS = sizeof steps / sizeof *steps };

/* The border elements of span i, at all steps before and behind u. */
static ix_status both_sides(places *l, int i, double u)
{
    for (int j = 0; j < l->own->nborders; j++) {
        const ix__border *e = &l->own->border[j];
        double at = e->side > 0 ? u : 1.0 - u;

        if (e->kind != IX__SIDE || e->index != i)
            continue;
        for (int k = 0; k < STEPS; k++) {
            IX_TRY(add_place(l, j, at - steps[k]));
            IX_TRY(add_place(l, j, at + steps[k]));
        }
    }
    return IX_OK;
}

static ix_status add_crossing(places *l, int curve, double t)
{
    for (int i = 0; i < l->own->nspans; i++) {
        const ix__span *sp = &l->own->span[i];
        double u = (t - sp->t[0]) / (sp->t[1] - sp->t[0]);

        if (sp->curve == curve && u > -1e-9 && u < 1.0 + 1e-9)
            IX_TRY(both_sides(l, i, u));
    }
    return IX_OK;
}

static ix_status crossings(places *l, int curve, const ix_mv *a, const ix_mv *b)
{
    /* overlapping curves would fill any number of boxes */
    static const ix_solve_opts few = {.max_boxes = 20000};
    ix_solutions meet;
    ix_status st = IX_OK;

    IX_TRY(ix_crv_crv_meet(l->ctx, a, b, &few, &meet));
    for (int i = 0; i < meet.n && st == IX_OK; i++)
        st = add_crossing(l, curve, meet.sol[i].x[0]);
    ix_solutions_free(l->ctx, &meet);
    return st;
}

/* --- regions ---------------------------------------------------------------
 *
 * Behind a common end is a region in which all points have it as nearest point
 * on both. In direction n it is as deep as the larger of both curvatures seen
 * from there lets it be; where the other set's becomes the larger one, or the
 * end of a curve begins to touch, a part of the bisector may begin. */

/* Directions that are looked at in a fan: what changes twice between two of
 * them may be missed. */
enum { DIRECTIONS = 64, HALVINGS = 52, MOST_CHANGES = 4 };
/* What touches nearer than a radius of 1e-5 is the end's own curve. */
#define ITS_OWN 1e5

typedef enum { UNBOUNDED, FIRST, SECOND, NOTHING } limit;

typedef struct {
    double angle;
    limit by;
    ix__touch own;
    double b[2];
} depth;

/* How deep the region behind x is at that angle, and what ends it. */
static depth depth_at(const places *l, const double x[2], double angle)
{
    double n[2] = {cos(angle), sin(angle)}, r;
    ix__touch other = {.span = -1};
    depth d = {.angle = angle, .own = {.span = -1}};

    ix__set_touch(l->own, x, n, IX__DEPTH, &d.own);
    ix__set_touch(l->other, x, n, IX__DEPTH, &other);
    r = 1.0 / fmax(d.own.kappa, other.kappa);
    for (int k = 0; k < 2; k++)
        d.b[k] = x[k] + r * n[k];
    d.by = !(r >= 1.0 / ITS_OWN)        ? NOTHING
           : !isfinite(r)               ? UNBOUNDED
           : d.own.kappa >= other.kappa ? FIRST
                                        : SECOND;
    return d;
}

/* Around where the first set ends the region. */
static ix_status add_depth(places *l, const depth *d)
{
    ix__place p;

    if (d->by != FIRST || !ix__border_place(l->own, &d->own, d->b, &p))
        return IX_OK;
    for (int k = 0; k < STEPS; k++) {
        IX_TRY(add_place(l, p.border, p.at - steps[k]));
        IX_TRY(add_place(l, p.border, p.at + steps[k]));
    }
    return IX_OK;
}

/* Encloses the first change between *a and *b. */
static void enclose(const places *l, const double x[2], depth *a, depth *b)
{
    for (int i = 0; i < HALVINGS; i++) {
        depth m = depth_at(l, x, 0.5 * (a->angle + b->angle));

        if (m.by == a->by)
            *a = m;
        else
            *b = m;
    }
}

/* All changes between a and b that halving finds: beside its normal the end of
 * the one curve gives way to itself first, then to the other. */
static ix_status add_changes(places *l, const double x[2], depth a, depth b)
{
    for (int i = 0; i < MOST_CHANGES && a.by != b.by; i++) {
        depth hi = b;

        enclose(l, x, &a, &hi);
        IX_TRY(add_depth(l, &a));
        IX_TRY(add_depth(l, &hi));
        a = hi;
    }
    return IX_OK;
}

static ix_status around_region(places *l, const ix__border *fan)
{
    const double *x = l->own->vertex[fan->index].x;
    depth a = depth_at(l, x, fan->from);

    for (int i = 1; i <= DIRECTIONS; i++) {
        double s = (double)i / DIRECTIONS;
        depth b = depth_at(l, x, fan->from + s * (fan->to - fan->from));

        IX_TRY(add_changes(l, x, a, b));
        a = b;
    }
    return IX_OK;
}

static ix_status regions(places *l)
{
    for (int i = 0; i < l->own->nborders; i++) {
        const ix__border *e = &l->own->border[i];

        if (e->kind == IX__FAN && l->own->vertex[e->index].shared)
            IX_TRY(around_region(l, e));
    }
    return IX_OK;
}

/* --- entry -----------------------------------------------------------------
 */

ix_status ix__plane_seeds(ix_ctx *ctx, const ix__object obj[2], int *n,
                          ix__place **out)
{
    places l = {.ctx = ctx, .own = obj[0].set, .other = obj[1].set};

    for (int i = 0; i < obj[0].n; i++)
        for (int j = 0; j < obj[1].n; j++)
            IX_TRY(crossings(&l, i, obj[0].crv[i], obj[1].crv[j]));
    IX_TRY(regions(&l));
    *n = l.n;
    *out = l.p;
    return IX_OK;
}
