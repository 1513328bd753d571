/* The degrees and numbers of control points of all operators on curves, in all
 * forms, as docs/ops and design tables have them; and that their reports are
 * small for curves where every value is well conditioned. */
#include <limits.h>
#include <string.h>

#include "crv_test.h"
#include "mv/mv.h"
#include "ops/table.h"

/* Degree a d + b of each form (minimal, published, naive, irit), for curves of
 * degree from on; at least d if it contains the curve itself. The result
 * contains derivs derivatives of the curve, which tells its continuity. */
typedef struct {
    const char *op;
    int ncoords, from, derivs;
    bool curve_in_it;
    int poly[4][2], rat[4][2];
} row;

static const row rows[] = {
    {"CINFLECT",
     2,
     2,
     2,
     false,
     {{2, -4}, {2, -3}, {2, -3}, {2, -3}},
     {{3, -6}, {3, -3}, {6, 0}, {6, 0}}},
    {"CCRVTR",
     2,
     2,
     3,
     false,
     {{4, -7}, {4, -6}, {12, -12}, {16, -16}},
     {{8, -12}, {9, -6}, {48, 0}, {64, 0}}},
    {"CCRVTR",
     3,
     2,
     3,
     false,
     {{6, -11}, {6, -9}, {12, -12}, {16, -16}},
     {{11, -18}, {13, -9}, {48, 0}, {64, 0}}},
    {"CCRVTRDIRECT",
     2,
     3,
     3,
     false,
     {{0, 0}, {0, 0}, {4, -6}},
     {{0, 0}, {0, 0}, {26, 0}}},
    {"CCRVTRDIRECT",
     3,
     3,
     3,
     false,
     {{0, 0}, {0, 0}, {6, -9}},
     {{0, 0}, {0, 0}, {38, 0}}},
    {"CCRVTRSQR",
     2,
     2,
     2,
     false,
     {{6, -6}, {6, -6}, {6, -6}, {6, -6}},
     {{12, -12}, {12, -6}, {24, 0}, {24, 0}}},
    {"CCRVTRSQR",
     3,
     2,
     2,
     false,
     {{6, -6}, {6, -6}, {6, -6}, {6, -6}},
     {{12, -12}, {12, -6}, {24, 0}, {24, 0}}},
    {"CTORSIONZERO",
     3,
     3,
     3,
     false,
     {{3, -9}, {3, -6}, {3, -6}},
     {{4, -12}, {6, -6}, {14, 0}}},
    {"CTORSION",
     3,
     3,
     3,
     false,
     {{4, -8}, {4, -6}, {4, -6}},
     {{6, -12}, {8, -6}, {26, 0}}},
    {"CNRMLCRV",
     3,
     2,
     2,
     false,
     {{4, -4}, {4, -4}, {4, -4}, {4, -4}},
     {{8, -8}, {8, -4}, {16, 0}, {16, 0}}},
    {"EVOLUTE",
     2,
     2,
     2,
     false,
     {{3, -3}, {3, -3}, {3, -3}, {6, -6}},
     {{6, -6}, {6, -3}, {13, 0}, {25, 0}}},
    {"EVOLUTE",
     3,
     2,
     2,
     false,
     {{5, -7}, {5, -6}, {5, -6}, {6, -6}},
     {{9, -12}, {10, -6}, {25, 0}, {25, 0}}},
    {"FOCALCRV",
     3,
     3,
     3,
     false,
     {{4, -7}, {4, -6}, {4, -6}},
     {{8, -12}, {9, -6}, {41, 0}}},
    {"FOCALSRF",
     3,
     3,
     2,
     false,
     {{3, -3}, {6, -9}, {6, -9}},
     {{6, -6}, {12, -6}, {31, 0}}},
    {"TANDEVSRF",
     3,
     2,
     1,
     true,
     {{1, 0}, {1, 0}, {1, 0}},
     {{2, -2}, {2, -1}, {3, 0}}},
    {"NRMLSCROLL",
     3,
     2,
     2,
     true,
     {{3, -5}, {3, -4}, {3, -4}},
     {{5, -8}, {6, -4}, {9, 0}}},
    {"BINRMLSCROLL",
     3,
     2,
     2,
     true,
     {{2, -4}, {2, -3}, {2, -3}},
     {{3, -6}, {4, -3}, {7, 0}}},
    {"RECTDEVSRF",
     3,
     3,
     3,
     true,
     {{6, -12}, {7, -8}, {7, -8}},
     {{10, -18}, {13, -8}, {39, 0}}},
};

/* n = degree + 1 + sum of multiplicities, degree - c of an inner knot: c is
 * the continuity of the curve, degree - 1 at its simple knots, less the
 * derivatives; IRIT keeps C0 at most, -1 is a jump. */
static int points(const row *r, const crv_kind *k, int form, int degree)
{
    int c = k->degree - 1 - r->derivs;

    c = c < -1 ? -1 : c;
    if (form == 3 && c > 0)
        c = 0;
    return degree + 1 +
           (k->spans ? k->spans - 1 : 0) * (degree > c ? degree - c : 0);
}

static void check_form(ix_ctx *ctx, const row *r, const crv_kind *k,
                       const ix_mv *c, int form)
{
    const ix_op *op = ix__op_find(r->op);
    ix_op_args a = {.mv = {c}, .num = {-0.5, 0.5}};
    ix_op_opts o = {(ix_degree_form)form, INT_MAX};
    const int *f = k->rational ? r->rat[form] : r->poly[form];
    int want = at_least_0(f[0] * k->degree + f[1]);
    ix_report rep;
    ix_mv *m;

    if (!(op->forms >> form & 1))
        return;
    if (r->curve_in_it && want < k->degree)
        want = k->degree;
    ASSERT_OK(ctx, op->run(ctx, &a, &o, &rep, &m));
    if (degree_of(m, 0) != want)
        fail_msg("%s form %d degree %d rational %d in %d coordinates: %d, not "
                 "%d",
                 r->op, form, k->degree, k->rational, k->ncoords,
                 degree_of(m, 0), want);
    if (ix_mv_length(m, 0) != points(r, k, form, want))
        fail_msg("%s form %d degree %d rational %d in %d coordinates, %d "
                 "spans: %d points, not %d",
                 r->op, form, k->degree, k->rational, k->ncoords, k->spans,
                 ix_mv_length(m, 0), points(r, k, form, want));
    if (!(rep.residual <= 1e-10))
        fail_msg("%s form %d degree %d rational %d in %d coordinates, %d "
                 "spans: residual %g",
                 r->op, form, k->degree, k->rational, k->ncoords, k->spans,
                 rep.residual);
    ix_mv_unref(ctx, m);
}

/* Law: the tables' degrees exactly, for curves of degree 2 to 6, Bezier and
 * B-spline; what the reports say is within the bound of the project. */
static void whole_table(void **state)
{
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    ix_rng rng = ix_rng_new(58);

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (int d = rows[i].from; d <= 6; d++)
            for (int q = 0; q < 4; q++) {
                crv_kind k = {.degree = d,
                              .ncoords = rows[i].ncoords,
                              .rational = q & 1,
                              .spans = q & 2 ? 3 : 0};
                ix_mv *c = gentle_crv(ctx, &rng, &k);

                for (int form = 0; form < 4; form++)
                    check_form(ctx, &rows[i], &k, c, form);
                ix_mv_unref(ctx, c);
            }
    ix_ctx_free(ctx);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(whole_table)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
