/* arrangements.c - see the header. Names are not used twice in a run as long as
 * a later one is still there. */
#include "lang/arrangements.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ctx.h"

ix_status ix__kept_add(ix_interp *in, ix_arrangement *a, const double back[16],
                       ix__kept **out)
{
    ix__kept **all = &ix__states(in)->kept;
    ix_ctx *ctx = ix__interp_ctx(in);
    ix__kept *k = ix__alloc(ctx, sizeof *k);
    long last = *all ? strtol((*all)->name + strlen("ARRANGEMENT"), NULL, 10)
                     : 0;

    if (!k) {
        ix_arrangement_free(ctx, a);
        return IX_ENOMEM;
    }
    *k = (ix__kept){.next = *all, .a = a};
    memcpy(k->back, back, sizeof k->back);
    (void)snprintf(k->name, sizeof k->name, "ARRANGEMENT%ld", last + 1);
    *all = *out = k;
    return IX_OK;
}

ix__kept *ix__kept_find(ix_interp *in, const char *name)
{
    ix__kept *k = ix__states(in)->kept;

    while (k && ix__name_cmp(k->name, name) != 0)
        k = k->next;
    return k;
}

static void release(ix_ctx *ctx, ix__kept *k)
{
    ix_arrangement_free(ctx, k->a);
    ix__free(ctx, k, sizeof *k);
}

void ix__kept_drop(ix_interp *in, ix__kept *k)
{
    ix__kept **at = &ix__states(in)->kept;

    while (*at != k)
        at = &(*at)->next;
    *at = k->next;
    release(ix__interp_ctx(in), k);
}

void ix__kept_free_all(ix_ctx *ctx, ix__kept **all)
{
    while (*all) {
        ix__kept *k = *all;

        *all = k->next;
        release(ctx, k);
    }
}
