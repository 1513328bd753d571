/* trisector_impl.h - shared by the parts of MTRISECTOR (trisector.c).
 *
 * The unknowns z are the centre C and the parameters of the feet, each in
 * [0, 1] of its span; one more than equations:
 *
 *   (C - X_i).T_ia = 0            for each tangent T_ia of the foot X_i
 *   |C - X_0|^2 - |C - X_j|^2 = 0  for j = 1, 2 */
#ifndef OPS_TRISECTOR_IMPL_H
#define OPS_TRISECTOR_IMPL_H

#include "base/ctx.h"
#include "iritx/geom.h"
#include "mv/mv.h"

enum { IX__TRI_VARS = 9, IX__TRI_EQS = 8 };

/* --- objects (trisector_span.c) ------------------------------------------- */

/* A vector polynomial in Bernstein form, double[d1 + 1][d0 + 1][rows]. */
typedef struct {
    int rows, deg[2];
    const double *c;
} ix__tri_field;

/* A Bezier piece of an object with 0 .. 2 parameters. */
typedef struct {
    int ndirs;
    bool rational;
    ix__tri_field p;    /* w, x, y, z */
    ix__tri_field d[2]; /* X_a = d_a / w^2 */
    ix__tri_field t[2]; /* d_a without the factors that vanish on a whole edge:
                           tangents at poles too */
    double part[2];     /* of the object's domain */
    double *room[8];    /* for the largest field */
    const double *weight[2][2]; /* of the products p t_a in each direction */
    double *last;    /* lo, hi of each parameter: the box of what is in room */
    double *product; /* for w (c - X).T_a */
} ix__tri_span;

typedef struct {
    int ndirs, nspans;
    ix__tri_span *span;
} ix__tri_object;

/* A foot: point, derivatives, tangents, their derivatives e_ab = T_a,b. */
typedef struct {
    double w, x[3], d[2][3], t[2][3], e[2][2][3];
} ix__tri_jet;

/* A curve of order 1. */
static inline bool ix__is_point(const ix_mv *m)
{
    return m->ndirs == 1 && m->dirs[0].order == 1;
}

/* In scratch. Err IX_EDOMAIN one of its directions does not move the point. */
ix_status ix__tri_object_of(ix_ctx *ctx, int which, const ix_mv *m,
                            ix__tri_object *out) IX_MUST_CHECK;
/* At u[ndirs], which may be outside [0, 1]; infinite at a pole of the weight.
 */
void ix__tri_jet_at(const ix__tri_span *s, const double *u, ix__tri_jet *out);
/* Middles and half widths of all values over lo <= u <= hi; false if the weight
 * may vanish there. */
bool ix__tri_bounds(const ix__tri_span *s, const double *lo, const double *hi,
                    ix__tri_jet *mid, ix__tri_jet *half);
/* Those of the derivatives of w (c - X).T_a in the parameters there, and of w.
 */
typedef struct {
    double g[2][2], h[2][2], w, hw;
} ix__tri_turn;
void ix__tri_turning(const ix__tri_span *s, const double *lo, const double *hi,
                     const double c[3], ix__tri_turn *out);

/* --- equations (trisector_system.c) --------------------------------------- */

typedef struct {
    int nvars, neqs;
    int ndirs[3], at[3]; /* parameters of each object, the first's index */
} ix__tri_shape;

typedef double ix__tri_matrix[IX__TRI_EQS][IX__TRI_VARS];

ix__tri_shape ix__tri_shape_of(const int ndirs[3]);

void ix__tri_values(const ix__tri_shape *s, const double c[3],
                    const ix__tri_jet *const j[3], double f[IX__TRI_EQS]);
/* The Jacobian at C with given jets. */
void ix__tri_jacobian(const ix__tri_shape *s, const double c[3],
                      const ix__tri_jet *const j[3], ix__tri_matrix out);
/* Half width of a.b, for half widths ha and hb of a and b. */
double ix__tri_dot_half(const double a[3], const double ha[3],
                        const double b[3], const double hb[3]);
/* Middle and half width of the Jacobian over boxes of C and of jets. */
void ix__tri_jacobian_bounds(const ix__tri_shape *s, const double c[3],
                             const double half[3],
                             const ix__tri_jet *const mid[3],
                             const ix__tri_jet *const rad[3],
                             ix__tri_matrix out, ix__tri_matrix out_rad);

/* inv M = the unit matrix in all columns but free, where it is slope: row r is
 * the unknown of[r], whose derivative in the free one is -slope[r], at most
 * about 1. */
typedef struct {
    int free, of[IX__TRI_EQS];
    double slope[IX__TRI_EQS];
    double inv[IX__TRI_EQS][IX__TRI_EQS];
} ix__tri_inverse;
/* False if the rows are dependent. fixed: the free unknown, or -1: the one that
 * changes most. */
bool ix__tri_invert(const ix__tri_shape *s, ix__tri_matrix m, int fixed,
                    ix__tri_inverse *out);

/* --- curves (trisector_walk.c) -------------------------------------------- */

/* A polyline in the parameters of one span of each object. */
typedef struct {
    int span[3], n;
    double *z; /* double[n][nvars] */
    bool closed;
} ix__tri_arc;

typedef struct {
    ix_ctx *ctx;
    ix__tri_object object[3];
    ix__tri_shape shape;
    const double *box; /* lo[3], hi[3] */
    double size;       /* its longest edge */
    double step;       /* of size and of the domains of the parameters */
    ix__tri_arc *arc;
    int narcs, cap;
    bool complete;
} ix__tri_task;

/* Spheres smaller than this part of the box end a curve: at a point that all
 * three objects share the equations say nothing any more. */
#define IX__TRI_TINY 1e-5
/* Parameters this far outside of a span are on its border. */
#define IX__TRI_BORDER 1e-9

/* Newton's method in all unknowns but fixed; false if it does not converge. */
bool ix__tri_correct(const ix__tri_task *k, const int span[3], int fixed,
                     double *z);
/* Whether z, of the curve, is in the box and in the spans, and its sphere is
 * not too small. */
bool ix__tri_inside(const ix__tri_task *k, const int span[3], const double *z);
/* Appends the curve through z, to both sides, unless it is there already. */
ix_status ix__tri_trace(ix__tri_task *k, const int span[3],
                        const double *z) IX_MUST_CHECK;

/* --- feet (trisector_feet.c) ---------------------------------------------- */

/* A box of centres: middle, half widths. */
typedef struct {
    double c[3], h[3];
} ix__tri_box;

/* A box of parameters. */
typedef struct {
    int span;
    double mid[2], half[2];
} ix__tri_place;

/* The same with its values in the middle, and their middles and half widths;
 * bounded is false where the weight may vanish. */
typedef struct {
    int span;
    double mid[2], half[2];
    bool bounded;
    ix__tri_jet at, m, h;
} ix__tri_foot;

typedef struct {
    ix__tri_foot *f;
    int n, cap;
} ix__tri_feet;

/* Of a box, how far normal planes of a foot's parameters may move in it. */
#define IX__TRI_COARSE 1.0

/* The values of f, whose place is given; the bounds hold for a box larger by
 * the margin, a part of its half widths. */
void ix__tri_measure(const ix__tri_object *o, double margin, ix__tri_foot *f);
double ix__tri_diameter(const ix__tri_box *b);
/* Bounds of the distances from points of the box to points of the foot. */
void ix__tri_distances(const ix__tri_box *b, const ix__tri_foot *f,
                       double d[2]);
/* Appends boxes of parameters that hold the feet, on the object within from[n],
 * of all normals through the box at distances between those given. */
ix_status ix__tri_feet_in(ix_ctx *ctx, const ix__tri_object *object,
                          const ix__tri_box *b, const double distance[2],
                          const ix__tri_place *from, int n,
                          ix__tri_feet *out) IX_MUST_CHECK;

/* --- arcs (trisector_arc.c) ----------------------------------------------- */

/* Of half widths: the larger box in which an arc is proven. */
#define IX__TRI_MARGIN 0.5

/* The equations on a box of centres and one foot of each object, unknowns from
 * -1 to 1. Row r says, with e <= sum of err[r][l] |z_l|,
 *
 *   z_of = at0[r] - slope[r] z_free +- e */
typedef struct {
    const ix__tri_foot *p[3];
    double half[IX__TRI_VARS];
    ix__tri_inverse inv; /* free: -1 if there is none */
    double at0[IX__TRI_EQS], err[IX__TRI_EQS][IX__TRI_VARS];
    ix__tri_matrix rad; /* of the Jacobian */
    double range[IX__TRI_VARS]
                [2]; /* of the unknowns, as far as they are left */
} ix__tri_linear;

/* No solution is in the box; for each value of the free unknown in its range
 * exactly one is in the larger box, and the others of the box are not in it;
 * or neither could be proven. l->p is given. */
typedef enum { IX__TRI_NONE, IX__TRI_ARC, IX__TRI_UNDECIDED } ix__tri_verdict;
ix__tri_verdict ix__tri_judge(const ix__tri_task *k, const ix__tri_box *b,
                              ix__tri_linear *l);
/* Whether the arc is known to a box's half width, so that the box is best
 * halved across it. */
bool ix__tri_is_tube(const ix__tri_task *k, const ix__tri_linear *l);

/* --- search (trisector_search.c) ------------------------------------------ */

/* All curves in the box. */
ix_status ix__tri_search(ix__tri_task *k) IX_MUST_CHECK;

/* --- polylines (trisector_join.c) ----------------------------------------- */

/* The arcs joined where they go on over the borders of spans. */
ix_status ix__tri_join(ix__tri_task *k, ix_lines *out) IX_MUST_CHECK;

#endif
