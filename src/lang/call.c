/* call.c - calling a built-in: the steps that scripts and calls by name share.
 * Who calls by name sits outside, so files, commands and the variables of the
 * session stay out of its reach. */
#include "lang/call.h"

#include <stdio.h>
#include <string.h>

#include "lang/host.h"
#include "lang/interp_impl.h"
#include "lang/startup.h"

/* --- steps ---------------------------------------------------------------- */

ix_status ix__call_count(ix_ctx *ctx, const ix__bi *bi, int n)
{
    const ix__sig *s = &bi->sig;
    char count[32], sig[300];

    if (n >= s->nmin && (s->nmax < 0 || n <= s->nmax))
        return IX_OK;
    if (s->nmax < 0)
        (void)snprintf(count, sizeof count, "at least %d", s->nmin);
    else if (s->nmax > s->nmin)
        (void)snprintf(count, sizeof count, "%d to %d", s->nmin, s->nmax);
    else
        (void)snprintf(count, sizeof count, "%d", s->nmin);
    return IX_FAIL(ctx, IX_EARG, "%s takes %s argument%s, got %d: %s",
                   bi->row->name, count,
                   s->nmin == 1 && s->nmax == 1 ? "" : "s", n,
                   ix__sig_text(bi->row, sig, sizeof sig));
}

ix_status ix__arg_mismatch(ix_interp *in, const ix__bi *bi, int i,
                           ix__types got)
{
    char want[300], have[300];

    return IX_FAIL(in->ctx, IX_EARG, "argument %d of %s must be %s, got %s",
                   i + 1, bi->row->name,
                   ix__types_text(ix__sig_arg(&bi->sig, i), want, sizeof want),
                   ix__types_text(got, have, sizeof have));
}

int ix__call_misfit(const ix__bi *bi, int argc, ix_obj *const *argv)
{
    int i = 0;

    while (i < argc && 1u << argv[i]->type & ix__sig_arg(&bi->sig, i))
        i++;
    return i;
}

ix_status ix__call_run(const ix__bi *bi, ix_call *c)
{
    ix_status st;

    ix__progress(c->ctx, bi->row->name, c->ctx->part);
    st = bi->ext ? bi->ext(&ix__host, c) : bi->row->fn(c);
    ix__progress(c->ctx, NULL, c->ctx->part);
    if (st != IX_OK) {
        ix__obj_unref(c->ctx, c->result);
        c->result = NULL;
    }
    return st;
}

bool ix__call_blame(const ix__bi *bi, const ix_call *c, ix_status st)
{
    char msg[sizeof c->ctx->msg];
    bool named = c->bad_arg > 0 && c->bad_arg <= c->argc;

    memcpy(msg, ix_ctx_message(c->ctx), sizeof msg);
    if (named)
        (void)IX_FAIL(c->ctx, st, "argument %d of %s: %.400s", c->bad_arg,
                      bi->row->name, msg);
    else
        (void)IX_FAIL(c->ctx, st, "%s: %.400s", bi->row->name, msg);
    return named;
}

/* --- by name -------------------------------------------------------------- */

static ix_status unknown(ix_interp *in, const char *name)
{
    char near[200];

    if (ix__startup_find(name))
        return IX_FAIL(in->ctx, IX_EARG,
                       "%.64s is a function of the start-up library in script "
                       "form; such are not offered",
                       name);
    if (ix__names_near(in, name, near, sizeof near))
        return IX_FAIL(in->ctx, IX_EARG,
                       "there is no function %.64s; did you mean %s?", name,
                       near);
    return IX_FAIL(in->ctx, IX_EARG, "there is no function %.64s", name);
}

static ix_status offered(ix_interp *in, const char *name, const ix__bi **out)
{
    const ix__bi *bi = *out = ix__bi_find(name);

    if (!bi)
        return unknown(in, name);
    if (bi->row->flags & IX_B_LOCAL)
        return IX_FAIL(in->ctx, IX_EARG,
                       "%s touches files, commands, the terminal or variables "
                       "of a script: it is not offered to other programs",
                       bi->row->name);
    if (!bi->sig.result)
        return IX_FAIL(in->ctx, IX_EARG,
                       "%s is a procedure: it gives no value, and is not "
                       "offered to other programs",
                       bi->row->name);
    return IX_OK;
}

ix_status ix__call_by_name(ix_interp *in, const char *name, int argc,
                           ix_obj **argv, ix_obj **out)
{
    ix_call c = {.in = in, .ctx = in->ctx, .argc = argc, .argv = argv};
    ix_mark mk = ix__scratch_mark(in->ctx);
    const ix__bi *bi;
    ix_status st;
    int bad;

    *out = NULL;
    IX_TRY(offered(in, name, &bi));
    IX_TRY(ix__call_count(in->ctx, bi, argc));
    bad = ix__call_misfit(bi, argc, argv);
    if (bad < argc)
        return ix__arg_mismatch(in, bi, bad, 1u << argv[bad]->type);
    st = ix__call_run(bi, &c);
    ix__scratch_release(in->ctx, mk);
    if (st != IX_OK)
        (void)ix__call_blame(bi, &c, st);
    else if (!c.result)
        st = IX_FAIL(in->ctx, IX_EUNABLE, "%s gives no value here",
                     bi->row->name);
    *out = c.result;
    return st;
}

bool ix__call_keeps_state(const char *name)
{
    const ix_builtin *row = ix__builtin_find(name);

    return row && row->flags & IX_B_STATE;
}
