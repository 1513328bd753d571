/* contact.h - lifts of points, curves and surfaces as rows of determinants in
 * the parameters of all of them together. */
#ifndef OPS_CONTACT_H
#define OPS_CONTACT_H

#include "iritx/ops_mbisect.h"
#include "sym/form.h"

enum { IX__MAX_OBJECTS = IX_CENTRE_OBJECTS, IX__MAX_CONTACT = 3 };

/* One object: its lift L and the derivatives of L, forms in the parameters of
 * all objects over [0, 1], with dim + 2 rows. */
typedef struct {
    int nrows;
    ix_form row[IX__MAX_CONTACT];
    const ix_mv *m; /* NULL: a point */
    int start;      /* its first parameter */
    double dom[2][2];
} ix_contact;

typedef struct {
    int dim, nvars, n;
    ix_frame frame;
    ix_contact at[IX__MAX_OBJECTS];
} ix_contacts;

/* m[i] NULL: the point q[i] (dim numbers each); not all of them. In scratch. */
ix_status ix__contacts_of(ix_ctx *ctx, int n, const ix_mv *const *m,
                          const double *q, int dim,
                          ix_contacts *out) IX_MUST_CHECK;

/* A determinant of rows of objects, given as object and row (0: L, 1 and 2 its
 * derivatives), dim + 2 of them: a polynomial over [0, 1]^nvars, in the degrees
 * that are left when what is known to cancel does. For an object of degree q of
 * which k rows are in it: (k + 1) q, less 1 in a direction of a derivative; for
 * a rational one 2 k q, less 2 if L is one of the rows, else less 1. */
typedef struct {
    int object, row;
} ix_contact_row;
ix_status ix__contact_det(ix_ctx *ctx, const ix_contacts *c,
                          const ix_contact_row *rows,
                          ix_mv **out) IX_MUST_CHECK;
/* The dim + 2 minors of dim + 1 rows, as a form. */
ix_status ix__contact_minors(ix_ctx *ctx, const ix_contacts *c,
                             const ix_contact_row *rows,
                             ix_form *out) IX_MUST_CHECK;

/* The foot on object i at the parameters x[nvars] (in [0, 1]) and its partial
 * derivatives (zero if there are none); false at a pole. */
ix_status ix__contact_foot(ix_ctx *ctx, const ix_contacts *c, int i,
                           const double *x, double foot[3], double d[2][3],
                           bool *ok) IX_MUST_CHECK;

/* The point with r[k].p = h[k] for three rows of length 1 (n of them, 2 or 3 in
 * the plane); the best conditioned ones are taken. False if all are dependent
 * to 1e-9. */
bool ix__meet_planes(int dim, int n, double (*r)[3], const double *h,
                     double p[3]);

#endif
