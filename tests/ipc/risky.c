/* Functions that die, never end, or want memory: what a service must survive.
 */
#include <iritx/plugin.h>

#include <signal.h>
#include <stdio.h>
#include <string.h>

static ix_status t_die(const ix_host *h, ix_call *c)
{
    (void)signal((int)h->arg_num(c, 0), SIG_DFL);
    (void)raise((int)h->arg_num(c, 0));
    return h->ret_num(c, 0);
}

static ix_status t_loop(const ix_host *h, ix_call *c)
{
    volatile int forever = 1;

    while (forever)
        ;
    return h->ret_num(c, 0);
}

static ix_status t_eat(const ix_host *h, ix_call *c)
{
    char *p = h->scratch(c, (size_t)h->arg_num(c, 0), 1 << 20);

    if (!p)
        return IX_ENOMEM;
    return h->ret_num(c, 1);
}

static ix_status t_print(const ix_host *h, ix_call *c)
{
    (void)printf("this must not be seen\n");
    (void)fflush(stdout);
    return h->ret_num(c, 5);
}

/* A text of n letters; with quotes if n is negative. */
static ix_status t_text(const ix_host *h, ix_call *c)
{
    static char text[8192];
    double n = h->arg_num(c, 0);

    if (n < 0)
        return h->ret(c, h->string(h->ctx(c), "a \"b\" \\ c\nd", 11));
    memset(text, 'x', sizeof text);
    return h->ret(c, h->string(h->ctx(c), text, (size_t)n));
}

static const ix_plugin_row rows[] = {
    {"T_DIE", "signal:num -> num", "Dies.", "1;", t_die, 0, 0},
    {"T_LOOP", "-> num", "Never ends.", "1;", t_loop, 0, 0},
    {"T_EAT", "mb:num -> num", "Takes memory.", "1;", t_eat, 0, 0},
    {"T_PRINT", "-> num", "Prints.", "1;", t_print, 0, 0},
    {"T_TEXT", "n:num -> str", "A text.", "1;", t_text, 0, 0},
    {0}};

ix_status ix_plugin_init(const ix_host *h, ix_registry *r)
{
    return h->add(r, IX_PLUGIN_VERSION, rows);
}
