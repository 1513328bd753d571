/* complete.c - the names that a person may type: built-ins, the start-up
 * library, constants, keywords, and what the session has defined. */
#define _POSIX_C_SOURCE 200809L
#include "app/complete.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "lang/startup.h"
#include "lang/types_impl.h"

typedef struct {
    const char *text;
    size_t n;
    bool within;
    const char **out;
    size_t found, max;
} search;

static bool fits(const search *s, const char *name)
{
    do {
        if (strncasecmp(name, s->text, s->n) == 0)
            return true;
    } while (s->within && *name++);
    return false;
}

static void offer(search *s, const char *name)
{
    if (s->found < s->max && fits(s, name))
        s->out[s->found++] = name;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

static size_t without_doubles(const char **name, size_t n)
{
    size_t kept = 0;

    for (size_t i = 0; i < n; i++)
        if (kept == 0 || strcmp(name[kept - 1], name[i]) != 0)
            name[kept++] = name[i];
    return kept;
}

static void offer_language(search *s)
{
    static const char *const keywords[] = {"IF", "FOR", "WHILE", "FUNCTION",
                                           "PROCEDURE"};
    const ix_builtin *row;
    const char *name;
    double v;

    for (size_t i = 0; i < sizeof keywords / sizeof *keywords; i++)
        offer(s, keywords[i]);
    for (size_t i = 0; (row = ix__builtin_at(i)); i++)
        offer(s, row->name);
    for (const ix__startup_fn *f = ix__startup_text; f->name; f++)
        offer(s, f->name);
    for (size_t i = 0; (name = ix__constant_at(i, &v)); i++)
        offer(s, name);
}

size_t complete_names(ix_interp *in, const char *prefix, size_t n, bool within,
                      const char **out, size_t max)
{
    search s = {prefix, n, within, out, 0, max};
    const char *name;
    const ix_obj *o;

    offer_language(&s);
    for (size_t i = 0; (name = ix__fn_at(in, i)); i++)
        offer(&s, name);
    for (size_t i = 0; (o = ix__var_at(in, i)); i++)
        if (o->name)
            offer(&s, o->name);
    qsort(out, s.found, sizeof *out, by_name);
    return without_doubles(out, s.found);
}
