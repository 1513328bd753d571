/* interp_impl.h - the interpreter's inside: symbols, activations, messages.
 *
 * Symbols live as long as the interpreter, so that nodes may point to them.
 * A variable is a box in a symbol or in the stack of locals; assignment
 * replaces the box's value in place, so every list that holds the box sees
 * it. */
#ifndef LANG_INTERP_IMPL_H
#define LANG_INTERP_IMPL_H

#include "lang/interp.h"
#include "lang/lexer_impl.h"

struct ix__sym {
    ix__sym *next;        /* in its bucket */
    ix_obj *box;          /* NULL: not defined */
    ix__fn *fn;           /* the user function of this name */
    ix__types declared;   /* --check: types that an assignment would give */
    unsigned long parsed; /* the last statement that assigns it, or the
                             complement of one that missed it */
    bool no_startup;      /* its start-up function was freed */
    char name[];          /* upper case */
};

typedef struct {
    const ix__fn *fn;
    size_t base; /* of its slots */
    const ix__unit *caller;
    ix__pos call;
} ix__frame;

#define IX_TRACE 10
typedef struct {
    ix__unit *unit; /* a reference; NULL: no place */
    ix__pos pos;
    bool set;
    int ntrace, nmore;
    struct {
        const char *fn, *file;
        int line;
    } trace[IX_TRACE];
} ix__place;

struct ix_interp {
    ix_ctx *ctx;
    ix_interp_opts opt;
    ix_states states;

    ix__sym **bucket;
    size_t nbuckets;
    ix__sym **sym; /* in the order of creation */
    size_t nsyms, cap_syms;
    char **file_name; /* interned names of sources */
    size_t nfiles, cap_files;

    ix_obj **stack;              /* locals; NULL: not defined */
    size_t top, base, cap_stack; /* base: of the running function's */
    ix__frame *frame;
    int nframes;
    size_t cap_frames;

    ix__unit *unit;     /* of the code that runs */
    ix__pos here;       /* what runs, for remarks */
    ix__unit *spare;    /* an empty unit for the next statement */
    ix__reader *rd;     /* the innermost reader of files */
    unsigned long step; /* statements and rounds so far */
    unsigned long parse_no;
    uintptr_t stack_base; /* of the C stack, at the outermost run */
    bool exiting;

    ix__place place;           /* of the failure under way */
    bool soft;                 /* it is a soft one, and ... */
    const ix__node *soft_node; /* ... this call gave no value */
    int nerrors, nshown;

    FILE *out, *log; /* NULL: standard output; no log */
    FILE *err;       /* messages; NULL: standard error */
    char *log_name;
    bool log_on;
    bool mid_line; /* standard output does not end with a newline */
    int out_errno; /* why output could not be written; 0: it could */
    ix_buf text;   /* of the value being printed */
    ix_obj *viewed;
    char *root;       /* real path of the directory that files stay below */
    char *script_dir; /* ... of the script on the command line */
};

/* --- symbols (scope.c) ---------------------------------------------------- */
/* A block of *cap items grown to at least twice that (64); NULL: no memory. */
void *ix__grow(ix_ctx *ctx, void *p, size_t *cap, size_t item);
/* The symbol of a name (any case), made if there is none. NULL: no memory. */
ix__sym *ix__sym_get(ix_interp *in, const char *name);
ix__sym *ix__sym_find(ix_interp *in, const char *name); /* NULL: none */
void ix__syms_free(ix_interp *in);
/* The name with a long life, for places and messages. NULL: no memory. */
const char *ix__intern_file(ix_interp *in, const char *name);
/* *slot = o in place. Takes over o (a new reference), whose value is moved
 * out when nobody else holds it. name NULL: the box stays unnamed. */
ix_status ix__slot_take(ix_interp *in, ix_obj **slot, const char *name,
                        ix_obj *o) IX_MUST_CHECK;
/* *slot = v. */
ix_status ix__slot_number(ix_interp *in, ix_obj **slot, const char *name,
                          double v) IX_MUST_CHECK;
/* The box of a name at run time, by ix__var_find's rule: where it is kept. */
ix_obj **ix__slot_find(ix_interp *in, const char *name);
/* Index in the stack of a parameter or local of a running function. */
bool ix__slot_outer(const ix_interp *in, const char *name, size_t *slot);
/* Room for n more slots, set to NULL. */
ix_status ix__stack_push(ix_interp *in, size_t n) IX_MUST_CHECK;
void ix__stack_pop(ix_interp *in, size_t n);
/* Gives a user function its name; appends to USR_FN_LIST unless it is of the
 * start-up library. Keeps a reference to fn's unit. */
ix_status ix__fn_define(ix_interp *in, ix__fn *fn) IX_MUST_CHECK;
/* The predefined variables. */
ix_status ix__predefine(ix_interp *in) IX_MUST_CHECK;

/* --- parsing (parser.c, check.c) ------------------------------------------ */
/* Reads and checks one statement into u. *out is NULL for an empty one; *end
 * is set when the input ended instead. dynamic: names are looked up among the
 * running activations first. */
ix_status ix__parse(ix_interp *in, ix__reader *rd, ix__unit *u, bool dynamic,
                    ix__node **out, bool *end) IX_MUST_CHECK;
/* What the static check needs to know of the statement. */
typedef struct {
    unsigned long parse_no; /* symbols that it assigns carry this */
    bool calls;             /* it calls user functions or EXEC */
    ix__fn *fn;             /* that it defines */
} ix__checks;
/* The static check: undefined names, argument counts and types. */
ix_status ix__check(ix_interp *in, ix__unit *u, const ix__checks *c,
                    ix__node *n) IX_MUST_CHECK;
/* The user function that a call of name would reach; compiles one of the
 * start-up library. *out NULL: none. */
ix_status ix__fn_lookup(ix_interp *in, const char *name,
                        ix__sym **out) IX_MUST_CHECK;

/* --- running (eval.c, exec.c) --------------------------------------------- */
/* A value: a new reference, or a number without a box. */
typedef struct {
    ix_obj *o; /* NULL: the number */
    double num;
    bool none; /* a call that gave no value */
} ix__val;
/* The value of a node of in->unit. A call that gives none is an error ... */
ix_status ix__eval(ix_interp *in, ix__node *n, ix__val *v) IX_MUST_CHECK;
/* ... or allowed. */
ix_status ix__eval_maybe(ix_interp *in, ix__node *n, ix__val *v) IX_MUST_CHECK;
/* As a box (a new reference): a variable's own, with its name. */
ix_status ix__eval_box(ix_interp *in, ix__node *n, ix_obj **out) IX_MUST_CHECK;
ix_status ix__eval_num(ix_interp *in, ix__node *n, const char *what,
                       double *out) IX_MUST_CHECK;
/* The box of a variable (borrowed, perhaps without a name yet). Err IX_EARG it
 * is not defined. */
ix_status ix__node_var_box(ix_interp *in, const ix__node *n,
                           ix_obj **out) IX_MUST_CHECK;
/* Where a variable's box is kept; its name. */
ix_obj **ix__node_slot(ix_interp *in, const ix__node *n);
const char *ix__node_name(const ix_interp *in, const ix__node *n);
/* Runs a statement of in->unit. */
ix_status ix__exec(ix_interp *in, ix__node *n) IX_MUST_CHECK;
ix_status ix__assign(ix_interp *in, ix__node *n) IX_MUST_CHECK;
/* One step of fuel, and a look at the cancel flag. */
ix_status ix__tick(ix_interp *in) IX_MUST_CHECK;
/* Prints a value as an expression statement; refs is what the header shows. */
ix_status ix__print_value(ix_interp *in, const ix_obj *o,
                          int refs) IX_MUST_CHECK;

/* A new activation of fn, called from the place call of in->unit. Err IX_EARG
 * (place recorded) too many, or most of the C stack is used up. */
ix_status ix__frame_push(ix_interp *in, const ix__fn *fn, size_t base,
                         ix__pos call) IX_MUST_CHECK;

/* --- files (paths.c) ------------------------------------------------------ */
#define IX_PATH 4096
ix_status ix__paths_init(ix_interp *in) IX_MUST_CHECK;
/* Scripts beside this one may be included. */
ix_status ix__paths_script(ix_interp *in, const char *script) IX_MUST_CHECK;
/* The path of a script to include from the file from. Err IX_EIO. */
ix_status ix__path_include(ix_interp *in, const char *name, const char *from,
                           char out[IX_PATH]) IX_MUST_CHECK;

/* --- messages (report.c) ---------------------------------------------------
 */
/* Where the failure just recorded in the context arose, unless a place is
 * known already. */
void ix__at(ix_interp *in, ix__unit *u, ix__pos pos);
/* The same, and yields the status st. */
#define IX_AT(in, u, pos, st) (ix__at((in), (u), (pos)), (st))
/* Records a message and its place, yields the literal IX_EARG. */
#define IX_FAIL_AT(in, u, pos, ...)                  \
    ((void)IX_FAIL((in)->ctx, IX_EARG, __VA_ARGS__), \
     IX_AT((in), (u), (pos), IX_EARG))
/* Prints the failure under way and forgets its place. */
void ix__report(ix_interp *in, bool soft);
/* A soft error or remark of its own at a place. */
void ix__complain(ix_interp *in, ix__unit *u, ix__pos pos, bool counts,
                  const char *text);
void ix__flush(ix_interp *in);

#endif
