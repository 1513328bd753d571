/* editor.c - libedit behind a few functions, loaded at run time.
 *
 * The terminal is in raw mode only within editor_read. Signals are handled by
 * the program; those that only concern the picture on the screen, here. */
#define _POSIX_C_SOURCE 200809L
#include "app/editor.h"

#ifndef IX_NO_LIBEDIT
#include <ctype.h>
#include <dlfcn.h>
#include <errno.h>
#include <glob.h>
#include <histedit.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <wchar.h>

#include "app/keyboard.h"

#define LIBRARY "libedit.so.2"

enum {
    REMEMBERED = 2000, /* lines of history */
    OFFERED = 4096,    /* names that are looked at for completion */
    LISTED = 200,      /* ... and at most shown */
    SCREEN = 80        /* columns, where they are */
};

/* --- the library ------------------------------------------------------- */

static struct {
    __typeof__(el_init) *init;
    __typeof__(el_end) *end;
    __typeof__(el_gets) *gets;
    __typeof__(el_set) *set;
    __typeof__(el_get) *get;
    __typeof__(el_line) *line;
    __typeof__(el_insertstr) *insertstr;
    __typeof__(el_deletestr) *deletestr;
    __typeof__(el_resize) *resize;
    __typeof__(el_source) *source;
    __typeof__(history_init) *history_init;
    __typeof__(history_end) *history_end;
    __typeof__(history) *history;
} lib;

static bool load_library(void)
{
    static const struct {
        const char *name;
        void *slot;
    } wanted[] = {
        {"el_init", &lib.init},
        {"el_end", &lib.end},
        {"el_gets", &lib.gets},
        {"el_set", &lib.set},
        {"el_get", &lib.get},
        {"el_line", &lib.line},
        {"el_insertstr", &lib.insertstr},
        {"el_deletestr", &lib.deletestr},
        {"el_resize", &lib.resize},
        {"el_source", &lib.source},
        {"history_init", &lib.history_init},
        {"history_end", &lib.history_end},
        {"history", &lib.history},
    };
    void *so = dlopen(LIBRARY, RTLD_NOW | RTLD_LOCAL);

    for (size_t i = 0; so && i < sizeof wanted / sizeof *wanted; i++) {
        void *symbol = dlsym(so, wanted[i].name);

        if (!symbol)
            return false;
        memcpy(wanted[i].slot, &symbol, sizeof symbol);
    }
    return so != NULL;
}

/* --- signals ----------------------------------------------------------- */

static volatile sig_atomic_t resized, resumed;

static void on_signal(int sig)
{
    *(sig == SIGCONT ? &resumed : &resized) = 1;
}

static void watch_screen(void)
{
    struct sigaction a = {.sa_handler = on_signal};

    (void)sigemptyset(&a.sa_mask);
    (void)sigaction(SIGWINCH, &a, NULL);
    (void)sigaction(SIGCONT, &a, NULL);
}

static void mend_screen(EditLine *el)
{
    if (resized)
        lib.resize(el);
    if (resumed) { /* the shell may have set other modes */
        (void)lib.set(el, EL_PREP_TERM, 0);
        (void)lib.set(el, EL_PREP_TERM, 1);
        (void)lib.set(el, EL_REFRESH);
    }
    resized = resumed = 0;
}

static editor *of(EditLine *el)
{
    void *e = NULL;

    (void)lib.get(el, EL_CLIENTDATA, &e);
    return e;
}

/* One character of the terminal. The language is ASCII: nothing else gets into
 * a line. */
static int read_char(EditLine *el, wchar_t *out)
{
    const editor *e = of(el);

    for (;;) {
        unsigned char c;
        ssize_t n;

        if (*e->cancel)
            return -1;
        if (!keyboard_wait(e->cancel)) {
            mend_screen(el);
            continue;
        }
        n = read(STDIN_FILENO, &c, 1);
        if (n == 0)
            return 0;
        if (n < 0 && errno != EINTR)
            return -1;
        if (n > 0 && c < 0x80) {
            *out = c;
            return 1;
        }
    }
}

static char *prompt_text(EditLine *el)
{
    static char text[32];

    (void)snprintf(text, sizeof text, "%s", of(el)->prompt);
    return text;
}

/* --- completion -------------------------------------------------------- */

/* Length of what all n names have in common. */
static size_t common(const char *const *name, size_t n)
{
    size_t k = strlen(name[0]);

    for (size_t i = 1; i < n; i++)
        for (size_t j = 0; j < k; j++)
            if (name[i][j] != name[0][j])
                k = j;
    return k;
}

static void list_names(const char *const *name, size_t n)
{
    size_t width = 0, columns;

    for (size_t i = 0; i < n; i++)
        width = strlen(name[i]) > width ? strlen(name[i]) : width;
    columns = SCREEN / (width + 2) ? SCREEN / (width + 2) : 1;
    for (size_t i = 0; i < n && i < LISTED; i++)
        (void)printf("%s%-*s", i % columns ? "  " : "\n", (int)width, name[i]);
    if (n > LISTED)
        (void)printf("\n... and %zu more", n - LISTED);
    (void)putchar('\n');
}

/* Inserts what follows the n characters typed, in their case. */
static void insert_rest(EditLine *el, const char *typed, size_t n,
                        const char *name, size_t len)
{
    bool lower = islower((unsigned char)typed[n - 1]);
    char rest[256];
    size_t k = 0;

    for (size_t i = n; i < len && k + 1 < sizeof rest; i++) {
        int c = (unsigned char)name[i];

        rest[k++] = (char)(lower ? tolower(c) : c);
    }
    rest[k] = '\0';
    (void)lib.insertstr(el, rest);
}

static bool in_name(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

/* Behind the quote of a text that is open at the cursor; NULL: none is. */
static const char *open_text(const LineInfo *li)
{
    const char *open = NULL;

    for (const char *p = li->buffer; p < li->cursor; p++) {
        if (*p == '"')
            open = open ? NULL : p + 1;
        else if (*p == '\\' && open && p + 1 < li->cursor)
            p++;
    }
    return open;
}

/* "text*" for glob(), which takes the text as it stands. */
static bool make_pattern(const char *text, size_t n, char *out, size_t room)
{
    size_t k = 0;

    if (2 * n + 2 > room)
        return false;
    for (size_t i = 0; i < n; i++) {
        if (strchr("*?[\\", text[i]))
            out[k++] = '\\';
        out[k++] = text[i];
    }
    out[k++] = '*';
    out[k] = '\0';
    return true;
}

static const char *cut(char *s, size_t n)
{
    s[n] = '\0';
    return s;
}

/* The name of a file, n characters of which are typed; a whole one ends the
 * text. */
static unsigned char complete_path(EditLine *el, const char *typed, size_t n)
{
    unsigned char done = CC_REFRESH_BEEP;
    char pattern[1024];
    glob_t g;
    size_t k;

    if (!make_pattern(typed, n, pattern, sizeof pattern) ||
        glob(pattern, GLOB_MARK, NULL, &g) != 0)
        return CC_REFRESH_BEEP;
    k = common((const char *const *)g.gl_pathv, g.gl_pathc);
    if (k > n || g.gl_pathc == 1) {
        (void)lib.insertstr(el, g.gl_pathc == 1 ? g.gl_pathv[0] + n
                                                : cut(g.gl_pathv[0], k) + n);
        if (g.gl_pathc == 1 && g.gl_pathv[0][k - 1] != '/')
            (void)lib.insertstr(el, "\"");
        done = CC_REFRESH;
    } else {
        list_names((const char *const *)g.gl_pathv, g.gl_pathc);
        done = CC_REDISPLAY;
    }
    globfree(&g);
    return done;
}

static unsigned char complete(EditLine *el, int key)
{
    static const char *name[OFFERED];
    const editor *e = of(el);
    const LineInfo *li = lib.line(el);
    const char *word = li->cursor, *text = open_text(li);
    size_t typed, n, k;

    (void)key;
    if (text)
        return complete_path(el, text, (size_t)(li->cursor - text));
    while (word > li->buffer && in_name(word[-1]))
        word--;
    typed = (size_t)(li->cursor - word);
    if (typed == 0)
        return CC_REFRESH_BEEP;
    n = e->complete(e->ud, word, typed, name, OFFERED);
    if (n == 0)
        return CC_REFRESH_BEEP;
    k = common(name, n);
    if (k > typed) {
        insert_rest(el, word, typed, name[0], k);
        return CC_REFRESH;
    }
    if (n == 1)
        return CC_NORM;
    list_names(name, n);
    return CC_REDISPLAY;
}

/* --- history ----------------------------------------------------------- */

/* Makes the directories of a path that are missing; private, as the XDG base
 * directories want it. */
static void make_directories(char *path)
{
    for (char *slash = strchr(path + 1, '/'); slash;
         slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        (void)mkdir(path, 0700);
        *slash = '/';
    }
}

static void find_history(editor *e)
{
    const char *state = getenv("XDG_STATE_HOME"), *home = getenv("HOME");
    int n = -1;

    if (state && *state == '/')
        n = snprintf(e->file, sizeof e->file, "%s/iritx/history", state);
    else if (home && *home == '/')
        n = snprintf(e->file, sizeof e->file, "%s/.local/state/iritx/history",
                     home);
    if (n < 0 || n >= (int)sizeof e->file)
        e->file[0] = '\0';
}

static void open_history(editor *e)
{
    HistEvent ev;

    e->history = lib.history_init();
    if (!e->history)
        return;
    (void)lib.history(e->history, &ev, H_SETSIZE, (int)REMEMBERED);
    (void)lib.history(e->history, &ev, H_SETUNIQUE, 1);
    (void)lib.set(e->line, EL_HIST, lib.history, e->history);
    find_history(e);
    if (e->file[0])
        (void)lib.history(e->history, &ev, H_LOAD, e->file);
}

void editor_remember(editor *e, const char *text, bool more)
{
    HistEvent ev;

    if (!e->history || !*text)
        return;
    if (more)
        (void)lib.history(e->history, &ev, H_APPEND, " ");
    (void)lib.history(e->history, &ev, more ? H_APPEND : H_ENTER, text);
    if (!e->file[0])
        return;
    make_directories(e->file);
    (void)lib.history(e->history, &ev, H_SAVE, e->file);
}

/* --- the editor -------------------------------------------------------- */

bool editor_open(editor *e, const volatile int *cancel,
                 editor_complete_fn names, void *ud)
{
    const char *term = getenv("TERM");
    EditLine *el;

    *e = (editor){.cancel = cancel, .complete = names, .ud = ud, .prompt = ""};
    if (!term || !*term || strcmp(term, "dumb") == 0 || !load_library())
        return false;
    el = e->line = lib.init("iritx", stdin, stdout, stderr);
    if (!el)
        return false;
    (void)lib.set(el, EL_CLIENTDATA, e);
    (void)lib.set(el, EL_PROMPT, prompt_text);
    (void)lib.set(el, EL_EDITOR, "emacs");
    (void)lib.set(el, EL_GETCFN, read_char);
    (void)lib.set(el, EL_ADDFN, "iritx-complete", "Completes a name", complete);
    open_history(e);
    (void)lib.set(el, EL_BIND, "^R", "em-inc-search-prev", NULL);
    (void)lib.source(el, NULL); /* ~/.editrc */
    (void)lib.set(el, EL_BIND, "^I", "iritx-complete", NULL);
    watch_screen();
    return true;
}

editor_result editor_read(editor *e, const char *prompt, ix_buf *b)
{
    const char *text;
    int n = 0;

    e->prompt = prompt;
    resized = 1; /* meanwhile, perhaps */
    mend_screen(e->line);
    text = lib.gets(e->line, &n);
    if (!text || n <= 0) {
        (void)putchar('\n');
        return *e->cancel ? EDITOR_INTERRUPTED : EDITOR_END;
    }
    while (n > 0 && (text[n - 1] == '\n' || text[n - 1] == '\r'))
        n--;
    ix__buf_add(b, text, (size_t)n);
    return EDITOR_LINE;
}

void editor_close(editor *e)
{
    if (e->history)
        lib.history_end(e->history);
    if (e->line)
        lib.end(e->line);
    e->line = e->history = NULL;
}

#else

bool editor_open(editor *e, const volatile int *cancel,
                 editor_complete_fn names, void *ud)
{
    *e = (editor){.cancel = cancel, .complete = names, .ud = ud};
    return false;
}

editor_result editor_read(editor *e, const char *prompt, ix_buf *b)
{
    (void)e;
    (void)prompt;
    (void)b;
    return EDITOR_END;
}

void editor_remember(editor *e, const char *text, bool more)
{
    (void)e;
    (void)text;
    (void)more;
}

void editor_close(editor *e)
{
    (void)e;
}
#endif
