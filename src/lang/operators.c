/* operators.c - the operators on values other than two numbers.
 *
 * One row of the table per combination of operand types; the static check
 * reads the types, the evaluator calls the function. Operands are borrowed,
 * results are new boxes. */
#include <math.h>
#include <string.h>

#include "lang/interp_impl.h"
#include "lang/operators_impl.h"

const char *ix__op_text(ix__op op)
{
    static const char *const text[] = {
        "+",  "-", "*",  "/",  "^",  "==", "!=", "<",
        "<=", ">", ">=", "&&", "||", "=",  "-",  "!"};

    return text[op];
}

/* --- numbers
 * ------------------------------------------------------------------- */

/* Conditions count as false below this, whatever their scale (spec/language
 * 5.7); NaN is false. */
#define TRUTH_EPS 1e-5

bool ix__truth(double x)
{
    return fabs(x) >= TRUTH_EPS;
}

static bool equal_numbers(const ix_interp *in, double a, double b)
{
    return a == b || fabs(a - b) < in->states.cmp_eps;
}

ix_status ix__op_numbers(ix_interp *in, ix__op op, double l, double r,
                         double *out)
{
    switch (op) {
    case OP_ADD:
        *out = l + r;
        return IX_OK;
    case OP_SUB:
        *out = l - r;
        return IX_OK;
    case OP_MUL:
        *out = l * r;
        return IX_OK;
    case OP_DIV:
        if (r == 0)
            return IX_FAIL(in->ctx, IX_EARG, "division by zero");
        *out = l / r;
        return IX_OK;
    case OP_POW:
        *out = pow(l, r);
        return IX_OK;
    case OP_EQ:
        *out = equal_numbers(in, l, r);
        return IX_OK;
    case OP_NE:
        *out = !equal_numbers(in, l, r);
        return IX_OK;
    case OP_LT:
        *out = l < r && !equal_numbers(in, l, r);
        return IX_OK;
    case OP_LE:
        *out = l < r || equal_numbers(in, l, r);
        return IX_OK;
    case OP_GT:
        *out = l > r && !equal_numbers(in, l, r);
        return IX_OK;
    case OP_GE:
        *out = l > r || equal_numbers(in, l, r);
        return IX_OK;
    case OP_AND:
        *out = ix__truth(l) && ix__truth(r);
        return IX_OK;
    case OP_OR:
        *out = ix__truth(l) || ix__truth(r);
        return IX_OK;
    default:
        return IX_FAIL(in->ctx, IX_EARG, "operator %s on two numbers",
                       ix__op_text(op));
    }
}

/* --- the table
 * ------------------------------------------------------------------- */

typedef ix_status (*binary_fn)(ix_interp *in, ix_obj *l, ix_obj *r,
                               ix_obj **out);
typedef struct {
    ix__types l, r, result;
    binary_fn fn; /* NULL: Boolean operations on solids, which we lack */
} rule;

#define NUM  IX_T(NUMBER)
#define STR  IX_T(STRING)
#define MAT  IX_T(MATRIX)
#define LST  IX_T(LIST)
#define CRV  IX_T(CURVE)
#define SRF  IX_T(SURFACE)
#define CTL  IX_T(CTLPT)
#define POLY IX_T(POLY)
#define VEC  IX_T(VECTOR)
#define PV   IX_T_PV
#define TRIM IX_T(TRIMSRF)
#define MDL  IX_T(MODEL)
/* What a matrix transforms. */
#define MOVABLE                                                              \
    (PV | IX_T(PLANE) | CTL | POLY | IX_T_FREE | TRIM | IX_T(TRISRF) | MDL | \
     IX_T(INSTANCE) | LST)

static const rule add_rules[] = {{NUM, NUM, NUM, NULL},
                                 {STR, STR, STR, ix__op_str_str},
                                 {NUM, STR, STR, ix__op_add_str_num},
                                 {STR, NUM, STR, ix__op_add_str_num},
                                 {PV, PV, VEC, ix__op_add_pv},
                                 {MAT, MAT, MAT, ix__op_add_mat},
                                 {LST, LST, LST, ix__op_add_list},
                                 {CTL, CTL, CRV, ix__op_add_ctlpt},
                                 {CRV | CTL, CRV, CRV, ix__op_add_curve},
                                 {CRV, CTL, CRV, ix__op_add_curve},
                                 {POLY, PV, POLY, ix__op_add_poly_pt},
                                 {PV, POLY, POLY, ix__op_add_poly_pt},
                                 {POLY, POLY, POLY, NULL},
                                 {SRF, SRF, SRF, NULL},
                                 {TRIM, TRIM, TRIM, NULL},
                                 {MDL, MDL, MDL, NULL},
                                 {0, 0, 0, NULL}};
static const rule sub_rules[] = {
    {NUM, NUM, NUM, NULL},           {PV, PV, VEC, ix__op_sub_pv},
    {MAT, MAT, MAT, ix__op_sub_mat}, {POLY, POLY, POLY, NULL},
    {SRF, SRF, SRF, NULL},           {TRIM, TRIM, TRIM, NULL},
    {MDL, MDL, MDL, NULL},           {0, 0, 0, NULL}};
static const rule mul_rules[] = {{NUM, NUM, NUM, NULL},
                                 {NUM, IX_T(POINT), IX_T(POINT), ix__op_scale},
                                 {IX_T(POINT), NUM, IX_T(POINT), ix__op_scale},
                                 {NUM, VEC, VEC, ix__op_scale},
                                 {VEC, NUM, VEC, ix__op_scale},
                                 {NUM, MAT, MAT, ix__op_scale},
                                 {MAT, NUM, MAT, ix__op_scale},
                                 {PV, PV, NUM, ix__op_dot},
                                 {VEC, CRV, CRV, ix__op_dot_freeform},
                                 {CRV, VEC, CRV, ix__op_dot_freeform},
                                 {VEC, SRF, SRF, ix__op_dot_freeform},
                                 {SRF, VEC, SRF, ix__op_dot_freeform},
                                 {MAT, MAT, MAT, ix__op_mul_mat},
                                 {MOVABLE, MAT, MOVABLE, ix__op_transform},
                                 {MAT, MOVABLE, MOVABLE, ix__op_transform},
                                 {POLY, POLY, POLY, NULL},
                                 {SRF, SRF, SRF, NULL},
                                 {TRIM, TRIM, TRIM, NULL},
                                 {MDL, MDL, MDL, NULL},
                                 {0, 0, 0, NULL}};
static const rule div_rules[] = {{NUM, NUM, NUM, NULL},
                                 {PV, PV, POLY, ix__op_polyline},
                                 {PV, POLY, POLY, ix__op_polyline},
                                 {POLY, PV, POLY, ix__op_polyline},
                                 {POLY, POLY, POLY, NULL},
                                 {SRF, SRF, SRF, NULL},
                                 {TRIM, TRIM, TRIM, NULL},
                                 {MDL, MDL, MDL, NULL},
                                 {0, 0, 0, NULL}};
static const rule pow_rules[] = {{NUM, NUM, NUM, NULL},
                                 {STR, STR, STR, ix__op_str_str},
                                 {NUM, STR, STR, ix__op_pow_str_num},
                                 {STR, NUM, STR, ix__op_pow_str_num},
                                 {PV, PV, VEC, ix__op_cross},
                                 {MAT, NUM, MAT, ix__op_mat_power},
                                 {POLY, POLY, POLY, ix__op_merge},
                                 {SRF, SRF, SRF, ix__op_merge},
                                 {TRIM, TRIM, TRIM, ix__op_merge},
                                 {0, 0, 0, NULL}};
static const rule order_rules[] = {
    {NUM, NUM, NUM, NULL}, {STR, STR, NUM, NULL}, {0, 0, 0, NULL}};
static const rule logic_rules[] = {{NUM, NUM, NUM, NULL}, {0, 0, 0, NULL}};

static const rule *rules_of(ix__op op)
{
    static const rule *const rules[] = {add_rules, sub_rules, mul_rules,
                                        div_rules, pow_rules};

    if (op <= OP_POW)
        return rules[op];
    return op >= OP_LT && op <= OP_GE ? order_rules : logic_rules;
}

/* Operands of == and != are of one type; a poly is a poly. */
#define COMPARABLE \
    (NUM | STR | PV | IX_T(PLANE) | CTL | MAT | POLY | IX_T_FREE | TRIM | LST)
/* What unary minus accepts; the result has the operand's type. */
#define NEGATABLE                                                         \
    (NUM | PV | IX_T(PLANE) | CTL | MAT | STR | CRV | SRF | TRIM | POLY | \
     MDL | LST)

ix__types ix__op_types(ix__op op, ix__types l, ix__types r)
{
    ix__types result = 0;

    if (op == OP_NEG)
        return l & NEGATABLE;
    if (op == OP_NOT)
        return l & NUM;
    if (op == OP_ASSIGN)
        return r;
    if (op == OP_EQ || op == OP_NE)
        return l & r & COMPARABLE ? NUM : 0;
    for (const rule *k = rules_of(op); k->l; k++) {
        if (!(k->l & l) || !(k->r & r))
            continue;
        if (k->result == MOVABLE) /* keeps the type of the object moved */
            result |= (k->r == MAT ? l : r) & MOVABLE;
        else
            result |= k->result;
    }
    return result;
}

ix__types ix__op_right(ix__op op, ix__types l)
{
    ix__types right = 0;

    if (op == OP_EQ || op == OP_NE)
        return l & COMPARABLE;
    for (const rule *k = rules_of(op); k->l; k++)
        if (k->l & l)
            right |= k->r;
    return right;
}

/* --- comparison
 * --------------------------------------------------------------------- */

static bool strings_compare(ix__op op, int c)
{
    switch (op) {
    case OP_EQ:
        return c == 0;
    case OP_NE:
        return c != 0;
    case OP_LT:
        return c < 0;
    case OP_LE:
        return c <= 0;
    case OP_GT:
        return c > 0;
    default:
        return c >= 0;
    }
}

static ix_status compare(ix_interp *in, ix__op op, const ix_obj *l,
                         const ix_obj *r, ix_obj **out)
{
    bool yes;

    if (l->type == IX_OBJ_STRING) {
        yes = strings_compare(op, strcmp(l->u.str.s, r->u.str.s));
    } else {
        IX_TRY(ix__obj_equal(in->ctx, l, r, in->states.cmp_eps, &yes));
        yes = yes == (op == OP_EQ);
    }
    *out = ix__obj_number(in->ctx, yes);
    return *out ? IX_OK : IX_ENOMEM;
}

/* --- dispatch
 * ------------------------------------------------------------------------ */

/* What unary op may have, or what may stand on the left of binary op. */
static ix__types operands(ix__op op)
{
    ix__types left = 0;

    if (op == OP_NEG)
        return NEGATABLE;
    if (op == OP_NOT)
        return NUM;
    if (op == OP_EQ || op == OP_NE)
        return COMPARABLE;
    for (const rule *k = rules_of(op); k->l; k++)
        left |= k->l;
    return left;
}

ix_status ix__op_mismatch(ix_interp *in, ix__op op, ix__types l, ix__types r)
{
    char a[200], b[200], c[400];
    ix__types right = op < OP_NEG ? ix__op_right(op, l) : 0;
    const char *left_text = ix__types_text(l, a, sizeof a);

    if (!right)
        return IX_FAIL(in->ctx, IX_EARG, "operator %s takes %s%s, got %s",
                       ix__op_text(op),
                       ix__types_text(operands(op), c, sizeof c),
                       op < OP_NEG ? " on its left" : "", left_text);
    return IX_FAIL(in->ctx, IX_EARG,
                   "operator %s with %s on its left takes %s on its right, "
                   "got %s",
                   ix__op_text(op), left_text,
                   ix__types_text(right, c, sizeof c),
                   ix__types_text(r, b, sizeof b));
}

ix_status ix__op_apply(ix_interp *in, ix__op op, ix_obj *l, ix_obj *r,
                       ix_obj **out)
{
    ix__types tl = 1u << l->type, tr = 1u << r->type;
    char a[64];

    *out = NULL;
    if (!ix__op_types(op, tl, tr))
        return ix__op_mismatch(in, op, tl, tr);
    if (l->type == IX_OBJ_NUMBER && r->type == IX_OBJ_NUMBER) {
        double v;

        IX_TRY(ix__op_numbers(in, op, l->u.num, r->u.num, &v));
        *out = ix__obj_number(in->ctx, v);
        return *out ? IX_OK : IX_ENOMEM;
    }
    if (op >= OP_EQ && op <= OP_GE)
        return compare(in, op, l, r, out);
    for (const rule *k = rules_of(op); k->l; k++) {
        if (!(k->l & tl) || !(k->r & tr))
            continue;
        if (k->fn)
            return k->fn(in, l, r, out);
    }
    return IX_FAIL(in->ctx, IX_EUNABLE,
                   "Boolean operations between solids (%s %s %s) are not "
                   "part of this program",
                   ix__types_text(tl, a, sizeof a), ix__op_text(op), a);
}
