/* The degrees of bisectors in all forms (the fields of planar curves:
 * t_cbisector2d), polynomial and rational, as the
 * headers and pages have them; and that all forms are one geometry. */
#include <limits.h>
#include <math.h>
#include <string.h>

#include "geom/vec3.h"
#include "harness/randmv.h"
#include "iritx/ops_bisect.h"

IX_TEST_FIXTURE(8901)

enum { POINT2D, PLANES, DIRECTRIX, CURVES, SECTOR, SURFACE, SPHERE };

/* a d + b, or the larger of it and c d + e. */
typedef struct {
    int a, b, c, e;
} degree;

#define D(a, b)    \
    {              \
        a, b, 0, 0 \
    }

static const struct {
    const char *name;
    int op, ncoords;
    degree poly[4], rat[4]; /* minimal, published, naive, irit */
} table[] = {
    {"point and planar curve",
     POINT2D,
     2,
     {D(3, -1), D(3, -1), D(3, -1), D(3, -1)},
     {D(4, -2), D(4, -1), D(8, 0), D(5, 0)}},
    {"point and curve, planes",
     PLANES,
     3,
     {D(3, -1), D(3, -1), D(7, -3), D(7, -3)},
     {D(4, -2), D(4, -1), D(17, 0), D(12, 0)}},
    {"point and curve, directrix",
     DIRECTRIX,
     3,
     {{5, -3, 6, -6}, D(7, -3), D(7, -3), D(7, -3)},
     {D(6, -4), D(10, -3), D(17, 0), D(12, 0)}},
    {"two curves",
     CURVES,
     3,
     {D(3, -1), D(3, -1), D(3, -1), D(3, -1)},
     {D(4, -2), D(4, -1), D(6, -2), D(5, 0)}},
    {"sector of two curves",
     SECTOR,
     3,
     {D(3, -1), D(3, -1), D(3, -1), D(3, -1)},
     {D(4, -2), D(4, -1), D(6, -2), D(5, 0)}},
    {"point and surface",
     SURFACE,
     3,
     {D(4, -1), D(4, -1), D(4, -1), D(4, -1)},
     {D(5, -2), D(5, -2), D(8, 0), D(8, 0)}},
    {"point and curve on the sphere",
     SPHERE,
     3,
     {D(2, -2), D(2, -2), D(2, -2), D(2, -2)},
     {D(2, -2), D(2, -2), D(2, -2), D(2, -2)}},
};

static int value(const degree *d, int n)
{
    int x = d->a * n + d->b, y = d->c * n + d->e;

    return x > y || d->c == 0 ? x : y;
}

static ix_mv *freeform(int ndirs, int ncoords, bool rational, int d, double z)
{
    const ix_dir dir[2] = {{IX_BEZIER, d + 1, d + 1, false, NULL},
                           {IX_BEZIER, d + 1, d + 1, false, NULL}};
    size_t m = (size_t)d + 1, n = ndirs == 2 ? m * m : m;
    double p[4 * 36];
    ix_mv *out;

    for (size_t i = 0; i < n; i++) {
        double w = rational ? ix_rng_range(&rng, 0.6, 1.6) : 1;

        p[i] = w;
        for (size_t k = 0; k < (size_t)ncoords; k++)
            p[(k + rational) * n + i] = w * (ix_rng_range(&rng, -0.5, 0.5) +
                                             (k == 2 ? z : 0) +
                                             (k == 0   ? (double)(i % m)
                                              : k == 1 ? (double)(i / m)
                                                       : 0));
    }
    ASSERT_OK(ctx, ix_mv_new(ctx, ndirs, dir, ncoords, rational, p, &out));
    return out;
}

static ix_mv *result(int op, const ix_mv *a, const ix_mv *b,
                     const ix_op_opts *o)
{
    const double q[3] = {0.3, -0.7, 2.1};
    const ix_ruling directrix = {IX_RULING_DIRECTRIX, {-1, 1}, {0, 0, 0}},
                    planes = {IX_RULING_PLANES, {-1, 1}, {0, 0.3, 1}};
    ix_mv *m = NULL;

    switch (op) {
    case POINT2D:
        ASSERT_OK(ctx, ix_pt_crv_bisector(ctx, a, q, 0.5, o, NULL, &m));
        break;
    case PLANES:
    case DIRECTRIX:
        ASSERT_OK(ctx, ix_pt_crv_bisector3d(ctx, a, q, 0.5,
                                            op == PLANES ? &planes : &directrix,
                                            o, NULL, &m));
        break;
    case CURVES:
        ASSERT_OK(ctx, ix_cbisector3d(ctx, a, b, o, NULL, &m));
        break;
    case SECTOR:
        ASSERT_OK(ctx, ix_calphasector3d(ctx, a, b, 0.3, o, NULL, &m));
        break;
    case SURFACE:
        ASSERT_OK(ctx, ix_pt_srf_bisector(ctx, a, q, o, NULL, &m));
        break;
    default:
        ASSERT_OK(ctx, ix_sphere_bisector_point(ctx, a, q, o, &m));
    }
    return m;
}

/* The degree in direction 0 is that of the table. */
static void degrees(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        for (int rational = 0; rational < 2; rational++)
            for (int d = 2; d <= 4; d++) {
                ix_mv *a = freeform(1 + (table[i].op == SURFACE),
                                    table[i].ncoords, rational, d, 0);
                ix_mv *b = freeform(1, 3, rational, 2, 3);

                for (int form = 0; form < 4; form++) {
                    const ix_op_opts o = {(ix_degree_form)form, INT_MAX};
                    const degree *w = rational ? table[i].rat : table[i].poly;
                    ix_mv *m = result(table[i].op, a, b, &o);

                    if (ix_mv_order(m, 0) - 1 != value(&w[form], d))
                        fail_msg("%s, form %d, degree %d%s: %d, not %d",
                                 table[i].name, form, d,
                                 rational ? " rational" : "",
                                 ix_mv_order(m, 0) - 1, value(&w[form], d));
                    ix_mv_unref(ctx, m);
                }
                ix_mv_unref(ctx, a);
                ix_mv_unref(ctx, b);
            }
}

/* Law: the forms of one operator have the same points (1e-9 away from poles:
 * the naive ones have the condition of their factors); the ruled ones the same
 * rulings. */
static void one_geometry(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        ix_mv *a = freeform(1 + (table[i].op == SURFACE), table[i].ncoords,
                            true, 2, 0),
              *b = freeform(1, 3, true, 2, 3), *m[4];

        for (int form = 0; form < 4; form++) {
            const ix_op_opts o = {(ix_degree_form)form, INT_MAX};

            m[form] = result(table[i].op, a, b, &o);
        }
        for (int j = 0; j < 9; j++) {
            double t[2] = {(j + 0.4) / 9, j % 3 * 0.5}, x[4][3] = {{0}}, far;
            bool ruled = table[i].op == PLANES || table[i].op == DIRECTRIX;

            for (int form = 0; form < 4; form++)
                ASSERT_OK(ctx, ix_mv_point(ctx, m[form], t, x[form]));
            far = 1 + ix__len3(x[0]);
            for (int form = 1; form < 4 && !ruled && far < 100; form++)
                if (!(ix__dist3(x[0], x[form]) <= 1e-9 * far))
                    fail_msg("%s, form %d: %g", table[i].name, form,
                             ix__dist3(x[0], x[form]));
        }
        for (int form = 0; form < 4; form++)
            ix_mv_unref(ctx, m[form]);
        ix_mv_unref(ctx, a);
        ix_mv_unref(ctx, b);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(degrees),
        cmocka_unit_test(one_geometry),
    };

    return cmocka_run_group_tests(tests, setup, teardown);
}
