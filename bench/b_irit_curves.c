/* b_irit_curves.c - operators on planar curves called from scripts, with the
 * input of the scripts by which IRIT 11 was timed (10 and 20 knots) or like it
 * (100 knots). Its times, in the default mode of products and in the fastest
 * one, are in the names: another machine's, for the order of magnitude. */
#define _POSIX_C_SOURCE 200809L
#include "script.h"

/* Ordinates of the curve with 10 knots; the others go on at random. */
static double ordinate(int knots, int i)
{
    static const double ten[14] = {0.655,  0.190,  0.762,  -0.361, -0.805,
                                   -0.629, -0.907, 0.415,  0.372,  0.509,
                                   0.562,  -0.750, -0.872, 0.318};
    static unsigned state = 1;

    if (knots == 10)
        return ten[i];
    state = i == 0 ? 1 : state * 1103515245u + 12345u;
    return (double)(state >> 16 & 1023) / 512 - 1;
}

/* The cubic B-spline with that many simple knots, as variable C. */
static void define(script_bench *b, int knots)
{
    static char text[20000];
    int n = 0;

    n += snprintf(text + n, sizeof text - (size_t)n, "c = cbspline(4, list(");
    for (int i = 0; i < knots + 4; i++)
        n += snprintf(text + n, sizeof text - (size_t)n,
                      "%sctlpt(E2, %.1f, %.3f)", i ? ", " : "", 0.5 * i,
                      ordinate(knots, i));
    snprintf(text + n, sizeof text - (size_t)n, "), list(KV_OPEN));");
    script_run(b, text);
}

typedef struct {
    int knots; /* 0: an ellipse of four arcs; 1: a cubic Bezier curve */
    const char *call, *irit;
} row;

static void time_row(script_bench *b, const row *r)
{
    static const char ellipse[] = "c = circle(vector(0, 0, 0), 1) * sx(2);";
    static const char cubic[] =
        "c = cbezier(list(ctlpt(E2, -1, 0.5), ctlpt(E2, -0.5, -2), ctlpt(E2, "
        "0, 1), ctlpt(E2, 1, 0)));";
    char name[100];

    if (r->knots > 1)
        define(b, r->knots);
    else
        script_run(b, r->knots ? cubic : ellipse);
    snprintf(name, sizeof name, "%s, %d knots (IRIT %s)", r->call, r->knots,
             r->irit);
    if (r->knots < 2)
        snprintf(name, sizeof name, "%s, %s (IRIT %s)", r->call,
                 r->knots ? "cubic" : "ellipse", r->irit);
    script_time(b, name, r->call);
}

int main(void)
{
    static const row rows[] = {{1, "evolute(c)", "9.18 us, 9.96 us"},
                               {10, "evolute(c)", "9.31 ms, 2.23 ms"},
                               {20, "evolute(c)", "40.8 ms, 9.37 ms"},
                               {100, "evolute(c)", "5.44 s, 1.14 s"},
                               {200, "evolute(c)", "-, 18.9 s"},
                               {100, "ccrvtr(c, 1e-6, 1)", "5.71 s, 4.86 s"},
                               {1, "ccrvtr(c, 1e-6, 2)", "18.3 us"},
                               {10, "ccrvtr(c, 1e-6, 2)", "9.76 ms"},
                               {24, "ccrvtr(c, 1e-6, 2)", "61.9 ms"},
                               {99, "ccrvtr(c, 1e-6, 2)", "2.52 s"},
                               {0, "ccrvtr(c, 1e-6, 2)", "248 ms"},
                               {99, "cinflect(c, 1e-6, 2)", "3.53 ms"}};
    script_bench b = script_begin();

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        time_row(&b, &rows[i]);
    script_end(&b);
    return 0;
}
