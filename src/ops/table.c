/* table.c - operators by name, all with one signature. */
#define _POSIX_C_SOURCE 200809L
#include "ops/table.h"

#include <string.h>
#include <strings.h>

#include "iritx/ops_bisect.h"
#include "iritx/ops_crv.h"
#include "iritx/ops_srf.h"

#define FIELD(fn, kind)                                                        \
    static ix_status fn(ix_ctx *ctx, const ix_op_args *a, const ix_op_opts *o, \
                        ix_report *rep, ix_mv **out)                           \
    {                                                                          \
        return ix_crv_field(ctx, a->mv[0], kind, o, rep, out);                 \
    }
#define RULED(fn, kind)                                                        \
    static ix_status fn(ix_ctx *ctx, const ix_op_args *a, const ix_op_opts *o, \
                        ix_report *rep, ix_mv **out)                           \
    {                                                                          \
        return ix_crv_ruled(ctx, a->mv[0], kind, a->num, o, rep, out);         \
    }
#define CURVE(fn, call)                                                        \
    static ix_status fn(ix_ctx *ctx, const ix_op_args *a, const ix_op_opts *o, \
                        ix_report *rep, ix_mv **out)                           \
    {                                                                          \
        return call(ctx, a->mv[0], o, rep, out);                               \
    }
#define SQUARE(fn, kind)                                                       \
    static ix_status fn(ix_ctx *ctx, const ix_op_args *a, const ix_op_opts *o, \
                        ix_report *rep, ix_mv **out)                           \
    {                                                                          \
        return ix_srf_curvature(ctx, a->mv[0], kind, o, rep, out);             \
    }

FIELD(inflection, IX_CRV_INFLECTION)
FIELD(critical, IX_CRV_CRITICAL)
FIELD(critical_direct, IX_CRV_CRITICAL_DIRECT)
FIELD(curvature_sqr, IX_CRV_CURVATURE_SQR)
FIELD(torsion_zero, IX_CRV_TORSION_ZERO)
FIELD(torsion, IX_CRV_TORSION)
RULED(tangent, IX_RULED_TANGENT)
RULED(normal, IX_RULED_NORMAL)
RULED(binormal, IX_RULED_BINORMAL)
RULED(rectifying, IX_RULED_RECTIFYING)
RULED(polar, IX_RULED_POLAR)
CURVE(normal_field, ix_crv_normal_field)
CURVE(evolute, ix_evolute)
CURVE(focal, ix_focal_crv)

static ix_status bisector3d(ix_ctx *ctx, const ix_op_args *a,
                            const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    return ix_cbisector3d(ctx, a->mv[0], a->mv[1], o, rep, out);
}

/* The numbers are the point. */
static ix_status point_bisector(ix_ctx *ctx, const ix_op_args *a,
                                const ix_op_opts *o, ix_report *rep,
                                ix_mv **out)
{
    return ix_pt_crv_bisector(ctx, a->mv[0], a->num, 0.5, o, rep, out);
}

static ix_status point_planes(ix_ctx *ctx, const ix_op_args *a,
                              const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    return ix_pt_crv_bisector3d(ctx, a->mv[0], a->num, 0.5, NULL, o, rep, out);
}

static ix_status point_directrix(ix_ctx *ctx, const ix_op_args *a,
                                 const ix_op_opts *o, ix_report *rep,
                                 ix_mv **out)
{
    static const ix_ruling r = {IX_RULING_DIRECTRIX, {0, 0}, {0, 0, 0}};

    return ix_pt_crv_bisector3d(ctx, a->mv[0], a->num, 0.5, &r, o, rep, out);
}

static ix_status surface_bisector(ix_ctx *ctx, const ix_op_args *a,
                                  const ix_op_opts *o, ix_report *rep,
                                  ix_mv **out)
{
    return ix_pt_srf_bisector(ctx, a->mv[0], a->num, o, rep, out);
}

static ix_status gauss(ix_ctx *ctx, const ix_op_args *a, const ix_op_opts *o,
                       ix_report *rep, ix_mv **out)
{
    return ix_srf_gauss(ctx, a->mv[0], false, o, rep, out);
}

static ix_status gauss_numerator(ix_ctx *ctx, const ix_op_args *a,
                                 const ix_op_opts *o, ix_report *rep,
                                 ix_mv **out)
{
    return ix_srf_gauss(ctx, a->mv[0], true, o, rep, out);
}

static ix_status mean(ix_ctx *ctx, const ix_op_args *a, const ix_op_opts *o,
                      ix_report *rep, ix_mv **out)
{
    return ix_srf_mean(ctx, a->mv[0], false, o, rep, out);
}

static ix_status mean_numerator(ix_ctx *ctx, const ix_op_args *a,
                                const ix_op_opts *o, ix_report *rep,
                                ix_mv **out)
{
    return ix_srf_mean(ctx, a->mv[0], true, o, rep, out);
}

SQUARE(total_curvature, IX_SRF_TOTAL)
SQUARE(curvature_along_u, IX_SRF_ALONG_U)
SQUARE(curvature_along_v, IX_SRF_ALONG_V)

/* The number is the direction. */
static ix_status srf_focal(ix_ctx *ctx, const ix_op_args *a,
                           const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    return ix_srf_focal(ctx, a->mv[0], a->num[0] != 0.0, o, rep, out);
}

/* No report. */
static ix_status dual(ix_ctx *ctx, const ix_op_args *a, const ix_op_opts *o,
                      ix_report *rep, ix_mv **out)
{
    (void)rep;
    return ix_duality(ctx, a->mv[0], o, out);
}

/* The numbers are the point and the factor. */
static ix_status orthotomic(ix_ctx *ctx, const ix_op_args *a,
                            const ix_op_opts *o, ix_report *rep, ix_mv **out)
{
    (void)rep;
    return ix_orthotomic(ctx, a->mv[0], a->num, a->num[3], o, out);
}

CURVE(srf_evolute, ix_srf_evolute)

enum { ALL = 15, NO_IRIT = 7, NO_PUBLISHED = 13, ONLY_NAIVE = 4 };

/* Fields have the names of the functions that look for their zeros; the
 * number is the op of these functions, told by two names. */
const ix_op ix__ops[] = {
    {"CINFLECT", {1, 0}, 0, ALL, inflection},
    {"CCRVTR", {1, 0}, 0, ALL, critical},
    {"CCRVTRDIRECT", {1, 0}, 0, ONLY_NAIVE, critical_direct},
    {"CCRVTRSQR", {1, 0}, 0, ALL, curvature_sqr},
    {"CTORSION", {1, 0}, 0, NO_IRIT, torsion},
    {"CTORSIONZERO", {1, 0}, 0, NO_IRIT, torsion_zero},
    {"CNRMLCRV", {1, 0}, 0, ALL, normal_field},
    {"EVOLUTE", {1, 0}, 0, ALL, evolute},
    {"FOCALCRV", {1, 0}, 0, NO_IRIT, focal},
    {"FOCALSRF", {1, 0}, 2, NO_IRIT, polar},
    {"TANDEVSRF", {1, 0}, 2, NO_IRIT, tangent},
    {"NRMLSCROLL", {1, 0}, 2, NO_IRIT, normal},
    {"BINRMLSCROLL", {1, 0}, 2, NO_IRIT, binormal},
    {"RECTDEVSRF", {1, 0}, 2, NO_IRIT, rectifying},
    {"CBISECTOR3D", {1, 1}, 0, ALL, bisector3d},
    {"CBISECTOR3DPT", {1, 0}, 3, ALL, point_planes},
    {"CBISECTOR3DPTDIR", {1, 0}, 3, ALL, point_directrix},
    {"SBISECTOR", {2, 0}, 3, NO_PUBLISHED, surface_bisector},
    {"PTCRVBISECT", {1, 0}, 2, ALL, point_bisector},
    {"SGAUSS", {2, 0}, 0, NO_PUBLISHED, gauss},
    {"SGAUSSNUM", {2, 0}, 0, NO_PUBLISHED, gauss_numerator},
    {"SMEAN", {2, 0}, 0, NO_PUBLISHED, mean},
    {"SMEANNUM", {2, 0}, 0, NO_PUBLISHED, mean_numerator},
    {"SCRVTR", {2, 0}, 0, NO_PUBLISHED, total_curvature},
    {"SCRVTRCOL", {2, 0}, 0, NO_PUBLISHED, curvature_along_u},
    {"SCRVTRROW", {2, 0}, 0, NO_PUBLISHED, curvature_along_v},
    {"EVOLUTE", {2, 0}, 0, NO_PUBLISHED, srf_evolute},
    {"SFOCAL", {2, 0}, 1, NO_PUBLISHED, srf_focal},
    {"DUALITY", {1, 0}, 0, NO_PUBLISHED, dual},
    {"DUALITY", {2, 0}, 0, NO_PUBLISHED, dual},
    {"ORTHOTOMC", {1, 0}, 4, NO_PUBLISHED, orthotomic},
    {"ORTHOTOMC", {2, 0}, 4, NO_PUBLISHED, orthotomic},
    {NULL, {0, 0}, 0, 0, NULL}};

const ix_op *ix__op_find(const char *name)
{
    const ix_op *op = ix__ops;

    while (op->name && strcasecmp(op->name, name) != 0)
        op++;
    return op->name ? op : NULL;
}
