/* wire.c - bytes of a peer, cut into objects (wire.h). */
#define _GNU_SOURCE
#include "app/wire.h"

#include <errno.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "app/service.h"
#include "io/ibd.h"

#define STALL      60.0              /* seconds within an object */
#define PIPE_STALL 5.0               /* ... where others wait, too */
#define USUAL      ((size_t)1 << 20) /* bytes of a buffer worth keeping */

void wire_init(wire *w, ix_ctx *ctx, int fd, bool socket, wire_form form)
{
    *w = (wire){.ctx = ctx, .fd = fd, .socket = socket, .form = form};
    ix__buf_init(&w->in, ctx);
    ix__message_init(&w->msg, ctx);
}

void wire_free(wire *w)
{
    ix__buf_free(&w->in);
    ix__message_free(&w->msg);
}

/* --- bytes ---------------------------------------------------------------- */

/* The peer writes in many small pieces and waits for their receipts: they must
 * not be delayed. The system forgets this again and again. */
static void hasten(const wire *w)
{
#ifdef TCP_QUICKACK
    int on = 1;

    if (w->socket)
        (void)setsockopt(w->fd, IPPROTO_TCP, TCP_QUICKACK, &on, sizeof on);
#else
    (void)w;
#endif
}

/* Bytes that are done with go. */
static void make_room(wire *w)
{
    size_t left = w->in.len - w->at;

    if (left > 0 && w->at < USUAL)
        return;
    if (left == 0 && w->in.cap > 2 * USUAL)
        ix__buf_free(&w->in);
    if (left > 0)
        memmove(w->in.data, w->in.data + w->at, left);
    w->in.len = left;
    w->at = 0;
}

/* Takes what is there. False: nothing for now, or w->ended. */
static bool take(wire *w)
{
    char piece[65536];
    ssize_t k;

    make_room(w);
    hasten(w);
    k = read(w->fd, piece, sizeof piece);
    if (k == 0 || (k < 0 && errno != EINTR && errno != EAGAIN))
        w->ended = true;
    if (k <= 0)
        return false;
    ix__buf_add(&w->in, piece, (size_t)k);
    if (w->in.failed) /* no memory: nothing that could be answered */
        w->ended = true;
    return !w->ended;
}

static bool readable(const wire *w, int ms)
{
    struct pollfd p = {.fd = w->fd, .events = POLLIN};

    return poll(&p, 1, ms) > 0;
}

/* Waits until n bytes are there; within an object not as long as between two.
 * False: there are fewer, and no more to come for now. */
static bool ahead(wire *w, size_t n, bool inside)
{
    double stall = w->socket ? STALL : PIPE_STALL;
    double limit = inside ? stall : w->idle, start = service_clock();
    bool wait = inside || w->socket;

    while (w->in.len - w->at < n) {
        if (!w->ended && ix__poll(w->ctx) != IX_OK)
            w->ended = true;
        if (w->ended)
            return false;
        hasten(w);
        if (readable(w, wait ? 200 : 0)) {
            if (take(w))
                start = service_clock();
        } else if (!wait || (limit > 0 && service_clock() - start > limit)) {
            w->ended = w->ended || (wait && !inside);
            return false;
        }
    }
    return true;
}

bool wire_pending(wire *w)
{
    while (!w->ended && readable(w, 0) && take(w))
        ;
    while (w->form == WIRE_TEXT && w->at < w->in.len &&
           memchr(" \t\r\n", w->in.data[w->at], 4))
        w->at++;
    return w->at < w->in.len;
}

/* --- the beginning of an object ------------------------------------------- */

static bool is_binary(const char *s)
{
    const unsigned char *u = (const unsigned char *)s;

    return u[0] >= IX_OBJ_POLY && u[0] <= IX_OBJ_MULTIVAR && u[1] == 0x80 &&
           u[2] == 0x16 && u[3] == 0x43;
}

static bool begins(wire *w)
{
    static const char text[] = "[OBJECT";
    const size_t n = sizeof text - 1;
    unsigned char c = (unsigned char)w->in.data[w->at];

    if (w->form != WIRE_TEXT && c >= IX_OBJ_POLY && c <= IX_OBJ_MULTIVAR &&
        ahead(w, 4, true) && is_binary(w->in.data + w->at))
        w->form = WIRE_BINARY;
    else if (w->form != WIRE_BINARY && c == '[' && ahead(w, n, true) &&
             memcmp(w->in.data + w->at, text, n) == 0)
        w->form = WIRE_TEXT;
    else
        return false;
    return true;
}

/* Skips bytes up to something that begins an object, and stays before it. */
static bool seek(wire *w)
{
    for (;; w->at++) {
        if (!ahead(w, 1, false))
            return false;
        if (begins(w))
            return true;
    }
}

/* --- objects -------------------------------------------------------------- */

static ix_status text_object(wire *w, ix_obj **o)
{
    bool complete = false;

    ix__message_clear(&w->msg);
    while (!complete) {
        size_t used;
        ix_status st;

        if (!ahead(w, 1, true))
            return IX_FAIL(w->ctx, IX_EIO, "the rest of a message is missing");
        st = ix__message_feed(&w->msg, w->in.data + w->at, w->in.len - w->at,
                              &used, &complete);
        w->at += used;
        IX_TRY(st);
    }
    return ix__message_object(&w->msg, o);
}

/* Just the bytes that belong to an object (ix__fill_fn). */
static ix_status fill(void *arg, char *to, size_t room, size_t *n)
{
    wire *w = arg;

    for (*n = 0; *n < room;) {
        size_t k = room - *n;

        if (!ahead(w, 1, true))
            return IX_FAIL(w->ctx, IX_EIO, "the rest of an object is missing");
        k = k < w->in.len - w->at ? k : w->in.len - w->at;
        memcpy(to + *n, w->in.data + w->at, k);
        w->at += k;
        *n += k;
    }
    for (size_t i = 0; i < room && w->nhead < sizeof w->head; i++)
        w->head[w->nhead++] = to[i];
    return IX_OK;
}

static ix_status binary_object(wire *w, ix_obj **o)
{
    w->nhead = 0;
    return ix__ibd_read_one(w->ctx, "message", fill, w, o);
}

/* Is what failed a request, which its asker waits for? */
static bool was_request(const wire *w, double *seq)
{
    return w->form == WIRE_TEXT ? ix__message_is_request(&w->msg, seq)
                                : ix__record_is_request(w->head, w->nhead, seq);
}

wire_event wire_next(wire *w, ix_obj **o, double *seq)
{
    *o = NULL;
    *seq = 0;
    while (seek(w)) {
        ix_status st = w->form == WIRE_TEXT ? text_object(w, o)
                                            : binary_object(w, o);

        if (st == IX_OK)
            return WIRE_OBJECT;
        if (st != IX_EIO && st != IX_ECANCEL && was_request(w, seq))
            return WIRE_BROKEN;
    }
    return WIRE_END;
}

/* --- answers -------------------------------------------------------------- */

/* The peer has room, or has sent something. */
static bool wait_for_room(wire *w)
{
    struct pollfd p = {.fd = w->fd, .events = POLLOUT | POLLIN};

    if (ix__poll(w->ctx) != IX_OK)
        return false;
    if (poll(&p, 1, 200) <= 0)
        return true;
    if (p.revents & POLLIN)
        (void)take(w);
    return !w->ended && !(p.revents & (POLLERR | POLLHUP));
}

bool wire_send(wire *w, const char *s, size_t n)
{
    while (n > 0) {
        ssize_t k = send(w->fd, s, n, MSG_NOSIGNAL | MSG_DONTWAIT);

        if (k < 0 && errno != EINTR && errno != EAGAIN)
            return false;
        s += k > 0 ? k : 0;
        n -= k > 0 ? (size_t)k : 0;
        if (n > 0 && !wait_for_room(w))
            return false;
    }
    return true;
}
