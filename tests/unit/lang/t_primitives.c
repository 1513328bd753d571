/* t_primitives.c - the functions of chapters 1 to 6 and of the start-up
 * library with every allocation failing in turn: a message, no value, no
 * block left. Their values are tested by tests/script, but for GETLINE. */
#define _POSIX_C_SOURCE 200809L
#include <string.h>
#include <unistd.h>

#include "harness/fault.h"
#include "harness/test.h"
#include "lang/interp_impl.h"

typedef struct {
    const char *text;
    FILE *nowhere;
    ix_interp *in;
} run_state;

static void open_interp(ix_ctx *ctx, void *state)
{
    static const ix_interp_opts none;
    run_state *s = state;

    ASSERT_OK(ctx, ix__interp_new(ctx, &none, &s->in));
    s->in->out = s->in->err = s->nowhere;
}

static ix_status run_text(ix_ctx *ctx, void *state)
{
    run_state *s = state;
    ix_status st = ix__interp_run_text(s->in, "t", s->text, strlen(s->text));

    (void)ctx;
    if (st != IX_OK)
        return st;
    return ix__interp_errors(s->in) ? IX_ENOMEM : IX_OK; /* a soft one */
}

static void close_interp(ix_ctx *ctx, void *state)
{
    run_state *s = state;

    (void)ctx;
    s->in->out = s->in->err = NULL;
    ix__interp_free(s->in);
}

static void fail_each(const char *text)
{
    run_state s = {.text = text, .nowhere = fopen("/dev/null", "w")};
    ix_fault_case c = {open_interp, run_text, close_interp, &s};

    assert_non_null(s.nowhere);
    if (!(ix_fault_run(&c) > 0))
        fail_msg("no allocation in %s", text);
    (void)fclose(s.nowhere);
}

static void fail_all(const char *const *texts)
{
    for (; *texts; texts++)
        fail_each(*texts);
}

static void test_visible(void **state)
{
    static const char *const texts[] = {
        "c = cbspline(3, list(ctlpt(E2, 0, 0), ctlpt(E2, 2, 0), ctlpt(E2, 1, "
        "1), ctlpt(E2, 2, 2), ctlpt(E2, 0, 2)), list(kv_periodic)); "
        "l = cvisible(c, vector(1, 0, 0), 1);",
        "c = cbspline(3, list(ctlpt(E2, 0, 0), ctlpt(E2, 2, 0), ctlpt(E2, 1, "
        "1), ctlpt(E2, 2, 2), ctlpt(E2, 0, 2)), list(kv_periodic)); "
        "h = cnvxhull(c, 1);",
        "l = canglemap(circle(vector(0, 0, 0), 1), 4, 0, 5); "
        "f = canglemap(circle(vector(0, 0, 0), 1), -1, 40, 5);",
        "c = cbspline(2, list(ctlpt(E2, 0, 0), ctlpt(E2, 1, 4), ctlpt(E2, 2, "
        "0), ctlpt(E2, 1, 1), ctlpt(E2, 0, 0)), list(kv_open)); "
        "h = cnvxhull(c, 1);",
        "a = sbezier(list(list(point(0, 0, 0), point(1, 0, 0)), list(point(0, "
        "1, 0), point(1, 1, 1)))); l = raytraps(list(a, a * tz(2)), 1, 0.1, "
        "-1, 1);",
        "p = circpoly(vector(1, 0, 0), vector(0, 0, 0), 1); "
        "q = cnvxhull(circpoly(vector(0, 0, 1), vector(0, 0, 0), 1), 1);",
        NULL};

    (void)state;
    fail_all(texts);
}

/* Arrangements, tilings, kernels, views: what scripts are given of them. */
static void test_regions(void **state)
{
    static const char *const texts[] = {
        "p = poly(list(point(0, 0, 0), point(2, 0, 0), point(0, 2, 0)), false);"
        " a = carngmnt2(list(p, p * ry(30)), 1, list(0.1, 1, true, 7)); "
        "a = carngmnt2(p * rx(20), 1, list(1e-3, 1e-3, false, 2)); "
        "b = carngmnt2(a, 2, nil()); a = carngmnt2(a, 6, list(10)); "
        "a = carngmnt2(a, 12, nil()); r = carngmnt2(a, 13, list(15)); "
        "l = carngmnt2(a, 14, list(1, 0, 1)); l = carngmnt2(a, 14, list(2, 0, "
        "0)); l = carngmnt2(a, 14, list(3, 0, 1)); "
        "l = carngmnt2(a, 14, list(4, 0.1, 0)); "
        "a = carngmnt2(a, 8, list(list(point(1, 0, 0)), 0.1)); "
        "f = carngmnt2(a, 15, nil());",
        "s = sbezier(list(list(point(0, 0, 0), point(1, 0, 0)), list(point(0, "
        "1, 0), point(1, 1, 1)))); a = carngmnt2(s, 1, list(0.1, 1, true, 4)); "
        "l = svisible(s, 1, 80); o = srfkernel(s, 1, 1);",
        "c = cbezier(list(ctlpt(E2, 0, 0), ctlpt(E2, 1, 2), ctlpt(E2, 2, 0))); "
        "o = moffset(c, 0.1, 90); v = cviewmap(c, c, 1, 1, 0);",
        "c = circle(vector(0, 0, 0), 1); "
        "p = c2rectrgn(list(c), 90, 1, 1, 1); "
        "l = c2rectrgn(list(c), 90, 3, 1, 0);",
        NULL};

    (void)state;
    fail_all(texts);
}

static void test_lists(void **state)
{
    static const char *const texts[] = {
        "l = list(1, \"a\", nil()); snoc(l, l); x = nth(l, 4);",
        "l = list(point(0, 0, 0)); attrib(nref(l, 1), \"k\", 1);",
        "l = list(1); setname(l, 0, \"b\"); n = getname(l, 1);",
        "a = 1; setname(list(a), 0, \"b2\"); x = b2;",
        "p = poly(list(point(0, 0, 0), point(1, 0, 0)), true); "
        "v = coord(p, 1); l = splitlst(axes); n = sizeof(axes);",
        "l = setcover(list(list(list(0, 2), list(3, 4)), list(list(1, 2), "
        "list(3, 6)), list(list(2, 3), list(4, 6))), 1e-9);",
        "s = getline(point_type);",
        NULL};

    (void)state;
    fail_all(texts);
}

static void test_coerce(void **state)
{
    static const char *const texts[] = {
        "l = coerce(list(point(1, 2, 3), ctlpt(P2, 1, 2, 3)), E3);",
        "p = coerce(plane(1, 2, 3, 4), point_type);",
        "c = cbspline(3, list(ctlpt(P1, 1, 5), ctlpt(P1, 2, 8), "
        "ctlpt(P1, 1, 3), ctlpt(P1, 4, 2)), list(KV_OPEN)); "
        "a = coerce(c, P2); b = coerce(c, bezier_type); "
        "d = coerce(c, power_type); m = coerce(c, multivar_type);",
        "c = cbspline(3, list(ctlpt(E1, 5), ctlpt(E1, 8), ctlpt(E1, 3)), "
        "list(KV_PERIODIC)); a = coerce(c, KV_OPEN); b = coerce(c, KV_FLOAT); "
        "d = coerce(a, bspline_type);",
        "s = sbezier(list(list(ctlpt(E1, 1), ctlpt(E1, 2)), "
        "list(ctlpt(E1, 3), ctlpt(E1, 4)))); a = coerce(s, E3); "
        "b = coerce(s, trimsrf_type); d = coerce(s, model_type); "
        "e = coerce(coerce(s, bspline_type), bezier_type);",
        NULL};

    (void)state;
    fail_all(texts);
}

static void test_attributes(void **state)
{
    static const char *const texts[] = {
        "p = point(0, 0, 0); attrib(p, \"s\", \"t\"); attrib(p, \"r\", 0.5); "
        "attrib(p, \"o\", list(p, list(1))); o = getattr(p, \"o\"); "
        "q = point(1, 0, 0); cpattr(q, p); rmattr(q, \"o\");",
        "l = list(point(0, 0, 0), list(point(1, 1, 1))); "
        "attrprop(l, \"rgb\", \"1,2,3\");",
        "p = poly(list(point(0, 0, 0), point(1, 0, 0)), true); "
        "attrib(p, \"rgb\", \"1,2,3\"); attrvprop(p, \"rgb\"); "
        "a = pattrib(p, 0, \"rgb\", \"3,2,1\"); "
        "n = pnormal(p, 0, vector(0, 0, 1));",
        NULL};

    (void)state;
    fail_all(texts);
}

static void test_analytic(void **state)
{
    static const char *const texts[] = {
        "m = matdecomp(rotx(30)); n = matdecomp2(rotx(30)); "
        "r = matrecomp(n); b = bbox(list(point(0, 0, 0))); "
        "h = homomat(list(list(1, 0, 0, 0), list(0, 1, 0, 0), "
        "list(0, 0, 1, 0), list(0, 0, 0, 1))); i = instance(\"a\", h);",
        "p = ptslnln(point(0, 0, 0), vector(1, 0, 0), point(0, 0, 2), "
        "vector(0, 1, 0)); c = ptscrcr(point(0, 0, 0), vector(0, 0, 1), 1, "
        "point(1, 0, 0), vector(0, 0, 1), 1); "
        "t = tnscrcr(point(-2, 0, 0), 0.5, point(1, 0, 0), 0.7, true);",
        "l = pthmspr(1.5); u = uvecsonspr(3); c = ctlpt(P2, 1, 2, 3);",
        "mov_x = cbezier(list(ctlpt(E1, 0), ctlpt(E1, 1))); "
        "p = point(1, 0, 0); attrib(p, \"animation\", list(mov_x, tx(1))); "
        "l = list(p, 3); q = animeval(0.5, l, false); "
        "m = animeval(0.5, l, true);",
        "g = isgeom(circle(vector(0, 0, 0), 1), GEOM_CIRCULAR, 1e-6); "
        "h = isgeom(ctlpt(E3, 0, 0, 0) + ctlpt(E3, 1, 0, 0), GEOM_LINEAR, "
        "1e-6);",
        NULL};

    (void)state;
    fail_all(texts);
}

static void test_system(void **state)
{
    static const char *const texts[] = {
        "a = 1; free(a); t = thisobj(\"a\"); varlist(); help(\"sin\"); "
        "help(\"view\"); iquery(1); iquery(2); idynmem(0); "
        "examplefunc(1, vector(1, 2, 3));",
        "o = iritstate(\"FloatFrmt\", \"%.15g\"); "
        "p = iritstate(\"BoolFreeform\", vector(1, 2, 3)); "
        "q = iritstate(\"RandomInit\", 5);",
        "exec(\"a = 3\"); f = function(x): return = x; fnfree(\"f\"); "
        "reset();",
        "viewobj(list(view_mat, axes)); view(axes, on); viewdclear(); "
        "printf(\"%d\\\\n\", list(3));",
        NULL};

    (void)state;
    fail_all(texts);
}

/* GETLINE takes the numbers that the type needs, else the text. */
static void test_getline(void **state)
{
    static const char input[] = "3.5\n1, 2 3\n1 2\n1 2 3 4\n4 5 6 \nword\n";
    static const char script[] =
        "a = getline(numeric_type); b = getline(point_type); "
        "c = getline(vector_type); d = getline(plane_type); "
        "e = getline(vector_type); f = getline(numeric_type); "
        "g = getline(string_type);";
    static const struct {
        const char *name;
        ix_obj_type type;
    } want[] = {{"A", IX_OBJ_NUMBER}, {"B", IX_OBJ_POINT},
                {"C", IX_OBJ_STRING}, {"D", IX_OBJ_PLANE},
                {"E", IX_OBJ_VECTOR}, {"F", IX_OBJ_STRING},
                {"G", IX_OBJ_STRING}};
    FILE *f = tmpfile();
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    run_state s = {.nowhere = stderr};

    (void)state;
    assert_non_null(f);
    assert_int_equal(fwrite(input, 1, sizeof input - 1, f), sizeof input - 1);
    assert_int_equal(fflush(f), 0);
    assert_true(dup2(fileno(f), 0) == 0);
    rewind(stdin);
    open_interp(ctx, &s);
    ASSERT_OK(ctx, ix__interp_run_text(s.in, "t", script, sizeof script - 1));
    for (size_t i = 0; i < sizeof want / sizeof *want; i++) {
        const ix_obj *o = ix__var_find(s.in, want[i].name);

        if (!o || o->type != want[i].type)
            fail_msg("%s is %s", want[i].name,
                     o ? ix__obj_type_name(o->type) : "not there");
    }
    assert_true(ix__var_find(s.in, "E")->u.pt[2] == 6);
    close_interp(ctx, &s);
    ix_ctx_free(ctx);
    (void)fclose(f);
}

/* What is shown is kept as it was then, until the display is cleared. */
static void test_viewed(void **state)
{
    static const char show[] = "a = 1; viewobj(list(a)); a = 2; viewobj(3);";
    ix_ctx *ctx = ix_ctx_new(NULL, NULL);
    run_state s = {.nowhere = stderr};
    const ix_obj *l;

    (void)state;
    open_interp(ctx, &s);
    ASSERT_OK(ctx, ix__interp_run_text(s.in, "t", show, sizeof show - 1));
    l = ix__interp_viewed(s.in);
    assert_int_equal(l->u.list.n, 2);
    assert_true(l->u.list.item[0]->u.list.item[0]->u.num == 1);
    assert_true(l->u.list.item[1]->u.num == 3);
    ASSERT_OK(ctx, ix__interp_run_text(s.in, "t", "viewclear();", 12));
    assert_int_equal(ix__interp_viewed(s.in)->u.list.n, 0);
    close_interp(ctx, &s);
    ix_ctx_free(ctx);
}

static void test_startup(void **state)
{
    static const char *const texts[] = {
        "m = tx(1) * rotline(point(1, 0, 0), vector(0, 0, 1), 90); "
        "n = normalize(point(3, 4, 0)); d = midpoint(n, n); "
        "c = genrandomcolor();",
        "p = makepolynsides(3); q = genplgonstopllns(list(p)); "
        "r = genpllnstoplgons(q); n = setnormalsinobjlist(list(p, list(q)), "
        "vector(0, 0, 1));",
        "s = planesrf(0, 0, 1, 2); l = getctlmeshpts(s, true);", NULL};

    (void)state;
    fail_all(texts);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_visible),    cmocka_unit_test(test_lists),
        cmocka_unit_test(test_regions),    cmocka_unit_test(test_coerce),
        cmocka_unit_test(test_attributes), cmocka_unit_test(test_analytic),
        cmocka_unit_test(test_system),     cmocka_unit_test(test_startup),
        cmocka_unit_test(test_getline),    cmocka_unit_test(test_viewed),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
