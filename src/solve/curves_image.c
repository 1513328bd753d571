/* curves_image.c - curves of parameters as they are on a surface in space: how
 * far their polylines are from them there. */
#include <math.h>

#include "mv/mv.h"
#include "solve/curves_impl.h"

ix_status ix__curves_take_image(ix_ctx *ctx, const ix_curves_opts *o,
                                ix__curves *s)
{
    const ix_mv *m = o ? o->image : NULL;
    double lo[IX_MAX_COORDS], hi[IX_MAX_COORDS];

    if (!m)
        return IX_OK;
    if (o->image_at < 0 || o->image_at + m->ndirs > s->n)
        return IX_FAIL(ctx, IX_EARG,
                       "an image of %d parameters from unknown %d of %d on",
                       m->ndirs, o->image_at + 1, s->n);
    if (ix_mv_bbox(ctx, m, lo, hi) != IX_OK)
        return IX_OK; /* it has poles, and no size */
    for (int k = 0; k < m->ncoords; k++)
        s->image_size = fmax(s->image_size, hi[k] - lo[k]);
    s->image = s->image_size > 0 ? m : NULL;
    s->image_at = o->image_at;
    return IX_OK;
}

/* False at a pole. */
static bool point(const ix__curves *s, const double *t, double *out)
{
    const ix_mv *m = s->image;
    double h[IX_MAX_COORDS + 1];
    bool finite = true;

    if (ix_mv_eval(s->t.ctx, m, t + s->image_at, h) != IX_OK)
        return false;
    for (int k = 0; k < m->ncoords; k++) {
        out[k] = m->rational ? h[k + 1] / h[0] : h[k];
        finite = finite && isfinite(out[k]);
    }
    return finite;
}

double ix__curves_image_sag(const ix__curves *s, const double *p,
                            const double *x, const double *r)
{
    double a[IX_MAX_COORDS], b[IX_MAX_COORDS], e[IX_MAX_COORDS];
    double d = 0, t = 0, len = 0;
    int n = s->image->ncoords;

    if (!point(s, p, a) || !point(s, x, b) || !point(s, r, e))
        return 0;
    for (int k = 0; k < n; k++) {
        len += (e[k] - a[k]) * (e[k] - a[k]);
        t += (e[k] - a[k]) * (b[k] - a[k]);
    }
    t = len > 0 ? t / len : 0;
    for (int k = 0; k < n; k++) {
        double c = b[k] - a[k] - t * (e[k] - a[k]);

        d += c * c;
    }
    return sqrt(d) / s->image_size;
}
