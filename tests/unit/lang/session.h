/* session.h - an interpreter whose output and messages are caught. */
#ifndef UNIT_LANG_SESSION_H
#define UNIT_LANG_SESSION_H

#include <stdlib.h>
#include <string.h>

#include "harness/fault.h"
#include "harness/test.h"
#include "lang/interp_impl.h"

typedef struct {
    ix_ctx *ctx;
    ix_interp *in;
    char *out, *err; /* everything so far */
    size_t nout, nerr;
    FILE *fout, *ferr;
} session;

static inline void session_open(session *s, const ix_interp_opts *o)
{
    static const ix_interp_opts none;

    *s = (session){.ctx = ix_ctx_new(NULL, NULL)};
    assert_non_null(s->ctx);
    ASSERT_OK(s->ctx, ix__interp_new(s->ctx, o ? o : &none, &s->in));
    s->fout = open_memstream(&s->out, &s->nout);
    s->ferr = open_memstream(&s->err, &s->nerr);
    s->in->out = s->fout;
    s->in->err = s->ferr;
}

/* Runs text; afterwards out and err hold what this text printed. */
static inline ix_status session_run(session *s, const char *text)
{
    ix_status st;

    rewind(s->fout);
    rewind(s->ferr);
    st = ix__interp_run_text(s->in, "t", text, strlen(text));
    (void)fflush(s->fout);
    (void)fflush(s->ferr);
    s->out[s->nout] = '\0';
    s->err[s->nerr] = '\0';
    return st;
}

static inline void session_close(session *s)
{
    s->in->out = NULL;
    s->in->err = NULL;
    ix__interp_free(s->in);
    ix_ctx_free(s->ctx);
    (void)fclose(s->fout);
    (void)fclose(s->ferr);
    free(s->out);
    free(s->err);
}

/* The number that an expression has. */
static inline double session_number(session *s, const char *expression)
{
    char text[2000];
    const ix_obj *o;

    (void)snprintf(text, sizeof text, "zz_value = %s;", expression);
    if (session_run(s, text) != IX_OK)
        fail_msg("%s: %s", expression, s->err);
    o = ix__var_find(s->in, "ZZ_VALUE");
    assert_non_null(o);
    if (o->type != IX_OBJ_NUMBER)
        fail_msg("%s is %s", expression, ix__obj_type_name(o->type));
    return o->u.num;
}

#endif
