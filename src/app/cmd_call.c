/* cmd_call.c - iritx --call IN OUT: one request in a file, its answer in
 * another, for programs that can run a command and read a file. There always is
 * an answer, complete or not there at all: IRIT's LOAD ends a script that meets
 * a missing or half a file. */
#include <string.h>

#include "app/cmd.h"
#include "app/service.h"
#include "io/message.h"

/* By the suffix, as LOAD and SAVE decide. */
static bool is_binary(const char *name)
{
    const char *s = strrchr(name, '.');

    if (s && (ix__name_cmp(s, ".gz") == 0 || ix__name_cmp(s, ".Z") == 0))
        return s - name >= 4 && memcmp(s - 4, ".ibd", 4) == 0;
    return s && ix__name_cmp(s, ".ibd") == 0;
}

static ix_status feed_all(ix__message *m, const ix_buf *text)
{
    bool complete;
    size_t used;

    IX_TRY(ix__message_feed(m, text->data, text->len, &used, &complete));
    return complete ? IX_OK
                    : IX_FAIL(text->ctx, IX_EPARSE,
                              "the request is empty or cut short");
}

/* Text as IRIT writes it, with strings that are not escaped. *seq: the number
 * of the request, as far as it can be seen. */
static ix_status read_text(ix_ctx *ctx, const char *name, double *seq,
                           ix_obj **o)
{
    ix__message m;
    ix_buf text;
    ix_status st;

    IX_TRY(ix__file_read(ctx, name, &text));
    ix__message_init(&m, ctx);
    st = feed_all(&m, &text);
    if (st == IX_OK)
        st = ix__message_object(&m, o);
    if (m.text.data)
        (void)ix__message_is_request(&m, seq);
    ix__message_free(&m);
    ix__buf_free(&text);
    return st;
}

static ix_status answer(service *s, const char *in, bool binary, ix_buf *out)
{
    char why[sizeof s->ctx->msg];
    double seq = 0;
    ix_obj *o = NULL;
    ix_status st = is_binary(in) ? ix__load(s->ctx, in, NULL, &o)
                                 : read_text(s->ctx, in, &seq, &o);

    if (st == IX_OK && !service_is_request(o))
        st = IX_FAIL(s->ctx, IX_EARG,
                     "%.200s holds no request list('IRITX/1', number, 'NAME', "
                     "list(arguments))",
                     in);
    if (st == IX_OK) {
        st = service_answer(s, o, binary, -1, out);
    } else {
        memcpy(why, ix_ctx_message(s->ctx), sizeof why);
        st = service_refuse(s, seq, why, binary, out);
    }
    ix__obj_unref(s->ctx, o);
    return st;
}

int cmd_call(ix_ctx *ctx, int argc, char **argv)
{
    service_opts o;
    service s;
    ix_buf out;
    ix_status st;
    int used;

    if (!service_options(argc, argv, &o, &used) || argc - used != 2)
        return cmd_wrong_usage("--call");
    argv += used;
    if (service_open(&s, ctx, &o) != IX_OK)
        return cmd_complain(ctx);
    ix__buf_init(&out, ctx);
    st = answer(&s, argv[0], is_binary(argv[1]), &out);
    if (st == IX_OK)
        st = ix__file_write(ctx, argv[1], out.data, out.len);
    ix__buf_free(&out);
    service_close(&s);
    return st == IX_OK ? 0 : cmd_complain(ctx);
}
