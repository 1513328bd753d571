/* registry.c - rows of plug-ins: each is checked, then all join the index of
 * built-ins, or none does. */
#include <ctype.h>
#include <string.h>

#include "lang/host.h"
#include "lang/interp.h"
#include "lang/startup.h"
#include "lang/types_impl.h"

#define MAX_NAME 64

/* As the lexer reads names; upper case, as tables have it. */
static bool is_name(const char *s)
{
    size_t n = strspn(s, "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_");

    return n > 0 && n <= MAX_NAME && !s[n] && !isdigit((unsigned char)*s);
}

/* What is wrong with a row; NULL: nothing. */
static const char *fault(const ix_plugin_row *row, ix__sig *sig)
{
    if (!is_name(row->name))
        return "the name must be letters in upper case, digits, underscores "
               "(at most 64)";
    if (!row->signature || !strstr(row->signature, "->") ||
        !ix__sig_parse(row->signature, sig))
        return "the signature is not like \"c:curve t:num [eps:num] -> point\"";
    if (!row->summary || !*row->summary)
        return "the summary is missing";
    if (!row->example || !*row->example)
        return "the example is missing";
    if (!row->fn)
        return "there is no C function";
    return NULL;
}

/* The first of n rows that has this name. */
static bool repeated(const ix_plugin_row *rows, int n, const char *name)
{
    for (int i = 0; i < n; i++)
        if (strcmp(rows[i].name, name) == 0)
            return true;
    return false;
}

static ix_status check_row(ix_ctx *ctx, const ix_plugin_row *rows, int i)
{
    const char *name = rows[i].name, *what;
    ix__sig sig;

    what = fault(&rows[i], &sig);
    if (what)
        return IX_FAIL(ctx, IX_EARG, "row %d (%.64s): %s", i + 1, name, what);
    if (ix__bi_find_so_far(name) || ix__startup_find(name) ||
        repeated(rows, i, name))
        return IX_FAIL(ctx, IX_EARG, "%s is a function already", name);
    return IX_OK;
}

ix_status ix__registry_add(ix_registry *r, unsigned version,
                           const ix_plugin_row *rows)
{
    int n = 0;

    if (version > IX_PLUGIN_VERSION)
        return IX_FAIL(r->ctx, IX_EUNABLE,
                       "it wants version %u of the plug-in interface, this "
                       "program has %d",
                       version, IX_PLUGIN_VERSION);
    if (r->ctx)
        (void)ix__builtin_at(0); /* the index is complete from here on */
    for (; rows[n].name; n++)
        IX_TRY(check_row(r->ctx, rows, n));
    IX_TRY(ix__bi_append(r->ctx, rows, n));
    r->added += n;
    return IX_OK;
}
