/* input.c - where text comes from. A file is read by position, so that a second
 * reader of it, which looks for the place of an error, does not disturb the
 * first. */
#define _POSIX_C_SOURCE 200809L
#include "io/input.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/file_impl.h"
#include "io/gz.h"

struct ix__input {
    ix_ctx *ctx;
    const char *name;
    const char *data; /* memory; NULL: a file */
    int fd;
    bool owner; /* of fd */
    bool packed;
    size_t size, pos; /* of data, or of the file when it was opened */
    size_t piece;
    bool started;   /* behind a byte order mark */
    ix__gunzip *gz; /* made at the first read */
};

/* --- bytes as they are stored ----------------------------------------- */

static ix_status pread_all(ix__input *s, char *to, size_t room, size_t *n)
{
    *n = 0;
    while (*n < room) {
        ssize_t k = pread(s->fd, to + *n, room - *n, (off_t)(s->pos + *n));

        if (k < 0 && errno == EINTR)
            continue;
        if (k < 0)
            return ix__file_failed(s->ctx, "read", s->name);
        if (k == 0)
            break;
        *n += (size_t)k;
    }
    return IX_OK;
}

static ix_status raw(void *arg, char *to, size_t room, size_t *n)
{
    ix__input *s = arg;

    IX_TRY(ix__poll(s->ctx));
    if (s->data) {
        *n = room < s->size - s->pos ? room : s->size - s->pos;
        memcpy(to, s->data + s->pos, *n);
    } else {
        IX_TRY(pread_all(s, to, room, n));
    }
    s->pos += *n;
    if (s->pos > IX_MAX_TEXT)
        return IX_FAIL(s->ctx, IX_EIO,
                       "%.200s: cannot read: more than %zu bytes", s->name,
                       IX_MAX_TEXT);
    return IX_OK;
}

/* --- opening ---------------------------------------------------------- */

static ix_status look_at_start(ix__input *s)
{
    char start[2];
    size_t n;

    IX_TRY(raw(s, start, sizeof start, &n));
    s->pos = 0;
    s->packed = ix__gz_is(start, n);
    if (n == 2 && memcmp(start, "\x1f\x9d", 2) == 0)
        return IX_FAIL(s->ctx, IX_EPARSE,
                       "%.200s: packed by compress; repack it with gzip",
                       s->name);
    return IX_OK;
}

/* A copy of model in memory of its own, with its start looked at. */
static ix_status make(const ix__input *model, ix__input **out)
{
    ix__input *s = ix__alloc(model->ctx, sizeof *s);
    ix_status st = s ? IX_OK : IX_ENOMEM;

    *out = NULL;
    if (s) {
        *s = *model;
        st = look_at_start(s);
    }
    if (st == IX_OK)
        *out = s;
    else
        ix__free(model->ctx, s, sizeof *s);
    return st;
}

/* Neither waits for the writer of a FIFO nor takes over a terminal. */
ix_status ix__input_file(ix_ctx *ctx, const char *name, ix__input **out)
{
    ix__input s = {.ctx = ctx, .name = name, .owner = true};
    struct stat sb;
    ix_status st;

    *out = NULL;
    s.piece = IX_INPUT_PIECE;
    s.fd = open(name, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (s.fd < 0)
        return ix__file_failed(ctx, "read", name);
    st = fstat(s.fd, &sb) == 0 ? ix__file_regular(ctx, "read", name, &sb)
                               : ix__file_failed(ctx, "read", name);
    s.size = st == IX_OK ? (size_t)sb.st_size : 0;
    if (st == IX_OK)
        st = make(&s, out);
    if (st != IX_OK)
        (void)close(s.fd);
    return st;
}

ix_status ix__input_memory(ix_ctx *ctx, const char *name, const char *data,
                           size_t n, size_t piece, ix__input **out)
{
    const ix__input s = {.ctx = ctx,
                         .name = name,
                         .data = data ? data : "",
                         .fd = -1,
                         .size = n,
                         .piece = piece ? piece : IX_INPUT_PIECE};

    return make(&s, out);
}

ix_status ix__input_again(const ix__input *s, ix__input **out)
{
    ix__input again = *s;

    again.owner = false;
    again.pos = 0;
    again.started = false;
    again.gz = NULL;
    return make(&again, out);
}

void ix__input_close(ix__input *s)
{
    if (!s)
        return;
    ix__gunzip_close(s->gz);
    if (s->owner)
        (void)close(s->fd);
    ix__free(s->ctx, s, sizeof *s);
}

/* --- text ------------------------------------------------------------- */

static ix_status read_text(ix__input *s, char *to, size_t room, size_t *n)
{
    if (!s->packed)
        return raw(s, to, room, n);
    if (!s->gz)
        IX_TRY(ix__gunzip_open(s->ctx, s->name, raw, s, &s->gz));
    return ix__gunzip_read(s->gz, to, room, n);
}

ix_status ix__input_read(ix__input *s, char *to, size_t room, size_t *n)
{
    size_t more = 0;

    IX_TRY(read_text(s, to, room, n));
    if (s->started)
        return IX_OK;
    s->started = true;
    if (*n < 3 || memcmp(to, "\xef\xbb\xbf", 3) != 0)
        return IX_OK;
    *n -= 3;
    memmove(to, to + 3, *n);
    if (*n + 3 == room)
        IX_TRY(read_text(s, to + *n, 3, &more));
    *n += more;
    return IX_OK;
}

size_t ix__input_most(const ix__input *s)
{
    return s->packed ? ix__gz_most(s->size) : s->size;
}

ix_ctx *ix__input_ctx(const ix__input *s)
{
    return s->ctx;
}

const char *ix__input_name(const ix__input *s)
{
    return s->name;
}

size_t ix__input_piece(const ix__input *s)
{
    return s->piece;
}

ix_status ix__input_text(ix_ctx *ctx, const char *name, const char *data,
                         size_t n, ix__read_fn read, ix_obj **out)
{
    ix__input *s;
    ix_status st;

    *out = NULL;
    IX_TRY(ix__input_memory(ctx, name, data, n, 0, &s));
    st = read(s, out);
    ix__input_close(s);
    return st;
}
