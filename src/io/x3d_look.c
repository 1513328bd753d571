/* x3d_look.c - colours, names and shapes of X3D. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "io/write_text.h"
#include "io/x3d_impl.h"

ix_status ix__x3d_check(const ix__x3d *w)
{
    return ix__write_check(w->b, w->start, w->nonfinite);
}

void ix__x3d_indent(ix__x3d *w)
{
    ix__buf_fill(w->b, ' ', (size_t)w->depth);
}

void ix__x3d_line(ix__x3d *w, const char *fmt, ...)
{
    char text[256];
    va_list ap;

    ix__x3d_indent(w);
    va_start(ap, fmt);
    (void)vsnprintf(text, sizeof text, fmt, ap);
    va_end(ap);
    ix__buf_puts(w->b, text);
    ix__buf_putc(w->b, '\n');
}

void ix__x3d_num(ix__x3d *w, double v)
{
    if (!isfinite(v))
        w->nonfinite = true;
    ix__buf_num(w->b, v);
}

void ix__x3d_rows(ix__x3d *w, const char *name, size_t n, int group,
                  const double *v, size_t stride)
{
    ix__buf_printf(w->b, " %s=\"", name);
    for (size_t i = 0; i < n; i++) {
        if (i > 0)
            ix__buf_puts(w->b, group > 1 ? ", " : " ");
        for (int a = 0; a < group; a++) {
            if (a > 0)
                ix__buf_putc(w->b, ' ');
            ix__x3d_num(w, v[i + (size_t)a * stride]);
        }
    }
    ix__buf_putc(w->b, '"');
}

/* --- colours ---------------------------------------------------------- */

/* spec/itd-format 3.5 */
static const unsigned char palette[16][3] = {
    {0, 0, 0},     {0, 0, 255},    {0, 255, 0},    {0, 255, 255},
    {255, 0, 0},   {255, 0, 255},  {128, 128, 0},  {128, 128, 128},
    {64, 64, 64},  {64, 64, 255},  {64, 255, 64},  {64, 255, 255},
    {255, 64, 64}, {255, 64, 255}, {255, 255, 64}, {255, 255, 255}};

/* "r,g,b" of 0 .. 255. */
static bool parse_rgb(const char *s, double rgb[3])
{
    const char *end = s + strlen(s);
    double v[3];

    for (int k = 0; k < 3; k++) {
        while (s < end && (*s == ' ' || *s == ','))
            s++;
        s = ix_num_parse(s, end, v + k);
        if (!s || !(v[k] >= 0 && v[k] <= 255))
            return false;
    }
    for (int k = 0; k < 3; k++)
        rgb[k] = v[k] / 255;
    return true;
}

static const ix_attr *find(const ix_attr *attrs, const char *name)
{
    for (const ix_attr *a = attrs; a; a = a->next)
        if (ix__name_cmp(a->name, name) == 0)
            return a;
    return NULL;
}

ix__x3d_look ix__x3d_look_of(const ix_attr *attrs, ix__x3d_look look)
{
    const ix_attr *rgb = find(attrs, "rgb"), *color = find(attrs, "color"),
                  *transp = find(attrs, "transp");

    if (color && color->type == IX_ATTR_INT && color->i >= 0 && color->i < 16)
        for (int k = 0; k < 3; k++)
            look.rgb[k] = palette[color->i][k] / 255.0;
    if (rgb && rgb->type == IX_ATTR_STRING)
        (void)parse_rgb(rgb->s, look.rgb); /* wins, as in IRIT */
    if (transp && transp->type == IX_ATTR_REAL)
        look.transparency = fmin(1, fmax(0, transp->r));
    if (transp && transp->type == IX_ATTR_INT)
        look.transparency = transp->i > 0 ? 1 : 0;
    return look;
}

/* --- names ------------------------------------------------------------ */

static uint64_t hash(const char *s)
{
    uint64_t h = 14695981039346656037u; /* FNV-1a */

    for (; *s; s++)
        h = (h ^ (unsigned char)*s) * 1099511628211u;
    return h | 1; /* 0 is a free place */
}

static bool insert(uint64_t *table, size_t cap, uint64_t h)
{
    size_t i = (size_t)(h >> 1) & (cap - 1);

    while (table[i] != 0 && table[i] != h)
        i = (i + 1) & (cap - 1);
    if (table[i] == h)
        return false;
    table[i] = h;
    return true;
}

static ix_status make_room(ix__x3d *w)
{
    size_t cap = w->cap ? 2 * w->cap : 64;
    uint64_t *fresh;

    if (2 * w->nseen < w->cap)
        return IX_OK;
    fresh = ix__alloc(w->b->ctx, cap * sizeof *fresh);
    if (!fresh)
        return IX_ENOMEM;
    memset(fresh, 0, cap * sizeof *fresh);
    for (size_t i = 0; i < w->cap; i++)
        if (w->seen[i])
            (void)insert(fresh, cap, w->seen[i]);
    ix__free(w->b->ctx, w->seen, w->cap * sizeof *fresh);
    w->seen = fresh;
    w->cap = cap;
    return IX_OK;
}

enum { LONGEST = 80 };

/* Letters, digits and "_-." only, a letter or "_" first. */
static void plain_name(const char *name, char out[LONGEST + 2])
{
    size_t n = 0;

    if (!((*name >= 'A' && *name <= 'Z') || (*name >= 'a' && *name <= 'z')))
        out[n++] = '_';
    for (; *name && n < LONGEST; name++) {
        bool fine = (*name >= 'A' && *name <= 'Z') ||
                    (*name >= 'a' && *name <= 'z') ||
                    (*name >= '0' && *name <= '9') || *name == '-' ||
                    *name == '.';

        out[n++] = *name;
        if (!fine)
            out[n - 1] = '_';
    }
    out[n] = '\0';
}

ix_status ix__x3d_def(ix__x3d *w, const char *name)
{
    char base[LONGEST + 2], full[LONGEST + 32];

    if (!name)
        return IX_OK;
    IX_TRY(make_room(w));
    plain_name(name, base);
    (void)snprintf(full, sizeof full, "%s", base);
    for (size_t k = w->nseen; !insert(w->seen, w->cap, hash(full)); k++)
        (void)snprintf(full, sizeof full, "%s_%zu", base, k);
    w->nseen++;
    ix__buf_printf(w->b, " DEF=\"%s\"", full);
    return IX_OK;
}

/* --- shapes ----------------------------------------------------------- */

ix_status ix__x3d_shape(ix__x3d *w, const char *name, const ix__x3d_look *look,
                        bool shines)
{
    IX_TRY(ix__x3d_check(w));
    ix__x3d_indent(w);
    ix__buf_puts(w->b, "<Shape");
    IX_TRY(ix__x3d_def(w, name));
    ix__buf_puts(w->b, "><Appearance><Material");
    if (shines)
        ix__buf_puts(w->b, " diffuseColor=\"0 0 0\"");
    ix__x3d_rows(w, shines ? "emissiveColor" : "diffuseColor", 1, 3, look->rgb,
                 1);
    if (look->transparency > 0)
        ix__x3d_rows(w, "transparency", 1, 1, &look->transparency, 1);
    ix__buf_puts(w->b, "/></Appearance>\n");
    w->depth++;
    return IX_OK;
}

void ix__x3d_end_shape(ix__x3d *w)
{
    w->depth--;
    ix__x3d_line(w, "</Shape>");
}
