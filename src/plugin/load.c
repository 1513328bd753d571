/* load.c - opens a shared object and calls its ix_plugin_init.
 *
 * What has registered rows stays open until the process ends, for the index of
 * built-ins points into it. */
#define _XOPEN_SOURCE 700
#include "plugin/load.h"

#include <dlfcn.h>
#include <limits.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/ctx.h"
#include "lang/host.h"

#define MAX_PLUGINS 64

static void *loaded[MAX_PLUGINS]; /* handles; under the lock */
static int nloaded;
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

typedef ix_status (*init_fn)(const ix_host *h, ix_registry *r);

/* The symbol as a function: ISO C has no conversion from void *. */
static init_fn find_init(void *handle)
{
    void *p = dlsym(handle, "ix_plugin_init");
    init_fn fn;

    _Static_assert(sizeof fn == sizeof p, "POSIX wants it so");
    memcpy(&fn, &p, sizeof fn);
    return fn;
}

static bool known(const void *handle)
{
    for (int i = 0; i < nloaded; i++)
        if (loaded[i] == handle)
            return true;
    return false;
}

/* Puts "plug-in NAME: " in front of the message. */
static ix_status refused(ix_ctx *ctx, const char *path, ix_status st)
{
    char text[400];

    (void)snprintf(text, sizeof text, "%s", ix_ctx_message(ctx));
    return IX_FAIL(ctx, st, "plug-in %.100s: %s", path,
                   *text ? text : ix_status_name(st));
}

static ix_status start(ix_ctx *ctx, const char *path, void *handle,
                       ix_registry *r)
{
    init_fn init = find_init(handle);
    ix_status st;

    if (!init)
        return IX_FAIL(ctx, IX_EARG,
                       "%s is not a plug-in: it has no function ix_plugin_init",
                       path);
    if (nloaded == MAX_PLUGINS)
        return IX_FAIL(ctx, IX_EUNABLE, "%s: %d plug-ins are loaded already",
                       path, MAX_PLUGINS);
    st = init(&ix__host, r);
    if (st == IX_OK && r->added == 0)
        st = IX_FAIL(ctx, IX_EARG, "it registers no function");
    return st == IX_OK ? IX_OK : refused(ctx, path, st);
}

/* Holds the lock. */
static ix_status load(ix_ctx *ctx, const char *path, const char *real)
{
    ix_registry r = {.ctx = ctx};
    void *handle = dlopen(real, RTLD_NOW | RTLD_LOCAL);
    ix_status st = IX_OK;

    if (!handle)
        return IX_FAIL(ctx, IX_EIO, "plug-in %.100s: %.300s", path, dlerror());
    if (!known(handle))
        st = start(ctx, path, handle, &r);
    if (r.added > 0)
        loaded[nloaded++] = handle;
    else
        (void)dlclose(handle);
    return st;
}

ix_status ix__plugin_load(ix_ctx *ctx, const char *path)
{
    char real[PATH_MAX];
    ix_status st;

    if (!realpath(path, real))
        return IX_FAIL(ctx, IX_EIO, "there is no plug-in %s", path);
    (void)pthread_mutex_lock(&lock);
    st = load(ctx, path, real);
    (void)pthread_mutex_unlock(&lock);
    return st;
}
