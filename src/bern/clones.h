/* clones.h - kernels compiled for several widths of vectors, chosen when the
 * program is loaded. The order of additions is written out, so the bits do
 * not depend on the choice. */
#ifndef BERN_CLONES_H
#define BERN_CLONES_H

/* clang 14 has no clones; under ASan the chooser would run before ASan. */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define IX__CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define IX__CLONES
#endif
#define IX__INLINE static inline __attribute__((always_inline))

/* Four doubles anywhere; wider types are split badly on narrower machines. */
typedef double ix__v4 __attribute__((vector_size(32), aligned(8), may_alias));

IX__INLINE ix__v4 *ix__vec(double *p)
{
    return (ix__v4 *)(void *)p;
}

IX__INLINE const ix__v4 *ix__cvec(const double *p)
{
    return (const ix__v4 *)(const void *)p;
}

#endif
