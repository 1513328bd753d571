/* file.c - whole files in and out. Only regular files are touched. A file is
 * replaced by renaming a complete, synced one onto it, so that at any moment
 * the old or the new contents are there, and nothing else. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "io/gz.h"
#include "io/io.h"

#define CHUNK ((size_t)1 << 20)

/* "x.itd: cannot read: No such file or directory" */
static ix_status failed(ix_ctx *ctx, const char *what, const char *name)
{
    int code = errno;
    char reason[128];

    if (strerror_r(code, reason, sizeof reason) != 0)
        reason[0] = '\0';
    return IX_FAIL(ctx, IX_EIO, "%.200s: cannot %s: %s", name, what, reason);
}

static ix_status need_regular(ix_ctx *ctx, const char *what, const char *name,
                              const struct stat *sb)
{
    if (S_ISREG(sb->st_mode))
        return IX_OK;
    return IX_FAIL(ctx, IX_EIO, "%.200s: cannot %s: it is a %s, not a file",
                   name, what,
                   S_ISDIR(sb->st_mode)    ? "directory"
                   : S_ISFIFO(sb->st_mode) ? "FIFO"
                   : S_ISSOCK(sb->st_mode) ? "socket"
                                           : "device");
}

/* --- reading ---------------------------------------------------------- */

static ix_status read_fd(ix_ctx *ctx, int fd, const char *name, ix_buf *out)
{
    char *chunk;
    ssize_t n;

    IX_SCRATCH(ctx, chunk, CHUNK);
    for (;;) {
        IX_TRY(ix__poll(ctx));
        n = read(fd, chunk, CHUNK);
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            return failed(ctx, "read", name);
        ix__buf_add(out, chunk, (size_t)n); /* also makes an empty text */
        IX_TRY(ix__buf_check(out));
        if (n == 0)
            return IX_OK;
        if (out->len > IX_MAX_TEXT)
            return IX_FAIL(ctx, IX_EIO,
                           "%.200s: cannot read: more than %zu bytes", name,
                           IX_MAX_TEXT);
    }
}

/* Neither waits for the writer of a FIFO nor takes over a terminal. */
static ix_status read_raw(ix_ctx *ctx, const char *name, ix_buf *out)
{
    int fd = open(name, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    struct stat sb;
    ix_status st;

    if (fd < 0)
        return failed(ctx, "read", name);
    st = fstat(fd, &sb) == 0 ? need_regular(ctx, "read", name, &sb)
                             : failed(ctx, "read", name);
    if (st == IX_OK)
        st = read_fd(ctx, fd, name, out);
    (void)close(fd);
    return st;
}

static ix_status inflate_in_place(ix_ctx *ctx, const char *name, ix_buf *b)
{
    ix_buf text;
    ix_status st;

    ix__buf_init(&text, ctx);
    st = ix__gz_inflate(ctx, name, b->data, b->len, &text);
    ix__buf_free(st == IX_OK ? b : &text);
    if (st == IX_OK)
        *b = text;
    return st;
}

ix_status ix__file_read(ix_ctx *ctx, const char *name, ix_buf *out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix_status st;

    ix__buf_init(out, ctx);
    st = read_raw(ctx, name, out);
    ix__scratch_release(ctx, mk);
    if (st == IX_OK && ix__gz_is(out->data, out->len))
        st = inflate_in_place(ctx, name, out);
    else if (st == IX_OK && out->len >= 2 &&
             memcmp(out->data, "\x1f\x9d", 2) == 0)
        st = IX_FAIL(ctx, IX_EPARSE,
                     "%.200s: packed by compress; repack it with gzip", name);
    if (st != IX_OK)
        ix__buf_free(out);
    return st;
}

/* --- writing ---------------------------------------------------------- */

typedef struct {
    ix_ctx *ctx;
    const char *name;
    char *temp; /* beside name */
    char *dir;
    int fd;
} saving;

static const char *base_name(const char *name)
{
    const char *slash = strrchr(name, '/');

    return slash ? slash + 1 : name;
}

static ix_status make_names(saving *s)
{
    const char *base = base_name(s->name);
    size_t dir = (size_t)(base - s->name);

    if (!*base)
        return IX_FAIL(s->ctx, IX_EIO, "%.200s: cannot write: no file name",
                       s->name);
    IX_SCRATCH(s->ctx, s->temp, strlen(s->name) + 16);
    IX_SCRATCH(s->ctx, s->dir, dir + 2);
    memcpy(s->dir, dir ? s->name : ".", dir ? dir : 1);
    s->dir[dir ? dir : 1] = '\0';
    return IX_OK;
}

/* dir/.base.XXXXXX with six letters drawn from a counter. */
static void temp_name(saving *s, uint64_t draw)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyz0123456789";
    const char *base = base_name(s->name);
    size_t dir = (size_t)(base - s->name), n = strlen(base);
    char *p = s->temp;

    memcpy(p, s->name, dir);
    p += dir;
    *p++ = '.';
    memcpy(p, base, n);
    p += n;
    *p++ = '.';
    for (int i = 0; i < 6; i++) {
        *p++ = letters[draw % 36];
        draw /= 36;
    }
    *p = '\0';
}

/* The process' umask applies; an old file's mode is kept. */
static ix_status open_temp(saving *s, const struct stat *old)
{
    struct timespec now;
    uint64_t draw;

    (void)clock_gettime(CLOCK_REALTIME, &now);
    draw = (uint64_t)now.tv_nsec ^ ((uint64_t)getpid() << 30);
    for (int i = 0; i < 100; i++) {
        temp_name(s, draw + (uint64_t)i * 7919);
        s->fd = open(s->temp,
                     O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                     0666);
        if (s->fd >= 0 || errno != EEXIST)
            break;
    }
    if (s->fd < 0)
        return failed(s->ctx, "write", s->name);
    if (old)
        (void)fchmod(s->fd, old->st_mode & 0777);
    return IX_OK;
}

static ix_status write_all(saving *s, const char *data, size_t n)
{
    while (n > 0) {
        ssize_t k;

        IX_TRY(ix__poll(s->ctx));
        k = write(s->fd, data, n < CHUNK ? n : CHUNK);
        if (k < 0 && errno == EINTR)
            continue;
        if (k < 0)
            return failed(s->ctx, "write", s->name);
        data += k;
        n -= (size_t)k;
    }
    if (fsync(s->fd) != 0 && errno != EINVAL)
        return failed(s->ctx, "write", s->name);
    return IX_OK;
}

/* The rename itself reaches the disk with its directory; some file systems
 * cannot do that and say EINVAL. */
static ix_status sync_dir(const saving *s)
{
    int fd = open(s->dir, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    ix_status st = IX_OK;

    if (fd < 0)
        return IX_OK; /* not readable: nothing more can be done */
    if (fsync(fd) != 0 && errno != EINVAL)
        st = failed(s->ctx, "sync the directory", s->name);
    (void)close(fd);
    return st;
}

static ix_status fill_and_rename(saving *s, const char *data, size_t n)
{
    ix_status st = write_all(s, data, n);

    if (close(s->fd) != 0 && st == IX_OK)
        st = failed(s->ctx, "write", s->name);
    if (st == IX_OK && rename(s->temp, s->name) != 0)
        st = failed(s->ctx, "write", s->name);
    if (st != IX_OK)
        (void)unlink(s->temp);
    return st;
}

static ix_status save(saving *s, const char *data, size_t n)
{
    struct stat old;
    bool exists = stat(s->name, &old) == 0;

    if (exists)
        IX_TRY(need_regular(s->ctx, "write", s->name, &old));
    IX_TRY(make_names(s));
    IX_TRY(open_temp(s, exists ? &old : NULL));
    IX_TRY(fill_and_rename(s, data, n));
    return sync_dir(s);
}

static bool ends_with(const char *s, const char *suffix)
{
    size_t n = strlen(s), k = strlen(suffix);

    return n > k && ix__name_cmp(s + n - k, suffix) == 0;
}

ix_status ix__file_write(ix_ctx *ctx, const char *name, const char *data,
                         size_t n)
{
    saving s = {.ctx = ctx, .name = name, .fd = -1};
    ix_mark mk = ix__scratch_mark(ctx);
    ix_buf packed;
    ix_status st = IX_OK;

    ix__buf_init(&packed, ctx);
    if (ends_with(name, ".gz") || ends_with(name, ".Z") ||
        ends_with(name, ".x3dz")) {
        st = ix__gz_deflate(ctx, data, n, &packed);
        data = packed.data;
        n = packed.len;
    }
    if (st == IX_OK)
        st = save(&s, data, n);
    ix__buf_free(&packed);
    ix__scratch_release(ctx, mk);
    return st;
}
