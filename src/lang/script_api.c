/* script_api.c - the public face of the interpreter (iritx/script.h). */
#include "iritx/script.h"

#include <string.h>

#include "lang/interp.h"

ix_status ix_script_new(ix_ctx *ctx, ix_script **out)
{
    const ix_interp_opts defaults = {.max_calls = 0};

    return ix__interp_new(ctx, &defaults, out);
}

void ix_script_free(ix_script *s)
{
    ix__interp_free(s);
}

ix_status ix_script_run(ix_script *s, const char *name, const char *text)
{
    return ix__interp_run_text(s, name, text, strlen(text));
}

ix_status ix_script_run_file(ix_script *s, const char *name)
{
    return ix__interp_run_file(s, name);
}

ix_obj *ix_script_get(ix_script *s, const char *name)
{
    return ix__var_find(s, name);
}

ix_status ix_script_set(ix_script *s, const char *name, const ix_obj *o)
{
    return ix__var_set(s, name, o);
}
