/* ast_impl.h - the parsed form of a statement.
 *
 * A unit holds everything that belongs to one statement or one user function:
 * an arena with its nodes and names, and the source lines for messages. Units
 * are counted; a function keeps its unit, a plain statement's unit is used
 * again for the next one. Names are resolved while parsing: a node points to
 * the global symbol or holds the index of a local. */
#ifndef LANG_AST_IMPL_H
#define LANG_AST_IMPL_H

#include "lang/types_impl.h"

typedef struct ix__sym ix__sym; /* a global name, lang/interp_impl.h */
typedef struct ix__fn ix__fn;
typedef struct ix__node ix__node;

/* A place in a unit: index of the source line, 1-based column. */
typedef struct {
    unsigned line, col;
} ix__pos;

typedef enum {
    N_NUM,
    N_STR,
    N_GLOBAL,  /* u.sym */
    N_LOCAL,   /* u.slot: index in the present activation */
    N_OUTER,   /* u.slot: index in the whole stack; EXEC only */
    N_UNBOUND, /* u.sym: did not exist when the function was defined */
    N_NEG,
    N_NOT,
    N_BINARY, /* op; kid[0] left, kid[1] right */
    N_CHAIN,  /* u.steps[i] between kid[i] and kid[i + 1], left associative */
    N_ASSIGN, /* kid[0] the variable, kid[1] the value */
    N_CALL,   /* u.bi: a built-in */
    N_USER,   /* u.sym: a user function or procedure */
    N_SEQ,
    N_IF,
    N_FOR,
    N_WHILE,
    N_FUNDEF /* u.fn */
} ix__kind;

/* One operator of a chain. */
typedef struct {
    ix__op op;
    ix__pos pos;
} ix__step;

struct ix__node {
    ix__kind kind;
    ix__op op;
    ix__pos pos;
    int n; /* kids */
    ix__node **kid;
    ix_obj *box; /* N_NUM, N_STR: made when first needed */
    ix__node *next_lit;
    union {
        struct {
            double num;
            const char *constant; /* its name, if it was one */
        } lit;
        struct {
            const char *s;
            size_t len;
        } str;
        ix__sym *sym;
        size_t slot;
        const ix__bi *bi;
        const ix__step *steps;
        ix__fn *fn;
    } u;
};

typedef struct {
    const char *file;
    int number;
    const char *text;
} ix__line;

typedef struct ix__block ix__block;
typedef struct {
    int refs;
    ix_ctx *ctx;
    ix__block *blocks;
    ix__node *lits; /* the literals that have a box */
    ix__line *line;
    unsigned nlines, cap_lines;
} ix__unit;

/* A user function or procedure; lives in its unit's arena. */
struct ix__fn {
    ix__unit *unit;
    const char *name;
    bool is_procedure;
    bool is_startup;
    int nparams, nslots; /* slots: parameters, locals, RETURN, locals that were
                            not declared */
    int result, cap_slots; /* result: the slot of RETURN */
    const char **slot_name;
    ix__node *body;
    ix__pos pos;
};

ix__unit *ix__unit_new(ix_ctx *ctx); /* one reference, NULL: no memory */
ix__unit *ix__unit_ref(ix__unit *u);
void ix__unit_unref(ix__unit *u); /* u may be NULL */
/* Forgets all nodes and lines, keeps the first block. Only with one reference.
 */
void ix__unit_clear(ix__unit *u);
/* Zeroed memory that lives as long as the unit; NULL: no memory. */
void *ix__unit_alloc(ix__unit *u, size_t size);
const char *ix__unit_text(ix__unit *u, const char *s, size_t n);
/* Adds a source line; its index is nlines - 1 afterwards. */
ix_status ix__unit_add_line(ix__unit *u, const char *file, int number,
                            const char *text, size_t n) IX_MUST_CHECK;
/* The box of a literal (borrowed); NULL: no memory. A fresh one is made when
 * somebody kept the last one. */
ix_obj *ix__node_box(ix__unit *u, ix__node *n);
bool ix__node_is_var(const ix__node *n);
/* The slot of a name, -1: none. Adding keeps name, which lives in the unit or
 * longer. */
int ix__fn_slot(const ix__fn *fn, const char *name);
ix_status ix__fn_add_slot(ix__fn *fn, const char *name) IX_MUST_CHECK;

#endif
