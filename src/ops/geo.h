/* geo.h - surfaces, curves on them and geodesics, as the operators of
 * iritx/geodesic.h see them.
 *
 * Inside, all is scaled: the surface's domain is [0, 1]^2, the curves' is [0,
 * 1], the surface has the size 1. So the tolerances of the integration are
 * relative. */
#ifndef OPS_GEO_H
#define OPS_GEO_H

#include "bsp/spans.h"
#include "iritx/geodesic.h"
#include "solve/ode.h"

/* Geodesics that start inside may be evaluated that far outside of the domain,
 * so that events at its edge can be bracketed. */
#define IX_GEO_MARGIN 0.0625
/* Points this near to the edge are in the domain. */
#define IX_GEO_SLACK 1e-12
/* Sine of the angle between two normals that counts as a crease, and between
 * two tangents that counts as a corner. */
#define IX_GEO_SHARP 1e-6

/* --- the surface --------------------------------------------------------- */

enum {
    IX_GEO_S,
    IX_GEO_SU,
    IX_GEO_SV,
    IX_GEO_SUU,
    IX_GEO_SUV,
    IX_GEO_SVV,
    IX_GEO_NJET = 10
};
typedef double ix__geo_jet[IX_GEO_NJET][3];

/* One direction of a spline: its spans, scaled to [0, 1]. */
typedef struct {
    ix_dir dir;
    int nspans;
    double *breaks;  /* [nspans + 1] */
    const int *cont; /* [nspans - 1], at inner breaks, at least */
    int *first;      /* of the window of each span */
    double *w;       /* [4][order], weights of the derivatives */
    double *wt;      /* [order][4], the same */
} ix__geo_dir;

typedef struct {
    ix_geo_surface in;
    double lo[2], len[2]; /* u = lo + len u^ */
    double size;          /* of length */
    const ix_mv *mv;      /* no power or periodic directions; NULL: function */
    ix__geo_dir d[2];
    bool planar;
} ix__geo_srf;

/* A span of each direction; its polynomial counts beyond it too. */
typedef struct {
    int at[2];
} ix__geo_cell;

/* Scratch and one reference in *keep, to be released after use.
 * Err IX_EARG, see the header. */
ix_status ix__geo_srf_open(ix_ctx *ctx, const ix_geo_surface *s,
                           ix__geo_srf *out, ix_mv **keep) IX_MUST_CHECK;
ix__geo_cell ix__geo_cell_of(const ix__geo_srf *s, double u, double v);
/* Derivatives up to order <= 3, scaled; false where there are none. */
bool ix__geo_eval(const ix__geo_srf *s, ix__geo_cell c, double u, double v,
                  int order, ix__geo_jet j);

/* First form and normal of a jet. */
typedef struct {
    double e, f, g, w; /* w = |S_u x S_v| */
    double n[3];       /* of length 1 */
} ix__geo_metric;
bool ix__geo_metric_of(ix__geo_jet j, ix__geo_metric *m); /* false: no normal */
/* K, or with grad (jets of order 3) K, K_u, K_v. */
void ix__geo_gauss(ix__geo_jet j, bool grad, double k[3]);
/* a S_u + b S_v. */
void ix__geo_vector(ix__geo_jet j, const double ab[2], double x[3]);
/* The parts a, b of the tangent vector x. */
void ix__geo_parts(ix__geo_jet j, const ix__geo_metric *m, const double x[3],
                   double ab[2]);

/* --- curves on it -------------------------------------------------------- */

/* A span is a piece of one polynomial of the curve within one cell of the
 * surface: there everything is analytic. */
typedef struct {
    const ix_mv *mv;
    ix__geo_dir d;
    ix__geo_cell *cell; /* of each span */
    int (*group)[2];    /* of each span: the first span, and the one after the
                           last, between breaks at which curvatures jump */
    int *cont;          /* [nspans + 1] at the breaks, -1 at the ends */
    int pieces;         /* polynomials; spans are more */
    double lo, len;
    const ix__geo_srf *s;
} ix__geo_crv;

/* Of C(t) on the surface, scaled. */
typedef struct {
    double uv[2], duv[2];
    ix__geo_cell cell;
    double len;                            /* |C'| */
    double inside;                         /* as in ix__geo, of all of it */
    double tangent[3], normal[3], side[3]; /* C' / |C'|, N, N x C' / |C'| */
    double side_ab[2];
    double kg, dkg; /* geodesic curvature and its derivative by t */
    double dlen;    /* of |C'| */
    double pos[3];
} ix__geo_place;

/* Err IX_EARG. Scratch and a reference in *keep. */
ix_status ix__geo_crv_open(ix_ctx *ctx, const ix__geo_srf *s, const ix_mv *crv,
                           const char *what, ix__geo_crv *out,
                           ix_mv **keep) IX_MUST_CHECK;
int ix__geo_crv_span(const ix__geo_crv *c, double t);
/* The same, but between two breaks lo and hi when t is one of them. */
int ix__geo_crv_span_in(const ix__geo_crv *c, double t, double lo, double hi);
/* The ends, and the breaks between which results are smooth enough for pieces
 * of degree 5; scratch. */
ix_status ix__geo_crv_rough(ix_ctx *ctx, const ix__geo_crv *c, int *n,
                            double **out) IX_MUST_CHECK;
/* By the polynomial of a span; false: no normal, or C' = 0. third: dkg too. */
bool ix__geo_place_at(const ix__geo_crv *c, int span, double t, bool third,
                      ix__geo_place *out);

/* --- geodesics ----------------------------------------------------------- */

/* u, v, u', v', y, y', and with variation dy/dt and its derivative. */
typedef double ix__geo_state[IX_ODE_UNKNOWNS];

typedef struct {
    ix_ctx *ctx;
    ix__geo_srf s;
    ix_mv *keep[3]; /* of the surface and at most two curves */
    ix__geo_crv c[2];
    double tol;                    /* of the integration */
    double fit;                    /* of the results, scaled */
    double reach;                  /* scaled */
    ix__ode *ode, *varied, *check; /* opened at first use */
    /* of the geodesic that is being integrated: */
    ix__geo_cell cell;
    double side; /* 1 if J is to the right of the direction */
    bool variation, margin, stop_at_focal;
    double inside; /* least distance of its u, v from the edge so far, negative
                      outside; extrema between steps by cubics */
} ix__geo;

/* Opens the surface and n = 0 .. 2 curves. ix__geo_close in any case. */
ix_status ix__geo_open(ix_ctx *ctx, const ix_geo_surface *s, int n,
                       const ix_mv *const *crvs, const ix_geo_opts *o,
                       ix__geo *out) IX_MUST_CHECK;
void ix__geo_close(ix__geo *g);

/* Where a geodesic is when it is told of. */
typedef enum {
    IX_GEO_STEP, /* anywhere */
    IX_GEO_EDGE, /* of a cell: derivatives of u, v above the first may jump */
    IX_GEO_KINK  /* after an edge where u', v' jump: the new ones */
} ix__geo_event;

/* How a geodesic is followed. */
typedef struct {
    bool variation;     /* with the derivative of y */
    bool margin;        /* a little beyond the domain, without stopping */
    bool stop_at_focal; /* where y falls through 0 */
    bool check;         /* by the other method, with a narrower tolerance */
    /* Called after each step and at each edge of a cell; NULL: not. */
    ix_status (*step)(void *ud, double s, const double *q, ix__geo_event e);
    void *ud;
} ix__geo_way;

/* From s, q to the distance end: the distance and state reached, and why.
 * side as in ix__geo. g->cell is that of the start, and of the end after. */
ix_status ix__geo_run(ix__geo *g, const ix__geo_way *w, double side, double end,
                      double *s, double *q, ix_geo_stop *stop) IX_MUST_CHECK;

/* The geodesic normal to a curve, followed over x (to the left if > 0). */
typedef struct {
    ix__geo_state q;
    ix__geo_cell cell;
    double sign;    /* of x, 1 for 0: u', v' are sign * dO/dx */
    double side[2]; /* parts of E, the direction of dO/dt = y E */
    double s;       /* |x|, or less if stopped */
    double len;     /* |C'| */
    double inside;  /* as in ix__geo, of all of it */
    ix_geo_stop stop;
} ix__geo_shot;
ix_status ix__geo_shoot(ix__geo *g, const ix__geo_crv *c, int span, double t,
                        double x, const ix__geo_way *w,
                        ix__geo_shot *out) IX_MUST_CHECK;
/* Back by the other method of integration: the place on the surface, scaled,
 * that a geodesic of the length len comes from which is in the state q; NaN
 * where that cannot be told. */
ix_status ix__geo_back(ix__geo *g, const double *q, const int cell[2],
                       double len, double x[3]) IX_MUST_CHECK;
/* Its start: q of the place. */
void ix__geo_start(const ix__geo_place *p, double sign, double *q);
/* E of a state: parts along S_u, S_v. */
bool ix__geo_across(const ix__geo *g, const double *q, double side,
                    double ab[2]);

/* --- results -------------------------------------------------------------- */

/* A point of a curve that is traced, in the user's units. */
typedef struct {
    double x;           /* the parameter */
    double p[5], dp[5]; /* (u, v, x, y, z) and its derivative by x */
    double form[3];     /* first fundamental form */
    double state[8];    /* what the operator knows */
    int cell[4];
    bool kink; /* the derivatives of u, v are others in the next piece: state
                  follows once more with them */
} ix__geo_sample;

/* A sample at x between two neighbours. */
typedef ix_status (*ix__geo_mid)(const void *ud, const ix__geo_sample *a,
                                 const ix__geo_sample *b, double x,
                                 ix__geo_sample *out);

/* Samples need not be nearer to each other than this (scaled) to begin with;
 * fitting adds those that are needed. */
#define IX_GEO_SPACING 0.1

typedef struct {
    int n, room;
    ix__geo_sample *at;
} ix__geo_trace;
/* Room for one more than n items of a size in scratch: the array, perhaps
 * moved, NULL without memory. */
void *ix__geo_grow(ix_ctx *ctx, void *at, int n, int *room,
                   size_t size) IX_MUST_CHECK;
ix_status ix__geo_trace_add(ix_ctx *ctx, ix__geo_trace *t,
                            const ix__geo_sample *s) IX_MUST_CHECK;

/* Fits out->uv and ->space to the samples, which are refined by mid until both
 * agree with it within tol; the trace then holds all. */
ix_status ix__geo_fit(ix_ctx *ctx, ix__geo_trace *t, ix__geo_mid mid,
                      const void *ud, double tol,
                      ix_geo_curve *out) IX_MUST_CHECK;
/* The samples as a B-spline of order 2 over their parameters: row fills the k
 * coordinates of one. */
typedef void (*ix__geo_row)(const void *ud, const ix__geo_sample *s,
                            double *row);
ix_status ix__geo_states(ix_ctx *ctx, const ix__geo_trace *t, int k,
                         ix__geo_row row, const void *ud,
                         ix_mv **out) IX_MUST_CHECK;

/* Curves found so far; ix__geo_found_end hands them over if st is IX_OK, and
 * releases them otherwise. */
typedef struct {
    int n, room;
    ix_geo_curve *crv;
} ix__geo_found;
ix_status ix__geo_keep(ix_ctx *ctx, ix__geo_found *f,
                       const ix_geo_curve *c) IX_MUST_CHECK;
ix_status ix__geo_found_end(ix_ctx *ctx, ix__geo_found *f, ix_status st,
                            ix_geo_curves *out) IX_MUST_CHECK;

/* --- one point for each parameter of a curve ------------------------------ */

/* A result that has a sample for each t (scaled) of g->c[0], where it exists.
 */
typedef struct {
    ix__geo *g;
    /* The sample at t by the polynomials of [lo, hi]; *ok false: there is
     * none, and why. out->x is set already. */
    ix_status (*sample)(void *ud, double t, double lo, double hi,
                        ix__geo_sample *out, bool *ok, ix_geo_stop *why);
    ix_status (*measure)(void *ud, const ix__geo_trace *t, double *miss);
    ix__geo_row row;
    int nrow;
    void *ud;
} ix__geo_along;
/* All curves between n breaks (scaled, increasing). Their states hold t in
 * state[6]. */
ix_status ix__geo_along_run(const ix__geo_along *a, int n, const double *breaks,
                            ix__geo_found *f) IX_MUST_CHECK;

/* p, form of a sample at scaled (u, v); the derivative of u, v by x is
 * duv, scaled parameters by the user's x. */
bool ix__geo_fill(const ix__geo *g, ix__geo_cell c, const double uv[2],
                  const double duv[2], ix__geo_sample *out);

#endif
