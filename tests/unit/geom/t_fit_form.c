/* t_fit_form.c - polynomials in two variables near data: what is such a
 * polynomial comes back, what is not is as near as can be. */
#include "iritx/geom_srf.h"
#include "unit/geom/geomtest.h"

enum { N = 60 };

typedef struct {
    double uv[2][N], val[2][N];
} data;

static ix_form_data wrap(const data *d, ix_form_kind kind, bool centred)
{
    return (ix_form_data){kind, centred, N, d->uv[0], 2, d->val[0]};
}

/* Parameters around (100, -3), so that centring matters. */
static void scatter(ix_rng *r, data *d)
{
    for (int i = 0; i < N; i++) {
        d->uv[0][i] = 100 + ix_rng_range(r, -2, 2);
        d->uv[1][i] = -3 + ix_rng_range(r, -1, 1);
    }
}

/* Law: data on a form give its values everywhere, about the mean to rounding,
 * about the origin to what (100 / 2)^degree leaves of the digits. */
static void forms_come_back(void **state)
{
    gt t = gt_begin(71);
    data d;

    (void)state;
    for (int kind = IX_FORM_LINEAR; kind <= IX_FORM_BICUBIC; kind++)
        for (int centred = 0; centred < 2; centred++) {
            double coef[2][16], got[2][16], mid[2] = {100, -3}, at[2], tol;
            int power[IX_FORM_MOST][2];
            int n = ix_form_terms((ix_form_kind)kind, power);
            double center[2];
            ix_fit_error err;
            ix_form_data f;

            scatter(&t.r, &d);
            for (int k = 0; k < 2 * n; k++)
                coef[k / n][k % n] = ix_rng_range(&t.r, -1, 1);
            for (int i = 0; i < N; i++)
                for (int c = 0; c < 2; c++)
                    d.val[c][i] = ix_form_value(
                        (ix_form_kind)kind, coef[c], mid,
                        (const double[2]){d.uv[0][i], d.uv[1][i]});
            f = wrap(&d, (ix_form_kind)kind, centred);
            ASSERT_OK(t.ctx, ix_fit_form(t.ctx, &f, center, &err,
                                         got[0])); /* [2][n], packed */
            assert_true(err.largest <= 1e-12);
            assert_true(err.rms <= err.largest);
            tol = centred ? 1e-11 : 1e-15 * pow(100, power[n - 1][0] + 3);
            for (int i = 0; i < 10; i++) {
                at[0] = 100 + ix_rng_range(&t.r, -2, 2);
                at[1] = -3 + ix_rng_range(&t.r, -1, 1);
                for (int c = 0; c < 2; c++)
                    ASSERT_CLOSE(
                        ix_form_value((ix_form_kind)kind, got[0] + c * n,
                                      center, at),
                        ix_form_value((ix_form_kind)kind, coef[c], mid, at),
                        tol);
            }
        }
    gt_end(&t);
}

/* Law: residuals are orthogonal to every term of the form, and the error told
 * is theirs. */
static void least_squares(void **state)
{
    gt t = gt_begin(72);
    data d;

    (void)state;
    for (int kind = IX_FORM_LINEAR; kind <= IX_FORM_BICUBIC; kind++) {
        int power[IX_FORM_MOST][2];
        int n = ix_form_terms((ix_form_kind)kind, power);
        double coef[32], center[2], sum = 0, dot[16] = {0};
        ix_fit_error err;
        ix_form_data f;

        scatter(&t.r, &d);
        for (int i = 0; i < 2 * N; i++)
            d.val[i / N][i % N] = ix_rng_range(&t.r, -1, 1);
        f = wrap(&d, (ix_form_kind)kind, true);
        ASSERT_OK(t.ctx, ix_fit_form(t.ctx, &f, center, &err, coef));
        for (int i = 0; i < N; i++) {
            double at[2] = {d.uv[0][i], d.uv[1][i]}, far = 0;

            for (int c = 0; c < 2; c++) {
                double gap = d.val[c][i] - ix_form_value((ix_form_kind)kind,
                                                         coef + c * n, center,
                                                         at);

                far += gap * gap;
                for (int k = 0; k < n && c == 0; k++)
                    dot[k] += gap * pow(at[0] - center[0], power[k][0]) *
                              pow(at[1] - center[1], power[k][1]);
            }
            sum += far;
            assert_true(sqrt(far) <= err.largest * (1 + 1e-12));
        }
        ASSERT_CLOSE(sqrt(sum / N), err.rms, 1e-12);
        for (int k = 0; k < n; k++)
            ASSERT_CLOSE(dot[k], 0, 1e-11);
    }
    gt_end(&t);
}

static void errors(void **state)
{
    const double one[2] = {0, 0};
    double coef[32], center[2];
    gt t = gt_begin(73);
    ix_form_data f;
    data d;

    (void)state;
    scatter(&t.r, &d);
    f = wrap(&d, (ix_form_kind)0, false);
    assert_int_equal(ix_fit_form(t.ctx, &f, center, NULL, coef), IX_EARG);
    f = wrap(&d, (ix_form_kind)7, false);
    assert_int_equal(ix_fit_form(t.ctx, &f, center, NULL, coef), IX_EARG);
    f = (ix_form_data){IX_FORM_LINEAR, false, 1, one, 1, one};
    assert_int_equal(ix_fit_form(t.ctx, &f, center, NULL, coef), IX_EARG);
    for (int i = 0; i < N; i++) { /* on a circle: u^2 + v^2 = 1 */
        d.uv[0][i] = cos(i);
        d.uv[1][i] = sin(i);
        d.val[0][i] = d.val[1][i] = i;
    }
    f = wrap(&d, IX_FORM_QUADRATIC, true);
    assert_int_equal(ix_fit_form(t.ctx, &f, center, NULL, coef), IX_EDOMAIN);
    f.kind = IX_FORM_BILINEAR;
    ASSERT_OK(t.ctx, ix_fit_form(t.ctx, &f, center, NULL, coef));
    d.uv[1][3] = NAN;
    assert_int_equal(ix_fit_form(t.ctx, &f, center, NULL, coef), IX_EARG);
    gt_end(&t);
}

static void nothing(ix_ctx *ctx, void *state)
{
    (void)ctx;
    (void)state;
}

static ix_status run(ix_ctx *ctx, void *state)
{
    const double uv[8] = {0, 1, 0, 1, 0, 0, 1, 1}, v[4] = {1, 2, 3, 4};
    const ix_form_data f = {IX_FORM_BILINEAR, true, 4, uv, 1, v};
    double coef[4], center[2];

    (void)state;
    return ix_fit_form(ctx, &f, center, NULL, coef);
}

static void out_of_memory(void **state)
{
    const ix_fault_case c = {nothing, run, nothing, NULL};

    (void)state;
    assert_true(ix_fault_run(&c) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forms_come_back),
        cmocka_unit_test(least_squares),
        cmocka_unit_test(errors),
        cmocka_unit_test(out_of_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
