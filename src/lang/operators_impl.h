/* operators_impl.h - the functions behind the operator table. Operands have
 * the types of their rows; *out is a new reference. */
#ifndef LANG_OPERATORS_IMPL_H
#define LANG_OPERATORS_IMPL_H

#include "lang/types_impl.h"

#define IX_BINARY(name)                                                        \
    ix_status ix__op_##name(ix_interp *in, ix_obj *l, ix_obj *r, ix_obj **out) \
        IX_MUST_CHECK

/* operators_simple.c: strings, points, matrices, lists */
IX_BINARY(str_str);
IX_BINARY(add_str_num);
IX_BINARY(pow_str_num);
IX_BINARY(add_pv);
IX_BINARY(sub_pv);
IX_BINARY(dot);
IX_BINARY(cross);
IX_BINARY(scale);
IX_BINARY(add_mat);
IX_BINARY(sub_mat);
IX_BINARY(mul_mat);
IX_BINARY(mat_power);
IX_BINARY(add_list);
/* Negates o itself; false if o is not of one of these simple types. */
bool ix__op_negate_simple(ix_obj *o);
/* operators_geom.c: curves, surfaces, polys, transformation */
IX_BINARY(add_ctlpt);
IX_BINARY(add_curve);
IX_BINARY(add_poly_pt);
IX_BINARY(polyline);
IX_BINARY(merge);
IX_BINARY(dot_freeform);
IX_BINARY(transform);

#endif
