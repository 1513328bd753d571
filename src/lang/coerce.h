/* coerce.h - COERCE: one kind of object made into another (spec/functions 3,
 * spec/model 4 and 11). */
#ifndef LANG_COERCE_H
#define LANG_COERCE_H

#include "object/object.h"

/* What a type number of a script asks for. */
typedef enum {
    IX_CODE_NONE,  /* no such number */
    IX_CODE_TYPE,  /* an ix_obj_type: type */
    IX_CODE_POINT, /* a control point type: ncoords, rational */
    IX_CODE_KNOTS, /* end conditions: kv */
    IX_CODE_BASIS  /* a basis: basis (GREGORY_TYPE is not one: none) */
} ix__code_kind;
typedef struct {
    ix__code_kind kind;
    ix_obj_type type;
    int ncoords;
    bool rational;
    ix_kv_kind kv;
    ix_basis basis;
} ix__code;

/* Codes are integers: others, and unknown ones, give IX_CODE_NONE. */
ix__code ix__code_of(double v);

/* o as code asks; lists element by element. The result keeps attributes when
 * it is one object made of one. Err IX_EARG "Invalid coercion requested: ...";
 * what the conversion itself gives. */
ix_status ix__coerce(ix_ctx *ctx, const ix_obj *o, double code,
                     ix_obj **out) IX_MUST_CHECK;

/* E1 .. P18 in words, "E3"; kind must be IX_CODE_POINT. */
void ix__code_point_name(int ncoords, bool rational, char buf[8]);

#endif
