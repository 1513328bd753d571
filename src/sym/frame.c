/* frame.c - carrying inputs into the unit box and results back. The scale is
 * a power of two, the shift is subtracted from the input with one rounding. */
#include <math.h>

#include "sym/form.h"

/* Grows the boxes by the projected control points of m; false if none has a
 * weight that projects to a finite point. */
static bool grow(const ix_mv *m, int nc, double *lo, double *hi)
{
    const double *w = ix_mv_weights(m);
    bool any = false;

    for (size_t i = 0; i < m->npts; i++) {
        if (w && w[i] == 0.0)
            continue;
        for (int k = 0; k < nc && k < m->ncoords; k++) {
            double x = ix_mv_coord(m, k)[i];

            x = w ? x / w[i] : x;
            if (!isfinite(x))
                continue;
            lo[k] = x < lo[k] ? x : lo[k];
            hi[k] = x > hi[k] ? x : hi[k];
            any = true;
        }
    }
    return any;
}

ix_status ix__frame_of(ix_ctx *ctx, int n, const ix_mv *const *m, ix_frame *out)
{
    double lo[IX_MAX_COORDS], hi[IX_MAX_COORDS], size = 0.0, far = 0.0;
    bool any = false;

    *out = (ix_frame){.ncoords = 0};
    for (int i = 0; i < n; i++)
        if (m[i]->ncoords > out->ncoords)
            out->ncoords = m[i]->ncoords;
    for (int k = 0; k < IX_MAX_COORDS; k++) {
        lo[k] = HUGE_VAL;
        hi[k] = -HUGE_VAL;
    }
    for (int i = 0; i < n; i++)
        any |= grow(m[i], out->ncoords, lo, hi);
    if (!any)
        return IX_FAIL(ctx, IX_EDOMAIN, "all weights are zero");
    for (int k = 0; k < out->ncoords && lo[k] <= hi[k]; k++) {
        out->shift[k] = lo[k] / 2 + hi[k] / 2;
        size = fmax(size, hi[k] - out->shift[k]);
        far = fmax(far, fmax(fabs(lo[k]), fabs(hi[k])));
    }
    if (size > 0.0)
        (void)frexp(size, &out->exp);
    out->noise = ldexp(far, -out->exp) * 0x1p-53;
    return IX_OK;
}

bool ix__frame_centre(ix_frame *f, int nc, const double *at)
{
    for (int k = 0; k < nc; k++)
        if (!(fabs(ldexp(at[k] - f->shift[k], -f->exp)) <= 2.0))
            return false;
    for (int k = 0; k < nc; k++)
        f->shift[k] = at[k];
    f->exp += 2;
    f->noise *= 0.25;
    return true;
}

void ix__frame_back(const ix_frame *f, double factor, size_t n, const double *w,
                    double *x)
{
    const double scale = ldexp(factor, f->exp);

    for (int k = 0; k < f->ncoords; k++, x += n)
        for (size_t i = 0; i < n; i++)
            x[i] = x[i] * scale + f->shift[k] * (w ? w[i] : 1.0);
}
