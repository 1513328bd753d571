/* cmd_client.c - iritx --irit-client: the client that IRIT's CLNTEXEC starts.
 *
 * IRIT is the server of one TCP connection. The client connects, says nothing
 * until it is asked, answers requests with one object each in one piece, and
 * leaves when it is told to or when the connection ends (spec/ipc 12). */
#define _GNU_SOURCE
#include <errno.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include "app/cmd.h"
#include "app/service.h"
#include "app/wire.h"

#define PATIENCE 8.0 /* seconds for connecting; IRIT waits for 10 */

/* --- connecting ----------------------------------------------------------- */

static int connect_once(const char *host, const char *port)
{
    const struct addrinfo want = {.ai_family = AF_INET,
                                  .ai_socktype = SOCK_STREAM};
    struct addrinfo *all;
    int fd = -1;

    if (getaddrinfo(host, port, &want, &all) != 0)
        return -1;
    for (const struct addrinfo *a = all; a && fd < 0; a = a->ai_next) {
        fd = socket(a->ai_family, a->ai_socktype | SOCK_CLOEXEC, 0);
        if (fd >= 0 && connect(fd, a->ai_addr, a->ai_addrlen) != 0) {
            (void)close(fd);
            fd = -1;
        }
    }
    freeaddrinfo(all);
    return fd;
}

/* -1: nobody listens there. */
static int connect_to(const service *s, const char *host, const char *port)
{
    const struct timespec pause = {0, 100000000};
    double end = service_clock() + PATIENCE;
    int on = 1, fd = connect_once(host, port);

    while (fd < 0 && service_clock() < end && ix__poll(s->ctx) == IX_OK) {
        (void)nanosleep(&pause, NULL);
        fd = connect_once(host, port);
    }
    if (fd >= 0)
        (void)setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    return fd;
}

/* --- the conversation ----------------------------------------------------- */

/* Answers an object if it is a request. False: this was the last one. */
static bool answer(service *s, wire *w, const ix_obj *o)
{
    ix_buf out;
    bool ok;

    if (service_is_farewell(o))
        return false;
    if (!service_is_request(o))
        return true;
    ix__buf_init(&out, s->ctx);
    ok = service_answer(s, o, w->form == WIRE_BINARY, w->fd, &out) == IX_OK &&
         wire_send(w, out.data, out.len);
    ix__buf_free(&out);
    return ok && !s->quit;
}

static bool answer_broken(service *s, wire *w, double seq)
{
    char why[sizeof s->ctx->msg];
    ix_buf out;
    bool ok;

    memcpy(why, ix_ctx_message(s->ctx), sizeof why);
    ix__buf_init(&out, s->ctx);
    ok = service_refuse(s, seq, why, w->form == WIRE_BINARY, &out) == IX_OK &&
         wire_send(w, out.data, out.len);
    ix__buf_free(&out);
    return ok;
}

static void converse(service *s, wire *w)
{
    bool on = true;

    while (on) {
        double seq;
        ix_obj *o;

        switch (wire_next(w, &o, &seq)) {
        case WIRE_OBJECT:
            on = answer(s, w, o);
            ix__obj_unref(s->ctx, o);
            break;
        case WIRE_BROKEN:
            on = answer_broken(s, w, seq);
            break;
        default:
            on = false;
        }
    }
}

static int run(service *s)
{
    const char *host = getenv("IRIT_SERVER_HOST");
    const char *port = getenv("IRIT_SERVER_PORT");
    wire w;
    int fd;

    host = host && *host ? host : "127.0.0.1";
    port = port && *port ? port : "5050";
    fd = connect_to(s, host, port);
    if (fd < 0) {
        service_tell(s, "no server at %s, port %s", host, port);
        return 1;
    }
    service_tell(s, "connected to %s, port %s", host, port);
    wire_init(&w, s->ctx, fd, true, WIRE_UNKNOWN);
    w.idle = s->opts.idle;
    converse(s, &w);
    wire_free(&w);
    (void)close(fd);
    service_tell(s, "the conversation is over");
    return 0;
}

int cmd_irit_client(ix_ctx *ctx, int argc, char **argv)
{
    service_opts o;
    service s;
    int used, rc;

    if (!service_options(argc, argv, &o, &used) || used != argc)
        return cmd_wrong_usage("--irit-client");
    if (service_open(&s, ctx, &o) != IX_OK)
        return cmd_complain(ctx);
    rc = run(&s);
    service_close(&s);
    return rc;
}
