/* curves_multiple.c - cells in which a plane curve counts several times.
 *
 * Where f = g^m h, h not 0, the curve g = 0 has no regular point: f and its
 * derivatives up to order m - 1 vanish on it. But D = d^(m-1) f / dx_j^(m-1)
 * has it as a simple zero. On a strip around the cell, wider than it in x_j:
 *
 *   d^m f / dx_j^m > 0, D < 0 at the low side of the strip and D > 0 at the
 * high one: for every x_k there is one x_j with D = 0; f = df/dx_j = ... = 0
 * there: f is, from m integrations, of one sign at each side of it, so it has
 * no other zero.
 *
 * The first is proven by signs of coefficients, the second looked at in places,
 * to what rounding can tell. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "solve/curves_impl.h"

#define UNIT (DBL_EPSILON / 2)
#define ACROSS                                                         \
    1.0 /* how far the strip reaches beyond the cell: a curve of slope \
           1 that touches the cell stays in it */
#define PLACES 9
#define MOST   4 /* times */

/* A tensor of two directions with fewer coefficients in direction j: len of
 * them are used, the room is that of the shape. */
typedef struct {
    const ix__shape *s;
    double *c;
    int j, len;
    double err;
} field;

static double *line(const field *f, size_t i)
{
    return f->c + (f->j ? i : i * (size_t)f->s->dims[0]);
}

static size_t lines(const field *f)
{
    return f->s->size / (size_t)f->s->dims[f->j];
}

static double largest(const field *f)
{
    size_t st = f->s->stride[f->j];
    double m = 0;

    for (size_t i = 0; i < lines(f); i++)
        for (int k = 0; k < f->len; k++)
            m = ix__larger(m, fabs(line(f, i)[(size_t)k * st]));
    return m;
}

/* d/dx_j. A difference of coefficients known to err is known to twice that. */
static void derive(field *f)
{
    size_t st = f->s->stride[f->j];

    f->err = 2 * (f->len - 1) * (f->err + UNIT * largest(f));
    for (size_t i = 0; i < lines(f); i++) {
        double *v = line(f, i);

        for (int k = 0; k + 1 < f->len; k++)
            v[(size_t)k * st] = (f->len - 1) *
                                (v[(size_t)(k + 1) * st] - v[(size_t)k * st]);
    }
    f->len--;
}

/* To as many coefficients as the shape has. */
static void elevate(field *f)
{
    size_t st = f->s->stride[f->j];

    for (; f->len < f->s->dims[f->j]; f->len++) {
        for (size_t i = 0; i < lines(f); i++) {
            double *v = line(f, i);

            v[(size_t)f->len * st] = v[(size_t)(f->len - 1) * st];
            for (int k = f->len - 1; k > 0; k--)
                v[(size_t)k * st] += (double)k / f->len *
                                     (v[(size_t)(k - 1) * st] -
                                      v[(size_t)k * st]);
        }
        f->err += 3 * UNIT * largest(f);
    }
}

/* The sign that coefficients from..to - 1 of all lines have, or 0. */
static int sign_of(const field *f, int from, int to)
{
    size_t st = f->s->stride[f->j];
    double lo = HUGE_VAL, hi = -HUGE_VAL;

    for (size_t i = 0; i < lines(f); i++)
        for (int k = from; k < to; k++) {
            lo = ix__smaller(lo, line(f, i)[(size_t)k * st]);
            hi = ix__larger(hi, line(f, i)[(size_t)k * st]);
        }
    return lo > f->err ? 1 : hi < -f->err ? -1 : 0;
}

/* Whether D has one zero for every x_k: on the strip. work: the size. */
static bool has_graph(const ix__curves *s, const ix__box *b, int j, int times,
                      double *work)
{
    const ix__shape *h = &s->t.shape;
    field f = {h, work, j, h->dims[j], b->err[0]};
    int low, high;

    memcpy(work, b->c, h->size * sizeof *work);
    ix__tensor_restrict(h, work, j, -ACROSS, 1 + ACROSS);
    /* the two passes extrapolate by 1 and by half of what there is then */
    f.err = (f.err + 6 * (f.len - 1) * UNIT * largest(&f)) *
            pow((1 + 2 * ACROSS) * 2, f.len - 1);
    for (int i = 1; i < times; i++)
        derive(&f);
    low = sign_of(&f, 0, 1);
    high = sign_of(&f, f.len - 1, f.len);
    if (low == 0 || high != -low)
        return false;
    derive(&f);
    return sign_of(&f, 0, f.len) == high;
}

/* The zero of d (given on the cell) in x_j, x_k in place; false if Newton does
 * not come to an end in the strip. */
static bool zero_at(const ix__shape *h, const double *d, int j, double *x,
                    double *work)
{
    double last = HUGE_VAL;

    x[j] = 0.5;
    for (int it = 0; it < 60; it++) {
        double grad[IX_MAX_UNKNOWNS], step;

        ix__tensor_gradient(h, d, x, grad, work);
        step = ix__tensor_value(h, d, x, work) / grad[j];
        if (!(fabs(step) < 4))
            return false;
        x[j] -= step;
        if (fabs(step) <= 4 * UNIT || (last < 1e-7 && fabs(step) >= last / 2))
            return x[j] >= -ACROSS && x[j] <= 1 + ACROSS;
        last = fabs(step);
    }
    return false;
}

/* Whether f and its derivatives below D vanish where D does. f: the equation on
 * the cell; room for a tensor in lower. */
static bool vanishes_on(const ix__curves *s, const ix__box *b, int j, int times,
                        const double *d, double *lower, double *work)
{
    const ix__shape *h = &s->t.shape;
    field f = {h, lower, j, h->dims[j], b->err[0]};

    memcpy(lower, b->c, h->size * sizeof *lower);
    for (int i = 1; i < times; i++) {
        field g = f;

        elevate(&g); /* in place: undone by the next round */
        for (int p = 0; p < PLACES; p++) {
            double x[2], grow;

            x[1 - j] = (double)p / (PLACES - 1);
            if (!zero_at(h, d, j, x, work))
                return false;
            grow = pow(fabs(x[j]) + fabs(1 - x[j]), h->dims[j] - 1);
            if (!(fabs(ix__tensor_value(h, lower, x, work)) <=
                  2 * g.err * grow))
                return false;
        }
        memcpy(lower, b->c, h->size * sizeof *lower);
        f = (field){h, lower, j, h->dims[j], b->err[0]};
        for (int k = 0; k < i; k++)
            derive(&f);
    }
    return true;
}

/* D on the cell. */
static void make(const ix__curves *s, const ix__box *b, int j, int times,
                 ix__box *out)
{
    const ix__shape *h = &s->t.shape;
    double *c = out->c;
    field f = {h, c, j, h->dims[j], b->err[0]};

    *out = *b;
    out->c = c;
    memcpy(c, b->c, h->size * sizeof *c);
    for (int i = 1; i < times; i++)
        derive(&f);
    elevate(&f);
    out->err[0] = f.err;
    out->mag[0] = largest(&f);
}

int ix__curves_multiple(const ix__curves *s, const ix__box *b, double *work,
                        ix__box *out)
{
    size_t size = s->t.shape.size;

    for (int times = 2; times <= MOST; times++)
        for (int j = 0; j < 2; j++) {
            if (times >= s->t.shape.dims[j] || !has_graph(s, b, j, times, work))
                continue;
            make(s, b, j, times, out);
            if (vanishes_on(s, b, j, times, out->c, work, work + size))
                return times;
        }
    return 0;
}
