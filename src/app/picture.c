/* picture.c - the way to the drawing module: iritx_draw.so beside the program
 * or in lib/iritx next to its bin. */
#define _POSIX_C_SOURCE 200809L
#include "app/picture.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define MODULE "iritx_draw.so"

/* Opens the module at the program's folder + relative. */
static void *open_beside(const char *relative)
{
    char path[PATH_MAX];
    ssize_t n = readlink("/proc/self/exe", path, sizeof path - 1);
    char *slash;
    size_t room;

    if (n <= 0)
        return NULL;
    path[n] = '\0';
    slash = strrchr(path, '/');
    if (!slash)
        return NULL;
    room = sizeof path - (size_t)(slash + 1 - path);
    if (strlen(relative) >= room)
        return NULL;
    memcpy(slash + 1, relative, strlen(relative) + 1);
    return dlopen(path, RTLD_NOW | RTLD_LOCAL);
}

static draw_fn find_module(ix_ctx *ctx)
{
    static draw_fn found;
    void *so, *symbol;

    if (found)
        return found;
    so = open_beside(MODULE);
    if (!so)
        so = open_beside("../lib/iritx/" MODULE);
    symbol = so ? dlsym(so, "ix__draw_picture") : NULL;
    if (symbol) {
        memcpy(&found, &symbol, sizeof found); /* POSIX: they have one size */
    } else {
        const char *why = dlerror();

        (void)IX_FAIL(ctx, IX_EUNABLE, "no pictures: %s",
                      why ? why : "the module " MODULE " cannot be loaded");
    }
    return found;
}

ix_status picture_draw(ix_buf *out, const ix_obj *o, const draw_opts *d)
{
    draw_fn draw = find_module(out->ctx);

    return draw ? draw(out, o, d) : IX_EUNABLE;
}

static ix_status write_as(draw_format f, ix_buf *b, const ix_obj *o)
{
    const draw_opts d = {.format = f};

    return picture_draw(b, o, &d);
}

static ix_status write_svg(ix_buf *b, const ix_obj *o, const ix_write_opts *w)
{
    (void)w;
    return write_as(DRAW_SVG, b, o);
}

static ix_status write_png(ix_buf *b, const ix_obj *o, const ix_write_opts *w)
{
    (void)w;
    return write_as(DRAW_PNG, b, o);
}

static ix_status write_pdf(ix_buf *b, const ix_obj *o, const ix_write_opts *w)
{
    (void)w;
    return write_as(DRAW_PDF, b, o);
}

void picture_register(void)
{
    ix__save_register("svg", write_svg);
    ix__save_register("png", write_png);
    ix__save_register("pdf", write_pdf);
}
