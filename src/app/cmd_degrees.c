/* cmd_degrees.c - iritx degrees FILE: for each curve and surface of a file, and
 * each operator that takes it, what the degree forms come to. Operators on two
 * curves get each two that follow one another. */
#include <math.h>
#include <string.h>

#include "app/cmd.h"
#include "ops/degrees.h"

enum { MAX_NAMES = 64, MAX_CURVES = 4096 };

typedef enum { TEXT, CSV, XML } format;

typedef struct {
    format format;
    const char *file;
    int nnames;
    const char *name[MAX_NAMES]; /* of operators; none: all */
    int *rows;                   /* counts those that were put */
} request;

/* The curves and surfaces of the file, by name. */
typedef struct {
    int n;
    const ix_mv *mv[MAX_CURVES];
    const char *name[MAX_CURVES];
} inputs;

/* --- arguments ----------------------------------------------------------- */

static bool read_format(const char *s, format *out)
{
    static const char *const names[] = {"text", "csv", "xml"};

    for (int i = 0; i < 3; i++)
        if (strcmp(s, names[i]) == 0) {
            *out = (format)i;
            return true;
        }
    (void)fprintf(stderr, "iritx: no format is called %s\n", s);
    return false;
}

/* The operators, each name once. */
static void list_operators(void)
{
    (void)fputs("iritx: operators are", stderr);
    for (const ix_op *op = ix__ops; op->name; op++)
        if (ix__op_find(op->name) == op)
            (void)fprintf(stderr, " %s", op->name);
    (void)fputc('\n', stderr);
}

/* Names after --op go on as long as they are operators. */
static bool read_names(int argc, char **argv, int *i, request *r)
{
    int first = r->nnames;

    while (*i + 1 < argc && r->nnames < MAX_NAMES && ix__op_find(argv[*i + 1]))
        r->name[r->nnames++] = argv[++*i];
    if (r->nnames > first)
        return true;
    if (*i + 1 < argc)
        (void)fprintf(stderr, "iritx: no operator is called %s\n",
                      argv[*i + 1]);
    list_operators();
    return false;
}

static bool read_request(int argc, char **argv, request *r)
{
    for (int i = 0; i < argc; i++) {
        if (strcmp(argv[i], "--op") == 0) {
            if (!read_names(argc, argv, &i, r))
                return false;
        } else if (strcmp(argv[i], "--format") == 0 && i + 1 < argc) {
            if (!read_format(argv[++i], &r->format))
                return false;
        } else if (argv[i][0] != '-' && !r->file) {
            r->file = argv[i];
        } else {
            return false;
        }
    }
    return r->file != NULL;
}

static bool wanted(const request *r, const ix_op *op)
{
    for (int i = 0; i < r->nnames; i++)
        if (op == ix__op_find(r->name[i]) ||
            strcmp(op->name, ix__op_find(r->name[i])->name) == 0)
            return true;
    return r->nnames == 0;
}

/* --- output -------------------------------------------------------------- */

static void put_xml(const char *s)
{
    for (; *s; s++)
        switch (*s) {
        case '&':
            (void)fputs("&amp;", stdout);
            break;
        case '<':
            (void)fputs("&lt;", stdout);
            break;
        case '"':
            (void)fputs("&quot;", stdout);
            break;
        default:
            (void)putchar(*s);
        }
}

static void put_csv(const char *s)
{
    (void)putchar('"');
    for (; *s; s++) {
        if (*s == '"')
            (void)putchar('"');
        (void)putchar(*s);
    }
    (void)putchar('"');
}

/* "8x8". */
static const char *sizes(int n, const int *v, char *buf, size_t size)
{
    size_t at = 0;

    buf[0] = '\0';
    for (int i = 0; i < n && at < size; i++) {
        int k = snprintf(buf + at, size - at, i ? "x%d" : "%d", v[i]);

        at += k > 0 ? (size_t)k : 0;
    }
    return buf;
}

static const char *number(double x, char *buf, size_t size)
{
    if (isnan(x))
        return "-";
    (void)snprintf(buf, size, "%.1e", x);
    return buf;
}

/* One form of an operator; message: why there is none in any form, or NULL. */
static void put_row(const request *r, const char *object, const ix_op *op,
                    int form, const ix_degree_row *row, const char *message)
{
    const char *name = message ? "all" : ix__form_name(form);
    char degree[64], points[64], residual[32];

    ++*r->rows;
    (void)sizes(row->ndirs, row->degree, degree, sizeof degree);
    (void)sizes(row->ndirs, row->length, points, sizeof points);
    if (r->format == TEXT && message) {
        (void)printf("  %-16s %-9s %s\n", op->name, name, message);
    } else if (r->format == TEXT) {
        (void)printf("  %-16s %-9s %8s %10s %9s %10.1f us\n", op->name, name,
                     degree, points,
                     number(row->residual, residual, sizeof residual),
                     1e6 * row->seconds);
    } else if (r->format == CSV) {
        put_csv(object);
        (void)printf(",%s,%s,%s,%s,%s,%.3e,", op->name, name, degree, points,
                     number(row->residual, residual, sizeof residual),
                     row->seconds);
        put_csv(message ? message : "");
        (void)putchar('\n');
    } else {
        (void)printf("    <form operator=\"%s\" name=\"%s\"", op->name, name);
        if (message) {
            (void)fputs(" message=\"", stdout);
            put_xml(message);
            (void)fputs("\"/>\n", stdout);
            return;
        }
        (void)printf(" degree=\"%s\" points=\"%s\" residual=\"%s\" "
                     "seconds=\"%.3e\"/>\n",
                     degree, points,
                     number(row->residual, residual, sizeof residual),
                     row->seconds);
    }
}

static void put_input(const request *r, const char *name, const ix_mv *m)
{
    int degree[IX_MAX_DIRS], length[IX_MAX_DIRS], n = ix_mv_ndirs(m);
    char d[64], l[64];

    for (int i = 0; i < n; i++) {
        degree[i] = ix_mv_order(m, i) - 1;
        length[i] = ix_mv_length(m, i);
    }
    (void)sizes(n, degree, d, sizeof d);
    (void)sizes(n, length, l, sizeof l);
    if (r->format == TEXT) {
        (void)printf("%s: %s %s %c%d of degree %s, %s points\n", name,
                     ix_mv_dir(m, 0).basis == IX_BSPLINE ? "B-spline"
                                                         : "Bezier",
                     n == 1 ? "curve" : "surface",
                     ix_mv_rational(m) ? 'P' : 'E', ix_mv_ncoords(m), d, l);
    } else if (r->format == XML) {
        (void)fputs("  <object name=\"", stdout);
        put_xml(name);
        (void)printf("\" type=\"%c%d\" degree=\"%s\" points=\"%s\">\n",
                     ix_mv_rational(m) ? 'P' : 'E', ix_mv_ncoords(m), d, l);
    }
}

/* --- the tables ---------------------------------------------------------- */

/* A failure of one operator is a row, only memory and interrupts end it. */
static ix_status put_op(ix_ctx *ctx, const request *r, const char *object,
                        const ix_op *op, const ix_op_args *a)
{
    static const int order[IX__NFORMS] = {IX_FORM_IRIT, IX_FORM_NAIVE,
                                          IX_FORM_PUBLISHED, IX_FORM_MINIMAL,
                                          IX__FORM_REDUCED};

    for (int i = 0; i < IX__NFORMS; i++) {
        ix_degree_row row;
        ix_status st;

        if (!ix__op_has_form(op, order[i]))
            continue;
        st = ix__degree_row(ctx, op, a, order[i], &row);
        if (st == IX_ENOMEM || st == IX_ECANCEL)
            return st;
        put_row(r, object, op, order[i], &row,
                st == IX_OK ? NULL : ix_ctx_message(ctx));
        if (st == IX_EDOMAIN || st == IX_EARG)
            return IX_OK; /* the same for all forms */
    }
    return IX_OK;
}

static ix_status put_object(ix_ctx *ctx, const request *r, const inputs *in,
                            int i)
{
    put_input(r, in->name[i], in->mv[i]);
    for (const ix_op *op = ix__ops; op->name; op++) {
        ix_op_args a = {.mv = {in->mv[i], NULL}};

        if (!wanted(r, op) || op->ndirs[0] != ix_mv_ndirs(in->mv[i]))
            continue;
        if (op->ndirs[1]) { /* with the next object */
            if (i + 1 >= in->n || ix_mv_ndirs(in->mv[i + 1]) != op->ndirs[1])
                continue;
            a.mv[1] = in->mv[i + 1];
        }
        ix__op_defaults(op, a.num);
        IX_TRY(put_op(ctx, r, in->name[i], op, &a));
    }
    if (r->format == XML)
        (void)puts("  </object>");
    return IX_OK;
}

/* Curves and surfaces in lists of lists; readers bound the depth. */
static void gather(const ix_obj *o, const char *name, inputs *in)
{
    if (o->name && o->name[0])
        name = o->name;
    if (o->type == IX_OBJ_LIST)
        for (int i = 0; i < o->u.list.n; i++)
            gather(o->u.list.item[i], name, in);
    if (o->type != IX_OBJ_CURVE && o->type != IX_OBJ_SURFACE)
        return;
    if (in->n < MAX_CURVES) {
        in->mv[in->n] = ix__obj_first_mv(o);
        in->name[in->n++] = name;
    }
}

static ix_status put_all(ix_ctx *ctx, const request *r, const inputs *in)
{
    if (r->format == CSV)
        (void)puts("object,operator,form,degree,points,residual,seconds,"
                   "message");
    if (r->format == XML)
        (void)puts("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<degrees>");
    for (int i = 0; i < in->n; i++)
        IX_TRY(put_object(ctx, r, in, i));
    if (r->format == XML)
        (void)puts("</degrees>");
    return IX_OK;
}

/* A table without rows is none. */
static ix_status check_rows(ix_ctx *ctx, const request *r, const inputs *in)
{
    if (*r->rows > 0)
        return IX_OK;
    if (in->n == 0)
        return IX_FAIL(ctx, IX_EARG, "%s: no curve or surface", r->file);
    return IX_FAIL(
        ctx, IX_EARG, "%s: no operator given with --op takes %s that it holds",
        r->file, in->n > 1 ? "any of the freeforms" : "the freeform");
}

int cmd_degrees(ix_ctx *ctx, int argc, char **argv)
{
    static inputs in;
    int rows = 0;
    request r = {.format = TEXT, .rows = &rows};
    ix_obj *o;
    ix_status st;

    if (!read_request(argc, argv, &r))
        return cmd_wrong_usage("degrees");
    in.n = 0;
    st = ix__load(ctx, r.file, NULL, &o);
    if (st == IX_OK) {
        gather(o, "-", &in);
        st = put_all(ctx, &r, &in);
        if (st == IX_OK)
            st = check_rows(ctx, &r, &in);
    }
    ix__obj_unref(ctx, o);
    return st == IX_OK ? 0 : cmd_complain(ctx);
}
