/* listing.c - functions by chapter, and help on one of them. */
#include "app/listing.h"

#include <stdio.h>
#include <string.h>

#include "lang/interp.h"
#include "lang/startup.h"

/* Chapters of the function reference. */
static const char *const chapters[] = {
    "",
    "Control flow, definitions, system",
    "Numeric",
    "Lists, strings, names, types, element access",
    "Output, files, display",
    "Attributes",
    "Points, vectors, planes, matrices, analytic geometry",
    "Curve construction",
    "Curve editing and conversion",
    "Curve interrogation",
    "Generic freeform interrogation",
    "Surface construction",
    "Surface editing",
    "Surface interrogation",
    "Trimmed surfaces",
    "Trivariates",
    "Multivariates",
    "Triangular patches",
    "Symbolic operations",
    "Differential geometry",
    "Offsets, developables, duals",
    "Bisectors, skeleton, Voronoi",
    "Zero sets, solving, distances, packing",
    "Polylines, conversion of freeforms to polygons",
    "Polygons, solids, models",
    "Start-up library",
};
#define NCHAPTERS ((int)(sizeof chapters / sizeof *chapters))

/* Rows of other chapters are listed with the start-up library. */
static int chapter_of(const ix_builtin *row)
{
    bool known = row->chapter > 0 && row->chapter < NCHAPTERS &&
                 !(row->flags & IX_B_LIBRARY);

    return known ? row->chapter : NCHAPTERS - 1;
}

/* The row of a chapter that follows name; NULL: none is left. */
static const ix_builtin *next_in_chapter(int chapter, const char *name)
{
    const ix_builtin *row, *best = NULL;

    for (size_t i = 0; (row = ix__builtin_at(i)); i++)
        if (chapter_of(row) == chapter && strcmp(row->name, name) > 0 &&
            (!best || strcmp(row->name, best->name) < 0))
            best = row;
    return best;
}

/* "(a, b)" of a definition "NAME = function(a, b): ...". */
static const char *header_of(const char *text, int *n)
{
    const char *open = strchr(text, '(');
    const char *close = open ? strchr(open, ')') : NULL;

    *n = close ? (int)(close - open) + 1 : 0;
    return close ? open : "";
}

static void list_startup(void)
{
    for (const ix__startup_fn *f = ix__startup_text; f->name; f++) {
        int n;
        const char *header = header_of(f->text, &n);

        (void)printf("%-20s %.*s\n", f->name, n, header);
    }
}

void listing_functions(void)
{
    for (int c = 1; c < NCHAPTERS; c++) {
        const ix_builtin *row = next_in_chapter(c, "");

        if (row)
            (void)printf("%s# %d. %s\n", c > 1 ? "\n" : "", c, chapters[c]);
        for (; row; row = next_in_chapter(c, row->name))
            (void)printf("%-20s %s\n", row->name, row->signature);
    }
    list_startup();
}

static bool help_startup(const char *name)
{
    const ix__startup_fn *f = ix__startup_find(name);
    const char *header;
    int n;

    if (!f)
        return false;
    header = header_of(f->text, &n);
    (void)printf("%s %.*s\n    %s\n", f->name, n, header, f->summary);
    if (f->example)
        (void)printf("    Example: %s\n", f->example);
    (void)printf("    Text: %s\n", f->text);
    return true;
}

bool listing_help(const char *name)
{
    const ix_builtin *f = ix__builtin_find(name);

    if (!f)
        return help_startup(name);
    (void)printf("%s %s\n    %s\n", f->name, f->signature, f->summary);
    if (f->flags & IX_B_SOFT)
        (void)printf("    Its errors are soft: the script goes on.\n");
    (void)printf("    Example: %s\n", f->example);
    return true;
}
