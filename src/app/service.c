/* service.c - requests and answers (service.h). An answer is one object that a
 * picky reader accepts: io/message.h, "peer" of ix_write_opts. */
#define _GNU_SOURCE
#include "app/service.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include "io/ibd.h"
#include "io/message.h"
#include "lang/call.h"

#ifndef POLLRDHUP
#define POLLRDHUP 0
#endif

#define DAY (24 * 3600.0)

/* --- options -------------------------------------------------------------- */

static bool seconds(const char *name, const char *s, double *out)
{
    const char *end = s ? s + strlen(s) : NULL;

    if (s && *s && ix_num_parse(s, end, out) == end && *out >= 0 && *out < 1e9)
        return true;
    (void)fprintf(stderr, "iritx: %s takes a number of seconds, 0: no limit\n",
                  name);
    return false;
}

bool service_options(int argc, char **argv, service_opts *o, int *used)
{
    *o = (service_opts){.idle = DAY};
    for (*used = 0; *used < argc && argv[*used][0] == '-'; ++*used) {
        const char *name = argv[*used];
        double *value = strcmp(name, "--idle") == 0    ? &o->idle
                        : strcmp(name, "--limit") == 0 ? &o->limit
                                                       : NULL;

        if (strcmp(name, "-v") == 0) {
            o->loud = true;
        } else if (value) {
            ++*used;
            if (!seconds(name, *used < argc ? argv[*used] : NULL, value))
                return false;
        } else {
            return true;
        }
    }
    return true;
}

/* --- surroundings --------------------------------------------------------- */

/* The program that started this one may have left its sockets open in us: then
 * their other ends would never learn that it closed them. */
static void close_inherited(void)
{
    long most = sysconf(_SC_OPEN_MAX);

#ifdef __linux__
    if (close_range(3, ~0u, 0) == 0)
        return;
#endif
    for (int fd = 3; fd < (most > 0 && most < 65536 ? most : 65536); fd++)
        (void)close(fd);
}

/* Standard output belongs to the script of the program that started us. */
static void drop_output(void)
{
    int fd = open("/dev/null", O_WRONLY);

    if (fd < 0)
        return;
    (void)dup2(fd, STDOUT_FILENO);
    if (fd != STDOUT_FILENO)
        (void)close(fd);
}

ix_status service_open(service *s, ix_ctx *ctx, const service_opts *o)
{
    const ix_interp_opts opts = {.quiet = !o->loud};

    *s = (service){.ctx = ctx, .opts = *o};
    close_inherited();
    drop_output();
    ix_ctx_set_progress(ctx, NULL, NULL);
    if (!o->loud)
        ix_ctx_set_note(ctx, NULL, NULL);
    return ix__interp_new(ctx, &opts, &s->in);
}

void service_close(service *s)
{
    ix__interp_free(s->in);
}

void service_tell(const service *s, const char *fmt, ...)
{
    va_list ap;

    if (!s->opts.loud)
        return;
    va_start(ap, fmt);
    (void)fprintf(stderr, "iritx: ");
    (void)vfprintf(stderr, fmt, ap);
    (void)fprintf(stderr, "\n");
    va_end(ap);
}

double service_clock(void)
{
    struct timespec t = {0, 0};

    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* --- what came ------------------------------------------------------------ */

static const ix_obj *item(const ix_obj *list, int i, ix_obj_type type)
{
    return i < list->u.list.n && list->u.list.item[i]->type == type
               ? list->u.list.item[i]
               : NULL;
}

bool service_is_request(const ix_obj *o)
{
    const ix_obj *head = o->type == IX_OBJ_LIST ? item(o, 0, IX_OBJ_STRING)
                                                : NULL;

    return head && strcmp(head->u.str.s, IX_MESSAGE_HEAD) == 0;
}

bool service_is_farewell(const ix_obj *o)
{
    return o->type == IX_OBJ_STRING && o->name &&
           strcmp(o->name, "COMMAND_") == 0 &&
           (strcmp(o->u.str.s, "EXIT") == 0 ||
            strcmp(o->u.str.s, "DISCONNECT") == 0);
}

static double number_of(const ix_obj *request)
{
    const ix_obj *seq = item(request, 1, IX_OBJ_NUMBER);

    return seq ? seq->u.num : 0;
}

/* --- the answer as an object ---------------------------------------------- */

static ix_obj *text_object(ix_ctx *ctx, const char *s)
{
    return ix__obj_string(ctx, s, strlen(s));
}

/* Takes over value. */
static ix_status answer_object(ix_ctx *ctx, double seq, int status,
                               ix_obj *value, ix_obj **out)
{
    ix_obj *list = ix__obj_list(ctx);
    ix_status st = ix__list_add(ctx, list, text_object(ctx, IX_MESSAGE_HEAD));

    if (st == IX_OK)
        st = ix__list_add_num(ctx, list, seq);
    if (st == IX_OK)
        st = ix__list_add_num(ctx, list, status);
    if (st == IX_OK)
        st = ix__list_add(ctx, list, value);
    else
        ix__obj_unref(ctx, value);
    if (st != IX_OK) {
        ix__obj_unref(ctx, list);
        list = NULL;
    }
    *out = list;
    return st;
}

static ix_status encode(ix_buf *b, const ix_obj *o, bool binary)
{
    const ix_write_opts w = {.file = true, .peer = true};

    return binary ? ix__ibd_write(b, o, &w) : ix__itd_write(b, o, &w, 0);
}

/* Takes over value. On failure out is as it was. */
static ix_status add_answer(ix_ctx *ctx, double seq, int status, ix_obj *value,
                            bool binary, ix_buf *out)
{
    size_t before = out->len;
    ix_obj *o;
    ix_status st;

    IX_TRY(answer_object(ctx, seq, status, value, &o));
    st = encode(out, o, binary);
    ix__obj_unref(ctx, o);
    if (st != IX_OK) {
        out->failed = false;
        out->len = before;
    }
    return st;
}

/* Without quotes, in one line, in printable bytes. */
static void clean_message(const char *s, char *to, size_t size)
{
    size_t n = 0;

    for (; *s && n + 1 < size; s++) {
        unsigned char c = (unsigned char)*s;

        to[n++] = *s == '"'                ? '\''
                  : c < ' ' || c == 0x7f   ? ' '
                  : c == 0xff || c == '\\' ? '/'
                                           : *s;
    }
    to[n] = '\0';
}

ix_status service_refuse(service *s, double seq, const char *why, bool binary,
                         ix_buf *out)
{
    char text[600];
    ix_obj *o;

    clean_message(why, text, sizeof text);
    service_tell(s, "request %.15g failed: %s", seq, text);
    o = text_object(s->ctx, text);
    return o ? add_answer(s->ctx, seq, 1, o, binary, out) : IX_ENOMEM;
}

/* --- computing ------------------------------------------------------------ */

/* Operations that are no functions of scripts. */
static bool is_own(const char *op)
{
    return ix__name_cmp(op, "EXIT") == 0 || ix__name_cmp(op, "PING") == 0 ||
           ix__name_cmp(op, "VERSION") == 0;
}

static ix_obj *own_value(service *s, const char *op)
{
    if (ix__name_cmp(op, "VERSION") == 0)
        return text_object(s->ctx, ix_version());
    s->quit = s->quit || ix__name_cmp(op, "EXIT") == 0;
    return ix__obj_number(s->ctx, 1);
}

static ix_status value_of(service *s, const ix_obj *request, ix_obj **v)
{
    const char *op = item(request, 2, IX_OBJ_STRING)->u.str.s;
    const ix_obj *args = item(request, 3, IX_OBJ_LIST);

    if (is_own(op)) {
        *v = own_value(s, op);
        return *v ? IX_OK : IX_ENOMEM;
    }
    IX_TRY(ix__call_by_name(s->in, op, args ? args->u.list.n : 0,
                            args ? args->u.list.item : NULL, v));
    if ((*v)->type != IX_OBJ_UNDEF)
        return IX_OK;
    ix__obj_unref(s->ctx, *v);
    *v = NULL;
    return IX_FAIL(s->ctx, IX_EUNABLE, "%.64s gives no value here", op);
}

/* The whole answer, in this process. */
static ix_status compute(service *s, const ix_obj *request, bool binary,
                         ix_buf *out)
{
    double seq = number_of(request);
    ix_obj *v = NULL;
    ix_status st = value_of(s, request, &v);

    if (st == IX_OK)
        st = add_answer(s->ctx, seq, 0, v, binary, out);
    if (st == IX_OK || st == IX_ECANCEL)
        return st;
    return service_refuse(s, seq, ix_ctx_message(s->ctx), binary, out);
}

/* --- in a child ----------------------------------------------------------- */

static bool write_all(int fd, const char *s, size_t n)
{
    while (n > 0) {
        ssize_t k = write(fd, s, n);

        if (k < 0 && errno != EINTR)
            return false;
        s += k > 0 ? k : 0;
        n -= k > 0 ? (size_t)k : 0;
    }
    return true;
}

/* No core files in somebody else's directory, no life after the parent. */
static void child(service *s, const ix_obj *request, bool binary, int watch,
                  int to)
{
    const struct rlimit none = {0, 0};
    ix_buf out;
    bool ok;

    (void)setrlimit(RLIMIT_CORE, &none);
#ifdef __linux__
    (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    if (watch >= 0)
        (void)close(watch);
    ix__buf_init(&out, s->ctx);
    ok = compute(s, request, binary, &out) == IX_OK &&
         write_all(to, out.data, out.len);
    _exit(ok ? 0 : 1);
}

/* All that the child writes. */
static ix_status collect(service *s, int from, int watch, ix_buf *out)
{
    double end = service_clock() + s->opts.limit;
    struct pollfd p[2] = {{.fd = from, .events = POLLIN},
                          {.fd = watch, .events = POLLRDHUP}};

    for (;;) {
        char piece[65536];
        ssize_t k;

        IX_TRY(ix__poll(s->ctx));
        if (s->opts.limit > 0 && service_clock() > end)
            return IX_FAIL(s->ctx, IX_EUNABLE,
                           "the computation takes longer than %g seconds",
                           s->opts.limit);
        if (poll(p, 2, 200) <= 0)
            continue;
        if (p[1].revents)
            return IX_FAIL(s->ctx, IX_ECANCEL, "the peer has left");
        k = read(from, piece, sizeof piece);
        if (k == 0)
            return IX_OK;
        ix__buf_add(out, piece, k > 0 ? (size_t)k : 0);
        IX_TRY(ix__buf_check(out));
    }
}

static pid_t reap(pid_t pid, int *status)
{
    pid_t p;

    do
        p = waitpid(pid, status, 0);
    while (p < 0 && errno == EINTR);
    return p;
}

static ix_status died(ix_ctx *ctx, int status)
{
    if (WIFSIGNALED(status))
        return IX_FAIL(ctx, IX_EUNABLE, "computation failed (signal %d)",
                       WTERMSIG(status));
    return IX_FAIL(ctx, IX_EUNABLE, "computation failed (status %d)",
                   WEXITSTATUS(status));
}

/* The child's answer, or why there is none. */
static ix_status from_child(service *s, pid_t pid, int from, int watch,
                            ix_buf *out)
{
    int status = 0;
    ix_status st = collect(s, from, watch, out);

    if (st != IX_OK)
        (void)kill(pid, SIGKILL);
    if (reap(pid, &status) < 0 && st == IX_OK)
        return IX_FAIL(s->ctx, IX_EUNABLE, "computation failed: %s",
                       strerror(errno));
    if (st == IX_OK && (!WIFEXITED(status) || WEXITSTATUS(status) != 0))
        return died(s->ctx, status);
    return st;
}

static ix_status delegate(service *s, const ix_obj *request, bool binary,
                          int watch, ix_buf *out)
{
    int fd[2];
    ix_status st;
    pid_t pid;

    if (pipe2(fd, O_CLOEXEC) != 0)
        return IX_FAIL(s->ctx, IX_EIO, "cannot compute: %s", strerror(errno));
    pid = fork();
    if (pid == 0) {
        (void)close(fd[0]);
        child(s, request, binary, watch, fd[1]);
    }
    (void)close(fd[1]);
    if (pid > 0)
        st = from_child(s, pid, fd[0], watch, out);
    else
        st = IX_FAIL(s->ctx, IX_EIO, "cannot compute: %s", strerror(errno));
    (void)close(fd[0]);
    return st;
}

/* --- answering ------------------------------------------------------------ */

/* What is wrong with a request, or NULL. */
static const char *fault(const ix_obj *r)
{
    if (!item(r, 1, IX_OBJ_NUMBER))
        return "a request is list('IRITX/1', number, 'NAME', list(arguments)): "
               "the number is missing";
    if (!item(r, 2, IX_OBJ_STRING))
        return "a request is list('IRITX/1', number, 'NAME', list(arguments)): "
               "the name is missing";
    if (r->u.list.n > 4 || (r->u.list.n == 4 && !item(r, 3, IX_OBJ_LIST)))
        return "a request is list('IRITX/1', number, 'NAME', list(arguments)): "
               "the arguments must be one list";
    return NULL;
}

/* What changes the states must, what cannot fail may happen here. */
static bool stays_here(const ix_obj *request)
{
    const char *op = item(request, 2, IX_OBJ_STRING)->u.str.s;

    return is_own(op) || ix__call_keeps_state(op) || !ix__builtin_find(op);
}

ix_status service_answer(service *s, const ix_obj *request, bool binary,
                         int watch, ix_buf *out)
{
    const char *wrong = fault(request);
    double seq = number_of(request), start = service_clock();
    size_t before = out->len;
    ix_status st;

    if (wrong)
        return service_refuse(s, seq, wrong, binary, out);
    if (stays_here(request))
        return compute(s, request, binary, out);
    st = delegate(s, request, binary, watch, out);
    service_tell(s, "request %.15g: %.64s, %.3f ms", seq,
                 item(request, 2, IX_OBJ_STRING)->u.str.s,
                 1e3 * (service_clock() - start));
    if (st == IX_OK || st == IX_ECANCEL)
        return st;
    out->failed = false;
    out->len = before; /* without half of an answer */
    return service_refuse(s, seq, ix_ctx_message(s->ctx), binary, out);
}
