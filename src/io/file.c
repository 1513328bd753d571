/* file.c - files in and out. Only regular files are touched. A file is replaced
 * by renaming a complete, synced one onto it, so that at any moment the old or
 * the new contents are there, and nothing else. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "io/file_impl.h"
#include "io/gz.h"
#include "io/input.h"

ix_status ix__file_failed(ix_ctx *ctx, const char *what, const char *name)
{
    int code = errno;
    char reason[128];

    if (strerror_r(code, reason, sizeof reason) != 0)
        reason[0] = '\0';
    return IX_FAIL(ctx, IX_EIO, "%.200s: cannot %s: %s", name, what, reason);
}

ix_status ix__file_regular(ix_ctx *ctx, const char *what, const char *name,
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

static ix_status read_all(ix__input *s, ix_buf *out)
{
    ix_ctx *ctx = ix__input_ctx(s);
    char *piece;
    size_t n;

    IX_SCRATCH(ctx, piece, IX_INPUT_PIECE);
    do {
        IX_TRY(ix__input_read(s, piece, IX_INPUT_PIECE, &n));
        ix__buf_add(out, piece, n); /* also makes an empty text */
        IX_TRY(ix__buf_check(out));
    } while (n == IX_INPUT_PIECE);
    return IX_OK;
}

ix_status ix__file_read(ix_ctx *ctx, const char *name, ix_buf *out)
{
    ix_mark mk = ix__scratch_mark(ctx);
    ix__input *s;
    ix_status st;

    ix__buf_init(out, ctx);
    IX_TRY(ix__input_file(ctx, name, &s));
    st = read_all(s, out);
    ix__input_close(s);
    ix__scratch_release(ctx, mk);
    if (st != IX_OK)
        ix__buf_free(out);
    return st;
}

/* --- writing ---------------------------------------------------------- */

struct ix__outfile {
    ix_ctx *ctx;
    const char *name;
    char *temp; /* beside name */
    size_t temp_bytes;
    int fd; /* of temp */
    ix_buf text;
    ix__gzip *gz; /* NULL: not packed */
};

typedef ix__outfile saving;

static const char *base_name(const char *name)
{
    const char *slash = strrchr(name, '/');

    return slash ? slash + 1 : name;
}

static ix_status make_names(saving *s)
{
    if (!*base_name(s->name))
        return IX_FAIL(s->ctx, IX_EIO, "%.200s: cannot write: no file name",
                       s->name);
    s->temp_bytes = strlen(s->name) + 16;
    s->temp = ix__alloc(s->ctx, s->temp_bytes);
    return s->temp ? IX_OK : IX_ENOMEM;
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
        return ix__file_failed(s->ctx, "write", s->name);
    if (old)
        (void)fchmod(s->fd, old->st_mode & 0777);
    return IX_OK;
}

/* Bytes as they are stored. */
static ix_status write_raw(void *arg, const char *data, size_t n)
{
    saving *s = arg;

    while (n > 0) {
        ssize_t k;

        IX_TRY(ix__poll(s->ctx));
        k = write(s->fd, data, n);
        if (k < 0 && errno == EINTR)
            continue;
        if (k < 0)
            return ix__file_failed(s->ctx, "write", s->name);
        data += k;
        n -= (size_t)k;
    }
    return IX_OK;
}

static ix_status write_text(void *arg, const char *data, size_t n)
{
    saving *s = arg;

    return s->gz ? ix__gzip_put(s->gz, data, n) : write_raw(s, data, n);
}

/* The rename itself reaches the disk with its directory; some file systems
 * cannot do that and say EINVAL. */
static ix_status sync_dir(const saving *s)
{
    size_t n = (size_t)(base_name(s->name) - s->name);
    ix_status st = IX_OK;
    int fd;

    memcpy(s->temp, n ? s->name : ".", n ? n : 1); /* not needed any more */
    s->temp[n ? n : 1] = '\0';
    fd = open(s->temp, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0)
        return IX_OK; /* not readable: nothing more can be done */
    if (fsync(fd) != 0 && errno != EINVAL)
        st = ix__file_failed(s->ctx, "sync the directory", s->name);
    (void)close(fd);
    return st;
}

static bool ends_with(const char *s, const char *suffix)
{
    size_t n = strlen(s), k = strlen(suffix);

    return n > k && ix__name_cmp(s + n - k, suffix) == 0;
}

static bool is_packed(const char *name)
{
    return ends_with(name, ".gz") || ends_with(name, ".Z") ||
           ends_with(name, ".x3dz");
}

static ix_status open_out(saving *s)
{
    struct stat old;
    bool exists = stat(s->name, &old) == 0;

    if (exists)
        IX_TRY(ix__file_regular(s->ctx, "write", s->name, &old));
    IX_TRY(make_names(s));
    if (is_packed(s->name))
        IX_TRY(ix__gzip_open(s->ctx, write_raw, s, &s->gz));
    return open_temp(s, exists ? &old : NULL);
}

static void drop_out(saving *s)
{
    if (s->fd >= 0) {
        (void)close(s->fd);
        (void)unlink(s->temp);
    }
    ix__gzip_close(s->gz);
    ix__buf_free(&s->text);
    ix__free(s->ctx, s->temp, s->temp_bytes);
    ix__free(s->ctx, s, sizeof *s);
}

ix_status ix__outfile_open(ix_ctx *ctx, const char *name, ix__outfile **out)
{
    saving *s = ix__alloc(ctx, sizeof *s);
    ix_status st;

    *out = NULL;
    if (!s)
        return IX_ENOMEM;
    *s = (saving){.ctx = ctx, .name = name, .fd = -1};
    ix__buf_init(&s->text, ctx);
    s->text.sink = write_text;
    s->text.sink_arg = s;
    st = open_out(s);
    if (st == IX_OK)
        *out = s;
    else
        drop_out(s);
    return st;
}

ix_buf *ix__outfile_text(ix__outfile *f)
{
    return &f->text;
}

/* Complete and on the disk, then under its name. */
static ix_status finish(saving *s)
{
    IX_TRY(ix__buf_flush(&s->text));
    if (s->gz)
        IX_TRY(ix__gzip_finish(s->gz));
    IX_TRY(ix__poll(s->ctx));
    if (fsync(s->fd) != 0 && errno != EINVAL)
        return ix__file_failed(s->ctx, "write", s->name);
    if (rename(s->temp, s->name) != 0)
        return ix__file_failed(s->ctx, "write", s->name);
    (void)close(s->fd); /* synced: it cannot fail to write */
    s->fd = -1;
    return sync_dir(s);
}

ix_status ix__outfile_close(ix__outfile *f, ix_status st)
{
    if (st == IX_OK)
        st = finish(f);
    drop_out(f);
    return st;
}

ix_status ix__file_write(ix_ctx *ctx, const char *name, const char *data,
                         size_t n)
{
    ix_status st = IX_OK;
    ix__outfile *f;

    IX_TRY(ix__outfile_open(ctx, name, &f));
    for (size_t at = 0; st == IX_OK && at < n; at += IX_BUF_PIECE) {
        ix__buf_add(&f->text, data + at,
                    n - at < IX_BUF_PIECE ? n - at : IX_BUF_PIECE);
        st = ix__buf_check(&f->text);
    }
    return ix__outfile_close(f, st);
}
