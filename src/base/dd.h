/* dd.h - double-double numbers: hi + lo with |lo| <= ulp(hi) / 2, about 106
 * bits. Error-free transformations of Knuth and Dekker; no contraction. */
#ifndef BASE_DD_H
#define BASE_DD_H

typedef struct {
    double hi, lo;
} ix_dd;

/* a + b exactly as a double-double. */
static inline ix_dd ix__two_sum(double a, double b)
{
    double s = a + b, bb = s - a;

    return (ix_dd){s, (a - (s - bb)) + (b - bb)};
}

static inline ix_dd ix__fast_two_sum(double a, double b) /* |a| >= |b| */
{
    double s = a + b;

    return (ix_dd){s, b - (s - a)};
}

/* a * b exactly (no overflow or underflow), Veltkamp splitting. */
static inline ix_dd ix__two_prod(double a, double b)
{
    double p = a * b;
    double ca = 134217729.0 * a, cb = 134217729.0 * b; /* 2^27 + 1 */
    double ah = ca - (ca - a), al = a - ah;
    double bh = cb - (cb - b), bl = b - bh;

    return (ix_dd){p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

/* Relative error below 2^-104 of |a| + |b|. */
static inline ix_dd ix__dd_add(ix_dd a, ix_dd b)
{
    ix_dd s = ix__two_sum(a.hi, b.hi), t = ix__two_sum(a.lo, b.lo);

    s = ix__fast_two_sum(s.hi, s.lo + t.hi);
    return ix__fast_two_sum(s.hi, s.lo + t.lo);
}

/* Relative error below 2^-102. */
static inline ix_dd ix__dd_mul(ix_dd a, ix_dd b)
{
    ix_dd p = ix__two_prod(a.hi, b.hi);

    return ix__fast_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

static inline ix_dd ix__dd_neg(ix_dd a)
{
    return (ix_dd){-a.hi, -a.lo};
}

#endif
