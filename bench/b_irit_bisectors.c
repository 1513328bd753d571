/* b_irit_bisectors.c - bisectors called from scripts, with the input of the
 * scripts by which IRIT 11 was timed where that is known ("like it" elsewhere).
 * Its times, in the default mode of products and in the fastest one, are in the
 * names: another machine's, for the order of magnitude. */
#define _POSIX_C_SOURCE 200809L
#include "script.h"

static const char cubics[] =
    "a = cbezier(list(ctlpt(E3, -0.8, 0.4, 0.2), ctlpt(E3, -0.2, -0.3, 0.5), "
    "ctlpt(E3, 0.3, 0.4, -0.5), ctlpt(E3, 0.7, -0.4, 0.4))); b = "
    "cbezier(list(ctlpt(E3, -0.7, 1.5, 1), ctlpt(E3, -0.1, 1.2, 1.6), "
    "ctlpt(E3, 0.4, 1.9, 1.3), ctlpt(E3, 0.9, 1.4, 0.8)));";
static const char splines[] =
    "a = cbspline(4, list(ctlpt(E3, 0, 0.219, 0.176), ctlpt(E3, 0.5, -0.428, "
    "-0.172), ctlpt(E3, 1, -0.044, -0.193), ctlpt(E3, 1.5, -0.302, -0.125), "
    "ctlpt(E3, 2, 0.333, -0.233), ctlpt(E3, 2.5, 0.436, -0.494), ctlpt(E3, 3, "
    "-0.078, 0.221), ctlpt(E3, 3.5, 0.255, -0.488), ctlpt(E3, 4, -0.385, "
    "-0.429), ctlpt(E3, 4.5, 0.065, -0.405), ctlpt(E3, 5, -0.104, -0.218), "
    "ctlpt(E3, 5.5, -0.398, -0.125)), list(0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, "
    "8, 9, 9, 9, 9)); b = cbspline(4, list(ctlpt(E3, 0, 1.936, 2.078), "
    "ctlpt(E3, 0.5, 1.845, 1.569), ctlpt(E3, 1, 1.829, 2.194), ctlpt(E3, 1.5, "
    "1.504, 2.022), ctlpt(E3, 2, 1.52, 2.364), ctlpt(E3, 2.5, 1.697, 2.034), "
    "ctlpt(E3, 3, 1.591, 2.047), ctlpt(E3, 3.5, 2.293, 2.415), ctlpt(E3, 4, "
    "2.29, 2.394), ctlpt(E3, 4.5, 1.508, 2.306), ctlpt(E3, 5, 1.549, 2.371), "
    "ctlpt(E3, 5.5, 2.496, 2.218)), list(0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, "
    "9, 9, 9, 9));";
static const char planar[] =
    "c = cbezier(list(ctlpt(E2, -1, 0.5), ctlpt(E2, -0.5, -2), ctlpt(E2, 0, "
    "1), ctlpt(E2, 1, 0)));";
static const char planar8[] =
    "c = cbspline(4, list(ctlpt(E2, 0, 0.213), ctlpt(E2, 0.5, 0.466), "
    "ctlpt(E2, 1, -0.826), ctlpt(E2, 1.5, 0.727), ctlpt(E2, 2, -0.825), "
    "ctlpt(E2, 2.5, -0.523), ctlpt(E2, 3, -0.46), ctlpt(E2, 3.5, 0.375), "
    "ctlpt(E2, 4, -0.213), ctlpt(E2, 4.5, -0.228), ctlpt(E2, 5, 0.004), "
    "ctlpt(E2, 5.5, 0.507)), list(0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, "
    "9, 9));";
static const char planar5[] =
    "a = cbspline(4, list(ctlpt(E2, 0, 0), ctlpt(E2, 0.4, 0.9), ctlpt(E2, "
    "1.1, 1), ctlpt(E2, 1.5, 0.1), ctlpt(E2, 2.1, -0.6), ctlpt(E2, 2.9, "
    "-0.2), ctlpt(E2, 3.2, 0.7), ctlpt(E2, 4, 1.1), ctlpt(E2, 4.6, 0.2)), "
    "list(0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 6, 6, 6)); b = cbspline(4, "
    "list(ctlpt(E2, 0, 2), ctlpt(E2, 0.5, 2.4), ctlpt(E2, 1, 2.9), ctlpt(E2, "
    "1.6, 2.2), ctlpt(E2, 2.2, 1.9), ctlpt(E2, 2.8, 2.3), ctlpt(E2, 3.3, "
    "2.8), ctlpt(E2, 3.9, 2.6), ctlpt(E2, 4.5, 2.1)), list(0, 0, 0, 0, 1, 2, "
    "3, 4, 5, 6, 6, 6, 6));";
static const char biquadratic[] =
    "s = sbezier(list(list(ctlpt(E3, -1, -1, 0), ctlpt(E3, -1, 0, 0.1), "
    "ctlpt(E3, -1, 1, 0)), list(ctlpt(E3, 0, -1, 0.1), ctlpt(E3, 0, 0, -0.8), "
    "ctlpt(E3, 0, 1, 0.1)), list(ctlpt(E3, 1, -1, 0), ctlpt(E3, 1, 0, 0.1), "
    "ctlpt(E3, 1, 1, 0))));";
static const char bicubic[] =
    "s = sbezier(list(list(ctlpt(E3, -0.9, -0.9, 0.2), ctlpt(E3, -0.9, -0.3, "
    "0), ctlpt(E3, -0.9, 0.3, -0.1), ctlpt(E3, -0.9, 0.9, 0.1)), "
    "list(ctlpt(E3, -0.3, -0.9, 0.1), ctlpt(E3, -0.3, -0.3, 0.4), ctlpt(E3, "
    "-0.3, 0.3, 0.2), ctlpt(E3, -0.3, 0.9, 0)), list(ctlpt(E3, 0.3, -0.9, 0), "
    "ctlpt(E3, 0.3, -0.3, -0.2), ctlpt(E3, 0.3, 0.3, 0.3), ctlpt(E3, 0.3, "
    "0.9, 0.2)), list(ctlpt(E3, 0.9, -0.9, -0.1), ctlpt(E3, 0.9, -0.3, 0.1), "
    "ctlpt(E3, 0.9, 0.3, 0), ctlpt(E3, 0.9, 0.9, 0.3))));";
static const char patches[] =
    "s = sbspline(4, 4, list(list(ctlpt(E3, 0, 0, 0.1), ctlpt(E3, 0, 1, 0.3), "
    "ctlpt(E3, 0, 2, 0), ctlpt(E3, 0, 3, 0.2), ctlpt(E3, 0, 4, 0.1)), "
    "list(ctlpt(E3, 1, 0, 0.4), ctlpt(E3, 1, 1, 0), ctlpt(E3, 1, 2, 0.5), "
    "ctlpt(E3, 1, 3, -0.2), ctlpt(E3, 1, 4, 0.3)), list(ctlpt(E3, 2, 0, "
    "-0.1), ctlpt(E3, 2, 1, 0.6), ctlpt(E3, 2, 2, 0.2), ctlpt(E3, 2, 3, 0.1), "
    "ctlpt(E3, 2, 4, 0)), list(ctlpt(E3, 3, 0, 0.2), ctlpt(E3, 3, 1, -0.3), "
    "ctlpt(E3, 3, 2, 0.1), ctlpt(E3, 3, 3, 0.4), ctlpt(E3, 3, 4, 0.2)), "
    "list(ctlpt(E3, 4, 0, 0), ctlpt(E3, 4, 1, 0.2), ctlpt(E3, 4, 2, -0.1), "
    "ctlpt(E3, 4, 3, 0.3), ctlpt(E3, 4, 4, 0.5))), list(list(0, 0, 0, 0, 1, "
    "2, 2, 2, 2), list(0, 0, 0, 0, 1, 2, 2, 2, 2)));";
static const char pair[] =
    "a = cbezier(list(ctlpt(E2, -1, 0.5), ctlpt(E2, -0.5, -2), ctlpt(E2, 0, "
    "1), ctlpt(E2, 1, 0))); b = cbezier(list(ctlpt(E2, -0.9, 2.1), ctlpt(E2, "
    "-0.3, 1.2), ctlpt(E2, 0.4, 2.6), ctlpt(E2, 1, 1.6)));";
static const char quadratics[] =
    "a = cbezier(list(ctlpt(E3, 0, 0, 0), ctlpt(E3, 1, 0, 1), ctlpt(E3, 2, 1, "
    "0))); b = cbezier(list(ctlpt(E3, 0, 2, 0), ctlpt(E3, 0, 3, 1), ctlpt(E3, "
    "1, 4, 2)));";
static const char circle_line[] =
    "a = circle(vector(0, 0, 0), 1); b = cbezier(list(point(1.5, 0.2, -1), "
    "point(1.7, 0.4, 1)));";
static const char arcs_line[] =
    "a = pcircle(vector(0, 0, 0), 1); b = cbezier(list(point(1.5, 0.2, -1), "
    "point(1.7, 0.4, 1)));";
static const char unit_circle[] = "c = circle(vector(0, 0, 0), 1);";
static const char ball[] = "s = spheresrf(1);";

typedef struct {
    const char *what, *setup, *call, *irit;
} row;

#define TWO      "cbisector3d(list(a, b), 1)"
#define POINT(x) "cbisector3d(list(" #x ", point(0.1, 2.9, 0.7)), 1)"
#define FLAT \
    "cbisector2d(list(c, point(0.3, 2.9, 0)), false, 1, 20, true, false)"
#define FIELD(k) "cbisector2d(list(a, b), true, " #k ", 30, true, false)"
#define LINES    "cbisector2d(list(a, b), false, 1, 30, true, false)"
#define SRF(z)   "sbisector(s, point(0.2, 0.1, " #z "))"

static const row rows[] = {
    {"two quadratics, like it", quadratics, TWO, "998 us, 98.6 us"},
    {"circle and line, like it", circle_line, TWO, "14.2 ms, 801 us"},
    {"polynomial circle and line, like it", arcs_line, TWO, "3.96 ms, 602 us"},
    {"two cubics", cubics, TWO, "3.4 ms, -"},
    {"two cubics, 8 inner knots each", splines, TWO, "439 ms, 16.4 ms"},
    {"point and planar cubic", planar, FLAT, "3.1 us, -"},
    {"point and planar cubic, 8 inner knots", planar8, FLAT, "953 us, 736 us"},
    {"point and planar cubic, 100 inner knots, like it", NULL, FLAT,
     "596 ms, 674 ms"},
    {"point and space cubic", cubics, POINT(a), "14.9 us, -"},
    {"point and space cubic, 8 inner knots", splines, POINT(a),
     "49.6 ms, 4.9 ms"},
    {"point and circle", unit_circle, POINT(c), "33.3 ms, -"},
    {"field 1 of two planar cubics, like it", pair, FIELD(1), "2.26 ms, -"},
    {"field 2", pair, FIELD(2), "2.02 ms, -"},
    {"field 3", pair, FIELD(3), "472 us, -"},
    {"field 4", pair, "cbisector3d(list(a, b), 4)", "3.63 ms, -"},
    {"polylines of field 1", pair, LINES, "3.43 ms, -"},
    {"polylines of field 1, 5 inner knots", planar5, LINES, "116 ms, 67.1 ms"},
    {"point and biquadratic", biquadratic, SRF(1.5), "19.6 us, -"},
    {"point and bicubic", bicubic, SRF(1.5), "38.1 us, -"},
    {"point and bicubic, 2 x 2 patches", patches, SRF(4.5), "49.7 ms, 723 us"},
    {"point and sphere", ball, SRF(1.5), "612 ms, 3.72 ms"}};

/* A planar cubic with 100 inner knots, as variable C. */
static void define_long(script_bench *b)
{
    script_run(b, "p = nil(); for (i = 0, 1, 103, "
                  "snoc(ctlpt(E2, i / 2, sin(i * i)), p)); "
                  "c = cbspline(4, p, list(KV_OPEN));");
}

static void time_row(script_bench *b, const row *r)
{
    char name[100];

    if (r->setup)
        script_run(b, r->setup);
    else
        define_long(b);
    snprintf(name, sizeof name, "%s (IRIT %s)", r->what, r->irit);
    script_time(b, name, r->call);
}

int main(void)
{
    script_bench b = script_begin();

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        time_row(&b, &rows[i]);
    script_end(&b);
    return 0;
}
