/* view_camera.c - viewpoints. What is upwards in X3D is y, and viewers keep it
 * so while the scene is turned; ours is z, but in drawings, where it is y. So
 * all but drawings are put into X3D with (x, y, z) at (x, z, -y). */
#include "app/view_camera.h"

#include <math.h>

/* Unit vectors of ours to the eye and upwards. */
static const struct {
    const char *name;
    double back[3], up[3];
} views[] = {
    {"3D",
     {0.5, -0.7, 0.50990195135927848},
     {-0.29637322, 0.41492251, 0.86023253}},
    {"Top", {0, 0, 1}, {0, 1, 0}},
    {"Front", {0, -1, 0}, {0, 0, 1}},
    {"Side", {1, 0, 0}, {0, 0, 1}},
};

typedef struct {
    double mid[3], size; /* of the box of all objects: middle, diagonal */
    bool flat;           /* a drawing */
} extent;

static extent extent_of(ix_ctx *ctx, const ix_obj *list)
{
    extent e = {{0}, 0, false};
    double box[6];

    if (ix__obj_bbox(ctx, list, box) == IX_OK) {
        for (int k = 0; k < 3; k++) {
            e.mid[k] = (box[2 * k] + box[2 * k + 1]) / 2;
            e.size = hypot(e.size, box[2 * k + 1] - box[2 * k]);
        }
        e.flat = box[4] == box[5];
    }
    if (!(e.size > 0 && isfinite(e.size)))
        e = (extent){{0}, 1, false}; /* nothing that has a size */
    return e;
}

static void to_x3d(const extent *e, const double v[3], double out[3])
{
    out[0] = v[0];
    out[1] = e->flat ? v[1] : v[2];
    out[2] = e->flat ? v[2] : -v[1];
}

/* The rotation that turns z to back and y to up, as an axis, and the angle in
 * axis[3] (Euler's theorem; none of ours is half a turn). */
static void rotation(const double back[3], const double up[3], double axis[4])
{
    const double right[3] = {up[1] * back[2] - up[2] * back[1],
                             up[2] * back[0] - up[0] * back[2],
                             up[0] * back[1] - up[1] * back[0]};
    double cosine = (right[0] + up[1] + back[2] - 1) / 2, length;

    axis[0] = up[2] - back[1];
    axis[1] = back[0] - right[2];
    axis[2] = right[1] - up[0];
    axis[3] = acos(fmax(-1, fmin(1, cosine)));
    length = hypot(hypot(axis[0], axis[1]), axis[2]);
    if (length == 0)
        axis[2] = 1; /* any will do */
    for (int k = 0; length > 0 && k < 3; k++)
        axis[k] /= length;
}

/* The sphere around the box fits into X3D's field of view of pi / 4. */
static void add_viewpoint(ix_buf *b, const extent *e, int i)
{
    int v = i == 0 && e->flat ? 1 : i;
    double back[3], up[3], mid[3], axis[4], far = 1.35 * e->size;

    to_x3d(e, views[v].back, back);
    to_x3d(e, views[v].up, up);
    to_x3d(e, e->mid, mid);
    rotation(back, up, axis);
    ix__buf_printf(b,
                   "<Viewpoint DEF=\"iritx_v%d\" description=\"%s\" "
                   "position=\"%.9g %.9g %.9g\" ",
                   i, views[i].name, mid[0] + far * back[0],
                   mid[1] + far * back[1], mid[2] + far * back[2]);
    ix__buf_printf(b,
                   "orientation=\"%.9g %.9g %.9g %.9g\" "
                   "centerOfRotation=\"%.9g %.9g %.9g\"/>\n",
                   axis[0], axis[1], axis[2], axis[3], mid[0], mid[1], mid[2]);
}

void view_camera_begin(ix_buf *b, const ix_obj *list)
{
    extent e = extent_of(b->ctx, list);

    for (int i = 0; i < 4; i++)
        add_viewpoint(b, &e, i);
    ix__buf_puts(b, e.flat ? "<Transform>\n"
                           : "<Transform rotation=\"1 0 0 "
                             "-1.5707963267948966\">\n");
}

void view_camera_end(ix_buf *b)
{
    ix__buf_puts(b, "</Transform>\n");
}
