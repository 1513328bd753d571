/* rand_obj.c - random objects of every type. */
#include "harness/rand_obj.h"

#include <string.h>

double ix_rand_double(ix_rng *r)
{
    double v;
    uint64_t bits;

    switch (ix_rng_int(r, 0, 3)) {
    case 0:
        return ix_rng_int(r, -9, 9);
    case 1:
        return ix_rng_range(r, -1, 1);
    case 2:
        return ix_rng_int(r, -99999, 99999) / 1000.0;
    default:
        do {
            bits = ix_rng_next(r);
            memcpy(&v, &bits, sizeof v);
        } while (!isfinite(v));
        return v;
    }
}

static void rand_doubles(ix_rng *r, int n, double *v)
{
    for (int i = 0; i < n; i++)
        v[i] = ix_rand_double(r);
}

/* --- freeforms -------------------------------------------------------- */

/* Non-decreasing, no value more than order times. */
static void rand_knots(ix_rng *r, int order, int n, double *knots)
{
    double at = ix_rng_range(r, -2, 2);
    int times = 0;

    for (int i = 0; i < n; i++) {
        if (times == order || ix_rng_int(r, 0, 2) == 0 || i == order) {
            at += ix_rng_range(r, 0.01, 1);
            times = 0;
        }
        knots[i] = at;
        times++;
    }
}

static ix_dir rand_dir(ix_rng *r, ix_basis basis, int most, double *knots)
{
    ix_dir d = {.basis = basis, .order = ix_rng_int(r, 1, most)};

    d.length = d.order;
    if (basis != IX_BSPLINE)
        return d;
    d.length += ix_rng_int(r, 0, 3);
    d.periodic = ix_rng_int(r, 0, 3) == 0;
    d.knots = knots;
    rand_knots(r, d.order, ix_knots_count(&d), knots);
    return d;
}

static double rand_coord(ix_rng *r)
{
    double v = ix_rand_double(r);

    return fabs(v) < 1e100 ? v : 1;
}

ix_mv *ix_rand_mv(ix_ctx *ctx, ix_rng *r, int ndirs)
{
    ix_basis basis = (ix_basis)ix_rng_int(r, 0, 2);
    int most = ndirs < 3 ? 4 : 2, nc = ix_rng_int(r, 1, 4);
    bool rational = ix_rng_int(r, 0, 1);
    double knots[IX_MAX_DIRS][32];
    ix_dir dirs[IX_MAX_DIRS];
    size_t n = 1;
    double *pts;
    ix_mark mk = ix__scratch_mark(ctx);
    ix_mv *m = NULL;

    if (ix_rng_int(r, 0, 9) == 0)
        nc = ix_rng_int(r, 5, IX_MAX_COORDS);
    for (int d = 0; d < ndirs; d++) {
        dirs[d] = rand_dir(r, basis, most, knots[d]);
        n *= (size_t)dirs[d].length;
    }
    pts = ix__scratch(ctx, n * (size_t)(nc + rational), sizeof *pts);
    for (size_t i = 0; pts && i < n * (size_t)(nc + rational); i++)
        pts[i] = rational && i < n ? ix_rng_range(r, 0.1, 3) : rand_coord(r);
    if (!pts || ix_mv_new(ctx, ndirs, dirs, nc, rational, pts, &m) != IX_OK)
        m = NULL;
    ix__scratch_release(ctx, mk);
    return m;
}

static ix_obj *rand_mvs(ix_ctx *ctx, ix_rng *r, ix_obj_type type)
{
    int n = ix_rng_int(r, 1, 3), made = 0;
    int dirs = type == IX_OBJ_CURVE     ? 1
               : type == IX_OBJ_SURFACE ? 2
               : type == IX_OBJ_TRIVAR  ? 3
                                        : ix_rng_int(r, 1, 5);
    const ix_mv *mv[3];
    ix_obj *o = NULL;

    while (made < n && (mv[made] = ix_rand_mv(ctx, r, dirs)))
        made++;
    if (made == n)
        o = ix__obj_mvs(ctx, type, ix__mvs_new(ctx, n, mv));
    for (int i = 0; i < made; i++)
        ix_mv_unref(ctx, mv[i]);
    return o;
}

/* --- attributes ------------------------------------------------------- */

static const char *rand_text(ix_rng *r)
{
    static const char *const texts[] = {"plain",     "two words",   "",
                                        "a\"quote",  "back\\slash", "[bracket]",
                                        "line\nend", "caf\xc3\xa9", "tab\there",
                                        "255,0,0",   "\\",          "12"};

    return texts[ix_rng_int(r, 0, sizeof texts / sizeof *texts - 1)];
}

static bool rand_attrs(ix_ctx *ctx, ix_rng *r, ix_attr **a, int depth)
{
    static const char *const names[] = {"width", "Color", "tExt",   "CURVE",
                                        "k-2",   "",      "a ]\"b", "normal"};
    ix_status st = IX_OK;
    ix_obj *o;

    for (int i = ix_rng_int(r, 0, 3); i > 0 && st == IX_OK; i--) {
        const char *name = names[ix_rng_int(r, 0, 7)];

        switch (ix_rng_int(r, 0, depth > 0 ? 3 : 2)) {
        case 0:
            st = ix__attr_set_int(ctx, a, name, ix_rng_int(r, -99, 99));
            break;
        case 1:
            st = ix__attr_set_real(ctx, a, name, ix_rand_double(r));
            break;
        case 2:
            st = ix__attr_set_string(ctx, a, name, rand_text(r));
            break;
        default:
            o = ix_rand_obj(ctx, r, depth - 1);
            st = o ? ix__attr_set_obj(ctx, a, name, o) : IX_ENOMEM;
            ix__obj_unref(ctx, o);
        }
    }
    return st == IX_OK;
}

/* --- polygons --------------------------------------------------------- */

static void rand_unit(ix_rng *r, double n[3])
{
    double len;

    for (int k = 0; k < 3; k++)
        n[k] = ix_rng_range(r, 0.1, 1);
    len = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int k = 0; k < 3; k++)
        n[k] /= len;
}

static bool rand_polygon(ix_ctx *ctx, ix_rng *r, ix_polygon *pg)
{
    int n = ix_rng_int(r, 1, 5);

    pg->kind = (ix_poly_kind)ix_rng_int(r, 0, 3);
    pg->has_plane = pg->kind == IX_POLYGON || pg->kind == IX_POLYSTRIP;
    if (pg->has_plane)
        rand_unit(r, pg->plane);
    if (pg->has_plane)
        pg->plane[3] = ix_rng_range(r, -1, 1);
    if (!rand_attrs(ctx, r, &pg->attrs, 0) ||
        ix__poly_vertices(ctx, pg, n) != IX_OK)
        return false;
    for (int i = 0; i < n; i++) {
        ix_vertex *v = &pg->v[i];

        rand_doubles(r, 3, v->p);
        v->has_normal = pg->has_plane;
        if (v->has_normal && ix_rng_int(r, 0, 1))
            rand_unit(r, v->normal);
        else
            memcpy(v->normal, pg->plane, sizeof v->normal);
        v->internal = pg->kind != IX_POINTLIST && ix_rng_int(r, 0, 3) == 0;
        if (ix_rng_int(r, 0, 3) == 0 && !rand_attrs(ctx, r, &v->attrs, 0))
            return false;
    }
    return true;
}

static ix_obj *rand_poly(ix_ctx *ctx, ix_rng *r)
{
    int n = ix_rng_int(r, 1, 3);
    ix_poly *p = ix__poly_new(ctx, n);

    for (int i = 0; p && i < n; i++) {
        if (!rand_polygon(ctx, r, &p->poly[i])) {
            ix__poly_unref(ctx, p);
            return NULL;
        }
    }
    return ix__obj_poly(ctx, p);
}

/* --- trimmed and triangular surfaces, models -------------------------- */

static ix_trimsrf *rand_trimsrf(ix_ctx *ctx, ix_rng *r)
{
    const ix_mv *srf = ix_rand_mv(ctx, r, 2);
    int n = ix_rng_int(r, 0, 2);
    ix_trimsrf *t = srf ? ix__trimsrf_new(ctx, srf, n) : NULL;
    bool ok = t != NULL;

    ix_mv_unref(ctx, srf);
    for (int i = 0; ok && i < n; i++) {
        int segs = ix_rng_int(r, 1, 3);

        ok = ix__trimloop_segs(ctx, &t->loop[i], segs) == IX_OK;
        for (int k = 0; ok && k < segs; k++) {
            ix_trimseg *s = &t->loop[i].seg[k];

            ok = (s->uv = ix_rand_mv(ctx, r, 1)) != NULL;
            if (ok && ix_rng_int(r, 0, 1))
                ok = (s->euclid = ix_rand_mv(ctx, r, 1)) != NULL;
        }
    }
    if (ok)
        return t;
    ix__trimsrf_unref(ctx, t);
    return NULL;
}

static ix_trisrf *rand_trisrf(ix_ctx *ctx, ix_rng *r)
{
    ix_tri_kind kind = (ix_tri_kind)ix_rng_int(r, 0, 2);
    int length = ix_rng_int(r, kind == IX_TRI_GREGORY ? 5 : 1, 6);
    int order = kind == IX_TRI_BSPLINE ? ix_rng_int(r, 1, length) : length;
    int nc = ix_rng_int(r, 1, 3);
    ix_trisrf *t = ix__trisrf_new(ctx, kind, length, order, nc,
                                  ix_rng_int(r, 0, 1));

    if (!t)
        return NULL;
    rand_knots(r, order, t->nknots, t->knots);
    rand_doubles(r, t->npts * (nc + t->rational), t->pts);
    for (int i = 0; t->rational && i < t->npts; i++)
        t->pts[i] = ix_rng_range(r, 0.1, 3);
    return t;
}

static bool rand_model_srf(ix_ctx *ctx, ix_rng *r, ix_model_srf *s, int nseg)
{
    int loops = ix_rng_int(r, 0, 2);

    s->srf = ix_rand_mv(ctx, r, 2);
    if (!s->srf || ix__model_loops(ctx, s, loops) != IX_OK)
        return false;
    for (int i = 0; i < loops; i++) {
        int n = ix_rng_int(r, 0, 4);

        if (ix__model_loop_segs(ctx, s, i, n) != IX_OK)
            return false;
        for (int k = 0; k < n; k++)
            s->seg[i][k] = ix_rng_int(r, 1, nseg) *
                           (ix_rng_int(r, 0, 1) ? 1 : -1);
    }
    return true;
}

static bool rand_model_seg(ix_ctx *ctx, ix_rng *r, ix_model_seg *s, int nsrf)
{
    s->mask = ix_rng_int(r, 0, 7);
    s->s1 = ix_rng_int(r, 0, nsrf);
    s->s2 = ix_rng_int(r, 0, nsrf);
    if ((s->mask & 1) && !(s->uv1 = ix_rand_mv(ctx, r, 1)))
        return false;
    if ((s->mask & 2) && !(s->uv2 = ix_rand_mv(ctx, r, 1)))
        return false;
    return !(s->mask & 4) || (s->euclid = ix_rand_mv(ctx, r, 1)) != NULL;
}

static ix_model *rand_model(ix_ctx *ctx, ix_rng *r)
{
    int nsrf = ix_rng_int(r, 1, 2), nseg = ix_rng_int(r, 1, 4);
    ix_model *m = ix__model_new(ctx, nsrf, nseg);
    bool ok = m != NULL;

    for (int i = 0; ok && i < nsrf; i++)
        ok = rand_model_srf(ctx, r, &m->srf[i], nseg);
    for (int i = 0; ok && i < nseg; i++)
        ok = rand_model_seg(ctx, r, &m->seg[i], nsrf);
    if (ok)
        return m;
    ix__model_unref(ctx, m);
    return NULL;
}

/* --- any object ------------------------------------------------------- */

static ix_obj *rand_list(ix_ctx *ctx, ix_rng *r, int depth)
{
    ix_obj *l = ix__obj_list(ctx);
    int n = ix_rng_int(r, 1, 4);

    for (int i = 0; l && i < n; i++) {
        ix_obj *o = ix_rand_obj(ctx, r, depth - 1);

        if (!o || ix__obj_append(ctx, l, o) != IX_OK) {
            ix__obj_unref(ctx, l);
            l = NULL;
        }
        ix__obj_unref(ctx, o);
    }
    return l;
}

static ix_obj *rand_simple(ix_ctx *ctx, ix_rng *r, ix_obj_type type)
{
    double v[16];
    ix_ctlpt p = {.ncoords = ix_rng_int(r, 1, 18)};
    const char *text = rand_text(r);

    rand_doubles(r, 16, v);
    p.rational = ix_rng_int(r, 0, 1);
    rand_doubles(r, p.ncoords + p.rational, p.v);
    switch (type) {
    case IX_OBJ_NUMBER:
        return ix__obj_number(ctx, v[0]);
    case IX_OBJ_POINT:
        return ix__obj_point(ctx, v);
    case IX_OBJ_VECTOR:
        return ix__obj_vector(ctx, v);
    case IX_OBJ_PLANE:
        return ix__obj_plane(ctx, v);
    case IX_OBJ_MATRIX:
        return ix__obj_matrix(ctx, v);
    case IX_OBJ_STRING:
        return ix__obj_string(ctx, text, strlen(text));
    case IX_OBJ_INSTANCE:
        return ix__obj_instance(ctx, "leg", v);
    case IX_OBJ_CTLPT:
        return ix__obj_ctlpt(ctx, &p);
    default:
        return ix__obj_undef(ctx);
    }
}

static ix_obj *rand_value(ix_ctx *ctx, ix_rng *r, ix_obj_type type, int depth)
{
    switch (type) {
    case IX_OBJ_LIST:
        return rand_list(ctx, r, depth);
    case IX_OBJ_POLY:
        return rand_poly(ctx, r);
    case IX_OBJ_TRIMSRF:
        return ix__obj_trimsrf(ctx, rand_trimsrf(ctx, r));
    case IX_OBJ_TRISRF:
        return ix__obj_trisrf(ctx, rand_trisrf(ctx, r));
    case IX_OBJ_MODEL:
        return ix__obj_model(ctx, rand_model(ctx, r));
    case IX_OBJ_CURVE:
    case IX_OBJ_SURFACE:
    case IX_OBJ_TRIVAR:
    case IX_OBJ_MULTIVAR:
        return rand_mvs(ctx, r, type);
    default:
        return rand_simple(ctx, r, type);
    }
}

ix_obj *ix_rand_obj_of(ix_ctx *ctx, ix_rng *r, ix_obj_type type, int depth)
{
    static const char *const names[] = {"NONE",        "c1",    "SURFACE",
                                        "a_Long_name", "x.y-z", "\xc3\xa9"};
    ix_obj *o = rand_value(ctx, r, type, depth);

    if (o && ix__obj_set_name(ctx, o, names[ix_rng_int(r, 0, 5)]) == IX_OK &&
        rand_attrs(ctx, r, &o->attrs, depth > 0 ? 1 : 0))
        return o;
    ix__obj_unref(ctx, o);
    return NULL;
}

ix_obj *ix_rand_obj(ix_ctx *ctx, ix_rng *r, int depth)
{
    ix_obj_type type;

    do
        type = (ix_obj_type)ix_rng_int(r, IX_OBJ_POLY, IX_OBJ_MULTIVAR);
    while (depth <= 0 && type == IX_OBJ_LIST);
    return ix_rand_obj_of(ctx, r, type, depth);
}
