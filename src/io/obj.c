/* obj.c - Wavefront OBJ: triangles and polygons as f, polylines as l, points as
 * p. Numbers are the shortest that read back to the same bits. */
#include <ctype.h>

#include "io/export.h"
#include "io/shapes.h"

typedef struct {
    ix_buf *b;
    size_t nverts; /* so far: the file counts from 1 through all shapes */
    const ix_obj *object; /* that the shapes come from now */
    size_t nobjects;
} objfile;

static void put_numbers(ix_buf *b, const char *word, const double *v, int n)
{
    ix__buf_puts(b, word);
    for (int c = 0; c < n; c++) {
        ix__buf_putc(b, ' ');
        ix__buf_num(b, v[c]);
    }
}

static void put_index(objfile *f, size_t i)
{
    ix__buf_putc(f->b, ' ');
    ix__buf_int(f->b, (long long)f->nverts + (long long)i + 1);
}

/* Blanks would end the name. */
static void put_name(ix_buf *b, const char *s)
{
    for (; *s; s++)
        ix__buf_putc(b, isgraph((unsigned char)*s) ? *s : '_');
}

/* "o" and the colour as a comment, before an object's first shape. */
static void begin(objfile *f, const ix_obj *o)
{
    double rgb[3];

    if (o == f->object)
        return;
    f->object = o;
    f->nobjects++;
    ix__buf_puts(f->b, "o ");
    if (o->name)
        put_name(f->b, o->name);
    else
        ix__buf_printf(f->b, "object%zu", f->nobjects);
    ix__buf_putc(f->b, '\n');
    if (!ix__shape_color(o, rgb))
        return;
    put_numbers(f->b, "# color", rgb, 3);
    ix__buf_putc(f->b, '\n');
}

static void put_vertex(objfile *f, const double p[3])
{
    put_numbers(f->b, "v", p, 3);
    ix__buf_putc(f->b, '\n');
}

static ix_status put_mesh(void *arg, const ix_obj *o, const ix__mesh *m)
{
    objfile *f = arg;

    begin(f, o);
    for (size_t i = 0; i < m->nverts; i++)
        put_vertex(f, m->xyz + 3 * i);
    for (size_t i = 0; i < m->ntris; i++) {
        ix__buf_putc(f->b, 'f');
        for (int k = 0; k < 3; k++)
            put_index(f, m->tri[i][k]);
        ix__buf_putc(f->b, '\n');
    }
    f->nverts += m->nverts;
    return ix__buf_check(f->b);
}

/* One element with the next n vertices. */
static void put_element(objfile *f, const char *word, size_t n)
{
    ix__buf_puts(f->b, word);
    for (size_t i = 0; i < n; i++)
        put_index(f, i);
    ix__buf_putc(f->b, '\n');
    f->nverts += n;
}

static ix_status put_lines(void *arg, const ix_obj *o, const ix__lines *l)
{
    objfile *f = arg;

    begin(f, o);
    for (size_t i = 0; i < l->nlines; i++) {
        for (size_t k = l->start[i]; k < l->start[i + 1]; k++)
            put_vertex(f, l->xyz + 3 * k);
        put_element(f, "l", l->start[i + 1] - l->start[i]);
    }
    return ix__buf_check(f->b);
}

/* Each vertex after the second makes a triangle with the two before it. */
static void put_strip(objfile *f, size_t n)
{
    for (size_t i = 0; i + 2 < n; i++) {
        ix__buf_putc(f->b, 'f');
        put_index(f, i + i % 2);
        put_index(f, i + 1 - i % 2);
        put_index(f, i + 2);
        ix__buf_putc(f->b, '\n');
    }
    f->nverts += n;
}

static void put_polygon(objfile *f, const ix_polygon *pg)
{
    size_t n = (size_t)pg->n;
    bool face = pg->kind == IX_POLYGON && n > 2;

    if (n == 0)
        return;
    for (size_t k = 0; k < n; k++)
        put_vertex(f, pg->v[k].p);
    if (pg->kind == IX_POLYSTRIP)
        put_strip(f, n);
    else if (pg->kind == IX_POINTLIST || n == 1)
        put_element(f, "p", n);
    else
        put_element(f, face ? "f" : "l", n);
}

static ix_status put_poly(void *arg, const ix_obj *o, const ix_poly *p)
{
    objfile *f = arg;

    begin(f, o);
    for (int i = 0; i < p->n; i++)
        put_polygon(f, &p->poly[i]);
    return ix__buf_check(f->b);
}

static ix_status put_point(void *arg, const ix_obj *o, const double p[3])
{
    objfile *f = arg;

    begin(f, o);
    put_vertex(f, p);
    put_element(f, "p", 1);
    return ix__buf_check(f->b);
}

ix_status ix__obj_file_write(ix_buf *b, const ix_obj *o, const ix_write_opts *w)
{
    objfile f = {.b = b};
    const ix__shape_sink sink = {
        .format = "an OBJ file",
        .holds = "curves, surfaces, models, polygons, points",
        .mesh = put_mesh,
        .lines = put_lines,
        .poly = put_poly,
        .point = put_point,
        .arg = &f};

    ix__buf_puts(b, "# iritx\n");
    IX_TRY(ix__shapes(b->ctx, o, w ? w->tol : 0, &sink));
    return ix__buf_check(b);
}
