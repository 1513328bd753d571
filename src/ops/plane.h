/* plane.h - sets of planar curves and points, the circles that touch them, and
 * the walk along the border of one set that finds what is equally far from
 * another.
 *
 * A set is cut into Bezier spans, joined at smooth joints or at vertices: ends
 * of curves, corners, cusps, single points. Its border is walked as loops of
 * elements: a side of a span, or a fan, in which the normal turns at a vertex.
 * Each place of the border has one circle that touches there, lies on that
 * side and is the largest that holds no point of the other set: the other set's
 * curvature as seen from c in direction n is
 *
 *   kappa = max over points x of  2 n.(x - c) / |x - c|^2 ,   radius 1 / kappa
 *
 * (n.y over the inverted points y = (x - c)/|x - c|^2: the support function of
 * the inverted set). The centre is on the bisector of both sets if that circle
 * holds no point of the own set either. So the bisector is a function on the
 * border of one set; its pieces begin and end where the touching circle
 * touches a third time, changes from curve to vertex, or becomes a line.
 *
 * All numbers are in a frame in which the sets have size 1. */
#ifndef OPS_PLANE_H
#define OPS_PLANE_H

#include "sym/form.h"

/* How deep a set may lie inside a circle that is said to hold none of it:
 * a few roundings of coordinates of size 1 in products of the degree at hand.
 * The own set gets more, so that what one test lets pass the next one does. */
#define IX__DEPTH     1e-14
#define IX__OWN_DEPTH 4e-14

/* Places of a span that a search begins with. */
enum { IX__SEEN = 8 };

typedef struct {
    int degree;
    const double *p;  /* [3][degree + 1] of w, wx, wy, scaled Bernstein */
    double weight;    /* largest Bernstein coefficient of w */
    double box[2][2]; /* of the control points, lo and hi */
    bool boxed;       /* weights of one sign: the box holds the span */
    bool phantom;     /* of the carrier, not of the curve */
    double t[2];      /* the user's parameters of both ends */
    double x[2][2];   /* end points */
    double seen[IX__SEEN][2]; /* points inside, evenly in u */
    double tangent[2][2];     /* unit tangents there, towards growing t */
    int curve, strand;
    int vertex[2]; /* at both ends; -1: a smooth joint */
} ix__span;

typedef struct {
    double x[2], t; /* t: the user's parameter on the curve */
    int curve;
    bool shared; /* lies on the other set too */
} ix__vertex;

/* Spans that follow one another. */
typedef struct {
    int first, count;
    bool closed;
} ix__strand;

typedef enum { IX__SIDE, IX__FAN } ix__border_kind;

/* An element of the border; its parameter runs over [0, 1]. */
typedef struct {
    ix__border_kind kind;
    int index;       /* span or vertex */
    int side;        /* of a span: 1 left, t grows; -1 right, t falls */
    double from, to; /* of a fan: angles of the normal */
} ix__border;

typedef struct {
    int first, count;
    int strand, side; /* side 0: both, around an open strand; or a point */
} ix__loop;

typedef struct {
    int nspans, nvertices, nstrands, nborders, nloops;
    ix__span *span;
    ix__vertex *vertex;
    ix__strand *strand;
    ix__border *border;
    ix__loop *loop;
    double *work; /* of the search for circles: one thread at a time */
} ix__set;

/* What a set is made with. */
typedef struct {
    bool carrier; /* the first and last span of each open strand go on to
                     infinity, as phantoms */
} ix__set_opts;

/* The set of n curves in the frame; scratch. Tangents that differ by less than
 * 1e-10 are a smooth joint; points nearer than 1e-11 are one.
 * Err IX_EARG not a curve, other than two coordinates (three in a plane) */
ix_status ix__set_of_curves(ix_ctx *ctx, int n, const ix_mv *const *crv,
                            const ix_frame *frame, ix__set_opts o,
                            ix__set *out) IX_MUST_CHECK;
ix_status ix__set_of_point(ix_ctx *ctx, const double x[2],
                           ix__set *out) IX_MUST_CHECK;
/* The frame of some curves and points x[npts][2]: the unit box. */
ix_status ix__plane_frame(ix_ctx *ctx, int n, const ix_mv *const *crv, int npts,
                          const double (*x)[2], ix_frame *out) IX_MUST_CHECK;
/* Half the longest edge of the box of both, as far as places of each span tell:
 * that of control points may be several times as large. */
double ix__sets_size(const ix__set *a, const ix__set *b);
/* Marks the vertices of a that lie on b and those of b that lie on a. */
void ix__sets_share(ix__set *a, ix__set *b);

/* Point, first and second derivative at u (not finite at a pole). */
void ix__span_at(const ix__set *s, const ix__span *sp, double u,
                 double out[3][2]);
/* Unit tangent at u; at ends the one that was found there. */
void ix__span_tangent(const ix__set *s, const ix__span *sp, double u,
                      double out[2]);
double ix__span_parameter(const ix__span *sp, double u);

/* --- circles ---------------------------------------------------------------
 */

/* The place where a circle touches: kappa is its curvature. span < 0: none. */
typedef struct {
    double kappa;
    int span;
    double u;
} ix__touch;

/* Raises io->kappa to that of the largest circle through c, on the side of the
 * unit vector n, that holds no point of the set deeper than depth. Untouched if
 * the circle that came in is such. */
void ix__set_touch(const ix__set *s, const double c[2], const double n[2],
                   double depth, ix__touch *io);
/* The same, sooner if it touches near foot (NULL: not known). */
void ix__set_touch_near(const ix__set *s, const double c[2], const double n[2],
                        double depth, const ix__touch *foot, ix__touch *io);
/* The same, but any larger kappa will do; io->span and u, unless that is -1, is
 * a place where the circle that came in touches. True if there was one. */
bool ix__set_blocks(const ix__set *s, const double c[2], const double n[2],
                    double depth, ix__touch *io);
/* Is a point of the set no farther from x than d > 0? */
bool ix__set_near(const ix__set *s, const double x[2], double d);
/* The span behind end e of a span; -1 if there is a vertex, or nothing. */
int ix__next_span(const ix__set *s, int span, int e);
/* Distance of x from the set; the place in *at unless that is NULL. */
double ix__set_distance(const ix__set *s, const double x[2], ix__touch *at);

#endif
