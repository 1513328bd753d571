/* shapes.c - the walk over an object for polygonal formats. Trivariates are
 * shown by their six sides. */
#include "io/shapes.h"

#include <math.h>
#include <string.h>

#include "io/x3d_impl.h"
#include "object/walk.h"

typedef struct {
    ix_ctx *ctx;
    double tol;
    const ix__shape_sink *sink;
    size_t written, skipped;
} walker;

/* --- the default tolerance --------------------------------------------- */

enum { LEAST_WEIGHT = 64 }; /* the tessellator leaves out the rest */

static void grow_mv(const ix_mv *m, double box[6])
{
    const double *w = ix_mv_weights(m);
    double wmax = 0;

    for (size_t i = 0; w && i < ix_mv_npts(m); i++)
        wmax = fmax(wmax, fabs(w[i]));
    for (size_t i = 0; i < ix_mv_npts(m); i++)
        for (int c = 0; c < 3; c++) {
            double x = c < ix_mv_ncoords(m) ? ix_mv_coord(m, c)[i] : 0;

            if (w && !(fabs(w[i]) * LEAST_WEIGHT >= wmax && w[i] != 0))
                continue;
            x /= w ? w[i] : 1;
            box[2 * c] = fmin(box[2 * c], x);
            box[2 * c + 1] = fmax(box[2 * c + 1], x);
        }
}

static void grow_all(const ix_obj *o, double box[6])
{
    for (int i = 0; i < ix__seq_count(o); i++) {
        const void *item = ix__seq_item(o, i);

        if (o->type == IX_OBJ_TRIMSRF)
            grow_mv(((const ix_trimsrf *)item)->srf, box);
        else if (o->type == IX_OBJ_MODEL)
            for (int k = 0; k < ((const ix_model *)item)->nsrf; k++)
                grow_mv(((const ix_model *)item)->srf[k].srf, box);
        else if (o->type != IX_OBJ_TRISRF)
            grow_mv(item, box);
    }
}

static ix_status grow_leaf(void *arg, const ix_obj *o)
{
    double *box = arg;

    grow_all(o, box);
    return IX_OK;
}

ix_status ix__shape_tol(ix_ctx *ctx, const ix_obj *o, double *tol)
{
    double box[6], d = 0;

    (void)ctx;
    for (int i = 0; i < 6; i++)
        box[i] = i % 2 ? -HUGE_VAL : HUGE_VAL;
    IX_TRY(ix__walk_leaves(o, grow_leaf, box));
    for (int c = 0; c < 3 && box[0] <= box[1]; c++)
        d = hypot(d, box[2 * c + 1] - box[2 * c]);
    *tol = d > 0 ? d / 1000 : 1;
    return IX_OK;
}

/* --- freeforms ----------------------------------------------------------- */

static ix_status give_mesh(walker *w, const ix_obj *o, ix__mesh *m)
{
    ix_status st = w->sink->mesh(w->sink->arg, o, m);

    w->written += m->ntris > 0;
    ix__mesh_free(w->ctx, m);
    return st;
}

static ix_status surface(walker *w, const ix_obj *o, const ix_mv *srf)
{
    ix__mesh m;

    if (!w->sink->mesh) {
        w->skipped++;
        return IX_OK;
    }
    IX_TRY(ix__mesh_of_srf(w->ctx, srf, w->tol, &m));
    return give_mesh(w, o, &m);
}

static ix_status curve(walker *w, const ix_obj *o, const ix_mv *crv)
{
    ix__lines l;
    ix_status st;

    if (!w->sink->lines) {
        w->skipped++;
        return IX_OK;
    }
    IX_TRY(ix__lines_of_crv(w->ctx, crv, w->tol, &l));
    st = w->sink->lines(w->sink->arg, o, &l);
    w->written += l.nlines > 0;
    ix__lines_free(w->ctx, &l);
    return st;
}

/* The sides of a box of parameters. */
static ix_status sides(walker *w, const ix_obj *o, const ix_mv *tv)
{
    for (int d = 0; d < 3; d++)
        for (int end = 0; end < 2; end++) {
            double dom[2];
            ix_status st;
            ix_mv *side;

            ix_mv_domain(tv, d, dom);
            IX_TRY(ix_mv_fix(w->ctx, tv, d, dom[end], &side));
            st = w->sink->freeform ? w->sink->freeform(w->sink->arg, o, side)
                                   : surface(w, o, side);
            w->written += w->sink->freeform != NULL;
            ix_mv_unref(w->ctx, side);
            IX_TRY(st);
        }
    return IX_OK;
}

static ix_status freeform(walker *w, const ix_obj *o, const ix_mv *m)
{
    if (w->sink->freeform && ix_mv_ndirs(m) <= 2) {
        w->written++;
        return w->sink->freeform(w->sink->arg, o, m);
    }
    switch (ix_mv_ndirs(m)) {
    case 1:
        return curve(w, o, m);
    case 2:
        return surface(w, o, m);
    case 3:
        return sides(w, o, m);
    default:
        w->skipped++;
        return IX_OK;
    }
}

/* --- trimmed surfaces and models ------------------------------------------ */

static ix_status meshes(walker *w, const ix_obj *o, int n, const ix__face *face)
{
    ix_status st = IX_OK;
    ix__mesh *m;

    IX_TRY(ix__mesh_of_faces(w->ctx, n, face, w->tol, NULL, &m));
    for (int i = 0; i < n; i++)
        if (st == IX_OK)
            st = give_mesh(w, o, &m[i]);
        else
            ix__mesh_free(w->ctx, &m[i]);
    return st;
}

static ix_status faces(walker *w, const ix_obj *o, int n, const ix__face *face)
{
    if (w->sink->faces) {
        w->written++;
        return w->sink->faces(w->sink->arg, o, n, face);
    }
    if (w->sink->mesh)
        return meshes(w, o, n, face);
    w->skipped++;
    return IX_OK;
}

/* Loops that are none: the reason is told, the rest is written. */
static ix_status leave_out(walker *w, ix_status st)
{
    if (st != IX_EARG && st != IX_EDOMAIN)
        return st;
    ix__note(w->ctx, "warning: %s", ix_ctx_message(w->ctx));
    w->skipped++;
    return IX_OK;
}

static ix_status trimmed(walker *w, const ix_obj *o, const ix_trimsrf *t)
{
    ix__face face;
    ix_status st = ix__face_of_trimsrf(w->ctx, t, &face);

    return st == IX_OK ? faces(w, o, 1, &face) : leave_out(w, st);
}

static ix_status model(walker *w, const ix_obj *o, const ix_model *m)
{
    ix__face *face;
    ix_status st = ix__faces_of_model(w->ctx, m, &face);

    return st == IX_OK ? faces(w, o, m->nsrf, face) : leave_out(w, st);
}

/* --- leaves -------------------------------------------------------------- */

static ix_status point(walker *w, const ix_obj *o, const double p[3])
{
    if (!w->sink->point) {
        w->skipped++;
        return IX_OK;
    }
    w->written++;
    return w->sink->point(w->sink->arg, o, p);
}

static ix_status control_point(walker *w, const ix_obj *o)
{
    const ix_ctlpt *c = o->u.ctlpt;
    double p[3] = {0, 0, 0}, d = c->rational ? c->v[0] : 1;

    if (d == 0) {
        w->skipped++;
        return IX_OK;
    }
    for (int k = 0; k < 3 && k < c->ncoords; k++)
        p[k] = c->v[k + c->rational] / d;
    return point(w, o, p);
}

static ix_status item(walker *w, const ix_obj *o, const void *it)
{
    switch (o->type) {
    case IX_OBJ_TRIMSRF:
        IX_RETURN_SCOPED(w->ctx, trimmed(w, o, it));
    case IX_OBJ_MODEL:
        IX_RETURN_SCOPED(w->ctx, model(w, o, it));
    case IX_OBJ_TRISRF:
        w->skipped++;
        return IX_OK;
    default:
        return freeform(w, o, it);
    }
}

static ix_status leaf(void *arg, const ix_obj *o)
{
    walker *w = arg;

    switch (o->type) {
    case IX_OBJ_POINT:
        return point(w, o, o->u.pt);
    case IX_OBJ_CTLPT:
        return control_point(w, o);
    case IX_OBJ_POLY:
        if (!w->sink->poly) {
            w->skipped++;
            return IX_OK;
        }
        w->written++;
        return w->sink->poly(w->sink->arg, o, o->u.poly);
    case IX_OBJ_INSTANCE:
        w->skipped++;
        return IX_OK;
    default:
        for (int i = 0; i < ix__seq_count(o); i++)
            IX_TRY(item(w, o, ix__seq_item(o, i)));
        return IX_OK;
    }
}

ix_status ix__shapes(ix_ctx *ctx, const ix_obj *o, double tol,
                     const ix__shape_sink *sink)
{
    walker w = {.ctx = ctx, .tol = tol, .sink = sink};

    if (tol == 0)
        IX_TRY(ix__shape_tol(ctx, o, &w.tol));
    IX_TRY(ix__walk_leaves(o, leaf, &w));
    if (w.written == 0)
        return IX_FAIL(ctx, IX_EARG,
                       "there is nothing that %s can hold: it takes %s",
                       sink->format, sink->holds);
    if (w.skipped > 0)
        ix__note(ctx, "%zu shape%s left out: not for %s", w.skipped,
                 w.skipped > 1 ? "s are" : " is", sink->format);
    return IX_OK;
}

/* --- polygons ------------------------------------------------------------ */

typedef struct {
    const ix_polygon *pg;
    int x, y; /* the coordinates seen */
    double sign;
} plan;

/* Twice the signed area of a corner, positive if it is convex. */
static double turn(const plan *l, int a, int b, int c)
{
    const double *p = l->pg->v[a].p, *q = l->pg->v[b].p, *r = l->pg->v[c].p;

    return l->sign * ((q[l->x] - p[l->x]) * (r[l->y] - p[l->y]) -
                      (q[l->y] - p[l->y]) * (r[l->x] - p[l->x]));
}

static plan plan_of(const ix_polygon *pg)
{
    double n[4] = {0, 0, 1, 0};
    int k = 2;

    (void)ix__polygon_plane(pg, n);
    for (int c = 0; c < 3; c++)
        if (fabs(n[c]) > fabs(n[k]))
            k = c;
    return (plan){pg, (k + 1) % 3, (k + 2) % 3, n[k] < 0 ? -1 : 1};
}

/* Is corner i of the n that are left one that can be cut off? */
static bool is_ear(const plan *l, const int *left, int n, int i)
{
    int a = left[(i + n - 1) % n], b = left[i], c = left[(i + 1) % n];

    if (!(turn(l, a, b, c) > 0))
        return false;
    for (int k = 0; k < n; k++) {
        int p = left[k];

        if (p != a && p != b && p != c && turn(l, a, b, p) >= 0 &&
            turn(l, b, c, p) >= 0 && turn(l, c, a, p) >= 0)
            return false;
    }
    return true;
}

int ix__polygon_ears(const ix_polygon *pg, int *work, int (*tri)[3])
{
    plan l = plan_of(pg);
    int n = pg->n, k = 0, i = 0, missed = 0;

    for (int j = 0; j < n; j++)
        work[j] = j;
    while (n > 3) {
        /* after a whole turn without an ear (crossing sides, corners in a
         * line) any corner will do */
        if (missed < n && !is_ear(&l, work, n, i % n)) {
            i++;
            missed++;
            continue;
        }
        i %= n;
        tri[k][0] = work[(i + n - 1) % n];
        tri[k][1] = work[i];
        tri[k++][2] = work[(i + 1) % n];
        memmove(work + i, work + i + 1, (size_t)(n - 1 - i) * sizeof *work);
        n--;
        missed = 0;
    }
    if (n == 3) {
        memcpy(tri[k], work, sizeof tri[k]);
        k++;
    }
    return k;
}

/* --- colours -------------------------------------------------------------- */

bool ix__shape_color(const ix_obj *o, double rgb[3])
{
    const ix__x3d_look none = {.rgb = {-1, -1, -1}};
    ix__x3d_look look = ix__x3d_look_of(o->attrs, none);

    memcpy(rgb, look.rgb, sizeof look.rgb);
    return rgb[0] >= 0;
}
