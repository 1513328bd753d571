/* options.h - the command line. */
#ifndef APP_OPTIONS_H
#define APP_OPTIONS_H

#include "app/cmd.h"
#include "lang/interp.h"

typedef enum { RUN_FILE, RUN_TEXT, RUN_DEFINE, RUN_PLUGIN } run_kind;
/* What to run, in the order given. */
typedef struct {
    run_kind kind;
    const char *arg; /* file name; text; NAME=VALUE; shared object */
} run_item;

typedef enum { DO_RUN, DO_HELP, DO_LIST, DO_VERSION, DO_COMMAND } task;

typedef struct {
    task task;
    const char *topic;  /* of --help; NULL: the program itself */
    const char *output; /* -o */
    int degree_form, threads;
    size_t max_memory; /* bytes; 0: no limit */
    ix_interp_opts interp;
    const command *command; /* with what stands behind its name */
    int nargs;
    char **args;
    int nitems;
    run_item *item; /* as many as there are arguments */
} options;

/* Reads the arguments; item has room for argc. False after a message on
 * standard error (exit code 2). */
bool options_read(int argc, char **argv, options *o);
void options_usage(FILE *f);

#endif
