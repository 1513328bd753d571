/* table.c - operators by name, all with one signature. */
#define _POSIX_C_SOURCE 200809L
#include "ops/table.h"

#include <string.h>
#include <strings.h>

#include "iritx/ops_crv.h"

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

FIELD(inflection, IX_CRV_INFLECTION)
FIELD(critical, IX_CRV_CRITICAL)
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

enum { ALL = 15, NO_IRIT = 7, NO_NAIVE = 11 };

/* Fields have the names of the functions that look for their zeros; the
 * number is the op of these functions, told by two names. */
const ix_op ix__ops[] = {{"CINFLECT", {1, 0}, 0, ALL, inflection},
                         {"CCRVTR", {1, 0}, 0, ALL, critical},
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
                         {"CBISECTOR3D", {1, 1}, 0, NO_NAIVE, bisector3d},
                         {NULL, {0, 0}, 0, 0, NULL}};

const ix_op *ix__op_find(const char *name)
{
    const ix_op *op = ix__ops;

    while (op->name && strcasecmp(op->name, name) != 0)
        op++;
    return op->name ? op : NULL;
}
