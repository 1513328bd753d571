/* interp.h - the interpreter: variables, scopes, state, output, errors.
 *
 * What primitives may use of it. The parser and evaluator keep the rest in
 * interp_impl.h. */
#ifndef LANG_INTERP_H
#define LANG_INTERP_H

#include <stdio.h>

#include "io/io.h"
#include "lang/builtin.h"

/* Limits; 0 stands for the default in brackets. */
typedef struct {
    int max_calls;       /* nested user function calls [1000] */
    unsigned long steps; /* statements and loop rounds [no limit] */
    bool strict;         /* stop at the first error of any kind */
    bool check_only;     /* parse and type-check, run nothing */
    bool quiet;          /* no warnings */
    bool allow_system;   /* SYSTEM, and files outside root */
    const char *root;    /* files stay below it; NULL: the current directory */
    /* LOADEXT: loads a plug-in; NULL: there is no loader. */
    ix_status (*load_plugin)(ix_ctx *ctx, const char *path);
    bool allow_plugins;       /* LOADEXT of any file */
    const char *plugin_dir;   /* ... of files below this; NULL: none */
    const char *include_path; /* directories, ';' between them, where INCLUDE
                                 looks last; NULL: none */
    /* Reads a line of the script "-" for a person: appends it to line without
     * its newline; more: in the middle of a statement. False at the end.
     * Errors do not end such a script, nor does cancelling (the reader then
     * clears the flag). NULL: "-" is standard input, in batch. */
    bool (*read_line)(void *ud, bool more, ix_buf *line);
    void *read_ud;
    /* How a value that a person's statement gives is shown: appends the text
     * to b. False: as in batch. NULL: always so. */
    bool (*show_value)(void *ud, const ix_obj *o, ix_buf *b);
} ix_interp_opts;

ix_status ix__interp_new(ix_ctx *ctx, const ix_interp_opts *o,
                         ix_interp **out) IX_MUST_CHECK;
void ix__interp_free(ix_interp *in);

/* Runs a file ("-" is standard input) or a text. Returns IX_OK or the first
 * hard error's status; messages have been written to standard error. */
ix_status ix__interp_run_file(ix_interp *in, const char *name) IX_MUST_CHECK;
ix_status ix__interp_run_text(ix_interp *in, const char *name, const char *text,
                              size_t n) IX_MUST_CHECK;
/* Errors reported so far, soft ones included. */
int ix__interp_errors(const ix_interp *in);
/* What scripts gave to VIEWOBJ and friends since the last clear: a list. */
const ix_obj *ix__interp_viewed(const ix_interp *in);

/* --- for primitives
 * ----------------------------------------------------------- */
ix_ctx *ix__interp_ctx(ix_interp *in);
/* Script output (values, PRINTF): standard output, or PRINTFILE's file. */
void ix__out(ix_interp *in, const char *s, size_t n);
/* A remark or warning on standard error with the present place. */
void ix__remark(ix_interp *in, const char *fmt, ...) IX_PRINTF(2, 3);

/* Run-time look-up by name, any case: innermost activation first, then
 * outer ones, then globals. Borrowed; NULL if there is none. */
ix_obj *ix__var_find(ix_interp *in, const char *name);
/* Assigns in place as a script's "name = o" at top level would. */
ix_status ix__var_set(ix_interp *in, const char *name,
                      const ix_obj *o) IX_MUST_CHECK;
/* A numeric system variable such as RESOLUTION, or dflt. */
double ix__var_num(ix_interp *in, const char *name, double dflt);
ix_status ix__var_free(ix_interp *in, const char *name) IX_MUST_CHECK;
/* The global variable from is called to from now on; its box stays the same.
 * A variable that had this name is gone. */
ix_status ix__var_rename(ix_interp *in, const char *from,
                         const char *to) IX_MUST_CHECK;

/* States of IRITSTATE that primitives read. */
typedef struct {
    int bsp_prod_method;   /* 0, 1, 2 [2] */
    int dump_level;        /* [23] */
    int prim_type;         /* [0] */
    bool prim_rat_srfs;    /* [true] */
    double cmp_eps;        /* CmpObjEps [1e-14] */
    char float_format[64]; /* ["%-16.14lg"] */
    bool float_format_set; /* true once a script changed it: SAVE follows it */
    int degree_form;       /* 0 minimal, 1 published, 2 naive, 3 irit */
    uint64_t random;       /* RandomInit */
    bool echo_source;      /* [false] print each source line as it is read */
    bool debug_func;       /* [false] trace calls of user functions */
    struct ix__kept *kept; /* arrangements (lang/arrangements.h); freed with the
                              interpreter */
    double time_start;     /* processor seconds at TIME's last reset [start] */
    ix_attr *other;        /* the states that are only remembered, by name;
                              freed with the interpreter */
} ix_states;
ix_states *ix__states(ix_interp *in);

/* Text dump of a value as an expression statement prints it. */
ix_status ix__dump_value(ix_interp *in, const ix_obj *o,
                         ix_buf *b) IX_MUST_CHECK;
/* PRINTF's formatter: appends to b. Err IX_EARG (soft) as spec/functions 4. */
ix_status ix__printf(ix_interp *in, const char *fmt, const ix_obj *args,
                     ix_buf *b) IX_MUST_CHECK;

/* Sends script output to a file (created anew); NULL or "": back to standard
 * output. */
ix_status ix__out_redirect(ix_interp *in, const char *file) IX_MUST_CHECK;
/* A copy of what is printed: file NULL keeps the present name. */
ix_status ix__log(ix_interp *in, const char *file, bool on) IX_MUST_CHECK;
/* One line of standard input without its newline, appended to b; false at
 * the end of input. */
bool ix__in_line(ix_interp *in, ix_buf *b);
/* VIEWOBJ: adds a copy to the viewed list; NULL empties the list. */
ix_status ix__view(ix_interp *in, ix_obj *o) IX_MUST_CHECK;

/* The global variables and user functions one by one, in the order of their
 * definition; NULL past the last. The variable's name is o->name. */
ix_obj *ix__var_at(ix_interp *in, size_t i);
const char *ix__fn_at(ix_interp *in, size_t i);
/* Removes a user function; "" removes all in USR_FN_LIST. Err IX_EARG. */
ix_status ix__fn_free(ix_interp *in, const char *name) IX_MUST_CHECK;
/* RESET: all variables go, the predefined ones are made again. */
ix_status ix__var_reset(ix_interp *in) IX_MUST_CHECK;
/* EXIT: the interpreter ends once the primitive returns this value. */
ix_status ix__exit(ix_interp *in) IX_MUST_CHECK;

/* EXEC: parses and runs text as one statement now (";" is added), names
 * looked up as by ix__var_find; variables of the running functions can be
 * read and assigned. */
ix_status ix__exec_text(ix_interp *in, const char *text) IX_MUST_CHECK;
/* IX_OK if the options allow SYSTEM, else IX_EIO with what would. */
ix_status ix__system_check(ix_interp *in) IX_MUST_CHECK;

/* INCLUDE: queues a script (".irt" added if missing) to be run after the rest
 * of the present line. A file that cannot be read is a soft error, reported
 * here. Err IX_EARG it is being read already, or nested too deeply. */
ix_status ix__queue_file(ix_interp *in, const char *name) IX_MUST_CHECK;
/* name if the safe mode allows it, else IX_EIO with what would. writing:
 * for output. */
ix_status ix__path_check(ix_interp *in, const char *name,
                         bool writing) IX_MUST_CHECK;
/* The same for a directory that is to become the working one. */
ix_status ix__dir_check(ix_interp *in, const char *name) IX_MUST_CHECK;

/* LOADEXT: loads a plug-in if the options allow it. Err IX_EIO they do not, or
 * there is none; IX_EUNABLE there is no loader; what the loader returns. */
ix_status ix__plugin_open(ix_interp *in, const char *name) IX_MUST_CHECK;

/* The table row of a built-in (any case) or NULL; and all rows in order. */
const ix_builtin *ix__builtin_find(const char *name);
const ix_builtin *ix__builtin_at(size_t i); /* NULL past the last */

#endif
