/* draw.c - pictures of objects through cairo.
 *
 * A scene's points are projected once; triangles fill a z-buffer that tells
 * which parts of lines are hidden; then lines are drawn, hidden and far parts
 * lighter. Cairo's own memory is the only one here that is not the context's.
 */
#include "draw/draw.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/scene.h"

#define MARGIN        36.0 /* pixels around the content */
#define FLAT          0.02 /* pixels from its chord: a vertex that does not show */
#define MOST_LEFT_OUT 32 /* vertices in a row: bounds the work for one */

typedef struct {
    ix_ctx *ctx;
    const draw_opts *o;
    ix_scene scene;
    bool plane;           /* axes and grid are shown */
    double w, h;          /* of the picture */
    double (*p)[3];       /* [npts]: pixels, y down; depth towards the viewer */
    double scale, dx, dy; /* pixel = scale * view + d (y turned) */
    double near, far;     /* range of depths */
    ix_raster raster;     /* empty without triangles */
    cairo_t *cr;
} picture;

/* --- projection --------------------------------------------------------------
 */

static void choose_view(const picture *d, double m[16])
{
    if (d->o->has_view)
        memcpy(m, d->o->view, 16 * sizeof *m);
    else if (d->scene.has_view)
        memcpy(m, d->scene.view, 16 * sizeof *m);
    else
        (void)ix__view_named(ix__scene_is_plane(&d->scene) ? "top" : "iso", m);
}

static ix_status project(picture *d)
{
    double m[16];

    choose_view(d, m);
    IX_SCRATCH(d->ctx, d->p, d->scene.npts);
    for (size_t i = 0; i < d->scene.npts; i++) {
        const double *x = d->scene.pts[i];
        double v[4];

        for (int c = 0; c < 4; c++)
            v[c] = x[0] * m[c] + x[1] * m[4 + c] + x[2] * m[8 + c] + m[12 + c];
        for (int c = 0; c < 3; c++)
            d->p[i][c] = v[3] != 0 ? v[c] / v[3] : v[c];
    }
    return IX_OK;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

#define FAR 20 /* times the distance within which three quarters lie */

/* How far from the middle points count for coordinate c: a surface that runs
 * through infinity shall not shrink all the rest to a dot. */
static ix_status reach(const picture *d, int c, double *mid, double *far)
{
    size_t n = d->scene.npts;
    double *v;

    IX_SCRATCH(d->ctx, v, n);
    for (size_t i = 0; i < n; i++)
        v[i] = d->p[i][c];
    qsort(v, n, sizeof *v, compare);
    *mid = v[n / 2];
    for (size_t i = 0; i < n; i++)
        v[i] = fabs(d->p[i][c] - *mid);
    qsort(v, n, sizeof *v, compare);
    *far = v[n - 1 - n / 4] > 0 ? FAR * v[n - 1 - n / 4] : HUGE_VAL;
    return IX_OK;
}

static ix_status bounds(const picture *d, double lo[3], double hi[3])
{
    for (int c = 0; c < 3; c++) {
        double mid, far;

        lo[c] = HUGE_VAL;
        hi[c] = -HUGE_VAL;
        IX_TRY(reach(d, c, &mid, &far));
        for (size_t i = 0; i < d->scene.npts; i++)
            if (fabs(d->p[i][c] - mid) <= far) {
                lo[c] = fmin(lo[c], d->p[i][c]);
                hi[c] = fmax(hi[c], d->p[i][c]);
            }
    }
    return IX_OK;
}

/* Cairo counts in 24 bits before the point. */
static double pixel(double x)
{
    return fmin(fmax(x, -1e5), 1e5);
}

/* The content fills the picture, or the picture takes its shape. */
static ix_status place(picture *d)
{
    double lo[3], hi[3], ex, ey, left = d->plane ? MARGIN + 14 : MARGIN;

    IX_TRY(bounds(d, lo, hi));
    ex = fmax(hi[0] - lo[0], 1e-12 * fmax(fabs(lo[0]), 1e-300));
    ey = fmax(hi[1] - lo[1], 1e-12 * fmax(fabs(lo[1]), 1e-300));
    ex = fmax(ex, 1e-6 * ey);
    ey = fmax(ey, 1e-6 * ex);
    d->scale = fmin((d->w - left - MARGIN) / ex, (d->h - 2 * MARGIN) / ey);
    if (d->o->fit) {
        d->w = ceil(ex * d->scale + left + MARGIN);
        d->h = ceil(ey * d->scale + 2 * MARGIN);
    }
    d->dx = left + 0.5 * (d->w - left - MARGIN - d->scale * (lo[0] + hi[0]));
    d->dy = 0.5 * (d->h + d->scale * (lo[1] + hi[1]));
    for (size_t i = 0; i < d->scene.npts; i++) {
        d->p[i][0] = pixel(d->dx + d->scale * d->p[i][0]);
        d->p[i][1] = pixel(d->dy - d->scale * d->p[i][1]);
        d->p[i][2] *= d->scale; /* one unit for all three: light needs it */
    }
    d->far = lo[2] * d->scale;
    d->near = hi[2] * d->scale;
    return IX_OK;
}

static ix_status fill_raster(picture *d)
{
    const ix_scene *s = &d->scene;

    if (s->ntris == 0)
        return IX_OK;
    IX_TRY(ix__raster_new(d->ctx, (int)d->w, (int)d->h, &d->raster));
    for (size_t i = 0; i < s->ntris; i++) {
        const ix_tri *t = &s->tri[i];

        ix__raster_triangle(&d->raster, d->p[t->v[0]], d->p[t->v[1]],
                            d->p[t->v[2]], t->rgb);
    }
    return IX_OK;
}

/* --- axes and grid
 * -------------------------------------------------------------- */

/* A step of 1, 2 or 5 times a power of ten, about 60 pixels wide. */
static double grid_step(const picture *d)
{
    double want = 60 / d->scale, p = pow(10, floor(log10(want)));

    return want / p > 5   ? 10 * p
           : want / p > 2 ? 5 * p
           : want / p > 1 ? 2 * p
                          : p;
}

static void label(const picture *d, double x, double y, double v, bool left)
{
    char text[IX_NUM_MAX + 8];
    cairo_text_extents_t e;

    (void)snprintf(text, sizeof text, "%.6g", v);
    cairo_text_extents(d->cr, text, &e);
    cairo_move_to(d->cr, left ? x - e.width - 4 : x - e.width / 2,
                  left ? y + e.height / 2 : y + e.height + 4);
    cairo_show_text(d->cr, text);
    cairo_new_path(d->cr);
}

static void grid_line(const picture *d, bool vertical, double at, bool axis)
{
    cairo_set_source_rgb(d->cr, axis ? 0.55 : 0.88, axis ? 0.55 : 0.88,
                         axis ? 0.55 : 0.88);
    cairo_set_line_width(d->cr, axis ? 1.0 : 0.6);
    cairo_move_to(d->cr, vertical ? at : MARGIN + 10,
                  vertical ? d->h - MARGIN + 10 : at);
    cairo_line_to(d->cr, vertical ? at : d->w - MARGIN + 10,
                  vertical ? MARGIN - 10 : at);
    cairo_stroke(d->cr);
}

static void draw_grid(const picture *d)
{
    double step = grid_step(d);

    cairo_set_font_size(d->cr, 10);
    for (int k = 0; k < 2; k++) {
        bool vertical = k == 0;
        double a = vertical ? (MARGIN + 10 - d->dx) / d->scale
                            : (d->dy - d->h + MARGIN - 10) / d->scale;
        double b = vertical ? (d->w - MARGIN + 10 - d->dx) / d->scale
                            : (d->dy - MARGIN + 10) / d->scale;

        for (double i = ceil(a / step); i * step <= b; i++) {
            double v = i != 0 ? i * step : 0; /* no "-0" */
            double at = vertical ? d->dx + d->scale * v : d->dy - d->scale * v;

            grid_line(d, vertical, at, i == 0);
            cairo_set_source_rgb(d->cr, 0.4, 0.4, 0.4);
            if (vertical)
                label(d, at, d->h - MARGIN + 10, v, false);
            else
                label(d, MARGIN + 10, at, v, true);
        }
    }
}

/* --- lines
 * ------------------------------------------------------------------------ */

/* How much a stretch of a line is mixed with white: 0 near and visible. */
static double paleness(const picture *d, const double *a, const double *b)
{
    double range = d->near - d->far, mid[3], pale = 0;

    for (int c = 0; c < 3; c++)
        mid[c] = 0.5 * (a[c] + b[c]);
    if (range > 0)
        pale = 0.4 * floor(4 * (d->near - mid[2]) / range) / 4;
    if (d->raster.z && ix__raster_hides(&d->raster, mid, 1.5))
        pale = d->o->shade ? 1 : 0.75;
    return pale;
}

static void stroke(const picture *d, const ix_path *p, double pale)
{
    if (pale < 1) {
        double k = 1 - pale;

        cairo_set_source_rgb(d->cr, 1 - k * (1 - p->rgb[0]),
                             1 - k * (1 - p->rgb[1]), 1 - k * (1 - p->rgb[2]));
        cairo_set_line_width(d->cr, p->width * (pale > 0.7 ? 0.6 : 1));
        cairo_stroke(d->cr);
    } else {
        cairo_new_path(d->cr);
    }
}

static const double *vertex(const picture *d, const ix_path *p, size_t i)
{
    return d->p[p->first + i % p->n];
}

/* Are all vertices between i and j within FLAT pixels of their chord? */
static bool on_chord(const picture *d, const ix_path *p, size_t i, size_t j)
{
    const double *a = vertex(d, p, i), *b = vertex(d, p, j);
    double ux = b[0] - a[0], uy = b[1] - a[1], len = hypot(ux, uy);

    for (size_t k = i + 1; k < j; k++) {
        const double *v = vertex(d, p, k);
        double x = v[0] - a[0], y = v[1] - a[1], along = x * ux + y * uy;

        if (!(fabs(x * uy - y * ux) <= FLAT * len) || !(along > 0) ||
            along > len * len)
            return false;
    }
    return true;
}

/* A path in stretches of equal paleness, without vertices that do not show:
 * from is the last one drawn. */
static void draw_line(const picture *d, const ix_path *p)
{
    size_t n = p->n + (p->closed && p->n > 2), from = 0;
    double last = -1;

    for (size_t i = 0; i + 1 < n; i++) {
        const double *a = vertex(d, p, i);
        double pale = paleness(d, a, vertex(d, p, i + 1));
        bool turn = pale < last || pale > last;

        if (last >= 0 && (turn || i - from >= MOST_LEFT_OUT ||
                          !on_chord(d, p, from, i + 1))) {
            cairo_line_to(d->cr, a[0], a[1]);
            from = i;
        }
        if (turn) {
            if (last >= 0)
                stroke(d, p, last);
            cairo_move_to(d->cr, a[0], a[1]);
            from = i;
            last = pale;
        }
    }
    if (last >= 0) {
        const double *b = vertex(d, p, n - 1);

        cairo_line_to(d->cr, b[0], b[1]);
        stroke(d, p, last);
    }
}

static void draw_net(const picture *d, const ix_path *p)
{
    const double dash[2] = {4, 3};

    cairo_set_source_rgb(d->cr, 0.55, 0.55, 0.55);
    cairo_set_line_width(d->cr, 0.8);
    cairo_set_dash(d->cr, dash, 2, 0);
    for (size_t i = 0; i < p->n; i++)
        cairo_line_to(d->cr, d->p[p->first + i][0], d->p[p->first + i][1]);
    if (p->closed)
        cairo_close_path(d->cr);
    cairo_stroke(d->cr);
    cairo_set_dash(d->cr, NULL, 0, 0);
    for (size_t i = 0; i < p->n; i++) {
        cairo_rectangle(d->cr, d->p[p->first + i][0] - 1.8,
                        d->p[p->first + i][1] - 1.8, 3.6, 3.6);
        cairo_fill(d->cr);
    }
}

static void draw_points(const picture *d, const ix_path *p)
{
    for (size_t i = 0; i < p->n; i++) {
        const double *x = d->p[p->first + i];

        cairo_new_sub_path(d->cr);
        cairo_arc(d->cr, x[0], x[1], p->kind == IX_PATH_KNOT ? 2.4 : 2.8, 0,
                  2 * acos(-1.0));
        if (p->kind == IX_PATH_KNOT) {
            cairo_set_source_rgb(d->cr, 1, 1, 1);
            cairo_fill_preserve(d->cr);
            cairo_set_line_width(d->cr, 1);
        }
        cairo_set_source_rgb(d->cr, p->rgb[0], p->rgb[1], p->rgb[2]);
        if (p->kind == IX_PATH_KNOT)
            cairo_stroke(d->cr);
        else
            cairo_fill(d->cr);
    }
}

/* Nets below lines below points. */
static void draw_paths(const picture *d)
{
    for (int layer = 0; layer < 3; layer++)
        for (size_t i = 0; i < d->scene.npaths; i++) {
            const ix_path *p = &d->scene.path[i];

            if (layer == 0 && p->kind == IX_PATH_NET)
                draw_net(d, p);
            else if (layer == 1 &&
                     (p->kind == IX_PATH_LINE || p->kind == IX_PATH_EDGE))
                draw_line(d, p);
            else if (layer == 2 &&
                     (p->kind == IX_PATH_POINT || p->kind == IX_PATH_KNOT))
                draw_points(d, p);
        }
}

/* The raster's colours as an image under the lines. */
static void draw_shading(const picture *d)
{
    const ix_raster *b = &d->raster;
    cairo_surface_t *s = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, b->w,
                                                    b->h);
    unsigned char *data = cairo_image_surface_get_data(s);
    int stride = cairo_image_surface_get_stride(s);

    for (int y = 0; data && y < b->h; y++)
        for (int x = 0; x < b->w; x++) {
            size_t at = (size_t)y * (size_t)b->w + (size_t)x;
            uint32_t v = 0;

            for (size_t k = 0; k < 3; k++)
                v = v << 8 |
                    (uint32_t)lrintf(255 * fminf(b->shade[3 * at + k], 1));
            v = isfinite(b->z[at]) ? v | 0xff000000u : 0;
            memcpy(data + (size_t)y * (size_t)stride + 4 * (size_t)x, &v, 4);
        }
    cairo_surface_mark_dirty(s);
    cairo_set_source_surface(d->cr, s, 0, 0);
    cairo_paint(d->cr);
    cairo_surface_destroy(s);
}

/* --- output
 * ------------------------------------------------------------------------- */

static cairo_status_t to_buffer(void *closure, const unsigned char *data,
                                unsigned int n)
{
    ix_buf *b = closure;

    ix__buf_add(b, (const char *)data, n);
    return b->failed ? CAIRO_STATUS_NO_MEMORY : CAIRO_STATUS_SUCCESS;
}

static cairo_surface_t *open_surface(const picture *d, ix_buf *out)
{
    switch (d->o->format) {
    case DRAW_SVG:
        return cairo_svg_surface_create_for_stream(to_buffer, out, d->w, d->h);
    case DRAW_PDF:
        return cairo_pdf_surface_create_for_stream(to_buffer, out, d->w, d->h);
    default:
        return cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)d->w,
                                          (int)d->h);
    }
}

static ix_status render(picture *d, ix_buf *out)
{
    cairo_surface_t *s = open_surface(d, out);
    cairo_status_t st;

    d->cr = cairo_create(s);
    cairo_set_source_rgb(d->cr, 1, 1, 1);
    cairo_paint(d->cr);
    cairo_set_line_join(d->cr, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(d->cr, CAIRO_LINE_CAP_ROUND);
    if (d->plane)
        draw_grid(d);
    if (d->o->shade && d->raster.z)
        draw_shading(d);
    draw_paths(d);
    st = cairo_status(d->cr);
    cairo_destroy(d->cr);
    if (st == CAIRO_STATUS_SUCCESS && d->o->format == DRAW_PNG)
        st = cairo_surface_write_to_png_stream(s, to_buffer, out);
    cairo_surface_finish(s);
    if (st == CAIRO_STATUS_SUCCESS)
        st = cairo_surface_status(s);
    cairo_surface_destroy(s);
    IX_TRY(ix__buf_check(out));
    if (st != CAIRO_STATUS_SUCCESS)
        return IX_FAIL(d->ctx, IX_EUNABLE, "cairo: %s",
                       cairo_status_to_string(st));
    return IX_OK;
}

static ix_status make(ix_ctx *ctx, const ix_obj *o, const draw_opts *opts,
                      ix_buf *out)
{
    const ix_scene_opts so = {
        .net = opts->net, .knots = opts->knots, .mesh = true};
    picture d = {.ctx = ctx, .o = opts};

    IX_TRY(ix__scene_build(ctx, o, &so, &d.scene));
    if (d.scene.npts == 0)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "nothing to draw: no curve, surface, polyline or "
                       "point");
    d.plane = ix__scene_is_plane(&d.scene) && !opts->has_view &&
              !d.scene.has_view && !opts->no_axes;
    d.w = opts->width > 0 ? opts->width : 900;
    d.h = opts->height > 0 ? opts->height : 700;
    IX_TRY(project(&d));
    IX_TRY(place(&d));
    IX_TRY(fill_raster(&d));
    return render(&d, out);
}

ix_status ix__draw_picture(ix_buf *out, const ix_obj *o, const draw_opts *d)
{
    ix_mark mk = ix__scratch_mark(out->ctx);
    ix_status st = make(out->ctx, o, d, out);

    ix__scratch_release(out->ctx, mk);
    return st;
}
