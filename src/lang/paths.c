/* paths.c - which files a script may touch, and where INCLUDE finds its own.
 *
 * Unless the system is allowed, files stay below the root directory, symbolic
 * links followed; scripts to include may also stand beside the script of the
 * command line and in the include path, which the user chose. */
#define _XOPEN_SOURCE 700
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "lang/interp_impl.h"

_Static_assert(IX_PATH >= PATH_MAX, "room for a path");

#define SUFFIX ".irt"

/* The directory part of a path, "." if it has none; false if it is too long.
 */
static bool directory(const char *path, char out[PATH_MAX])
{
    const char *slash = strrchr(path, '/');
    size_t n = slash ? (size_t)(slash - path) : 0;

    if (!slash) {
        memcpy(out, ".", 2);
        return true;
    }
    if (n >= PATH_MAX)
        return false;
    memcpy(out, n ? path : "/", n ? n : 1);
    out[n ? n : 1] = '\0';
    return true;
}

/* The real path of a file that may not exist yet; false if its directory does
 * not. */
static bool real_path(const char *path, char out[PATH_MAX])
{
    char dir[PATH_MAX];

    if (realpath(path, out))
        return true;
    return directory(path, dir) && realpath(dir, out);
}

static bool is_below(const char *path, const char *root)
{
    size_t n = root ? strlen(root) : 0;

    if (n == 0)
        return false;
    if (strcmp(root, "/") == 0)
        return true;
    return strncmp(path, root, n) == 0 && (path[n] == '/' || !path[n]);
}

/* Neither a device nor a FIFO nor a directory; what does not exist is fine. */
static ix_status check_kind(ix_interp *in, const char *name)
{
    struct stat s;

    if (stat(name, &s) == 0 && !S_ISREG(s.st_mode))
        return IX_FAIL(in->ctx, IX_EIO, "%s is not a regular file", name);
    return IX_OK;
}

static ix_status check_below(ix_interp *in, const char *doing, const char *name)
{
    char real[PATH_MAX];

    if (!real_path(name, real) || is_below(real, in->root))
        return IX_OK; /* without a directory, opening it fails anyway */
    return IX_FAIL(in->ctx, IX_EIO,
                   "%s %s is refused: it is not below %s (--root DIR or "
                   "--allow-system would permit it)",
                   doing, name, in->root);
}

ix_status ix__path_check(ix_interp *in, const char *name, bool writing)
{
    if (!*name || *name == '|')
        return IX_FAIL(in->ctx, IX_EIO, "\"%s\" is not a file name", name);
    if (in->opt.allow_system)
        return IX_OK;
    IX_TRY(check_kind(in, name));
    return check_below(in, writing ? "writing" : "reading", name);
}

ix_status ix__dir_check(ix_interp *in, const char *name)
{
    return in->opt.allow_system ? IX_OK : check_below(in, "going to", name);
}

ix_status ix__system_check(ix_interp *in)
{
    if (in->opt.allow_system)
        return IX_OK;
    return IX_FAIL(in->ctx, IX_EIO,
                   "commands are refused (--allow-system would permit them)");
}

/* --- plug-ins ------------------------------------------------------------- */

/* The real path of a plug-in: a name without a slash may stand in the folder
 * of plug-ins. */
static bool find_plugin(const ix_interp *in, const char *name,
                        char real[PATH_MAX])
{
    const char *dir = in->opt.plugin_dir;
    char path[PATH_MAX];
    int n;

    if (dir && !strchr(name, '/')) {
        n = snprintf(path, sizeof path, "%s/%s", dir, name);
        if (n < (int)sizeof path && realpath(path, real))
            return true;
    }
    return realpath(name, real) != NULL;
}

/* Any file, or those below the folder of plug-ins, symbolic links followed. */
static ix_status check_plugin(ix_interp *in, const char *name, const char *real)
{
    const char *dir = in->opt.plugin_dir;
    char root[PATH_MAX];

    if (in->opt.allow_plugins ||
        (dir && realpath(dir, root) && is_below(real, root)))
        return IX_OK;
    return IX_FAIL(in->ctx, IX_EIO,
                   "plug-in %s is refused: it is not below %s (--plugin-dir)",
                   name, dir);
}

ix_status ix__plugin_open(ix_interp *in, const char *name)
{
    char real[PATH_MAX];

    if (!in->opt.load_plugin)
        return IX_FAIL(in->ctx, IX_EUNABLE, "plug-ins cannot be loaded here");
    if (!in->opt.allow_plugins && !in->opt.plugin_dir)
        return IX_FAIL(in->ctx, IX_EIO,
                       "plug-ins are refused (--allow-plugins or --plugin-dir "
                       "DIR would permit them)");
    if (!find_plugin(in, name, real))
        return IX_FAIL(in->ctx, IX_EIO, "there is no plug-in %s", name);
    IX_TRY(check_plugin(in, name, real));
    return in->opt.load_plugin(in->ctx, real);
}

static ix_status keep_real(ix_interp *in, const char *path, char **out)
{
    char real[PATH_MAX];

    if (!realpath(path, real))
        return IX_FAIL(in->ctx, IX_EIO, "there is no directory %s", path);
    ix__strfree(in->ctx, *out);
    *out = ix__strdup(in->ctx, real);
    return *out ? IX_OK : IX_ENOMEM;
}

ix_status ix__paths_init(ix_interp *in)
{
    return keep_real(in, in->opt.root ? in->opt.root : ".", &in->root);
}

ix_status ix__paths_script(ix_interp *in, const char *script)
{
    char dir[PATH_MAX];

    if (!directory(script, dir))
        return IX_FAIL(in->ctx, IX_EIO, "%.100s...: name too long", script);
    return keep_real(in, dir, &in->script_dir);
}

/* --- INCLUDE
 * ---------------------------------------------------------------------- */

/* dir/name.irt if it is there; n: length of dir, 0: none. */
static bool candidate(const char *dir, size_t n, const char *name,
                      char out[PATH_MAX])
{
    size_t len = strlen(name);
    bool suffix = len >= 4 && strcmp(name + len - 4, SUFFIX) == 0;
    int k = snprintf(out, PATH_MAX, "%.*s%s%s%s", (int)n, dir, n ? "/" : "",
                     name, suffix ? "" : SUFFIX);

    return k > 0 && k < PATH_MAX && access(out, F_OK) == 0;
}

static bool in_include_path(const ix_interp *in, const char *name,
                            char out[PATH_MAX])
{
    const char *p = in->opt.include_path;

    while (p && *p) {
        size_t n = strcspn(p, ";");

        if (n > 0 && candidate(p, n, name, out))
            return true;
        p += n + (p[n] == ';');
    }
    return false;
}

static bool beside(const char *from, const char *name, char out[PATH_MAX])
{
    const char *slash = strrchr(from, '/');

    return slash && name[0] != '/' &&
           candidate(from, (size_t)(slash - from), name, out);
}

ix_status ix__path_include(ix_interp *in, const char *name, const char *from,
                           char out[IX_PATH])
{
    char real[PATH_MAX];

    if (!*name || *name == '|')
        return IX_FAIL(in->ctx, IX_EIO, "\"%s\" is not a file name", name);
    if (candidate("", 0, name, out) || beside(from, name, out)) {
        if (real_path(out, real) && is_below(real, in->script_dir))
            return check_kind(in, out);
        return ix__path_check(in, out, false);
    }
    if (in_include_path(in, name, out))
        return check_kind(in, out);
    return IX_FAIL(in->ctx, IX_EIO, "cannot find the script %s", name);
}
