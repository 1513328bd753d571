/* builtins_numeric.c - functions of numbers (chapter 2). Outside their domain
 * they give NaN or an infinity, silently, as scripts expect. */
#include <math.h>

#include "base/random.h"
#include "lang/interp.h"

#define NUMBER_FN(name, expr)             \
    static ix_status b_##name(ix_call *c) \
    {                                     \
        double x = ix__arg_num(c, 0);     \
                                          \
        return ix__ret_num(c, expr);      \
    }
#define NUMBER_FN2(name, expr)                               \
    static ix_status b_##name(ix_call *c)                    \
    {                                                        \
        double x = ix__arg_num(c, 0), y = ix__arg_num(c, 1); \
                                                             \
        return ix__ret_num(c, expr);                         \
    }

NUMBER_FN(abs, fabs(x))
NUMBER_FN(acos, acos(x))
NUMBER_FN(asin, asin(x))
NUMBER_FN(atan, atan(x))
NUMBER_FN(cos, cos(x))
NUMBER_FN(exp, exp(x))
NUMBER_FN(floor, floor(x))
NUMBER_FN(ln, log(x))
NUMBER_FN(log, log10(x))
NUMBER_FN(sin, sin(x))
NUMBER_FN(sqrt, sqrt(x))
NUMBER_FN(tan, tan(x))
NUMBER_FN2(atan2, atan2(x, y))
NUMBER_FN2(fmod, fmod(x, y))
NUMBER_FN2(power, pow(x, y))

static ix_status b_random(ix_call *c)
{
    double lo = ix__arg_num(c, 0), hi = ix__arg_num(c, 1);
    double u = ix__random_unit(&ix__states(c->in)->random);
    double v = lo * (1 - u) + hi * u;

    /* Rounding may reach the bound, which does not belong to the range. */
    return ix__ret_num(c, v == hi ? nextafter(hi, lo) : v);
}

const ix_builtin ix__builtins_numeric[] = {
    {"ABS", "x:num -> num", "The absolute value of x.", "abs(-2.5);", b_abs, 0,
     2},
    {"ACOS", "x:num -> num",
     "The angle in [0, pi] whose cosine is x; NaN outside [-1, 1].",
     "acos(0.5);", b_acos, 0, 2},
    {"ASIN", "x:num -> num",
     "The angle in [-pi/2, pi/2] whose sine is x; NaN outside [-1, 1].",
     "asin(0.5);", b_asin, 0, 2},
    {"ATAN", "x:num -> num", "The angle in (-pi/2, pi/2) whose tangent is x.",
     "atan(1);", b_atan, 0, 2},
    {"ATAN2", "y:num x:num -> num",
     "The angle in (-pi, pi] of the direction (x, y).", "atan2(1, -1);",
     b_atan2, 0, 2},
    {"COS", "x:num -> num", "The cosine of x radians.", "cos(pi / 3);", b_cos,
     0, 2},
    {"EXP", "x:num -> num", "e to the power x.", "exp(1);", b_exp, 0, 2},
    {"FLOOR", "x:num -> num", "The largest integer not above x.",
     "floor(-2.5);", b_floor, 0, 2},
    {"FMOD", "x:num m:num -> num", "The remainder of x / m with the sign of x.",
     "fmod(-7, 3);", b_fmod, 0, 2},
    {"LN", "x:num -> num", "The natural logarithm of x; -inf at 0, NaN below.",
     "ln(10);", b_ln, 0, 2},
    {"LOG", "x:num -> num",
     "The logarithm of x to base 10; -inf at 0, NaN below.", "log(1000);",
     b_log, 0, 2},
    {"POWER", "x:num y:num -> num", "x to the power y, like x ^ y.",
     "power(2, 0.5);", b_power, 0, 2},
    {"RANDOM", "min:num max:num -> num",
     "A pseudo-random number, uniform in [min, max); the state RandomInit "
     "starts the sequence, which is the same on every machine.",
     "dummy = iritstate(\"RandomInit\", 1964): random(0, 1);", b_random,
     IX_B_STATE, 2},
    {"SIN", "x:num -> num", "The sine of x radians.", "sin(pi / 6);", b_sin, 0,
     2},
    {"SQRT", "x:num -> num", "The square root of x; NaN below 0.", "sqrt(2);",
     b_sqrt, 0, 2},
    {"TAN", "x:num -> num", "The tangent of x radians.", "tan(pi / 4);", b_tan,
     0, 2},
    {NULL, NULL, NULL, NULL, NULL, 0, 0}};
