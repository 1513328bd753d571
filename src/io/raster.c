/* raster.c - a z-buffer of triangles: what is hidden, and shading. */
#include <math.h>

#include "io/scene.h"

ix_status ix__raster_new(ix_ctx *ctx, int w, int h, ix_raster *out)
{
    size_t n = (size_t)w * (size_t)h;

    *out = (ix_raster){.w = w, .h = h};
    IX_SCRATCH(ctx, out->z, n);
    IX_SCRATCH_ZERO(ctx, out->shade, 3 * n);
    for (size_t i = 0; i < n; i++)
        out->z[i] = -HUGE_VAL;
    return IX_OK;
}

/* Light from the viewer's left shoulder on both sides of a surface, with a
 * floor so that nothing is black. */
static double light(const double *p, const double *q, const double *r)
{
    double a[3], b[3], n[3], len, d;

    for (int k = 0; k < 3; k++) {
        a[k] = q[k] - p[k];
        b[k] = r[k] - p[k];
    }
    n[0] = a[1] * b[2] - a[2] * b[1];
    n[1] = a[2] * b[0] - a[0] * b[2];
    n[2] = a[0] * b[1] - a[1] * b[0];
    len = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (!(len > 0))
        return 1;
    d = (-0.35 * n[0] - 0.45 * n[1] + 0.82 * n[2]) / len;
    return 0.35 + 0.65 * fabs(d);
}

static double edge(const double *p, const double *q, double x, double y)
{
    return (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
}

static void put_pixel(ix_raster *b, int x, int y, double z, double lit,
                      const double rgb[3])
{
    size_t at = (size_t)y * (size_t)b->w + (size_t)x;

    if (!(z > b->z[at]))
        return;
    b->z[at] = z;
    /* paper-like: colours are mixed with white before they are lit */
    for (int k = 0; k < 3; k++)
        b->shade[3 * at + (size_t)k] = (float)(lit * (0.55 + 0.45 * rgb[k]));
}

void ix__raster_triangle(ix_raster *b, const double *p, const double *q,
                         const double *r, const double rgb[3])
{
    double area = edge(p, q, r[0], r[1]), lit = light(p, q, r);
    double lo[2], hi[2];

    if (!(fabs(area) > 0) || !isfinite(area))
        return;
    for (int k = 0; k < 2; k++) {
        lo[k] = fmax(fmin(fmin(p[k], q[k]), r[k]), 0);
        hi[k] = fmin(fmax(fmax(p[k], q[k]), r[k]), (k ? b->h : b->w) - 1);
    }
    if (!(lo[0] <= hi[0] && lo[1] <= hi[1]))
        return;
    for (int y = (int)lo[1]; y <= (int)hi[1]; y++)
        for (int x = (int)lo[0]; x <= (int)hi[0]; x++) {
            double u = edge(q, r, x, y) / area, v = edge(r, p, x, y) / area;
            double w = 1 - u - v;

            if (u >= 0 && v >= 0 && w >= 0)
                put_pixel(b, x, y, u * p[2] + v * q[2] + w * r[2], lit, rgb);
        }
}

bool ix__raster_hides(const ix_raster *b, const double p[3], double slack)
{
    int x = (int)lrint(p[0]), y = (int)lrint(p[1]);
    double near = HUGE_VAL;

    /* the lowest of the neighbourhood: an outline is not hidden by the very
     * surface that it bounds */
    for (int j = y - 1; j <= y + 1; j++)
        for (int i = x - 1; i <= x + 1; i++) {
            if (i < 0 || j < 0 || i >= b->w || j >= b->h)
                return false;
            near = fmin(near, b->z[(size_t)j * (size_t)b->w + (size_t)i]);
        }
    return near > p[2] + slack;
}
