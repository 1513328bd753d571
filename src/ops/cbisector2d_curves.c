/* cbisector2d_curves.c - untrimmed bisectors of two planar curves as polylines:
 * the solution curves of the correspondence, mapped to where the normals meet.
 */
#include <math.h>

#include "geom/lines.h"
#include "geom/parts.h"
#include "geom/path.h"
#include "iritx/ops_plane.h"
#include "mv/mv.h"
#include "ops/plane_bisector.h"
#include "sym/form.h"

/* Points farther away than this many sizes of both curves are left out. */
#define REACH 10.0
/* Normals that make a smaller angle are parallel: their meeting point has no
 * digits left. */
#define PARALLEL 1e-12

typedef struct {
    ix_path p[2];
    double mid[2], reach;
    bool facing;
} mapping;

/* The point where the normals at st meet; false if it is not wanted. */
static bool point_at(const mapping *k, const double *st, double out[3])
{
    double d[2][2][3], v[2], cross, along, size[2], dot;

    for (int i = 0; i < 2; i++) {
        ix__path_derivs3(&k->p[i], ix__path_span(&k->p[i], st[i]), st[i], 1,
                         d[i]);
        size[i] = hypot(d[i][1][0], d[i][1][1]);
    }
    cross = d[0][1][0] * d[1][1][1] - d[0][1][1] * d[1][1][0];
    dot = d[0][1][0] * d[1][1][0] + d[0][1][1] * d[1][1][1];
    if (!(fabs(cross) > PARALLEL * size[0] * size[1]) ||
        (k->facing && dot > 0.0))
        return false;
    for (int i = 0; i < 2; i++)
        v[i] = d[1][0][i] - d[0][0][i];
    along = (v[0] * d[1][1][0] + v[1] * d[1][1][1]) / cross;
    out[0] = d[0][0][0] - d[0][1][1] * along;
    out[1] = d[0][0][1] + d[0][1][0] * along;
    out[2] = 0.0;
    return hypot(out[0] - k->mid[0], out[1] - k->mid[1]) <= k->reach;
}

/* Vertices of one solution curve, in parts where they are left out; parts of a
 * single point are dropped. */
static void collect(const mapping *k, const ix_solution_curve *c, size_t *used,
                    ix_lines *out)
{
    bool open = false;

    for (int i = 0; i <= c->n; i++) {
        if (i < c->n && point_at(k, c->x + 2 * i, out->pt[*used])) {
            if (!open)
                out->count[out->n++] = 0;
            open = true;
            out->count[out->n - 1]++;
            (*used)++;
        } else if (open) {
            open = false;
            if (out->count[out->n - 1] == 1) {
                out->n--;
                (*used)--;
            }
        }
    }
}

static ix_status map_all(ix_ctx *ctx, const mapping *k,
                         const ix_solution_curves *s, ix_lines *out)
{
    size_t total = 0, used = 0;

    for (int i = 0; i < s->ncurves; i++)
        total += (size_t)s->curve[i].n;
    IX_TRY(ix__lines_new(ctx, total, out));
    for (int i = 0; i < s->ncurves; i++)
        collect(k, &s->curve[i], &used, out);
    return IX_OK;
}

static ix_status run(ix_ctx *ctx, const ix_mv *const *c, double tol,
                     bool facing, ix_lines *out)
{
    const ix_curves_opts o = {.tol = tol};
    ix_equation eq = {.rel = IX_EQUAL_ZERO};
    mapping k = {.facing = facing};
    ix_solution_curves s = {0};
    ix_frame frame;
    ix_status st;
    ix_mv *f;

    IX_TRY(ix__frame_of(ctx, 2, c, &frame));
    for (int i = 0; i < 2; i++) {
        k.mid[i] = frame.shift[i];
        IX_TRY(ix__path_new(ctx, c[i], &k.p[i]));
    }
    k.reach = ldexp(REACH, frame.exp);
    IX_TRY(ix_cbisector2d(ctx, c[0], c[1], 3, NULL, &f));
    eq.f = f;
    st = ix_solve_curves(ctx, 1, &eq, &o, &s);
    ix_mv_unref(ctx, f);
    IX_TRY(st);
    st = map_all(ctx, &k, &s, out);
    ix_solution_curves_free(ctx, &s);
    return st;
}

static ix_status scoped(ix_ctx *ctx, const ix_mv *const *c, double tol,
                        bool facing, ix_lines *out)
{
    ix_mv **flat;
    ix_status st;

    IX_TRY(ix__bisector_tol(ctx, tol, &tol));
    IX_TRY(ix__plane_curves(ctx, 2, c, &flat));
    st = run(ctx, (const ix_mv *const *)flat, tol, facing, out);
    ix__mv_unref_all(ctx, flat, 2);
    return st;
}

ix_status ix_cbisector2d_curves(ix_ctx *ctx, const ix_mv *c1, const ix_mv *c2,
                                double tol, bool facing, ix_lines *out)
{
    const ix_mv *const c[2] = {c1, c2};

    *out = (ix_lines){0};
    IX_RETURN_SCOPED(ctx, scoped(ctx, c, tol, facing, out));
}
