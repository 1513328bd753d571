/* cmd_pipes.c - iritx --pipes DIR: a resident service behind named pipes. A
 * request that is saved to DIR/in.itd is answered by DIR/out.itd, one in
 * DIR/in.ibd by DIR/out.ibd.
 *
 * Who asks may vanish before it has read the answer, so nothing waits for it
 * without end: an answer that nobody fetches is dropped after a while, or when
 * the next request comes. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "app/cmd.h"
#include "app/service.h"
#include "app/wire.h"

#define FETCH 10.0 /* seconds for an answer to be fetched */
#define GRACE 0.02 /* ... before a next request makes it stale */
#define STALL 60.0 /* seconds for a reader that has stopped in the middle */

enum { TEXT, BINARY, FORMS };

typedef struct {
    char in[4096], out[4096]; /* names */
    bool made_in, made_out;   /* by us */
    wire w;                   /* from in */
    int reader; /* out, opened for somebody who has asked again; -1: none */
} channel;

typedef struct {
    service s;
    const char *dir;
    bool made_dir;
    int lock; /* holds the first pipe as long as the service lives */
    channel c[FORMS];
} pipes;

/* --- making them ---------------------------------------------------------- */

static ix_status make_fifo(ix_ctx *ctx, const char *name, bool *made)
{
    struct stat sb;

    *made = mkfifo(name, 0600) == 0;
    if (!*made && errno != EEXIST)
        return IX_FAIL(ctx, IX_EIO, "%.300s: %s", name, strerror(errno));
    if (stat(name, &sb) != 0 || !S_ISFIFO(sb.st_mode))
        return IX_FAIL(ctx, IX_EIO, "%.300s is there, and is no named pipe",
                       name);
    return IX_OK;
}

/* Opened anew it is silent until somebody writes; the old descriptor is closed
 * only then, so that no request gets lost between the two. */
static ix_status open_in(channel *c)
{
    int fd = open(c->in, O_RDONLY | O_NONBLOCK | O_CLOEXEC);

    if (fd < 0)
        return IX_FAIL(c->w.ctx, IX_EIO, "%.300s: %s", c->in, strerror(errno));
    if (c->w.fd >= 0)
        (void)close(c->w.fd);
    c->w.fd = fd;
    c->w.ended = false;
    return IX_OK;
}

static ix_status open_channel(pipes *p, int form)
{
    static const char *const suffix[] = {"itd", "ibd"};
    channel *c = &p->c[form];
    ix_ctx *ctx = p->s.ctx;

    if (strlen(p->dir) > sizeof c->in - 16)
        return IX_FAIL(ctx, IX_EARG, "the name of the directory is too long");
    (void)snprintf(c->in, sizeof c->in, "%s/in.%s", p->dir, suffix[form]);
    (void)snprintf(c->out, sizeof c->out, "%s/out.%s", p->dir, suffix[form]);
    IX_TRY(make_fifo(ctx, c->in, &c->made_in));
    IX_TRY(make_fifo(ctx, c->out, &c->made_out));
    return open_in(c);
}

/* One service a directory. */
static ix_status take_lock(pipes *p)
{
    p->lock = open(p->c[TEXT].in, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (p->lock < 0)
        return IX_FAIL(p->s.ctx, IX_EIO, "%.300s: %s", p->c[TEXT].in,
                       strerror(errno));
    if (flock(p->lock, LOCK_EX | LOCK_NB) != 0)
        return IX_FAIL(p->s.ctx, IX_EIO,
                       "%.300s: another service is there already", p->dir);
    return IX_OK;
}

static ix_status open_all(pipes *p)
{
    p->made_dir = mkdir(p->dir, 0700) == 0;
    if (!p->made_dir && errno != EEXIST)
        return IX_FAIL(p->s.ctx, IX_EIO, "%.300s: %s", p->dir, strerror(errno));
    IX_TRY(open_channel(p, TEXT));
    IX_TRY(take_lock(p));
    return open_channel(p, BINARY);
}

static void close_all(pipes *p)
{
    for (int i = 0; i < FORMS; i++) {
        channel *c = &p->c[i];

        if (c->w.fd >= 0)
            (void)close(c->w.fd);
        if (c->reader >= 0)
            (void)close(c->reader);
        if (c->made_in)
            (void)unlink(c->in);
        if (c->made_out)
            (void)unlink(c->out);
        wire_free(&c->w);
    }
    if (p->lock >= 0)
        (void)close(p->lock);
    if (p->made_dir)
        (void)rmdir(p->dir);
}

/* --- giving answers ------------------------------------------------------- */

/* False: the reader has gone, or does not go on. */
static bool write_all(const pipes *p, int fd, const char *s, size_t n)
{
    double start = service_clock();
    struct pollfd q = {.fd = fd, .events = POLLOUT};

    while (n > 0) {
        ssize_t k = write(fd, s, n);

        if (k > 0) {
            s += k;
            n -= (size_t)k;
            start = service_clock();
        } else if (k < 0 && errno != EINTR && errno != EAGAIN) {
            return false;
        } else if (ix__poll(p->s.ctx) != IX_OK ||
                   service_clock() - start > STALL) {
            return false;
        }
        if (n > 0)
            (void)poll(&q, 1, 200);
    }
    return true;
}

/* Has the next request come? */
static bool asked_again(pipes *p)
{
    bool any = false;

    for (int i = 0; i < FORMS; i++) {
        channel *c = &p->c[i];

        any = any || wire_pending(&c->w);
        if (!any && c->w.ended && open_in(c) == IX_OK)
            any = wire_pending(&c->w);
    }
    return any;
}

/* A short sleep at first: the usual reader comes at once. */
static void pause_for(double waited)
{
    const struct timespec t = {0, waited < 0.01 ? 50000 : 1000000};

    (void)nanosleep(&t, NULL);
}

static int take_reader(channel *c)
{
    int fd = c->reader;

    c->reader = -1;
    return fd >= 0 ? fd : open(c->out, O_WRONLY | O_NONBLOCK | O_CLOEXEC);
}

/* Gives the answer to who reads now. True: it is done with, one way or the
 * other. Who has come after asking anew is kept for that answer: he would take
 * this one for it, or an end of the pipe for an empty one. */
static bool hand_over(pipes *p, channel *c, double waited, const ix_buf *out)
{
    int fd = take_reader(c);
    bool stale = waited > GRACE && asked_again(p), ok = false;

    if (fd >= 0 && !stale)
        ok = write_all(p, fd, out->data, out->len);
    if (fd >= 0 && stale)
        c->reader = fd;
    else if (fd >= 0)
        (void)close(fd);
    if (stale)
        service_tell(&p->s, "an answer was not fetched");
    return ok || stale;
}

static void deliver(pipes *p, channel *c, const ix_buf *out)
{
    double start = service_clock(), waited = 0;

    while (ix__poll(p->s.ctx) == IX_OK && waited < FETCH) {
        if (hand_over(p, c, waited, out))
            return;
        pause_for(waited);
        waited = service_clock() - start;
    }
    service_tell(&p->s, "an answer was not fetched");
}

/* --- the service ---------------------------------------------------------- */

static ix_status answer(pipes *p, channel *c, const ix_obj *o, double seq,
                        ix_buf *out)
{
    bool binary = c == &p->c[BINARY];
    char why[sizeof p->s.ctx->msg];

    if (o)
        return service_answer(&p->s, o, binary, -1, out);
    memcpy(why, ix_ctx_message(p->s.ctx), sizeof why);
    return service_refuse(&p->s, seq, why, binary, out);
}

/* o NULL: a request that cannot be read. What is no request gets an answer,
 * too, for who saved it will load something: a message. */
static void serve_object(pipes *p, channel *c, const ix_obj *o, double seq)
{
    ix_buf out;
    ix_status st;

    if (o && service_is_farewell(o)) {
        p->s.quit = true;
        return;
    }
    ix__buf_init(&out, p->s.ctx);
    if (o && !service_is_request(o)) {
        (void)IX_FAIL(p->s.ctx, IX_EARG,
                      "this is no request list('IRITX/1', number, 'NAME', "
                      "list(arguments))");
        o = NULL;
    }
    st = answer(p, c, o, seq, &out);
    if (st == IX_OK)
        deliver(p, c, &out);
    ix__buf_free(&out);
}

/* All that has come through one pipe. */
static ix_status serve(pipes *p, channel *c)
{
    double seq;
    ix_obj *o;

    while (!p->s.quit && wire_next(&c->w, &o, &seq) != WIRE_END) {
        if (c->w.ended) /* its writer is done: listen to the next */
            IX_TRY(open_in(c));
        serve_object(p, c, o, seq);
        ix__obj_unref(p->s.ctx, o);
    }
    return c->w.ended ? open_in(c) : IX_OK;
}

static bool idle(const pipes *p, double since)
{
    return p->s.opts.idle > 0 && service_clock() - since > p->s.opts.idle;
}

static ix_status serve_all(pipes *p)
{
    double since = service_clock();

    while (!p->s.quit && ix__poll(p->s.ctx) == IX_OK && !idle(p, since)) {
        struct pollfd q[FORMS];
        bool waiting = asked_again(p);

        for (int i = 0; i < FORMS; i++)
            q[i] = (struct pollfd){.fd = p->c[i].w.fd, .events = POLLIN};
        if (!waiting && poll(q, FORMS, 500) <= 0)
            continue;
        for (int i = 0; i < FORMS; i++)
            IX_TRY(serve(p, &p->c[i]));
        since = service_clock();
    }
    return IX_OK;
}

static ix_status run(pipes *p)
{
    IX_TRY(open_all(p));
    service_tell(&p->s, "listening to %s and %s", p->c[TEXT].in,
                 p->c[BINARY].in);
    return serve_all(p);
}

int cmd_pipes(ix_ctx *ctx, int argc, char **argv)
{
    static pipes p;
    service_opts o;
    ix_status st;
    int used;

    if (!service_options(argc, argv, &o, &used) || argc - used != 1)
        return cmd_wrong_usage("--pipes");
    if (service_open(&p.s, ctx, &o) != IX_OK)
        return cmd_complain(ctx);
    p.dir = argv[used];
    p.lock = -1;
    wire_init(&p.c[TEXT].w, ctx, -1, false, WIRE_TEXT);
    wire_init(&p.c[BINARY].w, ctx, -1, false, WIRE_BINARY);
    p.c[TEXT].reader = p.c[BINARY].reader = -1;
    st = run(&p);
    close_all(&p);
    service_close(&p.s);
    return st == IX_OK ? 0 : cmd_complain(ctx);
}
