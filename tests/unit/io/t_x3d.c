/* X3D: what a reader of the standard makes of the nodes is the geometry that
 * was written. The reader here follows the standard: homogeneous points,
 * multiplied by their weights. */
#include <libxml/parser.h>
#include <libxml/tree.h>
#include <stdlib.h>
#include <string.h>

#include "harness/fault.h"
#include "harness/rand_obj.h"
#include "harness/randmv.h"
#include "harness/test.h"
#include "io/io.h"

/* Two evaluations of the same points; weights of randmv are in [0.3, 3]. */
#define TOL 1e-11

static xmlDocPtr write_scene(ix_ctx *ctx, const ix_obj *o)
{
    xmlDocPtr doc;
    ix_buf b;

    ix__buf_init(&b, ctx);
    ASSERT_OK(ctx, ix__x3d_write(&b, o, NULL));
    doc = xmlReadMemory(b.data, (int)b.len, "scene", NULL, XML_PARSE_NONET);
    if (!doc)
        fail_msg("not well-formed:\n%.2000s", b.data);
    ix__buf_free(&b);
    return doc;
}

/* The first node of that name at or below n, in document order. */
static xmlNodePtr find(xmlNodePtr n, const char *name)
{
    for (; n; n = n->next) {
        xmlNodePtr below;

        if (strcmp((const char *)n->name, name) == 0)
            return n;
        below = find(n->children, name);
        if (below)
            return below;
    }
    return NULL;
}

static int count(xmlNodePtr n, const char *name)
{
    int k = 0;

    for (; n; n = n->next)
        k += (strcmp((const char *)n->name, name) == 0) +
             count(n->children, name);
    return k;
}

/* The numbers of an attribute; *n of them. NULL if it is not there. */
static double *numbers(xmlNodePtr node, const char *name, int *n)
{
    char *text = (char *)xmlGetProp(node, (const xmlChar *)name), *p = text;
    double *v;

    *n = 0;
    if (!text)
        return NULL;
    v = malloc((strlen(text) + 1) * sizeof *v);
    assert_non_null(v);
    while (*p) {
        const char *next = ix_num_parse(p, text + strlen(text), &v[*n]);

        assert_non_null(next);
        ++*n;
        p = text + (next - text);
        p += strspn(p, ", ");
    }
    xmlFree(text);
    return v;
}

static int integer(xmlNodePtr node, const char *name)
{
    int n;
    double *v = numbers(node, name, &n), x;

    assert_non_null(v);
    assert_int_equal(n, 1);
    x = v[0];
    free(v);
    return (int)x;
}

/* Points of dim numbers each and their weights, as our axes. */
static ix_mv *assemble(ix_ctx *ctx, int ndirs, const ix_dir *dirs, int dim,
                       const double *p, int np, const double *w, int nw)
{
    int n = np / dim;
    double *pts = malloc((size_t)(dim + 1) * (size_t)n * sizeof *pts);
    ix_mv *m;

    assert_non_null(pts);
    assert_true(!w || nw == n);
    for (int i = 0; i < n; i++) {
        if (w)
            assert_true(w[i] > 0);
        pts[i] = w ? w[i] : 0;
        for (int c = 0; c < dim; c++)
            pts[(c + (w ? 1 : 0)) * n + i] = p[i * dim + c];
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, ndirs, dirs, dim, w != NULL, pts, &m));
    free(pts);
    return m;
}

static ix_mv *read_curve(ix_ctx *ctx, xmlNodePtr node)
{
    int nk, np, nw;
    double *k = numbers(node, "knot", &nk), *w = numbers(node, "weight", &nw);
    double *p = numbers(find(node->children, "CoordinateDouble"), "point", &np);
    ix_dir dir = {IX_BSPLINE, integer(node, "order"), np / 3, false, k};
    ix_mv *m;

    assert_int_equal(nk, dir.order + dir.length);
    assert_true(dir.order >= 2);
    assert_true(integer(node, "tessellation") > 0);
    m = assemble(ctx, 1, &dir, 3, p, np, w, nw);
    free(k), free(w), free(p);
    return m;
}

static ix_mv *read_surface(ix_ctx *ctx, xmlNodePtr node)
{
    int nu, nv, np, nw;
    double *u = numbers(node, "uKnot", &nu), *v = numbers(node, "vKnot", &nv);
    double *w = numbers(node, "weight", &nw);
    double *p = numbers(find(node->children, "CoordinateDouble"), "point", &np);
    ix_dir dirs[2] = {{IX_BSPLINE, integer(node, "uOrder"),
                       integer(node, "uDimension"), false, u},
                      {IX_BSPLINE, integer(node, "vOrder"),
                       integer(node, "vDimension"), false, v}};
    ix_mv *m;

    assert_int_equal(nu, dirs[0].order + dirs[0].length);
    assert_int_equal(nv, dirs[1].order + dirs[1].length);
    assert_int_equal(np, 3 * dirs[0].length * dirs[1].length);
    m = assemble(ctx, 2, dirs, 3, p, np, w, nw);
    free(u), free(v), free(w), free(p);
    return m;
}

/* --- freeforms -------------------------------------------------------- */

/* The same Euclidean points at random parameters; missing coordinates 0. */
static void check_points(ix_ctx *ctx, ix_rng *r, const ix_mv *m,
                         const ix_mv *got)
{
    for (int i = 0; i < 8; i++) {
        double t[2], a[IX_MAX_COORDS], b[3];

        ix_mv_randparam(r, got, t);
        ASSERT_OK(ctx, ix_mv_point(ctx, m, t, a));
        ASSERT_OK(ctx, ix_mv_point(ctx, got, t, b));
        for (int c = 0; c < 3; c++)
            ASSERT_CLOSE(b[c], c < ix_mv_ncoords(m) ? a[c] : 0, TOL);
    }
}

static void check_mv(ix_ctx *ctx, ix_rng *r, const ix_mv *m)
{
    ix_obj *o = ix__obj_mv(ctx, ix__obj_type_of_mv(m), ix_mv_ref(m));
    xmlDocPtr doc = write_scene(ctx, o);
    bool curve = ix_mv_ndirs(m) == 1;
    xmlNodePtr node = find(xmlDocGetRootElement(doc),
                           curve ? "NurbsCurve" : "NurbsPatchSurface");
    ix_mv *got;

    assert_non_null(node);
    got = curve ? read_curve(ctx, node) : read_surface(ctx, node);
    check_points(ctx, r, m, got);
    ix_mv_unref(ctx, got);
    xmlFreeDoc(doc);
    ix__obj_unref(ctx, o);
}

/* Law: curves and surfaces of every kind come out the same. */
static void test_freeforms(void **state)
{
    ix_rng r = ix_rng_new(0x3d1);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int i = 0; i < 60; i++) {
        ix_rand_opts opts = {.ndirs = 1 + i % 2,
                             .kinds = IX_RAND_ALL & ~(unsigned)IX_RAND_JUMPS,
                             .min_order = 2,
                             .max_order = 4};
        ix_mv *m = ix_mv_randtest(ctx, &r, &opts);

        if (!ix_mv_has_poles(m))
            check_mv(ctx, &r, m);
        ix_mv_unref(ctx, m);
    }
    ix_ctx_free(ctx);
}

/* Negative weights all through are the same curve; x of a pole at 1/2 is not
 * bounded: all pieces together leave out a small part of it. */
static void test_poles(void **state)
{
    const ix_dir dir = {IX_BEZIER, 2, 2, false, NULL};
    const double negative[] = {-1, -2, 3, 4}, pole[] = {1, -1, 1, 1};
    ix_rng r = ix_rng_new(0x3d2);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_mv *m;
    ix_obj *o;
    xmlDocPtr doc;

    (void)state;
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, true, negative, &m));
    check_mv(ctx, &r, m);
    ix_mv_unref(ctx, m);
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 1, true, pole, &m));
    o = ix__obj_mv(ctx, IX_OBJ_CURVE, m);
    doc = write_scene(ctx, o);
    assert_int_equal(count(xmlDocGetRootElement(doc), "NurbsCurve"), 22);
    xmlFreeDoc(doc);
    ix__obj_unref(ctx, o);
    ix_ctx_free(ctx);
}

/* Law: the lines and triangles beside a curve or surface have their points on
 * it: those of an arc and a cylinder of radius 2 are 2 from the axis. */
static void test_approximation(void **state)
{
    static const double h = 0.70710678118654757;
    const ix_dir dirs[2] = {{IX_BEZIER, 3, 3, false, NULL},
                            {IX_BEZIER, 2, 2, false, NULL}};
    const double arc[] = {1, h, 1, 2, 2 * h, 0, 0, 2 * h, 2};
    const double cylinder[] = {1,     h, 1,     1, h, 1,     2,     2 * h,
                               0,     2, 2 * h, 0, 0, 2 * h, 2,     0,
                               2 * h, 2, 0,     0, 0, 5,     5 * h, 5};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int nd = 1; nd <= 2; nd++) {
        ix_mv *m;
        ix_obj *o;
        xmlDocPtr doc;
        xmlNodePtr node;
        double *p;
        int n;

        ASSERT_OK(ctx, ix_mv_new(ctx, nd, dirs, nd + 1, true,
                                 nd == 1 ? arc : cylinder, &m));
        o = ix__obj_mv(ctx, ix__obj_type_of_mv(m), m);
        doc = write_scene(ctx, o);
        node = find(xmlDocGetRootElement(doc),
                    nd == 1 ? "LineSet" : "IndexedTriangleSet");
        assert_non_null(node);
        p = numbers(find(node->children, "Coordinate"), "point", &n);
        assert_true(n > 12 && n % 3 == 0);
        for (int i = 0; i < n; i += 3)
            ASSERT_CLOSE(hypot(p[i], p[i + 1]), 2, TOL);
        free(p);
        xmlFreeDoc(doc);
        ix__obj_unref(ctx, o);
    }
    ix_ctx_free(ctx);
}

/* --- trimmed surfaces --------------------------------------------------- */

static ix_mv *square(ix_ctx *ctx, double lo, double hi, bool clockwise)
{
    static const double knots[] = {0, 0, 1, 2, 3, 4, 4};
    const ix_dir dir = {IX_BSPLINE, 2, 5, false, knots};
    const double a[10] = {lo, hi, hi, lo, lo, lo, lo, hi, hi, lo};
    const double b[10] = {lo, lo, hi, hi, lo, lo, hi, hi, lo, lo};
    ix_mv *m;

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &dir, 2, false, clockwise ? b : a, &m));
    return m;
}

/* Twice the area of the polygon of control points. */
static double turning(xmlNodePtr contour)
{
    int n;
    double sum = 0, *p = numbers(find(contour->children, "NurbsCurve2D"),
                                 "controlPoint", &n);

    for (int i = 0; i + 3 < n; i += 2)
        sum += p[i] * p[i + 3] - p[i + 2] * p[i + 1];
    free(p);
    return sum;
}

/* Law: whichever way loops run, outer ones come out counter-clockwise, holes
 * clockwise, islands in holes counter-clockwise. */
static void test_loops(void **state)
{
    const ix_dir dirs[2] = {{IX_BEZIER, 2, 2, false, NULL},
                            {IX_BEZIER, 2, 2, false, NULL}};
    const double flat[] = {0, 1, 0, 1, 0, 0, 1, 1};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int way = 0; way < 8; way++) {
        ix_mv *srf;
        ix_trimsrf *t;
        ix_obj *o;
        xmlDocPtr doc;
        xmlNodePtr at;

        ASSERT_OK(ctx, ix_mv_new(ctx, 2, dirs, 2, false, flat, &srf));
        t = ix__trimsrf_new(ctx, srf, 3);
        ix_mv_unref(ctx, srf);
        for (int i = 0; i < 3; i++) {
            ASSERT_OK(ctx, ix__trimloop_segs(ctx, &t->loop[i], 1));
            t->loop[i].seg[0].uv = square(ctx, 0.1 * (i + 1), 1 - 0.1 * (i + 1),
                                          way >> i & 1);
        }
        o = ix__obj_trimsrf(ctx, t);
        doc = write_scene(ctx, o);
        at = find(xmlDocGetRootElement(doc), "Contour2D");
        for (int i = 0; i < 3; i++) {
            assert_true((turning(at) > 0) == (i != 1));
            at = i < 2 ? find(at->next, "Contour2D") : at;
        }
        xmlFreeDoc(doc);
        ix__obj_unref(ctx, o);
    }
    ix_ctx_free(ctx);
}

/* --- the rest ----------------------------------------------------------- */

/* Names are unique and legal; colours: rgb wins over color, lists hand down. */
static void test_scene(void **state)
{
    static const double at[3] = {1, 2, 3};
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_obj *list = ix__obj_list(ctx), *o[3];
    xmlDocPtr doc;
    xmlNodePtr node;
    double *v;
    int n;

    (void)state;
    ASSERT_OK(ctx, ix__attr_set_int(ctx, &list->attrs, "Color", 4));
    for (int i = 0; i < 3; i++) {
        o[i] = ix__obj_point(ctx, at);
        ASSERT_OK(ctx, ix__obj_set_name(ctx, o[i], "1 \"P\""));
        ASSERT_OK(ctx, ix__obj_append(ctx, list, o[i]));
    }
    ASSERT_OK(ctx, ix__attr_set_int(ctx, &o[1]->attrs, "color", 1));
    ASSERT_OK(ctx, ix__attr_set_string(ctx, &o[1]->attrs, "RGB", "0, 255,51"));
    doc = write_scene(ctx, list);
    node = find(xmlDocGetRootElement(doc), "Shape");
    for (int i = 0; i < 3; i++) {
        static const char *const names[] = {"_1__P_", "_1__P__1", "_1__P__2"};
        char *def = (char *)xmlGetProp(node, (const xmlChar *)"DEF");

        assert_string_equal(def, names[i]);
        xmlFree(def);
        v = numbers(find(node->children, "Material"), "emissiveColor", &n);
        assert_true(v[0] == (i != 1) && v[1] == (i == 1));
        assert_true(v[2] == (i == 1 ? 51 / 255.0 : 0));
        free(v);
        node = node->next ? find(node->next, "Shape") : NULL;
    }
    xmlFreeDoc(doc);
    for (int i = 0; i < 3; i++)
        ix__obj_unref(ctx, o[i]);
    ix__obj_unref(ctx, list);
    ix_ctx_free(ctx);
}

/* Faces, lines, strips: indices and counts add up to the points. */
static void test_polygons(void **state)
{
    ix_rng r = ix_rng_new(0x3d3);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int i = 0; i < 40; i++) {
        ix_obj *o = ix_rand_obj_of(ctx, &r, IX_OBJ_POLY, 0);
        xmlDocPtr doc = write_scene(ctx, o);
        xmlNodePtr node = find(xmlDocGetRootElement(doc), "LineSet");
        int n, np, sum = 0;

        if (node) {
            double *v = numbers(node, "vertexCount", &n);
            double *p = numbers(find(node->children, "Coordinate"), "point",
                                &np);

            for (int k = 0; k < n; k++)
                sum += (int)v[k];
            assert_int_equal(3 * sum, np);
            free(v), free(p);
        }
        xmlFreeDoc(doc);
        ix__obj_unref(ctx, o);
    }
    ix_ctx_free(ctx);
}

/* Anything at all comes out well-formed. */
static void test_random(void **state)
{
    ix_rng r = ix_rng_new(0x3d4);
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);

    (void)state;
    for (int i = 0; i < 60; i++) {
        ix_obj *o = ix_rand_obj(ctx, &r, 2);
        ix_buf b;
        ix_status st;
        xmlDocPtr doc;

        ix__buf_init(&b, ctx);
        st = ix__x3d_write(&b, o, NULL);
        if (st != IX_OK && st != IX_EDOMAIN) /* overflow of wild numbers */
            fail_msg("%s", ix_ctx_message(ctx));
        doc = st == IX_OK ? xmlReadMemory(b.data, (int)b.len, "scene", NULL,
                                          XML_PARSE_NONET)
                          : NULL;
        assert_true((doc != NULL) == (st == IX_OK));
        xmlFreeDoc(doc);
        ix__buf_free(&b);
        ix__obj_unref(ctx, o);
    }
    ix_ctx_free(ctx);
}

/* --- memory ------------------------------------------------------------- */

typedef struct {
    ix_obj_type type;
    ix_obj *in;
} fault_state;

static void fault_setup(ix_ctx *ctx, void *state)
{
    fault_state *s = state;
    ix_rng r = ix_rng_new(11 + (uint64_t)s->type);

    s->in = ix_rand_obj_of(ctx, &r, s->type, 1);
    assert_non_null(s->in);
}

static void fault_teardown(ix_ctx *ctx, void *state)
{
    ix__obj_unref(ctx, ((fault_state *)state)->in);
}

static ix_status run_write(ix_ctx *ctx, void *state)
{
    ix_buf b;
    ix_status st;

    ix__buf_init(&b, ctx);
    st = ix__x3d_write(&b, ((fault_state *)state)->in, NULL);
    ix__buf_free(&b);
    return st == IX_EDOMAIN ? IX_OK : st;
}

static void test_faults(void **state)
{
    (void)state;
    for (int t = IX_OBJ_POLY; t <= IX_OBJ_MULTIVAR; t++) {
        fault_state s = {.type = (ix_obj_type)t};
        ix_fault_case c = {fault_setup, run_write, fault_teardown, &s};

        assert_true(ix_fault_run(&c) > 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_freeforms),     cmocka_unit_test(test_poles),
        cmocka_unit_test(test_approximation), cmocka_unit_test(test_loops),
        cmocka_unit_test(test_scene),         cmocka_unit_test(test_polygons),
        cmocka_unit_test(test_random),        cmocka_unit_test(test_faults)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
