/* Silhouettes and shadows for all views, against their definition: equations at
 * every vertex, and for single directions all of them by dense sampling. */
#include <math.h>
#include <stdlib.h>

#include "base/ctx.h"
#include "geomtest.h"
#include "iritx/visible.h"

enum { DENSE = 2000, MOST = 64 };

static ix_mv *blob(gt *t, bool rational)
{
    int n = 10, order = 4;
    double pts[3 * 10], knots[14];

    for (int i = 0; i < n; i++) {
        double w = rational ? ix_rng_range(&t->r, 0.7, 1.4) : 1;
        double a = 2 * 3.14159265358979 * (i % 9) / 9;
        double r = ix_rng_range(&t->r, 0.3, 1.5);

        if (rational)
            pts[i] = i == 9 ? pts[0] : w;
        for (int k = 0; k < 2; k++)
            pts[i + (k + rational) * n] = i == 9
                                              ? pts[(k + rational) * n]
                                              : w * r * (k ? sin(a) : cos(a));
    }
    ASSERT_OK(t->ctx, ix_knots_make(t->ctx, IX_KV_OPEN, order, n, knots));
    return gt_curve(t, order, n, knots, 2, rational, pts);
}

static ix_mv *views(gt *t)
{
    const double zero[3] = {0, 0, 0};
    ix_mv *v;

    ASSERT_OK(t->ctx, ix_pcircle(t->ctx, zero, 1, &v));
    return v;
}

/* Law: V(v) x C'(t) = 0 and V(v) x (C(r) - C(t)) = 0. Ends, and places
 * where the chord vanishes as at the seam, are singular: known to a box of 1e-6
 * of the domain. */
static void check_vertices(gt *t, const ix_mv *c, const ix_mv *view,
                           const ix_lines *l, int *silhouettes, int *shadows)
{
    double(*p)[3] = l->pt;

    for (int i = 0; i < l->n; i++)
        for (int k = 0; k < l->count[i]; k++, p++) {
            double v[IX_MAX_COORDS], a[IX_MAX_COORDS], b[IX_MAX_COORDS], d[3];
            double tol = k == 0 || k == l->count[i] - 1 ? 1e-5 : 1e-9;

            gt_point(t, view, &(*p)[1], v);
            gt_point(t, c, &(*p)[0], a);
            gt_point(t, c, &(*p)[2], b);
            ASSERT_OK(t->ctx, ix_tangent(t->ctx, c, (*p)[0], false, d));
            if ((*p)[0] != (*p)[2] && hypot(b[0] - a[0], b[1] - a[1]) < 1e-5)
                tol = 1e-5;
            assert_true(fabs(v[0] * d[1] - v[1] * d[0]) < tol);
            assert_true(fabs(v[0] * (b[1] - a[1]) - v[1] * (b[0] - a[0])) <
                        tol);
            if ((*p)[0] < (*p)[2] || (*p)[0] > (*p)[2])
                ++*shadows;
            else
                ++*silhouettes;
        }
}

/* How many lines pass the direction number v, with r = t (or not). */
static int passes(const ix_lines *l, double v, bool shadows)
{
    double(*p)[3] = l->pt;
    int n = 0;

    for (int i = 0; i < l->n; p += l->count[i], i++) {
        bool own = p[0][2] < p[0][0] || p[0][2] > p[0][0];

        for (int k = 0; own == shadows && k + 1 < l->count[i]; k++)
            n += (p[k][1] < v) != (p[k + 1][1] < v);
    }
    return n;
}

typedef struct {
    gt *t;
    double (*p)[2];
    double v[2];
    int sil[MOST], n, all, seen, shadows, seen_shadows;
} truth;

/* Where the line of sight through sample s crosses the polygon: distances
 * towards the viewer. */
static int line_hits(const truth *w, int s, double *along)
{
    int n = 0;

    for (int i = 0; i < DENSE; i++) {
        double a = (w->p[i][0] - w->p[s][0]) * w->v[1] -
                   (w->p[i][1] - w->p[s][1]) * w->v[0];
        double b = (w->p[i + 1][0] - w->p[s][0]) * w->v[1] -
                   (w->p[i + 1][1] - w->p[s][1]) * w->v[0];
        double u = a / (a - b), x[2];

        if ((a < 0) == (b < 0))
            continue;
        for (int k = 0; k < 2; k++)
            x[k] = w->p[i][k] + u * (w->p[i + 1][k] - w->p[i][k]) - w->p[s][k];
        x[0] = x[0] * w->v[0] + x[1] * w->v[1];
        if (fabs(x[0]) > 0.05 && n < MOST) /* else the contact itself */
            along[n++] = x[0];
    }
    return n;
}

/* Counts for one direction, by samples. */
static void count_truth(truth *w)
{
    for (int i = 1; i < DENSE; i++) {
        double before = (w->p[i][0] - w->p[i - 1][0]) * w->v[1] -
                        (w->p[i][1] - w->p[i - 1][1]) * w->v[0];
        double after = (w->p[i + 1][0] - w->p[i][0]) * w->v[1] -
                       (w->p[i + 1][1] - w->p[i][1]) * w->v[0];
        double hit[MOST], nearest = -HUGE_VAL;
        bool hidden = false;
        int n;

        if ((before < 0) == (after < 0))
            continue;
        n = line_hits(w, i, hit);
        for (int k = 0; k < n; k++) {
            hidden = hidden || hit[k] > 0;
            if (hit[k] < 0)
                nearest = fmax(nearest, hit[k]);
        }
        w->all++;
        w->shadows += n;
        w->seen += !hidden;
        w->seen_shadows += !hidden && nearest > -HUGE_VAL;
    }
}

static void samples(gt *t, const ix_mv *c, double (*p)[2])
{
    double dom[2], x[IX_MAX_COORDS];

    ix_mv_domain(c, 0, dom);
    for (int i = 0; i <= DENSE; i++) {
        double u = i == DENSE ? dom[1] : dom[0] + (dom[1] - dom[0]) * i / DENSE;

        gt_point(t, c, &u, x);
        p[i][0] = x[0];
        p[i][1] = x[1];
    }
}

/* Law: each direction meets as many lines as sampling finds silhouettes and
 * shadows; places within 0.05 of an event, which samples cannot tell, are few:
 * of 100 directions at least 85 must agree in all four numbers. */
static void as_sampled(void **state)
{
    static double p[DENSE + 1][2];
    gt t = gt_begin(1);
    int same = 0, sil = 0, sha = 0, visible = 0;

    (void)state;
    for (int k = 0; k < 4; k++) {
        ix_mv *c = blob(&t, k % 2), *view = views(&t);
        ix_lines all, seen;

        ASSERT_OK(t.ctx, ix_crv_view_map(t.ctx, c, view, false, 1e-3, &all));
        ASSERT_OK(t.ctx, ix_crv_view_map(t.ctx, c, view, true, 1e-3, &seen));
        check_vertices(&t, c, view, &all, &sil, &sha);
        check_vertices(&t, c, view, &seen, &visible, &visible);
        samples(&t, c, p);
        for (int i = 0; i < 25; i++) {
            double v = 4 * (i + 0.317) / 25, x[IX_MAX_COORDS];
            truth w = {.t = &t, .p = p};

            gt_point(&t, view, &v, x);
            w.v[0] = x[0] / hypot(x[0], x[1]);
            w.v[1] = x[1] / hypot(x[0], x[1]);
            count_truth(&w);
            same += passes(&all, v, false) == w.all &&
                    passes(&all, v, true) == w.shadows &&
                    passes(&seen, v, false) == w.seen &&
                    passes(&seen, v, true) == w.seen_shadows;
        }
        ix_lines_free(t.ctx, &all);
        ix_lines_free(t.ctx, &seen);
        ix_mv_unref(t.ctx, c);
        ix_mv_unref(t.ctx, view);
    }
    assert_true(sil > 200 && sha > 200 && visible > 200);
    if (same < 85)
        fail_msg("%d of 100 directions agree", same);
    gt_end(&t);
}

/* A circle: two silhouettes for every view, no shadow. */
static void a_circle(void **state)
{
    const double zero[3] = {0, 0, 0};
    gt t = gt_begin(2);
    ix_mv *c, *view = views(&t);
    ix_lines l;

    (void)state;
    ASSERT_OK(t.ctx, ix_circle(t.ctx, zero, 2, &c));
    ASSERT_OK(t.ctx, ix_crv_view_map(t.ctx, c, view, true, 1e-3, &l));
    for (int i = 0; i < 16; i++) {
        assert_int_equal(passes(&l, 4 * (i + 0.4) / 16, false), 2);
        assert_int_equal(passes(&l, 4 * (i + 0.4) / 16, true), 0);
    }
    ix_lines_free(t.ctx, &l);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, view);
    gt_end(&t);
}

static void errors(void **state)
{
    const double line[4] = {0, 1, 0, 1}, pole[6] = {1, -1, 0, -1, 0, 0};
    gt t = gt_begin(3);
    ix_mv *c = gt_curve(&t, 2, 2, NULL, 2, false, line);
    ix_mv *p = gt_curve(&t, 2, 2, NULL, 2, true, pole);
    ix_mv *s = gt_curve(&t, 2, 2, NULL, 1, false, line);
    ix_lines l;

    (void)state;
    assert_int_equal(ix_crv_view_map(t.ctx, s, c, false, 0, &l), IX_EARG);
    assert_int_equal(ix_crv_view_map(t.ctx, c, s, false, 0, &l), IX_EARG);
    assert_int_equal(ix_crv_view_map(t.ctx, p, c, false, 0, &l), IX_EDOMAIN);
    assert_int_equal(ix_crv_view_map(t.ctx, c, p, false, 0, &l), IX_EDOMAIN);
    assert_int_equal(l.n, 0);
    ix_mv_unref(t.ctx, c);
    ix_mv_unref(t.ctx, p);
    ix_mv_unref(t.ctx, s);
    gt_end(&t);
}

static void make(ix_ctx *ctx, ix_build_case *f)
{
    const double p[8] = {0, 1, 2, 3, 0, 2, -2, 1}, v[6] = {1, 1, -1, 0, 1, 0.5};
    const ix_dir d[2] = {{.basis = IX_BEZIER, .order = 4, .length = 4},
                         {.basis = IX_BEZIER, .order = 3, .length = 3}};

    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d[0], 2, false, p, &f->in[0]));
    ASSERT_OK(ctx, ix_mv_new(ctx, 1, &d[1], 2, false, v, &f->in[1]));
}

static ix_status build(ix_ctx *ctx, const ix_build_case *f, ix_mv **out)
{
    ix_lines l;

    IX_TRY(ix_crv_view_map(ctx, f->in[0], f->in[1], true, 0.1, &l));
    ix_lines_free(ctx, &l);
    *out = ix_mv_ref(f->in[0]);
    return IX_OK;
}

static void memory(void **state)
{
    (void)state;
    ix_build_faults(&(ix_build_case){.make = make, .build = build});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_sampled),
        cmocka_unit_test(a_circle),
        cmocka_unit_test(errors),
        cmocka_unit_test(memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
