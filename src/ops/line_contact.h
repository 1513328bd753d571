/* line_contact.h - how closely the tangent lines of a surface touch it.
 *
 * Unknowns (u, v, r), each in [0, 1]: a point of a Bezier patch and the tangent
 * a S_u + b S_v there. Directions (up to sign) are in two charts: (a, b) runs
 * linearly from (1, -q) to (1, q), or from there to (-1, q); q makes both parts
 * about as long.
 *
 * Let the curve S(u(s), v(s)) stay above the line, in a direction that is not
 * tangent, and h(s) be its distance from the tangent plane: the line meets the
 * surface k + 1 times (has contact of order k) where h'' = .. = h^(k) = 0. With
 * P = (p, w), n the tangent plane, P_i the i-th derivative along (a, b),
 *
 *   h''   = n.P_2                          asymptotic
 *   h'''  = n.P_3 - 3 n.P_2(d, g2)         flecnodal
 *   h'''' = n.P_4 - 6 n.P_3(d, d, g2) + 3 n.P_2(g2, g2) - 4 n.P_2(d, g3)
 *
 * where -g2 and -g3 are the accelerations that keep it there: P_2 = g2 (P_u,
 * P_v) modulo P, and g3 likewise for P_3 - 3 P_2(d, g2). Each is multiplied by
 * the power of n.e that makes it a polynomial, e a constant vector if that has
 * no zero, else n. */
#ifndef OPS_LINE_CONTACT_H
#define OPS_LINE_CONTACT_H

#include "iritx/solve.h"
#include "mv/mv.h"

typedef struct {
    int n;       /* equations: contact of order n + 1; 0: the Gauss curvature
                    is positive, there is no asymptotic direction */
    ix_mv *f[3]; /* references; h'', h''', h'''' */
    int chart;   /* 0, 1 */
    double q;
    double dom[2][2]; /* of the surface */
} ix__line_contact;

/* order 2 .. 4. dom becomes [0, 1]; places are in whatever it is set to. Err
 * IX_EARG not a Bezier surface of 3 coordinates; IX_EDOMAIN no normal; h'' is
 * zero everywhere: a plane; h''' is zero wherever h'' is, by samples: ruled */
ix_status ix__line_contact_make(ix_ctx *ctx, const ix_mv *s, int order,
                                int chart, ix__line_contact *out) IX_MUST_CHECK;
void ix__line_contact_free(ix_ctx *ctx, ix__line_contact *c);

/* (u, v, r) as (u, v, a, b) of the surface itself, a^2 + b^2 = 1. */
void ix__line_contact_place(const ix__line_contact *c, const double *x,
                            double out[4]);
/* The same of a solution and its box. */
ix_solution ix__line_contact_solution(const ix__line_contact *c,
                                      const ix_solution *s);

#endif
