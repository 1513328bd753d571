/* builtins_layout.c - surfaces as ruled strips, laid flat (chapter 13 of
 * spec/functions). */
#include <math.h>
#include <string.h>

#include "geom/ruled_pieces.h"
#include "iritx/geom_srf.h"
#include "lang/args_freeform.h"
#include "mv/mv.h"

/* n points at equal steps of one end curve (side 0 or 1) of the piece. */
static ix_status sample_side(ix_call *c, const ix_mv *piece, int side, int n,
                             double (*out)[3])
{
    double u[2], v[2];

    ix_mv_domain(piece, 0, u);
    ix_mv_domain(piece, 1, v);
    for (int i = 0; i < n; i++) {
        double x[IX_MAX_COORDS] = {0};
        double uv[2] = {i == n - 1 ? u[1] : u[0] + (u[1] - u[0]) * i / (n - 1),
                        v[side]};

        IX_TRY(ix_mv_point(c->ctx, piece, uv, x));
        memcpy(out[i], x, sizeof out[i]);
    }
    return IX_OK;
}

/* The flat strip with its lower left corner at (0, *y), which moves above it.
 */
static ix_status flat_strip(ix_call *c, int n, double (*const f[2])[2],
                            double *y, ix_mv **out)
{
    double lo[2] = {HUGE_VAL, HUGE_VAL}, top = -HUGE_VAL, *pts, *kv;
    ix_dir d[2] = {{IX_BSPLINE, 2, n, false, NULL},
                   {IX_BSPLINE, 2, 2, false, (const double[4]){0, 0, 1, 1}}};
    size_t total = 2 * (size_t)n;

    IX_SCRATCH(c->ctx, pts, 3 * total);
    IX_SCRATCH(c->ctx, kv, n + 2);
    IX_TRY(ix_knots_make(c->ctx, IX_KV_OPEN, 2, n, kv));
    d[0].knots = kv;
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < n; i++) {
            lo[0] = fmin(lo[0], f[side][i][0]);
            lo[1] = fmin(lo[1], f[side][i][1]);
            top = fmax(top, f[side][i][1]);
        }
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < n; i++) {
            size_t at = (size_t)side * (size_t)n + (size_t)i;

            pts[at] = f[side][i][0] - lo[0];
            pts[total + at] = f[side][i][1] - lo[1] + *y;
            pts[2 * total + at] = 0;
        }
    *y += top - lo[1];
    return ix_mv_new(c->ctx, 2, d, 3, false, pts, out);
}

static ix_status flatten(ix_call *c, const ix_mv *piece, int n, double *y,
                         ix_mv **out)
{
    double(*p)[3], (*q)[3], (*f[2])[2];

    IX_SCRATCH(c->ctx, p, n);
    IX_SCRATCH(c->ctx, q, n);
    IX_SCRATCH(c->ctx, f[0], n);
    IX_SCRATCH(c->ctx, f[1], n);
    IX_TRY(sample_side(c, piece, 0, n, p));
    IX_TRY(sample_side(c, piece, 1, n, q));
    ix__strip_flat(n, (const double(*)[3])p, (const double(*)[3])q, f[0], f[1]);
    return flat_strip(c, n, f, y, out);
}

/* Both end curves of a piece. */
static ix_status add_sections(ix_call *c, const ix_mv *piece, ix_obj *list)
{
    double dom[2];

    ix_mv_domain(piece, 1, dom);
    for (int side = 0; side < 2; side++) {
        ix_mv *crv;

        IX_TRY(ix_mv_fix(c->ctx, piece, 1, dom[side], &crv));
        IX_TRY(
            ix__list_add(c->ctx, list, ix__obj_mv(c->ctx, IX_OBJ_CURVE, crv)));
    }
    return IX_OK;
}

typedef struct {
    int dir, samples;
    bool flat, sections;
    double gap; /* between strips */
} layout;

static ix_status add_piece(ix_call *c, const layout *l, double a, double b,
                           double *y, ix_obj *list)
{
    ix_mv *piece, *flat = NULL;
    ix_status st;

    IX_TRY(ix__ruled_piece(c->ctx, ix__arg_mv(c, 0), l->dir, a, b, &piece));
    st = l->flat ? flatten(c, piece, l->samples, y, &flat) : IX_OK;
    *y += l->gap;
    if (st == IX_OK)
        st = ix__list_add(
            c->ctx, list,
            ix__obj_mv(c->ctx, IX_OBJ_SURFACE, flat ? flat : ix_mv_ref(piece)));
    if (st == IX_OK && l->sections)
        st = add_sections(c, piece, list);
    ix_mv_unref(c->ctx, piece);
    return st;
}

static ix_status prisa(ix_call *c)
{
    double eps = ix__arg_num(c, 2), space[3], *cut, y = 0;
    layout l = {.flat = eps > 0, .sections = ix__arg_bool(c, 5)};
    ix_obj *list;
    ix_status st;
    int n;

    IX_TRY(ix__arg_int(c, 1, 2, 10000, &l.samples));
    if (!(fabs(eps) > 0))
        return IX_ARG_FAIL(c, 2, "a tolerance of %g; it cannot be 0", eps);
    IX_TRY(ix__arg_dir(c, 3, 2, &l.dir));
    IX_TRY(ix__arg_vec3(c, 4, space));
    l.gap = space[1];
    IX_TRY(
        ix__ruled_pieces(c->ctx, ix__arg_mv(c, 0), l.dir, fabs(eps), &n, &cut));
    list = ix__obj_list(c->ctx);
    st = list ? IX_OK : IX_ENOMEM;
    for (int i = 0; st == IX_OK && i < n; i++)
        st = add_piece(c, &l, cut[i], cut[i + 1], &y, list);
    return ix__ret_list(c, list, st);
}

const ix_builtin ix__builtins_layout[] = {
    {"PRISA",
     "s:surface samples:num eps:num dir:num space:vector cross:bool -> list",
     "The surface as pieces in direction dir, each within |eps| of the ruled "
     "surface between its ends (a bound): with eps < 0 these ruled surfaces; "
     "with eps > 0 each of them as a strip of triangles between samples points "
     "laid flat into the XY plane, from x = 0 on, the y of space apart. With "
     "cross each is followed by its two end curves in space.",
     "s = spheresrf(1); l = prisa(s, 20, 0.05, ROW, vector(0.5, 0.1, 0), "
     "false);",
     prisa, 0, 13},
    {0}};
