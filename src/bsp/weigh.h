/* weigh.h - the kernel below knot insertion, sampling and composition: a
 * weighted sum of neighbouring rows. */
#ifndef BSP_WEIGH_H
#define BSP_WEIGH_H

#include <stddef.h>

/* out[l] = ref[l] + sum over q < n of w[q] (in[q * inner + l] - ref[l]) for
 * l < inner; without ref (NULL) plain sums. out overlaps nothing. */
void ix__weigh(size_t inner, int n, const double *w, const double *in,
               const double *ref, double *out);

#endif
