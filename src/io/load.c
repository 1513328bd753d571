/* load.c - loading and saving objects: the suffix of the name chooses the
 * format (spec/itd-format 12), ".gz" and ".Z" behind it are looked through. */
#define _POSIX_C_SOURCE 200809L
#include <string.h>
#include <sys/stat.h>

#include "io/export.h"
#include "io/ibd.h"
#include "io/input.h"

typedef ix_status (*write_fn)(ix_buf *b, const ix_obj *o,
                              const ix_write_opts *w);

static ix_status write_itd(ix_buf *b, const ix_obj *o, const ix_write_opts *w)
{
    ix_write_opts file = w ? *w : (ix_write_opts){0};

    file.file = true;
    return ix__itd_write(b, o, &file, 0);
}

static ix_status write_xml(ix_buf *b, const ix_obj *o, const ix_write_opts *w)
{
    (void)w; /* numbers are exact */
    return ix__xml_write(b, o);
}

/* Suffixes that mean something; without functions: known, not supported. */
static const struct format {
    const char *suffix;
    ix__read_fn read;
    write_fn write;
} formats[] = {
    {"itd", ix__itd_read_from, write_itd},
    {"imd", ix__itd_read_from, write_itd},
    {"xml", ix__xml_read_from, write_xml},
    {"x3d", NULL, ix__x3d_write},
    {"x3dz", NULL, ix__x3d_write},
    {"ibd", ix__ibd_read_from, ix__ibd_write},
    {"icd", NULL, NULL},
    {"igs", NULL, NULL},
    {"iges", NULL, NULL},
    {"stl", NULL, ix__stl_write},
    {"bstl", NULL, ix__bstl_write},
    {"obj", NULL, ix__obj_file_write},
    {"step", NULL, ix__step_write},
    {"stp", NULL, ix__step_write},
    {"wrl", NULL, NULL},
    {"vrl", NULL, NULL},
    {"nc", NULL, NULL},
    {"cnc", NULL, NULL},
    {"gcode", NULL, NULL},
};

static bool is_suffix(const char *s, size_t n, const char *suffix)
{
    char text[8];

    if (n != strlen(suffix) || n >= sizeof text)
        return false;
    memcpy(text, s, n);
    text[n] = '\0';
    return ix__name_cmp(text, suffix) == 0;
}

/* The suffix of s[0 .. n): the length behind the last point of the name. */
static size_t suffix_length(const char *s, size_t n)
{
    for (size_t k = 0; k < n && s[n - 1 - k] != '/'; k++)
        if (s[n - 1 - k] == '.')
            return k;
    return 0;
}

#define MAX_ADDED 8
static struct format added[MAX_ADDED];
static size_t nadded;

void ix__save_register(const char *suffix, ix__write_fn fn)
{
    if (nadded < MAX_ADDED)
        added[nadded++] = (struct format){suffix, NULL, fn};
}

static const struct format *find_format(const char *name)
{
    size_t n = strlen(name), k = suffix_length(name, n);

    if (is_suffix(name + n - k, k, "gz") || is_suffix(name + n - k, k, "Z")) {
        n -= k + 1;
        k = suffix_length(name, n);
    }
    for (size_t i = 0; k > 0 && i < sizeof formats / sizeof *formats; i++)
        if (is_suffix(name + n - k, k, formats[i].suffix))
            return &formats[i];
    for (size_t i = 0; k > 0 && i < nadded; i++)
        if (is_suffix(name + n - k, k, added[i].suffix))
            return &added[i];
    return NULL;
}

static ix_status unsupported(ix_ctx *ctx, const char *name, const char *suffix,
                             const char *done)
{
    return IX_FAIL(ctx, IX_EARG,
                   "%.200s: files of type \"%s\" cannot be %s; \"itd\", "
                   "\"ibd\" and \"xml\" can",
                   name, suffix, done);
}

static void with_itd(ix_buf *b, const char *name)
{
    ix__buf_clear(b);
    ix__buf_puts(b, name);
    ix__buf_puts(b, ".itd");
}

static bool is_file(const char *name)
{
    struct stat sb;

    return stat(name, &sb) == 0 && S_ISREG(sb.st_mode);
}

/* The name that is a file: as given, else with the suffix; else as given. */
static ix_status resolve(const char *name, ix_buf *b)
{
    with_itd(b, name);
    IX_TRY(ix__buf_check(b));
    if (is_file(name) || !is_file(b->data)) {
        ix__buf_clear(b);
        ix__buf_puts(b, name);
    }
    return ix__buf_check(b);
}

static ix_status load_file(ix_ctx *ctx, const char *name, ix_obj **out)
{
    const struct format *f = find_format(name);
    ix__read_fn reader = f ? f->read : ix__itd_read_from;
    ix__input *s;
    ix_status st;

    if (!reader)
        return unsupported(ctx, name, f->suffix, "read");
    IX_TRY(ix__input_file(ctx, name, &s));
    st = reader(s, out);
    ix__input_close(s);
    return st;
}

ix_status ix__load(ix_ctx *ctx, const char *name, ix_buf *resolved,
                   ix_obj **out)
{
    ix_buf found;
    ix_status st;

    *out = NULL;
    ix__buf_init(&found, ctx);
    st = resolve(name, &found);
    if (st == IX_OK)
        st = load_file(ctx, found.data, out);
    if (st == IX_OK && resolved) {
        ix__buf_clear(resolved);
        ix__buf_puts(resolved, found.data);
        st = ix__buf_check(resolved);
    }
    ix__buf_free(&found);
    if (st != IX_OK) {
        ix__obj_unref(ctx, *out);
        *out = NULL;
    }
    return st;
}

bool ix__save_knows(const char *name)
{
    return find_format(name) != NULL;
}

static ix_status save_as(ix_ctx *ctx, const char *name, const struct format *f,
                         const ix_obj *o, const ix_write_opts *w)
{
    ix__outfile *out;
    ix_buf text;
    ix_status st;

    IX_TRY(ix__outfile_open(ctx, name, &out));
    if (f->write != ix__bstl_write) /* which goes back to what it wrote */
        return ix__outfile_close(out, f->write(ix__outfile_text(out), o, w));
    ix__buf_init(&text, ctx);
    st = f->write(&text, o, w);
    ix__buf_add(ix__outfile_text(out), text.data, st == IX_OK ? text.len : 0);
    ix__buf_free(&text);
    return ix__outfile_close(out, st);
}

ix_status ix__save(ix_ctx *ctx, const char *name, const ix_obj *o,
                   const ix_write_opts *w)
{
    const struct format *f = find_format(name);
    ix_buf full;
    ix_status st;

    if (f && !f->write)
        return unsupported(ctx, name, f->suffix, "written");
    if (f)
        return save_as(ctx, name, f, o, w);
    ix__buf_init(&full, ctx);
    with_itd(&full, name);
    st = ix__buf_check(&full);
    if (st == IX_OK)
        st = save_as(ctx, full.data, &formats[0], o, w);
    ix__buf_free(&full);
    return st;
}
