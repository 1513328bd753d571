/* cmd.h - subcommands: "iritx [options] NAME arguments".
 *
 * One row of the table in cmd.c per command, one file cmd_<name>.c each. A
 * command prints its results on standard output, its errors through
 * cmd_complain, and returns the exit code. */
#ifndef APP_CMD_H
#define APP_CMD_H

#include <stdio.h>

#include "io/io.h"

typedef struct {
    const char *name, *args, *help; /* for the usage */
    /* argv[0 .. argc) stand behind the name of the command. */
    int (*run)(ix_ctx *ctx, int argc, char **argv);
} command;

const command *cmd_find(const char *name); /* NULL if there is none */
void cmd_usage(FILE *f);
void cmd_help(const command *c); /* iritx NAME --help */

/* "iritx: error: " and the context's message; returns 1. */
int cmd_complain(const ix_ctx *ctx);
/* What the command is called with, for wrong arguments; returns 2. */
int cmd_wrong_usage(const char *name);

int cmd_call(ix_ctx *ctx, int argc, char **argv);
int cmd_irit_client(ix_ctx *ctx, int argc, char **argv);
int cmd_pipes(ix_ctx *ctx, int argc, char **argv);
int cmd_convert(ix_ctx *ctx, int argc, char **argv);
int cmd_draw(ix_ctx *ctx, int argc, char **argv);
int cmd_degrees(ix_ctx *ctx, int argc, char **argv);
int cmd_view(ix_ctx *ctx, int argc, char **argv);
int cmd_info(ix_ctx *ctx, int argc, char **argv);
int cmd_validate(ix_ctx *ctx, int argc, char **argv);

#endif
