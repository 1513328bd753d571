/* types.c - sets of types: their words in signatures and in messages. */
#include "lang/types_impl.h"

#include <stdio.h>
#include <string.h>

static const struct {
    const char *word; /* in signatures */
    ix__types set;
    const char *text; /* in messages; NULL: made of its members */
} words[] = {
    {"num", IX_T(NUMBER), "a number"},
    {"bool", IX_T(NUMBER), NULL},
    {"str", IX_T(STRING), "a string"},
    {"point", IX_T(POINT), "a point"},
    {"vector", IX_T(VECTOR), "a vector"},
    {"plane", IX_T(PLANE), "a plane"},
    {"ctlpt", IX_T(CTLPT), "a control point"},
    {"matrix", IX_T(MATRIX), "a matrix"},
    {"list", IX_T(LIST), "a list"},
    {"poly", IX_T(POLY), "a poly"},
    {"curve", IX_T(CURVE), "a curve"},
    {"surface", IX_T(SURFACE), "a surface"},
    {"trimsrf", IX_T(TRIMSRF), "a trimmed surface"},
    {"trivar", IX_T(TRIVAR), "a trivariate"},
    {"trisrf", IX_T(TRISRF), "a triangular surface"},
    {"model", IX_T(MODEL), "a model"},
    {"mv", IX_T(MULTIVAR), "a multivariate"},
    {"instance", IX_T(INSTANCE), "an instance"},
    {"any", IX_T_ANY, NULL},
    {"pv", IX_T_PV, NULL},
    {"pt3", IX_T_PV | IX_T(CTLPT), NULL},
    {"freeform", IX_T_FREE, NULL},
    {"geom", IX_T_GEOM, NULL},
    {"nothing", 0, NULL},
};
#define NWORDS (sizeof words / sizeof *words)

static bool parse_word(const char *s, size_t n, ix__types *set)
{
    for (size_t i = 0; i < NWORDS; i++) {
        if (strlen(words[i].word) == n && memcmp(words[i].word, s, n) == 0) {
            *set |= words[i].set;
            return true;
        }
    }
    return false;
}

/* "word|word" up to end. */
static bool parse_set(const char *s, const char *end, ix__types *set)
{
    *set = 0;
    for (;;) {
        const char *bar = memchr(s, '|', (size_t)(end - s));
        const char *stop = bar ? bar : end;

        if (!parse_word(s, (size_t)(stop - s), set))
            return false;
        if (!bar)
            return true;
        s = bar + 1;
    }
}

/* "name:set", "[name:set]" or "name:set..." between s and end. */
static bool parse_arg(const char *s, const char *end, ix__sig *out)
{
    bool optional = *s == '[', rest;
    const char *colon;
    ix__types set;

    if (optional) {
        s++;
        if (*--end != ']')
            return false;
    }
    rest = end - s > 3 && memcmp(end - 3, "...", 3) == 0;
    if (rest)
        end -= 3;
    colon = memchr(s, ':', (size_t)(end - s));
    if (out->nmax < 0 || !colon || !parse_set(colon + 1, end, &set))
        return false;
    if (rest) {
        out->rest = set;
        out->nmax = -1;
        return true;
    }
    if (out->nmax == IX_SIG_MAX || (!optional && out->nmin < out->nmax))
        return false;
    out->arg[out->nmax++] = set;
    out->nmin += !optional;
    return true;
}

bool ix__sig_parse(const char *text, ix__sig *out)
{
    *out = (ix__sig){.nmin = 0};
    for (;;) {
        size_t n;

        text += strspn(text, " ");
        n = strcspn(text, " ");
        if (n == 2 && memcmp(text, "->", 2) == 0)
            break;
        if (n == 0 || !parse_arg(text, text + n, out))
            return false;
        text += n;
    }
    text += 2;
    text += strspn(text, " ");
    return parse_set(text, text + strlen(text), &out->result);
}

const char *ix__sig_text(const ix_builtin *row, char *buf, size_t size)
{
    const char *s = row->signature, *arrow = strstr(s, "->");
    size_t at = (size_t)snprintf(buf, size, "%s(", row->name);

    while (s < arrow && at < size) {
        size_t n = strcspn(s, " ");

        at += (size_t)snprintf(buf + at, size - at, "%.*s%s", (int)n, s,
                               s + n + 1 < arrow ? ", " : "");
        s += n + 1;
    }
    if (at < size)
        (void)snprintf(buf + at, size - at, ") %s", arrow);
    return buf;
}

ix__types ix__sig_arg(const ix__sig *s, int i)
{
    return s->nmax < 0 && i >= s->nmin ? s->rest : s->arg[i];
}

const char *ix__types_text(ix__types t, char *buf, size_t size)
{
    size_t at = 0;
    int left = __builtin_popcount(t);

    if (t == IX_T_ANY)
        return "a value";
    buf[0] = '\0';
    for (size_t i = 0; i < NWORDS; i++) {
        const char *sep;
        int n;

        if (!words[i].text || !(t & words[i].set))
            continue;
        sep = at == 0 ? "" : left == 1 ? " or " : ", ";
        n = snprintf(buf + at, size - at, "%s%s", sep, words[i].text);
        if (n < 0 || (size_t)n >= size - at)
            break;
        at += (size_t)n;
        left--;
    }
    return buf;
}
