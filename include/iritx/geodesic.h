/* geodesic.h - distances on surfaces: geodesics, their offsets, medial curves
 * and focal curves of curves on a surface.
 *
 * The surface is a free-form one or any other that a function evaluates. All
 * curves on it are given and returned in its parameter plane. N = S_u x S_v /
 * |S_u x S_v|; the positive side of a curve is its left one, seen from the tip
 * of N: that of N x C', as in the parameter plane.
 *
 * O(s, t) is the point at the signed geodesic distance s from C(t), along the
 * geodesic that starts there at a right angle. y is the signed length of the
 * derivative of O by t: y'' + K y = 0 along the geodesic, y(0) = |C'|, y'(0) =
 * -kg |C'|, K the Gauss curvature, kg the geodesic curvature of C. Where y = 0
 * is a focal point. (Rausch, Wolter, Sniehotta: Computation of medial curves on
 * surfaces, 1997, sections 2 to 5.)
 *
 * Needs SUNDIALS; IX_EUNABLE where the library is not there. */
#ifndef IRITX_GEODESIC_H
#define IRITX_GEODESIC_H

#include "iritx/mv.h"

#ifdef __cplusplus
extern "C" {
#endif

/* --- surfaces ------------------------------------------------------------ */

/* A surface by its derivatives at (u, v): d[k] for k = 0 .. 9 is S, S_u, S_v,
 * S_uu, S_uv, S_vv, S_uuu, S_uuv, S_uvv, S_vvv, of which those of total degree
 * at most order (2, or 3 where focal curves are traced) are to be set. It may
 * be asked up to 1/16 of the domain's length outside. False: it is not defined
 * there. */
typedef bool (*ix_surface_fn)(void *ud, double u, double v, int order,
                              double (*d)[3]);

typedef struct {
    const ix_mv *mv;     /* 2 directions, 2 or 3 coordinates, borrowed; or NULL
                            and a function */
    ix_surface_fn fn;    /* with continuous derivatives of order 3 */
    void *ud;            /* handed to fn */
    double lo[2], hi[2]; /* the piece that counts; lo == hi: all of mv */
} ix_geo_surface;

/* NULL stands for {0, 0}. */
typedef struct {
    double tol;   /* of the resulting curves, a length; 0: 1e-8 of the surface's
                     size. Below 1e-12 of it counts as that */
    double reach; /* geodesics are followed as far as this; 0: four times the
                     surface's size */
} ix_geo_opts;

/* --- results ------------------------------------------------------------- */

typedef enum {
    IX_GEO_END,      /* the length, or the end of a curve's range: as asked */
    IX_GEO_DOMAIN,   /* the edge of the surface's domain */
    IX_GEO_FOCAL,    /* a focal point of the (first) curve */
    IX_GEO_FOCAL2,   /* a focal point of the second curve */
    IX_GEO_CREASE,   /* the surface has no common tangent plane there */
    IX_GEO_CORNER,   /* a border curve has a corner there */
    IX_GEO_SINGULAR, /* no normal, or the function returned false */
    IX_GEO_REACH,    /* opts.reach */
    IX_GEO_CLOSED    /* back at the start */
} ix_geo_stop;
const char *ix_geo_stop_name(ix_geo_stop s); /* "end", "domain", ... */

/* One curve on the surface. */
typedef struct {
    ix_mv *uv;           /* in the parameter plane: order 6, C1 */
    ix_mv *space;        /* on the surface, with the knots of uv */
    ix_mv *states;       /* the places where it was computed, over the same
                            parameter: order 2; the coordinates are told below */
    ix_geo_stop stop[2]; /* what is at its first and last parameter */
    double fit;  /* largest distance of uv and space from the computed curve,
                    measured between the points that they interpolate */
    double miss; /* the error of the computed points, a length, measured by
                    another method of integration (see each function) */
} ix_geo_curve;

typedef struct {
    int n;
    ix_geo_curve *crv;
    size_t bytes;
} ix_geo_curves;
void ix_geo_curve_free(ix_ctx *ctx, ix_geo_curve *c);
void ix_geo_curves_free(ix_ctx *ctx, ix_geo_curves *c);

/* --- functions ---------------------------------------------------------------
 * Common errors:
 *   IX_EARG    not a surface of 2 or 3 coordinates, an empty piece; a curve
 *              that has not 2 coordinates or leaves the domain; not finite
 *   IX_EDOMAIN no normal at the start, a curve that stands still
 *   IX_EUNABLE no SUNDIALS; the tolerance is not reached with 4096 pieces */

/* The geodesic from uv in the direction dir (parts along S_u and S_v, of any
 * length but 0) of the length len.
 *
 * Out   *out  over [0, length]; states (s, u, v, y, y') with the polar Jacobi
 *             field y(0) = 0, y'(0) = 1: its first zero is the point conjugate
 *             to the start
 *       conjugate  NULL, or the distance of the first conjugate point, NaN if
 *             there is none up to the end
 * Num   miss: how far the geodesic back from the end misses the start */
ix_status ix_geodesic(ix_ctx *ctx, const ix_geo_surface *s, const double uv[2],
                      const double dir[2], double len, const ix_geo_opts *o,
                      double *conjugate, ix_geo_curve *out) IX_MUST_CHECK;

/* The geodesic at a right angle to a curve of the parameter plane at t, of the
 * length |len|, to the left if len > 0. It ends at the first focal point if
 * stop_at_focal. Out: as above with y(0) = |C'|, y'(0) = -+kg |C'|. */
ix_status ix_geodesic_normal(ix_ctx *ctx, const ix_geo_surface *s,
                             const ix_mv *crv, double t, double len,
                             bool stop_at_focal, const ix_geo_opts *o,
                             ix_geo_curve *out) IX_MUST_CHECK;

/* The geodesic curvature of a curve at t and its derivative by t, for N. */
ix_status ix_geodesic_curvature(ix_ctx *ctx, const ix_geo_surface *s,
                                const ix_mv *crv, double t,
                                double kg[2]) IX_MUST_CHECK;

/* The offset O(d(t), t) at a constant distance, or one that varies.
 *
 * In    dist      added to by the scalar curve
 *       variable  NULL, or a curve of one coordinate with crv's domain
 * Out   *out      over t, in as many pieces as t's for which the geodesics
 *                 exist; states (t, u, v, y, distance). The offset has a
 *                 cusp (or, for a variable distance, the normal of C as its
 *                 tangent) where y = 0
 *       ncusps, cusps  NULL, or a new array of the t with y = 0, freed with
 *                 ix_geo_numbers_free
 * Num   miss: how far the geodesics back miss C(t) */
ix_status ix_geodesic_offset(ix_ctx *ctx, const ix_geo_surface *s,
                             const ix_mv *crv, double dist,
                             const ix_mv *variable, const ix_geo_opts *o,
                             int *ncusps, double **cusps,
                             ix_geo_curves *out) IX_MUST_CHECK;
void ix_geo_numbers_free(ix_ctx *ctx, double *v, int n);

/* Where to begin with a medial curve. */
typedef enum {
    IX_MEDIAL_AUTO, /* where the borders meet; if they do not, the nearest of
                       the points that IX_MEDIAL_ENDS starts from */
    IX_MEDIAL_ENDS, /* all points whose foot is an end of a border */
    IX_MEDIAL_GUESS /* near guess, by Newton's method for a fixed t1 */
} ix_medial_start;

typedef struct {
    int sides[2]; /* 1 left, -1 right of each border; 0, 0: all four */
    ix_medial_start start;
    double guess[3]; /* t1, t2, distance */
} ix_medial_opts;

/* The medial curves of two border curves: points with O1(side1 s, t1) =
 * O2(side2 s, t2), traced through the (t1, t2, s) that solve this.
 *
 * In    m      NULL: all sides, IX_MEDIAL_AUTO
 * Out   *out   over the length in (C1, C2, s), from 0; t1 increases. States
 *              (t1, s, t2, |s|). s changes its sign where the borders meet: a
 *              medial curve of the sides (a, b) is one of (-a, -b) beyond. May
 *              be none. stop: IX_GEO_END at an end of a border's range,
 *              IX_GEO_FOCAL and _FOCAL2, IX_GEO_DOMAIN, _CORNER, _REACH;
 *              IX_GEO_SINGULAR also where the borders touch
 * Err   IX_EARG    sides are not both 1 or -1, or 0
 *       IX_EDOMAIN no point near the guess
 * Num   miss: largest distance between the ends of the two geodesics, shot
 *       anew. Starts at ends are found from a net of 33 geodesics
 * Src   Rausch, Wolter, Sniehotta 1997, (4.4) and (4.6); docs/ops/medial_crv.md
 *       says where we differ */
ix_status ix_medial_crv(ix_ctx *ctx, const ix_geo_surface *s, const ix_mv *c1,
                        const ix_mv *c2, const ix_medial_opts *m,
                        const ix_geo_opts *o, ix_geo_curves *out) IX_MUST_CHECK;

/* The first focal points on one side (1 left, -1 right) of a curve.
 *
 * Out   *out   over t, in as many pieces as they exist for; states (t, s, u, v,
 *              ds/dt). May be none
 * Num   miss: difference between the distances s located as zeros of y and
 *       those by integrating ds/dt from one to the next (equation (5.5))
 * Src   Rausch, Wolter, Sniehotta 1997, section 5 */
ix_status ix_srf_focal_crv(ix_ctx *ctx, const ix_geo_surface *s,
                           const ix_mv *crv, int side, const ix_geo_opts *o,
                           ix_geo_curves *out) IX_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif
