/* bbox.c - the box of all geometry in an object. Control points stand for
 * their freeforms; missing coordinates count as 0. */
#include <math.h>

#include "object/walk.h"

typedef struct {
    ix_ctx *ctx;
    double *box; /* xmin xmax ymin ymax zmin zmax; xmin > xmax: empty */
} boxing;

static void grow(double *box, int c, double v)
{
    box[2 * c] = fmin(box[2 * c], v);
    box[2 * c + 1] = fmax(box[2 * c + 1], v);
}

static void grow_point(double *box, const double p[3])
{
    for (int c = 0; c < 3; c++)
        grow(box, c, p[c]);
}

static ix_status grow_mv(const boxing *b, const ix_mv *m)
{
    double lo[IX_MAX_COORDS], hi[IX_MAX_COORDS];

    IX_TRY(ix_mv_bbox(b->ctx, m, lo, hi));
    for (int c = 0; c < 3; c++) {
        grow(b->box, c, c < ix_mv_ncoords(m) ? lo[c] : 0);
        grow(b->box, c, c < ix_mv_ncoords(m) ? hi[c] : 0);
    }
    return IX_OK;
}

/* A point given by its coordinates [n] and weight, w apart in memory. */
static ix_status grow_rational(const boxing *b, int n, const double *v,
                               size_t stride, double weight)
{
    double p[3] = {0, 0, 0};

    if (weight == 0)
        return IX_FAIL(b->ctx, IX_EDOMAIN,
                       "a control point at infinity has no box");
    for (int c = 0; c < n && c < 3; c++)
        p[c] = v[(size_t)c * stride] / weight;
    grow_point(b->box, p);
    return IX_OK;
}

static ix_status grow_trisrf(const boxing *b, const ix_trisrf *t)
{
    size_t n = (size_t)t->npts;
    const double *xyz = t->pts + (t->rational ? n : 0);

    for (size_t i = 0; i < n; i++)
        IX_TRY(grow_rational(b, t->ncoords, xyz + i, n,
                             t->rational ? t->pts[i] : 1));
    return IX_OK;
}

static void grow_poly(const boxing *b, const ix_poly *p)
{
    for (int i = 0; i < p->n; i++)
        for (int k = 0; k < p->poly[i].n; k++)
            grow_point(b->box, p->poly[i].v[k].p);
}

static ix_status grow_model(const boxing *b, const ix_model *m)
{
    for (int i = 0; i < m->nsrf; i++)
        IX_TRY(grow_mv(b, m->srf[i].srf));
    return IX_OK;
}

static ix_status grow_item(const boxing *b, ix_obj_type type, const void *item)
{
    switch (type) {
    case IX_OBJ_TRIMSRF:
        return grow_mv(b, ((const ix_trimsrf *)item)->srf);
    case IX_OBJ_TRISRF:
        return grow_trisrf(b, item);
    case IX_OBJ_MODEL:
        return grow_model(b, item);
    default:
        return grow_mv(b, item);
    }
}

static ix_status grow_leaf(void *arg, const ix_obj *o)
{
    const boxing *b = arg;
    const ix_ctlpt *p;

    IX_TRY(ix__poll(b->ctx));
    switch (o->type) {
    case IX_OBJ_POINT:
    case IX_OBJ_VECTOR:
        grow_point(b->box, o->u.pt);
        return IX_OK;
    case IX_OBJ_CTLPT:
        p = o->u.ctlpt;
        return grow_rational(b, p->ncoords, p->v + p->rational, 1,
                             p->rational ? p->v[0] : 1);
    case IX_OBJ_POLY:
        grow_poly(b, o->u.poly);
        return IX_OK;
    default:
        for (int i = 0; i < ix__seq_count(o); i++)
            IX_TRY(grow_item(b, o->type, ix__seq_item(o, i)));
        return IX_OK;
    }
}

ix_status ix__obj_bbox(ix_ctx *ctx, const ix_obj *o, double box[6])
{
    boxing b = {ctx, box};

    for (int i = 0; i < 6; i++)
        box[i] = i % 2 ? -HUGE_VAL : HUGE_VAL;
    IX_TRY(ix__walk_leaves(o, grow_leaf, &b));
    if (!(box[0] <= box[1]))
        return IX_FAIL(ctx, IX_EDOMAIN, "there is no geometry to put in a box");
    return IX_OK;
}
