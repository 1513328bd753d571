/* spread.c - random parameters, uniform over the domain or over the shape. By
 * measure they are accepted with a probability in proportion to the speed or
 * the area element, as far as a bound of it is known. */
#include <math.h>

#include "base/random.h"
#include "geom/vec3.h"
#include "iritx/geom_srf.h"
#include "mv/mv.h"

/* Speed of a curve or area element of a surface at t. */
static ix_status density(ix_ctx *ctx, const ix_mv *m, const double *t,
                         double *out)
{
    double d[2 * IX_MAX_COORDS], du[3], dv[3], n[3] = {0};

    if (m->ndirs == 1) {
        IX_TRY(ix_mv_curve_derivs(ctx, m, *t, 1, d));
        for (int k = 0; k < m->ncoords; k++)
            n[k] = d[m->ncoords + k];
    } else {
        IX_TRY(ix_srf_tangent(ctx, m, 0, t[0], t[1], du));
        IX_TRY(ix_srf_tangent(ctx, m, 1, t[0], t[1], dv));
        ix__cross3(du, dv, n);
    }
    *out = ix__len3(n);
    return IX_OK;
}

typedef struct {
    const ix_mv *m;
    double dom[2][2];
    uint64_t *random;
    double bound; /* of the density; 0: all are accepted */
} source;

static void draw(source *s, double *t)
{
    for (int d = 0; d < s->m->ndirs; d++) {
        double x = ix__random_unit(s->random);

        t[d] = (1 - x) * s->dom[d][0] + x * s->dom[d][1];
    }
}

/* The largest density at 256 points spread over the domain, and a tenth. */
static ix_status find_bound(ix_ctx *ctx, source *s)
{
    uint64_t state = 1;
    source probe = *s;
    double t[2], f;

    probe.random = &state;
    for (int i = 0; i < 256; i++) {
        draw(&probe, t);
        IX_TRY(density(ctx, s->m, t, &f));
        s->bound = fmax(s->bound, 1.1 * f);
    }
    if (!(s->bound > 0 && isfinite(s->bound)))
        return IX_FAIL(ctx, IX_EDOMAIN, "the shape has no %s: %g",
                       s->m->ndirs == 1 ? "length" : "area", s->bound);
    return IX_OK;
}

/* One accepted parameter; *bad if a density was above the bound, which is
 * then raised and all must be drawn again. */
static ix_status accept(ix_ctx *ctx, source *s, double *t, bool *bad)
{
    double f;

    for (;;) {
        IX_TRY(ix__poll(ctx));
        draw(s, t);
        if (s->bound == 0)
            return IX_OK;
        IX_TRY(density(ctx, s->m, t, &f));
        if (f > s->bound) {
            s->bound = 1.1 * f;
            *bad = true;
        }
        if (*bad || ix__random_unit(s->random) * s->bound < f)
            return IX_OK;
    }
}

static ix_status spread(ix_ctx *ctx, source *s, int n, double *out)
{
    double t[2];

    for (int i = 0; i < n;) {
        bool bad = false;

        IX_TRY(accept(ctx, s, t, &bad));
        if (bad) {
            i = 0;
            continue;
        }
        for (int d = 0; d < s->m->ndirs; d++)
            out[(size_t)d * (size_t)n + (size_t)i] = t[d];
        i++;
    }
    return IX_OK;
}

ix_status ix_spread(ix_ctx *ctx, const ix_mv *m, bool by_measure, int n,
                    uint64_t *random, double *out)
{
    source s = {.m = m, .random = random};

    if (m->ndirs > 2 || m->ncoords > 3 || n < 0)
        return IX_FAIL(ctx, IX_EARG,
                       "%d points on a shape of %d directions and %d "
                       "coordinates",
                       n, m->ndirs, m->ncoords);
    for (int d = 0; d < m->ndirs; d++)
        ix_mv_domain(m, d, s.dom[d]);
    if (by_measure)
        IX_TRY(find_bound(ctx, &s));
    return spread(ctx, &s, n, out);
}
