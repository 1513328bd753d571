/* cmd.c - the table of subcommands. */
#include "app/cmd.h"

#include <string.h>

static const command commands[] = {
    {"--call", "[-v] [--limit S] IN OUT",
     "answers the request in one file by another", cmd_call},
    {"--irit-client", "[-v] [--idle S] [--limit S]",
     "answers requests of the IRIT that started it by CLNTEXEC",
     cmd_irit_client},
    {"--pipes", "[-v] [--idle S] [--limit S] DIR",
     "answers requests through named pipes in DIR", cmd_pipes},
    {"convert", "[--tol X] IN OUT",
     "reads one file and writes another; suffixes decide", cmd_convert},
    {"draw", "FILE... -o PICTURE",
     "a picture (.svg .png .pdf): --net --knots --shade --fit --no-axes, "
     "--view V, --size WxH",
     cmd_draw},
    {"degrees", "[--op NAME...] [--format text|csv|xml] FILE",
     "degrees of all operators and forms for the curves of a file",
     cmd_degrees},
    {"info", "FILE...", "what files hold: names, types, orders, boxes",
     cmd_info},
    {"view", "FILE... -o PAGE", "a page that shows geometry in a browser",
     cmd_view},
    {"validate", "FILE...", "checks XML files by schema and contents",
     cmd_validate},
};
#define NCOMMANDS (sizeof commands / sizeof *commands)

const command *cmd_find(const char *name)
{
    for (size_t i = 0; i < NCOMMANDS; i++)
        if (strcmp(commands[i].name, name) == 0)
            return &commands[i];
    return NULL;
}

void cmd_usage(FILE *f)
{
    for (size_t i = 0; i < NCOMMANDS; i++) {
        char left[64];

        (void)snprintf(left, sizeof left, "%s %s", commands[i].name,
                       commands[i].args);
        (void)fprintf(f, "  %-22s %s\n", left, commands[i].help);
    }
}

void cmd_help(const command *c)
{
    (void)printf("usage: iritx %s %s\n%s\n", c->name, c->args, c->help);
}

int cmd_complain(const ix_ctx *ctx)
{
    (void)fprintf(stderr, "iritx: error: %s\n", ix_ctx_message(ctx));
    return 1;
}

int cmd_wrong_usage(const char *name)
{
    const command *c = cmd_find(name);

    (void)fprintf(stderr, "usage: iritx %s %s\n", name, c ? c->args : "");
    return 2;
}
