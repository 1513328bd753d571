/* tables.c - all built-ins by name, the predefined constants.
 *
 * The index of the built-ins is made once per process. Plug-ins append to it;
 * what is there never changes or moves, so it is read without a lock. */
#define _POSIX_C_SOURCE 200809L
#include <assert.h>
#include <ctype.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "irit_ext/ops/ops.h"
#include "lang/host.h"
#include "lang/interp_impl.h"
#include "lang/startup.h"

/* Statements that the parser knows itself, here for help and lists only. */
static const ix_builtin control[] = {
    {"IF", "cond:num then:any [else:any] -> nothing",
     "Runs the second argument if cond is not 0, else the third.",
     "x = 3; if (x > 0, y = 1, y = 2);", NULL, 0, 1},
    {"FOR", "init:any inc:num end:num body:any -> nothing",
     "Runs body for each value of the counter from init to end.",
     "l = nil(); for (i = 1, 1, 3, snoc(i, l));", NULL, 0, 1},
    {"WHILE", "cond:num body:any -> nothing",
     "Runs body as long as cond is not 0.",
     "i = 0; while (i < 9, i = i + 1: j = i);", NULL, 0, 1},
    {"FUNCTION", "params:any... -> nothing",
     "Defines a function: its value is what the body assigns to RETURN.",
     "f = function(x): return = x + 1;", NULL, 0, 1},
    {"PROCEDURE", "params:any... -> nothing",
     "Defines a procedure: a function without a value.",
     "p = procedure(x): printf(\"%f\\\\n\", list(x));", NULL, 0, 1},
    {0}};

static const ix_builtin *const tables[] = {
    control,
    ix__builtins_system,
    ix__builtins_numeric,
    ix__builtins_list,
    ix__builtins_output,
    ix__builtins_attr,
    ix__builtins_analytic,
    ix__builtins_curve,
    ix__builtins_curve_edit,
    ix__builtins_curve_ask,
    ix__builtins_freeform,
    ix__builtins_surface,
    ix__builtins_trivar,
    ix__builtins_mv,
    ix__builtins_sym,
    ix__builtins_ops,
    ix__builtins_bisect2d,
    ix__builtins_bisect3d,
    ix__builtins_prim,
    ix__builtins_mbisect,
    ix__builtins_geodesic,
    ix__builtins_degrees,
    ix__builtins_poly,
    ix__builtins_tess,
    ix__builtins_distance,
    ix__builtins_meet,
    ix__builtins_solve,
    ix__builtins_offset,
    ix__builtins_enclose,
    ix__builtins_touch,
    ix__builtins_visible,
    ix__builtins_text,
    ix__builtins_envelope,
    ix__builtins_fit,
    ix__builtins_planar,
    ix__builtins_arrange,
    ix__builtins_layout,
    ix__builtins_volume,
    ix__builtins_contact,
    ix__builtins_asymptotic,
    ix__builtins_sign,
    ix__builtins_solid,
    ix__builtins_startup,
};
#define NTABLES (sizeof tables / sizeof *tables)

#define MAX_BUILTINS   1024
#define MAX_EXT        512  /* of plug-ins */
#define NSLOTS         4096 /* of the hash table: a power of two */
#define CONSTANT_SLOTS 512

static ix__bi all[MAX_BUILTINS];
static ix_builtin ext_row[MAX_EXT]; /* of plug-ins */
static size_t next_ext;
static atomic_size_t count;
/* 1 + index into all, 0: empty. Set after the entry itself. */
static _Atomic unsigned short slot[NSLOTS];
static pthread_once_t once = PTHREAD_ONCE_INIT;
static pthread_mutex_t appending = PTHREAD_MUTEX_INITIALIZER;

/* Fowler-Noll-Vo, over the upper-case name. */
static unsigned hash(const char *name)
{
    unsigned h = 2166136261u;

    for (; *name; name++)
        h = (h ^ (unsigned)toupper((unsigned char)*name)) * 16777619u;
    return h;
}

static bool same_name(const char *a, const char *b)
{
    while (*a && toupper((unsigned char)*a) == toupper((unsigned char)*b))
        a++, b++;
    return !*a && !*b;
}

/* Its slot, or the empty one where it belongs; *bi NULL then. */
static size_t find_slot(const char *name, const ix__bi **bi)
{
    for (size_t i = hash(name) % NSLOTS;; i = (i + 1) % NSLOTS) {
        unsigned at = atomic_load_explicit(&slot[i], memory_order_acquire);

        *bi = at ? &all[at - 1] : NULL;
        if (!at || same_name(all[at - 1].row->name, name))
            return i;
    }
}

static void add_row(const ix_builtin *row, ix_plugin_fn ext)
{
    const ix__bi *there;
    size_t i = find_slot(row->name, &there);
    size_t n = atomic_load_explicit(&count, memory_order_relaxed);

    if (there || n == MAX_BUILTINS)
        return; /* the first one counts */
    all[n] = (ix__bi){.row = row, .ext = ext};
    if (!ix__sig_parse(row->signature, &all[n].sig))
        assert(!"malformed signature in a table of built-ins");
    atomic_store_explicit(&count, n + 1, memory_order_release);
    atomic_store_explicit(&slot[i], (unsigned short)(n + 1),
                          memory_order_release);
}

/* The operators come as those of a plug-in do. */
static void make_index(void)
{
    static ix_status (*const operators[])(const ix_host *h, ix_registry *r) = {
        ix__ops_curves, ix__ops_surfaces};
    ix_registry r = {.ctx = NULL};

    for (size_t i = 0; i < NTABLES; i++)
        for (const ix_builtin *t = tables[i]; t->name; t++)
            add_row(t, NULL);
    for (size_t i = 0; i < sizeof operators / sizeof *operators; i++)
        if (operators[i](&ix__host, &r) != IX_OK)
            assert(!"malformed row in irit_ext/ops");
}

const ix__bi *ix__bi_find_so_far(const char *name)
{
    const ix__bi *bi;

    (void)find_slot(name, &bi);
    return bi;
}

const ix__bi *ix__bi_find(const char *name)
{
    (void)pthread_once(&once, make_index);
    return ix__bi_find_so_far(name);
}

const ix_builtin *ix__builtin_find(const char *name)
{
    const ix__bi *b = ix__bi_find(name);

    return b ? b->row : NULL;
}

const ix_builtin *ix__builtin_at(size_t i)
{
    (void)pthread_once(&once, make_index);
    return i < atomic_load_explicit(&count, memory_order_acquire) ? all[i].row
                                                                  : NULL;
}

static void append(const ix_plugin_row *r)
{
    ix_builtin *row = &ext_row[next_ext++];

    *row = (ix_builtin){.name = r->name,
                        .signature = r->signature,
                        .summary = r->summary,
                        .example = r->example,
                        .flags = r->flags & IX_PLUGIN_SOFT,
                        .chapter = r->chapter};
    add_row(row, r->fn);
}

ix_status ix__bi_append(ix_ctx *ctx, const ix_plugin_row *rows, int n)
{
    bool room;

    (void)pthread_mutex_lock(&appending);
    room = n <= MAX_EXT - (int)next_ext && (size_t)n <= MAX_BUILTINS - count;
    for (int i = 0; room && i < n; i++)
        append(&rows[i]);
    (void)pthread_mutex_unlock(&appending);
    return room ? IX_OK
                : IX_FAIL(ctx, IX_EUNABLE,
                          "%d more functions: there is no room for so many", n);
}

/* --- constants ---------------------------------------------------------------
 */

#define TYPE(n)                \
    {                          \
#n "_TYPE", IX_OBJ_##n \
    }
static const struct {
    const char *name;
    double v;
} constants[] = {
    {"PI", 3.14159265358979323846},
    {"TRUE", 1},
    {"FALSE", 0},
    {"ON", 1},
    {"OFF", 0},
    {"COL", 1301},
    {"ROW", 1302},
    {"DEPTH", 1303},
    {"KV_OPEN", -10000},
    {"KV_FLOAT", -10001},
    {"KV_PERIODIC", -10002},
    {"KV_DISC_OPEN", -10003},
    {"PARAM_UNIFORM", 1501},
    {"PARAM_CENTRIP", 1502},
    {"PARAM_CHORD", 1503},
    {"PARAM_NIELFOL", 1504},
    {"E1", 1100},
    {"P1", 1101},
    {"E2", 1102},
    {"P2", 1103},
    {"E3", 1104},
    {"P3", 1105},
    {"E4", 1106},
    {"P4", 1107},
    {"E5", 1108},
    {"P5", 1109},
    {"E6", 1110},
    {"P6", 1111},
    {"E7", 1112},
    {"P7", 1113},
    {"E8", 1114},
    {"P8", 1115},
    {"E9", 1116},
    {"P9", 1117},
    TYPE(UNDEF),
    TYPE(POLY),
    {"NUMERIC_TYPE", IX_OBJ_NUMBER},
    TYPE(POINT),
    TYPE(VECTOR),
    TYPE(PLANE),
    TYPE(MATRIX),
    TYPE(CURVE),
    TYPE(SURFACE),
    TYPE(STRING),
    TYPE(LIST),
    TYPE(CTLPT),
    TYPE(TRIMSRF),
    TYPE(TRIVAR),
    TYPE(TRISRF),
    TYPE(MODEL),
    TYPE(MULTIVAR),
    {"BEZIER_TYPE", 5001},
    {"BSPLINE_TYPE", 5002},
    {"POWER_TYPE", 5003},
    {"GREGORY_TYPE", 5004},
    {"GEOM_CONST", 0},
    {"GEOM_LINEAR", 1},
    {"GEOM_CIRCULAR", 2},
    {"GEOM_PLANAR", 4},
    {"GEOM_SPHERICAL", 5},
    {"GEOM_SRF_OF_REV", 9},
    {"GEOM_EXTRUSION", 12},
    {"GEOM_RULED_SRF", 13},
    {"GEOM_DEVELOP_SRF", 14},
    {"GEOM_SWEEP", 15},
    {"BLACK", 0},
    {"BLUE", 1},
    {"GREEN", 2},
    {"CYAN", 3},
    {"RED", 4},
    {"MAGENTA", 5},
    {"YELLOW", 14},
    {"WHITE", 15},
    {"MSDOS", 1},
    {"SGI", 2},
    {"HP", 3},
    {"APOLLO", 4},
    {"SUN", 5},
    {"UNIX", 6},
    {"IBMOS2", 7},
    {"WINDOWS", 8},
    {"AMIGA", 9},
    {"CYGWIN", 10},
    {"MACOSX", 11},
    {"LINUX", 12},
    {"CLIENTS_ALL", 13030},
};

const char *ix__constant_at(size_t i, double *v)
{
    if (i >= sizeof constants / sizeof *constants)
        return NULL;
    *v = constants[i].v;
    return constants[i].name;
}

/* An index of its own, for every name that a script uses is looked up here. */
#define NCONSTANTS (sizeof constants / sizeof *constants)
static unsigned char constant_slot[CONSTANT_SLOTS]; /* 1 + index; 0: empty */
_Static_assert(NCONSTANTS < 255 && NCONSTANTS < CONSTANT_SLOTS / 2, "room");

static size_t find_constant_slot(const char *name)
{
    size_t i = hash(name) % CONSTANT_SLOTS;

    while (constant_slot[i] &&
           strcmp(constants[constant_slot[i] - 1].name, name) != 0)
        i = (i + 1) % CONSTANT_SLOTS;
    return i;
}

static void index_constants(void)
{
    for (size_t i = 0; i < NCONSTANTS; i++)
        constant_slot[find_constant_slot(constants[i].name)] =
            (unsigned char)(i + 1);
}

bool ix__constant_find(const char *name, double *v)
{
    static pthread_once_t indexed = PTHREAD_ONCE_INIT;
    size_t i;

    (void)pthread_once(&indexed, index_constants);
    i = find_constant_slot(name);
    if (!constant_slot[i])
        return false;
    *v = constants[constant_slot[i] - 1].v;
    return true;
}

/* --- names that are near
 * ------------------------------------------------------ */

#define MAX_NEAR 40 /* longer names are not compared */

/* Edits (insert, delete, replace, exchange of neighbours) that turn a into b,
 * any case; stops above limit. */
static int distance(const char *a, const char *b, int limit)
{
    int la = (int)strlen(a), lb = (int)strlen(b);
    int row[3][MAX_NEAR + 1];

    if (la > MAX_NEAR || lb > MAX_NEAR || abs(la - lb) > limit)
        return limit + 1;
    for (int j = 0; j <= lb; j++)
        row[0][j] = j;
    for (int i = 1; i <= la; i++) {
        int *cur = row[i % 3], *up = row[(i + 2) % 3], *up2 = row[(i + 1) % 3];

        cur[0] = i;
        for (int j = 1; j <= lb; j++) {
            int x = toupper((unsigned char)a[i - 1]);
            int y = toupper((unsigned char)b[j - 1]);
            int d = up[j - 1] + (x != y);

            d = d < up[j] + 1 ? d : up[j] + 1;
            d = d < cur[j - 1] + 1 ? d : cur[j - 1] + 1;
            if (i > 1 && j > 1 && x == toupper((unsigned char)b[j - 2]) &&
                y == toupper((unsigned char)a[i - 2]) && up2[j - 2] + 1 < d)
                d = up2[j - 2] + 1;
            cur[j] = d;
        }
    }
    return row[la % 3][lb];
}

typedef struct {
    const char *name[3];
    int dist[3], n;
} nearest;

static void consider(nearest *best, const char *wanted, const char *name,
                     int limit)
{
    int d = distance(wanted, name, limit), i;

    if (d > limit)
        return;
    for (i = best->n; i > 0 && best->dist[i - 1] > d; i--) {
        if (i < 3) {
            best->name[i] = best->name[i - 1];
            best->dist[i] = best->dist[i - 1];
        }
    }
    if (i >= 3)
        return;
    best->name[i] = name;
    best->dist[i] = d;
    best->n += best->n < 3;
}

/* "A, B or C"; false if there is none. */
static bool list_names(const nearest *best, char *buf, size_t size)
{
    size_t at = 0;

    for (int i = 0; i < best->n && at < size; i++) {
        const char *sep = i == 0 ? "" : i == best->n - 1 ? " or " : ", ";
        int n = snprintf(buf + at, size - at, "%s%s", sep, best->name[i]);

        at += n > 0 ? (size_t)n : 0;
    }
    return best->n > 0;
}

/* How many edits a name of this length may be away. */
static int reach(const char *name)
{
    size_t len = strlen(name);

    return len < 3 ? 0 : len < 5 ? 1 : 2;
}

bool ix__names_near(ix_interp *in, const char *name, char *buf, size_t size)
{
    nearest best = {.n = 0};
    int limit = reach(name);
    const char *fn;
    const ix_builtin *row;

    for (size_t i = 0; (row = ix__builtin_at(i)); i++)
        consider(&best, name, row->name, limit);
    for (const ix__startup_fn *f = ix__startup_text; f->name; f++)
        consider(&best, name, f->name, limit);
    for (size_t i = 0; (fn = ix__fn_at(in, i)); i++)
        consider(&best, name, fn, limit);
    return list_names(&best, buf, size);
}

bool ix__vars_near(ix_interp *in, const char *name, char *buf, size_t size)
{
    nearest best = {.n = 0};
    int limit = reach(name);
    const char *constant;
    double v;

    for (size_t i = 0; i < in->nsyms; i++)
        if (in->sym[i]->box)
            consider(&best, name, in->sym[i]->name, limit);
    for (size_t i = 0; (constant = ix__constant_at(i, &v)); i++)
        consider(&best, name, constant, limit);
    return list_names(&best, buf, size);
}
