/* tess_impl.h - the parts of the tessellator: bounds on one box, and the grid
 * of parameters of a whole curve or surface. Everything is in scratch. */
#ifndef MV_TESS_IMPL_H
#define MV_TESS_IMPL_H

#include "mv/bernstein.h"
#include "mv/tessellate.h"

/* A box of a curve or surface in Bezier form: double[naxes][o[1]][o[0]], the
 * weight first if rational. */
typedef struct {
    int o[2], naxes, ncoords; /* ncoords <= 3 are used */
    bool rational;
    double *net;
    double *work; /* if rational: room for ix__tess_work(box) */
} ix__tess_box;
size_t ix__tess_work(const ix__tess_box *b);

/* Largest second derivatives, the box taken as [0, 1]^2, and first ones. */
typedef struct {
    double uu, uv, vv, u, v;
} ix__tess_bound;

typedef enum { IX__TESS_KEEP, IX__TESS_POLE } ix__tess_sign;
/* Is the weight of one sign on the box, and |weight| >= least? */
ix__tess_sign ix__tess_weights(const ix__tess_box *b, double least);
/* For boxes whose weight has one sign. */
ix__tess_bound ix__tess_bounds(const ix__tess_box *b);
/* Steps hu, hv of the box's parameters, the box being [0, 1]^2, keep the error
 * below tol if e[0] hu^2 + e[1] hv^2 <= 8 tol. */
void ix__tess_needs(const ix__tess_bound *b, double e[2]);

/* One direction: interval k stands between the samples k and k + 1; joined[k]
 * is false where the curve or surface jumps between them. */
typedef struct {
    int nsamples;
    double *t;
    bool *joined; /* [nsamples - 1] */
    int *owner;   /* [nsamples - 1]: the piece of interval k */
    int nspans;
    int *first, *last; /* [nspans]: samples of a span, both included */
    double *basis;     /* [nspans + nsamples][order]: Bernstein values; those
                          of span s begin at first[s] + s */
} ix__tess_dir;

/* The samples of a curve (second direction: one sample) or surface, their
 * points and the cells between them. */
struct ix__tess_grid {
    ix__tess_dir d[2];
    size_t nverts;       /* d[0].nsamples * d[1].nsamples, d[0] fastest */
    double *xyz;         /* double[nverts][3]; not finite at poles */
    unsigned char *cell; /* [max(n1 - 1, 1)][n0 - 1]: 1: keep */
    size_t nleft;        /* cells at poles */
    double slope[2];     /* largest first derivatives of the kept boxes, by
                            the surface's own parameters */
};

/* --- parameters as integers
 * The k-th line of the grid is at k IX__CDT_SIDE, and what is very near to it
 * is on it; cells are divided evenly. Outside of the domain up to 16 cells are
 * told apart. */
int64_t ix__tess_place(const ix__tess_dir *d, double t);
/* The nearest line's place if that is very near, else x. */
int64_t ix__tess_snap(int64_t x);
/* The parameter at a place in the domain. */
double ix__tess_param(const ix__tess_dir *d, int64_t x);

/* Err as ix__mesh_of_srf. */
ix_status ix__tess_grid_of(ix_ctx *ctx, const ix_mv *m, double tol,
                           ix__tess_grid *out) IX_MUST_CHECK;

/* Equal steps in each direction, steps[ndirs] for the whole domain, and the
 * breaks of spans; no tolerance. Err IX_EARG steps below 1. */
ix_status ix__tess_grid_even(ix_ctx *ctx, const ix_mv *m, const int *steps,
                             ix__tess_grid *out) IX_MUST_CHECK;

/* All triangles of a grid. */
ix_status ix__mesh_of_grid(ix_ctx *ctx, const ix__tess_grid *g,
                           ix__mesh *out) IX_MUST_CHECK;
/* Parameters of its vertices: uv[nverts][2]. */
void ix__tess_put_uv(const ix__tess_grid *g, double *uv);
/* Two corners of a triangle are the same point. */
bool ix__tess_degenerate(const double *xyz, const uint32_t *t);
/* The two triangles of a cell with corners k: cut along the shorter diagonal.
 * Returns how many of them, not degenerate, are written to t. */
size_t ix__tess_cut_cell(const double *xyz, const uint32_t k[4],
                         uint32_t (*t)[3]);

/* The vertices that triangles use, and these, as a result. */
ix_status ix__mesh_pack(ix_ctx *ctx, size_t nverts, const double *xyz,
                        const double *uv, size_t ntris,
                        const uint32_t (*tri)[3], ix__mesh *out) IX_MUST_CHECK;
void ix__tess_note(ix_ctx *ctx, size_t nleft);

#endif
