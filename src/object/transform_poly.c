/* transform_poly.c - polygonal data times a matrix: vertices, normals,
 * planes. Normals keep their side also under mirroring. */
#include <math.h>
#include <string.h>

#include "object/transform_impl.h"

void ix__row_times(const double p[4], const double mat[16], double h[4])
{
    for (int j = 0; j < 4; j++)
        h[j] = p[0] * mat[j] + p[1] * mat[4 + j] + p[2] * mat[8 + j] +
               p[3] * mat[12 + j];
}

bool ix__is_affine(const double mat[16])
{
    return mat[3] == 0 && mat[7] == 0 && mat[11] == 0;
}

ix_status ix__move_point(ix_ctx *ctx, const double p[3], const double mat[16],
                         double out[3])
{
    double q[4] = {p[0], p[1], p[2], 1}, h[4];

    ix__row_times(q, mat, h);
    if (h[3] == 0)
        return IX_FAIL(ctx, IX_EDOMAIN,
                       "the matrix sends the point (%g, %g, %g) to infinity",
                       p[0], p[1], p[2]);
    for (int k = 0; k < 3; k++)
        out[k] = h[3] == 1 ? h[k] : h[k] / h[3];
    return IX_OK;
}

/* The cofactors of the linear part times the sign of its determinant: n cof
 * is normal to the image of what n was normal to, and looks to the image of
 * the side that n looked to. */
static void normal_matrix(const double mat[16], double cof[3][3])
{
    double det = 0;

    for (int i = 0; i < 3; i++) {
        const double *a = mat + 4 * ((i + 1) % 3), *b = mat + 4 * ((i + 2) % 3);

        for (int k = 0; k < 3; k++)
            cof[i][k] = a[(k + 1) % 3] * b[(k + 2) % 3] -
                        a[(k + 2) % 3] * b[(k + 1) % 3];
    }
    for (int k = 0; k < 3; k++)
        det += mat[k] * cof[0][k];
    for (int i = 0; det < 0 && i < 9; i++)
        cof[i / 3][i % 3] = -cof[i / 3][i % 3];
}

/* A unit normal again, or false. */
static bool move_normal(double n[3], double cof[3][3])
{
    double m[3], len;

    for (int k = 0; k < 3; k++)
        m[k] = n[0] * cof[0][k] + n[1] * cof[1][k] + n[2] * cof[2][k];
    len = sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    if (!(len > 0) || !isfinite(len))
        return false;
    for (int k = 0; k < 3; k++)
        n[k] = m[k] / len;
    return true;
}

/* Affine matrices: through the image of the plane's point next to the origin,
 * with the moved normal. */
static ix_status move_plane(ix_ctx *ctx, ix_polygon *pg, const double mat[16],
                            double cof[3][3])
{
    double *q = pg->plane, foot[3];

    for (int k = 0; k < 3; k++)
        foot[k] = -q[3] * q[k];
    IX_TRY(ix__move_point(ctx, foot, mat, foot));
    pg->has_plane = move_normal(q, cof);
    q[3] = 0 - (q[0] * foot[0] + q[1] * foot[1] + q[2] * foot[2]);
    return IX_OK;
}

/* Perspective does not keep normals: the plane is taken from the vertices. */
static void new_plane(ix_polygon *pg)
{
    pg->has_plane = pg->kind == IX_POLYGON && ix__polygon_plane(pg, pg->plane);
    for (int i = 0; i < pg->n; i++) {
        pg->v[i].has_normal = pg->has_plane;
        if (pg->has_plane)
            memcpy(pg->v[i].normal, pg->plane, sizeof pg->v[i].normal);
    }
}

static ix_status move_polygon(ix_ctx *ctx, ix_polygon *pg, const double mat[16],
                              double cof[3][3])
{
    bool affine = ix__is_affine(mat);

    for (int i = 0; i < pg->n; i++) {
        ix_vertex *v = &pg->v[i];

        IX_TRY(ix__move_point(ctx, v->p, mat, v->p));
        if (affine && v->has_normal)
            v->has_normal = move_normal(v->normal, cof);
    }
    if (!affine)
        new_plane(pg);
    else if (pg->has_plane)
        IX_TRY(move_plane(ctx, pg, mat, cof));
    return IX_OK;
}

static ix_status move_all(ix_ctx *ctx, ix_poly *p, const double mat[16])
{
    double cof[3][3];

    normal_matrix(mat, cof);
    for (int i = 0; i < p->n; i++) {
        IX_TRY(ix__poll(ctx));
        IX_TRY(move_polygon(ctx, &p->poly[i], mat, cof));
    }
    return IX_OK;
}

ix_status ix__move_poly(ix_ctx *ctx, const ix_poly *p, const double mat[16],
                        ix_poly **out)
{
    ix_status st;

    *out = ix__poly_dup(ctx, p);
    if (!*out)
        return IX_ENOMEM;
    st = move_all(ctx, *out, mat);
    if (st != IX_OK) {
        ix__poly_unref(ctx, *out);
        *out = NULL;
    }
    return st;
}
