/* plane_size.c - the size of sets of curves, to which tolerances are relative.
 */
#include <math.h>

#include "ops/plane.h"

/* Places of a span that are looked at: between them a span of degree 3 is no
 * more than 2 % of its size longer, and what is missed makes tolerances
 * smaller. */
enum { PLACES = 8 };

static void grow(double box[2][2], const double *x)
{
    for (int k = 0; k < 2; k++) {
        box[0][k] = fmin(box[0][k], x[k]);
        box[1][k] = fmax(box[1][k], x[k]);
    }
}

static void box_set(const ix__set *s, double box[2][2])
{
    for (int i = 0; i < s->nspans; i++) {
        const ix__span *sp = &s->span[i];

        if (sp->phantom)
            continue;
        for (int j = 0; j <= PLACES; j++) {
            double d[3][2];

            ix__span_at(s, sp, (double)j / PLACES, d);
            if (isfinite(d[0][0] + d[0][1]))
                grow(box, d[0]);
        }
    }
}

double ix__sets_size(const ix__set *a, const ix__set *b)
{
    double box[2][2] = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};

    box_set(a, box);
    if (b != a)
        box_set(b, box);
    return 0.5 * fmax(box[1][0] - box[0][0], box[1][1] - box[0][1]);
}
